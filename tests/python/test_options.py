"""What a choice cannot do is refused with the reason, never ignored."""

from __future__ import annotations

import math
from typing import Any

import linkwork as lw
import pytest
from linkwork import _core

#: Options that are refused, and what the message must have.
REFUSED: dict[str, tuple[dict[str, Any], list[str]]] = {
    "unknown formulation": ({"formulation": "standart"}, ["'standart'", "'standard'"]),
    "unknown stabilization": ({"stabilization": "baumgart"}, ["'baumgart'", "'baumgarte'"]),
    "unknown linear solver": ({"linear_solver": "umpfack"}, ["'umpfack'", "'umfpack'"]),
    "unknown system": ({"system": "shur"}, ["'shur'", "'schur'"]),
    "unknown option": ({"formulaton": "standard"}, ["'formulaton'", "'formulation'"]),
    "penalty without a penalty": ({"penalty": 1e7}, ["penalty", "'standard'", "'augmented_lagrangian'"]),
    "frequency without a penalty": ({"frequency": 10.0}, ["frequency", "'standard'", "'penalty'"]),
    "iterations without iteration": (
        {"formulation": "penalty", "max_iterations": 3},
        ["max_iterations", "'penalty'", "'augmented_lagrangian'"],
    ),
    "tolerance without iteration": (
        {"tolerance": 1e-9},
        ["tolerance", "'standard'", "'augmented_lag"],
    ),
    "negative penalty": ({"formulation": "penalty", "penalty": -3.0}, ["penalty", "-3.0"]),
    "NaN penalty": ({"formulation": "penalty", "penalty": math.nan}, ["penalty", "nan"]),
    "no iterations": ({"formulation": "augmented_lagrangian", "max_iterations": 0}, ["max_iterations", "0"]),
    "gains of no stabilization": (
        {"stabilization": "none", "baumgarte_alpha": 1.0, "baumgarte_beta": 1.0},
        ["baumgarte_alpha", "'none'"],
    ),
    "one gain of two": ({"baumgarte_beta": 1.0}, ["baumgarte_beta", "baumgarte_alpha"]),
    "damping with another stabilization": (
        {"formulation": "penalty", "damping_ratio": 1.0, "stabilization": "sampled_baumgarte"},
        ["damping_ratio", "'baumgarte'", "'sampled_baumgarte'"],
    ),
    "two pairs of gains": (
        {"formulation": "penalty", "frequency": 10.0, "baumgarte_alpha": 1.0, "baumgarte_beta": 1.0},
        ["frequency", "baumgarte_alpha"],
    ),
    "a solver that cannot factorize the system": (
        {"system": "kkt", "linear_solver": "eigen_ldlt"},
        ["'eigen_ldlt'", "kkt", "'schur'"],
    ),
    "a system that the formulation does not have": (
        {"formulation": "penalty", "system": "schur"},
        ["'schur'", "'penalty'"],
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_an_option_that_cannot_be_honored_is_refused_with_the_reason(case: str) -> None:
    options, fragments = REFUSED[case]
    with pytest.raises(lw.OptionError) as caught:
        lw.System(lw.mechanisms.pendulum(), **options)
    message = str(caught.value)
    assert [fragment for fragment in fragments if fragment not in message] == [], message


@pytest.mark.parametrize("formulation", [info.name for info in _core.formulations()])
@pytest.mark.parametrize("system", ["auto", "kkt", "schur"])
@pytest.mark.parametrize("linear_solver", ["auto", *(info.name for info in _core.linear_solvers())])
def test_a_choice_of_methods_is_honored_or_refused(formulation: str, system: str, linear_solver: str) -> None:
    info = {f.name: f for f in _core.formulations()}[formulation]
    solvable = {s.name: s.systems if s.available else [] for s in _core.linear_solvers()} | {
        "auto": info.systems
    }
    possible = [s for s in info.systems if system in ("auto", s) and s in solvable[linear_solver]]
    choice = {"formulation": formulation, "system": system, "linear_solver": linear_solver}
    if not possible:
        with pytest.raises(lw.OptionError):
            lw.System(lw.mechanisms.chain(3), **choice)
        return
    chosen = lw.System(lw.mechanisms.chain(3), **choice).options
    assert chosen["system"] in possible
    assert chosen["linear_solver"] == linear_solver or linear_solver == "auto"


def test_damping_ratio_and_frequency_are_gains_of_baumgarte() -> None:
    options = lw.System(
        lw.mechanisms.pendulum(), formulation="penalty", damping_ratio=0.5, frequency=20.0
    ).options
    assert options["stabilization"] == "baumgarte"
    assert (options["baumgarte_alpha"], options["baumgarte_beta"]) == (10.0, 20.0)


def test_the_textbook_damping_ratio_is_one() -> None:
    options = lw.System(lw.mechanisms.pendulum(), formulation="penalty", frequency=10.0).options
    assert (options["baumgarte_alpha"], options["baumgarte_beta"]) == (10.0, 10.0)


def test_none_stands_for_the_default() -> None:
    given = lw.System(lw.mechanisms.pendulum(), penalty=None, linear_solver="auto").options
    assert given == lw.System(lw.mechanisms.pendulum()).options
