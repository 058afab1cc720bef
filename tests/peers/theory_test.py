#!/usr/bin/env python3
"""palpate against formulas, on finer and finer meshes: docs/peers.md.

  theory_test.py PALPATE           exit code 1 where an error does not fall or is too large, 77 without Gmsh
  theory_test.py PALPATE --table   also the finest meshes
"""
import dataclasses
import functools
import sys
import tempfile

import comparing

comparing.require(programs=["gmsh"], modules=["numpy"])
import numpy as np  # noqa: E402  after it is known to be there

import run_palpate  # noqa: E402
import theory_scenes  # noqa: E402

DIED_OUT = 1e-8  # of the strain, what the held ends of a bar may still do seven widths away [-]; found: 1e-10


@dataclasses.dataclass
class Case:
    name: str
    scene: object  # (folder, cells) to scene and force [N]
    cells: tuple  # of the tests
    finest: tuple  # of the table alone
    bound: float  # of the error at the last of the tests
    limit: float  # of what the last two of the tests tend to
    falls: bool = True


CASES = [
    Case("bar pulled, nu = 0", theory_scenes.bar, (1, 2, 4), (), 1e-9, 1e-9, falls=False),
    Case("beam, one end moved across, nu = 0", theory_scenes.beam, (2, 4, 8, 16), (32,), 0.02, 1e-3),
    Case("Hertz: fingertip, nu = 0.4", theory_scenes.fingertip, (4, 6), (8,), 0.13, 0.05),
    Case("Hertz: stiff body, nu = 0.4", theory_scenes.rigid_sphere, (4, 6), (8, 10, 12), 0.13, 0.05),
    Case("Sneddon: cone, nu = 0.4", theory_scenes.rigid_cone, (4, 6), (8, 10, 12), 0.13, 0.05),
    Case("Sneddon: flat punch, nu = 0", theory_scenes.smooth_punch, (1.5, 2, 2.5), (3, 3.5), 0.17, 0.02),
    Case("Spence: flat punch that sticks, nu = 0", functools.partial(theory_scenes.sticking_punch, poisson=0.0),
         (2, 3), (4, 5), 0.12, 0.02),
    Case("Spence: flat punch that sticks, nu = 0.4", functools.partial(theory_scenes.sticking_punch, poisson=0.4),
         (2, 3), (4, 5), 0.15, 0.02),
]


def solve(palpate, case, cells):
    """@return the error, and a row of the table"""
    with tempfile.TemporaryDirectory() as folder:
        scene, force = case.scene(folder, cells)
        ours = run_palpate.press(palpate, scene.write(folder), scene.meshes(), save=False)
    found = ours.force @ scene.direction
    nodes = sum(len(body.mesh.nodes) for body in scene.bodies.values())
    return found / force - 1, [case.name, str(cells), str(nodes), f"{force:.6g}", f"{found:.6g}",
                               f"{100 * (found / force - 1):+.2g} %", f"{ours.preparation:.2f}",
                               f"{1e3 * ours.cycle:.3f}"]


def tends_to(errors, cells):
    """Error that the last two tend to where it falls as 1 / cells^2, as the energy does that linear elements miss."""
    coarse, fine = (n**-2 for n in cells[-2:])
    return errors[-1] - (errors[-2] - errors[-1]) * fine / (coarse - fine)


def check_case(palpate, case, table, findings):
    """@return rows of the table"""
    fineness = case.cells + (case.finest if table else ())
    solved = [solve(palpate, case, cells) for cells in fineness]
    errors = [error for error, _ in solved]
    for before, after in zip(errors, errors[1:]) if case.falls else ():
        findings.below(f"{case.name}: the error over that on the coarser mesh", after / before, 1)
    tested = errors[:len(case.cells)]
    findings.below(f"{case.name}: error with {case.cells[-1]} cells", tested[-1], case.bound)
    findings.below(f"{case.name}: error that this tends to", tends_to(tested, case.cells), case.limit)
    tends = [case.name, "tends to", "", "", "", f"{100 * tends_to(errors, fineness):+.2g} %", "", ""]
    return [row for _, row in solved] + [tends]


def check_contraction(palpate, findings):
    """Half-way along a bar whose ends are held: strain F / (E A) along it, -nu times that across."""
    scene = theory_scenes.contracting_bar()
    body = scene.bodies["body"]
    with tempfile.TemporaryDirectory() as folder:
        ours = run_palpate.press(palpate, scene.write(folder), scene.meshes())
    at, u = body.mesh.nodes, ours.displacement["body"]
    length, width = at[:, 2].max(), 2 * at[:, 0].max()
    middle = np.abs(at[:, 2] - length / 2) < width
    slopes = np.linalg.lstsq(np.column_stack([at[middle], np.ones(middle.sum())]), u[middle], rcond=None)[0]
    strain = ours.force @ scene.direction / (body.modulus * width**2)
    findings.below("bar, nu = 0.3: strain along, against F / (E A)", slopes[2, 2] / strain - 1, DIED_OUT)
    for axis, name in enumerate("xy"):
        findings.below(f"bar, nu = 0.3: strain along {name}, against -nu F / (E A)",
                       slopes[axis, axis] / (-body.poisson * strain) - 1, DIED_OUT)


def main(palpate, table):
    findings, rows = comparing.Findings(), []
    check_contraction(palpate, findings)
    for case in CASES:
        rows += check_case(palpate, case, table, findings)
    comparing.print_table(["scene", "cells", "nodes", "formula [N]", "palpate [N]", "error",
                           "preparation [processor s]", "cycle [ms]"], rows)
    findings.end()


main(sys.argv[1], "--table" in sys.argv[2:])
