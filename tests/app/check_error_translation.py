#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_error_translation.py SOURCES

Fails if a layer below the window can say a sentence that the window has no words for, and names each one. A sentence
is what the sources write in quotes and join by +; what stands between is a name or a number."""
import re
import sys
from pathlib import Path

# What needs no words in the window, and why: paths by their beginning.
ONLY_OUTSIDE = {
    "said by commands": "app/main.cpp app/cli/ app/common/plot_image.cpp app/gui/settings/window_options.cpp "
                        "geometry/files/file_transaction.cpp geometry/files/folder.cpp "
                        "session/cases/case_surfaces.cpp session/cases/make_case.cpp "
                        "experiments/ session/io/finite_tick.cpp session/audio/sound_profile.cpp session/simulation/tooth_source.cpp "
                        "session/io/vdb_file session/io/vdb_size.cpp sound/output/offline_render.cpp sound/files/wav_file.cpp",
    "said by tactooth devices, doctor and info": "devices/probe/child_probe.cpp devices/probe/device_probe.cpp "
                                                 "devices/device_enumeration.cpp devices/haply/haply_backend.cpp "
                                                 "devices/haply/haply_enumeration.cpp devices/mouse/mouse_backend.cpp "
                                                 "devices/openhaptics/openhaptics_backend.cpp "
                                                 "devices/sdl/joystick_probe.cpp "
                                                 "devices/spacemouse/space_mouse_backend.cpp "
                                                 "geometry/mesh/mesh_warnings.cpp haptics/real_time.cpp",
    "made of the list of devices; error_translation_test says it": "devices/open_device.cpp",
    "for tests": "geometry/mesh/triangle_mesh.cpp",
    "there is no window yet, or no more": "app/common/display_check.cpp app/gui/window/run_window.cpp view/",
    "the window has a sentence of its own": "haptics/overload_check.cpp",
    "names, and the text of files": "geometry/io/stl_writer.cpp instruments/anatomy/ assessment/practice_report.cpp assessment/metric_table.cpp "
                                       "session/model/session_tooth.cpp",
}
TABLES = ["error_messages_devices.cpp", "error_messages_files.cpp", "error_messages_texts.cpp",
          "import_note_translation.cpp", "term_translation.cpp"]  # of src/app/gui/text
FAILURES = {"unexpected", "fail", "failAt", "refuse", "reportError", "allow"}
VALUE = "\x01"  # a name or a number within a sentence
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#[^\n]*|R"\(.*?\)"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'|\w+|::|->|'
                   r"\+=|&&|\|\||==|<<|\S", re.M | re.S)
BETWEEN = {",", ";", "{", "}", "?", ":", "=", "==", "return", "<<", "&&", "||", "+=", "[", "]"}


def plain(text):
    """A text in quotes as it is said; what has lines is the text of a file."""
    return re.sub(r"\\(.)", lambda found: "\n" if found[1] == "n" else found[1], text)


def groups(text):
    """The tokens of a source as nested lists, one for each pair of parentheses."""
    text = re.sub(r'std::string\(("(?:[^"\\\n]|\\.)*")\)', r"\1", text)
    stack = [[]]
    for token in TOKEN.findall(text):
        if token.startswith(("//", "/*", 'R"')) or token.lstrip().startswith("#"):
            continue
        if token == "(":
            stack[-1].append([])
            stack.append(stack[-1][-1])
        elif token != ")":
            stack[-1].append(token)
        elif len(stack) > 1:
            stack.pop()
    return stack[0]


def sentence(expression):
    """What an expression says, with VALUE for each part that is no text in quotes."""
    terms = [[]]
    for token in expression:
        terms.append([]) if token == "+" else terms[-1].append(token)
    said = ""
    for term in terms:
        isText = bool(term) and all(isinstance(token, str) and token.startswith('"') for token in term)
        said += "".join(token[1:-1] for token in term) if isText else VALUE
    return plain(re.sub(VALUE + "+", VALUE, said))


def words(said):
    return sum(word.strip(".,:;'()").isalpha() for word in said.split())


def sentences(group, least):
    """Each thing of at least so many words that is said in a group: in a call that reports a failure two are enough."""
    expression = []
    for token in group + [";"]:
        if isinstance(token, str) and token in BETWEEN:
            said = sentence(expression)
            if words(said) >= least and "\n" not in said:
                yield said
            expression = []
        else:
            expression.append(token)
    for before, token in zip([""] + group, group):
        if isinstance(token, list) and before != "static_assert":
            yield from sentences(token, 2 if isinstance(before, str) and before in FAILURES else least)


def patterns(folder):
    """What the window has words for."""
    for texts in re.findall(r'QT_TRANSLATE_NOOP\(\s*"\w+",((?:\s*"(?:[^"\\]|\\.)*")+)\)',
                            "".join((folder / table).read_text() for table in TABLES)):
        template = plain("".join(re.findall(r'"((?:[^"\\]|\\.)*)"', texts))).removesuffix(".")
        yield re.compile("(.*?)".join(map(re.escape, re.split(r"%\d", template))) + r"\.?", re.S)


def isKnown(said, known):
    """Whether there are words for a sentence, and for each that stands within it."""
    matches = (each.fullmatch(said.strip(" :;,")) or each.fullmatch(said) for each in known)
    return any(match and all(words(part) < 2 or isKnown(part, known) for part in match.groups()) for match in matches)


def main():
    root = Path(sys.argv[1])
    known = list(patterns(root / "app/gui/text"))
    missing = []
    for path in sorted(path for path in root.rglob("*") if path.suffix in (".cpp", ".h")):
        name = path.relative_to(root).as_posix()
        if name.startswith(tuple(" ".join(ONLY_OUTSIDE.values()).split())):
            continue
        # What the window says by itself is in its catalogue, except what it reports as a failure.
        for said in sentences(groups(path.read_text()), 1000 if name.startswith("app/") else 3):
            if not isKnown(said, known):
                missing.append(f"{name}: {said.replace(VALUE, '%')}")
    for line in dict.fromkeys(missing):
        print(line)
    return 1 if missing else 0


sys.exit(main())
