#!/usr/bin/env python3
"""Holds docs/claims.md against the tests that there are.

  claims.py DOCUMENT CTEST BUILD_FOLDER

Its tables have the columns claim, stands in, standing, by. A claim that is `verified` names one test or more, as code, by
the names that ctest knows: of a test with parameters without them (`Laws/Allocation.NoneInTheCycle/none` is
`Allocation.NoneInTheCycle`). One that is `observed` names a command, as code, and a day (2026-11-29). One that is `open`
says what is missing. Exit code 77: programs of the tests are not built, so that nothing can be said.
"""
import json
import pathlib
import re
import subprocess
import sys

COLUMNS = ["claim", "stands in", "standing", "by"]
STANDINGS = ("verified", "observed", "open")
CODE = re.compile(r"`([^`]+)`")
DAY = re.compile(r"\b20\d\d-\d\d-\d\d\b")
NOT_BUILT = "_NOT_BUILT"
CANNOT_TELL = 77


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split(" | ")]


def claims_of(document):
    """(line number, cells) of each claim."""
    found, inside = [], False
    for number, line in enumerate(document.splitlines(), 1):
        if not line.startswith("|"):
            inside = False
        elif cells(line) == COLUMNS:
            inside = True
        elif inside and not set(line) <= set("|- "):
            found.append((number, cells(line)))
    return found


def plain(name):
    """A test's name without its parameters and the name of their set."""
    parts = name.split("/")
    return next((part for part in parts if "." in part), name) if len(parts) > 1 else name


def faults_of(claims, tests):
    """@param tests  the names that ctest knows"""
    known = {plain(name) for name in tests} | set(tests)
    faults, seen = [], {}
    for number, row in claims:
        if len(row) != len(COLUMNS) or not all(row):
            faults.append(f"line {number}: {len(COLUMNS)} columns are needed, none of them empty")
            continue
        claim, _, standing, by = row
        if claim in seen:
            faults.append(f"line {number}: the claim of line {seen[claim]} once more")
        seen[claim] = number
        if standing not in STANDINGS:
            faults.append(f"line {number}: \"{standing}\" is no standing; accepted: {', '.join(STANDINGS)}")
        if standing == "verified":
            names = CODE.findall(by)
            if not names:
                faults.append(f"line {number}: is verified by no test")
            faults += [f"line {number}: there is no test {name}" for name in names if name not in known]
        if standing == "observed" and not (CODE.search(by) and DAY.search(by)):
            faults.append(f"line {number}: is observed by no command on no day")
    return faults if claims else ["no claims"]


def tests_of(ctest, folder):
    listed = subprocess.run([ctest, "--show-only=json-v1", "--test-dir", folder], check=True, stdout=subprocess.PIPE,
                            text=True).stdout
    return [test["name"] for test in json.loads(listed)["tests"]]


def main():
    document, ctest, folder = sys.argv[1:]
    tests = tests_of(ctest, folder)
    not_built = [name.removesuffix(NOT_BUILT) for name in tests if name.endswith(NOT_BUILT)]
    if not_built:
        print(f"not built: {', '.join(not_built)}")
        return CANNOT_TELL
    claims = claims_of(pathlib.Path(document).read_text("utf-8"))
    faults = faults_of(claims, tests)
    standing = [row[2] for _, row in claims if len(row) == len(COLUMNS)]
    print("\n".join(faults) or f"{len(claims)} claims: " + ", ".join(f"{standing.count(s)} {s}" for s in STANDINGS))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
