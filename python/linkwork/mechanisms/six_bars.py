"""Six links and seven hinges: the two chains of one freedom beyond the four-bar linkage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.equations.assembly import assemble
from linkwork.errors import ModelError
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.planar import meet, polar, tube_link

DENSITY, RADIUS = 0.5, 0.01  # of aluminum tube [kg/m], [m]
FLYWHEEL = 0.02  # moment of inertia that keeps the crank turning [kg m2]

CRANK, START = 0.12, 0.5  # length [m], angle at the start [rad]
A, D = np.zeros(3), np.array([0.4, 0.0, 0.0])  # bearings of the crank and of the rocker [m]
WATT_BEARING = np.array([0.7, 0.1, 0.0])  # of the output
STEPHENSON_BEARING = np.array([0.1, 0.62, 0.0])

#: The branches of the first and the second loop, by number of the mode: 1 to the left, -1 to the right.
MODES = {1: (1, 1), 2: (1, -1), 3: (-1, 1), 4: (-1, -1)}


def watt_points(crank_angle: float, mode: int = 1) -> dict[str, Floats]:
    """Points (3,) [m] of the Watt linkage at an angle of the crank from x [rad]."""
    first, second = _branches("watt_six_bar", mode)
    B = polar(CRANK, crank_angle)
    C = meet(B, D, 0.35, 0.30, first)
    E = meet(D, C, 0.25, 0.20, 1)  # the third corner of the rocker
    F = meet(E, WATT_BEARING, 0.35, 0.30, second)
    return {"A": A, "B": B, "C": C, "D": D, "E": E, "F": F, "G": WATT_BEARING}


def stephenson_points(crank_angle: float, mode: int = 1) -> dict[str, Floats]:
    """Points (3,) [m] of the Stephenson linkage at an angle of the crank from x [rad]."""
    first, second = _branches("stephenson_six_bar", mode)
    B = polar(CRANK, crank_angle)
    C = meet(B, D, 0.35, 0.30, first)
    E = meet(B, C, 0.25, 0.22, 1)  # the third corner of the coupler
    F = meet(E, STEPHENSON_BEARING, 0.40, 0.50, second)
    return {"A": A, "B": B, "C": C, "D": D, "E": E, "F": F, "G": STEPHENSON_BEARING}


def watt_six_bar(mode: int = 1, speed: float = 12.0) -> Model:
    """Watt's six-bar linkage (II): two four-bars in a row, the rocker of one drives the other.

    Two links of the chain have three hinges, and they are neighbors: the ground and the rocker. The crank of
    12 cm, with a flywheel, turns all the way round, free after the start; the output of 30 cm swings. For
    each angle of the crank there are four assembly modes, and a motion stays in the one in which it begins.
    Seven revolutes with parallel axes: 35 equations of rank 29 on 30 coordinates. Gravity along -y. Classes
    of linkages as in McCarthy and Soh, Geometric Design of Linkages, 2nd ed., Springer 2011; dimensions our
    own.

    mode   of assembly, 1 to 4: first loop left or right, second loop left or right
    speed  of the crank at the start [rad/s]

        model = lw.mechanisms.watt_six_bar()
    """
    links = {"coupler": "BC", "rocker": "DCE", "rod": "EF", "output": "GF"}
    joints = ("B crank coupler", "C coupler rocker", "D ground rocker", "E rocker rod")
    return _six_bar("watt_six_bar", watt_points(START, mode), links, joints, speed)


def stephenson_six_bar(mode: int = 1, speed: float = 12.0) -> Model:
    """Stephenson's six-bar linkage (III): the coupler of a four-bar drives an output by a rod.

    Two links of the chain have three hinges, and they are not neighbors: the ground and the coupler. The rest
    is as in `watt_six_bar`: a crank of 12 cm with a flywheel that turns all the way round, four assembly
    modes, 35 equations of rank 29 on 30 coordinates, gravity along -y, dimensions our own.

    mode   of assembly, 1 to 4: first loop left or right, second loop left or right
    speed  of the crank at the start [rad/s]

        model = lw.mechanisms.stephenson_six_bar()
    """
    links = {"coupler": "BCE", "rocker": "DC", "rod": "EF", "output": "GF"}
    joints = ("B crank coupler", "C coupler rocker", "D ground rocker", "E coupler rod")
    return _six_bar("stephenson_six_bar", stephenson_points(START, mode), links, joints, speed)


def _six_bar(
    name: str, points: Mapping[str, Floats], links: Mapping[str, str], joints: Sequence[str], speed: float
) -> Model:
    model = Model(gravity=(0, -9.81, 0), name=name)
    model.body(
        "crank",
        mass=DENSITY * CRANK,
        inertia=(FLYWHEEL / 2, FLYWHEEL / 2, FLYWHEEL),
        position=(points["A"] + points["B"]) / 2,
        omega=(0, 0, speed),
    )
    for link, corners in links.items():
        tube_link(model, link, [points[corner] for corner in corners], DENSITY, RADIUS)
    for joint in ("A ground crank", *joints, "F rod output", "G ground output"):
        point, first, second = joint.split()
        model.revolute(first, second, at=points[point], axis=(0, 0, 1), name=point)
    return assemble(model, weights={"crank": 1e6}).model


def _branches(name: str, mode: int) -> tuple[int, int]:
    if mode not in MODES:
        raise ModelError(f"{name}: mode {mode} does not exist: 1 to 4", code="mode")
    return MODES[mode]


WATT_SIX_BAR = Mechanism(watt_six_bar, t_end=5.0, step=1e-3)
STEPHENSON_SIX_BAR = Mechanism(stephenson_six_bar, t_end=5.0, step=1e-3)
