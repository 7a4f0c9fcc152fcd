"""By how much a parameter of a function that builds a model changes all of that model, whatever its unit."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.analyses.difference_ladder import largest
from linkwork.arrays import Floats
from linkwork.modeling.elements import KINDS, Role
from linkwork.modeling.extent import Extent, extent

__all__ = ["size_of_parameter", "size_of_unit"]

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
        if not moved:
            return None
        if LOST <= moved <= SMALL:
            return change / moved
        change *= min(SMALL / moved / 2, 1e3)
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
    falling by its length; masses and parameters that are not zero their own, others that of their unit."""
    length, gravity = size.size, float(np.linalg.norm(core.gravity))
    poses, velocities = core.q0.reshape(-1, 7), core.v0.reshape(-1, 6)
    speed = max(np.sqrt(gravity * length), largest(velocities[:, :3]))
    turning = max(np.sqrt(gravity / length), largest(velocities[:, 3:]))
    yield poses[:, :3], length
    yield poses[:, 3:], 1.0
    yield velocities[:, :3], speed
    yield velocities[:, 3:], turning
    for weights in (core.mass[:, None], core.inertia.reshape(-1, 9)):
        own = np.abs(weights).max(axis=1, initial=0.0, keepdims=True)
        yield weights, np.where(own > 0.0, own, own.max(initial=0.0))
    yield core.gravity, gravity or EARTH
    rate = max(turning, speed / length)
    units = {"kg": largest(core.mass), "m": length, "s": 1 / rate if rate > 0.0 else 0.0, "rad": 1.0}
    of_kind: dict[Role, Any] = {"joint": core.joint_arrays(), "force": core.force_arrays()}
    for role, arrays in of_kind.items():
        yield arrays["origin"], length
        yield arrays["frame"], 1.0
        own = np.abs(arrays["parameters"])
        yield arrays["parameters"], np.where(own > 0.0, own, _sizes(role, arrays, units))


def _sizes(role: Role, arrays: Mapping[str, Floats], units: Mapping[str, float]) -> Floats:
    """Of parameters of all joints or forces, by their units; 0 where there is none."""
    kinds, sizes = list(KINDS[role].values()), np.zeros(len(arrays["parameters"]))
    for kind in np.unique(arrays["kind"]):
        first = arrays["first_parameter"][arrays["kind"] == kind]
        for place, parameter in enumerate(kinds[kind].parameters.values()):
            sizes[first + place] = size_of_unit(parameter.unit, units)
    return sizes


def size_of_unit(unit: str, units: Mapping[str, float]) -> float:
    """Of "N m s/rad^2" and the like, from those of kg, m, s and rad; 0 where it is not of these."""
    if units["s"] == 0.0:
        return 0.0
    known = {**units, "N": units["kg"] * units["m"] / units["s"] ** 2}
    size = 1.0
    for sign, factors in zip((1, -1), unit.split("/"), strict=False):
        for factor in factors.split():
            name, _, power = factor.partition("^")
            if name not in known or not (power or "1").isdigit():
                return 0.0
            size *= known[name] ** (sign * int(power or 1))
    return size
