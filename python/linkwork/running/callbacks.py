"""What functions of the user's own reach, by contents: whether it is another one than before.

Variables of the functions around it, global ones, defaults, attributes of its own and of its object, and data
of modules and classes that nobody has installed. What compiled functions remember behind an address nobody
sees. Whether it makes a difference what a function finds there, see `recall`.
"""

from __future__ import annotations

import builtins
import ctypes
import dis
import functools
import hashlib
import pickle
import types
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from linkwork.fingerprints import is_users
from linkwork.functions.calls import Calls
from linkwork.running.kept import CONSTANT, is_opaque, names_in
from linkwork.running.places import is_from_c

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

__all__ = ["UNKNOWN", "changed", "contents", "is_stateless", "of_model", "only_logs"]

#: What cannot be looked into counts as changed.
UNKNOWN = b""

#: Not looked into: they are not where a function of the user's keeps numbers.
_OPAQUE = (types.ModuleType, type, types.BuiltinFunctionType)


def of_model(model: Model) -> dict[str, Any]:
    """The functions that the model calls, by the name of what they belong to."""
    return dict(model._reaching)


def contents(functions: Mapping[str, Any]) -> dict[str, bytes]:
    """A digest of all that each of them reaches."""
    pickles: dict[int, tuple[Any, bytes]] = {}
    return {name: _digest(function, pickles) for name, function in functions.items()}


def changed(before: Mapping[str, bytes], functions: Mapping[str, Any]) -> list[str]:
    """Those that reach something else than `before`, or what cannot be looked into."""
    return [name for name, now in contents(functions).items() if now in (UNKNOWN,) or now != before[name]]


#: What functions may have in common that takes long to pickle.
_SHARED = (dict, list, set, np.ndarray)


def _digest(function: Any, pickles: dict[int, tuple[Any, bytes]]) -> bytes:
    """`pickles`: of what functions share, in short, by its place in memory, with it."""
    digest, seen, todo = hashlib.blake2b(digest_size=16), set[int](), [function]
    call = vars(type(function)).get("__call__")
    if isinstance(call, types.FunctionType):  # of an object
        todo.append(call)
    while todo:
        it = todo.pop()
        if _opaque(it):
            continue
        if is_from_c(it):
            digest.update(ctypes.string_at(ctypes.addressof(it), ctypes.sizeof(it)))
            continue
        found = _inside(it)
        try:
            if found is None:
                if not isinstance(it, _SHARED):
                    digest.update(pickle.dumps(it))
                else:
                    if id(it) not in pickles:
                        pickles[id(it)] = it, hashlib.blake2b(pickle.dumps(it), digest_size=16).digest()
                    digest.update(pickles[id(it)][1])
                continue
        except Exception:  # whatever an object of the user's raises
            if isinstance(it, CONSTANT):  # a lock, a logger
                continue
            found = _parts(it)
            if found is None:
                return UNKNOWN
        if id(it) not in seen:
            seen.add(id(it))
            todo += found
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
        found = list(it) if isinstance(it, tuple | frozenset) else _inside(it)
        if found is None or isinstance(it, types.MethodType):
            return False
        todo += found
    return not any(isinstance(it, types.FunctionType) and "random" in " ".join(names_in(it.__code__))
                   for it in [function])  # fmt: skip


#: Methods that add to a container.
_ADDS = {"append", "appendleft", "extend", "add"}
_STORES = ("STORE_DEREF", "STORE_GLOBAL", "STORE_ATTR")
_LOADS = ("LOAD_DEREF", "LOAD_GLOBAL", "LOAD_ATTR", "LOAD_METHOD")


def only_logs(function: Any, among: Iterable[Any]) -> bool:
    """Whether a function writes, and nobody `among` those that are called reads what it writes: when it was
    called, or how often."""
    own = _functions(function)
    kept = [it for each in own for it in each.__defaults__ or () if isinstance(it, list | dict | set)]
    used = [_used(it.__code__) for it in own]
    if kept or not any(_writes(it.__code__) for it in own) or any(it.elsewhere for it in used):
        return False
    written = set[str]().union(*(it.written for it in used))
    readers = {id(it): it for one in [function, *among] for it in _functions(one)}
    return all(written.isdisjoint(_used(it.__code__).read) for it in readers.values())


def _writes(code: types.CodeType) -> bool:
    """Whether it changes something other than its own variables."""
    for it in dis.get_instructions(code):
        if it.opname in (*_STORES, "STORE_SUBSCR") or (it.opname in _LOADS and it.argval in _ADDS):
            return True
    return any(_writes(it) for it in code.co_consts if isinstance(it, types.CodeType))


def _functions(function: Any) -> list[types.FunctionType]:
    """It, those that it reaches, and all methods of the objects of the user's that it reaches."""
    seen, todo, found = set[int](), [function], []
    while todo:
        it = todo.pop()
        if id(it) in seen or _opaque(it) or isinstance(it, (*_CONSTANT, list, dict, set)):
            continue
        seen.add(id(it))
        if isinstance(it, types.FunctionType):
            found.append(it)
        elif not isinstance(it, types.MethodType | functools.partial) and is_users(type(it).__module__):
            todo += [method for name, method in vars(type(it)).items() if name != "__init__"]
        elif type(it).__module__.startswith("linkwork.functions"):
            todo += _parts(it) or []
        todo += _inside(it) or []
    return [it for it in found if isinstance(it, types.FunctionType)]


class _Used(NamedTuple):
    """Names of what a function writes other than its own variables, and of what it reads, but only to add one
    more. elsewhere: it writes to what has no name here."""

    written: frozenset[str]
    read: frozenset[str]
    elsewhere: bool


@functools.cache
def _used(code: types.CodeType) -> _Used:
    steps = [it for it in dis.get_instructions(code) if it.opname not in ("CACHE", "SWAP", "COPY")]
    inner = [_used(it) for it in code.co_consts if isinstance(it, types.CodeType)]
    written = {it.argval for it in steps if it.opname in _STORES}
    read, elsewhere = set[str](), False
    for it, *then in zip(steps, *(steps[k:] + steps[-1:] * k for k in (1, 2, 3)), strict=True):
        elsewhere = elsewhere or (then[1].opname == "STORE_SUBSCR" and it.opname != "LOAD_FAST")
        if it.opname not in _LOADS:
            continue
        if then[0].opname in ("LOAD_ATTR", "LOAD_METHOD") and then[0].argval in _ADDS:
            written.add(it.argval)
        elif not (
            then[1].opname == "BINARY_OP" and then[2].opname in _STORES and then[2].argval == it.argval
        ):
            read.add(it.argval)
    return _Used(
        frozenset(written).union(*(it.written for it in inner)),
        frozenset(read).union(*(it.read for it in inner)),
        elsewhere or any(it.elsewhere for it in inner),
    )


def _chance(it: Any) -> bool:
    """Random numbers have a state of their own."""
    name = getattr(it, "__name__", "")
    return "random" in f"{getattr(it, '__module__', '')} {name if isinstance(it, types.ModuleType) else ''}"


def _opaque(it: Any) -> bool:
    return isinstance(it, _OPAQUE) or is_opaque(it)


def _inside(it: Any) -> list[Any] | None:
    """What a function reaches; None: it is something else."""
    if isinstance(it, types.FunctionType):
        return list(_reached(it))
    if isinstance(it, types.MethodType):
        return [it.__func__, it.__self__]
    if isinstance(it, functools.partial):
        return [it.func, *it.args, *it.keywords.values()]
    if isinstance(it, Calls):
        return [it.function]
    return None


def _parts(it: Any) -> list[Any] | None:
    """Of an object that cannot be pickled as a whole."""
    if isinstance(it, dict):
        return [*it.keys(), *it.values()]
    if isinstance(it, list | tuple | set | frozenset):
        return list(it)
    if isinstance(it, memoryview):
        return [bytes(it)]
    return list(vars(it).values()) if hasattr(it, "__dict__") else None


def _reached(function: types.FunctionType) -> Iterator[Any]:
    yield from function.__defaults__ or ()
    yield from (function.__kwdefaults__ or {}).values()
    yield from _cells(function)
    if vars(function):
        yield dict(vars(function))
    for name in sorted(names_in(function.__code__)):
        if name in function.__globals__ and not hasattr(builtins, name):
            value = function.__globals__[name]
            yield value
            yield from _data_of(value, function.__code__)


def _data_of(value: Any, code: types.CodeType) -> list[Any]:
    """Of a module or class of the user's: numbers and the like, by names that the function uses."""
    if not isinstance(value, types.ModuleType | type):
        return []
    if not is_users(value.__name__ if isinstance(value, types.ModuleType) else value.__module__):
        return []
    found = {name: vars(value)[name] for name in sorted(names_in(code)) if name in vars(value)}
    return [it for it in found.values() if isinstance(it, (*_CONSTANT, list, dict, set))]


def _cells(function: types.FunctionType) -> Iterator[Any]:
    for cell in function.__closure__ or ():
        try:
            yield cell.cell_contents
        except ValueError:  # nothing in it yet
            continue
