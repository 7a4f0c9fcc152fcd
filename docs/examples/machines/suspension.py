"""
Double wishbone suspension
==========================

Half of a car's axle on a shaker: two wishbones, an upright, a tie rod, a spring with its damper. A post shakes the tire.
"""

import linkwork as lw

model = lw.mechanisms.double_wishbone()
result = lw.simulate(model, t_end=3.0, step=1e-3)
print(result.summary())

# %%
view = result.view()

# %%
# What the joints bear is what one wants to know of it.

reactions = result.plot(kind="reactions")
