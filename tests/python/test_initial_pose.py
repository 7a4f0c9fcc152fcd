"""The initial pose of a model, looked at before anything is computed."""

from __future__ import annotations

import json
import re
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import run
from linkwork.mechanisms import MECHANISMS
from linkwork.results.initial_pose import initial_pose


@pytest.fixture
def broken_door() -> lw.Model:
    """A wheel hung beside its pin, its axis askew, and a coupler that is off; nothing could simulate it."""
    model = lw.Model(name="broken door")
    door = model.body("door", mass=1.0, inertia=(1, 1, 1), position=(0.5, 0, 0))
    wheel = model.body("wheel", mass=1.0, inertia=(1, 1, 1), position=(1.5, 0.2, 0))
    model.revolute("ground", door, at=(0, 0, 0), axis=(0, 0, 1), name="hinge")
    axes = ((0, 0, 1), (0, np.sin(0.1), np.cos(0.1)))
    model.revolute(door, wheel, at=((0.5, 0, 0), (-0.5, 0, 0.1)), axis=axes, frames="body", name="pin")
    return model


def runs_of(page: str) -> list[dict[str, object]]:
    found = re.search(r'<script id="runs" type="application/json">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


def test_joints_that_do_not_hold_are_named_with_their_gaps(broken_door: lw.Model) -> None:
    (run,) = runs_of(broken_door.view().html)
    gap = np.sqrt(0.2**2 + 0.1**2)
    assert run["still"]
    assert run["loose"] == [[1, f"{gap:.3g} m apart, {np.degrees(0.1):.3g} deg askew"]]


def test_pose_is_that_of_the_model_to_the_last_bit(broken_door: lw.Model) -> None:
    pose = initial_pose(broken_door)
    assert np.array_equal(pose.q.ravel(), broken_door.compiled().q0)
    assert len(pose) == 1 and not pose.finished


def test_a_violation_that_no_points_show_is_told_by_its_residual() -> None:
    model = lw.Model()
    a, b = (model.body(mass=1.0, inertia=(1, 1, 1), position=(k, 0, 0)) for k in (1, 2))
    first = model.revolute("ground", a, at=(1, 0, 0), axis=(0, 0, 1))
    second = model.revolute("ground", b, at=(2, 0, 0), axis=(0, 0, 1))
    model.coupler([(first, 1.0), (second, 2.0)], name="belt")
    assert initial_pose(model).manifest["loose"] == {}
    shifted = model.with_initial_state(model.compiled().q0.reshape(-1, 7) + turned(0.3), np.zeros((2, 6)))
    assert initial_pose(shifted).manifest["loose"] == {2: "off by 0.6"}


def turned(angle: float) -> np.ndarray:
    """What turns the second of two bodies about z."""
    change = np.zeros((2, 7))
    change[1, 3:] = np.cos(angle / 2) - 1, 0, 0, np.sin(angle / 2)
    return change


@pytest.mark.parametrize("name", sorted(MECHANISMS))
def test_every_mechanism_holds_in_its_initial_pose(name: str) -> None:
    mechanism = MECHANISMS[name]
    model = mechanism.function(**{it.name: it.default for it in mechanism.parameters})
    if model.body_count <= 100:
        assert initial_pose(model).manifest["loose"] == {}


def test_picture_has_names_and_gaps(broken_door: lw.Model, tmp_path: Path) -> None:
    figure = broken_door.plot(tmp_path / "pose.png")
    words = [text.get_text() for text in figure.axes[0].texts]
    assert {"door", "wheel", "x", "y", "z"} <= set(words)
    assert any(word.startswith("pin: 0.224 m apart") for word in words)
    assert (tmp_path / "pose.png").read_bytes().startswith(b"\x89PNG")


def test_a_model_without_bodies_is_refused() -> None:
    with pytest.raises(lw.ModelError, match="has no bodies: there is nothing to view"):
        lw.Model(name="empty").view()


def test_command_views_mechanisms_and_files(
    broken_door: lw.Model, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    broken_door.save(tmp_path / "door.yaml")
    for number, source in enumerate(("four_bar", str(tmp_path / "door.yaml"))):
        assert run(["view", source, "--html", str(tmp_path / f"page{number}.html")], debug=False) == 0
        assert f"page{number}.html" in capsys.readouterr().out
    assert runs_of((tmp_path / "page1.html").read_text())[0]["loose"]
    assert run(["view", "fuor_bar", "--html", str(tmp_path / "other.html")], debug=False) == 1
    assert "four_bar" in capsys.readouterr().err
