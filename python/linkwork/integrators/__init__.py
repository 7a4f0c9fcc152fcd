"""Integrators: each is data in a file of its own, registered here by one name.

The compiled drivers run them: all at a fixed step, an `EmbeddedPair` also with steps that follow tolerances.
A new one is a `ButcherTableau`, `EmbeddedPair`, `AdamsBashforth`, `AdamsBashforthMoulton` or `HalfExplicit`;
it can be given to `simulate` directly, or added to METHODS.
"""

from __future__ import annotations

from linkwork.arguments import one_of
from linkwork.integrators.adams import AdamsBashforth, AdamsBashforthMoulton
from linkwork.integrators.adams_bashforth import AB2, AB3, AB4, AB5
from linkwork.integrators.adams_bashforth_moulton import ABM4
from linkwork.integrators.bs32 import BS32
from linkwork.integrators.dop853 import DOP853
from linkwork.integrators.dopri5 import DOPRI5
from linkwork.integrators.embedded_pair import EmbeddedPair
from linkwork.integrators.euler import EULER
from linkwork.integrators.half_explicit import HalfExplicit
from linkwork.integrators.hem4 import HEM4
from linkwork.integrators.heun import HEUN
from linkwork.integrators.phem56 import PHEM56
from linkwork.integrators.rk3 import RK3
from linkwork.integrators.rk4 import RK4
from linkwork.integrators.runge_kutta import ButcherTableau
from linkwork.integrators.semi_implicit_euler import SEMI_IMPLICIT_EULER, SemiImplicitEuler
from linkwork.integrators.tsit5 import TSIT5

__all__ = [
    "METHODS", "AdamsBashforth", "AdamsBashforthMoulton", "ButcherTableau", "EmbeddedPair",
    "HalfExplicit", "Integrator", "SemiImplicitEuler", "named",
]  # fmt: skip

Integrator = ButcherTableau | AdamsBashforth | AdamsBashforthMoulton | HalfExplicit | SemiImplicitEuler

METHODS: dict[str, Integrator] = {
    method.name: method
    for method in (
        *(EULER, SEMI_IMPLICIT_EULER, HEUN, RK3, RK4, AB2, AB3, AB4, AB5, ABM4),
        *(BS32, DOPRI5, TSIT5, DOP853, HEM4, PHEM56),
    )
}


def named(name: str) -> Integrator:
    """The method with this name.

        assert lw.integrators.named("rk4").order == 4

    OptionError: there is none.
    """
    return METHODS[one_of(name, METHODS, "integrator")]
