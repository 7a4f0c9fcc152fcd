"""
Tolerances of a coupler's path
==============================

The links of a four-bar are cut to 0.1 mm, its bearings sit within 0.05 mm. How far does a point of the coupler leave its path?
"""

import numpy as np
from scipy import stats

import linkwork as lw


def build(crank=0.10, coupler=0.35, rocker=0.30, base=0.40, height=0.0):
    """A crank-rocker; links in m, the rocker's bearing at (base, height)."""
    model = lw.Model(gravity=(0, 0, 0), name="crank-rocker")
    A, B = np.array([0.0, 0.0, crank]), np.array([base, 0.0, height])
    d = np.linalg.norm(B - A)
    along = (coupler**2 - rocker**2 + d**2) / (2 * d)
    x, z = (B - A)[[0, 2]] / d
    P = A + along * np.array([x, 0, z]) + np.sqrt(coupler**2 - along**2) * np.array([-z, 0, x])
    for name, (start, end) in {"crank": ((0, 0, 0), A), "coupler": (A, P), "rocker": (B, P)}.items():
        length = np.linalg.norm(np.subtract(end, start))
        model.body(
            name,
            mass=length,
            inertia=lw.mechanisms.thin_rod(length, length),
            position=np.add(start, end) / 2,
            orientation=lw.rotation.from_axes(np.subtract(end, start), (0, 1, 0)),
        )
    for name, bodies, at in (
        ("motor", ("ground", "crank"), (0, 0, 0)),
        ("crank pin", ("crank", "coupler"), A),
        ("rocker pin", ("coupler", "rocker"), P),
        ("bearing", ("ground", "rocker"), B),
    ):
        model.revolute(*bodies, at=at, axis=(0, 1, 0), name=name)
    model.drive("motor", velocity=2 * np.pi)
    return lw.assemble(model).model


view = lw.simulate(build(), t_end=1.0, step=2e-3).view()

# %%
# A hundred machines, by a Latin hypercube; three standard deviations are the tolerance.

tolerances = {
    "crank": stats.norm(0.10, 1e-4 / 3),
    "coupler": stats.norm(0.35, 1e-4 / 3),
    "rocker": stats.norm(0.30, 1e-4 / 3),
    "base": stats.norm(0.40, 5e-5 / 3),
    "height": stats.norm(0.0, 5e-5 / 3),
}
path = lw.simulate(build(), t_end=1.0, step=2e-3).body("coupler").position


def off(result):
    """How far the middle of the coupler is from where it should be [mm]."""
    return 1e3 * np.linalg.norm(result.body("coupler").position - path, axis=1)


study = lw.sweep(
    build,
    tolerances,
    {
        "largest deviation": (lambda result: off(result).max(), "mm"),
        "z at half a turn": (lambda result: 1e3 * result.body("coupler").position[250, 2], "mm"),
    },
    t_end=1.0,
    step=2e-3,
    sampler="latin_hypercube",
    cases=100,
    seed=1,
)
print(study)
deviation = study.outputs["largest deviation"]
print(f"median {np.median(deviation):.3f} mm, one of twenty is above {np.percentile(deviation, 95):.3f} mm")
distribution = study.plot("histogram", outputs="largest deviation")

# %%
# What the height at half a turn owes to each dimension:

for swing in study.swings("z at half a turn"):
    print(f"{swing.parameter:8} {swing.change:+.4f} mm")
print(f"{swing.explained:.2%} of the variance is linear")
tornado = study.plot("tornado", outputs="z at half a turn")
