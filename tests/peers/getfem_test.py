#!/usr/bin/env python3
"""palpate against GetFEM on the same meshes, elements and contact conditions: docs/peers.md.

  getfem_test.py PALPATE    prints the table, too; exit code 1 where they differ, 77 where GetFEM is not installed
"""
import sys
import tempfile

import comparing

comparing.require(programs=["gmsh"], modules=["numpy", "getfem"])
import getfem  # noqa: E402  after it is known to be there

import peer_getfem  # noqa: E402
import run_palpate  # noqa: E402
import scenes  # noqa: E402

# Both solve one linear system in double precision, by other elimination orders.
SAME_SYSTEM = 1e-9
# GetFEM's Newton stops at a residual of 1e-9 of the forces; palpate shares redundant contacts with 1e-12 of D.
SAME_CONTACT = 1e-6
# GetFEM's own pairing takes other normals where nodes of the box face the facets of the sphere; before the flat box
# there is nothing to choose.
OWN_PAIRING = {"nodes of sphere": SAME_CONTACT, "nodes of box": 0.01, "both": SAME_CONTACT}
DEPTH = 2e-3  # of the sphere's cap [m]


def compare(palpate, name, scene, folder, bound, findings):
    """@return a row of the table"""
    ours = run_palpate.press(palpate, scene.write(folder), scene.meshes())
    displacement, forces, seconds = peer_getfem.solve(scene)
    first = next(iter(scene.bodies))
    force = forces[first][scene.moved].sum(0)  # on what is moved, as palpate's on the probe's body
    differences = {"force": comparing.apart(ours.force, force),
                   "displacement": max(comparing.apart(ours.displacement[b], displacement[b]) for b in scene.bodies)}
    for what, value in differences.items():
        findings.below(f"{name}, {what}", value, bound)
    own = "-"
    if scene.pairing:
        pressed = peer_getfem.solve(scene, own_pairing=True)[1][first][scene.moved].sum(0) @ scene.direction
        difference = ours.force @ scene.direction / pressed - 1
        findings.below(f"{name}, force with GetFEM's own pairing", difference, OWN_PAIRING[scene.pairing])
        own = f"{abs(difference):.1e}"
    nodes = sum(len(body.mesh.nodes) for body in scene.bodies.values())
    return [name, str(nodes), str(ours.active) if scene.pairing else "-", f"{force @ scene.direction:.8f}",
            *(f"{value:.1e}" for value in differences.values()), own, f"{1e3 * seconds:.0f}", f"{1e3 * ours.cycle:.3f}"]


def main(palpate):
    getfem.util_trace_level(1)
    findings, rows = comparing.Findings(), []
    for name, scene in (("region on a block", scenes.region_on_block()),
                        ("point on the prostate", scenes.point_on_prostate())):
        with tempfile.TemporaryDirectory() as folder:
            rows.append(compare(palpate, name, scene, folder, SAME_SYSTEM, findings))
    for edge in (7e-3, 4e-3):
        for pairing in ("nodes of sphere", "nodes of box", "both"):
            with tempfile.TemporaryDirectory() as folder:
                scene = scenes.sphere_on_box(folder, edge, pairing, DEPTH)
                rows.append(compare(palpate, f"sphere on box, {1e3 * edge:g} mm, {pairing}", scene, folder,
                                    SAME_CONTACT, findings))
    comparing.print_table(["scene", "nodes", "closed contacts", "force of GetFEM along the press [N]",
                           "forces differ by", "displacements differ by", "forces differ by, GetFEM's own pairing",
                           "GetFEM's solve [ms]", "palpate's cycle [ms]"], rows)
    findings.end()


main(sys.argv[1])
