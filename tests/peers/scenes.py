"""The scenes that palpate and its peers solve, and the scene files of them."""
import dataclasses
import pathlib

import numpy as np

import mesh as meshes

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"


@dataclasses.dataclass
class Body:
    mesh: meshes.Mesh  # with the groups `fixed` (may be empty), `touchable`, and what the probe holds
    modulus: float  # E [Pa]
    poisson: float  # nu [-]


@dataclasses.dataclass
class Scene:
    bodies: dict  # name: Body; the probe is on the first
    probe: str  # TOML: its kind and what it holds
    moved: np.ndarray  # nodes of the first body that the probe moves
    direction: np.ndarray
    depth: float  # [m]
    pairing: str = ""  # of the contact of both bodies

    def prescribed(self):
        """Of each body: the nodes that are held or moved, and their displacement (k x 3) [m]."""
        held = {name: body.mesh.groups.get("fixed", np.array([], int)) for name, body in self.bodies.items()}
        result = {name: (nodes, np.zeros((len(nodes), 3))) for name, nodes in held.items()}
        first = next(iter(self.bodies))
        by = self.depth * self.direction / np.linalg.norm(self.direction)
        result[first] = (np.concatenate([held[first], self.moved]),
                         np.concatenate([np.zeros((len(held[first]), 3)), np.tile(by, (len(self.moved), 1))]))
        return result

    def write(self, folder):
        """The scene file, with its meshes beside it."""
        lines = ['name = "peers"']
        for name, body in self.bodies.items():
            meshes.write_msh(pathlib.Path(folder) / f"{name}.msh", body.mesh)
            lines += [f"[bodies.{name}]", f'mesh = "{name}.msh"', 'length_unit = "m"',
                      f'young_modulus = "{body.modulus!r} Pa"', f"poisson_ratio = {body.poisson!r}"]
            lines += [f'{key} = "{key}"' for key in ("fixed", "touchable") if key in body.mesh.groups]
        if self.pairing:
            lines += ["[contact]", f"touch = [{list(self.bodies)}]", 'model = "exact"', f'pairing = "{self.pairing}"']
        lines += ["[probes.finger]", f'body = "{next(iter(self.bodies))}"', self.probe,
                  f"direction = {self.direction.tolist()}", f'depth = "{self.depth!r} m"']
        file = pathlib.Path(folder) / "scene.toml"
        file.write_text("\n".join(lines) + "\n")
        return file

    def meshes(self):
        return {name: body.mesh for name, body in self.bodies.items()}


def region_on_block():
    """A block on its bottom; a disc of its top is moved as one, aslant."""
    block = meshes.grid([-30e-3, -30e-3, -40e-3], [30e-3, 30e-3, 0], [8, 8, 6])
    block.add_group("fixed", lambda x, y, z: z < -40e-3 + 1e-9)
    block.add_group("disc", lambda x, y, z: (z > -1e-9) & (np.hypot(x, y) < 12e-3))
    return Scene({"block": Body(block, 20e3, 0.30)}, 'kind = "region"\ngroup = "disc"', block.groups["disc"],
                 np.array([0.3, -0.2, -1.0]), 3e-3)


def point_on_prostate():
    """The committed prostate, held where it is held in the shipped scene; a point of its lower face is pushed."""
    prostate = meshes.read_msh(DATA / "meshes" / "prostate.msh")
    groups = prostate.groups
    prostate.groups = {"fixed": groups["fixed"], "touchable": groups["contact"]}
    inner = np.setdiff1d(groups["contact"], groups["fixed"])
    node = inner[np.argmin(prostate.nodes[inner, 2])]
    return Scene({"prostate": Body(prostate, 1e6, 0.40)}, f'kind = "point"\nnode = {node + 1}', np.array([node]),
                 np.array([0.1, 0.2, 1.0]), 5e-3)


RADIUS, GAP = 20e-3, 0.1e-3  # of the sphere, and between it and the box at rest [m]


def sphere_on_box(folder, edge, pairing, depth):
    """A sphere whose cap a probe moves down onto a box on its bottom: both 1 MPa, nu 0.40, no friction."""
    size = f"\nMesh.MeshSizeMin = {edge};\nMesh.MeshSizeMax = {edge};"
    box = meshes.made_by_gmsh(folder, "Box(1) = {-25e-3, -25e-3, -30e-3, 50e-3, 50e-3, 30e-3};" + size)
    sphere = meshes.made_by_gmsh(folder, f"Sphere(1) = {{0, 0, {RADIUS + GAP}, {RADIUS}}};" + size)
    near = 15e-3  # from the axis, within which surfaces can touch [m]
    box.add_group("fixed", lambda x, y, z: z < -30e-3 + 1e-9)
    box.add_group("touchable", lambda x, y, z: (z > -1e-9) & (np.hypot(x, y) < near))
    from_middle = np.linalg.norm(sphere.nodes - [0, 0, RADIUS + GAP], axis=1)
    surface = np.abs(from_middle - RADIUS) < 1e-6
    sphere.add_group("cap", lambda x, y, z: surface & (z > RADIUS + 12e-3))
    sphere.add_group("touchable", lambda x, y, z: surface & (z < RADIUS) & (np.hypot(x, y) < near))
    return Scene({"sphere": Body(sphere, 1e6, 0.40), "box": Body(box, 1e6, 0.40)},
                 'kind = "region"\ngroup = "cap"', sphere.groups["cap"], np.array([0.0, 0.0, -1.0]), depth, pairing)


def lame(body):
    """Lame's constants lambda and mu [Pa]. Source: [Zienkiewicz2013] ch. 6."""
    return (body.modulus * body.poisson / ((1 + body.poisson) * (1 - 2 * body.poisson)),
            body.modulus / (2 * (1 + body.poisson)))
