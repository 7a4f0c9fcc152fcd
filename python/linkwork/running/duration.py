"""How long a run with very many steps will take, told before the first of them."""

from __future__ import annotations

import time

from linkwork.equations.system import System
from linkwork.errors import LinkworkError, OptionError, warn
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot
from linkwork.options import Options
from linkwork.running.recording import PythonStep

__all__ = ["announce"]

#: Runs of fewer steps, and of fewer steps times bodies, are not worth a look.
MANY_STEPS, MANY_BODY_STEPS = 1e6, 1e9

#: Of evaluations: so many at least, for so long [s].
EVALUATIONS, WATCHED = 3, 5e-3

#: What is told, and what nobody waits for [s].
LONG, ABSURD = 6 * 3600.0, 30 * 86400.0


def announce(
    model: Model,
    options: Options,
    method: Integrator | PythonStep,
    steps: float,
    start: Snapshot | None,
) -> None:
    """LinkworkWarning: the run will take hours. OptionError: months."""
    if steps < MANY_STEPS and steps * model.body_count < MANY_BODY_STEPS:
        return
    evaluation = _evaluation(System(model, **options), start)
    seconds = steps * max(1, len(getattr(method, "A", ()))) * evaluation
    if seconds < LONG:
        return
    found = f"the run takes {steps:.3g} steps, about {_in_words(seconds)} on this machine"
    remedy = "give a larger step, or rtol for steps that follow the motion"
    if seconds > ABSURD:
        raise OptionError(f"{found}: {remedy}", code="too_long")
    warn(f"{found}; where that is too long, {remedy}")


def _evaluation(system: System, start: Snapshot | None) -> float:
    """The time of a right-hand side at the start [s], 0 where there is none."""
    t, y = (0.0, system.initial_state()) if start is None else (start.t, start.y)
    least, began, count = float("inf"), time.perf_counter(), 0
    try:
        while count < EVALUATIONS or time.perf_counter() - began < WATCHED:
            before = time.perf_counter()
            system.derivative(t, y)
            least, count = min(least, time.perf_counter() - before), count + 1
    except LinkworkError:  # the run will say what it is
        return 0.0
    return least


def _in_words(seconds: float) -> str:
    for size, unit in ((365 * 86400, "years"), (86400, "days"), (3600, "hours")):
        if seconds >= 2 * size:
            return f"{seconds / size:.2g} {unit}"
    return f"{seconds / 60:.2g} minutes"
