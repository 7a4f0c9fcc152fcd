"""Semi-implicit (symplectic) Euler."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from linkwork import _core


@dataclass(frozen=True)
class SemiImplicitEuler:
    """v_next = v + h v_dot(t, q, v), then q_next = q + h N(q) v_next."""

    name: str = "semi_implicit_euler"
    order: int = 1
    reference: str = "Hairer, Lubich, Wanner (2006), Geometric Numerical Integration, section I.1"

    def compiled(self) -> _core.SemiImplicitEuler:
        """The same method in the compiled module."""
        return _core.SemiImplicitEuler()

    def growth(self, alpha_h: float, beta_h: float) -> float:
        """As `ButcherTableau.growth`: the spectral radius of the step of (Phi, h Phi_dot)."""
        rate = (-(beta_h**2), 1 - 2 * alpha_h)
        step = np.array([[1 + rate[0], rate[1]], rate])
        return float(np.max(np.abs(np.linalg.eigvals(step))))


SEMI_IMPLICIT_EULER = SemiImplicitEuler()
