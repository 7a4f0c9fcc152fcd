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

from linkwork.modeling.model import Model


def manifest(
    model: Model, model_hash: str, given: Mapping[str, Any], chosen: Mapping[str, Any]
) -> dict[str, Any]:
    """Versions, machine, model and options: `given` as the user wrote them, `chosen` with none left open."""
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
    """What a file can hold: methods and functions by their names."""
    if isinstance(value, str | int | float | bool | type(None)):
        return value
    return getattr(value, "name", None) or getattr(value, "__qualname__", None) or str(value)


@functools.cache
def _cpu() -> str:
    try:
        with open("/proc/cpuinfo") as file:
            lines = [line for line in file if line.startswith("model name")]
        return lines[0].split(":", 1)[1].strip()
    except (OSError, IndexError):
        return platform.processor() or platform.machine()
