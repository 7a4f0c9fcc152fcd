"""Joints and force elements that are placed anew in part: what is not said stays as it was."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from generic_elements import P, Q, added, arguments, bodies
from linkwork import _core

KINDS = {kind.name: kind for kind in (*_core.joint_kinds(), *_core.force_kinds())}

#: Another value of an argument; some are pairs in one placement and single in another.
ANOTHER = {
    "at": (0.7, 0.1, -0.4), "axis": (2.0, 1.0, 2.0), "x_axis": (-2.0, 0.5, 0.5), "normal": (0.0, 1.0, 2.0),
    "axes": ((0.0, 3.0, 4.0), (0.0, 4.0, -3.0)), "orientation": lw.rotation.about((3, 1, 1), -0.7),
    "frame": "inertial",
}  # fmt: skip


def built(kind: _core.KindInfo, **changes: Any) -> lw.Model:
    model = bodies()
    added(model, kind, "it", **{**arguments(kind), **changes})
    return model


def another(kind: _core.KindInfo, what: str, value: Any) -> Any:
    if what == "at" and np.ndim(value) == 2:
        return ((0.7, 0.1, -0.4), (1.6, 0.9, 0.2))
    if what == "axes" and kind.placement == "shafts":
        return ((0.0, 3.0, 4.0), (0.5, 3.0, 4.0))
    return ANOTHER.get(what, value)


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
def test_an_argument_replaced_by_its_own_value_changes_nothing(kind: _core.KindInfo) -> None:
    """Not a bit, whatever else was given."""
    model = built(kind)
    for what, value in arguments(kind).items():
        assert model.replaced("it", **{what: value}).hash() == model.hash(), what


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
def test_with_one_argument_replaced_it_is_where_it_would_be_built(kind: _core.KindInfo) -> None:
    """Points and axes of both bodies, to rounding: what had been given stays."""
    model = built(kind)
    for what, value in arguments(kind).items():
        if what in kind.parameters or (kind.placement == "centers" and what == "axis"):
            continue
        new = another(kind, what, value)
        found, wanted = (
            model.replaced("it", **{what: new}).values("it"),
            built(kind, **{what: new}).values("it"),
        )
        for part in ("origin", "frame"):
            here, there = (np.array(it["attachment"].pop(part)) for it in (found, wanted))
            assert np.allclose(here, there, rtol=0, atol=4e-15), (what, part)
        assert found == wanted


def test_a_weld_that_is_moved_keeps_the_axes_of_its_reaction() -> None:
    """In joint axes the weight is C^T (0, 0, m g), C the orientation that was given."""
    p = lw.rotation.about((1, 2, 3), 1.0)
    model = lw.Model()
    model.body("b", mass=2.0, inertia=(1, 1, 1), position=(1, 0, 0))
    model.fixed("ground", "b", at=(0, 0, 0), orientation=p, name="weld")
    result = lw.simulate(model.replaced("weld", at=(0.1, 0, 0)), 0.01, 0.01, progress=False)
    weight = lw.rotation.matrix(p).T @ (0, 0, 2.0 * 9.81)
    assert np.allclose(result.reaction("weld", frame="joint").force[0], weight, rtol=1e-12, atol=1e-12)


def test_a_hinge_keeps_its_angle_about_another_point_and_axis() -> None:
    """It was assembled at half a radian, which a new point, or a new length of its axis, does not change."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=1.0, inertia=(1, 1, 1), orientation=lw.rotation.about((0, 0, 1), 0.5))
    z, x = ((0, 0, 1), (0, 0, 1)), ((1, 0, 0), (1, 0, 0))
    model.revolute("ground", "b", at=((0, 0, 0), (0, 0, 0)), axis=z, x_axis=x, frames="body", name="pin")
    for changes in ({"at": (1, 0, 0)}, {"at": (1, 0.2, 0), "axis": (0, 0, 2)}, {"axis": (0, 0, 1)}):
        moved = model.replaced("pin", **changes)
        result = lw.simulate(moved, 0.01, 0.01, progress=False, on_inaccurate="pass", assemble=False)
        assert result.coordinate("pin").value[0] == pytest.approx(0.5, rel=1e-14)


def test_an_x_axis_that_cannot_stay_is_asked_for() -> None:
    model = built(KINDS["revolute"])
    with pytest.raises(lw.ModelError, match="revolute 'it': x_axis is parallel to the axis"):
        model.replaced("it", axis=arguments(KINDS["revolute"])["x_axis"])
    with pytest.raises(lw.ModelError, match="'axes' is none of its arguments"):
        model.replaced("it", axes=(P, Q))


def test_points_that_went_along_an_axis_are_asked_for_with_another() -> None:
    """A gear has its centers in one plane across the axis, wherever on the axis they were given."""
    with pytest.raises(lw.ModelError, match="gear 'it': at is missing"):
        built(KINDS["gear"]).replaced("it", axis=ANOTHER["axis"])


def test_an_element_on_another_body_stays_where_it_was_in_space() -> None:
    """With what is said of its place, the rest is that of the first."""
    model, wanted = bodies(2), bodies(2)
    kind = KINDS["bushing"]
    added(model, kind, "it", **arguments(kind))
    wanted.bushing("a 0", "b 1", name="it", **{**arguments(kind), "at": Q})
    found, there = (it.values("it") for it in (model.replaced("it", b="b 1", at=Q), wanted))
    for part in ("origin", "frame"):
        assert np.allclose(found["attachment"][part], there["attachment"][part], rtol=0, atol=1e-14)
    assert found["b"] == "b 1"


def test_an_applied_force_is_replaced_in_the_words_of_its_method() -> None:
    """Body, axes of the components and point, each by itself."""
    given = arguments(KINDS["applied"])
    model, wanted = bodies(2), bodies(2)
    model.force("b 0", name="it", **given)
    wanted.force("a 1", name="it", **{**given, "force": (1, 2, 3), "frame": "inertial"})
    assert (
        model.replaced("it", body="a 1").replaced("it", force=(1, 2, 3), frame="inertial").hash()
        == wanted.hash()
    )


def test_axes_of_a_body_that_a_force_turns_with_go_with_it_to_another() -> None:
    model = lw.Model()
    for name in ("first", "second"):
        model.body(name, mass=1.0, inertia=(1, 2, 3), orientation=(0.8, 0.6, 0, 0))
    model.force("first", force=(0, 1, 0), frame="body", name="thrust")
    for change in ({"b": "second"}, {"body": "second"}, {"b": "second", "force": (0, 1, 0)}):
        own = model.replaced("thrust", **change).values("thrust")
        assert own["a"] == own["b"] == "second"


def test_another_stiffness_of_a_bushing_leaves_full_turns_of_others_as_they_are(
    recwarn: pytest.WarningsRecorder,
) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    rod = model.body("rod", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 4 * np.pi))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.rotational_spring_damper("ground", rod, axis=(0, 0, 1), stiffness=1e-9, name="spring")
    model.bushing("ground", rod, at=(0, 0, 0), stiffness=(0, 0, 1), name="bushing")
    end = lw.simulate(model, 1.6, 1e-3).snapshot()
    turned = model.with_initial_state(end.q, end.v, history=end.history)
    for change in ({"stiffness": (0, 0, 2)}, {"stiffness_z": 2.0}):
        other = turned.replaced("bushing", **change)
        assert lw.simulate(other, 1e-3, 1e-3).force("spring").deflection[0] == pytest.approx(6.4 * np.pi)
    assert not recwarn.list


def test_full_turns_begin_anew_between_other_bodies_at_the_same_points_of_these() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    for name in ("first", "second"):
        body = model.body(name, mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 4 * np.pi))
        model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name=f"pin of {name}")
    model.rotational_spring_damper("ground", "first", axis=(0, 0, 1), stiffness=1e-9, name="spring")
    end = lw.simulate(model, 1.6, 1e-3).snapshot()
    turned = model.with_initial_state(end.q, end.v, history=end.history)
    with pytest.warns(lw.LinkworkWarning, match="full turns"):
        other = turned.replaced("spring", b="second", frames="body", at=((0, 0, 0), (0, 0, 0)))
    assert abs(lw.simulate(other, 1e-3, 1e-3).force("spring").deflection[0]) < 2 * np.pi
