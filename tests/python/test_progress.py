"""Progress: what is said, to whom, and when."""

from __future__ import annotations

import ast
import logging
import os
import pty
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import linkwork as lw
import pytest
from linkwork.running import progress
from linkwork.running.progress import ProgressInfo, describe, reporting

TAKES_SECONDS = """
import sys, time
from linkwork.running.progress import reporting
with reporting({progress}, t_end=10.0, steps_total=100) as report:
    for step in range(1, 101):
        report(0.1 * step, step)
        time.sleep({seconds} / 100)
print("done")
"""


COUNTS_TASKS = """
import time
from linkwork.running.progress import counting
with counting({progress}, 100) as report:
    for task in range(100):
        report(task, f"task {{task}} of 100")
        time.sleep({seconds} / 100)
print("done")
"""


def test_rate_and_remaining_time_follow_from_the_steps() -> None:
    info = ProgressInfo(t=2.5, t_end=10.0, steps_done=5000, steps_total=20000, elapsed=4.0)
    assert (info.fraction, info.rate, info.remaining) == (0.25, 1250.0, 12.0)
    assert describe(info) == "t = 2.5 of 10 s, 1.25k steps/s, 12 s left"


@pytest.mark.parametrize("seconds, text", [(3.4, "3 s"), (200, "3 min 20 s"), (7500, "2 h 5 min")])
def test_remaining_time_is_said_as_people_say_it(seconds: float, text: str) -> None:
    info = ProgressInfo(t=5.0, t_end=10.0, steps_done=1, steps_total=2, elapsed=seconds)
    assert describe(info).endswith(f", {text} left")


def test_function_of_the_user_is_called_at_every_report() -> None:
    seen: list[tuple[float, int, int]] = []
    with reporting(lambda i: seen.append((i.t, i.steps_done, i.steps_total)), 1.0, 4) as report:
        report(0.25, 1)
        report(1.0, 4)
    assert seen == [(0.25, 1, 4), (1.0, 4, 4)]


def on_a_terminal(progress: str, seconds: float, text: str = TAKES_SECONDS) -> str:
    """What a program above writes to a standard error that is a terminal."""
    try:
        screen, terminal = pty.openpty()
    except OSError as error:
        pytest.skip(f"this machine has no pseudo-terminals: {error}")
    words = [sys.executable, "-c", text.format(progress=progress, seconds=seconds)]
    program = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=terminal, text=True)
    os.close(terminal)
    written = b""
    while True:
        try:
            piece = os.read(screen, 4096)
        except OSError:
            break
        if not piece:
            break
        written += piece
    os.close(screen)
    assert program.communicate(timeout=10)[0] == "done\n"
    return written.decode()


def on_terminals(*programs: tuple[str, float, str]) -> list[str]:
    """Each on one of its own, at the same time: they wait most of it."""
    with ThreadPoolExecutor(len(programs)) as pool:
        return list(pool.map(lambda it: on_a_terminal(*it), programs))


def test_line_on_a_terminal_appears_after_two_seconds() -> None:
    written = on_a_terminal("None", 3.0)
    assert "of 10 s" in written and "steps/s" in written and "left" in written
    assert "t = 1 of" not in written


def test_line_has_step_and_violation_once_they_are_known() -> None:
    info = ProgressInfo(2.5, 10.0, 5000, 20000, 4.0, step=5e-4, violation=3.21e-12)
    assert describe(info).endswith("12 s left, step 0.0005 s, violation 3e-12")


def test_run_reports_its_step_and_its_violation() -> None:
    seen: list[ProgressInfo] = []
    model = lw.mechanisms.spatial_slider_crank()
    result = lw.simulate(model, 40.0, 1e-3, stabilization="none", record_every=100, progress=seen.append,
                         on_inaccurate="pass")  # fmt: skip
    assert seen[-1].violation == result.violation[-1, 0] > 0
    assert seen[-1].step == pytest.approx(1e-3)


SHARES = """
import time
from linkwork.running.progress import sharing
with sharing({progress}, "the verdict", {before}) as report:
    for part in range(100):
        report(part / 100)
        time.sleep({seconds} / 100)
print("done")
"""


def test_a_part_of_a_run_other_than_its_steps_says_what_it_is_and_how_long_it_takes() -> None:
    own, of_long_run = (SHARES.replace("{before}", before) for before in ("0.0", "10.0"))
    told, at_once, *quiet = on_terminals(
        ("None", 3.0, own), ("None", 0.0, of_long_run), ("False", 2.5, of_long_run), ("None", 0.5, own)
    )
    assert re.search(r"the verdict, \d s left", told)
    assert "the verdict" in at_once
    assert quiet == ["", ""]


PREPARES = """
import time
from linkwork.running.progress import preparing
with preparing({progress}, "preparing the run"):
    time.sleep({seconds})  # says nothing itself
print("done")
"""

AFTER_LONG_SETUP = """
import time
from linkwork.running.progress import reporting
with reporting({progress}, 10.0, 100, before=9.0):
    time.sleep({seconds})
print("done")
"""


def test_what_says_nothing_of_itself_is_told_of_while_it_lasts() -> None:
    written, *quiet = on_terminals(("None", 3.5, PREPARES), ("None", 0.5, PREPARES), ("False", 2.5, PREPARES))
    assert re.search(r"preparing the run, 2 s", written) and re.search(r"preparing the run, 3 s", written)
    assert "%" not in written  # nobody knows its share
    assert quiet == ["", ""]


def test_what_fails_while_it_is_told_of_fails_as_ever() -> None:
    with pytest.raises(ZeroDivisionError), progress.preparing(None, "preparing the run"):
        _ = 1 / 0


def test_the_first_frame_of_a_long_run_is_waited_for_before_a_line() -> None:
    assert "t = 0 of 10 s" in on_a_terminal("None", 0.0, AFTER_LONG_SETUP)
    assert on_a_terminal("False", 0.0, AFTER_LONG_SETUP) == ""


NOTEBOOK = """
import sys, types
shown = []
class Shell:
    kernel = "a kernel"
def display(data, raw, display_id, update):
    shown.append((data["text/plain"], display_id, update))
ipython, module = types.ModuleType("IPython"), types.ModuleType("IPython.display")
ipython.get_ipython, module.display = Shell, display
sys.modules.update({{"IPython": ipython, "IPython.display": module}})
"""


def test_line_in_a_notebook_is_one_output_that_is_replaced_and_emptied() -> None:
    program = NOTEBOOK + TAKES_SECONDS + "print(shown)"
    words = [sys.executable, "-c", program.format(progress="None", seconds=3.5)]
    done = subprocess.run(words, capture_output=True, text=True, check=True, stdin=subprocess.DEVNULL)
    shown = ast.literal_eval(done.stdout.splitlines()[-1])
    assert done.stderr == ""
    assert len(shown) >= 3 and len({name for _, name, _ in shown}) == 1
    assert [update for *_, update in shown] == [False] + [True] * (len(shown) - 1)
    assert "of 10 s" in shown[0][0] and shown[-1][0] == ""


def test_log_has_a_line_now_and_then_even_where_nothing_is_shown(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress._Log, "seconds", 0.0)
    monkeypatch.setattr(progress, "SILENT_SECONDS", 0.0)
    with caplog.at_level(logging.INFO, "linkwork"), reporting(False, 10.0, 100) as report:
        report(5.0, 50)
    assert [record.name for record in caplog.records] == ["linkwork.running.progress"]
    assert caplog.messages[0].startswith("50 %, t = 5 of 10 s")


def test_log_tells_how_a_run_began_and_ended(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, "linkwork"):
        lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3)
    began, ended = caplog.messages
    assert (
        "pendulum: 1 body, 1 distance; 1 constraint equation;" in began
        and "standard, sampled_baumgarte, rk4" in began
    )
    assert "done, 10 steps" in ended


@pytest.mark.parametrize("progress, seconds", [("None", 0.5), ("False", 2.5)])
def test_short_runs_and_quiet_ones_write_nothing(progress: str, seconds: float) -> None:
    assert on_a_terminal(progress, seconds) == ""


def test_tasks_in_a_series_say_which_one_runs_after_two_seconds() -> None:
    written, quiet = on_terminals(("None", 3.0, COUNTS_TASKS), ("False", 2.5, COUNTS_TASKS))
    shown = [int(task) for task in re.findall(r"task (\d+) of 100", written)]
    assert shown and min(shown) > 30
    assert quiet == ""


def test_no_text_is_made_where_nothing_is_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[ProgressInfo] = []
    monkeypatch.setattr(progress, "describe", made.append)
    monkeypatch.setattr(progress, "SILENT_SECONDS", 0.0)
    with reporting(False, 1.0, 10**5) as report:
        for step in range(100):
            report(0.0, step)
    assert made == []


def test_the_line_fits_80_columns() -> None:
    """Its last parts go first; what is longer still is cut."""
    info = ProgressInfo(12.345678, 1000.0, 123_456, 9_999_999, 3661.0, 1.23456e-5, 3e-12)
    whole = describe(info)
    assert len(whole) > 60
    for width in (100, 80, 60, 40, 20, 5):
        line = progress.fitting(whole, width)
        assert len(line) <= width
        assert whole.startswith(line.rstrip("…"))
    assert "left" in progress.fitting(whole, 80 - progress.BAR - 7)


def test_a_terminal_of_80_columns_has_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    import io

    from rich.console import Console

    monkeypatch.setenv("COLUMNS", "80")
    screen = io.StringIO()
    console = Console(file=screen, force_terminal=True, width=80, color_system=None)
    monkeypatch.setattr("rich.console.Console", lambda **_: console)
    terminal = progress._Terminal()
    info = ProgressInfo(12.345678, 1000.0, 123_456, 9_999_999, 3661.0, 1.23456e-5, 3e-12)
    terminal.show(0.5, describe(info))
    terminal.close()
    lines = [re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", line) for line in re.split(r"[\r\n]", screen.getvalue())]
    said = [line for line in lines if "t = 12.35" in line]
    assert said and all(len(line.rstrip()) <= 80 and "left" in line for line in said)
