"""The motion that the joints leave in which a mechanism at rest is softest."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from linkwork.analyses.eigenmodes import softest_by_lanczos
from linkwork.analyses.kinks import Kink, kink
from linkwork.analyses.stiffness import has_potential, scaled, stiffness_and_parts
from linkwork.arrays import Floats
from linkwork.constraints.equations import Equations, Sparse
from linkwork.constraints.solver import DENSE, null_space
from linkwork.errors import NotFiniteError
from linkwork.motion.records import Snapshot

__all__ = ["Softest", "softest"]

#: Stiffness below this part of the terms that it is the sum of, and of the largest, counts as none.
NEUTRAL, EPSILON = 1e-9, 1e-14


class Softest(NamedTuple):
    stiffness: float  # [N/m]; NaN: the joints leave no motion
    motion: Floats  # (6n,)
    neutral: float  # which stiffness would be rounding of the terms that it is the sum of [N/m]
    kink: Kink | None  # where there is one stiffness is none
    symmetric: bool  # the stiffness of what has a potential, which alone decides whether motions grow


def softest(eq: Equations, q: Floats, multipliers: Floats) -> Softest:
    """At rest at t = 0. NotFiniteError."""
    rest = np.zeros(6 * eq.core.body_count)
    found = stiffness_and_parts(eq, 0.0, q, rest, multipliers)
    D = eq.terms(0.0, q).D
    D = D[eq.independent(D)]
    symmetric = bool(eq.holonomic.all()) and has_potential(eq, found)
    value, x = _smallest(eq, found.K, D, symmetric)
    noise = float(found.rounding(x, NEUTRAL)) / (float(np.sum((x / eq.scale) ** 2)) or 1.0)
    at = Snapshot(0.0, q.reshape(-1, 7), rest.reshape(-1, 6))
    return Softest(
        value, x, noise + EPSILON * _stiffest(eq, found.parts), kink(eq, at, D, found.doubt), symmetric
    )


def _smallest(eq: Equations, K: Sparse, D: Sparse, symmetric: bool) -> tuple[float, Floats]:
    if D.shape[1] > DENSE:
        from scipy.sparse import diags_array

        W = diags_array(1 / eq.scale**2).tocsr()
        return softest_by_lanczos(W, (K + K.T) / 2, D, _stiffest(eq, K))
    Z = null_space(eq, D)
    if not Z.shape[1]:
        return np.nan, np.zeros(len(Z))
    k = Z.T @ (K @ Z)
    if not np.isfinite(k).all():
        raise NotFiniteError(
            "the stiffness about the equilibrium is not finite: masses, forces or lengths are too large",
            code="not_finite",
        )
    values, y = np.linalg.eigh((k + k.T) / 2) if symmetric else np.linalg.eig(k)
    lowest = int(np.argmin(values.real))
    return float(values[lowest].real), Z @ y[:, lowest].real


def _stiffest(eq: Equations, K: Sparse) -> float:
    return float(abs(scaled(eq, K)).max()) if K.nnz else 0.0
