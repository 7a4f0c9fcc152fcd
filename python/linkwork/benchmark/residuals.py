"""How well the equations of motion are solved."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.equations.system import System


def residuals(system: System, t: float, y: Floats) -> dict[str, float]:
    """Relative residuals of both block rows of the equations of motion, at t [s] and y = (q, v) (13n,).

    Of all constraints, redundant ones included:

    motion      |M v_dot - D^T lambda - g|_max / |(|M| |v_dot| + |D|^T |lambda| + |g|)|_max
    constraint  |D v_dot - gamma|_max / |(|D| |v_dot| + |gamma|)|_max
    """
    n = system.model.body_count
    q, v = y[: 7 * n], y[7 * n :]
    at, (v_dot, multipliers) = system.evaluate(t, q, v), system.accelerations(t, q, v)
    data, columns, begin = at.D
    rows = np.repeat(np.arange(len(at.gamma)), np.diff(begin))
    d, places, ends = at.inerters
    inerters = np.repeat(np.arange(len(at.inertance)), np.diff(ends))

    def products(M: Floats, d: Floats, D: Floats, x: Floats, forces: Floats) -> tuple[Floats, Floats, Floats]:
        """M x, D^T forces, D x"""
        rates = at.inertance * _sums(inerters, d * x[places], len(at.inertance))
        return (
            np.einsum("bij,bj->bi", M, x.reshape(n, 6)).ravel() + _sums(places, d * rates[inerters], 6 * n),
            _sums(columns, D * forces[rows], 6 * n),
            _sums(rows, D * x[columns], len(at.gamma)),
        )

    inertia, joints, acceleration = products(at.M, d, data, v_dot, multipliers)
    sizes = products(*map(np.abs, (at.M, d, data, v_dot, multipliers)))
    return {
        "motion": _ratio(inertia - joints - at.g, sizes[0] + sizes[1] + np.abs(at.g)),
        "constraint": _ratio(acceleration - at.gamma, sizes[2] + np.abs(at.gamma)),
    }


def _sums(places: NDArray[np.int64], values: Floats, size: int) -> Floats:
    """The values that belong to each place, added."""
    return np.bincount(places, values, size).astype(np.float64)  # of int where there are no values


def _ratio(residual: Floats, size: Floats) -> float:
    largest = float(np.abs(size).max(initial=0.0))
    return float(np.abs(residual).max(initial=0.0)) / largest if largest else 0.0
