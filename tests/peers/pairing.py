"""What each node of one body faces on the surface of another at rest, as docs/method.md defines it for `exact`, made
from meshes and groups alone: every node is measured against every triangle.
"""
import dataclasses

import numpy as np

ON_EDGE = 1e-12  # a corner's weight below which the nearest place is on the edge opposite [-]


@dataclasses.dataclass
class Row:
    """Gap = gap + normal . (u of node - sum of weights times u of corners)."""
    node: int
    corners: np.ndarray  # (3)
    weights: np.ndarray  # (3), sum 1
    normal: np.ndarray  # unit, from the place to the node
    gap: float  # at rest [m]


def touchable_triangles(mesh):
    """Of the boundary, those with three corners that may be touched."""
    boundary = mesh.boundary()
    return boundary[np.isin(boundary, mesh.groups["touchable"]).all(axis=1)]


def _on_segments(place, a, b):
    """Share of b in the nearest places of segments a-b (k x 3 each)."""
    along = b - a
    return np.clip(np.einsum("ij,ij->i", place - a, along) / np.einsum("ij,ij->i", along, along), 0, 1)


def nearest_weights(place, corners):
    """Weights (k x 3) of the place of each triangle (k x 3 x 3) that is nearest: within it where the foot of the
    perpendicular is, else on the nearest of its edges."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = np.cross(b - a, c - a)
    shares = [np.einsum("ij,ij->i", np.cross(q - place, r - place), area) / np.einsum("ij,ij->i", area, area)
              for q, r in ((b, c), (c, a), (a, b))]
    best = np.stack(shares, 1)
    distance = np.where((best >= 0).all(1), np.linalg.norm(np.einsum("ij,ijk->ik", best, corners) - place, axis=1),
                        np.inf)
    for k, (p, q) in enumerate(((0, 1), (1, 2), (2, 0))):
        share = _on_segments(place, corners[:, p], corners[:, q])
        weights = np.zeros_like(best)
        weights[:, p], weights[:, q] = 1 - share, share
        here = np.linalg.norm(np.einsum("ij,ijk->ik", weights, corners) - place, axis=1)
        nearer = here < distance
        best[nearer], distance[nearer] = weights[nearer], here[nearer]
    return best, distance


def outward(mesh, triangles, node):
    """Normal at a node: its triangles' normals, each with its angle there. Source: [Baerentzen2005]."""
    total = np.zeros(3)
    for triangle in triangles[(triangles == node).any(1)]:
        k = triangle.tolist().index(node)
        p, q, r = mesh.nodes[np.roll(triangle, -k)]
        normal = np.cross(q - p, r - p)
        total += np.arctan2(np.linalg.norm(normal), (q - p) @ (r - p)) * normal / np.linalg.norm(normal)
    return total


def rim_edges(triangles):
    """Edges of one triangle only, as pairs in ascending order."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), 1)
    edges, count = np.unique(edges, axis=0, return_counts=True)
    return {tuple(edge) for edge in edges[count == 1].tolist()}


def facing_rows(nodes_of, surface_of):
    """Rows for the touchable nodes of one mesh before the touchable surface of another. Left out: those whose own
    surface looks away, and those that face the rim of the touchable patch. Bodies must stand apart at rest."""
    own, other = touchable_triangles(nodes_of), touchable_triangles(surface_of)
    rim = rim_edges(other)
    rim_nodes = {node for edge in rim for node in edge}
    rows = []
    for node in np.unique(own).tolist():
        place = nodes_of.nodes[node]
        weights, distances = nearest_weights(place, surface_of.nodes[other])
        k = int(np.argmin(distances))
        corners, gap = other[k], distances[k]
        borne = sorted(corners[weights[k] > ON_EDGE].tolist())
        if (len(borne) == 2 and tuple(borne) in rim) or (len(borne) == 1 and borne[0] in rim_nodes):
            continue
        normal = (place - weights[k] @ surface_of.nodes[corners]) / gap
        if outward(nodes_of, own, node) @ normal < 0:
            rows.append(Row(node, corners, weights[k], normal, gap))
    return rows
