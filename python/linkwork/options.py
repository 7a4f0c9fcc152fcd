"""The choices of a run. What a choice cannot do is refused with the reason, never ignored."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, TypedDict

from linkwork import _core, given
from linkwork.errors import OptionError, nearest

__all__ = ["Options", "compile_options"]


class Options(TypedDict, total=False):
    """What `simulate` and `System` take by name; what is left out, or None, has its default."""

    #: "standard" (default), "penalty" or "augmented_lagrangian"
    formulation: str
    #: matrix of the standard formulation: "kkt" (12.3), "schur" (12.5), or "auto" (default)
    system: str
    #: "sampled_baumgarte" (default), "baumgarte" (12.8), "projection" (default of half-explicit methods),
    #: "position_projection", "velocity_projection" or "none"
    stabilization: str
    #: "auto" (default) or a name in `_core.linear_solvers()`
    linear_solver: str
    #: gain of the velocity violation [1/s]; with `baumgarte_beta`
    baumgarte_alpha: float | None
    #: gain of the position violation [1/s]; with `baumgarte_alpha`
    baumgarte_beta: float | None
    #: penalty factor of all equations; without it scaled to each equation's inertia
    penalty: float | None
    #: mu of (12.14), 1 where only `frequency` is given
    damping_ratio: float | None
    #: omega of (12.14) [rad/s], 10 where only `damping_ratio` is given
    frequency: float | None
    #: at which the iteration of the augmented Lagrangian stops, relative
    tolerance: float | None
    #: cap of that iteration
    max_iterations: int | None
    #: at a singular pose: "pass" (default), "warn" or "stop"
    on_singular: str
    #: largest violation at the ends of steps: of positions [m or 1], or by level as in
    #: {"position": 1e-8, "velocity": 1e-6, "acceleration": 1e-9}
    violation_limit: float | Mapping[str, float] | None
    #: beyond it: "record" (default), "project" (positions and velocities) or "stop"
    on_violation: str


#: Of constraints, in the order of `Result.violation`.
LEVELS = ("position", "velocity", "acceleration")

#: What `on_inaccurate` of simulate can be.
POLICIES = ("pass", "warn", "stop")

#: Flores (2015), section 12.4.
TEXTBOOK_DAMPING_RATIO, TEXTBOOK_FREQUENCY = 1.0, 10.0


def compile_options(choices: Mapping[str, Any]) -> _core.Options:
    """The options of the compiled module. OptionError: a name or value that does not exist, or a conflict."""
    for name in choices:
        if name not in Options.__annotations__:
            raise OptionError(
                f"option '{name}' does not exist{nearest(name, Options.__annotations__)}", code="option"
            )
    chosen = {name: value for name, value in choices.items() if value is not None}
    _check_names(chosen)
    _check_numbers(chosen)
    _check_formulation(chosen)
    chosen |= _gains(chosen) | _limits(chosen)
    options = _core.Options()
    for name in chosen.keys() - {"damping_ratio", "frequency"}:
        setattr(options, name, chosen[name])
    return options


def names() -> dict[str, list[str]]:
    """What each option that is a name can be."""
    return {
        "formulation": [info.name for info in _core.formulations()],
        "stabilization": [info.name for info in _core.stabilizations()],
        "linear_solver": ["auto", *(info.name for info in _core.linear_solvers())],
        "system": ["auto", "kkt", "schur"],
        "on_singular": ["pass", "warn", "stop"],
        "on_violation": ["record", "project", "stop"],
        "on_inaccurate": list(POLICIES),
    }


def _check_names(chosen: Mapping[str, Any]) -> None:
    for what, known in names().items():
        if what in chosen:
            check_name(what, chosen[what], known)


def check_name(what: str, name: Any, known: Iterable[str]) -> None:
    """OptionError: it is none of the known."""
    given.one_of(name, known, what)


def _check_numbers(chosen: Mapping[str, Any]) -> None:
    for name in ("penalty", "tolerance", "frequency", "damping_ratio", "baumgarte_alpha", "baumgarte_beta"):
        if name in chosen:
            check_number(name, chosen[name], positive=name in ("penalty", "tolerance", "frequency"))
    iterations = chosen.get("max_iterations", 1)
    if not isinstance(iterations, int) or not 1 <= iterations < 2**31:
        raise OptionError(
            f"max_iterations {iterations!r} is not a positive whole number", code="max_iterations"
        )


def check_number(name: str, value: Any, *, positive: bool, unit: str = "") -> None:
    """OptionError: not a finite number, or negative, or (`positive`) zero."""
    if not given.is_number(value) or value < 0 or (positive and value == 0):
        wanted = "positive" if positive else "zero or positive"
        raise OptionError(
            f"{name} {value!r:.80}{unit and ' ' + unit} must be a finite number, {wanted}", code=name
        )


def _check_formulation(chosen: Mapping[str, Any]) -> None:
    """Refuse what the formulation does not have."""
    known = {info.name: info for info in _core.formulations()}
    formulation = known[chosen.get("formulation", _core.Options().formulation)]
    for option in ("penalty", "damping_ratio", "frequency"):
        if option in chosen and not formulation.has_penalty:
            having = [info.name for info in known.values() if info.has_penalty]
            _refuse(option, formulation.name, "it has no penalty", having)
    for option in ("tolerance", "max_iterations"):
        if option in chosen and not formulation.iterative:
            having = [info.name for info in known.values() if info.iterative]
            _refuse(option, formulation.name, "it does not iterate", having)


def _refuse(option: str, formulation: str, why: str, others: Iterable[str]) -> None:
    choices = " or ".join(f"'{name}'" for name in others)
    message = f"{option} has no meaning for formulation '{formulation}': {why}; use formulation {choices}"
    raise OptionError(message, code="conflict")


def _limits(chosen: Mapping[str, Any]) -> dict[str, Any]:
    """violation_limit level by level."""
    limits = chosen.get("violation_limit")
    if limits is None:
        if "on_violation" in chosen:
            raise OptionError("on_violation needs a violation_limit", code="conflict")
        return {}
    by_level = limits if isinstance(limits, Mapping) else {LEVELS[0]: limits}
    for level, limit in by_level.items():
        if level not in LEVELS:
            raise OptionError(
                f"violation_limit: level '{level}' does not exist{nearest(str(level), LEVELS)}",
                code="unknown_option",
            )
        check_number(f"violation_limit: {level}", limit, positive=True)
    if set(by_level) == {"acceleration"} and chosen.get("on_violation") == "project":
        raise OptionError(
            "on_violation 'project' has no meaning for accelerations alone: a projection changes positions "
            "and velocities; give their limits, or on_violation 'record' or 'stop'",
            code="conflict",
        )
    return {"violation_limit": [float(by_level.get(level, math.inf)) for level in LEVELS]}


def _gains(chosen: Mapping[str, Any]) -> dict[str, Any]:
    """Stabilization and gains; those of (12.14) are alpha = mu omega, beta = omega."""
    gains = [name for name in ("baumgarte_alpha", "baumgarte_beta") if name in chosen]
    damped = [name for name in ("damping_ratio", "frequency") if name in chosen]
    stabilization = chosen.get("stabilization")
    if len(gains) == 1:
        raise OptionError(
            f"{gains[0]} is given alone: give baumgarte_alpha and baumgarte_beta", code="conflict"
        )
    if gains and stabilization not in (None, "baumgarte", "sampled_baumgarte"):
        raise OptionError(
            f"baumgarte_alpha and baumgarte_beta have no meaning for stabilization '{stabilization}'",
            code="conflict",
        )
    if not damped:
        return {}
    if gains:
        raise OptionError(
            f"{damped[0]} and baumgarte_alpha are gains of the same term: give one pair", code="conflict"
        )
    if stabilization not in (None, "baumgarte"):
        raise OptionError(
            f"{damped[0]} is a gain of stabilization 'baumgarte', in conflict with '{stabilization}'",
            code="conflict",
        )
    mu, omega = (
        chosen.get("damping_ratio", TEXTBOOK_DAMPING_RATIO),
        chosen.get("frequency", TEXTBOOK_FREQUENCY),
    )
    return {"stabilization": "baumgarte", "baumgarte_alpha": mu * omega, "baumgarte_beta": omega}
