"""Steps that are, or have become, so short that a run hardly goes on."""

from __future__ import annotations

import heapq
import math
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import StepSizeError, warn
from linkwork.modeling.elements import KINDS
from linkwork.running.progress import time_in_words

if TYPE_CHECKING:
    from linkwork.modeling.model import Model
    from linkwork.motion.header import Header

__all__ = ["Pace", "Places", "ShortSteps", "sharp_forces"]

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

#: A pace is that of so many seconds. It is slow where the rest of a run takes longer than the second [s], in
#: steps of less than this part of the run; nobody is told of more than the last [s].
PACE_SECONDS, SLOW_SECONDS, TINY, MOST_SECONDS = 10.0, 3600.0, 1e-6, 100 * 365 * 86400.0

#: Forces that are named.
LISTED = 3


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


class Pace:
    """Of a run from t to t_end [s], over the last PACE_SECONDS."""

    def __init__(self, t: float, steps: int, t_end: float) -> None:
        self._t_end, self._tiny = t_end, TINY * (t_end - t)
        self._began = self._since = time.monotonic()
        self._t, self._steps = t, steps

    def look(self, t: float, steps: int) -> str:
        """At time t [s] after that many steps: why the run will take very long, or nothing."""
        now = time.monotonic()
        spent, taken, passed = now - self._since, steps - self._steps, t - self._t
        if spent < PACE_SECONDS or taken <= 0 or passed < 0.0:  # one that is resumed takes steps again
            return ""
        self._since, self._t, self._steps = now, t, steps
        rest = (self._t_end - t) * spent / passed if passed > 0.0 else math.inf
        if rest < SLOW_SECONDS or passed >= self._tiny * taken:
            return ""
        longer = f"more than {time_in_words(MOST_SECONDS)}" if rest > MOST_SECONDS else time_in_words(rest)
        return (
            f"the run is at t = {t:.6g} of {self._t_end:.6g} s after {time_in_words(now - self._began)}, "
            f"with steps of about {passed / taken:.2g} s, {taken / spent:.2g} a second: at this pace it "
            f"takes {longer} more"
        )


def sharp_forces(header: Header, model: Model) -> str:
    """Which of the forces may ask for tiny steps, by what is known of them without a call, or nothing."""
    places = {kind: list(KINDS["force"][kind].parameters) for kind in set(header.force_kinds)}
    transitions: list[tuple[float, str]] = []
    for name, kind, first in zip(
        header.force_names, header.force_kinds, header.force_first_parameter, strict=False
    ):
        if "transition" in places[kind]:
            place = first + places[kind].index("transition")
            transitions.append((float(header.force_parameters[place]), name))
    sharpest = [f"'{name}' with transition {least:g}" for least, name in heapq.nsmallest(LISTED, transitions)]
    return ", ".join([*sharpest, *(f"the function of '{name}'" for name, _ in model._calls[:LISTED])])


class ShortSteps:
    """Of a run with steps as long as its tolerances allow; `state`: what gives y = (q, v, ...) now.

    forces  those that may be why, in words; None: steps are fixed, and their pace is no surprise
    """

    def __init__(
        self,
        t: float,
        steps: int,
        t_end: float,
        state: Callable[[], Floats],
        forces: Callable[[], str] | None = None,
    ) -> None:
        self._forces = forces
        self._pace = Pace(t, steps, t_end)
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
        if self._forces is not None and (slow := self._pace.look(t, steps)):
            self._tell_pace(slow, self._forces())
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

    def _tell_pace(self, slow: str, forces: str) -> None:
        self._told = True
        here = f": here perhaps {forces}" if forces else ""
        warn(
            f"{slow}. A force that changes sharply with velocity or position asks for such steps, as "
            f"friction with a small transition, a function with a jump, or noise{here}. Make it smoother, or "
            "give larger rtol and atol. Interrupted (ctrl-C), the run keeps what it has"
        )

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
