"""Texts of the functions that a model calls."""

from __future__ import annotations

import collections
import functools
from collections.abc import Mapping, Set
from types import BuiltinFunctionType, CodeType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from linkwork.fingerprints.origins import is_users, made_from
from linkwork.fingerprints.reading import (
    RESTLESS,
    attributes,
    attributes_changed,
    cells,
    counts,
    is_wrapper,
    module_of,
    read_by,
    wrapped,
)
from linkwork.fingerprints.writing import canonical, shortened

__all__ = ["law"]

#: Numbers and text; functions keep tables in arrays.
_PLAIN = (bool, int, float, complex, str, bytes, np.generic, np.ndarray)

#: Objects and containers within each other that are looked into.
_DEEPEST = 5


def law(value: Any) -> str:
    """A text of a function that a model calls: its code, and what it reads from around it, of its module and
    of others that nobody has installed. What it may write to, such as a list of times at which it was called,
    does not count; models and results do by their kind alone."""
    return _Law().text(value)


class _Law:
    """Writes each object once: functions of a module may use each other."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[Any, str]] = {}
        self._inside: set[int] = set()

    def text(self, value: Any, depth: int = 0) -> str:
        if value is None or isinstance(value, _PLAIN):
            return canonical(value)
        if id(value) in self._inside:
            return "itself"
        if id(value) in self._known:
            return self._known[id(value)][1]
        if depth > _DEEPEST:
            return type(value).__name__
        self._inside.add(id(value))
        found = shortened(self._written(value, depth))
        self._inside.discard(id(value))
        self._known[id(value)] = value, found
        return found

    def _written(self, value: Any, depth: int) -> str:
        def texts(parts: Any) -> list[str]:
            return [self.text(it, depth + 1) for it in parts]

        if isinstance(value, FunctionType):
            return self._of_function(value, depth)
        if isinstance(value, functools.partial):
            return " ".join(["partial", *texts((value.func, value.args, sorted(value.keywords.items())))])
        if isinstance(value, MethodType):
            return " of ".join(texts((value.__func__, value.__self__)))
        if isinstance(value, Mapping):
            return f"{type(value).__name__}{sorted(texts(value.items()))}"
        if isinstance(value, Set):
            return f"set{sorted(texts(value))}"
        if isinstance(value, tuple | list | collections.deque):
            return f"({','.join(texts(value))})"
        if is_wrapper(value):
            return self.text(wrapped(value), depth)
        if (made := made_from(value)) is not None:
            return " ".join([type(value).__qualname__, *texts(made)])
        return self._of_object(value, depth)

    def _of_function(self, function: FunctionType, depth: int) -> str:
        own = module_of(function)
        found = [(name, it) for name, it in cells(function) if counts(it, own)] + read_by(function)
        given = function.__defaults__ or (), tuple(sorted((function.__kwdefaults__ or {}).items()))
        parts = [*map(self.text, given), *(f"{name}={self.text(it, depth)}" for name, it in found)]
        return " ".join([canonical(function.__code__), *parts])

    def _of_object(self, value: Any, depth: int) -> str:
        """Its class, and what its attributes hold: but for those that its methods change."""
        kind = type(value)
        if isinstance(value, type):
            return canonical(value)
        if isinstance(value, (ModuleType, BuiltinFunctionType, *RESTLESS)) or _is_ours(kind):
            told = (
                value.fingerprint() if hasattr(value, "fingerprint") else getattr(value, "__qualname__", "")
            )
            return f"{kind.__qualname__} {told!r}"
        parameters = getattr(kind, "__dataclass_params__", None)
        if parameters is not None and parameters.frozen:
            return canonical(value)
        users = is_users(kind.__module__)
        changed = frozenset[str]().union(*map(attributes_changed, _codes_of(kind) if users else ()))
        held = [f"{name}={self.text(it, depth + 1)}" for name, it in attributes(value) if name not in changed]
        return " ".join([kind.__qualname__, *([canonical(kind)] if users else []), *held])


def _is_ours(kind: type) -> bool:
    return kind.__module__.partition(".")[0] == "linkwork"


def _codes_of(kind: type) -> list[CodeType]:
    """Of its methods other than those that make an object."""
    methods = [
        it.__wrapped__ if isinstance(it, staticmethod | classmethod) else it
        for base in kind.__mro__
        for name, it in vars(base).items()
        if name not in ("__init__", "__post_init__", "__new__", "__setstate__")
    ]
    return [it.__code__ for it in methods if isinstance(it, FunctionType)]
