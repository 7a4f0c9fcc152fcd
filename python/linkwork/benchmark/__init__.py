"""How fast linkwork is: right-hand sides by linear solver, growth with the size, time of steps and runs.

    from linkwork import benchmark

    chain = benchmark.Subject.of("chain", bodies=1000)
    print(benchmark.compare_solvers(chain, ["block", "cholmod"]).solvers[0].ns_per_body)

Times are wall times, medians over rounds. For numbers to compare, let nothing else run and give BLAS one
thread (OMP_NUM_THREADS=1, OPENBLAS_NUM_THREADS=1, before Python starts), as `linkwork bench` does.
"""

from __future__ import annotations

from linkwork.benchmark.ensembles import SUBJECTS, Lanes, measure_lanes
from linkwork.benchmark.large import ERRORS, Large, LargeRun, Left, least_cost, measure_large
from linkwork.benchmark.large import METHODS as LARGE_METHODS
from linkwork.benchmark.large_models import LARGE_MODELS
from linkwork.benchmark.machine import machine
from linkwork.benchmark.right_hand_side import Comparison, Measured, Refused, compare_solvers
from linkwork.benchmark.scaling import Growth, Missing, Size, growth
from linkwork.benchmark.stepping import LONG_RUNS, Run, Steps, long_run, time_steps
from linkwork.benchmark.subject import Subject

__all__ = [
    "ERRORS", "LARGE_METHODS", "LARGE_MODELS", "LONG_RUNS", "SUBJECTS", "Comparison", "Growth", "Lanes",
    "Large", "LargeRun", "Left", "Measured", "Missing", "Refused", "Run", "Size", "Steps", "Subject",
    "compare_solvers", "growth", "least_cost", "long_run", "machine", "measure_lanes", "measure_large",
    "time_steps",
]  # fmt: skip
