"""The same model by every method, with errors measured and not assumed."""

from __future__ import annotations

import logging
import math
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from linkwork.arguments import path
from linkwork.arrays import Floats
from linkwork.comparison import runs
from linkwork.comparison.choices import Cell, Choice, Entry, cells, choices
from linkwork.comparison.order import OrderStudy, Study
from linkwork.comparison.reference import GOOD_ENOUGH, Reference, given_reference, solved_reference
from linkwork.comparison.runs import AT_END, Outcome, Runs, Sampling
from linkwork.comparison.store import Store
from linkwork.comparison.table import Comparison
from linkwork.comparison.workers import Lost, in_processes, processor_count
from linkwork.errors import LinkworkError, OptionError, warn
from linkwork.modeling.model import Model, check_bodies
from linkwork.options import TABLE, Policy, check_name, check_number, check_option, names
from linkwork.results.result import Result
from linkwork.running.interrupts import Interrupts
from linkwork.running.manifest import platform_facts
from linkwork.running.progress import ShowOption, counting
from linkwork.running.recording import frame_bytes

__all__ = ["compare"]

log = logging.getLogger(__name__)

#: Without steps: twice, once and half the step that a method of order 4 needs for an error of about this.
USUAL_ERROR = 1e-4

#: Of the size of a model: farther away than assembly puts its bodies.
ELSEWHERE = 0.1

#: What `compare` takes by name.
_NAMES = ("formulations", "stabilizations", "integrators", "linear_solvers", "steps", "tolerances",
          *TABLE)  # fmt: skip


def compare(
    model: Model | str,
    t_end: float | None = None,
    *,
    formulations: Iterable[Entry] | None = None,
    stabilizations: Iterable[Entry] | None = None,
    integrators: Iterable[Entry] | None = None,
    linear_solvers: Iterable[Entry] | None = None,
    steps: Iterable[float] | float | None = None,
    tolerances: Iterable[float] | float | None = None,
    reference: Result | str | os.PathLike[str] | None = None,
    reference_error: float | None = None,
    processes: int | None = None,
    time_limit: float | None = None,
    resume: str | os.PathLike[str] | None = None,
    on_inaccurate: Policy = "pass",
    progress: ShowOption = None,
    **options: Any,
) -> Comparison:  # Long: 18 lines are its arguments.
    """Simulate a model by many methods, in parallel processes, and measure the error of each.

        comparison = lw.compare(model, t_end=0.1, steps=[2e-3, 1e-3], integrators=["rk4", "euler"])
        print(comparison)

    model           a Model, or the name of a mechanism in linkwork.mechanisms
    t_end           [s]; None: what the mechanism recommends
    formulations, stabilizations, integrators, linear_solvers
                    the axes of the grid; one that is not given is left to `simulate`. None of them given: a
                    selection that shows what they are about. An entry is a name, a name with numbers
                    ("baumgarte:5:5" [1/s], "baumgarte:1/h:sqrt(2)/h" with the step h, "penalty:1e7"), or
                    options by name; integrators may be methods as data
    steps           fixed steps [s]; None without tolerances: of the mechanism four times, twice and once the
                    recommended one, of other models what the reference suggests
    tolerances      rtol of steps that follow it (atol = rtol / 1000), for integrators with an error estimate
    reference       a known solution, with frames at multiples of the steps; None: one is computed by DOP853
                    with projection at a tight tolerance, its own error by a second, tighter one
    reference_error
                    of a known solution, as state errors are measured, where it is known
    processes       at the same time; None: one a processor
    time_limit      of one cell [s]; beyond it the cell is lost
    resume          a folder in which every finished cell is kept at once, and from which an interrupted
                    comparison goes on, also with more cells
    on_inaccurate   what a run's own estimate of more than 1 % means to its cell, see simulate: "warn" adds a
                    remark, "stop" ends the run, which counts as failed. The errors of cells are measured
    progress        None: a line on a terminal after two seconds; False: nothing
    options         further options of every cell, see linkwork.options.Options

    A cell that is refused, diverges or fails does not stop the others: its `status` and `reason` say so.
    Figures are those of `simulate` with the options of the cell, the largest of up to 200 frames, not of all
    steps. Times are of processes that run side by side: fewer of them than processors give better ones.

    OptionError: a grid without cells, no reference. ModelError: the model cannot be simulated. FileError: of
    `reference` or `resume`. LinkworkWarning: the reference is too inaccurate to compare with.
    """
    model, t_end, recommended = _resolved(model, t_end)
    _check(processes, time_limit, reference, reference_error, options)
    check_name("on_inaccurate", on_inaccurate, names()["on_inaccurate"])
    axes = (formulations, stabilizations, integrators, linear_solvers)
    rtols, asked = _numbers("tolerances", tolerances) or [], _numbers("steps", steps)
    methods = choices(*axes, options, adaptive=bool(rtols) and not asked)
    if asked is None and not rtols and recommended is not None:
        asked = usual_steps(recommended, t_end)
    elif asked is None and not rtols and reference is None:
        asked = _suggested_steps(model, t_end)
    grid = _grid(methods, asked or [], rtols)
    store, count = _store(resume, model, t_end, reference), processes or processor_count()
    known = {} if store is None else store.found()
    log.info("comparison of %s: %d runs, %d of them known", model.name or "model", len(grid),
             sum(item.key in known for item in grid))  # fmt: skip
    with counting(progress, 1 + len(grid)) as report:
        sampling = Sampling.of(t_end, asked or [], frame_bytes(model))
        if reference is not None:
            exact = _checked(given_reference(reference, reference_error), model, t_end)
        else:
            exact = _solved(model, t_end, sampling.times(asked or []), store, count, report)
        times = exact.motion.t if reference is not None else None
        task = Runs(model, t_end, sampling, exact, times, on_inaccurate)
        found = _run(task, grid, known, store, count, time_limit, report)
    manifest = {"model": model.name, "model_hash": model.hash(), "processes": count, **platform_facts()}
    outcomes = [it for it in found if isinstance(it, Outcome)]
    return Comparison(outcomes, exact, t_end, manifest, [it for it in found if isinstance(it, OrderStudy)])


def _check(
    processes: int | None,
    time_limit: float | None,
    reference: object,
    reference_error: float | None,
    options: Mapping[str, Any],
) -> None:
    """OptionError: numbers that are not positive, options that there are not."""
    numbers = {"processes": processes, "time_limit": time_limit, "reference_error": reference_error}
    for name, number in numbers.items():
        if number is not None:
            check_number(name, number, positive=True)
    if reference_error is not None and reference is None:
        raise OptionError(
            "reference_error is that of a known solution: give reference, too, or leave it to be estimated",
            code="conflict",
        )
    for name in options:
        check_option(name, TABLE if name in TABLE else _NAMES)


def _grid(methods: Sequence[Choice], steps: Sequence[float], rtols: Sequence[float]) -> list[Cell | Study]:
    """Every method at every step and tolerance, and a study of its order. OptionError: there are none."""
    if not steps and not rtols:
        raise OptionError(
            "steps and tolerances are missing: give steps=[1e-2, 5e-3] [s] or tolerances=[1e-6, 1e-8]",
            code="step",
        )
    studies = [Study(choice, max(steps), min(steps)) for choice in methods] if steps else []
    return [*cells(methods, steps, rtols), *studies]


def _numbers(name: str, given: Any) -> list[float] | None:
    """One number or several. OptionError: something else, or none that is positive."""
    if given is None:
        return None
    several = list(given) if isinstance(given, Iterable) and not isinstance(given, str) else [given]
    for number in several:
        check_number(name, number, positive=True)
    return [float(number) for number in several]


def usual_steps(recommended: float, t_end: float) -> list[float]:
    """Where no steps are given: the recommended one [s], and larger ones that show the order.

    None of them is longer than the run.
    """
    finest = min(recommended, t_end / 4) if t_end > 0 else recommended
    return [4 * finest, 2 * finest, finest]


def _run(
    task: Runs,
    items: Sequence[Cell | Study],
    known: Mapping[str, Outcome | OrderStudy],
    store: Store | None,
    processes: int,
    time_limit: float | None,
    report: Callable[[int, str], None],
) -> list[Outcome | OrderStudy]:
    """What every item gives, known or new."""
    found = {item.key: known[item.key] for item in items if item.key in known}
    todo = [item for item in items if item.key not in found]

    def beat(places: Sequence[int]) -> None:
        interrupts.check()
        now = f", {todo[places[0]].label}" if places else ""
        report(1 + len(found), f"{len(found)} of {len(items)} runs{now}")

    with Interrupts() as interrupts:
        for place, answer in interrupts.each(in_processes(task, todo, processes, time_limit, beat)):
            item = todo[place]
            if isinstance(answer, Lost):
                found[item.key] = runs.lost(item, answer.reason)
            else:
                found[item.key] = answer
                if store is not None:
                    store.keep(item, answer)
            log.info("%s: %s", item.label, getattr(found[item.key], "verdict", "done"))
    return [found[item.key] for item in items]


def _solved(
    model: Model,
    t_end: float,
    times: Floats,
    store: Store | None,
    processes: int,
    report: Callable[[int, str], None],
) -> Reference:
    """The one in the store, or a new one. LinkworkWarning: it is too inaccurate to compare with."""
    stored = store.reference() if store is not None else None
    if stored is not None and len(stored.motion.at(times)[1]) == len(times):
        return stored
    made = solved_reference(model, t_end, times, processes, beat=lambda _: report(0, "reference solution"))
    if made.error is not None and made.error["state_error"] > GOOD_ENOUGH:
        warn(
            f"reference of {model.name or 'the model'}: it is only known to "
            f"{made.error['state_error']:.1e} of the motion; smaller errors cannot be told from it: shorten "
            "the run, or give a known solution as reference"
        )
    if store is not None:
        store.keep_reference(made)
    return made


def _checked(reference: Reference, model: Model, t_end: float) -> Reference:
    """OptionError: a solution of another mechanism, or one that ends too early. LinkworkWarning: it may
    be one of another."""
    bodies = reference.motion.q.shape[1]
    if bodies != model.body_count:
        raise OptionError(
            f"reference: has {bodies} bodies, the model {model.body_count}; give a result of this model",
            code="reference",
        )
    if not len(reference.motion.t) or reference.motion.t[-1] < t_end * (1 - AT_END):
        last = reference.motion.t[-1] if len(reference.motion.t) else math.nan
        raise OptionError(
            f"reference: ends at {last:g} s, the comparison at {t_end:g} s; shorten it", code="reference"
        )
    if reference.motion.t[0] == 0.0:
        _check_start(reference, model)
    if reference.model_hash not in (None, model.hash()):
        warn(
            "reference: it may be of a model with other numbers, functions or another initial state than "
            "this, or of another version of linkwork: what the two differ by counts as an error of every "
            f"method (hash {reference.model_hash}, not {model.hash()})"
        )
    return reference


def _check_start(reference: Reference, model: Model) -> None:
    """OptionError: its bodies begin elsewhere."""
    own, given = model.compiled().q0.reshape(-1, 7)[:, :3], reference.motion.q[0, :, :3]
    apart = np.linalg.norm(own - given, axis=1)
    body, size = int(np.argmax(apart)), float(np.ptp(own, axis=0).max() + reference.scales.length.max())
    if apart[body] > ELSEWHERE * size:
        raise OptionError(
            f"reference: body '{model.compiled().body_name(body)}' begins {apart[body]:.3g} m from where it "
            "is in the model; give a result of this model",
            code="reference",
        )


def _suggested_steps(model: Model, t_end: float) -> list[float]:
    """From the steps of a run with an error of about USUAL_ERROR by a method of order 5."""
    from linkwork.running.simulation import simulate

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            pilot = simulate(model, t_end, rtol=USUAL_ERROR, integrator="dopri5", progress=False,
                             times=[t_end])  # fmt: skip
        count = max(int(pilot.statistics["steps"]), 10)
    except LinkworkError as error:
        raise OptionError(
            f"steps are missing, and none could be found ({error}); give steps=[...] [s]", code="step"
        ) from error
    return [t_end / (count * n) for n in (1, 2, 4)]


def _store(folder: str | os.PathLike[str] | None, model: Model, t_end: float, reference: Any) -> Store | None:
    if folder is None:
        return None
    given = None if reference is None else str(getattr(reference, "manifest", {}).get("started", reference))
    folder = path(folder, "resume", folder=True)
    identity = {"model_hash": model.hash(), "t_end": t_end, "reference": given}
    return Store(folder, {**identity, "velocity_error": "by the largest speed of bodies"})


def _resolved(model: Model | str, t_end: float | None) -> tuple[Model, float, float | None]:
    """The model, the end, and the recommended step. OptionError. ModelError: no model."""
    settings: dict[str, Any] = {}
    if isinstance(model, str):
        from linkwork.mechanisms import named

        mechanism = named(model)
        settings, model = dict(mechanism.settings), mechanism.function()
    check_bodies(model)
    end = settings.get("t_end") if t_end is None else t_end
    if end is None:
        raise OptionError("t_end is missing: give the end of the simulated time [s]", code="t_end")
    check_number("t_end", end, positive=True, unit="s")
    return model, float(end), settings.get("step")
