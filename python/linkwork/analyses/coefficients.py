"""The coefficients of small motions about a state, and whether it is in balance."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from linkwork.analyses.force_derivatives import Doubt
from linkwork.analyses.stiffness import Stiffness, damping_and_doubt, stiffness_and_parts, velocity_part
from linkwork.arrays import Floats
from linkwork.constraints.equations import LAST_DIGITS, Equations, Sparse
from linkwork.constraints.solver import DENSE, balance, null_space
from linkwork.constraints.tangent import to_inertial_axes
from linkwork.equations.system import System
from linkwork.errors import ModelError
from linkwork.motion.records import Snapshot

__all__ = ["NEAR", "Coefficients", "coefficients", "refuse_imbalance"]

#: Forces that are not in balance, relative to what acts on their body.
BALANCE = 1e-6

#: How far a state in motion, such as one that a run has come to, may be from a steady one: positions in sizes
#: of the mechanism and rad, velocities relative to the largest; and what no such difference explains of its
#: accelerations, relative.
NEAR, UNEXPLAINED = 1e-6, 1e-6

#: Of the largest coefficient: those of motions that change no force.
NEUTRAL = 1e-10


class Coefficients(NamedTuple):
    """At one state."""

    M: Sparse
    C: Sparse
    K: Sparse
    D: Sparse  # independent rows
    E: Sparse  # of these rows: D x' + E x = 0 of those that `rolling` has, zero in others
    fixed: Sparse  # rows with D x = 0
    rolling: tuple[Sparse, Sparse]  # D and E of rows with D x' + E x = 0: of velocities, in motion
    stiffness: Stiffness
    doubts: tuple[Doubt, Doubt]  # of K and C at a kink of the forces
    multipliers: Floats
    unbalanced: Floats  # (6n,) forces that accelerate the bodies

    @property
    def matrices(self) -> tuple[Sparse, Sparse, Sparse]:
        return self.M, self.C, self.K


def coefficients(eq: Equations, at: Snapshot) -> Coefficients:
    from scipy.sparse import csr_array

    q, v = np.ravel(at.q).astype(float), np.ravel(at.v).astype(float)
    M = eq.mass(q)
    if v.any():
        v_dot, multipliers = System(eq.model).accelerations(at.t, q, v, eq.dynamics.history)
        unbalanced = M @ to_inertial_axes(q, v_dot)
    else:  # of drivers only the present value counts
        unbalanced, multipliers, _ = balance(eq, at.t, q)
    found = stiffness_and_parts(eq, at.t, q, v, multipliers)
    D = eq.terms(at.t, q, v).D
    rows, rolls = eq.independent(D), ~eq.holonomic & bool(v.any())  # at rest they hold the pose, too
    E = velocity_part(eq, at.t, q, v) if rolls.any() else csr_array(D.shape)
    every = np.arange(len(rolls)) if rolls.any() and D.shape[1] <= DENSE else rows
    fixed, rolling = every[~rolls[every]], every[rolls[every]]
    C, doubt = damping_and_doubt(eq, at.t, q, v, eq.length * (abs(found.K) @ eq.scale))
    return Coefficients(
        M, C, found.K, D[rows], E[rows], D[fixed], (D[rolling], E[rolling]),
        found, (found.doubt, doubt), multipliers, unbalanced,
    )  # fmt: skip


def refuse_imbalance(eq: Equations, at: Snapshot, now: Coefficients, near: float = NEAR) -> None:
    """ModelError: forces in the directions that the joints leave, or accelerations."""
    q, v = np.ravel(at.q).astype(float), np.ravel(at.v).astype(float)
    moving = bool(v.any())
    if moving and _is_nearly_steady(eq, v, now, near):
        return
    acting = eq.acting(at.t, q, v, now.multipliers, now.K)
    unbalanced = eq.beyond_rounding(now.unbalanced, q, now.K, acting)
    size = np.abs(unbalanced) / acting
    if size.max() <= BALANCE:
        return
    body, k = divmod(int(size.argmax()), 6)
    value = f"{unbalanced.reshape(-1, 6)[body, k]:.3g} {'N' if k < 3 else 'N m'}"
    name = eq.core.body_name(body)
    why = (
        f"is not in balance: body '{name}' is driven by {value}; start from "
        "linkwork.equilibrium(model).model"
    )
    if moving:
        why = (
            f"accelerates: body '{name}' needs {value} for it; linearize at rest, or in motion in which "
            "no center of mass and no rotation accelerates, such as that of an upright top"
        )
    raise ModelError(f"linearize: {eq.called} {why}", code="not_in_balance", bodies=[name])


# Z^T M a = -Z^T (K dx + C dv) with the least dx = L Z y, dv = |v| Z u
def _is_nearly_steady(eq: Equations, v: Floats, now: Coefficients, near: float) -> bool:
    """Whether a small motion, and other velocities, take away the accelerations. Of large models that is not
    known."""
    if now.D.shape[1] > DENSE:
        return False
    Z = null_space(eq.scale, now.D)
    speed = float(np.abs(v / eq.scale).max(initial=0.0))
    forces = Z.T @ now.unbalanced
    change = np.hstack([eq.length * (Z.T @ (now.K @ Z)), speed * (Z.T @ (now.C @ Z))])
    if not change.any():
        return False
    difference = np.linalg.lstsq(change, forces, rcond=NEUTRAL)[0]
    left = np.linalg.norm(forces - change @ difference)
    rounding = LAST_DIGITS * np.abs(change).max()
    is_near = np.abs(difference).max() <= near
    return bool(is_near and left <= UNEXPLAINED * np.linalg.norm(forces) + rounding)
