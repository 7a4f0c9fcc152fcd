"""
Bricard's mechanism: it moves against the count
===============================================

Five rods and six hinges in a closed loop: 30 equations on 30 coordinates, so by the count nothing moves. It does, because one
equation follows from the others. Problem A04 of the IFToMM benchmark library.
"""

import linkwork as lw

model = lw.mechanisms.bricard()
result = lw.simulate(model, t_end=10.0, step=1e-3)
print(result.manifest["constraints"])

# %%
view = result.view()

# %%
# The redundant equation was found before the first step and left out. Solved as it stands, the matrix is singular on the
# constraints and nearly so beside them: a plain LU solver raises nothing and is wrong by almost two meters.

energy = result.plot(kind="energy")
print("all reactions are shares:", not result.unique_reactions.any())
