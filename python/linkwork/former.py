"""Where the modules of public names stood in version 0.1.0.

What was pickled then loads; code that imports from there gets a DeprecationWarning with today's place.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence
from importlib import import_module
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

__all__ = ["PLACES", "install"]

#: By the former module, those that have its names now.
PLACES = {
    "linkwork.analyses.equations": ("constraints.equations",),
    "linkwork.assembly": ("equations.assembly",),
    "linkwork.comparison.measures": ("accuracy.measures",),
    "linkwork.contact": ("modeling.contact",),
    "linkwork.events": ("running.events", "motion.records"),
    "linkwork.handles": ("modeling.handles",),
    "linkwork.header": ("motion.header",),
    "linkwork.joint_coordinates": ("modeling.coordinates",),
    "linkwork.model": ("modeling.model",),
    "linkwork.model_file": ("modeling.files",),
    "linkwork.model_file.reading": ("modeling.model",),
    "linkwork.progress": ("running.progress",),
    "linkwork.result": ("motion.records", "results.result"),
    "linkwork.shapes": ("modeling.shapes",),
    "linkwork.simulation": ("running.simulation",),
    "linkwork.system": ("equations.system",),
    "linkwork.verdict": ("accuracy.verdict",),
    "linkwork.verification": ("accuracy.verification",),
}


class _FormerModules:
    """Finder and loader, asked for what is not found otherwise."""

    @staticmethod
    def find_spec(
        name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return ModuleSpec(name, _FormerModules, is_package=True) if name in PLACES else None  # type: ignore[arg-type]

    @staticmethod
    def create_module(spec: ModuleSpec) -> None:
        """The usual one."""

    @staticmethod
    def exec_module(module: ModuleType) -> None:
        def attribute(name: str) -> Any:
            for place in PLACES[module.__name__] if not name.startswith("__") else ():
                if hasattr(today := import_module(f"linkwork.{place}"), name):
                    warnings.warn(
                        f"{module.__name__}.{name} is {today.__name__}.{name} now",
                        DeprecationWarning,
                        stacklevel=2,
                    )
                    return getattr(today, name)
            raise AttributeError(f"module '{module.__name__}' has no attribute '{name}'")

        module.__getattr__ = attribute  # type: ignore[method-assign]


def install() -> None:
    sys.meta_path.append(_FormerModules)
