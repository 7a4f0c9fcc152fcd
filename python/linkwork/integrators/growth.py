"""How fast integrators let the violation of a constraint grow or decay."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def damped_roots(alpha_h: float, beta_h: float) -> NDArray[np.complex128]:
    """z = h s for the two roots s of s^2 + 2 alpha s + beta^2 = 0, from alpha h and beta h."""
    root = np.sqrt(complex(alpha_h**2 - beta_h**2))
    return np.array([-alpha_h + root, -alpha_h - root])
