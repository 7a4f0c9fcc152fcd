"""Some members of an ensemble: through the lanes where they can, else one by one."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from linkwork import _core
from linkwork.equations.system import System
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.motion.header import Header
from linkwork.options import TABLE
from linkwork.results.result import Result
from linkwork.running import checks, schedule
from linkwork.running.interrupts import Interrupts
from linkwork.running.manifest import manifest
from linkwork.running.simulation import simulate, what_steps
from linkwork.studies.cases import facts_of

__all__ = ["Member", "Method", "run_members"]


@dataclass(frozen=True)
class Member:
    """What became of one.

    result  its motion; None where it failed
    reason  why it was simulated by itself; empty: it ran in a lane
    error   of one that failed: type, code, message, and `reached`, the simulated time [s]
    """

    result: Result | None
    reason: str = ""
    error: Mapping[str, Any] = field(default_factory=dict)
    remarks: Sequence[str] = ()


@dataclass(frozen=True)
class Method:
    """How all of them are simulated: the arguments of `simulate` as they were given."""

    t_end: float
    arguments: Mapping[str, Any]
    threads: int
    alone: str  # why none of them can run in lanes; empty where they can
    plan: schedule.Fixed | schedule.Adaptive

    @property
    def given(self) -> dict[str, Any]:
        usual = {"integrator": None, "breaks": (), "assemble": True}
        return {**usual, "t_end": self.t_end, **self.arguments}

    @property
    def options(self) -> Any:
        return {name: value for name, value in self.arguments.items() if name in TABLE}


@dataclass
class _Ready:
    """One that can run in a lane."""

    place: int
    model: Model
    system: System
    method: Integrator
    remarks: list[str]


def run_members(models: Sequence[Model | Exception], method: Method) -> list[Member]:
    """In the order of the models; an exception in place of a model is why there is none."""
    found: dict[int, Member] = {}
    ready: list[_Ready] = []
    for place, model in enumerate(models):
        if isinstance(model, Exception):
            found[place] = Member(None, error=facts_of(model))
        elif method.alone:
            found[place] = _alone(model, method, method.alone)
        else:
            it = _prepared(place, model, method)
            if isinstance(it, Member):
                found[place] = it
            else:
                ready.append(it)
    if ready:
        found.update(_in_lanes(ready, method))
    return [found[place] for place in range(len(models))]


def _prepared(place: int, model: Model, method: Method) -> _Ready | Member:
    with _remarked() as remarks:
        try:
            with _core.OnePath(method.options.get("deterministic") is True):
                checks.check_bodies(model)
                stepped = what_steps(model, method.plan, method.given, method.options)
        except Exception as error:
            return Member(None, error=facts_of(error))
    assert isinstance(stepped.method, Integrator)
    return _Ready(place, stepped.system.model, stepped.system, stepped.method, remarks)


def _in_lanes(ready: Sequence[_Ready], method: Method) -> dict[int, Member]:
    plan = method.plan
    tableau = ready[0].method.compiled()
    assert isinstance(plan, schedule.Fixed)
    assert isinstance(tableau, _core.Tableau)  # others run alone
    with Interrupts() as interrupts, interrupts.computing():
        answers = _core.run_ensemble(
            [it.system.compiled() for it in ready], tableau, plan.t_end, plan.step, plan.record_every,
            method.threads,
        )  # fmt: skip
    found = {}
    for it, answer in zip(ready, answers, strict=True):
        if answer["reason"]:
            when = answer["left_at"]
            reason = answer["reason"] + ("" if when is None else f" (at t = {when:.6g} s)")
            found[it.place] = _alone(it.model, method, reason, it.remarks)
        else:
            found[it.place] = Member(_result(it, answer["frames"], method), remarks=it.remarks)
    return found


def _result(it: _Ready, frames: Mapping[str, Any], method: Method) -> Result:
    chosen = {"t_start": 0.0, **method.plan.chosen(), "integrator": it.method.name, **it.system.options}
    facts = {**manifest(it.model, method.given, chosen), "lane": True}
    header = Header.of(
        it.model.compiled(), it.system.compiled(), facts, None, it.model.shapes, it.model.curves
    )
    return Result(frames, header, {"lane": True})


def _alone(model: Model, method: Method, reason: str, remarks: Sequence[str] = ()) -> Member:
    with _remarked() as more:
        try:
            result = simulate(model, method.t_end, progress=False, **method.arguments)
        except Exception as error:
            return Member(None, reason, facts_of(error), [*remarks, *more])
    return Member(result, reason, remarks=list(dict.fromkeys([*remarks, *more])))


@contextmanager
def _remarked() -> Iterator[list[str]]:
    """Warnings go to the member."""
    texts: list[str] = []
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield texts
    texts.extend(dict.fromkeys(str(it.message) for it in caught))
