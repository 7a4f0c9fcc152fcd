"""A cubic lattice of any size: loops in all three directions."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.truss import Indices, add_rods, bent, join_at_nodes

#: Of the rods at the ends of each line [rad].
SLOPE = 0.4


def lattice(n: int = 3) -> Model:
    """Cubic lattice of rods that hangs slack from two of its upper corners.

    n x n x n cells: (n + 1)^3 nodes, joined along the three directions by 3 n (n + 1)^2 rods of 1 m and 1 kg
    with square section of 5 cm, which meet in spherical joints. The nodes lie on P(i, j, k) = c(i) + d(j) +
    e(k), with polygons on arcs of a circle: so all rods have the same length, and because every line is bent
    and opposite corners are held, no equation is redundant. Nothing braces the cells: they fold as those of a
    net do. Gravity along -z.

    n  cells along an edge

        model = lw.mechanisms.lattice(2)
    """
    at_least(1, n, "lattice: n")
    model = Model(gravity=(0, 0, -9.81), name="lattice")
    side = n + 1
    across, up = bent(side, SLOPE)
    points = np.zeros((side, side, side, 3))
    points[..., 0] += across[:, None, None]
    points[..., 1] += across[:, None] + up  # e is bent, too
    points[..., 2] += up[:, None, None] + up[:, None] - across
    nodes = points.reshape(-1, 3)

    ends = _ends(side)
    rods = add_rods(model, nodes[ends[:, 0]], nodes[ends[:, 1]])
    hub = join_at_nodes(model, rods, ends, nodes)
    corners = np.array([0, n * side + n]) * side
    model.joints("spherical", model.ground, hub[corners], at=nodes[corners], name="corner")
    return model


def _ends(side: int) -> Indices:
    """The two nodes of each rod (rods, 2)."""
    node = np.arange(side**3).reshape(side, side, side)
    pairs = [(node[:-1], node[1:]), (node[:, :-1], node[:, 1:]), (node[..., :-1], node[..., 1:])]
    return np.concatenate([np.stack([a.ravel(), b.ravel()], axis=1) for a, b in pairs])


LATTICE = Mechanism(lattice, size=Size("n", lambda n: 3 * n * (n + 1) ** 2), t_end=1.0, step=1e-3)
