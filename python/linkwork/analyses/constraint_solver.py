"""What constraints leave: motions along which they hold, and motions that correct them.

D is scaled: its columns of rotations by the size of the mechanism, each row to length 1. So its singular
values are numbers between 0 and sqrt(m) without unit, whatever the model is made of.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwork.analyses.equations import Equations, Sparse

__all__ = ["DENSE", "Constraints", "null_space"]

Floats = NDArray[np.float64]

#: Up to so many columns of D dense matrices are the faster ones.
DENSE = 480

#: Singular values below this part of the largest count as zero.
RANK_TOLERANCE = 1e-9


@dataclass(frozen=True)
class Constraints:
    """Scaled singular value decomposition of D (m, 6n) at one pose: R D S = U diag(sigma) V^T."""

    U: Floats
    sigma: Floats  # descending, min(m, 6n)
    V: Floats  # (6n, min(m, 6n))
    row_scale: Floats  # R, diagonal
    column_scale: Floats  # S, diagonal
    scaled: Floats  # R D S

    @classmethod
    def of(cls, equations: Equations, D: Sparse) -> Constraints:
        scaled = np.asarray(D.todense()) * equations.scale
        length = np.linalg.norm(scaled, axis=1)
        R = np.divide(1.0, length, out=np.ones_like(length), where=length > 0)
        scaled *= R[:, None]
        U, sigma, Vt = np.linalg.svd(scaled, full_matrices=False)
        return cls(U, sigma, Vt.T, R, equations.scale, scaled)

    @property
    def rank(self) -> int:
        largest = self.sigma[0] if len(self.sigma) else 0.0
        return int(np.count_nonzero(self.sigma > RANK_TOLERANCE * largest))

    def solve(self, b: Floats) -> Floats:
        """The shortest x (6n,) with D x = b (m,), in the sense of least squares."""
        k = self.rank
        y = (self.U[:, :k].T @ (self.row_scale * b)) / self.sigma[:k]
        x: Floats = self.column_scale * (self.V[:, :k] @ y)
        return x

    def solve_transposed(self, f: Floats) -> Floats:
        """The smallest lambda (m,), in scaled rows, with D^T lambda = f (6n,), by least squares."""
        k = self.rank
        y = (self.V[:, :k].T @ (self.column_scale * f)) / self.sigma[:k]
        multipliers: Floats = self.row_scale * (self.U[:, :k] @ y)
        return multipliers

    def smallest(self, count: int) -> float:
        """The singular value on which the solution depends most, of `count` that there are away from singular
        poses; 0 where one of them is missing."""
        return float(self.sigma[count - 1]) if 0 < count <= len(self.sigma) else 0.0

    def weakest_rows(self, count: int) -> NDArray[np.intp]:
        """Rows that nearly depend on each other, the strongest first: left vector of that singular value."""
        share = np.abs(self.U[:, count - 1])
        order = np.argsort(-share, kind="stable")
        chosen: NDArray[np.intp] = order[share[order] > 0.1 * share[order[0]]]
        return chosen


def null_space(equations: Equations, D: Sparse) -> Floats:
    """Z (6n, f): a basis of the motions with D x = 0, orthonormal in scaled columns."""
    from scipy.linalg import qr

    scaled = np.asarray(D.todense()) * equations.scale
    length = np.linalg.norm(scaled, axis=1, keepdims=True)
    scaled = np.divide(scaled, length, out=np.zeros_like(scaled), where=length > 0)
    _, sigma, Vt = np.linalg.svd(scaled, full_matrices=True)
    rank = int(np.count_nonzero(sigma > RANK_TOLERANCE * sigma[0])) if len(sigma) and len(scaled) else 0
    Z = Vt[rank:].T
    if Z.shape[1] > 1:  # turned so that each column has one coordinate to itself
        _, _, order = qr(Z.T, mode="economic", pivoting=True)
        Z = Z @ np.linalg.inv(Z[order[: Z.shape[1]]])
        Z, _ = np.linalg.qr(Z)
    basis: Floats = equations.scale[:, None] * Z
    return basis
