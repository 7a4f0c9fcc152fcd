"""
Delta robot
===========

Three arms and parallelograms of rods carry a platform that never turns, for picking and placing at many g.
"""

import linkwork as lw

model = lw.mechanisms.delta_robot()
result = lw.simulate(model, t_end=1.0, step=5e-4)
print(result.summary())

# %%
view = result.view()

# %%
reactions = result.plot(kind="reactions")
