"""Cases of a study in the lanes of ensembles: whether all of them go there, and what becomes of some.

Which it is follows from what the study is: its model, its options, its times. So a case has the same bits on
whatever processor, in whatever task, shard or rerun: those of its run by itself with deterministic=True.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from linkwork.errors import LinkworkError
from linkwork.modeling.model import Model
from linkwork.results.last_state import LastState
from linkwork.running.estimation import apply_policy
from linkwork.running.members import (
    Member,
    Method,
    method_of,
    refusal,
    run_members,
)
from linkwork.running.remarks import facts_of, remarked
from linkwork.studies.cases import Answer, Case, Run, Runner, machine
from linkwork.studies.followed import ALL, last_followed

__all__ = ["PACK", "fits", "with_lanes"]

#: Members of the widest pack; tasks have a multiple of it.
PACK = 8

#: Cases that are made and simulated at a time: memory does not grow with those of a task.
AT_ONCE = 4 * PACK

#: Options of `simulate` that lanes do not have.
ALONE = ("verify", "threads")


@dataclass(frozen=True)
class LaneRunner(Runner):
    """Several cases at once, in the lanes of an ensemble."""

    lanes: ClassVar[bool] = True
    follow_errors: bool = False  #: of all cases
    last_followed: str = ALL  #: else of those with a key up to this one

    @property
    def follows_all(self) -> bool:
        return self.last_followed == ALL

    def following(self, keys: Sequence[str]) -> LaneRunner:
        """Errors of some of the cases with these keys, of all with tolerances."""
        every = self.follow_errors or _has_tolerances(self.options)
        return self if every else replace(self, last_followed=last_followed(keys))

    def follows(self, case: Case) -> bool:
        """Whether errors of this one are, as they grow."""
        return case.key <= self.last_followed

    def __call__(self, cases: Sequence[Case]) -> Answer:
        return Answer(machine(), [run for start in range(0, len(cases), AT_ONCE)
                                  for run in _at_once(self, cases[start : start + AT_ONCE])])  # fmt: skip


def with_lanes(runner: Runner, given: Mapping[str, Any], follow_errors: bool) -> Runner | None:
    """The same in lanes; None: they cannot have what it asks for, or the `given` options forbid it."""
    if given.get("deterministic") is False or given.get("on_inaccurate") == "stop":
        return None
    if any(given.get(name) for name in ALONE):
        return None
    options = {**runner.options, "deterministic": True}
    follow_errors = follow_errors and not _has_tolerances(options)
    return LaneRunner(
        runner.source, runner.t_end, options, runner.outputs, runner.times, follow_errors=follow_errors
    )


def _has_tolerances(options: Mapping[str, Any]) -> bool:
    return any(options.get(name) is not None for name in ("rtol", "atol"))


def fits(runner: Runner, example: Model) -> bool:
    """Whether lanes can run a model of the study: else none of it is worth the slower arithmetic."""
    try:
        return not refusal(example, _method(runner, example))
    except LinkworkError:
        return False


def _at_once(runner: LaneRunner, cases: Sequence[Case]) -> list[Run]:
    started = time.perf_counter()
    models = [_model_or_error(runner, case) for case in cases]
    example = next((it for it in models if isinstance(it, Model)), None)
    if example is None:
        errors = [facts_of(it) for it in models if isinstance(it, Exception)]
        return [Run(case.key, "failed", error=facts, values=dict(case.values))
                for case, facts in zip(cases, errors, strict=True)]  # fmt: skip
    with remarked() as told:
        found = run_members(models, _method(runner, example), [runner.follows(case) for case in cases])
        kept = [_kept(runner, member) for member in found]
    seconds = (time.perf_counter() - started) / len(cases)
    return [runner.noted(case, found, [*remarks, *told], seconds)
            for case, (found, remarks) in zip(cases, kept, strict=True)]  # fmt: skip


def _kept(runner: Runner, member: Member) -> tuple[dict[str, Any], Sequence[str]]:
    """As Runner.kept, with all remarks."""
    motion = member.motion
    if motion is None:
        return {"status": "failed", "error": member.error}, member.remarks
    if isinstance(motion, LastState) and runner.options["on_inaccurate"] == "pass":  # nothing remarks
        return runner.kept(motion), member.remarks
    with remarked() as more:
        found = runner.kept(motion)
        apply_policy(motion, runner.options["on_inaccurate"])
    return found, list(dict.fromkeys([*member.remarks, *more]))


def _model_or_error(runner: Runner, case: Case) -> Model | Exception:
    try:
        return runner.source.model(case.values)
    except Exception as error:
        return error


def _method(runner: Runner, example: Model) -> Method:
    last_state = runner.times is None and all(it.at_end for it in runner.outputs)
    return method_of(
        example, runner.t_end, {**runner.options, "threads": 1}, 1, judged=True, last_state=last_state,
        state_alone=all(it.of_state_alone for it in runner.outputs),
        looked_at=any(it.by_user for it in runner.outputs), weights_alone=runner.source.weights_alone,
    )  # fmt: skip
