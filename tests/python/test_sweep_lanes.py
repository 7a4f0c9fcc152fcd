"""Studies in lanes: a case has the bits of its deterministic run by itself, whatever runs beside it."""

from __future__ import annotations

import concurrent.futures
import json
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.studies import chunks, sweeping
from linkwork.studies.variants import Changed
from numpy.testing import assert_array_equal

RUN: dict[str, Any] = {"t_end": 0.1, "step": 2e-3, "progress": False}
OUTPUTS = ["final", "reaction('bearing').force.max", "energy_error.abs_max"]
MASSES = np.linspace(0.4, 0.8, 21).tolist()


def slider_crank() -> lw.Model:
    return mechanisms.spatial_slider_crank()


def parameters(masses: list[float] = MASSES) -> dict[str, Any]:
    return {"coupler.mass": masses}


def study(masses: list[float] = MASSES, **arguments: Any) -> lw.Study:
    return lw.sweep(slider_crank(), parameters(masses), OUTPUTS, **{**RUN, "processes": 1, **arguments})


def same(one: lw.Study, other: lw.Study, *numbers: int) -> None:
    """All but the wall time, of these cases."""
    which = list(numbers) or list(range(len(one)))
    assert one.status[which].tolist() == other.status[which].tolist()
    assert one.verdict[which].tolist() == other.verdict[which].tolist()
    assert_array_equal(one.accuracy[which], other.accuracy[which])
    assert [one.errors.get(k) for k in which] == [other.errors.get(k) for k in which]
    assert [one.remarks.get(k) for k in which] == [other.remarks.get(k) for k in which]
    for label in one.outputs:
        assert_array_equal(one.outputs[label][which], other.outputs[label][which])


@pytest.mark.parametrize("processes", [1, 3])
def test_a_time_limit_holds_for_each_case_in_lanes(processes: int) -> None:
    none = study(processes=processes, case_seconds=1e-9)
    assert none.manifest["lanes"] is True and set(none.status.tolist()) == {"failed"}
    same(study(processes=processes, case_seconds=60.0), study())


def test_a_case_in_lanes_has_the_bits_and_the_verdict_of_its_deterministic_run_by_itself() -> None:
    found = study()
    assert found.manifest["lanes"] is True
    for k in (0, 7, 20):
        model = slider_crank().replaced("coupler", mass=MASSES[k])
        result = lw.simulate(model, RUN["t_end"], RUN["step"], record_every=1, deterministic=True)
        assert_array_equal(found.outputs["final.q"][k], result.q[-1])
        force = np.linalg.norm(result.reaction("bearing").force, axis=1)
        assert found.outputs["reaction('bearing').force.max"][k] == force.max()
        assert result.verdict is not None
        assert (found.verdict[k], found.accuracy[k]) == (result.verdict.level, result.verdict.error)
        assert_array_equal(found.simulate(k).v, result.v)


def test_where_the_last_state_alone_is_asked_for_nothing_else_of_a_case_is_another_one() -> None:
    whole = lw.sweep(slider_crank(), parameters(), ["final", "energy.final"], **RUN, processes=1)
    state = lw.sweep(slider_crank(), parameters(), "final", **RUN, processes=1)
    assert state.manifest["lanes"] is True
    same(state, whole)


def test_bits_do_not_depend_on_tasks_shards_executors_or_neighbors(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = study()
    with concurrent.futures.ThreadPoolExecutor(2) as executor:
        same(whole, study(processes=None, executor=executor))
    for k in (2, 0, 1):
        study(directory=tmp_path, shard=(k, 3))
    same(whole, study(directory=tmp_path, gather=True, processes=None))
    monkeypatch.setattr(chunks, "TASK_SECONDS", 1e-9)  # every case alone
    same(whole, study(processes=2))
    assert_array_equal(study([MASSES[5]]).outputs["final.v"][0], whole.outputs["final.v"][5])


def test_a_rerun_of_one_missing_case_gives_its_bits(tmp_path: Path) -> None:
    whole = study(directory=tmp_path)
    for file in (tmp_path / "cases").glob("*.jsonl"):
        if len(keys := [json.loads(line) for line in file.read_text().splitlines()[1:]]) > 1:
            file.unlink()
            break
    again = study(directory=tmp_path)
    assert len(keys) > 1
    same(whole, again)


def test_cases_that_fail_leave_the_others_of_their_pack_as_they_are() -> None:
    """One has no model, one turns too fast, one has an output that is no number."""

    def build(mass: float, speed: float = 0.0) -> lw.Model:
        model = lw.Model(name="two rods")
        J = (0.01, 0.1, 0.1)
        first = model.body("first", mass=1, inertia=J, position=(0.5, 0, 0), omega=(0, speed, 0),
                           velocity=(0, 0, -0.5 * speed))  # fmt: skip
        second = model.body("second", mass=mass, inertia=J, position=(1.5, 0, 0), velocity=(0, 0, -speed))
        model.revolute(model.ground, first, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
        model.spherical(first, second, at=(1, 0, 0), name="elbow")
        return model

    def height(result: lw.Result) -> Any:
        return "high" if result.v[0, 0, 4] == 1.0 else float(result.q[-1, 1, 2])

    rows: list[dict[str, float]] = [{"mass": 1.0 + 0.1 * k, "speed": 0.0} for k in range(17)]
    spoiled = [dict(row) for row in rows]
    spoiled[3]["mass"] = -1.0
    spoiled[9]["speed"] = 1e5
    spoiled[12]["speed"] = 1.0
    few = {**RUN, "processes": 1}
    good, found = (lw.sweep(build, it, {"height": height}, **few) for it in (rows, spoiled))
    assert found.manifest["lanes"] is True
    assert sorted(found.errors) == [3, 9, 12]
    assert (found.errors[3]["type"], found.errors[12]["type"]) == ("ModelError", "OptionError")
    assert found.errors[9]["reached"] is not None
    same(good, found, *(k for k in range(17) if k not in found.errors))


def half_way(t: float, _: Any) -> float:
    return t - RUN["t_end"] / 2


@pytest.mark.parametrize("options", [
    {"deterministic": False}, {"integrator": "ab2"}, {"formulation": "penalty"}, {"on_inaccurate": "stop"},
    {"stabilization": "projection"}, {"rtol": 1e-6, "step": None}, {"events": ()},
    {"rtol": 1e-6, "step": None, "events": (lw.Event(half_way, terminal=True),)},
])  # fmt: skip
def test_with_and_without_lanes_cases_are_runs(options: dict[str, Any]) -> None:
    found = study(MASSES[:2], **options)
    assert found.manifest["lanes"] is bool({"events", "rtol", "stabilization"} & options.keys())
    arguments = {"step": RUN["step"], "deterministic": found.manifest["lanes"], **options}
    model = slider_crank().replaced("coupler", mass=MASSES[1])
    result = lw.simulate(model, RUN["t_end"], record_every=1, **arguments)
    assert_array_equal(found.outputs["final.q"][1], result.q[-1])


@pytest.mark.parametrize("in_lanes", [True, False])
@pytest.mark.parametrize(("how", "times"), [
    ({"step": 5e-4}, None), ({"rtol": 1e-8}, None), ({"step": 5e-4}, [1.0, 2.0]),
    ({"rtol": 1e-8}, [1.0, 2.0]),
])  # fmt: skip
def test_full_turns_are_counted_between_the_times_of_outputs(
    how: dict[str, float], times: list[float] | None, in_lanes: bool
) -> None:
    """An indexing table, w t - sin w t: at rest after each turn, where few frames see nothing of it."""
    w, options = 10 * np.pi, {"progress": False, **how}
    model = lw.Model(name="indexing table", gravity=(0, 0, 0))
    model.revolute("ground", model.body("table", mass=1.0, inertia=(0.1, 0.1, 0.1)),
                   at=(0, 0, 0), axis=(0, 1, 0), name="pin")  # fmt: skip
    model.drive("pin", position=lw.functions.expression(f"{w}*t - sin({w}*t)"))
    output = "coordinate('pin').value" + ("" if times else ".final")
    turned = w * np.array(times) if times else 2.0 * w
    if in_lanes:
        many = lw.Ensemble(model, {"table.mass": [1.0, 2.0]})
        found = many.simulate(2.0, outputs=output, times=times, **options).outputs[output]
        np.testing.assert_allclose(found[0], turned, rtol=1e-6)
    study = lw.sweep(model, {"table.mass": [1.0]}, output, t_end=2.0, times=times, processes=1,
                     deterministic=in_lanes, **options)  # fmt: skip
    assert study.manifest["lanes"] is in_lanes
    np.testing.assert_allclose(study.outputs[output][0], turned, rtol=1e-6)


@pytest.mark.parametrize("in_lanes", [True, False])
def test_a_model_that_lanes_refuse_is_run_as_ever(in_lanes: bool) -> None:
    """With a limit of accelerations; not for its body with very many joints in loops."""
    model = mechanisms.scissors(16, 2)
    options: dict[str, Any] = {} if in_lanes else {"violation_limit": {"acceleration": 1e6}}
    found = lw.sweep(model, {"gravity[2]": [-1.0]}, "final", **RUN, **options, processes=1)
    assert found.manifest["lanes"] is in_lanes
    changed = Changed.of(model, ["gravity[2]"]).model({"gravity[2]": -1.0})
    single = lw.simulate(changed, RUN["t_end"], RUN["step"], deterministic=in_lanes, **options)
    assert_array_equal(found.outputs["final.q"][0], single.q[-1])


def test_a_study_that_began_otherwise_goes_on_as_it_began(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:  # as versions did that had no lanes
        patch.setattr(sweeping, "with_lanes", lambda *_: None)
        before = study(MASSES[:3], directory=tmp_path)
    assert before.manifest["lanes"] is False
    more = study(MASSES[:4], directory=tmp_path)
    assert more.manifest["lanes"] is False
    same(before, more, 0, 1, 2)


def test_tasks_are_of_whole_packs_where_cases_are_cheap() -> None:
    cases: list[Any] = [None] * 1000
    assert {len(it) for it in chunks.chunked(cases, 0.01, 2, 8)[:-1]} == {128}
    assert {len(it) for it in chunks.chunked(cases, 0.5, 2, 8)} == {8}
    assert {len(it) for it in chunks.chunked(cases, 2.0, 2, 8)} == {1}


def test_cases_of_other_weights_are_each_told_what_their_own_run_is_told() -> None:
    """Such as axes that point in opposite directions, which is the same for all of them."""
    model, masses = lw.Model(gravity=(0, 0, 0), name="turned"), np.linspace(1.0, 3.0, 9).tolist()
    model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), orientation=(0, 1, 0, 0), omega=(0, 0, 0.1))
    place: dict[str, Any] = {"at": ((0, 0, 0), (0, 0, 0)), "frames": "body", "name": "pin"}
    model.revolute("ground", "rod", axis=((0, 0, 1), (0, 0, 1)), **place)
    with pytest.warns(lw.LinkworkWarning, match="axes of 'pin' point in opposite directions"):
        found = lw.sweep(model, {"rod.mass": masses}, "final", **RUN, processes=1)
    assert found.manifest["lanes"] is True
    for k, mass in enumerate(masses):
        with pytest.warns(lw.LinkworkWarning) as told:
            lw.simulate(model.replaced("rod", mass=mass), **RUN)
        assert found.remarks[k] == "; ".join(str(it.message) for it in told)
