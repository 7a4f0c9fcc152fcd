"""What kinds of joints hold, and by how much the points of joints are apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwork import rotation
from linkwork.elements import KINDS
from linkwork.header import Floats, Header

if TYPE_CHECKING:
    from linkwork.result import Result

#: Placements of joints that hold directions only: they sit nowhere.
UNPLACED = ("direction", "two_directions", "orientation")


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
        return cls(
            (x, y, z),
            "distance" in names,
            sum(name.startswith("rotation") for name in names),
            info.placement not in UNPLACED,
            [f"rotation about joint {a}" in names for a in "xyz"] == [True, True, False],
            (x, y, z) == (True, True, False),
        )


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


def _with_ground(q: Floats) -> Floats:
    """Poses (k, n + 1, 7); index -1 is the ground."""
    ground = np.zeros((len(q), 1, 7))
    ground[..., 3] = 1.0
    return np.concatenate([q, ground], axis=1)
