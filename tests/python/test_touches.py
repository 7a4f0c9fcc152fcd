"""Contacts and stops that come and go within what a free motion takes for a step."""

import linkwork as lw
import numpy as np
import pytest
from recorded import PAIRS

RADIUS, SPEED = 0.01, 10.0


def two_spheres(distance: float, beside: float = 0.0) -> lw.Model:
    """Without weight; one comes along x and meets the other, at rest."""
    model = lw.Model(gravity=(0, 0, 0))
    there = (distance, beside, 0)
    model.body("a", mass=0.01, inertia=(4e-7,) * 3, velocity=(SPEED, 0, 0))
    model.body("b", mass=0.01, inertia=(4e-7,) * 3, position=there)
    model.sphere_sphere_contact(
        "a", "b", at=((0, 0, 0), there), radius_a=RADIUS, radius_b=RADIUS, stiffness=1e9
    )
    return model


def end(model: lw.Model, t_end: float, pair: str) -> lw.Result:
    rtol = 1e-7 if pair == "bs32" else 1e-8
    return lw.simulate(model, t_end, rtol=rtol, integrator=pair, progress=False)


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("distance", [0.5, 3.0, 20.0, 51.7])
def test_equal_spheres_exchange_their_velocities_however_far_they_come(distance: float, pair: str) -> None:
    result = end(two_spheres(distance), 1.5 * distance / SPEED, pair)
    assert result.v[-1, :, 0] == pytest.approx([0.0, SPEED], abs=1e-4)
    assert result.verdict.level == "good"


@pytest.mark.parametrize("pair", PAIRS)
def test_an_oblique_collision_does_not_depend_on_the_flight_before(pair: str) -> None:
    near, far = (end(two_spheres(d, 0.01), 1.5 * d / SPEED, pair).v[-1] for d in (0.1, 40.0))
    assert far == pytest.approx(near, abs=1e-4)


@pytest.mark.parametrize("beside", [2.001 * RADIUS, 0.1])
def test_spheres_that_pass_each_other_do_not_touch(beside: float) -> None:
    result = end(two_spheres(20.0, beside), 3.0, "dopri5")
    assert result.v[-1, :, 0].tolist() == [SPEED, 0.0]


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("gap", [0.3, 0.03, 0.003])
def test_what_is_thrown_at_a_ceiling_comes_back_by_its_law(gap: float, pair: str) -> None:
    """Up at 4 m/s; it is at the ceiling for as long as a stiff spring takes to turn it round."""
    top, stiffness, g = 4.0**2 / (2 * 9.81) - gap, 1e8, 9.81
    model = lw.Model(gravity=(0, 0, -g))
    model.body("b", mass=0.1, inertia=(4e-5,) * 3, velocity=(1, 0, 4))
    model.translational_stop(
        "ground", "b", at=(0, 0, 0), axis=(0, 0, 1), lower=-100, upper=top, stiffness=stiffness
    )
    met, omega = np.sqrt(2 * g * gap), np.sqrt(stiffness / 0.1)
    rise, contact = (4 - met) / g, (np.pi - 2 * np.arctan(g / omega / met)) / omega
    result = end(model, 0.9, pair)
    assert result.v[-1, 0, 2] == pytest.approx(-met - g * (0.9 - rise - contact), abs=1e-5)


@pytest.mark.parametrize("beside", [0.0, 0.015])
def test_fixed_steps_tell_where_bodies_pass_through_each_other(beside: float) -> None:
    result = lw.simulate(two_spheres(5.13, beside), 1.0, 0.02, on_inaccurate="pass", progress=False)
    assert result.v[-1, 1, 0] == 0.0  # as nothing stopped the other
    assert result.verdict.level == "wrong"
    assert "pass through each other at contact 'sphere_sphere_contact 1' at t = 0.5 s" in str(result.verdict)
    (passed,) = result.statistics["passed_touches"]
    assert (passed["t"], passed["steps"]) == (pytest.approx(0.5), 1)
    with pytest.warns(lw.LinkworkWarning, match="pass through each other"):
        lw.simulate(two_spheres(5.13, beside), 1.0, 0.02, progress=False)


@pytest.mark.parametrize("beside", [2.001 * RADIUS, 0.1])
def test_fixed_steps_tell_nothing_of_bodies_that_pass_by(beside: float) -> None:
    result = lw.simulate(two_spheres(5.13, beside), 1.0, 0.02, progress=False)
    assert result.verdict.level == "good"
    assert "passed_touches" not in result.statistics


def test_members_of_ensembles_tell_it_too() -> None:
    models = [two_spheres(5.13, beside) for beside in (0.0, 0.005, 0.1)]
    found = lw.simulate_many(models, None, 1.0, 0.02, threads=1, on_inaccurate="pass", progress=False)
    assert found.alone == {}
    assert [found.member(k).verdict.level for k in range(3)] == ["wrong", "wrong", "good"]
