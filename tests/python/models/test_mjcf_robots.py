"""The MJCF files of the package gymnasium (`./dev test --models`): every file loads and accelerates as in
MuJoCo, or a note says why not."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork.importers import mjcf_dynamics
from mujoco_comparison import largest_difference

pytestmark = pytest.mark.models


def _folder() -> Path:
    found = importlib.util.find_spec("gymnasium")
    return (
        Path(found.origin).parent / "envs/mujoco/assets"
        if found and found.origin
        else Path("gymnasium is missing")
    )


ROBOTS = _folder()
FILES = sorted(ROBOTS.glob("*.xml"))

#: What MuJoCo's model has and ours has not, as the notes say.
DIFFERENT = {"medium", "damping", "nonlinear"}


def test_there_are_the_files_that_are_expected() -> None:
    assert ROBOTS.is_dir(), ROBOTS
    assert len(FILES) >= 10 and "humanoid.xml" in {path.name for path in FILES}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_file_loads_and_accelerates_as_in_mujoco(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Friction is left out: it is a soft constraint there and regularized here."""
    disabled = mjcf_dynamics.is_disabled
    monkeypatch.setattr(mjcf_dynamics, "is_disabled", lambda m, *f: "frictionloss" in f or disabled(m, *f))
    topics = {note.topic for note in lw.import_mjcf(path).notes}
    worst = max(largest_difference(path, np.random.default_rng(seed), spread=0.5) for seed in range(5))
    assert worst < 1e-10 or topics & DIFFERENT, (worst, topics)
