#!/usr/bin/env python3
"""claims.py finds what it is there to find."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import claims

HEAD = "| claim | stands in | standing | by |\n|---|---|---|---|\n"
TESTS = ["Exact.ConvergesToHertz", "Laws/Allocation.NoneInTheCycle/none", "documents.guide", "slurm",
         "A/Every.Name/0.5/2"]


def faults(*rows):
    document = "# Claims\n\n" + HEAD + "".join(f"| {row} |\n" for row in rows) + "\nEnd | of | the | table\n"
    return claims.faults_of(claims.claims_of(document), TESTS)


class Claims(unittest.TestCase):
    def test_what_is_sound_has_no_faults(self):
        self.assertEqual([], faults("a | README | verified | `Exact.ConvergesToHertz`, on a sphere",
                                    "b | guide | verified | `Allocation.NoneInTheCycle`, `slurm` and `documents.guide`",
                                    "c | method | observed | `palpate cost SCENE`, 2026-11-29, two cores",
                                    "d | method | open | no device yet",
                                    "e | method | verified | `Every.Name`"))

    def test_a_name_that_does_not_exist_is_told_with_its_line(self):
        self.assertEqual(["line 5: there is no test Exact.IsExact"],
                         faults("a | README | verified | `Exact.IsExact` and `slurm`"))

    def test_a_part_of_a_name_is_none(self):
        self.assertEqual(3, len(faults("a | b | verified | `Exact`", "c | b | verified | `NoneInTheCycle`",
                                       "e | b | verified | `Exact.Converges`")))

    def test_verified_needs_a_test_and_observed_a_command_and_a_day(self):
        self.assertIn("by no test", faults("a | b | verified | by looking")[0])
        for by in ("`palpate cost`", "2026-11-29", "a look"):
            self.assertIn("observed", faults(f"a | b | observed | {by}")[0])

    def test_other_words_columns_and_claims_twice_are_told(self):
        self.assertIn("is no standing", faults("a | b | proven | `slurm`")[0])
        self.assertIn("columns", faults("a | b | open")[0])
        self.assertIn("columns", faults("a | b | open | ")[0])
        self.assertIn("once more", faults("a | b | open | c", "a | d | open | e")[0])

    def test_a_document_without_claims_is_a_fault(self):
        self.assertEqual(["no claims"], faults())


if __name__ == "__main__":
    unittest.main()
