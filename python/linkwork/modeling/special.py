"""Joints that a point and axes on two bodies do not describe: relations of coordinates, and curves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core, rotation
from linkwork.arguments import UNREADABLE, is_one_of, is_text, reals
from linkwork.arrays import Floats, ReadOnly, VectorLike
from linkwork.errors import ModelError
from linkwork.functions import TimeFunction, TimeFunctionLike, as_time_function, broken, infinite_derivative
from linkwork.modeling.coordinates import coordinate_of
from linkwork.modeling.handles import BodyLike, Joint
from linkwork.modeling.placement import Frames, Subject

if TYPE_CHECKING:
    from scipy.interpolate import CubicSpline

    from linkwork.modeling.builder import ModelBuilder

#: Least part of a curve's cross direction that is not along it, anywhere on a piece.
_ACROSS = 0.5
#: Least |dc/ds| of a curve c, where s has the lengths of the chords.
_SLOWEST = 1e-3
#: Steps of a piece in which the cross direction is carried along.
_STEPS = 16


class CoupledCoordinate(NamedTuple):
    """A free coordinate of a joint, as it enters a coupler."""

    joint: str
    coordinate: str
    factor: float


@dataclass(frozen=True)
class CouplerData:
    """What a coupler couples."""

    coordinates: tuple[CoupledCoordinate, ...]

    def arguments(self) -> dict[str, Any]:
        """Of Model.coupler, but the offset, as plain data."""
        return {"coordinates": [term._asdict() for term in self.coordinates]}

    def facts(self, core: _core.Model) -> list[Any]:
        """What decides on the motion: joints by their place."""
        return [term._replace(joint=str(core.find_joint(term.joint))) for term in self.coordinates]


@dataclass(frozen=True)
class CurveData(ReadOnly):
    """The curve of a point_on_curve."""

    points: Floats  #: (k, 3) in body a [m]
    at: Floats  #: the point of b (3,) in body b [m]
    closed: bool

    def arguments(self) -> dict[str, Any]:
        """Of Model.point_on_curve, but the bodies, as plain data."""
        points, at = self.points.tolist(), self.at.tolist()
        return {"points": points, "at": at, "closed": self.closed, "frames": "body"}

    def facts(self, _core: _core.Model) -> dict[str, Any]:
        """What decides on the motion."""
        return self.arguments()

    def line(self) -> Floats:
        """Points along the curve (m, 3), in body a [m], near enough to each other for a picture."""
        curve = _curve(self.points, self.closed)
        line: Floats = curve(_refined(curve.x, max(1, min(8, 400 // len(self.points)))))
        return line


def _coupled(core: _core.Model, terms: Sequence[Any], who: str) -> tuple[CoupledCoordinate, ...]:
    """Checked terms of a coupler: (joint, factor) or (joint, coordinate, factor)."""
    wanted = "(joint, factor) or (joint, coordinate, factor)"
    if isinstance(terms, str) or not isinstance(terms, Sequence) or not terms:
        raise ModelError(
            f"{who}: its coordinates are a list of {wanted}, not {terms!r}", code="terms", subject=who
        )
    out: list[CoupledCoordinate] = []
    for term in terms:
        if isinstance(term, str) or not isinstance(term, Sequence) or len(term) not in (2, 3):
            raise ModelError(f"{who}: {term!r} is not {wanted}", code="terms", subject=who)
        name = term[0].name if isinstance(term[0], Joint) else term[0]
        index = core.find_joint(name) if is_text(name) else -1
        if index < 0:
            raise ModelError(f"{who}: no joint named {name!r:.80}", code="unknown_name", subject=who)
        if isinstance(term[0], Joint) and (index, core.joint_kind(index)) != (term[0].index, term[0].kind):
            raise ModelError(
                f"{who}: joint '{name}' belongs to another model", code="unknown_joint", subject=who
            )
        coordinate = coordinate_of(core.joint_kind(index), str(name), term[1] if len(term) == 3 else None)
        try:
            factor = float(term[-1])
        except UNREADABLE as error:
            why = f"factor {term[-1]!r} of '{name}' is not a number"
            raise ModelError(f"{who}: {why}", code="factor", subject=who) from error
        if not np.isfinite(factor) or factor == 0.0:
            why = f"factor {factor:g} of '{name}' must be finite and not zero"
            raise ModelError(f"{who}: {why}", code="factor", subject=who)
        if any(one[:2] == (name, coordinate) for one in out):
            raise ModelError(
                f"{who}: {coordinate} of '{name}' is there twice; add the factors", code="terms", subject=who
            )
        out.append(CoupledCoordinate(str(name), coordinate, factor))
    return tuple(out)


class SpecialJointMethods:
    """The methods of Model that add special joints."""

    def coupler(
        self,
        coordinates: Sequence[tuple[Joint | str, float] | tuple[Joint | str, str, float]],
        *,
        offset: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> Joint:
        """Add a linear relation between free coordinates of joints: sum factor x coordinate = offset.

        A belt, a differential gear, a finger that follows another: what a transmission demands, wherever its
        wheels are. 1 equation, among all bodies of the joints.

            model.coupler([("motor pin", 1.0), ("wheel pin", -2.5)])   # 2.5 turns of the motor for one

        coordinates  (joint, factor), or (joint, coordinate, factor) where a joint has several; joints that
                     were added before, or their names. Coordinates as `Result.coordinate` gives them [rad, m]
        offset       a number or a function of time; in the unit of the sum
        breaks       times [s] at which a Python function is not smooth, see functions.with_breaks

        Angles count over full turns from the initial pose on, where they are within half a turn of zero. If
        the relation does not hold so, joints may have turned before, as up to a frame of another run: it goes
        on with the fewest whole turns of two joints (100 at most each) with which it holds, which
        `Result.coordinate` is without. Where all angles are zero nothing has turned, and it has to hold.

        The multiplier is the generalized force of the sum; the reaction is what acts on the second body of
        the first joint.

        ModelError: no such joint or coordinate, a factor that is no number or zero, a taken name.
        """
        model = cast("ModelBuilder", self)
        name = model._named(name, "coupler", model._counts["coupler"])
        who = f"coupler '{name}'"
        terms = _coupled(model._core, coordinates, who)
        function = as_time_function(broken({"offset": offset}, breaks, who)["offset"], f"{who}: offset")
        constant, signal = 0.0, -1
        if not isinstance(function, TimeFunction):
            constant = function
        elif why := infinite_derivative(function) if function.has_derivatives else "":
            raise ModelError(f"{who}: offset: {why}", code="derivatives", subject=who, field="offset")
        elif function.has_derivatives:
            signal = model._core.add_signal(function.compiled())
            model._functions[signal] = function
            model._signals.append((f"{who}: offset", function))
            model._drivers.append((f"{who}: offset", function))
        else:
            remedy = "a tuple of functions (f, df, ddf), or one of linkwork.functions such as table"
            why = f"offset enters with its time derivatives: give {remedy}"
            raise ModelError(f"{who}: {why}", code="derivatives", subject=who, field="offset")
        given = [_core.CoupledCoordinate(model._core.find_joint(j), which, c) for j, which, c in terms]
        index = model._core.add_coupler(name, given, constant, signal)
        return model._keep("coupler", index, CouplerData(terms))

    def point_on_curve(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        points: VectorLike,
        at: VectorLike,
        closed: bool = False,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Let a point of b stay on a smooth curve that is fixed in a: a rail, a cam track, a roller coaster.

        The curve is the cubic spline through the points with the lengths of the chords as parameter; one that
        is not closed goes on straight beyond its ends. 2 equations.

            cart = model.body("cart", mass=1.0, inertia=(0.1, 0.1, 0.1))
            model.point_on_curve("ground", cart, points=[(0, 0, 0), (1, 0, 0.3), (2, 0, 0)], at=(0, 0, 0))

        points  of the curve (k, 3) [m]: two or more, three or more of a closed one
        at      the point of b (3,) [m], on the curve; a pose that is off it is corrected by `assemble`
        closed  the curve returns from its last point to its first
        frames  "space": points are inertial, at the initial pose; "body": `points` in a, `at` in b

        ModelError: too few points, two that coincide, a curve that turns too sharply for its points.
        """
        model = cast("ModelBuilder", self)
        name = model._named(name, "point_on_curve", model._counts["point_on_curve"])
        subject = Subject("point_on_curve", name, False, 1)
        bodies = model._bodies.pair(a, b, subject)
        if not is_one_of(frames, ("space", "body")):
            subject.refuse(0, f"frames {frames!r:.80} is not 'space' or 'body'", "unknown_option")
        if not isinstance(closed, bool | np.bool_):
            subject.refuse(0, f"closed {closed!r:.80} is not True or False", "closed")
        curve, point = _points(points, subject), subject.array(at, 3, "at")[0]
        (r_a, A_a), (r_b, A_b) = ((q[:3], rotation.matrix(q[3:])) for q in model._core.poses(bodies[0]))
        if frames == "space":
            curve, point = (curve - r_a) @ A_a, (point - r_b) @ A_b
        knots, pieces, across = _spline(curve - curve[0], closed, subject)
        origin, frame = np.stack([curve[0], point])[None], np.broadcast_to(np.eye(3), (1, 2, 3, 3))
        index = model._core.add_point_on_curve(
            name, bodies, origin, frame, knots.tolist(), pieces, across, closed
        )
        return model._keep("point_on_curve", index, CurveData(curve, point, closed))


def _points(points: VectorLike, subject: Subject) -> Floats:
    try:
        array = np.array(reals(points, texts=True))
    except UNREADABLE:
        subject.refuse(0, "points are not made of numbers", "not_a_number")
    if array.ndim != 2 or array.shape[1] != 3:
        subject.refuse(0, f"points have shape {array.shape}, not (k, 3)", "shape")
    if not np.isfinite(array).all():
        k = int(np.argmin(np.isfinite(array).all(axis=1)))
        subject.refuse(0, f"point {k} of the curve, {array[k].tolist()}, is not finite", "not_finite")
    return array


def _spline(points: Floats, closed: bool, subject: Subject) -> tuple[Floats, Floats, Floats]:
    """Knots (k + 1,) and ascending coefficients (k, 4, 3) of the curve and of a direction across it."""
    least = 3 if closed else 2
    if len(points) < least:
        subject.refuse(0, f"{len(points)} points: a curve needs {least} or more", "points")
    with np.errstate(over="ignore"):
        chords = np.linalg.norm(np.diff(_around(points, closed), axis=0), axis=1)
    if not np.isfinite(chords).all():
        k = int(np.argmin(np.isfinite(chords)))
        subject.refuse(0, f"points {k} and {k + 1} of the curve are too far apart", "points")
    if not (chords > 0.0).all():
        k = int(np.argmin(chords))
        subject.refuse(0, f"points {k} and {k + 1} of the curve coincide", "points")
    curve = _curve(points, closed)
    for pieces in (1, 2, 4, 8, 16, 32):
        knots, fine = _refined(curve.x, pieces), _refined(curve.x, pieces * _STEPS)
        tangents = curve(fine, 1)
        speed = np.linalg.norm(tangents, axis=1, keepdims=True)
        if not (speed > _SLOWEST).all():
            k = int(np.argmin(speed)) // (pieces * _STEPS)
            subject.refuse(0, f"the curve turns back after point {k}: move or add points there", "points")
        tangents = tangents / speed
        across = _cubic(knots, _carried(tangents, closed)[::_STEPS], closed)
        e = across(fine)
        off = np.linalg.norm(e - np.sum(e * tangents, axis=1, keepdims=True) * tangents, axis=1)
        if (off > _ACROSS).all():
            return knots, _ascending(curve, knots), _ascending(across, knots)
    k = int(np.argmin(off)) // (pieces * _STEPS)
    subject.refuse(0, f"the curve turns too sharply after point {k}: give more points there", "points")


def _around(points: Floats, closed: bool) -> Floats:
    """Of a closed curve the first point once more at the end."""
    again = closed and not np.array_equal(points[0], points[-1])
    return np.vstack([points, points[:1]]) if again else points


def _curve(points: Floats, closed: bool) -> CubicSpline:
    """The spline over the length of the chords."""
    points = _around(points, closed)
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return _cubic(np.append(0.0, np.cumsum(chords)), points, closed)


def _cubic(x: Floats, y: Floats, closed: bool) -> CubicSpline:
    from scipy.interpolate import CubicSpline  # which takes longer to import than all the rest

    return CubicSpline(x, y, bc_type="periodic" if closed else "natural")


def _refined(knots: Floats, pieces: int) -> Floats:
    """Every piece cut into so many of equal length."""
    count = len(knots) - 1
    return np.interp(np.arange(pieces * count + 1) / pieces, np.arange(count + 1), knots)


def _ascending(of: CubicSpline, knots: Floats) -> Floats:
    """Coefficients (k, 4, 3) of the pieces between these knots, the spline's own among them."""
    start = knots[:-1]
    return np.stack([of(start, m) / math.factorial(m) for m in range(3)] + [_thirds(of, start)], axis=1)


def _thirds(of: CubicSpline, start: Floats) -> Floats:
    """A third derivative jumps at the spline's own knots: what follows them counts."""
    third: Floats = of.c[0][np.searchsorted(of.x[1:-1], start, side="right")]
    return third


def _carried(t: Floats, closed: bool) -> Floats:
    """Unit vectors across a curve with unit tangents t (k, 3) that turn about them as little as can be.

    Each is the one before, turned as the tangent turns; of a closed curve, what is missing at the end is
    spread along it.
    """
    first = np.eye(3)[np.argmin(np.abs(t[0]))]
    e = np.zeros_like(t)
    e[0] = first - (first @ t[0]) * t[0]
    e[0] /= np.linalg.norm(e[0])
    for k in range(1, len(t)):
        e[k] = e[k - 1] - (e[k - 1] @ t[k]) * t[k]
        e[k] /= np.linalg.norm(e[k])
    if closed:
        missing = np.arctan2(np.cross(e[-1], e[0]) @ t[0], e[-1] @ e[0])
        angle = missing * np.linspace(0.0, 1.0, len(t))[:, None]
        e = np.cos(angle) * e + np.sin(angle) * np.cross(t, e)
        e[-1] = e[0]
    return e
