"""What force elements do, against their laws, the power balance and the equations of motion."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest


def swinging() -> lw.Model:
    """A rod on a hinge with a torsion spring, a spring to the ground, drag and a turning force."""
    model = lw.Model(gravity=(0, 0, -9.81), name="swing")
    rod = model.body("rod", mass=2.0, inertia=(0.01, 0.2, 0.2), position=(0.5, 0, 0))
    bob = model.body("bob", mass=1.0, inertia=(0.02, 0.03, 0.04), position=(1.0, 0, -0.4))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.spherical(rod, bob, at=(1, 0, 0), name="ball")
    model.rotational_spring_damper(
        "ground",
        rod,
        at=(0, 0, 0),
        axis=(0, 1, 0),
        stiffness=5.0,
        damping=0.3,
        free_angle=0.2,
        name="torsion",
    )
    model.spring_damper(
        bob,
        "ground",
        at=((1, 0, -0.5), (0.4, 0.3, 1)),
        stiffness=40.0,
        damping=2.0,
        free_length=0.7,
        name="coil",
    )
    model.spring_damper(
        "ground", bob, at=((0, 1, 0), (1, 0, -0.4)), stiffness=9.0, free_length=0.1, name="rope"
    )
    model.force(rod, force=(0, 0, lw.functions.harmonic(3.0, 4.0, 0.0, 0.0)), at=(0.7, 0, 0), name="push")
    return model


@pytest.fixture(scope="module")
def result() -> lw.Result:
    return lw.simulate(swinging(), t_end=1.0, step=1e-3)


def test_springs_pull_by_their_deflection_and_its_rate(result: lw.Result) -> None:
    """f = k x + c x_dot along the line between the points; positive in tension."""
    for name, stiffness, damping in (("coil", 40.0, 2.0), ("rope", 9.0, 0.0)):
        found = result.force(name)
        x = found.deflection
        assert x is not None
        assert np.abs(found.potential - stiffness * x**2 / 2).max() < 1e-10
        pull = np.linalg.norm(found.force, axis=1)
        law = np.abs(stiffness * x + damping * np.gradient(x, result.t, edge_order=2))
        assert np.abs(pull - law)[2:-2].max() < 1e-3 * pull.max()
        assert np.abs(found.torque).max() < 1e-12 * pull.max()
    twist = result.force("torsion")
    assert twist.deflection is not None
    angle = result.coordinate("hinge")
    assert np.abs(twist.deflection - (angle.value - 0.2)).max() < 1e-12
    law = -5.0 * twist.deflection - 0.3 * angle.rate
    assert np.abs(twist.torque[:, 1] - law).max() < 1e-10
    assert np.abs(twist.force).max() == 0.0


def test_powers_of_elements_sum_up_to_the_change_of_energy(result: lw.Result) -> None:
    """Their power and that of gravity is the rate of the kinetic energy; joints do no work."""
    weights = 9.81 * np.array([2.0, 1.0])
    power = sum(result.force(k).power for k in range(4)) - result.velocity[:, :, 2] @ weights
    change = np.gradient(result.kinetic_energy, result.t, edge_order=2)
    assert np.abs(power - change)[3:-3].max() < 5e-4 * np.abs(power).max()


def test_forces_and_reactions_move_a_body(result: lw.Result) -> None:
    """m a = the sum of what acts on the bob; the coil acts on it as the first of its two bodies."""
    acting = result.reaction("ball").force + result.force("rope").force - result.force("coil").force
    acting = acting + np.array([0, 0, -9.81])
    assert np.abs(acting - result.body("bob").acceleration).max() < 1e-9 * np.abs(acting).max()


def test_a_force_on_one_body_is_as_it_was_given(result: lw.Result) -> None:
    found = result.force("push")
    assert np.abs(found.force - np.outer(3.0 * np.sin(4.0 * result.t), (0, 0, 1))).max() < 1e-12
    assert np.abs(found.torque).max() < 1e-12
    assert found.deflection is None


def test_a_result_of_a_file_takes_its_laws_from_the_model(result: lw.Result, tmp_path: Path) -> None:
    result.save(tmp_path / "run.h5")
    loaded = lw.Result.load(tmp_path / "run.h5")
    with pytest.raises(lw.OptionError, match="has no laws of forces: give the model"):
        loaded.force("coil")
    assert np.array_equal(loaded.force("coil", swinging()).force, result.force("coil").force)
    with pytest.raises(lw.OptionError, match="has other force elements or bodies"):
        loaded.force("coil", lw.mechanisms.pendulum())


def test_a_result_of_a_file_refuses_the_laws_of_a_model_with_other_numbers(
    result: lw.Result, tmp_path: Path
) -> None:
    """Also where it is only a mass; a result that does not say of which model it is takes any of its kind."""
    result.save(tmp_path / "run.h5")
    loaded = lw.Result.load(tmp_path / "run.h5")
    other = swinging().replaced(result.body_names[0], mass=7.0)
    for found in (loaded, result):
        with pytest.raises(lw.OptionError, match="is another model than that of this result"):
            found.force("coil", other)
    del loaded.header.manifest["model_hash"]
    assert np.array_equal(loaded.force("coil", other).force, result.force("coil").force)
    with pytest.raises(lw.ModelError, match="no force element named 'koil'"):
        result.force("koil")


def sliding(**law: float) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("slider", mass=2.0, inertia=(0.1,) * 3, position=(0, 0, 0), velocity=(0, 0, 3.0))
    model.translational("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="rail")
    model.translational_spring_damper("ground", body, at=(0, 0, 0), axis=(0, 0, 1), **law, name="spring")
    return model


def test_a_spring_along_an_axis_swings_to_both_sides_however_far() -> None:
    model = sliding(stiffness=8.0, damping=0.4, free_displacement=-20.0, force=4.0)
    result = lw.simulate(model, t_end=4.0, rtol=1e-10)
    decay, rest = 0.1, -19.5
    omega = np.sqrt(4.0 - decay**2)
    phase = np.exp(-decay * result.t) * np.array([np.cos(omega * result.t), np.sin(omega * result.t)])
    x = rest + np.array([-rest, (3.0 - decay * rest) / omega]) @ phase
    found = result.force("spring")
    assert result.coordinate("rail").value == pytest.approx(x, abs=1e-8)
    assert found.deflection == pytest.approx(x + 20.0, abs=1e-8)
    assert found.potential == pytest.approx(4.0 * (x + 20.0) ** 2, abs=1e-6)
    assert abs(result.energy_error).max() < 1e-6


def test_a_twist_keeps_its_full_turns_from_run_to_run_and_between_frames() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("wheel", mass=1.0, inertia=(0.1,) * 3, omega=(0, 0, 20))
    model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.rotational_spring_damper(
        "ground", body, axis=(0, 0, 1), stiffness=0.5, free_angle=0.3, name="spring"
    )
    whole = lw.simulate(model, t_end=1.0, rtol=1e-8, times=[0.0, 0.5, 1.0]).force("spring")
    half = lw.simulate(model, t_end=0.5, rtol=1e-8)
    onward = lw.simulate(model, t_end=1.0, rtol=1e-8, start=half.snapshot()).force("spring")
    for found in (whole, onward):
        assert found.deflection is not None
        assert abs(found.deflection) == pytest.approx(np.sqrt(2 * found.potential / 0.5), abs=1e-9)
    assert whole.deflection is not None
    assert onward.deflection is not None
    assert whole.deflection[-1] == pytest.approx(onward.deflection[-1], rel=1e-6)
    assert whole.deflection[-1] > 2 * np.pi


STEP = lw.functions.piecewise_polynomial([0.0, 0.5, 2.0], [[1.0], [3.0]])
AFTER = lw.functions.with_breaks(lambda t: 3.0 if t > 0.5 else 1.0, [0.5])
FROM = lw.functions.with_breaks(lambda t: 3.0 if t >= 0.5 else 1.0, [0.5])


@pytest.mark.parametrize("how", [{"record_every": 1}, {"times": [0.0, 0.25, 0.5]}, {"start": 0.5}])
@pytest.mark.parametrize("t_end", [0.5, 1.0])
@pytest.mark.parametrize("law", [STEP, AFTER, FROM])
def test_the_force_at_a_break_is_that_which_the_frame_has(
    law: Any, t_end: float, how: dict[str, Any], tmp_path: Path
) -> None:
    """Just after it, as what goes on, and at the end of the run just before."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("body", mass=2.0, inertia=(0.1, 0.1, 0.1))
    model.force("body", force=(law, 0, 0), name="push")
    begun = how.get("start")
    if begun is not None:
        how = {"start": lw.simulate(model, 0.5, rtol=1e-6).snapshot()}
        t_end += 0.5
    result = lw.simulate(model, t_end, rtol=1e-6, **how)
    at_break = np.flatnonzero(result.t == 0.5)
    assert len(at_break) == 1
    assert result.force("push").force[at_break[0], 0] == (1.0 if t_end == 0.5 else 3.0)
    result.save(tmp_path / "run.h5")
    for found in (result.force("push"), lw.Result.load(tmp_path / "run.h5").force("push", model)):
        np.testing.assert_allclose(found.force[:, 0], 2.0 * result.acceleration[:, 0, 0], rtol=1e-12)


def test_breaks_side_by_side_are_one() -> None:
    """With forces that jump a unit in the last place apart, and one given to the run alone."""
    later = np.nextafter(0.5, 1.0)
    model = lw.Model(gravity=(0, 0, 0))
    model.body("body", mass=2.0, inertia=(0.1, 0.1, 0.1))
    model.force("body", force=(AFTER, 0, 0), name="one")
    model.force(
        "body", force=(lw.functions.with_breaks(lambda t: float(t >= later), [later]), 0, 0), name="two"
    )
    model.force("body", force=(lambda t: float(t > 0.75), 0, 0), name="three")
    result = lw.simulate(model, 1.0, rtol=1e-6, breaks=[0.75], record_every=1)
    forces = [result.force(name).force[:, 0] for name in ("one", "two", "three")]
    np.testing.assert_allclose(sum(forces), 2.0 * result.acceleration[:, 0, 0], rtol=1e-12)
    assert {0.5, 0.75} <= set(result.t)


BREAKS = [0.0, 0.5, 1.0, 2.0]


@pytest.mark.parametrize("end", [0.5, 1.0, 1.0 + 2e-16])
@pytest.mark.parametrize("jumping", [True, False])
def test_the_force_at_a_break_is_that_of_a_driven_motion(jumping: bool, end: float) -> None:
    """m a = driver + force in all frames; in the last one of both before the break, as in a run."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=2.0, inertia=(0.1, 0.2, 0.3))
    model.translational("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    law = lw.functions.piecewise_polynomial(BREAKS, [[1.0], [3.0], [-2.0]])
    model.drive("rail", acceleration=law if jumping else lw.functions.polynomial(1.0, 2.0), name="drive")
    forces = [-4.0, 9.0, 5.0]
    model.force(
        "b", force=(lw.functions.piecewise_polynomial(BREAKS, [[it] for it in forces]), 0, 0), name="push"
    )
    needed = lw.inverse_dynamics(model, np.append(np.linspace(0, 0.95 * round(end, 1), 20), end))
    motion = needed.motion
    push = motion.force("push")
    effort, acceleration = needed.effort("drive"), motion.acceleration[:, 0, 0]
    np.testing.assert_allclose(effort + push.force[:, 0], 2 * acceleration, rtol=1e-9, atol=1e-9)
    assert push.force[-1, 0] == forces[0 if end == 0.5 else 1]
    np.testing.assert_allclose(needed.drives["drive"].power, effort * motion.velocity[:, 0, 0], atol=1e-9)
    if motion.t[-1] == round(end, 1):
        run = lw.simulate(model, end, rtol=1e-9)
        assert run.reaction("drive").force[-1, 0] == pytest.approx(effort[-1], abs=1e-6)


def test_laws_of_the_users_own_are_named_as_such(tmp_path: Path) -> None:
    """They are found by what a result has."""
    model = swinging()
    model.joint_force("hinge", lambda t, angle, rate: -2.0 * angle - 0.3 * rate + np.sin(5 * t), name="law")
    model.user_force(lambda t, q, v: [0, 0, -v[2], 0, 0, 0], "bob", name="drag of my own")
    result = lw.simulate(model, 0.1, step=1e-3)
    result.save(tmp_path / "run.h5")
    for name in ("law", "drag of my own"):
        for found, given in ((result, None), (lw.Result.load(tmp_path / "run.h5"), model)):
            with pytest.raises(
                lw.ModelError, match=f"'{name}' is no force element but a law of the user's own"
            ):
                found.force(name, given)
    with pytest.raises(lw.ModelError, match="no force element named 'low'"):
        result.force("low")


def pushed(held: list[float]) -> tuple[lw.Model, lw.Event]:
    """A free body of 2 kg that is pushed by what is held, and an event that turns that over at 0.5 s."""
    model = lw.Model(gravity=(0, 0, 0), name="pushed")
    model.body("b", mass=2.0, inertia=(0.1, 0.1, 0.1))
    model.force("b", force=(lambda t: held[0], 0, 0), name="push")
    model.force("b", force=(0, lambda t: 2 * t, 0), name="other")

    def turn_over(t: float, state: lw.State) -> None:
        held[0] = -3.0

    return model, lw.Event(lambda t, state: t - 0.5, "switch", change=turn_over)


UNLIKE = "force of 'push': its law is not everywhere what it was in the run"


def test_a_force_that_an_event_has_changed_is_told(tmp_path: Path) -> None:
    """M v_dot is 1 N before and -3 N after; whatever is held later, it is not both."""
    held = [1.0]
    model, switch = pushed(held)
    runs = []
    for output in (None, tmp_path / "pushed.h5"):
        held[0] = 1.0
        runs.append(lw.simulate(model, t_end=1.0, rtol=1e-8, events=switch, output=output))
    for now in (-3.0, 1.0):
        held[0] = now
        with pytest.warns(lw.LinkworkWarning, match=UNLIKE):
            found = runs[0].force("push").force
        assert np.abs(found - 2 * runs[0].acceleration[:, 0])[:, 0].max() == 4.0
    with pytest.warns(lw.LinkworkWarning, match=UNLIKE):  # of the model as it began
        lw.Result.load(tmp_path / "pushed.h5").force("push", model)
    other = runs[0].force("other").force[:, 1]
    assert np.abs(other - 2 * runs[0].t).max() < 1e-15


def test_a_force_that_is_changed_after_the_run_is_told() -> None:
    held = [1.0]
    model, _ = pushed(held)
    driven, _ = pushed(held)
    driven.translational("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    driven.drive("rail", position=lw.functions.cycloidal(0.3, 1.0))
    results = [
        lw.simulate(model, t_end=1.0, step=0.01),
        lw.simulate_many(model, {"b.mass": [2.0]}, 1.0, step=0.01).member(0),
        lw.kinematics(driven, np.linspace(0, 1, 11)),
    ]
    for result in results:
        assert (result.force("push").force[:, 0] == 1.0).all()
    held[0] = 5.0
    for result in results:
        with pytest.warns(lw.LinkworkWarning, match=UNLIKE):
            result.force("push")
    held[0] = 1.0
    for result in results:
        assert (result.force("push").force[:, 0] == 1.0).all()


def test_a_force_that_begins_at_an_event_is_what_it_was() -> None:
    """Steps that the event cut were taken by the law before it; no frame has them."""
    began = [np.inf]
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=2.0, inertia=(0.1, 0.1, 0.1), velocity=(1, 0, 0))
    model.force("b", force=(lambda t: 3 * (t - began[0]) if t > began[0] else 0.0, 0, 0), name="ramp")

    def trigger(t: float, state: lw.State) -> None:
        began[0] = t

    passing = lw.Event(lambda t, state: state.body("b").position[0] - 0.4567, "passes", change=trigger)
    result = lw.simulate(model, t_end=1.0, rtol=1e-8, events=passing, on_inaccurate="pass")
    assert result.events[0].t == pytest.approx(0.4567)
    assert np.abs(result.force("ramp").force - 2 * result.acceleration[:, 0]).max() < 1e-12


def test_cases_remark_forces_that_are_not_those_of_the_run() -> None:
    held = [1.0]
    model, switch = pushed(held)
    asked, cases = ["force('push').force.x.max"], {"b.mass": [2.0, 3.0]}
    study = lw.sweep(model, cases, asked, t_end=1.0, rtol=1e-8, events=switch, processes=1)
    many = lw.simulate_many(model, cases, 1.0, rtol=1e-8, events=switch, outputs=asked)
    for found in (study, many):
        assert found.remarks.keys() == {0, 1}
        assert all(text.startswith(UNLIKE) for text in found.remarks.values())
    assert not lw.sweep(model, cases, asked, t_end=1.0, step=0.01, processes=1).remarks
