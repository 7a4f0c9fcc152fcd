"""Coordinates of joints against closed forms and finite differences; gaps of joints."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.joint_motion import Holds, coordinate, gaps
from linkwork.view.run import Choice, joint_gaps


def test_angle_of_a_driven_turn_over_full_turns() -> None:
    """A wheel without load keeps its speed: angle = w t, beyond pi."""
    model = lw.Model(gravity=(0, 0, 0))
    wheel = model.body("wheel", mass=1, inertia=(1, 1, 2), omega=(0, 0, 7.0))
    model.revolute(model.ground, wheel, at=(0, 0, 0), axis=(0, 0, 1))
    result = lw.simulate(model, t_end=2.0, step=1e-2)
    angle, rate = coordinate(result, 0, "angle")
    np.testing.assert_allclose(angle, 7 * result.t, atol=1e-6)
    np.testing.assert_allclose(rate, 7.0, atol=1e-8)


def test_displacement_of_a_fall_along_a_slope() -> None:
    """s = g sin(a) t^2 / 2 along a guide that goes down by a = 30 degrees."""
    axis = np.array([np.cos(np.pi / 6), 0, -np.sin(np.pi / 6)])
    model = lw.Model(gravity=(0, 0, -10))
    block = model.body("block", mass=2, inertia=(1, 1, 1), position=(0.3, 0, 0))
    model.translational(model.ground, block, at=(0.3, 0, 0), axis=axis)
    result = lw.simulate(model, t_end=1.0, step=1e-2)
    s, rate = coordinate(result, 0, "displacement")
    np.testing.assert_allclose(s, 2.5 * result.t**2, atol=1e-9)
    np.testing.assert_allclose(rate, 5 * result.t, atol=1e-9)


@pytest.mark.parametrize(("joint", "which"), [("bearing", "angle"), ("guide", "displacement")])
def test_rates_are_the_derivatives_of_coordinates(joint: str, which: str) -> None:
    """On moving bodies: central differences of the coordinate."""
    result = lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=0.5, step=1e-4, record_every=1)
    value, rate = coordinate(result, result.index("joint", joint), which)  # type: ignore[arg-type]
    measured = (value[2:] - value[:-2]) / (result.t[2:] - result.t[:-2])
    assert np.abs(measured - rate[1:-1]).max() < 1e-4 * np.abs(rate).max()


def test_gap_of_a_chain_is_the_distance_of_its_points() -> None:
    result = lw.simulate(lw.mechanisms.chain(bodies=3), t_end=0.1, step=1e-2)
    gap, axes = gaps(result, np.arange(3))
    for joint in range(3):
        a, b = np.moveaxis(result.joint_points(joint), 1, 0)
        np.testing.assert_allclose(gap[:, joint], b - a, atol=1e-14)
        np.testing.assert_allclose(axes[:, joint], result.joint_axes(joint), atol=1e-14)


def test_gap_in_the_page_is_the_violation_and_never_a_prescribed_motion() -> None:
    """A driver holds no points together; a pin whose points were set 1 mm apart is violated by that."""
    assert not any(Holds.of("displacement_driver").translations)
    pinned = lw.Model(gravity=(0, 0, 0))
    body = pinned.body("body", mass=1, inertia=(1, 1, 1))
    pinned.spherical(pinned.ground, body, at=((0, 0, 0), (1e-3, 0, 0)), frames="body")
    with pytest.warns(lw.LinkworkWarning):
        result = lw.simulate(pinned, t_end=1e-3, step=1e-3, stabilization="none", assemble=False)
    apart = joint_gaps(result, Choice.of(result, 1e6))
    np.testing.assert_allclose(apart, 1e-3, rtol=1e-9)
