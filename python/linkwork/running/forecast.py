"""What a large run will take, told before its first step: time, memory, room for what is recorded."""

from __future__ import annotations

import logging
import math
import os
import sys
from dataclasses import dataclass
from typing import Any

from linkwork import memory
from linkwork.equations.system import System
from linkwork.errors import LinkworkError, OptionError, warn
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot
from linkwork.running.progress import ProgressOption, screen, time_in_words
from linkwork.running.recording import PIECE_BYTES, PythonStep, frame_bytes
from linkwork.running.schedule import Adaptive, Fixed

__all__ = ["Forecast", "announce", "look_ahead"]

log = logging.getLogger(__name__)

#: Runs that take less are not told of [s, bytes].
LARGE_SECONDS, LARGE_BYTES = 2.0, 3e8

#: What a right-hand side takes at least, and for each body [s]; memory of a body [bytes]. By these nobody
#: needs to measure that a run is small.
LEAST_SECONDS, BODY_SECONDS, BODY_BYTES = 5e-7, 1e-7, 8000.0

#: Right-hand sides are watched for so long [s].
WATCHED = 5e-3

#: Vectors of a state that an integrator has beside its stages [bytes a body].
STATE_BYTES, VECTORS = 8.0 * 13, 3

#: Steps that are kept for the verdict take at most so much [bytes]; each has two states.
KEPT_BYTES = 2.0**27

#: Evaluations that the verdict holds beside that of the run, and each of them for every body and row [bytes].
VERDICT_EVALUATIONS, EVALUATION_BODY_BYTES, EVALUATION_ROW_BYTES = 4, 200.0, 96.0

#: Frames on their way into a file.
CHUNKS_BYTES = 1.5 * PIECE_BYTES

#: What is told by a warning, and what nobody waits for [s].
LONG, ABSURD = 6 * 3600.0, 30 * 86400.0


@dataclass(frozen=True)
class Forecast:
    """Of a run before its first step."""

    step_evaluations: int  #: right-hand sides of a step
    evaluation_seconds: float  #: of each, measured; 0 where there is none at the start
    steps: float | None  #: None: as many as the tolerances ask for
    memory: (
        float  #: most, of the process: model, evaluation, factors, steps, verdict, frames in memory [bytes]
    )
    factors: float | None  #: of which factors [bytes]; None: the solver does not tell
    frames: int | None  #: None: nobody knows
    frame_bytes: float  #: of each frame
    output: str | None  #: the file that has them; None: memory

    @property
    def seconds(self) -> float | None:
        """Of all steps, without what is recorded and the estimate of the error; None: nobody knows."""
        return None if self.steps is None else self.steps * self.step_seconds

    @property
    def step_seconds(self) -> float:
        return self.step_evaluations * self.evaluation_seconds

    @property
    def recorded(self) -> float | None:
        """All frames [bytes]; None: nobody knows how many."""
        return None if self.frames is None else self.frames * self.frame_bytes

    def numbers(self) -> dict[str, Any]:
        """For the manifest; times in s, sizes in bytes."""
        return {
            "seconds": self.seconds, "evaluation_seconds": self.evaluation_seconds, "steps": self.steps,
            "memory": self.memory, "factors": self.factors, "frames": self.frames,
            "frame_bytes": self.frame_bytes, "recorded": self.recorded,
        }  # fmt: skip

    def text(self) -> str:
        """All of it in a line."""
        return "; ".join([f"expected: {self._time()}", self._memory(), self._frames()])

    def _time(self) -> str:
        each = f"{self.step_evaluations} x {_short(self.evaluation_seconds)}"
        if self.seconds is None:
            return f"{_short(self.step_seconds)} a step ({each}), as many steps as the tolerances ask for"
        return f"{time_in_words(self.seconds)} for {self.steps:.4g} steps (each {each})"

    def _memory(self) -> str:
        factors = f" ({memory.in_words(self.factors)} of it factors)" if self.factors else ""
        return f"{memory.in_words(self.memory)} of memory{factors}"

    def _frames(self) -> str:
        where = f"in '{self.output}'" if self.output else "of that frames"
        if self.recorded is None:
            return f"each frame {memory.in_words(self.frame_bytes)} {where}"
        return f"{memory.in_words(self.recorded)} {where} ({self.frames} frames)"


def look_ahead(
    system: System,
    plan: Fixed | Adaptive,
    method: Integrator | PythonStep,
    start: Snapshot | None,
    frames: int | None,
    output: str | os.PathLike[str] | None,
) -> Forecast | None:
    """What the run will take that `system` is about to make; None: not much."""
    bodies, size = system.model.body_count, float(frame_bytes(system.model))
    t_start = start.t if start is not None else 0.0
    evaluations = max(1, len(getattr(method, "A", ())))
    least = plan.least_steps(t_start) * evaluations * max(LEAST_SECONDS, BODY_SECONDS * bodies)
    if least < LARGE_SECONDS / 4 and bodies * BODY_BYTES + (frames or 0) * size < LARGE_BYTES / 2:
        return None
    evaluation = _evaluation_seconds(system, start)
    steps = plan.least_steps(t_start) if isinstance(plan, Fixed) else None
    kept = (frames or 0) * size if output is None else min(CHUNKS_BYTES, 2 * size * (frames or 2))
    found = Forecast(
        step_evaluations=evaluations,
        evaluation_seconds=evaluation,
        steps=steps,
        memory=memory.in_use() + kept + _steps_bytes(system.model, evaluations, steps or math.inf),
        factors=system.compiled().factorization_cost()["bytes"],
        frames=frames,
        frame_bytes=size,
        output=None if output is None else os.fspath(output),
    )
    _check_time(plan.least_steps(t_start), found.step_seconds)
    large = max(found.memory, found.recorded or 0.0) > LARGE_BYTES
    return found if large or (found.seconds or 0.0) > LARGE_SECONDS else None


def _steps_bytes(model: Model, stages: int, steps: float) -> float:
    """What steps and the verdict on them take beside model, evaluation and factors."""
    state, evaluation = STATE_BYTES * model.body_count, EVALUATION_BODY_BYTES * model.body_count
    kept = min(KEPT_BYTES, 2 * state * steps)
    evaluation += EVALUATION_ROW_BYTES * model.row_count
    return state * (stages + VECTORS) + kept + VERDICT_EVALUATIONS * evaluation


def announce(forecast: Forecast | None, progress: ProgressOption) -> None:
    """Where progress is shown, and in the log; None: there is nothing to be told."""
    if forecast is None:
        return
    log.info("%s", forecast.text())
    if (progress is None or progress is True) and screen():
        print(forecast.text(), file=sys.stderr, flush=True)


def _evaluation_seconds(system: System, start: Snapshot | None) -> float:
    """The time of a right-hand side at the start, 0 where there is none."""
    t, y = (0.0, system.initial_state()) if start is None else (start.t, start.y)
    try:
        least: float = system.compiled().least_time_ahead(t, y, WATCHED)
    except LinkworkError:  # the run will say what it is
        return 0.0
    return least


def _check_time(steps: float, step_seconds: float) -> None:
    """LinkworkWarning: the run will take hours. OptionError: months."""
    seconds = steps * step_seconds
    if seconds < LONG:
        return
    found = f"the run takes {steps:.3g} steps, about {time_in_words(seconds)} on this machine"
    remedy = "give a larger step, or rtol for steps that follow the motion"
    if seconds > ABSURD:
        raise OptionError(f"{found}: {remedy}", code="too_long")
    warn(f"{found}; where that is too long, {remedy}")


def _short(seconds: float) -> str:
    for size, unit in ((1.0, "s"), (1e-3, "ms")):
        if seconds >= size:
            return f"{seconds / size:.2g} {unit}"
    return f"{seconds / 1e-6:.2g} us"
