#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Chooses the source files of each target that are compiled together (cmake/TactoothUnity.cmake).

    unity_groups.py LINES < FILES

FILES has one line 'TARGET PATH' for each file, those of a target in a row. Prints 'TARGET GROUP PATH' for each. A group
holds at most LINES lines of code. Two files of a group never disagree about a name: what one of them declares for itself
(in an anonymous namespace, static, or by a macro), the other does not mention at all, or declares as the same alias of a
type.
"""
import re
import sys

OPEN_GROUPS = 8  # groups that can still take a file

# What cmake/check_format.sh keeps: a declaration of a namespace begins at the left margin, its parts do not.
ANONYMOUS = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", flags=re.M | re.S)
TEST = re.compile(r"(TEST\w*|TYPED_TEST\w*|INSTANTIATE_\w+|BENCHMARK\w*)\(\s*(\w+)\s*,?\s*(\w*)")
ALIAS = re.compile(r"^(using (\w+) = [^;\n]*;)$", flags=re.M)
TYPE = re.compile(r"(?:template .*)?(?:struct|class|enum class|enum|union|using)\s+(\w+)\s*(?:[:;={]|final|$)")
OTHER = re.compile(r"(\w+)\s*(?:\(|=|\{|\[|;|$)")
WORD = re.compile(r"\w+")


def declared_name(line):
    test = TEST.match(line)
    if test:
        return "_".join(test.groups())
    if re.match(r"using (namespace|(::)?\w+::)|namespace|static_assert|INSTANTIATE|template <[^>]*>$", line):
        return None  # may be said twice, has its name from a test, or stands in the next line
    kind = TYPE.match(line)
    if kind:
        return kind.group(1)
    arguments = None
    while arguments != line:
        arguments, line = line, re.sub(r"<[^<>]*>", "", line)
    other = OTHER.search(line)
    return other.group(1) if other else None


def own_names(text):
    names = set(re.findall(r"^\s*#\s*define\s+(\w+)", text, flags=re.M))
    names.update(re.findall(r"^static\s[^;{=(]*?(\w+)\s*[;{=(]", text, flags=re.M))
    for block in ANONYMOUS.finditer(text):
        names.update(declared_name(line) for line in re.findall(r"^[A-Za-z_].*$", block.group(1), flags=re.M))
    names.discard(None)
    return names


def own_aliases(text):
    """Name: declaration in one line, of the aliases that the file declares for itself."""
    blocks = ANONYMOUS.findall(text)
    return {name: declaration for block in blocks for declaration, name in ALIAS.findall(block)}


class File:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            text = re.sub(r"//(?! namespace$)[^\n]*", "", file.read(), flags=re.M)
        self.lines, self.mentioned = text.count("\n"), set(WORD.findall(text))
        self.own, self.aliases = own_names(text), own_aliases(text)


class Group:
    def __init__(self, number):
        self.number, self.lines, self.own, self.mentioned, self.aliases = number, 0, set(), set(), {}

    def takes(self, file, limit):
        fits = self.lines == 0 or self.lines + file.lines <= limit
        return fits and not self.disagrees(file)

    def disagrees(self, file):
        names = (self.own & file.mentioned) | (self.mentioned & file.own)
        return any(name not in self.aliases or self.aliases[name] != file.aliases.get(name) for name in names)

    def add(self, file):
        self.lines += file.lines
        self.own |= file.own
        self.mentioned |= file.mentioned
        self.aliases |= file.aliases


def chosen_groups(entries, limit):
    target_before, groups, count = None, [], 0
    for entry in entries:
        target, path = entry.split(" ", 1)
        if target != target_before:
            target_before, groups, count = target, [], 0
        file = File(path)
        group = next((g for g in groups if g.takes(file, limit)), None)
        if group is None:
            group = Group(count)
            count += 1
            groups = (groups + [group])[-OPEN_GROUPS:]
        group.add(file)
        yield target, group.number, path


def main():
    sys.stdout.writelines(f"{target} {group} {path}\n" for target, group, path in
                          chosen_groups(sys.stdin.read().splitlines(), int(sys.argv[1])))


if __name__ == "__main__":
    main()
