# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Words that the code no longer uses, read from retired_words.txt, looked for in identifiers and in names of files.

Comments and the text of strings are no identifiers: command names, options and columns of files stay as they are.
"""
import re
from pathlib import Path

LIST = Path(__file__).with_name("retired_words.txt")
IDENTIFIER = re.compile(r"\b[A-Za-z_]\w*")
PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")


def parts(identifier):
    """kPairListSize -> (k, pair, list, size), pair_list -> (pair, list)."""
    return tuple(word.lower() for word in PART.findall(identifier))


class RetiredWords:
    def __init__(self, text):
        self.exact = {}  # identifier: what to write instead
        self.by_first = {}  # first part: list of (all parts, word, what to write instead)
        for line in text.splitlines():
            word, _, instead = line.split("#")[0].strip().partition(" ")
            if word.startswith("="):
                self.exact[word[1:]] = instead.strip()
            elif word:
                entry = (parts(word), word, instead.strip())
                self.by_first.setdefault(entry[0][0], []).append(entry)
        self.known = {}

    def find(self, identifier):
        """The retired word in an identifier and its successor, or nothing."""
        if identifier not in self.known:
            self.known[identifier] = self._find(identifier)
        return self.known[identifier]

    def _find(self, identifier):
        if identifier in self.exact:
            return identifier, self.exact[identifier]
        own = parts(identifier)
        for start, first in enumerate(own):
            for wanted, word, instead in self.by_first.get(first, ()):
                if own[start : start + len(wanted)] == wanted:
                    return word, instead
        return None


def check(tree, words=None):
    if words is None:
        words = RetiredWords(LIST.read_text(encoding="utf-8"))
    for file in tree.cpp_files:
        found = words.find(file.path.stem)
        if found:
            yield f"{file.name}: the name holds the retired word {_said(found)}"
        for number, line in enumerate(file.code.split("\n"), 1):
            if line.lstrip().startswith("#include"):
                continue
            for identifier in dict.fromkeys(IDENTIFIER.findall(line)):
                found = words.find(identifier)
                if found:
                    yield f"{file.name}:{number}: {identifier} holds the retired word {_said(found)}"


def _said(found):
    word, instead = found
    return f"{word}; write {instead}" if instead else word
