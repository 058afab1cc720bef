"""palpate as its user runs it: a scene file, `palpate press SCENE --format json --save STATE`, the files it wrote."""
import dataclasses
import json
import os
import pathlib
import resource
import subprocess
import sys
import xml.etree.ElementTree

import numpy as np


@dataclasses.dataclass
class Pressed:
    force: np.ndarray  # of the first probe on its body (3): the opposite of what the hand feels [N]
    active: int  # closed contacts
    displacement: dict  # body: (n x 3) [m]
    nodal_force: dict  # body: what acts on each node from outside, without supports (n x 3) [N]
    cycle: float  # of the last cycle [s]
    preparation: float  # processor time of the whole command, but for that cycle [s]


def _point_data(file, mesh):
    """Arrays of a VTU file in text, whose nodes must be those of the mesh."""
    piece = xml.etree.ElementTree.parse(file).getroot().find(".//Piece")
    points = np.array(piece.find("Points/DataArray").text.split(), float).reshape(-1, 3)
    assert (points == mesh.nodes).all(), f"{file}: nodes are not those of the mesh"
    return {array.get("Name"): np.array(array.text.split(), float).reshape(len(points), -1)
            for array in piece.findall("PointData/DataArray")}


def _processor_time():
    """Of all programs that this one has run [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def press(palpate, scene, meshes, save=True):
    """@param meshes  of each body, where the scene puts it, to check that results are in its order"""
    state = pathlib.Path(scene).with_suffix("")
    command = [palpate, "press", scene, "--steps", "1", "--format", "json"] + (["--save", state] if save else [])
    # Nothing is taken from what an earlier run has prepared.
    before = _processor_time()
    done = subprocess.run(command, capture_output=True, text=True,
                          env=os.environ | {"PALPATE_CACHE": str(state.parent / "cache")})
    used = _processor_time() - before
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}")
    step = json.loads(done.stdout)["curve"][-1]
    fields = {body: _point_data(f"{state}.{body}.vtu", mesh) for body, mesh in meshes.items()} if save else {}
    return Pressed(force=-np.array(step["force"]), active=sum(pair["active"] for pair in step["pairs"]),
                   displacement={body: arrays["displacement"] for body, arrays in fields.items()},
                   nodal_force={body: arrays["force"] for body, arrays in fields.items()},
                   cycle=1e-6 * step["cycle_us"], preparation=used - 1e-6 * step["cycle_us"])
