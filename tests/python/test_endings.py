"""Runs that are ended from outside, and outputs that cannot be: one line, and whole files."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import linkwork as lw
import pytest
from linkwork import _core
from linkwork.running.interrupts import Terminated, honor_termination

LIMITED = """
import os, resource, sys
import linkwork as lw
from linkwork import mechanisms

model = mechanisms.four_bar()
for limit in map(int, sys.argv[2:]):
    pid = os.fork()
    if pid == 0:
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        path = f"{sys.argv[1]}/{limit}.h5"
        try:
            lw.simulate(model, 2.0, 1e-3, record_every=1, output=path, progress=False, on_inaccurate="pass")
            os._exit(10)
        except lw.FileError as error:
            os._exit(20 if error.code == "not_writable" else 30)
    print(limit, os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), flush=True)
"""


def test_a_file_that_may_not_grow_is_told_wherever_the_limit_is(tmp_path: Path) -> None:
    limits = [0, 24, 100, 2000, 8192, 20_000, 40_000, 100_000, 300_000, 310_000, 500_000, 1_200_000, 2**30]
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, tmp_path, *map(str, limits)], capture_output=True, text=True
    )
    codes = dict(map(int, line.split()) for line in done.stdout.splitlines())  # type: ignore[misc]
    assert codes == {**dict.fromkeys(limits, 20), 2**30: 10}, done.stderr[-500:]
    left = {int(path.stem): lw.Result.load(path) for path in tmp_path.iterdir()}
    assert all(not found.finished for limit, found in left.items() if limit < 2**30)
    assert len(left[1_200_000]) > 0 and left[2**30].status == "finished"


@pytest.mark.filterwarnings("ignore:the run takes")
@pytest.mark.parametrize("seconds", [0.0, 0.05, None], ids=["at once", "soon", "with its output"])
def test_termination_ends_a_run_also_where_it_is_set_up(tmp_path: Path, seconds: float | None) -> None:
    output = tmp_path / "run.h5"
    lw.simulate(lw.mechanisms.four_bar(), 0.01, 1e-3, output=tmp_path / "imports.h5", progress=False)
    before = signal.getsignal(signal.SIGTERM)
    honor_termination()
    soon = threading.Timer(seconds or 0.0, _terminate, [None if seconds is not None else output])
    try:
        with pytest.raises(Terminated):
            soon.start()
            lw.simulate(lw.mechanisms.net(60), 1e4, 1e-3, output=output, progress=False)
    finally:
        soon.cancel()
        soon.join()
        signal.signal(signal.SIGTERM, before)
    assert output.exists() or seconds is not None
    assert not output.exists() or lw.Result.load(output).status == "interrupted"


def _terminate(output: Path | None) -> None:
    """This process, once it has begun to write this file."""
    until = time.monotonic() + 60
    while output is not None and not output.exists() and time.monotonic() < until:
        time.sleep(0.01)
    os.kill(os.getpid(), signal.SIGTERM)


def test_termination_of_a_command_is_a_line_and_its_exit_code(tmp_path: Path) -> None:
    command = [
        sys.executable,
        "-c",
        "from linkwork.cli import main; main()",
        "run",
        "four_bar",
        "--t-end",
        "1e4",
        "--step",
        "1e-4",
        "--json",
    ]
    output = tmp_path / "run.h5"
    process = subprocess.Popen([*command, "--output", output], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while not output.exists():
        assert process.poll() is None
    process.send_signal(signal.SIGTERM)
    said, complaint = process.communicate()
    assert process.returncode == 143
    assert json.loads(said)["error"].items() >= {"code": "interrupted", "exit_code": 143}.items()
    assert complaint.decode().startswith("error: interrupted") and complaint.count(b"\n") == 1
    assert lw.Result.load(output).status == "interrupted"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no such device here")
@pytest.mark.parametrize("words", [["list", "joints"], ["run", "pendulum", "--json"]])
def test_output_for_which_there_is_no_room_is_an_error_in_one_line(words: list[str]) -> None:
    command = [sys.executable, "-c", "from linkwork.cli import main; main()", *words]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 1
    assert done.stderr.decode().startswith("error: standard output: no space left on device")
    assert done.stderr.count(b"\n") == 1


COMMAND = f'"{sys.executable}" -m linkwork'
IN_SHELL: dict[str, Any] = {"shell": True, "check": False, "text": True}


@pytest.mark.parametrize("words", [
    "list", "list joints --json", "check four_bar", "schema", "linearize four_bar", "--help", "run --help",
    "run four_bar --t-end 0.01", "run four_bar --t-end 0.01 --json",
])  # fmt: skip
def test_standard_output_that_is_closed_is_an_error_in_one_line(words: str) -> None:
    done = subprocess.run(f"{COMMAND} {words} >&-", stderr=subprocess.PIPE, **IN_SHELL)
    *notes, error = done.stderr.splitlines()
    assert (error, done.returncode) == ("error: standard output: bad file descriptor", 1)
    assert all(line.startswith(("note: ", "warning: ")) for line in notes)


def test_no_file_takes_the_place_of_standard_output_that_is_closed(tmp_path: Path) -> None:
    source, target = tmp_path / "source.yaml", tmp_path / "target.yaml"
    lw.mechanisms.four_bar().save(source)
    done = subprocess.run(f'{COMMAND} convert "{source}" "{target}" >&-', stderr=subprocess.PIPE, **IN_SHELL)
    assert lw.Model.load(target).hash() == lw.Model.load(source).hash()
    assert (done.stderr, done.returncode) == ("error: standard output: bad file descriptor\n", 1)


@pytest.mark.parametrize("end", ["2>&-", "2>/dev/full"])
@pytest.mark.parametrize(("words", "code"), [
    ("run four_bar --t-end 0.01 --json", 0), ("list joints --json", 0), ("run for_bar", 2),
    ("run four_bar --t-end -1 --json", 1),
])  # fmt: skip
def test_standard_error_that_takes_nothing_leaves_output_and_exit_code_alone(
    words: str, code: int, end: str
) -> None:
    """Notes and errors do not come between what is printed."""
    done = subprocess.run(f"{COMMAND} {words} {end}", stdout=subprocess.PIPE, **IN_SHELL)
    assert done.returncode == code
    assert "--json" not in words or json.loads(done.stdout)
    assert "error: " not in done.stdout and "note: " not in done.stdout


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no such device here")
@pytest.mark.parametrize(
    ("words", "code"), [("run pendulum --t-end 0.01", 1), ("run pendulum --t-end -1", 1), ("run nix", 2)]
)
def test_a_log_for_which_there_is_no_room_is_named(words: str, code: int) -> None:
    done = subprocess.run(f"{COMMAND} --log /dev/full {words}", stderr=subprocess.PIPE, **IN_SHELL)
    last = done.stderr.splitlines()[-1]
    assert last.startswith("error: log '/dev/full': cannot be written: no space left on device")
    assert done.returncode == code and "Traceback" not in done.stderr


HEAP = b"GCOL\x01\x00\x00\x00"


@pytest.mark.parametrize("content", [b"\0", b"\xff"])
def test_texts_of_a_result_that_are_lost_do_not_hold_up_whoever_reads_it(
    tmp_path: Path, content: bytes
) -> None:
    path = tmp_path / "run.h5"
    lw.simulate(lw.mechanisms.pendulum(), 0.1, 1e-2, progress=False).save(path)
    whole = path.read_bytes()
    read = """import sys, linkwork as lw
try: lw.Result.load(sys.argv[1])
except lw.FileError as e: print(e.code)"""
    for heap in re.finditer(re.escape(HEAP), whole):
        size = int.from_bytes(whole[heap.end() : heap.end() + 8], "little")
        start, end = heap.start() + 48, heap.start() + size
        path.write_bytes(whole[:start] + (end - start) * content + whole[end:])
        found = subprocess.run(
            [sys.executable, "-c", read, path], capture_output=True, text=True, timeout=60, check=True
        )
        assert found.stdout == "not_readable\n"


NO_MEMORY = """
import os, resource, sys
import linkwork as lw
from linkwork import mechanisms

system = lw.System(mechanisms.four_bar(5))
system.derivative(0.0, system.initial_state())  # everything is loaded by now
taken = 4096 * int(open("/proc/self/statm").read().split()[0])
resource.setrlimit(resource.RLIMIT_AS, (taken + 64 * 2**20,) * 2)
for choice in ({"linear_solver": "spqr"}, {"linear_solver": "umfpack"}, {"linear_solver": "klu"},
               {"linear_solver": "cholmod_supernodal", "matrix_form": "schur"}):
    try:
        lw.System(mechanisms.four_bar(5), **choice).derivative(0.0, system.initial_state())
        print("done")
    except MemoryError:
        print("no memory")
    except lw.OptionError:
        print("not here")
"""
SOLVERS = ("spqr", "umfpack", "klu", "cholmod_supernodal")


def test_solvers_with_blas_refuse_where_there_is_no_memory_for_its_buffer() -> None:
    """OpenBLAS itself tries again for ever; room of 129 MB is asked for before, and there are 64 MB."""
    done = subprocess.run([sys.executable, "-c", NO_MEMORY], capture_output=True, text=True, timeout=120)
    assert done.stderr == ""
    expected = ["no memory", "no memory", "done", "no memory"]
    there = {it.name for it in _core.linear_solvers() if it.available}
    assert done.stdout.splitlines() == [
        word if name in there else "not here" for name, word in zip(SOLVERS, expected, strict=True)
    ]


@pytest.mark.parametrize("how", ["law", "violation"])
def test_the_file_of_a_run_that_failed_says_so(tmp_path: Path, how: str) -> None:
    """As the result that its error has: nothing of it is lost."""
    output = tmp_path / "run.h5"
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("a", mass=1.0, inertia=(0.01, 0.08, 0.09), position=(0.5, 0, 0))
    model.revolute("ground", "a", at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.force("a", force=(0, 0, lambda t: 1 / 0 if how == "law" and t > 0.5 else 3.0))
    drifting: Any = {
        "on_violation": "stop",
        "stabilization": "none",
        "integrator": "euler",
        "violation_limit": 1e-3,
    }
    error, options = (ZeroDivisionError, {}) if how == "law" else (lw.ViolationError, drifting)
    with pytest.raises(error) as failure:
        lw.simulate(model, 1.0, 1e-3, output=output, **options)
    result = lw.Result.load(output)
    assert result.status == failure.value.result.status == "failed"
    assert result.missing == () and not result.finished and result.verdict is None
    assert result.statistics == failure.value.result.statistics
    assert 0 <= result.statistics["steps"] - (len(result) - 1) <= 1 and len(result) > 100
