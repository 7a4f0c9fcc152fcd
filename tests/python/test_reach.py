"""Runs whose drivers ask for more than the joints allow: they end, and say why, by any method."""

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.running import reach

#: Of the cylinder: its ends, and its speed [m/s].
ENDS, SPEED = ((0.5, 0.0, -1.0), (1.5, 0.0, -0.1)), 2.0

METHODS: list[dict[str, Any]] = [
    {"step": 1e-3},
    {"step": 0.05},
    {"step": 1e-3, "formulation": "penalty"},
    {"step": 1e-3, "formulation": "augmented_lagrangian"},
    {"step": 1e-3, "stabilization": "none"},
    {"step": 1e-3, "stabilization": "projection"},
    {"step": 1e-3, "integrator": "hem4"},
    {"rtol": 1e-6},
]


def excavator(*, speed: float = SPEED, free: bool = False) -> lw.Model:
    """A boom that a cylinder turns about its foot; `free`: on a cart with a spring, a bucket hangs on it."""
    model = lw.Model(name="excavator")
    base: lw.Body = model.ground
    if free:
        base = model.body("cart", mass=3000.0, inertia=(100.0, 100.0, 100.0), position=(0, 0, -1))
        model.translational("ground", base, at=(0, 0, -1), axis=(1, 0, 0), name="rail")
        at = ((-3, 0, -1), (0, 0, -1))
        model.spring_damper("ground", base, at=at, stiffness=1e5, damping=1e4)
    boom = model.body("boom", mass=500.0, inertia=(50.0, 400.0, 400.0), position=(2, 0, 0))
    model.revolute(base, boom, at=(0, 0, 0), axis=(0, 1, 0), name="foot")
    start = float(np.linalg.norm(np.subtract(*ENDS)))
    model.distance(base, boom, at=ENDS, length=lw.functions.polynomial(start, speed), name="cylinder")
    if free:
        model.body("bucket", mass=50.0, inertia=(5.0, 5.0, 5.0), position=(4, 0, -1))
        model.spherical(boom, "bucket", at=(4, 0, 0), name="hook")
    return lw.assemble(model).model


def longest() -> float:
    """When the ends of the cylinder and the foot between them are in line [s]."""
    arms = [float(np.linalg.norm(end)) for end in ENDS]
    return (sum(arms) - float(np.linalg.norm(np.subtract(*ENDS)))) / SPEED


@pytest.mark.parametrize("free", [False, True])
@pytest.mark.parametrize("method", METHODS, ids=lambda it: "-".join(str(value) for value in it.values()))
def test_a_boom_that_its_cylinder_pushes_beyond_reach_says_so(method: dict[str, Any], free: bool) -> None:
    with pytest.raises(lw.LinkworkError, match="cannot follow its drivers beyond") as found:
        lw.simulate(excavator(free=free), 5.0, progress=False, **method)
    error = found.value
    assert sorted(error.joints) == ["cylinder", "foot"]
    assert error.code == "dead_point"
    assert float(str(error).split("t = ")[1].split(" s:")[0]) == pytest.approx(longest(), abs=1e-6)
    assert "the run ended with: " in error.__notes__[-1]
    assert error.result is not None
    assert error.state is not None
    assert error.state.t == pytest.approx(longest(), abs=0.11)


@pytest.mark.parametrize("free", [False, True])
def test_a_run_that_diverges_while_its_drivers_are_in_reach_says_that(free: bool) -> None:
    """By a load that grows with the speed; a boom that stands still would have the same constraints."""
    model = excavator(speed=0.02, free=free)
    body = model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 5, 0), velocity=(1, 0, 0))
    model.user_force(lambda t, q, v: [*(1e3 * abs(v[:3]) * v[:3]), 0, 0, 0], body)
    if free:  # it takes the cart with it
        model.spring_damper("cart", body, at=((0, 1, -1), (0, 5, 0)), stiffness=1e3)
    with pytest.raises(lw.NotFiniteError) as found:
        lw.simulate(model, 2.0, 1e-2, progress=False)
    assert "drivers" not in str(found.value)
    assert found.value.code != "dead_point"


def test_a_look_that_fails_leaves_the_error_of_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise RuntimeError

    monkeypatch.setattr(reach, "_impasse", fail)
    with pytest.raises(lw.NotFiniteError, match="the run diverged"):
        lw.simulate(excavator(), 5.0, 1e-2, progress=False)


def test_a_look_beyond_its_time_leaves_the_error_of_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reach, "SECONDS", 0.0)
    with pytest.raises(lw.NotFiniteError, match="the run diverged"):
        lw.simulate(excavator(), 5.0, 1e-2, progress=False)
