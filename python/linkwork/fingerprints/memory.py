"""What calls change, as counters and what is remembered: it counts as it was when it was first looked at.

So two controllers that begin with other integrals are told apart, and one that has run is the one that began.
"""

from __future__ import annotations

import functools
import weakref
from collections.abc import Callable, Iterator, Mapping
from types import FunctionType, MethodType
from typing import Any

from linkwork.fingerprints import codes
from linkwork.fingerprints.origins import is_users_class
from linkwork.fingerprints.reading import attributes, cells, is_wrapper, read_by, wrapped

__all__ = ["Calls", "first_look"]

#: Methods that run before there is anything to remember.
_MAKING = ("__init__", "__post_init__", "__new__", "__setstate__", "__set_name__")

#: Texts by object and what looked; with the object, so that no other one has its place in memory.
_FIRST: dict[tuple[Any, ...], tuple[Callable[[], Any], str]] = {}


def first_look(value: Any, how: tuple[Any, ...], write: Callable[[], str]) -> str:
    """The text of what an object remembers as it was when this was asked for the first time."""
    key = (id(value), *how)
    if key in _FIRST and _FIRST[key][0]() is value:
        return _FIRST[key][1]
    text = write()
    try:
        held: Callable[[], Any] = weakref.ref(value, lambda _: _FIRST.pop(key, None))
    except TypeError:  # it has no place for that
        held = functools.partial(_same, value)
    _FIRST[key] = held, text
    return text


def _same(value: Any) -> Any:
    return value


class Calls:
    """What may happen when something is called: the methods that are used by name, and what these and the
    functions change."""

    def __init__(self, root: Any) -> None:
        self._seen: dict[int, Any] = {}
        self._names: set[str] = set()
        self._kinds: set[type] = set()
        self._methods: set[FunctionType] = set()
        self._by_functions: codes.Changes = frozenset()
        self._look(root)
        while new := [it for kind in self._kinds for it in self._used(kind) if it not in self._methods]:
            self._methods.update(new)
            for method in new:
                self._follow(method)

    def changes(self, kind: type) -> codes.Changes:
        """Of the attributes of objects of a class."""
        own = (codes.attributes_changed(it.__code__) for it in self._used(kind))
        return self._by_functions.union(*own)

    def _look(self, root: Any) -> None:
        todo = [root]
        while todo:
            it = todo.pop()
            if id(it) in self._seen or isinstance(it, str | bytes | int | float | complex):
                continue
            self._seen[id(it)] = it
            if isinstance(it, FunctionType):
                self._by_functions |= codes.attributes_changed(it.__code__)
                self._follow(it)
            elif isinstance(it, type):
                self._kinds.update(base for base in it.__mro__ if is_users_class(base))
            else:
                todo += self._inside(it)

    def _inside(self, value: Any) -> list[Any]:
        if isinstance(value, MethodType):
            self._names.add(value.__func__.__name__)
            return [value.__self__]
        if isinstance(value, functools.partial):
            return [value.func, *value.args, *value.keywords.values()]
        if isinstance(value, Mapping):
            return [*value.keys(), *value.values()]
        if isinstance(value, list | tuple | set | frozenset):
            return list(value)
        if is_wrapper(value):
            return [wrapped(value)]
        if is_users_class(type(value)):
            return [type(value), *(it for _, it in attributes(value))]
        return []

    def _follow(self, function: FunctionType) -> None:
        self._names |= codes.names(function.__code__)
        around = [it for held in cells(function) for _, it in held]
        given = [*(function.__defaults__ or ()), *(function.__kwdefaults__ or {}).values()]
        for it in (*around, *given, *(it for _, it in read_by(function))):
            self._look(it)

    def _used(self, kind: type) -> list[FunctionType]:
        """Its methods that are used by name, or by what Python does with objects; not those that make one."""
        return [
            function
            for base in kind.__mro__
            if is_users_class(base)
            for name, it in vars(base).items()
            if name not in _MAKING and (name in self._names or name.startswith("__"))
            for function in _functions(it)
        ]


def _functions(value: Any) -> Iterator[FunctionType]:
    found = [value.fget, value.fset, value.fdel] if isinstance(value, property) else [value]
    for it in found:
        inner = wrapped(it) if is_wrapper(it) else it
        if isinstance(inner, FunctionType):
            yield inner
