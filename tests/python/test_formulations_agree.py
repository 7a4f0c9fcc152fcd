"""All ways of solving M v_dot - D^T lambda = g, D v_dot = gamma give the same answer, on random mechanisms.

The reference is a dense solution of the KKT system, refined in extended precision. Accelerations are measured
against those of the mechanism and of its bodies without joints, M^-1 g: some mechanisms cannot move.
"""

from __future__ import annotations

import contextlib

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import _core
from linkwork.arrays import Floats
from random_mechanisms import Equations, Mechanism, examples, make, mean_delassus_diagonal, mechanisms

#: (matrix, linear solver): "normal" is M + D^T a D of the augmented Lagrangian.
CHOICES = [
    (form, solver.name)
    for solver in _core.linear_solvers()
    if solver.available
    for form in solver.matrix_forms
]


def options(form: str, solver: str) -> dict[str, str]:
    if form == "normal":
        return {"formulation": "augmented_lagrangian", "linear_solver": solver}
    return {"formulation": "standard", "matrix_form": form, "linear_solver": solver}


def largest(x: Floats) -> float:
    return float(np.abs(x).max(initial=0.0))


def solve(mechanism: Mechanism, **options: object) -> tuple[Floats, Floats]:
    return mechanism.dynamics(**options).accelerations(0.0, mechanism.q, mechanism.v)


@pytest.mark.parametrize(("form", "solver"), CHOICES)
@examples(60, shared=1)
@given(mechanism=mechanisms())
def test_every_solver_finds_the_accelerations_and_joint_forces(
    mechanism: Mechanism, form: str, solver: str
) -> None:
    at = Equations.of(mechanism)
    v_dot, multipliers = solve(mechanism, **options(form, solver))
    exact_v_dot, exact_multipliers = at.solution
    force, exact_force = at.D.T @ multipliers, at.D.T @ exact_multipliers
    error = largest(v_dot - exact_v_dot) / (largest(exact_v_dot) + largest(at.free_v_dot))
    force_error = largest(force - exact_force) / (largest(exact_force) or 1.0)
    assert error <= 1e-9
    assert force_error <= 1e-9


@pytest.mark.parametrize(("form", "solver"), CHOICES)
@examples(60, shared=2)
@given(mechanism=mechanisms())
def test_every_solution_satisfies_its_equations(mechanism: Mechanism, form: str, solver: str) -> None:
    at = Equations.of(mechanism)
    v_dot, multipliers = solve(mechanism, **options(form, solver))
    inertia, force = at.M @ v_dot, at.D.T @ multipliers
    imbalance = largest(inertia - force - at.g) / max(largest(inertia), largest(force), largest(at.g))
    violation = largest(at.D @ v_dot - at.gamma)
    scale = largest(np.abs(at.D) @ np.abs(v_dot)) + largest(at.D @ at.free_v_dot) + largest(at.gamma)
    assert imbalance <= 1e-12
    assert violation <= 1e-9 * scale


# The penalty method solves (S + a^-1) lambda = gamma - D M^-1 g instead of S lambda = ..., S = D M^-1 D^T.
# With sigma the eigenvalues of a^1/2 S a^1/2, v_dot is off by M^-1 D^T (lambda_penalty - lambda), in which
# each part of M^-1 D^T lambda shrinks to 1 / (1 + sigma):
#   ||v_dot_penalty - v_dot||_M <= ||M^-1 D^T lambda||_M / (1 + sigma_min)
@pytest.mark.parametrize("solver", [solver for form, solver in CHOICES if form == "normal"])
@pytest.mark.parametrize("penalty", ({"penalty": 1e5}, {"penalty_scale": 1e4}), ids=("uniform", "scaled"))
@examples(30, shared=3)
@given(mechanism=mechanisms())
def test_penalty_is_off_by_what_its_smallest_eigenvalue_predicts(
    mechanism: Mechanism, solver: str, penalty: dict[str, float]
) -> None:
    at = Equations.of(mechanism)
    exact_v_dot, multipliers = at.solution
    S = at.D @ np.linalg.solve(at.M, at.D.T)
    scaled = penalty.get("penalty_scale", 1.0) / mean_delassus_diagonal(mechanism, at)
    a = np.full(len(S), penalty["penalty"]) if "penalty" in penalty else scaled
    sigma = np.linalg.eigvalsh(np.sqrt(a)[:, None] * S * np.sqrt(a))
    predicted = -np.linalg.solve(at.M, at.D.T @ np.linalg.solve(S + np.diag(1 / a), multipliers / a))

    v_dot, _ = solve(mechanism, formulation="penalty", linear_solver=solver, **penalty)
    size = energy_norm(at, np.linalg.solve(at.M, at.D.T @ multipliers))
    roundoff = 1e-14 * (1 + sigma[-1]) * (size + energy_norm(at, exact_v_dot))
    error, unpredicted = (energy_norm(at, x) for x in (v_dot - exact_v_dot, v_dot - exact_v_dot - predicted))
    assert error <= size / (1 + sigma[0]) + roundoff
    assert unpredicted <= roundoff


def energy_norm(at: Equations, x: Floats) -> float:
    return float(np.sqrt(x @ at.M @ x))


def test_slow_convergence_of_the_augmented_lagrangian_is_not_taken_for_its_end() -> None:
    """Its error is halved in each iteration here, also where it is small already."""
    mechanism = make(
        980,
        joints=["universal", "distance", "revolute", "distance", "universal", "translational", "fixed",
                "fixed", "translational", "cylindrical", "distance", "fixed", "distance", "universal",
                "cylindrical"],
        loops=["universal", "translational", "spherical"],
        forces=["applied", "applied", "spring_damper", "applied"],
        floating=True,
    )  # fmt: skip
    at = Equations.of(mechanism)
    v_dot, multipliers = solve(mechanism, formulation="augmented_lagrangian")
    exact_v_dot, exact_multipliers = at.solution
    force, exact_force = at.D.T @ multipliers, at.D.T @ exact_multipliers
    error = largest(v_dot - exact_v_dot) / largest(exact_v_dot)
    force_error = largest(force - exact_force) / largest(exact_force)
    assert error <= 1e-9
    assert force_error <= 1e-9


def with_masses_apart(mechanism: Mechanism, decades: float, seed: int) -> Mechanism:
    factors = 10 ** np.random.default_rng(seed).uniform(-decades / 2, decades / 2, len(mechanism.bodies))
    return mechanism.with_masses(tuple(factors))


@pytest.mark.parametrize(("form", "solver"), [it for it in CHOICES if it[0] != "normal"])
@pytest.mark.parametrize("decades", [6, 9])
@examples(10)
@given(mechanism=mechanisms(most=12), seed=st.integers(0, 2**32 - 1))
def test_every_solver_of_standard_takes_masses_that_are_far_apart(
    mechanism: Mechanism, decades: int, seed: int, form: str, solver: str
) -> None:
    uneven = with_masses_apart(mechanism, decades, seed)
    at = Equations.of(uneven)
    v_dot, _ = solve(uneven, **options(form, solver))
    exact_v_dot, _ = at.solution
    error = largest(v_dot - exact_v_dot) / (largest(exact_v_dot) + largest(at.free_v_dot))
    assert error <= 1e-9


@pytest.mark.parametrize("decades", [4, 8, 12])
@examples(20)
@given(mechanism=mechanisms(most=12), seed=st.integers(0, 2**32 - 1))
def test_the_augmented_lagrangian_takes_bodies_of_any_masses(
    mechanism: Mechanism, decades: int, seed: int
) -> None:
    """Between very heavy bodies that a very light one connects, a penalty changes hardly anything."""
    uneven = with_masses_apart(mechanism, decades, seed)
    at = Equations.of(uneven)
    v_dot, multipliers = solve(uneven, formulation="augmented_lagrangian")
    exact_v_dot, exact_multipliers = solve(uneven)
    force, exact_force = at.D.T @ multipliers, at.D.T @ exact_multipliers
    roundoff = 1e-13 * largest(at.free_v_dot)
    assert largest(v_dot - exact_v_dot) <= 1e-7 * largest(exact_v_dot) + roundoff
    assert largest(force - exact_force) <= 1e-7 * largest(exact_force)


@examples(20)
@given(mechanism=mechanisms())
def test_random_mechanisms_are_consistent(mechanism: Mechanism) -> None:
    """Of the strategy itself: the initial state satisfies the joints, driven ones included."""
    at = Equations.of(mechanism)
    speed = 1 + largest(mechanism.v)
    assert largest(at.Phi) <= 1e-13 * (1 + largest(mechanism.q))
    assert largest(at.Phi_dot) <= 1e-12 * speed
    assert largest(at.D @ mechanism.v + at.Phi_t) <= 1e-12 * speed


@pytest.mark.parametrize("penalty", [1e-300, 1e-200, 1e-150, 1e-30, 1e-8, 1.0, 1e30, 1e200, 1e300])
@pytest.mark.parametrize("name", ["spatial_slider_crank", "chain", "bricard"])
def test_the_augmented_lagrangian_is_right_with_any_penalty_or_says_that_it_is_not(
    name: str, penalty: float
) -> None:
    model = getattr(lw.mechanisms, name)()
    n = model.body_count
    y = lw.System(model).initial_state()
    right, *_ = lw.System(model).accelerations(0.0, y[: 7 * n], y[7 * n :])
    system = lw.System(model, formulation="augmented_lagrangian", penalty=penalty)
    may_fail = penalty < 1e30 and name != "chain"
    with contextlib.suppress(*[lw.NotConvergedError] * may_fail):
        found, *_ = system.accelerations(0.0, y[: 7 * n], y[7 * n :])
        assert np.abs(found - right).max() < 1e-8 * np.abs(right).max()
