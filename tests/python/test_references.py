"""Runs against published benchmarks and closed forms; the numbers come from independent computations."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from reference_data import Floats, Series


def run(model: lw.Model, reference: Series, t_end: float, step: float, **options: Any) -> lw.Result:
    """With frames at the times of the reference."""
    every = round(reference.interval / step)
    result = lw.simulate(model, t_end, step, record_every=every, progress=False, **options)
    np.testing.assert_allclose(result.t, reference("t")[: len(result.t)], atol=1e-9)
    return result


def end_of(rod: Any) -> tuple[Floats, Floats]:
    """Position and velocity of the point 0.5 m along a body's x axis."""
    A = lw.rotation.matrix(rod.orientation)
    arm = np.array([0.5, 0.0, 0.0])
    turning = np.einsum("kij,kj->ki", A, np.cross(rod.omega, arm))
    return rod.position + A @ arm, rod.velocity + turning


def largest(x: Floats) -> float:
    return float(np.abs(x).max())


def test_the_reactions_of_the_rod_pendulum_are_right_to_1e_7() -> None:
    reference = Series("rod_pendulum")
    force = run(mechanisms.rod_pendulum(), reference, 10.0, 1e-3).reaction("pin").force
    exact = reference("Rx", "Ry")
    assert largest(force[:, :2] - exact) <= 1e-7 * largest(exact)
    assert largest(force[:, 2]) <= 1e-12


def test_the_reactions_of_the_rod_pendulum_follow_from_its_angle() -> None:
    """At all times: 5/2 m g cos(theta) along the rod, toward the pin, and m g sin(theta) / 4 across."""
    result = lw.simulate(mechanisms.rod_pendulum(), 10.0, 1e-3, record_every=10, progress=False)
    along = 2 * result.body("rod").position
    cosine, sine = -along[:, 1:2], along[:, :1]
    across = np.column_stack([-along[:, 1], along[:, 0], 0 * along[:, 0]])
    exact = 9.81 * (-2.5 * cosine * along + sine / 4 * across)
    assert largest(result.reaction("pin").force - exact) <= 1e-7 * largest(exact)


def test_the_heavy_top_is_at_its_published_place_after_two_seconds() -> None:
    reference = Series("heavy_top")
    result = run(mechanisms.heavy_top(), reference, 2.0, 1e-4)
    assert largest(result.position[-1, 0] - (-0.150416822746, -0.724165591637, -0.673022269560)) <= 1e-6
    assert largest(result.position[:, 0] - reference("x", "y", "z")) <= 1e-6
    assert largest(result.energy - reference.definition["E0"]) <= 1e-6 * reference.definition["E0"]


def test_the_free_top_turns_as_in_closed_form() -> None:
    reference = Series("torquefree_symmetric")
    result = run(mechanisms.torque_free_top(), reference, 20.0, 1e-3)
    exact = reference("q0", "q1", "q2", "q3")
    same_sign = np.sign(np.sum(exact * result.orientation[:, 0], axis=1))[:, None]
    assert largest(result.orientation[:, 0] - same_sign * exact) <= 1e-9
    assert largest(result.omega[:, 0] - reference("wx", "wy", "wz")) <= 1e-9


def recommended(name: str, reference: Series, t_end: float = 10.0, **parameters: Any) -> lw.Result:
    """A mechanism with what its documentation recommends."""
    mechanism = mechanisms.MECHANISMS[name]
    settings = {what: value for what, value in mechanism.settings.items() if what not in ("t_end", "step")}
    return run(mechanism.function(**parameters), reference, t_end, mechanism.settings["step"], **settings)


def test_the_simple_pendulum_keeps_time_for_ten_seconds() -> None:
    """IFToMM A01, with the tension of the rod; the multiplier counts compression."""
    reference = Series("A01_pendulum")
    result = recommended("pendulum", reference)
    assert largest(result.position[:, 0, :2] - reference("x", "y")) <= 1e-8
    assert largest(result.velocity[:, 0, :2] - reference("vx", "vy")) <= 1e-8
    assert largest(-result.multipliers[:, 0] - reference("tension")) <= 1e-8 * largest(reference("tension"))


@pytest.mark.parametrize(("n", "bound"), [(1, 1e-7), (2, 1e-7), (40, 1e-5)])
def test_four_bar_linkages_pass_their_singular_poses_for_ten_seconds(n: int, bound: float) -> None:
    """IFToMM A02 with redundant equations: ten times and more the rods lie on one line."""
    reference = Series(f"A02_fourbar_N{n}_10s")
    result = recommended("four_bar", reference, n=n)
    position, velocity = end_of(result.body("post 0"))
    assert largest(position[:, :2] - reference("x", "y")) <= bound
    assert largest(velocity[:, :2] - reference("vx", "vy")) <= bound


#: Angles of Andrews' mechanism, and of which bodies they are differences.
ANDREWS_ANGLES = {
    "beta": ("K1", None),
    "theta": ("K2", "K1"),
    "gamma": ("K3", None),
    "phi": ("K4", "K5"),
    "delta": ("K5", None),
    "omega": ("K6", "K7"),
    "epsilon": ("K7", None),
}


def test_andrews_mechanism_is_where_the_test_set_says() -> None:
    """IFToMM A03 with 9 redundant equations; lambda are the forces on K3, K4 and K6 at their common point."""
    reference = Series("A03_andrews_ivp")
    result = recommended("andrews", reference, t_end=0.03)
    published = reference.definition["published_reference_y27_t0p03"]
    angles, rates, forces = np.array(published[:7]), np.array(published[7:14]), np.array(published[21:27])
    turned = {
        b.name: 2 * np.arctan2(b.orientation[-1, 3], b.orientation[-1, 0])
        for b in map(result.body, result.body_names)
    }
    spins = {name: result.body(name).omega[-1, 2] for name in result.body_names}
    for k, (body, other) in enumerate(ANDREWS_ANGLES.values()):
        angle, rate = turned[body] - turned.get(other, 0.0), spins[body] - spins.get(other, 0.0)
        turns = round((angles[k] - angle) / (2 * np.pi))
        assert angle + 2 * np.pi * turns == pytest.approx(angles[k], rel=1e-9)
        assert rate == pytest.approx(rates[k], rel=1e-7)
    found = [result.reaction(joint).force[-1, :2] for joint in ("E3", "E4", "E6")]
    assert np.concatenate(found) == pytest.approx(forces, rel=1e-5)


def test_bricards_mechanism_goes_where_its_loop_lets_it() -> None:
    """IFToMM A04, one redundant equation: P3 is where the second rod ends."""
    reference = Series("A04_bricard_section0p1")
    result = recommended("bricard", reference)
    position, _ = end_of(result.body("rod 2"))
    assert largest(position - reference("P3x", "P3y", "P3z")[: len(result)]) <= 1e-8
    assert largest(result.energy - reference.definition["E0"]) <= 1e-8


def test_the_slider_of_the_flyball_governor_goes_up_and_down() -> None:
    """IFToMM A05, stiff; the angular momentum about the shaft stays, the energy goes into the dampers."""
    reference = Series("A05_flyball")
    result = recommended("flyball_governor", reference)
    slider, model = result.body("slider"), mechanisms.flyball_governor().compiled()
    assert result.kinetic_energy[0] == pytest.approx(reference("T")[0], rel=1e-12)
    assert largest(slider.position[:, 2] - reference("s")) <= 1e-7
    assert largest(slider.velocity[:, 2] - reference("sdot")) <= 1e-6
    spin = np.einsum("kbij,bjl,kbl->kbi", lw.rotation.matrix(result.orientation), model.inertia, result.omega)
    momentum = (model.mass[:, None] * np.cross(result.position, result.velocity) + spin).sum(axis=1)[:, 2]
    assert largest(momentum - reference("Hz")) <= 1e-7 * reference("Hz")[0]
