"""A second, finer run beside the first: what both say differs by the error of the first.

With a fixed step h and a method of order p the second has h / 2, and the error of whatever was recorded is
(x_h - x_h/2) 2^p / (2^p - 1), Richardson (1911); with tolerances it has a tenth of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from linkwork.accuracy.measures import Differences, Sampled, Scales, longest_arm
from linkwork.arrays import Floats

if TYPE_CHECKING:
    from linkwork.results.result import Result

__all__ = ["Finer", "band", "difference", "state_error"]

#: Frames on either side whose errors count, too: where an error passes through zero its estimate does so a
#: little earlier or later. At least one, and this share of all.
NEIGHBORS = 0.01

#: Of the largest value: rounding, which both runs may share.
ROUNDING = 1e-15


class Finer(NamedTuple):
    """The second run, with frames at the times of the first, and the factor of the difference."""

    result: Result
    factor: float


def difference(first: Any, second: Any, of: Callable[[Floats, Floats], Floats]) -> Any:
    """`of` two arrays; of records of arrays, such as a Reaction, a record of the same kind."""
    if isinstance(first, tuple):
        return type(first)(*(difference(a, b, of) for a, b in zip(first, second, strict=True)))
    if is_dataclass(first):
        pairs = {it.name: (getattr(first, it.name), getattr(second, it.name)) for it in fields(first)}
        kind: Any = type(first)
        return kind(**{name: difference(*pair, of) for name, pair in pairs.items()})
    return of(first, second) if isinstance(first, np.ndarray) else first


def band(factor: float) -> Callable[[Floats, Floats], Floats]:
    """Error of the first of two arrays over time (k, ...): at each time the largest of its neighbors."""

    def of(first: Floats, second: Floats) -> Floats:
        known = min(len(first), len(second))
        error = np.full(first.shape, np.nan)
        apart = factor * np.abs(first[:known] - second[:known])
        largest, reach = apart.copy(), max(1, round(NEIGHBORS * known))
        for shift in range(1, min(reach, known - 1) + 1):
            np.maximum(largest[shift:], apart[:-shift], out=largest[shift:])
            np.maximum(largest[:-shift], apart[shift:], out=largest[:-shift])
        error[:known] = largest + ROUNDING * np.abs(first[:known]).max(initial=0.0)
        return error

    return of


def state_error(first: Result, finer: Finer) -> float:
    """Largest error of poses and velocities, relative as those of linkwork.accuracy.measures."""
    exact = Sampled.of(finer.result)
    differences = Differences.between(Sampled.of(first), exact)
    mass, rtol = float(first.header.mass.sum()), first.manifest["options"].get("rtol")
    state = differences.state(Scales.of(exact, longest_arm(finer.result), mass, rtol))
    return float(finer.factor * state.max(initial=0.0))
