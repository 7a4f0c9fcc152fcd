"""
An integrator of your own
=========================

A Butcher tableau is data: the compiled loop runs it. Anything else is a function of Python.
"""

import linkwork as lw
from linkwork.integrators import ButcherTableau

ralston = ButcherTableau(
    name="ralston",
    order=3,
    reference="Ralston (1962)",
    A=((), (1 / 2,), (0, 3 / 4)),
    b=(2 / 9, 1 / 3, 4 / 9),
    c=(0, 1 / 2, 3 / 4),
)


def midpoint(system, t, y, h):
    return y + h * system.derivative(t + h / 2, y + h / 2 * system.derivative(t, y))


model = lw.mechanisms.spatial_slider_crank()
for integrator in ("rk3", ralston, midpoint):
    errors = [
        abs(
            lw.simulate(model, t_end=0.5, step=h, integrator=integrator, on_inaccurate="pass").energy_error
        ).max()
        for h in (2e-3, 1e-3)
    ]
    print(
        f"{getattr(integrator, 'name', None) or getattr(integrator, '__name__', integrator):10} "
        f"energy errors {errors[0]:.1e}, {errors[1]:.1e} J: a factor of {errors[0] / errors[1]:.1f}"
    )

# %%
result = lw.simulate(model, t_end=1.0, step=1e-3, integrator=ralston)
print(result.verdict.sentence)
view = result.view()
