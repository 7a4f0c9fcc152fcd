"""The two ways in which bodies can be joined by an axis: along it, or turned by 180 degrees."""

from __future__ import annotations

import hashlib
from collections import deque
from functools import cache

import numpy as np
from numpy.typing import NDArray

from linkwork import _core, rotation
from linkwork.arrays import Floats
from linkwork.modeling.elements import KINDS

__all__ = ["aligned", "opposed", "shared_axes"]

Joints = NDArray[np.intp]

#: What was found last, by pose and joints, which many cases have in common.
_LATEST: dict[bytes, Joints] = {}


def opposed(core: _core.Model, q: Floats) -> Joints:
    """Joints of which two axes that should coincide point away from each other, ascending.

    The equations of joints that hold an axis say that it is perpendicular to two others: they hold for the
    opposite axis, too.
    """
    arrays = core.joint_arrays()
    asked = hashlib.blake2b(digest_size=16)
    for of in (q, arrays["bodies"], arrays["frame"], arrays["kind"]):
        asked.update(np.ascontiguousarray(of).data)
    found = _LATEST.get(asked.digest())
    if found is None:
        first, second = _frames(core, q)
        cosines = np.einsum("kia,kia->ka", first, second)
        found = np.flatnonzero(((cosines < 0) & shared_axes(core)).any(axis=1))
        _LATEST.clear()
        _LATEST[asked.digest()] = found
    return found.copy()


def aligned(core: _core.Model, q: Floats, joints: Joints, held: NDArray[np.int32]) -> Floats:
    """q with the axes of these joints made to coincide, by turning what hangs on each about its point.

    In a tree of the joints from the ground, or from a held body, outward; what closes loops follows nothing.
    """
    arrays = core.joint_arrays()
    out, bodies = q.copy().reshape(-1, 7), arrays["bodies"]
    turn = np.zeros(len(bodies), bool)
    turn[joints] = True
    motion: dict[int, tuple[Floats, Floats]] = {-1: (np.eye(3), np.zeros(3))}  # x -> R x + s
    motion |= {int(body): motion[-1] for body in held}
    neighbors: dict[int, list[int]] = {}
    for joint, pair in enumerate(bodies):
        for body in pair:
            neighbors.setdefault(int(body), []).append(joint)
    frames, shared = _frames(core, q), shared_axes(core)
    queue = deque(motion)
    unseen = iter(range(core.body_count))
    while queue or (body := next((b for b in unseen if b not in motion), None)) is not None:
        if not queue:  # hangs on nothing
            motion[body] = motion[-1]
            queue.append(body)
        inner = queue.popleft()
        for joint in neighbors.get(inner, ()):
            side = int(bodies[joint, 0] == inner)  # of the outer body
            outer = int(bodies[joint, side])
            if outer in motion:
                continue
            R, s = motion[inner]
            if turn[joint]:
                half = _half_turn(frames[1 - side][joint], frames[side][joint], shared[joint])
                point = _point(q, outer, arrays["origin"][joint, side])
                R, s = R @ half, R @ (point - half @ point) + s
            motion[outer] = (R, s)
            queue.append(outer)
    for body, (R, s) in motion.items():
        if body >= 0:
            r, A = out[body, :3], rotation.matrix(out[body, 3:])
            out[body, :3], out[body, 3:] = R @ r + s, rotation.from_matrix(R @ A)
    return out.ravel()


def _half_turn(inner: Floats, outer: Floats, shared: NDArray[np.bool_]) -> Floats:
    """The half turn that takes the shared axes of the outer frame nearest to those of the inner."""
    candidates = [2 * np.outer(e, e) - np.eye(3) for e in outer.T]
    return max(candidates, key=lambda H: float(np.sum((inner * (H @ outer))[:, shared])))


def _point(q: Floats, body: int, s: Floats) -> Floats:
    r, p = q[7 * body : 7 * body + 3], q[7 * body + 3 : 7 * body + 7]
    out: Floats = r + rotation.matrix(p) @ s
    return out


def _frames(core: _core.Model, q: Floats) -> tuple[Floats, Floats]:
    """Axes of the joints (joints, 3, 3), columns, as each of the two bodies carries them; inertial."""
    arrays = core.joint_arrays()
    A = np.concatenate([rotation.matrix(q.reshape(-1, 7)[:, 3:]), np.eye(3)[None]])
    first, second = (A[arrays["bodies"][:, k]] @ arrays["frame"][:, k] for k in (0, 1))
    return first, second


def shared_axes(core: _core.Model) -> NDArray[np.bool_]:
    """Which axes of a joint's two frames have to coincide (joints, 3): all, only z, or none."""
    shared: NDArray[np.bool_] = _shared_axes_of_kinds()[core.joint_arrays()["kind"]].reshape(-1, 3)
    return shared


@cache
def _shared_axes_of_kinds() -> NDArray[np.bool_]:
    of_kind = []
    for kind in KINDS["joint"].values():
        locked = {it.axis for it in kind.equations.values() if it.quantity == "rotation"}
        of_kind.append([locked >= {0, 1, 2}] * 2 + [locked >= {0, 1}])
    return np.array(of_kind)
