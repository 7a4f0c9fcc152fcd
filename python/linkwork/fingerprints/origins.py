"""Where functions come from: who wrote them, and what compiled ones are made from."""

from __future__ import annotations

import ctypes
import functools
import gc
import hashlib
import sys
import sysconfig
from pathlib import Path
from types import BuiltinFunctionType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

__all__ = ["called_from_ctypes", "is_users", "made_from"]

_FROM_LIBRARY: type = ctypes._CFuncPtr  # type: ignore[attr-defined]


@functools.cache
def is_users(module: str) -> bool:
    """Whether it is a script, or in a file that nobody has installed."""
    if module in ("__main__", "__mp_main__"):
        return True
    file = getattr(sys.modules.get(module), "__file__", None)
    if file is None or module.split(".")[0] == "linkwork":
        return False
    place = Path(file).resolve()
    standard = Path(sysconfig.get_path("stdlib")).resolve()
    return not place.is_relative_to(standard) and not {"site-packages", "dist-packages"} & set(place.parts)


def made_from(value: Any) -> list[Any] | None:
    """What makes a compiled function what it is: functions of Python and how they were compiled, the object
    whose method it is, the bytes of its library. None: it is no such function, or nothing is known."""
    if isinstance(value, FunctionType | MethodType | type) or is_users(type(value).__module__):
        return None
    if isinstance(inner := getattr(value, "__wrapped__", None), FunctionType):  # compiled by numba
        return [inner, getattr(value, "targetoptions", None), str(getattr(value, "_sig", ""))]
    if (numba := getattr(type(value), "_numba_type_", None)) is not None:
        data = {name: getattr(value, name) for name in numba.struct if hasattr(value, name)}
        return [data, {name: it.__wrapped__ for name, it in numba.jit_methods.items()}]
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
