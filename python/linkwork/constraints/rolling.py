"""Motions along which wheels roll and blades do not slip: positions follow from velocities by integration."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from linkwork.arrays import Floats
from linkwork.constraints.tangent import rate_of_change

__all__ = ["rolled"]

#: Of the integration, relative and absolute.
ACCURACY = 1e-11


def rolled(q: Floats, velocity: Callable[[float, Floats], Floats], start: float, end: float) -> Floats:
    """q (7n,) at `end` after the motion with velocity(t, q) (6n,), in inertial axes."""
    from scipy.integrate import solve_ivp

    def rate(t: float, q: Floats) -> Floats:
        return rate_of_change(q, velocity(t, _normalized(q)))

    options = {"rtol": ACCURACY, "atol": ACCURACY, "first_step": abs(end - start)}
    found = solve_ivp(rate, (start, end), q, "DOP853", **options)
    return _normalized(found.y[:, -1])


def _normalized(q: Floats) -> Floats:
    """With Euler parameters of unit length."""
    out = q.reshape(-1, 7).copy()
    out[:, 3:] /= np.linalg.norm(out[:, 3:], axis=1, keepdims=True)
    return out.ravel()
