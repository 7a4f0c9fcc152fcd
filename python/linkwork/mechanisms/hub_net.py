"""A net whose knots are bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.net import net_nodes, net_rods
from linkwork.mechanisms.truss import Indices, add_rods
from linkwork.modeling.handles import Body, Range

#: Of a knot [kg], [m].
KNOT, RADIUS = 0.5, 0.1


def hub_net(n: int = 10) -> Model:
    """Square net of knots and rods that hangs slack from its four corners.

    n x n knots, 1 m apart, are balls of 0.5 kg and 10 cm radius; 2 n (n - 1) rods of 1 kg/m with square
    section of 5 cm lead from the surface of one to that of the next. Each end is a spherical joint, so that
    there are 12 n (n - 1) equations, and 12 more at the corners; none is redundant, because every row and
    column is bent, as in "net". With n = 100 bodies and joints are those that He et al. (2026) count in the
    net of their M-ABD: 29 800, and 118 800 equations; masses and pose are ours. Gravity along -z.

    n  knots on a side, three or more

        model = lw.mechanisms.hub_net(4)
    """
    at_least(3, n, "hub_net: n")
    model = Model(gravity=(0, 0, -9.81), name="hub_net")
    nodes, ends = net_nodes(n), net_rods(n)
    knots = add_knotted_net(model, nodes, ends)
    corners = np.array([0, n - 1, n * (n - 1), n * n - 1])
    model.joints("spherical", model.ground, knots.indices[corners], at=nodes[corners], name="corner")
    return model


def add_knotted_net(
    model: Model, nodes: Floats, ends: Indices, velocity: Floats | None = None
) -> Range[Body]:
    """The knots at nodes (n, 3), with rods between them by the numbers of their ends (rods, 2), all with one
    velocity (3,).
    """
    moving: dict[str, Any] = {} if velocity is None else {"velocity": velocity}
    moment = 0.4 * KNOT * RADIUS**2
    knots = model.bodies("knot", mass=KNOT, inertia=(moment, moment, moment), position=nodes, **moving)
    start, end = nodes[ends[:, 0]], nodes[ends[:, 1]]
    along = RADIUS * (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
    rods = add_rods(model, start + along, end - along, **moving)
    for side, point in enumerate((start + along, end - along)):
        model.joints("spherical", knots.indices[ends[:, side]], rods, at=point, name=("tail", "head")[side])
    return knots


HUB_NET = Mechanism(hub_net, size=Size("n", lambda n: n * n + 2 * n * (n - 1)), t_end=1.0, step=1e-3)
