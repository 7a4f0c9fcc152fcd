"""Reference problems, published or in closed form and computed without linkwork, and our error against each.

    from linkwork import validation

    for verdict in validation.validate():
        print(verdict.problem, verdict.passed, [figure.error for figure in verdict.figures])

`linkwork validate` prints them as a table.
"""

from __future__ import annotations

from linkwork.validation.problem import Figure, Problem, Verdict
from linkwork.validation.problems import PROBLEMS, validate
from linkwork.validation.series import Series

__all__ = ["PROBLEMS", "Figure", "Problem", "Series", "Verdict", "validate"]
