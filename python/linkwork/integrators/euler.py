from linkwork.integrators.runge_kutta import ButcherTableau

EULER = ButcherTableau(name="euler", order=1, reference="Euler (1768)", A=((),), b=(1,), c=(0,))
