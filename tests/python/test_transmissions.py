"""Joints against their closed forms: what turns by how much, what slides, what rolls."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest

G = 9.81


def wheel(model: lw.Model, name: str, position: tuple[float, ...] = (0, 0, 0), **state: object) -> lw.Body:
    return model.body(name, mass=2.0, inertia=(0.3, 0.3, 0.4), position=position, **state)


def turns(result: lw.Result, body: int, axis: int = 2) -> np.ndarray:
    """Of a body that turns about one fixed axis: the angle [rad] at each frame, from its first."""
    half = np.arctan2(result.q[:, body, 4 + axis], result.q[:, body, 3])
    return np.unwrap(2 * half, period=2 * np.pi)


def run(model: lw.Model, t_end: float, step: float = 1e-3, **options: object) -> lw.Result:
    return lw.simulate(model, t_end, step, progress=False, **options)


# --- screws, gears, racks -----------------------------------------------------------------------------------


@pytest.mark.parametrize("pitch", (2.0, -0.4))
def test_a_nut_falls_down_its_thread(pitch: float) -> None:
    """m z_ddot + J (2 pi / p)^2 z_ddot = -m g, over many turns."""
    model = lw.Model()
    nut = wheel(model, "nut")
    model.screw(model.ground, nut, at=(0, 0, 0), axis=(0, 0, 1), pitch=pitch)
    result = run(model, 3.0)
    acceleration = -G / (1 + 0.4 * (2 * np.pi / pitch) ** 2 / 2.0)
    assert np.abs(result.q[:, 0, 2] - acceleration * result.t**2 / 2).max() < 1e-8
    assert np.abs(turns(result, 0) - 2 * np.pi / pitch * result.q[:, 0, 2]).max() < 1e-9


def pair_of_gears(teeth_a: int, teeth_b: int, distance: float) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    first = wheel(model, "first", (0.1, 0.2, 0), omega=(0, 0, 3.0))
    second = wheel(model, "second", (0.1 + distance, 0.2, 0.5), omega=(0, 0, -3.0 * teeth_a / teeth_b))
    for body, x in ((first, 0.1), (second, 0.1 + distance)):
        model.revolute(model.ground, body, at=(x, 0.2, 0), axis=(0, 0, 1))
    model.gear(
        first, second, at=((0.1, 0.2, 0), (0.1 + distance, 0.2, 0.5)), axis=(0, 0, 1), teeth_a=teeth_a,
        teeth_b=teeth_b, name="mesh",
    )  # fmt: skip
    model.force(first, torque=(0, 0, 1.2))
    return model


@pytest.mark.parametrize("teeth", ((20, 31), (20, -53), (17, 17)))
def test_gears_turn_as_their_teeth_say_over_many_turns(teeth: tuple[int, int]) -> None:
    """As one inertia 0.4 (1 + (z_a/z_b)^2) with the torque on the first."""
    result = run(pair_of_gears(*teeth, distance=0.6), 4.0, 2e-3)
    ratio = teeth[0] / teeth[1]
    acceleration = 1.2 / (0.4 * (1 + ratio**2))
    assert np.abs(turns(result, 0) - (3.0 * result.t + acceleration * result.t**2 / 2)).max() < 1e-8
    assert np.abs(turns(result, 1) + ratio * turns(result, 0)).max() < 1e-9
    assert turns(result, 0)[-1] > 4 * np.pi


def test_a_planetary_gear_obeys_willis() -> None:
    """(w_ring - w_carrier) / (w_sun - w_carrier) = -z_sun / z_ring, the ring held, the carrier in motion."""
    sun_teeth, planet_teeth, ring_teeth = 24, 18, 60
    model = lw.Model(gravity=(0, 0, 0))
    sun, carrier = wheel(model, "sun"), wheel(model, "carrier")
    planet = wheel(model, "planet", (1.0, 0, 0))
    model.revolute(model.ground, sun, at=(0, 0, 0), axis=(0, 0, 1))
    model.revolute(model.ground, carrier, at=(0, 0, 0), axis=(0, 0, 1))
    model.revolute(carrier, planet, at=(1, 0, 0), axis=(0, 0, 1))
    both = {"at": ((0, 0, 0), (1, 0, 0)), "axis": (0, 0, 1), "teeth_b": planet_teeth}
    model.gear(sun, planet, teeth_a=sun_teeth, **both)
    model.gear(model.ground, planet, teeth_a=-ring_teeth, **both)
    model.angle_driver(
        model.ground, sun, at=(0, 0, 0), axis=(0, 0, 1), angle=lw.functions.polynomial(0, 0, 1.5)
    )
    result = run(model, 4.0, 2e-3)
    sun_turns, carrier_turns = turns(result, 0), turns(result, 1)
    assert np.abs(sun_turns - 1.5 * result.t**2).max() < 1e-9
    assert np.abs(carrier_turns - sun_turns * sun_teeth / (sun_teeth + ring_teeth)).max() < 1e-9


@pytest.mark.parametrize("radius", (0.25, -0.25))
def test_a_pinion_rolls_down_its_rack(radius: float) -> None:
    """Down a slope of 30 degrees: s_ddot = g sin(30) / (1 + J / (m r^2)), and it turns by -s / r."""
    model = lw.Model(gravity=(G * 0.5, -G * np.sqrt(0.75), 0))
    pinion = wheel(model, "pinion")
    model.planar(model.ground, pinion, at=(0, 0, 0), axis=(0, 0, 1))
    model.point_on_plane(model.ground, pinion, at=(0, 0, 0), axis=(0, 1, 0))
    model.rack_pinion(model.ground, pinion, at=(0, 0, 0), axes=((1, 0, 0), (0, 0, 1)), radius=radius)
    result = run(model, 2.0)
    acceleration = G * 0.5 / (1 + 0.4 / (2.0 * radius**2))
    assert np.abs(result.q[:, 0, 0] - acceleration * result.t**2 / 2).max() < 1e-10
    assert np.abs(turns(result, 0) + result.q[:, 0, 0] / radius).max() < 1e-9


# --- shafts -------------------------------------------------------------------------------------------------


def bent_shafts(kind: str, bend: float) -> lw.Result:
    """A shaft along z, turned by 2 rad/s, drives another one at an angle."""
    axis = np.array([0, np.sin(bend), np.cos(bend)])
    model = lw.Model(gravity=(0, 0, 0))
    first = wheel(model, "first", (0, 0, -1))
    second = wheel(model, "second", tuple(axis), orientation=lw.rotation.about((1, 0, 0), -bend))
    model.cylindrical(model.ground, second, at=axis, axis=axis)
    model.revolute(model.ground, first, at=(0, 0, -1), axis=(0, 0, 1))
    model.angle_driver(
        model.ground, first, at=(0, 0, -1), axis=(0, 0, 1), angle=lw.functions.polynomial(0, 2.0)
    )
    if kind == "constant_velocity":
        model.constant_velocity(first, second, at=(0, 0, 0), axes=((0, 0, 1), axis))
    else:  # the cross lies along x on the driving shaft
        model.universal(first, second, at=(0, 0, 0), axes=((1, 0, 0), np.cross(axis, (1, 0, 0))))
    return run(lw.assemble(model).model, 4.0)


def test_a_homokinetic_joint_turns_both_shafts_alike() -> None:
    result = bent_shafts("constant_velocity", 0.6)
    assert np.abs(result.v[:, 1, 5] - 2.0).max() < 1e-9


def test_a_cardan_joint_turns_the_second_shaft_unevenly() -> None:
    """w_2 / w_1 = cos b / (1 - sin(b)^2 sin(phi)^2), the first axis normal to both shafts at phi = 0."""
    bend = 0.6
    result = bent_shafts("universal", bend)
    sine = np.sin(bend) * np.sin(2.0 * result.t)
    assert np.abs(result.v[:, 1, 5] - 2.0 * np.cos(bend) / (1 - sine**2)).max() < 1e-7


# --- massless links -----------------------------------------------------------------------------------------


def pendulum_on(kind: str, **place: object) -> lw.Result:
    model = lw.Model()
    ball = model.body("ball", mass=1.5, inertia=(0.1, 0.1, 0.1), position=(0.8, 0, 0))
    getattr(model, kind)(model.ground, ball, **place)
    return run(model, 2.0)


def test_massless_links_are_pendulums_of_a_point() -> None:
    """A ball that starts at rest in the plane of a swing does not see what else its link could do."""
    at = {"at": ((0, 0.3, 0), (0.8, 0, 0))}
    rod = pendulum_on("distance", at=((0, 0, 0), (0.8, 0, 0)))
    hinged = pendulum_on("revolute_spherical", **at, axis=(0, 1, 0))
    both = pendulum_on("revolute_revolute", **at, axis=(0, 1, 0))
    assert np.abs(hinged.q[:, 0, :3] - rod.q[:, 0, :3]).max() < 1e-9
    assert np.abs(both.q[:, 0, :3] - rod.q[:, 0, :3]).max() < 1e-9
    cardan = pendulum_on("universal_spherical", at=((0, 0, 0), (0.8, 0, 0)))
    assert np.array_equal(cardan.q, rod.q)


def test_a_pin_in_a_slot_is_an_inverted_slider_crank() -> None:
    """Crank r about the origin, slot about (-d, 0): tan(theta) = r sin(phi) / (d + r cos(phi))."""
    r, d, rate = 0.3, 1.0, 5.0
    model = lw.Model(gravity=(0, 0, 0))
    crank = wheel(model, "crank")
    lever = wheel(model, "lever", (-d, 0, 0))
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=(0, 0, 1))
    model.revolute(model.ground, lever, at=(-d, 0, 0), axis=(0, 0, 1))
    model.revolute_translational(crank, lever, at=(r, 0, 0), axes=((0, 0, 1), (1, 0, 0)))
    model.angle_driver(
        model.ground, crank, at=(0, 0, 0), axis=(0, 0, 1), angle=lw.functions.polynomial(0, rate)
    )
    result = run(lw.assemble(model).model, 3.0)
    phi = rate * result.t
    theta = np.arctan2(r * np.sin(phi), d + r * np.cos(phi))
    assert np.abs(turns(result, 1) - theta).max() < 1e-9


# --- drivers ------------------------------------------------------------------------------------------------


def test_a_driven_pendulum_needs_the_torque_of_its_motion() -> None:
    """theta = 0.5 sin 3t about the vertical downward: torque J theta_ddot + m g l sin(theta)."""
    model = lw.Model()
    rod = model.body("rod", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(0, 0, -0.7))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(1, 0, 0))
    motion = lw.functions.harmonic(0.5, 3.0)
    model.angle_driver(model.ground, rod, at=(0, 0, 0), axis=(1, 0, 0), angle=motion, name="motor")
    result = run(lw.assemble(model).model, 3.0)
    theta = 0.5 * np.sin(3 * result.t)
    torque = -(0.1 + 2.0 * 0.49) * 9 * theta + 2.0 * G * 0.7 * np.sin(theta)
    assert np.abs(turns(result, 0, axis=0) - theta).max() < 1e-9
    assert np.abs(result.reaction("motor").torque[:, 0] - torque).max() < 1e-6


def test_a_driven_slider_carries_its_load() -> None:
    model = lw.Model()
    block = wheel(model, "block")
    model.translational(model.ground, block, at=(0, 0, 0), axis=(0, 0, 1))
    motion = lw.functions.polynomial(0, 0, 0.2, 0.4)
    model.displacement_driver(
        model.ground, block, at=(0, 0, 0), axis=(0, 0, 1), displacement=motion, name="piston"
    )
    result = run(model, 2.0)
    t = result.t
    assert np.abs(result.q[:, 0, 2] - (0.2 * t**2 + 0.4 * t**3)).max() < 1e-9
    assert np.abs(result.reaction("piston").force[:, 2] - 2.0 * (G + 0.4 + 2.4 * t)).max() < 1e-6


# --- rolling and skating ------------------------------------------------------------------------------------


def disc(spin: float, tilt: float, yaw: float) -> tuple[lw.Model, float]:
    """A thin disc of radius 0.5 on the ground; its axis is z of the body."""
    radius, mass = 0.5, 1.0
    turn = lw.rotation.about((1, 0, 0), np.pi / 2 - tilt)
    A = lw.rotation.matrix(turn)
    down = A[2, 2] * A[:, 2] - np.array([0, 0, 1.0])
    center = -radius * down / np.linalg.norm(down)
    omega = A.T @ np.array([0, 0, yaw]) + np.array([0, 0, spin])
    velocity = np.cross(A @ omega, center)  # the point of contact is the origin, at rest
    model = lw.Model()
    body = model.body(
        "disc", mass=mass, inertia=(mass * radius**2 / 4,) * 2 + (mass * radius**2 / 2,), position=center,
        orientation=turn, velocity=velocity, omega=omega,
    )  # fmt: skip
    model.rolling_disc(
        model.ground, body, at=((0, 0, 0), center), axes=((0, 0, 1), A[:, 2]), radius=radius, name="contact"
    )
    return model, radius


def contact_velocity(result: lw.Result, radius: float) -> np.ndarray:
    A = lw.rotation.matrix(result.q[:, 0, 3:])
    axis, up = A[:, :, 2], np.array([0, 0, 1.0])
    down = axis[:, 2:] * axis - up
    arm = radius * down / np.linalg.norm(down, axis=1, keepdims=True)
    spin = np.einsum("kij,kj->ki", A, result.v[:, 0, 3:])
    return result.v[:, 0, :3] + np.cross(spin, arm)


def test_a_disc_rolls_for_ten_seconds_without_slip_or_loss() -> None:
    model, radius = disc(spin=4.0, tilt=0.4, yaw=0.6)
    result = run(model, 10.0)
    assert np.abs(result.energy - result.energy[0]).max() < 1e-8
    assert np.abs(contact_velocity(result, radius)).max() < 1e-10
    assert result.violation[:, 0].max() < 1e-10


def test_a_disc_keeps_rolling_in_a_circle() -> None:
    """Steady rolling, tilted by a from the vertical, spin w, yaw O; moments 1/4 and 1/2 of m R^2.

    O^2 sin(a) cos(a) / 4 + 3/2 O (w + O sin(a)) cos(a) = -(g / R) sin(a) as signs are here.
    """
    tilt, yaw = 0.3, 1.5
    s, c = np.sin(tilt), np.cos(tilt)
    spin = -((G / 0.5 * s - 0.25 * yaw**2 * s * c) / (1.5 * yaw * c)) - yaw * s
    model, radius = disc(spin=spin, tilt=tilt, yaw=yaw)
    result = run(model, 2 * np.pi / yaw)
    axis = lw.rotation.matrix(result.q[:, 0, 3:])[:, :, 2]
    assert np.abs(axis[:, 2] - axis[0, 2]).max() < 1e-8
    assert np.abs(result.q[-1] - result.q[0])[0, :3].max() < 1e-6


def test_a_skate_on_a_slope_goes_in_cycloids() -> None:
    """x = c sin(wt)^2 down the slope, y = c (wt - sin(2wt) / 2) across it, c = g sin(a) / (2 w^2)."""
    slope, w = 0.3, 2.0
    model = lw.Model(gravity=(G * np.sin(slope), 0, -G * np.cos(slope)))
    skate = wheel(model, "skate", omega=(0, 0, w))
    model.planar(model.ground, skate, at=(0, 0, 0), axis=(0, 0, 1))
    model.knife_edge(model.ground, skate, at=(0, 0, 0), axis=(0, 1, 0))
    result = run(model, 5.0)
    t, scale = result.t, G * np.sin(slope) / (2 * w**2)
    assert np.abs(result.q[:, 0, 0] - scale * np.sin(w * t) ** 2).max() < 1e-9
    assert np.abs(result.q[:, 0, 1] - scale * (w * t - np.sin(2 * w * t) / 2)).max() < 1e-9


# --- what is refused ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "words"),
    (
        ({"teeth_a": 20.5, "teeth_b": 30}, "whole number"),
        ({"teeth_a": 20, "teeth_b": 0}, "zero"),
        ({"teeth_a": lw.functions.polynomial(20, 1), "teeth_b": 30}, "function of time"),
        ({"teeth_a": 20}, "teeth_b"),
    ),
)
def test_teeth_are_whole_numbers(arguments: dict[str, object], words: str) -> None:
    model = lw.Model()
    bodies = wheel(model, "first"), wheel(model, "second", (1, 0, 0))
    with pytest.raises((lw.ModelError, TypeError), match=words):
        model.gear(*bodies, at=((0, 0, 0), (1, 0, 0)), axis=(0, 0, 1), **arguments)


@pytest.mark.parametrize(
    ("teeth_a", "teeth_b", "words"),
    (
        (-20, -40, "two ring gears"),
        (20, -20, "more teeth"),
        (-20, 30, "more teeth"),
        (-20, -20, "two ring gears"),
    ),
)
def test_wheels_that_do_not_mesh_are_refused(teeth_a: int, teeth_b: int, words: str) -> None:
    model = lw.Model()
    bodies = wheel(model, "first"), wheel(model, "second", (1, 0, 0))
    with pytest.raises(lw.ModelError, match=f"teeth_a = {teeth_a}, teeth_b = {teeth_b}: .*{words}"):
        model.gear(*bodies, at=((0, 0, 0), (1, 0, 0)), axis=(0, 0, 1), teeth_a=teeth_a, teeth_b=teeth_b)


def test_centers_on_one_axis_are_refused() -> None:
    model = lw.Model()
    bodies = wheel(model, "first"), wheel(model, "second", (0, 0, 1))
    with pytest.raises(lw.ModelError, match="not apart"):
        model.gear(*bodies, at=((0, 0, 0), (0, 0, 1)), axis=(0, 0, 1), teeth_a=9, teeth_b=9)
