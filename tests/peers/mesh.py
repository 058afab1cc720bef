"""Meshes of the comparisons: tetrahedra, read from Gmsh's MSH 4.1, made by Gmsh or as a grid, written as MSH 2.2.

Nothing here is palpate's: what another program is given comes from the same file that palpate reads.
"""
import dataclasses
import pathlib
import subprocess
import sys

import numpy as np

GMSH_NODES = {15: 1, 1: 2, 2: 3, 4: 4}  # Gmsh's element types: point, line, triangle, tetrahedron; nodes of each


@dataclasses.dataclass
class Mesh:
    nodes: np.ndarray  # (n x 3) [m]
    tetrahedra: np.ndarray  # (m x 4), places in nodes
    groups: dict = dataclasses.field(default_factory=dict)  # name: ascending places in nodes

    def add_group(self, name, belongs):
        """The nodes at which belongs(x, y, z), on arrays, is true."""
        self.groups[name] = np.flatnonzero(belongs(*self.nodes.T))

    def boundary(self):
        """Triangles of one tetrahedron only (k x 3), anticlockwise from outside."""
        a, b, c, d = self.tetrahedra.T
        faces = np.concatenate([np.stack(f, 1) for f in ((a, c, b), (a, b, d), (b, c, d), (a, d, c))])
        _, first, count = np.unique(np.sort(faces, 1), axis=0, return_index=True, return_counts=True)
        return faces[np.sort(first[count == 1])]


def oriented(nodes, tetrahedra):
    """The same tetrahedra, each with a volume > 0."""
    a, b, c, d = (nodes[tetrahedra[:, k]] for k in range(4))
    turned = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) < 0
    tetrahedra = tetrahedra.copy()
    tetrahedra[turned] = tetrahedra[turned][:, [0, 1, 3, 2]]
    return tetrahedra


def grid(lower, upper, cells):
    """A box of cells, six tetrahedra each, which match across cells (Kuhn's division)."""
    ticks = [np.linspace(a, b, n + 1) for a, b, n in zip(lower, upper, cells)]
    nodes = np.stack(np.meshgrid(*ticks, indexing="ij"), -1).reshape(-1, 3)
    number = np.arange(len(nodes)).reshape([n + 1 for n in cells])
    tetrahedra = []
    for order in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
        corner, corners = [0, 0, 0], []
        for axis in (None, *order):
            if axis is not None:
                corner[axis] = 1
            corners.append(number[tuple(slice(c, n + c) for c, n in zip(corner, cells))].ravel())
        tetrahedra.append(np.stack(corners, 1))
    return Mesh(nodes, oriented(nodes, np.concatenate(tetrahedra)))


def mirrored(mesh, axis):
    """The mesh and its mirror image on the plane of its nodes of least x, y or z, as one."""
    image, least = mesh.nodes.copy(), mesh.nodes[:, axis].min()
    image[:, axis] = 2 * least - image[:, axis]
    new = np.flatnonzero(mesh.nodes[:, axis] > least)
    place = np.arange(len(image))
    place[new] = len(image) + np.arange(len(new))
    nodes = np.concatenate([mesh.nodes, image[new]])
    return Mesh(nodes, oriented(nodes, np.concatenate([mesh.tetrahedra, place[mesh.tetrahedra]])))


def _sections(text):
    """Lines of each $Section."""
    sections, lines = {}, iter(text.splitlines())
    for line in lines:
        if line.startswith("$"):
            name, end = line[1:].strip(), "$End" + line[1:].strip()
            sections[name] = [inside for inside in iter(lambda: next(lines).strip(), end)]
    return sections


def read_msh(file):
    """Nodes, tetrahedra and the nodes of physical groups of an MSH 4.1 file in text."""
    section = _sections(pathlib.Path(file).read_text())
    assert section["MeshFormat"][0].startswith("4.1 0"), file
    names = {}
    for line in section.get("PhysicalNames", ["0"])[1:]:
        dimension, tag, name = line.split(maxsplit=2)
        names[int(dimension), int(tag)] = name.strip('"')
    physicals = {}  # (dimension, entity): names
    lines = iter(section["Entities"])
    for dimension, count in enumerate(map(int, next(lines).split())):
        for _ in range(count):
            words = next(lines).split()
            entity, tags = int(words[0]), words[4 if dimension == 0 else 7:]  # a point has one place, others a box
            physicals[dimension, entity] = [names.get((dimension, int(tag)), tag) for tag in tags[1:1 + int(tags[0])]]
    lines, place, nodes = iter(section["Nodes"]), {}, []
    for _ in range(int(next(lines).split()[0])):
        count = int(next(lines).split()[3])
        for _ in range(count):
            place[int(next(lines))] = len(place)
        nodes += [[float(x) for x in next(lines).split()] for _ in range(count)]
    lines, tetrahedra, groups = iter(section["Elements"]), [], {}
    for _ in range(int(next(lines).split()[0])):
        dimension, entity, kind, count = map(int, next(lines).split())
        elements = [[place[int(n)] for n in next(lines).split()[1:1 + GMSH_NODES[kind]]] for _ in range(count)]
        tetrahedra += elements if kind == 4 else []
        for name in physicals[dimension, entity]:
            groups.setdefault(name, set()).update(n for element in elements for n in element)
    mesh = Mesh(np.array(nodes), np.array(tetrahedra), {name: np.array(sorted(g)) for name, g in groups.items()})
    assert (oriented(mesh.nodes, mesh.tetrahedra) == mesh.tetrahedra).all(), file
    return mesh


def write_msh(file, mesh):
    """MSH 2.2 in text. MSH has no groups of nodes: each node of a group is a point element of its physical group."""
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(mesh.groups))]
    lines += [f'0 {tag} "{name}"' for tag, name in enumerate(mesh.groups, 1)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(mesh.nodes))]
    lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(mesh.nodes.tolist(), 1)]
    elements = [f"15 2 {tag} {tag} {node + 1}" for tag, group in enumerate(mesh.groups.values(), 1)
                for node in group.tolist()]
    elements += ["4 2 0 1 " + " ".join(str(n + 1) for n in t) for t in mesh.tetrahedra.tolist()]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i} {element}" for i, element in enumerate(elements, 1)] + ["$EndElements", ""]
    pathlib.Path(file).write_text("\n".join(lines))


def made_by_gmsh(folder, geometry):
    """The mesh of a geometry in Gmsh's language. What is no volume is left out."""
    geo, msh = pathlib.Path(folder) / "body.geo", pathlib.Path(folder) / "body.msh"
    geo.write_text('SetFactory("OpenCASCADE");\n' + geometry + "\nMesh.MshFileVersion = 4.1;\n")
    done = subprocess.run(["gmsh", geo, "-3", "-nt", "1", "-v", "1", "-o", msh], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"gmsh {geo}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    mesh = read_msh(msh)
    used = np.unique(mesh.tetrahedra)
    place = np.full(len(mesh.nodes), -1)
    place[used] = np.arange(len(used))
    return Mesh(mesh.nodes[used], oriented(mesh.nodes[used], place[mesh.tetrahedra]))
