# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Rules for single lines and the head of a file."""
import re

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
THIS_FILE = "cmake/checks/house_rules.py"  # names the words that it looks for


def check(tree):
    for file in tree.files:
        yield from head_offences(file)
        for number, line in enumerate(file.lines, 1):
            for text in line_offences(file.name, line):
                yield f"{file.name}:{number}: {text}"


def head_offences(file):
    head = "\n".join(file.lines[:5])
    licence = "GPL-3.0-or-later" if file.name.startswith(GPL_FOLDERS) else "Apache-2.0"
    wanted = ("SPDX-FileCopyrightText: 2026 The Tactooth authors", f"SPDX-License-Identifier: {licence}")
    if not all(text in head for text in wanted):
        yield f"{file.name}:1: the two-line SPDX head ({licence}) is missing"
    if file.path.suffix == ".h" and "#pragma once" not in file.lines:
        yield f"{file.name}: '#pragma once' is missing"


def line_offences(name, line):
    if UNFINISHED.search(line) and name != THIS_FILE:
        yield "unfinished work"
    if not name.startswith("src/"):
        return
    if name.startswith("src/app/") and "fmt::print(" in line:
        yield "fmt::print throws where the output is closed; use say of app/cli/terminal/output.h"
    if LIBRARY_RANGE.search(line):
        yield "check numbers by numberFrom and wholeNumberFrom of app/cli/terminal/number_range.h"
    if name.startswith("src/app/cli/") and RAW_NAME.search(line):
        yield "show a path by displayName; where its bytes are meant, use native()"
    if name != TOML_GUARD and BARE_TOML.search(line):
        yield "TOML is read by parseToml of session/io/limited_toml.h alone"
    if BARE_SENTENCE.search(line):
        yield "make it a row of messages.h, which has both languages"
    if name.startswith(PURE_LAYERS) and IMPURE_INCLUDE.search(line):
        yield "this layer may know no screen, sound or device"
