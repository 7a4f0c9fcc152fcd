"""Stabilization by projection: constraints to roundoff after every step, orders kept."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.integrators import METHODS
from small_mechanisms import driven_pendulum, slider_crank, spherical_pendulum

VARIANTS = {"projection": (0, 1), "position_projection": (0,), "velocity_projection": (1,)}


def run(model: lw.Model, t_end: float, steps: int, method: str, **options: Any) -> lw.Result:
    every = max(1, steps // 16)
    return lw.simulate(model, t_end, t_end / steps, method, record_every=every, progress=False,
                       on_inaccurate="pass", **options)  # fmt: skip


@pytest.mark.parametrize("method", ["rk4", "abm4", "semi_implicit_euler", "heun"])
@pytest.mark.parametrize("variant", VARIANTS)
def test_what_is_projected_is_annulled_after_every_step(variant: str, method: str) -> None:
    bare = run(slider_crank(), 1.0, 64, method, stabilization="none")
    result = run(slider_crank(), 1.0, 64, method, stabilization=variant)
    for level in VARIANTS[variant]:
        assert result.violation[:, level].max() < 1e-13 * max(1.0, float(np.abs(result.v).max()))
        assert bare.violation[1:, level].min() > 1e-13


@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian", "penalty"])
def test_every_formulation_projects(formulation: str) -> None:
    result = run(spherical_pendulum(), 1.0, 64, "rk4", stabilization="projection", formulation=formulation)
    assert result.violation[:, :2].max() < 1e-12


def test_redundant_equations_are_projected_by_the_augmented_lagrangian() -> None:
    result = run(mechanisms.bricard(), 1.0, 64, "rk4", stabilization="projection",
                 formulation="augmented_lagrangian")  # fmt: skip
    assert result.violation[:, :2].max() < 1e-12
    assert np.abs(result.energy_error).max() < 1e-5


@pytest.mark.parametrize("make", [spherical_pendulum, slider_crank, driven_pendulum])
@pytest.mark.parametrize("method", ["heun", "rk4", "dopri5", "tsit5"])
def test_the_order_is_kept(method: str, make: Any) -> None:
    order = METHODS[method].order
    steps = 128 if order > 2 else 512
    exact = run(make(), 1.0, 4096, "tsit5", stabilization="projection")
    errors = [
        float(np.abs(run(make(), 1.0, n, method, stabilization="projection").q - exact.q).max())
        for n in (steps, 2 * steps)
    ]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.3)


def test_adaptive_steps_project_too() -> None:
    result = lw.simulate(
        spherical_pendulum(), 5.0, rtol=1e-6, record_every=1, stabilization="projection", progress=False
    )
    assert result.violation[:, :2].max() < 1e-13


def test_an_integrator_of_the_users_own_is_projected_too() -> None:
    def euler(system: lw.System, t: float, y: Any, h: float) -> Any:
        return y + h * system.derivative(t, y)

    result = lw.simulate(
        spherical_pendulum(), 0.5, 1e-3, euler, record_every=1, stabilization="projection", progress=False,
        on_inaccurate="pass",
    )  # fmt: skip
    assert result.violation[:, :2].max() < 1e-13


def test_the_change_is_the_least_in_the_metric_of_the_masses() -> None:
    """Two free masses on a rod that is d too long: they share d in the inverse ratio of their masses."""
    d, step = 5e-10, 1e-9  # as little as passes for rounding before the first step
    model = lw.Model(gravity=(0, 0, 0))
    a = model.body("a", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 0))
    b = model.body("b", mass=3.0, inertia=(1, 1, 1), position=(1 + d, 0, 0))
    model.distance(a, b, at=((0, 0, 0), (1 + d, 0, 0)), length=1.0)
    result = lw.simulate(model, step, step, "rk4", stabilization="projection", progress=False)
    moved = result.position[-1, :, 0] - result.position[0, :, 0]
    np.testing.assert_allclose(moved, [0.75 * d, -0.25 * d], rtol=1e-5)


def test_gains_of_baumgarte_are_refused() -> None:
    with pytest.raises(lw.OptionError, match="no meaning for stabilization 'projection'"):
        run(
            slider_crank(),
            1.0,
            64,
            "rk4",
            stabilization="projection",
            baumgarte_alpha=1.0,
            baumgarte_beta=1.0,
        )


@pytest.mark.filterwarnings("ignore:initial")
def test_a_state_that_is_too_far_from_the_constraints_is_refused_by_joint() -> None:
    """A rod between points that are farther apart than it could ever be."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=(1, 1, 1), position=(0.5, 0, 0))
    model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.distance(model.ground, body, at=((5, 0, 0), (1, 0, 0)), length=1.0, name="short")
    with pytest.raises((lw.NotConvergedError, lw.SingularSystemError), match="short|pin"):
        run(model, 1.0, 8, "rk4", stabilization="projection", assemble=False)
