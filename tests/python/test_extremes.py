"""Mechanisms as they are on no desk: far from the origin, and of milligrams beside thousands of tons."""

from __future__ import annotations

from itertools import pairwise

import linkwork as lw
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from linkwork import mechanisms as known
from linkwork.arrays import Floats
from linkwork.equations import stiffness
from random_mechanisms import RANK, Equations, Maker, Mechanism, examples, mechanisms
from test_formulations_agree import CHOICES, options
from test_invariance import EXACT, motion, moved

#: Powers of ten by which masses are multiplied at most.
SPREAD = 6.0


def largest_of_each(x: Floats) -> Floats:
    """Of each body or joint."""
    out: Floats = np.abs(x).max(axis=1, initial=0.0)
    return out


# A coordinate of 1e6 m is rounded by 1e-10 m, and so are the arms between bodies; the worst of these
# mechanisms magnify that by a thousand.
@pytest.mark.parametrize("formulation", EXACT)
@examples(25)
@given(mechanism=mechanisms(most=15), seed=st.integers(0, 2**32 - 1))
def test_forces_and_accelerations_are_the_same_a_thousand_kilometers_away(
    mechanism: Mechanism, seed: int, formulation: str
) -> None:
    upright, shift = np.array([1.0, 0, 0, 0]), Maker(seed).vector(1e6)
    motion(moved(mechanism, upright, shift), formulation).close_to(motion(mechanism, formulation), 1e-6)


@pytest.mark.parametrize(("form", "solver"), CHOICES)
@examples(25, shared=5)
@given(mechanism=mechanisms(most=15), seed=st.integers(0, 2**32 - 1))
def test_every_body_and_joint_is_exact_beside_much_lighter_and_heavier_ones(
    mechanism: Mechanism, seed: int, form: str, solver: str
) -> None:
    """Accelerations against those of the same body, forces down to 1e-4 of the largest."""
    factors = 10 ** np.random.default_rng(seed).uniform(-SPREAD, SPREAD, len(mechanism.bodies))
    mechanism = mechanism.with_masses(tuple(factors))
    at, dynamics = Equations.of(mechanism), mechanism.dynamics(**options(form, solver))
    assume(at.smallest_singular_value > RANK)
    exact_v_dot, exact_multipliers = at.solution
    v_dot, multipliers = dynamics.accelerations(0.0, mechanism.q, mechanism.v)
    size = np.abs(exact_v_dot) + np.abs(at.free_v_dot)
    error = largest_of_each((v_dot - exact_v_dot).reshape(-1, 6)) / largest_of_each(size.reshape(-1, 6))
    assert error.max() <= 1e-8
    found, exact = (
        np.hstack(dynamics.reactions(0.0, mechanism.q, x)) for x in (multipliers, exact_multipliers)
    )
    scale = largest_of_each(exact)
    assert (largest_of_each(found - exact) <= 1e-8 * scale + 1e-12 * scale.max(initial=0.0)).all()


def sprung_four_bar(origin: Floats, miss: float = 0.0) -> lw.Model:
    """Planar, so that three of its equations are redundant, with a spring; the last pin misses its place."""
    model = lw.Model()
    points = origin + np.array([(0, 0, 0), (0, 0, 0.3), (0.5, 0, 0.55), (0.6, 0, 0)])
    names = ("ground", "crank", "coupler", "rocker", "ground")
    for name, start, end in zip(names[1:-1], points[:-1], points[1:], strict=True):
        length = float(np.linalg.norm(end - start))
        axes = lw.rotation.from_axes(x=end - start, y=(0, 1, 0))
        inertia = known.thin_rod(2 * length, length)
        model.body(name, mass=2 * length, inertia=inertia, position=(start + end) / 2, orientation=axes)
    for k, (a, b) in enumerate(pairwise(names)):
        model.revolute(a, b, at=points[k], axis=(0, 1, 0), name=f"pin {k}")
    hook = origin + np.array([0, 0, 1.0])
    model.spring_damper("ground", "coupler", at=(hook, points[2]), stiffness=500.0, damping=2.0)
    q = model.compiled().q0.copy()
    q[7 * 2] += miss
    return model.with_initial_state(q, model.compiled().v0)


FAR = np.array([1e5, -1e5, 1e5])


@pytest.mark.parametrize("choice", [{"step": 1e-3}, {"rtol": 1e-8}], ids=["fixed", "adaptive"])
def test_a_run_a_hundred_kilometers_away_is_the_run_here(choice: dict[str, float]) -> None:
    """Rank, step checks, steps and stabilization with it."""
    near, far = (
        lw.simulate(sprung_four_bar(origin), 1.0, progress=False, **choice) for origin in (np.zeros(3), FAR)
    )
    assert far.manifest["constraints"] == near.manifest["constraints"]
    assert far.violation[:, 0].max() <= 1e-9
    np.testing.assert_allclose(far.position - FAR, near.position, atol=1e-8)
    assert far.energy - far.energy[0] == pytest.approx(near.energy - near.energy[0], abs=1e-6)


def test_planar_loops_are_as_redundant_a_thousand_kilometers_away() -> None:
    near, far = (lw.System(sprung_four_bar(origin)).compiled().rank() for origin in (np.zeros(3), 10 * FAR))
    assert near.rank == far.rank == 17
    assert near.redundant_rows == far.redundant_rows


def test_a_spring_is_as_stiff_a_hundred_kilometers_away() -> None:
    near, far = (stiffness.fastest(lw.System(sprung_four_bar(origin))) for origin in (np.zeros(3), FAR))
    assert near is not None and far is not None
    assert far.eigenvalue == pytest.approx(near.eigenvalue, rel=1e-3)


def test_what_is_an_inaccuracy_is_measured_by_the_mechanism_not_by_its_place() -> None:
    with pytest.raises(lw.ModelError, match=r"pin 3 0\.02"):
        lw.simulate(sprung_four_bar(FAR, miss=0.02), 1e-3, 1e-3)
    with pytest.warns(lw.LinkworkWarning, match="corrected bodies by at most"):
        lw.simulate(sprung_four_bar(FAR, miss=1e-5), 1e-3, 1e-3)
