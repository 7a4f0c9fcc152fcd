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


def side_by_side(*shares: float) -> lw.Model:
    """Such discs, 1 m apart across their way."""
    model = lw.Model()
    upright = lw.rotation.about((1, 0, 0), np.pi / 2)
    for k, share in enumerate(shares):
        center = (0.0, float(k), RADIUS)
        disc = model.body(f"body {k}", mass=MASS, inertia=(0.005, 0.005, 0.01), position=center,
                          orientation=upright, velocity=(0.5, 0, 0), omega=(0, 0, -0.5 / RADIUS))  # fmt: skip
        ends = ((0, float(k), 0), center)
        axes = ((0, 0, 1), (0, 1, 0))
        model.rolling_disc("ground", disc, at=ends, axes=axes, radius=RADIUS, name=f"disc {k}")
        model.force(disc, force=[0.0, 0.0, lw.functions.polynomial(0.0, share * MASS * GRAVITY)])
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


@pytest.mark.parametrize(
    ("shares", "who", "first", "most"),
    [((2.0, 4.0), "'disc 0', 'disc 1'", 0.25, 3.0), ((0.5, 2.0), "'disc 1'", 0.5, 1.0)],
)
def test_of_several_discs_those_that_lift_off_are_told_with_the_first_time_and_the_largest_pull(
    shares: tuple[float, float], who: str, first: float, most: float
) -> None:
    (text,) = told(lambda: lw.simulate(side_by_side(*shares), 1.0, rtol=1e-8, on_inaccurate="pass"))
    names, rest = text.split(": by t = ")
    assert names == who
    assert float(rest.split()[0]) == pytest.approx(first, abs=5e-3)
    assert float(rest.split(PULLS)[1].split()[0]) == pytest.approx(most * MASS * GRAVITY, rel=1e-2)


@pytest.mark.parametrize("speeds_up", [False, True])
@pytest.mark.parametrize("part", [0.96, 1.04])
def test_a_pull_counts_from_a_thousandth_of_the_largest_force_and_little_of_its_inertia_on(
    part: float, speeds_up: bool
) -> None:
    """Of m g at the start, and of m g + m v^2 / R a ten thousandth: at 3 m/s, the highest speed, ten m g."""
    speed = 3.0
    counts = 1e-3 + 1e-4 * (1 + speed**2 / RADIUS / GRAVITY)  # parts of m g
    model = lifted(1.0 + part * counts, speed=0.0 if speeds_up else speed)
    if speeds_up:  # in 1 s, with its inertia J = 0.01 kg m2
        model.force("disc", force=(speed * (MASS + 0.01 / RADIUS**2), 0, 0), name="push")
    assert bool(told(lambda: lw.simulate(model, 1.0, rtol=1e-9, on_inaccurate="pass"))) == (part > 1)
