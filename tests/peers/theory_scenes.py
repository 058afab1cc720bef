"""Scenes whose force a formula gives, at several fineness of mesh, and the formulas."""
import math

import numpy as np

import mesh as meshes
import scenes

MODULUS = 1e6  # E of all that gives way [Pa]
STIFF = 1e6  # times as stiff is what counts as rigid [-]
CONTACT = 1e-3  # a: radius of the contact [m]
RADIUS = 10 * CONTACT  # of spheres [m]
BLOCK = 400 * CONTACT  # half the width, and the height, of the block that stands for a half-space [m]
DOWN = np.array([0.0, 0.0, -1.0])


def plane_modulus(poisson):
    """E* = E / (1 - nu^2), one side rigid [Pa]."""
    return MODULUS / (1 - poisson**2)


def hertz(radius, depth, poisson):
    """Sphere on a half-space without friction [N]. Source: [Johnson1985] section 4.2."""
    return 4 / 3 * plane_modulus(poisson) * math.sqrt(radius) * depth**1.5


def flat_punch(radius, depth, poisson):
    """Flat end of a rigid cylinder, without friction [N]. Source: [Sneddon1965]."""
    return 2 * radius * plane_modulus(poisson) * depth


def bonded_punch(radius, depth, poisson):
    """The same where the surface sticks [N]. Source: [Spence1968]; at nu = 0.5 it is that without friction."""
    return flat_punch(radius, depth, poisson) * (1 - poisson) * math.log(3 - 4 * poisson) / (1 - 2 * poisson)


def cone(slope, depth, poisson):
    """Cone whose face rises with tan(slope) from the surface, without friction [N]. Source: [Sneddon1965]."""
    return 2 / math.pi * plane_modulus(poisson) * depth**2 / math.tan(slope)


def guided_beam(length, width, thickness, depth, poisson):
    """Beam with one end held and the other moved across without turning: bending and shear [N], shear coefficient
    10 (1 + nu) / (12 + 11 nu). Source: [Cowper1966]."""
    inertia, shear = width * thickness**3 / 12, MODULUS / (2 * (1 + poisson))
    kappa = 10 * (1 + poisson) / (12 + 11 * poisson)
    return depth / (length**3 / (12 * MODULUS * inertia) + length / (kappa * shear * width * thickness))


def graded_block(folder, size, touchable, disc=False):
    """Block below z = 0, held on its bottom, with a node at the origin. @param size  edge of tetrahedra at x, y, z
    @param touchable  radii between which its top may be touched  @param disc  the contact's circle is made of edges"""
    half, a = BLOCK, CONTACT
    middle = (f"Disk(100) = {{0, 0, 0, {a}}};\nBooleanFragments{{ Volume{{1}}; Delete; }}{{ Surface{{100}}; Delete; }}"
              if disc else "Point(100) = {0, 0, 0, 1};\nPoint{100} In Surface {6};")
    block = meshes.made_by_gmsh(folder, f"""Box(1) = {{-{half}, -{half}, -{half}, {2 * half}, {2 * half}, {half}}};
{middle}
Field[1] = MathEval;
Field[1].F = "{size}";
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;""")
    block.add_group("fixed", lambda x, y, z: z < -half * (1 - 1e-9))
    block.add_group("touchable", lambda x, y, z: (z > -1e-9) & (np.hypot(x, y) >= touchable[0])
                    & (np.hypot(x, y) < touchable[1]))
    return block


def fine_within(cells):
    """Edges of 1 / cells contact radii within 1.2 of them from the origin, growing by 2 / cells of the distance
    beyond: strain falls as its square."""
    return f"{CONTACT / cells} + {2 / cells} * max(0, sqrt(x*x + y*y + z*z) - {1.2 * CONTACT})"


def fine_at_rim(cells):
    """Edges of 1 / (2 cells^2) contact radii at the circle that bounds the contact, growing by 0.8 / cells of the
    distance from it. Stress there goes as 1 / sqrt(distance): the energy that linear elements miss goes as the edge at
    the circle, and as the square of the growth."""
    return f"{CONTACT / (2 * cells**2)} + {0.8 / cells} * sqrt((sqrt(x*x + y*y) - {CONTACT})^2 + z*z)"


def indenter(block, within, height):
    """A rigid body over the block's own triangles within a radius, a layer thick, its face at height(r) above the
    block: its nodes stand above the block's, so each faces one of them, straight down."""
    boundary = block.boundary()
    top = (block.nodes[boundary, 2] > -1e-9).all(1)
    near = (np.hypot(block.nodes[boundary, 0], block.nodes[boundary, 1]) < within).all(1)
    nodes, triangles = np.unique(boundary[top & near], return_inverse=True)
    a, b, c = np.sort(triangles.reshape(-1, 3), 1).T
    n = len(nodes)  # of the face; those above it come behind
    face = block.nodes[nodes].copy()
    face[:, 2] = height(np.hypot(face[:, 0], face[:, 1]))
    places = np.concatenate([face, face + [0, 0, 0.3 * CONTACT]])
    prisms = np.concatenate([np.stack(corners, 1) for corners in
                             ((a, b, c, c + n), (a, b, b + n, c + n), (a, a + n, b + n, c + n))])
    return meshes.Mesh(places, meshes.oriented(places, prisms),
                       {"touchable": np.arange(n), "held": np.arange(n, 2 * n)})


def pressed_by(block, poisson, punch, depth):
    bodies = {"punch": scenes.Body(punch, STIFF * MODULUS, 0.3), "block": scenes.Body(block, MODULUS, poisson)}
    return scenes.Scene(bodies, 'kind = "region"\ngroup = "held"', punch.groups["held"], DOWN, depth, "nodes of punch")


# Each: @param cells  how fine: cells across the thickness, or as fine_within and fine_at_rim have it
# @return scene, and its force by the formula [N]

def fingertip(folder, cells):
    poisson, depth = 0.4, CONTACT**2 / RADIUS
    block = graded_block(folder, fine_within(cells), (0, CONTACT))
    scene = scenes.Scene({"block": scenes.Body(block, MODULUS, poisson)},
                         f'kind = "fingertip"\nradius = "{RADIUS!r} m"\nat = ["0 m", "0 m", "0 m"]',
                         np.array([], int), DOWN, depth)
    return scene, hertz(RADIUS, depth, poisson)


def _rounded(folder, cells, poisson, depth, height):
    """A rigid body without edges, whose face is at height(r), pressed down."""
    block = graded_block(folder, fine_within(cells), (0, (1.1 + 2 / cells) * CONTACT))
    return pressed_by(block, poisson, indenter(block, (1.1 + 1 / cells) * CONTACT, height), depth)


def rigid_sphere(folder, cells):
    """A paraboloid, as which Hertz takes a sphere."""
    poisson, depth = 0.4, CONTACT**2 / RADIUS
    scene = _rounded(folder, cells, poisson, depth, lambda r: r**2 / (2 * RADIUS))
    return scene, hertz(RADIUS, depth, poisson)


def rigid_cone(folder, cells):
    poisson, slope = 0.4, math.radians(5)
    depth = math.pi / 2 * CONTACT * math.tan(slope)
    return _rounded(folder, cells, poisson, depth, lambda r: r * math.tan(slope)), cone(slope, depth, poisson)


def smooth_punch(folder, cells):
    poisson, depth = 0.0, 0.05 * CONTACT
    beyond = 1 + 1.5 / cells**2  # three edges: what faces the rim of the touchable patch faces nothing
    block = graded_block(folder, fine_at_rim(cells), (0, beyond * CONTACT), disc=True)
    punch = indenter(block, CONTACT * (1 + 1e-6), lambda r: 0 * r)
    return pressed_by(block, poisson, punch, depth), flat_punch(CONTACT, depth, poisson)


def sticking_punch(folder, cells, poisson):
    depth = 0.05 * CONTACT
    block = graded_block(folder, fine_at_rim(cells), (1.5 * CONTACT, 2 * CONTACT), disc=True)
    block.add_group("disc", lambda x, y, z: (z > -1e-9) & (np.hypot(x, y) < CONTACT * (1 + 1e-6)))
    scene = scenes.Scene({"block": scenes.Body(block, MODULUS, poisson)}, 'kind = "region"\ngroup = "disc"',
                         block.groups["disc"], DOWN, depth)
    return scene, bonded_punch(CONTACT, depth, poisson)


def beam(_, cells):
    length, thickness = 100e-3, 10e-3
    edge = thickness / cells
    mesh = meshes.grid([0, 0, 0], [length, edge, thickness], [10 * cells, 1, cells])
    return _held_at_ends(mesh, 0, length, DOWN, 1e-3), guided_beam(length, edge, thickness, 1e-3, 0.0)


def bar(_, cells):
    """Pulled along its length; with nu = 0 its ends need not contract, and linear elements hold the solution."""
    length, width = 100e-3, 10e-3
    mesh = meshes.grid([0, 0, 0], [width, width, length], [cells, cells, 10 * cells])
    return _held_at_ends(mesh, 2, length, -DOWN, 1e-3), MODULUS * width**2 * 1e-3 / length


def _held_at_ends(mesh, axis, length, direction, depth, poisson=0.0):
    along = mesh.nodes[:, axis]
    mesh.groups = {"fixed": np.flatnonzero(along < 1e-9), "end": np.flatnonzero(along > length - 1e-9),
                   "touchable": np.flatnonzero(np.abs(along - length / 2) < 1e-9)}  # few: nothing touches it
    return scenes.Scene({"body": scenes.Body(mesh, MODULUS, poisson)}, 'kind = "region"\ngroup = "end"',
                        mesh.groups["end"], direction, depth)


def contracting_bar(poisson=0.3, cells=2):
    """Fourteen widths long, its ends held as they are: what they do to it dies out towards its middle. Its tetrahedra
    are mirrored on both middle planes: else the ends would bend it a little, and that does not die out."""
    half, length = 5e-3, 140e-3
    quarter = meshes.grid([0, 0, 0], [half, half, length], [cells, cells, 28 * cells])
    return _held_at_ends(meshes.mirrored(meshes.mirrored(quarter, 0), 1), 2, length, -DOWN, 1e-3, poisson)
