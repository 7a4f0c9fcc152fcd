"""What constraints leave: motions along which they hold, and motions that correct them.

D is scaled: its columns of rotations by the size of the mechanism, each row to length 1. So its singular
values are numbers between 0 and sqrt(m) without unit, whatever the model is made of. Small models get its
singular values, large ones its sparse triangular factors and the weakest direction only.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.constraints.equations import LAST_DIGITS, LISTED, Equations, Sparse
from linkwork.constraints.row_choice import scaled_rows
from linkwork.errors import LinkworkError, SingularSystemError, warn

__all__ = [
    "DENSE", "Constraints", "SparseConstraints", "balance", "check_regular", "constraints_of", "free_motions",
    "null_space", "saddle_point", "shared", "strongest",
]  # fmt: skip

#: Up to so many columns of D dense matrices are the faster ones.
DENSE = 480

#: In place of a pivot of zero, and steps toward the smallest singular value.
SMALLEST_PIVOT, INVERSE_ITERATIONS = 1e-13, 6

#: Singular values below this part of the largest count as zero.
RANK_TOLERANCE = 1e-9

#: Of the smallest singular value: what keeps factors regular where it is zero, in its square.
LEAST_SQUARE = 1e-16

#: Violations of joints, relative to the size of the mechanism, that are the error of a pose, at most.
DRIFT = 1e-10

#: By how much what joints leave and take may be off, relative: nothing is known any more, and that is told.
SINGULAR, INEXACT = 1e-3, 1e-5

#: Forces of joints, relative to the largest, by which two sets of multipliers may differ and be the same.
SAME_FORCES = 1e-12


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

    def weakest(self, count: int) -> Floats:
        """Left vector (m,) of that singular value, in scaled rows: how they nearly depend on each other."""
        left: Floats = self.U[:, count - 1]
        return left

    def contradiction(self, Phi: Floats) -> Floats:
        """What of Phi (m,) no motion corrects, in scaled rows: how rows contradict each other."""
        scaled, independent = self.row_scale * Phi, self.U[:, : self.rank]
        left: Floats = scaled - independent @ (independent.T @ scaled)
        return left

    def turns(self, other: Any) -> bool:
        """Whether D may have lost its rank between two poses that are near: singular values that passed
        through zero are negative in U^T D_2 V, be they an even number, which its determinant does not tell.
        """
        there = self.U.T @ other.scaled @ self.V
        return bool(np.linalg.eigvalsh(there + there.T)[:1].sum() < 0)


@dataclass(frozen=True)
class SparseConstraints:
    """Triangular factors of R D S, of as many independent rows as there are motions: nothing is left free.

    Its smallest singular value by inverse iteration; where that is zero, solutions leave its direction out.
    The smallest singular values of long chains are small everywhere: `unit` is what counts as one.
    """

    rows: NDArray[np.intp]  # that are independent
    scaled: Sparse  # R D S of all rows
    factor: Any  # of these rows
    row_scale: Floats
    column_scale: Floats
    sigma: float
    left: Floats  # singular vectors of sigma
    right: Floats
    unit: float

    @classmethod
    def of(cls, equations: Equations, D: Sparse, unit: float = 1.0) -> SparseConstraints:
        rows = equations.independent(D)
        if len(rows) != D.shape[1]:
            raise _singular(equations)
        every, R = scaled_rows(D, equations.scale)
        factor = _factor(every[rows])
        right = np.random.default_rng(0).standard_normal(len(rows))
        for _ in range(INVERSE_ITERATIONS):
            left = factor.solve(right / np.linalg.norm(right), "T")
            right = factor.solve(left / np.linalg.norm(left))
        sigma = 1 / np.linalg.norm(right)
        left, right = left / np.linalg.norm(left), right * sigma
        return cls(rows, every, factor, R, equations.scale, float(sigma), left, right, unit)

    @property
    def rank(self) -> int:
        return len(self.rows) - int(self.sigma <= RANK_TOLERANCE * self.unit)

    def solve(self, b: Floats) -> Floats:
        """The x (6n,) that meets the independent rows of D x = b (m,)."""
        y = (self.row_scale * b)[self.rows]
        singular = self.rank < len(self.rows)
        if singular:
            y = y - self.left * (self.left @ y)
        x = self.factor.solve(y)
        x += self.factor.solve(y - self.scaled[self.rows] @ x)
        if singular:
            x = x - self.right * (self.right @ x)
        out: Floats = self.column_scale * x
        return out

    def solve_transposed(self, f: Floats) -> Floats:
        """lambda (m,) with D^T lambda = f (6n,), zero in redundant rows."""
        y = self.column_scale * f
        singular = self.rank < len(self.rows)
        if singular:
            y = y - self.right * (self.right @ y)
        z = self.factor.solve(y, "T")
        if singular:
            z = z - self.left * (self.left @ z)
        multipliers = np.zeros(len(self.row_scale))
        multipliers[self.rows] = z
        return self.row_scale * multipliers

    def smallest(self, count: int) -> float:
        """The smallest singular value, in units of `unit`."""
        return self.sigma / self.unit

    def weakest(self, count: int) -> Floats:
        """As that of Constraints; zero in rows that are redundant."""
        left = np.zeros(len(self.row_scale))
        left[self.rows] = self.left
        return left

    def contradiction(self, Phi: Floats) -> Floats:
        """As that of Constraints, by the redundant row that is off most, and those on which it depends."""
        left = self.row_scale * Phi
        left[self.rows] = 0.0
        worst = int(np.abs(left).argmax())
        parts = np.zeros_like(left)
        parts[self.rows] = -self.factor.solve(self.scaled[[worst]].toarray()[0], "T")
        parts[worst] = 1.0
        parts *= left[worst]
        return parts

    def turns(self, other: Any) -> bool:
        """As that of Constraints, by the smallest singular value, of the same rows."""
        same = np.array_equal(self.rows, other.rows)
        there = other.factor if same else _factor(other.scaled[self.rows])
        return float(self.left @ there.solve(self.right, "T")) < 0


def strongest(left: Floats) -> NDArray[np.intp]:
    """The rows that count in such a left vector, the strongest first."""
    share = np.abs(left)
    order = np.argsort(-share, kind="stable")
    chosen: NDArray[np.intp] = order[share[order] > 0.1 * share[order[0]]]
    return chosen


def _factor(scaled: Sparse) -> Any:
    """Triangular factors of as many rows as columns."""
    from scipy.sparse import eye_array
    from scipy.sparse.linalg import splu

    try:
        return splu(scaled.tocsc())
    except RuntimeError:  # a pivot of zero: as good as this one
        return splu((scaled + SMALLEST_PIVOT * eye_array(scaled.shape[0])).tocsc())


def constraints_of(equations: Equations, D: Sparse, unit: float = 1.0) -> Constraints | SparseConstraints:
    """Dense for small models; sparse for large ones, of which no freedom may be left."""
    if D.shape[1] <= DENSE:
        return Constraints.of(equations, D)
    return SparseConstraints.of(equations, D, unit)


def free_motions(equations: Equations, D: Sparse, count: int) -> Floats:
    """Up to `count` motions (6n, k) with D x = 0, of length one in scaled columns.

    Of large models what D leaves of random motions.
    """
    if D.shape[1] <= DENSE:
        return null_space(equations.scale, D)[:, :count]
    from scipy.sparse import diags_array

    W, rows = diags_array(1 / equations.scale).tocsr(), equations.independent(D)
    random = np.random.default_rng(0).standard_normal((count, D.shape[1]))
    found = [saddle_point(equations, W @ W, D[rows], W @ b, np.zeros(len(rows))) for b in random]
    left = [x[0] / equations.scale for x in found if x is not None]
    basis: Floats = equations.scale[:, None] * _localized(np.transpose(left)) if left else np.zeros((0, 0))
    return basis


def _localized(Z: Floats) -> Floats:
    """The same space by orthonormal columns, each with one coordinate that is large in no other one."""
    from scipy.linalg import qr

    if Z.shape[1] < 2:
        return Z
    _, _, order = qr(Z.T, mode="economic", pivoting=True)
    Z, _ = np.linalg.qr(Z @ np.linalg.inv(Z[order[: Z.shape[1]]]))
    return Z


def null_space(scale: Floats, D: Sparse) -> Floats:
    """Z (6n, f): a basis of the motions with D x = 0, orthonormal in scaled columns."""
    scaled = np.asarray(D.todense()) * scale
    length = np.linalg.norm(scaled, axis=1, keepdims=True)
    scaled = np.divide(scaled, length, out=np.zeros_like(scaled), where=length > 0)
    _, sigma, Vt = np.linalg.svd(scaled, full_matrices=True)
    rank = int(np.count_nonzero(sigma > RANK_TOLERANCE * sigma[0])) if len(sigma) and len(scaled) else 0
    basis: Floats = scale[:, None] * _localized(Vt[rank:].T)
    return basis


def saddle_point(
    equations: Equations, A: Sparse, D: Sparse, b: Floats, c: Floats
) -> tuple[Floats, Floats] | None:
    """x (6n,) and y (m,) of A x - D^T y = b, D x = c, for D of full row rank; None: singular."""
    from scipy.sparse import csc_array
    from scipy.sparse.linalg import splu

    unit = float(abs(A.diagonal() * equations.scale**2).max()) or 1.0
    scale = np.concatenate([equations.scale, np.full(len(c), unit)])
    own, joints = A.tocoo(), D.tocoo()
    below = joints.row + len(b)
    row = np.concatenate([own.row, joints.col, below])
    column = np.concatenate([own.col, below, joints.col])
    entries = np.concatenate([own.data, -joints.data, joints.data]) * scale[row] * scale[column]
    matrix = csc_array((entries, (row, column)), shape=(len(scale), len(scale)))
    try:
        factor = splu(matrix)
    except RuntimeError:
        return None
    found = scale * factor.solve(scale * np.concatenate([b, c]))
    return found[: len(b)], found[len(b) :]


def balance(equations: Equations, t: float, q: Floats) -> tuple[Floats, Floats, Floats]:
    """r = g + D^T lambda (6n,) at rest, with the lambda (m,) that makes it shortest, and g.

    Shortest in the measure of forces that goes with motions in scaled columns; zero in redundant rows: see
    `shared`. SingularSystemError: independent rows depend on each other in this pose.
    """
    from scipy.sparse import diags_array

    terms = equations.terms(t, q)
    rows = equations.independent(terms.D)
    W = diags_array(1 / equations.scale**2).tocsr()
    found = saddle_point(equations, W, terms.D[rows], terms.g, np.zeros(len(rows)))
    if found is None:
        raise _singular(equations)
    multipliers = np.zeros(equations.core.row_count)
    multipliers[rows] = found[1]
    return W @ found[0], multipliers, terms.g


# Phi is known to delta, by rounding and violations, and so the pose along the weakest direction to
# delta / sigma. By as much D is off, and by delta / sigma^2 what the joints leave and take.
def check_regular(equations: Equations, t: float, q: Floats, pose: str, error: type[LinkworkError]) -> None:
    """`error`: the pose, which is called so in the message, is singular. LinkworkWarning: nearly so."""
    terms = equations.terms(t, q)
    rows = equations.independent(terms.D)
    if not len(rows):
        return
    sigma, left = _weakest(scaled_rows(terms.D[rows], equations.scale)[0])
    off = equations.violation(np.where(equations.holonomic, terms.Phi, 0.0))
    places = float(np.abs(q.reshape(-1, 7)[:, :3]).max()) / equations.length
    delta = min(off, DRIFT) + LAST_DIGITS * max(places, 1.0)
    if delta <= INEXACT * sigma**2:
        return
    names = equations.joints(rows[strongest(left)])
    what = f"{pose} of {equations.called}"
    value = f"(smallest singular value {sigma:.1e})"
    why = f"the equations of {_listed(names)} depend on others for the moment"
    if delta > SINGULAR * sigma**2:
        raise error(
            f"{what} is singular {value}: {why}, so that small motions about it are not linear, as they are "
            "about other poses",
            code="singular_pose",
            joints=names,
        )
    warn(
        f"{what} is nearly singular {value}: {why}, but for little; by what they leave open of the pose "
        f"within rounding small motions and forces of joints may be {100 * delta / sigma**2:.1g} % off"
    )


def _weakest(S: Sparse) -> tuple[float, Floats]:
    """The smallest singular value of S (r, 6n) with r <= 6n, and its left vector (r,)."""
    from scipy.sparse import block_array, eye_array
    from scipy.sparse.linalg import splu

    count, columns = S.shape
    if columns <= DENSE:
        U, sigma, _ = np.linalg.svd(S.toarray(), full_matrices=False)
        return abs(float(sigma[-1])) if count <= columns else 0.0, U[:, -1]
    # inverse iteration with S S^T
    square = LEAST_SQUARE * eye_array(count)
    factor = splu(block_array([[eye_array(columns), S.T], [S, -square]], format="csc"))
    left, rest = np.random.default_rng(0).standard_normal(count), np.zeros(columns)
    for _ in range(INVERSE_ITERATIONS):
        left = factor.solve(np.concatenate([rest, left]))[columns:]
        left /= np.linalg.norm(left)
    return float(np.linalg.norm(S.T @ left)), left


def _singular(equations: Equations) -> SingularSystemError:
    names = equations.joints(equations.rank.singular_rows)
    return SingularSystemError(
        f"of {equations.called} in this pose the equations of {_listed(names) or 'some joints'} "
        "depend on others for the moment; start elsewhere",
        code="singular_pose",
        joints=names,
    )


def _listed(names: list[str]) -> str:
    return ", ".join(names[:LISTED]) + (", ..." if len(names) > LISTED else "")


def shared(equations: Equations, t: float, q: Floats, multipliers: Floats) -> Floats:
    """The same D^T lambda by multipliers (m,) of least norm, shared among redundant rows as in `simulate`.

    What drivers would need to accelerate at t is not in them: they hold at rest.
    """
    from linkwork.equations.system import System

    if not len(multipliers):
        return multipliers
    system = System(equations.model)
    D = equations.terms(t, q).D
    try:
        share = system.accelerations(t, q, np.zeros(6 * equations.core.body_count))[1]
    except LinkworkError:
        share = multipliers
    left = D.T @ (multipliers - share)
    if np.abs(left).max(initial=0.0) <= SAME_FORCES * np.abs(D.T @ multipliers).max(initial=0.0):
        return share
    if D.shape[1] > DENSE:
        return multipliers
    return share + Constraints.of(equations, D).solve_transposed(left)
