"""What analyses are asked for: handles wherever a joint is wanted, and words for what there is not."""

from __future__ import annotations

from collections.abc import Callable

import linkwork as lw
import numpy as np
import pytest

G = 9.81


def hanging() -> tuple[lw.Model, lw.modeling.handles.Joint]:
    model = lw.Model()
    bob = model.body("bob", mass=2.0, inertia=(0.1,) * 3, position=(0, 0, -1))
    return model, model.revolute("ground", bob, at=(0, 0, 0), axis=(0, 1, 0), name="pin")


def test_reactions_at_rest_are_asked_for_by_name_index_or_handle() -> None:
    model, pin = hanging()
    rest = lw.equilibrium(model)
    for named in ("pin", 0, pin):
        assert rest.reaction(named).force == pytest.approx((0, 0, 2 * G))
    with pytest.raises(lw.ModelError, match="no joint named 'pinn'; the nearest is 'pin'"):
        rest.reaction("pinn")
    with pytest.raises(lw.ModelError, match="no joint 1: there are 1"):
        rest.reaction(1)


def test_drivers_are_named_by_their_handles() -> None:
    """Of a pendulum held level: m g l."""
    model, _ = hanging()
    arm = model.body("arm", mass=1.0, inertia=(0.1,) * 3, position=(1, 0, 0))
    model.revolute("ground", arm, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.drive("pin", position=0.0)
    motor = model.drive("hinge", position=0.0)
    needed = lw.inverse_dynamics(model, [0.0, 0.1], drivers=[motor])
    assert list(needed.drives) == [motor.name]
    assert np.abs(needed.effort(motor)) == pytest.approx(G)


@pytest.mark.parametrize(("ask", "message"), [
    (lambda found: found.describe(1), "mode 1: there are 1, from 0 on"),
    (lambda found: found.describe(None), "mode None"),
    (lambda found: found.displaced(-2, 0.1), "mode -2"),
    (lambda found: found.displaced(0, None), "amplitude None is not a finite number"),
    (lambda found: found.displaced(0, 1.0, np.nan), "phase nan is not a finite number"),
])  # fmt: skip
def test_modes_that_there_are_not_are_refused(
    ask: Callable[[lw.Linearization], object], message: str
) -> None:
    found = lw.linearize(hanging()[0])
    assert found.describe(-1) == found.describe(0)
    with pytest.raises(lw.OptionError, match=message):
        ask(found)


def test_sensitivity_says_what_it_wants() -> None:
    def build(mass: float) -> lw.Model:
        return hanging()[0]

    arguments = (build, {"mass": 1.0}, {"x": lambda result: 1.0})
    with pytest.raises(lw.OptionError, match="run is 1, not a function"):
        lw.sensitivity(*arguments, run=1)  # type: ignore[arg-type]
    with pytest.raises(lw.OptionError, match="t_end is missing"):
        lw.sensitivity(*arguments, step=0.01)
    found = lw.sensitivity(*arguments, t_end=0.1, step=0.01)
    with pytest.raises(lw.ModelError, match=r"no output or parameter named \['x'\]"):
        found.relative(["x"], "mass")  # type: ignore[arg-type]
