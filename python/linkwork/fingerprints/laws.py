"""Texts of the functions that a model calls."""

from __future__ import annotations

import dis
import functools
from types import BuiltinFunctionType, CodeType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from linkwork.fingerprints.reading import attributes, content, is_users, loaded
from linkwork.fingerprints.writing import canonical

__all__ = ["law"]


def law(value: Any) -> str:
    """A text of a function that a model calls: its code, and the constants that it reads, also as globals of
    its module. What it may write to, such as a list of times at which it was called, does not count."""
    if isinstance(value, functools.partial):
        given = value.args, tuple(sorted(value.keywords.items()))
        return " ".join(["partial", law(value.func), *map(_constant, given)])
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
    users = is_users(kind.__module__)
    written = _written_by(kind) if users else set()
    held = [f"{name}={_constant(it)}" for name, it in attributes(value) if name not in written]
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
    written = _written_cells(value.__code__)
    found = {name: content(cell) for name, cell in read.items() if name not in written}
    found |= {name: value.__globals__[name] for name in loaded(value.__code__) if name in value.__globals__}
    given = value.__defaults__ or (), tuple(sorted((value.__kwdefaults__ or {}).items()))
    parts = [canonical(value.__code__), *map(_constant, given)]
    for name, it in sorted(found.items()):
        own = isinstance(it, FunctionType) and it.__module__ == value.__module__
        parts.append(f"{name}={_law(it, inside | {value}) if own else _constant(it)}")
    return " ".join(parts)


@functools.cache
def _written_cells(code: CodeType) -> set[str]:
    """Variables from around a function to which it, or one inside of it, writes, as counters."""
    own = {
        step.argval for step in dis.get_instructions(code) if step.opname in ("STORE_DEREF", "DELETE_DEREF")
    }
    return own.union(*(_written_cells(it) for it in code.co_consts if isinstance(it, CodeType)))


def _constant(value: Any) -> str:
    """Nothing of what is no number, text or array, or a tuple of them."""
    if isinstance(value, tuple):
        return f"({','.join(map(_constant, value))})"
    plain_one = isinstance(value, bool | int | float | complex | str | bytes | np.generic | np.ndarray)
    return canonical(value) if plain_one else type(value).__name__
