"""Rods between nodes, joined there by spherical joints: what nets and lattices are made of."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.mechanisms.rods import square_rods
from linkwork.modeling.handles import Body, Range
from linkwork.modeling.model import Model
from linkwork.rotation import from_axes

Indices = NDArray[np.int64]

#: Of the rods [kg/m], [m].
MASS_PER_LENGTH, SIDE = 1.0, 0.05

#: A rod this near to the vertical [cosine of the angle] takes another direction across.
STEEP = 0.9


def add_rods(model: Model, start: Floats, end: Floats, **moving: Any) -> Range[Body]:
    """Rods from points to points (rods, 3), along their x axes, of square section; `moving`: velocities."""
    between = end - start
    length = np.linalg.norm(between, axis=1)
    steep = np.abs(between[:, 2]) > STEEP * length
    up = np.where(steep[:, None], (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    mass = MASS_PER_LENGTH * length
    return model.bodies(
        "rod",
        mass=mass,
        inertia=square_rods(mass, length, SIDE),
        position=(start + end) / 2,
        orientation=from_axes(between, np.cross(up, between)),
        **moving,
    )


def join_at_nodes(model: Model, rods: Range[Body], ends: Indices, nodes: Floats) -> Indices:
    """Spherical joints at the nodes, by the numbers of each rod's two (rods, 2); the first rod of each node.

    The first rod is the hub: every other one at the node is joined to it.
    """
    rod = np.repeat(np.arange(len(ends)), 2)
    order = np.argsort(ends.ravel(), kind="stable")
    node, rod = ends.ravel()[order], rod[order]
    first = np.searchsorted(node, np.arange(len(nodes)))
    other = np.ones(len(node), dtype=bool)
    other[first] = False
    hub = rod[first]
    pairs = rods.indices[hub[node[other]]], rods.indices[rod[other]]
    model.joints("spherical", *pairs, at=nodes[node[other]], name="node")
    return np.asarray(rods.indices[hub], dtype=np.int64)


def bent(count: int, slope: float) -> tuple[Floats, Floats]:
    """Across and up: a polygon of unit sides whose slope goes evenly from -slope to slope [rad]."""
    angle = np.linspace(-slope, slope, count - 1)
    across, up = (np.concatenate([[0.0], np.cumsum(step)]) for step in (np.cos(angle), np.sin(angle)))
    return across, up
