"""
A spatial slider-crank by the four methods
==========================================

Lagrange multipliers, Baumgarte, penalty, augmented Lagrangian: chapter 12 of Flores' book on one mechanism, with the error of each
against a reference solution.
"""

import linkwork as lw

comparison = lw.compare(
    "spatial_slider_crank",
    t_end=2.0,
    steps=[4e-3, 2e-3, 1e-3],
    processes=1,
    progress=False,
    formulations=[
        {"formulation": "standard", "stabilization": "none"},
        {
            "formulation": "standard",
            "stabilization": "baumgarte",
            "baumgarte_alpha": 5.0,
            "baumgarte_beta": 5.0,
        },
        {"formulation": "standard"},
        {"formulation": "penalty", "penalty": 1e7, "damping_ratio": 1.0, "frequency": 10.0},
        {"formulation": "augmented_lagrangian"},
    ],
)
print(comparison)

# %%
work = comparison.plot("work_precision")

# %%
# How far each violates the joints, over time:

violation = comparison.plot("violation")

# %%
# sphinx_gallery_thumbnail_number = 3
print(comparison.recommend(error=1e-3))
view = lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=2.0, step=1e-3).view()
