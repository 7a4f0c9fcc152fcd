"""A disc that rolls on a table: Euler's disc without its losses."""

from __future__ import annotations

import numpy as np

from linkwork import Model, rotation
from linkwork.errors import ModelError
from linkwork.mechanisms.mechanism import Mechanism

MASS, RADIUS = 0.4, 0.0375  # [kg], [m]


def rolling_disc(tilt: float = 0.5, spin: float = 18.0, yaw: float = 6.0) -> Model:
    """Disc that rolls on a table without slipping or loss, nodding on its way.

    A non-holonomic joint: the disc touches the table (one equation of positions), and its lowest point is at
    rest (two of velocities): three degrees of freedom, and a mechanism that ends up elsewhere than it began.
    A thin disc of 0.4 kg, 75 mm across, about that of the toy "Euler's disk" (on which see H. K. Moffatt,
    Euler's disk and its finite-time singularity, Nature 404, 833-834, 2000); gravity along -z. "dop853" with
    a step of 1 ms keeps its energy to the last digits.

    tilt  of the disc's plane from the vertical at the start [rad], below 1.3
    spin  about the disc's axis at the start, against the frame that yaws [rad/s]
    yaw   about the vertical at the start [rad/s]

        model = lw.mechanisms.rolling_disc()
    """
    if not abs(tilt) <= 1.3:
        raise ModelError(f"rolling_disc: tilt {tilt} rad is not between -1.3 and 1.3", code="tilt")
    turned = rotation.about((1, 0, 0), np.pi / 2 - tilt)  # the axis of the disc is z of the body
    A = rotation.matrix(turned)
    axis, up = A[:, 2], np.array([0.0, 0.0, 1.0])
    upward = up - axis[2] * axis  # from the point of contact, the origin, to the center
    center = RADIUS * upward / np.linalg.norm(upward)
    omega = yaw * up + spin * axis
    model = Model(gravity=(0, 0, -9.81), name="rolling_disc")
    disc = model.body(
        "disc",
        mass=MASS,
        inertia=np.array([0.25, 0.25, 0.5]) * MASS * RADIUS**2,
        position=center,
        orientation=turned,
        velocity=np.cross(omega, center),
        omega=A.T @ omega,
    )
    model.rolling_disc(
        model.ground, disc, at=((0, 0, 0), center), axes=(up, axis), radius=RADIUS, name="contact"
    )
    return model


ROLLING_DISC = Mechanism(rolling_disc, t_end=10.0, step=1e-3, integrator="dop853")
