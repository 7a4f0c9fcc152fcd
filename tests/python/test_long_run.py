"""The long runs of tests/benchmarks, a twentieth as long: nothing drifts, and memory does not grow."""

from __future__ import annotations

import statistics
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

import long_run


@pytest.mark.parametrize("name", long_run.MECHANISMS)
def test_violation_energy_and_memory_stay_within_bounds(name: str) -> None:
    pieces = list(long_run.run(name, 50.0, 5))
    assert pieces[-1].t == 50.0
    assert max(piece.position for piece in pieces) <= 1e-9
    # how near a step comes to the singular pose is chance: 1e-9 1/s as a rule, 5e-7 in the worst of 24 runs
    velocities = [piece.velocity for piece in pieces]
    assert statistics.median(velocities) <= 1e-8 and max(velocities) <= 2e-6
    assert pieces[-1].energy_error <= 1e-6
    assert pieces[-1].memory - pieces[1].memory <= 5.0  # MB
