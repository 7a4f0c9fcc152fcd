"""Functions of the user's own that do something for a moment, which no step may see.

A pulse between the stages of a step, or one that a step of adaptive size leaps over, leaves no trace in the
run. So functions of time are looked at beside it, at times that are in step with nothing; where one is far
from what its neighbors say, the steps that come there are taken again, in parts that end there.

Functions that may remember calls are left alone, and those of the state cannot be looked at.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from linkwork.arguments import reals
from linkwork.arrays import Floats
from linkwork.functions import Broken, Callback, Expression, Sum, TimeFunction
from linkwork.modeling.model import Model
from linkwork.running import callbacks

__all__ = ["Looks", "Pulse", "look"]

#: Times at which a function is looked at: a share of the evaluations of the run, within bounds.
SHARE, FEWEST, MOST = 0.02, 2000, 20000

#: For how long at most, all of them together [s]; whoever takes longer is told. What a verdict says is else
#: no matter of the processor's pace.
PATIENCE = 5.0

#: At most so many, the farthest, of a function.
LISTED = 8

#: Far: more than so many times the median, and than this share of the range.
FAR, NOTICEABLE = 20.0, 1e-3

#: Spreads times evenly, and in step with no period.
GOLDEN = 0.6180339887498949


class Pulse(NamedTuple):
    """When a function does something that its neighbors do not tell."""

    t: float  #: [s]
    what: str  #: the function


class Looks(NamedTuple):
    """What was found, by time, and what takes so long that it was not looked at everywhere."""

    pulses: list[Pulse]
    cut_short: list[str]


def look(model: Model, t_start: float, t_end: float, evaluations: float) -> Looks:
    """At all functions of time that are the user's own, in a run of about so many evaluations."""
    looked_at = [(what, it) for what, it in model.signals if _own(it)]
    found = Looks([], [])
    if not looked_at or not t_end > t_start:
        return found
    count = int(min(max(SHARE * evaluations, FEWEST), MOST))
    places = np.sort((GOLDEN * np.arange(1, count + 1)) % 1.0)
    times = t_start + (t_end - t_start) * places
    for what, it in looked_at:
        far, whole = _far(it, times, PATIENCE / len(looked_at))
        found.pulses.extend(Pulse(t, what) for t in far)
        if not whole:
            found.cut_short.append(what)
    found.pulses.sort()
    return found


def _own(function: TimeFunction) -> bool:
    """A Python function, alone or in a sum, that cannot remember anything."""
    if isinstance(function, Sum):
        return any(_own(term) for term in function.terms) and all(_harmless(term) for term in function.terms)
    if isinstance(function, Broken):
        return _own(function.function)
    return isinstance(function, Expression) or (isinstance(function, Callback) and _harmless(function))


def _harmless(function: TimeFunction) -> bool:
    if isinstance(function, Sum):
        return all(map(_harmless, function.terms))
    if isinstance(function, Broken):
        return _harmless(function.function)
    return not isinstance(function, Callback) or callbacks.is_stateless(function.value)


def _far(function: TimeFunction, times: Floats, seconds: float) -> tuple[list[float], bool]:
    """Where it is far from the straight line between its neighbors, those first where it is farthest; and
    whether it was looked at everywhere."""
    compiled = function.compiled()  # once: a formula is read each time
    value: Callable[[float], float] = lambda t: compiled.evaluate(t)[0]  # noqa: E731
    if isinstance(function, Callback):
        value = function.value
    values, ends = [], time.thread_time() + seconds
    order = np.argsort((GOLDEN * np.arange(len(times))) % 1.0)  # as far as the time goes, all over the run
    try:
        for place in order:
            values.append(float(reals(value(float(times[place])))))
            if len(values) % 16 == 0 and time.thread_time() > ends:
                break
    except Exception:  # the run will say so
        return [], True
    seen = np.sort(order[: len(values)])
    by_place = np.array(values)[np.argsort(order[: len(values)])]
    return _outliers(times[seen], by_place), len(values) == len(times)


def _outliers(t: Floats, f: Floats) -> list[float]:
    if len(t) < 3 or not np.isfinite(f).all():
        return []
    share = (t[1:-1] - t[:-2]) / (t[2:] - t[:-2])
    apart = np.abs(f[1:-1] - (1 - share) * f[:-2] - share * f[2:])
    far = np.flatnonzero(apart > max(FAR * float(np.median(apart)), NOTICEABLE * float(np.ptp(f))))
    farthest = far[np.argsort(-apart[far], kind="stable")][:LISTED]
    return [float(t[1 + place]) for place in farthest]
