"""IFToMM benchmark A04."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

#: The rods go from point to point; the last point is joined to the ground, like the first.
POINTS = np.array([(0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1)], float)
AXES = np.array([(0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0)], float)


def bricard() -> Model:
    """Bricard's mechanism: a closed loop of hinges that moves against the count (IFToMM benchmark A04).

    Five rods of 1 m and 1 kg with square section of 0.1 m and the ground are joined by six revolutes. 30
    equations on 30 coordinates leave one degree of freedom, because one of them is redundant. Gravity along
    -y. With "rk4" and a step of 1 ms the end of the second rod keeps its place to 1e-8 m for 10 s.

        model = lw.mechanisms.bricard()
    """
    model = Model(gravity=(0, -9.81, 0), name="bricard")
    inertia = square_rod(mass=1.0, length=1.0, side=0.1)
    links = [model.ground]
    for k, (start, end) in enumerate(pairwise(POINTS), 1):
        along = from_axes(x=end - start, y=AXES[k - 1])
        rod = model.body(f"rod {k}", mass=1.0, inertia=inertia, position=(start + end) / 2, orientation=along)
        links.append(rod)
    for k, (point, axis) in enumerate(zip(POINTS, AXES, strict=True)):
        model.revolute(links[k], links[(k + 1) % 6], at=point, axis=axis, name=f"hinge {k}")
    return model


BRICARD = Mechanism(bricard, t_end=10.0, step=1e-3)
