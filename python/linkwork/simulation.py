"""One run: from a model to its motion."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Protocol, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core, checks, integrators
from linkwork.errors import OptionError
from linkwork.header import Header
from linkwork.integrators import Integrator
from linkwork.manifest import manifest
from linkwork.model import Model
from linkwork.options import Options
from linkwork.progress import ProgressOption, Report, reporting
from linkwork.result import Result
from linkwork.system import System

__all__ = ["PythonStep", "simulate"]

Floats = NDArray[np.float64]
Frames = Mapping[str, Floats]

#: An integrator of the user's own: step(system, t, y, h) -> y at t + h, y (13n,).
PythonStep = Callable[[System, float, Floats, float], ArrayLike]

#: Frames recorded without `record_every`, and the memory they may take [bytes].
FRAMES, FRAME_BYTES = 1000, 2**30

#: Beyond, a run is refused by the driver.
MOST_STEPS = 1e15

#: A piece of a run that goes on without a look at signals and progress: wall time [s], and memory [bytes].
PIECE_SECONDS, PIECE_BYTES = 0.1, 2**26


def simulate(
    model: Model,
    t_end: float,
    step: float,
    integrator: str | Integrator | PythonStep = "rk4",
    *,
    record_every: int | None = None,
    output: str | os.PathLike[str] | None = None,
    progress: ProgressOption = None,
    **options: Unpack[Options],
) -> Result:
    """Simulate a model from t = 0 to `t_end` with a fixed `step` [s].

    integrator    a name in linkwork.integrators.METHODS, a method as data, or step(system, t, y, h)
    record_every  steps between frames; None: at most about 1000 frames. The last state is always recorded
    output        an HDF5 file that is written while the run goes on; the result then reads from it
    progress      None: a line on a terminal after two seconds; False: nothing; or a function of ProgressInfo
    options       formulation="standard", system="auto", stabilization="sampled_baumgarte",
                  linear_solver="auto", baumgarte_alpha, baumgarte_beta, penalty, damping_ratio, frequency,
                  tolerance, max_iterations: see linkwork.options.Options

    OptionError: a choice that does not exist or cannot be honored. SingularSystemError: dependent constraint
    equations with the standard formulation (before the first step), or a singular pose. NotConvergedError,
    NotFiniteError: the run failed. FileError: `output` cannot be written. LinkworkWarning: initial poses or
    velocities do not satisfy the joints. Ctrl-C ends the run; what `output` has by then stays readable.
    """
    started = time.perf_counter()
    checks.check_times(t_end, step)
    checks.check_bodies(model)
    checks.check_tables(model, t_end)
    method = integrators.named(integrator) if isinstance(integrator, str) else integrator
    system = System(model, **options)
    _check_method(method, system, step)
    checks.warn_of_residuals(model, system.compiled())
    every = _record_every(record_every, t_end / step, _frame_bytes(model))
    compiled = None if callable(method) else method.compiled()
    run = _core.Simulation(system.compiled(), compiled, t_end, step, every)

    given = {"t_end": t_end, "step": step, "integrator": integrator, "record_every": record_every, **options}
    name = getattr(method, "name", None) or getattr(method, "__qualname__", "own")
    chosen = {"t_end": t_end, "step": step, "integrator": name, "record_every": every, **system.options}
    facts = manifest(model, given, chosen)
    header = Header.of(model.compiled(), system.compiled(), facts, run.steps_total // every + 2)
    recorder = _recorder(output, header)
    setup_seconds = time.perf_counter() - started
    with reporting(progress, t_end, run.steps_total) as report:
        pieces = (
            _python_pieces(run, method, system)
            if callable(method)
            else _compiled_pieces(run, _frame_bytes(model))
        )
        driver_seconds = _record(run, pieces, recorder, report)
    seconds = time.perf_counter() - started
    times = {"seconds": seconds, "setup_seconds": setup_seconds, "driver_seconds": driver_seconds}
    return recorder.result({**run.statistics(), **times})


class _Recorder(Protocol):
    """Where frames go."""

    def write(self, frames: Frames) -> None: ...
    def abandon(self) -> None: ...
    def result(self, statistics: Mapping[str, Any]) -> Result: ...


class _Memory:
    def __init__(self, header: Header) -> None:
        self._header = header
        self._pieces: list[Frames] = []

    def write(self, frames: Frames) -> None:
        if len(frames["t"]):
            self._pieces.append(frames)

    def abandon(self) -> None:
        self._pieces.clear()

    def result(self, statistics: Mapping[str, Any]) -> Result:
        joined = {name: np.concatenate([piece[name] for piece in self._pieces]) for name in self._pieces[0]}
        return Result(joined, self._header, statistics)


class _File:
    def __init__(self, path: str | os.PathLike[str], header: Header) -> None:
        from linkwork.result_file import ResultWriter

        self._writer = ResultWriter(path, header)

    def write(self, frames: Frames) -> None:
        self._writer.write(frames)

    def abandon(self) -> None:
        self._writer.close()

    def result(self, statistics: Mapping[str, Any]) -> Result:
        self._writer.close(statistics)
        return Result.load(self._writer.path)


def _recorder(output: str | os.PathLike[str] | None, header: Header) -> _Recorder:
    if output is None:
        return _Memory(header)
    return _File(output, header)


def _record(run: _core.Simulation, pieces: Iterator[Frames], recorder: _Recorder, report: Report) -> float:
    """Write the pieces as they come, and close the file however the run ends; the time they took [s]."""
    spent, before = 0.0, time.perf_counter()
    try:
        for frames in pieces:
            spent += time.perf_counter() - before
            recorder.write(frames)
            report(run.t, run.steps_done)
            before = time.perf_counter()
    except BaseException:
        recorder.write(run.take_frames())
        recorder.abandon()
        raise
    return spent


def _compiled_pieces(run: _core.Simulation, frame_bytes: int) -> Iterator[Frames]:
    """The compiled driver, which returns now and then so that signals are honored and progress is shown."""
    while not run.finished:
        yield run.advance(max(1, PIECE_BYTES // frame_bytes), PIECE_SECONDS)


def _python_pieces(run: _core.Simulation, step: PythonStep, system: System) -> Iterator[Frames]:
    """The user's own integrator; meanwhile `system.derivative` has the sampled correction in it."""
    t, y, h = run.begin_step()
    pause = time.perf_counter() + PIECE_SECONDS
    while h > 0.0:
        run.accept(np.asarray(step(system, t, y, h), dtype=float))
        t, y, h = run.begin_step()
        if time.perf_counter() > pause:
            yield run.take_frames()
            pause = time.perf_counter() + PIECE_SECONDS
    yield run.take_frames()


def _check_method(method: Any, system: System, step: float) -> None:
    """OptionError: no integrator at all, or one for which the gains are too large."""
    if isinstance(method, Integrator):
        checks.check_gains(method, system.compiled(), step)
    elif not callable(method):
        raise OptionError(
            f"integrator {method!r} is no name, no method as data, and no function step(system, t, y, h)",
            code="integrator",
        )


def _record_every(given: int | None, steps: float, frame_bytes: int) -> int:
    if given is None:
        return max(1, math.ceil(min(steps, MOST_STEPS) / min(FRAMES, max(1, FRAME_BYTES // frame_bytes))))
    if not isinstance(given, int | np.integer) or given < 1:
        raise OptionError(
            f"record_every {given!r} is not a positive whole number of steps", code="record_every"
        )
    return int(given)


def _frame_bytes(model: Model) -> int:
    """One frame: q, v, v_dot, lambda, the reactions, and a few numbers."""
    return 8 * (19 * model.body_count + model.row_count + 6 * model.joint_count + 7)
