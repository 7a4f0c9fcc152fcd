"""URDF files: the mechanism that comes out moves by the equations of the robot that the file describes."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.importers import stops
from robot_files import ROBOTS, accelerations, check_refused, check_takes_time_as_it_is_long, topics, turned

G = 9.81


def loaded(tmp_path: Path, body: str, **options: Any) -> lw.Imported:
    path = tmp_path / "robot.urdf"
    path.write_text(f'<?xml version="1.0"?>\n<robot name="test">\n{body}\n</robot>\n')
    return lw.import_urdf(path, **options)


# --- an arm of two rods in a vertical plane, in closed form -------------------------------------------------
#
# Angles q1, q2 (relative) about y from the x axis; masses m, lengths l, centers at a, moments J about y:
#   M = [J1 + m1 a1^2 + m2 l1^2 + J2 + m2 a2^2 + 2 m2 l1 a2 c2,  J2 + m2 a2^2 + m2 l1 a2 c2; ., J2 + m2 a2^2]
#   h = m2 l1 a2 s2 [-(2 w1 w2 + w2^2), w1^2],   heights z = -a sin q:  tau_g = -dV/dq

ARM = ROBOTS / "arm.urdf"
M1, L1, A1, J1 = 2.0, 0.8, 0.3, 0.05
M2, A2, J2 = 1.5, 0.45, 0.04
D1, D2 = 0.0, 0.7


def closed_form(q: np.ndarray, w: np.ndarray) -> np.ndarray:
    c2, s2 = np.cos(q[1]), np.sin(q[1])
    m12 = J2 + M2 * A2**2 + M2 * L1 * A2 * c2
    M = np.array([[J1 + M1 * A1**2 + M2 * (L1**2 + L1 * A2 * c2) + m12, m12], [m12, J2 + M2 * A2**2]])
    h = M2 * L1 * A2 * s2 * np.array([-(2 * w[0] * w[1] + w[1] ** 2), w[0] ** 2])
    both = M2 * G * A2 * np.cos(q[0] + q[1])
    gravity = np.array([(M1 * A1 + M2 * L1) * G * np.cos(q[0]) + both, both])
    return np.linalg.solve(M, gravity - h - np.array([D1, D2]) * w)


@pytest.mark.parametrize("q", [(0.0, 0.0), (0.4, -1.1), (-2.0, 2.5)])
@pytest.mark.parametrize("w", [(0.0, 0.0), (3.0, -5.0)])
def test_an_arm_accelerates_as_its_equations_say(q: tuple[float, float], w: tuple[float, float]) -> None:
    names = ("shoulder", "elbow")
    model = lw.import_urdf(ARM, coordinates=dict(zip(names, q, strict=True)),
                           velocities=dict(zip(names, w, strict=True))).model  # fmt: skip
    expected = closed_form(np.array(q), np.array(w))
    v_dot = accelerations(model)
    upper, lower = model.find("upper").index, model.find("lower").index
    # body axes of both have y along the joints
    found = np.array([v_dot[upper, 4], v_dot[lower, 4] - v_dot[upper, 4]])
    assert found == pytest.approx(expected, rel=1e-10, abs=1e-10)


def test_links_are_where_the_coordinates_put_them() -> None:
    q, w = np.array([0.3, 0.9]), np.array([1.0, -2.0])
    model = lw.import_urdf(ARM, coordinates={"shoulder": q[0], "elbow": q[1]},
                           velocities={"shoulder": w[0], "elbow": w[1]}).model  # fmt: skip
    k = model.find("lower").index
    angle, rate = q.sum(), w.sum()
    x_1, x_2 = np.array([np.cos(q[0]), 0, -np.sin(q[0])]), np.array([np.cos(angle), 0, -np.sin(angle)])
    z_1, z_2 = np.array([-np.sin(q[0]), 0, -np.cos(q[0])]), np.array([-np.sin(angle), 0, -np.cos(angle)])
    core = model.compiled()
    assert core.q0.reshape(-1, 7)[k, :3] == pytest.approx([0, 0, 1] + L1 * x_1 + A2 * x_2, abs=1e-14)
    velocity = L1 * w[0] * z_1 + A2 * rate * z_2
    assert core.v0.reshape(-1, 6)[k] == pytest.approx([*velocity, 0, rate, 0], abs=1e-13)


def test_coordinates_of_the_result_are_those_of_the_file() -> None:
    result = lw.simulate(
        lw.import_urdf(ARM, coordinates={"shoulder": 0.3, "elbow": -0.8}).model, t_end=0.01, step=1e-3
    )
    assert result.coordinate("shoulder").value[0] == pytest.approx(0.3, abs=1e-14)
    assert result.coordinate("elbow").value[0] == pytest.approx(-0.8, abs=1e-14)


def test_what_is_not_in_the_model_is_listed() -> None:
    imported = lw.import_urdf(ARM)
    assert topics(imported) == [
        ("base", "link 'base'"), ("collision", "link 'lower'"), ("element", "<transmission>"),
        ("limits", "joint 'elbow'"), ("merged", "massless link 'tool'"),
    ]  # fmt: skip
    with pytest.warns(lw.LinkworkWarning, match=r"limits \(1\)"):
        imported.warn()


# --- inertias and rigid groups ------------------------------------------------------------------------------

LINK = '<link name="{0}"><inertial><origin xyz="{1}" rpy="{2}"/><mass value="{3}"/>' \
       '<inertia ixx="0.3" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.15"/></inertial></link>'  # fmt: skip


def link(name: str, xyz: str = "0 0 0", rpy: str = "0 0 0", mass: float = 1.0) -> str:
    return LINK.format(name, xyz, rpy, mass)


def joint(name: str, type_: str, parent: str, child: str, inner: str = "") -> str:
    return (
        f'<joint name="{name}" type="{type_}"><parent link="{parent}"/><child link="{child}"/>{inner}</joint>'
    )


def test_the_frame_of_the_inertial_turns_the_tensor(tmp_path: Path) -> None:
    body = (
        link("base") + link("arm", "0.1 0.2 0.3", "0.3 -0.5 0.7") + joint("hinge", "revolute", "base", "arm")
    )
    model = loaded(tmp_path, body).model
    A = turned(0.3, -0.5, 0.7)
    assert model.compiled().inertia[0] == pytest.approx(A @ np.diag([0.3, 0.2, 0.15]) @ A.T, abs=1e-15)
    assert model.compiled().q0[:3] == pytest.approx([0.1, 0.2, 0.3])


@pytest.mark.parametrize("merge_fixed", [False, True])
def test_fixed_links_move_as_one(merge_fixed: bool, tmp_path: Path) -> None:
    """Two links fixed to each other, against one body with the sum of their inertias (Steiner), swinging."""
    place = '<origin xyz="0.4 0.1 -0.2" rpy="0.2 0.4 -0.6"/>'
    axis = '<origin xyz="0 0 0"/><axis xyz="0 1 0"/>'
    body = (link("base") + link("arm", "0.2 0 0", mass=2.0) + link("hand", "0 0.1 0")
            + joint("hinge", "revolute", "base", "arm", axis)
            + joint("weld", "fixed", "arm", "hand", place))  # fmt: skip
    model = loaded(tmp_path, body, merge_fixed=merge_fixed, velocities={"hinge": 2.0}).model
    assert model.body_count == (1 if merge_fixed else 2)
    A = turned(0.2, 0.4, -0.6)
    hand = np.array([0.4, 0.1, -0.2]) + A @ [0, 0.1, 0]
    about_y = 0.2 + 2.0 * 0.2**2 + (A @ np.diag([0.3, 0.2, 0.15]) @ A.T)[1, 1] + hand[0] ** 2 + hand[2] ** 2
    moment = G * (2.0 * 0.2 + hand[0])  # about y: z x (-g) turns x toward -z
    assert accelerations(model)[0, 4] == pytest.approx(moment / about_y, rel=1e-11)


def test_massless_links_between_fixed_joints_are_frames(tmp_path: Path) -> None:
    origin = '<origin xyz="{} 0 0"/>'
    axis = '<axis xyz="0 1 0"/>'
    body = (link("base") + link("a", "0.5 0 0") + '<link name="flange"/><link name="mount"/>'
            + link("b", "0.25 0 0") + joint("j1", "revolute", "base", "a", axis)
            + joint("f1", "fixed", "a", "flange", origin.format(0.6))
            + joint("f2", "fixed", "flange", "mount", origin.format(0.4))
            + joint("j2", "revolute", "mount", "b", axis))  # fmt: skip
    imported = loaded(tmp_path, body)
    core = imported.model.compiled()
    assert [core.body_name(k) for k in range(core.body_count)] == ["a", "b"]
    assert core.q0.reshape(-1, 7)[:, 0] == pytest.approx([0.5, 1.25])
    assert [note.subject for note in imported.notes if note.topic == "merged"] == [
        "massless link 'flange'",
        "massless link 'mount'",
    ]


def test_a_part_without_mass_gives_its_moments_of_inertia(tmp_path: Path) -> None:
    """A rotor that a file describes by moments alone."""
    turn = '<origin xyz="1 2 3" rpy="0 0 1.5707963267948966"/>'
    body = (link("base") + link("arm") + link("rotor", mass=0.0) + joint("j", "revolute", "base", "arm")
            + joint("f", "fixed", "arm", "rotor", turn))  # fmt: skip
    core = loaded(tmp_path, body).model.compiled()
    assert (core.body_count, core.mass[0]) == (1, 1.0)
    assert core.inertia[0] == pytest.approx(np.diag([0.5, 0.5, 0.3]), abs=1e-15)
    assert core.q0[:3] == pytest.approx([0, 0, 0])


def test_a_floating_base_falls(tmp_path: Path) -> None:
    body = (
        '<link name="root"/>' + link("trunk", "0.1 0 0.3", mass=5) + joint("root", "fixed", "root", "trunk")
    )
    model = loaded(tmp_path, body, floating=True, gravity=(1.0, 2.0, 3.0)).model
    assert model.joint_count == 0
    assert accelerations(model)[0] == pytest.approx([1, 2, 3, 0, 0, 0], abs=1e-14)


def test_a_slider_with_damping_and_friction_slows_as_they_say(tmp_path: Path) -> None:
    inner = '<origin rpy="0 0 0.7"/><axis xyz="2 0 0"/><dynamics damping="3" friction="0.5"/>'
    body = link("base") + link("cart", mass=2.0) + joint("rail", "prismatic", "base", "cart", inner)
    imported = loaded(tmp_path, body, velocities={"rail": 4.0})
    along = np.array([np.cos(0.7), np.sin(0.7), 0])
    assert accelerations(imported.model)[0, :3] == pytest.approx(
        -(3 * 4 + 0.5) / 2 * along, rel=1e-12, abs=1e-12
    )
    assert ["regularized" in note.message for note in imported.notes if note.topic == "friction"] == [True]


def test_a_joint_that_mimics_is_coupled(tmp_path: Path) -> None:
    """q_b = m q_a + c: (J_a + m^2 J_b) a = T_a + m T_b, T = -M g r cos(q) of gravity along -y."""
    axis = '<axis xyz="0 0 1"/>'
    m, c = -2.0, 0.1
    body = (link("base") + link("a", "0.2 0 0", mass=3) + link("b", "0.4 0 0", mass=2)
            + joint("left", "revolute", "base", "a", axis)
            + joint("right", "revolute", "base", "b",
                    axis + f'<mimic joint="left" multiplier="{m}" offset="{c}"/>'))  # fmt: skip
    imported = loaded(tmp_path, body, coordinates={"left": 0.3}, velocities={"left": 1.0}, gravity=(0, -G, 0))
    assert topics(imported) == [("base", "link 'base'")]
    model = imported.model
    q, v = model.compiled().q0.reshape(-1, 7), model.compiled().v0.reshape(-1, 6)
    angles = np.array([0.3, m * 0.3 + c])
    assert 2 * np.arctan2(q[:, 6], q[:, 3]) == pytest.approx(angles) and v[:, 5] == pytest.approx([1.0, m])
    J = 0.15 + np.array([3, 2]) * np.array([0.2, 0.4]) ** 2
    T = -G * np.array([3 * 0.2, 2 * 0.4]) * np.cos(angles)
    a = (T[0] + m * T[1]) / (J[0] + m**2 * J[1])
    assert accelerations(model)[:, 5] == pytest.approx([a, m * a], rel=1e-11)
    result = lw.simulate(model, t_end=2.0, step=1e-3)
    left, right = (result.coordinate(name).value for name in ("left", "right"))
    assert np.ptp(left) > 0.5 and np.abs(right - m * left - c).max() < 1e-9


def test_a_joint_that_mimics_moves_freely_where_that_is_asked_for(tmp_path: Path) -> None:
    body = (link("base") + link("a") + link("b") + joint("left", "revolute", "base", "a")
            + joint("right", "revolute", "base", "b", '<mimic joint="left"/>'))  # fmt: skip
    imported = loaded(tmp_path, body, couple=False)
    assert ("mimic", "joint 'right'") in topics(imported) and imported.model.row_count == 10


def test_a_slider_that_follows_an_angle_is_a_rack(tmp_path: Path) -> None:
    """x = r q: (J + r^2 m) a = -r f, where the slider is held by friction in part."""
    body = (link("base") + link("wheel") + link("rack", mass=2)
            + joint("hinge", "continuous", "base", "wheel", '<axis xyz="0 0 1"/>')
            + joint("slide", "prismatic", "base", "rack", '<axis xyz="1 0 0"/><mimic joint="hinge" '
                    'multiplier="0.3"/><dynamics damping="0.7"/>'))  # fmt: skip
    model = loaded(tmp_path, body, velocities={"hinge": 4.0}, gravity=(0, 0, 0)).model
    a = -0.3 * 0.7 * (0.3 * 4.0) / (0.15 + 0.3**2 * 2)
    v_dot = accelerations(model)
    assert (v_dot[0, 5], v_dot[1, 0]) == pytest.approx((a, 0.3 * a), rel=1e-11)


def test_a_joint_that_follows_one_that_cannot_move_is_listed(tmp_path: Path) -> None:
    body = (link("base") + link("a") + '<link name="frame"/>'
            + joint("still", "fixed", "base", "frame") + joint("hinge", "revolute", "base", "a",
                    '<mimic joint="still"/>'))  # fmt: skip
    (note,) = (note for note in loaded(tmp_path, body).notes if note.topic == "mimic")
    assert note.subject == "joint 'hinge'" and "'still' has no coordinate" in note.message


def test_inertias_of_no_body_are_refused_or_made_the_nearest(tmp_path: Path) -> None:
    bad = link("arm").replace('izz="0.15"', 'izz="0.9"')
    body = link("base") + bad + joint("hinge", "revolute", "base", "arm")
    with pytest.raises(lw.ModelFileError, match=r"link 'arm': .*triangle inequality.*repair_inertia"):
        loaded(tmp_path, body)
    imported = loaded(tmp_path, body, repair_inertia=True)
    assert np.diag(imported.model.compiled().inertia[0]) == pytest.approx([0.5, 0.4, 0.9])
    assert [note.topic for note in imported.notes].count("inertia") == 1
    for huge in ("1e308", "1.7e308"):
        with pytest.raises(lw.ModelFileError, match="link 'arm'"):
            loaded(tmp_path, body.replace('izz="0.9"', f'izz="{huge}"'))


def test_moving_links_without_inertia_are_named(tmp_path: Path) -> None:
    body = (
        link("base")
        + '<link name="ghost"/>'
        + link("a")
        + joint("j1", "revolute", "base", "ghost")
        + joint("j2", "revolute", "ghost", "a")
    )
    with pytest.raises(lw.ModelFileError, match=r"robot.urdf:4: link 'ghost': moves but has no mass"):
        loaded(tmp_path, body.replace('<link name="ghost"/>', '\n<link name="ghost"/>'))
    imported = loaded(tmp_path, body, keep_massless=True)
    assert imported.model.body_count == 2
    assert ("massless", "link 'ghost'") in {(note.topic, note.subject) for note in imported.notes}


def test_a_root_named_world_is_the_ground(tmp_path: Path) -> None:
    body = link("world", mass=7.0) + link("a") + joint("j", "revolute", "world", "a")
    model = loaded(tmp_path, body, floating=True).model
    assert (model.body_count, model.row_count) == (1, 5)


@pytest.mark.parametrize(("world", "floating", "said"), [
    (link("world", mass=7.0), True,
     ["it does not float, nor what is fixed to it", "its mass 7 is not represented"]),
    (link("world", mass=7.0), False, ["its mass 7 is not represented"]),
    ('<link name="world"/>', True, ["it does not float, nor what is fixed to it"]),
    ('<link name="world"/>', None, []),
])  # fmt: skip
def test_what_a_root_named_world_does_not_have_is_noted(
    world: str, floating: bool | None, said: list[str], tmp_path: Path
) -> None:
    imported = loaded(tmp_path, world + link("a") + joint("j", "revolute", "world", "a"), floating=floating)
    found = [str(note) for note in imported.notes if "by its name" in str(note)]
    assert found == [f"link 'world': is the ground by its name: {text}" for text in said]


@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
@pytest.mark.parametrize("limits", ["note", "stops"])
@pytest.mark.parametrize("ends", ['lower="0" upper="0"', ""])
def test_limits_that_lock_a_joint_are_noted(kind: str, limits: str, ends: str, tmp_path: Path) -> None:
    """Ends that are not given are zero."""
    limit = f'<limit {ends} effort="5" velocity="1"/>'
    body = link("base") + link("a") + joint("j", kind, "base", "a", limit)
    unit = "rad" if kind == "revolute" else "m"
    said = f"joint 'j': limits 0 to 0 {unit}, effort 5, velocity 1 are not represented"
    assert said in map(str, loaded(tmp_path, body, limits=limits).notes)


@pytest.mark.parametrize(("given", "taken"), [
    ("&#65279;arm", "arm"), ("an&#10;arm&#8203;", "an arm"), ("arm" * 400, ("arm" * 400)[:980]),
])  # fmt: skip
def test_what_a_model_cannot_have_in_its_name_is_left_out_with_a_note(
    given: str, taken: str, tmp_path: Path
) -> None:
    path = tmp_path / "robot.urdf"
    body = link("base") + link("a") + joint("j", "revolute", "base", "a")
    path.write_text(f'<robot name="{given}">{body}</robot>')
    imported = lw.import_urdf(path)
    assert imported.model.name == taken
    assert ("name", "model") in topics(imported)


def test_names_of_links_and_joints_that_cannot_be_printed_are_refused_by_line(tmp_path: Path) -> None:
    """They are what one finds these by."""
    base, arm = link("base"), link("a&#8203;")
    with pytest.raises(lw.ModelFileError, match=r"robot.urdf:4: link .*'a\\u200b' is not printable"):
        loaded(tmp_path, base + "\n" + arm + joint("j", "revolute", "base", "a&#8203;"))
    with pytest.raises(lw.ModelFileError, match=r"robot.urdf:4: joint .*'\\ufeffj' is not printable"):
        loaded(tmp_path, base + link("a") + "\n" + joint("&#65279;j", "revolute", "base", "a"))


def test_values_as_text_are_noted(tmp_path: Path) -> None:
    """The values of URDF are attributes."""
    inner = "<axis>0 1 0</axis><origin>0 0 1</origin>"
    imported = loaded(tmp_path, link("base") + link("a") + "\n" + joint("j", "revolute", "base", "a", inner))
    said = [str(note) for note in imported.notes if note.topic == "element"]
    assert said == [f"<{tag}>: in line 4 has text, which is not taken" for tag in ("axis", "origin")]


# --- wrong files --------------------------------------------------------------------------------------------

GOOD = (
    link("base")
    + "\n"
    + link("arm")
    + "\n"
    + joint("hinge", "revolute", "base", "arm", '<axis xyz="0 0 1"/>')
)

WRONG = [
    ('<mass value="1.0"/>', '<mass value="heavy"/>', r":3: link 'base' mass: 'heavy' is not a finite number"),
    ('<mass value="1.0"/>', '<mass value="nan"/>', r":3: link 'base' mass: 'nan' is not a finite number"),
    ('<mass value="1.0"/>', '<mass value="1e400"/>', r":3: link 'base' mass"),
    ('<mass value="1.0"/>', '<mass value="1_000"/>', r":3: link 'base' mass: '1_000' is not a finite"),
    ('<mass value="1.0"/>', '<mass value="\u0661"/>', r":3: link 'base' mass: '\u0661' is not a finite"),
    ('<mass value="1.0"/>', '<mass value="\uff11"/>', r":3: link 'base' mass: '\uff11' is not a finite"),
    ('xyz="0 0 0"', 'xyz="0\u00a00 0"', r":3: link 'base' origin xyz: .* is not 3 finite numbers"),
    ('<mass value="1.0"/>', "", r":3: link 'base' mass: is missing"),
    ('ixx="0.3"', "", r":3: link 'base' inertia ixx: is missing"),
    ('xyz="0 0 0"', 'xyz=""', r":3: link 'base' origin xyz: '' is not 3 finite numbers"),
    ('ixx="0.3"', 'ixx=" "', r":3: link 'base' inertia ixx: '' is not a finite number"),
    ('xyz="0 0 0"', 'xyz="0 0"', r":3: link 'base' origin xyz: '0 0' is not 3 finite numbers"),
    ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>', r":5: joint 'hinge' axis: has no direction"),
    ('<axis xyz="0 0 1"/>', '<axis xyz="z"/>', r":5: joint 'hinge' axis: 'z' is not 3 finite numbers"),
    ('type="revolute"', 'type="hinge"', r":5: joint 'hinge': type 'hinge' does not exist"),
    ('type="revolute"', "", r":5: joint 'hinge': type is missing"),
    ('<child link="arm"/>', '<child link="leg"/>', r":5: joint 'hinge' child: no link 'leg'"),
    ('<child link="arm"/>', "", r":5: joint 'hinge': child is missing"),
    ('<child link="arm"/>', '<child link="base"/>', r":5: joint 'hinge': is part of a ring"),
    ('name="arm"', 'name="base"', r":4: link 'base': is given twice"),
    (
        '<child link="arm"/>',
        '<child link="world"/></joint><link name="world"/><joint name="k" type="fixed">'
        '<parent link="base"/><child link="arm"/>',
        r":5: joint 'hinge' child: link 'world' is the ground: nothing carries it",
    ),
    ('name="arm"', "", r":4: link: name is missing"),
    ("</joint>", '<mimic joint="hip"/></joint>', r":5: joint 'hinge' mimic: no joint 'hip'"),
    (
        "</joint>",
        '<mimic joint="hinge"/></joint>',
        r":5: joint 'hinge' mimic: follows itself: hinge -> hinge",
    ),
    ("</joint>", "<mimic/></joint>", r":5: joint 'hinge' mimic: joint is missing"),
    (
        "</joint>",
        '<mimic joint="a" multiplier="x"/></joint>',
        r":5: joint 'hinge' mimic multiplier: 'x' is not",
    ),
    ("</link>", "</lnik>", r":3: is no XML: mismatched tag"),
    ("</robot>", "", r"is no XML: no element found"),
    (
        '<robot name="test">',
        '<!DOCTYPE robot [<!ENTITY a "b">]><robot name="test">',
        r":2: DOCTYPE is not taken",
    ),
    ('<robot name="test">', '<sdf name="test">', r"is no XML"),
    ('<link name="base">', "<link name='base'>" + "<a>" * 20_000, r"nested more than 10000 deep"),
    ('<link name="base">', '<xacro:macro name="x"/><link name="base">', r"expand the file by xacro first"),
]


@pytest.mark.parametrize(("part", "by", "message"), WRONG)
def test_wrong_files_are_refused_with_line_and_field(
    part: str, by: str, message: str, tmp_path: Path
) -> None:
    text = f'<?xml version="1.0"?>\n<robot name="test">\n{GOOD}\n</robot>\n'
    check_refused(lw.import_urdf, tmp_path / "robot.urdf", text, part, by, message)


@pytest.mark.parametrize("text", ["2", "+2.", "2.0", "2e0", "20E-1", ".2e+1", " 2\n"])
def test_numbers_are_read_as_in_c(text: str, tmp_path: Path) -> None:
    body = link("base") + link("a").replace('"1.0"', f'"{text}"') + joint("j", "revolute", "base", "a")
    assert loaded(tmp_path, body).model.compiled().mass == [2.0]


def test_joints_that_follow_each_other_in_a_ring_are_refused(tmp_path: Path) -> None:
    joints = "".join(
        joint(name, "revolute", "base", link_name, f'<mimic joint="{leader}"/>')
        for name, link_name, leader in (("x", "a", "y"), ("y", "b", "z"), ("z", "c", "x"))
    )
    with pytest.raises(lw.ModelFileError, match="follows itself: x -> y -> z -> x"):
        loaded(tmp_path, link("base") + link("a") + link("b") + link("c") + joints)


def test_joints_that_follow_in_a_chain_are_placed(tmp_path: Path) -> None:
    """z = 2 y - 0.1, y = -3 x + 0.2, in an order other than that of the file."""
    mimic = '<axis xyz="0 0 1"/><mimic joint="{}" multiplier="{}" offset="{}"/>'
    body = (link("base") + link("c") + link("b") + link("a")
            + joint("z", "revolute", "base", "c", mimic.format("y", 2, -0.1))
            + joint("y", "revolute", "base", "b", mimic.format("x", -3, 0.2))
            + joint("x", "revolute", "base", "a", '<axis xyz="0 0 1"/>'))  # fmt: skip
    core = loaded(tmp_path, body, coordinates={"x": 0.3}, velocities={"x": 1.0}).model.compiled()
    q, v = core.q0.reshape(-1, 7), core.v0.reshape(-1, 6)
    assert 2 * np.arctan2(q[:, 6], q[:, 3]) == pytest.approx([2 * (-0.9 + 0.2) - 0.1, -0.9 + 0.2, 0.3])
    assert v[:, 5] == pytest.approx([-6.0, -3.0, 1.0])


def test_a_planar_joint_that_would_follow_stays_where_it_is(tmp_path: Path) -> None:
    body = (link("base") + link("a") + link("b") + joint("x", "revolute", "base", "a")
            + joint("flat", "planar", "base", "b", '<mimic joint="x"/>'))  # fmt: skip
    imported = loaded(tmp_path, body, coordinates={"x": 0.3}, velocities={"x": 1.0})
    assert ("mimic", "joint 'flat'") in topics(imported)
    core = imported.model.compiled()
    assert core.q0[7:] == pytest.approx([0, 0, 0, 1, 0, 0, 0])


@pytest.mark.parametrize("q", [-7.0, -3.5, -np.pi, 3.0, np.pi, 3.5, 7.0])
def test_stops_know_full_turns_before_the_start(q: float, tmp_path: Path) -> None:
    """Between its ends, which are a turn and more apart, a joint is free; beyond one, pushed back."""
    axis = '<axis xyz="1 2 0.3"/>'
    for lower, upper in ((q - 1.0, q + 6.5), (q - 6.5, q + 1.0), (q + 0.1, q + 6.5)):
        limit = f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'
        body = link("base") + link("a") + joint("x", "revolute", "base", "a", axis + limit)
        imported = loaded(tmp_path, body, coordinates={"x": q}, limits="stops", gravity=(0, 0, 0))
        pushed = accelerations(imported.model)[0, 3:] @ (1.0, 2.0, 0.3)
        assert abs(pushed) < 1e-9 if lower < q else pushed > 1.0


def test_a_ring_of_joints_is_no_tree(tmp_path: Path) -> None:
    ring = link("a") + link("b") + joint("j", "revolute", "a", "b") + joint("k", "revolute", "b", "a")
    with pytest.raises(lw.ModelFileError, match="ring of joints"):
        loaded(tmp_path, ring)


def test_coordinates_are_checked() -> None:
    with pytest.raises(lw.ModelError, match="no joint 'elbo'; the nearest is 'elbow'"):
        lw.import_urdf(ARM, coordinates={"elbo": 0.1})
    with pytest.raises(lw.ModelError, match="takes 1 finite numbers"):
        lw.import_urdf(ARM, coordinates={"elbow": (0.1, 0.2)})


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"shapes": "none"}, lw.OptionError, "shapes 'none' is not True or False"),
        ({"inertia_as_is": 1}, lw.OptionError, "inertia_as_is 1 is not True or False"),
        ({"merge_fixed": "no"}, lw.OptionError, "merge_fixed 'no' is not True or False"),
        ({"floating": "no"}, lw.OptionError, "floating 'no' is not True, False or None"),
        ({"coordinates": [1]}, lw.OptionError, r"coordinates \[1\] is no mapping"),
        ({"coordinates": {"elbow": "abc"}}, lw.OptionError, "coordinates.'elbow'. 'abc' is not made of num"),
        ({"coordinates": {"elbow": 1j}}, lw.OptionError, "coordinates.'elbow'. 1j is not made of numbers"),
        ({"velocities": {"elbow": "1.5"}}, lw.OptionError, "velocities.'elbow'. '1.5' is no number"),
        (
            {"velocities": {"elbow": [[1], [2, 3]]}},
            lw.OptionError,
            "velocities.'elbow'. .* rows of diff",
        ),
        *(
            ({"align_axes": angle}, lw.OptionError, f"align_axes {angle!r} is no angle from 0 to 0.785 rad")
            for angle in ("x", float("nan"), -1, 3.2, True)
        ),
        ({"search_path": 3}, lw.OptionError, "search_path 3 is no list of folders"),
        ({"search_path": ["nowhere"]}, lw.FileError, "search_path '.*nowhere': there is no such folder"),
        ({"search_path": ARM}, lw.FileError, "search_path '.*arm.urdf': there is no such folder"),
    ],
)
def test_choices_that_there_are_not_are_refused(
    options: dict[str, Any], error: type[Exception], message: str
) -> None:
    """Any text would count as yes, and folders with a misspelled name as empty."""
    with pytest.raises(error, match=message):
        lw.import_urdf(ARM, **options)


def test_one_folder_is_a_search_path(tmp_path: Path) -> None:
    """A text is not one of letters."""
    (tmp_path / "meshes").mkdir()
    assert lw.import_urdf(ARM, search_path=str(tmp_path / "meshes")).notes == lw.import_urdf(ARM).notes


@pytest.mark.filterwarnings("error")
def test_numbers_beyond_all_are_refused_by_name_and_without_warnings(tmp_path: Path) -> None:
    text = (link("base") + link("a") + link("b") + joint("x", "revolute", "base", "a", '<axis xyz="0 0 1"/>')
            + joint("y", "revolute", "base", "b", '<mimic joint="x" multiplier="1e308"/>'))  # fmt: skip
    with pytest.raises(
        lw.ModelError, match=r"joint 'y', 1e\+308 times joint 'x', would be beyond all numbers"
    ):
        loaded(tmp_path, text, coordinates={"x": 1e3})
    far = link("c") + joint("w", "fixed", "a", "c", '<origin xyz="1e200 0 0"/>')
    with pytest.raises(lw.ModelFileError, match=r":\d+: link 'a': inertia .*inf.*"):
        loaded(tmp_path, text + far, merge_fixed=True)


def hinges(count: int) -> str:
    """A chain along x of links of 1 kg, which turn about z."""
    inner = '<origin xyz="0.5 0 0"/><axis xyz="0 0 1"/><limit lower="-1" upper="1"/>'
    links = "".join(link(f"l{k}") for k in range(count + 1))
    return links + "".join(joint(f"j{k}", "revolute", f"l{k}", f"l{k + 1}", inner) for k in range(count))


def test_stops_along_a_chain_take_what_is_behind_them(tmp_path: Path) -> None:
    """k = (100 rad/s)^2 J about each axis; joint k carries links at 0, 0.5, 1, ... m from it."""
    count = 6
    notes = loaded(tmp_path, hinges(count), limits="stops").notes
    found = [str(note).rpartition("stops of ")[2] for note in notes if note.topic == "limits"]
    arms = [0.5 * np.arange(count - k) for k in range(count)]
    assert found == [f"{1e4 * (0.15 * len(arm) + arm @ arm):.3g} N m/rad" for arm in arms]


def test_stops_along_a_chain_take_time_as_it_is_long(tmp_path: Path) -> None:
    check_takes_time_as_it_is_long(lambda count: loaded(tmp_path, hinges(count), limits="stops"), stops)


def test_long_chains_of_joints_that_follow_each_other_are_read_at_once(tmp_path: Path) -> None:
    count = 2000
    chain = "".join(
        link(f"l{k}") + joint(f"j{k}", "continuous", "base", f"l{k}", f'<mimic joint="j{k + 1}"/>')
        for k in range(count)
    )
    last = link("last") + joint(f"j{count}", "continuous", "base", "last")
    begin = time.process_time()
    model = loaded(tmp_path, link("base") + chain + last, coordinates={f"j{count}": 0.3}).model
    assert time.process_time() - begin < 15  # the time of a chain grew with the cube of its length
    assert model.joint_count == 2 * count + 1


def test_a_link_named_ground_has_a_free_name(tmp_path: Path) -> None:
    body = link("ground") + link("ground 2") + joint("ground", "revolute", "ground", "ground 2")
    model = loaded(tmp_path, body, floating=True)
    assert [model.model.compiled().body_name(k) for k in range(2)] == ["ground 3", "ground 2"]
    said = "link 'ground': is called 'ground 3' here: 'ground' is the name of the ground"
    assert [str(note) for note in model.notes if note.topic == "name"] == [said]
    fixed = loaded(tmp_path, body)  # the base is the ground
    assert fixed.model.body_count == 1 and "name" not in {note.topic for note in fixed.notes}


def test_names_with_tabs_and_line_breaks_are_taken_with_spaces(tmp_path: Path) -> None:
    """Also where what they name is meant, and `coordinates` take the name of the file and the new one."""
    body = (link("base") + link("a&#9;b") + link("a b") + link("c&#10;d")
            + joint("x&#9;y", "continuous", "base", "a&#9;b") + joint("x y", "continuous", "a&#9;b", "a b")
            + joint("m&#10;n", "continuous", "base", "c&#10;d",
                    '<mimic joint="x&#9;y" multiplier="2"/>'))  # fmt: skip
    imported = loaded(tmp_path, body, coordinates={"x\ty": 0.3, "x y": 0.2})
    core = imported.model.compiled()
    assert [core.body_name(k) for k in range(core.body_count)] == ["a b 2", "a b", "c d"]
    assert [core.joint_name(k) for k in range(4)] == ["x y 2", "x y", "m n", "m n mimic"]
    assert {note.subject: note.message for note in imported.notes if note.topic == "name"} == {
        "link 'a b 2'": r"its name 'a\tb' is 'a b 2' here: to be printed",
        "link 'c d'": r"its name 'c\nd' is 'c d' here: to be printed",
        "joint 'x y 2'": r"its name 'x\ty' is 'x y 2' here: to be printed",
        "joint 'm n'": r"its name 'm\nn' is 'm n' here: to be printed",
    }
    same = loaded(tmp_path, body, coordinates={"x y 2": 0.3, "x y": 0.2}).model.compiled()
    assert np.array_equal(same.q0, core.q0) and np.abs(core.q0[4]) > 0.1
    with pytest.raises(lw.ModelFileError, match=r":3: link 'a b 2': principal moments"):
        loaded(tmp_path, body.replace('izz="0.15"', 'izz="1.5"', 2).replace('izz="1.5"', 'izz="0.15"', 1))


@pytest.mark.parametrize("type_", ["continuous", "planar"])
def test_ends_of_joints_that_have_none_are_noted(type_: str, tmp_path: Path) -> None:
    limit = '<axis xyz="0 0 1"/><limit lower="-1" upper="0" effort="3"/>'
    imported = loaded(
        tmp_path, link("base") + link("a") + joint("j", type_, "base", "a", limit), limits="stops"
    )
    said = [str(note) for note in imported.notes if note.topic == "limits"]
    assert said == ["joint 'j': limits lower -1, upper 0, effort 3 are not represented"]


def test_a_coupler_has_a_name_that_no_joint_has(tmp_path: Path) -> None:
    names = ["k", "k mimic", "k mimic mimic"]
    body = link("base") + link("l") + "".join(
        link(name) + joint(name, "continuous", "base", name, '<mimic joint="j"/>' * (name == "k"))
        for name in names
    ) + joint("j", "continuous", "base", "l")  # fmt: skip
    core = loaded(tmp_path, body).model.compiled()
    assert [core.joint_name(k) for k in range(core.joint_count)] == [*names, "j", "k mimic mimic 2"]


@pytest.mark.parametrize("start", [1e6, 1e12, -1e15])
def test_the_note_of_many_turns_says_the_angle_that_is_used(start: float, tmp_path: Path) -> None:
    body = link("base") + link("a") + joint("j", "continuous", "base", "a", '<axis xyz="0 0 1"/>')
    imported = loaded(tmp_path, body, coordinates={"j": start}, gravity=(0, 0, 0))
    used = lw.simulate(imported.model, t_end=1e-3, step=1e-3).coordinate("j").value[0]
    (said,) = (note.message for note in imported.notes if note.topic == "coordinates")
    assert float(said.split()[-2]) == pytest.approx(used, abs=1e-5)


def test_negative_moments_are_made_the_nearest_but_never_taken_as_they_are(tmp_path: Path) -> None:
    """(3, 1, -1) has the second moments -3/2, 1/2, 5/2."""
    bad = link("arm")
    for part, by in (('"0.3"', '"3"'), ('"0.2"', '"1"'), ('"0.15"', '"-1"')):
        bad = bad.replace(part, by)
    body = link("base") + bad + joint("hinge", "revolute", "base", "arm")
    for options in ({}, {"inertia_as_is": True}):
        with pytest.raises(lw.ModelFileError, match="moment of inertia -1 .* is negative; repair_inertia"):
            loaded(tmp_path, body, **options)
    repaired = loaded(tmp_path, body, repair_inertia=True).model.compiled().inertia[0]
    assert np.diag(repaired) == pytest.approx([3.0, 2.5, 0.5])


def test_a_joint_that_is_given_by_both_of_its_names_is_refused(tmp_path: Path) -> None:
    body = link("base") + link("a") + joint("x&#9;y", "continuous", "base", "a")
    for given in ({"x\ty": 0.5}, {"x y": 0.5}):
        model = loaded(tmp_path, body, coordinates=given).model
        assert lw.simulate(model, 0.0, 1e-3, progress=False).coordinate("x y").value[0] == pytest.approx(0.5)
    with pytest.raises(lw.ModelError, match="coordinates: joint 'x.*y' is given twice, as 'x y', too"):
        loaded(tmp_path, body, coordinates={"x\ty": 0.5, "x y": 0.25})
