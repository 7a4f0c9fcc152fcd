"""
Bicycle
=======

The benchmark of Meijaard, Papadopoulos, Ruina and Schwab (Proceedings of the Royal Society A 463, 2007): four bodies, wheels that roll
without slipping. Linearized about riding upright and straight ahead it weaves when it is slow, capsizes gently when it is fast, and
between 4.29 and 6.02 m/s it balances itself.
"""

import linkwork as lw
import numpy as np
from matplotlib.figure import Figure

BASE, TILT, Y, Z = 1.02, np.pi / 10, (0, 1, 0), (0, 0, 1)


def symmetric(xx, yy, zz, xz=0.0):
    return np.array([[xx, 0, xz], [0, yy, 0], [xz, 0, zz]])


def bicycle(speed):
    model = lw.Model(name="bicycle")
    for name, mass, inertia, at, radius in (
        ("rear wheel", 2.0, symmetric(0.0603, 0.12, 0.0603), (0, 0, 0.3), 0.3),
        ("frame", 85.0, symmetric(9.2, 11.0, 2.8, -2.4), (0.3, 0, 0.9), np.inf),
        ("fork", 4.0, symmetric(0.05892, 0.06, 0.00708, 0.00756), (0.9, 0, 0.7), np.inf),
        ("front wheel", 3.0, symmetric(0.1405, 0.28, 0.1405), (BASE, 0, 0.35), 0.35),
    ):
        model.body(
            name,
            mass=mass,
            inertia=inertia,
            position=at,
            velocity=(speed, 0, 0),
            omega=(0, speed / radius, 0),
            shape=[lw.Cylinder(radius, 0.03, axis=Y)] if np.isfinite(radius) else [],
        )
    for wheel, holder, at in (("rear wheel", "frame", (0, 0, 0.3)), ("front wheel", "fork", (BASE, 0, 0.35))):
        model.rolling_disc("ground", wheel, at=((0, 0, 0), at), axes=(Z, Y), radius=at[2])
        model.revolute(holder, wheel, at=at, axis=Y)
    model.revolute(
        "frame", "fork", at=(BASE + 0.08, 0, 0), axis=(-np.sin(TILT), 0, np.cos(TILT)), name="head"
    )
    return model


found = lw.linearize(bicycle(5.0))
print(found)

# %%
speeds = np.linspace(0.2, 10, 50)
figure = Figure(figsize=(6, 4), layout="constrained")
ax = figure.subplots()
for speed in speeds:
    growth = lw.linearize(bicycle(speed)).eigenvalues.real
    ax.plot(np.full(growth.size, speed), growth, ".", color="tab:blue", markersize=4)
ax.axhspan(-10, 0, xmin=0.429, xmax=0.602, color="tab:green", alpha=0.2)
ax.set(
    ylim=(-10, 6),
    xlim=(0, 10),
    xlabel="speed [m/s]",
    ylabel="growth [1/s]",
    title="where the bicycle balances itself",
)

# %%
# Begun with a roll of 0.2 rad/s it steers into the fall, and comes to ride straight ahead:

model = bicycle(5.0)
v = np.array(model.compiled().v0).reshape(-1, 6)
v[:, 3] += 0.2
v[:, 1] -= 0.2 * np.array([0.3, 0.9, 0.7, 0.35])
start = lw.assemble(model.with_initial_state(np.array(model.compiled().q0).reshape(-1, 7), v)).model
result = lw.simulate(start, t_end=4.0, rtol=1e-8)
view = result.view()

# %%
steering = result.plot(kind="coordinates", joints=["head"])
