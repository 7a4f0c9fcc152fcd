"""How joints move: what their kinds hold, their coordinates, and by how much their points are apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from linkwork import rotation
from linkwork.elements import KINDS
from linkwork.header import Floats, Header

if TYPE_CHECKING:
    from linkwork.result import Result

#: Placements of joints that hold directions only: they sit nowhere.
UNPLACED = ("direction", "two_directions", "orientation")

Coordinate = Literal["angle", "displacement"]


@dataclass(frozen=True)
class Holds:
    """What a kind of joint holds, read from the names of its equations."""

    translations: tuple[bool, bool, bool]  #: of the points, along the joint's x, y, z, at zero
    distance: bool  #: between the two points
    rotations: int
    placed: bool  #: it sits at points of its bodies
    turning: bool  #: about its z axis, and about no other
    sliding: bool  #: along its z axis, and along no other

    @classmethod
    def of(cls, kind: str) -> Holds:
        """An unknown kind, from a file of a later version, holds nothing that is known."""
        info = KINDS["joint"].get(kind)
        if info is None:
            return cls((False, False, False), False, 0, True, False, False)
        names = set(info.equations)

        x, y, z = (f"translation {a}" in names or f"translation along joint {a}" in names for a in "xyz")
        if "displacement" in info.parameters:  # it prescribes the translation along z
            z = False
        turns = [f"rotation about joint {a}" in names for a in "xyz"]
        return cls(
            (x, y, z),
            "distance" in names,
            sum(name.startswith("rotation") for name in names),
            info.placement not in UNPLACED,
            turns == [True, True, False],
            (x, y, z) == (True, True, False),
        )

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """Those about and along z that the joint leaves free."""
        free: tuple[tuple[Coordinate, bool], ...] = (("angle", self.turning), ("displacement", self.sliding))
        return tuple(name for name, is_free in free if is_free)


def joint_kinds(header: Header) -> list[Holds]:
    """Of each joint."""
    known = {kind: Holds.of(kind) for kind in set(header.joint_kinds)}
    return [known[kind] for kind in header.joint_kinds]


def gaps(result: Result, joints: NDArray[np.integer], every: int = 1) -> tuple[Floats, Floats]:
    """From each joint's first point to its second (k, j, 3) [m], and its axes (k, j, 3, 3), inertial."""
    header = result.header
    q = _with_ground(result.recorded("q", np.s_[::every]))
    bodies, origin = header.joint_bodies[joints], header.joint_origin[joints]
    turns = [rotation.matrix(q[:, bodies[:, side], 3:]) for side in (0, 1)]
    points = [
        q[:, bodies[:, side], :3] + np.einsum("kjab,jb->kja", turns[side], origin[:, side]) for side in (0, 1)
    ]
    return points[1] - points[0], turns[0] @ header.joint_frame[joints, 0]


def coordinate(result: Result, joint: int, which: Coordinate) -> tuple[Floats, Floats]:
    """A joint's coordinate over time (k,) and its rate (k,): [rad] and [rad/s], or [m] and [m/s].

    angle         of the second body against the first about the joint's z, zero at the start, over full turns
    displacement  of the second point from the first along the joint's z

    With d the vector between the points, w the angular velocities, all inertial:
    angle_dot = z . (w_j - w_i),   displacement_dot = z . (d_dot - w_i x d)
    """
    header = result.header
    i, j = (int(body) for body in header.joint_bodies[joint])
    s_i, s_j = header.joint_origin[joint]
    q, v = _with_ground(result.q), result.v
    v = np.concatenate([v, np.zeros_like(v[:, :1])], axis=1)
    A_i, A_j = rotation.matrix(q[:, i, 3:]), rotation.matrix(q[:, j, 3:])
    w_i, w_j = (np.einsum("kab,kb->ka", A, v[:, body, 3:]) for A, body in ((A_i, i), (A_j, j)))
    axes = A_i @ header.joint_frame[joint, 0]
    z = axes[..., 2]
    if which == "angle":
        relative = np.swapaxes(axes, 1, 2) @ A_j @ header.joint_frame[joint, 1]
        angle = np.unwrap(np.arctan2(relative[:, 1, 0], relative[:, 0, 0]))
        return angle - angle[:1], np.sum(z * (w_j - w_i), axis=1)
    arm_i, arm_j = A_i @ s_i, A_j @ s_j
    d = q[:, j, :3] + arm_j - q[:, i, :3] - arm_i
    d_dot = v[:, j, :3] + np.cross(w_j, arm_j) - v[:, i, :3] - np.cross(w_i, arm_i)
    return np.sum(z * d, axis=1), np.sum(z * (d_dot - np.cross(w_i, d)), axis=1)


def _with_ground(q: Floats) -> Floats:
    """Poses (k, n + 1, 7); index -1 is the ground."""
    ground = np.zeros((len(q), 1, 7))
    ground[..., 3] = 1.0
    return np.concatenate([q, ground], axis=1)
