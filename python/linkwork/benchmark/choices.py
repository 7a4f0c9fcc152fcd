"""The choices of a benchmark, checked before it begins."""

from __future__ import annotations

import math
from collections.abc import Sequence

from linkwork.benchmark.isolated import Failure, isolated
from linkwork.benchmark.subject import Subject
from linkwork.errors import OptionError
from linkwork.options import compile_options
from linkwork.system import System

#: Of the errors of formulation "standard": those that the substitute does not have.
STANDARD_CANNOT = ("dependent_constraints", "singular_pose", "massless_body")
SUBSTITUTE = "augmented_lagrangian"


def check_choices(
    solvers: Sequence[str], formulation: str | None, system: str, rounds: int, limit: float
) -> None:
    """OptionError: a name that does not exist, a number that cannot be."""
    for solver in solvers:
        compile_options({"linear_solver": solver, "formulation": formulation, "system": system})
    if rounds < 1:
        raise OptionError(f"repeats {rounds} is too small: at least 1", code="repeats")
    if not (math.isfinite(limit) and limit > 0):
        raise OptionError(f"limit {limit:g} s must be a finite number, positive", code="limit")


def choose_formulation(subject: Subject, given: str | None, limit: float) -> tuple[str, str | None]:
    """The one that was given, else "standard", or what stands in for it and the reason."""
    if given is not None:
        return given, None
    answer = isolated(why_not_standard, subject, seconds=limit)
    if isinstance(answer, Failure) and answer.code in STANDARD_CANNOT:
        return SUBSTITUTE, answer.reason
    return "standard", None


def why_not_standard(subject: Subject) -> None:
    """A LinkworkError with a code of STANDARD_CANNOT: redundant joints or massless bodies."""
    System(subject.build(), formulation="standard", linear_solver="klu")
