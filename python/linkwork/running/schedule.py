"""When a run steps and what it keeps: with a fixed step, or with steps that follow tolerances."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core
from linkwork.arguments import array
from linkwork.arrays import Floats
from linkwork.equations.system import System
from linkwork.errors import OptionError
from linkwork.integrators import EmbeddedPair, Integrator
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot
from linkwork.options import LEAST_RTOL, check_estimate, check_setting, check_step
from linkwork.running import breakpoints, checks
from linkwork.running.recording import PythonStep

__all__ = ["Adaptive", "Fixed", "evenly", "plan"]

#: Frames recorded where nothing is said about them, and the memory they may take [bytes].
FRAMES, FRAME_BYTES = 1000, 2**30

#: Of a run with steps that follow tolerances, where something must be assumed.
ADAPTIVE_EVALUATIONS = 5e4

#: Beyond, a run is refused by the driver.
MOST_STEPS = 1e15

#: Times that are one, relative to the step.
SAME_TIME = 1e-9

#: Steps, at least, between those that end when one of a second run does.
APART = 5

#: Where only the other tolerance is given.
USUAL_RTOL, USUAL_RATIO = 1e-6, 1e-3


@dataclass(frozen=True)
class Fixed:
    """A run with a fixed step [s]."""

    t_end: float
    step: float
    record_every: int

    usual_integrator: ClassVar[str] = "rk4"

    def expected_frames(self, run: _core.Run) -> int:
        return run.steps_total // self.record_every + 3

    def finer(self, times: NDArray[np.float64], onsets: bool = False, met: bool = False) -> dict[str, Any]:
        """Arguments of a run with half the step and frames at the same times.

        onsets  contacts begin, at a speed that is known where a step ends. Where a step of both ends, both
                are off by the same: with a little less than half of it that is so at frames alone
        met     steps end at breaks: those of the finer run as well, of a third
        """
        if not onsets or met:
            parts = 3 if onsets else 2
            return {"step": self.step / parts, "record_every": parts * self.record_every}
        steps = self.record_every * math.ceil(APART / self.record_every)
        return {"step": self.step * steps / (2 * steps + 1), "record_every": 2 * steps + 1}

    def least_steps(self, t_start: float) -> float:
        return (self.t_end - t_start) / self.step

    def evaluations(self, method: Any, t_start: float) -> float:
        """About so many."""
        return self.least_steps(t_start) * max(1, len(getattr(method, "A", ())))

    def chosen(self) -> dict[str, Any]:
        return {"t_end": self.t_end, "step": self.step, "record_every": self.record_every}

    def steps(self) -> dict[str, Any]:
        """What decides on the steps."""
        return {"step": self.step}

    def check(self, method: Integrator | PythonStep, system: System) -> None:
        """OptionError: gains or force elements that are too stiff for the integrator at this step."""
        checks.check_gains(method, system.compiled(), self.step)
        if isinstance(method, Integrator):
            checks.check_stiffness(method, system, self.step)

    def run(
        self,
        method: Integrator | PythonStep,
        system: System,
        events: Sequence[_core.Event],
        start: Snapshot | None = None,
        breaks: Sequence[float] = (),
    ) -> _core.Simulation:
        """OptionError: events, for which there is no interpolant."""
        if events:
            raise OptionError(
                "events are located by an interpolant, which runs with a fixed step do not have: give rtol",
                code="conflict",
            )
        compiled = method.compiled() if isinstance(method, Integrator) else None
        return _core.Simulation(
            system.compiled(),
            compiled,
            t_end=self.t_end,
            step=self.step,
            record_every=self.record_every,
            breaks=list(breaks),
            **_from(start),
        )

    def between_parts(self, model: Model, known: Sequence[float], t_start: float) -> Sequence[float]:
        """Breaks at which parts of steps end that are taken again: all of them, that at the start, too."""
        return breakpoints.beside(model, known, t_start, self.t_end)

    def beside(
        self, model: Model, known: Sequence[float], t_start: float, run: _core.Run | None = None
    ) -> Sequence[float]:
        """Breaks beside which functions are evaluated, not at them, and the ends of steps at them."""
        found = _core.BreakPoints(breakpoints.beside(model, known, t_start, self.t_end))
        found.meet_steps(_origin(run), self.step, (t_start, self.t_end))
        return found.times

    def steps_with_breaks(self, breaks: Sequence[float], run: _core.Run | None = None) -> dict[str, int]:
        """How many steps go over break points: those at which steps end are between two."""
        inside = [t for t in breaks if t < self.t_end - SAME_TIME * self.step]
        ends = [(t - _origin(run)) / self.step for t in inside]
        same = [SAME_TIME + breakpoints.ROUNDING * abs(t) / self.step for t in inside]
        steps = {math.ceil(it) for it, near in zip(ends, same, strict=True) if abs(it - round(it)) > near}
        return {"steps_with_breaks": len(steps)} if steps else {}


@dataclass(frozen=True)
class Adaptive:
    """A run with steps that follow tolerances; `record_every` 0: frames at `times` alone."""

    t_end: float
    rtol: float
    atol: float
    largest_step: float
    record_every: int
    times: NDArray[np.float64]

    usual_integrator: ClassVar[str] = "dopri5"

    def expected_frames(self, run: _core.Run) -> int | None:
        return None if self.record_every else len(self.times) + 1

    def finer(self, times: NDArray[np.float64], onsets: bool = False, met: bool = False) -> dict[str, Any]:
        """Arguments of a run with a tenth of the tolerances and frames at these times. Half the largest step:
        where that limits steps, and not the tolerances, a run with the same one would have the same error."""
        largest = self.largest_step / 2 if math.isfinite(self.largest_step) else None
        rtol = max(self.rtol / 10, LEAST_RTOL)
        return {"rtol": rtol, "atol": self.atol / 10, "step": largest, "times": np.unique(times)}

    def least_steps(self, t_start: float) -> float:
        return (self.t_end - t_start) / self.largest_step

    def evaluations(self, method: Any, t_start: float) -> float:
        """Nobody knows: as of a run of some thousand steps."""
        return ADAPTIVE_EVALUATIONS

    def chosen(self) -> dict[str, Any]:
        return {
            "t_end": self.t_end,
            "rtol": self.rtol,
            "atol": self.atol,
            "largest_step": self.largest_step if math.isfinite(self.largest_step) else None,
            "record_every": self.record_every or None,
        }

    def steps(self) -> dict[str, Any]:
        """What decides on the steps."""
        return {"rtol": self.rtol, "atol": self.atol, "largest_step": self.largest_step}

    def check(self, method: Integrator | PythonStep, system: System) -> None:
        """OptionError: an integrator without an error estimate."""
        check_estimate(method)

    def run(
        self,
        method: Integrator | PythonStep,
        system: System,
        events: Sequence[_core.Event],
        start: Snapshot | None = None,
        breaks: Sequence[float] = (),
    ) -> _core.AdaptiveSimulation:
        assert isinstance(method, EmbeddedPair)
        return _core.AdaptiveSimulation(
            system.compiled(),
            method.compiled_pair(),
            t_end=self.t_end,
            rtol=self.rtol,
            atol=self.atol,
            largest_step=self.largest_step,
            record_every=self.record_every,
            times=self.times.tolist(),
            events=list(events),
            breaks=list(breaks),
            happened=_happened(events, start),
            listed=_listed(events, start),
            **_from(start),
        )

    def between_parts(self, model: Model, known: Sequence[float], t_start: float) -> Sequence[float]:
        """Breaks at which parts of steps end that are taken again: none, as steps end there."""
        return ()

    def beside(
        self, model: Model, known: Sequence[float], t_start: float, run: _core.Run | None = None
    ) -> Sequence[float]:
        """Breaks beside which functions are evaluated, not at them: all."""
        return breakpoints.beside(model, known, t_start, self.t_end)

    def steps_with_breaks(self, breaks: Sequence[float], run: _core.Run | None = None) -> dict[str, int]:
        """None: steps end at each."""
        return {}


def _origin(run: _core.Run | None) -> float:
    """From which fixed steps are counted [s]."""
    return run.origin if isinstance(run, _core.Simulation) else 0.0


def _happened(events: Sequence[_core.Event], start: Snapshot | None) -> list[tuple[int, NDArray[np.float64]]]:
    """The events that came at the time of the start, by index, with y before them (13n,). OptionError: what
    is no list of them."""
    if start is None:
        return []
    try:
        known = [(str(label), np.asarray(y, dtype=float)) for label, y in start.happened]
    except (TypeError, ValueError) as error:
        raise OptionError(
            f"start: happened {start.happened!r:.80} is no list of (label, y before) of events", code="start"
        ) from error
    wrong = next((label for label, y in known if y.shape != start.y.shape), None)
    if wrong is not None:
        raise OptionError(
            f"start: happened: y before event '{wrong}' has not the {len(start.y)} numbers of (q, v)",
            code="start",
        )
    return [(k, y) for k, event in enumerate(events) for label, y in known if label == event.name]


def _listed(events: Sequence[_core.Event], start: Snapshot | None) -> list[tuple[int, float]] | None:
    """Those that the run before has listed since its checkpoint, by index, with their times [s]; None: nobody
    knows."""
    if start is None or start.resume is None or start.resume.listed is None:
        return None
    known, labels = start.resume.listed, {event.name for event in events}
    if len(labels) < len(events) and any(isinstance(which, str) for which, _ in known):
        return None
    return [(k, t) for k, event in enumerate(events) for which, t in known if which in (k, event.name)]


def _from(start: Snapshot | None) -> _Start:
    return {} if start is None else {"t_start": start.t, "start": start.y}


class _Start(TypedDict, total=False):
    t_start: float
    start: NDArray[np.float64]


def plan(
    t_end: float,
    step: float | None,
    rtol: float | None,
    atol: float | None,
    record_every: int | None,
    times: ArrayLike | None,
    frame_bytes: int,
    t_start: float = 0.0,
) -> Fixed | Adaptive:
    """The arguments of `simulate` as a schedule. OptionError: a value that makes no sense, or a conflict."""
    check_setting("t_end", t_end)
    t_end = float(t_end)
    if step is not None:
        check_setting("step", step)
        step = float(step)
    if record_every is not None:
        check_setting("record_every", record_every)
    if t_start > t_end:
        raise OptionError(f"the start, at {t_start:g} s, is after t_end {t_end:g} s", code="start")
    if rtol is None and atol is None:
        return _fixed(t_end, step, record_every, times, _most_frames(frame_bytes), t_start)
    if record_every is None and times is None:
        times = evenly(t_start, t_end, frame_bytes)
    return _adaptive(t_end, step, rtol, atol, record_every, times, t_start)


def evenly(t_start: float, t_end: float, frame_bytes: int) -> Floats:
    """The times of frames [s] where nothing is said about them; one where nothing is left to run."""
    return np.unique(np.linspace(t_start, t_end, _most_frames(frame_bytes) + 1))


def _most_frames(frame_bytes: int) -> int:
    return min(FRAMES, max(1, FRAME_BYTES // frame_bytes))


def _fixed(
    t_end: float,
    step: float | None,
    record_every: int | None,
    times: ArrayLike | None,
    most_frames: int,
    t_start: float,
) -> Fixed:
    if step is None:
        raise OptionError("step is missing: give a step [s], or rtol for steps that follow it", code="step")
    if times is not None:
        raise OptionError(
            "times needs steps that follow tolerances: give rtol, or record_every instead of times",
            code="conflict",
        )
    goes_on = t_start != 0.0  # its steps are those of the run before, of which this may be less than one
    if not goes_on:
        check_step(step, t_end)
    every = record_every or max(1, math.ceil(min((t_end - t_start) / step, MOST_STEPS) / most_frames))
    return Fixed(t_end=t_end, step=step, record_every=int(every))


def _adaptive(
    t_end: float,
    step: float | None,
    rtol: float | None,
    atol: float | None,
    record_every: int | None,
    times: ArrayLike | None,
    t_start: float,
) -> Adaptive:
    rtol = USUAL_RTOL if rtol is None else rtol
    check_setting("rtol", rtol)
    rtol = float(rtol)
    atol = USUAL_RATIO * rtol if atol is None else atol
    check_setting("atol", atol)
    asked = np.zeros(0) if times is None else _checked_times(times, t_start, t_end)
    return Adaptive(
        t_end=t_end,
        rtol=rtol,
        atol=float(atol),
        largest_step=math.inf if step is None else step,
        record_every=int(record_every or 0),
        times=asked,
    )


def _checked_times(times: ArrayLike, t_start: float, t_end: float) -> NDArray[np.float64]:
    asked = np.atleast_1d(array(times, "times"))
    if asked.ndim != 1 or not len(asked) or not np.isfinite(asked).all() or (np.diff(asked) <= 0).any():
        raise OptionError("times must be finite and ascending, one at least", code="times")
    if asked[0] < t_start or asked[-1] > t_end:
        raise OptionError(
            f"times go from {asked[0]:g} to {asked[-1]:g} s, the run from {t_start:g} to {t_end:g} s",
            code="times",
        )
    return asked
