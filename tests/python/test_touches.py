"""Contacts and stops that come and go within what a free motion takes for a step."""

from collections.abc import Callable

import linkwork as lw
import numpy as np
import pytest
from recorded import PAIRS

RADIUS, SPEED = 0.01, 10.0


def two_spheres(distance: float, beside: float = 0.0) -> lw.Model:
    """Without weight; one comes along x and meets the other, at rest."""
    model = lw.Model(gravity=(0, 0, 0))
    there = (distance, beside, 0)
    model.body("a", mass=0.01, inertia=(4e-7,) * 3, velocity=(SPEED, 0, 0))
    model.body("b", mass=0.01, inertia=(4e-7,) * 3, position=there)
    model.sphere_sphere_contact(
        "a", "b", at=((0, 0, 0), there), radius_a=RADIUS, radius_b=RADIUS, stiffness=1e9
    )
    return model


def end(model: lw.Model, t_end: float, pair: str) -> lw.Result:
    rtol = 1e-7 if pair == "bs32" else 1e-8
    return lw.simulate(model, t_end, rtol=rtol, integrator=pair, progress=False)


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("distance", [0.5, 3.0, 20.0, 51.7])
def test_equal_spheres_exchange_their_velocities_however_far_they_come(distance: float, pair: str) -> None:
    result = end(two_spheres(distance), 1.5 * distance / SPEED, pair)
    assert result.v[-1, :, 0] == pytest.approx([0.0, SPEED], abs=1e-4)
    assert result.verdict.level == "good"


@pytest.mark.parametrize("pair", PAIRS)
def test_an_oblique_collision_does_not_depend_on_the_flight_before(pair: str) -> None:
    near, far = (end(two_spheres(d, 0.01), 1.5 * d / SPEED, pair).v[-1] for d in (0.1, 40.0))
    assert far == pytest.approx(near, abs=1e-4)


@pytest.mark.parametrize("beside", [2.001 * RADIUS, 0.1])
def test_spheres_that_pass_each_other_do_not_touch(beside: float) -> None:
    result = end(two_spheres(20.0, beside), 3.0, "dopri5")
    assert result.v[-1, :, 0].tolist() == [SPEED, 0.0]


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("gap", [0.3, 0.03, 0.003])
def test_what_is_thrown_at_a_ceiling_comes_back_by_its_law(gap: float, pair: str) -> None:
    """Up at 4 m/s; it is at the ceiling for as long as a stiff spring takes to turn it round."""
    top, stiffness, g = 4.0**2 / (2 * 9.81) - gap, 1e8, 9.81
    model = lw.Model(gravity=(0, 0, -g))
    model.body("b", mass=0.1, inertia=(4e-5,) * 3, velocity=(1, 0, 4))
    model.translational_stop(
        "ground", "b", at=(0, 0, 0), axis=(0, 0, 1), lower=-100, upper=top, stiffness=stiffness
    )
    met, omega = np.sqrt(2 * g * gap), np.sqrt(stiffness / 0.1)
    rise, contact = (4 - met) / g, (np.pi - 2 * np.arctan(g / omega / met)) / omega
    result = end(model, 0.9, pair)
    assert result.v[-1, 0, 2] == pytest.approx(-met - g * (0.9 - rise - contact), abs=1e-5)


@pytest.mark.parametrize("beside", [0.0, 0.015])
def test_fixed_steps_tell_where_bodies_pass_through_each_other(beside: float) -> None:
    result = lw.simulate(two_spheres(5.13, beside), 1.0, 0.02, on_inaccurate="pass", progress=False)
    assert result.v[-1, 1, 0] == 0.0  # as nothing stopped the other
    assert result.verdict.level == "wrong"
    assert "pass through each other at contact 'sphere_sphere_contact 1' at t = 0.5 s" in str(result.verdict)
    (passed,) = result.statistics["passed_touches"]
    assert (passed["t"], passed["steps"]) == (pytest.approx(0.5), 1)
    with pytest.warns(lw.LinkworkWarning, match="pass through each other"):
        lw.simulate(two_spheres(5.13, beside), 1.0, 0.02, progress=False)


@pytest.mark.parametrize("beside", [2.001 * RADIUS, 0.1])
def test_fixed_steps_tell_nothing_of_bodies_that_pass_by(beside: float) -> None:
    result = lw.simulate(two_spheres(5.13, beside), 1.0, 0.02, progress=False)
    assert result.verdict.level == "good"
    assert "passed_touches" not in result.statistics


def test_members_of_ensembles_tell_it_too() -> None:
    models = [two_spheres(5.13, beside) for beside in (0.0, 0.005, 0.1)]
    found = lw.simulate_many(models, None, 1.0, 0.02, threads=1, on_inaccurate="pass", progress=False)
    assert found.alone == {}
    assert [found.member(k).verdict.level for k in range(3)] == ["wrong", "wrong", "good"]


G = 9.81


def thrown(radius: float = 0.005, stiffness: float = 1e9) -> lw.Model:
    """A ball thrown up that comes down on a fixed one; an oscillator beside it makes more steps."""
    model = lw.Model(gravity=(0, 0, -G))
    start = (-0.19, 0, 0.17)
    model.body("ball", mass=0.1, inertia=(4e-5,) * 3, position=start, velocity=(0.27, 0, 3.1))
    model.sphere_sphere_contact(
        "ground", "ball", at=((0, 0, 0), start), radius_a=radius, radius_b=radius, stiffness=stiffness
    )
    along = {"at": (0, 1, 0), "axis": (1, 0, 0)}
    model.body("o", mass=1.0, inertia=(0.1,) * 3, position=(0, 1, 0), velocity=(0.5, 0, 0))
    model.translational("ground", "o", **along)
    model.translational_spring_damper("ground", "o", **along, stiffness=3.2)
    return model


def struck(radius: float = 0.005) -> float:
    """Velocity along x after a parabola from there is thrown back by the ball at the origin."""
    t = np.linspace(0.6, 0.8, 2_000_001)
    x, z = -0.19 + 0.27 * t, 0.17 + 3.1 * t - 0.5 * G * t**2
    k = int(np.argmax(np.hypot(x, z) < 2 * radius))
    assert k > 0
    n, v = np.array([x[k], z[k]]) / (2 * radius), np.array([0.27, 3.1 - G * t[k]])
    return float((v - 2 * n.dot(v) * n)[0])


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("rtol", [1e-3, 1e-5, 1e-7])
def test_a_ball_thrown_up_does_not_come_down_through_a_fixed_one(rtol: float, pair: str) -> None:
    result = lw.simulate(thrown(), 2.0, rtol=rtol, integrator=pair, progress=False, on_inaccurate="pass")
    assert result.v[-1, 0, 0] == pytest.approx(struck(), abs=0.2)


def stopped_oscillator(beyond: float, stiffness: float) -> lw.Model:
    """1 Hz, 0.1 m, with a stop so far before the turning point."""
    model = lw.Model(gravity=(0, 0, 0))
    along = {"at": (0, 0, 0), "axis": (1, 0, 0)}
    model.body("o", mass=1.0, inertia=(0.1,) * 3, velocity=(0.2 * np.pi, 0, 0))
    model.translational("ground", "o", **along)
    model.translational_spring_damper("ground", "o", **along, stiffness=4 * np.pi**2)
    model.translational_stop(
        "ground", "o", **along, lower=-1, upper=0.1 - beyond, stiffness=stiffness, name="end"
    )
    return model


def place_at(t: float, beyond: float, stiffness: float) -> float:
    """Its place outside of the stop: arcs of two harmonic motions follow each other."""
    omega, up = 2 * np.pi, 0.1 - beyond
    inside = np.hypot(omega, np.sqrt(stiffness))
    speed, depth = omega * np.sqrt(0.01 - up**2), up - stiffness * up / inside**2
    touch, leave = np.arcsin(up / 0.1), np.arccos(up / 0.1)
    turning = 2 * (np.pi / 2 - np.arctan2(depth * inside, speed)) / inside
    away = (t - touch / omega) % (turning + (2 * np.pi - 2 * leave) / omega) - turning
    assert away > 0
    return float(0.1 * np.cos(omega * away + leave))


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("beyond, stiffness", [(1.19e-4, 1e8), (2.5e-6, 5e6), (1e-3, 1e6)])
def test_a_stop_just_before_the_turning_point_is_met_in_each_period(
    beyond: float, stiffness: float, pair: str
) -> None:
    result = lw.simulate(
        stopped_oscillator(beyond, stiffness), 8.7, rtol=1e-7, integrator=pair, progress=False
    )
    assert result.position[-1, 0, 0] == pytest.approx(place_at(8.7, beyond, stiffness), abs=2e-4)


@pytest.mark.parametrize("pair", ["dopri5", "dop853"])
def test_a_turning_arm_meets_a_ball_that_drifts_into_its_way(pair: str) -> None:
    """Without losses: energy and the angular momentum about the hinge stay, and the ball does not."""
    n, phi, omega = 20, 5.032, 5.0
    t_meet = (phi + 2 * np.pi * n) / omega
    start = (np.cos(phi), np.sin(phi), -0.05 * t_meet)
    model = lw.Model(gravity=(0, 0, 0))
    model.body("arm", mass=1.0, inertia=(0.1,) * 3, omega=(0, 0, omega))
    model.revolute("ground", "arm", at=(0, 0, 0), axis=(0, 0, 1))
    model.body("ball", mass=1.0, inertia=(0.1,) * 3, position=start, velocity=(0, 0, 0.05))
    model.sphere_sphere_contact(
        "ball", "arm", at=(start, (1, 0, 0)), radius_a=0.03, radius_b=0.03, stiffness=1e6
    )
    result = lw.simulate(model, t_meet + 3.0, rtol=1e-5, integrator=pair, progress=False)
    arm, (r, v) = result.v[-1, 0, 5], (result.position[-1, 1], result.v[-1, 1])
    spin = 0.1 * arm + np.cross(r, v[:3])[2] + 0.1 * v[5]
    assert spin == pytest.approx(0.1 * omega, abs=1e-3)
    assert abs(arm) < 0.9 * omega


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("gap", [0.0, -1e-12, 1e-12])
def test_balls_that_touch_at_the_start_do_not_fly_through_each_other(gap: float, pair: str) -> None:
    model = two_spheres(2 * RADIUS + gap)
    far = {"at": (0, 1, 0), "axis": (1, 0, 0)}
    model.body("o", mass=1.0, inertia=(0.1,) * 3, position=(0, 1, 0), velocity=(0.5, 0, 0))
    model.translational("ground", "o", **far)
    model.translational_spring_damper("ground", "o", **far, stiffness=9.0)
    result = lw.simulate(model, 3.0, rtol=1e-6, integrator=pair, progress=False)
    assert result.v[-1, :2, 0] == pytest.approx([0.0, SPEED], abs=1e-3)


@pytest.mark.parametrize("step", [0.1, 0.05, 0.02])
def test_fixed_steps_that_fall_through_a_ball_from_rest_are_told(step: float) -> None:
    """Up at first: where the step over the ball begins it is slow."""
    radius, start = 0.0052, (0, 0, 0.2643)
    model = lw.Model(gravity=(0, 0, -10))
    model.body("ball", mass=0.1, inertia=(4e-6,) * 3, position=start, velocity=(0, 0, 1.858))
    model.sphere_sphere_contact(
        "ground", "ball", at=((0, 0, 0), start), radius_a=radius, radius_b=radius, stiffness=1e7
    )
    result = lw.simulate(model, 0.6, step, progress=False, on_inaccurate="pass")
    assert result.position[-1, 0, 2] > 0 or result.verdict.level == "wrong"


def parallelogram(peg: float) -> lw.Model:
    """A crank of 1 m with losses at a peg, 1 rad ahead; all bars lie in one line where its angle is zero."""
    model = lw.Model(gravity=(0, 0, 0))
    along: Callable[[float], np.ndarray] = lambda angle: np.array([np.cos(angle), 0, -np.sin(angle)])  # noqa: E731
    pin, far, axis = along(peg - 1.0), np.array([2.0, 0, 0]), (0, 1, 0)
    speed, inertia = np.cross([0, 5.0, 0], pin), (0.01, 0.1, 0.1)
    for name, at in (("first", 0 * far), ("second", far)):
        model.body(
            name,
            mass=1.0,
            inertia=inertia,
            position=at + pin / 2,
            velocity=speed / 2,
            omega=(0, 5, 0),
        )
        model.revolute("ground", name, at=at, axis=axis)
    model.body("coupler", mass=1.0, inertia=(0.01, 0.3, 0.3), position=pin + far / 2, velocity=speed)
    model.revolute("first", "coupler", at=pin, axis=axis)
    model.revolute("second", "coupler", at=pin + far, axis=axis)
    model.sphere_sphere_contact(
        "ground",
        "first",
        at=(along(peg), pin),
        radius_a=0.003,
        radius_b=0.003,
        stiffness=1e7,
        hysteresis=0.8,
    )
    return model


@pytest.mark.parametrize("peg", [0.05, 0.02, 0.003, -0.02])
def test_a_peg_beside_a_singular_pose_takes_what_it_takes_elsewhere(peg: float) -> None:
    """One degree of freedom: what is left of the speed does not depend on where the peg is."""
    ends = [lw.simulate(parallelogram(at), 0.3, rtol=1e-8, progress=False) for at in (0.5, peg)]
    assert ends[1].v[-1, 0, 4] == pytest.approx(ends[0].v[-1, 0, 4], rel=1e-3)


@pytest.mark.parametrize("count", [2, 5])
def test_contacts_that_begin_together_begin_with_the_speed_of_each(count: int) -> None:
    def end_of(count: int) -> np.ndarray:
        model = lw.Model()
        for k in range(count):
            at = (k, 0, 0.3)
            model.body(f"b{k}", mass=0.1, inertia=(4e-5,) * 3, position=at)
            model.sphere_plane_contact(
                "ground",
                f"b{k}",
                at=((0, 0, 0), at),
                normal=(0, 0, 1),
                radius=0.03,
                stiffness=1e6,
                hysteresis=0.5,
            )
        return lw.simulate(model, 0.26, rtol=1e-6, progress=False).v[-1, :, 2]

    assert end_of(count) == pytest.approx(np.full(count, end_of(1)[0]), rel=1e-5)


def test_a_soft_stop_that_is_grazed_changes_nothing_and_is_no_other_motion() -> None:
    result = lw.simulate(stopped_oscillator(1e-6, 10.0), 3.0, 0.003, progress=False)
    assert result.verdict.level == "good"
    assert result.position[-1, 0, 0] == pytest.approx(0.1 * np.sin(6 * np.pi), abs=1e-6)
    stiff = lw.simulate(
        stopped_oscillator(1e-5, 1e6), 0.3, 0.02, integrator="ab2", progress=False, on_inaccurate="pass"
    )
    assert "bodies pass through stop 'end'" in stiff.verdict.sentence


def beside_an_end(amplitude: float, frequency: float) -> lw.Model:
    """A slider at rest, 0.5 m above where the end of a stop swings about."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("s", mass=1.0, inertia=(0.1,) * 3)
    along = {"at": (0, 0, 0), "axis": (1, 0, 0)}
    model.translational("ground", "s", **along)
    lower = -0.5 + lw.functions.harmonic(amplitude, frequency)
    model.translational_stop("ground", "s", **along, lower=lower, upper=100.0, stiffness=1e7)
    return model


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("frequency", [37.0, 6283.0])
def test_the_end_of_a_stop_that_swings_meets_a_body_at_rest_when_it_first_comes(
    frequency: float, pair: str
) -> None:
    seconds, step = 0.2, 0.01 / frequency
    short = lw.simulate(beside_an_end(0.51, frequency), seconds, rtol=1e-10, step=step, progress=False)
    result = lw.simulate(beside_an_end(0.51, frequency), 1.0, rtol=1e-7, integrator=pair, progress=False)
    moved = short.position[-1, 0, 0] + (1.0 - seconds) * short.v[-1, 0, 0]
    assert result.position[-1, 0, 0] == pytest.approx(moved, rel=1e-4)
    assert moved > 1.0


@pytest.mark.parametrize("amplitude", [0.4999, 0.5])
def test_the_end_of_a_stop_that_swings_short_of_a_body_leaves_it_alone(amplitude: float) -> None:
    for how in ({"rtol": 1e-6}, {"step": 0.01}):
        result = lw.simulate(beside_an_end(amplitude, 6283.0), 1.0, **how, progress=False)
        assert result.position[-1, 0, 0] == 0.0
        assert result.verdict.level == "good"


def test_fixed_steps_tell_of_the_end_of_a_stop_that_swings_through_a_body() -> None:
    result = lw.simulate(beside_an_end(0.51, 6283.0), 1.0, 1e-3, progress=False, on_inaccurate="pass")
    assert "bodies pass through stop" in result.verdict.sentence


def test_the_end_of_a_stop_that_swings_too_often_to_be_followed_is_refused_by_name() -> None:
    with pytest.raises(lw.StepSizeError, match="its end comes and goes too often to be followed"):
        lw.simulate(beside_an_end(0.4999, 1e7), 1.0, rtol=1e-6, progress=False)
