from linkwork.integrators.adams import AdamsBashforth
from linkwork.integrators.dopri5 import DOPRI5
from linkwork.integrators.heun import HEUN
from linkwork.integrators.rk3 import RK3
from linkwork.integrators.rk4 import RK4

_REFERENCE = "Bashforth and Adams (1883)"

AB2 = AdamsBashforth("ab2", 2, _REFERENCE, predictor=(3/2, -1/2), starter=HEUN)  # fmt: skip
AB3 = AdamsBashforth("ab3", 3, _REFERENCE, predictor=(23/12, -16/12, 5/12), starter=RK3)  # fmt: skip
AB4 = AdamsBashforth("ab4", 4, _REFERENCE, predictor=(55/24, -59/24, 37/24, -9/24), starter=RK4)  # fmt: skip
AB5 = AdamsBashforth(
    "ab5", 5, _REFERENCE, predictor=(1901/720, -2774/720, 2616/720, -1274/720, 251/720), starter=DOPRI5
)  # fmt: skip
