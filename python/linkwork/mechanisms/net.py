"""A net of any size: many closed loops."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

Indices = NDArray[np.int64]

NO_ROD = -1


def net(n: int = 10) -> Model:
    """Square net of rods that hangs slack from its four corners.

    n x n nodes, joined along rows and columns by 2 n (n - 1) rods of 1 m and 1 kg with square section of 5
    cm, which meet in spherical joints. The nodes lie on P(i, j) = c(i) + d(j), with c and d polygons on a
    quarter of a circle: so all rods have the same length, and because every row and column is bent, no
    equation is redundant. Gravity along -z.

    n  nodes on a side, three or more

        model = lw.mechanisms.net(4)
    """
    at_least(3, n, "net: n")
    model = Model(gravity=(0, 0, -9.81), name="net")
    nodes = _nodes(n)
    ends, at_node = _rods(n)
    start, end = nodes[ends[:, 0]], nodes[ends[:, 1]]
    along = from_axes(end - start, np.cross((0, 0, 1), end - start))
    rods = model.bodies(
        "rod", mass=1.0, inertia=square_rod(1.0, 1.0, 0.05), position=(start + end) / 2, orientation=along
    )

    hub, (node, other) = _stars(at_node)
    model.joints("spherical", rods.indices[hub[node]], rods.indices[other], at=nodes[node], name="node")
    corners = np.array([0, n - 1, n * (n - 1), n * n - 1])
    model.joints("spherical", model.ground, rods.indices[hub[corners]], at=nodes[corners], name="corner")
    return model


def _nodes(n: int) -> Floats:
    """Points (n * n, 3), node i n + j at c(i) + d(j)."""
    slope = np.linspace(-np.pi / 4, np.pi / 4, n - 1)
    across, down = (np.concatenate([[0.0], np.cumsum(step)]) for step in (np.cos(slope), np.sin(slope)))
    points = np.empty((n, n, 3))
    points[..., 0], points[..., 1] = across[:, None], across
    points[..., 2] = down[:, None] + down
    return points.reshape(-1, 3)


def _rods(n: int) -> tuple[Indices, Indices]:
    """The two nodes of each rod (rods, 2), and the rods at each node (n * n, 4) or NO_ROD."""
    node = np.arange(n * n).reshape(n, n)
    rows = np.stack([node[:-1].ravel(), node[1:].ravel()], axis=1)
    columns = np.stack([node[:, :-1].ravel(), node[:, 1:].ravel()], axis=1)
    at_node = np.full((n, n, 4), NO_ROD)
    number = np.arange(len(rows))
    at_node[1:, :, 0] = at_node[:-1, :, 1] = number.reshape(n - 1, n)
    at_node[:, 1:, 2] = at_node[:, :-1, 3] = len(rows) + number.reshape(n, n - 1)
    return np.concatenate([rows, columns]), at_node.reshape(-1, 4)


def _stars(at_node: Indices) -> tuple[Indices, tuple[Indices, Indices]]:
    """At each node the first rod is the hub (n * n,); pairs (node, rod) are the other rods, joined to it."""
    first = np.argmax(at_node != NO_ROD, axis=1)
    hub = at_node[np.arange(len(at_node)), first]
    others = (at_node != NO_ROD) & (np.arange(4) != first[:, None])
    return hub, (np.nonzero(others)[0], at_node[others])


NET = Mechanism(net, size=Size("n", lambda n: 2 * n * (n - 1)), t_end=2.0, step=1e-3)
