"""Eigenvalues s and vectors a of  s^2 a + s c a + k a = 0: damped vibrations of unit mass, by dense matrices.

In first order over z = (w a, a'), w^2 about the diagonal of k, so that slow and quick motions have each the
size of their energies:

    z' = A z,   A = [[0, w], [-k / w, -c]]

By Schur's form, without the balancing of LAPACK's geev: that takes what is the rounding of zero in k for
size, and then spoils eigenvectors (Watkins, A case where balancing is harmful, ETNA 23, 2006).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Complex, Floats

__all__ = ["damped_modes", "rolling_modes"]

#: Of the largest rates: those of motions without stiffness; of the largest terms: their rounding.
SLOWEST, ROUNDING = 1e-8, 1e-14

#: Residuals, relative to their terms, that are mended; in how many steps; and by which part s may change.
SHORT, STEPS, NEAR = 1e-10, 3, 0.1

#: Entries of vectors that are scaled down, and what no divisor is below.
HUGE, TINY = 1e100, 1e-300

#: Singular values of rows that depend on others, and of rates that are zero, relative to the largest.
DEPENDENT, NO_RATE = 1e-9, 1e-10


def damped_modes(c: Floats, k: Floats) -> tuple[Complex, Complex, Floats]:
    """s (2f,), a (f, 2f) of length one, both of conjugate pairs; and what of the residuals is more than
    rounding, over their terms (2f,)."""
    s, a, left = _of_first_order(c, k)
    pair = s.imag > 0
    s = _by_quotients(c, k, s, a, left)
    s, a = _mended(c, k, s, a)
    last_digits = np.finfo(float).eps * float(np.abs(s).max())
    residual, terms, rounding = _sizes(c, k, s, a, last_digits)
    off = _ratio(np.maximum(residual - rounding, 0.0), terms)
    return np.append(s, s[pair].conj()), np.hstack([a, a[:, pair].conj()]), np.append(off, off[pair])


def _of_first_order(c: Floats, k: Floats) -> tuple[Complex, Complex, Complex]:
    """s, a and left vectors (f, .), one of each conjugate pair."""
    from scipy.linalg import rsf2csf, schur

    f, w = len(k), _rates(c, k)
    A = np.block([[np.zeros((f, f)), np.diag(w)], [-k / w, -c]])
    order = np.argsort(-np.abs(A).max(axis=1), kind="stable")  # large first: small ones keep their digits
    real = schur(A[np.ix_(order, order)])
    T, U = rsf2csf(*real)
    s, one = _one_of_each_pair(real[0], T)
    z, y = np.empty((2, 2 * f, len(one)), complex)
    z[order] = U @ _vectors(T)[:, one]
    y[order] = U @ _vectors(T[::-1, ::-1].conj().T)[::-1, ::-1][:, one]
    a = (w[:, None] * z[:f] + s.conj() * z[f:]) / (w[:, None] ** 2 + np.abs(s) ** 2)
    return s, _unit(a), _unit(y[f:])


def _rates(c: Floats, k: Floats) -> Floats:
    """w (f,), powers of two."""
    w = np.sqrt(np.abs(np.diagonal(k)))
    least = SLOWEST * float(w.max()) or SLOWEST * float(np.abs(c).max()) or 1.0
    return np.asarray(np.exp2(np.round(np.log2(np.maximum(w, least)))))


def _one_of_each_pair(blocks: Floats, T: Complex) -> tuple[Complex, NDArray[np.intp]]:
    """Eigenvalues of Schur's real form, in which pairs are blocks, and their places in the complex one T."""
    first = np.flatnonzero(np.diagonal(blocks, -1))
    s = np.diagonal(blocks).astype(complex)
    s[first] += 1j * np.sqrt(np.abs(blocks[first, first + 1])) * np.sqrt(np.abs(blocks[first + 1, first]))
    place = np.arange(len(s))
    place[first] += np.diagonal(T)[first].imag < np.diagonal(T)[first + 1].imag
    one = np.delete(np.arange(len(s)), first + 1)
    return s[one], place[one]


# Where equal eigenvalues share a vector their difference is what rounding leaves of it.
def _vectors(T: Complex) -> Complex:
    """X with T X = X diag(T), both upper triangular."""
    n, s = len(T), np.diagonal(T)
    least = np.finfo(float).eps * float(np.abs(T).max()) or 1.0
    X = np.eye(n, dtype=complex)
    for i in range(n - 2, -1, -1):
        apart = s[i + 1 :] - T[i, i]
        apart[np.abs(apart) < least] = least
        X[i, i + 1 :] = (T[i, i + 1 :] @ X[i + 1 :, i + 1 :]) / apart
        X[:, np.abs(X[i]) > HUGE] /= HUGE
    return X


def _unit(a: Complex) -> Complex:
    length = np.linalg.norm(a, axis=0)
    return np.asarray(a / np.where(length > 0, length, 1.0))


def _by_quotients(c: Floats, k: Floats, s: Complex, a: Complex, left: Complex) -> Complex:
    """s of which the residuals do no work in the left vectors: slow ones beside quick ones gain digits."""
    slope = np.sum(left.conj() * (2 * s * a + c @ a), axis=0)
    work = np.sum(left.conj() * _residuals(c, k, s, a), axis=0)
    new = s - np.divide(work, slope, out=np.zeros_like(work), where=slope != 0)
    new = np.where(s.imag == 0, new.real, new)
    before, after = (np.linalg.norm(_residuals(c, k, it, a), axis=0) for it in (s, new))
    return np.where(after < before, new, s)


def _residuals(c: Floats, k: Floats, s: Complex, a: Complex) -> Complex:
    return np.asarray(s**2 * a + s * (c @ a) + k @ a)


def _relative(c: Floats, k: Floats, s: Complex, a: Complex) -> Floats:
    """Residuals in parts of their terms, or of the rounding of the largest."""
    off, terms, rounding = _sizes(c, k, s, a)
    return _ratio(off, terms + rounding)


def _sizes(c: Floats, k: Floats, s: Complex, a: Complex, least: float = 0.0) -> tuple[Floats, Floats, Floats]:
    """Of the residuals, of their terms, for |s| of `least` at least, and of the rounding of the largest."""
    size, rate = np.abs(a), np.maximum(np.abs(s), least)
    terms = rate**2 * size + rate * (np.abs(c) @ size) + np.abs(k) @ size
    largest = rate**2 + rate * np.linalg.norm(c) + np.linalg.norm(k)
    off = np.linalg.norm(_residuals(c, k, s, a), axis=0)
    return off, np.linalg.norm(terms, axis=0), ROUNDING * largest


def _ratio(part: Floats, of: Floats) -> Floats:
    return np.asarray(np.divide(part, of, out=np.zeros_like(part), where=of > 0))


def _mended(c: Floats, k: Floats, s: Complex, a: Complex) -> tuple[Complex, Complex]:
    """With those that are short by inverse iteration (Ruhe, SIAM J. Numer. Anal. 10, 1973)."""
    off = _relative(c, k, s, a)
    for mode in np.flatnonzero(off > SHORT):
        for _ in range(STEPS):
            found = _inverse_step(c, k, s[[mode]], a[:, [mode]])
            residual = _relative(c, k, *found)
            change = np.abs(found[0] - s[mode]) - NEAR * np.abs(s[mode])
            if not (residual < off[mode] and change <= ROUNDING * np.abs(s).max()):
                break
            s[[mode]], a[:, [mode]] = found
            off[mode] = residual[0]
    return s, a


def _inverse_step(c: Floats, k: Floats, s: Complex, a: Complex) -> tuple[Complex, Complex]:
    """Of one s (1,) and a (f, 1)."""
    slope = 2 * s * a + c @ a
    try:
        z = np.linalg.solve(s**2 * np.eye(len(k)) + s * c + k, slope)
    except np.linalg.LinAlgError:
        return s, a
    new: Complex = s - 1 / np.sum(a.conj() * z, axis=0)
    return np.where(s.imag == 0, new.real, new), _unit(np.asarray(z))


# --- motions along which wheels roll ---


# a' = R a + N u with the velocities u that the rows leave; no force of theirs acts along N:
#   u' = -N^T (c (R a + N u) + k a)
def rolling_modes(c: Floats, k: Floats, D: Floats, E: Floats) -> tuple[Complex, Complex, Floats]:
    """s (j,), a (f, j) of  s^2 a + s c a + k a + D^T mu = 0,  (s D + E) a = 0,  both of conjugate pairs, and
    how far s may be off by rounding, relative (j,).

    D, E (m, f). Motions that stay displaced, and what grows with time from these, have s = 0.
    """
    length = np.linalg.norm(D, axis=1)
    D, E = (it[length > 0] / length[length > 0, None] for it in (D, E))
    U, sigma, Vt = np.linalg.svd(D)
    rank = int(np.count_nonzero(sigma > DEPENDENT * sigma.max(initial=0.0)))
    N, R = Vt[rank:].T, -Vt[:rank].T @ ((U[:, :rank].T @ E) / sigma[:rank, None])
    w = max(np.linalg.norm(R), np.linalg.norm(c), np.sqrt(np.linalg.norm(k))) or 1.0
    s, z, off = _with_exact_zeros(np.block([[R, w * N], [-N.T @ (c @ R + k) / w, -N.T @ c @ N]]))
    a, pair = _unit(z[: len(k)]), s.imag > 0
    return np.append(s, s[pair].conj()), np.hstack([a, a[:, pair].conj()]), np.append(off, off[pair])


def _with_exact_zeros(A: Floats) -> tuple[Complex, Complex, Floats]:
    """s, vectors, and rounding relative to s, one of each conjugate pair. Zeros are split off until what is
    left is regular: rounding makes of double ones the root of what it is."""
    from scipy.linalg import rsf2csf, schur

    left, basis, size, count = A, np.eye(len(A)), float(np.linalg.norm(A, 2)), 0
    while len(left):
        _, sigma, Vt = np.linalg.svd(left)
        zeros = int(np.count_nonzero(sigma <= NO_RATE * size))
        if not zeros:
            break
        turn = Vt[::-1].T  # what has no rate first
        basis[:, count:] = basis[:, count:] @ turn
        left = (turn.T @ left @ turn)[zeros:, zeros:]
        count += zeros
    still, other = basis[:, :count], basis[:, count:]
    if not len(left):
        return np.zeros(count, complex), still.astype(complex), np.zeros(count)
    real = schur(left)
    T, V = rsf2csf(*real)
    s, one = _one_of_each_pair(real[0], T)
    z = V @ _vectors(T)[:, one]
    y = V @ _vectors(T[::-1, ::-1].conj().T)[::-1, ::-1][:, one]
    angle = np.abs(np.sum(_unit(y).conj() * _unit(z), axis=0))
    off = ROUNDING * size / np.maximum(angle * np.abs(s), TINY)
    moved = still.T @ A @ other @ z
    parts = [np.linalg.solve(it * np.eye(count) - still.T @ A @ still, moved[:, k]) for k, it in enumerate(s)]
    vectors = other @ z + still @ np.reshape(parts, (-1, count)).T
    return np.append(np.zeros(count), s), np.hstack([still, vectors]), np.append(np.zeros(count), off)
