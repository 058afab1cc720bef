#!/usr/bin/env python3
"""Counts and element quality of Gmsh MSH 4.1 ASCII files, one line each: measure_mesh.py FILE...

Written apart from the simulator's own reader, so that each checks the other. Standard library only.
free: nodes on the boundary of the volume that are not in the group "fixed".
ratio: 3 r_in / r_circum, 1 for a regular tetrahedron.  angle: between two faces of one tetrahedron [degree].
"""
import math
import sys
from collections import Counter
from itertools import combinations


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def norm(a):
    return math.sqrt(dot(a, a))


def read(path):
    """Nodes {tag: (x, y, z)}, elements [(dimension, group name, node tags)]."""
    lines = iter(open(path).read().split("\n"))
    sections = {}
    for line in lines:
        if line.startswith("$") and not line.startswith("$End"):
            body = []
            for inner in lines:
                if inner == "$End" + line[1:]:
                    break
                body.append(inner.split())
            sections[line[1:]] = body
    if sections["MeshFormat"][0][0] != "4.1":
        sys.exit(f"{path}: not MSH 4.1 ASCII")
    names = {}
    for dimension, tag, *name in sections["PhysicalNames"][1:]:
        names[int(dimension), int(tag)] = " ".join(name).strip('"')
    entities = iter(sections["Entities"])
    group = {}
    for dimension, count in enumerate(map(int, next(entities))):
        for _ in range(count):
            row = next(entities)
            at = 4 if dimension == 0 else 7
            tags = [int(t) for t in row[at + 1:at + 1 + int(row[at])]]
            group[dimension, int(row[0])] = [names[dimension, t] for t in tags]
    nodes = {}
    rows = iter(sections["Nodes"])
    for _ in range(int(next(rows)[0])):
        count = int(next(rows)[3])
        tags = [int(next(rows)[0]) for _ in range(count)]
        for tag in tags:
            nodes[tag] = tuple(float(v) for v in next(rows)[:3])
    elements = []
    rows = iter(sections["Elements"])
    for _ in range(int(next(rows)[0])):
        dimension, entity, _, count = map(int, next(rows))
        for _ in range(count):
            elements.append((dimension, group[dimension, entity], [int(t) for t in next(rows)[1:]]))
    return nodes, elements


def angles(p):
    """The six angles between the faces of a tetrahedron [degree]."""
    for i, j in combinations(range(4), 2):
        k, l = (m for m in range(4) if m not in (i, j))
        edge = sub(p[j], p[i])
        a, b = cross(edge, sub(p[k], p[i])), cross(edge, sub(p[l], p[i]))
        yield math.degrees(math.atan2(norm(cross(a, b)), dot(a, b)))


def radius_ratio(p):
    a, b, c = sub(p[1], p[0]), sub(p[2], p[0]), sub(p[3], p[0])
    volume6 = dot(a, cross(b, c))
    area2 = norm(cross(a, b)) + norm(cross(b, c)) + norm(cross(c, a)) + norm(cross(sub(b, a), sub(c, a)))
    centre = [dot(a, a) * x + dot(b, b) * y + dot(c, c) * z
              for x, y, z in zip(cross(b, c), cross(c, a), cross(a, b))]
    return 3 * (abs(volume6) / area2) / (norm(centre) / abs(2 * volume6)), volume6 / 6


def triangle_angles(p):
    for i in range(3):
        a, b = sub(p[(i + 1) % 3], p[i]), sub(p[(i + 2) % 3], p[i])
        yield math.degrees(math.atan2(norm(cross(a, b)), dot(a, b)))


def measure(path):
    nodes, elements = read(path)
    tets = [t for dimension, _, t in elements if dimension == 3]
    groups = {}
    for dimension, names, tags in elements:
        for name in names:
            groups.setdefault(name, set()).update(tags)
    faces = Counter(frozenset(f) for t in tets for f in combinations(t, 3))
    boundary = [tuple(f) for f, times in faces.items() if times == 1]
    surface = {n for f in boundary for n in f}
    used = {n for t in tets for n in t}
    points = [[nodes[n] for n in t] for t in tets]
    ratio, volume = zip(*(radius_ratio(p) for p in points))
    angle = [a for p in points for a in angles(p)]
    flat = [a for f in boundary for a in triangle_angles([nodes[n] for n in f])]
    fixed, contact = groups.get("fixed", set()), groups.get("contact", set())
    return {
        "nodes": len(used), "orphans": len(nodes) - len(used), "surface": len(surface),
        "free": len(surface - fixed), "tetrahedra": len(tets), "fixed": len(fixed), "contact": len(contact),
        "shared": len(fixed & contact), "volume": sum(volume), "inverted": sum(v <= 0 for v in volume),
        "min_angle": min(angle), "max_angle": max(angle), "min_ratio": min(ratio),
        "mean_ratio": sum(ratio) / len(ratio), "min_triangle": min(flat), "max_triangle": max(flat),
    }


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for path in sys.argv[1:]:
        m = measure(path)
        print(f"{path}: " + " ".join(f"{k}={v:.4g}" if isinstance(v, float) else f"{k}={v}"
                                     for k, v in m.items()))
