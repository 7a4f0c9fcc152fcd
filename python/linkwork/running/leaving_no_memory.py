"""Runs that leave no memory in functions of the user's: each begins with what there was before the first.

An event that samples a controller changes what a law reads, in a list, an array, an attribute, a variable of
the functions around them or a global one. Of many runs in one process each would go on with what the last one
left.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from linkwork.errors import warn
from linkwork.functions.calls import Calls
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.running import callbacks
from linkwork.running.events import functions_of
from linkwork.running.kept import Kept
from linkwork.running.returned import look_for_hidden

__all__ = ["Memory", "called", "function_of", "leaving_no_memory", "memory_of", "warn_of_lasting"]

#: Threads share what functions reach: of those that could change something one runs at a time.
_ONE_AT_A_TIME = threading.RLock()


def called(model: Model, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """What a run with these arguments of `simulate` calls of the user's, by name: `Calls` of its laws, else
    functions."""
    method = arguments.get("integrator")
    own = {"integrator": method} if callable(method) and not isinstance(method, Integrator) else {}
    laws: dict[str, Any] = {}
    for name, calls in model._calls:
        laws[name if name not in laws else f"{name} ({len(laws)})"] = calls
    return {**callbacks.of_model(model), **laws, **functions_of(arguments.get("events", ())), **own}


class Memory:
    """All that functions reach and could change, as it is now; calls from now on are looked at."""

    def __init__(self, functions: Mapping[str, Any]) -> None:
        self._calls = [(name, it) for name, it in functions.items() if isinstance(it, Calls)]
        for _, calls in self._calls:
            calls.forget()
        self._functions = {name: function_of(it) for name, it in functions.items()}
        self._before = callbacks.contents(self._functions)
        self._kept = Kept(self._functions.values())

    @property
    def hidden(self) -> list[str]:
        """The functions that reach what cannot be looked into."""
        unread = [name for name, it in self._before.items() if it == callbacks.UNKNOWN]
        return [name for name in unread if not Kept([self._functions[name]]).whole]

    @property
    def is_empty(self) -> bool:
        return not self._kept.writable and not self.hidden

    def is_changed(self, *, logs: bool) -> bool:
        """Whether functions reach something else now, as far as it can be looked into. But for `logs` where
        they only write it: that changes no motion, and is there for whoever looks at it in the end. Where
        calls return something else than in the run it is no log, whatever it looks like."""
        changed = [*self._changed(), *self._written()]
        known = [self._functions[name] for name in dict.fromkeys(changed)]
        counts = logs or any(calls.differs for _, calls in self._calls)
        return any(counts or not callbacks.only_logs(it, self._functions.values()) for it in known)

    def _written(self) -> list[str]:
        """Functions that reach places where something else is now."""
        keys = {key for key, _ in self._kept.changed()}
        if not keys:
            return []
        return [name for name, it in self._functions.items() if not keys.isdisjoint(Kept([it]).keys)]

    def _changed(self) -> list[str]:
        """By content, of functions of which that can be read."""
        read = {name: it for name, it in self._before.items() if it != callbacks.UNKNOWN}
        return callbacks.changed(read, {name: self._functions[name] for name in read})

    def makes_a_difference(self) -> bool:
        """Whether functions return something else than in calls before, also where all is given back."""
        if not any(calls.differs or calls.differs is None for _, calls in self._calls):
            return False
        with self._kept.as_then():
            look_for_hidden(self._calls)
        return any(calls.differs or calls.hidden for _, calls in self._calls)

    def put_back(self) -> list[str]:
        """Makes it what it was, logs too; the functions of which that could not be done."""
        self._kept.put_back()
        return [*self._changed(), *self._written()]

    def give_back(self, *, logs: bool) -> list[str]:
        """Makes it what it was, if it is changed; the functions of which that is not known."""
        hidden = [*self.hidden, *(name for name, calls in self._calls if calls.hidden)]
        if not self.is_changed(logs=logs):
            return hidden
        return [*self.put_back(), *hidden]


def function_of(it: Any) -> Any:
    """Of what `called` gives."""
    return it.function if isinstance(it, Calls) else it


@contextmanager
def memory_of(functions: Mapping[str, Any]) -> Iterator[Memory]:
    """Theirs: where there is any, other threads wait that would change it meanwhile."""
    with _ONE_AT_A_TIME:
        memory = Memory(functions)
        if not memory.is_empty:
            yield memory
            return
    yield memory


@contextmanager
def leaving_no_memory(functions: Mapping[str, Any], *, logs: bool) -> Iterator[None]:
    """A run, and all that looks at what it left there. LinkworkWarning: it cannot be given back."""
    with memory_of(functions) as memory:
        try:
            yield
        finally:
            warn_of_lasting(memory.give_back(logs=logs))


def warn_of_lasting(names: Sequence[str]) -> None:
    """LinkworkWarning: these functions may go on with what other runs left."""
    if names:
        listed = ", ".join(f"'{name}'" for name in dict.fromkeys(names[:3]))
        warn(
            f"{listed}: what it remembers cannot be given back after a run, so that runs may depend on those "
            "before them: keep it in lists, dicts, arrays or attributes"
        )
