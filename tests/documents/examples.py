#!/usr/bin/env python3
"""Runs the commands that a document shows, as they stand.

  examples.py DOCUMENT PROGRAM ROOT

The commands are those of the blocks fenced as ```sh: the lines behind "$ ", or every line where none begins so; and
what is marked as code in the text and begins with "./palpate ". They run one after the other in a folder of their own,
which holds what the source's root has of protocols/ and data/, and the files that a reader would bring (BROUGHT). Every
one must end well. Lines of output that are shown behind a "$ " command must come, whatever their numbers are.

A block of TOML behind a line `<!-- put into FILE -->` is put into that file, each line in the place of the one of its
key, as a reader does it in an editor.

`<!-- in place of people: COMMAND -->` is run as well, and not shown: it makes the sessions that people would have sat.

A block behind a line `<!-- not run: REASON -->` is left out, and so is code in the text behind one, and a line that
ends in `# not run: REASON`.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^(?:<!-- (?:not run: (?P<reason>[^\n]+)|put into (?P<file>\S+)) -->\n)?"
                   r"```(?P<kind>\w*)\n(?P<text>.*?)^```$", re.M | re.S)
INLINE = re.compile(r"(?:<!-- not run: [^\n]+? -->\s*`[^`]+`)|`(\./palpate\s[^`]+)`"
                    r"|<!-- in place of people: ([^\n]+?) -->")
NOT_RUN = re.compile(r"#.*not run: ")
NUMBER = re.compile(r"\d[\d.]*(?:e-?\d+)?")
LONGEST = 120  # that a command may take [s]
BROUGHT = pathlib.Path(__file__).resolve().parent / "brought"


class Fault(Exception):
    pass


class Command:
    """A command, and the lines of its output that are shown."""

    def __init__(self, text):
        self.text, self.shown = text, []

    def run(self, folder, environment):
        try:
            done = subprocess.run(["sh", "-c", "exec 2>&1; " + self.text], cwd=folder, env=environment, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, timeout=LONGEST)
        except subprocess.TimeoutExpired as late:
            raise Fault(f"{self.text}\n  is not over after {LONGEST} s; does it wait for a person?") from late
        if done.returncode != 0:
            raise Fault(f"{self.text}\n  exit code {done.returncode}: {done.stdout.strip()}")
        printed = {plain(line) for line in done.stdout.splitlines()}
        for line in self.shown:
            if plain(line) not in printed:
                raise Fault(f"{self.text}\n  does not print: {line}")


class Edit:
    """Lines that a reader is told to change in a file."""

    def __init__(self, file, text):
        self.file, self.text = file, text

    def run(self, folder, _):
        lines, table = (folder / self.file).read_text("utf-8").splitlines(), ""
        for line in self.text.splitlines():
            if line.startswith("["):
                table = line
            elif line:
                lines[place_of(lines, table, line.split(" = ")[0], self.file)] = line
        (folder / self.file).write_text("\n".join(lines) + "\n", "utf-8")


def place_of(lines, table, key, file):
    """Where the line of a key stands, taken in or as an option."""
    here = ""
    for number, line in enumerate(lines):
        if line.startswith("["):
            here = line
        elif here == table and line.removeprefix("#").startswith(key + " = "):
            return number
    raise Fault(f"{file} has no line of {table} {key}")


def examples(document):
    """What a document tells its reader to do, in its order."""
    found, at = [], 0
    for block in BLOCK.finditer(document):
        found += inline(document[at:block.start()])
        at = block.end()
        if block["file"]:
            found.append(Edit(block["file"], block["text"]))
        elif block["kind"] == "sh" and not block["reason"]:
            found += commands_of(block["text"])
        elif block["kind"] != "sh" and re.search(r"^(\$ )?(\./)?palpate ", block["text"], re.M):
            raise Fault(f"a block shows commands and is not fenced as sh:\n{block['text']}")
    return found + inline(document[at:])


def inline(text):
    return [Command((shown or hidden).replace("\n", " ")) for shown, hidden in INLINE.findall(text) if shown or hidden]


def commands_of(text):
    lines = text.replace("\\\n", " ").splitlines()
    transcript = any(line.startswith("$ ") for line in lines)
    found = []
    for line in lines:
        if line.startswith("$ ") or not transcript:
            found.append(Command(line.removeprefix("$ ")))
        elif line.strip() not in ("", "..."):
            found[-1].shown.append(line)
    return [command for command in found if command.text.strip() and not NOT_RUN.search(command.text)]


def plain(line):
    """A line apart from its numbers, hashes and spacing."""
    return re.sub(r"\s+", " ", NUMBER.sub("#", re.sub(r"[0-9a-f]{16,}(\.\.\.)?", "#", line))).strip()


def prepared(folder, program, root):
    for name in ("protocols", "data", "docs"):
        shutil.copytree(root / name, folder / name)
    for file in BROUGHT.iterdir():
        shutil.copy(file, folder)
    shutil.copy(root / "data/meshes/prostate.msh", folder / "mine.msh")
    launcher = folder / "palpate"
    launcher.write_text(f'#!/bin/sh\nexec "{program}" "$@"\n')
    launcher.chmod(0o755)


def main():
    document, program, root = pathlib.Path(sys.argv[1]), *map(pathlib.Path, sys.argv[2:])
    faults, ran = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prepared(folder, program, root)
        environment = os.environ | {"PATH": f"{folder}:{os.environ['PATH']}"}
        try:
            for example in examples(document.read_text("utf-8")):
                ran += 1
                try:
                    example.run(folder, environment)
                except Fault as fault:
                    faults.append(str(fault))
        except Fault as fault:
            faults.append(str(fault))
    print("\n".join(f"{document.name}: {fault}" for fault in faults) or f"{document.name}: {ran} examples run as shown")
    return 1 if faults or ran == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
