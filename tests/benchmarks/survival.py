"""Which methods take a double four-bar through its singular poses, at which steps.

python tests/benchmarks/survival.py

The mechanism is four_bar(2) for 5 s; eight steps between 4.6 and 10.9 ms (fixed, or for DP5 the largest). A
run survives when it ends with its state within 1 % of a reference of order eight; the error is the largest
difference of any coordinate q [m or 1] at t = 5 s.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import linkwork as lw
import numpy as np
from linkwork import mechanisms
from linkwork.arrays import Floats

T_END = 5.0
STEPS = (4.6e-3, 5.5e-3, 6.4e-3, 7.3e-3, 8.2e-3, 9.1e-3, 10.0e-3, 10.9e-3)  # s
SURVIVED = 1e-2
REFERENCE_STEPS, AGREEMENT = (1e-3, 7e-4), 1e-7

METHODS: dict[str, dict[str, Any]] = {
    "standard, sampled Baumgarte, RK4": {"integrator": "rk4"},
    "standard, projection, RK4": {"integrator": "rk4", "stabilization": "projection"},
    "augmented Lagrangian, RK4": {"integrator": "rk4", "formulation": "augmented_lagrangian"},
    "HEM4": {"integrator": "hem4"},
    "DP5, rtol 1e-8": {"integrator": "dopri5", "rtol": 1e-8},
}


@dataclass(frozen=True)
class Survival:
    """Errors at the end, one for each step; infinite for a run that failed."""

    method: str
    errors: tuple[float, ...]

    @property
    def survived(self) -> int:
        return sum(error <= SURVIVED for error in self.errors)

    @property
    def median(self) -> float:
        return float(np.median(self.errors))


def final_state(step: float | None, **options: Any) -> Floats:
    """q at the end (5, 7)."""
    result = lw.simulate(mechanisms.four_bar(2), T_END, step, progress=False, **options)
    return np.asarray(result.q[-1])


def reference() -> Floats:
    """By a method of order eight; errors far from singular poses are below 1e-12 at both steps.

    Steps that end or have a stage very near to a singular pose magnify what violates the constraints there,
    so two runs that agree are asked for. RuntimeError: they do not.
    """
    first, second = (final_state(step, integrator="dop853") for step in REFERENCE_STEPS)
    if not np.abs(first - second).max() <= AGREEMENT:
        raise RuntimeError(f"the references differ by {np.abs(first - second).max():.1e}")
    return second


def survive(method: str, steps: Sequence[float], expected: Floats) -> Survival:
    """Run one of METHODS with each of the steps [s]."""
    errors = []
    for step in steps:
        try:
            errors.append(float(np.abs(final_state(step, **METHODS[method]) - expected).max()))
        except lw.LinkworkError as error:
            print(f"{method}, step {step:g} s: {error}", file=sys.stderr)
            errors.append(float("inf"))
    return Survival(method, tuple(errors))


def main() -> None:
    expected = reference()
    print(f"{'':34}survived   median    worst   by step [ms]")
    print(f"{'':60}" + " ".join(f"{1e3 * step:7.1f}" for step in STEPS))
    for method in METHODS:
        found = survive(method, STEPS, expected)
        each = " ".join(f"{error:7.0e}" for error in found.errors)
        count = f"{found.survived} of {len(STEPS)}"
        print(f"{method:34}{count:8}  {found.median:7.1e}  {max(found.errors):7.1e}   {each}")


if __name__ == "__main__":
    main()
