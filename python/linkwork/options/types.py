"""The types of the choices of a run, from the compiled module's table of options and the integrators.

Type checkers read types.pyi, where names are literals; `./dev stubs` writes it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypedDict

from linkwork import _core
from linkwork.integrators import METHODS

__all__ = ["IntegratorName", "Level", "Options"]

#: Of constraints, in the order of `Result.violation`.
Level = Literal["position", "velocity", "acceleration"]

IntegratorName = Literal[tuple(METHODS)]


def _type(option: _core.OptionInfo) -> Any:
    names: Any = Literal[tuple(option.choices)] if option.choices else None
    number, limits = float | None, float | Mapping[Level, float] | None
    return {"name": names, "number": number, "whole": int | None, "limits": limits, "switch": bool | None}[
        option.type
    ]


Options: Any = TypedDict("Options", {option.name: _type(option) for option in _core.options()}, total=False)
Options.__doc__ = "What `simulate` and `System` take by name; what is left out, or None, has its default."


def described(option: _core.OptionInfo) -> str:
    """One line: what it is, its unit, what it can be, its default, and which methods have it."""
    default = option.usual if option.methods else getattr(_core.Options(), option.name)
    unit = f" [{option.unit}]" if option.unit else ""
    names = f": {', '.join(option.choices)}" if option.choices else ""
    shown = f"{default:g}" if isinstance(default, float) else default if option.choices else ""
    usual = f", default {shown}" if shown else ""
    methods = f" (of {', '.join(option.methods)})" if option.methods else ""
    return f"{option.documentation}{unit}{names}{methods}{usual}"


def stub() -> str:
    """The text of types.pyi."""
    types = {"number": "float", "whole": "int", "limits": "float | Mapping[Level, float]", "switch": "bool"}
    fields = "\n".join(
        f"    {it.name}: " + (f"{types[it.type]} | None" if it.type in types else f"Literal{it.choices}")
        + f'\n    """{described(it)}"""' for it in _core.options()
    )  # fmt: skip
    return f'''"""Written by `./dev stubs`."""

from collections.abc import Mapping
from typing import Literal, TypedDict

from linkwork import _core

Level = Literal["position", "velocity", "acceleration"]
IntegratorName = Literal{list(METHODS)}

class Options(TypedDict, total=False):
    """{Options.__doc__}"""

{fields}

def described(option: _core.OptionInfo) -> str: ...
'''
