from linkwork.integrators.half_explicit import HalfExplicit

_R = 6**0.5
_A = (
    (),
    (3/10,),
    ((1 + _R)/30, (11 - 4*_R)/30),
    ((-79 - 31*_R)/150, (-1 - 4*_R)/30, (24 + 11*_R)/25),
    ((14 + 5*_R)/6, (-8 + 7*_R)/6, (-9 - 7*_R)/4, (9 - _R)/4),
)  # fmt: skip

# Each stage meets the velocity constraints where the next one begins, the last one at the new state.
HEM4 = HalfExplicit(
    name="hem4", order=4, reference="Brasey and Hairer (1993), SIAM J. Numer. Anal. 30, 538-552",
    A=_A, A_bar=(*_A[1:], (0, 0, (16 - _R)/36, (16 + _R)/36, 1/9)),
)  # fmt: skip
