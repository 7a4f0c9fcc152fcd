"""One case: a model, its run, and at once what is kept of it; what fails is kept as failed."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from linkwork import _core
from linkwork.arguments import UNREADABLE, whole
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.modeling.model import Model
from linkwork.results.last_state import LastState
from linkwork.results.result import Result
from linkwork.running import recording, schedule
from linkwork.running.estimation import of_memory
from linkwork.running.leaving_no_memory import called, leaving_no_memory
from linkwork.running.manifest import platform_facts
from linkwork.running.remarks import facts_of, remarked
from linkwork.running.simulation import simulate
from linkwork.studies.notes import warn_of_notes
from linkwork.studies.outputs import Output
from linkwork.studies.variants import Source

__all__ = ["Answer", "Case", "Run", "Runner", "in_one", "kept", "machine"]

#: A time that differs from the end by no more than this, relative, is the end: 3 * 0.1 is not 0.3.
ROUNDED = 1e-12

#: Characters of remarks that are kept of a case.
REMARKS = 1000


@dataclass(frozen=True)
class Case:
    """One that is to be run."""

    number: int
    key: str
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Run:
    """What became of one, in plain data.

    status   "finished" or "failed"
    outputs  by label, in lists; none of one that failed
    error    of one that failed: type, code, message, and `reached`, the simulated time [s] up to there
    verdict  level, sentence and error of Result.verdict, what remembers, and where that is known the growth
             of errors that is more than in regular motion, "unstable"; nothing where there is none
    seconds  wall time
    """

    key: str
    status: str
    outputs: Mapping[str, Any] = field(default_factory=dict)
    error: Mapping[str, Any] = field(default_factory=dict)
    verdict: Mapping[str, Any] = field(default_factory=dict)
    remarks: str = ""
    seconds: float = 0.0
    values: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Answer:
    """What a process gives back for several cases."""

    machine: Mapping[str, Any]
    runs: Sequence[Run]


@dataclass(frozen=True)
class Runner:
    """Everything that the cases have in common; it goes to other processes."""

    source: Source
    t_end: float
    options: Mapping[str, Any]
    outputs: Sequence[Output]
    times: Floats | None

    lanes: ClassVar[bool] = False  #: whether they run in those of ensembles

    @property
    def follows_all(self) -> bool:
        """Whether errors of all cases are followed as they grow, as far as they can be."""
        return True

    def __call__(self, cases: Sequence[Case]) -> Answer:
        return Answer(machine(), [self.run(case) for case in cases])

    def run(self, case: Case) -> Run:
        """Whatever it raises, it is a Run."""
        found: dict[str, Any]
        started = time.perf_counter()
        with remarked() as remarks:
            try:
                model = self.source.model(case.values)
                with leaving_no_memory(called(model, self.options), logs=True):
                    found = self.kept(self._simulated(model))
            except Exception as error:
                found = {"status": "failed", "error": facts_of(error)}
        return self.noted(case, found, remarks, time.perf_counter() - started)

    def noted(self, case: Case, found: Mapping[str, Any], remarks: Sequence[str], seconds: float) -> Run:
        return Run(case.key, **found, remarks=_cut(in_one(remarks, found)), seconds=seconds,
                   values=dict(case.values))  # fmt: skip

    def kept(self, result: Result | LastState) -> dict[str, Any]:
        """Status, outputs and verdict of one that came to its end; failed where an output cannot be told.

        LinkworkWarning: notes on what the outputs are.
        """
        warn_of_notes(result, self.outputs)
        return kept(result, self.outputs, self.times)

    def result(self, values: Mapping[str, Any]) -> Result:
        """The whole run of a case."""
        model = self.source.model(values)
        with leaving_no_memory(called(model, self.options), logs=False):
            return self._simulated(model)

    def _simulated(self, model: Model) -> Result:
        options = {"threads": 1, **self.options}  # the processors are for other cases
        return simulate(model, self.t_end, progress=False, **options)


def kept(result: Result | LastState, outputs: Sequence[Output], times: Floats | None) -> dict[str, Any]:
    """As Runner.kept, without the notes."""
    values = {}
    for output in outputs:
        try:
            values[output.label] = output.value(result, times).tolist()
        except Exception as error:
            facts, named = facts_of(error), f"output '{output.label}': "
            text = str(facts["message"])
            message = text if text.startswith(named) else named + text
            return {"status": "failed", "error": {**facts, "message": message}}
    return {"status": "finished", "outputs": values, "verdict": _verdict(result)}


def machine() -> dict[str, str]:
    """Where numbers come from: bits may differ between instruction sets."""
    return {"cpu": str(platform_facts()["cpu"]), "instruction_set": _core.instruction_set()}


def _verdict(result: Result | LastState) -> dict[str, Any]:
    verdict = result.verdict
    if verdict is None:
        return {}
    found = {"level": verdict.level, "error": float(verdict.error), "sentence": verdict.sentence}
    if verdict.growth is not None or verdict.unstable > 1.0:
        found["unstable"] = verdict.unstable
    return {**found, "memory": list(verdict.memory)} if verdict.memory else found


def _cut(text: str) -> str:
    return text if len(text) <= REMARKS else f"{text[:REMARKS]} ... ({len(text)} characters)"


def in_one(remarks: Sequence[str], found: Mapping[str, Any]) -> str:
    """The remarks of a case, and that functions of the user's remember calls, which its run does not say."""
    memory = found.get("verdict", {}).get("memory")
    return "; ".join(dict.fromkeys([*remarks, *([of_memory(memory)] if memory else [])]))


def check_times(
    times: Any, t_end: float, options: Mapping[str, Any], outputs: Sequence[Output], model: Model
) -> tuple[Floats | None, dict[str, Any]]:
    """The times of arrays (k,) [s], and options with frames there, and wherever outputs look.

    OptionError: not ascending, beyond the run, or between the frames of fixed steps.
    """
    wanted = None if times is None else _ascending(times, t_end)
    fixed = options.get("rtol") is None and options.get("atol") is None
    at_end = fixed and wanted is None and all(it.at_end for it in outputs)
    made = {**({} if at_end else {"record_every": 1}), "on_inaccurate": "pass", **options}
    if not fixed:
        return wanted, {**made, **_frames(wanted, t_end, options, outputs, recording.frame_bytes(model))}
    if wanted is not None:
        apart = float(options.get("step") or t_end) * whole(made["record_every"], 1, "record_every")
        _check_multiples(wanted, apart, t_end)
    return wanted, made


def _ascending(times: Any, t_end: float) -> Floats:
    try:
        wanted = np.atleast_1d(np.array(times, dtype=float))
    except UNREADABLE as error:
        raise OptionError(f"times {times!r:.80} are no numbers", code="times") from error
    good = wanted.ndim == 1 and len(wanted) and np.isfinite(wanted).all()
    wanted = np.where(np.abs(wanted - t_end) <= ROUNDED * t_end, t_end, wanted)
    if not good or (np.diff(wanted) <= 0).any() or wanted[0] < 0 or wanted[-1] > t_end:
        raise OptionError(f"times {times!r:.80} are not ascending, from 0 to {t_end:g} s", code="times")
    return wanted


def _frames(
    wanted: Floats | None, t_end: float, options: Mapping[str, Any], outputs: Sequence[Output], size: int
) -> dict[str, Any]:
    """`record_every` and `times` of a run whose steps follow tolerances, of frames of `size` bytes.

    Its steps are long where the motion is smooth, however much it turns in one: what is largest is looked for
    at the times of the frames of `simulate`, too, and at all steps, which are short where something happens.
    """
    every, at = options.get("record_every"), wanted
    if every is None and any(it.of_whole_run for it in outputs):
        every, between = 1, schedule.evenly(0.0, t_end, size)
        at = between if wanted is None else np.union1d(wanted, between)
    elif every is None and wanted is not None:
        at = np.union1d(wanted, [0.0, t_end])
    elif every is None:
        every = 1
    return {"record_every": every, **({} if at is None else {"times": at.tolist()})}


def _check_multiples(wanted: Floats, apart: float, t_end: float) -> None:
    """OptionError: between frames that are so far apart [s]."""
    off = np.abs(wanted / apart - np.round(wanted / apart)) * apart > 1e-9 * t_end
    off &= wanted < t_end
    if off.any():
        raise OptionError(
            f"times: {wanted[off][0]:.9g} s is between the frames of this run, {apart:g} s apart: give "
            "multiples of that, or rtol instead of step",
            code="times",
        )
