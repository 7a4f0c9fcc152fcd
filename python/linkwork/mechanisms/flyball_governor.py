"""IFToMM benchmark A05."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.rods import square_rod
from linkwork.modeling.shapes import Rod, Sphere
from linkwork.rotation import from_axes, matrix

ROD, SLIDER, BALL = 0.3, 3.0, 5.0  # masses [kg]
STIFFNESS, DAMPING = 8e5, 4e4  # of each spring [N/m], [N s/m]
SPEED = 2 * np.pi  # of the shaft at the start [rad/s]
SLOPE = np.pi / 6  # of the arms at the start, downward [rad]


def flyball_governor() -> Model:
    """Flyball governor: balls on two arms hold a slider by stiff springs (IFToMM benchmark A05).

    A shaft of 1 m turns about z with 2 pi rad/s at first. Hinged to its top, 5 cm to either side, are arms of
    1 m with points of 5 kg at their ends, 30 degrees below the horizontal. Springs of 0.5 m, 8e5 N/m, with
    dampers of 4e4 N s/m join the middle of each arm to a slider on the shaft, a cube of 10 cm and 3 kg. Shaft
    and arms are 1 cm square, 0.3 kg each. Gravity along -z. Four degrees of freedom, no redundant equation.

    The dampers make it stiff: the fastest motion dies away with 8100 1/s, which "rk4" can follow with steps
    below 0.34 ms. With a step of 0.1 ms the slider is within 1e-9 m after 10 s.

        model = lw.mechanisms.flyball_governor()
    """
    model, turn = Model(gravity=(0, 0, -9.81), name="flyball_governor"), np.array([0.0, 0.0, SPEED])
    rod, cube = square_rod(ROD, length=1.0, side=0.01), square_rod(SLIDER, length=0.1, side=0.1)
    upright = from_axes(x=(0, 0, 1), y=(0, 1, 0))
    shaft = model.body(
        "shaft", mass=ROD, inertia=rod, position=(0, 0, 0.5), orientation=upright, omega=(SPEED, 0, 0)
    )
    slider = model.body("slider", mass=SLIDER, inertia=cube, position=(0, 0, 0.5), omega=turn)
    model.revolute(model.ground, shaft, at=(0, 0, 0), axis=(0, 0, 1), name="bearing")
    model.translational(shaft, slider, at=(0, 0, 0.5), axis=(0, 0, 1), name="guide")

    # Rod and ball are one body: their center, and the moment about it.
    out = (ROD * 0.5 + BALL * 1.0) / (ROD + BALL)
    across = rod[1] + ROD * (out - 0.5) ** 2 + BALL * (1.0 - out) ** 2
    for name, side in (("right", 1.0), ("left", -1.0)):
        hinge, eye = np.array([0.05 * side, 0.0, 1.0]), np.array([0.05 * side, 0.0, 0.5])
        along = np.array([side * np.cos(SLOPE), 0.0, -np.sin(SLOPE)])
        center = hinge + out * along
        orientation = from_axes(x=along, y=(0, 1, 0))
        arm = model.body(
            f"{name} arm",
            mass=ROD + BALL,
            inertia=(rod[0], across, across),
            position=center,
            orientation=orientation,
            velocity=np.cross(turn, center),
            omega=matrix(orientation).T @ turn,
        )
        arm.shape(*_rod_and_ball(out))
        model.revolute(shaft, arm, at=hinge, axis=(0, 1, 0), name=f"{name} hinge")
        model.spring_damper(
            slider,
            arm,
            at=(eye, hinge + 0.5 * along),
            stiffness=STIFFNESS,
            damping=DAMPING,
            free_length=0.5,
            name=f"{name} spring",
        )
    return model


def _rod_and_ball(out: float) -> tuple[Rod, Sphere]:
    """An arm as it looks; its center is so far out [m]."""
    ball = Sphere(0.07, position=(1 - out, 0, 0), color="#c9a227")
    return Rod((-out, 0, 0), (1 - out, 0, 0), 0.012), ball


FLYBALL_GOVERNOR = Mechanism(flyball_governor, t_end=10.0, step=1e-4)
