"""A chain of any number of links."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwork import Model, OptionError
from linkwork.arguments import is_one_of
from linkwork.errors import nearest
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import square_rod

#: The joints that can be between links, with what each needs beside its point.
AXES: dict[str, dict[str, Any]] = {
    "revolute": {"axis": (0, 1, 0)},
    "spherical": {},
    "universal": {"axes": ((0, 1, 0), (0, 0, 1))},
}


def chain(bodies: int = 10, joint: str = "revolute") -> Model:
    """Chain of rods that falls from the horizontal.

    Each link is 1 m long, weighs 1 kg and has a square section of 5 cm. The first hangs from the ground at
    the origin, the chain lies along +x at rest; gravity along -z.

    bodies  number of links
    joint   between the links: revolute (about y), spherical or universal

        model = lw.mechanisms.chain(10)
    """
    at_least(1, bodies, "chain: bodies")
    if not is_one_of(joint, AXES):
        raise OptionError(
            f"chain: joint '{joint!s:.80}' is not available{nearest(str(joint), AXES)}", code="unknown_option"
        )
    model = Model(gravity=(0, 0, -9.81), name="chain")
    x_axis = np.array([1.0, 0.0, 0.0])
    ends = np.arange(bodies)[:, None] * x_axis
    links = model.bodies("link", mass=1.0, inertia=square_rod(1.0, 1.0, 0.05), position=ends + x_axis / 2)
    earlier = np.arange(-1, bodies - 1)  # the first link hangs from the ground, -1
    model.joints(joint, earlier, links, at=ends, name="joint", **AXES[joint])
    return model


CHAIN = Mechanism(chain, size=Size("bodies"), t_end=2.0, step=1e-3)
