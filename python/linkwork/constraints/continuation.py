"""The motion of a mechanism that drivers move, followed from pose to pose on one branch."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.constraints import solver
from linkwork.constraints.equations import LISTED, Equations, Sparse
from linkwork.constraints.rolling import rolled
from linkwork.constraints.solver import (
    Constraints,
    SparseConstraints,
    constraints_of,
    free_motions,
    strongest,
)
from linkwork.constraints.tangent import displaced, to_body_axes, to_inertial_axes
from linkwork.errors import ModelError, NotConvergedError
from linkwork.motion.records import Snapshot

__all__ = ["SINGULAR", "SUSPICIOUS", "Continuation", "Impasse", "MotionState", "named"]

AnyConstraints = Constraints | SparseConstraints

#: The smallest singular value at the start as a part of what counts as one, see SparseConstraints.
USUAL = 0.1

#: A pose whose scaled constraints have a singular value below this is singular, or as good as that.
SINGULAR = 1e-6

#: Minima of that value below this are looked at more closely: they may hide a singular pose.
SUSPICIOUS = 0.05

#: The most a predictor may move a body [rad, sizes of the mechanism], and the correction as a part of it.
LIMITS = _core.DrivenLimits()
LONGEST_STEP, LARGEST_CORRECTION = LIMITS.longest_step, LIMITS.largest_correction

#: Motions [rad, sizes] of a step that look like none, and where inside of it they are looked at.
HARDLY, INSIDE = 1e-2, 0.618

#: From where a singular pose takes the velocity that it leaves open, as a part of the step.
NEARBY = 1e-2

#: Of the largest rate that a driver asks for: what no velocity gives, where that is no rounding.
ASKED = 1e-3

#: The shortest step, as a part of the way, which is the time between two frames in `kinematics`.
SHORTEST_STEP = 2.0**-40

#: Of times, relative.
ROUNDING_OF_TIMES = 4 * np.finfo(float).eps

#: Violations of joints, relative to the size of the mechanism, of a pose in which all hold.
CLOSED = LIMITS.closed

#: Corrections relative to the size of the mechanism at which Newton's method ends.
CONVERGED, ITERATIONS = LIMITS.converged, LIMITS.iterations


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


@dataclass(frozen=True)
class Impasse:
    """The pose beyond which no motion was found."""

    time: float  # [s]
    joints: list[str]  # whose equations depend on each other there, the strongest first
    sigma: float  # the smallest singular value
    driven: bool  # whether a driver asks for a velocity that they do not allow: u D = 0, and u Phi_t is not

    @property
    def dead(self) -> bool:
        return self.sigma < SUSPICIOUS

    def __str__(self) -> str:
        pose = "a dead point" if self.dead else "a pose"
        return (
            f"{pose} where the equations of {named(self.joints)} depend on each other (smallest singular "
            f"value {self.sigma:.2g})"
        )


@dataclass
class Continuation:
    """Follows the motion in steps that the predictor can answer for."""

    equations: Equations
    t_end: float
    at: MotionState = field(init=False)
    unit: float = 1.0  # of singular values
    shortest: float = SHORTEST_STEP  # as a part of the way
    most_seconds: float = math.inf  # from now on
    beside: bool = False  # a singular pose, which is left on both of its sides
    watch: Callable[[MotionState, MotionState], None] | None = None  # told of the ends of each step
    crossings: list[dict[str, Any]] = field(default_factory=list)
    counts: dict[str, int] = field(
        default_factory=lambda: {"steps": 0, "evaluations": 0, "factorizations": 0}
    )

    @property
    def rank(self) -> int:
        """How many rows of D are independent away from singular poses; 6n, or freedoms are left."""
        return 6 * self.equations.core.body_count - self.equations.rank.degrees_of_freedom

    def _accept(self, state: MotionState) -> None:
        self.at = state
        self.equations.dynamics.history = state.history

    def __post_init__(self) -> None:
        self._ends = time.monotonic() + self.most_seconds

    def _constraints(self, D: Sparse) -> AnyConstraints:
        """TimeoutError: the time for all of them is over."""
        if time.monotonic() > self._ends:
            raise TimeoutError
        self.counts["factorizations"] += 1
        return constraints_of(self.equations, D, self.unit)

    def jump(self, t: float, q: Floats, v: Floats, a: Floats, history: Floats) -> None:
        """To where the motion has been found to go."""
        terms, constraints = self.equations.terms, self._constraints
        self._accept(MotionState(t, q, v, a, lambda: constraints(terms(t, q).D), history))

    def prepare(self) -> None:
        """ModelError: freedoms are left. SingularSystemError: a large model in a singular pose."""
        eq = self.equations
        q0 = np.array(eq.core.q0)
        if eq.rank.degrees_of_freedom > 0:
            self._refuse_freedoms(q0)
        self.measure()

    def measure(self) -> None:
        """The unit of singular values. SingularSystemError: a large model in a singular pose."""
        eq = self.equations
        if self.rank > solver.DENSE:
            start = SparseConstraints.of(eq, eq.terms(0.0, np.array(eq.core.q0)).D)
            self.unit = float(np.clip(start.sigma / USUAL, 1e-6, 1.0))

    def begin(self) -> None:
        """Onto the constraints at t = 0. NotConvergedError."""
        eq = self.equations
        q0 = np.array(eq.core.q0)
        start = self._constraints(eq.terms(0.0, q0).D)
        q = self._corrected(0.0, q0, start)
        if q is None:
            raise self._no_start()
        self._accept(self._state(0.0, q, None))

    def begin_near(self, state: Snapshot, largest: float) -> bool:
        """Onto the constraints by a correction up to `largest` [rad, sizes]; False: that takes more."""
        t, q, v = state.t, np.ravel(state.q), np.ravel(state.v)
        self.equations.dynamics.history = np.asarray(state.history, dtype=float)
        found = self._corrected(t, q, self._constraints(self.equations.terms(t, q).D), largest)
        if found is not None:
            self._accept(self._completed(t, found, to_inertial_axes(found, v), np.zeros(v.size)))
        return found is not None

    def way_to(self, t: float) -> float:
        """How far bodies come until then as they move now, at most [rad, sizes]."""
        return _reach((t - self.at.t) * self.at.x_dot, self.equations.length)

    def go_to(self, t: float) -> None:
        """NotConvergedError: there is no way to go on."""
        h = t - self.at.t
        smallest, soon = self.shortest * h, max(LIMITS.touch_part * h, ROUNDING_OF_TIMES * t)
        while self.at.t < t:
            last = self.at.t + h >= t - smallest
            found = self._step(t if last else self.at.t + h)
            if found is None or (h > soon and self._touches(found)):
                h = min(h, t - self.at.t) / 2
                if h < smallest:
                    self._refuse_to_go_on(t)
            else:
                before = self.at
                self._accept(found)
                self.counts["steps"] += 1
                h *= 2
                if self.watch is not None:
                    self.watch(before, found)

    def _touches(self, found: MotionState) -> bool:
        """Whether a contact begins on the way: its force depends on the speed there."""
        return bool(self.equations.dynamics.begins_contact(self.at.history, found.history))

    def soon_after(self, first: MotionState, t: float) -> MotionState | None:
        """The mechanism soon after `first`, without going there."""
        kept, watch = self.at, self.watch
        self.watch = None
        self._accept(first)
        try:
            self.go_to(t)
            return self.at
        except NotConvergedError:
            return None
        finally:
            self._accept(kept)
            self.watch = watch

    def _step(self, t: float) -> MotionState | None:
        """q + h v + h^2 v_dot / 2, corrected; None: the step is too long for the predictor to be trusted."""
        at, h = self.at, t - self.at.t
        length = self.equations.length
        x = h * at.x_dot + h * h / 2 * at.x_ddot
        moved = _reach(x, length)
        if moved > LONGEST_STEP or (moved < HARDLY and not self._foreseen(h)):
            return None
        predicted = displaced(at.q, x) if self.equations.holonomic.all() else self._rolled(t)
        q = self._corrected(t, predicted, at.constraints, max(LARGEST_CORRECTION * moved, 1e-9))
        if q is None:
            return None
        state = self._state(t, q, at)
        if state.constraints.rank == self.rank:
            return state
        if self.beside or at.constraints.rank < self.rank:
            return None  # singular poses one after the other: no step, however short, leaves them
        return self._singular(state, h) if h > 1e-6 * max(t, 1e-3 * self.t_end) else state

    def _foreseen(self, h: float) -> bool:
        """Whether drivers do nothing else within the step: a whole turn looks like none at its end."""
        at, part = self.at, INSIDE * h
        predicted = displaced(at.q, part * at.x_dot + part * part / 2 * at.x_ddot)
        Phi = self.equations.Phi(at.t + part, predicted)
        return self.equations.violation(np.where(self.equations.holonomic, Phi, 0.0)) < HARDLY

    def _rolled(self, t: float) -> Floats:
        """q at t by integration of D v = -Phi_t, where joints restrict velocities only."""

        def velocity(t: float, q: Floats) -> Floats:
            terms = self.equations.terms(t, q)
            self.counts["evaluations"] += 1
            return self._constraints(terms.D).solve(-terms.Phi_t)

        return rolled(self.at.q, velocity, self.at.t, t)

    def _singular(self, state: MotionState, h: float) -> MotionState | None:
        """The same, with the velocity and acceleration that it leaves open from both sides of it.

        Hermite's interpolation: f(t) = (f_1 + f_2) / 2 + (t_2 - t_1) (f_1' - f_2') / 8 in the middle.
        """
        d = NEARBY * h
        self.beside = True
        try:
            before = self.soon_after(self.at, state.t - d)
            if before is None:
                return None
            after = self.soon_after(before, state.t + d) if state.t + d <= self.t_end else None
        finally:
            self.beside = False
        if after is None:
            return self._state(state.t, state.q, before)
        x_ddot = (before.x_ddot + after.x_ddot) / 2
        x_dot = (before.x_dot + after.x_dot) / 2 + d / 4 * (before.x_ddot - after.x_ddot)
        return self._completed(state.t, state.q, x_dot, x_ddot)

    # Newton's method with the D of the last moment, renewed where it converges slowly
    def _corrected(
        self, t: float, q: Floats, constraints: AnyConstraints, largest: float = np.inf
    ) -> Floats | None:
        eq, total, before = self.equations, 0.0, np.inf
        for _ in range(ITERATIONS):
            Phi = eq.Phi(t, q)
            self.counts["evaluations"] += 1
            x = constraints.solve(-Phi)
            size = _reach(x, eq.length)
            total += size
            if not np.isfinite(size) or total > largest:
                return None
            if size > 0.1 * before:
                if before < LIMITS.rounding:
                    return displaced(q, x) if self._closed(Phi) else None
                constraints = self._constraints(eq.terms(t, q).D)
                x = constraints.solve(-Phi)
                size = _reach(x, eq.length)
            q, before = displaced(q, x), size
            if size < CONVERGED:
                return q if self._closed(eq.Phi(t, q)) else None
        return q if before < 10 * LIMITS.rounding and self._closed(eq.Phi(t, q)) else None

    def _closed(self, Phi: Floats) -> bool:
        """Whether redundant equations hold as well as the others."""
        return bool(self.equations.violation(Phi) < CLOSED + self.equations.rounding)

    def _state(self, t: float, q: Floats, last: MotionState | None) -> MotionState:
        """With velocities and accelerations; what a singular pose leaves open goes on as before."""
        if last is None:
            still = np.zeros(6 * self.equations.core.body_count)
            return self._completed(t, q, still, still)
        return self._completed(t, q, last.x_dot + (t - last.t) * last.x_ddot, last.x_ddot)

    def _completed(self, t: float, q: Floats, x_dot: Floats, x_ddot: Floats) -> MotionState:
        """With the velocities and accelerations nearest to these."""
        terms = self.equations.terms(t, q)
        constraints = self._constraints(terms.D)
        v = to_body_axes(q, x_dot - constraints.solve(terms.D @ x_dot + terms.Phi_t))
        gamma = self.equations.terms(t, q, v).gamma
        a = to_body_axes(q, x_ddot - constraints.solve(terms.D @ x_ddot - gamma))
        self.counts["evaluations"] += 2
        history = self.equations.dynamics.advanced_history(t, q, v)
        return MotionState(t, q, v, a, lambda: constraints, history)

    # --- what cannot be done ---

    def _refuse_freedoms(self, q: Floats) -> None:
        eq = self.equations
        count = eq.rank.degrees_of_freedom
        Z = free_motions(eq, eq.terms(0.0, q).D, min(count, LISTED))
        left = [eq.motion(z) for z in Z.T]
        what = "1 freedom is" if count == 1 else f"{count} freedoms are"
        raise ModelError(
            f"kinematics: {what} left to {eq.called}: {'; '.join(left)}"
            f"{'; ...' if count > LISTED else ''}; add drivers (angle_driver, "
            "displacement_driver), or simulate",
            code="freedoms",
        )

    def _no_start(self) -> NotConvergedError:
        eq = self.equations
        residuals = np.abs(eq.Phi(0.0, np.array(eq.core.q0)))
        rows = np.argsort(-residuals)[: 2 * LISTED]
        names = eq.joints(rows[residuals[rows] > 1e-9 * residuals.max(initial=0.0)])
        return NotConvergedError(
            f"kinematics: no pose satisfies joints and drivers at t = 0 near the initial one; at the initial "
            f"one these do not hold: {named(names)} (at most {residuals.max():.3g} m or 1)",
            code="no_start",
            joints=names,
            time=0.0,
        )

    def impasse(self) -> Impasse:
        """Where it is, after there was no way to go on."""
        at, count = self.at, self.rank
        constraints = at.constraints
        left, rates = constraints.weakest(count), self.equations.terms(at.t, at.q).Phi_t
        asked = constraints.row_scale * rates
        driven = abs(left @ asked) > ASKED * np.abs(asked).max(initial=0.0)
        names = self.equations.joints(strongest(left))
        return Impasse(at.t, names, constraints.smallest(count), bool(driven))

    def _refuse_to_go_on(self, t: float) -> None:
        it = self.impasse()
        remedy = "end before it, or drive another joint"
        if it.time == 0.0:
            remedy = "begin in a pose beside it, which says how the motion goes on, or drive another joint"
        raise NotConvergedError(
            f"kinematics: the mechanism cannot follow its drivers beyond t = {it.time:.9g} s (asked for "
            f"{t:.9g} s): {it}; {remedy}",
            code="dead_point",
            joints=it.joints,
            time=it.time,
            residuals={"smallest_singular_value": it.sigma},
        )


def _reach(x: Floats, length: float) -> float:
    """The largest shift in sizes of the mechanism, or angle [rad]."""
    parts = np.abs(x.reshape(-1, 2, 3)).max(axis=(0, 2))
    return float(max(parts[0] / length, parts[1]))


def named(names: list[str]) -> str:
    return ", ".join(f"'{name}'" for name in names[:LISTED]) + (", ..." if len(names) > LISTED else "")
