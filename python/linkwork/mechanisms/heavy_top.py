"""The heavy top of the literature on Lie group integrators."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism


def heavy_top() -> Model:
    """Heavy top spinning at 150 rad/s about its axis, held at a point.

    Benchmark of Bruels, Cardona and Arnold (2012), Mech. Mach. Theory 48, 121-137: 15 kg, the center of
    mass 1 m from the point, at (0, 1, 0) at the start; gravity along -z.

        model = lw.mechanisms.heavy_top()
    """
    model = Model(gravity=(0, 0, -9.81), name="heavy_top")
    center, omega = np.array([0.0, 1.0, 0.0]), np.array([0.0, 150.0, -4.61538])
    top = model.body(
        "top",
        mass=15.0,
        inertia=(0.234375, 0.46875, 0.234375),
        position=center,
        velocity=np.cross(omega, center),
        omega=omega,
    )
    model.spherical(model.ground, top, at=(0, 0, 0), name="tip")
    return model


HEAVY_TOP = Mechanism(heavy_top, t_end=2.0, step=1e-4)
