"""A run that goes on where another one ended takes the steps of one that never ended, bit for bit."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import mechanisms
from random_mechanisms import Mechanism, examples
from random_mechanisms import mechanisms as mechanisms_of
from recorded import PAIRS, bits_after


def run(model: lw.Model, t_end: float, **choices: Any) -> lw.Result:
    return lw.simulate(model, t_end, progress=False, on_inaccurate="pass", **choices)


def assert_goes_on(model: lw.Model, first_end: float, t_end: float, **choices: Any) -> lw.Result:
    """A run to `first_end` and from there to `t_end` has the frames of one to `t_end`; the rest of it."""
    first = dict(choices)
    if "times" in choices:
        first["times"] = np.linspace(0.0, first_end, 5)
    whole = run(model, t_end, **choices)
    rest = run(model, t_end, start=run(model, first_end, **first).snapshot(), **choices)
    assert rest.manifest["resumed"] is True
    assert len(bits_after(whole, first_end)["t"]) > 0
    assert bits_after(rest, first_end) == bits_after(whole, first_end)
    return rest


@pytest.mark.parametrize("formulation", ["standard", "penalty", "augmented_lagrangian"])
@pytest.mark.parametrize("integrator", list(lw.integrators.METHODS))
def test_every_integrator_goes_on_in_the_middle_of_a_step_that_the_end_had_shortened(
    integrator: str, formulation: str
) -> None:
    assert_goes_on(mechanisms.four_bar(), 0.333, 0.5, step=1e-2, integrator=integrator,
                   formulation=formulation, record_every=3)  # fmt: skip


@pytest.mark.parametrize("steps", [{"step": 5e-4, "record_every": 1}, {"rtol": 1e-5, "record_every": 1}])
@pytest.mark.parametrize("first_end", [0.02, 0.0215, 0.0422])
def test_runs_that_let_drift_be_go_on_where_other_equations_become_redundant(
    first_end: float, steps: dict[str, Any]
) -> None:
    rest = assert_goes_on(mechanisms.planetary_gear(2), first_end, 0.08, stabilization="none", **steps)
    assert rest.statistics["row_changes"] > 0


@pytest.mark.parametrize("integrator", ["rk4", "ab4", "dopri5"])
@pytest.mark.parametrize("seconds", [0.15, 0.2, 0.3])
def test_an_interrupted_run_goes_on_from_its_last_frame(
    integrator: str, seconds: float, tmp_path: Path
) -> None:
    """The key is pressed while steps are taken; what they had recorded by then is not lost."""
    how: dict[str, Any] = {"step": 1e-3, "integrator": integrator, "record_every": 7}
    model, output = mechanisms.spatial_slider_crank(), tmp_path / "run.h5"

    def press() -> None:
        while not output.exists():
            time.sleep(0.01)
        time.sleep(seconds)
        os.kill(os.getpid(), signal.SIGINT)

    key = threading.Thread(target=press)
    key.start()
    with pytest.raises(KeyboardInterrupt):
        run(model, 1e4, output=output, **how)
    key.join()
    last = lw.Result.load(output).snapshot()
    assert last.resume is not None
    t_end = last.t + 0.1
    rest = bits_after(run(model, t_end, start=last, **how), last.t)
    assert rest == bits_after(run(model, t_end, **how), last.t)


@pytest.mark.parametrize("integrator", PAIRS)
@pytest.mark.parametrize("frames", [{"record_every": 1}, {"times": [0.4, 0.41, 0.5]}])
def test_steps_that_follow_tolerances_go_on_with_their_control(integrator: str, frames: Any) -> None:
    assert_goes_on(mechanisms.four_bar(), 0.39, 0.5, rtol=1e-6, integrator=integrator, **frames)


@pytest.mark.parametrize("stabilization", ["none", "baumgarte", "projection", "position_projection"])
def test_every_stabilization_goes_on(stabilization: str) -> None:
    for choice in ({"step": 1e-2, "integrator": "rk4"}, {"rtol": 1e-5, "record_every": 1}):
        assert_goes_on(mechanisms.bricard(), 0.1, 0.3, stabilization=stabilization, **choice)


@pytest.mark.parametrize("end", [0.705, *np.linspace(0.55, 1.15, 13)])  # 3 ms before a pose
@pytest.mark.parametrize("choice", [{"step": 5e-3, "integrator": "ab4"}, {"rtol": 1e-6, "record_every": 1}])
def test_a_run_goes_on_before_in_and_after_a_leap_over_a_singular_pose(end: float, choice: Any) -> None:
    rest = assert_goes_on(mechanisms.four_bar(), end, 1.2, **choice)
    whole = run(mechanisms.four_bar(), 1.2, **choice)
    assert [it.t for it in rest.singular_poses] == [it.t for it in whole.singular_poses if it.t > end]


def bouncing() -> tuple[lw.Model, lw.Event]:
    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 1.0))

    def bounce(t: float, state: Any) -> None:
        state.body("ball").velocity[2] *= -0.9

    return model, lw.Event(lambda t, state: state.body("ball").position[2], "floor", -1, change=bounce)


@pytest.mark.parametrize("end", [0.2, 0.4516, 0.9, 1.6])
def test_events_that_came_do_not_come_again_and_those_to_come_come_as_they_would(end: float) -> None:
    model, event = bouncing()
    choices: dict[str, Any] = {"rtol": 1e-7, "record_every": 1, "events": event}
    rest = assert_goes_on(model, end, 2.0, **choices)
    whole = run(model, 2.0, **choices)
    assert [it.t for it in rest.events] == [it.t for it in whole.events if it.t > end]


def test_contacts_springs_with_turns_and_tables_go_on() -> None:
    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 1.5), omega=(0, 0, 20.0))
    at = ((0, 0, 0), (0, 0, 1.5))
    model.sphere_plane_contact("ground", "ball", at=at, normal=(0, 0, 1), radius=0.5, stiffness=1e4,
                               hysteresis=0.5, name="floor")  # fmt: skip
    push = lw.functions.with_breaks(lw.functions.harmonic(1.0, 20.0), [0.21, 0.52])
    model.force("ball", force=(push, 0, 0), name="push")
    for end in (0.15, 0.46, 0.47, 0.6):
        assert_goes_on(model, end, 0.8, rtol=1e-6, record_every=1)
        assert_goes_on(model, end, 0.8, step=1e-3, integrator="abm4")


def test_a_run_goes_on_twice() -> None:
    model, choices = mechanisms.bricard(), {"rtol": 1e-6, "record_every": 1, "integrator": "dop853"}
    state = run(model, 0.07, **choices).snapshot()
    state = run(model, 0.11, start=state, **choices).snapshot()
    rest, whole = run(model, 0.2, start=state, **choices), run(model, 0.2, **choices)
    assert rest.manifest["resumed"] and bits_after(rest, 0.11) == bits_after(whole, 0.11)


def test_a_model_whose_initial_state_was_corrected_goes_on() -> None:
    model = mechanisms.bricard()
    q = model.compiled().q0.copy()
    q[0] += 1e-5
    model = model.with_initial_state(q, model.compiled().v0)
    with pytest.warns(lw.LinkworkWarning, match="corrected"):
        assert_goes_on(model, 0.1, 0.2, step=1e-2, integrator="ab3")


def test_an_integrator_of_the_users_own_goes_on() -> None:
    def heun(system: lw.System, t: float, y: Any, h: float) -> Any:
        k = system.derivative(t, y)
        return y + h / 2 * (k + system.derivative(t + h, y + h * k))

    assert_goes_on(mechanisms.four_bar(), 0.05, 0.1, step=1e-3, integrator=heun)


def test_a_result_file_goes_on(tmp_path: Path) -> None:
    model, choices = mechanisms.four_bar(), {"step": 1e-2, "integrator": "abm4"}
    run(model, 0.3, output=tmp_path / "first.h5", **choices)
    run(model, 0.3, **choices).save(tmp_path / "saved.h5")
    whole = run(model, 0.5, **choices)
    for name in ("first.h5", "saved.h5"):
        rest = run(model, 0.5, start=lw.Result.load(tmp_path / name).snapshot(), **choices)
        assert rest.manifest["resumed"] and bits_after(rest, 0.3) == bits_after(whole, 0.3)
    assert sorted(it.name for it in tmp_path.iterdir()) == ["first.h5", "saved.h5"]


KILLED = """
    import os, signal, sys, time
    import linkwork as lw
    from linkwork import mechanisms
    from linkwork.results import writing
    writing.FLUSH_SECONDS = writing.CHECKPOINT_SECONDS = 0.01
    def end(info):
        if info.t > 0.3:
            os.kill(os.getpid(), signal.SIGKILL)
    lw.simulate(mechanisms.four_bar(), 50.0, 1e-4, "ab5", record_every=7, output=sys.argv[1], progress=end)
"""


def test_the_file_of_a_killed_run_goes_on(tmp_path: Path) -> None:
    killed = subprocess.run([sys.executable, "-c", textwrap.dedent(KILLED), tmp_path / "run.h5"])
    assert killed.returncode == -9
    first = lw.Result.load(tmp_path / "run.h5")
    model, choices = mechanisms.four_bar(), {"step": 1e-4, "integrator": "ab5", "record_every": 7}
    end, t_end = float(first.t[-1]), float(first.t[-1]) + 0.05
    rest = run(model, t_end, start=first.snapshot(), **choices)
    assert not first.finished and rest.manifest["resumed"]
    assert bits_after(rest, end) == bits_after(run(model, t_end, **choices), end)


def test_the_state_of_an_error_goes_on() -> None:
    model = mechanisms.pendulum()
    healed = threading.Event()  # whose state does not count among what makes a function another one

    def fragile(t: float, state: Any) -> float:
        return np.nan if t > 0.4 and not healed.is_set() else 1.0

    choices: dict[str, Any] = {"rtol": 1e-6, "record_every": 1, "events": lw.Event(fragile, "fragile")}
    with pytest.raises(lw.OptionError, match="not a finite number") as caught:
        run(model, 1.0, **choices)
    healed.set()
    state = caught.value.state
    assert state is not None
    rest, whole = run(model, 1.0, start=state, **choices), run(model, 1.0, **choices)
    assert rest.manifest["resumed"] and bits_after(rest, state.t) == bits_after(whole, state.t)


@pytest.mark.parametrize(
    "change",
    [{"step": 2e-3}, {"integrator": "ab3"}, {"formulation": "penalty"}, {"linear_solver": "dense"}],
)
def test_another_method_begins_anew(change: dict[str, Any]) -> None:
    model, choices = mechanisms.pendulum(), {"step": 1e-3, "integrator": "ab4"}
    state = run(model, 0.1, **choices).snapshot()
    assert run(model, 0.2, start=state, **{**choices, **change}).manifest["resumed"] is False


def level(height: float, drop: float) -> lw.Event:
    """At a height [m] of the bob, where it loses so much of its velocity."""

    def passes(t: float, state: Any) -> float:
        return float(state.body("bob").position[1]) - height

    def slow_down(t: float, state: Any) -> None:
        state.body("bob").velocity *= 1.0 - drop

    return lw.Event(passes, change=slow_down)


@pytest.mark.parametrize("other", [(-0.9, 0.5), (-0.8, 0.6)])
def test_another_event_of_the_same_name_begins_anew(other: tuple[float, float]) -> None:
    """As in code, so in the numbers that it reads: the event is that of the run that goes on."""
    model, choices = mechanisms.pendulum(), {"rtol": 1e-8}
    state = run(model, 0.2, events=level(-0.8, 0.5), **choices).snapshot()
    same = run(model, 1.0, events=level(-0.8, 0.5), start=state, **choices)
    rest = run(model, 1.0, events=level(*other), start=state, **choices)
    assert (same.manifest["resumed"], rest.manifest["resumed"]) == (True, False)
    heights = [float(it.q_before[0, 1]) for it in rest.events]
    assert heights
    np.testing.assert_allclose(heights, other[0], atol=1e-9)


def test_another_integrator_of_the_same_name_begins_anew() -> None:
    def method(theta: float) -> Any:
        def step(system: lw.System, t: float, y: Any, h: float) -> Any:
            k = system.derivative(t, y)
            later = system.derivative(t + theta * h, y + theta * h * k)
            return y + h * ((1 - 0.5 / theta) * k + 0.5 / theta * later)

        return step

    model = mechanisms.pendulum()
    state = run(model, 0.05, step=1e-3, integrator=method(0.5)).snapshot()
    for theta, resumed in ((0.5, True), (1.0, False)):
        rest = run(model, 0.1, step=1e-3, integrator=method(theta), start=state)
        assert rest.manifest["resumed"] is resumed


def test_functions_that_count_their_calls_go_on() -> None:
    """What they write themselves makes no other function of them."""
    calls = 0

    def never(t: float, state: Any) -> float:
        nonlocal calls
        calls += 1
        return 1.0

    rest = assert_goes_on(mechanisms.pendulum(), 0.2, 0.4, rtol=1e-6, events=lw.Event(never), record_every=1)
    assert calls > 0 and rest.events == ()


def test_another_state_or_model_begins_anew_there() -> None:
    model, other = mechanisms.pendulum(), mechanisms.pendulum()
    state = run(model, 0.1, step=1e-3).snapshot()
    faster = state._replace(v=2 * state.v)
    rest = run(model, 0.2, step=1e-3, start=faster)
    assert rest.manifest["resumed"] is False and np.array_equal(rest.v[0], faster.v)
    other.force("bob", force=(1.0, 0, 0))
    assert run(other, 0.2, step=1e-3, start=state).manifest["resumed"] is False


def test_the_energy_balance_of_the_rest_begins_with_it() -> None:
    model = mechanisms.pendulum()
    model.force("bob", force=(1.0, 0, 0))
    rest = assert_goes_on(model, 0.5, 1.0, step=1e-3)
    assert rest.work[0] != 0.0
    assert np.abs(rest.energy_error).max() < 1e-9


@examples(25)
@given(
    mechanism=mechanisms_of(most=5, forces=("spring_damper", "applied", "drag", "bushing")),
    integrator=st.sampled_from(list(lw.integrators.METHODS)),
    formulation=st.sampled_from(["standard", "penalty", "augmented_lagrangian"]),
    adaptive=st.booleans(),
    end=st.floats(0.002, 0.018),
)
def test_random_mechanisms_go_on(
    mechanism: Mechanism, integrator: str, formulation: str, adaptive: bool, end: float
) -> None:
    choices: dict[str, Any] = {"formulation": formulation, "integrator": integrator}
    if adaptive and integrator in PAIRS:
        choices.update(rtol=1e-5, record_every=1)
    else:
        choices.update(step=1e-3)
    try:
        run(mechanism.model, 0.02, **choices)
    except lw.LinkworkError:  # too stiff for this step
        return
    assert_goes_on(mechanism.model, end, 0.02, **choices)


class Sampled:
    """A controller that an event samples: what it holds is in an attribute, or in a list."""

    def __init__(self, in_list: bool) -> None:
        self.held, self.listed, self.in_list = 0.0, [0.0], in_list
        self.period = 0.05

    def set(self, held: float) -> None:
        self.held = self.listed[0] = held

    def events(self) -> lw.Event:
        listed = self.listed

        def sample(t: float, state: Any) -> None:
            bob = state.body("bob")
            listed[0] = self.held = -3.0 * bob.position[0] - 2.0 * bob.velocity[0]

        return lw.Event(lambda t, state: np.sin(np.pi * t / self.period), "clock", change=sample)

    def model(self) -> lw.Model:
        model, listed = mechanisms.pendulum(), self.listed
        law = (lambda t, q, v: [listed[0], 0, 0, 0, 0, 0]) if self.in_list else self.effort
        model.user_force(law, "bob", name="controller")
        return model

    def effort(self, t: float, q: Any, v: Any) -> list[float]:
        return [self.held, 0, 0, 0, 0, 0]


@pytest.mark.parametrize("in_list", [True, False])
def test_a_sampled_controller_goes_on_with_what_it_held_and_not_with_something_else(
    in_list: bool, tmp_path: Path
) -> None:
    sampled = Sampled(in_list)
    model, how = sampled.model(), {"rtol": 1e-8, "record_every": 1, "events": sampled.events()}
    whole = run(model, 0.6, **how)
    sampled.set(0.0)
    first = run(model, 0.33, output=tmp_path / "first.h5", **how)
    held = sampled.held
    assert held != 0.0
    rest = run(model, 0.6, start=first.snapshot(), **how)
    assert rest.manifest["resumed"] and bits_after(rest, 0.33) == bits_after(whole, 0.33)
    sampled.set(held)
    rest = run(model, 0.6, start=lw.Result.load(tmp_path / "first.h5").snapshot(), **how)
    assert rest.manifest["resumed"] and bits_after(rest, 0.33) == bits_after(whole, 0.33)
    sampled.set(0.0)
    with pytest.warns(
        lw.LinkworkWarning, match="start: 'controller'.*: reads something else than at the end"
    ):
        rest = run(model, 0.6, start=lw.Result.load(tmp_path / "first.h5").snapshot(), **how)
    assert rest.manifest["resumed"] is False
    assert np.abs(rest.q[-1] - whole.q[-1]).max() > 1e-4


def test_a_sample_in_steps_that_the_end_had_shortened_is_not_taken_again_with_what_it_left() -> None:
    sampled = Sampled(in_list=True)
    model, how = sampled.model(), {"rtol": 1e-8, "step": sampled.period, "events": sampled.events()}
    whole = run(model, 0.2, **how)
    resumed = set()
    for end in np.linspace(0.1, 0.13, 7):
        sampled.set(0.0)
        first = run(model, float(end), **how)
        rest = run(model, 0.2, start=first.snapshot(), **how)
        assert np.abs(rest.q[-1] - whole.q[-1]).max() < 1e-8, end
        resumed.add(rest.manifest["resumed"])
    assert resumed == {True, False}


def kicks() -> lw.Event:
    """Every 0.1 s 0.5 rad/s more, at times that the event itself moves on."""
    due = [0.1]

    def kick(t: float, state: Any) -> None:
        state.body("bob").velocity[0] += 0.5
        due[0] += 0.1

    return lw.Event(lambda t, state: t - due[0], "kick", direction=1, change=kick)


def test_an_event_that_moves_its_next_time_on_comes_once_where_the_end_had_shortened_steps() -> None:
    model, how = mechanisms.pendulum(), {"rtol": 1e-10, "step": 0.02}
    whole = run(model, 0.5, events=kicks(), **how)
    for end in (0.2, 0.205, 0.21):
        kick = kicks()
        first = run(model, end, events=kick, **how)
        rest = run(model, 0.5, start=first.snapshot(), events=kick, **how)
        assert np.abs(rest.q[-1] - whole.q[-1]).max() < 1e-8, end


@pytest.mark.parametrize("from_file", [True, False])
def test_a_start_from_the_middle_tells_what_was_changed_later(from_file: bool, tmp_path: Path) -> None:
    sampled = Sampled(in_list=True)
    model, how = sampled.model(), {"rtol": 1e-10, "events": sampled.events()}
    first = run(model, 0.4, times=[0.0, 0.13, 0.4], output=tmp_path / "r.h5" if from_file else None, **how)
    left = sampled.held
    with pytest.warns(lw.LinkworkWarning, match="'controller'.*: reads what .* changed after t = 0.13 s"):
        again = run(model, 0.4, start=first.snapshot(1), **how)
    assert np.abs(again.q[-1] - first.q[-1]).max() > 1e-6
    sampled.set(0.0)
    run(model, 0.13, **how)
    assert sampled.held != left
    again = run(model, 0.4, start=first.snapshot(1), **how)
    assert np.abs(again.q[-1] - first.q[-1]).max() < 1e-8


def test_a_start_from_the_middle_tells_nothing_where_the_last_change_was_back() -> None:
    """An effort that is switched off and on every 0.1 s, and is on at the end."""
    on = [1.0]

    def switch(t: float, state: Any) -> None:
        on[0] = 1.0 - on[0]

    model = mechanisms.pendulum()
    model.user_force(lambda t, q, v: [on[0], 0, 0, 0, 0, 0], "bob", name="effort")
    clock = lw.Event(lambda t, state: np.sin(np.pi * (t - 0.05) / 0.1), "clock", change=switch)
    how: dict[str, Any] = {"rtol": 1e-10, "events": clock, "step": 0.02}
    first = run(model, 0.3, times=[0.0, 0.1, 0.2, 0.3], **how)
    assert [it.t for it in first.events] == pytest.approx([0.05, 0.15, 0.25]) and on == [0.0]
    again = run(model, 0.3, start=first.snapshot(1), **how)
    assert np.abs(again.q[-1] - first.q[-1]).max() < 1e-8
    on[0] = 0.0
    with pytest.warns(lw.LinkworkWarning, match="'effort': reads what it or events have changed"):
        run(model, 0.3, start=first.snapshot(2), **how)


def test_a_start_from_the_middle_tells_that_a_law_has_latched_later() -> None:
    latched = [False]

    def law(t: float, q: Any, v: Any) -> list[float]:
        latched[0] = latched[0] or t > 0.2
        return [5.0 * latched[0], 0, 0, 0, 0, 0]

    model = mechanisms.pendulum()
    model.user_force(law, "bob", name="latch")
    first = run(model, 0.4, step=1e-3)
    with pytest.warns(lw.LinkworkWarning, match="'latch': reads what it or events have changed after"):
        run(model, 0.4, step=1e-3, start=first.snapshot(100))


@pytest.mark.parametrize("in_list", [True, False])
def test_what_the_last_run_left_in_a_controller_is_told_as_the_next_begins(in_list: bool) -> None:
    sampled = Sampled(in_list)
    model, how = sampled.model(), {"rtol": 1e-8, "record_every": 1, "events": sampled.events()}
    first = run(model, 0.33, **how)
    with pytest.warns(
        lw.LinkworkWarning, match="'controller': reads what events have changed in a run before"
    ):
        second = run(model, 0.33, **how)
    assert np.abs(second.q[-1] - first.q[-1]).max() > 1e-6
    sampled.set(0.0)
    assert bits_after(run(model, 0.33, **how), 0.0) == bits_after(first, 0.0)
    sampled.set(1.0)
    run(model, 0.33, **how)


def test_an_integrator_that_remembers_another_run_does_not_go_on() -> None:
    """Adams-Bashforth 2."""

    def ab2() -> Any:
        past: list[Any] = [None]

        def step(system: lw.System, t: float, y: Any, h: float) -> Any:
            f, before = system.derivative(t, y), past[0]
            past[0] = f
            return y + h * f if before is None else y + h * (1.5 * f - 0.5 * before)

        return step

    model, method = mechanisms.pendulum(), ab2()
    whole = run(model, 0.2, step=1e-3, integrator=ab2())
    first = run(model, 0.1, step=1e-3, integrator=method)
    rest = run(model, 0.2, step=1e-3, integrator=method, start=first.snapshot())
    assert rest.manifest["resumed"] and np.array_equal(rest.q[-1], whole.q[-1])
    for other in (method, ab2()):
        with pytest.warns(lw.LinkworkWarning, match="start: the integrator: reads something else"):
            rest = run(model, 0.2, step=1e-3, integrator=other, start=first.snapshot())
        assert rest.manifest["resumed"] is False
