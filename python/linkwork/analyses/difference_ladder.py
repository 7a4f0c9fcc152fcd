"""Differences with steps, and with smaller ones until they agree: derivatives whose error is known.

As in C. Ridders, Accurate computation of F'(x) and F'(x) F''(x), Adv. Eng. Software 4 (1982) 75-76.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from linkwork.arrays import Floats

__all__ = ["Difference", "Ladder", "descend", "difference", "largest"]

#: The error of a difference relative to it, from which on smaller steps are tried.
AGREED = 1e-2

#: By which steps become smaller, from rung to rung.
FACTOR = 100.0

#: Rungs where the size of the parameter is known, and where it is not.
RUNGS_OF_KNOWN, RUNGS = 4, 6

#: A disagreement relative to the derivative, up to which it may grow when the step becomes smaller, by noise.
#: Above it something smaller than the steps begins to show, as a turn through many revolutions.
GREW = 1e-5

#: A disagreement that falls by less from rung to rung does not go to zero with the step.
FALLS = 0.9


class Difference(NamedTuple):
    """A derivative by the steps h and h/2, and what it is off by."""

    step: float
    derivative: Floats
    apart: Floats  #: how much the steps disagree
    noise: Floats  #: by rounding, and by the errors of the runs

    @property
    def error(self) -> Floats:
        return self.apart + self.noise

    @property
    def part(self) -> float:
        """Of the error in the derivative, where they are largest."""
        size, error = largest(self.derivative), largest(self.error)
        return error / size if size > 0.0 else np.inf if error > 0.0 else 0.0

    def agrees(self, negligible: float) -> bool:
        """The steps with each other, up to noise or to what does not matter."""
        return largest(self.apart) <= max(AGREED * largest(self.derivative), largest(self.noise), negligible)


def largest(values: Floats) -> float:
    return float(np.abs(values).max(initial=0.0))


def difference(samples: list[Floats], middle: Floats, at: float, h: float, of_runs: Floats) -> Difference:
    """From outputs where a parameter is at -h, at -h/2, at h/2, at h and at itself.

    d = (4 d(h/2) - d(h)) / 3. Central differences do not see a kink: the derivatives on both sides do, which
    differ by second differences over h. With f = d(h/2), c = d(h), and the jumps l, b of these derivatives
    with h/2 and h, a kink of jump J at s h beside the middle gives
        s <= 1/2:  f - c = -s J / 2,  2 l - b = (1 - 3 s) J,  and d is off by (1/2 - 7 s / 6) J,
        s >= 1/2:  f - c = -(1 - s) J / 2,  and d is off by (1 - s) J / 6,
    which |f - c| + |2 l - b| / 2 is never less than.
    """
    coarse, fine = (samples[3] - samples[0]) / (2 * h), (samples[2] - samples[1]) / h
    bend, less = (samples[3] - 2 * middle + samples[0]) / h, (samples[2] - 2 * middle + samples[1]) / (h / 2)
    derivative = (4 * fine - coarse) / 3
    of_outputs, of_parameter = np.max(np.abs(samples), axis=0), (abs(at) + h) * np.abs(derivative)
    rounding = 4 * np.finfo(float).eps * (of_outputs + of_parameter) / h
    apart = np.abs(fine - coarse) + np.abs(2 * less - bend) / 2
    return Difference(h, derivative, apart, rounding + of_runs)


@dataclass
class Ladder:
    """Differences of one output by one parameter, each with a smaller step than that before."""

    negligible: float  #: derivatives that are no more than this are as good as zero
    known: bool  #: whether the first step is of the size of the parameter, or a guess
    rungs: list[Difference] = field(default_factory=list)

    @property
    def settled(self) -> bool:
        """The last two agree, or the one that there is, where its step is no guess."""
        if len(self.rungs) < 2:
            return self.known and any(it.agrees(self.negligible) for it in self.rungs)
        before, last = self.rungs[-2:]
        between, size = largest(before.derivative - last.derivative), largest(self.best.derivative)
        return (
            self.best.agrees(self.negligible)
            and between <= max(AGREED * size, self.negligible)
            and largest(last.apart) <= max(largest(before.apart), GREW * size, self.negligible)
        )

    @property
    def hopeless(self) -> bool:
        """Where the size of the parameter is known: smaller steps disagree as much, as at a kink."""
        if not self.known or len(self.rungs) < 2:
            return False
        before, last = self.rungs[-2:]
        return not last.agrees(self.negligible) and largest(last.apart) > FALLS * largest(before.apart)

    @property
    def best(self) -> Difference:
        return min(self.rungs[-2:] if self.rungs[-1].agrees(self.negligible) else self.rungs,
                   key=lambda it: it.part)  # fmt: skip

    @property
    def error(self) -> Floats:
        """Of the best: its own, and what it differs by from the others as far as their noise does not."""
        best, settled = self.best, self.settled
        others = [it for it in (self.rungs[-2:] if settled else self.rungs) if it is not best]
        apart = [np.abs(it.derivative - best.derivative) - it.error for it in others]
        error: Floats = np.max([best.error, *apart], axis=0)
        return error


def descend(
    ladders: dict[str, Ladder],
    differences: Callable[[float], dict[str, Difference]],
    step: float,
    least: float,
    most: int | None,
) -> None:
    """With smaller steps until all of them are settled, or none is worth going on with."""
    known = all(it.known for it in ladders.values())
    for _ in range(most or (RUNGS_OF_KNOWN if known else RUNGS)):
        for name, it in differences(step).items():
            if not ladders[name].settled:
                ladders[name].rungs.append(it)
        step /= FACTOR
        if step < least or all(it.settled or it.hopeless for it in ladders.values()):
            return
