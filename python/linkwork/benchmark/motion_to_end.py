"""One run to its end for its time: where the bodies are then, and whether physics held on the way."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import LinkworkError
from linkwork.modeling.model import Model
from linkwork.running import recording, schedule, simulation

__all__ = ["Motion", "Trial", "attempt", "distance", "move", "spread", "try_steps", "unsound"]

#: Looks at energy and violation on the way.
LOOKS = 20

#: What a run may violate, of the size of the mechanism, and lose of the energy that it exchanges; how much
#: narrower than the true one a mechanism may become.
VIOLATION, ENERGY, NARROWER = 1e-3, 0.05, 0.1

#: Of a run, between two pieces [s], and frames of a piece.
PIECE_SECONDS, PIECE_FRAMES = 1.0, 1


@dataclass(frozen=True)
class Motion:
    """The end of a run, and the way there."""

    start: Floats  #: centers of the bodies (n, 3) [m]
    end: Floats  #: the same at the end
    cpu_seconds: float  #: of the steps, on all threads
    seconds: float  #: of the clock
    steps: int
    setup_seconds: float  #: from the model to the first step
    violation: float  #: the largest of a position constraint, relative to the size of the mechanism
    energy_error: float  #: the largest, relative to what energies changed by
    rank: Mapping[str, Any]  #: equations, rank, degrees_of_freedom, redundant


@dataclass(frozen=True)
class Trial:
    """The first steps of a run."""

    steps: int
    cpu_seconds: float  #: of one step, on all threads: the median
    seconds: float  #: the same of the clock
    setup_seconds: float  #: from the model to the first step
    rank: Mapping[str, Any]  #: as in Motion


def try_steps(model: Model, step: float, method: str, most: int, limit: float, **options: Any) -> Trial:
    """So many steps of a run; fewer, but one, where they take longer than the limit [CPU s].

    One more ends the run, which is no part of the cost of a step, but needs memory; not beyond the limit.
    LinkworkError: it cannot, or fails.
    """
    ready, setup = _prepared(model, (most + 1) * step, step, method, 1, options)
    cpu: list[float] = []
    clock: list[float] = []
    while not cpu or (len(cpu) < most and sum(cpu) < limit):
        before = time.process_time(), time.perf_counter()
        ready.run.advance(PIECE_FRAMES, 0.0)
        cpu.append(time.process_time() - before[0])
        clock.append(time.perf_counter() - before[1])
        ready.run.take_frames()
    while not ready.run.finished and sum(cpu) < limit:
        ready.run.advance(PIECE_FRAMES, 0.0)
        ready.run.take_frames()
    rank = ready.facts["constraints"]
    return Trial(len(cpu), float(np.median(cpu)), float(np.median(clock)), setup, rank)


def _prepared(
    model: Model, t_end: float, step: float, method: str, every: int, options: Mapping[str, Any]
) -> tuple[Any, float]:
    """A run that records each so many steps, and what it took to set it up [s]. LinkworkError: it cannot."""
    began = time.perf_counter()
    plan = schedule.plan(t_end, step, None, None, every, None, recording.frame_bytes(model), 0.0)
    given = {"t_end": t_end, "step": step, "integrator": method, "breaks": (), "assemble": True, **options}
    ready = simulation.prepared(model, plan, given, options)  # type: ignore[arg-type]
    return ready, time.perf_counter() - began


def move(
    model: Model,
    t_end: float,
    step: float,
    method: str,
    *,
    limit: float = np.inf,
    looks: int = LOOKS,
    **options: Any,
) -> Motion:
    """Steps of a method to the end. LinkworkError: it cannot, fails, or takes longer than the limit [CPU s].

    Beside the steps nothing is computed: no verdict, and so many frames after the first.
    """
    steps = max(1, round(t_end / step))
    ready, setup = _prepared(model, t_end, step, method, max(1, -(-steps // looks)), options)
    run = ready.run
    start = np.array(run.last_state[: 7 * model.body_count]).reshape(-1, 7)[:, :3]
    energies, violation = [], 0.0
    clock, cpu = time.perf_counter(), time.process_time()
    while not run.finished:
        if time.process_time() - cpu > limit:
            reached = f"{run.steps_done} of {steps} steps"
            raise LinkworkError(f"{reached} took {limit:.0f} s, the limit", code="time")
        run.advance(PIECE_FRAMES, PIECE_SECONDS)
        frames = run.take_frames()
        if len(frames["t"]):
            energies.append([frames[name] for name in ("kinetic", "potential", "work")])
            violation = max(violation, run.relative_violation())
    cpu, clock = time.process_time() - cpu, time.perf_counter() - clock
    end = np.array(run.last_state[: 7 * model.body_count]).reshape(-1, 7)[:, :3]
    return Motion(
        start, end, cpu, clock, run.steps_done, setup, violation,
        _energy_error(np.concatenate(energies, axis=1)), ready.facts["constraints"],
    )  # fmt: skip


def unsound(motion: Motion, true: Motion | None = None) -> str:
    """Why a run is no motion of the mechanism, by the physics and beside the true motion; empty: it is."""
    if not np.isfinite(motion.end).all():
        return "not finite"
    if not motion.violation < VIOLATION:
        return f"violates its joints by {motion.violation:.0e} of its size"
    if not motion.energy_error < ENERGY:
        return f"loses or gains {motion.energy_error:.0%} of the energy that it exchanges"
    width = spread(motion.start if true is None else true.end)
    if not spread(motion.end) > (NARROWER if true is None else 1 - NARROWER) * width:
        return "has collapsed"
    return ""


def spread(points: Floats) -> float:
    """Root of the mean square distance of points (n, 3) from their mean [m]."""
    return float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=1))))


def _energy_error(found: Floats) -> float:
    """From (kinetic, potential, work) at each frame (3, frames)."""
    kinetic, potential, work = found
    balance = kinetic + potential - work
    exchanged = max(float(np.abs(kinetic).max()), float(np.ptp(potential)), float(np.ptp(work)))
    return float(np.abs(balance - balance[0]).max()) / max(exchanged, 1e-300)


def distance(found: Motion, true: Motion) -> float:
    """The largest between a body and where it should be, over the farthest that one has moved."""
    moved = float(np.linalg.norm(true.end - true.start, axis=1).max())
    return float(np.linalg.norm(found.end - true.end, axis=1).max()) / max(moved, 1e-300)


def attempt(model: Model, t_end: float, step: float, method: str, **options: Any) -> Motion | str:
    """`move`, or in words why not."""
    try:
        return move(model, t_end, step, method, **options)
    except LinkworkError as error:
        return str(error)
