"""Models in YAML and JSON files: what is written comes back exactly, and people can write them, too."""

from __future__ import annotations

import itertools
import json
import math
import pickle
import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import _core
from linkwork.cli import base, run
from linkwork.functions import Sum
from linkwork.mechanisms import MECHANISMS
from linkwork.modeling import files
from linkwork.modeling.files import schema, syntax
from linkwork.modeling.files.writing import json_lines, record_of, yaml_lines
from random_mechanisms import FORCES, JOINTS, Maker, Mechanism, examples, make

SUFFIXES = (".yaml", ".json")


def bits(model: lw.Model) -> dict[str, Any]:
    """Everything in the compiled model, as bytes and names."""
    core = model.compiled()
    out: dict[str, Any] = {
        what: getattr(core, what).tobytes() for what in ("gravity", "mass", "inertia", "q0", "v0")
    }
    for role in ("joint", "force"):
        out |= {f"{role} {what}": x.tobytes() for what, x in getattr(core, f"{role}_arrays")().items()}
    out["bodies"] = [core.body_name(k) for k in range(core.body_count)]
    out["joints"] = [core.joint_name(k) for k in range(core.joint_count)]
    out["forces"] = [core.force_name(k) for k in range(core.force_count)]
    out["functions"] = {index: function.fingerprint() for index, function in model._functions.items()}
    return out | {"name": model.name, "hash": model.hash()}


def round_trip(model: lw.Model, path: Path) -> lw.Model:
    model.save(path)
    return lw.Model.load(path)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", MECHANISMS)
def test_every_mechanism_comes_back_to_the_last_bit(name: str, suffix: str, tmp_path: Path) -> None:
    model = MECHANISMS[name].function()
    assert bits(round_trip(model, tmp_path / f"model{suffix}")) == bits(model)


@pytest.mark.parametrize("suffix", SUFFIXES)
@examples(15)
@given(
    seed=st.integers(0, 2**32 - 1), joints=st.lists(st.sampled_from(sorted(JOINTS)), min_size=2, max_size=12)
)
def test_random_mechanisms_come_back_to_the_last_bit(
    suffix: str, seed: int, joints: list[str], tmp_path_factory: pytest.TempPathFactory
) -> None:
    forces = [sorted(FORCES)[k] for k in np.random.default_rng(seed).integers(len(FORCES), size=4)]
    model = make(seed, joints, forces=forces).model
    assert bits(round_trip(model, tmp_path_factory.mktemp("files") / f"model{suffix}")) == bits(model)


@examples(5)
@given(seed=st.integers(0, 2**32 - 1))
def test_every_orientation_comes_back(seed: int, tmp_path_factory: pytest.TempPathFactory) -> None:
    rng, count = np.random.default_rng(seed), 1000
    p = rng.standard_normal((count, 4))
    model = lw.Model()
    model.bodies(
        "b", mass=1.0, inertia=(1, 1, 1), position=np.zeros((count, 3)),
        orientation=p / np.linalg.norm(p, axis=1, keepdims=True),
    )  # fmt: skip
    again = round_trip(model, tmp_path_factory.mktemp("files") / "model.json")
    assert again.compiled().q0.tobytes() == model.compiled().q0.tobytes()


def test_orientations_next_to_powers_of_two_come_back(tmp_path: Path) -> None:
    """A rounded quarter turn, of parameters not quite of length 1; numbers are finer below 1/2 than above."""
    words = "0x1.ffff84bf688e1p-2", "0x1.fffffffff12a3p-2", "0x1.fffffffff12a3p-2", "-0x1.00003da04bb8fp-1"
    p = np.array(list(map(float.fromhex, words))) * (1 + 1e-9 * np.arange(-500, 500)[:, None])
    model = lw.Model()
    model.bodies("b", mass=1.0, inertia=(1, 1, 1), position=np.zeros((len(p), 3)), orientation=p)
    again = round_trip(model, tmp_path / "model.json")
    assert again.compiled().q0.tobytes() == model.compiled().q0.tobytes()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_numbers_at_the_edges_come_back(suffix: str, tmp_path: Path) -> None:
    model = lw.Model(gravity=(-0.0, 5e-324, 1.7976931348623157e308))
    model.body("a", mass=0.1 + 0.2, inertia=(1e-300, 1e-300, 1e-300), position=(-0.0, 1 / 3, -1e22))
    assert bits(round_trip(model, tmp_path / f"model{suffix}")) == bits(model)


@pytest.mark.parametrize("zero", ["0", "0.0", "-0.0", "0e-400", "+0.000E-5", "00.0"])
def test_a_number_that_is_written_as_zero_is_zero(zero: str, tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text(f"linkwork: 1\ngravity: [{zero}, 5e-324, -2.5e-320]\n")
    gravity = lw.Model.load(tmp_path / "model.yaml").compiled().gravity
    assert gravity.tolist() == [0.0, 5e-324, -2.5e-320]


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_any_printable_name_comes_back(suffix: str, tmp_path: Path) -> None:
    names = ["null", "1e3", "true", "~", "yes", "a: b", "# no", "- x", "[0]", "{", "'", '"', "\\", "é",
             "车轮", "🤖", "x" * 300, " lead", "trail ", "*a", "&b", "!c", "%d", "@", "`", "=",
             "<<", "0x1F", "1_000", "link[3]"]  # fmt: skip
    model = lw.Model(name="one line, no tab and é")
    for name in names:
        model.body(name, mass=1.0, inertia=(1, 1, 1))
    again = round_trip(model, tmp_path / f"model{suffix}")
    assert [again.compiled().body_name(k) for k in range(len(names))] == names
    assert again.name == model.name


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_loaded_model_moves_as_the_one_saved(suffix: str, tmp_path: Path) -> None:
    model = MECHANISMS["spatial_slider_crank"].function()
    one, other = (
        lw.simulate(m, t_end=0.1, step=1e-3) for m in (model, round_trip(model, tmp_path / f"m{suffix}"))
    )
    assert one.q.tobytes() == other.q.tobytes()


# --- functions of time --------------------------------------------------------------------------------------


def driven(length: Any, count: int = 1) -> lw.Model:
    model = lw.Model()
    bodies = model.bodies(
        "b", mass=1.0, inertia=(1, 1, 1), position=np.array([[1.0, k, 0] for k in range(count)])
    )
    at = (np.array([[0.0, k, 0] for k in range(count)]), np.array([[1.0, k, 0] for k in range(count)]))
    model.joints("distance", model.ground, bodies, at=at, length=length)
    return model


@pytest.mark.parametrize("function", [
    lw.functions.polynomial(1.0, 0.1, -0.2), lw.functions.constant(1.0),
    lw.functions.harmonic(0.1, 3.0, 0.2, 1.0),
    lw.functions.table([0, 0.3, 0.7, 2.0], [1.0, 1.1, 0.9, 1.3]),
    lw.functions.piecewise_polynomial([0.0, 1.0, 3.0], [[1.0, 0.1], [1.1, 0.2]]),
    Sum((lw.functions.constant(1.0), lw.functions.cycloidal(0.3, duration=1.5, start=0.1))),
    lw.functions.expression("1 + 0.3 * sin(2*pi*t)**2"),
    Sum((lw.functions.constant(1.0), lw.functions.harmonic(0.1, 3.0, 0.2, 1.0).integral().integral())),
], ids=repr)  # fmt: skip
def test_functions_of_time_come_back(function: Any, tmp_path: Path) -> None:
    model = driven(function)
    again = round_trip(model, tmp_path / "model.yaml")
    assert bits(again) == bits(model)
    for t in (0.0, 0.31, 1.7, 2.0):
        assert again.signals[0][1].evaluate(t) == function.evaluate(t)


DRIVEN = """
linkwork: 1
functions: {{shared: {{polynomial: [0.1, 1, -0.5]}}}}
bodies:
  - {{name: arm, mass: 1, inertia: [0.01, 0.02, 0.02], position: [0.5, 0, 0]}}
  - {{name: cart, mass: 1, inertia: [0.01, 0.02, 0.02], position: [0, 1, 0]}}
joints:
  - {{kind: revolute, name: pin, a: ground, b: arm, at: [0, 0, 0], axis: [0, 1, 0]}}
  - {{kind: translational, name: rail, a: ground, b: cart, at: [0, 1, 0], axis: [1, 0, 1]}}
  - {{kind: angle_driver, name: motor, a: ground, b: arm, at: [0, 0, 0], axis: [0, 1, 0], angle: {0}}}
  - {{kind: displacement_driver, a: ground, b: cart, at: [0, 1, 0], axis: [1, 0, 1], displacement: {0}}}
"""

DRIVERS = {
    "{expression: 0.1 + 0.3 * sin(2 * pi * t)**2}": lambda t: 0.1 + 0.3 * np.sin(2 * np.pi * t) ** 2,
    "{table: {t: [0, 1, 2], values: [0.1, 0.2, 0.7]}}": lambda t: 0.1 - 0.1 * t + 0.2 * t**2,
    "shared": lambda t: 0.1 + t - 0.5 * t**2,
    "{harmonic: {amplitude: 0.2, frequency: 5, offset: 0.1}}": lambda t: 0.1 + 0.2 * np.sin(5 * t),
    "{cycloidal: {rise: 0.4, duration: 0.2}}": lambda t: (
        np.where(t < 0.2, 2 * t - 0.4 * np.sin(10 * np.pi * t) / (2 * np.pi), 0.4)
    ),
    "{sum: [{polynomial: [0.1, 1]}, {expression: t**3}]}": lambda t: 0.1 + t + t**3,
}


@pytest.mark.parametrize("text", DRIVERS)
def test_drivers_of_a_file_move_as_their_functions_say(text: str, tmp_path: Path) -> None:
    path, out = tmp_path / "driven.yaml", tmp_path / "assembled.yaml"
    path.write_text(DRIVEN.format(text))
    assert bits(round_trip(lw.Model.load(path), tmp_path / "again.yaml")) == bits(lw.Model.load(path))
    assert run(["convert", str(path), str(out), "--assemble"], debug=False) == 0
    result = lw.simulate(lw.Model.load(out), t_end=0.3, step=1e-3)
    for joint in ("pin", "rail"):
        assert result.coordinate(joint).value == pytest.approx(DRIVERS[text](result.t), abs=1e-9), joint


@pytest.mark.parametrize(("motion", "expected"), [
    ("position: {expression: 0.2 * sin(3 * t)}", lambda t: 0.2 * np.sin(3 * t)),
    ("velocity: {polynomial: [0.5, 2]}", lambda t: 0.5 * t + t**2),
    ("velocity: swing", lambda t: 0.4 * (1 - np.cos(5 * t)) / 5),
    ("acceleration: 3", lambda t: 1.5 * t**2),
])  # fmt: skip
@pytest.mark.parametrize("joint", ["joint: pin", "joint: rail", "joint: bush, coordinate: angle"])
def test_joints_of_a_file_are_driven_by_their_names(
    joint: str, motion: str, expected: Any, tmp_path: Path
) -> None:
    path = tmp_path / "driven.yaml"
    drive = f"  - {{kind: drive, {joint}, {motion}}}"
    bush = "  - {kind: cylindrical, name: bush, a: ground, b: cart, at: [0, 1, 0], axis: [1, 0, 1]}"
    lines = [line for line in DRIVEN.format(0).splitlines() if "driver" not in line]
    if "bush" in joint:
        lines = [bush if "rail" in line else line for line in lines]
    text = "\n".join([*lines, drive])
    path.write_text(
        text.replace(
            "{shared: {polynomial: [0.1, 1, -0.5]}}", "{swing: {harmonic: {amplitude: 0.4, frequency: 5}}}"
        )
    )
    model = lw.Model.load(path)
    assert bits(round_trip(model, tmp_path / "again.json")) == bits(model)
    result = lw.simulate(lw.assemble(model).model, t_end=0.3, step=1e-3)
    name, *which = (word.split(": ")[1] for word in joint.split(", "))
    assert result.coordinate(name, *which).value == pytest.approx(expected(result.t), abs=1e-9)


def test_every_function_of_time_there_is_is_in_the_schema() -> None:
    """Each class of linkwork.functions but those for Python functions is written: above is one of each."""
    written = {"Polynomial", "Harmonic", "Table", "Cycloidal", "Expression", "Sum"}
    assert {kind.__name__ for kind in lw.functions.TimeFunction.__subclasses__()} == written | {
        "Callback",
        "Broken",
    }


def test_a_function_of_several_elements_stays_one(tmp_path: Path) -> None:
    model = driven(lw.functions.harmonic(0.1, 3.0, 0.2, 1.0), count=5)
    again = round_trip(model, tmp_path / "model.json")
    assert bits(again) == bits(model) and len(again.signals) == 1
    assert list(json.loads((tmp_path / "model.json").read_text())["functions"]) == ["function 1"]


def test_a_file_that_is_there_is_replaced_only_where_one_says_so(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    MECHANISMS["pendulum"].function().save(path)
    before = path.read_bytes()
    with pytest.raises(lw.FileError, match="there is such a file already") as refused:
        MECHANISMS["four_bar"].function().save(path)
    assert refused.value.code == "exists" and path.read_bytes() == before
    MECHANISMS["four_bar"].function().save(path, overwrite=True)
    assert lw.Model.load(path).hash() == MECHANISMS["four_bar"].function().hash()


@pytest.mark.parametrize("order", list(itertools.permutations(("force", "driver", "rod", "spring")))[::5])
def test_the_order_in_which_joints_and_forces_take_functions_does_not_count(
    order: tuple[str, ...], tmp_path: Path
) -> None:
    """A file has the joints first."""
    harmonic = lw.functions.harmonic
    model = lw.Model()
    for k, name in enumerate("ab"):
        model.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, k, 0))
    model.revolute("ground", "b", at=(0, 1, 0), axis=(0, 0, 1), name="pin")
    shared = harmonic(1.0, 3.0)
    line = {"at": ((0, 3, 0), (1, 0, 0))}
    add: dict[str, Callable[[], object]] = {
        "force": lambda: model.force("a", force=(shared, 0, 0)),
        "driver": lambda: model.drive("pin", position=harmonic(0.1, 2.0)),
        "rod": lambda: model.distance("ground", "a", length=harmonic(0.1, 2.0, 0.0, 3.1), **line),
        "spring": lambda: model.spring_damper("b", "a", stiffness=harmonic(1.0, 4.0, 0.0, 9.0), **line),
    }
    for what in order:
        add[what]()
    model.save(tmp_path / "model.yaml")
    for same in (lw.Model.load(tmp_path / "model.yaml"), pickle.loads(pickle.dumps(model)), model.without()):
        assert same.hash() == model.hash()
    assert model.replaced("a", mass=2.0).hash() != model.hash()


def test_python_functions_are_refused_by_name(tmp_path: Path) -> None:
    model = driven((lambda t: 1.0 + t, lambda t: 1.0, lambda t: 0.0))
    with pytest.raises(lw.ModelError, match=r"distance 'distance 1\[0\]': length is a Python function"):
        model.save(tmp_path / "model.yaml")
    assert not list(tmp_path.iterdir())


def test_forces_of_the_users_own_are_refused_by_name(tmp_path: Path) -> None:
    model = MECHANISMS["pendulum"].function()
    model.user_force(lambda t, q, v: (np.zeros(3), np.zeros(3)), model.compiled().body_name(0), name="wind")
    with pytest.raises(lw.ModelError, match="'wind'"):
        model.save(tmp_path / "model.yaml")


def test_shapes_come_back(tmp_path: Path) -> None:
    model = crank_and_rod()
    turn = lw.rotation.about((1, 2, 3), 0.7)
    tetrahedron = lw.Mesh(np.eye(4)[:, :3], [[0, 1, 2], [1, 2, 3]], color="red")
    model.shape("crank", lw.Box((1, 0.1, 0.2), orientation=turn), tetrahedron)
    model.shape(["rod", model.ground], lw.Rod((0, 0, 0), (0, 0, 1)),
                lw.Cylinder(0.1, 0.3, axis=(1, 1, 0), position=(1, 2, 3)))  # fmt: skip
    for suffix in SUFFIXES:
        again = round_trip(model, tmp_path / f"model{suffix}")
        assert shape_bits(again) == shape_bits(model)


def test_shapes_of_any_orientation_come_back_moved_or_not(tmp_path: Path) -> None:
    """Moved shapes are where a matrix says, the Euler parameters of which are unit but for roundoff."""
    p = np.random.default_rng(0).standard_normal((10_000, 4))
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    boxes = [lw.Box((1, 2, 3), orientation=one) for one in p]
    pairs = zip(boxes, lw.rotation.matrix(p[::-1]), strict=True)
    model = crank_and_rod()
    model.shape("crank", *boxes)
    model.shape("rod", *(box.moved(np.zeros(3), axes) for box, axes in pairs))
    assert shape_bits(round_trip(model, tmp_path / "model.json")) == shape_bits(model)


def test_a_robot_comes_back_whose_box_is_turned_by_three_angles(tmp_path: Path) -> None:
    (tmp_path / "robot.urdf").write_text(
        '<robot name="r"><link name="base"/><link name="arm"><inertial><mass value="1"/>'
        '<inertia ixx="1" iyy="1" izz="1"/></inertial><visual><origin rpy="2.516 -0.202 -2.527"/>'
        '<geometry><box size="1 1 1"/></geometry></visual></link><joint name="j" type="continuous">'
        '<parent link="base"/><child link="arm"/></joint></robot>'
    )
    model = lw.import_urdf(tmp_path / "robot.urdf").model
    assert shape_bits(round_trip(model, tmp_path / "model.yaml")) == shape_bits(model)


def shape_bits(model: lw.Model) -> list[Any]:
    return [
        (
            bodies,
            [{what: np.asarray(x).tolist() for what, x in shape.description().items()} for shape in shapes],
        )
        for bodies, shapes in model.shapes
    ]


# --- as people write them -----------------------------------------------------------------------------------

SLIDER = """
linkwork: 1
name: crank and rod   # a comment
gravity: [0, 0, -9.81]
simulation: {t_end: 0.2, step: 1e-3, formulation: augmented_lagrangian}
functions:
  push: {harmonic: {amplitude: 5, frequency: 3}}
bodies:
  - {name: crank, mass: 1, inertia: [0.01, 0.02, 0.02], position: [0.5, 0, 0]}
  - name: rod
    mass: 2.0
    inertia: [[0.02, 0, 0], [0, 0.3, 0], [0, 0, 0.3]]
    position: [2, 0, 0]
joints:
  - {kind: revolute, name: motor pin, a: ground, b: crank, at: [0, 0, 0], axis: [0, 1, 0]}
  - {kind: spherical, a: crank, b: rod, at: [[0.5, 0, 0], [-1, 0, 0]], frames: body}
forces:
  - {kind: spring_damper, a: ground, b: rod, at: [[3, 0, 1], [3, 0, 0]], stiffness: 100}
  - {kind: applied, body: rod, force: [push, 0, {polynomial: [1, 2]}], at: [1, 0, 0]}
"""


def crank_and_rod() -> lw.Model:
    model = lw.Model(name="crank and rod")
    crank = model.body("crank", mass=1.0, inertia=(0.01, 0.02, 0.02), position=(0.5, 0, 0))
    rod = model.body("rod", mass=2.0, inertia=np.diag([0.02, 0.3, 0.3]), position=(2, 0, 0))
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=(0, 1, 0), name="motor pin")
    model.spherical(crank, rod, at=((0.5, 0, 0), (-1, 0, 0)), frames="body")
    model.spring_damper(model.ground, rod, at=((3, 0, 1), (3, 0, 0)), stiffness=100)
    push = lw.functions.harmonic(amplitude=5, frequency=3)
    model.force(rod, force=(push, 0, lw.functions.polynomial(1, 2)), at=(1, 0, 0))
    return model


def test_a_file_says_what_python_says(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(SLIDER)
    assert bits(lw.Model.load(path)) == bits(crank_and_rod())


@pytest.mark.parametrize("kind", sorted(JOINTS))
def test_every_kind_of_joint_can_be_written_as_its_method_is_called(kind: str, tmp_path: Path) -> None:
    maker = Maker(7)
    maker.body(-1)
    maker.body(0)
    element = maker.element(JOINTS[kind], 0, 1, (), "it")
    if JOINTS[kind].parameters and not element.parameters:
        element = make(7, [kind, kind]).joints[0]
    mechanism = Mechanism(np.zeros(3), tuple(maker.bodies), (), ())
    from random_mechanisms import _arguments

    arguments = _arguments(JOINTS, element)
    model = mechanism.model
    getattr(model, kind)("body 0", "body 1", frames="body", name="it", **arguments)
    document = record_of(mechanism.model, {}) | {"functions": {}}
    bodies = document["bodies"]
    plain = {what: _plain(value) for what, value in arguments.items()}
    joints = [{"kind": kind, "name": "it", "a": "body 0", "b": "body 1", "frames": "body", **plain}]
    path = tmp_path / "model.json"
    path.write_text(json.dumps({"linkwork": 1, "gravity": [0, 0, 0], "bodies": bodies, "joints": joints}))
    assert bits(lw.Model.load(path)) == bits(model)


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(part) for part in value]
    return value.tolist() if isinstance(value, np.ndarray) else _function(value)


def _function(value: Any) -> Any:
    from linkwork.modeling.files.writing import function_record

    return function_record(value, "") if isinstance(value, lw.functions.TimeFunction) else value


def test_elements_that_follow_each_other_are_as_if_added_one_by_one(tmp_path: Path) -> None:
    """Placed in space, in several kinds and forms, in one file: batches give what single calls give."""
    model = lw.Model()
    records, bodies = [], []
    for k in range(12):
        position = [float(k), 0.5 * k, 0.1]
        bodies.append({"name": f"b{k}", "mass": 1, "inertia": [1, 1, 1], "position": position})
        model.body(f"b{k}", mass=1, inertia=(1, 1, 1), position=position)
    for k in range(11):
        kind = "revolute" if k < 7 else "spherical"
        place: dict[str, Any] = {"at": [k + 0.5, 0.0, 0.0]}
        if kind == "revolute":
            place["axis"] = [0.0, 1.0, 0.1 * k]
        if k in (3, 4):
            place["x_axis"] = [1.0, 0.0, 0.0]
        named = {} if k == 9 else {"name": f"j{k}"}
        records.append({"kind": kind, "a": f"b{k}", "b": f"b{k + 1}", **place, **named})
        getattr(model, kind)(f"b{k}", f"b{k + 1}", **place, **named)
    path = tmp_path / "model.json"
    path.write_text(json.dumps({"linkwork": 1, "bodies": bodies, "joints": records}))
    assert bits(lw.Model.load(path)) == bits(model)


# --- the schema and the command line ------------------------------------------------------------------------


def test_the_schema_has_every_kind_and_refers_only_to_what_it_has() -> None:
    published = files.json_schema()
    text = json.dumps(published)
    kinds = [kind.name for kind in (*_core.joint_kinds(), *_core.force_kinds())]
    assert all(f'"const": "{kind}"' in text for kind in kinds)
    references = {word.split('"')[0] for word in text.split('"$ref": "#/$defs/')[1:]}
    assert references <= set(published["$defs"])


def test_saved_documents_obey_the_published_schema() -> None:
    validator = jsonschema.Draft202012Validator(files.json_schema())
    for model in (
        crank_and_rod(),
        make(3, sorted(JOINTS)[:8]).model,
        driven(lw.functions.table([0, 1], [1, 2])),
    ):
        validator.validate(record_of(model, {"t_end": 1.0}))
    broken = record_of(crank_and_rod(), {})
    broken["bodies"][0]["mass"] = "heavy"
    assert not validator.is_valid(broken)


def test_yaml_and_json_hold_the_same_document() -> None:
    document = record_of(crank_and_rod(), {"t_end": 1.0})
    from linkwork.modeling.files.yaml_text import YamlText

    assert (
        YamlText("".join(yaml_lines(document))).data == json.loads("".join(json_lines(document))) == document
    )


def test_settings_of_the_file_hold_on_the_command_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(SLIDER.replace("0.2, step", "0.05, step"))
    assert run(["run", str(path), "--json"], debug=False) == 0
    chosen = json.loads(capsys.readouterr().out)["manifest"]["options"]
    assert (chosen["t_end"], chosen["step"], chosen["formulation"]) == (0.05, 1e-3, "augmented_lagrangian")
    for command in (["check", str(path)], ["schema"], ["run", str(path), "--t-end", "0.01"]):
        assert run(command, debug=False) == 0, command
        assert capsys.readouterr().err == ""


def test_every_fault_is_a_line_of_its_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(SLIDER.replace("mass: 1,", "mass: -1,").replace("kind: spherical", "kind: sferical"))
    assert run(["run", str(path)], debug=False) == 1
    said = capsys.readouterr().err.splitlines()
    assert said == [
        f"error: {path}:9: bodies[0].mass: -1 is not 0 or more",
        f"error: {path}:16: joints[1].kind: 'sferical' is no kind of joint; the nearest is 'spherical'",
    ]


def test_a_failed_save_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    crank_and_rod().save(path)
    before = path.read_bytes()
    with pytest.raises(lw.ModelError):
        driven((lambda t: 1.0, lambda t: 0.0, lambda t: 0.0)).save(path, overwrite=True)
    with pytest.raises(lw.OptionError, match="t_end"):
        crank_and_rod().save(path, simulation={"tend": 1}, overwrite=True)
    assert path.read_bytes() == before and len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        ({"step": -1}, r"simulation.step: step -1 s must be a finite number, positive"),
        ({"t_end": math.inf}, r"simulation.t_end: t_end inf s"),
        ({"t_end": True}, r"simulation.t_end: t_end True s must be a finite number"),
        ({"breaks": ["a"]}, r"simulation.breaks: .*not times"),
        ({"record_every": 0}, r"simulation.record_every: .*positive whole number"),
        ({"integrator": "rk5"}, r"simulation.integrator: integrator 'rk5' does not exist"),
        ({"integrator": lw.integrators.METHODS["rk4"]}, r"integrator 'rk4' is given as its coefficients"),
        ({"formulation": "penalty", "matrix_form": "kkt"}, r"simulation.matrix_form: .*one form only"),
        ({"step": 2.0}, r"simulation.step: step 2 s is longer than the run"),
    ],
)
def test_what_no_run_takes_is_not_saved(wrong: dict[str, Any], why: str, tmp_path: Path) -> None:
    """A file with it would be refused as a whole."""
    path = tmp_path / "model.yaml"
    crank_and_rod().save(path)
    before = path.read_bytes()
    with pytest.raises(lw.OptionError, match=why):
        crank_and_rod().save(path, simulation={"t_end": 1.0, **wrong}, overwrite=True)
    assert path.read_bytes() == before


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_settings_of_numpy_are_saved_as_numbers(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"model{suffix}"
    given = {"t_end": np.float64(0.1), "step": np.float32(1e-3), "record_every": np.int64(2)}
    more = {
        "deterministic": np.True_,
        "breaks": np.array([0.5]),
        "violation_limit": {"position": np.float32(1)},
    }
    crank_and_rod().save(path, simulation={**given, **more})
    held = files.read(path, lw.Model).simulation
    assert held == {**given, "deterministic": True, "breaks": [0.5], "violation_limit": {"position": 1.0}}
    assert {type(held[name]) for name in ("t_end", "step")} == {float}


@pytest.mark.parametrize("deep", [4, 5])
def test_functions_deeper_than_files_take_are_not_saved(deep: int, tmp_path: Path) -> None:
    function = lw.functions.harmonic(0.1, 2.0, offset=1.0)
    for level in range(deep):
        function = (
            lw.functions.with_breaks(function, [level + 0.5])
            if level % 2
            else function + lw.functions.polynomial(0.0, 1e-3)
        )
    if deep == schema.SUMS:
        model = driven(function)
        assert bits(round_trip(model, tmp_path / "model.yaml")) == bits(model)
    else:
        with pytest.raises(lw.ModelError, match="more than 4 levels deep in each other"):
            driven(function).save(tmp_path / "model.yaml")


@pytest.mark.parametrize("by_command", [False, True])
def test_a_file_that_would_be_too_large_to_read_replaces_none(
    by_command: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Reading and writing have the same limit, of which JSON has more."""
    monkeypatch.setattr(base, "_force", [True])
    monkeypatch.setattr(
        syntax, "SUFFIXES", {**syntax.SUFFIXES, ".yaml": (syntax.SUFFIXES[".yaml"][0], 2**14)}
    )
    source, path = tmp_path / "chain.json", tmp_path / "model.yaml"
    lw.mechanisms.chain(5).save(path)
    before = path.read_bytes()
    lw.mechanisms.chain(200).save(source)
    why = r"has 0\.0\d+ MiB; a \.yaml file may have 0 MiB; write it as \.json"
    if by_command:
        assert run(["convert", str(source), str(path)], debug=False) == 1
        assert re.search(why, capsys.readouterr().err)
    else:
        with pytest.raises(lw.FileError, match=why):
            lw.Model.load(source).save(path, overwrite=True)
    assert path.read_bytes() == before and sorted(tmp_path.iterdir()) == [source, path]


@pytest.mark.parametrize("far", [1e160, 1e308])
@pytest.mark.parametrize("count", [1, 2])
def test_bodies_beyond_the_root_of_all_numbers_are_read_without_warnings(
    far: float, count: int, tmp_path: Path
) -> None:
    """One joint or several alike, written by hand or by a model: the square of a distance is no number."""
    bodies = [
        f"  - {{name: b{k}, mass: 1, inertia: [1, 1, 1], position: [0, 0, {far}]}}" for k in range(count)
    ]
    place = "at: [[0, 0, 0], [0, 0, 0]], frames: body, axis: [[0, 1, 0], [0, 1, 0]]"
    joints = [f"  - {{kind: revolute, name: j{k}, a: ground, b: b{k}, {place}}}" for k in range(count)]
    path = tmp_path / "far.yaml"
    path.write_text("\n".join(["linkwork: 1", "units: SI", "bodies:", *bodies, "joints:", *joints, ""]))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = lw.Model.load(path)
        assert bits(round_trip(model, tmp_path / "again.yaml")) == bits(model)
