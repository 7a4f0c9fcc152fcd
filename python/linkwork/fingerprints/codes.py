"""What code of Python reads, imports and writes, by its instructions."""

from __future__ import annotations

import array
import collections
import contextvars
import dis
import functools
import itertools
import weakref
from collections.abc import Iterator
from types import CodeType
from typing import Any, NamedTuple

import numpy as np

from linkwork.fingerprints.origins import is_users

__all__ = [
    "Import", "attributes_changed", "cells_changed", "constants", "globals_changed", "globals_read",
    "handed_on", "imports", "is_changed", "names",
]  # fmt: skip

#: What a function may keep its memory in.
_CONTAINERS = (
    list, dict, set, bytearray, array.array, collections.deque, collections.UserDict, collections.UserList,
    weakref.WeakKeyDictionary, weakref.WeakValueDictionary, weakref.WeakSet, np.ndarray,
    contextvars.ContextVar,
)  # fmt: skip

#: Methods by which these change, and where an item is put into them.
_ITEM = "[]"
_CHANGING = {
    _ITEM, "append", "appendleft", "extend", "extendleft", "insert", "pop", "popleft", "popitem", "remove",
    "discard", "clear", "update", "setdefault", "add", "sort", "reverse", "rotate", "move_to_end", "fill",
    "set",
}  # fmt: skip

#: What happens to a name: it is written anew (None), or a method of what it holds is called.
Changes = frozenset[tuple[str, str | None]]


class Import(NamedTuple):
    """An import inside a function."""

    module: str
    level: int  #: dots before the name
    names: tuple[str, ...]  #: that it takes from the module
    known_as: frozenset[str]  #: names of its own for what it takes


def names(code: CodeType) -> frozenset[str]:
    """Globals, attributes and methods that a function and those inside of it use."""
    return frozenset(code.co_names).union(*map(names, _inner(code)))


def constants(code: CodeType) -> frozenset[str]:
    """Texts in a function and those inside of it."""
    own = frozenset(it for it in code.co_consts if isinstance(it, str))
    return own.union(*map(constants, _inner(code)))


@functools.cache
def globals_read(code: CodeType) -> frozenset[str]:
    """Names that a function, and those inside of it, read as globals: attributes may have the same."""
    found = frozenset(it.argval for it in _steps(code) if it.opname in ("LOAD_GLOBAL", "LOAD_NAME"))
    return found.union(*map(globals_read, _inner(code)))


@functools.cache
def handed_on(code: CodeType) -> frozenset[str]:
    """Names of which a function uses more than attributes by their names."""
    steps = _steps(code)
    found: list[str] = []
    for it, then in itertools.pairwise(steps):
        if it.opname.startswith("LOAD_") and then.opname not in ("LOAD_ATTR", "LOAD_METHOD"):
            found += [it.argval] if isinstance(it.argval, str) else _texts(it.argval)
    return frozenset(found).union(*map(handed_on, _inner(code)))


@functools.cache
def imports(code: CodeType) -> tuple[Import, ...]:
    """What a function, and those inside of it, import themselves."""
    steps, found = _steps(code), []
    for place, it in enumerate(steps):
        if it.opname == "IMPORT_NAME":
            level, taken = (step.argval for step in steps[place - 2 : place])
            found.append(Import(it.argval, level, tuple(taken or ()), _stored(steps[place + 1 :])))
    return tuple(found + [it for inner in _inner(code) for it in imports(inner)])


def _stored(steps: list[dis.Instruction]) -> frozenset[str]:
    """Names that what has just been imported is given."""
    found: list[str] = []
    for it in steps:
        if it.opname.startswith("STORE_"):
            found += [it.argval] if isinstance(it.argval, str) else it.argval
        elif it.opname not in ("IMPORT_FROM", "SWAP", "POP_TOP"):
            break
    return frozenset(found)


@functools.cache
def globals_changed(code: CodeType) -> Changes:
    own = _changes(code, ("LOAD_GLOBAL",), ("STORE_GLOBAL", "DELETE_GLOBAL"))
    return own.union(*map(globals_changed, _inner(code)))


@functools.cache
def cells_changed(code: CodeType) -> Changes:
    """Of variables from around a function: one inside of it may have others of the same name."""
    own = _changes(code, ("LOAD_DEREF",), ("STORE_DEREF", "DELETE_DEREF"))
    found = own.union(*map(cells_changed, _inner(code)))
    return frozenset(it for it in found if it[0] in code.co_freevars)


@functools.cache
def attributes_changed(code: CodeType) -> Changes:
    """Of whatever objects."""
    own = _changes(code, ("LOAD_ATTR",), ("STORE_ATTR", "DELETE_ATTR"))
    return own.union(*map(attributes_changed, _inner(code)))


def is_changed(name: str, value: Any, changes: Changes) -> bool:
    """Whether such changes are those of a value: `add` changes a set, and is a sum of other objects."""
    how = {method for changed, method in changes if changed == name}
    if not how or None in how:
        return bool(how)
    return isinstance(value, _CONTAINERS) and not is_users(type(value).__module__)


def _changes(code: CodeType, read: tuple[str, ...], written: tuple[str, ...]) -> Changes:
    steps = _steps(code)
    found: set[tuple[str, str | None]] = {(it.argval, None) for it in steps if it.opname in written}
    for place, it in enumerate(steps):
        if it.opname in read and steps[place + 1].opname in ("LOAD_ATTR", "LOAD_METHOD"):
            if (method := steps[place + 1].argval) in _CHANGING:
                found.add((it.argval, method))
        elif it.opname in ("STORE_SUBSCR", "DELETE_SUBSCR", "STORE_SLICE"):
            above = 2 if it.opname == "STORE_SLICE" else 1
        elif [step.opname for step in steps[place : place + 2]] == ["COPY", "COPY"]:  # x[k] += ...
            above = 1
        else:
            continue
        if it.opname not in read:
            holder = _pushed(steps, place, above)
            if holder is not None and holder.opname in read:
                found.add((holder.argval, _ITEM))
    return frozenset(found)


def _pushed(steps: list[dis.Instruction], place: int, above: int) -> dis.Instruction | None:
    """What has put the value onto the stack that has so many above it before a step; None: nobody knows."""
    height = 0
    for it in reversed(steps[:place]):
        if it.opcode in dis.hasjrel or it.opcode in dis.hasjabs:
            return None
        if height <= -above:
            return it if height == -above else None
        height -= dis.stack_effect(it.opcode, it.arg if it.opcode >= dis.HAVE_ARGUMENT else None)
    return None


@functools.cache
def _steps(code: CodeType) -> list[dis.Instruction]:
    return [it for it in dis.get_instructions(code) if it.opname not in ("CACHE", "EXTENDED_ARG")]


def _texts(value: Any) -> list[str]:
    """Of steps that load two variables at once."""
    return [it for it in value if isinstance(it, str)] if isinstance(value, tuple) else []


def _inner(code: CodeType) -> Iterator[CodeType]:
    return (it for it in code.co_consts if isinstance(it, CodeType))
