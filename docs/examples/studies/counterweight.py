"""
The best counterweight
======================

A slider-crank shakes its frame. A counterweight opposite to the crank pin cancels what rotates; what goes to and fro it can only
turn into another direction. A sweep finds the mass whose largest shaking force is least.
"""

import numpy as np
from matplotlib.figure import Figure

import linkwork as lw

CRANK, ROD, SPEED = 0.05, 0.25, 60.0  # m, m, rad/s
PISTON, ROD_MASS = 0.6, 0.2  # kg


def build(counterweight=0.0):
    """The counterweight sits at the crank's radius, opposite to the pin."""
    model = lw.Model(gravity=(0, 0, 0), name="slider-crank")
    model.body("crank", mass=0.5 + counterweight, inertia=(0.01, 0.01, 0.01),
               position=(-CRANK * counterweight / (0.5 + counterweight), 0, 0))  # fmt: skip
    model.body(
        "rod", mass=ROD_MASS, inertia=lw.mechanisms.thin_rod(ROD_MASS, ROD), position=(CRANK + ROD / 2, 0, 0)
    )
    model.body("piston", mass=PISTON, inertia=(1e-4, 1e-4, 1e-4), position=(CRANK + ROD, 0, 0),
               shape=lw.Box((0.08, 0.06, 0.06)))  # fmt: skip
    model.revolute("ground", "crank", at=(0, 0, 0), axis=(0, 1, 0), name="shaft")
    model.revolute("crank", "rod", at=(CRANK, 0, 0), axis=(0, 1, 0), name="crank pin")
    model.spherical("rod", "piston", at=(CRANK + ROD, 0, 0), name="wrist pin")
    model.translational("ground", "piston", at=(CRANK + ROD, 0, 0), axis=(1, 0, 0), name="cylinder")
    model.drive("shaft", velocity=SPEED)
    return lw.assemble(model).model


def shaking(result):
    """The largest force of shaft and cylinder on the frame [N]."""
    both = result.reaction("shaft").force + result.reaction("cylinder").force
    return np.linalg.norm(both, axis=1).max()


turn = 2 * np.pi / SPEED
run = {"t_end": turn, "step": turn / 400}
study = lw.sweep(
    build, {"counterweight": np.linspace(0, 1.2, 25).tolist()}, {"shaking force": (shaking, "N")}, **run
)
force, masses = study.outputs["shaking force"], study.parameters["counterweight"]
best = masses[force.argmin()]
print(f"without: {force[0]:.0f} N; with {best:.2f} kg: {force.min():.0f} N")

# %%
# Half of the rod rotates with the pin, the other half goes with the piston; a textbook balances what rotates and about half of the
# rest:

print(f"rule of thumb: {ROD_MASS / 2 + (PISTON + ROD_MASS / 2) / 2:.2f} kg")

# %%
figure = Figure(figsize=(6, 3.5), layout="constrained")
axes = figure.subplots()
axes.plot(masses, force, "o-")
axes.set(xlabel="counterweight [kg]", ylabel="largest shaking force [N]")
axes.grid(color="0.9")

# %%
# sphinx_gallery_thumbnail_number = 2
view = lw.simulate(build(best), **{**run, "t_end": 10 * turn}).view()
