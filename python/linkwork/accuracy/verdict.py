"""How accurate a run is, estimated from the run itself.

Some of its steps are taken again in parts, see `linkwork/integration/step_judge.hpp` and `run_judge.hpp`:
a few dozen, spread over the run and more where accelerations change most, all of few; those in which the
balance of energy jumps, those that contain break points, at which parts end, and some in which contacts and
stops begin or end; the worst once more in eight parts. Each difference is the local error of that step, by
Richardson's extrapolation, in four lengths of every body: its position, rotation, velocity, angular velocity.
Methods with memory and integrators of the user's own are compared with another one-step method, penalties and
loose iterations with equations that are solved exactly. Functions of time of the user's own are looked at
between steps, too (running.pulses); where frames come from the interpolant of long steps, what that gives.

Over the run local errors add up, and grow: see `linkwork/integration/accumulated_error.hpp`. The estimate is
meant to be large rather than small: of 1200 runs of 60 random mechanisms by all integrators, see
`tests/benchmarks/verdicts.py`, 90 % had one of 2.3 to 97 times the true error, 11 times in the median. It is
much too large where errors die out more slowly than within a few steps, and where drivers leave nothing to
go wrong.

The steps are taken again when the run is over, and change nothing in it. Of runs of 10 000 steps by rk4 that
takes 1.3 % of the time or less, of one body by Euler's method 2.5 to 4 %. Some of their errors are then
followed as they grow, by up to 10 000 evaluations, or 100 000 of one body, and one for two steps; five times
as many where motion seems unstable or chaotic, where errors grow exponentially: see `error_growth.hpp`.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, NamedTuple

import numpy as np

from linkwork.arrays import Floats
from linkwork.options import LEAST_RTOL

__all__ = [
    "WRONG", "Energies", "Method", "StepEstimate", "Verdict", "cut_short", "estimate", "leaping",
    "passing", "say", "without_steps",
]  # fmt: skip

#: Errors up to here are good, beyond the second the motion is wrong.
GOOD, WRONG = 1e-2, 1e-1

#: What a better step or tolerance is to give.
AIM = 1e-4

#: Of an error: the part of runs before that no step of this one could mend.
INHERITED = 0.5

#: Speed of a mechanism as a whole, relative to what happens in it: beyond, tolerances are for that speed.
FAST = 10.0

#: Of a step, relative to the rtol that it follows: beyond, its own estimate has not seen what happens in it.
#: As much of the whole error is most of it, with SAFETY.
BLIND, MOST = 1e4, 0.2

#: On the estimate: too large is better than too small.
SAFETY = 2.0

#: By how much more errors of all steps may come to than they add up to, as some were seen to grow; and
#: what they make of the energy, relative to them, where steps tell all of it.
FOLLOWED, BY_STEPS = 4.0, 4.0

#: By how much more than constraints are violated poses may be off, along motions that they hold weakly.
VIOLATED = 10.0

#: Of an estimate: what is left of it in a finer run where steps resolve what happens is less.
HARDLY = 0.5

#: Of a step: rounding adds up in as many more.
LEAST_SHARE = 1e-6

#: Of errors: beyond such a growth a motion is unstable or chaotic.
UNSTABLE = 100.0

#: Of energies, relative to the largest.
ROUNDING = 1e-12


class StepEstimate(NamedTuple):
    """What one step was off by."""

    t: float  #: its start [s]
    h: float  #: its size [s]
    #: Of the state at its end, see `Verdict.state`; of semi-implicit Euler what the next does not take back.
    error: float
    reactions: float | None  #: of forces and torques, relative to the largest; None: not looked at


@dataclass(frozen=True)
class Verdict:
    """How accurate a run is, in numbers and in a sentence. Errors are relative: 1 is as large as the motion.

    level        "good": up to 1 % off, "coarse", or "wrong": beyond 10 %
    sentence     "accurate to about 3e-7", or what is the matter and what would help
    error        the largest of `state`, `energy`, `violation`, `yielding` and `rounding`; of motion that is
                 unstable behind an event or a kink, or late in a long run, it may be too small by any factor
    state        of poses, relative to the smaller of the path and the size of the motion, and of velocities,
                 relative to the largest: local errors accumulated over the run; None: no step was taken
                 again. Parts that neither joints nor forces connect are judged as if alone: the worst counts
    local_error  of the state, per second [1/s]: the mean over the run
    reactions    of forces and torques, relative to the largest, accumulated likewise, and what they lose by
                 `yielding`; None: not known
    energy       made or lost, relative to the largest kinetic energy or energy exchanged
    violation    largest of position constraints, as a displacement relative to the size of the mechanism
    steps        what was taken again
    steps_total  of the run
    left_out     why no step was taken again, or how many of them could not be
    singular_poses, contradictions, break_points
                 poses passed; joints whose redundant equations turned out to contradict the others; steps
                 that contain a time at which what acts on the mechanism is not smooth
    verified     error of the state by a second, finer run, the largest over the frames; None: there was none
    before       error of the runs that this one goes on from, see `start`; part of `state`
    memory       functions of the user's that remember calls: how far the motion is off is not known then
    recalled     what a function returned in the run, and later for the same arguments, in words
    yielding     of forces and torques, relative to the largest: what they lose in the states of the run where
                 constraints yield, by a penalty or by iterations that end early
    rounding     of positions, relative to the path, where it adds up: of motion that is uniform to the last
                 digit, in steps that are short beside the distance from the origin; of velocities there, into
                 which stabilization turns violations that are rounding
    body         of the connected part that the error is of; "": all bodies are one part, or it is of no one
    growth       of errors of steps until the end of the run, the largest factor: in proportion to time in
                 regular motion, exponential where it is unstable or chaotic. None: not known, as of most
                 members of ensembles, long runs, large models, and from the first event or kink on
    unstable     the same of motion that is unstable or chaotic, of whichever part: where it is much more than
                 in regular motion, else 1
    followed_until
                 when something happens beyond which nobody knows what becomes of errors before [s], such as a
                 singular pose or a kink of a law; None: nothing did as far as errors were followed
    """

    level: Literal["good", "coarse", "wrong"]
    sentence: str
    error: float
    state: float | None
    local_error: float | None
    reactions: float | None
    energy: float
    violation: float
    steps: tuple[StepEstimate, ...] = field(default=(), repr=False)
    steps_total: int = 0
    left_out: str = ""
    singular_poses: int = 0
    contradictions: int = 0
    break_points: int = 0
    before: float = 0.0
    verified: float | None = None
    memory: tuple[str, ...] = ()
    recalled: str = ""
    yielding: float = 0.0
    rounding: float = 0.0
    body: str = ""
    growth: float | None = field(default=None, compare=False)  # most lanes do not look at it
    unstable: float = field(default=1.0, compare=False)
    followed_until: float | None = field(default=None, compare=False)

    def numbers(self) -> dict[str, Any]:
        """
        As plain data, for files.

            result.verdict.numbers()
        """
        return {**vars(self), "steps": list(map(list, self.steps)), "memory": list(self.memory)}

    @classmethod
    def of(cls, numbers: Mapping[str, Any]) -> Verdict:
        """
        The inverse of `numbers`.

            assert lw.Verdict.of(result.verdict.numbers()).sentence == result.verdict.sentence
        """
        steps = tuple(itertools.starmap(StepEstimate, numbers["steps"]))
        return cls(**{**numbers, "steps": steps, "memory": tuple(numbers.get("memory", ()))})


class Energies:
    """The balance of energy over the frames of a run; `rest` [J]: as little is that of bodies at rest."""

    def __init__(self, rest: float = 0.0) -> None:
        self._rest = rest
        self._first: float | None = None
        self._first_work = 0.0
        self._made = self._kinetic = self._work = 0.0
        self._least, self._largest = math.inf, -math.inf
        self._began = self._last = (0.0, 0.0)  # time, and what was made till then
        self._late = self._latest = 0.0  # its integral, and the largest of that [J s]

    def reach(self, kinetic: float, least: float, largest: float, work: float) -> None:
        """What energies came to between frames, too: see `_core.Run.energies`."""
        self._kinetic, self._work = max(self._kinetic, kinetic), max(self._work, work)
        self._least, self._largest = min(self._least, least), max(self._largest, largest)

    def add(self, frames: Mapping[str, Floats]) -> None:
        if not len(frames["t"]):
            return
        kinetic, potential, work = (frames[name] for name in ("kinetic", "potential", "work"))
        balance = kinetic + potential - work
        if self._first is None:
            self._first, self._first_work = float(balance[0]), float(work[0])
            self._began = self._last = (float(frames["t"][0]), 0.0)
        self._made = max(self._made, float(balance.max()) - self._first, self._first - float(balance.min()))
        self._add_up(frames["t"], balance - self._first)
        self.reach(
            float(kinetic.max()),
            float(potential.min()),
            float(potential.max()),
            float(np.abs(work - self._first_work).max()),
        )

    def _add_up(self, t: Floats, made: Floats) -> None:
        t, made = np.append(self._last[0], t), np.append(self._last[1], made)
        # One after the other: the sum does not depend on how many frames come at a time.
        integral = np.cumsum(np.append(self._late, 0.5 * (made[1:] + made[:-1]) * np.diff(t)))[1:]
        self._last, self._late = (float(t[-1]), float(made[-1])), float(integral[-1])
        self._latest = max(self._latest, float(np.abs(integral).max()))

    @property
    def lasting(self) -> float:
        """The integral over time of what was made, relative to that of a drift to the most that it was.

        At most 2: as what is made at the start. What comes and goes within the motion delays nothing.
        """
        drift = 0.5 * self._made * (self._last[0] - self._began[0])
        return min(self._latest / drift, 2.0) if drift > 0.0 else 1.0

    @property
    def at_rest(self) -> bool:
        """Whether nothing moved: then estimates are of rounding."""
        return self._kinetic <= self._rest

    def error(self, share: float = 1.0, rest: float = 0.0) -> tuple[float, float]:
        """Made or lost, relative to what there was and to all that was exchanged: the first counts.

        share  of the kinetic energy that is of the motion, not of that of the mechanism as a whole
        rest   as little is that of a mechanism that rests [J]
        """
        if self._first is None:
            return 0.0, math.inf
        if self._kinetic == 0.0 and self._least == self._largest:
            return 0.0, 0.0  # bodies without mass, which nothing but drivers moves: work is rounding
        largest = max(self._kinetic, abs(self._least), abs(self._largest), self._work)
        scale = max(share * self._kinetic, self._largest - self._least, self._work, self._rest, rest)
        replaced = self._work / scale if scale > 0 else 0.0
        made = max(self._made - ROUNDING * largest, 0.0)
        return (made / max(scale, 1e-9 * largest) if made > 0 else 0.0), replaced


@dataclass(frozen=True)
class Method:
    """What is needed to say what would be better: the order, and the step [s] or the rtol.

    carried  speed of the mechanism as a whole, relative to that of its motion in axes that move along
    growth   of errors, where most of the whole error is theirs
    """

    order: int
    step: float | None = None
    rtol: float | None = None
    carried: float = 0.0
    growth: float = 1.0

    def advice(self, error: float, steps: Sequence[StepEstimate] = (), state: float = math.inf) -> str:
        """ "the step is too long: about 4 % off; 2e-4 s would give 1e-4"; `steps`: some of
        the run, `state`: what these come to."""
        if self.rtol is not None and self.carried > FAST:
            return f"{_off(error)}, as {self._carries()}: {self._along(error)}"
        if self.rtol is not None and (blind := _blind(steps, self.rtol, error, state)):
            span = f"between t = {blind.t:.5g} and {blind.t + blind.h:.5g} s"
            return (
                f"a step goes over what happens {span}, {_off(error)}, which rtol did not see: give a "
                f"longest step (step=), less than {_rounded(blind.h):g} s, or breaks"
            )
        if self.growth > UNSTABLE:
            return (
                f"{_off(error)}, as errors grow {_times(self.growth)} in this motion: {self._smaller(error)}"
            )
        if self.rtol is not None and self.rtol * AIM / error < LEAST_RTOL:
            return f"{_off(error)}, which smaller tolerances would hardly mend: something is not smooth there"
        what = "the step is too long" if self.rtol is None else "the tolerances are too large"
        return f"{what}: {_off(error)}; {self._smaller(error)}"

    def _smaller(self, error: float) -> str:
        if self.rtol is None:
            share = (AIM / error) ** (1 / max(self.order, 1))
            if share < LEAST_SHARE:
                return "no step is short enough up to its end"
            better = f"{_rounded((self.step or 0.0) * share):g} s"
        elif self.rtol * AIM / error < LEAST_RTOL:
            return "no tolerance is small enough up to its end"
        else:
            better = f"rtol {_rounded(self.rtol * AIM / error):g}"
        return f"{better} would give {AIM:.0e}".replace("e-0", "e-")

    def _carries(self) -> str:
        return (
            f"rtol {self.rtol:g} is relative to speeds in space, and the mechanism moves as a whole at "
            f"{self.carried:.1g} times the speed of what happens in it".replace("e+0", "e")
        )

    def _along(self, error: float) -> str:
        rtol = (self.rtol or 0.0) * AIM / error
        smaller = f", or rtol {_rounded(rtol):g}".replace("e-0", "e-") if rtol >= LEAST_RTOL else ""
        return f"give the bodies velocities without that{smaller}"


def estimate(
    found: Mapping[str, Any],
    energies: Energies,
    method: Method,
    statistics: Mapping[str, Any],
    before: float = 0.0,
    name: Callable[[int], str] = lambda body: "",
) -> Verdict:
    """From what `_core.Run.judge` found; `name`: of a body, by its index."""
    taken = found["taken"]
    if not taken:
        why = "no step could be taken again" if found["failed"] else "no step was one of the method's own"
        return without_steps(why, energies, statistics, found["violation"], before)
    (energy, delay, late), violation = _made(found, energies), found["violation"]
    before *= found["unstable"] if found["body"] < 0 else 1.0  # else of which part it is, nobody knows
    delay = min(delay, at_most := _at_most(found, energy))
    by_steps = before + min(SAFETY * _known(found["state"]), at_most)
    state = max(by_steps, before + max(delay, VIOLATED * violation))
    failed, yielding, reactions = found["failed"], found["yielding"], _reactions(found, state)
    error, steps = max(state, energy, yielding), tuple(itertools.starmap(StepEstimate, found["steps"]))
    method = replace(method, growth=found["growth"] if found["grows"] and by_steps >= error else 1.0)
    body = name(found["body"] if by_steps >= error else late if max(before + delay, energy) >= error else -1)
    sentence = _sentence(error, violation, state, method, before, steps, body) + _but(error, reactions)
    verdict = Verdict(
        level=_level(error),
        sentence=sentence + _beyond(found, error),
        error=error,
        state=state,
        local_error=_known(found["local_error"]),
        reactions=reactions,
        energy=energy,
        violation=violation,
        steps=steps,
        left_out=f"{failed} of {failed + taken} steps could not be taken again" if failed else "",
        before=before,
        yielding=yielding,
        body=body,
        **_as_found(found),
        **_counts(statistics),
    )
    return _rounded_off(verdict)


def _as_found(found: Mapping[str, Any]) -> dict[str, Any]:
    """What a Verdict has as it is."""
    return {name: found[name] for name in ("rounding", "growth", "unstable")} | {
        "followed_until": found["lost"]
    }


def _beyond(found: Mapping[str, Any], error: float) -> str:
    """Of a good run: that errors were followed to there alone."""
    if found["lost"] is None or error > GOOD:
        return ""
    return f"; what errors before t = {found['lost']:.5g} s become there is not known (verify=True tells)"


def without_steps(
    why: str, energies: Energies, statistics: Mapping[str, Any], violation: float, before: float = 0.0
) -> Verdict:
    """Of a run whose steps cannot be taken again: by its energy and its constraints alone."""
    energy, _ = energies.error()
    error = max(energy, violation, before)
    said = f"{_percent(error)} off" if error > GOOD else f"right to {_figure(error)}"
    return Verdict(
        level=_level(error), sentence=f"energy and constraints are {said}; {why}", error=error, state=None,
        local_error=None, reactions=None, energy=energy, violation=violation, left_out=why, before=before,
        **_counts(statistics),
    )  # fmt: skip


def verified(
    verdict: Verdict, state: float, method: Method, second: Verdict | None = None, body: str = ""
) -> Verdict:
    """The same with what a finer run says of the state, and of which `body`, in place of the estimate, and of
    reactions in proportion: unless that of the `second`, finer run is hardly smaller, as where steps of both
    leap over a pulse, or are in step with what oscillates."""
    error = max(state + verdict.before, verdict.energy, verdict.violation, verdict.yielding)
    body = body if state + verdict.before >= error else ""
    found = _sentence(error, verdict.violation, state, method, verdict.before, verdict.steps, body)
    reactions = verdict.reactions
    if reactions is not None and verdict.state:
        reactions = verdict.yielding + (reactions - verdict.yielding) * state / verdict.state
    sentence = f"{found} by a second run{_but(error, reactions)}"
    if second is not None and second.level != "good" and second.error > max(error, HARDLY * verdict.error):
        error, sentence, body = second.error, f"{second.sentence} (of a second run)", second.body
    second_run = replace(
        verdict,
        error=error,
        level=_level(error),
        sentence=sentence,
        reactions=reactions,
        verified=state,
        body=body,
    )
    return _rounded_off(second_run)


def _rounded_off(verdict: Verdict) -> Verdict:
    """Says so where it is rounding that makes most of the error, in each run alike."""
    if verdict.rounding == 0.0 or not verdict.error <= SAFETY * verdict.rounding:
        return verdict
    error = max(verdict.rounding, verdict.error)
    sentence = f"accurate to about {_figure(error)}{_but(error, verdict.reactions)}"
    if error > GOOD:
        why = "as steps are short beside the distance from the origin, to which positions are rounded"
        sentence = f"{_off(error)}, {why}: use longer steps, or put the origin nearer"
    return replace(verdict, error=error, level=_level(error), sentence=sentence, body="")


def leaping(verdict: Verdict, moments: Iterable[tuple[float, str]]) -> Verdict:
    """Says so where it is such a moment of a function of time that the worst step leaps over."""
    if verdict.level == "good" or not verdict.steps:
        return verdict
    worst = max(verdict.steps, key=lambda step: step.error)
    for t, what in moments:
        if worst.t <= t <= worst.t + worst.h:
            leapt = f"steps leap over what {what} does at t = {t:.5g} s, {_off(verdict.error)}"
            breaks = "give it its breaks (linkwork.functions.with_breaks), at which steps by rtol end"
            remedy = f"{breaks}, or a shorter step"
            return replace(verdict, sentence=f"{leapt}: {remedy}")
    return verdict


def cut_short(verdict: Verdict, functions: Sequence[str]) -> Verdict:
    """Says so where these functions of time take too long to be looked at everywhere between the steps."""
    if verdict.level != "good" or not functions:
        return verdict
    more = f" and {len(functions) - 1} more" if len(functions) > 1 else ""
    unseen = f"but for what {functions[0]}{more} may do between steps: too slow to be looked at everywhere"
    return replace(verdict, sentence=f"{verdict.sentence}, {unseen}")


def passing(verdict: Verdict, passed: Iterable[Mapping[str, Any]]) -> Verdict:
    """Says so where fixed steps went over contacts or stops, which no step taken again may have seen.

    For the bodies there the motion is another one, however fast others are, unless the force that they did
    not feel is next to nothing. `passed`: of the statistics, with the `speed` at which bodies came nearer
    [m/s or rad/s] and the `change` of their velocities that the force would have made, relative to these.
    """
    worst = max(passed, key=lambda it: (it["change"], it["speed"]), default=None)
    if worst is None or SAFETY * worst["change"] <= verdict.error:
        return verdict
    error = max(min(1.0, SAFETY * worst["change"]), verdict.error)
    if _level(error) == "good":
        return replace(verdict, error=error, sentence=f"accurate to about {_figure(error)}")
    more = f", {worst['steps']} times up to {worst['until']:.5g} s" if worst["steps"] > 1 else ""
    sentence = (
        f"{_passed(worst)} at t = {worst['t']:.5g} s{more}: the step is too long for their speed; use rtol"
    )
    return replace(verdict, error=error, level=_level(error), sentence=sentence)


def _passed(touch: Mapping[str, Any]) -> str:
    if "stop" in touch:
        return f"bodies pass through stop '{touch['stop']}'"
    return f"bodies pass through each other at contact '{touch['contact']}'"


def loose(verdict: Verdict, formulation: str) -> Verdict:
    """Says that it is the formulation that is inexact, as constraints yield: by no more than that, and the
    motion, other than reactions, less the shorter the steps."""
    if verdict.yielding >= verdict.error:
        return replace(verdict, sentence=_yields(verdict, formulation))
    remedy = "a larger penalty or a shorter step" if formulation == "penalty" else "a smaller tolerance"
    what = f"formulation '{formulation}' is not exact enough here"
    off = f"up to {_off(verdict.error).removeprefix('about ')}" if verdict.error < 1 else _off(verdict.error)
    return replace(verdict, sentence=f"{what}: {off}; use 'standard', {remedy}")


def _yields(verdict: Verdict, formulation: str) -> str:
    remedy = "a larger penalty" if formulation == "penalty" else "a smaller tolerance"
    what = f"formulation '{formulation}' is not exact enough here"
    return f"{what}: reactions are about {_percent(verdict.yielding)} off; use 'standard' or {remedy}"


def say(verdict: Verdict, name: str | None) -> str:
    """For messages: what is wrong with which run."""
    return f"{name or 'model'}: {verdict.sentence}"


# --- how it works ------------------------------------------------------------------------------------------


def _counts(statistics: Mapping[str, Any]) -> dict[str, Any]:
    names = {"steps_total": "steps", "singular_poses": "singular_poses", "break_points": "steps_with_breaks"}
    counts = {name: int(statistics.get(key, 0)) for name, key in names.items()}
    return {**counts, "contradictions": len(statistics.get("contradiction", {}).get("joints", ()))}


class _Made(NamedTuple):
    """Energy that a run made or lost, where that is most: in all of it, or in a connected part of its own."""

    error: float
    delay: float  #: what a state is off by, as the motion is late
    body: int  #: the first of that part; -1: of all


def _made(found: Mapping[str, Any], energies: Energies) -> _Made:
    whole, replaced = energies.error(found["kinetic_share"], found["rest_energy"])
    pace = found["rate"], found["slowness"], found["suddenness"]
    all_of_it = (-1, whole, energies.lasting, *pace, replaced)
    made = [
        _Made(error, error * _delay(found["seconds"], *how), body)
        for body, error, *how in (all_of_it, *found["energies"])
    ]
    worst = max(made, key=lambda it: max(it.error, it.delay))
    return _Made(max(it.error for it in made), max(it.delay for it in made), worst.body)


def _reactions(found: Mapping[str, Any], state: float) -> float | None:
    """By the state; None: not known."""
    ratio, yielding = found["reactions_by_state"], found["yielding"]
    if math.isfinite(ratio):
        return float(state * ratio + yielding)
    return float(yielding) if yielding > 0 else None


def _at_most(found: Mapping[str, Any], energy: float) -> float:
    """Of the state, where it is known how all errors of steps grow, and the energy says nothing else."""
    local = found["local_error"] * found["seconds"]
    if math.isnan(found["at_most"]) or not energy <= BY_STEPS * local:
        return math.inf
    return FOLLOWED * float(found["at_most"])


def _delay(
    duration: float, lasting: float, rate: float, slowness: float, sudden: float, replaced: float = 0.0
) -> float:
    """What a state is off by as a run makes or loses energy, relative to that.

    It is late by half the integral over time of the share of the kinetic energy that is made, at the largest
    speed, or, where it is `sudden`, the largest acceleration; what is `replaced` by work is no longer there.
    One that goes around but once or twice has no part where it is slow time and again.
    """
    turns = 0.25 * min(duration, duration / replaced if replaced > 0 else duration) * rate
    late = max(min(SAFETY * slowness, turns**2 / 2), SAFETY * sudden)
    return turns * late * lasting if turns > 1 else 0.0


def _known(error: float) -> float:
    """Sums of what is infinite may be no number."""
    return math.inf if math.isnan(error) else error


def _level(error: float) -> Literal["good", "coarse", "wrong"]:
    if error <= GOOD:
        return "good"
    return "coarse" if error <= WRONG else "wrong"


def _sentence(
    error: float,
    violation: float,
    state: float,
    method: Method,
    before: float,
    steps: Sequence[StepEstimate],
    body: str,
) -> str:
    there = f"body '{body}': " if body else ""
    if not math.isfinite(error):
        return f"{there}the motion is lost: use a much smaller step"
    if error <= GOOD:
        return f"accurate to about {_figure(error)}"
    if before > INHERITED * error:
        return f"{_off(error)}, as the runs are that this one goes on from: take those again"
    if VIOLATED * violation >= error:
        size = f"{_percent(violation)} of the mechanism's size"
        return f"the constraints are violated by {size}: {method.advice(error)}"
    return there + method.advice(error, steps, state)


def _but(error: float, reactions: float | None) -> str:
    """Of a good motion whose reactions may not be: where they are steep, as near singular poses and in stiff
    contacts. No reason to warn: what they accumulate to is much too large as a rule."""
    if error > GOOD or reactions is None or reactions <= WRONG:
        return ""
    return f", but reactions may be {f'{_percent(reactions)} ' if reactions < 1 else 'far '}off"


def _blind(steps: Sequence[StepEstimate], rtol: float, error: float, state: float) -> StepEstimate | None:
    """The step that makes most of the error, where it is off far more than steps that follow rtol may be; the
    longest, where the balance of energy shows what no step does."""
    if not steps:
        return None
    if state < MOST * error:
        return max(steps, key=lambda step: step.h)
    worst = max(steps, key=lambda step: step.error)
    if worst.error < max(BLIND * rtol, MOST * error):
        return None
    return worst


def _off(error: float) -> str:
    return f"about {_percent(error)} off" if error < 1 else "the motion is another one"


def _figure(error: float) -> str:
    return f"{max(error, 1e-15):.0e}".replace("e-0", "e-")


def _percent(error: float) -> str:
    return f"{100 * error:.2g} %" if error < 0.995 else f"{100 * error:.0f} %"


def _times(factor: float) -> str:
    return (
        f"{factor:.0f} times"
        if factor < 1e4
        else f"{factor:.0e} times".replace("e+0", "e").replace("e+", "e")
    )


def _rounded(value: float) -> float:
    """Down to 1, 2 or 5 times a power of ten."""
    if not value > 0:
        return 0.0
    power = 10.0 ** math.floor(math.log10(value))
    return float(f"{max(digit for digit in (1, 2, 5) if digit <= value / power + 1e-9) * power:.0e}")
