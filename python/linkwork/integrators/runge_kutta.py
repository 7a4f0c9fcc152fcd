"""Explicit Runge-Kutta methods as data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.integrators.data import check_name, check_nodes, check_numbers, check_order, check_rows, keep
from linkwork.integrators.growth import damped_roots, held_growth, stability
from linkwork.integrators.order_conditions import check_runge_kutta


@dataclass(frozen=True)
class ButcherTableau:
    """An explicit Runge-Kutta method of s stages with step h:

    Y_i = y + h sum_j A_ij f(t + c_j h, Y_j),   y_next = y + h sum_i b_i f(t + c_i h, Y_i)

    `A` holds the strictly lower triangle, row i with i numbers, which add up to c_i (Hairer, Norsett and
    Wanner I, eq. II.1.9). OptionError: sizes that do not fit, what is no number, another c, an order that the
    coefficients do not have.
    """

    name: str
    order: int
    reference: str
    A: Sequence[Sequence[float]]
    b: Sequence[float]
    c: Sequence[float]

    def __post_init__(self) -> None:
        check_name(self.name)
        check_numbers(self.name, b=self.b, c=self.c)
        check_rows(self.name, A=self.A)
        stages = len(self.b)
        if len(self.c) != stages or [len(row) for row in self.A] != list(range(stages)) or not stages:
            raise OptionError(
                f"integrator '{self.name}': the tableau must have as many c and rows of A as b ({stages}), "
                "and i numbers in row i of A",
                code="tableau",
            )
        check_nodes(self.name, self.A, self.c)
        check_order(self.name, stages, order=self.order)
        keep(self, "A", "b", "c")
        check_runge_kutta(self.name, self.matrix, np.array(self.b, float), self.order)

    @property
    def matrix(self) -> Floats:
        """A as a square matrix (s, s)."""
        square = np.zeros((len(self.b), len(self.b)))
        for i, row in enumerate(self.A):
            square[i, :i] = row
        return square

    def compiled(self) -> _core.Tableau:
        """The same method in the compiled module."""
        return _core.Tableau(
            self.name, self.order, self.matrix, np.array(self.b, float), np.array(self.c, float)
        )

    def growth(self, alpha_h: float, beta_h: float) -> float:
        """By which Phi_ddot + 2 alpha Phi_dot + beta^2 Phi = 0 grows in a step (below 1: it decays).

        R(z) = 1 + z b^T (1 - z A)^-1 1, the stability function, at z = h s for s^2 + 2 alpha s + beta^2 = 0.
        """
        A, b = self.matrix, np.array(self.b, float)
        return float(np.max(np.abs([stability(A, b, z) for z in damped_roots(alpha_h, beta_h)])))

    def sampled_growth(self, alpha_h: float, beta_h: float) -> float:
        """The same where the term of Phi_dot and Phi is computed once a step and held."""
        return held_growth(alpha_h, beta_h, float(np.array(self.b, float) @ self.matrix.sum(axis=1)))
