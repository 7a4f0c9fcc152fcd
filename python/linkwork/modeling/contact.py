"""Laws of continuous contact: how much a contact loses at a coefficient of restitution."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from linkwork.arguments import number, one_of
from linkwork.errors import OptionError

__all__ = ["contact_hysteresis"]

#: Factor c of F = K d^n (1 + c d_dot / d_dot_0) by the coefficient of restitution.
LAWS: Mapping[str, Callable[[float], float]] = {
    "hunt_crossley": lambda e: 3 * (1 - e) / 2,
    "lankarani_nikravesh": lambda e: 3 * (1 - e**2) / 4,
    "flores": lambda e: 8 * (1 - e) / (5 * e),
}


def contact_hysteresis(law: str, restitution: float) -> float:
    """The parameter `hysteresis` of a contact with this coefficient of restitution, 0 < e <= 1.

        loss = lw.contact_hysteresis("flores", restitution=0.8)

    law  "hunt_crossley" (1975): 3 (1 - e) / 2; "lankarani_nikravesh" (1990): 3 (1 - e^2) / 4, both for hard
         contacts with e near 1; "flores" (Flores, Machado, Silva, Martins 2011): 8 (1 - e) / (5 e), for all e

    OptionError: another law, or a coefficient that is not in (0, 1].
    """
    one_of(law, LAWS, "contact law")
    restitution = number(restitution, "restitution", code="restitution")
    if not 0 < restitution <= 1:
        raise OptionError(
            f"restitution {restitution!r:.80} is not between 0 (exclusive) and 1", code="restitution"
        )
    return LAWS[law](restitution)
