"""The choices of a run. What a choice cannot do is refused with the reason, never ignored.

What there is to choose is said once, in the compiled module's table (formulation/options.def).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, Literal, get_args

from linkwork import _core, arguments
from linkwork.errors import OptionError, nearest
from linkwork.options.types import Level, Options

__all__ = [
    "LEVELS", "Options", "Policy", "RENAMED", "TABLE", "check_name", "check_number", "check_option",
    "checked", "compile_options", "names", "renamed", "without_threads",
]  # fmt: skip

LEVELS: tuple[Level, ...] = get_args(Level)

#: What a run can make of an inaccurate end, see `on_inaccurate` of simulate.
Policy = Literal["pass", "warn", "stop"]

TABLE: Mapping[str, _core.OptionInfo] = {option.name: option for option in _core.options()}

#: Former names and those of today: files are still read with them, code is told.
RENAMED = {"system": "matrix_form"}


#: What other codes call the arguments of `simulate`.
SYNONYMS = {
    **dict.fromkeys(("dt", "h", "timestep", "time_step", "step_size", "stepsize"), "step"),
    **dict.fromkeys(("tol", "tolerance", "rel_tol", "reltol"), "rtol"),
    **dict.fromkeys(("abs_tol", "abstol"), "atol"),
    **dict.fromkeys(("tend", "t_final", "t_stop", "t_max", "duration", "end_time"), "t_end"),
    **dict.fromkeys(("method", "scheme", "solver"), "integrator"),
    **dict.fromkeys(("linsolve", "linear"), "linear_solver"),
    **dict.fromkeys(("alpha",), "baumgarte_alpha"), **dict.fromkeys(("beta",), "baumgarte_beta"),
    **dict.fromkeys(("t_eval", "times_out", "output_times"), "times"),
}  # fmt: skip


def renamed(settings: Mapping[str, Any]) -> dict[str, Any]:
    """What a file of an earlier version says, by the names of today."""
    return {RENAMED.get(name, name): value for name, value in settings.items()}


def without_threads(choices: Mapping[str, Any]) -> dict[str, Any]:
    """Those that results depend on: how many threads there are changes no bit."""
    return {name: value for name, value in choices.items() if name != "threads"}


def compile_options(choices: Mapping[str, Any]) -> _core.Options:
    """The options of the compiled module. OptionError: a name or value that does not exist, or a conflict."""
    options = _core.Options()
    chosen = {name: value for name, value in choices.items() if value is not None or name not in TABLE}
    if chosen.keys() & {"damping_ratio", "frequency"}:
        options.stabilization = "baumgarte"
    for name, value in chosen.items():
        check_option(name, TABLE)
        setattr(options, name, checked(TABLE[name], value))
    return options.resolved()


def check_option(name: str, known: Iterable[str]) -> None:
    """OptionError: there is none of this name."""
    if name in RENAMED:
        raise OptionError(f"option '{name}' is called '{RENAMED[name]}' now: give that", code="option")
    if name not in known:
        meant = f"; it is called '{SYNONYMS[name]}'" if name in SYNONYMS else nearest(name, known)
        raise OptionError(f"option '{name}' does not exist{meant}", code="option")


def names() -> dict[str, list[str]]:
    """What each option that is a name can be."""
    found = {name: option.choices for name, option in TABLE.items() if option.choices}
    return {**found, "on_inaccurate": list(get_args(Policy))}


def check_name(what: str, name: Any, known: Iterable[str]) -> None:
    """OptionError: it is none of the known."""
    arguments.one_of(name, known, what)


def checked(option: _core.OptionInfo, value: Any) -> Any:
    """As the compiled module takes it. OptionError: another type, or a number that cannot be."""
    if option.type == "name":
        check_name(option.name, value, option.choices)
    elif option.type == "number":
        check_number(option.name, value, positive=option.positive)
    elif option.type == "limits":
        return _limits(value)
    elif option.type == "switch":
        if not isinstance(value, bool):
            raise OptionError(f"{option.name} {value!r:.80} is not True or False", code=option.name)
    elif isinstance(value, bool) or not isinstance(value, int) or not 1 <= value < 2**31:
        raise OptionError(f"{option.name} {value!r} is not a positive whole number", code=option.name)
    return value


def check_number(name: str, value: Any, *, positive: bool, unit: str = "") -> None:
    """OptionError: not a finite number, or negative, or (`positive`) zero."""
    if not arguments.is_number(value) or value < 0 or (positive and value == 0):
        wanted = "positive" if positive else "zero or positive"
        raise OptionError(
            f"{name} {value!r:.80}{unit and ' ' + unit} must be a finite number, {wanted}", code=name
        )


def _limits(limits: Any) -> list[float]:
    """violation_limit level by level."""
    by_level = limits if isinstance(limits, Mapping) else {LEVELS[0]: limits}
    for level, limit in by_level.items():
        check_name("violation_limit: level", level, LEVELS)
        check_number(f"violation_limit: {level}", limit, positive=True)
    return [float(by_level.get(level, math.inf)) for level in LEVELS]
