"""The record of a mechanism: what the command line and the comparisons know about it."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork import memory
from linkwork.arguments import is_number
from linkwork.arrays import Number
from linkwork.errors import ModelError
from linkwork.mechanisms.recommended import beside
from linkwork.modeling.model import Model

__all__ = ["Mechanism", "Parameter", "Size", "at_least"]


#: Memory that a body with its joint takes until it moves [bytes], and the most of anything.
BYTES, MOST = 3000, 10**12


@dataclass(frozen=True)
class Parameter:
    """An argument of a mechanism's function; its default says its type."""

    name: str
    default: Any
    description: str


@dataclass(frozen=True)
class Size:
    """The parameter that makes a mechanism large, and how many bodies a value of it gives."""

    parameter: str
    bodies: Callable[[int], int] = lambda value: value

    def value_for(self, bodies: int) -> int:
        """The largest value that gives no more than so many bodies, found by bisection; at least 1."""
        low, high = 1, max(bodies, 1) + 1
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.bodies(middle) <= bodies else (low, middle)
        return low


@dataclass(frozen=True, init=False)
class Mechanism:
    """A function that builds a model, and recommended arguments for `simulate`."""

    function: Callable[..., Model]
    size: Size | None  #: None: the mechanism has one size only
    settings: Mapping[str, Any]

    def __init__(self, function: Callable[..., Model], size: Size | None = None, **settings: Any) -> None:
        object.__setattr__(self, "function", function)
        object.__setattr__(self, "size", size)
        object.__setattr__(self, "settings", settings)

    def settings_beside(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """The settings that have a meaning beside those that are given."""
        return beside(self.settings, given)

    @property
    def name(self) -> str:
        return self.function.__name__

    @property
    def description(self) -> str:
        """The first line of the function's documentation."""
        return inspect.getdoc(self.function).split("\n")[0]  # type: ignore[union-attr]

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """From the function's signature; a line `name  what it is` of its documentation describes each."""
        text = inspect.getdoc(self.function) or ""
        described = dict(re.findall(r"^(\w+)  +(\S.*)$", text, re.MULTILINE))
        arguments = inspect.signature(self.function).parameters.values()
        return tuple(Parameter(p.name, p.default, described.get(p.name, "")) for p in arguments)


def between(least: float, value: Number, most: float, what: str) -> None:
    """ModelError: no number, or one out of these bounds."""
    if not is_number(value):
        raise ModelError(f"{what} {value!r:.80} is not a finite number", code="not_a_number")
    if not least <= value <= most:
        wanted = f"from {least:g} to {most:g}" if math.isfinite(most) else f"at least {least:g}"
        raise ModelError(f"{what} {value:g} is out of its bounds: {wanted}", code="out_of_bounds")


def at_least(least: int, value: int, what: str) -> None:
    """ModelError: a number of things that is too small, or none."""
    if not isinstance(value, int | np.integer) or isinstance(value, bool):
        raise ModelError(f"{what} {value!r:.80} is not a whole number", code="count")
    if value < least:
        raise ModelError(f"{what} {value} is too small: at least {least}", code="count")
    if value > MOST:
        raise ModelError(f"{what} is more than any memory holds: at most {MOST:.0e}", code="memory")
    needed, there = BYTES * int(value), memory.available()
    if needed > there:
        raise ModelError(
            f"{what} {value} needs about {memory.in_words(needed)}, and there are {memory.in_words(there)}: "
            "give a smaller number, or run it on a machine with more memory",
            code="memory",
        )
