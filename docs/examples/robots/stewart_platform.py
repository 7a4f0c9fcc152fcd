"""
Stewart platform
================

Six legs that change their lengths move a platform of three tons in all six ways. The lengths are prescribed; the forces in the legs
are what a designer asks for.
"""

import numpy as np
import linkwork as lw
from matplotlib.figure import Figure

model = lw.mechanisms.stewart_platform()
needed = lw.inverse_dynamics(model, np.linspace(0, 2.1, 211))
figure = Figure(figsize=(8, 3.4), layout="constrained")
ax = figure.subplots()
for name in needed.drives:
    ax.plot(needed.t, needed.effort(name) / 1e3, label=name)
ax.set(xlabel="time [s]", ylabel="force in the leg [kN]")
figure.legend(ncols=3, loc="outside upper center")

# %%
# sphinx_gallery_thumbnail_number = 2
view = needed.motion.view()
