"""Whether a mechanism returns to a pose of rest."""

from __future__ import annotations

import warnings
from typing import Literal, NamedTuple

import numpy as np

from linkwork.analyses.linearization import linearize
from linkwork.analyses.softest import Softest
from linkwork.constraints.equations import Equations
from linkwork.constraints.solver import DENSE
from linkwork.errors import LinkworkWarning, ModelError, NotConvergedError
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot

__all__ = ["Judged", "Stability", "judged"]

Stability = Literal["stable", "neutral", "unstable", "unknown"]

#: Where stiffness alone does not decide, and linearize does not, either.
NOT_SYMMETRIC = "wheels roll or forces follow the bodies, so that stiffness does not tell"

#: Growth below this part of the rate of the forces is what rounding makes of eigenvalues that are zero three
#: or four times.
ROUNDED = 1e-4


class Judged(NamedTuple):
    stability: Stability
    softest: float  # [N/m]; NaN: there is none, or it is unknown
    words: str  # the softest motion, or the one that grows; or why it is unknown


def judged(eq: Equations, rest: Model, found: Softest) -> Judged:
    """Of a model at rest in balance, by its stiffness; by its small motions where that is not symmetric."""
    if found.kink:
        return Judged("unknown", np.nan, str(found.kink))
    soft = found.stiffness
    if np.isnan(soft):
        return Judged("stable", soft, "")
    if not found.symmetric and len(eq.scale) > DENSE:  # not all motions are known
        why = f"{NOT_SYMMETRIC}; linkwork.linearize finds single motions that grow"
        return Judged("unknown", np.nan, why)
    kinds: tuple[Stability, ...] = ("unstable", "neutral", "stable")
    kind = kinds[1 + int(np.sign(soft) * (abs(soft) > found.neutral))]
    by_stiffness = Judged(kind, soft, eq.motion(found.motion))
    return by_stiffness if found.symmetric else _by_motions(eq, rest, by_stiffness)


def _by_motions(eq: Equations, rest: Model, by_stiffness: Judged) -> Judged:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", LinkworkWarning)
            small = linearize(rest)
    except (ModelError, NotConvergedError) as error:
        return Judged("unknown", np.nan, f"{NOT_SYMMETRIC}; {error}")
    neutral = by_stiffness.stability == "neutral"
    fastest = int(small.eigenvalues.real.argmax())
    growth = float(small.eigenvalues[fastest].real)
    if small.stable or (neutral and growth <= ROUNDED * _rate(eq, small.snapshot)):
        return by_stiffness._replace(stability="neutral" if neutral else "stable")
    words = f"{by_stiffness.words}; small motions grow by {growth:.4g} 1/s, {small.describe(fastest)}"
    return by_stiffness._replace(stability="unstable", words=words)


def _rate(eq: Equations, at: Snapshot) -> float:
    q, v = np.ravel(at.q), np.ravel(at.v)
    return eq.rate(v, eq.gross_forces(at.t, q, v))
