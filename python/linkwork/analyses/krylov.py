"""The largest eigenvalues of an operator, all of those that are equal included."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwork.arrays import Complex, Floats
from linkwork.errors import NotConvergedError

__all__ = ["largest_eigenvalues"]

#: Vectors of a Krylov space, per eigenvalue, and at least; restarts until it is tried with more vectors.
VECTORS, FEWEST, RESTARTS = (2, 4, 8, 16), 20, 300

#: Parts of unit vectors that others leave, which are rounding.
DEPENDENT = 1e-8

#: Eigenvalues that differ by less, relative, are equal; by so much those beside others may be off.
EQUAL, CLOSE = 1e-6, 1e-10

#: Residuals, relative, of what is an eigenvector: where so many are known that others are hardly left, what
#: is found beside them may be none.
RESIDUAL = 1e-7


def largest_eigenvalues(operator: Any, number: int, enough: int, first: Complex) -> tuple[Complex, Complex]:
    """So many eigenvalues (k,) and vectors (n, k), `enough` at least; they are found from the vector `first`.

    A Krylov space has one vector of those that are equal, and others by rounding only. So the largest one is
    looked for beside the vectors that are there, in what the operator leaves of others (Saad, Numerical
    Methods for Large Eigenvalue Problems, 2011, section 4.2), until it is smaller than those, or none by its
    residual, as where hardly any are left.
    """
    theta, z = _by_arnoldi(operator, number, enough, first)
    real = operator.dtype == float
    basis = _orthonormal(np.hstack([z.real, z.imag]) if real else z)
    image = np.zeros((len(basis), 0), basis.dtype)  # operator times the first of these
    for _ in range(number):
        if not len(theta) or len(basis.T) >= operator.shape[0] - FEWEST:
            break
        least = np.sort(np.abs(theta))[-min(number, len(theta))]
        found, w = _largest_beside(operator, basis, first)
        larger = np.abs(found) > least * (1 + EQUAL)
        if not larger.any():
            break
        found, w = found[larger], w[:, larger]
        image = np.hstack([image, _applied(operator, basis[:, image.shape[1] :])])
        inside, coupled = (basis.conj().T @ it for it in (image, _applied(operator, w)))
        whole = w + basis @ _beside(found, inside, coupled)
        exact = _residuals(operator, found, whole) < RESIDUAL
        if not exact.any():
            break
        theta, z = np.append(theta, found[exact]), np.hstack([z, whole[:, exact]])
        basis = np.hstack([basis, _orthonormal(np.hstack([w.real, w.imag]) if real else w)])
    chosen = np.argsort(-np.abs(theta), kind="stable")[:number]
    return theta[chosen], z[:, chosen]


def _largest_beside(operator: Any, basis: Complex, first: Complex) -> tuple[Complex, Complex]:
    """The largest eigenvalue, or a pair, and vectors of what is left of the operator beside those."""
    from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigs

    def left(x: Complex) -> Complex:
        return np.asarray(x - basis @ (basis.conj().T @ x))

    others = LinearOperator(operator.shape, matvec=lambda x: left(operator @ left(x)), dtype=operator.dtype)
    start = others @ np.random.default_rng(1).standard_normal(len(first))
    count = 2 if operator.dtype == float else 1
    for vectors in (FEWEST, 3 * FEWEST):
        try:
            theta, z = eigs(others, k=count, v0=start, ncv=vectors, maxiter=RESTARTS, tol=CLOSE)
            return theta, z
        except ArpackNoConvergence:
            continue
    raise _not_certain(1)


def _beside(theta: Complex, inside: Complex, coupled: Complex) -> Complex:
    """What vectors of the whole operator have of the basis, by the blocks of the operator there."""
    of_each = [it * np.eye(len(inside)) - inside for it in theta]
    return np.array([np.linalg.lstsq(of_each[k], coupled[:, k], DEPENDENT)[0] for k in range(len(theta))]).T


def _residuals(operator: Any, theta: Complex, z: Complex) -> Floats:
    """Relative (k,)."""
    off = np.linalg.norm(_applied(operator, z) - theta * z, axis=0)
    return np.asarray(off / (np.abs(theta) * np.linalg.norm(z, axis=0)))


def _applied(operator: Any, vectors: Complex) -> Complex:
    real = operator.dtype == float and np.iscomplexobj(vectors)
    columns = [operator @ x.real + 1j * (operator @ x.imag) if real else operator @ x for x in vectors.T]
    return np.array(columns).T


def _orthonormal(vectors: Floats | Complex) -> Any:
    lengths = np.linalg.norm(vectors, axis=0)
    U, sigma, _ = np.linalg.svd(vectors[:, lengths > 0] / lengths[lengths > 0], full_matrices=False)
    return U[:, sigma > DEPENDENT]


def _by_arnoldi(operator: Any, number: int, enough: int, first: Complex) -> tuple[Complex, Complex]:
    """Where there are no more than `enough`, others do not converge."""
    from scipy.sparse.linalg import ArpackError, ArpackNoConvergence, eigs

    error: ArpackError | None = None
    for vectors in VECTORS:
        ncv = min(max(vectors * number + 1, FEWEST), operator.shape[0])
        try:
            theta, z = eigs(operator, k=number, v0=first, ncv=ncv, maxiter=RESTARTS)
            return theta, z
        except ArpackNoConvergence as failure:
            error = failure
            if len(failure.eigenvalues) >= enough - 1:  # of a pair one may be left out
                return failure.eigenvalues, failure.eigenvectors
        except ArpackError as failure:  # a Krylov space that is exhausted goes on by chance
            error = failure
    raise _not_certain(number) from error


def _not_certain(number: int) -> NotConvergedError:
    return NotConvergedError(
        f"linearize: the iteration for {number} eigenvalues did not converge, as where very many are equal: "
        "give `near`, a frequency beside those, or ask for more modes",
        code="modes_not_found",
    )
