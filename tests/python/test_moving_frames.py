"""A uniform motion of everything changes no verdict (Galilei), and what rests is judged by its size."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from linkwork.arrays import Floats

AMPLITUDE, OMEGA = 1e-3, 2 * np.pi  # m, rad/s


def quick(model: lw.Model, t_end: float, **how: Any) -> lw.Result:
    return lw.simulate(model, t_end, **{"progress": False, "on_inaccurate": "pass", **how})


def found(result: lw.Result) -> lw.Verdict:
    assert result.verdict is not None
    return result.verdict


def told(result: lw.Result) -> float:
    return found(result).error


# --- mechanisms that nothing on the ground sees, by their velocity ---


def slosh(v0: Floats) -> lw.Model:
    """A satellite of 500 kg with 1 kg on a spring: z_b - z_a - 1 = A sin(omega t) [m]."""
    model = lw.Model(gravity=(0, 0, 0))
    m, n = 500.0, 1.0
    back = AMPLITUDE * OMEGA * n / (m + n)
    bus = model.body("bus", mass=m, inertia=(100,) * 3, velocity=v0 - np.array([0, 0, back]))
    mass = model.body("mass", mass=n, inertia=(0.01,) * 3, position=(0, 0, 1),
                      velocity=v0 + np.array([0, 0, AMPLITUDE * OMEGA - back]))  # fmt: skip
    model.translational(bus, mass, at=(0, 0, 1), axis=(0, 0, 1), name="guide")
    model.translational_spring_damper(
        bus, mass, at=(0, 0, 1), axis=(0, 0, 1), stiffness=OMEGA**2 * m * n / (m + n)
    )
    return model


def tumbling(v0: Floats) -> lw.Model:
    """Two bodies on a ball joint without weight."""
    model = lw.Model(gravity=(0, 0, 0))
    a = model.body("a", mass=2.0, inertia=(0.1, 0.2, 0.25), velocity=v0, omega=(0, 1, 0.4))
    b = model.body("b", mass=1.0, inertia=(0.05, 0.1, 0.1), position=(1, 0, 0),
                   velocity=v0 + np.array([0, 0.2, -0.5]))  # fmt: skip
    model.spherical(a, b, at=(0.5, 0, 0))
    return model


def truck(v0: Floats) -> lw.Model:
    """A body on springs on an axle, along rails on the ground, under its weight."""
    model, along = lw.Model(), np.array([v0[0], 0, 0])
    axle = model.body("axle", mass=100.0, inertia=(10,) * 3, velocity=along)
    load = model.body("load", mass=400.0, inertia=(50,) * 3, position=(0, 0, 1), velocity=along)
    model.translational(model.ground, axle, at=(0, 0, 0), axis=(1, 0, 0))
    model.translational(axle, load, at=(0, 0, 1), axis=(0, 0, 1))
    model.translational_spring_damper(axle, load, at=(0, 0, 1), axis=(0, 0, 1), stiffness=4e4, damping=400.0)
    return model


MECHANISMS = (slosh, tumbling, truck)


@pytest.mark.parametrize("make", MECHANISMS)
@given(speed=st.floats(0.0, 1e4), x=st.floats(-1, 1), y=st.floats(-1, 1))
@settings(max_examples=4, deadline=None)
def test_a_uniform_motion_of_everything_changes_no_verdict(
    make: Callable[[Floats], lw.Model], speed: float, x: float, y: float
) -> None:
    """But by what rounding makes of the choice of the steps that are taken again."""
    for how in ({"step": 0.1}, {"step": 0.05, "integrator": "heun"}, {"step": 0.02, "integrator": "ab3"}):
        still, moving = (told(quick(make(v * np.array([x, y, 0])), 2.0, **how)) for v in (0.0, speed))
        assert moving == pytest.approx(still, rel=0.3, abs=1e-6), how


@pytest.mark.parametrize("how", [{}, {"integrator": "dop853"}, {"verify": True}])
@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("speed", [0.0, 30.0, 7600.0])
def test_a_vibration_is_judged_by_itself_however_fast_what_vibrates_flies(
    speed: float, rtol: float, how: dict[str, Any]
) -> None:
    result = quick(slosh(np.array([speed, 0, 0])), 5.0, rtol=rtol, **how)
    value = result.coordinate("guide").value
    true = np.abs(value - AMPLITUDE * np.sin(OMEGA * result.t)).max() / AMPLITUDE
    assert told(result) > min(true, 0.1) / 3
    assert true < 0.01 or found(result).level != "good"


def at_rest(model: lw.Model) -> None:
    model.body("marker", mass=1e-3, inertia=(1e-6,) * 3, position=(0, 5, 0))


def on_the_ground(model: lw.Model) -> None:
    at_rest(model)
    model.fixed(model.ground, "marker", at=(0, 5, 0))


def flying_past(model: lw.Model) -> None:
    model.body("other", mass=10.0, inertia=(1.0,) * 3, position=(0, 50, 0), velocity=(-20.0, 10.0, 0))


@pytest.mark.parametrize("beside", [at_rest, on_the_ground, flying_past])
@pytest.mark.parametrize("make", [slosh, tumbling])
@pytest.mark.parametrize("speed", [0.0, 30.0, 7600.0])
def test_what_rests_or_flies_beside_it_changes_no_verdict(
    make: Callable[[Floats], lw.Model], beside: Callable[[lw.Model], None], speed: float
) -> None:
    alone, both = make(np.array([speed, 0, 0])), make(np.array([speed, 0, 0]))
    beside(both)
    for how in ({"step": 0.05, "integrator": "heun"}, {"step": 0.1, "verify": True}):
        expected = told(quick(alone, 2.0, **how))
        assert told(quick(both, 2.0, **how)) == pytest.approx(expected, rel=0.05), how


@pytest.mark.parametrize("how", [{}, {"verify": True}])
@pytest.mark.parametrize("speed", [30.0, 7600.0])
def test_a_vibration_beside_a_body_at_rest_is_judged_by_itself(speed: float, how: dict[str, Any]) -> None:
    model = slosh(np.array([speed, 0, 0]))
    on_the_ground(model)
    result = quick(model, 5.0, rtol=1e-4, **how)
    value = result.coordinate("guide").value
    assert np.abs(value - AMPLITUDE * np.sin(OMEGA * result.t)).max() > 0.1 * AMPLITUDE
    assert found(result).level == "wrong"


def test_tolerances_for_a_speed_of_everything_are_told_as_such() -> None:
    said = found(quick(slosh(np.array([7600.0, 0, 0])), 5.0, rtol=1e-6)).sentence
    assert "is relative to speeds in space, and the mechanism moves as a whole at" in said
    assert "relative to speeds" not in found(quick(slosh(np.zeros(3)), 5.0, rtol=1e-3)).sentence


@pytest.mark.parametrize("how", [{"step": 1e-2}, {"step": 1e-3}, {"rtol": 1e-6}])
@pytest.mark.parametrize("offset", [0.0, 1e6])
def test_what_flies_without_a_motion_of_its_own_is_no_error(offset: float, how: dict[str, Any]) -> None:
    model, v0 = lw.Model(gravity=(0, 0, 0)), (7600.0, 100.0, 0)
    a = model.body("a", mass=2.0, inertia=(0.1,) * 3, position=(offset, 0, 0), velocity=v0)
    b = model.body("b", mass=1.0, inertia=(0.1,) * 3, position=(offset + 1, 0, 0), velocity=v0)
    model.fixed(a, b, at=(offset + 0.5, 0, 0))
    assert told(quick(model, 10.0, **how)) < 1e-4


def test_a_stone_that_is_thrown_is_exact() -> None:
    model = lw.Model()
    model.body("stone", mass=1.0, inertia=(0.1,) * 3, velocity=(300.0, 0, 40.0))
    assert told(quick(model, 8.0, step=0.05)) < 1e-9


# --- at rest ---


def on_a_plane(hysteresis: float) -> lw.Model:
    model = lw.Model()
    ball = model.body("ball", mass=1.0, inertia=(0.004,) * 3, position=(0, 0, 0.12))
    model.sphere_plane_contact(model.ground, ball, at=((0, 0, 0), (0, 0, 0.12)), normal=(0, 0, 1), radius=0.1,
                               stiffness=1e6, hysteresis=hysteresis, friction=0.3)  # fmt: skip
    return lw.equilibrium(model).model


def in_a_groove(hysteresis: float) -> lw.Model:
    model = lw.Model()
    ball = model.body("ball", mass=1.0, inertia=(0.004,) * 3, position=(0, 0, 0.17))
    for side in (1, -1):
        model.sphere_plane_contact(
            model.ground, ball, at=((0, 0, 0), (0, 0, 0.17)), normal=(side * np.sqrt(0.5), 0, np.sqrt(0.5)),
            radius=0.1, stiffness=1e6, hysteresis=hysteresis, friction=0.3,
        )  # fmt: skip
    return lw.equilibrium(model).model


@pytest.mark.parametrize("how", [{"rtol": 1e-2}, {"rtol": 1e-6}, {"rtol": 1e-8, "verify": True}])
@pytest.mark.parametrize("hysteresis", [0.0, 0.3])
@pytest.mark.parametrize("make", [on_a_plane, in_a_groove])
def test_what_rests_is_off_by_what_the_run_moved_it(
    make: Callable[[float], lw.Model], hysteresis: float, how: dict[str, Any]
) -> None:
    result = quick(make(hysteresis), 0.4, **how)
    moved = np.abs(result.q - result.q[0]).max() / 0.1
    speed = np.abs(result.v).max() / np.sqrt(9.81 * 0.1)
    assert told(result) <= 20 * max(moved, speed) + 1e-15


def test_a_vibration_of_ten_nanometers_is_no_rest() -> None:
    model = lw.Model()
    body = model.body("body", mass=1.0, inertia=(0.1,) * 3, position=(0, 0, 0))
    where: dict[str, Any] = {"at": (0.5, 0, 0), "axis": (0, 0, 1)}
    model.translational(model.ground, body, **where)
    model.translational_spring_damper(model.ground, body, **where, stiffness=1e4, force=9.81 + 1e4 * 1e-8)
    assert found(quick(model, 1.0, step=0.018)).level == "wrong"


def test_what_a_driver_moves_by_ten_nanometers_is_no_rest() -> None:
    """A load on a spring whose foot moves by that: where both are in the first pose, so is the spring."""
    model, moved = lw.Model(), 1e-8
    foot = model.body("foot", mass=1.0, inertia=(0.1, 0.1, 0.1))
    load = model.body("load", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.1, 0, 0))
    model.translational("ground", foot, at=(0, 0, 0), axis=(1, 0, 0))
    along = {"at": (0.05, 0, 0), "axis": (1, 0, 0)}
    model.translational(foot, load, **along)
    model.translational_spring_damper(foot, load, **along, stiffness=400.0)
    there = lw.functions.cycloidal(moved, 1.0, 1.0)
    model.displacement_driver("ground", foot, at=(0, 0, 0), axis=(1, 0, 0), displacement=there)
    run = quick(model, 40.0, step=0.02, integrator="heun")
    assert run.position[:, 1, 0].max() > 0.1 + 2 * moved  # in truth it swings by no more than that
    assert found(run).level == "wrong"
