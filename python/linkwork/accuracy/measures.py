"""By how much a motion differs from the reference: poses, velocities, reactions, over time.

At each time the largest over the bodies counts (over the joints with unique reactions), scaled so that 1
means "as large as the motion itself":

    pose error      max(|r - r*|, L phi) / L,  phi the angle [rad] of the rotation A(p)^T A(p*)
    velocity error  max(|r_dot - r_dot*| / V, |omega - omega*| / Omega)
    state error     the larger of the two
    reaction error  max(|F - F*|, |T - T*| / L) / F_max

with the `Scales` L, V, Omega, F_max of the reference, the starred quantities: each connected part of a
mechanism has its own, as if it were alone. L and V are those of its motion in axes that move with the part
as a whole, at the mean velocity of its center of mass: a uniform motion changes no error, and no scale
(Galilei), nor does what rests, moves or flies along beside it.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats, ReadOnly
from linkwork.errors import OptionError
from linkwork.modeling.elements import KINDS
from linkwork.motion.records import rotate

if TYPE_CHECKING:
    from linkwork.motion.header import Header
    from linkwork.results.result import Result

__all__ = [
    "MOVING", "AtRest", "Bodies", "Differences", "Lateness", "Sampled", "Scales", "rounding_of", "same_times",
]  # fmt: skip

#: Frames over which it is found how late a motion is: this share of all, and at least so many, or half of
#: few; where squared speeds are less than this part of their mean, nobody can tell.
LATE, LATE_FRAMES, SLOW = 0.02, 10, 0.1

#: Two times are the same, relative to the later one.
SAME_TIME = 1e-9


@dataclass(frozen=True)
class Sampled(ReadOnly):
    """The frames of a result that a comparison needs; k times, n bodies, j joints with unique reactions."""

    t: Floats  # (k,) [s]
    q: Floats  # (k, n, 7) position [m], Euler parameters
    v: Floats  # (k, n, 6) velocity, inertial [m/s]; angular velocity, body axes [rad/s]
    force: Floats  # (k, j, 3) inertial [N]
    torque: Floats  # (k, j, 3) inertial, at the joint's point [N m]

    @classmethod
    def of(cls, result: Result) -> Sampled:
        unique = result.unique_reactions
        reactions = result.reactions()
        return cls(result.t, result.q, result.v, reactions.force[:, unique], reactions.torque[:, unique])

    def at(self, times: Floats) -> tuple[Sampled, NDArray[np.intp]]:
        """The frames at those of the `times` that are here, and their places among `times`."""
        taken, places = same_times(self.t, times)
        values = (getattr(self, field.name)[taken] for field in fields(self))
        return Sampled(*values), places


def same_times(t: Floats, times: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Places in `t` and in `times` of those that both have; `t` is ascending."""
    if not len(t):
        return np.zeros(0, np.intp), np.zeros(0, np.intp)
    after = np.clip(np.searchsorted(t, times), 1, max(len(t) - 1, 1))
    before = after - 1
    after = np.minimum(after, len(t) - 1)
    nearest = np.where(np.abs(t[after] - times) < np.abs(t[before] - times), after, before)
    near = np.abs(t[nearest] - times) <= rounding_of(times)
    return nearest[near], np.flatnonzero(near)


def rounding_of(times: Floats) -> float:
    """By which times that are one may differ [s]."""
    return SAME_TIME * max(float(np.abs(times).max(initial=0)), 1e-300)


#: Of the largest coordinate: where a center of mass moves no more, seen from the part as a whole, it is none.
ROUNDING = 1e-12

#: Of the radius of gyration: nearer to a center of mass joints give a body no size.
NEXT_TO = 1e-3

#: What moves less is at rest, and what is left of it is rounding: of the length over the whole run.
STILL = 1e-6


class AtRest(NamedTuple):
    """L and V of what forces leave at rest, by body or for all: the size of its part, and the speed of a fall
    by that; 0 of what moves."""

    length: Floats | float  #: m
    speed: Floats | float  #: m/s


MOVING = AtRest(0.0, 0.0)


class Bodies(NamedTuple):
    """What there is to know of n bodies to weigh their motion; they make up p connected parts."""

    masses: Floats  #: (n,) [kg]
    part: NDArray[np.integer]  #: (n,) of each the connected part: joints and forces connect, the ground not
    longest: Floats  #: (p,) way from a center of mass to a joint, or between points that one keeps apart [m]
    gyration: Floats  #: (p,) least radius of gyration, by the trace of the inertia [m]; infinite: none
    joint_part: NDArray[np.integer]  #: (j,) of the joints with unique reactions

    @classmethod
    def of(cls, header: Header) -> Bodies:
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

        joints = header.joint_bodies
        pairs = np.concatenate([joints, header.force_bodies]).astype(np.int64)
        first, second = pairs[(pairs >= 0).all(axis=1)].T
        count = len(header.mass)
        edges = coo_array((np.ones(len(first)), (first, second)), shape=(count, count))
        part = connected_components(edges, directed=False)[1] if count else np.zeros(0, np.intp)
        arms = np.linalg.norm(header.joint_origin, axis=-1)
        longest = _by_part(arms[joints >= 0], part[joints[joints >= 0]], int(part.max(initial=-1)) + 1)
        which, apart = _kept_apart(header)
        np.maximum.at(longest, part[joints[which].max(axis=1)], apart)
        unique = joints[header.reaction_unique].max(axis=1, initial=-1)  # not the ground
        mass = np.where(header.mass > 0.0, header.mass, np.nan)
        squares = np.trace(header.inertia, axis1=1, axis2=2) / mass
        gyration = np.full(len(longest), np.inf)
        np.fmin.at(gyration, part, np.sqrt(np.where(squares > 0.0, squares, np.nan)))
        return cls(header.mass, part, longest, gyration, part[unique])

    def size(self) -> Floats:
        """Of the bodies of each part (p,): the longest way, or, where joints are at centers of mass, the
        radius of gyration; 1 where there is neither [m]. Verdicts have the same (Dynamics.part_sizes)."""
        extended = np.isfinite(self.gyration)
        small = extended & (self.longest < NEXT_TO * self.gyration)
        return np.where(small, self.gyration, _or_one(self.longest))


def _kept_apart(header: Header) -> tuple[NDArray[np.intp], Floats]:
    """Joints that keep two points apart, and by how much they do in the initial pose [m]."""
    kinds = {kind for kind, it in KINDS["joint"].items()
             if any(equation.quantity == "distance" for equation in it.equations.values())}  # fmt: skip
    which = np.array([k for k, kind in enumerate(header.joint_kinds) if kind in kinds], dtype=np.intp)
    bodies, points, q = header.joint_bodies[which], header.joint_origin[which], header.q0.reshape(-1, 7)
    there = q[bodies, :3] + rotate(q[bodies, 3:], points) if len(q) else points
    there = np.where((bodies >= 0)[..., None], there, points)
    return which, np.linalg.norm(there[:, 0] - there[:, 1], axis=-1)


@dataclass(frozen=True)
class Scales(ReadOnly):
    """What errors are divided by, of p connected parts, in axes that move with each; 1 where nothing moves or
    pulls."""

    length: Floats  #: (p,) L: half the diagonal of the box in which centers move, or the longest way [m]
    speed: Floats  #: (p,) V: largest of |r_dot| and s |omega|, s the size of the bodies [m/s]
    turning: Floats  #: (p,) Omega: largest of |omega| and V / L [rad/s]
    force: Floats  #: (p,) F_max: largest of |F| and |T| / L of the unique reactions [N]
    part: NDArray[np.integer]  #: (n,) of each body
    joint_part: NDArray[np.integer]  #: (j,) of each joint with unique reactions

    @classmethod
    def of(
        cls,
        motion: Sampled,
        bodies: Bodies,
        tolerance: float | None = None,
        at_rest: AtRest = MOVING,
    ) -> Scales:
        """`at_rest`: see AtRest.

        What goes no farther than `STILL`, or the `tolerance` that steps follow, of the length is at rest: its
        trembling is weighed by the speed that the largest reaction gives to the mass of its part.
        """
        part, count = bodies.part, len(bodies.longest)
        r, r_dot = _in_moving_axes(motion, bodies)
        fallen, speed = (_by_part(np.broadcast_to(it, part.shape), part, count) for it in at_rest)
        boxes, far = _half_boxes(r, part, count), _by_part(_largest(motion.q[:, :, :3]), part, count)
        boxes[boxes <= ROUNDING * far] = 0.0
        length = _or_one(np.max([boxes, bodies.longest, fallen], axis=0))
        turning = _by_part(_largest(motion.v[:, :, 3:]), part, count)
        own = np.maximum(_by_part(_largest(r_dot), part, count), bodies.size() * turning)
        speed = np.maximum(speed, own)
        pull = np.maximum(_largest(motion.force), _largest(motion.torque) / length[bodies.joint_part])
        force = _by_part(pull, bodies.joint_part, count)
        duration = float(np.ptp(motion.t)) if len(motion.t) else 0.0
        speed = np.maximum(speed, STILL * length / duration if duration > 0.0 else 0.0)
        still = max(STILL, tolerance or 0.0)
        mass = np.bincount(part, bodies.masses, count)
        way = _by_part(_way(r, motion.q[:, :, 3:], length[part]), part, count)
        rests = (mass > 0.0) & (way <= still * length)
        shaken = still * np.sqrt(force * length / np.where(mass > 0.0, mass, 1.0))
        speed = _or_one(np.where(rests, np.maximum(speed, shaken), speed))
        turning = np.maximum(turning, speed / length)
        return cls(length, speed, turning, _or_one(force), part, bodies.joint_part)

    def numbers(self) -> dict[str, float | list[float]]:
        """L, V, Omega and F_max: one number each, or a list, of several parts."""
        found = {name: getattr(self, name).tolist() for name in ("length", "speed", "turning", "force")}
        return {name: values[0] if len(values) == 1 else values for name, values in found.items()}


@dataclass(frozen=True)
class Differences(ReadOnly):
    """From the reference, at k times, of n bodies and j joints."""

    t: Floats  # (k,) [s]
    position: Floats  # (k, n) [m]
    rotation: Floats  # (k, n) [rad]
    velocity: Floats  # (k, n) [m/s]
    omega: Floats  # (k, n) [rad/s]
    force: Floats  # (k, j) [N]
    torque: Floats  # (k, j) [N m]

    @classmethod
    def between(cls, motion: Sampled, reference: Sampled) -> Differences:
        """At the times that both have. OptionError: they have none but the start."""
        exact, places = reference.at(motion.t)
        if len(places) < min(2, len(motion.t)):
            raise OptionError(
                f"the reference has {len(reference.t)} frames from {reference.t[0]:g} to "
                f"{reference.t[-1]:g} s, none at the times of the run; record it at multiples of the steps",
                code="reference",
            )
        q, v = motion.q[places], motion.v[places]
        return cls(
            t=motion.t[places],
            position=_norms(q[:, :, :3] - exact.q[:, :, :3]),
            rotation=_angle(q[:, :, 3:], exact.q[:, :, 3:]),
            velocity=_norms(v[:, :, :3] - exact.v[:, :, :3]),
            omega=_norms(v[:, :, 3:] - exact.v[:, :, 3:]),
            force=_norms(motion.force[places] - exact.force),
            torque=_norms(motion.torque[places] - exact.torque),
        )

    # The largest of any body or joint at each time (k,); NaN where there is none.

    def pose(self, scales: Scales) -> Floats:
        return _at_each_time(self._poses(scales))

    def velocities(self, scales: Scales) -> Floats:
        return _at_each_time(self._velocities(scales))

    def state(self, scales: Scales) -> Floats:
        return _at_each_time(self.states(scales))

    def reaction(self, scales: Scales) -> Floats:
        length, force = (it[scales.joint_part] for it in (scales.length, scales.force))
        return _at_each_time(np.maximum(self.force, self.torque / length) / force)

    def states(self, scales: Scales) -> Floats:
        """Of each body (k, n)."""
        states: Floats = np.maximum(self._poses(scales), self._velocities(scales))
        return states

    def _poses(self, scales: Scales) -> Floats:
        poses: Floats = np.maximum(self.position / scales.length[scales.part], self.rotation)
        return poses

    def _velocities(self, scales: Scales) -> Floats:
        speed, turning = (it[scales.part] for it in (scales.speed, scales.turning))
        velocities: Floats = np.maximum(self.velocity / speed, self.omega / turning)
        return velocities


# dt = sum <dy, y'> / sum <y', y'> over some frames, <a, b> = a_r . b_r + L^2 a_theta . b_theta
class Lateness(NamedTuple):
    """By how much a motion is late or early, in the mean over some frames."""

    begin: Floats  #: of these (w,) [s]
    end: Floats  #: (w,) [s]
    by: Floats  #: of each connected part, what of its difference from the reference is along it (w, p) [s]

    @classmethod
    def of(cls, motion: Sampled, reference: Sampled, bodies: Bodies, scales: Scales) -> Lateness | None:
        """None: there are too few frames to tell."""
        _, ours = same_times(reference.t, motion.t)
        width = max(round(LATE * len(ours)), min(LATE_FRAMES, len(ours) // 2), 2)
        if len(ours) < width or not len(bodies.part):
            return None
        t = motion.t[ours]
        exact, _ = reference.at(t)
        turned = scales.length[bodies.part] ** 2
        r_dot, omega = _in_moving_axes(exact, bodies)[1], exact.v[:, :, 3:]
        scalar, vector = _turn(exact.q[:, :, 3:], motion.q[ours, :, 3:])
        angle = 2 * np.where(scalar < 0, -1.0, 1.0)[..., None] * vector
        along = np.sum((motion.q[ours, :, :3] - exact.q[:, :, :3]) * r_dot, axis=2)
        along += turned * np.sum(angle * omega, axis=2)
        speed = np.sum(r_dot**2, axis=2) + turned * np.sum(omega**2, axis=2)
        order = np.argsort(bodies.part, kind="stable")
        begins = np.searchsorted(bodies.part[order], np.arange(len(bodies.longest)))
        of_parts = [np.add.reduceat(it[:, order], begins, axis=1) for it in (along, speed)]
        sums = [np.cumsum(np.pad(it, ((1, 0), (0, 0))), axis=0) for it in of_parts]
        along, speed = (it[width:] - it[:-width] for it in sums)
        moves = speed > SLOW * speed.mean(axis=0)
        late = np.divide(np.abs(along), speed, out=np.zeros_like(along), where=moves)
        return cls(t[: len(t) - width + 1], t[width - 1 :], late)


def _in_moving_axes(motion: Sampled, bodies: Bodies) -> tuple[Floats, Floats]:
    """Positions and velocities (k, n, 3) in axes with the mean velocity of the center of each part."""
    r, r_dot = motion.q[:, :, :3], motion.v[:, :, :3]
    if not r.size or not np.ptp(motion.t) > 0.0:
        return r, r_dot
    mass = np.bincount(bodies.part, bodies.masses)
    weights = np.where(mass[bodies.part] > 0.0, bodies.masses, 1.0)
    since = motion.t - motion.t[0]
    moved = weights[:, None] * (r[-1] - r[0])
    centers = np.stack([np.bincount(bodies.part, along) for along in moved.T], axis=1)
    velocity = centers / np.bincount(bodies.part, weights)[:, None] / since[-1]
    velocity = np.where(np.isfinite(velocity).all(axis=1, keepdims=True), velocity, 0.0)[bodies.part]
    return r - since[:, None, None] * velocity, r_dot - velocity


def _by_part(values: Floats, part: NDArray[np.integer], count: int) -> Floats:
    """Largest of each part (count,); 0 where it has none."""
    largest = np.zeros(count)
    np.maximum.at(largest, part, values)
    return largest


def _or_one(scales: Floats) -> Floats:
    scales = np.where(scales > 0.0, scales, 1.0)
    return scales


def _half_boxes(r: Floats, part: NDArray[np.integer], count: int) -> Floats:
    """Of the centers of mass (k, n, 3) of each part half the diagonal of the box in which they move [m]."""
    if not r.size:
        return np.zeros(count)
    low, high = np.full((2, count, 3), np.inf)
    np.minimum.at(low, part, r.min(axis=0))
    np.minimum.at(high, part, -r.max(axis=0))
    half: Floats = np.linalg.norm(high + low, axis=1) / 2
    return half


def _way(r: Floats, p: Floats, length: Floats) -> Floats:
    """How far each body goes from where it begins, or turns by an arm of this length [m]; (k, n, 3 and 4)."""
    if not r.size:
        return np.zeros(r.shape[1])
    moved, turned = (np.abs(it - it[0]).max(axis=(0, 2)) for it in (r, p))
    way: Floats = np.maximum(moved, 2 * length * turned)
    return way


def _norms(vectors: Floats) -> Floats:
    lengths: Floats = np.linalg.norm(vectors, axis=-1)
    return lengths


def _largest(vectors: Floats) -> Floats:
    """Longest of each body or joint (n,) over the times, of vectors (k, n, 3)."""
    longest: Floats = _norms(vectors).max(axis=0, initial=0.0)
    return longest


def _at_each_time(values: Floats) -> Floats:
    """Largest of the values (k, n); NaN where there are none."""
    largest: Floats = values.max(axis=1) if values.shape[1] else np.full(len(values), np.nan)
    return largest


def _angle(p: Floats, exact: Floats) -> Floats:
    """Angle of the rotation A(p)^T A(p*) [rad], with full accuracy for small ones: 2 atan2(|e|, |e0|)."""
    scalar, vector = _turn(p, exact)
    angle: Floats = 2 * np.arctan2(np.linalg.norm(vector, axis=-1), np.abs(scalar))
    return angle


# e0 = p . p*,  e = p0 e* - p0* e - e x e*
def _turn(p: Floats, other: Floats) -> tuple[Floats, Floats]:
    """Euler parameters of the rotation A(p)^T A(p*): e0 (...) and e (..., 3)."""
    e, e_other = p[..., 1:], other[..., 1:]
    return np.sum(p * other, axis=-1), p[..., :1] * e_other - other[..., :1] * e - np.cross(e, e_other)
