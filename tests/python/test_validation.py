"""Published benchmarks and closed forms, and that `validate` notices when one is missed."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.arrays import Floats
from linkwork.cli import run
from linkwork.validation import PROBLEMS, Figure, Series, validate


@pytest.mark.parametrize("name", PROBLEMS)
def test_reference_problem_is_solved_as_accurately_as_required(name: str) -> None:
    verdict = PROBLEMS[name].run()
    missed = [(it.quantity, it.error, it.required) for it in verdict.figures if not it.passed]
    assert verdict.passed, missed or verdict.reason


@pytest.mark.parametrize("name", PROBLEMS)
def test_required_figures_are_finer_than_the_motion_and_coarser_than_the_solution(name: str) -> None:
    """A requirement beyond the trusted digits of the solution could be met by chance alone."""
    digits = Series(PROBLEMS[name].solution).definition["trusted_digits"]
    for figure in PROBLEMS[name].run().figures:
        assert 10.0**-digits < figure.required <= 1e-5, figure


def test_the_reactions_of_the_rod_pendulum_follow_from_its_angle() -> None:
    """At all times: 5/2 m g cos(theta) along the rod, toward the pin, and m g sin(theta) / 4 across."""
    result = lw.simulate(mechanisms.rod_pendulum(), 10.0, 1e-3, record_every=10, progress=False)
    along = 2 * result.body("rod").position
    cosine, sine = -along[:, 1:2], along[:, :1]
    across = np.column_stack([-along[:, 1], along[:, 0], 0 * along[:, 0]])
    exact = 9.81 * (-2.5 * cosine * along + sine / 4 * across)
    assert np.abs(result.reaction("pin").force - exact).max() <= 1e-7 * np.abs(exact).max()


#: Steps [s] that are too large.
COARSE = {
    "pendulum": 0.05,
    "rod_pendulum": 0.05,
    "heavy_top": 2e-3,
    "torque_free_top": 0.1,
    "four_bar_1": 0.05,
    "four_bar_2": 0.05,
    "andrews": 1e-4,
    "bricard": 0.05,
    "flyball_governor": 2.5e-4,
}


@pytest.mark.parametrize("name", COARSE)
def test_a_step_that_is_too_large_misses_the_figures(name: str) -> None:
    assert not replace(PROBLEMS[name], step=COARSE[name]).run().passed


def document(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, Any]:
    code = run(words, debug=False)
    return code, json.loads(capsys.readouterr().out)


def test_command_says_what_it_measured(capsys: pytest.CaptureFixture[str]) -> None:
    code, said = document(["validate", "pendulum", "torque_free_top", "--json"], capsys)
    assert code == 0 and said["passed"]
    assert [it["problem"] for it in said["problems"]] == ["pendulum", "torque_free_top"]
    for problem in said["problems"]:
        assert problem["method"] and problem["source"] and problem["seconds"] > 0
        assert all(it["error"] <= it["required"] for it in problem["figures"])


def test_command_fails_where_a_figure_is_missed(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(PROBLEMS, "pendulum", replace(PROBLEMS["pendulum"], step=0.05))
    code, said = document(["validate", "pendulum", "--json"], capsys)
    assert code == 1 and not said["passed"]
    assert run(["validate", "pendulum"], debug=False) == 1
    assert "1 of 1 problems FAILED" in capsys.readouterr().out


def test_run_that_fails_is_a_verdict(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(PROBLEMS, "flyball_governor", replace(PROBLEMS["flyball_governor"], step=0.1))
    (verdict,) = validate(["flyball_governor"])
    assert not verdict.passed and "step 0.1 s is too long" in verdict.reason


def test_what_is_not_a_number_does_not_pass() -> None:
    values: Floats = np.array([np.nan])
    assert not Figure("position", float(values[0]), 1.0).passed


def test_unknown_problem_is_answered_with_the_nearest() -> None:
    with pytest.raises(lw.OptionError, match="the nearest is 'andrews'"):
        validate(["andrew"])
