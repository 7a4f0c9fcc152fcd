from linkwork.integrators.dopri5 import DOPRI5
from linkwork.integrators.half_explicit import HalfExplicit

PHEM56 = HalfExplicit(
    name="phem56", order=5, reference="Murua (1997), Computing 59, 43-61, based on Dormand and Prince",
    A=DOPRI5.A,
    A_bar=(
        (),
        (3/40, 9/40),
        (21/256, 45/256, 15/128),
        (19235/98784, -225/392, 6235/6174, 2755/32928),
        (-293/1152, 85/48, -2275/1908, 35/32, -2835/6784),
        DOPRI5.b,
    ),
    explicit_first_stage=True,
)  # fmt: skip
