"""Motion whose accelerations are large for short times only: what is late is far off there."""

from __future__ import annotations

import functools
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from scipy.optimize import brentq
from scipy.special import ellipeinc

START = 0.3


def _trammel(light: float) -> lw.Model:
    """Sliders of 1 kg and of `light` on crossed rails, on a rod of 1 m that turns; no forces."""
    x, y = np.cos(START), np.sin(START)
    model = lw.Model(gravity=(0, 0, 0))
    model.body("heavy", mass=1.0, inertia=(1, 1, 1), position=(x, 0, 0), velocity=(-y, 0, 0))
    model.body("light", mass=light, inertia=(1, 1, 1), position=(0, y, 0), velocity=(0, x, 0))
    model.translational("ground", "heavy", at=(x, 0, 0), axis=(1, 0, 0))
    model.translational("ground", "light", at=(0, y, 0), axis=(0, 1, 0))
    model.distance("heavy", "light", at=((x, 0, 0), (0, y, 0)))
    return model


# omega sqrt(sin^2 + m cos^2) = P, constant
def _velocities_of_trammel(light: float, t: Floats) -> Floats:
    P = np.sqrt(np.sin(START) ** 2 + light * np.cos(START) ** 2)
    scale, m = np.sqrt(light) / P, 1 - 1 / light
    begun, turn = scale * ellipeinc(START, m), 2 * scale * ellipeinc(np.pi / 2, m)

    def angle(time: float) -> float:
        whole = START + np.floor(time / turn) * np.pi
        return float(
            brentq(lambda x: scale * ellipeinc(x, m) - begun - time, whole - 1e-9, whole + 3.2, xtol=1e-14)
        )

    angles = np.array([angle(time) for time in t])
    omega = P / np.sqrt(np.sin(angles) ** 2 + light * np.cos(angles) ** 2)
    return np.stack([-np.sin(angles) * omega, np.cos(angles) * omega], axis=1)


def _off(light: float, run: lw.Result) -> float:
    exact = _velocities_of_trammel(light, run.t)
    found = np.stack([run.velocity[:, 0, 0], run.velocity[:, 1, 1]], axis=1)
    return float(abs(found - exact).max() / abs(exact).max())


PROJECTED: Any = {"integrator": "tsit5", "stabilization": "projection"}


@pytest.mark.parametrize("light", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize(("t_end", "how"), [
    (100.0, {"rtol": 1e-6}), (60.0, {"rtol": 1e-6, **PROJECTED}), (60.0, {"rtol": 1e-8}),
])  # fmt: skip
def test_what_is_late_counts_where_accelerations_burst_without_contacts_too(
    light: float, t_end: float, how: Any
) -> None:
    run = lw.simulate(_trammel(light), t_end=t_end, on_inaccurate="pass", record_every=1, **how)
    assert run.verdict is not None
    true = _off(light, run)
    most = 100 if how == {"rtol": 1e-8} else 20  # there what is late grows on, and cancels in part
    assert true < run.verdict.error < most * true


@pytest.mark.parametrize("velocity", [0.0, 1.0, 1e4])
def test_a_second_run_of_a_body_that_turns_and_flies_is_not_another_motion(velocity: float) -> None:
    """Seen from its center of mass there is rounding alone in its way."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("top", mass=1.0, inertia=(0.1, 0.1, 0.15), velocity=(velocity, 0, 0), omega=(0.5, 0, 10))
    run = lw.simulate(model, t_end=4.0, rtol=1e-8, integrator="dop853", verify=True, on_inaccurate="pass")
    assert run.verdict is not None and run.verdict.verified is not None
    assert run.verdict.verified < 1e-5


@pytest.mark.parametrize(
    "frames", [{}, {"times": np.linspace(0, 100, 201)}, {"times": np.linspace(0, 100, 5)}]
)
def test_a_second_run_tells_of_bursts_between_frames(frames: Any) -> None:
    """The light slider is fast for a hundredth of the time."""
    how: Any = {"t_end": 100.0, "rtol": 1e-6, "on_inaccurate": "pass", **PROJECTED}
    true = _off(1e-4, lw.simulate(_trammel(1e-4), record_every=1, **how))
    seen = lw.simulate(_trammel(1e-4), verify=True, **how, **frames)
    assert seen.verdict is not None
    assert seen.verdict.verified == pytest.approx(true, rel=0.5)


def _orbit(e: float) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("planet", mass=1.0, inertia=(1, 1, 1), position=(1 + e, 0, 0),
               velocity=(0, np.sqrt((1 - e) / (1 + e)), 0))  # fmt: skip
    model.nonlinear_spring_damper("ground", "planet", at=((0, 0, 0), (1 + e, 0, 0)), free_length=0.0,
                                  spring=lambda r: 1 / max(r, 1e-3) ** 2)  # fmt: skip
    return model


# t + pi = E - e sin E
def _velocities_in_orbit(e: float, t: Floats) -> Floats:
    anomaly = np.array(
        [brentq(lambda x, m=m: x - e * np.sin(x) - m, m - 1, m + 1, xtol=1e-15) for m in t + np.pi]
    )
    rate = 1 / (1 - e * np.cos(anomaly))
    return np.stack([np.sin(anomaly) * rate, -np.sqrt(1 - e * e) * np.cos(anomaly) * rate], axis=1)


@pytest.mark.parametrize(("e", "rtol"), [(0.6, 1e-8), (0.9, 1e-8), (0.9, 1e-9)])
def test_work_that_a_force_gives_back_was_not_taken_from_the_error(e: float, rtol: float) -> None:
    """An orbit about a law of attraction that tells no potential: bodies are fast beside its center only."""
    run = lw.simulate(_orbit(e), t_end=66.0, rtol=rtol, on_inaccurate="pass", record_every=1)
    exact = _velocities_in_orbit(e, run.t)
    assert run.verdict is not None
    true = float(np.linalg.norm(run.velocity[:, 0, :2] - exact, axis=1).max()) / np.sqrt((1 + e) / (1 - e))
    most = 500 if rtol == 1e-9 else 20  # likewise
    assert true < run.verdict.error < most * true


@pytest.mark.parametrize(("integrator", "step"), [("dopri5", 0.02), ("tsit5", 0.01), ("phem56", 0.01)])
@pytest.mark.parametrize("t_end", [60.0, 200.0])
def test_energy_that_the_balance_does_not_show_is_found_by_steps(
    integrator: str, step: float, t_end: float
) -> None:
    """The work of a law is integrated by the stages that err."""
    how: Any = {"step": step, "integrator": integrator, "on_inaccurate": "pass"}
    run = lw.simulate(_orbit(0.6), t_end=t_end, record_every=1, **how)
    exact = _velocities_in_orbit(0.6, run.t)
    assert run.verdict is not None
    true = float(np.linalg.norm(run.velocity[:, 0, :2] - exact, axis=1).max()) / 2
    assert 0.8 * true < run.verdict.error < 30 * true


def _hanging(law: bool, beside: str = "") -> lw.Model:
    model = lw.Model()
    model.body("b", mass=1.0, inertia=(1, 1, 1), position=(0, 0, -1))
    _spring(model, "b", 1e4, 1 - 9.81e-4, ((0, 0, 0), (0, 0, -1)), law)
    if beside:
        model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(5.5, 0, 0))
        model.revolute("ground", "rod", at=(5, 0, 0), axis=(0, 1, 0))
        model.user_force(lambda t, q, v: np.zeros(6), "rod")
    return model


def _gate(law: bool, t_end: float) -> lw.Model:
    """Driven against a spring; both do much more work than the gate has energy."""
    model = lw.Model()
    model.body("gate", mass=50.0, inertia=(5, 5, 5), position=(1, 0, 0))
    model.revolute("ground", "gate", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.drive("pin", position=lw.functions.cycloidal(1.0, t_end))
    _spring(model, "gate", 2e4, 1.5, ((-1, 0, 1), (1, 0, 0)), law)
    return model


def _rotors(law: bool) -> lw.Model:
    """Two links of 1 kg on hinges with a hundred times their inertia."""
    model = lw.Model()
    axes: Any = ((0, 1, 0), (0, 1, 0.2))
    for k, (before, axis) in enumerate(zip(("ground", "link 0"), axes, strict=True)):
        at, name = (k, 0, 0), f"link {k}"
        model.body(name, mass=1.0, inertia=(0.01, 1 / 12, 1 / 12), position=(k + 0.5, 0, 0))
        pin = model.revolute(before, name, at=at, axis=axis)
        model.rotational_inerter(before, name, at=at, axis=axis, inertance=100.0)
        if law:
            model.joint_force(pin, lambda t, angle, rate: -200 * (angle - 0.1))
        else:
            model.rotational_spring_damper(before, name, at=at, axis=axis, stiffness=200.0, damping=0.0,
                                           free_angle=0.1)  # fmt: skip
    return model


def _spring(model: lw.Model, body: str, k: float, free: float, at: Any, law: bool) -> None:
    if law:
        model.nonlinear_spring_damper("ground", body, at=at, free_length=free, spring=lambda x: k * x)
    else:
        model.spring_damper("ground", body, at=at, free_length=free, stiffness=k, damping=0.0)


@pytest.mark.parametrize(("model", "t_end"), [
    (_hanging, 2.0), (functools.partial(_hanging, beside="rod"), 2.0),
    (functools.partial(_gate, t_end=60.0), 60.0), (functools.partial(_gate, t_end=600.0), 600.0),
    (_rotors, 40.0),
])  # fmt: skip
def test_a_law_that_rests_is_driven_or_moves_rotors_is_judged_as_the_spring_that_it_is(
    model: Any, t_end: float
) -> None:
    errors = []
    for law in (True, False):
        verdict = lw.simulate(model(law), t_end=t_end, rtol=1e-6, on_inaccurate="pass").verdict
        assert verdict is not None
        errors.append(verdict.error)
    assert errors[0] < 20 * errors[1] + 1e-6
