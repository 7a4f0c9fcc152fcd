"""IFToMM benchmark A03."""

from __future__ import annotations

import numpy as np

from linkwork import Model, rotation
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism

#: Angles at the start [rad]; they close the loops to the last digit.
BETA, GAMMA, PHI = -0.0617138900142764496, 0.455279819163070380, 0.222668390165885885
DELTA, EPSILON = 0.487364979543842550, 1.23054744454982119

#: Points fixed in the plane [m].
ORIGIN, A, B, C = (np.array(point) for point in (
    (0.0, 0.0, 0.0), (-0.06934, -0.00227, 0.0), (-0.03635, 0.03273, 0.0), (0.014, 0.072, 0.0)
))  # fmt: skip

#: Mass [kg], moment of inertia about the normal [kg m2].
INERTIAS = {
    "K1": (0.04325, 2.194e-6),
    "K2": (0.00365, 4.410e-7),
    "K3": (0.02373, 5.255e-6),
    "K4": (0.00706, 5.667e-7),
    "K5": (0.07050, 1.169e-5),
    "K6": (0.00706, 5.667e-7),
    "K7": (0.05498, 1.912e-5),
}

MOTOR = 0.033  # N m
STIFFNESS, FREE_LENGTH = 4530.0, 0.07785  # N/m, m


def andrews() -> Model:
    """Andrews' squeezing mechanism: seven flat bodies, a motor and a spring (IFToMM benchmark A03).

    A motor of 0.033 N m turns the crank K1 from rest, which works three loops that meet in one point, E; a
    spring holds K3; no gravity. Ten revolutes with parallel axes: 50 equations of rank 41 on 42 coordinates.
    Data of the Test Set for Initial Value Problem Solvers, problem "Andrews' squeezing mechanism" (Hairer
    and Wanner, Solving Ordinary Differential Equations II, section VII.7).

    Bodies of some grams and millimeters, accelerated by 10 000 rad/s2: "rk4" with a step of 10 us keeps
    angles to 1e-9, velocities to 1e-7 and reactions to 1e-5 at t = 0.03 s, relative. More digits, in less
    time: "dop853" with rtol = atol = 1e-12.

        model = lw.mechanisms.andrews()
    """
    model = Model(gravity=(0, 0, 0), name="andrews")
    F = ORIGIN + 0.007 * _along(BETA)
    E = F - 0.028 * _along(BETA)
    G, H = A + 0.04 * _along(DELTA), A - 0.04 * _across(EPSILON)
    D = B + 0.02 * _along(GAMMA) - 0.018 * _across(GAMMA)  # the end of the spring on K3
    poses = {
        "K1": (ORIGIN + 0.00092 * _along(BETA), BETA),
        "K2": (F - 0.0115 * _along(BETA), BETA),
        "K3": (B + 0.01043 * _along(GAMMA) - 0.01874 * _across(GAMMA), GAMMA),
        "K4": (G - (0.02 - 0.01421) * _across(PHI + DELTA), PHI + DELTA),
        "K5": (A + 0.02308 * _along(DELTA) + 0.00916 * _across(DELTA), DELTA),
        "K6": (H + (0.02 - 0.01421) * _along(EPSILON - PHI), EPSILON - PHI),
        "K7": (A - 0.00449 * _along(EPSILON) - 0.01228 * _across(EPSILON), EPSILON),
    }
    for name, (center, angle) in poses.items():
        mass, J = INERTIAS[name]
        turned = rotation.about((0, 0, 1), angle)
        model.body(name, mass=mass, inertia=(J / 2, J / 2, J), position=center, orientation=turned)
    for name, first, second, point in (
        ("O", "ground", "K1", ORIGIN),
        ("F", "K1", "K2", F),
        ("E3", "K2", "K3", E),
        ("E4", "K2", "K4", E),
        ("E6", "K2", "K6", E),
        ("B", "ground", "K3", B),
        ("A5", "ground", "K5", A),
        ("A7", "ground", "K7", A),
        ("G", "K5", "K4", G),
        ("H", "K7", "K6", H),
    ):
        model.revolute(first, second, at=point, axis=(0, 0, 1), name=name)
    model.spring_damper(
        "ground", "K3", at=(C, D), stiffness=STIFFNESS, free_length=FREE_LENGTH, name="spring"
    )
    model.force("K1", torque=(0, 0, MOTOR), name="motor")
    return model


def _along(angle: float) -> Floats:
    """Unit vector at an angle from x in the plane."""
    return np.array([np.cos(angle), np.sin(angle), 0.0])


def _across(angle: float) -> Floats:
    """A quarter turn further."""
    return np.array([-np.sin(angle), np.cos(angle), 0.0])


ANDREWS = Mechanism(andrews, t_end=0.03, step=1e-5)
