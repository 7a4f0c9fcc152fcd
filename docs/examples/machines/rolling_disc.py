"""
A disc that rolls
=================

Euler's disc without its losses. The disc touches the table (one equation of positions) and its lowest point is at rest (two of
velocities): a non-holonomic joint. Three freedoms of motion, five of position.
"""

import linkwork as lw
from matplotlib.figure import Figure

model = lw.mechanisms.rolling_disc()
result = lw.simulate(model, t_end=6.0, step=1e-3, integrator="dop853")
print(f"energy is kept to {abs(result.energy_error).max() / result.energy[0]:.0e}")

# %%
view = result.view()

# %%
center = result.position[:, 0]
figure = Figure(figsize=(6, 4), layout="constrained")
ax = figure.subplots()
ax.plot(center[:, 0], center[:, 1], lw=1)
ax.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="way of the center, from above")
