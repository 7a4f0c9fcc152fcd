"""Steps that have become so short that a run hardly goes on."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import StepSizeError, warn

__all__ = ["Places", "ShortSteps"]

Piece = TypeVar("Piece")

#: Short are steps of less than this part of those before, where the rest of the run takes so many of them.
SHORTER, MANY = 1e-3, 1e7

#: Looks in a row, and steps in these, after which it is no matter of a moment, such as a hard contact is.
LOOKS, STEPS = 10, 5000

#: The usual reason.
JUMPS = ". A force that jumps to and fro does so"

#: Of the way of a step: rounding of a larger part is felt. Of the size of a mechanism, or of the way that it
#: has come: where it is farther from the origin, that is why.
FELT, FAR = 1e-5, 1e2


@dataclass(frozen=True)
class Places:
    """Where the bodies of a state y = (q, v, ...) are, and how fast they move."""

    middle: Floats  #: of all [m]
    size: float  #: largest distance from there [m]
    distance: float  #: largest from the origin [m]
    speed: float  #: largest [m/s]

    @classmethod
    def of(cls, y: Floats) -> Places:
        bodies = len(y) // 13
        places = y[: 7 * bodies].reshape(-1, 7)[:, :3]
        velocities = y[7 * bodies : 13 * bodies].reshape(-1, 6)[:, :3]
        middle = places.sum(axis=0) / max(bodies, 1)
        return cls(middle, _longest(places - middle), _longest(places), _longest(velocities))

    def rounded(self, start: Places, step: float) -> str:
        """What the rounding of positions is beside a step [s] of a motion from `start` on, or nothing."""
        rounding, way = float(np.spacing(self.distance)), self.speed * step
        extent = max(self.size, float(np.linalg.norm(self.middle - start.middle)))
        if not rounding > FELT * way or not self.distance > FAR * extent:
            return ""
        return (
            f"positions {self.distance:.2g} m from the origin are rounded to {rounding:.1g} m, where bodies "
            f"move {way:.1g} m in a step: stiff forces feel that. Place the mechanism nearer to the origin, "
            "or give larger rtol and atol"
        )


def _longest(vectors: Floats) -> float:
    return float(np.linalg.norm(vectors, axis=1).max(initial=0.0))


class ShortSteps:
    """Of a run with steps as long as its tolerances allow; `state`: what gives y = (q, v, ...) now."""

    def __init__(self, t: float, steps: int, t_end: float, state: Callable[[], Floats]) -> None:
        self._t, self._steps, self._t_end = t, steps, t_end
        self._state, self._start = state, Places.of(state())
        self._usual = 0.0  # the longest mean between two looks [s]
        self._since: tuple[float, int] | None = None  # time and steps at the first of the short ones
        self._looks, self._told = 0, False

    def look(self, t: float, steps: int) -> None:
        """At time t [s] after that many steps; LinkworkWarning, once: they are short, and stay so."""
        taken, passed = steps - self._steps, t - self._t
        if self._told or taken <= 0:
            return
        before = self._t, self._steps
        self._t, self._steps = t, steps
        self._usual = max(self._usual, passed / taken)
        if passed >= SHORTER * self._usual * taken or (self._t_end - t) * taken < MANY * passed:
            self._since, self._looks = None, 0
            return
        self._since = self._since or before
        self._looks += 1
        if self._looks >= LOOKS and steps - self._since[1] >= STEPS:
            self._tell(*self._since)

    def explained(self, pieces: Iterator[Piece]) -> Iterator[Piece]:
        """The same; a StepSizeError says so where no step is short enough for the rounding of positions."""
        try:
            yield from pieces
        except StepSizeError as error:
            if error.step is not None and (rounded := self._rounded(error.step)):
                error.message = f"{error.message}; {rounded}"
                error.args = (error.message,)
            raise

    def _rounded(self, step: float) -> str:
        return Places.of(self._state()).rounded(self._start, step)

    def _tell(self, since: float, steps_before: int) -> None:
        self._told = True
        step = (self._t - since) / (self._steps - steps_before)
        rest = f"{(self._t_end - self._t) / step:.2g} more" if step > 0.0 else "more than can be counted"
        rounded = self._rounded(step)
        why = f": {rounded}. A force that jumps to and fro does so, too" if rounded else JUMPS
        warn(
            f"since t = {since:.6g} s steps are about {step:.2g} s, {self._usual:.2g} s and more before: to "
            f"{self._t_end:.6g} s there would be {rest}{why}, such as friction by "
            "the sign of a velocity: let it go through zero within a small velocity, as that of "
            "linkwork does, or end the run there by an event. Interrupted (ctrl-C), it keeps what it has"
        )
