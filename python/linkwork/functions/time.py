"""The kinds of functions of time, and how each is told to the compiled module."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.arguments import UNREADABLE, array, check_called, is_number, number, reals
from linkwork.arrays import Floats, ReadOnly
from linkwork.errors import ModelError, counted
from linkwork.fingerprints import law
from linkwork.functions.calls import Calls

__all__ = [
    "Broken", "Callback", "Cycloidal", "Expression", "Harmonic", "Polynomial", "Sum", "Table",
    "TimeFunction", "TimeFunctionLike", "as_time_function", "broken", "check_breaks", "constant",
    "cycloidal", "expression", "harmonic", "infinite_derivative", "piecewise_polynomial",
    "polynomial", "table", "with_breaks",
]  # fmt: skip

#: Of a harmonic, below which an integral has no digits left in the first seconds [rad/s].
SLOWEST = 1e-4

#: A number, a TimeFunction, a function f(t), or a tuple (f, df, ddf) of functions of t.
TimeFunctionLike = Any


class TimeFunction(ABC):
    """A quantity f(t) with its first two derivatives.

    Functions add and subtract, with numbers too, and are multiplied by numbers: 1 + 2 * f - g.
    """

    __array_ufunc__ = None  # numbers of NumPy leave the sum and the product to us

    @property
    def calls(self) -> tuple[Calls, ...]:
        """Of the functions of Python in it."""
        return ()

    def __add__(self, other: TimeFunction | float) -> TimeFunction:
        """ModelError: a number that is not finite."""
        if not isinstance(other, TimeFunction):
            if not _is_factor(other):
                return NotImplemented
            if other == 0:
                return self
            other = constant(other)
        parts = ((it.terms if isinstance(it, Sum) else (it,)) for it in (self, other))
        return Sum(tuple(term for terms in parts for term in terms))

    __radd__ = __add__

    def __pos__(self) -> TimeFunction:
        return self

    def __neg__(self) -> TimeFunction:
        return self.scaled(-1.0)

    def __sub__(self, other: TimeFunction | float) -> TimeFunction:
        if not isinstance(other, TimeFunction) and not _is_factor(other):
            return NotImplemented
        return self + -other

    def __rsub__(self, other: float) -> TimeFunction:
        return -self + other

    def __mul__(self, factor: float) -> TimeFunction:
        """ModelError: the product is not finite."""
        if not _is_factor(factor):
            return NotImplemented
        return self.scaled(float(factor))

    __rmul__ = __mul__

    def __truediv__(self, divisor: float) -> TimeFunction:
        """ModelError: the quotient is not finite."""
        if not _is_factor(divisor):
            return NotImplemented
        if divisor == 0:
            raise ModelError("a function of time cannot be divided by zero", code="time_function")
        return self.scaled(1.0 / float(divisor))

    def scaled(self, factor: float) -> TimeFunction:
        """`factor` times the function. ModelError: it is not known."""
        raise ModelError(
            f"{type(self).__name__.lower()}: not known how it is multiplied by a number", code="time_function"
        )

    @property
    def span(self) -> tuple[float, float]:
        """Times [s] between which the function is defined."""
        return -math.inf, math.inf

    @property
    def has_derivatives(self) -> bool:
        """False where the derivatives are not known: then the function cannot drive a constraint."""
        return True

    def check(self, t_end: float) -> None:
        """ModelError: derivatives of the user's own are wrong somewhere up to t_end [s]."""
        return

    def integral(self) -> TimeFunction:
        """The function with this derivative, zero at t = 0. ModelError: it is not known."""
        raise ModelError(
            f"{type(self).__name__.lower()}: its integral is not known: give the position instead",
            code="time_function",
        )

    @abstractmethod
    def compiled(self) -> _core.TimeFunction:
        """The same function in the compiled module."""

    @property
    def break_points(self) -> list[float]:
        """Times [s] at which it is known not to be smooth, ascending: steps that follow tolerances end there.

        Knots of tables with two continuous derivatives are not among them.
        """
        return sorted({t for t, ends_step in self.compiled().breaks if ends_step})

    def fingerprint(self) -> bytes:
        """Equal for equal functions; one of Python counts by its code and the constants that it reads."""
        return repr(self).encode()

    def evaluate(self, t: float) -> tuple[float, float, float]:
        """(f, df/dt, d2f/dt2) at t [s]; derivatives that are not known are NaN."""
        value, rate, acceleration = self.compiled().evaluate(number(t, "t", ModelError))
        return value, rate, acceleration


@dataclass(frozen=True)
class Polynomial(TimeFunction):
    """f(t) = sum c_k t^k, ascending."""

    coefficients: tuple[float, ...]

    def compiled(self) -> _core.TimeFunction:
        return _core.TimeFunction.polynomial(list(self.coefficients))

    def integral(self) -> TimeFunction:
        return Polynomial((0.0, *(c / (k + 1) for k, c in enumerate(self.coefficients))))

    def scaled(self, factor: float) -> TimeFunction:
        return polynomial(*(factor * c for c in self.coefficients))


@dataclass(frozen=True)
class Harmonic(TimeFunction):
    """f(t) = offset + amplitude sin(frequency t + phase), frequency in rad/s."""

    amplitude: float
    frequency: float
    phase: float
    offset: float

    def compiled(self) -> _core.TimeFunction:
        return _core.TimeFunction.harmonic(self.amplitude, self.frequency, self.phase, self.offset)

    def integral(self) -> TimeFunction:
        if self.frequency == 0:
            return Polynomial((0.0, self.offset + self.amplitude * math.sin(self.phase)))
        if abs(self.frequency) < SLOWEST:
            raise ModelError(
                f"harmonic: its integral at {self.frequency:g} rad/s would be a difference of numbers much "
                f"larger than it, below {SLOWEST:g} rad/s: give the position instead, or a polynomial",
                code="time_function",
            )
        size = self.amplitude / self.frequency
        swing = Harmonic(size, self.frequency, self.phase - math.pi / 2, size * math.cos(self.phase))
        return swing if self.offset == 0 else Sum((swing, Polynomial((0.0, self.offset))))

    def scaled(self, factor: float) -> TimeFunction:
        return harmonic(factor * self.amplitude, self.frequency, self.phase, factor * self.offset)


@dataclass(frozen=True)
class Cycloidal(TimeFunction):
    """rise (s - sin(2 pi s) / 2 pi), s = (t - start) / duration from 0 to 1; constant beyond."""

    rise: float
    start: float
    duration: float

    def compiled(self) -> _core.TimeFunction:
        return _core.TimeFunction.cycloidal(self.rise, self.start, self.duration)

    def scaled(self, factor: float) -> TimeFunction:
        return cycloidal(factor * self.rise, self.duration, self.start)


@dataclass(frozen=True)
class Sum(TimeFunction):
    """The sum of functions."""

    terms: tuple[TimeFunction, ...]

    @property
    def calls(self) -> tuple[Calls, ...]:
        return tuple(calls for term in self.terms for calls in term.calls)

    @property
    def span(self) -> tuple[float, float]:
        spans = [term.span for term in self.terms]
        return max(first for first, _ in spans), min(last for _, last in spans)

    @property
    def has_derivatives(self) -> bool:
        return all(term.has_derivatives for term in self.terms)

    def check(self, t_end: float) -> None:
        for term in self.terms:
            term.check(t_end)

    def compiled(self) -> _core.TimeFunction:
        return _core.TimeFunction.sum([term.compiled() for term in self.terms])

    def fingerprint(self) -> bytes:
        return b"+".join(term.fingerprint() for term in self.terms)

    def integral(self) -> TimeFunction:
        return Sum(tuple(term.integral() for term in self.terms))

    def scaled(self, factor: float) -> TimeFunction:
        return Sum(tuple(term.scaled(factor) for term in self.terms))


@dataclass(frozen=True, eq=False)
class Table(ReadOnly, TimeFunction):
    """A cubic spline through samples; `coefficients` (k-1, 4) in powers of t - breaks[i], ascending."""

    breaks: Floats
    coefficients: Floats

    @property
    def span(self) -> tuple[float, float]:
        return float(self.breaks[0]), float(self.breaks[-1])

    def compiled(self) -> _core.TimeFunction:
        return _core.TimeFunction.piecewise_polynomial(
            self.breaks.tolist(), self.coefficients.ravel().tolist()
        )

    def fingerprint(self) -> bytes:
        return self.breaks.tobytes() + self.coefficients.tobytes()

    def scaled(self, factor: float) -> TimeFunction:
        return piecewise_polynomial(self.breaks, factor * self.coefficients)

    def integral(self) -> TimeFunction:
        """Zero at the first sample where the table does not hold t = 0."""
        from scipy.interpolate import PPoly

        whole = PPoly(self.coefficients.T[::-1], self.breaks).antiderivative()
        if self.span[0] <= 0 <= self.span[1]:
            whole.c[-1] -= whole(0.0)
        return Table(self.breaks, whole.c[::-1].T)


@dataclass(frozen=True)
class Callback(TimeFunction):
    """A Python function, called in every evaluation: slow, and without derivatives unless they are given."""

    value: Callable[[float], float]
    rate: Callable[[float], float] | None = None
    acceleration: Callable[[float], float] | None = None
    what: str = "function of time"  #: that it is for, in messages
    _calls: tuple[Calls, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        functions = (self.value, self.rate, self.acceleration)
        object.__setattr__(self, "_calls", tuple(Calls(it) for it in functions if it is not None))

    @property
    def calls(self) -> tuple[Calls, ...]:
        return self._calls

    @property
    def has_derivatives(self) -> bool:
        return self.rate is not None and self.acceleration is not None

    def check(self, t_end: float) -> None:
        """Its first seconds were looked at when it was made."""
        from linkwork.functions.derivatives import later_starts

        if self.has_derivatives and (starts := later_starts(t_end)):
            _check_derivatives(self.value, self.rate, self.acceleration, self.what, starts)

    def compiled(self) -> _core.TimeFunction:
        value, *derivatives = (it.ask for it in self._calls)
        rate, acceleration = derivatives if self.has_derivatives else (None, None)
        return _core.TimeFunction.callback(value, rate, acceleration, self.what)

    def fingerprint(self) -> bytes:
        return " ".join(map(law, (self.value, self.rate, self.acceleration))).encode()

    def scaled(self, factor: float) -> TimeFunction:
        value, rate, acceleration = (
            None if it is None else _times(factor, it) for it in (self.value, self.rate, self.acceleration)
        )
        assert value is not None
        return Callback(value, rate, acceleration, self.what)


@dataclass(frozen=True)
class Broken(TimeFunction):
    """A function that is not smooth at these times [s], either."""

    function: TimeFunction
    times: tuple[float, ...]

    @property
    def calls(self) -> tuple[Calls, ...]:
        return self.function.calls

    @property
    def span(self) -> tuple[float, float]:
        return self.function.span

    @property
    def has_derivatives(self) -> bool:
        return self.function.has_derivatives

    def check(self, t_end: float) -> None:
        self.function.check(t_end)

    def compiled(self) -> _core.TimeFunction:
        return _core.TimeFunction.with_breaks(self.function.compiled(), list(self.times))

    def fingerprint(self) -> bytes:
        return self.function.fingerprint() + repr(self.times).encode()

    def integral(self) -> TimeFunction:
        return Broken(self.function.integral(), self.times)

    def scaled(self, factor: float) -> TimeFunction:
        return Broken(self.function.scaled(factor), self.times)


def _is_factor(given: Any) -> bool:
    """Whether it is a number. ModelError: one that is not finite."""
    if isinstance(given, float | np.floating) and not math.isfinite(given):
        raise ModelError(f"{given} is not finite: functions of time take finite numbers", code="not_finite")
    return is_number(given)


def _times(factor: float, function: Callable[[float], float]) -> Callable[[float], float]:
    """A function of Python, of t alone, times a number."""
    return lambda t: factor * function(t)


def with_breaks(function: TimeFunctionLike, breaks: ArrayLike) -> TimeFunction:
    """A function that is not smooth at the times `breaks` (k,) [s]: where a formula of yours has a case.

    with_breaks(lambda t: 5.0 if 1.0 <= t < 1.001 else 0.0, breaks=(1.0, 1.001))

    Steps that follow tolerances end at each of them, and what ends there sees the function before, what
    begins there the function after it, whichever side the function counts the time itself to. Without them
    such a step may miss a pulse altogether. `polynomial`, `cycloidal`, `table` and the like know their own.
    In an `expression` it is what is under sqrt or a broken power that becomes zero, as in sqrt((t - 1)**2).
    ModelError: no function of time, times that are not finite.

        pulse = lw.functions.with_breaks(lambda t: 5.0 if 1.0 <= t < 1.001 else 0.0, breaks=(1.0, 1.001))
        model.force("rod", force=(0, 0, pulse))
    """
    given = as_time_function(function, "with_breaks: function")
    whole = given if isinstance(given, TimeFunction) else Polynomial((given,))
    return Broken(whole, check_breaks(breaks, "with_breaks"))


def check_breaks(breaks: ArrayLike, who: str) -> tuple[float, ...]:
    """Times [s], ascending. ModelError: they are no finite numbers."""
    try:
        times = np.unique(reals(breaks, texts=True))
    except UNREADABLE as error:
        raise ModelError(
            f"{who}: breaks {breaks!r:.80} are not times [s]", code="breaks", subject=who, field="breaks"
        ) from error
    if not np.isfinite(times).all():
        raise ModelError(
            f"{who}: breaks {times.tolist()} are not finite", code="breaks", subject=who, field="breaks"
        )
    return tuple(times.tolist())


def broken(arguments: Mapping[str, Any], breaks: ArrayLike, who: str) -> dict[str, Any]:
    """Arguments of an element, functions of time among them, with breaks. ModelError: none is a function."""
    times = check_breaks(breaks, who)
    if not times:
        return dict(arguments)
    functions = {what: x for what, x in arguments.items() if _is_function(x)}
    if not functions:
        raise ModelError(
            f"{who}: breaks, but no function of time", code="breaks", subject=who, field="breaks"
        )
    return {**arguments, **{what: with_breaks(x, times) for what, x in functions.items()}}


def _is_function(x: Any) -> bool:
    return isinstance(x, TimeFunction) or callable(x) or (isinstance(x, tuple) and all(map(callable, x)))


def constant(value: float) -> TimeFunction:
    """
    f(t) = value. A plain number does the same.

        model.drive("motor pin", velocity=lw.functions.constant(2.0))
    """
    return Polynomial((_finite(value, "constant: value"),))


def polynomial(*coefficients: float) -> TimeFunction:
    """f(t) = c_0 + c_1 t + c_2 t^2 + ..., t in s.

    ModelError: no coefficient, or one that is not finite.

        model.drive("motor pin", position=lw.functions.polynomial(0, 2.0, 0.5))
    """
    if not coefficients:
        raise ModelError("polynomial: needs at least one coefficient", code="time_function")
    return Polynomial(tuple(_finite(c, f"polynomial: coefficient {k}") for k, c in enumerate(coefficients)))


def harmonic(amplitude: float, frequency: float, phase: float = 0.0, offset: float = 0.0) -> TimeFunction:
    """f(t) = offset + amplitude sin(frequency t + phase); frequency in rad/s, phase in rad.

    ModelError: a value that is not finite.

        model.drive("motor pin", position=lw.functions.harmonic(amplitude=0.1, frequency=2.0))
    """
    values = {"amplitude": amplitude, "frequency": frequency, "phase": phase, "offset": offset}
    return Harmonic(**{name: _finite(value, f"harmonic: {name}") for name, value in values.items()})


def cycloidal(rise: float, duration: float, start: float = 0.0) -> TimeFunction:
    """The cycloidal motion of cams: up by `rise` from `start` [s] on within `duration` [s], else at rest.

    f = rise (s - sin(2 pi s) / 2 pi), s = (t - start) / duration. ModelError: a duration not positive.

        model.drive("motor pin", position=lw.functions.cycloidal(rise=0.5, duration=2.0))
    """
    values = {"rise": rise, "start": start, "duration": duration}
    checked = {name: _finite(value, f"cycloidal: {name}") for name, value in values.items()}
    if checked["duration"] <= 0:
        raise ModelError(f"cycloidal: duration {duration} s must be positive", code="time_function")
    return Cycloidal(**checked)


def expression(text: str) -> TimeFunction:
    """A formula in t, such as "0.3 * sin(2*pi*t)**2", with its exact derivatives.

    Numbers, t, pi, e, + - * / **, and sin, cos, tan, asin, acos, atan, atan2,
    exp, log, sqrt, tanh. Where it is not smooth, as
    sqrt((t - 1)**2) at 1 s, say so by `with_breaks`: it is not known in advance. It runs in Python: what
    `polynomial`, `harmonic`, `cycloidal` and `table` can say is much faster by them.
    Where a derivative is not finite, as of sqrt(t) at 0 s, it may still be
    a force. ModelError: anything else, or no finite value at t = 0.

        model.drive("motor pin", position=lw.functions.expression("0.3 * sin(2*pi*t)**2"))
    """
    from linkwork.functions.expressions import Formula

    _finite(Formula(text).derivative(0.0, 0), f"expression '{text}': value at t = 0")
    return Expression(text)


@dataclass(frozen=True)
class Expression(TimeFunction):
    """A formula in t."""

    text: str

    def compiled(self) -> _core.TimeFunction:
        from linkwork.functions.expressions import Formula

        formula = Formula(self.text)
        value, rate, acceleration = (partial(formula.derivative, order=k) for k in range(3))
        return _core.TimeFunction.callback(value, rate, acceleration, what=f"expression '{self.text}'")

    def scaled(self, factor: float) -> TimeFunction:
        return expression(f"{factor!r} * ({self.text})")


def table(t: ArrayLike, values: ArrayLike) -> TimeFunction:
    """The cubic spline through samples `values` (k,) at increasing times `t` (k,) [s].

    Twice continuously differentiable, with not-a-knot ends: two samples make a line, three a parabola. It is
    defined between the first and the last time only: a run that goes beyond is refused.
    ModelError: fewer than two samples, unequal lengths, times not increasing, values not finite.

        model.drive("motor pin", position=lw.functions.table([0, 1, 2, 3], [0, 0.1, 0.4, 0.5]))
    """
    breaks, samples = (
        array(x, f"table: {what}", ModelError).copy() for x, what in ((t, "t"), (values, "values"))
    )
    _check_samples(breaks, samples)
    from scipy.interpolate import CubicSpline

    return Table(breaks, CubicSpline(breaks, samples, bc_type="not-a-knot").c[::-1].T)


def piecewise_polynomial(breaks: ArrayLike, coefficients: ArrayLike) -> TimeFunction:
    """f(t) = sum_k c_ik (t - t_i)^k between the times t_i and t_i+1 of `breaks` (k + 1,) [s].

    coefficients (k, any number): a row c_i for each interval, ascending powers. It is defined between the
    first and the last time only. ModelError: breaks that do not increase, no row for each interval, not
    finite.

        rise = lw.functions.piecewise_polynomial([0, 1, 2], [[0, 0, 1], [1, 2, 0]])
    """
    times = array(breaks, "piecewise_polynomial: breaks", ModelError).copy()
    rows = array(coefficients, "piecewise_polynomial: coefficients", ModelError).copy()
    _check_samples(times, times)
    if rows.ndim != 2 or len(rows) != len(times) - 1 or not rows.size:
        shape = f"breaks {times.shape} and coefficients {rows.shape}"
        raise ModelError(
            f"piecewise_polynomial: {shape}: a row for each interval is needed", code="time_function"
        )
    if not np.isfinite(rows).all():
        raise ModelError("piecewise_polynomial: coefficients are not finite", code="not_finite")
    return Table(times, rows)


def as_time_function(x: TimeFunctionLike, what: str) -> float | TimeFunction:
    """What may be given for a quantity of time: a number stays a number, the rest becomes a TimeFunction.

    `what` names the quantity in messages. ModelError: anything else, or no finite value at t = 0.

        angle = lw.functions.as_time_function(lambda t: 0.1 * t**2, "angle")
    """
    if isinstance(x, TimeFunction):
        return x
    if callable(x):
        x = (x,)
    if isinstance(x, tuple) and len(x) in (1, 3) and all(map(callable, x)):
        for function, name in zip(x, ("value", "first derivative", "second derivative"), strict=False):
            check_called(function, ("t",), f"{what}: {name}")
            _finite(_at_zero(function, f"{what}: {name}"), f"{what}: {name} at t = 0", given=False)
        if len(x) == 3:
            from linkwork.functions.derivatives import STARTS

            _check_derivatives(*x, what, STARTS)
        return Callback(*x, what=what)  # type: ignore[misc]
    if isinstance(x, tuple) and x and all(map(callable, x)):
        raise ModelError(
            f"{what}: {counted(len(x), 'function')} in a tuple: give one, or three (f, df, ddf), a function "
            "of time and its derivatives",
            code="time_function",
        )
    return _finite(x, what)


def infinite_derivative(function: TimeFunction) -> str:
    """In words, of a function that enters with its derivatives, one that is not finite at the start."""
    first, last = function.span
    start = min(max(0.0, first), last)
    for name, value in zip(("first", "second"), function.evaluate(start)[1:], strict=True):
        if not math.isfinite(value):
            return f"its {name} derivative at t = {start:g} s is not finite, with which it enters"
    return ""


def _at_zero(function: Callable[[float], Any], what: str) -> Any:
    """An error of the function itself says what it was called for."""
    try:
        return function(0.0)
    except Exception as error:
        error.add_note(f"linkwork: {what} at t = 0")
        raise


def _check_derivatives(f: Any, df: Any, ddf: Any, what: str, starts: Iterable[float]) -> None:
    """ModelError: `df` or `ddf` is not the derivative of what comes before it, in an interval from there."""
    from linkwork.functions.derivatives import disagreement

    for name, function, derivative in (("first", f, df), ("second", df, ddf)):
        if found := disagreement(function, derivative, starts):
            before = "value" if name == "first" else "first derivative"
            raise ModelError(
                f"{what}: the {name} derivative adds up to {found.integral:.6g} from t = {found.start:g} to "
                f"{found.end:g} s, where the {before} changes by {found.change:.6g}; correct it",
                code="derivatives",
            )


def _finite(x: Any, what: str, given: bool = True) -> float:
    """What is given, or returned by a function."""
    try:
        value = float(reals(x, texts=given))
    except UNREADABLE as error:
        choices = "a number, a function of time, or a tuple of functions (f, df, ddf)"
        raise ModelError(f"{what}: {x!r:.80} is not {choices}", code="not_a_number") from error
    if not math.isfinite(value):
        raise ModelError(f"{what}: {value} is not finite", code="not_finite")
    return value


def _check_samples(t: Floats, values: Floats) -> None:
    if t.ndim != 1 or t.shape != values.shape or len(t) < 2:
        shapes = f"t {t.shape} and values {values.shape}"
        raise ModelError(
            f"table: {shapes} must be two or more samples, as many values as times", code="time_function"
        )
    for name, samples in (("time", t), ("value", values)):
        if not np.isfinite(samples).all():
            k = int(np.argmin(np.isfinite(samples)))
            raise ModelError(f"table: {name} {k} is {samples[k]}, not finite", code="not_finite")
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        steps = np.diff(t)
        slopes = np.diff(values) / steps
    if (steps <= 0).any():
        k = int(np.argmax(steps <= 0))
        raise ModelError(
            f"table: times, or coordinates, must increase, but {t[k + 1]:g} follows {t[k]:g}",
            code="time_function",
        )
    possible = np.isfinite(steps) & np.isfinite(slopes)
    if not possible.all():
        k = int(np.argmin(possible))
        where = f"{values[k]:g} at {t[k]:g} and {values[k + 1]:g} at {t[k + 1]:g}"
        raise ModelError(f"table: the slope between {where} is beyond all numbers", code="not_finite")
