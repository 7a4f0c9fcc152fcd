"""Thin rods, point masses and massless bodies, whose motion joints and the rest of the mechanism decide."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from light_mechanisms import Light, light_mechanisms
from random_mechanisms import Floats, examples
from test_formulations_agree import CHOICES, largest, options


def relative_error(found: Floats, exact: Floats, least: float = 0.0) -> float:
    return largest(found - exact) / (max(largest(exact), least) or 1.0)


@pytest.mark.parametrize(("form", "solver"), [(f, s) for f, s in CHOICES if f != "normal"])
@examples(15)
@given(light=light_mechanisms(most=12))
def test_every_solver_of_standard_finds_accelerations_and_joint_forces(
    light: Light, form: str, solver: str
) -> None:
    mechanism = light.mechanism
    dynamics = mechanism.dynamics(**options(form, solver))
    v_dot, multipliers = dynamics.accelerations(0.0, mechanism.q, mechanism.v)
    exact_v_dot, exact_multipliers = light.solution()
    assert relative_error(v_dot, exact_v_dot) <= 1e-9
    D = light.at.D
    assert relative_error(D.T @ multipliers, D.T @ exact_multipliers) <= 1e-9
