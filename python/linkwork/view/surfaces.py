"""Shapes as triangles with a normal at each corner, for pictures that need no browser."""

from __future__ import annotations

from functools import cache

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.modeling.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere

__all__ = ["Surface", "coil", "cylinder", "surface"]

#: Corners (m, 3, 3) and the unit normals there (m, 3, 3), counterclockwise from outside.
Surface = tuple[Floats, Floats]

#: Of a round shape: sides around, and rings of a ball; where there are many shapes, fewer.
SIDES, RINGS, FEW_SIDES, FEW_RINGS = 28, 16, 10, 6

#: Of a spring: turns, straight pieces of each, corners of the wire's section, and its radius over that of the
#: spring.
TURNS, PIECES, SECTION, WIRE = 7, 20, 6, 0.17

#: Length of a spring over its radius at which its wire is round.
SLENDER = 12.0


def surface(shape: Shape, coarse: bool = False) -> Surface:
    """Of a shape in body coordinates."""
    sides, rings = (FEW_SIDES, FEW_RINGS) if coarse else (SIDES, RINGS)
    if isinstance(shape, Mesh):
        corners, normals = _flat(shape.vertices[shape.triangles])
    elif isinstance(shape, Box):
        corners, normals = _box()
        corners = corners * shape.size
    elif isinstance(shape, Sphere):
        corners, normals = _ball(sides, rings)
        corners = corners * shape.radius
    else:
        assert isinstance(shape, Cylinder | Rod)
        length = (
            shape.length if isinstance(shape, Cylinder) else float(np.linalg.norm(shape.end - shape.start))
        )
        corners, normals = cylinder(sides)
        corners = corners * (shape.radius, shape.radius, length)
    A = rotation.matrix(shape.orientation)
    return shape.position + corners @ A.T, normals @ A.T


def _flat(corners: Floats) -> Surface:
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    return corners, np.repeat(normals[:, None], 3, axis=1)


def _split(quads: Floats) -> Floats:
    """Triangles (2 m, 3, ...) of faces with four corners (m, 4, ...)."""
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


@cache
def _box() -> Surface:
    """Edges of one."""
    square = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]) / 2
    turns = [np.roll(square, shift, axis=1) for shift in range(3)]
    return _flat(_split(np.stack([*turns, *(-turn[::-1] for turn in turns)])))


@cache
def cylinder(sides: int) -> Surface:
    """Radius and length one, about z."""
    angle = 2 * np.pi * np.arange(sides + 1) / sides
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(sides + 1)], axis=1)
    up = np.array([0, 0, 0.5])
    a, b = ring[:-1], ring[1:]
    walls = np.stack([a - up, b - up, b + up, a + up], axis=1)
    out = np.stack([a, b, b, a], axis=1)
    lids = np.concatenate([np.stack([0 * a + up, a + up, b + up], axis=1),
                           np.stack([0 * a - up, b - up, a - up], axis=1)])  # fmt: skip
    corners, normals = _flat(lids)
    return np.concatenate([_split(walls), corners]), np.concatenate([_split(out), normals])


@cache
def _ball(sides: int, rings: int) -> Surface:
    """Radius one; normals are the corners."""
    polar = np.linspace(0, np.pi, rings + 1)[:, None]
    angle = 2 * np.pi * np.arange(sides + 1) / sides
    parts = (np.sin(polar) * np.cos(angle), np.sin(polar) * np.sin(angle), np.cos(polar) + 0 * angle)
    point = np.stack(parts, axis=-1)
    quads = np.stack([point[1:, :-1], point[1:, 1:], point[:-1, 1:], point[:-1, :-1]], axis=2)
    corners = _split(quads.reshape(-1, 4, 3))
    return corners, corners


@cache
def coil() -> Surface:
    """A spring of radius one along z from -1/2 to 1/2, with a straight piece at each end."""
    s = np.linspace(0, 1, TURNS * PIECES + 1)
    turn = np.clip((s - 0.08) / 0.84, 0, 1)
    radius = np.minimum(1, 12 * np.minimum(turn, 1 - turn))
    angle = 2 * np.pi * TURNS * turn
    middle = np.stack([radius * np.cos(angle), radius * np.sin(angle), SLENDER * (s - 0.5)], axis=1)
    along = np.gradient(middle, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    x = rotation.perpendicular(along)
    x[1:-1] = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)[1:-1]
    x -= (x * along).sum(axis=1, keepdims=True) * along
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    y = np.cross(along, x)
    round_ = 2 * np.pi * np.arange(SECTION + 1) / SECTION
    out = np.cos(round_)[:, None] * x[:, None] + np.sin(round_)[:, None] * y[:, None]
    tube = middle[:, None] + WIRE * out
    quads = [np.stack([it[:-1, :-1], it[:-1, 1:], it[1:, 1:], it[1:, :-1]], axis=2).reshape(-1, 4, 3)
             for it in (tube, out)]  # fmt: skip
    return _split(quads[0]) / (1, 1, SLENDER), _split(quads[1])
