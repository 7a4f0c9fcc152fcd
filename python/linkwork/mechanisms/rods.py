"""Moments of inertia of rods along their x axis."""

from __future__ import annotations

import numpy as np

from linkwork.arrays import Floats, Number
from linkwork.mechanisms.mechanism import between

__all__ = ["square_rod", "thin_rod"]


def square_rod(mass: Number, length: Number, side: Number) -> tuple[float, float, float]:
    """
    Principal moments [kg m2] of a rod of square section: m s^2 / 6, m (l^2 + s^2) / 12 twice.

        model.body("bar", mass=0.3, inertia=lw.mechanisms.square_rod(0.3, length=1.0, side=0.01))

    ModelError: what is no number, or negative.
    """
    _check("square_rod", mass=mass, length=length, side=side)
    across = float(mass * (length**2 + side**2) / 12)
    return float(mass * side**2 / 6), across, across


def thin_rod(mass: Number, length: Number) -> tuple[float, float, float]:
    """Principal moments [kg m2] of a rod in plane motion: m l^2 / 1200 about its own axis, m l^2 / 12 twice.

    Plane motion never feels the first, which is a choice: it is not zero, so that the mass matrix stays
    regular. Motion in space does; there `square_rod` has that of a real section.

        model.body("bar", mass=0.3, inertia=lw.mechanisms.thin_rod(0.3, length=1.0))

    ModelError: what is no number, or negative.
    """
    _check("thin_rod", mass=mass, length=length)
    across = float(mass * length**2 / 12)
    return across / 100, across, across


def _check(who: str, **sizes: Number) -> None:
    """ModelError: what is no number, or negative."""
    for what, size in sizes.items():
        between(0.0, size, np.inf, f"{who}: {what}")


def square_rods(mass: Floats, length: Floats, side: float) -> Floats:
    """Of many rods (n, 3)."""
    across = mass * (length**2 + side**2) / 12
    return np.stack([mass * side**2 / 6, across, across], axis=1)
