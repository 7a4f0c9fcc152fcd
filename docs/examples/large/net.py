"""
A net
=====

Rods in squares, hung by four corners: every mesh is a closed loop, and no equation is redundant, because the net is curved both ways.
"""

import linkwork as lw

model = lw.mechanisms.net(10)
print(model)
result = lw.simulate(model, t_end=2.0, step=2e-3)
print(result.verdict.sentence)

# %%
view = result.view()

# %%
energy = result.plot(kind="energy")
