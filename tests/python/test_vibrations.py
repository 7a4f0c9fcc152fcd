"""Verdicts of many periods of vibrations that are linear or nearly so: errors add up, and do not grow on."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from scipy.linalg import eigh
from scipy.special import ellipj, ellipk

#: Methods that are 1e-5 to 1e-1 off here after some hundred periods.
METHODS: tuple[dict[str, Any], ...] = (
    {"rtol": 1e-5},
    {"rtol": 1e-6, "integrator": "bs32"},
    {"step": 0.02, "integrator": "rk4"},
    {"step": 2e-3, "integrator": "heun"},
)


def masses(count: int, damping: float = 0.0) -> lw.Model:
    """Of 1, 1.3, ... kg in a row on springs of 40 N/m, the first of which is pushed with 1 m/s."""
    model = lw.Model(gravity=(0, 0, 0))
    for k in range(count):
        place = (float(k), 0, 0)
        model.body(f"mass {k}", mass=1 + 0.3 * k, inertia=(0.1, 0.1, 0.1), position=place,
                   velocity=(float(k == 0), 0, 0))  # fmt: skip
        model.translational("ground", f"mass {k}", at=place, axis=(1, 0, 0))
        model.spring_damper(f"mass {k - 1}" if k else "ground", f"mass {k}", at=((k - 1.0, 0, 0), place),
                            stiffness=40.0, damping=damping, free_length=1.0)  # fmt: skip
    return model


def shifts(count: int, t: Floats) -> Floats:
    """(F, n): of undamped masses, by their normal modes."""
    M = np.diag(1 + 0.3 * np.arange(count))
    K = 40.0 * (2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1))
    K[-1, -1] = 40.0
    squares, shapes = eigh(K, M)
    omega, start = np.sqrt(squares), shapes.T @ M @ np.eye(count)[0]
    return np.asarray((start / omega * np.sin(np.multiply.outer(t, omega))) @ shapes.T)


def said_by_true(result: lw.Result, true: float) -> float:
    assert result.verdict is not None and 1e-6 < true < 0.5
    return result.verdict.error / true


@pytest.mark.parametrize("how", METHODS, ids=str)
@pytest.mark.parametrize("count", (1, 3))
def test_a_linear_vibration_is_said_to_be_as_far_off_as_it_is(count: int, how: dict[str, Any]) -> None:
    result = lw.simulate(masses(count), 200.0, **how, on_inaccurate="pass", progress=False)
    exact = shifts(count, result.t)
    moved = result.position[:, :, 0] - np.arange(count)
    true = float(np.abs(moved - exact).max() / np.abs(exact).max())
    assert 0.5 < said_by_true(result, true) < 60


@pytest.mark.parametrize("how", METHODS, ids=str)
@pytest.mark.parametrize("amplitude", (0.02, 0.1, 1.2))
def test_a_pendulum_is_never_said_to_be_better_than_it_is(amplitude: float, how: dict[str, Any]) -> None:
    """theta = 2 asin(k sn(K - w t, k)), k = sin(amplitude / 2), whose period hardly depends on small ones."""
    g, length, modulus = 9.81, 1.5, np.sin(amplitude / 2)
    model = lw.Model(gravity=(0, 0, -g))
    start = length * np.sin(amplitude), 0.0, -length * np.cos(amplitude)
    model.body("bob", mass=1.0, inertia=(0.1, 0.1, 0.1), position=start)
    model.distance("ground", "bob", at=((0, 0, 0), start))
    result = lw.simulate(model, 150.0, **how, on_inaccurate="pass", progress=False)
    sn = ellipj(ellipk(modulus**2) - np.sqrt(g / length) * result.t, modulus**2)[0]
    exact = length * np.sin(2 * np.arcsin(modulus * sn))
    true = float(np.abs(result.position[:, 0, 0] - exact).max() / start[0])
    assert 0.5 < said_by_true(result, true) < 100


def test_what_dampers_take_away_is_no_delay() -> None:
    damped = lw.simulate(masses(2, damping=0.5), 200.0, rtol=1e-5, progress=False)
    assert damped.verdict is not None and damped.verdict.error < 1e-3


@pytest.mark.parametrize("amplitude", (0.02, 0.3, 1.0))
def test_springs_across_the_way_have_a_period_that_depends_on_the_energy(amplitude: float) -> None:
    """Half unloaded ones: a verdict that took their vibration for linear would be far below the truth."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(amplitude, 0, 0))
    model.translational("ground", "mass", at=(amplitude, 0, 0), axis=(1, 0, 0))
    for side in (-1.0, 1.0):
        model.spring_damper("ground", "mass", at=((0, side, 0), (amplitude, 0, 0)), stiffness=40.0,
                            free_length=0.9)  # fmt: skip
    times = np.linspace(0.0, 200.0, 2001)
    truth = lw.simulate(model, 200.0, rtol=1e-12, integrator="dop853", times=times, progress=False)
    for how in ({"rtol": 1e-5}, {"rtol": 1e-6, "integrator": "bs32"}):
        result = lw.simulate(model, 200.0, **how, times=times, on_inaccurate="pass", progress=False)
        true = float(np.abs(result.position - truth.position).max() / amplitude)
        assert 0.5 < said_by_true(result, true) < 60
