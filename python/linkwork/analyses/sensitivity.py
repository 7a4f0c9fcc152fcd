"""Sensitivity of the results of a run to parameters of its model, by finite differences with their error."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork.errors import ModelError, OptionError
from linkwork.model import Model
from linkwork.result import Result
from linkwork.simulation import simulate

__all__ = ["Sensitivity", "sensitivity"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """Derivatives of outputs by parameters, each with an estimate of its error."""

    values: Mapping[str, Floats]  #: outputs at the parameters as given
    derivatives: Mapping[str, Mapping[str, Floats]]  #: [output][parameter], in the shape of the output
    errors: Mapping[str, Mapping[str, Floats]]  #: estimated errors of the derivatives, absolute
    parameters: Mapping[str, float]
    steps: Mapping[str, float]  #: the larger of the two, for each parameter
    runs: int

    def relative(self, output: str, parameter: str) -> Floats:
        """(dy / y) / (dp / p), without unit; infinite where the output is zero."""
        with np.errstate(divide="ignore", invalid="ignore"):
            change: Floats = self.derivatives[output][parameter] * self.parameters[parameter]
            return change / self.values[output]

    def __str__(self) -> str:
        """A line for each output and parameter; of arrays the largest."""
        lines = []
        for output, by in self.derivatives.items():
            for parameter, derivative in by.items():
                k = int(np.abs(derivative).argmax())
                value, error = derivative.flat[k], self.errors[output][parameter].flat[k]
                lines.append(f"d {output} / d {parameter} = {value:.8g} +- {error:.1e}")
        return "\n".join(lines)


def sensitivity(
    build: Callable[..., Model],
    parameters: Mapping[str, float],
    outputs: Mapping[str, Callable[[Result], ArrayLike]],
    *,
    steps: Mapping[str, float] | float = 1e-3,
    run: Callable[[Model], Any] | None = None,
    **options: Any,
) -> Sensitivity:
    """How outputs of a run change with parameters of the model.

        found = lw.sensitivity(
            build, {"length": 1.0, "mass": 2.0},
            {"height": lambda result: result.position[-1, 0, 2]},
            t_end=2.0, step=1e-3,
        )
        found.derivatives["height"]["length"], found.errors["height"]["length"]

    Central differences with the steps h and h/2 and Richardson's extrapolation, (4 d(h/2) - d(h)) / 3, of
    fourth order: four runs for each parameter and one at the middle. The estimated error is
    |d(h/2) - d(h)| / 3, which is that of d(h/2), a bound for what is better, and not less than what rounding
    makes of the differences. Where it is large, the output is not smooth in the parameter (events, stops,
    another branch, adaptive steps with loose tolerances), or the step is not suitable. Use a fixed step, or a
    tight rtol.

    build       makes the model: build(length=1.0, mass=2.0)
    parameters  by name, at which derivatives are wanted
    outputs     by name, numbers or arrays of the same shape in all runs, of the Result
    steps       h for each parameter [its unit], or for all relative to the parameter (absolute where it is 0)
    run         instead of `simulate(model, **options)`: any analysis; `outputs` get what it returns
    options     of `linkwork.simulate`

    OptionError: no parameters, no outputs, or a step that is not positive. ModelError: an output is not
    finite or changes its shape. Errors of `build` and of the runs name parameter and value in a note.
    """
    h = _steps(parameters, steps)
    if not outputs:
        raise OptionError("sensitivity: outputs are missing: {name: function of the Result}", code="outputs")
    at = {name: float(value) for name, value in parameters.items()}

    def measured(changed: str, value: float) -> dict[str, Floats]:
        try:
            model = build(**{**at, changed: value})
            result = run(model) if run is not None else simulate(model, **{"progress": False, **options})
        except Exception as error:
            error.add_note(f"sensitivity: in the run with {changed} = {value!r}")
            raise
        return {name: _output(name, f(result), changed, value) for name, f in outputs.items()}

    first = next(iter(at))
    middle = measured(first, at[first])
    derivatives: dict[str, dict[str, Floats]] = {name: {} for name in outputs}
    errors: dict[str, dict[str, Floats]] = {name: {} for name in outputs}
    for parameter, value in at.items():
        ends = [measured(parameter, value + c * h[parameter]) for c in (-1.0, -0.5, 0.5, 1.0)]
        for name in outputs:
            samples = [end[name] for end in ends]
            _check_shapes(name, parameter, middle[name], samples)
            derivatives[name][parameter], errors[name][parameter] = _extrapolated(samples, h[parameter])
    return Sensitivity(middle, derivatives, errors, at, h, 1 + 4 * len(at))


def _extrapolated(samples: list[Floats], h: float) -> tuple[Floats, Floats]:
    """The derivative and its error from outputs at -h, -h/2, h/2, h."""
    coarse, fine = (samples[3] - samples[0]) / (2 * h), (samples[2] - samples[1]) / h
    rounding = np.finfo(float).eps * np.max(np.abs(samples), axis=0) / h
    return (4 * fine - coarse) / 3, np.maximum(np.abs(fine - coarse) / 3, rounding)


def _steps(parameters: Mapping[str, float], steps: Mapping[str, float] | float) -> dict[str, float]:
    """OptionError: nothing to vary, or a step that is not positive."""
    if not parameters:
        raise OptionError("sensitivity: parameters are missing: {name: value}", code="parameters")
    found = {}
    for name, value in parameters.items():
        if isinstance(steps, Mapping):
            if name not in steps:
                raise OptionError(f"sensitivity: the step of '{name}' is missing", code="steps")
            found[name] = float(steps[name])
        else:
            found[name] = float(steps) * (abs(float(value)) or 1.0)
        if not np.isfinite(found[name]) or found[name] <= 0 or not np.isfinite(float(value)):
            raise OptionError(
                f"sensitivity: parameter '{name}' = {value!r} with step {found[name]!r}: both must be "
                "finite, the step positive",
                code="steps",
            )
    return found


def _output(name: str, value: ArrayLike, changed: str, at: float) -> Floats:
    array = np.asarray(value, dtype=float)
    if not np.isfinite(array).all():
        raise ModelError(
            f"sensitivity: output '{name}' is not finite with {changed} = {at:.9g}", code="not_finite"
        )
    return array


def _check_shapes(name: str, parameter: str, middle: Floats, samples: list[Floats]) -> None:
    for sample in samples:
        if sample.shape != middle.shape:
            raise ModelError(
                f"sensitivity: output '{name}' has shape {middle.shape}, and {sample.shape} with another "
                f"{parameter}: give `times` to the run, or take one number of the result",
                code="shape",
            )
