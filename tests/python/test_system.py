"""System: a model with a method as the right-hand side of y' = f(t, y), for the integrators of others."""

from __future__ import annotations

from collections.abc import Callable

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from linkwork.arrays import Floats
from random_mechanisms import Equations, Mechanism, examples, mechanisms
from scipy.integrate import solve_ivp
from small_mechanisms import driven_pendulum


def runge_kutta_4(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    k1 = system.derivative(t, y)
    k2 = system.derivative(t + h / 2, y + h / 2 * k1)
    k3 = system.derivative(t + h / 2, y + h / 2 * k2)
    k4 = system.derivative(t + h, y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def test_dop853_and_the_own_rk4_find_the_same_motion_and_reactions_of_the_slider_crank() -> None:
    model, t_end = lw.mechanisms.spatial_slider_crank(), 1.0
    system = lw.System(model, stabilization="none")
    solution = solve_ivp(
        system.derivative, (0, t_end), system.initial_state(), "DOP853", rtol=1e-10, atol=1e-12
    )
    result = lw.simulate(model, t_end, 1e-4, "rk4", progress=False)
    q, v = np.split(solution.y[:, -1], [21])
    assert np.abs(result.q[-1].ravel() - q).max() <= 1e-8
    assert np.abs(result.v[-1].ravel() - v).max() <= 1e-7
    _, multipliers = system.accelerations(t_end, q, v)
    assert np.abs(result.multipliers[-1] - multipliers).max() <= 1e-7 * np.abs(multipliers).max()


@pytest.mark.parametrize("make", [lw.mechanisms.spatial_slider_crank, driven_pendulum])
@pytest.mark.parametrize("stabilization", ["none", "sampled_baumgarte"])
def test_a_python_rk4_takes_the_steps_of_the_compiled_one(
    make: Callable[[], lw.Model], stabilization: str
) -> None:
    own, compiled = (
        lw.simulate(make(), 0.2, 2e-3, method, stabilization=stabilization, progress=False)
        for method in (runge_kutta_4, "rk4")
    )
    # The correction of violations is held inside steps of the compiled one, and added beside those of others.
    apart = 1e5 if stabilization == "sampled_baumgarte" else 1.0
    assert np.abs(own.q - compiled.q).max() <= 1e-13 * apart
    assert np.abs(own.v - compiled.v).max() <= 1e-12 * apart * np.abs(compiled.v).max()
    assert np.abs(own.work - compiled.work).max() <= 1e-7 * np.ptp(
        own.kinetic_energy
    )  # by Simpson's rule there


def test_the_initial_state_is_that_of_the_model() -> None:
    model = lw.mechanisms.spatial_slider_crank()
    first = lw.simulate(model, 0.0, 1e-3, progress=False)
    state = lw.System(model).initial_state()
    assert np.array_equal(state, np.concatenate([first.q[0].ravel(), first.v[0].ravel()]))


@examples(30)
@given(mechanism=mechanisms())
def test_the_terms_of_the_equations_have_their_documented_shapes(mechanism: Mechanism) -> None:
    at = lw.System(mechanism.model).evaluate(0.0, mechanism.q, mechanism.v)
    n, m = mechanism.model.body_count, mechanism.model.row_count
    data, columns, starts = at.D
    assert at.M.shape == (n, 6, 6)
    assert {getattr(at, name).shape for name in ("Phi", "Phi_t", "Phi_dot", "gamma")} == {(m,)}
    assert at.g.shape == (6 * n,)
    assert starts.shape == (m + 1,)
    assert data.shape == columns.shape == (starts[-1],)
    assert m == 0 or (columns.min() >= 0 and columns.max() < 6 * n)
    terms = (at.M, data, at.Phi, at.Phi_t, at.Phi_dot, at.gamma, at.g, at.potential, at.force_power)
    assert all(np.isfinite(term).all() for term in terms)


# r' = r_dot,   p' = 1/2 (-e . w, e0 w + e x w),   v' the acceleration, for which
# Phi_ddot + 2 alpha Phi_dot + beta^2 Phi = 0 with continuous stabilization: the state violates the joints.
@examples(30)
@given(mechanism=mechanisms())
def test_the_derivative_moves_the_bodies_and_damps_violations(mechanism: Mechanism) -> None:
    alpha, beta = 3.0, 7.0
    q, v = mechanism.q + 1e-3 * np.sin(np.arange(len(mechanism.q))), 1.01 * mechanism.v + 0.01
    system = lw.System(mechanism.model, stabilization="baumgarte", baumgarte_alpha=alpha, baumgarte_beta=beta)
    q_dot, v_dot = np.split(system.derivative(0.0, np.concatenate([q, v])), [len(q)])
    p, p_dot, omega = q.reshape(-1, 7)[:, 3:], q_dot.reshape(-1, 7)[:, 3:], v.reshape(-1, 6)[:, 3:]
    assert np.array_equal(q_dot.reshape(-1, 7)[:, :3], v.reshape(-1, 6)[:, :3])
    expected = p[:, :1] * omega + np.cross(p[:, 1:], omega)
    assert 2 * p_dot[:, 1:] == pytest.approx(expected, abs=1e-12)
    assert 2 * p_dot[:, 0] == pytest.approx(-np.sum(p[:, 1:] * omega, axis=1), abs=1e-12)
    at = Equations.at(mechanism, 0.0, q, v)
    residual = at.D @ v_dot - at.gamma + 2 * alpha * at.Phi_dot + beta**2 * at.Phi
    assert np.abs(residual).max() <= 1e-9 * (np.abs(at.D) @ np.abs(v_dot) + np.abs(at.gamma)).max()


@pytest.mark.parametrize("make", [lw.mechanisms.bricard, driven_pendulum])
def test_residuals_are_those_of_the_evaluation_at_the_same_state(make: Callable[[], lw.Model]) -> None:
    dynamics, rng = lw.System(make()).compiled(), np.random.default_rng(3)
    q, v = np.split(lw.System(make()).initial_state(), [7 * make().body_count])
    q, v = q + 1e-3 * rng.normal(size=q.shape), v + rng.normal(size=v.shape)
    evaluation = dynamics.evaluate(0.2, q, v)
    Phi, Phi_dot, lengths, rates, _ = dynamics.residuals(0.2, q, v)
    assert (Phi == evaluation["Phi"]).all() and (Phi_dot == evaluation["Phi_dot"]).all()
    for scales in (lengths, rates):
        assert scales.shape == Phi.shape and scales.min() > 0


def coupled(factor: float) -> lw.Model:
    """Two sliders with two couplers, which say the same where the factor is 2."""
    model = lw.Model(name="coupled")
    for k in range(2):
        slider = model.body(f"slider {k}", mass=1.0 + k, inertia=(0.1, 0.1, 0.1), position=(0, k, 0))
        model.translational(model.ground, slider, at=(0, k, 0), axis=(1, 0, 0), name=f"rail {k}")
    for ratio in (2.0, factor):
        model.coupler([("rail 0", 1.0), ("rail 1", -ratio)])
    return model


def test_factors_of_couplers_are_part_of_the_geometry() -> None:
    twice, otherwise = lw.System(coupled(2.0)), lw.System(coupled(3.0))
    assert twice.of(coupled(3.0)).compiled().rank().redundant_rows == []
    assert len(otherwise.of(coupled(2.0)).compiled().rank().redundant_rows) == 1


def test_a_system_of_another_one_has_the_bits_of_one_made_by_itself() -> None:
    """With another mass, whose rank is known; of a mechanism with other redundant equations, whose is not."""
    first = lw.System(lw.mechanisms.four_bar(), deterministic=True)
    heavier = lw.mechanisms.four_bar().replaced("beam 0", mass=5.0)
    for model in (heavier, lw.mechanisms.four_bar(3), lw.mechanisms.bricard(), driven_pendulum()):
        made, alone = first.of(model), lw.System(model, deterministic=True)
        assert made.options == alone.options
        assert made.compiled().rank().redundant_rows == alone.compiled().rank().redundant_rows
        assert made.compiled().rank().unique == alone.compiled().rank().unique
        y = alone.initial_state()
        assert (made.derivative(0.0, y) == alone.derivative(0.0, y)).all()
        q, v = np.split(y, [7 * model.body_count])
        for one, other in zip(made.accelerations(0.0, q, v), alone.accelerations(0.0, q, v), strict=True):
            assert (one == other).all()
