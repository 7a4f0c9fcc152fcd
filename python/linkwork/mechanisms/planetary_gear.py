"""An epicyclic gear with two degrees of freedom."""

from __future__ import annotations

import numpy as np

from linkwork import Model, rotation
from linkwork.errors import ModelError
from linkwork.mechanisms.mechanism import Mechanism, at_least

SUN, PLANET, RING = 30, 23, 78  # teeth
MODULE = 1.5e-3  # pitch circles are so many meters across for each tooth
Z = (0, 0, 1)
RADIUS = {teeth: MODULE * teeth / 2 for teeth in (SUN, PLANET, RING)}  # of the pitch circles [m]
ARM = RADIUS[SUN] + RADIUS[PLANET]  # of the carrier
WIDTH, DENSITY = 0.025, 7850.0  # of the wheels, of steel [m], [kg/m3]

#: Moments of what is on the shafts [kg m2]: generator, engine, and the car, 1300 kg on tires of 0.287 m,
#: geared down by 4.11.
LOADS = {"sun": 0.02, "carrier": 0.15, "ring": 1300 * (0.287 / 4.11) ** 2}

CARRIER_SPEED, RING_SPEED = 150.0, 120.0  # at the start [rad/s]


def planetary_gear(
    planets: int = 4, engine: float = 60.0, generator: float = -12.0, road: float = 20.0
) -> Model:
    """Planetary gear that splits the power of an engine between a generator and a ring (Toyota's hybrid).

    The engine turns the carrier, the generator holds back the sun, the ring drives the car: two degrees of
    freedom, as Willis says, (w_ring - w_carrier) / (w_sun - w_carrier) = -z_sun / z_ring. Sun of 30 teeth,
    planets of 23, ring of 78, as in the power split of the Toyota Prius; wheels of steel, 25 mm wide, module
    1.5 mm: chosen here. No gravity. Each planet but the first closes a loop with one redundant equation.

    planets    number of planets; (30 + 78) / planets must be whole for them to fit
    engine     torque on the carrier [N m]
    generator  torque on the sun [N m]
    road       torque that holds the ring back [N m]

        model = lw.mechanisms.planetary_gear()
    """
    at_least(1, planets, "planetary_gear: planets")
    if planets not in (1, 2, 3, 4, 6):
        raise ModelError(
            f"planetary_gear: {planets} planets do not fit between {SUN} and {RING} teeth: 1 to 4 or 6",
            code="planets",
        )
    model = Model(gravity=(0, 0, 0), name="planetary_gear")
    sun_speed = CARRIER_SPEED - RING / SUN * (RING_SPEED - CARRIER_SPEED)
    for name, outer, inner, speed in (
        ("sun", RADIUS[SUN], 0.0, sun_speed),
        ("carrier", ARM + RADIUS[PLANET] / 2, 0.0, CARRIER_SPEED),
        ("ring", RADIUS[RING] + 0.01, RADIUS[RING], RING_SPEED),
    ):
        mass, (across, _, axial) = _disk(outer, inner)
        shaft = LOADS[name]
        inertia = (across + shaft / 2, across + shaft / 2, axial + shaft)
        body = model.body(name, mass=mass, inertia=inertia, omega=(0, 0, speed))
        model.revolute(model.ground, body, at=np.zeros(3), axis=Z, name=f"{name} bearing")
    _add_planets(model, planets)
    model.force("carrier", torque=(0, 0, engine), name="engine")
    model.force("sun", torque=(0, 0, generator), name="generator")
    model.force("ring", torque=(0, 0, -road), name="road")
    return model


def _add_planets(model: Model, planets: int) -> None:
    """Evenly around the sun, each on its bearing and in two gears."""
    speed = CARRIER_SPEED + RING / PLANET * (RING_SPEED - CARRIER_SPEED)
    mass, moments = _disk(RADIUS[PLANET], 0.0)
    for k in range(planets):
        angle = 2 * np.pi * k / planets
        center = ARM * np.array([np.cos(angle), np.sin(angle), 0.0])
        planet = model.body(
            f"planet {k + 1}",
            mass=mass,
            inertia=moments,
            position=center,
            orientation=rotation.about(Z, angle),
            velocity=CARRIER_SPEED * np.cross(Z, center),
            omega=(0, 0, speed),
        )
        model.revolute("carrier", planet, at=center, axis=Z, name=f"planet {k + 1} bearing")
        for wheel, teeth in (("sun", SUN), ("ring", -RING)):
            model.gear(wheel, planet, at=(np.zeros(3), center), axis=Z, teeth_a=teeth, teeth_b=PLANET,
                       name=f"{wheel} and planet {k + 1}")  # fmt: skip


def _disk(outer: float, inner: float) -> tuple[float, tuple[float, float, float]]:
    """Mass [kg] and principal moments [kg m2] of a disk with a hole, radii in m."""
    mass = DENSITY * np.pi * (outer**2 - inner**2) * WIDTH
    across = mass * (3 * (outer**2 + inner**2) + WIDTH**2) / 12
    return mass, (across, across, mass * (outer**2 + inner**2) / 2)


PLANETARY_GEAR = Mechanism(planetary_gear, t_end=1.0, step=1e-4)
