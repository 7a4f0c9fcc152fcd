"""MJCF files: against MuJoCo where it is exact (trees), against our own models where it is soft (loops)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import linkwork as lw
import mujoco
import numpy as np
import pytest
from linkwork.modeling.coordinates import JointCoordinate
from mujoco_comparison import largest_difference
from random_mjcf import RandomFile
from robot_files import ROBOTS, accelerations

SLIDER_CRANK = ROBOTS / "slider_crank.xml"


def written(tmp_path: Path, body: str, rest: str = "", flags: str = "") -> Path:
    path = tmp_path / "model.xml"
    path.write_text(
        f'<mujoco model="test">\n<option gravity="0 0 -9.81"><flag {flags}/></option>\n'
        f"<worldbody>\n{body}\n</worldbody>\n{rest}\n</mujoco>\n"
    )
    return path


INERTIAL = '<inertial pos="0.1 0.2 -0.1" quat="0.9 0.1 0.2 0.3" mass="2" diaginertia="0.03 0.02 0.04"/>'

TREE = f"""
<body name="a" pos="0.1 0.2 0.3" quat="0.8 0.2 0.4 0.1"><joint name="q1" type="hinge" pos="0.1 0 0.2" axis="1
2 0" damping="0.3" armature="0.4"/>{INERTIAL}
  <body name="b" pos="0.5 0 0.1" quat="0.7 0 0.7 0.2"><joint name="q2" type="slide" axis="0 1 1" ref="0.05"
  stiffness="7" springref="0.2" armature="3"/>{INERTIAL}
    <body name="c" pos="0 0.4 0" quat="1 0.3 0 0"><joint name="q3" type="hinge" axis="0 0 1" ref="0.3"
    stiffness="2" springref="-0.1"/>{INERTIAL}
      <body name="d" pos="0 0 0.5"><joint name="q4" type="hinge" pos="0.1 0 0" axis="1 0 0"/><joint name="q5"
      type="hinge" pos="0.1 0 0" axis="0 1 0"/>{INERTIAL}
        <body name="e" pos="0.2 0 0"><joint name="q6" type="slide" axis="0 0 1"/><joint name="q7" type="hinge"
        axis="0 0 1"/>{INERTIAL} <body name="f" pos="0.2 0.1 0"><joint name="q8" type="slide" axis="1 0
        0"/><joint name="q9" type="slide" axis="0 1 0"/><joint name="q10" type="hinge" axis="0 0
        1"/>{INERTIAL}
          <body name="g" pos="0.2 0 0.3">{INERTIAL}</body>
</body></body></body></body></body></body>
"""  # fmt: skip

JOINTS = {
    "q1": 0.3,
    "q2": 0.15,
    "q3": -0.8,
    "q4+q5": (0.4, 0.9),
    "q6+q7": (0.1, 2.0),
    "q8+q9+q10": (0.2, -0.1, 0.6),
}


def test_a_tree_of_all_joints_accelerates_as_in_mujoco(tmp_path: Path) -> None:
    path = written(tmp_path, TREE)
    rng = np.random.default_rng(3)
    rates = {name: rng.uniform(-2, 2, np.size(value)) for name, value in JOINTS.items()}
    model = lw.import_mjcf(path, coordinates=JOINTS, velocities=rates).model

    theirs = mujoco.MjModel.from_xml_path(str(path))
    theirs.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    data = mujoco.MjData(theirs)
    data.qpos[:] = np.concatenate([np.atleast_1d(value) for value in JOINTS.values()])
    data.qvel[:] = np.concatenate(list(rates.values()))
    mujoco.mj_forward(theirs, data)
    mujoco.mj_rnePostConstraint(theirs, data)

    v_dot, core = accelerations(model), model.compiled()
    q, v = core.q0.reshape(-1, 7), core.v0.reshape(-1, 6)
    for name in "abcdefg":
        k, body = model.find(name).index, theirs.body(name).id
        A = lw.rotation.matrix(q[k, 3:])
        assert q[k, :3] == pytest.approx(data.xipos[body], abs=1e-13), name
        assert pytest.approx(data.xmat[body].reshape(3, 3), abs=1e-13) == A, name
        velocity, acceleration = np.zeros(6), np.zeros(6)
        mujoco.mj_objectVelocity(theirs, data, mujoco.mjtObj.mjOBJ_BODY, body, velocity, 0)
        mujoco.mj_objectAcceleration(theirs, data, mujoco.mjtObj.mjOBJ_BODY, body, acceleration, 0)
        assert np.concatenate([v[k, :3], A @ v[k, 3:]]) == pytest.approx(
            [*velocity[3:], *velocity[:3]], abs=1e-12
        ), name
        # theirs is against free fall
        expected = [*(acceleration[3:] + theirs.opt.gravity), *acceleration[:3]]
        assert np.concatenate([v_dot[k, :3], A @ v_dot[k, 3:]]) == pytest.approx(
            expected, rel=1e-9, abs=1e-9
        ), name


def slider_crank() -> lw.Model:
    """The mechanism of slider_crank.xml, by hand."""
    model = lw.Model()
    crank = model.body("crank", mass=1, inertia=(0.001, 0.02, 0.02), position=(0.25, 0, 0))
    rod = model.body("rod", mass=2, inertia=(0.002, 0.2, 0.2), position=(1.0, 0, 0))
    slider = model.body("slider", mass=0.5, inertia=(0.01, 0.01, 0.01), position=(1.5, 0, 0))
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute(crank, rod, at=(0.5, 0, 0), axis=(0, 1, 0))
    model.translational(model.ground, slider, at=(1.5, 0, 0), axis=(1, 0, 0))
    model.spherical(rod, slider, at=(1.5, 0, 0))
    return model


def rotating(model: lw.Model, speed: float) -> lw.Model:
    """With the crank at this speed, in the stretched pose: the slider rests for the moment."""
    v = np.zeros((3, 6))
    names = [model.find(name).index for name in ("crank", "rod", "slider")]
    rate = -speed / 2.0  # the rod of 1 m turns the other way: its end stays on the axis
    v[names[0]] = [0, 0, -0.25 * speed, 0, speed, 0]
    v[names[1]] = [0, 0, -0.25 * speed, 0, rate, 0]
    return model.with_initial_state(model.compiled().q0, v)


def test_a_slider_crank_with_connect_moves_as_the_same_mechanism_by_hand() -> None:
    imported = lw.import_mjcf(SLIDER_CRANK)
    assert [(note.topic, note.subject) for note in imported.notes] == [
        ("equality", "equality 'wrist pin'"), ("actuator", "actuator 'motor'"),
    ]  # fmt: skip
    runs = [
        lw.simulate(rotating(model, 6.0), t_end=2.0, step=1e-3) for model in (imported.model, slider_crank())
    ]
    slider = imported.model.find("slider").index
    assert np.ptp(runs[0].q[:, slider, 0]) > 0.9  # a stroke of 1 m
    assert np.abs(runs[0].q - runs[1].q).max() < 1e-9


def test_welds_are_fixed_joints(tmp_path: Path) -> None:
    bodies = (f'<body name="a" pos="0 0 1"><freejoint/>{INERTIAL}</body>'
              f'<body name="b" pos="0.5 0.1 1" quat="9 2 1 1"><freejoint/>{INERTIAL}</body>')  # fmt: skip
    path = written(tmp_path, bodies, '<equality><weld name="glue" body1="a" body2="b"/></equality>')
    model = lw.import_mjcf(path).model
    assert (model.joint_count, model.row_count) == (1, 6)
    core = model.compiled()
    violation = lw.System(model).evaluate(0.0, core.q0, core.v0).Phi
    assert np.abs(violation).max() < 1e-12
    assert accelerations(model)[:, :3] == pytest.approx(np.tile([0, 0, -9.81], (2, 1)), abs=1e-10)


WELDS = ["", 'anchor="0.3 0.1 0.2"', 'anchor="0.3 0.1 0.2" relpose="0.5 -0.2 0.1 4 1 2 1"',
         'anchor="0.3 0.1 0.2" torquescale="0"', 'relpose="0.4 -0.3 0.2 1 0 0 0"']  # fmt: skip


@pytest.mark.parametrize("weld", WELDS)
def test_welds_and_their_anchors_hold_where_they_do_in_mujoco(weld: str, tmp_path: Path) -> None:
    """Points that are to coincide are as far apart as in MuJoCo."""
    bodies = (f'<body name="a" pos="0 0 1" quat="5 1 2 0"><freejoint/>{INERTIAL}</body>'
              f'<body name="b" pos="0.5 0.1 1" quat="9 2 1 1"><freejoint/>{INERTIAL}</body>')  # fmt: skip
    path = written(tmp_path, bodies, f'<equality><weld body1="a" body2="b" {weld}/></equality>')
    theirs = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(theirs)
    mujoco.mj_forward(theirs, data)
    model = lw.import_mjcf(path).model
    gap = lw.System(model).evaluate(0.0, model.compiled().q0, model.compiled().v0).Phi
    assert np.linalg.norm(gap[:3]) == pytest.approx(np.linalg.norm(data.efc_pos[:3]), abs=1e-12)
    if "relpose" not in weld:
        assert np.abs(gap).max() < 1e-12


WRONG = [
    ('<body name="a"><freejoint/><geom size="1"/><site name="s"/></body><site name="t"/>',
     '<tendon><spatial name="cord" stiffness="5"><site site="s"/><site site="t"/></spatial></tendon>',
     "tendon 'cord'"),
    ('<body><joint type="door"/><geom size="1"/></body>', "", "MuJoCo: .*door"),
    ("<body>", "", "is no XML"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "rest", "message"), WRONG)
def test_what_cannot_be_is_refused_by_name(body: str, rest: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(lw.ModelFileError, match=message):
        lw.import_mjcf(written(tmp_path, body, rest))


def test_tendons_without_forces_are_noted(tmp_path: Path) -> None:
    tendons = "".join(
        f'<fixed name="{name}" {more}><joint joint="q" coef="2"/></fixed>'
        for name, more in (("idle", ""), ("ends", 'limited="true" range="-1 2"'))
    )
    body = f'<body name="a"><joint name="q"/>{INERTIAL}</body>'
    notes = lw.import_mjcf(written(tmp_path, body, f"<tendon>{tendons}</tendon>")).notes
    said = {note.subject: note.message for note in notes if note.topic == "tendon"}
    assert "exerts no forces" in said["tendon 'idle'"] and "-1 to 2" in said["tendon 'ends'"]
    pulling = "<tendon>" + tendons.replace('name="idle"', 'name="idle" damping="1"') + "</tendon>"
    with pytest.raises(lw.ModelFileError, match="tendon 'idle'.*that exert forces"):
        lw.import_mjcf(written(tmp_path, body, pulling))
    lw.import_mjcf(written(tmp_path, body, pulling, flags='damper="disable"'))


@pytest.mark.parametrize("kind", ["hinge", "slide", "ball", "free"])
@pytest.mark.parametrize("what", ["damping", "frictionloss", "armature"])
def test_joints_that_would_drive_themselves_are_refused(kind: str, what: str, tmp_path: Path) -> None:
    body = f'<body name="a"><joint name="q" type="{kind}" {what}="{{}}"/>{INERTIAL}</body>'
    lw.import_mjcf(written(tmp_path, body.format(0.01)))
    with pytest.raises(lw.ModelFileError, match=r":4: .*-0.01 .*must .*not .*negative"):
        lw.import_mjcf(written(tmp_path, body.format(-0.01)))


def test_a_file_is_read_after_one_that_mujoco_could_not_read(tmp_path: Path) -> None:
    body = f'<body name="a"><joint type="hinge"/>{INERTIAL}</body>'
    with pytest.raises(lw.ModelFileError, match="MuJoCo: "):
        lw.import_mjcf(written(tmp_path, body, '<equality><connect body1="a" anchor=""/></equality>'))
    assert lw.import_mjcf(written(tmp_path, body)).model.body_count == 1


def test_a_warning_of_mujoco_comes_after_a_file_that_it_could_not_read(tmp_path: Path) -> None:
    """Its state in the same thread is damaged then: it waited for ever before it warned."""
    body = f'<body name="a"><joint type="hinge" {{}}/>{INERTIAL}</body>'
    for _ in range(2):
        with pytest.raises(lw.ModelFileError, match="MuJoCo: Caught an unknown exception"):
            lw.import_mjcf(
                written(tmp_path, body.format(""), '<equality><connect body1="a" anchor=" "/></equality>')
            )
        with pytest.raises(lw.ModelFileError, match="nan is not finite"):
            lw.import_mjcf(written(tmp_path, body.format('damping="nan"')))


def test_other_encodings_than_utf_8_are_refused(tmp_path: Path) -> None:
    body = f'<body name="b\u00e9"><joint name="x"/>{INERTIAL}</body>'
    head = '<?xml version="1.0" encoding="ISO-8859-1"?>\n'
    path = tmp_path / "model.xml"
    path.write_bytes(f"{head}<mujoco><worldbody>{body}</worldbody></mujoco>".encode("latin-1"))
    with pytest.raises(lw.ModelFileError, match=":1: is in ISO-8859-1, which is not taken: save it in UTF-8"):
        lw.import_mjcf(path)
    (tmp_path / "part.xml").write_bytes(f"{head}<mujocoinclude>{body}</mujocoinclude>".encode("latin-1"))
    with pytest.raises(lw.ModelFileError, match="a file that it includes is not in UTF-8"):
        lw.import_mjcf(written(tmp_path, '<include file="part.xml"/>'))
    path.write_text(f"{head}<mujoco><worldbody>{body.replace(chr(233), 'e')}</worldbody></mujoco>")
    assert lw.import_mjcf(path).model.body_count == 1  # what is in ASCII is in UTF-8


def test_doctype_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "model.xml"
    path.write_text('<!DOCTYPE mujoco [<!ENTITY a "b">]>\n<mujoco/>')
    with pytest.raises(lw.ModelFileError, match="DOCTYPE"):
        lw.import_mjcf(path)


def test_a_joint_equality_is_a_coupler(tmp_path: Path) -> None:
    """q_1 - ref_1 = 0.2 - 0.5 (q_2 - ref_2), in MuJoCo's coordinates; other polynomials are listed."""
    body = "".join(
        f'<body name="{name}"><joint name="{q}" axis="0 0 1" ref="{ref}"/>{INERTIAL}</body>'
        for name, q, ref in (("a", "q1", 20), ("b", "q2", -15), ("c", "q3", 0))  # degrees
    )
    rest = ('<equality><joint name="linear" joint1="q1" joint2="q2" polycoef="0.2 -0.5 0 0 0"/>'
            '<joint name="square" joint1="q3" joint2="q2" polycoef="0 0 1 0 0"/></equality>')  # fmt: skip
    imported = lw.import_mjcf(
        written(tmp_path, body, rest), coordinates={"q2": 0.5}, velocities={"q2": 2.0}, gravity=(3, 0, 0)
    )
    subjects = [note.subject for note in imported.notes if note.topic == "equality"]
    assert subjects == ["equality 'linear'", "equality 'square'"]
    result = lw.simulate(imported.model, t_end=1.0, step=1e-3)
    one, other = (result.coordinate(name).value for name in ("q1", "q2"))
    assert np.ptp(other) > 0.1
    assert one - np.radians(20) == pytest.approx(0.2 - 0.5 * (other + np.radians(15)), abs=1e-9)
    assert other[0] == pytest.approx(0.5)


def test_what_is_not_in_the_model_is_listed(tmp_path: Path) -> None:
    body: Any = (f'<body name="a"><joint name="j" range="-1 1" limited="true" frictionloss="0.2"/>'
                 f'{INERTIAL}<geom size="0.1"/></body>')  # fmt: skip
    rest = (
        '<equality><joint joint1="j" name="lock"/></equality><actuator><motor joint="j" name="m"/></actuator>'
    )
    notes = lw.import_mjcf(written(tmp_path, body, rest)).notes
    assert {note.topic for note in notes} == {"limits", "friction", "equality", "actuator", "contact"}
    text = next(note.message for note in notes if note.topic == "equality")
    assert text == "that it holds joint 'j' at 0 from its reference is not represented"


# --- against MuJoCo, attribute by attribute -----------------------------------------------------------------


@pytest.mark.parametrize("seed", range(40))
def test_random_files_accelerate_as_in_mujoco(seed: int, tmp_path: Path) -> None:
    """With all kinds of joints and what acts at them, poses and inertias in all forms, defaults and flags."""
    path = tmp_path / "model.xml"
    path.write_text(RandomFile(seed).text())
    assert largest_difference(path, np.random.default_rng(seed)) < 1e-9


def hinged(attributes: str, inner: str = "") -> str:
    """A free body with another one hinged to it."""
    inner = f'<joint name="q" axis="1 2 0" pos="0.1 0 0"/>{INERTIAL}{inner}'
    return (f'<body name="a" pos="0 0 1" quat="0.8 0.2 0.4 0.1"><freejoint/>{INERTIAL}'
            f'<body name="b" pos="0.5 0.1 0" {attributes}>{inner}</body></body>')  # fmt: skip


PLACE = 'name="a" pos="1 2 3" quat="0.8 0.2 0.4 0.1"'

ROOT = f'<body {PLACE}><joint name="root" type="free" {{}}/>{INERTIAL}</body>'

BALL = (f'<body {PLACE}><freejoint/>{INERTIAL}<body name="b" pos="0 0 0.3">'
        f'<joint name="ball" type="ball" pos="0.1 0.2 0" {{}}/>{INERTIAL}</body></body>')  # fmt: skip

#: Bodies, what follows them, and flags: each changes the accelerations, and in no other way than in MuJoCo.
CHANGES = {
    "free damping": (ROOT.format('damping="0.7"'), "", ""),
    "free armature": (ROOT.format('armature="0.9"'), "", ""),
    "free spring": (ROOT.format('stiffness="5"'), "", ""),
    "free with all": (ROOT.format('damping="0.7" armature="0.9" stiffness="5"'), "", ""),
    "ball damping": (BALL.format('damping="0.7"'), "", ""),
    "ball spring": (BALL.format('stiffness="5"'), "", ""),
    "gravity compensation": (hinged('gravcomp="0.6"'), "", ""),
    "rotor of an actuator": (
        hinged(""),
        '<actuator><motor joint="q" gear="5" armature="0.02"/></actuator>',
        "",
    ),
    "damper of an actuator": (
        hinged(""),
        '<actuator><motor joint="q" gear="5" damping="0.4"/></actuator>',
        "",
    ),
    "no gravity": (ROOT.format('damping="0.7" armature="0.9"'), "", 'gravity="disable"'),
    "no gravity to compensate": (hinged('gravcomp="0.6"'), "", 'gravity="disable"'),
    "no dampers": (ROOT.format('damping="0.7" stiffness="5"'), "", 'damper="disable"'),
    "no springs": (ROOT.format('damping="0.7" stiffness="5"'), "", 'spring="disable"'),
    "no passive forces": (hinged('gravcomp="0.6"'), "", 'spring="disable" damper="disable"'),
}


@pytest.mark.parametrize("name", CHANGES)
def test_what_acts_on_joints_acts_as_in_mujoco(name: str, tmp_path: Path) -> None:
    path = written(tmp_path, *CHANGES[name])
    for seed in range(3):
        assert largest_difference(path, np.random.default_rng(seed), spread=2.0) < 1e-12


def test_the_spring_of_a_slider_acts_on_both_sides_however_far_away(tmp_path: Path) -> None:
    slide = '<joint name="s" type="slide" axis="1 2 2" stiffness="3" springref="0.4" ref="0.1"/>'
    path = written(tmp_path, f'<body name="a">{slide}{INERTIAL}</body>')
    for seed in range(3):
        assert largest_difference(path, np.random.default_rng(seed), spread=40.0) < 1e-12


def lifted(first: str, second: str, share: float = 0.6) -> str:
    """Two arms, of which the second is lifted."""
    joint = '<joint name="{}" axis="{}" {}/>' + INERTIAL
    inner = f'<body name="b" pos="0.5 0 0" gravcomp="{share}">{joint.format("q2", "0 1 0", second)}</body>'
    return f'<body name="a" pos="0 0 1">{joint.format("q1", "1 2 0", first)}{inner}</body>'


ON = 'actuatorgravcomp="true"'
MOTOR = '<actuator><motor name="m" joint="q1"/></actuator>'
OFF = 'actuation="disable"'

#: Bodies, actuators, flags; what is noted.
ACTUATED = {
    "actuated": ((lifted(ON, ON), MOTOR, ""), None),
    "an actuator elsewhere": ((lifted("", ON), MOTOR, ""), None),
    "no actuators": ((lifted(ON, ON), "", ""), None),
    "actuation disabled": ((lifted(ON, ON), MOTOR, OFF), None),
    "no passive forces": ((lifted(ON, ON), MOTOR, 'spring="disable" damper="disable"'), None),
    "no actuators needed": ((lifted("", ""), MOTOR, OFF), None),
    "free": ((f'<body name="a" gravcomp="0.6"><joint type="free" {ON}/>{INERTIAL}</body>', "", ""), None),
    "half of the joints": ((lifted("", ON), "", ""), "body 'b': .* at 'q2', too"),
    "limited": ((lifted(ON, f'{ON} actuatorfrcrange="-0.5 0.5"'), MOTOR, ""),
                "joint 'q2': its actuatorfrcrange -0.5 to 0.5 does not limit"),
    "limited elsewhere": ((lifted(ON, 'actuatorfrcrange="-0.5 0.5"'), MOTOR, ""), None),
}  # fmt: skip


@pytest.mark.parametrize("name", ACTUATED)
def test_actuators_compensate_gravity_as_in_mujoco_or_a_note_says_so(name: str, tmp_path: Path) -> None:
    """A lift in a body acts at all joints: at some alone it cannot be, nor be limited."""
    written_, said = ACTUATED[name]
    path = written(tmp_path, *written_)
    imported = lw.import_mjcf(path)
    notes = [str(note) for note in imported.notes if note.topic == "gravcomp"]
    if said:
        assert len(notes) == 1
        assert re.search(said, notes[0])
        return
    assert not notes
    assert np.abs(accelerations(imported.model) - at_rest_in_mujoco(path)).max() < 1e-10


def at_rest_in_mujoco(path: Path) -> np.ndarray:
    """v_dot of each body (n, 6), the angular one in body axes."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data, out = mujoco.MjData(model), []
    mujoco.mj_forward(model, data)
    mujoco.mj_rnePostConstraint(model, data)
    for body in range(1, model.nbody):
        found = np.zeros(6)
        mujoco.mj_objectAcceleration(model, data, mujoco.mjtObj.mjOBJ_BODY, body, found, 0)
        A = data.xmat[body].reshape(3, 3)
        out.append([*(found[3:] + model.opt.gravity), *(A.T @ found[:3])])  # theirs is against free fall
    return np.array(out)


@pytest.mark.parametrize("shares", [(-0.5,), (-0.5, 0.25), (0.25, -0.5), (-0.5, 0.0), (0.5, 2.0)])
def test_negative_gravity_compensation_acts_where_it_does_in_mujoco(
    shares: tuple[float, ...], tmp_path: Path
) -> None:
    """Only in models with a positive one."""
    bodies = "".join(
        f'<body name="b{k}" gravcomp="{share}"><freejoint/>{INERTIAL}</body>'
        for k, share in enumerate(shares)
    )
    path = written(tmp_path, bodies)
    assert np.abs(accelerations(lw.import_mjcf(path).model) - at_rest_in_mujoco(path)).max() < 1e-10


def test_a_damped_free_body_approaches_its_speed_of_fall(tmp_path: Path) -> None:
    """(m + a) v_dot = -m g - d v: the armature a has no weight."""
    inertial = '<inertial pos="0 0 0" mass="2" diaginertia="0.1 0.1 0.1"/>'
    path = written(
        tmp_path, f'<body name="ball"><joint type="free" damping="0.8" armature="0.5"/>{inertial}</body>'
    )
    model = lw.import_mjcf(path).model
    result = lw.simulate(model, t_end=4.0, step=1e-3)
    terminal, rate = 2 * 9.81 / 0.8, 0.8 / 2.5
    expected = -terminal * (1 - np.exp(-rate * result.t))
    assert np.abs(result.v[:, model.find("ball").index, 2] - expected).max() < 1e-9


@pytest.mark.parametrize("flag", ["equality", "constraint"])
def test_equalities_that_a_flag_disables_are_left_out_and_noted(flag: str, tmp_path: Path) -> None:
    bodies = "".join(
        f'<body name="{name}"><joint name="q{name}" axis="0 0 1"/>{INERTIAL}</body>' for name in "ab"
    )
    glue, gear = '<weld name="glue" body1="a" body2="b"/>', '<joint name="gear" joint1="qa" joint2="qb"/>'
    rest = f"<equality>{glue}{gear}</equality>"
    imported = lw.import_mjcf(written(tmp_path, bodies, rest, f'{flag}="disable"'))
    assert imported.model.joint_count == 2
    found = {note.subject for note in imported.notes if "disabled by a flag" in note.message}
    assert found == {"equality 'glue'", "equality 'gear'"}
    assert lw.import_mjcf(written(tmp_path, bodies, rest)).model.joint_count == 4


@pytest.mark.parametrize(
    ("flags", "topics"),
    [("", {"limits", "contact", "friction"}), ('limit="disable"', {"contact", "friction"}),
     ('contact="disable"', {"limits", "friction"}), ('frictionloss="disable"', {"limits", "contact"}),
     ('constraint="disable"', set())],
)  # fmt: skip
def test_what_a_flag_disables_is_not_missing(flags: str, topics: set[str], tmp_path: Path) -> None:
    body = (f'<body name="a"><joint name="j" range="-1 1" limited="true" frictionloss="0.2"/>{INERTIAL}'
            f'<geom size="0.1"/></body>')  # fmt: skip
    found = {note.topic for note in lw.import_mjcf(written(tmp_path, body, flags=flags)).notes}
    assert found == topics


def test_coordinates_of_several_joints_of_a_body_are_from_their_references(tmp_path: Path) -> None:
    """q - ref is the motion from the file's pose: by each of the joints."""
    slides = ('<joint name="x" type="slide" axis="1 0 0" ref="0.4"/>'
              '<joint name="y" type="slide" axis="0 1 0" ref="-0.2"/>')  # fmt: skip
    turn = '<joint name="turn" axis="0 0 1" ref="90"/>'
    body = f'<body name="a" pos="0.3 0 0">{slides}{turn}{INERTIAL}</body>'
    path = written(tmp_path, body)
    theirs = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(theirs)
    data.qpos[:] = 1.0, 0.5, 0.3
    mujoco.mj_forward(theirs, data)
    core = lw.import_mjcf(path, coordinates={"x+y+turn": (1.0, 0.5, 0.3)}).model.compiled()
    assert core.q0[:3] == pytest.approx(data.xipos[1], abs=1e-14)
    at_rest = lw.import_mjcf(path, coordinates={"x+y+turn": (0.4, -0.2, np.pi / 2)}).model.compiled()
    assert at_rest.q0 == pytest.approx(lw.import_mjcf(path).model.compiled().q0, abs=1e-14)


def jointed(tmp_path: Path, joints: str) -> tuple[Path, mujoco.MjModel, mujoco.MjData]:
    """A body on these joints, also as MuJoCo has it."""
    path = tmp_path / "model.xml"
    path.write_text(
        '<mujoco><compiler angle="radian"/><option timestep="1e-3" integrator="RK4"/><worldbody>'
        f'<body name="a" pos="1 2 3" quat="1 2 3 4">{joints}{INERTIAL}</body></worldbody></mujoco>'
    )
    theirs = mujoco.MjModel.from_xml_path(str(path))
    return path, theirs, mujoco.MjData(theirs)


def assert_moves_as(theirs: mujoco.MjModel, data: mujoco.MjData, found: Sequence[JointCoordinate]) -> None:
    """From the state that MuJoCo has now, over 200 of its steps: one coordinate for each of its own."""
    assert [it.value[0] for it in found] == pytest.approx(data.qpos, abs=1e-12)
    for _ in range(200):
        mujoco.mj_step(theirs, data)
    assert [it.value[-1] for it in found] == pytest.approx(data.qpos, abs=1e-5)
    assert [it.rate[-1] for it in found] == pytest.approx(data.qvel, abs=1e-4)


#: Joints of one body that no one joint here stands for, with what acts at each.
FOLLOWING = {
    "three hinges": '<joint name="a" axis="1 0 0" damping="0.3" armature="0.02" limited="true" range="-2 2"/>'
                    '<joint name="b" axis="0 1 0.3" pos="0.1 0 0" ref="0.2"/>'
                    '<joint name="c" axis="0 0.2 1" stiffness="2" springref="0.5"/>',
    "damped universal": '<joint name="a" axis="1 0 0" damping="0.3"/><joint name="b" axis="0 1 0"/>',
    "slides": '<joint name="a" type="slide" axis="1 0 0.5" stiffness="9" ref="0.1"/>'
              '<joint name="b" type="slide" axis="0 1 0"/><joint name="c" type="slide" axis="0 0.2 1"/>',
}  # fmt: skip


@pytest.mark.parametrize("name", FOLLOWING)
def test_joints_of_a_body_follow_each_other_as_in_mujoco(name: str, tmp_path: Path) -> None:
    """In the motion, each by its coordinate, and with each limit a stop."""
    path, theirs, data = jointed(tmp_path, FOLLOWING[name])
    names = "abc"[: theirs.njnt]
    data.qpos[:], data.qvel[:] = [0.8, -0.5, 0.4][: theirs.nq], [0.3, 0.7, -1.0][: theirs.nv]
    start = {"coordinates": dict(zip(names, data.qpos.tolist(), strict=True)),
             "velocities": dict(zip(names, data.qvel.tolist(), strict=True))}  # fmt: skip
    imported = lw.import_mjcf(path, limits="stops", **start)
    assert [note.subject for note in imported.notes if note.topic == "massless"] == ["body 'a'"]
    result = lw.simulate(imported.model, t_end=0.2, step=1e-3)
    which = "displacement" if name == "slides" else "angle"
    found = [result.coordinate(joint, which) for joint in names]
    assert_moves_as(theirs, data, found)
    stops = imported.model.compiled().find_force("a stop") >= 0
    assert stops == bool(theirs.jnt_limited[0])


def test_a_motion_twice_without_inertia_between_is_refused_by_name(tmp_path: Path) -> None:
    body = f'<body name="arm"><joint name="a" axis="0 0 1"/><joint name="b" axis="0 0 1"/>{INERTIAL}</body>'
    model = lw.import_mjcf(written(tmp_path, body)).model
    with pytest.raises(lw.SingularSystemError, match="body 'a link' has a motion without inertia"):
        lw.simulate(model, t_end=0.1, step=1e-3)
    with_rotor = body.replace('name="b"', 'name="b" armature="0.1"')
    lw.simulate(lw.import_mjcf(written(tmp_path, with_rotor)).model, t_end=0.1, step=1e-3)


#: Joints of one body, each somewhere else; the axes are those of a frame.
SEVERAL = {
    "slide, hinge": ("slide z", "hinge z"),
    "hinge, slide": ("hinge z", "slide z"),
    "hinge, slide back": ("hinge z", "slide -z"),
    "two slides, hinge": ("slide x", "slide y", "hinge z"),
    "slide": ("slide x",),
}


@pytest.mark.parametrize("name", SEVERAL)
def test_bodies_turn_about_the_points_of_their_hinges(name: str, tmp_path: Path) -> None:
    """Where slides have their points does not matter."""
    axes = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1", "-z": "0 0 -1"}
    joints = "".join(
        f'<joint name="q{k}" type="{kind}" axis="{axes[axis]}" pos="{0.3 * k - 0.2} 0.4 {0.1 + k}"/>'
        for k, (kind, axis) in enumerate(map(str.split, SEVERAL[name]))
    )
    path = written(tmp_path, f'<body name="a" quat="0.8 0.2 0.4 0.1" pos="0 0 1">{joints}{INERTIAL}</body>')
    for seed in range(3):
        assert largest_difference(path, np.random.default_rng(seed)) < 1e-12


@pytest.mark.parametrize("q", [3.0, np.pi, -np.pi, 4.0, -7.0, 40.0])
@pytest.mark.parametrize("more", ["", 'ref="4"', 'springref="4"', 'ref="-3" springref="13"'])
def test_springs_know_full_turns_before_the_start(q: float, more: str, tmp_path: Path) -> None:
    path = tmp_path / "model.xml"
    path.write_text(
        '<mujoco><compiler angle="radian"/><option gravity="0 0 0"/><worldbody><body name="a" quat="1 2 3 4">'
        f'<joint name="q" axis="1 2 0.3" stiffness="0.7" {more}/>{INERTIAL}</body></worldbody></mujoco>'
    )
    theirs = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(theirs)
    data.qpos[:] = q
    mujoco.mj_forward(theirs, data)
    imported = lw.import_mjcf(path, coordinates={"q": q})
    q_ddot = accelerations(imported.model)[0, 3:] @ theirs.jnt_axis[0]
    assert q_ddot == pytest.approx(data.qacc[0], rel=1e-9, abs=1e-10)
    assert ("coordinates" in {note.topic for note in imported.notes}) == (abs(q) > np.pi)


def test_an_angle_in_results_begins_where_the_note_says(tmp_path: Path) -> None:
    body = f'<body name="a"><joint name="q" axis="0 0 1"/>{INERTIAL}</body>'
    imported = lw.import_mjcf(written(tmp_path, body), coordinates={"q": np.radians(200)})
    assert [str(note) for note in imported.notes] == [
        "joint 'q': turned by 3.49066 rad at the start: its angle in results begins within a turn, "
        "at -2.79253 rad"
    ]
    result = lw.simulate(imported.model, t_end=0.01, step=1e-3)
    assert result.coordinate("q").value[0] == pytest.approx(np.radians(-160), abs=1e-14)


def test_what_is_not_linear_or_cannot_be_at_a_joint_is_noted(tmp_path: Path) -> None:
    bodies = (f'<body name="a"><joint name="j" stiffness="1 2" damping="0.3 0 0.1"/>{INERTIAL}</body>'
              f'<body name="b"><joint name="k" type="ball" armature="0.3"/>{INERTIAL}</body>'
              f'<body name="c"><joint name="f" type="free" frictionloss="3"/>{INERTIAL}</body>')  # fmt: skip
    rest = '<actuator><motor name="m" joint="k" gear="1 2 3" armature="0.1"/></actuator>'
    notes = {(note.topic, note.subject) for note in lw.import_mjcf(written(tmp_path, bodies, rest)).notes}
    assert notes >= {("nonlinear", "joint 'j'"), ("armature", "joint 'k'"), ("friction", "joint 'f'")}
    said = "\n".join(map(str, lw.import_mjcf(written(tmp_path, bodies, rest)).notes))
    assert "actuator 'm': is not represented, nor its damping and armature" in said


def test_a_weld_without_torque_is_a_ball(tmp_path: Path) -> None:
    free = f"<freejoint/>{INERTIAL}"
    bodies = f'<body name="a">{free}</body><body name="b" pos="1 0 0">{free}</body>'
    rest = '<equality><weld body1="a" body2="b" torquescale="0"/></equality>'
    assert lw.import_mjcf(written(tmp_path, bodies, rest)).model.row_count == 3


MEASURED = {
    "hinge": ('<joint name="a" axis="1 2 0" ref="1.2" stiffness="3" springref="0.3"/>', ["angle"]),
    "slide": ('<joint name="a" type="slide" axis="1 2 0" ref="0.4" stiffness="3"/>', ["displacement"]),
    "universal": ('<joint name="a" axis="1 2 0" ref="0.4" pos="0.1 0 0"/><joint name="b" axis="-2 1 1" '
                  'ref="-0.3" pos="0.1 0 0"/>', ["angle_a", "angle_b"]),
    "cylindrical": ('<joint name="a" type="slide" axis="1 2 0" ref="0.4"/><joint name="b" axis="1 2 0" '
                    'ref="0.7"/>', ["displacement", "angle"]),
}  # fmt: skip


@pytest.mark.parametrize("name", MEASURED)
def test_coordinates_in_results_are_those_of_mujoco(name: str, tmp_path: Path) -> None:
    joints, which = MEASURED[name]
    path, theirs, data = jointed(tmp_path, joints)
    data.qpos[:], data.qvel[:] = [0.8, -0.5][: theirs.nq], [0.3, 0.7][: theirs.nv]
    given = "+".join("ab"[: theirs.njnt])
    start = {"coordinates": {given: data.qpos.copy()}, "velocities": {given: data.qvel.copy()}}
    result = lw.simulate(lw.import_mjcf(path, **start).model, t_end=0.2, step=1e-3)
    found = [result.coordinate(given, it) for it in which]
    assert_moves_as(theirs, data, found)


def test_stops_are_where_mujoco_has_them_though_coordinates_have_a_reference(tmp_path: Path) -> None:
    body = f'<body name="a"><joint name="q" axis="0 0 1" ref="40" range="-20 60"/>{INERTIAL}</body>'
    path = written(tmp_path, body, '<compiler angle="degree"/>')
    start = {"coordinates": {"q": np.radians(59)}, "velocities": {"q": 1.0}}
    result = lw.simulate(lw.import_mjcf(path, limits="stops", **start).model, t_end=0.1, step=1e-4)
    assert np.radians(60.1) < result.coordinate("q").value.max() < np.radians(61)


@pytest.mark.parametrize("margin", [0.2, -0.1])
def test_stops_begin_by_the_margin_before_the_ends_as_in_mujoco(margin: float, tmp_path: Path) -> None:
    """A load at rest on its limit: at the same place but for how soft both are."""
    joint = f'<joint name="q" type="slide" axis="0 0 1" range="-0.5 0.5" damping="30" margin="{margin}"/>'
    path = written(tmp_path, f'<body name="a">{joint}{INERTIAL}</body>')
    theirs = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(theirs)
    mujoco.mj_step(theirs, data, 2000)
    result = lw.simulate(lw.import_mjcf(path, limits="stops").model, t_end=4.0, rtol=1e-6)
    at = result.coordinate("q").value[-1]
    assert at == pytest.approx(margin - 0.5, abs=2e-3)
    assert at == pytest.approx(data.qpos[0], abs=2e-3)


@pytest.mark.parametrize(("given", "limits", "said"), [
    ('margin="0.2"', "note", "limits -0.5 to 0.5, which margin 0.2 makes -0.3 to 0.3, are not represented"),
    ('margin="0.5"', "stops", "limits -0.5 to 0.5, which margin 0.5 makes 0 to 0, are not represented"),
    ('solreflimit="0.1 1"', "stops", "solreflimit of its limits is not taken"),
    ('solimplimit="0.5 0.9"', "stops", "solimplimit of its limits is not taken"),
    ('solreflimit="0.02 1" solimplimit="0.9 0.95" margin="0"', "stops", None),
])  # fmt: skip
def test_what_limits_have_besides_their_ends_is_taken_or_noted(
    given: str, limits: Any, said: str | None, tmp_path: Path
) -> None:
    body = f'<body name="a"><joint name="q" range="-0.5 0.5" {given}/>{INERTIAL}</body>'
    path = written(tmp_path, body, '<compiler angle="radian"/>')
    found = [str(it) for it in lw.import_mjcf(path, limits=limits).notes if it.topic == "limits"]
    stop = [it for it in found if "are stops of" in it]
    assert any(it.startswith(f"joint 'q': {said}") for it in found) if said else found == stop


@pytest.mark.parametrize(("joints", "which"), [
    ('<joint name="a" type="slide" axis="0 0 1"/><joint name="b" axis="0 0 -1"/>', "angle"),
    ('<joint name="a" axis="0 0 1"/><joint name="b" type="slide" axis="0 0 -1"/>', "displacement"),
])  # fmt: skip
def test_a_coordinate_that_counts_the_other_way_is_noted(joints: str, which: str, tmp_path: Path) -> None:
    path = written(tmp_path, f'<body name="a">{joints}{INERTIAL}</body>')
    imported = lw.import_mjcf(path, coordinates={"a+b": (0.1, 0.2)})
    assert [str(note) for note in imported.notes] == [
        f"joint 'a+b': its two axes are opposite: its {which} in results has the other sign than in the file"
    ]
    result = lw.simulate(imported.model, t_end=0.01, step=1e-3)
    assert result.coordinate("a+b", which).value[0] == pytest.approx(-0.2)


def test_bodies_without_names_are_not_those_that_have_the_invented_ones(tmp_path: Path) -> None:
    heavy = INERTIAL.replace('mass="2"', 'mass="5"')
    body = (f'<body><joint type="free" name="k" armature="3"/>{INERTIAL}</body>'
            f'<body name="body 1" pos="1 0 0"><joint axis="0 1 0"/>{heavy}</body>'
            f'<body name="k rotor" pos="2 0 0"><joint axis="0 1 0"/>{INERTIAL}</body>')  # fmt: skip
    core = lw.import_mjcf(written(tmp_path, body)).model.compiled()
    names = [core.body_name(k) for k in range(core.body_count)]
    assert dict(zip(names, core.mass.tolist(), strict=True)) == {
        "body 1 2": 2, "body 1": 5, "k rotor": 2, "k rotor 2": 3,
    }  # fmt: skip


def test_joints_without_names_are_not_those_that_have_the_invented_ones(tmp_path: Path) -> None:
    """Of a joint, a fixed body, several joints of one body and an equality."""
    two = '<joint name="x" type="slide" axis="0 0 1"/><joint name="y" axis="0 0 1"/>'
    body = (f'<body name="a"><joint/>{INERTIAL}<body name="b">{INERTIAL}</body></body>'
            f'<body name="c"><joint name="joint 0"/>{INERTIAL}<body name="d">{two}{INERTIAL}</body></body>'
            f'<body name="e"><joint name="b fixed"/>{INERTIAL}</body>'
            f'<body name="f"><joint name="x+y"/>{INERTIAL}</body>'
            f'<body name="g"><joint name="lock"/>{INERTIAL}</body>')  # fmt: skip
    rest = '<equality><connect name="lock" body1="f" body2="g" anchor="0 0 0"/></equality>'
    core = lw.import_mjcf(written(tmp_path, body, rest)).model.compiled()
    joints = {core.joint_name(k): core.joint_arrays()["bodies"][k, 1] for k in range(core.joint_count)}
    assert {name: core.body_name(body) for name, body in joints.items()} == {
        "joint 0 2": "a", "b fixed 2": "b", "joint 0": "c", "x+y 2": "d", "b fixed": "e", "x+y": "f",
        "lock": "g", "lock 2": "g",
    }  # fmt: skip


def test_a_joint_equality_is_noted_as_rigid(tmp_path: Path) -> None:
    body = "".join(f'<body name="{q}"><joint name="{q}"/>{INERTIAL}</body>' for q in "xy")
    path = written(tmp_path, body, '<equality><joint name="e" joint1="x" joint2="y"/></equality>')
    assert [str(it) for it in lw.import_mjcf(path).notes] == [
        "equality 'e': soft in MuJoCo, a rigid coupler here"
    ]


RELATED = {
    "about and along one axis": '<joint name="x" axis="0 0 1"/><joint name="y" type="slide" axis="0 0 1"/>',
    "about axes at right angles": '<joint name="x" axis="1 0 0"/><joint name="y" axis="0 1 0"/>',
    "in a plane": '<joint name="x" type="slide" axis="1 0 0"/><joint name="z" type="slide" axis="0 1 0"/>'
                  '<joint name="y" axis="0 0 1"/>',
}  # fmt: skip

RELATION = '<equality><joint name="e" joint1="x" joint2="y" polycoef="0.1 2 {} 0 0"/></equality>'


@pytest.mark.parametrize("name", RELATED)
def test_joints_of_one_body_follow_each_other_by_the_relation_of_the_file(name: str, tmp_path: Path) -> None:
    """M a + c = J^T lambda,  J a = 0,  of x - 2 y = 0.1, by MuJoCo's M and c."""
    path = written(tmp_path, f'<body name="a" quat="5 1 2 3">{RELATED[name]}{INERTIAL}</body>',
                   RELATION.format(0), 'constraint="enable"')  # fmt: skip
    imported = lw.import_mjcf(path, coordinates={"y": 0.3}, velocities={"y": 0.7})
    theirs = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(theirs)
    x, y = (theirs.joint(joint).id for joint in "xy")
    data.qpos[[x, y]], data.qvel[[x, y]] = (0.7, 0.3), (1.4, 0.7)
    mujoco.mj_forward(theirs, data)
    J, solved = np.zeros(theirs.nv), np.zeros((2, theirs.nv))
    J[[x, y]] = 1, -2
    mujoco.mj_solveM(theirs, data, solved, np.array([J, -data.qfrc_bias]))  # M^-1 J^T, -M^-1 c
    data.qacc[:] = solved[1] - solved[0] * (J @ solved[1]) / (J @ solved[0])
    mujoco.mj_rnePostConstraint(theirs, data)
    expected = np.zeros(6)
    mujoco.mj_objectAcceleration(theirs, data, mujoco.mjtObj.mjOBJ_BODY, 1, expected, 0)
    k = imported.model.find("a").index
    A = lw.rotation.matrix(imported.model.compiled().poses(np.array([k], np.int32))[0, 3:])
    found = accelerations(imported.model)[k]
    assert found[:3] == pytest.approx(expected[3:] + theirs.opt.gravity, rel=1e-9, abs=1e-9)
    assert A @ found[3:] == pytest.approx(expected[:3], rel=1e-9, abs=1e-9)
    said = [str(note) for note in imported.notes if note.topic == "equality"]
    assert said == ["equality 'e': soft in MuJoCo, a rigid coupler here"]


@pytest.mark.parametrize(
    ("square", "couple", "how"), [(0, False, ""), (1, True, " by more than a linear relation")]
)
def test_joints_of_one_body_are_one_joint_where_no_relation_of_them_is_taken(
    square: int, couple: bool, how: str, tmp_path: Path
) -> None:
    path = written(
        tmp_path, f'<body name="a">{RELATED["in a plane"]}{INERTIAL}</body>', RELATION.format(square)
    )
    imported = lw.import_mjcf(path, couple=couple)
    assert imported.model.compiled().joint_name(0) == "x+z+y"
    said = f"equality 'e': that joint 'x' follows 'y'{how} is not represented"
    assert [str(note) for note in imported.notes] == [said]


def test_a_body_named_ground_has_a_free_name_and_one_with_a_tab_has_a_space(tmp_path: Path) -> None:
    text = (f'<body name="ground"><joint name="j"/>{INERTIAL}'
            f'<body name="a&#9;b"><joint name="k"/>{INERTIAL}</body></body>')  # fmt: skip
    imported = lw.import_mjcf(written(tmp_path, text))
    assert [imported.model.compiled().body_name(k) for k in range(2)] == ["ground 2", "a b"]
    assert sorted((note.topic, note.subject) for note in imported.notes) == [
        ("name", "link 'a b'"), ("name", "link 'ground'"),
    ]  # fmt: skip


def test_a_chain_of_bodies_in_each_other_is_read(tmp_path: Path) -> None:
    """More than Python has calls in calls; MuJoCo takes 498 in a file, 1024 in all."""

    def chain(prefix: str, inner: str) -> str:
        bodies = (f'<body name="{prefix}{k}" pos="0 0 0.1"><joint/>{INERTIAL}' for k in range(490))
        return "".join(bodies) + inner + "</body>" * 490

    (tmp_path / "more.xml").write_text(f"<mujocoinclude>{chain('b', '')}</mujocoinclude>")
    path = written(tmp_path, chain("a", '<include file="more.xml"/>'))
    assert lw.import_mjcf(path).model.body_count == 980
