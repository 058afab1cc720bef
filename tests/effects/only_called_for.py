#!/usr/bin/env python3
"""What a cycle executes, counted by valgrind's callgrind.

  only_called_for.py CYCLES CYCLES_EXTENDED SOURCE

1. A simulation that is made and run enters no file of a contact law, effect or probe kind that its scene does not call
   for, and does enter those of the law that it calls for.
2. A cycle takes the same number of instructions in a program to which a law, an effect and a probe kind have been
   added (tests/extending), of which the scene knows nothing.

CYCLES makes a simulation, runs 100 cycles, then 200 (cycles.cpp): what 100 take is the difference, to the instruction.
"""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

LAWS = ["none", "sibille", "kuroda", "exact"]
SHARED = {"sim/contact/prescribed", "sim/probe/mean"}  # rooms of several laws, of several kinds


def rooms_of(source):
    """Folders of laws, effects and kinds that have code of their own, and of detection, which only laws call for."""
    rooms = {str(folder.relative_to(source)) for part in ("contact", "effects", "probe")
             for folder in (source / "sim" / part).iterdir() if folder.is_dir()}
    return rooms - SHARED | {"sim/pairing"}


def own_instructions(dump, program):
    """Instructions of the program itself: how many the C library takes to copy or to clear memory hangs on where that
    lies."""
    total, own, after_call = 0, False, False
    for line in dump.splitlines():
        if line.startswith("ob="):
            own = line[3:] == str(program)
        elif line.startswith("calls="):
            after_call = True  # the next line has the cost of what is called
        elif re.match(r"^[+*\-\d]", line):
            if own and not after_call:
                total += int(line.split()[-1])
            after_call = False
    return total


def count(program, law, kind, folder):
    """Instructions of 100 and of 200 cycles, the files entered, and what the program printed."""
    out = pathlib.Path(folder) / f"{program.name}.{law}.{kind}"
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=make_simulation",
         "--toggle-collect=run_cycles", "--dump-after=make_simulation", "--dump-after=run_cycles",
         "--compress-strings=no", "--compress-pos=no", f"--callgrind-out-file={out}", program, law, kind],
        capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"{program.name} {law} {kind}: valgrind ended with {run.returncode}:\n{run.stderr}")
    dumps = [pathlib.Path(f"{out}.{number}").read_text() for number in (1, 2, 3)]
    instructions = [own_instructions(dump, program) for dump in dumps[1:]]
    files = set(re.findall(r"^(?:fl|fi|fe)=(.*)$", "\n".join(dumps), re.MULTILINE))
    return instructions, files, run.stdout.split()


def room_of(file, rooms):
    return next((room for room in rooms if f"{room}/" in file), None)


def main():
    program, extended, source = map(pathlib.Path, sys.argv[1:])
    if not shutil.which("valgrind"):
        print("valgrind is not installed: what a cycle executes is not looked at")
        return 77
    rooms, faults = rooms_of(source), []
    scenes = [(law, "point") for law in LAWS] + [("exact", "pad")]
    jobs = [(one, *scene) for scene in scenes for one in (program, extended)]
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = dict(zip(jobs, pool.map(lambda job: count(*job, folder), jobs)))
    for law, kind in scenes:
        (once, twice), files, printed = results[program, law, kind]
        entered = {room_of(file, rooms) for file in files} - {None}
        allowed = {f"sim/contact/{law}", f"sim/probe/{kind}"} | ({"sim/pairing"} if law != "none" else set())
        for room in sorted(entered - allowed):
            faults.append(f"{law}, {kind}: cycles enter {room}, which the scene does not call for")
        if law != "none" and f"sim/contact/{law}" not in entered:
            faults.append(f"{law}, {kind}: cycles do not enter sim/contact/{law}: are there line tables (-g1)?")
        (more_once, more_twice), _, printed_more = results[extended, law, kind]
        if int(printed_more[0]) != int(printed[0]) + 3 or printed_more[1:] != printed[1:]:
            faults.append(f"{law}, {kind}: {extended.name} printed {printed_more}, {program.name} {printed}")
        cycles, more = twice - once, more_twice - more_once
        print(f"{law}, {kind}: {cycles / 100} instructions a cycle; with rooms added {more / 100}")
        if cycles != more or cycles <= 0:
            faults.append(f"{law}, {kind}: 100 cycles take {cycles} instructions, and {more} with rooms added")
    print("\n".join(faults) or "cycles execute what their scene calls for")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
