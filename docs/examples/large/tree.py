"""
A tree
======

A binary tree of rods falls from the horizontal: eliminated from its leaves to its root, exactly and without fill.
"""

import linkwork as lw

model = lw.mechanisms.binary_tree(31)
print(model)
result = lw.simulate(model, t_end=1.0, step=1e-3, on_inaccurate="pass")
print(result.verdict.sentence)

# %%
view = result.view()
