"""Where functions, classes and modules come from: who wrote them, and what compiled ones are made from."""

from __future__ import annotations

import ctypes
import functools
import gc
import hashlib
import importlib
import importlib.util
import sys
import sysconfig
from collections.abc import Mapping
from pathlib import Path
from types import BuiltinFunctionType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

__all__ = [
    "called_from_ctypes", "imported", "is_installed", "is_users", "is_users_class", "made_from", "module_of",
]  # fmt: skip

_FROM_LIBRARY: type = ctypes._CFuncPtr  # type: ignore[attr-defined]

#: Of `type.__flags__`: made while a program runs, no part of Python or of compiled code.
_HEAP = 1 << 9


def is_users(module: str) -> bool:
    """Whether it is a script, in a file that nobody has installed, or made while the program runs."""
    if module in ("__main__", "__mp_main__"):
        return True
    if module.split(".")[0] == "linkwork":
        return False
    found = sys.modules.get(module)
    if found is None:
        return True
    file = getattr(found, "__file__", None) or next(iter(getattr(found, "__path__", ())), None)
    return _is_users_file(file) if file else getattr(found, "__spec__", None) is None


@functools.cache
def _is_users_file(file: str) -> bool:
    place = Path(file).resolve()
    standard = Path(sysconfig.get_path("stdlib")).resolve()
    return not place.is_relative_to(standard) and not {"site-packages", "dist-packages"} & set(place.parts)


def is_users_class(kind: type) -> bool:
    """Classes that `exec` makes say that they are built in, and compiled ones may say anything."""
    if not kind.__flags__ & _HEAP:
        return False
    if kind.__module__ != "builtins" and kind.__module__ in sys.modules:
        return is_users(kind.__module__)
    return any(isinstance(it, FunctionType) for it in vars(kind).values())


def module_of(function: FunctionType) -> str:
    """Where it is written: `__module__` of a wrapper is that of what it wraps."""
    return str(function.__globals__.get("__name__") or function.__module__ or "")


def is_installed(function: FunctionType) -> bool:
    """Whether it is a function of an installed module under its name there, which one made by that module
    around others is not."""
    if is_users(module_of(function)):
        return False
    found: Any = sys.modules.get(function.__module__)
    if found is None or is_users(function.__module__):
        return not function.__closure__
    for name in function.__qualname__.split("."):
        found = getattr(found, name, None)
    return found is function or not function.__closure__


def imported(name: str) -> ModuleType | str | None:
    """The module that `import` gives, which is imported if it is the user's; its text where that fails. None:
    it is installed and not loaded, or there is none."""
    if name in sys.modules:
        return sys.modules[name]
    parent = name.rpartition(".")[0]
    if parent and not isinstance(imported(parent), ModuleType):
        return None
    try:
        spec = importlib.util.find_spec(name)
    except (ImportError, ValueError):
        return None
    file = getattr(spec, "origin", None)
    if spec is None or (file and not Path(file).is_file()):
        return None
    place = file or next(iter(spec.submodule_search_locations or ()), None)
    if place is None or name.split(".")[0] == "linkwork" or not _is_users_file(place):
        return None
    script = sys.modules["__main__"]
    if file and Path(getattr(script, "__file__", None) or "").resolve() == Path(file).resolve():
        return script  # it would run once more
    try:
        return importlib.import_module(name)
    except (Exception, SystemExit):  # whatever a module of the user's raises
        return Path(file).read_text(errors="replace") if file else None


def made_from(value: Any) -> list[Any] | None:
    """What makes a compiled function what it is: functions of Python and how they were compiled, the object
    whose method it is, the bytes of its library. None: it is no such function, or nothing is known."""
    if isinstance(value, FunctionType | MethodType | type) or is_users_class(type(value)):
        return None
    if (numba := _made_by_numba(value)) is not None:
        return numba
    if isinstance(value, np.vectorize):
        return [value.pyfunc, value.otypes, value.signature, sorted(map(str, value.excluded))]
    if isinstance(value, np.ufunc):
        return _called_by(value) or None
    if isinstance(value, _FROM_LIBRARY):
        return _behind(value)
    if isinstance(value, BuiltinFunctionType):
        owner = getattr(value, "__self__", None)
        if owner is not None and not isinstance(owner, ModuleType):
            return [value.__name__, owner]
        module = value.__module__ or ""
        return (
            _library(getattr(sys.modules.get(module), "__file__", None), value) if is_users(module) else None
        )
    return None


def _made_by_numba(value: Any) -> list[Any] | None:
    """A compiled function, an object of a compiled class, a typed list or dictionary, a stencil."""
    kind = type(value)
    if isinstance(inner := getattr(value, "__wrapped__", None), FunctionType):
        return [inner, getattr(value, "targetoptions", None), str(getattr(value, "_sig", ""))]
    if (numba := getattr(kind, "_numba_type_", None)) is not None and hasattr(numba, "jit_methods"):
        data = {name: getattr(value, name) for name in numba.struct if hasattr(value, name)}
        return [data, {name: it.__wrapped__ for name, it in numba.jit_methods.items()}]
    if kind.__module__.startswith("numba.typed"):
        items = list(value.items() if isinstance(value, Mapping) else value)
        return [str(value._numba_type_), items]
    if kind.__name__ == "StencilFunc":
        return [value.kernel_ir.func_id.func, value.mode, value.options, value.neighborhood]
    return None


def called_from_ctypes(value: Any) -> Any:
    """The function of Python that one of ctypes calls; None: it calls another."""
    held = getattr(value, "_objects", None) if isinstance(value, _FROM_LIBRARY) else None
    found = [called for it in (held or {}).values() for called in _called_by(it)]
    return found[0] if found else None


def _behind(function: Any) -> list[Any] | None:
    """A function of ctypes: one of Python that it calls, or its library."""
    if (called := called_from_ctypes(function)) is not None:
        return [called]
    held = (function._objects or {}).values()
    return next((_library(it._name, function) for it in held if isinstance(it, ctypes.CDLL)), None)


def _library(file: str | None, function: Any) -> list[Any] | None:
    if not file or not Path(file).is_file():
        return None
    return [function.__name__, hashlib.blake2b(Path(file).read_bytes(), digest_size=16).hexdigest()]


def _called_by(value: Any) -> list[Any]:
    return [it for it in gc.get_referents(value) if isinstance(it, FunctionType | MethodType)]
