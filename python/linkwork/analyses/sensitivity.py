"""Sensitivity of the results of a run to parameters of its model, by finite differences with their error."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from linkwork.accuracy.verdict import Verdict
from linkwork.analyses.difference_ladder import Difference, Ladder, descend, difference, largest
from linkwork.analyses.parameter_sizes import size_of_parameter
from linkwork.arguments import UNREADABLE, check_takes, number, reals
from linkwork.arrays import Floats, ReadOnly
from linkwork.errors import LinkworkWarning, ModelError, OptionError, nearest
from linkwork.modeling.model import Model, check_bodies
from linkwork.results.result import Result
from linkwork.running.leaving_no_memory import called, leaving_no_memory
from linkwork.running.simulation import simulate

__all__ = ["Sensitivity", "sensitivity"]

#: Steps relative to the parameter that its rounding would swallow.
SMALLEST_STEP = 1e-13

#: Steps relative to the parameter below which no smaller ones are tried.
SMALLEST_LADDER = 1e-9

#: Parameters, in any unit, of which it is looked whether they are zero but for rounding of the model.
SMALL_IN_ITS_UNIT = 1e-6

#: Parameters relative to their sizes that may be rounding.
ROUNDED = 1e-9

#: Derivatives, relative to the output over the size of the parameter, that are as good as zero.
NEGLIGIBLE = 1e-6

#: Runs at h/2 may be off by more than those at h, of which finer ones are made.
ALLOWANCE = 3.0


@dataclass(frozen=True, eq=False)
class Sensitivity(ReadOnly):
    """Derivatives of outputs by parameters, each with an estimate of its error."""

    values: Mapping[str, Floats]  #: outputs at the parameters as given
    derivatives: Mapping[str, Mapping[str, Floats]]  #: [output][parameter], in the shape of the output
    errors: Mapping[str, Mapping[str, Floats]]  #: estimated errors of the derivatives, absolute
    parameters: Mapping[str, float]
    steps: Mapping[str, float]  #: the larger of the two, for each parameter; of several, the smallest used
    runs: int

    def relative(self, output: str, parameter: str) -> Floats:
        """(dy / y) / (dp / p), without unit; infinite where the output is zero.

            found.relative("height", "length")

        ModelError: no such names.
        """
        for name, known in ((output, self.derivatives), (parameter, self.parameters)):
            if not isinstance(name, str) or name not in known:
                raise ModelError(
                    f"sensitivity: no output or parameter named {name!r}{nearest(str(name), known)}",
                    code="unknown_name",
                )
        with np.errstate(divide="ignore", invalid="ignore"):
            change: Floats = self.derivatives[output][parameter] * self.parameters[parameter]
            return change / self.values[output]

    def __str__(self) -> str:
        """A line for each output and parameter; of arrays the largest."""
        lines = []
        for output, by in self.derivatives.items():
            for parameter, derivative in by.items():
                if not derivative.size:
                    lines.append(f"d {output} / d {parameter}: no numbers")
                    continue
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
    fourth order: four runs for each parameter and one at the middle. Where both steps do not agree within a
    hundredth of the derivative, steps of h/100, h/10000 ... follow until two of them do; where none do, as at
    a kink, a LinkworkWarning says so. The estimated error is |d(h/2) - d(h)|, half the jump between the
    derivatives on both sides, and what rounding makes of the differences; where there are several h, what
    they differ by, too; and beside, what the runs are off by: two of the four are made once more, finer, as
    by `verify` of simulate, which gives d(h) without the most of it. Where there is no finer run, as with
    `run`, or an output is not found in it, it is the outputs over h, times the error of the verdicts: much
    more than the truth as a rule. Where it is large, the output is not smooth in the parameter (events,
    stops, another branch, adaptive steps with loose tolerances), or steps are not suitable. Use a fixed step,
    or a tight rtol.

    A parameter that is zero has the size by which it changes the whole of the model: a coordinate the length
    of the mechanism, an angle 1 rad, an added mass that mass, a stiffness one that holds the weight. Where
    the model does not tell, as of what its functions depend on, h is absolute, and always followed by a
    smaller one that has to agree.

    build       makes the model: build(length=1.0, mass=2.0)
    parameters  by name, at which derivatives are wanted
    outputs     by name, numbers or arrays of the same shape in all runs, of the Result
    steps       h for each parameter [its unit], which is taken as it is; or for all relative to the
                parameter, where that is 0 to its size, as above
    run         instead of `simulate(model, **options)`: any analysis; `outputs` get what it returns
    options     of `linkwork.simulate`

    Each run begins with what functions of the model and events remember at the call.

    OptionError: no parameters, or some that `build` does not take, no outputs, a step that is not positive,
    or options beside `run`. ModelError: an output is not finite or changes its shape. Errors of `build`, of
    the runs and of outputs name parameter and value in a note.
    """
    at = _parameters(parameters)
    h = _steps(at, steps)
    _check_functions(build, outputs)
    check_takes(build, list(at), str(getattr(build, "__name__", type(build).__name__)))
    if run is not None and not callable(run):
        raise OptionError(f"sensitivity: run is {run!r:.80}, not a function of a Model", code="run")
    if run is None and "t_end" not in options:
        raise OptionError("sensitivity: t_end is missing, up to which simulate runs [s]", code="options")
    if run is not None and options:
        raise OptionError(
            f"sensitivity: {', '.join(options)}: options of simulate, which `run` replaces; give them there",
            code="options",
        )

    runs = _Runs(build, at, outputs, run, options)
    first = next(iter(at))
    middle = runs.sample(first, at[first]).outputs
    derivatives: dict[str, dict[str, Floats]] = {name: {} for name in outputs}
    errors: dict[str, dict[str, Floats]] = {name: {} for name in outputs}
    for parameter in at:
        ladders = _ladders(runs, middle, parameter, h, isinstance(steps, Mapping))
        h[parameter] = min(it.best.step for it in ladders.values())
        for name, ladder in ladders.items():
            derivatives[name][parameter], errors[name][parameter] = ladder.best.derivative, ladder.error
        _warn(parameter, ladders)
    return Sensitivity(middle, derivatives, errors, at, h, runs.count)


def _ladders(
    runs: _Runs, middle: dict[str, Floats], parameter: str, h: Mapping[str, float], given: bool
) -> dict[str, Ladder]:
    """Of each output, by a parameter. Steps that are `given` are taken as they are."""
    value, step = runs.at[parameter], h[parameter]
    size: float | None = abs(value)
    if not given and abs(value) < SMALL_IN_ITS_UNIT:
        size = size_of_parameter(lambda at: runs.built(parameter, at).compiled(), value)
        if size is None or abs(value) > ROUNDED * size:
            size = abs(value) or None
        step *= (size or 1.0) / (abs(value) or 1.0)
    ladders = {
        name: Ladder(NEGLIGIBLE * largest(y) / (size or 1.0), given or size is not None)
        for name, y in middle.items()
    }

    def differences(step: float) -> dict[str, Difference]:
        ends = [runs.sample(parameter, value + c * step, finer=abs(c) == 1.0) for c in (-1.0, -0.5, 0.5, 1.0)]
        found = {}
        for name, y in middle.items():
            samples = [end.outputs[name] for end in ends]
            _check_shapes(name, parameter, y, samples)
            found[name] = difference(samples, y, value, step, _of_runs(ends, name, step))
        return found

    descend(ladders, differences, step, SMALLEST_LADDER * abs(value), 1 if given else None)
    return ladders


def _warn(parameter: str, ladders: Mapping[str, Ladder]) -> None:
    unsettled = [name for name, it in ladders.items() if not it.settled]
    if unsettled:
        it = ladders[unsettled[0]]
        tried = " to ".join(f"{step:.3g}" for step in dict.fromkeys((it.rungs[0].step, it.rungs[-1].step)))
        warnings.warn(
            f"sensitivity: d {' and '.join(unsettled)} / d {parameter}: differences with steps {tried} do "
            "not agree; `errors` has by how much, and the truth may be farther. Either the output is not "
            "smooth there (a maximum, a stop, an event, loose tolerances), or no step is of the size on "
            f"which {parameter} acts: give that by steps={{'{parameter}': ...}}",
            LinkworkWarning,
            stacklevel=3,
        )


class _Sample(NamedTuple):
    """Outputs of a run, by how much it is off by its verdict, and they by a finer run, where known."""

    outputs: dict[str, Floats]
    inexact: float
    off: dict[str, Floats]


@dataclass
class _Runs:
    """Runs with one parameter changed."""

    build: Callable[..., Model]
    at: Mapping[str, float]
    outputs: Mapping[str, Callable[[Result], ArrayLike]]
    run: Callable[[Model], Any] | None
    options: Mapping[str, Any]
    count: int = 0

    def built(self, changed: str, value: float) -> Model:
        return self.build(**{**self.at, changed: value})

    def sample(self, changed: str, value: float, *, finer: bool = False) -> _Sample:
        """Errors name the parameter and its value in a note."""
        try:
            model = self.built(changed, value)
            check_bodies(model)
            with leaving_no_memory(called(model, self.options), logs=False):
                result = self._result(model, finer)
                verdict = getattr(result, "verdict", None)
                inexact = verdict.error if isinstance(verdict, Verdict) else 0.0
                found = self._outputs_of(result, changed, value)
                return _Sample(found, inexact, self._off(result, found, changed, value) if finer else {})
        except Exception as error:
            error.add_note(f"sensitivity: in the run with {changed} = {value!r}")
            raise

    def _result(self, model: Model, finer: bool) -> Any:
        self.count += 1
        if self.run is not None:
            return self.run(model)
        options = {"progress": False, **self.options}
        if not finer:
            return simulate(model, **options)
        with warnings.catch_warnings():  # without a finer run the error is another one
            warnings.filterwarnings("ignore", "verify: ", LinkworkWarning)
            return simulate(model, **{**options, "verify": True})

    def _outputs_of(self, result: Any, changed: str, value: float) -> dict[str, Floats]:
        return {name: _output(name, f(result), changed, value) for name, f in self.outputs.items()}

    def _off(self, result: Any, found: dict[str, Floats], changed: str, value: float) -> dict[str, Floats]:
        """Without those that a finer run has not, or in another shape, as where it has not all frames."""
        second = getattr(result, "_finer", None)
        if second is None:
            return {}
        self.count += 1
        finer, off = second.result if second.own is None else second.own, {}
        for name, f in self.outputs.items():
            try:
                other = _output(name, f(finer), changed, value)
            except Exception:  # it may have no event at which the function looks
                continue
            if other.shape == found[name].shape:
                off[name] = second.factor * (found[name] - other)
        return off


def _of_runs(ends: list[_Sample], name: str, h: float) -> Floats:
    """The error of a derivative by that of the runs, from -h to h."""
    first, last = ends[0].off.get(name), ends[-1].off.get(name)
    if first is not None and last is not None:
        return ALLOWANCE * np.abs(last - first) / (2 * h)
    inexact = max(end.inexact for end in ends)
    return np.asarray(inexact * np.max([np.abs(end.outputs[name]).max(initial=0.0) for end in ends]) / h)


def _parameters(given: Mapping[str, float]) -> dict[str, float]:
    """OptionError: nothing to vary, or no finite numbers."""
    if not isinstance(given, Mapping) or not given:
        raise OptionError("sensitivity: parameters are missing: {name: value}", code="parameters")
    return {name: _number(value, f"parameter '{name}'") for name, value in given.items()}


def _steps(at: Mapping[str, float], steps: Mapping[str, float] | float) -> dict[str, float]:
    """OptionError: a step that is missing, not positive, or lost in the parameter's rounding."""
    if isinstance(steps, Mapping):
        for name in steps:
            if name not in at:
                raise OptionError(f"sensitivity: no parameter '{name}'{nearest(name, at)}", code="steps")
        for name in at:
            if name not in steps:
                raise OptionError(f"sensitivity: the step of '{name}' is missing", code="steps")
        h = {name: _number(steps[name], f"the step of '{name}'") for name in at}
    else:
        relative = _number(steps, "steps")
        h = {name: relative * (abs(value) or 1.0) for name, value in at.items()}
    for name, step in h.items():
        if not step > SMALLEST_STEP * abs(at[name]):
            raise OptionError(
                f"sensitivity: parameter '{name}' = {at[name]!r} with step {step!r}: steps must be positive, "
                "and more than the rounding of the parameter",
                code="steps",
            )
    return h


def _number(value: object, what: str) -> float:
    """OptionError: not a finite number."""
    return number(value, f"sensitivity: {what}")


def _check_functions(
    build: Callable[..., Model], outputs: Mapping[str, Callable[[Result], ArrayLike]]
) -> None:
    """OptionError: not a function, or not functions by name."""
    if not callable(build):
        raise OptionError(
            f"sensitivity: build is {build!r:.80}, not a function that makes a Model", code="build"
        )
    if not isinstance(outputs, Mapping) or not outputs:
        raise OptionError("sensitivity: outputs are missing: {name: function of the Result}", code="outputs")
    for name, function in outputs.items():
        if not callable(function):
            raise OptionError(
                f"sensitivity: output '{name}' is {function!r:.80}, not a function of the Result",
                code="outputs",
            )


def _output(name: str, value: ArrayLike, changed: str, at: float) -> Floats:
    try:
        array = reals(value)
    except UNREADABLE:
        raise ModelError(
            f"sensitivity: output '{name}' is {value!r:.80}, not numbers", code="not_a_number"
        ) from None
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
