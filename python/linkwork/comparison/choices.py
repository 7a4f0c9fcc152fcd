"""The methods of a comparison: formulation, stabilization, integrator and linear solver, at which steps."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any

from linkwork import integrators
from linkwork.errors import OptionError
from linkwork.integrators import EmbeddedPair
from linkwork.options import check_name, names

__all__ = ["DEFAULT_CHOICES", "Cell", "Choice", "Entry", "cells", "choices"]

#: One entry of an axis: a name, "NAME:NUMBER:...", options by name, or (integrators) a method.
Entry = Any

#: What the numbers behind a name are: "baumgarte:5:5", "baumgarte:1/h:1.4142/h", "penalty:1e7:1:10".
_NUMBERS: dict[str, tuple[str, ...]] = {
    "stabilization": ("baumgarte_alpha", "baumgarte_beta"),
    "formulation": ("penalty", "damping_ratio", "frequency"),
}

#: The axes, in the order in which a method is named.
AXES = ("formulation", "stabilization", "integrator", "linear_solver")

#: Steps that follow tolerances have atol = ATOL_RATIO * rtol, as everywhere in linkwork.
ATOL_RATIO = 1e-3

#: Of a number that is divided by the step.
PER_STEP = "/h"


@dataclass(frozen=True)
class Choice:
    """One method: options of `simulate`, without a step; a gain "1/h" [1/s] follows the step h."""

    options: Mapping[str, Any] = field(default_factory=dict)

    @property
    def label(self) -> str:
        """What was chosen, in words that fit a table: standard, baumgarte 1/h 1.41/h, rk4."""
        words = [_worded(axis, self.options) for axis in AXES]
        rest = [
            f"{name} {_number(value)}"
            for name, value in self.options.items()
            if name not in AXES and not any(name in numbers for numbers in _NUMBERS.values())
        ]
        return ", ".join(word for word in (*words, *rest) if word) or "default"

    @property
    def integrator(self) -> Any:
        """The method as data where its name is known."""
        given = self.options.get("integrator")
        return integrators.METHODS.get(given, given) if isinstance(given, str) else given

    @property
    def key(self) -> str:
        """Equal for equal choices, in this process and in any other."""
        return json.dumps({name: _plain(value) for name, value in sorted(self.options.items())})

    def at(self, step: float | None) -> dict[str, Any]:
        """The options at a step [s]. OptionError: a gain that follows the step, which is not fixed."""
        return {name: _resolved(name, value, step) for name, value in self.options.items()}


@dataclass(frozen=True)
class Cell:
    """A method with a fixed step [s], or with rtol for steps that follow it."""

    choice: Choice
    step: float | None = None
    rtol: float | None = None

    @property
    def label(self) -> str:
        return f"{self.choice.label}, {self.resolution}"

    @property
    def resolution(self) -> str:
        return f"step {self.step:g} s" if self.step is not None else f"rtol {self.rtol:g}"

    @property
    def key(self) -> str:
        return f"{self.choice.key} step={self.step!r} rtol={self.rtol!r}"

    def options(self) -> dict[str, Any]:
        """What `simulate` takes, besides model and t_end. OptionError."""
        chosen = self.choice.at(self.step)
        if self.step is not None:
            return {**chosen, "step": self.step}
        return {**chosen, "rtol": self.rtol, "atol": ATOL_RATIO * self.rtol if self.rtol else None}


def _per_step(number: float) -> str:
    return f"{number!r}{PER_STEP}"


def _of(formulation: str, integrator: str, stabilization: str | None = None, **numbers: Any) -> Choice:
    names = {"formulation": formulation, "stabilization": stabilization, "integrator": integrator}
    return Choice({**{axis: name for axis, name in names.items() if name}, **numbers})


#: What a newcomer learns from: drift and its cures, the price of gains that follow the step, the floor of the
#: penalty method, orders 4 and 5, and half-explicit methods.
DEFAULT_CHOICES: tuple[Choice, ...] = (
    _of("standard", "rk4", "none"),
    _of("standard", "rk4", "baumgarte", baumgarte_alpha=5.0, baumgarte_beta=5.0),
    _of("standard", "rk4", "baumgarte", baumgarte_alpha=_per_step(1.0),
        baumgarte_beta=_per_step(math.sqrt(2.0))),
    _of("standard", "rk4", "sampled_baumgarte"),
    _of("standard", "rk4", "projection"),
    _of("penalty", "rk4", "sampled_baumgarte"),
    _of("augmented_lagrangian", "rk4", "sampled_baumgarte"),
    _of("standard", "dopri5", "sampled_baumgarte"),
    _of("penalty", "dopri5", "sampled_baumgarte"),
    _of("standard", "hem4", "projection"),
    _of("standard", "phem56", "projection"),
)  # fmt: skip

#: The same where steps follow tolerances.
DEFAULT_ADAPTIVE: tuple[Choice, ...] = (
    *(_of("standard", name, "sampled_baumgarte") for name in ("bs32", "tsit5", "dopri5", "dop853")),
    _of("standard", "dopri5", "none"),
    _of("standard", "dopri5", "projection"),
    _of("penalty", "dopri5", "sampled_baumgarte"),
    _of("augmented_lagrangian", "dopri5", "sampled_baumgarte"),
)


def choices(
    formulations: Iterable[Entry] | None,
    stabilizations: Iterable[Entry] | None,
    integrators: Iterable[Entry] | None,
    linear_solvers: Iterable[Entry] | None,
    common: Mapping[str, Any],
    *,
    adaptive: bool = False,
) -> list[Choice]:
    """All combinations of the axes; one that is None is left to `simulate`. All four None: DEFAULT_CHOICES.

    `common`: options of every method; `adaptive`: steps follow tolerances, so DEFAULT_ADAPTIVE instead.
    OptionError: an axis without entries, or an entry that is none.
    """
    axes = dict(zip(AXES, (formulations, stabilizations, integrators, linear_solvers), strict=True))
    if all(entries is None for entries in axes.values()):
        usual = DEFAULT_ADAPTIVE if adaptive else DEFAULT_CHOICES
        found = [Choice({**choice.options, **common}) for choice in usual]
    else:
        entries = [_entries(axis, given) for axis, given in axes.items()]
        found = [Choice({**common, **{k: v for part in parts for k, v in part.items()}})
                 for parts in product(*entries)]  # fmt: skip
    return list({choice.key: choice for choice in found}.values())


def cells(found: Sequence[Choice], steps: Sequence[float], tolerances: Sequence[float]) -> list[Cell]:
    """Every method at every step, coarse to fine, and at every tolerance.

    Where both are given, tolerances are for methods with an error estimate alone.
    """
    out = []
    for choice in found:
        out += [Cell(choice, step=float(step)) for step in sorted(set(steps), reverse=True)]
        if isinstance(choice.integrator, EmbeddedPair) or not steps:
            out += [Cell(choice, rtol=float(rtol)) for rtol in sorted(set(tolerances), reverse=True)]
    return out


def _entries(axis: str, given: Iterable[Entry] | None) -> list[Mapping[str, Any]]:
    if given is None:
        return [{}]
    entries = [given] if isinstance(given, str | Mapping) or not isinstance(given, Iterable) else list(given)
    if not entries:
        raise OptionError(f"{axis}s: is empty; name one at least, or leave it out", code="empty")
    return [_entry(axis, entry) for entry in entries]


def _entry(axis: str, entry: Entry) -> Mapping[str, Any]:
    if isinstance(entry, Mapping):
        return {name: value for name, value in entry.items() if value is not None}
    if not isinstance(entry, str):
        if axis != "integrator":
            raise OptionError(f"{axis}s: {entry!r} is neither a name nor options by name", code=axis)
        return {axis: entry}
    name, *numbers = (word.strip() for word in entry.split(":"))
    known = _NUMBERS.get(axis, ())
    if len(numbers) > len(known):
        takes = f"takes {' and '.join(known)}" if known else "takes no numbers"
        raise OptionError(f"{axis} '{entry}': {name} {takes}, not {len(numbers)} numbers", code=axis)
    check_name(axis, name, integrators.METHODS if axis == "integrator" else names()[axis])
    given = {option: _read(entry, number) for option, number in zip(known, numbers, strict=False)}
    return {axis: name, **given}


def _read(entry: str, text: str) -> float | str:
    """A number, or one that is divided by the step. OptionError."""
    number = text.removesuffix(PER_STEP).replace(" ", "")
    try:
        value = math.sqrt(float(number[5:-1])) if number.startswith("sqrt(") else float(number)
    except ValueError:
        raise OptionError(
            f"'{entry}': '{text}' is no number; write 5, 1e7, 1/h or sqrt(2)/h, h being the step",
            code="number",
        ) from None
    return _per_step(value) if text.endswith(PER_STEP) else value


def _resolved(name: str, value: Any, step: float | None) -> Any:
    if not (isinstance(value, str) and value.endswith(PER_STEP)):
        return value
    if step is None:
        raise OptionError(
            f"{name} {value}: h is a fixed step, which runs with tolerances do not have; give a number [1/s]",
            code="conflict",
        )
    return float(value.removesuffix(PER_STEP)) / step


def _worded(axis: str, options: Mapping[str, Any]) -> str:
    name = options.get(axis)
    numbers = [_number(options[option]) for option in _NUMBERS.get(axis, ()) if option in options]
    if name is None:
        return " ".join((axis, *numbers)) if numbers else ""
    return " ".join((_name(name), *numbers))


def _number(value: Any) -> str:
    if isinstance(value, str) and value.endswith(PER_STEP):
        return f"{float(value.removesuffix(PER_STEP)):.3g}{PER_STEP}"
    return f"{value:g}" if isinstance(value, int | float) and not isinstance(value, bool) else str(value)


def _name(method: Any) -> str:
    if isinstance(method, str):
        return method
    return str(getattr(method, "name", None) or getattr(method, "__qualname__", type(method).__name__))


def _plain(value: Any) -> Any:
    """For a key: methods that are data by their numbers, functions by their names."""
    if isinstance(value, str | int | float | bool | None):
        return value
    return repr(value) if hasattr(value, "order") else _name(value)
