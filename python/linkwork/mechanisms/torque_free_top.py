"""A free body: its motion is known in closed form."""

from __future__ import annotations

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism


def torque_free_top() -> Model:
    """Symmetric top without forces or joints.

    Moments (2, 2, 1) kg m2, at first turning with (0.3, 0, 1) rad/s in body axes, where the angular velocity
    goes round the axis of symmetry with (1/2 - 1) 1 rad/s.

        model = lw.mechanisms.torque_free_top()
    """
    model = Model(gravity=(0, 0, 0), name="torque_free_top")
    model.body("top", mass=1.0, inertia=(2.0, 2.0, 1.0), omega=(0.3, 0.0, 1.0))
    return model


TORQUE_FREE_TOP = Mechanism(torque_free_top, t_end=20.0, step=1e-3)
