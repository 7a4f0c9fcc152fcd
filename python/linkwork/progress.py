"""Progress of a long run: one line on a terminal, or a call of the user's function.

`simulate` reports through `reporting(...)`, a series of tasks through `counting(...)`; whether anything is
shown is decided here.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from rich.progress import Progress

#: What `simulate(progress=...)` takes: None shows a line on a terminal, False shows nothing.
ProgressOption = Callable[["ProgressInfo"], object] | Literal[False] | None

#: What a series of tasks takes: None shows a line on a terminal, False shows nothing.
ShowOption = Literal[False] | None

#: A run is silent for this long [s]: most are over by then.
SILENT_SECONDS = 2.0


@dataclass(frozen=True)
class ProgressInfo:
    """Where a run stands."""

    #: simulated time and its end [s]
    t: float
    t_end: float
    #: steps done, and in all (0 when not known)
    steps_done: int
    steps_total: int
    #: wall time since the start [s]
    elapsed: float

    @property
    def fraction(self) -> float:
        """Share of the run that is done, 0 to 1."""
        if self.steps_total > 0:
            return min(self.steps_done / self.steps_total, 1.0)
        return min(self.t / self.t_end, 1.0) if self.t_end > 0 else 1.0

    @property
    def rate(self) -> float:
        """Steps per second of wall time."""
        return self.steps_done / self.elapsed if self.elapsed > 0 else 0.0

    @property
    def remaining(self) -> float | None:
        """Estimated wall time to the end [s]; None before anything is known."""
        return self.elapsed * (1 / self.fraction - 1) if self.fraction > 0 else None


#: What `reporting` hands to the run: report(t, steps_done).
Report = Callable[[float, int], None]


@contextmanager
def reporting(progress: ProgressOption, t_end: float, steps_total: int = 0) -> Iterator[Report]:
    """Give the run its `report(t, steps_done)`; a line that was shown is cleared at the end.

    `progress`: None = automatic (standard error is a terminal and the run takes more than two seconds),
    False = nothing, or a function that is called with a ProgressInfo at every report.
    """
    started = time.monotonic()
    line = _Line() if progress is None and _is_terminal() else None

    def report(t: float, steps_done: int) -> None:
        info = ProgressInfo(t, t_end, steps_done, steps_total, time.monotonic() - started)
        if line is not None:
            line.show(info.elapsed, info.fraction, describe(info))
        elif callable(progress):
            progress(info)

    try:
        yield report
    finally:
        if line is not None:
            line.close()


@contextmanager
def counting(show: ShowOption, total: int) -> Iterator[Callable[[int, str], None]]:
    """Give a series of tasks its `report(done, what)`, called as each begins; shown as by `reporting`."""
    started = time.monotonic()
    line = _Line() if show is None and _is_terminal() else None

    def report(done: int, what: str) -> None:
        if line is not None:
            line.show(time.monotonic() - started, min(done / total, 1.0), what)

    try:
        yield report
    finally:
        if line is not None:
            line.close()


def describe(info: ProgressInfo) -> str:
    """The numbers of the line: simulated time, rate, remaining time."""
    remaining = "" if info.remaining is None else f", {_duration(info.remaining)} left"
    return f"t = {info.t:.4g} of {info.t_end:g} s, {_quantity(info.rate)} steps/s{remaining}"


class _Line:
    """The line on the terminal; it appears only after SILENT_SECONDS."""

    def __init__(self) -> None:
        self._progress: Progress | None = None

    def show(self, elapsed: float, fraction: float, text: str) -> None:
        if elapsed < SILENT_SECONDS:
            return
        if self._progress is None:
            self._progress = _terminal_progress()
            self._progress.start()
            self._progress.add_task("", total=1.0)
        task = self._progress.task_ids[0]
        self._progress.update(task, completed=fraction, description=text)

    def close(self) -> None:
        if self._progress is not None:
            self._progress.stop()


def _terminal_progress() -> Progress:
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

    return Progress(
        BarColumn(bar_width=24),
        TaskProgressColumn(),
        TextColumn("{task.description}"),
        console=Console(stderr=True),
        transient=True,
    )


def _is_terminal() -> bool:
    return sys.stderr is not None and sys.stderr.isatty()


def _duration(seconds: float) -> str:
    """Seconds as people say them: 8 s, 3 min 20 s, 2 h 5 min."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"


def _quantity(value: float) -> str:
    """A rate with three digits: 950, 12.3k, 4.56M."""
    for limit, unit in ((1e6, "M"), (1e3, "k")):
        if value >= limit:
            return f"{value / limit:.3g}{unit}"
    return f"{value:.3g}"
