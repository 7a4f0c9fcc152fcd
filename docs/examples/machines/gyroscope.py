"""
Gyroscope in two gimbals
========================

A weight pulls the axis down; it goes around instead. The initial state is that of regular precession, so the tilt stays as it is.
"""

import numpy as np
import linkwork as lw
from matplotlib.figure import Figure

model = lw.mechanisms.gyroscope()
result = lw.simulate(model, t_end=3.0, step=2e-4)
rotor = result.body("rotor")
axis = lw.rotation.matrix(rotor.orientation)[:, :, 2]
print(f"tilt varies by {np.ptp(np.arccos(np.clip(axis[:, 2], -1, 1))):.1e} rad")
print(result.verdict.sentence)

# %%
view = result.view()

# %%
# Let go with its axis at rest instead, it falls a little, and then nods on its way around:

v = np.zeros((3, 6))
v[2, 5] = rotor.omega[0, 2]
nodding = lw.simulate(model.with_initial_state(result.q[0], v), t_end=1.0, step=2e-4)
axis = lw.rotation.matrix(nodding.body("rotor").orientation)[:, :, 2]
figure = Figure(figsize=(8, 3), layout="constrained")
ax = figure.subplots()
ax.plot(nodding.t, np.arccos(axis[:, 2]))
ax.set(xlabel="time [s]", ylabel="tilt of the axis [rad]")
