"""The long runs of tests/benchmarks, a twentieth as long: nothing drifts, and memory does not grow."""

from __future__ import annotations

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
    assert max(piece.velocity for piece in pieces) <= 1e-7
    assert pieces[-1].energy_error <= 1e-6
    assert pieces[-1].memory - pieces[1].memory <= 5.0  # MB
