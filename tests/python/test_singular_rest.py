"""Rest and small motions in singular poses, where a parallelogram lies folded flat, and beside them."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms import thin_rod

A, PLATE, CRANK, G, STIFFNESS = 0.3, 3.0, 0.5, 9.81, 7.0
INERTIA = A * A * (PLATE + 2 * CRANK / 3)
X, Y, Z = np.eye(3)


def parallelogram(
    angle: float, down: np.ndarray | None = None, *, redundant: bool = True, stiffness: float = 0.0
) -> lw.Model:
    model = lw.Model(gravity=np.zeros(3) if down is None else G * down, name="fold")
    u = A * np.array([np.cos(angle), 0.0, np.sin(angle)])
    model.body("plate", mass=PLATE, inertia=thin_rod(PLATE, 1.0), position=u + X / 2)
    for k in range(2):
        axes = lw.rotation.from_axes(u, Y)
        body = model.body(
            f"crank{k}", mass=CRANK, inertia=thin_rod(CRANK, A), position=k * X + u / 2, orientation=axes
        )
        model.revolute(model.ground, body, at=k * X, axis=Y, name=f"foot{k}")
        join = model.revolute if redundant or k == 0 else model.point_on_line
        join(body, "plate", at=k * X + u, axis=Y, name=f"head{k}")
    if stiffness:
        model.rotational_spring_damper(model.ground, "crank0", axis=Y, stiffness=stiffness)
    return model


def state(model: lw.Model) -> lw.Snapshot:
    core = model.compiled()
    return lw.Snapshot(0.0, core.q0.reshape(-1, 7), core.v0.reshape(-1, 6))


@pytest.mark.parametrize("redundant", [True, False])
@pytest.mark.parametrize("angle", [0.35, 0.5, 1.5, 1.65, 2.5])
def test_rest_folded_flat_is_refused_and_its_pose_is_told(angle: float, redundant: bool) -> None:
    with pytest.raises(lw.SingularSystemError, match="pose of rest .* is singular") as caught:
        lw.equilibrium(parallelogram(angle, X, redundant=redundant))
    assert caught.value.code == "singular_pose"
    assert set(caught.value.joints) == {"foot0", "foot1", "head0", "head1"}
    assert caught.value.state is not None
    assert caught.value.state.q[0, :3] == pytest.approx([A + 0.5, 0.0, 0.0], abs=1e-6)


@pytest.mark.parametrize("sparse", [False, True])
def test_a_start_folded_flat_is_refused(sparse: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    if sparse:
        monkeypatch.setattr("linkwork.constraints.solver.DENSE", 0)
    with pytest.raises(lw.ModelError, match="the pose of the model 'fold' is singular") as caught:
        lw.linearize(parallelogram(0.5, X), start=state(parallelogram(0.0, X)))
    assert caught.value.code == "singular_pose" and len(caught.value.joints) == 4


@pytest.mark.parametrize("angle", [0.0, 1e-9, np.pi])
def test_a_model_folded_flat_vibrates_about_a_start_that_is_not(angle: float) -> None:
    hanging = state(parallelogram(-np.pi / 2))
    frequencies = lw.linearize(parallelogram(angle, -Z), start=hanging).frequencies
    assert frequencies == pytest.approx([np.sqrt(G * A * (PLATE + CRANK) / INERTIA)], rel=1e-8)


@pytest.mark.parametrize("sparse", [False, True])
def test_beside_a_singular_pose_small_motions_are_told_as_long_as_there_are_digits(
    sparse: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if sparse:
        monkeypatch.setattr("linkwork.constraints.solver.DENSE", 0)
    expected = [np.sqrt(STIFFNESS / INERTIA)]
    near = parallelogram(1e-3, stiffness=STIFFNESS)
    assert lw.linearize(near).frequencies == pytest.approx(expected, rel=1e-6)
    nearer = parallelogram(1e-5, stiffness=STIFFNESS)
    with pytest.warns(lw.LinkworkWarning, match=r"nearly singular .* may be 0\.0\d+ % off"):
        assert lw.linearize(nearer).frequencies == pytest.approx(expected, rel=1e-3)
    with pytest.warns(lw.LinkworkWarning, match="pose of rest .* nearly singular"):
        assert lw.equilibrium(nearer).stability == "stable"
    with pytest.raises(lw.ModelError, match="is singular"):
        lw.linearize(parallelogram(1e-7, stiffness=STIFFNESS))
