"""Runs that leave no memory in functions of the user's: each begins with what there was before the first.

An event that samples a controller changes what a law reads, in a list, an array, an attribute, a variable of
the functions around them or a global one. Of many runs in one process each would go on with what the last one
left.
"""

from __future__ import annotations

import collections
import dis
import random
import threading
import types
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any

import numpy as np

from linkwork.errors import warn
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.running import callbacks
from linkwork.running.events import functions_of

__all__ = ["Memory", "called", "leaving_no_memory", "memory_of", "warn_of_lasting"]

GiveBack = Callable[[], object]

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
        self._places = list(_places(functions.values()))

    @property
    def hidden(self) -> list[str]:
        """The functions that reach what cannot be looked into."""
        return [name for name, it in self._before.items() if it == callbacks.UNKNOWN]

    @property
    def is_empty(self) -> bool:
        return not self._places and not self.hidden

    def is_changed(self, *, logs: bool) -> bool:
        """Whether functions reach something else now, as far as it can be looked into. But for `logs` where
        they only write it: that changes no motion, and is there for whoever looks at it in the end."""
        changed = callbacks.changed(self._before, self._functions)
        known = [self._functions[name] for name in changed if name not in self.hidden]
        return any(logs or not callbacks.only_logs(it) for it in known)

    def give_back(self, *, logs: bool) -> list[str]:
        """Makes it what it was, if it is changed; the functions of which that is not known."""
        if not self.is_changed(logs=logs):
            return self.hidden
        for give_back in self._places:
            give_back()
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


def _places(functions: Any) -> Iterator[GiveBack]:
    seen, todo = set[int](), list(functions)
    while todo:
        it = todo.pop()
        if id(it) in seen or isinstance(it, _CONSTANT) or callbacks.opaque(it):
            continue
        seen.add(id(it))
        yield from _kept(it)
        todo += _inside(it)


_CONSTANT = (type(None), bool, int, float, complex, str, bytes, np.generic)


def _inside(it: Any) -> list[Any]:
    """What it reaches."""
    if isinstance(it, np.ndarray):
        return list(it.flat) if it.dtype.hasobject else []
    found = list(callbacks.inside(it) or ())
    if isinstance(it, dict):
        found += it.values()
    elif isinstance(it, list | tuple | set | frozenset | collections.deque):
        found += it
    return [*found, *_attributes(it).values()]


def _attributes(it: Any) -> dict[str, Any]:
    """In its dictionary, and in slots."""
    slots = [name for kind in type(it).__mro__ for name in _as_names(vars(kind).get("__slots__", ()))]
    found = {name: getattr(it, name) for name in slots if isinstance(getattr(type(it), name, None), _SLOT)
             and hasattr(it, name)}  # fmt: skip
    return {**found, **getattr(it, "__dict__", {})}


_SLOT = types.MemberDescriptorType


def _as_names(slots: Any) -> tuple[str, ...]:
    return (slots,) if isinstance(slots, str) else tuple(slots)


def _kept(it: Any) -> Iterator[GiveBack]:
    """What makes it again what it is now, but for what it reaches."""
    if isinstance(it, types.FunctionType):
        yield from _variables(it)
    elif isinstance(it, list | bytearray):
        yield partial(_put, it, slice(None), it[:])
    elif isinstance(it, dict | set):
        yield partial(_refill, it, it.copy(), "update")
    elif isinstance(it, collections.deque):
        yield partial(_refill, it, it.copy(), "extend")
    elif isinstance(it, np.ndarray):
        if it.flags.writeable:
            yield partial(_put, it, ..., it.copy())
    elif isinstance(it, random.Random):
        yield partial(it.setstate, it.getstate())
    elif isinstance(it, np.random.Generator):
        yield partial(setattr, it.bit_generator, "state", it.bit_generator.state)
    elif isinstance(it, np.random.RandomState):
        yield partial(it.set_state, it.get_state())
    if attributes := _attributes(it):
        yield partial(_give_attributes, it, attributes)


def _put(it: Any, where: Any, before: Any) -> None:
    it[where] = before


def _refill(it: Any, before: Any, by: str) -> None:
    if not _same(it, before) or (isinstance(it, dict) and not _same(it.values(), before.values())):
        it.clear()
        getattr(it, by)(before)


def _same(values: Any, others: Any) -> bool:
    return len(values) == len(others) and all(a is b for a, b in zip(values, others, strict=True))


def _give_attributes(it: Any, before: Mapping[str, Any]) -> None:
    now = _attributes(it)
    for name in now.keys() - before.keys():
        object.__delattr__(it, name)
    for name, value in before.items():
        if name not in now or now[name] is not value:
            object.__setattr__(it, name, value)


def _variables(function: types.FunctionType) -> Iterator[GiveBack]:
    """Those of others that it assigns to, and attributes that it assigns to of what is global."""
    stored = set(_stored(function.__code__))
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        if name in stored:
            yield partial(setattr, cell, "cell_contents", cell.cell_contents)
    for name in set(callbacks.names(function.__code__)) & function.__globals__.keys():
        it = function.__globals__[name]
        if name in stored:
            yield partial(_put, function.__globals__, name, it)
        if isinstance(it, types.ModuleType | type | types.FunctionType):
            for attribute in stored & vars(it).keys():
                yield partial(setattr, it, attribute, vars(it)[attribute])


def _stored(code: types.CodeType) -> Iterator[str]:
    """Names of others' variables, and of attributes, that it assigns to; functions inside, too."""
    yield from (it.argval for it in dis.get_instructions(code) if it.opname in _STORES)
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _stored(constant)


_STORES = ("STORE_DEREF", "STORE_GLOBAL", "STORE_ATTR")
