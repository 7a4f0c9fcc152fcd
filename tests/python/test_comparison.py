"""Comparisons: figures are those of separate runs, orders those of theory, errors those of closed forms."""

from __future__ import annotations

import contextlib
import csv
import gc
import io
import json
import os
import resource
import signal
import subprocess
import sys
import time
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pandas
import pytest
from commands import running
from deterministic_bits import SMALLER
from drawn_words import HOSTILE, words_of
from linkwork import mechanisms
from linkwork.accuracy.measures import Bodies, Differences, Sampled, Scales
from linkwork.arrays import Floats
from linkwork.cli import run
from linkwork.comparison import Comparison, text, workers
from linkwork.comparison.reference import solved_reference
from linkwork.comparison.store import Store
from linkwork.motion.header import Header
from linkwork.validation import Series

ONE_BODY = Bodies(np.ones(1), np.zeros(1, int), np.ones(1), np.full(1, np.inf), joint_part=np.zeros(1, int))

STEPS = [1e-2, 5e-3, 2.5e-3]


@cache
def slider_crank() -> Comparison:
    """The selection that is made where no method is named."""
    return lw.compare("spatial_slider_crank", 2.0, steps=STEPS, progress=False)


def quick(model: lw.Model | str = "pendulum", t_end: float = 0.2, **arguments: Any) -> Comparison:
    return lw.compare(model, t_end, **{"steps": [2e-2, 1e-2], "progress": False, **arguments})


# --- orders ---


def test_orders_are_those_of_theory() -> None:
    """Sampled stabilization and projection keep the order of RK4, gains that follow the step take it."""
    orders = slider_crank().orders("pose_error")
    assert orders["standard, none, rk4"] == pytest.approx(4.0, abs=0.1)
    assert orders["standard, sampled_baumgarte, rk4"] == pytest.approx(4.0, abs=0.1)
    assert orders["standard, projection, rk4"] == pytest.approx(4.0, abs=0.1)
    assert orders["standard, baumgarte 1/h 1.41/h, rk4"] == pytest.approx(2.0, abs=0.1)
    assert orders["standard, projection, phem56"] == pytest.approx(5.0, abs=0.5)


def test_velocities_and_reactions_of_gains_that_follow_the_step_are_of_order_one() -> None:
    for error in ("velocity_error", "reaction_error"):
        order = slider_crank().orders(error)["standard, baumgarte 1/h 1.41/h, rk4"]
        assert order == pytest.approx(1.0, abs=0.1), error


def test_reactions_of_the_penalty_method_have_a_floor() -> None:
    """M v_dot = g - a D^T (D v_dot - gamma): a finite penalty leaves what no step takes away."""
    floors = {it.label: it.stagnation("reaction_error") for it in slider_crank().studies}
    assert {label for label, floor in floors.items() if floor} == {
        "penalty, sampled_baumgarte, rk4",
        "penalty, sampled_baumgarte, dopri5",
    }
    cells = [it for it in slider_crank() if it.label.startswith("penalty")]
    violations = np.array([it.acceleration_violation for it in cells])
    assert violations == pytest.approx(violations.mean(), rel=0.01)


def test_observed_order_is_the_slope_between_two_steps() -> None:
    rows = [row for row in slider_crank().rows() if row["label"] == "standard, none, rk4"]
    assert rows[0]["pose_order"] is None
    slope = np.log(rows[1]["pose_error"] / rows[2]["pose_error"]) / np.log(2)
    assert rows[2]["pose_order"] == pytest.approx(slope)


# --- figures ---


def test_figures_are_those_of_a_separate_run() -> None:
    comparison = slider_crank()
    cell = next(it for it in comparison if it.label == "standard, none, rk4" and it.step == 5e-3)
    model = mechanisms.spatial_slider_crank()
    result = lw.simulate(model, 2.0, 5e-3, "rk4", stabilization="none", record_every=2, progress=False,
                         on_inaccurate="pass")  # fmt: skip
    assert cell.position_violation == result.violation[:, 0].max()
    assert cell.velocity_violation == result.violation[:, 1].max()
    assert cell.energy_error == np.abs(result.energy_error).max()
    assert cell.evaluations == result.statistics["evaluations"]
    assert result.verdict is not None and cell.estimated_error == result.verdict.error
    reference, scales = comparison.reference.motion, comparison.reference.scales
    apart = np.linalg.norm(result.position - reference.q[:, :, :3], axis=-1).max(axis=1)
    turned = np.array([
        max(angle_between(p, exact) for p, exact in zip(*pair, strict=True))
        for pair in zip(result.orientation, reference.q[:, :, 3:], strict=True)
    ])  # fmt: skip
    assert cell.pose_error == pytest.approx(np.maximum(apart / scales.length, turned).max(), rel=1e-9)
    force = np.linalg.norm(result.reactions().force - reference.force, axis=-1).max()
    torque = np.linalg.norm(result.reactions().torque - reference.torque, axis=-1).max()
    expected = max(force, torque / scales.length) / scales.force
    assert cell.reaction_error == pytest.approx(expected, rel=1e-9)


def angle_between(p: Floats, exact: Floats) -> float:
    """From the trace of the relative rotation matrix."""
    relative = lw.rotation.matrix(p).T @ lw.rotation.matrix(exact)
    return float(np.arccos(np.clip((np.trace(relative) - 1) / 2, -1, 1)))


def test_small_angles_between_rotations_are_not_rounded_away() -> None:
    p = lw.rotation.about((1, 2, 3), 2.0)
    axis, angle = np.array([0.0, 0.6, 0.8]), 1e-12
    turned = lw.rotation.from_matrix(lw.rotation.matrix(p) @ lw.rotation.matrix(lw.rotation.about(axis, 0.0)))
    half = angle / 2 * axis
    turned = turned + np.concatenate([[-half @ p[1:]], p[0] * half + np.cross(p[1:], half)])
    assert between(p, turned).rotation[1] == pytest.approx(angle, rel=1e-3)
    assert between(p, -p).rotation[1] == 0.0


def between(p: Floats, exact: Floats) -> Differences:
    """Two motions of one body at rest."""

    def motion(orientation: Floats) -> Sampled:
        q = np.tile(np.concatenate([np.zeros(3), orientation]), (2, 1, 1))
        return Sampled(np.array([0.0, 1.0]), q, np.zeros((2, 1, 6)), np.zeros((2, 0, 3)), np.zeros((2, 0, 3)))

    return Differences.between(motion(p), motion(exact))


def test_adaptive_cells_are_more_accurate_with_smaller_tolerances() -> None:
    cells = quick(t_end=1.0, steps=None, tolerances=[1e-5, 1e-7, 1e-9], integrators=["dopri5"]).outcomes
    errors = [it.state_error for it in cells]
    assert errors == sorted(errors, reverse=True) and errors[-1] < 1e-7


def test_only_unique_reactions_are_compared() -> None:
    comparison = quick("four_bar", integrators=["rk4"])
    assert comparison.reference.unique_joints == [] and all(it.reaction_error is None for it in comparison)
    assert "no joint" in comparison.recommend(of="reaction_error")
    assert all(it.status == "finished" and it.state_error < 1e-4 for it in comparison)


def test_linear_solvers_agree_and_are_told_apart() -> None:
    comparison = quick("spatial_slider_crank", steps=[5e-3], linear_solvers=["block", "eigen_ldlt", "dense"])
    assert [it.options["linear_solver"] for it in comparison] == ["block", "eigen_ldlt", "dense"]
    errors = [it.pose_error for it in comparison]
    assert errors == pytest.approx([errors[0]] * 3, rel=1e-6)


@pytest.mark.parametrize("name", mechanisms.MECHANISMS)
def test_every_mechanism_can_be_compared(name: str) -> None:
    step = mechanisms.MECHANISMS[name].settings["step"]
    size = SMALLER.get(name, {}) if name != "tracked_chain" else {}  # of 40 shoes it needs shorter steps
    model = mechanisms.MECHANISMS[name].function(**size)
    comparison = quick(model, 40 * step, steps=[2 * step, step], integrators=["rk4", "phem56"])
    assert {it.status for it in comparison} == {"finished"}
    assert max(it.state_error for it in comparison if it.state_error is not None) < 1e-2
    assert comparison.reference.error is not None and comparison.reference.error["state_error"] < 1e-9


# --- the reference ---


def rod_pendulum() -> tuple[lw.Model, Floats, Floats, Floats]:
    """(model, times, q, v) of the closed form theta = 2 asin(k sn)."""
    reference = Series("rod_pendulum")
    theta, rate = reference("theta"), reference("thetadot")
    q, v = np.zeros((len(theta), 1, 7)), np.zeros((len(theta), 1, 6))
    q[:, 0] = posed(0.5 * np.sin(theta), -0.5 * np.cos(theta), theta - np.pi / 2)
    v[:, 0] = moving(0.5 * rate * np.cos(theta), 0.5 * rate * np.sin(theta), rate)
    return mechanisms.rod_pendulum(), reference("t"), q, v


def heavy_top() -> tuple[lw.Model, Floats, Floats, Floats]:
    reference = Series("heavy_top")
    q = reference("x", "y", "z", "q0", "q1", "q2", "q3")[:, None]
    return mechanisms.heavy_top(), reference("t"), q, reference("vx", "vy", "vz", "Wx", "Wy", "Wz")[:, None]


def four_bar() -> tuple[lw.Model, Floats, Floats, Floats]:
    """Posts turn clockwise by phi from upright, the beam moves in parallel."""
    reference = Series("A02_fourbar_N1_10s")
    phi, rate = reference("phi"), reference("phidot")
    x, y, vx, vy = np.sin(phi), np.cos(phi), rate * np.cos(phi), -rate * np.sin(phi)
    posts = [posed(base + x / 2, y / 2, np.pi / 2 - phi) for base in (0.0, 1.0)]
    q = np.stack([*posts, posed(0.5 + x, y, 0 * phi)], axis=1)
    v = np.stack([*[moving(vx / 2, vy / 2, -rate)] * 2, moving(vx, vy, 0 * rate)], axis=1)
    return mechanisms.four_bar(), reference("t"), q, v


def posed(x: Floats, y: Floats, angle: Floats) -> Floats:
    zero = 0 * angle
    return np.stack([x, y, zero, np.cos(angle / 2), zero, zero, np.sin(angle / 2)], axis=1)


def moving(vx: Floats, vy: Floats, rate: Floats) -> Floats:
    zero = 0 * rate
    return np.stack([vx, vy, zero, zero, zero, rate], axis=1)


@pytest.mark.parametrize("closed_form", [rod_pendulum, heavy_top, four_bar])
def test_error_of_the_reference_is_estimated_within_a_factor_of_ten(closed_form: Any) -> None:
    model, t, q, v = closed_form()
    reference = solved_reference(model, float(t[-1]), t)
    exact = Sampled(reference.motion.t, q, v, reference.motion.force, reference.motion.torque)
    differences = Differences.between(exact, reference.motion)
    for what, error in (("pose_error", differences.pose), ("velocity_error", differences.velocities)):
        true = float(error(reference.scales).max())
        assert 0.1 < reference.error[what] / true < 10, (what, true)


def test_a_known_solution_can_be_the_reference(tmp_path: Path) -> None:
    exact = lw.simulate(mechanisms.pendulum(), 0.2, 1e-3, "dop853", record_every=10, progress=False)
    exact.save(tmp_path / "exact.h5")
    given = quick(reference=tmp_path / "exact.h5", integrators=["rk4"])
    found = quick(integrators=["rk4"])
    assert [it.pose_error for it in given] == pytest.approx([it.pose_error for it in found], rel=1e-3)
    assert given.reference.error is None
    assert "own error not stated" in str(given)
    assert given.recommend(1.0).endswith("if the reference is that good: its own error is not stated.")
    told = quick(reference=tmp_path / "exact.h5", reference_error=1e-3, integrators=["rk4"])
    assert "own error about 1.0e-03" in str(told)
    assert told.recommend(1.0).endswith(" s.")
    assert "only known to 0.001" in told.recommend(2e-3)


def test_a_reference_of_another_model_is_told_and_one_of_another_place_refused() -> None:
    def lifted(mass: float, height: float) -> lw.Model:
        model = lw.Model()
        model.body("rod", mass=mass, inertia=(0.1, 0.1, 0.1), position=(1, 0, height))
        model.revolute("ground", "rod", at=(0, 0, height), axis=(0, 1, 0))
        return model

    how: dict[str, Any] = {"steps": [1e-2], "integrators": ["rk4"], "processes": 1, "progress": False}
    heavy, high = (lw.simulate(lifted(*it), 0.2, rtol=1e-8, progress=False) for it in ((2, 0), (1, 1)))
    with pytest.warns(lw.LinkworkWarning, match="with other numbers.*an error of every method"):
        lw.compare(lifted(1, 0), 0.2, reference=heavy, **how)
    with pytest.raises(lw.OptionError, match="body 'rod' begins 1 m from where it is in the model"):
        lw.compare(lifted(1, 0), 0.2, reference=high, **how)


def test_a_reference_of_other_times_is_compared_where_the_times_meet() -> None:
    """Frames at multiples of 7 ms, a step of 10 ms: 0, 0.07, 0.14 and the end."""
    exact = lw.simulate(mechanisms.pendulum(), 0.2, 7e-3, record_every=1, progress=False)
    (cell,) = quick(reference=exact, integrators=["rk4"], steps=[1e-2]).outcomes
    assert cell.status == "finished" and cell.curves is not None
    assert cell.curves.t == pytest.approx([0, 0.07, 0.14, 0.2])


@pytest.mark.parametrize(("arguments", "message"), [
    ({"model": "pendulun"}, "the nearest is 'pendulum'"),
    ({"steps": None, "model": mechanisms.pendulum(), "t_end": None}, "t_end is missing"),
    ({"steps": [0.0]}, "steps 0.0"),
    ({"steps": ["tiny"]}, "steps 'tiny'"),
    ({"integrators": ["rk4", "rk44"]}, "integrator 'rk44' does not exist; the nearest is 'rk4'"),
    ({"steps": None, "step": 1e-3}, "option 'step' does not exist; the nearest is 'steps'"),
    ({"steps": []}, "steps and tolerances are missing"),
    ({"integrators": []}, "integrators: is empty"),
    ({"stabilizations": ["baumgarte:five"]}, "'five' is no number"),
    ({"integrators": ["rk4:3"]}, "takes no numbers"),
    ({"processes": 0}, "processes 0"),
    ({"reference": lw.simulate(mechanisms.chain(3), 0.2, 1e-2, progress=False)}, "has 3 bodies, the model 1"),
    ({"reference": lw.simulate(mechanisms.pendulum(), 0.1, 1e-2, progress=False)}, "ends at 0.1 s"),
])  # fmt: skip
def test_what_cannot_be_compared_is_refused(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(lw.OptionError, match=message):
        quick(**arguments)


# --- cells that do not finish ---


def test_a_model_that_cannot_be_simulated_is_an_error_of_the_model() -> None:
    model = lw.Model()
    bob = model.body("bob", mass=1.0, inertia=(1, 1, 1), velocity=(1, 0, 0))
    model.spherical(model.ground, bob, at=(0, 0, 0), name="pivot")
    with pytest.raises(lw.ModelError, match="initial velocities do not satisfy 1 joint ") as caught:
        quick(model)
    assert caught.value.joints == ["pivot"]


def test_cells_that_do_not_finish_say_why_and_stop_nothing() -> None:
    axes = {"stabilizations": ["none", "baumgarte:500:500"], "integrators": ["euler", "rk4"]}
    comparison = quick("spatial_slider_crank", t_end=1.0, steps=[0.2, 1e-2], **axes)
    by_status: dict[str, list[Any]] = {}
    for it in comparison:
        by_status.setdefault(it.status, []).append(it)
    assert set(by_status) == {"finished", "refused", "diverged"}
    reasons = {it.label: it.reason for it in by_status["refused"]}
    assert "unstable" in reasons["baumgarte 500 500, rk4"]
    assert all(
        it.reason and it.t_reached is not None and it.state_error is None for it in by_status["diverged"]
    )


def explosive(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    raise ZeroDivisionError("no way")


def suicidal(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    os.kill(os.getpid(), signal.SIGKILL)
    return y


def endless(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    time.sleep(60)
    return y


def test_an_integrator_that_fails_kills_or_never_ends_costs_its_own_cell_alone() -> None:
    comparison = quick(integrators=[explosive, suicidal, endless, "rk4"], steps=[1e-2], time_limit=1.0)
    found = {it.label: (it.status, it.reason) for it in comparison}
    assert found["explosive"] == ("failed", "ZeroDivisionError: no way")
    assert found["suicidal"] == ("lost", "its process was ended by SIGKILL")
    assert found["endless"] == ("lost", "not done after 1 s")
    assert found["rk4"] == ("finished", "")


def test_a_model_with_functions_of_python_is_compared() -> None:
    model = mechanisms.pendulum()
    model.force("bob", force=(lambda t: np.sin(3 * t), 0, 0))
    assert [it.status for it in quick(model, integrators=["rk4"])] == ["finished"] * 2


# --- going on after an interruption ---


def test_finished_cells_are_not_run_again(tmp_path: Path) -> None:
    first = quick(resume=tmp_path / "c", integrators=["rk4"])
    kept = (tmp_path / "c" / "cells.jsonl").read_text()
    second = quick(resume=tmp_path / "c", integrators=["rk4", "heun"])
    assert second.outcomes[:2] == first.outcomes
    assert (tmp_path / "c" / "cells.jsonl").read_text().startswith(kept)


def test_a_line_that_was_cut_off_is_run_again(tmp_path: Path) -> None:
    first = quick(resume=tmp_path / "c", integrators=["rk4"])
    file = tmp_path / "c" / "cells.jsonl"
    file.write_text(file.read_text()[:-40])
    second = quick(resume=tmp_path / "c", integrators=["rk4"])
    assert [it.pose_error for it in second] == [it.pose_error for it in first]
    assert [json.loads(line)["key"] for line in file.read_text().splitlines() if line.endswith("}")]


def test_a_folder_of_another_comparison_is_refused(tmp_path: Path) -> None:
    quick(resume=tmp_path / "c", integrators=["rk4"])
    with pytest.raises(lw.FileError, match="holds a comparison with t_end 0.2, not 0.3"):
        quick(resume=tmp_path / "c", integrators=["rk4"], t_end=0.3)


@pytest.mark.parametrize("content", [b"", b'{"t_end": ', b"[]", b"\xff", b"[" * 100_000])
def test_a_folder_that_does_not_say_what_it_holds_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "comparison.json").write_bytes(content)
    with pytest.raises(lw.FileError, match=r"its comparison.json is none of a comparison; give another"):
        quick(resume=tmp_path)
    assert (tmp_path / "comparison.json").read_bytes() == content
    (tmp_path / "comparison.json").unlink()
    (tmp_path / "cells.jsonl").touch()
    with pytest.raises(lw.FileError, match="comparison.json is not there, beside cells that are"):
        quick(resume=tmp_path)


def test_a_cell_with_another_number_is_run_again(tmp_path: Path) -> None:
    first = quick(resume=tmp_path / "c", integrators=["rk4"])
    file = tmp_path / "c" / "cells.jsonl"
    lines = [json.loads(line) for line in file.read_text().splitlines()]
    kept, changed, older = lines
    changed["found"]["pose_error"] = 1.0
    del older["digest"]  # as in older files
    damaged = [b"\xff", b"1", b"[" * 100_000]
    file.write_bytes(b"\n".join([*(json.dumps(line).encode() for line in lines), *damaged]))
    store = Store(tmp_path / "c", json.loads((tmp_path / "c" / "comparison.json").read_text()))
    assert list(store.found()) == [kept["key"], older["key"]]
    second = quick(resume=tmp_path / "c", integrators=["rk4"])
    assert [it.pose_error for it in second] == [it.pose_error for it in first]


def test_a_killed_comparison_keeps_its_finished_cells_and_leaves_no_process(tmp_path: Path) -> None:
    program = f"""
import linkwork as lw
lw.compare("spatial_slider_crank", 10.0, steps=[1e-3 / 2**k for k in range(8)], integrators=["rk4"],
           resume={str(tmp_path / "c")!r}, processes=2, progress=False)
"""
    process = subprocess.Popen([sys.executable, "-c", program])
    wait_for_cells(tmp_path / "c", 2)
    group = children(process.pid)
    process.kill()
    process.wait()
    assert group
    lines = [json.loads(line) for line in (tmp_path / "c" / "cells.jsonl").read_text().splitlines()]
    assert len(lines) >= 2 and all("found" in line for line in lines)
    deadline = time.monotonic() + 20
    while any(Path(f"/proc/{pid}").exists() for pid in group) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not [pid for pid in group if Path(f"/proc/{pid}").exists()]


@pytest.fixture(scope="module")
def uninterrupted() -> Comparison:
    return lw.compare(
        "four_bar", 0.2, steps=[2e-3, 1e-3, 5e-4], integrators=["rk4", "dopri5"], progress=False
    )


@pytest.mark.parametrize("seconds", np.random.default_rng(7).uniform(0.4, 2.5, 4).round(2))
def test_a_comparison_killed_at_any_moment_goes_on(
    tmp_path: Path, seconds: float, uninterrupted: Comparison
) -> None:
    program = f"""
import linkwork as lw
lw.compare("four_bar", 0.2, steps=[2e-3, 1e-3, 5e-4], integrators=["rk4", "dopri5"],
           resume={str(tmp_path / "c")!r}, processes=1, progress=False)
"""
    process = subprocess.Popen([sys.executable, "-c", program])
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(timeout=seconds)
    process.kill()
    process.wait()
    found = lw.compare("four_bar", 0.2, steps=[2e-3, 1e-3, 5e-4], integrators=["rk4", "dopri5"],
                       resume=tmp_path / "c", progress=False)  # fmt: skip
    assert [it.pose_error for it in found] == [it.pose_error for it in uninterrupted]
    assert found.orders() == uninterrupted.orders()


def test_a_stored_reference_that_is_damaged_is_made_anew(tmp_path: Path) -> None:
    first = quick(resume=tmp_path / "c", integrators=["rk4"])
    file = tmp_path / "c" / "reference.npz"
    for content in (file.read_bytes()[:-200], file.read_bytes()[:50], b""):
        file.write_bytes(content)
        again = quick(resume=tmp_path / "c", integrators=["rk4"])
        assert again.reference.error == first.reference.error


def test_a_file_that_grows_too_large_ends_with_one_line_and_the_cells_so_far(tmp_path: Path) -> None:
    """The reference fits, and some cells of 25 kB each."""
    words = ["compare", "pendulum", "--t-end", "1", "--steps", "1e-2,5e-3,2.5e-3", "--resume", tmp_path / "c"]
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10**5, 10**5))  # noqa: E731
    done = subprocess.run([*PROGRAM, *map(str, words)], preexec_fn=limit, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (1, "", 1)
    assert done.stderr.startswith(f"error: folder '{tmp_path / 'c'}': cannot be written: file too large")
    *whole, _ = (tmp_path / "c" / "cells.jsonl").read_text().splitlines()
    kept = [json.loads(line)["found"] for line in whole]
    assert kept and all(len(it["curves"]["t"]) == 101 for it in kept)
    assert len(quick(t_end=1.0, steps=STEPS, resume=tmp_path / "c")) == 33


def test_texts_of_a_comparison_replace_no_file_and_have_suffixes_of_their_kinds(tmp_path: Path) -> None:
    comparison = quick(integrators=["rk4"])
    for write, suffix in ((comparison.to_csv, "csv"), (comparison.to_json, "json")):
        file = tmp_path / f"it.{suffix}"
        file.write_text("precious")
        with pytest.raises(lw.FileError, match="there is such a file already"):
            write(file)
        assert file.read_text() == "precious"
        assert write(file, overwrite=True) is None  # as Result.to_csv
        assert file.read_text() == write()
        with pytest.raises(lw.FileError, match=rf"\.html is the suffix of a page: .* written to \.{suffix}"):
            write(tmp_path / "it.html")
    with pytest.raises(lw.FileError, match="is the suffix of a table: a page is written to"):
        comparison.to_html(tmp_path / "it.csv")


def test_a_page_that_cannot_be_written_leaves_the_old_one(tmp_path: Path) -> None:
    comparison = quick(integrators=["rk4"])
    (tmp_path / "table.csv").write_text("old")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    try:
        with pytest.raises(lw.FileError, match=r"table.csv': cannot be written: file too large"):
            comparison.to_csv(tmp_path / "table.csv", overwrite=True)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert os.listdir(tmp_path) == ["table.csv"] and (tmp_path / "table.csv").read_text() == "old"


def wait_for_cells(folder: Path, count: int) -> None:
    """Until so many are kept."""
    for _ in range(400):
        time.sleep(0.05)
        if (folder / "cells.jsonl").exists() and (folder / "cells.jsonl").read_text().count("\n") >= count:
            return
    pytest.fail(f"no {count} cells after 20 s")


def children(pid: int) -> list[str]:
    return Path(f"/proc/{pid}/task/{pid}/children").read_text().split()


def test_workers_answer_in_any_order_and_all_items() -> None:
    answers = dict(workers.in_processes(square, list(range(20)), processes=3))
    assert answers == {place: place**2 for place in range(20)}


def test_what_was_there_before_a_process_is_not_looked_through_for_garbage_in_it() -> None:
    there, before = len(gc.get_objects()), gc.get_freeze_count()
    (frozen,) = dict(workers.in_processes(lambda _: gc.get_freeze_count(), [0], processes=1)).values()
    assert isinstance(frozen, int)
    assert frozen - before > 0.9 * there
    assert gc.get_freeze_count() == before


def square(number: int) -> int:
    return number**2


# --- what is shown ---


def test_recommendation_is_the_cheapest_cell_that_meets_the_error() -> None:
    comparison = slider_crank()
    meeting = [it for it in comparison if it.state_error is not None and it.state_error <= 1e-4]
    best = min(meeting, key=lambda it: it.evaluations)
    sentence = comparison.recommend(1e-4, by="evaluations")
    assert best.label in sentence and f"{best.step:g} s" in sentence and f"{best.evaluations:,}" in sentence
    assert comparison.recommend(1e-15).startswith("No cell meets a state error of 1e-15: the smallest is")
    with pytest.raises(lw.OptionError, match="the nearest is 'state_error'"):
        comparison.recommend(of="sate_error")


def test_table_csv_and_json_agree() -> None:
    comparison = slider_crank()
    rows = list(csv.DictReader(io.StringIO(comparison.to_csv())))
    document = json.loads(
        comparison.to_json(), parse_constant=lambda word: pytest.fail(f"{word} is not JSON")
    )
    assert len(rows) == len(document["cells"]) == len(comparison) == 33
    for row, cell, outcome in zip(rows, document["cells"], comparison, strict=True):
        assert float(row["pose_error"]) == cell["pose_error"] == outcome.pose_error
        assert len(cell["curves"]["t"]) == 201
    text = str(comparison)
    assert all(it.label in text for it in comparison)


def test_table_fits_a_terminal_and_keeps_all_of_its_columns() -> None:
    wide, narrow = text.table(slider_crank()), text.table(slider_crank(), 80)
    assert max(map(len, narrow.splitlines())) <= 80 < max(map(len, wide.splitlines()))
    shown = {word for line in narrow.splitlines() for word in line.split()}
    assert shown >= {word for line in text.cells(slider_crank()) for cell in line for word in cell.split()}
    for column in text.COLUMNS[1:]:
        for words in filter(None, column.heading.split("\n")):
            assert words in narrow, words
    for label in {it.label for it in slider_crank()}:  # a line of its own in each part
        assert narrow.splitlines().count(label) == 2


def test_table_is_a_frame_of_pandas() -> None:
    frame = slider_crank().to_frame()
    assert isinstance(frame, pandas.DataFrame) and len(frame) == 33
    assert frame["pose_error"].min() == min(it.pose_error for it in slider_crank())


def test_page_needs_nothing_from_anywhere(tmp_path: Path) -> None:
    page = slider_crank().to_html()
    slider_crank().to_html(tmp_path / "c.html")
    assert (tmp_path / "c.html").read_text() == page
    assert page.count("<svg") == 5 and "<script" not in page and "src=" not in page and "@import" not in page
    links = {part.split('"')[0] for part in page.split('href="')[1:]}
    assert all(link.startswith("#") for link in links)
    identifiers = [part.split('"')[0] for part in page.split(' id="')[1:]]
    assert len(identifiers) == len(set(identifiers))
    assert {link[1:] for link in links} <= set(identifiers)


@pytest.mark.parametrize("kind", ["work_precision", "order", "violation", "energy", "error"])
def test_picture_shows_every_method(kind: str, tmp_path: Path) -> None:
    figure = slider_crank().plot(kind, tmp_path / "picture.png")
    assert (tmp_path / "picture.png").stat().st_size > 10_000
    labels = figure.axes[0].get_legend_handles_labels()[1]
    for label in slider_crank().orders():
        assert any(shown.startswith(label) for shown in labels), label


@pytest.mark.parametrize("name", HOSTILE)
def test_picture_has_the_name_of_the_model_letter_by_letter(name: str, tmp_path: Path) -> None:
    table = slider_crank()
    renamed = replace(table, manifest={**table.manifest, "model": name})
    words = words_of(renamed.plot("energy"), tmp_path)
    assert any(word.startswith(f"{name}, 0 to") for word in words)


def test_scales_of_a_body_that_only_turns_are_those_of_its_arm() -> None:
    q = np.tile([0.0, 0, 0, 1, 0, 0, 0], (3, 1, 1))
    v = np.tile([0.0, 0, 0, 0, 0, 5.0], (3, 1, 1))
    scales = Scales.of(
        Sampled(np.arange(3.0), q, v, np.zeros((3, 0, 3)), np.zeros((3, 0, 3))),
        ONE_BODY._replace(longest=np.array([0.2]), joint_part=np.zeros(0, int)),
    )
    assert (scales.length, scales.speed, scales.force) == (0.2, 1.0, 1.0)


def rod_in_the_air(length: float) -> lw.Model:
    """A ball that a rod of two points holds at its center, beside one on an arm of 0.5 m and a free one."""
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("ball", mass=1.0, inertia=(0.004,) * 3, position=(0, 0, 3 - length), omega=(3, 0, 0))
    model.distance("ground", "ball", at=((0, 0, 3), (0, 0, 3 - length)))
    model.body("arm", mass=1.0, inertia=(0.1, 0.2, 0.2), position=(5.5, 0, 0))
    model.revolute("ground", "arm", at=(5, 0, 0), axis=(0, 1, 0))
    model.body("free", mass=2.0, inertia=(0.4, 0.3, 0.3), position=(9, 0, 0))
    return model


SIZED = [
    lambda: rod_in_the_air(2.0),
    mechanisms.bricard,
    mechanisms.flyball_governor,
    mechanisms.double_wishbone,
    mechanisms.rolling_disc,
]


@pytest.mark.parametrize("build", SIZED)
def test_the_size_of_bodies_is_that_of_verdicts(build: Any) -> None:
    model = build()
    bodies = Bodies.of(Header.of(model.compiled(), None, {}))
    np.testing.assert_allclose(bodies.size()[bodies.part], lw.System(model).compiled().part_sizes, rtol=1e-14)


def test_what_a_rod_holds_has_the_size_of_the_rod() -> None:
    """Not of the ball, at whose center it ends."""
    bodies = Bodies.of(Header.of(rod_in_the_air(2.0).compiled(), None, {}))
    assert bodies.size()[bodies.part] == pytest.approx([2.0, 0.5, np.sqrt(0.5)], rel=1e-14)


@pytest.mark.parametrize(("way", "speed"), [(0.01, 0.01), (1e-8, 1e-4 * 1e3)])
def test_forces_scale_the_speed_of_what_is_at_rest_alone(way: float, speed: float) -> None:
    """1 cm and back in 1 s, under a preload that would give the mass 1000 m/s; and a trembling of 10 nm."""
    q = np.tile([0.0, 0, 0, 1, 0, 0, 0], (3, 1, 1))
    q[:, 0, 0] = np.array([0.0, 1.0, 0.0]) * way
    v = np.tile([way, 0.0, 0, 0, 0, 0], (3, 1, 1))
    force = np.tile([1e6, 0.0, 0.0], (3, 1, 1))
    motion = Sampled(np.linspace(0.0, 1.0, 3), q, v, force, np.zeros((3, 1, 3)))
    assert Scales.of(motion, ONE_BODY, tolerance=1e-4).speed == pytest.approx(speed)


# --- the command ---

PROGRAM = [sys.executable, "-c", "from linkwork.cli import main; main()"]


def test_command_writes_what_it_names_and_says_what_compare_says(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {option: tmp_path / f"c.{option}" for option in ("html", "csv")} | {"plot": tmp_path / "c.png"}
    words = [word for option, file in files.items() for word in (f"--{option}", str(file))]
    line = ["compare", "chain", "--bodies", "3", "--t-end", "0.2", "--steps", "2e-2,1e-2"]
    assert run([*line, "--integrators", "rk4,heun", "--json", *words], debug=False) == 0
    said = json.loads(capsys.readouterr().out)
    expected = quick(mechanisms.chain(3), integrators=["rk4", "heun"])
    assert [it["pose_error"] for it in said["cells"]] == [it.pose_error for it in expected]
    assert said["recommendation"].startswith("The cheapest of")
    assert all(file.stat().st_size > 500 for file in files.values())


@pytest.mark.parametrize(("words", "code", "message"), [
    (["--steps", "1e-2,tiny"], 2, "'1e-2,tiny' is not a list of numbers"),
    (["--steps", ","], 2, "names nothing"),
    (["--integrator", "rk4"], 2, "no option --integrator; the nearest is '--integrators'"),
    (["--processes", "0"], 2, "0 is not in the range"),
    (["--reference", "missing.h5"], 1, "'missing.h5': no such file"),
    (["--html", "/nowhere/c.html"], 1, "'/nowhere/c.html': cannot be written: no directory"),
    (["--stabilizations", "baumgarte:1:2:3"], 1, "takes baumgarte_alpha and baumgarte_beta"),
])  # fmt: skip
def test_mistake_is_answered_in_one_line(
    words: list[str], code: int, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["compare", "pendulum", "--t-end", "0.1", *words], debug=False) == code
    out, err = capsys.readouterr()
    assert out == "" and err.startswith("error: ") and err.count("\n") == 1 and message in err


def test_interrupted_command_says_what_it_kept_and_leaves_no_process(tmp_path: Path) -> None:
    steps = ",".join(f"{1e-3 / 2**k:g}" for k in range(9))
    words = ["compare", "spatial_slider_crank", "--integrators", "rk4", "--steps", steps, "--processes", "2"]
    with running([*PROGRAM, *words, "--resume", str(tmp_path / "c")]) as command:
        wait_for_cells(tmp_path / "c", 1)
        group = children(command.pid)
        command.send_signal(signal.SIGINT)
        out, err = command.communicate(timeout=20)
    assert (command.returncode, out) == (130, "")
    assert err == f"error: interrupted; '{tmp_path / 'c'}' has the runs so far\n"
    assert group and not [pid for pid in group if Path(f"/proc/{pid}").exists()]
