#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Checks the rules for source files that no compiler checks; prints every offence and fails if there is one.

Usage: check_sources.py SOURCE_FOLDER
The rules are in the folder checks beside this file: one module a topic, and test_checks.py for the checks themselves.
"""
import sys
from pathlib import Path

from checks import assert_density, fixed_waits, house_rules, include_direction, retired_phrases, retired_words, sizes
from checks.source_tree import SourceTree

WANTED_LENGTH = 300  # lines of a file
CHECKS = (house_rules.check, sizes.folder_offences, sizes.file_offences, sizes.function_offences,
          include_direction.check, assert_density.check, fixed_waits.check, retired_words.check, retired_phrases.check)


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit("usage: check_sources.py SOURCE_FOLDER")
    tree = SourceTree(sys.argv[1])
    if not tree.files:
        sys.exit(f"{tree.root}: there are no sources here")
    found = [text for check in CHECKS for text in check(tree)]
    print(*found, sep="\n", end="\n" if found else "")
    long_files = sum(len(f.lines) > WANTED_LENGTH for f in tree.files)
    print(f"{long_files} files are longer than the wanted {WANTED_LENGTH} lines")
    print("asserts per 1,000 lines:", ", ".join(f"{k} {v:.1f}" for k, v in assert_density.densities(tree).items()))
    print(f"{len(tree.files)} files, {len(found)} offences")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
