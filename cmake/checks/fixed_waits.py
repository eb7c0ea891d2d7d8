# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""How long the tests of the window wait without a condition, all of them together."""
import re

FOLDER = "tests/app/"
LONGEST = 5.0  # s
MILLISECONDS = re.compile(r"\b(?:qWait|qSleep|msleep)\s*\(\s*(\d[\d']*)\s*\)")
DURATION = re.compile(r"\bsleep_for\s*\(\s*(?:std::chrono::(seconds|milliseconds)\s*\(\s*(\d[\d']*)\s*\)|(\d[\d']*)(m?s)\b)")


def waits(code):
    """Pairs of position and seconds."""
    for match in MILLISECONDS.finditer(code):
        yield match.start(), int(match[1].replace("'", "")) / 1000
    for match in DURATION.finditer(code):
        number = int((match[2] or match[3]).replace("'", ""))
        yield match.start(), number if (match[1] or match[4]) in ("seconds", "s") else number / 1000


def check(tree):
    found = [(seconds, file.name, file.code.count("\n", 0, place) + 1)
             for file in tree.cpp_files if file.name.startswith(FOLDER) for place, seconds in waits(file.code)]
    total = sum(seconds for seconds, _, _ in found)
    if total > LONGEST:
        seconds, name, line = max(found)
        yield f"{FOLDER}: fixed waits of {total:g} s, more than {LONGEST:g}; the longest, {name}:{line}, is {seconds:g} s"
