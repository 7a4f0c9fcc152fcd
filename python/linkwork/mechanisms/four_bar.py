"""IFToMM benchmark A02."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import thin_rod
from linkwork.rotation import from_axes


def four_bar(n: int = 1) -> Model:
    """Row of n four-bar linkages that goes through singular poses (IFToMM benchmark A02).

    2 n + 1 slender rods of 1 m and 1 kg: n + 1 of them stand on the ground at x = 0, 1, ..., n, their tops
    are joined by n others. The tops move along +x with 1 m/s at the start; gravity along -y. Where all rods
    lie down, the mechanism could go on in several ways. In three dimensions its equations are redundant. With
    "rk4" and a step of 1 ms the tops keep their place through these poses to 1e-8 m for 10 s.

    n  number of loops

        model = lw.mechanisms.four_bar(3)
    """
    at_least(1, n, "four_bar: n")
    model = Model(gravity=(0, -9.81, 0), name="four_bar")
    upright = from_axes(x=(0, 1, 0), y=(-1, 0, 0))
    turn, drift = (0, 0, -1), (1, 0, 0)  # rad/s and m/s that give the tops 1 m/s
    inertia = thin_rod(mass=1.0, length=1.0)
    posts = model.bodies(
        [f"post {i}" for i in range(n + 1)],
        mass=1.0,
        inertia=inertia,
        position=_row(n + 1, 0.0, 0.5),
        orientation=upright,
        velocity=(0.5, 0, 0),
        omega=turn,
    ).indices
    names = [f"beam {i}" for i in range(n)]
    at = _row(n, 0.5, 1.0)
    beams = model.bodies(names, mass=1.0, inertia=inertia, position=at, velocity=drift).indices
    names = [f"pin {i}" for i in range(n + 1)]
    model.joints("revolute", model.ground, posts, at=_row(n + 1, 0.0, 0.0), axis=(0, 0, 1), name=names)
    names = [f"{side} {i}" for i in range(n) for side in ("left", "right")]
    ends = np.stack([np.arange(n), np.arange(1, n + 1)], axis=1).ravel()  # of the beams: number of the post
    at = _row(n + 1, 0.0, 1.0)[ends]
    model.joints("revolute", posts[ends], np.repeat(beams, 2), at=at, axis=(0, 0, 1), name=names)
    return model


def _row(count: int, x: float, y: float) -> Floats:
    """Points (count, 3) at x, x + 1, ..."""
    return np.stack([x + np.arange(count), np.full(count, y), np.zeros(count)], axis=1)


FOUR_BAR = Mechanism(four_bar, size=Size("n", lambda n: 2 * n + 1), t_end=10.0, step=1e-3)
