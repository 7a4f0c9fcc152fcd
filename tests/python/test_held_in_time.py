"""Stiffness that changes with time is held in a linearization, which is told."""

from __future__ import annotations

import warnings

import linkwork as lw
import numpy as np
import pytest
from linkwork.functions import harmonic


def on_a_spring(**parameters: object) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("block", mass=1.0, inertia=(0.01,) * 3)
    model.translational("ground", body, at=(0, 0, 0), axis=(1, 0, 0), name="slide")
    model.translational_spring_damper("ground", body, at=(0, 0, 0), axis=(1, 0, 0), **parameters)
    return model


def mathieu() -> lw.Model:
    """x'' + (100 + 50 cos 20 t) x = 0 grows, however stable each of these stiffnesses is."""
    return on_a_spring(stiffness=100.0 + harmonic(50.0, 20.0, np.pi / 2))


def by_law() -> lw.Model:
    model = on_a_spring(stiffness=100.0)
    model.joint_force("slide", lambda t, x, v: -50 * np.cos(20 * t) * x)
    return model


@pytest.mark.parametrize("build", [mathieu, by_law])
def test_a_stiffness_that_changes_with_time_is_told_and_held(build: object) -> None:
    with pytest.warns(lw.LinkworkWarning, match=r"stiffness or damping of the model changes with time \(.*1"):
        found = lw.linearize(build())  # type: ignore[operator]
    assert found.frequencies == pytest.approx([np.sqrt(150)], rel=1e-9)


def test_forces_and_drivers_that_change_no_stiffness_are_not_told() -> None:
    model = on_a_spring(stiffness=100.0, damping=0.5)
    model.joint_force("slide", lambda t, x, v: np.sin(3 * t))
    rod = model.body("rod", mass=1.0, inertia=(0.1,) * 3, position=(0, 1, 0))
    model.revolute("ground", rod, at=(0, 1, 0), axis=(0, 0, 1), name="pin")
    model.drive("pin", position=harmonic(0.1, 3.0, np.pi / 2))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert lw.linearize(model).frequencies == pytest.approx([10.0], rel=1e-9)
