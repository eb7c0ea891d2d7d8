# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Words that the project no longer writes, read from retired_phrases.txt, looked for in comments, strings and pages."""
import re
from pathlib import Path

LIST = Path(__file__).with_name("retired_phrases.txt")
# The list and its tests, and the pages that may name the words.
EXCEPT = ("cmake/checks/", "docs/glossary.md", "bench/results/", "tests/fuzz/corpus/")


class RetiredPhrases:
    def __init__(self, text):
        lines = (line.split("#")[0].strip() for line in text.splitlines())
        self.instead = dict(map(str.strip, line.split(">")) for line in lines if line)
        words = "|".join(re.escape(word).replace(r"\ ", r"\s+") for word in self.instead)
        self.pattern = re.compile(rf"\b({words})s?\b", re.IGNORECASE)

    def find(self, line):
        """Pairs of a retired word in a line and its successor."""
        for match in self.pattern.finditer(line):
            word = " ".join(match[1].lower().split())
            yield word, self.instead[word]


def check(tree, phrases=None):
    if phrases is None:
        phrases = RetiredPhrases(LIST.read_text(encoding="utf-8"))
    for file in tree.files + tree.pages:
        if file.name.startswith(EXCEPT):
            continue
        for number, line in enumerate(file.lines, 1):
            for word, instead in phrases.find(line):
                yield f"{file.name}:{number}: the retired word '{word}'; write {instead}"
