"""Static equilibrium where contacts hold, and where nothing does."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms.tracked_chain import TENSION, tracked_chain
from scipy.optimize import brentq

Z = (0.0, 0.0, 1.0)


def wheel(**state: object) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0), name="rig")
    body = model.body("wheel", mass=2.0, inertia=(0.1, 0.1, 0.2), **state)
    model.revolute(model.ground, body, at=(0, 0, 0), axis=Z, name="bearing")
    return model


def test_a_motor_against_friction_goes_round() -> None:
    model = wheel()
    model.motor(model.ground, "wheel", at=(0, 0, 0), axis=Z, curve=lw.functions.polynomial(5.0, -1.0))
    model.rotational_friction(model.ground, "wheel", at=(0, 0, 0), axis=Z, coulomb=8.0)
    with pytest.raises(
        lw.NotConvergedError, match=r"body 'wheel' is driven by 5 N m still, and goes"
    ) as caught:
        lw.equilibrium(model)
    assert caught.value.code == "goes_round" and caught.value.state is not None


def test_a_motor_against_a_spring_rests_far_from_where_it_started() -> None:
    model = wheel()
    model.rotational_spring_damper(model.ground, "wheel", axis=Z, stiffness=0.25, torque=0.25 * 3.0)
    rest = lw.equilibrium(model)
    assert rest.turned == pytest.approx([3.0], abs=1e-8)


def test_a_track_that_is_not_driven_rests_on_its_rollers() -> None:
    model = tracked_chain(40, speed=0.0)
    rest = lw.equilibrium(model)
    q = rest.model.compiled().q0
    v_dot, _ = lw.System(rest.model).accelerations(0.0, q, np.zeros(6 * model.body_count))
    assert np.abs(v_dot).max() < 1e-7
    wheel, idler, guide = (
        rest.reaction(name).force for name in ("wheel bearing", "idler bearing", "slide guide")
    )
    assert wheel[1] + guide[1] == pytest.approx(9.81 * np.sum(model.compiled().mass), rel=1e-9)
    assert wheel[1] == pytest.approx(idler[1], rel=1e-6)
    assert idler[0] == pytest.approx(-wheel[0], rel=1e-9)
    assert idler[0] == pytest.approx(2 * TENSION, rel=0.01)


def test_a_torsion_spring_is_wound_over_several_turns() -> None:
    model = wheel()
    model.rotational_spring_damper(model.ground, "wheel", axis=Z, stiffness=1.0, torque=10.0, name="spring")
    rest = lw.equilibrium(model)
    result = lw.simulate(rest.model, t_end=0.01, step=1e-3)
    assert rest.stability == "stable"
    assert result.force("spring").deflection == pytest.approx(10.0, abs=1e-9)


def test_a_weight_turns_a_drum_several_times_until_its_spring_holds() -> None:
    model = wheel()
    model.body("weight", mass=2.0, inertia=(0.1, 0.1, 0.1))
    model.translational(model.ground, "weight", at=(0, 0, 0), axis=Z, name="guide")
    model.coupler([("bearing", 1.0), ("guide", -100.0)])
    model.translational_spring_damper(model.ground, "weight", at=(0, 0, 0), axis=Z, stiffness=100.0)
    model.force("weight", force=(0, 0, -20.0))
    rest = lw.equilibrium(model)
    assert rest.model.compiled().q0[9] == pytest.approx(-0.2, rel=1e-9)
    result = lw.simulate(rest.model, t_end=0.01, step=1e-3)
    assert result.position[-1, 1, 2] == pytest.approx(-0.2, rel=1e-9)
    softness = lw.linearize(rest.model).frequencies
    assert softness == pytest.approx([np.sqrt(100 / (2 + 0.2 * 100**2))], rel=1e-6)


def screw(load: float) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("nut", mass=20.0, inertia=(0.1, 0.1, 0.1))
    model.screw(model.ground, "nut", at=(0, 0, 0), axis=Z, pitch=0.05, name="screw")
    model.force("nut", force=(0, 0, -load))
    return model


def test_a_torsion_spring_on_a_screw_is_wound_by_as_many_turns_as_the_screw() -> None:
    model, lead = screw(200.0), 0.05 / (2 * np.pi)
    model.rotational_spring_damper(model.ground, "nut", at=(0, 0, 0), axis=Z, stiffness=0.05)
    model.translational_spring_damper(model.ground, "nut", at=(0, 0, 0), axis=Z, stiffness=1500.0)
    angle = -200.0 * lead / (0.05 + 1500.0 * lead**2)
    assert angle < -3 * np.pi
    assert lw.equilibrium(model).model.compiled().q0[2] == pytest.approx(angle * lead, rel=1e-9)


def test_a_stop_holds_after_more_turns_than_those_of_a_body_that_goes_round() -> None:
    model, lead = screw(200.0), 0.05 / (2 * np.pi)
    model.rotational_stop(model.ground, "nut", at=(0, 0, 0), axis=Z, lower=-20.0, upper=20.0, stiffness=10.0)
    angle = -20.0 - 200.0 * lead / 10.0
    assert lw.equilibrium(model).model.compiled().q0[2] == pytest.approx(angle * lead, rel=1e-9)


@pytest.mark.parametrize(("pitch", "counted"), [(0.01, False), (1e-3, False), (1e-4, False), (1e-3, True)])
def test_a_nut_sinks_on_its_spring_however_fine_the_thread_is(pitch: float, counted: bool) -> None:
    """By up to 5000 turns; also where a soft spring on the spindle counts them."""
    model, lead = lw.Model(), pitch / (2 * np.pi)
    model.body("spindle", mass=1.0, inertia=(0.01, 0.01, 0.02))
    model.body("nut", mass=5.0, inertia=(1, 1, 1), position=(0, 0, 0.1))
    model.revolute("ground", "spindle", at=(0, 0, 0), axis=Z, name="bearing")
    model.translational("ground", "nut", at=(0, 0, 0.1), axis=Z, name="guide")
    model.screw("spindle", "nut", at=(0, 0, 0.1), axis=Z, pitch=pitch)
    softness = 10.0 * lead**2 if counted else 0.0
    model.translational_spring_damper(
        "ground", "nut", at=(0, 0, 0.1), axis=Z, stiffness=98.1 - softness / lead**2
    )
    if counted:
        model.rotational_spring_damper("ground", "spindle", axis=Z, stiffness=softness)
    rest = lw.equilibrium(model)
    assert rest.moved[1] == pytest.approx(0.5, rel=1e-6)
    assert rest.stability == "stable" and rest.iterations < 100


@pytest.mark.parametrize("radius", [0.2, 4e-3, 1.1e-3])
def test_a_rack_sinks_on_its_spring_however_small_the_pinion_is(radius: float) -> None:
    model = lw.Model(gravity=(0, -9.81, 0))
    model.body("rack", mass=5.0, inertia=(1, 1, 1))
    model.body("pinion", mass=0.1, inertia=(1e-3,) * 3, position=(0.5, 0, 0))
    model.translational("ground", "rack", at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute("ground", "pinion", at=(0.5, 0, 0), axis=Z)
    model.rack_pinion("rack", "pinion", at=(0.5, 0, 0), axes=((0, 1, 0), Z), radius=radius)
    model.translational_spring_damper("ground", "rack", at=(0, 0, 0), axis=(0, 1, 0), stiffness=20.0)
    rest = lw.equilibrium(model)
    q = np.array(rest.model.compiled().q0).reshape(-1, 7)
    assert q[0, 1] == pytest.approx(-5 * 9.81 / 20, rel=1e-9)
    turn = np.angle(np.exp(1j * (q[0, 1] / radius - 2 * np.arctan2(q[1, 6], q[1, 3]))))
    assert abs(turn) < 1e-8


def test_a_peg_on_a_wheel_rests_against_the_first_ball_that_it_meets() -> None:
    """Long turns begin only after a whole one in which nothing was met."""
    model, angle = wheel(), 5.5
    ball = (0.3 * np.cos(angle), 0.3 * np.sin(angle), 0.0)
    model.rotational_spring_damper("ground", "wheel", axis=Z, torque=2.0)
    model.sphere_sphere_contact(
        "ground", "wheel", at=(ball, (0.3, 0, 0)), radius_a=0.03, radius_b=0.03, stiffness=1e6
    )
    q = np.array(lw.equilibrium(model).model.compiled().q0)
    turned = 2 * np.arctan2(q[6], q[3]) % (2 * np.pi)
    assert turned == pytest.approx(angle - 2 * np.arcsin(0.03 / 0.3), abs=2e-3)  # it yields


def unbalanced_disc(phi: float, stiffness: float, slope: float) -> lw.Model:
    """It rolls in a plane, a spring holds its middle; its mass is 8 cm off, phi from the lowest place."""
    model = lw.Model(gravity=(9.81 * np.sin(slope), 0, -9.81 * np.cos(slope)))
    middle = np.array([0.0, 0.0, 0.2])
    place = middle - 0.08 * np.array([np.sin(phi), 0, np.cos(phi)])
    model.body("disc", mass=1.5, inertia=(0.02, 0.02, 0.02), position=place)
    model.planar("ground", "disc", at=middle, axis=(0, 1, 0))
    model.rolling_disc("ground", "disc", at=((0, 0, 0), middle), axes=(Z, (0, 1, 0)), radius=0.2)
    model.translational_spring_damper("ground", "disc", at=middle, axis=(1, 0, 0), stiffness=stiffness)
    return model


@pytest.mark.parametrize(("phi", "stiffness", "slope"), [(2.9, 3.0, 0.0), (2.9, 0.5, 0.2), (1.0, 2.0, 0.3)])
def test_a_disc_rolls_to_its_rest_without_slip(phi: float, stiffness: float, slope: float) -> None:
    """V(a) = m g e (-cos(phi + a)) and so on, of the turn a alone, as the middle moves by R a."""
    R, e, weight = 0.2, 0.08, 1.5 * 9.81

    def downhill(a: float) -> float:
        along, across = weight * np.sin(slope), weight * np.cos(slope)
        lever = e * np.sin(phi + a)
        return along * (R - e * np.cos(phi + a)) - across * lever - stiffness * R**2 * a

    step = 1e-3 * np.sign(downhill(0.0))
    a = 0.0
    while downhill(a) * step > 0:
        a += step
    exact = brentq(downhill, a - step, a, xtol=1e-14)
    rest = lw.equilibrium(unbalanced_disc(phi, stiffness, slope))
    x, _, _ = np.array(rest.model.compiled().q0)[:3]
    assert rest.stability == "stable"
    assert x + e * np.sin(phi + exact) == pytest.approx(R * exact, abs=1e-8)


def test_two_wheels_that_a_spring_joins_turn_by_their_ways_over_their_radii() -> None:
    model, radii = lw.Model(), (0.1, 0.25)
    for k, R in enumerate(radii):
        model.body(f"wheel {k}", mass=1.0, inertia=(0.01,) * 3, position=(k, 0, R))
        model.planar("ground", f"wheel {k}", at=(k, 0, R), axis=(0, 1, 0))
        model.rolling_disc("ground", f"wheel {k}", at=((0, 0, 0), (k, 0, R)), axes=(Z, (0, 1, 0)), radius=R)
    model.spring_damper("wheel 0", "wheel 1", at=((0, 0, 0.1), (1, 0, 0.25)), stiffness=50.0, free_length=2.0)
    model.translational_spring_damper("ground", "wheel 0", at=(0, 0, 0.1), axis=(1, 0, 0), stiffness=40.0)
    q = np.array(lw.equilibrium(model).model.compiled().q0).reshape(-1, 7)
    for k, R in enumerate(radii):
        turn = 2 * np.arctan2(q[k, 5], q[k, 3])
        assert np.angle(np.exp(1j * (turn - (q[k, 0] - k) / R))) == pytest.approx(0.0, abs=1e-8)
    assert abs(q[1, 0] - 1) > 0.5


def lamp_in_a_ship(mass: float, angle: float) -> lw.Model:
    """A ship on its buoyancy, and a lamp of 2 kg in it, hung out of the vertical."""
    model = lw.Model()
    model.body("ship", mass=mass, inertia=(10 * mass, 200 * mass, 200 * mass))
    model.translational("ground", "ship", at=(0, 0, 0), axis=Z)
    model.translational_spring_damper("ground", "ship", at=(0, 0, 0), axis=Z, stiffness=10 * mass)
    at = (10 + 0.3 * np.sin(angle), 0, 5 - 0.3 * np.cos(angle))
    model.body("lamp", mass=2.0, inertia=(1e-3, 1e-3, 1e-3), position=at)
    model.revolute("ship", "lamp", at=(10, 0, 5), axis=(0, 1, 0), name="pin")
    return model


@pytest.mark.parametrize("mass", [1e3, 1e7, 1e8])
def test_a_lamp_hangs_vertically_however_heavy_its_ship_is(mass: float) -> None:
    rest = lw.equilibrium(lamp_in_a_ship(mass, 0.5))
    ship, lamp = np.array(rest.model.compiled().q0).reshape(-1, 7)
    assert rest.stability == "stable" and rest.imbalance < 1e-9
    assert lamp[0] - ship[0] == pytest.approx(10.0, abs=1e-7)
    swing = np.sqrt(2 * 9.81 * 0.3 / (2 * 0.3**2 + 1e-3))
    assert lw.linearize(rest.model).frequencies == pytest.approx(
        [np.sqrt(10 * mass / (mass + 2)), swing], rel=1e-6
    )


def test_linearize_refuses_a_light_body_out_of_balance_beside_a_heavy_one() -> None:
    model = lamp_in_a_ship(1e7, 0.5)
    q = np.array(model.compiled().q0).reshape(-1, 7)
    q[:, 2] -= 0.981
    with pytest.raises(lw.ModelError, match="body 'lamp' is driven"):
        lw.linearize(model.with_initial_state(q, np.zeros((2, 6))))


@pytest.mark.parametrize("distance", [1.0, 1e2])
def test_an_upright_bob_falls_beside_whatever_is_stiff_and_far(distance: float) -> None:
    model = lw.Model()
    model.body("bob", mass=1.0, inertia=(1e-3, 1e-3, 1e-3), position=(0, 0, 0.1))
    model.revolute("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0))
    model.body("far", mass=1e6, inertia=(1e6, 1e6, 1e6), position=(distance, 0, 0))
    model.translational("ground", "far", at=(distance, 0, 0), axis=(1, 0, 0))
    model.translational_spring_damper("ground", "far", at=(distance, 0, 0), axis=(1, 0, 0), stiffness=1e10)
    assert lw.equilibrium(model, stable=False).stability == "unstable"
    rest = lw.equilibrium(model)
    assert rest.stability == "stable"
    assert np.array(rest.model.compiled().q0)[2] == pytest.approx(-0.1, rel=1e-9)


def test_a_heavy_load_on_links_of_a_gram_rests_within_its_rounding() -> None:
    model = lw.Model()
    above = model.ground
    for k in range(6):
        link = model.body(f"link {k}", mass=1e-3, inertia=(1e-6, 1e-6, 1e-6), position=(0.1 * k + 0.05, 0, 0))
        model.revolute(above, link, at=(0.1 * k, 0, 0), axis=(0, 1, 0))
        above = link
    model.body("load", mass=1e6, inertia=(1e6, 1e6, 1e6), position=(1.6, 0, 0))
    model.revolute(above, "load", at=(0.6, 0, 0), axis=(0, 1, 0))
    rest = lw.equilibrium(model)
    assert np.array(rest.model.compiled().q0).reshape(-1, 7)[-1, :3] == pytest.approx([0, 0, -1.6], abs=1e-6)
    assert rest.imbalance < 1e-9


@pytest.mark.parametrize("torque", [10.0, 70.0])
def test_what_equilibrium_returns_is_in_balance_for_linearize_where_large_torques_cancel(
    torque: float,
) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(1, 1, 1))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=Z, name="pin")
    model.rotational_spring_damper("ground", "wheel", at=(0, 0, 0), axis=Z, stiffness=1.0)
    model.joint_force("pin", lambda t, x, v: torque)
    rest = lw.equilibrium(model)
    assert rest.imbalance < 1e-12
    assert lw.linearize(rest.model).frequencies == pytest.approx([1.0], rel=1e-9)


@pytest.mark.parametrize("depth", [1.0, 100.0, 1e4])
def test_a_weight_sinks_on_a_soft_spring_however_far(depth: float) -> None:
    model = lw.Model()
    model.body("weight", mass=1.0, inertia=(0.01, 0.01, 0.01))
    model.translational("ground", "weight", at=(0, 0, 0), axis=Z)
    model.translational_spring_damper("ground", "weight", at=(0, 0, 0), axis=Z, stiffness=9.81 / depth)
    rest = lw.equilibrium(model)
    assert np.array(rest.model.compiled().q0)[2] == pytest.approx(-depth, rel=1e-9)
    assert rest.iterations < 100


def test_a_torsion_spring_is_wound_over_fifty_turns() -> None:
    model, angle = wheel(), 100 * np.pi
    model.rotational_spring_damper(model.ground, "wheel", axis=Z, stiffness=1.0, torque=angle, name="spring")
    result = lw.simulate(lw.equilibrium(model).model, t_end=0.01, step=1e-3)
    assert result.force("spring").deflection == pytest.approx(angle, rel=1e-9)


def test_an_equilibrium_that_is_too_far_is_told_as_such(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwork.analyses.equilibrium.ALL_ITERATIONS", 5)
    model = wheel()
    model.rotational_spring_damper(model.ground, "wheel", axis=Z, stiffness=1.0, torque=100.0)
    with pytest.raises(lw.NotConvergedError, match="still moves on by large steps while that falls"):
        lw.equilibrium(model)


def test_a_run_that_came_to_rest_is_linearized_there() -> None:
    model, arm = lw.Model(), np.hypot(0.3, 0.9)
    model.body("bob", mass=1.0, inertia=(0.01, 0.01, 0.01), position=(0.3, 0, -0.9))
    model.revolute("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_spring_damper("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0), stiffness=0.0, damping=3.0)
    settled = lw.simulate(model, t_end=30.0, step=2e-3).snapshot()
    assert 0.0 < np.abs(settled.v).max() < 1e-9
    found = lw.linearize(model, start=settled)
    exact = np.roots([arm**2 + 0.01, 3.0, 9.81 * arm])
    assert found.eigenvalues == pytest.approx([exact[exact.imag > 0][0]], rel=1e-6)
    assert not found.snapshot.v.any()


def buckled(k: float) -> lw.Model:
    """A slider that two springs press out of the line, -1 N/m, beside 89 others on springs of k [N/m]."""
    model = lw.Model(gravity=(0, 0, 0))
    for i in range(90):
        model.body(f"slider {i}", mass=1.0, inertia=(1.0,) * 3, position=(i, 0, 0))
        model.translational("ground", f"slider {i}", at=(i, 0, 0), axis=(0, 1, 0))
        if i:
            model.translational_spring_damper(
                "ground", f"slider {i}", at=(i, 0, 0), axis=(0, 1, 0), stiffness=k
            )
    model.spring_damper("ground", "slider 0", at=((0, 0, -1), (0, 0, 0)), stiffness=2.0, free_length=1.5)
    return model


@pytest.mark.parametrize("k", [1.0, 0.1, 1e-4])
def test_of_a_large_model_the_smallest_stiffness_is_told_and_not_the_one_nearest_to_zero(k: float) -> None:
    rest = lw.equilibrium(buckled(k), stable=False)
    assert rest.softest == pytest.approx(-1.0, rel=1e-9)
    assert rest.stability == "unstable"
    assert lw.equilibrium(buckled(k)).moved.max() == pytest.approx(np.sqrt(1.5**2 - 1), rel=1e-6)


@pytest.mark.parametrize("count", [12, 120])
def test_pendulums_that_nothing_joins_fall_all_at_once(count: int) -> None:
    model = lw.Model()
    for k in range(count):
        model.body(f"rod {k}", mass=1 + 0.1 * k, inertia=(0.1, 0.1, 0.1), position=(3.0 * k, 0, 0.5))
        model.revolute("ground", f"rod {k}", at=(3.0 * k, 0, 0), axis=(0, 1, 0))
    rest = lw.equilibrium(model)
    assert rest.stability == "stable" and rest.imbalance < 1e-9
    assert rest.iterations < 100
    np.testing.assert_allclose(np.array(rest.model.compiled().q0)[2::7], -0.5, atol=1e-9)


@pytest.mark.parametrize("stiffness", [1e6, 1e10, 1e12])
def test_a_small_pendulum_falls_beside_whatever_is_stiff(stiffness: float) -> None:
    """That what rounding makes of the other part is more than all of its own says nothing of it."""
    model = lw.Model()
    model.body("slider", mass=1.0, inertia=(0.1,) * 3, position=(3, 0, 0))
    model.translational("ground", "slider", at=(3, 0, 0), axis=(0, 0, 1))
    model.translational_spring_damper("ground", "slider", at=(3, 0, 0), axis=(0, 0, 1), stiffness=stiffness)
    model.body("small", mass=1e-3, inertia=(1e-8,) * 3, position=(0, 0, 0.005))
    model.revolute("ground", "small", at=(0, 0, 0), axis=(0, 1, 0))
    assert lw.equilibrium(model, stable=False).stability == "unstable"
    rest = lw.equilibrium(model)
    assert rest.stability == "stable" and rest.moved[1] == pytest.approx(0.01, rel=1e-9)


def test_one_heavy_pendulum_upside_down_beside_89_that_hang_falls() -> None:
    model = lw.Model()
    for i in range(90):
        mass, z = (1.0, 0.5) if i == 0 else (0.01, -0.5)
        model.body(f"bob {i}", mass=mass, inertia=(1e-3 * mass,) * 3, position=(0.01 * i, 0, z))
        model.revolute("ground", f"bob {i}", at=(0.01 * i, 0, 0), axis=(1, 0, 0))
    assert lw.equilibrium(model, stable=False).stability == "unstable"
    rest = lw.equilibrium(model)
    assert rest.stability == "stable"
    assert rest.moved[0] == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("shift", np.linspace(0.1, 2.0, 7))
def test_a_body_on_a_slack_bending_spring_rests_where_it_is(shift: float) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    turned = lw.rotation.about((1, 2, 3), 0.7)
    model.body("b", mass=1.0, inertia=(0.06,) * 3, position=(shift, -0.2, 0.3), orientation=turned)
    model.revolute("ground", "b", at=(-0.16, 0.343, -0.278), axis=(0.29, -0.23, -0.93))
    model.bending_spring("ground", "b", axis=(0.6, 0.8, 0), stiffness=0.93)
    rest = lw.equilibrium(model)
    assert rest.stability == "stable" and rest.imbalance < 1e-9
    assert lw.linearize(rest.model).stable


@pytest.mark.parametrize("seed", range(8))
def test_a_chain_with_a_slack_bending_spring_rests_where_it_is(seed: int) -> None:
    """The rounding of its torques reaches links that have no others."""
    model, random = lw.Model(gravity=(0, 0, 0)), np.random.default_rng(seed)
    before, at = "ground", np.zeros(3)
    for k in range(4):
        name, turned = f"link {k}", lw.rotation.about(random.standard_normal(3), 1.0)
        model.body(name, mass=1.0, inertia=(0.06,) * 3, position=at, orientation=turned)
        model.spherical(before, name, at=at + random.standard_normal(3))
        before, at = name, at + random.standard_normal(3)
    model.bending_spring("link 2", "link 3", axis=random.standard_normal(3), stiffness=1e3)
    rest = lw.equilibrium(model)
    assert rest.moved.max() < 1e-12 and rest.imbalance < 1e-9
    assert lw.linearize(rest.model).frequencies[-1] > 1.0


def test_a_pendulum_of_two_bodies_that_are_stiffly_joined_falls_in_a_few_hundred_steps() -> None:
    model, upward = lw.Model(), np.array([np.sin(1.0), 0.0, np.cos(1.0)])
    model.body("a", mass=1e-3, inertia=(0.1,) * 3, position=upward)
    model.body("b", mass=1.0, inertia=(0.1,) * 3, position=1.3 * upward)
    model.distance("ground", "a", at=((0, 0, 0), upward))
    model.bushing("a", "b", at=upward, stiffness=(3e6,) * 3, rotational_stiffness=(3e6,) * 3)
    rest = lw.equilibrium(model)
    assert rest.model.compiled().q0[2::7].max() < -0.9
    assert rest.iterations < 300


@pytest.mark.parametrize("hangs", ["ground", "heavy"])
@pytest.mark.parametrize("mass", [1e-3, 1e-6])
@pytest.mark.parametrize("stiffness", [1e6, 1e8, 1e10])
def test_light_bodies_beside_stiff_springs_come_to_rest(stiffness: float, mass: float, hangs: str) -> None:
    """Whose rounding is more than their weights."""
    model, below = lw.Model(), np.array([0.1 * np.sin(0.5), 0.0, -2.0 - 0.1 * np.cos(0.5)])
    model.body("heavy", mass=1.0, inertia=(0.1,) * 3)
    model.spring_damper("ground", "heavy", at=((0, 0, 1), (0, 0, 0)), stiffness=stiffness, free_length=1.0)
    model.translational("ground", "heavy", at=(0, 0, 0), axis=(0, 0, 1))
    model.body("light", mass=mass, inertia=(1e-3 * mass,) * 3, position=below)
    model.revolute(hangs, "light", at=(0, 0, -2), axis=(0, 1, 0))
    with pytest.raises(lw.ModelError, match="not in balance"):
        lw.linearize(model)
    rest = lw.equilibrium(model)
    assert abs(rest.model.compiled().q0.reshape(-1, 7)[1, 0]) < 1e-8
    assert rest.imbalance < 1e-9


def in_units_of(length: float) -> lw.Model:
    """A bar of one such length on a hinge, held by a spring, and a rope of five bars."""
    model = lw.Model(gravity=(0, 0, -9.81 * length))
    bar = model.body("bar", mass=1.0, inertia=np.array([0.01, 0.1, 0.1]) * length**2,
                     position=(0.5 * length, 0, 0))  # fmt: skip
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.spring_damper("ground", bar, at=((length, 0, length), (length, 0, 0)), stiffness=30.0,
                        damping=0.0, free_length=0.5 * length, name="spring")  # fmt: skip
    for k in range(5):
        link = model.body(f"link {k}", mass=0.1, inertia=np.array([1e-4, 1e-2, 1e-2]) * length**2,
                          position=((1.5 + k) * length, 0, 0))  # fmt: skip
        model.revolute(bar, link, at=((1 + k) * length, 0, 0), axis=(0, 1, 0), name=f"pin {k}")
        bar = link
    return model


def test_equilibrium_takes_the_same_way_in_any_unit_of_length() -> None:
    def found(length: float) -> lw.Equilibrium:
        return lw.equilibrium(in_units_of(length))

    meter = found(1.0)
    for length in (1e-8, 1e-6, 1e-3, 1e3):
        other = found(length)
        assert other.iterations == meter.iterations
        assert other.model.compiled().q0.reshape(-1, 7)[:, :3] / length == pytest.approx(
            meter.model.compiled().q0.reshape(-1, 7)[:, :3], abs=1e-7
        )


@pytest.mark.filterwarnings("error::RuntimeWarning")
def test_a_way_past_a_pose_without_a_constraint_warns_of_nothing() -> None:
    with pytest.raises(lw.NotConvergedError, match="found none"):
        lw.equilibrium(lw.mechanisms.rolling_disc())  # which lies flat on its way


def follower_column(load: float, damping: float) -> lw.Model:
    """Ziegler's: bars of 1 m, 2 kg and 1 kg at their ends, hinges of 1 N m/rad, the load along the second."""
    model = lw.Model(gravity=(0, 0, 0), name="column")
    last = model.ground
    for k, mass in enumerate((2.0, 1.0)):
        bar = model.body(f"bar {k}", mass=mass, inertia=(1e-9,) * 3, position=(k + 1, 0, 0))
        place = {"at": (k, 0, 0), "axis": Z}
        model.revolute(last, bar, **place)
        model.rotational_spring_damper(last, bar, **place, stiffness=1.0, damping=damping)
        last = bar
    model.force(last, force=(-load, 0, 0), frame="body")
    return model


@pytest.mark.parametrize(
    ("load", "damping", "stability"),
    [
        (2.0, 0.0, "stable"),
        (2.15, 0.0, "unstable"),
        (1.42, 0.01, "stable"),
        (1.52, 0.01, "unstable"),
    ],
)
def test_a_column_under_a_follower_load_flutters(load: float, damping: float, stability: str) -> None:
    """Beyond 7/2 - sqrt(2) N, and with the same small damping in both hinges beyond 41/28 N already (Ziegler,
    Die Stabilitätskriterien der Elastomechanik, Ingenieur-Archiv 20, 1952): all stiffness is positive."""
    rest = lw.equilibrium(follower_column(load, damping))
    assert rest.stability == stability
    assert ("small motions grow" in str(rest)) == (stability == "unstable")


def disc_in_springs() -> lw.Model:
    center, upright = np.array((0.1, 0, 0.1)), lw.rotation.about((1, 0, 0), np.pi / 2)
    model = lw.Model()
    model.body("disc", mass=0.5, inertia=(0.00125, 0.00125, 0.0025), position=center, orientation=upright)
    axes = (Z, lw.rotation.matrix(upright)[:, 2])
    model.rolling_disc("ground", "disc", at=((0, 0, 0), center), axes=axes, radius=0.1)
    for end, stiffness, rise, damping in (
        ((1, 1, 0.3), 80.0, 0.0, 0.3),
        ((-1, 0.1, 0.3), 40.0, 0.0, 0.0),
        ((0, 1, 1), 40.0, 0.05, 0.0),
        ((0, -1, 1), 40.0, 0.05, 0.0),
    ):
        at = (end, center + np.array((0, 0, rise)))
        model.spring_damper("ground", "disc", at=at, stiffness=stiffness, damping=damping, free_length=0.8)
    return model


def test_motions_of_a_disc_that_rolls_grow_although_it_is_stiff() -> None:
    rest = lw.equilibrium(disc_in_springs())
    assert rest.softest > 0 and rest.stability == "unstable"
    pushed = lw.assemble(rest.model.replaced("disc", omega=(1e-6, 0, 2e-6))).model
    energy = lw.simulate(pushed, 1.2, rtol=1e-9, progress=False).kinetic_energy
    assert energy.max() > 1e4 * energy[0]
