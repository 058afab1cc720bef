#!/usr/bin/env python3
"""cycle_bench.py flags what is slower beyond its noise, and nothing else. All figures here are made up."""
import contextlib
import io
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import cycle_bench

KEY = ("exact", "none")


def verdict(now, then, apart=0.0):
    [(_, found, _, _)] = cycle_bench.compare({KEY: now}, {KEY: then}, lambda _: apart)
    return found


def program(folder, name, lines, head="1.0; a machine"):
    """A program that prints these rows."""
    file = pathlib.Path(folder) / name
    rows = "\n".join(["row,beside,ratio,low,high,microseconds,contacts,allocations", *lines])
    file.write_text(f"#!/bin/sh\ncat <<'END'\n# {head}\n{rows}\nEND\n")
    file.chmod(0o755)
    return str(file)


def call(*arguments):
    """@return exit code and what is printed"""
    printed, before = io.StringIO(), sys.argv
    sys.argv = ["cycle_bench.py", *arguments, "--runs", "2"]
    try:
        with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
            return cycle_bench.main(), printed.getvalue()
    finally:
        sys.argv = before


class Compare(unittest.TestCase):
    def test_slower_beyond_noise(self):
        self.assertEqual("slower", verdict((12.0, 11.0, 13.0), (10.0, 9.5, 10.5)))
        self.assertEqual("faster", verdict((10.0, 9.5, 10.5), (12.0, 11.0, 13.0)))

    def test_within_noise_is_the_same(self):
        self.assertEqual("same", verdict((12.0, 10.4, 13.0), (10.0, 9.5, 10.5)))
        self.assertEqual("same", verdict((12.0, 11.0, 13.0), (10.0, 9.5, 11.0)))
        self.assertEqual("same", verdict((9.0, 8.0, 9.5), (10.0, 9.5, 10.5)))

    def test_a_small_change_is_none_however_quiet_the_machine(self):
        self.assertEqual("same", verdict((10.9, 10.9, 10.9), (10.0, 10.0, 10.0), apart=0.10))
        self.assertEqual("slower", verdict((11.1, 11.1, 11.1), (10.0, 10.0, 10.0), apart=0.10))
        self.assertEqual("same", verdict((10.0, 10.0, 10.0), (10.9, 10.9, 10.9), apart=0.10))

    def test_missing_and_new_rows_are_told(self):
        one = (1.0, 1.0, 1.0)
        found = cycle_bench.compare({("a", ""): one, ("b", ""): one}, {("b", ""): one, ("c", ""): one},
                                    lambda _: 0.0)
        self.assertEqual(["new", "same", "missing"], [what for _, what, _, _ in found])

    def test_what_is_no_time_is_refused(self):
        for bad in (0.0, -1.0, float("nan"), float("inf")):
            with self.assertRaises(ValueError):
                verdict((bad, bad, bad), (1.0, 1.0, 1.0))


class Run(unittest.TestCase):
    def test_a_line_with_too_many_or_too_few_cells_is_refused(self):
        for line in ("a,b,c", "a"):
            with self.assertRaisesRegex(ValueError, "cells"):
                cycle_bench.read_run(f"# 1.0; a machine\nrow,beside\n{line}")


class Program(unittest.TestCase):
    PLAIN = ["none,the limit,2,2,2,1,0,0", "exact,none,10,10,10,10,40,0"]

    def test_baseline_is_recorded_and_held_against(self):
        with tempfile.TemporaryDirectory() as folder:
            baseline = os.path.join(folder, "baseline.csv")
            plain = program(folder, "plain", self.PLAIN)
            self.assertEqual(0, call(plain, "--record", baseline)[0])
            code, text = call(plain, "--baseline", baseline)
            self.assertEqual(0, code)
            self.assertIn("2 rows: nothing slower", text)
            slow = program(folder, "slow", [self.PLAIN[0], "exact,none,12,12,12,12,40,0"])
            code, text = call(slow, "--baseline", baseline)
            self.assertEqual(1, code)
            self.assertRegex(text, r"slower +exact : none .*\+20 %")
            self.assertIn("2 rows: 1 slower", text)

    def test_a_baseline_holds_no_times(self):
        with tempfile.TemporaryDirectory() as folder:
            baseline = os.path.join(folder, "baseline.csv")
            call(program(folder, "plain", ["exact,none,10,10,10,98765,40,0"]), "--record", baseline)
            self.assertNotIn("98765", pathlib.Path(baseline).read_text())

    def test_another_machine_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            baseline = os.path.join(folder, "baseline.csv")
            call(program(folder, "here", self.PLAIN), "--record", baseline)
            there = program(folder, "there", self.PLAIN, head="1.0; another machine")
            self.assertIn("another machine's", call(there, "--baseline", baseline)[1])

    def test_a_row_that_is_gone_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            baseline = os.path.join(folder, "baseline.csv")
            call(program(folder, "all", self.PLAIN), "--record", baseline)
            code, text = call(program(folder, "some", self.PLAIN[:1]), "--baseline", baseline)
            self.assertEqual(1, code)
            self.assertIn("1 missing", text)

    def test_another_build_is_compared_by_time(self):
        # The ratios are the same: both rows have become slower alike.
        with tempfile.TemporaryDirectory() as folder:
            before = program(folder, "before", self.PLAIN)
            after = program(folder, "after", ["none,the limit,2,2,2,1.5,0,0", "exact,none,10,10,10,15,40,0"])
            code, text = call(after, "--against", before)
            self.assertEqual(1, code)
            self.assertIn("2 rows: 2 slower", text)
            self.assertEqual(0, call(before, "--against", after)[0])

    def test_heap_in_a_cycle_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            code, text = call(program(folder, "heap", ["exact,none,10,10,10,10,40,3"]))
            self.assertEqual(1, code)
            self.assertIn("allocates exact", text)


if __name__ == "__main__":
    unittest.main()
