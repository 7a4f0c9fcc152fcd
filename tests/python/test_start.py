"""A run that begins in the middle: at the state of another run, or of an error."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from linkwork import mechanisms
from linkwork.running.progress import ProgressInfo
from random_mechanisms import Mechanism, examples
from random_mechanisms import mechanisms as mechanisms_of


def halfway(model: lw.Model) -> lw.Snapshot:
    return lw.simulate(model, 1.0, 1e-3, progress=False).snapshot()


@pytest.mark.parametrize("choice", [{"step": 1e-3}, {"rtol": 1e-8}])
def test_progress_counts_from_the_start_of_the_run(
    choice: dict[str, float],
) -> None:
    told: list[ProgressInfo] = []
    model = mechanisms.pendulum()
    lw.simulate(model, 1.5, start=halfway(model), progress=told.append, **choice)
    assert told[-1].t_start == 1.0 and told[-1].fraction == 1.0
    middle = ProgressInfo(t=1.25, t_end=1.5, steps_done=1, steps_total=0, elapsed=3.0, t_start=1.0)
    assert (middle.fraction, middle.remaining) == (0.5, 3.0)


def test_about_a_thousand_frames_are_recorded_of_the_rest() -> None:
    model = mechanisms.pendulum()
    rest = lw.simulate(model, 1.5, 1e-4, start=halfway(model), progress=False)
    assert 500 <= len(rest) <= 1002


def test_summary_and_manifest_say_where_the_run_began() -> None:
    model = mechanisms.pendulum()
    rest = lw.simulate(model, 1.5, 1e-2, start=halfway(model), progress=False)
    assert "1 to 1.5 s" in rest.summary()
    assert rest.manifest["options"]["t_start"] == 1.0


def test_state_of_the_model_does_not_matter_to_a_run_that_starts_elsewhere() -> None:
    """The pin of this pendulum is 0.5 m off at t = 0, where the run does not begin."""
    model = mechanisms.pendulum()
    state = halfway(model)
    q, v = model.compiled().q0.copy(), model.compiled().v0
    q[0] += 0.5
    shifted = model.with_initial_state(q, v)
    with pytest.raises(lw.ModelError):
        lw.simulate(shifted, 1.5, 1e-2, progress=False)
    found, expected = (lw.simulate(it, 1.5, 1e-2, start=state, progress=False) for it in (shifted, model))
    assert np.array_equal(found.q, expected.q)


def test_start_that_violates_a_joint_is_a_warning_that_names_it() -> None:
    model = mechanisms.pendulum()
    state = halfway(model)
    off = state._replace(q=state.q + np.array([0.5, 0, 0, 0, 0, 0, 0]))
    with pytest.warns(lw.LinkworkWarning, match=r"start: .* 1 joint .*: rod 0\.4"):
        lw.simulate(model, 1.01, 1e-2, start=off, progress=False, on_inaccurate="pass")


def test_driver_is_met_at_the_time_of_the_start_not_at_zero() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 2.0))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="axle")
    model.drive("axle", position=lw.functions.polynomial(0.0, 2.0, 0.5))
    state = halfway(model)
    rest = lw.simulate(model, 2.0, 1e-3, start=state, progress=False)
    assert rest.coordinate("axle").rate[-1] == pytest.approx(4.0, abs=1e-9)


@pytest.mark.parametrize("broken", [np.nan, np.inf])
def test_start_that_is_not_finite_is_refused(broken: float) -> None:
    model = mechanisms.pendulum()
    state = halfway(model)
    with pytest.raises(lw.OptionError, match="start: .*no finite state"):
        lw.simulate(model, 2.0, 1e-2, start=state._replace(v=np.full((1, 6), broken)), progress=False)


def wound(stiffness: float = 0.01) -> lw.Model:
    """A wheel that winds a spring up, beside a floor."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 1), omega=(0, 0, 20.0))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1))
    axis = (0, 0, 1)
    model.rotational_spring_damper("ground", "wheel", axis=axis, stiffness=stiffness, name="mainspring")
    at = ((0, 0, 0), (0, 0, 1))
    model.sphere_plane_contact("ground", "wheel", at=at, normal=axis, radius=0.5, stiffness=1e3, name="floor")
    return model


def test_what_force_elements_remember_and_no_state_holds_is_a_warning_that_names_them() -> None:
    model = wound()
    state = halfway(model)._replace(history=())
    with pytest.warns(lw.LinkworkWarning) as caught:
        lw.simulate(model, 1.01, 1e-2, start=state, progress=False)
    said = " ".join(str(warning.message) for warning in caught)
    assert "mainspring: full turns" in said and "floor: the speed at which a contact began" in said


@pytest.mark.parametrize("kept", ["frames", "file"])
def test_a_spring_that_is_wound_up_by_turns_stays_so(kept: str, tmp_path: Path) -> None:
    model = wound(stiffness=1.0)
    first = lw.simulate(model, 1.0, 1e-3, progress=False)
    assert first.energy[-1] == pytest.approx(200.0, abs=1e-6)
    if kept == "file":
        first.save(tmp_path / "first.h5")
        first = lw.Result.load(tmp_path / "first.h5")
    rest = lw.simulate(model, 2.0, 1e-3, start=first.snapshot(), progress=False)
    whole = lw.simulate(model, 2.0, 1e-3, progress=False)
    assert rest.energy[0] == pytest.approx(200.0, abs=1e-6)
    assert np.abs(rest.v[-1] - whole.v[-1]).max() < 1e-9


def test_a_contact_that_is_under_way_goes_on() -> None:
    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 1.5))
    at = ((0, 0, 0), (0, 0, 1.5))
    model.sphere_plane_contact(
        "ground", "ball", at=at, normal=(0, 0, 1), radius=0.5, stiffness=1e4, hysteresis=1.0
    )
    touched = np.sqrt(2 * 1.0 / 9.81) + 0.01  # it falls 1 m, and is pressed for a while
    steps = {"step": touched / 1000}
    first = lw.simulate(model, touched, progress=False, **steps)
    assert first.q[-1, 0, 2] < 0.5
    rest = lw.simulate(model, 2 * touched, start=first.snapshot(), progress=False, **steps)
    whole = lw.simulate(model, 2 * touched, progress=False, **steps)
    assert np.abs(rest.q[-1] - whole.q[-1]).max() < 1e-9


def test_a_system_begins_a_new_motion_without_what_another_left() -> None:
    system = lw.System(wound(stiffness=1.0))
    y = system.initial_state()
    fresh, history = system.derivative(0.0, y), system.initial_history
    for angle in np.linspace(0.0, 2 * np.pi, 7):  # a turn
        turned = y.copy()
        turned[3:7] = [np.cos(angle / 2), 0, 0, np.sin(angle / 2)]
        history = system.advance_history(0.0, turned, history)
    assert system.derivative(0.0, y, history)[-1] - fresh[-1] == pytest.approx(-2 * np.pi)
    assert np.array_equal(system.derivative(0.0, y), fresh)


@examples(15)
@given(mechanism=mechanisms_of(most=6, forces=("spring_damper", "applied", "drag", "bushing")))
def test_random_mechanism_in_two_parts_moves_as_in_one(mechanism: Mechanism) -> None:
    model = mechanism.model
    whole, first = (lw.simulate(model, t_end, 1e-4, progress=False) for t_end in (0.02, 0.01))
    rest = lw.simulate(model, 0.02, 1e-4, start=first.snapshot(), progress=False)
    size = 1 + np.abs(whole.v).max()
    assert np.abs(rest.q[-1] - whole.q[-1]).max() <= 1e-10 * size
    assert np.abs(rest.v[-1] - whole.v[-1]).max() <= 1e-8 * size


def test_history_of_another_model_is_refused() -> None:
    model = wound()
    state = lw.simulate(model, 0.1, 1e-2, progress=False).snapshot()
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), stiffness=0.1)
    with pytest.raises(lw.OptionError, match=r"says nothing of the history variable of .* 2' .*_replace\("):
        lw.simulate(model, 0.2, 1e-2, start=state, progress=False)


@pytest.mark.parametrize(
    "call", [lw.simulate, lw.System, lw.assemble, lw.compare, lw.equilibrium, lw.linearize]
)
@pytest.mark.parametrize("what, text", [(3, "3"), (mechanisms.pendulum, "the function pendulum: call it")])
def test_what_is_no_model_is_named(call: Any, what: object, text: str) -> None:
    numbers = {"t_end": 1.0} if call in (lw.simulate, lw.compare) else {}
    with pytest.raises(lw.ModelError, match=f"a linkwork.Model is wanted, not {text}"):
        call(what, **numbers)
