"""Containers and variables with what was in them at some time: what has changed, and how it is put back."""

from __future__ import annotations

import array
import contextvars
import ctypes
import functools
import gc
import operator
import pickle
import random
import threading
import types
from collections import OrderedDict, deque
from collections.abc import Callable, Collection, Hashable, Iterable
from typing import Any, Protocol

import numpy as np

__all__ = ["ALL", "LARGE", "Named", "Names", "Place", "in_cache", "is_from_c", "is_same", "place_of"]

#: A part of a place: all of it. Others are keys and numbers of elements.
ALL = ("all of it",)

#: Arrays of more bytes are not copied. Elements of one that count one by one.
LARGE, FEW = 2**27, 1000

_MISSING = object()

#: Numbers, arrays and structures of ctypes.
_FROM_C: Any = ctypes._SimpleCData.__mro__[1]


class Place(Protocol):
    """Something that can be written to, as it was."""

    _then: Any  # what was in it

    @property
    def size(self) -> int:
        """Entries and elements."""

    def again(self) -> Place:
        """The same, as it is now."""

    def changed(self) -> set[Hashable]:
        """Parts in which something else is now."""

    def put_back(self, parts: set[Hashable] | None) -> None:
        """Makes them what they were; None: all."""


class Named:
    """A variable, an attribute or an entry: what `get` gives where there is none, `put` gets then."""

    def __init__(self, get: Callable[[], Any], put: Callable[[Any], object]) -> None:
        self._get, self._put, self._then = get, put, get()
        self.size = 1

    def again(self) -> Named:
        return Named(self._get, self._put)

    def changed(self) -> set[Hashable]:
        return set() if self._get() is self._then else {ALL}

    def put_back(self, parts: set[Hashable] | None) -> None:
        if self._get() is not self._then:
            self._put(self._then)


class Names:
    """Which attributes a class has, but for those that Python adds: their values are places of their own."""

    def __init__(self, it: type) -> None:
        self._it, self._then = it, frozenset(name for name in vars(it) if not name.startswith("__"))
        self.size = 1

    def again(self) -> Names:
        return Names(self._it)

    def changed(self) -> set[Hashable]:
        return {ALL} if Names(self._it)._then - self._then else set()

    def put_back(self, parts: set[Hashable] | None) -> None:
        stay = []
        for name in Names(self._it)._then - self._then:
            try:
                delattr(self._it, name)
            except (AttributeError, TypeError):
                stay.append(name)
        if stay:
            raise TypeError(f"class {self._it.__qualname__} does not give up {', '.join(stay)}")


class _Entries:
    """Of a dictionary, in their order."""

    def __init__(self, it: dict[Any, Any]) -> None:
        self._it, self._then = it, dict.copy(it)
        self.size = 1 + len(self._then)

    def again(self) -> _Entries:
        return _Entries(self._it)

    def changed(self) -> set[Hashable]:
        if self._is_same():
            return set()
        now, then = dict.copy(self._it), self._then
        keys = now.keys() | then.keys()
        return {it for it in keys if now.get(it, _MISSING) is not then.get(it, _MISSING)} or {ALL}

    def put_back(self, parts: set[Hashable] | None) -> None:
        it, then = self._it, self._then
        kind: Any = OrderedDict if isinstance(it, OrderedDict) else dict
        if parts is None or ALL in parts:
            if not self._is_same():
                kind.clear(it)
                kind.update(it, then)
            return
        for key in parts:
            if key in then:
                kind.__setitem__(it, key, then[key])
            elif dict.__contains__(it, key):
                kind.__delitem__(it, key)

    def _is_same(self) -> bool:
        return is_same(dict.keys(self._it), self._then.keys()) and is_same(
            dict.values(self._it), self._then.values()
        )


class _Row:
    """A list, a deque."""

    def __init__(self, it: Any) -> None:
        self._it, self._then = it, list(list.__iter__(it) if isinstance(it, list) else it)
        self.size = 1 + len(self._then)

    def again(self) -> _Row:
        return _Row(self._it)

    def changed(self) -> set[Hashable]:
        now, then = _Row(self._it)._then, self._then
        if len(now) != len(then):
            return {ALL}
        return {k for k, same in enumerate(map(operator.is_, now, then)) if not same}

    def put_back(self, parts: set[Hashable] | None) -> None:
        it, then = self._it, self._then
        kind: Any = list if isinstance(it, list) else deque
        if parts is None or ALL in parts or len(it) != len(then):
            if not is_same(_Row(it)._then, then):
                kind.clear(it)
                kind.extend(it, then)
            return
        for place in parts:
            kind.__setitem__(it, place, then[place])  # type: ignore[call-overload]


class _Array:
    """Of NumPy."""

    def __init__(self, it: Any) -> None:
        self._it = it
        self._then = np.array(it, copy=True, subok=False) if it.nbytes <= LARGE else None
        self.size = 1 + it.size // 16

    def again(self) -> _Array:
        return _Array(self._it)

    def changed(self) -> set[Hashable]:
        it, then = np.asarray(self._it), self._then
        if then is None:
            return set()
        if it.shape != then.shape:
            return {ALL}
        if it.dtype.hasobject or it.dtype.names:
            return set() if pickled(it) == pickled(then) else {ALL}
        apart = np.flatnonzero((it != then) & ~((it != it) & (then != then)))
        return {ALL} if len(apart) > FEW else set(apart.tolist())

    def put_back(self, parts: set[Hashable] | None) -> None:
        it, then = np.asarray(self._it), self._then
        if then is None:
            return
        if it.shape != then.shape:  # as whoever calls does it, who makes it larger in place
            self._it.resize(then.shape, refcheck=False)
            it = np.asarray(self._it)
        if not (self.changed() if parts is None else parts):
            return
        locked = not it.flags.writeable
        if locked:
            it.flags.writeable = True
        if parts is None or ALL in parts:
            np.copyto(it, then)
        else:
            chosen: Any = list(parts)
            it.flat[chosen] = then.flat[chosen]
        if locked:
            it.flags.writeable = False


class _Whole:
    """What is put back as a whole."""

    def __init__(self, get: Callable[[], Any], put: Callable[[Any], object]) -> None:
        self._get, self._put, self._then = get, put, get()
        self.size = 1

    def again(self) -> _Whole:
        return _Whole(self._get, self._put)

    def changed(self) -> set[Hashable]:
        now, then = self._get(), self._then
        if isinstance(then, set):
            return set() if now == then else {ALL}
        return set() if pickled(now) == pickled(then) else {ALL}

    def put_back(self, parts: set[Hashable] | None) -> None:
        if self.changed():
            self._put(self._then)


def pickled(value: Any) -> bytes:
    return pickle.dumps(value, protocol=5)


def place_of(it: Any) -> tuple[Place | None, Iterable[Any]] | None:
    """What can be written to there, and what is in it; None: it is no container that is known."""
    if isinstance(it, dict):
        return _Entries(it), list(dict.values(it))
    if isinstance(it, list | deque):
        return (row := _Row(it)), row._then
    if isinstance(it, np.ndarray):
        inside: list[Any] = it.ravel().tolist() if it.dtype.hasobject else []
        return _Array(it), [*inside, it.base]
    if isinstance(it, memoryview):
        return None, [it.obj]
    if isinstance(it, types.MappingProxyType):
        return None, list(it.values())
    if isinstance(it, np.random.Generator):
        return None, [it.bit_generator]
    found = _whole(it)
    if found is None:
        return None
    return found, list(it) if isinstance(it, set) else _kept_by_c(it) if is_from_c(it) else []


def _whole(it: Any) -> _Whole | None:
    if isinstance(it, set):
        return _Whole(lambda: set(it), functools.partial(_refill, it))
    if isinstance(it, bytearray | array.array):
        return _Whole(lambda: it[:], lambda then: it.__setitem__(slice(None), then))
    if isinstance(it, random.SystemRandom):
        return _Whole(lambda: None, lambda then: None)
    if isinstance(it, random.Random):
        return _Whole(it.getstate, it.setstate)
    if isinstance(it, np.random.RandomState):
        return _Whole(it.get_state, it.set_state)
    if isinstance(it, np.random.BitGenerator):
        return _Whole(lambda: it.state, lambda then: setattr(it, "state", then))
    if isinstance(it, threading.Event):
        return _Whole(it.is_set, lambda then: it.set() if then else it.clear())
    if isinstance(it, np.void):
        return _Whole(it.copy, functools.partial(_copy_fields, it))
    if isinstance(it, contextvars.ContextVar):
        return _Whole(lambda: it.get(_NONE), functools.partial(_set_context, it))
    if is_from_c(it):
        size = ctypes.sizeof(it)
        return _Whole(
            lambda: ctypes.string_at(ctypes.addressof(it), size),
            lambda then: ctypes.memmove(ctypes.addressof(it), then, size),
        )
    return None


def _set_context(it: contextvars.ContextVar[Any], then: Any) -> None:
    """ValueError: it had no value, which only the token that set it could give back."""
    if then is _NONE:
        raise ValueError(f"context variable {it.name} had no value")
    it.set(then)


def _refill(it: set[Any], content: set[Any]) -> None:
    it.clear()
    it.update(content)


def _copy_fields(it: Any, then: Any) -> None:
    for name in it.dtype.names or ():
        it[name] = then[name]


def _kept_by_c(it: Any) -> list[Any]:
    """What a pointer or a structure keeps alive, as what it points to; nobody knows of addresses."""
    objects = it._objects
    held = list(objects.values()) if isinstance(objects, dict) else [objects]
    return [*held, *vars(it).values()] if hasattr(it, "__dict__") else held


def in_cache(it: Any) -> list[Any]:
    """Arguments and results that a cache of functools holds."""
    found = []
    for inner in gc.get_referents(it):
        if type(inner) is dict and inner is not vars(it):
            found += [*inner.keys(), *inner.values()]
    links = [part for part in found if type(part).__name__ == "_lru_list_elem"]
    return [*found, *(part for link in links for part in gc.get_referents(link))] if links else found


def is_from_c(it: Any) -> bool:
    """A number, an array or a structure of ctypes."""
    return isinstance(it, _FROM_C) and not isinstance(it, ctypes._CFuncPtr)  # type: ignore[attr-defined]


#: Of a context variable that has no value.
_NONE = ("nothing",)


def is_same(now: Collection[Any], then: Collection[Any]) -> bool:
    """The very same objects, in this order."""
    return len(now) == len(then) and all(map(operator.is_, now, then))
