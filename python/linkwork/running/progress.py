"""Progress of a long run: one line on a terminal or in a notebook, lines in a log, or the user's function.

`simulate` reports through `reporting(...)`, a series of tasks through `counting(...)`; whether anything is
shown, and where, is decided here. The log is that of logger "linkwork.running.progress", level INFO.
"""

from __future__ import annotations

import logging
import sys
import threading
import time
import uuid
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol

from linkwork.errors import OptionError

if TYPE_CHECKING:
    from rich.progress import Progress

#: What `simulate(progress=...)` takes: None or True shows a line, False shows nothing.
ProgressOption = Callable[["ProgressInfo"], object] | bool | None

#: What a series of tasks takes: None shows a line, False shows nothing.
ShowOption = Literal[False] | None

log = logging.getLogger(__name__)

#: A run is silent for this long [s]: most are over by then.
SILENT_SECONDS = 2.0

#: Of the bar on a terminal, in characters.
BAR = 16

#: Between two looks at work whose share is not known [s].
WORKING_SECONDS = 0.25

#: Between two lines in a log, and between two updates in a notebook [s].
LOG_SECONDS, NOTEBOOK_SECONDS = 10.0, 0.5


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
    #: mean step since the last report [s], and the largest violation of a position constraint [m or 1] at the
    #: last frame; None before anything is known
    step: float | None = None
    violation: float | None = None
    #: where the run began [s]
    t_start: float = 0.0

    @property
    def fraction(self) -> float:
        """Share of the run that is done, 0 to 1."""
        if self.steps_total > 0:
            return min(self.steps_done / self.steps_total, 1.0)
        span = self.t_end - self.t_start
        return min((self.t - self.t_start) / span, 1.0) if span > 0 else 1.0

    @property
    def rate(self) -> float:
        """Steps per second of wall time."""
        return self.steps_done / self.elapsed if self.elapsed > 0 else 0.0

    @property
    def remaining(self) -> float | None:
        """Estimated wall time to the end [s]; None before anything is known."""
        return self.elapsed * (1 / self.fraction - 1) if self.fraction > 0 else None


class Report(Protocol):
    """What `reporting` hands to the run."""

    def __call__(self, t: float, steps_done: int, violation: float | None = None) -> None: ...


def check_progress(progress: ProgressOption) -> None:
    """OptionError: nothing that says where progress is shown."""
    if not (callable(progress) or progress is None or isinstance(progress, bool)):
        raise OptionError(
            f"progress {progress!r} is neither None, True or False, nor a function of ProgressInfo",
            code="progress",
        )


@contextmanager
def reporting(
    progress: ProgressOption, t_end: float, steps_total: int = 0, t_start: float = 0.0, before: float = 0.0
) -> Iterator[Report]:
    """Give the run its `report(t, steps_done, violation)`; a line that was shown is cleared at the end.

    `progress`: None = automatic (a line where the run takes more than two seconds and standard error is a
    terminal or the program a notebook), False = nothing, or a function that is called with a ProgressInfo at
    every report. The log is written in any case, every ten seconds, where its level allows. `before` is what
    the run took up to here [s]: where that is long, the line is there before the first report.
    """
    started = time.monotonic()
    last = t_start, 0
    with _shown(progress is None or progress is True) as show:
        if before:
            show(before, 0.0, lambda: f"t = {t_start:.4g} of {t_end:g} s")

        def report(t: float, steps_done: int, violation: float | None = None) -> None:
            nonlocal last
            t = max(t, t_start)  # one that is resumed takes some steps again
            taken = steps_done - last[1]
            step = (t - last[0]) / taken if taken > 0 and last[1] > 0 else None
            last = t, steps_done
            elapsed = time.monotonic() - started
            info = ProgressInfo(
                t=t, t_end=t_end, steps_done=steps_done, steps_total=steps_total, elapsed=elapsed, step=step,
                violation=violation, t_start=t_start,
            )  # fmt: skip
            show(before + info.elapsed, info.fraction, lambda: describe(info))
            if callable(progress):
                progress(info)

        yield report


@contextmanager
def counting(show: ShowOption, total: int) -> Iterator[Callable[[int, str], None]]:
    """Give a series of tasks its `report(done, what)`, called as each begins; shown as by `reporting`."""
    started = time.monotonic()
    with _shown(show is None) as shown:

        def report(done: int, what: str) -> None:
            fraction, elapsed = min(done / total, 1.0), time.monotonic() - started
            shown(elapsed, fraction, lambda: what + _left(elapsed, fraction))

        yield report


@contextmanager
def sharing(progress: ProgressOption, what: str, before: float = 0.0) -> Iterator[Callable[[float], None]]:
    """Give a part of a run other than its steps its `report(share)`; shown as by `reporting`.

    before  what the run took up to here [s]; the part of a long one is shown at once
    """
    started = time.monotonic()
    with _shown(progress is None or progress is True) as shown:

        def report(share: float) -> None:
            elapsed = time.monotonic() - started
            shown(before + elapsed, share, lambda: what + _left(elapsed, share))

        report(0.0)
        yield report


@contextmanager
def preparing(progress: ProgressOption, what: str, before: float = 0.0) -> Iterator[None]:
    """Tell of work whose share is not known, as it lasts; shown as by `reporting`.

    before  what the run took up to here [s]
    """
    started = time.monotonic() - before
    with _shown(progress is None or progress is True) as show:
        done = threading.Event()

        def elapsed() -> float:
            return time.monotonic() - started

        def tell() -> None:
            while not done.wait(WORKING_SECONDS):
                show(elapsed(), None, lambda: f"{what}, {time_in_words(elapsed())}")

        teller = threading.Thread(target=tell, daemon=True)
        if show.displays:
            teller.start()
        try:
            yield
        finally:
            done.set()
            if show.displays:
                teller.join()


def describe(info: ProgressInfo) -> str:
    """The numbers of the line: simulated time, rate, remaining time, step, violation."""
    left = "" if info.remaining is None else f", {time_in_words(info.remaining)} left"
    step = "" if info.step is None else f", step {info.step:.3g} s"
    violation = "" if info.violation is None else f", violation {info.violation:.0e}"
    return f"t = {info.t:.4g} of {info.t_end:g} s, {_quantity(info.rate)} steps/s{left}{step}{violation}"


def fitting(text: str, width: int) -> str:
    """In one line: without as many of the last parts, between commas, as it takes."""
    parts = text.split(", ")
    while len(parts) > 1 and len(", ".join(parts)) > width:
        parts.pop()
    shorter = ", ".join(parts)
    return shorter if len(shorter) <= width else shorter[: max(width - 1, 0)] + "…"


def _left(elapsed: float, fraction: float) -> str:
    return f", {time_in_words(elapsed * (1 / fraction - 1))} left" if 0 < fraction < 1 else ""


class _Display(Protocol):
    """Where a line is shown; `seconds` pass between two updates."""

    seconds: float

    def show(self, fraction: float | None, text: str) -> None: ...
    def close(self) -> None: ...


class _Show:
    """show(elapsed, fraction, text) on displays; the text is made when it is needed.

    A fraction is None where nobody knows it.
    """

    def __init__(self, displays: list[_Display]) -> None:
        self.displays = displays
        self._due = {display: max(SILENT_SECONDS, display.seconds) for display in displays}

    def __call__(self, elapsed: float, fraction: float | None, text: Callable[[], str]) -> None:
        for display, when in self._due.items():
            if elapsed >= when:
                display.show(fraction, text())
                self._due[display] = elapsed + display.seconds


@contextmanager
def _shown(wanted: bool) -> Iterator[_Show]:
    """On all displays that there are."""
    displays = [*(_screens() if wanted else []), *([_Log()] if log.isEnabledFor(logging.INFO) else [])]
    try:
        yield _Show(displays)
    finally:
        for display in displays:
            display.close()


def screen() -> bool:
    """Whether somebody looks at a terminal or a notebook."""
    return bool(_screens())


def _screens() -> list[_Display]:
    """A terminal, a notebook, or nothing that anybody looks at."""
    if sys.stderr is not None and sys.stderr.isatty():
        return [_Terminal()]
    return [_Notebook()] if _in_notebook() else []


class _Terminal:
    """One line, which goes away at the end."""

    seconds = 0.0

    def __init__(self) -> None:
        self._progress: Progress | None = None

    def show(self, fraction: float | None, text: str) -> None:
        if self._progress is None:
            self._progress = _terminal_progress()
            self._progress.start()
            self._progress.add_task("", total=None if fraction is None else 1.0)
        text = fitting(text, self._progress.console.width - BAR - len(" 100%  "))
        self._progress.update(self._progress.task_ids[0], completed=fraction, description=text)

    def close(self) -> None:
        if self._progress is not None:
            self._progress.stop()


class _Notebook:
    """One output that is replaced, and empty at the end."""

    seconds = NOTEBOOK_SECONDS

    def __init__(self) -> None:
        self._name = uuid.uuid4().hex
        self._shown = False

    def show(self, fraction: float | None, text: str) -> None:
        self._display(text if fraction is None else f"{100 * fraction:3.0f} %  {text}")

    def close(self) -> None:
        if self._shown:
            self._display("")

    def _display(self, text: str) -> None:
        from IPython import display

        show: Any = display.display  # untyped there
        show({"text/plain": text}, raw=True, display_id=self._name, update=self._shown)
        self._shown = True


class _Log:
    """A record now and then."""

    seconds = LOG_SECONDS

    def show(self, fraction: float | None, text: str) -> None:
        log.info("%s", text if fraction is None else f"{100 * fraction:.0f} %, {text}")

    def close(self) -> None:
        pass


def _terminal_progress() -> Progress:
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

    return Progress(
        BarColumn(bar_width=BAR),
        TaskProgressColumn(),
        TextColumn("{task.description}"),
        console=Console(stderr=True),
        transient=True,
    )


def _in_notebook() -> bool:
    """Whether an IPython kernel runs this: nobody has it who did not import IPython before."""
    ipython: Any = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return getattr(shell, "kernel", None) is not None


def time_in_words(seconds: float) -> str:
    """Seconds as people say them: 8 s, 3 min 20 s, 2 h 5 min, 8 hours, 3 days."""
    for size, unit in ((365 * 86400, "years"), (86400, "days"), (3600, "hours")):
        if seconds >= max(2 * size, 6 * 3600):
            return f"{seconds / size:.2g} {unit}"
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
