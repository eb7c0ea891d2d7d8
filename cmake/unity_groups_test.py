#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Groups made-up files by unity_groups.py: python3 unity_groups_test.py"""
import tempfile
import unittest
from pathlib import Path

from unity_groups import chosen_groups, own_names


def in_anonymous_namespace(text):
    return "namespace tactooth {\nnamespace {\n\n" + text + "\n\n}  // namespace\n\n}  // namespace tactooth\n"


class UnityGroups(unittest.TestCase):
    def groups(self, files, limit=100, target="layer"):
        with tempfile.TemporaryDirectory() as folder:
            entries = []
            for number, text in enumerate(files):
                path = Path(folder, f"{number}.cpp")
                path.write_text(text, encoding="utf-8")
                entries.append(f"{target if isinstance(target, str) else target[number]} {path}")
            return [group for _, group, _ in chosen_groups(entries, limit)]

    def test_finds_what_a_file_declares_for_itself(self):
        text = in_anonymous_namespace(
            "constexpr double kStep = 1;  // mm\nstruct Row {\n    int inside = 0;\n};\nusing Json = other::Json;\n"
            "std::map<int, std::pair<int, int>> tableOf(const Row& row) {\n    return {};\n}\n"
            "using namespace test;\nTEST(Suite, Case) {\n}")
        self.assertEqual(own_names("#define LIMIT 3\nstatic int count = 0;\n" + text),
                         {"LIMIT", "count", "kStep", "Row", "Json", "tableOf", "TEST_Suite_Case"})

    def test_files_without_a_common_name_stand_together(self):
        one, two = (in_anonymous_namespace(f"double {name}() {{\n}}") for name in ("first", "second"))
        self.assertEqual(self.groups([one, two]), [0, 0])

    def test_files_that_give_a_name_twice_stand_apart(self):
        one = in_anonymous_namespace("double place() {\n}")
        two = in_anonymous_namespace("int place() {\n}")
        self.assertEqual(self.groups([one, two]), [0, 1])

    def test_a_file_that_mentions_the_name_of_another_stands_apart(self):
        own, uses = in_anonymous_namespace("double place() {\n}"), "double x = tactooth::place();\n"
        self.assertEqual(self.groups([own, uses]), [0, 1])
        self.assertEqual(self.groups([uses, own]), [0, 1])

    def test_files_that_give_one_alias_stand_together(self):
        json, other = (in_anonymous_namespace(f"using Json = {name};") for name in ("one::Json", "other::Json"))
        uses = in_anonymous_namespace("Json x;")
        self.assertEqual(self.groups([json, json, json]), [0, 0, 0])
        self.assertEqual(self.groups([json, other, json, other]), [0, 1, 0, 1])
        self.assertEqual(self.groups([json, uses]), [0, 1])
        self.assertEqual(self.groups([uses, json]), [0, 1])
        self.assertEqual(self.groups([in_anonymous_namespace("struct Json {\n};"), json]), [0, 1])
        self.assertEqual(self.groups([json, in_anonymous_namespace("struct Json {\n};")]), [0, 1])

    def test_names_of_other_namespaces_may_be_taken_in_twice(self):
        for name in ("testing::HasSubstr", "::testing::HasSubstr"):
            text = in_anonymous_namespace(f"using {name};")
            self.assertEqual(own_names(text), set())
            self.assertEqual(self.groups([text, text]), [0, 0])

    def test_a_comment_mentions_nothing(self):
        own, comment = in_anonymous_namespace("double place() {\n}"), "int x;  // not a place\n"
        self.assertEqual(self.groups([own, comment]), [0, 0])

    def test_a_group_is_no_longer_than_the_limit_and_takes_later_files(self):
        self.assertEqual(self.groups(["int a;\n" * 60, "int b;\n" * 60, "int c;\n" * 40]), [0, 1, 0])

    def test_a_longer_file_has_a_group_of_its_own(self):
        self.assertEqual(self.groups(["int a;\n" * 300, "int b;\n"]), [0, 1])

    def test_each_target_has_groups_of_its_own(self):
        self.assertEqual(self.groups(["int a;\n", "int b;\n", "int c;\n"], target=["one", "one", "two"]), [0, 0, 0])


if __name__ == "__main__":
    unittest.main()
