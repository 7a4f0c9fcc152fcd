"""What a run says of itself beside the truth: a seeded part of the table of tests/benchmarks.

And runs that are wrong in ways that a look at some of their steps could miss.
"""

from __future__ import annotations

import math
import sys
import warnings
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions, mechanisms

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

import verdicts

#: One of each family, with rk4 and another method.
SEEDS = (1056, 1017, 1058, 1099, 1044, 1013, 1022, 1071, 1161)


@pytest.fixture(scope="module")
def found() -> list[verdicts.Found]:
    return [it for seed in SEEDS for it in verdicts.study(seed, 2)[1]]


def test_every_family_is_looked_at(found: list[verdicts.Found]) -> None:
    assert {it.family for it in found} == set(verdicts.FAMILIES)
    assert sum(not it.failure for it in found) > 60


def test_no_run_of_the_table_is_wrong_without_a_word(found: list[verdicts.Found]) -> None:
    assert not [it for it in found if it.silent]
    assert sum(it.warned for it in found if it.true > verdicts.WRONG) > 10


def test_local_errors_are_within_a_factor_of_thirty(found: list[verdicts.Found]) -> None:
    ratios = verdicts.ratios([it for it in found if not it.failure])
    assert len(ratios) > 100
    assert np.mean((ratios > 1 / verdicts.FACTOR) & (ratios < verdicts.FACTOR)) >= 0.95


def test_three_times_the_bands_contain_the_truth(found: list[verdicts.Found]) -> None:
    shares = [share for it in found for share in it.bands.values()]
    assert len(shares) > 40 and np.mean(shares) >= 0.95


def test_frames_inside_of_long_steps_are_judged_as_their_interpolant_gives_them() -> None:
    """DOP853 takes 23 steps here, with ends that are 100 times as good as what is between."""
    model = verdicts.mechanism(40164)[1].model
    result, said = runs(model, rtol=1e-3, integrator="dop853", times=np.linspace(0, 1, 101))
    best = verdicts.exact(model, 1.0, result.t)
    assert verdicts.difference(result, best).max() > 0.01 and said
    ends, said = runs(model, rtol=1e-3, integrator="dop853", record_every=1)
    assert ends.verdict is not None and result.verdict is not None
    assert ends.verdict.error < 0.5 * result.verdict.error
    assert verdicts.difference(ends, verdicts.exact(model, 1.0, ends.t)).max() < ends.verdict.error


def runs(model: lw.Model, t_end: float = 1.0, **how: Any) -> tuple[lw.Result, list[str]]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = lw.simulate(model, t_end, progress=False, **how)
    return result, [str(it.message) for it in caught if issubclass(it.category, lw.LinkworkWarning)]


def mass(force: Any, velocity: float = 0.1) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    ball = model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(velocity, 0, 0))
    model.force(ball, force=(force, 0, 0))
    return model


@pytest.mark.parametrize("integrator", ["euler", "heun", "rk4", "dopri5", "ab2", "abm4", "hem4"])
@pytest.mark.parametrize("periods", [1, 2, 4, 12])
def test_a_force_that_is_in_step_with_the_run_is_seen(integrator: str, periods: int) -> None:
    """Stages of a step and of its halves see it at its peak; it does no work over a period."""
    h = 0.04
    model = mass(functions.harmonic(10.0, 2 * math.pi * periods / h, math.pi / 2))
    result, said = runs(model, step=h, integrator=integrator)
    exact = (
        0.1 * result.t
        + 10.0 * (1 - np.cos(2 * math.pi * periods / h * result.t)) * (h / (2 * math.pi * periods)) ** 2
    )
    assert np.abs(result.position[:, 0, 0] - exact).max() < 0.01 * 0.1 or said


@pytest.mark.parametrize("step", [0.1, 0.02, 1e-3])
def test_a_pulse_inside_a_step_is_seen_where_its_times_are_known(step: float) -> None:
    pulse = functions.with_breaks(lambda t: 50.0 if 0.6153 <= t < 0.6158 else 0.0, (0.6153, 0.6158))
    model = mass(pulse, velocity=0.02)
    result, said = runs(model, step=step)
    assert abs(result.velocity[-1, 0, 0] - (0.02 + 50.0 * 5e-4)) > 0.01 * 0.045 and said
    result, said = runs(model, rtol=1e-6)
    assert result.velocity[-1, 0, 0] == pytest.approx(0.045, rel=1e-6) and not said


@pytest.mark.parametrize("how", [{"step": 0.1}, {"step": 0.02}, {"rtol": 1e-6}])
@pytest.mark.parametrize(
    "force",
    [
        functions.expression("50*exp(-((t-0.6153)/0.001)**2)"),
        lambda t: 50.0 * math.exp(-(((t - 0.6153) / 1e-3) ** 2)),
    ],
)
def test_a_pulse_that_no_step_sees_is_told_with_its_function_and_time(
    force: Any, how: dict[str, Any]
) -> None:
    result, said = runs(mass(force), **how)
    exact = 0.1 + 50.0 * 1e-3 * math.sqrt(math.pi)
    assert abs(result.velocity[-1, 0, 0] - exact) > 0.01
    assert len(said) == 1 and "force_x does at t = 0.61" in said[0] and "with_breaks" in said[0]


@pytest.mark.parametrize("how", [{"step": 5e-3}, {"rtol": 1e-6}])
def test_a_pulse_is_told_however_slow_its_law_is(how: dict[str, Any]) -> None:
    def slow(t: float) -> float:
        for _ in range(8000):
            pass
        return 1000.0 * (abs(t - 0.5137) < 4e-4)

    result, said = runs(mass(slow), **how)
    assert abs(result.velocity[-1, 0, 0] - 0.9) > 0.1
    assert len(said) == 1 and "force_x does at t = 0.51" in said[0]


def test_what_takes_too_long_to_be_looked_at_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwork.running.pulses.PATIENCE", 0.0)
    result, _ = runs(mass(math.sin), step=5e-3)
    assert result.verdict is not None and result.verdict.level == "good"
    assert "but for what" in result.verdict.sentence and "force_x" in result.verdict.sentence


def test_functions_that_may_remember_are_not_called_beside_the_run() -> None:
    class Counting:
        calls = 0

        def __call__(self, t: float) -> float:
            self.calls += 1
            return 0.0

    counting = Counting()
    result, _ = runs(mass(counting), step=1e-2)
    assert counting.calls <= result.statistics["evaluations"] + 10


def test_a_stop_makes_velocities_of_what_is_late() -> None:
    """Ten impacts of 3 ms each: a delay of 1e-4 s is 10 % of the velocity there."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(1, 0, 0))
    model.translational(model.ground, body, at=(0, 0, 0), axis=(1, 0, 0))
    model.translational_stop(
        model.ground, body, at=(0, 0, 0), axis=(1, 0, 0), lower=-0.1, upper=0.1, stiffness=1e6
    )
    result, said = runs(model, step=1e-4, record_every=1)
    best = verdicts.exact(model, 1.0, result.t)
    assert verdicts.difference(result, best).max() > 0.01 and said
    result, said = runs(model, step=1e-5, record_every=10)
    best = verdicts.exact(model, 1.0, result.t)
    assert result.verdict is not None and verdicts.difference(result, best).max() < 10 * result.verdict.error


@pytest.mark.parametrize("penalty", [1.0, 10.0, 100.0])
def test_the_error_that_a_penalty_leaves_is_part_of_what_is_said(penalty: float) -> None:
    model = mechanisms.spatial_slider_crank()
    how: dict[str, Any] = {"formulation": "penalty", "penalty": penalty, "step": 1e-3}
    result, said = runs(model, verify=True, **how)
    assert ("formulation 'penalty' is not exact enough here" in str(said)) is bool(said)
    best = verdicts.exact(model, 1.0, result.t)
    true = float(verdicts.difference(result, best).max())
    assert result.verdict is not None and result.verdict.verified is not None
    assert 0.5 * true < result.verdict.verified < 5 * true
    local = [step.error for step in result.verdict.steps]
    assert sum(local) * result.verdict.steps_total / len(local) > 0.3 * true
    off = np.abs(result.energy - best.energy)
    assert np.mean(off <= 3 * result.error_of("energy") + 1e-12) > 0.95
