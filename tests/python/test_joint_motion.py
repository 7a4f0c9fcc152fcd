"""By how much the points of joints are apart."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.joint_motion import Holds, gaps
from linkwork.view.run import Choice, joint_gaps


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
