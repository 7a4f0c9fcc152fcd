"""The motion that the joints leave in which a mechanism at rest is softest."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.analyses.eigenmodes import softest_by_lanczos
from linkwork.analyses.kinks import Kink, kink
from linkwork.analyses.stiffness import Stiffness, has_potential, scaled, stiffness_and_parts
from linkwork.arrays import Floats
from linkwork.constraints.equations import Equations, Sparse
from linkwork.constraints.solver import DENSE, null_space
from linkwork.errors import NotFiniteError
from linkwork.motion.records import Snapshot

__all__ = ["Softest", "softest"]

#: Stiffness below this part of the terms that it is the sum of, and of the largest, counts as none.
NEUTRAL, EPSILON = 1e-9, 1e-14

#: Which are looked at one by one.
MOST_PARTS = 2000


class Softest(NamedTuple):
    stiffness: float  # [N/m]; NaN: the joints leave no motion
    motion: Floats  # (6n,)
    neutral: float  # which stiffness would be rounding of the terms that it is the sum of [N/m]
    kink: Kink | None  # where there is one stiffness is none
    symmetric: bool  # the stiffness of what has a potential, which alone decides whether motions grow
    away: Floats  # (6n,): each part that is pushed away, in its own softest motion, as far as any other


def softest(eq: Equations, q: Floats, multipliers: Floats) -> Softest:
    """At rest at t = 0. NotFiniteError."""
    rest = np.zeros(6 * eq.core.body_count)
    found = stiffness_and_parts(eq, 0.0, q, rest, multipliers)
    D = eq.terms(0.0, q).D
    D = D[eq.independent(D)]
    symmetric = bool(eq.holonomic.all()) and has_potential(eq, found)
    at = Snapshot(0.0, q.reshape(-1, 7), rest.reshape(-1, 6))
    away, of_parts = np.zeros_like(rest), _of_parts(eq, found, D, symmetric)
    for value, x, neutral in of_parts:
        if value < -neutral:
            away += x / np.abs(x / eq.scale).max()
    # Of a stiff or large part rounding is more than what others have at all.
    unstable = [it for it in of_parts if it[0] < -it[2]]
    value, x, neutral = min(unstable or of_parts, key=lambda it: np.nan_to_num(it[0], nan=np.inf))
    return Softest(value, x, neutral, kink(eq, at, D, found.doubt), symmetric, away)


def _of_parts(
    eq: Equations, found: Stiffness, D: Sparse, symmetric: bool
) -> list[tuple[float, Floats, float]]:
    """The smallest stiffness, its motion, and which would be rounding, of each part that neither joints nor
    stiffness connects; of very many in one."""
    part = _parts(found.K, D)
    count = int(part.max(initial=0)) + 1
    if count > MOST_PARTS:
        part, count = np.zeros_like(part), 1
    K, D, out = found.K.tocsr(), D.tocsc(), []
    scaled_K, sizes = scaled(eq, K).tocsr(), scaled(eq, found.parts).tocsr()
    for k in range(count):
        own = np.flatnonzero(part == k)
        own_D = D[:, own].tocsr()
        own_D = own_D[np.diff(own_D.indptr) > 0]
        own_K, stiffest = K[own][:, own], _stiffest(scaled_K[own])
        value, motion = _smallest(eq.scale[own], own_K, own_D, symmetric, stiffest)
        x = np.zeros(len(part))
        x[own] = motion
        noise = float(found.rounding(x, NEUTRAL)) / (float(np.sum((x / eq.scale) ** 2)) or 1.0)
        out.append((value, x, noise + EPSILON * _stiffest(sizes[own])))
    return out


def _parts(K: Sparse, D: Sparse) -> NDArray[np.intp]:
    """Of each coordinate (6n,)."""
    from scipy.sparse import eye_array, kron
    from scipy.sparse.csgraph import connected_components

    bodies = kron(eye_array(K.shape[0] // 6), np.ones((6, 6)))
    return np.asarray(connected_components(abs(K) + abs(D).T @ abs(D) + bodies, directed=False)[1])


def _smallest(scale: Floats, K: Sparse, D: Sparse, symmetric: bool, stiffest: float) -> tuple[float, Floats]:
    if D.shape[1] > DENSE:
        from scipy.sparse import diags_array

        W = diags_array(1 / scale**2).tocsr()
        return softest_by_lanczos(W, (K + K.T) / 2, D, stiffest)
    Z = null_space(scale, D)
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


def _stiffest(rows: Sparse) -> float:
    return float(abs(rows).max()) if rows.nnz else 0.0
