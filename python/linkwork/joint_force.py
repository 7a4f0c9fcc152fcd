"""A force of the user's own along a free coordinate of a joint, as one on all bodies."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import rotation
from linkwork.errors import ModelError
from linkwork.joint_coordinates import COORDINATES, side

Floats = NDArray[np.float64]

_REST = np.zeros((1, 6))
_GROUND = np.array([[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]])


def along_coordinate(
    function: Callable[[float, float, float], ArrayLike],
    which: str,
    bodies: tuple[int, int],
    origin: Floats,
    frame: Floats,
    name: str,
) -> Callable[[float, Floats, Floats], Floats]:
    """Forces on n bodies (n, 6) from Q = function(t, x, x_dot), x the coordinate of a joint of `bodies`.

    Q does the work Q dx: of an angle, torques Q and -Q about its axis; of a displacement z_a . d, forces
    along z_a on the point of b, and back on a in the same line.
    """

    def whole(t: float, q: Floats, v: Floats) -> Floats:
        ends = [(q[[k]], v[[k]]) if k >= 0 else (_GROUND, _REST) for k in bodies]
        i, j = (side(*end, s, C) for end, s, C in zip(ends, origin, frame, strict=True))
        x = COORDINATES[which](np.array([t]), i, j)
        given = function(t, float(x.value[0]), float(x.rate[0]))
        try:
            Q = np.asarray(given, dtype=float)
        except (TypeError, ValueError) as error:
            raise ModelError(
                f"joint force '{name}': returned {given!r}, not a number", code="shape"
            ) from error
        if Q.shape != ():
            raise ModelError(f"joint force '{name}': returned shape {Q.shape}, not a number", code="shape")
        axis = Q * (j if which == "angle_b" else i).axes[0, :, 2]
        out = np.zeros_like(v)
        for body, sign in zip(bodies, (-1.0, 1.0), strict=True):
            if body < 0:
                continue
            torque = axis
            if which == "displacement":
                out[body, :3] = sign * axis
                torque = np.cross(j.point[0] - q[body, :3], axis)
            out[body, 3:] = sign * rotation.matrix(q[body, 3:]).T @ torque
        return out

    return whole
