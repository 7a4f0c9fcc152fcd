"""IFToMM benchmark A02."""

from __future__ import annotations

from linkwork import Model
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import thin_rod
from linkwork.rotation import from_axes


def four_bar(n: int = 1) -> Model:
    """Row of n four-bar linkages that goes through singular poses (IFToMM benchmark A02).

    2 n + 1 slender rods of 1 m and 1 kg: n + 1 of them stand on the ground at x = 0, 1, ..., n, their tops
    are joined by n others. The tops move along +x with 1 m/s at the start; gravity along -y. Where all rods
    lie down, the mechanism could go on in several ways. In three dimensions its equations are redundant. With
    "rk4" and a step of 1 ms the tops keep their place through these poses to 1e-8 m for 10 s.

    n  number of loops
    """
    at_least(1, n, "four_bar: n")
    model = Model(gravity=(0, -9.81, 0), name="four_bar")
    inertia, upright = thin_rod(mass=1.0, length=1.0), from_axes(x=(0, 1, 0), y=(-1, 0, 0))
    turn, drift = (0, 0, -1), (1, 0, 0)  # rad/s and m/s that give the tops 1 m/s
    posts = [
        model.body(f"post {i}", mass=1.0, inertia=inertia, position=(i, 0.5, 0), orientation=upright,
                   velocity=(0.5, 0, 0), omega=turn)
        for i in range(n + 1)
    ]  # fmt: skip
    beams = [
        model.body(f"beam {i}", mass=1.0, inertia=inertia, position=(i + 0.5, 1, 0), velocity=drift)
        for i in range(n)
    ]
    for i, post in enumerate(posts):
        model.revolute(model.ground, post, at=(i, 0, 0), axis=(0, 0, 1), name=f"pin {i}")
    for i, beam in enumerate(beams):
        model.revolute(posts[i], beam, at=(i, 1, 0), axis=(0, 0, 1), name=f"left {i}")
        model.revolute(posts[i + 1], beam, at=(i + 1, 1, 0), axis=(0, 0, 1), name=f"right {i}")
    return model


FOUR_BAR = Mechanism(four_bar, size=Size("n", lambda n: 2 * n + 1), t_end=10.0, step=1e-3)
