"""One run: from a model to its motion."""

from __future__ import annotations

import math
import os
import time
from typing import Any, Unpack

import numpy as np

from linkwork import _core, checks, integrators, recording
from linkwork.errors import OptionError
from linkwork.header import Header
from linkwork.integrators import Integrator
from linkwork.interrupts import Interrupts
from linkwork.manifest import manifest
from linkwork.model import Model
from linkwork.options import Options
from linkwork.progress import ProgressOption, reporting
from linkwork.recording import PythonStep
from linkwork.result import Result
from linkwork.system import System

__all__ = ["PythonStep", "simulate"]

#: Frames recorded without `record_every`, and the memory they may take [bytes].
FRAMES, FRAME_BYTES = 1000, 2**30

#: Beyond, a run is refused by the driver.
MOST_STEPS = 1e15


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

    Redundant constraint equations are found and left out of the solution; the reactions that they leave open
    are those of least norm, see `Result.unique_reactions`.

    OptionError: a choice that does not exist or cannot be honored. SingularSystemError: a singular pose, with
    the standard formulation (also before the first step). NotConvergedError, NotFiniteError: the run failed.
    FileError: `output` cannot be written. LinkworkWarning: initial poses or velocities do not satisfy the
    joints. Ctrl-C ends the run; what `output` has by then stays readable.
    """
    started = time.perf_counter()
    checks.check_times(t_end, step)
    checks.check_bodies(model)
    checks.check_tables(model, t_end)
    system = System(model, **options)
    method = _method(integrator, system, step)
    checks.warn_of_residuals(model, system.compiled())

    every = _record_every(record_every, t_end / step, _frame_bytes(model))
    compiled = None if callable(method) else method.compiled()
    run = _core.Simulation(system.compiled(), compiled, t_end, step, every)
    given = {"t_end": t_end, "step": step, "integrator": integrator, "record_every": record_every, **options}
    chosen = {
        "t_end": t_end,
        "step": step,
        "integrator": _name(method),
        "record_every": every,
        **system.options,
    }
    facts = {**manifest(model, given, chosen), "constraints": checks.rank_numbers(system.compiled())}
    header = Header.of(model.compiled(), system.compiled(), facts, run.steps_total // every + 2)
    recorder = recording.recorder(output, header)

    setup_seconds = time.perf_counter() - started
    with Interrupts() as interrupts, reporting(progress, t_end, run.steps_total) as report:
        if callable(method):
            pieces = recording.python_pieces(run, interrupts, method, system)
        else:
            pieces = recording.compiled_pieces(run, interrupts, _frame_bytes(model))
        driver_seconds = recording.record(run, pieces, recorder, report)
    seconds = time.perf_counter() - started
    times = {"seconds": seconds, "setup_seconds": setup_seconds, "driver_seconds": driver_seconds}
    return recorder.result({**run.statistics(), **times})


def _method(integrator: Any, system: System, step: float) -> Integrator | PythonStep:
    """OptionError: no integrator at all, or one for which the gains are too large."""
    method = integrators.named(integrator) if isinstance(integrator, str) else integrator
    if isinstance(method, Integrator):
        checks.check_gains(method, system.compiled(), step)
    elif not callable(method):
        raise OptionError(
            f"integrator {method!r} is no name, no method as data, and no function step(system, t, y, h)",
            code="integrator",
        )
    return method  # type: ignore[no-any-return]


def _name(method: Integrator | PythonStep) -> str:
    if isinstance(method, Integrator):
        return method.name
    return str(getattr(method, "__qualname__", type(method).__name__))


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
