"""
A track of sixty shoes
======================

A closed chain of shoes runs around a driving wheel and an idler, carried by rollers: sixty revolutes in one loop, and contact with
friction wherever a pin touches a wheel. It begins as a polygon, sags onto its rollers, and surges.

Where single shoes are after half a second hangs on the last digits of every contact, and the verdict of the run says so. Energy and
joints are kept all the same: what is asked of such a motion is its tension, not its shoes.
"""

import linkwork as lw

model = lw.mechanisms.tracked_chain(shoes=60)
result = lw.simulate(model, t_end=0.5, step=1e-4, on_inaccurate="pass")
print(result.summary())

# %%
view = result.view()
