"""Rolling discs that the joint holds down where they would lift off their plane: runs and analyses say so."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest

MASS, RADIUS, GRAVITY = 2.0, 0.1, 9.81
PULLS = "the plane pulls at the disc, with up to "


def lifted(
    share: float, *, speed: float = 0.5, gravity: float = GRAVITY, turn: Any = (1.0, 0, 0, 0)
) -> lw.Model:
    """A disc that rolls upright along x, pulled upward by share m g t; all of it turned in space."""
    A = lw.rotation.matrix(turn)
    model = lw.Model(gravity=A @ (0, 0, -gravity))
    upright = lw.rotation.from_matrix(A @ lw.rotation.matrix(lw.rotation.about((1, 0, 0), np.pi / 2)))
    center = A @ (0, 0, RADIUS)
    disc = model.body("disc", mass=MASS, inertia=(0.005, 0.005, 0.01), position=center, orientation=upright,
                      velocity=A @ (speed, 0, 0), omega=(0, 0, -speed / RADIUS))  # fmt: skip
    model.rolling_disc(
        "ground", disc, at=((0, 0, 0), center), axes=(A[:, 2], A[:, 1]), radius=RADIUS, name="disc"
    )
    if share:
        model.force("disc", force=[lw.functions.polynomial(0.0, share * MASS * GRAVITY * z) for z in A[:, 2]])
    return model


def told(call: Any) -> list[str]:
    result = call()
    found = [line[10:] for line in result.summary().splitlines() if line.startswith("discs")]
    assert found == [it for it in [result.statistics.get("lifting_discs")] if it]
    return found


@pytest.mark.parametrize("turn", [(1.0, 0, 0, 0), (0.5, -0.5, 0.5, 0.5), (0.1, 0.7, 0.1, 0.7)])
@pytest.mark.parametrize("method", [{"rtol": 1e-8}, {"step": 1e-2}, {"step": 1e-2, "formulation": "penalty"}])
def test_a_run_says_when_a_disc_would_lift_off(turn: Any, method: Any) -> None:
    """N = m g - F along the normal: m g (1 - 2 t), negative from 0.5 s on, m g at the end."""
    turn = np.array(turn) / np.linalg.norm(turn)
    (text,) = told(lambda: lw.simulate(lifted(2.0, turn=turn), 1.0, on_inaccurate="pass", **method))
    when, most = text.split("by t = ")[1].split()[0], text.split(PULLS)[1].split()[0]
    assert text.startswith("'disc': by t = ")
    assert float(when) == pytest.approx(0.5, abs=2e-2) and float(when) > 0.5
    assert float(most) == pytest.approx(MASS * GRAVITY, rel=1e-2)


@pytest.mark.parametrize("disc", [{"share": 0.99}, {"share": 0.0}, {"share": 0.0, "gravity": 0.0},
                                  {"share": 0.0, "gravity": 0.0, "speed": 0.0}])  # fmt: skip
@pytest.mark.parametrize("method", [{"rtol": 1e-6}, {"step": 1e-2}])
def test_a_disc_that_its_plane_holds_up_or_leaves_alone_is_silent(disc: Any, method: Any) -> None:
    assert not told(lambda: lw.simulate(lifted(**disc), 1.0, on_inaccurate="pass", **method))


def test_kinematics_says_so() -> None:
    driven = lifted(2.0)
    driven.displacement_driver("ground", "disc", at=(0, 0, RADIUS), axis=(1, 0, 0), name="push",
                               displacement=lw.functions.polynomial(0.0, 0.5))  # fmt: skip
    driven.parallel_axes("ground", "disc", axis=(0, 1, 0), name="upright")
    assert told(lambda: lw.kinematics(driven, np.linspace(0, 1, 101)))
