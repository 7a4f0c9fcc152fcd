"""
Gyroscope in two gimbals
========================

A weight pulls the axis down; it goes around instead. The initial state is that of regular precession, so the tilt stays as it is.
"""

import numpy as np
import linkwork as lw

model = lw.mechanisms.gyroscope()
result = lw.simulate(model, t_end=3.0, step=2e-4)
rotor = result.body("rotor")
axis = lw.rotation.matrix(rotor.orientation)[:, :, 2]
print(f"tilt varies by {np.ptp(np.arccos(np.clip(axis[:, 2], -1, 1))):.1e} rad")
print(result.verdict.sentence)

# %%
# A gyroscope that spins too slowly nods:

slow = lw.simulate(lw.mechanisms.gyroscope(), t_end=3.0, step=2e-4, integrator="dop853")
overview = slow.plot(kind="energy")

# %%
view = result.view()
