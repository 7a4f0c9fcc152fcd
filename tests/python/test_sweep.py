"""Studies: each case has the bits of its own run, once, whatever fails, dies or is interrupted."""

from __future__ import annotations

import concurrent.futures
import enum
import importlib.util
import json
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import threading
import time
import types
import warnings
import weakref
from collections import Counter
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import run
from linkwork.fingerprints import digest, digests
from linkwork.studies.chunks import FILES, chunked
from linkwork.studies.files import read_study
from linkwork.studies.variants import Changed
from numpy.testing import assert_array_equal

RUN: dict[str, Any] = {"t_end": 0.05, "step": 5e-3, "progress": False}
FEW: dict[str, Any] = {**RUN, "processes": 1}
FEW_OF: dict[Any, dict[str, Any]] = {lw.sweep: FEW, lw.simulate_many: RUN}
GRID = {"rod.mass": [1.0, 2.0, 3.0], "gravity[2]": [-9.81, -1.62]}


#: Of threads: it computes nothing here.
ANY = concurrent.futures.ThreadPoolExecutor(1)

RANDOM: dict[str, Any] = {"parameters": {"rod.mass": (1, 2)}, "sampler": "random", "cases": 4, "seed": 1}


def rod(length: float = 1.0, gravity: float = 9.81, speed: float = 0.0) -> lw.Model:
    """A slender rod on a hinge, released from the side."""
    model = lw.Model(gravity=(0, 0, -gravity), name="rod")
    J = length**2 / 12
    body = model.body("rod", mass=1.0, inertia=(1e-3, J, J), position=(length / 2, 0, 0),
                      velocity=(0, 0, -speed * length / 2), omega=(0, speed, 0))  # fmt: skip
    model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


def dying(mass: float) -> lw.Model:
    """Ends its process where the mass is 3 kg and the file says so."""
    if mass == 3.0 and Path(os.environ["DYING"]).exists():
        os.kill(os.getpid(), signal.SIGKILL)
    return rod().replaced("rod", mass=mass)


def keys_in(directory: Path) -> Counter[str]:
    lines = [line for file in (directory / "cases").glob("*.jsonl") for line in file.read_text().splitlines()]
    return Counter(found["key"] for line in lines if "key" in (found := json.loads(line)))


def same(one: lw.Study, other: lw.Study) -> None:
    assert one.status.tolist() == other.status.tolist()
    for label in one.outputs:
        assert_array_equal(one.outputs[label], other.outputs[label])


# --- what is computed ---


def test_a_case_has_the_bits_of_simulate() -> None:
    study = lw.sweep(rod(), GRID, ["reaction('pin').force.max", "final"], **FEW)
    for k in range(len(study)):
        model = lw.Model((0, 0, study.parameters["gravity[2]"][k]))
        base = rod().values("rod")
        kept = {name: base[name] for name in ("inertia", "position")}
        body = model.body("rod", mass=study.parameters["rod.mass"][k], **kept)
        model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
        result = lw.simulate(model, RUN["t_end"], RUN["step"], record_every=1, deterministic=True)
        assert_array_equal(study.outputs["final.q"][k], result.q[-1])
        assert_array_equal(study.outputs["final.v"][k], result.v[-1])
        force = np.linalg.norm(result.reaction("pin").force, axis=1)
        assert study.outputs["reaction('pin').force.max"][k] == force.max()
        assert_array_equal(study.simulate(k).q, result.q)


def test_reactions_of_all_joints_are_those_of_each() -> None:
    chain = lw.mechanisms.chain(3)
    names = lw.simulate(chain, t_end=1e-3, step=1e-3, progress=False).joint_names
    each = [f"reaction('{name}').force.max" for name in names]
    study = lw.sweep(chain, {"gravity[2]": [-9.81, -1.62]}, ["reactions().force.max", *each], **FEW)
    assert study.units["reactions().force.max"] == "N"
    found = np.stack([study.outputs[label] for label in each], axis=1)
    assert_array_equal(study.outputs["reactions().force.max"], found)


def test_period_of_small_swings_is_that_of_length_and_gravity() -> None:
    """T = 2 pi sqrt(2 L / 3 g) of a slender rod, for small angles."""

    def period(result: lw.Result) -> float:
        z, t = result.body("rod").velocity[:, 0], result.t
        k = np.flatnonzero((z[:-1] < 0) & (z[1:] >= 0))[0]
        return float(t[k] - z[k] * (t[k + 1] - t[k]) / (z[k + 1] - z[k]))

    def hanging(length: float, gravity: float) -> lw.Model:
        model = lw.Model(gravity=(0, 0, -gravity))
        J, angle = length**2 / 12, 1e-3
        turned = lw.rotation.about((0, 1, 0), angle)
        body = model.body("rod", mass=1.0, inertia=(J, J, 1e-3), orientation=turned,
                          position=(-length / 2 * np.sin(angle), 0, -length / 2 * np.cos(angle)))  # fmt: skip
        model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 1, 0))
        return model

    study = lw.sweep(hanging, {"length": [0.1, 0.2], "gravity": [5.0, 9.81, 20.0]}, {"period": (period, "s")},
                     t_end=1.5, step=2e-3, progress=False, processes=2)  # fmt: skip
    L, g = study.parameters["length"], study.parameters["gravity"]
    assert study.outputs["period"] == pytest.approx(2 * np.pi * np.sqrt(2 * L / (3 * g)), rel=1e-5)
    assert study.units["period"] == "s"


@pytest.mark.parametrize("index", ["[:, 0]", "[:, -1]", "[:, [0]]", "[:]", "[...]", "[:, 0, :]", "[:][:, 0]"])
@pytest.mark.parametrize("name", ["velocity", "acceleration", "omega"])
def test_a_body_by_index_has_the_magnitude_that_it_has_by_name(index: str, name: str) -> None:
    by_index, by_name = f"{name}{index}.max", f"body('rod').{name}.max"
    study = lw.sweep(rod(), {"rod.mass": [1.0]}, [by_index, by_name], t_end=0.2, step=5e-3, processes=1)
    assert study.outputs[by_index].item() == study.outputs[by_name].item() > 0.0


@pytest.mark.parametrize(
    "index, component", [("[:, 0, 2]", "z"), ("[..., 0, -1]", "z"), ("[:, 0, ::-1]", "")]
)
def test_an_index_into_components_gives_these(index: str, component: str) -> None:
    names = [f"velocity{index}.min", *(f"body('rod').velocity.{it}.min" for it in component or "zyx")]
    study = lw.sweep(rod(), {"rod.mass": [1.0]}, names, t_end=0.2, step=5e-3, processes=1)
    found, *expected = (study.outputs[name][0] for name in names)
    assert_array_equal(np.ravel(found), expected)


def test_reductions_are_over_magnitudes_and_over_time() -> None:
    names = ["body('rod').velocity.max", "body('rod').velocity.z.min", "body('rod').velocity.mean",
             "body('rod').velocity.rms", "body('rod').velocity.final", "body('rod').velocity.z.range",
             "body('rod').velocity.z.abs_max", "violation[:, 0].max"]  # fmt: skip
    study = lw.sweep(rod(), {"rod.mass": 1.0}, names, t_end=0.2, rtol=1e-6, processes=1)
    result = study.simulate(0)
    v, t = result.body("rod").velocity, result.t
    size = np.linalg.norm(v, axis=1)
    steps = np.diff(t)

    def mean(x: Any) -> float:
        return float(((x[1:] + x[:-1]) / 2 * steps).sum() / 0.2)

    expected = [size.max(), v[:, 2].min(), mean(size), np.sqrt(mean(size**2)), v[-1], np.ptp(v[:, 2]),
                np.abs(v[:, 2]).max(), result.violation[:, 0].max()]  # fmt: skip
    for name, value in zip(names, expected, strict=True):
        assert study.outputs[name][0] == pytest.approx(value, rel=1e-6), name
    assert np.ptp(steps) > 0  # the mean over frames would be another


def thrown() -> lw.Model:
    """A ball, upward at 5 m/s: largest height v^2 / 2 g, mean v T / 2 - g T^2 / 6."""
    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), velocity=(0, 0, 5.0))
    return model


@pytest.mark.parametrize("times", [None, [0.5, 1.0]])
@pytest.mark.parametrize("study", [True, False])
def test_long_steps_do_not_hide_what_is_largest_between_them(times: list[float] | None, study: bool) -> None:
    asked = {"highest": "body('ball').position.z.max", "mean": "body('ball').position.z.mean",
             "slowest": "kinetic_energy.min",
             "own": lambda result: result.body("ball").position[:, 2].max()}  # fmt: skip
    if times:
        asked["z"] = "body('ball').position.z"
    run: dict[str, Any] = {"rtol": 1e-8, "times": times, "progress": False}
    varied = {"ball.mass": [1.0]}
    if study:
        found = lw.sweep(thrown(), varied, asked, t_end=1.0, processes=1, **run).outputs
    else:
        found = dict(lw.simulate_many(thrown(), varied, 1.0, outputs=asked, **run).outputs)
    g = 9.81
    assert found["highest"][0] == pytest.approx(25 / (2 * g), rel=1e-5)
    assert found["own"][0] == pytest.approx(found["highest"][0], rel=1e-5)
    assert found["mean"][0] == pytest.approx(2.5 - g / 6, rel=1e-5)
    assert found["slowest"][0] == pytest.approx(0.0, abs=1e-4)
    if times:
        assert found["z"][0] == pytest.approx([2.5 - g / 8, 5.0 - g / 2], abs=1e-9)


def test_short_steps_do_not_fall_between_frames() -> None:
    model = thrown()  # a blow of 1 N s within 0.2 ms, between frames that are 1 ms apart
    blow = (0.5003, 0.5005)
    model.user_force(lambda t, q, v: [0, 0, 5e3 * (blow[0] < t < blow[1]), 0, 0, 0], "ball", breaks=blow)
    study = lw.sweep(lambda speed: model, {"speed": [5.0]}, "body('ball').acceleration.z.max", t_end=1.0,
                     rtol=1e-8, processes=1)  # fmt: skip
    assert study.outputs["body('ball').acceleration.z.max"][0] == pytest.approx(5e3 - 9.81, rel=1e-9)


@pytest.mark.parametrize("how", [{"step": 5e-3}, {"rtol": 1e-6}])
def test_arrays_are_at_the_times_that_are_given(how: dict[str, float]) -> None:
    times = [0.01, 0.035, 0.05]
    study = lw.sweep(rod(), {"rod.mass": [1, 2]}, ["body('rod').position"], t_end=0.05, times=times,
                     processes=1, **how)  # fmt: skip
    result = lw.simulate(rod(), 0.05, rtol=1e-10, times=[*times])
    assert study.outputs["body('rod').position"].shape == (2, 3, 3)
    assert study.outputs["body('rod').position"][0] == pytest.approx(result.body("rod").position, abs=1e-7)


def test_a_last_time_that_is_the_end_but_for_roundoff_is_the_end() -> None:
    times = [0.1 * k for k in range(4)]
    assert times[-1] > 0.3
    run = {**FEW, "t_end": 0.3}
    study = lw.sweep(rod(), {"rod.mass": [1]}, {"h": "body('rod').position.z"}, times=times, **run)
    last = lw.sweep(rod(), {"rod.mass": [1]}, {"h": "body('rod').position.z.final"}, **run).outputs["h"]
    assert study.times is not None and study.times[-1] == 0.3
    assert_array_equal(study.outputs["h"][:, -1], last)


def test_a_body_and_a_joint_of_one_name_are_told_apart_by_their_fields() -> None:
    model = lw.Model()
    model.body("elbow", mass=2.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute(model.ground, "elbow", at=(0, 0, 0), axis=(0, 1, 0), name="elbow")
    model.rotational_spring_damper(model.ground, "elbow", axis=(0, 1, 0), stiffness=1.0, name="elbow")
    load = "reaction('elbow').force.z.final"  # of a rod that begins to fall from level: m g J / (J + m l^2)
    study = lw.sweep(model, {"elbow.mass": [1.0, 3.0]}, load, t_end=1e-6, step=1e-6, processes=1)
    m = study.parameters["elbow.mass"]
    assert abs(study.outputs[load]) == pytest.approx(m * 9.81 * 0.1 / (0.1 + m / 4))
    assert Changed.of(model, ["elbow.stiffness"]).units(["elbow.stiffness"]) == {"elbow.stiffness": "N m/rad"}
    for path, words in (
        ("elbow.attachment", "'elbow' is a joint and a force element, which have a 'attachment' each"),
        (
            "elbow.mas",
            "is a body and a joint and a force element, and none has a 'mas'; the nearest is 'mass'",
        ),
    ):
        with pytest.raises(lw.OptionError, match=words):
            Changed.of(model, [path])


@pytest.mark.parametrize(
    "case",
    [
        {"rod.position": [0.6, 0, 0.2], "pin.at": [0.1, 0, 0.2]},
        {"pin.at": [0.1, 0, 0.2], "rod.position": [0.6, 0, 0.2]},
        {"rod.position[0]": 0.6, "rod.position[2]": 0.2, "pin.at[0]": 0.1, "pin.at[2]": 0.2},
    ],
)
def test_a_body_and_its_joint_are_moved_together(case: dict[str, Any]) -> None:
    height = "body('rod').position.z"
    study = lw.sweep(rod(), [case], f"{height}.range", t_end=0.2, step=2e-3, processes=1)
    still = lw.sweep(rod(), {"rod.mass": [1.0]}, f"{height}.range", t_end=0.2, step=2e-3, processes=1)
    assert Changed.of(rod(), list(case)).model(case).values("pin")["attachment"]["origin"] == [
        pytest.approx([0.1, 0, 0.2]), pytest.approx([-0.5, 0, 0])
    ]  # fmt: skip
    assert study.outputs[f"{height}.range"] == pytest.approx(still.outputs[f"{height}.range"], rel=1e-9)


def test_a_part_of_a_point_that_a_moved_body_has_elsewhere_is_refused() -> None:
    case = {"rod.position[2]": 0.2, "pin.at[0]": 0.1}
    with pytest.raises(lw.OptionError, match="'pin' has a point on each of its bodies"):
        Changed.of(rod(), list(case)).model(case)


def test_paths_lead_to_points_and_parts() -> None:
    model = rod()
    model.spring_damper(
        model.ground, "rod", at=((0, 0, 1), (1, 0, 0)), stiffness=10.0, damping=1.0, name="spring"
    )
    paths = {"pin.at[2]": 0.1, "spring.stiffness": 20.0, "rod.inertia[1]": 0.0835, "rod.omega": [0, 1, 0]}
    changed = Changed.of(model, list(paths)).model(paths)
    assert changed.values("spring")["stiffness"] == 20.0
    assert changed.values("rod")["inertia"] == [1e-3, 0.0835, 1 / 12]
    assert changed.values("rod")["omega"] == [0, 1, 0]
    assert changed.values("pin")["attachment"]["origin"] == [[0, 0, 0.1], [-0.5, 0, 0.1]]
    assert model.values("spring")["stiffness"] == 10.0
    with pytest.raises(lw.OptionError, match=r"'spring.at\[0\]': 'spring' has a point on each"):
        Changed.of(model, ["spring.at[0]"])


@pytest.mark.parametrize("of_driver", [{}, {"drive.at[1]": 0.5}])
def test_what_drives_a_joint_goes_with_it(of_driver: dict[str, float]) -> None:
    """Unless it is moved itself."""

    def hinge(y: float, y_driver: float) -> lw.Model:
        model = lw.Model()
        model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
        model.revolute("ground", "rod", at=(0, y, 0), axis=(0, 0, 1), name="pin")
        if y_driver == y:
            model.drive("pin", position=lw.functions.polynomial(0, 1), name="drive")
        else:
            law = lw.functions.polynomial(0, 1)
            model.angle_driver("ground", "rod", at=(0, y_driver, 0), axis=(0, 0, 1), angle=law, name="drive")
        return model

    case = {"pin.at[1]": 0.25, **of_driver}
    changed = Changed.of(hinge(0.0, 0.0), list(case)).model(case)
    assert changed.hash() == hinge(0.25, of_driver.get("drive.at[1]", 0.25)).hash()


def test_what_drives_two_joints_goes_with_both() -> None:
    """A coordinate of two hinges on one axis is that of either."""

    def hinges(y: float) -> lw.Model:
        model = lw.Model()
        model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
        for name in ("pin", "second"):
            model.revolute("ground", "rod", at=(0, y, 0), axis=(0, 0, 1), name=name)
        model.drive("pin", position=lw.functions.polynomial(0, 1), name="drive")
        return model

    case = {"pin.at[1]": 0.25, "second.at[1]": 0.25}
    changed = Changed.of(hinges(0.0), list(case))
    assert changed.model(case).hash() == hinges(0.25).hash()
    with pytest.raises(lw.ModelError, match=r"'drive': drives a coordinate of 'pin' and 'second', which go"):
        changed.model({**case, "second.at[1]": 0.5})


def test_studies_that_move_what_is_driven_gather_nothing_of_versions_that_left_drivers_behind() -> None:
    model = lw.Model()
    model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    free = Changed.of(model, ["pin.at[1]"]).identity(), Changed.of(model, ["rod.mass"]).identity()
    model.drive("pin", position=lw.functions.polynomial(0, 1), name="drive")
    moved, heavier = (Changed.of(model, [path]).identity() for path in ("pin.at[1]", "rod.mass"))
    assert free[0] == free[1] and moved != heavier


def test_the_point_that_is_on_a_curve_is_varied_in_space() -> None:
    """As it is given to the joint, though a file has it in coordinates of the body; here turned."""

    def bead(at: float) -> lw.Model:
        model = lw.Model(gravity=(-9.81, 0, 0))
        body = model.body("bead", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(1, 0.1, 0),
                          orientation=lw.rotation.about((0, 0, 1), 0.5))  # fmt: skip
        model.point_on_curve("ground", body, points=[(0, 0, 0), (3, 0, 0)], at=(at, 0, 0), name="rail")
        return model

    model = bead(1.2)
    assert Changed.of(model, ["rail.at"]).value("rail.at") == pytest.approx([1.2, 0, 0], abs=1e-15)
    study = lw.sweep(model, {"rail.at[0]": [1.2, 0.7]}, "final", **FEW)
    ensemble = lw.Ensemble(model, {"rail.at[0]": [1.2, 0.7]}).simulate(0.05, step=5e-3)
    for k, at in enumerate((1.2, 0.7)):
        alone = lw.simulate(bead(at), 0.05, step=5e-3)
        assert study.outputs["final.q"][k] == pytest.approx(alone.q[-1], abs=1e-13)
        assert ensemble.member(k).q[-1] == pytest.approx(alone.q[-1], abs=1e-13)
    assert study.units["rail.at[0]"] == "m"
    with pytest.raises(lw.OptionError, match="joint 'rail' has no 'frames'"):
        Changed.of(model, ["rail.frames"])


OWN = ["four_bar", "bricard", "spatial_slider_crank", "double_wishbone", "rolling_disc", "planetary_gear",
       "flyball_governor", "stewart_platform"]  # fmt: skip


@pytest.mark.parametrize("name", OWN)
def test_a_models_own_values_make_the_same_model(name: str) -> None:
    """By Model.hash, which has every bit of it."""
    model = lw.mechanisms.MECHANISMS[name].function()
    body = model.table("bodies")[-1]["name"]
    changed = Changed.of(model, [f"{body}.mass", f"{body}.velocity", "gravity[0]"])
    own = {path: changed.value(path) for path in changed.addresses}
    assert changed.model(own).hash() == model.hash()
    heavier = changed.model({**own, f"{body}.mass": 2 * own[f"{body}.mass"] + 1})
    assert heavier.hash() != model.hash()


def test_turns_of_the_model_are_not_lost_where_poses_are_varied() -> None:
    """A spring wound up by one turn pulls three times as much, or its study is refused."""
    model = lw.Model()
    body = model.body("wheel", mass=1.0, inertia=(1, 1, 1))
    model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    place: dict[str, Any] = {"at": (0, 0, 0), "axis": (0, 0, 1)}
    model.rotational_spring_damper(model.ground, body, **place, stiffness=1.0, damping=0.0, name="spring")
    wound = model.with_initial_state([[0, 0, 0, 1, 0, 0, 0]], np.zeros((1, 6)), [2 * np.pi])
    study = lw.sweep(wound, {"spring.stiffness": [1.0, 3.0]}, "force('spring').torque.z.abs_max", **FEW)
    assert study.outputs["force('spring').torque.z.abs_max"] == pytest.approx(
        [2 * np.pi, 6 * np.pi], rel=1e-12
    )
    with pytest.raises(lw.OptionError, match="begins with full turns"):
        lw.sweep(wound, {"spring.attachment.origin[0][2]": [1.0]}, "final", **FEW)


def test_a_function_of_time_is_varied_by_its_numbers() -> None:
    """A driver turns the rod by c t^2, of which c is varied."""
    model = rod()
    angle = lw.functions.polynomial(0.0, 0.0, 1.0)
    model.angle_driver(model.ground, "rod", at=(0, 0, 0), axis=(0, 1, 0), angle=angle, name="motor")
    study = lw.sweep(model, {"motor.angle.polynomial[2]": [0.4, 1.2]}, "coordinate('pin').value.final",
                     t_end=0.5, step=1e-3, processes=1, assemble=True)  # fmt: skip
    assert study.outputs["coordinate('pin').value.final"] == pytest.approx([0.1, 0.3], rel=1e-8)


# --- who computes it ---


def test_bits_do_not_depend_on_processes_executors_or_shards(tmp_path: Path) -> None:
    outputs = ["final", "reaction('pin').torque.max"]
    one = lw.sweep(rod(), GRID, outputs, **FEW)
    same(one, lw.sweep(rod(), GRID, outputs, **RUN, processes=2))
    with concurrent.futures.ThreadPoolExecutor(2) as threads:
        same(one, lw.sweep(rod(), GRID, outputs, **RUN, executor=threads))
    for shard in ((3, 3), (1, 3)):  # of arrays from 1
        part = lw.sweep(rod(), GRID, outputs, **FEW, directory=tmp_path, shard=shard)
        assert (part.status == "finished").sum() >= 2
    partly = lw.sweep(rod(), GRID, outputs, **RUN, directory=tmp_path, gather=True)
    assert Counter(partly.status.tolist()) == {"finished": 4, "skipped": 2}
    lw.sweep(rod(), GRID, outputs, **FEW, directory=tmp_path, shard=(2, 3))
    same(one, lw.sweep(rod(), GRID, outputs, **RUN, directory=tmp_path, gather=True))
    assert set(keys_in(tmp_path).values()) == {1}


def test_other_processes_of_an_executor_give_the_same_bits() -> None:
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=context) as pool:
        study = lw.sweep(rod(), {"rod.mass": [1, 2]}, "final", **RUN, executor=pool)
        with pytest.raises(lw.OptionError, match="cannot go to another process"):
            lw.sweep(rod(), {"rod.mass": [1]}, lambda result: 1.0, **RUN, executor=pool)
    same(study, lw.sweep(rod(), {"rod.mass": [1, 2]}, "final", **FEW))


def test_a_rerun_runs_what_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = lw.sweep(rod(), {"rod.mass": [1, 2]}, "final", **FEW, directory=tmp_path)
    before = keys_in(tmp_path)
    more = lw.sweep(rod(), {"rod.mass": [3, 1, 2]}, "final", **FEW, directory=tmp_path)
    assert len(keys_in(tmp_path) - before) == 1
    assert set(keys_in(tmp_path).values()) == {1}
    assert_array_equal(more.outputs["final.q"][1:], first.outputs["final.q"])
    damaged = next((tmp_path / "cases").glob("*.jsonl"))
    damaged.write_text(damaged.read_text().replace("finished", "finishes"))
    with pytest.warns(lw.LinkworkWarning, match="is damaged"):
        same(more, lw.sweep(rod(), {"rod.mass": [3, 1, 2]}, "final", **FEW, directory=tmp_path))
    for content in (b"\xff", b"[" * 100_000):
        damaged.write_bytes(content)
        with pytest.warns(lw.LinkworkWarning, match="is damaged"):
            same(more, lw.sweep(rod(), {"rod.mass": [3, 1, 2]}, "final", **FEW, directory=tmp_path))
    (tmp_path / "cases" / "a link to nowhere.jsonl").symlink_to(tmp_path / "nowhere")
    (tmp_path / "cases" / "a folder.jsonl").mkdir()
    with pytest.warns(lw.LinkworkWarning, match=r"(nowhere|folder)\.jsonl.*is damaged"):
        same(more, lw.sweep(rod(), {"rod.mass": [3, 1, 2]}, "final", **FEW, directory=tmp_path))


@pytest.mark.parametrize("content", [b"{}", b'{"identity": [1]}', b'{"identity": 1}', b"\xff", b"[" * 10**5])
def test_a_directory_that_does_not_say_what_it_holds_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "study.json").write_bytes(content)
    with pytest.raises(lw.FileError, match="its study.json is none of a study; give another directory"):
        lw.sweep(rod(), {"rod.mass": [1]}, "final", **FEW, directory=tmp_path)


def test_a_killed_process_takes_its_case_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    switch = tmp_path / "switch"
    switch.touch()
    monkeypatch.setenv("DYING", str(switch))
    masses = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]
    where = tmp_path / "study"
    study = lw.sweep(dying, {"mass": masses}, "final", **RUN, processes=2, directory=where)
    assert study.status.tolist() == ["finished", "finished", "failed", *["finished"] * 5]
    assert "SIGKILL" in study.errors[2]["message"]
    switch.unlink()
    whole = lw.sweep(dying, {"mass": masses}, "final", **RUN, processes=2, directory=where)
    assert (whole.status == "finished").all()
    assert len(keys_in(where)) == 8 and set(keys_in(where).values()) == {1}
    same(whole, lw.sweep(rod(), {"rod.mass": masses}, "final", **FEW))


def test_an_interrupted_study_keeps_what_is_done(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from linkwork.studies.store import Store

    keep = Store.keep

    def interrupted(store: Store, answer: Any) -> None:
        if keys_in(tmp_path):
            raise KeyboardInterrupt
        keep(store, answer)

    with monkeypatch.context() as patch:
        patch.setattr(Store, "keep", interrupted)
        with pytest.raises(KeyboardInterrupt) as caught:
            lw.sweep(rod(), GRID, "final", **FEW, directory=tmp_path)
    done = len(keys_in(tmp_path))
    assert f"{done} of 6 cases are done, and kept in '{tmp_path}'" in str(caught.value)
    assert f"the other {6 - done}" in str(caught.value) and done >= 1
    assert (lw.sweep(rod(), GRID, "final", **FEW, directory=tmp_path).status == "finished").all()
    assert set(keys_in(tmp_path).values()) == {1}


def test_an_interrupted_study_without_a_directory_says_that_it_is_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def interrupted(*_: Any) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr("linkwork.studies.chunks.in_processes", interrupted)
    with pytest.raises(KeyboardInterrupt, match="0 of 6 cases are done, and lost: give a directory"):
        lw.sweep(rod(), GRID, "final", **FEW)


def test_cases_of_the_same_values_count_as_often_as_they_are_there(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr("linkwork.studies.chunks.in_processes", interrupted)
    with pytest.raises(KeyboardInterrupt, match="0 of 5 cases are done"):
        lw.sweep(rod(), {"rod.mass": [1.0, 2.0, 1.0, 2.0, 1.0]}, "final", **FEW)


def test_a_broken_executor_says_so_and_leaves_a_study_that_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    switch, where = tmp_path / "switch", tmp_path / "study"
    switch.touch()
    monkeypatch.setenv("DYING", str(switch))
    masses = {"mass": [1.0, 2.0, 3.0, 4.0]}
    with (
        concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("fork")) as pool,
        pytest.raises(lw.LinkworkError, match="executor: works no more.*run the study again") as caught,
    ):
        lw.sweep(dying, masses, "final", **RUN, directory=where, executor=pool)
    assert caught.value.code == "executor"
    done = keys_in(where)
    switch.unlink()
    assert (lw.sweep(dying, masses, "final", **FEW, directory=where).status == "finished").all()
    assert done and not done - keys_in(where)
    assert set(keys_in(where).values()) == {1} and len(keys_in(where)) == 4


# --- what fails ---


def endless(result: lw.Result) -> float:
    """Where the mass is 3 kg."""
    while result.header.mass[0] == 3.0:
        time.sleep(0.01)
    return float(result.energy[-1])


def test_a_case_that_never_ends_is_given_up_after_its_time_and_takes_no_other_with_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also one that shares its task with others: of ten cases by one process the first goes alone."""
    monkeypatch.setattr("linkwork.studies.chunks.PATIENCE", 0.5)
    for masses in ([3.0, 1.0], [1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0]):
        study = lw.sweep(rod(), {"rod.mass": masses}, endless, **FEW, case_seconds=0.5, directory=tmp_path)
        assert [mass for mass, it in zip(masses, study.status, strict=True) if it == "failed"] == [3.0]
        assert study.errors[masses.index(3.0)]["message"] == "not done after 0.5 s"
    assert len(keys_in(tmp_path)) == 10  # it is not kept, and so tried again
    kept = lw.sweep(rod(), {"rod.mass": [1.0, 2.0]}, endless, **RUN, directory=tmp_path, gather=True)
    same(kept, lw.sweep(rod(), {"rod.mass": [1.0, 2.0]}, endless, **FEW))


def slow(result: lw.Result) -> float:
    """Where the mass is above 5 kg."""
    time.sleep(0.3 if result.header.mass[0] > 5.0 else 0.0)
    return 1.0


@pytest.mark.parametrize("processes", [1, 2, 5])
def test_a_time_limit_holds_for_each_case_however_they_are_shared_out(processes: int) -> None:
    masses = np.arange(1.0, 9.0)
    given: dict[str, Any] = {**FEW, "processes": processes}
    none = lw.sweep(rod(), {"rod.mass": masses}, "energy.max", **given, case_seconds=1e-9)
    assert none.status.tolist() == 8 * ["failed"]
    assert {error["message"] for error in none.errors.values()} == {"not done after 1e-09 s"}
    some = lw.sweep(rod(), {"rod.mass": masses}, slow, **given, case_seconds=0.25)
    assert some.status.tolist() == 5 * ["finished"] + 3 * ["failed"]


@pytest.mark.parametrize("value", [None, "text", [1.0, None], 1j])
def test_what_a_function_gives_that_is_no_number_is_no_output(value: Any) -> None:
    """NumPy would take None for NaN."""
    study = lw.sweep(rod(), {"rod.mass": [1.0]}, {"mine": lambda result: value}, **FEW)
    assert study.status.tolist() == ["failed"]
    assert "output 'mine': its function gives " in study.errors[0]["message"]


def test_what_a_function_masks_is_nan() -> None:
    def below(result: lw.Result) -> Any:
        return np.ma.masked_less([-1.0, 2.0], 0.0)

    def at(result: lw.Result) -> Any:
        return np.ma.masked_array(3, mask=True)

    study = lw.sweep(rod(), {"rod.mass": [1.0]}, [below, at], **FEW)
    assert_array_equal(study.outputs["below"], [[np.nan, 2.0]])
    assert_array_equal(study.outputs["at"], [np.nan])


@pytest.mark.parametrize("joint", ["'pin'", "name='pin'", "which='angle', name='pin'", "'pin', 'angle'"])
def test_a_coordinate_is_named_in_every_way_of_a_call(joint: str) -> None:
    output = f"coordinate({joint}).value.max"
    study = lw.sweep(rod(), {"rod.mass": [1.0]}, output, **FEW)
    assert study.outputs[output][0] == study.simulate(0).coordinate("pin").value.max() > 0
    assert study.units[output] == "rad"


class Silent(Exception):
    """It cannot say what it is."""

    def __str__(self) -> str:
        raise AttributeError("limit")


@pytest.mark.parametrize(("error", "message"), [
    (Silent(), "Silent"), (ValueError("x" * 3000), "x" * 2000 + " ... (3000 characters)"),
    (ValueError("of \udcff\n mine"), "of ? mine"),
    (MemoryError(), "MemoryError"), (ValueError(" "), "ValueError"),
])  # fmt: skip
def test_whatever_an_error_says_it_fails_one_case_and_goes_to_files(
    error: Exception, message: str, tmp_path: Path
) -> None:
    def build(k: int) -> lw.Model:
        if k == 1:
            raise error
        return rod()

    study = lw.sweep(build, {"k": [0, 1, 2]}, "energy.max", **FEW, directory=tmp_path / "kept")
    assert study.status.tolist() == ["finished", "failed", "finished"]
    assert study.errors[1]["message"] == message and study.errors[1]["reached"] is None
    study.to_csv(tmp_path / "study.csv")
    many = lw.simulate_many(build, {"k": [0, 1, 2]}, 0.05, 5e-3, outputs="energy.max", progress=False)
    assert many.errors == {1: study.errors[1]}


def test_failed_cases_are_kept_with_their_reason(tmp_path: Path) -> None:
    def fails(result: lw.Result) -> float:
        if result.header.mass[0] == 3.0:
            raise ZeroDivisionError("of mine")
        return 1.0

    study = lw.sweep(rod(), {"rod.mass": [1, -2, 3, 4]}, {"one": fails}, **FEW, directory=tmp_path)
    assert study.status.tolist() == ["finished", "failed", "failed", "finished"]
    assert study.errors[1]["type"] == "ModelError"
    assert "mass" in study.errors[1]["message"]
    assert study.errors[2]["type"] == "ZeroDivisionError"
    assert_array_equal(study.outputs["one"], [1, np.nan, np.nan, 1])
    again = lw.sweep(rod(), {"rod.mass": [1, -2, 3, 4]}, {"one": fails}, **FEW, directory=tmp_path)
    same(study, again)
    assert again.errors[1] == study.errors[1]


def from_file(mass: float) -> lw.Model:
    """Of 2 kg and more only where the file is there; never of 4 kg."""
    if mass == 4.0 or (mass >= 2.0 and not Path(os.environ["NEEDED"]).exists()):
        raise OSError("the file is missing")
    return rod().replaced("rod", mass=mass)


@pytest.mark.parametrize("masses", [[1.0, 2.0, 3.0, 4.0], [2.0, 1.0, 3.0, 4.0]])
def test_cases_that_failed_are_tried_again_where_that_is_wanted(
    masses: list[float], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    needed, where = tmp_path / "needed", tmp_path / "study"
    monkeypatch.setenv("NEEDED", str(needed))

    def found(**how: Any) -> lw.Study:
        more = {} if how.get("gather") else {"processes": 1}
        return lw.sweep(from_file, {"mass": masses}, "final", **RUN, **more, directory=where, **how)

    expected = ["finished" if mass == 1.0 else "failed" for mass in masses]
    assert found().status.tolist() == expected
    needed.touch()
    assert found().status.tolist() == expected
    part = found(retry=True, shard=(2, 4))  # the third of them: the others are what they were
    assert part.status.tolist() == [*expected[:2], "finished", "failed"]
    again = found(retry=True)
    assert again.status.tolist() == [*["finished"] * 3, "failed"] and set(again.errors) == {3}
    for study in (found(), found(gather=True)):  # whichever of two tries is read first
        same(study, again)
        assert set(study.errors) == {3}
    same(again, lw.sweep(from_file, {"mass": masses}, "final", **FEW))


def test_a_run_that_is_interrupted_amid_failed_cases_counts_them_as_open(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lw.sweep(rod(), {"rod.mass": [-1.0, -2.0, 1.0]}, "final", **FEW, directory=tmp_path)

    def interrupted(*_: Any) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr("linkwork.studies.chunks.in_processes", interrupted)
    with pytest.raises(KeyboardInterrupt, match="0 of 2 cases are done, and kept in"):
        lw.sweep(rod(), {"rod.mass": [-1.0, -2.0, 1.0]}, "final", **FEW, directory=tmp_path, retry=True)


def test_a_run_that_fails_says_how_far_it_came() -> None:
    def stiff(speed: float) -> lw.Model:
        return rod(speed=speed)

    study = lw.sweep(stiff, {"speed": [0.0, 30.0]}, "final", t_end=0.5, step=0.05, processes=1,
                     on_violation="stop", violation_limit=1e-2)  # fmt: skip
    assert study.status.tolist() == ["finished", "failed"]
    assert study.errors[1]["type"] == "ViolationError"
    assert 0 < study.errors[1]["reached"] <= 0.5


def test_arrays_of_a_function_that_differ_in_shape_are_failures() -> None:
    study = lw.sweep(rod(), {"rod.mass": [1, 2]}, {"it": lambda it: np.ones(int(it.header.mass[0]))}, **FEW)
    assert study.status.tolist() == ["finished", "failed"]
    assert "shape (2,), not (1,)" in study.errors[1]["message"]
    assert np.isnan(study.accuracy[1]) and study.verdict.tolist() == ["good", ""]


def test_an_inaccurate_case_has_its_verdict() -> None:
    study = lw.sweep(rod(speed=20.0), {"rod.mass": [1]}, "final", t_end=1.0, step=0.1, processes=1)
    assert study.verdict[0] in ("coarse", "wrong")
    assert study.accuracy[0] > 0.01


def slowed(mass: float) -> lw.Model:
    """A slider, slowed by what its law remembers of its speed."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=mass, inertia=(0.02, 0.03, 0.04), velocity=(1, 0, 0))
    model.translational("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), name="s")
    last = [0.0]

    def filtered(t: float, x: float, speed: float) -> float:
        last[0] = 0.9 * last[0] + 0.1 * speed
        return -5.0 * last[0]

    model.joint_force("s", filtered, name="filter")
    return model


@pytest.mark.parametrize("outputs", [None, "final", "velocity.max"])
@pytest.mark.parametrize("study", [True, False])
def test_laws_that_remember_calls_are_told_once_and_of_each_case(outputs: str | None, study: bool) -> None:
    def found(**more: Any) -> Any:
        if study:
            asked = outputs or "body('b').velocity.x.final"
            return lw.sweep(slowed, {"mass": [1.0, 2.0]}, asked, **FEW, **more)
        run = {key: it for key, it in RUN.items() if key != "t_end"}
        return lw.simulate_many(slowed, {"mass": [1.0, 2.0]}, RUN["t_end"], outputs=outputs, **run, **more)

    with pytest.warns(lw.LinkworkWarning, match="'filter': remembers calls") as told:
        it = found()
    assert len(told) == 1
    assert all("'filter': remembers calls" in it.remarks[k] for k in (0, 1))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found(on_inaccurate="pass")


def in_a_list() -> tuple[Any, Any]:
    held = [0.0]

    def put(value: float) -> None:
        held[0] = value

    return put, lambda t, angle, rate: held[0]


def in_an_array() -> tuple[Any, Any]:
    held = np.zeros(1)

    def put(value: float) -> None:
        held[0] = value

    return put, lambda t, angle, rate: held[0]


def in_a_mapping() -> tuple[Any, Any]:
    held = {"effort": 0.0}

    def put(value: float) -> None:
        held["effort"] = value

    return put, lambda t, angle, rate: held["effort"]


def in_a_variable() -> tuple[Any, Any]:
    held = 0.0

    def put(value: float) -> None:
        nonlocal held
        held = value

    return put, lambda t, angle, rate: held


HELD = 0.0


def in_a_global_variable() -> tuple[Any, Any]:
    def put(value: float) -> None:
        global HELD
        HELD = value

    put(0.0)
    return put, lambda t, angle, rate: HELD


def in_an_attribute() -> tuple[Any, Any]:
    held = types.SimpleNamespace(effort=0.0)

    def put(value: float) -> None:
        held.effort = value

    return put, lambda t, angle, rate: held.effort


def sampled(where: Any) -> tuple[Any, lw.Event, Any]:
    """A bar that a controller lifts, by samples every 20 ms, and the event that takes them."""
    put, law = where()

    def build(mass: float) -> lw.Model:
        model = lw.Model()
        bar = model.body("bar", mass=mass, inertia=(0.003, 0.03, 0.03), position=(0, 0, -0.3))
        model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
        model.joint_force("hinge", law)
        return model

    def sample(t: float, state: Any) -> None:
        bar = state.body("bar")
        angle = 2 * np.arctan2(bar.orientation[2], bar.orientation[0])
        put(20.0 * (1.0 - angle) - 3.0 * bar.omega[1])

    return build, lw.Event(lambda t, state: np.sin(np.pi * t / 0.02), "clock", change=sample), law


@pytest.mark.parametrize(
    ("where", "how"),
    [
        *((in_a_list, how) for how in ("ensemble", "lanes", "alone", "threads")),
        (in_an_array, "ensemble"),
        (in_a_mapping, "ensemble"),
        (in_a_variable, "ensemble"),
        (in_a_global_variable, "ensemble"),
        (in_an_attribute, "ensemble"),
    ],
)
def test_no_case_goes_on_with_what_events_of_another_remember(where: Any, how: str) -> None:
    masses = [1.0, 0.5, 2.0, 1.5]
    run: dict[str, Any] = {"rtol": 1e-8, "step": 0.01}

    def single(mass: float) -> float:
        build, clock, _ = sampled(where)
        result = lw.simulate(
            build(mass), 0.11, **run, events=clock, deterministic=how in ("ensemble", "lanes")
        )
        assert len(result.events) == 5
        return float(result.coordinate("hinge").value[-1])

    expected, name = [single(mass) for mass in masses], "coordinate('hinge').value.final"
    build, clock, law = sampled(where)
    if how == "ensemble":
        found: Any = lw.simulate_many(build, {"mass": masses}, 0.11, outputs=[name], events=clock, **run)
        assert "remember" in found.alone[0]
    else:
        others = (
            {"executor": concurrent.futures.ThreadPoolExecutor(4)} if how == "threads" else {"processes": 1}
        )
        more: dict[str, Any] = {**others, **({} if how == "lanes" else {"deterministic": False})}
        found = lw.sweep(
            build, {"mass": masses}, name, t_end=0.11, events=clock, progress=False, **run, **more
        )
    assert found.outputs[name] == pytest.approx(expected, rel=1e-12)
    assert law(0.0, 0.0, 0.0) == 0.0


@pytest.mark.parametrize("more", [{}, {"deterministic": False}])
def test_threads_keep_the_remarks_of_their_own_cases(more: dict[str, Any]) -> None:
    def doubtful(result: lw.Result) -> float:
        time.sleep(0.005)
        height = float(result.body("ball").position[-1, 2])
        if height > 0.15:
            warnings.warn("high up", stacklevel=1)
        return height

    speeds, before = [1.0, 5.0] * 8, warnings.showwarning
    cases = [{"ball.velocity": [0.0, 0.0, speed], "ball.mass": 1.0 + k} for k, speed in enumerate(speeds)]
    with concurrent.futures.ThreadPoolExecutor(4) as threads:
        study = lw.sweep(thrown(), cases, {"height": doubtful}, executor=threads, **RUN, **more)
    assert study.remarks == {k: "high up" for k in range(1, 16, 2)}
    assert warnings.showwarning is before


def test_a_function_counts_what_events_of_its_own_case_left() -> None:
    hits = [0]

    def count(t: float, state: Any) -> None:
        hits[0] += 1

    low = lw.Event(lambda t, state: state.body("ball").position[2] - 1.0, "low", change=count)
    asked = {"hits": lambda result: hits[0]}
    for found in (
        lw.simulate_many(thrown(), {"ball.mass": [1.0, 2.0]}, 1.0, rtol=1e-6, events=low, outputs=asked),
        lw.sweep(thrown(), {"ball.mass": [1.0, 2.0]}, asked, t_end=1.0, rtol=1e-6, events=low, processes=1),
    ):
        assert found.outputs["hits"].tolist() == [2.0, 2.0]  # up and down


def test_memory_that_cannot_be_given_back_is_told() -> None:
    numbers = iter(range(100))
    change = lw.Event(lambda t, state: t - 0.5, "next", change=lambda t, state: bool(next(numbers) > 50))
    with pytest.warns(
        lw.LinkworkWarning, match="change of event next, 1': what it remembers cannot be given"
    ):
        lw.simulate_many(thrown(), {"ball.mass": [1.0, 2.0]}, 1.0, rtol=1e-6, events=change, outputs="final")


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"parameters": {"rot.mass": [1]}}, lw.OptionError, "no body, joint or force element 'rot'.*'rod'"),
        ({"parameters": {"rod.mas": [1]}}, lw.OptionError, "body 'rod' has no 'mas'.*'mass'"),
        ({"parameters": {"gravity[3]": [1]}}, lw.OptionError, "indices are 0 to 2"),
        ({"parameters": {"rod.position": [1.0]}}, lw.OptionError, r"shape \(\), not \(3,\)"),
        ({"parameters": {"rod.mass": [[1, 2]]}}, lw.OptionError, r"shape \(2,\), not \(\)"),
        ({"parameters": {"rod.mass": ["heavy"]}}, lw.OptionError, "not made of finite numbers"),
        ({"parameters": {"gravity": [[0, 0, 1]], "gravity[2]": [1]}}, lw.OptionError, "same value"),
        ({"parameters": {"pin.at[2]": [0], "pin.attachment.origin[0]": [0]}}, lw.OptionError, "same"),
        ({"parameters": {"pin.attachment.origin[0]": [0], "pin.at[2]": [0]}}, lw.OptionError, "same"),
        ({"parameters": {"rod.mass": []}}, lw.OptionError, "'rod.mass': has no values, so there is no case"),
        ({"parameters": {}}, lw.OptionError, "no case"),
        ({"parameters": [{"rod.mass": 1}, {}]}, lw.OptionError, "case 1 and case 0 differ in 'rod.mass'"),
        ({"parameters": {"rod.mass": (1, 2)}, "sampler": "sobol", "cases": 4}, lw.OptionError, "give a seed"),
        ({**RANDOM, "parameters": {"rod.mass": (2, 1)}}, lw.OptionError, r"reversed: give \(1, 2\)"),
        ({**RANDOM, "parameters": {"rod.mass": (2, 2)}}, lw.OptionError, r"\(2, 2\) are equal"),
        ({**RANDOM, "parameters": {"rod.mass": (1, 2, 3)}}, lw.OptionError, r"no pair \(low, high\)"),
        ({**RANDOM, "cases": 0}, lw.OptionError, "cases 0"),
        ({**RANDOM, "cases": None}, lw.OptionError, "cases is missing"),
        ({"sampler": "sobel"}, lw.OptionError, "sampler 'sobel'.*'sobol'"),
        ({"outputs": ["energi.max"]}, lw.OptionError, "no quantity 'energi'.*'energy'"),
        ({"outputs": ["reaction('pim').force.max"]}, lw.OptionError, "'pim'.*'pin'"),
        ({"outputs": ["reaction('pin').forse.max"]}, lw.OptionError, "'forse'.*'force'"),
        ({"outputs": ["reaction('pin').force.final.x"]}, lw.OptionError, "'final' is .*: it comes last"),
        ({"outputs": ["reaction('pin').power.max"]}, lw.OptionError, "choose from 'force', 'torque'$"),
        ({"outputs": ["reactions.force.max"]}, lw.OptionError, r"is written reactions\(\)"),
        ({"outputs": ["reactions('pin').force.max"]}, lw.OptionError, r"is written reactions\(\)"),
        ({"outputs": ["energy"]}, lw.OptionError, "array over time"),
        ({"outputs": ["energy.maximum"]}, lw.OptionError, "'maximum'"),
        ({"outputs": ["__import__('os')"]}, lw.OptionError, "no quantity"),
        ({"outputs": []}, lw.OptionError, "outputs"),
        ({"outputs": "body('rod').position.z[::2]", "times": [0.05]}, lw.OptionError, r"z\[::2\]': .*times="),
        ({"outputs": "body('rod').position.z[:3].final"}, lw.OptionError, "add one of .max"),
        ({"outputs": "body('rod').position[..., -1:, 2].max"}, lw.OptionError, "among the frames"),
        ({"outputs": "energy[[0]].max"}, lw.OptionError, "among the frames"),
        ({"outputs": "energy[None].max"}, lw.OptionError, "among the frames"),
        ({"times": [0.001]}, lw.OptionError, "between the frames"),
        ({"times": [9.0]}, lw.OptionError, "ascending"),
        ({"stepp": 1}, lw.OptionError, "'stepp'.*'step'"),
        ({"output": "a.h5"}, lw.OptionError, "Study.simulate"),
        ({"formulation": "none"}, lw.OptionError, "formulation"),
        ({"integrator": "rk5"}, lw.OptionError, "'rk5'.*'rk"),
        ({"integrator": "rk4", "step": None, "rtol": 1e-6}, lw.OptionError, "error estimate"),
        ({"on_inaccurate": "cry"}, lw.OptionError, "'cry'"),
        ({"events": 3}, lw.LinkworkError, "vent"),
        ({"outputs": {"rod.mass": "energy.max"}}, lw.OptionError, "'rod.mass': is the name of a parameter"),
        ({"outputs": {"status": "energy.max"}}, lw.OptionError, "column that every study has"),
        ({"step": -1.0}, lw.OptionError, "step"),
        ({"seed": 3}, lw.OptionError, "seed 3: nothing is drawn of a grid"),
        ({"parameters": [{"rod.mass": 1}], "seed": 3}, lw.OptionError, "seed 3: nothing is drawn of a table"),
        ({"cases": 3}, lw.OptionError, "cases 3: nothing is drawn of a grid"),
        ({"parameters": {"rod": [1]}}, lw.OptionError, "'rod': is a whole body: name one .*: 'rod.mass'"),
        ({"times": [0.05]}, lw.OptionError, "no output is an array over time"),
        ({"case_seconds": 0}, lw.OptionError, "case_seconds"),
        ({"case_seconds": 1, "executor": ANY, "processes": None}, lw.OptionError, "cannot be kept in"),
        ({"gather": True, "directory": "x"}, lw.OptionError, "processes 1: gather runs no case"),
        ({"retry": True}, lw.OptionError, "retry needs a directory"),
        ({"retry": 1}, lw.OptionError, "retry 1 is not True or False"),
        ({"gather": True, "directory": "x", "processes": None}, lw.FileError, "'x': there is no study to"),
        ({"shard": (1, 2)}, lw.OptionError, "directory"),
        ({"shard": (3, 2), "directory": "x"}, lw.OptionError, "shard"),
        ({"executor": 3, "processes": None}, lw.OptionError, "executor"),
        ({"model": rod}, lw.OptionError, "function rod does not take"),
        ({"model": 3}, lw.ModelError, "linkwork.Model"),
        ({"parameters": {"rod.mass": [1.0, np.nan]}}, lw.OptionError, "nan of case 1 is not made of finite"),
        ({"parameters": {"gravity[2]": [np.inf]}}, lw.OptionError, "inf of case 0 is not made of finite"),
    ],
)  # fmt: skip
def test_wrong_input_is_refused_before_the_first_case(
    change: dict[str, Any], error: type[Exception], message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("linkwork.studies.cases.simulate", lambda *_, **__: pytest.fail("a case was run"))
    given = {"model": rod(), "parameters": {"rod.mass": [1]}, "outputs": "final", **FEW, **change}
    with pytest.raises(error, match=message):
        lw.sweep(given.pop("model"), given.pop("parameters"), given.pop("outputs"), **given)


def test_a_directory_of_another_study_is_refused(tmp_path: Path) -> None:
    lw.sweep(rod(), {"rod.mass": [1]}, "final", **FEW, directory=tmp_path / "a")
    for change in ({"t_end": 0.1}, {"step": 1e-2}, {"outputs": "energy.max"}, {"model": rod(2.0)},
                   {"parameters": {"gravity[2]": [1]}}):  # fmt: skip
        usual: dict[str, Any] = {"model": rod(), "parameters": {"rod.mass": [1]}, "outputs": "final"}
        given: dict[str, Any] = {**usual, **FEW, **change}
        with pytest.raises(lw.FileError, match="holds a study with (another|other)"):
            lw.sweep(given.pop("model"), given.pop("parameters"), given.pop("outputs"), **given,
                     directory=tmp_path / "a")  # fmt: skip
    with pytest.raises(
        lw.FileError, match="other options: integrator none, not 'rk4'; step 0.005, not 0.01;"
    ):
        lw.sweep(rod(), {"rod.mass": [1]}, "final", **{**FEW, "step": 0.01}, integrator="rk4",
                 directory=tmp_path / "a")  # fmt: skip
    (tmp_path / "c" / "cases").mkdir(parents=True)  # one who begins it now comes so far
    (tmp_path / "c" / ".study.json.1f").touch()
    lw.sweep(rod(), {"rod.mass": [1]}, "final", **FEW, directory=tmp_path / "c")
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "diary.txt").touch()
    with pytest.raises(lw.FileError, match="something else than a study"):
        lw.sweep(rod(), {"rod.mass": [1]}, "final", **FEW, directory=tmp_path / "b")


def test_a_function_that_builds_something_else_now_is_refused(tmp_path: Path) -> None:
    length = tmp_path / "length"

    def build(mass: float) -> lw.Model:
        return rod(float(length.read_text())).replaced("rod", mass=mass)

    length.write_text("1.0")
    lw.sweep(build, {"mass": [1.0]}, "final", **FEW, directory=tmp_path / "study")
    length.write_text("2.0")
    with pytest.raises(lw.FileError, match="the function build built another model of .*'mass': 1.0"):
        lw.sweep(build, {"mass": [2.0]}, "final", **FEW, directory=tmp_path / "study")


class Scaled:
    def __init__(self, factor: float) -> None:
        self.factor = factor

    def of(self, result: lw.Result) -> float:
        return self.factor

    def __call__(self, result: lw.Result) -> float:
        return self.factor


def scaled() -> float:
    return FACTOR * 1.0


def read_from_module(result: lw.Result) -> float:
    return scaled() + OFFSET["x"] + OBJECT.factor


FACTOR, OFFSET, OBJECT = 1.0, {"x": 1.0}, Scaled(1.0)


@pytest.mark.parametrize("output", ["method", "object", "FACTOR", "OFFSET", "OBJECT"])
def test_an_output_that_says_something_else_now_is_refused(
    output: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By what its object or its module holds: its code is the same."""

    def study(factor: float) -> float:
        functions: dict[str, Any] = {"method": Scaled(factor).of, "object": Scaled(factor)}
        now: Any = {"FACTOR": factor, "OFFSET": {"x": factor}, "OBJECT": Scaled(factor)}
        if output in now:
            monkeypatch.setitem(globals(), output, now[output])
        outputs = {"it": functions.get(output, read_from_module)}
        return float(lw.sweep(rod(), {"rod.mass": [1]}, outputs, **FEW, directory=tmp_path).outputs["it"][0])

    first = study(1.0)
    assert study(1.0) == first
    with pytest.raises(lw.FileError, match="holds a study with other outputs"):
        study(2.0)


def test_a_function_is_asked_once_for_a_model_before_the_cases_and_once_by_a_directory(
    tmp_path: Path,
) -> None:
    asked: list[float] = []

    def build(length: float) -> lw.Model:
        asked.append(length)
        return rod(length)

    workers = {"executor": concurrent.futures.ThreadPoolExecutor(1)}  # of this process
    lw.sweep(build, {"length": [1.0, 2.0, 3.0]}, "final", **RUN, **workers)
    assert sorted(asked) == [1.0, 1.0, 2.0, 3.0]
    asked.clear()
    lw.sweep(build, {"length": [1.0, 2.0, 3.0]}, "final", **RUN, **workers, directory=tmp_path)
    assert sorted(asked) == [1.0, 1.0, 1.0, 2.0, 3.0]  # is it the model that the directory was begun with?


def test_a_function_that_builds_at_random_is_no_study_that_can_be_kept(tmp_path: Path) -> None:
    def build(mass: float) -> lw.Model:
        return rod().replaced("rod", mass=mass * (1.0 + np.random.default_rng().random()))

    with pytest.raises(lw.FileError, match=r"build built another model of .* or is random"):
        lw.sweep(build, {"mass": [1.0]}, "final", **FEW, directory=tmp_path)


GAINS = np.array([[0.1, 0.2], [0.3, 0.4]])


def at_height(z: float) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, z))
    return model


@pytest.mark.parametrize(("read", "given", "heights"), [
    (lambda it: GAINS[it].sum(), [(0, 1), [0, 1]], [0.2, 1.0]),  # one entry of the array, two rows of it
    (lambda it: len(2 * it), [np.array([1.0, 2.0]), [1.0, 2.0]], [2, 4]),
    (lambda it: it.dot(it), np.array([[1.0, 2.0], [3.0, 4.0]]), [5, 25]),
    (lambda it: it * np.int8(2), [np.int64(100), np.int16(50)], [200, 100]),
    (lambda it: it["rows"].sum(), [{"rows": np.ones(2)}], [2]),
])  # fmt: skip
def test_a_function_that_builds_gets_what_was_given(
    read: Any, given: Any, heights: list[float], tmp_path: Path
) -> None:
    """With the same model as by itself, also from a directory that keeps numbers and lists."""
    z, built = "body('body').position.z.max", []

    def build(it: Any) -> lw.Model:
        built.append(it)
        return at_height(float(read(it)))

    assert [build(it).compiled().q0[2] for it in given] == pytest.approx(heights)
    for _ in range(2):
        study = lw.sweep(build, [{"it": it} for it in given], z, **FEW, directory=tmp_path)
        assert study.outputs[z] == pytest.approx(heights)
        assert [study.simulate(k).position[0, 0, 2] for k in range(len(given))] == pytest.approx(heights)
    assert [type(it) for it in built[: len(given)]] == [type(it) for it in given]


def test_a_builder_that_changes_what_it_is_given_changes_no_other_case() -> None:
    def build(at: Any) -> lw.Model:
        at *= 2.0
        return at_height(at[2])

    given = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 2.0]])
    study = lw.sweep(build, [{"at": row} for row in given], "body('body').position.z.max", **FEW)
    assert study.simulate(0).position[0, 0, 2] == study.simulate(0).position[0, 0, 2] == 2.0
    assert study.outputs["body('body').position.z.max"].tolist() == [2.0, 4.0]
    assert given[:, 2].tolist() == study.parameters["at"][:, 2].tolist() == [1.0, 2.0]


def test_of_values_that_a_file_does_not_tell_apart_the_first_model_is_compared_too(tmp_path: Path) -> None:
    length = tmp_path / "length"

    def build(index: Any) -> lw.Model:
        return at_height(float(length.read_text()) * GAINS[index].sum())

    length.write_text("1.0")
    lw.sweep(build, [{"index": (0, 1)}], "final", **FEW, directory=tmp_path / "study")
    lw.sweep(build, [{"index": [0, 1]}], "final", **FEW, directory=tmp_path / "study")
    length.write_text("2.0")
    with pytest.raises(lw.FileError, match="the function build built another model"):
        lw.sweep(build, [{"index": (0, 1)}], "final", **FEW, directory=tmp_path / "study")


def test_a_study_goes_on_whatever_holds_the_numbers_of_its_model_and_options(tmp_path: Path) -> None:
    def study(number: Any, whole: Any, rows: Any) -> lw.Study:
        model = lw.Model(gravity=rows([0, 0, -9.81]))
        model.body("rod", mass=number(1.0), inertia=rows([1.0, 1.0, 1.0]), position=rows([0.5, 0, 0]))
        model.revolute("ground", "rod", at=rows([0, 0, 0]), axis=rows([0, 1, 0]), name="pin")
        model.joint_force("pin", lambda t, angle, rate: -rate, breaks=rows([0.01]))
        return lw.sweep(model, {"rod.mass": rows([1.0, 2.0])}, "final", t_end=0.02, step=number(5e-3),
                        record_every=whole(2), processes=1, progress=False, directory=tmp_path)  # fmt: skip

    first = study(float, int, tuple)
    for number, whole, rows in ((float, int, list), (np.float64, int, np.array)):
        assert study(number, whole, rows).seconds.tolist() == first.seconds.tolist()  # of those that ran then


@pytest.mark.parametrize("given", [[True, 2], [1, "1"], [2**53 + 1, 2**53, 0.5]])
def test_parameters_of_several_kinds_stay_apart_in_the_table(given: list[Any]) -> None:
    def build(choice: Any) -> lw.Model:
        return rod()

    study = lw.sweep(build, {"choice": given}, "final", **FEW)
    assert len(set(study.parameters["choice"].tolist())) == len(given)
    assert study.parameters["choice"].dtype.kind == "U"


@pytest.mark.parametrize("value", [2.0, np.float64(2.0), np.array(2.0)])
def test_a_single_value_is_a_list_of_one(value: Any) -> None:
    study = lw.sweep(rod(), {"rod.mass": value}, "energy.final", **FEW)
    assert study.parameters["rod.mass"].tolist() == [2.0] and study.status.tolist() == ["finished"]


def test_machines_of_other_instruction_sets_are_told(tmp_path: Path) -> None:
    lw.sweep(rod(), {"rod.mass": [1.0]}, "final", **FEW, directory=tmp_path)
    (file,) = (tmp_path / "cases").iterdir()
    head, body = file.read_text().split("\n", 1)
    other = {**json.loads(head), "machine": {"cpu": "another", "instruction_set": "aarch64"}}
    file.write_text(json.dumps(other) + "\n" + body)
    with pytest.warns(lw.LinkworkWarning, match="several instruction sets took part .*aarch64"):
        study = lw.sweep(rod(), {"rod.mass": [1, 2]}, "final", **FEW, directory=tmp_path)
    assert study.manifest["machines"][0]["cpu"] == "another"


# --- samplers and tables ---


def test_samplers_fill_their_bounds_and_repeat_by_their_seed() -> None:
    from linkwork.studies.sampling import cases_of
    from scipy import stats
    from scipy.stats import qmc

    bounds = {"a": (1.0, 3.0), "b": stats.norm(5.0, 0.1)}
    for sampler in ("random", "sobol", "halton", "latin_hypercube", qmc.Sobol(2, seed=7)):
        seed = 7 if isinstance(sampler, str) else None
        found = cases_of(bounds, sampler, 256, seed)
        a, b = np.array(found.columns["a"]), np.array(found.columns["b"])
        assert 1 <= a.min() < 1.1 and 2.9 < a.max() <= 3
        assert stats.kstest(b, stats.norm(5.0, 0.1).cdf).pvalue > 1e-3
        assert found.columns == cases_of(bounds, sampler, 256, seed).columns
        if isinstance(sampler, str):
            assert found.columns != cases_of(bounds, sampler, 256, 8).columns
    fewer = cases_of({"b": bounds["b"]}, None, 100, 7)  # distributions alone mean random
    assert fewer.columns["b"] == cases_of(bounds, "random", 256, 7).columns["b"][:100]
    with pytest.raises(lw.OptionError, match=r"'b': is a distribution: give a seed"):
        cases_of(bounds, "random", 4, None)
    with pytest.raises(lw.OptionError, match="has no seed"):
        cases_of(bounds, qmc.Halton(2), 4, None)
    with pytest.raises(lw.OptionError, match="seed 3: an engine of scipy.stats.qmc has its own"):
        cases_of(bounds, qmc.Halton(2, seed=7), 4, 3)
    with pytest.warns(lw.LinkworkWarning, match="cases 5: The balance properties of Sobol"):
        cases_of(bounds, "sobol", 5, 7)


def test_distributions_of_every_kind_have_their_quantiles() -> None:
    from linkwork.studies.sampling import cases_of
    from scipy import stats

    def drawn(given: Any) -> Any:
        return np.array(cases_of({"x": given}, None, 400, 3).columns["x"])

    u = drawn(stats.uniform())
    histogram = stats.rv_histogram(np.histogram([1, 2, 2, 3.0], bins=3))
    assert_array_equal(drawn(histogram), histogram.ppf(u))
    if hasattr(stats, "Normal"):  # of SciPy 1.15
        assert_array_equal(drawn(stats.Normal(mu=2.0, sigma=0.5)), stats.Normal(mu=2.0, sigma=0.5).icdf(u))
        gamma = stats.make_distribution(stats.gamma)(a=2.0)
        assert drawn(gamma) == pytest.approx(stats.gamma(2.0).ppf(u), rel=1e-12)
        with pytest.raises(lw.OptionError, match=r"Normal is a distribution without its numbers: .*mu=1.0"):
            drawn(stats.Normal)
    with pytest.raises(lw.OptionError, match=r"norm is a distribution without its numbers: .*loc=1.0"):
        drawn(stats.norm)
    with pytest.raises(lw.OptionError, match=r"cases 4: nothing is drawn of a grid.*ppf or icdf"):
        cases_of({"x": stats.gaussian_kde([1.0, 2.0, 3.0])}, None, 4, 1)


def test_whole_numbers_of_discrete_distributions_are_integers(tmp_path: Path) -> None:
    """Which count what a function builds, in a directory, too; fractions stay what they are."""
    from linkwork.studies.sampling import cases_of
    from scipy import stats

    def build(n: int) -> lw.Model:
        return lw.mechanisms.chain(n)

    drawn: Any = {"n": stats.randint(1, 4), "k": stats.Binomial(n=3, p=0.5), "l": stats.poisson(3.0, loc=1)}
    found = cases_of(drawn, None, 50, 1)
    assert {type(value) for values in found.columns.values() for value in values} == {int}
    assert set(found.columns["n"]) == {1, 2, 3}
    for fractions in (stats.randint(1, 3, loc=0.5), stats.rv_discrete(values=([1, 2.5], [0.9, 0.1]))):
        assert {type(it) for it in cases_of({"x": fractions}, None, 50, 1).columns["x"]} == {float}
    study = [
        lw.sweep(
            build,
            {"n": drawn["n"]},
            "energy_error.abs_max",
            **RUN,
            cases=4,
            seed=1,
            directory=tmp_path,
            gather=again,
        )
        for again in (False, True)
    ]
    assert study[1].parameters["n"].dtype == study[0].parameters["n"].dtype == int
    assert study[1].status.tolist() == ["finished"] * 4


def test_a_function_that_builds_nothing_is_told_with_its_case() -> None:
    def build(n: float, name: str) -> lw.Model:
        raise TypeError("no such thing")

    with pytest.raises(TypeError, match="no such thing") as caught:
        lw.sweep(build, {"n": [2.5, 3.5], "name": ["a"]}, "final", **FEW)
    assert caught.value.__notes__ == ["sweep: the model of case 0, n = 2.5, name = 'a'"]


def test_an_optimized_engine_gives_the_points_that_a_new_one_has_or_is_refused() -> None:
    from linkwork.studies.sampling import cases_of
    from scipy.stats import qmc

    def drawn(engine: Any) -> Any:
        columns = cases_of({"x": (0.0, 1.0), "y": (0.0, 1.0)}, engine, 8, None).columns
        return np.stack([columns["x"], columns["y"]], axis=1)

    for kind in (qmc.LatinHypercube, qmc.Halton):
        new = [kind(2, optimization="random-cd", seed=3) for _ in range(3)]
        expected = new[0].random(8)
        assert_array_equal(drawn(new[1]), expected)
        assert_array_equal(drawn(new[1]), expected)  # nothing was drawn from the engine itself
        with pytest.raises(lw.OptionError, match="was drawn from before, and its optimization"):
            drawn(new[0])
    used = qmc.Sobol(2, optimization="lloyd", seed=3)
    expected = used.random(8)
    assert_array_equal(drawn(used), expected)


@pytest.mark.parametrize("bounds", [(False, True), [0.0, True], np.array([False, True]), (np.False_, 2.0)])
def test_truth_values_are_no_bounds(bounds: Any) -> None:
    from linkwork.studies.sampling import cases_of

    with pytest.raises(lw.OptionError, match=r"parameter 'gravity\[0\]': .* is no pair \(low, high\)"):
        cases_of({"gravity[0]": bounds}, "random", 4, 1)


@pytest.mark.parametrize("values", [[-9.81, -1.62], (-9.81, -1.62), [-9.81], [1, 2, 3], "moon", -9.81])
def test_values_beside_a_distribution_are_no_bounds_but_with_a_sampler(values: Any) -> None:
    from linkwork.studies.sampling import cases_of
    from scipy import stats

    with pytest.raises(lw.OptionError, match=r"'gravity\[2\]': without a sampler .* give sampler='random'"):
        cases_of({"rod.mass": stats.norm(1, 0.01), "gravity[2]": values}, None, 4, 1)


def test_a_manifest_says_what_was_drawn_so_that_it_can_be_drawn_again(tmp_path: Path) -> None:
    import scipy
    from scipy import stats
    from scipy.stats import qmc

    wanted = {"rod.mass": stats.norm(1.0, scale=0.01), "gravity[2]": (-10, -9)}
    study = lw.sweep(rod(), wanted, "energy.max", **FEW, sampler="sobol", cases=4, seed=5, directory=tmp_path)
    told = study.manifest["drawn"]
    assert told["parameters"] == {"rod.mass": "norm(1.0, scale=0.01)", "gravity[2]": "(-10.0, -9.0)"}
    assert (told["sampler"], told["cases"], told["seed"]) == ("sobol", 4, 5)
    again = {name: eval(text, {"norm": stats.norm}) for name, text in told["parameters"].items()}
    same = lw.sweep(rod(), again, "energy.max", **FEW, sampler="sobol", cases=4, seed=5)
    for name, values in study.parameters.items():
        assert_array_equal(same.parameters[name], values)
    stored = json.loads((tmp_path / "study.json").read_text())
    assert stored["drawn"] == told and stored["versions"]["scipy"] == scipy.__version__
    engine = qmc.Sobol(2, scramble=True, bits=40, seed=11)
    made = lw.sweep(rod(), wanted, "energy.max", **FEW, sampler=engine, cases=4).manifest["drawn"]
    assert made["seed"] == 11 and made["engine"]["bits"] == 40 and made["engine"]["scramble"] is True
    assert made["generator"] == engine.rng_seed.bit_generator.state
    assert not lw.sweep(rod(), {"rod.mass": [1.0]}, "energy.max", **FEW).manifest["drawn"]


def test_rows_columns_frames_and_arrays_are_the_same_table() -> None:
    import pandas
    from linkwork.studies.sampling import cases_of

    rows = [{"a": 1.0, "b": 5.0}, {"a": 2.0, "b": 6.0}]
    array = np.array([(1.0, 5.0), (2.0, 6.0)], dtype=[("a", float), ("b", float)])
    for given, sampler in ((rows, None), (pandas.DataFrame(rows), None), (array, None),
                           ({"a": [1.0, 2.0], "b": [5.0, 6.0]}, "table")):  # fmt: skip
        assert cases_of(given, sampler, None, None).columns == {"a": [1.0, 2.0], "b": [5.0, 6.0]}
    with pytest.raises(lw.OptionError, match="'a': two columns of the table have this name"):
        cases_of(pandas.DataFrame([[1.0, 2.0]], columns=["a", "a"]), None, None, None)


def test_tables_for_other_tools_have_all_of_it(tmp_path: Path) -> None:
    import xarray

    times = [0.02, 0.05]
    outputs = {"z": "body('rod').position.z", "force": "reaction('pin').force.max"}
    study = lw.sweep(rod(), {"rod.mass": [1, -1]}, outputs, times=times, **FEW)
    table, frame, data = study.to_table(), study.to_frame(), study.to_xarray()
    assert_array_equal(table["z"], study.outputs["z"])
    assert_array_equal(frame["z[1]"], study.outputs["z"][:, 1])
    assert data["z"].dims == ("case", "time") and data["z"].attrs["units"] == "m"
    assert data["force"].attrs["long_name"] == "largest magnitude over the recorded frames"
    assert data["rod.mass"].attrs["units"] == "kg" and "mass" in str(data["error"].values[1])
    study.save(tmp_path / "study.nc")
    lw.sweep(rod(), GRID, ["reaction('pin').force.max", "final"], **FEW).save(tmp_path / "names.nc")
    named = xarray.load_dataset(tmp_path / "names.nc")
    assert named["reaction('pin').force.max"].attrs["units"] == "N" and "gravity[2]" in named.coords
    with pytest.raises(lw.FileError, match="already"):
        study.save(tmp_path / "study.nc")
    read = xarray.load_dataset(tmp_path / "study.nc")
    assert_array_equal(read["z"].values, study.outputs["z"])
    assert_array_equal(read["status"].values.astype(str), study.status)


def test_names_with_a_slash_are_found_again_in_zarr_and_netcdf(tmp_path: Path) -> None:
    """In both it would divide groups, in which nobody finds them who opens the file."""
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("zarr")
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("arm/left", mass=1.0, inertia=(1, 1, 1))
    outputs = {"z/z": "body('arm/left').position.z.final", "z_z": "energy.max",
               "a/b": "body('arm/left').position.final"}  # fmt: skip
    values = {"arm/left.mass": [1.0, 2.0]}
    study = lw.sweep(model, values, outputs, **FEW)
    with pytest.warns(lw.LinkworkWarning, match=r"'arm/left.mass' is 'arm_left.mass'.*have no /"):
        data = study.to_xarray()
    assert data["arm_left.mass"].attrs["name"] == "arm/left.mass"
    with pytest.warns(lw.LinkworkWarning, match="have no /"):
        study.save(tmp_path / "it.nc")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zarr has more to say
        data.to_zarr(tmp_path / "it.zarr")
        back = [xarray.open_zarr(tmp_path / "it.zarr").load(), xarray.load_dataset(tmp_path / "it.nc")]
    for found in back:
        assert_array_equal(found["arm_left.mass"], [1.0, 2.0])
        assert_array_equal(found["z_z_"], study.outputs["z/z"])
        assert_array_equal(found["z_z"], study.outputs["z_z"])
        assert found["a_b"].shape == (2, 3)
    with pytest.warns(lw.LinkworkWarning, match="have no /"):
        many = lw.simulate_many(model, values, 0.05, step=5e-3, progress=False).to_xarray()
    assert_array_equal(many["arm_left.mass"], [1.0, 2.0])


def seeded(seed: int) -> lw.Model:
    return rod()


def test_large_whole_numbers_come_back_from_netcdf_exactly_or_are_refused(tmp_path: Path) -> None:
    """SciPy's, of 32 bits, where no other package is there."""
    xarray = pytest.importorskip("xarray")
    given = [1, 2**40 + 1, -(2**53)]
    lw.sweep(seeded, {"seed": given}, "energy.max", **FEW).save(tmp_path / "it.nc")
    assert [int(it) for it in xarray.load_dataset(tmp_path / "it.nc")["seed"].values] == given
    beyond = lw.sweep(seeded, {"seed": [1, 2**53 + 1]}, "energy.max", **FEW)
    if any(importlib.util.find_spec(name) for name in ("netCDF4", "h5netcdf")):
        beyond.save(tmp_path / "beyond.nc")
        return
    with pytest.raises(lw.FileError, match=r"'seed' has whole numbers beyond 2\^53.*install h5netcdf"):
        beyond.save(tmp_path / "beyond.nc")


def test_without_xarray_and_pandas_there_is_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    study = lw.sweep(rod(), {"rod.mass": [1, 2]}, "energy.max", **FEW)
    for package, method in (("xarray", study.to_xarray), ("pandas", study.to_frame)):
        monkeypatch.setitem(sys.modules, package, None)
        with pytest.raises(lw.OptionError, match=rf"needs the package {package}.*'linkwork\[{package}\]'"):
            method()
    assert study.to_table()["energy.max"].tolist() == study.outputs["energy.max"].tolist()


# --- bookkeeping ---


def test_progress_tells_rate_and_failures(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level("INFO", logger="linkwork.studies"):
        lw.sweep(rod(), {"rod.mass": [1, -1, 2]}, "final", **FEW)
    assert re.fullmatch(r"3 of 3 cases, \S+ cases/s, 1 failed", caplog.messages[-1])


def test_chunks_take_seconds_whatever_cases_cost_and_files_are_bounded() -> None:
    cases: Any = range(1_000_000)
    for seconds in (1e-5, 1e-3, 0.1, 10.0, 1000.0):
        chunks = chunked(cases, seconds, 2)
        assert sum(map(len, chunks)) == len(cases)
        assert len(chunks) <= FILES
        assert len(chunks[0]) * seconds <= max(3.0, seconds * len(cases) / FILES)
    assert len(chunked(range(8), 1e-3, 2)) == 8  # type: ignore[arg-type]
    shards: list[Any] = [range(k, 1_000_000, 100) for k in range(100)]
    assert sum(len(chunked(it, 1000.0, 2, total=1_000_000)) for it in shards) <= FILES


def test_digests_tell_functions_apart_by_what_they_do() -> None:
    def scaled(factor: float) -> Any:
        return lambda x: factor * x

    assert digest(scaled(2.0)) == digest(scaled(2.0))
    assert digest(scaled(2.0)) != digest(scaled(3.0))
    assert digest({"a": 1, "b": 2.0}) == digest({"b": 2.0, "a": 1})
    assert digest(0.1) != digest(np.nextafter(0.1, 1))


@pytest.mark.parametrize("columns", [
    {"b'x": [1.0, 2.5, float("inf")], "a": [-0.0, 1e-300, 3.0], "ab": [1.0, 2.0, 3.0]},
    {"z": [1, 2.5], "a": [[1.0, 2.0], [3.0]]},
])  # fmt: skip
def test_digests_of_rows_are_those_of_each(columns: dict[str, Any]) -> None:
    rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    assert digests("head", columns) == [digest("head", row) for row in rows]


# --- files and the command line ---

STUDY = """\
linkwork_study: 1
model: rod.yaml
t_end: 0.05
simulation: {step: 0.005}
parameters:
  rod.mass: [1.0, 2.0, -3.0]
outputs: {force: "reaction('pin').force.max"}
directory: kept
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    rod().save(tmp_path / "rod.yaml")
    (tmp_path / "study.yaml").write_text(STUDY)
    return tmp_path


def test_command_runs_shards_and_gathers_them(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(folder / "study.yaml")
    for k in range(2):
        assert run(["sweep", file, "--shard", f"{k}/2", "--processes", "1"], False) == 0
    assert "1 x body 'rod'" in capsys.readouterr().out
    table = folder / "study.csv"
    assert run(["sweep", file, "--gather", "--json", "--output", str(table)], False) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["finished"], found["failed"], found["skipped"]) == (2, 1, 0)
    study = lw.sweep(rod(), {"rod.mass": [1.0, 2.0, -3.0]}, {"force": "reaction('pin').force.max"}, **FEW)
    assert found["table"]["force"][:2] == study.outputs["force"][:2].tolist()
    rows = [line.split(",") for line in table.read_text().splitlines()]
    assert [float(row[rows[0].index("force")]) for row in rows[1:3]] == study.outputs["force"][:2].tolist()
    assert set(keys_in(folder / "kept").values()) == {1}


def test_command_tries_failed_cases_again(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(folder / "study.yaml")

    def written(*options: str) -> set[int]:
        assert run(["sweep", file, "--processes", "1", *options], False) == 0
        return {it.stat().st_ino for it in (folder / "kept" / "cases").glob("*.jsonl")}

    first = written()
    assert written() == first
    assert written("--retry") != first  # that of the mass of -3 kg
    assert run(["sweep", file, "--retry", "--gather"], False) == 1
    assert "retry True: gather runs no case" in capsys.readouterr().err


def test_command_says_that_all_have_failed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "study.yaml").write_text(STUDY.replace("[1.0, 2.0, -3.0]", "[-2.0, -3.0]"))
    file = str(folder / "study.yaml")
    assert run(["sweep", file, "--shard", "0/2"], False) == 0  # other shards may do better
    capsys.readouterr()
    assert run(["sweep", file, "--json"], False) == 1
    said = capsys.readouterr()
    assert json.loads(said.out)["failed"] == 2
    assert said.err.startswith("error: no case has finished, 2 failed: body 'rod': mass")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            ["--output", "cases.xlsx"],
            "xlsx is the suffix of a spreadsheet: a table of cases is written to .csv or .nc",
        ),
        (["--output", "cases.parquet"], "parquet is the suffix of a column store"),
        (["--output", "cases.zarr"], "zarr is the suffix of a Zarr store"),
        (["--output", "cases.npz"], "npz is the suffix of a NumPy file"),
        (["--plot", "p.png", "--kind", "bands"], "no output is an array over time"),
        (["--plot", "p.png", "--kind", "surface"], "needs two parameters, and the study has 1"),
    ],
)
def test_command_refuses_before_the_first_case_what_it_could_not_write_or_draw(
    options: list[str], message: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["sweep", str(folder / "study.yaml"), *options], False) == 1
    assert message in capsys.readouterr().err and not (folder / "kept").exists()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("t_end: 0.05", "t_ent: 0.05", r"study.yaml:3: t_ent: is not known here; the nearest is 't_end'"),
        ("t_end: 0.05", "t_end: soon", r"study.yaml:3: t_end: 'soon' is not a number"),
        ("linkwork_study: 1", "linkwork_study: 2", r"study.yaml:1: linkwork_study: 2 is not 1"),
        ("t_end: 0.05", "t_end: -0.5", r"study.yaml:3: t_end: -0.5 is not above 0"),
        ("model: rod.yaml", "model: four_baar", "no mechanism 'four_baar'; the nearest is 'four_bar'"),
        ("model: rod.yaml", "model: rot.yaml", r"model file '.*rot.yaml'"),
        ("rod.mass: [1.0, 2.0, -3.0]", "rod.mass: {norn: {loc: 1}}", "no distribution 'norn'; .*'norm'"),
        *(
            (
                "rod.mass: [1.0, 2.0, -3.0]",
                f"rod.mass: {{{words}}}\ncases: 4\nsampler: random\nseed: 1",
                f"^{said}",
            )
            for words, said in (
                (
                    "norm: {lc: 1}",
                    "error: parameter 'rod.mass': norm has no number 'lc'; the nearest is 'loc'",
                ),
                ("poisson: {mu: 3, scale: 1}", "error: parameter 'rod.mass': poisson has no number 'scale'"),
                ("beta: {a: 1}", "error: parameter 'rod.mass': beta needs a number 'b'"),
                ("norm: {loc: x}", "error: parameter 'rod.mass': norm: loc 'x' is not a finite number"),
                ("norm: {loc: true}", "error: parameter 'rod.mass': norm: loc True is not a finite number"),
                (
                    "norm: {scale: 0}",
                    "error: parameter 'rod.mass': its distribution is none: check its numbers",
                ),
                (
                    "norm: {scale: 1e-400}",
                    "error: .*study.yaml:6: .*scale: 1e-400 is nearer to zero than any other",
                ),
            )
        ),
        ("linkwork_study: 1", "linkwork_study: true", "study.yaml:1: linkwork_study: true is not 1"),
        *(
            (
                "outputs: {force:",
                f"outputs: {empty}\n# {{force:",
                "study.yaml:7: outputs: there are none: write",
            )
            for empty in ("", "[]", "{}")
        ),
        (
            "rod.mass: [1.0, 2.0, -3.0]",
            "rod.mass: {norm: {loc: 1}}\ncases: 4",
            "'rod.mass': is a distribution: give a seed",
        ),
        *(
            (
                "simulation: {",
                f"simulation: {{{option}, ",
                rf"study.yaml:4: simulation.{option.split(':')[0]}: is none of simulate, but {of}",
            )
            for option, of in (
                ("t_end: 9.0", "of the study: write it outside"),
                ("processes: 2", "of the command"),
                ("follow_errors: true", "of the study: write it outside"),
                ("progress: false", "of linkwork.sweep in Python"),
            )
        ),
    ],
)
def test_a_wrong_file_is_refused_with_its_line(
    old: str, new: str, message: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "study.yaml").write_text(STUDY.replace(old, new))
    assert run(["sweep", str(folder / "study.yaml")], False) == 1
    assert re.search(message, capsys.readouterr().err)


def test_a_distribution_that_is_none_is_refused_without_warnings() -> None:
    from scipy import stats

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(lw.OptionError, match="'rod.mass': its distribution is none"):
            lw.sweep(rod(), {"rod.mass": stats.norm(1, 0)}, "final", sampler="random", cases=4, seed=1, **FEW)


@pytest.mark.parametrize(("sign", "code"), [(signal.SIGINT, 130), (signal.SIGKILL, -signal.SIGKILL)])
def test_a_command_that_is_ended_goes_on_where_it_was(folder: Path, sign: signal.Signals, code: int) -> None:
    text = STUDY.replace("[1.0, 2.0, -3.0]", str([1.0 + k for k in range(40)])).replace("0.05", "2.0")
    (folder / "study.yaml").write_text(text.replace("0.005", "0.0005"))
    line = [sys.executable, "-c", "from linkwork.cli import main; main()", "sweep", "study.yaml",
            "--processes", "2"]  # fmt: skip
    process = subprocess.Popen(line, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while not any((folder / "kept" / "cases").glob("*.jsonl")) and time.monotonic() < deadline:
        time.sleep(0.01)
    process.send_signal(sign)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == code, errors
    done = keys_in(folder / "kept")
    assert sign == signal.SIGKILL or f"interrupted: {len(done)} of 40 cases are done, and kept" in errors
    assert 0 < len(done) < 40
    assert subprocess.run(line, cwd=folder, capture_output=True, timeout=120).returncode == 0
    whole = keys_in(folder / "kept")
    assert len(whole) == 40 and set(whole.values()) == {1} and not done - whole


class Pressed:
    """An executor in whose third task the key is pressed, in the callback of a weak reference or in a run."""

    def __init__(self, swallowed: bool) -> None:
        self.left, self.swallowed = 3, swallowed

    def submit(self, task: Any, *given: Any) -> concurrent.futures.Future[Any]:
        found: concurrent.futures.Future[Any] = concurrent.futures.Future()
        self.left -= 1
        if not self.left and self.swallowed:
            thing = Pressed(True)
            kept = weakref.ref(thing, lambda _: signal.raise_signal(signal.SIGINT))  # noqa: F841
            del thing
        elif not self.left:
            threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
            lw.simulate(rod(), 1e4, 1e-3, progress=False)
        found.set_result(task(*given))
        return found


@pytest.mark.parametrize("swallowed", [True, False])
def test_a_key_that_is_pressed_ends_a_study(
    swallowed: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Python ignores what is raised in callbacks of weak references."""
    monkeypatch.setattr(sys, "unraisablehook", lambda _: None)
    before = signal.getsignal(signal.SIGINT)

    def study() -> lw.Study:
        masses = {"rod.mass": [1.0 + k for k in range(12)]}
        kept, options = tmp_path / "kept", {**FEW, "processes": None}
        return lw.sweep(rod(), masses, "final", directory=kept, executor=Pressed(swallowed), **options)

    with pytest.raises(KeyboardInterrupt, match=r"interrupted: \d+ of 12 cases are done, and kept"):
        study()
    assert signal.getsignal(signal.SIGINT) is before
    assert len(keys_in(tmp_path / "kept")) < 12


@pytest.mark.parametrize("kind", ["object", "spline", "frame"])
def test_cases_that_differ_in_an_object_are_told_apart(kind: str) -> None:
    from scipy.interpolate import CubicSpline

    def value(mass: float) -> Any:
        if kind == "object":
            return Scaled(mass)
        if kind == "spline":
            return CubicSpline([0.0, 1.0, 2.0], [mass, 2.0, 3.0])
        return pytest.importorskip("pandas").DataFrame({"x": np.where(np.arange(1000) == 500, mass, 0.0)})

    def build(load: Any) -> lw.Model:
        at = {"object": lambda: load.factor, "spline": lambda: load(0.0), "frame": lambda: load["x"].max()}
        return rod(float(at[kind]()))

    masses = [1.0, 2.0, 5.0]
    study = lw.sweep(build, [{"load": value(mass)} for mass in masses], "reaction('pin').force.max", **FEW)
    (found,) = study.outputs.values()
    assert len(set(found.tolist())) == 3


def test_functions_that_use_each_other_are_read_once_each() -> None:
    """By paths from function to function 40 of them would take forever."""
    names = [f"f{k}" for k in range(40)]
    module: dict[str, Any] = {"__name__": "interwoven", "SIZE": 1.0}
    for name in names:
        exec(f"def {name}(x): return SIZE * sum(f(x) for f in ({', '.join(names)}))", module)
    before = digest(module["f0"])
    assert digest(module["f0"]) == before
    module["SIZE"] = 2.0
    assert digest(module["f0"]) != before


def test_columns_of_one_name_are_refused() -> None:
    outputs = {"a": lambda r: np.array([1.0, 2.0]), "a[0]": lambda r: 9.0}
    study = lw.sweep(rod(), {"rod.mass": [1]}, outputs, **FEW)
    with pytest.raises(lw.OptionError, match=r"two columns are 'a\[0\]'"):
        study.to_frame()


def test_dimensions_have_no_name_of_a_parameter_or_output() -> None:
    pytest.importorskip("xarray")
    outputs = {"a": lambda r: np.array([1.0, 2.0, 3.0]), "a_1": lambda r: 9.0}
    study = lw.sweep(rod(), {"rod.mass": [1, 2]}, outputs, **FEW)
    many = lw.simulate_many(rod(), {"rod.mass": [1, 2]}, 0.05, 5e-3, outputs=outputs, progress=False)
    for found in (study.to_xarray(), many.to_xarray()):
        assert found["a_1"].values.tolist() == [9.0, 9.0]
        assert found["a"].values.tolist() == 2 * [[1.0, 2.0, 3.0]]


def test_times_of_very_short_runs_are_told_apart() -> None:
    with pytest.raises(lw.OptionError, match="2.5e-10 s is between the frames of this run"):
        lw.sweep(rod(), {"rod.mass": [1]}, "body('rod').position", t_end=1e-9, step=1e-10, times=[0.25e-9],
                 processes=1)  # fmt: skip


def test_names_may_begin_with_gravity() -> None:
    model = rod()
    model.spring_damper("ground", "rod", at=((0, 0, 1), (1, 0, 0)), stiffness=2.0, name="gravity spring")
    found = lw.sweep(model, {"gravity spring.stiffness": [1.0, 3.0], "gravity[2]": [-1.0]}, "final", **FEW)
    assert len(found) == 2 and (found.status == "finished").all()


def test_a_study_with_a_tolerance_keeps_the_method_of_its_model_file(folder: Path) -> None:
    model = (folder / "rod.yaml").read_text()
    method = "simulation: {formulation: penalty, penalty: 1e4, integrator: tsit5, step: 1e-3, t_end: 2.0}\n"
    (folder / "rod.yaml").write_text(model + method)
    (folder / "study.yaml").write_text(STUDY.replace("{step: 0.005}", "{rtol: 1.0e-8}"))
    given = read_study(folder / "study.yaml")
    assert {name: given[name] for name in ("formulation", "penalty", "integrator", "rtol")} == {
        "formulation": "penalty", "penalty": 1e4, "integrator": "tsit5", "rtol": 1e-8
    }  # fmt: skip
    assert "step" not in given and given["t_end"] == 0.05


def test_a_file_says_whether_errors_of_all_cases_are_followed(folder: Path) -> None:
    found = {}
    for text in ("", "follow_errors: true\n"):
        (folder / "study.yaml").write_text(STUDY.replace("kept", f"kept{len(text)}") + text)
        given = read_study(folder / "study.yaml")
        many = given | {"t_end": 1.0, "parameters": {"rod.mass": np.linspace(1, 2, 20).tolist()}}
        found[text] = np.isnan(lw.sweep(**many, processes=1, progress=False).unstable).sum()
    assert list(found.values()) == [4, 0]


def test_a_file_has_samplers_and_distributions(folder: Path) -> None:
    from scipy import stats

    text = STUDY.replace("[1.0, 2.0, -3.0]", "{uniform: {loc: 1.0, scale: 2.0}}") + "cases: 4\nseed: 3\n"
    (folder / "study.yaml").write_text(text)
    given = read_study(folder / "study.yaml")
    study = lw.sweep(**given, processes=1)
    direct = lw.sweep(rod(), {"rod.mass": stats.uniform(1.0, 2.0)}, {"force": "reaction('pin').force.max"},
                      cases=4, seed=3, **FEW)  # fmt: skip
    same(study, direct)
    assert given["directory"] == folder / "kept"


class Material(enum.Enum):
    STEEL = 7850.0
    OAK = 700.0


@pytest.mark.parametrize("values", [list(Material), [Path("a"), Path("b")], [{1: 2.0}, {1: 3.0}]])
def test_values_that_a_directory_cannot_hold_are_refused_and_run_without_one(
    values: list[Any], tmp_path: Path
) -> None:
    def build(it: Any) -> lw.Model:
        return rod()

    assert (lw.sweep(build, {"it": values}, "final", **FEW).status == "finished").all()
    with pytest.raises(lw.OptionError, match="parameter 'it': .* cannot be kept in a directory"):
        lw.sweep(build, {"it": values}, "final", **FEW, directory=tmp_path / "kept")


def test_an_output_function_cannot_spoil_the_outputs_after_it() -> None:
    """A height above the lowest point in place is refused, and with a copy it is free fall: g t^2 / 2."""

    def falling(gravity: float) -> lw.Model:
        model = lw.Model(gravity=(0, 0, -gravity))
        model.body("ball", mass=1.0, inertia=(1, 1, 1))
        return model

    def in_place(result: lw.Result) -> Any:
        height = result.position[:, 0, 2]
        height -= height.min()
        return height.max()

    def own(result: lw.Result) -> Any:
        height = result.position[:, 0, 2].copy()
        height -= height.min()
        return height.max()

    after = "body('ball').position.z.final"
    for call in (lw.sweep, lw.simulate_many):
        refused = call(falling, {"gravity": [10.0]}, outputs={"drop": in_place, "z": after}, **FEW_OF[call])
        assert (
            "output 'drop': its function writes into an array of the result" in refused.errors[0]["message"]
        )
        found = call(falling, {"gravity": [10.0]}, outputs={"drop": own, "z": after}, **FEW_OF[call])
        assert found.outputs["drop"] == pytest.approx(0.0125) and found.outputs["z"] == pytest.approx(-0.0125)


@pytest.mark.parametrize("processes", [1, 2])
def test_models_with_functions_of_python_are_varied_by_path(processes: int) -> None:
    """A ball with the force a t and a drag of its own that is none: v = a t^2 / 2 m - g t."""

    def ball(a: float) -> lw.Model:
        model = lw.Model()
        model.body("ball", mass=2.0, inertia=(1, 1, 1))
        model.force("ball", force=(0, 0, lambda t: a * t))
        model.user_force(lambda t, q, v: 0 * v, "ball")
        return model

    varied = {"ball.mass": [1.0, 2.0], "ball.position[2]": [0.0, 5.0]}
    arguments: dict[str, Any] = {"outputs": "body('ball').velocity.z.final", "progress": False}
    for a in (3.0, 6.0):
        study = lw.sweep(ball(a), varied, t_end=1.0, step=1e-2, processes=processes, **arguments)
        many = lw.simulate_many(ball(a), varied, 1.0, 1e-2, **arguments)
        for found in (study, many):
            (speeds,) = found.outputs.values()
            assert speeds == pytest.approx(a / 2 / found.parameters["ball.mass"] - 9.81)
    same, other = (Changed.of(ball(a), list(varied)).identity() for a in (3.0, 6.0))
    assert same != other and same == Changed.of(ball(3.0), list(varied)).identity()


def test_what_a_study_gives_out_cannot_make_it_another_one() -> None:
    study = lw.sweep(rod, {"length": [1.0, 2.0]}, "final", **FEW)
    for given in (study.outputs["final.q"], study.parameters["length"], study.accuracy, study.seconds,
                  study.case(0)["final.q"]):  # fmt: skip
        with pytest.raises(ValueError, match="read-only"):
            given *= 2.0
    table = study.to_table()
    table["length"] *= 2
    if pytest.importorskip("xarray"):
        study.to_xarray()["final.q"].values[:] = 0.0
    assert study.case(1)["length"] == 2.0 and study.outputs["final.q"].any()


def test_an_output_that_raises_is_named() -> None:
    study = lw.sweep(rod(), {"rod.mass": [1]}, {"quotient": lambda result: 1 / 0}, **FEW)
    assert study.errors[0]["message"] == "output 'quotient': division by zero"


def test_samplers_and_distributions_that_give_something_else_are_told() -> None:
    from linkwork.studies.sampling import cases_of
    from scipy import stats
    from scipy.stats import qmc

    few = qmc.PoissonDisk(1, radius=0.3, seed=1)
    with pytest.warns(lw.LinkworkWarning, match="cases 50: PoissonDisk gives 3 only"):
        assert len(cases_of({"x": (0, 1)}, few, 50, None)) == 3
    with pytest.raises(lw.OptionError, match="parameter 'x': its distribution is of 2 numbers"):
        cases_of({"x": stats.norm([1, 2], 0.1)}, None, 5, 1)


def test_names_that_netcdf_does_not_take_are_told(tmp_path: Path) -> None:
    pytest.importorskip("xarray")
    study = lw.sweep(rod(), {"rod.mass": [1]}, {"\u043c\u0430\u0441\u0441\u0430": "energy.max"}, **FEW)
    try:
        study.save(tmp_path / "cases.nc")
    except lw.FileError as error:  # of SciPy, where no other package is there
        assert "not of Latin letters" in str(error) and not list(tmp_path.iterdir())
    study.to_csv(tmp_path / "cases.csv")


def test_parts_of_functions_have_the_units_of_their_arguments() -> None:
    model = rod()
    motion = lw.functions.harmonic(0.1, 2.0, offset=0.1).integral()  # a sum
    model.drive("pin", position=motion, name="motor")
    ramp = lw.functions.polynomial(1.0, 2.0)
    ends = ((0, 0, 1), (1, 0, 0))
    model.spring_damper("ground", "rod", at=ends, stiffness=ramp, damping=0.0, name="strut")
    model.nonlinear_spring_damper("ground", "rod", at=ends, spring=ramp, damper=0.0, name="curved")
    expected = {
        "motor.angle.sum[0].harmonic.amplitude": "rad", "motor.angle.sum[0].harmonic.frequency": "rad/s",
        "motor.angle.sum[0].harmonic.phase": "rad", "strut.stiffness.polynomial[0]": "N/m",
        "strut.stiffness.polynomial[1]": "", "curved.spring.polynomial[1]": "",
        "strut.attachment.origin[0][2]": "m", "rod.inertia[0]": "kg m2",
    }  # fmt: skip
    assert Changed.of(model, list(expected)).units(list(expected)) == expected


def test_a_study_without_a_finished_case_is_an_error_in_json_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rod().save(tmp_path / "rod.yaml")
    (tmp_path / "study.yaml").write_text(
        "linkwork_study: 1\nmodel: rod.yaml\nt_end: 0.02\nsimulation: {step: 0.01}\n"
        "parameters: {rod.mass: [-1.0, -2.0]}\noutputs: final\n"
    )
    assert run(["sweep", str(tmp_path / "study.yaml"), "--processes", "1", "--json"], debug=False) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["failed"] == 2 and found["error"]["exit_code"] == 1
    assert found["error"]["message"].startswith("no case has finished, 2 failed: ")
