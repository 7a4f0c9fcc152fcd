"""Half-explicit Runge-Kutta methods as data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.integrators.data import check_name, check_order, check_rows, keep
from linkwork.integrators.growth import damped_roots, stability
from linkwork.integrators.order_conditions import check_runge_kutta


@dataclass(frozen=True)
class HalfExplicit:
    """A method of s stages for M v_dot - D^T lambda = g, D v + Phi_t = 0 that needs no gamma. With step h:

    Y_i = y + h sum_{j<i} A_ij k_j,  Z_i = y + h sum_{j<=i} A_bar_ij k_j,  k_i = (N(Q_i) V_i, V_dot_i)

    V_dot_i and the multipliers of stage i follow from the equations of motion at Y_i and the velocity
    constraints at Z_i; y_next = Z_s. `A` holds the strictly lower triangle, row i with i numbers; row i of
    `A_bar` has i + 1. With `explicit_first_stage` the first stage takes D v_dot = gamma, and row 0 of A_bar
    is empty. OptionError: as for a `ButcherTableau`.
    """

    name: str
    order: int
    reference: str
    A: Sequence[Sequence[float]]
    A_bar: Sequence[Sequence[float]]
    explicit_first_stage: bool = False

    def __post_init__(self) -> None:
        check_name(self.name)
        check_rows(self.name, A=self.A, A_bar=self.A_bar)
        if not isinstance(self.explicit_first_stage, bool):
            given = f"explicit_first_stage {self.explicit_first_stage!r:.80}"
            raise OptionError(f"integrator '{self.name}': {given} is not True or False", code="tableau")
        lengths = [len(row) for row in self.A], [len(row) for row in self.A_bar]
        stages = list(range(len(self.A)))
        expected = [i + 1 if i or not self.explicit_first_stage else 0 for i in stages]
        if not stages or lengths != (stages, expected):
            raise OptionError(
                f"integrator '{self.name}': A and A_bar need as many rows, with i and i + 1 numbers in row i",
                code="tableau",
            )
        check_order(self.name, len(stages), order=self.order)
        keep(self, "A", "A_bar")
        A, A_bar = self.matrices  # where nothing is constrained, a Runge-Kutta method
        check_runge_kutta(self.name, A, A_bar[-1], self.order)

    @property
    def matrices(self) -> tuple[Floats, Floats]:
        """A and A_bar as square matrices (s, s)."""
        squares = np.zeros((2, len(self.A), len(self.A)))
        for square, rows in zip(squares, (self.A, self.A_bar), strict=True):
            for i, row in enumerate(rows):
                square[i, : len(row)] = row
        return squares[0], squares[1]

    def growth(self, alpha_h: float, beta_h: float) -> float:
        """By which a motion with s^2 + 2 alpha s + beta^2 = 0 that the constraints allow grows in a step.

        There the last row of A_bar has the weights of a Runge-Kutta method: R(z) = 1 + z b^T (1 - z A)^-1 1.
        """
        A, A_bar = self.matrices
        return float(np.max(np.abs([stability(A, A_bar[-1], z) for z in damped_roots(alpha_h, beta_h)])))

    def compiled(self) -> _core.HalfExplicit:
        """The same method in the compiled module."""
        return _core.HalfExplicit(self.name, self.order, *self.matrices, self.explicit_first_stage)
