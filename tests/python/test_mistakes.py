"""Wrong input of every kind for every command: one line that says what to do, and never a traceback."""

from __future__ import annotations

import shlex
from pathlib import Path

import linkwork as lw
import pytest
from linkwork.cli import run

#: A line that ends well has one of these.
ADVICE = ("; ", ": give ", "give ", "must be", "choose from", "the nearest is", "such as", "needs a ",
          "at least", "not a positive whole number", "is none of", "not one of", "add an ", "is no YAML",
          "is not NAME=VALUE", "is no XML", "commas between", "is missing")  # fmt: skip

#: Of all commands that take a mechanism.
OF_MECHANISMS = ("run", "check", "compare", "equilibrium", "linearize", "kinematics")

MISTAKES = [
    "export run.h5 --csv -", "plot run.h5 -o -", "run pendulum --output -", "--log - list",
    "nix", "--nix", "list extra", "schema extra", "completion", "completion powershell", "validate nix",
    "validate --nix", "--log nowhere/x list", "--log folder list",
    *(f"{command}{rest}" for command in OF_MECHANISMS for rest in (
        "", " nix", " nix.yaml", " broken.yaml", " empty.json", " broken.urdf", " text.txt", " folder",
        " pendulum --nix", " pendulum extra", " chain --bodies 0", " chain --bodies x",
        " chain --joint nix")),
    "run pendulum --step", "run pendulum --step x", "run pendulum --step nan", "run pendulum --t-end inf",
    "run pendulum --rtol 1e-6 --integrator rk4", "run pendulum --rtol 1", "run pendulum --rtol 1e-30",
    "run pendulum --penalty 1e7", "run pendulum --formulation penalty --penalty -1",
    "run pendulum --baumgarte-alpha 5", "run pendulum --max-iterations 0", "run pendulum --on-singular nix",
    "run pendulum --matrix-form nix",
    "run pendulum --violation-limit x", "run pendulum --violation-limit nix=1",
    "run pendulum --on-violation stop", "run pendulum --record-every 1.5", "run pendulum --tolerance 1",
    "run pendulum --output nowhere/run.h5", "run pendulum --output folder", "run pendulum --plot folder",
    "run pendulum --plot nowhere/run.png", "run pendulum --plot run.nix", "run pendulum --start nowhere.h5",
    "run pendulum --start junk.h5", "run pendulum --start cut.h5", "run four_bar --start run.h5",
    "run pendulum --start run.h5 --t-end 0.05",
    "compare pendulum --steps x", "compare pendulum --steps ,", "compare pendulum --steps 1e-2,-1",
    "compare pendulum --tolerances 0", "compare pendulum --integrators rk5",
    "compare pendulum --formulations nix", "compare pendulum --linear-solvers nix",
    "compare pendulum --stabilizations baumgarte:x", "compare pendulum --processes 0",
    "compare pendulum --time-limit -1", "compare pendulum --reference nowhere.h5",
    "compare four_bar --reference run.h5", "compare pendulum --reference run.h5 --t-end 5",
    "compare pendulum --reference-error 1e-3", "compare pendulum --error -1",
    "compare pendulum --html folder", "compare pendulum --html nowhere/c.html",
    "compare pendulum --plot c.nix", "compare pendulum --resume text.txt",
    "view", "view nowhere.h5", "view junk.h5", "view empty.h5", "view folder", "view cut.h5 --html v.html",
    "view run.h5 --html nowhere/v.html", "view run.h5 --html folder", "view run.h5 --limit x",
    "view run.h5 --with nowhere.h5 --html v.html", "view run.h5 --limit 1e-6 --html v.html",
    "report", "report pendulum", "report nix -o r.html", "report junk.h5 -o r.html",
    "report folder -o r.html", "report pendulum -o nowhere/r.html", "report pendulum -o folder",
    "report run.h5 -o r.html --t-end 1", "report pendulum -o r.html --step -1",
    "convert", "convert broken.urdf", "convert nowhere.urdf x.yaml", "convert text.txt x.yaml",
    "convert broken.urdf x.txt", "convert broken.urdf nowhere/x.yaml",
    "convert broken.urdf x.yaml --align-axes x",
    "linearize chain --modes 0", "linearize chain --near -1", "kinematics four_bar --t-end -1",
    "kinematics four_bar --step 0", "kinematics four_bar --output nowhere/x.h5",
    "kinematics four_bar", "kinematics four_bar --drive x", "kinematics four_bar --drive x=1",
    "kinematics four_bar --drive 'pin 0=x'",
    "demo --output-dir text.txt",
    "bench", "bench nix", "bench rhs --mechanism nix", "bench rhs --set x", "bench rhs --set x=1",
    "bench rhs --solver nix", "bench rhs --formulation nix", "bench rhs --repeats x", "bench rhs --limit -1",
    "bench scaling --bodies x", "bench step --nix",
]  # fmt: skip


@pytest.fixture(scope="module")
def inputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with files of every wrong kind, and a result."""
    folder = tmp_path_factory.mktemp("inputs")
    (folder / "folder").mkdir()
    for name, content in (("broken.yaml", "a: ["), ("empty.json", "{}"), ("broken.urdf", "<robot"),
                          ("junk.h5", "junk"), ("empty.h5", ""), ("text.txt", "text")):  # fmt: skip
        (folder / name).write_text(content)
    lw.simulate(lw.mechanisms.pendulum(), 0.1, 1e-2, output=folder / "run.h5", progress=False)
    (folder / "cut.h5").write_bytes((folder / "run.h5").read_bytes()[:3000])
    return folder


@pytest.mark.parametrize("line", MISTAKES)
def test_mistake_is_answered_with_what_to_do(
    line: str, inputs: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(inputs)
    code = run(shlex.split(line), debug=False)
    out, error = capsys.readouterr()
    assert (code in (1, 2), out) == (True, ""), line
    assert error.startswith("error: ") and error.count("\n") == 1
    assert "unexpected;" not in error
    assert any(advice in error for advice in ADVICE), error
