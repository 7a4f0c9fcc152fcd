"""What a large run will take is told before its first step, and changes nothing of it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.running import forecast


@pytest.fixture
def everything_large(monkeypatch: pytest.MonkeyPatch) -> None:
    for limit in ("LARGE_SECONDS", "LARGE_BYTES"):
        monkeypatch.setattr(forecast, limit, 0.0)


def test_a_small_run_says_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    result = lw.simulate(lw.mechanisms.pendulum(), t_end=1.0, step=1e-3, progress=True)
    assert "forecast" not in result.manifest
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize(
    "model, options",
    [
        (lw.mechanisms.four_bar(2), {"step": 1e-3}),  # passes singular poses
        (lw.mechanisms.four_bar(), {"rtol": 1e-6}),
        (lw.mechanisms.bricard(), {"step": 1e-2, "formulation": "augmented_lagrangian"}),
        (lw.mechanisms.net(3), {"step": 1e-3, "integrator": "hem4"}),
        (lw.mechanisms.tracked_chain(40), {"step": 1e-4, "integrator": "ab3"}),
    ],
)
def test_looking_ahead_changes_no_bit_and_no_count(
    model: lw.Model, options: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = lw.simulate(model, t_end=options.get("step", 1e-2) * 100, **options, on_inaccurate="pass")
    for limit in ("LARGE_SECONDS", "LARGE_BYTES"):
        monkeypatch.setattr(forecast, limit, 0.0)
    told = lw.simulate(model, t_end=options.get("step", 1e-2) * 100, **options, on_inaccurate="pass")
    assert "forecast" in told.manifest and "forecast" not in plain.manifest
    np.testing.assert_array_equal(told.q, plain.q)
    np.testing.assert_array_equal(told.v, plain.v)
    for count in ("evaluations", "factorizations", "solves", "iterations", "singular_poses"):
        assert told.statistics[count] == plain.statistics[count], count


@pytest.mark.usefixtures("everything_large")
def test_frames_take_as_much_as_was_told(tmp_path: Path) -> None:
    result = lw.simulate(lw.mechanisms.chain(300), t_end=0.1, step=1e-3, output=tmp_path / "run.h5")
    told = result.manifest["forecast"]
    assert told["steps"] == pytest.approx(100)
    assert len(result) <= told["frames"] <= len(result) + 3
    assert told["recorded"] == told["frames"] * told["frame_bytes"]
    assert (tmp_path / "run.h5").stat().st_size == pytest.approx(told["recorded"], rel=0.1)


@pytest.mark.usefixtures("everything_large")
def test_the_line_has_time_memory_and_file(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(forecast, "screen", lambda: True)
    lw.simulate(lw.mechanisms.chain(5), t_end=0.1, step=1e-3, output=tmp_path / "run.h5", progress=True)
    told = capfd.readouterr().err
    assert f"in '{tmp_path / 'run.h5'}' (103 frames)" in told
    assert told.startswith("expected: 0 s for 100 steps (each 4 x ")
    assert re.search(r"[MG]B of memory \(", told)
    lw.simulate(lw.mechanisms.chain(5), t_end=0.1, rtol=1e-6, progress=True)
    told = capfd.readouterr().err
    assert "a step (6 x " in told
    assert "as many steps as the tolerances ask for" in told
    assert "of that frames (1002 frames)" in told
    lw.simulate(lw.mechanisms.chain(5), t_end=0.1, step=1e-3, progress=False)
    assert capfd.readouterr().err == ""


@pytest.mark.usefixtures("everything_large")
def test_where_no_progress_is_shown_it_is_in_the_log(
    capfd: pytest.CaptureFixture[str], caplog: pytest.LogCaptureFixture
) -> None:
    with caplog.at_level("INFO"):
        lw.simulate(lw.mechanisms.chain(5), t_end=0.1, step=1e-3, progress=True)
    assert capfd.readouterr().err == ""
    assert any(text.startswith("expected: ") for text in caplog.messages)


ASKED = """
import linkwork as lw
result = lw.simulate(lw.mechanisms.chain(100_000), t_end=3e-3, step=1e-3, output="run.h5")
peak = next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM"))
print(result.manifest["forecast"]["memory"] / 1e3 / float(peak))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="asks Linux for the peak of its memory")
def test_memory_of_a_large_run_is_about_what_it_comes_to(tmp_path: Path) -> None:
    """In a process of its own: peaks stay."""
    done = subprocess.run([sys.executable, "-c", ASKED], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert 0.7 < float(done.stdout) < 1.3
