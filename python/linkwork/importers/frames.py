"""Rigid displacements: where one frame is in another."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from linkwork import rotation
from linkwork.arrays import Floats, near_one


@dataclass(frozen=True)
class Frame:
    """Origin r (3,) [m] and rotation A (3, 3) of a frame in another: x in this frame is r + A x there."""

    r: Floats = field(default_factory=lambda: np.zeros(3))
    A: Floats = field(default_factory=lambda: np.eye(3))

    def __matmul__(self, inner: Frame) -> Frame:
        """The frame `inner` of this frame, seen from outside."""
        return Frame(self.r + self.A @ inner.r, self.A @ inner.A)

    @property
    def inverse(self) -> Frame:
        return Frame(-self.A.T @ self.r, self.A.T)

    def point(self, x: Floats) -> Floats:
        """r + A x"""
        point: Floats = self.r + self.A @ x
        return point


def from_rpy(xyz: ArrayLike, rpy: ArrayLike) -> Frame:
    """Origin, and roll, pitch, yaw [rad] as in URDF and SDF: A = A_z(yaw) A_y(pitch) A_x(roll)."""
    (sr, sp, sy), (cr, cp, cy) = np.sin(rpy), np.cos(rpy)
    A = np.array([
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ])  # fmt: skip
    return Frame(np.array(xyz, dtype=float), A)


def from_quaternion(xyz: ArrayLike, p: ArrayLike) -> Frame:
    """Origin and Euler parameters, scalar first, of any length."""
    p = near_one(np.asarray(p, dtype=float))
    return Frame(np.array(xyz, dtype=float), rotation.matrix(p / np.linalg.norm(p)))


def turned(axis: Floats, angle: float) -> Frame:
    """A rotation about an axis of unit length."""
    return Frame(A=rotation.matrix(rotation.about(axis, angle)))
