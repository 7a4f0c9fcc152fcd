"""How fast integrators let the violation of a constraint grow or decay."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats


def damped_roots(alpha_h: float, beta_h: float) -> NDArray[np.complex128]:
    """z = h s for the two roots s of s^2 + 2 alpha s + beta^2 = 0, from alpha h and beta h."""
    root = np.sqrt(np.complex128(alpha_h - beta_h)) * np.sqrt(np.complex128(alpha_h + beta_h))
    return np.array([-alpha_h + root, -alpha_h - root])


def held_growth(alpha_h: float, beta_h: float, s: float) -> float:
    """By which a violation grows under u = -2 alpha Phi_dot - beta^2 Phi held over a step; s = sum b_i c_i.

    The spectral radius of K of docs/theory/stabilization.md. By its trace and determinant its eigenvalues are
    1 - x +- sqrt(x^2 - (beta h)^2) with x = alpha h + s (beta h)^2 / 2.
    """
    return float(np.max(np.abs(1 + damped_roots(alpha_h + 0.5 * s * beta_h**2, beta_h))))


def added_growth(alpha_h: float, beta_h: float) -> float:
    """The same where a step adds -2 alpha h Phi_dot to Phi_dot and -(beta h)^2 Phi to Phi by itself.

    That is triangular, as Phi_dot enters Phi alone: 1 - 2 alpha h and 1 - (beta h)^2 are its eigenvalues.
    """
    return max(abs(1 - 2 * alpha_h), abs(1 - beta_h**2))


def stability(A: Floats, b: Floats, z: complex) -> complex:
    """R(z) = 1 + z b^T (1 - z A)^-1 1 of an explicit method, stage by stage.

    A is strictly lower triangular; a decomposition of 1 - z A would find it singular where z is large.
    """
    stages = np.ones(len(b), complex)
    for i in range(1, len(b)):
        stages[i] += z * (A[i, :i] @ stages[:i])
    return complex(1 + z * (b @ stages))
