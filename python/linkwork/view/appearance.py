"""What is drawn of a mechanism: the shapes that were given, defaults for the rest, symbols for joints.

A body without a shape is drawn as rods between the points of its joints, or as a plate where four or more are
in a plane; without such points, or for what sticks out beyond them, as the uniform solid that has its mass
and inertia. Two bodies that slide in each other along their length are a cylinder and its piston. The symbol
of a joint follows from its equations: which translations and rotations they hold.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.modeling.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere
from linkwork.motion.header import Header
from linkwork.motion.violations import Holds, gaps, joint_kinds
from linkwork.view import machine_elements, meshes
from linkwork.view.machine_elements import Form, at

if TYPE_CHECKING:
    from linkwork.results.result import Result

Layer = Literal["body", "joint", "force", "ground"]

#: Muted, and distinguishable with any color vision; bodies take them in turn.
BODY_COLORS = ("#4c78a8", "#e08a3c", "#5a9e6f", "#b279a2", "#c9a227", "#6fb1c7", "#9c6b4e", "#8a8fa3")
JOINT_COLOR, GROUND_COLOR, FORCE_COLOR, PLANE_COLOR = "#3a424d", "#8b929c", "#7d6b9e", "#b9bfc7"

#: Of what is stretched between two points.
SPAN_COLORS = {"bar": "#7a828c", "coil": FORCE_COLOR, "damper": "#98a1ab"}

#: Of many bodies the first to the last are of one color after the other: neighbors look alike.
RAMP = ("#35608d", "#2f9384", "#7fae4a", "#e3b43c", "#dd7f3c", "#b5547a")

RAMP_BYTES = [bytes.fromhex(color[1:]) for color in RAMP]

#: Many.
RAMPED = 200

#: Points are in a plane where they are no farther from it than this part of how far they are apart.
FLAT = 0.05

#: Radius of a piston over that of its cylinder; a collar's, which ends the cylinder, and its length.
PISTON, COLLAR, COLLAR_LENGTH = 0.6, 1.3, 2.5

#: Moments of inertia that differ by less are taken for equal.
EQUAL = 1e-3

#: Around each corner of a plate [rad].
CORNERS = 2 * np.pi / 12 * np.arange(12)

#: Frames looked at to see how far something slides; joints for which that is done.
SAMPLED_FRAMES, SLIDES = 100, 500


@dataclass(frozen=True)
class Solid:
    """A shape on a body, -1 the ground; `index` of the body, joint or force element that it shows."""

    layer: Layer
    index: int
    body: int
    shape: Shape
    color: str
    clear: bool = False  #: one looks through it


@dataclass(frozen=True)
class Span:
    """A bar, coil or damper between points of two bodies; `index` of the joint or force element."""

    layer: Literal["joint", "force"]
    index: int
    form: Form
    bodies: tuple[int, int]
    ends: Floats  # (2, 3) in the bodies [m]
    radius: float  # [m]
    color: str


@dataclass(frozen=True)
class Scene:
    """Everything that is drawn, in the order of the bodies, joints and force elements."""

    solids: list[Solid]
    spans: list[Span]


def scene(result: Result) -> Scene:
    """What is drawn of a result."""
    header = result.header
    holds = joint_kinds(header)
    points = _points_of_bodies(header, holds)
    thickness = _thickness(header, points)
    spans = [
        Span(it.element.role, it.element.index, it.form, it.element.bodies, it.element.origin, it.radius,
             SPAN_COLORS[it.form])
        for it in machine_elements.stretched(header, thickness)
    ]  # fmt: skip
    return Scene(_solids(result, holds, points, thickness), spans)


def _solids(
    result: Result, holds: Sequence[Holds], points: dict[int, list[Floats]], thickness: float
) -> list[Solid]:
    """Everything solid, in the order of the bodies and joints; `points` of the joints on each body."""
    header = result.header
    given = header.shapes.by_body()
    telescopes = _telescopes(header, holds, given, thickness)
    default = _once_each(thickness)
    halves = {body: rod for it in telescopes.values() for body, rod in it.items()}
    parts = [_element(it, header.body_count) for it in machine_elements.solid_parts(result, thickness)]
    wheels = {it.body for it in parts if it.layer == "body"}
    found = [
        Solid("body", i, i, shape, shape.color or body_color(i, header.body_count))
        for i in range(header.body_count)
        for shape in given.get(i) or halves.get(i) or default(points[i], header.mass[i], header.inertia[i])
        if i in given or i not in wheels or isinstance(shape, Rod)  # a wheel needs no solid of its inertia
    ]
    found += [Solid("ground", -1, -1, shape, shape.color or GROUND_COLOR) for shape in given.get(-1, ())]
    slides = _slides(result, [j for j, it in enumerate(holds) if it.sliding])
    symbols: Symbols = {}
    for j, it in enumerate(holds):
        found += [] if j in telescopes else _joint(header, j, it, thickness, slides.get(j), symbols)
    return found + parts


def body_color(body: int, count: int) -> str:
    """Of one of so many."""
    if count < RAMPED:
        return BODY_COLORS[body % len(BODY_COLORS)]
    place = body / (count - 1) * (len(RAMP) - 1)
    first = min(int(place), len(RAMP) - 2)
    pairs = zip(RAMP_BYTES[first], RAMP_BYTES[first + 1], strict=True)
    return "#" + bytes([round(a + (place - first) * (b - a)) for a, b in pairs]).hex()


def _once_each(thickness: float) -> Callable[[Sequence[Floats], float, Floats], list[Shape]]:
    """default_shapes, the same for bodies that are alike: a long chain has few different ones."""
    made: dict[tuple[bytes, ...], list[Shape]] = {}

    def shapes(points: Sequence[Floats], mass: float, inertia: Floats) -> list[Shape]:
        key = (*(point.tobytes() for point in points), np.float64(mass).tobytes(), inertia.tobytes())
        if key not in made:
            made[key] = default_shapes(points, mass, inertia, thickness)
        return made[key]

    return shapes


# --- cylinders and pistons ---------------------------------------------------------------------------------


def _telescopes(
    header: Header, holds: Sequence[Holds], given: Mapping[int, Sequence[Shape]], thickness: float
) -> dict[int, dict[int, list[Shape]]]:
    """Joints along which two bodies slide in each other, with the shapes of both.

    Both are rods along the axis of the joint, from their other joints to where their inertia ends.
    """
    pairs = {
        j: (int(pair[0]), int(pair[1]))
        for j, pair in enumerate(header.joint_bodies)
        if holds[j].sliding and min(pair) >= 0 and not {int(pair[0]), int(pair[1])} & set(given)
    }
    inner = {frozenset(pair) for pair in pairs.values()}
    between = [
        j for j, pair in enumerate(header.joint_bodies) if inner and frozenset(map(int, pair)) in inner
    ]
    points = _points_of_bodies(header, holds, set(between)) if pairs else {}
    found: dict[int, dict[int, list[Shape]]] = {}
    taken: set[int] = set()
    for j, pair in pairs.items():
        axes = header.joint_frame[j, :, :, 2]
        cylinder, piston = (
            _half(points.get(body, []), header, body, axis, thickness)
            for body, axis in zip(pair, axes, strict=True)
        )
        if cylinder and piston and not taken & set(pair):
            taken |= set(pair)
            found[j] = dict(zip(pair, _telescope(cylinder, piston), strict=True))
    return found


def _telescope(cylinder: Rod, piston: Rod) -> tuple[list[Shape], list[Shape]]:
    """With a collar where the piston comes out, and so much thinner that it is in the cylinder."""
    along = cylinder.end - cylinder.start
    half = COLLAR_LENGTH * cylinder.radius / 2 * along / np.linalg.norm(along)
    collar = Rod(cylinder.end - half, cylinder.end + half, COLLAR * cylinder.radius)
    thin = Rod(piston.start, piston.end, PISTON * min(cylinder.radius, piston.radius))
    return [cylinder, collar], [thin]


def _half(points: Sequence[Floats], header: Header, body: int, axis: Floats, thickness: float) -> Rod | None:
    """The one rod that a body is, from its joint, if it lies along an axis."""
    shapes = default_shapes(points, header.mass[body], header.inertia[body], thickness) if points else []
    if len(shapes) != 1 or not isinstance(shapes[0], Rod):
        return None
    along = shapes[0].end - shapes[0].start
    return shapes[0] if abs(along @ axis) > 0.99 * np.linalg.norm(along) else None


def _element(it: machine_elements.Placed, count: int) -> Solid:
    """Wheels and balls have the color of their body; balls stand for more than one sees of a body."""
    role, index = it.element.role, it.element.index
    if it.part in ("body", "ball") and it.body >= 0:
        color, ball = body_color(it.body, count), it.part == "ball"
        return Solid("force" if ball else "body", index if ball else it.body, it.body, it.shape, color, ball)
    color = PLANE_COLOR if it.part != "symbol" else FORCE_COLOR if role == "force" else JOINT_COLOR
    return Solid(role, index, it.body, it.shape, color)


# --- bodies ------------------------------------------------------------------------------------------------


def default_shapes(points: Sequence[Floats], mass: float, inertia: Floats, thickness: float) -> list[Shape]:
    """Of a body with joints at `points` (3,), body coordinates; `thickness` is the radius of rods [m]."""
    corners = _distinct(points, 0.5 * thickness)
    arms = [corner for corner in corners if np.linalg.norm(corner) > 2 * thickness]
    if len(corners) == 2:
        return _link(corners[0], corners[1], thickness)
    if len(corners) == 3:
        pairs = [(0, 1), (1, 2), (2, 0)]
        return [_rod(corners[a], corners[b], thickness) for a, b in pairs]
    if len(corners) > 3 and (plate := _plate(np.array(corners), thickness)):
        return [plate]
    if len(corners) > 3:
        return [Sphere(1.8 * thickness), *(_rod(np.zeros(3), arm, thickness) for arm in arms)]
    solid = _uniform_solid(mass, inertia, 3 * thickness)
    if not corners:
        return [solid]
    if not arms:
        solid = Box([1.6 * solid.radius] * 3) if isinstance(solid, Sphere) else solid
        return [_at_most(solid, 10 * thickness)]
    return _hanging(arms[0], solid, thickness)


def _plate(points: Floats, thickness: float) -> Shape | None:
    """What covers points (k, 3) in a plane, but not on a line, with an edge beyond them; else None."""
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle)
    if spread[2] > FLAT * spread[0] or spread[1] < 4 * FLAT * spread[0]:
        return None
    axes[2] = np.cross(axes[0], axes[1])
    edge = 1.8 * thickness * np.stack([np.cos(CORNERS), np.sin(CORNERS)], axis=1)
    outline = ((points - middle) @ axes[:2].T)[:, None] + edge
    return Mesh(*meshes.plate(outline.reshape(-1, 2), 0.5 * thickness), position=middle,
                orientation=rotation.from_matrix(axes.T))  # fmt: skip


def _link(a: Floats, b: Floats, thickness: float) -> list[Shape]:
    """Two joints: a rod; where the center of mass is far beside it, a triangle."""
    direction = (b - a) / np.linalg.norm(b - a)
    beside = np.linalg.norm(a - (a @ direction) * direction)
    if beside < 0.15 * np.linalg.norm(b - a):
        return [_rod(a, b, thickness)]
    center = np.zeros(3)
    return [_rod(a, b, thickness), *(_rod(center, end, 0.7 * thickness) for end in (a, b))]


def _hanging(joint: Floats, solid: Shape, thickness: float) -> list[Shape]:
    """One joint: a rod that ends where the inertia says, or an arm to the solid at the center of mass."""
    arm = float(np.linalg.norm(joint))
    along, length = _longest(solid)
    if length > 0.5 * arm and abs(along @ joint) > 0.99 * arm:
        return [_rod(joint, -joint * length / (2 * arm), thickness)]
    return [_rod(joint, np.zeros(3), thickness), _at_most(solid, 1.2 * arm)]


def _at_most(solid: Shape, length: float) -> Shape:
    """The same, smaller where it is longer than that: inertias of bodies on joints are often but guesses."""
    size = {name: np.asarray(value) for name, value in solid.dimensions().items()}
    longest = max(float(np.max(value)) * (2 if name == "radius" else 1) for name, value in size.items())
    if longest <= length:
        return solid
    smaller = {name: value * length / longest for name, value in size.items()}
    return Shape.of(solid.description() | {name: value.tolist() for name, value in smaller.items()})


def at_least(shape: Shape, thinnest: float) -> Shape:
    """The same, nowhere thinner than that [m]: what is seen from afar. Meshes stay as they are."""
    sizes = {name: value for name, value in shape.dimensions().items() if name in ("size", "radius")}
    wide = {
        name: np.maximum(value, thinnest if name == "size" else thinnest / 2) for name, value in sizes.items()
    }
    if all(np.array_equal(wide[name], sizes[name]) for name in sizes):
        return shape
    return Shape.of(shape.description() | {name: value.tolist() for name, value in wide.items()})


def _longest(solid: Shape) -> tuple[Floats, float]:
    """Direction (3,) and length of a slender solid; length 0 where it is not slender."""
    if isinstance(solid, Cylinder) and solid.length > 4 * solid.radius:
        return rotation.matrix(solid.orientation)[:, 2], solid.length
    if isinstance(solid, Box):
        order = np.argsort(solid.size)
        if solid.size[order[2]] > 3 * solid.size[order[1]]:
            return rotation.matrix(solid.orientation)[:, order[2]], float(solid.size[order[2]])
    return np.zeros(3), 0.0


def _uniform_solid(mass: float, inertia: Floats, least: float) -> Shape:
    """The uniform ball, cylinder or box of that mass and inertia; no edge below `least` / 2 [m].

    Box with edges a:  J_x = m (a_y^2 + a_z^2) / 12,  so  a_x^2 = 6 (J_y + J_z - J_x) / m
    Cylinder about z:  J_z = m R^2 / 2,  J_x = m (3 R^2 + L^2) / 12
    """
    if mass <= 0 or not np.any(inertia):
        return Sphere(least)
    moments, axes = np.linalg.eigh(inertia)
    if np.linalg.det(axes) < 0:
        axes = -axes
    if moments[2] - moments[0] < EQUAL * moments[2]:
        return Sphere(max(least / 2, float(np.sqrt(2.5 * moments.mean() / mass))))
    odd = 0 if moments[2] - moments[1] < moments[1] - moments[0] else 2
    if abs(moments[1] - moments[2 - odd]) < EQUAL * moments[2]:
        radius = np.sqrt(2 * max(moments[odd], 0.0) / mass)
        length = np.sqrt(max(12 * moments[1] / mass - 3 * radius**2, 0.0))
        return Cylinder(max(radius, least / 4), max(length, least / 2), axis=axes[:, odd])
    squares = 6 * (moments.sum() - 2 * moments) / mass
    edges = np.maximum(np.sqrt(np.maximum(squares, 0.0)), least / 2)
    return Box(edges, orientation=rotation.from_matrix(axes))


def _rod(a: Floats, b: Floats, thickness: float) -> Shape:
    return Rod(a, b, min(thickness, 0.15 * float(np.linalg.norm(b - a))))


def _distinct(points: Sequence[Floats], least: float) -> list[Floats]:
    """Points at least so far apart."""
    if len(points) > 100:  # a hub
        return list(points)
    found: list[Floats] = []
    for point in points:
        if all(np.linalg.norm(point - other) > least for other in found):
            found.append(point)
    return found


def _points_of_bodies(
    header: Header, holds: Sequence[Holds], without: Collection[int] = ()
) -> dict[int, list[Floats]]:
    """Where placed joints and bushings sit on each body; `without` these joints."""
    points: dict[int, list[Floats]] = defaultdict(list)
    bodies = header.joint_bodies.tolist()
    for j, it in enumerate(holds):
        if j in without:
            continue
        for body, origin in zip(bodies[j], header.joint_origin[j], strict=True):
            if body >= 0 and it.placed:
                points[body].append(origin)
    for bearing in machine_elements.bearings(header):
        for body, origin in zip(bearing.bodies, bearing.origin, strict=True):
            if body >= 0:
                points[body].append(origin)
    return points


def _thickness(header: Header, points: dict[int, list[Floats]]) -> float:
    """Radius of rods: 1/36 of a usual distance between the joints of a body or from one to its center."""
    counts = [len(several) for several in points.values()]
    joined = np.concatenate([np.zeros((0, 3)), *points.values()])
    reach = np.linalg.norm(joined, axis=1)
    spans = 2 * np.maximum.reduceat(reach, np.cumsum([0, *counts[:-1]])) if counts else reach
    usual = float(np.median(spans)) if len(spans) else 0.0
    if usual <= 0:
        heavy = header.mass > 0
        radii = np.sqrt(np.trace(header.inertia[heavy], axis1=1, axis2=2) / header.mass[heavy])
        usual = 4 * float(np.median(radii)) if len(radii) else 0.0
    return usual / 36 or 0.02


#: The symbols of joints that hold the same, at the same place on their first bodies.
Symbols = dict[tuple[tuple[bool, bool, bool], int, bytes, bytes], list[Shape]]

# --- joints ------------------------------------------------------------------------------------------------


def _joint(
    header: Header, j: int, it: Holds, r: float, slide: tuple[float, float] | None, symbols: Symbols
) -> list[Solid]:
    """The symbol at the joint's point on its first body, a rail where it slides, a foot on the ground."""
    if not it.placed:
        return []
    first, second = (int(body) for body in header.joint_bodies[j])
    origin, axes = header.joint_origin[j, 0], header.joint_frame[j, 0]
    foot = []
    if -1 in (first, second) and not it.sliding and it.translations != (False, False, False):
        side = 0 if first < 0 else 1
        foot = [
            at(Box((4.4 * r, 4.4 * r, 1.2 * r)), header.joint_origin[j, side], header.joint_frame[j, side])
        ]
    key = it.translations, it.rotations, origin.tobytes(), axes.tobytes()
    if key not in symbols:
        symbols[key] = _symbol(it, origin, axes, r)
    found = [Solid("joint", j, first, shape, JOINT_COLOR) for shape in symbols[key]]
    found += [Solid("ground", j, -1, shape, GROUND_COLOR) for shape in foot]
    if it.sliding:  # the sleeve is where the second body is
        low, high = slide or (0.0, 0.0)
        z = axes[:, 2]
        ends = origin + (low - 6 * r) * z, origin + (high + 6 * r) * z
        rail = Solid("ground", j, first, Rod(*ends, 0.55 * r), GROUND_COLOR)
        sleeve = at(_sleeve(it.rotations, r), header.joint_origin[j, 1], header.joint_frame[j, 1])
        return [rail, Solid("joint", j, second, sleeve, JOINT_COLOR)]
    return found


def _sleeve(rotations: int, r: float) -> Shape:
    """One that may turn is round."""
    return Box((3.2 * r, 3.2 * r, 6 * r)) if rotations >= 3 else Cylinder(1.8 * r, 6 * r)


def _symbol(it: Holds, origin: Floats, axes: Floats, r: float) -> list[Shape]:
    """Pin, ball, cross, block, plate, or a small ball for what has no usual symbol."""
    match it.translations, it.rotations:
        case (True, True, True), 0:
            return [at(Sphere(1.9 * r), origin, axes)]
        case (True, True, True), 1:
            cross = [Cylinder(0.8 * r, 5 * r, axis=axis) for axis in ((0, 0, 1), (1, 0, 0))]
            return [at(pin, origin, axes) for pin in cross]
        case (True, True, True), 2:
            return [at(Cylinder(1.5 * r, 4.2 * r), origin, axes)]
        case (True, True, True), _:
            return [at(Box((3 * r, 3 * r, 3 * r)), origin, axes)]
        case (False, False, True), _:
            return []  # its plane is drawn where something moves on it
        case _:
            return [at(Sphere(1.2 * r), origin, axes)]


def _slides(result: Result, joints: Sequence[int]) -> dict[int, tuple[float, float]]:
    """How far the second point moves along the z axis of each joint, from a sample of frames [m]."""
    every = max(1, len(result) // SAMPLED_FRAMES)
    chosen = np.asarray(joints[:SLIDES], int)
    if not len(chosen) or not len(result):
        return {}
    gap, axes = gaps(result, chosen, every)
    along = np.einsum("kjc,kjc->kj", gap, axes[..., 2])
    return {
        int(j): (float(low), float(high))
        for j, low, high in zip(chosen, along.min(0), along.max(0), strict=True)
    }
