#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Runs clang-tidy with the checks of .clang-tidy on the files changed since checks/first_checked_commit.txt.

Usage: check_tidy.py BUILD_FOLDER    (the folder holds compile_commands.json)
TACTOOTH_TIDY=all checks every file. Without it the newest changes come first, and the run ends after
TACTOOTH_TIDY_SECONDS (default 120) and says how many files are left: a file takes 10 s of a core. A file that has passed is
not checked again until it, a header that it includes, its compiler options or .clang-tidy change (marks in
BUILD_FOLDER/tidy), so that the next run continues.
It ends with 77 (skipped) where clang-tidy, compile_commands.json or the history is missing.
"""
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check_commits import first_checked_commit, git, skip
from checks.source_tree import SourceTree

ROOT = Path(__file__).resolve().parent.parent
INCLUDE_ROOTS = ("src", "include", "tests")  # what "collision/bvh/surface.h" and "support/shapes.h" are relative to


class Includes:
    """Which files of the repository a file includes, directly or through others."""

    def __init__(self):
        self.files = {f.name: f for f in SourceTree(ROOT).cpp_files}
        self.known = {}
        self.digests = {name: hashlib.sha256(f.text.encode()).hexdigest() for name, f in self.files.items()}

    def of(self, name):
        if name not in self.known:
            folders = (*INCLUDE_ROOTS, os.path.dirname(name))
            wanted = [f"{folder}/{text}" for _, text in self.files[name].includes for folder in folders]
            self.known[name] = [n for n in dict.fromkeys(wanted) if n in self.files]
        return self.known[name]

    def closure(self, names):
        found, waiting = set(), [n for n in names if n in self.files]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting += self.of(name)
        return found


class Unit:
    """A file of ours and the command that compiles it by itself."""

    def __init__(self, directory, command, path):
        self.directory = directory
        self.command = command
        self.path = path
        self.name = path.relative_to(ROOT).as_posix()

    def mark(self, includes, rules):
        """Changes with everything of ours that clang-tidy reads."""
        total = hashlib.sha256((rules + self.command).encode())
        for name in sorted(includes.closure([self.name])):
            total.update(f"{name} {includes.digests[name]}\n".encode())
        return total.hexdigest()

    def entry(self):
        return {"directory": self.directory, "command": self.command, "file": str(self.path)}


# Headers that another compiler has compiled: clang-tidy cannot read them.
COMPILED_HEADERS = re.compile(r" -Winvalid-pch| -include \S*cmake_pch\.hxx")


def units_of(entry, includes):
    """The files that one run of the compiler compiles, several in a unity build, each by itself."""
    command = COMPILED_HEADERS.sub("", entry.get("command") or " ".join(entry["arguments"]))
    path = Path(entry["directory"], entry["file"])
    paths = [path]
    if path.name.startswith("unity_"):
        paths = [Path(p) for p in re.findall(r'#include "([^"]+)"', path.read_text(encoding="utf-8"))]
    for p in paths:
        if p.is_relative_to(ROOT) and p.relative_to(ROOT).as_posix() in includes.files:
            yield Unit(entry["directory"], command.replace(f" -c {path}", f" -c {p}"), p)


def changed_files():
    """The files that changed since the first checked commit, the newest change first."""
    try:
        first = first_checked_commit()
        diff = git("diff", "--name-only", "--diff-filter=d", first)  # relative to the repository
        log = git("log", "--name-only", "--format=", f"{first}..HEAD")
    except FileNotFoundError:
        skip("git is not installed")
    if diff.returncode != 0 or log.returncode != 0:
        skip("the history lacks the first checked commit; TACTOOTH_TIDY=all does without")
    changed = set(diff.stdout.splitlines())
    committed = [n for n in dict.fromkeys(log.stdout.split()) if n in changed]
    return [*sorted(changed.difference(committed)), *committed]


def units_to_check(units, includes):
    """All, or those through which clang-tidy reads each changed file, in the order of the changes."""
    if os.environ.get("TACTOOTH_TIDY") == "all":
        return units
    unit_of = {u.name: u for u in units}
    for unit in units:
        for name in includes.closure([unit.name]):
            unit_of.setdefault(name, unit)
    return list({unit_of[n].name: unit_of[n] for n in changed_files() if n in unit_of}.values())


def tidy(unit, folder, stop_at):
    """What clang-tidy printed and whether it found nothing; nothing at all if the time is over."""
    if stop_at and time.monotonic() > stop_at:
        return None
    run = subprocess.run(("nice", "-n", "10", "clang-tidy", "--quiet", "-p", str(folder), str(unit.path)),
                         capture_output=True, text=True, check=False)
    errors = "\n".join(l for l in run.stderr.splitlines() if not re.match(r"\d+ warnings?( and \d+ errors?)? ", l))
    return (run.stdout + errors).strip(), run.returncode == 0


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: check_tidy.py BUILD_FOLDER")
    build = Path(sys.argv[1]).resolve()
    if not shutil.which("clang-tidy"):
        skip("clang-tidy is not installed (apt-get install clang-tidy)")
    if not (build / "compile_commands.json").is_file():
        skip(f"there is no compile_commands.json in {build}")
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    includes = Includes()
    units = list({u.name: u for e in entries for u in units_of(e, includes)}.values())
    rules = (ROOT / ".clang-tidy").read_text(encoding="utf-8")
    marks = build / "tidy"
    marks.mkdir(exist_ok=True)
    (marks / "compile_commands.json").write_text(json.dumps([u.entry() for u in units]), encoding="utf-8")
    chosen = {u.mark(includes, rules): u for u in units_to_check(units, includes)}
    waiting = {mark: u for mark, u in chosen.items() if not (marks / mark).exists()}
    is_all = os.environ.get("TACTOOTH_TIDY") == "all"
    stop_at = None if is_all else time.monotonic() + float(os.environ.get("TACTOOTH_TIDY_SECONDS", "120"))
    bad = left = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for mark, result in zip(waiting, pool.map(lambda u: tidy(u, marks, stop_at), waiting.values())):
            if result is None:
                left += 1
            elif result[1]:
                (marks / mark).touch()
            else:
                bad += 1
                print(result[0], flush=True)
    print(f"{len(chosen)} files, {len(chosen) - len(waiting)} unchanged since they passed, {bad} with offences, "
          f"{left} left for the next run")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
