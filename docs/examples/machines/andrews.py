"""
Andrews' squeezing mechanism
============================

Seven bodies within a hand's width, driven by a constant motor torque: after 30 ms the crank has turned ten times. A test problem of
integrators since 1983, and problem A03 of the IFToMM benchmark library.
"""

import linkwork as lw

model = lw.mechanisms.andrews()
result = lw.simulate(model, t_end=0.05, rtol=1e-8)
print(result.summary())

# %%
view = result.view()

# %%
# Steps follow the motion: they shrink whenever the spring is squeezed.

every = lw.simulate(model, t_end=0.05, rtol=1e-8, record_every=1)
steps = every.plot(kind="step")
