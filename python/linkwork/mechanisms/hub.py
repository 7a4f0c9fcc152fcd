"""One body with many joints."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

#: Of the hub: mass [kg], radius and thickness [m].
MASS, RADIUS, THICKNESS = 10.0, 0.5, 0.1

#: At which all of it turns about the vertical at first [rad/s].
SPIN = 5.0


def hub(arms: int = 8, loops: bool = False) -> Model:
    """Hub on a vertical axle, with any number of arms around it.

    The hub is a disk of 10 kg, 1 m across, on a revolute joint about z. Arms of 1 m and 1 kg with square
    section of 5 cm hang from its rim in spherical joints, outward and 45 degrees down; all turn with 5 rad/s
    at first. Gravity along -z. With loops a distance joint keeps each tip as far from the next as it is, all
    the way round. It is one equation for each arm, and because the arms slant, none is redundant: lifting
    all arms stretches all distances.

    arms   number of arms; with loops three or more
    loops  join neighboring tips

        model = lw.mechanisms.hub(6)
    """
    at_least(3 if loops else 1, arms, "hub with loops: arms" if loops else "hub: arms")
    model = Model(gravity=(0, 0, -9.81), name="hub")
    across = MASS * (3 * RADIUS**2 + THICKNESS**2) / 12
    disk = model.body(
        "hub", mass=MASS, inertia=(across, across, MASS * RADIUS**2 / 2), omega=(0.0, 0.0, SPIN)
    )
    model.revolute(model.ground, disk, at=(0, 0, 0), axis=(0, 0, 1), name="axle")

    turn = 2 * np.pi * np.arange(arms) / arms
    outward = np.stack([np.cos(turn), np.sin(turn), np.zeros(arms)], axis=1)
    along = (outward - np.array([0.0, 0.0, 1.0])) / np.sqrt(2)
    around = np.cross((0, 0, 1), outward)
    rim, tip = RADIUS * outward, RADIUS * outward + along
    center = (rim + tip) / 2
    rods = model.bodies(
        "arm",
        mass=1.0,
        inertia=square_rod(1.0, 1.0, 0.05),
        position=center,
        orientation=from_axes(along, around),
        velocity=np.cross((0.0, 0.0, SPIN), center),
        omega=np.array([-SPIN / np.sqrt(2), 0.0, SPIN / np.sqrt(2)]),  # the vertical in the axes of an arm
    )
    model.joints("spherical", disk, rods, at=rim, name="shoulder")
    if loops:
        following = np.roll(np.arange(arms), -1)
        model.joints("distance", rods, rods.indices[following], at=(tip, tip[following]), name="loop")
    return model


HUB = Mechanism(hub, size=Size("arms", lambda arms: arms + 1), t_end=2.0, step=1e-3)
