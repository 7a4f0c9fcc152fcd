"""What functions of the user's own can write to, kept so that it can be put back."""

from __future__ import annotations

import builtins
import contextlib
import copy
import datetime
import decimal
import dis
import enum
import fractions
import functools
import gc
import io
import logging
import os
import pathlib
import random
import re
import sys
import threading
import types
import uuid
import weakref
from collections import deque
from collections.abc import Callable, Hashable, Iterable, Iterator, Set
from contextlib import AbstractContextManager
from typing import Any

import numpy as np

from linkwork.fingerprints import is_users
from linkwork.running.places import ALL, Named, Names, Place, in_cache, is_from_c, is_same, place_of

__all__ = ["CONSTANT", "Kept", "Part", "Parts", "is_opaque", "names_in"]

#: Nothing in them can be written to that functions compute with, nor do they hold anything that can be, but
#: for attributes that a class of the user's adds.
CONSTANT = (
    type(None), bool, int, float, complex, str, bytes, np.number, np.bool_, np.character, np.datetime64,
    np.dtype, range, slice, datetime.date, datetime.time, datetime.timedelta, datetime.tzinfo,
    decimal.Decimal, decimal.Context, fractions.Fraction, re.Pattern, re.Match, uuid.UUID, pathlib.PurePath,
    enum.Enum, type(threading.Lock()), type(threading.RLock()), threading.Thread, threading.Condition,
    threading.Semaphore, threading.Barrier, logging.Logger, logging.Handler, io.TextIOWrapper, io.FileIO,
    io.BufferedWriter, types.CodeType, types.GenericAlias, types.WrapperDescriptorType,
    types.MethodDescriptorType, types.GetSetDescriptorType, types.MemberDescriptorType,
    types.ClassMethodDescriptorType, types.EllipsisType, types.NotImplementedType,
)  # fmt: skip

#: Of these an object without attributes holds what can be written to in arrays and other objects.
_HOLDERS = ("pandas", "xarray", "scipy", "operator", "functools", "types", "weakref")

#: Objects that are looked into.
MOST = 200_000

#: Of a variable or an attribute that is not there.
_ABSENT = object()

#: Containers that a compiled object has for itself.
_BARE = (list, dict, set, deque, bytearray)

_ASSIGN = ("STORE_DEREF", "STORE_GLOBAL", "STORE_ATTR")
_READ, _WRITTEN = ("LOAD_GLOBAL", "LOAD_NAME"), ("STORE_GLOBAL", "STORE_NAME")
_COMPILED = ("ctypes", "_ctypes", "_cffi_backend", "numba")
_LOCKS = ("_multiprocessing", "_thread")
_WRAPPERS = (types.MethodType, staticmethod, classmethod, functools.partial, property)
_PROXIES = (weakref.ProxyType, weakref.CallableProxyType)
_CACHE = type(functools.lru_cache(len))
_CODE = (types.FunctionType, types.BuiltinFunctionType, *_WRAPPERS, type)

#: With these a function reads or writes what its texts name.
_BY_TEXT = {"globals", "getattr", "setattr", "delattr", "vars", "__dict__"}

#: Of places what was written to: the key of one, and a part of it.
Part = tuple[Hashable, Hashable]
Parts = set[Part]


class Kept(AbstractContextManager["Kept"]):
    """All that functions reach, as it is now; as a context it puts that back at its end.

    unknown  kinds of what could not be looked into
    lost     whether something could not be put back
    """

    def __init__(self, functions: Iterable[Any]) -> None:
        self.unknown: dict[str, None] = {}
        self.lost = False
        self._assigns = False
        self._empty: set[Hashable] = set()  # places of functions' attributes that have none
        self._places: dict[Hashable, Place] = {}  # by what it is that is written to
        self._code: set[Hashable] = set()  # of these what holds functions and classes
        self._caches: dict[Hashable, tuple[Any, list[Any]]] = {}  # of functools, with what was in them
        self._seen: dict[int, Any] = {}  # alive, or another could have the same id
        self._todo = list(functions)
        while self._todo and len(self._seen) < MOST:
            it = self._todo.pop()
            try:
                self._look_into(it)
            except Exception:  # whatever an object of the user's raises
                self._unknown(it)
        if self._todo:
            self.unknown[f"more than {MOST} objects"] = None

    def __exit__(self, *error: object) -> None:
        self.put_back()

    @property
    def whole(self) -> bool:
        """Whether all could be looked into."""
        return not self.unknown

    def put_back(self, only: Parts | None = None) -> None:
        """Makes it what it was, all of it or parts."""
        chosen: dict[Hashable, set[Hashable]] = {}
        for key, part in only or ():
            chosen.setdefault(key, set()).add(part)
        for key in self._outdated() if only is None else chosen.keys() & self._caches.keys():
            self._caches[key][0].cache_clear()
        for key in self._places if only is None else chosen.keys() & self._places.keys():
            try:
                self._places[key].put_back(chosen.get(key))
            except Exception:
                self.lost = True

    def changed(self) -> Parts:
        """Where something else is now."""
        found = self._written()
        return found | {(key, ALL) for key in self._outdated(found)}

    def _written(self) -> Parts:
        found: Parts = set()
        for key, place in self._places.items():
            with contextlib.suppress(Exception):
                found.update((key, part) for part in place.changed())
        return found

    def changed_contents(self) -> Parts:
        """The same, of others than dictionaries as a whole: for `content`."""
        whole = {key for key, it in self._places.items() if not isinstance(it._then, dict)}
        return {(key, ALL if key in whole else part) for key, part in self._written()}

    def content(self, of: Part) -> Any:
        """What was there."""
        key, part = of
        then = self._places[key]._then
        return then if part == ALL else then.get(part)

    def _outdated(self, written: Parts | None = None) -> list[Hashable]:
        """Caches of functools that have been filled by functions of what was written to meanwhile.

        What was in them nobody can put back. So they are emptied; others would give the same once more.
        """
        filled = [key for key, (it, then) in self._caches.items() if not is_same(in_cache(it), then)]
        if not filled:
            return []
        keys = {key for key, _ in (self._written() if written is None else written)}
        return [key for key in filled if not keys.isdisjoint(_read_by_cached(self._caches[key][0]))]

    def again(self) -> Kept:
        """The same places, as they are now."""
        found = copy.copy(self)
        found._caches = {key: (it, in_cache(it)) for key, (it, _) in self._caches.items()}
        found._places = {}
        for key, place in self._places.items():
            with contextlib.suppress(Exception):
                found._places[key] = place.again()
        return found

    @contextlib.contextmanager
    def as_then(self, only: Parts | None = None) -> Iterator[None]:
        """A context in which it is what it was, all of it or parts; all is as it is now at its end."""
        now = self.again()
        try:
            self.put_back(only)
            yield
        finally:
            now.put_back()

    @property
    def size(self) -> int:
        """How much there is to look at: entries and elements."""
        return sum(place.size for place in self._places.values())

    def reaches(self, key: Hashable) -> bool:
        return key in self._places

    def has(self, it: Any) -> bool:
        """Whether it is an object that was looked into."""
        return id(it) in self._seen

    def has_kind(self, kind: type) -> bool:
        return any(type(it) is kind for it in self._seen.values())

    @property
    def keys(self) -> Set[Hashable]:
        """Of all places, for as long as what is written to is there."""
        return self._places.keys()

    @property
    def writable(self) -> bool:
        """Whether there are containers, or variables that they assign to."""
        return self._assigns or any(isinstance(key, int) for key in self._places.keys() - self._empty)

    def shares(self, other: Kept) -> bool:
        """Whether both reach something that can be written to, or might."""
        of_both = self._places.keys() & other._places.keys() - self._code - self._empty
        return not (self.whole and other.whole) or bool(of_both)

    def _unknown(self, it: Any) -> None:
        kind = type(it)
        self.unknown[kind.__qualname__ if kind.__module__ == "builtins" else
                     f"{kind.__module__}.{kind.__qualname__}"] = None  # fmt: skip

    def _look_into(self, it: Any) -> None:
        kind = type(it)
        if kind in _PROXIES:
            return self._proxy(it)
        if id(it) in self._seen:
            return
        if isinstance(it, CONSTANT):
            return self._attributes(it) if is_users(kind.__module__) else None
        found = place_of(it)
        if found is None and is_opaque(it):
            if hasattr(kind, "_numba_type_") or kind.__module__.startswith("numba.typed"):  # holds numbers
                self._unknown(it)
            return
        self._seen[id(it)] = it
        if isinstance(it, types.FunctionType):
            self._function(it)
        elif isinstance(it, type):
            self._class(it)
        elif isinstance(it, types.BuiltinMethodType | types.MethodWrapperType):
            self._todo.append(it.__self__)
        elif isinstance(it, _WRAPPERS):
            self._todo += _wrapped(it)
        elif isinstance(it, weakref.ref):
            self._todo.append(it())
        elif isinstance(it, _CACHE):
            self._caches[id(it)] = it, in_cache(it)
            self._attributes(it)
            self._todo += _worth_a_look(in_cache(it))
        elif found is not None:
            place, inside = found
            if place is not None:
                self._places[id(it)] = place
            self._todo += _worth_a_look(inside)
            if not is_from_c(it) and (hasattr(it, "__dict__") or is_users(kind.__module__)):
                self._object(it)
        elif isinstance(it, tuple | frozenset):
            self._todo += it
        elif not isinstance(it, types.ModuleType):
            self._object(it)

    def _proxy(self, it: Any) -> None:
        with contextlib.suppress(ReferenceError):  # nothing is behind it
            self._todo.append(vars(it))

    def _function(self, it: types.FunctionType) -> None:
        self._assigns = self._assigns or _assigns(it.__code__)
        for cell in it.__closure__ or ():
            self._seen[id(cell)] = cell
            get = functools.partial(_in_cell, cell)
            self._named(
                (id(cell), "cell_contents"), get(), get, functools.partial(_put, cell, "cell_contents")
            )
        self._todo += [*(it.__defaults__ or ()), it.__kwdefaults__, vars(it)]
        if not vars(it):
            self._empty.add(id(vars(it)))
        if _is_installed(it):
            return
        names, known = names_in(it.__code__), it.__globals__
        texts = texts_in(it.__code__) if names & _BY_TEXT else frozenset()
        variables, new = variables_in(it.__code__), attributes_set_in(it.__code__) | texts
        names |= texts
        for name in names & known.keys() | variables | (texts if "globals" in names else frozenset()):
            self._entry(known, name)
            self._module(known.get(name), names, new)

    def _module(self, value: Any, names: frozenset[str], new: frozenset[str]) -> None:
        """What a function reads there, by names that it uses; `new` need not be there yet."""
        if getattr(value, "__module__", "") == "numpy.random":  # a function that is imported from there
            self._todo.append(np.random.mtrand._rand)
        if not isinstance(value, types.ModuleType) or id(value) in self._seen:
            return
        if value is os and names & {"environ", "getenv"}:
            self._todo.append(os.environ)
        if value is random:
            self._todo.append(random.seed.__self__)  # type: ignore[attr-defined]
        if value is np.random or (value is np and "random" in names):
            self._todo.append(np.random.mtrand._rand)
        if not is_users(value.__name__):
            return
        self._seen[id(value)] = value
        for name in names & vars(value).keys() | new:
            self._attribute(value, name, vars(value).get(name, _ABSENT))
            self._module(vars(value).get(name), names, new)
        del self._seen[id(value)]  # another function uses other names

    def _class(self, it: type) -> None:
        if not is_users(it.__module__):
            return
        for name, value in vars(it).items():
            if name.startswith("__") and name != "__call__":
                continue
            if not isinstance(value, types.MemberDescriptorType):
                self._attribute(it, name, value)
        self._places[id(it), "names"] = Names(it)
        self._code.add((id(it), "names"))
        self._todo += [*it.__bases__, type(it)]

    def _object(self, it: Any) -> None:
        kind = type(it)
        self._attributes(it)
        if id(it) not in self._places:
            # Bare containers are the object's own, which counts on what is in them: writing there may crash.
            self._todo += [
                inner for inner in gc.get_referents(it) if inner is not kind and type(inner) not in _BARE
            ]
            has_own = hasattr(it, "__dict__") or any("__slots__" in vars(base) for base in kind.__mro__)
            if (
                not has_own
                and kind is not object
                and kind.__module__.partition(".")[0] not in (*_HOLDERS, *_LOCKS)
            ):
                self._unknown(it)
        if is_users(kind.__module__):
            self._todo.append(kind)

    def _attributes(self, it: Any) -> None:
        kind = type(it)
        self._seen[id(it)] = it
        for name in [name for base in kind.__mro__ for name in _slots(base)]:
            self._attribute(it, name, getattr(it, name, _ABSENT))
        if hasattr(it, "__dict__"):
            self._todo.append(vars(it))
            if is_users(kind.__module__):
                self._attribute(it, "__class__", kind)

    def _attribute(self, of: Any, name: str, value: Any) -> None:
        self._seen[id(of)] = of
        if isinstance(of, type | types.ModuleType):
            held: Any = vars(of)
            get = functools.partial(held.get, name, _ABSENT)
        else:
            get = functools.partial(getattr, of, name, _ABSENT)
        self._named((id(of), name), value, get, functools.partial(_put, of, name))

    def _entry(self, of: dict[str, Any], name: str) -> None:
        get = functools.partial(of.get, name, _ABSENT)
        self._named((id(of), name), get(), get, functools.partial(_enter, of, name))

    def _named(self, key: Hashable, value: Any, get: Callable[[], Any], put: Callable[[Any], object]) -> None:
        if value is not _ABSENT:
            self._todo.append(value)
        if isinstance(value, types.ModuleType):
            return
        self._places[key] = Named(get, put)
        if isinstance(value, _CODE):
            self._code.add(key)


#: What long logs are full of, in tuples, too.
_NUMBERS = {type(None), bool, int, float, complex, str, bytes, np.float64}


def _worth_a_look(inside: Iterable[Any]) -> list[Any]:
    return [
        it
        for it in inside
        if not (type(it) in _NUMBERS or (type(it) is tuple and _NUMBERS.issuperset(map(type, it))))
    ]


def _in_cell(cell: types.CellType) -> Any:
    try:
        return cell.cell_contents
    except ValueError:  # nothing is in it
        return _ABSENT


def _put(of: Any, name: str, value: Any) -> None:
    plain = isinstance(of, type | types.ModuleType)
    if value is _ABSENT:
        (delattr if plain else object.__delattr__)(of, name)
    else:
        (setattr if plain else object.__setattr__)(of, name, value)


def _enter(of: dict[str, Any], name: str, value: Any) -> None:
    if value is _ABSENT:
        of.pop(name, None)
    else:
        of[name] = value


def _wrapped(it: Any) -> list[Any]:
    if isinstance(it, property):
        return [it.fget, it.fset]
    if isinstance(it, functools.partial):
        return [it.func, *it.args, it.keywords]
    return [it.__func__, getattr(it, "__self__", None)]


def _read_by_cached(it: Any) -> Set[Hashable]:
    """What a cached function reaches, by itself or in arguments that it was called with."""
    return Kept([it.__wrapped__, *_worth_a_look(in_cache(it))]).keys


def _slots(kind: type) -> list[str]:
    named = vars(kind).get("__slots__", ())
    found = [named] if isinstance(named, str) else list(named)
    private = "_" + kind.__name__.lstrip("_")
    return [
        f"{private}{it}" if it.startswith("__") and not it.endswith("__") else it
        for it in found
        if it not in ("__dict__", "__weakref__")
    ]


@functools.cache
def _assigns(code: types.CodeType) -> bool:
    """Whether it, or a function inside, assigns to other variables than its own, or to attributes."""
    inner = [it for it in code.co_consts if isinstance(it, types.CodeType)]
    return any(it.opname in _ASSIGN for it in dis.get_instructions(code)) or any(map(_assigns, inner))


@functools.cache
def variables_in(code: types.CodeType) -> frozenset[str]:
    """Global ones that it, or a function inside, reads or writes, but for those of Python's own."""
    inner = [variables_in(it) for it in code.co_consts if isinstance(it, types.CodeType)]
    steps = list(dis.get_instructions(code))
    read, written = ({it.argval for it in steps if it.opname in kind} for kind in (_READ, _WRITTEN))
    return frozenset({name for name in read if not hasattr(builtins, name)} | written).union(*inner)


@functools.cache
def attributes_set_in(code: types.CodeType) -> frozenset[str]:
    inner = [attributes_set_in(it) for it in code.co_consts if isinstance(it, types.CodeType)]
    return frozenset(it.argval for it in dis.get_instructions(code) if it.opname == "STORE_ATTR").union(
        *inner
    )


def _is_installed(function: types.FunctionType) -> bool:
    """Whether its global variables are those of a module that is not the user's."""
    name = function.__module__ or ""
    of_module = vars(sys.modules[name]) if name in sys.modules else None
    return of_module is function.__globals__ and not is_users(name)


def is_opaque(it: Any) -> bool:
    """What keeps no numbers of the user's: compiled functions, parts of a model."""
    package, _, rest = type(it).__module__.partition(".")
    if is_from_c(it):
        return False
    return (
        isinstance(it, np.ufunc)
        or package in _COMPILED
        or (package == "linkwork" and not rest.startswith("functions"))
    )


@functools.cache
def names_in(code: types.CodeType) -> frozenset[str]:
    """Of globals and attributes, also of the functions inside."""
    inner = [names_in(it) for it in code.co_consts if isinstance(it, types.CodeType)]
    return frozenset(code.co_names).union(*inner)


@functools.cache
def texts_in(code: types.CodeType) -> frozenset[str]:
    """Constants, also of the functions inside."""
    inner = [texts_in(it) for it in code.co_consts if isinstance(it, types.CodeType)]
    return frozenset(it for it in code.co_consts if isinstance(it, str)).union(*inner)
