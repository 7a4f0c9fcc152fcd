"""Which rows of D are independent: of redundant ones there is a choice, and none is good in every pose."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

__all__ = ["RowChoice", "scaled_rows"]

#: A matrix of scipy.sparse; places of rows.
Sparse = Any
Rows = NDArray[np.intp]

#: Up to so many columns dense factors choose, by pivots.
FEW = 480

#: Rows are chosen anew where one of them comes nearer to the span of others than this part of the farthest
#: seen, and replaced by those that are farther by this factor.
NEARER, BETTER = 0.2, 2.0

#: What keeps dependent rows from a pivot of zero.
FLOOR = 1e-13

#: The most entries of D D^T: there are more where a body has very many joints.
MOST_ENTRIES = 20_000_000


def scaled_rows(D: Sparse, scale: Floats) -> tuple[Sparse, Floats]:
    """R D S in compressed rows, and the R that makes their length 1; S is `scale`."""
    from scipy.sparse.linalg import norm

    scaled = D.multiply(scale[None, :]).tocsr()
    length = norm(scaled, axis=1) if D.shape[0] else np.zeros(0)
    R = np.divide(1.0, length, out=np.ones_like(length), where=length > 0)
    return scaled.multiply(R[:, None]).tocsr(), R


class RowChoice:
    """As many rows of D as are independent in almost every pose, the same ones while they are good.

    The number is that of the rows `first`, of each part of the model that joints connect.
    """

    def __init__(self, first: Rows, part_of_row: Rows, scale: Floats) -> None:
        self.rows, self.part_of_row, self.scale = first, part_of_row, scale
        chosen = np.bincount(part_of_row[first], minlength=part_of_row.max(initial=-1) + 1)
        every = np.bincount(part_of_row, minlength=len(chosen))
        self.parts = np.flatnonzero(every > chosen)  # that have a choice
        self.farthest = np.zeros(len(chosen))

    def of(self, D: Sparse) -> Rows:
        """Ascending; D (m, 6n) by compressed rows."""
        if not len(self.parts):
            return self.rows
        own = np.isin(self.part_of_row, self.parts)
        S = scaled_rows(D, self.scale)[0]
        nearest = self._nearest(S, self.rows[own[self.rows]])
        near = self.parts[nearest[self.parts] < NEARER * self.farthest[self.parts]]
        if len(near):
            nearest = self._replace(S, near, nearest)
        self.farthest = np.maximum(self.farthest, np.where(np.isfinite(nearest), nearest, 0.0))
        return self.rows

    def _replace(self, S: Sparse, parts: Rows, nearest: Floats) -> Floats:
        """In these parts the rows, where others are better; what `nearest` becomes."""
        chosen = [self._choice(S, part) for part in parts]
        found = self._nearest(S, np.concatenate(chosen))
        better = found[parts] > BETTER * nearest[parts]
        kept = self.rows[~np.isin(self.part_of_row[self.rows], parts[better])]
        taken = [rows for rows, is_better in zip(chosen, better, strict=True) if is_better]
        self.rows = np.sort(np.concatenate([kept, *taken]))
        return np.where(np.isin(np.arange(len(nearest)), parts[better]), found, nearest)

    def _nearest(self, S: Sparse, rows: Rows) -> Floats:
        """Of each part the least distance of a row from the span of others; infinite for parts without."""
        out = np.full(len(self.farthest), np.inf)
        np.minimum.at(out, self.part_of_row[rows], distances(S[rows]))
        return out

    def _choice(self, S: Sparse, part: int) -> Rows:
        from scipy.linalg import qr

        rows = np.flatnonzero(self.part_of_row == part)
        count = int(np.count_nonzero(self.part_of_row[self.rows] == part))
        own = S[rows].tocsc()
        columns = np.flatnonzero(np.diff(own.indptr))
        if len(columns) <= FEW:
            order = qr(own[:, columns].toarray().T, mode="r", pivoting=True)[1]
        else:
            order = np.argsort(-distances(own.tocsr()), kind="stable")
        chosen: Rows = rows[order[:count]]
        return chosen


# S S^T = L diag(d) L^T, d_i is the square of that distance (Gram and Schmidt)
def distances(S: Sparse) -> Floats:
    """Of each row, of length 1, from the span of those that are eliminated before it, in an order that keeps
    the triangular factor sparse; infinite where it would not be."""
    from scipy.sparse import eye_array
    from scipy.sparse.linalg import splu

    per_column = np.bincount(S.indices, minlength=S.shape[1]).astype(float)
    if not S.shape[0] or per_column @ per_column > MOST_ENTRIES:
        return np.full(S.shape[0], np.inf)
    factor = splu(
        (S @ S.T + FLOOR * eye_array(S.shape[0])).tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    return np.asarray(np.sqrt(np.abs(factor.U.diagonal()[factor.perm_c])))
