"""
A pendulum that is balanced
===========================

A cart on a rail keeps a pole upright: state feedback with gains from the linearized equations, computed by SciPy, acting through
`joint_force`. The controller is a Python function in the loop.
"""

import numpy as np
import linkwork as lw
from scipy.linalg import solve_continuous_are

M, m, L, g = 1.0, 0.2, 0.6, 9.81
model = lw.Model(name="cart and pole")
model.body("cart", mass=M, inertia=(0.01, 0.01, 0.01), shape=lw.Box((0.3, 0.16, 0.1)))
tilt = 0.35
model.body(
    "pole",
    mass=m,
    inertia=lw.mechanisms.thin_rod(m, L),
    position=(L / 2 * np.sin(tilt), 0, L / 2 * np.cos(tilt)),
    orientation=lw.rotation.from_axes((np.sin(tilt), 0, np.cos(tilt)), (0, 1, 0)),
)
model.translational("ground", "cart", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
model.revolute("cart", "pole", at=(0, 0, 0), axis=(0, 1, 0), name="hinge")

# %%
# The linear model in the cart's position x and the pole's angle a from the vertical, and the regulator's gains:

inertia = np.array([[M + m, m * L / 2], [m * L / 2, m * L**2 / 3]])
drive, gravity = np.linalg.solve(inertia, [1.0, 0.0]), np.linalg.solve(inertia, [0.0, m * g * L / 2])
A = np.zeros((4, 4))
A[0, 2] = A[1, 3] = 1.0
A[2:, 1] = gravity
B = np.array([[0, 0, *drive]]).T
P = solve_continuous_are(A, B, np.diag([4.0, 20.0, 1.0, 1.0]), np.eye(1))
K = (B.T @ P)[0]
print("gains:", K.round(2))

# %%
# The law acts along the rail; it reads the pole's angle from the state.


def feedback(t, q, v):
    cart, pole = q
    angle = np.arctan2(pole[0] - cart[0], pole[2] - cart[2])
    rate = v[1, 4]  # about y, which the motion keeps
    force = -K @ [cart[0], angle, v[0, 0], rate]
    return [[force, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]]


model.user_force(feedback, ["cart", "pole"], name="regulator")
result = lw.simulate(model, t_end=4.0, step=2e-3)
print(
    f"at the end: cart at {result.position[-1, 0, 0]:.4f} m, pole off by {result.position[-1, 1, 0] - result.position[-1, 0, 0]:.1e} m"
)
coordinates = result.plot(kind="coordinates")

# %%
# sphinx_gallery_thumbnail_number = 2
view = result.view()
