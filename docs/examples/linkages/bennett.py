"""
Bennett's linkage: four hinges in space
=======================================

Four hinges whose axes are neither parallel nor meet in a point should lock. Where the lengths and twists of opposite links agree
and are in Bennett's ratio, they move.
"""

import linkwork as lw

model = lw.mechanisms.bennett()
result = lw.simulate(model, t_end=5.0, step=1e-3)
print(result.manifest["constraints"])

# %%
view = result.view()

# %%
coordinates = result.plot(kind="coordinates")
