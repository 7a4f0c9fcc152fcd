"""What is needed to run a simulation again."""

from __future__ import annotations

import datetime
import functools
import importlib.metadata
import os
import platform
from collections.abc import Mapping
from typing import Any

import numpy as np

from linkwork.arguments import UNREADABLE, reals
from linkwork.integrators import METHODS, Integrator
from linkwork.modeling.model import Model


def manifest(
    model: Model, model_hash: str, given: Mapping[str, Any], chosen: Mapping[str, Any]
) -> dict[str, Any]:
    """Versions, machine, model and options: `given` as the user wrote them, `chosen` with none left open.

    What is given makes the same run again, `simulate(model, **manifest["options_given"])`, where a file can
    hold it: events, a state to start from and integrators of the user's own are told in words.
    """
    return {
        "model": model.name,
        "model_hash": model_hash,
        **({"user_forces": [name for name, _ in model.user_forces]} if model.user_forces else {}),
        "options": dict(chosen),
        "options_given": {name: _plain(value) for name, value in given.items()},
        **platform_facts(),
        "started": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
    }


@functools.cache
def _versions() -> Mapping[str, str]:
    """They stay, and reading the metadata of a package takes 0.3 ms."""
    return {
        "linkwork": importlib.metadata.version("linkwork"),
        "numpy": np.__version__,
        "python": platform.python_version(),
    }


def platform_facts() -> dict[str, Any]:
    """Versions, platform, processor and its cores."""
    return {"versions": dict(_versions()), **_machine()}


@functools.cache
def _machine() -> Mapping[str, Any]:
    return {"platform": platform.platform(), "cpu": _cpu(), "cores": os.cpu_count()}


def _plain(value: Any) -> Any:
    """What a file can hold and `simulate` takes again; of anything else a text that it refuses."""
    if isinstance(value, str | int | float | bool | type(None)):
        return value
    if isinstance(value, Integrator) and repr(METHODS.get(value.name)) == repr(value):
        return value.name
    if isinstance(value, Mapping):
        return {str(name): _plain(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part) for part in value]
    try:
        numbers = np.asarray(value)
        return (numbers if numbers.dtype.kind in "biuf" else reals(value)).tolist()
    except UNREADABLE:
        # never the name alone: a function called rk4 is not the method of this name
        name = getattr(value, "name", None) or getattr(value, "__qualname__", None) or str(value)
        return f"{name}, a {type(value).__name__} of the user's own"


@functools.cache
def _cpu() -> str:
    try:
        with open("/proc/cpuinfo") as file:
            lines = [line for line in file if line.startswith("model name")]
        return lines[0].split(":", 1)[1].strip()
    except (OSError, IndexError):
        return platform.processor() or platform.machine()
