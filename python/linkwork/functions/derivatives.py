"""Whether functions that are given as derivatives are the derivatives of what comes before them.

Not by differences, which lose their digits where a function is small and look to times before the start, but
by integrals: f(b) - f(a) is the integral of f' over (a, b), which Gauss-Legendre quadrature finds to rounding
where f' is smooth, in the function's own size. Where it does not converge, the interval is cut.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np

from linkwork.arrays import Floats

__all__ = ["Disagreement", "disagreement", "later_starts"]

Function = Callable[[float], float]

#: Where intervals begin, and how long they are at most and at least [s].
STARTS, LONGEST, SHORTEST = (0.0, 0.173, 1.31, 4.7), 1.0, 1e-7

#: Of an interval, which is looked at, too: over whole periods everything adds up to nothing.
PART = 0.6180339887498949

#: Intervals of a run beyond the first seconds.
LATER = 12

#: By which a derivative may miss the change of the function, as a part of its own integral of |f'|.
AGREE = 1e-3

#: Of quadrature: the difference of two of them as a part of that integral.
CONVERGED = 1e-6

#: A wrong derivative is wrong all over an interval; a jump, or a pulse that no node saw, at one place of it,
#: which keeps the whole error when the worse half is taken again and again.
HALVINGS, CONCENTRATED = 8, 0.25

#: Of a function's values.
ROUNDOFF = 2e-14

#: Times at which a function is evaluated to see where it changes most, and how great it becomes.
SOME, MANY = 101, 1001

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class Disagreement(NamedTuple):
    """Between two times the function changes by `change`, and its derivative adds up to `integral`."""

    start: float
    end: float
    change: float
    integral: float


class _Interval(NamedTuple):
    change: float  # of the function
    integral: float  # of the derivative
    error: float  # of that
    size: float  # integral of its amount
    rounding: float  # of the function

    @property
    def miss(self) -> float:
        return abs(self.change - self.integral)

    @property
    def wrong(self) -> bool:
        return self.miss > AGREE * self.size + 10 * self.error + self.rounding


def later_starts(t_end: float) -> list[float]:
    """Where intervals of a run to t_end [s] begin, beyond those of its first seconds."""
    begins = [t_end * (k * PART % 1.0) for k in range(1, LATER + 1)]
    return [t for t in begins if STARTS[-1] + LONGEST < t < t_end - LONGEST]


def disagreement(f: Function, derivative: Function, starts: Iterable[float] = STARTS) -> Disagreement | None:
    """Where `derivative` is not that of f in intervals that begin there; None where they agree.

    Times at which one of them is not defined, or not smooth enough to tell, are passed over.
    """
    starts = list(starts)
    end = max(starts, default=0.0) + LONGEST
    for start in [*starts, _steepest(f, end)]:
        found = _from(f, derivative, start)
        if found and abs(found.change - found.integral) > ROUNDOFF * _greatest(f, end):
            return found
    return None


def _from(f: Function, derivative: Function, start: float) -> Disagreement | None:
    """Where they do not agree in the longest interval from `start` over which both are smooth."""
    length = LONGEST
    while length >= SHORTEST:
        whole = _interval(f, derivative, start, start + length)
        if whole is not None and whole.error <= CONVERGED * whole.size:
            for end in (start + length, start + PART * length):
                found = _interval(f, derivative, start, end)
                if found and found.wrong and _everywhere(f, derivative, start, end, found.miss):
                    return Disagreement(start, end, found.change, found.integral)
            break
        length /= 4
    return None


def _interval(f: Function, derivative: Function, a: float, b: float) -> _Interval | None:
    """None: something there is not defined."""
    middle = (a + b) / 2
    times = [_nodes(a, b), _nodes(a, middle), _nodes(middle, b)]
    try:
        ends = np.array([float(f(t)) for t in (a, b)])
        values = [np.array([float(derivative(float(t))) for t in each]) for each in times]
    except Exception:
        return None
    parts = [_WEIGHTS @ each * h / 2 for each, h in zip(values, (b - a, middle - a, b - middle), strict=True)]
    size = float(_WEIGHTS @ np.abs(values[1]) + _WEIGHTS @ np.abs(values[2])) * (b - a) / 4
    integral = float(parts[1] + parts[2])
    if not np.isfinite([*ends, size]).all():
        return None
    rounding = ROUNDOFF * float(np.abs(ends).max())
    return _Interval(float(ends[1] - ends[0]), integral, abs(float(parts[0]) - integral), size, rounding)


def _steepest(f: Function, end: float) -> float:
    """When before `end` f changes most [s]: a step may be over between two of the starts."""
    times = [float(t) for t in np.linspace(0.0, end, SOME)]
    values = [_value(f, t) for t in times]
    a, b, fa, fb = max(
        zip(times, times[1:], values, values[1:], strict=False), key=lambda it: abs(it[3] - it[2])
    )
    for _ in range(HALVINGS):
        middle = (a + b) / 2
        fm = _value(f, middle)
        a, b, fa, fb = (a, middle, fa, fm) if abs(fm - fa) > abs(fb - fm) else (middle, b, fm, fb)
    return a


def _greatest(f: Function, end: float) -> float:
    """Of |f| from 0 to `end`: what 1 - tanh² loses in rounding is a part of it, where it fades, too."""
    return max(abs(_value(f, float(t))) for t in np.linspace(0.0, end, MANY))


def _value(f: Function, t: float) -> float:
    """Of f at t; 0 where it is not defined."""
    with contextlib.suppress(Exception):
        value = float(f(t))
        return value if np.isfinite(value) else 0.0
    return 0.0


def _nodes(a: float, b: float) -> Floats:
    nodes: Floats = (a + b) / 2 + (b - a) / 2 * _NODES
    return nodes


def _everywhere(f: Function, derivative: Function, a: float, b: float, miss: float) -> bool:
    """Whether the error of an interval is spread over it."""
    for _ in range(HALVINGS):
        middle = (a + b) / 2
        halves = [(_interval(f, derivative, *ends), ends) for ends in ((a, middle), (middle, b))]
        known = [(half.miss, half.wrong, ends) for half, ends in halves if half is not None]
        if not known:
            return False
        left, wrong, (a, b) = max(known, key=lambda it: it[0])
        if not wrong or left < CONCENTRATED * miss:
            return wrong
        miss = max(miss, left)  # in the whole some of it may cancel
    return False
