"""Half-explicit Runge-Kutta methods: order conditions of index 2, constraints, redundancy, refusals."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.arrays import Floats
from linkwork.integrators import METHODS, HalfExplicit
from linkwork.mechanisms.bricard import AXES, POINTS
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes
from small_mechanisms import driven_pendulum, slider_crank, spherical_pendulum, two_body_loop

METHOD = [method for method in METHODS.values() if isinstance(method, HalfExplicit)]
MECHANISMS = [spherical_pendulum, slider_crank, two_body_loop, driven_pendulum]

# --- order conditions of y' = f(y, z), 0 = g(y): Hairer, Lubich and Roche (1989), LNM 1409, section 5
#
# A tree is ("y", sons) with sons of both kinds, or ("z", sons) with two sons or more, all of them y.

Tree = tuple[str, tuple[Any, ...]]


@cache
def y_trees(order: int) -> tuple[Tree, ...]:
    return tuple(("y", sons) for sons in forests(order - 1, order - 1, True))


@cache
def z_trees(order: int) -> tuple[Tree, ...]:
    return tuple(("z", sons) for sons in forests(order + 1, order, False) if len(sons) >= 2)


@cache
def forests(total: int, largest: int, with_z: bool) -> tuple[tuple[Tree, ...], ...]:
    """Multisets of trees whose orders add up to `total`, none of an order above `largest`."""
    kinds = (y_trees, z_trees) if with_z else (y_trees,)
    choices = [tree for make in kinds for order in range(1, min(total, largest) + 1) for tree in make(order)]

    def continued(first: int, left: int) -> list[tuple[Tree, ...]]:
        if left == 0:
            return [()]
        return [
            (choices[place], *rest)
            for place in range(first, len(choices))
            if order_of(choices[place]) <= left
            for rest in continued(place, left - order_of(choices[place]))
        ]

    return tuple(continued(0, total))


def order_of(tree: Tree) -> int:
    kind, sons = tree
    return sum(map(order_of, sons)) + (1 if kind == "y" else -1)


def density(tree: Tree) -> float:
    kind, sons = tree
    product = math.prod(map(density, sons))
    return order_of(tree) * product if kind == "y" else product / (order_of(tree) + 1)


def stage_weights(tree: Tree, method: HalfExplicit) -> Floats:
    """Of the derivatives of f (y) or of z at each stage, where A_bar z = product of A_bar sons."""
    A, A_bar = method.matrices
    kind, sons = tree
    weights = np.ones(len(A))
    for son in sons:
        of_son = stage_weights(son, method)
        weights = weights * (A_bar @ of_son if kind == "z" else A @ of_son if son[0] == "y" else of_son)
    if kind == "y":
        return weights
    first = int(method.explicit_first_stage)  # z is exact there
    return np.append(np.zeros(first), np.linalg.solve(A_bar[first:, first:], weights[first:]))


def defects(method: HalfExplicit, order: int) -> list[float]:
    b = method.matrices[1][-1]
    return [abs(b @ stage_weights(tree, method) - 1 / density(tree)) for tree in y_trees(order)]


def test_there_are_as_many_trees_as_there_should_be() -> None:
    assert [len(y_trees(order)) for order in range(1, 5)] == [1, 2, 8, 36]


def test_the_condition_of_order_three_that_index_two_adds_has_its_known_value() -> None:
    """sum b_i c_i omega_ij c_{j+1}^2 = 2/3."""
    tau: Tree = ("y", ())
    assert 1 / density(("y", (tau, ("z", (tau, tau))))) == pytest.approx(2 / 3)


@pytest.mark.parametrize("method", METHOD, ids=lambda method: method.name)
def test_a_half_explicit_method_meets_all_order_conditions_of_index_two(method: HalfExplicit) -> None:
    assert max(max(defects(method, order)) for order in range(1, method.order + 1)) < 1e-13


@pytest.mark.parametrize("method", METHOD, ids=lambda method: method.name)
def test_a_half_explicit_method_claims_no_less_than_its_order(method: HalfExplicit) -> None:
    assert max(defects(method, method.order + 1)) > 1e-3


# --- constraints and reactions ---


def largest(x: Floats) -> float:
    return float(np.abs(x).max())


def run(model: lw.Model, t_end: float, steps: int, method: str, **options: Any) -> lw.Result:
    every = max(1, steps // 16)
    return lw.simulate(model, t_end, t_end / steps, method, record_every=every, progress=False, **options)


@pytest.mark.parametrize("make", MECHANISMS)
@pytest.mark.parametrize("method", ["hem4", "phem56"])
def test_the_velocity_constraints_hold_without_any_stabilization(
    method: str, make: Callable[[], lw.Model]
) -> None:
    result = run(make(), 1.0, 512, method, stabilization="none")
    assert result.violation[:, 1].max() <= 1e-11 * largest(result.v)
    assert result.violation[:, 0].max() < 1e-5  # the drift that remains


@pytest.mark.parametrize("method", ["hem4", "phem56"])
def test_by_default_positions_are_projected(method: str) -> None:
    result = run(slider_crank(), 1.0, 64, method)
    assert result.manifest["options"]["stabilization"] == "projection"
    assert result.violation[:, :2].max() <= 1e-13 * max(1.0, largest(result.v))


@pytest.mark.parametrize("method", ["hem4", "phem56"])
def test_the_work_of_a_driven_joint_balances_the_energy(method: str) -> None:
    result = run(driven_pendulum(), 2.0, 512, method)
    assert largest(result.work) > 1.0
    assert largest(result.energy_error) <= 1e-8


def test_a_body_without_joints_moves_as_by_dopri5() -> None:
    """Without constraints PHEM56 is the method of Dormand and Prince."""
    half_explicit, explicit = (
        run(mechanisms.torque_free_top(), 1.0, 64, method, stabilization="none")
        for method in ("phem56", "dopri5")
    )
    np.testing.assert_allclose(half_explicit.q, explicit.q, atol=1e-14)


# --- redundant constraints ---


def bricard(independent: bool) -> lw.Model:
    """Bricard's mechanism; `independent`: without the one equation that repeats the others."""
    model = lw.Model(gravity=(0, -9.81, 0))
    links = [model.ground]
    for k, (start, end) in enumerate(pairwise(POINTS), 1):
        along = from_axes(x=end - start, y=AXES[k - 1])
        links.append(
            model.body(f"rod {k}", mass=1.0, inertia=square_rod(1.0, 1.0, 0.1), position=(start + end) / 2,
                       orientation=along)
        )  # fmt: skip
    for k, (point, axis) in enumerate(zip(POINTS, AXES, strict=True)):
        a, b = links[k], links[(k + 1) % 6]
        if independent and k == 5:
            model.universal(a, b, at=point, axes=(axis, np.roll(axis, 1)))
        else:
            model.revolute(a, b, at=point, axis=axis)
    return model


def observed_order(make: Callable[[], lw.Model], method: str, steps: int) -> float:
    exact = run(make(), 0.5, 4096, "tsit5")
    coarse, fine = (largest(run(make(), 0.5, n, method).q - exact.q) for n in (steps, 2 * steps))
    return float(np.log2(coarse / fine))


@pytest.mark.parametrize("method", ["hem4", "phem56"])
@pytest.mark.parametrize("independent", [True, False])
def test_the_order_is_kept_on_bricards_mechanism(independent: bool, method: str) -> None:
    """Also where one equation repeats the others, and contradicts them off the constraints."""
    order = METHODS[method].order
    assert observed_order(lambda: bricard(independent), method, 32) == pytest.approx(order, abs=0.2)


def test_the_order_is_kept_on_a_four_bar_with_redundant_equations() -> None:
    exact = run(mechanisms.four_bar(), 0.5, 4096, "tsit5")
    for method, order in (("hem4", 4), ("phem56", 5)):
        coarse, fine = (largest(run(mechanisms.four_bar(), 0.5, n, method).q - exact.q) for n in (32, 64))
        assert np.log2(coarse / fine) == pytest.approx(order, abs=0.2)


# --- what is refused ---


@pytest.mark.parametrize("method", ["hem4", "phem56"])
@pytest.mark.parametrize("stabilization", ["baumgarte", "sampled_baumgarte"])
def test_a_stabilization_of_accelerations_is_refused(stabilization: str, method: str) -> None:
    with pytest.raises(lw.OptionError, match=f"'{method}'.*'{stabilization}'.*choose 'projection'"):
        run(slider_crank(), 1.0, 64, method, stabilization=stabilization)


def test_a_step_in_which_bodies_turn_too_far_is_refused_with_the_reason() -> None:
    with pytest.raises(lw.NotConvergedError, match="too far.*smaller step"):
        run(slider_crank(speed=200.0), 1.0, 16, "hem4")


def test_a_table_of_unequal_sizes_is_refused_by_name() -> None:
    with pytest.raises(lw.OptionError, match="'mine'"):
        HalfExplicit(name="mine", order=1, reference="", A=((),), A_bar=((), (1,)))
