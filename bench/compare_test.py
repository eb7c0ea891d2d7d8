#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tactooth authors
# SPDX-License-Identifier: Apache-2.0
"""Judges made-up results by compare.py, and runs it on programs that print such results: python3 compare_test.py"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import compare
from compare import Key

TICK = Key("contact molar", "tick", "p50")
UPDATE = Key("cut round", "update", "p99")


def contact(p50, p99):
    return json.dumps({"cases": [{"tooth": "molar", "triangles": 20000, "mm_per_s": 10.0, "p50_us": p50, "p99_us": p99}]})


def cut(tick, update):
    case = {"bur": "round 1.0 x 0.8", "voxel_um": 50.0, "tick_p50_us": tick, "tick_p99_us": 2 * tick,
            "update_p50_ms": update, "update_p99_ms": 2 * update}
    return json.dumps({"cases": [case]})


def view(median):
    return f"# llvmpipe\ncase,triangles,best_ms,median_ms,worst_ms\nball 20k quick, light follows,20448,9.0,{median},90.0\n"


class Readers(unittest.TestCase):
    def test_contact(self):
        self.assertEqual(compare.read_contact(contact(5, 44)),
                         {Key("contact molar, 20000 triangles, 10 mm/s", "tick", "p50"): 5,
                          Key("contact molar, 20000 triangles, 10 mm/s", "tick", "p99"): 44})

    def test_cut(self):
        figures = compare.read_cut(cut(40, 2))
        self.assertEqual(figures[Key("cut round 1.0 x 0.8, voxel 50 um", "tick", "p99")], 80)
        self.assertEqual(figures[Key("cut round 1.0 x 0.8, voxel 50 um", "update", "p50")], 2)

    def test_view(self):
        self.assertEqual(compare.read_view(view(12.5)), {Key("view ball 20k quick, light follows", "picture", "p50"): 12.5})


class Judgement(unittest.TestCase):
    def test_slower_takes_both_fifteen_percent_and_the_bound(self):
        for key, base, head, slower in ((TICK, 100, 115, True), (TICK, 100, 114.9, False), (TICK, 10, 15, False),
                                        (TICK, 10, 15.1, True), (TICK, 100, 50, False), (UPDATE, 4, 5, False),
                                        (UPDATE, 4, 5.1, True), (UPDATE, 20, 22, False)):
            found = compare.slower_figures({key: base}, {key: head})
            self.assertEqual(found, [key] if slower else [], (base, head))

    def test_medians_shrug_off_one_bad_run(self):
        runs = [{TICK: 10}, {TICK: 900}, {TICK: 12}]
        self.assertEqual(compare.medians(runs), {TICK: 12})

    def test_a_case_of_one_side_alone_is_shown_and_not_judged(self):
        self.assertEqual(compare.slower_figures({}, {TICK: 100}), [])
        self.assertIn("contact molar", compare.table({}, {TICK: 100}))

    def test_the_table_marks_what_is_slower(self):
        lines = compare.table({TICK: 100, UPDATE: 4}, {TICK: 130, UPDATE: 4}).splitlines()
        self.assertEqual(len(lines), 3)
        self.assertTrue(lines[1].endswith("SLOWER p50"))
        self.assertIn("1.30", lines[1])
        self.assertNotIn("SLOWER", lines[2])


class Program(unittest.TestCase):
    def programs(self, folder, factor, fails=False):
        """Stand-ins for the two programs, each `factor` times slower."""
        Path(folder).mkdir()
        outputs = {"contact": contact(50 * factor, 90 * factor), "cut": cut(40 * factor, 20 * factor)}
        bodies = {"tactooth": f"case $2 in contact) echo '{outputs['contact']}';; cut) echo '{outputs['cut']}';; esac\n",
                  "view_bench": f"cat <<END\n{view(30 * factor)}END\n"}
        for name, body in bodies.items():
            path = Path(folder, name)
            path.write_text("#!/bin/sh\n" + ("echo no >&2; exit 3\n" if fails else body), encoding="utf-8")
            path.chmod(0o755)
        return str(folder)

    def compare(self, factor, fails=False):
        with tempfile.TemporaryDirectory() as folder:
            base = self.programs(Path(folder, "base"), 1)
            head = self.programs(Path(folder, "head"), factor, fails)
            return subprocess.run((sys.executable, compare.__file__, "--base", base, "--head", head, "--runs", "2"),
                                  capture_output=True, text=True, check=False)

    def test_as_fast_passes(self):
        done = self.compare(1.1)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("0 of 7 figures slower", done.stdout)

    def test_slower_fails(self):
        done = self.compare(1.2)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("7 of 7 figures slower", done.stdout)

    def test_a_program_that_fails_is_named(self):
        done = self.compare(1, fails=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("bench contact", done.stderr)

    def test_a_program_that_is_missing_is_named(self):
        done = subprocess.run((sys.executable, compare.__file__, "--base", "/nowhere", "--head", "/nowhere"),
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("/nowhere/tactooth cannot be started", done.stderr)


if __name__ == "__main__":
    unittest.main()
