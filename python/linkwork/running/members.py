"""Some members of an ensemble: through the lanes where they can, else one by one."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from linkwork import _core
from linkwork.accuracy.verdict import Verdict
from linkwork.equations.system import System
from linkwork.errors import LinkworkError
from linkwork.functions import check_breaks
from linkwork.integrators import ButcherTableau, EmbeddedPair, Integrator, named
from linkwork.modeling.model import Model, check_bodies
from linkwork.motion.header import Header
from linkwork.options import TABLE
from linkwork.results.last_state import LastState
from linkwork.results.result import Result
from linkwork.running import estimation, forecast, recording, schedule
from linkwork.running.events import events_of
from linkwork.running.interrupts import Interrupts
from linkwork.running.laws_of_forces import LawsOfForces
from linkwork.running.leaving_no_memory import (
    Memory,
    called,
    function_of,
    leaving_no_memory,
    memory_of,
    warn_of_lasting,
)
from linkwork.running.manifest import manifest
from linkwork.running.remarks import facts_of, remarked
from linkwork.running.seen_in_frames import may_show_in_frames, warn_of_what_frames_show
from linkwork.running.simulation import (
    Prepared,
    Stepped,
    concluded,
    estimator_of,
    of_other_weights,
    prepared,
    simulate,
    what_steps,
)

__all__ = ["Member", "Method", "method_of", "refusal", "run_members"]

#: Of members of which only the last frame is asked for: the verdict looks at the balance of energy over them.
FRAMES = 50

#: Frames of a run of which it is looked whether its functions remember, between two looks.
LOOK = 10

#: Statistics of what lanes share, which say nothing of one of them.
SHARED = ("evaluations", "factorizations", "solves", "evaluate_time", "factorize_time", "assemble_time",
          "solve_time", "smallest_pivot", "seconds", "setup_seconds", "driver_seconds")  # fmt: skip


@dataclass(frozen=True)
class Member:
    """What became of one.

    result  its motion; None where it failed, or has its last state alone
    last    that, in lanes of a Method to which it is enough
    reason  why it was simulated by itself; empty: it ran in a lane
    error   of one that failed: type, code, message, and `reached`, the simulated time [s]
    """

    result: Result | None
    reason: str = ""
    error: Mapping[str, Any] = field(default_factory=dict)
    remarks: Sequence[str] = ()
    last: LastState | None = None

    @property
    def motion(self) -> Result | LastState | None:
        """As much as there is; None where it failed."""
        return self.result if self.last is None else self.last


@dataclass(frozen=True)
class Method:
    """How all of them are simulated: the arguments of `simulate` as they were given."""

    t_end: float
    arguments: Mapping[str, Any]
    threads: int
    alone: str  # why none of them can run in lanes; empty where they can
    plan: schedule.Fixed | schedule.Adaptive
    judged: bool = False  # whether members have a verdict
    last_state: bool = False  # in lanes the first and the last frame are enough
    state_alone: bool = False  # and of that q and v
    looked_at: bool = False  # by functions of the user's, which may look at what others remember, too
    weights_alone: bool = False  # members differ in nothing but gravity, masses and inertias
    with_frames: Method | None = None  # where `last_state`: of models whose frames have something to say

    def of(self, model: Model) -> Method:
        """That of one member: its warnings are those of its run by itself, whatever is asked for."""
        if self.with_frames is None or not may_show_in_frames(model):
            return self
        return self.with_frames

    @property
    def adaptive(self) -> bool:
        return isinstance(self.plan, schedule.Adaptive)

    def functions(self, model: Model) -> dict[str, Any]:
        """Of the user's, by name, that a member calls."""
        return called(model, self.given)

    @property
    def lanes_record_every(self) -> int:
        """Steps between the frames of lanes."""
        assert isinstance(self.plan, schedule.Fixed)
        steps = max(1, math.ceil(self.plan.t_end / self.plan.step))
        return steps if self.last_state and self.judged else self.plan.record_every

    @property
    def given(self) -> dict[str, Any]:
        usual = {"integrator": None, "breaks": (), "assemble": True}
        return {**usual, "t_end": self.t_end, **self.arguments}

    @property
    def options(self) -> Any:
        return {name: value for name, value in self.arguments.items() if name in TABLE}


@dataclass(frozen=True)
class _Left:
    """One that is to be simulated by itself, why, and what was said of it before."""

    reason: str
    remarks: Sequence[str] = ()


@dataclass
class _Ready:
    """One that can run in a lane."""

    place: int
    method: Method
    stepped: Stepped
    remarks: list[str]
    plain: bool = False  # there was nothing to be said or corrected
    run: _core.LaneRun | None = None  # with its estimator, where there is to be a verdict
    estimator: estimation.ErrorEstimator | None = None

    @property
    def system(self) -> System:
        return self.stepped.system

    @property
    def model(self) -> Model:
        return self.system.model


def method_of(
    example: Model, t_end: float, arguments: Mapping[str, Any], threads: int, *,
    judged: bool = False, last_state: bool = False, state_alone: bool = False, looked_at: bool = False,
    weights_alone: bool = False,
) -> Method:  # fmt: skip
    """`last_state`: the frames before are for the verdict alone, `state_alone`: so is all but q and v of it.
    `looked_at`: by functions of the user's. `weights_alone`: in which members differ.

    OptionError: a plan that makes no sense.
    """
    step, rtol, atol, every, at = (
        arguments.get(name) for name in ("step", "rtol", "atol", "record_every", "times")
    )
    plan = schedule.plan(t_end, step, rtol, atol, every, at, recording.frame_bytes(example), 0.0)
    given = {name: value for name, value in arguments.items() if value is not None or name in TABLE}
    chosen = arguments.get("integrator")
    integrator = plan.usual_integrator if chosen is None else chosen
    found = named(integrator) if isinstance(integrator, str) else integrator
    alone = ""
    if not isinstance(found, ButcherTableau if isinstance(plan, schedule.Fixed) else EmbeddedPair):
        alone = "lanes have explicit Runge-Kutta methods only"
    if isinstance(plan, schedule.Fixed) and events_of(given.get("events")):
        alone = "events need steps that follow tolerances"
    whole = Method(
        t_end, given, threads, alone, plan, judged, looked_at=looked_at, weights_alone=weights_alone
    )
    if not (last_state and judged and isinstance(plan, schedule.Fixed)):
        return replace(whole, last_state=last_state)
    if every is None:
        plan = replace(plan, record_every=max(1, math.ceil(plan.t_end / plan.step / FRAMES)))
        given = {**given, "record_every": plan.record_every}
    return replace(
        whole, arguments=given, plan=plan, last_state=True, state_alone=state_alone, with_frames=whole
    )


def refusal(model: Model, method: Method) -> str:
    """Why lanes cannot run it, or why it cannot be run at all; empty where they can."""
    if method.alone:
        return method.alone
    with remarked(), leaving_no_memory(method.functions(model), logs=True):
        try:
            return _core.lane_refusal(_stepped(model, method).system.compiled())
        except LinkworkError as error:
            return str(error)


def run_members(
    models: Sequence[Model | Exception], method: Method, follows: Sequence[bool]
) -> Iterator[Member]:
    """In the order of the models; an exception in place of a model is why there is none. `follows`: whether
    errors of each are followed as they grow, for its verdict, also in a lane at a fixed step.

    Each begins with what functions of the user's remember now, and what its own run leaves there stays until
    the next is asked for. Those that run side by side would share it: who remembers runs alone.
    """
    there = {place: model for place, model in enumerate(models) if isinstance(model, Model)}
    with memory_of(_functions_of_all(there, method)) as memory:
        found = _of_lanes(there, method, memory, follows)
        for place, model in enumerate(models):
            it = Member(None, error=facts_of(model)) if isinstance(model, Exception) else found[place]
            if isinstance(it, Member):
                yield it
                continue
            with leaving_no_memory(method.functions(there[place]), logs=method.looked_at):
                yield _alone(there[place], method.of(there[place]), it)


def _functions_of_all(models: Mapping[int, Model], method: Method) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for place, model in models.items():
        for name, function in method.functions(model).items():
            if function_of(found.setdefault(name, function)) is not function_of(function):
                found[f"{name} of member {place}"] = function
    return found


def _of_lanes(
    models: Mapping[int, Model], method: Method, memory: Memory, follows: Sequence[bool]
) -> dict[int, Member | _Left]:
    """What becomes of all of them there, or why not."""
    if method.alone or not models:
        return dict.fromkeys(models, _Left(method.alone))
    remember = dict.fromkeys(models, _Left("its functions remember, which lanes would share"))
    if method.adaptive and not memory.is_empty and _changes_by_itself(models, method, memory):
        return dict[int, Member | _Left](remember)
    found = _side_by_side(models, method) if method.adaptive else _at_fixed_steps(models, method, follows)
    if memory.is_changed(logs=method.looked_at) or memory.makes_a_difference():
        warn_of_lasting(memory.give_back(logs=method.looked_at))
        return dict[int, Member | _Left](remember)
    warn_of_lasting(memory.hidden)
    return found


def _changes_by_itself(models: Mapping[int, Model], method: Method, memory: Memory) -> bool:
    """Whether the first of them changes what its functions remember: steps that follow tolerances may never
    come to an end where lanes share that."""
    deterministic = method.options.get("deterministic") is True
    with remarked(), contextlib.suppress(Exception), _core.OnePath(deterministic):  # errors come again
        model = models[min(models)]
        check_bodies(model)
        run = prepared(model, method.plan, method.given, method.options).run
        while not (run.finished or memory.is_changed(logs=method.looked_at)):
            with Interrupts() as interrupts, interrupts.computing():
                run.advance(LOOK, recording.PIECE_SECONDS)
            run.take_frames()
    found = memory.is_changed(logs=method.looked_at)
    warn_of_lasting(memory.put_back())
    return found


def _at_fixed_steps(
    models: Mapping[int, Model], method: Method, follows: Sequence[bool]
) -> dict[int, Member | _Left]:
    found: dict[int, Member | _Left] = {}
    ready: list[_Ready] = []
    for place, model in models.items():
        it = _prepared(place, model, method, ready[0] if ready else None, follows=follows[place])
        if isinstance(it, Member):
            found[place] = it
        else:
            ready.append(it)
    for own in (method, method.with_frames):
        if own is not None and (those := [it for it in ready if it.method is own]):
            found.update(_in_lanes(those, own))
    return found


def _side_by_side(models: Mapping[int, Model], method: Method) -> dict[int, Member | _Left]:
    """With steps that follow tolerances: each is the run that it is alone, but lanes take stages of it."""
    found: dict[int, Member | _Left] = {}
    runs: dict[int, tuple[Prepared, estimation.ErrorEstimator, list[str]]] = {}
    for place, model in models.items():
        with remarked() as remarks:
            try:
                with _core.OnePath(method.options.get("deterministic") is True):
                    check_bodies(model)
                    given = {"on_inaccurate": "pass", **method.given}
                    it = prepared(model, method.plan, given, method.options)
                    it = replace(it, facts={**it.facts, "lane": True})
                    runs[place] = it, estimator_of(it), remarks  # it sees the run from the first step on
            except Exception as error:
                found[place] = Member(None, error=facts_of(error))
    with Interrupts() as interrupts, interrupts.computing():
        reasons = _core.advance_together([_adaptive(it.run) for it, *_ in runs.values()], method.threads)
    for (place, (it, estimator, remarks)), reason in zip(runs.items(), reasons, strict=True):
        if reason:
            found[place] = _Left(reason, remarks)
        else:
            found[place] = _concluded(it, estimator, method, remarks)
    return found


def _adaptive(run: _core.Run) -> _core.AdaptiveSimulation:
    assert isinstance(run, _core.AdaptiveSimulation)
    return run


def _concluded(
    it: Prepared, estimator: estimation.ErrorEstimator, method: Method, remarks: Sequence[str]
) -> Member:
    with remarked() as more:
        try:
            with _core.OnePath(method.options.get("deterministic") is True):
                result = concluded(it, estimator)
        except Exception as error:
            return Member(None, error=facts_of(error), remarks=[*remarks, *more])
    result._statistics["lane"] = True
    for name in SHARED:
        result._statistics.pop(name, None)
    return Member(result, remarks=list(dict.fromkeys([*remarks, *more])))


def _prepared(
    place: int, model: Model, method: Method, first: _Ready | None, *, follows: bool
) -> _Ready | Member:
    """`first`: one that was prepared before: what does not depend on weights is not looked at again."""
    known = first is not None and method.weights_alone and first.plain
    with remarked() as remarks:
        try:
            if first is not None and known:
                it = _Ready(place, first.method, _of_other_weights(first.stepped, model, method), remarks)
            else:
                own, like = method.of(model), None if first is None else first.system
                it = _Ready(place, own, _stepped(model, own, like), remarks)
                forecast.look_ahead(it.system, own.plan, it.stepped.method, None, None, None)
            it.plain = it.stepped.assembly is None and not remarks
            if method.judged:
                _follow(it, it.method, follows)
        except Exception as error:
            return Member(None, error=facts_of(error))
    return it


def _of_other_weights(known: Stepped, model: Model, method: Method) -> Stepped:
    with _core.OnePath(method.options.get("deterministic") is True):
        check_bodies(model)
        return of_other_weights(known, model, method.plan, assemble=method.given["assemble"])


def _stepped(model: Model, method: Method, like: System | None = None) -> Stepped:
    with _core.OnePath(method.options.get("deterministic") is True):
        check_bodies(model)
        return what_steps(model, method.plan, method.given, method.options, like=like)


def _follow(it: _Ready, method: Method, errors: bool) -> None:
    """Its steps, for the verdict, and `errors` as they grow."""
    plan = method.plan
    assert isinstance(plan, schedule.Fixed)
    every = plan.record_every if method.last_state else 0
    it.run = _core.LaneRun(it.system.compiled(), plan.t_end, plan.step, every, errors)
    it.estimator = estimation.ErrorEstimator(
        it.run, it.stepped.method, it.system, it.stepped.options, None, plan, breaks=it.stepped.breaks
    )


def _in_lanes(ready: Sequence[_Ready], method: Method) -> dict[int, Member | _Left]:
    plan = method.plan
    integrator = ready[0].stepped.method
    assert isinstance(plan, schedule.Fixed)
    assert isinstance(integrator, Integrator)
    tableau = integrator.compiled()
    assert isinstance(tableau, _core.Tableau)  # others run alone
    with Interrupts() as interrupts, interrupts.computing():
        answers = _core.run_ensemble(
            [it.system.compiled() for it in ready], tableau, plan.t_end, plan.step, method.lanes_record_every,
            method.threads, [it.run for it in ready if it.run is not None],
            list(check_breaks(method.given["breaks"], "simulate")), counts_turns=not method.last_state,
        )  # fmt: skip
    found: dict[int, Member | _Left] = {}
    for it, answer in zip(ready, answers, strict=True):
        if answer["reason"]:
            when = answer["left_at"]
            reason = answer["reason"] + ("" if when is None else f" (at t = {when:.6g} s)")
            found[it.place] = _Left(reason, it.remarks)
        else:
            found[it.place] = _ended(it, answer, method)
    return found


def _ended(it: _Ready, answer: Mapping[str, Any], method: Method) -> Member:
    frames = answer["frames"]
    poses = _singular_poses(it)
    if not method.state_alone:
        result = _result(it, frames, method, poses)
        result._statistics.update({name: answer[name] for name in ("turned",) if name in answer})
        with remarked() as more:
            warn_of_what_frames_show(result)
        return Member(result, remarks=[*it.remarks, *more])
    verdict, _ = _judged(it, frames, method, poses)
    return Member(None, remarks=it.remarks, last=LastState(frames, verdict, {"model": it.model.name}))


def _result(it: _Ready, frames: Mapping[str, Any], method: Method, poses: Mapping[str, Any]) -> Result:
    integrator = it.stepped.method
    assert isinstance(integrator, Integrator)
    facts: dict[str, Any] = {"model": it.model.name, "lane": True}
    if not method.last_state:  # else nobody sees more of the result than its last state
        chosen = {"t_start": 0.0, **method.plan.chosen(), "integrator": integrator.name, **it.system.options}
        facts = {**manifest(it.model, it.model.hash(), method.given, chosen), **facts}
    beside = method.plan.beside(it.model, it.stepped.breaks, 0.0)
    header = Header.of(
        it.model.compiled(), it.system.compiled(), facts, None, it.model.shapes, it.model.curves, beside
    )
    verdict, counts = _judged(it, frames, method, poses)
    crossings = it.system.compiled().statistics()["singularity_crossings"]
    statistics = {"lane": True, **poses, "singularity_crossings": crossings, **counts}
    if verdict is not None:
        statistics["verdict"] = verdict.numbers()
    return Result(frames, replace(header, unlike_run=LawsOfForces(it.model)), statistics)


def _singular_poses(it: _Ready) -> dict[str, Any]:
    """How many were passed; LinkworkWarning as asked for."""
    compiled = it.system.compiled()
    poses, changes = compiled.passed
    if poses and compiled.options.on_singular == "warn":
        with remarked() as remarks:
            recording.warn_of_singular_poses(compiled.statistics(), 0)
            recording.warn_of_more_singular_poses(compiled.statistics())
        it.remarks.extend(remarks)
    return {"singular_poses": poses, "row_changes": changes}


def _judged(
    it: _Ready, frames: Mapping[str, Any], method: Method, poses: Mapping[str, Any]
) -> tuple[Verdict | None, dict[str, Any]]:
    """The verdict, and the statistics with which it comes: as of the run by itself."""
    if it.run is None or it.estimator is None:
        return None, {}
    with _core.OnePath(method.options.get("deterministic") is True):
        it.estimator.look(it.run.take_balance() if method.last_state else frames)
        counts: dict[str, Any] = {
            **poses,
            "steps": it.run.steps_done,
            **({"passed_touches": passed} if (passed := it.run.passed_touches) else {}),
            **method.plan.steps_with_breaks(it.stepped.breaks),
        }
        return it.estimator.verdict(counts, steps=not method.state_alone), counts


def _alone(model: Model, method: Method, left: _Left) -> Member:
    with remarked() as more:
        try:
            result = simulate(model, method.t_end, progress=False, **method.arguments)
        except Exception as error:
            return Member(None, left.reason, facts_of(error), [*left.remarks, *more])
    return Member(result, left.reason, remarks=list(dict.fromkeys([*left.remarks, *more])))
