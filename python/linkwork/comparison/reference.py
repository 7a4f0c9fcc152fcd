"""The solution that errors are measured against, and how far it may be trusted."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np

from linkwork.accuracy.measures import Bodies, Differences, Sampled, Scales
from linkwork.arrays import Floats
from linkwork.comparison.workers import Lost, in_processes
from linkwork.errors import LinkworkError, ModelError, OptionError
from linkwork.modeling.model import Model
from linkwork.motion import summary
from linkwork.results.result import Result
from linkwork.running.estimation import warn_of_memory
from linkwork.running.interrupts import Interrupts
from linkwork.running.simulation import simulate

__all__ = ["ERRORS", "Reference", "given_reference", "solved_reference"]

#: Of a run against the reference, see `measures`.
ERRORS = ("state_error", "pose_error", "velocity_error", "reaction_error")

#: Tried one after the other: rtol; each is judged by a run with a smaller tolerance.
TOLERANCES, TIGHTER = (1e-12, 1e-11, 1e-10), 0.3

#: Two runs that differ by more have passed something that magnifies rounding, such as a singular pose, where
#: chance makes one better than another: more are tried, and the two that agree best are taken.
AGREED = 1e-8

#: What a reference is computed with; the second where the first fails.
METHODS: tuple[dict[str, Any], ...] = (
    {"formulation": "standard", "stabilization": "projection", "integrator": "dop853"},
    {"formulation": "augmented_lagrangian", "stabilization": "projection", "integrator": "dop853"},
)

#: No double precision is better, even where two runs agree by chance.
ROUNDING = 1e-15

#: A reference with a larger error is improved on, if that is possible.
GOOD_ENOUGH = 1e-6


@dataclass(frozen=True)
class Reference:
    """A motion, its scales, and its own error: None where that is not known."""

    motion: Sampled
    scales: Scales
    description: str
    error: Mapping[str, float] | None  #: pose, velocity, state and reaction error, largest over time
    steps: int | None  #: that it took
    seconds: float | None
    unique_joints: Sequence[str]
    joint_count: int
    model_hash: str | None = None  #: of what was run; None: not known

    def errors(self, motion: Sampled) -> dict[str, float]:
        """Largest pose, velocity, state and reaction error of another motion."""
        return largest(Differences.between(motion, self.motion), self.scales)


def largest(differences: Differences, scales: Scales) -> dict[str, float]:
    """The errors of `measures`, largest over time; NaN where there are no unique reactions."""
    return {
        "pose_error": _most(differences.pose(scales)),
        "velocity_error": _most(differences.velocities(scales)),
        "state_error": _most(differences.state(scales)),
        "reaction_error": _most(differences.reaction(scales)),
    }


def given_reference(
    reference: Result | str | os.PathLike[str], state_error: float | None = None
) -> Reference:
    """A known solution; its error is what its owner says, if anything. FileError: the file cannot be read.

    A statement about states is one about poses and velocities; reactions are taken to be as good.
    """
    result = reference if isinstance(reference, Result) else Result.load(reference)
    name = "given result" if isinstance(reference, Result) else str(reference)
    words = summary.method(result.manifest.get("options", {}), short=True)
    made = _made(result, ": ".join(filter(None, [name, ", ".join(words)])), None)
    if state_error is None:
        return made
    return replace(made, error=dict.fromkeys(ERRORS, state_error))


def solved_reference(
    model: Model,
    t_end: float,
    times: Floats,
    processes: int | None = None,
    seconds: float | None = None,
    beat: Callable[[Sequence[int]], object] = lambda places: None,
) -> Reference:
    """DOP853 with projection at a tight tolerance; its error is the difference to a run at a tighter one.

    The two take different steps, so their errors, of truncation and of rounding, are independent: the
    difference is about that of the first run. Where rounding is magnified, of more runs the two count that
    agree best. OptionError: no method gives a solution.
    """
    failures: list[str] = []
    for method in METHODS:
        found: dict[float, Result] = {}
        best: Reference | None = None
        for rtol in TOLERANCES:
            pair = (rtol, TIGHTER * rtol)
            runs = [_Run(model, t_end, times, method, tolerance) for tolerance in pair]
            with Interrupts() as interrupts:
                for place, answer in interrupts.each(in_processes(_solve, runs, processes, seconds, beat)):
                    if isinstance(answer, Result):
                        found[pair[place]] = answer
                    else:
                        failures.append(f"{method['formulation']}, rtol {pair[place]:g}: {answer.reason}")
            best = _closest(found, method)
            if best is not None and best.error is not None and best.error["state_error"] <= AGREED:
                return best
        if best is not None:
            return best
    raise OptionError(
        f"no reference solution was found ({'; '.join(dict.fromkeys(failures))}); give one: reference=result",
        code="reference",
    )


def _closest(found: Mapping[float, Result], method: Mapping[str, Any]) -> Reference | None:
    """Of the runs by their rtol the two that agree best: the first, its error the difference to the other."""
    names = [method[axis] for axis in ("integrator", "formulation", "stabilization")]
    made: list[Reference] = [
        _made(found[loose], ", ".join([*names, f"rtol {loose:g}"]), found[tight])
        for tight, loose in combinations(sorted(found), 2)
    ]
    if not made:
        return None
    return min(made, key=lambda it: it.error["state_error"] if it.error else np.inf)


@dataclass(frozen=True)
class _Run:
    model: Model
    t_end: float
    times: Floats
    method: Mapping[str, Any]
    rtol: float


def _solve(run: _Run) -> Result | Lost:
    # An absolute tolerance as fine as the relative one is for coordinates of the size of the mechanism.
    positions = np.abs(run.model.compiled().q0.reshape(-1, 7)[:, :3])
    size = float(positions.max(initial=0.0)) or 1.0
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return simulate(run.model, run.t_end, rtol=run.rtol, atol=run.rtol * min(size, 1.0),
                            times=run.times, progress=False, **run.method)  # fmt: skip
    except ModelError:
        raise
    except LinkworkError as error:
        return Lost(str(error))


def _made(result: Result, description: str, tighter: Result | None) -> Reference:
    motion = Sampled.of(result)
    scales = Scales.of(motion, Bodies.of(result.header))
    error = None
    warn_of_memory(result.verdict)
    if tighter is not None:
        apart = largest(Differences.between(motion, Sampled.of(tighter)), scales)
        least = max(ROUNDING, _of_both(result, tighter))
        error = {name: float(np.maximum(value, least)) for name, value in apart.items()}  # NaN stays
    joints = [
        name for name, unique in zip(result.joint_names, result.unique_reactions, strict=True) if unique
    ]
    return Reference(
        motion, scales, description, error, steps=result.statistics.get("steps"),
        seconds=result.statistics.get("driver_seconds"), unique_joints=joints,
        joint_count=len(result.joint_names), model_hash=result.manifest.get("model_hash"),
    )  # fmt: skip


def _of_both(*results: Result) -> float:
    """The error that two runs may share, such as a pulse that both leap over, where they say so."""
    verdicts = [it.verdict for it in results if it.verdict is not None and it.verdict.level != "good"]
    return max((it.error for it in verdicts), default=0.0)


def _most(values: Floats) -> float:
    return float(values.max(initial=0.0)) if not np.isnan(values).any() else float("nan")
