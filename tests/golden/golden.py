#!/usr/bin/env python3
"""What a user sees of palpate, recorded and compared: tests/golden/README.md.

  golden.py record PROGRAM FOLDER    runs PROGRAM on every shipped scene and protocol, writes FOLDER/*.json
  golden.py compare PROGRAM FOLDER   does the same aside, and compares it with FOLDER; exit code 1 names what differs
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

import chain

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = ["none", "sibille", "kuroda"]
PRESS_STEPS = "10"
# Another processor may round the last bits otherwise (fused multiply-add, the BLAS kernel that is chosen): forces and
# depths then differ by some 1e-12 of themselves, and by 1e-7 where they were kept in single precision in a trace.
CLOSE = 1e-6
MOMENT = re.compile(r"\d{4}-\d\d-\d\d[T ]\d\d:\d\d:\d\d(?:[.\d]*Z| UTC)?")


def run(program, *arguments):
    done = subprocess.run([program, *arguments], cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"palpate {' '.join(arguments)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def without(value, drop):
    """The same JSON value without the keys that `drop` names, at any depth, and without points in time in texts."""
    if isinstance(value, dict):
        return {key: without(item, drop) for key, item in value.items() if not drop(key)}
    if isinstance(value, list):
        return [without(item, drop) for item in value]
    return MOMENT.sub("(a point in time)", value) if isinstance(value, str) else value


def is_clock(key):
    """Clock, machine and loop timing: what no two runs share."""
    return key.endswith("_utc") or key in ("utc", "cycle_us", "machine", "software_version", "uuid", "receipt", "file",
                                           "study_uuid", "program", "version")


def press(program, where, *options):
    text = run(program, "press", where, "--steps", PRESS_STEPS, "--format", "json", *options)
    return without(json.loads(text), is_clock)


def presses(program):
    found = {}
    for scene in sorted((ROOT / "data/scenes").glob("*.toml")):
        for model in MODELS:
            found[f"{scene.name}, {model}"] = press(program, f"data/scenes/{scene.name}", "--model", model)
    for protocol in shipped_protocols():
        found[protocol.name] = press(program, f"protocols/{protocol.name}")
    return found


def table(file):
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.reader(stream))
    kept = [place for place, name in enumerate(rows[0]) if not is_clock(name)]
    return [[row[place] for place in kept] for row in rows]


def study(program, protocol, folder):
    """A whole study with simulated examinees: exports, report, and the chain of each sitting."""
    file = folder / "study.db"
    planned = tomllib.loads((ROOT / "protocols" / protocol).read_text("utf-8"))["sample"]["planned_examinees"]
    run(program, "simulate", f"protocols/{protocol}", "--study", str(file), "--seed", "1", "--examinees", str(planned))
    run(program, "export", str(file), "--as", "csv", "--out", str(folder / "csv"))
    run(program, "export", str(file), "--as", "json", "--out", str(folder / "json"))
    report = json.loads(run(program, "report", str(file), "--run-mode", "simulated", "--format", "json"))
    return {
        "csv": {at.name: table(at) for at in sorted((folder / "csv").glob("*.csv"))},
        "json": without(json.loads((folder / "json/study.json").read_text("utf-8")), is_clock) | {"study": "(random)"},
        "report": without(report, is_clock),
        "sittings": chain.sittings(file),
    }


def shipped_protocols():
    return [at for at in sorted((ROOT / "protocols").glob("*.toml")) if at.name.startswith("kuroda2003")]


def studies(program):
    for protocol in shipped_protocols():
        with tempfile.TemporaryDirectory() as folder:
            yield protocol.stem, study(program, protocol.name, pathlib.Path(folder))


def recording(program):
    yield "press", presses(program)
    yield from studies(program)


def write(value, file):
    """One line for each innermost object or list, so that a difference shows where it is."""
    def lines(item, indent):
        inner = list(item.values()) if isinstance(item, dict) else item
        flat = not any(isinstance(part, (dict, list)) for part in inner)
        if flat or not inner:
            return json.dumps(item, ensure_ascii=False)
        pad = " " * (indent + 1)
        if isinstance(item, dict):
            parts = [f"{pad}{json.dumps(key)}: {text(part, indent + 1)}" for key, part in item.items()]
            return "{\n" + ",\n".join(parts) + "\n" + " " * indent + "}"
        return "[\n" + ",\n".join(pad + text(part, indent + 1) for part in item) + "\n" + " " * indent + "]"

    def text(item, indent):
        return lines(item, indent) if isinstance(item, (dict, list)) else json.dumps(item, ensure_ascii=False)

    file.write_text(text(value, 0) + "\n", encoding="utf-8")


def number(value):
    if isinstance(value, bool):
        return None
    if isinstance(value, (int, float)):
        return float(value)
    try:
        return float(value) if isinstance(value, str) else None
    except ValueError:
        return None


class Comparison:
    """Differences, told apart: of meaning, and of rounding alone."""

    def __init__(self):
        self.differences, self.roundings = [], 0

    def of(self, was, now, where):
        if was == now and type(was) is type(now):
            return
        if isinstance(was, dict) and isinstance(now, dict) and list(was) == list(now):
            for key in was:
                self.of(was[key], now[key], f"{where}.{key}")
        elif isinstance(was, list) and isinstance(now, list) and len(was) == len(now):
            for place, (before, after) in enumerate(zip(was, now)):
                self.of(before, after, f"{where}[{place}]")
        elif self.rounded(was, now) or where.endswith(".head"):
            self.roundings += 1
        else:
            self.differences.append(f"{where}\n  was {str(was)[:300]}\n  is  {str(now)[:300]}")

    @staticmethod
    def rounded(was, now):
        before, after = number(was), number(now)
        if before is None or after is None or type(was) is not type(now):
            return False
        return abs(before - after) <= CLOSE * max(abs(before), abs(after), 1e-3)


def processor():
    """What decides how sums are rounded: the processor's name and its instructions."""
    facts = {}
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        name, _, value = line.partition(":")
        facts.setdefault(name.strip(), value.strip())
    return f"{facts.get('model name', 'unknown')}; {'avx512f' if 'avx512f' in facts.get('flags', '') else 'no avx512f'}"


def compare(program, folder):
    comparison = Comparison()
    made_on = (folder / "processor.txt").read_text("utf-8").strip()
    for name, now in recording(program):
        comparison.of(json.loads((folder / f"{name}.json").read_text("utf-8")), json.loads(json.dumps(now)), name)
    if comparison.roundings and made_on == processor():
        comparison.differences.append(
            f"{comparison.roundings} values differ in rounding alone, on the kind of processor that recorded them")
    for difference in comparison.differences[:20]:
        print(difference)
    if len(comparison.differences) > 20:
        print(f"and {len(comparison.differences) - 20} more")
    print(f"{len(comparison.differences)} differences, {comparison.roundings} values rounded otherwise "
          f"(recorded on {made_on}; here {processor()})")
    return 1 if comparison.differences else 0


def record(program, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, value in recording(program):
        write(value, folder / f"{name}.json")
    (folder / "processor.txt").write_text(processor() + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in ("record", "compare"):
        sys.exit(__doc__)
    sys.exit({"record": record, "compare": compare}[sys.argv[1]](sys.argv[2], pathlib.Path(sys.argv[3])))
