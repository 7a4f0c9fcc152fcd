"""A vehicle on two tracks."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.errors import ModelError
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.tracked_chain import (
    CONTACT,
    PIN,
    PITCH_RADIUS,
    ROLLER_RADIUS,
    ROUND,
    WIDTH,
    Frame,
    add_roller,
    add_track,
    pins,
)
from linkwork.modeling.handles import Body, Range
from linkwork.modeling.shapes import Box

HULL, HULL_INERTIA = 8000.0, (8000.0, 22000.0, 20000.0)  # [kg], along, upward, across (z) [kg m2]
HULL_HEIGHT = 0.3  # of its center above the wheels' [m]
GAUGE = 2.16  # between the tracks [m]

ROAD_WHEEL, ROAD_WHEEL_RADIUS, ROAD_WHEEL_INERTIA = 60.0, 0.3, (1.5, 1.5, 2.7)  # [kg], [m], [kg m2]
ROAD_WHEELS, RETURN_ROLLERS = 5, 2  # of a track

#: Of a shoe on the ground: a ball at its center [m].
PAD = 0.05


def tracked_vehicle(shoes: int = 90, speed: float = 1.0) -> Model:
    """Tracked vehicle with 90 shoes on each side that rolls on flat ground.

    Two of the tracks of "tracked_chain", 2.16 m apart, on a hull of 8 t: each has a driving wheel with its
    motor, an idler on a slide with a spring, five road wheels on the lower run and two rollers under the
    upper one, by friction and contact with every pin. Bearings are fixed in the hull: there is no suspension
    but the track. Each shoe presses on the ground in one point below its center. It rolls at the start, with
    the lower runs at rest, and settles. Gravity along -y.

    The hull has six freedoms, each shoe, wheel, roller and slide one; three equations of each track are
    redundant, as in any closed chain of parallel revolutes.

    shoes  of each track, even, 60 or more
    speed  of the vehicle, along -x [m/s]

        model = lw.mechanisms.tracked_vehicle(shoes=60)
    """
    if shoes < 3 * ROUND or shoes % 2:
        raise ModelError(
            f"tracked_vehicle: shoes {shoes} is not an even number from {3 * ROUND}", code="count"
        )
    model = Model(gravity=(0, -9.81, 0), name="tracked_vehicle")
    points, idler_center = pins(shoes)
    velocity = np.array([-speed, 0.0, 0.0])
    middle = np.array([idler_center[0] / 2, HULL_HEIGHT, 0.0])
    hull = model.body("hull", mass=HULL, inertia=HULL_INERTIA, position=middle, velocity=velocity)
    hull.shape(Box((idler_center[0], 0.7, GAUGE - WIDTH), color="#6b7357"))
    for name, z in (("left ", -GAUGE / 2), ("right ", GAUGE / 2)):
        frame = Frame(model, hull, name, np.array([0.0, 0.0, z]), velocity)
        track = add_track(frame, points, idler_center, speed)
        _carry(frame, track, points, idler_center[0], speed)
        _stand(frame, track, points)
    return model


def _carry(frame: Frame, track: Range[Body], points: Floats, length: float, speed: float) -> None:
    """Road wheels on the lower run, rollers under the upper one."""
    for k in range(1, RETURN_ROLLERS + 1):
        center = np.array([length * k / (RETURN_ROLLERS + 1), PITCH_RADIUS - PIN - ROLLER_RADIUS, 0.0])
        add_roller(frame, f"return roller {k}", center, speed, track, points)
    for k in range(1, ROAD_WHEELS + 1):
        center = np.array([length * k / (ROAD_WHEELS + 1), -PITCH_RADIUS + PIN + ROAD_WHEEL_RADIUS, 0.0])
        add_roller(
            frame, f"road wheel {k}", center, speed, track, points, radius=ROAD_WHEEL_RADIUS,
            mass=ROAD_WHEEL, inertia=ROAD_WHEEL_INERTIA,
        )  # fmt: skip


def _stand(frame: Frame, track: Range[Body], points: Floats) -> None:
    """The shoes on the ground."""
    centers = (points + np.roll(points, -1, axis=0)) / 2 + frame.origin
    ground = (0.0, -PITCH_RADIUS - PAD, 0.0)
    frame.model.forces(
        "sphere_plane_contact", frame.model.ground, track, at=(ground, centers), normal=(0, 1, 0), radius=PAD,
        name=f"{frame.name}track on the ground", **CONTACT,
    )  # fmt: skip


TRACKED_VEHICLE = Mechanism(tracked_vehicle, t_end=1.0, step=1e-4)
