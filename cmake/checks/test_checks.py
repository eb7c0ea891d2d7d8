#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Shows that each check finds its offence in a small tree and finds none in a clean one: python3 test_checks.py"""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from checks import (assert_density, commit_subjects, fixed_waits, house_rules, include_direction, retired_phrases,
                    retired_words, sizes)
from checks.source_tree import SourceTree

HEAD = "// SPDX-FileCopyrightText: 2026 The Tactooth authors\n// SPDX-License-Identifier: Apache-2.0\n"
GPL_HEAD = HEAD.replace("Apache-2.0", "GPL-3.0-or-later")
TOP = """add_subdirectory(src/low)
add_subdirectory(src/middle)
if(NOT TACTOOTH_LIBRARY_ONLY)
  add_subdirectory(src/high)
  add_subdirectory(src/app)
endif()
"""
CLEAN = {
    "CMakeLists.txt": HEAD.replace("//", "#") + TOP,
    "src/low/CMakeLists.txt": HEAD.replace("//", "#") + "tactooth_layer(NAME low FOLDERS a b SOURCES b/two.cpp)\n",
    "src/low/a/one.h": HEAD + "#pragma once\n",
    "src/low/b/two.cpp": HEAD + '#include "low/a/one.h"\nint two() { return 2; }\n',
    "src/low/all.h": HEAD + '#pragma once\n#include "low/b/two.h"\n#include "low/a/one.h"\n',
    "src/middle/CMakeLists.txt": HEAD.replace("//", "#") + "tactooth_layer(NAME middle SOURCES m.cpp)\n",
    "src/middle/m.h": HEAD + "#pragma once\n",
    "src/high/CMakeLists.txt": HEAD.replace("//", "#") + "tactooth_layer(NAME high USES low)\n",
    "src/high/h.cpp": HEAD + '#include "low/a/one.h"\n',
    "src/app/CMakeLists.txt": GPL_HEAD.replace("//", "#")
    + "tactooth_folder_order(app FOLDERS common gui)\ntactooth_folder_order(app/gui FOLDERS text window)\n",
    "src/app/common/c.cpp": GPL_HEAD,
    "src/app/gui/text/t.cpp": GPL_HEAD + '#include "app/common/c.h"\n',
    "src/app/gui/window/w.cpp": GPL_HEAD + '#include "app/gui/text/t.h"\n#include "high/h.h"\n',
}


class CheckTest(unittest.TestCase):
    def offences(self, check, changes=None):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**CLEAN, **(changes or {})}.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return list(check(SourceTree(folder)))

    def expect_one(self, check, changes, start):
        found = self.offences(check, changes)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(start), found[0])


class CleanTree(CheckTest):
    def test_a_clean_tree_passes(self):
        for check in (house_rules.check, sizes.folder_offences, sizes.file_offences, sizes.function_offences,
                      include_direction.check, assert_density.check, fixed_waits.check, retired_words.check,
                      retired_phrases.check):
            self.assertEqual(self.offences(check), [], check)


class HouseRules(CheckTest):
    def test_the_head(self):
        self.expect_one(house_rules.check, {"src/low/a/x.cpp": "int x;\n"}, "src/low/a/x.cpp:1: the two-line SPDX head")
        self.expect_one(house_rules.check, {"src/app/common/x.cpp": HEAD}, "src/app/common/x.cpp:1:")
        self.expect_one(house_rules.check, {"src/low/a/x.h": HEAD}, "src/low/a/x.h: '#pragma once'")

    def test_single_lines(self):
        for name, line in (("src/low/a/x.cpp", "// TO" + "DO"), ("src/app/common/x.cpp", 'fmt::print("x");'),
                           ("src/app/cli/x.cpp", "path.string()"), ("src/low/a/x.cpp", "auto t = toml::parse(text);"),
                           ("src/low/a/x.cpp", "CLI::Range(1, 2)"), ("src/geometry/x.cpp", "#include <QWidget>")):
            head = GPL_HEAD if name.startswith("src/app/") else HEAD
            self.expect_one(house_rules.check, {name: head + line + "\n"}, f"{name}:3:")


class Sizes(CheckTest):
    def test_folders(self):
        def files(folder, count):
            return {f"{folder}/f{i}.stl": "" for i in range(count)}

        self.assertEqual(self.offences(sizes.folder_offences, files("tests/low", 40)), [])
        self.assertEqual(self.offences(sizes.folder_offences, files("tests/fuzz/corpus/stl", 41)), [])
        self.assertEqual(self.offences(sizes.folder_offences, files("tests/image/baselines", 41)), [])
        self.expect_one(sizes.folder_offences, files("tests/low", 41), "tests/low: 41 files")
        self.expect_one(sizes.folder_offences, files("src", 41), "src: 41 files")
        self.expect_one(sizes.folder_offences, files("data/icons", 41), "data/icons: 41 files")

    def test_files(self):
        self.assertEqual(self.offences(sizes.file_offences, {"src/low/a/x.cpp": "\n" * 500}), [])
        self.expect_one(sizes.file_offences, {"src/low/a/x.cpp": "\n" * 501}, "src/low/a/x.cpp: 501 lines")

    def test_functions(self):
        body = "    call();\n"
        for start, name in (("void f() {\n", "f"), ("A::A(int a) : a_{a}, b_(1) {\n", "A::A"),
                            ("bool A::operator==(const A& o) const {\n", "A::operator"),
                            ("void f(Options o = {}, char c = '{') {\n", "f"), ("const auto f = [](int i) {\n", "f"),
                            ("TEST(Suite, Name) {\n", "Suite.Name"), ("struct alignas(32) S {\nvoid f() {\n", "f"),
                            ("namespace a {\nauto f() -> int {\n", "f"), ("template <class T(int)>\nT f() {\n", "f")):
            end = "}\n" * (start.count("\n") if "template" not in start else 1)
            self.assertEqual(self.offences(sizes.function_offences, {"src/low/x.cpp": start + 80 * body + end}), [])
            line = 2 if "\n" in start[:-1] else 1
            self.expect_one(sizes.function_offences, {"src/low/x.cpp": start + 81 * body + end},
                            f"src/low/x.cpp:{line}: {name} has 81 lines")

    def test_the_lines_of_a_table_do_not_count(self):
        rows = '        {"a", {1, 2}},\n' * 90
        table = "void f() {\n    const std::vector<Row> rows = {\n" + rows + "    };\n    g();\n}\n"
        self.assertEqual(self.offences(sizes.function_offences, {"src/low/x.cpp": table}), [])
        blocks = "void f() {\n" + "    if (a) {\n        g();\n    }\n" * 27 + "}\n"
        self.expect_one(sizes.function_offences, {"src/low/x.cpp": blocks}, "src/low/x.cpp:1: f has 81 lines")
        big = "void f() {\n    while (a) {\n        if (b) {\n" + "            g();\n" * 90 + "        }\n    }\n}\n"
        self.expect_one(sizes.function_offences, {"src/low/x.cpp": big}, "src/low/x.cpp:1: f has 94 lines")

    def test_comments_and_strings_hold_no_braces(self):
        text = 'void f() {\n    g("}", \'}\', 1\'000);  // }\n    /* } */ h(R"(})");\n' + "    g();\n" * 79 + "}\n"
        self.expect_one(sizes.function_offences, {"src/low/x.cpp": text}, "src/low/x.cpp:1: f has 81 lines")


class IncludeDirection(CheckTest):
    def test_each_offence(self):
        for name, included, reason in (
                ("src/low/a/x.cpp", "low/b/two.h", "the folder b stands after a"),
                ("src/low/a/x.cpp", "low/all.h", "it stands in src/low itself"),
                ("src/low/b/deep/x.h", "low/all.h", "it stands in src/low itself"),
                ("src/low/a/x.cpp", "high/h.h", "the layer high stands above low"),
                ("src/high/x.cpp", "middle/m.h", "high does not name middle"),
                ("src/app/common/x.cpp", "app/gui/text/t.h", "the folder gui stands after common"),
                ("src/app/gui/text/x.cpp", "app/gui/window/w.h", "the folder window stands after text")):
            self.expect_one(include_direction.check, {name: f'#pragma once\n#include "{included}"\n'},
                            f"{name}:2: includes {included}: {reason}")

    def test_folders_that_the_order_forgets_or_invents(self):
        self.expect_one(include_direction.check, {"src/low/c/x.h": ""}, "src/low/c: is not in the FOLDERS")
        layer = {"src/low/CMakeLists.txt": "tactooth_layer(NAME low FOLDERS a b gone)"}
        self.expect_one(include_direction.check, layer, "src/low/gone: is in the FOLDERS but not there")

    def test_layers_that_a_used_layer_uses_may_be_included(self):
        uses = {"src/high/CMakeLists.txt": "tactooth_layer(NAME high USES middle)",
                "src/middle/CMakeLists.txt": "tactooth_layer(NAME middle USES low)"}
        self.assertEqual(self.offences(include_direction.check, uses), [])


class AssertDensity(CheckTest):
    def test_counts_only_code(self):
        lines = ["// static_assert(true)", "#define TACTOOTH_ASSERT(x)", "static_assert(1);", "TACTOOTH_ASSERT(a);"]
        changes = {"src/tooth/x.h": "\n".join(lines + [""] * 196) + "\n"}
        wanted = {"src/collision": 0, "src/tooth": 10, "src/haptics": 0}
        self.assertEqual(self.offences(lambda t: assert_density.check(t, wanted), changes), [])
        wanted["src/tooth"] = 11
        self.expect_one(lambda t: assert_density.check(t, wanted), changes, "src/tooth: 10.0 asserts per 1,000 lines")


class FixedWaits(CheckTest):
    def test_adds_up_what_the_tests_of_the_window_wait(self):
        def waits(folder, last):
            lines = ["QTest::qWait(2'000);", "QThread::msleep(500);", "std::this_thread::sleep_for(1s);", "// qWait(9000)",
                     "std::this_thread::sleep_for(std::chrono::milliseconds(500));", "QTest::qWaitFor(isThere, 9000);",
                     f"std::this_thread::sleep_for({last});"]
            return {f"{folder}/x.cpp": GPL_HEAD + "\n".join(lines) + "\n"}

        self.assertEqual(self.offences(fixed_waits.check, waits("tests/app", "std::chrono::seconds(1)")), [])
        self.assertEqual(self.offences(fixed_waits.check, waits("tests/low", "std::chrono::seconds(2)")), [])
        self.expect_one(fixed_waits.check, waits("tests/app", "1001ms"),
                        "tests/app/: fixed waits of 5.001 s, more than 5; the longest, tests/app/x.cpp:3, is 2 s")


class RetiredWords(CheckTest):
    WORDS = retired_words.RetiredWords("# list\nPairList NeighbourList\n=Look\nlikeness  dice\n")

    def find(self, changes):
        return self.offences(lambda t: retired_words.check(t, self.WORDS), changes)

    def test_identifiers_and_names_of_files(self):
        for code in ("PairList x;", "int kPairListSize;", "pairList_.clear();", "int pair_list;", "Look x;", "kLikeness"):
            found = self.find({"src/low/a/x.cpp": code + "\n"})
            self.assertEqual(len(found), 1, code)
            self.assertIn("src/low/a/x.cpp:1:", found[0])
        self.assertIn("write NeighbourList", self.find({"src/low/a/x.cpp": "PairList x;"})[0])
        self.assertEqual(len(self.find({"src/low/a/pair_list_test.cpp": ""})), 1)

    def test_what_is_no_identifier_or_another_word(self):
        for code in ("// PairList", 'say("likeness");', "lookAt();", "pairLists();", "repairList();", "LookAt x;"):
            self.assertEqual(self.find({"src/low/a/x.cpp": code + "\n"}), [], code)


class RetiredPhrases(CheckTest):
    WORDS = retired_phrases.RetiredPhrases("# list\npair list > neighbour list\ntells > reports\n")

    def find(self, changes):
        return self.offences(lambda t: retired_phrases.check(t, self.WORDS), changes)

    def test_comments_strings_pages_and_data(self):
        for name, text in (("src/low/a/x.cpp", "// Two pair  lists."), ("tests/low/x_test.cpp", 'say("Pair list");'),
                           ("docs/user/x.md", "It tells you."), ("README.md", "a pair list"),
                           ("data/x.toml", 'text = "Tells"'), ("bench/README.md", "pair lists")):
            found = self.find({name: text + "\n"})
            self.assertEqual(len(found), 1, name)
            self.assertTrue(found[0].startswith(name + ":1: "), found[0])
        self.assertIn("write neighbour list", self.find({"docs/x.md": "pair list"})[0])

    def test_other_words_and_pages_that_may_name_them(self):
        for name, text in (("docs/x.md", "a pair of lists, repair lists, to tell"), ("docs/glossary.md", "pair list"),
                           ("bench/results/x.md", "pair list")):
            self.assertEqual(self.find({name: text + "\n"}), [], name)


class CommitSubjects(unittest.TestCase):
    def test_clear_subjects_pass(self):
        for subject in ("Put files into folders by topic", "Embed the table", "Bring back the test", "A" + "a" * 71,
                        "Merge branch 'gates'", 'Revert "Added a very long subject that nobody would have let pass"'):
            self.assertEqual(commit_subjects.offences_in(subject), [], subject)

    def test_each_offence(self):
        for subject, part in (("Added a test", "imperative"), ("Adding a test", "imperative"), ("add a test", "capital"),
                              ("Add a test.", "full stop"), ("A" + "a" * 72, "73 characters"), ("", "empty")):
            found = commit_subjects.offences_in(subject)
            self.assertEqual(len(found), 1, subject)
            self.assertIn(part, found[0])


if __name__ == "__main__":
    unittest.main()
