#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_translations.py LUPDATE INCLUDE_ROOT CATALOGUE FOLDER...

Fails if a text of the sources in the folders has no translation in the catalogue, if a translation is empty, or if it
lost a place holder (%1) or a keyboard mark (&)."""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def problems(catalogue):
    for context in ElementTree.parse(catalogue).getroot().iter("context"):
        for message in context.iter("message"):
            source = message.findtext("source") or ""
            translation = message.find("translation")
            text = translation.text or ""
            if translation.get("type") or not text.strip():
                yield f"{context.findtext('name')}: no translation of {source!r}"
            elif sorted(re.findall(r"%\d", source)) != sorted(re.findall(r"%\d", text)):
                yield f"{context.findtext('name')}: place holders differ in {source!r}"
            elif ("&" in source) != ("&" in text) and "&nbsp" not in source:
                yield f"{context.findtext('name')}: keyboard marks differ in {source!r}"


def main():
    lupdate, root, catalogue, *folders = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / Path(catalogue).name
        shutil.copy(catalogue, copy)
        command = [lupdate, "-silent", "-I", root, "-locations", "none", *folders, "-ts", str(copy)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        found = list(problems(copy))
    for line in found:
        print(line)
    return 1 if found else 0


sys.exit(main())
