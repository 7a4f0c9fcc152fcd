"""The order of a method as steps go to zero, where the steps of the grid are too large to show it.

Over a whole run the error grows by what the mechanism makes of it, and terms of higher order hide the leading
one; so order is observed early in the motion, and with steps that are halved from coarse ones until the
reference or rounding ends it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from linkwork.comparison.choices import Choice

__all__ = ["WINDOW", "OrderStudy", "Study"]

#: Share of the run in which order is observed.
WINDOW = 0.25

#: Doublings of the largest step to begin with, halvings of the smallest at the end, and the time of a run [s]
#: after which there is no other.
DOUBLINGS, HALVINGS, LONGEST_SECONDS = 3, 6, 0.5

#: Errors less than so many times the reference's own, or rounding, show no order.
ABOVE_REFERENCE, ROUNDING = 10.0, 1e-12

#: By so much more than the order of the integrator errors fall only where steps were far too large.
TOO_GOOD = 1.5

#: An order this low says that the error does not depend on the step.
STAGNANT = 0.3


@dataclass(frozen=True)
class Study:
    """A method whose order is to be observed around these steps [s]."""

    choice: Choice
    largest: float
    smallest: float

    @property
    def key(self) -> str:
        return f"order {self.choice.key} steps={self.largest!r},{self.smallest!r}"

    @property
    def divisions(self) -> list[int]:
        """Powers of two by which the largest step is divided, negative ones first."""
        finest = math.ceil(math.log2(self.largest / self.smallest)) + HALVINGS
        return list(range(-DOUBLINGS, finest + 1))

    @property
    def label(self) -> str:
        return f"order of {self.choice.label}"


@dataclass(frozen=True)
class OrderStudy:
    """Errors by step, over the first quarter of the run."""

    method: str  #: as `Outcome.method`
    label: str
    steps: Sequence[float]
    errors: Mapping[str, Sequence[float | None]]  #: each error of `measures`, a number for each step
    floors: Mapping[str, float]  #: below which an error is that of the reference, or rounding
    nominal: int | None = None  #: order of the integrator, where it is known

    def order(self, error: str) -> float | None:
        """Of the finest two steps whose error is above the floor; None where there are none."""
        found = None
        points = list(zip(self.steps, self.errors[error], strict=True))
        for (coarse, of_coarse), (fine, of_fine) in pairwise(points):
            if of_coarse is None or of_fine is None or of_fine <= self.floors[error] or of_coarse >= 1:
                continue
            order = math.log(of_coarse / of_fine) / math.log(coarse / fine)
            if self.nominal is None or order < self.nominal + TOO_GOOD:
                found = order
        return found

    def stagnation(self, error: str) -> float | None:
        """The error that no smaller step makes smaller, such as that of a penalty; None: there is none."""
        order = self.order(error)
        known = [value for value in self.errors[error] if value is not None]
        return known[-1] if order is not None and order < STAGNANT and len(known) > 2 else None
