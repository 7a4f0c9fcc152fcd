"""How fast integrators let the violation of a constraint grow or decay."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def damped_roots(alpha_h: float, beta_h: float) -> NDArray[np.complex128]:
    """z = h s for the two roots s of s^2 + 2 alpha s + beta^2 = 0, from alpha h and beta h."""
    root = np.sqrt(np.complex128(alpha_h - beta_h)) * np.sqrt(np.complex128(alpha_h + beta_h))
    return np.array([-alpha_h + root, -alpha_h - root])
