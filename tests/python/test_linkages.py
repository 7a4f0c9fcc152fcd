"""The linkages among the mechanisms against their geometry."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from linkwork.mechanisms import planar, six_bars
from linkwork.mechanisms.bennett import START, follower_angle, hinges
from linkwork.mechanisms.strandbeest_leg import leg_points


def point_of(model: lw.Model, result: lw.Result, body: str, point: Floats) -> Floats:
    """Where a point (3,), in space at the initial pose, of a body goes (k, 3)."""
    index = model.find(body).index
    start = model.compiled().q0.reshape(-1, 7)[index]
    arm = lw.rotation.matrix(start[3:]).T @ (point - start[:3])
    moved = result.body(body)
    out: Floats = moved.position + lw.rotation.matrix(moved.orientation) @ arm
    return out


# --- points from lengths ------------------------------------------------------------------------------------


@pytest.mark.parametrize("side", (1, -1))
def test_links_meet_at_their_lengths_on_the_side_that_is_asked_for(side: int) -> None:
    a, b = np.array([0.3, -0.2, 0.0]), np.array([1.0, 0.5, 0.0])
    point = planar.meet(a, b, 0.8, 0.6, side)
    assert [np.linalg.norm(point - a), np.linalg.norm(point - b)] == pytest.approx([0.8, 0.6], rel=1e-14)
    assert side * np.cross(b - a, point - a)[2] > 0.1


def test_links_that_are_too_short_are_refused() -> None:
    with pytest.raises(lw.ModelError, match=r"0\.3 m and 0\.6 m do not meet over a distance of 1 m"):
        planar.meet(np.zeros(3), np.array([1.0, 0.0, 0.0]), 0.3, 0.6)


def test_a_link_of_three_tubes_has_the_inertia_of_an_equilateral_triangle() -> None:
    """About the normal: 3 m (l^2 / 12 + r^2 / 2 + (l / (2 sqrt 3))^2) = m l^2 / 2 + 3 m r^2 / 2."""
    model, length, radius, mass = lw.Model(), 0.6, 0.02, 0.9
    corners = [planar.polar(length / np.sqrt(3), angle) for angle in (0, 2 * np.pi / 3, 4 * np.pi / 3)]
    planar.tube_link(model, "plate", corners, density=mass / length, radius=radius)
    (J,) = model.compiled().inertia
    assert J[2, 2] == pytest.approx(mass * length**2 / 2 + 1.5 * mass * radius**2, rel=1e-14)
    assert model.compiled().mass == pytest.approx([3 * mass], rel=1e-14)
    assert np.abs(J - np.diag(np.diag(J))).max() < 1e-15


# --- six-bars -----------------------------------------------------------------------------------------------

SIX_BARS = {"watt_six_bar": six_bars.watt_points, "stephenson_six_bar": six_bars.stephenson_points}


@pytest.mark.parametrize("mode", six_bars.MODES)
@pytest.mark.parametrize("name", SIX_BARS)
def test_a_six_bar_stays_in_its_assembly_mode(name: str, mode: int) -> None:
    """Through more than a turn of the crank its joints are where circles about the others meet."""
    model = lw.mechanisms.MECHANISMS[name].function(mode=mode)
    result = lw.simulate(model, t_end=0.8, step=1e-3, progress=False)
    start = SIX_BARS[name](six_bars.START, mode)
    places = {
        letter: point_of(model, result, body, start[letter])
        for letter, body in (("B", "crank"), ("C", "rocker"), ("E", "rod"), ("F", "output"))
    }
    angle = np.unwrap(np.arctan2(places["B"][:, 1], places["B"][:, 0]))
    assert angle[-1] - angle[0] > 2 * np.pi
    for k in range(0, len(result), 10):
        closed_form = SIX_BARS[name](angle[k], mode)
        for letter, place in places.items():
            assert np.abs(place[k] - closed_form[letter]).max() < 1e-8


@pytest.mark.parametrize("name", SIX_BARS)
def test_the_four_assembly_modes_of_a_six_bar_are_apart(name: str) -> None:
    ends = [SIX_BARS[name](six_bars.START, mode)["F"] for mode in six_bars.MODES]
    assert min(np.linalg.norm(a - b) for k, a in enumerate(ends) for b in ends[:k]) > 0.05


@pytest.mark.parametrize("name", SIX_BARS)
def test_a_six_bar_keeps_its_energy(name: str) -> None:
    result = lw.simulate(lw.mechanisms.MECHANISMS[name].function(), t_end=2.0, step=1e-3, progress=False)
    assert np.abs(result.energy_error).max() < 1e-8


# --- strandbeest --------------------------------------------------------------------------------------------


def foot_path() -> tuple[lw.Result, Floats]:
    """Of one turn of the crank."""
    model = lw.mechanisms.strandbeest_leg(speed=-2 * np.pi)
    result = lw.simulate(model, t_end=1.0, step=1e-3, progress=False)
    foot = leg_points(0.0)["foot"]
    return result, point_of(model, result, "lower triangle", foot)


def test_the_foot_of_a_strandbeest_is_where_its_lengths_put_it() -> None:
    result, path = foot_path()
    wanted = np.array([leg_points(-2 * np.pi * t)["foot"] for t in result.t])
    assert np.abs(path - wanted).max() < 1e-8
    assert np.abs(path[-1] - path[0]).max() < 1e-8


def test_kinematic_analysis_walks_a_strandbeest() -> None:
    times = np.linspace(0.0, 1.0, 101)
    model = lw.mechanisms.strandbeest_leg(speed=-2 * np.pi)
    path = point_of(model, lw.kinematics(model, times), "lower triangle", leg_points(0.0)["foot"])
    assert np.abs(path - [leg_points(-2 * np.pi * t)["foot"] for t in times]).max() < 1e-10


def test_a_strandbeest_takes_level_steps() -> None:
    """Half of the time within 2 cm of the ground, over more than 60 cm; on the way back it lifts 20 cm."""
    result, path = foot_path()
    height = path[:, 1] - path[:, 1].min()
    down = height < 0.02
    assert np.mean(down) > 0.5
    assert np.ptp(path[down, 0]) > 0.6
    assert 0.2 < height.max() < 0.25
    velocity = np.gradient(path[:, 0], result.t)
    assert velocity[down][20:-20].min() * velocity[down][20:-20].max() > 0  # one way on the ground


# --- Bennett ------------------------------------------------------------------------------------------------


def angle_about(axis: Floats, a: Floats, b: Floats) -> float:
    """From a to b, both perpendicular to the axis [rad]."""
    return float(np.arctan2(np.cross(a, b) @ axis, a @ b))


def test_bennett_closes_at_every_angle_of_its_crank() -> None:
    """Each link is as long as its opposite, along the common normal of the axes at its ends."""
    for crank_angle in np.linspace(-3, 3, 13):
        points, axes = hinges(crank_angle)
        along = np.roll(points, -1, axis=0) - points
        assert np.linalg.norm(along, axis=1) == pytest.approx([1.0, 0.5, 1.0, 0.5], rel=1e-14)
        assert np.abs(np.sum(along * axes, axis=1)).max() < 1e-14
        assert np.abs(np.sum(along * np.roll(axes, -1, axis=0), axis=1)).max() < 1e-14


def test_bennett_turns_as_its_closure_says() -> None:
    """Two turns of the crank under gravity: tan(t1 / 2) tan(t2 / 2) stays, the energy as well."""
    model = lw.mechanisms.bennett()
    result = lw.simulate(model, t_end=3.0, step=5e-4, progress=False)
    points, axes = hinges(START)
    pin, knee = (point_of(model, result, body, points[k]) for body, k in (("crank", 1), ("coupler", 2)))
    hinge = point_of(model, result, "crank", points[1] + axes[1]) - pin
    first = [angle_about(axes[0], points[0] - points[3], p - points[0]) for p in pin]
    second = [angle_about(z, p - points[0], k - p) for z, p, k in zip(hinge, pin, knee, strict=True)]
    expected = np.array([follower_angle(angle) for angle in first])
    assert np.abs(np.angle(np.exp(1j * (np.array(second) - expected)))).max() < 1e-7
    assert np.unwrap(first)[-1] - first[0] > 4 * np.pi
    assert np.abs(result.energy_error).max() < 1e-8
