"""Linkages that move in the plane z = 0: how their points follow from lengths, and links made of tube."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.errors import ModelError
from linkwork.modeling.handles import Body

__all__ = ["meet", "polar", "tube_link"]


def polar(length: float, angle: float) -> Floats:
    """Vector (3,) of this length [m] at an angle from x [rad]."""
    return length * np.array([np.cos(angle), np.sin(angle), 0.0])


def meet(a: Floats, b: Floats, from_a: float, from_b: float, side: float = 1.0) -> Floats:
    """The point (3,) at distances `from_a`, `from_b` [m] from the points a and b, where two links meet.

    It is to the left of the way from a to b with `side` 1, to the right with -1: the two assembly modes.
    ModelError: the links are too short or too long to meet.
    """
    way = b - a
    distance = float(np.linalg.norm(way))
    along = (distance**2 + from_a**2 - from_b**2) / (2 * distance)
    across = from_a**2 - along**2
    if across < 0:
        raise ModelError(
            f"links of {from_a:g} m and {from_b:g} m do not meet over a distance of {distance:g} m",
            code="no_assembly",
        )
    ahead = way / distance
    left = np.array([-ahead[1], ahead[0], 0.0])
    point: Floats = a + along * ahead + side * np.sqrt(across) * left
    return point


def tube_link(
    model: Model, name: str, points: ArrayLike, density: float, radius: float, omega: float = 0.0
) -> Body:
    """Add a link: thin-walled tubes from each of its points (k, 3) to each other, welded at their ends.

    density  mass of tube for its length [kg/m]       radius  of the tubes [m]
    omega    angular velocity about z [rad/s]; the velocity of the center is left to lw.assemble

    A tube has m r^2 about itself and m (r^2 / 2 + l^2 / 12) across; the body's axes are the inertial ones.
    """
    pairs = np.array(list(combinations(np.asarray(points, dtype=float), 2)))
    along = pairs[:, 1] - pairs[:, 0]
    length = np.linalg.norm(along, axis=1)
    mass, middle = density * length, pairs.mean(axis=1)
    center = mass @ middle / mass.sum()
    J = np.zeros((3, 3))
    for m, long, u, d in zip(mass, length, along / length[:, None], middle - center, strict=True):
        own, across = np.outer(u, u), m * (radius**2 / 2 + long**2 / 12)
        J += m * radius**2 * own + across * (np.eye(3) - own) + m * (d @ d * np.eye(3) - np.outer(d, d))
    return model.body(name, mass=float(mass.sum()), inertia=J, position=center, omega=(0.0, 0.0, omega))
