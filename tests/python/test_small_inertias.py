"""Thin rods, point masses and massless bodies run where joints and the other inertias decide the motion."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from light_mechanisms import Light, light_mechanisms
from linkwork import _core
from linkwork.arrays import Floats
from linkwork.mechanisms.bricard import AXES, POINTS
from linkwork.rotation import from_axes, matrix
from minimal_coordinates import Chain, Link, Turn
from random_mechanisms import examples
from test_formulations_agree import CHOICES, largest, options

SOLVERS = [options(form, solver) for form, solver in CHOICES if form != "normal"]


def relative_error(found: Floats, exact: Floats, least: float = 0.0) -> float:
    return largest(found - exact) / (max(largest(exact), least) or 1.0)


# --- accelerations and joint forces -------------------------------------------------------------------------


@examples(40)
@given(light=light_mechanisms(most=12))
def test_every_solver_of_standard_finds_accelerations_and_joint_forces(light: Light) -> None:
    mechanism, D = light.mechanism, light.at.D
    exact_v_dot, exact_multipliers = light.solution()
    for choice in SOLVERS:
        dynamics = mechanism.dynamics(**choice)
        v_dot, multipliers = dynamics.accelerations(0.0, mechanism.q, mechanism.v)
        error = relative_error(v_dot, exact_v_dot)
        spins = 1e-7 * largest(light.compact * exact_v_dot)  # whose roundoff is in the forces
        least = max(largest(light.at.g), spins)
        force_error = relative_error(D.T @ multipliers, D.T @ exact_multipliers, least)
        assert error <= 1e-9, choice
        assert force_error <= 1e-9, choice


@examples(15)
@given(light=light_mechanisms(ratios=(0.0, 1e-12, 1e-8, 1e-5), most=10, forces=()))
def test_a_step_is_that_of_the_augmented_lagrangian(light: Light) -> None:
    ends = []
    for formulation in ("standard", "augmented_lagrangian"):
        result = lw.simulate(light.mechanism.model, 1e-3, 1e-3, formulation=formulation, progress=False)
        ends.append(np.concatenate([result.q[-1].ravel(), result.v[-1].ravel()]))
    assert relative_error(*ends) <= 1e-10


# --- closed loops with redundant equations ------------------------------------------------------------------


def bricard(moment: float, length: float = 1.0, mass: float = 1.0) -> lw.Model:
    """The benchmark A04 with this moment of the rods about themselves, in other units of length and mass."""
    model = lw.Model(gravity=(0, -9.81 * length, 0), name="bricard")
    unit = mass * length**2
    links: list[lw.Body] = [model.ground]
    for k, (start, end) in enumerate(pairwise(POINTS), 1):
        links.append(
            model.body(
                f"rod {k}",
                mass=mass,
                inertia=(moment * unit, unit / 12, unit / 12),
                position=length * (start + end) / 2,
                orientation=from_axes(x=end - start, y=AXES[k - 1]),
            )
        )
    for k, (point, axis) in enumerate(zip(POINTS, AXES, strict=True)):
        model.revolute(links[k], links[(k + 1) % 6], at=length * point, axis=axis, name=f"hinge {k}")
    return model


def tightly(model: lw.Model, **choices: str) -> lw.Result:
    return lw.simulate(model, 3.0, integrator="dop853", rtol=1e-12, progress=False, **choices)


def steps(result: lw.Result) -> int:
    return int(result.statistics["steps"])


@pytest.mark.parametrize("moment", [1e-2, 1e-3, 1.25e-5, 2e-6, 1e-8, 1e-10, 1e-12, 0.0])
def test_bricards_rods_may_be_as_thin_as_they_like(moment: float) -> None:
    """Noise in the accelerations would cost steps: 83 709 with rods of 5 mm without the refinement."""
    thin, line = tightly(bricard(moment)), tightly(bricard(0.0), formulation="augmented_lagrangian")
    assert lw.System(bricard(moment)).compiled().rank().rank == 29
    assert steps(thin) <= 1.5 * steps(tightly(bricard(moment), formulation="augmented_lagrangian"))
    assert np.abs(thin.q[-1] - line.q[-1]).max() <= 10 * moment + 1e-9


@pytest.mark.parametrize("solver", [info.name for info in _core.linear_solvers() if info.available])
@pytest.mark.parametrize("moment", [1e-2, 1e-10, 0.0])
def test_every_linear_solver_takes_as_few_steps_with_thin_rods(moment: float, solver: str) -> None:
    def tight(**choices: str) -> lw.Result:
        model = bricard(moment)
        return lw.simulate(model, 1.0, integrator="dop853", rtol=1e-12, progress=False, **choices)

    thin, other = tight(linear_solver=solver), tight(formulation="augmented_lagrangian")
    assert steps(thin) <= 1.5 * steps(other)
    assert np.abs(thin.q[-1] - other.q[-1]).max() <= 1e-11


def test_the_same_thin_rods_in_other_units_move_the_same() -> None:
    state = bricard(1e-7).compiled()
    v_dot, multipliers = lw.System(bricard(1e-7)).accelerations(0.0, state.q0, state.v0)
    for length, mass in ((1e-6, 1e6), (1e6, 1e-6), (1e-3, 1e-3)):
        scaled = bricard(1e-7, length, mass)
        q = state.q0.reshape(-1, 7) * np.array([length] * 3 + [1] * 4)
        found, forces = lw.System(scaled).accelerations(0.0, q.ravel(), state.v0)
        found = found.reshape(-1, 6) / np.array([length] * 3 + [1] * 3)
        assert relative_error(found.ravel(), v_dot) <= 1e-12
        # translations are forces, rotations torques; those of least norm among the redundant ones
        units = np.tile([mass * length] * 3 + [mass * length**2] * 2, 6)
        assert relative_error(forces / units, multipliers) <= 1e-9


@pytest.mark.parametrize("solver", ["umfpack", "klu", "cholmod", "dense"])
@pytest.mark.parametrize(("mass", "force"), [(1e-6, 1.0), (1e-9, 1e-2), (1e-11, 1e-4)])
def test_what_presses_a_light_body_does_not_hide_how_it_moves(mass: float, force: float, solver: str) -> None:
    along, across = np.array((2, 1, 2)) / 3, np.array((1, 2, -2)) / 3
    model, at = lw.Model(gravity=9.81 * along), (0.1, 0.2, 0.3)
    base = model.body("base", mass=1, inertia=(1, 1, 1))
    link = model.body("link", mass=0, inertia=(0, 0, 0))
    tip = model.body("tip", mass=mass, inertia=(0.1 * mass,) * 3, position=at)
    model.fixed("ground", base, at=(0, 0, 0))
    model.translational(base, link, at=(0, 0, 0), axis=along)
    model.translational(link, tip, at=at, axis=across)
    model.force(tip, force=force * np.cross(along, across) + mass * across)
    run = lw.simulate(model, 0.5, 1e-2, linear_solver=solver, on_inaccurate="pass")
    way = run.body("tip").position[-1] - at  # axes and forces are rounded, 2e-16 of these
    assert way @ along == pytest.approx(9.81 * 0.5**2 / 2, rel=1e-14 * force / mass)
    assert way @ across == pytest.approx(0.5**2 / 2, rel=1e-14 * force / mass)


@pytest.mark.parametrize("solver", ["auto", "umfpack", "klu", "cholmod", "dense", "spqr"])
@pytest.mark.parametrize("first", ["universal", "cylindrical"])
@pytest.mark.parametrize("mass", [1e-6, 1e-9, 1e-11])
def test_a_light_tip_behind_a_massless_link_accelerates_as_in_the_limit(
    mass: float, first: str, solver: str
) -> None:
    """Tips a hundredth as heavy move alike, but for what they do to the base: at most 100 times mass."""

    def accelerations(mass: float, solver: str) -> Floats:
        model = lw.Model(gravity=(1, 2, -5))
        base = model.body("base", mass=1.8, inertia=(0.3, 0.35, 0.4), position=(0.3, -0.2, 0.1))
        link = model.body("link", mass=0, inertia=(0, 0, 0), position=(0.6, 0.1, 0.2))
        tip = model.body("tip", mass=mass, inertia=(0.1 * mass,) * 3, position=(0.6, -0.2, 0.7))
        model.revolute("ground", base, at=(0, 0, 0), axis=(0, 1, 2))
        axes = {"axis": (1, 2, 0.5)} if first == "cylindrical" else {"axes": ((1, 2, 0.5), (2, -1, 0))}
        getattr(model, first)(base, link, at=(0.5, 0.5, 0), **axes)
        model.translational(link, tip, at=(1, 0.5, 0), axis=(0.2, -1, 0.6))
        state = model.compiled()
        return lw.System(model, linear_solver=solver).accelerations(0.0, state.q0, state.v0)[0]

    expected = accelerations(1e-2 * mass, "auto")
    assert relative_error(accelerations(mass, solver), expected) < 100 * mass + 1e-18 / mass


@pytest.mark.parametrize("solver", ["umfpack", "klu", "cholmod", "dense"])
def test_an_inerter_does_not_hide_how_a_light_body_moves(solver: str) -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    base = model.body("base", mass=1, inertia=(0.3, 0.4, 0.5), position=(0.3, 0.2, 0.1))
    link = model.body("link", mass=0, inertia=(0, 0, 0), position=(0.6, 0.1, 0.2))
    tip = model.body("tip", mass=1e-11, inertia=(1e-12,) * 3, position=(0.6, -0.2, 0.7))
    model.revolute("ground", base, at=(0, 0, 0), axis=(0, 1, 0.2))
    model.translational(base, link, at=(0.5, 0.5, 0), axis=(1, 2, 0.5))
    model.translational(link, tip, at=(1, 0.5, 0), axis=(0.2, -1, 0.6))
    model.translational_inerter(link, tip, at=(0.5, 0.5, 0), axis=(0.2, -1, 0.6), inertance=1.0)
    tree = lw.simulate(model, 0.3, 1e-3)  # eliminated by its freedoms
    run = lw.simulate(model, 0.3, 1e-3, linear_solver=solver)
    assert np.abs(run.position[-1] - tree.position[-1]).max() < 1e-7


@pytest.mark.parametrize("solver", ["auto", "umfpack", "klu", "cholmod", "dense"])
@pytest.mark.parametrize("mass", [1e-7, 1e-9, 1e-11])
def test_what_moves_beside_them_does_not_hide_how_light_bodies_move(mass: float, solver: str) -> None:
    def accelerations(company: float) -> Floats:
        model = lw.Model(gravity=(0, 0, -9.81))
        base = model.body("base", mass=1, inertia=(0.3, 0.4, 0.5), position=(0.3, 0.2, 0.1))
        link = model.body("link", mass=0, inertia=(0, 0, 0), position=(0.6, 0.1, 0.2))
        tip = model.body("tip", mass=mass, inertia=(0.1 * mass,) * 3, position=(0.6, -0.2, 0.7))
        model.revolute("ground", base, at=(0, 0, 0), axis=(0, 1, 0.2))
        model.translational(base, link, at=(0.5, 0.5, 0), axis=(1, 2, 0.5))
        model.translational(link, tip, at=(1, 0.5, 0), axis=(0.2, -1, 0.6))
        if company:
            free = model.body("free", mass=1, inertia=(1, 1, 1), position=(9, 9, 9))
            model.force(free, force=(company, 0, 0))
            held = model.body("held", mass=1, inertia=(1, 1, 1), position=(-9, 9, 9))
            model.revolute("ground", held, at=(-9, 8, 9), axis=(0, 0, 1))
            model.force(held, force=(-company, 0, 0))
        state = model.compiled()
        return lw.System(model, linear_solver=solver).accelerations(0.0, state.q0, state.v0)[0][:18]

    for company in (1e5, 1e9, 1e12):
        assert relative_error(accelerations(company), accelerations(0.0)) < 1e-12


RUNS = [
    *({"stabilization": name} for name in ("none", "sampled_baumgarte", "projection", "velocity_projection")),
    {"integrator": "hem4", "stabilization": "projection"},
    {"integrator": "phem56", "stabilization": "none"},
    {"integrator": "abm4"},
    {"matrix_form": "schur", "linear_solver": "eigen_ldlt"},
    {"matrix_form": "schur", "linear_solver": "dense"},
]


@pytest.mark.parametrize("choice", RUNS, ids=lambda choice: " ".join(choice.values()))
@pytest.mark.parametrize("moment", [0.0, 1e-9])
def test_every_method_moves_lines_with_mass(moment: float, choice: dict[str, str]) -> None:
    reference = lw.simulate(bricard(0.0), 1.0, integrator="dop853", rtol=1e-12, progress=False)
    result = lw.simulate(bricard(moment), 1.0, 2e-3, progress=False, **choice)
    assert np.abs(result.q[-1] - reference.q[-1]).max() <= 1e-7
    assert np.abs(result.energy - result.energy[0]).max() <= 1e-6


# --- open chains, against minimal coordinates ---------------------------------------------------------------


def hinged_chain(seed: int, moments: Sequence[float]) -> tuple[lw.Model, Chain, Floats]:
    """Rods on oblique hinges, with these moments about themselves; the rate of each hinge."""
    rng = np.random.default_rng(seed)
    model, links, at = lw.Model(gravity=(0, 0, -9.81)), [], np.zeros(3)
    before, rates = model.ground, rng.uniform(-2, 2, len(moments))
    v, w = np.zeros(3), np.zeros(3)
    for k, moment in enumerate(moments):
        along, axis = rng.standard_normal(3), rng.standard_normal(3)
        along, axis = along / np.linalg.norm(along), axis / np.linalg.norm(axis)
        mass, center = 0.5 + rng.random(), at + 0.5 * along
        inertia = mass / 12 * (np.eye(3) + (12 * moment / mass - 1) * np.outer(along, along))
        w = w + rates[k] * axis
        body = model.body(
            f"rod {k}", mass=mass, inertia=inertia, position=center,
            velocity=v + np.cross(w, center - at), omega=w,
        )  # fmt: skip
        model.revolute(before, body, at=at, axis=axis)
        links.append(Link([Turn(at, axis)], mass, inertia, center, at))
        v, at, before = v + np.cross(w, along), at + along, body
    chain = Chain(links, (0, 0, -9.81), lambda _, bodies: [(np.zeros(3), np.zeros(3))] * len(bodies))
    return model, chain, rates


@pytest.mark.parametrize("moments", [(0.0, 0.0, 0.0), (0.0, 1e-9, 0.02), (1e-12, 1e-6, 1e-4)], ids=str)
def test_thin_rods_on_oblique_hinges_move_as_in_minimal_coordinates(moments: tuple[float, ...]) -> None:
    model, chain, rates = hinged_chain(7, moments)
    result = lw.simulate(
        model, 1.0, integrator="dop853", rtol=1e-11, times=np.linspace(0, 1, 6), progress=False
    )
    bodies, forces, _ = chain.motion(rates, result.t)
    for k in range(len(moments)):
        r = np.array([placed[k].r for placed in bodies])
        assert np.abs(result.position[:, k] - r).max() <= 1e-8
        start = matrix(model.compiled().q0[7 * k + 3 : 7 * k + 7])
        A = np.array([placed[k].A @ start for placed in bodies])
        assert np.abs(matrix(result.q[:, k, 3:]) - A).max() <= 1e-8
        force = result.reaction(f"revolute {k + 1}").force
        assert np.abs(force - forces[:, k]).max() <= 1e-7 * np.abs(forces[:, k]).max()


# --- what small inertias decide themselves ------------------------------------------------------------------


@pytest.mark.parametrize("moment", [1e-3, 1e-7, 1e-11])
def test_a_spin_that_only_a_tiny_moment_decides_has_its_closed_form(moment: float) -> None:
    """Two rods in line, welded end to end on a hinge about themselves: torque / (2 j)."""
    model = lw.Model(gravity=(0, 0, 0))
    inertia, torque = (moment, 1 / 12, 1 / 12), 1e-3
    first = model.body("first", mass=1.0, inertia=inertia, position=(0.5, 0, 0))
    second = model.body("second", mass=1.0, inertia=inertia, position=(1.5, 0, 0))
    model.revolute("ground", first, at=(0, 0, 0), axis=(1, 0, 0))
    model.fixed(first, second, at=(1, 0, 0))
    model.force(second, torque=(torque, 0, 0))
    state = model.compiled()
    v_dot, _ = lw.System(model).accelerations(0.0, state.q0, state.v0)
    spins = v_dot.reshape(-1, 6)[:, 3]
    assert np.abs(spins - torque / (2 * moment)).max() <= 1e-7 * torque / (2 * moment)


@pytest.mark.parametrize("off", [0.0, 1e-16, 1e-13])
@pytest.mark.parametrize(("size", "away"), [(1e-3, 0.0), (1.0, 0.0), (1e3, 0.0), (1.0, 1e6), (1.0, 1e9)])
def test_a_line_between_two_balls_is_refused_by_name_and_direction(
    off: float, size: float, away: float
) -> None:
    """Though they are beside it by roundoff, of which there is more far from the origin."""
    model = lw.Model()
    J, x = size**2 / 12, np.array([1.0, 2.0, 2.0]) / 3
    y, foot = np.array([2.0, -2.0, 1.0]) / 3, away * np.array([1.0, 0.7, 0.3])
    along = lw.rotation.from_axes(x=x, y=y)
    rod = model.body("rod", mass=1.0, inertia=(0, J, J), position=foot + size / 2 * x, orientation=along)
    arm = model.body("arm", mass=1.0, inertia=(J, J, J), position=foot + size * (x + y / 2))
    model.spherical("ground", rod, at=foot + off * size * y)
    model.spherical(rod, arm, at=foot + size * x)
    with pytest.raises(lw.SingularSystemError, match=r"'rod'.*its rotation about \(1, 0, 0\)") as caught:
        lw.simulate(model, 0.1, 1e-3, progress=False)
    assert caught.value.code == "free_massless_body"
    assert caught.value.bodies == ["rod"]


# --- analyses -----------------------------------------------------------------------------------------------


def hanging_line() -> lw.Model:
    """A rod of 1 m without a moment about itself, and a point mass on a string of 3 m."""
    model = lw.Model(gravity=(0, 0, -9.81))
    rod = model.body("rod", mass=2.0, inertia=(2 / 12, 2 / 12, 0), position=(0, 0, -0.5))
    point = model.body("point", mass=1.0, inertia=(0, 0, 0), position=(2, 0, -3))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.revolute("ground", point, at=(2, 0, 0), axis=(0, 1, 0), name="string")
    return model


def test_lines_and_points_swing_with_the_frequencies_of_textbooks() -> None:
    modes = lw.linearize(hanging_line())
    found = np.sort(np.abs(np.imag(modes.eigenvalues)))[-2:]
    assert np.allclose(found, np.sqrt(9.81 * np.array([1 / 3, 3 / 2])), rtol=1e-9)


def test_lines_and_points_are_assembled_and_checked_and_come_to_rest() -> None:
    model = lw.assemble(hanging_line()).model
    assert lw.System(model).compiled().rank().degrees_of_freedom == 2
    rest = lw.equilibrium(model)
    assert np.abs(rest.model.compiled().q0 - model.compiled().q0).max() <= 1e-9
