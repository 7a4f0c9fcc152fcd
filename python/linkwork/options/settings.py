"""The arguments of `simulate` that are data, one by one and together: what no run takes is refused.

A run looks at them before its first step, and a file that recommends them when it is read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from typing import Any, get_args

import numpy as np

from linkwork import _core
from linkwork.arguments import check_switch
from linkwork.errors import ModelError, OptionError, nearest
from linkwork.functions import check_breaks
from linkwork.integrators import METHODS, EmbeddedPair, HalfExplicit, named
from linkwork.options.table import (
    RENAMED,
    TABLE,
    Policy,
    check_name,
    check_number,
    checked,
    compile_options,
    renamed,
)

__all__ = ["LEAST_RTOL", "RUN_SETTINGS", "check_estimate", "check_setting", "check_step", "check_together",
           "honored", "refused"]  # fmt: skip

#: The smallest relative tolerance that double precision holds.
LEAST_RTOL = 1e-13

#: Arguments of `simulate` that are no settings of a model.
OF_CALLS = ("model", "times", "events", "start", "output", "overwrite", "progress")

#: Times that are one, relative.
SAME_TIME = 1e-9


def refused(settings: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """What no run takes: names, and why; where there are none, why not all of them together, and the name
    that this is about, "" where it is none of theirs. Names of earlier versions are taken, too.
    """
    known, good = [*RUN_SETTINGS, *TABLE], True
    for name, value in settings.items():
        try:
            if name in known or name in RENAMED:
                check_setting(RENAMED.get(name, name), value)
                continue
            why = f"is no argument of simulate{nearest(str(name), known)}"
            if name in OF_CALLS:
                why = "is an argument of simulate that no file has: give it with the call"
        except OptionError as error:
            why = str(error)
        good = False
        yield name, why
    if not good:
        return
    try:
        check_together(renamed(settings))
    except OptionError as error:
        about = (it for it in (error.code, *re.findall(r"\w+", str(error))) if it in settings)
        yield next(about, ""), str(error)


def check_setting(name: str, value: Any) -> None:
    """An option of the table, or one of RUN_SETTINGS. OptionError: a value that no run takes."""
    if name in RUN_SETTINGS:
        RUN_SETTINGS[name](value)
    elif value is not None:
        checked(TABLE[name], value)


def check_together(settings: Mapping[str, Any]) -> None:
    """Each of which a run takes. OptionError: none takes them beside each other."""
    method = named(settings["integrator"]) if "integrator" in settings else None
    if settings.keys() & {"rtol", "atol"}:
        if method is not None:
            check_estimate(method)
    elif settings.keys() >= {"step", "t_end"}:
        check_step(settings["step"], settings["t_end"])
    options = honored(method, {name: value for name, value in settings.items() if name in TABLE})
    dynamics = _core.Dynamics(_pendulum(), compile_options(options))
    if isinstance(method, HalfExplicit):
        _core.Simulation(dynamics, method.compiled(), t_end=1.0, step=1.0)


def honored(method: Any, options: Mapping[str, Any]) -> dict[str, Any]:
    """Half-explicit methods have no acceleration to which to add a correction."""
    if isinstance(method, HalfExplicit) and options.get("stabilization") is None:
        return {**options, "stabilization": "projection"}
    return dict(options)


def check_step(step: float, t_end: float) -> None:
    """OptionError: a fixed step that is longer than a run from 0 to t_end [s]."""
    if step > t_end * (1 + SAME_TIME) > 0.0:
        raise OptionError(
            f"step {step:g} s is longer than the run, from 0 to {t_end:g} s: give a step of {t_end:g} s or "
            "less",
            code="step",
        )


def check_estimate(method: Any) -> None:
    """OptionError: rtol and atol with an integrator without an error estimate."""
    if not isinstance(method, EmbeddedPair):
        able = ", ".join(f"'{name}'" for name, known in METHODS.items() if isinstance(known, EmbeddedPair))
        name = getattr(method, "name", "of your own")
        raise OptionError(
            f"rtol and atol need an error estimate, which integrator '{name}' does not have: choose from "
            f"{able}, or give a fixed step without rtol and atol",
            code="conflict",
        )


@cache
def _pendulum() -> _core.Model:
    """With which options are tried that not every method has."""
    model, turn = _core.Model(), np.eye(3)
    rest = np.zeros((1, 3))
    model.add_bodies(["rod"], [1.0], [turn], [[0.0, 0.0, -1.0]], [[1.0, 0.0, 0.0, 0.0]], rest, rest)
    ends, none = np.array([[[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]]), np.zeros((1, 0))
    model.add_joints("spherical", ["pin"], [[-1, 0]], ends, [[turn, turn]], none, none)
    return model


def _check_integrator(name: Any) -> None:
    named(name)


def _check_rtol(rtol: Any) -> None:
    check_number("rtol", rtol, positive=True)
    if rtol < LEAST_RTOL:
        raise OptionError(
            f"rtol {rtol:g} is below {LEAST_RTOL:g}: double precision holds no more; give a larger one",
            code="rtol",
        )
    if rtol >= 1:
        raise OptionError(
            f"rtol {rtol:g} allows errors as large as the motion: give 1e-3 or less", code="rtol"
        )


def _check_record_every(given: Any) -> None:
    if isinstance(given, bool) or not isinstance(given, int | np.integer) or not 1 <= given < 2**63:
        raise OptionError(
            f"record_every {given!r:.80} is not a positive whole number of steps", code="record_every"
        )


def _check_breaks(given: Any) -> None:
    try:
        check_breaks(given, "simulate")
    except ModelError as error:
        raise OptionError(error.message, code=error.code) from error


def _check_policy(given: Any) -> None:
    check_name("on_inaccurate", given, get_args(Policy))


#: Arguments of `simulate` beside the options, a model file may recommend them; and how each is looked at.
RUN_SETTINGS: Mapping[str, Callable[[Any], None]] = {
    "t_end": partial(check_number, "t_end", positive=False, unit="s"),
    "step": partial(check_number, "step", positive=True, unit="s"),
    "integrator": _check_integrator,
    "rtol": _check_rtol,
    "atol": partial(check_number, "atol", positive=True),
    "record_every": _check_record_every,
    "breaks": _check_breaks,
    "assemble": partial(check_switch, "assemble"),
    "on_inaccurate": _check_policy,
    "verify": partial(check_switch, "verify"),
}
