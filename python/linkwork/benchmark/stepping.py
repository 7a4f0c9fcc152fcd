"""The time of a step of `simulate`, and of whole runs."""

from __future__ import annotations

import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.benchmark.choices import check_choices
from linkwork.benchmark.subject import Subject
from linkwork.equations.system import System
from linkwork.modeling.model import Model
from linkwork.results.result import Result
from linkwork.running.progress import ShowOption, counting
from linkwork.running.simulation import simulate

ROUNDS = 5

#: A run of several steps takes about so long [s]; its fewest and most steps.
RUN_SECONDS, FEWEST_STEPS, MOST_STEPS = 0.1, 10, 20_000

#: Looks at redundant equations that are timed together.
WATCH_REPEATS = 1000

#: What a run is made of, in its statistics.
PARTS = ("evaluate", "factorize", "solve")


@dataclass(frozen=True)
class Steps:
    """Steps of one mechanism with its recommended settings; times are wall times, medians over the rounds."""

    mechanism: str
    parameters: dict[str, Any]
    bodies: int
    rows: int
    formulation: str
    linear_solver: str
    integrator: str
    step: float  #: [s]
    steps: int  #: in a round
    rounds: int
    us_per_step: float
    ns_per_body_and_evaluation: float
    evaluations_per_step: float
    #: of the time of a step: evaluate, factorize (with the first solution), solve (further ones), rest
    shares: dict[str, float]
    #: of the time of a step, spent on looking whether redundant equations still hold; part of the rest
    watch_share: float
    #: of the time of these steps, beside it: to follow them, and to take some of them again for the verdict
    watching: float
    verdict: float


@dataclass(frozen=True)
class Run:
    """One run through `simulate`, from the model to the result."""

    mechanism: str
    parameters: dict[str, Any]
    bodies: int
    formulation: str
    linear_solver: str
    integrator: str
    t_end: float  #: [s]
    step: float  #: [s]
    seconds: float  #: in all
    setup_seconds: float
    compiled_share: float  #: of the time in all, spent in the compiled module
    steps_per_second: float
    max_energy_error: float  #: [J]
    max_position_violation: float


#: mechanism, t_end [s], step [s]: runs that a user waits for.
LONG_RUNS: tuple[tuple[Subject, float, float], ...] = (
    (Subject("bricard", {}), 10.0, 1e-3),
    (Subject("four_bar", {"n": 40}), 10.0, 1e-3),
)


def time_steps(
    subjects: Sequence[Subject], *, rounds: int = ROUNDS, progress: ShowOption = None
) -> list[Steps]:
    """Time steps of RK4 with the settings that each mechanism recommends, the mechanisms in alternation.

    OptionError, ModelError: parameters that make no mechanism. LinkworkError: a run that fails.
    """
    check_choices(["auto"], "standard", "auto", rounds, 1.0)
    with counting(progress, rounds + 1) as report:
        stepped = []
        for subject in subjects:
            report(0, subject.mechanism)
            stepped.append(_Stepped(subject))
        for number in range(rounds):
            for one in stepped:
                report(1 + number, f"{one.subject.mechanism}: round {number + 1} of {rounds}")
                one.results.append(one.run(one.steps).statistics)
    return [one.measured() for one in stepped]


def long_run(subject: Subject, t_end: float, step: float, progress: ShowOption = None) -> Run:
    """One run by RK4, else with the settings that the mechanism recommends. LinkworkError: it fails."""
    model = subject.build()
    result = _simulate(subject, model, t_end, step, progress=progress)
    found, chosen = result.statistics, result.manifest["options"]
    return Run(
        mechanism=subject.mechanism,
        parameters=dict(subject.parameters),
        bodies=model.body_count,
        formulation=chosen["formulation"],
        linear_solver=chosen["linear_solver"],
        integrator=chosen["integrator"],
        t_end=t_end,
        step=step,
        seconds=found["seconds"],
        setup_seconds=found["setup_seconds"],
        compiled_share=found["driver_seconds"] / found["seconds"],
        steps_per_second=found["steps"] / found["seconds"],
        max_energy_error=float(np.abs(result.energy_error).max()),
        max_position_violation=float(result.violation[:, 0].max()),
    )


class _Stepped:
    """A mechanism, and the statistics of its runs."""

    def __init__(self, subject: Subject) -> None:
        self.subject, self.model = subject, subject.build()
        self.step: float = subject.step
        self.run(1)
        one = self.run(FEWEST_STEPS).statistics["driver_seconds"] / FEWEST_STEPS
        self.steps = min(max(round(RUN_SECONDS / one), FEWEST_STEPS), MOST_STEPS)
        self.results: list[Mapping[str, Any]] = []

    def run(self, steps: int) -> Result:
        end = steps * self.step
        self.result = _simulate(self.subject, self.model, end, self.step, record_every=steps, progress=False)
        return self.result

    def measured(self) -> Steps:
        bodies, chosen = self.model.body_count, self.result.manifest["options"]
        seconds = self._median("driver_seconds") / self.steps
        evaluations = self._median("evaluations") / self.steps
        shares = {part: self._median(f"{part}_time") / self.steps / seconds for part in PARTS}
        return Steps(
            mechanism=self.subject.mechanism,
            parameters=dict(self.subject.parameters),
            bodies=bodies,
            rows=self.model.row_count,
            formulation=chosen["formulation"],
            linear_solver=chosen["linear_solver"],
            integrator=chosen["integrator"],
            step=self.step,
            steps=self.steps,
            rounds=len(self.results),
            us_per_step=1e6 * seconds,
            ns_per_body_and_evaluation=1e9 * seconds / (bodies * evaluations),
            evaluations_per_step=evaluations,
            shares={**shares, "rest": 1 - sum(shares.values())},
            watch_share=self._watch_seconds() / seconds,
            watching=self._watching() / (seconds * self.steps),
            verdict=self._median("verdict_seconds") / (seconds * self.steps),
        )

    def _watch_seconds(self) -> float:
        """Of one look, at the end of the last run."""
        dynamics = System(self.model).compiled()
        end = self.result.snapshot()
        return float(dynamics.redundancy_watch_time(end.t, end.y, WATCH_REPEATS)) / WATCH_REPEATS

    def _watching(self) -> float:
        dynamics = System(self.model).compiled()
        return float(min(_core.time_sampling(dynamics, self.steps) for _ in range(ROUNDS)))

    def _median(self, name: str) -> float:
        return float(statistics.median(result[name] for result in self.results))


def _simulate(subject: Subject, model: Model, t_end: float, step: float, **how: Any) -> Result:
    settings = {**subject.record.settings, "integrator": "rk4", "t_end": t_end, "step": step,
                "on_inaccurate": "pass"}  # fmt: skip
    return simulate(model, **settings, **how)
