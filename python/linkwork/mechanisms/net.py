"""A net of any size: many closed loops."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import square_rod
from linkwork.mechanisms.truss import Indices, bent, join_at_nodes
from linkwork.rotation import from_axes


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
    nodes, ends = net_nodes(n), net_rods(n)
    start, end = nodes[ends[:, 0]], nodes[ends[:, 1]]
    along = from_axes(end - start, np.cross((0, 0, 1), end - start))
    rods = model.bodies(
        "rod", mass=1.0, inertia=square_rod(1.0, 1.0, 0.05), position=(start + end) / 2, orientation=along
    )
    hub = join_at_nodes(model, rods, ends, nodes)
    corners = np.array([0, n - 1, n * (n - 1), n * n - 1])
    model.joints("spherical", model.ground, hub[corners], at=nodes[corners], name="corner")
    return model


def net_nodes(n: int) -> Floats:
    """Points (n * n, 3), node i n + j at c(i) + d(j)."""
    across, down = bent(n, np.pi / 4)
    points = np.empty((n, n, 3))
    points[..., 0], points[..., 1] = across[:, None], across
    points[..., 2] = down[:, None] + down
    return points.reshape(-1, 3)


def net_rods(n: int) -> Indices:
    """The two nodes of each rod (rods, 2)."""
    node = np.arange(n * n).reshape(n, n)
    rows = np.stack([node[:-1].ravel(), node[1:].ravel()], axis=1)
    columns = np.stack([node[:, :-1].ravel(), node[:, 1:].ravel()], axis=1)
    return np.concatenate([rows, columns])


NET = Mechanism(net, size=Size("n", lambda n: 2 * n * (n - 1)), t_end=2.0, step=1e-3)
