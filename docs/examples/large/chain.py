"""
A chain of a thousand rods
==========================

It falls from the horizontal. A bend runs from the pin to the free end; what it has not reached falls freely. An evaluation costs
less than a microsecond a rod, and twice as many rods cost twice as much; a million are no different but for the memory.
"""

import numpy as np
import linkwork as lw

model = lw.mechanisms.chain(1000)
result = lw.simulate(model, t_end=8.0, integrator="dop853", rtol=1e-5, times=np.linspace(0, 8, 161))
print(result.summary())

# %%
# The last rod, and what falls freely:

print(result.position[-1, -1, 2], -9.81 / 2 * 8.0**2)

# %%
view = result.view()

# %%
energy = result.plot(kind="energy")
