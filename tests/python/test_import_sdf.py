"""SDF files: frames, every kind of joint, and loops, against models that are built by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.importers import sdf_scopes
from robot_files import (
    ROBOTS,
    about,
    accelerations,
    check_refused,
    check_takes_time_as_it_is_long,
    topics,
    turned,
)

FOUR_BAR = ROBOTS / "four_bar.sdf"


def four_bar() -> lw.Model:
    """The mechanism of four_bar.sdf, by hand."""
    model = lw.Model(gravity=(0, 0, -9.8))
    A = about((0, 1, 0), -1.2)
    pin = A @ [0.4, 0, 0]
    B = about((0, 1, 0), -0.3)
    crank = model.body("crank", mass=1, inertia=(0.001, 0.02, 0.02), position=A @ [0.2, 0, 0],
                       orientation=lw.rotation.from_matrix(A))  # fmt: skip
    rocker = model.body("rocker", mass=2, inertia=(0.06, 0.06, 0.002), position=(1, 0, 0.3))
    tensor = about((0, 1, 0), 0.1) @ np.diag([0.01, 0.1, 0.1]) @ about((0, 1, 0), 0.1).T
    coupler = model.body("coupler", mass=1.5, inertia=tensor, position=pin + B @ [0.4, 0, 0.05],
                         orientation=lw.rotation.from_matrix(B))  # fmt: skip
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute(model.ground, rocker, at=(1, 0, 0), axis=(0, 1, 0))
    model.revolute(crank, coupler, at=pin, axis=(0, 1, 0))
    model.revolute(coupler, rocker, at=(1, 0, 0.6), axis=(0, 1, 0))
    model.rotational_spring_damper(
        model.ground, rocker, at=(1, 0, 0), axis=(0, 1, 0), stiffness=3, free_angle=0.2
    )
    return model


def test_a_closed_loop_moves_as_the_same_mechanism_by_hand() -> None:
    imported = lw.import_sdf(FOUR_BAR)
    assert not imported.notes
    model, own = imported.model, four_bar()
    assert model.compiled().q0 == pytest.approx(own.compiled().q0, abs=1e-14)
    one, other = (lw.simulate(m, t_end=1.0, step=1e-3) for m in (model, own))
    assert np.ptp(one.q[:, 2, 5]) > 0.01  # it moves
    assert np.abs(one.q - other.q).max() < 1e-10


def loaded(tmp_path: Path, body: str, version: str = "1.9", **options: Any) -> lw.Imported:
    path = tmp_path / "model.sdf"
    path.write_text(
        f'<?xml version="1.0"?>\n<sdf version="{version}"><model name="m">\n{body}\n</model></sdf>\n'
    )
    return lw.import_sdf(path, **options)


def link(name: str, pose: str = "0 0 0 0 0 0", attributes: str = "") -> str:
    return (f'<link name="{name}"><pose {attributes}>{pose}</pose>'
            "<inertial><pose>0.1 0.2 0 0 0 0</pose><mass>2</mass>"
            "<inertia><ixx>0.2</ixx><iyy>0.3</iyy><izz>0.25</izz></inertia></inertial></link>")  # fmt: skip


def joint(name: str, type_: str, parent: str, child: str, inner: str = "") -> str:
    return (
        f'<joint name="{name}" type="{type_}"><parent>{parent}</parent><child>{child}</child>{inner}</joint>'
    )


def axis(xyz: str, rest: str = "", tag: str = "axis", attributes: str = "") -> str:
    return f"<{tag}><xyz {attributes}>{xyz}</xyz>{rest}</{tag}>"


POSE = "0.3 0.1 0.5 0.3 0.4 0.5"
A = turned(0.3, 0.4, 0.5)
R = np.array([0.3, 0.1, 0.5])


def by_hand() -> tuple[lw.Model, lw.Body]:
    model = lw.Model(gravity=(0, 0, -9.8))
    body = model.body("a", mass=2, inertia=(0.2, 0.3, 0.25), position=R + A @ [0.1, 0.2, 0],
                      orientation=lw.rotation.from_matrix(A))  # fmt: skip
    return model, body


KINDS = {
    "revolute": (axis("0 1 1"), lambda m, b: m.revolute(m.ground, b, at=R, axis=A @ [0, 1, 1])),
    "prismatic": (axis("1 1 0"), lambda m, b: m.translational(m.ground, b, at=R, axis=A @ [1, 1, 0])),
    "ball": ("", lambda m, b: m.spherical(m.ground, b, at=R)),
    "universal": (axis("1 0 0") + axis("0 1 1", tag="axis2"),
                  lambda m, b: m.universal(m.ground, b, at=R, axes=(A @ [1, 0, 0], A @ [0, 1, 1]))),
    "revolute2": (axis("1 0 0") + axis("0 0 1", tag="axis2"),
                  lambda m, b: m.universal(m.ground, b, at=R, axes=(A @ [1, 0, 0], A @ [0, 0, 1]))),
    "screw": (axis("0 0 1") + "<screw_thread_pitch>0.5</screw_thread_pitch>",
              lambda m, b: m.screw(m.ground, b, at=R, axis=A @ [0, 0, 1], pitch=0.5)),
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_joint_does_what_ours_does(kind: str, tmp_path: Path) -> None:
    inner, add = KINDS[kind]
    model, body = by_hand()
    add(model, body)
    found = loaded(tmp_path, link("a", POSE) + joint("j", kind, "world", "a", inner)).model
    assert accelerations(found) == pytest.approx(accelerations(model), rel=1e-11, abs=1e-11)


@pytest.mark.parametrize(("version", "rest", "direction"), [
    ("1.4", "", (0, 1, 1)), ("1.6", "", A @ [0, 1, 1]),
    ("1.6", "<use_parent_model_frame>1</use_parent_model_frame>", (0, 1, 1)), ("1.9", "", A @ [0, 1, 1]),
])  # fmt: skip
def test_axes_are_in_the_frame_that_the_version_says(
    version: str, rest: str, direction: Any, tmp_path: Path
) -> None:
    model, body = by_hand()
    model.revolute(model.ground, body, at=R, axis=direction)
    text = link("a", POSE) + joint("j", "revolute", "world", "a", axis("0 1 1", rest))
    assert accelerations(loaded(tmp_path, text, version).model) == pytest.approx(
        accelerations(model), rel=1e-11, abs=1e-11
    )


def test_poses_go_through_frames_degrees_and_quaternions(tmp_path: Path) -> None:
    half = np.sqrt(0.5)
    text = (
        "<pose>0 0 1 0 0 0</pose>"
        + link("a", "1 0 0 0 0 90", 'degrees="true"')
        + link("b", f"2 0 0 0 0 {half} {half}", 'relative_to="a" rotation_format="quat_xyzw"')
        + link("c", "0 3 0 0 0 0", 'relative_to="mark"')
        + '<frame name="mark" attached_to="b"><pose>0 0 4 0 0 0</pose></frame>'
    )
    model = loaded(tmp_path, text).model
    q = model.compiled().q0.reshape(-1, 7)
    # a: turned 90 degrees about z at (1, 0, 1); b: 2 m along a's x (space y), turned 180 degrees; c: 3 m
    # along b's y
    centers = [(1 - 0.2, 0.1, 1), (1 - 0.1, 2 - 0.2, 1), (1 - 0.1, 2 - 3 - 0.2, 5)]
    assert q[:, :3] == pytest.approx(np.array(centers), abs=1e-14)


def test_a_model_is_free_unless_it_is_joined_static_or_asked_otherwise(tmp_path: Path) -> None:
    free = loaded(tmp_path, link("a"))
    assert accelerations(free.model)[0] == pytest.approx([0, 0, -9.8, 0, 0, 0])
    assert loaded(tmp_path, link("a"), floating=False).model.body_count == 0
    assert loaded(tmp_path, "<static>true</static>" + link("a")).model.body_count == 0


def test_what_is_not_in_the_model_is_listed(tmp_path: Path) -> None:
    limit = "<limit><lower>-1</lower><upper>1</upper></limit>"
    text = (link("a") + '<link name="b"/>' + link("c") + '<plugin name="p"/>'
            + joint("j", "revolute", "a", "b", axis("0 0 1", limit))
            + joint("g", "gearbox", "b", "c", "<gearbox_reference_body>a</gearbox_reference_body>"
                    + axis("0 0 1") + axis("0 0 1", tag="axis2")))  # fmt: skip
    assert topics(loaded(tmp_path, text)) == [
        ("element", "<plugin>"),
        ("gearbox", "joint 'g'"),
        ("inertial", "link 'b'"),
        ("limits", "joint 'j'"),
    ]


@pytest.mark.parametrize("reversed_", [False, True])
@pytest.mark.parametrize("along", [1, -1])
def test_a_gearbox_couples_the_joints_on_its_reference_body(
    reversed_: bool, along: int, tmp_path: Path
) -> None:
    """theta_2 = -3 theta_1, from the reference body about its axes, however the joints count."""
    ends = ("rotor", "base") if reversed_ else ("base", "rotor")
    text = (link("base") + link("rotor") + link("arm", "0 0 1 0 0 0") + joint("w", "fixed", "world", "base")
            + joint("in", "revolute", *ends, axis(f"0 0 {along}"))
            + joint("out", "revolute", "base", "arm", axis("0 0 1"))
            + joint("g", "gearbox", "rotor", "arm",
                    "<gearbox_reference_body>base</gearbox_reference_body><gearbox_ratio>3</gearbox_ratio>"
                    + axis("0 0 1") + axis("0 0 1", tag="axis2")))  # fmt: skip
    imported = loaded(tmp_path, text, gravity=(3, 0, 0))
    assert not [note for note in imported.notes if note.topic == "gearbox"]
    result = lw.simulate(imported.model, t_end=0.5, step=1e-3)
    spin = result.v.reshape(len(result.t), -1, 6)[:, :, 5]
    rotor, arm = (imported.model.find(name).index for name in ("rotor", "arm"))
    assert np.abs(spin[:, arm]).max() > 0.1
    assert spin[:, arm] == pytest.approx(-3 * spin[:, rotor], abs=1e-9)


def test_axes_of_rounded_angles_are_made_parallel_where_asked(tmp_path: Path) -> None:
    text = (
        link("a")
        + link("b", "0 0 0 0 1.57 0")
        + joint("j", "revolute", "world", "a", axis("1 0 0"))
        + joint("k", "revolute", "a", "b", axis("0 0 1"))
    )
    imported = loaded(tmp_path, text, align_axes=1e-3)
    assert [note.subject for note in imported.notes if note.topic == "axis"] == ["joint 'k'"]
    frame = imported.model.compiled().joint_arrays()["frame"][1, 0]
    assert np.abs(frame[:, 2]) == pytest.approx([1, 0, 0], abs=1e-15)
    assert np.abs(loaded(tmp_path, text).model.compiled().joint_arrays()["frame"][1, 0][:, 2])[2] > 5e-4


def planar(tilt: str, last: str) -> str:
    """Crank, coupler and a third link in the x-z plane, closed by the joint `last`; the coupler is tilted."""
    y = axis("0 1 0", attributes='expressed_in="__model__"')
    return (link("crank") + link("coupler", f"0.4 0 0.3 {tilt}") + link("third", "1 0 0 0 0 0")
            + joint("a", "revolute", "world", "crank", y)
            + joint("b", "revolute", "crank", "coupler", axis("0 0 -1"))
            + joint("c", "revolute", "coupler", "third", y)
            + last)  # fmt: skip


ROCKER = joint("d", "revolute", "world", "third", "<pose>0 0 -0.6 0 0 0</pose>"
               + axis("0 1 0", attributes='expressed_in="__model__"'))  # fmt: skip
SLIDER = joint("d", "prismatic", "world", "third", axis("1 0.0008 0", attributes='expressed_in="__model__"'))


@pytest.mark.parametrize(("tilt", "last", "turned_joints"), [
    ("1.57 0 0", ROCKER, ["joint 'b'"]), ("1.5707963267948966 0 0", SLIDER, ["joint 'd'"]),
    ("1.5707963267948966 0 0", ROCKER, []),
])  # fmt: skip
def test_planar_loops_move_though_their_angles_are_rounded(
    tilt: str, last: str, turned_joints: list[str], tmp_path: Path
) -> None:
    """Axes that are parallel, or across each other, only nearly would lock a planar loop."""
    imported = loaded(tmp_path, planar(tilt, last))
    assert [note.subject for note in imported.notes if note.topic == "axis"] == turned_joints
    assert freedoms(imported.model) == 1
    literally = loaded(tmp_path, planar(tilt, last), align_axes=0).model
    assert freedoms(literally) == (0 if turned_joints else 1)


def freedoms(model: lw.Model) -> int:
    return lw.System(model).compiled().rank().degrees_of_freedom


GOOD = link("a") + "\n" + joint("j", "revolute", "world", "a", axis("0 0 1"))

WRONG = [
    ("<mass>2</mass>", "<mass>two</mass>", r":3: link 'a' mass: 'two' is not a finite number"),
    ("<mass>2</mass>", "<mass>1_000</mass>", r":3: link 'a' mass: '1_000' is not a finite number"),
    ("<xyz >0 0 1</xyz>", "<xyz>0 0 0</xyz>", r":4: joint 'j' axis: has no direction"),
    ("<xyz >0 0 1</xyz>", "<xyz>0 0</xyz>", r":4: joint 'j' axis: '0 0' is not 3"),
    ("<parent>world</parent>", "<parent>base</parent>", r":4: joint 'j' parent: no link 'base'"),
    ("<child>a</child>", "", r":4: joint 'j': child is missing"),
    ('type="revolute"', 'type="rubber"', r":4: joint 'j': type 'rubber' is not taken"),
    (
        "<pose >0 0 0 0 0 0</pose>",
        "<pose>0 0 0</pose>",
        r":3: link 'a' pose: '0 0 0' is not 6 finite numbers",
    ),
    ("<pose >0 0 0 0 0 0</pose>", '<pose relative_to="b">0 0 0 0 0 0</pose>', r"no frame 'b'"),
    (
        "<pose >0 0 0 0 0 0</pose>",
        '<pose relative_to="j">0 0 0 0 0 0</pose>',
        r"is relative to itself: a -> j -> a",
    ),
    ('<link name="a">', '<link name="a"/><link name="a">', r":3: link 'a': is given twice"),
    ("</model>", "</model><model/>", r"has 2 models"),
    ('version="1.9"', 'version="new"', r":2: sdf version: 'new' is no version, such as 1.9"),
    ('version="1.9"', 'version="1.9.1"', r":2: sdf version: '1.9.1' is no version"),
    ('version="1.9"', 'version="1_0.9"', r":2: sdf version: '1_0.9' is no version"),
    ("<pose >", '<pose degrees="yes">', r":3: link 'a' pose degrees: 'yes' is not true, false, 1 or 0"),
    ("<inertial>", "<gravity>1.0</gravity><inertial>", r":3: link 'a' gravity: '1.0' is not true"),
    ("<inertial>", '<inertial auto="maybe">', r":3: link 'a' inertial auto: 'maybe' is not true"),
    ("<link", "<static>yes</static><link", r":2: model 'm' static: 'yes' is not true"),
    (
        "<xyz >0 0 1</xyz>",
        "<xyz>0 0 1</xyz><use_parent_model_frame>on</use_parent_model_frame>",
        r":4: joint 'j' axis use_parent_model_frame: 'on' is not true",
    ),
    ("<xyz >0 0 1</xyz>", "<xyz>0 0 1</xyz><mimic joint='k'/>", r":4: joint 'j' mimic: no joint 'k'"),
    (
        "<xyz >0 0 1</xyz>",
        "<xyz>0 0 1</xyz><mimic joint='j'/>",
        r":4: joint 'j' mimic: follows itself: j -> j",
    ),
    ("<xyz >0 0 1</xyz>", "<xyz>0 0 1</xyz><mimic/>", r":4: joint 'j' mimic: joint is missing"),
    (
        "<xyz >0 0 1</xyz>",
        "<xyz>0 0 1</xyz><mimic joint='j' axis='axis3'/>",
        r":4: joint 'j' mimic axis: 'axis3' is not axis or axis2",
    ),
    (
        "<xyz >0 0 1</xyz>",
        "<xyz>0 0 1</xyz><mimic joint='j' axis='axis2'/>",
        r":4: joint 'j' mimic: joint 'j' has no second axis",
    ),
    (
        "</joint>",
        "</joint><joint name='g' type='gearbox'><parent>a</parent><child>a</child></joint>",
        r":4: joint 'g' gearbox_reference_body: is missing",
    ),
    (
        '<link name="a">',
        '<link name="b::a"/><link name="a">',
        r":3: link 'b::a': has ::, which stands behind",
    ),
    (
        "<pose >",
        '<pose rotation_format="quat_wxyz">',
        r":3: link 'a' pose: rotation_format 'quat_wxyz' is not",
    ),
    (
        "<pose >0",
        '<pose rotation_format="quat_xyzw" degrees="1">1 0',
        r":3: link 'a' pose: a quaternion is not in degrees",
    ),
    ('name="m"', 'name="m" canonical_link="b"', r":2: model 'm' canonical_link: no link 'b'"),
    (
        "<xyz >0 0 1</xyz>",
        "<xyz>0 0 1</xyz><limit><lower>inf</lower></limit>",
        r":4: joint 'j' lower: 'inf' is not a finite number",
    ),
    ('<?xml version="1.0"?>', '<!DOCTYPE sdf SYSTEM "file:///etc/passwd">', r":1: DOCTYPE is not taken"),
]


@pytest.mark.parametrize(("part", "by", "message"), WRONG)
def test_wrong_files_are_refused_with_line_and_field(
    part: str, by: str, message: str, tmp_path: Path
) -> None:
    text = f'<?xml version="1.0"?>\n<sdf version="1.9"><model name="m">\n{GOOD}\n</model></sdf>\n'
    check_refused(lw.import_sdf, tmp_path / "model.sdf", text, part, by, message)


@pytest.mark.parametrize("text", ["false", "0", "False"])
def test_links_without_gravity_are_not_pulled(text: str, tmp_path: Path) -> None:
    """In a group of links that are fixed to each other, only the weight of the others acts."""
    lift = f"<gravity>{text}</gravity>"
    bodies = link("a").replace("</link>", f"{lift}</link>")
    bodies += link("b").replace("</link>", "<gravity>1</gravity></link>")
    model = loaded(tmp_path, bodies).model
    assert accelerations(model) == pytest.approx(np.array([[0.0] * 6, [0, 0, -9.8, 0, 0, 0]]), abs=1e-14)
    glued = bodies + joint("j", "fixed", "a", "b")
    for merge in (False, True):
        found = accelerations(loaded(tmp_path, glued, merge_fixed=merge).model)
        assert found[:, 2] == pytest.approx(-4.9, abs=1e-10)


def test_true_in_capitals_is_true(tmp_path: Path) -> None:
    assert loaded(tmp_path, "<static>True</static>" + link("a")).model.body_count == 0


@pytest.mark.parametrize("q", [0.0, 3.0, np.pi, 4.0, -6.0])
def test_a_spring_is_at_rest_at_its_reference_and_not_a_turn_before(q: float, tmp_path: Path) -> None:
    """J q_ddot = k (q_s - q)"""
    spring = "<spring_stiffness>0.7</spring_stiffness><spring_reference>4</spring_reference>"
    along = axis("0 0 1", f"<dynamics>{spring}</dynamics>")
    body = link("a") + joint("x", "revolute", "world", "a", along)
    imported = loaded(tmp_path, body, coordinates={"x": q}, gravity=(0, 0, 0))
    J = 0.25 + 2 * (0.1**2 + 0.2**2)
    assert accelerations(imported.model)[0, 5] == pytest.approx(0.7 * (4 - q) / J, abs=1e-12)


@pytest.mark.parametrize(
    ("text", "falls"), [("true", 1), ("1", 1), (" TRUE ", 1), ("", 1), ("false", 0), ("0", 0)]
)
def test_links_fall_where_gravity_is_true_or_left_empty(text: str, falls: int, tmp_path: Path) -> None:
    body = link("a").replace("<inertial>", f"<gravity>{text}</gravity><inertial>")
    assert accelerations(loaded(tmp_path, body).model)[0, 2] == pytest.approx(-9.8 * falls, abs=1e-12)


@pytest.mark.parametrize(
    "thread", ["<screw_thread_pitch>0.3</screw_thread_pitch>", "<thread_pitch>-20</thread_pitch>"]
)
def test_a_screw_that_has_turned_has_advanced(thread: str, tmp_path: Path) -> None:
    """By its pitch each turn, and with its speed."""
    pitch = 0.3 if "screw" in thread else 2 * np.pi / 20
    body = link("a") + joint("s", "screw", "world", "a", axis("0 0 1") + thread)
    model = loaded(tmp_path, body, coordinates={"s": 4.0}, velocities={"s": 3.0}).model
    core = model.compiled()
    assert core.q0[2] == pytest.approx(4.0 * pitch / (2 * np.pi), abs=1e-14)
    assert core.v0[[2, 5]] == pytest.approx([3.0 * pitch / (2 * np.pi), 3.0], abs=1e-14)
    assert np.abs(lw.System(model).evaluate(0.0, core.q0, core.v0).Phi).max() < 1e-14


# --- where coordinates put links ----------------------------------------------------------------------------

BRACKET = {
    "column": joint("column", "fixed", "world", "foot"),
    "crank": joint("crank", "revolute", "world", "a", axis("0 0 1")),
    "bracket": joint("bracket", "fixed", "foot", "b"),
    "coupler": joint("coupler", "revolute", "a", "b", axis("0 0 1")),
}


@pytest.mark.parametrize("order", [("column", "crank", "bracket", "coupler"), ("crank", "coupler", "column",
                                                                               "bracket")])  # fmt: skip
def test_coordinates_leave_what_fixed_joints_hold_in_its_place(
    order: tuple[str, ...], tmp_path: Path
) -> None:
    """In whatever order the file has its joints: the last one closes the loop where the bracket is."""
    text = link("foot") + link("a") + link("b", "2 0 0 0 0 0") + "".join(BRACKET[name] for name in order)
    core = loaded(tmp_path, text, coordinates={"crank": 0.3}).model.compiled()
    k = core.find_joint("coupler")
    ends = dict(zip(core.joint_arrays()["bodies"][k].tolist(), core.joint_arrays()["origin"][k], strict=True))
    assert ends[-1] == pytest.approx([2, 0, 0], abs=1e-14)  # on the ground, which the bracket is part of


@pytest.mark.parametrize("order", ["ab", "ba"])
def test_links_that_are_fixed_to_each_other_move_as_one(order: str, tmp_path: Path) -> None:
    """Their inertia is that of the file's poses, whichever of them a chain with coordinates leads to."""
    parents = {"a": "world", "b": "crank"}
    text = (
        *(link("crank"), link("a", "2 0 0 0 0 0"), link("b", "2 1 0 0 0 0")),
        *(joint(f"to {name}", "revolute", parents[name], name, axis("0 0 1")) for name in order),
        joint("pin", "revolute", "world", "crank", axis("0 0 1")) + joint("weld", "fixed", "a", "b"),
    )
    still, moved = (
        loaded(tmp_path, "".join(text), merge_fixed=True, coordinates=q).model.compiled()
        for q in ({}, {"pin": 0.3})
    )
    assert moved.inertia == pytest.approx(still.inertia, rel=1e-12)
    assert still.mass.tolist() == [2, 4]


HANGING = (link("a") + link("b", "1 0 0 0.3 0.2 0.1") + joint("pin", "revolute", "world", "a", axis("0 0 1"))
           + joint("up", "revolute", "b", "a", "<pose>0.5 0.1 0 0 0 0</pose>" + axis("0.3 0 1")))  # fmt: skip


def test_a_joint_may_have_its_parent_farther_from_the_ground_than_its_child(tmp_path: Path) -> None:
    imported = loaded(
        tmp_path, HANGING, coordinates={"pin": 0.6, "up": 0.3}, velocities={"pin": 2.0, "up": -1.0}
    )
    result = lw.simulate(imported.model, t_end=0.01, step=1e-3)  # which begins with all joints closed
    for name, value, rate in (("pin", 0.6, 2.0), ("up", 0.3, -1.0)):
        found = result.coordinate(name)
        assert (found.value[0], found.rate[0]) == pytest.approx((value, rate), abs=1e-12)


def test_what_a_joint_carries_the_other_way_round_is_not_fixed_to_the_ground(tmp_path: Path) -> None:
    assert loaded(tmp_path, HANGING, floating=False).model.body_count == 2


def test_a_stop_of_a_joint_the_other_way_round_carries_its_parent(tmp_path: Path) -> None:
    """k = (100 rad/s)^2 J, of a link of 2 kg alone, whose center of mass is 0.7 m from the axis."""
    limit = "<limit><lower>-1</lower><upper>1</upper></limit>"
    up = joint("up", "revolute", "b", "a", "<pose>0.4 0.2 0 0 0 0</pose>" + axis("0 0 1", limit))
    text = link("a") + link("b", "1 0 0 0 0 0") + joint("pin", "revolute", "world", "a", axis("0 0 1"))
    (note,) = loaded(tmp_path, text + up, limits="stops").notes
    stiffness = 1e4 * (0.25 + 2 * 0.7**2)
    assert str(note) == f"joint 'up': limits -1 to 1 rad are stops of {stiffness:.3g} N m/rad"


def test_a_stop_of_a_joint_that_closes_a_loop_knows_where_it_starts(tmp_path: Path) -> None:
    """A parallelogram: what its cranks turn by, their pins on the coupler turn back."""
    limit = "<limit><lower>-0.2</lower><upper>0.2</upper></limit>"
    text = (
        *(link("a"), link("b", "0 1 0 0 0 0"), link("c", "2 0 0 0 0 0")),
        joint("left", "revolute", "world", "a", axis("0 0 1")),
        joint("right", "revolute", "world", "c", axis("0 0 1")),
        joint("closing", "revolute", "a", "b", axis("0 0 1", limit)),
        joint("coupler", "revolute", "c", "b", "<pose>2 0 0 0 0 0</pose>" + axis("0 0 1")),
    )
    start = {"left": 0.5, "right": 0.5, "coupler": -0.5}
    notes = loaded(tmp_path, "".join(text), limits="stops", coordinates=start).notes
    assert [str(note).partition("; ")[2] for note in notes] == ["it starts 0.3 beyond: give `coordinates`"]


def test_a_stop_of_a_joint_that_closes_a_loop_at_the_ground_carries_the_other_link(tmp_path: Path) -> None:
    """k = (100 rad/s)^2 J about the axis in its pose; its child is fixed to the ground."""
    limit = "<limit><lower>-1</lower><upper>1</upper></limit>"
    text = (
        *(link("a"), link("c", "2 0 0 0 0 0"), link("post", "2 0 -1 0 0 0")),
        joint("left", "revolute", "world", "a", axis("0 0 1")),
        joint("coupler", "revolute", "a", "c", axis("0 0 1")),
        joint("foot", "fixed", "world", "post"),
        joint("right", "revolute", "c", "post", "<pose>0.4 0.2 0 0 0 0</pose>" + axis("0 0 1", limit)),
    )
    notes = loaded(tmp_path, "".join(text), limits="stops").notes
    (found,) = (str(note) for note in notes if note.topic == "limits")
    stiffness = 1e4 * (0.25 + 2 * 0.3**2)
    assert found == f"joint 'right': limits -1 to 1 rad are stops of {stiffness:.3g} N m/rad"


def test_the_angles_of_a_universal_joint_are_those_of_the_file(tmp_path: Path) -> None:
    text = link("a") + joint("u", "universal", "world", "a", axis("1 0 0") + axis("0 1 0", tag="axis2"))
    model = loaded(tmp_path, text, coordinates={"u": (0.4, -0.2)}).model
    result = lw.simulate(model, t_end=0.01, step=1e-3)
    starts = [result.coordinate("u", which).value[0] for which in ("angle_a", "angle_b")]
    assert starts == pytest.approx([0.4, -0.2], abs=1e-14)


# --- what is not taken as it is written ---------------------------------------------------------------------


def test_a_link_in_a_model_is_not_one_of_an_old_file_that_is_called_so(tmp_path: Path) -> None:
    """Before 1.8 names could have ::, and two links the same full name."""
    with pytest.raises(lw.ModelFileError, match="link 'm::a': is the full name of another, too"):
        loaded(tmp_path, link("m::a") + f'<model name="m">{link("a")}</model>', version="1.7")


def test_a_mimic_names_the_axis_that_it_follows(tmp_path: Path) -> None:
    """The first of a hinge; the second of a universal joint is none that a coupler has, which is noted."""

    def read(which: str, type_: str) -> lw.Imported:
        leader = axis("0 1 0") + axis("0 0 1", tag="axis2") * (which == "axis2")
        mimic = axis("0 1 0", f"<mimic joint='j' axis='{which}'><multiplier>2</multiplier></mimic>")
        joints = joint("j", type_, "world", "a", leader) + joint("k", "revolute", "world", "b", mimic)
        return loaded(tmp_path, link("a") + link("b") + joints, "1.11")

    result = lw.simulate(read("axis", "revolute").model, t_end=0.2, step=1e-2)
    leader, follower = (result.coordinate(name).rate for name in "jk")
    assert abs(leader[-1]) > 0.1
    assert follower == pytest.approx(2 * leader, abs=1e-8)
    assert topics(read("axis", "revolute")) == []
    ((topic, subject),) = topics(read("axis2", "universal"))
    assert (topic, subject) == ("mimic", "joint 'k'")


def test_what_a_gearbox_and_a_fixed_joint_have_besides_is_noted(tmp_path: Path) -> None:
    more = "<dynamics><damping>7</damping></dynamics><limit><lower>-1</lower><upper>1</upper></limit>"
    text = (link("a") + link("b") + link("c") + joint("w", "fixed", "world", "a", axis("0 0 1", more))
            + joint("j", "revolute", "a", "b", axis("0 0 1"))
            + joint("k", "revolute", "a", "c", axis("0 0 1"))
            + joint("g", "gearbox", "b", "c", "<gearbox_reference_body>a</gearbox_reference_body><physics/>"
                    + axis("0 0 1", more) + axis("0 0 1", tag="axis2") + '<sensor name="s"/>'))  # fmt: skip
    found = {(note.topic, note.subject) for note in loaded(tmp_path, text).notes}
    gear, weld = "joint 'g'", "joint 'w'"
    assert found >= {("dynamics", gear), ("limit", gear), ("physics", gear), ("sensor", gear),
                     ("dynamics", weld), ("limit", weld)}  # fmt: skip


@pytest.mark.parametrize(("version", "notes"), [("1.6", 0), ("1.7", 1), ("1.9", 1)])
def test_an_axis_in_the_model_frame_is_noted_where_the_version_has_none(
    version: str, notes: int, tmp_path: Path
) -> None:
    rest = "<use_parent_model_frame>true</use_parent_model_frame>"
    text = link("a", POSE) + joint("j", "revolute", "world", "a", axis("0 0 1", rest))
    assert [str(note) for note in loaded(tmp_path, text, version).notes] == notes * [
        "joint 'j': use_parent_model_frame of its axis is not taken: there is none since SDF 1.7"
    ]


def test_limits_that_are_infinite_are_none(tmp_path: Path) -> None:
    limit = "<limit><lower>-inf</lower><upper>inf</upper><effort>inf</effort></limit>"
    text = link("a") + joint("j", "revolute", "world", "a", axis("0 0 1", limit))
    imported = loaded(tmp_path, text, "1.11", limits="stops")
    assert (imported.notes, imported.model.force_count) == ((), 0)


@pytest.mark.parametrize("size", ["1e200", "1e-200", "3"])
def test_quaternions_and_axes_may_have_any_length(size: str, tmp_path: Path) -> None:
    pose = link("a", f"0 0 0 {size} 0 0 {size}", 'rotation_format="quat_xyzw"')
    text = pose + joint("j", "revolute", "world", "a", axis(f"0 {size} -{size}"))
    core = loaded(tmp_path, text).model.compiled()
    assert core.q0[3:] == pytest.approx([0.5**0.5, 0.5**0.5, 0, 0], abs=1e-15)
    assert core.joint_arrays()["frame"][0, 1, :, 2] == pytest.approx([0, 0.5**0.5, -(0.5**0.5)], abs=1e-15)


PHYSICS = '<physics type="ode" {}><gravity>0 0 {}</gravity></physics>'

#: Version, what the world has, its gravity, and lines with gravity that is not taken.
FALLS = [
    ("1.5", PHYSICS.format("", -1.62), -1.62, []),
    ("1.4", '<physics type="ode"/>', -9.8, []),
    ("1.5", PHYSICS.format("", -1) + "\n" + PHYSICS.format('default="true"', -2), -2, [2]),
    ("1.5", PHYSICS.format("", -1) + "<gravity>0 0 -3</gravity>", -3, [2]),
    ("1.6", PHYSICS.format("", -1.62), -9.8, [2]),
    ("1.9", PHYSICS.format("", -1.62) + "<gravity>0 0 -3</gravity>", -3, [2]),
]


@pytest.mark.parametrize(("version", "inner", "g", "lines"), FALLS)
def test_gravity_is_of_physics_before_version_1_6_and_of_the_world_from_then_on(
    version: str, inner: str, g: float, lines: list[int], tmp_path: Path
) -> None:
    path = tmp_path / "world.sdf"
    path.write_text(f'<sdf version="{version}"><world name="w">\n{inner}<model name="m">{link("a")}'
                    "</model></world></sdf>")  # fmt: skip
    imported = lw.import_sdf(path)
    assert accelerations(imported.model)[0] == pytest.approx([0, 0, g, 0, 0, 0])
    said = [note.message for note in imported.notes if note.subject == "<gravity>"]
    assert [text.split(",")[0] for text in said] == [f"in line {line}" for line in lines]


def test_a_link_named_ground_has_a_free_name_and_one_with_a_tab_has_a_space(tmp_path: Path) -> None:
    text = link("ground") + link("a&#9;b") + joint("j", "revolute", "ground", "a&#9;b", axis("0 0 1"))
    imported = loaded(tmp_path, text)
    assert [imported.model.compiled().body_name(k) for k in range(2)] == ["ground 2", "a b"]
    assert topics(imported) == [("name", "link 'a b'"), ("name", "link 'ground'")]


SPRING = "<dynamics><spring_stiffness>0.7</spring_stiffness></dynamics>"

#: What acts on the joint that closes a loop, options, and whether its angle is noted.
CLOSING = [
    ("", {}, 0),
    (SPRING, {}, 1),
    ("<limit><lower>-1</lower><upper>1</upper></limit>", {}, 0),
    ("<limit><lower>-1</lower><upper>1</upper></limit>", {"limits": "stops"}, 1),
    ('<mimic joint="left"><multiplier>-1</multiplier></mimic>', {}, 1),
    ('<mimic joint="left"><multiplier>-1</multiplier></mimic>', {"couple": False}, 0),
]


@pytest.mark.parametrize(("acting", "options", "count"), CLOSING)
@pytest.mark.parametrize(("turned", "beyond"), [(3.5, True), (0.5, False)])
def test_the_angle_of_a_joint_that_closes_a_loop_is_noted_where_it_may_be_another(
    turned: float, beyond: bool, acting: str, options: Any, count: int, tmp_path: Path
) -> None:
    """A parallelogram turned by more than half a turn: its last pin is turned back by as much."""
    text = (
        *(link("a"), link("b", "0 1 0 0 0 0"), link("c", "2 0 0 0 0 0")),
        joint("left", "revolute", "world", "a", axis("0 0 1")),
        joint("right", "revolute", "world", "c", axis("0 0 1")),
        joint("coupler", "revolute", "c", "b", "<pose>2 0 0 0 0 0</pose>" + axis("0 0 1")),
        joint("closing", "revolute", "a", "b", axis("0 0 1", acting)),
    )
    start = {"left": turned, "right": turned, "coupler": -turned}
    notes = loaded(tmp_path, "".join(text), coordinates=start, **options).notes
    said = [str(note) for note in notes if "within a turn:" in note.message]
    expected = f"closes a loop: its coordinate is taken within a turn: {2 * np.pi - turned:.6g} rad"
    assert said == [f"joint 'closing': {expected}"] * (count * beyond)


def test_a_link_without_weight_is_noted_to_have_it_in_the_potential_energy(tmp_path: Path) -> None:
    light = link("a").replace("<inertial>", "<gravity>false</gravity><inertial>")
    text = "force 'a lift' takes 1 of its weight and does work: the weight stays in the potential energy"
    assert [str(note) for note in loaded(tmp_path, light).notes] == [f"link 'a': {text}"]
    assert not loaded(tmp_path, light, gravity=(0, 0, 0)).notes


@pytest.mark.parametrize("limits", ["note", "stops"])
def test_limits_of_a_continuous_joint_are_noted_not_taken(limits: Any, tmp_path: Path) -> None:
    limit = "<limit><lower>-1</lower><upper>inf</upper><effort>3</effort></limit>"
    text = link("a") + joint("j", "continuous", "world", "a", axis("0 0 1", limit))
    imported = loaded(tmp_path, text.replace("inf", "1"), limits=limits)
    assert imported.model.compiled().force_count == 0
    said = "joint 'j': limits lower -1, upper 1, effort 3 are not represented"
    assert [str(note) for note in imported.notes] == [said]
    assert str(loaded(tmp_path, text, limits=limits).notes[0]) == said.replace(" upper 1,", "")


@pytest.mark.parametrize(("type_", "unused"), [
    ("revolute", ["axis2", "thread_pitch", "gearbox_ratio"]),
    ("fixed", ["axis2", "thread_pitch", "gearbox_ratio"]),
    ("universal", ["thread_pitch", "gearbox_ratio"]), ("screw", ["axis2", "gearbox_ratio"]),
])  # fmt: skip
def test_what_only_joints_of_other_types_have_is_noted(type_: str, unused: list[str], tmp_path: Path) -> None:
    inner = axis("1 0 0") + axis("0 1 0", tag="axis2") + "<gearbox_ratio>2</gearbox_ratio>"
    text = link("a") + joint("j", type_, "world", "a", inner + "<thread_pitch>3</thread_pitch>")
    said = {str(note) for note in loaded(tmp_path, text).notes if note.subject == "joint 'j'"}
    assert {it for it in said if f"of a {type_} joint is not represented" in it} == {
        f"joint 'j': its {tag} of a {type_} joint is not represented" for tag in unused
    }


def test_a_joint_of_a_link_with_itself_is_noted(tmp_path: Path) -> None:
    for type_, inner in (("fixed", ""), ("revolute", axis("0 0 1"))):
        imported = loaded(tmp_path, link("a") + joint("j", type_, "a", "a", inner))
        assert imported.model.joint_count == 0
        assert [str(note) for note in imported.notes] == [
            "joint 'j': joins a link with itself: it is left out"
        ]


@pytest.mark.parametrize(("version", "known"), [("1.2", True), ("1.12", True), ("1.13", False),
                                                ("1.99", False), ("2.0", False)])  # fmt: skip
def test_versions_beyond_those_that_are_known_are_noted(version: str, known: bool, tmp_path: Path) -> None:
    said = [str(note) for note in loaded(tmp_path, link("a"), version).notes if note.topic == "version"]
    assert said == [f"sdf: {version} is not known here: read as 1.12"] * (not known)


@pytest.mark.parametrize("version", ["0.9", "1.0", "1.1"])
def test_versions_of_other_elements_are_refused(version: str, tmp_path: Path) -> None:
    """In SDF 1.0 the mass is an attribute of <inertial>."""
    with pytest.raises(lw.ModelFileError, match=f":2: sdf version: {version} .*convert .* by `gz sdf -p`"):
        loaded(tmp_path, '<link name="a"><inertial mass="7"/></link>', version)


def test_frames_along_a_line_take_time_as_it_is_long(tmp_path: Path) -> None:
    def read(count: int) -> None:
        frames = [f'<frame name="f{k + 1}" attached_to="f{k}"/>' for k in range(count)]
        joints = (link(f"l{k}") + joint(f"j{k}", "ball", f"f{k}", f"l{k}") for k in range(1, count))
        loaded(tmp_path, link("l0") + '<frame name="f0" attached_to="l0"/>' + "".join([*frames, *joints]))

    check_takes_time_as_it_is_long(read, sdf_scopes)
