"""Joints that are driven, by every function of time: Phi_t, Phi_dot and gamma against differences in time.

Along a uniform motion, v_dot = 0, so that Phi_ddot = D v_dot - gamma = -gamma.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import functions
from linkwork.arrays import Floats
from linkwork.functions import TimeFunction, as_time_function
from random_mechanisms import JOINTS, Mechanism, examples, make
from test_invariance import quaternion_product

#: Positive between 0 and 1 s, as lengths have to be.
DRIVES: dict[str, TimeFunction] = {
    "polynomial": functions.polynomial(1.1, 0.4, -0.7, 0.3),
    "harmonic": functions.harmonic(0.3, 4.0, 0.4, 1.2),
    "cycloidal": functions.Sum((functions.constant(0.5), functions.cycloidal(0.6, 0.9, start=0.05))),
    "table": functions.table(np.linspace(-1.03, 2.01, 9), 1 + 0.3 * np.sin(np.linspace(-3, 6, 9))),
    "integral of a table": functions.Sum((
        functions.constant(0.8), functions.table([0, 0.4, 0.9, 2], [0.1, 0.5, 0.2, 0.3]).integral(),
    )),
    "expression": functions.expression("1 + 0.3 * sin(2*pi*t)**2 - t / (4 + t**2)"),
    "python": as_time_function(
        (lambda t: 1 + math.exp(-t), lambda t: -math.exp(-t), lambda t: math.exp(-t)), "drive"
    ),
}  # fmt: skip

DRIVEN = sorted(
    name
    for name, kind in JOINTS.items()
    if any(it.takes == "differentiable" for it in kind.parameters.values())
)


def moved_on(q: Floats, v: Floats, h: float) -> Floats:
    """q (7n,) after a uniform motion over h [s], exactly."""
    pose, rate = q.reshape(-1, 7).copy(), v.reshape(-1, 6)
    pose[:, :3] += h * rate[:, :3]
    for body, omega in zip(pose, rate[:, 3:], strict=True):
        angle = h * float(np.linalg.norm(omega))
        body[3:] = quaternion_product(body[3:], lw.rotation.about(omega, angle))
    return pose.ravel()


@pytest.mark.parametrize("drive", DRIVES)
@pytest.mark.parametrize("kind", DRIVEN)
@examples(4)
@given(seed=st.integers(0, 2**32 - 1), t=st.floats(0.1, 0.9))
def test_time_derivatives_of_a_driven_joint_are_those_of_differences(
    kind: str, drive: str, seed: int, t: float
) -> None:
    mechanism = make(seed, joints=["revolute", kind])
    driven = replace(mechanism.joints[1], parameters=(DRIVES[drive],))
    mechanism = replace(mechanism, joints=(mechanism.joints[0], driven))
    rng = np.random.default_rng(seed)
    v = rng.uniform(-1, 1, len(mechanism.v))
    q = moved_on(mechanism.q, rng.uniform(-1, 1, len(v)), 0.1)
    check(mechanism, t, q, v)


def check(mechanism: Mechanism, t: float, q: Floats, v: Floats) -> None:
    dynamics = mechanism.dynamics(formulation="penalty")
    at = dynamics.evaluate(t, q, v)
    Phi_t = slope(lambda h: dynamics.evaluate(t + h, q, v)["Phi"])
    Phi_dot, Phi_ddot = (
        slope(lambda h, what=what: dynamics.evaluate(t + h, moved_on(q, v, h), v)[what])
        for what in ("Phi", "Phi_dot")
    )
    for found, expected in ((at["Phi_t"], Phi_t), (at["Phi_dot"], Phi_dot), (-at["gamma"], Phi_ddot)):
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-6)


def slope(f: Callable[[float], Floats], h: float = 5e-4) -> Floats:
    """The derivative at 0 by differences of fourth order."""
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)


@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian"])
@pytest.mark.parametrize("length", [1.0, 0.01, 1e-4])
def test_a_driver_that_begins_at_rest_has_next_to_no_acceleration_then(
    length: float, formulation: str
) -> None:
    """Just behind its start that is 1e-320, of which no digits are known."""
    model = lw.Model(gravity=(0, 0, 0))
    inertia = (0.1 * length**2,) * 3
    rod = model.body("rod", mass=1.0, inertia=inertia, position=(0.5 * length, 0, 0))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0))
    turn = lw.functions.cycloidal(1e-4, start=0.0, duration=0.45)
    model.angle_driver("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), angle=turn)
    run = lw.simulate(model, 0.5, 1e-3, formulation=formulation)
    assert 2 * np.arcsin(run.q[-1, 0, 5]) == pytest.approx(1e-4, abs=1e-10)
