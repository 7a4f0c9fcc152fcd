"""Elements and their bodies in the frames of a result, of many elements in some of the frames only."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core, rotation
from linkwork.arrays import Floats
from linkwork.modeling.elements import KINDS
from linkwork.results.result import Result

__all__ = ["ELEMENTS", "Elements", "axes_of", "every_of", "kinds_in", "listed", "of_bodies", "times_of"]

#: What is looked at: so many elements at most, and so many of elements in frames.
ELEMENTS, LOOKS = 100_000, 200_000

#: How many elements a message names.
NAMED = 3


class Elements(NamedTuple):
    """Joints or force elements, with axes on two bodies."""

    names: Sequence[str]
    bodies: NDArray[np.integer]  # (e, 2)
    frame: Floats  # (e, 2, 3, 3), axes in the bodies as columns


def kinds_in(model: _core.Model) -> set[str]:
    """Of all joints and force elements."""
    joints, forces = list(KINDS["joint"]), list(KINDS["force"])
    of_joints, of_forces = (set(it["kind"].tolist()) for it in (model.joint_arrays(), model.force_arrays()))
    return {*(joints[kind] for kind in of_joints), *(forces[kind] for kind in of_forces)}


def every_of(result: Result, elements: int) -> int:
    """Of the frames every so manyth is looked at, and the last one: each where elements are few."""
    return -(-len(result) // max(1, LOOKS // elements))


def times_of(result: Result, every: int) -> Floats:
    """Of every so manyth frame and the last one (k,) [s]."""
    return np.append(result.t[::every], result.t[-1])


def of_bodies(
    result: Result,
    name: str,
    elements: Elements,
    every: int,
    convert: Callable[[Floats], Floats],
    of_ground: ArrayLike,
) -> Callable[[int], Floats]:
    """What gives a recorded field, converted, of the body on a side of each element (k, e, ...), in every so
    manyth frame and the last one."""
    bodies = np.unique(elements.bodies[elements.bodies >= 0])
    sampled = result.recorded_of(name, bodies, every)
    found = convert(np.concatenate([sampled, result.recorded(name, np.s_[-1:])[:, bodies]]))
    ground = np.broadcast_to(of_ground, (len(found), 1, *found.shape[2:]))
    values = np.concatenate([found, ground], axis=1)
    place = np.where(elements.bodies < 0, -1, np.searchsorted(bodies, elements.bodies))
    return lambda side: values[:, place[:, side]]


def axes_of(result: Result, elements: Elements, every: int) -> Callable[[int, int], Floats]:
    """What gives an axis (side, which) of each (k, e, 3) in every so manyth frame and the last one."""
    turn = of_bodies(result, "q", elements, every, lambda q: rotation.matrix(q[..., 3:]), np.eye(3))

    def axis(side: int, which: int) -> Floats:
        found: Floats = np.einsum("keij,ej->kei", turn(side), elements.frame[:, side, :, which])
        return found

    return axis


def listed(names: Sequence[str]) -> str:
    """The first ones, and how many more there are."""
    more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return ", ".join(map(repr, names[:NAMED])) + more
