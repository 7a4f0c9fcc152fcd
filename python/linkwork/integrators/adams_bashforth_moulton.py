from linkwork.integrators.adams import AdamsBashforthMoulton
from linkwork.integrators.adams_bashforth import AB4
from linkwork.integrators.rk4 import RK4

ABM4 = AdamsBashforthMoulton(
    "abm4", 4, "Moulton (1926)", predictor=AB4.predictor, corrector=(9/24, 19/24, -5/24, 1/24), starter=RK4
)  # fmt: skip
