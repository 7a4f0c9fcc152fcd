"""`linkwork list`: the mechanisms and their parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from linkwork.cli import output as out

if TYPE_CHECKING:
    from linkwork.mechanisms import Mechanism


def show_mechanisms(as_json: bool) -> None:
    from linkwork.mechanisms import MECHANISMS

    if as_json:
        out.print_json([_record(name, mechanism) for name, mechanism in MECHANISMS.items()])
        return
    rows = [
        (name, mechanism.description, "\n".join(f"{_option(p)} {p.default}" for p in mechanism.parameters))
        for name, mechanism in MECHANISMS.items()
    ]
    out.print_table(("mechanism", "what it is", "parameters"), rows, left=3)
    print("\nlinkwork run NAME simulates one; with --help it explains the parameters.")


def _record(name: str, mechanism: Mechanism) -> dict[str, Any]:
    return {
        "name": name,
        "description": mechanism.description,
        "parameters": [
            {"name": p.name, "default": p.default, "description": p.description} for p in mechanism.parameters
        ],
        "settings": dict(mechanism.settings),
    }


def _option(parameter: Any) -> str:
    return "--" + str(parameter.name).replace("_", "-")
