"""The one closed chain of four hinges that moves without parallel or concurrent axes."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.equations.assembly import assemble
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

#: Twists between the axes of a link, of the ground and of the crank [rad]; opposite links are alike.
ALPHA, BETA = np.radians(30.0), np.radians(90.0)
BASE = 0.5  # length of the ground and the coupler [m]
CRANK = BASE * np.sin(BETA) / np.sin(ALPHA)  # Bennett's condition: a / sin(alpha) = b / sin(beta)

START = np.radians(70.0)  # angle of the crank at the start


def follower_angle(crank_angle: float) -> float:
    """Angle of the second hinge at one of the first [rad], both as of Denavit and Hartenberg.

    tan(theta_1 / 2) tan(theta_2 / 2) = sin((alpha + beta) / 2) / sin((alpha - beta) / 2)
    """
    ratio = np.sin((ALPHA + BETA) / 2) / np.sin((ALPHA - BETA) / 2)
    return float(2 * np.arctan2(ratio * np.cos(crank_angle / 2), np.sin(crank_angle / 2)))


def hinges(crank_angle: float) -> tuple[Floats, Floats]:
    """Feet (4, 3) of the common normals on the axes [m], and the axes (4, 3), around the loop."""
    other = follower_angle(crank_angle)
    frame, points, axes = np.eye(4), [], []
    for theta, length, twist in (
        (crank_angle, CRANK, BETA),
        (other, BASE, ALPHA),
        (-crank_angle, CRANK, BETA),
        (-other, BASE, ALPHA),
    ):
        points.append(frame[:3, 3])
        axes.append(frame[:3, 2])
        frame = frame @ _link(theta, length, twist)
    return np.array(points), np.array(axes)


def bennett(speed: float = 6.0) -> Model:
    """Bennett's linkage: four hinges in space that move although the count forbids it.

    Three rods and the ground, opposite ones alike: lengths a = 0.5 m with a twist of 30 degrees between the
    axes of their ends, and b = 1 m with 90 degrees, in Bennett's condition a / sin(alpha) = b /
    sin(beta). Rods of 1 kg/m, 4 cm square; gravity along -z. 20 equations on 18 coordinates are of rank 17:
    one degree of freedom, where Gruebler's formula counts -2, and three redundant equations. G. T. Bennett,
    A new mechanism, Engineering 76, 1903; closure as in Hunt, Kinematic Geometry of Mechanisms, 1978.
    Dimensions our own.

    speed  of the crank at the start [rad/s]

        model = lw.mechanisms.bennett()
    """
    model = Model(gravity=(0, 0, -9.81), name="bennett")
    points, axes = hinges(START)
    links = [model.ground]
    for k, name in ((1, "crank"), (2, "coupler"), (3, "follower")):
        start, end = points[k - 1], points[k]
        length = float(np.linalg.norm(end - start))
        turn = axes[0] if k == 1 else np.zeros(3)
        along = from_axes(x=end - start, y=axes[k - 1])
        links.append(
            model.body(
                name,
                mass=length,
                inertia=square_rod(mass=length, length=length, side=0.04),
                position=(start + end) / 2,
                orientation=along,
                velocity=np.cross(speed * turn, (end - start) / 2),
                omega=(0.0, speed, 0.0) if k == 1 else (0.0, 0.0, 0.0),  # y is along the first axis
            )
        )
    for k in range(4):
        model.revolute(links[k], links[(k + 1) % 4], at=points[k], axis=axes[k], name=f"hinge {k + 1}")
    return assemble(model, weights={"crank": 1e6}).model


def _link(theta: float, length: float, twist: float) -> Floats:
    """From an axis to the next: a turn about z, a shift and a turn along x (Denavit and Hartenberg 1955)."""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(twist), np.sin(twist)
    return np.array(
        [[c, -s * ca, s * sa, length * c], [s, c * ca, -c * sa, length * s], [0, sa, ca, 0], [0, 0, 0, 1]]
    )


BENNETT = Mechanism(bennett, t_end=5.0, step=5e-4)
