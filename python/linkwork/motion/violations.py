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
        )

    @property
    def anything(self) -> bool:
        """Whether `violations` can tell by how much it is violated."""
        return any(self.translations) or self.distance or bool(self.angles)


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
    left out: their equations join points and angles.
    """
    header = result.header
    kinds = joint_kinds(header)
    holds = [kinds[j] for j in joints]
    gap, turns = separations(result, header.joint_bodies[joints], header.joint_origin[joints], every)
    a, b = (turns[side] @ header.joint_frame[joints, side] for side in (0, 1))
    held = np.array([it.translations for it in holds], float).reshape(-1, 3)
    apart: Floats = np.linalg.norm(np.einsum("kjab,kja->kjb", a, gap) * held, axis=-1)
    for place, (j, it) in enumerate(zip(joints, holds, strict=True)):
        if not it.distance:
            continue
        length = header.parameters("joint", int(j))[-1:]
        if len(length) and np.isfinite(length).all():
            apart[:, place] = np.abs(np.linalg.norm(gap[:, place], axis=-1) - length)
    askew = np.zeros_like(apart)
    for angles, places in _alike([it.angles for it in holds]):
        askew[:, places] = _askew(a[:, places], b[:, places], angles)
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
