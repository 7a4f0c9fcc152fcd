"""How accurate a run is, estimated from the run itself.

Some of its steps are taken again in parts, see `linkwork/integration/step_judge.hpp` and `run_judge.hpp`:
fewer than 100, spread over the run and more where accelerations change most, all of few; those in which the
balance of energy jumps, and those that contain break points, at which parts end; the worst once more in
eight parts. Each difference is the local error of that step, by Richardson's extrapolation, in four lengths
of every body: its position, rotation, velocity, angular velocity. Methods with memory and integrators of
the user's own are compared with another one-step method, penalties and loose iterations with equations that
are solved exactly. Functions of time of the user's own are looked at between steps, too (running.pulses).
Errors are relative: of poses to L, half of the box in which centers of mass move or the
longest arm, or to the path where that is shorter; of velocities to V, the largest speed.

Over the run local errors add up. An error of a velocity is also one of positions later: it grows with time,
as far as V t / L = GROWTH; beyond, motions of a mechanism turn rather than part. An error of a pose is a
delay, which in an impact is one of the velocity. What does grow on is the error of the energy, as that of the
speed along the path. The estimate is meant to be large rather than small: of 3600 runs of 300 random
mechanisms by all integrators, see `tests/benchmarks/verdicts.py`, 90 % had one of 2 to 150 times the true
error, 10 times in the median. It is much too large where errors die out, as in friction that sticks, with
steps that are long for it, and where drivers leave nothing to go wrong.

The steps are taken again when the run is over, and change nothing in it. Of runs of 10 000 steps by rk4 that
took 1.5 to 1.6 % of the time for a four-bar, Bricard's mechanism and a chain; about half a millisecond is its
least, which is 4 to 5 % for one body, and 10 % by Euler's method.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

__all__ = ["Energies", "Method", "StepEstimate", "Verdict", "estimate", "leaping", "say", "without_steps"]

#: Errors up to here are good, beyond the second the motion is wrong.
GOOD, WRONG = 1e-2, 1e-1

#: What a better step or tolerance is to give.
AIM = 1e-4

#: Characteristic times L / V in which an error of a velocity moves positions.
GROWTH = 5.0

#: A step whose accelerations change so many times as much as in the mean of its part is out of the ordinary.
STEEP = 10.0

#: On the estimate: too large is better than too small.
SAFETY = 2.0

#: Below, relative to L or to L / duration, nothing moves: what is left is rounding.
STILL = 1e-6

#: By how much more than constraints are violated poses may be off, along motions that they hold weakly.
VIOLATED = 10.0

#: Of energies, relative to the largest.
ROUNDING = 1e-12


class StepEstimate(NamedTuple):
    """What one step was off by."""

    t: float  #: its start [s]
    h: float  #: its size [s]
    error: float  #: of the state at its end, see `Verdict.state`
    reactions: float | None  #: of forces and torques, relative to the largest; None: not looked at


@dataclass(frozen=True)
class Verdict:
    """How accurate a run is, in numbers and in a sentence. Errors are relative: 1 is as large as the motion.

    level        "good": up to 1 % off, "coarse", or "wrong": beyond 10 %
    sentence     "accurate to about 3e-7", or what is the matter and what would help
    error        the largest of `state`, `energy` and `violation`
    state        of poses, relative to the smaller of the path and the size of the motion, and of velocities,
                 relative to the largest: local errors accumulated over the run; None: no step was taken again
    local_error  of the state, per second [1/s]: the mean over the run
    reactions    of forces and torques, relative to the largest, accumulated likewise; None: not known
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

    def numbers(self) -> dict[str, Any]:
        """As plain data, for files."""
        return {**vars(self), "steps": list(map(list, self.steps))}

    @classmethod
    def of(cls, numbers: Mapping[str, Any]) -> Verdict:
        """The inverse of `numbers`."""
        return cls(**{**numbers, "steps": tuple(itertools.starmap(StepEstimate, numbers["steps"]))})


class Energies:
    """The balance of energy over the frames of a run."""

    def __init__(self) -> None:
        self._frames: list[tuple[Floats, Floats, Floats]] = []
        self._reached = 0.0, math.inf, -math.inf, 0.0

    def reach(self, kinetic: float, least: float, largest: float, work: float) -> None:
        """What energies came to between frames, too: see `_core.Run.energies`."""
        self._reached = kinetic, least, largest, work

    def add(self, frames: Mapping[str, Floats]) -> None:
        if len(frames["t"]):
            self._frames.append((frames["kinetic"], frames["potential"], frames["work"]))

    def error(self) -> tuple[float, float]:
        """Made or lost, relative to what there was and to all that was exchanged: the first counts."""
        if not self._frames:
            return 0.0, math.inf
        kinetic, potential, work = (np.concatenate(one) for one in zip(*self._frames, strict=True))
        balance = kinetic + potential - work
        error = float(np.abs(balance - balance[0]).max())
        moving, least, most, done = self._reached
        least, most = min(least, float(potential.min())), max(most, float(potential.max()))
        moving, done = max(moving, float(kinetic.max())), max(done, float(np.abs(work).max()))
        largest, scale = max(moving, abs(least), abs(most), done), max(moving, most - least, done)
        replaced = done / scale if scale > 0 else 0.0
        made = max(error - ROUNDING * largest, 0.0)
        return (made / max(scale, 1e-9 * largest) if made > 0 else 0.0), replaced


@dataclass(frozen=True)
class Method:
    """What is needed to say what would be better: the order, and the step [s] or the rtol."""

    order: int
    step: float | None = None
    rtol: float | None = None

    def advice(self, error: float) -> str:
        """ "the step is too long: about 4 % off; 2e-4 s would give 1e-4"."""
        if self.rtol is not None:
            better, what = f"rtol {_rounded(self.rtol * AIM / error):g}", "the tolerances are too large"
        else:
            step = (self.step or 0.0) * (AIM / error) ** (1 / max(self.order, 1))
            better, what = f"{_rounded(step):g} s", "the step is too long"
        return f"{what}: {_off(error)}; {better} would give {AIM:.0e}".replace("e-0", "e-")


# Long: the formulas of one estimate, one after the other.
def estimate(
    found: Mapping[str, Any],
    energies: Energies,
    method: Method,
    statistics: Mapping[str, Any],
    before: float = 0.0,
) -> Verdict:
    """From what `_core.Run.judge` found."""
    ok = found["failed"] == 0
    if not ok.any():
        why = "no step could be taken again" if len(ok) else "no step was one of the method's own"
        return without_steps(why, energies, statistics, float(found["end_violation"]), before)
    parts = _Parts(found, ok)
    duration = float(found["part_seconds"].sum())
    L = max(float(found["diagonal"]) / 2, float(found["length"]))
    speeds = np.maximum(found["speed"], L * found["spin"])
    V = max(float(speeds[ok].max()), STILL * L / duration)
    size = max(min(L, parts.path(speeds)), STILL * L)
    poses = np.maximum(found["position"], L * found["rotation"]) / size
    velocities = np.maximum(found["velocity"], L * found["omega"]) / V

    local = np.maximum(poses, velocities)
    accelerations = np.maximum(found["acceleration"], L * found["spin_rate"])
    of_poses, of_velocities, of_both = parts.sums(np.array([poses, velocities, local]))
    accumulated = float(found["resolved"]) * parts.accumulated(
        of_poses, of_velocities, V / size, accelerations * (size / V**2)
    )
    violation = float(max(found["violation"][ok].max(), found["end_violation"]))
    energy, replaced = energies.error()
    turns = 0.25 * min(duration, duration / replaced if replaced > 0 else duration) * V / L
    state = before + max(SAFETY * accumulated, energy * turns if turns > 1 else 0.0, VIOLATED * violation)
    reactions = _reactions(found, L, ok)
    known = ok & np.isfinite(reactions) & (local > 0)
    ratio = float(reactions[known].sum() / local[known].sum()) if known.any() else math.nan
    error = max(state, energy)
    return Verdict(
        level=_level(error),
        sentence=_sentence(error, violation, state, method),
        error=error,
        state=state,
        local_error=float(of_both.sum()) / duration,
        reactions=state * ratio if math.isfinite(ratio) else None,
        energy=energy,
        violation=violation,
        steps=_steps(found, local, reactions, ok),
        left_out="" if ok.all() else f"{int((~ok).sum())} of {len(ok)} steps could not be taken again",
        before=before,
        **_counts(statistics),
    )


def without_steps(
    why: str, energies: Energies, statistics: Mapping[str, Any], violation: float, before: float = 0.0
) -> Verdict:
    """Of a run whose steps cannot be taken again: by its energy and its constraints alone."""
    energy, _ = energies.error()
    error = max(energy, violation, before)
    said = f"{_percent(error)} off" if error > GOOD else f"right to {_figure(error)}"
    sentence = f"energy and constraints are {said}; {why}"
    return Verdict(_level(error), sentence, error, None, None, None, energy, violation, left_out=why,
                   before=before, **_counts(statistics))  # fmt: skip


def verified(verdict: Verdict, state: float, method: Method) -> Verdict:
    """The same with what a finer run says of the state, which takes the place of the estimate."""
    error = max(state + verdict.before, verdict.energy, verdict.violation)
    sentence = f"{_sentence(error, verdict.violation, state, method)} by a second run"
    return replace(verdict, error=error, level=_level(error), sentence=sentence, verified=state)


def leaping(verdict: Verdict, moments: Iterable[tuple[float, str]]) -> Verdict:
    """Says so where it is such a moment of a function of time that the worst step leaps over."""
    if verdict.level == "good" or not verdict.steps:
        return verdict
    worst = max(verdict.steps, key=lambda step: step.error)
    for t, what in moments:
        if worst.t <= t <= worst.t + worst.h:
            leapt = f"steps leap over what {what} does at t = {t:.5g} s, {_off(verdict.error)}"
            remedy = "give it its breaks (linkwork.functions.with_breaks), or a shorter step"
            return replace(verdict, sentence=f"{leapt}: {remedy}")
    return verdict


def say(verdict: Verdict, name: str | None) -> str:
    """For messages: what is wrong with which run."""
    return f"{name or 'model'}: {verdict.sentence}"


# --- how it works ------------------------------------------------------------------------------------------


class _Parts:
    """The parts of a run with the steps that are known of them: one, or two, the second the steepest.

    Between the two values go with the change of accelerations, of which the mean is known; the sum over a
    part is at least what they say.
    """

    def __init__(self, found: Mapping[str, Any], ok: NDArray[np.bool_]) -> None:
        known = np.flatnonzero(ok)
        part_of = found["part"][known].astype(int)  # ascending
        last = np.append(np.flatnonzero(part_of[1:] != part_of[:-1]), len(known) - 1)
        first = np.append(0, last[:-1] + 1)
        parts = part_of[first]
        self._first, self._last = known[first], known[last]
        self.steps, self.seconds, self.start = (
            found[f"part_{name}"][parts] for name in ("steps", "seconds", "t")
        )
        mean = found["part_change"][parts] / self.steps - found["change"][self._first]
        with np.errstate(divide="ignore", invalid="ignore"):
            share = mean / (found["change"][self._last] - found["change"][self._first])
        self._share = np.fmax(np.clip(share, 0.0, 1.0), 1 / self.steps)
        alone = first == last  # far steeper than its part: it does not stand for all of it
        with np.errstate(divide="ignore", invalid="ignore"):
            typical = STEEP * found["part_change"][parts] / self.steps / found["change"][self._first]
        self._weight = np.where(alone, np.fmax(np.fmin(typical, 1.0), 1 / self.steps), 1.0)
        self._missed = float(found["part_steps"].sum() / self.steps.sum())  # parts of which no step is known

    def accumulated(self, poses: Floats, velocities: Floats, rate: float, shake: Floats) -> float:
        """Over the run, of the sums of parts: the larger of poses and velocities at any time.

        rate   [1/s] at which an error of a velocity moves poses
        shake  for each step: by how much larger an error of a pose is as one of the velocity there. In an
               impact a body that is late by dt is off by the acceleration times dt
        """
        order = np.argsort(self.start, kind="stable")
        time = (self.start + self.seconds / 2)[order]
        velocities = velocities[order]
        of_poses, of_velocities = poses[order].cumsum(), velocities.cumsum()
        of_moments = (velocities * time).cumsum()
        moved = np.minimum(rate * (time * of_velocities - of_moments), GROWTH * of_velocities)
        end = float((self.start + self.seconds).max())
        at_end = min(rate * (end * of_velocities[-1] - of_moments[-1]), GROWTH * of_velocities[-1])
        shaken = (of_poses + moved) * np.maximum(shake[self._first], shake[self._last])[order]
        return float(max(of_poses[-1] + of_velocities[-1] + at_end, shaken.max()))

    def sums(self, values: Floats) -> Floats:
        """Over the steps of each part; of values (..., steps)."""
        sums: Floats = self._means(values) * (self.steps * self._missed)
        return sums

    def path(self, speeds: Floats) -> float:
        """Over the time of all parts."""
        return float(self._means(speeds) @ self.seconds) * self._missed

    def _means(self, values: Floats) -> Floats:
        first, last = values[..., self._first], values[..., self._last]
        means: Floats = np.maximum(first + self._share * (last - first), first + (last - first) / self.steps)
        return means * self._weight


def _reactions(found: Mapping[str, Any], L: float, ok: NDArray[np.bool_]) -> Floats:
    """Relative to the largest; NaN where they were not looked at."""
    looked = ok & np.isfinite(found["force"])
    largest = np.maximum(found["largest_force"], found["largest_torque"] / L)
    scale = float(largest[looked].max()) if looked.any() else 0.0
    values: Floats = np.maximum(found["force"], found["torque"] / L)
    return values / scale if scale > 0 else np.full(len(ok), np.nan)


def _steps(
    found: Mapping[str, Any], local: Floats, reactions: Floats, ok: NDArray[np.bool_]
) -> tuple[StepEstimate, ...]:
    known = np.where(np.isfinite(reactions), reactions, None)  # type: ignore[call-overload]
    by_time = np.flatnonzero(ok)[np.argsort(found["t"][ok], kind="stable")]
    numbers = (found["t"], found["h"], local, known)
    return tuple(map(StepEstimate, *(it[by_time].tolist() for it in numbers)))


def _counts(statistics: Mapping[str, Any]) -> dict[str, Any]:
    names = {"steps_total": "steps", "singular_poses": "singular_poses", "break_points": "steps_with_breaks"}
    counts = {name: int(statistics.get(key, 0)) for name, key in names.items()}
    return {**counts, "contradictions": len(statistics.get("contradiction", {}).get("joints", ()))}


def _level(error: float) -> Literal["good", "coarse", "wrong"]:
    if error <= GOOD:
        return "good"
    return "coarse" if error <= WRONG else "wrong"


def _sentence(error: float, violation: float, state: float, method: Method) -> str:
    if not math.isfinite(error):
        return "the motion is lost: use a much smaller step"
    if error <= GOOD:
        return f"accurate to about {_figure(error)}"
    if VIOLATED * violation >= error:
        size = f"{_percent(violation)} of the mechanism's size"
        return f"the constraints are violated by {size}: {method.advice(error)}"
    return method.advice(error)


def _off(error: float) -> str:
    return f"about {_percent(error)} off" if error < 1 else "the motion is another one"


def _figure(error: float) -> str:
    return f"{max(error, 1e-15):.0e}".replace("e-0", "e-")


def _percent(error: float) -> str:
    return f"{100 * error:.2g} %" if error < 0.995 else f"{100 * error:.0f} %"


def _rounded(value: float) -> float:
    """Down to 1, 2 or 5 times a power of ten."""
    if not value > 0:
        return 0.0
    power = 10.0 ** math.floor(math.log10(value))
    return float(f"{max(digit for digit in (1, 2, 5) if digit <= value / power + 1e-9) * power:.0e}")
