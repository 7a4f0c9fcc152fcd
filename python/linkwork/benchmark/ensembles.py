"""Right-hand sides of equal mechanisms in the lanes of the processor, beside that of one by itself."""

from __future__ import annotations

import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.arguments import whole
from linkwork.benchmark.articulated import articulated
from linkwork.benchmark.rollout import Measure, rollouts
from linkwork.benchmark.subject import Subject
from linkwork.benchmark.timing import WINDOW_SECONDS, Timing
from linkwork.equations.system import System
from linkwork.errors import LinkworkError, OptionError
from linkwork.modeling.model import Model
from linkwork.running.progress import ShowOption, counting

__all__ = ["SUBJECTS", "Lanes", "measure_lanes"]

#: A chain, a ladder of four-bars, and what has loops in space: name and bodies (None: one size only).
SUBJECTS: Sequence[tuple[str, int | None]] = (
    ("chain", 10), ("four_bar", 21), ("bricard", None), ("spatial_slider_crank", None),
    ("stewart_platform", None),
)  # fmt: skip

#: Beyond, accelerations by lanes are not those of the usual arithmetic [relative to the largest].
AGREES = 1e-9


@dataclass(frozen=True)
class Lanes:
    """One mechanism; times are of one right-hand side with reactions of one mechanism [ns], medians."""

    mechanism: str
    bodies: int
    lanes: int  #: of a pack
    single: float  #: by itself
    deterministic: float  #: by itself, with the bits that lanes have
    packed: dict[int, float]  #: in lanes, of all of them, by threads
    difference: float  #: of accelerations from those by itself, relative to the largest
    mujoco: dict[int, float]  #: of one step of MuJoCo's rollout, of the chain, by threads; none without it
    pinocchio: dict[int, float]  #: of one evaluation by Pinocchio, by threads; none without it
    pinocchio_solves: str  #: its algorithm, or why there is none


def measure_lanes(
    subjects: Sequence[tuple[str, int | None]] = SUBJECTS,
    *,
    threads: Sequence[int] = (1, 2),
    rounds: int = 9,
    progress: ShowOption = None,
) -> list[Lanes]:
    """Time each of the mechanisms alone and in full packs, one a thread, in alternation.

    Before a time counts, lanes must give the bits of the deterministic run, and the accelerations of the
    usual one. LinkworkError: they do not. OptionError: lanes cannot run a mechanism, or there is none.
    """
    whole(rounds, 1, "rounds")
    found = []
    with counting(progress, len(subjects)) as report:
        for place, (name, bodies) in enumerate(subjects):
            report(place, name)
            model = Subject.of(name, bodies).build()
            found.append(_measured(name, model, [whole(it, 1, "threads") for it in threads], rounds))
    return found


def _measured(name: str, model: Model, threads: Sequence[int], rounds: int) -> Lanes:
    y = np.concatenate([model.compiled().q0, model.compiled().v0])
    timings = [Timing(System(model, deterministic=exact), 0.0, y, rounds) for exact in (False, True)]
    packs = {count: _packs(model, count * _core.lane_count()) for count in threads}
    difference = max(_difference(name, model, y, it, count) for count, it in packs.items())
    once = _core.time_lanes(packs[threads[0]], 3, threads[0])[0]
    repetitions = max(1, round(WINDOW_SECONDS / max(once, 1e-7)))

    def in_lanes(count: int) -> float:
        seconds = _core.time_lanes(packs[count], repetitions, count)[0]
        return float(seconds) / (count * _core.lane_count())

    peer = articulated(model, threads)
    own = {count: partial(in_lanes, count) for count in threads}
    with rollouts(model, _turning(model, y), threads if name == "chain" else ()) as mujoco:
        packed, stepped, evaluated = _in_turn(timings, [own, mujoco, peer.seconds], rounds)
    alone, deterministic = (1e9 * it.seconds["whole"] for it in timings)
    found = packed, difference, stepped, evaluated, peer.solves
    return Lanes(name, model.body_count, _core.lane_count(), alone, deterministic, *found)


def _in_turn(
    timings: Sequence[Timing], sides: Sequence[Mapping[int, Measure]], rounds: int
) -> list[dict[int, float]]:
    """Medians of the measures of each side by threads [ns], all of which are taken in every round."""
    samples: list[dict[int, list[float]]] = [{count: [] for count in side} for side in sides]
    for _ in range(rounds):
        for timing in timings:
            timing.measure()
        for side, found in zip(sides, samples, strict=True):
            for count, measure in side.items():
                found[count].append(1e9 * measure())
    return [{count: statistics.median(times) for count, times in found.items()} for found in samples]


def _turning(model: Model, y: Any) -> Any:
    """Angular accelerations about y [rad/s2]."""
    v_dot = System(model).compiled().derivative(0.0, y)[7 * model.body_count :]
    return v_dot[: 6 * model.body_count].reshape(-1, 6)[:, 4]


def _packs(model: Model, count: int) -> list[Any]:
    return [System(model, deterministic=True).compiled() for _ in range(count)]


def _difference(name: str, model: Model, y: Any, pack: list[Any], threads: int) -> float:
    """From the usual accelerations. LinkworkError: lanes are wrong, and their time counts for nothing."""
    try:
        _, found = _core.time_lanes(pack, 1, threads)
    except OptionError as error:
        raise OptionError(f"{name}: {error}", code="lanes") from error
    velocities = slice(7 * model.body_count, 13 * model.body_count)
    with _core.OnePath(True):
        exact = System(model, deterministic=True).compiled().derivative(0.0, y)[velocities]
    usual = System(model).compiled().derivative(0.0, y)[velocities]
    apart = max(float(np.abs(it - usual).max()) for it in found) / max(float(np.abs(usual).max()), 1e-300)
    if not all(np.array_equal(it, exact) for it in found) or not apart < AGREES:
        raise LinkworkError(f"{name}: lanes give other accelerations, {apart:.1e} off", code="lanes")
    return apart
