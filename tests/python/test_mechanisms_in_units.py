"""What is said of a mechanism before it runs does not depend on the units of length, mass and time."""

from __future__ import annotations

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core
from linkwork.cli.checking import examine
from linkwork.mechanisms import MECHANISMS
from linkwork.modeling.elements import KINDS
from linkwork.modeling.files import record_of
from linkwork.modeling.model import model_of
from linkwork.running import checks
from test_invariance import Units, factor

UNITS = {
    "um": Units(1.0, 1e6, 1.0),
    "Mm": Units(1.0, 1e-6, 1.0),
    "mg": Units(1e6, 1.0, 1.0),
    "kt": Units(1e-6, 1.0, 1.0),
    "us": Units(1.0, 1.0, 1e6),
    "Ms": Units(1.0, 1.0, 1e-6),
    "mg um us": Units(1e6, 1e6, 1e6),
    "kt Mm Ms": Units(1e-6, 1e-6, 1e-6),
}

#: Of the size of a mechanism or of its speed.
OFF = {"rounding": 1e-11, "little": 1e-5, "much": 3e-2}


def function(value: Any, by: float, units: Units, of_speed: bool) -> Any:
    """A number or the record of a function of time, multiplied; or of a polynomial of a speed [rad/s]."""
    if not isinstance(value, dict):
        return by * value
    ((kind, given),) = value.items()
    if kind == "polynomial":
        argument = units.s if of_speed else 1 / units.s
        return {kind: [by * c * argument**k for k, c in enumerate(given)]}
    scaled = {"amplitude": by, "offset": by, "frequency": 1 / units.s, "phase": 1.0}
    return {kind: {name: scaled[name] * x for name, x in given.items()}}


def element(record: dict[str, Any], units: Units) -> dict[str, Any]:
    kind = KINDS["joint"].get(record["kind"]) or KINDS["force"][record["kind"]]
    out = dict(record)
    for name, value in record.items():
        if name == "attachment":
            out[name] = {**value, "origin": (units.m * np.array(value["origin"])).tolist()}
        elif name not in ("kind", "name", "a", "b"):
            by = factor(units, kind.parameters[name].unit, record)
            out[name] = function(value, by, units, record["kind"] == "motor")
    return out


def in_units(model: lw.Model, units: Units) -> lw.Model:
    record = record_of(model, {})

    def times(values: Any, kg: float, m: float, s: float) -> Any:
        return (units.of(kg, m, s) * np.array(values)).tolist()

    powers = {
        "mass": (1, 0, 0),
        "inertia": (1, 2, 0),
        "position": (0, 1, 0),
        "velocity": (0, 1, -1),
        "omega": (0, 0, -1),
    }
    bodies = [
        {what: times(x, *powers[what]) if what in powers else x for what, x in body.items()}
        for body in record["bodies"]
    ]
    record |= {"gravity": times(record["gravity"], 0, 1, -2), "bodies": bodies}
    for role in {"joints", "forces"} & set(record):
        record[role] = [element(each, units) for each in record[role]]
    return model_of(record)


def off_by(model: lw.Model, part: float, size: float, rate: float) -> lw.Model:
    """Every second body displaced, turned, pushed and spun."""
    core = model.compiled()
    q, v = core.q0.reshape(-1, 7).copy(), core.v0.reshape(-1, 6).copy()
    turn = np.array([1.0, 0.3 * part, -0.2 * part, 0.1 * part])
    q[::2, :3] += part * size * np.array([0.2, -0.3, 0.25])
    for p in q[::2, 3:]:
        e0, e = p[0], p[1:].copy()
        p[0] = e0 * turn[0] - e @ turn[1:]
        p[1:] = e0 * turn[1:] + turn[0] * e + np.cross(e, turn[1:])
        p /= np.linalg.norm(p)
    v[::2] += part * rate * np.array([0.3 * size, 0.1 * size, -0.2 * size, 0.2, 0.3, -0.1])
    return model.with_initial_state(q.ravel(), v.ravel())


def answer(model: lw.Model) -> str:
    """To a run that begins like this: nothing to say, a correction, or the code of an error."""
    options = _core.Options()
    options.formulation = "augmented_lagrangian"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            found = checks.consistent(model, _core.Dynamics(model.compiled(), options))
        except lw.LinkworkError as error:
            return error.code
    return "corrected" if found else ""


def facts(model: lw.Model) -> dict[str, Any]:
    found = examine(model)
    same = ("rows", "rank", "degrees_of_freedom", "redundant", "redundant_joints", "singular_equations")
    return {what: found[what] for what in same} | {
        "unique": [joint["reaction_unique"] for joint in found["residuals"]]
    }


@pytest.mark.parametrize("name", MECHANISMS)
def test_rank_and_what_is_said_of_a_start_do_not_depend_on_units(name: str) -> None:
    model = MECHANISMS[name].function()
    size = float(np.abs(model.compiled().joint_arrays()["origin"]).max(initial=0.1))
    starts = {what: off_by(model, part, size, 10.0) for what, part in OFF.items()}
    expected, answers = facts(model), {what: answer(start) for what, start in starts.items()}
    few = model.row_count > 500  # of the large ones the last two: all units at once
    for units in [*UNITS.values()][-2 if few else 0 :]:
        assert facts(in_units(model, units)) == expected
        for what, start in starts.items():
            assert answer(in_units(start, units)) == answers[what], (what, units)


@pytest.mark.parametrize("name", ["four_bar", "bricard", "spatial_slider_crank", "andrews", "planetary_gear"])
def test_assembly_does_not_depend_on_units(name: str) -> None:
    model = off_by(MECHANISMS[name].function(), 1e-3, 0.3, 10.0)
    expected = lw.assemble(model).model.compiled()
    for units in UNITS.values():
        found = lw.assemble(in_units(model, units)).model.compiled()
        m, s = np.array([units.m] * 3 + [1.0] * 4), np.array([units.m] * 3 + [1.0] * 3) / units.s
        assert np.allclose(found.q0.reshape(-1, 7) / m, expected.q0.reshape(-1, 7), atol=1e-9)
        assert np.allclose(found.v0.reshape(-1, 6) / s, expected.v0.reshape(-1, 6), atol=1e-7)


def test_rank_does_not_depend_on_masses() -> None:
    """Bricard's linkage of six rods, five independent of six hinges' equations and one freedom."""
    record = record_of(lw.mechanisms.bricard(), {})
    for inertia in (1e-2, 1e-6, 1e-10, 1e-14, 0.0):
        for body in record["bodies"]:
            moments = np.array(body["inertia"])
            body["inertia"] = np.where(moments == moments.min(), inertia, moments).tolist()
        found = examine(model_of(record))
        assert (found["rank"], found["degrees_of_freedom"], found["redundant"]) == (29, 1, 1)


WAYS: dict[str, dict[str, Any]] = {
    "standard": {},
    "schur": {"matrix_form": "schur"},
    "no stabilization": {"stabilization": "none"},
    "projection": {"stabilization": "projection"},
    "penalty": {"formulation": "penalty"},
    "augmented Lagrangian": {"formulation": "augmented_lagrangian"},
    "hem4": {"integrator": "hem4"},
    "phem56": {"integrator": "phem56"},
    "abm4": {"integrator": "abm4"},
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ["four_bar", "bricard", "spatial_slider_crank"])
def test_motions_do_not_depend_on_units(name: str, way: str) -> None:
    """Short of what rounding makes of 40 steps."""
    model, step, count = MECHANISMS[name].function(), 1e-3, 40

    def motion(units: Units) -> tuple[Any, Any]:
        h = step * units.s
        result = lw.simulate(in_units(model, units), count * h, h, progress=False, **WAYS[way])
        m, s = np.array([units.m] * 3 + [1.0] * 4), np.array([units.m] * 3 + [1.0] * 3) / units.s
        return result.q / m, result.v / s

    q, v = motion(Units(1.0, 1.0, 1.0))
    for units in UNITS.values():
        found_q, found_v = motion(units)
        assert np.abs(found_q - q).max() <= 1e-9
        assert np.abs(found_v - v).max() <= 1e-9 * np.abs(v).max()


def of_length(units: Units) -> Any:
    return np.array([units.m] * 3 + [1.0] * 4)


def rest(model: lw.Model, units: Units) -> Any:
    q = lw.equilibrium(in_units(model, units)).model.compiled().q0
    return q.reshape(-1, 7) / of_length(units)


def driven_motion(model: lw.Model, units: Units) -> Any:
    return lw.kinematics(in_units(model, units), np.linspace(0, 0.3, 7) * units.s).q / of_length(units)


def eigenvalues(model: lw.Model, units: Units) -> Any:
    return lw.linearize(in_units(model, units)).eigenvalues * units.s


@pytest.mark.parametrize(
    ("analysis", "name"),
    [
        *((rest, name) for name in ("pendulum", "double_wishbone")),
        *((driven_motion, name) for name in ("stewart_platform", "delta_robot")),
        (eigenvalues, "double_wishbone"),
    ],
)
def test_analyses_do_not_depend_on_units(analysis: Any, name: str) -> None:
    model = MECHANISMS[name].function()
    expected = analysis(model, Units(1.0, 1.0, 1.0))
    for units in UNITS.values():
        found = analysis(model, units)
        assert found.shape == expected.shape
        assert np.abs(found - expected).max() <= 1e-6 * np.abs(expected).max()
