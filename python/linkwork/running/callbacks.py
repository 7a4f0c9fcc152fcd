"""Whether functions of the user's own remember something from one call to the next.

Nobody says so; but what a function can remember is what it reaches: variables of the functions around it,
global ones, defaults, the attributes of its object. Their contents before and after a run tell. What compiled
functions remember behind an address nobody sees.
"""

from __future__ import annotations

import builtins
import functools
import hashlib
import pickle
import types
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

__all__ = ["changed", "contents", "of_model", "is_stateless"]

#: What cannot be looked into counts as changed.
UNKNOWN = b""

#: Not looked into: they are not where a function of the user's keeps numbers.
_OPAQUE = (types.ModuleType, type, types.BuiltinFunctionType, np.ufunc)
_COMPILED = ("ctypes", "_ctypes", "_cffi_backend", "numba")


def of_model(model: Model) -> dict[str, Any]:
    """The functions that the model calls, by the name of what they belong to."""
    return dict([*model.user_forces, *model.signals])


def contents(functions: Mapping[str, Any]) -> dict[str, bytes]:
    """A digest of all that each of them reaches."""
    return {name: _digest(function) for name, function in functions.items()}


def changed(before: Mapping[str, bytes], functions: Mapping[str, Any]) -> list[str]:
    """Those that reach something else than `before`, or what cannot be looked into."""
    return [name for name, now in contents(functions).items() if now in (UNKNOWN,) or now != before[name]]


def _digest(function: Any) -> bytes:
    digest, seen, todo = hashlib.blake2b(digest_size=16), set[int](), [function]
    call = vars(type(function)).get("__call__")
    if isinstance(call, types.FunctionType):  # of an object
        todo.append(call)
    while todo:
        it = todo.pop()
        if _opaque(it):
            continue
        inside = _inside(it)
        try:
            if inside is None:
                digest.update(pickle.dumps(it))
                continue
        except Exception:  # whatever an object of the user's raises
            inside = _parts(it)
            if inside is None:
                return UNKNOWN
        if id(it) not in seen:
            seen.add(id(it))
            todo += inside
    return digest.digest()


#: What cannot change; arrays can, but functions keep tables in them.
_CONSTANT = (type(None), bool, int, float, complex, str, bytes, np.generic, np.ndarray)


def is_stateless(function: Any) -> bool:
    """Whether all that a function reaches is constant, so that a call more or less makes no difference."""
    seen, todo = set[int](), [function]
    while todo:
        it = todo.pop()
        if id(it) in seen or isinstance(it, _CONSTANT) or (_opaque(it) and not _chance(it)):
            continue
        seen.add(id(it))
        inside = list(it) if isinstance(it, tuple | frozenset) else _inside(it)
        if inside is None or isinstance(it, types.MethodType):
            return False
        todo += inside
    return not any(isinstance(it, types.FunctionType) and "random" in " ".join(_names(it.__code__))
                   for it in [function])  # fmt: skip


def _chance(it: Any) -> bool:
    """Random numbers have a state of their own."""
    name = getattr(it, "__name__", "")
    return "random" in f"{getattr(it, '__module__', '')} {name if isinstance(it, types.ModuleType) else ''}"


def _opaque(it: Any) -> bool:
    """What keeps no numbers of the user's: modules, classes, compiled functions, parts of a model."""
    package, _, rest = type(it).__module__.partition(".")
    return (
        isinstance(it, _OPAQUE)
        or package in _COMPILED
        or (package == "linkwork" and not rest.startswith("functions"))
    )


def _inside(it: Any) -> list[Any] | None:
    """What a function reaches; None: it is something else."""
    if isinstance(it, types.FunctionType):
        return list(_reached(it))
    if isinstance(it, types.MethodType):
        return [it.__func__, it.__self__]
    if isinstance(it, functools.partial):
        return [it.func, *it.args, *it.keywords.values()]
    return None


def _parts(it: Any) -> list[Any] | None:
    """Of an object that cannot be pickled as a whole."""
    if isinstance(it, dict):
        return [*it.keys(), *it.values()]
    if isinstance(it, list | tuple | set | frozenset):
        return list(it)
    return list(vars(it).values()) if hasattr(it, "__dict__") else None


def _reached(function: types.FunctionType) -> Iterator[Any]:
    yield from function.__defaults__ or ()
    yield from (function.__kwdefaults__ or {}).values()
    yield from _cells(function)
    for name in _names(function.__code__):
        if name in function.__globals__ and not hasattr(builtins, name):
            yield function.__globals__[name]


def _cells(function: types.FunctionType) -> Iterator[Any]:
    for cell in function.__closure__ or ():
        try:
            yield cell.cell_contents
        except ValueError:  # nothing in it yet
            continue


def _names(code: types.CodeType) -> Iterator[str]:
    """Of globals and attributes, also of the functions inside."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _names(constant)
