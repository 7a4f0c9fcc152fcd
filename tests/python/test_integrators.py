"""Integrators are data, and tested as data: order conditions, exactness on polynomials, stability limits."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from linkwork.integrators import (
    METHODS,
    AdamsBashforth,
    AdamsBashforthMoulton,
    ButcherTableau,
    EmbeddedPair,
    HalfExplicit,
    Integrator,
)

RUNGE_KUTTA = [method for method in METHODS.values() if isinstance(method, ButcherTableau)]
PAIRS = [method for method in METHODS.values() if isinstance(method, EmbeddedPair)]
ADAMS = [method for method in METHODS.values() if isinstance(method, AdamsBashforth | AdamsBashforthMoulton)]

EPS = np.finfo(float).eps

#: A rooted tree: the trees that hang from its root, in a fixed order.
Tree = tuple["Tree", ...]


def trees(order: int) -> list[Tree]:
    """All rooted trees with so many vertices."""
    return sorted(forests(order - 1, order - 1))


def forests(vertices: int, largest: int) -> Iterator[Tree]:
    """Multisets of trees with so many vertices in all, none larger than `largest`."""
    if vertices == 0:
        yield ()
    for size in range(min(vertices, largest), 0, -1):
        for tree in trees(size):
            for rest in forests(vertices - size, size):
                if not rest or tree >= rest[0]:
                    yield (tree, *rest)


def size(tree: Tree) -> int:
    return 1 + sum(map(size, tree))


def density(tree: Tree) -> int:
    """gamma(t): the product of the sizes of all subtrees."""
    return size(tree) * math.prod(map(density, tree))


def stage_weights(tree: Tree, A: Floats) -> Floats:
    """Phi_i(t) at each stage: the product of A Phi(subtree) over the subtrees of the root."""
    return math.prod((A @ stage_weights(subtree, A) for subtree in tree), start=np.ones(len(A)))


def test_there_are_as_many_rooted_trees_as_there_should_be() -> None:
    assert [len(trees(order)) for order in range(1, 7)] == [1, 1, 2, 4, 9, 20]


@pytest.mark.parametrize("method", RUNGE_KUTTA, ids=lambda method: method.name)
def test_a_tableau_meets_the_order_conditions_of_its_order(method: ButcherTableau) -> None:
    conditions = [tree for order in range(1, method.order + 1) for tree in trees(order)]
    A, b = method.matrix, np.array(method.b)
    defects = {tree: b @ stage_weights(tree, A) - 1 / density(tree) for tree in conditions}
    rounding = {tree: 4 * EPS * (abs(b) @ stage_weights(tree, abs(A))) for tree in conditions}
    assert {tree: defect for tree, defect in defects.items() if abs(defect) > rounding[tree]} == {}


@pytest.mark.parametrize("method", RUNGE_KUTTA, ids=lambda method: method.name)
def test_a_tableau_claims_no_less_than_its_order(method: ButcherTableau) -> None:
    defects = [method.b @ stage_weights(t, method.matrix) - 1 / density(t) for t in trees(method.order + 1)]
    assert np.abs(defects).max() > 1e-6


@pytest.mark.parametrize("method", RUNGE_KUTTA, ids=lambda method: method.name)
def test_the_rows_of_a_tableau_add_up_to_its_nodes(method: ButcherTableau) -> None:
    rounding = 4 * EPS * np.maximum(np.abs(method.matrix).sum(axis=1), 1)
    assert (np.abs(method.matrix.sum(axis=1) - method.c) <= rounding).all()


def all_stages(pair: EmbeddedPair) -> Floats:
    """A of all stages: those of the method, the first of the next step, those of the interpolant."""
    s, extra = len(pair.b), len(pair.extra_c)
    A = np.zeros((s + 1 + extra, s + 1 + extra))
    A[:s, :s], A[s, :s], A[s + 1 :] = pair.matrix, pair.b, pair.extra_matrix
    return A


def order_of(weights: Floats, A: Floats, most: int) -> int:
    """Up to which all order conditions hold, to the digits that coefficients have."""
    weights = np.pad(weights, (0, len(A) - len(weights)))
    for order in range(1, most + 1):
        for tree in trees(order):
            rounding = 100 * EPS * (np.abs(weights) @ stage_weights(tree, np.abs(A)))
            if abs(weights @ stage_weights(tree, A) - 1 / density(tree)) > max(rounding, 1e-13):
                return order - 1
    return most


@pytest.mark.parametrize("pair", PAIRS, ids=lambda pair: pair.name)
def test_an_error_estimate_has_the_order_that_step_control_believes(pair: EmbeddedPair) -> None:
    """Two estimates combine as e^2 / sqrt(e^2 + 0.01 e_2^2) to the order 2 (p + 1) - (p_2 + 1)."""
    A, b = all_stages(pair), np.append(pair.b, 0)
    of_estimate = order_of(b - pair.error, A, pair.order + 1) + 1
    if pair.second_error:
        of_estimate = 2 * of_estimate - (order_of(b - pair.second_error, A, pair.order) + 1)
    assert of_estimate == pair.error_order + 1


@pytest.mark.parametrize("pair", PAIRS, ids=lambda pair: pair.name)
def test_an_interpolant_meets_the_order_conditions_inside_the_step(pair: EmbeddedPair) -> None:
    """sum_i b_i(theta) Phi_i(t) = theta^|t| / gamma(t) for all trees up to its order, and no further."""
    A, polynomial = all_stages(pair), np.array(pair.interpolant)
    powers = np.arange(1, polynomial.shape[1] + 1)
    for theta in (0.1, 0.5, 0.77):
        weights = polynomial @ theta**powers
        defects = [
            max(abs(weights @ stage_weights(tree, A) - theta**order / density(tree)) for tree in trees(order))
            for order in range(1, pair.dense_order + 2)
        ]
        assert max(defects[:-1]) < 1e-12
        assert defects[-1] > 1e-8


@pytest.mark.parametrize("pair", PAIRS, ids=lambda pair: pair.name)
def test_an_interpolant_is_smooth_across_steps(pair: EmbeddedPair) -> None:
    """It ends in the new state; its slopes at the ends are those of the first stage and of the next step."""
    polynomial, s = np.array(pair.interpolant), len(pair.b)
    first, last = np.eye(len(polynomial))[0], np.eye(len(polynomial))[s]
    np.testing.assert_allclose(polynomial.sum(axis=1)[:s], pair.b, atol=1e-12)
    np.testing.assert_allclose(polynomial[:, 0], first, atol=1e-12)
    np.testing.assert_allclose(polynomial @ np.arange(1, polynomial.shape[1] + 1), last, atol=1e-11)


def moments(coefficients: Floats, newest: int) -> list[float]:
    """Defects of int_0^1 s^k ds = sum_j c_j s_j^k with s_j = newest, newest - 1, ..., for k = 0, 1, ..."""
    places = newest - np.arange(len(coefficients))
    exact = [Fraction(c).limit_denominator(1440) for c in coefficients]
    sums = [sum(c * int(s) ** k for c, s in zip(exact, places, strict=True)) for k in range(len(exact) + 1)]
    return [float(total - Fraction(1, k + 1)) for k, total in enumerate(sums)]


@pytest.mark.parametrize("method", ADAMS, ids=lambda method: method.name)
def test_a_predictor_integrates_polynomials_below_its_order_exactly(method: AdamsBashforth) -> None:
    *zero, error = moments(np.array(method.predictor), newest=0)
    assert zero == [0.0] * method.order
    assert abs(error) > 1e-3


def test_the_corrector_of_abm4_integrates_cubics_exactly() -> None:
    method = METHODS["abm4"]
    assert isinstance(method, AdamsBashforthMoulton)
    *zero, error = moments(np.array(method.corrector), newest=1)
    assert zero == [0.0] * 4
    assert abs(error) > 1e-3


@pytest.mark.parametrize("method", ADAMS, ids=lambda method: method.name)
def test_an_adams_method_starts_with_a_method_of_its_order(method: AdamsBashforth) -> None:
    assert method.starter.order >= method.order


#: alpha h = beta h at which continuous Baumgarte stabilization becomes unstable (measured on a mechanism).
LIMITS = {
    "euler": 2.0, "semi_implicit_euler": 0.82, "heun": 2.0, "rk3": 2.51, "rk4": 2.785, "dopri5": 3.30,
    "tsit5": 3.50, "ab2": 1.0, "abm4": 1.28,
}  # fmt: skip


@pytest.mark.parametrize("name", [name for name, method in METHODS.items() if hasattr(method, "growth")])
def test_whatever_is_far_too_stiff_grows(name: str) -> None:
    """Undamped, up to a million radians a step."""
    for turned in np.logspace(1.5, 6, 400):
        assert 1.0 < METHODS[name].growth(0.0, turned) < np.inf


@pytest.mark.parametrize("name", LIMITS)
def test_the_growth_of_a_violation_passes_one_at_the_known_gain(name: str) -> None:
    below, above = (METHODS[name].growth(gain * LIMITS[name], gain * LIMITS[name]) for gain in (0.98, 1.02))
    assert below < 1 < above, (below, above)


#: All but the half-explicit ones, which have no gains.
WITH_GAINS = [method for method in METHODS.values() if not isinstance(method, HalfExplicit)]


def off_its_joint() -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    bob = model.body("bob", mass=1.0, inertia=(0.01, 0.01, 0.01), position=(1 + 1e-4, 0, 0))
    model.distance("ground", bob, at=((0, 0, 0), (1 + 1e-4, 0, 0)), length=1.0)
    return model


@pytest.mark.filterwarnings("ignore:.*initial poses do not satisfy")
@pytest.mark.parametrize("method", WITH_GAINS, ids=lambda method: method.name)
def test_under_held_gains_a_violation_decays_as_its_map_says(method: Integrator) -> None:
    gains = {"baumgarte_alpha": 40.0, "baumgarte_beta": 20.0}
    run = lw.simulate(
        off_its_joint(), 0.6, 0.01, method, assemble=False, record_every=1, on_inaccurate="pass", **gains
    )
    early, late = run.violation[[20, 60], 0]
    assert method.sampled_growth(0.4, 0.2) == pytest.approx((late / early) ** (1 / 40), rel=1e-3)


@pytest.mark.parametrize("method", WITH_GAINS, ids=lambda method: method.name)
def test_held_gains_with_which_a_violation_grows_are_refused(method: Integrator) -> None:
    for gain in (0.5, 0.9, 1.1, 1.9, 2.1, 1e5, 1e300):
        gains = {"baumgarte_alpha": gain / 1e-3, "baumgarte_beta": gain / 1e-3}
        if method.sampled_growth(min(gain, 1e6), min(gain, 1e6)) < 1:
            assert (
                len(lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, method, on_inaccurate="pass", **gains))
                == 11
            )
            continue
        message = f"{gain / 1e-3:g} 1/s are unstable with integrator '{method.name}' and step 0.001 s"
        with pytest.raises(lw.OptionError, match=re.escape(message)) as caught:
            lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, method, on_inaccurate="pass", **gains)
        assert caught.value.code == "unstable_gains"
        assert "leave both out" in str(caught.value)


def midpoint(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    return y + h * system.derivative(t + h / 2, y + h / 2 * system.derivative(t, y))


@pytest.mark.filterwarnings("ignore:.*initial poses do not satisfy")
def test_gains_with_integrators_of_ones_own_have_the_map_of_multistep_methods() -> None:
    gains = {"baumgarte_alpha": 40.0, "baumgarte_beta": 20.0}
    choices: dict[str, Any] = {"assemble": False, "record_every": 1, "on_inaccurate": "pass"}
    run = lw.simulate(off_its_joint(), 0.6, 0.01, midpoint, **choices, **gains)
    early, late = run.violation[[20, 60], 0]
    assert (late / early) ** (1 / 40) == pytest.approx(METHODS["ab2"].sampled_growth(0.4, 0.2), rel=1e-6)
    for gains in ({"baumgarte_alpha": 101.0, "baumgarte_beta": 20.0},
                  {"baumgarte_alpha": 40.0, "baumgarte_beta": 142.0}):  # fmt: skip
        with pytest.raises(
            lw.OptionError, match="unstable with integrator <function midpoint.*leave both out"
        ):
            lw.simulate(off_its_joint(), 0.6, 0.01, midpoint, **choices, **gains)


@pytest.mark.parametrize(
    ("name", "limit"),
    [("euler", 2.0), ("rk4", 1.0), ("ab4", 1.0), ("semi_implicit_euler", 2 * (math.sqrt(2) - 1))],
)
def test_the_growth_under_held_gains_passes_one_at_the_gain_that_their_map_says(
    name: str, limit: float
) -> None:
    """K has the eigenvalue -1 where 4 - 4 a + (1 - 2 s) b^2 = 0."""
    below, above = (METHODS[name].sampled_growth(gain, gain) for gain in (0.98 * limit, 1.02 * limit))
    assert below < 1 < above, (below, above)


def test_an_unknown_name_is_answered_with_the_nearest() -> None:
    with pytest.raises(lw.OptionError, match="'rk5'.*'rk4'"):
        lw.integrators.named("rk5")


def test_a_tableau_of_unequal_sizes_is_refused_by_name() -> None:
    with pytest.raises(lw.OptionError, match="'mine'"):
        ButcherTableau(name="mine", order=2, reference="", A=((), (1,)), b=(0.5, 0.5), c=(0,))


#: Changes of a field, and what the error says.
NO_DATA: list[tuple[str, dict[str, Any], str]] = [
    *(
        ("heun", {"order": it}, f"'heun': order {it!r} is not a whole")
        for it in (2.5, "2", None, 0, -3, True)
    ),
    ("heun", {"order": 10**12}, "order 1000000000000 is above 2"),
    ("heun", {"order": 3}, "order 3 is above 2, the highest"),
    ("heun", {"name": None}, "name None is no text"),
    ("heun", {"b": (0, 1j)}, "'heun': 1j in b is not a finite number"),
    ("heun", {"b": None}, "'heun': b None is no list"),
    ("heun", {"b": "01"}, "'heun': b '01' is no list"),
    ("heun", {"c": (0, math.inf)}, "inf in c"),
    ("heun", {"A": ((), ("x",))}, r"'x' in A\[1\] is not"),
    ("heun", {"A": ((), 1.0)}, r"A\[1\] 1.0 is no list"),
    ("bs32", {"interpolant": ((1, 2), (0,), (0,), (0,))}, "rows of interpolant have not all 2 numbers"),
    ("bs32", {"error": (0, 1j, 0, 0)}, "1j in error is"),
    ("bs32", {"second_error": None}, "second_error None is no list"),
    ("bs32", {"error_order": 1.5}, "error_order 1.5 is not"),
    ("bs32", {"dense_order": 4}, "dense_order 4 is above 3"),
    ("hem4", {"order": "2"}, "'hem4': order '2' is not"),
    ("hem4", {"A_bar": None}, "A_bar None is no list"),
    ("hem4", {"explicit_first_stage": 1}, "explicit_first_stage 1 is not True or False"),
    ("ab2", {"predictor": (1, "x")}, "'x' in predictor"),
    ("ab2", {"order": 3}, "order 3 is above 2"),
    ("ab2", {"starter": "heun"}, "starter 'heun' is no ButcherTableau"),
    ("abm4", {"corrector": ()}, "corrector is empty"),
]


@pytest.mark.parametrize(("name", "change", "message"), NO_DATA)
def test_what_is_no_data_of_a_method_is_refused_where_it_is_given(
    name: str, change: dict[str, Any], message: str
) -> None:
    with pytest.raises(lw.OptionError, match=message):
        dataclasses.replace(METHODS[name], **change)


def test_coefficients_may_be_fractions_and_arrays() -> None:
    half = Fraction(1, 2)
    exact = dataclasses.replace(METHODS["heun"], b=(half, half), c=np.array([0.0, 1.0]), A=[[], [1]])
    runs = [
        lw.simulate(lw.mechanisms.rod_pendulum(), 0.1, 1e-3, integrator=method) for method in ("heun", exact)
    ]
    assert np.array_equal(runs[0].q, runs[1].q)


@pytest.mark.parametrize(
    ("name", "change", "message"),
    [
        ("rk3", {"c": (0, 0.5, 0.9)}, r"c\[2\] is 0.9, but the numbers in row 2 of A add up to 1"),
        ("rk4", {"c": (0, 0, 0, 0)}, r"c\[1\] is 0, but .* row 1 of A add up to 0.5"),
        ("euler", {"c": (1.0,)}, r"c\[0\] is 1, but .* row 0 of A add up to 0"),
        ("dop853", {"extra_c": (0.2, 0.2, 0.2)}, r"extra_c\[0\] is 0.2, but .* row 0 of extra_A"),
    ],
)
def test_stages_are_at_the_times_of_their_states(name: str, change: dict[str, Any], message: str) -> None:
    """c_i = sum_j A_ij: else what is driven by time would be computed wrongly, with a good verdict."""
    with pytest.raises(lw.OptionError, match=message):
        dataclasses.replace(METHODS[name], **change)


@pytest.mark.parametrize(
    ("name", "change", "message"),
    [
        ("rk4", {"b": (1 / 6, 1 / 3, 1 / 3, 0.2)}, "have order 0, not 4.* 1 gives 1.03333333 instead"),
        ("rk4", {"b": (1 / 6, 1 / 3, 1 / 6, 1 / 3)}, "have order 1, not 4"),
        ("rk4", {"A": ((), (0.5,), (0.25, 0.25), (0, 0, 1))}, "have order 2, not 4"),
        ("tsit5", {"error": (1, 0, 0, 0, 0, 0, 0)}, "have error_order 0, not 4"),
        ("dopri5", {"dense_order": 5, "interpolant": [(*row, 0.0) for row in METHODS["dopri5"].interpolant]},
         "have dense_order 4, not 5"),
        ("hem4", {"A_bar": [*METHODS["hem4"].A_bar[:-1], [1, *[0] * (len(METHODS["hem4"].A) - 1)]]},
         "have order 1, not 4"),
        ("ab2", {"predictor": (1.0, 0.0)}, "have order of predictor 1, not 2"),
        ("abm4", {"corrector": (0.5, 0.5)}, "have order of corrector 2, not 4"),
    ],
)  # fmt: skip
def test_an_order_is_one_that_the_coefficients_have(name: str, change: dict[str, Any], message: str) -> None:
    """Errors are estimated by it."""
    with pytest.raises(lw.OptionError, match=message):
        dataclasses.replace(METHODS[name], **change)


def test_a_lower_order_may_be_declared() -> None:
    euler = [(1.0,), (0.0,), (0.0,), (0.0,)]
    dataclasses.replace(METHODS["bs32"], order=2, error_order=1, interpolant=euler, dense_order=1)


def test_a_method_is_the_one_that_was_checked_whatever_becomes_of_the_lists_it_was_given() -> None:
    A, b, c = [[], [0.5]], [0.0, 1.0], np.array([0.0, 0.5])
    midpoint = ButcherTableau("midpoint", 2, "", A=A, b=b, c=c)
    same = ButcherTableau("midpoint", 2, "", A=((), (0.5,)), b=(0.0, 1.0), c=(0.0, 0.5))
    predictor = [1.5, -0.5]
    ab2 = dataclasses.replace(METHODS["ab2"], predictor=predictor)
    A[1][0] = c[1] = predictor[0] = 1.0
    b[:] = [0.5, 0.5]
    assert midpoint == same and ab2 == METHODS["ab2"]
    assert hash(midpoint) == hash(same)


def test_a_tableau_of_the_users_own_runs() -> None:
    ralston = ButcherTableau(
        name="ralston", order=2, reference="Ralston (1962)", A=((), (2 / 3,)), b=(1 / 4, 3 / 4), c=(0, 2 / 3)
    )
    result = lw.simulate(lw.mechanisms.rod_pendulum(), t_end=0.1, step=1e-3, integrator=ralston)
    assert result.manifest["options"]["integrator"] == "ralston"
    assert np.abs(result.energy_error).max() < 1e-5


@pytest.mark.parametrize("integrator", ["rk4", "heun", "semi_implicit_euler", "dop853"])
@pytest.mark.parametrize("rest", [1e-3, 1e-6, 1e-9])
def test_a_short_last_step_makes_no_velocities_of_violations(integrator: str, rest: float) -> None:
    """It changes the state by its accelerations, and corrects its part of what a whole step would correct."""
    step, steps = 5e-3, 100
    whole, more = (
        lw.simulate(lw.mechanisms.chain(3), step * count, step, integrator, on_inaccurate="pass")
        for count in (steps, steps + rest)
    )
    if rest > 1e-9:  # of a step: not the same time
        assert more.t[-1] > whole.t[-1]
    after = whole.v[-1] + rest * step * whole.recorded("vdot", -1)
    np.testing.assert_allclose(more.v[-1], after, atol=0.1 * rest + 1e-12)
    truth = lw.simulate(lw.mechanisms.chain(3), float(more.t[-1]), integrator="dop853", rtol=1e-12)
    off = np.abs(more.position[-1] - truth.position[-1]).max() / 1.5
    off_in_velocity = np.abs(more.velocity[-1] - truth.velocity[-1]).max() / np.abs(truth.velocity).max()
    assert more.verdict is not None
    assert max(off, off_in_velocity) <= more.verdict.error + 1e-10  # of the reference
