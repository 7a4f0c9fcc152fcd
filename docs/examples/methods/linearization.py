"""
Vibrations of a car on its wheels
=================================

A body on four bushings: where it rests, and the frequencies, damping and shapes of its small motions about that pose. The simulation
of one mode is the check.
"""

import numpy as np
import linkwork as lw
from matplotlib.figure import Figure

model = lw.Model(name="car body")
model.body(
    "car", mass=1200.0, inertia=(400.0, 1500.0, 1700.0), position=(0, 0, 0.6), shape=lw.Box((3.6, 1.5, 0.5))
)
for x in (-1.3, 1.2):
    for y in (-0.7, 0.7):
        model.bushing(
            "ground",
            "car",
            at=(x, y, 0.3),
            stiffness=(2e5, 2e5, 2.2e4),
            damping=(2e3, 2e3, 1.5e3),
            name=f"wheel {x:+g} {y:+g}",
        )
rest = lw.equilibrium(model)
print(rest)

# %%
vibration = lw.linearize(rest.model)
for mode, (frequency, damping) in enumerate(zip(vibration.frequencies, vibration.damping_ratios)):
    print(f"{frequency / (2 * np.pi):6.2f} Hz, damping {damping:5.3f}: {vibration.describe(mode)}")

# %%
# The first mode, let go from a displaced pose, decays as the linear theory says:

released = lw.simulate(vibration.displaced(0, 0.02), t_end=2.0, step=1e-3)
s = vibration.frequencies[0] * (
    -vibration.damping_ratios[0] + 1j * np.sqrt(1 - vibration.damping_ratios[0] ** 2)
)
moved = released.position[:, 0] - rest.model.compiled().q0[:3]
axis = np.argmax(np.abs(moved[0]))
figure = Figure(figsize=(8, 3.4), layout="constrained")
ax = figure.subplots()
ax.plot(released.t, moved[:, axis] * 1e3, label="simulated")
shape = moved[0, axis] * np.real(np.exp(s * released.t) * (1 - 1j * np.real(s) / np.imag(s)))
ax.plot(released.t, shape * 1e3, "--", label="linear")
ax.set(xlabel="time [s]", ylabel=f"{'xyz'[axis]} of the center [mm]")
ax.legend()

# %%
# sphinx_gallery_thumbnail_number = 2
view = released.view()
