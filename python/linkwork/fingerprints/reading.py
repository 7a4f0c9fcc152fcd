"""What counts of objects, functions and classes: their parts, and what they read."""

from __future__ import annotations

import array
import builtins
import collections
import contextlib
import contextvars
import dataclasses
import datetime
import functools
import importlib.util
import inspect
import io
import logging
import random
import re
import sys
import threading
import weakref
from collections.abc import Iterable, Iterator
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from types import (
    BuiltinFunctionType,
    CellType,
    FunctionType,
    GetSetDescriptorType,
    MappingProxyType,
    MethodType,
    ModuleType,
    SimpleNamespace,
)
from typing import Any

import numpy as np

from linkwork.fingerprints import codes
from linkwork.fingerprints.origins import (
    imported,
    is_installed,
    is_users,
    is_users_class,
    made_from,
    module_of,
)

__all__ = [
    "DATA", "RESTLESS", "attached", "attributes", "bare", "cells", "counts", "is_wrapper", "kept_by_pickle",
    "of_class", "of_module", "read_by", "shown", "wrapped",
]  # fmt: skip

#: Data, whose every bit counts.
DATA = (bool, int, float, complex, str, bytes, list, tuple, dict, set, frozenset, np.generic, np.ndarray)

#: Values of the standard library that say all by what they are made of.
_VALUES = (
    *DATA, slice, range, bytearray, memoryview, array.array, collections.deque, re.Pattern, Decimal, Fraction,
    Enum, datetime.date, datetime.time, datetime.timedelta, MappingProxyType, SimpleNamespace,
    functools.partial, MethodType,
)  # fmt: skip

#: Data without parts.
_NUMBERS = (bool, int, float, complex, str, bytes, np.generic, np.ndarray)

#: Where libraries keep what a class says of the attributes of its objects: their defaults, too.
_FIELDS = ("__pydantic_fields__", "__attrs_attrs__")

#: Whose state says nothing about what is computed, or is never the same.
RESTLESS = (
    logging.Logger, logging.Handler, io.IOBase, random.Random, np.random.Generator, np.random.RandomState,
    weakref.WeakKeyDictionary, weakref.WeakValueDictionary, weakref.WeakSet, threading.Thread,
    threading.Event, threading.Condition, threading.Semaphore, threading.Barrier, type(threading.Lock()),
    type(threading.RLock()),
)  # fmt: skip

#: Variables of these count by what they hold now.
_HOLDING = (
    contextvars.ContextVar, weakref.WeakKeyDictionary, weakref.WeakValueDictionary, weakref.WeakSet,
)  # fmt: skip

#: Methods by which a class says how its objects are pickled.
_PICKLING = ("__reduce__", "__reduce_ex__", "__getstate__", "__getnewargs__", "__getnewargs_ex__")

#: Functions that read what has no name in the code: a module by its name, all of their own module.
_IMPORTERS = {"import_module", "__import__"}
_READ_ALL = frozenset({"globals", "eval", "exec"})

#: Objects within each other of which it is looked whether they can be known.
_DEEPEST = 5

#: What a class has that nobody has written.
_MADE = {
    "__module__", "__qualname__", "__dict__", "__weakref__", "__doc__", "__annotations__", "__slots__",
    "__abstractmethods__", "_abc_impl", "__dataclass_fields__", "__dataclass_params__", "__match_args__",
    "__parameters__", "__orig_bases__", "__firstlineno__", "__static_attributes__", "_value2member_map_",
    "__slotnames__",
}  # fmt: skip


def is_wrapper(value: Any) -> bool:
    """Of a function: a method of a class, one that is cached."""
    return isinstance(value, staticmethod | classmethod | functools.cached_property) or (
        type(value).__name__ == "_lru_cache_wrapper"
    )


def wrapped(value: Any) -> Any:
    return value.func if isinstance(value, functools.cached_property) else value.__wrapped__


def attributes(value: Any) -> list[tuple[str, Any]]:
    """Attributes of an object of a class written in Python, without what it has kept of its own."""
    kind = type(value)
    slots = [getattr(base, "__slots__", ()) for base in kind.__mro__]
    names = {name for it in slots for name in ((it,) if isinstance(it, str) else it)}
    found = {name: getattr(value, name) for name in names if hasattr(value, name)} | getattr(
        value, "__dict__", {}
    )
    kept = {
        name
        for base in kind.__mro__
        for name, it in vars(base).items()
        if isinstance(it, functools.cached_property)
    }
    kept.add("__weakref__")
    return sorted((name, it) for name, it in found.items() if name not in kept and isinstance(name, str))


def bare(value: Any) -> Any:
    """The data alone, of an object of a class that is made from one of data."""
    if isinstance(value, np.generic):
        return np.asarray(value)
    if isinstance(value, np.ndarray):
        return value.view(next(it for it in type(value).__mro__ if it.__module__.split(".")[0] == "numpy"))
    return next(it for it in type(value).__mro__ if it in DATA)(value)


def shown(value: Any) -> list[tuple[str, Any]]:
    """Numbers and arrays that a compiled class shows, such as a tree of points; none without arrays."""
    names = {
        name
        for base in type(value).__mro__
        for name, it in vars(base).items()
        if isinstance(it, GetSetDescriptorType) and not name.startswith("_")
    }
    found = []
    for name in sorted(names):
        with contextlib.suppress(Exception):  # it is not to be had now
            found.append((name, getattr(value, name)))
    found = [(name, it) for name, it in found if isinstance(it, DATA)]
    return found if any(isinstance(it, np.ndarray) for _, it in found) else []


def kept_by_pickle(value: Any, kinds: Iterable[type]) -> list[Any]:
    """What such classes of an object say themselves that it is made of; none where they say nothing."""
    if not any(name in vars(kind) for kind in kinds if kind is not object for name in _PICKLING):
        return []
    with contextlib.suppress(Exception):  # what cannot be pickled says so in many ways
        reduced = value.__reduce_ex__(4)
        if isinstance(reduced, tuple):
            return [list(it) if isinstance(it, Iterator) else it for it in reduced[1:]]
    return []


def attached(function: FunctionType) -> list[tuple[str, Any]]:
    """What counts of a function's attributes, but for those to which it writes, as counters and what it
    remembers."""
    own, code = module_of(function), function.__code__
    itself = function.__name__ in codes.globals_read(code) | set(code.co_freevars)
    changes = codes.attributes_changed(code) if itself else codes.Changes()
    return sorted(
        (name, it)
        for name, it in vars(function).items()
        if name != "__wrapped__" and counts(it, own) and not codes.is_changed(name, it, changes)
    )


def read_by(function: FunctionType) -> list[tuple[str, Any]]:
    """What counts of its module, of others that are not installed, and of what was put into installed ones,
    by name. What it changes itself, as counters and what it remembers, is not read; of a module that it hands
    on everything is."""
    own, known, code = module_of(function), function.__globals__, function.__code__
    if function.__closure__ and not is_users(own):  # what is read is what it is made around
        return []
    changes, handed_on = codes.globals_changed(code), codes.handed_on(code)
    found: dict[str, Any] = {}
    modules: list[tuple[str, ModuleType, bool]] = []
    for name in codes.globals_read(code):
        value = known[name] if name in known else vars(builtins).get(name, NotImplemented)
        if isinstance(value, ModuleType):
            modules.append((name, value, name in handed_on))
        elif _is_read(value, own) and not codes.is_changed(name, value, changes):
            found[name] = _now(value)
            if isinstance(value, type) and "__subclasses__" in codes.names(code):
                found[f"{name}.__subclasses__"] = type.__subclasses__(value)
    if codes.globals_read(code) & _READ_ALL - known.keys() and own in sys.modules:
        modules.append(("", sys.modules[own], True))
    for name, value, whole in _imports(function):
        if isinstance(value, ModuleType):
            modules.append((name, value, whole))
        elif value is not None:
            found[name] = value
    return sorted((found | _of_modules(modules, function)).items())


def _of_modules(modules: list[tuple[str, ModuleType, bool]], function: FunctionType) -> dict[str, Any]:
    """What counts of modules that are not installed, by names that a function uses; or all of it."""
    own, used = module_of(function), codes.names(function.__code__) | {"__getattr__"}
    handed_on = codes.handed_on(function.__code__)
    found: dict[str, Any] = {}
    seen: set[tuple[int, bool]] = set()
    while modules:
        label, module, whole = modules.pop()
        if (id(module), whole) in seen:
            continue
        seen.add((id(module), whole))
        is_known = _is_read if counts(module, own) else _is_put
        if whole and is_known is _is_read:
            found[label] = module
        for name in used & vars(module).keys():
            value = vars(module)[name]
            if isinstance(value, ModuleType):
                modules.append((f"{label}.{name}", value, name in handed_on))
            elif is_known(value, own):
                found[f"{label}.{name}"] = _now(value)
    return found


def _is_read(value: Any, own: str) -> bool:
    return isinstance(value, _HOLDING) or counts(value, own)


def _is_put(value: Any, own: str) -> bool:
    """Whether somebody may have put it into an installed module: numbers, of which most are its constants,
    and what is made of the user's functions and classes."""
    if isinstance(value, FunctionType):
        return is_users(module_of(value))
    kind = value if isinstance(value, type) else type(value)
    is_number = kind in (bool, int, float, complex, np.ndarray) or issubclass(kind, np.generic)
    return is_number or is_users_class(kind)


def _now(value: Any) -> Any:
    """What it holds, of what is none of its own."""
    if isinstance(value, contextvars.ContextVar):
        with contextlib.suppress(LookupError):
            return ["context", value.get()]
        return ["context"]
    if isinstance(value, weakref.WeakSet):
        return frozenset(value)
    is_mapping = isinstance(value, weakref.WeakKeyDictionary | weakref.WeakValueDictionary)
    return dict(value) if is_mapping else value


def _imports(function: FunctionType) -> list[tuple[str, Any, bool]]:
    """Modules that a function imports itself, whether it hands them on; the text of what cannot be."""
    code, known = function.__code__, function.__globals__
    handed_on = codes.handed_on(code)
    found: list[tuple[str, Any, bool]] = []
    for it in codes.imports(code):
        name = it.module
        if it.level:
            package = known.get("__package__") or module_of(function).rpartition(".")[0]
            with contextlib.suppress(ImportError):
                name = importlib.util.resolve_name("." * it.level + name, package)
        whole = not it.known_as.isdisjoint(handed_on)
        found += [(place, imported(place), whole and not it.names) for place in {name, name.split(".")[0]}]
        for part in it.names:  # what a module has, or a module of a package
            has = getattr(sys.modules.get(name), part, None)
            if has is None or isinstance(has, ModuleType):
                found.append((f"{name}.{part}", has or imported(f"{name}.{part}"), whole))
    if codes.names(code) & _IMPORTERS or codes.names(code) >= {"sys", "modules"}:
        texts = (it for it in codes.constants(code) if it.replace(".", "").isidentifier())
        found += [(it, imported(it), True) for it in texts]
        if "__name__" in codes.globals_read(code):
            found.append(("__name__", imported(module_of(function)), False))
    return found


def counts(value: Any, own: str, depth: int = 0) -> bool:
    """Whether it is known by more than its name: functions, classes and modules that are not installed, what
    is made while a program runs, and data."""
    if isinstance(value, FunctionType):
        return module_of(value) == own or not is_installed(value)
    if isinstance(value, type):
        return value.__module__ == own or is_users_class(value)
    if isinstance(value, ModuleType):
        return value.__name__ == own or is_users(value.__name__)
    if (made := made_from(value)) is not None:
        return all(counts(it, own) for it in made if isinstance(it, FunctionType))
    if isinstance(value, (BuiltinFunctionType, np.ufunc, *RESTLESS)):
        return False
    if is_wrapper(value):
        return counts(wrapped(value), own)
    if isinstance(value, weakref.ref):
        return counts(value(), own)
    kind = type(value)
    if isinstance(value, _VALUES) or value is None or hasattr(kind, "__array__"):
        return True
    if kind.__module__ == own or is_users_class(kind) or dataclasses.is_dataclass(value):
        return True
    if hasattr(kind, "__fingerprint__") or shown(value) or depth > _DEEPEST:
        return True
    if kept := kept_by_pickle(value, kind.__mro__):
        return all(_says(it, own, depth) for it in kept)
    held = attributes(value)
    return bool(held) and all(_says(it, own, depth) for _, it in held)


def _says(value: Any, own: str, depth: int) -> bool:
    """Whether it can be known what an object holds."""
    return value is None or callable(value) or isinstance(value, ModuleType) or counts(value, own, depth + 1)


def of_module(module: ModuleType) -> list[tuple[str, Any]]:
    """All that counts of a module."""
    own = module.__name__
    return sorted(
        (name, it)
        for name, it in vars(module).items()
        if counts(it, own) and (not name.startswith("__") or isinstance(it, FunctionType))
    )


def of_class(kind: type) -> list[tuple[str, Any]]:
    """What its text says, and that of those that it is made from."""
    found = []
    bases: list[type] = [*kind.__mro__, *inspect.getmro(type(kind))]
    for place, base in enumerate(bases):
        if not is_users_class(base):
            continue
        for name, value in sorted(vars(base).items()):
            if not _is_made(name, value) and (_is_written(value) or counts(value, base.__module__)):
                found.append((name if base is kind else f"{place}.{name}", value))
    return found


def _is_written(value: Any) -> bool:
    return isinstance(value, property | functools.partialmethod) or is_wrapper(value)


def _is_made(name: str, value: Any) -> bool:
    """Names with two underscores are those of methods, of data, and of what libraries make of a class."""
    if name in _MADE:
        return True
    written = isinstance(value, (FunctionType, *_NUMBERS)) or _is_written(value)
    return name.startswith("__") and name not in _FIELDS and not written


def cells(function: FunctionType) -> tuple[list[tuple[str, Any]], list[tuple[str, Any]]]:
    """Variables from around it, and those that it changes itself, as counters. Of a function that an
    installed module has made, those that count, and nothing that it remembers."""
    code = function.__code__
    changes, users = codes.cells_changed(code), is_users(module_of(function))
    around = list(zip(code.co_freevars, map(_content, function.__closure__ or ()), strict=True))
    read: list[tuple[str, Any]] = []
    kept: list[tuple[str, Any]] = []
    for name, it in around:
        if not codes.is_changed(name, it, changes):
            read += [(name, _now(it) if users else it)] if users or counts(it, "") else []
        elif users:
            kept.append((name, it))
    return read, kept


def _content(cell: CellType) -> Any:
    with contextlib.suppress(ValueError):  # there is nothing in it yet
        return cell.cell_contents
    return None
