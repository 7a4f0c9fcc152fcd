"""The suspension: its equilibrium, and where the upright goes as the wishbones swing."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from linkwork.mechanisms.double_wishbone import (
    LOWER_BALL,
    TIE_INNER,
    TIE_OUTER,
    UPPER_BACK,
    UPPER_BALL,
    UPPER_FRONT,
    WHEEL_CENTER,
)
from test_linkages import point_of


def turned(point: Floats, origin: Floats, axis: Floats, target: Floats, distance: float) -> Floats:
    """The point, turned the least about an axis so that it is so far from the target.

    |o + a + b cos(t) + c sin(t) - target|^2 = d^2 with a along the axis: B cos(t) + C sin(t) = E.
    """
    z = axis / np.linalg.norm(axis)
    a = z * (z @ (point - origin))
    b = point - origin - a
    c = np.cross(z, b)
    to = origin + a - target
    B, C, E = 2 * to @ b, 2 * to @ c, distance**2 - to @ to - b @ b
    angles = np.arctan2(C, B) + np.array([1, -1]) * np.arccos(E / np.hypot(B, C))
    angle = min(np.angle(np.exp(1j * angles)), key=abs)
    result: Floats = origin + a + b * np.cos(angle) + c * np.sin(angle)
    return result


def upright(lower_ball: Floats) -> tuple[Floats, Floats]:
    """Upper ball and outer end of the tie rod, in the axes of the chassis, from the lower ball."""
    length = np.linalg.norm
    upper_ball = turned(
        UPPER_BALL, UPPER_FRONT, UPPER_FRONT - UPPER_BACK, lower_ball, float(length(UPPER_BALL - LOWER_BALL))
    )
    # The end of the tie rod keeps its place against the line of the balls; where around it, the rod says.
    old, new = UPPER_BALL - LOWER_BALL, upper_ball - lower_ball
    along = old / length(old)
    carried = lower_ball + lw.rotation.between(along, new / length(new)) @ (TIE_OUTER - LOWER_BALL)
    return upper_ball, turned(carried, lower_ball, new, TIE_INNER, float(length(TIE_OUTER - TIE_INNER)))


def test_a_suspension_stands_still_in_equilibrium() -> None:
    model = lw.mechanisms.double_wishbone(amplitude=0.0)
    result = lw.simulate(model, t_end=1.0, step=1e-3, progress=False)
    assert np.abs(result.q - result.q[0]).max() < 1e-11


def test_the_upright_goes_where_circles_and_spheres_meet() -> None:
    """From the lower ball on its circle: the upper ball, then the tie rod, while the wheel travels 5 cm."""
    model = lw.mechanisms.double_wishbone(amplitude=0.03, rate=9.0)
    result = lw.simulate(model, t_end=2.0, step=1e-3, progress=False)
    heave = result.body("chassis").position - result.body("chassis").position[0]
    lower, upper, tie, center = (
        point_of(model, result, "upright", point) - heave
        for point in (LOWER_BALL, UPPER_BALL, TIE_OUTER, WHEEL_CENTER)
    )
    for k in range(0, len(result), 10):
        expected_upper, expected_tie = upright(lower[k])
        assert np.abs(upper[k] - expected_upper).max() < 1e-9
        assert np.abs(tie[k] - expected_tie).max() < 1e-9
    assert np.ptp(center[:, 2]) > 0.05


def test_a_slow_post_lifts_the_car_as_it_is() -> None:
    """At 0.5 rad/s all goes up by what the post does, but for the inertia: 1/1000."""
    result = lw.simulate(lw.mechanisms.double_wishbone(rate=0.5), t_end=3.0, step=1e-3, progress=False)
    wanted = 0.02 * (1 - np.cos(0.5 * result.t))
    for name in ("chassis", "wheel", "upright"):
        height = result.body(name).position[:, 2]
        assert height - height[0] == pytest.approx(wanted, abs=3e-4)
