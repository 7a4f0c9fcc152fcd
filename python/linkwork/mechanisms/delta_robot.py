"""The parallel robot that picks and places."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.equations.assembly import assemble
from linkwork.functions import TimeFunction, harmonic
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

BASE, ARM, FOREARM, TOOL = 0.2, 0.35, 0.8, 0.045  # radius, lengths, radius [m]
APART = 0.1  # of the two rods of a forearm [m]
START = np.radians(20.0)  # of the arms below the horizontal

ARM_MASS, ROD_MASS, TOOL_MASS = 1.2, 0.15, 0.8  # [kg]

AZIMUTHS = np.radians([0.0, 120.0, 240.0])  # of the motors
OUTWARD = np.stack([np.cos(AZIMUTHS), np.sin(AZIMUTHS), np.zeros(3)], axis=1)
UP = np.array([0.0, 0.0, 1.0])


def tool_position(angles: Floats) -> Floats:
    """Where the platform is (3,) [m] at angles of the arms below the horizontal (3,) [rad].

    It is as far as a forearm from each elbow, drawn in by the radius of the platform: the lower of the two
    points where three spheres meet.
    """
    along = np.cos(angles)[:, None] * OUTWARD - np.sin(angles)[:, None] * UP
    elbows = (BASE - TOOL) * OUTWARD + ARM * along
    # (x - c_k)^2 = l^2:  2 (c_k - c_0) . x = c_k^2 - c_0^2 is the line x = p + s n through both points.
    rows, sides = 2 * (elbows[1:] - elbows[0]), np.sum(elbows[1:] ** 2 - elbows[0] ** 2, axis=1)
    p, n = np.linalg.lstsq(rows, sides, rcond=None)[0], np.cross(rows[0], rows[1])
    n = n / np.linalg.norm(n) * np.sign(n[2])
    out, b = p - elbows[0], n @ (p - elbows[0])
    point: Floats = p - (b + np.sqrt(b**2 - out @ out + FOREARM**2)) * n
    return point


def motions(amplitude: float, rate: float) -> list[TimeFunction]:
    """By how much each motor lowers its arm [rad], from zero: the arms follow each other."""
    return [harmonic(amplitude, rate, phase, -amplitude * np.sin(phase)) for phase in AZIMUTHS]


def delta_robot(driven: bool = True, amplitude: float = 0.4, rate: float = 6.0) -> Model:
    """Delta robot: three arms and parallelograms of rods carry a platform that never turns.

    R. Clavel's robot (US patent 4976582, 1990). Motors on a circle of 0.2 m turn arms of 35 cm; from each two
    rods of 80 cm, 10 cm apart, lead to the platform, a radius of 4.5 cm: the size of a robot that packs,
    chosen here as are the masses. A rod has a universal joint on the arm and a ball on the platform. 57
    equations on 60 coordinates leave three degrees of freedom, the shifts of the platform. The motors follow
    each other, so that it goes round. Gravity along -z.

    driven     motors turn the arms; otherwise they are free, and the platform falls
    amplitude  of the arms [rad]
    rate       of the arms [rad/s]

        model = lw.mechanisms.delta_robot()
    """
    model = Model(gravity=(0, 0, -9.81), name="delta_robot")
    center = tool_position(np.full(3, START))
    tool = model.body("tool", mass=TOOL_MASS, inertia=(0.001, 0.001, 0.002), position=center)
    for k, (outward, motion) in enumerate(zip(OUTWARD, motions(amplitude, rate), strict=True), 1):
        axis = np.cross(UP, outward)  # a turn about it lowers the arm
        along = np.cos(START) * outward - np.sin(START) * UP
        shoulder, wrist = BASE * outward, center + TOOL * outward
        elbow = shoulder + ARM * along
        arm = model.body(
            f"arm {k}",
            mass=ARM_MASS,
            inertia=square_rod(ARM_MASS, ARM, 0.05),
            position=(shoulder + elbow) / 2,
            orientation=from_axes(along, axis),
        )
        model.revolute(model.ground, arm, at=shoulder, axis=axis, name=f"shoulder {k}")
        for side, shift in (("left", APART / 2 * axis), ("right", -APART / 2 * axis)):
            down = (wrist - elbow) / FOREARM
            rod = model.body(
                f"{side} rod {k}",
                mass=ROD_MASS,
                inertia=square_rod(ROD_MASS, FOREARM, 0.012),
                position=(elbow + wrist) / 2 + shift,
                orientation=from_axes(down, axis),
            )
            model.universal(
                arm, rod, at=elbow + shift, axes=(axis, np.cross(down, axis)), name=f"{side} elbow {k}"
            )
            model.spherical(rod, tool, at=wrist + shift, name=f"{side} wrist {k}")
        if driven:
            model.angle_driver(model.ground, arm, at=shoulder, axis=axis, angle=motion, name=f"motor {k}")
    return assemble(model).model if driven else model


DELTA_ROBOT = Mechanism(delta_robot, t_end=5.0, step=1e-3)
