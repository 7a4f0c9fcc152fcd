"""
A four-bar linkage through singular poses
=========================================

When all rods of this parallelogram lie on one line, it could go on in two ways: as a parallelogram, or folded. At that moment
its equations depend on each other, and most codes take the wrong branch or blow up. linkwork foresees such poses and takes them
in one leap. It is problem A02 of the IFToMM benchmark library.
"""

import linkwork as lw

model = lw.mechanisms.four_bar()
result = lw.simulate(model, t_end=10.0, step=1e-3)
print(result.summary())

# %%
view = result.view()

# %%
# The tops keep their speed and energy is kept to twelve digits, after a dozen passages:

for pose in result.singular_poses[:4]:
    print(f"{pose.t:.4f} s: {', '.join(pose.joints)}")
energy = result.plot(kind="energy")
