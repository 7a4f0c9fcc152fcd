"""`linkwork list`: the mechanisms and their parameters."""

from __future__ import annotations

from linkwork.cli import output as out


def show_mechanisms(as_json: bool) -> None:
    from linkwork.mechanisms import MECHANISMS

    if as_json:
        out.print_json([
            {
                "name": name,
                "description": mechanism.description,
                "parameters": [
                    {"name": p.name, "default": p.default, "description": p.description} for p in mechanism.parameters
                ],
                "settings": dict(mechanism.settings),
            }
            for name, mechanism in MECHANISMS.items()
        ])  # fmt: skip
        return
    rows = [
        (name, mechanism.description, "\n".join(f"--{p.name.replace('_', '-')} {p.default}" for p in mechanism.parameters))
        for name, mechanism in MECHANISMS.items()
    ]
    out.print_table(("mechanism", "what it is", "parameters"), rows, left=3)
    print("linkwork run NAME simulates one; linkwork run NAME --help explains its parameters.")
