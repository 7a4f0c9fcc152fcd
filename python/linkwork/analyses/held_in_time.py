"""Whether forces are as stiff, and damp as much, at other times: a linearization holds functions of time as
they are."""

from __future__ import annotations

import numpy as np

from linkwork.analyses.force_derivatives import DOUBT, Doubt
from linkwork.arrays import Floats
from linkwork.constraints.equations import LISTED, Equations
from linkwork.constraints.tangent import displaced
from linkwork.errors import warn
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot

__all__ = ["warn_of_time"]

#: Later by so much [s]: no simple parts of each other, nor of periods.
LATER = (0.00123, 0.0127, 0.119, 0.313, 1.37, 3.79, 11.9, 103.0)


def warn_of_time(eq: Equations, at: Snapshot, doubts: tuple[Doubt, Doubt]) -> None:
    """LinkworkWarning: functions of time change stiffness or damping (`doubts`, whose steps are used)."""
    names = _functions(eq.model)
    if not names:
        return
    random = np.random.default_rng(3)
    x, u = (doubt.h * random.uniform(0.5, 1.0, len(doubt.h)) for doubt in doubts)
    least = np.maximum(*(doubt.noise for doubt in doubts))
    now = _changes(eq, at, at.t, x, u)
    for later in LATER:
        try:
            then = _changes(eq, at, at.t + later, x, u)
        except Exception:  # a function of the user's own need not be known at other times
            continue
        if any((np.abs(b - a) > DOUBT * np.abs(a) + least).any() for a, b in zip(now, then, strict=True)):
            listed = "; ".join(names[:LISTED]) + ("; ..." if names[LISTED:] else "")
            warn(
                f"linearize: stiffness or damping of {eq.called} changes with time ({listed}): frequencies "
                f"and stability are those of what is held as it is at t = {at.t:.6g} s"
            )
            return


def _functions(model: Model) -> list[str]:
    """What may depend on time beside drivers, by name."""
    driving = {name for name, _ in model.drivers}
    return [name for name, _ in model.signals if name not in driving] + [
        name for name, _ in model.user_forces
    ]


def _changes(eq: Equations, at: Snapshot, t: float, x: Floats, u: Floats) -> tuple[Floats, Floats]:
    """Of the forces at t, by a motion and by a velocity, to both sides."""
    q, v = np.ravel(at.q).astype(float), np.ravel(at.v).astype(float)

    def force(q: Floats, v: Floats) -> Floats:
        g: Floats = eq.dynamics.evaluate(t, q, v)["g"]
        return g

    return force(displaced(q, x), v) - force(displaced(q, -x), v), force(q, v + u) - force(q, v - u)
