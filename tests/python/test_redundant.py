"""Random mechanisms with planted redundancy: rank, accelerations and multipliers are those of dense SVDs.

Accelerations follow from the constraints however many equations repeat them. The multipliers are those of
least norm sum_i w_i lambda_i^2, with w_i the mean of diag(D M^-1 D^T) over the joint's translations or over
its rotations.
"""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from linkwork import _core
from linkwork.arrays import Floats
from random_mechanisms import (
    JOINTS,
    ZERO,
    Equations,
    Mechanism,
    examples,
    mean_delassus_diagonal,
    redundant_mechanisms,
)

#: (matrix, linear solver) of the standard formulation that take redundant equations.
CHOICES = [("kkt", "block")] + [
    ("schur", solver.name)
    for solver in _core.linear_solvers()
    if solver.available and "schur" in solver.matrix_forms
]


def rank_of(D: Floats) -> int:
    sigma = np.linalg.svd(D, compute_uv=False)
    return int(np.sum(sigma > ZERO * sigma[0]))


def expected_accelerations(at: Equations) -> Floats:
    """argmin |v_dot - M^-1 g| in the metric M subject to D v_dot = gamma."""
    root = np.linalg.inv(np.linalg.cholesky(at.M)).T  # M^-1 = root root^T
    lengths = np.linalg.norm(at.D @ root, axis=1)
    right = (at.gamma - at.D @ at.free_v_dot) / lengths
    return at.free_v_dot + root @ (np.linalg.pinv(at.scaled_D, rcond=ZERO) @ right)


def expected_multipliers(mechanism: Mechanism, at: Equations, v_dot: Floats) -> Floats:
    root = np.sqrt(mean_delassus_diagonal(mechanism, at))
    metric = np.linalg.inv(np.linalg.cholesky(at.M))  # forces in the metric M^-1
    force = metric @ (at.M @ v_dot - at.g)
    return np.linalg.pinv(metric @ at.D.T / root, rcond=ZERO) @ force / root


def relative(found: Floats, expected: Floats, beside: Floats) -> float:
    return float(np.abs(found - expected).max() / (np.abs(expected).max() + np.abs(beside).max()))


@examples(60)
@given(mechanism=redundant_mechanisms())
def test_the_rank_is_that_of_the_singular_values(mechanism: Mechanism) -> None:
    D = Equations.of(mechanism).scaled_D
    report = mechanism.dynamics().rank()
    assert (report.rank, report.degrees_of_freedom) == (rank_of(D), D.shape[1] - rank_of(D))
    assert report.singular_rows == []
    assert len(report.redundant_rows) == len(D) - report.rank
    assert rank_of(np.delete(D, report.redundant_rows, axis=0)) == report.rank


@examples(60)
@given(mechanism=redundant_mechanisms())
def test_reactions_are_unique_where_no_vector_of_the_kernel_reaches(mechanism: Mechanism) -> None:
    D = Equations.of(mechanism).scaled_D
    kernel = np.linalg.svd(D.T)[2][rank_of(D) :]
    size = np.linalg.norm(kernel, axis=0)
    ends = np.cumsum([len(JOINTS[joint.kind].equations) for joint in mechanism.joints])
    largest = np.array([rows.max() for rows in np.split(size, ends[:-1])])
    assert mechanism.dynamics().rank().unique == list(largest < 1e-6)


@pytest.mark.parametrize(("form", "solver"), CHOICES)
@examples(25)
@given(mechanism=redundant_mechanisms())
def test_the_standard_formulation_finds_the_accelerations_and_the_smallest_multipliers(
    mechanism: Mechanism, form: str, solver: str
) -> None:
    check(mechanism, formulation="standard", matrix_form=form, linear_solver=solver)


@examples(40)
@given(mechanism=redundant_mechanisms())
def test_so_does_the_augmented_lagrangian(mechanism: Mechanism) -> None:
    check(mechanism, formulation="augmented_lagrangian")


def check(mechanism: Mechanism, **options: str) -> None:
    at = Equations.of(mechanism)
    expected = expected_accelerations(at)
    v_dot, multipliers = mechanism.dynamics(**options).accelerations(0.0, mechanism.q, mechanism.v)
    assert relative(v_dot, expected, at.free_v_dot) <= 1e-9
    least = expected_multipliers(mechanism, at, expected)
    root = np.sqrt(mean_delassus_diagonal(mechanism, at))
    assert relative(root * multipliers, root * least, np.zeros(1)) <= 1e-5  # roundoff / s^2 of the kept rows


@pytest.mark.parametrize("n", (1, 2, 5))
def test_four_bars_in_space_have_the_rank_of_their_singular_values(n: int) -> None:
    system = lw.System(lw.mechanisms.four_bar(n))
    y = system.initial_state()
    data, columns, begin = system.evaluate(0.0, y[: 7 * (2 * n + 1)], y[7 * (2 * n + 1) :]).D
    D = np.zeros((len(begin) - 1, 6 * (2 * n + 1)))
    np.add.at(D, (np.repeat(np.arange(len(D)), np.diff(begin)), columns), data)
    assert system.compiled().rank().rank == rank_of(D) == 15 * n + 5 - 3 * n


@pytest.mark.parametrize("formulation", [info.name for info in _core.formulations()])
def test_bricard_keeps_its_energy_with_every_formulation(formulation: str) -> None:
    """Rank 29 of 30, and no reaction of the six hinges follows from the motion alone."""
    result = lw.simulate(lw.mechanisms.bricard(), 10.0, 1e-2, formulation=formulation, progress=False)
    report = lw.System(lw.mechanisms.bricard()).compiled().rank()
    assert (report.rows, report.rank, sum(report.unique)) == (30, 29, 0)
    assert np.abs(result.energy_error).max() <= 1e-6


@pytest.mark.parametrize("formulation", ("standard", "augmented_lagrangian"))
def test_a_long_row_of_four_bars_keeps_its_energy_through_singular_poses(formulation: str) -> None:
    result = lw.simulate(lw.mechanisms.four_bar(40), 2.0, 1e-3, formulation=formulation, progress=False)
    assert np.abs(result.energy_error).max() <= 1e-6


@pytest.mark.parametrize("bars", [300, 1300])
def test_a_long_loop_of_hinges_repeats_three_equations_however_little_it_bends(bars: int) -> None:
    """A chain in a vee between two pins: away from its ends and its tip a link falls across its arm alone."""
    length = 1 / bars
    along = np.repeat([(0.6, 0, -0.8), (0.6, 0, 0.8)], bars // 2, axis=0)
    points = np.vstack([np.zeros(3), np.cumsum(along * length, axis=0)])
    model = lw.Model(gravity=(0, 0, -9.81))
    inertia = lw.mechanisms.thin_rod(length, length)
    turned = np.array([lw.rotation.from_axes(x=x, y=(0, 1, 0)) for x in along])
    middles = (points[1:] + points[:-1]) / 2
    links = model.bodies("link", mass=length, inertia=inertia, position=middles, orientation=turned)
    model.joints("revolute", ["ground", *links], [*links, "ground"], at=points, axis=(0, 1, 0), name="pin")
    result = lw.simulate(model, 2e-4, 1e-4, progress=False, on_inaccurate="pass")
    assert len(result.redundant_rows) == 3 and not result.unique_reactions.any()
    across = np.array((0, 0, -9.81)) + 9.81 * along[0, 2] * along[0]
    assert result.recorded("vdot")[0].reshape(-1, 6)[bars // 4, :3] == pytest.approx(across, abs=1e-6)


def flap(digits: int, turned: lw.functions.TimeFunction | None = None) -> lw.Model:
    """20 kg on two hinges in one oblique line, points and axes with so many digits; on a turned table."""
    axis = np.array([1.0, 2.0, 0.5]) / np.linalg.norm([1.0, 2.0, 0.5])
    center = np.array([0.4, -0.2, 0.0])
    model = lw.Model()
    frame = "ground" if turned is None else model.body("table", mass=50.0, inertia=(4.0, 5.0, 7.0))
    model.body("flap", mass=20.0, inertia=(4.3, 5.4, 1.9), position=center - (center @ axis) * axis)
    for name, at in (("lower", -0.6), ("upper", 0.6)):
        model.revolute(frame, "flap", at=np.round(at * axis, digits), axis=np.round(axis, digits), name=name)
    if turned is not None:
        model.revolute("ground", "table", at=(0, 0, 0), axis=(0, 0, 1), name="base")
        model.drive("base", position=turned)
    return model


@pytest.mark.parametrize("digits", [3, 4, 5, 6, 8])
def test_a_flap_that_digits_lock_says_so(digits: int) -> None:
    """In truth 1.13 rad in half a second at 155 N at most; locked, its hinges press with 1e5 N and more."""
    locked = (
        "'lower', 'upper'.* is independent of the others by .* nothing can move.* leave 1 degree of freedom"
    )
    with pytest.warns(lw.LinkworkWarning, match=locked):
        lw.simulate(flap(digits), 0.01, 1e-3, progress=False)
    members = lw.simulate_many(flap(digits), {"flap.mass": [20.0, 21.0]}, 0.01, 1e-3, progress=False)
    assert all("nothing can move" in members.remarks[k] for k in (0, 1))


@pytest.mark.parametrize("digits", [3, 5, 8])
def test_a_flap_that_digits_lock_on_a_driven_table_says_so(digits: int) -> None:
    """What is driven says where it stands; digits are told from a singular pose as they are without."""
    locked = "'lower', 'upper': .* nothing can move beside what is driven.* leave 1 degree of freedom"
    model = flap(digits, turned=lw.functions.polynomial(0.0, 1.0))
    with pytest.warns(lw.LinkworkWarning, match=locked):
        system = lw.System(lw.assemble(model).model)
        lw.running.checks.warn_of_near_dependence(system.compiled())


@pytest.mark.parametrize("digits", [9, 12, 16])
def test_digits_that_are_enough_say_nothing(digits: int) -> None:
    table = lw.assemble(flap(digits, turned=lw.functions.polynomial(0.0, 1.0))).model
    lw.simulate(table, 0.01, 1e-3, progress=False)
    result = lw.simulate(flap(digits), 0.5, 1e-3, progress=False)
    assert result.coordinate("lower").value[-1] == pytest.approx(1.13413, abs=1e-5)
    assert result.manifest["constraints"]["degrees_of_freedom"] == 1


@pytest.mark.parametrize("digits", [9, 10])
def test_what_rank_does_not_tell_apart_is_assembled_and_driven(digits: int) -> None:
    model = flap(digits)
    model.drive("lower", position=lw.functions.polynomial(0.0, 1.0))
    assembled = lw.assemble(model)
    assert 1e-12 < assembled.velocity_after.max() < 1e-9
    result = lw.simulate(assembled.model, 0.5, 1e-3, progress=False)
    assert result.coordinate("lower").value[-1] == pytest.approx(0.5, abs=1e-9)
