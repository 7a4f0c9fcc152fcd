"""The verdict of a run: near the truth, told wherever the run is shown, without a trace in the run."""

from __future__ import annotations

import json
import subprocess
import sys
import warnings
from itertools import pairwise
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, mechanisms
from linkwork.accuracy import verdict
from linkwork.accuracy.measures import Bodies, Differences, Sampled, Scales
from linkwork.arrays import Floats
from linkwork.integrators import METHODS
from linkwork.options import compile_options
from linkwork.running.estimation import unjudged
from random_mechanisms import make

#: As of a run that found little.
_NUMBERS: dict[str, Any] = {
    "taken": 1, "failed": 0, "kinetic_share": 1.0, "rest_energy": 1.0, "violation": 0.0, "seconds": 1.0,
    "rate": 1.0, "slowness": 1.0, "suddenness": 0.0, "state": 1e-3,
    "local_error": 1e-3, "rounding": 0.0, "yielding": 0.0, "steps": [(0.0, 1e-3, 1e-6, None)], "energies": [],
    "body": -1, "growth": 2.0, "at_most": float("nan"), "unstable": 1.0, "grows": False, "lost": None,
}  # fmt: skip


def quick(model: lw.Model, t_end: float, **how: Any) -> lw.Result:
    return lw.simulate(model, t_end, **{"progress": False, "on_inaccurate": "pass", **how})


def exact(model: lw.Model, result: lw.Result) -> lw.Result:
    with unjudged():
        return quick(model, result.t[-1], rtol=1e-11, integrator="dop853", stabilization="projection",
                     times=result.t)  # fmt: skip


def true_error(model: lw.Model, result: lw.Result) -> float:
    """Of the state, as `compare` measures it."""
    best = exact(model, result)
    reference = Sampled.of(best)
    differences = Differences.between(Sampled.of(result), reference)
    return float(differences.state(Scales.of(reference, Bodies.of(best.header))).max())


# --- near the truth ---


@pytest.mark.parametrize("integrator", sorted({*METHODS} - {"semi_implicit_euler"}))
def test_the_error_of_a_step_is_that_of_the_exact_motion_from_its_start(integrator: str) -> None:
    model, h = mechanisms.spatial_slider_crank(), 2e-3
    result = quick(model, 0.1, step=h, integrator=integrator, record_every=1, stabilization="none")
    assert result.verdict is not None and result.verdict.steps
    reference = Sampled.of(result)
    scales = Scales.of(reference, Bodies.of(result.header))
    for step in result.verdict.steps[2::6]:
        k = round(step.t / h)
        start = result.snapshot(k)
        end = quick(model, float(result.t[k + 1]), rtol=1e-12, atol=1e-15, integrator="dop853", start=start,
                    times=[float(result.t[k + 1])], stabilization="none")  # fmt: skip
        apart = Differences.between(_frame(reference, k + 1), _frame(Sampled.of(end), -1))
        true = float(apart.state(scales).max())
        if true > 1e-13:
            assert 1 / 5 < step.error / true < 5, (step, true)


@pytest.mark.parametrize("name", ["pendulum", "four_bar", "rod_pendulum", "bricard"])
def test_steps_that_take_back_the_error_of_the_one_before_do_not_add_up(name: str) -> None:
    """Energies of semi-implicit Euler oscillate, and so do its errors."""
    model = getattr(mechanisms, name)()
    result = quick(
        model, 4.0, step=1e-3, integrator="semi_implicit_euler", record_every=10, on_inaccurate="pass"
    )
    assert result.verdict is not None
    true = true_error(model, result)
    assert true < result.verdict.error < 15 * true


@pytest.mark.parametrize(("name", "integrator", "steps"), [
    ("four_bar", "rk3", {"step": 1e-2}), ("four_bar", "bs32", {"rtol": 1e-4}),
    ("four_bar", "dopri5", {"rtol": 1e-6}), ("spatial_slider_crank", "bs32", {"rtol": 1e-6}),
    ("spatial_slider_crank", "rk3", {"step": 2e-3}),
])  # fmt: skip
def test_a_drift_of_the_energy_delays_slow_passages_most(name: str, integrator: str, steps: Any) -> None:
    model = getattr(mechanisms, name)()
    record = {"times": np.linspace(0.0, 6.0, 301)} if "rtol" in steps else {"record_every": 1}
    result = quick(model, 6.0, integrator=integrator, on_inaccurate="pass", **record, **steps)
    assert result.verdict is not None
    true = true_error(model, result)
    assert true < result.verdict.error < 20 * true


@pytest.mark.parametrize(("omega", "t_end", "steps"), [
    (1e3, 40.0, {"rtol": 1e-8}), (1e3, 40.0, {"rtol": 1e-8, "integrator": "dop853"}),
    (1e3, 10.0, {"rtol": 1e-6}), (1e3, 1.0, {"step": 1e-4, "integrator": "rk4"}),
    (1e3, 2.181, {"rtol": 1e-5, "integrator": "dop853"}),
    (3e3, 3.668, {"rtol": 1e-5}), (1e4, 4.7568, {"rtol": 1e-7}),
    (1e5, 8.0, {"rtol": 1e-7, "integrator": "dop853"}),
])  # fmt: skip
def test_what_bounces_for_long_is_late_where_its_velocity_changes_most(
    omega: float, t_end: float, steps: Any
) -> None:
    """Between two elastic stops: straight lines and half periods of a spring."""
    half, speed = 0.1, 2.0
    model = lw.Model(gravity=(0, 0, 0))
    model.body("s", mass=1.0, inertia=(1e-3,) * 3, velocity=(speed, 0, 0))
    model.translational("ground", "s", at=(0, 0, 0), axis=(1, 0, 0))
    model.translational_stop("ground", "s", at=(0, 0, 0), axis=(1, 0, 0),
                             lower=-half, upper=half, stiffness=omega**2)  # fmt: skip
    result = quick(model, t_end, on_inaccurate="pass", **steps)
    way = 2 * half / speed + np.pi / omega
    phase = (result.t + half / speed) % (2 * way)
    turned = omega * np.maximum(phase % way - 2 * half / speed, 0.0)
    true = float(abs(result.v[:, 0, 0] - np.where(phase < way, 1, -1) * speed * np.cos(turned)).max()) / speed
    assert result.verdict is not None
    assert true < result.verdict.error < 20 * true


@pytest.mark.parametrize(("integrator", "step"), [("rk4", 0.02), ("heun", 2e-3)])
@pytest.mark.parametrize("damping", [0.1, 0.5, 2.0])
def test_a_motion_that_has_settled_is_not_late(integrator: str, step: float, damping: float) -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("rod", mass=1, inertia=(1 / 12,) * 3, position=(np.sin(1.2) / 2, 0, -np.cos(1.2) / 2))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_spring_damper("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), damping=damping)
    result = quick(model, 60.0, step=step, integrator=integrator, record_every=5)
    true = true_error(model, result)
    assert result.verdict is not None
    assert true < result.verdict.error < 300 * true


@pytest.mark.parametrize("rest", [0.3, 1.0, 5.0, 20.0])
def test_a_body_that_rests_until_it_is_pushed_is_late_from_there_on(rest: float) -> None:
    """It swings by 0.2 (1 - cos 10 t)."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("rotor", mass=1, inertia=(0.1,) * 3)
    model.revolute("ground", "rotor", at=(0, 0, 0), axis=(0, 0, 1))
    model.rotational_spring_damper("ground", "rotor", axis=(0, 0, 1), stiffness=10.0,
                                   torque=lambda t: 2.0 if t >= rest else 0.0, breaks=[rest])  # fmt: skip
    found = quick(model, rest + 20.0, step=0.02, integrator="rk3", on_inaccurate="pass")
    swings = np.where(found.t > rest, 2.0 * np.sin(10.0 * (found.t - rest)), 0.0)
    off = float(np.abs(found.v[:, 0, 5] - swings).max()) / 2.0
    assert found.verdict is not None
    assert off < found.verdict.error < 60 * off


@pytest.mark.parametrize("how", [{"rtol": 1e-5}, {"step": 2e-3}], ids=str)
def test_what_is_damped_is_off_by_all_errors_as_they_have_grown_at_most(how: dict[str, Any]) -> None:
    """What forces took away of the energy they took away of its error, too."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("mass", mass=1.0, inertia=(0.1,) * 3, velocity=(0.3, 0, 0))
    along: Any = {"at": (0, 0, 0), "axis": (1, 0, 0)}
    model.translational("ground", "mass", **along)
    model.translational_spring_damper("ground", "mass", **along, stiffness=100.0, damping=0.05)
    run = quick(model, 20.0, **how)
    w = np.sqrt(100.0 - 0.025**2)
    swings = 0.3 * np.exp(-0.025 * run.t) * (np.cos(w * run.t) - 0.025 / w * np.sin(w * run.t))
    off = float(np.abs(run.v[:, 0, 0] - swings).max()) / 0.3
    assert run.verdict is not None and run.verdict.growth is not None
    assert off < run.verdict.error < 30 * off


def test_energy_that_comes_and_goes_lasts_less_than_a_drift() -> None:
    t = np.linspace(0.0, 10.0, 2001)

    def lasting(made: Floats, pieces: int = 7) -> float:
        energies = verdict.Energies()
        for piece in np.array_split(np.arange(len(t)), pieces):
            at = {"t": t[piece], "kinetic": 1.0 + made[piece], "potential": 0.0 * piece, "work": 0.0 * piece}
            energies.add(at)
        return energies.lasting

    assert lasting(1e-3 * t) == pytest.approx(1.0)
    assert lasting(1e-3 * np.sin(50 * t)) < 0.02
    assert lasting(1e-3 * (t > 0.1)) == pytest.approx(2.0, rel=0.02)
    assert lasting(np.zeros_like(t)) == 1.0
    uneven = 1e-3 * np.random.default_rng(0).standard_normal(len(t))
    assert len({lasting(uneven, pieces) for pieces in (1, 2, 7, 50)}) == 1, "to the last bit"


def test_what_adds_up_to_no_number_is_not_good() -> None:
    method = verdict.Method(1, step=0.1)
    found = verdict.estimate(
        _NUMBERS | {"state": np.nan, "local_error": np.nan, "reactions_by_state": np.nan},
        verdict.Energies(),
        method,
        {},
    )
    assert found.level == "wrong" and found.error == np.inf


def _frame(of: Sampled, k: int) -> Sampled:
    return Sampled(*(getattr(of, name)[k:][:1] for name in ("t", "q", "v", "force", "torque")))


@pytest.mark.parametrize(
    ("name", "t_end", "step", "integrator"),
    [
        ("andrews", 0.03, 1e-3, "rk4"),
        ("andrews", 0.03, 1e-4, "rk4"),
        ("four_bar", 2.0, 0.2, "rk4"),
        ("four_bar", 0.6, 1e-2, "abm4"),
        ("pendulum", 10.0, 0.05, "rk4"),
        ("bricard", 1.0, 1e-2, "hem4"),
        ("spatial_slider_crank", 1.0, 1e-2, "heun"),
        ("heavy_top", 1.0, 1e-3, "ab3"),
        ("chain", 0.5, 5e-3, "heun"),
    ],
)
def test_the_estimate_is_near_the_true_error(name: str, t_end: float, step: float, integrator: str) -> None:
    model = mechanisms.MECHANISMS[name].function()
    result = quick(model, t_end, step=step, integrator=integrator)
    assert result.verdict is not None and result.verdict.state is not None
    assert 0.2 < result.verdict.state / true_error(model, result) < 30, result.verdict


@pytest.mark.filterwarnings("ignore:.*are above 0.1 / step")
@pytest.mark.parametrize("gain", [0.2, 1.0])
def test_errors_that_the_stabilization_takes_back_do_not_add_up(gain: float) -> None:
    """With gains by the step each begins anew off the constraints, by about as much."""
    model, step = mechanisms.chain(4), 1e-3
    how: dict[str, Any] = {"baumgarte_alpha": gain / step, "baumgarte_beta": gain / step}
    result = quick(model, 1.0, step=step, stabilization="baumgarte", **how)
    assert result.verdict is not None
    true = true_error(model, result)
    assert true < result.verdict.error < 100 * true


@pytest.mark.parametrize("seed", [101, 105, 112, 150, 199, 221])
def test_no_motion_that_is_wrong_by_more_than_a_percent_is_silent(seed: int) -> None:
    rng = np.random.default_rng(seed)
    kinds = ("revolute", "spherical", "universal", "cylindrical", "translational")
    mechanism = make(seed, list(rng.choice(kinds, 3)), forces=["spring_damper"], driven=False)
    for step in (0.1, 0.03, 0.01):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                result = lw.simulate(mechanism.model, 1.0, step, progress=False)
            except lw.LinkworkError:
                continue
        silent = not any(issubclass(it.category, lw.LinkworkWarning) for it in caught)
        assert not (silent and true_error(mechanism.model, result) > 0.01), (step, result.verdict)


def test_too_long_steps_are_a_warning_that_says_what_would_help() -> None:
    model = mechanisms.andrews()
    with pytest.warns(
        lw.LinkworkWarning, match="is too long: the motion is another one; 5e-5 s would give 1e-4"
    ):
        lw.simulate(model, 0.03, 1e-3, progress=False)
    better = lw.simulate(model, 0.03, 1e-4, progress=False)
    assert true_error(model, better) < 1e-4
    loose = quick(mechanisms.spatial_slider_crank(), 2.0, rtol=3e-2, integrator="bs32")
    assert loose.verdict is not None and "the tolerances are too large" in loose.verdict.sentence


def test_a_violation_counts_relative_to_the_size_of_the_mechanism_in_any_unit() -> None:
    found = []
    for unit in (1e-3, 1.0, 1e3):
        model = lw.Model(gravity=(0, 0, -9.81 * unit))
        rod = model.body("rod", mass=1.0, inertia=np.eye(3) * 0.1 * unit**2, position=(0.5 * unit, 0, 0))
        model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0))
        result = quick(model, 1.0, step=0.05, stabilization="none")
        assert result.verdict is not None
        found.append(result.verdict)
    for a, b in pairwise(found):
        assert a.violation == pytest.approx(b.violation, rel=1e-6)
        assert a.state == pytest.approx(b.state, rel=1e-6)
        assert a.energy == pytest.approx(b.energy, rel=1e-6)


@pytest.mark.parametrize("inertia", [1.0, 1e-4])
def test_a_violation_of_a_long_rod_between_small_bodies_counts_relative_to_the_rod(inertia: float) -> None:
    model, length, rate = lw.Model(gravity=(0, 0, 0)), 100.0, 0.5
    for name, side in (("a", -0.5), ("b", 0.5)):
        model.body(name, mass=1.0, inertia=(inertia,) * 3, position=(side * length, 0, 0),
                   velocity=(0, side * rate * length, 0))  # fmt: skip
    model.distance("a", "b", at=((-length / 2, 0, 0), (length / 2, 0, 0)), name="tether")
    result = quick(model, 20.0, step=0.2, stabilization="none")
    assert result.verdict is not None
    assert result.verdict.violation == pytest.approx(result.violation.max() / length, rel=0.5)


def test_what_does_not_move_is_not_inaccurate() -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, -0.5))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0))
    result = quick(model, 1.0, step=0.01)
    assert result.verdict is not None and result.verdict.error < 1e-9


# --- without a trace ---


def _frames(dynamics: _core.Dynamics, run: _core.Run) -> dict[str, Floats]:
    pieces = []
    while not run.finished:
        run.advance(10**6, 1e6)
        pieces.append(run.take_frames())
    return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


@pytest.mark.parametrize("integrator", ["rk4", "ab4", "hem4", "semi_implicit_euler"])
@pytest.mark.parametrize("policy", ["pass", "stop"])
def test_the_run_is_that_of_the_driver_alone_to_the_last_bit(integrator: str, policy: str) -> None:
    model = mechanisms.four_bar()
    stabilization = {"stabilization": "projection"} if integrator == "hem4" else {}
    dynamics = _core.Dynamics(model.compiled(), compile_options(stabilization))
    run = _core.Simulation(dynamics, METHODS[integrator].compiled(), 0.25, 5e-4, 1)
    alone = _frames(dynamics, run)
    result = quick(model, 0.25, step=5e-4, integrator=integrator, record_every=1, on_inaccurate=policy)
    for name in ("q", "v", "vdot", "lambda", "work"):
        np.testing.assert_array_equal(np.ravel(result.recorded(name)), np.ravel(alone[name]))
    for name in ("evaluations", "factorizations", "solves", "singular_poses"):
        assert result.statistics[name] == run.statistics()[name]


def test_adaptive_runs_with_events_have_a_verdict_and_keep_their_steps() -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    ball = model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, 1.0))

    def reflect(t: float, state: lw.State) -> None:
        state.body(ball).velocity *= -0.9

    bounce = lw.Event(
        lambda t, state: state.body(ball).position[2] - 0.1, "bounce", direction=-1, change=reflect
    )
    result = quick(model, 2.0, rtol=1e-8, events=[bounce], record_every=1)
    assert result.events and result.verdict is not None and result.verdict.error < 1e-6


@pytest.mark.parametrize(
    ("steps", "least", "most"), [(5, 5, 5), (20, 20, 20), (300, 11, 22), (10**4, 22, 66), (2 * 10**4, 36, 96)]
)
def test_about_a_hundred_steps_are_taken_again_and_all_of_five(steps: int, least: int, most: int) -> None:
    result = quick(mechanisms.pendulum(), steps * 1e-4, step=1e-4)
    assert result.verdict is not None and result.verdict.steps_total == steps
    assert least <= len(result.verdict.steps) <= most
    assert 1 <= result.statistics["evaluations"] - 4 * steps <= 2  # taking them again counts for nothing


def test_a_long_run_takes_steps_again_where_accelerations_change_most() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    mass = model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.force(mass, force=(lambda t: 50 * np.exp(-(((t - 0.615) / 0.005) ** 2)), 0, 0))
    result = quick(model, 2.0, step=1e-3, integrator="heun")
    assert result.verdict is not None
    worst = max(result.verdict.steps, key=lambda step: step.error)
    assert 0.58 < worst.t < 0.65


# --- functions of the user's ---


def _swinging(force: Any) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -9.81))
    rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.user_force(force, bodies=[rod], name="wind")
    return model


def test_a_function_that_keeps_a_log_is_judged_by_steps_and_its_log_is_that_of_the_run() -> None:
    calls: list[float] = []

    def wind(t: float, q: Floats, v: Floats) -> Floats:
        calls.append(t)
        return np.zeros_like(v)

    model = _swinging(wind)
    calls.clear()
    result = quick(model, 0.1, step=1e-3)
    assert result.statistics["evaluations"] <= len(calls) < 1.2 * result.statistics["evaluations"]
    assert calls[-1] == pytest.approx(0.1)
    assert result.verdict is not None and result.verdict.steps and not result.verdict.memory


def test_functions_that_remember_nothing_are_no_obstacle() -> None:
    gains, table = [1.0, 2.0], np.array([0.5, 0.25])

    def wind(t: float, q: Floats, v: Floats) -> Floats:
        out = -0.1 * gains[0] * v
        out[0, 0] += table[1]
        return out

    result = quick(_swinging(wind), 0.1, step=1e-3)
    assert result.verdict is not None and result.verdict.state is not None
    assert result.verdict.steps and result.verdict.level == "good"


class Heun:
    """The user's own, with or without a memory."""

    order = 2

    def __init__(self, counts: bool) -> None:
        self.counts, self.calls = counts, 0

    def __call__(self, system: lw.System, t: float, y: Floats, h: float) -> Floats:
        self.calls += self.counts
        k = system.derivative(t, y)
        return y + h / 2 * (k + system.derivative(t + h, y + h * k))


def test_steps_of_an_integrator_of_the_users_own_are_taken_again_by_another() -> None:
    model = mechanisms.spatial_slider_crank()
    own = quick(model, 0.2, step=1e-3, integrator=Heun(counts=False))
    ours = quick(model, 0.2, step=1e-3, integrator="heun")
    assert own.verdict is not None and own.verdict.local_error is not None and ours.verdict is not None
    assert own.verdict.local_error == pytest.approx(ours.verdict.local_error, rel=0.05)
    counting = Heun(counts=True)
    remembering = quick(model, 0.2, step=1e-3, integrator=counting)
    assert remembering.verdict is not None and remembering.verdict.state == own.verdict.state
    assert counting.calls == 200


def test_a_mistake_in_an_integrator_of_the_users_own_is_told() -> None:
    """At half the speed energy is kept, and two halves of a step agree with the whole."""

    def slow(system: lw.System, t: float, y: Floats, h: float) -> Floats:
        return y + h / 2 * system.derivative(t, y + h / 4 * system.derivative(t, y))

    with pytest.warns(lw.LinkworkWarning, match="too long"):
        lw.simulate(mechanisms.pendulum(), 1.0, 1e-3, slow, stabilization="none", progress=False)


# --- what it means to the run ---


def test_stop_ends_an_inaccurate_run_early_with_its_result() -> None:
    with pytest.raises(lw.AccuracyError, match="too long") as stopped:
        lw.simulate(mechanisms.pendulum(), 2000.0, 0.2, progress=False, on_inaccurate="stop", record_every=1)
    result, state = stopped.value.result, stopped.value.state
    assert result is not None and 200 <= len(result) < 5000
    assert state is not None and state.t == pytest.approx(result.t[-1], abs=0.3)
    model = mechanisms.andrews()
    with pytest.raises(lw.AccuracyError) as ended:
        lw.simulate(model, 0.03, 1e-3, progress=False, on_inaccurate="stop")
    assert ended.value.result is not None and ended.value.result.finished
    with pytest.raises(lw.OptionError, match="on_inaccurate 'stopp'"):
        lw.simulate(model, 0.03, 1e-3, on_inaccurate="stopp")


def test_runs_that_go_on_from_others_count_their_errors() -> None:
    model = mechanisms.spatial_slider_crank()
    first = quick(model, 0.5, step=5e-3)
    second = quick(model, 1.0, step=5e-3, start=first.snapshot())
    alone = quick(model, 1.0, step=5e-3, start=first.snapshot()._replace(error=0.0))
    assert first.verdict is not None and second.verdict is not None and alone.verdict is not None
    assert first.verdict.state is not None and alone.verdict.state is not None
    assert second.verdict.before == pytest.approx(first.verdict.state)
    assert second.verdict.state == pytest.approx(first.verdict.state + alone.verdict.state)


# --- where it is told ---


def test_the_verdict_is_told_wherever_the_run_is(tmp_path: Path) -> None:
    model = mechanisms.four_bar()
    path = tmp_path / "run.h5"
    result = quick(model, 2.0, step=0.2, output=path)
    found = result.verdict
    assert found is not None and found.level in ("coarse", "wrong")
    assert lw.Result.load(path).verdict == found
    quick(model, 2.0, step=0.2).save(tmp_path / "saved.h5")
    assert lw.Result.load(tmp_path / "saved.h5").verdict == found
    assert found.sentence in result.summary()
    assert result.manifest["verdict"]["sentence"] == found.sentence
    assert found.sentence in result.report().html
    assert found.sentence in result.view().html
    assert verdict.Verdict.of(found.numbers()) == found


def command(*words: str) -> tuple[int, str, str]:
    """Exit code, standard output and standard error."""
    run = ["run", "four_bar", "--t-end", "2", "--step", "0.2", *words]
    done = subprocess.run(
        [sys.executable, "-c", "from linkwork.cli import main; main()", *run], capture_output=True, text=True
    )
    return done.returncode, done.stdout, done.stderr


def test_the_command_tells_it_in_its_table_and_in_json() -> None:
    code, out, error = command()
    assert code == 0 and "the step is too long" in out and error.startswith("warning: four_bar: the")
    code, out, error = command("--on-inaccurate", "pass", "--json")
    assert code == 0 and json.loads(out)["result"]["verdict"]["level"] == "wrong" and not error
    code, _, error = command("--on-inaccurate", "stop")
    assert code == 1 and error.startswith("error: four_bar: the step is too long")


def held_arm(inertance: float) -> lw.Model:
    """At rest by a driver, beside a rotor on the same hinge: the driver bears 2 kg, 0.5 m away."""
    model = lw.Model()
    arm = model.body("arm", mass=2.0, inertia=(0.01, 0.05, 0.05), position=(0.5, 0, 0))
    axis: dict[str, Any] = {"at": (0, 0, 0), "axis": (0, 1, 0)}
    model.revolute("ground", arm, **axis, name="hinge")
    model.drive("hinge", position=lw.functions.polynomial(0.0), name="motor")
    if inertance:
        model.rotational_inerter("ground", arm, **axis, inertance=inertance)
    return model


PENALTY: dict[str, Any] = {"formulation": "penalty"}


@pytest.mark.parametrize(
    ("inertance", "how"),
    [
        (0.0, PENALTY | {"penalty_scale": 1e3}),
        (1e3, PENALTY | {"penalty_scale": 1e5}),
        (1e5, PENALTY),
    ],
)
def test_reactions_that_are_lost_where_constraints_yield_are_told(
    inertance: float, how: dict[str, Any]
) -> None:
    result = quick(held_arm(inertance), 0.1, step=1e-3, **how)
    torque = -2.0 * 9.81 * 0.5
    lost = float(np.abs(result.reaction("motor").torque[:, 1] / torque - 1).max())
    found = result.verdict
    assert found is not None and found.reactions is not None and lost > 1e-3
    assert found.yielding == pytest.approx(lost, rel=0.05)
    assert found.reactions >= found.yielding and found.error >= found.yielding
    assert (found.level == "good") is (lost < 0.01)
    assert ("reactions are about" in found.sentence) is (lost > 0.01)


def on_crosses() -> lw.Model:
    """A double pendulum on universal joints, of which one is made of a massless cross."""
    model = lw.Model()
    upper = model.body("upper", mass=2.0, inertia=(0.1, 0.2, 0.25), position=(0.3, 0, -0.9))
    lower = model.body("lower", mass=1.0, inertia=(0.1, 0.1, 0.02), position=(0.3, 0.4, -2.5))
    cross = model.body("cross", mass=0.0, inertia=(0, 0, 0), position=(0, 0, 0))
    model.revolute("ground", cross, at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute(cross, upper, at=(0, 0, 0), axis=(1, 0, 1))
    model.universal(upper, lower, at=(0.3, 0, -1.6), axes=((0, 1, 0), (1, 0, 0)))
    return model


@pytest.mark.parametrize("model", [on_crosses(), mechanisms.chain(4)], ids=["massless crosses", "chain"])
def test_what_penalties_yield_and_stabilization_takes_back_does_not_add_up(model: lw.Model) -> None:
    """It was up to 10 % where the motion is right to 1e-6 or better."""
    how: dict[str, Any] = PENALTY | ({"penalty_scale": 1e6} if model.body_count == 4 else {})
    result = quick(model, 1.0, step=1e-3, **how)
    assert result.verdict is not None and result.verdict.state is not None
    true = true_error(model, result)
    assert true < 1e-5 and true < result.verdict.state < 1e-3 and result.verdict.level == "good"


@pytest.mark.parametrize("gravity", [(0, 0, 0), (0, 0, -9.81)])
@pytest.mark.parametrize("how", [PENALTY, PENALTY | {"penalty_scale": 1e4}])
def test_reactions_that_are_rounding_of_none_lose_nothing(
    gravity: tuple[float, float, float], how: dict[str, Any]
) -> None:
    """Two bodies on a hinge that fall or fly side by side."""
    model = lw.Model(gravity=gravity)
    first = model.body("first", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(1, 2, 3))
    second = model.body("second", mass=2.0, inertia=(0.1, 0.2, 0.1), position=(1, 0, 0), velocity=(1, 2, 3))
    model.revolute(first, second, at=(0.5, 0, 0), axis=(0, 1, 0.3))
    found = quick(model, 0.2, step=1e-3, **how).verdict
    assert found is not None and found.level == "good" and found.yielding < 1e-6


def test_reactions_of_exact_equations_lose_nothing() -> None:
    found = quick(held_arm(1e3), 0.1, step=1e-3).verdict
    assert found is not None and found.yielding == 0.0 and found.level == "good"


def test_reactions_that_may_be_off_are_named_beside_a_good_motion() -> None:
    method = verdict.Method(4, step=1e-3)
    for ratio, said in ((10.0, "2e-3"), (100.0, "20 % off"), (1e4, "far off")):
        found = verdict.estimate(_NUMBERS | {"reactions_by_state": ratio}, verdict.Energies(), method, {})
        assert found.level == "good" and found.sentence.endswith(said)
        assert found.state is not None and found.reactions is not None
        again = verdict.verified(found, 0.25 * found.state, method)
        assert again.reactions == pytest.approx(0.25 * found.reactions)
        assert ("but reactions" in again.sentence) is (ratio == 1e4), again.sentence


def test_a_good_run_says_beyond_which_time_nobody_knows_what_becomes_of_errors() -> None:
    method = verdict.Method(4, step=1e-3)
    for changed, said in (({}, True), ({"unstable": 1e4}, True), ({"state": 1.0}, False)):
        found = verdict.estimate(
            _NUMBERS | {"lost": 1.14, "reactions_by_state": 0.0} | changed, verdict.Energies(), method, {}
        )
        assert ("before t = 1.14 s become there is not known" in found.sentence) is said
        assert found.followed_until == 1.14


def test_errors_of_what_drivers_move_vanish_and_are_not_lost() -> None:
    found = quick(mechanisms.delta_robot(), 1.0, step=2e-3).verdict
    assert found is not None and found.followed_until is None and found.sentence.startswith("accurate to")


def test_what_a_bead_leaves_its_curve_by_at_knots_is_taken_back_and_does_not_add_up() -> None:
    t = np.linspace(0, 2 * np.pi, 80, endpoint=False)
    points = np.column_stack([np.cos(t), np.sin(2 * t) / 2, 0.3 * np.sin(t)])
    along = points[1] - points[-1]
    model = lw.Model(gravity=(0, 0, 0), name="bead")
    bead = model.body("bead", mass=1.0, inertia=(0.01, 0.01, 0.01), position=points[0],
                      velocity=2.0 * along / np.linalg.norm(along))  # fmt: skip
    model.point_on_curve("ground", bead, points=points, at=points[0], closed=True)
    model = lw.assemble(model).model
    run = quick(model, 2.0, step=5e-3)
    assert run.verdict is not None
    assert 1.0 < run.verdict.error / true_error(model, run) < 300.0  # thousands with all that is taken back


def test_what_stays_at_rest_is_judged_by_its_size() -> None:
    """A door in two hinges, whose reactions leave it speeds of 1e-18 m/s."""
    model = lw.Model(name="door")
    door = model.body("door", mass=20.0, inertia=(1, 3, 4), position=(0.5, 0, 0))
    for height in (0.5, -0.5):
        model.revolute("ground", door, at=(0, 0, height), axis=(0, 0, 1))
    found = lw.simulate(model, 1.0, 2e-3, progress=False).verdict
    assert found is not None and found.level == "good" and found.error < 1e-4


@pytest.mark.parametrize("how", [{"step": 1e-3}, {"rtol": 1e-6}])
@pytest.mark.parametrize("speed", [1e-12, 9e-10])
def test_what_hardly_moves_at_the_beginning_is_at_rest(speed: float, how: dict[str, float]) -> None:
    """Two bars that hold each other: velocities that are rounding move no axes with what stands still."""
    model = lw.Model()
    left, right = (
        model.body(name, mass=1, inertia=(0.01, 0.1, 0.1), position=(x, 0, 0.5), velocity=(0, 0, v),
                   orientation=lw.rotation.from_axes((1, 0, slope), (0, 1, 0)))
        for name, x, slope, v in (("left", 0.5, 1, speed), ("right", 1.5, -1, 0.0))
    )  # fmt: skip
    for a, b, x, z in (("ground", left, 0, 0), (left, right, 1, 1), ("ground", right, 2, 0)):
        model.revolute(a, b, at=(x, 0, z), axis=(0, 1, 0))
    result = lw.simulate(model, 1.0, progress=False, **how)
    assert np.abs(result.position - result.position[0]).max() < 1e-8
    assert result.verdict.level == "good" and result.verdict.error < 1e-6


@pytest.mark.parametrize("offset", [0.0, 5.6e-17, 1e-12, 1e-6, 1e-4])
@pytest.mark.parametrize("how", [{"step": 1e-2}, {"rtol": 1e-6}])
def test_a_rotor_on_a_joint_next_to_its_center_is_judged_by_its_extent(
    offset: float, how: dict[str, float]
) -> None:
    """Its radius of gyration is 0.55 m, whatever its unbalance: theta = 1/6 + a cos(w t) + b sin(w t)."""
    inertia, omega = 0.3 + offset**2, 2.0
    model = lw.Model()
    rotor = model.body("rotor", mass=1, inertia=(0.2, 0.2, 0.3), position=(0.3 + offset, 0, 0),
                       omega=(0, 0, omega), velocity=(0, omega * offset, 0))  # fmt: skip
    model.revolute("ground", rotor, at=(0.3, 0, 0), axis=(0, 0, 1), name="pin")
    model.rotational_spring_damper("ground", rotor, axis=(0, 0, 1), stiffness=3.0, torque=0.5)
    result = quick(model, 2.0, **how)
    rate = np.sqrt(3.0 / inertia)
    exact = (1 - np.cos(2.0 * rate)) / 6 + omega / rate * np.sin(2.0 * rate)
    error = abs(result.coordinate("pin").value[-1] - exact)
    assert result.verdict is not None and error < result.verdict.error < 1e-4


@pytest.mark.parametrize("joint", ["translational", "planar", "cylindrical"])
def test_a_slider_on_a_joint_next_to_its_center_does_not_diverge(joint: str) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    slider = model.body(
        "slider", mass=1, inertia=(0.1, 0.1, 0.1), position=(0.1 + 0.2, 0, 0), velocity=(0.5, 0, 0)
    )
    axis = {"axis": (0, 0, 1) if joint == "planar" else (1, 0, 0)}
    getattr(model, joint)("ground", slider, at=(0.3, 0, 0), **axis)
    result = quick(model, 1.0, step=1e-2)
    assert result.position[-1, 0] == pytest.approx([0.8, 0, 0], abs=1e-12)


@pytest.mark.parametrize(("integrator", "step"), [("rk4", 2e-3), ("dopri5", 5e-3)])
def test_errors_below_rounding_of_one_step_add_up(integrator: str, step: float) -> None:
    """A symmetric top: its axis goes about the angular momentum at L / I_1, the angle is a closed form."""
    about, axial, omega, t_end = 0.2, 0.1, np.array([0.6, 0, 2.0]), 200.0
    model = lw.Model(gravity=(0, 0, 0))
    top = model.body("top", mass=1, inertia=(about, about, axial), omega=omega)
    model.spherical("ground", top, at=(0, 0, 0))
    result = quick(model, t_end, step=step, integrator=integrator, record_every=round(t_end / step))
    momentum = omega * (about, about, axial)
    rate = float(np.linalg.norm(momentum)) / about
    exact = lw.rotation.matrix(lw.rotation.about(momentum, rate * t_end)) @ lw.rotation.matrix(
        lw.rotation.about((0, 0, 1), (omega[2] - momentum[2] / about) * t_end)
    )
    found = lw.rotation.matrix(result.orientation[-1, 0])
    error = np.linalg.norm(found - exact) / np.sqrt(2)
    assert result.verdict is not None and 1e-13 < error < result.verdict.error < 1e-8


def test_a_long_ring_that_bears_its_weight_across_its_hinges_is_at_rest() -> None:
    """Roundoff of moments of 1e5 N m gives links of 1e-3 kg m^2 accelerations, and there is nothing else."""
    n = 300
    angles = 2 * np.pi * np.arange(n) / n
    points = n / (2 * np.pi) * np.column_stack((np.cos(angles), np.sin(angles), 0 * angles))
    along = np.diff(points, axis=0)
    turned = np.array([lw.rotation.from_axes(x=x, y=(-x[1], x[0], 0)) for x in along])
    model = lw.Model()
    middles = (points[1:] + points[:-1]) / 2
    links = model.bodies("link", mass=1, inertia=(1e-3, 1 / 12, 1 / 12), position=middles, orientation=turned)
    model.joints("revolute", ["ground", *links], [*links, "ground"], at=points, axis=(0, 0, 1), name="pin")
    result = lw.simulate(model, 0.1, 0.01, progress=False)
    assert result.verdict.error < 1e-4
    assert np.abs(result.q[-1] - result.q[0]).max() < 1e-6


@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("drop", [0.5, 0.3])
def test_a_step_that_ends_where_a_contact_begins_is_no_error(rtol: float, drop: float) -> None:
    """A bounce by the law with hysteresis: its height follows the tolerance, and so does the verdict."""
    heights = []
    for tolerance in (rtol, 1e-12):
        model = lw.Model(name="ball")
        ball = model.body("ball", mass=0.1, inertia=(4e-5,) * 3, position=(0, 0, drop))
        model.sphere_plane_contact("ground", ball, radius=0.03, stiffness=1e5, hysteresis=0.3,
                                   at=((0, 0, 0), (0, 0, drop)), normal=(0, 0, 1))  # fmt: skip
        result = lw.simulate(model, 0.6, rtol=tolerance, progress=False)
        heights.append(result.position[-1, 0, 2])
    found = lw.simulate(model, 0.6, rtol=rtol, progress=False).verdict
    assert found is not None
    error = abs(heights[0] - heights[1]) / drop
    assert error <= found.error <= max(1e4 * error, 1e-3)


def test_what_a_run_goes_on_from_is_not_blamed_on_its_steps() -> None:
    start = lw.simulate(mechanisms.pendulum(), 0.2, 1e-3).snapshot()._replace(error=0.4, resume=None)
    found = lw.simulate(mechanisms.pendulum(), 0.4, rtol=1e-9, start=start, on_inaccurate="pass").verdict
    assert found is not None
    assert found.sentence == "about 40 % off, as the runs are that this one goes on from: take those again"


def test_contacts_that_begin_almost_together_are_no_error() -> None:
    model = lw.Model()
    model.body("chassis", mass=4.0, inertia=(0.2, 0.3, 0.4), position=(0, 0, 0.5))
    for x, y in ((0.3, 0.2), (0.3, -0.2), (-0.3, 0.2), (-0.3, -0.2)):
        model.sphere_plane_contact("ground", "chassis", at=((0, 0, 0), (x, y, 0.4)), normal=(0, 0, 1),
                                   radius=0.1, stiffness=2e5, hysteresis=0.4)  # fmt: skip
    rod = mechanisms.thin_rod(0.5, 0.4)
    for name, inner, x in (("first", "chassis", 0.2), ("second", "first", 0.6)):
        model.body(name, mass=0.5, inertia=rod, position=(x, 0, 0.5))
        model.revolute(inner, name, at=(x - 0.2, 0, 0.5), axis=(0, 1, 0))
    for rtol in (1e-5, 1e-6, 1e-7):
        found = lw.simulate(model, 0.6, rtol=rtol, on_inaccurate="pass").verdict
        assert found is not None
        assert found.level == "good"


def bouncing() -> lw.Model:
    model = lw.Model()
    ball = model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, 0.3))
    model.sphere_plane_contact(
        "ground",
        ball,
        at=((0, 0, 0), (0, 0, 0.3)),
        normal=(0, 0, 1),
        radius=0.1,
        stiffness=1e5,
        hysteresis=0.3,
    )
    return model


def between_stops(stiffness: float = 3e3) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    slider = model.body("slider", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(1, 0, 0))
    axis: dict[str, Any] = {"at": (0, 0, 0), "axis": (1, 0, 0)}
    model.translational("ground", slider, **axis)
    model.translational_stop("ground", slider, **axis, lower=-0.1, upper=0.1, stiffness=stiffness)
    return model


@pytest.mark.parametrize("integrator", ["rk4", "ab4", "abm4"])
@pytest.mark.parametrize("make_model", [bouncing, between_stops])
def test_contacts_and_stops_that_begin_and_end_inside_steps(make_model: Any, integrator: str) -> None:
    """Steps beside them stand for each other alone: not for smooth ones, nor these for them."""
    ratios = []
    for step in (6.1e-4, 3.1e-4, 1.7e-4, 9e-5):
        run = lw.simulate(make_model(), 1.0, step, integrator, progress=False, on_inaccurate="pass")
        truth = lw.simulate(
            make_model(),
            1.0,
            rtol=1e-12,
            integrator="dop853",
            times=run.t,
            progress=False,
            on_inaccurate="pass",
        )
        speeds = np.abs(run.velocity - truth.velocity).max() / np.abs(truth.velocity).max()
        assert run.verdict is not None
        ratios.append(run.verdict.error / max(speeds, np.abs(run.position - truth.position).max() / 0.2))
    assert min(ratios) > 1.0
    assert max(ratios) < 1500.0


@pytest.mark.parametrize("stiffness", [1e5, 3e5, 1e6])
def test_what_comes_late_to_a_stiff_stop_is_off_by_its_acceleration(stiffness: float) -> None:
    """Also where no step amid the stop, where accelerations are largest and change least, is taken again."""
    for step in (5e-5, 7e-5, 1e-4, 1.4e-4, 2e-4):
        run = lw.simulate(between_stops(stiffness), 0.65, step, progress=False, on_inaccurate="pass")
        # Free flight at 1 m/s, and half a period of an oscillation in each stop.
        flight, half = 0.2, np.pi / np.sqrt(stiffness)
        since = (run.t - 0.1) % (flight + half)
        side = (-1.0) ** np.floor((run.t - 0.1) / (flight + half))
        inside = since < half
        speed = np.where(inside, np.cos(np.pi * since / half), -1.0) * side
        speed[run.t < 0.1] = 1.0
        assert run.verdict is not None
        assert run.verdict.error > np.abs(run.velocity[:, 0, 0] - speed).max()


class Held:
    """A controller that samples by itself."""

    def __init__(self) -> None:
        self.sample, self.effort = -1, 0.0

    def __call__(self, t: float, angle: float, rate: float) -> float:
        if (sample := int(50.0 * t)) != self.sample:
            self.sample, self.effort = sample, -3.0 * angle - 0.1 * rate
        return self.effort


def _in_attributes(t: float, angle: float, rate: float) -> float:
    memory: Any = _in_attributes
    if (sample := int(50.0 * t)) != memory.sample:
        memory.sample, memory.effort = sample, -3.0 * angle - 0.1 * rate
    return float(memory.effort)


def _in_a_default(t: float, angle: float, rate: float, samples: list[float] = [0.0]) -> float:  # noqa: B006
    samples.append(angle)
    return -3.0 * samples[-2]


class _InItsClass(Held):
    last = 0.0

    @staticmethod
    def law(t: float, angle: float, rate: float) -> float:
        before, _InItsClass.last = _InItsClass.last, angle
        return -3.0 * before


vars(_in_attributes).update(sample=-1, effort=0.0)


def _held_by(law: Any, gravity: float = -9.81) -> lw.Model:
    model = lw.Model(gravity=(0, 0, gravity))
    bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.joint_force("hinge", law, name="controller")
    return model


@pytest.mark.parametrize("law", [Held(), Held().__call__, _in_attributes, _in_a_default, _InItsClass.law])
def test_a_law_that_remembers_is_a_warning(law: Any) -> None:
    for method in ({"step": 1e-3}, {"rtol": 1e-8}):
        with warnings.catch_warnings(record=True) as told:  # the second run also of what the first one left
            warnings.simplefilter("always")
            result = lw.simulate(_held_by(law), t_end=0.1, progress=False, **method)
        assert any("'controller': remembers calls" in str(it.message) for it in told)
        verdict = lw.Verdict.of(result.statistics["verdict"])
        assert verdict.memory == ("controller",)


def test_a_comparison_of_laws_that_remember_is_a_warning() -> None:
    with (
        pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"),
        pytest.warns(lw.LinkworkWarning, match="only known to"),
    ):
        lw.compare(
            _held_by(Held()), t_end=0.1, steps=[1e-2], integrators=["rk4"], processes=1, progress=False
        )


def test_samples_that_an_event_takes_are_exact() -> None:
    """Between samples the effort is constant: angle'' = held / J, without gravity."""
    period, held, inertia = 0.02, [-0.3], 0.03 + 0.3**2

    def sample(t: float, state: Any) -> None:
        bar = state.body("bar")
        angle = 2 * np.arctan2(bar.orientation[2], bar.orientation[0])
        held[0] = -3.0 * angle - 0.1 * bar.omega[1]

    model = _held_by(lambda t, angle, rate: held[0], gravity=0.0)
    clock = lw.Event(lambda t, state: np.sin(np.pi * t / period), "clock", change=sample)
    result = quick(model, 0.5 + 0.5 * period, rtol=1e-9, events=clock)
    angle, rate, effort = 0.0, 0.0, -0.3
    for _ in range(25):
        angle += rate * period + effort / inertia * period**2 / 2
        rate += effort / inertia * period
        effort = -3.0 * angle - 0.1 * rate
    assert len(result.events) == 25
    assert held[0] == pytest.approx(effort, abs=1e-8)


@pytest.mark.parametrize("method", [{"rtol": 1.1776175712110667e-06}, {"rtol": 4.76e-7},
                                    {"integrator": "dopri5", "step": 0.024990108107659385},
                                    {"integrator": "dopri5", "step": 0.025}])  # fmt: skip
def test_a_step_over_a_pose_in_which_its_redundant_rows_are_bad_is_taken_again_with_others(
    method: Any,
) -> None:
    """Bennett's linkage at t = 0.41 s, where the rows that the run leaves out make the others dependent."""
    model = lw.mechanisms.bennett()
    truth = quick(model, 0.6, rtol=1e-12, integrator="dop853")
    result = quick(model, 0.6, **method)
    assert result.statistics["row_changes"] == 1
    assert np.abs(result.position[-1] - truth.position[-1]).max() < 1e-7
    assert result.verdict is not None and result.verdict.error < 3e-4


# --- contacts ---


def bouncing(friction: float, hysteresis: float = 0.3, height: float = 0.3) -> lw.Model:
    """A ball that comes down on a floor at a slant, once within 0.4 s."""
    model = lw.Model()
    ball = model.body("ball", mass=0.1, inertia=(4e-5,) * 3, position=(0, 0, height), velocity=(0.4, 0, 0))
    model.sphere_plane_contact(
        model.ground, ball, at=((0, 0, 0), (0, 0, height)), normal=(0, 0, 1), radius=0.03, stiffness=1e5,
        hysteresis=hysteresis, friction=friction,
    )  # fmt: skip
    return model


@pytest.mark.parametrize(
    "how", [{"step": 3e-5}, {"step": 1e-5}, {"rtol": 1e-4}, {"rtol": 1e-5}, {"step": 1e-3}]
)
def test_errors_that_friction_takes_back_do_not_add_up(how: dict[str, Any]) -> None:
    model = bouncing(friction=0.3)
    best = quick(model, 0.4, rtol=1e-11, times=[0.4])
    result = quick(model, 0.4, **how)
    off = np.abs(result.v[-1] - best.v[-1]).max(axis=0)
    true = max(off[:3].max(), 0.03 * off[3:].max()) / 2.3
    assert result.verdict is not None
    assert (result.verdict.level == "good") == (how != {"step": 1e-3})
    assert result.verdict.error > true / 3


def test_a_step_that_its_tolerance_did_not_see_needs_a_longest_one() -> None:
    """No error estimate, no law by which it gets smaller with rtol."""
    leap, usual = (verdict.StepEstimate(*it, None) for it in ((2.0, 15.0, 0.5), (17.0, 0.1, 1e-8)))
    method = verdict.Method(5, rtol=1e-7)
    said = method.advice(1.0, [usual, leap])
    assert "between t = 2 and 17 s" in said and "longest step (step=), less than 10 s" in said
    assert "rtol 1e-11 would give 1e-4" in method.advice(1.0, [usual])
    assert "longest step" in method.advice(1.0, [usual], state=1e-3)  # the energy alone shows it


@pytest.mark.parametrize(("place", "speed", "step"), [(1e6, 1e-3, 1e-4), (1e9, 0.1, 1e-5), (1e9, 0.1, 1e-6)])
def test_rounding_of_places_far_away_adds_up_in_uniform_motion(
    place: float, speed: float, step: float
) -> None:
    """All steps are rounded to the same side."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("slider", mass=1, inertia=(0.1,) * 3, position=(place, 0, 0), velocity=(speed, 0, 0))
    model.translational("ground", "slider", at=(place, 0, 0), axis=(1, 0, 0))
    result = lw.simulate(model, 10**4 * step, step, on_inaccurate="pass", progress=False)
    moved = result.position[-1, 0, 0] - place
    off = abs(moved / (10**4 * step * speed) - 1)
    assert result.verdict.error >= 0.5 * off > 0
    assert ("from the origin" in result.verdict.sentence) == (result.verdict.level != "good")


@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian"])
@pytest.mark.parametrize(("place", "swing", "step"), [(5e6, 1e-3, 1e-3), (5e6, 0.1, 1e-4), (4e5, 1e-3, 1e-3)])
def test_rounding_of_places_far_away_is_an_error_of_velocities(
    place: float, swing: float, step: float, formulation: str
) -> None:
    """Stabilization turns violations that are rounding into velocities: those along the rod."""

    def pendulum(x: float) -> lw.Result:
        model = lw.Model(gravity=(0, 0, -9.81))
        pin = np.array((x, 0, 0.7 * x))
        center = pin + np.array((np.sin(swing), 0, -np.cos(swing)))
        rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.01), position=center)
        model.revolute("ground", rod, at=pin, axis=(0, 1, 0))
        return lw.simulate(model, 1.0, step, formulation=formulation, on_inaccurate="pass", record_every=7)

    near, far = pendulum(0.0), pendulum(place)
    error = np.abs(far.velocity - near.velocity).max() / np.abs(near.velocity).max()
    assert error > 1e-6
    assert 0.3 * error < far.verdict.error < 30 * error


def test_without_hysteresis_the_speed_at_which_contact_begins_is_no_error() -> None:
    model, up = lw.Model(gravity=(0, 0, -9.81)), (0, 0, 0.2)
    ball = model.body("ball", mass=0.1, inertia=(1e-4,) * 3, position=up)
    model.sphere_plane_contact(
        "ground", ball, at=((0, 0, 0), up), normal=(0, 0, 1), radius=0.05, stiffness=1e4
    )
    run = lw.simulate(model, 0.5, 1e-4)
    exact = lw.simulate(model, 0.5, times=run.t, rtol=1e-11, atol=1e-13, integrator="dop853")
    error = np.abs(run.velocity - exact.velocity).max() / np.abs(exact.velocity).max()
    assert error < 1e-3
    assert error < run.verdict.error < 100 * error


@pytest.mark.parametrize("hysteresis", [0.01, 0.05, 0.5])
@pytest.mark.parametrize("step", [1e-4, 1.3e-4])
def test_with_little_hysteresis_the_speed_at_which_contact_begins_is_little_error(
    hysteresis: float, step: float
) -> None:
    """One bounce, by steps in which gravity changes the speed by more than the method is off."""
    model = bouncing(friction=0.0, hysteresis=hysteresis)
    run = lw.simulate(model, 0.3, step, on_inaccurate="pass")
    exact = lw.simulate(model, 0.3, times=run.t, rtol=1e-11, atol=1e-13, integrator="dop853")
    error = np.abs(run.velocity - exact.velocity).max() / np.abs(exact.velocity).max()
    assert error < run.verdict.error < 100 * error


@pytest.mark.parametrize("steps", [1000, 2000, 4000])
@pytest.mark.parametrize("drop", [0.0, 1e-5])
def test_where_contact_stays_all_of_the_speed_at_which_it_begins_counts(drop: float, steps: int) -> None:
    """A ball that lies on a floor, or next to it: it goes up and down in contact."""
    model, up = lw.Model(), (0, 0, 0.1 + drop)
    model.body("ball", mass=1.0, inertia=(4e-3,) * 3, position=up)
    model.sphere_plane_contact("ground", "ball", at=((0, 0, 0), up), normal=(0, 0, 1), radius=0.1,
                               stiffness=1e6, hysteresis=0.1)  # fmt: skip
    run = lw.simulate(model, 1.0, 1.0 / steps, on_inaccurate="pass")
    exact = lw.simulate(model, 1.0, times=run.t, rtol=1e-11, atol=1e-13, integrator="dop853")
    error = np.abs(run.velocity - exact.velocity).max() / np.abs(exact.velocity).max()
    assert run.verdict.error > 0.5 * error


def rubbing(number: int) -> lw.Model:
    """One to three rods of 1 m on hinges with dry friction, that fall."""
    chosen = np.random.default_rng(number)
    model, end, before = lw.Model(), np.zeros(3), "ground"
    for k, angle in enumerate(chosen.uniform(1.0, 2.2, chosen.integers(1, 4))):
        way, name = np.array([np.sin(angle), 0.0, np.cos(angle)]), f"rod {k}"
        model.body(name, mass=1.0, inertia=(1 / 12, 1 / 12, 1e-3), position=end + way / 2,
                   orientation=(np.cos(angle / 2), 0, np.sin(angle / 2), 0))  # fmt: skip
        joint: Any = {"at": end, "axis": (0, 1, 0)}
        model.revolute(before, name, **joint)
        model.rotational_friction(before, name, **joint, coulomb=chosen.uniform(0.02, 0.2))
        end, before = end + way, name
    return model


@pytest.mark.parametrize("integrator", ["dopri5", "tsit5"])
@pytest.mark.parametrize("number", range(6))
def test_steps_in_which_dry_friction_turns_around_are_among_those_that_are_looked_at(
    number: int, integrator: str
) -> None:
    """Their own estimate may not have seen that."""
    model, times = rubbing(number), np.linspace(0.0, 5.0, 201)
    run = quick(model, 5.0, rtol=1e-6, integrator=integrator, times=times)
    best = quick(model, 5.0, rtol=1e-12, integrator="dop853", times=times)
    off = np.abs(run.velocity - best.velocity).max() / np.abs(best.velocity).max()
    assert run.verdict is not None
    assert 0.5 * min(off, 0.5) < run.verdict.error


def test_a_hard_hit_of_a_light_part_is_seen_beside_one_that_often_touches_soft_stops() -> None:
    model, speed = lw.Model(gravity=(0, 0, 0)), 0.31
    for name, mass, v, y in (("heavy", 10.0, 2.0, 0), ("light", 1e-3, speed, 2)):
        body = model.body(name, mass=mass, inertia=(0.01 * mass,) * 3, position=(0, y, 0), velocity=(v, 0, 0))
        model.translational("ground", body, at=(0, y, 0), axis=(1, 0, 0))
    joint = {"at": (0, 0, 0), "axis": (1, 0, 0)}
    model.translational_spring_damper("ground", "heavy", stiffness=4000.0, **joint)
    model.translational_stop("ground", "heavy", lower=-0.09, upper=0.09, stiffness=200.0, damping=0, **joint)
    model.translational_stop("ground", "light", at=(0, 2, 0), axis=(1, 0, 0), lower=-10.0, upper=1.0,
                             stiffness=400.0, damping=0)  # fmt: skip
    run = lw.simulate(model, 20.0, 2e-3, on_inaccurate="pass")
    assert abs(run.body("light").velocity[-1, 0] / speed + 1) > 0.05, "it bounces elastically"
    assert run.verdict is not None and run.verdict.level != "good"


@pytest.mark.parametrize("integrator", ["rk4", "tsit5", "dopri5", "ab4"])
@pytest.mark.parametrize(
    ("above", "below", "step"), [(2000.0, 2.0, 5e-3), (1200.0, 2.0, 1e-2), (50.0, 100.0, 2e-2)]
)
def test_kinks_of_characteristics_that_steps_go_over(
    above: float, below: float, step: float, integrator: str
) -> None:
    """A mass passes from a spring into another one: half sines."""
    model, v = lw.Model(gravity=(0, 0, 0)), 0.3
    body = model.body("mass", mass=1.0, inertia=(0.01,) * 3, velocity=(v, 0, 0))
    model.translational("ground", body, at=(0, 0, 0), axis=(1, 0, 0))
    spring = lw.functions.piecewise_polynomial([-8.0, 0.0, 8.0], [[-8 * below, below], [0.0, above]])
    model.nonlinear_spring_damper("ground", body, at=((-9, 0, 0), (0, 0, 0)), spring=spring, free_length=9.0)
    run = lw.simulate(model, 2.0, step, integrator, on_inaccurate="pass")
    lanes = lw.Ensemble(model, {"mass.mass": [1.0, 1.1]})
    found = lanes.simulate(2.0, step, integrator, on_inaccurate="pass")
    assert found.member(0).verdict == run.verdict
    first, other = np.pi / np.sqrt(above), np.pi / np.sqrt(below)
    within = run.t % (first + other)
    exact = np.where(
        within < first, np.cos(np.sqrt(above) * within), -np.cos(np.sqrt(below) * (within - first))
    )
    error = np.abs(run.velocity[:, 0, 0] / v - exact).max()
    assert error > 1e-6
    assert error < run.verdict.error < 300 * error


@pytest.mark.parametrize(
    ("integrator", "rtol", "torque", "omega"),
    [
        ("bs32", 1e-6, 5.86, 4.9),
        ("dopri5", 1e-6, 3.83, 6.21),
        ("dop853", 1e-5, 5.86, 4.9),
        ("bs32", 1e-8, 0.87, 6.76),
    ],
)
def test_a_rotor_over_teeth_is_late_by_what_energy_it_gains(
    integrator: str, rtol: float, torque: float, omega: float
) -> None:
    """Steps over jumps of a sawtooth err to one side; within a tooth the motion is a sine."""
    teeth, omega_0 = np.arange(-200.0, 201.0), np.sqrt(2 * torque)
    sawtooth = lw.functions.piecewise_polynomial(teeth, [[-torque, 2 * torque]] * 400)
    model = lw.Model(gravity=(0, 0, 0))
    rotor = model.body("rotor", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, omega))
    model.revolute("ground", rotor, at=(0, 0, 0), axis=(0, 0, 1))
    model.nonlinear_rotational_spring_damper("ground", rotor, at=(0, 0, 0), axis=(0, 0, 1), spring=sawtooth)
    run = lw.simulate(model, 28.0, rtol=rtol, integrator=integrator, on_inaccurate="pass")
    amplitude = np.hypot(0.5, omega / omega_0)  # the first tooth begins here
    tooth = 2 * np.arcsin(0.5 / amplitude) / omega_0
    passed, within = np.divmod(run.t, tooth)
    exact = passed + 0.5 + amplitude * np.sin(omega_0 * (within - tooth / 2))
    angle = 2 * np.arctan2(run.q[:, 0, 6], run.q[:, 0, 3])
    error = np.abs(np.angle(np.exp(1j * (angle - exact)))).max()
    assert run.verdict is not None and run.verdict.error > 0.5 * min(error, 1.0)


@pytest.mark.parametrize("integrator", ["rk4", "ab4"])
def test_a_run_of_the_rest_of_a_step_answers_for_it(integrator: str) -> None:
    model = mechanisms.rod_pendulum()
    first = lw.simulate(model, 0.9996, 5e-2, integrator, on_inaccurate="pass")
    rest = lw.simulate(model, 1.0, 5e-2, integrator, start=first.snapshot(), on_inaccurate="pass")
    assert first.verdict is not None and rest.verdict is not None
    assert rest.verdict.error == pytest.approx(first.verdict.error, rel=0.3)
