"""
A robot from a URDF file
========================

Links become bodies of the same names, joints keep their zero. What of the file is not in the model is told.
"""

import linkwork as lw

imported = lw.import_urdf("arm.urdf", coordinates={"shoulder": -0.9, "elbow": 1.2})
print(imported.model)
for note in imported.notes:
    print("-", note)

# %%
result = lw.simulate(imported.model, t_end=1.0, step=1e-3)
print(result.verdict.sentence)

# %%
view = result.view()
