#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Checks the rules for source files that no compiler checks; prints every offence and fails if there is one.

Usage: check_sources.py SOURCE_FOLDER
"""
import re
import sys
from pathlib import Path

LONGEST_FILE = 500  # lines
FOLDERS = ["src", "include", "tests", "bench", "examples", "cmake", ".ci"]
ROOT_FILES = ["CMakeLists.txt", "run", "test"]
SUFFIXES = {".h", ".cpp", ".in", ".glsl", ".vert", ".frag", ".cmake", ".py", ".sh", ".txt", ".supp", ".toml"}
GPL_FOLDERS = ("src/app/", "tests/app/", "tests/cli/", "bench/app/")
PURE_LAYERS = ("src/geometry/", "src/collision/", "src/tooth/", "src/patient/", "src/haptics/")
# Screen, sound and device headers, which the pure layers may not know.
IMPURE_INCLUDE = re.compile(r'#\s*include\s*[<"](Q[A-Z]|Qt|GL/|GLES|EGL/|epoxy/|AL/|sndfile|HD/|HL/)')
# The library's checks of numbers take "nan" and read "010" as eight: src/app/cli/terminal/number_range.h does neither.
LIBRARY_RANGE = re.compile(r"\bCLI::(Range|Bound|PositiveNumber|NonNegativeNumber|Number|TypeValidator)\b")
# What a command prints of a path goes through displayName: names may hold what a terminal obeys.
RAW_NAME = re.compile(r"(\.|->)string\(\)")
# A hostile text of 100 kB overflows the stack of the parser; one place guards it.
BARE_TOML = re.compile(r"\btoml::parse(_file)?\s*\(")
TOML_GUARD = "src/session/io/limited_toml.cpp"
# What the program says to people is a row of a catalogue (messages.h), in both languages.
BARE_SENTENCE = re.compile(r'\b(unexpected|fail|failAt|reportError|refuse)\(\s*\{?\s*"|\bverbatim\(\s*"')
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")


def sources(root):
    for folder in FOLDERS:
        yield from sorted(p for p in (root / folder).rglob("*") if p.is_file() and "corpus" not in p.parts)
    yield from (root / name for name in ROOT_FILES)


def offences(path, name):
    lines = path.read_text(encoding="utf-8").splitlines()
    if len(lines) > LONGEST_FILE:
        yield f"{name}: {len(lines)} lines, more than {LONGEST_FILE}; split it"
    head = "\n".join(lines[:5])
    licence = "GPL-3.0-or-later" if name.startswith(GPL_FOLDERS) else "Apache-2.0"
    if "SPDX-FileCopyrightText: 2026 The Tactooth authors" not in head or f"SPDX-License-Identifier: {licence}" not in head:
        yield f"{name}:1: the two-line SPDX head ({licence}) is missing"
    if path.suffix == ".h" and "#pragma once" not in lines:
        yield f"{name}: '#pragma once' is missing"
    for number, line in enumerate(lines, 1):
        if UNFINISHED.search(line) and path != Path(__file__).resolve():
            yield f"{name}:{number}: unfinished work"
        if name.startswith("src/app/") and "fmt::print(" in line:
            yield f"{name}:{number}: fmt::print throws where the output is closed; use say of app/cli/terminal/output.h"
        if name.startswith("src/") and LIBRARY_RANGE.search(line):
            yield f"{name}:{number}: check numbers by numberFrom and wholeNumberFrom of app/cli/terminal/number_range.h"
        if name.startswith("src/app/cli/") and RAW_NAME.search(line):
            yield f"{name}:{number}: show a path by displayName; where its bytes are meant, use native()"
        if name.startswith("src/") and name != TOML_GUARD and BARE_TOML.search(line):
            yield f"{name}:{number}: TOML is read by parseToml of session/io/limited_toml.h alone"
        if name.startswith("src/") and BARE_SENTENCE.search(line):
            yield f"{name}:{number}: make it a row of messages.h, which has both languages"
        if name.startswith(PURE_LAYERS) and IMPURE_INCLUDE.search(line):
            yield f"{name}:{number}: this layer may know no screen, sound or device"


def main():
    root = Path(sys.argv[1]).resolve()
    files = [p for p in sources(root) if p.suffix in SUFFIXES or p.name in ROOT_FILES]
    if not files:
        sys.exit(f"{root}: there are no sources here")
    found = [text for p in files for text in offences(p, p.relative_to(root).as_posix())]
    print(*found, f"{len(files)} files, {len(found)} offences", sep="\n")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
