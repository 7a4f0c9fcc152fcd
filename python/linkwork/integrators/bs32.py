from linkwork.integrators.embedded_pair import EmbeddedPair

# The interpolant is the cubic that has the values and the slopes of both ends.
BS32 = EmbeddedPair(
    name="bs32", order=3, reference="Bogacki and Shampine (1989), Appl. Math. Lett. 2, 321-325",
    A=((), (1/2,), (0, 3/4)), b=(2/9, 1/3, 4/9), c=(0, 1/2, 3/4),
    error_order=2, error=(-5/72, 1/12, 1/9, -1/8),
    dense_order=3,
    interpolant=((1, -4/3, 5/9), (0, 1, -2/3), (0, 4/3, -8/9), (0, -1, 1)),
)  # fmt: skip
