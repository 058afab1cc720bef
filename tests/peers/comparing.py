"""What the tests of this folder share: how they are called, how far apart two fields are, how a table is printed."""
import importlib.util
import shutil
import sys

SKIPPED = 77  # the exit code that ctest takes for "skipped"


def require(programs=(), modules=()):
    """Ends the test as skipped where something is not installed."""
    missing = [p for p in programs if not shutil.which(p)] + [m for m in modules if not importlib.util.find_spec(m)]
    if missing:
        print(f"not installed: {', '.join(missing)}; packages.txt names the Debian packages")
        sys.exit(SKIPPED)


def apart(ours, theirs):
    """Largest difference of two fields, as a part of the largest entry."""
    return abs(ours - theirs).max() / abs(theirs).max()


class Findings:
    """Every comparison, told; the program fails at its end if one did."""

    def __init__(self):
        self.failed = 0

    def below(self, what, value, bound):
        holds = abs(value) < bound
        self.failed += not holds
        print(f"{'ok  ' if holds else 'FAIL'} {what}: {value:.3g}, below {bound:g}", flush=True)

    def end(self):
        sys.exit(1 if self.failed else 0)


def print_table(heading, rows):
    print("\n| " + " | ".join(heading) + " |\n|" + "---|" * len(heading))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print(flush=True)
