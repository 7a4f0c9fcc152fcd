"""What functions of the user's own can write to, kept so that it can be put back."""

from __future__ import annotations

import array
import dis
import functools
import random
import sys
import types
from collections import OrderedDict, deque
from collections.abc import Callable, Collection, Iterable, Mapping
from contextlib import AbstractContextManager
from typing import Any

import numpy as np

from linkwork.fingerprints import is_users

__all__ = ["Kept", "is_opaque", "names_in"]

#: Nothing in them can be written to, nor do they hold anything.
CONSTANT = (type(None), bool, int, float, complex, str, bytes, np.generic, np.dtype, range)

#: Arrays of more bytes are not copied, nor are more objects looked into.
LARGE, MOST = 2**27, 200_000

_ASSIGN = ("STORE_DEREF", "STORE_GLOBAL", "STORE_ATTR")
_COMPILED = ("ctypes", "_ctypes", "_cffi_backend", "numba")
_WRAPPERS = (types.MethodType, staticmethod, classmethod, functools.partial, property)


class Kept(AbstractContextManager["Kept"]):
    """All that functions reach, as it is now; as a context it puts that back at its end."""

    def __init__(self, functions: Iterable[Any]) -> None:
        self.whole = True  # whether all could be looked into
        self._assigns = False
        self._back: dict[object, Callable[[], object]] = {}  # by what it is that is written to
        self._seen: dict[int, Any] = {}  # alive, or another could have the same id
        self._todo = list(functions)
        while self._todo and len(self._seen) < MOST:
            self._look_into(self._todo.pop())
        self.whole = self.whole and not self._todo

    def __exit__(self, *error: object) -> None:
        self.put_back()

    def put_back(self) -> None:
        for restore in self._back.values():
            restore()

    @property
    def writable(self) -> bool:
        """Whether there are containers, or variables that they assign to."""
        return self._assigns or any(isinstance(key, int) for key in self._back)

    def shares(self, other: Kept) -> bool:
        """Whether both reach something that can be written to, or might."""
        return not (self.whole and other.whole) or not self._back.keys().isdisjoint(other._back)

    def _look_into(self, it: Any) -> None:
        if isinstance(it, CONSTANT) or id(it) in self._seen or is_opaque(it):
            return
        self._seen[id(it)] = it
        if isinstance(it, types.FunctionType):
            self._function(it)
        elif isinstance(it, type):
            self._class(it)
        elif isinstance(it, types.BuiltinMethodType):
            self._todo.append(it.__self__)
        elif isinstance(it, _WRAPPERS):
            self._todo += _wrapped(it)
        elif (state := _state(it)) is not None:
            restore, inside = state
            self._back[id(it)] = restore
            self._todo += inside
        elif isinstance(it, tuple | frozenset):
            self._todo += it
        elif not isinstance(it, types.ModuleType):
            self._object(it)

    def _function(self, it: types.FunctionType) -> None:
        self._assigns = self._assigns or _assigns(it.__code__)
        for cell in it.__closure__ or ():
            try:
                self._attribute(cell, "cell_contents", cell.cell_contents)
            except ValueError:  # nothing in it yet
                continue
        self._todo += [*(it.__defaults__ or ()), it.__kwdefaults__, vars(it) or None]
        if _is_installed(it):
            return
        names = names_in(it.__code__)
        for name in names & it.__globals__.keys():
            value = it.__globals__[name]
            self._named((id(it.__globals__), name), value, it.__globals__.__setitem__, name, value)
            if isinstance(value, types.ModuleType) and is_users(value.__name__):
                for inner in names & vars(value).keys():
                    self._attribute(value, inner, vars(value)[inner])

    def _class(self, it: type) -> None:
        if not is_users(it.__module__):
            return
        for name, value in vars(it).items():
            if name.startswith("__") and name != "__call__":
                continue
            if isinstance(value, (types.FunctionType, types.MemberDescriptorType, *_WRAPPERS)):
                self._todo.append(value)
            else:
                self._attribute(it, name, value)
        self._todo += it.__bases__

    def _object(self, it: Any) -> None:
        kind = type(it)
        slots = [name for base in kind.__mro__ for name in _slots(base) if hasattr(it, name)]
        for name in slots:
            value = getattr(it, name)
            self._attribute(it, name, value)
        if hasattr(it, "__dict__"):
            self._todo.append(vars(it))
        elif not any("__slots__" in vars(base) for base in kind.__mro__):
            self.whole = False
        if is_users(kind.__module__):
            self._todo.append(kind)

    def _attribute(self, of: Any, name: str, value: Any) -> None:
        self._seen[id(of)] = of
        self._named((id(of), name), value, _put, of, name, value)

    def _named(self, key: object, value: Any, restore: Callable[..., None], *arguments: Any) -> None:
        self._todo.append(value)
        if not isinstance(value, types.FunctionType | types.BuiltinFunctionType | types.ModuleType | type):
            self._back[key] = functools.partial(restore, *arguments)


def _state(it: Any) -> tuple[Callable[[], object], Iterable[Any]] | None:
    """How to put its state back, and what is in it; None: it is no container that is known."""
    if isinstance(it, dict):
        return functools.partial(_refill, it, dict(it)), list(it.values())
    if isinstance(it, list):
        return functools.partial(list.__setitem__, it, slice(None), list(it)), list(it)
    if isinstance(it, set | deque):
        return functools.partial(_renew, it, list(it)), list(it)
    if isinstance(it, bytearray | array.array):
        return functools.partial(it.__setitem__, slice(None), it[:]), ()
    if isinstance(it, np.ndarray):
        inside: list[Any] = it.ravel().tolist() if it.dtype.hasobject else []
        if not it.flags.writeable or it.nbytes > LARGE:
            return _nothing, inside
        return functools.partial(np.copyto, it, it.copy()), inside
    if isinstance(it, random.Random):
        return functools.partial(it.setstate, it.getstate()), ()
    if isinstance(it, np.random.RandomState):
        return functools.partial(it.set_state, it.get_state()), ()
    if isinstance(it, np.random.Generator):
        return _nothing, [it.bit_generator]
    if isinstance(it, np.random.BitGenerator):
        return functools.partial(setattr, it, "state", it.state), ()
    return None


def _nothing() -> None:
    pass


def _put(of: Any, name: str, value: Any) -> None:
    if getattr(of, name, None) is value:
        return
    put: Any = setattr if isinstance(of, type | types.ModuleType) else object.__setattr__
    put(of, name, value)


def _refill(it: dict[Any, Any], content: Mapping[Any, Any]) -> None:
    if _same(it.keys(), content.keys()) and _same(it.values(), content.values()):
        return
    kind: Any = OrderedDict if isinstance(it, OrderedDict) else dict
    kind.clear(it)
    kind.update(it, content)


def _renew(it: Any, content: list[Any]) -> None:
    if not _same(it, content):
        it.clear()
        (it.update if isinstance(it, set) else it.extend)(content)


def _same(now: Collection[Any], then: Collection[Any]) -> bool:
    """The very same objects, in this order."""
    return len(now) == len(then) and all(a is b for a, b in zip(now, then, strict=True))


def _wrapped(it: Any) -> list[Any]:
    if isinstance(it, property):
        return [it.fget, it.fset]
    if isinstance(it, functools.partial):
        return [it.func, *it.args, it.keywords]
    return [it.__func__, getattr(it, "__self__", None)]


def _slots(kind: type) -> list[str]:
    named = vars(kind).get("__slots__", ())
    found = [named] if isinstance(named, str) else list(named)
    return [it for it in found if it not in ("__dict__", "__weakref__")]


def _assigns(code: types.CodeType) -> bool:
    """Whether it, or a function inside, assigns to other variables than its own, or to attributes."""
    inner = [it for it in code.co_consts if isinstance(it, types.CodeType)]
    return any(it.opname in _ASSIGN for it in dis.get_instructions(code)) or any(map(_assigns, inner))


def _is_installed(function: types.FunctionType) -> bool:
    """Whether its global variables are those of a module that is not the user's."""
    name = function.__module__ or ""
    of_module = vars(sys.modules[name]) if name in sys.modules else None
    return of_module is function.__globals__ and not is_users(name)


def is_opaque(it: Any) -> bool:
    """What keeps no numbers of the user's: compiled functions, parts of a model."""
    package, _, rest = type(it).__module__.partition(".")
    return (
        isinstance(it, np.ufunc)
        or package in _COMPILED
        or (package == "linkwork" and not rest.startswith("functions"))
    )


def names_in(code: types.CodeType) -> set[str]:
    """Of globals and attributes, also of the functions inside."""
    inner = [names_in(it) for it in code.co_consts if isinstance(it, types.CodeType)]
    return set(code.co_names).union(*inner)
