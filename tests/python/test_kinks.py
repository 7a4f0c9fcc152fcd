"""Stiffness next to a kink of the forces, and at one: a contact or stop that just touches, or rests in it
less deep than the steps of differences are long."""

from __future__ import annotations

from collections.abc import Callable

import linkwork as lw
import numpy as np
import pytest

G = 9.81

Law = Callable[[float, float, float], float]


def on_a_stop(stiffness: float, away: float, mass: float = 0.1) -> lw.Model:
    """Beside another body that is far away."""
    model = lw.Model()
    body = model.body("block", mass=mass, inertia=(1e-4,) * 3, position=(0, 0, 0.05))
    model.translational("ground", body, at=(0, 0, 0.05), axis=(0, 0, 1))
    model.translational_stop(
        "ground", body, at=(0, 0, 0.05), axis=(0, 0, 1), lower=0.0, upper=1.0, stiffness=stiffness
    )
    far = model.body("far", mass=1.0, inertia=(0.1,) * 3, position=(away, 0, -1))
    model.revolute("ground", far, at=(away, 0, 0), axis=(0, 1, 0))
    return model


@pytest.mark.parametrize(("stiffness", "away"), [(1e5, 10), (1e5, 100), (1e9, 10), (1e7, 1000), (1e9, 1000)])
def test_what_rests_on_a_stop_has_its_stiffness_however_shallow_and_however_far_others_are(
    stiffness: float, away: float
) -> None:
    """Depths m g / k from 1e-5 to 1e-9 m; omega = sqrt(k / m)."""
    rest = lw.equilibrium(on_a_stop(stiffness, away))
    assert rest.stability == "stable"
    assert lw.linearize(rest.model).frequencies[-1] == pytest.approx(np.sqrt(stiffness / 0.1), rel=1e-6)


@pytest.mark.parametrize("stiffness", [1e9, 1e10, 1e11])
def test_a_ball_that_just_touches_a_plane_sinks_into_it_by_its_weight(stiffness: float) -> None:
    """F = k d^1.5, without stiffness where it begins; frequency by 1.5 k d^0.5, beside a body 1 km away."""
    model = lw.Model()
    ball = model.body("ball", mass=0.1, inertia=(1e-4,) * 3, position=(0, 0, 0.05))
    model.translational("ground", ball, at=(0, 0, 0.05), axis=(0, 0, 1))
    model.sphere_plane_contact(
        "ground", ball, at=((0, 0, 0), (0, 0, 0.05)), normal=(0, 0, 1), radius=0.05, stiffness=stiffness
    )
    far = model.body("far", mass=1.0, inertia=(0.1,) * 3, position=(1000, 0, -1))
    model.revolute("ground", far, at=(1000, 0, 0), axis=(0, 1, 0))
    depth = (0.1 * G / stiffness) ** (2 / 3)
    found = lw.linearize(lw.equilibrium(model).model)
    assert found.frequencies[-1] == pytest.approx(np.sqrt(1.5 * stiffness * depth**0.5 / 0.1), rel=1e-5)


def on_a_spring(law: Law | None = None) -> lw.Model:
    """1 kg on 100 N/m, as long as it is: omega = 10 rad/s without what the law adds."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("block", mass=1.0, inertia=(0.01,) * 3)
    model.translational("ground", body, at=(0, 0, 0), axis=(1, 0, 0), name="slide")
    model.translational_spring_damper("ground", body, at=(0, 0, 0), axis=(1, 0, 0), stiffness=100.0)
    if law is not None:
        model.joint_force("slide", law)
    return model


def beside_a_stop() -> lw.Model:
    """Which begins where the spring is not stretched: 100 N/m to one side, 3100 N/m to the other."""
    model = on_a_spring()
    model.translational_stop(
        "ground", "block", at=(0, 0, 0), axis=(1, 0, 0), lower=0.0, upper=1.0, stiffness=3000.0, name="stop"
    )
    return model


def beside_a_plane() -> lw.Model:
    model = on_a_spring()
    model.sphere_plane_contact(
        "ground", "block", at=((-0.1, 0, 0), (0, 0, 0)), normal=(1, 0, 0), radius=0.1, stiffness=1e9,
        name="stop",
    )  # fmt: skip
    return model


def against_a_stop() -> lw.Model:
    """An upright rod that touches a stop: it falls to the other side."""
    model = lw.Model()
    rod = model.body("block", mass=1.0, inertia=(0.01, 0.1, 0.1), position=(0, 0, 1))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_stop(
        "ground", rod, at=(0, 0, 0), axis=(0, 1, 0), lower=-1.5, upper=0.0, stiffness=3000.0, name="stop"
    )
    return model


@pytest.mark.parametrize("build", [beside_a_stop, beside_a_plane, against_a_stop])
def test_where_a_contact_just_touches_there_are_no_frequencies_and_stability_is_unknown(
    build: Callable[[], lw.Model],
) -> None:
    with pytest.raises(lw.ModelError, match="force 'stop' on body 'block' has a kink") as caught:
        lw.linearize(build())
    assert caught.value.code == "kink" and caught.value.forces == ["stop"]
    rest = lw.equilibrium(build())
    assert rest.stability == "unknown" and np.isnan(rest.softest)
    assert str(rest).startswith("equilibrium of unknown stability") and "'stop' on body 'block'" in str(rest)


def test_a_cradle_of_balls_that_just_touch_is_not_linear() -> None:
    model = lw.Model()
    for k in range(3):
        ball = model.body(f"ball {k}", mass=1.0, inertia=(1e-3,) * 3, position=(0.1 * k, 0, -1))
        model.revolute("ground", ball, at=(0.1 * k, 0, 0), axis=(0, 1, 0))
    for k in range(2):
        model.sphere_sphere_contact(
            f"ball {k}", f"ball {k + 1}", at=((0.1 * k, 0, -1), (0.1 * k + 0.1, 0, -1)),
            radius_a=0.05, radius_b=0.05, stiffness=1e9,
        )  # fmt: skip
    with pytest.raises(lw.ModelError, match="small motions are not linear"):
        lw.linearize(model)


@pytest.mark.parametrize("free_length", [0.0, 0.2])
def test_a_damper_whose_ends_coincide_has_no_direction(free_length: float) -> None:
    """Beside such a state it damps, at it it does not; and with a free length its force leaps."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("block", mass=1.0, inertia=(0.01,) * 3)
    model.orientation("ground", "block")
    model.spring_damper(
        "ground", "block", at=((0, 0, 0), (0, 0, 0)), stiffness=10.0, damping=0.5, free_length=free_length,
        name="spring",
    )  # fmt: skip
    with pytest.raises(lw.ModelError, match="force 'spring' on body 'block' has a kink"):
        lw.linearize(model)


@pytest.mark.parametrize("law", [
    lambda t, x, v: -0.1 * np.sign(v),
    lambda t, x, v: -3.0 * v * (x > 0),
    lambda t, x, v: -30.0 * max(x, 0.0),
], ids=["dry friction", "a damper to one side", "a spring to one side"])  # fmt: skip
def test_laws_of_the_users_own_with_a_kink_are_named(law: Law) -> None:
    with pytest.raises(lw.ModelError, match="force 'joint force 1' on body 'block' has a kink"):
        lw.linearize(on_a_spring(law))


@pytest.mark.parametrize("law", [
    lambda t, x, v: -5.0 * v * abs(v),
    lambda t, x, v: -1e6 * x * abs(x),
    lambda t, x, v: -1e5 * x**3,
    lambda t, x, v: -3.0 * abs(x) * v,
    lambda t, x, v: -1e5 * max(x - 1e-7, 0.0),
    lambda t, x, v: -1e4 * (max(x - 1e-4, 0.0) + min(x + 1e-4, 0.0)),
], ids=["drag", "stiffening", "cubic", "damped aside", "near a bumper", "play"])  # fmt: skip
def test_laws_with_a_slope_on_both_sides_of_their_derivative_are_linear(law: Law) -> None:
    """f = c x |x| has the derivative 2 c |x|, 0 at the state: they add nothing."""
    assert lw.linearize(on_a_spring(law)).eigenvalues == pytest.approx([10j], abs=1e-5)
    assert lw.equilibrium(on_a_spring(law)).softest == pytest.approx(100.0, rel=1e-6)


@pytest.mark.parametrize("transition", [1e-3, 1e-6, 1e-9])
def test_regularized_friction_is_a_damper_however_steep(transition: float) -> None:
    found = lw.linearize(on_a_spring(lambda t, x, v: -np.tanh(v / transition)))
    assert found.C.toarray()[0, 0] == pytest.approx(1 / transition, rel=1e-5)


def test_noise_of_a_law_is_no_kink() -> None:
    random = np.random.default_rng(0)
    found = lw.linearize(on_a_spring(lambda t, x, v: -50.0 * x + 1e-13 * random.standard_normal()))
    assert found.eigenvalues.imag == pytest.approx([np.sqrt(150)], rel=1e-4)


def test_a_kink_in_directions_that_joints_hold_does_not_count() -> None:
    """A sphere on a plane that it just touches, held by a joint; a pendulum on it."""
    model = lw.Model()
    ball = model.body("ball", mass=1.0, inertia=(0.1,) * 3, position=(0, 0, 0.1))
    model.fixed("ground", ball, at=(0, 0, 0))
    model.sphere_plane_contact(
        "ground", ball, at=((0, 0, 0), (0, 0, 0.1)), normal=(0, 0, 1), radius=0.1, stiffness=1e8
    )
    bob = model.body("bob", mass=1.0, inertia=(0.1,) * 3, position=(1, 0, 0))
    model.revolute(ball, bob, at=(1, 0, 1), axis=(0, 1, 0))
    assert lw.linearize(model).frequencies == pytest.approx([np.sqrt(G / 1.1)], rel=1e-8)
    assert lw.equilibrium(model).stability == "stable"
