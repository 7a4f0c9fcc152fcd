from linkwork.integrators.runge_kutta import ButcherTableau

RK3 = ButcherTableau(
    name="rk3", order=3, reference="Kutta (1901)",
    A=((), (1/2,), (-1, 2)), b=(1/6, 2/3, 1/6), c=(0, 1/2, 1),
)  # fmt: skip
