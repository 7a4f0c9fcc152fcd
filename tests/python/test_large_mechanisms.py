"""The mechanisms of the large benchmarks, in small: what is conserved, and what they are counted to be."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms.capture_net import SPEED
from linkwork.mechanisms.hub_net import RADIUS
from linkwork.mechanisms.rope import LENGTH
from linkwork.mechanisms.tracked_chain import PITCH, PITCH_RADIUS
from linkwork.mechanisms.tracked_vehicle import ROAD_WHEEL_RADIUS


def run(model: lw.Model, t_end: float, step: float) -> lw.Result:
    return lw.simulate(model, t_end, step, progress=False, on_inaccurate="pass")


def test_net_of_the_published_size_has_its_bodies_and_equations() -> None:
    """29 800 bodies and 118 800 equations; the corners have 12 more."""
    model = lw.mechanisms.hub_net(100)
    assert (model.body_count, model.row_count) == (29_800, 118_800 + 12)


def test_hexagonal_net_of_14_rings_has_631_nodes() -> None:
    """A node less than all rods' ends is joined: joints = ends - nodes, and three corners."""
    model = lw.mechanisms.hexagonal_net(14)
    assert model.body_count == 1260
    assert 2 * model.body_count - (model.joint_count - 3) == 631


@pytest.mark.parametrize("n, rods, nodes", [(2, 54, 27), (10, 3630, 1331), (20, 26_460, 9261)])
def test_lattice_has_a_rod_for_every_edge_of_its_cells(n: int, rods: int, nodes: int) -> None:
    model = lw.mechanisms.lattice(n)
    assert model.body_count == rods
    assert 2 * rods - (model.joint_count - 2) == nodes


@pytest.mark.parametrize("name", ["lattice", "hexagonal_net"])
def test_rods_end_at_their_joints(name: str) -> None:
    """And weigh 1 kg/m."""
    model = getattr(lw.mechanisms, name)(3)
    core = model.compiled()
    joints = core.joint_arrays()
    held = joints["bodies"] >= 0
    arms = np.linalg.norm(joints["origin"], axis=2)[held]
    assert arms == pytest.approx(core.mass[joints["bodies"][held]] / 2, rel=1e-12)


def test_scissors_keep_energy_and_angular_momentum_and_their_arms_unfold_alike() -> None:
    model = lw.mechanisms.scissors(arms=3, units=4)
    result = lw.simulate(model, 0.2, 1e-3, progress=False)
    core = model.compiled()
    A = lw.rotation.matrix(result.orientation)
    turning = np.einsum("kbij,bjl,kbl->kbi", A, core.inertia, result.omega)
    moving = core.mass[:, None] * np.cross(result.position, result.velocity)
    momentum = (moving + turning).sum(axis=1)[:, 2]
    assert momentum == pytest.approx(np.full(len(result), momentum[0]), rel=1e-10)
    assert np.abs(result.energy_error).max() < 1e-9 * result.kinetic_energy[0]
    slope = A[-1, 1:13, 2, 0].reshape(3, 4)  # of the rising bars
    assert slope == pytest.approx(np.full((3, 4), slope[0, 0]), rel=1e-9)
    assert slope[0, 0] < A[0, 1, 2, 0] - 0.1
    end = np.linalg.norm(result.body("rising bar[3]").position, axis=1)
    assert end[-1] - end[0] > 0.5


def test_scissors_turn_slower_as_they_unfold() -> None:
    result = lw.simulate(lw.mechanisms.scissors(arms=3, units=4), 0.2, 1e-3, progress=False)
    spin = result.body("hub").omega[:, 2]
    assert np.all(np.diff(spin) < 0)


def test_free_half_of_a_folded_rope_falls_faster_than_freely() -> None:
    """Energy that the links give up as they come to rest pulls at the others."""
    model = lw.mechanisms.rope(40)
    result = lw.simulate(model, 0.3, 2e-4, progress=False)
    free = result.body("link[39]").position[:, 2]
    freely = -9.81 / 2 * result.t**2
    late = result.t > 0.2
    assert np.all((free - free[0] - freely)[late] < -1e-3 * LENGTH)
    assert np.abs(result.energy_error).max() < 1e-6 * result.kinetic_energy.max()


def test_thrown_net_pushes_the_ball_and_keeps_its_momentum() -> None:
    """Knots stay outside of the ball but for the depth of contact."""
    model = lw.mechanisms.capture_net(5)
    result = run(model, 0.1, 1e-4)
    momentum = np.einsum("b,kbi->ki", model.compiled().mass, result.velocity)
    assert momentum == pytest.approx(np.tile(momentum[0], (len(result), 1)), abs=1e-9 * momentum[0, 2])
    ball = result.body("ball")
    assert 0 < ball.velocity[-1, 2] < 2 * SPEED
    apart = np.linalg.norm(result.position[:, :25] - ball.position[:, None], axis=2).min()
    radius = apart_at_start(model) - 0.02
    assert radius - 0.03 < apart < radius + RADIUS


def apart_at_start(model: lw.Model) -> float:
    """The nearest knot from the center of the ball, 2 cm before it touches."""
    position = np.reshape(model.compiled().q0, (-1, 7))[:, :3]
    return float(np.linalg.norm(position[:25] - position[-1], axis=1).min())


def test_tracked_vehicle_rolls_on_upright_without_sinking() -> None:
    """1 m/s along -x; what is on the ground stays within 5 mm of it, as do road wheels of the lower run."""
    result = run(lw.mechanisms.tracked_vehicle(60), 0.2, 1e-4)
    hull = result.body("hull")
    up = lw.rotation.matrix(hull.orientation)[:, 1, 1]
    assert up.min() > 0.999
    assert hull.velocity[-1, 0] == pytest.approx(-1.0, abs=0.3)
    lowest = min(
        result.body(f"{side} shoe[{k}]").position[:, 1].min() for side in ("left", "right") for k in range(60)
    )
    assert lowest > -PITCH_RADIUS - 5e-3
    wheel = result.body("left road wheel 3")
    assert wheel.position[-1, 1] == pytest.approx(-PITCH_RADIUS + 0.015 + ROAD_WHEEL_RADIUS, abs=0.02)
    assert np.abs(np.diff(hull.position[[0, -1], 0])).max() > PITCH


def test_both_tracks_of_a_vehicle_move_alike() -> None:
    result = run(lw.mechanisms.tracked_vehicle(60), 0.05, 1e-4)
    for k in (0, 15, 40):
        left, right = (result.body(f"{side} shoe[{k}]").position[-1, :2] for side in ("left", "right"))
        assert left == pytest.approx(right, abs=1e-7)


def test_a_large_bent_net_begins_without_looking_for_a_singular_pose() -> None:
    """Its pivots are small wherever it is: a leap was tried in vain for a thousand evaluations."""
    model = lw.mechanisms.hub_net(45)
    result = run(model, 1e-3, 1e-3)
    assert result.statistics["smallest_pivot"] < 0.01
    assert result.statistics["singular_poses"] == 0
    assert result.statistics["evaluations"] < 40


def conserved(result: lw.Result) -> float:
    """Energy that is lost or gained, of all that moves."""
    return float(np.abs(result.energy_error).max() / result.kinetic_energy.max())


def test_slender_arm_is_near_no_singular_pose_however_weak_it_is() -> None:
    """Its least singular value is 1e-6 of a usual one, and stays: iterations to it seemed to be a fall."""
    result = run(lw.mechanisms.scissors(arms=1, units=500), 0.04, 1e-2)
    assert result.statistics["singular_poses"] == 0
    assert result.statistics["evaluations"] < 50
    assert conserved(result) < 1e-9


def test_slow_fall_in_a_net_foretells_no_singular_pose_far_ahead() -> None:
    """Half a radian ahead, as it seems: leaps were tried in vain for 1300 evaluations."""
    result = run(lw.mechanisms.hexagonal_net(8), 0.2, 2e-2)
    assert result.statistics["singular_poses"] == 0
    assert result.statistics["evaluations"] < 100
    assert conserved(result) < 1e-2
