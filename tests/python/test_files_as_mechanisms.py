"""Every command that takes a mechanism's name takes a file, too."""

from __future__ import annotations

import json
from contextlib import nullcontext
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork.benchmark.subject import Subject
from linkwork.cli import run
from linkwork.running.time_scale import usual_end

ROBOTS = Path(__file__).parent / "robots"


@pytest.fixture
def four_bar(tmp_path: Path) -> Path:
    path = tmp_path / "four_bar.yaml"
    lw.mechanisms.four_bar().save(path, simulation={"t_end": 0.05, "step": 1e-3})
    return path


@pytest.mark.parametrize("words", [
    "run FILE", "run FILE --t-end 0.01 --integrator dopri5", "check FILE", "report FILE -o page.html",
    "compare FILE --t-end 0.01 --formulations standard --integrators rk4 --steps 1e-3",
    "bench rhs --mechanism FILE --solver block --repeats 2", "convert FILE again.json",
])  # fmt: skip
def test_commands_take_files(
    words: str, four_bar: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(four_bar.parent)
    code = run([str(four_bar) if word == "FILE" else word for word in words.split()], debug=True)
    assert (code, capsys.readouterr().err) == (0, "")


@pytest.mark.parametrize(("name", "message"), [
    ("run.h5", ".xml; it is that of a result, which `linkwork view run.h5` shows"),
    ("arm.urfd", "is none of a model: .json, .yaml, .yml, .urdf, .sdf, .mjcf, .xml; the nearest is '.urdf'"),
])  # fmt: skip
def test_extensions_that_are_taken_are_told(
    name: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    for command in ("run", "check"):
        assert run([command, name], debug=False) == 1
        assert message in capsys.readouterr().err


def test_a_file_gives_the_same_run_as_the_name(four_bar: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ran = []
    for subject in (str(four_bar), "four_bar"):
        assert run(["run", subject, "--t-end", "0.05", "--step", "1e-3", "--json"], debug=False) == 0
        ran.append(json.loads(capsys.readouterr().out)["result"])
    assert ran[0] == ran[1]


def test_python_functions_that_take_names_take_files(four_bar: Path) -> None:
    assert Subject.of(str(four_bar)).build().hash() == lw.mechanisms.four_bar().hash()
    assert lw.mechanisms.named(str(four_bar)).settings == {"t_end": 0.05, "step": 1e-3}
    with pytest.raises(lw.OptionError, match="no mechanism 'four_ba'; the nearest is 'four_bar'"):
        lw.mechanisms.named("four_ba")


def test_where_nothing_recommends_an_end_a_run_chooses_and_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Swings of sqrt(L / g), turns, tables; a comparison asks."""
    path = tmp_path / "model.json"
    lw.mechanisms.four_bar().save(path)
    assert run(["run", str(path), "--json"], debug=False) == 0
    shown = capsys.readouterr()
    assert "--t-end 5 (from its size, 0.5 m" in shown.err and "--rtol 1e-06" in shown.err
    assert json.loads(shown.out)["manifest"]["options"]["t_end"] == 5.0
    assert run(["compare", str(path)], debug=False) == 1
    assert capsys.readouterr().err.startswith("error: t_end is missing")


def test_the_usual_end_is_that_of_the_motion() -> None:
    top = lw.Model(gravity=(0, 0, 0))
    body = top.body(mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 4 * np.pi))
    top.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1))
    assert usual_end(top)[0] == 2.0  # three turns of 0.5 s, rounded
    pushed = lw.Model()
    body = pushed.body(mass=1.0, inertia=(1, 1, 1))
    pushed.force(body, force=(lw.functions.table([0, 0.7], [0, 1]), 0, 0))
    assert usual_end(pushed)[0] == 0.7


def test_errors_are_json_where_json_is_asked_for(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["run", "four_bar", "--t-end", "-1", "--json"], debug=False) == 1
    error = json.loads(capsys.readouterr().out)["error"]
    assert (error["type"], error["code"], error["exit_code"]) == ("OptionError", "t_end", 1)
    assert run(["run", "four_bar", "--no-such", "--json"], debug=False) == 2
    assert json.loads(capsys.readouterr().out)["error"]["type"] == "UsageError"


@pytest.mark.parametrize("name", ["arm.urdf", "four_bar.sdf", "slider_crank.xml"])
def test_robots_run_and_say_what_is_left_out(
    name: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    target = tmp_path / "out.yaml"
    assert run(["convert", str(ROBOTS / name), str(target), "--json"], debug=False) == 0
    told = json.loads(capsys.readouterr().out)
    with pytest.warns(lw.LinkworkWarning) if told["notes"] else nullcontext():
        assert run(["run", str(ROBOTS / name), "--t-end", "0.01", "--step", "1e-3"], debug=False) == 0
    assert lw.Model.load(target).body_count == told["bodies"]


GAINS = {"stabilization": "baumgarte", "baumgarte_alpha": 5.0, "baumgarte_beta": 5.0}
SOFT = {"formulation": "penalty", "penalty": 1e7}


@pytest.mark.parametrize(
    ("recommended", "given", "taken"),
    [
        (GAINS, "--stabilization none", {"stabilization": "none", "step": 1e-3}),
        (GAINS, "--integrator phem56", {"integrator": "phem56", "stabilization": "projection"}),
        (GAINS, "--baumgarte-alpha 7", {"baumgarte_alpha": 7.0, "baumgarte_beta": 5.0}),
        (SOFT, "--formulation standard", {"formulation": "standard"}),
        (SOFT, "--penalty-scale 1e5", {"penalty_scale": 1e5, "penalty": None}),
        ({"integrator": "rk4"}, "--rtol 1e-6", {"integrator": "dopri5", "rtol": 1e-6, "step": None}),
        ({"rtol": 1e-6}, "--integrator rk4", {"integrator": "rk4", "step": 1e-3}),
    ],
)  # fmt: skip
def test_what_is_given_takes_the_place_of_what_a_file_recommends(
    recommended: dict[str, object], given: str, taken: dict[str, object], tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    path = tmp_path / "model.yaml"
    lw.mechanisms.four_bar().save(path, simulation={"t_end": 0.01, "step": 1e-3, **recommended})
    assert run(["run", str(path), *given.split(), "--json"], debug=False) == 0
    options = json.loads(capsys.readouterr().out)["manifest"]["options"]
    assert {name: options.get(name) for name in taken} == taken


def test_a_report_chooses_what_nothing_says_as_a_run_does(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "model.json"
    lw.mechanisms.four_bar().save(path)
    words = ["report", str(path), "--t-end", "0.1", "-o", str(tmp_path / "page.html")]
    assert run(words, debug=False) == 0
    assert "--rtol" in capsys.readouterr().err
    assert (tmp_path / "page.html").exists()
