"""Content hashes of models and studies: equal for equal values, in any process, on any machine."""

from __future__ import annotations

import array
import collections
import contextlib
import dataclasses
import datetime
import dis
import functools
import hashlib
import inspect
import io
import logging
import random
import re
import sys
import sysconfig
from collections.abc import Iterator, Mapping, Sequence, Set
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from os import PathLike
from pathlib import Path
from types import (
    BuiltinFunctionType,
    CellType,
    CodeType,
    FunctionType,
    MappingProxyType,
    MethodType,
    ModuleType,
    SimpleNamespace,
)
from typing import Any

import numpy as np

from linkwork.errors import OptionError

__all__ = ["canonical", "digest", "digests", "law", "plain"]

#: Data, whose every bit counts.
_DATA = (bool, int, float, complex, str, bytes, list, tuple, dict, set, frozenset, np.generic, np.ndarray)

#: Values of the standard library that say all by what they are made of.
_VALUES = (
    *_DATA, slice, range, bytearray, array.array, collections.deque, re.Pattern, Decimal, Fraction, Enum,
    datetime.date, datetime.time, datetime.timedelta, MappingProxyType, SimpleNamespace, functools.partial,
    MethodType,
)  # fmt: skip

#: Whose state says nothing about what is computed, or is never the same.
_RESTLESS = (
    logging.Logger, logging.Handler, io.IOBase, random.Random, np.random.Generator, np.random.RandomState,
)  # fmt: skip

#: Where an object is in memory, which says nothing about it.
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")

#: Calls within each other.
DEEPEST = 200_000

#: Characters of a text that is written out where it is part of another.
LONG = 4000

#: What a class has that nobody has written.
_MADE = {
    "__module__", "__qualname__", "__dict__", "__weakref__", "__doc__", "__annotations__", "__slots__",
    "__abstractmethods__", "_abc_impl", "__dataclass_fields__", "__dataclass_params__", "__match_args__",
    "__parameters__", "__orig_bases__", "__firstlineno__", "__static_attributes__", "_value2member_map_",
}  # fmt: skip


def digest(*values: Any) -> str:
    """32 hexadecimal digits. OptionError: lists in lists, too many of them."""
    return _hashed(canonical(values))


def _hashed(text: str) -> str:
    return hashlib.blake2b(text.encode(errors="surrogatepass"), digest_size=16).hexdigest()


def _short(text: str) -> str:
    return text if len(text) <= LONG else _hashed(text)


def digests(head: str, columns: Mapping[str, Sequence[Any]]) -> list[str]:
    """digest(head, {name: value}) of each row of columns of equal length."""
    names = sorted(columns, key=lambda name: f"list({name!r},")
    if not all(type(value) is float for values in columns.values() for value in values):
        rows = zip(*columns.values(), strict=True)
        return [digest(head, dict(zip(columns, row, strict=True))) for row in rows]
    start, inner = f"list({head!r},", [f"list({name!r}," for name in names]
    texts = (
        "dict(" + ",".join(f"{text}{it.hex()})" for text, it in zip(inner, row, strict=True)) + ")"
        for row in zip(*(columns[name] for name in names), strict=True)
    )
    return [_hashed(_short(f"{start}{_short(text)})")) for text in texts]


def canonical(value: Any) -> str:
    """A text with every bit of the value. Functions count by their code, defaults, closures, and by the data,
    functions and classes that they read of their own module and others that are not installed; objects by
    their attributes, and by their classes where these are not installed."""
    try:
        return _Writer().text(value)
    except RecursionError:  # a chain of objects that is long, or for ever
        return _text_of_chain(value)


def _text_of_chain(value: Any) -> str:
    usual = sys.getrecursionlimit()
    sys.setrecursionlimit(max(usual, DEEPEST))
    try:
        return _Writer().text(value)
    except RecursionError as error:
        raise OptionError(
            f"a value ({type(value).__name__}) is nested more than {DEEPEST // 4} deep: it cannot be told "
            "from others; give something that is flatter",
            code="parameters",
        ) from error
    finally:
        sys.setrecursionlimit(usual)


class _Writer:
    """Writes each object once, however many ways lead to it."""

    def __init__(self) -> None:
        # by the place in memory, which is an object's own as long as it stays: so it does
        self._known: dict[int, tuple[Any, str]] = {}
        self._inside: set[int] = set()

    def text(self, value: Any) -> str:
        if type(value) is float:  # what most are
            return value.hex()
        if type(value) is str:
            return _short(repr(value))
        if isinstance(value, np.generic | np.ndarray):
            value = value.tolist()
        if isinstance(value, float):
            return float(value).hex()
        if value is None or isinstance(value, bool | bytes | str) or value is Ellipsis:
            return _short(repr(value))
        if isinstance(value, int) and not isinstance(value, Enum):
            return repr(int(value)) if abs(value) < 2**64 else hex(value)
        if id(value) in self._known:
            return self._known[id(value)][1]
        if id(value) in self._inside:
            return "itself"
        self._inside.add(id(value))
        found = _short(self._written(value))
        self._inside.discard(id(value))
        self._known[id(value)] = value, found
        return found

    def _written(self, value: Any) -> str:
        parts = [self.text(part) for part in _parts(value)]
        if isinstance(value, Set | Mapping):
            parts.sort()
        kind = "list" if isinstance(value, list | tuple) else type(value).__name__
        return f"{kind}({','.join(parts)})" if parts else ADDRESS.sub("", f"{kind} {value!r}")


def _parts(value: Any) -> list[Any]:
    """What it is made of; none where its own text says that."""
    if isinstance(value, list | tuple | Set | collections.deque):
        return list(value)
    if isinstance(value, Mapping):
        return [*value.items()]
    if isinstance(value, FunctionType):
        parts = [value.__qualname__, value.__code__, value.__defaults__, value.__kwdefaults__, _cells(value)]
        return [*parts, *_read_by(value)]
    if isinstance(value, CodeType):
        return [value.co_code, value.co_consts, value.co_names, value.co_varnames]
    if isinstance(value, MethodType):
        return [value.__func__, value.__self__]
    if isinstance(value, functools.partial | functools.partialmethod):
        return [value.func, value.args, value.keywords]
    if isinstance(value, Enum):
        return [value.name, value.value]
    if isinstance(value, property):
        return [value.fget, value.fset, value.fdel]
    if _is_wrapper(value):
        return [_wrapped(value)]
    if isinstance(value, type):
        content = _of_class(value) if _is_users(value.__module__) else [("module", value.__module__)]
        return [value.__qualname__, *content]
    if isinstance(value, slice):
        return ["slice", value.start, value.stop, value.step]
    return _parts_of_object(value)


def _is_wrapper(value: Any) -> bool:
    """Of a function: a method of a class, one that is cached."""
    return isinstance(value, staticmethod | classmethod | functools.cached_property) or (
        type(value).__name__ == "_lru_cache_wrapper"
    )


def _wrapped(value: Any) -> Any:
    return value.func if isinstance(value, functools.cached_property) else value.__wrapped__


def _parts_of_object(value: Any) -> list[Any]:
    kind = type(value)
    if isinstance(value, (ModuleType, PathLike, *_RESTLESS)):
        return [
            kind.__qualname__,
            str(value) if isinstance(value, PathLike) else getattr(value, "__name__", ""),
        ]
    own: list[Any] = [kind] if _is_users(kind.__module__) else []
    if dataclasses.is_dataclass(value):
        return [*own, *((it.name, getattr(value, it.name)) for it in dataclasses.fields(value))]
    if hasattr(kind, "__array__"):  # a data frame: columns that were looked at are in its state
        names = [np.asarray(getattr(value, name)) for name in ("columns", "index") if hasattr(value, name)]
        return [*own, kind.__qualname__, np.asarray(value), *names]
    if state := _state(value):
        return [*own, *state]
    if own:
        return [*own, ADDRESS.sub("", repr(value)) if "__repr__" in vars(kind) else ""]
    with contextlib.suppress(Exception):  # what has no such parts says so in many ways
        reduced = value.__reduce_ex__(2)
        if isinstance(reduced, tuple):
            return [kind.__qualname__, *(list(it) if isinstance(it, Iterator) else it for it in reduced[1:])]
    return []


def _state(value: Any) -> list[tuple[str, Any]]:
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


# --- what functions read ---


def _read_by(function: FunctionType) -> list[tuple[str, Any]]:
    """What counts of its module, and of others that are not installed, by name."""
    own, known = _module_of(function), function.__globals__
    found: dict[str, Any] = {}
    modules: list[tuple[str, ModuleType]] = []
    for name in _loaded(function.__code__):
        value = known.get(name)
        if isinstance(value, ModuleType):
            modules.append((name, value))
        elif name in known and _counts(value, own):
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
            elif _counts(value, own):
                found[f"{label}.{name}"] = value
    return sorted(found.items())


def _counts(value: Any, own: str) -> bool:
    """Whether it is known by more than its name: functions and classes that are not installed, and data."""
    if isinstance(value, FunctionType):
        return _is_own(_module_of(value), own)
    if isinstance(value, type):
        return _is_own(value.__module__, own)
    if isinstance(value, (ModuleType, BuiltinFunctionType, *_RESTLESS)):
        return False
    if _is_wrapper(value):
        return _counts(_wrapped(value), own)
    kind = type(value)
    if isinstance(value, _VALUES) or value is None or hasattr(kind, "__array__"):
        return True
    if _is_own(kind.__module__, own) or dataclasses.is_dataclass(value):
        return True
    state = _state(value)
    return bool(state) and all(it is None or callable(it) or isinstance(it, _VALUES) for _, it in state)


def _of_class(kind: type) -> list[tuple[str, Any]]:
    """What its text says, and that of those that it is made from."""
    found = []
    bases: list[type] = [*kind.__mro__, *inspect.getmro(type(kind))]
    for place, base in enumerate(bases):
        if not _is_users(base.__module__):
            continue
        for name, value in sorted(vars(base).items()):
            if name not in _MADE and (_is_written(value) or _counts(value, base.__module__)):
                found.append((f"{place}.{name}", value))
    return found


def _is_written(value: Any) -> bool:
    return isinstance(value, property | functools.partialmethod) or _is_wrapper(value)


def _module_of(function: FunctionType) -> str:
    """Where it is written: `__module__` of a wrapper is that of what it wraps."""
    return str(function.__globals__.get("__name__", function.__module__))


def _cells(function: FunctionType) -> list[Any]:
    return [_content(cell) for cell in function.__closure__ or ()]


@functools.cache
def _loaded(code: CodeType) -> list[str]:
    """Names that a function, and those inside of it, read as globals: attributes may have the same. What it
    writes to itself, as counters and what it remembers, is not read."""
    steps = [it for it in dis.get_instructions(code) if it.opname != "CACHE"]
    found = {it.argval for it in steps if it.opname in ("LOAD_GLOBAL", "LOAD_NAME")}
    written = {it.argval for it in steps if it.opname in ("STORE_GLOBAL", "DELETE_GLOBAL")}
    for what, key, store in zip(steps, steps[1:], steps[2:], strict=False):
        if store.opname == "STORE_SUBSCR" and key.opname.startswith("LOAD_") and what.opname == "LOAD_GLOBAL":
            written.add(what.argval)
    inner = [set(_loaded(it)) for it in code.co_consts if isinstance(it, CodeType)]
    return sorted(found.union(*inner) - written)


@functools.cache
def _imported(code: CodeType) -> list[str]:
    """Modules that it imports itself."""
    found = {it.argval for it in dis.get_instructions(code) if it.opname == "IMPORT_NAME"}
    return sorted(found.union(*(_imported(it) for it in code.co_consts if isinstance(it, CodeType))))


def _is_own(module: str, own: str) -> bool:
    return module == own or _is_users(module)


@functools.cache
def _is_users(module: str) -> bool:
    """Whether it is a script, or in a file that nobody has installed."""
    if module in ("__main__", "__mp_main__"):
        return True
    file = getattr(sys.modules.get(module), "__file__", None)
    if file is None or module.split(".")[0] == "linkwork":
        return False
    place = Path(file).resolve()
    standard = Path(sysconfig.get_path("stdlib")).resolve()
    return not place.is_relative_to(standard) and not {"site-packages", "dist-packages"} & set(place.parts)


def law(value: Any) -> str:
    """A text of a function that a model calls: its code, and the constants that it reads, also as globals of
    its module. What it may write to, such as a list of times at which it was called, does not count."""
    if isinstance(value, functools.partial):
        return " ".join(
            ["partial", law(value.func), *map(_constant, (value.args, sorted(value.keywords.items())))]
        )
    if isinstance(value, MethodType):
        return f"{law(value.__func__)} of {_law_of_object(value.__self__)}"
    parameters = getattr(type(value), "__dataclass_params__", None)
    if parameters is not None and parameters.frozen:
        return canonical(value)
    if not isinstance(value, FunctionType):
        return _law_of_object(value)
    return _law(value, frozenset())


def _law_of_object(value: Any) -> str:
    """Its class, and what its attributes hold of numbers and text: but for those that its methods write."""
    kind = type(value)
    name = str(getattr(value, "__qualname__", kind.__qualname__))
    if isinstance(value, type | ModuleType | BuiltinFunctionType):
        return name
    users = _is_users(kind.__module__)
    written = _written_by(kind) if users else set()
    held = [f"{name}={_constant(it)}" for name, it in _state(value) if name not in written]
    return " ".join([name, *([canonical(kind)] if users else []), *held])


def _written_by(kind: type) -> set[str]:
    """Attributes, by the methods other than those that make an object."""
    methods = [
        it.__wrapped__ if isinstance(it, staticmethod | classmethod) else it
        for base in kind.__mro__
        for name, it in vars(base).items()
        if name not in ("__init__", "__post_init__", "__new__", "__setstate__")
    ]
    return {
        step.argval
        for method in methods
        if isinstance(method, FunctionType)
        for step in dis.get_instructions(method)
        if step.opname in ("STORE_ATTR", "DELETE_ATTR")
    }


def _law(value: FunctionType, inside: frozenset[FunctionType]) -> str:
    if value in inside:
        return "itself"
    read = dict(zip(value.__code__.co_freevars, value.__closure__ or (), strict=True))
    found = {name: _content(cell) for name, cell in read.items()}
    found |= {name: value.__globals__[name] for name in _loaded(value.__code__) if name in value.__globals__}
    given = [value.__defaults__ or (), sorted((value.__kwdefaults__ or {}).items())]
    parts = [canonical(value.__code__), *map(_constant, given)]
    for name, it in sorted(found.items()):
        own = isinstance(it, FunctionType) and it.__module__ == value.__module__
        parts.append(f"{name}={_law(it, inside | {value}) if own else _constant(it)}")
    return " ".join(parts)


def _content(cell: CellType) -> Any:
    with contextlib.suppress(ValueError):  # there is nothing in it yet
        return cell.cell_contents
    return None


def _names(code: CodeType) -> set[str]:
    """That a function and those inside of it use."""
    inner = [it for it in code.co_consts if isinstance(it, CodeType)]
    return set(code.co_names).union(*map(_names, inner))


def _constant(value: Any) -> str:
    """Nothing of what is no number, text or array, or a tuple of them."""
    if isinstance(value, tuple):
        return f"({','.join(map(_constant, value))})"
    plain_one = isinstance(value, bool | int | float | complex | str | bytes | np.generic | np.ndarray)
    return canonical(value) if plain_one else type(value).__name__


def plain(value: Any) -> Any:
    """Numbers of Python in lists, as JSON has them; what is no number or array stays."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    return [plain(part) for part in value] if isinstance(value, list | tuple) else value
