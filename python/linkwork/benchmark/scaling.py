"""How time and memory grow with the number of bodies."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import cast

import numpy as np

from linkwork.arrays import Floats
from linkwork.benchmark import memory
from linkwork.benchmark.choices import check_choices
from linkwork.benchmark.isolated import Failure, isolated
from linkwork.benchmark.subject import Subject
from linkwork.benchmark.timing import Timing
from linkwork.equations.system import System
from linkwork.errors import OptionError
from linkwork.mechanisms import four_bar
from linkwork.options import Options
from linkwork.running.progress import ShowOption, counting

ROUNDS, LIMIT_SECONDS = 15, 600.0

#: Of the two Euler steps that bring the mechanism into motion [s].
SHORT_STEP = 1e-4


@dataclass(frozen=True)
class Size:
    """One size of a mechanism. Times are wall times, medians over the rounds; memory is what is resident."""

    bodies: int
    rows: int
    ns_per_body: dict[str, float]  #: as in Measured
    rounds: int
    build_seconds: float  #: in Python
    compile_seconds: float  #: from the model to the first evaluation: system, rank of D, symbolic analysis
    analyze_seconds: float  #: of which symbolic analysis
    bytes_per_body: float | None  #: of model, system, factors
    peak_bytes_per_body: float | None  #: with what was in use only on the way


@dataclass(frozen=True)
class Missing:
    """A size that could not be measured; `code` as in LinkworkError."""

    bodies: int
    reason: str
    code: str


@dataclass(frozen=True)
class Growth:
    """One mechanism in several sizes by one method."""

    mechanism: str
    formulation: str
    linear_solver: str
    threads: int  #: that share one right-hand side, where it is large enough
    sizes: list[Size | Missing]
    #: of the fit: time of a right-hand side ~ bodies ^ exponent; None: fewer than two sizes
    exponent: float | None


def growth(
    subjects: Sequence[Subject],
    linear_solver: str = "auto",
    formulation: str = "standard",
    *,
    rounds: int = ROUNDS,
    limit: float = LIMIT_SECONDS,
    threads: int = 1,
    progress: ShowOption = None,
) -> Growth:
    """Time right-hand sides of one mechanism in several sizes, each in a process of its own.

    rounds  of which the medians are taken; slow sizes get fewer
    limit   time [s] for each size
    threads that share one right-hand side, see linkwork.options.Options

    A size that fails is Missing. OptionError: a name that does not exist, a number that cannot be, no size.
    """
    check_choices([linear_solver], formulation, "auto", rounds, limit, threads)
    if not subjects:
        raise OptionError("no size to measure", code="bodies")
    method = {"formulation": formulation, "linear_solver": linear_solver, "threads": threads}
    options = cast(Options, method)
    sizes: list[Size | Missing] = []
    with counting(progress, len(subjects)) as report:
        for place, subject in enumerate(subjects):
            bodies = subject.bodies
            beat = partial(report, place, f"{bodies:,} bodies")
            answer: Size | Missing | Failure
            answer = isolated(measure_size, subject, options, rounds, seconds=limit, beat=beat)
            if isinstance(answer, Failure):
                answer = Missing(bodies, answer.reason, answer.code)
            sizes.append(answer)
    return Growth(subjects[0].mechanism, formulation, linear_solver, threads, sizes, fitted_exponent(sizes))


def measure_size(subject: Subject, options: Options, rounds: int) -> Size:
    """In this process, which must not have measured before."""
    small = System(four_bar(), **options)  # so that code and tables are loaded before memory is counted
    small.derivative(0.0, small.initial_state())
    before, started = memory.resident(), time.perf_counter()
    model = subject.build()
    model.compiled()
    built = time.perf_counter()
    system = System(model, **options)
    compiled = time.perf_counter()
    timing = Timing(system, 2 * SHORT_STEP, _in_motion(system), rounds)
    for _ in range(rounds):
        timing.measure()
    after, peak, bodies = memory.resident(), memory.peak(), model.body_count

    def per_body(total: int | None) -> float | None:
        return None if total is None or before is None else (total - before) / bodies

    return Size(
        bodies=bodies,
        rows=model.row_count,
        ns_per_body={part: 1e9 * value / bodies for part, value in timing.seconds.items()},
        rounds=len(timing.samples),
        build_seconds=built - started,
        compile_seconds=compiled - built,
        analyze_seconds=system.compiled().analysis_time(),
        bytes_per_body=per_body(after),
        peak_bytes_per_body=per_body(peak),
    )


def _in_motion(system: System) -> Floats:
    """y (13n,): two steps are enough for every number that is not always zero to differ from zero."""
    y = system.initial_state()
    for step in range(2):
        y += SHORT_STEP * system.derivative(step * SHORT_STEP, y)
    return y


def fitted_exponent(sizes: Sequence[Size | Missing]) -> float | None:
    """Of time ~ bodies ^ exponent, by least squares of the logarithms; None: fewer than two sizes."""
    measured = [size for size in sizes if isinstance(size, Size)]
    bodies = np.array([size.bodies for size in measured], dtype=float)
    if len(set(bodies)) < 2:
        return None
    whole = bodies * [size.ns_per_body["whole"] for size in measured]
    return float(np.polyfit(np.log(bodies), np.log(whole), 1)[0])
