"""Energy, work and momentum: what every mechanism must balance."""

from __future__ import annotations

from functools import cache
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from linkwork import functions, mechanisms
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


def _switched(how: str) -> lw.Model:
    """A body on a rail at 1.3 m; at JUMP what holds it becomes stiffer, or free elsewhere."""
    model = lw.Model(gravity=(0, 0, 0))
    velocity = (0.9, 0, 0) if how == "bushing" else (0, 0, 0)
    body = model.body("b", mass=1.0, inertia=(0.1, 0.2, 0.3), position=(1.3, 0, 0), velocity=velocity)
    model.translational("ground", body, at=(1.3, 0, 0), axis=(1, 0, 0), name="rail")
    axis: dict[str, Any] = {"at": (1.3, 0, 0), "axis": (1, 0, 0)}
    ends = ((0, 0, 0), (1.3, 0, 0))

    def step(before: float, after: float) -> functions.TimeFunction:
        return functions.piecewise_polynomial([-1, JUMP, 9], [[before], [after]])

    if how == "stiffness":
        model.spring_damper("ground", body, at=ends, stiffness=step(10, 50), free_length=1.0)
    elif how == "free length":
        model.spring_damper("ground", body, at=ends, stiffness=10, free_length=step(1, 0.5))
    elif how == "free displacement":
        model.translational_spring_damper("ground", body, **axis, stiffness=10,
                                          free_displacement=step(-0.3, -0.8))  # fmt: skip
    elif how == "bushing":
        model.bushing("ground", body, at=(1.0, 0, 0), stiffness=(step(10, 50), 0, 0))
    else:
        model.translational_stop("ground", body, **axis, lower=-9, upper=-0.3, stiffness=step(10, 50))
    return model


JUMP = 0.05  # [s]
#: Over it, up to it, and as it asks for.
STEPS: tuple[dict[str, float], ...] = ({"step": 0.7e-3}, {"step": 1e-3}, {"rtol": 1e-8})


def _stored_more(how: str) -> float:
    """By the jump [J], from the motion before it: a shift of 0.3 cos w t, or 0.9 / w sin w t."""
    w = np.sqrt(10)
    shift = 0.9 / w * np.sin(w * JUMP) if how == "bushing" else 0.3 * np.cos(w * JUMP)
    if how.startswith("free"):
        return float(0.5 * 10 * ((shift + 0.5) ** 2 - shift**2))
    return float(0.5 * 40 * shift**2)


@pytest.mark.parametrize("how", ["stiffness", "free length", "free displacement", "bushing", "stop"])
def test_what_makes_a_spring_stiffer_at_once_does_its_work(how: str) -> None:
    result = lw.simulate(_switched(how), t_end=0.3, rtol=1e-10)
    assert abs(result.energy_error).max() < 1e-8
    assert result.work[-1] == pytest.approx(_stored_more(how), rel=1e-8)
    assert result.verdict is not None and result.verdict.level == "good"


@pytest.mark.parametrize(("step", "integrator"), [(1e-3, "rk4"), (1e-3, "abm4"), (0.7e-3, "rk4")])
def test_fixed_steps_that_end_at_a_jump_of_stiffness_or_go_over_it_know_its_work(
    step: float, integrator: str
) -> None:
    model = _switched("stiffness")
    run: dict[str, Any] = {"integrator": integrator, "on_inaccurate": "pass"}  # it sees a jump of the force
    result = lw.simulate(model, t_end=0.3, step=step, **run)
    assert result.work[-1] == pytest.approx(_stored_more("stiffness"), rel=1e-5)
    half = lw.simulate(model, t_end=0.3, step=step / 2, **run)
    assert abs(result.energy_error).max() < 1e-2  # of the step over it, of first order
    assert abs(half.energy_error).max() < 0.75 * abs(result.energy_error).max()


@pytest.mark.parametrize("steps", STEPS)
def test_a_jump_of_stiffness_does_the_same_work_in_lanes(steps: dict[str, float]) -> None:
    model = _switched("stiffness")
    run: dict[str, Any] = {"record_every": 1, "on_inaccurate": "pass", **steps}
    found = lw.simulate_many(model, {"b.mass": [1.0, 2.0]}, 0.3, **run)
    assert not any(found.alone)
    alone = lw.simulate(model, t_end=0.3, deterministic=True, **run)
    member = found.member(0)
    np.testing.assert_array_equal(member.work, alone.work)
    assert member.work[-1] == pytest.approx(_stored_more("stiffness"), rel=1e-5)
    np.testing.assert_array_equal(member.q, alone.q)


@pytest.mark.parametrize("end", [JUMP, 0.03, 0.1])
@pytest.mark.parametrize("steps", STEPS)
def test_a_run_that_goes_on_at_a_jump_of_stiffness_knows_its_work(
    steps: dict[str, float], end: float
) -> None:
    model = _switched("stiffness")
    run: dict[str, Any] = {"on_inaccurate": "pass", **steps}
    first = lw.simulate(model, t_end=end, **run)
    rest = lw.simulate(model, t_end=0.3, start=first.snapshot(), **run)
    whole = lw.simulate(model, t_end=0.3, **run)
    assert rest.work[-1] == whole.work[-1]
    assert rest.work[-1] == pytest.approx(_stored_more("stiffness"), rel=1e-5)
    assert rest.t[0] == first.t[-1]
    assert abs(rest.energy_error).max() < max(1e-7, 1.1 * abs(whole.energy_error).max())


@pytest.mark.parametrize("off", [-1e-15, 0.0, 1e-15, 1e-13])
@pytest.mark.parametrize("terminal", [False, True])
def test_an_event_at_a_jump_of_stiffness_does_not_do_its_work_again(off: float, terminal: bool) -> None:
    event = lw.Event(lambda t, _: t - JUMP - off, change=None if terminal else lambda t, state: None,
                     terminal=terminal)  # fmt: skip
    result = lw.simulate(_switched("stiffness"), t_end=0.3, rtol=1e-10, events=event)
    assert len(result.events) == 1 and result.t[-1] == pytest.approx(JUMP if terminal else 0.3)
    assert result.work[-1] == pytest.approx(_stored_more("stiffness"), rel=1e-8)
    assert abs(result.energy_error).max() < 1e-8
    assert result.statistics["breaks"] == 1


def test_a_stiffness_that_jumps_does_work_in_a_driven_motion() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("b", mass=1.0, inertia=(0.1, 0.2, 0.3), position=(1.3, 0, 0))
    model.translational("ground", body, at=(1.3, 0, 0), axis=(1, 0, 0), name="rail")
    model.drive("rail", position=functions.cycloidal(0.5, 1.0))
    model.spring_damper("ground", body, at=((0, 0, 0), (1.3, 0, 0)), free_length=1.0,
                        stiffness=functions.piecewise_polynomial([0, 0.5, 9], [[10], [50]]))  # fmt: skip
    for times in (np.linspace(0, 1, 101), np.linspace(0, 0.5, 51), np.linspace(0, 1, 100)):
        result = lw.kinematics(model, times)
        assert abs(result.energy_error).max() < 1e-5
    assert result.work[-1] == pytest.approx(0.5 * 50 * 0.8**2 - 0.5 * 10 * 0.3**2, rel=1e-5)
