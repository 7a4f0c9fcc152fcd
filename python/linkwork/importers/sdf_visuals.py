"""The visual geometry of SDF as shapes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from linkwork.errors import ModelError
from linkwork.importers.robot_file import Texts
from linkwork.importers.visuals import GRAY, Visuals, capsule, ellipsoid, hex_of, numbers
from linkwork.importers.xml_text import Node
from linkwork.modeling.shapes import Box, Cylinder, Shape, Sphere

__all__ = ["shapes_of"]

#: Thickness of a plane, in its size.
THIN = 1e-3

#: By tag, from the texts of the children and a color; the defaults are those of the format.
SOLIDS: Mapping[str, Callable[[Texts, str], Sequence[Shape]]] = {
    "box": lambda texts, color: [Box(numbers(texts("size"), 3, "box size", [1.0] * 3), color=color)],
    "sphere": lambda texts, color: [Sphere(_one(texts, "sphere", "radius", 1.0), color=color)],
    "cylinder": lambda texts, color: [
        Cylinder(_one(texts, "cylinder", "radius", 1.0), _one(texts, "cylinder", "length", 1.0), color=color)
    ],
    "capsule": lambda texts, color: capsule(
        _one(texts, "capsule", "radius", 0.5), _one(texts, "capsule", "length", 1.0), color
    ),
    "ellipsoid": lambda texts, color: ellipsoid(
        numbers(texts("radii"), 3, "ellipsoid radii", [1.0] * 3), color
    ),
    "plane": lambda texts, color: _plane(texts, color),
    "empty": lambda texts, color: [],
}


def shapes_of(visuals: Visuals, visual: Node) -> Sequence[Shape]:
    """Of one <visual>, in its frame. ModelError, FileError: it cannot be drawn."""
    if float(numbers(visual.word("transparency"), 1, "transparency", [0.0])[0]) >= 1:
        return []
    color = _color(visual.one("material"))
    geometry = visual.one("geometry")
    for node in geometry.children if geometry is not None else ():
        if node.tag == "mesh":
            scale = numbers(node.word("scale"), 3, "mesh scale", [1.0] * 3)
            return visuals.mesh(node.word("uri") or "", scale, color)
        if node.tag in SOLIDS:
            return SOLIDS[node.tag](node.word, color or GRAY)
    known = ", ".join(("mesh", *SOLIDS))
    raise ModelError(f"there is none of {known}", code="shape")


def _one(texts: Texts, kind: str, what: str, default: float) -> float:
    return numbers(texts(what), 1, f"{kind} {what}", [default])[0]


def _plane(texts: Texts, color: str) -> Sequence[Shape]:
    """A thin plate, its upper side in the plane."""
    x, y = numbers(texts("size"), 2, "plane size", [1.0] * 2)
    normal = np.array(numbers(texts("normal"), 3, "plane normal", [0.0, 0.0, 1.0]))
    thick = THIN * max(x, y)
    plate = Cylinder(
        1.0, 1.0, axis=normal
    )  # refuses a normal of no direction; its axes are those of the plate
    middle = -thick / 2 * normal / np.linalg.norm(normal)
    return [Box((x, y, thick), position=middle, orientation=plate.orientation, color=color)]


def _color(material: Node | None) -> str | None:
    """The diffuse one, or the ambient one."""
    for tag in ("diffuse", "ambient"):
        text = material.word(tag) if material is not None else None
        if text:
            return hex_of(numbers(text, len(text.split()) if len(text.split()) in (3, 4) else 4, tag))
    return None
