"""Axes that a file means to be parallel or perpendicular, made so: it has angles with few digits, like 1.57.

A planar loop whose axes are parallel only nearly is locked.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from linkwork.arrays import Floats
from linkwork.importers.description import WORLD, Description, JointDescription
from linkwork.importers.tree import LinkState, grounded_links, link_states

#: Angle [rad] to which axes of one loop are parallel where they are meant to be: two roundings of 1.57 apart.
ROUNDED = 2e-3

#: Angles below this [rad] are rounding of double precision.
EXACT = 1e-9


def align_axes(description: Description, tolerance: float | None) -> None:
    """Make axes exactly parallel or perpendicular that are so to within `tolerance` [rad].

    At coordinates zero. The first of them, rounded to an axis of the model where it is that near, says how
    the others are. None: the axes of the joints in each closed loop, to within ROUNDED.
    """
    states = link_states(description, {}, {})
    for joints in loops(description) if tolerance is None else [list(description.joints)]:
        _align(description, joints, states, ROUNDED if tolerance is None else tolerance)


def _align(
    description: Description,
    joints: Iterable[JointDescription],
    states: Mapping[str, LinkState],
    tolerance: float,
) -> None:
    known: list[Floats] = []
    for joint in joints:
        A = states[joint.parent].frame.A @ joint.in_parent.A
        motions = []
        for motion in joint.motions:
            axis = A @ motion.axis
            meant = _meant(axis, known, np.sin(tolerance))
            angle = float(np.linalg.norm(np.cross(meant, axis)))
            if angle > EXACT:
                text = f"its axis is turned by {angle:.2g} rad, to be parallel or perpendicular to others"
                description.note("axis", f"joint '{joint.name}'", text)
            motions.append(replace(motion, axis=A.T @ meant))
        joint.motions = motions


def _meant(axis: Floats, known: list[Floats], near: float) -> Floats:
    """Along one of the known directions, or across those that it nearly is across: then known, too."""
    for u in known:
        if np.linalg.norm(np.cross(u, axis)) <= near:
            return u * np.sign(u @ axis)
    main = np.eye(3)[int(np.argmax(np.abs(axis)))]
    if np.linalg.norm(np.cross(main, axis)) <= near:
        axis = main * np.sign(main @ axis)
    for u in known:
        if abs(u @ axis) <= near:
            axis = axis - (u @ axis) * u
    unit: Floats = axis / np.linalg.norm(axis)
    known.append(unit)
    return unit


def loops(description: Description) -> list[list[JointDescription]]:
    """The joints of each closed loop; loops that share a joint are one. Links fixed to the ground are it."""
    joints = [joint for joint in description.joints if joint.kind != "free"]
    of_ground = {*grounded_links(description), WORLD}
    ends = [tuple(WORLD if x in of_ground else x for x in (joint.parent, joint.child)) for joint in joints]

    parents = _spanning_forest(ends)
    group = list(range(len(joints)))  # union-find: each joint points to one of its loop

    def leader(k: int) -> int:
        while group[k] != k:
            group[k] = group[group[k]]
            k = group[k]
        return k

    in_loop: set[int] = set()
    tree = {step[1] for step in parents.values() if step is not None}
    for k, (a, b) in enumerate(ends):
        if k not in tree and a != b:
            ring = [k, *_path(parents, a, b)]
            in_loop.update(ring)
            for other in ring:
                group[leader(other)] = leader(k)
    found: dict[int, list[JointDescription]] = {}
    for k in sorted(in_loop):
        found.setdefault(leader(k), []).append(joints[k])
    return list(found.values())


#: To each link the one before it and the number of the joint between them; None at a root.
_Parents = dict[str, tuple[str, int] | None]


def _spanning_forest(ends: list[tuple[str, ...]]) -> _Parents:
    """Breadth first, so that paths are short."""
    neighbors: dict[str, list[tuple[str, int]]] = {}
    for k, (a, b) in enumerate(ends):
        neighbors.setdefault(a, []).append((b, k))
        neighbors.setdefault(b, []).append((a, k))
    parents: _Parents = {}
    for root in neighbors:
        if root in parents:
            continue
        parents[root] = None
        front = [root]
        for link in front:
            for other, k in neighbors[link]:
                if other not in parents:
                    parents[other] = link, k
                    front.append(other)
    return parents


def _path(parents: _Parents, a: str, b: str) -> Iterator[int]:
    """The joints between two links of one tree."""
    up = {link: k for k, (link, _) in enumerate(_upward(parents, a))}
    below = next(link for link, _ in _upward(parents, b) if link in up)
    for start in (a, b):
        for link, joint in _upward(parents, start):
            if link == below:
                break
            yield joint


def _upward(parents: _Parents, link: str) -> Iterator[tuple[str, int]]:
    """Each link up to the root, with the joint behind it; -1 at the root."""
    while (step := parents[link]) is not None:
        yield link, step[1]
        link = step[0]
    yield link, -1
