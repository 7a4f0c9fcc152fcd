"""Singular poses that a driven motion passes on one branch: what lies in and beside them is told from both
sides.

Phi is known to delta by rounding, and so the pose along the weakest direction to delta / sigma; velocities
are off by delta / sigma^2 there, accelerations by delta / sigma^3. On its branch the motion is smooth, and
sigma falls like the way to the pose. States some hundredths of a radian away have nearly all digits, and
tell the others by polynomials.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from linkwork.arrays import Floats
from linkwork.constraints.solver import Constraints, SparseConstraints
from linkwork.constraints.tangent import between, displaced, to_body_axes, to_inertial_axes

__all__ = ["Crossing", "MotionState", "Search", "reach"]

AnyConstraints = Constraints | SparseConstraints

#: A pose whose scaled constraints have a singular value below this is singular, or as good as that.
SINGULAR = 1e-6

#: Minima of that value below this are looked at more closely: they may hide a singular pose.
SUSPICIOUS = 0.05

#: The ways between neighboring states [rad, sizes], and from the pose to the first; the longest that is good.
SPACINGS = 0.015, 0.004, 0.001

#: So many states on a side, where the motion has both; on one side at most; and in all at least.
ON_EACH_SIDE, ON_ONE_SIDE, LEAST = 5, 8, 6

#: From where on either side the pose is looked for, in spacings, and how often.
LOOK, LOOKS = 1.5, 8

#: By how much polynomials may differ with and without the outermost states: good ones, and any, relative.
GOOD, USABLE = 1e-8, 1e-2

#: The same where the motion turns back beside a pose that it does not reach.
TURNING = 1e-6

#: Of times between which sigma changes its sign, where no states tell the pose.
HALVINGS = 20

#: Of the secant method, for the time at which sigma is zero.
ROOT_STEPS = 8

#: A time so near to that of the pose, in spacings, is that of the pose.
SAME = 1e-6

#: So near to a pose, in spacings, equations at the states that are told have no forces.
IN_POSE = 1e-2

#: Multipliers that grow toward the pose by more than these parts of their own size, and of the largest.
GROWS, GROWS_OF_ALL = 1e-6, 1e-9

#: What counts of multipliers, as a part of the largest.
OF_ALL = 1e-6


@dataclass(frozen=True)
class MotionState:
    """The mechanism at one time; omega and its rate in body axes in v and a, inertial in x_dot and x_ddot."""

    t: float
    q: Floats
    v: Floats
    a: Floats
    factors: Callable[[], AnyConstraints]
    history: Floats  # of couplers and force elements, see linkwork.System

    @cached_property
    def constraints(self) -> AnyConstraints:
        return self.factors()

    @property
    def x_dot(self) -> Floats:
        return to_inertial_axes(self.q, self.v)

    @property
    def x_ddot(self) -> Floats:
        return to_inertial_axes(self.q, self.a)


def reach(x: Floats, length: float) -> float:
    """The largest shift in sizes of the mechanism, or angle [rad]."""
    parts = np.abs(x.reshape(-1, 2, 3)).max(axis=(0, 2))
    return float(max(parts[0] / length, parts[1]))


@dataclass(frozen=True)
class Crossing:
    """Singular poses about `t` between regular states of one branch, `spacing` [s] apart.

    The smallest singular value, with its sign, is a smooth function of time: one that passes through zero,
    or, where the motion turns back beside a pose or in it, a parabola.
    """

    t: float
    spacing: float
    states: Sequence[MotionState]  # by time
    sigma: Floats  # of the states, with its sign
    turns: bool  # whether the motion turns back between them
    poses: Sequence[float] = ()  # times at which it is zero [s]
    error: float = np.inf  # of what they tell, relative

    def covers(self, t: float) -> bool:
        """Whether t is nearer to the middle than any of the states."""
        return abs(t - self.t) < (1 - SAME) * self.spacing

    def outside(self, t: float) -> float:
        """The time, or one on its side of a pose in which it is: equations have no forces there."""
        apart = IN_POSE * self.spacing
        for pose in self.poses:
            if abs(t - pose) < apart:
                return pose + apart if t >= pose else pose - apart
        return t

    @cached_property
    def _values(self) -> tuple[Floats, Floats, Floats]:
        """Motions from the first state, velocities and accelerations (k, 6n), inertial."""
        q = self.states[0].q
        x = np.array([between(q, it.q) for it in self.states])
        return x, np.array([it.x_dot for it in self.states]), np.array([it.x_ddot for it in self.states])

    def state(self, t: float, factors: Callable[[float, Floats], AnyConstraints]) -> MotionState:
        """The one on the branch at t."""
        x, x_dot, x_ddot = (self._weights(t) @ values for values in self._values)
        q = displaced(self.states[0].q, x)
        before = [it for it in self.states if it.t <= t] or self.states[:1]
        v, a = to_body_axes(q, x_dot), to_body_axes(q, x_ddot)
        return MotionState(t, q, v, a, lambda: factors(t, q), before[-1].history)

    def _weights(self, t: float, without: int = 0) -> Floats:
        """Of the values in a polynomial at t; without so many states, those farthest from the middle."""
        times = (np.array([it.t for it in self.states]) - self.t) / self.spacing
        kept = np.sort(np.argsort(np.abs(times), kind="stable")[: len(times) - without])
        out = np.zeros(len(times))
        out[kept] = _lagrange(times[kept], (t - self.t) / self.spacing)
        return out

    def doubt(self, values: Floats) -> Floats:
        """By how much the outermost states change the value in the middle."""
        change: Floats = (self._weights(self.t) - self._weights(self.t, 2)) @ values
        return change

    def judged(self, length: float) -> Crossing:
        """With its poses, and its error."""
        x_dot, x_ddot = self._values[1:]
        unit = max([reach(x, length) ** 2 for x in x_dot] + [reach(x, length) for x in x_ddot])
        off = reach(self.doubt(x_ddot), length) / unit
        off = max(off, float(abs(self.doubt(self.sigma)) / np.abs(self.sigma).max()))
        return replace(self, poses=self._zeros(), error=off)

    def _zeros(self) -> list[float]:
        """When sigma is zero: once, twice, or where it only touches zero; by the parabola, then exactly."""
        if not self.turns:
            return [self._zero(self.t)]
        ways = np.array([-0.5, 0.0, 0.5])
        values = [self._weights(t) @ self.sigma for t in self.t + ways * self.spacing]
        bend, slope, middle = map(float, np.polyfit(ways, values, 2))
        least, place = middle - slope**2 / (4 * bend), -slope / (2 * bend)
        if abs(least) <= SAME * np.abs(self.sigma).max():
            return [self.t + place * self.spacing]
        if bend < 0.0 or least > 0.0:
            return []
        half = np.sqrt(-least / bend)
        return [self._zero(float(self.t + (place + side * half) * self.spacing)) for side in (-1, 1)]

    def _zero(self, t: float) -> float:
        """The one near t, by the secant method."""
        times = t, t + self.spacing / 64
        for _ in range(ROOT_STEPS):
            low, high = (float(self._weights(it) @ self.sigma) for it in times)
            if low == high:
                break
            times = times[1], times[1] - high * (times[1] - times[0]) / (high - low)
        return times[1]

    # sigma lambda is smooth, lambda itself where nothing pushes along the other branch
    def multipliers(self, values: Floats, t: Floats) -> tuple[Floats, Floats, float]:
        """At times t (k, m), by those of the states; which of them grow without limit toward a pose (m,);
        and by how much they may be off, relative.

        In the pose these are large numbers of either sign.
        """
        limits = values * self.sigma[:, None]
        sizes, least = np.abs(limits).max(axis=0), SAME * np.abs(self.sigma).max()
        b = np.max([np.abs(self._weights(it) @ limits) for it in self.poses or [self.t]], axis=0)
        grow = b > np.maximum(GROWS * sizes, GROWS_OF_ALL * sizes.max(initial=0.0))
        rows = []
        for weights in map(self._weights, t):
            sigma = weights @ self.sigma
            sigma = np.copysign(max(abs(sigma), least), sigma)
            rows.append(np.where(grow, weights @ limits / sigma, weights @ values))
        off = np.abs(np.where(grow, self.doubt(limits), self.doubt(values)))
        own = np.where(grow, sizes, np.abs(values).max(axis=0))
        unit = np.maximum(own, OF_ALL * own.max(initial=0.0))
        off = np.divide(off, unit, out=np.zeros_like(off), where=unit > 0)
        return np.array(rows).reshape(len(t), len(grow)), grow, float(off.max(initial=0.0))


def _lagrange(times: Floats, t: float) -> Floats:
    """The weights of values at `times` in the polynomial through them at t."""
    apart = times[:, None] - times
    np.fill_diagonal(apart, 1.0)
    ways = np.where(np.eye(len(times), dtype=bool), 1.0, t - times)
    weights: Floats = (ways / apart).prod(axis=1)
    return weights


@dataclass(frozen=True)
class Search:
    """For a pose near a state, by states of its branch."""

    step: Callable[[MotionState, float], MotionState | None]  # to a time nearby, before or after
    smallest: Callable[[MotionState], float]  # singular value
    length: float  # of the mechanism
    begin: float  # the times between which drivers are known, and smooth
    end: float

    def find(self, first: MotionState, second: MotionState) -> Crossing | None:
        """The pose to which sigma leads from the first state by the second."""
        best: Crossing | None = None
        if not self._leads_there(first, second):
            return None
        for way in SPACINGS:
            found = self._at(first, second, way)
            if found is not None and (best is None or found.error < best.error):
                best = found
            if best is not None and best.error < GOOD:
                break
        return best

    def _leads_there(self, first: MotionState, second: MotionState) -> bool:
        """Whether the pose to which sigma leads is beside the second state, or the motion has passed it."""
        pose = self._pose(first, second, 1.0)
        return pose is not None and first.t < pose < second.t + self._spacing(first, second, SPACINGS[0])

    def stands(self, first: MotionState, second: MotionState) -> MotionState | None:
        """One in a pose that is not crossed by such states: the second, or one between, where sigma changes
        its sign."""
        if self.smallest(first) < SINGULAR:
            return None  # which has been told
        if self.smallest(second) < SINGULAR:
            return second
        low, high, best = first, second, second
        for _ in range(HALVINGS):
            if _turned(low, high) > 0:
                return None
            middle = self.step(low, (low.t + high.t) / 2)
            if middle is None:
                break
            best = min(best, middle, key=self.smallest)
            if self.smallest(middle) < SINGULAR:
                break
            low, high = (low, middle) if _turned(low, middle) < 0 else (middle, high)
        return best if self.smallest(best) < SUSPICIOUS else None

    def _spacing(self, first: MotionState, second: MotionState, way: float) -> float:
        """[s] that the motion needs for it, by the state that is known better; 0: it rests."""
        it = max((first, second), key=self.smallest)
        rate, rise = reach(it.x_dot, self.length), reach(it.x_ddot, self.length)
        whole = rate + np.sqrt(rate**2 + 2 * rise * way)
        return float(2 * way / whole) if whole > 0.0 else 0.0

    def _pose(self, first: MotionState, second: MotionState, sign: float) -> float | None:
        """By a line through the two values of sigma, the first of this sign; None: they are the same."""
        low = sign * self.smallest(first)
        high = sign * _turned(first, second) * self.smallest(second)
        return None if low == high else first.t + (second.t - first.t) * low / (low - high)

    def _at(self, first: MotionState, second: MotionState, way: float) -> Crossing | None:
        """With states so far apart at both sides of the pose, which begins as a guess."""
        low, sign, pose = first, 1.0, self._pose(first, second, 1.0)
        spacing = self._spacing(first, second, way)
        for _ in range(LOOKS):
            if pose is None or spacing == 0.0 or not self.begin - spacing < pose < self.end + spacing:
                return None
            times = self._sides(pose, spacing)
            near = self.step(low, times[0])
            beyond = None if near is None else self.step(near, times[1])
            if near is None or beyond is None:
                return None
            sign *= _turned(low, near)
            low, last, former = near, pose, spacing
            vertex = self._vertex(near, beyond) if near.t < pose < beyond.t else None
            pose = self._pose(near, beyond, sign) if vertex is None else vertex
            spacing = self._spacing(near, beyond, way)
            if pose is not None and abs(pose - last) < spacing / 4 and abs(spacing - former) < spacing / 4:
                return self._between(near, beyond, pose, spacing)
        return None

    def _vertex(self, near: MotionState, beyond: MotionState) -> float | None:
        """Where sigma has a minimum between them, by a parabola; None: it has none, or changes its sign."""
        if _turned(near, beyond) < 0:
            return None
        outer = self.step(near, near.t - (beyond.t - near.t) / 2)
        if outer is None or outer.t < self.begin:
            return None
        ways = np.array([it.t - near.t for it in (outer, near, beyond)]) / (beyond.t - near.t)
        bend, slope, _ = np.polyfit(ways, [self.smallest(it) for it in (outer, near, beyond)], 2)
        part = -slope / (2 * bend) if bend > 0.0 else 0.0
        return float(near.t + part * (beyond.t - near.t)) if 0.0 < part < 1.0 else None

    def _sides(self, pose: float, spacing: float) -> tuple[float, float]:
        """Times before and after it, or two on one side where the motion ends, or begins."""
        if pose + LOOK * spacing > self.end:
            return pose - 2 * LOOK * spacing, pose - LOOK * spacing
        if pose - LOOK * spacing < self.begin:
            return pose + LOOK * spacing, pose + 2 * LOOK * spacing
        return pose - LOOK * spacing, pose + LOOK * spacing

    def _between(self, low: MotionState, high: MotionState, pose: float, spacing: float) -> Crossing | None:
        before: list[MotionState] = []
        after: list[MotionState] = []
        if low.t < pose:
            before = self._walk(high if high.t < pose else low, pose, -spacing, range(1, ON_EACH_SIDE + 1))
        if high.t > pose:
            after = self._walk(low if low.t > pose else high, pose, spacing, range(1, ON_EACH_SIDE + 1))
        for side, other, way in ((before, after, -spacing), (after, before, spacing)):
            more = min(2 * ON_EACH_SIDE - len(other), ON_ONE_SIDE)
            if side and more > len(side):
                side.extend(self._walk(side[-1], pose, way, range(len(side) + 1, more + 1)))
        states = [*before[::-1], *after]
        if len(states) < LEAST:
            return None
        turns = bool(before and after) and _turned(before[0], after[0]) > 0
        signs = [1.0 if turns or it.t > pose else -1.0 for it in states]
        sigma = np.array([sign * self.smallest(it) for sign, it in zip(signs, states, strict=True)])
        return self._usable(Crossing(pose, spacing, states, sigma, turns).judged(self.length))

    def _usable(self, crossing: Crossing) -> Crossing | None:
        """None: what the states tell is not smooth, or of no pose."""
        within = all(abs(it - crossing.t) < crossing.spacing for it in crossing.poses)
        return crossing if within and crossing.error < (USABLE if crossing.poses else TURNING) else None

    def _walk(self, last: MotionState, pose: float, spacing: float, places: range) -> list[MotionState]:
        """States at these places, in spacings from the pose, as many as there are."""
        found: list[MotionState] = []
        for k in places:
            t = pose + k * spacing
            following = self.step(last, t) if self.begin <= t <= self.end else None
            if following is None:
                break
            found.append(following)
            last = following
        return found


def _turned(first: MotionState, second: MotionState) -> float:
    """Whether sigma has changed its sign: -1."""
    return -1.0 if first.constraints.turns(second.constraints) else 1.0
