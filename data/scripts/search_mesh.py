#!/usr/bin/env python3
"""Finds the parameters of a geometry whose mesh has the wanted counts: search_mesh.py rectum|prostate [DRAWS] [SEED]

Draws parameters at random within ranges that anatomy and the look of the mesh allow, and prints those with the
node counts of Table 1 of Kuroda et al. 2003, best element quality last. Forces are not looked at. Needs gmsh.
"""
import os
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import measure_mesh  # beside this file

HERE = os.path.dirname(os.path.abspath(__file__))


def steps(first, last, step):
    return [round(first + i * step, 6) for i in range(round((last - first) / step) + 1)]


# Wanted: all nodes, free surface nodes. Ranges in the units of the geometry (mm, degree).
SEARCHES = {
    "rectum": ((282, 207), {"length": steps(60, 64, 2), "size": steps(7.8, 8.4, 0.1),
                            "lumen_size": steps(7.6, 8.4, 0.1), "sacral_angle": steps(23, 25, 1),
                            "margin": steps(6, 8, 0.5), "contact_angle": steps(64, 90, 2)}),
    "prostate": ((360, 110), {"depth_below": steps(10, 11, 0.1), "depth_above": steps(14.5, 15.5, 0.1),
                              "contact_height": steps(4, 5, 0.5), "size": steps(4.15, 4.3, 0.05)}),
}


def mesh(geometry, parameters, dimension, folder):
    """Makes a mesh; None where Gmsh gives up."""
    file = os.path.join(folder, "mesh.msh")
    options = [word for name, value in parameters.items() for word in ("-setnumber", name, str(value))]
    command = ["gmsh", f"-{dimension}", "-v", "1", "-nt", "1", *options,
               os.path.join(HERE, "..", "geometry", geometry + ".geo"), "-o", file]
    return file if subprocess.run(command, capture_output=True).returncode == 0 else None


def surface_counts(file):
    """Nodes and free nodes of a surface mesh."""
    nodes, elements = measure_mesh.read(file)
    fixed = {n for _, names, tags in elements if "fixed" in names for n in tags}
    return len(nodes), len(nodes) - len(fixed)


def search(geometry, draws, seed):
    wanted, ranges = SEARCHES[geometry]
    random.seed(seed)
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(draws):
            parameters = {name: random.choice(values) for name, values in ranges.items()}
            file = mesh(geometry, parameters, 2, folder)  # the surface alone is quick to make, and tells most
            if not file or surface_counts(file)[1] != wanted[1]:
                continue
            file = mesh(geometry, parameters, 3, folder)
            figures = measure_mesh.measure(file) if file else {"nodes": 0}
            if figures["nodes"] == wanted[0]:
                found.append((figures["min_angle"], figures, parameters))
                print_one(figures, parameters)
    print("best last:")
    for _, figures, parameters in sorted(found, key=lambda f: f[0]):
        print_one(figures, parameters)


def print_one(figures, parameters):
    chosen = " ".join(f"{name} {value}" for name, value in parameters.items())
    print(f"{figures['tetrahedra']} tetrahedra, angle >= {figures['min_angle']:.1f}, ratio >= "
          f"{figures['min_ratio']:.2f}, mean {figures['mean_ratio']:.3f}, triangles {figures['min_triangle']:.0f} .. "
          f"{figures['max_triangle']:.0f}: {chosen}", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in SEARCHES:
        sys.exit(__doc__)
    draws, seed = [int(word) for word in (sys.argv[2:] + ["1000", "1"][len(sys.argv) - 2:])[:2]]
    search(sys.argv[1], draws, seed)
