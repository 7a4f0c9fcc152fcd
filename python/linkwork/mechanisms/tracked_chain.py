"""A track of many shoes around a driving wheel and an idler."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from linkwork import Model, rotation
from linkwork.arrays import Floats
from linkwork.errors import ModelError
from linkwork.functions import polynomial
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.modeling.contact import contact_hysteresis
from linkwork.modeling.handles import Body, Range
from linkwork.modeling.shapes import Box, Cylinder

AXIS = np.array([0.0, 0.0, 1.0])  # of all pins, wheels and rollers

PITCH, SHOE = 0.154, 18.02  # of a shoe [m], [kg]
SHOE_INERTIA = (0.22, 0.25, 0.04)  # along the track, across it, along the pins (z) [kg m2]
PIN = 0.015  # radius of what presses on the wheels [m]
WIDTH = 0.38  # of the shoes, as they are drawn [m]

ROUND = 20  # shoes on a full turn of a wheel
PITCH_RADIUS = PITCH / 2 / np.sin(np.pi / ROUND)
WHEEL_RADIUS = PITCH_RADIUS - PIN
WHEEL, WHEEL_INERTIA = 250.0, (20.0, 20.0, 35.0)  # [kg], [kg m2]
ROLLER, ROLLER_RADIUS, ROLLER_INERTIA = 25.0, 0.1, (0.1, 0.1, 0.125)
ROLLER_SPACING = 2.5  # at most [m]
SLIDE = 100.0  # the bearing of the idler [kg]

TENSION = 3.0e4  # of each run [N]
TENSIONER, TENSIONER_DAMPING = 4e5, 2e4  # on the slide [N/m], [N s/m]

#: Of a pin on a wheel.
CONTACT: dict[str, Any] = {
    "stiffness": 2e8,  # [N/m^1.5]
    "hysteresis": contact_hysteresis("flores", 0.8),
    "friction": 0.5,
    "transition": 0.1,  # [m/s]
}
GOVERNOR = 4000.0  # by which the motor's torque falls with its speed [N m s]


def pins(shoes: int) -> tuple[Floats, Floats]:
    """Where the pins are at the start (shoes, 3) [m], and the center of the idler; the wheel's is the origin.

    Around: over the left wheel, back below, over the right wheel, back above. Each wheel has half a turn of
    shoes, the corners of a regular polygon.
    """
    half, straight = ROUND // 2, (shoes - ROUND) // 2
    turn = np.pi / 2 + 2 * np.pi / ROUND * np.arange(half)
    corner = PITCH_RADIUS * np.stack([np.cos(turn), np.sin(turn), np.zeros(half)], axis=1)
    run = np.zeros((straight, 3))
    run[:, 0], run[:, 1] = PITCH * np.arange(straight), -PITCH_RADIUS
    center = np.array([PITCH * straight, 0.0, 0.0])
    opposite = np.array([-1.0, -1.0, 1.0])
    return np.concatenate([corner, run, center + opposite * corner, center + opposite * run]), center


def tracked_chain(shoes: int = 200, speed: float = 1.0) -> Model:
    """Track of 200 shoes around a driving wheel and an idler, carried by rollers.

    A closed chain of shoes joined by revolutes, as in an apron conveyor. Its pins press on wheels and rollers
    by contact (Flores et al. 2011) and are driven by friction: the wheels have no teeth. A motor turns the
    left wheel; a spring on the slide of the right one, the idler, holds a tension of 30 kN in each run; loose
    rollers, at most 2.5 m apart, carry both. Shoes of the M113's track as in Project Chrono's model of it
    (M113_TrackShoeSinglePin.json): pitch 154 mm, 18.02 kg; wheels of 20 shoes a turn and the rest our own.

    It starts as a polygon that moves with the given speed, sags onto the rollers, and surges; gravity along
    -y. Each shoe has one freedom, as have wheels, rollers and the slide; three equations are redundant, as in
    any closed chain of parallel revolutes. With "rk4" and a step of 0.2 ms the energy is known to 1/1000 for
    2 s: contacts begin within steps.

    shoes  number of shoes, even, 40 or more
    speed  of the track [m/s]

        model = lw.mechanisms.tracked_chain(shoes=60)
    """
    if shoes < 2 * ROUND or shoes % 2:
        raise ModelError(f"tracked_chain: shoes {shoes} is not an even number from {2 * ROUND}", code="count")
    model = Model(gravity=(0, -9.81, 0), name="tracked_chain")
    points, idler_center = pins(shoes)
    frame = Frame(model, model.ground)
    track = add_track(frame, points, idler_center, speed)
    _rollers(frame, track, points, idler_center[0], speed)
    return model


@dataclass(frozen=True)
class Frame:
    """What carries a track and its wheels, the beginning of their names, where its driving wheel is and how
    fast all of it goes at the start.
    """

    model: Model
    carrier: Body
    name: str = ""
    origin: Floats = field(default_factory=lambda: np.zeros(3))
    velocity: Floats = field(default_factory=lambda: np.zeros(3))


def add_track(frame: Frame, points: Floats, idler_center: Floats, speed: float) -> Range[Body]:
    """The shoes, by `pins`, that go around at this speed, with wheel, idler and motor."""
    track = _shoes(frame, points, idler_center, speed / PITCH_RADIUS)
    _wheels(frame, track, points, idler_center, speed / PITCH_RADIUS)
    _show(frame, track)
    return track


def _show(frame: Frame, track: Range[Body]) -> None:
    """What the bodies look like: plates in front of and behind the pins, discs between them."""
    model = frame.model
    plate = Box((0.92 * PITCH, 0.05, WIDTH), position=(0, -0.02, 0))
    model.shape(track, plate, Box((0.2 * PITCH, 0.05, 0.6 * WIDTH), position=(0, -0.07, 0)))
    for name, mark in (("wheel", "#d9b36c"), ("idler", "#b9c4d0")):
        spoke = Box((1.6 * WHEEL_RADIUS, 0.12, 0.5 * WIDTH + 0.02), color="#5b6570")
        model.find(frame.name + name).shape(Cylinder(WHEEL_RADIUS, 0.5 * WIDTH, axis=AXIS, color=mark), spoke)
    model.find(frame.name + "slide").shape(
        Box((0.5, 0.12, 0.6 * WIDTH), position=(0.1, 0, 0), color="#7a828c")
    )


def _shoes(frame: Frame, points: Floats, idler_center: Floats, turn: float) -> Range[Body]:
    """The chain: a shoe leads from each pin to the next; on a wheel they turn with it, others go straight."""
    model, name, origin = frame.model, frame.name, frame.origin
    shoes, half = len(points), ROUND // 2
    straight = shoes // 2 - half
    following = np.roll(points, -1, axis=0)
    along = following - points
    middle = (points + following) / 2

    velocity, omega = np.zeros((shoes, 3)), np.zeros((shoes, 3))
    for first, center, way in ((0, np.zeros(3), 1.0), (shoes // 2, idler_center, -1.0)):
        on_wheel = slice(first, first + half)
        velocity[on_wheel] = turn * np.cross(AXIS, middle[on_wheel] - center)
        omega[on_wheel, 2] = turn
        velocity[first + half : first + half + straight, 0] = way * turn * PITCH_RADIUS
    track = model.bodies(
        name + "shoe",
        mass=SHOE,
        inertia=SHOE_INERTIA,
        position=middle + origin,
        orientation=rotation.from_axes(along, np.cross(AXIS, along)),
        velocity=velocity + frame.velocity,
        omega=omega,
    )
    previous = track.indices[np.arange(shoes) - 1]
    model.joints("revolute", previous, track, at=points + origin, axis=AXIS, name=name + "pin")
    plane = name + "plane of the track"
    model.planar(frame.carrier, track[0], at=middle[0] + origin, axis=AXIS, name=plane)
    return track


def _wheels(frame: Frame, track: Range[Body], points: Floats, idler_center: Floats, turn: float) -> None:
    """The wheel and its motor; the idler on a slide that a spring pushes away."""
    model, carrier, name, center = frame.model, frame.carrier, frame.name, frame.origin
    idler_at = idler_center + center
    moving: dict[str, Any] = {"velocity": frame.velocity, "omega": turn * AXIS}
    wheel = model.body(name + "wheel", mass=WHEEL, inertia=WHEEL_INERTIA, position=center, **moving)
    slide = model.body(
        name + "slide", mass=SLIDE, inertia=(5.0, 5.0, 5.0), position=idler_at, velocity=frame.velocity
    )
    idler = model.body(name + "idler", mass=WHEEL, inertia=WHEEL_INERTIA, position=idler_at, **moving)
    model.revolute(carrier, wheel, at=center, axis=AXIS, name=name + "wheel bearing")
    model.revolute(slide, idler, at=idler_at, axis=AXIS, name=name + "idler bearing")
    model.translational(carrier, slide, at=idler_at, axis=(1, 0, 0), name=name + "slide guide")
    model.spring_damper(
        carrier, slide, at=(idler_at - (1.0, 0, 0), idler_at), stiffness=TENSIONER,
        damping=TENSIONER_DAMPING, free_length=1.0 + 2 * TENSION / TENSIONER, name=name + "tensioner",
    )  # fmt: skip
    torque = polynomial(GOVERNOR * turn, -GOVERNOR)
    model.motor(carrier, wheel, at=center, axis=AXIS, curve=torque, name=name + "motor")
    press_on(frame, wheel, np.zeros(3), WHEEL_RADIUS + _press(), track, points)
    press_on(frame, idler, idler_center, WHEEL_RADIUS + _press(), track, points)


def _rollers(frame: Frame, track: Range[Body], points: Floats, length: float, speed: float) -> None:
    """Pairs of them below the upper and the lower run."""
    count = int(np.ceil(length / ROLLER_SPACING)) - 1
    for k, x in enumerate(length * np.arange(1, count + 1) / (count + 1), 1):
        for run, height, sense in (("upper", PITCH_RADIUS, 1.0), ("lower", -PITCH_RADIUS, -1.0)):
            center = np.array([x, height - PIN - ROLLER_RADIUS, 0.0])
            add_roller(frame, f"{run} roller {k}", center, sense * speed, track, points)


def add_roller(
    frame: Frame,
    name: str,
    center: Floats,
    speed: float,
    track: Range[Body],
    points: Floats,
    *,
    radius: float = ROLLER_RADIUS,
    mass: float = ROLLER,
    inertia: tuple[float, float, float] = ROLLER_INERTIA,
) -> None:
    """A loose roller at this place in the frame, with this speed at its rim."""
    model, name, at = frame.model, frame.name + name, center + frame.origin
    roller = model.body(
        name, mass=mass, inertia=inertia, position=at, velocity=frame.velocity, omega=speed / radius * AXIS
    )
    roller.shape(Cylinder(radius, 0.5 * WIDTH, axis=AXIS, color="#8a8fa3"))
    model.revolute(frame.carrier, roller, at=at, axis=AXIS, name=f"{name} bearing")
    press_on(frame, roller, center, radius, track, points)


def press_on(
    frame: Frame, wheel: Body, center: Floats, radius: float, track: Range[Body], points: Floats
) -> None:
    """Contact of a wheel with every pin."""
    at = (center + frame.origin, points + frame.origin)
    frame.model.forces(
        "sphere_sphere_contact", wheel, track, at=at, radius_a=radius, radius_b=PIN,
        name=f"pins on {wheel.name}", **CONTACT,
    )  # fmt: skip


def _press() -> float:
    """How deep a pin is in a wheel [m] that bends the track by its tension: N = 2 T sin(pi / n)."""
    normal = 2 * TENSION * np.sin(np.pi / ROUND)
    return float((normal / CONTACT["stiffness"]) ** (2 / 3))


TRACKED_CHAIN = Mechanism(tracked_chain, t_end=1.0, step=2e-4)
