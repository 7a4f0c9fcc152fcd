"""
Newton's cradle
===============

Five balls on pairs of threads, half a millimeter apart, so that they meet one after the other. Contacts are Hertzian, with a little
loss. The middle balls hardly move, and the last one carries the momentum away.
"""

import numpy as np
import linkwork as lw
from matplotlib.figure import Figure

RADIUS, LENGTH = 0.02, 0.15
model = lw.Model(name="Newton's cradle")
places = (2 * RADIUS + 0.5e-3) * np.arange(5)
first = np.array([-LENGTH * np.sin(0.7), 0, LENGTH * (1 - np.cos(0.7))])  # pulled aside
for number, x in enumerate(places):
    name, center = f"ball {number}", np.array([x, 0, -LENGTH]) + (first if number == 0 else 0)
    threads = [lw.Rod((0, 0, 0), (x, y, 0) - center, radius=0.0007) for y in (-0.05, 0.05)]
    model.body(
        name,
        mass=0.26,
        inertia=[0.4 * 0.26 * RADIUS**2] * 3,
        shape=[lw.Sphere(RADIUS), *threads],
        position=center,
    )
    model.revolute("ground", name, at=(x, 0, 0), axis=(0, 1, 0), name=f"threads {number}")
for number in range(4):
    centers = [np.array([places[k], 0, -LENGTH]) + (first if k == 0 else 0) for k in (number, number + 1)]
    model.sphere_sphere_contact(
        f"ball {number}",
        f"ball {number + 1}",
        at=centers,
        radius_a=RADIUS,
        radius_b=RADIUS,
        stiffness=1e8,
        hysteresis=lw.contact_hysteresis("lankarani_nikravesh", 0.98),
    )
result = lw.simulate(model, t_end=0.55, step=1e-5)
print(result.verdict.sentence)

# %%
view = result.view()

# %%
figure = Figure(figsize=(8, 3.4), layout="constrained")
ax = figure.subplots()
for number in range(5):
    ax.plot(result.t, result.coordinate(f"threads {number}").value, label=f"ball {number}")
ax.set(xlabel="time [s]", ylabel="angle [rad]")
figure.legend(ncols=5, loc="outside upper center")
