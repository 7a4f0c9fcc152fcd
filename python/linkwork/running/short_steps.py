"""Steps that are, or have become, so short that a run hardly goes on."""

from __future__ import annotations

import heapq
import math
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import StepSizeError, warn
from linkwork.modeling.elements import KINDS
from linkwork.running.progress import time_in_words

if TYPE_CHECKING:
    from linkwork.modeling.model import Model
    from linkwork.motion.header import Header

__all__ = ["Pace", "Places", "ShortSteps", "Suspects", "second_run"]

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

#: Where fewer steps are taken in a second, what each of them takes is why.
FEW = 100.0

#: Forces that are named.
LISTED = 3

#: Whether it is a second run that has begun, beside one that was told of; None: a first one.
_BESIDE: ContextVar[bool | None] = ContextVar("beside", default=None)


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


class Suspects(NamedTuple):
    """Forces that may be why a run is slow, by what is known of them without a call."""

    sharp: Sequence[str] = ()  #: with the smallest transitions
    functions: Sequence[str] = ()  #: of the user's

    @classmethod
    def of(cls, header: Header, model: Model) -> Suspects:
        places = {kind: list(KINDS["force"][kind].parameters) for kind in set(header.force_kinds)}
        transitions: list[tuple[float, str]] = []
        for name, kind, first in zip(
            header.force_names, header.force_kinds, header.force_first_parameter, strict=False
        ):
            if "transition" in places[kind]:
                place = first + places[kind].index("transition")
                transitions.append((float(header.force_parameters[place]), name))
        sharp = [
            f"'{name}' with transition {least:g}" for least, name in heapq.nsmallest(LISTED, transitions)
        ]
        return cls(sharp, [f"the function of '{name}'" for name, _ in model._calls[:LISTED]])


@dataclass(frozen=True)
class Slow:
    """A pace by which the rest of a run takes very long."""

    told: str
    rate: float  # steps in a second
    left: float  # steps

    def why(self, suspects: Suspects) -> str:
        """In sentences."""
        costly = self.rate < FEW
        found = [self._of_cost(suspects)] if costly else []
        if not costly or self.left >= MANY:
            found.append(self._of_number(suspects))
        return " ".join(found)

    def _of_cost(self, suspects: Suspects) -> str:
        asked = "a function in Python is called several times in each, and may be slow"
        why = f": {asked}{_perhaps(suspects.functions)}" if suspects.functions else ", as of a large model"
        return f"Each step takes {1 / self.rate:.2g} s{why}."

    def _of_number(self, suspects: Suspects) -> str:
        here = _perhaps([*suspects.sharp, *suspects.functions])
        return (
            "A force that changes sharply with velocity or position asks for such steps, as friction with a "
            f"small transition, a function with a jump, or noise{here}. "
            "Make it smoother, or give larger rtol and atol."
        )


def _perhaps(forces: Sequence[str]) -> str:
    return f": here perhaps {', '.join(forces)}" if forces else ""


class Pace:
    """Of a run from t to t_end [s], over the last PACE_SECONDS."""

    def __init__(self, t: float, steps: int, t_end: float) -> None:
        self._t_end, self._tiny = t_end, TINY * (t_end - t)
        self._began = self._since = time.monotonic()
        self._t, self._steps = t, steps

    def look(self, t: float, steps: int) -> Slow | None:
        """At time t [s] after that many steps; None: the run will not take very long."""
        now = time.monotonic()
        spent, taken, passed = now - self._since, steps - self._steps, t - self._t
        if spent < PACE_SECONDS or taken <= 0 or passed < 0.0:  # one that is resumed takes steps again
            return None
        self._since, self._t, self._steps = now, t, steps
        step, rate = passed / taken, taken / spent
        left = (self._t_end - t) / step if step > 0.0 else math.inf
        rest = left / rate
        if rest < SLOW_SECONDS or passed >= self._tiny * taken:
            return None
        longer = f"more than {time_in_words(MOST_SECONDS)}" if rest > MOST_SECONDS else time_in_words(rest)
        told = (
            f"the run is at t = {t:.6g} of {self._t_end:.6g} s after {time_in_words(now - self._began)}, "
            f"with steps of about {step:.2g} s, {rate:.2g} a second: at this pace it takes {longer} more"
        )
        return Slow(told, rate, left)


@contextmanager
def second_run(told: bool) -> Iterator[None]:
    """One that is finer than another begins, of which it is `told` that it is slow: nobody is told twice."""
    before = _BESIDE.set(told)
    try:
        yield
    finally:
        _BESIDE.reset(before)


class ShortSteps:
    """Of a run with steps as long as its tolerances allow; `state`: what gives y = (q, v, ...) now.

    forces  those that may be why; None: steps are fixed, and their pace is no surprise
    """

    def __init__(
        self,
        t: float,
        steps: int,
        t_end: float,
        state: Callable[[], Floats],
        forces: Callable[[], Suspects] | None = None,
    ) -> None:
        self._forces = forces
        beside = _BESIDE.get()
        self._who = "" if beside is None else "the second run, by verify: "
        self._pace = Pace(t, steps, t_end)
        self._t, self._steps, self._t_end = t, steps, t_end
        self._state, self._start = state, Places.of(state())
        self._usual = 0.0  # the longest mean between two looks [s]
        self._since: tuple[float, int] | None = None  # time and steps at the first of the short ones
        self._looks, self.told = 0, beside is True

    def look(self, t: float, steps: int) -> None:
        """At time t [s] after that many steps; LinkworkWarning, once: they are short, and stay so."""
        taken, passed = steps - self._steps, t - self._t
        if self.told or taken <= 0:
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

    def _tell_pace(self, slow: Slow, suspects: Suspects) -> None:
        self.told = True
        warn(f"{self._who}{slow.told}. {slow.why(suspects)} Interrupted (ctrl-C), the run keeps what it has")

    def _tell(self, since: float, steps_before: int) -> None:
        self.told = True
        step = (self._t - since) / (self._steps - steps_before)
        rest = f"{(self._t_end - self._t) / step:.2g} more" if step > 0.0 else "more than can be counted"
        rounded = self._rounded(step)
        why = f": {rounded}. A force that jumps to and fro does so, too" if rounded else JUMPS
        warn(
            f"{self._who}since t = {since:.6g} s steps are about {step:.2g} s, {self._usual:.2g} s and more "
            f"before: to {self._t_end:.6g} s there would be {rest}{why}, such as friction by "
            "the sign of a velocity: let it go through zero within a small velocity, as that of "
            "linkwork does, or end the run there by an event. Interrupted (ctrl-C), it keeps what it has"
        )
