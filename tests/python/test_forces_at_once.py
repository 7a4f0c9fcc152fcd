"""Many force elements added at once are those that the kind's own method adds, whatever its arguments."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from generic_elements import added, arguments, bodies
from linkwork import _core

FORCES = {kind.name: kind for kind in _core.force_kinds()}


def at_once(kind: _core.KindInfo, count: int, **given: Any) -> lw.Model:
    model = bodies(count)
    a = "ground" if kind.name == "applied" else [f"a {k}" for k in range(count)]
    model.forces(kind.name, a, [f"b {k}" for k in range(count)], **given)
    return model


def one_by_one(kind: _core.KindInfo, given: list[dict[str, Any]]) -> lw.Model:
    model = bodies(len(given))
    for k, own in enumerate(given):
        added(model, kind, f"element {k}", k, **own)
    return model


@pytest.mark.parametrize("kind", FORCES.values(), ids=FORCES)
def test_the_arguments_of_one_are_those_of_many(kind: _core.KindInfo) -> None:
    """The same for all of them."""
    given = arguments(kind)
    assert at_once(kind, 2, **given).hash() == one_by_one(kind, [given, given]).hash()


@pytest.mark.parametrize("kind", FORCES.values(), ids=FORCES)
def test_what_a_method_can_do_without_many_can_do_without(kind: _core.KindInfo) -> None:
    method = getattr(lw.Model, "force" if kind.name == "applied" else kind.name)
    defaults = {what: it.default for what, it in inspect.signature(method).parameters.items()}
    needed = {what: x for what, x in arguments(kind).items() if defaults[what] is inspect.Parameter.empty}
    assert at_once(kind, 2, **needed).hash() == one_by_one(kind, [needed, needed]).hash()


@pytest.mark.parametrize("kind", FORCES.values(), ids=FORCES)
def test_each_of_many_has_its_own_of_every_argument(kind: _core.KindInfo) -> None:
    """Vectors and numbers with a leading k, pairs of such."""
    first = arguments(kind)
    second = {what: _another(what, x) for what, x in first.items()}
    both: dict[str, Any] = {}
    for what, x in first.items():
        both[what] = x if isinstance(x, str) else np.stack([x, second[what]], axis=max(0, np.ndim(x) - 1))
    assert at_once(kind, 2, **both).hash() == one_by_one(kind, [first, second]).hash()


def _another(what: str, value: Any) -> Any:
    """Value of an argument; pairs are turned round, and orientations stay unit."""
    if isinstance(value, str) or what == "orientation":
        return value
    return value[::-1] if np.ndim(value) == 2 else 2.0 * np.array(value)


@pytest.mark.parametrize("frame", ["inertial", "body"])
def test_forces_at_a_point_of_their_body_turn_it_about_its_center(frame: str) -> None:
    """J omega_dot = s x A^T F: points are in body coordinates, components inertial or in body axes."""
    s, F = np.array((0.1, 0.2, 0.0)), np.array((3.0, -1.0, 2.0))
    A = lw.rotation.matrix(lw.rotation.about((0, 0, 1), np.pi / 2))
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=1.0, inertia=(1.0, 2.0, 2.5), position=(2, 0, 0),
               orientation=lw.rotation.about((0, 0, 1), np.pi / 2))  # fmt: skip
    model.forces("applied", "ground", ["b"], force=F, at=s, frame=frame)
    result = lw.simulate(model, 1e-3, 1e-3, progress=False)
    in_body = F if frame == "body" else A.T @ F
    expected = np.cross(s, in_body) / (1.0, 2.0, 2.5)
    assert np.allclose(result.angular_acceleration[0, 0], expected, rtol=1e-14, atol=1e-14)
    assert np.allclose(result.acceleration[0, 0], A @ in_body, rtol=1e-14, atol=1e-14)


def test_components_are_in_the_axes_of_the_first_body() -> None:
    """Those of the body itself, which the frame says as well; of another body, which no frame says."""
    kind, given = FORCES["applied"], arguments(FORCES["applied"])
    own = bodies()
    own.forces("applied", ["b 0"], ["b 0"], **{**given, "frame": "body"})
    without = bodies()
    without.forces("applied", ["b 0"], ["b 0"], at=given["at"], force=given["force"], torque=given["torque"])
    assert own.hash() == without.hash() == one_by_one(kind, [given]).hash()
    with pytest.raises(lw.ModelError, match="frame 'body' are not the axes of a"):
        bodies().forces("applied", "a 0", "b 0", **given)


def test_points_in_space_of_applied_forces_are_said_to_be_such() -> None:
    """As they were given before, they would be taken for points in body coordinates."""
    components = {f"{what}_{axis}": 1.0 for what in ("force", "torque") for axis in "xyz"}
    model = bodies()
    r, A = model.compiled().q0[7:10], lw.rotation.matrix(model.compiled().q0[10:14])
    s = np.array((0.1, 0.2, 0.3))
    with pytest.raises(lw.ModelError, match='frames="space" for a point in space'):
        model.forces("applied", "ground", "b 0", at=r + A @ s, **components)
    model.forces("applied", "ground", "b 0", at=r + A @ s, frames="space", **components, name="lift")
    assert np.allclose(model.values("lift[0]")["attachment"]["origin"][1], s, rtol=0, atol=1e-15)
    with pytest.raises(lw.ModelError, match="'point' is none of its arguments"):
        model.forces("applied", "ground", "b 0", point=s)


@pytest.mark.parametrize(
    "kind", [it for it in FORCES.values() if it.name != "applied"], ids=lambda it: it.name
)
def test_between_points_of_one_body_forces_cancel_and_are_refused(kind: _core.KindInfo) -> None:
    model, given = bodies(2), arguments(kind)
    with pytest.raises(lw.ModelError, match=f"{kind.name} 'it': joins body 'b 0' to itself"):
        getattr(model, kind.name)("b 0", "b 0", name="it", **given)
    with pytest.raises(lw.ModelError, match=rf"{kind.name} 'it\[1\]': joins body 'a 1' to itself"):
        model.forces(kind.name, "a 1", ["b 1", "a 1"], name="it", **given)
    assert model.force_count == 0


def test_forces_on_the_ground_are_refused(tmp_path: Path) -> None:
    """By the method, at once, from a file, and where a body is replaced by it."""
    model = bodies()
    message = "'it': acts on b alone, and that is the ground"
    with pytest.raises(lw.ModelError, match=f"applied {message}"):
        model.force("ground", force=(1, 0, 0), name="it")
    with pytest.raises(lw.ModelError, match=f"drag {message}"):
        model.drag("a 0", "ground", at=(0, 0, 0), coefficient=1.0, name="it")
    model.force("b 0", force=(1, 0, 0), name="it")
    with pytest.raises(lw.ModelError, match="acts on b alone, and that is the ground"):
        model.replaced("it", body="ground")
    model.save(tmp_path / "model.yaml")
    text = (tmp_path / "model.yaml").read_text()
    (tmp_path / "model.yaml").write_text(text.replace("b: b 0", "b: ground"))
    with pytest.raises(lw.ModelFileError, match=r"forces\[0\].*the ground"):
        lw.Model.load(tmp_path / "model.yaml")
