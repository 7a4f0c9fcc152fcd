"""
A carousel
==========

One body with many joints: a hub that turns, forty arms that swing out. General sparse solvers fill in around such a body; the block
solver eliminates it among its joints.
"""

import linkwork as lw

model = lw.mechanisms.hub(arms=40, loops=True)
result = lw.simulate(model, t_end=2.0, step=1e-3)
print(result.summary())

# %%
view = result.view()
