"""The right-hand side of one mechanism by every linear solver: its parts, the factors, residuals."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, cast

from linkwork import _core
from linkwork.benchmark.choices import check_choices
from linkwork.benchmark.first_step import FirstStep, make_first_step
from linkwork.benchmark.isolated import Failure, isolated
from linkwork.benchmark.residuals import residuals
from linkwork.benchmark.subject import Subject
from linkwork.benchmark.timing import Timing
from linkwork.equations.system import System
from linkwork.errors import LinkworkError
from linkwork.modeling.model import Model
from linkwork.options import Options
from linkwork.running.progress import ShowOption, counting

ROUNDS, LIMIT_SECONDS = 15, 30.0


@dataclass(frozen=True)
class Measured:
    """What one linear solver took; times are wall times, medians over the rounds."""

    solver: str
    matrix_form: str  #: the matrix: kkt, schur or normal
    #: evaluate, assemble (0: part of factorize), factorize, solve, reactions, whole
    ns_per_body: dict[str, float]
    whole_quartiles_ns_per_body: tuple[float, float]
    rounds: int
    passes: int  #: right-hand sides in a round
    compile_seconds: float  #: from the model to the first evaluation: system, rank of D, symbolic analysis
    analyze_seconds: float  #: of which symbolic analysis
    flops: float | None  #: of one factorization, as the solver counts; None: it does not
    flops_per_second: float | None  #: flops over the time to factorize
    factor_bytes: int | None
    factor_nonzeros: int
    matrix_nonzeros: int  #: of the lower triangle
    fill: float  #: factor nonzeros over matrix nonzeros; LU and QR have two factors
    peak_bytes: int | None  #: of memory, of a process that makes one step
    peak_growth_bytes: int | None  #: of which beyond the model
    iterations: float  #: of the formulation, for one solution
    residuals: dict[str, float]  #: relative; see benchmark.residuals


@dataclass(frozen=True)
class Refused:
    """A linear solver that did not take part, and why; `code` as in LinkworkError."""

    solver: str
    reason: str
    code: str


@dataclass(frozen=True)
class Comparison:
    """One mechanism, one formulation, one state; several linear solvers."""

    mechanism: str
    parameters: dict[str, Any]
    bodies: int
    joints: int
    rows: int
    formulation: str
    threads: int  #: that share one right-hand side, where it is large enough
    t: float | None  #: time of the state [s]; None where no solver reached one
    solvers: list[Measured | Refused]


def compare_solvers(
    subject: Subject,
    solvers: Sequence[str] | None = None,
    formulation: str = "standard",
    matrix_form: str = "auto",
    *,
    rounds: int = ROUNDS,
    limit: float = LIMIT_SECONDS,
    threads: int = 1,
    progress: ShowOption = None,
) -> Comparison:  # Long: 21 lines are its arguments and what they are.
    """Time the right-hand side with several linear solvers in alternation, after one step of the mechanism.

    solvers  names; None: all that there are
    rounds   of which the medians are taken; slow solvers get fewer
    limit    time [s] for a process that builds the mechanism and makes its first step
    threads  that share one right-hand side, see linkwork.options.Options

    Each solver makes that step in a process of its own first, which gives its peak memory; a solver that
    fails there is Refused. OptionError: a name that does not exist, a mechanism or a number that cannot be.
    """
    names = list(dict.fromkeys(solvers or [info.name for info in _core.linear_solvers()]))
    check_choices(names, formulation, matrix_form, rounds, limit, threads)
    model = subject.build()
    options = cast(Options, {"formulation": formulation, "matrix_form": matrix_form, "threads": threads})
    with counting(progress, len(names) + rounds) as report:
        steps, refused = _first_steps(subject, options, names, limit, report)
        candidates: dict[str, _Candidate] = {}
        for name, own in steps.items():
            report(len(names), f"{name}: symbolic analysis")
            state = next(iter(steps.values()))  # the same for all
            try:
                own_options = cast(Options, {**options, "linear_solver": name})
                candidates[name] = _Candidate(model, own_options, state, own, rounds)
            except (LinkworkError, MemoryError) as error:
                refused[name] = Refused(name, str(error), getattr(error, "code", "memory"))
        for number in range(rounds):
            for name, candidate in candidates.items():
                report(len(names) + number, f"{name}: round {number + 1} of {rounds}")
                candidate.timing.measure()
    found = {name: candidate.measured(name) for name, candidate in candidates.items()} | refused
    return Comparison(
        mechanism=subject.mechanism,
        parameters=dict(subject.parameters),
        bodies=model.body_count,
        joints=model.joint_count,
        rows=model.row_count,
        formulation=formulation,
        threads=threads,
        t=next((step.t for step in steps.values()), None),
        solvers=[found[name] for name in names],
    )


def _first_steps(
    subject: Subject, options: Options, names: Sequence[str], limit: float, report: Callable[[int, str], None]
) -> tuple[dict[str, FirstStep], dict[str, Refused]]:
    """By each solver in a process of its own; and those that cannot, or take longer than `limit` [s]."""
    steps: dict[str, FirstStep] = {}
    refused: dict[str, Refused] = {}
    for place, name in enumerate(names):
        beat = partial(report, place, f"{name}: first step")
        step = isolated(
            make_first_step, subject, {**options, "linear_solver": name}, seconds=limit, beat=beat
        )
        if isinstance(step, Failure):
            refused[name] = Refused(name, step.reason, step.code)
        else:
            steps[name] = step
    return steps, refused


class _Candidate:
    """A solver that can: its system, and the times so far."""

    def __init__(self, model: Model, options: Options, state: FirstStep, own: FirstStep, rounds: int) -> None:
        started = time.perf_counter()
        self._system = System(model, **options)
        self._compile_seconds = time.perf_counter() - started
        self._own = own
        self.timing = Timing(self._system, state.t, state.y, rounds)

    def measured(self, name: str) -> Measured:
        dynamics, bodies = self._system.compiled(), self._system.model.body_count
        cost, seconds = dynamics.factorization_cost(), self.timing.seconds
        flops, factorize = cost["flops"], seconds["factorize"]
        counts = dynamics.statistics()
        first, third = self.timing.whole_quartiles
        return Measured(
            solver=name,
            matrix_form=dynamics.matrix_form,
            ns_per_body={part: 1e9 * value / bodies for part, value in seconds.items()},
            whole_quartiles_ns_per_body=(1e9 * first / bodies, 1e9 * third / bodies),
            rounds=len(self.timing.samples),
            passes=self.timing.passes,
            compile_seconds=self._compile_seconds,
            analyze_seconds=dynamics.analysis_time(),
            flops=flops,
            flops_per_second=flops / factorize if flops is not None and factorize > 0 else None,
            factor_bytes=cost["bytes"],
            factor_nonzeros=cost["factor_nonzeros"],
            matrix_nonzeros=cost["matrix_nonzeros"],
            fill=cost["factor_nonzeros"] / max(cost["matrix_nonzeros"], 1),
            peak_bytes=self._own.peak_bytes,
            peak_growth_bytes=self._own.growth_bytes,
            iterations=counts["iterations"] / counts["solves"],
            residuals=residuals(self._system, self.timing.t, self.timing.y),
        )
