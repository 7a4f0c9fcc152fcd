"""The track: it closes, runs on its wheels, and passes through none of them."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms.tracked_chain import PIN, PITCH, PITCH_RADIUS, ROLLER_RADIUS, WHEEL_RADIUS, pins

SHOES = 60


def run(t_end: float, step: float = 2e-4, speed: float = 1.0) -> lw.Result:
    return lw.simulate(
        lw.mechanisms.tracked_chain(SHOES, speed),
        t_end=t_end,
        step=step,
        on_inaccurate="pass",
        progress=False,
    )


def pins_of(result: lw.Result) -> np.ndarray:
    """Where the first pin of each shoe is (k, shoes, 3)."""
    along = lw.rotation.matrix(result.orientation[:, :SHOES])[..., 0]
    places: np.ndarray = result.position[:, :SHOES] - PITCH / 2 * along
    return places


def test_pins_are_a_pitch_apart_all_the_way_round() -> None:
    for shoes in (40, 60, 200):
        points, center = pins(shoes)
        apart = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
        assert apart == pytest.approx(np.full(shoes, PITCH), rel=1e-12)
        assert center[0] == pytest.approx(PITCH * (shoes - 20) / 2, rel=1e-14)


def test_no_pin_goes_through_a_wheel_or_a_roller() -> None:
    """They press in by less than 3 mm, under a tension of 30 kN, while some shoes pass on."""
    result = run(0.5)
    places = pins_of(result)
    for name, radius in (
        ("wheel", WHEEL_RADIUS),
        ("idler", WHEEL_RADIUS),
        ("upper roller 1", ROLLER_RADIUS),
        ("lower roller 1", ROLLER_RADIUS),
    ):
        distance = np.linalg.norm(places - result.body(name).position[:, None], axis=2)
        assert distance.min() > radius + PIN - 3e-3
        if radius == WHEEL_RADIUS:  # which always has some on it
            assert distance.min(axis=1).max() < radius + PIN + 1e-3
    assert np.abs(places[-1, 0] - places[0, 0]).max() > 2 * PITCH


def test_friction_turns_what_the_track_runs_on() -> None:
    """With the track, which slips little; the rollers above and below turn in opposite directions."""
    result = run(0.5)
    rate = {name: result.body(name).omega[:, 2].mean() for name in ("wheel", "idler", "upper roller 1")}
    assert rate["wheel"] == pytest.approx(1 / PITCH_RADIUS, rel=0.3)
    assert rate["idler"] == pytest.approx(1 / PITCH_RADIUS, rel=0.3)
    assert rate["upper roller 1"] > 2.0
    assert result.body("lower roller 1").omega[:, 2].mean() < -2.0


def test_a_track_stays_in_its_plane() -> None:
    result = run(0.2)
    assert np.abs(result.position[:, :, 2]).max() < 1e-12
    assert np.abs(result.omega[:, :, :2]).max() < 1e-9


def test_the_energy_of_a_track_is_the_better_known_with_shorter_steps() -> None:
    """What friction and contacts take is counted as work; contacts that begin within steps cost order."""
    errors = [np.abs(run(0.1, step).energy_error).max() for step in (2e-4, 1e-4)]
    assert errors[1] < errors[0] / 4
    assert errors[0] < 1e-4 * run(0.1).kinetic_energy[0]
