"""CalculiX (ccx) on a scene: elements C3D4, small strain; where bodies touch, face-to-face penalty contact."""
import os
import pathlib
import subprocess
import sys
import time

import numpy as np

import pairing

# Printed by *NODE PRINT: one digit before the point and six behind it.
PRINTED = 0.5e-6  # of the printed number, that rounding takes at most [-]
FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))  # S1 to S4 of a C3D4: the corners of each


def _lines(numbers):
    """16 to a line, as an input file may hold."""
    return [", ".join(map(str, numbers[i:i + 16])) + "," for i in range(0, len(numbers), 16)]


def _bodies(scene):
    """Nodes, elements and materials. @return lines, and of each body its first node and element, counted from 1"""
    lines, first, node, element = [], {}, 1, 1
    for name, body in scene.bodies.items():
        first[name] = (node, element)
        lines += [f"*NODE, NSET=N{name}"]
        # 20 characters a number are read
        lines += [f"{i}, {x:.13e}, {y:.13e}, {z:.13e}" for i, (x, y, z) in enumerate(body.mesh.nodes.tolist(), node)]
        lines += [f"*ELEMENT, TYPE=C3D4, ELSET=E{name}"]
        lines += [f"{i}, " + ", ".join(str(n + node) for n in t) for i, t in
                  enumerate(body.mesh.tetrahedra.tolist(), element)]
        lines += [f"*MATERIAL, NAME=M{name}", "*ELASTIC", f"{body.modulus!r}, {body.poisson!r}",
                  f"*SOLID SECTION, ELSET=E{name}, MATERIAL=M{name}"]
        node, element = node + len(body.mesh.nodes), element + len(body.mesh.tetrahedra)
    return lines, first


def _surface(name, mesh, first_element):
    """The touchable surface as faces of elements."""
    touchable = {tuple(sorted(t)) for t in pairing.touchable_triangles(mesh).tolist()}
    lines = [f"*SURFACE, NAME=S{name}, TYPE=ELEMENT"]
    for i, tetrahedron in enumerate(mesh.tetrahedra.tolist(), first_element):
        lines += [f"{i}, S{k}" for k, face in enumerate(FACES, 1)
                  if tuple(sorted(tetrahedron[c] for c in face)) in touchable]
    return lines


def _contact(scene, first, penalty):
    """The first body's surface is the slave. @param penalty  pressure per depth [Pa/m]"""
    slave, master = scene.bodies
    lines = [line for name in scene.bodies for line in _surface(name, scene.bodies[name].mesh, first[name][1])]
    return lines + ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", f"S{slave}, S{master}",
                    "*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
                    # no pull across what stands open by more than 1e-9 m
                    f"{penalty!r}, 1e-3, 1e-9"]


def _step(scene, first):
    lines = ["*STEP", "*STATIC", "1., 1.", "*BOUNDARY"]
    for name, (nodes, values) in scene.prescribed().items():
        lines += [f"{node + first[name][0]}, {k}, {k}, {value:.13e}" for node, vector in zip(nodes.tolist(), values)
                  for k, value in enumerate(vector.tolist(), 1)]
    for name in scene.bodies:
        lines += [f"*NODE PRINT, NSET=N{name}", "U, RF"]
    return lines + ["*END STEP", ""]


def _printed(file, scene, first):
    """Displacements and forces of the last increment, of each body."""
    tables, table = {}, None
    for line in pathlib.Path(file).read_text().splitlines():
        words = line.split()
        if words and words[0] in ("displacements", "forces"):
            table = tables.setdefault(words[0], {})
        elif len(words) == 4:
            table[int(words[0])] = [float(word) for word in words[1:]]
    nodes = {name: range(begin, begin + len(scene.bodies[name].mesh.nodes)) for name, (begin, _) in first.items()}
    return tuple({name: np.array([tables[kind][node] for node in numbers]) for name, numbers in nodes.items()}
                 for kind in ("displacements", "forces"))


def solve(scene, folder, penalty=None):
    """@return displacement and force of every node of each body (n x 3), and the seconds of the whole program"""
    lines, first = _bodies(scene)
    if scene.pairing:
        lines += _contact(scene, first, penalty)
    job = pathlib.Path(folder) / "peer"
    job.with_suffix(".inp").write_text("\n".join(lines + _step(scene, first)))
    begun = time.monotonic()
    done = subprocess.run(["ccx", "-i", job.name], cwd=folder, capture_output=True, text=True,
                          env=os.environ | {"OMP_NUM_THREADS": "1"})
    seconds = time.monotonic() - begun
    if done.returncode != 0 or "Job finished" not in done.stdout:
        sys.exit(f"ccx: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return *_printed(job.with_suffix(".dat"), scene, first), seconds
