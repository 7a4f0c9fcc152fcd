"""The frames of a motion that drivers prescribe, and what it needs in them."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.constraints.continuation import Continuation
from linkwork.constraints.crossing import IN_POSE, Crossing, MotionState
from linkwork.constraints.equations import Sparse
from linkwork.constraints.tangent import to_inertial_axes
from linkwork.equations.system import System
from linkwork.errors import LinkworkError, warn
from linkwork.modeling.model import Model
from linkwork.motion.header import Header
from linkwork.results.result import Result
from linkwork.running import breakpoints
from linkwork.running.laws_of_forces import LawsOfForces
from linkwork.running.manifest import manifest

__all__ = ["Frames"]

#: From this error on, relative, it is told that frames beside a singular pose are not known better.
TOLD = 1e-4

#: The same by an estimate that is high as a rule.
BADLY = 1e-3


#: Of the way that a driver makes between knots, relative to all of its way: it rests there.
RESTS = 1e-6


@dataclass(frozen=True)
class Passed:
    """A singular pose on the way, with the multipliers (k, m) that the states beside it need."""

    crossing: Crossing
    multipliers: Floats


class Frames:
    """The frames of a Result, and those beside breaks of drivers, which may turn and rest in between, where
    these begin or end to rest, and beside jumps of energy that is stored."""

    def __init__(self, model: Model, asked: Floats) -> None:
        self.model, self.asked = model, asked
        self.system = System(model)
        self.rows: dict[str, list[Any]] = {}
        self.poses: list[dict[str, Any]] = []  # that are singular
        self.passed: list[Passed] = []
        self.turned: list[Any] = []  # joints between frames, see linkwork.results.joint_motion
        self.doubts: dict[float, float] = {}  # by how much what equations say at a time may be off, relative
        self.struck = breakpoints.struck_between_frames(model, float(asked[0]), float(asked[-1]))
        breaks = {t for _, signal in model.drivers for t in signal.break_points if t > 0.0}
        breaks.update(breakpoints.stored_energy_jumps(model, 0.0, float(asked[-1])))
        #: The last time before each of these, and the first after it.
        self.sides = [it for it in breakpoints.on_either_side(breaks) if it[1] < asked[-1]]
        #: When drivers begin or end to rest: at rest nothing tells of a whole turn beyond.
        self.ends_of_rest = [
            t for _, signal in model.drivers for t in _ends_of_rest(signal.compiled(), float(asked[-1]))
        ]
        #: Of all that acts, with the last frame where rounding puts it beside one.
        self.breaks = _breaks(model, float(asked[-1]))
        #: When frames are found: at a break, as those of a run.
        self.taken = _core.BreakPoints(self.breaks).clock(asked, float(asked[-1]))

    @property
    def times(self) -> Floats:
        beside = {*np.ravel(self.sides).tolist(), *self.ends_of_rest}
        return np.union1d(self.taken, sorted(beside))

    @property
    def begun(self) -> bool:
        """Whether there is one of those that are asked for."""
        return any(np.max(t) >= self.taken[0] for t in self.rows.get("t", ()))

    def add(self, at: MotionState, off: float) -> None:
        """One in which accelerations and forces are known to that, relative."""
        if off > TOLD and not any(it.crossing.covers(at.t) for it in self.passed):
            self.doubts[at.t] = off
        self.extend({name: [value] for name, value in self._values(at).items()})

    def extend(self, found: Mapping[str, ArrayLike]) -> None:
        """With frames (k, ...) of each."""
        for name, values in found.items():
            self.rows.setdefault(name, []).append(values)

    def cross(self, crossing: Crossing) -> list[str]:
        """The joints whose reactions grow without limit toward this pose, whose frames it will tell."""
        multipliers = np.array([self._values(state)["lambda"] for state in crossing.states])
        self.passed.append(Passed(crossing, multipliers))
        _, grow, error = crossing.multipliers(multipliers, np.array([]))
        if error > TOLD:
            return []  # forces are not smooth there
        core = self.model.compiled()
        joints = np.repeat(np.arange(core.joint_count), np.diff(core.joint_rows))[grow]
        return [core.joint_name(int(joint)) for joint in dict.fromkeys(joints)]

    def nearest(self, t: float, apart: float) -> float:
        """The time of the frame so near to t, or t [s]."""
        nearest = float(self.times[np.abs(self.times - t).argmin()])
        return nearest if abs(nearest - t) < apart else t

    def result(self, continuation: Continuation, began: float, failed: bool = False) -> Result:
        fields, dynamics = self._fields(continuation), self.system.compiled()
        given = {"times": self.asked}
        chosen = {"analysis": "kinematics", "integrator": "kinematics", "t_end": float(self.asked[-1])}
        facts = {
            **manifest(self.model, self.model.hash(), given, chosen),
            "breaks": {"count": len(self.sides), **breakpoints.noted(self.struck)},
        }
        model = self.model
        header = Header.of(model.compiled(), dynamics, facts, None, model.shapes, model.curves, self.breaks)
        header = replace(header, unlike_run=LawsOfForces(model))
        crossings = self.poses
        struck = breakpoints.on_either_side(it.time for it in self.struck if it.time <= fields["t"][-1])
        statistics = {**continuation.counts, "impacts": len(struck), "singular_poses": len(crossings),
                      "singularity_crossings": crossings, "seconds": time.perf_counter() - began,
                      "failed": failed, **self._turned()}  # fmt: skip
        if not failed:
            self._warn_of_doubts()
        return Result(fields, header, statistics)

    def _turned(self) -> dict[str, Any]:
        """As the statistics of a run have it, at the times that were asked for."""
        at = dict(zip(self.taken.tolist(), self.asked.tolist(), strict=True))
        found = [[*which, at[before], at[t], angle] for *which, before, t, angle in self.turned]
        return {"turned": found} if found else {}

    def _values(self, it: MotionState, multipliers: Floats | None = None) -> dict[str, Any]:
        dynamics = self.system.compiled()
        found = dynamics.evaluate(it.t, it.q, it.v, it.history)
        D = self._matrix(found["D"], self.model.row_count)
        if multipliers is None:
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

    def _tell(self, arrays: Mapping[str, Floats], passed: Passed, continuation: Continuation) -> None:
        """Those beside this pose or in it. LinkworkWarning: they are known badly.

        Forces that are not smooth there, as where a contact begins, are those of the equations at the state
        that is told.
        """
        crossing = passed.crossing
        pose = crossing.poses[0] if crossing.poses else crossing.t
        beside = np.array([k for k, t in enumerate(arrays["t"]) if crossing.covers(t)], dtype=int)
        multipliers, _, error = crossing.multipliers(passed.multipliers, arrays["t"][beside])
        off = crossing.error if len(beside) else 0.0
        for k, its in zip(beside, multipliers, strict=True):
            t = float(arrays["t"][k])
            if error > TOLD:
                outside = crossing.state(crossing.outside(t), continuation.constraints_at)
                its = self._values(outside)["lambda"]
                doubt = continuation.doubt(outside)
                off = max(off, doubt if doubt > BADLY else 0.0)
            state = crossing.state(t, continuation.constraints_at)
            for name, value in self._values(state, its).items():
                arrays[name][k] = value
        if off > TOLD:
            warn(
                f"kinematics: in the singular pose at t = {pose:.6g} s, and beside it, accelerations, "
                f"reactions and efforts of frames may be {100 * min(off, 1.0):.1g} % off: the motion is not "
                "smooth there, or other loops are in such poses nearly at once"
            )
        elif any(crossing.outside(t) != t for t in arrays["t"][beside]) and error > TOLD:
            warn(
                f"kinematics: reactions and efforts in the singular pose at t = {pose:.6g} s are those "
                f"of up to {crossing.spacing * IN_POSE:.1g} s before or after it: forces are not smooth there"
            )

    def _warn_of_doubts(self) -> None:
        """LinkworkWarning: frames nearly in a pose that the motion does not cross."""
        beside = {t for it in self.passed for t in self.doubts if it.crossing.covers(t)}
        left = {t: off for t, off in self.doubts.items() if t >= self.taken[0] and t not in beside}
        if left:
            worst = max(left, key=left.__getitem__)
            others = f", and {len(left) - 1} more frames" if len(left) > 1 else ""
            warn(
                f"kinematics: at t = {worst:.6g} s{others} the mechanism is in a singular pose or nearly so: "
                "accelerations, reactions and efforts there may be "
                f"{100 * min(left[worst], 1.0):.1g} % off by rounding of the pose"
            )

    def _fields(self, continuation: Continuation) -> Mapping[str, Floats]:
        arrays = {name: np.concatenate(values, dtype=float) for name, values in self.rows.items()}
        for passed in self.passed:
            self._tell(arrays, passed, continuation)
        arrays = {name: values[arrays["t"] >= self.taken[0]] for name, values in arrays.items()}
        t, power = arrays["t"], arrays.pop("power")
        states = (arrays["q"].reshape(len(t), -1), arrays["v"].reshape(len(t), -1))
        kinetic = self.system.compiled().kinetic_energies(*states)
        found = {**arrays, "kinetic": kinetic, "work": self._work(t, power, kinetic + arrays["potential"])}
        count = np.searchsorted(self.taken, t[-1], side="right")
        found = {name: values[np.searchsorted(t, self.taken[:count])] for name, values in found.items()}
        found["t"] = self.asked[:count]
        return found

    def _work(self, t: Floats, power: Floats, energy: Floats) -> Floats:
        """The integral of the power, and what bodies gain or lose where drivers demand another velocity, or
        springs where their stiffness jumps."""
        blows, within = np.zeros(len(t)), np.zeros(len(t), dtype=bool)
        for before, after in self.sides:
            there = np.flatnonzero((t >= before) & (t <= after))
            within |= (t > before) & (t < after)
            blows[there[1:]] = np.diff(energy[there])
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


def _breaks(model: Model, last: float) -> list[float]:
    """Of all that acts, after t = 0 up to the last frame, with its time where one is that near [s]."""
    reach = _core.BreakPoints([last])
    breaks = breakpoints.of_run(model, (), 0.0, reach.after(last))
    return sorted({*breaks, last}) if breaks and breaks[-1] >= reach.before(last) else breaks


def _ends_of_rest(function: _core.TimeFunction, end: float) -> list[float]:
    """Knots before `end` [s] between a part in which the function rests and one in which it does not."""
    knots = np.unique([0.0, *(t for t, _ in function.breaks if 0.0 < t < end), end])
    if len(knots) < 3:
        return []
    length = np.diff(knots)
    values, rates, accelerations = np.array([function.evaluate(t) for t in knots[:-1] + length / 2]).T
    way = np.abs(rates) * length + np.abs(accelerations) * length**2
    resting = way <= RESTS * np.ptp(values)
    ends: list[float] = knots[1:-1][resting[1:] != resting[:-1]].tolist()
    return ends


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
