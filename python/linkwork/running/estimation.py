"""The estimate of the error of a run: what is taken again, when, and by what."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.accuracy.measures import MOVING, AtRest
from linkwork.accuracy.verdict import (
    GOOD,
    Energies,
    Method,
    Verdict,
    cut_short,
    estimate,
    leaping,
    loose,
    passing,
    say,
    verified,
    without_steps,
)
from linkwork.accuracy.verification import Extremes, Finer, joined, state_error
from linkwork.arrays import Floats
from linkwork.equations.system import System
from linkwork.errors import AccuracyError, LinkworkError, warn
from linkwork.functions.calls import Calls
from linkwork.integrators import METHODS, EmbeddedPair, Integrator
from linkwork.modeling.model import Model, check_model
from linkwork.motion.records import Snapshot
from linkwork.options import Options
from linkwork.results.last_state import LastState
from linkwork.results.result import Result
from linkwork.running import callbacks, pulses, recall
from linkwork.running.compiled_laws import CompiledLaws
from linkwork.running.kept import Kept
from linkwork.running.returned import note_left
from linkwork.running.schedule import Adaptive, Fixed
from linkwork.running.short_steps import second_run
from linkwork.running.time_scale import size
from linkwork.running.written import Written

__all__ = [
    "ErrorEstimator",
    "apply_policy",
    "no_second_run",
    "of_memory",
    "strict",
    "told_of_memory",
    "unjudged",
    "warn_of_memory",
]

#: Takes the steps of integrators of the user's own again.
TRUSTED = "dop853"

#: Steps after which a run that may be stopped is looked at first, and then whenever they have doubled.
FIRST_LOOK = 200

#: Of an error: what is left of it by the run's own equations is not theirs.
CAUSE = 0.5

NOT_AS_IT_WAS = (
    "functions were called again when the run was over, and what they have written meanwhile could not be "
    "made what it was: what they logged has these calls in it"
)

#: Of the size of a mechanism: what moves or falls less in a run is at rest.
STILL, FALLEN = 1e-10, 1e-12

_judges: ContextVar[bool] = ContextVar("_judges", default=True)


@contextmanager
def unjudged() -> Iterator[None]:
    """A context whose runs have no verdict: it may take many times as long as a run of few steps."""
    before = _judges.set(False)
    try:
        yield
    finally:
        _judges.reset(before)


def _at_rest(model: Model, duration: float) -> float:
    """Energy [J] of bodies that move 1e-10 of the size of the mechanism in the run, and fall 1e-12 of it."""
    core, length = model.compiled(), size(model)
    speed = STILL * length / duration if duration > 0 else 0.0
    falling = float(np.linalg.norm(core.gravity)) * FALLEN * length
    return float(np.sum(core.mass)) * (0.5 * speed * speed + falling)


class ErrorEstimator:
    """Follows a run, and takes steps of it again."""

    told_of_steps = False  #: whether the run was told to be slow

    def __init__(
        self,
        run: _core.Run | _core.LaneRun,
        method: Integrator | Any,
        system: System,
        options: Options,
        start: Snapshot | None,
        plan: Fixed | Adaptive,
        *,
        breaks: Sequence[float] = (),
        stops: bool = False,
        others: Sequence[Any] = (),
        written: Written | None = None,
        watching: Sequence[tuple[str, Calls]] = (),
    ) -> None:
        """`breaks` [s] of the run; `stops`: it, as soon as it is known to be inaccurate; `others`: functions
        that may change what those of the model read, as those of events; `written`: what these write;
        `watching`: functions of events. All calls are those of the run."""
        self._run, self._method, self._system = run, method, system
        self._stops, self._next_look = stops, FIRST_LOOK
        stabilization: Any = system.compiled().options.stabilization
        self._options: Options = {**options, "stabilization": stabilization}
        self._plan = plan
        self._inexact = False  # the formulation
        self._at_rest, self._carried = MOVING, 0.0
        self._between: Extremes | None = None
        self._contacts_begin, self._onset = False, 0.0
        self._before = start.error if start is not None else 0.0
        self._energies = Energies(
            _at_rest(system.model, plan.t_end - (start.t if start is not None else 0.0))
        )
        self._functions, self._watching = system.model._calls, watching
        self._compiled_laws = CompiledLaws(self._functions)
        self._recall = recall.NOTHING
        self._own = {} if isinstance(method, Integrator) else {"integrator": method}
        self._own_contents = callbacks.contents(self._own)
        self._others, self._written = [*others, *self._own.values()], written
        t_start = start.t if start is not None else 0.0
        evaluations = plan.evaluations(method, t_start)
        self._looks = pulses.look(system.model, t_start, plan.t_end, evaluations)
        known = plan.between_parts(system.model, breaks, t_start)
        run.expect_breaks(sorted({*known, *(it.t for it in self._looks.pulses)}))

    def look(self, frames: Mapping[str, Floats]) -> None:
        """At frames as they come. AccuracyError: the run is inaccurate, and is to stop."""
        self._energies.add(frames)
        if not isinstance(self._run, _core.LaneRun):  # those that remember run alone
            self._compiled_laws.look(frames)
        if not self._stops or isinstance(self._run, _core.LaneRun):
            return
        if self._run.finished or self._run.steps_done < self._next_look:
            return
        self._next_look = 2 * self._run.steps_done
        if not self._as_it_was().whole:
            return
        verdict = self._of(System(self._system.model, **self._options), self._run.statistics())
        if verdict.error > GOOD:
            raise AccuracyError(f"{say(verdict, self._system.model.name)}: stopped", code="inaccurate")

    def verdict(
        self,
        statistics: Mapping[str, Any],
        *,
        steps: bool = True,
        report: Callable[[float], None] | None = None,
    ) -> Verdict | None:
        """Of the run, which is over: the system is used up. None: there was no step, or nobody asks.

        steps   whether it lists those that were taken again
        report  is called with the share that is done, as each is begun
        """
        if not self._run.has_steps or not _judges.get():
            return None
        return self._of(self._system, statistics, steps=steps, report=report)

    def verify(
        self,
        result: Result,
        output: str | os.PathLike[str] | None,
        run: Callable[[dict[str, Any]], Result],
        began: Kept,
        changed: Sequence[str],
    ) -> None:
        """Adds a finer run, made by `run` with such arguments, to the result and its file.

        began    what functions of the user's remembered then: the finer run begins with that, and leaves them
                 with what they remember now
        changed  functions of events that remember something else now

        LinkworkWarning: there is none, as a function of the user's remembers calls, or it failed.
        """
        stateful = [*self._recall.remember, *callbacks.changed(self._own_contents, self._own)]
        if not began.whole:
            stateful = [*self._recall.differ, *stateful, *changed]
        if stateful:
            return warn(no_second_run(stateful[0]))
        try:
            with self._as_it_was(), began.as_then(), second_run(self.told_of_steps):
                found = self._second_run(result, run)
        except LinkworkError as error:
            return warn(f"verify: the second run failed, so that nothing is known by it: {error}")
        if self._written is not None and self._recall.differ:
            note_left(self._functions, self._written.began)  # by this run, not by the second one
        gain = 10.0
        if isinstance(self._plan, Fixed):
            # The speed at which a contact begins is known to the first order.
            order = 1 if self._contacts_begin else self._resolution().order
            gain = (self._plan.step / self._finer(result)["step"]) ** order
        finer = Finer.of(result, found, gain / (gain - 1) if gain > 1 else 2.0)
        result._finer = finer
        verdict = result.verdict
        if verdict is not None:
            second = None if self._energies.at_rest else found.verdict
            found_state = state_error(result, finer, self._at_rest, self._between)
            body = self._name(found_state.body)
            state = max(found_state.error, self._onset)
            new = verified(verdict, state, self._resolution(), second, body)
            result._statistics["verdict"] = self._explained(new).numbers()
        if output is not None:
            from linkwork.results.writing import add_finer

            add_finer(output, finer, result.statistics)
            result._finer = finer.in_file(Result.load(output)._finer)

    def _second_run(self, result: Result, run: Callable[[dict[str, Any]], Result]) -> Result:
        """With frames at the times of the result.

        Those of a run that goes on with a fixed step are at multiples of the steps of the one before: another
        run is to come to the first of them.
        """
        finer = self._finer(result)
        if isinstance(self._plan, Adaptive) or not result.manifest.get("resumed") or len(result) < 3:
            return run(finer)
        t_start, t_first = map(float, result.t[:2])
        lead = run({**finer, "t_end": t_first, "step": min(finer["step"], t_first - t_start)})
        rest = run({**finer, "start": lead.snapshot()._replace(resume=None)})
        return joined(lead, rest)

    def _finer(self, result: Result) -> dict[str, Any]:
        breaks = result.manifest["breaks"]
        met = breaks["count"] > breaks.get("steps_with_breaks", 0)
        return self._plan.finer(result.t, onsets=self._contacts_begin, met=met)

    def _of(
        self,
        system: System,
        statistics: Mapping[str, Any],
        *,
        steps: bool = True,
        report: Callable[[float], None] | None = None,
    ) -> Verdict:
        self._energies.reach(*self._run.energies)
        if not self._functions and not self._watching:  # nobody could remember
            return self._by_steps(system, statistics, steps=steps, report=report)
        with self._as_it_was() as kept:
            self._recall = self._called_again()
        if kept.lost:
            warn(NOT_AS_IT_WAS)
        if self._recall.differ:
            names = ", ".join(f"'{name}'" for name in self._recall.differ[:3])
            why = f"no step was taken again, as {names} may remember the calls before"
            found = self._by_balance(why, statistics)
        else:
            with self._as_it_was():
                found = self._by_steps(system, statistics, steps=steps, report=report)
        return replace(found, memory=self._recall.remember, recalled=self._recall.example)

    def _called_again(self) -> recall.Recall:
        own = None if self._written is None else self._written.parts(Kept(self._own.values()))
        return recall.call_again(self._functions, self._others, self._written, own, self._watching)

    def _as_it_was(self) -> Kept:
        """A context that leaves what functions of the user's write to as it is now."""
        return Kept(calls.function for _, calls in [*self._functions, *self._watching])

    def _by_steps(
        self,
        system: System,
        statistics: Mapping[str, Any],
        *,
        steps: bool,
        report: Callable[[float], None] | None,
    ) -> Verdict:
        try:
            exact = self._strict(system)
            own = system if exact is not system else None
            verdict = self._judged(exact, statistics, steps=steps, report=report, recorded=own)
            self._inexact = verdict.yielding >= verdict.error > 0.0
            if verdict.level != "good" and own is not None and not self._inexact:
                by_steps = self._judged(own, statistics, steps=steps, report=report)
                self._inexact = by_steps.error < CAUSE * verdict.error
        except Exception as error:  # also of the user's functions
            return self._by_balance(f"no step could be taken again ({error})", statistics)
        passed = statistics.get("passed_touches", ())
        verdict = passing(leaping(verdict, self._looks.pulses), passed)
        return self._explained(cut_short(verdict, self._looks.cut_short))

    def _explained(self, verdict: Verdict) -> Verdict:
        inexact = self._inexact and verdict.level != "good"
        return loose(verdict, self._options.get("formulation", "")) if inexact else verdict

    def _judged(
        self,
        system: System,
        statistics: Mapping[str, Any],
        *,
        steps: bool,
        report: Callable[[float], None] | None,
        recorded: System | None = None,
    ) -> Verdict:
        """By the equations of `system`; `recorded`: with those that gave the run its reactions."""
        if isinstance(self._run, _core.LaneRun):
            listed = steps or bool(self._looks.pulses)
            found = self._run.judge(system.compiled(), *self._compiled(), steps=listed)
        else:
            its = None if recorded is None else recorded.compiled()
            found = self._run.judge(system.compiled(), *self._compiled(), progress=report, recorded=its)
        self._carried, self._onset = found["carried"], found["onset"]
        self._contacts_begin = found["contacts_begin"]
        self._at_rest = AtRest(found["rest_length"], found["rest_speed"])
        self._between = Extremes.of(found)
        return estimate(found, self._energies, self._resolution(), statistics, self._before, self._name)

    def _name(self, body: int) -> str:
        return self._system.model.compiled().body_name(body) if body >= 0 else ""

    def _strict(self, system: System) -> System:
        """One without loose tolerances or penalties, whose errors the parts of a step would share."""
        options = strict(self._options)
        return system if options == self._options else System(self._system.model, **options)

    def _by_balance(self, why: str, statistics: Mapping[str, Any]) -> Verdict:
        violation = self._run.relative_violation()
        return without_steps(why, self._energies, statistics, violation, self._before)

    def _resolution(self) -> Method:
        order = self._method.order if isinstance(self._method, Integrator) else self._order()
        if isinstance(self._plan, Adaptive):
            return Method(order, rtol=self._plan.rtol, carried=self._carried)
        return Method(order, step=min(self._plan.step, self._run.t))

    def _compiled(self) -> tuple[Any, bool]:
        """What takes the steps again, and whether that is another method.

        It is for integrators of the user's own: whoever makes a mistake in a step makes it in its parts, too.
        """
        method = self._method
        if isinstance(method, EmbeddedPair) and isinstance(self._run, _core.AdaptiveSimulation):
            return method.compiled_pair(), False
        if isinstance(method, Integrator):
            return method.compiled(), False
        return METHODS[TRUSTED].compiled(), True

    def _order(self) -> int:
        """0 where nobody knows."""
        order = getattr(self._method, "order", 0)
        return int(order) if isinstance(order, int) else 0


def strict(options: Options) -> Options:
    """Those with which the equations of motion are solved exactly.

    Penalties leave constraints violated and reactions wrong at any step, loose iterations likewise: the
    augmented Lagrangian has the same right-hand side without that.
    """
    iterates_loosely = "tolerance" in options or "max_iterations" in options
    if options.get("formulation") != "penalty" and not iterates_loosely:
        return options
    out = options.copy()
    out["formulation"] = "augmented_lagrangian"
    for name in ("penalty", "penalty_scale", "tolerance", "max_iterations"):
        out.pop(name, None)  # type: ignore[misc]
    return out


def no_second_run(name: str) -> str:
    return f"verify: no second run was made, as '{name}' may remember the calls before"


def of_memory(names: Sequence[str], seen: str = "") -> str:
    """What is wrong with functions of the user's that remember calls; `seen`: as one did."""
    listed = ", ".join(f"'{name}'" for name in names[:3])
    example = f" ({seen})" if seen else ""
    return (
        f"{listed}: remembers calls{example}. They come in stages of steps, in steps that "
        "are taken again, for frames in between and in other runs, so that what it remembers depends on the "
        "method, and how far the motion is off is not known: let an event change what lasts, as samples of a "
        "controller (lw.Event, change=)"
    )


@contextmanager
def told_of_memory(model: Model, what: str) -> Iterator[None]:
    """Around an analysis. LinkworkWarning: functions of the model that it calls remember calls.

    ModelError: it is no model.
    """
    check_model(model)
    functions, written = model._calls, Written(model._calls)
    try:
        yield
    except LinkworkError:
        _tell_of_memory(functions, written, what)
        raise
    _tell_of_memory(functions, written, what)


def _tell_of_memory(functions: Sequence[tuple[str, Calls]], written: Written, what: str) -> None:
    with Kept(calls.function for _, calls in functions):
        found = recall.call_again(functions, written=written, own=written.parts(Kept([])))
    if found.remember:
        listed = ", ".join(f"'{name}'" for name in found.remember[:3])
        warn(
            f"{what}: {listed}: remembers calls ({found.example}), so that what it returns depends on what "
            "was called before, and on where it was asked for that"
        )


def warn_of_memory(verdict: Verdict | None) -> None:
    """LinkworkWarning: functions of the user's remember calls."""
    if verdict is not None and verdict.memory:
        warn(of_memory(verdict.memory, verdict.recalled))


def apply_policy(result: Result | LastState, policy: str) -> None:
    """LinkworkWarning, with "warn", or AccuracyError, with "stop": the run is more than 1 % off.

    LinkworkWarning: nobody knows how much, as functions of the user's remember.
    """
    verdict = None if policy == "pass" else result.verdict
    if verdict is None:
        return
    warn_of_memory(verdict)
    if verdict.level == "good":
        return
    message = say(verdict, result.manifest.get("model"))
    if policy == "warn":
        return warn(f"{message} (result.verdict says more, on_inaccurate='pass' nothing)")
    error = AccuracyError(message, code="inaccurate")
    assert isinstance(result, Result)
    error.result, error.state = result, result.snapshot()
    raise error
