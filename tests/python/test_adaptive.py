"""Steps that follow tolerances: errors, output between steps, invariants, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.arrays import Floats
from linkwork.validation import Series
from recorded import PAIRS
from small_mechanisms import driven_pendulum, slider_crank, spherical_pendulum, two_body_loop

MECHANISMS = [spherical_pendulum, slider_crank, two_body_loop, driven_pendulum]


def run(model: lw.Model, t_end: float, rtol: float, integrator: str = "dopri5", **options: Any) -> lw.Result:
    return lw.simulate(model, t_end, integrator=integrator, rtol=rtol, progress=False, **options)


def largest(x: Floats) -> float:
    return float(np.abs(x).max())


def difference(a: lw.Result, b: lw.Result) -> float:
    """Of the motion, relative to the largest value."""
    return max(largest(a.q - b.q) / largest(b.q), largest(a.v - b.v) / largest(b.v))


# --- references ---


def test_the_simple_pendulum_reaches_its_reference() -> None:
    reference = Series("A01_pendulum")
    result = run(mechanisms.pendulum(), 10.0, 1e-10, "tsit5", times=reference("t"))
    assert largest(result.position[:, 0, :2] - reference("x", "y")) <= 1e-8
    assert largest(-result.multipliers[:, 0] - reference("tension")) <= 1e-8 * largest(reference("tension"))


def test_the_heavy_top_reaches_its_reference() -> None:
    reference = Series("heavy_top")
    result = run(mechanisms.heavy_top(), 2.0, 1e-10, "dop853", times=reference("t"))
    assert largest(result.position[:, 0] - reference("x", "y", "z")) <= 1e-8


def test_the_rod_pendulum_reaches_its_reference() -> None:
    reference = Series("rod_pendulum")
    result = run(mechanisms.rod_pendulum(), 10.0, 1e-10, "dop853", times=reference("t"))
    exact = reference("Rx", "Ry")
    assert largest(result.reaction("pin").force[:, :2] - exact) <= 1e-8 * largest(exact)


# --- errors and tolerances ---


@pytest.mark.parametrize("make", MECHANISMS)
@pytest.mark.parametrize("name", PAIRS)
def test_a_hundredth_of_the_tolerances_makes_about_a_hundredth_of_the_error(
    name: str, make: Callable[[], lw.Model]
) -> None:
    times = np.linspace(0, 1.1, 12)
    exact = run(make(), 1.1, 1e-13, "dop853", times=times)
    coarse, fine = (difference(run(make(), 1.1, rtol, name, times=times), exact) for rtol in (1e-5, 1e-7))
    assert fine < 1e-5
    assert 20 < coarse / fine < 600, (coarse, fine)


def test_bodies_at_rest_change_no_step() -> None:
    """The largest error of all bodies counts, not a mean that bodies at rest would lower."""
    alone, among = spherical_pendulum(), spherical_pendulum()
    for k in range(20):
        resting = among.body(f"resting {k}", mass=1.0, inertia=(1, 1, 1), position=(k, 5, 5))
        among.fixed(among.ground, resting, at=(k, 5, 5))
    few, many = (run(model, 1.0, 1e-6, record_every=1) for model in (alone, among))
    np.testing.assert_allclose(many.t, few.t, rtol=1e-6)


def test_the_steps_do_not_depend_on_the_axes_in_space() -> None:
    turn = lw.rotation.from_axes((0, 0.6, 0.8), (1, 0, 0))
    A = lw.rotation.matrix(turn)

    def pendulum(A: Floats, orientation: Any) -> lw.Model:
        model = lw.Model(gravity=A @ (0, 0, -9.81))
        center, omega = np.array([0.6, 0.2, -0.5]), np.array([2.0, -4.0, 6.0])
        bob = model.body("bob", mass=2.0, inertia=(0.3, 0.2, 0.1), position=A @ center, omega=omega,
                         orientation=orientation, velocity=A @ np.cross(omega, center))  # fmt: skip
        model.spherical(model.ground, bob, at=(0, 0, 0))
        return model

    straight, turned = (
        run(pendulum(*axes), 1.0, 1e-6, record_every=1) for axes in ((np.eye(3), (1, 0, 0, 0)), (A, turn))
    )
    np.testing.assert_allclose(turned.t, straight.t, rtol=1e-6)
    np.testing.assert_allclose(turned.position[:, 0], straight.position[:, 0] @ A.T, atol=1e-6)


def test_the_free_top_is_judged_by_its_rotation() -> None:
    """A body that turns in place: only the tolerance of the rotation and of omega can limit the steps."""
    reference = Series("torquefree_symmetric")
    exact = reference("q0", "q1", "q2", "q3")
    for rtol in (1e-5, 1e-8):
        result = run(mechanisms.torque_free_top(), 20.0, rtol, times=reference("t"))
        found = result.orientation[:, 0]
        angle = (
            2 * np.linalg.norm(found * np.sign(np.sum(exact * found, axis=1))[:, None] - exact, axis=1).max()
        )
        assert 0.01 * rtol < angle < result.statistics["steps"] * rtol


# --- invariants ---


@pytest.mark.parametrize("name", PAIRS)
def test_energy_is_kept_to_the_tolerance(name: str) -> None:
    result = run(two_body_loop(), 2.0, 1e-8, name)
    assert largest(result.energy_error) <= 1e-6 * largest(result.kinetic_energy)


def test_the_work_of_a_driven_joint_balances_the_energy() -> None:
    result = run(driven_pendulum(), 2.0, 1e-9)
    assert largest(result.work) > 1.0
    assert largest(result.energy_error) <= 1e-6


def swinging(position: Any, orientation: Any, velocity: Any, omega: Any) -> lw.Model:
    """A body on a ball joint at the origin."""
    model = lw.Model()
    bob = model.body("bob", mass=2.0, inertia=(0.3, 0.2, 0.1), position=position, orientation=orientation,
                     velocity=velocity, omega=omega)  # fmt: skip
    model.spherical(model.ground, bob, at=(0, 0, 0))
    return model


@pytest.mark.parametrize("name", PAIRS)
def test_with_velocities_reversed_the_mechanism_goes_back(name: str) -> None:
    rtol, center, omega = 1e-7, np.array([0.6, 0.2, -0.5]), np.array([2.0, -4.0, 6.0])
    forth = run(swinging(center, (1, 0, 0, 0), np.cross(omega, center), omega), 1.0, rtol, name)
    q, v = forth.q[-1, 0], forth.v[-1, 0]
    v = np.append(np.cross(forth.omega_inertial[-1, 0], q[:3]), v[3:])  # exactly on the constraints
    back = run(swinging(q[:3], q[3:], -v[:3], -v[3:]), 1.0, rtol, name)
    assert largest(back.q[-1] - forth.q[0]) <= 100 * rtol
    assert largest(back.v[-1] + forth.v[0]) <= 1000 * rtol


def test_a_violation_of_the_constraints_stays_at_the_tolerance() -> None:
    for rtol in (1e-5, 1e-8):
        result = run(spherical_pendulum(), 20.0, rtol, record_every=1, on_inaccurate="pass")  # it is chaotic
        assert result.violation[:, 0].max() <= 10 * rtol
        assert result.violation[:, 1].max() <= 100 * rtol


# --- output ---


@pytest.mark.parametrize("name", PAIRS)
def test_a_state_between_steps_is_that_of_a_run_that_steps_there(name: str) -> None:
    rtol, t = 1e-7, 0.7315
    between = run(slider_crank(), 1.0, rtol, name, times=[t])
    there = run(slider_crank(), t, rtol, name, times=[t])
    assert 0 < difference(between, there) <= 100 * rtol
    assert largest(between.multipliers - there.multipliers) <= 1e-3 * largest(there.multipliers)


@pytest.mark.parametrize("name", PAIRS)
def test_output_never_limits_a_step(name: str) -> None:
    few = run(slider_crank(), 1.0, 1e-6, name, times=[1.0])
    many = run(slider_crank(), 1.0, 1e-6, name, times=np.linspace(0, 1, 2001))
    for what in ("steps", "rejected_steps", "smallest_step", "largest_step"):
        assert many.statistics[what] == pytest.approx(few.statistics[what], rel=1e-6)
    assert len(many) == 2001
    np.testing.assert_allclose(many.q[-1], few.q[-1], rtol=0, atol=1e-12)


def test_frames_come_at_the_requested_times_exactly() -> None:
    times = [0.0, 0.1, 0.1 + 1e-12, 1 / 3, 1.0]
    assert run(slider_crank(), 1.0, 1e-6, times=times).t.tolist() == times


def test_every_step_is_recorded_on_request() -> None:
    result = run(slider_crank(), 1.0, 1e-6, record_every=1)
    steps = np.diff(result.t)
    assert len(steps) == result.statistics["steps"]
    assert steps.min() == pytest.approx(result.statistics["smallest_step"])
    assert steps.max() == pytest.approx(result.statistics["largest_step"])
    assert result.t[-1] == 1.0


def test_every_third_step_and_the_last_are_recorded_on_request() -> None:
    every, third = (run(slider_crank(), 1.0, 1e-6, record_every=k) for k in (1, 3))
    np.testing.assert_array_equal(third.t, np.unique(np.append(every.t[::3], 1.0)))


def test_steps_and_times_are_recorded_together_on_request() -> None:
    steps, times = run(slider_crank(), 1.0, 1e-6, record_every=1), [0.25, 0.5, 0.75]
    both = run(slider_crank(), 1.0, 1e-6, record_every=1, times=times)
    np.testing.assert_array_equal(both.t, np.union1d(steps.t, times))
    np.testing.assert_array_equal(both.q[np.isin(both.t, steps.t)], steps.q)


def test_without_a_request_frames_are_even() -> None:
    result = run(slider_crank(), 1.0, 1e-6)
    np.testing.assert_array_equal(result.t, np.linspace(0, 1, 1001))


def test_a_run_of_no_time_is_the_initial_state() -> None:
    assert run(slider_crank(), 0.0, 1e-6, record_every=1).t.tolist() == [0.0]


# --- steps ---


def test_no_step_is_larger_than_allowed() -> None:
    free, bound = (run(slider_crank(), 1.0, 1e-6, step=step) for step in (None, 0.005))
    assert free.statistics["largest_step"] > 0.01
    assert bound.statistics["largest_step"] <= 0.005


def test_where_nothing_moves_the_steps_grow_without_end() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("stone", mass=1.0, inertia=(1, 1, 1))
    assert run(model, 1e6, 1e-6).statistics["steps"] <= 2


def test_a_force_that_jumps_costs_rejected_steps_and_no_accuracy() -> None:
    """1 N from t = 0.5 s on, 1 kg: (t - 0.5)^2 / 2."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=(1, 1, 1))
    model.force(body, force=(lambda t: 1.0 if t >= 0.5 else 0.0, 0, 0))
    result = run(model, 1.0, 1e-8, step=0.1, times=[1.0])
    assert result.statistics["rejected_steps"] > 5
    assert result.position[-1, 0, 0] == pytest.approx(0.125, abs=1e-6)


def test_a_force_without_bound_ends_in_an_error_that_says_when_and_where() -> None:
    """x_ddot = 6 / (1 - t)^4 has the solution 1 / (1 - t)^2."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("rocket", mass=1.0, inertia=(1, 1, 1), position=(1, 0, 0), velocity=(2, 0, 0))
    model.force(body, force=(lambda t: 6.0 / (1.0 - t) ** 4 if t != 1.0 else np.inf, 0, 0))
    with pytest.raises((lw.StepSizeError, lw.NotFiniteError), match="body 'rocket'|infinite") as caught:
        run(model, 2.0, 1e-8, atol=1e-12)
    assert caught.value.time == pytest.approx(1.0, abs=1e-3)
    assert caught.value.bodies in ([], ["rocket"])


# --- what is refused ---


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"rtol": 1e-6, "integrator": "rk4"}, "error estimate.*'rk4'.*'dopri5'"),
        ({"atol": 1e-6, "integrator": "abm4"}, "error estimate.*'abm4'"),
        ({"rtol": 1e-6, "integrator": lambda system, t, y, h: y}, "error estimate"),
        ({"rtol": 1e-15}, "1e-15.*double precision"),
        ({"rtol": -1e-6}, "rtol -1e-06"),
        ({"rtol": 1e-6, "atol": 0.0}, "atol 0.0"),
        ({"rtol": 1e-6, "step": -1.0}, "step -1.0"),
        ({"rtol": 1e-6, "times": [0.5, 0.2]}, "ascending"),
        ({"rtol": 1e-6, "times": [0.5, 2.0]}, "0.5 to 2 s.*0 to 1 s"),
        ({"rtol": 1e-6, "times": []}, "one at least"),
        ({"step": 1e-3, "times": [0.5]}, "give rtol"),
        ({}, "give a step"),
    ],
)
def test_what_makes_no_sense_is_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(lw.OptionError, match=message):
        lw.simulate(slider_crank(), 1.0, progress=False, **options)


def test_the_manifest_says_what_was_chosen() -> None:
    chosen = run(slider_crank(), 0.1, 1e-7).manifest["options"]
    assert (chosen["integrator"], chosen["rtol"], chosen["atol"]) == ("dopri5", 1e-7, 1e-10)
    assert "rtol 1e-07" in run(slider_crank(), 0.1, 1e-7).summary()


# --- steps that are cut short ---


@pytest.mark.parametrize("gap", [1e-14, 1e-12, 1e-9])
@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8])
def test_breaks_side_by_side_make_no_velocities_of_violations(gap: float, rtol: float) -> None:
    """A correction of positions within so short a step would be a velocity of any size."""
    one, two = (
        run(mechanisms.chain(3), 1.0, rtol, breaks=breaks, on_inaccurate="pass")
        for breaks in ([0.3], [0.3, 0.3 + gap])
    )
    assert difference(one, two) <= 10 * rtol
    assert largest(two.energy_error) <= 2 * largest(one.energy_error)


@pytest.mark.parametrize("integrator", ["dopri5", "dop853"])
def test_contacts_that_begin_almost_together_cost_no_accuracy(integrator: str) -> None:
    """A cart that drops flat on four spheres: tighter tolerances are not worse ones."""

    def cart(rtol: float, **options: Any) -> lw.Result:
        model = lw.Model()
        model.body("cart", mass=2.0, inertia=(0.1, 0.12, 0.2), position=(0, 0, 0.3))
        model.body("arm", mass=0.5, inertia=(0.01, 0.01, 0.01), position=(0, 0, 0.7))
        model.spherical("cart", "arm", at=(0, 0, 0.5))
        for k, (x, y) in enumerate(((0.3, 0.2), (0.3, -0.2), (-0.3, 0.2), (-0.3, -0.2))):
            at = (0, 0, 0), (x, y, 0.15 + k * 1e-12)
            model.sphere_plane_contact("ground", "cart", at=at, normal=(0, 0, 1), radius=0.1, stiffness=1e5,
                                       hysteresis=0.3)  # fmt: skip
        return run(model, 0.3, rtol, integrator, on_inaccurate="pass", **options)

    truth = cart(1e-11, stabilization="projection", times=[0.3])
    errors = [difference(cart(rtol, times=[0.3]), truth) for rtol in (1e-6, 1e-9)]
    assert errors[0] < 3e-5
    assert errors[1] < 1e-6


def test_a_run_without_time_has_its_start() -> None:
    """Also where what is left is as long as roundoff."""
    model = mechanisms.pendulum()
    assert run(model, 0.0, 1e-6).t.tolist() == [0.0]
    start = lw.Snapshot.of(1000.0, lw.System(model).initial_state())
    assert run(model, 1000.0, 1e-6, start=start).t.tolist() == [1000.0]
    t = run(model, 1000.0 + 5e-11, 1e-6, start=start).t
    assert (t[0], t[-1]) == (1000.0, 1000.0 + 5e-11) and (np.diff(t) > 0).all()
    with pytest.raises(lw.OptionError, match="the start, at 1000 s, is after t_end 999 s"):
        run(model, 999.0, 1e-6, start=start)


@pytest.mark.parametrize("after", [1e-12, 1e-9, 1e-6])
def test_a_short_first_step_makes_no_velocities_of_the_violations_it_begins_with(after: float) -> None:
    """Left by a run of large steps; up to a break, and up to the end."""
    first = lw.simulate(mechanisms.chain(3), 0.5, 0.01, on_inaccurate="pass")
    assert largest(first.violation[-1, 0]) > 1e-11
    start = first.snapshot(-1)._replace(resume=None)
    usual = run(mechanisms.chain(3), 1.0, 1e-8, start=start)
    broken = run(mechanisms.chain(3), 1.0, 1e-8, start=start, breaks=[0.5 + after])
    assert largest(usual.q[-1] - broken.q[-1]) < 1e-6
    ended = run(mechanisms.chain(3), 0.5 + after, 1e-8, start=start)
    assert largest(ended.v[-1] - first.v[-1]) < 1e-5 + 1e3 * after


@pytest.mark.parametrize("integrator", ["dopri5", "tsit5", "dop853"])
def test_trial_steps_may_leave_a_table_that_the_motion_stays_in(integrator: str) -> None:
    """Free flight between two walls: half sines of the stiffness k, at +-x."""
    x, k, v = 0.1, 1e3, 0.4
    model = lw.Model(gravity=(0, 0, 0))
    ball = model.body("ball", mass=1.0, inertia=(0.01,) * 3, velocity=(v, 0, 0))
    model.translational("ground", ball, at=(0, 0, 0), axis=(1, 0, 0))
    walls = lw.functions.piecewise_polynomial([-9, -x, x, 9], [[-(9 - x) * k, k], [0, 0], [0, k]])
    model.nonlinear_spring_damper("ground", ball, at=((-9, 0, 0), (0, 0, 0)), spring=walls, free_length=9.0)
    run = lw.simulate(model, 6.0, rtol=1e-8, integrator=integrator)
    flight, wall = 2 * x / v, np.pi / np.sqrt(k)
    within = (run.t + x / v) % (2 * (flight + wall))
    back = within - flight - wall
    at_wall = v * np.cos(np.sqrt(k) * (within - flight))
    at_other = -v * np.cos(np.sqrt(k) * (back - flight))
    exact = np.select([within < flight, back < 0, back < flight], [v, at_wall, -v], at_other)
    error = np.abs(run.velocity[:, 0, 0] - exact).max() / v
    assert error < 1e-3
    assert run.verdict is not None and run.verdict.error > 0.3 * error


def test_a_motion_that_does_leave_its_table_is_told_so() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    ball = model.body("ball", mass=1.0, inertia=(0.01,) * 3, velocity=(1.0, 0, 0))
    model.translational("ground", ball, at=(0, 0, 0), axis=(1, 0, 0))
    spring = lw.functions.piecewise_polynomial([-1, 0.5], [[0.0, 0.1]])
    model.nonlinear_spring_damper("ground", ball, at=((-9, 0, 0), (0, 0, 0)), spring=spring, free_length=9.0)
    with pytest.raises(lw.OptionError, match=r"leaves its table; extend it \(t = 0\.[45]\d* s\)$"):
        lw.simulate(model, 6.0, rtol=1e-8)
