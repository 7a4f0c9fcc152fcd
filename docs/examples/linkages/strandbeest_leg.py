"""
A leg of a Strandbeest
======================

Theo Jansen's eleven numbers turn a crank into a step: the foot draws a level line on the ground and lifts on its way back. A driver
turns the crank, so nothing is free; kinematics needs no integrator, and the torque on the crank follows.
"""

import numpy as np
import linkwork as lw
from matplotlib.figure import Figure

turn = 2 * np.pi / 6.0
needed = lw.inverse_dynamics(lw.mechanisms.strandbeest_leg(), np.linspace(0, turn, 361))
motion = needed.motion
print(f"torque on the crank: {abs(needed.effort('motor')).max():.2f} N m at most")

# %%
view = motion.view()

# %%
# The foot is the corner of the lower triangle that no joint holds.

foot = motion.position[:, -1]
figure = Figure(figsize=(8, 3.2), layout="constrained")
left, right = figure.subplots(1, 2, width_ratios=(2, 1))
left.plot(foot[:, 0], foot[:, 1])
left.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="way of the last link's center")
right.plot(motion.t, needed.effort("motor"))
right.set(xlabel="time [s]", title="torque [N m]")
