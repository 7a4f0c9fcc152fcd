"""Kinematic analysis: the motion of a mechanism whose freedoms are all fixed by drivers."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.accuracy.verdict import WRONG, Energies
from linkwork.arguments import array, one_of
from linkwork.arrays import Floats
from linkwork.constraints.continuation import SINGULAR, SUSPICIOUS, Continuation, MotionState, named
from linkwork.constraints.equations import Equations, Sparse
from linkwork.constraints.solver import strongest
from linkwork.constraints.tangent import to_inertial_axes
from linkwork.equations.system import System
from linkwork.errors import LinkworkError, OptionError, SingularSystemError, carry, warn
from linkwork.modeling.model import Model, check_bodies
from linkwork.motion.header import Header
from linkwork.motion.records import Snapshot
from linkwork.results.result import Result
from linkwork.running import breakpoints, checks
from linkwork.running.estimation import told_of_memory
from linkwork.running.manifest import manifest
from linkwork.running.seen_in_frames import warn_of_what_frames_show

__all__ = ["kinematics"]

#: Frames away from singular poses are found in pieces that take so long [s], then the user is listened to.
PIECE = 0.2


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
    passed; the velocity of a driver jumps, by an impulse that multipliers and reactions are without;
    functions of the model remember calls.
    """
    one_of(on_singular, ("pass", "warn", "stop"), "on_singular")
    check_bodies(model)
    with told_of_memory(model, "kinematics"):
        return _motion(model, _times(times), on_singular)


def _motion(model: Model, t: Floats, on_singular: Literal["pass", "warn", "stop"]) -> Result:
    began = time.perf_counter()
    checks.warn_of_opposed_axes(model, model.compiled().q0)
    checks.check_tables(model, float(t[-1]))
    continuation = Continuation(Equations(model), float(t[-1]))
    continuation.prepare()
    frames = _Frames(model, t)
    t = frames.times
    fast = _CompiledContinuation(continuation, frames)
    if not fast.start():
        continuation.begin()
    watch = _Watch(continuation, on_singular)
    k = 0
    try:
        if not fast.ready:
            watch.look(continuation.at, continuation.at)
        while k < len(t):
            if not (taken := fast.follow(t[k:])):
                continuation.go_to(float(t[k]))
                watch.warn()
                frames.add(continuation)
                fast.resume()
            k += taken or 1
    except Exception as error:
        found = frames.result(continuation, began, failed=True) if frames.begun else None
        at = continuation.at
        state = Snapshot(at.t, at.q.reshape(-1, 7), at.v.reshape(-1, 6), at.history)
        carry(error, result=found, state=state)
        if found is not None:
            warn_of_what_frames_show(found)
        raise
    result = frames.result(continuation, began)
    _check_work(result)
    warn_of_what_frames_show(result)
    return result


def _check_work(result: Result) -> None:
    """LinkworkWarning: the integral of the power over the frames is not what the energy gains."""
    energies = Energies()
    energies.add({name: result._field(name) for name in ("t", "kinetic", "potential", "work")})
    made, _ = energies.error()
    if made > WRONG:
        warn(
            f"kinematics: the work is about {100 * min(made, 1.0):.2g} % off, as it is an integral over the "
            "frames and these are too far apart, or a driver jumps where its function has no break: "
            "take more times, or `simulate` with rtol (poses, forces and reactions are exact)"
        )


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


class _CompiledContinuation:
    """The same in compiled code while poses are regular, joints restrict positions, and steps are trusted."""

    def __init__(self, continuation: Continuation, frames: _Frames) -> None:
        eq = continuation.equations
        self.continuation, self.frames, self.ready = continuation, frames, False
        self.motion = None
        if eq.holonomic.all() and eq.core.row_count >= continuation.rank:
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


class _Watch:
    """Notes singular poses within steps, or at their ends."""

    def __init__(self, continuation: Continuation, on_singular: str) -> None:
        self.continuation, self.on_singular = continuation, on_singular
        self.messages: list[str] = []
        continuation.watch = self.look

    def look(self, first: MotionState, second: MotionState) -> None:
        """SingularSystemError: there is one, with on_singular="stop"."""
        continuation = self.continuation
        eq, count = continuation.equations, continuation.rank
        if first is not second and first.constraints.smallest(count) < SINGULAR:  # which has been noted
            return
        found: MotionState | None = None
        if second.constraints.smallest(count) < SINGULAR:
            found = second
        elif first is not second and first.constraints.turns(second.constraints):
            found = _crossing(continuation, first, second)
        if found is None:
            return
        names = eq.joints(strongest(found.constraints.weakest(count)))
        continuation.crossings.append(
            {"t": found.t, "joints": names[:16], "pivot": found.constraints.smallest(count),
             "rows_changed": False, "fallback_evaluations": int(found is second)}
        )  # fmt: skip
        message = (
            f"kinematics: singular pose at t = {found.t:.6g} s: the equations of {named(names)} depend on "
            "each other for a state, where the motion could go on in several ways"
        )
        if self.on_singular == "stop":
            raise SingularSystemError(message, code="singular_pose", joints=names, time=found.t)
        if self.on_singular == "warn":
            self.messages.append(message)

    def warn(self) -> None:
        """Of those that were passed: where the motion ends in one, the error says so."""
        for message in self.messages:
            warn(message)
        self.messages.clear()


def _crossing(continuation: Continuation, first: MotionState, second: MotionState) -> MotionState | None:
    """The pose between two moments where D loses its rank, by bisection of the time; None: it does not."""
    low, high, best = first, second, second
    for _ in range(40):
        middle = continuation.soon_after(low, (low.t + high.t) / 2)
        if middle is None:
            break
        best = middle
        if middle.constraints.smallest(continuation.rank) < SINGULAR:
            return best
        low, high = (low, middle) if low.constraints.turns(middle.constraints) else (middle, high)
        if not low.constraints.turns(high.constraints):
            return None
    return best if best.constraints.smallest(continuation.rank) < SUSPICIOUS else None


class _Frames:
    """The frames of a Result, and those beside breaks of drivers: a driver may turn and rest in between."""

    def __init__(self, model: Model, asked: Floats) -> None:
        self.model, self.asked = model, asked
        self.system = System(model)
        self.rows: dict[str, list[Any]] = {}
        self.struck = breakpoints.struck_between_frames(model, float(asked[0]), float(asked[-1]))
        breaks = sorted({t for _, signal in model.drivers for t in signal.break_points if t > 0.0})
        #: The last time before each of these, and the first after it.
        sides = list(map(breakpoints.on_either_side, breaks))
        self.sides = [it for it in sides if it[1] < asked[-1]]
        at_end = [before for before, after in sides if asked[-2] < before <= asked[-1] <= after]
        #: When frames are found: at a break the last one is of what comes before it, as that of a run.
        self.taken = np.append(asked[:-1], at_end[:1]) if at_end else asked

    @property
    def times(self) -> Floats:
        return np.union1d(self.taken, np.ravel(self.sides))

    @property
    def begun(self) -> bool:
        """Whether there is one of those that are asked for."""
        return any(np.max(t) >= self.asked[0] for t in self.rows.get("t", ()))

    def add(self, continuation: Continuation) -> None:
        self.extend({name: [value] for name, value in self._values(continuation.at).items()})

    def extend(self, found: Mapping[str, ArrayLike]) -> None:
        """With frames (k, ...) of each."""
        for name, values in found.items():
            self.rows.setdefault(name, []).append(values)

    def result(self, continuation: Continuation, began: float, failed: bool = False) -> Result:
        fields, dynamics = self._fields(), self.system.compiled()
        given = {"times": self.asked}
        chosen = {"analysis": "kinematics", "integrator": "kinematics"}
        facts = {
            **manifest(self.model, self.model.hash(), given, chosen),
            "breaks": {"count": len(self.sides), **breakpoints.noted(self.struck)},
        }
        header = Header.of(self.model.compiled(), dynamics, facts, None, self.model.shapes, self.model.curves)
        crossings = continuation.crossings
        struck = {it.time for it in self.struck if it.time <= fields["t"][-1]}
        statistics = {**continuation.counts, "impacts": len(struck), "singular_poses": len(crossings),
                      "singularity_crossings": crossings, "seconds": time.perf_counter() - began,
                      "failed": failed}  # fmt: skip
        return Result(fields, header, statistics)

    def _values(self, it: MotionState) -> dict[str, Any]:
        dynamics = self.system.compiled()
        found = dynamics.evaluate(it.t, it.q, it.v, it.history)
        D = self._matrix(found["D"], self.model.row_count)
        multipliers = _multipliers(dynamics, it)
        left = self._inertial_forces(it.a, found) - found["g"] - D.T @ multipliers
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
        arrays = {name: np.concatenate(values, dtype=float) for name, values in self.rows.items()}
        arrays = {name: values[arrays["t"] >= self.asked[0]] for name, values in arrays.items()}
        t, power = arrays["t"], arrays.pop("power")
        states = (arrays["q"].reshape(len(t), -1), arrays["v"].reshape(len(t), -1))
        kinetic = self.system.compiled().kinetic_energies(*states)
        found = {**arrays, "kinetic": kinetic, "work": self._work(t, power, kinetic)}
        found = {name: values[np.isin(t, self.taken)] for name, values in found.items()}
        found["t"] = self.asked[: len(found["t"])]
        return found

    def _work(self, t: Floats, power: Floats, kinetic: Floats) -> Floats:
        """The integral of the power, and what bodies gain or lose where drivers demand another velocity."""
        blows, within = np.zeros(len(t)), np.zeros(len(t), dtype=bool)
        for before, after in self.sides:
            there = np.flatnonzero((t >= before) & (t <= after))
            within |= (t > before) & (t < after)
            blows[there[1:]] = np.diff(kinetic[there])
        breaks = breakpoints.of_run(self.system.model, (), float(t[0]), float(t[-1]))
        work = np.zeros(len(t))
        work[~within] = _integral(t[~within], power[~within], breaks)
        last = np.maximum.accumulate(np.where(within, 0, np.arange(len(t))))
        return work[last] + np.cumsum(blows)

    def _matrix(self, rows: Mapping[str, Any], count: int) -> Sparse:
        from scipy.sparse import csr_array

        shape = (count, 6 * self.model.body_count)
        return csr_array((rows["data"], rows["indices"], rows["indptr"]), shape=shape)

    def _inertial_forces(self, a: Floats, found: Mapping[str, Any]) -> Floats:
        """M v_dot (6n,), torques in body axes."""
        core, parts = self.model.compiled(), a.reshape(-1, 2, 3)
        force = np.asarray(core.mass)[:, None] * parts[:, 0]
        of_bodies = np.stack([force, np.einsum("nij,nj->ni", core.inertia, parts[:, 1])], axis=1).ravel()
        rows = self._matrix(found["inerters"], len(found["inertance"]))
        total: Floats = of_bodies + rows.T @ (found["inertance"] * (rows @ a))
        return total


def _multipliers(dynamics: _core.Dynamics, it: MotionState) -> Floats:
    """Those that the motion needs, of least norm; zero where they are not found, to be corrected."""
    try:
        multipliers: Floats = dynamics.accelerations(it.t, it.q, it.v, it.history)[1]
        return multipliers
    except LinkworkError:
        return np.zeros(dynamics.row_count)


def _integral(t: Floats, power: Floats, breaks: Sequence[float]) -> Floats:
    """Of cubic splines through the powers, from the first time on, each from one of the breaks to the next.

    At a break frames are of what follows; up to there the spline before it goes on.
    """
    from scipy.interpolate import CubicSpline

    if len(t) < 2 or not np.isfinite(power).all():
        known = np.where(np.isfinite(power), power, 0.0)
        steps = np.diff(t) * (known[1:] + known[:-1]) / 2
        return np.concatenate([[0.0], np.cumsum(steps)])
    inside = [time for time in breaks if t[0] < time <= t[-1]]
    begins = np.unique(np.searchsorted(t, inside))  # of the parts that have frames
    edges = [t[0], *(next(time for time in reversed(inside) if time <= t[k]) for k in begins), t[-1]]
    work, done = np.zeros(len(t)), 0.0
    for begin, end, frames in zip(edges[:-1], edges[1:], np.split(np.arange(len(t)), begins), strict=True):
        if len(frames) < 2:
            spent = power[frames[0]] * (np.array([t[frames[0]], end]) - begin)
        else:
            spline = CubicSpline(t[frames], power[frames]).antiderivative()
            spent = spline(np.append(t[frames], end)) - spline(begin)
        work[frames] = done + spent[:-1]
        done += spent[-1]
    return work
