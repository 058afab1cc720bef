#!/usr/bin/env python3
"""palpate against CalculiX on the same meshes: docs/peers.md.

  calculix_test.py PALPATE           exit code 1 where they differ, 77 where ccx is not installed
  calculix_test.py PALPATE --table   also finer meshes
"""
import sys
import tempfile

import comparing

comparing.require(programs=["ccx", "gmsh"], modules=["numpy"])
import numpy as np  # noqa: E402  after it is known to be there

import peer_calculix  # noqa: E402
import run_palpate  # noqa: E402
import scenes  # noqa: E402

DEPTH = 2e-3  # of the sphere's cap [m]
PAIRINGS = ("nodes of box", "nodes of sphere", "both")
PENALTIES = (1e9, 1e10, 1e11)  # pressure per depth [Pa/m]


def beyond_rounding(ours, theirs):
    """Largest difference, as a part of what the printed digits allow: half a unit of the last one, and for entries
    near 0 1e-10 of the largest, for both solved a linear system."""
    allowed = peer_calculix.PRINTED * np.abs(theirs) + 1e-10 * np.abs(theirs).max()
    return (np.abs(ours - theirs) / allowed).max()


def compare_fields(palpate, name, scene, findings):
    """@return a row of the table"""
    body = next(iter(scene.bodies))
    with tempfile.TemporaryDirectory() as folder:
        ours = run_palpate.press(palpate, scene.write(folder), scene.meshes())
        displacement, forces, seconds = peer_calculix.solve(scene, folder)
    force = forces[body][scene.moved].sum(0)
    # A sum of printed numbers: each may be off by its last digit.
    sums = peer_calculix.PRINTED * np.abs(forces[body][scene.moved]).sum()
    findings.below(f"{name}, displacements, of what the printed digits allow",
                   beyond_rounding(ours.displacement[body], displacement[body]), 1)
    findings.below(f"{name}, force [N]", np.abs(ours.force - force).max(), sums)
    return [name, str(len(displacement[body])), f"{comparing.apart(ours.force, force):.1e}",
            f"{comparing.apart(ours.displacement[body], displacement[body]):.1e}", f"{seconds:.2f}",
            f"{1e3 * ours.cycle:.3f}"]


def compare_contact(palpate, edge):
    """How far CalculiX's force is from palpate's, at each penalty. @return the differences, and a row of the table"""
    ours = {}
    with tempfile.TemporaryDirectory() as folder:
        scene = scenes.sphere_on_box(folder, edge, "both", DEPTH)
        for scene.pairing in PAIRINGS:
            ours[scene.pairing] = run_palpate.press(palpate, scene.write(folder), scene.meshes(), save=False)
        solved = [peer_calculix.solve(scene, folder, penalty) for penalty in PENALTIES]
    theirs = [forces["sphere"][scene.moved].sum(0) @ scene.direction for _, forces, _ in solved]
    force = {pairing: pressed.force @ scene.direction for pairing, pressed in ours.items()}
    differences = [t / force["both"] - 1 for t in theirs]
    nodes = sum(len(body.mesh.nodes) for body in scene.bodies.values())
    row = [f"{1e3 * edge:g}", str(nodes), str(ours["nodes of sphere"].active), *(f"{f:.4f}" for f in force.values()),
           *(f"{t:.4f} ({100 * d:+.1f} %)" for t, d in zip(theirs, differences)), f"{solved[-1][2]:.1f}",
           f"{1e3 * ours['both'].cycle:.3f}"]
    return differences, row


def main(palpate, table):
    findings = comparing.Findings()
    rows = [compare_fields(palpate, name, scene, findings)
            for name, scene in (("region on a block", scenes.region_on_block()),
                                ("point on the prostate", scenes.point_on_prostate()))]
    comparing.print_table(["scene", "nodes", "forces differ by", "displacements differ by", "ccx, whole program [s]",
                           "palpate's cycle [ms]"], rows)
    edges = (7e-3, 4e-3) + ((2.9e-3, 2.2e-3) if table else ())
    compared = [compare_contact(palpate, edge) for edge in edges]
    for edge, (differences, _) in zip(edges, compared):
        for penalty, before, after in zip(PENALTIES[1:], differences, differences[1:]):
            findings.below(f"{1e3 * edge:g} mm, {penalty:.0e} Pa/m: the difference over that with less penalty",
                           after / before, 1)
    for (coarse, _), (fine, _) in zip(compared, compared[1:]):
        findings.below("hardest penalty: the difference over that on the coarser mesh", fine[-1] / coarse[-1], 1)
    findings.below("4 mm, hardest penalty: forces differ by", compared[1][0][-1], 0.02)
    comparing.print_table(["edges [mm]", "nodes", "closed contacts", *(f"{pairing} [N]" for pairing in PAIRINGS),
                           *(f"ccx, {p:.0e} Pa/m [N]" for p in PENALTIES), "ccx, whole program [s]",
                           "palpate's cycle [ms]"], [row for _, row in compared])
    findings.end()


main(sys.argv[1], "--table" in sys.argv[2:])
