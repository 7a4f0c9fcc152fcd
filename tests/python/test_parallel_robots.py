"""The parallel robots against their closed-form kinematics."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms.delta_robot import START, motions, tool_position
from linkwork.mechanisms.stewart_platform import base_points, platform_points, strokes
from test_mechanisms import dense_D


def run(model: lw.Model, t_end: float = 2.0) -> lw.Result:
    return lw.simulate(model, t_end=t_end, step=1e-3, progress=False)


# --- Stewart platform ---------------------------------------------------------------------------------------


def leg_lengths(result: lw.Result) -> np.ndarray:
    """By the pose of the platform (k, 6)."""
    platform = result.body("platform")
    heads = platform.position[:, None] + platform_points() @ lw.rotation.matrix(
        platform.orientation
    ).swapaxes(1, 2)
    lengths: np.ndarray = np.linalg.norm(heads - base_points(), axis=2)
    return lengths


def test_the_lengths_of_its_legs_place_a_stewart_platform() -> None:
    result = run(lw.mechanisms.stewart_platform(amplitude=0.2, rate=4.0))
    lengths = leg_lengths(result)
    wanted = np.array([[stroke.evaluate(t)[0] for stroke in strokes(0.2, 4.0)] for t in result.t])
    assert np.abs(lengths - lengths[0] - wanted).max() < 1e-9
    assert np.ptp(lw.rotation.matrix(result.body("platform").orientation)[:, 2, 2]) > 1e-3


def test_the_feet_of_a_stewart_platform_carry_all_of_its_weight() -> None:
    """At rest: 3000 kg and six legs of 135 kg."""
    result = run(lw.mechanisms.stewart_platform(amplitude=0.0), t_end=0.1)
    force = sum(result.reaction(f"foot {k}").force for k in range(1, 7))
    assert force[-1] == pytest.approx([0, 0, (3000 + 6 * 135) * 9.81], abs=1e-5)
    assert np.abs(result.velocity).max() < 1e-9


def test_a_stewart_platform_sinks_by_its_energy() -> None:
    result = run(lw.mechanisms.stewart_platform(driven=False), t_end=0.3)
    assert np.abs(result.energy_error).max() < 1e-7 * result.kinetic_energy.max()
    assert result.body("platform").position[-1, 2] < 1.8


# --- delta robot --------------------------------------------------------------------------------------------


def test_the_tool_of_a_delta_robot_is_where_three_spheres_meet() -> None:
    result = run(lw.mechanisms.delta_robot(amplitude=0.5, rate=5.0))
    angles = START + np.array([[motion.evaluate(t)[0] for motion in motions(0.5, 5.0)] for t in result.t])
    wanted = np.array([tool_position(angle) for angle in angles])
    assert np.abs(result.body("tool").position - wanted).max() < 1e-9
    assert np.ptp(wanted, axis=0).min() > 0.1


@pytest.mark.parametrize("driven", (True, False))
def test_the_tool_of_a_delta_robot_never_turns(driven: bool) -> None:
    result = run(lw.mechanisms.delta_robot(driven=driven), t_end=2.0 if driven else 0.3)
    tool = result.body("tool")
    assert np.abs(tool.orientation - (1, 0, 0, 0)).max() < 1e-10
    assert np.ptp(tool.position[:, 2]) > 0.1


def test_a_delta_robot_falls_by_its_energy() -> None:
    result = run(lw.mechanisms.delta_robot(driven=False), t_end=0.3)
    assert np.abs(result.energy_error).max() < 1e-8


@pytest.mark.parametrize(("name", "freedom"), (("stewart_platform", 6), ("delta_robot", 3)))
def test_as_many_drivers_as_freedoms_leave_none(name: str, freedom: int) -> None:
    make: Any = lw.mechanisms.MECHANISMS[name].function
    for driven, left in ((False, freedom), (True, 0)):
        D = dense_D(make(driven=driven))
        singular_values = np.linalg.svd(D, compute_uv=False)
        assert (D.shape[1] - D.shape[0], int(np.sum(singular_values < 1e-3))) == (left, 0)


def test_the_freedoms_of_a_delta_robot_are_the_shifts_of_its_tool() -> None:
    """Motions that the joints allow: the tool's velocities span all three directions, its rotations none."""
    model = lw.mechanisms.delta_robot(driven=False)
    _, singular_values, Vt = np.linalg.svd(dense_D(model))
    free = Vt[57:, :6]  # of the tool, body 0
    assert np.linalg.svd(free[:, :3], compute_uv=False).min() > 0.1
    assert np.abs(free[:, 3:]).max() < 1e-12


# --- by kinematic analysis ----------------------------------------------------------------------------------

TIMES = np.linspace(0.0, 2.0, 101)


def test_kinematic_analysis_places_a_stewart_platform_by_its_legs() -> None:
    motion = lw.kinematics(lw.mechanisms.stewart_platform(amplitude=0.2, rate=4.0), TIMES)
    lengths = leg_lengths(motion)
    wanted = np.array([[stroke.evaluate(t)[0] for stroke in strokes(0.2, 4.0)] for t in TIMES])
    assert np.abs(lengths - lengths[0] - wanted).max() < 1e-10


def test_kinematic_analysis_places_the_tool_of_a_delta_robot() -> None:
    motion = lw.kinematics(lw.mechanisms.delta_robot(amplitude=0.5, rate=5.0), TIMES)
    angles = START + np.array([[m.evaluate(t)[0] for m in motions(0.5, 5.0)] for t in TIMES])
    wanted = np.array([tool_position(angle) for angle in angles])
    assert np.abs(motion.body("tool").position - wanted).max() < 1e-10


@pytest.mark.parametrize("name", ("stewart_platform", "delta_robot"))
def test_the_motors_need_what_forward_dynamics_finds(name: str) -> None:
    """Inverse dynamics by the kinematic analysis, and the multipliers of a simulation."""
    motor = {"stewart_platform": "actuator 2", "delta_robot": "motor 2"}[name]
    model = lw.mechanisms.MECHANISMS[name].function()
    times = np.linspace(0.0, 1.0, 51)
    needed = lw.kinematics(model, times).reaction(motor)
    result = lw.simulate(model, t_end=1.0, step=1e-3, record_every=20, progress=False)
    found = result.reaction(motor)
    for wanted, got in ((needed.force, found.force), (needed.torque, found.torque)):
        assert np.abs(got - wanted).max() < 1e-6 * max(1.0, float(np.abs(wanted).max()))
    assert max(np.ptp(needed.force, axis=0).max(), np.ptp(needed.torque, axis=0).max()) > 1.0
