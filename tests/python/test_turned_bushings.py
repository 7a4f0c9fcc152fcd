"""Bushings beyond half a turn, where their torque changes its sign: runs and analyses say so."""

from __future__ import annotations

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest

BEYOND = "'bushing': turned beyond half a turn by t = "
INERTIA, STIFFNESS = 0.1, 1.0


def rotor(omega: float, axis: Any = (0, 0, 1), on: str = "ground", **more: Any) -> lw.Model:
    """Held by a bushing alone, it swings to omega sqrt(J / k) [rad] about the axis."""
    axis = np.array(axis) / np.linalg.norm(axis)
    model = lw.Model(gravity=(0, 0, 0))
    base = model.body("base", mass=1e9, inertia=(1e9,) * 3, orientation=lw.rotation.about((1, 2, 3), 2.5))
    body = model.body("rotor", mass=1.0, inertia=(INERTIA,) * 3, omega=omega * axis)
    stiffness = {"rotational_stiffness": (STIFFNESS,) * 3, **more}
    model.bushing("ground" if on == "ground" else base, body, at=(0, 0, 0), name="bushing", **stiffness)
    return model


def told(call: Any) -> list[str]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    return [str(it.message) for it in caught if "half a turn" in str(it.message)]


@pytest.mark.parametrize("axis", [(0, 0, 1), (1, -2, 0.5)])
@pytest.mark.parametrize("on", ["ground", "base"])
@pytest.mark.parametrize("method", [{"rtol": 1e-8}, {"step": 1e-2}])
def test_a_run_says_when_a_bushing_passes_half_a_turn(axis: Any, on: str, method: Any) -> None:
    """Up to there phi = w0 sqrt(J / k) sin(sqrt(k / J) t)."""
    rate, omega = np.sqrt(STIFFNESS / INERTIA), 12.0
    (text,) = told(lambda: lw.simulate(rotor(omega, axis, on), 1.0, on_inaccurate="pass", **method))
    assert text.startswith(BEYOND)
    passes = np.arcsin(np.pi * rate / omega) / rate
    assert float(text.removeprefix(BEYOND).split()[0]) == pytest.approx(passes, abs=2e-2)


@pytest.mark.parametrize("other", ["ground", "rotor that turns the other way"])
def test_it_says_so_of_its_first_body_too(other: str) -> None:
    """Of two that turn against each other by w0 sqrt(J / 2k) sin(sqrt(2k / J) t) each, about one axis."""
    axis, omega, both = np.array((1.0, -2.0, 0.5)) / np.sqrt(5.25), 12.0, other != "ground"
    model = lw.Model(gravity=(0, 0, 0))
    names = ["rotor", other][: 1 + both]
    for name, sign in zip(names, (1, -1), strict=False):
        model.body(name, mass=1.0, inertia=(INERTIA,) * 3, omega=sign * omega * axis)
    stiffness = (STIFFNESS,) * 3
    model.bushing("rotor", other, at=(0, 0, 0), name="bushing", rotational_stiffness=stiffness)
    (text,) = told(lambda: lw.simulate(model, 1.0, rtol=1e-8, on_inaccurate="pass"))
    rate = np.sqrt((1 + both) * STIFFNESS / INERTIA)
    passes = np.arcsin(np.pi / (1 + both) * rate / omega) / rate
    assert float(text.removeprefix(BEYOND).split()[0]) == pytest.approx(passes, abs=5e-3)


@pytest.mark.parametrize("reach", [0.95, 0.999])
def test_swings_that_stay_below_are_silent(reach: float) -> None:
    omega = reach * np.pi * np.sqrt(STIFFNESS / INERTIA)
    assert not told(lambda: lw.simulate(rotor(omega), 4.0, rtol=1e-8))


def test_frames_from_one_side_to_the_other_are_no_turn_through_the_back() -> None:
    """Of swings by 140 degrees the frames have the ends, of which the shortest way is through 180."""
    omega = np.radians(140) * np.sqrt(STIFFNESS / INERTIA)
    half = np.pi / np.sqrt(STIFFNESS / INERTIA)
    ends = half * (np.arange(9) + 0.5)
    assert not told(lambda: lw.simulate(rotor(omega), 9.6 * half, times=ends, rtol=1e-8))


def test_a_bushing_without_torque_may_turn() -> None:
    none = {"rotational_stiffness": (0, 0, 0), "stiffness": (10, 10, 10)}
    assert not told(lambda: lw.simulate(rotor(12.0, **none), 1.0, rtol=1e-8))


def test_kinematics_and_members_of_ensembles_say_so() -> None:
    model = rotor(0.0)
    model.revolute("ground", "rotor", at=(0, 0, 0), axis=(0, 0, 1), name="hinge")
    model = model.without("base")
    model.drive("hinge", velocity=5.0)
    (text,) = told(lambda: lw.kinematics(model, np.linspace(0, 1, 101)))
    assert text.startswith(f"{BEYOND}0.63 s")
    many = lw.Ensemble([rotor(12.0), rotor(9.0)]).simulate(1.0, step=1e-2, on_inaccurate="pass")
    assert list(many.remarks) == [0] and BEYOND in str(many.remarks[0])
