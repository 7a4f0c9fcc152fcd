"""
What a parameter does
=====================

How the stroke and the largest bearing force of a slider-crank change with its dimensions: derivatives of a run, each with the error
of its finite difference.
"""

import numpy as np
import linkwork as lw


def build(crank, rod, piston):
    model = lw.Model(name="slider-crank")
    model.body(
        "crank",
        mass=1.0,
        inertia=lw.mechanisms.thin_rod(1.0, crank),
        position=(0, 0, crank / 2),
        orientation=lw.rotation.from_axes((0, 0, 1), (0, 1, 0)),
    )
    reach = np.sqrt(rod**2 - crank**2)
    model.body(
        "rod",
        mass=1.5,
        inertia=lw.mechanisms.thin_rod(1.5, rod),
        position=(reach / 2, 0, crank / 2),
        orientation=lw.rotation.from_axes((reach, 0, -crank), (0, 1, 0)),
    )
    model.body(
        "piston",
        mass=piston,
        inertia=(0.002, 0.002, 0.002),
        position=(reach, 0, 0),
        shape=lw.Box((0.12, 0.1, 0.1)),
    )
    model.revolute("ground", "crank", at=(0, 0, 0), axis=(0, 1, 0), name="shaft")
    model.revolute("crank", "rod", at=(0, 0, crank), axis=(0, 1, 0), name="crank pin")
    model.revolute("rod", "piston", at=(reach, 0, 0), axis=(0, 1, 0), name="wrist pin")
    model.translational("ground", "piston", at=(reach, 0, 0), axis=(1, 0, 0), name="cylinder")
    model.drive("shaft", velocity=12.0)
    return lw.assemble(model).model


def load(result):
    return np.sqrt(np.mean(np.sum(result.reaction("crank pin").force ** 2, axis=1)))


found = lw.sensitivity(
    build,
    {"crank": 0.1, "rod": 0.3, "piston": 1.0},
    {"stroke": lambda result: np.ptp(result.body("piston").position[:, 0]), "load": load},
    t_end=0.6,
    step=1e-3,
)
for output in ("stroke", "load"):
    for parameter in ("crank", "rod", "piston"):
        value, error = found.derivatives[output][parameter], found.errors[output][parameter]
        print(
            f"d {output:6} / d {parameter:6} = {value:10.4f} +- {error:.0e}   relative {found.relative(output, parameter):+.3f}"
        )

# %%
view = lw.simulate(build(0.1, 0.3, 1.0), t_end=1.0, step=1e-3).view()
