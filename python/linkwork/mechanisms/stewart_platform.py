"""The hexapod of flight simulators."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.equations.assembly import assemble
from linkwork.functions import TimeFunction, harmonic
from linkwork.mechanisms.mechanism import Mechanism, between
from linkwork.rotation import from_axes

HEIGHT = 2.1  # of the platform at the start [m]
CYLINDER, PISTON = 1.3, 1.5  # lengths of the two halves of a leg, from its ends [m]

PLATFORM, CYLINDER_MASS, PISTON_MASS = 3000.0, 90.0, 45.0  # [kg]
PLATFORM_INERTIA = (3000.0, 3500.0, 2500.0)  # [kg m2]


#: Of strokes with which the platform goes round [m]; from 0.64 on it comes to a dead point.
LONGEST = 0.63


def base_points() -> Floats:
    """Centers of the joints on the ground (6, 3) [m]: pairs 0.6 m apart on a circle of 1.65 m."""
    return _pairs(radius=1.65, apart=0.6, angles=np.radians([0, 120, 240]))


def platform_points() -> Floats:
    """Centers of the joints on the platform, in its axes (6, 3) [m]: pairs 0.2 m apart on a circle of 1.6 m.

    Each pair is between two pairs of the ground; a leg goes to the nearer one.
    """
    return np.roll(_pairs(radius=1.6, apart=0.2, angles=np.radians([60, 180, 300])), 1, axis=0)


def strokes(amplitude: float, rate: float) -> list[TimeFunction]:
    """How much longer each leg is [m] than at the start; a wave that goes round at `rate` [rad/s]."""
    phases = np.arctan2(base_points()[:, 1], base_points()[:, 0])
    return [harmonic(amplitude, rate, phase, -amplitude * np.sin(phase)) for phase in phases]


def stewart_platform(driven: bool = True, amplitude: float = 0.15, rate: float = 3.0) -> Model:
    """Stewart platform: six legs that change their lengths move a platform in all six ways.

    A leg is a cylinder on a universal joint on the ground and a piston in a ball joint on the platform: 72
    equations on 78 coordinates, six degrees of freedom, which the six lengths determine. The platform of 3 t
    is 2.1 m above the ground; its joints are pairs 0.2 m apart on a circle of 1.6 m radius, those of the
    ground 0.6 m apart on one of 1.65 m: the size of a flight simulator, chosen here as are the masses. The
    legs go in a wave, so that the platform tilts around. Gravity along -z.

    driven     legs follow their strokes; otherwise they are free, and the platform sinks
    amplitude  of the strokes [m], up to 0.63 either way: beyond, the legs do not reach
    rate       of the strokes [rad/s]

        model = lw.mechanisms.stewart_platform()
    """
    between(-LONGEST, amplitude, LONGEST, "stewart_platform: amplitude")
    model = Model(gravity=(0, 0, -9.81), name="stewart_platform")
    lower, upper = base_points(), platform_points() + np.array([0.0, 0.0, HEIGHT])
    platform = model.body("platform", mass=PLATFORM, inertia=PLATFORM_INERTIA, position=(0, 0, HEIGHT))
    for k, (foot, head, stroke) in enumerate(zip(lower, upper, strokes(amplitude, rate), strict=True), 1):
        along = (head - foot) / np.linalg.norm(head - foot)
        level = np.cross((0, 0, 1), along)
        turned = from_axes(along, level)
        halves = []
        for name, mass, length, center in (
            (f"cylinder {k}", CYLINDER_MASS, CYLINDER, foot + CYLINDER / 2 * along),
            (f"piston {k}", PISTON_MASS, PISTON, head - PISTON / 2 * along),
        ):
            across = mass * length**2 / 12
            inertia = (mass * 0.06**2, across, across)
            halves.append(model.body(name, mass=mass, inertia=inertia, position=center, orientation=turned))
        cylinder, piston = halves
        model.universal(
            model.ground, cylinder, at=foot, axes=(level, np.cross(along, level)), name=f"foot {k}"
        )
        model.translational(cylinder, piston, at=head, axis=along, name=f"guide {k}")
        model.spherical(piston, platform, at=head, name=f"head {k}")
        if driven:
            model.displacement_driver(
                cylinder, piston, at=head, axis=along, displacement=stroke, name=f"actuator {k}"
            )
    return assemble(model).model if driven else model


def _pairs(radius: float, apart: float, angles: Floats) -> Floats:
    half = np.arcsin(apart / 2 / radius)
    both = np.stack([angles - half, angles + half], axis=1).ravel()
    return radius * np.stack([np.cos(both), np.sin(both), np.zeros(6)], axis=1)


STEWART_PLATFORM = Mechanism(stewart_platform, t_end=5.0, step=1e-3)
