"""GetFEM on a scene: its mesh and elements, its stiffness, its Newton solver, contact by an augmented Lagrangian."""
import time

import getfem
import numpy as np

import pairing
import scenes

# Augmentation parameter [N/m], about what a node of the scene's meshes gives way by, E times an edge: it changes
# Newton's way, not the solution. With 1e8 Newton stops with a contact that pulls, and calls it converged.
AUGMENTATION = 5e3
RESIDUAL = 1e-9  # at which Newton stops, as a part of the forces [-]
MOST_ITERATIONS = 100


class Problem:
    """All bodies of a scene as one mesh of GetFEM with linear elements; body i is its region i + 1."""

    def __init__(self, scene):
        self.mesh, self.dofs = getfem.Mesh("empty", 3), {}
        geometry = getfem.GeoTrans("GT_PK(3, 1)")
        for region, body in enumerate(scene.bodies.values(), 1):
            points = body.mesh.nodes[body.mesh.tetrahedra].transpose(2, 1, 0)  # 3 x corners x tetrahedra
            convexes = self.mesh.add_convex(geometry, points)
            self.mesh.set_region(region, np.stack([convexes, np.full(len(convexes), -1)]))
        self.fem = getfem.MeshFem(self.mesh, 3)
        self.fem.set_fem(getfem.Fem("FEM_PK(3, 1)"))
        self.integration = getfem.MeshIm(self.mesh, getfem.Integ("IM_TETRAHEDRON(1)"))
        first = self.fem.basic_dof_nodes()[:, ::3]  # the place of the first of three unknowns of each node
        number = {tuple(place): 3 * i for i, place in enumerate(first.T.tolist())}
        for name, body in scene.bodies.items():
            self.dofs[name] = np.array([number[tuple(place)] for place in body.mesh.nodes.tolist()])
        assert self.fem.nbdof() == 3 * sum(len(d) for d in self.dofs.values()), "nodes of the bodies coincide"

    def vectors(self, values, name):
        """Of each node of a body (n x 3)."""
        return np.asarray(values)[self.dofs[name][:, None] + np.arange(3)]


def _elasticity(problem, scene):
    model = getfem.Model("real")
    model.add_fem_variable("u", problem.fem)
    for region, body in enumerate(scene.bodies.values(), 1):
        names = [f"lambda{region}", f"mu{region}"]
        for name, value in zip(names, scenes.lame(body)):
            model.add_initialized_data(name, [value])
        model.add_isotropic_linearized_elasticity_brick(problem.integration, "u", *names, region)
    model.assembly("build_matrix")
    return model, model.tangent_matrix()


def _prescribe(model, problem, scene):
    rows = [(dof + k, value[k]) for name, (nodes, values) in scene.prescribed().items()
            for dof, value in zip(problem.dofs[name][nodes], values) for k in range(3)]
    matrix = getfem.Spmat("empty", len(rows), problem.fem.nbdof())
    for row, (dof, _) in enumerate(rows):
        matrix.add(row, int(dof), 1.0)
    model.add_variable("held", len(rows))
    model.add_constraint_with_multipliers("u", "held", matrix, [value for _, value in rows])


def contact_rows(scene):
    """(body of the nodes, body of the surface, row) of every contact condition."""
    first, second = scene.bodies
    sides = [(first, second), (second, first)] if scene.pairing == "both" else [
        (a, b) for a, b in ((first, second), (second, first)) if scene.pairing == f"nodes of {a}"]
    return [(a, b, row) for a, b in sides
            for row in pairing.facing_rows(scene.bodies[a].mesh, scene.bodies[b].mesh)]


def _let_touch(model, problem, rows):
    """BN u <= gap: a node comes no nearer to the place that it faces than their gap at rest."""
    normals = getfem.Spmat("empty", len(rows), problem.fem.nbdof())
    for i, (nodes_of, surface_of, row) in enumerate(rows):
        for k in range(3):
            normals.add(i, int(problem.dofs[nodes_of][row.node] + k), -row.normal[k])
            for corner, weight in zip(row.corners, row.weights):
                normals.add(i, int(problem.dofs[surface_of][corner] + k), weight * row.normal[k])
    model.add_variable("pressure", len(rows))
    model.add_initialized_data("r", [AUGMENTATION])
    model.add_initialized_data("gap", [row.gap for _, _, row in rows])
    model.add_basic_contact_brick("u", "pressure", "r", normals, "gap")


def _face_region(problem, body, region):
    """Makes the touchable triangles of a body, with their tetrahedra, a region of GetFEM's mesh."""
    number = {tuple(place): i for i, place in enumerate(body.mesh.nodes.tolist())}
    touchable = {tuple(sorted(triangle)) for triangle in pairing.touchable_triangles(body.mesh).tolist()}
    faces = []
    for convex, face in problem.mesh.outer_faces().T.tolist():
        corners = problem.mesh.pts(problem.mesh.pid_in_faces([[convex], [face]])).T.tolist()
        if tuple(sorted(number.get(tuple(corner), -1) for corner in corners)) in touchable:
            faces.append((convex, face))
    problem.mesh.set_region(region, np.array(faces).T)


def _let_touch_by_own_pairing(model, problem, scene):
    """The same contact, but GetFEM finds what each node faces, by its own rules."""
    regions = [len(scene.bodies) + 1, len(scene.bodies) + 2]
    for region, body in zip(regions, scene.bodies.values()):
        _face_region(problem, body, region)
    of_nodes = [int(scene.pairing in ("both", f"nodes of {name}")) for name in scene.bodies]
    model.add_initialized_data("r", [AUGMENTATION])
    model.add_nodal_contact_between_nonmatching_meshes_brick(problem.integration, "u", "pressure", "r", *regions,
                                                             *of_nodes)


def solve(scene, own_pairing=False):
    """@param own_pairing  GetFEM finds what faces what, and not the conditions of contact_rows
    @return displacement and K u of every node of each body (n x 3), and the seconds that the solver took"""
    problem = Problem(scene)
    model, stiffness = _elasticity(problem, scene)
    _prescribe(model, problem, scene)
    if scene.pairing and own_pairing:
        _let_touch_by_own_pairing(model, problem, scene)
    elif scene.pairing:
        _let_touch(model, problem, contact_rows(scene))
    begun = time.monotonic()
    iterations, converged = model.solve("max_res", RESIDUAL, "max_iter", MOST_ITERATIONS, "lsolver", "mumps")
    seconds = time.monotonic() - begun
    assert converged, f"GetFEM's Newton has not converged in {iterations} steps"
    if scene.pairing:
        pull = model.variable("pressure")  # < 0 where a contact pushes
        assert pull.max() < 1e-9 * -pull.min(), "GetFEM's Newton has stopped with a contact that pulls"
    u = model.variable("u")
    forces = stiffness.mult(u)
    return ({name: problem.vectors(u, name) for name in scene.bodies},
            {name: problem.vectors(forces, name) for name in scene.bodies}, seconds)
