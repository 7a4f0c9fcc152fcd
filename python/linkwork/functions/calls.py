"""Some calls of a function of the user's own, with what it returned: they tell later whether it remembers."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from linkwork.arguments import reals
from linkwork.arrays import Floats

__all__ = ["Call", "Calls"]

#: Calls in a row, as those of one step; with so many rows each second one is left out; bytes of arguments.
ROW, ROWS, BYTES = 3, 64, 2**24


#: Of all calls that are kept, in the order in which they came.
_COUNT = itertools.count()


class Call(NamedTuple):
    """What a function was called with, and what it returned; calls of several functions by their numbers."""

    given: tuple[Any, ...]
    returned: Floats
    number: int = 0


class Calls:
    """A function that is called by `ask`, and calls of it: rows of them, evenly over all since `forget`."""

    def __init__(
        self, function: Callable[..., Any], given: Callable[..., tuple[Any, ...]] | None = None
    ) -> None:
        """`given`: makes what the function is given of what is asked with; None: it is the same."""
        self.function, self._given = function, given
        self.forget()

    def forget(self) -> None:
        self.differs: bool | None = None  #: whether they return something else later; None: nobody has looked
        self.remembers = False  #: whether that may be by the calls before
        self.by_itself = False  #: whether the calls before make that difference
        self.hidden = False  #: whether they do so although all is as it was that can be put back
        self._rows: list[list[Call]] = []
        self._left = 0  # calls until the next that is kept
        self._apart = 0  # calls between rows

    def ask(self, *given: Any) -> Any:
        if self._left:
            self._left -= 1
            return self._call(given)
        kept = copied(given)  # the function may write into what it gets
        returned = self._call(given)
        self._keep(kept, returned)
        return returned

    def _call(self, given: tuple[Any, ...]) -> Any:
        return self.function(*(given if self._given is None else self._given(*given)))

    def again(self, call: Call) -> Floats | None:
        """What it returns now for the same arguments; None: it fails."""
        try:
            return np.array(reals(self._call(copied(call.given))))
        except Exception:  # of the user's
            return None

    @property
    def first(self) -> list[Call]:
        """All until there are enough in a row."""
        return self._rows[0] if self._rows else []

    def some(self, most: int) -> list[Call]:
        """About so many of those that are kept, in rows, evenly over all; at least one row."""
        every = max(1, ROW * len(self._rows) // max(most, ROW))
        return [call for row in self._rows[every // 2 :: every] for call in row]

    def _keep(self, given: tuple[Any, ...], returned: Any) -> None:
        try:
            call = Call(given, np.array(reals(returned)), next(_COUNT))
        except Exception:  # of its objects; the caller refuses them, too
            return
        if not self._rows or len(self._rows[-1]) >= ROW:
            self._make_room(sum(np.asarray(it).nbytes for it in given))
            self._rows.append([])
        self._rows[-1].append(call)
        self._left = self._apart if len(self._rows[-1]) >= ROW else 0

    def _make_room(self, size: int) -> None:
        if len(self._rows) >= max(2, min(ROWS, BYTES // (ROW * size))):
            self._rows = self._rows[::2]
            self._apart = 2 * self._apart + ROW

    def __reduce__(self) -> tuple[type[Calls], tuple[Callable[..., Any]]]:
        """Without the calls."""
        return Calls, (self.function,)

    def __fingerprint__(self) -> str:
        """Nothing of what the function is."""
        return ""


def copied(given: tuple[Any, ...]) -> tuple[Any, ...]:
    return tuple(it.copy() if isinstance(it, np.ndarray) else it for it in given)
