"""Models are read in tables, found by name, and changed into other models."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.modeling.coordinates import known_coordinates


@pytest.fixture
def pendulums() -> lw.Model:
    """Two pendulums side by side, a spring between them, a coupler and a shape."""
    model = lw.Model(name="pendulums")
    rods = [
        model.body(
            f"rod {k}", mass=1.0 + k, inertia=(0.1, 0.2, 0.2), position=(0.5, k, 0), shape=lw.Sphere(0.1)
        )
        for k in range(2)
    ]
    pins = [
        model.revolute("ground", rod, at=(0, k, 0), axis=(0, 1, 0), name=f"pin {k}")
        for k, rod in enumerate(rods)
    ]
    model.spring_damper(*rods, at=((1, 0, 0), (1, 1, 0)), stiffness=10.0, name="spring")
    model.coupler([(pins[0], 1.0), (pins[1], -1.0)], name="belt")
    return model


def test_tables_have_what_was_added(pendulums: lw.Model) -> None:
    bodies, joints, forces = (pendulums.table(what) for what in ("bodies", "joints", "forces"))
    assert [row["name"] for row in bodies] == ["rod 0", "rod 1"]
    assert bodies[1]["mass [kg]"] == "2" and bodies[1]["position [m]"] == "(0.5, 1, 0)"
    assert joints[1] == {
        "name": "pin 1", "kind": "revolute", "a": "ground", "b": "rod 1", "at [m]": "(0, 1, 0)",
        "axis": "(0, 1, 0)", "equations": "5",
    }  # fmt: skip
    assert sum(int(row["equations"]) for row in joints) == pendulums.row_count
    assert "stiffness 10" in forces[0]["parameters"]
    assert "rod 0" in repr(bodies) and "<td>pin 0</td>" in pendulums._repr_html_()


def test_axis_of_a_joint_on_a_turned_body_is_inertial() -> None:
    model = lw.Model()
    body = model.body(
        mass=1.0, inertia=(1, 1, 1), position=(1, 0, 0), orientation=lw.rotation.about((0, 0, 1), 1.0)
    )
    other = model.body(mass=1.0, inertia=(1, 1, 1), position=(2, 0, 0))
    model.revolute(body, other, at=(1.5, 0.25, 0), axis=(0, 1, 0))
    assert model.table("joints")[0]["at [m]"] == "(1.5, 0.25, 0)"
    assert model.table("joints")[0]["axis"] == "(0, 1, 0)"


def test_a_replaced_value_is_that_of_a_model_built_with_it(pendulums: lw.Model) -> None:
    """The same bits, and so the same motion."""
    heavier = pendulums.replaced("rod 1", mass=7.0).replaced("spring", stiffness=20.0)
    assert heavier.values("rod 1")["mass"] == 7.0 and heavier.values("spring")["stiffness"] == 20.0
    assert pendulums.values("rod 1")["mass"] == 2.0
    back = heavier.replaced("rod 1", mass=2.0).replaced("spring", stiffness=10.0)
    assert back.hash() == pendulums.hash() != heavier.hash()


def test_a_joint_moves_to_where_it_is_said(pendulums: lw.Model) -> None:
    moved = pendulums.replaced("pin 0", at=(0.2, 0, 0), axis=(0, 1, 0))
    assert moved.table("joints")[0]["at [m]"] == "(0.2, 0, 0)"
    assert moved.table("joints")[1] == pendulums.table("joints")[1]


def test_a_function_takes_the_place_of_a_number(pendulums: lw.Model) -> None:
    driven = pendulums.without("belt").replaced(
        "spring", stiffness=lw.functions.harmonic(1.0, 2.0, offset=5.0)
    )
    wanted = {"amplitude": 1.0, "frequency": 2.0, "phase": 0.0, "offset": 5.0}
    assert driven.values("spring")["stiffness"] == {"harmonic": wanted}


def test_what_is_left_moves_as_if_built_alone(pendulums: lw.Model) -> None:
    alone = lw.Model()
    rod = alone.body("rod 1", mass=2.0, inertia=(0.1, 0.2, 0.2), position=(0.5, 1, 0))
    alone.revolute("ground", rod, at=(0, 1, 0), axis=(0, 1, 0))
    left = pendulums.without("rod 0", attached=True)
    assert (left.body_count, left.joint_count, left.force_count) == (1, 1, 0)
    ours, theirs = (lw.simulate(it, t_end=0.5, step=1e-2, progress=False).q for it in (left, alone))
    assert np.array_equal(ours, theirs)


def test_what_would_hang_on_nothing_is_named(pendulums: lw.Model) -> None:
    with pytest.raises(lw.ModelError, match="'pin 0', 'spring' would hang on nothing") as caught:
        pendulums.without("rod 0")
    assert caught.value.code == "attached"
    with pytest.raises(lw.ModelError, match="'belt' would hang on nothing"):
        pendulums.without("pin 0")
    assert pendulums.without("pin 0", "belt").joint_count == 1


def test_a_new_name_goes_everywhere(pendulums: lw.Model) -> None:
    named = pendulums.replaced("rod 0", name="arm").replaced("pin 1", name="shoulder")
    assert named.table("joints")[0]["b"] == "arm"
    assert named.values("belt")["coordinates"][1]["joint"] == "shoulder"
    assert named.hash() == pendulums.hash()


def test_full_turns_are_kept_where_only_numbers_change_and_told_where_they_are_lost() -> None:
    """A torsion spring wound twice: its torque is that of two turns, or it says that it begins anew."""
    model = lw.Model(gravity=(0, 0, 0))
    wheel = model.body("wheel", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 4 * np.pi))
    model.revolute("ground", wheel, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.rotational_spring_damper("ground", wheel, axis=(0, 0, 1), stiffness=0.0, name="spring")
    turned = lw.simulate(model, 1.0, 1e-2, progress=False)
    wound = model.with_initial_state(turned.q[-1], turned.v[-1], turned.history[-1])
    stiff = wound.replaced("spring", stiffness=3.0)
    torque = lw.simulate(stiff, 1e-3, 1e-3, progress=False).angular_acceleration[0, 0, 2]
    assert torque == pytest.approx(-3.0 * 4 * np.pi, rel=1e-5)
    with pytest.warns(lw.LinkworkWarning, match="begin anew"):
        wound.replaced("pin", at=(0, 0, 0.1), axis=(0, 0, 1))
    assert model.without("pin").joint_count == 0  # without a word: nothing had turned


def test_a_body_that_is_called_like_a_function_is_a_body(pendulums: lw.Model) -> None:
    law = lw.functions.harmonic(1.0, 2.0)
    for body in ("rod 0", "rod 1"):
        pendulums.force(body, force=(law, 0, 0), name=f"push {body}")
    named = pendulums.replaced("rod 0", name="function 1")
    assert named.values("pin 0")["b"] == "function 1"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda model: model.replaced("rod 1", mass=-1.0), "mass"),
        (lambda model: model.replaced("rod 1", color="red"), "color"),
        (lambda model: model.replaced("rod 2", mass=1.0), "nothing is named 'rod 2'; the nearest is 'rod"),
        (lambda model: model.replaced("pin 1", b="rod 9"), "joint 'pin 1': b: no body named 'rod 9'"),
        (lambda model: model.replaced("rod 0", name="rod 1"), "'rod 1' is the name of bodies\\[0\\], too"),
        (lambda model: model.values("nothing"), "nothing is named 'nothing'"),
        (lambda model: model.table("wheels"), "wheels"),
    ],
)
def test_impossible_changes_are_refused(pendulums: lw.Model, change: object, message: str) -> None:
    before = pendulums.hash()
    with pytest.raises(lw.LinkworkError, match=message):
        change(pendulums)  # type: ignore[operator]
    assert pendulums.hash() == before


def own_model() -> lw.Model:
    """With forces of the user's own of every kind, and functions of Python as parameters."""
    model = lw.Model(gravity=(0, 0, -9.81), name="own")
    arm, hand = (
        model.body(name, mass=1.0, inertia=(0.1, 0.2, 0.3), position=(x, 0, 0))
        for name, x in (("arm", 1.0), ("hand", 3.0))
    )
    model.revolute("ground", arm, at=(0, 0, 0), axis=(0, 1, 0), name="h")
    model.revolute(arm, hand, at=(2, 0, 0), axis=(0, 1, 0), name="elbow")
    model.joint_force("h", lambda t, x, rate: -3.0 * x - rate, name="controller", breaks=(0.1,))
    model.joint_force("elbow", lw.functions.harmonic(2.0, 5.0), name="motor")
    model.user_force(lambda t, q, v: -0.2 * v, [hand], name="wind")
    model.user_force(lambda t, q, v: [0, 0, -0.3 * v[2], 0, 0, 0], "arm", name="drag")
    model.force(hand, force=(lambda t: 2.0 * t, 0, 0), name="push")
    model.spring_damper("ground", hand, at=((0, 0, 0), (3, 0, 0)), stiffness=5.0, name="spring",
                        free_length=(lambda t: 3 + t**2, lambda t: 2 * t, lambda t: 2.0))  # fmt: skip
    return model


def bits(model: lw.Model) -> bytes:
    result = lw.simulate(model, 0.2, 1e-3, progress=False, assemble=False, on_inaccurate="pass")
    return bytes(result.q.tobytes() + result.v.tobytes())


def test_functions_of_the_users_own_go_with_a_changed_model() -> None:
    """To the last bit: changed to what it was, the model moves as it did."""
    model = own_model()
    changed = model.replaced("arm", mass=2.0)
    assert bits(changed) != bits(model)
    assert bits(changed.replaced("arm", mass=1.0)) == bits(model)
    assert bits(model.replaced("arm", name="upper")) == bits(model)
    assert bits(model.without("motor").without("drag").without("wind").without("controller")) != bits(model)


def test_an_object_is_read_whatever_else_is_in_the_model() -> None:
    model = own_model()
    assert model.values("arm")["mass"] == 1.0
    assert model.values("push")["force_x"].evaluate(3.0)[0] == 6.0
    assert model.values("controller")["function"](0.0, 1.0, 0.0) == -3.0
    assert model.values("controller")["joint"] == "h"
    assert model.values("drag")["bodies"] == "arm" and model.values("wind")["bodies"] == ["hand"]


def test_a_law_of_the_users_own_is_replaced() -> None:
    model = own_model()
    stiffer = model.replaced("controller", function=lambda t, x, rate: -30.0 * x - rate)
    assert bits(stiffer) != bits(model)
    pushed = model.replaced("push", force_x=lambda t: 0.0)
    assert bits(pushed) == bits(model.replaced("push", force_x=0.0))
    with pytest.raises(lw.ModelError, match="joint_force 'controller': has no field 'law'"):
        model.replaced("controller", law=1.0)


def test_a_force_of_the_users_own_does_not_hang_on_nothing() -> None:
    model = own_model()
    with pytest.raises(lw.ModelError, match="'motor' would hang on nothing"):
        model.without("elbow")
    rest = model.without("hand", attached=True)
    assert [row["name"] for row in rest.table("forces")] == ["controller", "drag"]
    model.user_force(lambda t, q, v: 0 * v, name="field")
    with pytest.raises(lw.ModelError, match="'field' gets all bodies by number"):
        model.without("hand", attached=True)
    assert model.without("hand", "field", attached=True).user_force_count == 2


def test_full_turns_of_a_joint_force_go_with_a_changed_model() -> None:
    """A torsion spring of the user's own, wound twice."""
    model = lw.Model(gravity=(0, 0, 0))
    wheel = model.body("wheel", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 4 * np.pi))
    model.revolute("ground", wheel, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.joint_force("pin", lambda t, x, rate: 0.0, name="spring")
    turned = lw.simulate(model, 1.0, 1e-2, progress=False)
    wound = model.with_initial_state(turned.q[-1], turned.v[-1], turned.history[-1])
    stiff = wound.replaced("wheel", mass=2.0).replaced("spring", function=lambda t, x, rate: -3.0 * x)
    torque = lw.simulate(stiff, 1e-3, 1e-3, progress=False).angular_acceleration[0, 0, 2]
    assert torque == pytest.approx(-3.0 * 4 * np.pi, rel=1e-5)


def test_forces_of_the_users_own_are_counted_and_listed() -> None:
    model = own_model()
    for text in (model.describe(), repr(model)):
        assert "2 joint_force" in text and "2 user_force" in text
    rows = {row["name"]: row for row in model.table("forces")}
    assert rows["controller"]["kind"] == "joint_force" and rows["controller"]["b"] == "arm"
    assert rows["controller"]["parameters"] == "angle of 'h'" and rows["wind"]["parameters"] == "on hand"


def test_a_function_that_several_elements_share_is_one_of_each() -> None:
    """Copies, as in another process, have equal ones in its place."""
    shared = lw.functions.harmonic(1.0, 3.0)
    hashes = []
    for functions in ((shared, shared), (lw.functions.harmonic(1.0, 3.0), lw.functions.harmonic(1.0, 3.0))):
        model = lw.Model()
        model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1))
        model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 0, 1), name="pin")
        model.force("rod", force=(functions[0], 0, 0))
        model.joint_force("pin", functions[1])
        hashes += [model.hash(), model.without().hash()]
    assert len(set(hashes)) == 1


def driven(kind: str, at: tuple[float, ...], axis: tuple[float, ...]) -> lw.Model:
    """A body on a joint of which each coordinate is driven."""
    model = lw.Model()
    model.body("other", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 2, 0))
    model.body("body", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(0.5, 0, 0))
    model.fixed("ground", "other", at=(0, 0, 0))
    getattr(model, kind)("ground", "body", at=at, axis=axis, name="joint")
    for k, which in enumerate(known_coordinates(kind)):
        model.drive("joint", position=lw.functions.polynomial(0, 0, 1 + k), coordinate=which, name=which)
    return model


@pytest.mark.parametrize("kind", ["revolute", "translational", "cylindrical"])
def test_drivers_go_with_their_joint(kind: str) -> None:
    """A driven coordinate is what `Result.coordinate` gives, wherever the joint is moved."""
    model, wanted = driven(kind, (0, 0, 0), (1, 0, 0)), driven(kind, (0, 0.3, 0), (1, 0.2, 1))
    moved = model.replaced("joint", at=(0, 0.3, 0), axis=(1, 0.2, 1))
    assert moved.hash() == wanted.hash() != model.hash()
    attached = model.replaced("joint", attachment=wanted.values("joint")["attachment"])
    assert attached.hash() == wanted.hash()


def test_drivers_go_with_a_joint_to_another_body() -> None:
    model = driven("revolute", (0, 0, 0), (0, 0, 1)).without("other", attached=True)
    model.body("next", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.fixed("ground", "body", at=(0, 0, 0))
    moved = model.replaced("joint", b="next")
    assert moved.values("angle")["b"] == "next"


def test_only_drivers_of_a_joint_go_with_it() -> None:
    """One of the same axis between other bodies, or elsewhere, stays where it is."""
    model = driven("revolute", (0, 0, 0), (0, 0, 1))
    model.angle_driver("ground", "body", at=(0, 0, 1), axis=(0, 0, 1), angle=0.0, name="elsewhere")
    moved = model.replaced("joint", at=(0, 0, 2), axis=(0, 0, 1))
    assert moved.values("elsewhere") == model.values("elsewhere")
    assert moved.values("angle")["attachment"] == moved.values("joint")["attachment"]


def test_drivers_hang_on_their_joint() -> None:
    model = driven("cylindrical", (0, 0, 0), (0, 0, 1))
    with pytest.raises(lw.ModelError, match="'angle', 'displacement' would hang on nothing"):
        model.without("joint")
    assert model.without("joint", attached=True).joint_count == 1


def test_gravity_is_read_and_changed(pendulums: lw.Model) -> None:
    """A model elsewhere is the one that is built there; turns, functions and shapes go with it."""
    pendulums.force("rod 0", force=(0, lambda t: t, 0))
    moon = pendulums.with_gravity((0, 0, -1.62))
    assert pendulums.gravity.tolist() == [0, 0, -9.81] and moon.gravity.tolist() == [0, 0, -1.62]
    assert moon.hash() != pendulums.hash() == moon.with_gravity(pendulums.gravity).hash()
    assert len(moon.shapes) == len(pendulums.shapes) == 2
    with pytest.raises(ValueError, match="read-only"):
        moon.gravity[2] = 0.0
    for wrong in ((0, 0), (0, 0, np.nan), "down"):
        with pytest.raises(lw.ModelError, match="gravity"):
            pendulums.with_gravity(wrong)
    with pytest.raises(lw.ModelError, match=r"gravity \(0, 0, nan\) is not finite"):
        pendulums.with_gravity((0, 0, np.nan))


def test_a_pendulum_on_the_moon_is_slower(pendulums: lw.Model) -> None:
    """a = g / g_earth times as fast from rest."""
    free = pendulums.without("rod 1", attached=True)
    moon, earth = (
        lw.simulate(it, t_end=1e-3, step=1e-3, progress=False).angular_acceleration[0, 0, 1]
        for it in (free.with_gravity((0, 0, -1.62)), free)
    )
    assert moon / earth == pytest.approx(1.62 / 9.81, rel=1e-12)


def test_a_driver_stays_where_another_joint_has_its_coordinate() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1))
    for name in ("pin", "second"):
        model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name=name)
    model.drive("pin", position=lw.functions.polynomial(0.0, 1.0), name="motor")
    assert len(model.without("second", attached=True).table("joints").rows) == 2
    assert not model.without("pin", "second", attached=True).table("joints").rows
    other = model.replaced("second", at=(0, 0, 0), axis=(0, 0, -1))
    assert lw.kinematics(other, [0.0, 1.0]).coordinate("pin").value[-1] == pytest.approx(1.0, rel=1e-9)
