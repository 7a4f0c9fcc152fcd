"""Leaps over singular poses: of mechanisms far from the origin, and beside fast rotors."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms


def bars_at(place: float, turn: float) -> lw.Model:
    """A parallelogram of bars of 1 m and 1 kg, its posts up at 1 rad/s, moved and turned about z."""
    c, s = np.cos(turn), np.sin(turn)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    o = place * np.array([1.0, 0.5, 0.7])
    model = lw.Model(gravity=tuple(R @ (0, -9.81, 0)))

    def bar(name: str, center: tuple[float, float], along: float, omega: float) -> lw.Body:
        p = (np.cos((along + turn) / 2), 0, 0, np.sin((along + turn) / 2))
        return model.body(
            name,
            mass=1.0,
            inertia=(1e-3, 1 / 12, 1 / 12),
            position=tuple(R @ (*center, 0) + o),
            orientation=p,
            velocity=tuple(R @ (center[1], 0, 0)),
            omega=(0, 0, omega),
        )

    left, right = (bar(f"post {x}", (x, 0.5), np.pi / 2, -1.0) for x in (0, 1))
    beam = bar("beam", (0.5, 1.0), 0.0, 0.0)
    for name, a, b, at in (
        ("left", model.ground, left, (0, 0, 0)),
        ("right", model.ground, right, (1, 0, 0)),
        ("left pin", left, beam, (0, 1, 0)),
        ("right pin", right, beam, (1, 1, 0)),
    ):
        model.revolute(a, b, at=tuple(R @ at + o), axis=(0, 0, 1), name=name)
    return model


@pytest.mark.parametrize("options", [{"step": 1e-4}, {"rtol": 1e-8}], ids=["fixed", "adaptive"])
@pytest.mark.parametrize("place", [1e4, 3e4])
def test_leaps_far_from_the_origin_are_what_roundoff_of_positions_allows(
    place: float, options: dict[str, Any]
) -> None:
    """Of a turned mechanism: its positions, and lengths along axes, are no round numbers."""
    near = lw.simulate(bars_at(0.0, 0.0), 1.5, rtol=1e-11, times=[1.5], progress=False)
    far = lw.simulate(bars_at(place, 0.3), 1.5, **options, on_inaccurate="pass", progress=False)
    assert len(far.singular_poses) == len(near.singular_poses) == 2
    assert np.abs(far.v[-1][:, 5] - near.v[-1][:, 5]).max() <= 1e-6


def with_rotor(omega: float, on: str, inertia: tuple[float, float, float] = (0.05, 0.05, 0.1)) -> lw.Model:
    """A four-bar with a rotor about z in the middle of its beam, or on a bearing beside it."""
    model = mechanisms.four_bar(1)
    if not on:
        return model
    at = (0.5, 1.0, 0.0) if on == "beam 0" else (50.0, 0.0, 0.0)
    moves = (1.0, 0.0, 0.0) if on == "beam 0" else (0.0, 0.0, 0.0)
    model.body("rotor", mass=0.3, inertia=inertia, position=at, velocity=moves, omega=(0, 0, omega))
    model.revolute(on, "rotor", at=at, axis=(0, 0, 1), name="bearing")
    return model


def forces_beside_a_pose(model: lw.Model, pose: float, **options: Any) -> np.ndarray:
    after = np.array([0, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2])
    times = np.unique(np.concatenate([pose - after, pose + after]))
    result = lw.simulate(model, 1.0, times=times, progress=False, on_inaccurate="pass", **options)
    return result.reaction("left 0").force


@pytest.mark.parametrize("options", [{"rtol": 1e-6}, {"rtol": 1e-8, "integrator": "dop853"}], ids=str)
@pytest.mark.parametrize("on", ["ground", "beam 0"])
def test_a_fast_rotor_changes_no_force_beside_a_pose(on: str, options: dict[str, Any]) -> None:
    """Its rotation about the axis of its symmetry has no part in what goes on in the plane."""
    alone = with_rotor(0.0, on if on != "ground" else "")
    pose = lw.simulate(alone, 0.8, rtol=1e-11, progress=False).singular_poses[0].t
    expected = forces_beside_a_pose(alone, pose, rtol=1e-10)
    found = forces_beside_a_pose(with_rotor(3000.0, on), pose, **options)
    assert np.abs(found - expected).max() <= 1e-4  # N, of 12 N


def test_the_bearing_of_a_fast_gyroscope_has_its_torque_in_leaps() -> None:
    """J Omega theta_dot, of an axis along the post, whatever the axes along which the bearing counts it."""
    moment, spin = 0.1, 1000.0
    model = mechanisms.four_bar(1)
    q = (np.cos(np.pi / 4), 0, 0, np.sin(np.pi / 4))
    model.body(
        "rotor",
        mass=0.3,
        inertia=(moment, 1e-6, 1e-6),
        inertia_as_is=True,
        position=(0, 0.5, 0),
        orientation=q,
        velocity=(0.5, 0, 0),
        omega=(spin, 0, -1.0),
    )
    model.revolute("post 0", "rotor", at=(0, 0.5, 0), axis=(0, 1, 0), name="bearing")
    times = 0.70845 + np.linspace(-6e-3, 6e-3, 25)
    result = lw.simulate(model, times[-1], rtol=1e-7, times=times, progress=False, on_inaccurate="pass")
    torque = np.linalg.norm(result.reaction("bearing").torque, axis=1)
    theta_dot = np.abs(result.v[:, 0, 5])
    assert torque == pytest.approx(moment * spin * theta_dot, rel=1e-5)


def test_frames_some_hundredths_of_a_radian_from_a_pose_ask_nothing_of_it() -> None:
    """Where a usual step leads over it. Of a rotor that is not symmetric, beside the mechanism."""
    pose = lw.simulate(with_rotor(0.0, ""), 0.8, rtol=1e-11, progress=False).singular_poses[0].t
    expected = forces_beside_a_pose(with_rotor(0.0, ""), pose, rtol=1e-10)
    model = with_rotor(30.0, "ground", (0.02, 0.07, 0.05))
    found = forces_beside_a_pose(model, pose, rtol=1e-9, integrator="dop853")
    assert np.abs(found - expected).max() <= 1e-4  # N


@pytest.mark.parametrize("options", [{"step": 1e-3}, {"rtol": 1e-9}, {"rtol": 1e-6, "integrator": "dop853"}])
@pytest.mark.parametrize("mass", [0.2, 3.0])
def test_reactions_that_grow_toward_a_pose_are_met_in_leaps(mass: float, options: dict[str, Any]) -> None:
    """A parallelogram whose crank is driven at 2 rad/s lies flat after 0.5 s. Its rocker, of this mass, bears
    half of the rod's weight by a force along the rod, infinite there: sin a X = cos a (Y + m g / 2)."""
    rate, g, rod = -2.0, 9.81, 2.0
    up, across, along = (np.array((np.cos(1.0), np.sin(1.0), 0)), np.array((-np.sin(1.0), np.cos(1.0), 0)),
                         np.array((2.0, 0, 0)))  # fmt: skip
    model, turned = lw.Model(gravity=(0, -g, 0)), lw.rotation.from_axes(x=up, y=across)
    for name, m, foot in (("crank", 1.0, 0 * along), ("rocker", mass, along)):
        model.body(name, mass=m, inertia=(0.01, m / 12, m / 12), position=foot + up / 2, orientation=turned,
                   velocity=rate * across / 2, omega=(0, 0, rate))  # fmt: skip
    model.body(
        "rod", mass=rod, inertia=(0.01, rod / 3, rod / 3), position=up + along / 2, velocity=rate * across
    )
    for name, i, j, at in (("A", "ground", "crank", 0 * along), ("B", "crank", "rod", up),
                           ("C", "rod", "rocker", up + along), ("D", "ground", "rocker", along)):  # fmt: skip
        model.revolute(i, j, at=at, axis=(0, 0, 1), name=name)
    model.drive("A", position=lw.functions.polynomial(0.0, rate))
    how = {"record_every": 1} if "step" in options else {"times": np.linspace(0.0, 0.8, 801)}
    result = lw.simulate(model, 0.8, **options, **how, progress=False)
    assert len(result.singular_poses) == 1
    beside = np.abs(1.0 + rate * result.t) > 1e-3
    angle = 1.0 + rate * result.t[beside]
    Y = rod * (g - rate**2 * np.sin(angle)) / 2
    X = np.cos(angle) * (Y + mass * g / 2) / np.sin(angle)
    found = result.reaction("C").force[beside, :2]  # of the rod on the rocker
    off = np.abs(found + np.column_stack((X, Y))).max(axis=1)
    assert (off / np.hypot(X, Y)).max() < 1e-5


def uneven_parallelogram() -> lw.Model:
    """It swings over its flat poses at about 9 rad/s; toward them forces in the pins grow without limit."""
    turned, axis, along = 0.99, np.array((0.0, -1.0, 0.0)), np.array((2.0, 0.0, 0.0))
    up = np.array((np.cos(turned), 0.0, np.sin(turned)))
    omega, orientation = 8.9 * axis, lw.rotation.about(axis, turned)
    model = lw.Model()
    for name, m, foot in (("a", 2.2, 0 * along), ("b", 0.5, along)):
        model.body(name, mass=m, inertia=(0.01, m / 12, m / 12), position=foot + up / 2, omega=omega,
                   orientation=orientation, velocity=np.cross(omega, up / 2))  # fmt: skip
    model.body(
        "c", mass=0.9, inertia=(0.01, 0.3, 0.3), position=up + 0.7 * along, velocity=np.cross(omega, up)
    )
    model.revolute("ground", "a", at=(0, 0, 0), axis=axis, name="A0")
    model.revolute("ground", "b", at=along, axis=axis, name="B0")
    model.revolute("a", "c", at=up, axis=axis, name="A")
    model.point_on_line("b", "c", at=up + along, axis=axis, name="B")
    return model


@pytest.mark.parametrize("options", [
    {"step": 0.01}, {"step": 0.005}, {"step": 0.01, "integrator": "dopri5"},
    {"step": 0.005, "formulation": "augmented_lagrangian"},
])  # fmt: skip
def test_steps_that_are_long_beside_a_pose_leave_forces_of_the_motion(options: dict[str, Any]) -> None:
    """A step of 0.09 rad ends 0.012 rad before the pose: what it is off made forces six times as large."""
    result = lw.simulate(uneven_parallelogram(), 1.0, **options, progress=False)
    tight = lw.simulate(uneven_parallelogram(), 1.0, rtol=1e-10, times=result.t, progress=False)
    found, expected = (run.reaction("A0").force for run in (result, tight))
    assert len(result.singular_poses) == 3
    assert (np.abs(found - expected).max(axis=1) / np.abs(expected).max(axis=1)).max() < 5e-3


@pytest.mark.parametrize(("t_end", "steps"), [(0.53, 106), (0.5308, 106), (0.532, 106), (0.5275, 53)])
def test_the_last_frame_beside_a_pose_has_forces_of_the_motion(t_end: float, steps: int) -> None:
    model, step = uneven_parallelogram(), t_end / steps
    found, expected = (
        lw.simulate(model, t_end, **options, progress=False).reaction("A0").force[-1]
        for options in ({"step": step}, {"rtol": 1e-10})
    )
    assert np.abs(found - expected).max() < 2e-3 * np.abs(expected).max()


def test_finite_forces_are_found_in_the_pose_beside_infinite_ones() -> None:
    """A crank of 1 kg lifts a rod of 2 kg and another crank at 2 rad/s: its torque is 3 g cos(a), also where
    all lie flat and pins bear without limit."""
    rate, start, axis, along = 2.0, -0.6, np.array((0.0, -1.0, 0.0)), np.array((2.0, 0.0, 0.0))
    up = np.array((np.cos(start), 0.0, np.sin(start)))
    model, omega = lw.Model(), rate * axis
    for name, foot in (("a", 0 * along), ("b", along)):
        model.body(name, mass=1.0, inertia=(0.01, 1 / 12, 1 / 12), position=foot + up / 2, omega=omega,
                   orientation=lw.rotation.about(axis, start), velocity=np.cross(omega, up / 2))  # fmt: skip
    model.body("c", mass=2.0, inertia=(0.01, 0.7, 0.7), position=up + along / 2, velocity=np.cross(omega, up))
    for name, i, j, at in (
        ("A0", "ground", "a", 0 * along),
        ("B0", "ground", "b", along),
        ("A", "a", "c", up),
    ):
        model.revolute(i, j, at=at, axis=axis, name=name)
    model.point_on_line("b", "c", at=up + along, axis=axis, name="B")
    model.drive("A0", velocity=rate, name="motor")
    result = lw.simulate(model, 1.0, rtol=1e-9, times=np.linspace(0, 1, 101), progress=False)
    expected = 3 * 9.81 * np.cos(start + rate * result.t)
    assert np.abs(np.abs(result.reaction("motor").torque[:, 1]) - expected).max() < 1e-3
