from linkwork.integrators.runge_kutta import ButcherTableau

RK4 = ButcherTableau(
    name="rk4", order=4, reference="Kutta (1901)",
    A=((), (1/2,), (0, 1/2), (0, 0, 1)), b=(1/6, 1/3, 1/3, 1/6), c=(0, 1/2, 1/2, 1),
)  # fmt: skip
