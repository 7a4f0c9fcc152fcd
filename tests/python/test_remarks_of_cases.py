"""Studies and ensembles say of a case what its run by itself says, in lanes and without, whatever is kept."""

from __future__ import annotations

import csv
import json
import math
import warnings
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions
from linkwork.cli import run
from linkwork.running.seen_in_frames import may_show_in_frames
from numpy.testing import assert_array_equal

STEP: dict[str, Any] = {"step": 1e-3}
QUIET: dict[str, Any] = {"processes": 1, "progress": False}
LAST = ("final", "body('b').omega.final")


def bushing(w: float = 30.0) -> lw.Model:
    """It turns on beyond half a turn."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=1.0, inertia=(0.1,) * 3, omega=(0, 0, w))
    model.bushing("ground", "b", at=(0, 0, 0), stiffness=[1e3] * 3, rotational_stiffness=[5.0] * 3, name="it")
    return model


def tilting(w: float = 3.0) -> lw.Model:
    """A spring about z, on a body that a ball joint lets tilt to and fro."""
    model = lw.Model()
    model.body("b", mass=1.0, inertia=(0.1, 0.12, 0.05), position=(0.3, 0, 0), omega=(2.0, 0, w),
               velocity=(0, 0.3 * w, 0))  # fmt: skip
    model.spherical("ground", "b", at=(0, 0, 0))
    model.rotational_spring_damper("ground", "b", axis=(0, 0, 1), at=(0, 0, 0), stiffness=20.0, name="it")
    return model


def jointed(w: float = 1.0) -> lw.Model:
    """By one that folds at 180 degrees."""
    model = falls(w)
    model.constant_velocity("ground", "b", at=(0, 0, 0), axes=((0, 0, 1), (0, 0, 1)))
    return model


def opposed(w: float = 1.0) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=w, inertia=(1, 1, 1), orientation=(0, 1, 0, 0))
    model.revolute("ground", "b", at=((0, 0, 0),) * 2, axis=((0, 0, 1),) * 2, frames="body", name="it")
    return model


def told(make: Callable[[], lw.Model], t_end: float, **options: Any) -> str:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        lw.simulate(make(), t_end, **options, on_inaccurate="pass")
    return "; ".join(str(it.message) for it in caught)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("make", [bushing, tilting, opposed])
@pytest.mark.parametrize("outputs", [*LAST, "energy.max"])
def test_a_case_has_the_warnings_of_its_run_by_itself(make: Any, outputs: str) -> None:
    (w,) = make.__defaults__
    expected = told(make, 1.0, **STEP)
    assert "it" in expected
    for lanes, more in ((True, {}), (False, {"deterministic": False})):
        study = lw.sweep(make, {"w": [w, w]}, outputs, t_end=1.0, **STEP, **QUIET, **more)
        assert study.manifest["lanes"] is lanes
        assert study.remarks == {0: expected, 1: expected}
    many = lw.simulate_many(make, {"w": [w]}, 1.0, **STEP, outputs=outputs, progress=False)
    assert many.remarks == {0: expected} and not many.alone


def test_models_that_have_frames_and_such_that_have_none_run_in_one_study() -> None:
    def build(bush: int) -> lw.Model:
        return bushing() if bush else falls()

    def alone(bush: int) -> lw.Study:
        return lw.sweep(build, {"bush": [bush]}, "final", t_end=0.2, **STEP, **QUIET)

    by_itself, which = [alone(0), alone(1)], [1, 1, 0, 0, 1]
    mixed = lw.sweep(build, {"bush": which}, "final", t_end=0.2, **STEP, **QUIET)
    for k, bush in enumerate(which):
        for label, values in mixed.outputs.items():
            assert_array_equal(values[k], by_itself[bush].outputs[label][0])
        assert mixed.remarks.get(k) == by_itself[bush].remarks.get(0)
        assert mixed.accuracy[k] == by_itself[bush].accuracy[0]


def hinged(axis: Any, first: str, at: Any = (0, 0, 0)) -> lw.Model:
    model = lw.Model()
    model.body(
        "b", mass=1.0, inertia=(0.1,) * 3, position=(1, 0, 0), orientation=lw.rotation.about((1, 2, 3), 2)
    )
    model.revolute("b", "ground", at=at, axis=(0, 1, 0), name="hinge")
    other = {"b": "ground", "ground": "b"}[first]
    model.rotational_spring_damper(first, other, at=at, axis=axis, stiffness=1.0)
    return model


@pytest.mark.parametrize("first", ["b", "ground"])
def test_frames_tell_nothing_of_an_axis_that_a_joint_holds(first: str) -> None:
    """So that studies of last states need none, which take time."""
    assert not any(may_show_in_frames(hinged((0, y, 0), first)) for y in (1, -1))
    assert may_show_in_frames(hinged((0, 1, 0.01), first)) and may_show_in_frames(tilting())
    assert may_show_in_frames(jointed()) and may_show_in_frames(bushing()) and may_show_in_frames(pulled_up())
    assert not may_show_in_frames(opposed())


# --- what simulate refuses ---


def test_a_case_that_takes_years_is_refused_in_lanes_as_by_itself() -> None:
    swing = lw.mechanisms.pendulum()
    study = lw.sweep(swing, {"gravity[2]": [-9.81]}, "final", t_end=1e12, **STEP, **QUIET)
    many = lw.simulate_many(swing, {"gravity[2]": [-9.81]}, 1e12, **STEP, outputs="final", progress=False)
    assert study.manifest["lanes"] is True
    assert study.errors[0]["code"] == many.errors[0]["code"] == "too_long"


@pytest.mark.parametrize("value", ["no", "False", 0, 1, None, []])
@pytest.mark.parametrize("name", ["assemble", "verify"])
def test_a_switch_is_true_or_false(name: str, value: Any) -> None:
    swing, values = lw.mechanisms.pendulum(), {"gravity[2]": [-9.81]}
    for call in (
        lambda **more: lw.simulate(swing, 0.1, **STEP, **more),
        lambda **more: lw.sweep(swing, values, "final", t_end=0.1, **STEP, **QUIET, **more),
        lambda **more: lw.Ensemble(swing, values).single(0, 0.1, **STEP, **more),
        *([lambda **more: lw.simulate_many(swing, values, 0.1, **STEP, progress=False, **more)]
          if name == "assemble" else []),
    ):  # fmt: skip
        with pytest.raises(lw.OptionError, match=f"^{name} "):
            call(**{name: value})


ODD: list[dict[str, Any]] = [
    {"outputs": {"x": np.array([1.0, 2.0])}}, {"events": np.array(1.0)}, {"times": [10**400]},
    {"integrator": np.array([1.0, 2.0])}, {"assemble": np.array([1.0, 2.0])},
    {"threads": np.array([1.0, 2.0])},
    {"on_singular": (x for x in "ab")}, {"violation_limit": (x for x in "ab")},
    {"deterministic": "no"},
]  # fmt: skip


@pytest.mark.parametrize("odd", ODD, ids=[next(iter(it)) for it in ODD])
def test_arguments_of_another_kind_are_refused_by_name(odd: dict[str, Any]) -> None:
    (name,) = odd
    swing, values = lw.mechanisms.pendulum(), {"gravity[2]": [-9.81]}
    with pytest.raises(lw.OptionError, match=name):
        lw.sweep(swing, values, **{"outputs": "final", "t_end": 0.1, **STEP, **QUIET, **odd})
    with pytest.raises(lw.OptionError, match=name):
        lw.simulate_many(swing, values, 0.1, **{"outputs": "final", "progress": False, **STEP, **odd})


@pytest.mark.parametrize("number", [Decimal, Fraction])
@pytest.mark.parametrize("exact", [{"step": "0.01"}, {"rtol": "1e-6", "atol": "1e-8"}])
def test_numbers_of_other_kinds_are_numbers(number: Any, exact: dict[str, str]) -> None:
    swing, values = lw.mechanisms.pendulum(), {"gravity[2]": [0.0]}
    given, usual = ({name: kind(it) for name, it in exact.items()} for kind in (number, float))
    for found in (
        lw.sweep(swing, values, "final", t_end=0.1, case_seconds=number(60), **given, **QUIET),
        lw.simulate_many(swing, values, 0.1, outputs="final", progress=False, **given),
    ):
        result = lw.simulate(swing, 0.1, deterministic=True, **usual)
        assert_array_equal(found.outputs["final.q"][0], result.q[-1])


def falls(w: float = 1.0) -> lw.Model:
    model = lw.Model()
    model.body("b", mass=w, inertia=(1, 1, 1))
    return model


def below(t: float, state: Any) -> float:
    return float(state.q[0, 2]) + 0.1


def test_events_are_those_of_every_case_also_where_they_are_given_but_once() -> None:
    def given() -> Iterator[lw.Event]:
        yield lw.Event(below, terminal=True)

    masses = {"w": [1.0, 2.0, 3.0]}
    end = math.sqrt(2 * 0.1 / 9.81)
    for many in (
        lw.sweep(falls, masses, {"t": last_time}, t_end=1.0, rtol=1e-8, events=given(), **QUIET),
        lw.simulate_many(
            falls, masses, 1.0, rtol=1e-8, outputs={"t": last_time}, events=given(), progress=False
        ),
    ):
        assert many.outputs["t"] == pytest.approx([end] * 3, rel=1e-6)


def last_time(result: lw.Result) -> float:
    return float(result.t[-1])


def test_fixed_steps_have_no_events_in_lanes_either_where_the_first_case_has_no_model() -> None:
    study = lw.sweep(falls, {"w": [-1.0, 1.0]}, "final", t_end=1.0, **STEP, events=lw.Event(below), **QUIET)
    assert "give rtol" in study.errors[1]["message"]


# --- where it is told ---


def test_what_is_remarked_is_in_every_table_and_in_the_summary(tmp_path: Path) -> None:
    pytest.importorskip("xarray")
    study = lw.sweep(bushing, {"w": [1.0, 30.0, 31.0]}, "energy.max", t_end=0.2, **STEP, **QUIET)
    many = lw.simulate_many(
        bushing,
        {"w": [1.0, 30.0, 31.0]},
        0.2,
        **STEP,
        outputs="energy.max",
        on_inaccurate="pass",
        progress=False,
    )
    texts = [study.remarks.get(k, "") for k in range(3)]
    assert [bool(it) for it in texts] == [False, True, True]
    assert "remarks in 2 of 3 cases, such as: 'it': turned beyond" in repr(study)
    assert "remarks in 2 of 3 members, such as: 'it': turned beyond" in repr(many)
    assert study.to_frame()["remarks"].tolist() == texts
    assert (
        study.to_xarray()["remarks"].values.tolist() == many.to_xarray()["remarks"].values.tolist() == texts
    )
    study.to_csv(tmp_path / "cases.csv")
    with open(tmp_path / "cases.csv", encoding="utf-8") as file:
        assert [row["remarks"] for row in csv.DictReader(file)] == texts
    study.save(tmp_path / "cases.nc")


def test_the_command_line_tells_of_remarks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bushing().save(tmp_path / "bush.yaml")
    (tmp_path / "study.yaml").write_text(
        "linkwork_study: 1\nmodel: bush.yaml\nt_end: 0.2\nsimulation: {step: 1e-3}\n"
        "parameters: {b.mass: [1.0, 2.0]}\noutputs: final\n"
    )
    assert run(["sweep", str(tmp_path / "study.yaml"), "--processes", "1"], False) == 0
    assert "remarks in 2 of 2 cases, such as: 'it': turned beyond" in capsys.readouterr().out
    assert run(["sweep", str(tmp_path / "study.yaml"), "--gather", "--json"], False) == 0
    found = json.loads(capsys.readouterr().out)
    assert sorted(found["remarks"]) == ["0", "1"] and found["notes"] == {}


# --- what the summary of a run says of outputs ---


def door(hinges: int = 2) -> lw.Model:
    """The load along two hinges does not follow from the motion."""
    model = lw.Model()
    model.body("b", mass=20.0, inertia=(2, 2, 2), position=(0.4, 0, 0))
    for k in range(hinges):
        model.revolute("ground", "b", at=(0, 0, float(k)), axis=(0, 0, 1), name=f"hinge {k}")
    return model


@pytest.mark.parametrize("more", [{}, {"deterministic": False}])
def test_reactions_that_redundant_equations_leave_open_are_noted_once(more: Any) -> None:
    outputs: Any = ["reaction('hinge 0').force.z.max", "body('b').position.x.max", last_time]
    study = lw.sweep(door, {"hinges": [2, 2, 1]}, outputs, t_end=0.1, **STEP, **QUIET, **more)
    note = "reactions of 'hinge 0' are not unique, but shares of least norm"
    assert study.notes[outputs[0]] == note
    assert list(study.notes) == [outputs[0], "last_time"]
    assert list(study.remarks) == [2] and "unique here" in study.remarks[2]
    assert repr(study).count(note) == 1
    assert study.to_frame().attrs["notes"] == study.notes
    pytest.importorskip("xarray")
    assert study.to_xarray()[outputs[0]].attrs["comment"] == note


def test_an_ensemble_notes_them_of_outputs_and_of_multipliers() -> None:
    kept = lw.simulate_many(door, {"hinges": [2]}, 0.1, **STEP, outputs="reaction(name='hinge 1').torque.max",
                            progress=False)  # fmt: skip
    motions = lw.simulate_many(door, {"hinges": [2]}, 0.1, **STEP, progress=False)
    assert "of 'hinge 1' are not unique" in repr(kept)
    assert "lambda: reactions of 'hinge 0', 'hinge 1' are not unique" in repr(motions)
    assert not kept.remarks and not motions.remarks


def struck(w: float = 1.0) -> lw.Model:
    """A driver that leaves at once with 1 m/s."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=w, inertia=(0.1,) * 3)
    rail = model.translational("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    jump = functions.piecewise_polynomial([0, 0.5, 1.0], [[0.0, 0.0], [0.0, 1.0]])
    model.drive(rail, position=jump, name="driver")
    return model


def pulled_up(w: float = -9.81) -> lw.Model:
    """A disc that rolls, and would lift off."""
    model, R = lw.Model(gravity=(0, 0, w)), 0.3
    model.body("b", mass=1.0, inertia=(0.02, 0.04, 0.02), position=(0, 0, R), omega=(0, 4.0, 0.1),
               velocity=(4 * R, 0, 0))  # fmt: skip
    model.rolling_disc("ground", "b", at=((0, 0, 0), (0, 0, R)), axes=((0, 0, 1), (0, 1, 0)), radius=R)
    model.force("b", force=(0, 0, lambda t: 30 * t))
    return model


def four_bar(w: float = 1.0) -> lw.Model:
    return lw.mechanisms.spatial_slider_crank(6.0 * w)


@pytest.mark.parametrize("more", [{}, {"deterministic": False}])
@pytest.mark.parametrize(("make", "output", "method", "text"), [
    (struck, "reaction('driver').force.max", {"rtol": 1e-8}, "reactions are without the impulses"),
    (struck, "body('b').position.x.final", {"rtol": 1e-8}, ""),
    (pulled_up, "final", STEP, "the plane pulls at the disc"),
    (four_bar, "final", {**STEP, "violation_limit": {"position": 1e-12}}, "violation_limit: passed"),
])  # fmt: skip
def test_notes_of_a_run_are_remarks_where_they_say_what_outputs_are(
    make: Any, output: str, method: Any, text: str, more: Any
) -> None:
    (w,) = make.__defaults__
    study = lw.sweep(make, {"w": [w]}, output, t_end=1.0, **method, **QUIET, **more)
    many = lw.simulate_many(make, {"w": [w]}, 1.0, outputs=output, progress=False, **method)
    for found in (study.remarks, many.remarks):
        assert (text in found[0]) if text else not found
