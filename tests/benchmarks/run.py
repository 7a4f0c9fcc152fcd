"""Benchmarks: python tests/benchmarks/run.py [NAME ...] [--runs N] [--json]

Each measures several runs with one thread and prints medians, beside the target it must meet.
"""

# ruff: noqa: E402 (the environment comes before numpy)

from __future__ import annotations

import os

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[threads] = "1"

import argparse
import json
import platform
import sys
from collections.abc import Callable
from importlib.metadata import version

from measure import Outcome, table
from overhead import overhead
from step_scaling import step_scaling

BENCHMARKS: dict[str, Callable[[int], Outcome]] = {"step_scaling": step_scaling, "overhead": overhead}


def main() -> int:
    """1 where a target is missed."""
    arguments = _arguments()
    outcomes = {}
    for name in arguments.names or BENCHMARKS:
        outcomes[name] = BENCHMARKS[name](arguments.runs)
        if not arguments.json:
            print(table(name, outcomes[name]), flush=True)
    if arguments.json:
        machine = {
            "python": platform.python_version(),
            "machine": platform.machine(),
            "processor": _processor(),
        }
        found = {name: outcome.as_dict() for name, outcome in outcomes.items()}
        print(
            json.dumps(
                {"linkwork": version("linkwork"), **machine, "runs": arguments.runs, "benchmarks": found},
                indent=1,
            )
        )
    return 0 if all(outcome.met for outcome in outcomes.values()) else 1


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Benchmarks of linkwork.")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(BENCHMARKS)}; without: all")
    parser.add_argument("--runs", type=int, default=5, help="of which the median is taken (5)")
    parser.add_argument("--json", action="store_true", help="numbers for machines")
    arguments = parser.parse_args()
    for name in arguments.names:
        if name not in BENCHMARKS:
            parser.error(f"no benchmark '{name}'; there are: {', '.join(BENCHMARKS)}")
    if arguments.runs < 1:
        parser.error(f"--runs {arguments.runs} must be at least 1")
    return arguments


def _processor() -> str:
    try:
        with open("/proc/cpuinfo") as lines:
            return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()


if __name__ == "__main__":
    sys.exit(main())
