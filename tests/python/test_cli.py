"""The command `linkwork` as a user meets it: what it prints, where, and its exit codes."""

from __future__ import annotations

import json
import os
import resource
import signal
import socket
import stat
import subprocess
import sys
import time
from itertools import chain
from pathlib import Path
from typing import Any

import h5py
import pytest
from commands import running
from linkwork import FileError, Model, Result, import_urdf, simulate
from linkwork.cli import run
from linkwork.integrators import METHODS
from linkwork.mechanisms import MECHANISMS
from linkwork.options import TABLE, names

COMMAND = [sys.executable, "-c", "from linkwork.cli import main; main()"]
QUICK = ["--t-end", "0.05", "--step", "1e-3"]


def linkwork(*words: object, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """One command in a process of its own."""
    return subprocess.run([*COMMAND, *map(str, words)], capture_output=True, text=True, cwd=cwd, timeout=120)


class Screen:
    """One command in this process: its exit code, standard output and standard error."""

    def __init__(self, capture: pytest.CaptureFixture[str]) -> None:
        self.capture = capture

    def __call__(self, *words: object) -> tuple[int, str, str]:
        code = run([str(word) for word in words], debug=False)
        output = self.capture.readouterr()
        return code, output.out, output.err


@pytest.fixture
def screen(capsys: pytest.CaptureFixture[str]) -> Screen:
    return Screen(capsys)


def document(screen: Screen, *words: object) -> Any:
    """The JSON that a command prints, and nothing else."""
    code, out, err = screen(*words)
    assert (code, err) == (0, "")
    return json.loads(out, parse_constant=lambda word: pytest.fail(f"{word} is not JSON"))


# --- what the commands do ---


def test_version_is_that_of_the_package() -> None:
    import linkwork as lw

    assert linkwork("--version").stdout == f"linkwork {lw.__version__}\n"


def test_help_appears_quickly_and_without_the_slow_imports() -> None:
    program = """
import sys
from linkwork.cli import main
try:
    main(["--help"])
finally:
    print(sorted({"matplotlib", "h5py", "numpy", "rich"} & set(sys.modules)))
"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    output = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert output.splitlines()[-1] == "[]"
    assert after.ru_utime - before.ru_utime < 0.5


def test_every_command_explains_itself(screen: Screen) -> None:
    for words in ([], ["run"], ["check"], ["list"], ["demo"], ["run", "chain"], ["check", "chain"]):
        code, out, err = screen(*words, "--help")
        assert (code, err) == (0, ""), words
        assert "Usage: linkwork" in out, words


def test_list_names_every_mechanism_with_its_parameters(screen: Screen) -> None:
    from linkwork.mechanisms import MECHANISMS

    listed = document(screen, "list", "--json")
    assert [entry["name"] for entry in listed] == list(MECHANISMS)
    table = screen("list")[1]
    for entry in listed:
        assert entry["name"] in table and entry["description"]
        for parameter in entry["parameters"]:
            assert f"--{parameter['name'].replace('_', '-')}" in table


def test_every_mechanism_runs_and_is_checked_from_the_command_line(screen: Screen) -> None:
    for entry in document(screen, "list", "--json"):
        ran = document(screen, "run", entry["name"], "--json", "--t-end", "0.002", "--step", "0.0001")
        assert ran["result"]["t_end"] == pytest.approx(0.002), entry["name"]
        checked = document(screen, "check", entry["name"], "--json")
        assert checked["degrees_of_freedom"] == 6 * checked["bodies"] - checked["rank"], entry["name"]


def test_help_of_a_run_lists_every_option_and_every_name(screen: Screen) -> None:
    text = screen("run", "pendulum", "--help")[1]
    words = {word.strip(".,:;()") for word in text.split()}
    assert {"--" + name.replace("_", "-") for name in TABLE} <= words
    assert {*METHODS, *chain.from_iterable(names().values())} <= words


def test_options_reach_the_run_and_the_manifest(screen: Screen) -> None:
    options = {
        "integrator": "dopri5",
        "formulation": "augmented_lagrangian",
        "stabilization": "baumgarte",
        "baumgarte_alpha": 7.0,
        "baumgarte_beta": 8.0,
        "tolerance": 1e-9,
        "max_iterations": 17,
    }
    words = [word for name, value in options.items() for word in ("--" + name.replace("_", "-"), value)]
    said = document(screen, "run", "chain", "--bodies", 3, "--json", *QUICK, *words)["manifest"]["options"]
    assert {name: said[name] for name in options} == options
    assert (said["t_end"], said["step"]) == (0.05, 1e-3)


def test_run_with_a_tolerance_ignores_the_recommended_step(screen: Screen) -> None:
    found = document(screen, "run", "pendulum", "--t-end", "1", "--rtol", "1e-8", "--json")
    assert found["manifest"]["options"]["rtol"] == 1e-8
    assert found["manifest"]["options"]["largest_step"] is None
    assert found["statistics"]["largest_step"] > 1e-3


def test_run_with_a_tolerance_takes_a_given_step_as_the_largest(screen: Screen) -> None:
    words = (
        "run",
        "pendulum",
        "--t-end",
        "1",
        "--atol",
        "1e-8",
        "--step",
        "2e-3",
        "--integrator",
        "tsit5",
        "--json",
    )
    assert document(screen, *words)["statistics"]["largest_step"] <= 2e-3


def test_run_writes_the_result_and_the_picture_that_it_names(screen: Screen, tmp_path: Path) -> None:
    result, picture = tmp_path / "run.h5", tmp_path / "run.png"
    code, out, err = screen("run", "pendulum", *QUICK, "--output", result, "--plot", picture)
    assert (code, err) == (0, "")
    assert str(result) in out and str(picture) in out
    assert Result.load(result).t[-1] == pytest.approx(0.05)
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_parameters_of_a_mechanism_are_options(screen: Screen) -> None:
    assert document(screen, "run", "chain", "--bodies", 7, "--json", *QUICK)["result"]["bodies"] == 7


def test_check_counts_the_freedom_of_the_slider_crank(screen: Screen) -> None:
    found = document(screen, "check", "spatial_slider_crank", "--json")
    assert (found["degrees_of_freedom"], found["rank"], found["redundant_joints"]) == (1, found["rows"], [])
    assert max(joint["position"] for joint in found["residuals"]) < 1e-12


def test_check_names_the_redundant_joints_of_bricard(screen: Screen) -> None:
    found = document(screen, "check", "bricard", "--json")
    assert (found["rows"], found["rank"], found["degrees_of_freedom"]) == (30, 29, 1)
    code, out, _ = screen("check", "bricard")
    assert code == 0 and found["redundant_joints"]
    assert all(name in out for name in found["redundant_joints"])
    (group,) = found["dependent_groups"]
    assert {group["joint"], *group["joints"]} == {f"hinge {k}" for k in range(6)}
    assert group["text"].endswith("already fix") and group["text"] in " ".join(out.split())
    assert not any(joint["reaction_unique"] for joint in found["residuals"]) and "not unique" in out


def test_demo_compares_the_four_methods(screen: Screen, tmp_path: Path) -> None:
    shown = document(screen, "demo", "--output-dir", tmp_path, "--json")
    methods = {method["equations"]: method for method in shown["methods"]}
    assert {"12.3", "12.8", "12.14", "12.16-18"} < set(methods)
    assert methods["12.8"]["max_position_violation"] < methods["12.3"]["max_position_violation"]
    assert methods["12.16-18"]["iterations"] > methods["12.16-18"]["evaluations"]
    assert all(0 < method["reaction_difference"] < 0.1 for method in shown["methods"])
    assert Result.load(tmp_path / "linkwork-demo.h5").finished
    assert (tmp_path / "linkwork-demo.png").stat().st_size > 10_000
    (tmp_path / "linkwork-demo.h5").write_text("precious")
    code, _, err = screen("demo", "--output-dir", tmp_path)
    assert code == 1 and "linkwork-demo.h5': there is such a file already" in err
    assert (tmp_path / "linkwork-demo.h5").read_text() == "precious"


def test_demo_table_fits_a_terminal_of_80_columns(tmp_path: Path) -> None:
    environment = {**os.environ, "COLUMNS": "80", "TERM": "xterm"}
    shown = subprocess.run(
        [*COMMAND, "demo"], capture_output=True, text=True, cwd=tmp_path, env=environment, check=True
    )
    assert max(map(len, shown.stdout.splitlines())) <= 80
    assert "\x1b" not in shown.stdout
    assert shown.stderr == ""


# --- errors: one line that names the object and the value ---

MISTAKES = [
    # words, exit code, what the line says
    (["rnu"], 2, "no command 'rnu'; the nearest is 'run'"),
    (["run"], 2, "run needs a mechanism: "),
    (["run", "--t-end", "1"], 2, "no option --t-end before a mechanism: run needs that first"),
    (["run", "--hlep"], 2, "no option --hlep; the nearest is '--help'"),
    (["run", "pendulun"], 2, "no mechanism 'pendulun'; the nearest is 'pendulum'"),
    (["check", "brickard"], 2, "no mechanism 'brickard'; the nearest is 'bricard'"),
    (["run", "pendulum", "--stpe", "1"], 2, "no option --stpe; the nearest is '--step'"),
    (["run", "pendulum", "--step"], 2, "'--step' needs a value, which you give after it"),
    (["run", "pendulum", "--step", "tiny"], 2, "'--step': 'tiny' is not a number"),
    (
        ["run", "pendulum", "--t-end", "1e-400"],
        2,
        "'--t-end': 1e-400 is nearer to zero than any other number",
    ),
    (["compare", "pendulum", "--t-end", "-1e-999"], 2, "'--t-end': -1e-999 is nearer to zero than any other"),
    (["run", "pendulum", "now"], 2, "unexpected extra argument (now)"),
    (["run", "pendulum", "--step", "0"], 1, "step"),
    (["run", "pendulum", "--step", "-0.001"], 1, "-0.001"),
    (["run", "pendulum", "--step", "nan"], 1, "nan"),
    (["run", "pendulum", "--t-end", "-1"], 1, "-1"),
    (
        ["run", "pendulum", "--integrator", "rk44"],
        1,
        "integrator 'rk44' does not exist; the nearest is 'rk4'",
    ),
    (
        ["run", "pendulum", "--formulation", "standrad"],
        1,
        "'standrad' does not exist; the nearest is 'standard'",
    ),
    (["run", "pendulum", "--stabilization", "baum"], 1, "'baum' does not exist; the nearest is 'baumgarte'"),
    (["run", "pendulum", "--system", "kkt"], 2, "no option --system; it is called --matrix-form now"),
    (
        ["run", "pendulum", "--matrix-form", "shur"],
        1,
        "matrix_form 'shur' does not exist; the nearest is 'schur'",
    ),
    (
        ["run", "pendulum", "--linear-solver", "clhomod"],
        1,
        "'clhomod' does not exist; the nearest is 'cholmod'",
    ),
    (
        ["run", "pendulum", "--output", "/nowhere/run.h5"],
        1,
        "output '/nowhere/run.h5': cannot be written: no such",
    ),
    (
        ["run", "pendulum", "--plot", "/nowhere/run.png"],
        1,
        "output '/nowhere/run.png': cannot be written: no directory",
    ),
    (["run", "pendulum", "--plot", "run.pgn"], 1, "picture 'run.pgn': no format 'pgn'; the nearest is 'png'"),
    (["run", "pendulum", "--record-every", "0"], 1, "record_every"),
    (["run", "chain", "--bodies", "-3"], 1, "-3"),
    (["run", "chain", "--bodies", "many"], 2, "'--bodies': 'many' is not a whole number"),
    (["run", "chain", "--joint", "sferical"], 1, "'sferical' is not available; the nearest is 'spherical'"),
    (
        ["run", "bricard", "--matrix-form", "kkt", "--linear-solver", "dense"],
        1,
        "use matrix_form 'schur', or linear solver",
    ),
    (["demo", "--output-dir", "/proc/nowhere"], 1, "'/proc/nowhere'"),
]


@pytest.mark.parametrize("words, code, message", MISTAKES, ids=[" ".join(words) for words, *_ in MISTAKES])
def test_mistake_is_answered_in_one_line(screen: Screen, words: list[str], code: int, message: str) -> None:
    found, out, err = screen(*words)
    assert (found, out) == (code, "")
    assert err.startswith("error: ") and err.count("\n") == 1
    assert message in err
    assert "Traceback" not in err and "Usage" not in err


def test_process_ends_with_the_exit_code_and_without_traceback() -> None:
    done = linkwork("run", "pendulum", "--step", "-1")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("error: ") and done.stderr.count("\n") == 1


def test_debug_shows_the_traceback() -> None:
    done = linkwork("run", "pendulum", "--step", "-1", "--debug")
    assert done.returncode == 1 and "Traceback" in done.stderr


MODEL_MISTAKES = [
    ("model.body('bob', mass=-2.0, inertia=(1, 1, 1))", "'bob'", "-2"),
    ("model.body('bob', mass=float('nan'), inertia=(1, 1, 1))", "'bob'", "nan"),
    ("model.body('bob', mass=1.0, inertia=(1, 1, 3))", "'bob'", "3"),
    ("model.body('bob', mass=1.0, inertia=(1, 1, 1), orientation=(2, 0, 0, 0))", "'bob'", "2"),
    ("model.body('bob', mass=1.0, inertia=(1, 1, 1), orientation=(0, 0, 0, 0))", "'bob'", "0"),
    ("model.revolute(model.ground, a, at=(0, 0, 0), axis=(0, 0, 0), name='pin')", "'pin'", "0"),
    ("model.spherical(a, a, at=(0, 0, 0), name='ball')", "'ball'", "'a'"),
    ("model.body('a', mass=1.0, inertia=(1, 1, 1))", "'a'", "name"),
]


@pytest.mark.parametrize("line, name, value", MODEL_MISTAKES)
def test_mistake_in_a_model_reaches_the_terminal_in_one_line(
    screen: Screen, monkeypatch: pytest.MonkeyPatch, line: str, name: str, value: str
) -> None:
    import linkwork as lw
    from linkwork.mechanisms import MECHANISMS
    from linkwork.mechanisms.mechanism import Mechanism

    def broken() -> lw.Model:
        """A mechanism with a mistake."""
        model = lw.Model()
        a = model.body("a", mass=1.0, inertia=(1, 1, 1))
        exec(line, {"model": model, "a": a})
        return model

    monkeypatch.setitem(MECHANISMS, "broken", Mechanism(broken, t_end=0.1, step=1e-3))
    code, out, err = screen("run", "broken")
    assert (code, out, err.count("\n")) == (1, "", 1)
    assert err.startswith("error: ") and name in err and value in err


def test_warning_is_one_line_on_standard_error_and_the_run_goes_on() -> None:
    program = """
import sys, linkwork as lw
from linkwork.mechanisms import MECHANISMS
from linkwork.mechanisms.mechanism import Mechanism
def inconsistent():
    "A rod that moves away from its joint."
    model = lw.Model()
    rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0), velocity=(2.5e-4, 0, 0))
    model.spherical(model.ground, rod, at=(0, 0, 0), name="shoulder")
    return model
MECHANISMS["inconsistent"] = Mechanism(inconsistent, t_end=0.01, step=1e-3)
sys.argv = ["linkwork", "run", "inconsistent", "--json"]
from linkwork.cli import main
main()
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0 and json.loads(done.stdout)
    assert done.stderr.startswith("warning: ") and done.stderr.count("\n") == 1
    assert "shoulder 0.00025/s: corrected" in done.stderr


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupted_run_says_so_in_one_line_and_leaves_a_readable_file(
    number: signal.Signals, code: int, tmp_path: Path
) -> None:
    file = tmp_path / "run.h5"
    words = ["run", "spatial_slider_crank", "--t-end", "1e5", "--output", str(file), "--record-every", "100"]
    with running([*COMMAND, *words]) as command:
        wait_for_frames(file)
        command.send_signal(number)
        out, err = command.communicate(timeout=60)  # the run itself would take hours
    assert (command.returncode, out, err.count("\n")) == (code, "", 1)
    assert err.startswith("error: interrupted")
    result = Result.load(file)
    assert len(result) > 1 and not result.finished


@pytest.mark.parametrize("kind", ["device", "pipe", "socket"])
def test_what_is_no_file_is_neither_written_nor_read(kind: str, screen: Screen, tmp_path: Path) -> None:
    """Not even by a link to it: as root a device would be replaced, and a pipe waits for ever."""
    place = tmp_path / "run.h5"
    if kind == "pipe":
        os.mkfifo(place)
    elif kind == "socket":
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(place))
    else:
        place.symlink_to(os.devnull)
    for words in (
        ["run", "pendulum", "--t-end", "0.1", "--output"],
        ["compare", "pendulum", "--t-end", "0.1", "--csv"],
        ["repair"],
        ["view"],
    ):
        code, _, error = screen(*words, place)
        assert code == 1 and f"is no regular file but a {kind}" in error, error
    with pytest.raises(FileError, match="no regular file"):
        simulate(MECHANISMS["pendulum"].function(), 0.01, 1e-3, output=place)
    result = simulate(MECHANISMS["pendulum"].function(), 0.01, 1e-3)
    for write in (result.save, result.view):
        with pytest.raises(FileError, match="no regular file"):
            write(place)
    for name in ("model.yaml", "model.json", "robot.urdf"):
        (tmp_path / name).symlink_to(place)
        with pytest.raises(FileError, match=f"no regular file but a {kind}"):
            Model.load(tmp_path / name) if name != "robot.urdf" else import_urdf(tmp_path / name)
    assert not place.is_file() and stat.S_ISCHR(os.stat(os.devnull).st_mode)


def wait_for_frames(path: Path) -> None:
    """Until the file of a run that goes on has frames."""
    for _ in range(200):
        time.sleep(0.05)
        try:
            with h5py.File(path, "r", locking=False) as file:
                if len(file["frames/t"]):
                    return
        except (OSError, KeyError):
            continue
    pytest.fail("no frame after 10 s")


def test_progress_is_silent_when_standard_error_is_not_a_terminal() -> None:
    """Also where a line would be shown from the beginning."""
    program = "from linkwork.running import progress; progress.SILENT_SECONDS = 0.0; " + COMMAND[-1]
    words = ["run", "spatial_slider_crank", "--t-end", "60", "--step", "1e-3", "--on-inaccurate", "pass"]
    done = subprocess.run([*COMMAND[:-1], program, *words], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "")


def test_names_that_standard_output_has_no_letters_for_are_written_in_numbers(tmp_path: Path) -> None:
    model = Model(name="Stab \u0142")
    model.body("\u00fc", mass=1.0, inertia=(1, 1, 1))
    model.save(tmp_path / "model.yaml")
    words = [*COMMAND, "run", "model.yaml", "--t-end", "0.1", "--step", "0.01"]
    done = subprocess.run(
        words, capture_output=True, cwd=tmp_path, env={**os.environ, "PYTHONIOENCODING": "ascii"}, timeout=120
    )
    assert done.returncode == 0, done.stderr
    assert b"Stab \\u0142" in done.stdout
