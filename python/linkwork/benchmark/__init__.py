"""How fast linkwork is: right-hand sides by linear solver, growth with the size, time of steps and runs.

    from linkwork import benchmark

    chain = benchmark.Subject.of("chain", bodies=1000)
    print(benchmark.compare_solvers(chain, ["block", "cholmod"]).solvers[0].ns_per_body)

Times are wall times, medians over rounds. For numbers to compare, let nothing else run and give BLAS one
thread (OMP_NUM_THREADS=1, OPENBLAS_NUM_THREADS=1, before Python starts), as `linkwork bench` does.
"""

from __future__ import annotations

from linkwork.benchmark.ensembles import SUBJECTS, Lanes, measure_lanes
from linkwork.benchmark.machine import machine
from linkwork.benchmark.right_hand_side import Comparison, Measured, Refused, compare_solvers
from linkwork.benchmark.scaling import Growth, Missing, Size, growth
from linkwork.benchmark.stepping import LONG_RUNS, Run, Steps, long_run, time_steps
from linkwork.benchmark.subject import Subject

__all__ = [
    "LONG_RUNS", "SUBJECTS", "Comparison", "Growth", "Lanes", "Measured", "Missing", "Refused", "Run", "Size",
    "Steps", "Subject", "compare_solvers", "growth", "long_run", "machine", "measure_lanes", "time_steps",
]  # fmt: skip
