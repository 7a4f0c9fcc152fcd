"""One run: from a model to its motion."""

from __future__ import annotations

import errno
import logging
import os
import textwrap
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, Unpack, cast

from numpy.typing import ArrayLike

from linkwork import _core, integrators
from linkwork.arguments import check_new
from linkwork.equations.assembly import Assembly
from linkwork.equations.system import System
from linkwork.errors import OptionError, unwritable
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model, check_bodies
from linkwork.motion.header import Header
from linkwork.motion.records import Snapshot
from linkwork.options import TABLE, Options, Policy, check_option, honored
from linkwork.options.types import IntegratorName, described
from linkwork.results.result import Result
from linkwork.running import (
    breakpoints,
    callbacks,
    checks,
    estimation,
    forecast,
    recording,
    resuming,
    schedule,
)
from linkwork.running.events import Event, Watched, calls_of, compile_events, events_of, functions_of
from linkwork.running.interrupts import Interrupts
from linkwork.running.kept import Kept
from linkwork.running.laws_of_forces import LawsOfForces
from linkwork.running.leaving_no_memory import called
from linkwork.running.manifest import manifest
from linkwork.running.own_order import in_own_order
from linkwork.running.progress import ProgressOption, check_progress, preparing, reporting, sharing
from linkwork.running.reach import telling_of_reach
from linkwork.running.recording import PythonStep
from linkwork.running.seen_in_frames import warn_of_what_frames_show
from linkwork.running.short_steps import Suspects
from linkwork.running.written import Written

__all__ = ["PythonStep", "check_run", "simulate", "what_steps"]

log = logging.getLogger(__name__)

#: What the run's statistics count, and what looks ahead of it count, too.
COUNTED = ("evaluations", "factorizations", "solves", "iterations", "evaluate_time", "factorize_time",
           "assemble_time", "solve_time")  # fmt: skip


def simulate(
    model: Model,
    t_end: float,
    step: float | None = None,
    integrator: IntegratorName | Integrator | PythonStep | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    record_every: int | None = None,
    times: ArrayLike | None = None,
    events: Event | Iterable[Event] = (),
    breaks: ArrayLike = (),
    start: Snapshot | None = None,
    output: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: ProgressOption = None,
    assemble: bool = True,
    on_inaccurate: Policy = "warn",
    verify: bool = False,
    **options: Unpack[Options],
) -> Result:  # Long: 20 lines are its arguments.
    """Simulate a model from t = 0 to `t_end` [s], with a fixed `step` [s] or steps that follow tolerances.

        result = lw.simulate(model, t_end=0.1, step=1e-3)
        print(result.verdict)

    t_end         end of the simulated time [s]
    step          [s] fixed, not longer than the run, or with rtol or atol the largest (None: no limit). What
                  would take hours is told before the first step by a LinkworkWarning, what would take more
                  than a month is refused; manifest["forecast"] has time and memory of a large run
    integrator    how steps are taken. A name in linkwork.integrators.METHODS, a method as data, or
                  step(system, t, y, h); None: "rk4", or "dopri5" with rtol or atol
    rtol          relative tolerance: steps that follow it (bs32, dopri5, tsit5, dop853). The error of each
                  step is at most rtol * size + atol, for each body's position [m], rotation (size 1 rad),
                  velocity [m/s] and angular velocity [rad/s]. Without it 1e-6 where atol is given
    atol          absolute tolerance [m, rad, m/s, rad/s], without it rtol / 1000
    record_every  steps between frames. The last state is always recorded. With adaptive steps 1 keeps every
                  step: numpy.diff(result.t) are their sizes
    times         frames at these times (adaptive steps only), interpolated where no step ends: output never
                  limits a step. With record_every frames at both, without either at most about 1000, evenly
    events        what happens when functions of the state pass through zero (adaptive steps only), see
                  linkwork.Event; result.events lists what came
    breaks        times [s] at which something is not smooth, beside those that functions of time and forces
                  declare: steps that follow tolerances end there; fixed ones that do see each its own side
                  (integrators of your own what they ask for);
                  of those that go over one, the summary says how many
    start         where to begin, instead of t = 0 and the state of the model: `Result.snapshot(frame)` or the
                  `state` of an error. From the last frame of a result, in memory or in a file, and from the
                  state of an error, a run of the same model by the same method goes on to the last bit, as if
                  it had never ended (manifest["resumed"]; steps that the end had shortened are taken once
                  more, unseen). Otherwise the work, multistep methods and step control begin anew. Bodies and
                  history variables are taken by their names (`start.names`), in whatever order. Where a state
                  has no history variables (of a file of version 0.1), full turns and contacts under way begin
                  anew: a LinkworkWarning names them
    output        an HDF5 file that is written while the run goes on; the result then reads from it
    overwrite     whether `output` may replace a file that is there
    progress      None: on a terminal or in a notebook what a large run will take, before its first step, and
                  a line after two seconds; False: nothing; or a function of ProgressInfo. Loggers "linkwork"
                  and below tell of runs, too (level INFO)
    assemble      correct initial poses and velocities that violate the joints a little. Up to 1/1000 of the
                  size and speed of the mechanism as by linkwork.assemble, larger violations are refused;
                  False: the run starts from them as they are, with a warning
    on_inaccurate what an estimated error of more than 1 % means to the run. "pass", "warn" or "stop", see
                  `Result.verdict`; "stop" looks after it ever doubled the number of its steps, too
    verify        a second run at half the step, a little less where contacts begin, or a tenth of the
                  tolerances: `Result.error_of` then tells the error of whatever was recorded, and plots have
                  error bands
    options       by name; what is left out, or None, has its default

    Redundant constraint equations are found and left out of the solution; the reactions that they leave open
    are those of least norm, see `Result.unique_reactions`.

    Singular poses, where equations of loops depend on each other for a moment and the motion could go on in
    several ways, are taken in one leap by collocation; `Result.singular_poses` lists them.

    OptionError: a choice that does not exist or cannot be honored. SingularSystemError: a singular pose with
    on_singular="stop", or a matrix that no method here can factorize. NotConvergedError, NotFiniteError: the
    run failed. StepSizeError: no step is small enough for rtol and atol. FileError: `output` cannot be
    written. ViolationError: on_violation="stop", or joints and drivers contradict each other. AccuracyError:
    on_inaccurate="stop". An error of a run has its `result` up to there and the last `state`; with code
    "dead_point" its drivers ask for more than its joints allow. ModelError: initial poses or velocities do
    not satisfy the joints, see `assemble`.
    LinkworkWarning: they were corrected; the run is inaccurate; steps that follow tolerances are so short
    that at their pace it takes hours; joints repeat each other but for digits of their points or axes, which
    lock them; redundant equations contradict the others a little; elements about an axis measured an angle
    that depends on their x axes.
    Ctrl-C ends the run; what `output` has by then stays readable.
    """
    started = time.perf_counter()
    path = _core.OnePath(options.get("deterministic") is True)
    check_progress(progress)
    with (Interrupts() as interrupts, interrupts.computing(), recording.StopIterationIsError(), path,
          preparing(progress, "preparing the run")):  # fmt: skip
        check_bodies(model)
        for name in options:
            check_option(name, TABLE)
        t_start = checks.start_time(start)
        size = recording.frame_bytes(model)
        plan = schedule.plan(t_end, step, rtol, atol, record_every, times, size, t_start)
        given = {"t_end": t_end, "step": step, "integrator": integrator, "rtol": rtol, "atol": atol,
                 "record_every": record_every, "times": times, "breaks": breaks, "assemble": assemble,
                 "on_inaccurate": on_inaccurate, "verify": verify, **options}  # fmt: skip
        events = events_of(events)
        watched = compile_events(events, model, lambda t: written.by_others(t))
        written = Written([*model._calls, *calls_of(watched)], _readers(model, events))
        by_user = {"events": events, "integrator": integrator}
        began = Kept(called(model, by_user).values()) if verify is True else None
        prepared = _prepared(model, plan, given, options, watched, start, written, in_file=output is not None)
        _check_output(output, overwrite)
        prepared = _looked_ahead(prepared, output)
    of_events = functions_of(events) if verify else {}
    contents = callbacks.contents(of_events)
    with Interrupts() as interrupts, path:
        result, estimator = _carried_out(prepared, output, progress, started, interrupts)
    if began is not None:
        again: dict[str, Any] = {"t_end": t_end, "integrator": prepared.method, "events": events,
                                 "breaks": breaks, "start": start, "assemble": assemble}  # fmt: skip
        estimator.verify(result, output, lambda finer: simulate(
            model, **{**again, **finer}, progress=progress, on_inaccurate="pass",
            **estimation.strict(options),
        ), began, callbacks.changed(contents, of_events))  # fmt: skip
    estimation.apply_policy(result, on_inaccurate)
    return result


_OPTIONS_LINE = "    options       by name; what is left out, or None, has its default\n"
simulate.__doc__ = (
    simulate.__doc__ or ""
).replace(  # the table of the compiled module is the one text of options
    _OPTIONS_LINE,
    _OPTIONS_LINE
    + "".join(
        textwrap.fill(
            f"{it.name:<17} {described(it)}", 110, initial_indent=" " * 8, subsequent_indent=" " * 26
        )
        + "\n"
        for it in TABLE.values()
    ),
)


@dataclass(frozen=True)
class Prepared:
    """A run before its first step."""

    plan: schedule.Fixed | schedule.Adaptive
    method: Integrator | PythonStep
    system: System
    options: Options
    start: Snapshot | None
    breaks: Sequence[float]  # [s], in the run
    given: Mapping[str, Any]  # as the user wrote it
    run: _core.Run
    chosen: Mapping[str, Any]  # options with none left open
    facts: Mapping[str, Any]  # for the manifest
    identity: resuming.Identity  # of checkpoints
    known: Sequence[float]  # [s], breaks of which the driver was told
    watched: Sequence[Watched]
    written: Written | None = None  # by functions of the model
    forecast: forecast.Forecast | None = None  # of a large run
    looking: Mapping[str, float] = field(default_factory=dict)  # what it cost to make that, of the statistics

    @property
    def t_start(self) -> float:
        return checks.start_time(self.start)

    def statistics(self) -> dict[str, Any]:
        """Of the run so far, without the looks ahead of it."""
        found = recording.statistics_of(self.run)
        return {**found, **{name: found[name] - cost for name, cost in self.looking.items()}}

    def header(self) -> Header:
        model = self.system.model
        beside = self.plan.beside(model, self.known, self.t_start, self.run)
        return Header.of(
            model.compiled(), self.system.compiled(), self.facts, self.plan.expected_frames(self.run),
            model.shapes, model.curves, beside,
        )  # fmt: skip


def _prepared(
    model: Model, plan: schedule.Fixed | schedule.Adaptive, given: Mapping[str, Any], options: Options,
    watched: Sequence[Watched], start: Snapshot | None, written: Written | None = None, *,
    in_file: bool = False,
) -> Prepared:  # fmt: skip
    """System, consistent initial state and driver. OptionError, ModelError: what cannot be run.

    in_file  whether frames go to a file, which has reactions
    """
    t_start = checks.start_time(start)
    model_hash = model.hash()  # before anything calls its functions, which may remember it
    method, options, system, assembly, breaks, impacts = what_steps(model, plan, given, options, start)
    choices = {**plan.steps(), **system.options}
    identity = resuming.Identity(model, model_hash, method, choices, watched, given, assembly, written)
    resume = resuming.of(start, identity, plan.t_end)
    if start is not None:
        start = in_own_order(model.compiled(), system.compiled(), start) if resume is None else start
        checks.check_start(model, system.compiled(), start, known=resume is not None)
    if resume is None:
        known = breaks
    else:
        system = _as_then(system, model, options, given["assemble"], identity.key)
        known = breakpoints.of_run(model, given["breaks"], resume.checkpoint.t, plan.t_end)
    run = plan.run(method, system, [event.compiled for event in watched], start, known)
    if in_file:
        run.record_reactions()
    if resume is not None:
        run.resume(resume.checkpoint.state, resume.work)
    chosen = {"t_start": t_start, **plan.chosen(), "integrator": _name(method), **system.options}
    facts = {
        **manifest(model, identity.model_hash, {**given, **_in_words(watched, start)}, chosen),
        "breaks": {"count": len(breaks), **plan.steps_with_breaks(breaks, run), **impacts},
        "constraints": checks.rank_numbers(system.compiled()),
        "assembled": assembly and str(assembly),
        "events": [event.label for event in watched],
        **({} if start is None else {"resumed": resume is not None}),
    }
    return Prepared(plan, method, system, options, start, breaks, given, run, chosen, facts, identity, known,
                    watched, written)  # fmt: skip


def _in_words(watched: Sequence[Watched], start: Snapshot | None) -> dict[str, Any]:
    """Arguments that no file can hold, where they were given."""
    events: dict[str, Any] = {"events": [event.label for event in watched]} if watched else {}
    return events if start is None else {**events, "start": f"the state at {start.t:g} s"}


class Stepped(NamedTuple):
    """A method, and the system that it steps."""

    method: Integrator | PythonStep
    options: Options
    system: System
    assembly: Assembly | None  # what it took to make the initial state consistent
    breaks: Sequence[float]  # [s], in the run
    impacts: Mapping[str, Any]  # where velocities of drivers jump, for the manifest


def what_steps(
    model: Model,
    plan: schedule.Fixed | schedule.Adaptive,
    given: Mapping[str, Any],
    options: Options,
    start: Snapshot | None = None,
    like: System | None = None,
) -> Stepped:
    """The system of a run, with all that is looked at before. `like`: one of these options, see System.of.

    OptionError, ModelError: what cannot be run.
    """
    t_start = checks.start_time(start)
    checks.check_choices(given)
    checks.check_tables(model, plan.t_end)
    breaks = breakpoints.of_run(model, given["breaks"], t_start, plan.t_end)
    adaptive = isinstance(plan, schedule.Adaptive)
    struck = breakpoints.check_drivers(model, t_start, plan.t_end, adaptive=adaptive)
    if isinstance(plan, schedule.Fixed):
        breakpoints.check_apart(model, given["breaks"], plan.step, t_start, plan.t_end)
    method = _method(plan.usual_integrator if given["integrator"] is None else given["integrator"])
    options = cast(Options, honored(method, options))
    system, assembly = _system(model, method, options, plan, given["assemble"], start, like)
    if start is None:
        checks.warn_of_near_dependence(system.compiled())
        checks.warn_of_opposed_axes(model, system.model.compiled().q0)
    return Stepped(method, options, system, assembly, breaks, breakpoints.noted(struck))


def of_other_weights(
    known: Stepped, model: Model, plan: schedule.Fixed | schedule.Adaptive, *, assemble: bool
) -> Stepped:
    """What steps a model that differs in gravity, masses and inertias alone.

    OptionError, ModelError: what cannot be run.
    """
    system, assembly = _system(model, known.method, known.options, plan, assemble, None, known.system)
    return known._replace(system=system, assembly=assembly)


def _looked_ahead(it: Prepared, output: str | os.PathLike[str] | None) -> Prepared:
    """With a forecast where it is large. OptionError: it would take months."""
    before = it.run.statistics()
    frames = it.plan.expected_frames(it.run)
    found = forecast.look_ahead(it.system, it.plan, it.method, it.start, frames, output)
    after = it.run.statistics()
    cost = {name: after[name] - before[name] for name in COUNTED if after[name] != before[name]}
    facts = it.facts if found is None else {**it.facts, "forecast": found.numbers()}
    return replace(it, facts=facts, forecast=found, looking=cost)


def prepared(
    model: Model, plan: schedule.Fixed | schedule.Adaptive, given: Mapping[str, Any], options: Options
) -> Prepared:
    """A run before its first step. OptionError, ModelError: what cannot be run."""
    it = _prepared(model, plan, given, options, compile_events(given.get("events"), model), None)
    return _looked_ahead(it, None)


def concluded(it: Prepared, estimator: estimation.ErrorEstimator) -> Result:
    """The result of a run that has come to its end, which the estimator has followed."""
    with Interrupts() as interrupts:
        return _carried_out(it, None, False, time.perf_counter(), interrupts, estimator)[0]


def estimator_of(it: Prepared) -> estimation.ErrorEstimator:
    """Before the first step."""
    changes = [each.event.change for each in it.watched if each.event.change is not None]
    return estimation.ErrorEstimator(
        it.run, it.method, it.system, it.options, it.start, it.plan, breaks=it.breaks,
        stops=it.given["on_inaccurate"] == "stop", others=changes, written=it.written,
        watching=calls_of(it.watched),
    )  # fmt: skip


def check_run(
    model: Model, plan: schedule.Fixed | schedule.Adaptive, given: Mapping[str, Any], options: Options
) -> None:
    """All of a run but its steps. OptionError, ModelError: what cannot be run."""
    _prepared(model, plan, given, options, compile_events(given["events"], model), None)


def _carried_out(
    it: Prepared,
    output: str | os.PathLike[str] | None,
    progress: ProgressOption,
    started: float,
    interrupts: Interrupts,
    estimator: estimation.ErrorEstimator | None = None,
) -> tuple[Result, estimation.ErrorEstimator]:
    """The result, with what the run took since `started` [s], and who can take steps of it again."""
    checkpoints = recording.Checkpoints(it.run, it.identity)
    with interrupts.computing():
        estimator = estimator or estimator_of(it)
        header = it.header()
    with preparing(progress, f"beginning '{output}'", time.perf_counter() - started):
        recorder = recording.recorder(output, header, checkpoints, interrupts, it.system.model)
    model, run, plan, t_start, labels = it.system.model, it.run, it.plan, it.t_start, it.facts["events"]
    spent = {"setup_seconds": time.perf_counter() - started}
    log.info("%s: %g to %g s by %s", model.describe(), t_start, plan.t_end, _listed(it.chosen))
    forecast.announce(it.forecast, progress)
    with telling_of_reach(model), recording.kept(run, recorder, labels, checkpoints, header.state_names):
        with reporting(progress, plan.t_end, run.steps_total, t_start, spent["setup_seconds"]) as report:
            spent["driver_seconds"] = recording.record(
                run, recording.pieces(run, interrupts, it.method, it.system), recorder, report, labels,
                estimator, interrupts, t_end=plan.t_end, warns=it.system.options["on_singular"] == "warn",
                forces=lambda: Suspects.of(header, model),
            )  # fmt: skip
        laws = LawsOfForces(model)
        statistics = {**it.statistics(), **plan.steps_with_breaks(it.breaks, it.run)}
        driven = time.perf_counter()
        sharing_verdict = sharing(progress, "steps taken again for the verdict", driven - started)
        with interrupts.computing(), sharing_verdict as share:
            verdict = estimator.verdict(statistics, report=share)
        spent["verdict_seconds"] = time.perf_counter() - driven
    seconds = time.perf_counter() - started
    log.info("%s: done, %d steps in %.3g s", model.name or "model", run.steps_done, seconds)
    found = {"verdict": verdict.numbers()} if verdict is not None else {}
    result = recorder.result({**statistics, "seconds": seconds, **spent, **found, **laws.statistics()}, laws)
    recording.add_sides(result, run)
    checks.warn_of_contradiction(result.statistics)
    warn_of_what_frames_show(result)
    return result, estimator


def _readers(model: Model, events: Sequence[Event]) -> list[Any] | None:
    """Functions of events, but for those that only log; None: no event changes anything."""
    if all(it.change is None for it in events):
        return None
    functions = list(functions_of(events).values())
    among = [*(calls.function for _, calls in model._calls), *functions]
    return [it for it in functions if not callbacks.only_logs(it, among)]


def _system(
    model: Model,
    method: Integrator | PythonStep,
    options: Options,
    plan: schedule.Fixed | schedule.Adaptive,
    assemble: bool,
    start: Snapshot | None,
    like: System | None,
) -> tuple[System, Assembly | None]:
    """The model with its method and a consistent initial state, and what it took to make it so."""
    system = System(model, **options) if like is None else like.of(model)
    plan.check(method, system)
    if start is not None:
        return system, None
    assembly = checks.consistent(model, system.compiled(), correct=assemble)
    return (system, None) if assembly is None else (System(assembly.model, **options), assembly)


def _as_then(system: System, model: Model, options: Options, assemble: bool, key: str) -> System:
    """As it was in the run that is resumed, of a model whose initial state had been corrected."""
    if not resuming.assembled(key):
        return system
    assembly = checks.consistent(model, system.compiled(), correct=assemble, quiet=True)
    assert assembly is not None
    then = System(assembly.model, **options)
    then.compiled().history = system.compiled().history
    return then


def _check_output(output: str | os.PathLike[str] | None, overwrite: bool) -> None:
    """FileError: there is no folder for it, or a file, which is told before how long the run would take."""
    if output is not None and not check_new(output, "result", overwrite).absolute().parent.is_dir():
        raise unwritable("output", output, FileNotFoundError(errno.ENOENT, "no folder"))


def _listed(chosen: Mapping[str, Any]) -> str:
    """The method in words, for the log."""
    names = ("formulation", "stabilization", "integrator", "linear_solver")
    sizes = [f"{name} {chosen[name]:g}" for name in ("step", "rtol") if chosen.get(name)]
    return ", ".join([*(str(chosen[name]) for name in names), *sizes])


def _method(integrator: Any) -> Integrator | PythonStep:
    """OptionError: no integrator at all."""
    method = integrators.named(integrator) if isinstance(integrator, str) else integrator
    if not isinstance(method, Integrator) and not callable(method):
        raise OptionError(
            f"integrator {method!r} is no name, no method as data, and no function step(system, t, y, h)",
            code="integrator",
        )
    return method  # type: ignore[no-any-return]


def _name(method: Integrator | PythonStep) -> str:
    if isinstance(method, Integrator):
        return method.name
    return str(getattr(method, "__qualname__", type(method).__name__))
