"""The choices of a benchmark, checked before it begins."""

from __future__ import annotations

import math
from collections.abc import Sequence

from linkwork.errors import OptionError
from linkwork.options import compile_options


def check_choices(
    solvers: Sequence[str], formulation: str, matrix_form: str, rounds: int, limit: float, threads: int = 1
) -> None:
    """OptionError: a name that does not exist, a number that cannot be. A solver that is not in this build is
    refused later, with the reason, beside those that are.
    """
    for solver in solvers:
        try:
            compile_options({"linear_solver": solver, "formulation": formulation, "matrix_form": matrix_form})
        except OptionError as error:
            if error.code != "linear_solver_not_built":
                raise
    if threads < 1:
        raise OptionError(f"threads {threads} is too small: at least 1", code="threads")
    if rounds < 1:
        raise OptionError(f"repeats {rounds} is too small: at least 1", code="repeats")
    if not (math.isfinite(limit) and limit > 0):
        raise OptionError(f"limit {limit:g} s must be a finite number, positive", code="limit")
