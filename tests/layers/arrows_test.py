#!/usr/bin/env python3
"""arrows.py finds what it is there to find: small trees, each with one fault."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import arrows


class Arrows(unittest.TestCase):
    def faults(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                file = pathlib.Path(folder) / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            return "\n".join(arrows.faults(pathlib.Path(folder).resolve()))

    def test_arrows_down_are_no_fault(self):
        self.assertEqual("", self.faults({
            "base/text/utf8.hpp": "", "sim/mesh/mesh.hpp": '#include "base/text/utf8.hpp"\n',
            "sim/model/model.hpp": '#include "sim/mesh/mesh.hpp"\n#include <vector>\n'}))

    def test_a_forbidden_module_is_named_with_its_place(self):
        told = self.faults({"sim/mesh/mesh.hpp": '#pragma once\n#include "trials/plan/plan.hpp"\n',
                            "trials/plan/plan.hpp": ""})
        self.assertIn("sim may not know trials (it may know base)", told)
        self.assertIn("sim/mesh -> trials/plan   sim/mesh/mesh.hpp:2", told)

    def test_base_may_know_nobody(self):
        told = self.faults({"base/text/a.cpp": '#include "sim/mesh/mesh.hpp"\n', "sim/mesh/mesh.hpp": ""})
        self.assertIn("base may not know sim (it may know nobody)", told)

    def test_a_circle_of_three_folders_is_told_with_its_arrows(self):
        told = self.faults({
            "sim/a/a.hpp": '#include "sim/b/b.hpp"\n', "sim/b/b.hpp": "", "sim/b/b.cpp": '#include "sim/c/c.hpp"\n',
            "sim/c/c.hpp": '#include "sim/a/a.hpp"\n'})
        self.assertIn("sim/a, sim/b, sim/c", told)
        self.assertIn("sim/b -> sim/c   sim/b/b.cpp:1", told)

    def test_a_folder_and_the_folder_above_can_be_a_circle(self):
        told = self.faults({"sim/contact/laws.cpp": '#include "sim/contact/kuroda/kuroda.hpp"\n',
                            "sim/contact/law.hpp": "",
                            "sim/contact/kuroda/kuroda.hpp": '#include "sim/contact/law.hpp"\n'})
        self.assertIn("sim/contact, sim/contact/kuroda", told)

    def test_pages_are_read_too(self):
        told = self.faults({"app/web/pages/a/main.ts": 'import { x } from "../b/link";\n',
                            "app/web/pages/b/link.ts": 'import { y } from "../a/main";\n'})
        self.assertIn("app/web/pages/a, app/web/pages/b", told)

    def test_a_commented_include_is_none(self):
        self.assertEqual("", self.faults({"base/text/a.cpp": '// #include "sim/mesh/mesh.hpp"\n', "sim/mesh/mesh.hpp": ""}))


if __name__ == "__main__":
    unittest.main()
