"""
Heavy top
=========

A body held at one point, spinning at 150 rad/s about its axis: the benchmark of the literature on integrators for rotations. Its
position after two seconds is published.
"""

import linkwork as lw

model = lw.mechanisms.heavy_top()
result = lw.simulate(model, t_end=2.0, step=1e-4)
print(result.position[-1, 0], result.verdict.sentence)

# %%
view = result.view()

# %%
positions = result.plot()
