#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of two builds of tactooth on the same inputs and compares what they leave, wording apart.

Usage: compare_commands.py BASE_PROGRAM HEAD_PROGRAM [--data FOLDER]

Compared are the exit code, every number on standard output and standard error, and every file: its bytes, and for
tables and JSON the numbers and keys, without times and facts of the machine. Prints each difference; exit code 1 if
there is one. Use it to show that a change of structure changes no result.
"""
import argparse
import csv
import hashlib
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
# What two runs of one program may differ in.
VOLATILE = re.compile(r"micros|seconds|_us|us_|time|ms|commit|compiler|machine|program|version|real|date|written|build|rate|load|memory|cpu|cores|updates")
TEXT = {".csv", ".json", ".toml", ".txt"}


def trajectory(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow("t,x,y,z,qw,qx,qy,qz".split(","))
        out.writerows(rows)


def inputs(folder, program):
    """Fixed inputs, made by the base program and closed forms."""
    run = lambda *words: subprocess.run([program, *map(str, words)], check=True, capture_output=True)
    run("tooth", 46, "--triangles", 20000, "--caries", "occlusal", "--out", folder / "46")
    run("bur", "330", "--out", folder / "330.stl")
    run("bur", "856-016", "--out", folder / "856.stl")
    top = max(float(n) for n in re.findall(r'"max":\s*\[[^\]]*?([-\d.e+]+)\s*\]', run(
        "info", "--json", folder / "46/outer.stl").stdout.decode()) or ["7"])
    down = [(i / 1000, 0.2 * math.sin(i / 200), i / 2000 - 0.5, top + 0.5 - 2.5 * min(1, i / 800), 1, 0, 0, 0)
            for i in range(1500)]
    trajectory(folder / "down.csv", down)
    trajectory(folder / "poses.csv", down[::50])
    (folder / "profile.csv").write_text("t,speed_rpm,power,material\n0,300000,0,none\n0.3,280000,0.5,enamel\n"
                                        "0.6,250000,1,dentin\n0.9,300000,0,none\n1.2,0,0,none\n")


def commands(data):
    """Name, words; IN is the folder of inputs, OUT an empty one."""
    layers = [word for name in ("enamel", "dentin", "pulp", "caries") for word in ("--layer", f"{name}=IN/46/{name}.stl")]
    tooth = ["--tooth", "IN/46/outer.stl", "--tool", "IN/330.stl"]
    yield "info", ["info", "--json", "IN/46/outer.stl", "IN/330.stl"]
    yield "info table", ["info", "IN/46/outer.stl"]
    yield "info of a missing file", ["info", "IN/none.stl"]
    yield "contact", ["contact", *tooth, "--poses", "IN/poses.csv", "--out", "OUT/contact.csv"]
    for mode in (["--mode", "proxy"], ["--mode", "penalty"], ["--freedom", "6"], ["--friction", "0.3"]):
        yield f"feel {mode}", ["feel", *tooth, "--trajectory", "IN/down.csv", "--out", "OUT/feel.csv", *mode]
    cut = ["cut", *tooth, *layers, "--trajectory", "IN/down.csv", "--speed-rpm", "300000", "--out", "OUT/cut.stl"]
    yield "cut", [*cut, "--voxel", "0.05", "--forces", "OUT/forces.csv", "--events", "OUT/events.csv", "--removed",
                  "OUT/removed.csv", "--export-layers", "OUT/layers", "--save", "OUT/cut.tactooth"]
    yield "cut rigid", [*cut, "--feed", "rigid", "--voxel", "0.1"]
    yield "sound", ["sound", "--profile", "IN/profile.csv", "--out", "OUT/sound.wav", "--water", "--suction"]
    yield "bur list", ["bur", "--list"]
    yield "bur", ["bur", "245", "--out", "OUT/245.stl"]
    yield "instrument", ["instrument", "turbine", "--out", "OUT/turbine.stl"]
    yield "tooth", ["tooth", "36", "--triangles", "4000", "--no-cache", "--out", "OUT/36"]
    yield "simplify", ["simplify", "IN/46/outer.stl", "--keep", "30%", "--out", "OUT/small.stl"]
    yield "subdivide", ["subdivide", "IN/330.stl", "--times", "1", "--out", "OUT/fine.stl"]
    yield "case new", ["case", "new", "IN/46/outer.stl", "--out", "OUT/case"]
    yield "render", ["render", "IN/46/outer.stl", "--out", "OUT/tooth.png", "--width", "300", "--height", "200"]
    yield "demo", ["demo", "--out", "OUT/demo", "--seconds", "3"]
    yield "wrong number", [*cut, "--voxel", "nan"]
    yield "no command", ["nothing"]
    if data:
        for stl in sorted(Path(data).rglob("*.stl"))[:4]:
            yield f"info {stl.name}", ["info", "--json", str(stl)]


def jsonFacts(value, path=""):
    """The leaves of a JSON value that a second run must repeat."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if not VOLATILE.search(key):
                yield from jsonFacts(inner, f"{path}.{key}")
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from jsonFacts(inner, f"{path}[{i}]")
    elif not isinstance(value, str):
        yield f"{path}={value}"
    else:
        yield path


def facts(path):
    data = path.read_bytes()
    if path.suffix == ".json":
        return "\n".join(jsonFacts(json.loads(data)))
    if path.suffix == ".csv":
        rows = list(csv.reader(data.decode().splitlines()))
        keep = [i for i, name in enumerate(rows[0]) if not VOLATILE.fullmatch(name)] if rows else []
        return "\n".join(",".join(row[i] for i in keep if i < len(row)) for row in rows)
    if path.suffix in TEXT or path.suffix == ".tactooth":  # provenance names the program
        return str(len(data)) if path.suffix == ".tactooth" else " ".join(NUMBER.findall(data.decode(errors="replace")))
    return hashlib.sha256(data).hexdigest()


def outcome(program, words, folder, sources):
    out = folder / "out"
    out.mkdir(parents=True)
    words = [word.replace("IN/", f"{sources}/").replace("OUT/", f"{out}/") for word in words]
    done = subprocess.run([program, *words], capture_output=True, env={**os.environ, "XDG_CACHE_HOME": str(folder / "cache")})
    said = (done.stdout + b"\n" + done.stderr).decode(errors="replace").replace(str(folder), "")
    printed = said
    if "--json" in words and done.returncode == 0:
        printed = "\n".join("\n".join(jsonFacts(json.loads(line))) for line in done.stdout.decode().splitlines() if line)
    else:
        lines = [line for line in said.splitlines() if not re.search(r"\bin \d+(\.\d+)? (m?s|seconds)|\d+(\.\d+)? (ms|us|s)\b", line)]
        printed = " ".join(NUMBER.findall("\n".join(lines)))
    found = {"exit code": str(done.returncode), "printed numbers": printed}
    for path in sorted(p for p in out.rglob("*") if p.is_file()):
        found[str(path.relative_to(out))] = facts(path)
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("base")
    parser.add_argument("head")
    parser.add_argument("--data")
    options = parser.parse_args()
    differences = compared = 0
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        sources = root / "in"
        sources.mkdir()
        inputs(sources, options.base)
        for i, (title, words) in enumerate(commands(options.data)):
            base = outcome(options.base, words, root / f"base-{i}", sources)
            head = outcome(options.head, words, root / f"head-{i}", sources)
            for key in sorted(base.keys() | head.keys()):
                compared += 1
                if base.get(key) != head.get(key):
                    differences += 1
                    print(f"{title}: {key} differs\n  base: {str(base.get(key))[:300]}\n  head: {str(head.get(key))[:300]}")
    print(f"{compared} results compared, {differences} differ")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
