"""What the functions of a model have written by themselves in a run, apart from what its events have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from linkwork.running.changes import Changes
from linkwork.running.kept import Kept, Parts

__all__ = ["Written"]

#: Entries and elements that are looked at as events come; after them nobody knows what is written between.
MOST = 10_000_000


class Written:
    """Made before anything calls the functions.

    began    what they reach, as it was then
    changes  of what they and functions of events read, by events
    """

    def __init__(self, functions: Iterable[Any], events: Iterable[Any] | None = None) -> None:
        """`events`: functions of events that read, too; None: there are none that change something."""
        functions = list(functions)
        self.began = self._since = Kept(functions)
        self.changes = Changes([] if events is None else [*functions, *events])
        self._parts: Parts = set()
        self._left = MOST
        self._follows = bool(self.began.size)

    @contextmanager
    def by_others(self, t: float) -> Iterator[None]:
        """While an event changes what they read, at t [s]."""
        self._note()
        try:
            with self.changes.at(t):
                yield
        finally:
            if self._follows:
                self._since = self._since.again()

    @property
    def changed(self) -> bool:
        """Whether there is something else now, whoever has written it."""
        return bool(self.began.changed())

    def parts(self, others: Kept) -> Parts:
        """What they have written so far, but for where others write, of whom it is not known when."""
        self._note()
        return {it for it in self._parts if not others.reaches(it[0])}

    def _note(self) -> None:
        if self._follows:
            self._parts |= self._since.changed()
            self._left -= self._since.size
            self._follows = self._left > 0
