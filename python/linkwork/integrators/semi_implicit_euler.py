"""Semi-implicit (symplectic) Euler."""

from __future__ import annotations

from dataclasses import dataclass

from linkwork import _core
from linkwork.integrators.growth import held_growth
from linkwork.integrators.rk4 import RK4


@dataclass(frozen=True)
class SemiImplicitEuler:
    """v_next = v + h v_dot(t, q, v), then q_next = q + h N(q) v_next."""

    name: str = "semi_implicit_euler"
    order: int = 1
    reference: str = "Hairer, Lubich, Wanner (2006), Geometric Numerical Integration, section I.1"

    def compiled(self) -> _core.SemiImplicitEuler:
        """The same method in the compiled module."""
        return _core.SemiImplicitEuler(RK4.compiled())

    def growth(self, alpha_h: float, beta_h: float) -> float:
        """As `ButcherTableau.growth`: one evaluation a step, whose term is held, with s = 1."""
        return held_growth(alpha_h, beta_h, 1.0)

    sampled_growth = growth


SEMI_IMPLICIT_EULER = SemiImplicitEuler()
