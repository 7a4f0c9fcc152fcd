"""Formulations, stabilizations, linear solvers and integrators: all combinations run, or name a way out."""

from __future__ import annotations

import re
import warnings
from itertools import product
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core
from linkwork.integrators import METHODS, EmbeddedPair

FORMULATIONS = [info.name for info in _core.formulations()]
STABILIZATIONS = [info.name for info in _core.stabilizations()]
SOLVERS = [info.name for info in _core.linear_solvers()]
AVAILABLE = [info.name for info in _core.linear_solvers() if info.available]

WAY_OUT = re.compile(r"\b(use|choose|leave|give|nearest)\b")

MODEL = lw.mechanisms.four_bar()  # with redundant equations
REFERENCE = lw.simulate(MODEL, 3e-3, 1e-3, progress=False).q[-1]


def runs(**options: Any) -> bool:
    """False: refused, with a way out."""
    adaptive = isinstance(METHODS[options["integrator"]], EmbeddedPair)
    steps: dict[str, Any] = {"rtol": 1e-6, "record_every": 1} if adaptive else {"step": 1e-3}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", lw.LinkworkWarning)
            result = lw.simulate(MODEL, 3e-3, progress=False, **steps, **options)
    except lw.OptionError as error:
        assert WAY_OUT.search(str(error)), f"{options}: {error}"
        return False
    assert np.isfinite(result.multipliers).all(), options
    np.testing.assert_allclose(result.q[-1], REFERENCE, atol=1e-4, err_msg=str(options))
    return True


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("stabilization", STABILIZATIONS)
def test_every_combination_runs_or_is_refused_with_a_way_out(formulation: str, stabilization: str) -> None:
    ran = 0
    for solver, integrator in product(["auto", *SOLVERS], METHODS):
        ran += runs(
            formulation=formulation, stabilization=stabilization, linear_solver=solver, integrator=integrator
        )
    for solver, form in product(["auto", *SOLVERS], ["kkt", "schur"]):
        ran += runs(
            formulation=formulation, stabilization=stabilization, linear_solver=solver, matrix_form=form,
            integrator="rk4",
        )  # fmt: skip
    assert ran > len(AVAILABLE) * len(METHODS) / 2
