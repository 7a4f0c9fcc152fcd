"""Surfaces of machine elements that are no box, ball or cylinder: toothed wheels, spiral springs, plates."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

Surface = tuple[Floats, NDArray[np.int32]]  # vertices (n, 3), triangles (m, 3) counterclockwise from outside

#: Corners of a tooth: the angle from its middle in parts of the pitch; 1 at its tip, -1 at its root.
TOOTH = ((-0.5, -1), (-0.32, -1), (-0.16, 1), (0.16, 1), (0.32, -1))

#: Height of a tooth above and below the pitch circle, and depth of a ring behind it, in modules.
HEIGHT, RING = 0.9, 3.0

#: Of a spiral spring: turns, straight pieces of each, inner radius, width and height of the ribbon.
TURNS, PIECES, INNER, WIDTH, BAND = 2.5, 16, 0.3, 0.1, 0.5


@cache
def wheel(teeth: int) -> Surface:
    """A spur gear of pitch radius one and width one, about z, with a tooth at x; negative: a ring gear."""
    count, module = abs(teeth), 2 / abs(teeth)
    angle = np.concatenate(
        [2 * np.pi / count * (k + np.array([part for part, _ in TOOTH])) for k in range(count)]
    )
    height = np.tile([HEIGHT * module * side for _, side in TOOTH], count)
    if teeth > 0:
        return _band(0.3 * np.ones_like(angle), 1 + height, angle, 0.5, closed=True)
    return _band(1 - height, (1 + RING * module) * np.ones_like(angle), angle, 0.5, closed=True)


@cache
def spiral() -> Surface:
    """A ribbon wound across z, of outer radius one."""
    angle = np.linspace(0, 2 * np.pi * TURNS, int(TURNS * PIECES) + 1)
    radius = np.linspace(INNER, 1 - WIDTH, len(angle))
    return _band(radius, radius + WIDTH, angle, BAND / 2, closed=False)


def plate(points: Floats, half: float) -> Surface:
    """What the convex hull of points (k, 2) covers, from -half to half along z."""
    from scipy.spatial import ConvexHull

    outline = points[ConvexHull(points).vertices]  # counterclockwise
    count, k = len(outline), np.arange(len(outline))
    n = (k + 1) % count
    vertices = np.vstack([np.column_stack([outline, np.full(count, z)]) for z in (-half, half)])
    fan = np.stack([np.zeros(count - 2, int), k[1:-1], k[2:]], axis=1)
    walls = [np.stack(three, axis=1) for three in ((k, n, n + count), (k, n + count, k + count))]
    return vertices, np.concatenate([fan[:, ::-1], fan + count, *walls]).astype(np.int32)


def _band(inner: Floats, outer: Floats, angle: Floats, half: float, *, closed: bool) -> Surface:
    """What lies between two curves (radius over angle) in a plane, extruded from -half to half along z."""
    count = len(angle)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    corners = [(inner, -half), (outer, -half), (outer, half), (inner, half)]  # of a section, counterclockwise
    vertices = np.stack(
        [np.column_stack([radius[:, None] * circle, np.full(count, z)]) for radius, z in corners], axis=1
    ).reshape(-1, 3)
    sections = np.arange(count if closed else count - 1)
    here, there = 4 * sections, 4 * ((sections + 1) % count)
    sides = [(here + c, there + c, there + (c + 1) % 4, here + (c + 1) % 4) for c in range(4)]
    triangles = [np.stack(three, axis=1) for a, b, c, d in sides for three in ((a, b, c), (a, c, d))]
    if not closed:
        last = 4 * (count - 1)
        triangles.append(
            np.array([[0, 1, 2], [0, 2, 3], [last, last + 2, last + 1], [last, last + 3, last + 2]])
        )
    return vertices, np.concatenate(triangles).astype(np.int32)
