"""The rotating mechanisms against their theory: gyroscope, planetary gear, rolling disc."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms import MECHANISMS
from linkwork.mechanisms.gyroscope import precession
from linkwork.mechanisms.planetary_gear import MODULE, PLANET, RING, SUN

# --- gyroscope ----------------------------------------------------------------------------------------------


def axis_of(result: lw.Result, body: str) -> np.ndarray:
    """The z axis of a body (k, 3)."""
    A: np.ndarray = lw.rotation.matrix(result.body(body).orientation)
    return A[:, :, 2]


@pytest.mark.parametrize(("spin", "tilt"), ((100.0, 1.0), (60.0, 2.2), (150.0, np.pi / 2)))
def test_a_gyroscope_precesses_regularly(spin: float, tilt: float) -> None:
    result = lw.simulate(lw.mechanisms.gyroscope(spin, tilt), t_end=2.0, step=1e-4, progress=False)
    axis, angle = axis_of(result, "rotor"), precession(spin, tilt) * result.t
    steady = np.sin(tilt) * np.stack([np.sin(angle), -np.cos(angle)], axis=1)
    assert np.abs(axis[:, 2] - np.cos(tilt)).max() < 1e-9
    assert np.abs(axis[:, :2] - steady).max() < 1e-8
    assert angle[-1] > 0.7


def test_a_level_gyroscope_precesses_as_the_torque_says() -> None:
    """W = m g l / (C w): the weight of 0.2 kg at 12 cm, the disk of 1.5 kg and 7.5 cm."""
    assert precession(200.0, np.pi / 2) == pytest.approx(
        0.2 * 9.81 * 0.12 / (0.5 * 1.5 * 0.075**2 * 200), rel=1e-14
    )


def test_a_gyroscope_that_is_held_back_nods() -> None:
    """Without the rate of precession at the start it dips, and what it gains is the rate: energy is kept."""
    model = lw.mechanisms.gyroscope()
    q, v = model.compiled().q0.reshape(-1, 7), np.zeros((3, 6))
    v[2, 5] = 100.0
    result = lw.simulate(model.with_initial_state(q, v), t_end=1.0, step=1e-4, progress=False)
    height = axis_of(result, "rotor")[:, 2]
    assert height.max() - height[0] < 1e-10
    assert height[0] - height.min() > 1e-3
    assert np.abs(result.energy_error).max() < 1e-10


# --- planetary gear -----------------------------------------------------------------------------------------


def test_a_planetary_gear_speeds_up_as_its_two_inertias_say() -> None:
    """T(w_carrier, w_sun) with the speeds of Willis: M w_dot = the torques on the carrier and the sun."""
    torques = {"engine": 80.0, "generator": -15.0, "road": 30.0}
    model = lw.mechanisms.planetary_gear(3, **torques)
    result = lw.simulate(model, **{**MECHANISMS["planetary_gear"].settings, "t_end": 0.4}, progress=False)

    core = model.compiled()
    axial = {
        name: core.inertia[model.find(name).index, 2, 2] for name in ("sun", "carrier", "ring", "planet 1")
    }
    arm = MODULE * (SUN + PLANET) / 2
    speeds = {  # over (w_carrier, w_sun)
        "sun": np.array([0.0, 1.0]),
        "carrier": np.array([1.0, 0.0]),
        "ring": np.array([1 + SUN / RING, -SUN / RING]),
        "planet 1": np.array([1 + SUN / PLANET, -SUN / PLANET]),
    }
    axial = {name: core.inertia[model.find(name).index, 2, 2] for name in speeds}
    count = {"planet 1": 3}
    M = sum(count.get(name, 1) * axial[name] * np.outer(w, w) for name, w in speeds.items())
    M[0, 0] += 3 * core.mass[model.find("planet 1").index] * arm**2
    torque = np.array([torques["engine"], torques["generator"]]) - torques["road"] * speeds["ring"]
    rate = np.linalg.solve(M, torque)
    for name, w in speeds.items():
        omega = result.body(name).omega[:, 2]
        assert np.abs(omega - omega[0] - w @ rate * result.t).max() < 1e-6


def test_the_wheels_of_a_planetary_gear_turn_as_willis_says() -> None:
    result = lw.simulate(lw.mechanisms.planetary_gear(), t_end=0.2, step=1e-4, progress=False)
    sun, carrier, ring = (result.body(name).omega[:, 2] for name in ("sun", "carrier", "ring"))
    assert np.abs((ring - carrier) * RING + (sun - carrier) * SUN).max() < 1e-6 * RING * sun.max()
    assert np.ptp(sun) > 1.0


# --- rolling disc -------------------------------------------------------------------------------------------


def test_a_rolling_disc_keeps_its_energy_for_ten_seconds() -> None:
    """And its point of contact stays at rest on the table, while the disc nods and wanders."""
    result = lw.simulate(lw.mechanisms.rolling_disc(), **MECHANISMS["rolling_disc"].settings, progress=False)
    axis, disc = axis_of(result, "disc"), result.body("disc")
    upward = np.array([0, 0, 1.0]) - axis[:, 2:] * axis
    arm = 0.0375 * upward / np.linalg.norm(upward, axis=1, keepdims=True)
    slip = disc.velocity - np.cross(disc.omega_inertial, arm)
    assert np.abs(result.energy_error).max() < 1e-12
    assert np.abs(slip).max() < 1e-10
    assert np.abs(disc.position[:, 2] - arm[:, 2]).max() < 1e-12
    assert np.ptp(axis[:, 2]) > 0.05
    assert np.linalg.norm(disc.position[:, :2] - disc.position[0, :2], axis=1).max() > 0.1
