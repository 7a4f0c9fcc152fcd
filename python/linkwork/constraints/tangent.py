"""Small motions of bodies: x (n, 6) is a shift of the center of mass and a rotation vector, inertial axes."""

from __future__ import annotations

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats

__all__ = ["between", "displaced", "rate_of_change", "to_body_axes", "to_inertial_axes"]


def displaced(q: Floats, x: Floats) -> Floats:
    """q (7n,) after the motion x (6n,): r + dr, and A turned by the rotation vector, exp(phi~) A."""
    x, out = x.reshape(-1, 6), q.reshape(-1, 7).copy()
    out[:, :3] += x[:, :3]
    turned = np.flatnonzero(x[:, 3:].any(axis=1))  # of few bodies, where derivatives are taken
    if len(turned):
        out[turned, 3:] = _product(_exponential(x[turned, 3:]), out[turned, 3:])
    return out.ravel()


def between(q: Floats, other: Floats) -> Floats:
    """The motion x (6n,) that takes q (7n,) to `other`: the inverse of `displaced`."""
    a, b = q.reshape(-1, 7), other.reshape(-1, 7)
    turn = _product(b[:, 3:], a[:, 3:] * (1, -1, -1, -1))
    turn *= np.where(turn[:, :1] < 0, -1.0, 1.0)
    sine = np.linalg.norm(turn[:, 1:], axis=1, keepdims=True)
    angle = 2 * np.arctan2(sine, turn[:, :1])
    scale = np.divide(angle, sine, out=np.full_like(sine, 2.0), where=sine > 0)
    return np.hstack([b[:, :3] - a[:, :3], scale * turn[:, 1:]]).ravel()


def rate_of_change(q: Floats, x_dot: Floats) -> Floats:
    """q_dot (7n,) of velocities and angular velocities x_dot (6n,): p_dot = (0, omega) p / 2."""
    p, v = q.reshape(-1, 7)[:, 3:], x_dot.reshape(-1, 6)
    w = v[:, 3:]
    scalar = -np.sum(w * p[:, 1:], axis=1, keepdims=True)
    p_dot = np.hstack([scalar, p[:, :1] * w + np.cross(w, p[:, 1:])]) / 2
    return np.hstack([v[:, :3], p_dot]).ravel()


def to_body_axes(q: Floats, x: Floats) -> Floats:
    """x (6n,) with the rotations, velocities or torques in body axes instead of inertial ones: A^T phi."""
    out = x.reshape(-1, 6).copy()
    out[:, 3:] = np.einsum("nji,nj->ni", rotation.matrix(q.reshape(-1, 7)[:, 3:]), out[:, 3:])
    return out.ravel()


def to_inertial_axes(q: Floats, x: Floats) -> Floats:
    """x (6n,) with the rotations, velocities or torques in inertial axes instead of body axes: A phi."""
    out = x.reshape(-1, 6).copy()
    out[:, 3:] = np.einsum("nij,nj->ni", rotation.matrix(q.reshape(-1, 7)[:, 3:]), out[:, 3:])
    return out.ravel()


def _exponential(phi: Floats) -> Floats:
    """Euler parameters (n, 4) of rotation vectors (n, 3)."""
    half = np.linalg.norm(phi, axis=1, keepdims=True) / 2
    p = np.empty((len(phi), 4))
    p[:, :1] = np.cos(half)
    p[:, 1:] = np.sinc(half / np.pi) / 2 * phi
    return p


def _product(a: Floats, b: Floats) -> Floats:
    """Of Euler parameters (n, 4): first the turn b, then a; of unit length."""
    (a0, a1, a2, a3), (b0, b1, b2, b3) = a.T, b.T
    p = np.empty_like(a)
    p[:, 0] = a0 * b0 - a1 * b1 - a2 * b2 - a3 * b3
    p[:, 1] = a0 * b1 + a1 * b0 + a2 * b3 - a3 * b2
    p[:, 2] = a0 * b2 + a2 * b0 + a3 * b1 - a1 * b3
    p[:, 3] = a0 * b3 + a3 * b0 + a1 * b2 - a2 * b1
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    return p
