from linkwork.integrators.runge_kutta import ButcherTableau

# At a fixed step the seventh stage, which only the embedded method of order 4 uses, is left out.
DOPRI5 = ButcherTableau(
    name="dopri5", order=5, reference="Dormand and Prince (1980), J. Comput. Appl. Math. 6, 19-26",
    A=(
        (),
        (1/5,),
        (3/40, 9/40),
        (44/45, -56/15, 32/9),
        (19372/6561, -25360/2187, 64448/6561, -212/729),
        (9017/3168, -355/33, 46732/5247, 49/176, -5103/18656),
    ),
    b=(35/384, 0, 500/1113, 125/192, -2187/6784, 11/84),
    c=(0, 1/5, 3/10, 4/5, 8/9, 1),
)  # fmt: skip
