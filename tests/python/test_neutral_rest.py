"""Springs that take away just the weight: no stiffness is left, wherever the mechanism is."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest

G = 9.81


def column(part: float, mass: float = 1.0, height: float = 1.0, turn: float = 0.0) -> lw.Model:
    """Upright, with that part of the stiffness m g h at which it buckles."""
    model = lw.Model(gravity=(0, 0, -G), name="column")
    axis = (np.sin(turn), np.cos(turn), 0.0)
    model.body("mass", mass=mass, inertia=(0.01, 0.01, 0.01), position=(0, 0, height))
    model.revolute(model.ground, "mass", at=(0, 0, 0), axis=axis)
    model.rotational_spring_damper(model.ground, "mass", axis=axis, stiffness=part * mass * G * height)
    return model


@pytest.mark.parametrize(
    ("mass", "height", "turn"), [(1.0, 1.0, 0.0), *np.random.default_rng(0).uniform(0.3, 2.0, (4, 3))]
)
def test_a_column_under_its_critical_weight_is_neutral(mass: float, height: float, turn: float) -> None:
    model = column(1.0, mass, height, turn)
    assert lw.equilibrium(model).stability == "neutral"
    vibration = lw.linearize(model)
    assert vibration.stable and vibration.frequencies == pytest.approx([0.0], abs=0)


def test_a_column_near_its_critical_weight_stands_or_leans() -> None:
    stands, leans = (lw.equilibrium(column(part)) for part in (1 + 1e-6, 1 - 1e-6))
    assert stands.stability == leans.stability == "stable"
    assert stands.turned == pytest.approx([0.0], abs=1e-12)
    assert leans.turned == pytest.approx([np.sqrt(6e-6)], rel=1e-3)  # sin(a) / a = 1 - 1e-6


@pytest.mark.parametrize("away", [0.0, 1.0, 100.0])
def test_a_balanced_arm_is_neutral_in_every_pose_however_far_from_the_origin(away: float) -> None:
    mass, arm, spring, high = 3.7, 0.43, 0.31, 0.27
    origin = np.array([away, 0.0, 0.0])
    for angle in np.random.default_rng(0).uniform(-3, 3, 10):
        model = lw.Model(gravity=(0, 0, -G), name="lamp")
        u = np.array([np.cos(angle), 0.0, np.sin(angle)])
        axes = lw.rotation.from_axes(u, (0, 1, 0))
        model.body("arm", mass=mass, inertia=(0.01, 0.05, 0.05), position=origin + arm * u, orientation=axes)
        model.revolute(model.ground, "arm", at=origin, axis=(0, 1, 0))
        at = (origin + np.array([0, 0, high]), origin + spring * u)
        stiffness = mass * G * arm / (spring * high)
        model.spring_damper(model.ground, "arm", at=at, stiffness=stiffness, free_length=0.0)
        assert lw.equilibrium(model).stability == "neutral"
        vibration = lw.linearize(model)
        assert vibration.stable and vibration.frequencies == pytest.approx([0.0], abs=0)
