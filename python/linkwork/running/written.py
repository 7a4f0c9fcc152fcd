"""What the functions of a model have written by themselves in a run, apart from what its events have."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from linkwork.functions.calls import Calls
from linkwork.running.changes import Changes
from linkwork.running.kept import Kept, Parts
from linkwork.running.places import ALL

__all__ = ["Written"]

#: Entries and elements that are looked at as events come; after them nobody knows what is written between.
MOST = 10_000_000


class Written:
    """Made before anything calls the functions.

    began    what they reach, as it was then
    changes  of what they and functions of events read, by events
    """

    def __init__(self, functions: Iterable[tuple[str, Calls]], events: Iterable[Any] | None = None) -> None:
        """Calls from now on are those of the run.

        events  functions of events, which read too; None: no event changes anything
        """
        functions = list(functions)
        for _, calls in functions:
            calls.forget()
        its_own = [calls.function for _, calls in functions]
        self.began = self._since = self._left_by_others = Kept(its_own)
        self.changes = Changes([] if events is None else [*its_own, *events])
        self._parts: Parts = set()
        self._by_others: Parts = set()
        self._left = MOST
        self._follows = bool(self.began.size)

    @contextmanager
    def by_others(self, t: float) -> Iterator[None]:
        """While an event changes what they read, at t [s]."""
        self._parts |= self._news()
        try:
            with self.changes.at(t):
                yield
        finally:
            self._by_others |= self._news()
            self._left_by_others = self._since

    @property
    def changed(self) -> bool:
        """Whether there is something else now, whoever has written it."""
        return bool(self.began.changed())

    def parts(self, others: Kept) -> Parts:
        """What they have written so far, but for where others write, of whom it is not known when."""
        self._parts |= self._news()
        return {it for it in self._parts if not others.reaches(it[0])}

    @contextmanager
    def undone(self, parts: Parts) -> Iterator[Callable[[], None]]:
        """A context in which they have not written these; what it gives undoes that once more.

        What events have written, too, is then as the last of them left it: a value that it has dropped, and a
        function computes anew, belongs to what the event has changed beside it. All else is as the run began.
        """
        of_both = {it for it in parts if it in self._by_others or (it[0], ALL) in self._by_others}
        now = self.began.again()

        def undo() -> None:
            self.began.put_back(parts - of_both)
            self._left_by_others.put_back(of_both)

        try:
            undo()
            yield undo
        finally:
            now.put_back()

    def _news(self) -> Parts:
        """What has changed since the last look."""
        if not self._follows:
            return set()
        found = self._since.changed()
        if found:
            self._since = self._since.again()
        self._left -= self._since.size
        self._follows = self._left > 0
        return found
