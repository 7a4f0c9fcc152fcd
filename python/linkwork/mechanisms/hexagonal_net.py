"""A hexagonal net, as it is thrown at debris in orbit."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.truss import Indices, add_rods, join_at_nodes

#: By which the center hangs below the corners, over the radius.
DIP = 0.3


def hexagonal_net(rings: int = 5) -> Model:
    """Hexagonal net that hangs slack from three of its corners.

    A node in the middle and hexagons around it, ring k with 6 k nodes, 1 m apart in plan: 1 + 3 k (k + 1)
    nodes with k rings, 631 with 14. Rods of 1 kg/m and square section of 5 cm follow the rings, and one leads
    from each node to the ring inside, 6 k (k + 1) in all, which meet in spherical joints. The nodes lie on a
    paraboloid, so that every side of a ring is bent, and every other corner is held: no equation is
    redundant. Gravity along -z.

    rings  hexagons around the middle

        model = lw.mechanisms.hexagonal_net(3)
    """
    at_least(1, rings, "hexagonal_net: rings")
    model = Model(gravity=(0, 0, -9.81), name="hexagonal_net")
    nodes, ends = _nodes(rings), _ends(rings)
    rods = add_rods(model, nodes[ends[:, 0]], nodes[ends[:, 1]])
    hub = join_at_nodes(model, rods, ends, nodes)
    corners = _first(rings) + 2 * rings * np.arange(3)
    model.joints("spherical", model.ground, hub[corners], at=nodes[corners], name="corner")
    return model


def _first(ring: int) -> int:
    """The number of a ring's first node."""
    return 1 + 3 * ring * (ring - 1)


def _nodes(rings: int) -> Floats:
    """Points (nodes, 3): the middle, then ring by ring, each from the corner on +x."""
    turn = np.pi / 3 * np.arange(7)
    corner = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    plan = [np.zeros((1, 2))]
    for ring in range(1, rings + 1):
        part = np.arange(ring)[:, None] / ring
        plan += [ring * ((1 - part) * corner[side] + part * corner[side + 1]) for side in range(6)]
    flat = np.concatenate(plan)
    height = DIP / rings * (flat**2).sum(axis=1)
    return np.column_stack([flat, height])


def _ends(rings: int) -> Indices:
    """The two nodes of each rod (rods, 2): around each ring, and from it inward."""
    pairs = []
    for ring in range(1, rings + 1):
        place = np.arange(6 * ring)
        node = _first(ring) + place
        pairs.append(np.stack([node, _first(ring) + (place + 1) % (6 * ring)], axis=1))
        side, step = np.divmod(place, ring)
        inner = side * (ring - 1) + np.minimum(step, ring - 1)
        inside = np.zeros_like(node) if ring == 1 else _first(ring - 1) + inner % (6 * (ring - 1))
        pairs.append(np.stack([inside, node], axis=1))
    return np.concatenate(pairs)


HEXAGONAL_NET = Mechanism(
    hexagonal_net, size=Size("rings", lambda rings: 6 * rings * (rings + 1)), t_end=1.0, step=1e-3
)
