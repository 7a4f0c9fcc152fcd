"""A net that is thrown over a ball."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.mechanisms.hub_net import RADIUS, add_knotted_net
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.net import net_nodes, net_rods
from linkwork.modeling.contact import contact_hysteresis
from linkwork.modeling.shapes import Sphere

#: Of the ball: radius over the width of the net, density [kg/m3] of what fills it.
BALL, DENSITY = 0.15, 50.0

#: At which the net flies [m/s], and how far it is from the ball at first [m].
SPEED, GAP = 5.0, 0.02

#: Of a knot on the ball: [N/m^1.5], hysteresis for a restitution of 0.5.
STIFFNESS, RESTITUTION = 1e6, 0.5


def capture_net(n: int = 10) -> Model:
    """Net that flies at a ball in space and wraps itself around it.

    The knots and rods of "hub_net", free, with no gravity: 12 n (n - 1) equations, none of them redundant.
    The net, a shallow bowl, flies along +z with 5 m/s; in the bowl, 2 cm before a knot in its middle, floats
    a ball whose radius is 0.15 of the width of the net. Every knot presses on it by contact without friction
    (Hertz's exponent, with the hysteresis of a restitution of 0.5); between knots rods pass through the ball.
    Momentum stays, and what contacts take is counted as work.

    n  knots on a side, three or more

        model = lw.mechanisms.capture_net(5)
    """
    at_least(3, n, "capture_net: n")
    model = Model(gravity=(0, 0, 0), name="capture_net")
    nodes = net_nodes(n)
    middle = nodes[(n // 2) * n + n // 2]
    knots = add_knotted_net(model, nodes, net_rods(n), velocity=np.array([0.0, 0.0, SPEED]))
    radius = BALL * float(np.ptp(nodes[:, 0]))
    mass = DENSITY * 4 / 3 * np.pi * radius**3
    moment = 0.4 * mass * radius**2
    center = middle + np.array([0.0, 0.0, radius + RADIUS + GAP])
    ball = model.body("ball", mass=mass, inertia=(moment, moment, moment), position=center)
    ball.shape(Sphere(radius))
    model.forces(
        "sphere_sphere_contact", ball, knots, at=(center, nodes), radius_a=radius, radius_b=RADIUS,
        stiffness=STIFFNESS, hysteresis=contact_hysteresis("flores", RESTITUTION), name="knots on the ball",
    )  # fmt: skip
    return model


CAPTURE_NET = Mechanism(
    capture_net, size=Size("n", lambda n: n * n + 2 * n * (n - 1) + 1), t_end=0.2, step=1e-4
)
