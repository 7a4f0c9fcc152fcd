"""Events come once, whatever their functions are of, whatever the tolerance, and in runs that go on."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest

GRAVITY = 9.81


def run(model: lw.Model, t_end: float, event: lw.Event, rtol: float = 1e-9, **options: Any) -> lw.Result:
    return lw.simulate(model, t_end, rtol=rtol, events=event, progress=False, **options)


def ball(**state: Any) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -GRAVITY))
    model.body("ball", mass=2.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, 1), **state)
    return model


@pytest.mark.parametrize("rtol", [1e-10, 1e-7])
def test_a_speed_is_passed_once_where_the_change_leaves_it_alone(rtol: float) -> None:
    """A falling bar moves from level to level; each gives a cart 1 m/s."""
    model = lw.Model()
    model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", "bar", at=(0, 0, 0), axis=(0, 1, 0))
    model.body("cart", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 5, 0))
    model.translational("ground", "cart", at=(0, 5, 0), axis=(1, 0, 0))

    def kick(t: float, state: lw.State) -> None:
        state.body("cart").velocity[0] += 1.0

    for level in [*np.linspace(0.5, 3.5, 41), 3.1325]:
        passed = lw.Event(
            lambda t, state, at=level: state.body("bar").omega[1] - at, direction=1, change=kick
        )
        result = run(model, 0.5, passed, rtol)
        assert len(result.events) == 1
        assert result.v[-1, 1, 0] == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("restitution", [0.5, 0.1, 0.02])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-6, 0.0])
def test_what_bounces_stays_above_the_floor_however_large_the_tolerance(
    restitution: float, tolerance: float
) -> None:
    """v_n = e^n (2 g h)^1/2, until a bounce is slower than 5 cm/s."""

    def bounce(t: float, state: lw.State) -> bool:
        state.body("ball").velocity[2] *= -restitution
        return bool(state.body("ball").velocity[2] < 0.05)

    floor = lw.Event(
        lambda t, state: state.body("ball").position[2], direction=-1, change=bounce, tolerance=tolerance
    )
    result = run(ball(), 3.0, floor)
    speed, bounces, time = np.sqrt(2 * GRAVITY), 1, np.sqrt(2 / GRAVITY)
    while speed * restitution >= 0.05:
        speed *= restitution
        time += 2 * speed / GRAVITY
        bounces += 1
    assert len(result.events) == bounces
    assert result.t[-1] == pytest.approx(time, abs=1e-7)
    assert result.position[:, 0, 2].min() > -1e-9


def test_events_at_equal_intervals_are_no_accumulation() -> None:
    ticks = lw.Event(lambda t, state: np.sin(np.pi * t / 5e-3), change=lambda t, state: None, tolerance=0.01)
    result = run(ball(), 0.1025, ticks)
    np.testing.assert_allclose([it.t for it in result.events], np.arange(1, 21) * 5e-3, atol=1e-12)


def with_force(t: float) -> lw.Model:
    model = ball()
    model.force("ball", force=(lw.functions.piecewise_polynomial([0, t, 9], [[0.0], [3.0]]), 0, 0))
    return model


def with_contact(t: float) -> lw.Model:
    model = ball()
    level = 1 - GRAVITY * t**2 / 2
    model.sphere_plane_contact(
        "ground", "ball", at=((0, 0, level - 0.03), (0, 0, 1)), normal=(0, 0, 1), radius=0.03, stiffness=1e6
    )
    return model


def with_stop(t: float) -> lw.Model:
    model = ball()
    level = 1 - GRAVITY * t**2 / 2
    model.translational("ground", "ball", at=(0, 0, 1), axis=(0, 0, 1))
    model.translational_stop(
        "ground", "ball", at=(0, 0, 1), axis=(0, 0, 1), lower=level - 1, upper=5.0, stiffness=1e6
    )
    return model


@pytest.mark.parametrize("make", [with_force, with_contact, with_stop])
@pytest.mark.parametrize("apart", [0.0, 1e-13, 1e-9])
@pytest.mark.parametrize("resumed", [True, False])
@pytest.mark.parametrize("by", ["time", "place"])
def test_a_run_goes_on_after_a_terminal_event_where_the_motion_is_not_smooth(
    make: Any, apart: float, resumed: bool, by: str
) -> None:
    for time in (0.1, 0.25, 0.3):
        level = 1 - GRAVITY * (time + apart) ** 2 / 2
        event = lw.Event(
            (lambda t, state, at=time + apart: t - at)
            if by == "time"
            else (lambda t, state, at=level: state.body("ball").position[2] - at),
            terminal=True,
            direction=1 if by == "time" else -1,
        )
        first = run(make(time), time + 0.01, event)
        assert first.t[-1] == pytest.approx(time + apart, abs=1e-8)
        start = first.snapshot()
        rest = run(make(time), time + 0.01, event, start=start if resumed else start._replace(resume=None))
        assert rest.t[-1] == time + 0.01
        assert not rest.events


@pytest.mark.parametrize("period", [1e3, 1.0, 1e-3, 1e-6, 1e-9, 1e-12])
def test_bounces_are_found_whatever_the_unit_of_time(period: float) -> None:
    """From 1/2 m, at restitution 0.7, with a gravity that lets 1 m take one `period` [s]."""
    gravity = 2.0 / period**2
    model = lw.Model(gravity=(0, 0, -gravity))
    model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, 0.5))

    def bounce(t: float, state: lw.State) -> None:
        state.body("ball").velocity[2] *= -0.7

    floor = lw.Event(lambda t, state: state.body("ball").position[2], direction=-1, change=bounce)
    result = run(model, 3 * period, floor, 1e-10)
    first = np.sqrt(0.5)
    expected = first + 2 * first * np.cumsum([0.0, 0.7, 0.49, 0.343])
    assert np.array([it.t for it in result.events]) / period == pytest.approx(expected, rel=1e-8)
