"""Laws of the user's own along a coordinate of a joint, against force elements and closed forms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.errors import ModelError

INERTIA = (0.02, 0.03, 0.05)
AXIS = (0.3, 0.2, 1.0)
K, C = 3.0, 0.2


def two_bodies(joint: str, **place: Any) -> lw.Model:
    """Free in space, so that what acts on both is seen on both."""
    model = lw.Model(gravity=(0.0, 0.0, -9.81))
    model.body("a", mass=2.0, inertia=(0.2, 0.3, 0.4), position=(0, 0, 0), omega=(0.3, 0.1, -0.2))
    model.body("b", mass=1.0, inertia=INERTIA, position=(0.4, 0.1, 0.2), omega=(0.1, -0.3, 1.2))
    getattr(model, joint)("a", "b", name="joint", **place)
    return lw.assemble(model).model


def law(t: float, x: float, rate: float) -> float:
    return -K * x - C * rate


@pytest.mark.parametrize("kind", ["angle", "displacement"])
def test_a_linear_law_is_the_force_element_that_says_the_same(kind: str) -> None:
    joint = "revolute" if kind == "angle" else "translational"
    place = {"at": (0.1, 0.05, 0.1), "axis": AXIS}

    def run(add: Callable[[lw.Model], Any]) -> lw.Result:
        model = two_bodies(joint, **place)
        add(model)
        return lw.simulate(model, t_end=1.0, step=1e-3)

    ours = run(lambda model: model.joint_force("joint", law))
    if kind == "angle":

        def spring(model: lw.Model) -> None:
            place = held(model)
            model.rotational_spring_damper("a", "b", stiffness=K, damping=C, frames="body", **place)

        element = run(spring)
        assert np.abs(ours.q - element.q).max() < 1e-9
    momentum = ours.v[:, :, 2] @ np.array([2.0, 1.0])  # only gravity acts from outside
    assert np.abs(momentum - momentum[0] + 3.0 * 9.81 * ours.t).max() < 1e-9
    assert np.ptp(ours.coordinate("joint").value) > 1e-3
    assert np.ptp(ours.energy - ours.work) < 1e-7  # the work that is counted is what the mechanism loses


def held(model: lw.Model) -> dict[str, Any]:
    """The place of the joint in both bodies."""
    arrays = model.compiled().joint_arrays()
    frames = arrays["frame"][0]
    return {
        "at": tuple(arrays["origin"][0]),
        "axis": (frames[0][:, 2], frames[1][:, 2]),
        "x_axis": (frames[0][:, 0], frames[1][:, 0]),
    }


def test_a_spring_in_a_slide_swings_with_the_closed_form() -> None:
    """m x_ddot = -k x - c x_dot + m g along the slide."""
    model = lw.Model()
    axis = np.array([0.6, 0.0, -0.8])
    model.body("b", mass=2.0, inertia=INERTIA)
    model.translational("ground", "b", at=(0, 0, 0), axis=axis, name="slide")
    model.joint_force("slide", lambda t, x, rate: -50.0 * x)
    result = lw.simulate(model, t_end=2.0, step=1e-3)
    rest, omega = 2.0 * 9.81 * 0.8 / 50.0, 5.0
    exact = rest * (1 - np.cos(omega * result.t))
    assert np.abs(result.coordinate("slide").value - exact).max() < 1e-9


@pytest.mark.parametrize("which", ["angle_a", "angle_b"])
def test_a_torque_about_one_axis_of_a_cross_does_its_work_there_only(which: str) -> None:
    """Power is Q x_dot, for both axes moving."""
    model = two_bodies("universal", at=(0.1, 0.05, 0.1), axes=((1, 0, 0), (0, 1, 0)))
    model.joint_force("joint", lambda t, x, rate: 0.3 * np.cos(x), coordinate=which)
    result = lw.simulate(model, t_end=1.0, step=1e-3, record_every=1)
    found = result.coordinate("joint", which)
    power = 0.3 * np.cos(found.value) * found.rate
    work = np.concatenate([[0.0], np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(result.t))])
    assert np.ptp(found.value) > 0.1
    assert np.abs(result.work - result.work[0] - work).max() < 1e-5 * np.abs(work).max()
    assert np.ptp(result.energy - result.work) < 1e-7


@pytest.mark.parametrize(
    "joint, function, message",
    [
        ("nix", law, "joint_force: no joint named 'nix'"),
        ("joint", "law", "joint force 'f': 'law' is not a function"),
        ("joint", lambda t, x, rate: (1.0, 2.0), "joint force 'f': returned shape (2,), not a number"),
        ("joint", lambda t, x, rate: "much", "joint force 'f': returned 'much', not a number"),
    ],
)
def test_a_mistake_is_named(joint: str, function: Any, message: str) -> None:
    model = two_bodies("revolute", at=(0.1, 0.05, 0.1), axis=AXIS)
    with pytest.raises(ModelError) as found:
        model.joint_force(joint, function, name="f")
        lw.simulate(model, t_end=0.1, step=1e-2)
    assert message in str(found.value)
