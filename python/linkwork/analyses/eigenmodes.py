"""Eigenvalues s and motions x of  (s^2 M + s C + K) x + D^T mu = 0,  D x = 0; of what rolls (s D + E) x = 0.

By dense matrices over the motions that D leaves, or by Krylov spaces with D in the matrix that is factorized.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.analyses.damped_modes import damped_modes, rolling_modes
from linkwork.analyses.krylov import largest_eigenvalues
from linkwork.arrays import Complex, Floats
from linkwork.constraints.equations import Sparse
from linkwork.errors import ModelError, NotConvergedError

__all__ = [
    "by_arnoldi", "by_dense_matrices", "by_lanczos", "constrained_solver", "nearest_to", "one_of_each_pair",
    "of_unit_masses", "softest_by_lanczos",
]  # fmt: skip

Indices = NDArray[np.intp]

#: Mass of a motion, relative to the largest, that is none.
MASSLESS = 1e-14

#: Imaginary parts, relative to |s|, that are rounding: of one of a conjugate pair they are positive. And |s|,
#: relative to the shift from which it was found.
REAL = 1e-12

#: Shifts of the spectrum, relative to the largest possible eigenvalues (squares, or themselves): enough for
#: factors where there are neutral motions, and such as are only just enough.
SQUARE_SHIFT, SHIFTS = 1e-8, (1e-4, 1e-6)

#: How often twice as many eigenvalues are asked for, until those that are wanted are certain.
DOUBLINGS = 6

#: Velocities that the joints do not allow, relative, in what is no motion.
ALLOWED = 1e-3

#: In place of zero, where only a division by it is to be avoided.
TINY = 1e-300

#: Distances of eigenvalues from a shift that differ by less, relative, are equal: by so much those of neutral
#: motions may be off.
EQUAL = 1e-6

#: Distances of which neither is called nearer, relative.
AS_NEAR = 1e-4

#: Eigenvalues, relative to a shift next to zero, that those of neutral motions with damping may be off.
NEUTRAL = 1e-4

#: Of the inverse, that are enough for one motion where others are hardly there.
POWERS = 3

#: A shift lies below the smallest eigenvalue by this part of the largest, or of its distance from a bound,
#: where the eigenvalue is known as roughly as this.
BELOW, ROUGH = 0.1, 1e-2


# --- small models ---


def by_dense_matrices(
    M: Sparse, C: Sparse, K: Sparse, Z: Floats, symmetric: bool, rolling: tuple[Sparse, Sparse]
) -> tuple[Complex, Complex, Floats]:
    """Eigenvalues (k,) and shapes (6n, k) over x = Z y, of conjugate pairs both; and what their terms leave,
    relative (k,). `rolling`: D and E of rows that roll."""
    from scipy.linalg import eigh

    m, c, k = (Z.T @ (a @ Z) for a in (M, C, K))
    f = len(m)
    if not f:
        return np.zeros(0, complex), np.zeros((len(Z), 0), complex), np.zeros(0)
    unit = _unit_masses((m + m.T) / 2)
    m, c, k = (unit[:, None] * a * unit for a in ((m + m.T) / 2, c, k))
    _, y = eigh((k + k.T) / 2, m)
    squares, shapes = _quotients(k, m, y), Z @ (unit[:, None] * y)
    if rolling[0].shape[0]:
        s, a, off = rolling_modes(y.T @ c @ y, y.T @ k @ y, *(rows @ shapes for rows in rolling))
        return s, shapes @ a, off
    if symmetric and not C.count_nonzero():
        return _from_squares(squares), shapes.astype(complex), np.zeros(f)
    # a'' + c a' + k a = 0 over motions y without damping: their rates may be far apart
    s, a, off = damped_modes(y.T @ c @ y, np.diag(squares) if symmetric else y.T @ k @ y)
    return s, shapes @ a, off


def _unit_masses(m: Floats) -> Floats:
    """Factors (f,) of the motions by which each has the mass 1. ModelError: one moves no mass."""
    diagonal = np.diagonal(m)
    unit = 1 / np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    values = np.linalg.eigvalsh(unit[:, None] * m * unit)
    if values[0] <= MASSLESS * values[-1]:
        raise ModelError(
            "linearize: a motion that the joints allow moves no mass: give its bodies mass and inertia",
            code="massless",
        )
    return np.asarray(unit)


def of_unit_masses(M: Sparse, Z: Floats) -> Floats:
    """Y (6n, f) with Y^T M Y = 1, of the motions Z (6n, f). ModelError: one moves no mass."""
    m = Z.T @ (M @ Z)
    unit = _unit_masses((m + m.T) / 2)
    L = np.linalg.cholesky(unit[:, None] * ((m + m.T) / 2) * unit)
    return np.asarray(np.linalg.solve(L, (Z * unit).T).T, dtype=float)


def _quotients(K: Any, M: Any, x: Floats) -> Floats:
    """Rayleigh's quotients (k,) of x (n, k): slow motions beside quick ones have more digits by them."""
    return np.asarray(np.sum(x * (K @ x), axis=0) / np.sum(x * (M @ x), axis=0))


def _from_squares(squares: Floats) -> Complex:
    """s = i omega of omega^2, real where it is negative."""
    root = np.sqrt(np.abs(squares))
    return np.where(squares >= 0, 1j * root, root)


def one_of_each_pair(s: Complex) -> Indices:
    """Their places, slow ones first."""
    places = np.flatnonzero(s.imag >= -REAL * np.abs(s))
    return places[np.argsort(np.abs(s[places]), kind="stable")]


def nearest_to(s: Complex, near: float, count: int | None) -> Indices:
    """The places of so many that are nearest to i near, in the order that they have."""
    return np.sort(np.argsort(np.abs(s - 1j * near), kind="stable")[:count])


# --- large models ---


def _rate(M: Sparse, C: Sparse | None, K: Sparse) -> float:
    """About the largest that frequencies may be [1/s], 1 without stiffness and damping."""
    heaviest = max(M.diagonal().max(), TINY)
    strongest, stiffest = (0.0 if a is None else float(abs(a).sum(axis=1).max()) for a in (C, K))
    return float(np.sqrt(stiffest / heaviest)) or strongest / heaviest or 1.0


def constrained_solver(A: Sparse, D: Sparse, rows: Sparse | None = None) -> Callable[..., Floats]:
    """b, c = 0 -> x with A x + D^T mu = b, D x = c; with `rows` instead of D there. ModelError: singular."""
    from scipy.sparse import block_array
    from scipy.sparse.linalg import splu

    size = A.shape[0]
    try:
        factor = splu(block_array([[A, D.T], [D if rows is None else rows, None]], format="csc"))
    except RuntimeError as error:
        raise ModelError(
            "linearize: the matrix of the small motions is singular: the pose is singular, or `near` is a "
            "frequency of the model",
            code="singular_pose",
        ) from error
    rest = np.zeros(D.shape[0])

    def solve(b: Floats, c: Floats = rest) -> Floats:
        x: Floats = factor.solve(np.concatenate([b, c]).astype(A.dtype))[:size]
        return x

    return solve


# Of a multiple eigenvalue a Krylov space has one motion, and others by rounding: so it is asked again, for
# one without those that are known, until there is none nearer. In omega^2 others are nearest than in omega:
# so it is asked for more until those are all known that may be nearer to `near`.
def by_lanczos(M: Sparse, K: Sparse, D: Sparse, modes: int, near: float) -> tuple[Complex, Complex]:
    """(K - sigma M) x + D^T mu = M b, D x = 0 solved for each vector b of a Krylov space."""
    from scipy.sparse.linalg import LinearOperator

    symmetric, sigma = (K + K.T) / 2, near**2 or -SQUARE_SHIFT * _rate(M, None, K) ** 2
    solve = constrained_solver(symmetric - sigma * M, D)
    random, free = np.random.default_rng(0), M.shape[0] - D.shape[0]
    squares, x, count = np.zeros(0), np.zeros((M.shape[0], 0)), min(modes, free)
    wanted = count

    def without_known(b: Floats) -> Floats:
        z = solve(b)
        return np.asarray(z - x @ (x.T @ (M @ z)))

    inverse = LinearOperator(M.shape, matvec=without_known, dtype=float)
    while len(squares) < free:
        first = without_known(M @ random.standard_normal(M.shape[0]))
        missing = max(wanted - len(squares), 1)
        more, shapes = _converged(symmetric, M, missing, sigma, inverse, first)
        far = np.sort(np.abs(squares - sigma))[wanted - 1] if len(squares) >= wanted else np.inf
        nearer = np.abs(more - sigma) < (1 - EQUAL) * far
        squares, x = np.append(squares, more[nearer]), np.hstack([x, shapes[:, nearer]])
        if not nearer.any():
            farthest = np.sort(np.abs(_from_squares(squares) - 1j * near))[count - 1]
            if farthest <= _known_to(sigma, (1 + EQUAL) * far, near):
                break
            wanted = min(2 * wanted, free)
    order = np.argsort(np.abs(_from_squares(squares) - 1j * near), kind="stable")[:count]
    return _from_squares(_quotients(symmetric, M, x[:, order])), x[:, order].astype(complex)


def _known_to(sigma: float, radius: float, near: float) -> float:
    """Up to which distance of s from i near all are known, where the radius about sigma has all omega^2."""
    above = np.sqrt(max(sigma + radius, 0.0)) - near
    least = sigma - radius
    below = near - np.sqrt(least) if least > 0 else np.sqrt(near**2 - least)
    return float(min(above, below))


def _converged(
    K: Sparse, M: Sparse, count: int, sigma: float, inverse: Any, first: Floats
) -> tuple[Floats, Floats]:
    """Squares (k,) and motions (6n, k) of at most so many modes: of equal ones not all may be found, and one
    where so many are equal that the Krylov space has hardly another."""
    from scipy.sparse.linalg import ArpackError, ArpackNoConvergence, eigsh

    try:
        squares, x = eigsh(K, k=count, M=M, sigma=sigma, OPinv=inverse, v0=first)
    except ArpackNoConvergence as error:
        if not len(error.eigenvalues):
            raise
        squares, x = error.eigenvalues, error.eigenvectors
    except ArpackError:
        x = first[:, None]
        for _ in range(POWERS):
            x = inverse.matvec(M @ x[:, 0])[:, None]
            x = x / np.sqrt(np.sum(x * (M @ x)))
        squares = _quotients(K, M, x)
    return squares, x


# Where the shift is far from i near others are nearest to it: so it is asked again, from a nearer shift and
# for more, until those are all known that may be nearer to i near.
def by_arnoldi(
    M: Sparse, C: Sparse, K: Sparse, D: Sparse, rolling: tuple[Sparse, Sparse], modes: int, near: float
) -> tuple[Complex, Complex]:
    every = 2 * (D.shape[1] - D.shape[0]) - rolling[0].shape[0]
    count, found = min(modes, every), (np.zeros(0, complex), np.zeros((D.shape[1], 0), complex))
    shifts = [1j * near] if near else [-shift * _rate(M, C, K) for shift in SHIFTS]
    needed = int(np.ceil(np.log2(every / count))) if count else 0
    doublings = min(needed, DOUBLINGS)
    for sigma in shifts if count else ():
        nearest = _nearest(M, C, K, D, rolling, sigma)
        for k in range(doublings + 1 if sigma == shifts[-1] else 1):
            s, shapes, radius = nearest(2 * count * 2**k + 2, every)
            chosen = nearest_to(s, near, count)
            found = s[chosen], shapes[:, chosen]
            farthest = np.abs(found[0] - 1j * near).max() if len(chosen) == count else np.inf
            none_nearer = farthest + abs(sigma - 1j * near) <= (1 + AS_NEAR) * radius
            if none_nearer or (not near and farthest <= NEUTRAL * abs(sigma)):
                return found
    if doublings < needed:
        raise NotConvergedError(
            f"linearize: beside what is stiff here it is not certain which modes are the nearest, of {count} "
            "that are asked for: ask for more, or give `near`",
            code="modes_not_found",
        )
    return found


# With eta = x':  x_new = (x_old's share) of (sigma^2 M + sigma C + K) x_new = -(C + sigma M) x - M eta,
# eta_new = sigma x_new + x: one application of (A - sigma B)^-1 B of the first-order equations. Rows that
# roll are those of velocities, D eta + E x = 0.
def _nearest(
    M: Sparse, C: Sparse, K: Sparse, D: Sparse, rolling: tuple[Sparse, Sparse], sigma: complex
) -> Callable[[int, int], tuple[Complex, Complex, float]]:
    """Of a number, of so many that there are: s nearest to sigma, one of each pair, their shapes, and the
    radius in which these are all."""
    from scipy.sparse import block_array, csr_array, vstack
    from scipy.sparse.linalg import LinearOperator

    real = np.imag(sigma) == 0
    shift = np.real(sigma) if real else sigma
    (of_velocities, E), fixed = rolling, np.zeros(D.shape[0])
    rows = (vstack([D, it]) for it in (of_velocities, shift * of_velocities + E))
    solve = constrained_solver((shift * shift * M + shift * C + K).tocsr(), *rows)
    size = M.shape[0]

    def apply(z: Complex) -> Complex:
        x, eta = z[:size], z[size:]
        new = solve(-(C @ x + shift * (M @ x)) - M @ eta, np.append(fixed, -(of_velocities @ x)))
        return np.concatenate([new, shift * new + x])

    rates = block_array([[csr_array(D.shape), D], [E, of_velocities]], format="csr")  # times (x, x')
    operator = LinearOperator((2 * size, 2 * size), matvec=apply, dtype=float if real else complex)
    allowed = solve(M @ np.random.default_rng(0).standard_normal(size))
    first = np.concatenate([allowed, allowed])

    def found(number: int, every: int) -> tuple[Complex, Complex, float]:
        theta, z = largest_eigenvalues(operator, min(number, 2 * size - 2), min(number, every), first)
        off = np.abs(rates @ z).max(axis=0, initial=0.0)  # a Krylov space that is exhausted has others
        all_terms = (abs(rates) @ np.abs(z)).max(axis=0, initial=0.0)
        size_of_rates = abs(rates).max() if rates.nnz else 0.0
        x, x_dot = (np.abs(it).max(axis=0, initial=0.0) for it in (z[:size], z[size:]))
        rounding = ALLOWED * size_of_rates * np.maximum(ALLOWED**2 * x_dot, np.abs(sigma) * x)
        motion = off <= np.maximum(ALLOWED * all_terms, rounding)  # joints may have no part in it
        s = sigma + 1 / theta[motion]
        s[np.abs(s) <= (NEUTRAL if real else REAL) * np.abs(sigma)] = (
            0.0  # double ones are pairs, by rounding
        )
        one = one_of_each_pair(s)
        return s[one], z[:size, motion][:, one], float(np.abs(1 / theta).max()) if number < every else np.inf

    return found


# Lanczos finds the eigenvalue nearest to the shift: the smallest, if the shift is below all. A safe bound is
# far below, where digits are few: from there the shift goes most of the way up to a rough value.
def softest_by_lanczos(W: Sparse, K: Sparse, D: Sparse, scale: float) -> tuple[float, Floats]:
    """The smallest k of K x + D^T mu = k W x, D x = 0, and its x (6n,).

    K symmetric, W diagonal, `scale` of K in units of W.
    """
    from scipy.sparse.linalg import LinearOperator, eigsh

    if D.shape[0] >= D.shape[1]:
        return np.nan, np.zeros(D.shape[1])
    sigma = min(_lower_bound(W, K), 0.0) - BELOW * (scale or 1.0)
    first = np.random.default_rng(0).standard_normal(W.shape[0])
    for tolerance in (ROUGH, 0.0):
        inverse = LinearOperator(W.shape, matvec=constrained_solver(K - sigma * W, D), dtype=float)
        first = inverse @ (W @ first)
        values, x = eigsh(K, k=1, M=W, sigma=sigma, OPinv=inverse, v0=first, tol=tolerance)
        sigma, first = sigma + (1 - BELOW) * (float(values[0]) - sigma), x[:, 0]
    return float(values[0]), x[:, 0]


def _lower_bound(W: Sparse, K: Sparse) -> float:
    """Of the eigenvalues of K x = k W x, those of W^-1/2 K W^-1/2: Gershgorin's discs."""
    from scipy.sparse import diags_array

    root = diags_array(1 / np.sqrt(W.diagonal()))
    scaled = (root @ K @ root).tocsr()
    diagonal = scaled.diagonal()
    return float((diagonal + np.abs(diagonal) - abs(scaled).sum(axis=1)).min())
