"""The front suspension of an off-road car on a post rig."""

from __future__ import annotations

import numpy as np

from linkwork import Box, Cylinder, Model, Rod
from linkwork.arrays import Floats
from linkwork.functions import harmonic
from linkwork.mechanisms.mechanism import Mechanism

G = 9.81
CHASSIS, POST = 520.0, 50.0  # a quarter of the car, and the post [kg]
WHEEL, TIRE_RADIUS = 70.0, 0.47  # [kg], [m]

#: Points of the left side [m]: x forward, y to the left, z up; the origin is level with the lower hinges.
LOWER_HINGE, LOWER_BALL = np.array([0.0, 0.307, 0.0]), np.array([-0.036, 0.787, -0.118])
UPPER_FRONT, UPPER_BACK = np.array([-0.048, 0.446, 0.245]), np.array([-0.268, 0.478, 0.196])
UPPER_BALL = np.array([-0.053, 0.716, 0.215])
TIE_INNER, TIE_OUTER = np.array([-0.25, 0.448, 0.054]), np.array([-0.176, 0.821, -0.016])
STRUT_TOP, STRUT_FOOT = np.array([0.104, 0.498, 0.323]), np.array([0.097, 0.543, -0.047])
WHEEL_CENTER = np.array([-0.04, 0.91, -0.026])

#: Mass [kg], moments of inertia [kg m2], center [m]. The flat arms have half the moment about z across: the
#: source has less, which no body can have.
ARMS = {
    "lower arm": (23.965, (0.447, 0.447, 0.8938), (0.0, 0.547, -0.059)),
    "upper arm": (5.813, (0.0314, 0.0314, 0.06276), (-0.106, 0.589, 0.218)),
    "upright": (19.45, (0.1656, 0.1934, 0.04367), (-0.04, 0.751, -0.026)),
}

SPRING, DAMPER = 1.5e5, 1.9e4  # of the strut [N/m], [N s/m]
TIRE = 3.5e5  # [N/m]
#: Of the strut [N]: with it no body is accelerated at the start.
PRELOAD = 11611.3708382283


def double_wishbone(amplitude: float = 0.02, rate: float = 8.0) -> Model:
    """Double wishbone suspension of a car that is shaken by a post under its tire.

    A quarter of the chassis that goes up and down, two wishbones hinged to it, the upright in ball joints at
    their ends, a massless tie rod that steers it, a strut, a wheel; the tire, a sphere that presses on the
    post, carries all. Points and masses of the front suspension of the HMMWV as in Project Chrono's model
    (HMMWV_DoubleWishboneFront.json); spring, tire and chassis our own. 33 equations on 36 coordinates leave
    three degrees of freedom: the chassis, the suspension, and the wheel's spin. Gravity along -z; it starts
    at rest in equilibrium, and the post goes as amplitude (1 - cos(rate t)).

    amplitude  of the post [m]
    rate       of the post [rad/s]

        model = lw.mechanisms.double_wishbone()
    """
    model = Model(gravity=(0, 0, -G), name="double_wishbone")
    chassis = model.body("chassis", mass=CHASSIS, inertia=(100.0, 100.0, 150.0), position=(-0.04, 0, 0.4))
    lower, upper, upright = (
        model.body(name, mass=mass, inertia=inertia, position=center)
        for name, (mass, inertia, center) in ARMS.items()
    )
    wheel = model.body("wheel", mass=WHEEL, inertia=(2.5, 4.5, 2.5), position=WHEEL_CENTER)
    load = (CHASSIS + WHEEL + sum(mass for mass, _, _ in ARMS.values())) * G
    patch = WHEEL_CENTER - (0, 0, TIRE_RADIUS - load / TIRE)
    post = model.body("post", mass=POST, inertia=(2.0, 2.0, 2.0), position=patch - (0, 0, 0.2))

    up = (0, 0, 1)
    model.translational(model.ground, chassis, at=(0, 0, 0), axis=up, name="chassis guide")
    model.revolute(chassis, lower, at=LOWER_HINGE, axis=(1, 0, 0), name="lower hinge")
    model.revolute(chassis, upper, at=UPPER_FRONT, axis=UPPER_FRONT - UPPER_BACK, name="upper hinge")
    model.spherical(lower, upright, at=LOWER_BALL, name="lower ball")
    model.spherical(upper, upright, at=UPPER_BALL, name="upper ball")
    model.universal_spherical(chassis, upright, at=(TIE_INNER, TIE_OUTER), name="tie rod")
    model.revolute(upright, wheel, at=WHEEL_CENTER, axis=(0, 1, 0), name="hub")
    model.translational(model.ground, post, at=patch, axis=up, name="post guide")
    model.displacement_driver(
        model.ground, post, at=patch, axis=up, name="shaker",
        displacement=harmonic(amplitude, rate, -np.pi / 2, amplitude),
    )  # fmt: skip

    length = float(np.linalg.norm(STRUT_TOP - STRUT_FOOT))
    model.spring_damper(
        chassis, lower, at=(STRUT_TOP, STRUT_FOOT), stiffness=SPRING, damping=DAMPER,
        free_length=length + PRELOAD / SPRING, name="strut",
    )  # fmt: skip
    model.sphere_plane_contact(
        post, wheel, at=(patch, WHEEL_CENTER), normal=up, radius=TIRE_RADIUS, stiffness=TIRE, exponent=1.0,
        name="tire",
    )  # fmt: skip
    _show(model, patch)
    return model


def _show(model: Model, patch: Floats) -> None:
    """What the bodies look like."""
    across = (0, 1, 0)
    model.find("wheel").shape(
        Cylinder(TIRE_RADIUS, 0.26, axis=across, color="#3b4048"),
        Cylinder(0.25, 0.28, axis=across, color="#c9ced6"),
    )
    post = model.find("post")
    post.shape(Box((0.45, 0.45, 0.03), position=(0, 0, 0.185)), Rod((0, 0, 0.17), (0, 0, -0.25), 0.04))
    center = np.array([-0.04, 0, 0.4])
    frame = [np.array([x, 0.26, z]) for x, z in ((0.3, 0.0), (-0.4, 0.0), (-0.4, 0.32), (0.3, 0.32))]
    beams = [Rod(a - center, b - center, 0.022) for a, b in zip(frame, frame[1:] + frame[:1], strict=True)]
    brackets = [Rod(point * (1, 0, 1) + (0, 0.26, 0) - center, point - center, 0.014)
                for point in (LOWER_HINGE, UPPER_FRONT, UPPER_BACK, STRUT_TOP, TIE_INNER)]  # fmt: skip
    model.find("chassis").shape(*beams, *brackets)
    front, back = (LOWER_HINGE + np.array([x, 0, 0]) for x in (0.2, -0.2))
    for name, (first, second, ball) in {
        "lower arm": (front, back, LOWER_BALL), "upper arm": (UPPER_FRONT, UPPER_BACK, UPPER_BALL)
    }.items():  # fmt: skip
        center = np.array(ARMS[name][2])
        ends = ((first, ball), (second, ball), (first, second))
        model.find(name).shape(*(Rod(a - center, b - center, 0.018) for a, b in ends))


DOUBLE_WISHBONE = Mechanism(double_wishbone, t_end=5.0, step=1e-3)
