"""Events of adaptive runs: when they come, what they change, what is refused."""

from __future__ import annotations

import pydoc
from functools import cache
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from recorded import PAIRS
from scipy.special import ellipk

GRAVITY = 9.81


def run(model: lw.Model, t_end: float, *events: lw.Event, rtol: float = 1e-10, **options: Any) -> lw.Result:
    return lw.simulate(model, t_end, rtol=rtol, events=events, progress=False, **options)


def ball(height: float = 1.0) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -GRAVITY))
    model.body("ball", mass=2.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, height))
    return model


def floor(restitution: float, level: float = 0.0) -> lw.Event:
    def height(t: float, state: lw.State) -> float:
        return float(state.body("ball").position[2]) - level

    def bounce(t: float, state: lw.State) -> None:
        state.body("ball").velocity[2] *= -restitution

    return lw.Event(height, direction=-1, change=bounce, name="floor")


def clock(time: float, **options: Any) -> lw.Event:
    return lw.Event(lambda t, state: t - time, name=f"at {time:g} s", **options)


# --- when ---


@pytest.mark.parametrize("integrator", PAIRS)
def test_a_pendulum_passes_its_lowest_point_at_a_quarter_of_its_period(integrator: str) -> None:
    """Released from the horizontal, the period is 4 sqrt(l / g) K(sin^2(45 deg))."""
    rtol = 1e-8 if integrator == "bs32" else 1e-11
    bottom = lw.Event(lambda t, state: state.body("bob").position[0], name="bottom")
    result = run(mechanisms.pendulum(), 6.0, bottom, integrator=integrator, rtol=rtol)
    quarter = np.sqrt(1 / GRAVITY) * ellipk(0.5)
    exact = quarter * np.arange(1, 6.0 / quarter, 2)
    assert [it.name for it in result.events] == ["bottom"] * len(exact)
    np.testing.assert_allclose([it.t for it in result.events], exact, rtol=1000 * rtol)


@pytest.mark.parametrize(("direction", "expected"), [(1, [0]), (-1, [1]), (0, [0, 1])])
def test_the_direction_chooses_the_crossing(direction: int, expected: list[int]) -> None:
    """A stone thrown up with 5 m/s crosses 1 m going up and coming down."""
    model = lw.Model(gravity=(0, 0, -GRAVITY))
    model.body("stone", mass=1.0, inertia=(1, 1, 1), velocity=(0, 0, 5))
    event = lw.Event(lambda t, state: state.q[0, 2] - 1.0, direction=direction)
    root = np.sqrt(25 - 2 * GRAVITY)
    exact = np.array([5 - root, 5 + root]) / GRAVITY
    found = [it.t for it in run(model, 1.5, event).events]
    np.testing.assert_allclose(found, exact[expected], atol=1e-10)


def test_events_of_one_step_come_in_order_of_time() -> None:
    times = [0.7, 0.1, 0.4, 0.100001]
    result = run(lw_resting(), 1.0, *(clock(time) for time in times))
    assert result.statistics["steps"] <= 3
    np.testing.assert_allclose([it.t for it in result.events], sorted(times), atol=1e-11)


def lw_resting() -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("stone", mass=1.0, inertia=(1, 1, 1))
    return model


def test_an_event_that_changes_nothing_changes_no_step() -> None:
    bottom = lw.Event(lambda t, state: state.body("bob").position[0])
    bare, watched = (run(mechanisms.pendulum(), 3.0, *events, record_every=1) for events in ((), (bottom,)))
    np.testing.assert_array_equal(bare.t, watched.t)
    assert len(watched.events) == 3


def test_a_value_of_zero_at_the_start_is_no_event() -> None:
    event = lw.Event(lambda t, state: state.q[0, 2] - 1.0)
    assert run(ball(), 0.3, event).events == ()


# --- the end ---


def test_a_terminal_event_ends_the_run_at_its_time() -> None:
    impact = lw.Event(lambda t, state: state.body("ball").position[2], terminal=True, name="impact")
    result = run(ball(), 5.0, impact, times=[0.1, 0.2, 3.0])
    exact = np.sqrt(2 / GRAVITY)
    np.testing.assert_allclose(result.t, [0.1, 0.2, exact], rtol=1e-10)
    assert result.position[-1, 0, 2] == pytest.approx(0.0, abs=1e-10)
    assert result.velocity[-1, 0, 2] == pytest.approx(-GRAVITY * exact, rel=1e-9)
    assert "impact" in result.summary()


def test_of_two_terminal_events_in_one_step_the_first_counts() -> None:
    result = run(lw_resting(), 1.0, clock(0.6, terminal=True), clock(0.3, terminal=True), clock(0.2))
    assert [it.name for it in result.events] == ["at 0.2 s", "at 0.3 s"]
    assert result.t[-1] == pytest.approx(0.3)


# --- changes ---


@pytest.mark.parametrize("integrator", PAIRS)
def test_a_ball_bounces_when_and_as_high_as_it_must(integrator: str) -> None:
    restitution, first = 0.8, np.sqrt(2 / GRAVITY)
    result = run(ball(), 3.0, floor(restitution), integrator=integrator, rtol=1e-8)
    flights = 2 * first * restitution ** np.arange(1, 20)
    exact = first + np.concatenate([[0.0], np.cumsum(flights)])
    np.testing.assert_allclose([it.t for it in result.events], exact[exact < 3.0], atol=1e-7)
    for k, it in enumerate(result.events):
        assert it.v_before[0, 2] == pytest.approx(-GRAVITY * first * restitution**k, rel=1e-6)
        assert it.v_after[0, 2] == pytest.approx(-restitution * it.v_before[0, 2], rel=1e-12)


@pytest.mark.parametrize("integrator", PAIRS)
def test_two_balls_that_come_down_at_the_same_time_both_bounce(integrator: str) -> None:
    model = lw.Model(gravity=(0, 0, -GRAVITY))
    for x, name in enumerate(("left", "right")):
        model.body(name, mass=2.0, inertia=(0.1,) * 3, position=(x, 0, 1.0))

    def bounce(name: str) -> lw.Event:
        def change(t: float, state: lw.State) -> None:
            state.body(name).velocity = -state.body(name).velocity

        return lw.Event(lambda t, state: state.body(name).position[2], name, direction=-1, change=change)

    log = lw.Event(lambda t, state: state.body("right").position[2], "log")
    result = run(model, 3.0, bounce("left"), log, bounce("right"), integrator=integrator)
    fall = np.sqrt(2 / GRAVITY)
    assert [it.name for it in result.events] == ["left", "right", "log"] * 3
    assert [it.t for it in result.events] == pytest.approx(np.repeat([1, 3, 5], 3) * fall, rel=1e-9)
    t = 3.0 - 6 * fall
    assert result.position[-1, :, 2] == pytest.approx(1 - GRAVITY * t**2 / 2, rel=1e-7)


@pytest.mark.parametrize("onward", ["dopri5", "dop853"])
@pytest.mark.parametrize("of", ["time", "place"])
def test_an_event_where_a_run_is_cut_in_two_comes_once(of: str, onward: str) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("body", mass=1.0, inertia=(0.1,) * 3, velocity=(1, 0, 0))

    def value(t: float, state: lw.State) -> float:
        return (t if of == "time" else float(state.body("body").position[0])) - 0.5

    def turn_back(t: float, state: lw.State) -> None:
        state.body("body").velocity = -state.body("body").velocity

    wall = lw.Event(value, "wall", change=turn_back)
    first = run(model, 0.5, wall, rtol=1e-9)
    second = run(model, 1.0, wall, rtol=1e-9, integrator=onward, start=first.snapshot())
    assert [it.t for it in first.events] == pytest.approx([0.5], abs=1e-12)
    assert not second.events
    assert second.position[-1, 0, 0] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("on_the_way", ["", "its end alone", "a short run before it", "another event"])
@pytest.mark.parametrize("rtol", [1e-6, 1e-9])
@pytest.mark.parametrize("integrator", ["bs32", "dopri5", "tsit5"])
def test_an_event_at_the_very_end_of_a_run_is_in_it_or_in_the_next(
    integrator: str, rtol: float, on_the_way: str
) -> None:
    """The last step is cut there, and sees it by rounding or not; so do steps that are taken again."""
    model = lw.Model()
    model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", "bar", at=(0, 0, 0), axis=(0, 1, 0))

    def at(x: float, terminal: bool = False) -> lw.Event:
        return lw.Event(lambda t, state: state.body("bar").position[0] - x, terminal=terminal)

    others = [at(0.002)] if on_the_way == "another event" else []
    how: dict[str, Any] = {"integrator": integrator, "rtol": rtol, "on_inaccurate": "pass", "record_every": 1}
    whole = run(model, 2.0, *others, at(0.0), **how)
    crossing = whole.events[len(others)].t

    def cut(end: float, *events: lw.Event) -> tuple[list[float], lw.Result]:
        """Of the first run, and what goes on from it."""
        begun = run(model, end - 1e-4, *events, **how) if on_the_way == "a short run before it" else None
        start = {} if begun is None else {"start": begun.snapshot()}
        times = {"times": [end], "record_every": None} if on_the_way == "its end alone" else {}
        first = run(model, end, *events, **{**how, **start, **times})
        listed = [it.t for part in (begun, first) if part is not None for it in part.events]
        return listed, run(model, 2.0, *events, **how, start=first.snapshot())

    for ulps in (-3, 0, 3):
        end = crossing + ulps * np.spacing(crossing)
        before, second = cut(end, *others, at(0.0))
        times = [*before, *(it.t for it in second.events)]
        assert times == pytest.approx([it.t for it in whole.events], abs=10 * rtol)
        assert (second.q[-1] == whole.q[-1]).all()
        before, second = cut(end, *others, at(0.0, terminal=True))
        found = len(before) > len(others)
        expected = next(it.t for it in whole.events if it.t > crossing + 0.1) if found else end
        assert second.t[-1] == pytest.approx(expected, abs=10 * rtol)
        assert second.events[-1].t == second.t[-1]


def test_bodies_struck_where_a_run_ends_are_told_of_once() -> None:
    model = lw.Model()
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    bend = lw.functions.piecewise_polynomial([0.0, 1.0, 9.0], [[0.0, -1.0], [-1.0, 1.0]])
    model.drive("pin", position=bend)
    model = lw.assemble(model).model
    end = lw.Event(lambda t, state: t - (1.0 - 1e-15), "end", terminal=True)
    log = lw.Event(lambda t, state: t - 1.0, "log")
    for events, t_end in (([end], 2.0), ([log], 1.0), ([], 1.0)):
        first = run(model, t_end, *events, rtol=1e-8)
        second = run(model, 2.0, *events, rtol=1e-8, start=first.snapshot())
        assert first.t[-1] == pytest.approx(1.0) and len(first._strikes) + len(second._strikes) == 1


def test_an_end_and_a_change_at_the_same_time_both_count() -> None:
    end = lw.Event(lambda t, state: state.body("ball").position[2], "end", terminal=True)
    for events in ([end, floor(1.0)], [floor(1.0), end]):
        result = run(ball(), 2.0, *events)
        assert result.t[-1] == pytest.approx(np.sqrt(2 / GRAVITY), rel=1e-9)
        assert result.velocity[-1, 0, 2] == pytest.approx(np.sqrt(2 * GRAVITY), rel=1e-9)


def test_the_work_counts_what_an_impact_takes() -> None:
    result = run(ball(), 1.0, floor(0.5), record_every=1)
    assert np.abs(result.energy_error).max() < 1e-10
    lost = result.energy[0] - result.energy[-1]
    assert lost == pytest.approx(2.0 * GRAVITY * (1 - 0.5**4), rel=1e-8)
    assert result.work[-1] == pytest.approx(-lost)


@pytest.mark.parametrize("level", [0.0, 1000.0])
@pytest.mark.parametrize("restitution", [0.0, 1e-3, 0.01, 0.05, 0.2, 0.5, 0.8, 0.9, 0.95])
def test_a_ball_never_falls_through_the_floor(restitution: float, level: float) -> None:
    """Its bounces accumulate at sqrt(2 / g) (1 + e) / (1 - e); nothing after that is computed."""
    end = np.sqrt(2 / GRAVITY) * (1 + restitution) / (1 - restitution)
    with pytest.raises(lw.StepSizeError, match="event 'floor' comes after ever shorter times") as caught:
        run(ball(level + 1.0), 1.5 * end, floor(restitution, level), rtol=1e-8)
    assert caught.value.time == pytest.approx(end, rel=1e-3)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ((5.0, 0.0), r"velocity has shape \(3,\), not \(2,\)"),
        ((5.0,), r"velocity has shape \(3,\), not \(1,\)"),
        ("fast", "velocity 'fast' is not made of numbers"),
        ([[1, 2], [3]], "has rows of different lengths"),
    ],
)
def test_what_a_change_assigns_has_the_shape_of_the_state(value: Any, message: str) -> None:
    def change(t: float, state: Any) -> None:
        state.body("ball").velocity = value

    falls = lw.Event(lambda t, state: state.body("ball").position[2] - 0.5, change=change)
    with pytest.raises(lw.OptionError, match=message):
        run(ball(), 1.0, falls)


def test_a_change_ends_the_run_where_it_says_so() -> None:
    """After five bounces with e = 1/2 the speed is 1/32 of the first."""
    bounce, first = floor(0.5).change, GRAVITY * np.sqrt(2 / GRAVITY)
    assert bounce is not None

    def bounce_or_rest(t: float, state: lw.State) -> bool:
        bounce(t, state)
        return bool(state.v[0, 2] < first / 20)

    impact = lw.Event(floor(0.5).function, direction=-1, change=bounce_or_rest)
    result = run(ball(), 3.0, impact)
    assert len(result.events) == 5
    assert result.t[-1] == result.events[-1].t
    assert result.velocity[-1, 0, 2] == pytest.approx(first / 32)


def test_a_kick_in_passing_is_given_once() -> None:
    """A change that does not turn the motion back is no barrier: 1 m/s more at the passage through x = 0."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("cart", mass=1.0, inertia=(1, 1, 1), position=(-1, 0, 0), velocity=(1, 0, 0))

    def kick(t: float, state: lw.State) -> None:
        state.body("cart").velocity[0] += 1.0

    result = run(model, 3.0, lw.Event(lambda t, state: state.q[0, 0], change=kick))
    assert len(result.events) == 1
    assert result.position[-1, 0, 0] == pytest.approx(4.0)


def test_joints_answer_an_impulse_on_one_body() -> None:
    """An impulse I across the free end of a pinned rod gives omega = I l / (m l^2 / 3), by way of the pin."""
    impulse, kick = 0.3, 0.5
    model = mechanisms.rod_pendulum()

    def strike(t: float, state: lw.State) -> None:
        rod = state.body("rod")
        along = 2 * rod.position
        across = np.array([-along[1], along[0], 0.0])
        rod.velocity += impulse * across  # 1 kg
        rod.omega[2] += impulse * 0.5 / (1 / 12)

    result = run(model, 1.0, clock(kick, change=strike), record_every=1)
    (it,) = result.events
    jump = it.v_after[0] - it.v_before[0]
    assert jump[5] == pytest.approx(3 * impulse, rel=1e-9)
    along = 2 * it.q_before[0, :3]
    np.testing.assert_allclose(jump[:3], 1.5 * impulse * np.array([-along[1], along[0], 0]), atol=1e-9)
    assert result.violation[:, :2].max() < 1e-9
    assert np.abs(result.energy_error).max() < 1e-8


def test_a_pendulum_that_bounces_off_a_wall_without_loss_swings_for_ever() -> None:
    """A wall at the lowest point, restitution 1: the mirror image of the free pendulum."""

    def bounce(t: float, state: lw.State) -> None:
        state.v *= -1.0

    wall = lw.Event(lambda t, state: state.body("bob").position[0], direction=1, change=bounce, name="wall")
    times = np.linspace(0, 4, 41)
    free = run(mechanisms.pendulum(), 4.0, rtol=1e-11, times=times)
    walled = run(mechanisms.pendulum(), 4.0, wall, rtol=1e-11, times=times)
    assert len(walled.events) == 3
    mirrored = -np.abs(free.position[:, 0, 0])
    np.testing.assert_allclose(walled.position[:, 0, 0], mirrored, atol=1e-8)
    np.testing.assert_allclose(walled.energy, walled.energy[0], atol=1e-8)


def test_with_every_step_recorded_an_event_that_changes_the_state_has_a_frame() -> None:
    result = run(ball(), 1.0, floor(0.5), record_every=3)
    assert {it.t for it in result.events} <= set(result.t)
    assert len(result.events) == 2


# --- files ---


def test_events_come_back_from_a_file(tmp_path: Path) -> None:
    written = run(ball(), 1.0, floor(0.5), output=tmp_path / "run.h5")
    in_memory = run(ball(), 1.0, floor(0.5))
    in_memory.save(tmp_path / "saved.h5")
    for result in (written, lw.Result.load(tmp_path / "saved.h5")):
        assert [it.name for it in result.events] == ["floor", "floor"]
        for found, exact in zip(result.events, in_memory.events, strict=True):
            assert found.t == exact.t
            for field in ("q_before", "v_before", "q_after", "v_after"):
                np.testing.assert_array_equal(getattr(found, field), getattr(exact, field))


def test_the_events_of_a_run_that_failed_are_in_its_file(tmp_path: Path) -> None:
    with pytest.raises(lw.StepSizeError):
        run(ball(), 3.0, floor(0.5), output=tmp_path / "run.h5")
    result = lw.Result.load(tmp_path / "run.h5")
    assert not result.finished
    assert len(result.events) > 10


# --- what is refused ---


@pytest.mark.parametrize(
    ("event", "message"),
    [
        (lambda t, state: 1.0, "is no linkwork.Event"),
        (lw.Event(lambda t, state: float("nan"), name="odd"), "'odd'.*not a finite number"),
        (lw.Event(lambda t, state: 1.0, name="odd", direction=2), "'odd'.*direction"),
        (lw.Event(lambda t, state: 1.0, name="odd", tolerance=-1.0), "'odd'.*tolerance"),
        (clock(0.1, change=lambda t, state: state), "at 0.1 s.*in place"),
        (clock(0.1, change=lambda t, state: state.v.fill(np.inf)), "at 0.1 s.*not finite"),
    ],
)
def test_an_event_that_makes_no_sense_is_refused_by_name(event: Any, message: str) -> None:
    with pytest.raises(lw.OptionError, match=message):
        run(ball(), 0.3, event)


def test_events_need_adaptive_steps() -> None:
    with pytest.raises(lw.OptionError, match="give rtol"):
        lw.simulate(ball(), 0.3, 1e-3, events=floor(0.5), progress=False)


def test_an_error_of_the_users_function_reaches_the_user() -> None:
    with pytest.raises(lw.ModelError, match="no body named 'boll'"):
        run(ball(), 0.3, lw.Event(lambda t, state: state.body("boll").position[2]))


def test_what_a_state_has_is_told_by_help() -> None:
    assert "Poses (n, 7)" in pydoc.render_doc(lw.State)
    assert "angular velocity" in pydoc.render_doc(lw.State).lower()


# --- the end of a run ---


@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-9])
@pytest.mark.parametrize("later", [0.0, 1e-12, 1e-11, 1e-10, 1e-9, 1e-7])
def test_an_impact_shortly_before_the_end_comes_once(rtol: float, later: float) -> None:
    """At sqrt(2 h / g); what has bounced is still there until it has left by more than times are known."""
    for height in np.linspace(0.1, 1.0, 12):
        result = run(ball(height), np.sqrt(2 * height / GRAVITY) + later, floor(0.7), rtol=rtol)
        assert len(result.events) <= 1
        assert result.velocity[-1, 0, 2] == pytest.approx(
            (0.7 if result.events else -1.0) * np.sqrt(2 * GRAVITY * height), rel=1e-4
        )


@pytest.mark.parametrize(("start", "t_end"), [(0.0, 1e4), (-2.0, 0.0), (-1.0, 1e-9), (1e5, 1e5 + 2)])
def test_bounces_end_alike_whatever_the_length_of_the_run_and_its_start(start: float, t_end: float) -> None:
    def until_slow(t: float, state: lw.State) -> bool:
        body = state.body("ball")
        body.velocity[2] *= -0.7
        return bool(body.velocity[2] < 0.02)

    event, model = lw.Event(floor(0.7).function, direction=-1, change=until_slow, name="floor"), ball(0.05)
    usual = run(model, 2.0, event, rtol=1e-8)
    at = lw.Snapshot.of(start, lw.System(model).initial_state())
    found = run(model, t_end, event, rtol=1e-8, start=at)
    assert len(found.events) == len(usual.events) == 11
    assert found.t[-1] - start == pytest.approx(usual.t[-1], abs=1e-9)


def test_a_force_without_bounds_ends_a_run_that_ends_at_zero() -> None:
    model = ball()
    model.force("ball", force=(0, 0, lambda t: 1 / (-0.5 - t) ** 2 if t < -0.5 else 1e300))
    with pytest.raises(lw.StepSizeError, match="stays above the tolerances"):
        run(model, 0.0, rtol=1e-6, start=lw.Snapshot.of(-1.0, lw.System(model).initial_state()))


@pytest.mark.parametrize("by_change", [False, True])
def test_a_run_that_an_event_ended_goes_on_to_the_next_one(by_change: bool) -> None:
    def aside(t: float, state: lw.State) -> float:
        return float(state.body("bob").position[0]) - 0.2

    every = run(mechanisms.pendulum(), 3.0, lw.Event(aside, name="aside")).events
    how: dict[str, Any] = {"change": lambda t, state: True} if by_change else {"terminal": True}
    found = run(mechanisms.pendulum(), 10.0, lw.Event(aside, name="aside", **how))
    for passage in every[1:3]:
        found = run(mechanisms.pendulum(), 10.0, lw.Event(aside, name="aside", **how), start=found.snapshot())
        assert [event.t for event in found.events] == pytest.approx([passage.t], abs=1e-7)
        assert found.t[-1] == found.events[0].t


@pytest.mark.parametrize("change", [
    {"rtol": 1e-9}, {"integrator": "dop853"}, {"terminal": False}, {"more": True}, {"t_end": 0.01},
])  # fmt: skip
@pytest.mark.parametrize("place", [0.9, 0.5, 0.2])
def test_an_event_does_not_come_again_in_a_run_that_goes_on_by_another_method(
    change: dict[str, Any], place: float
) -> None:
    """Its time is known to 1e-12 s: on which side of zero the state is that goes on, is rounding."""

    def aside(t: float, state: lw.State) -> float:
        return float(state.body("bob").position[0]) - place

    def kick(t: float, state: lw.State) -> None:
        state.v *= 1.5

    def event(terminal: bool = True) -> lw.Event:
        return lw.Event(aside, name="kick", change=kick, terminal=terminal)

    first = run(mechanisms.pendulum(), 3.0, event(), rtol=1e-6)
    options = {"rtol": 1e-6, "integrator": "dopri5", **change}
    events = [event(options.pop("terminal", True))]
    if options.pop("more", False):
        events.append(clock(2.9))
    t_end = first.t[-1] + options.pop("t_end", 0.05)
    second = run(mechanisms.pendulum(), t_end, *events, start=first.snapshot(), **options)
    assert [it.name for it in second.events] == []
    assert second.t[-1] == t_end
    assert np.abs(second.energy_error).max() < 1e-4


def test_the_event_of_another_body_does_not_undo_a_barrier() -> None:
    """Two balls that hit the floor 5 ps apart, and leave it at a hundredth of their speed."""
    model = lw.Model()
    height, g = 0.5, GRAVITY
    later = 5e-12 * np.sqrt(2 * g * height)
    for name, x, z in (("a", 0.0, height), ("b", 1.0, height + later)):
        model.body(name, mass=1.0, inertia=(0.1,) * 3, position=(x, 0, z))

    def floor_of(name: str) -> lw.Event:
        def bounce(t: float, state: lw.State) -> None:
            state.body(name).velocity[2] *= -0.01

        return lw.Event(lambda t, state: state.body(name).position[2], name=name, change=bounce)

    result = run(model, np.sqrt(2 * height / g) + 1e-4, floor_of("a"), floor_of("b"))
    assert sorted(it.name for it in result.events) == ["a", "b"]
    rise = 0.01 * np.sqrt(2 * g * height) - g * 1e-4
    assert result.velocity[-1, :, 2] == pytest.approx([rise, rise], rel=1e-5)


@pytest.mark.parametrize(("happened", "message"), [
    (5, "is no list of"), ([("kick", "up")], "is no list of"),
    ([("kick", [1.0])], "'kick' has not the 13 numbers"),
])  # fmt: skip
def test_events_that_are_said_to_have_come_are_looked_at(happened: Any, message: str) -> None:
    start = run(mechanisms.pendulum(), 0.1).snapshot()._replace(happened=happened, resume=None)
    with pytest.raises(lw.OptionError, match=message):
        run(mechanisms.pendulum(), 0.2, clock(0.15), start=start)


def hinged_bars(count: int) -> lw.Model:
    model = lw.Model()
    before: Any = "ground"
    for k in range(count):
        bar = model.body(f"bar {k}", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3 + 0.6 * k, 0, 0))
        model.revolute(before, bar, at=(0.6 * k, 0, 0), axis=(0, 1, 0), name=f"hinge {k}")
        before = bar
    return model


CALLS: list[float] = []
CHANGES: dict[str, Any] = {
    "bounce": lambda t, state: setattr(state, "v", -0.6 * state.v),
    "splash": lambda t, state: setattr(state, "v", 0.5 * state.v),
    "kick": lambda t, state: setattr(state, "v", np.concatenate([-2.4 * state.v[:6], state.v[6:]])),
    "count": lambda t, state: CALLS.append(t),
}


def event_of_bars(of: str, level: float, change: str) -> lw.Event:
    def height(t: float, state: lw.State) -> float:
        bar = state.body("bar 0")
        return float(bar.position[2] + 0.3 * lw.rotation.matrix(bar.orientation)[2, 0] + level)

    def speed(t: float, state: lw.State) -> float:
        return float(state.body("bar 0").omega[1]) - 8.0 * level

    function = height if of == "height" else speed
    return lw.Event(function, direction=-1 if of == "height" else 1, change=CHANGES[change])


@cache
def right_times(of: str, level: float, change: str) -> list[float]:
    right = run(hinged_bars(2), 0.5, event_of_bars(of, level, change), rtol=1e-11, record_every=1)
    return [it.t for it in right.events]


@pytest.mark.parametrize("integrator", ["bs32", "dopri5", "tsit5"])
@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("of", ["height", "speed"])
def test_changes_of_mechanisms_with_joints_come_once(of: str, change: str, integrator: str) -> None:
    """What brings the state back to the constraints moves the function off zero, to either side."""
    how: dict[str, Any] = {"integrator": integrator, "on_inaccurate": "pass", "record_every": 1}
    for level in (0.2, 0.3, 0.47):
        times = right_times(of, level, change)
        assert times
        for rtol in (1e-4, 1e-6):
            found = run(hinged_bars(2), 0.5, event_of_bars(of, level, change), rtol=rtol, **how)
            assert [it.t for it in found.events] == pytest.approx(times, abs=30 * rtol)


def spinning() -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    rate = 2 * np.pi
    arm = model.body(
        "arm",
        mass=1.0,
        inertia=(0.1,) * 3,
        position=(0.3, 0, 0),
        omega=(0, rate, 0),
        velocity=(0, 0, -0.3 * rate),
    )
    model.revolute("ground", arm, at=(0, 0, 0), axis=(0, 1, 0))
    return model


@pytest.mark.parametrize("change", [None, lambda t, state: None])
@pytest.mark.parametrize("integrator", ["dopri5", "bs32"])
def test_functions_that_jump_through_zero_come_every_time(integrator: str, change: Any) -> None:
    def inside(t: float, state: lw.State) -> float:
        return 1.0 if state.body("arm").position[0] > 0.1 else -1.0

    def angle(t: float, state: lw.State) -> float:
        x, _, z = state.body("arm").position
        return float(np.arctan2(-z, x)) - 0.5

    out = np.arccos(1 / 3) / (2 * np.pi)
    expected = {
        inside: [turn + at for turn in range(3) for at in (out, 1 - out)],
        angle: [turn + at for turn in range(3) for at in (0.5 / (2 * np.pi), 0.5)],
    }
    for function, times in expected.items():
        event = lw.Event(function, change=change)
        result = run(spinning(), 3.0, event, rtol=1e-8, integrator=integrator, step=0.02)
        assert [it.t for it in result.events] == pytest.approx(times, abs=1e-5)


@pytest.mark.parametrize("start", [0.5, 0.7, 0.913, 1.0, 1.5, 2.0])
@pytest.mark.parametrize("wall", [False, True])
def test_what_rests_at_a_barrier_is_not_pushed_through_without_a_word(start: float, wall: bool) -> None:
    """Also where its function is zero but for roundoff all the time, and another event comes meanwhile."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("ball", mass=1.0, inertia=(0.1,) * 3, position=(0, 0, start), velocity=(1, 0, -1))
    model.force("ball", force=(0, 0, lambda t: -2.0 if t > 3.0 else 0.0), breaks=[3.0])

    def stop(t: float, state: lw.State) -> None:
        state.body("ball").velocity[2] = 0.0

    events = [
        lw.Event(lambda t, state: state.body("ball").position[2], direction=-1, change=stop, name="floor")
    ]
    if wall:
        events.append(clock(2.5, change=lambda t, state: None))
    with pytest.raises(lw.StepSizeError, match="'floor' comes after ever shorter times"):
        run(model, 3.5, *events, rtol=1e-8)


def test_a_change_that_takes_the_motion_elsewhere_is_no_barrier() -> None:
    """From x = 1 to x = 2 with its speed reversed: it comes back through x = 1 one second later."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("ball", mass=1.0, inertia=(0.1,) * 3, velocity=(1, 0, 0))

    def turn_back(t: float, state: lw.State) -> None:
        state.body("ball").position[0] = 2.0
        state.body("ball").velocity[0] = -1.0

    def beyond(t: float, state: lw.State) -> float:
        return float(state.body("ball").position[0]) - 1.0

    for direction, times in ((1, [1.0]), (0, [1.0, 2.0, 3.0])):
        result = run(model, 3.5, lw.Event(beyond, direction=direction, change=turn_back))
        assert [it.t for it in result.events] == pytest.approx(times)


def test_what_touches_zero_does_not_pass_it() -> None:
    """A second event of the same function, in the other direction: a bounce is no rise through the floor."""
    for height in np.linspace(0.5, 1.5, 11):
        lift = lw.Event(lambda t, state: state.body("ball").position[2], direction=1, name="lifts off")
        result = run(ball(height), 1.2, floor(0.8), lift, rtol=1e-8)
        assert {it.name for it in result.events} == {"floor"}


def test_what_a_state_does_not_have_cannot_be_set() -> None:
    def by_body(t: float, state: Any) -> None:
        state.body("ball").angular_velocity = (0, 0, 0)

    def by_state(t: float, state: Any) -> None:
        state.velocity = 0.0

    for change, name in ((by_body, "angular_velocity"), (by_state, "velocity")):
        with pytest.raises(AttributeError, match=f"'{name}'"):
            run(ball(), 0.5, clock(0.2, change=change))


@pytest.mark.parametrize("answer", [True, np.bool_(False)])
def test_a_function_that_says_whether_instead_of_how_far_is_refused(answer: Any) -> None:
    below = lw.Event(lambda t, state: answer, name="below", terminal=True)
    with pytest.raises(
        lw.OptionError,
        match=f"'below': its function returned {answer!r}.*passes zero".replace("(", r"\(").replace(
            ")", r"\)"
        ),
    ):
        run(ball(), 0.8, below)


@pytest.mark.parametrize("orientation", [(0, 0, 0, 0), (1, np.nan, 0, 0)])
@pytest.mark.parametrize("hinged", [True, False])
def test_a_change_to_no_orientation_is_refused_by_name(orientation: Any, hinged: bool) -> None:
    def change(t: float, state: lw.State) -> None:
        state.body("ball").orientation = orientation

    model = ball()
    if hinged:
        model.revolute("ground", "ball", at=(0, 0, 0), axis=(0, 1, 0))
    with pytest.raises(lw.OptionError, match="event 'at 0.2 s': its change leaves body 'ball'"):
        run(model, 0.5, clock(0.2, change=change))
