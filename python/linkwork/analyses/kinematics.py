"""Kinematic analysis: the motion of a mechanism whose freedoms are all fixed by drivers."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.analyses import constraint_solver
from linkwork.analyses.constraint_solver import (
    Constraints,
    SparseConstraints,
    constraints_of,
    free_motions,
)
from linkwork.analyses.equations import LISTED, Equations, Sparse
from linkwork.analyses.tangent import displaced, rate_of_change, to_body_axes, to_inertial_axes
from linkwork.arguments import array, one_of
from linkwork.arrays import Floats
from linkwork.equations.system import System
from linkwork.errors import (
    LinkworkError,
    ModelError,
    NotConvergedError,
    OptionError,
    SingularSystemError,
    warn,
)
from linkwork.modeling.model import Model
from linkwork.motion.header import Header
from linkwork.motion.records import Snapshot
from linkwork.results.result import Result
from linkwork.running import checks
from linkwork.running.manifest import manifest

__all__ = ["kinematics"]

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

#: Frames away from singular poses are found in pieces that take so long [s], then the user is listened to.
PIECE = 0.2

#: From where a singular pose takes the velocity that it leaves open, as a part of the step.
NEARBY = 1e-2

#: The shortest step, as a part of the time between two frames.
SHORTEST_STEP = 2.0**-40

#: Of the integration where joints restrict velocities only, relative and absolute.
ROLLING = 1e-11

#: Violations of joints, relative to the size of the mechanism, of a pose in which all hold.
CLOSED = LIMITS.closed

#: Corrections relative to the size of the mechanism at which Newton's method ends.
CONVERGED, ITERATIONS = LIMITS.converged, LIMITS.iterations


def kinematics(
    model: Model, times: ArrayLike, *, on_singular: Literal["pass", "warn", "stop"] = "warn"
) -> Result:
    """Positions, velocities and accelerations at `times` of a mechanism that drivers move.

        motion = lw.kinematics(model, np.linspace(0, 2, 201))
        motion.body("piston").acceleration

    The joints and drivers alone decide: Phi(q, t) = 0 by Newton's method, from frame to frame with the
    velocity and acceleration as predictor, so that the mechanism stays on its branch; D v = -Phi_t and
    D v_dot = gamma. The model's own initial velocities do not matter, its initial pose says which branch.
    Where joints restrict velocities only, as by rolling, positions follow by integration. Redundant equations
    do no harm. Multipliers and reactions are those that the motion needs (inverse dynamics); `Result.work` is
    that of the drivers and of forces without a potential.

    times        increasing, at least two, from 0 on [s]
    on_singular  where branches meet (dead points, toggles): "pass", "warn" or "stop". In any case
                 `Result.singular_poses` has them, found between the times as well, with the joints whose
                 equations depend on each other there; `pivot` is the smallest singular value of D, scaled

    ModelError: freedoms are left, which the message names.
    NotConvergedError: the drivers ask for what the joints do not allow: at the start, or after a dead point,
    which the message names with its time; the error's `result` is the motion up to there.
    SingularSystemError: a singular pose with on_singular="stop", or at the start of a large model.
    OptionError: times, or a function of time that is not known there. LinkworkWarning: a singular pose was
    passed.
    """
    began = time.perf_counter()
    t = _times(times)
    one_of(on_singular, ("pass", "warn", "stop"), "on_singular")
    checks.check_bodies(model)
    checks.check_tables(model, float(t[-1]))
    continuation = _Continuation(Equations(model), float(t[-1]))
    continuation.prepare()
    frames = _Frames(model)
    fast = _CompiledContinuation(continuation, frames)
    if not fast.start():
        continuation.begin()
    try:
        previous, k = continuation.at, 0
        while k < len(t):
            if not (taken := fast.follow(t[k:])):
                continuation.go_to(float(t[k]))
                _watch(continuation, previous, on_singular)
                frames.add(continuation)
                fast.resume()
            previous, k = continuation.at, k + (taken or 1)
    except LinkworkError as error:
        error.result = frames.result(continuation, t, began, failed=True) if frames.rows else None
        at = continuation.at
        error.state = Snapshot(at.t, at.q.reshape(-1, 7), at.v.reshape(-1, 6), at.history)
        raise
    return frames.result(continuation, t, began)


def _times(times: ArrayLike) -> Floats:
    """OptionError: not two or more increasing finite numbers from 0 on."""
    try:
        t = array(times, "times")
    except OptionError as error:
        raise OptionError(f"times {times!r:.80} are not numbers [s]", code="times") from error
    if t.ndim != 1 or len(t) < 2 or not np.isfinite(t).all() or t[0] < 0 or (np.diff(t) <= 0).any():
        raise OptionError(
            f"times of shape {t.shape} must be two or more finite numbers [s] that increase, from 0 on",
            code="times",
        )
    return t


@dataclass(frozen=True)
class _MotionState:
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


@dataclass
class _Continuation:
    """Follows the motion in steps that the predictor can answer for."""

    equations: Equations
    t_end: float
    at: _MotionState = field(init=False)
    unit: float = 1.0  # of singular values
    beside: bool = False  # a singular pose, which is left on both of its sides
    crossings: list[dict[str, Any]] = field(default_factory=list)
    counts: dict[str, int] = field(
        default_factory=lambda: {"steps": 0, "evaluations": 0, "factorizations": 0}
    )

    @property
    def freedoms(self) -> int:
        return 6 * self.equations.core.body_count

    def _accept(self, state: _MotionState) -> None:
        self.at = state
        self.equations.dynamics.history = state.history

    def _constraints(self, D: Sparse) -> AnyConstraints:
        self.counts["factorizations"] += 1
        return constraints_of(self.equations, D, self.unit)

    def jump(self, t: float, q: Floats, v: Floats, a: Floats, history: Floats) -> None:
        """To where the motion has been found to go."""
        terms, constraints = self.equations.terms, self._constraints
        self._accept(_MotionState(t, q, v, a, lambda: constraints(terms(t, q).D), history))

    def prepare(self) -> None:
        """ModelError: freedoms are left. SingularSystemError: a large model in a singular pose."""
        eq = self.equations
        q0 = np.array(eq.core.q0)
        if eq.rank.degrees_of_freedom > 0:
            self._refuse_freedoms(q0)
        if self.freedoms > constraint_solver.DENSE:
            start = SparseConstraints.of(eq, eq.terms(0.0, q0).D)
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

    def go_to(self, t: float) -> None:
        """NotConvergedError: there is no way to go on."""
        start, h = self.at.t, t - self.at.t
        smallest = SHORTEST_STEP * h
        while self.at.t < t:
            last = self.at.t + h >= t - smallest
            found = self._step(t if last else self.at.t + h)
            if found is None:
                h /= 2
                if h < smallest:
                    self._refuse_to_go_on(start, t)
            else:
                self._accept(found)
                self.counts["steps"] += 1
                h *= 2

    def soon_after(self, first: _MotionState, t: float) -> _MotionState | None:
        """The mechanism soon after `first`, without going there."""
        kept = self.at
        self._accept(first)
        try:
            self.go_to(t)
            return self.at
        except NotConvergedError:
            return None
        finally:
            self._accept(kept)

    def _step(self, t: float) -> _MotionState | None:
        """q + h v + h^2 v_dot / 2, corrected; None: the step is too long for the predictor to be trusted."""
        at, h = self.at, t - self.at.t
        length = self.equations.length
        x = h * at.x_dot + h * h / 2 * at.x_ddot
        moved = _reach(x, length)
        if moved > LONGEST_STEP:
            return None
        predicted = displaced(at.q, x) if self.equations.holonomic.all() else self._rolled(t)
        q = self._corrected(t, predicted, at.constraints, max(LARGEST_CORRECTION * moved, 1e-9))
        if q is None:
            return None
        state = self._state(t, q, at)
        if state.constraints.rank == self.freedoms:
            return state
        if self.beside or at.constraints.rank < self.freedoms:
            return None  # singular poses one after the other: no step, however short, leaves them
        return self._singular(state, h) if h > 1e-6 * max(t, 1e-3 * self.t_end) else state

    def _rolled(self, t: float) -> Floats:
        """q at t by integration of D v = -Phi_t, where joints restrict velocities only."""
        from scipy.integrate import solve_ivp

        def rate(t: float, q: Floats) -> Floats:
            terms = self.equations.terms(t, q)
            self.counts["evaluations"] += 1
            x_dot = self._constraints(terms.D).solve(-terms.Phi_t)
            return rate_of_change(q, x_dot)

        options = {"rtol": ROLLING, "atol": ROLLING, "first_step": t - self.at.t}
        found = solve_ivp(rate, (self.at.t, t), self.at.q, "DOP853", **options)
        return displaced(found.y[:, -1], np.zeros(self.freedoms))

    def _singular(self, state: _MotionState, h: float) -> _MotionState | None:
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

    def _state(self, t: float, q: Floats, last: _MotionState | None) -> _MotionState:
        """With velocities and accelerations; what a singular pose leaves open goes on as before."""
        if last is None:
            return self._completed(t, q, np.zeros(self.freedoms), np.zeros(self.freedoms))
        return self._completed(t, q, last.x_dot + (t - last.t) * last.x_ddot, last.x_ddot)

    def _completed(self, t: float, q: Floats, x_dot: Floats, x_ddot: Floats) -> _MotionState:
        """With the velocities and accelerations nearest to these."""
        terms = self.equations.terms(t, q)
        constraints = self._constraints(terms.D)
        v = to_body_axes(q, x_dot - constraints.solve(terms.D @ x_dot + terms.Phi_t))
        gamma = self.equations.terms(t, q, v).gamma
        a = to_body_axes(q, x_ddot - constraints.solve(terms.D @ x_ddot - gamma))
        self.counts["evaluations"] += 2
        history = self.equations.dynamics.advanced_history(t, q, v)
        return _MotionState(t, q, v, a, lambda: constraints, history)

    # --- what cannot be done ---

    def _refuse_freedoms(self, q: Floats) -> None:
        eq = self.equations
        count = eq.rank.degrees_of_freedom
        Z = free_motions(eq, eq.terms(0.0, q).D, min(count, LISTED))
        left = [eq.motion(z) for z in Z.T]
        what = "1 freedom is" if count == 1 else f"{count} freedoms are"
        raise ModelError(
            f"kinematics: {what} left to the model '{eq.model.name}': {'; '.join(left)}"
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
            f"one these do not hold: {_named(names)} (at most {residuals.max():.3g} m or 1)",
            code="no_start",
            joints=names,
            time=0.0,
        )

    def _refuse_to_go_on(self, start: float, t: float) -> None:
        eq, at = self.equations, self.at
        sigma = at.constraints.smallest(self.freedoms)
        names = eq.joints(at.constraints.weakest_rows(self.freedoms))
        dead = "a dead point" if sigma < SUSPICIOUS else "a pose"
        remedy = "end before it, or drive another joint"
        if at.t == 0.0:
            remedy = "begin in a pose beside it, which says how the motion goes on, or drive another joint"
        raise NotConvergedError(
            f"kinematics: the mechanism cannot follow its drivers beyond t = {at.t:.9g} s (asked for "
            f"{t:.9g} s): {dead} where the equations of {_named(names)} depend on each other (smallest "
            f"singular value {sigma:.2g}); {remedy}",
            code="dead_point",
            joints=names,
            time=at.t,
            residuals={"smallest_singular_value": sigma},
        )


class _CompiledContinuation:
    """The same in compiled code while poses are regular, joints restrict positions, and steps are trusted."""

    def __init__(self, continuation: _Continuation, frames: _Frames) -> None:
        eq = continuation.equations
        self.continuation, self.frames, self.ready = continuation, frames, False
        self.motion = None
        if eq.holonomic.all() and eq.core.row_count >= continuation.freedoms:
            dynamics = frames.system.compiled()
            self.motion = _core.DrivenMotion(
                dynamics, eq.length, eq.row_lengths, eq.rounding, continuation.unit
            )

    def start(self) -> bool:
        """Onto the constraints at t = 0, with the continuation; False: that needs a closer look."""
        core, dynamics = self.continuation.equations.core, self.frames.system.compiled()
        if self.motion is not None and self.motion.start(core.q0, dynamics.initial_history):
            self.ready = True
            self.continuation.jump(*self.motion.state)
        return self.ready

    def resume(self) -> None:
        """From where the continuation is."""
        at = self.continuation.at
        self.ready = self.motion is not None and self.motion.begin(at.t, at.q, at.v, at.a, at.history)

    def follow(self, t: Floats) -> int:
        """How many frames at these times have been added; 0: the next one needs a closer look."""
        if not self.ready or self.motion is None:
            return 0
        count, found, costs = self.motion.follow(list(t), PIECE)
        for name, cost in costs.items():
            self.continuation.counts[name] += cost
        self.ready = count > 0
        if count:
            self.frames.extend(found)
        self.continuation.jump(*self.motion.state)
        return int(count)


def _watch(continuation: _Continuation, first: _MotionState, on_singular: str) -> None:
    """Note a singular pose between two frames, or at the second one."""
    eq, second, count = continuation.equations, continuation.at, continuation.freedoms
    values = [state.constraints.smallest(count) for state in (first, second)]
    crossed = first is not second and first.constraints.orientation(second.constraints) < 0
    found: _MotionState | None = None
    if values[1] < SINGULAR:
        found = second
    elif crossed and values[0] >= SINGULAR:
        found = _crossing(continuation, first, second)
    if found is None:
        return
    rows = found.constraints.weakest_rows(count)
    names = eq.joints(rows)
    pivot = found.constraints.smallest(count)
    continuation.crossings.append(
        {"t": found.t, "joints": names[:16], "pivot": pivot, "rows_changed": False,
         "fallback_evaluations": int(found is second)}
    )  # fmt: skip
    if on_singular == "pass":
        return
    message = (
        f"kinematics: singular pose at t = {found.t:.6g} s: the equations of {_named(names)} depend on each "
        "other for a state, where the motion could go on in several ways"
    )
    if on_singular == "stop":
        raise SingularSystemError(message, code="singular_pose", joints=names, time=found.t)
    warn(message)


def _crossing(continuation: _Continuation, first: _MotionState, second: _MotionState) -> _MotionState:
    """The pose between two moments where D comes nearest to losing its rank, by bisection of the time."""
    low, high, best = first, second, second
    for _ in range(40):
        middle = continuation.soon_after(low, (low.t + high.t) / 2)
        if middle is None:
            break
        best = middle
        if middle.constraints.smallest(continuation.freedoms) < SINGULAR:
            break
        crossed = low.constraints.orientation(middle.constraints) < 0
        low, high = (low, middle) if crossed else (middle, high)
    return best


def _reach(x: Floats, length: float) -> float:
    """The largest shift in sizes of the mechanism, or angle [rad]."""
    parts = np.abs(x.reshape(-1, 2, 3)).max(axis=(0, 2))
    return float(max(parts[0] / length, parts[1]))


def _named(names: list[str]) -> str:
    return ", ".join(f"'{name}'" for name in names[:LISTED]) + (", ..." if len(names) > LISTED else "")


class _Frames:
    """The frames of a Result."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.system = System(model)
        self.rows: dict[str, list[Any]] = {}

    def add(self, continuation: _Continuation) -> None:
        self.extend({name: [value] for name, value in self._values(continuation.at).items()})

    def extend(self, found: Mapping[str, ArrayLike]) -> None:
        """With frames (k, ...) of each."""
        for name, values in found.items():
            self.rows.setdefault(name, []).append(values)

    def result(self, continuation: _Continuation, t: Floats, began: float, failed: bool = False) -> Result:
        fields, dynamics = self._fields(), self.system.compiled()
        given = {"times": f"{t[0]:g} to {t[-1]:g} s, {len(t)}"}
        facts = manifest(self.model, given, {"analysis": "kinematics", "integrator": "kinematics"})
        header = Header.of(self.model.compiled(), dynamics, facts, None, self.model.shapes, self.model.curves)
        crossings = continuation.crossings
        statistics = {**continuation.counts, "singular_poses": len(crossings),
                      "singularity_crossings": crossings, "seconds": time.perf_counter() - began,
                      "failed": failed}  # fmt: skip
        return Result(fields, header, statistics)

    def _values(self, it: _MotionState) -> dict[str, Any]:
        dynamics = self.system.compiled()
        found = dynamics.evaluate(it.t, it.q, it.v, it.history)
        D = self._matrix(found["D"])
        multipliers = _multipliers(dynamics, it)
        left = self._inertial_forces(it.a) - found["g"] - D.T @ multipliers
        multipliers = multipliers + it.constraints.solve_transposed(to_inertial_axes(it.q, left))
        residuals = (found["Phi"], found["Phi_dot"], D @ it.a - found["gamma"])
        return {
            "t": it.t,
            "q": it.q,
            "v": it.v,
            "vdot": it.a,
            "lambda": multipliers,
            "potential": found["potential"],
            "power": found["force_power"] - multipliers @ found["Phi_t"],
            "violation": [float(np.abs(x).max(initial=0.0)) for x in residuals],
            "history": it.history,
        }

    def _fields(self) -> Mapping[str, Floats]:
        mass = np.asarray(self.model.compiled().mass)
        arrays = {name: np.concatenate(values, dtype=float) for name, values in self.rows.items()}
        t, power = arrays["t"], arrays.pop("power")
        parts = arrays["v"].reshape(len(t), -1, 6)
        w = parts[..., 3:]
        kinetic = (mass * (parts[..., :3] ** 2).sum(axis=-1)).sum(axis=-1)
        kinetic = (kinetic + np.einsum("kni,nij,knj->k", w, self.model.compiled().inertia, w)) / 2
        return {**arrays, "kinetic": kinetic, "work": _integral(t, power)}

    def _matrix(self, D: Mapping[str, Any]) -> Sparse:
        from scipy.sparse import csr_array

        shape = (self.model.row_count, 6 * self.model.body_count)
        return csr_array((D["data"], D["indices"], D["indptr"]), shape=shape)

    def _inertial_forces(self, a: Floats) -> Floats:
        """M v_dot (6n,), torques in body axes."""
        core, parts = self.model.compiled(), a.reshape(-1, 2, 3)
        force = np.asarray(core.mass)[:, None] * parts[:, 0]
        return np.stack([force, np.einsum("nij,nj->ni", core.inertia, parts[:, 1])], axis=1).ravel()


def _multipliers(dynamics: _core.Dynamics, it: _MotionState) -> Floats:
    """Those that the motion needs, of least norm; zero where they are not found, to be corrected."""
    try:
        multipliers: Floats = dynamics.accelerations(it.t, it.q, it.v, it.history)[1]
        return multipliers
    except LinkworkError:
        return np.zeros(dynamics.row_count)


def _integral(t: Floats, power: Floats) -> Floats:
    """Of the cubic spline through the powers, from the first time on."""
    from scipy.interpolate import CubicSpline

    if len(t) < 2 or not np.isfinite(power).all():
        known = np.where(np.isfinite(power), power, 0.0)
        steps = np.diff(t) * (known[1:] + known[:-1]) / 2
        return np.concatenate([[0.0], np.cumsum(steps)])
    spline = CubicSpline(t, power).antiderivative()
    work: Floats = spline(t) - spline(t[0])
    return work
