"""Kinematic analysis: the motion of a mechanism whose freedoms are all fixed by drivers."""

from __future__ import annotations

import time
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.accuracy.verdict import WRONG, Energies
from linkwork.analyses.driven_frames import Frames
from linkwork.arguments import array, one_of
from linkwork.arrays import Floats
from linkwork.blas_threads import one_blas_thread
from linkwork.constraints.continuation import Continuation
from linkwork.constraints.crossing import SAME, SINGULAR, Crossing, MotionState
from linkwork.constraints.equations import Equations
from linkwork.constraints.impasse import named
from linkwork.constraints.solver import strongest
from linkwork.errors import OptionError, SingularSystemError, carry, warn
from linkwork.modeling.model import Model, check_bodies
from linkwork.motion.records import Snapshot
from linkwork.motion.state_names import StateNames
from linkwork.results.result import Result
from linkwork.running import checks
from linkwork.running.estimation import told_of_memory
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
    that of the drivers and of forces without a potential, an integral over the `times`: `energy_error` is
    what it is off [J], and more than 10 % are a LinkworkWarning.

    times        increasing, at least two, from 0 on [s]
    on_singular  where branches meet (dead points, toggles): "pass", "warn" or "stop". In any case
                 `Result.singular_poses` has them, found between the times as well, with the joints whose
                 equations depend on each other there; `pivot` is the smallest singular value of D, scaled

    In and beside such a pose frames are those of the branch, as states on both sides of it tell; reactions
    that grow without limit toward it are large numbers in it.

    ModelError: freedoms are left, which the message names.
    NotConvergedError: the drivers ask for what the joints do not allow: at the start, or after a dead point,
    which the message names with its time; the error's `result` is the motion up to there. With the code
    "contradiction": drivers ask for different motions from some time on.
    SingularSystemError: a singular pose with on_singular="stop", or at the start of a large model.
    OptionError: times, or a function of time that is not known there. LinkworkWarning: joints repeat
    each other but for digits of their points or axes; a singular pose was passed; accelerations
    and forces in or beside one are known badly; the velocity of a driver jumps, by an impulse that
    multipliers and reactions are without; functions of the model remember calls.
    """
    one_of(on_singular, ("pass", "warn", "stop"), "on_singular")
    check_bodies(model)
    with one_blas_thread(), told_of_memory(model, "kinematics"):
        return _motion(model, _times(times), on_singular)


def _motion(model: Model, t: Floats, on_singular: Literal["pass", "warn", "stop"]) -> Result:
    began = time.perf_counter()
    checks.warn_of_opposed_axes(model, model.compiled().q0)
    checks.check_tables(model, float(t[-1]))
    equations = Equations(model)
    checks.warn_of_near_dependence(equations.dynamics)
    continuation = Continuation(equations, float(t[-1]))
    continuation.prepare()
    frames = Frames(model, t)
    t = frames.times
    fast = _CompiledContinuation(continuation, frames)
    if not fast.start():
        continuation.begin()
    watch = _Watch(continuation, frames, on_singular)
    k = 0
    try:
        if not fast.ready and continuation.at.constraints.smallest(continuation.rank) < SINGULAR:
            watch.look(continuation.at)
        while k < len(t):
            if not (taken := fast.follow(t[k:])):
                continuation.go_to(float(t[k]))
                watch.warn()
                frames.add(continuation.at, continuation.doubt(continuation.at))
                fast.record(continuation.at)
                fast.resume()
            k += taken or 1
    except Exception as error:
        found = frames.result(continuation, began, failed=True) if frames.begun else None
        at = continuation.at
        names = StateNames.of(model.compiled(), continuation.equations.dynamics)
        state = Snapshot(at.t, at.q.reshape(-1, 7), at.v.reshape(-1, 6), at.history, names=names)
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

    def __init__(self, continuation: Continuation, frames: Frames) -> None:
        eq = continuation.equations
        self.continuation, self.frames, self.ready = continuation, frames, False
        self.motion = None
        if eq.holonomic.all() and eq.core.row_count >= continuation.rank:
            dynamics = frames.system.compiled()
            self.motion = motion = _core.DrivenMotion(
                dynamics, eq.length, eq.row_lengths, eq.rounding, continuation.unit, list(frames.taken)
            )
            continuation.passed = lambda at: motion.pass_by(at.t, at.q, at.v)

    def start(self) -> bool:
        """Onto the constraints at t = 0, with the continuation; False: that needs a closer look."""
        core, dynamics = self.continuation.equations.core, self.frames.system.compiled()
        if self.motion is not None and self.motion.start(core.q0, dynamics.initial_history):
            self.ready = True
            self.continuation.jump(*self.motion.state)
        return self.ready

    def resume(self) -> None:
        """From where the continuation is."""
        at, crossed = self.continuation.at, self.continuation.crossed
        if self.motion is not None and not any(it.covers(at.t) for it in crossed[-1:]):
            self.ready = self.motion.begin(at.t, at.q, at.v, at.a, at.history)

    def record(self, at: MotionState) -> None:
        """A frame that was found otherwise: turns of joints up to it are counted."""
        if self.motion is not None:
            self.motion.record(at.t, at.q, at.v)
            self.frames.turned = self.motion.turned

    def follow(self, t: Floats) -> int:
        """How many frames at these times have been added; 0: the next one needs a closer look."""
        if not self.ready or self.motion is None:
            return 0
        count, paused = 0, True
        while paused and not count:
            count, found, paused, costs = self.motion.follow(list(t), PIECE)
            for name, cost in costs.items():
                self.continuation.counts[name] += cost
        self.ready = count > 0
        if count:
            self.frames.extend(found)
            self.frames.turned = self.motion.turned
        self.continuation.jump(*self.motion.state)
        return int(count)


class _Watch:
    """Notes singular poses that are passed, and those in which the motion stands."""

    def __init__(self, continuation: Continuation, frames: Frames, on_singular: str) -> None:
        self.continuation, self.frames, self.on_singular = continuation, frames, on_singular
        self.messages: list[str] = []
        continuation.watch = self.look

    def look(self, at: Crossing | MotionState) -> None:
        """SingularSystemError: with on_singular="stop"."""
        if isinstance(at, MotionState):
            return self._note(at, "; what joints and drivers exert in it is not known")
        growing = self.frames.cross(at)
        grow = f"; toward it the reactions of {named(growing)} grow without limit" if growing else ""
        for t in at.poses:
            time_of_frame = self.frames.nearest(t, SAME * at.spacing)
            self._note(at.state(time_of_frame, self.continuation.constraints_at), grow)
        return None

    def _note(self, pose: MotionState, forces: str) -> None:
        eq, count = self.continuation.equations, self.continuation.rank
        names = eq.joints(strongest(pose.constraints.weakest(count)))
        self.frames.poses.append(
            {"t": pose.t, "joints": names[:16], "pivot": pose.constraints.smallest(count),
             "rows_changed": False, "fallback_evaluations": 0}
        )  # fmt: skip
        message = (
            f"kinematics: singular pose at t = {pose.t:.6g} s: the equations of {named(names)} depend on "
            f"each other for a state, where the motion could go on in several ways{forces}"
        )
        if self.on_singular == "stop":
            raise SingularSystemError(message, code="singular_pose", joints=names, time=pose.t)
        if self.on_singular == "warn":
            self.messages.append(message)

    def warn(self) -> None:
        """Of those that were passed: where the motion ends in one, the error says so."""
        for message in self.messages:
            warn(message)
        self.messages.clear()
