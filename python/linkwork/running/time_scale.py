"""How long a mechanism is worth looking at, where nobody says: by size, gravity, speeds and functions."""

from __future__ import annotations

import numpy as np

from linkwork.modeling.model import Model

__all__ = ["TOLERANCE", "size", "usual_end"]

#: Of steps that are chosen where nobody chooses any.
TOLERANCE = 1e-6

#: Swings, or turns, in a run.
PERIODS = 3.0


def usual_end(model: Model) -> tuple[float, str]:
    """An end [s] that shows the motion, 1, 2 or 5 times a power of ten, and what it comes from."""
    core = model.compiled()
    gravity, length = float(np.linalg.norm(core.gravity)), size(model)
    v = core.v0.reshape(-1, 6)
    fastest = max(
        np.linalg.norm(v[:, :3], axis=1).max(initial=0.0) / length, np.abs(v[:, 3:]).max(initial=0.0)
    )
    tables = [last for _, function in model.signals for last in function.span if 0.0 < last < np.inf]
    if tables:
        return float(min(tables)), "where the first of its tables ends"
    if fastest > 0.0 and not gravity > 0.0:
        return _round(PERIODS * 2 * np.pi / fastest), f"from its speed, {fastest:.3g} rad/s"
    if gravity > 0.0:
        period = 2 * np.pi * np.sqrt(length / gravity)
        return _round(PERIODS * period), f"from its size, {length:.3g} m, which swings in {period:.2g} s"
    return 1.0, "as nothing in it tells"


def size(model: Model) -> float:
    """The longest arm from a center of mass to a joint, or the way between bodies, or 1 [m]."""
    core = model.compiled()
    if arm := float(core.longest_arm):
        return arm
    spread = np.ptp(core.q0.reshape(-1, 7)[:, :3], axis=0) if core.body_count else np.zeros(3)
    return float(np.linalg.norm(spread)) or 1.0


def _round(t: float) -> float:
    power = 10.0 ** np.floor(np.log10(t))
    return float(f"{min((1, 2, 5, 10), key=lambda step: abs(np.log(step * power / t))) * power:.0e}")
