"""How fast integrators let the violation of a constraint grow or decay."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats


def damped_roots(alpha_h: float, beta_h: float) -> NDArray[np.complex128]:
    """z = h s for the two roots s of s^2 + 2 alpha s + beta^2 = 0, from alpha h and beta h."""
    root = np.sqrt(np.complex128(alpha_h - beta_h)) * np.sqrt(np.complex128(alpha_h + beta_h))
    return np.array([-alpha_h + root, -alpha_h - root])


def stability(A: Floats, b: Floats, z: complex) -> complex:
    """R(z) = 1 + z b^T (1 - z A)^-1 1 of an explicit method, stage by stage.

    A is strictly lower triangular; a decomposition of 1 - z A would find it singular where z is large.
    """
    stages = np.ones(len(b), complex)
    for i in range(1, len(b)):
        stages[i] += z * (A[i, :i] @ stages[:i])
    return complex(1 + z * (b @ stages))
