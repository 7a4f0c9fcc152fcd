"""What counts of objects, functions and classes: their parts, and what they read."""

from __future__ import annotations

import array
import collections
import contextlib
import dataclasses
import datetime
import dis
import functools
import inspect
import io
import logging
import random
import re
import sys
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from types import (
    BuiltinFunctionType,
    CellType,
    CodeType,
    FunctionType,
    GetSetDescriptorType,
    MappingProxyType,
    MethodType,
    ModuleType,
    SimpleNamespace,
)
from typing import Any

import numpy as np

from linkwork.fingerprints.origins import is_users, made_from

__all__ = [
    "RESTLESS", "attached", "attributes", "attributes_changed", "bare", "beside", "cells", "counts",
    "is_wrapper", "module_of", "of_class", "read_by", "shown", "wrapped",
]  # fmt: skip

#: Data, whose every bit counts.
_DATA = (bool, int, float, complex, str, bytes, list, tuple, dict, set, frozenset, np.generic, np.ndarray)

#: Values of the standard library that say all by what they are made of.
_VALUES = (
    *_DATA, slice, range, bytearray, array.array, collections.deque, re.Pattern, Decimal, Fraction, Enum,
    datetime.date, datetime.time, datetime.timedelta, MappingProxyType, SimpleNamespace, functools.partial,
    MethodType,
)  # fmt: skip

#: Whose state says nothing about what is computed, or is never the same.
RESTLESS = (
    logging.Logger, logging.Handler, io.IOBase, random.Random, np.random.Generator, np.random.RandomState,
)  # fmt: skip

#: Methods by which a container changes.
_CHANGING = {
    "append", "appendleft", "extend", "extendleft", "insert", "pop", "popleft", "popitem", "remove",
    "discard", "clear", "update", "setdefault", "add", "sort", "reverse", "rotate", "move_to_end",
}  # fmt: skip

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
    return sorted((name, it) for name, it in found.items() if name not in kept and isinstance(name, str))


def bare(value: Any) -> Any:
    """The data alone, of an object of a class that is made from one of data."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    return next(it for it in type(value).__mro__ if it in _DATA)(value)


def beside(value: Any) -> list[tuple[str, Any]]:
    """Attributes that such an object has beside its data."""
    home = type(value).__module__.split(".")[0]
    if home in ("builtins", "numpy") or not isinstance(value, _DATA) or isinstance(value, Enum):
        return []
    return attributes(value)


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
    found = [(name, it) for name, it in found if isinstance(it, _DATA)]
    return found if any(isinstance(it, np.ndarray) for _, it in found) else []


def attached(function: FunctionType) -> list[tuple[str, Any]]:
    """What counts of a function's attributes, but for those to which it writes, as counters and what it
    remembers."""
    own, written = module_of(function), attributes_changed(function.__code__)
    return sorted(
        (name, it)
        for name, it in vars(function).items()
        if name != "__wrapped__" and name not in written and counts(it, own)
    )


def attributes_changed(code: CodeType) -> frozenset[str]:
    return _changed(code, ("LOAD_ATTR",), ("STORE_ATTR", "DELETE_ATTR"))


@functools.cache
def _changed(code: CodeType, read: tuple[str, ...], written: tuple[str, ...]) -> frozenset[str]:
    """Names to which a function, and those inside of it, writes, or in which it changes what is there."""
    steps = [it for it in dis.get_instructions(code) if it.opname != "CACHE"]
    found = {it.argval for it in steps if it.opname in written}
    for what, then, last in zip(steps, steps[1:], steps[2:], strict=False):
        item = last.opname == "STORE_SUBSCR" and then.opname.startswith("LOAD_")
        method = then.opname in ("LOAD_ATTR", "LOAD_METHOD") and then.argval in _CHANGING
        if what.opname in read and (item or method):
            found.add(what.argval)
    inner = (it for it in code.co_consts if isinstance(it, CodeType))
    return frozenset(found.union(*(_changed(it, read, written) for it in inner)))


def read_by(function: FunctionType) -> list[tuple[str, Any]]:
    """What counts of its module, and of others that are not installed, by name."""
    own, known = module_of(function), function.__globals__
    found: dict[str, Any] = {}
    modules: list[tuple[str, ModuleType]] = []
    for name in _loaded(function.__code__):
        value = known.get(name)
        if isinstance(value, ModuleType):
            modules.append((name, value))
        elif name in known and counts(value, own):
            found[name] = value
    modules += [(name, sys.modules[name]) for name in _imported(function.__code__) if name in sys.modules]
    seen: set[int] = set()
    while modules:
        label, module = modules.pop()
        if id(module) in seen or not _is_own(module.__name__, own):
            continue
        seen.add(id(module))
        for name in _names(function.__code__) & vars(module).keys():
            value = vars(module)[name]
            if isinstance(value, ModuleType):
                modules.append((f"{label}.{name}", value))
            elif counts(value, own):
                found[f"{label}.{name}"] = value
    return sorted(found.items())


def counts(value: Any, own: str) -> bool:
    """Whether it is known by more than its name: functions and classes that are not installed, and data."""
    if isinstance(value, FunctionType):
        return _is_own(module_of(value), own)
    if isinstance(value, type):
        return _is_own(value.__module__, own)
    if (made := made_from(value)) is not None:
        return all(counts(it, own) for it in made if isinstance(it, FunctionType))
    if isinstance(value, (ModuleType, BuiltinFunctionType, *RESTLESS)):
        return False
    if is_wrapper(value):
        return counts(wrapped(value), own)
    kind = type(value)
    if isinstance(value, _VALUES) or value is None or hasattr(kind, "__array__"):
        return True
    if _is_own(kind.__module__, own) or dataclasses.is_dataclass(value) or hasattr(kind, "__fingerprint__"):
        return True
    if shown(value):
        return True
    held = attributes(value)
    said = (*_VALUES, ModuleType)
    return bool(held) and all(it is None or callable(it) or isinstance(it, said) for _, it in held)


def of_class(kind: type) -> list[tuple[str, Any]]:
    """What its text says, and that of those that it is made from."""
    found = []
    bases: list[type] = [*kind.__mro__, *inspect.getmro(type(kind))]
    for place, base in enumerate(bases):
        if not is_users(base.__module__):
            continue
        for name, value in sorted(vars(base).items()):
            if name not in _MADE and (_is_written(value) or counts(value, base.__module__)):
                found.append((f"{place}.{name}", value))
    return found


def _is_written(value: Any) -> bool:
    return isinstance(value, property | functools.partialmethod) or is_wrapper(value)


def module_of(function: FunctionType) -> str:
    """Where it is written: `__module__` of a wrapper is that of what it wraps."""
    return str(function.__globals__.get("__name__", function.__module__))


def cells(function: FunctionType) -> list[tuple[str, Any]]:
    """Variables from around it, but for those that it changes, as counters."""
    code = function.__code__
    changed = _changed(code, ("LOAD_DEREF",), ("STORE_DEREF", "DELETE_DEREF"))
    around = zip(code.co_freevars, function.__closure__ or (), strict=True)
    return [(name, _content(cell)) for name, cell in around if name not in changed]


def _loaded(code: CodeType) -> list[str]:
    """Names that a function, and those inside of it, read as globals: attributes may have the same. What it
    changes itself, as counters and what it remembers, is not read."""
    return sorted(_globals_of(code) - _changed(code, ("LOAD_GLOBAL",), ("STORE_GLOBAL", "DELETE_GLOBAL")))


@functools.cache
def _globals_of(code: CodeType) -> frozenset[str]:
    steps = dis.get_instructions(code)
    found = {it.argval for it in steps if it.opname in ("LOAD_GLOBAL", "LOAD_NAME")}
    return frozenset(found.union(*(_globals_of(it) for it in code.co_consts if isinstance(it, CodeType))))


@functools.cache
def _imported(code: CodeType) -> list[str]:
    """Modules that it imports itself."""
    found = {it.argval for it in dis.get_instructions(code) if it.opname == "IMPORT_NAME"}
    return sorted(found.union(*(_imported(it) for it in code.co_consts if isinstance(it, CodeType))))


def _is_own(module: str, own: str) -> bool:
    return module == own or is_users(module)


def _content(cell: CellType) -> Any:
    with contextlib.suppress(ValueError):  # there is nothing in it yet
        return cell.cell_contents
    return None


def _names(code: CodeType) -> set[str]:
    """That a function and those inside of it use."""
    inner = [it for it in code.co_consts if isinstance(it, CodeType)]
    return set(code.co_names).union(*map(_names, inner))
