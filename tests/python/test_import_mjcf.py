"""MJCF files: against MuJoCo where it is exact (trees), against our own models where it is soft (loops)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import mujoco
import numpy as np
import pytest
from robot_files import ROBOTS, accelerations

SLIDER_CRANK = ROBOTS / "slider_crank.xml"


def written(tmp_path: Path, body: str, rest: str = "") -> Path:
    path = tmp_path / "model.xml"
    path.write_text(
        f'<mujoco model="test">\n<option gravity="0 0 -9.81"/>\n'
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


WRONG = [
    ('<body><joint type="hinge"/><joint type="hinge" axis="0 1 1"/><geom size="1"/></body>', "",
     "no joint here does"),
    ('<body><joint type="ball"/><joint type="slide"/><geom size="1"/></body>', "", "no joint here does"),
    ('<body name="a"><freejoint/><geom size="1"/><site name="s"/></body><site name="t"/>',
     '<tendon><spatial name="cord"><site site="s"/><site site="t"/></spatial></tendon>', "tendon 'cord'"),
    ('<body><joint type="door"/><geom size="1"/></body>', "", "MuJoCo: .*door"),
    ("<body>", "", "is no XML"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "rest", "message"), WRONG)
def test_what_cannot_be_is_refused_by_name(body: str, rest: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(lw.ModelFileError, match=message):
        lw.import_mjcf(written(tmp_path, body, rest))


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
    assert [note.subject for note in imported.notes if note.topic == "equality"] == ["equality 'square'"]
    result = lw.simulate(imported.model, t_end=1.0, step=1e-3)
    one, other = (result.coordinate(name).value for name in ("q1", "q2"))
    assert np.ptp(other) > 0.1
    assert one == pytest.approx(0.2 - 0.5 * other, abs=1e-9)
    assert other[0] == pytest.approx(0.5 + np.radians(15))


def test_what_is_not_in_the_model_is_listed(tmp_path: Path) -> None:
    body: Any = (f'<body name="a"><joint name="j" range="-1 1" limited="true" frictionloss="0.2"/>'
                 f'{INERTIAL}<geom size="0.1"/></body>')  # fmt: skip
    rest = (
        '<equality><joint joint1="j" name="lock"/></equality><actuator><motor joint="j" name="m"/></actuator>'
    )
    topics = {note.topic for note in lw.import_mjcf(written(tmp_path, body, rest)).notes}
    assert topics == {"limits", "friction", "equality", "actuator", "contact", "visual"}
