#!/usr/bin/env python3
"""Runs cycle_bench, and tells what has become slower.

  cycle_bench.py PROGRAM                     measures and shows
  cycle_bench.py PROGRAM --baseline FILE     compares ratios with a recorded baseline: ninja bench_compare
  cycle_bench.py PROGRAM --record FILE       records the baseline anew: ninja bench_record
  cycle_bench.py PROGRAM --against OTHER     runs another build's cycle_bench (of the release before) in turns with this
                                             one, and compares the times of each row

Exit code 1: something is slower, takes from the heap in a cycle, or is measured no more.

A figure is the median of several runs of the program; its noise reaches from the least to the greatest of them. Slower
means beyond noise: every run now is above every run then. Where nothing has changed, 7 runs lie above 7 others once in
3432 comparisons (14 over 7), so that of 32 rows one cries wolf in one comparison of 100. The two sets of runs of
--against take turns; a baseline is of another day, so a change must be larger than APART as well.
"""
import argparse
import csv
import datetime
import math
import statistics
import subprocess
import sys

RUNS = 7
# The part by which a ratio may move from one day to another, or with other work on the machine [-]. Two sets of runs of one
# build, on two processors with 8 to 17 programs waiting, lay apart by 3 % at the most, and by 24 % beside the limit, whose
# reading is of memory, which others read as well.
APART, APART_FROM_LIMIT = 0.10, 0.30
FAULTS = ("slower", "missing", "allocates")


def read_run(text):
    """The head and the rows of one run."""
    head, *lines = text.splitlines()
    rows = list(csv.DictReader(lines))
    for line, row in zip(lines[1:], rows):
        if None in row or None in row.values():
            raise ValueError(f"not as many cells as columns: {line}")
    return head.removeprefix("# "), rows


def collect(runs, column):
    """The values of each figure over the runs: ratios by row and what it is beside; microseconds by row."""
    values = {}
    for rows in runs:
        of_run = {(row["row"], row["beside"] if column == "ratio" else ""): float(row[column]) for row in rows}
        for key, value in of_run.items():
            values.setdefault(key, []).append(value)
    return values


def figure(values):
    """Median, least and greatest."""
    return statistics.median(values), min(values), max(values)


def compare(now, then, apart):
    """What became of each figure: (key, verdict, figure now, figure then), in the order of `now`, the missing last.

    @param now, then  (median, least, greatest) of each figure
    @param apart      of a key: a change of the median by no more than this part is none
    """
    found = []
    for key, (middle, least, greatest) in now.items():
        if key not in then:
            found.append((key, "new", now[key], None))
            continue
        was, was_least, was_greatest = then[key]
        if not all(map(math.isfinite, (middle, was))) or min(middle, was) <= 0.0:
            raise ValueError(f"{name_of(key)}: a figure must be greater than 0, found {middle} and {was}")
        if least > was_greatest and middle > was * (1.0 + apart(key)):
            verdict = "slower"
        elif greatest < was_least and was > middle * (1.0 + apart(key)):
            verdict = "faster"
        else:
            verdict = "same"
        found.append((key, verdict, now[key], then[key]))
    return found + [(key, "missing", None, then[key]) for key in then if key not in now]


def apart_on_another_day(key):
    return APART_FROM_LIMIT if key[1] == "the limit" else APART


def allocating(runs):
    """Rows whose cycles took from the heap in any run."""
    return sorted({row["row"] for rows in runs for row in rows if int(row["allocations"]) > 0})


def name_of(key):
    row, beside = key
    return f"{row} : {beside}" if beside else row


def shown(figure_of):
    return "-" if figure_of is None else "{:.4g} ({:.4g} to {:.4g})".format(*figure_of)


def report(found, heap, unit):
    """Prints a line each and the sum. @return the exit code"""
    print(f"{'verdict':<10}{'row':<48}{'now' + unit:<34}then{unit}")
    for key, verdict, now, then in found:
        change = f"  {100 * (now[0] / then[0] - 1):+.0f} %" if now and then else ""
        print(f"{verdict:<10}{name_of(key):<48}{shown(now):<34}{shown(then)}{change}")
    for row in heap:
        print(f"{'allocates':<10}{row}")
    verdicts = [verdict for _, verdict, _, _ in found] + ["allocates"] * len(heap)
    faults = [f"{verdicts.count(fault)} {fault}" for fault in FAULTS if fault in verdicts]
    print(f"{len(found)} rows: {', '.join(faults) or 'nothing slower'}")
    return 1 if faults else 0


def show(runs):
    microseconds = collect(runs, "microseconds")
    print(f"{'row : beside':<48}{'ratio':<34}{'cycle [us]':<34}{'contacts':<10}allocations")
    for row in runs[0]:
        key = (row["row"], row["beside"])
        print(f"{name_of(key):<48}{shown(figure(collect(runs, 'ratio')[key])):<34}"
              f"{shown(figure(microseconds[row['row'], ''])):<34}{row['contacts']:<10}{row['allocations']}")
    heap = allocating(runs)
    for row in heap:
        print(f"{'allocates':<10}{row}")
    return 1 if heap else 0


def write_baseline(file, head, values):
    with open(file, "w", encoding="utf-8", newline="") as out:
        out.write(f"# {head}; {datetime.date.today()}; {len(next(iter(values.values())))} runs\n")
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(["row", "beside", "ratio", "least", "greatest"])
        for key, ratios in values.items():
            writer.writerow([*key, *(f"{part:.4g}" for part in figure(ratios))])


def read_baseline(file):
    """The head and the figures."""
    with open(file, encoding="utf-8", newline="") as lines:
        head = lines.readline().strip().removeprefix("# ")
        return head, {(row["row"], row["beside"]): tuple(float(row[k]) for k in ("ratio", "least", "greatest"))
                      for row in csv.DictReader(lines)}


def machine_of(head):
    return head.split("; ")[1]


def run_in_turns(programs, count):
    """@return the head, and the rows of each run, of each program"""
    heads, runs = [""] * len(programs), [[] for _ in programs]
    for turn in range(count):
        for at, program in enumerate(programs):
            print(f"run {turn + 1} of {count}: {program}", file=sys.stderr)
            done = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True)
            heads[at], rows = read_run(done.stdout)
            runs[at].append(rows)
    return list(zip(heads, runs))


def figures(values):
    return {key: figure(all_runs) for key, all_runs in values.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    choice = parser.add_mutually_exclusive_group()
    for option in ("--baseline", "--record", "--against"):
        choice.add_argument(option)
    parser.add_argument("--runs", type=int, default=RUNS)
    asked = parser.parse_args()
    (head, runs), *other = run_in_turns([asked.program] + ([asked.against] if asked.against else []), asked.runs)
    print(head)
    if asked.against:
        print("against " + other[0][0])
        then = figures(collect(other[0][1], "microseconds"))
        return report(compare(figures(collect(runs, "microseconds")), then, lambda _: 0.0), allocating(runs), " [us]")
    ratios = collect(runs, "ratio")
    if asked.record:
        write_baseline(asked.record, head, ratios)
    if not asked.baseline:
        return show(runs)
    baseline_head, then = read_baseline(asked.baseline)
    print("baseline " + baseline_head)
    if machine_of(baseline_head) != machine_of(head):
        print("The baseline is another machine's: ratios follow caches and clocks, too. Record it anew for a verdict here.")
    return report(compare(figures(ratios), then, apart_on_another_day), allocating(runs), "")


if __name__ == "__main__":
    sys.exit(main())
