"""Values as texts with every bit of them, and hashes of these."""

from __future__ import annotations

import collections
import contextlib
import contextvars
import ctypes
import dataclasses
import functools
import hashlib
import re
import secrets
import sys
import weakref
from collections.abc import Iterator, Mapping, Sequence, Set
from enum import Enum
from os import PathLike
from types import CodeType, FunctionType, MethodType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from linkwork.errors import LinkworkError, OptionError
from linkwork.fingerprints import codes, numbers
from linkwork.fingerprints.memory import Calls, first_look
from linkwork.fingerprints.origins import is_users, is_users_class, made_from
from linkwork.fingerprints.reading import (
    DATA,
    RESTLESS,
    attached,
    attributes,
    bare,
    cells,
    is_wrapper,
    kept_by_pickle,
    of_class,
    of_module,
    read_by,
    shown,
    wrapped,
)

__all__ = ["Writer", "canonical", "digest", "digests", "shortened", "text_of", "together"]

#: Where an object is in memory, which says nothing about it.
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")

#: What cannot be looked at says something in this process alone.
_HERE = secrets.token_hex(8)

#: Of numbers and texts alone, these are tables. Texts of those that values have which are written together,
#: by their place in memory, with them, so that it stays theirs.
_CONTAINERS = (list, tuple, dict, set, frozenset)
_SHARED: contextvars.ContextVar[dict[int, tuple[Any, str]] | None]
_SHARED = contextvars.ContextVar("shared", default=None)

#: Calls within each other.
DEEPEST = 200_000

_BARE = frozenset(DATA)

#: Written by their texts alone.
_SHORT = frozenset((float, int, bool, bytes, str, type(None), type(Ellipsis)))

#: Numbers, arrays and structures of ctypes.
_FROM_C: type = ctypes._SimpleCData.__mro__[1]

#: Compiled by these, a function goes on with the global values that it began with.
_FREEZING = ("numba.core", "numba.np")

#: Characters of a text that is written out where it is part of another.
LONG = 4000


def digest(*values: Any) -> str:
    """32 hexadecimal digits. OptionError: lists in lists, too many of them."""
    return _hashed(canonical(values))


def _hashed(text: str) -> str:
    return hashlib.blake2b(text.encode(errors="surrogatepass"), digest_size=16).hexdigest()


def shortened(text: str) -> str:
    return text if len(text) <= LONG else _hashed(text)


def digests(head: str, columns: Mapping[str, Sequence[Any]]) -> list[str]:
    """digest(head, {name: value}) of each row of columns of equal length."""
    names = sorted(columns, key=lambda name: f"tuple({name!r},")
    if not all(type(value) is float for values in columns.values() for value in values):
        rows = zip(*columns.values(), strict=True)
        return [digest(head, dict(zip(columns, row, strict=True))) for row in rows]
    start, inner = f"tuple({head!r},", [f"tuple({name!r}," for name in names]
    texts = (
        "dict(" + ",".join(f"{text}{it.hex()})" for text, it in zip(inner, row, strict=True)) + ")"
        for row in zip(*(columns[name] for name in names), strict=True)
    )
    return [_hashed(shortened(f"{start}{shortened(text)})")) for text in texts]


def canonical(value: Any) -> str:
    """A text with every bit of the value and its type: with a list for a tuple, or an array, functions may do
    something else. Functions count by their code, defaults, closures, and by the data, functions and
    classes that they read of their own module and others that are not installed; objects by their attributes,
    and by their classes where these are not installed, or by their `__fingerprint__`."""
    return text_of(value, Writer)


@contextlib.contextmanager
def together() -> Iterator[None]:
    """While values are written that share tables, which nothing changes meanwhile: each table once."""
    shared = _SHARED.get()
    before = _SHARED.set({} if shared is None else shared)
    try:
        yield
    finally:
        _SHARED.reset(before)


def text_of(value: Any, writer: type[Writer]) -> str:
    """OptionError: lists in lists, too many of them."""
    try:
        return writer(value).text(value)
    except RecursionError:  # a chain of objects that is long, or for ever
        return _text_of_chain(value, writer)


def _text_of_chain(value: Any, writer: type[Writer]) -> str:
    usual = sys.getrecursionlimit()
    sys.setrecursionlimit(max(usual, DEEPEST))
    try:
        return writer(value).text(value)
    except RecursionError as error:
        raise OptionError(
            f"a value ({type(value).__name__}) is nested more than {DEEPEST // 4} deep: it cannot be told "
            "from others; give something that is flatter",
            code="parameters",
        ) from error
    finally:
        sys.setrecursionlimit(usual)


class Writer:
    """Writes each object once, however many ways lead to it."""

    def __init__(self, root: Any) -> None:
        # by the place in memory, which is an object's own as long as it stays: so it does
        self._known: dict[int, tuple[Any, str]] = {}
        self._inside: set[int] = set()
        self._root = root
        shared = _SHARED.get()
        self._tables = {} if shared is None else shared
        self._others = 0  # texts so far of what is no table, which may depend on the root

    def text(self, value: Any) -> str:
        if type(value) is float:  # what most are
            return value.hex()
        if type(value) is str:
            return shortened(repr(value))
        try:
            return self._text(value)
        except (RecursionError, MemoryError, LinkworkError):
            raise
        except Exception:  # whatever an object of the user's raises: in this process it is the one that it is
            return f"{type(value).__qualname__} {_HERE} {id(value)}"

    def _text(self, value: Any) -> str:
        if id(value) in self._tables:
            return self._tables[id(value)][1]
        given = value
        if not (_is_of_a_class(value) or isinstance(value, Enum)):
            if isinstance(value, np.ndarray):
                value = numbers.of_array(value)
            elif isinstance(value, np.generic):
                value = numbers.of_scalar(value)
                if isinstance(value, str):
                    return shortened(value)
            elif (told := _short(value)) is not None:
                return shortened(told if type(value) in _SHORT else f"{type(value).__qualname__} {told}")
        if id(value) in self._known or id(value) in self._inside:
            self._others += 1
            return self._known[id(value)][1] if id(value) in self._known else "itself"
        self._inside.add(id(value))
        before = self._others
        try:
            found = shortened(self._written(value))
        finally:
            self._inside.discard(id(value))
        is_table = isinstance(value, _CONTAINERS) and self._others == before
        self._others += not is_table
        (self._tables if is_table else self._known)[id(given)] = given, found
        return found

    def _written(self, value: Any) -> str:
        parts = [self.text(part) for part in self.parts(value)]
        if isinstance(value, Set | Mapping):
            parts.sort()
        kind = type(value).__name__
        return f"{kind}({','.join(parts)})" if parts else ADDRESS.sub("", f"{kind} {value!r}")

    def parts(self, value: Any) -> list[Any]:
        """What it is made of; none where its own text says that."""
        if type(value) is list or type(value) is tuple:  # what most others are
            return numbers.of_list(value) or list(value)
        if _is_of_a_class(value):
            return [type(value), bare(value), *self._held(value)]
        if isinstance(value, FunctionType):
            return [value.__qualname__, *self.of_function(value)]
        if isinstance(value, _FROM_C) and not isinstance(value, ctypes._CFuncPtr):  # type: ignore[attr-defined]
            return [type(value), *_parts_of_c(value)]
        if isinstance(value, memoryview):
            return [value.format, value.shape, value.tobytes()]
        if isinstance(value, RESTLESS):
            return [type(value), getattr(value, "__name__", "")]
        if type(value) is SimpleNamespace:
            return ["namespace", *self._held(value)]
        if isinstance(value, type) and is_users_class(value):
            return [value.__qualname__, *self._first(value, of_class(value), self._calls.changes(value))]
        if is_users_class(type(value)) and not isinstance(value, type | Enum | property):
            return self._of_users_object(value)
        if (made := made_from(value)) is None:
            return _parts(value)
        if not type(value).__module__.startswith(_FREEZING):
            return [type(value).__qualname__, *made]
        return [type(value).__qualname__, first_look(value, (type(self),), lambda: self.text(made))]

    def of_function(self, function: FunctionType) -> list[Any]:
        """All but its name."""
        read, kept = cells(function)
        first = [first_look(function, (type(self),), lambda: self.text(kept))] if kept else []
        given = function.__defaults__, function.__kwdefaults__
        return [function.__code__, *given, read, *first, *read_by(function), *attached(function)]

    def _of_users_object(self, value: Any) -> list[Any]:
        kind = type(value)
        if hasattr(kind, "__fingerprint__"):
            return [kind.__qualname__, value.__fingerprint__()]
        made = [it for it in kind.__mro__ if not is_users_class(it)]
        found = [*self._held(value), *(shown(value) or kept_by_pickle(value, made))]
        return [kind, *found] if found else [kind, _shown_as(value)]

    def _held(self, value: Any) -> list[Any]:
        kind, held = type(value), attributes(value)
        if not is_users_class(kind) and kind is not SimpleNamespace:
            return list(held)
        return self._first(value, held, self._calls.changes(kind))

    def _first(self, owner: Any, held: list[tuple[str, Any]], changes: codes.Changes) -> list[Any]:
        """Attributes; those that calls change as they were when they were first looked at."""
        if not changes:
            return list(held)
        kept = [(name, it) for name, it in held if codes.is_changed(name, it, changes)]
        names = {name for name, _ in kept}
        first = first_look(owner, (type(self), changes), lambda: self.text(kept))
        return [*(it for it in held if it[0] not in names), first]

    @functools.cached_property
    def _calls(self) -> Calls:
        return Calls(self._root)


def _is_of_a_class(value: Any) -> bool:
    """Data that have attributes beside them, or are of a class that nobody has installed."""
    kind = type(value)
    if kind in _BARE or not isinstance(value, DATA) or isinstance(value, Enum):
        return False
    return is_users_class(kind) or (kind.__module__.split(".")[0] != "numpy" and bool(attributes(value)))


def _short(value: Any) -> str | None:
    """Of data without parts; None: it has some."""
    if isinstance(value, float):
        return float(value).hex()
    if value is None or isinstance(value, bool | bytes | str) or value is Ellipsis:
        return repr(value)
    if isinstance(value, int):
        return repr(int(value)) if abs(value) < 2**64 else hex(value)
    return None


def _parts_of_c(value: Any) -> list[Any]:
    """Of a value of C. Pointers say what they were made from; of others nobody knows where they point to."""
    if isinstance(value, ctypes.c_char_p | ctypes.c_wchar_p):
        return [value.value]
    if isinstance(value, ctypes._Pointer) and value._objects:
        return [value._objects]
    return [ctypes.string_at(ctypes.addressof(value), ctypes.sizeof(value))]


def _shown_as(value: Any) -> str:
    return ADDRESS.sub("", repr(value)) if "__repr__" in vars(type(value)) else ""


def _parts(value: Any) -> list[Any]:
    """Of what is no function and of no class of the user's."""
    if isinstance(value, list | tuple | Set | collections.deque):
        return list(value)
    if type(value).__module__.startswith("xarray."):
        return [type(value).__qualname__, value.to_dict(data="array")]
    if isinstance(value, Mapping):
        return [
            *value.items(),
            *([value.default_factory] if isinstance(value, collections.defaultdict) else []),
        ]
    if isinstance(value, CodeType):
        return _parts_of_code(value)
    if isinstance(value, MethodType):
        return [value.__func__, value.__self__]
    if isinstance(value, functools.partial | functools.partialmethod):
        return [value.func, value.args, value.keywords]
    if isinstance(value, Enum):
        own = [type(value)] if is_users_class(type(value)) else []
        return [*own, value.name, value.value, *attributes(value)]
    if isinstance(value, property):
        return [value.fget, value.fset, value.fdel]
    if is_wrapper(value):
        return [wrapped(value)]
    if isinstance(value, type):
        return [value.__qualname__, ("module", value.__module__)]
    if isinstance(value, weakref.ref):
        return [value()]
    if isinstance(value, slice):
        return ["slice", value.start, value.stop, value.step]
    if isinstance(value, ModuleType):
        return [value.__name__, *(of_module(value) if is_users(value.__name__) else ())]
    return _parts_of_object(value)


def _parts_of_code(code: CodeType) -> list[Any]:
    """All but names and places in files. An argument with a star has the code of one without."""
    counted = code.co_argcount, code.co_posonlyargcount, code.co_kwonlyargcount, code.co_flags
    variables = code.co_varnames, code.co_cellvars, code.co_freevars
    return [code.co_code, code.co_consts, code.co_names, *variables, counted, code.co_exceptiontable]


def _parts_of_object(value: Any) -> list[Any]:
    """Of a class that somebody has installed."""
    kind = type(value)
    if isinstance(value, PathLike):
        return [kind.__qualname__, str(value)]
    if hasattr(kind, "__fingerprint__"):
        return [kind.__qualname__, value.__fingerprint__()]
    if dataclasses.is_dataclass(value):
        return [kind.__qualname__, *((it.name, getattr(value, it.name)) for it in dataclasses.fields(value))]
    if hasattr(value, "_eval_args") and hasattr(value, "ext"):  # a spline of FITPACK: beside it are leavings
        return [kind.__qualname__, value._eval_args, value.ext]
    if hasattr(kind, "__array__"):  # a data frame: columns that were looked at are in its state
        names = [np.asarray(getattr(value, name)) for name in ("columns", "index") if hasattr(value, name)]
        types = [str(it) for it in np.ravel(np.asarray(getattr(value, "dtypes", []), dtype=object))]
        return [kind.__qualname__, np.asarray(value), types, *(names or attributes(value))]
    if told := shown(value) or kept_by_pickle(value, kind.__mro__) or attributes(value):
        return [kind.__qualname__, *told]
    with contextlib.suppress(Exception):  # what has no such parts says so in many ways
        reduced = value.__reduce_ex__(2)
        if isinstance(reduced, tuple):
            return [kind.__qualname__, *reduced[1:]]
    return []
