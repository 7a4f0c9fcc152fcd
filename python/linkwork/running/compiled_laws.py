"""Compiled forces in a run, whose calls by the driver nobody sees: they are asked at frames instead."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence

import numpy as np

from linkwork.arrays import Floats
from linkwork.functions.calls import Calls
from linkwork.functions.compiled_law import CompiledLaw
from linkwork.running.kept import Kept

__all__ = ["CompiledLaws"]

#: Frames at which they are asked, of those between two looks; entries and elements that are copied for it.
FRAMES, MOST = 3, 10_000_000


class CompiledLaws:
    """Made before the run. Calls that are kept are by what they remembered at the last look, or do now."""

    def __init__(self, functions: Sequence[tuple[str, Calls]]) -> None:
        self._calls = [calls for _, calls in functions if isinstance(calls.function, CompiledLaw)]
        self._before = Kept(calls.function for calls in self._calls)
        self._left = MOST

    def look(self, frames: Mapping[str, Floats]) -> None:
        """At frames as they come."""
        count = len(frames["t"])
        if not self._calls or not count or self._left <= 0:
            return
        now = self._before.again()
        self._left -= FRAMES * now.size
        for frame in sorted({0, count // 2, count - 1}):
            t, q, v = float(frames["t"][frame]), *(np.array(frames[name][frame]) for name in ("q", "v"))
            for memory in (self._before, now):
                with memory.as_then():
                    self._ask(t, q.reshape(-1, 7), v.reshape(-1, 6))
        self._before = now

    def _ask(self, t: float, q: Floats, v: Floats) -> None:
        for calls in self._calls:
            with contextlib.suppress(Exception):  # of the user's, who has seen it in the run
                calls.ask(t, q, v)
