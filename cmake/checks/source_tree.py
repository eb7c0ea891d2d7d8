# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""The files of the repository that the checks read, each read and stripped of comments at most once."""
import re
from functools import cached_property, lru_cache
from pathlib import Path

FOLDERS = ["src", "include", "tests", "bench", "examples", "cmake", ".ci", ".github"]
PAGES = ["*.md", "docs/**/*.md", "bench/**/*.md", "tests/**/*.md", "data/**/*.toml", "data/**/*.md"]
ROOT_FILES = ["CMakeLists.txt", "run", "test", "benchmark"]
SUFFIXES = {".h", ".cpp", ".in", ".glsl", ".vert", ".frag", ".cmake", ".py", ".sh", ".txt", ".supp", ".toml", ".yml"}
CODE_FOLDERS = ("src/", "include/", "tests/", "bench/", "examples/")
# What the compiler does not read as code: comments, raw strings, strings, characters (but not 1'000).
NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^()\\\s"]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'", re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)


def _blank(match):
    """Keeps the lines, and the quotes of a string, so that "x" stays one thing between two commas."""
    lines = "\n" * match[0].count("\n")
    return ('""' if match[0][0] in "\"R" else "''" if match[0][0] == "'" else " ") + lines


class SourceFile:
    """One file: its name in the repository, its lines, and its code without comments and the text of strings."""

    def __init__(self, root, path):
        self.path = path
        self.name = path.relative_to(root).as_posix()
        self.text = path.read_text(encoding="utf-8")
        self.lines = self.text.splitlines()

    @property
    def is_cpp(self):
        return self.path.suffix in (".h", ".cpp") and self.name.startswith(CODE_FOLDERS)

    @cached_property
    def code(self):
        return NOT_CODE.sub(_blank, self.text)

    @cached_property
    def includes(self):
        """Pairs of line number and what is included in quotes."""
        return [(self.text.count("\n", 0, m.start()) + 1, m[1]) for m in INCLUDE.finditer(self.text)]


class SourceTree:
    def __init__(self, root):
        self.root = Path(root).resolve()

    @cached_property
    def files(self):
        paths = [p for folder in FOLDERS for p in sorted((self.root / folder).rglob("*"))]
        paths = [p for p in paths if (p.suffix in SUFFIXES or p.name in ROOT_FILES) and "corpus" not in p.parts]
        paths += map(self.root.joinpath, ROOT_FILES)
        return [SourceFile(self.root, p) for p in paths if p.is_file()]

    @cached_property
    def pages(self):
        """What people read: pages, and the data files, which hold sentences."""
        paths = sorted({p for pattern in PAGES for p in self.root.glob(pattern)})
        return [SourceFile(self.root, p) for p in paths]

    @cached_property
    def cpp_files(self):
        return [f for f in self.files if f.is_cpp]

    @lru_cache(maxsize=None)
    def cmake_text(self, name):
        """The text of a CMake file without its comments; empty if there is no such file."""
        path = self.root / name
        return re.sub(r"#[^\n]*", "", path.read_text(encoding="utf-8")) if path.is_file() else ""
