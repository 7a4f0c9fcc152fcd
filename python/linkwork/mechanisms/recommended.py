"""What a mechanism recommends for a run, without what the options that are given leave no meaning."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwork.integrators import METHODS, EmbeddedPair, HalfExplicit
from linkwork.options import TABLE

__all__ = ["beside"]

#: Choices that options belong to.
AXES = ("formulation", "stabilization")

#: Options that say the same in another way: what is given of one side takes the place of the other.
SAME = (
    ({"penalty"}, {"penalty_scale"}),
    ({"baumgarte_alpha", "baumgarte_beta"}, {"damping_ratio", "frequency"}),
)

#: By which half-explicit methods hold what is left of drift.
PROJECTIONS = ("none", "projection", "position_projection")


def beside(recommended: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """The recommended arguments of `simulate` that have a meaning beside those that are given."""
    return {name: value for name, value in recommended.items() if not _overruled(name, value, given)}


def _overruled(name: str, value: Any, given: Mapping[str, Any]) -> bool:
    if name in ("step", "integrator", "rtol", "atol"):
        return _of_other_steps(name, value, given)
    if _method(given, HalfExplicit) and (
        (name == "stabilization" and value not in PROJECTIONS) or _axis(name) == "stabilization"
    ):
        return True
    for one, other in (*SAME, *(pair[::-1] for pair in SAME)):
        if name in one and given.keys() & other:
            return True
    if name in ("damping_ratio", "frequency") and given.get("stabilization", "baumgarte") != "baumgarte":
        return True
    axis = _axis(name)
    return axis in given and given[axis] not in TABLE[name].methods


def _of_other_steps(name: str, value: Any, given: Mapping[str, Any]) -> bool:
    """A recommended step is no limit for steps that follow given tolerances, and rk4 follows none."""
    adaptive = bool(given.keys() & {"rtol", "atol"})
    if name in ("rtol", "atol"):
        return "integrator" in given and not _method(given, EmbeddedPair)
    return adaptive and (name == "step" or not _method({name: value}, EmbeddedPair))


def _method(choices: Mapping[str, Any], kind: type) -> bool:
    """Whether the integrator among these is of a kind."""
    method = choices.get("integrator")
    return isinstance(METHODS.get(method) if isinstance(method, str) else method, kind)


def _axis(name: str) -> str:
    """The choice that an option belongs to; empty: none."""
    methods = set(TABLE[name].methods) if name in TABLE else set()
    return next((axis for axis in AXES if methods & set(TABLE[axis].choices)), "")
