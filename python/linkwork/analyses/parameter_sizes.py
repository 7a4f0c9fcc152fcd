"""By how much a parameter of a function that builds a model changes all of that model, whatever its unit."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.modeling.extent import Extent, extent

__all__ = ["size_of_parameter"]

#: Changes of the model, relative to its sizes: from the first on they are linear in the parameter as a rule,
#: up to the last they are rounding, or what assembly leaves.
SMALL, LOST = 1e-2, 1e-10

TRIALS = 6

#: The size of gravity where there is none [m/s^2].
EARTH = 9.81


def size_of_parameter(compiled: Callable[[float], _core.Model], value: float) -> float | None:
    """1 / max |d x_i / d p| / X_i over all numbers x_i of the model at p = value, each with its size X_i.

    None: the model does not tell, as of what functions in it depend on, or of a number that has no size.
    """
    at = compiled(value)
    size, change = extent(at), 1e-3
    for _ in range(TRIALS):
        try:
            other = compiled(value + change)
        except Exception:  # so far it cannot be built
            change *= 1e-3
            continue
        moved = _moved(at, other, size)
        if moved is None or moved < LOST:
            return None
        if moved <= SMALL:
            return change / moved
        change *= SMALL / moved / 2
    return None


def _moved(at: _core.Model, other: _core.Model, size: Extent) -> float | None:
    """The largest change relative to its size; None where a number changes that has none."""
    largest = 0.0
    for (x, scale), (y, _) in zip(_numbers(at, size), _numbers(other, size), strict=True):
        if x.shape != y.shape:
            return None
        change, scales = np.abs(y - x), np.broadcast_to(scale, x.shape)
        if change[scales == 0.0].any():
            return None
        known = scales > 0.0
        largest = max(largest, float((change[known] / scales[known]).max(initial=0.0)))
    return largest


def _numbers(core: _core.Model, size: Extent) -> Iterator[tuple[Floats, Floats | float]]:
    """Numbers of a model, each with its size: lengths that of the mechanism, directions 1, speeds those of
    falling by its length, what is not zero its own, masses and inertias that are the largest."""
    length, gravity = size.size, float(np.linalg.norm(core.gravity))
    poses, velocities = core.q0.reshape(-1, 7), core.v0.reshape(-1, 6)
    yield poses[:, :3], length
    yield poses[:, 3:], 1.0
    yield from _speeds(velocities[:, :3], np.sqrt(gravity * length))
    yield from _speeds(velocities[:, 3:], np.sqrt(gravity / length))
    inertia = core.inertia.reshape(-1, 9)
    for weights in (core.mass[:, None], inertia):
        own = np.abs(weights).max(axis=1, initial=0.0, keepdims=True)
        yield weights, np.where(own > 0.0, own, own.max(initial=0.0))
    yield core.gravity, gravity or EARTH
    for arrays in (core.joint_arrays(), core.force_arrays()):
        yield arrays["origin"], length
        yield arrays["frame"], 1.0
        yield arrays["parameters"], np.abs(arrays["parameters"])


def _speeds(v: Floats, falling: float) -> Iterator[tuple[Floats, float]]:
    yield v, max(falling, float(np.abs(v).max(initial=0.0)))
