"""What kinds of joints hold, and by how much the points of joints are apart."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.modeling.elements import KINDS
from linkwork.motion.header import Header, Indices

if TYPE_CHECKING:
    from linkwork.results.result import Result

#: Equations of angles, each of pairs of axes.
Angles = tuple[tuple[tuple[int, int], ...], ...]

#: Of kinds that hold translations along an axis of each body: which of a, and which of b.
BETWEEN = {"revolute_translational": ((False, False, True), (True, False, False))}

#: Placements of joints that hold directions only: they sit nowhere.
UNPLACED = ("direction", "two_directions", "orientation")


@dataclass(frozen=True)
class Holds:
    """What a kind of joint holds."""

    translations: tuple[bool, bool, bool]  #: of the points, along the joint's x, y, z, at zero
    distance: bool  #: between the two points
    rotations: int
    placed: bool  #: it sits at points of its bodies
    turning: bool  #: about its z axis, and about no other
    sliding: bool  #: along its z axis, and along no other
    angles: Angles  #: of its rotations at zero, see EquationInfo.perpendicular
    between: tuple[tuple[bool, ...], tuple[bool, ...]] = ((False,) * 3,) * 2  #: along axes of a and of b

    @classmethod
    def of(cls, kind: str) -> Holds:
        """An unknown kind, from a file of a later version, holds nothing that is known."""
        info = KINDS["joint"].get(kind)
        if info is None:
            return cls((False, False, False), False, 0, True, False, False, ())
        equations = info.equations.values()
        held = {(it.quantity, it.axis) for it in equations}
        x, y, z = (("translation", axis) in held for axis in range(3))
        return cls(
            (x, y, z),
            any(it.quantity == "distance" for it in equations),
            sum(it.quantity == "rotation" for it in equations),
            info.placement not in UNPLACED,
            [("rotation", axis) in held for axis in range(3)] == [True, True, False],
            (x, y, z) == (True, True, False),
            tuple(tuple(it.perpendicular) for it in equations if it.perpendicular),
            BETWEEN.get(kind, cls.between),
        )

    def axes(self, side: int) -> list[bool]:
        """Of the first or second body, along which the points are not apart."""
        along = self.translations if side == 0 else (False,) * 3
        return [one or other for one, other in zip(along, self.between[side], strict=True)]


def told(header: Header) -> list[bool]:
    """Of each joint whether `violations` can tell by how much it is violated: a length that is a function of
    time is not known."""
    found = []
    for joint, it in enumerate(joint_kinds(header)):
        known = not it.distance or _length(header, joint) is not None
        found.append(known and (it.distance or any(it.translations) or bool(it.angles)))
    return found


def _length(header: Header, joint: int) -> float | None:
    """At which a joint holds its points [m]; None: it is a function of time, or not in an early file."""
    length = header.parameters("joint", joint)[-1:]
    return float(length[0]) if len(length) and np.isfinite(length[0]) else None


def joint_kinds(header: Header) -> list[Holds]:
    """Of each joint."""
    kinds = list(header.joint_kinds)
    known = {kind: Holds.of(kind) for kind in set(kinds)}
    return [known[kind] for kind in kinds]


def gaps(result: Result, joints: NDArray[np.integer], every: int = 1) -> tuple[Floats, Floats]:
    """From each joint's first point to its second (k, j, 3) [m], and its axes (k, j, 3, 3), inertial."""
    header = result.header
    gap, turns = separations(result, header.joint_bodies[joints], header.joint_origin[joints], every)
    return gap, turns[0] @ header.joint_frame[joints, 0]


def separations(
    result: Result, bodies: Indices, origin: Floats, every: int = 1
) -> tuple[Floats, tuple[Floats, Floats]]:
    """From a point of the first body to one of the second (k, m, 3) [m], inertial; A of both (k, m, 3, 3).

    bodies (m, 2), origin (m, 2, 3) in the bodies [m]
    """
    involved, places = np.unique(bodies, return_inverse=True)
    places = places.reshape(bodies.shape) - np.count_nonzero(involved < 0)  # of the ground -1, as before
    q = _with_ground(result.recorded_of("q", involved[involved >= 0], every))
    first, second = (rotation.matrix(q[:, places[:, side], 3:]) for side in (0, 1))
    points = [
        q[:, places[:, side], :3] + np.einsum("kmab,mb->kma", turn, origin[:, side])
        for side, turn in enumerate((first, second))
    ]
    return points[1] - points[0], (first, second)


def violations(result: Result, joints: NDArray[np.integer], every: int = 1) -> tuple[Floats, Floats]:
    """By how much each joint's points are apart [m] and its axes askew [rad] (k, j), where it holds them.

    Of points that are held at a distance the error of that distance counts. Rolling, threads and drivers are
    left out: their equations join points and angles. See `told`.
    """
    header = result.header
    kinds = joint_kinds(header)
    holds = [kinds[j] for j in joints]
    gap, turns = separations(result, header.joint_bodies[joints], header.joint_origin[joints], every)
    axes = [turns[side] @ header.joint_frame[joints, side] for side in (0, 1)]
    apart: Floats = np.zeros(gap.shape[:-1])
    for side in (0, 1):
        held = np.array([it.axes(side) for it in holds], float).reshape(-1, 3)
        along = np.einsum("kjab,kja->kjb", axes[side], gap) * held
        apart = np.hypot(apart, np.linalg.norm(along, axis=-1))
    for place, (j, it) in enumerate(zip(joints, holds, strict=True)):
        if it.distance and (length := _length(header, int(j))) is not None:
            longer = np.linalg.norm(gap[:, place], axis=-1) - length
            apart[:, place] = np.hypot(apart[:, place], longer)
    askew = np.zeros_like(apart)
    for angles, places in _alike([it.angles for it in holds]):
        askew[:, places] = _askew(axes[0][:, places], axes[1][:, places], angles)
    return apart, askew


def _alike(angles: Sequence[Angles]) -> Iterator[tuple[Angles, NDArray[np.intp]]]:
    """The places of joints whose rotations are held by the same equations."""
    places: dict[Angles, list[int]] = defaultdict(list)
    for place, equations in enumerate(angles):
        places[equations].append(place)
    return ((equations, np.array(found)) for equations, found in places.items())


def _askew(a: Floats, b: Floats, equations: Angles) -> Floats:
    """Angle between the axes (k, j, 3, 3) of joints on their two bodies that they do not allow (k, j)."""
    squares = np.zeros(a.shape[:2])
    for pairs in equations:
        products = [np.einsum("kjc,kjc->kj", a[..., u], b[..., w]) for u, w in pairs]
        error = products[0] if len(products) == 1 else (products[0] - products[1]) / 2
        squares += np.arcsin(np.clip(error, -1, 1)) ** 2
    root: Floats = np.sqrt(squares)
    return root


def _with_ground(q: Floats) -> Floats:
    """Poses (k, n + 1, 7); index -1 is the ground."""
    ground = np.zeros((len(q), 1, 7))
    ground[..., 3] = 1.0
    return np.concatenate([q, ground], axis=1)
