"""Extremes and means of studies are those of the motion, not of the frames that were recorded."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from linkwork.studies.between_frames import Bends, Curve, bends_of
from numpy.testing import assert_array_equal
from scipy.integrate import quad

G, UP, ALONG = 9.81, 3.0, 1.0

#: By output: of the height z of a ball of 2 kg that is thrown, or of its speed, in one second.
Z = "body('b').position.z"
CLOSED: dict[str, Callable[[Floats, Floats], float]] = {
    f"{Z}.max": lambda z, v: UP**2 / (2 * G),
    f"{Z}.min": lambda z, v: UP - G / 2,
    f"{Z}.range": lambda z, v: UP**2 / (2 * G) - UP + G / 2,
    f"{Z}.abs_max": lambda z, v: G / 2 - UP,
    f"{Z}.mean": lambda z, v: UP / 2 - G / 6,
    f"{Z}.rms": lambda z, v: np.sqrt(UP**2 / 3 - UP * G / 4 + G**2 / 20),
    "position[:, 0, 2].max": lambda z, v: UP**2 / (2 * G),
    "body('b').velocity.min": lambda z, v: ALONG,
    "body('b').velocity.max": lambda z, v: np.hypot(ALONG, UP - G),
    "body('b').velocity.mean": lambda z, v: np.mean(v),
    "body('b').velocity.rms": lambda z, v: np.sqrt(ALONG**2 + UP**2 - UP * G + G**2 / 3),
    "kinetic_energy.min": lambda z, v: ALONG**2,
    "kinetic_energy.mean": lambda z, v: ALONG**2 + UP**2 - UP * G + G**2 / 3,
    "potential_energy.mean": lambda z, v: 2 * G * (UP / 2 - G / 6),
    "potential_energy.max": lambda z, v: UP**2,
}

TOLERANCE = {"body('b').velocity.mean": 1e-5}  # of a magnitude that turns sharply


def thrown(gravity: float = G) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -gravity))
    model.body("b", mass=2.0, inertia=(0.1, 0.2, 0.3), velocity=(ALONG, 0, UP))
    return model


@pytest.mark.parametrize(
    "steps", [{"step": 0.25}, {"step": 0.3}, {"step": 1e-3, "record_every": 100}, {"rtol": 1e-8}]
)
def test_a_thrown_ball_has_its_extremes_and_means_however_far_apart_frames_are(steps: dict[str, Any]) -> None:
    run: dict[str, Any] = {**steps, "progress": False}
    study = lw.sweep(thrown, {"gravity": [G]}, list(CLOSED), t_end=1.0, processes=1, **run)
    many = lw.simulate_many(thrown, {"gravity": [G]}, 1.0, outputs=list(CLOSED), **run)
    t = (np.arange(200_000) + 0.5) / 200_000
    for name, closed in CLOSED.items():
        exact = closed(UP * t - G * t**2 / 2, np.hypot(ALONG, UP - G * t))
        assert study.outputs[name][0] == pytest.approx(
            exact, rel=3e-6 if "velocity.mean" in name else 1e-9
        ), name
        assert_array_equal(many.outputs[name], study.outputs[name])


@pytest.mark.parametrize(
    "up,t_end,frames",
    [
        (G * 0.487, 0.52, {"step": 0.25}),
        (G * 0.973, 1.05, {"step": 0.5}),
        (UP, 0.7, {"rtol": 1e-6, "record_every": 5, "times": [0.3, 0.7]}),
    ],
)
def test_the_summit_is_found_beside_a_short_piece(up: float, t_end: float, frames: dict[str, Any]) -> None:
    model = lw.Model(gravity=(0, 0, -G))
    model.body("b", mass=2.0, inertia=(0.1, 0.2, 0.3), velocity=(ALONG, 0, up))
    names = [f"{Z}.max", "body('b').velocity.min", "kinetic_energy.min"]
    names += [Z] if "times" in frames else []
    found = lw.sweep(model, {"b.mass": [2.0]}, names, t_end=t_end, processes=1, progress=False, **frames)
    values = [found.outputs[name][0] for name in names[:3]]
    assert values == pytest.approx([up**2 / (2 * G), ALONG, ALONG**2], rel=1e-12)


@pytest.mark.parametrize("step", [0.05, 0.01])
def test_the_closest_of_two_passes_is_told(step: float) -> None:
    g, through, beside, apart = 10.0, 0.203125, 1.80625, 0.02  # it goes through the origin at the first time
    up, along = (through + beside) * g / 2, apart / (beside - through)
    start = (-along * through, 0.0, g * through**2 / 2 - up * through)
    model = lw.Model(gravity=(0, 0, -g))
    model.body("b", mass=1.0, inertia=(1, 1, 1), position=start, velocity=(along, 0, up))
    name = "body('b').position.min"
    found = lw.sweep(model, {"b.mass": [1.0]}, name, t_end=2.0, step=step, processes=1, progress=False)
    assert found.outputs[name][0] < 1e-9


def test_extremes_of_pieces_of_any_length_are_those_of_many_points_on_them() -> None:
    random = np.random.default_rng(1)
    t = np.cumsum(10.0 ** random.uniform(-2, 0, 30))
    values = random.normal(size=(30, 4, 3))
    rates = random.normal(size=(30, 4, 3)) * 3
    bends = bends_of(t, values, rates)
    bends = Bends(bends.start, bends.end, np.ones_like(bends.known))
    rise = np.diff(values, axis=0)
    points = [
        values[:-1] + x * rise + x * (1 - x) * ((1 - x) * bends.start - x * bends.end)
        for x in np.linspace(0.0, 1.0, 2001)
    ]
    on_them = np.concatenate(points)
    for sizes, seen in ((False, on_them), (True, np.linalg.norm(on_them, axis=-1))):
        curve = Curve(t, values, bends, sizes)
        for what in (np.asarray, np.negative, np.abs):
            over = curve.largest(what) - what(seen).max(axis=0)
            assert over.min() >= -1e-13
            assert over.max() < 1e-4


def test_a_joint_that_swings_is_widest_where_its_energy_says() -> None:
    model = lw.Model()
    model.body("rod", mass=1.0, inertia=(1e-3, 1 / 12, 1 / 12), position=(0.5, 0, 0))
    model.revolute(model.ground, "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    names = ["coordinate('pin').value.max", "omega[:, 0, 1].abs_max"]
    found = lw.sweep(
        model, {"rod.mass": [1.0]}, names, t_end=2.0, step=2e-3, record_every=25, processes=1
    ).outputs
    assert found[names[0]][0] == pytest.approx(np.pi, rel=1e-6)  # let go when level, it comes to be level
    assert found[names[1]][0] == pytest.approx(np.sqrt(3 * G), rel=1e-5)


@pytest.mark.parametrize("tilt", [0.0, 0.1, 0.3, 0.7])
def test_a_rod_on_a_tilted_hinge_stands_still_where_it_turns_back(tilt: float) -> None:
    R = lw.rotation.matrix(lw.rotation.about((1, 0, 0), tilt))
    down, axis = R @ (0.0, 0.0, -1.0), R @ (0.0, 1.0, 0.0)  # one component of omega is rounding
    turns = {"velocity": np.cross(4.0 * axis, 0.5 * down), "omega": (0.0, 4.0, 0.0)}
    pose = {"position": 0.5 * down, "orientation": lw.rotation.from_axes(x=down, y=axis)}
    model = lw.Model()
    rod = model.body("rod", mass=1.0, inertia=(1e-3, 1 / 12, 1 / 12), **pose, **turns)
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=axis, name="pin")
    names = ["body('rod').omega.min", "body('rod').velocity.min", "body('rod').omega.max"]
    found = lw.sweep(model, {"rod.mass": [1.0]}, names, t_end=1.7, step=2e-2, processes=1, progress=False)
    least, slowest, most = (found.outputs[name][0] for name in names)
    assert least < 1e-7
    assert slowest < 1e-3
    assert most == pytest.approx(4.0, rel=1e-9)


@pytest.mark.parametrize("count", [9, 18, 36])
def test_between_frames_the_error_is_of_fourth_order(count: int) -> None:
    t = np.linspace(0.0, 2.0, count + 1)
    curve = Curve(t, np.sin(t), bends_of(t, np.sin(t), np.cos(t)))
    bound = (2.0 / count) ** 4 / 384  # of Hermite's cubics for the sine
    assert abs(curve.mean() - (1 - np.cos(2.0)) / 2.0) < bound
    assert abs(curve.largest() - 1.0) < bound


def test_what_rates_do_not_tell_is_straight() -> None:
    """A ball that bounces every second, recorded after impacts: never below the ground, nor at rest there."""
    t = np.linspace(0.0, 2.0, 9)
    within = t % 1.0
    z, v = 5.0 * within * (1 - within), 5.0 - 10.0 * within
    height = Curve(t, z, bends_of(t, z, v))
    assert -height.largest(np.negative) == 0.0 and height.largest() == 1.25
    vectors = np.zeros((9, 3))
    vectors[:, 0], vectors[:, 2] = 1.0, v
    rates = np.zeros((9, 3))
    rates[:, 2] = -10.0
    speed = Curve(t, vectors, bends_of(t, vectors, rates), sizes=True)
    assert -speed.largest(np.negative) == pytest.approx(1.0, rel=1e-12)
    assert speed.largest() == np.sqrt(26.0)
    jump = Curve(t[:2], vectors[3:5], bends_of(t[:2], vectors[3:5], rates[3:5]), sizes=True)
    ends = np.linalg.norm(vectors[3:5], axis=1)
    assert -jump.largest(np.negative) == ends.min() and jump.mean() == pytest.approx(ends.mean(), rel=1e-14)


def test_what_has_no_rate_is_largest_at_a_frame() -> None:
    model = thrown()
    model.spring_damper(model.ground, "b", at=((0, 0, 1), (0, 0, 0)), stiffness=9.0, damping=0.0)
    names = ["potential_energy.max", "body('b').acceleration.max", "energy.min"]
    study = lw.sweep(model, {"b.mass": [2.0]}, names, t_end=0.5, step=0.05, processes=1)
    result = study.simulate(0)
    assert study.outputs[names[0]][0] == result.potential_energy.max()
    assert study.outputs[names[1]][0] == np.linalg.norm(result.body("b").acceleration, axis=1).max()
    assert study.outputs[names[2]][0] == result.energy.min()


@pytest.mark.parametrize("apart", [0.5, 1.5, 3.3, 11.5])
def test_frames_too_far_apart_for_an_oscillation_give_no_more_than_they_have(apart: float) -> None:
    """sin t at frames so many periods apart: velocities look as if it went far between."""
    t = 2 * np.pi * apart * np.arange(60)
    bends = bends_of(t, np.sin(t), np.cos(t), -np.sin(t))
    assert Curve(t, np.sin(t), bends).largest() <= 1.0


@pytest.mark.parametrize("every", [1, 100])
def test_a_ball_is_fastest_just_before_it_bounces(every: int) -> None:
    back, struck = 0.8, np.sqrt(2 / G)  # dropped from 1 m, in one second

    def strike(t: float, state: lw.State) -> None:
        state.body("b").velocity = state.body("b").velocity * (1, 1, -back)

    bounce = lw.Event(lambda t, state: state.body("b").position[2], "bounce", direction=-1, change=strike)
    model = lw.Model(gravity=(0, 0, -G))
    model.body("b", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(0, 0, 1))
    after = 1 - struck
    end = back * G * struck * after - G * after**2 / 2
    fallen, risen = struck - G * struck**3 / 6, back * G * struck * after**2 / 2 - G * after**3 / 6
    exact = {
        "body('b').velocity.z.min": -G * struck,
        "body('b').velocity.z.max": back * G * struck,
        "body('b').velocity.max": G * struck,
        "body('b').velocity.z.mean": end - 1,
        f"{Z}.min": 0.0,
        f"{Z}.mean": fallen + risen,
        "kinetic_energy.max": 2 * G,
        "potential_energy.range": 2 * G,
    }
    run: dict[str, Any] = {"rtol": 1e-9, "events": [bounce], "record_every": every, "progress": False}
    found = lw.sweep(model, {"b.mass": [2.0]}, list(exact), t_end=1.0, processes=1, **run).outputs
    for name, value in exact.items():
        assert found[name][0] == pytest.approx(value, rel=1e-7, abs=1e-7), name


@pytest.mark.parametrize("in_lanes", [True, False])
@pytest.mark.parametrize("frames", [{}, {"record_every": 1}, {"record_every": 100}])
def test_a_body_is_fastest_just_before_its_driver_stops_it(frames: dict[str, int], in_lanes: bool) -> None:
    """It is driven with v = 10 t up to 0.2 s, where the driver stops."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("b", mass=1.0, inertia=(0.1, 0.2, 0.3))
    model.translational("ground", body, at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    model.drive("rail", velocity=lw.functions.piecewise_polynomial([0, 0.2, 1], [[0, 10], [0, 0]]))
    model.spring_damper("ground", body, at=((-1, 0, 0), (0, 0, 0)), stiffness=30.0, name="spring")
    exact = {
        "body('b').velocity.x.max": 2.0,
        "body('b').velocity.x.mean": 0.5,
        "body('b').velocity.abs_max": 2.0,
        "body('b').position.x.mean": (0.01 / 0.75 + 0.04) / 0.4,
        "coordinate('rail').rate.max": 2.0,
        "coordinate('rail').value.mean": (0.01 / 0.75 + 0.04) / 0.4,
        "kinetic_energy.max": 2.0,
        "kinetic_energy.mean": 1 / 3,
        "energy.max": 2.0 + 15 * 0.2**2,
        "work.max": 2.0 + 15 * 0.2**2,
    }
    run: dict[str, Any] = {"rtol": 1e-8, "progress": False, **frames}
    if not in_lanes:
        run["deterministic"] = False
    found = lw.sweep(model, {"b.mass": [1.0]}, list(exact), t_end=0.4, processes=1, **run)
    assert found.manifest["lanes"] is in_lanes
    for name, value in exact.items():
        assert found.outputs[name][0] == pytest.approx(value, rel=1e-6), name


@pytest.mark.parametrize("frames", [{}, {"record_every": 1}, {"record_every": 1000}])
def test_a_blow_is_seen_beside_an_event_that_changes_nothing(frames: dict[str, int]) -> None:
    """A driver shifts a spring and an inerter by v = 1 + t up to 0.8 s, and with -0.5 m/s then."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=0.5, inertia=(0.02, 0.02, 0.02), velocity=(0, 0, 1))
    at: dict[str, Any] = {"at": (0, 0, 0), "axis": (0, 0, 1)}
    model.translational("ground", "b", **at, name="rail")
    pieces = lw.functions.piecewise_polynomial([0, 0.8, 9], [[1.0, 1.0], [-0.5, 0.0]])
    model.drive("rail", velocity=pieces)
    model.translational_inerter("ground", "b", **at, inertance=1.5)
    model.translational_spring_damper("ground", "b", **at, stiffness=100.0)
    fast, stored = 0.5 * 2.0 * 1.8**2, 50 * (0.8 + 0.32) ** 2
    exact = {"kinetic_energy.max": fast, "energy.max": fast + stored, "work.max": fast + stored - 1.0}
    events = [lw.Event(lambda t, state, when=when: t - when, f"{when} s") for when in (0.3, 0.8, 1.2)]
    run: dict[str, Any] = {"t_end": 1.5, "rtol": 1e-9, "processes": 1, **frames}
    found = lw.sweep(model, {"b.mass": [0.5]}, list(exact), events=events, **run).outputs
    for name, value in exact.items():
        assert found[name][0] == pytest.approx(value, rel=1e-7), name


@pytest.mark.parametrize("every", [1, 1000])
def test_energies_and_work_before_an_impact_are_those_of_what_stores_them(every: int) -> None:
    """1 kg with 1 kg of inertance falls 1 m under twice its weight, to rebound with 0.3 of its speed."""
    model = lw.Model(gravity=(0, 0, -10.0))
    body = model.body("b", mass=1.0, inertia=(0.02, 0.02, 0.02))
    model.translational("ground", body, at=(0, 0, 0), axis=(0, 0, 1))
    model.translational_inerter("ground", body, at=(0, 0, 0), axis=(0, 0, 1), inertance=1.0)
    model.force(body, force=(0, 0, -10.0))

    def rebound(t: float, state: lw.State) -> None:
        state.body("b").velocity = -0.3 * state.body("b").velocity

    floor = lw.Event(lambda t, state: state.body("b").position[2] + 1.0, direction=-1, change=rebound)
    exact = {"kinetic_energy.max": 20.0, "work.max": 10.0, "energy.max": 10.0}
    run: dict[str, Any] = {"t_end": 0.5, "rtol": 1e-9, "record_every": every, "processes": 1}
    found = lw.sweep(model, {"b.mass": [1.0]}, list(exact), events=floor, **run).outputs
    for name, value in exact.items():
        assert found[name][0] == pytest.approx(value, rel=1e-7), name


@pytest.mark.parametrize("how", [{"step": 1.0}, {"step": 0.3}, {"rtol": 1e-9, "record_every": 1}])
@pytest.mark.parametrize("drift", [0.0, 1e-3, 0.3])
def test_means_of_magnitudes_are_exact_where_the_vector_passes_near_zero(how: Any, drift: float) -> None:
    """A ball that is thrown up by 4 m/s."""
    up, g = 4.0, 9.81
    model = lw.Model(gravity=(0, 0, -g))
    model.body("ball", mass=1.0, inertia=(0.1,) * 3, velocity=(drift, 0, up))
    names = ["velocity[:,0].mean", "position[:,0].mean"]
    study = lw.sweep(model, {"ball.mass": [1.0]}, names, t_end=1.0, processes=1, **how)
    turn = [up / g, 2 * up / g]
    speed = quad(lambda t: np.hypot(drift, up - g * t), 0, 1, points=turn, epsabs=1e-13)[0]
    way = quad(lambda t: np.hypot(drift * t, up * t - g * t * t / 2), 0, 1, points=turn, epsabs=1e-13)[0]
    assert study.outputs[names[0]][0] == pytest.approx(speed, rel=1e-9)
    assert study.outputs[names[1]][0] == pytest.approx(way, rel=1e-7)


@pytest.mark.parametrize("jump", [0.3, 0.337, 0.96])
@pytest.mark.parametrize("frames", [{"step": 0.1}, {"step": 0.05, "record_every": 2}, {"rtol": 1e-8}])
def test_means_go_up_to_a_jump_and_begin_anew_there(frames: dict[str, Any], jump: float) -> None:
    """A force is t before the jump and 5 - t after it: what is straight between jumps has exact means."""
    law = lw.functions.piecewise_polynomial([0, jump, 2], [[0, 1], [5 - jump, -1]])
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=1.0, inertia=(1, 1, 1))
    model.translational("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    model.force("b", force=(law, law, 0))
    mean = jump**2 / 2 + 5 * (1 - jump) - (1 - jump**2) / 2
    square = jump**3 / 3 + ((5 - jump) ** 3 - 4.0**3) / 3
    exact = {
        "body('b').acceleration.x.mean": mean,
        "body('b').acceleration.rms": np.sqrt(square),
        "reaction('rail').force.mean": mean,
        "reaction('rail').force.rms": np.sqrt(square),
    }
    run: dict[str, Any] = {**frames, "progress": False, "on_inaccurate": "pass"}
    found = lw.sweep(model, {"b.mass": [1.0]}, list(exact), t_end=1.0, processes=1, **run)
    many = lw.simulate_many(model, {"b.mass": [1.0]}, 1.0, outputs=list(exact), **run)
    for name, value in exact.items():
        close = 5e-3 if jump == 0.96 else 1e-12  # one frame after it tells no slope
        assert found.outputs[name][0] == pytest.approx(value, rel=close), name
        assert_array_equal(many.outputs[name], found.outputs[name])
