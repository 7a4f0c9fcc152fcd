"""Runge-Kutta methods with an error estimate and an interpolant: they choose their steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.integrators.data import check_nodes, check_numbers, check_order, check_rows, keep
from linkwork.integrators.order_conditions import check_dense_order, check_error_order
from linkwork.integrators.runge_kutta import ButcherTableau


@dataclass(frozen=True)
class EmbeddedPair(ButcherTableau):
    """A `ButcherTableau` of s stages, and what adaptive steps need beside it. With k_s = f(t + h, y_next):

    error         s + 1 weights: the estimate of the error is h sum_i error_i k_i, of order error_order + 1
    second_error  empty, or weights of a second estimate e_2; the error is then e^2 / sqrt(e^2 + 0.01 e_2^2)
    extra_A       further stages for the interpolant alone: row i has s + 1 + i numbers
    extra_c       their places in the step
    interpolant   a row for each stage: y(t + theta h) = y + h sum_i (sum_k interpolant_ik theta^(k+1)) k_i
    dense_order   of the interpolant

    At a fixed step only the method itself is used. OptionError: as for a `ButcherTableau`.
    """

    error_order: int
    error: Sequence[float]
    interpolant: Sequence[Sequence[float]]
    dense_order: int
    second_error: Sequence[float] = ()
    extra_A: Sequence[Sequence[float]] = ()
    extra_c: Sequence[float] = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        check_numbers(self.name, error=self.error, second_error=self.second_error, extra_c=self.extra_c)
        check_rows(self.name, interpolant=self.interpolant, extra_A=self.extra_A)
        stages, extra = len(self.b), len(self.extra_c)
        sizes = [len(row) for row in self.extra_A] == [stages + 1 + i for i in range(extra)]
        if not sizes or len(self.error) != stages + 1 or len(self.interpolant) != stages + 1 + extra:
            raise OptionError(
                f"integrator '{self.name}': error needs {stages + 1} weights, interpolant "
                f"{stages + 1 + extra} rows, and row i of extra_A {stages + 1} + i numbers",
                code="tableau",
            )
        check_nodes(self.name, self.extra_A, self.extra_c, "extra_")
        columns = len(self.interpolant[0])
        if any(len(row) != columns for row in self.interpolant):
            raise OptionError(
                f"integrator '{self.name}': the rows of interpolant have not all {columns} numbers",
                code="tableau",
            )
        check_order(self.name, stages + 1, error_order=self.error_order)
        check_order(self.name, columns, dense_order=self.dense_order)
        keep(self, "error", "interpolant", "second_error", "extra_A", "extra_c")
        self._check_conditions(stages + 1)

    def _check_conditions(self, stages: int) -> None:
        """OptionError: the estimate or the interpolant has not the order that is declared."""
        A = np.zeros((len(self.interpolant), len(self.interpolant)))
        A[: stages - 1, : stages - 1], A[stages - 1, : stages - 1] = self.matrix, self.b
        A[stages:] = self.extra_matrix
        if not self.second_error:  # of two estimates neither has the order of what is made of them
            error = np.array(self.error, float)
            check_error_order(self.name, A[:stages, :stages], error, self.error_order)
        check_dense_order(self.name, A, np.array(self.interpolant, float), self.dense_order)

    @property
    def extra_matrix(self) -> Floats:
        """extra_A with a column for each stage (extra, s + 1 + extra)."""
        square = np.zeros((len(self.extra_c), len(self.interpolant)))
        for i, row in enumerate(self.extra_A):
            square[i, : len(row)] = row
        return square

    def compiled_pair(self) -> _core.EmbeddedPair:
        """The whole pair in the compiled module; `compiled` is the method at a fixed step."""
        error, second_error, extra_c = (
            np.array(numbers, float) for numbers in (self.error, self.second_error, self.extra_c)
        )
        interpolant = np.array(self.interpolant, float)
        return _core.EmbeddedPair(
            self.compiled(), self.error_order, error, second_error, self.extra_matrix, extra_c, interpolant
        )
