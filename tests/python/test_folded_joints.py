"""Joints of constant velocity that fold through 180 degrees: a run that goes on along another says so."""

from __future__ import annotations

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest

MASS, ARM, GRAVITY = 1.0, 0.3, 9.81


def bent(angle: float, direction: float, rates: tuple[float, float]) -> lw.Model:
    """A body on the ground, bent by twice the angle a [rad] about an axis across the shaft, without a twist:
    p = (cos a, sin a cos b, sin a sin b, 0)."""

    def p(a: float, b: float) -> np.ndarray[Any, Any]:
        return np.array([np.cos(a), np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), 0.0])

    here = p(angle, direction)
    h = 1e-6
    ahead, behind = (p(angle + k * h * rates[0], direction + k * h * rates[1]) for k in (1, -1))
    p_dot = (ahead - behind) / (2 * h)
    omega = 2 * np.array([
        [-here[1], here[0], here[3], -here[2]], [-here[2], -here[3], here[0], here[1]],
        [-here[3], here[2], -here[1], here[0]],
    ]) @ p_dot  # fmt: skip
    A = lw.rotation.matrix(here)
    model = lw.Model(gravity=(0, 0, -GRAVITY))
    body = model.body("body", mass=MASS, inertia=(0.03, 0.034, 0.004), position=A @ (0, 0, ARM),
                      orientation=here, omega=omega, velocity=A @ np.cross(omega, (0, 0, ARM)))  # fmt: skip
    model.constant_velocity("ground", body, at=((0, 0, 0), (0, 0, -ARM)), axes=((0, 0, 1), (0, 0, 1)),
                            frames="body", name="joint")  # fmt: skip
    return model


FOLDS = 0.6708783400346652, 4.332988848852705, (-0.9596447598081417, -2.5029297639839543)


@pytest.mark.parametrize("method", [{"rtol": 1e-8, "integrator": "dop853"}, {"rtol": 1e-8}, {"rtol": 1e-6},
                                    {"step": 1e-3}, {"step": 1e-3, "integrator": "hem4"}])  # fmt: skip
def test_a_run_in_which_a_joint_of_constant_velocity_twists_is_warned_of(method: Any) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = lw.simulate(bent(*FOLDS), t_end=1.0, progress=False, on_inaccurate="pass", **method)
    twist = np.abs(result.q[:, 0, 6]).max()
    told = [str(it.message) for it in caught if "folded through 180 degrees" in str(it.message)]
    assert len(told) == (twist > 1e-2)
    assert all(it.startswith("'joint'") for it in told)


def test_a_joint_that_stays_below_is_not_warned_of() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = lw.simulate(bent(0.3, 0.4, (0.5, 0.6)), t_end=0.3, rtol=1e-8, progress=False)
    assert np.abs(result.q[:, 0, 6]).max() < 1e-8
