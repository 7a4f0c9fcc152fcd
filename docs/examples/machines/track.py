"""
A track of two hundred shoes
============================

A closed chain of shoes runs around a driving wheel and an idler, carried by rollers: 200 revolutes in one loop, and contact with
friction wherever a pin touches a wheel. It begins as a polygon and sags onto its rollers.
"""

import linkwork as lw

model = lw.mechanisms.tracked_chain(shoes=60)
result = lw.simulate(model, t_end=0.5, step=1e-4, on_inaccurate="pass")
print(result.summary())

# %%
view = result.view()
