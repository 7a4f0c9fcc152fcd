"""The shapes of bodies in a result file: a JSON description, and the arrays of meshes beside it.

/model/shapes/description   [{"bodies": [first, count], "shapes": [{"kind": "box", ...}, ...]}, ...]
/model/shapes/0, 1, ...     vertices (n, 3) and triangles (m, 3) of the meshes, by their place in a list
"""

from __future__ import annotations

import json
from typing import Any

import h5py

from linkwork.modeling.shapes import Mesh, Shape, Shapes


def write_shapes(model: h5py.Group, shapes: Shapes) -> None:
    """To the group /model; a mesh that several bodies share is written once."""
    if not len(shapes):
        return
    group = model.create_group("shapes")
    written: dict[int, int] = {}
    groups = [
        {
            "bodies": [bodies.start, len(bodies)],
            "shapes": [_described(group, shape, written) for shape in several],
        }
        for bodies, several in shapes
    ]
    group["description"] = json.dumps(groups)


def read_shapes(model: h5py.Group) -> Shapes:
    """From the group /model; files of earlier versions have none."""
    if "shapes" not in model:
        return Shapes()
    group = model["shapes"]
    read: dict[int, dict[str, Any]] = {}
    return Shapes(
        (
            range(found["bodies"][0], found["bodies"][0] + found["bodies"][1]),
            tuple(_shape(group, description, read) for description in found["shapes"]),
        )
        for found in json.loads(group["description"].asstr()[()])
    )


def _described(group: h5py.Group, shape: Shape, written: dict[int, int]) -> dict[str, Any]:
    if not isinstance(shape, Mesh):
        return shape.description()
    place = written.setdefault(id(shape.vertices), len(written))
    if str(place) not in group:
        for name, array in shape.dimensions().items():
            group[f"{place}/{name}"] = array
    rest = {name: value for name, value in shape.description().items() if name not in shape.dimensions()}
    return rest | {"mesh": place}


def _shape(group: h5py.Group, description: dict[str, Any], read: dict[int, dict[str, Any]]) -> Shape:
    place = description.pop("mesh", None)
    if place is None:
        return Shape.of(description)
    if place not in read:
        read[place] = {name: group[f"{place}/{name}"][()] for name in ("vertices", "triangles")}
    return Shape.of(description | read[place])
