"""Progress: what is said, to whom, and when."""

from __future__ import annotations

import os
import pty
import re
import subprocess
import sys
import time

import pytest
from linkwork.progress import ProgressInfo, describe, reporting

TAKES_SECONDS = """
import sys, time
from linkwork.progress import reporting
with reporting({progress}, t_end=10.0, steps_total=100) as report:
    for step in range(1, 101):
        report(0.1 * step, step)
        time.sleep({seconds} / 100)
print("done")
"""


COUNTS_TASKS = """
import time
from linkwork.progress import counting
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


def test_line_on_a_terminal_appears_after_two_seconds() -> None:
    written = on_a_terminal("None", 3.0)
    assert "of 10 s" in written and "steps/s" in written and "left" in written
    assert "t = 1 of" not in written


@pytest.mark.parametrize("progress, seconds", [("None", 0.5), ("False", 2.5)])
def test_short_runs_and_quiet_ones_write_nothing(progress: str, seconds: float) -> None:
    assert on_a_terminal(progress, seconds) == ""


def test_tasks_in_a_series_say_which_one_runs_after_two_seconds() -> None:
    written = on_a_terminal("None", 3.0, COUNTS_TASKS)
    shown = [int(task) for task in re.findall(r"task (\d+) of 100", written)]
    assert shown and min(shown) > 30
    assert on_a_terminal("False", 2.5, COUNTS_TASKS) == ""


def test_reporting_costs_little_where_nothing_is_shown() -> None:
    with reporting(None, 1.0, 10**5) as report:
        start = time.perf_counter()
        for step in range(10**4):
            report(0.0, step)
        assert time.perf_counter() - start < 10**4 * 1e-5
