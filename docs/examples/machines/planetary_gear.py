"""
Planetary gear
==============

The power split of a hybrid car: the engine turns the carrier, a generator holds back the sun, the ring drives the wheels. Each of
the four planets but the first closes a loop with one redundant equation.
"""

import linkwork as lw

model = lw.mechanisms.planetary_gear()
result = lw.simulate(model, t_end=1.0, step=1e-4)
print(result.manifest["constraints"])

# %%
view = result.view()

# %%
# Willis' equation holds at every moment: (w_ring - w_carrier) / (w_sun - w_carrier) = -z_sun / z_ring.

carrier, sun, ring = (result.body(name).omega[:, 2] for name in ("carrier", "sun", "ring"))
ratio = (ring - carrier)[1:] / (sun - carrier)[1:]
print(f"{ratio.min():.12f} to {ratio.max():.12f}; -30/78 = {-30 / 78:.12f}")
coordinates = result.plot(kind="coordinates")
