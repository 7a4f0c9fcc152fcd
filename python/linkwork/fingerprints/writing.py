"""Values as texts with every bit of them, and hashes of these."""

from __future__ import annotations

import collections
import contextlib
import dataclasses
import functools
import hashlib
import re
import sys
from collections.abc import Iterator, Mapping, Sequence, Set
from enum import Enum
from os import PathLike
from types import CodeType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from linkwork.errors import OptionError
from linkwork.fingerprints.origins import is_users, made_from
from linkwork.fingerprints.reading import (
    RESTLESS,
    attached,
    attributes,
    bare,
    beside,
    cells,
    is_wrapper,
    of_class,
    read_by,
    shown,
    wrapped,
)

__all__ = ["canonical", "digest", "digests", "plain", "shortened"]

#: Where an object is in memory, which says nothing about it.
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")

#: Calls within each other.
DEEPEST = 200_000

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
    names = sorted(columns, key=lambda name: f"list({name!r},")
    if not all(type(value) is float for values in columns.values() for value in values):
        rows = zip(*columns.values(), strict=True)
        return [digest(head, dict(zip(columns, row, strict=True))) for row in rows]
    start, inner = f"list({head!r},", [f"list({name!r}," for name in names]
    texts = (
        "dict(" + ",".join(f"{text}{it.hex()})" for text, it in zip(inner, row, strict=True)) + ")"
        for row in zip(*(columns[name] for name in names), strict=True)
    )
    return [_hashed(shortened(f"{start}{shortened(text)})")) for text in texts]


def canonical(value: Any) -> str:
    """A text with every bit of the value. Functions count by their code, defaults, closures, and by the data,
    functions and classes that they read of their own module and others that are not installed; objects by
    their attributes, and by their classes where these are not installed, or by their `__fingerprint__`."""
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
            return shortened(repr(value))
        if not beside(value):
            if isinstance(value, np.generic | np.ndarray):
                value = _told(value)
            if isinstance(value, float):
                return float(value).hex()
            if value is None or isinstance(value, bool | bytes | str) or value is Ellipsis:
                return shortened(repr(value))
            if isinstance(value, int) and not isinstance(value, Enum):
                return repr(int(value)) if abs(value) < 2**64 else hex(value)
        if id(value) in self._known:
            return self._known[id(value)][1]
        if id(value) in self._inside:
            return "itself"
        self._inside.add(id(value))
        found = shortened(self._written(value))
        self._inside.discard(id(value))
        self._known[id(value)] = value, found
        return found

    def _written(self, value: Any) -> str:
        parts = [self.text(part) for part in _parts(value)]
        if isinstance(value, Set | Mapping):
            parts.sort()
        kind = "list" if isinstance(value, list | tuple) else type(value).__name__
        return f"{kind}({','.join(parts)})" if parts else ADDRESS.sub("", f"{kind} {value!r}")


def _told(value: Any) -> Any:
    """What NumPy holds, as numbers of Python; beside its type where these do not say all of it."""
    if value.dtype.names:
        return ["fields", *((name, value[name]) for name in value.dtype.names)]
    if value.dtype.kind in "mM":  # in some units they are objects of Python, in others counts without unit
        return [value.dtype.str, value.astype(np.int64)]
    told = value.tolist()
    if not isinstance(told, np.generic):
        return told
    if not isinstance(told, np.longdouble | np.clongdouble):
        return [told.dtype.str, repr(told)]
    return [told.dtype.str, *(np.format_float_scientific(part) for part in (told.real, told.imag))]


def _parts(value: Any) -> list[Any]:
    """What it is made of; none where its own text says that."""
    if held := beside(value):
        return [type(value), bare(value), *held]
    if isinstance(value, list | tuple | Set | collections.deque):
        return list(value)
    if isinstance(value, Mapping):
        return [*value.items()]
    if isinstance(value, FunctionType):
        parts = [value.__qualname__, value.__code__, value.__defaults__, value.__kwdefaults__, cells(value)]
        return [*parts, *read_by(value), *attached(value)]
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
    if is_wrapper(value):
        return [wrapped(value)]
    if isinstance(value, type):
        content = of_class(value) if is_users(value.__module__) else [("module", value.__module__)]
        return [value.__qualname__, *content]
    if isinstance(value, slice):
        return ["slice", value.start, value.stop, value.step]
    if (made := made_from(value)) is not None:
        return [type(value).__qualname__, *made]
    return _parts_of_object(value)


def _parts_of_object(value: Any) -> list[Any]:
    kind = type(value)
    if isinstance(value, (ModuleType, PathLike, *RESTLESS)):
        return [
            kind.__qualname__,
            str(value) if isinstance(value, PathLike) else getattr(value, "__name__", ""),
        ]
    if hasattr(kind, "__fingerprint__"):
        return [kind.__qualname__, value.__fingerprint__()]
    own: list[Any] = [kind] if is_users(kind.__module__) else []
    if dataclasses.is_dataclass(value):
        return [*own, *((it.name, getattr(value, it.name)) for it in dataclasses.fields(value))]
    if hasattr(kind, "__array__"):  # a data frame: columns that were looked at are in its state
        names = [np.asarray(getattr(value, name)) for name in ("columns", "index") if hasattr(value, name)]
        return [*own, kind.__qualname__, np.asarray(value), *names]
    seen, held = shown(value), attributes(value)
    if seen or held:
        return [*own, *seen, *(held if own or not seen else ())]
    if own:
        return [*own, ADDRESS.sub("", repr(value)) if "__repr__" in vars(kind) else ""]
    with contextlib.suppress(Exception):  # what has no such parts says so in many ways
        reduced = value.__reduce_ex__(2)
        if isinstance(reduced, tuple):
            return [kind.__qualname__, *(list(it) if isinstance(it, Iterator) else it for it in reduced[1:])]
    return []


def plain(value: Any) -> Any:
    """Numbers of Python in lists, as JSON has them; what is no number or array stays."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    return [plain(part) for part in value] if isinstance(value, list | tuple) else value
