"""Energy, work and momentum: what every mechanism must balance."""

from __future__ import annotations

from functools import cache

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from linkwork import mechanisms
from linkwork.arrays import Floats
from linkwork.integrators import METHODS
from random_mechanisms import Mechanism, examples
from random_mechanisms import mechanisms as random_mechanisms

harmonic = lw.functions.harmonic


def powered() -> lw.Model:
    """Two bodies with a driven rod, dampers, actuators, a motor and forces that change in time."""
    model = lw.Model()
    ground = model.ground
    arm = model.body("arm", mass=2.0, inertia=(0.1, 0.3, 0.3), position=(0.5, 0, 0))
    bob = model.body(
        "bob", mass=1.0, inertia=(0.2, 0.1, 0.15), position=(1.0, 0.5, 0.3), velocity=(0, 0.3, 0)
    )
    model.revolute(ground, arm, at=(0, 0, 0), axis=(0, 1, 0.2))
    length = harmonic(amplitude=0.1, frequency=3.0, offset=0.5)
    model.distance(arm, bob, at=((1.0, 0, 0.3), (1.0, 0.5, 0.3)), length=length)
    model.spring_damper(
        ground, bob, at=((1.5, 1.0, 1.5), (1.1, 0.5, 0.3)), stiffness=20.0, damping=2.0,
        free_length=harmonic(0.2, 5.0, offset=1.0), force=harmonic(3.0, 4.0),
    )  # fmt: skip
    model.rotational_spring_damper(
        ground,
        arm,
        axis=(0, 1, 0.2),
        stiffness=lw.functions.polynomial(5.0, 2.0),
        damping=0.5,
        torque=harmonic(4.0, 6.0),
    )
    model.force(bob, force=(harmonic(5.0, 7.0), 0.0, 2.0), torque=(0, 0.3, 0), at=(0.1, 0.2, 0), frame="body")
    model.force(arm, force=(0, harmonic(2.0, 3.0), 1.0))
    return model


@cache
def energy_error(method: str, steps: int) -> float:
    """Largest during 1 s."""
    try:
        result = lw.simulate(powered(), 1.0, 1.0 / steps, method, record_every=steps // 16, progress=False,
                             on_inaccurate="pass")  # fmt: skip
    except (lw.NotFiniteError, lw.SingularSystemError):
        return np.inf
    return float(np.abs(result.energy_error).max())


@pytest.mark.parametrize("method", METHODS)
def test_the_energy_error_with_work_converges_with_the_order_of_the_method(method: str) -> None:
    steps = 2**13
    while energy_error(method, steps) < 5e-12:  # roundoff
        steps //= 2
    assert (
        np.log2(energy_error(method, steps // 2) / energy_error(method, steps)) >= METHODS[method].order - 0.2
    )


def test_forces_and_drives_do_work_worth_balancing() -> None:
    """Of the model above: the work is not small, and neither is what springs and gravity store."""
    result = lw.simulate(powered(), 1.0, 1e-3, progress=False)
    assert np.ptp(result.work) > 1.0
    assert np.ptp(result.potential_energy) > 1.0
    assert np.abs(result.energy_error).max() < 1e-8


CONSERVATIVE = {
    "pendulum": (mechanisms.pendulum, 5e-3),
    "rod_pendulum": (mechanisms.rod_pendulum, 5e-3),
    "chain": (lambda: mechanisms.chain(4, "spherical"), 2e-3),
    "heavy_top": (mechanisms.heavy_top, 4e-4),
    "torque_free_top": (mechanisms.torque_free_top, 5e-2),
    "spatial_slider_crank": (mechanisms.spatial_slider_crank, 1e-3),
    "net": (lambda: mechanisms.net(3), 2e-3),
}


@pytest.mark.parametrize("name", CONSERVATIVE)
def test_a_conservative_mechanism_keeps_its_energy(name: str) -> None:
    """To the order of RK4, or better; nothing does work."""
    make, step = CONSERVATIVE[name]
    coarse, fine = (lw.simulate(make(), 1.0, h, progress=False) for h in (step, step / 2))
    errors = [np.abs(result.energy - result.energy[0]).max() for result in (coarse, fine)]
    assert not np.any(fine.work)
    assert errors[1] <= max(errors[0] / 2**3.8, 1e-12 * np.ptp(fine.kinetic_energy) + 1e-12)


@examples(40)
@given(mechanism=random_mechanisms(most=8))
def test_energy_and_work_balance_in_random_mechanisms(mechanism: Mechanism) -> None:
    """Over 0.2 ms in steps so short that RK4 makes no error: dampers of light bodies are stiff."""
    result = lw.simulate(mechanism.model, 2e-4, 1e-6, progress=False)
    moved = np.abs(result.work).max() + np.ptp(result.kinetic_energy) + np.ptp(result.potential_energy)
    roundoff = 1e-13 * (np.abs(result.kinetic_energy).max() + np.abs(result.potential_energy).max())
    assert np.abs(result.energy_error).max() <= 1e-9 * moved + roundoff


# --- momentum of what nothing holds -------------------------------------------------------------------------


def momentum_rates(mechanism: Mechanism, v_dot: Floats) -> tuple[Floats, Floats, float, float]:
    """Of linear and angular momentum about the origin, inertial; and the sizes of what adds up to them."""
    linear, angular = [], []
    for body, rates in zip(mechanism.bodies, v_dot.reshape(-1, 6), strict=True):
        A, spin = lw.rotation.matrix(body.p), body.inertia @ body.omega
        force = body.mass * rates[:3]
        linear.append(force)
        angular += [np.cross(body.r, force), A @ (body.inertia @ rates[3:] + np.cross(body.omega, spin))]
    sizes = (np.abs(part).max() for part in (linear, angular))
    return sum(linear), sum(angular), *sizes


@examples(50)
@given(
    mechanism=random_mechanisms(
        floating=True, isolated=True, forces=("spring_damper", "rotational_spring_damper")
    )
)
def test_joints_and_springs_do_not_change_the_momentum_of_a_free_mechanism(mechanism: Mechanism) -> None:
    v_dot, _ = mechanism.dynamics().accelerations(0.0, mechanism.q, mechanism.v)
    linear, angular, force, torque = momentum_rates(mechanism, v_dot)
    assert np.abs(linear).max() <= 1e-11 * force
    assert np.abs(angular).max() <= 1e-11 * (torque + force)


def tumbling() -> lw.Model:
    """Three bodies in space with a hinge, a driven rod and a spring."""
    model = lw.Model(gravity=(0, 0, 0))
    a = model.body("a", mass=1.0, inertia=(0.1, 0.2, 0.25), velocity=(0.1, 0.2, 0.3), omega=(1, 2, 0))
    b = model.body(
        "b", mass=2.0, inertia=(0.3, 0.2, 0.4), position=(1, 0, 0), velocity=(0.1, 0.2, -1.7), omega=(1, 2, 0)
    )
    velocity = (0, 0.1 + 0.8 * np.sqrt(2), 0)  # lengthens the rod by 0.8 m/s
    c = model.body(
        "c", mass=1.5, inertia=(0.3, 0.3, 0.1), position=(1, 1, 0), velocity=velocity, omega=(0, 1, 3)
    )
    model.revolute(a, b, at=(0.5, 0, 0), axis=(1, 2, 0))
    length = harmonic(amplitude=0.2, frequency=4.0, offset=float(np.sqrt(0.5)))
    model.distance(b, c, at=((1.5, 0.5, 0), (1, 1, 0)), length=length)
    model.spring_damper(a, c, at=((0, 0.5, 0), (1, 1, 0.5)), stiffness=30.0, damping=1.0, free_length=0.5)
    return model


def momentum(model: lw.Model, result: lw.Result) -> tuple[Floats, Floats]:
    """Linear and angular (k, 3), the latter about the origin; inertial."""
    core = model.compiled()
    linear = core.mass[:, None] * result.velocity
    spin = np.einsum("nij,knj->kni", core.inertia, result.omega)
    turned = np.einsum("knij,knj->kni", lw.rotation.matrix(result.orientation), spin)
    return linear.sum(axis=1), (np.cross(result.position, linear) + turned).sum(axis=1)


def test_a_tumbling_mechanism_keeps_its_momentum() -> None:
    """Linear momentum to roundoff: it is linear in the state. Angular momentum to the order of RK4."""
    lost = []
    for step in (4e-3, 2e-3):
        model = tumbling()
        linear, angular = momentum(model, lw.simulate(model, 2.0, step, progress=False))
        assert np.abs(linear - linear[0]).max() <= 1e-13 * np.abs(linear).max()
        lost.append(np.abs(angular - angular[0]).max() / np.abs(angular).max())
    assert lost[1] <= lost[0] / 2**3.8
    assert lost[1] <= 1e-7
