"""The description of a mechanism: what it refuses, and where it puts things."""

from __future__ import annotations

import copy
import ctypes
import functools
import inspect
import pickle
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, arrays, mechanisms
from linkwork.modeling.elements import KINDS
from linkwork.running.checks import joint_residuals

NAN = float("nan")


def two_bodies() -> lw.Model:
    """Bodies "crank" and "rod", turned and moved, so that space and body coordinates differ."""
    model = lw.Model()
    model.body(
        "crank",
        mass=1,
        inertia=(1, 2, 2),
        position=(0.5, 1, -2),
        orientation=lw.rotation.about((1, 2, 3), 0.7),
    )
    model.body(
        "rod", mass=2, inertia=(2, 3, 3), position=(2, 0, 1), orientation=lw.rotation.about((3, 1, 0), -2)
    )
    return model


def dynamics(model: lw.Model) -> _core.Dynamics:
    return lw.System(model, formulation="penalty").compiled()


BODY = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}

#: What is wrong with a body, and what the message must have beside the body's name.
BAD_BODIES = {
    "negative mass": ({"mass": -1.5}, "-1.5"),
    "NaN mass": ({"mass": NAN}, "nan"),
    "mass that is no number": ({"mass": "heavy"}, "heavy"),
    "inertia against the triangle inequality": ({"inertia": (1, 1, 2.5)}, "2.5"),
    "negative inertia": ({"inertia": (-0.5, 1, 1)}, "-0.5"),
    "infinite inertia": ({"inertia": (1, 1, float("inf"))}, "inf"),
    "inertia that is not symmetric": ({"inertia": [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]}, "symmetric"),
    "inertia of a wrong shape": ({"inertia": (1, 1)}, "(2,)"),
    "zero orientation": ({"orientation": (0, 0, 0, 0)}, "(0, 0, 0, 0)"),
    "orientation that is not unit": ({"orientation": (1, 0.1, 0, 0)}, "(1, 0.1, 0, 0)"),
    "NaN position": ({"position": (0, NAN, 0)}, "nan"),
    "infinite velocity": ({"velocity": (0, float("inf"), 0)}, "inf"),
    "NaN omega": ({"omega": (NAN, 0, 0)}, "nan"),
}


@pytest.mark.parametrize("case", BAD_BODIES)
def test_a_bad_body_is_refused_by_name_and_value(case: str) -> None:
    arguments, value = BAD_BODIES[case]
    with pytest.raises(lw.ModelError) as caught:
        lw.Model().body("flywheel", **{**BODY, **arguments})
    assert "'flywheel'" in str(caught.value)
    assert value in str(caught.value)


@pytest.mark.parametrize("case", BAD_BODIES)
def test_a_bad_body_leaves_the_model_as_it_was(case: str) -> None:
    model = two_bodies()
    before = model.hash()
    with pytest.raises(lw.ModelError):
        model.body("flywheel", **{**BODY, **BAD_BODIES[case][0]})
    assert (model.body_count, model.hash()) == (2, before)


@pytest.mark.parametrize("what", ["mass", "position", "orientation", "inertia"])
def test_the_bad_one_of_many_bodies_is_named(what: str) -> None:
    k = 1000
    arrays = {
        "mass": np.ones(k),
        "inertia": np.ones((k, 3)),
        "position": np.zeros((k, 3)),
        "orientation": np.tile((1.0, 0, 0, 0), (k, 1)),
    }
    arrays[what][617] = -7.0
    if what == "position":
        arrays[what][617] = NAN
    with pytest.raises(lw.ModelError, match=r"link\[617\]"):
        lw.Model().bodies("link", **arrays)


#: Joints that make no sense: how they are added, and what the message must have.
BAD_JOINTS: dict[str, tuple[Callable[[lw.Model], object], list[str]]] = {
    "zero axis": (
        lambda m: m.revolute("crank", "rod", at=(0, 0, 0), axis=(0, 0, 0), name="pin"),
        ["'pin'", "(0, 0, 0)"],
    ),
    "NaN axis": (
        lambda m: m.cylindrical("crank", "rod", at=(0, 0, 0), axis=(0, NAN, 1), name="pin"),
        ["'pin'", "(0, nan, 1)"],
    ),
    "NaN point": (
        lambda m: m.spherical("crank", "rod", at=(NAN, 0, 0), name="ball"),
        ["'ball'", "(nan, 0, 0)"],
    ),
    "point of two numbers": (
        lambda m: m.spherical("crank", "rod", at=(0, 1), name="ball"),
        ["'ball'", "(2,)"],
    ),
    "a body to itself": (lambda m: m.spherical("rod", "rod", at=(0, 0, 0), name="ball"), ["'ball'", "'rod'"]),
    "ground to ground": (
        lambda m: m.spherical("ground", m.ground, at=(0, 0, 0), name="ball"),
        ["'ball'", "'ground'"],
    ),
    "unknown body": (
        lambda m: m.spherical("crnk", "rod", at=(0, 0, 0), name="ball"),
        ["'ball'", "'crnk'", "'crank'"],
    ),
    "something that is no body": (
        lambda m: m.spherical(3, "rod", at=(0, 0, 0), name="ball"),
        ["'ball'", "3"],
    ),
    "body of another model": (
        lambda m: m.spherical(two_bodies().find("rod"), "crank", at=(0, 0, 0), name="ball"),
        ["'ball'", "'rod'", "another model"],
    ),
    "parallel axes": (
        lambda m: m.universal("crank", "rod", at=(0, 0, 0), axes=((0, 0, 1), (0, 0, 2)), name="cross"),
        ["'cross'", "(0, 0, 1)", "parallel"],
    ),
    "axes that are not perpendicular": (
        lambda m: m.universal("crank", "rod", at=(0, 0, 0), axes=((0, 0, 1), (0, 1, 1)), name="cross"),
        ["'cross'", "45 degrees"],
    ),
    "one axis instead of two": (
        lambda m: m.universal("crank", "rod", at=(0, 0, 0), axes=(0, 0, 1), name="cross"),
        ["'cross'", "pair"],
    ),
    "distance of two points that coincide": (
        lambda m: m.distance("crank", "rod", at=((1, 2, 3), (1, 2, 3)), name="tie"),
        ["'tie'", "0 m"],
    ),
    "negative length": (
        lambda m: m.distance("crank", "rod", at=((1, 2, 3), (0, 2, 3)), length=-2, name="tie"),
        ["'tie'", "-2 m"],
    ),
    "length without derivatives": (
        lambda m: m.distance("crank", "rod", at=((1, 2, 3), (0, 2, 3)), length=lambda t: 1.0 + t, name="tie"),
        ["'tie'", "length", "(f, df, ddf)"],
    ),
    "zero orientation": (
        lambda m: m.fixed("crank", "rod", at=(0, 0, 0), orientation=(0, 0, 0, 0), name="weld"),
        ["'weld'", "(0, 0, 0, 0)"],
    ),
    "x axis along the axis": (
        lambda m: m.translational(
            "crank", "rod", at=(0, 0, 0), axis=(0, 0, 2), x_axis=(0, 0, 1), name="guide"
        ),
        ["'guide'", "x_axis", "parallel"],
    ),
    "a name that is taken": (
        lambda m: [m.spherical("crank", "rod", at=(0, 0, 0), name="ball") for _ in range(2)],
        ["'ball'", "exists"],
    ),
    "infinite stiffness": (
        lambda m: m.spring_damper(
            "crank", "rod", at=((0, 0, 0), (1, 0, 0)), stiffness=float("inf"), name="coil"
        ),
        ["'coil'", "stiffness", "inf"],
    ),
    "force of two components": (lambda m: m.force("rod", force=(1, 2), name="push"), ["'push'", "(1, 2)"]),
    "force that is NaN at first": (
        lambda m: m.force("rod", force=(lambda t: NAN, 0, 0), name="push"),
        ["'push'", "force_x", "t = 0"],
    ),
}


@pytest.mark.parametrize("case", BAD_JOINTS)
def test_a_bad_element_is_refused_by_name_and_value(case: str) -> None:
    add, fragments = BAD_JOINTS[case]
    with pytest.raises(lw.ModelError) as caught:
        add(two_bodies())
    message = str(caught.value)
    assert [fragment for fragment in fragments if fragment not in message] == [], message
    assert "\n" not in message


@pytest.mark.parametrize("piece", [arrays.PIECE, 20])
def test_the_bad_one_of_many_joints_is_named(piece: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(arrays, "PIECE", piece)
    model = lw.Model()
    links = model.bodies("link", **BODY, position=np.zeros((100, 3)))
    axes = np.tile((0.0, 0, 1), (99, 1))
    axes[42] = 0
    with pytest.raises(lw.ModelError, match=r"'pin\[42\]'.*\(0, 0, 0\)"):
        model.joints("revolute", links[:-1], links[1:], at=(0, 0, 0), axis=axes, name="pin")


def test_a_duplicate_body_name_is_refused() -> None:
    with pytest.raises(lw.ModelError, match="'rod' exists"):
        two_bodies().body("rod", **BODY)


@pytest.mark.parametrize("name", [3, "", "two\nlines"])
def test_a_name_that_is_no_text_is_refused(name: object) -> None:
    with pytest.raises(lw.ModelError, match="name"):
        lw.Model().body(name, **BODY)  # type: ignore[arg-type]


def test_the_name_of_the_ground_is_refused() -> None:
    with pytest.raises(lw.ModelError, match="'ground'"):
        two_bodies().body("ground", **BODY)


def test_an_unknown_joint_kind_is_answered_with_the_nearest() -> None:
    with pytest.raises(lw.OptionError, match="'revolut'.*'revolute'"):
        two_bodies().joints("revolut", "crank", "rod", at=(0, 0, 0))


def test_unknown_frames_are_answered_with_the_nearest() -> None:
    with pytest.raises(lw.OptionError, match="'bodies'.*'body'"):
        two_bodies().spherical("crank", "rod", at=(0, 0, 0), frames="bodies")  # type: ignore[arg-type]


def test_nearly_unit_orientations_are_normalized() -> None:
    model = lw.Model()
    model.body("rod", **BODY, orientation=(1 + 1e-7, 0, 0, 0))
    assert np.linalg.norm(model.compiled().q0[3:]) == pytest.approx(1.0, abs=1e-15)


def test_things_without_a_name_are_numbered() -> None:
    model = lw.Model()
    bodies = [model.body(**BODY) for _ in range(2)]
    joints = [model.spherical(*bodies, at=(0, 0, 0)), model.fixed(*bodies, at=(0, 0, 0))]
    joints.append(model.spherical(*bodies, at=(0, 0, 0)))
    assert [thing.name for thing in (*bodies, *joints)] == [
        "body 1", "body 2", "spherical 1", "fixed 1", "spherical 2"
    ]  # fmt: skip


def test_numbers_of_names_avoid_those_that_are_taken() -> None:
    model = two_bodies()
    model.spherical("crank", "rod", at=(0, 0, 0), name="spherical 1")
    model.fixed("crank", "rod", at=(0, 0, 0), name="revolute 1")
    assert model.spherical("crank", "rod", at=(0, 0, 0)).name == "spherical 2"
    assert model.revolute("crank", "rod", at=(0, 0, 0), axis=(0, 0, 1)).name == "revolute 2"


def test_a_slice_of_a_range_names_the_same_bodies() -> None:
    links = lw.Model().bodies("link", **BODY, position=np.zeros((5, 3)))
    assert [body.name for body in links[1:4:2]] == ["link[1]", "link[3]"]
    assert links[1:4:2].indices.tolist() == [1, 3]


@pytest.mark.parametrize(
    "chosen", [[1, 3], (np.int64(1), 3), range(1, 5, 2), np.array([1, 3]), ["link[1]", 3]], ids=repr
)
def test_a_list_of_bodies_may_be_of_indices(chosen: Any) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.bodies("link", **BODY, position=np.diag(range(5))[:, :3])
    assert model.indices(chosen).tolist() == [1, 3]
    model.user_force(lambda t, q, v: np.eye(6)[:2], chosen)
    moving = np.abs(lw.simulate(model, 0.1, 0.05).velocity[-1]).max(axis=1) > 0
    assert moving.tolist() == [False, True, False, True, False]


@pytest.mark.parametrize("chosen", [[0, 5], [-2], range(6), [0, True], [0, 1.0], 3], ids=repr)
def test_what_is_no_index_of_a_body_is_refused(chosen: Any) -> None:
    model = lw.Model()
    model.bodies("link", **BODY, position=np.zeros((5, 3)))
    with pytest.raises(lw.ModelError, match="body index (5|-2) does not exist|is not a body|are no bodies"):
        model.indices(chosen)


#: Placements in space for every kind of joint.
IN_SPACE = {
    "point": {"at": (1, 2, 3)},
    "axis": {"at": (1, 2, 3), "axis": (0, 3, 4)},
    "two_axes": {"at": (1, 2, 3), "axes": ((0, 3, 4), (1, 0, 0))},
    "two_points": {"at": ((1, 2, 3), (4, 2, 0))},
    "frame": {"at": (1, 2, 3), "orientation": lw.rotation.about((1, 1, 0), 0.4)},
    "direction": {"axis": (0, 3, 4)},
    "two_directions": {"axes": ((0, 3, 4), (1, 0, 0))},
    "orientation": {"orientation": lw.rotation.about((1, 1, 0), 0.4)},
    "shafts": {"at": (1, 2, 3), "axes": ((0, 3, 4), (1, 0, 1))},
    "centers": {"at": ((1, 2, 3), (1, -1, 4)), "axis": (0, 3, 4)},
    "disc": {"at": ((1, 2, 3 - 0.3 * np.sqrt(0.5)), (1, 2, 3)), "axes": ((0, 0, 1), (1, 0, 1))},
}


def arguments(kind: _core.KindInfo) -> dict[str, object]:
    return IN_SPACE[kind.placement] | {
        name: it.example for name, it in kind.parameters.items() if not it.initial_distance
    }


@pytest.mark.parametrize("kind", _core.joint_kinds(), ids=lambda kind: kind.name)
def test_a_joint_placed_in_space_holds_at_the_initial_pose(kind: _core.KindInfo) -> None:
    model = two_bodies()
    getattr(model, kind.name)("crank", "rod", **arguments(kind))
    assert joint_residuals(model, dynamics(model))[0].max() < 1e-14


@pytest.mark.parametrize("kind", _core.joint_kinds(), ids=lambda kind: kind.name)
def test_a_method_of_a_joint_is_documented_by_its_kind(kind: _core.KindInfo) -> None:
    text = getattr(lw.Model, kind.name).__doc__
    assert kind.documentation in text
    assert [name for name in kind.equations if name not in text] == []


@pytest.mark.parametrize("kind", _core.joint_kinds(), ids=lambda kind: kind.name)
def test_joints_in_bulk_are_those_added_one_by_one(kind: _core.KindInfo) -> None:
    one_by_one, in_bulk = two_bodies(), two_bodies()
    for name in ("a", "b"):
        getattr(one_by_one, kind.name)("crank", "rod", **arguments(kind), name=name)
    pair = ["crank", "crank"], "rod"
    in_bulk.joints(kind.name, *pair, **arguments(kind))
    assert one_by_one.hash() == in_bulk.hash()


@pytest.mark.parametrize("kind", _core.joint_kinds(), ids=lambda kind: kind.name)
def test_joints_that_are_worked_through_in_pieces_are_those_of_one_piece(
    kind: _core.KindInfo, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, in_pieces = two_bodies(), two_bodies()
    many = ["crank"] * 7, "rod"
    whole.joints(kind.name, *many, **arguments(kind))
    monkeypatch.setattr(arrays, "PIECE", 3)  # the last has one joint
    in_pieces.joints(kind.name, *many, **arguments(kind))
    assert in_pieces.hash() == whole.hash()


@pytest.mark.parametrize("frames", ["space", "body"])
def test_lists_of_a_place_for_each_joint_are_arrays_of_them_in_pieces(
    frames: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    at, axis = np.random.default_rng(6).normal(size=(2, 7, 3))
    if frames == "body":
        at, axis = np.stack([at, 2 * at]), np.stack([axis, 3 * axis])
    whole, in_pieces = two_bodies(), two_bodies()
    many = ["crank"] * 7, "rod"
    whole.joints("revolute", *many, at=at, axis=axis, frames=frames)
    monkeypatch.setattr(arrays, "PIECE", 3)
    in_pieces.joints("revolute", *many, at=at.tolist(), axis=axis.tolist(), frames=frames)
    assert in_pieces.hash() == whole.hash()
    with pytest.raises(lw.ModelError, match=r"shape \(6, 3\), not \(3,\) or \(7, 3\)"):
        in_pieces.joints("spherical", *many, at=at[..., :6, :], frames=frames)


def test_bodies_do_not_depend_on_how_their_arrays_lie_in_memory() -> None:
    rng = np.random.default_rng(5)
    position, velocity = rng.normal(size=(2, 9, 3))
    orientation = rng.normal(size=(9, 4))
    orientation /= np.linalg.norm(orientation, axis=1, keepdims=True)
    inertia = np.array([A @ np.diag((2.0, 3.0, 4.0)) @ A.T for A in lw.rotation.matrix(orientation)])
    inertia = (inertia + np.swapaxes(inertia, 1, 2)) / 2
    mass = np.arange(1.0, 10.0)
    rows, others = lw.Model(), lw.Model()
    rows.bodies(
        "body", mass=mass, inertia=inertia, position=position, orientation=orientation, velocity=velocity
    )
    others.bodies(
        "body",
        mass=np.repeat(mass, 2)[::2],
        inertia=np.asfortranarray(inertia),
        position=position[::-1].copy()[::-1],
        orientation=np.asfortranarray(orientation),
        velocity=np.hstack([velocity, velocity])[:, :3],
    )
    assert np.array_equal(others.compiled().mass, mass)
    assert others.hash() == rows.hash()
    assert np.array_equal(rows.compiled().inertia, inertia)
    assert np.array_equal(rows.compiled().v0.reshape(-1, 6)[:, :3], velocity)


def in_body(model: lw.Model, body: str, point: np.ndarray, free: bool = False) -> np.ndarray:
    """A point (or free vector) of space in coordinates of a body."""
    q = model.compiled().q0.reshape(-1, 7)[model.find(body).index]
    return lw.rotation.matrix(q[3:]).T @ (point - (0 if free else q[:3]))


def test_a_revolute_in_body_frames_is_the_one_in_space() -> None:
    in_space, in_bodies = two_bodies(), two_bodies()
    at, axis, x = np.array([1.0, 2, 3]), np.array([0, 0.6, 0.8]), np.array([1.0, 0, 0])
    in_space.revolute("crank", "rod", at=at, axis=axis, x_axis=x)
    in_bodies.revolute(
        "crank",
        "rod",
        at=[in_body(in_bodies, body, at) for body in ("crank", "rod")],
        axis=[in_body(in_bodies, body, axis, free=True) for body in ("crank", "rod")],
        x_axis=[in_body(in_bodies, body, x, free=True) for body in ("crank", "rod")],
        frames="body",
    )
    given, found = in_space.compiled().joint_arrays(), in_bodies.compiled().joint_arrays()
    assert np.abs(given["origin"] - found["origin"]).max() < 1e-14
    assert np.abs(given["frame"] - found["frame"]).max() < 1e-14


def test_a_translational_in_body_frames_keeps_the_initial_turn_about_its_axis() -> None:
    model = two_bodies()
    axis = np.array([0, 0.6, 0.8])
    axes = [in_body(model, body, axis, free=True) for body in ("crank", "rod")]
    origin = in_body(model, "crank", np.array([2.0, 0, 1])), (0, 0, 0)
    model.translational("crank", "rod", at=origin, axis=axes, frames="body")
    assert joint_residuals(model, dynamics(model))[0].max() < 1e-14


def test_nearly_perpendicular_axes_of_a_universal_are_made_perpendicular() -> None:
    model = two_bodies()
    model.universal("crank", "rod", at=(0, 0, 0), axes=((0.8, 0.6, 0), (-0.6 + 1e-8, 0.8, 0)))
    assert joint_residuals(model, dynamics(model))[0].max() < 1e-15


def test_the_length_of_a_distance_is_the_initial_one() -> None:
    model = two_bodies()
    model.distance("crank", "rod", at=((1, 2, 3), (4, 2, -1)))
    assert model.compiled().joint_arrays()["parameters"][0] == pytest.approx(5.0, rel=1e-15)


def test_a_spring_is_at_rest_initially() -> None:
    model = two_bodies()
    model.spring_damper("crank", "rod", at=((1, 2, 3), (4, 2, -1)), stiffness=1e3)
    core = model.compiled()
    without = dynamics(two_bodies()).evaluate(0.0, core.q0, core.v0)["potential"]
    assert dynamics(model).evaluate(0.0, core.q0, core.v0)["potential"] == pytest.approx(without, abs=1e-12)


@pytest.mark.parametrize("frame", ["inertial", "body"])
def test_the_components_of_a_force_are_in_its_frame(frame: str) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("rod", **BODY, orientation=lw.rotation.about((0, 0, 1), np.pi / 2))
    model.force(body, force=(1, 0, 0), at=(0, 2, 0), frame=frame)  # type: ignore[arg-type]
    core = model.compiled()
    expected = {"inertial": (1, 0, 0, 0, 0, 2 * np.cos(np.pi / 2)), "body": (0, 1, 0, 0, 0, -2)}
    found = dynamics(model).evaluate(0.0, core.q0, core.v0)["g"]
    assert found == pytest.approx(expected[frame], abs=1e-15)


def no_force(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    return np.zeros(v.shape)


def test_the_hash_does_not_depend_on_names() -> None:
    """Of bodies, joints, those that are coupled, and forces of the user's own; which is coupled matters."""
    models = [lw.Model() for _ in range(3)]
    for letters, coupled, model in zip(("xyz", "abc", "abc"), (1, 1, 0), models, strict=True):
        for name in letters:
            body = model.body(name, **BODY)
            model.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0), name=f"pin {name}")
        ends = (letters[coupled], letters[2])
        model.coupler([(f"pin {name}", 1.0) for name in ends], name=f"belt {letters}")
        model.user_force(no_force, name=f"wind {letters}")
    assert models[0].hash() == models[1].hash() != models[2].hash()
    assert len({wind_on(bodies).hash() for bodies in (None, "x", ["x"], ["y"], ["x", "y"])}) == 4


def wind_on(bodies: Any) -> lw.Model:
    model = lw.Model()
    for name in "xyz":
        model.body(name, **BODY)
    model.user_force(no_force, bodies)
    return model


GAIN = 2.0


def braked(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    return -GAIN * v


def law_of(gain: float, calls: list[float]) -> Any:
    def law(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        calls.append(t)
        return -gain * v

    return law


def hash_with(law: Any) -> str:
    model = lw.Model()
    model.user_force(law, model.body("x", **BODY))
    return model.hash()


def test_the_hash_depends_on_what_a_force_of_python_computes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its code and the constants that it reads; not on what it keeps of its calls."""
    before = hash_with(braked)
    monkeypatch.setattr(sys.modules[__name__], "GAIN", 3.0)
    assert hash_with(braked) != before
    monkeypatch.undo()
    assert hash_with(braked) == before
    calls: list[float] = []
    law = law_of(1.0, calls)
    alike = hash_with(law)
    calls.append(0.5)
    assert hash_with(law) == alike == hash_with(law_of(1.0, [])) != hash_with(law_of(2.0, []))
    halved, doubled = (functools.partial(scaled, factor) for factor in (0.5, 2.0))
    assert hash_with(halved) != hash_with(doubled)
    assert len({hash_with(it) for it in (lambda t, q, v: v, lambda t, q, v: 2 * v, no_force)}) == 3


def scaled(factor: float, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    return factor * v


def test_the_hash_depends_on_a_mass() -> None:
    models = [lw.Model() for _ in range(2)]
    for mass, model in zip((1.0, 1.0 + 1e-15), models, strict=True):
        model.body("rod", mass=mass, inertia=(1, 1, 1))
    assert models[0].hash() != models[1].hash()


def test_a_model_describes_itself_in_a_line() -> None:
    model = lw.mechanisms.spatial_slider_crank()
    for word in ("spatial_slider_crank", "3 bodies", "1 universal", "17 constraint equations"):
        assert word in repr(model)
    assert "\n" not in repr(model)


# --- copies -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", mechanisms.MECHANISMS)
def test_copies_of_a_model_are_exact_and_on_their_own(name: str) -> None:
    model = mechanisms.MECHANISMS[name].function()
    for twin in (pickle.loads(pickle.dumps(model)), copy.deepcopy(model)):
        assert (twin.hash(), twin.describe()) == (model.hash(), model.describe())
        twin.body("another", mass=1.0, inertia=(1, 1, 1))
        assert twin.body_count == model.body_count + 1


def still(t: float, q: Any, v: Any) -> Any:
    return 0 * v


def growing(t: float) -> float:
    return 3.0 * t


def test_copies_of_a_model_have_its_functions_of_python() -> None:
    """A ball that a force 3 t lifts off: v = 3 t^2 / 4 - g t. In a pickle these are functions of modules."""

    def ball(force: Any, law: Any) -> lw.Model:
        model = lw.Model(name="ball")
        model.body("ball", mass=2.0, inertia=(1, 1, 1))
        model.force("ball", force=(0, 0, force))
        model.user_force(law, name="mine")
        return model

    of_module, local = ball(growing, still), ball(lambda t: 3.0 * t, lambda t, q, v: 0 * v)
    twins = [(of_module, pickle.loads(pickle.dumps(of_module)))]
    twins += [(it, make(it)) for it in (of_module, local) for make in (copy.copy, copy.deepcopy)]
    for model, twin in twins:
        assert twin.hash() == model.hash() and twin.user_forces[0][0] == "mine"
        assert lw.simulate(twin, 1.0, step=1e-2).v[-1, 0, 2] == pytest.approx(0.75 - 9.81)
        twin.body("another", mass=1.0, inertia=(1, 1, 1))
        assert model.body_count == 1
    with pytest.raises((AttributeError, pickle.PicklingError), match="lambda"):
        pickle.dumps(local)


def test_a_compiled_force_stays_in_its_process() -> None:
    """What is at its address in another one, nobody knows."""
    numbers = ctypes.POINTER(ctypes.c_double)
    kind = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_int64, *[numbers] * 3, ctypes.c_void_p)
    model = mechanisms.pendulum()
    function = kind(lambda t, n, q, v, g, data: None)
    model.compiled_force(ctypes.cast(function, ctypes.c_void_p).value, name="wind")
    assert copy.deepcopy(model).hash() == model.hash()
    with pytest.raises(
        lw.ModelError, match="'wind' is a compiled force, whose address is that of this process"
    ):
        pickle.dumps(model)


class Arm(lw.Model):
    """A class of the user's own, with arguments, attributes and methods."""

    def __init__(self, length: float) -> None:
        super().__init__(name="arm")
        self._length = length
        self._rod = self.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(length / 2, 0, 0))
        self.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")

    def length(self) -> float:
        return self._length


class Noted(lw.Model):
    def __init__(self, gravity: Any = (0, 0, -1.62), name: str = "") -> None:
        super().__init__(gravity, name)
        self._notes = ["moon"]


def test_models_of_a_class_of_ones_own_stay_of_it(tmp_path: Path) -> None:
    arm = Arm(2.0)
    q, v = arm.compiled().q0, arm.compiled().v0
    made = [copy.copy(arm), copy.deepcopy(arm), pickle.loads(pickle.dumps(arm)),
            arm.replaced("rod", mass=2.0), arm.without("pin"), arm.with_initial_state(q, v),
            lw.assemble(arm).model]  # fmt: skip
    for model in made:
        assert isinstance(model, Arm) and model.length() == 2.0 and model.body_count == 1
    for model in made[1:3]:  # their handles are their own
        model.revolute("ground", model._rod, at=(2, 0, 0), axis=(0, 1, 0))
    with pytest.raises(lw.ModelError, match="'rod' belongs to another model"):
        made[3].revolute("ground", made[3]._rod, at=(2, 0, 0), axis=(0, 1, 0))
    arm.save(file := tmp_path / "arm.yaml")
    with pytest.raises(
        lw.ModelError, match="Arm.load: __init__ of this class takes or adds what no file has"
    ):
        Arm.load(file)
    noted = Noted.load(file)
    assert noted._notes == ["moon"] and noted.hash() == arm.hash() and noted.name == "arm"


def test_what_is_made_of_a_model_goes_to_another_process() -> None:
    """With the same numbers there: reactions, shapes in words, residuals by name, accelerations."""
    rest = lw.equilibrium(mechanisms.chain(2))
    vibration, assembly = lw.linearize(rest.model), lw.assemble(mechanisms.four_bar())
    system = lw.System(mechanisms.chain(2), formulation="penalty", penalty=1e7)
    ensemble = lw.Ensemble(mechanisms.chain(2), {"gravity[2]": [-9.81, -1.62]})
    y = system.initial_state()
    for twin in (lambda it: pickle.loads(pickle.dumps(it)), copy.deepcopy):
        assert np.array_equal(twin(rest).reactions().force, rest.reactions().force)
        assert not twin(rest).multipliers.flags.writeable
        assert np.array_equal(twin(vibration).frequencies, vibration.frequencies)
        assert twin(vibration).describe(0) == vibration.describe(0)
        assert twin(assembly).residuals == assembly.residuals
        assert np.array_equal(twin(system).derivative(0.0, y), system.derivative(0.0, y))
        assert twin(system).options == system.options
        assert twin(ensemble).model(1).hash() == ensemble.model(1).hash()
    changed = copy.deepcopy(system)
    assert changed.model is not system.model and changed.model.hash() == system.model.hash()


def _named(model: lw.Model) -> tuple[list[str], list[str], list[str]]:
    core = model.compiled()
    return (
        [core.body_name(k) for k in range(model.body_count)],
        [core.joint_name(k) for k in range(model.joint_count)],
        [core.force_name(k) for k in range(model.force_count)],
    )


def test_bodies_joints_and_forces_in_bulk_take_names_of_their_own() -> None:
    model = lw.Model()
    at = np.array([[0.0, 0, 0], [1, 0, 0]])
    bodies = model.bodies(["crank", "rod"], mass=1.0, inertia=(1, 1, 1), position=at)
    ends = (["ground", "crank"], ["crank", "rod"])
    model.joints("revolute", *ends, at=at, axis=(0, 1, 0), name=("pin", "knee"))
    model.forces("bushing", "ground", bodies, at=at, name=["left", "right"])
    assert _named(model) == (["crank", "rod"], ["pin", "knee"], ["left", "right"])
    assert [body.name for body in bodies] == ["crank", "rod"]
    assert model.find("rod").index == 1


#: Of force elements between rods at (0, 0, 0), (1, 0, 0), ..., what their own methods take.
OF_METHODS: dict[str, dict[str, Any]] = {
    "spring_damper": {"at": ((0, 0, 0), (1, 0, 0)), "stiffness": 10.0},
    "rotational_spring_damper": {"axis": (0, 1, 0), "stiffness": 5.0},
    "bushing": {"at": (0.5, 0, 0), "stiffness": (1.0, 2.0, 3.0)},
}


@pytest.mark.parametrize("kind", OF_METHODS)
def test_many_force_elements_take_what_their_method_takes(kind: str) -> None:
    """The same models, one by one and at once."""
    each, at_once = lw.Model(), lw.Model()
    for model in (each, at_once):
        model.bodies("rod", mass=1.0, inertia=(1, 1, 1), position=[(k, 0, 0) for k in range(4)])
    for k in range(3):
        getattr(each, kind)(f"rod[{k}]", f"rod[{k + 1}]", **OF_METHODS[kind])
    rods = [f"rod[{k}]" for k in range(4)]
    at_once.forces(kind, rods[:-1], rods[1:], **OF_METHODS[kind])
    assert at_once.hash() == each.hash()


def test_vectors_of_many_are_one_for_all_or_one_for_each() -> None:
    model, at = lw.Model(), [(k, 0, 0) for k in range(3)]
    rods = model.bodies("rod", mass=1.0, inertia=(1, 1, 1), position=at)
    model.forces("bushing", "ground", rods, at=at, stiffness=np.diag((1.0, 2.0, 3.0)), damping_z=4.0)
    model.forces("applied", "ground", rods, at=at, force=(0, 0, lw.functions.polynomial(0, 1)))
    assert [model.values(f"bushing 1[{k}]")["stiffness_z"] for k in range(3)] == [0.0, 0.0, 3.0]
    assert (
        model.values("bushing 1[0]")["damping_z"] == 4.0 and model.values("applied 1[2]")["torque_x"] == 0.0
    )
    with pytest.raises(lw.ModelError, match="stiffness and stiffness_x are both given"):
        model.forces("bushing", "ground", rods, at=at, stiffness=(1, 2, 3), stiffness_x=1.0)
    with pytest.raises(lw.ModelError, match=r"stiffness has shape \(2, 3\), not \(3,\) or \(3, 3\)"):
        model.forces("bushing", "ground", rods, at=at, stiffness=np.ones((2, 3)))


@pytest.mark.parametrize("count", [2, 3, 4])
def test_rows_of_functions_of_many_are_refused_as_such(count: int) -> None:
    """Three functions for three elements may be one with its derivatives, or a vector; else they are that."""
    model, at = lw.Model(), [(k, 0, 0) for k in range(count)]
    rods = model.bodies("rod", mass=1.0, inertia=(1, 1, 1), position=at)
    f = (np.sin, np.cos, lambda t: -np.sin(t))
    for rows in ([(np.sin, 0, 0)] * count, [[*f]] * count, *([[f] * 3] if count == 3 else [])):
        with pytest.raises(lw.ModelError, match=r"\[0\]': force has rows of functions: .* one by one"):
            model.forces("applied", "ground", rods, at=at, force=rows)
    assert model.force_count == 0
    if count != 3:
        model.forces("applied", "ground", rods, at=at, force=[f] * 3)
        assert model.force_count == count


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["c", "d", "crank"], "body 'crank' exists already"),
        (["c", "d", "c"], "body 'c' exists already"),
        (["c", "ground", "d"], "body 'ground': the name belongs to the ground"),
        (["c", "", "d"], "the name is empty"),
        (["c", "d"], "2 names for 3"),
        (["c", 7, "d"], "name 7 is not printable text"),
        (["c", "d\n", "e"], r"bodies: name 'd\\n' is not printable text"),
        (["c", "d" * 981, "e"], "has more than 980 characters"),
        ("c\n", r"bodies: name 'c\\n' is not printable text"),
        (7, "bodies: name 7 is neither a text nor a sequence of names"),
        ({"c"}, "bodies: name {'c'} is neither a text nor a sequence of names"),
    ],
)
def test_where_one_of_many_names_is_refused_nothing_is_added(names: list[str], message: str) -> None:
    model = lw.Model()
    model.body("crank", mass=1.0, inertia=(1, 1, 1))
    with pytest.raises(lw.ModelError, match=message):
        model.bodies(names, mass=1.0, inertia=(1, 1, 1), position=np.zeros((3, 3)))
    assert _named(model) == (["crank"], [], [])
    model.bodies(["c", "d", "e"], mass=1.0, inertia=(1, 1, 1), position=np.zeros((3, 3)))
    with pytest.raises(lw.ModelError, match="joint 'a' exists already"):
        model.joints("spherical", "ground", ["c", "d", "e"], at=(0, 0, 0), name=["a", "b", "a"])
    with pytest.raises(lw.ModelError, match="revolute 'b': axis .* has no direction"):
        model.joints(
            "revolute", "ground", ["c", "d"], at=(0, 0, 0), axis=[(0, 0, 1), (0, 0, 0)], name=["a", "b"]
        )
    assert _named(model)[1] == []


#: With methods of their own, beside the stubs.
SPECIAL = {"coupler", "point_on_curve", "spring_damper", "rotational_spring_damper", "bushing"}

ELEMENTS = [name for name in dir(lw.Model) if name in {*KINDS["joint"], *KINDS["force"]}]


def example_of(name: str) -> list[str]:
    """The lines of code in a docstring, which an editor shows over the name."""
    lines = [line[4:] for line in (inspect.getdoc(getattr(lw.Model, name)) or "").splitlines()
             if line.startswith("    ")]  # fmt: skip
    return [line for line in lines if line.split(" = ")[-1].startswith("model.")]


@pytest.mark.parametrize("name", ELEMENTS)
def test_each_joint_and_force_element_has_an_example_that_runs(name: str) -> None:
    """Whole in the stubs, too."""
    stub = (Path(lw.__file__).parent / "modeling/methods.pyi").read_text()
    example = example_of(name)
    assert any(line.startswith(f"model.{name}(") for line in example)
    model = lw.Model()
    for pin in ("motor pin", "wheel pin"):
        wheel = model.body(mass=1, inertia=(1, 1, 1))
        model.revolute("ground", wheel, at=(0, 0, 0), axis=(0, 1, 0), name=pin)
    before = model.joint_count, model.force_count
    exec("\n".join(example), {"model": model})
    added = model.joint_count - before[0], model.force_count - before[1]
    assert added[name in KINDS["force"]] == 1
    assert name in SPECIAL or all(line in stub for line in example)


#: What methods in a form of their own add: bodies, joints, force elements, functions of the user's, shapes.
OWN_FORM = {
    "body": (1, 0, 0, 0, 0), "drive": (1, 2, 0, 0, 0), "force": (1, 0, 1, 0, 0), "shape": (1, 0, 0, 0, 2),
    "joint_force": (1, 1, 0, 1, 0), "user_force": (1, 0, 0, 1, 0), "spring_damper": (1, 0, 1, 0, 0),
    "rotational_spring_damper": (1, 1, 1, 0, 0), "bushing": (1, 0, 1, 0, 0),
}  # fmt: skip


@pytest.mark.parametrize("name", OWN_FORM)
def test_each_method_in_a_form_of_its_own_has_an_example_that_moves(name: str) -> None:
    example = example_of(name)
    assert any(line.split(" = ")[-1].startswith(f"model.{name}(") for line in example)
    model = lw.Model()
    exec("\n".join(example), {"model": model, "lw": lw})
    shapes = sum(map(len, model.shapes.by_body().values()))
    counts = model.body_count, model.joint_count, model.force_count, model.user_force_count, shapes
    assert counts == OWN_FORM[name]
    assert lw.simulate(model, 0.05, 1e-3, progress=False).finished


def test_examples_of_what_is_read_and_changed_run() -> None:
    model = lw.mechanisms.rod_pendulum()
    place = {"at": ((0, 0, 1), (0.5, 0, 0)), "stiffness": 1.0, "name": "spring"}
    model.spring_damper("ground", model.table()[0]["name"], **place)
    pin = model.table("joints")[0]["name"]
    result = lw.simulate(model, 0.1, 1e-3, progress=False)
    found: dict[str, Any] = {"model": model, "result": result}
    for name in ("values", "without", "with_initial_state"):
        exec("\n".join(example_of(name)).replace("pin", pin), found)
    assert found["length"] == model.values("spring")["free_length"]
    assert found["free"].joint_count == 0
    np.testing.assert_array_equal(found["onward"].compiled().q0, result.q[-1].ravel())


@pytest.mark.parametrize(
    ("role", "kind", "arguments", "fragments"),
    [
        ("joints", "revolute", {"at": (0, 0, 0), "axis": (0, 0, 1), "stiff": 1}, ["'stiff'", "'at', 'axis'"]),
        ("joints", "revolute", {"at": (0, 0, 0)}, ["axis is missing"]),
        (
            "forces",
            "spring_damper",
            {"at": ((0, 0, 0), (0, 0, 1)), "stifness": 1},
            ["'stifness'", "'stiffness'"],
        ),
        ("forces", "spring_damper", {"stiffness": 1}, ["at is missing"]),
    ],
)
def test_arguments_of_many_that_there_are_not_are_named(
    role: str, kind: str, arguments: dict[str, Any], fragments: list[str]
) -> None:
    model = lw.Model()
    body = model.body("x", **BODY)
    with pytest.raises(lw.ModelError) as refused:
        getattr(model, role)(kind, model.ground, [body], **arguments)
    assert all(fragment in str(refused.value) for fragment in [kind, *fragments])
    assert (model.joint_count, model.force_count) == (0, 0)


@pytest.mark.parametrize("given", [1j * np.ones((1, 6)), [["1"] * 6]])
def test_a_force_that_is_not_of_real_numbers_is_refused(given: Any) -> None:
    model = lw.Model()
    model.body("x", **BODY)
    model.user_force(lambda t, q, v: given, name="push")
    with pytest.raises(lw.ModelError, match="'push': returned .*, not an array of numbers"):
        lw.simulate(model, 0.1, 0.01, progress=False)


def test_what_cannot_be_set_is_refused() -> None:
    model = lw.mechanisms.chain(3)
    with pytest.raises(AttributeError, match="'gravity' cannot be set.*Model\\(gravity"):
        model.gravity = (0, 0, 0)  # type: ignore[attr-defined]
    for handles in (
        model.bodies("rods", mass=[1.0, 2.0], inertia=(1, 1, 1), position=np.eye(2, 3)),
        model.find("link[0]"),
    ):
        with pytest.raises(AttributeError):
            handles.mass = 3.0  # type: ignore[union-attr]
    model.name = "chain"
    assert copy.copy(model).name == "chain"
