"""
Monte Carlo of a suspension
===========================

Springs, dampers, tires and loads scatter from car to car. What must the joints of an axle bear, and how far does the body move?
"""

import numpy as np
from scipy import stats

import linkwork as lw

model = lw.mechanisms.double_wishbone()
scatter = {
    "strut.stiffness": stats.norm(150e3, 7.5e3),
    "strut.damping": stats.norm(19e3, 1.9e3),
    "tire.stiffness": stats.norm(350e3, 35e3),
    "chassis.mass": stats.uniform(400.0, 200.0),
}
study = lw.sweep(
    model,
    scatter,
    {
        "lower ball": "reaction('lower ball').force.max",
        "tie rod": "reaction('tie rod').force.max",
        "travel of the body": "body('chassis').position.z.range",
        "height of the body": "body('chassis').position.z",
    },
    t_end=1.5,
    step=1e-3,
    times=np.linspace(0, 1.5, 31),
    sampler="sobol",
    cases=64,
    seed=3,
)
print(study)
for name in ("lower ball", "tie rod"):
    force = study.outputs[name]
    print(f"{name}: {np.median(force):.0f} N in the middle, {force.max():.0f} N at most")
bands = study.plot("bands")

# %%
# What matters for what:

tornado = study.plot("tornado")

# %%
# Every case is there again, to the last bit: the one whose joint bears the most.

# sphinx_gallery_thumbnail_number = 3
worst = int(np.argmax(study.outputs["lower ball"]))
print({name: float(values[worst].round(1)) for name, values in study.parameters.items()})
view = study.simulate(worst).view()
