"""The robots of the package example-robot-data (a large download: `./dev test --models`): every file loads or
is
refused with a true reason, and what loads moves as in Pinocchio."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest

pytestmark = pytest.mark.models


def _folder() -> Path:
    found = (Path(place) / "cmeel.prefix/share/example-robot-data/robots" for place in sys.path)
    return next((folder for folder in found if folder.is_dir()), Path("example-robot-data is not installed"))


ROBOTS = _folder()
URDF_FILES = sorted(ROBOTS.rglob("*.urdf"))
SDF_FILES = sorted(ROBOTS.rglob("*.sdf"))

#: Files that are refused as they are, with the words of the reason.
REFUSED = {
    "alex_psyonic_hands.urdf": "no joint 'index_q1'",
    "allegro_left_hand.urdf": "triangle inequality",
    "allegro_right_hand.urdf": "triangle inequality",
    "human.urdf": "moves but has no mass",
    "hyq_no_sensors.urdf": "triangle inequality",
    "icub.urdf": "moves but has no moment of inertia",
    "icub_reduced.urdf": "moves but has no moment of inertia",
    "pr2.urdf": "triangle inequality",
    "romeo.urdf": "moves but has no mass",
    "romeo_laas_small.urdf": "moves but has no mass",
    "romeo_small.urdf": "triangle inequality",
    "ur3.urdf": "has no links",
    "cassie.sdf": "triangle inequality",
}


def named(name: str) -> Path:
    return next(path for path in (*URDF_FILES, *SDF_FILES) if path.name == name)


def test_there_are_the_files_that_are_expected() -> None:
    assert ROBOTS.is_dir(), ROBOTS
    assert len(URDF_FILES) >= 60 and len(SDF_FILES) == 5


@pytest.mark.parametrize("path", [*URDF_FILES, *SDF_FILES], ids=lambda path: path.name)
def test_every_file_loads_or_is_refused_with_the_reason(path: Path, tmp_path: Path) -> None:
    """What loads can be saved, and comes back exactly."""
    read = lw.import_urdf if path.suffix == ".urdf" else lw.import_sdf
    if path.name not in REFUSED:
        model = read(path).model
        assert model.joint_count >= model.body_count - 1
        model.save(tmp_path / "robot.yaml")
        assert lw.Model.load(tmp_path / "robot.yaml").hash() == model.hash()
        return
    with pytest.raises(lw.ModelFileError, match=REFUSED[path.name]) as refused:
        read(path)
    lines = path.read_text(errors="replace").count("\n") + 1
    assert all(1 <= fault.line <= lines for fault in refused.value.faults)


@pytest.mark.parametrize(
    "name", [name for name in REFUSED if name not in ("ur3.urdf", "alex_psyonic_hands.urdf")]
)
def test_files_with_wrong_inertias_load_where_that_is_asked_for(name: str) -> None:
    read = lw.import_urdf if name.endswith("urdf") else lw.import_sdf
    imported = read(named(name), repair_inertia=True, keep_massless=True)
    assert {note.topic for note in imported.notes} & {"inertia", "massless"}


# --- against Pinocchio --------------------------------------------------------------------------------------

#: Different kinds of robots: arms, legs, humanoids, with sliders, branches, damping, continuous joints.
COMPARED = (
    "panda.urdf", "ur5_robot.urdf", "kinova.urdf", "solo12.urdf", "bolt.urdf", "a1.urdf",
    "tiago_no_hand.urdf", "talos_reduced.urdf", "double_pendulum.urdf", "baxter.urdf", "anymal-kinova.urdf",
    "z1.urdf",
)  # fmt: skip

STATES = 20


@pytest.mark.parametrize("name", COMPARED)
def test_forward_dynamics_agrees_with_aba(name: str) -> None:
    import pinocchio as pin

    path = named(name)
    theirs = pin.buildModelFromUrdf(str(path))
    data = theirs.createData()
    damping, friction = _dissipation(path)
    rng = np.random.default_rng(7)
    for _ in range(STATES):
        angles, rates = rng.uniform(-1, 1, theirs.nv), rng.uniform(-1, 1, theirs.nv)
        joints = list(theirs.names)[1:]
        q = _configuration(theirs, angles)
        c, f = (np.array([table.get(joint, 0.0) for joint in joints]) for table in (damping, friction))
        slides = np.array(["P" in theirs.joints[k + 1].shortname()[6:8] for k in range(len(joints))])
        tau = -c * rates - f * np.tanh(rates / np.where(slides, 1e-3, 1e-2))
        qdd = pin.aba(theirs, data, q, rates, tau)
        pin.forwardKinematics(theirs, data, q, rates, qdd)
        pin.updateFramePlacements(theirs, data)

        # aba does not heed mimics
        model = lw.import_urdf(path, coordinates=dict(zip(joints, angles, strict=True)), couple=False,
                               velocities=dict(zip(joints, rates, strict=True))).model  # fmt: skip
        core = model.compiled()
        v_dot = lw.System(model).accelerations(0.0, core.q0, core.v0)[0].reshape(-1, 6)
        _compare(pin, theirs, data, core, v_dot)


def _compare(pin: Any, theirs: Any, data: Any, core: Any, v_dot: np.ndarray) -> None:
    """Pose, velocity and acceleration of the center of mass, and angular acceleration, of every body."""
    q, v = core.q0.reshape(-1, 7), core.v0.reshape(-1, 6)
    scale = np.abs(v_dot).max()
    for k in range(core.body_count):
        frame = theirs.getFrameId(core.body_name(k), pin.FrameType.BODY)
        placement, A = data.oMf[frame], lw.rotation.matrix(q[k, 3:])
        assert pytest.approx(placement.rotation, abs=1e-12) == A
        axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        speed = pin.getFrameVelocity(theirs, data, frame, axes)
        acceleration = pin.getFrameClassicalAcceleration(theirs, data, frame, axes)
        arm, w, alpha = q[k, :3] - placement.translation, speed.angular, acceleration.angular
        assert v[k, :3] == pytest.approx(speed.linear + np.cross(w, arm), abs=1e-11)
        linear = acceleration.linear + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
        found = np.concatenate([v_dot[k, :3], A @ v_dot[k, 3:]])
        assert np.abs(found - [*linear, *alpha]).max() <= 1e-8 * max(1.0, scale), core.body_name(k)


def _configuration(theirs: Any, angles: np.ndarray) -> np.ndarray:
    """Pinocchio has cosine and sine of an angle without limits."""
    q = np.zeros(theirs.nq)
    for joint, angle in zip(list(theirs.joints)[1:], angles, strict=True):
        q[joint.idx_q : joint.idx_q + joint.nq] = angle if joint.nq == 1 else [np.cos(angle), np.sin(angle)]
    return q


def _dissipation(path: Path) -> tuple[dict[str, float], dict[str, float]]:
    """Damping and friction of each joint of the file, which aba leaves to the torques."""
    from xml.etree import ElementTree

    damping, friction = {}, {}
    for joint in ElementTree.parse(path).getroot().iter("joint"):
        found = joint.find("dynamics")
        if found is not None and "type" in joint.attrib:
            damping[joint.attrib["name"]] = float(found.get("damping", 0))
            friction[joint.attrib["name"]] = float(found.get("friction", 0))
    return damping, friction


DRIFT: dict[str, Any] = {
    "violation_limit": {"position": 1e-8, "velocity": 1e-6},
    "on_violation": "stop",
}


# --- closed loops -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", SDF_FILES, ids=lambda path: path.name)
def test_cassie_runs_with_its_loops_within_the_limit_of_violation(path: Path) -> None:
    """In free fall and turning: the files have no floor. That at a dead center needs a regularized matrix."""
    model = lw.import_sdf(path, repair_inertia=True).model
    assert model.joint_count > model.body_count - 1
    formulation = "augmented_lagrangian" if path.name == "cassie.sdf" else "standard"
    result = lw.simulate(model, t_end=2.0, step=1e-3, formulation=formulation, **DRIFT)
    assert result.t[-1] == pytest.approx(2.0)
    assert np.ptp(result.energy) < 1e-8 * np.abs(result.energy).max()


@pytest.mark.parametrize(
    "path", [path for path in SDF_FILES if path.name != "cassie.sdf"], ids=lambda path: path.name
)
def test_cassie_hangs_by_its_pelvis(path: Path) -> None:
    """Its legs fall without stops through poses that are nearly singular: the steps follow the motion."""
    model = lw.import_sdf(path, repair_inertia=True, floating=False).model
    result = lw.simulate(model, t_end=2.0, step=1e-3, integrator="dopri5", rtol=1e-8, **DRIFT)
    assert result.t[-1] == pytest.approx(2.0)


def test_cassie_with_rigid_springs_is_at_a_dead_center_for_good() -> None:
    """In cassie.sdf a slide across the line of two hinges stands for the spring of the knee: a triangle
    without freedom that is singular in the only pose that it has."""
    model = lw.import_sdf(named("cassie.sdf"), repair_inertia=True, floating=False).model
    rank = lw.System(model).compiled().rank()
    joints = {model.compiled().describe_row(row).split("'")[1] for row in rank.singular_rows}
    for side in ("left", "right"):
        assert joints & {f"{side}-knee-shin-joint", f"{side}-knee-spring-joint"}, joints
    with pytest.raises(lw.NotConvergedError, match="singular pose"):
        lw.simulate(model, t_end=0.1, step=1e-3)


def test_cassie_as_in_the_file_is_locked_by_rounded_angles() -> None:
    """1.5708 for pi / 2 turns axes of the planar feet by up to 1e-5 rad, which locks feet: how many is
    within the square of that, 1e-10, and so within the tolerance."""
    path = named("cassie_v2.sdf")
    found = [lw.import_sdf(path, repair_inertia=True, align_axes=angle) for angle in (None, 0)]
    free, literal = (lw.System(imported.model).compiled().rank().degrees_of_freedom for imported in found)
    assert free == 18 and literal in (16, 17)
    angles = [float(note.message.split()[5]) for note in found[0].notes if note.topic == "axis"]
    assert angles and max(angles) < 2e-5
