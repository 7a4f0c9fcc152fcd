"""How force elements and rolling joints are drawn: springs, dampers, bearings, contacts, gears, discs.

What a kind is follows from the names of its parameters, so that one added to the compiled module is drawn
without a word here. Applied forces, drag, linear damping, friction and stops have no picture.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.modeling.elements import KINDS
from linkwork.modeling.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere
from linkwork.motion.header import Header
from linkwork.motion.violations import Holds, joint_kinds, separations
from linkwork.view import meshes

if TYPE_CHECKING:
    from linkwork.results.result import Result

Role = Literal["joint", "force"]
Form = Literal["bar", "coil", "damper"]

#: More teeth than these, or numbers that are not known, are drawn as a smooth wheel; a pinion has so many.
MOST_TEETH, PINION_TEETH = 240, 24

#: Positions looked at to find how large a plane must be.
SAMPLED = 20_000


@dataclass(frozen=True)
class Element:
    """A joint or force element as it sits on its bodies."""

    role: Role
    index: int
    kind: str
    bodies: tuple[int, int]
    origin: Floats  # (2, 3) [m]
    frame: Floats  # (2, 3, 3) axes as columns
    numbers: Mapping[str, float]  #: its parameters by name; NaN for functions of time

    def has(self, *names: str) -> bool:
        """Whether one of these parameters is there and not zero."""
        return any(self.numbers.get(name, 0.0) != 0 for name in names)

    def on(self, side: int, shape: Shape) -> Placed:
        """A shape given in the axes of the element, on its first (0) or second (1) body."""
        return Placed(self, self.bodies[side], at(shape, self.origin[side], self.frame[side]))


@dataclass(frozen=True)
class Placed:
    """A shape on a body, for an element: its symbol, material of the body, a ball or plane that touches."""

    element: Element
    body: int
    shape: Shape
    part: Literal["symbol", "body", "ball", "plane"] = "symbol"


@dataclass(frozen=True)
class Stretched:
    """What reaches from a point of one body to a point of another."""

    element: Element
    form: Form
    radius: float


def elements(header: Header, role: Role) -> Iterator[Element]:
    """Of a result; force elements are known to files of this version on."""
    kinds = getattr(header, f"{role}_kinds")
    origin, frame = (getattr(header, f"{role}_{what}") for what in ("origin", "frame"))
    bodies = getattr(header, f"{role}_bodies").tolist()
    for index, kind in enumerate(kinds):
        info = KINDS[role].get(kind)
        values = header.parameters(role, index).tolist() if info and info.parameters else []
        numbers = dict(zip(info.parameters, values, strict=True)) if info and values else {}
        first, second = bodies[index]
        yield Element(role, index, kind, (first, second), origin[index], frame[index], numbers)


def stretched(header: Header, thickness: float) -> list[Stretched]:
    """Bars of joints that hold a distance, springs and dampers between points; `thickness` of a rod [m]."""
    distances = {kind for kind in set(header.joint_kinds) if Holds.of(kind).distance}
    joints = elements(header, "joint") if distances else ()
    found = [Stretched(it, "bar", 0.5 * thickness) for it in joints if it.kind in distances]
    for it in elements(header, "force"):
        if "free_length" not in it.numbers:
            continue
        length = float(np.linalg.norm(_center_distance(header, it)))
        radius = float(np.clip(length / 12, 0.8 * thickness, 2.4 * thickness))
        spring = it.has("stiffness", "spring")
        if spring:
            found.append(Stretched(it, "coil", radius))
        if it.has("damping", "damper", "force") or not spring:
            found.append(Stretched(it, "damper", 0.55 * radius if spring else 0.8 * radius))
    return found


def solid_parts(result: Result, thickness: float) -> list[Placed]:
    """All that is fixed in a body."""
    header = result.header
    shaped = header.shapes.by_body()
    found: list[Placed] = []
    planes: list[tuple[Element, float]] = []
    for it, holds in zip(elements(header, "joint"), joint_kinds(header), strict=True):
        if holds.translations == (False, False, True) or _placement(it) in ("disc", "plane"):
            planes.append((it, max(abs(it.numbers.get("radius", 0.0)), 4 * thickness)))
        found += [placed for placed in _wheels(header, it, thickness) if placed.body not in shaped]
        line = header.curves.get(it.index, np.zeros((0, 3)))
        found += [Placed(it, it.bodies[0], Rod(a, b, 0.5 * thickness), "plane") for a, b in pairwise(line)]
    for it in elements(header, "force"):
        if "radius" in it.numbers and it.bodies[0] not in shaped:
            planes.append((it, 2 * abs(it.numbers["radius"])))
        parts = _force(it, thickness)
        found += [placed for placed in parts if placed.part == "symbol" or placed.body not in shaped]
    return _distinct(found) + _planes(result, planes, thickness)


def bearings(header: Header) -> Iterator[Element]:
    """Force elements that hold bodies as joints do: bushings."""
    return (it for it in elements(header, "force") if "rotational_stiffness_x" in it.numbers)


def _placement(it: Element) -> str:
    info = KINDS[it.role].get(it.kind)
    return info.placement if info else ""


def at(shape: Shape, origin: Floats, axes: Floats) -> Shape:
    """The same shape, given in the axes of a joint, in those of the body."""
    return shape.moved(origin, axes)


def _force(it: Element, r: float) -> list[Placed]:
    """Balls of contacts, sleeves of bushings, spirals of rotational springs, cases of motors."""
    numbers = it.numbers
    if "rotational_stiffness_x" in numbers:
        return [it.on(0, Cylinder(2.4 * r, 3.4 * r))]
    if "free_angle" in numbers:
        return [it.on(0, Mesh(*_spiral(3.4 * r, 1.6 * r)))]
    if "throttle" in numbers:
        return [it.on(0, Cylinder(2.8 * r, 3 * r))]
    balls = (("radius_a", 0), ("radius_b", 1), ("radius", 1))
    return [
        Placed(it, it.bodies[side], Sphere(abs(numbers[name]), position=it.origin[side]), "ball")
        for name, side in balls
        if np.isfinite(numbers.get(name, np.nan))
    ]


def _wheels(header: Header, it: Element, r: float) -> list[Placed]:
    """Gears, pinions, rolling discs."""
    numbers = it.numbers
    if {"teeth_a", "teeth_b"} <= numbers.keys():
        return _gears(header, it, r)
    radius = abs(numbers.get("radius", np.nan))
    if not np.isfinite(radius):
        return []
    if it.kind == "rack_pinion":
        return [_body(it, 1, _gear(PINION_TEETH, radius, r))]
    spoke = Box((1.9 * radius, 0.12 * radius, 0.09 * radius))
    return [_body(it, 1, Cylinder(radius, 0.06 * radius)), it.on(1, spoke)]


def _gears(header: Header, it: Element, r: float) -> list[Placed]:
    """Both wheels on their pitch circles, a tooth of a in a gap of b where they mesh.

    Between centers a distance c apart:  r_a = c |z_a / (z_a + z_b)|,  r_b = c |z_b / (z_a + z_b)|
    """
    teeth = [round(it.numbers[name]) for name in ("teeth_a", "teeth_b")]
    apart = _center_distance(header, it)
    away = rotation.matrix(_pose(header, it.bodies[0])[3:]) @ it.frame[0]
    across = apart - (apart @ away[:, 2]) * away[:, 2]
    distance = float(np.linalg.norm(across))
    if not sum(teeth) or not distance:
        return []
    found = []
    for side, count in enumerate(teeth):
        radius = distance * abs(count / sum(teeth))
        A = rotation.matrix(_pose(header, it.bodies[side])[3:]) @ it.frame[side]
        # wheels mesh between the centers; a ring and a wheel inside it do beyond the smaller one
        outside = 1 if side == 0 else -1
        if min(teeth) < 0:
            outside = -1 if abs(teeth[0]) < abs(teeth[1]) else 1
        x, y = (A.T @ across)[:2] * outside
        phase = np.arctan2(y, x) + side * np.pi / abs(count)
        turned = rotation.about((0, 0, 1), phase)
        found.append(_body(it, side, _gear(count, radius, r, turned)))
    return found


def _gear(teeth: int, radius: float, r: float, orientation: Sequence[float] | Floats = (1, 0, 0, 0)) -> Shape:
    width = min(3 * r, 0.4 * radius)
    if abs(teeth) > MOST_TEETH:
        return Cylinder(radius, width)
    return Mesh(*_wheel(teeth, radius, width), orientation=orientation)


def _body(it: Element, side: int, shape: Shape) -> Placed:
    placed = it.on(side, shape)
    return Placed(it, placed.body, placed.shape, "body")


@lru_cache(maxsize=256)
def _wheel(teeth: int, radius: float, width: float) -> meshes.Surface:
    """Equal wheels share their arrays, which the page has once then."""
    return _scaled(meshes.wheel(teeth), radius, width)


@lru_cache(maxsize=4)
def _spiral(radius: float, width: float) -> meshes.Surface:
    return _scaled(meshes.spiral(), radius, width)


def _scaled(surface: meshes.Surface, radius: float, width: float) -> meshes.Surface:
    vertices, triangles = surface
    return vertices * (radius, radius, width), triangles


def _planes(result: Result, planes: Sequence[tuple[Element, float]], r: float) -> list[Placed]:
    """One plate for all elements in a plane of a body, as large as what moves on it needs, below it."""
    if not planes or not len(result):
        return []
    several: dict[tuple[int, ...], list[int]] = {}
    for place, (it, _) in enumerate(planes):
        normal = it.frame[0][:, 2]
        height = normal @ it.origin[0] / (100 * r)
        key = (it.bodies[0], *np.round(1e4 * np.append(normal, height)).astype(int).tolist())
        several.setdefault(key, []).append(place)
    every = max(1, len(result) * len(planes) // SAMPLED)
    gap, turns = separations(
        result, np.array([it.bodies for it, _ in planes]), np.array([it.origin for it, _ in planes]), every
    )
    found = []
    for places in several.values():
        first = planes[places[0]][0]
        C, origin = first.frame[0], first.origin[0]
        seen = np.einsum("kmba,kmb->kma", turns[0][:, places], gap[:, places])
        seen = (seen + np.array([planes[place][0].origin[0] for place in places]) - origin) @ C
        reach = np.array([planes[place][1] for place in places])[:, None]
        low = (seen[..., :2].min(axis=0) - reach).min(axis=0)
        high = (seen[..., :2].max(axis=0) + reach).max(axis=0)
        plate = Box((*(high - low), 0.4 * r), position=(*((low + high) / 2), -0.2 * r))
        found.append(Placed(first, first.bodies[0], at(plate, origin, C), "plane"))
    return found


def _distinct(parts: list[Placed]) -> list[Placed]:
    """Without the balls and wheels that several elements have in common."""
    seen = set()
    found = []
    for it in parts:
        size = it.shape.vertices.shape if isinstance(it.shape, Mesh) else str(it.shape.dimensions())
        key = (it.part, it.body, it.shape.kind, size, *np.round(it.shape.position, 9).tolist())
        if it.part == "symbol" or key not in seen:
            found.append(it)
        seen.add(key)
    return found


def _center_distance(header: Header, it: Element) -> Floats:
    """From the first point to the second at the initial pose (3,) [m]."""
    points = []
    for body, origin in zip(it.bodies, it.origin, strict=True):
        pose = _pose(header, body)
        points.append(pose[:3] + rotation.matrix(pose[3:]) @ origin)
    apart: Floats = points[1] - points[0]
    return apart


def _pose(header: Header, body: int) -> Floats:
    pose: Floats = header.q0.reshape(-1, 7)[body] if body >= 0 else np.array([0, 0, 0, 1.0, 0, 0, 0])
    return pose
