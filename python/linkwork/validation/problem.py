"""What a reference problem is: a run with the recommended method, and its errors against figures required."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import LinkworkError
from linkwork.mechanisms import MECHANISMS
from linkwork.running.simulation import simulate
from linkwork.validation.series import Series

if TYPE_CHECKING:
    from linkwork.results.result import Result

__all__ = ["Figure", "Problem", "Verdict"]


@dataclass(frozen=True)
class Figure:
    """An error, and how large it may be."""

    quantity: str
    error: float
    required: float
    unit: str = ""  #: empty: relative to the largest value

    @property
    def passed(self) -> bool:
        """False for what is not a number, too."""
        return bool(self.error <= self.required)


@dataclass(frozen=True)
class Verdict:
    """What came out of a problem; without figures where the run failed, for the `reason`."""

    problem: str
    source: str
    method: str
    figures: Sequence[Figure]
    seconds: float
    reason: str = ""

    @property
    def passed(self) -> bool:
        return bool(self.figures) and all(figure.passed for figure in self.figures)

    def document(self) -> dict[str, Any]:
        """As data, for JSON."""
        figures = [{**asdict(figure), "passed": figure.passed} for figure in self.figures]
        return {**asdict(self), "figures": figures, "passed": self.passed}


@dataclass(frozen=True)
class Problem:
    """A mechanism run as its documentation recommends, with frames at the times of the solution.

    name       of the problem
    source     where the solution comes from
    solution   name of the file in data/
    measure    (result, solution) -> figures
    mechanism, parameters
               in linkwork.mechanisms
    t_end      [s]; None: to the end of the solution
    step       [s]; None: the recommended one
    """

    name: str
    source: str
    solution: str
    measure: Callable[[Result, Series], Sequence[Figure]]
    mechanism: str
    parameters: Mapping[str, Any] = field(default_factory=dict)
    t_end: float | None = None
    step: float | None = None

    def run(self) -> Verdict:
        """Never raises a LinkworkError: a run that fails is a verdict, too."""
        started = time.perf_counter()
        try:
            result, solution = self.result(), Series(self.solution)
            figures = tuple(self.measure(result, solution))
            options = result.manifest["options"]
            names = (options["formulation"], options["stabilization"], options["integrator"])
            method = f"{', '.join(names)}, step {options['step']:g} s"
        except LinkworkError as error:
            seconds = time.perf_counter() - started
            return Verdict(self.name, self.source, "", (), seconds, str(error))
        return Verdict(self.name, self.source, method, figures, time.perf_counter() - started)

    def result(self) -> Result:
        solution, mechanism = Series(self.solution), MECHANISMS[self.mechanism]
        settings = dict(mechanism.settings)
        t_end = self.t_end or min(float(solution("t")[-1]), settings["t_end"])
        step = self.step or settings["step"]
        rest = {name: value for name, value in settings.items() if name not in ("t_end", "step")}
        return simulate(
            mechanism.function(**self.parameters), t_end, step, record_every=round(solution.interval / step),
            progress=False, on_inaccurate="pass", **rest,
        )  # fmt: skip


def largest(values: Floats) -> float:
    """Magnitude of the largest value; infinite where one is not finite or there is none."""
    return float(np.abs(values).max()) if values.size and np.isfinite(values).all() else float("inf")


def relative(values: Floats, exact: Floats) -> float:
    """Largest difference over the largest exact value."""
    return largest(values - exact) / largest(exact)
