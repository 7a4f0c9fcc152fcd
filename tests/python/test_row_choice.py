"""A plate on equal cranks: which of its redundant rows are independent changes with the pose."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms import thin_rod

A, PLATE, CRANK, G = 0.3, 3.0, 0.5, 9.81
X, Y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def cranks(angle: float, count: int = 3, copies: int = 1) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -G), name="cranks")
    u = A * np.array([np.cos(angle), 0.0, np.sin(angle)])
    for copy in range(copies):
        plate = model.body(
            f"plate{copy}", mass=PLATE, inertia=thin_rod(PLATE, 1.0), position=copy * Y + u + X / 2
        )
        for k in range(count):
            at = copy * Y + X * k / (count - 1)
            axes = lw.rotation.from_axes(u, Y)
            name = f"crank{copy}.{k}"
            body = model.body(
                name, mass=CRANK, inertia=thin_rod(CRANK, A), position=at + u / 2, orientation=axes
            )
            model.revolute(model.ground, body, at=at, axis=Y, name=f"pin{copy}.{k}")
            model.revolute(body, plate, at=at + u, axis=Y)
    return model


def frequency(count: int) -> float:
    """Of small motions about the hanging pose [rad/s]."""
    return float(np.sqrt(G * A * (PLATE + count * CRANK / 2) / (A * A * (PLATE + count * CRANK / 3))))


@pytest.mark.parametrize("angle", [0.3, 0.05, -0.4, 0.7, 1.2])
def test_a_plate_on_three_cranks_hangs_wherever_it_starts(angle: float) -> None:
    rest = lw.equilibrium(cranks(angle))
    assert rest.stability == "stable"
    assert rest.turned[1:] == pytest.approx(3 * [angle + np.pi / 2], abs=1e-8)
    up = rest.reactions().force[::2, 2]
    assert up.sum() == pytest.approx(G * (PLATE + 3 * CRANK), rel=1e-9)
    assert lw.linearize(rest.model).frequencies == pytest.approx([frequency(3)], rel=1e-8)


@pytest.mark.parametrize("angle", [0.05, -0.4])
def test_rows_of_large_parts_are_chosen_by_sparse_factors(
    angle: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("linkwork.constraints.row_choice.FEW", 0)
    rest = lw.equilibrium(cranks(angle, 4))
    assert rest.stability == "stable"
    assert lw.linearize(rest.model).frequencies == pytest.approx([frequency(4)], rel=1e-8)


@pytest.mark.parametrize("angle", [0.3, 0.05, -0.4, 0.7])
def test_from_a_start_a_plate_vibrates_as_from_its_own_pose(angle: float) -> None:
    hanging = lw.simulate(cranks(-np.pi / 2), t_end=1e-3, step=1e-3).snapshot(0)
    vibration = lw.linearize(cranks(angle), start=hanging)
    assert vibration.stable
    assert vibration.frequencies == pytest.approx([frequency(3)], rel=1e-8)


def test_many_plates_on_driven_cranks_pass_their_highest_pose() -> None:
    model = cranks(0.3, copies=24)
    for copy in range(24):
        model.drive(f"pin{copy}.0", velocity=-2.0, name=f"drive{copy}")
    highest = (np.pi / 2 - 0.3) / 2 + np.array([-1e-9, 0.0, 1e-9])  # short steps get a closer look
    needed = lw.inverse_dynamics(model, np.union1d(np.linspace(0.0, 1.0, 11), highest))
    angle = 0.3 + 2 * needed.t
    assert not needed.motion.singular_poses
    assert needed.motion.position[:, 0, 2] == pytest.approx(A * np.sin(angle), abs=1e-12)
    torque = G * A * (PLATE + 3 * CRANK / 2) * np.cos(angle)
    assert np.abs(needed.effort("drive0")) == pytest.approx(np.abs(torque), abs=1e-9)
