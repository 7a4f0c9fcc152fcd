"""Relative positions that a joint leaves free: angles over full turns, and shifts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from linkwork import rotation
from linkwork.arguments import is_one_of
from linkwork.arrays import Floats, by_value
from linkwork.errors import ModelError
from linkwork.modeling.elements import KINDS


@by_value
class JointCoordinate(NamedTuple):
    """An angle [rad], continued over full turns, or a shift [m] over time, with its rate."""

    value: Floats  #: (k,)
    rate: Floats  #: (k,)


class Side(NamedTuple):
    """One end of a joint over k frames, in space."""

    point: Floats  # (k, 3) [m]
    point_dot: Floats  # (k, 3)
    axes: Floats  # (k, 3, 3) columns x, y, z
    omega: Floats  # (k, 3)

    def axis(self, k: int) -> tuple[Floats, Floats]:
        """A unit vector fixed in the body, and its rate."""
        a = self.axes[:, :, k]
        return a, np.cross(self.omega, a)


def side(q: Floats, v: Floats, s: Floats, C: Floats) -> Side:
    """Of a body with poses q (k, 7) and velocities v (k, 6); s (3,) and C (3, 3) fixed in it."""
    A = rotation.matrix(q[:, 3:])
    arm, omega = A @ s, np.einsum("kij,kj->ki", A, v[:, 3:])
    return Side(q[:, :3] + arm, v[:, :3] + np.cross(omega, arm), A @ C, omega)


def _dot(a: tuple[Floats, Floats], b: tuple[Floats, Floats]) -> tuple[Floats, Floats]:
    """The product of two vectors over time, and its rate."""
    product = np.sum(a[0] * b[0], axis=1)
    return product, np.sum(a[1] * b[0] + a[0] * b[1], axis=1)


def _angle(t: Floats, sine: tuple[Floats, Floats], cosine: tuple[Floats, Floats]) -> JointCoordinate:
    (s, s_dot), (c, c_dot) = sine, cosine
    rate = (c * s_dot - s * c_dot) / (c**2 + s**2)
    return JointCoordinate(continued(t, np.arctan2(s, c), rate), rate)


def continued(t: Floats, angle: Floats, rate: Floats) -> Floats:
    """An angle in (-pi, pi] over full turns: between frames it turns by nearly the mean of their rates.

    Half a turn in the first one is pi, to rounding, as it is for forces.
    """
    angle = np.where(angle < (1e-9 - 0.5) * 2 * np.pi, angle + 2 * np.pi, angle)
    change, expected = np.diff(angle), np.diff(t) * (rate[1:] + rate[:-1]) / 2
    change += 2 * np.pi * np.round((expected - change) / (2 * np.pi))
    return np.concatenate([angle[:1], angle[:1] + np.cumsum(change)])


def _turn(t: Floats, i: Side, j: Side) -> JointCoordinate:
    return _angle(t, _dot(i.axis(1), j.axis(0)), _dot(i.axis(0), j.axis(0)))


def _shift(t: Floats, i: Side, j: Side) -> JointCoordinate:
    value, rate = _dot(i.axis(2), (j.point - i.point, j.point_dot - i.point_dot))
    return JointCoordinate(value, rate)


# Of a Cardan joint, x = z_a x z_b: about z_a turns z_b, which was -y_a; about z_b turns y_b, which was z_a.
def _turn_a(t: Floats, i: Side, j: Side) -> JointCoordinate:
    y, y_dot = i.axis(1)
    return _angle(t, _dot(i.axis(0), j.axis(2)), _dot((-y, -y_dot), j.axis(2)))


def _turn_b(t: Floats, i: Side, j: Side) -> JointCoordinate:
    return _angle(t, _dot(j.axis(0), i.axis(2)), _dot(j.axis(1), i.axis(2)))


#: How each of the coordinates that the compiled kinds name follows from the two sides of a joint.
COORDINATES: Mapping[str, Callable[[Floats, Side, Side], JointCoordinate]] = {
    "angle": _turn,
    "displacement": _shift,
    "angle_a": _turn_a,
    "angle_b": _turn_b,
}


def known_coordinates(kind: str) -> Sequence[str]:
    """Of a kind of joint; none of an unknown kind, from a file of a later version."""
    return tuple(KINDS["joint"][kind].coordinates) if kind in KINDS["joint"] else ()


def coordinate_of(kind: str, name: str, which: str | None) -> str:
    """The coordinate that is meant. ModelError: a joint of this kind has none of this name, or several."""
    known = known_coordinates(kind)
    if not known:
        others = " or ".join(k for k, info in KINDS["joint"].items() if info.coordinates)
        raise ModelError(
            f"{kind} '{name}': has no free coordinates; choose a joint that is {others}", code="coordinate"
        )
    if which is None and len(known) == 1:
        which = known[0]
    if not is_one_of(which, known):
        there = f"it has {' and '.join(known)}"
        given = "say which" if which is None else f"not {which!r:.80}"
        raise ModelError(f"{kind} '{name}': free coordinates: {there}, {given}", code="coordinate")
    assert which is not None
    return which


def coordinates_of(
    which: str, t: Floats, ends: Sequence[tuple[Floats, Floats]], origin: Floats, frame: Floats
) -> JointCoordinate:
    """Of a joint at `origin` (2, 3), axes `frame` (2, 3, 3), between bodies with q (k, 7) and v (k, 6)."""
    i, j = (side(q, v, s, C) for (q, v), s, C in zip(ends, origin, frame, strict=True))
    return COORDINATES[which](t, i, j)
