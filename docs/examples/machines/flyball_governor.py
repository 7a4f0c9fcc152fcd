"""
Flyball governor
================

Problem A05 of the IFToMM benchmark library: balls swing out as the shaft turns faster and lift a slider, held by stiff springs with
strong dampers. The fastest motion dies away with 8100 1/s; explicit steps must be shorter than 0.34 ms.
"""

import linkwork as lw

model = lw.mechanisms.flyball_governor()
result = lw.simulate(model, t_end=2.0, step=2e-4)
print(result.verdict.sentence)

# %%
view = result.view()

# %%
# Where the step is too long, the run does not end in a wrong picture but in an error:

try:
    lw.simulate(model, t_end=2.0, step=5e-4)
except lw.LinkworkError as error:
    print(f"{type(error).__name__}: {error}")

# %%
coordinates = result.plot(kind="coordinates")
