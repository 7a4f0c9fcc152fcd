"""A folded rope whose end is let go."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

#: Of a link [m], [kg], [m].
LENGTH, MASS, SIDE = 0.1, 0.05, 0.02

#: Links of the bend, each of which turns by the same angle, and the fewest of a rope.
BEND, FEWEST = 7, 12


def rope(links: int = 100) -> Model:
    """Rope that is folded once, held at one end and let go at the other.

    Links of 10 cm, 50 g and a square section of 2 cm, joined by spherical joints: one half hangs from the
    ground at the origin, a bend of 7 links leads to the other half, which begins beside it and falls; gravity
    along -z. Energy is conserved, so the free half falls faster than freely (Calkin and March, 1989), by a
    factor that grows as it becomes short. The ground is out of reach. No equation is redundant. Under the
    weight of half the rope the held half is stiff: with n links its fastest oscillation has about
    sqrt(24 g n / l) rad/s, which limits the step.

    links  number of them, 12 or more

        model = lw.mechanisms.rope(20)
    """
    at_least(FEWEST, links, "rope: links")
    model = Model(gravity=(0, 0, -9.81), name="rope")
    down = (links - BEND) // 2
    turn = np.zeros(links)  # of the direction, from downward
    turn[down : down + BEND] = np.pi * np.arange(1, BEND + 1) / (BEND + 1)
    turn[down + BEND :] = np.pi
    along = np.stack([np.sin(turn), np.zeros(links), -np.cos(turn)], axis=1)
    ends = np.concatenate([np.zeros((1, 3)), LENGTH * np.cumsum(along, axis=0)])
    rods = model.bodies(
        "link",
        mass=MASS,
        inertia=square_rod(MASS, LENGTH, SIDE),
        position=(ends[:-1] + ends[1:]) / 2,
        orientation=from_axes(along, (0, 1, 0)),
    )
    model.joints("spherical", np.arange(-1, links - 1), rods, at=ends[:-1], name="joint")
    return model


ROPE = Mechanism(rope, size=Size("links"), t_end=1.0, step=2e-4)
