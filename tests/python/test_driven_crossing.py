"""Driven motions through singular poses: what frames in and beside them have is that of the branch."""

from __future__ import annotations

import time

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats

G, RATE, START = 9.81, 2.0, -0.6  # m/s^2, rad/s, rad
POSE = -START / RATE  # s, all links in line
BASE = 2.0  # m


def parallelogram(turn: object = None, masses: tuple[float, float, float] = (1.0, 1.0, 2.0)) -> lw.Model:
    """Cranks of 1 m, driven from the angle START, and a coupler that a point on a line holds at one end."""
    model, axis = lw.Model(gravity=(0, 0, -G)), (0.0, -1.0, 0.0)
    u = np.array([np.cos(START), 0.0, np.sin(START)])
    turned = lw.rotation.about(axis, START)
    for name, x, mass in (("left", 0.0, masses[0]), ("right", BASE, masses[1])):
        at, inertia = np.array([x, 0.0, 0.0]), (0.01, mass / 12, mass / 12)
        model.body(name, mass=mass, inertia=inertia, position=at + u / 2, orientation=turned)
        model.revolute("ground", name, at=at, axis=axis, name=f"pin {name}")
    model.body("coupler", mass=masses[2], inertia=(0.01, 0.7, 0.7), position=u + np.array([BASE / 2, 0, 0]))
    model.revolute("left", "coupler", at=u, axis=axis, name="joint left")
    model.point_on_line("right", "coupler", at=u + np.array([BASE, 0, 0]), axis=axis, name="joint right")
    turn = lw.functions.polynomial(0.0, RATE) if turn is None else turn
    model.drive("pin left", position=turn, name="motor")
    return model


def weight_torque(t: Floats, masses: tuple[float, float, float] = (1.0, 1.0, 2.0)) -> Floats:
    """[N m] at constant speed, when kinetic energy is constant."""
    torque: Floats = ((masses[0] + masses[1]) / 2 + masses[2]) * G * np.cos(START + RATE * t)
    return torque


@pytest.fixture(params=("dense", "sparse"))
def matrices(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.param == "sparse":
        monkeypatch.setattr("linkwork.constraints.solver.DENSE", 0)


@pytest.mark.usefixtures("matrices")
@pytest.mark.filterwarnings("ignore:kinematics. singular pose")
@pytest.mark.parametrize("frames", [11, 101, 201, 501, 2001])
def test_efforts_in_and_beside_a_pose_are_those_of_the_motion(frames: int) -> None:
    """The grids hold the pose, to the last digit or nearly so, and frames at 1e-3 rad from it."""
    needed = lw.inverse_dynamics(parallelogram(), np.linspace(0, 1, frames))
    assert needed.effort("motor") == pytest.approx(weight_torque(needed.t), rel=1e-7)
    place = needed.motion.body("coupler").position[:, 0]
    assert place == pytest.approx(np.cos(START + RATE * needed.t) + BASE / 2, abs=1e-9)


@pytest.mark.filterwarnings("ignore:kinematics")
@pytest.mark.parametrize("apart", [1e-9, 1e-7, 1e-5, 1e-3])
def test_frames_in_a_pose_and_just_beside_it_take_no_time(apart: float) -> None:
    t, begin = np.array([0, 0.1, 0.2, POSE, POSE + apart, 0.4]), time.perf_counter()
    needed = lw.inverse_dynamics(parallelogram(), t)
    assert needed.effort("motor") == pytest.approx(weight_torque(t), rel=1e-7)
    assert time.perf_counter() - begin < 5.0


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("start", [-1e-2, -1e-4])
def test_a_motion_may_begin_beside_a_pose(start: float) -> None:
    flat = lw.kinematics(parallelogram(), [0, POSE + start / RATE], on_singular="pass")
    turn = lw.functions.polynomial(-START + start, RATE)
    model = parallelogram(turn).with_initial_state(flat.q[-1], flat.v[-1])
    t = np.array([0.0, -start / RATE, 0.1])
    needed = lw.inverse_dynamics(model, t, on_singular="pass")
    assert needed.effort("motor") == pytest.approx(weight_torque(t + POSE + start / RATE), rel=1e-6)


@pytest.mark.filterwarnings("ignore:kinematics")
@pytest.mark.parametrize("beyond", [-1e-6, 0.0, 1e-6, 1e-3])
def test_a_motion_may_end_beside_a_pose_or_in_it(beyond: float) -> None:
    """Nothing is known of the driver beyond the end."""
    t = np.array([0.0, 0.2, POSE + beyond])
    needed = lw.inverse_dynamics(parallelogram(), t)
    assert needed.effort("motor") == pytest.approx(weight_torque(t), rel=1e-7)


def test_reactions_that_grow_toward_a_pose_are_told_and_grow_like_its_distance() -> None:
    """Cranks of unequal weight push along the other branch, too."""
    masses = (1.0, 3.0, 2.0)
    apart = np.array([1e-2, 1e-3, 1e-4, 1e-5])
    t = np.concatenate([[0.0], POSE - apart, POSE + apart[::-1], [0.6]])
    told = r"singular pose at t = 0.3 s.* toward it the reactions of .*'pin left'.* grow without limit"
    with pytest.warns(lw.LinkworkWarning, match=told):
        needed = lw.inverse_dynamics(parallelogram(masses=masses), t)
    assert needed.effort("motor") == pytest.approx(weight_torque(t, masses), rel=1e-7)
    force = needed.motion.reaction("pin left").force[1:-1, 0]
    before, after = force[:4], force[:3:-1]
    assert before - after == pytest.approx((before - after)[0] * apart[0] / apart, rel=1e-3)


@pytest.mark.usefixtures("matrices")
@pytest.mark.filterwarnings("ignore:kinematics")
@pytest.mark.parametrize("beyond", [-1e-4, 0.0, 1e-4, 1e-2])
def test_a_motion_may_turn_back_beside_a_pose_or_in_it(beyond: float) -> None:
    """Soon before and after it is in a pose twice, once, or not at all."""
    turn, w = lw.functions.harmonic(-START + beyond, 5.0), 5.0
    t = np.sort(np.append(np.linspace(0, 0.6, 61), np.pi / (2 * w)))
    needed = lw.inverse_dynamics(parallelogram(turn), t)
    angle = (-START + beyond) * np.sin(w * t)
    inertia = 2 / 3 + 2
    torque = 3 * G * np.cos(START + angle) - inertia * w**2 * angle
    assert needed.effort("motor") == pytest.approx(torque, abs=1e-5)
    assert len(needed.motion.singular_poses) == (2 if beyond > 0 else int(beyond == 0.0))


@pytest.mark.filterwarnings("ignore:kinematics. (the work|singular pose)")
@pytest.mark.parametrize("begins", [POSE, POSE + 2e-3])
def test_forces_that_begin_beside_a_pose_are_told_and_leave_no_trace_beyond(begins: float) -> None:
    """A torque on the driven crank is what its motor needs more."""
    model, jump = parallelogram(), lw.functions.piecewise_polynomial([-1, begins, 9], [[0.0], [100.0]])
    model.force("left", torque=(0, jump, 0))
    t = np.array([0.0, POSE - 5e-3, POSE - 1e-3, POSE, POSE + 1e-3, POSE + 5e-3, 0.6])
    with pytest.warns(lw.LinkworkWarning, match="forces are not smooth there"):
        needed = lw.inverse_dynamics(model, t)
    assert needed.effort("motor") == pytest.approx(weight_torque(t) + 100.0 * (t >= begins), rel=1e-6)


def test_poses_are_found_to_nearly_all_digits() -> None:
    motion = lw.kinematics(parallelogram(), np.linspace(0, 1, 8), on_singular="pass")
    assert [pose.t for pose in motion.singular_poses] == pytest.approx([POSE], abs=1e-10)


@pytest.mark.parametrize("second", [lw.functions.harmonic(0.3, 2.1), lw.functions.harmonic(0.6, 1.0)])
def test_drivers_that_part_after_the_start_are_said_to_contradict_each_other(
    second: lw.functions.TimeFunction,
) -> None:
    model = lw.Model()
    bar = model.body("bar", mass=2.0, inertia=(0.1, 0.1, 0.1), position=(0.3, 0, 0))
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.drive("pin", position=lw.functions.harmonic(0.3, 2.0), name="first")
    model.drive("pin", position=second, name="second")
    with pytest.raises(lw.NotConvergedError, match="'first', 'second' contradict each other from") as caught:
        lw.kinematics(model, np.linspace(0, 1, 5))
    assert caught.value.code == "contradiction" and caught.value.joints == ["first", "second"]
    assert caught.value.time is not None and caught.value.time < 2e-3


def test_hinges_of_a_driven_door_with_too_few_digits_are_told_what_they_lack() -> None:
    model = lw.Model()
    door = model.body("door", mass=20.0, inertia=(1.0, 2.0, 1.5), position=(0.4, 0, 0))
    axis = np.array((0.3, 0.2, 1.0)) / np.linalg.norm((0.3, 0.2, 1.0))
    lower = model.revolute("ground", door, at=(0, 0, 0), axis=axis, name="lower")
    model.revolute("ground", door, at=np.round(1.3 * axis, 8), axis=np.round(axis, 8), name="upper")
    model.drive(lower, position=lw.functions.harmonic(0.5, 3.0), name="motor")
    with pytest.raises(
        lw.NotConvergedError, match="contradict .* with all digits, or leave one out"
    ) as caught:
        lw.kinematics(model, np.linspace(0, 1, 5))
    assert sorted(caught.value.joints) == ["lower", "upper"]


def test_drivers_of_one_freedom_at_two_joints_are_named_before_the_joints() -> None:
    model = parallelogram()
    model.drive("pin right", position=lw.functions.polynomial(0.0, 1.1 * RATE), name="other motor")
    with pytest.raises(lw.NotConvergedError, match="contradict each other") as caught:
        lw.kinematics(model, [0.0, 0.1])
    assert set(caught.value.joints[:2]) == {"motor", "other motor"}
