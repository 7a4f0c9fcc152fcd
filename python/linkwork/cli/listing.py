"""`linkwork list`: the mechanisms, joints and forces, and their parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from linkwork import _core
from linkwork.cli import output as out
from linkwork.modeling.elements import KINDS, Role, described

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


def show_kinds(role: Role, as_json: bool) -> None:
    """Kinds of joints or forces: what they are, their parameters and equations."""
    if as_json:
        out.print_json([_kind_record(kind) for kind in KINDS[role].values()])
        return
    rows = []
    for name, kind in KINDS[role].items():
        lines = [f"{parameter.name}: {described(parameter)}" for parameter in kind.parameters.values()]
        rows.append((name, kind.documentation, "\n".join([*lines, *kind.equations])))
    what = "parameters and equations" if role == "joint" else "parameters"
    out.print_table((role, "what it is", what), rows, left=3)


def _kind_record(kind: _core.KindInfo) -> dict[str, Any]:
    facts = ("name", "unit", "meaning", "takes", "usual", "least", "above", "not_above")
    return {
        "name": kind.name,
        "description": kind.documentation,
        "placement": kind.placement,
        "parameters": [{fact: getattr(it, fact) for fact in facts} for it in kind.parameters.values()],
        "equations": [{"name": it.name, "quantity": it.quantity} for it in kind.equations.values()],
        "coordinates": [{"name": it.name, "unit": it.unit} for it in kind.coordinates.values()],
    }
