"""The commands equilibrium, linearize and kinematics."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import run


def answer(words: list[str], capsys: pytest.CaptureFixture[str]) -> Any:
    code = run([*words, "--json"], debug=False)
    printed = capsys.readouterr()
    assert code == 0, printed.err
    return json.loads(printed.out)


def driven_pendulum(path: Path) -> Path:
    model = lw.Model(gravity=(0, -9.81, 0), name="driven")
    rod = model.body("rod", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(0.7, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 0, 1), name="hinge")
    model.angle_driver(
        model.ground, rod, at=(0, 0, 0), axis=(0, 0, 1), angle=lw.functions.polynomial(0, 1.0), name="motor"
    )
    model.save(path)
    return path


def test_linearize_finds_the_frequency_of_the_pendulum_that_hangs(capsys: pytest.CaptureFixture[str]) -> None:
    """A rod of 1 m and a square section of 5 cm: omega^2 = m g / 2 / (m / 3 + m b^2 / 12)."""
    found = answer(["linearize", "chain", "--bodies", "1"], capsys)
    exact = np.sqrt(9.81 / 2 / (1 / 3 + 0.05**2 / 12))
    assert [it["frequency"] for it in found["modes"]] == pytest.approx([exact], rel=1e-9)
    assert found["stable"] and found["about"] == "equilibrium"


def test_equilibrium_gives_the_weight_to_the_first_joint(capsys: pytest.CaptureFixture[str]) -> None:
    found = answer(["equilibrium", "chain", "--bodies", "3"], capsys)
    assert found["stability"] == "stable"
    assert found["reactions"][0]["force"] == pytest.approx([0, 0, 3 * 9.81], abs=1e-6)
    assert found["bodies"][2]["position"] == pytest.approx([0, 0, -2.5], abs=1e-8)


def test_kinematics_of_a_file_tells_the_torque_of_the_motor(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, output = driven_pendulum(tmp_path / "driven.yaml"), tmp_path / "motion.h5"
    found = answer(["kinematics", str(path), "--t-end", "1", "--output", str(output)], capsys)
    (motor,) = found["drives"]
    assert motor["driver"] == "motor"
    assert motor["largest_effort"] == pytest.approx(2 * 9.81 * 0.7, rel=1e-12)  # at the start, level
    assert lw.Result.load(output).position[-1, 0] == pytest.approx([0.7 * np.cos(1), 0.7 * np.sin(1), 0])


def test_efforts_of_drives_have_the_unit_of_each(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A lift at constant speed bears its weight by a force, a motor that of the level rod by a torque."""
    path = driven_pendulum(tmp_path / "driven.yaml")
    model = lw.Model.load(path)
    cage = model.body("cage", mass=3.0, inertia=(1, 1, 1))
    model.translational(model.ground, cage, at=(0, 0, 0), axis=(0, 1, 0), name="shaft")
    model.drive("shaft", velocity=0.5, name="lift")
    model.save(path, overwrite=True)
    words = ["kinematics", str(path), "--t-end", "0.1"]
    motor, lift = answer(words, capsys)["drives"]
    assert (motor["effort_unit"], lift["effort_unit"]) == ("N m", "N")
    assert lift["largest_effort"] == pytest.approx(3 * 9.81)
    assert run(words, debug=False) == 0
    said = capsys.readouterr().out
    assert "13.734 N m" in said and "29.43 N " in said and "[N or N m]" not in said


def test_kinematics_drives_a_joint_at_a_speed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Power is torque times speed; after 0.5 s at 2 rad/s the crank has turned by 1 rad."""
    output = tmp_path / "motion.h5"
    words = ["kinematics", "four_bar", "--drive", "pin 0=2", "--t-end", "0.5", "--output", str(output)]
    (drive,) = answer(words, capsys)["drives"]
    assert drive["driver"] == "drive of pin 0"
    assert drive["largest_power"] == pytest.approx(2 * drive["largest_effort"])
    motion = lw.Result.load(output)
    angle = motion.coordinate("pin 0").value
    assert angle[-1] - angle[0] == pytest.approx(1.0, abs=1e-9)


def test_kinematics_without_drivers_says_what_is_missing(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["kinematics", "four_bar"], debug=False) == 1
    said = capsys.readouterr().err
    assert "kinematics: 'four_bar' has no drivers: give --drive JOINT=SPEED" in said
    assert "inverse_dynamics" not in said


@pytest.mark.parametrize("command", ("linearize", "equilibrium"))
def test_tables_are_printed(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run([command, "chain", "--bodies", "2"], debug=False) == 0
    assert "stable equilibrium" in capsys.readouterr().out


@pytest.mark.parametrize(("t_end", "step", "frames"), [(1.1, 0.1, 12), (0.3, 0.1, 4), (0.25, 0.1, 4)])
def test_frames_of_kinematics_are_never_farther_apart_than_asked(
    t_end: float, step: float, frames: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = driven_pendulum(tmp_path / "driven.yaml")
    words = ["kinematics", str(path), "--t-end", str(t_end), "--step", str(step), "--json"]
    assert run(words, debug=False) == 0
    printed = capsys.readouterr()
    assert json.loads(printed.out)["frames"] == frames
    assert ("frames are 0.0833333 s apart" in printed.err) == (t_end == 0.25)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ["kinematics", "FILE", "--t-end", "0.1", "--step", "1"],
            "step 1 s is longer than the run, from 0 to 0.1 s",
        ),
        (
            ["kinematics", "FILE", "--step", "1e-300"],
            "step 1e-300 s: up to 1 s these are more than 1000000 frames",
        ),
        (["kinematics", "FILE", "--step", "nan"], "nan must be a finite number, positive"),
        (["kinematics", "FILE", "--t-end", "inf"], "inf must be a finite number, positive"),
        (["compare", "FILE", "--error", "nan"], "nan must be a finite number, positive"),
        (["view", "FILE", "--html", "page.html", "--limit", "nan"], "nan must be a finite number, positive"),
        (["run", "FILE", "--violation-limit", "position=1e-9,position=1"], "gives one level two limits"),
    ],
)
def test_numbers_that_cannot_be_are_refused(
    words: list[str], message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    path = driven_pendulum(tmp_path / "driven.yaml")
    assert run([str(path) if word == "FILE" else word for word in words], debug=False) != 0
    said = capsys.readouterr().err
    assert message in said and "unexpected" not in said
    assert not (tmp_path / "page.html").exists()
