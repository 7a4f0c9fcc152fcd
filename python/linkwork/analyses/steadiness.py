"""Whether a state in motion is steady but for its last digits, such as one that a run has come to."""

from __future__ import annotations

import numpy as np

from linkwork.analyses.equations import LAST_DIGITS, Equations, Sparse
from linkwork.arrays import Floats

__all__ = ["is_nearly_steady"]

#: How far it may be from a steady one: positions in sizes of the mechanism and rad, velocities relative to
#: the largest; and what no such difference explains of its accelerations, relative.
NEAR, UNEXPLAINED = 1e-6, 1e-6

#: Of the largest coefficient: those of motions that change no force.
NEUTRAL = 1e-10


# Z^T M a = -Z^T (K dx + C dv) with the least dx = L Z y, dv = |v| Z u
def is_nearly_steady(eq: Equations, v: Floats, unbalanced: Floats, K: Sparse, C: Sparse, Z: Floats) -> bool:
    """Whether a small motion along Z (6n, f), and other velocities, take away the accelerations: forces
    `unbalanced` (6n,)."""
    speed = float(np.abs(v / eq.scale).max(initial=0.0))
    forces = Z.T @ unbalanced
    change = np.hstack([eq.length * (Z.T @ (K @ Z)), speed * (Z.T @ (C @ Z))])
    if not change.any():
        return False
    difference = np.linalg.lstsq(change, forces, rcond=NEUTRAL)[0]
    left = np.linalg.norm(forces - change @ difference)
    rounding = LAST_DIGITS * np.abs(change).max()
    near = np.abs(difference).max() <= NEAR
    return bool(near and left <= UNEXPLAINED * np.linalg.norm(forces) + rounding)
