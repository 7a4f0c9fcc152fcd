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
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.running import callbacks
from linkwork.running.events import functions_of
from linkwork.running.kept import Kept

__all__ = ["Memory", "called", "leaving_no_memory", "memory_of", "warn_of_lasting"]

#: Threads share what functions reach: of those that could change something one runs at a time.
_ONE_AT_A_TIME = threading.RLock()


def called(model: Model, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """The functions of the user's that a run with these arguments of `simulate` calls, by name."""
    method = arguments.get("integrator")
    own = {"integrator": method} if callable(method) and not isinstance(method, Integrator) else {}
    return {**callbacks.of_model(model), **functions_of(arguments.get("events", ())), **own}


class Memory:
    """All that functions reach and could change, as it is now."""

    def __init__(self, functions: Mapping[str, Any]) -> None:
        self._functions = functions
        self._before = callbacks.contents(functions)
        self._kept = Kept(functions.values())

    @property
    def hidden(self) -> list[str]:
        """The functions that reach what cannot be looked into."""
        return [name for name, it in self._before.items() if it == callbacks.UNKNOWN]

    @property
    def is_empty(self) -> bool:
        return not self._kept.writable and not self.hidden

    def is_changed(self, *, logs: bool) -> bool:
        """Whether functions reach something else now, as far as it can be looked into. But for `logs` where
        they only write it: that changes no motion, and is there for whoever looks at it in the end."""
        changed = callbacks.changed(self._before, self._functions)
        known = [self._functions[name] for name in changed if name not in self.hidden]
        return any(logs or not callbacks.only_logs(it) for it in known)

    def put_back(self) -> None:
        """Makes it what it was, logs too."""
        self._kept.put_back()

    def give_back(self, *, logs: bool) -> list[str]:
        """Makes it what it was, if it is changed; the functions of which that is not known."""
        if not self.is_changed(logs=logs):
            return self.hidden
        self._kept.put_back()
        return callbacks.changed(self._before, self._functions)


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
        listed = ", ".join(f"'{name}'" for name in names[:3])
        warn(
            f"{listed}: what it remembers cannot be given back after a run, so that runs may depend on those "
            "before them: keep it in lists, dicts, arrays or attributes"
        )
