"""Verdicts of many periods of vibrations: where these are nearly linear, errors add up and do not grow on."""

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
    g, arm, moment, modulus = 9.81, 0.5, 1 / 12, np.sin(amplitude / 2)
    model = lw.Model(gravity=(0, 0, -g))
    place = arm * np.sin(amplitude), 0.0, -arm * np.cos(amplitude)
    model.body("rod", mass=1.0, inertia=(moment, moment, moment), position=place)
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0))
    omega = np.sqrt(g * arm / (moment + arm**2))
    result = lw.simulate(model, 150.0, **how, on_inaccurate="pass", progress=False)
    sn = ellipj(ellipk(modulus**2) - omega * result.t, modulus**2)[0]
    exact = arm * np.sin(2 * np.arcsin(modulus * sn))
    true = float(np.abs(result.position[:, 0, 0] - exact).max() / place[0])
    assert 0.5 < said_by_true(result, true) < 100


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


def test_a_swinging_spring_whose_motions_exchange_energy_is_not_said_to_be_better_than_it_is() -> None:
    """It stretches twice as often as it swings, so that a little of the one grows by the other, and back."""
    g, stretched = 9.81, 1.1
    model = lw.Model(gravity=(0, 0, -g))
    place = stretched * np.sin(0.01), 0.0, -stretched * np.cos(0.01)
    model.body("bob", mass=1.0, inertia=(0.1, 0.1, 0.1), position=place)
    model.spring_damper("ground", "bob", at=((0, 0, 0), place), stiffness=4 * g, free_length=0.75)
    times = np.linspace(0.0, 400.0, 4001)
    truth = lw.simulate(model, 400.0, rtol=1e-12, integrator="dop853", times=times, progress=False)
    for how in ({"rtol": 1e-6}, {"rtol": 1e-7, "integrator": "dopri5"}):
        result = lw.simulate(model, 400.0, **how, times=times, on_inaccurate="pass", progress=False)
        true = float(np.abs(result.velocity - truth.velocity).max() / np.abs(truth.velocity).max())
        assert said_by_true(result, true) > 0.5


@pytest.mark.parametrize("damping", (-0.02, 0.0))
def test_what_grows_by_itself_is_not_said_to_be_better_than_it_is(damping: float) -> None:
    """By negative damping, or a stiffness that varies twice as fast as the mass (Mathieu): 1e-6 m to 1 m."""
    grows = damping < 0.0
    stiffness: Any = 1.0
    if not grows:
        stiffness = (
            lambda t: 1 + 0.1 * np.sin(2 * t),
            lambda t: 0.2 * np.cos(2 * t),
            lambda t: -0.4 * np.sin(2 * t),
        )
    model = lw.Model(gravity=(0, 0, 0))
    model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1e-6, 0, 0))
    model.translational("ground", "mass", at=(1e-6, 0, 0), axis=(1, 0, 0))
    model.spring_damper("ground", "mass", at=((-3, 0, 0), (1e-6, 0, 0)), stiffness=stiffness, damping=damping,
                        free_length=3.0)  # fmt: skip
    end = 1382.0 if grows else 552.6
    truth = lw.simulate(model, end, rtol=1e-12, integrator="dop853", times=[0.0, end], progress=False)
    result = lw.simulate(model, end, rtol=1e-5, times=[0.0, end], on_inaccurate="pass", progress=False)
    largest = max(abs(truth.position[-1, 0, 0]), abs(truth.velocity[-1, 0, 0]))
    true = float(abs(result.position[-1, 0, 0] - truth.position[-1, 0, 0]) / largest)
    assert said_by_true(result, true) > 0.5


def test_a_law_is_not_asked_about_states_that_the_motion_does_not_have() -> None:
    """It slows a body down that never comes beyond 1 m, beside one that vibrates: the verdict is of both."""
    model = masses(1)
    model.body("slower", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(5, 5, 0), velocity=(1, 0, 0))
    model.translational("ground", "slower", at=(5, 5, 0), axis=(1, 0, 0), name="rail")

    def brake(t: float, shift: float, rate: float) -> float:
        if shift > 1.2:
            raise ValueError(f"{shift} m is not on the rail")
        return -rate

    model.joint_force("rail", brake)
    run = lw.simulate(model, 40.0, 1e-2, on_inaccurate="pass", progress=False)
    assert run.verdict is not None and "no step could be taken again" not in run.verdict.sentence
    assert run.verdict.local_error > 0


def test_equal_vibrations_of_a_large_model_are_all_there_and_no_others() -> None:
    model, lengths = lw.Model(), [1.0 if k % 3 else 0.5 + 0.001 * k for k in range(150)]
    for k, length in enumerate(lengths):
        model.body(f"bob {k}", mass=1.0, inertia=(0.01,) * 3, position=(k, 0, -length))
        model.revolute("ground", f"bob {k}", at=(k, 0, 0), axis=(1, 0, 0))
        model.rotational_friction("ground", f"bob {k}", at=(k, 0, 0), axis=(1, 0, 0), viscous=0.1)
    exact = np.array([np.roots([0.01 + L**2, 0.1, 9.81 * L])[0] for L in lengths])
    for modes, near in ((16, 0.0), (16, 3.0), (110, 0.0)):
        found = np.array(lw.linearize(model, modes=modes, near=near).eigenvalues)
        distances = np.sort(np.abs(exact.real + 1j * np.abs(exact.imag) - 1j * near))[:modes]
        assert np.sort(np.abs(found - 1j * near)) == pytest.approx(distances, rel=1e-7)


def test_each_of_many_free_rotors_is_a_neutral_motion() -> None:
    model = lw.Model()
    for k in range(60):
        at = (k, 0, -0.5 - 0.01 * k)
        model.body(f"arm {k}", mass=1.0, inertia=(0.01, 0.02, 0.02), position=at)
        model.spherical("ground", f"arm {k}", at=(k, 0, 0))
        model.linear_damping("ground", f"arm {k}", at=at, damping=0.1, rotational_damping=0.05)
        model.body(f"rotor {k}", mass=0.5, inertia=(0.01, 0.01, 0.02), position=at, omega=(0, 0, 40.0))
        model.revolute(f"arm {k}", f"rotor {k}", at=at, axis=(0, 0, 1))
    assert np.abs(lw.linearize(model, modes=40).eigenvalues).max() < 1e-6
