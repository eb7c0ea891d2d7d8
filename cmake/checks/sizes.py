# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Limits for the number of files in a folder, lines in a file and lines in a function."""
import re

MOST_FILES = 40  # directly in one folder: what one still finds a file in
LONGEST_FILE = 500  # lines; 300 are wanted
LONGEST_FUNCTION = 80  # lines between the braces: what fits on a screen
CROWDED_FOLDERS = ("src", "include", "tests", "bench", "data", "examples")
DATA_FOLDERS = ("tests/fuzz/corpus", "tests/image/baselines")

CONTAINER = re.compile(r"\b(?:namespace|class|struct|union|enum)\b|\bextern\s*\"\"\s*$")
NO_NAME = re.compile(r"<[^<>;]*>|\balignas\s*\([^)]*\)|\[\[[^\]]*\]\]")
PREPROCESSOR = re.compile(r"(?m)^[ \t]*#(?:[^\n]*\\\n)*[^\n]*")


def folder_offences(tree):
    for top in CROWDED_FOLDERS:
        for folder in sorted(p for p in [tree.root / top, *(tree.root / top).rglob("*")] if p.is_dir()):
            name = folder.relative_to(tree.root).as_posix()
            if (name + "/").startswith(tuple(f + "/" for f in DATA_FOLDERS)):
                continue
            count = sum(p.is_file() for p in folder.iterdir())
            if count > MOST_FILES:
                yield f"{name}: {count} files, more than {MOST_FILES}; sort them into folders by topic"


def file_offences(tree):
    for file in tree.files:
        if len(file.lines) > LONGEST_FILE:
            yield f"{file.name}: {len(file.lines)} lines, more than {LONGEST_FILE}; split it"


def function_offences(tree):
    for file in tree.cpp_files:
        for line, name, length in functions(file.code):
            if length > LONGEST_FUNCTION:
                yield f"{file.name}:{line}: {name} has {length} lines, more than {LONGEST_FUNCTION}; split it"


class _Block:
    def __init__(self, kind, name, line, since):
        self.kind, self.name, self.line, self.since = kind, name, line, since
        self.has_statement = False
        self.data_lines = 0  # of the tables inside


def functions(code):
    """The outermost functions of a C++ text: line, name, and lines between the braces without those of tables.

    A table is a braced list without a statement (nothing in it ends with a semicolon): data, not code.
    """
    stack, line, since, found = [], 1, 0, []
    code = PREPROCESSOR.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), code)
    for match in re.finditer(r"[{};\n]", code):
        sign = match[0]
        if sign == "\n":
            line += 1
            continue
        if sign == "{":
            stack.append(_Block(*_opened(code[since : match.start()], stack), line, since))
        elif stack:
            if sign == "}":
                block = stack.pop()
                _close(block, stack, line, found)
            else:
                stack[-1].has_statement = True
        # What comes after a braced value belongs to the same declaration.
        is_value_end = sign == "}" and block.kind == "value"
        since = block.since if is_value_end else match.end()
    return found


def _opened(before, stack):
    """What a brace opens, and its name, by the text between it and the statement or brace before it."""
    if any(block.kind in ("function", "inner") for block in stack):
        return "inner", ""
    if before.count("(") > before.count(")") or re.search(r"[\w>]$", before):  # f(A a = {}) or : member_{1}
        return "value", ""
    bare = NO_NAME.sub("", before)
    declaration = re.match(r"[^(]*(?=\()", bare)
    if declaration and "=" not in re.sub(r"operator\s*[^\w\s]+", "", declaration[0]):
        words = re.findall(r"[\w:~]+", declaration[0])
        name = words[-1] if words else "a function"
        test = re.match(r"\s*\(\s*(\w+),\s*(\w+)\s*\)", bare[declaration.end() :]) if name.isupper() else None
        return "function", f"{test[1]}.{test[2]}" if test else name
    if CONTAINER.search(bare) and "=" not in bare:
        return "container", ""
    is_lambda = "=" in bare and re.search(r"=\s*\[[^\]]*\]", bare)
    return ("function", re.findall(r"\w+", bare.split("=")[0])[-1]) if is_lambda else ("inner", "")


def _close(block, stack, line, found):
    if block.kind == "function":
        found.append((block.line, block.name, max(0, line - block.line - 1 - block.data_lines)))
    elif stack:
        is_table = block.kind == "inner" and not block.has_statement
        stack[-1].data_lines += max(0, line - block.line - 1) if is_table else block.data_lines
        stack[-1].has_statement |= block.has_statement
