"""Equilibrium and small vibrations against closed forms and reduced equations."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from linkwork.analyses.stiffness import damping, stiffness
from linkwork.arrays import Floats
from linkwork.constraints.equations import Equations
from linkwork.constraints.tangent import between, displaced, to_body_axes
from scipy.optimize import brentq
from scipy.special import jn_zeros

G = 9.81
Z = (0.0, 0.0, 1.0)


# --- frequencies --------------------------------------------------------------------------------------------


def hanging_chain(n: int, length: float = 1.0) -> lw.Model:
    """n equal thin rods below each other, hinged about y."""
    model, rod = lw.Model(), length / n
    k = np.arange(n)
    at = np.column_stack([np.zeros((n, 2)), -k * rod])
    moment = rod**2 / n / 12
    links = model.bodies(
        "link", mass=1 / n, inertia=(moment, moment, 1e-4 * moment), position=at - (0, 0, rod / 2)
    )
    model.joints("revolute", k - 1, links, at=at, axis=(0, 1, 0), name="joint")
    return model


def test_a_chain_of_1000_links_has_the_frequencies_of_a_hanging_rope() -> None:
    """omega_k = j_0,k / 2 sqrt(g / L), Bessel's zeros (Bernoulli 1732); the error falls as 1 / n^2."""
    exact = jn_zeros(0, 5) / 2 * np.sqrt(G)
    errors = [lw.linearize(hanging_chain(n), modes=5).frequencies / exact - 1 for n in (500, 1000)]
    assert np.abs(errors[1]).max() < 3e-5
    assert np.log2(errors[0] / errors[1]) == pytest.approx(np.full(5, 2.0), abs=0.02)


def test_dense_and_sparse_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    model = hanging_chain(20)
    dense = lw.linearize(model, modes=6)
    monkeypatch.setattr("linkwork.analyses.linearization.DENSE", 0)
    sparse = lw.linearize(model, modes=6)
    assert sparse.frequencies == pytest.approx(dense.frequencies, rel=1e-9)
    overlap = np.abs((sparse.shapes.conj() * dense.shapes).sum(axis=(1, 2)))
    norms = np.linalg.norm(sparse.shapes, axis=(1, 2)) * np.linalg.norm(dense.shapes, axis=(1, 2))
    assert overlap == pytest.approx(norms, rel=1e-7)


def test_modes_near_a_frequency_are_found() -> None:
    every = lw.linearize(hanging_chain(100), modes=12).frequencies
    some = lw.linearize(hanging_chain(100), modes=3, near=float(every[8]) + 1e-3).frequencies
    assert some == pytest.approx(every[7:10], rel=1e-9)


def damped_chain(n: int) -> lw.Model:
    """Masses on a line, each on a spring and a damper to the one before."""
    model = lw.Model(gravity=(0, 0, 0))
    for k in range(n):
        mass = model.body(f"mass {k}", mass=2.0, inertia=(1, 1, 1), position=(k + 1.0, 0, 0))
        model.translational(model.ground, mass, at=(k + 1.0, 0, 0), axis=(1, 0, 0))
        before = model.find(f"mass {k - 1}") if k else model.ground
        model.spring_damper(before, mass, at=((k, 0, 0), (k + 1.0, 0, 0)), stiffness=50.0, damping=0.4)
    return model


@pytest.mark.parametrize("n", (1, 6, 100))
def test_a_row_of_masses_has_the_frequencies_and_damping_of_its_closed_form(n: int) -> None:
    """w_k = 2 sqrt(k/m) sin((2k - 1) pi / (4n + 2)), zeta_k = c w_k / (2 k)."""
    found = lw.linearize(damped_chain(n), modes=5)
    count = min(n, 5)
    exact = 2 * np.sqrt(25.0) * np.sin((2 * np.arange(1, count + 1) - 1) * np.pi / (4 * n + 2))
    assert found.frequencies == pytest.approx(exact, rel=1e-7)
    assert found.damping_ratios == pytest.approx(0.4 * exact / 100.0, rel=1e-6)
    assert found.stable


@pytest.mark.parametrize("spin", (300.0, 700.0))
def test_a_sleeping_top_precesses_and_nutates(spin: float) -> None:
    """J_1 s^2 - i J_3 w s - m g l = 0: stable above w = 2 sqrt(J_1 m g l) / J_3, 528 rad/s here."""
    model, arm, J, J_3, m = lw.Model(), 0.3, 0.01, 0.004, 2.0
    top = model.body("top", mass=m, inertia=(J, J, J_3), position=(0, 0, arm), omega=(0, 0, spin))
    model.spherical(model.ground, top, at=(0, 0, 0))
    J_1 = J + m * arm**2
    exact = np.roots([J_1, -1j * J_3 * spin, -m * G * arm])
    found = lw.linearize(model)
    moving = found.eigenvalues[np.abs(found.eigenvalues) > 1e-3]
    assert len(moving) == 2
    assert np.sort_complex(np.round(moving, 6)) == pytest.approx(
        np.sort_complex(np.round(exact, 6)), abs=2e-5
    )
    assert found.stable == (spin > 2 * np.sqrt(J_1 * m * G * arm) / J_3)


def test_a_hundred_tops_that_springs_join_precess_as_their_closed_form_says() -> None:
    """In the direction of the row each mode has the stiffness k_j = 4 k a^2 sin^2(j pi / 2 n), across none:
    (J_1 s^2 - m g a + k_j) (J_1 s^2 - m g a) + (J_3 w s)^2 = 0.
    """
    n, arm, J, J_3, m, spin, k = 100, 0.3, 0.01, 0.004, 2.0, 700.0, 2.0
    model = lw.Model()
    at = np.arange(float(n))[:, None] * (1.0, 0, 0)
    centers = at + np.array([0, 0, arm])
    tops = model.bodies("top", mass=m, inertia=(J, J, J_3), position=centers, omega=(0, 0, spin))
    model.joints("spherical", model.ground, tops, at=at, name="tip")
    for one, other in zip(range(n - 1), range(1, n), strict=True):
        between = (centers[one], centers[other])
        model.spring_damper(tops[one], tops[other], at=between, stiffness=k)
    J_1, weight = J + m * arm**2, m * G * arm
    stiffness = 4 * k * arm**2 * np.sin(np.arange(n) * np.pi / (2 * n)) ** 2
    squares = [
        np.roots([J_1**2, (J_3 * spin) ** 2 + J_1 * (k_j - 2 * weight), weight * (weight - k_j)])
        for k_j in stiffness
    ]
    exact = np.sqrt(-np.ravel(squares))
    found = lw.linearize(model, modes=6, near=2.5).frequencies
    nearest = np.sort(exact[np.argsort(np.abs(exact - 2.5))[:6]])
    assert found == pytest.approx(nearest, rel=1e-7)


def sliders(*names: str) -> lw.Model:
    """1 kg each, on the x axis."""
    model = lw.Model(gravity=(0, 0, 0))
    for x, name in enumerate(names):
        model.body(name, mass=1.0, inertia=(0.1,) * 3, position=(x, 0, 0))
    return model


@pytest.mark.parametrize("law", ["joint_force", "user_force"])
@pytest.mark.parametrize("stiff", [1e4, 1e7])
@pytest.mark.parametrize("k", [1e3, -1e3])
def test_forces_of_the_users_own_count_beside_stiffer_ones(law: str, stiff: float, k: float) -> None:
    model = sliders("a", "b", "c")
    model.translational("ground", "a", at=(0, 0, 0), axis=(1, 0, 0))
    model.translational("a", "b", at=(1, 0, 0), axis=(1, 0, 0), name="ab")
    model.translational("ground", "c", at=(2, 0, 0), axis=(1, 0, 0))
    model.translational_spring_damper("ground", "c", at=(2, 0, 0), axis=(1, 0, 0), stiffness=stiff)

    def between(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        force = np.zeros_like(v)
        force[1, 0] = -k * (q[1, 0] - q[0, 0] - 1.0)
        force[0, 0] = -force[1, 0]
        return force

    if law == "joint_force":
        model.joint_force("ab", lambda t, x, v: -k * x)
    else:
        model.user_force(between)
    found = lw.linearize(model)
    assert found.eigenvalues**2 == pytest.approx([0, -2 * k, -stiff], rel=1e-7, abs=1e-6)
    assert found.stable == (k > 0)
    assert lw.equilibrium(model, stable=False).stability == ("neutral" if k > 0 else "unstable")


HANGERS: dict[str, Callable[[lw.Model, float, float, float], Any]] = {
    "along an axis": lambda model, z, k, c: model.translational_spring_damper(
        "ground", "block", at=(0, 0, z), axis=(0, 0, 1), stiffness=k, damping=c),
    "between points": lambda model, z, k, c: model.spring_damper(
        "ground", "block", at=((0, 0, 0), (0, 0, z)), stiffness=k, damping=c, free_length=z),
    "bushing": lambda model, z, k, c: model.bushing(
        "ground", "block", at=(0, 0, z), stiffness=(k,) * 3, damping=(c,) * 3),
    "on a coordinate": lambda model, z, k, c: model.joint_force(
        "guide", lambda t, x, v: -k * x - c * v),
    "of two that pull": lambda model, z, k, c: [model.spring_damper(
        "ground", "block", at=((0, 0, end), (0, 0, z)), stiffness=k / 2, damping=c / 2, free_length=z / 2)
        for end in (0.0, 2 * z)],
}  # fmt: skip


@given(
    hanger=st.sampled_from(list(HANGERS)), mass=st.floats(-9, 6), size=st.floats(-5, 3),
    gravity=st.sampled_from((0, G)), frequency=st.floats(-1, 4),
    ratio=st.floats(-5, -0.2),
)  # fmt: skip
def test_what_hangs_on_springs_alone_has_its_damping(
    hanger: str, mass: float, size: float, gravity: float, frequency: float, ratio: float
) -> None:
    """Where springs balance a weight nothing is left of forces but rounding. Exponents of 10."""
    m, z, w, ratio = (10.0**exponent for exponent in (mass, size, frequency, ratio))
    assume(gravity / w**2 < 0.2 * z)
    model = lw.Model(gravity=(0, 0, -gravity))
    model.body("block", mass=m, inertia=(m * z**2 / 10,) * 3, position=(0, 0, z))
    model.translational("ground", "block", at=(0, 0, z), axis=(0, 0, 1), name="guide")
    HANGERS[hanger](model, z, m * w * w, 2 * ratio * m * w)
    found = lw.linearize(lw.equilibrium(model).model)
    assert found.frequencies == pytest.approx([w], rel=1e-6)
    assert found.damping_ratios == pytest.approx([ratio], rel=1e-4)


@cache
def eigenvalues_away(x: float, on_bushing: bool) -> Any:
    model, place = lw.Model(), np.array((x, 0.37 * x, -0.61 * x))
    at, end = place + np.array((0.3, 0.1, 0.2)), place + np.array((1.0, 0, 0))
    model.body("body", mass=1.0, inertia=(0.1,) * 3, position=at)
    if on_bushing:
        model.bushing(
            "ground",
            "body",
            at=at + 0.1 * np.array(Z),
            stiffness=(100.0, 200.0, 300.0),
            damping=(2.0,) * 3,
            rotational_stiffness=(100.0, 200.0, 300.0),
            rotational_damping=(2.0,) * 3,
        )
    else:
        model.revolute("ground", "body", at=place, axis=(0, 1, 0))
        model.spring_damper("ground", "body", at=(end, at), stiffness=100.0, damping=2.0)
    return lw.linearize(lw.equilibrium(model).model).eigenvalues


@pytest.mark.parametrize("away", [1e4, 1e6, 1e8])
@pytest.mark.parametrize("on_bushing", [False, True])
def test_eigenvalues_do_not_depend_on_where_the_origin_is(away: float, on_bushing: bool) -> None:
    """Steps do not become shorter than positions have digits, where rounding looks like a kink."""
    expected = eigenvalues_away(0.0, on_bushing)
    assert eigenvalues_away(away, on_bushing) == pytest.approx(expected, rel=1e-5)


def test_an_engine_on_bushings_has_their_damping() -> None:
    model, places = lw.Model(), [(x, y) for x in (-0.3, 0.3) for y in (-0.2, 0.2)]
    engine = model.body("engine", mass=200.0, inertia=(10.0, 14.0, 12.0), position=(0, 0, 0.5))
    for x, y in places:
        model.bushing(
            "ground", engine, at=(x, y, 0.4), stiffness=(4e4, 4e4, 9e4), damping=(80.0, 80.0, 180.0)
        )
    exact = np.zeros((6, 6))
    for x, y in places:
        arm = np.array([[0, -0.1, -y], [0.1, 0, x], [y, -x, 0]])  # v of the point = v_c + arm @ omega
        J = np.hstack([np.eye(3), arm])
        exact += J.T @ np.diag([80.0, 80.0, 180.0]) @ J
    found = lw.linearize(lw.equilibrium(model).model)
    assert found.stable
    np.testing.assert_allclose(found.C.toarray(), exact, atol=1e-8 * exact.max())


@pytest.mark.parametrize("place", [0.0, 10.0])
@pytest.mark.parametrize("stiffness", [1e7, 1e9, 1e11])
def test_a_sphere_that_rests_vibrates_by_the_stiffness_of_its_contact(place: float, stiffness: float) -> None:
    """F = k d^1.5 and F' = 1.5 k d^0.5 where F is the weight: however shallow, and however far others are."""
    model = lw.Model()
    model.body("far", mass=1.0, inertia=(0.1,) * 3, position=(0, 0, -place))
    model.revolute("ground", "far", at=(0, 0, 0), axis=(0, 1, 0))
    model.body("ball", mass=1.0, inertia=(0.1,) * 3, position=(place, 0, 0.1))
    model.translational("ground", "ball", at=(place, 0, 0.1), axis=(0, 0, 1))
    model.sphere_plane_contact(
        "ground", "ball", at=((0, 0, 0), (place, 0, 0.1)), normal=(0, 0, 1), radius=0.1, stiffness=stiffness
    )
    depth = (G / stiffness) ** (2 / 3)
    found = lw.linearize(lw.equilibrium(model).model)
    assert found.frequencies[-1] == pytest.approx(np.sqrt(1.5 * stiffness * depth**0.5), rel=1e-4)


@pytest.mark.parametrize("transition", [1e-2, 1e-3, 1e-4])
def test_friction_damps_by_its_slope_at_rest_however_steep(transition: float) -> None:
    model = lw.Model()
    model.body("bob", mass=1.0, inertia=(0.01,) * 3, position=(0, 0, -1))
    model.revolute("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_friction(
        "ground", "bob", at=(0, 0, 0), axis=(0, 1, 0), coulomb=0.5, transition=transition
    )
    exact = np.sort(np.roots([1.01, 0.5 / transition, G]))
    assert np.sort(lw.linearize(model).eigenvalues.real) == pytest.approx(exact, rel=1e-5)


def test_a_slow_motion_is_not_lost_beside_a_quick_one() -> None:
    """An inverted mast with a light sensor on a stiff mount, and an inverted pendulum in syrup."""
    model, length = lw.Model(), 20.0
    rod = lw.mechanisms.thin_rod(100.0, length)
    along = lw.rotation.from_axes((0, 0, 1), (0, 1, 0))
    mast = model.body("mast", mass=100.0, inertia=rod, position=(0, 0, length / 2), orientation=along)
    model.revolute("ground", mast, at=(0, 0, 0), axis=(0, 1, 0))
    sensor = model.body("sensor", mass=1e-3, inertia=(1e-7,) * 3, position=(0, 0, length))
    model.translational(mast, sensor, at=(0, 0, length), axis=(0, 0, 1))
    model.spring_damper(mast, sensor, at=((0, 0, length - 0.1), (0, 0, length)), stiffness=1e9, damping=1.0)
    found = lw.linearize(lw.equilibrium(model, stable=False).model)
    growth = np.sqrt(1.5 * G / length)
    assert np.sort(found.eigenvalues[:2].real) == pytest.approx([-growth, growth], rel=1e-4)
    assert not found.stable
    model = lw.Model()
    model.body("rod", mass=1.0, inertia=(0.01, 0.91, 0.91), position=(0, 0, 0.3))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_spring_damper("ground", "rod", axis=(0, 1, 0), damping=3000.0)
    found = lw.linearize(model)
    assert np.sort(found.eigenvalues.real) == pytest.approx(
        np.sort(np.roots([1.0, 3000.0, -G * 0.3])), rel=1e-6
    )
    assert not found.stable


def test_each_of_many_equal_modes_of_a_large_model_is_found() -> None:
    stiffness = np.append(np.ones(60), np.repeat(np.arange(2, 62) ** 2.0, 2))
    model = sliders(*(f"mass {k}" for k in range(len(stiffness))))
    for k, own in enumerate(stiffness):
        model.translational("ground", f"mass {k}", at=(k, 0, 0), axis=(1, 0, 0))
        model.translational_spring_damper(
            "ground", f"mass {k}", at=(k, 0, 0), axis=(1, 0, 0), stiffness=float(own)
        )
    assert lw.linearize(model, modes=20).frequencies == pytest.approx(np.ones(20), rel=1e-8)
    near = lw.linearize(model, modes=6, near=10.1).frequencies
    assert near == pytest.approx([9, 9, 10, 10, 11, 11], rel=1e-8)


def test_a_large_model_with_many_neutral_motions_has_them_and_no_others_first() -> None:
    """Links in a row on balls, every tenth of which is held elastically: 600 freedoms, few with springs."""
    model = lw.Model(gravity=(0, 0, 0))
    before: lw.Body | str = "ground"
    for k in range(200):
        link = model.body(f"link {k}", mass=1.0, inertia=(0.1,) * 3, position=(k + 0.5, 0, 0))
        model.spherical(before, link, at=(k, 0, 0))
        if k % 10 == 0:
            model.bushing("ground", link, at=(k + 0.5, 0, 0), stiffness=(100.0,) * 3)
        before = link
    found = lw.linearize(model, modes=10)
    assert found.frequencies == pytest.approx(np.zeros(10))
    assert np.linalg.matrix_rank(found.shapes.reshape(10, -1)) == 10
    assert found.stable


def test_velocities_that_do_not_follow_a_driver_are_refused() -> None:
    """A bead in the slot of a hub that turns is stable only as long as the hub rests."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("hub", mass=1.0, inertia=(1, 1, 1))
    model.body("bead", mass=2.0, inertia=(0.01,) * 3, position=(0.5, 0, 0))
    model.revolute("ground", "hub", at=(0, 0, 0), axis=(0, 0, 1), name="shaft")
    model.translational("hub", "bead", at=(0.5, 0, 0), axis=(1, 0, 0), name="slot")
    model.translational_spring_damper("hub", "bead", at=(0.5, 0, 0), axis=(1, 0, 0), stiffness=20.0)
    model.drive("shaft", velocity=4.0)
    with pytest.raises(lw.ModelError, match="velocities of the model do not satisfy joint"):
        lw.linearize(model)


def test_a_free_body_that_spins_is_neutral_or_nutates() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("spinning", mass=1.0, inertia=(1.0, 1.0, 1.7), omega=(0, 0, 3.0))
    assert lw.linearize(model).frequencies.max() == pytest.approx(0.7 * 3.0 + 3.0, rel=1e-6)


@pytest.mark.parametrize("n", (1, 100))
def test_what_turns_and_does_not_look_the_same_has_no_frequencies(n: int) -> None:
    model = lw.Model()
    for k in range(n):
        inertia = (0.01, 0.02 if k == 0 else 0.01, 0.015)
        top = model.body(mass=2.0, inertia=inertia, position=(k, 0, 0.3), omega=(0, 0, 50))
        model.spherical(model.ground, top, at=(k, 0, 0))
    with pytest.raises(lw.ModelError, match="moves so that its .* changes? with time"):
        lw.linearize(model)


def test_a_model_that_falls_is_not_in_balance() -> None:
    with pytest.raises(lw.ModelError, match="is not in balance: body 'link\\[2\\]'"):
        lw.linearize(lw.mechanisms.chain(3))


# --- the matrices -------------------------------------------------------------------------------------------


def tangle() -> lw.Model:
    """A loop with springs and a moving body, not in balance: nothing in it is symmetric or zero."""
    model = lw.Model()
    a = model.body("a", mass=1.0, inertia=(0.02, 0.1, 0.1), position=(0.5, 0, 0), omega=(1, 2, 3))
    b = model.body("b", mass=1.5, inertia=(0.03, 0.15, 0.12), position=(1.0, 0.5, 0.3), omega=(2, 0, -1),
                   orientation=lw.rotation.about((1, 2, 3), 0.7))  # fmt: skip
    c = model.body("c", mass=0.5, inertia=(0.03, 0.05, 0.02), position=(0, 1, 0))
    model.revolute(model.ground, a, at=(0, 0, 0), axis=(0, 1, 0.2))
    model.universal(a, b, at=(1, 0, 0), axes=((0, 1, 0), (1, 0, 1)))
    model.distance(b, model.ground, at=((1.0, 1.0, 0.6), (1.5, 1.0, 1.0)))
    model.spring_damper(b, c, at=((1.1, 0.5, 0.3), (0, 1.1, 0)), stiffness=70.0, damping=3.0, free_length=0.9)
    model.spring_damper(a, c, at=((0.4, 0, 0), (0, 0.9, 0)), stiffness=40.0, damping=2.0, free_length=0.5)
    return model


def test_stiffness_and_damping_are_derivatives_of_the_forces() -> None:
    """Against one difference along a random direction, bodies all together, constraint forces included."""
    model = tangle()
    eq, core, random = Equations(model), model.compiled(), np.random.default_rng(5)
    q, v = np.array(core.q0), np.array(core.v0)
    multipliers, x, h = random.standard_normal(core.row_count), random.standard_normal(18), 1e-5
    T = eq.turn(q)

    def forces(at: Floats, speed: Floats) -> Floats:
        terms = eq.terms(0.0, at, speed)
        return T.T @ to_body_axes(at, terms.g + terms.D.T @ multipliers)

    along = (forces(displaced(q, h * x), v) - forces(displaced(q, -h * x), v)) / (2 * h)
    assert np.abs(stiffness(eq, 0.0, q, v, multipliers) @ x + along).max() < 1e-6 * np.abs(along).max()
    faster, slower = v + h * (T @ x), v - h * (T @ x)
    speedwise = (forces(q, faster) - forces(q, slower)) / (2 * h)
    omega, turning = v.reshape(-1, 6)[:, 3:], np.zeros((3, 6))
    turning[:, 3:] = -np.einsum("nij,nj->ni", core.inertia, np.cross(omega, (T @ x).reshape(-1, 6)[:, 3:]))
    expected = T.T @ turning.ravel() - speedwise
    assert np.abs(damping(eq, 0.0, q, v) @ x - expected).max() < 1e-6 * np.abs(expected).max()


def test_small_motions_add_and_undo() -> None:
    random = np.random.default_rng(3)
    p = random.standard_normal((5, 4))
    q = np.hstack([random.standard_normal((5, 3)), p / np.linalg.norm(p, axis=1, keepdims=True)]).ravel()
    x = random.uniform(-1, 1, 30)
    assert np.abs(between(q, displaced(q, x)) - x).max() < 1e-13


# --- equilibrium --------------------------------------------------------------------------------------------


def test_an_upright_rod_falls_to_where_it_hangs() -> None:
    model = lw.Model()
    rod = model.body("rod", mass=3.0, inertia=(0.01, 0.1, 0.1), position=(0, 0, 0.5))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    up, down = lw.equilibrium(model, stable=False), lw.equilibrium(model)
    assert (up.stability, down.stability) == ("unstable", "stable")
    assert up.moved.max() == 0.0 and down.moved[0] == pytest.approx(1.0, abs=1e-12)
    assert down.reaction("hinge").force == pytest.approx([0, 0, 3 * G], abs=1e-9)
    rate = np.sqrt(3 * G * 0.5 / (0.1 + 3 * 0.25))
    assert lw.linearize(up.model).eigenvalues == pytest.approx([rate], rel=1e-9)
    assert lw.linearize(down.model).eigenvalues == pytest.approx([1j * rate], rel=1e-9)


def test_a_body_on_three_springs_sinks_by_its_weight() -> None:
    model = lw.Model()
    box = model.body("box", mass=2.0, inertia=(1, 1, 1), position=(0.1, 0.05, -1.0))
    for x, y in ((1, 0), (-0.5, 0.8), (-0.5, -0.8)):
        model.spring_damper(
            model.ground, box, at=((x, y, 0), (x + 0.1, y + 0.05, -1)), stiffness=100.0, free_length=1.0
        )
    rest = lw.equilibrium(model)
    assert rest.model.compiled().q0[2] == pytest.approx(-1 - 2 * G / 300, abs=1e-12)
    assert rest.imbalance < 1e-12


def four_bar_angles(theta: float) -> tuple[float, float]:
    """Angles of coupler and rocker of the linkage below, crank at theta."""
    a, b, c, d = 0.5, 1.4, 1.2, 1.5
    tip = a * np.array([np.cos(theta), np.sin(theta)])
    to = np.array([d, 0.0]) - tip
    s = float(np.linalg.norm(to))
    along = (s**2 + b**2 - c**2) / (2 * s)
    meet = tip + along * to / s + np.sqrt(b**2 - along**2) * np.array([-to[1], to[0]]) / s
    coupler, rocker = meet - tip, meet - (d, 0)
    return float(np.arctan2(coupler[1], coupler[0])), float(np.arctan2(rocker[1], rocker[0]))


def four_bar_in_plane(
    theta: float, a: float, c: float, d: float, masses: tuple[float, ...], J: float
) -> lw.Model:
    """Crank of length a at angle theta, coupler, and rocker of length c; d between the pins on the ground."""
    _, rocker = four_bar_angles(theta)
    tip = a * np.array([np.cos(theta), np.sin(theta), 0])
    meet = np.array([d, 0, 0]) + c * np.array([np.cos(rocker), np.sin(rocker), 0])
    model = lw.Model(gravity=(0, -G, 0))
    spans = (((0, 0, 0), tip), (tip, meet), ((d, 0, 0), meet))
    bodies = [
        model.body(f"link {k}", mass=m, inertia=(0.01, J, J), position=(np.array(i) + j) / 2)
        for k, (m, (i, j)) in enumerate(zip(masses, spans, strict=True))
    ]
    pins = (
        (model.ground, 0, (0, 0, 0)),
        (bodies[0], 1, tip),
        (bodies[1], 2, meet),
        (model.ground, 2, (d, 0, 0)),
    )
    for i, k, at in pins:
        model.revolute(i, bodies[k], at=at, axis=Z)
    return model


def test_a_four_bar_vibrates_as_its_reduced_equation_says() -> None:
    """m(theta) theta'' + ... = -V'(theta): V' = 0 at rest, omega^2 = V'' / m there."""
    a, b, c, d, masses, J = 0.5, 1.4, 1.2, 1.5, (1.0, 2.0, 1.5), 0.05

    def centers(theta: float) -> Floats:
        """Of mass (3, 2), and the angles of the links as a third column."""
        phi, psi = four_bar_angles(theta)
        e = [np.array([np.cos(x), np.sin(x)]) for x in (theta, phi, psi)]
        points = (a * e[0] / 2, a * e[0] + b * e[1] / 2, np.array([d, 0]) + c * e[2] / 2)
        return np.array([[*p, x] for p, x in zip(points, (theta, phi, psi), strict=True)])

    def height(theta: float) -> float:
        return float(np.dot(masses, centers(theta)[:, 1]))

    def slope(theta: float, h: float = 1e-3) -> float:
        f = [height(theta + k * h) for k in (-2, -1, 1, 2)]
        return (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * h)

    low = brentq(slope, np.pi, 2 * np.pi, xtol=1e-14)
    h = 1e-3
    rates = (centers(low - 2 * h) - 8 * centers(low - h) + 8 * centers(low + h) - centers(low + 2 * h)) / (
        12 * h
    )
    inertia = np.dot(masses, (rates[:, :2] ** 2).sum(axis=1)) + J * (rates[:, 2] ** 2).sum()
    curvature = (slope(low - 2 * h) - 8 * slope(low - h) + 8 * slope(low + h) - slope(low + 2 * h)) / (12 * h)
    rest = lw.equilibrium(four_bar_in_plane(np.pi / 3, a, c, d, masses, J))
    assert rest.stability == "stable"
    assert rest.model.compiled().q0[:2] == pytest.approx(
        a / 2 * np.array([np.cos(low), np.sin(low)]), abs=1e-8
    )
    assert lw.linearize(rest.model).frequencies == pytest.approx([np.sqrt(G * curvature / inertia)], rel=1e-7)


def test_a_body_that_nothing_holds_has_no_equilibrium() -> None:
    model = lw.Model()
    model.body("stone", mass=1.0, inertia=(1, 1, 1))
    with pytest.raises(lw.NotConvergedError, match="body 'stone' is driven by -9.81 N"):
        lw.equilibrium(model)


def test_a_mechanism_at_rest_stays_there() -> None:
    """The spatial slider-crank, released in the equilibrium that was found."""
    rest = lw.equilibrium(lw.mechanisms.spatial_slider_crank())
    result = lw.simulate(rest.model, 1.0, 1e-3, progress=False)
    assert np.abs(result.position - result.position[0]).max() < 1e-10


def test_a_sled_stands_across_the_slope_on_its_edge() -> None:
    """The edge restricts velocities only, and holds the weight along the slope nevertheless."""
    model = lw.Model(gravity=(0, -G / 2, -G * np.sqrt(0.75)))
    sled = model.body("sled", mass=2, inertia=(0.1, 0.1, 0.1))
    model.planar(model.ground, sled, at=(0, 0, 0), axis=Z)
    model.knife_edge(model.ground, sled, at=(0, 0, 0), axis=(0, 1, 0), name="edge")
    rest = lw.equilibrium(model)
    assert rest.stability == "neutral"
    assert rest.reaction("edge").force == pytest.approx([0, G, 0], abs=1e-12)


def test_springs_that_pull_against_each_other_are_in_balance_without_weight() -> None:
    """Lateral stiffness of a prestressed mass: 2 F / l."""
    model = lw.Model(gravity=(0, 0, 0))
    bead = model.body("bead", mass=0.5, inertia=(1, 1, 1))
    model.orientation(model.ground, bead)
    for x in (-2.0, 2.0):
        model.spring_damper(model.ground, bead, at=((x, 0, 0), (0, 0, 0)), stiffness=100.0, free_length=1.5)
    rest = lw.equilibrium(model)
    assert rest.stability == "stable" and rest.softest == pytest.approx(2 * 50 / 2, rel=1e-7)
    exact = np.sqrt(np.array([50.0, 50.0, 200.0]) / 0.5)
    assert lw.linearize(rest.model).frequencies == pytest.approx(exact, rel=1e-7)


def test_a_driver_that_starts_to_accelerate_holds_at_rest() -> None:
    """Reactions of the equilibrium are those of statics; vibrations are those with the driver held."""
    model = lw.Model(gravity=(0, 0, -G))
    arm = model.body("arm", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(0.5, 0, 0))
    bob = model.body("bob", mass=1.0, inertia=(0.01, 0.02, 0.03), position=(1.0, 0, -0.4))
    model.revolute(model.ground, arm, at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute(arm, bob, at=(1, 0, 0), axis=(0, 1, 0))
    turn = lw.functions.polynomial(0, 0, 7.0)
    model.angle_driver(model.ground, arm, at=(0, 0, 0), axis=(0, 1, 0), angle=turn, name="motor")
    rest = lw.equilibrium(model)
    assert rest.reaction("motor").torque == pytest.approx([0, -(2 * 0.5 + 1) * G, 0], abs=1e-9)
    exact = np.sqrt(G * 0.4 / (0.02 + 0.16))
    assert lw.linearize(rest.model).frequencies == pytest.approx([exact], rel=1e-9)


def test_motion_that_accelerates_is_told_as_such_and_not_sent_to_an_equilibrium() -> None:
    """A ball that goes round on a shaft stays at its height: at rest it would hang."""
    omega, length = 8.0, 0.3
    angle = np.arccos(G / (omega**2 * length))
    p = lw.rotation.about((0, 1, 0), -angle)
    A = lw.rotation.matrix(p)
    r = A @ (0, 0, -length)
    model = lw.Model(name="governor")
    model.body("shaft", mass=1.0, inertia=(0.1, 0.1, 0.1), omega=(0, 0, omega))
    model.revolute("ground", "shaft", at=(0, 0, 0), axis=Z, name="bearing")
    model.body("ball", mass=1.0, inertia=(1e-3, 1e-3, 1e-3), position=r, orientation=p,
               velocity=np.cross((0, 0, omega), r), omega=A.T @ (0, 0, omega))  # fmt: skip
    model.revolute("shaft", "ball", at=(0, 0, 0), axis=(0, 1, 0), name="arm")
    with pytest.raises(lw.ModelError, match="accelerates: body 'ball' needs .* N for it") as caught:
        lw.linearize(model)
    assert caught.value.code == "not_in_balance" and "equilibrium" not in str(caught.value)


# --- parts that are far from each other ---------------------------------------------------------------------


def row_of_sliders(mass: Floats, stiffness: Floats, damping: Floats) -> lw.Model:
    """Each with a spring and a damper of its own."""
    model = lw.Model(gravity=(0, 0, 0))
    for k, (m, c, d) in enumerate(zip(mass, stiffness, damping, strict=True)):
        name, at = f"slider {k}", (float(k), 0.0, 0.0)
        model.body(name, mass=m, inertia=(m,) * 3, position=at)
        model.translational("ground", name, at=at, axis=(0, 1, 0))
        model.translational_spring_damper(
            "ground", name, at=at, axis=(0, 1, 0), stiffness=float(c), damping=float(d)
        )
    return model


def of_sliders(mass: Floats, stiffness: Floats, damping: Floats) -> np.ndarray:
    """Their eigenvalues, one of each pair, slow ones first."""
    half = damping / (2 * mass)
    root = np.sqrt(half**2 - stiffness / mass + 0j)
    every = np.concatenate([-half + root, np.where(root.imag > 0, np.nan, -half - root)])
    every = every[~np.isnan(every)]
    return np.asarray(every[np.argsort(np.abs(every), kind="stable")])


@pytest.mark.parametrize("stiffest", [1e4, 1e10, 1e12])
def test_slow_damped_modes_of_a_large_model_are_found_beside_something_stiff(stiffest: float) -> None:
    omega = np.arange(1.0, 91)
    stiffness, damping = omega**2, np.where(np.arange(90) % 2, 0.02, 3.0) * omega
    stiffness[0] = stiffest
    exact = of_sliders(np.ones(90), stiffness, damping)[:6]
    found = lw.linearize(row_of_sliders(np.ones(90), stiffness, damping), modes=6).eigenvalues
    assert found == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize("n", [79, 90])
def test_growth_is_found_where_damped_motions_have_two_modes_each(n: int) -> None:
    """s^2 + 0.3 s + 0.02 = 0, and a buckled slider of -25 N/m."""
    model = lw.Model(gravity=(0, 0, 0))
    for k in range(n):
        model.body(f"body {k}", mass=1.0, inertia=(1.0,) * 3, position=(k, 0, 0))
        if k < 2:
            model.translational("ground", f"body {k}", at=(k, 0, 0), axis=(0, 1, 0))
        else:
            model.fixed("ground", f"body {k}", at=(k, 0, 0))
    model.translational_spring_damper(
        "ground", "body 0", at=(0, 0, 0), axis=(0, 1, 0), stiffness=0.02, damping=0.3
    )
    model.spring_damper("ground", "body 1", at=((1, 0, -1), (1, 0, 0)), stiffness=50.0, free_length=1.5)
    found = lw.linearize(model)
    assert np.sort(found.eigenvalues.real) == pytest.approx([-5.0, -0.2, -0.1, 5.0], rel=1e-6)
    assert not found.stable


@pytest.mark.parametrize("others", [0, 90])
@pytest.mark.parametrize("stiffness", [1e9, 1e10])
def test_something_light_keeps_its_damping_beside_something_heavy(others: int, stiffness: float) -> None:
    """omega = 100 rad/s, ratio 1/2."""
    mass = np.concatenate([[1e6, 1e-3], np.ones(others)])
    springs = np.concatenate([[stiffness, 10.0], 1e6 + np.arange(others)])
    dampers = np.concatenate([[0.0, 0.1], np.zeros(others)])
    found = lw.linearize(row_of_sliders(mass, springs, dampers), modes=2)
    slow = np.sqrt(stiffness / 1e6) * 1j
    assert np.sort_complex(found.eigenvalues) == pytest.approx(
        np.sort_complex([slow, 100 * np.exp(2j * np.pi / 3)]), rel=1e-7, abs=1e-7
    )


@pytest.mark.parametrize("stiff", [1e4, 1e10])
def test_forces_that_follow_a_body_make_it_flutter_beside_something_stiff(stiff: float) -> None:
    """s^2 = -100 +- 10 i."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("plate", mass=1.0, inertia=(1.0,) * 3)
    model.planar("ground", "plate", at=(0, 0, 0), axis=Z)
    model.bushing("ground", "plate", at=(0, 0, 0), stiffness=(100.0, 100.0, 0.0))
    model.rotational_spring_damper("ground", "plate", at=(0, 0, 0), axis=Z, stiffness=1.0)
    model.body("rod", mass=1.0, inertia=(1.0,) * 3, position=(1, 0, 0))
    model.translational("ground", "rod", at=(1, 0, 0), axis=(1, 0, 0))
    model.translational_spring_damper("ground", "rod", at=(1, 0, 0), axis=(1, 0, 0), stiffness=stiff)

    def follower(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        force = np.zeros_like(v)
        force[0, :2] = -10 * q[0, 1], 10 * q[0, 0]
        return force

    model.user_force(follower)
    found = lw.linearize(model)
    assert not found.stable
    assert found.eigenvalues.real.max() == pytest.approx(np.sqrt(-100 + 10j).real, rel=1e-6)


def test_near_is_nearest_in_frequency_and_not_in_its_square() -> None:
    omega = 100.0 + np.arange(90)
    omega[:2] = 8.0, 11.9
    model = row_of_sliders(np.ones(90), omega**2, np.zeros(90))
    assert lw.linearize(model, modes=1, near=10.0).frequencies == pytest.approx([11.9], rel=1e-7)


@pytest.mark.parametrize("inertia", [1e-7, 1e-6])
def test_a_small_rotor_on_a_large_boom_moves_mass(inertia: float) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    mass, length = 1e5, 100.0
    moment = mass * length**2 / 3
    model.body("boom", mass=mass, inertia=(moment / 4,) * 3, position=(length / 2, 0, 0))
    model.revolute("ground", "boom", at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_spring_damper("ground", "boom", at=(0, 0, 0), axis=(0, 1, 0), stiffness=moment)
    model.body("rotor", mass=0.01, inertia=(inertia,) * 3, position=(length, 0, 0))
    model.revolute("boom", "rotor", at=(length, 0, 0), axis=Z)
    model.rotational_spring_damper("boom", "rotor", at=(length, 0, 0), axis=Z, stiffness=100 * inertia)
    assert lw.linearize(model).frequencies == pytest.approx([1.0, 10.0], rel=1e-6)


@pytest.mark.parametrize("n", [79, 90])
def test_motions_without_stiffness_are_neutral_however_many(n: int) -> None:
    free = lw.linearize(row_of_sliders(np.ones(n), np.zeros(n), np.zeros(n)), modes=3)
    assert free.frequencies == pytest.approx(np.zeros(3)) and free.stable
    damped = lw.linearize(row_of_sliders(np.ones(n), np.zeros(n), 1.0 + np.arange(n)), modes=3)
    assert damped.frequencies == pytest.approx(np.zeros(3)) and damped.stable


@pytest.mark.parametrize("away", [1.0, 500.0, 5000.0])
@pytest.mark.parametrize("kind", ["distance", "universal_spherical", "revolute_spherical"])
def test_a_short_pendulum_swings_as_it_does_however_far_another_body_is(kind: str, away: float) -> None:
    """omega^2 = g / l of a bob on a rod of 0.3 m."""
    model = lw.Model()
    model.body("bob", mass=1.0, inertia=(1e-3,) * 3, position=(0, 0, -0.3))
    axis = {"axis": (0, 1, 0)} if kind == "revolute_spherical" else {}
    getattr(model, kind)("ground", "bob", at=((0, 0, 0), (0, 0, -0.3)), **axis)
    model.body("pylon", mass=1.0, inertia=(1.0,) * 3, position=(away, 0, 0))
    model.fixed("ground", "pylon", at=(away, 0, 0))
    assert lw.linearize(model).frequencies.max() == pytest.approx(np.sqrt(G / 0.3), rel=1e-6)


@pytest.mark.parametrize("away", [1.0, 500.0, 5000.0])
def test_a_short_strut_buckles_however_far_another_body_is(away: float) -> None:
    """20 N/m do not hold a weight of 9.81 N on a rod of 0.3 m: that takes 32.7 N/m."""
    model = lw.Model()
    model.body("bob", mass=1.0, inertia=(1e-3,) * 3, position=(0, 0, 0.3))
    model.distance("ground", "bob", at=((0, 0, 0), (0, 0, 0.3)))
    model.bushing(
        "ground", "bob", at=(0, 0, 0.3), stiffness=(20.0, 20.0, 0.0), rotational_stiffness=(1.0,) * 3
    )
    model.body("pylon", mass=1.0, inertia=(1.0,) * 3, position=(away, 0, 0))
    model.fixed("ground", "pylon", at=(away, 0, 0))
    assert not lw.linearize(model).stable
    rest = lw.equilibrium(model, stable=False)
    assert rest.stability == "unstable"
    assert rest.softest == pytest.approx(20 - G / 0.3, rel=1e-6)


@pytest.mark.parametrize("across", [0.0, 1e10])
def test_a_contact_counts_beside_something_stiff_on_the_same_body(across: float) -> None:
    """Force k d^1.5 of a ball of 1 kg, in a mechanism of 30 m: omega^2 = 1.5 k sqrt(d)."""
    model, k = lw.Model(), 1e8
    model.body("pylon", mass=1.0, inertia=(1.0,) * 3, position=(30, 0, 0))
    model.fixed("ground", "pylon", at=(30, 0, 0))
    model.body("ball", mass=1.0, inertia=(0.1,) * 3, position=(0, 0, 0.1))
    model.bushing(
        "ground", "ball", at=(0, 0, 0.1), stiffness=(across, across, 0), rotational_stiffness=(1e4,) * 3
    )
    at = ((0, 0, 0), (0, 0, 0.1))
    model.sphere_plane_contact("ground", "ball", at=at, normal=Z, radius=0.1, stiffness=k)
    found = lw.linearize(lw.equilibrium(model).model).frequencies
    exact = np.sqrt(1.5 * k * np.cbrt(G / k))
    assert np.abs(found / exact - 1).min() < 1e-4


@pytest.mark.parametrize("near", [0.0, 10.1])
def test_equal_damped_modes_of_a_large_model_are_all_found(near: float) -> None:
    """Pairs of sliders, whose joints have no part in their motion."""
    model, frequencies = lw.Model(gravity=(0, 0, 0)), np.repeat(np.arange(1.0, 51.0), 2)
    for k, w in enumerate(frequencies):
        name, at = f"slider {k}", (0.01 * k, 0, 0)
        model.body(name, mass=1.0, inertia=(1.0,) * 3, position=at)
        model.translational("ground", name, at=at, axis=(1, 0, 0))
        model.translational_spring_damper(
            "ground", name, at=at, axis=(1, 0, 0), stiffness=w * w, damping=0.1 * w
        )
    found = lw.linearize(model, modes=6, near=near)
    exact = [1, 1, 2, 2, 3, 3] if near == 0 else [9, 9, 10, 10, 11, 11]
    assert found.frequencies == pytest.approx(exact, rel=1e-6)
    assert found.damping_ratios == pytest.approx(np.full(6, 0.05), rel=1e-6)


def tilted_body(seed: int) -> tuple[lw.Model, Floats]:
    """One in a plane of any direction, and the axis of that."""
    random = np.random.default_rng(seed)
    axis = random.standard_normal(3)
    model = lw.Model(gravity=(0, 0, 0))
    orientation = lw.rotation.about(random.standard_normal(3), 1.0)
    position = random.standard_normal(3)
    model.body("body", mass=1.0, inertia=(0.06,) * 3, position=position, orientation=orientation)
    model.planar("ground", "body", at=(0, 0, 0), axis=axis)
    return model, axis / np.linalg.norm(axis)


@pytest.mark.parametrize("seed", range(8))
def test_forces_of_a_damped_mode_add_up_to_nothing_in_any_direction(seed: int) -> None:
    model, axis = tilted_body(seed)
    model.linear_damping("ground", "body", at=(1.0, 2.0, 3.0), damping=1.0, rotational_damping=0.1)
    model.rotational_spring_damper("ground", "body", at=(0, 0, 0), axis=axis, stiffness=3.0)
    found = lw.linearize(model)
    free = np.linalg.svd(found.D.toarray())[2][3:]
    for s, x in zip(found.eigenvalues, found.shapes.reshape(-1, 6), strict=True):
        terms = np.array([free @ (A @ x) for A in (s * s * found.M, s * found.C, found.K)])
        assert np.abs(terms.sum(axis=0)).max() <= 1e-11 * max(np.abs(terms).max(), 1e-3)


@pytest.mark.parametrize("seed", range(20))
def test_slow_growth_beside_quick_damping_is_not_neutral(seed: int) -> None:
    """Beside a damper c at the arm d:  (J + m d^2 / (1 + m s / c)) s^2 + c_r s = k."""
    k, c = 0.01, 1e6
    model, axis = tilted_body(seed)
    arm = np.cross(axis, (0.2, 0.5, -0.3))
    at = model.compiled().q0[:3] + arm
    model.linear_damping("ground", "body", at=at, damping=c, rotational_damping=0.1)
    model.rotational_spring_damper("ground", "body", at=(0, 0, 0), axis=axis, stiffness=-k)
    found = lw.linearize(model)
    exact = brentq(lambda s: (0.06 + arm @ arm / (1 + s / c)) * s * s + 0.1 * s - k, 0.0, 1.0, xtol=1e-14)
    assert not found.stable
    assert found.eigenvalues.real.max() == pytest.approx(exact, rel=1e-7)


def test_slow_modes_beside_quick_damping_keep_their_digits() -> None:
    """Two masses on springs k, with dampers between walls and masses:  m s^2 + (2 -+ 1) c s + k = 0."""
    k, c = 1.0, 1e7
    model = row_of_sliders(np.ones(2), np.full(2, k), np.full(2, c))
    model.translational_spring_damper("slider 0", "slider 1", at=(0, 0, 0), axis=(0, 1, 0), damping=c)
    found = lw.linearize(model, modes=2).eigenvalues
    assert found == pytest.approx([-k / (3 * c), -k / c], rel=1e-9)


def test_modes_of_a_small_model_are_those_near_a_frequency() -> None:
    every = lw.linearize(hanging_chain(20)).frequencies
    nearest = np.sort(every[np.argsort(np.abs(every - 30.0))[:3]])
    found = lw.linearize(hanging_chain(20), modes=3, near=30.0).frequencies
    assert nearest[0] > every[0]
    assert found == pytest.approx(nearest, rel=1e-9)


def test_modes_whose_forces_do_not_add_up_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwork.analyses.linearization.SURE", -1.0)
    with pytest.warns(lw.LinkworkWarning, match="3 of 3 modes are not sure; of mode"):
        lw.linearize(damped_chain(3))


@pytest.mark.parametrize(("n", "seed"), [(90, 0), (90, 3), (120, 4), (120, 5)])
def test_one_of_very_many_neutral_modes_is_found(n: int, seed: int) -> None:
    random, model = np.random.default_rng(seed), lw.Model(gravity=(0, 0, 0))
    for k in range(n):
        name, at = f"body {k}", (float(k), 0.0, 0.0)
        model.body(name, mass=1.0, inertia=(1.0,) * 3, position=at)
        stiffness, damping = 10 ** random.uniform(-2, 2, 2)
        if k % 2:
            model.translational("ground", name, at=at, axis=(0, 1, 0))
            model.translational_spring_damper(
                "ground", name, at=at, axis=(0, 1, 0), stiffness=stiffness, damping=damping
            )
        else:
            model.planar("ground", name, at=at, axis=Z)
            if k % 4:
                model.bushing("ground", name, at=(k, 0.3, 0), stiffness=(0.0,) * 3, damping=(damping, 0, 0))
    found = lw.linearize(model, modes=1)
    assert found.frequencies == pytest.approx([0.0]) and found.stable
