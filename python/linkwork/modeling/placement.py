"""Where a joint or force element sits: from what the user says to points and axes fixed in its two bodies.

A user places an element in space at the initial pose (`frames="space"`) or in the coordinates of its two
bodies (`frames="body"`, every argument a pair: in a, in b). Each way of placing is one entry of PLACEMENTS;
the compiled kinds of joints and forces name theirs. Everything works on k elements at once, of large groups
on some thousand: what is computed on the way then fits into a cache.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from typing import Any, Literal, NoReturn

import numpy as np
from numpy.typing import NDArray

from linkwork import rotation
from linkwork.arguments import UNREADABLE, reals
from linkwork.arrays import Floats, Indices, pieces
from linkwork.errors import ModelError

Pair = tuple[Floats, Floats]

#: Where points and axes of an element are given: in space at the initial pose, or as pairs in its two bodies.
Frames = Literal["space", "body"]

#: Deviations from a right angle [rad] and from unit length up to here are taken for rounding.
ROUNDING = 1e-6


@dataclass(frozen=True)
class Subject:
    """Whom a message is about: one element, or the members of a group."""

    kind: str
    name: str
    group: bool
    count: int
    each: Sequence[str] = ()  # names of their own for the members of a group
    first: int = 0  # of a part of a group: number of its first member, ...
    total: int | None = None  # ... and of how many, which arguments may have

    def part(self, piece: slice) -> Subject:
        """Some members of this group; arguments are those of all."""
        some = {"count": piece.stop - piece.start, "each": self.each[piece]}
        return replace(self, **some, first=piece.start, total=self.count)

    def member(self, k: int) -> str:
        if self.each:
            return self.each[k]
        return f"{self.name}[{self.first + k}]" if self.group else self.name

    @property
    def names(self) -> str | list[str]:
        """As the compiled model takes them: a prefix for a group, else a name for each element."""
        if self.each:
            return list(self.each)
        return self.name if self.group else [self.name]

    def who(self, k: int) -> str:
        return f"{self.kind} '{self.member(k)}'"

    def refuse(self, k: int, why: str, code: str, field: str = "") -> NoReturn:
        """Raise the ModelError about element k, and the argument that is wrong."""
        who, name = self.who(k), self.member(k)
        raise ModelError(f"{who}: {why}", code=code, joints=[name], subject=who, field=field)

    def check(self, good: NDArray[np.bool_], why: Callable[[int], str], code: str, field: str = "") -> None:
        """Refuse the first element for which `good` (k,) does not hold."""
        if not good.all():
            k = int(np.argmin(good))
            self.refuse(k, why(k), code, field)

    def array(self, value: Any, size: int, what: str) -> Floats:
        """`value` as (k, size): the same for all, or one for each element; finite."""
        try:
            given = reals(value, texts=True)
        except UNREADABLE:
            self.refuse(0, f"{what} {value!r:.80} is not made of numbers", "not_a_number", what)
        total = self.count if self.total is None else self.total
        if given.shape not in ((size,), (total, size)):
            each = f" or ({total}, {size})" if self.group else ""
            self.refuse(0, f"{what} has shape {given.shape}, not ({size},){each}", "shape", what)
        own = given if given.ndim == 1 else given[self.first : self.first + self.count]
        array = np.broadcast_to(own, (self.count, size))
        self.check(
            np.asarray(np.isfinite(array).all(axis=1)),
            lambda k: f"{what} {text(array[k])} is not finite",
            "not_finite",
            what,
        )
        return array

    def pair(self, value: Any, what: str) -> tuple[Any, Any]:
        """Two things: one for a, one for b."""
        if _length(value) != 2:
            self.refuse(0, f"{what} must be a pair (for a, for b), not {value!r}", "not_a_pair", what)
        return value[0], value[1]

    def components(self, value: Any, what: str) -> dict[str, Any]:
        """The three parts of a vector, of any kind: what_x, what_y, what_z; of a group also (k, 3)."""
        if self.group and (each := _rows(value)) is not None:
            return {f"{what}_{axis}": x for axis, x in zip("xyz", self.array(each, 3, what).T, strict=True)}
        if self.group and self._are_rows(value):
            why = f"{what} has rows of functions: in a group a function of time is for all elements"
            self.refuse(0, f"{why}; add those that have functions of their own one by one", "shape", what)
        if _length(value) != 3:
            self.refuse(0, f"{what} must have three components, not {value!r}", "shape", what)
        return {f"{what}_{axis}": component for axis, component in zip("xyz", value, strict=True)}

    def _are_rows(self, value: Any) -> bool:
        """Whether a component is a vector; three functions, one with its derivatives, are none, unless there
        are as many as elements, where nobody can tell."""
        vectors = [it for it in value if _length(it) == 3] if _length(value) else []
        return any(
            len(vectors) == self.count or not (isinstance(it, tuple) and all(map(callable, it)))
            for it in vectors
        )

    def directions(self, value: Any, what: str) -> Floats:
        """Unit vectors (k, 3)."""
        given = self.array(value, 3, what)
        largest = np.abs(given).max(axis=1, keepdims=True)
        self.check(
            largest[:, 0] > 0, lambda k: f"{what} {text(given[k])} has no direction", "zero_axis", what
        )
        scaled = given / largest
        unit: Floats = scaled / np.linalg.norm(scaled, axis=1, keepdims=True)
        return unit

    def orientations(self, value: Any, what: str) -> Floats:
        """Rotation matrices (k, 3, 3) of unit Euler parameters (e0, e1, e2, e3)."""
        p = self.array(value, 4, what)
        norm = np.linalg.norm(p, axis=1, keepdims=True)
        self.check(
            np.abs(norm[:, 0] - 1) <= ROUNDING,
            lambda k: f"{what} {text(p[k])} has norm {norm[k, 0]:.6g} and must be unit Euler parameters",
            "orientation",
            what,
        )
        return rotation.matrix(p / norm)


@dataclass(frozen=True)
class Poses:
    """Where k bodies are: centers of mass r (k, 3), rotations A (k, 3, 3) from body to inertial."""

    r: Floats
    A: Floats

    def point(self, s: Floats) -> Floats:
        """r + A s"""
        return self.r + turn(self.A, s)

    def body_point(self, p: Floats) -> Floats:
        """A^T (p - r)"""
        return turn(np.swapaxes(self.A, 1, 2), p - self.r)


@dataclass(frozen=True)
class Attachment:
    """How k elements are attached to their bodies a and b."""

    origin: Floats  # (k, 2, 3) the points, in body coordinates
    frame: Floats  # (k, 2, 3, 3) the joint frames, in body coordinates; columns x, y, z
    distance: Floats  # (k,) of the two points at the initial pose

    @classmethod
    def empty(cls, k: int) -> Attachment:
        return cls(np.empty((k, 2, 3)), np.empty((k, 2, 3, 3)), np.empty(k))


@dataclass(frozen=True)
class Place:
    """What a placement starts from: whom it is about, the bodies' poses, and the frames of the arguments."""

    subject: Subject
    a: Poses
    b: Poses
    in_bodies: Collection[str]  # names of those that are in body coordinates, for a and for b

    def common_points(self, at: Any) -> Pair:
        """The same point of both bodies, in body coordinates."""
        return self.points(at if "at" in self.in_bodies else (at, at))

    def points(self, at: Any) -> Pair:
        """A point of a and a point of b, in body coordinates."""
        p_a, p_b = (self.subject.array(p, 3, "at") for p in self.subject.pair(at, "at"))
        return (p_a, p_b) if "at" in self.in_bodies else (self.a.body_point(p_a), self.b.body_point(p_b))

    def common_direction(self, axis: Any, what: str) -> Pair:
        """The same direction, as seen by both bodies, in space."""
        if what in self.in_bodies:
            return self.directions(axis, what)
        z = self.subject.directions(axis, what)
        return z, z

    def directions(self, axes: Any, what: str) -> Pair:
        """A direction fixed in a and one fixed in b, in space."""
        z_a, z_b = (self.subject.directions(z, what) for z in self.subject.pair(axes, what))
        return (turn(self.a.A, z_a), turn(self.b.A, z_b)) if what in self.in_bodies else (z_a, z_b)

    def attachment(self, points: Pair, frames: Pair) -> Attachment:
        """From points in body coordinates and frames (k, 3, 3) in space."""
        out = Attachment.empty(self.subject.count)
        for end, body in enumerate((self.a, self.b)):
            out.origin[:, end] = points[end]
            out.frame[:, end] = np.swapaxes(body.A, 1, 2) @ frames[end]
        out.distance[:] = self.distance(*points)
        return out

    def distance(self, s_a: Floats, s_b: Floats) -> Floats:
        """Of the two points (k,) at the initial pose; infinite where its square is beyond all numbers."""
        with np.errstate(over="ignore", invalid="ignore"):
            found: Floats = np.linalg.norm(self.separation(s_a, s_b), axis=1)
        return found

    def separation(self, s_a: Floats, s_b: Floats) -> Floats:
        """From the point of a to that of b (k, 3), in space at the initial pose; zero where only rounding."""
        p_a, p_b = self.a.point(s_a), self.b.point(s_b)
        rounding = 1e-14 * np.abs(np.concatenate([p_a, p_b, self.a.r, self.b.r], axis=1)).max(axis=1)
        d = p_b - p_a
        return np.where((np.abs(d).max(axis=1) > rounding)[:, None], d, 0.0)


def point(place: Place, at: Any) -> Attachment:
    """A point; the frames are those of space at the initial pose."""
    return place.attachment(place.common_points(at), _space_axes(place))


def axis(place: Place, at: Any, axis: Any, x_axis: Any = None) -> Attachment:
    """A point and an axis z. Without `x_axis` a perpendicular is chosen, in space the same for both."""
    return _axis(place, place.common_points(at), axis, x_axis)


def _axis(place: Place, points: Pair, axis: Any, x_axis: Any) -> Attachment:
    z_a, z_b = place.common_direction(axis, "axis")
    if x_axis is None:
        x_a = x_b = rotation.perpendicular(z_a)
    else:
        x_a, x_b = place.common_direction(x_axis, "x_axis")
    frame = _frame(place, z_a, x_a, "x_axis")
    same = z_b is z_a and x_b is x_a
    return place.attachment(points, (frame, frame if same else _frame(place, z_b, x_b, "x_axis")))


def two_axes(place: Place, at: Any, axes: Any) -> Attachment:
    """A point, and an axis z for each body, perpendicular to each other; x is perpendicular to both."""
    return _two_axes(place, place.common_points(at), axes)


def _two_axes(place: Place, points: Pair, axes: Any) -> Attachment:
    z_a, z_b = place.directions(axes, "axes")
    cosine = np.sum(z_a * z_b, axis=1)
    right = np.abs(cosine) <= (1 - ROUNDING if "axes" in place.in_bodies else ROUNDING)
    place.subject.check(right, lambda k: _wrong_angle(z_a[k], z_b[k]), "axes", "axes")
    if "axes" not in place.in_bodies:
        z_b = z_b - cosine[:, None] * z_a
    x = np.cross(z_a, z_b)
    return place.attachment(points, (_frame(place, z_a, x, "axes"), _frame(place, z_b, x, "axes")))


def direction(place: Place, axis: Any, x_axis: Any = None) -> Attachment:
    """An axis z and no point: as `axis`, in the centers of mass."""
    return _axis(place, _centers_of_mass(place), axis, x_axis)


def two_directions(place: Place, axes: Any) -> Attachment:
    """An axis for each body, perpendicular to each other, and no point."""
    return _two_axes(place, _centers_of_mass(place), axes)


def orientation(place: Place, orientation: Any = None) -> Attachment:
    """Full axes and no point."""
    return _frames(place, _centers_of_mass(place), orientation)


def shafts(place: Place, at: Any, axes: Any) -> Attachment:
    """A point, and an axis z for each body, not opposite; x of b is that of a, turned along."""
    z_a, z_b = place.directions(axes, "axes")
    place.subject.check(
        np.sum(z_a * z_b, axis=1) > -1 + ROUNDING,
        lambda k: f"axes {text(z_a[k])} and {text(z_b[k])} are opposite",
        "axes",
        "axes",
    )
    first = _frame(place, z_a, rotation.perpendicular(z_a), "axes")
    second = rotation.between(z_a, z_b) @ first
    return place.attachment(place.common_points(at), (first, second))


def centers(place: Place, at: Any, axis: Any) -> Attachment:
    """A point for each body and a common axis z; x of each body points to the other's point.

    The point of a is shifted along the axis until the line between the points is perpendicular to it.
    """
    z_a, z_b = place.common_direction(axis, "axis")
    s_a, s_b = place.points(at)
    d = place.separation(s_a, s_b)
    along = np.sum(d * z_a, axis=1, keepdims=True) * z_a
    s_a = place.a.body_point(place.a.point(s_a) + along)
    d = d - along
    place.subject.check(
        np.linalg.norm(d, axis=1) > ROUNDING * np.linalg.norm(along, axis=1),
        lambda k: f"its points are not apart from each other across the axis {text(z_a[k])}",
        "at",
        "at",
    )
    return place.attachment((s_a, s_b), (_frame(place, z_a, d, "at"), _frame(place, z_b, -d, "at")))


def disc(place: Place, at: Any, axes: Any) -> Attachment:
    """A point and an axis z for each body."""
    z_a, z_b = place.directions(axes, "axes")
    x_a, x_b = rotation.perpendicular(z_a), rotation.perpendicular(z_b)
    frames = _frame(place, z_a, x_a, "axes"), _frame(place, z_b, x_b, "axes")
    return place.attachment(place.points(at), frames)


def plane(place: Place, at: Any, normal: Any) -> Attachment:
    """A plane of a, by a point and its normal z toward b, and a point of b."""
    z = place.subject.directions(normal, "normal")
    z = turn(place.a.A, z) if "normal" in place.in_bodies else z
    frame = _frame(place, z, rotation.perpendicular(z), "normal")
    return place.attachment(place.points(at), (frame, frame))


def two_points(place: Place, at: Any) -> Attachment:
    """A point of a and a point of b; z points from one to the other at the initial pose."""
    s_a, s_b = place.points(at)
    z = place.separation(s_a, s_b)
    z = np.where(np.linalg.norm(z, axis=1, keepdims=True) > 0, z, (0.0, 0.0, 1.0))
    frame = _frame(place, z, rotation.perpendicular(z), "at")
    return place.attachment((s_a, s_b), (frame, frame))


def frame(place: Place, at: Any, orientation: Any = None) -> Attachment:
    """A point and full axes by Euler parameters; without them those of space at the initial pose."""
    return _frames(place, place.common_points(at), orientation)


def _frames(place: Place, points: Pair, orientation: Any) -> Attachment:
    if orientation is None:
        frames = _space_axes(place)
    elif "orientation" in place.in_bodies:
        C_a, C_b = (
            place.subject.orientations(p, "orientation")
            for p in place.subject.pair(orientation, "orientation")
        )
        frames = place.a.A @ C_a, place.b.A @ C_b
    else:
        frames = (place.subject.orientations(orientation, "orientation"),) * 2
    return place.attachment(points, frames)


#: The ways of placing, by the name that the compiled kinds use.
PLACEMENTS: Mapping[str, Callable[..., Attachment]] = {
    "point": point,
    "axis": axis,
    "two_axes": two_axes,
    "two_points": two_points,
    "frame": frame,
    "direction": direction,
    "two_directions": two_directions,
    "orientation": orientation,
    "shafts": shafts,
    "centers": centers,
    "disc": disc,
    "plane": plane,
}


def attach(
    placement: Callable[..., Attachment],
    subject: Subject,
    bodies: Indices,
    poses: Callable[[Indices], Poses],
    in_bodies: Collection[str],
    where: Mapping[str, Any],
) -> Attachment:
    """k elements between bodies (k, 2), which have these `poses`, by the arguments `where` of a placement.

    in_bodies  names of the arguments that are in body coordinates; the others are in space
    """

    def attached(subject: Subject, bodies: Indices, where: Mapping[str, Any]) -> Attachment:
        place = Place(subject, poses(bodies[:, 0]), poses(bodies[:, 1]), in_bodies)
        with np.errstate(over="ignore", invalid="ignore"):  # elements refuse what is not finite
            return placement(place, **where)

    parts = list(pieces(subject.count))
    if len(parts) <= 1:
        return attached(subject, bodies, where)
    out = Attachment.empty(subject.count)
    where = {what: _as_arrays(value, subject.count) for what, value in where.items()}
    for piece in parts:
        part = attached(subject.part(piece), bodies[piece], where)
        out.origin[piece], out.frame[piece], out.distance[piece] = part.origin, part.frame, part.distance
    return out


def _as_arrays(value: Any, count: int) -> Any:
    """A list of a vector for each element, or a pair of such, as arrays: read once; what is none stays."""
    if isinstance(value, list | tuple) and len(value) == 2:
        return tuple(_as_arrays(part, count) for part in value)
    if isinstance(value, list | tuple) and len(value) == count:
        try:
            return reals(value, texts=True)
        except UNREADABLE:
            return value
    return value


def turn(A: Floats, u: Floats) -> Floats:
    """A u for matrices (k, 3, 3) and vectors (k, 3)."""
    turned: Floats = np.einsum("kij,kj->ki", A, u)
    return turned


def text(values: Floats) -> str:
    """A vector in a message."""
    return "(" + ", ".join(f"{value:.6g}" for value in values) + ")"


def _centers_of_mass(place: Place) -> Pair:
    return (np.zeros((place.subject.count, 3)),) * 2


def _space_axes(place: Place) -> Pair:
    identity = np.broadcast_to(np.eye(3), (place.subject.count, 3, 3))
    return identity, identity


def _frame(place: Place, z: Floats, x: Floats, what: str) -> Floats:
    """Right-handed axes (k, 3, 3) with the direction of z, and x as near as can be."""
    z = z / np.linalg.norm(z, axis=1, keepdims=True)
    given = np.linalg.norm(x, axis=1)
    x = x - np.sum(x * z, axis=1, keepdims=True) * z
    length = np.linalg.norm(x, axis=1, keepdims=True)
    place.subject.check(
        length[:, 0] > ROUNDING * given,
        lambda k: f"{what} is parallel to the axis {text(z[k])}",
        "zero_axis",
        what,
    )
    x = x / length
    return np.stack([x, np.cross(z, x), z], axis=2)


def _wrong_angle(z_a: Floats, z_b: Floats) -> str:
    angle = float(np.degrees(np.arctan2(np.linalg.norm(np.cross(z_a, z_b)), z_a @ z_b)))
    if min(angle, 180 - angle) < 1e-3:
        return f"axes {text(z_a)} and {text(z_b)} are parallel"
    return f"axes {text(z_a)} and {text(z_b)} are at {angle:.6g} degrees to each other, not 90"


def _rows(value: Any) -> Floats | None:
    """A vector for each of a group; None: it is one for all, or none of numbers."""
    try:
        found = reals(value, texts=True)
    except UNREADABLE:
        return None
    return found if found.ndim == 2 else None


def _length(value: Any) -> int:
    """0 of what has none, of text, and of what has no order."""
    try:
        return 0 if isinstance(value, str | Set | Mapping) else len(value)
    except TypeError:
        return 0
