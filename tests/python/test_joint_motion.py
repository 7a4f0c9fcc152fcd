"""By how much the points of joints are apart, and their axes askew."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.modeling.elements import KINDS
from linkwork.motion.violations import Holds, gaps, told, violations
from linkwork.view.run import Choice, joint_violations


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
    apart, askew = joint_violations(result, Choice.of(result, 1e6))
    np.testing.assert_allclose(apart, 1e-3, rtol=1e-9)
    np.testing.assert_array_equal(askew, 0)


#: Arguments of each placement, in the two bodies: axes along z, or along z and x.
PLACES = {
    "axis": {"at": ((0, 0, 0), (0, 0, 0)), "axis": ((0, 0, 1), (0, 0, 1))},
    "direction": {"axis": ((0, 0, 1), (0, 0, 1))},
    "frame": {"at": ((0, 0, 0), (0, 0, 0)), "orientation": ((1, 0, 0, 0), (1, 0, 0, 0))},
    "orientation": {"orientation": ((1, 0, 0, 0), (1, 0, 0, 0))},
    "centers": {"at": ((0, 0, 0), (0.3, 0, 0)), "axis": ((0, 0, 1), (0, 0, 1))},
    "shafts": {"at": ((0, 0, 0), (0, 0, 0)), "axes": ((0, 0, 1), (0, 0, 1))},
    "two_axes": {"at": ((0, 0, 0), (0, 0, 0)), "axes": ((0, 0, 1), (1, 0, 0))},
    "two_directions": {"axes": ((0, 0, 1), (1, 0, 0))},
}


@pytest.mark.parametrize("kind", [
    kind for kind, info in KINDS["joint"].items()
    if any(it.perpendicular for it in info.equations.values())
])  # fmt: skip
def test_axes_askew_are_what_the_equations_of_rotations_measure(kind: str) -> None:
    """A body turned by 1e-3 rad about a random axis: the sines of the angles are the rows of Phi."""
    info = KINDS["joint"][kind]
    axis = np.random.default_rng(3).normal(size=3)
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1, inertia=(1, 1, 1))
    numbers = {name: it.example for name, it in info.parameters.items() if not it.initial_distance}
    getattr(model, kind)("ground", body, **PLACES[info.placement], **numbers, frames="body")
    model = model.with_initial_state(
        np.concatenate([np.zeros(3), lw.rotation.about(axis, 1e-3)]), np.zeros(6)
    )
    with pytest.warns(lw.LinkworkWarning):
        result = lw.simulate(model, t_end=1e-3, step=1e-3, stabilization="none", assemble=False)
    _, askew = violations(result, np.arange(1))
    core = model.compiled()
    rows = [it.quantity == "rotation" for it in info.equations.values()]
    phi = lw.System(model).compiled().evaluate(0.0, core.q0, core.v0)["Phi"][rows]
    assert askew[0, 0] > 1e-4
    assert askew[0, 0] == pytest.approx(np.linalg.norm(phi), rel=1e-3)


#: Equations of points alone: threads, rolling and drivers also hold angles, or prescribe motion.
OF_POINTS = ("translation", "distance")


@pytest.mark.parametrize("kind", [
    kind for kind, info in KINDS["joint"].items()
    if info.placement in {**PLACES, "point": 0, "two_points": 0} and not info.driver
    and any(it.quantity in OF_POINTS for it in info.equations.values())
])  # fmt: skip
def test_points_apart_are_what_the_equations_of_points_measure(kind: str) -> None:
    """A body moved by some mm and turned by 1e-3 rad: their rows of Phi are lengths along axes."""
    info = KINDS["joint"][kind]
    places = {
        **PLACES,
        "point": {"at": ((0, 0, 0), (0, 0, 0))},
        "two_points": {"at": ((0, 0, 0), (0.3, 0, 0))},
    }
    axis, shift = np.random.default_rng(3).normal(size=(2, 3))
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1, inertia=(1, 1, 1))
    numbers = {name: it.example for name, it in info.parameters.items() if not it.initial_distance}
    lengths = {name: 0.299 for name, it in info.parameters.items() if it.initial_distance}
    getattr(model, kind)("ground", body, **places[info.placement], **numbers, **lengths, frames="body")
    start = np.concatenate([4e-3 * shift, lw.rotation.about(axis, 1e-3)])
    model = model.with_initial_state(start, np.zeros(6))
    with pytest.warns(lw.LinkworkWarning):
        result = lw.simulate(model, t_end=1e-3, step=1e-3, stabilization="none", assemble=False)
    apart, _ = violations(result, np.arange(1))
    rows = [
        it.quantity in OF_POINTS and name != "translation along the thread"
        for name, it in info.equations.items()
    ]
    core = model.compiled()
    phi = lw.System(model).compiled().evaluate(0.0, core.q0, core.v0)["Phi"][rows]
    assert apart[0, 0] > 1e-4
    assert apart[0, 0] == pytest.approx(np.linalg.norm(phi), rel=1e-9)
    assert told(result.header) == [True]


@pytest.mark.parametrize(
    "kind", [kind for kind, info in KINDS["joint"].items() if "length" in info.parameters]
)
def test_of_lengths_that_change_nothing_is_told(kind: str) -> None:
    """No zero that would say that the joint is not violated."""
    places = {**PLACES, "two_points": {"at": ((0, 0, 0), (0.3, 0, 0))}}
    for length, known in ((0.3, True), (lw.functions.polynomial(0.3, 0.0, 1.0), False)):
        model = lw.Model(gravity=(0, 0, 0))
        body = model.body("body", mass=1, inertia=(1, 1, 1))
        place = places[KINDS["joint"][kind].placement]
        getattr(model, kind)("ground", body, **place, length=length, frames="body")
        result = lw.simulate(model, t_end=1e-2, step=1e-3)
        assert told(result.header) == [known]


def test_distance_held_is_compared_with_its_length() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1, inertia=(1, 1, 1))
    model.distance("ground", body, at=((0, 0, 0), (0.3, 0, 0.4)), length=0.49, frames="body")
    with pytest.warns(lw.LinkworkWarning):
        result = lw.simulate(model, t_end=1e-3, step=1e-3, stabilization="none", assemble=False)
    apart, askew = violations(result, np.arange(1))
    assert apart[0, 0] == pytest.approx(0.01, rel=1e-9)
    assert not askew.any()
