"""Files that version 0.1.0 wrote are read, and what they describe moves as it did then."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import linkwork as lw
import numpy as np
import pytest
from linkwork import _core

FILES = Path(__file__).parent / "first_release"

#: x(t) [m] of every driven slide of every_function.yaml.
DRIVEN: dict[str, Callable[[float], float]] = {
    "constant": lambda t: 0.0,
    "polynomial": lambda t: 1.5 * t**2,
    "harmonic": lambda t: 0.3 * math.sin(4.0 * t),
    "cycloidal": lambda t: cycloid((t - 0.1) / 0.2),
    "expression": lambda t: 0.2 * math.sin(3 * t) ** 2,
    "table": lambda t: 0.1 * t**3 * (1 + t),
    "piecewise_polynomial": lambda t: t**2 if t < 0.25 else 0.0625 + 0.5 * (t - 0.25) - 0.5 * (t - 0.25) ** 2,
    "sum": lambda t: 0.3 * math.sin(4.0 * t) + cycloid(t / 0.2),
}


def cycloid(part: float) -> float:
    part = min(max(part, 0.0), 1.0)
    return part - math.sin(2 * math.pi * part) / (2 * math.pi)


@pytest.fixture(scope="module")
def result() -> lw.Result:
    return lw.Result.load(FILES / "every_kind.h5")


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_a_model_file_of_every_kind_moves_as_its_result(suffix: str, result: lw.Result) -> None:
    model = lw.Model.load(FILES / f"every_kind{suffix}")
    assert model.name == "every kind of joint and force" and model.body_count == 25
    again = lw.simulate(
        model, t_end=0.02, step=1e-4, integrator="rk4", record_every=20, on_inaccurate="pass", progress=False
    )
    assert np.array_equal(again.t, result.t)
    assert np.abs(again.q - result.q).max() < 1e-8
    assert np.abs(again.v - result.v).max() < 1e-6  # m/s, of up to 24


def test_a_result_is_whole_and_its_model_too(result: lw.Result) -> None:
    assert result.finished and not result.missing and len(result) == 11
    assert "damage there goes unseen" in result.manifest["digests"]
    assert result.violation[:, :2].max() < 1e-6
    assert np.isfinite(result.multipliers).all() and result.multipliers.any()


def test_a_run_goes_on_from_a_result_and_says_what_it_does_not_know(result: lw.Result) -> None:
    model = lw.Model.load(FILES / "every_kind.yaml")
    turns = pytest.warns(lw.LinkworkWarning, match="full turns are not in the state")
    contacts = pytest.warns(lw.LinkworkWarning, match="a contact began is not in the state")
    with turns, contacts:
        rest = lw.simulate(
            model, t_end=0.02, step=1e-4, integrator="rk4", start=result.snapshot(5), progress=False,
            on_inaccurate="pass",
        )  # fmt: skip
    assert np.array_equal(rest.q[0], result.q[5]) and rest.finished


def test_files_of_a_later_release_are_refused(tmp_path: Path) -> None:
    result, model = tmp_path / "later.h5", tmp_path / "later.yaml"
    shutil.copy(FILES / "every_kind.h5", result)
    with h5py.File(result, "r+") as file:
        file.attrs["version"] = 99
    with pytest.raises(lw.FileError, match="version 99.*update linkwork"):
        lw.Result.load(result)
    text = (FILES / "every_kind.yaml").read_text()
    model.write_text(text.replace("linkwork: 1\n", "linkwork: 99\n"))
    with pytest.raises(lw.FileError, match="99"):
        lw.Model.load(model)


@pytest.mark.parametrize("given", [{"step": 1e-3, "integrator": "rk4"}, {"rtol": 1e-8}])
@pytest.mark.filterwarnings("ignore:the rate of")
def test_every_function_of_time_drives_as_it_is_written(given: dict[str, Any]) -> None:
    model = lw.Model.load(FILES / "every_function.yaml")
    moved = lw.simulate(model, t_end=0.4, progress=False, on_inaccurate="pass", **given)
    for name, x in DRIVEN.items():
        expected = [0.5 + x(t) for t in moved.t]
        assert moved.q[:, moved.body_names.index(name), 0] == pytest.approx(
            expected, abs=1e-5
        ), name  # a table of eleven samples


def test_the_files_have_every_kind_of_the_first_release() -> None:
    text = (FILES / "every_kind.yaml").read_text() + (FILES / "every_function.yaml").read_text()
    kinds = {line.split()[-1] for line in text.splitlines() if line.strip().startswith("- kind:")}
    known = {kind.name for kind in (*_core.joint_kinds(), *_core.force_kinds())}
    assert kinds <= known and len(kinds) >= 30, (len(kinds), known - kinds)
