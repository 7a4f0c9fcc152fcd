"""What kinds of joints and forces declare of themselves is complete, and is what users are told and hear."""

from __future__ import annotations

import json
import re
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import run as command
from linkwork.modeling.elements import KINDS
from linkwork.modeling.files import json_schema

PARAMETERS = [
    pytest.param(info, it, id=f"{info.name} {it.name}")
    for kinds in KINDS.values() for info in kinds.values() for it in info.parameters.values()
]  # fmt: skip


@pytest.mark.parametrize("kind, it", PARAMETERS)
def test_a_parameter_says_what_it_is_and_gives_values_that_it_may_have(kind: Any, it: Any) -> None:
    assert it.meaning
    words = set(re.findall(r"[A-Za-z_]+", it.unit))
    assert words <= {"kg", "m", "s", "N", "rad", "or", *kind.parameters}, it.unit
    for value in (it.example, it.usual):
        if value is not None and it.least is not None:
            assert value > it.least or (value == it.least and not it.above)
    assert not it.not_above or it.example <= kind.parameters[it.not_above].example


@pytest.mark.parametrize("kind", KINDS["joint"].values(), ids=lambda kind: kind.name)
def test_equations_of_velocities_stand_last(kind: Any) -> None:
    quantities = [it.quantity for it in kind.equations.values()]
    assert len(quantities) == kind.rows
    assert quantities[len(quantities) - kind.velocity_rows :] == ["velocity"] * kind.velocity_rows
    assert quantities.count("velocity") == kind.velocity_rows


@pytest.mark.parametrize("role", KINDS)
def test_the_command_line_lists_kinds_with_their_units(role: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert command(["list", f"{role}s", "--json"], False) == 0
    listed = {kind["name"]: kind for kind in json.loads(capsys.readouterr().out)}
    assert list(listed) == list(KINDS[role])
    for name, kind in KINDS[role].items():
        units = {it.name: it.unit for it in kind.parameters.values()}
        assert {it["name"]: it["unit"] for it in listed[name]["parameters"]} == units
    assert command(["list", f"{role}s"], False) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert all(name in text for name in KINDS[role])


def test_the_schema_tells_units_and_bounds() -> None:
    text = json.dumps(json_schema()["$defs"]["rolling_disc_joint"]["properties"]["radius"])
    assert "of the disc [m], a number, above 0" in text and '"exclusiveMinimum": 0.0' in text


@pytest.mark.parametrize(
    ("given", "subject", "field"),
    [
        ({"axis": (0, 0, 0)}, "screw 'it'", "axis"),
        ({"at": (0, 0)}, "screw 'it'", "at"),
        ({"x_axis": (0, 0, np.nan)}, "screw 'it'", "x_axis"),
        ({"pitch": 0.0}, "screw 'it'", "pitch"),
        ({"pitch": lambda t: t}, "screw 'it'", "pitch"),
        ({"pitch": "steep"}, "screw 'it'", "pitch"),
    ],
)
def test_an_error_knows_its_field(given: dict[str, Any], subject: str, field: str) -> None:
    model = lw.Model()
    body = model.body("body", mass=1.0, inertia=(1.0, 1.0, 1.0))
    usual = {"at": (0, 0, 0), "axis": (0, 0, 1), "pitch": 0.1, "name": "it"}
    with pytest.raises(lw.ModelError) as caught:
        model.screw("ground", body, **usual | given)
    assert (caught.value.subject, caught.value.field) == (subject, field)
    assert str(caught.value) == f"{subject}: {caught.value.reason}"


def test_an_error_of_a_body_knows_its_field() -> None:
    for field, value in {"mass": -1.0, "inertia": (1, 1, 9), "position": (0, np.inf, 0)}.items():
        with pytest.raises(lw.ModelError) as caught:
            lw.Model().body("body", **{"mass": 1.0, "inertia": (1, 1, 1)} | {field: value})
        assert (caught.value.subject, caught.value.field) == ("body 'body'", field)
