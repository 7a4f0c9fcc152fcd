"""Which motions look the same at all times, and have frequencies, and which do not."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import linkwork as lw
import numpy as np
import pytest
from linkwork.analyses import steadiness
from linkwork.constraints.equations import Equations

Z = (0.0, 0.0, 1.0)


def on_a_shaft(
    model: lw.Model, stiffness: tuple[float, float], *, spin: float = 7.0, torsion: float = 50.0,
    damping: float = 0.0, x: float = 0.0, tilt: float = 0.0,
) -> lw.Model:  # fmt: skip
    """A disc of 2 kg on an elastic shaft that turns in a rigid bearing; stiffness in axes of the shaft."""
    p = lw.rotation.about((1, 2, 0), tilt)
    axis, at, k = lw.rotation.matrix(p)[:, 2], (x, 0, 0), model.body_count
    place = {"position": at, "orientation": p, "omega": (0, 0, spin)}
    shaft = model.body(f"shaft {k}", mass=1.0, inertia=(0.01,) * 3, **place)
    disc = model.body(f"disc {k}", mass=2.0, inertia=(0.02, 0.02, 0.04), **place)
    model.revolute("ground", shaft, at=at, axis=axis, name=f"bearing {k}")
    model.planar("ground", disc, at=at, axis=axis)
    model.bushing(
        shaft, disc, at=at, orientation=p, stiffness=(*stiffness, 0.0), damping=(damping, damping, 0.0),
        rotational_stiffness=(0, 0, torsion), rotational_damping=(0, 0, 0.1),
    )  # fmt: skip
    return model


def block_on_a_spring(model: lw.Model, stiffness: float) -> lw.Model:
    model.body("block", mass=1.0, inertia=(0.01,) * 3, position=(-1, 0, 0))
    model.translational("ground", "block", at=(-1, 0, 0), axis=(1, 0, 0))
    model.translational_spring_damper("ground", "block", at=(-1, 0, 0), axis=(1, 0, 0), stiffness=stiffness)
    return model


@pytest.mark.parametrize("tilt", [0.0, 0.7])
@pytest.mark.parametrize("torsion", [5.0, 1e4, 1e8])
@pytest.mark.parametrize("stiffness", [(80.0, 120.0), (99.0, 101.0)])
def test_a_flat_shaft_has_no_frequencies_however_stiff_its_torsion_is(
    stiffness: tuple[float, float], torsion: float, tilt: float
) -> None:
    """It grows between sqrt(k_1 / m) and sqrt(k_2 / m) of speed, which no constant coefficients tell."""
    model = on_a_shaft(lw.Model(gravity=(0, 0, 0)), stiffness, torsion=torsion, tilt=tilt)
    with pytest.raises(lw.ModelError, match="stiffness changes with time"):
        lw.linearize(model)


@pytest.mark.parametrize("others", [0, 45])
@pytest.mark.parametrize("stiff", [1e4, 1e10])
def test_a_flat_shaft_has_no_frequencies_beside_whatever_is_stiff(stiff: float, others: int) -> None:
    model = block_on_a_spring(on_a_shaft(lw.Model(gravity=(0, 0, 0)), (80.0, 120.0)), stiff)
    for k in range(others):
        on_a_shaft(model, (100.0, 100.0), spin=5.0 + k, x=k + 1.0)
    with pytest.raises(lw.ModelError, match="stiffness changes with time"):
        lw.linearize(model)


@pytest.mark.parametrize("quick", [20.0, 2e4])
def test_a_slow_flat_shaft_has_no_frequencies_beside_a_quick_round_one(quick: float) -> None:
    model = on_a_shaft(lw.Model(gravity=(0, 0, 0)), (80.0, 120.0), spin=0.3)
    on_a_shaft(model, (100.0, 100.0), spin=quick, x=1.0)
    with pytest.raises(lw.ModelError, match="stiffness changes with time"):
        lw.linearize(model)


@pytest.mark.parametrize("tilt", [0.0, 0.7])
@pytest.mark.parametrize("spin", [5.0, 12.0])
def test_a_round_shaft_with_damping_inside_whirls_as_its_closed_form_says(spin: float, tilt: float) -> None:
    """m z'' + c (z' - i Omega z) + k z = 0: it grows above the critical speed sqrt(k / m)."""
    model = block_on_a_spring(lw.Model(gravity=(0, 0, 0)), 1e8)
    found = lw.linearize(on_a_shaft(model, (100.0, 100.0), spin=spin, torsion=1e4, damping=1.0, tilt=tilt))
    for s in np.roots([2.0, 1.0, 100.0 - 1j * spin]):
        assert np.abs(found.eigenvalues - (s.real + 1j * abs(s.imag))).min() < 1e-7
    assert found.stable == (spin < np.sqrt(50.0))


def rotor_in_a_house(inertia: tuple[float, float, float], *, slides: bool = False) -> lw.Model:
    """On unequal springs, or on one along a rail."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("house", mass=5.0, inertia=(0.2, 0.2, 0.2))
    model.bushing("ground", "house", at=(0, 0, 0), stiffness=(1e4, 2e4, 3e4),
                  rotational_stiffness=(300, 700, 500))  # fmt: skip
    if slides:
        model.translational("ground", "house", at=(0, 0, 0), axis=(1, 0, 0))
    model.body("rotor", mass=2.0, inertia=inertia, omega=(0, 0, 50.0))
    model.revolute("house", "rotor", at=(0, 0, 0), axis=Z, name="shaft")
    return model


def test_a_round_rotor_on_unequal_springs_has_frequencies() -> None:
    """(J s^2 + k_x) (J s^2 + k_y) + (J_3 Omega s)^2 = 0."""
    found = lw.linearize(rotor_in_a_house((0.05, 0.05, 0.08))).frequencies
    J, G = 0.25, 0.08 * 50.0
    exact = np.sqrt(-np.roots([J * J, J * (300 + 700) + G * G, 300.0 * 700.0]))
    for frequency in exact:
        assert np.abs(found - frequency).min() < 1e-6 * frequency


def test_a_rotor_with_two_blades_has_none_unless_its_house_does_not_tilt() -> None:
    blades = (0.01, 0.08, 0.085)
    with pytest.raises(lw.ModelError, match="inertia and damping change with time"):
        lw.linearize(rotor_in_a_house(blades))
    found = lw.linearize(rotor_in_a_house(blades, slides=True))
    assert found.frequencies[-1] == pytest.approx(np.sqrt(1e4 / 7.0), rel=1e-7)


def test_what_is_in_balance_for_the_moment_only_accelerates() -> None:
    """A balance wheel as it passes its middle, a bead as it passes the anchor of its spring."""
    wheel, bead = lw.Model(gravity=(0, 0, 0)), lw.Model(gravity=(0, 0, 0))
    wheel.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1), omega=(0, 0, 3.0))
    wheel.revolute("ground", "wheel", at=(0, 0, 0), axis=Z)
    wheel.rotational_spring_damper("ground", "wheel", axis=Z, stiffness=5.0)
    bead.body("bead", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(3.0, 0, 0))
    bead.translational("ground", "bead", at=(0, 0, 0), axis=(1, 0, 0))
    bead.spring_damper("ground", "bead", at=((0, 1, 0), (0, 0, 0)), stiffness=5.0)
    for model in (wheel, bead):
        with pytest.raises(lw.ModelError, match="accelerates: body"):
            lw.linearize(model)


def test_a_pendulum_swings_on_a_carriage_that_glides_as_on_one_that_rests() -> None:
    model, arm = lw.Model(), 0.5
    model.body("carriage", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(3.0, 0, 0))
    model.translational("ground", "carriage", at=(0, 0, 0), axis=(1, 0, 0))
    model.body("bob", mass=2.0, inertia=(0.01,) * 3, position=(0, 0, -arm), velocity=(3.0, 0, 0))
    model.revolute("carriage", "bob", at=(0, 0, 0), axis=(0, 1, 0))
    exact = np.sqrt(2 * 9.81 * arm / (0.01 + 2 * arm**2 * 1.0 / 3.0))
    assert lw.linearize(model).frequencies[-1] == pytest.approx(exact, rel=1e-7)


def test_a_stiff_torsion_spring_between_two_tilted_shafts_bends_them_by_nothing() -> None:
    """Its coupling with soft tilts is the rounding of a stiffness, and not that of the steps."""
    from linkwork.analyses.stiffness import stiffness
    from linkwork.constraints.equations import Equations

    model, k = lw.Model(gravity=(0, 0, 0)), 4.4e6
    turned = lw.rotation.about((1, -2, 3), 0.9)
    for name in ("one", "other"):
        model.body(name, mass=1.0, inertia=(0.01,) * 3, orientation=turned)
    # across the relative turn along which the length of steps is tried, nearly
    turn = np.random.default_rng(0).uniform(0.5, 1.0, 12).reshape(2, 6)[:, 3:]
    axis = np.cross(turn[1] - turn[0], (0.3, -0.4, 0.9))
    axis += 3e-5 * (turn[1] - turn[0])
    model.rotational_spring_damper("one", "other", axis=axis, stiffness=k)
    q, rest = np.array(model.compiled().q0), np.zeros(12)
    K = stiffness(Equations(model), 0.0, q, rest, np.zeros(0)).toarray()
    n = axis / np.linalg.norm(axis)
    assert np.abs(K[3:6, 3:6] - k * np.outer(n, n)).max() < 1e-8 * k


def test_a_model_without_a_name_is_called_the_model(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwork.analyses.equilibrium.ALL_ITERATIONS", 20)  # it falls for ever
    model = lw.Model()
    model.body("falls", mass=1.0, inertia=(0.1, 0.1, 0.1))
    for analysis in (lw.linearize, lw.equilibrium, lambda model: lw.kinematics(model, [0.0, 1.0])):
        with pytest.raises(lw.LinkworkError, match="the model[^']*(body|freedoms|6)"):
            analysis(model)


def test_without_damping_the_growing_one_of_a_pair_is_listed() -> None:
    """Of an inverted pendulum s and -s; with the least damping both."""
    model = lw.Model()
    model.body("bob", mass=1.0, inertia=(0.01,) * 3, position=(0, 0, 0.5))
    model.revolute("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    s = np.sqrt(9.81 * 0.5 / 0.26)
    assert lw.linearize(model).eigenvalues == pytest.approx([s], rel=1e-9)
    model.rotational_spring_damper("ground", "bob", axis=(0, 1, 0), damping=1e-6)
    assert np.sort(lw.linearize(model).eigenvalues.real) == pytest.approx([-s, s], rel=1e-5)


@pytest.mark.parametrize(("length", "creeps", "counts"), [(1e3, 1e-4, False), (1e-3, 1e-4, True)])
def test_a_creep_counts_by_the_size_of_the_mechanism(length: float, creeps: float, counts: bool) -> None:
    """Beside a body that turns at 1 rad/s, another moves so many of its own sizes in a second."""
    x_dot = np.zeros(12)
    x_dot[3], x_dot[6] = 1.0, creeps  # [rad/s], [m/s]
    left = steadiness._without_rests(cast(Any, SimpleNamespace(length=length)), x_dot, 1.0)
    assert left[3] == 1.0
    assert left[6] == (creeps if counts else 0.0)


@pytest.mark.parametrize("size", [0.01, 1.0])
def test_a_body_that_slides_is_looked_at_again_when_it_has_moved_by_its_own_sizes(size: float) -> None:
    model, speed = lw.Model(gravity=(0, 0, 0)), 3.0
    block = model.body("block", mass=1.0, inertia=(size**2 / 6,) * 3, velocity=(speed, 0, 0))
    model.translational("ground", block, at=(0, 0, 0), axis=(1, 0, 0))
    eq = Equations(model)
    (time,) = steadiness._times(eq, np.array([speed, 0, 0, 0, 0, 0]), speed / eq.arms[0])
    assert eq.arms[0] == pytest.approx(size / 2)  # the radius of gyration, sqrt(tr J / 2 m)
    assert time * speed == pytest.approx(steadiness.TURN * eq.arms[0])
