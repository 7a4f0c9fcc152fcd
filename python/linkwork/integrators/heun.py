from linkwork.integrators.runge_kutta import ButcherTableau

HEUN = ButcherTableau(
    name="heun", order=2, reference="Heun (1900)",
    A=((), (1,)), b=(1/2, 1/2), c=(0, 1),
)  # fmt: skip
