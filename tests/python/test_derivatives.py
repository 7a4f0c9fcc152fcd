"""Derivatives that are given are told from wrong ones, whatever their size, place and speed."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import functions
from linkwork.functions.derivatives import disagreement
from random_mechanisms import examples

Function = Callable[[float], float]


class Motion(NamedTuple):
    f: Function
    df: Function
    ddf: Function


RIGHT = {
    "t^3": Motion(lambda t: t**3, lambda t: 3 * t**2, lambda t: 6 * t),
    "t - sin t": Motion(lambda t: t - math.sin(t), lambda t: 1 - math.cos(t), math.sin),
    "sin^3(10 t)": Motion(
        lambda t: math.sin(10 * t) ** 3,
        lambda t: 30 * math.sin(10 * t) ** 2 * math.cos(10 * t),
        lambda t: 600 * math.sin(10 * t) * math.cos(10 * t) ** 2 - 300 * math.sin(10 * t) ** 3,
    ),
    "t^2.5, from 0 on": Motion(
        lambda t: math.sqrt(t) ** 5, lambda t: 2.5 * math.sqrt(t) ** 3, lambda t: 3.75 * math.sqrt(t)
    ),
    "1e-9 t^4": Motion(lambda t: 1e-9 * t**4, lambda t: 4e-9 * t**3, lambda t: 12e-9 * t**2),
    "sin(1e4 t)": Motion(
        lambda t: math.sin(1e4 * t), lambda t: 1e4 * math.cos(1e4 * t), lambda t: -1e8 * math.sin(1e4 * t)
    ),
    "1e6 + 1e-3 sin t": Motion(
        lambda t: 1e6 + 1e-3 * math.sin(t), lambda t: 1e-3 * math.cos(t), lambda t: -1e-3 * math.sin(t)
    ),
    "ramp with a corner": Motion(lambda t: max(t - 0.4, 0.0), lambda t: float(t > 0.4), lambda t: 0.0),
    "cubic from 0.2 on": Motion(
        lambda t: max(t - 0.2, 0) ** 3, lambda t: 3 * max(t - 0.2, 0) ** 2, lambda t: 6 * max(t - 0.2, 0)
    ),
    "rest": Motion(lambda t: 2.0, lambda t: 0.0, lambda t: 0.0),
}


def sliding() -> lw.Model:
    model = lw.Model()
    model.body("b", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.translational("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), name="slide")
    return model


@pytest.mark.parametrize("name", RIGHT)
def test_right_derivatives_are_taken(name: str) -> None:
    sliding().drive("slide", position=tuple(RIGHT[name]))


@pytest.mark.parametrize("t_end", [7.0, 30.0, 1e4])
@pytest.mark.parametrize("name", RIGHT)
def test_right_derivatives_are_taken_all_over_a_run(name: str, t_end: float) -> None:
    functions.as_time_function(tuple(RIGHT[name]), name).check(t_end)


#: What goes wrong: of a derivative g.
MISTAKES: dict[str, Callable[[Function], Function]] = {
    "sign": lambda g: lambda t: -g(t),
    "twice": lambda g: lambda t: 2 * g(t),
    "one percent": lambda g: lambda t: 1.01 * g(t),
    "none": lambda g: lambda t: 0.0,
}


@pytest.mark.parametrize("mistake", MISTAKES)
@pytest.mark.parametrize("name", [name for name in RIGHT if name not in ("rest", "ramp with a corner")])
def test_wrong_derivatives_are_refused(name: str, mistake: str) -> None:
    f, df, ddf = RIGHT[name]
    with pytest.raises(lw.ModelError, match=r"position: the first derivative adds up to .* from t = "):
        sliding().drive("slide", position=(f, MISTAKES[mistake](df), ddf))
    with pytest.raises(lw.ModelError, match=r"position: the second derivative adds up to"):
        sliding().drive("slide", position=(f, df, MISTAKES[mistake](ddf)))


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("wrap", ["none", "breaks"])
def test_derivatives_that_are_wrong_later_are_refused_before_a_run(order: int, wrap: str) -> None:
    """From 6 s on, beyond what is looked at when a driver is made."""
    f = [lambda t: 0.3 - 0.3 * math.cos(t), lambda t: 0.3 * math.sin(t), lambda t: 0.3 * math.cos(t)]
    right = f[order]
    f[order] = lambda t: right(t) * (1.0 if t < 6.0 else 0.5)
    model = sliding()
    model.drive("slide", position=functions.with_breaks(tuple(f), 6.0) if wrap == "breaks" else tuple(f))
    with pytest.raises(lw.ModelError, match="derivative adds up to"):
        lw.kinematics(model, np.linspace(0, 10, 201))
    with pytest.raises(lw.ModelError, match="derivative adds up to"):
        lw.simulate(model, 10.0, 0.01)
    lw.simulate(model, 5.0, 0.01)


@pytest.mark.parametrize("wrong", [1.0, 1.01, -1.0])
@pytest.mark.parametrize("k", [5.0, 20.0, 50.0, 100.0])
@pytest.mark.parametrize("center", [0.45, 2.3, 4.9])
def test_what_rounding_leaves_of_a_derivative_is_no_disagreement(
    k: float, center: float, wrong: float
) -> None:
    """k (1 - tanh²) is a few 1e-16 of k, or nothing, where it should be 1e-20 of it."""

    def step(t: float) -> float:
        return math.tanh(k * (t - center))

    def rate(t: float) -> float:
        return k * (1 - step(t) ** 2)

    def change(t: float) -> float:
        return -2 * k * step(t) * rate(t)

    assert (disagreement(step, lambda t: wrong * rate(t)) is None) == (wrong == 1.0)
    assert (disagreement(rate, lambda t: wrong * change(t)) is None) == (wrong == 1.0)


@st.composite
def smooth(draw: Callable[..., float]) -> tuple[Function, Function]:
    """A sum of a polynomial and waves of any size and speed, with its derivative."""
    size = 10.0 ** draw(st.integers(-6, 6))
    c = [size * draw(st.floats(-1, 1)) for _ in range(4)]
    waves = [
        (size * draw(st.floats(0.1, 1)), 10.0 ** draw(st.floats(-1, 3)), draw(st.floats(-3, 3)))
        for _ in range(draw(st.integers(1, 3)))
    ]

    def f(t: float) -> float:
        return float(np.polyval(c, t)) + sum(a * math.sin(w * t + p) for a, w, p in waves)

    def df(t: float) -> float:
        return float(np.polyval(np.polyder(c), t)) + sum(a * w * math.cos(w * t + p) for a, w, p in waves)

    return f, df


@pytest.mark.parametrize("period", [1.0, 0.5, 0.25, 1 / 16, 2 * math.pi / 100, 1.006, 0.618, 2.0])
@pytest.mark.parametrize("mistake", MISTAKES)
def test_wrong_derivatives_of_waves_are_refused(mistake: str, period: float) -> None:
    """Over a period a wave changes by nothing, and so does whatever wrong wave."""
    w = 2 * math.pi / period
    derivative = MISTAKES[mistake](lambda t: w * math.cos(w * t))
    assert disagreement(lambda t: math.sin(w * t), derivative) is not None
    assert disagreement(lambda t: math.sin(w * t), lambda t: w * math.cos(w * t)) is None


@examples(60)
@given(motion=smooth())
def test_any_smooth_function_goes_with_its_derivative_and_no_other(motion: tuple[Function, Function]) -> None:
    f, df = motion
    assert disagreement(f, df) is None
    size = max(abs(df(t)) for t in np.linspace(0, 1, 101))
    for wrong in (lambda t: -df(t), lambda t: 1.02 * df(t), lambda t: df(t) + 0.1 * size):
        assert disagreement(f, wrong) is not None
