"""Linearization of motion along which wheels roll or blades glide."""

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats

G, Y, Z = 9.81, (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def symmetric(xx: float, yy: float, zz: float, xz: float = 0.0) -> Floats:
    """Inertia [kg m2] of what is symmetric about the plane of x and z."""
    return np.array([[xx, 0, xz], [0, yy, 0], [xz, 0, zz]])


def bicycle(
    speed: float, turned: float = 0.0, away: Floats | tuple[float, ...] = (0.0, 0.0, 0.0)
) -> lw.Model:
    """The benchmark of Meijaard, Papadopoulos, Ruina and Schwab (Proc. R. Soc. A 463, 2007), upright and
    straight ahead, turned about the vertical z."""
    A = lw.rotation.matrix(lw.rotation.about(Z, turned))
    model, tilt, base, front = lw.Model(gravity=(0, 0, -G)), np.pi / 10, 1.02, (0.0, 0.0, 0.0)

    def add(name: str, mass: float, inertia: Floats, at: tuple[float, ...], radius: float = np.inf) -> None:
        model.body(name, mass=mass, inertia=inertia, position=A @ at + away, velocity=A @ (speed, 0, 0),
                   orientation=lw.rotation.about(Z, turned), omega=(0, speed / radius, 0))  # fmt: skip

    add("rear wheel", 2.0, symmetric(0.0603, 0.12, 0.0603), (0, 0, 0.3), 0.3)
    add("frame", 85.0, symmetric(9.2, 11.0, 2.8, -2.4), (0.3, 0, 0.9))
    add("fork", 4.0, symmetric(0.05892, 0.06, 0.00708, 0.00756), (0.9, 0, 0.7))
    add("front wheel", 3.0, symmetric(0.1405, 0.28, 0.1405), (base, 0, 0.35), 0.35)
    for wheel, holder, center in (
        ("rear wheel", "frame", (0, 0, 0.3)),
        ("front wheel", "fork", (base, 0, 0.35)),
    ):
        at = A @ center + away
        model.rolling_disc(
            "ground", wheel, at=(np.array(away) + front, at), axes=(Z, A @ Y), radius=center[2]
        )
        model.revolute(holder, wheel, at=at, axis=A @ Y)
    steering = (-np.sin(tilt), 0, np.cos(tilt))
    model.revolute("frame", "fork", at=A @ (base + 0.08, 0, 0) + away, axis=A @ steering, name="head")
    return model


#: Weave, capsize and caster modes [1/s] by speed [m/s], as published.
BENCHMARK = {
    0: [5.53094371765393, 3.13164324790656],
    1: [3.52696170990070 + 0.80774027519930j, -3.13423125066578, -7.11008014637442],
    3: [1.70675605663975 + 2.31582447384325j, -2.63366137253667, -10.35101467245920],
    5: [-0.77534188219585 + 4.46486771378823j, -0.32286642900409, -14.07838969279822],
    10: [-3.72016840437287 + 10.90681139476287j, 0.16105338653172, -24.62459635017404],
}  # fmt: skip


def moving(found: lw.Linearization) -> Floats:
    """Eigenvalues that are not zero."""
    s = found.eigenvalues
    return np.sort_complex(s[np.abs(s) > 0])


@pytest.mark.parametrize("speed", BENCHMARK)
def test_the_bicycle_of_the_benchmark_has_its_modes(speed: int) -> None:
    found = moving(lw.linearize(bicycle(speed)))
    expected = np.sort_complex(np.array(BENCHMARK[speed], complex))
    if speed == 0:  # without damping: of s and -s that which grows, or i omega
        found = np.sort_complex(np.abs(found) + 0j)
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_the_bicycle_balances_itself_between_weave_and_capsize() -> None:
    """4.29238253634111 to 6.02426201538837 m/s."""
    assert [lw.linearize(bicycle(v)).stable for v in (4.2, 4.4, 6.0, 6.1)] == [False, True, True, False]


def test_modes_do_not_depend_on_the_direction_and_the_place() -> None:
    found = moving(lw.linearize(bicycle(5.0, turned=0.8, away=(300.0, -20.0, 0.0))))
    assert found == pytest.approx(np.sort_complex(np.array(BENCHMARK[5])), rel=1e-6)


def test_the_runs_of_the_bicycle_are_what_its_modes_say() -> None:
    """What begins along weave turns the fork as it should: to the square of its size."""
    found, size = lw.linearize(bicycle(5.0)), 1e-4
    mode = int(np.argmax(found.eigenvalues.imag))
    s, x, at = found.eigenvalues[mode], found.shapes[mode], found.snapshot
    q, v = found.displaced(mode, size).compiled().q0.reshape(-1, 7), at.v.copy()
    v[:, :3] += size * (s * x[:, :3]).real
    v[:, 3:] += size * np.einsum("nji,nj->ni", lw.rotation.matrix(at.q[:, 3:]), (s * x[:, 3:]).real)
    start = lw.assemble(bicycle(5.0).with_initial_state(q, v)).model
    angle = lw.simulate(start, 1.0, rtol=1e-10, progress=False).coordinate("head").value
    steered = complex(x[2, 5] - x[1, 5])  # about the vertical
    assert angle[-1] / angle[0] == pytest.approx((np.exp(s) * steered).real / steered.real, rel=1e-5)


def disc(rate: float) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -G))
    model.body("disc", mass=2.0, inertia=(0.03, 0.05, 0.03), position=(0, 0, 0.2),
               velocity=(0.2 * rate, 0, 0), omega=(0, rate, 0))  # fmt: skip
    model.rolling_disc("ground", "disc", at=((0, 0, 0), (0, 0, 0.2)), axes=(Z, Y), radius=0.2)
    return model


@pytest.mark.parametrize("rate", [1.0, 4.0, 20.0])
def test_a_disc_that_rolls_upright_stays_so_when_it_is_fast(rate: float) -> None:
    """s^2 = (m g r I - J (J + m r^2) rate^2) / (I (I + m r^2)), I about a diameter, J about the axle."""
    m, r, across, axle = 2.0, 0.2, 0.03, 0.05
    square = m * G * r * across - axle * (axle + m * r**2) * rate**2
    expected = np.sqrt(complex(square / (across * (across + m * r**2))))
    found = lw.linearize(disc(rate))
    assert np.abs(found.eigenvalues).max() == pytest.approx(abs(expected), rel=1e-9)
    assert found.stable == (square < 0)


@pytest.mark.parametrize("blades", [(-0.3,), (-0.3, -0.3)], ids=["one blade", "another of no use"])
@pytest.mark.parametrize("ahead", [0.3, -0.2])
def test_a_sleigh_on_a_blade_glides_straight_with_the_mass_ahead(
    ahead: float, blades: tuple[float, ...]
) -> None:
    """Chaplygin: s = -m a u / (I + m a^2) with the center of mass by a ahead of the blade."""
    m, inertia, u = 3.0, 0.4, 1.7
    model = lw.Model(gravity=(0, 0, -G))
    model.body("sleigh", mass=m, inertia=(1, 1, inertia), position=(ahead, 0, 0), velocity=(u, 0, 0))
    model.planar("ground", "sleigh", at=(0, 0, 0), axis=Z)
    for _ in blades:
        model.knife_edge("ground", "sleigh", at=(0, 0, 0), axis=Y)
    found = moving(lw.linearize(model))
    assert found == pytest.approx([-m * ahead * u / (inertia + m * ahead**2)], rel=1e-9)


def test_a_blade_that_nothing_turns_glides_on() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("blade", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(1, 0, 0))
    model.knife_edge("ground", "blade", at=(0, 0, 0), axis=Y)
    found = lw.linearize(model)
    assert len(found.eigenvalues) == 11 and not found.eigenvalues.any() and found.stable


def test_a_large_model_that_rolls_has_the_modes_of_the_bicycle_and_of_what_is_on_it() -> None:
    """Ninety pendulums of next to no mass swing on its frame."""
    model, lengths = bicycle(5.0), 0.05 + 0.002 * np.arange(90)
    for k, length in enumerate(lengths):
        model.body(
            f"bob {k}", mass=1e-9, inertia=(0, 0, 0), position=(0.3, 0, 0.9 - length), velocity=(5, 0, 0)
        )
        model.revolute("frame", f"bob {k}", at=(0.3, 0, 0.9), axis=Y)
    found = lw.linearize(model, modes=3, near=5.0).eigenvalues
    slowest = 1j * np.sqrt(G / lengths[-2:][::-1])
    expected = np.append(slowest, BENCHMARK[5][0])
    nearest = np.abs(found[:, None] - expected).argmin(axis=0)
    assert sorted(nearest) == [0, 1, 2]
    assert found[nearest] == pytest.approx(expected, rel=1e-5)


def test_a_disc_that_rolls_in_a_circle_is_not_steady() -> None:
    model = lw.mechanisms.rolling_disc()
    with pytest.raises(lw.ModelError, match="accelerates"):
        lw.linearize(model)


def test_rows_of_velocities_are_given_with_what_displacements_do_to_them() -> None:
    """A disc that heads y by a small angle moves aside: D x' + E x = 0."""
    found = lw.linearize(disc(5.0))
    D, E = found.D.toarray(), found.E.toarray()
    heading, aside = np.eye(6)[5], np.eye(6)[1]
    rolls = np.abs(E).max(axis=1) > 0
    assert np.abs(E[rolls] @ heading).max() == pytest.approx(1.0, rel=1e-9)  # 5 rad/s at 0.2 m
    assert (D @ aside * 1.0 + E @ heading)[rolls] == pytest.approx(0.0, abs=1e-9)
    assert not lw.linearize(disc(0.0)).E.count_nonzero()
