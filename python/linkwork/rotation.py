"""Rotations by Euler parameters p = (e0, e1, e2, e3), scalar first; A(p) turns body axes to inertial.

All functions take stacks: the last one or two axes are the vector or matrix.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from linkwork.arguments import array
from linkwork.arrays import Floats, near_one, pieces
from linkwork.errors import ModelError

__all__ = ["about", "between", "from_axes", "from_matrix", "matrix", "perpendicular"]

#: Of the products of a rotation matrix' columns, beyond which it is none; of squares of unit vectors.
ORTHONORMAL = 1e-3

#: 1 + cos of the angle between vectors that are opposite to each other.
OPPOSITE = 1e-14


def matrix(p: ArrayLike) -> Floats:
    """A(p) (..., 3, 3) of unit Euler parameters p (..., 4).

        x_axes = lw.rotation.matrix(result.body("rod").orientation)[..., 0]

    A = (2 e0^2 - 1) I + 2 (e e^T + e0 e~)
    ModelError: p of another length.
    """
    p = _vectors(p, 4, "matrix: p")
    if p.size and np.abs(np.einsum("...i,...i->...", p, p) - 1).max() > ORTHONORMAL:
        raise ModelError(f"rotation.matrix: p {p!r:.80} is no unit quaternion: divide it by its length",
                         code="euler_parameters")  # fmt: skip
    if p.ndim == 1:
        return _matrix(p)
    result: Floats = np.empty((*p.shape[:-1], 3, 3))
    for piece in pieces(len(p)):
        result[piece] = _matrix(p[piece])
    return result


def about(axis: ArrayLike, angle: ArrayLike) -> Floats:
    """
    Euler parameters (..., 4) of a turn by `angle` (...) [rad] about `axis` (..., 3), of any length.

        p = lw.rotation.about((0, 0, 1), np.pi / 2)
    """
    half = _numbers(angle, "about: angle")[..., None] / 2
    if not np.isfinite(half).all():
        raise ModelError(f"rotation.about: angle {angle!r:.80} is not finite", code="not_finite")
    e = np.sin(half) * _unit(_vectors(axis, 3, "about: axis"), "about: axis")
    e0 = np.broadcast_to(np.cos(half), (*e.shape[:-1], 1))
    return np.concatenate([e0, e], axis=-1)


def from_matrix(A: ArrayLike) -> Floats:
    """Euler parameters (..., 4), e0 >= 0, of rotation matrices A (..., 3, 3).

        p = lw.rotation.from_matrix(np.eye(3))

    4 p p^T follows from the entries of A; its longest column is the one to divide by (Shepperd 1978).
    ModelError: another matrix, a reflection among them, as eigenvectors may be.
    """
    A = _numbers(A, "from_matrix: A")
    if A.shape[-2:] != (3, 3) or not (np.abs(A @ np.swapaxes(A, -1, -2) - np.eye(3)) <= ORTHONORMAL).all():
        raise ModelError(
            f"rotation.from_matrix: A {A!r:.80} is no rotation matrix (..., 3, 3)", code="rotation"
        )
    if (np.linalg.det(A) < 0).any():
        raise ModelError(
            f"rotation.from_matrix: A {A!r:.80} is a reflection, of determinant -1: change the sign of one "
            "of its columns",
            code="rotation",
        )
    trace = np.trace(A, axis1=-2, axis2=-1)[..., None, None]
    antisymmetric = A - np.swapaxes(A, -1, -2)
    s = np.stack([antisymmetric[..., 2, 1], antisymmetric[..., 0, 2], antisymmetric[..., 1, 0]], axis=-1)
    products = np.empty((*A.shape[:-2], 4, 4))
    products[..., :1, :1] = 1 + trace
    products[..., 0, 1:] = products[..., 1:, 0] = s
    products[..., 1:, 1:] = A + np.swapaxes(A, -1, -2) + (1 - trace) * np.eye(3)
    longest = np.argmax(np.diagonal(products, axis1=-2, axis2=-1), axis=-1)[..., None, None]
    p = np.take_along_axis(products, longest, axis=-1)[..., 0]
    p *= np.where(p[..., :1] < 0, -1.0, 1.0) / np.linalg.norm(p, axis=-1, keepdims=True)
    return p


def from_axes(x: ArrayLike, y: ArrayLike) -> Floats:
    """
    Euler parameters (..., 4) of a body with its x axis along `x` (..., 3), its y axis nearest to `y`.

        p = lw.rotation.from_axes(x=(0, 0, 1), y=(0, 1, 0))
    """
    x = _unit(_vectors(x, 3, "from_axes: x"), "from_axes: x")
    z = _unit(np.cross(x, _vectors(y, 3, "from_axes: y")), "from_axes: x across y")
    return from_matrix(np.stack([x, np.cross(z, x), z], axis=-1))


def perpendicular(z: ArrayLike) -> Floats:
    """A unit vector (..., 3) perpendicular to each z (..., 3), always the same for the same z.

        x = lw.rotation.perpendicular((0, 0, 1.0))

    The inertial axis that is farthest from z is projected; at a tie the first one.
    """
    z = _unit(_vectors(z, 3, "perpendicular: z"), "perpendicular: z")
    farthest = np.eye(3)[np.argmin(np.abs(z), axis=-1)]
    return _unit(farthest - np.sum(farthest * z, axis=-1, keepdims=True) * z, "perpendicular: z")


def between(a: ArrayLike, b: ArrayLike) -> Floats:
    """
    The shortest rotation (..., 3, 3) that turns unit vectors a (..., 3) into b, not opposite to a.

        A = lw.rotation.between((1, 0, 0), (0, 1, 0))

    ModelError: vectors of other lengths, or opposite to each other.
    """
    a, b = _vectors(a, 3, "between: a"), _vectors(b, 3, "between: b")
    cos = np.sum(a * b, axis=-1)
    if not np.isfinite(cos).all():
        raise ModelError("rotation.between: a or b is not finite", code="not_finite")
    for what, vector in (("a", a), ("b", b)):
        if (np.abs(np.sum(vector * vector, axis=-1) - 1) > ORTHONORMAL).any():
            raise ModelError(f"rotation.between: {what} {vector!r:.80} is no unit vector", code="unit_vector")
    if (1 + cos < OPPOSITE).any():
        raise ModelError(
            "rotation.between: a and b are opposite to each other: half a turn about which axis? "
            "Give rotation.about(axis, np.pi)",
            code="opposite",
        )
    tilde = _skew(np.cross(a, b))
    turn: Floats = np.eye(3) + tilde + tilde @ tilde / (1 + cos)[..., None, None]
    return turn


def _numbers(given: ArrayLike, what: str) -> Floats:
    """ModelError: it is not made of numbers; text is none, which would have a unit."""
    return array(given, f"rotation.{what}", ModelError, texts=False)


def _vectors(given: ArrayLike, size: int, what: str) -> Floats:
    """ModelError: no numbers, or not so many along the last axis."""
    vectors = _numbers(given, what)
    if vectors.shape[-1:] != (size,):
        raise ModelError(f"rotation.{what} has shape {vectors.shape}, not (..., {size})", code="shape")
    return vectors


def _unit(a: Floats, what: str) -> Floats:
    """ModelError: a vector without a direction."""
    a = near_one(a)
    length = np.linalg.norm(a, axis=-1, keepdims=True)
    if not (length > 0).all():
        raise ModelError(f"rotation.{what} has no direction", code="zero_axis")
    unit: Floats = a / length
    return unit


def _matrix(p: Floats) -> Floats:
    e0, e = p[..., :1, None], p[..., 1:]
    result: Floats = (2 * e0**2 - 1) * np.eye(3) + 2 * (e[..., :, None] * e[..., None, :] + e0 * _skew(e))
    return result


def _skew(a: Floats) -> Floats:
    """a~ (..., 3, 3) with a~ b = a x b."""
    tilde = np.zeros((*a.shape, 3))
    tilde[..., 2, 1], tilde[..., 0, 2], tilde[..., 1, 0] = a[..., 0], a[..., 1], a[..., 2]
    antisymmetric: Floats = tilde - np.swapaxes(tilde, -1, -2)
    return antisymmetric
