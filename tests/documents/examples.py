#!/usr/bin/env python3
"""Runs the commands that a document shows, as they stand.

  examples.py DOCUMENT PROGRAM ROOT

The commands are those of the blocks fenced as ```sh: the lines behind "$ ", or every line where none begins so; and
what is marked as code in the text and begins with ./palpate. They run one after the other in a folder of their own,
which holds what the source's root has of protocols/ and data/, and the files that a reader would bring (BROUGHT). Every
one must end well. Lines of output that are shown behind a "$ " command must come, whatever their numbers are.

A block behind a line `<!-- not run: REASON -->` is left out, and so is a line that ends in `# not run: REASON`.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^(?:<!-- not run: (?P<reason>.+) -->\n)?```(?P<kind>\w*)\n(?P<text>.*?)^```$", re.M | re.S)
INLINE = re.compile(r"`(\./palpate [^`]+)`")
NUMBER = re.compile(r"\d[\d.]*(?:e-?\d+)?")
BROUGHT = pathlib.Path(__file__).resolve().parent / "brought"


class Faults(Exception):
    pass


def examples(document):
    """(command, lines of output that are shown) in the order of the document."""
    found, at = [], 0
    for block in BLOCK.finditer(document):
        found += [(command, []) for command in INLINE.findall(document[at:block.start()])]
        at = block.end()
        if block["kind"] == "sh" and not block["reason"]:
            found += commands_of(block["text"])
        elif "palpate " in block["text"] and block["kind"] != "sh" and re.search(r"^(\$ )?(\./)?palpate ", block["text"], re.M):
            raise Faults(f"a block shows commands and is not fenced as sh:\n{block['text']}")
    found += [(command, []) for command in INLINE.findall(document[at:])]
    return [(command, shown) for command, shown in found if "# not run: " not in command and "..." not in command]


def commands_of(text):
    lines = joined(text)
    if not any(line.startswith("$ ") for line in lines):
        return [(line, []) for line in lines if line.strip()]
    found = []
    for line in lines:
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found and line.strip() not in ("", "..."):
            found[-1][1].append(line)
    return found


def joined(text):
    return text.replace("\\\n", " ").splitlines()


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
            found = examples(document.read_text("utf-8"))
        except Faults as fault:
            found = []
            faults.append(str(fault))
        for command, shown in found:
            done = subprocess.run(["sh", "-c", command], cwd=folder, env=environment, capture_output=True, text=True,
                                  stdin=subprocess.DEVNULL)
            ran += 1
            if done.returncode != 0:
                faults.append(f"{command}\n  exit code {done.returncode}: {done.stderr.strip()}")
            printed = {plain(line) for line in (done.stdout + done.stderr).splitlines()}
            faults += [f"{command}\n  does not print: {line}" for line in shown if plain(line) not in printed]
    print("\n".join(f"{document.name}: {fault}" for fault in faults) or f"{document.name}: {ran} commands run as shown")
    return 1 if faults or ran == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
