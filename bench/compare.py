#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Compares the speed of two builds: runs the benchmarks of both in turn and judges the medians.

Usage: compare.py --base BIN_FOLDER --head BIN_FOLDER [--runs N] [--only BENCH]...
A figure is slower if the median of head is at least 15 % above that of base and the difference is above the bound of its
kind (BOUNDS): a small time that doubles is no loss that anybody notices. Exit code: 1 if a figure is slower, 2 if a
benchmark failed. Started by ./benchmark --compare; the programs find the real teeth as always.
"""
import argparse
import csv
import json
import statistics
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

SLOWER = 1.15  # ratio head / base
BOUNDS = {"tick": 5.0, "update": 1.0, "picture": 1.0}  # in the unit below
UNITS = {"tick": "us", "update": "ms", "picture": "ms"}
BENCHES = {
    "contact": ("tactooth", "bench", "contact", "--resolution", "25", "--resolution", "100", "--json"),
    "cut": ("tactooth", "bench", "cut", "--voxel", "50", "--voxel", "25", "--diameter", "1", "--diameter", "1.8", "--json"),
    "view": ("view_bench",),
}


class Key(NamedTuple):
    case: str
    kind: str  # of BOUNDS
    quantile: str  # p50 or p99


def read_contact(text):
    figures = {}
    for case in json.loads(text)["cases"]:
        name = f"contact {case['tooth']}, {case['triangles']} triangles, {case['mm_per_s']:g} mm/s"
        for quantile in ("p50", "p99"):
            figures[Key(name, "tick", quantile)] = case[quantile + "_us"]
    return figures


def read_cut(text):
    figures = {}
    for case in json.loads(text)["cases"]:
        name = f"cut {case['bur']}, voxel {case['voxel_um']:g} um"
        for quantile in ("p50", "p99"):
            figures[Key(name, "tick", quantile)] = case[f"tick_{quantile}_us"]
            figures[Key(name, "update", quantile)] = case[f"update_{quantile}_ms"]
    return figures


def read_view(text):
    """The CSV of view_bench, whose names of cases hold commas. Of 25 pictures there is no p99."""
    rows = [row for row in csv.reader(text.splitlines()) if row and not row[0].startswith("#") and row[0] != "case"]
    return {Key("view " + ",".join(row[:-4]), "picture", "p50"): float(row[-2]) for row in rows}


READERS = {"contact": read_contact, "cut": read_cut, "view": read_view}


def medians(runs):
    """The median of each figure over runs; each run is a dictionary of figures."""
    keys = dict.fromkeys(key for run in runs for key in run)
    return {key: statistics.median(run[key] for run in runs if key in run) for key in keys}


def is_slower(key, base, head):
    return head >= SLOWER * base and head - base > BOUNDS[key.kind]


def slower_figures(base, head):
    return [key for key in base if key in head and is_slower(key, base[key], head[key])]


def table(base, head):
    """One line a case and kind: p50 and p99 of both and their ratios; what is slower is marked."""
    bad = set(slower_figures(base, head))
    titles = [f"{quantile} {side}" for quantile in ("p50", "p99") for side in ("base", "head", "ratio")]
    lines = [f"{'case':<52} {'kind':<11}" + "".join(f" {title:>10}" for title in titles)]
    for case, kind in dict.fromkeys((key.case, key.kind) for key in {**base, **head}):
        line = f"{case:<52} {kind + ', ' + UNITS[kind]:<11}"
        for quantile in ("p50", "p99"):
            key = Key(case, kind, quantile)
            for side in (base, head):
                line += f" {side[key]:>10.2f}" if key in side else f" {'-':>10}"
            line += f" {head[key] / base[key]:>10.2f}" if base.get(key) and key in head else f" {'-':>10}"
        marks = [key.quantile for key in (Key(case, kind, "p50"), Key(case, kind, "p99")) if key in bad]
        lines.append(line + (f"  SLOWER {', '.join(marks)}" if marks else ""))
    return "\n".join(lines)


def run(folder, bench):
    program, *options = BENCHES[bench]
    try:
        done = subprocess.run((str(Path(folder, program)), *options), capture_output=True, text=True, check=False)
    except OSError as error:
        print(f"{folder}/{program} cannot be started: {error.strerror}", file=sys.stderr)
        sys.exit(2)
    if done.returncode != 0:
        print(f"{folder}/{program} {' '.join(options)} failed:\n{done.stderr}", file=sys.stderr)
        sys.exit(2)
    return READERS[bench](done.stdout)


def main():
    parser = argparse.ArgumentParser(description="Compares the speed of two builds.")
    parser.add_argument("--base", required=True, help="folder with the programs to compare with")
    parser.add_argument("--head", required=True, help="folder with the programs to judge")
    parser.add_argument("--runs", type=int, default=5, help="of each benchmark and build (default: 5)")
    parser.add_argument("--only", action="append", choices=BENCHES, help="this benchmark; may be given several times")
    options = parser.parse_args()
    if options.runs < 1:
        parser.error("--runs has to be at least 1")
    folders = {"base": options.base, "head": options.head}
    runs = {side: [] for side in folders}
    for number in range(options.runs):
        figures = {side: {} for side in folders}
        for bench in options.only or BENCHES:
            # Who comes first changes, so that a machine that grows warm treats both alike.
            for side in list(folders)[:: 1 if number % 2 == 0 else -1]:
                print(f"run {number + 1} of {options.runs}: {bench}, {side}", file=sys.stderr)
                figures[side].update(run(folders[side], bench))
        for side in folders:
            runs[side].append(figures[side])
    base, head = medians(runs["base"]), medians(runs["head"])
    print(table(base, head))
    slower = slower_figures(base, head)
    print(f"{len(slower)} of {len(base.keys() & head.keys())} figures slower (15 % and beyond their bound), "
          f"medians of {options.runs} runs")
    sys.exit(1 if slower else 0)


if __name__ == "__main__":
    main()
