#!/usr/bin/env python3
"""Keeps docs/extending.md equal to the examples that it shows.

  document.py check ROOT   says where the document shows other text than a file holds, or leaves an example out
  document.py write ROOT   puts the files' text in

A block follows a line `<!-- tests/extending/NAME/FILE -->` and is fenced.
"""
import pathlib
import re
import sys

BLOCK = re.compile(r"^<!-- (tests/extending/\S+) -->\n```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SHOWN = {".hpp", ".cpp", ".txt"}  # of an example: but for its test and what a shipped example resembles


def main():
    command, root = sys.argv[1], pathlib.Path(sys.argv[2])
    document = root / "docs/extending.md"
    text, faults = document.read_text(), []
    for path, _, shown in BLOCK.findall(text):
        if not (root / path).is_file():
            faults.append(f"{path}: is shown and does not exist")
        elif (root / path).read_text() != shown:
            faults.append(f"{path}: the document shows another text; python3 tests/extending/document.py write .")
    shown = {path for path, _, _ in BLOCK.findall(text)}
    for file in sorted((root / "tests/extending").glob("*/*")):
        path = str(file.relative_to(root))
        if file.suffix in SHOWN and not path.endswith("_test.cpp") and path not in shown:
            faults.append(f"{path}: is not shown")
    if command == "write":
        def filled(block):
            file = root / block[1]
            return f"<!-- {block[1]} -->\n```{block[2]}\n{file.read_text()}```" if file.is_file() else block[0]
        document.write_text(BLOCK.sub(filled, text))
        return 0
    print("\n".join(f"docs/extending.md: {fault}" for fault in faults) or "the document shows what is built")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
