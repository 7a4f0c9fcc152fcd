"""When events changed what functions of a run read: in which times that was not what it is at its end."""

from __future__ import annotations

import hashlib
import math
import pickle
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from linkwork.running.kept import Kept, Part

__all__ = ["Changes"]

#: Entries and elements that are looked at; after them what was read before counts as something else.
MOST = 10_000_000

#: Times that are told apart; more are told as if it had been something else between the first of them, too.
TIMES = 1000


class Changes:
    """Made before anything calls the functions."""

    def __init__(self, functions: Iterable[Any]) -> None:
        self._kept = Kept(functions)
        self._past: dict[Part, list[tuple[float, bytes]]] = {}  # from when on [s], digest
        self._known_from = -math.inf
        self._left = MOST

    @contextmanager
    def at(self, t: float) -> Iterator[None]:
        """While an event changes something at t [s]."""
        self._left -= self._kept.size
        before = self._kept.again() if self._left > 0 else None
        try:
            yield
        finally:
            if before is None:
                self._known_from = t
            else:
                self._note(t, before)

    def _note(self, t: float, before: Kept) -> None:
        now = self._kept.again()
        for part in before.changed_contents():
            past = self._past.setdefault(part, [(-math.inf, _digest(before.content(part)))])
            past.append((t, _digest(now.content(part))))

    def read_by(self, function: Any) -> bool:
        """Whether it reaches something that was changed."""
        kept = Kept([function])
        return any(kept.reaches(place) for place, _ in self._past) or self._known_from > -math.inf

    @property
    def unlike_the_end(self) -> tuple[tuple[float, float], ...]:
        """From and until when [s] they read something else than at the end, in order."""
        known, now = self._known_from, self._kept.again()
        found = [] if known == -math.inf else [(-math.inf, known)]
        for part, past in self._past.items():
            end, until = _digest(now.content(part)), [*(t for t, _ in past[1:]), math.inf]
            same = [bool(end) and digest == end for _, digest in past]
            found += [(t, then) for (t, _), then, as_now in zip(past, until, same, strict=True) if not as_now]
        return tuple(_joined(sorted(found)))


def _joined(times: list[tuple[float, float]]) -> list[tuple[float, float]]:
    found: list[tuple[float, float]] = []
    for begin, end in times:
        if found and begin <= found[-1][1]:
            found[-1] = found[-1][0], max(found[-1][1], end)
        else:
            found.append((begin, end))
    if len(found) > TIMES:
        found[: 1 - TIMES] = [(found[0][0], found[-TIMES][1])]
    return found


def _digest(content: Any) -> bytes:
    """b"": of what cannot be compared, which is like nothing else."""
    try:
        return hashlib.blake2b(pickle.dumps(content), digest_size=8).digest()
    except Exception:  # whatever an object of the user's raises
        return b""
