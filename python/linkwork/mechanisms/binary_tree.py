"""A tree of any size: open branches, no loop."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork import Model, OptionError
from linkwork.arrays import Floats
from linkwork.errors import nearest
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

#: The joints that can be between rods.
JOINTS = ("revolute", "spherical")

#: By how much the two rods at the end of the first turn aside [rad]; half of it at each further level.
FORK = np.pi / 4


def binary_tree(bodies: int = 15, joint: str = "revolute") -> Model:
    """Binary tree of rods that falls from the horizontal.

    Each rod is 1 m long, weighs 1 kg and has a square section of 5 cm. The first hangs from the ground at the
    origin and lies along +x; rods 2 k + 1 and 2 k + 2 hang from the end of rod k and fork to the left and to
    the right. All lie in the plane z = 0 at rest; gravity along -z.

    bodies  number of rods
    joint   between the rods: revolute (about the horizontal across the rod) or spherical

        model = lw.mechanisms.binary_tree(7)
    """
    at_least(1, bodies, "binary_tree: bodies")
    if joint not in JOINTS:
        raise OptionError(
            f"binary_tree: joint '{joint}' is not available{nearest(joint, JOINTS)}", code="unknown_option"
        )
    parent = (np.arange(bodies) - 1) // 2  # the first rod hangs from the ground, -1
    start, along = _rods(parent)
    across = np.cross((0, 0, 1), along)
    model = Model(gravity=(0, 0, -9.81), name="binary_tree")
    rods = model.bodies(
        "rod",
        mass=1.0,
        inertia=square_rod(1.0, 1.0, 0.05),
        position=start + along / 2,
        orientation=from_axes(along, across),
    )
    axis: dict[str, Any] = {"axis": across} if joint == "revolute" else {}
    model.joints(joint, parent, rods, at=start, name="joint", **axis)
    return model


def _rods(parent: NDArray[np.int64]) -> tuple[Floats, Floats]:
    """Where each rod starts (n, 3), and its direction (n, 3), level by level from the ground."""
    n = len(parent)
    heading, start = np.zeros(n), np.zeros((n, 3))
    along = np.zeros((n, 3))
    along[0, 0] = 1.0
    first, fork = 1, FORK
    while first < n:
        level = np.arange(first, min(2 * first + 1, n))
        above = parent[level]
        heading[level] = heading[above] + np.where(level % 2, fork, -fork)
        along[level, 0], along[level, 1] = np.cos(heading[level]), np.sin(heading[level])
        start[level] = start[above] + along[above]
        first, fork = 2 * first + 1, fork / 2
    return start, along


BINARY_TREE = Mechanism(binary_tree, size=Size("bodies"), t_end=2.0, step=1e-3)
