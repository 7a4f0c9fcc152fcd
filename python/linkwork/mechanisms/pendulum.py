"""IFToMM benchmark A01."""

from __future__ import annotations

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism


def pendulum() -> Model:
    """Simple pendulum: a point mass on a massless rod (IFToMM benchmark A01).

    1 kg at a distance of 1 m from the origin, released at rest from x = -1 m; gravity along -y. With "rk4"
    and a step of 1 ms it keeps its place to 1e-8 m for 10 s.

        model = lw.mechanisms.pendulum()
    """
    model = Model(gravity=(0, -9.81, 0), name="pendulum")
    start = (-1, 0, 0)
    # A point has no inertia; the rod pulls at the center of the bob, so whatever it has never begins to turn.
    bob = model.body("bob", mass=1.0, inertia=(1.0, 1.0, 1.0), position=start)
    model.distance(model.ground, bob, at=((0, 0, 0), start), name="rod")
    return model


PENDULUM = Mechanism(pendulum, t_end=10.0, step=1e-3)
