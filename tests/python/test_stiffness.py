"""Steps against stiff force elements: eigenvalues and stability limits in closed form."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from linkwork.equations import stiffness
from linkwork.integrators import METHODS
from random_mechanisms import Mechanism, examples, mechanisms
from test_invariance import UNITS, in_units


def oscillator(stiffness: float, damping: float = 0.0, bodies: int = 1) -> lw.Model:
    """1 kg on a spring along z, in a slide; each of `bodies` on its own."""
    model = lw.Model()
    for k in range(bodies):
        mass = model.body(f"mass {k}", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(k, 0, 1.0))
        model.translational(model.ground, mass, at=(k, 0, 1.0), axis=(0, 0, 1))
        share = 1.0 if k == bodies - 1 else 0.01
        model.spring_damper(
            model.ground, mass, at=((k, 0, 0), (k, 0, 1.0)), stiffness=share * stiffness,
            damping=share * damping,
        )  # fmt: skip
    return model


@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian"])
@pytest.mark.parametrize(("k", "c"), [(1e6, 0.0), (1e6, 200.0), (1e6, 1e4)])
def test_the_fastest_eigenvalue_is_that_of_the_oscillator(k: float, c: float, formulation: str) -> None:
    found = stiffness.fastest(lw.System(oscillator(k, c, bodies=3), formulation=formulation))
    assert found is not None and found.body == "mass 2"
    exact = max(np.roots([1.0, c, k]), key=abs)
    assert found.eigenvalue.real == pytest.approx(exact.real, rel=1e-5, abs=1e-5 * abs(exact))
    assert abs(found.eigenvalue.imag) == pytest.approx(abs(exact.imag), rel=1e-5, abs=1e-5 * abs(exact))


@pytest.mark.parametrize("beside", [5.0, 500.0, 5e4])
@pytest.mark.parametrize("spin", [0.0, 3.0])
def test_what_is_larger_or_faster_beside_a_mechanism_does_not_make_it_stiff(
    beside: float, spin: float
) -> None:
    """A crank of 1 mm against a spring that is far from straight within its arm: phi_ddot = f(phi)."""
    model, mm = lw.Model(gravity=(0, 0, 0)), 1e-3
    crank = model.body("crank", mass=1e-6, inertia=(1e-13,) * 3, position=(mm, 0, 0))
    model.revolute("ground", crank, at=(0, 0, 0), axis=(0, 0, 1))
    model.spring_damper("ground", crank, at=((3 * mm, 0, 0), (mm, 0, 0)), stiffness=40.0, free_length=mm)
    alone = stiffness.fastest(lw.System(model))
    arm = model.body("arm", mass=1e3, inertia=(1e3 * beside**2,) * 3, position=(beside, 0, 0),
                     velocity=(0, 0, -spin * beside), omega=(0, spin, 0))  # fmt: skip
    model.revolute("ground", arm, at=(0, 0, 0), axis=(0, 1, 0))
    found = stiffness.fastest(lw.System(model))
    # pull 40 N/m (l - 1 mm), l = 2 mm here: its arm about the pin grows by 3/2 mm an angle
    rate = np.sqrt(40.0 * mm * 1.5 * mm / (1e-6 * mm**2 + 1e-13))
    assert alone is not None and found is not None and found.body == "crank"
    assert abs(alone.eigenvalue) == pytest.approx(rate, rel=1e-5)
    assert abs(found.eigenvalue) == pytest.approx(rate, rel=1e-5)


@pytest.mark.parametrize("place", [(0, 0, 0), (10, 7, 3)])
@pytest.mark.parametrize("beside", [False, True])
@pytest.mark.parametrize(("k", "c"), [(1e3, 10.0), (1e9, 10.0), (1e3, 0.0)])
def test_the_fastest_eigenvalue_at_rest_is_that_of_the_springs(
    k: float, c: float, beside: bool, place: tuple[float, float, float]
) -> None:
    """A ball on three pairs of springs that are free: 2 k and 2 c along each axis."""
    for seed in range(5):
        model = lw.Model(gravity=(0, 0, 0))
        axes = np.linalg.qr(np.random.default_rng(seed).standard_normal((3, 3)))[0]
        ball = model.body("ball", mass=1.0, inertia=(0.1,) * 3, position=place)
        for axis in [*axes, *-axes]:
            model.spring_damper("ground", ball, at=(place + axis, place), stiffness=k, damping=c)
        if beside:
            model.body("spinner", mass=1.0, inertia=(0.1, 0.2, 0.3), position=(50, 0, 0), omega=(1, 2, 3))
        found = stiffness.fastest(lw.System(model))
        assert found is not None and found.body == "ball"
        assert abs(found.eigenvalue) == pytest.approx(max(abs(np.roots([1, 2 * c, 2 * k]))), rel=1e-4)


@pytest.mark.parametrize("c", [0.0, 2e4])
def test_a_step_beyond_the_limit_of_rk4_is_refused_and_one_below_is_stable(c: float) -> None:
    """|h lambda| <= 2.828 on the imaginary axis, 2.785 on the real one."""
    k = 1e6
    rate = float(max(abs(np.roots([1.0, c, k]))))
    limit = (2.785 if c else 2.828) / rate
    with pytest.raises(lw.OptionError, match=rf"'rk4'.*'mass 0'.*about {limit:.2g}"):
        lw.simulate(oscillator(k, c), 100 * limit, 1.1 * limit, progress=False)
    result = lw.simulate(oscillator(k, c), 100 * limit, 0.98 * limit, on_inaccurate="pass", progress=False)
    assert np.abs(result.position).max() < 1.1


def test_the_limit_of_each_method_is_where_its_growth_begins() -> None:
    for method in METHODS.values():
        if growth := getattr(method, "growth", None):
            limit = stiffness.stable_step(growth, -1000.0, 1.0)
            assert growth(0.5 * 1000 * 0.99 * limit, 0.0) <= stiffness.GROWTH, method.name


def test_the_flyball_governor_needs_the_step_that_its_springs_allow() -> None:
    """Measured: RK4 needs h < 3.4e-4 s (IFToMM benchmark A05)."""
    found = stiffness.fastest(lw.System(lw.mechanisms.flyball_governor()))
    assert found is not None
    limit = stiffness.stable_step(METHODS["rk4"].growth, found.eigenvalue, 1.0)
    assert limit == pytest.approx(3.4e-4, rel=0.1)


def test_without_force_elements_and_with_soft_ones_every_step_is_let_through() -> None:
    assert stiffness.fastest(lw.System(lw.mechanisms.spatial_slider_crank())) is None
    lw.simulate(oscillator(1.0), 1.0, 0.1, "euler", on_inaccurate="pass", progress=False)


@pytest.mark.parametrize("units", ["g mm s", "kg mm ms", "mg km min"])
@examples(15)
@given(mechanism=mechanisms(most=6, forces=("spring_damper", "rotational_spring_damper", "bushing")))
def test_the_fastest_eigenvalue_does_not_depend_on_units(mechanism: Mechanism, units: str) -> None:
    to = UNITS[units]
    found, scaled = (stiffness.fastest(lw.System(it.model)) for it in (mechanism, in_units(mechanism, to)))
    if found is None or scaled is None:
        assert found is scaled is None
    else:
        assert abs(scaled.eigenvalue) * to.s == pytest.approx(abs(found.eigenvalue), rel=1e-3, abs=1e-3)


@pytest.mark.parametrize("length", [1.0, 1e-3, 1e-7, 1e4])
def test_the_fastest_eigenvalue_of_one_ball_on_an_incline_does_not_depend_on_the_unit_of_length(
    length: float,
) -> None:
    model = lw.Model(gravity=(0, 0, -9.81 * length))
    z = (0.1 - 1e-5) * length
    ball = model.body("ball", mass=1.0, inertia=(0.004 * length**2,) * 3, position=(0, 0, z))
    model.sphere_plane_contact(
        model.ground, ball, at=((0, 0, 0), (0, 0, z)), normal=(0.1, 0, 1), radius=0.1 * length,
        stiffness=1e5 * length**-0.5, hysteresis=0.3, friction=0.3, transition=1e-2 * length,
    )  # fmt: skip
    found = stiffness.fastest(lw.System(model))
    assert found is not None
    # friction at rest, mu K d^(3/2) / transition, against the ball's mass and its turning
    depth = 0.1 - (0.1 - 1e-5) / np.sqrt(1.01)
    rate = 0.3 * 1e5 * depth**1.5 / 1e-2 * (1 / 1.0 + (0.1 - depth) ** 2 / 0.004)
    assert found.eigenvalue.real == pytest.approx(-rate, rel=1e-6)
    assert found.eigenvalue.imag == pytest.approx(0.0, abs=1e-6 * rate)
