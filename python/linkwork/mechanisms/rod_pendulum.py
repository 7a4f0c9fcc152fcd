"""A rod on a pin: its reactions are known in closed form."""

from __future__ import annotations

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.rods import thin_rod


def rod_pendulum() -> Model:
    """Uniform rod on a pin, released from the horizontal.

    1 kg, 1 m, along +x from the pin at the origin; gravity along -y. With theta the angle from the downward
    vertical, the pin pulls with 5/2 m g cos(theta) along the rod and m g sin(theta) / 4 across it.

        model = lw.mechanisms.rod_pendulum()
    """
    model = Model(gravity=(0, -9.81, 0), name="rod_pendulum")
    rod = model.body("rod", mass=1.0, inertia=thin_rod(mass=1.0, length=1.0), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    return model


ROD_PENDULUM = Mechanism(rod_pendulum, t_end=10.0, step=1e-3)
