"""A rotor in gimbals with a weight: regular precession."""

from __future__ import annotations

import numpy as np

from linkwork import Model, rotation
from linkwork.errors import ModelError
from linkwork.mechanisms.mechanism import Mechanism

G = 9.81
ROTOR, ROTOR_RADIUS, ROTOR_WIDTH = 1.5, 0.075, 0.012  # mass [kg], radius and thickness [m]
INNER, INNER_RADIUS = 0.3, 0.09  # ring [kg], [m]
OUTER, OUTER_RADIUS = 0.5, 0.11
WEIGHT, ARM = 0.2, 0.12  # a point on the inner ring [kg], along the rotor's axis [m]

AXIAL = ROTOR * ROTOR_RADIUS**2 / 2  # moments of the rotor [kg m2]
ACROSS = ROTOR * (3 * ROTOR_RADIUS**2 + ROTOR_WIDTH**2) / 12


def precession(spin: float, tilt: float) -> float:
    """The slow rate [rad/s] about the vertical at which the tilt [rad] of the axis stays as it is.

    (B - E) cos(tilt) W^2 - C spin W + m g l = 0, with B the moment of rotor, ring and weight across the axis
    and E that of the ring along it; `spin` [rad/s] is the rotor's angular velocity about its axis, all in all
    (Goldstein, Classical Mechanics, 3rd ed., section 5.7, with the moments of the ring).
    ModelError: the rotor is too slow for any.
    """
    across = ACROSS + INNER * INNER_RADIUS**2 + WEIGHT * ARM**2 - INNER * INNER_RADIUS**2 / 2
    a, b, c = across * np.cos(tilt), AXIAL * spin, WEIGHT * G * ARM
    discriminant = b**2 - 4 * a * c
    if b <= 0 or discriminant < 0:
        raise ModelError(
            f"gyroscope: spin {spin:g} rad/s is too slow to hold a tilt of {tilt:g} rad", code="spin"
        )
    return float(2 * c / (b + np.sqrt(discriminant)))


def gyroscope(spin: float = 100.0, tilt: float = 1.0) -> Model:
    """Gyroscope in two gimbals, with a weight on its axis, in regular precession.

    The outer ring turns about the vertical z, the inner one about a level axis of the outer, the rotor in the
    inner. A disk of 1.5 kg, 15 cm across; rings of 0.3 and 0.5 kg; a weight of 0.2 kg 12 cm from the center
    pulls the axis down, which therefore goes round the vertical at the rate that keeps its tilt. Three
    revolutes that meet in a point, three degrees of freedom. Gravity along -z; dimensions our own, of a
    demonstration model. With "rk4" and a step of 0.2 ms the axis
    stays where it should be to 1e-8 for 10 s.

    spin  angular velocity of the rotor about its axis [rad/s]
    tilt  of the axis from the vertical [rad], from 0.3 to 2.8

        model = lw.mechanisms.gyroscope()
    """
    if not 0.3 <= tilt <= 2.8:
        raise ModelError(f"gyroscope: tilt {tilt} rad is not from 0.3 to 2.8", code="tilt")
    rate = precession(spin, tilt)
    model = Model(gravity=(0, 0, -G), name="gyroscope")
    turned = rotation.about((1, 0, 0), tilt)
    A = rotation.matrix(turned)
    axis, turn = A[:, 2], A.T @ (0, 0, rate)

    outer = model.body("outer ring", mass=OUTER, inertia=_ring(OUTER, OUTER_RADIUS), omega=(0, 0, rate))
    center = WEIGHT * ARM / (INNER + WEIGHT) * axis
    off = INNER * WEIGHT / (INNER + WEIGHT) * ARM**2  # moment of ring and weight about their common center
    inner = model.body(
        "inner ring",
        mass=INNER + WEIGHT,
        inertia=_ring(INNER, INNER_RADIUS) + off * np.array([1.0, 1.0, 0.0]),
        position=center,
        orientation=turned,
        velocity=np.cross((0, 0, rate), center),
        omega=turn,
    )
    rotor = model.body(
        "rotor",
        mass=ROTOR,
        inertia=(ACROSS, ACROSS, AXIAL),
        orientation=turned,
        omega=(turn[0], turn[1], spin),
    )
    model.revolute(model.ground, outer, at=(0, 0, 0), axis=(0, 0, 1), name="outer bearing")
    model.revolute(outer, inner, at=(0, 0, 0), axis=(1, 0, 0), name="inner bearing")
    model.revolute(inner, rotor, at=(0, 0, 0), axis=axis, name="spindle")
    return model


def _ring(mass: float, radius: float) -> np.ndarray:
    """Moments of a thin ring in the plane of x and z."""
    return mass * radius**2 * np.array([0.5, 1.0, 0.5])


GYROSCOPE = Mechanism(gyroscope, t_end=10.0, step=2e-4)
