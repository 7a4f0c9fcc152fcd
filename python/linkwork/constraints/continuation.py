"""The motion of a mechanism that drivers move, followed from pose to pose on one branch."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import NoReturn

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.constraints import solver
from linkwork.constraints.crossing import Crossing, MotionState, Search, reach
from linkwork.constraints.equations import LISTED, Equations, Sparse
from linkwork.constraints.impasse import Impasse, named
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

__all__ = ["Continuation"]

AnyConstraints = Constraints | SparseConstraints

#: Of singular poses: those that are crossed, and others in which the motion stands, or nearly so.
Watch = Callable[[Crossing | MotionState], None]

#: The smallest singular value at the start as a part of what counts as one, see SparseConstraints.
USUAL = 0.1

#: The most a predictor may move a body [rad, sizes of the mechanism], and the correction as a part of it.
LIMITS = _core.DrivenLimits()
LONGEST_STEP, LARGEST_CORRECTION = LIMITS.longest_step, LIMITS.largest_correction

#: Motions [rad, sizes] of a step that look like none, and where inside of it they are looked at.
HARDLY, INSIDE = 1e-2, 0.618

#: Of the largest rate that a driver asks for: what no velocity gives, where that is no rounding.
ASKED = 1e-3

#: Steps that are tiny parts of the way and hardly move a body, and how many of them in a row there may be.
TINY, MOST_TINY = 1e-6, 1000

#: The shortest step, as a part of the way, which is the time between two frames in `kinematics`.
SHORTEST_STEP = 2.0**-40

#: Of times, relative.
ROUNDING_OF_TIMES = 4 * np.finfo(float).eps

#: Of Phi, relative to the size of the mechanism, as a rule.
ROUNDING = 5e-17

#: The smallest singular value of a pose that is far from singular.
REGULAR = 1e-4

#: Violations of joints, relative to the size of the mechanism, of a pose in which all hold.
CLOSED = LIMITS.closed

#: Corrections relative to the size of the mechanism at which Newton's method ends.
CONVERGED, ITERATIONS = LIMITS.converged, LIMITS.iterations


@dataclass
class Continuation:
    """Follows the motion in steps that the predictor can answer for."""

    equations: Equations
    t_end: float
    at: MotionState = field(init=False)
    unit: float = 1.0  # of singular values
    shortest: float = SHORTEST_STEP  # as a part of the way
    most_seconds: float = math.inf  # from now on
    watch: Watch | None = None  # told of singular poses
    passed: Callable[[MotionState], None] | None = None  # told of each state that it comes to
    crossed: list[Crossing] = field(default_factory=list)
    unmet: Floats | None = field(
        default=None, init=False
    )  # Phi of the last pose found, where not all can hold
    counts: dict[str, int] = field(
        default_factory=lambda: {"steps": 0, "evaluations": 0, "factorizations": 0}
    )

    @property
    def rank(self) -> int:
        """How many rows of D are independent away from singular poses; 6n, or freedoms are left."""
        return 6 * self.equations.core.body_count - self.equations.rank.degrees_of_freedom

    def doubt(self, at: MotionState) -> float:
        """By how much accelerations and forces that the equations tell may be off there, relative.

        By rounding delta of Phi: velocities delta / sigma^2, accelerations v^2 delta / sigma^3.
        """
        length = self.equations.length
        sigma = max(self._smallest(at), ROUNDING)
        square = reach(at.x_dot, length) ** 2
        part = square / (square + reach(at.x_ddot, length)) if square > 0.0 else 0.0
        return ROUNDING / sigma**2 * (1 + part / sigma)

    def _accept(self, state: MotionState) -> None:
        self.at = state
        self.equations.dynamics.history = state.history
        if self.passed is not None:
            self.passed(state)

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
        return reach((t - self.at.t) * self.at.x_dot, self.equations.length)

    def go_to(self, t: float) -> None:
        """NotConvergedError: there is no way to go on."""
        if self.crossed:
            self._go_on(self.crossed[-1], t)
        h = t - self.at.t
        smallest, soon = self.shortest * h, max(LIMITS.touch_part * h, ROUNDING_OF_TIMES * t)
        short, tiny = 0, TINY * h
        while self.at.t < t:
            last = self.at.t + h >= t - smallest
            found = self._step(self.at, t if last else self.at.t + h)
            moves = self.way_to(self.at.t + h) >= HARDLY
            short += h < tiny and not moves
            if found is None or (h > soon and self._touches(found)):
                h = min(h, t - self.at.t) / 2
                if h < smallest or short > MOST_TINY:
                    self._refuse_to_go_on(t)
            else:
                self.counts["steps"] += 1
                short = 0 if moves else short
                self._take(found, t)
                h *= 2

    def _take(self, found: MotionState, t: float) -> None:
        """The step to it, or on the way to t over a singular pose that is beside it or before."""
        before = self.at
        passed = self.crossed and before.t <= self.crossed[-1].t <= found.t
        pose = None if passed else self._pose(before, found)
        if isinstance(pose, Crossing):
            self.crossed.append(pose)
        if pose is not None and self.watch is not None:
            self.watch(pose)
        self._accept(found)
        if isinstance(pose, Crossing):
            self._go_on(pose, t)

    def _go_on(self, crossing: Crossing, t: float) -> None:
        """On the way to t to a state that is beside the singular pose, or in it."""
        if crossing.covers(t):
            return self._accept(crossing.state(t, self.constraints_at))
        if crossing.covers(self.at.t) or crossing.states[0].t < self.at.t:
            known = [it for it in crossing.states if it.t <= t]
            if known and (known[-1].t > self.at.t or crossing.covers(self.at.t)):
                self._accept(known[-1])
        return None

    def _pose(self, first: MotionState, second: MotionState) -> Crossing | MotionState | None:
        """The singular pose between the states, or beside the second one; None: the motion passes none."""
        breaks = [0.0, *self._breaks, self.t_end]
        begin = max(t for t in breaks if t <= first.t)
        end = min((t for t in breaks if t >= second.t), default=second.t)
        search = Search(self._step, self._smallest, self.equations.length, begin, end)
        try:
            return search.find(first, second) or search.stands(first, second)
        finally:
            self.equations.dynamics.history = self.at.history

    @cached_property
    def _breaks(self) -> list[float]:
        """Of drivers [s]: beyond them the motion is another function."""
        signals = [signal for _, signal in self.equations.model.drivers]
        return sorted({t for signal in signals for t in signal.break_points})

    def _smallest(self, state: MotionState) -> float:
        return state.constraints.smallest(self.rank)

    def constraints_at(self, t: float, q: Floats) -> AnyConstraints:
        return self._constraints(self.equations.terms(t, q).D)

    def _touches(self, found: MotionState) -> bool:
        """Whether a contact begins on the way: its force depends on the speed there."""
        return bool(self.equations.dynamics.begins_contact(self.at.history, found.history))

    def _step(self, at: MotionState, t: float) -> MotionState | None:
        """q + h v + h^2 v_dot / 2, corrected; None: the step is too long for the predictor to be trusted."""
        h, length = t - at.t, self.equations.length
        self.equations.dynamics.history = at.history
        parts = h * at.x_dot, h * h / 2 * at.x_ddot
        x = parts[0] + parts[1]
        moved = reach(x, length)
        if moved > LONGEST_STEP or (moved < HARDLY and not self._foreseen(at, h)):
            return None
        predicted = displaced(at.q, x) if self.equations.holonomic.all() else self._rolled(at, t)
        way = max(moved, *(reach(part, length) for part in parts))  # there and back, where it turns
        q = self._corrected(t, predicted, at.constraints, max(LARGEST_CORRECTION * way, 1e-9))
        if q is None:
            return None
        state = self._state(t, q, at)
        if moved < HARDLY and reach(h * state.x_dot, length) > LONGEST_STEP:
            return None  # once round, or more, where nothing seemed to move
        if state.constraints.rank < self.rank and at.constraints.rank < self.rank:
            return None  # singular poses one after the other: no step, however short, leaves them
        return state

    def _foreseen(self, at: MotionState, h: float) -> bool:
        """Whether drivers do nothing else within the step: a whole turn looks like none at its end."""
        part = INSIDE * h
        predicted = displaced(at.q, part * at.x_dot + part * part / 2 * at.x_ddot)
        Phi = self.equations.Phi(at.t + part, predicted)
        return self.equations.violation(np.where(self.equations.holonomic, Phi, 0.0)) < HARDLY

    def _rolled(self, at: MotionState, t: float) -> Floats:
        """q at t by integration of D v = -Phi_t, where joints restrict velocities only."""

        def velocity(t: float, q: Floats) -> Floats:
            terms = self.equations.terms(t, q)
            self.counts["evaluations"] += 1
            return self._constraints(terms.D).solve(-terms.Phi_t)

        return rolled(at.q, velocity, at.t, t)

    # Newton's method with the D of the last moment, renewed where it converges slowly
    def _corrected(
        self, t: float, q: Floats, constraints: AnyConstraints, largest: float = np.inf
    ) -> Floats | None:
        eq, total, before = self.equations, 0.0, np.inf
        self.unmet = None
        for _ in range(ITERATIONS):
            Phi = eq.Phi(t, q)
            self.counts["evaluations"] += 1
            x = constraints.solve(-Phi)
            size = reach(x, eq.length)
            total += size
            if not np.isfinite(size) or total > largest:
                return None
            if size > 0.1 * before:
                if before < LIMITS.rounding:
                    return displaced(q, x) if self._closed(Phi) else None
                constraints = self._constraints(eq.terms(t, q).D)
                x = constraints.solve(-Phi)
                size = reach(x, eq.length)
            q, before = displaced(q, x), size
            if size < CONVERGED:
                return q if self._closed(eq.Phi(t, q)) else None
        return q if before < 10 * LIMITS.rounding and self._closed(eq.Phi(t, q)) else None

    def _closed(self, Phi: Floats) -> bool:
        """Whether redundant equations hold as well as the others."""
        closed = bool(self.equations.violation(Phi) < CLOSED + self.equations.rounding)
        self.unmet = None if closed else Phi
        return closed

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

    def _refuse_to_go_on(self, t: float) -> NoReturn:
        it = self.impasse()
        if self.unmet is not None and it.sigma > REGULAR:
            self._refuse_contradiction(self.unmet)
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

    def _refuse_contradiction(self, Phi: Floats) -> NoReturn:
        """Of equations that depend on each other, and held together up to now."""
        at, eq = self.at, self.equations
        rows = strongest(at.constraints.contradiction(Phi))
        driving = eq.terms(at.t, at.q).Phi_t[rows] != 0.0
        names = eq.joints(np.concatenate([rows[driving], rows[~driving]]))
        remedy = (
            "drive it once only, or by functions that agree"
            if driving.any()
            else "give points and axes of joints that repeat each other with all digits, or leave one out"
        )
        raise NotConvergedError(
            f"kinematics: {named(names)} contradict each other from t = {at.t:.6g} s on: they demand the "
            f"same motion in different ways; {remedy}",
            code="contradiction",
            joints=names,
            time=at.t,
        )
