"""The MJCF files of the package gymnasium (`./dev test --models`): every file loads or is refused with a true
reason, and what loads accelerates as in MuJoCo."""

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

#: Files that are refused as they are, with the words of the reason.
REFUSED = {
    "humanoid.xml": "tendons are not taken",
    "humanoidstandup.xml": "tendons are not taken",
    "pusher.xml": "no joint here does what",
    "pusher_v5.xml": "no joint here does what",
    "reacher.xml": "no joint here does what",
}

#: What MuJoCo's model has and ours has not, as the notes say.
DIFFERENT = {"medium", "damping", "nonlinear"}


def test_there_are_the_files_that_are_expected() -> None:
    assert ROBOTS.is_dir(), ROBOTS
    assert len(FILES) >= 10 and {path.name for path in FILES} >= set(REFUSED)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_file_loads_and_accelerates_as_in_mujoco_or_is_refused_with_the_reason(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Friction is left out: it is a soft constraint there and regularized here."""
    if path.name in REFUSED:
        with pytest.raises(lw.ModelFileError, match=REFUSED[path.name]):
            lw.import_mjcf(path)
        return
    disabled = mjcf_dynamics.is_disabled
    monkeypatch.setattr(mjcf_dynamics, "is_disabled", lambda m, *f: "frictionloss" in f or disabled(m, *f))
    topics = {note.topic for note in lw.import_mjcf(path).notes}
    worst = max(largest_difference(path, np.random.default_rng(seed), spread=0.5) for seed in range(5))
    assert worst < 1e-10 or topics & DIFFERENT, (worst, topics)
