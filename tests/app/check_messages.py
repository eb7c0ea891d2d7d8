#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_messages.py SOURCES

Checks each row of each catalogue of messages (messages.h): its identifier, its two languages, and that something says
it. The compiler checks the places and the full stops as well. A row that ends in "// a name" is the same in both languages.
Names each fault and fails if there is one."""
import re
import sys
from pathlib import Path

TEXT = r'((?:\s*"(?:[^"\\]|\\.)*")+)'
ROW = re.compile(r"inline constexpr MessageText k(\w+)\{" + TEXT + "," + TEXT + "," + TEXT + r"\};( *// a name$)?", re.M)
JAPANESE = re.compile("[\u3001-\u9fff\uff01-\uff9f]")
# Words of a Japanese sentence in Latin letters that the English sentence need not have.
TECHNICAL = {"TOML", "mm", "Hz", "Qt", "ZIP", "WAV"}


def plain(literals):
    text = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals))
    return text.replace('\\"', '"').replace("\\\\", "\\")


def snake(name):
    return re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower()


def faults(name, is_name, key, english, japanese):
    if key != snake(name):
        yield f"the identifier is '{key}', but the constant makes it '{snake(name)}'"
    places = [sorted(re.findall(r"%[1-9]", text)) for text in (english, japanese)]
    if set(places[0]) != set(places[1]):
        yield "the languages have different places"
    if sorted(set(places[0])) != [f"%{i + 1}" for i in range(len(set(places[0])))]:
        yield "the places do not count from %1"
    if english.endswith(".") != japanese.endswith("\u3002"):
        yield "one language lacks the full stop"
    if re.search(r"\. [A-Z]", english) and not english.rstrip().endswith("."):
        yield "the last of its sentences has no full stop"
    if JAPANESE.search(english):
        yield "the English has Japanese letters"
    has_words = re.search(r"[A-Za-z]{2}", re.sub(r"%[1-9]", "", english))
    if is_name and english != japanese:
        yield "a name is the same in both languages"
    if has_words and not JAPANESE.search(japanese) and not is_name:
        yield "the Japanese has no Japanese letter"
    known = set(re.findall(r"[A-Za-z]+", english)) | TECHNICAL
    for word in re.findall(r"[A-Za-z]{2,}", japanese):
        if word not in known:
            yield f"the Japanese has the word '{word}', which the English has not"


def main():
    root = Path(sys.argv[1])
    sources = {path: path.read_text(encoding="utf-8") for path in root.rglob("*") if path.suffix in (".cpp", ".h")}
    used = set(re.findall(r"\bmsg::k(\w+)", "".join(sources.values())))
    found, seen = [], set()
    for path, text in sorted(sources.items()):
        rows = ROW.findall(text)
        if len(rows) != len(re.findall(r"\bconstexpr MessageText k", text)):
            found.append(f"{path}: a row is not written as the others are")
        for name, *literals, mark in rows:
            found += [f"{path}: {name}: {fault}" for fault in faults(name, bool(mark), *map(plain, literals))]
            if name in seen:
                found.append(f"{path}: {name}: there is another row of this name")
            if name not in used:
                found.append(f"{path}: {name}: nothing says this")
            seen.add(name)
    if not seen:
        found.append(f"{root}: there are no messages here")
    print(*found, f"{len(seen)} messages, {len(found)} faults", sep="\n")
    return 1 if found else 0


sys.exit(main())
