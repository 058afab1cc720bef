#!/usr/bin/env python3
"""Who may know whom, read from the includes (C++) and imports (TypeScript) of the tree: tests/layers/CMakeLists.txt.

  arrows.py TREE    exit code 1 names every forbidden arrow between modules and every circle of folders in a module

A module may include what MAY_KNOW lists and no more, and the folders of a module form no circle. The compiler refuses a
forbidden module too; this finds circles, which it does not, and says where each arrow is.
"""
import os
import pathlib
import re
import sys

MAY_KNOW = {
    "base": set(),
    "sim": {"base"},
    "trials": {"base", "sim"},
    "analysis": {"base"},
    "tasks": {"base", "sim", "trials", "analysis"},
    "devices": {"base", "sim"},
    "app": {"base", "sim", "trials", "analysis", "tasks", "devices"},
}
INCLUDE = re.compile(r'\s*#\s*include\s+"([^"]+)"')
IMPORT = re.compile(r'\s*(?:import|export)\b.*?\bfrom\s+"(\.[^"]+)"')


def arrows_of(tree):
    """{(folder, folder): [(file, line), ...]} over the folders of all modules."""
    found = {}
    for module in sorted(MAY_KNOW):
        for file in sorted((tree / module).rglob("*")):
            if file.suffix not in (".cpp", ".hpp", ".ts"):
                continue
            for number, line in enumerate(file.read_text("utf-8").splitlines(), 1):
                there = target(tree, file, line)
                here = file.parent.relative_to(tree).as_posix()
                if there is not None and there != here:
                    found.setdefault((here, there), []).append((file.relative_to(tree).as_posix(), number))
    return found


def target(tree, file, line):
    """The folder that a line includes or imports something of, from the tree's root; nothing for other lines."""
    if file.suffix == ".ts":
        match = IMPORT.match(line)
        if not match:
            return None
        place = pathlib.PurePosixPath(os.path.normpath(file.parent / match.group(1)))
        return place.parent.relative_to(tree).as_posix()
    match = INCLUDE.match(line)
    if not match or not (tree / match.group(1)).exists():  # made by the build, or a library's
        return None
    return pathlib.PurePosixPath(match.group(1)).parent.as_posix()


def module_of(folder):
    return folder.split("/")[0]


def forbidden(arrows):
    return [(here, there) for here, there in sorted(arrows)
            if module_of(here) != module_of(there) and module_of(there) not in MAY_KNOW[module_of(here)]]


def circles(arrows):
    """Folders of one module that can all be reached from each other, each circle once (Tarjan 1972)."""
    graph = {}
    for here, there in arrows:
        if module_of(here) == module_of(there):
            graph.setdefault(here, set()).add(there)
            graph.setdefault(there, set())
    order, lowest, stack, on_stack, found = {}, {}, [], set(), []

    def visit(folder):
        order[folder] = lowest[folder] = len(order)
        stack.append(folder)
        on_stack.add(folder)
        for next_folder in sorted(graph[folder]):
            if next_folder not in order:
                visit(next_folder)
                lowest[folder] = min(lowest[folder], lowest[next_folder])
            elif next_folder in on_stack:
                lowest[folder] = min(lowest[folder], order[next_folder])
        if lowest[folder] == order[folder]:
            circle = []
            while not circle or circle[-1] != folder:
                circle.append(stack.pop())
                on_stack.discard(circle[-1])
            if len(circle) > 1:
                found.append(sorted(circle))

    for folder in sorted(graph):
        if folder not in order:
            visit(folder)
    return found


def told(arrows, pairs):
    return [f"  {here} -> {there}   {file}:{line}" for here, there in pairs for file, line in arrows[here, there][:3]]


def faults(tree):
    """What is wrong, a line each; none where all arrows point down."""
    arrows = arrows_of(tree)
    lines = []
    for here, there in forbidden(arrows):
        allowed = ", ".join(sorted(MAY_KNOW[module_of(here)])) or "nobody"
        lines.append(f"{module_of(here)} may not know {module_of(there)} (it may know {allowed}):")
        lines += told(arrows, [(here, there)])
    for circle in circles(arrows):
        lines.append("these folders stand in one circle; an interface belongs below those who share it: " + ", ".join(circle))
        lines += told(arrows, [pair for pair in sorted(arrows) if pair[0] in circle and pair[1] in circle])
    return lines


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = faults(pathlib.Path(sys.argv[1]).resolve())
    print("\n".join(found) if found else "every arrow points down")
    sys.exit(1 if found else 0)
