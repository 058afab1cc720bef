#!/usr/bin/env python3
"""examples.py finds what it is there to find."""
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import examples


class Examples(unittest.TestCase):
    def commands(self, document):
        return [example.text for example in examples.examples(document)]

    def faults(self, document, files=None):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file, text in (files or {}).items():
                (folder / file).write_text(text)
            found = []
            for example in examples.examples(document):
                try:
                    example.run(folder, dict(os.environ))
                except examples.Fault as fault:
                    found.append(str(fault))
            return "\n".join(found), {file.name: file.read_text() for file in folder.iterdir()}

    def test_commands_are_found_in_order(self):
        document = "`./palpate a`\n```sh\n./palpate b\n./palpate c \\\n  d\n```\n```\nno command\n```\nand `./palpate\ne`"
        self.assertEqual(["./palpate a", "./palpate b", "./palpate c    d", "./palpate e"], self.commands(document))

    def test_what_is_marked_is_left_out(self):
        document = ("<!-- not run: a person -->\n```sh\n./palpate a\n```\n```sh\n./palpate b  # not run: slow\n./palpate c\n```\n"
                    "<!-- not run: D stands for a file -->`./palpate d`")
        self.assertEqual(["./palpate c"], self.commands(document))

    def test_a_marked_block_hides_no_other(self):
        document = "<!-- not run: a -->\n```sh\nx\n```\n\n```sh\n./palpate b\n```\n"
        self.assertEqual(["./palpate b"], self.commands(document))

    def test_commands_outside_a_block_of_sh_are_a_fault(self):
        with self.assertRaises(examples.Fault):
            self.commands("```\n$ ./palpate a\n```\n")

    def test_a_command_that_fails_is_told(self):
        self.assertIn("exit code 3", self.faults("```sh\nexit 3\n```\n")[0])

    def test_output_is_compared_apart_from_numbers(self):
        shown = "```sh\n$ echo 'it took 12.5 us'\nit took 99 us\n```\n"
        self.assertEqual("", self.faults(shown)[0])
        self.assertIn("does not print", self.faults(shown.replace("99 us", "99 ms"))[0])

    def test_lines_are_put_into_a_file(self):
        document = "<!-- put into f.toml -->\n```toml\n[a]\nx = 3\ny = 4\n```\n"
        fault, files = self.faults(document, {"f.toml": "x = 0\n[a]\nx = 1\n#y = 2\n"})
        self.assertEqual(("", "x = 0\n[a]\nx = 3\ny = 4\n"), (fault, files["f.toml"]))
        self.assertIn("has no line of [a] y", self.faults(document, {"f.toml": "[a]\nx = 1\n"})[0])

    def test_what_stands_in_for_people_runs_first(self):
        document = "<!-- in place of people: ./palpate s -->\n```sh\n./palpate r\n```\n"
        self.assertEqual(["./palpate s", "./palpate r"], self.commands(document))


if __name__ == "__main__":
    unittest.main()
