"""Content hashes of models and studies: equal for equal values, in any process, on any machine."""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import hashlib
import re
import sys
from collections.abc import Iterator, Mapping, Sequence, Set
from os import PathLike
from pathlib import Path
from types import CellType, CodeType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

__all__ = ["canonical", "digest", "digests", "law", "plain"]

#: Data, whose every bit counts.
_DATA = (bool, int, float, complex, str, bytes, list, tuple, dict, set, frozenset, np.generic, np.ndarray)

#: Where an object is in memory, which says nothing about it.
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")


def digest(*values: Any) -> str:
    """32 hexadecimal digits."""
    return _hashed(canonical(values))


def _hashed(text: str) -> str:
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()


def digests(head: str, columns: Mapping[str, Sequence[Any]]) -> list[str]:
    """digest(head, {name: value}) of each row of columns of equal length."""
    names = sorted(columns, key=lambda name: f"list({name!r},")
    if not all(type(value) is float for values in columns.values() for value in values):
        rows = zip(*columns.values(), strict=True)
        return [digest(head, dict(zip(columns, row, strict=True))) for row in rows]
    start, inner = f"list({head!r},dict(", [f"list({name!r}," for name in names]
    return [
        _hashed(start + ",".join(f"{text}{it.hex()})" for text, it in zip(inner, row, strict=True)) + "))")
        for row in zip(*(columns[name] for name in names), strict=True)
    ]


def canonical(value: Any, inside: frozenset[int] = frozenset()) -> str:
    """A text with every bit of the value. Functions count by their code, defaults, closures, and by the data,
    functions and classes that they read of their own module and others that are not installed; objects by
    their attributes."""
    if type(value) is float:  # what most are
        return value.hex()
    if type(value) is str:
        return repr(value)
    if isinstance(value, np.generic | np.ndarray):
        value = value.tolist()
    if isinstance(value, float):
        return value.hex()
    if value is None or isinstance(value, bool | int | str | bytes):
        return repr(value)
    if id(value) in inside:
        return "itself"
    below = inside | {id(value)}
    parts = [canonical(part, below) for part in _parts(value)]
    if isinstance(value, Set | Mapping):
        parts.sort()
    kind = "list" if isinstance(value, list | tuple) else type(value).__name__
    return f"{kind}({','.join(parts)})" if parts else ADDRESS.sub("", f"{kind} {value!r}")


def _read_by(function: FunctionType) -> list[tuple[str, Any]]:
    """What a function reads of its module and of others that are not installed, itself or by functions and
    classes of these, each once: their code, data, objects of their classes, data classes, and others that
    hold nothing but data."""
    own, found = function.__module__, dict[str, Any]()
    seen, todo = {id(function)}, [function]
    while todo:
        for label, value in _reads(todo.pop(), function, own):
            if label in found:
                continue
            kind = value if isinstance(value, type) else type(value)
            parts = [("", value)] if isinstance(value, FunctionType) else []
            if _is_own(kind.__module__, own):
                parts = _of_class(kind, own)
            for name, it in parts:
                if isinstance(it, FunctionType) and _is_own(it.__module__, own):
                    inner = [
                        cell for cell in _cells(it) if isinstance(cell, FunctionType)
                    ]  # what is decorated
                    found[label + name] = _code_and_data(it, inner)
                    todo += [other for other in (it, *inner) if id(other) not in seen]
                    seen.update(map(id, (it, *inner)))
                elif name:
                    found[label + name] = it
            if _counts(value, own):
                found[label] = value
    return sorted(found.items())


def _reads(it: FunctionType, first: FunctionType, own: str) -> Iterator[tuple[str, Any]]:
    """Names of the module, and of other modules by these: "FACTOR", "helpers.FACTOR"."""
    names, known = sorted(_names(it.__code__)), it.__globals__
    lead = "" if known is first.__globals__ else f"{it.__module__}."
    for name in names:
        value = known.get(name)
        if not isinstance(value, ModuleType):
            if name in known:
                yield lead + name, value
        elif _is_own(value.__name__, own):
            inside = vars(value)
            yield from ((f"{value.__name__}.{inner}", inside[inner]) for inner in names if inner in inside)


def _of_class(kind: type, own: str) -> list[tuple[str, Any]]:
    """Functions and data of a class, and of those that it is made from."""
    found = []
    for base in kind.__mro__:
        for name, value in vars(base).items() if _is_own(base.__module__, own) else ():
            for attribute in ("__func__", "fget", "func"):  # of a class, a property, a cached one
                value = getattr(value, attribute, value)
            if isinstance(value, FunctionType) or (isinstance(value, _DATA) and not name.startswith("_")):
                found.append((f":{base.__name__}.{name}", value))
    return found


def _code_and_data(function: FunctionType, inner: Sequence[FunctionType]) -> list[Any]:
    given = [function.__defaults__, function.__kwdefaults__]
    data = [cell for cell in _cells(function) if isinstance(cell, _DATA)]
    return [*(it.__code__ for it in (function, *inner)), *given, *data]


def _cells(function: FunctionType) -> list[Any]:
    return [_content(cell) for cell in function.__closure__ or ()]


def _is_own(module: str, own: str) -> bool:
    return module == own or _is_users(module)


@functools.cache
def _is_users(module: str) -> bool:
    """Whether it is a script, or in a file that nobody has installed."""
    file = getattr(sys.modules.get(module), "__file__", None)
    if module in ("__main__", "__mp_main__"):
        return True
    if file is None or module.split(".")[0] in ("linkwork", *sys.stdlib_module_names):
        return False
    return not {"site-packages", "dist-packages"} & set(Path(file).parts)


def _counts(value: Any, own: str) -> bool:
    if isinstance(value, type | FunctionType):
        return False
    known = isinstance(value, (*_DATA, functools.partial, MethodType))
    if known or _is_own(type(value).__module__, own) or dataclasses.is_dataclass(value):
        return True
    state = _state(value)
    return bool(state) and all(it is None or callable(it) or isinstance(it, _DATA) for _, it in state)


def _state(value: Any) -> list[tuple[str, Any]]:
    """Attributes of an object of a class written in Python."""
    if isinstance(value, type | ModuleType | PathLike):  # paths have caches, and say all
        return []
    slots = [getattr(base, "__slots__", ()) for base in type(value).__mro__]
    names = {name for it in slots for name in ((it,) if isinstance(it, str) else it)}
    found = {name: getattr(value, name) for name in names if hasattr(value, name)}
    return sorted((found | getattr(value, "__dict__", {})).items())


def law(value: Any) -> str:
    """A text of a function that a model calls: its code, and the constants that it reads, also as globals of
    its module. What it may write to, such as a list of times at which it was called, does not count."""
    if isinstance(value, functools.partial):
        return " ".join(
            ["partial", law(value.func), *map(_constant, (value.args, sorted(value.keywords.items())))]
        )
    if isinstance(value, MethodType):
        return f"{law(value.__func__)} of {type(value.__self__).__qualname__}"
    parameters = getattr(type(value), "__dataclass_params__", None)
    if parameters is not None and parameters.frozen:
        return canonical(value)
    if not isinstance(value, FunctionType):
        return getattr(value, "__qualname__", type(value).__qualname__)
    return _law(value, frozenset())


def _law(value: FunctionType, inside: frozenset[FunctionType]) -> str:
    if value in inside:
        return "itself"
    read = dict(zip(value.__code__.co_freevars, value.__closure__ or (), strict=True))
    found = {name: _content(cell) for name, cell in read.items()}
    found |= {name: value.__globals__[name] for name in _names(value.__code__) if name in value.__globals__}
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


def _parts(value: Any) -> list[Any]:
    if isinstance(value, list | tuple | Set):
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
    if isinstance(value, functools.partial):
        return [value.func, value.args, value.keywords]
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return [(it.name, getattr(value, it.name)) for it in dataclasses.fields(value)]
    if state := _state(value):
        kind = type(value)
        call = vars(kind).get("__call__")
        methods: list[Any] = _of_class(kind, kind.__module__) if _is_users(kind.__module__) else []
        numbers = [np.asarray(value)] if hasattr(type(value), "__array__") else []  # of a data frame
        return [
            ADDRESS.sub("", repr(value)),
            *(methods or ([call] if isinstance(call, FunctionType) else [])),
            *numbers,
            *state,
        ]
    return []


def plain(value: Any) -> Any:
    """Numbers of Python in lists, as JSON has them; what is no number or array stays."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    return [plain(part) for part in value] if isinstance(value, list | tuple) else value
