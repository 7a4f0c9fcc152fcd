"""Functions of time."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions
from linkwork.functions import as_time_function

T = np.array([0.0, 0.3, 0.35, 1.0, 1.2, 2.0])


def test_a_polynomial_has_its_derivatives() -> None:
    assert functions.polynomial(1, 2, 3, 4).evaluate(0.5) == pytest.approx((3.25, 8.0, 18.0), rel=1e-15)


def test_a_harmonic_has_its_derivatives() -> None:
    angle = 3 * 0.5 + 0.2
    expected = (1 + 2 * math.sin(angle), 6 * math.cos(angle), -18 * math.sin(angle))
    found = functions.harmonic(amplitude=2, frequency=3, phase=0.2, offset=1).evaluate(0.5)
    assert found == pytest.approx(expected, rel=1e-15)


def test_a_constant_does_not_change() -> None:
    assert functions.constant(4.5).evaluate(7.0) == (4.5, 0.0, 0.0)


@pytest.mark.parametrize("count", [2, 3, 4, 5, 6])
def test_a_table_meets_its_samples_and_is_twice_continuously_differentiable(count: int) -> None:
    t, values = T[:count], np.sin(5 * T[:count])
    table = functions.table(t, values)
    assert [table.evaluate(time)[0] for time in t] == pytest.approx(values, abs=1e-14)
    for time in t[1:-1]:
        left, right = (table.evaluate(np.nextafter(time, side)) for side in (0.0, 9.0))
        assert left == pytest.approx(right, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_a_table_of_few_samples_is_the_polynomial_through_them(count: int) -> None:
    t, values = T[:count], np.sin(5 * T[:count])
    through = np.polynomial.Polynomial.fit(t, values, count - 1)
    table = functions.table(t, values)
    for time in np.linspace(t[0], t[-1], 40):
        expected = [float(through.deriv(order)(time)) for order in range(3)]
        assert table.evaluate(time) == pytest.approx(expected, rel=1e-10, abs=1e-10)


def test_a_table_of_a_cubic_is_the_cubic() -> None:
    cubic = functions.polynomial(1, -2, 0.5, 3)
    table = functions.table(T, [cubic.evaluate(t)[0] for t in T])
    for time in np.linspace(0, 2, 33):
        assert table.evaluate(time) == pytest.approx(cubic.evaluate(time), rel=1e-12, abs=1e-12)


def test_the_error_of_a_table_falls_with_the_fourth_power_of_its_step() -> None:
    def error(samples: int) -> float:
        t = np.linspace(0, 1, samples)
        table = functions.table(t, np.exp(t))
        return max(abs(table.evaluate(x)[0] - math.exp(x)) for x in np.linspace(0, 1, 777))

    assert math.log2(error(41) / error(81)) == pytest.approx(4.0, abs=0.2)


@pytest.mark.parametrize(
    ("t", "values", "fragment"),
    [
        ([0.0], [1.0], "(1,)"),
        ([0, 1, 2], [1, 2], "(2,)"),
        ([0, 1, 1], [1, 2, 3], "1 follows 1"),
        ([0, 2, 1], [1, 2, 3], "1 follows 2"),
        ([0, math.nan, 1], [1, 2, 3], "time 1 is nan"),
        ([0, 1, 2], [1, 2, math.inf], "value 2 is inf"),
    ],
)
def test_a_bad_table_is_refused(t: list[float], values: list[float], fragment: str) -> None:
    with pytest.raises(lw.ModelError) as caught:
        functions.table(t, values)
    assert fragment in str(caught.value)


def test_a_table_is_not_extrapolated() -> None:
    with pytest.raises(lw.OptionError, match="2.5"):
        functions.table(T, T).evaluate(2.5)


def test_a_run_beyond_a_table_is_refused_before_it_starts() -> None:
    model = lw.mechanisms.rod_pendulum()
    model.force("rod", force=(functions.table([0, 1], [0, 1]), 0, 0), name="push")
    with pytest.raises(lw.OptionError, match=r"'push': force_x: is given from 0 to 1 s.*to 2 s"):
        lw.simulate(model, t_end=2.0, step=0.1)


def test_a_number_stays_a_number() -> None:
    assert as_time_function(3, "stiffness") == 3.0


def test_a_tuple_of_functions_has_derivatives() -> None:
    function = as_time_function((math.sin, math.cos, lambda t: -math.sin(t)), "length")
    assert isinstance(function, functions.TimeFunction)
    assert function.has_derivatives
    assert function.evaluate(0.3) == (math.sin(0.3), math.cos(0.3), -math.sin(0.3))


def test_a_plain_function_has_none() -> None:
    function = as_time_function(math.sin, "force")
    assert isinstance(function, functions.TimeFunction)
    assert not function.has_derivatives
    assert np.isnan(function.evaluate(0.3)[1:]).all()


@pytest.mark.parametrize("bad", [None, "fast", math.nan, (math.sin, math.cos), lambda t: math.inf, [1, 2]])
def test_what_is_no_function_of_time_is_refused_by_name(bad: object) -> None:
    with pytest.raises(lw.ModelError, match="coil: stiffness"):
        as_time_function(bad, "coil: stiffness")


def test_an_error_in_a_python_function_reaches_the_user() -> None:
    def push(t: float) -> float:
        if t > 0.05:
            raise ZeroDivisionError("at 0.05 s")
        return 1.0

    model = lw.mechanisms.rod_pendulum()
    model.force("rod", force=(push, 0, 0))
    with pytest.raises(ZeroDivisionError, match="at 0.05 s"):
        lw.simulate(model, t_end=0.1, step=0.01)


@pytest.mark.parametrize("drive", ["harmonic", "python"])
def test_the_work_of_a_driven_length_is_the_change_of_energy(drive: str) -> None:
    """A mass on a rod that grows and shrinks: no other force has work."""
    sine, cosine = (lambda t: math.sin(3 * t)), (lambda t: math.cos(3 * t))
    python = (lambda t: 1 + 0.2 * sine(t), lambda t: 0.6 * cosine(t), lambda t: -1.8 * sine(t))
    harmonic = functions.harmonic(amplitude=0.2, frequency=3.0, offset=1.0)
    length = {"harmonic": harmonic, "python": python}[drive]
    model = lw.Model(gravity=(0, -9.81, 0))
    bob = model.body("bob", mass=1, inertia=(1, 1, 1), position=(1, 0, 0), velocity=(0.6, 0, 0))
    model.distance(model.ground, bob, at=((0, 0, 0), (1, 0, 0)), length=length)
    result = lw.simulate(model, t_end=1.0, step=1e-3)
    assert np.abs(result.energy_error).max() < 1e-8
    assert np.abs(result.work).max() > 0.1


# --- drives: cycloidal, expressions, integrals --------------------------------------------------------------


def differences(f: functions.TimeFunction, t: float, h: float = 1e-4) -> tuple[float, float]:
    low, middle, high = (f.evaluate(t + k * h)[0] for k in (-1, 0, 1))
    return (high - low) / (2 * h), (high - 2 * middle + low) / h**2


@pytest.mark.parametrize(
    "f",
    (
        functions.cycloidal(0.4, 1.5, start=0.1),
        functions.expression("0.3*sin(2*pi*t)**2 - t/(1 + t**2) + 2**t"),
        functions.expression("sqrt(1 + t) * exp(-t) + log(2 + t) * tanh(t) - tan(t/3) + cos(t)**-1.5"),
        functions.polynomial(1, 2, 3).integral(),
        functions.harmonic(2, 3, 0.4, 0.7).integral(),
        functions.table(T, np.sin(3 * T)).integral(),
    ),
    ids=lambda f: type(f).__name__,
)
def test_derivatives_are_those_of_differences(f: functions.TimeFunction) -> None:
    for t in (0.2, 0.7, 1.1):
        rate, acceleration = differences(f, t)
        assert f.evaluate(t)[1] == pytest.approx(rate, rel=1e-6, abs=1e-7)
        assert f.evaluate(t)[2] == pytest.approx(acceleration, rel=1e-4, abs=1e-5)


@pytest.mark.parametrize(
    "f",
    (
        functions.polynomial(1, 2, 3),
        functions.harmonic(2, 3, 0.4, 0.7),
        functions.harmonic(2, 0, 0.4, 0.7),
        functions.table(T, np.sin(3 * T)),
    ),
    ids=lambda f: type(f).__name__,
)
def test_an_integral_starts_at_zero_with_the_function_as_its_rate(f: functions.TimeFunction) -> None:
    whole = f.integral()
    assert whole.evaluate(0.0)[0] == pytest.approx(0.0, abs=1e-15)
    for t in (0.0, 0.31, 0.9, 1.9):
        value, rate, _ = f.evaluate(t)
        assert whole.evaluate(t)[1:] == pytest.approx((value, rate), rel=1e-13, abs=1e-13)


def test_a_cycloidal_motion_rests_before_and_after() -> None:
    f = functions.cycloidal(0.4, 1.5, start=0.1)
    assert f.evaluate(0.1) == (0.0, 0.0, 0.0)
    assert f.evaluate(-3.0) == (0.0, 0.0, 0.0)
    assert f.evaluate(1.6) == pytest.approx((0.4, 0.0, 0.0), abs=1e-14)
    assert f.evaluate(0.85)[1] == pytest.approx(2 * 0.4 / 1.5)  # twice the mean speed in the middle


@pytest.mark.parametrize(
    "text",
    ("", "2 *", "x + 1", "sin(t", "sin(t, 2)", "__import__('os')", "t.real", "[t]", "t if t else 1",
     "lambda: t", "'t'", "1/t", "log(t)", "t" * 3000, "(" * 300 + "t" + ")" * 300, "1e400*t", "True",
     "t := 3", "sine(t)", "1" + "0" * 400, "(-1)**0.5", "sin((t - 1)**0.5)", "(t - 1)**(t + 0.5)"),
)  # fmt: skip
def test_text_that_is_no_formula_is_refused(text: str) -> None:
    with pytest.raises(lw.ModelError):
        functions.expression(text)


def test_a_formula_with_a_caret_is_told_how_powers_are_written() -> None:
    with pytest.raises(lw.ModelError, match=r"written with \*\*"):
        functions.expression("exp(-((t - 1) / 0.2)^2)")


def test_a_formula_that_keeps_its_last_time_is_right_at_any_order_of_times() -> None:
    formula = functions.expression("sqrt(t)").compiled()
    for t in (1.0, 4.0, 4.0, -1.0, 1.0, -1.0, 4.0):
        exact = (np.sqrt(t), 0.5 * t**-0.5, -0.25 * t**-1.5) if t > 0 else (np.nan,) * 3
        assert formula.evaluate(t) == pytest.approx(exact, rel=1e-15, nan_ok=True)


def test_an_error_at_the_start_says_what_the_function_was_called_for() -> None:
    with pytest.raises(ZeroDivisionError) as caught:
        as_time_function(lambda t: 1 / t, "coil: stiffness")
    assert caught.value.__notes__ == ["linkwork: coil: stiffness: value at t = 0"]


def test_wrong_derivatives_are_refused() -> None:
    right = (math.sin, math.cos, lambda t: -math.sin(t))
    assert as_time_function(right, "drive").evaluate(0.3)[1] == math.cos(0.3)
    with pytest.raises(lw.ModelError, match="second derivative"):
        as_time_function((math.sin, math.cos, math.sin), "drive")
    with pytest.raises(lw.ModelError, match="first derivative"):
        as_time_function((math.sin, math.sin, math.cos), "drive")


def test_integrals_that_would_cancel_are_refused() -> None:
    """A cos(w t) / w less its value at 0: at 3e-6 rad/s a position from an acceleration has 5 digits."""
    with pytest.raises(lw.ModelError, match=r"its integral at 3e-06 rad/s .*: give the position"):
        functions.harmonic(1.0, 3e-6).integral()


@pytest.mark.parametrize(("t", "values"), [
    ([0, 1], [1e308, -1e308]), ([0, 5e-324], [0, 1]), ([-1e308, 1e308], [0, 1]),
])  # fmt: skip
def test_tables_beyond_all_numbers_are_refused(t: list[float], values: list[float]) -> None:
    with pytest.raises(lw.ModelError, match="table: the slope between"):
        lw.functions.table(t, values)


@pytest.mark.parametrize(
    ("text", "exact"),
    [("6 * sqrt(t)", 24 / 15), ("t**1.5", 4 / 35), ("acos(1 - t)", None), ("0.1 * t * t**0.5", 0.4 / 35)],
)
def test_a_force_may_begin_with_an_infinite_derivative(text: str, exact: float | None) -> None:
    """A mass of 1 kg is pushed by t^a: it goes t^(a + 2) / ((a + 1) (a + 2))."""
    model = lw.Model(gravity=(0, 0, 0))
    ball = model.body("ball", mass=1.0, inertia=(1, 1, 1))
    model.force(ball, force=(functions.expression(text), 0, 0), at=(0, 0, 0))
    result = lw.simulate(model, t_end=1.0, rtol=1e-9, progress=False)
    if exact is None:  # the force twice integrated, substituting t = 1 - cos(u)
        u = np.linspace(0.0, np.pi / 2, 100_001)
        exact = float(np.trapezoid(np.cos(u) * u * np.sin(u), u))
    assert result.position[-1, 0, 0] == pytest.approx(exact, rel=1e-7)


@pytest.mark.parametrize(("text", "which"), [("sqrt(t)", "first"), ("t**1.5", "second")])
def test_a_driver_with_an_infinite_derivative_is_refused_with_the_reason(text: str, which: str) -> None:
    model = lw.mechanisms.four_bar()
    why = f"{which} derivative at t = 0 s is not finite, with which it enters"
    with pytest.raises(lw.ModelError, match=why):
        model.drive("pin 0", position=functions.expression(text))
    with pytest.raises(lw.ModelError, match=why):
        model.coupler([("pin 0", 1.0)], offset=functions.expression(text))


@pytest.mark.parametrize("text", ["log(t)", "1/t", "t**-0.5", "sqrt(t - 1)", "asin(t + 2)"])
def test_an_expression_without_a_value_at_the_start_is_refused(text: str) -> None:
    with pytest.raises(lw.ModelError, match="value at t = 0: nan is not finite"):
        functions.expression(text)


def some_functions() -> dict[str, functions.TimeFunction]:
    return {
        "polynomial": functions.polynomial(1.0, -2.0, 0.5),
        "harmonic": functions.harmonic(0.7, 3.0, 0.2, 0.4),
        "cycloidal": functions.cycloidal(0.5, 1.1, 0.2),
        "table": functions.table(T, np.sin(5 * T)),
        "expression": functions.expression("exp(-t) * sin(3 * t)"),
        "python": functions.with_breaks((lambda t: t**3, lambda t: 3 * t**2, lambda t: 6 * t), [0.8]),
    }


@pytest.mark.parametrize("name", some_functions())
def test_sums_and_multiples_have_the_derivatives_of_their_terms(name: str) -> None:
    f, g = some_functions()[name], functions.harmonic(1.3, 2.0)
    sums = {
        f + g: (1, 1, 0),
        f - 2 * g: (1, -2, 0),
        3.0 - f * np.float64(0.5): (-0.5, 0, 3),
        -f + 1: (-1, 0, 1),
        +f / 4 - g / np.float32(0.5): (0.25, -2, 0),
    }
    for found, (a, b, c) in sums.items():
        for t in (0.0, 0.45, 1.7):
            expected = a * np.array(f.evaluate(t)) + b * np.array(g.evaluate(t)) + np.array([c, 0, 0])
            assert found.evaluate(t) == pytest.approx(expected, rel=1e-14, abs=1e-14)
        assert set(f.break_points) <= set(found.break_points) and found.span == f.span
        assert found.fingerprint() != f.fingerprint() != g.fingerprint()


def test_a_sum_of_many_functions_goes_through_a_file(tmp_path: Path) -> None:
    """However long: terms of sums are terms of the whole."""
    law = functions.constant(0.5)
    for k, term in enumerate(list(some_functions().values())[:-1] * 2):
        law = 1.5 * law - term + k
    model = lw.Model()
    body = model.body("body", mass=1.0, inertia=(1, 1, 1))
    model.force(body, force=(law, 0, 0), name="push")
    model.save(tmp_path / "model.yaml")
    again = lw.Model.load(tmp_path / "model.yaml")
    assert again.hash() == model.hash()


@pytest.mark.parametrize("suffix", ["yaml", "json"])
def test_functions_with_breaks_go_through_a_file(tmp_path: Path, suffix: str) -> None:
    pulse = functions.with_breaks(functions.harmonic(1.0, 2.0), (0.5, 0.7))
    bent = functions.with_breaks(functions.expression("sqrt((t-1)**2)"), [1.0]) / 2 + 3.0
    model = lw.Model()
    body = model.body("body", mass=1.0, inertia=(1, 1, 1))
    model.force(body, force=(pulse, bent, functions.with_breaks(pulse + bent, 0.9)), name="push")
    model.force(body, force=(functions.harmonic(1.0, 3.0), 0, 0), breaks=0.3, name="late")
    model.save(tmp_path / f"model.{suffix}")
    again = lw.Model.load(tmp_path / f"model.{suffix}")
    assert again.hash() == model.hash()
    assert [f.break_points for _, f in again.signals] == [f.break_points for _, f in model.signals]


def test_a_motion_of_two_parts_drives_a_joint() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=(1, 1, 1))
    model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.drive(
        "pin", position=sum([functions.cycloidal(1.0, 0.5), 0.1 * functions.cycloidal(1.0, 0.2, 0.6)])
    )
    result = lw.simulate(model, 1.0, 1e-2, progress=False)
    assert result.coordinate("pin").value[-1] == pytest.approx(1.1, abs=1e-9)


def test_functions_are_not_multiplied_with_each_other() -> None:
    f = functions.constant(2.0)
    for wrong in (lambda: f * f, lambda: f + "1", lambda: "1" - f):  # type: ignore[operator]
        with pytest.raises(TypeError, match="unsupported operand"):
            wrong()
    with pytest.raises(lw.ModelError, match="not finite"):
        f * 1e308
    for not_finite in (
        lambda: math.nan * f,
        lambda: f + np.inf,
        lambda: f - np.float32(np.nan),
        lambda: f / np.inf,
    ):
        with pytest.raises(lw.ModelError, match="is not finite"):
            not_finite()
    with pytest.raises(lw.ModelError, match="divided by zero"):
        f / 0


def test_a_table_is_the_one_that_was_given() -> None:
    t, values, rows = np.arange(4.0), np.arange(4.0), np.ones((3, 4))
    samples, pieces = functions.table(t, values), functions.piecewise_polynomial(t, rows)
    before = samples.evaluate(1.5), pieces.evaluate(1.5)
    values *= 2
    rows *= 2
    assert (samples.evaluate(1.5), pieces.evaluate(1.5)) == before
    for array in (samples.coefficients, pieces.coefficients, pieces.breaks):
        with pytest.raises(ValueError, match="read-only"):
            array *= 2


def test_functions_that_do_not_take_the_time_are_refused_by_name() -> None:
    model = lw.Model()
    model.body("b", mass=1.0, inertia=(1, 1, 1))
    with pytest.raises(lw.ModelError, match="force_x: value: its function does not take \\(t\\)"):
        model.force("b", force=(lambda a, b: 1.0, 0, 0))
    event = lw.Event(lambda t: t)  # type: ignore[arg-type]
    with pytest.raises(lw.OptionError, match="its function does not take \\(t, state\\)"):
        lw.simulate(model, 0.1, rtol=1e-6, events=event, progress=False)


@pytest.mark.parametrize(
    "given",
    [
        True,
        np.True_,
        [True, 1, 1],
        (1, np.True_, 1),
        np.array([True, 1, 1], object),
        (np.eye(3) == 1).tolist(),
    ],
)
def test_truth_values_are_no_numbers(given: Any) -> None:
    """But what a function returns, as `t > 1`, which is 0 or 1."""
    model = lw.Model()
    model.body("b", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 1))
    with pytest.raises(lw.ModelError, match="is not"):
        if np.ndim(given) > 0:
            model.body("c", mass=1.0, inertia=given)
        else:
            model.spring_damper("ground", "b", at=((0, 0, 0), (0, 0, 1)), stiffness=given)
    model.force("b", force=(lambda t: t > 1.0, 0, 0))
    assert lw.simulate(model, 0.1, 1e-2, progress=False).v[-1, 0, 0] == 0.0
