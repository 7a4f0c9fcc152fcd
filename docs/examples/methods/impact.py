"""
Impacts as events
=================

A double pendulum hits a wall. At the moment of contact the event gives the lower rod another velocity; the joints answer with impulses
of their own, in the metric of the masses.
"""

import numpy as np
import linkwork as lw

model = lw.Model(name="double pendulum at a wall")
for number, x in enumerate((0.2, 0.6)):
    model.body(f"rod {number}", mass=0.5, inertia=lw.mechanisms.thin_rod(0.5, 0.4), position=(x, 0, 0))
model.revolute("ground", "rod 0", at=(0, 0, 0), axis=(0, 1, 0), name="upper")
model.revolute("rod 0", "rod 1", at=(0.4, 0, 0), axis=(0, 1, 0), name="lower")
WALL = -0.15


def tip(state):
    rod = state.body("rod 1")
    A = lw.rotation.matrix(rod.orientation)
    arm = A @ [0.2, 0, 0]
    return rod.position + arm, rod.velocity + np.cross(A @ rod.omega, arm)


def distance(t, state):
    return tip(state)[0][0] - WALL


def hit(t, state):
    rod = state.body("rod 1")
    rod.velocity = rod.velocity - np.array([1.6 * tip(state)[1][0], 0, 0])


result = lw.simulate(
    model, t_end=1.2, rtol=1e-8, events=lw.Event(distance, direction=-1, change=hit, name="wall")
)
for event in result.events:
    print(f"{event.name} at {event.t:.4f} s")

# %%
view = result.view()

# %%
energy = result.plot(kind="energy")
