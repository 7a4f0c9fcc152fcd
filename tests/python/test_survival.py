"""The survival table of tests/benchmarks, with two of its steps: every method passes the singular poses."""

from __future__ import annotations

import sys
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

import survival


@pytest.fixture(scope="module")
def expected() -> survival.Floats:
    return survival.reference()


@pytest.mark.parametrize("method", survival.METHODS)
def test_a_double_four_bar_survives_its_singular_poses(method: str, expected: survival.Floats) -> None:
    found = survival.survive(method, survival.STEPS[1:5:3], expected)
    assert max(found.errors) <= 1e-5


def test_the_reference_keeps_energy_and_constraints() -> None:
    result = lw.simulate(mechanisms.four_bar(2), survival.T_END, 1e-3, "dop853", progress=False)
    assert np.abs(result.energy_error).max() <= 1e-7
    assert result.violation[:, 0].max() <= 1e-9


@pytest.mark.parametrize("integrator", ["dopri5", "tsit5", "dop853"])
@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10])
def test_adaptive_steps_do_not_get_stuck_at_a_singular_pose(
    integrator: str, rtol: float, expected: survival.Floats
) -> None:
    result = lw.simulate(
        mechanisms.four_bar(2), survival.T_END, integrator=integrator, rtol=rtol, progress=False
    )
    assert np.abs(result.q[-1] - expected).max() <= max(100 * rtol, 1e-7)
    assert result.statistics["smallest_step"] >= 1e-5
