"""A spatial mechanism of one degree of freedom without redundant equations."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes, matrix

X, Y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])

BEARING = np.array([0.0, 0.1, 0.12])  # of the crank, which turns about x
PIN = np.array([0.0, 0.1, 0.20])  # between crank and coupler
PISTON = np.array([0.2, 0.0, 0.0])  # center of the slider, which moves along x
COUPLER = PISTON - PIN
ACROSS = np.cross(COUPLER, Y)  # axis of the universal joint in the coupler; the one in the slider is y


def spatial_slider_crank(speed: float = 6.0) -> Model:
    """Spatial slider-crank: revolute, spherical, universal and translational joint.

    A crank of 8 cm turns about x; a coupler of 30 cm drives a slider of 2 kg along x, on a line 16 cm from
    the bearing of the crank. 17 equations, one degree of freedom; gravity along -z.

    speed  of the crank at the start [rad/s]

        model = lw.mechanisms.spatial_slider_crank()
    """
    model = Model(gravity=(0, 0, -9.81), name="spatial_slider_crank")
    pin_velocity = np.cross(speed * X, PIN - BEARING)
    slider_velocity = (COUPLER @ pin_velocity) / (COUPLER @ X) * X  # the coupler does not change its length
    coupler_omega = _turning(slider_velocity - pin_velocity)

    up, along = from_axes(PIN - BEARING, X), from_axes(COUPLER, ACROSS)
    crank = model.body(
        "crank",
        mass=0.12,
        inertia=square_rod(0.12, 0.08, 0.02),
        position=(BEARING + PIN) / 2,
        orientation=up,
        velocity=pin_velocity / 2,
        omega=matrix(up).T @ (speed * X),
    )
    coupler = model.body(
        "coupler",
        mass=0.5,
        inertia=square_rod(0.5, 0.3, 0.02),
        position=(PIN + PISTON) / 2,
        orientation=along,
        velocity=(pin_velocity + slider_velocity) / 2,
        omega=matrix(along).T @ coupler_omega,
    )
    slider = model.body("slider", mass=2.0, inertia=(0.002,) * 3, position=PISTON, velocity=slider_velocity)

    model.revolute(model.ground, crank, at=BEARING, axis=X, name="bearing")
    model.spherical(crank, coupler, at=PIN, name="crank pin")
    model.universal(coupler, slider, at=PISTON, axes=(ACROSS, Y), name="piston pin")
    model.translational(model.ground, slider, at=PISTON, axis=X, name="guide")
    return model


def _turning(end_velocity: Floats) -> Floats:
    """Angular velocity w of the coupler, inertial [rad/s], when its ends move against each other.

    w x COUPLER = end_velocity,   w . (ACROSS x y) = 0: the axes of the universal joint stay perpendicular
    """
    equations = np.vstack([np.cross(np.eye(3), COUPLER).T, np.cross(ACROSS, Y)])
    omega: Floats = np.linalg.lstsq(equations, np.append(end_velocity, 0.0), rcond=None)[0]
    return omega


SPATIAL_SLIDER_CRANK = Mechanism(spatial_slider_crank, t_end=5.0, step=1e-3)
