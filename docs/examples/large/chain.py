"""
A chain of a thousand rods
==========================

It falls from the horizontal. An evaluation costs less than a microsecond a rod, and twice as many rods cost twice as much; a million
are no different but for the memory.
"""

import linkwork as lw

model = lw.mechanisms.chain(1000)
result = lw.simulate(model, t_end=2.0, step=2e-3, record_every=10, on_inaccurate="pass")
print(result.summary())

# %%
view = result.view()

# %%
energy = result.plot(kind="energy")
