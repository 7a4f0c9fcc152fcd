"""The steps of differences: derivatives do not depend on units, and their errors are bounds."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.analyses.parameter_sizes import size_of_parameter, size_of_unit

SIZES = (1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1.0, 1e3, 1e6)


def pendulum(L: float, *, z: float = 0.0, angle: float = 0.0, gravity: float = 9.81) -> lw.Model:
    """Released at (L, 0, z), turned downward by an angle."""
    c, s = np.cos(angle), np.sin(angle)
    model = lw.Model(gravity=(0, 0, -gravity))
    position = (L * c + z * s, 0, z * c - L * s)
    model.body("bob", mass=1e-9, inertia=np.ones(3) * 1e-9 * L**2, position=position)
    model.revolute("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


OUTPUTS: dict[str, Callable[[lw.Result], Any]] = {
    "x": lambda result: result.position[-1, 0, 0],
    "angle": lambda result: result.coordinate("pin").value[-1],
}


def of_pendulum(L: float, parameter: str, at: float = 0.0, **options: Any) -> lw.Sensitivity:
    T = 0.5 * np.sqrt(L)

    def build(p: float) -> lw.Model:
        return pendulum(L, **{parameter: p})

    return lw.sensitivity(build, {"p": at}, OUTPUTS, t_end=T, step=T / 200, **options)


@pytest.mark.parametrize("L", SIZES)
@pytest.mark.parametrize("parameter", ["z", "angle"])
def test_a_zero_coordinate_or_angle_of_a_mechanism_of_any_size(L: float, parameter: str) -> None:
    """x / L and the angle depend on z / L, or on an angle, alone, in times of sqrt(L)."""
    unit = {"z": L, "angle": 1.0}[parameter]
    one, found = of_pendulum(1.0, parameter), of_pendulum(L, parameter)
    for output, size in (("x", L), ("angle", 1.0)):
        same = pytest.approx(one.derivatives[output]["p"], rel=1e-8)
        assert found.derivatives[output]["p"] * unit / size == same
        error = found.errors[output]["p"] * unit / size
        assert error == pytest.approx(one.errors[output]["p"], rel=0.01)
        assert error < 1e-4
    assert found.runs == 7  # as where the parameter is not zero


def test_a_coordinate_that_is_zero_but_for_rounding_is_zero() -> None:
    zero, rounded = of_pendulum(1e-3, "z"), of_pendulum(1e-3, "z", 6e-20)
    assert rounded.derivatives["x"]["p"] == pytest.approx(zero.derivatives["x"]["p"], rel=1e-9)
    assert rounded.steps == pytest.approx(zero.steps)


def test_gravity_that_is_none_has_steps_as_on_earth() -> None:
    found = lw.sensitivity(
        lambda gravity: pendulum(1e3, gravity=gravity),
        {"gravity": 0.0},
        {"z": lambda result: result.position[-1, 0, 2]},
        t_end=0.5,
        step=0.01,
    )
    assert found.derivatives["z"]["gravity"] == pytest.approx(-(0.5**2) / 4, rel=1e-6)  # m L^2 / 2 m L^2
    assert found.steps["gravity"] == pytest.approx(9.81e-3)


@pytest.mark.parametrize("L", [1e-6, 1.0, 1e6])
def test_the_size_of_a_parameter_is_that_by_which_it_changes_the_whole(L: float) -> None:
    def size(build: Callable[[float], lw.Model]) -> float | None:
        return size_of_parameter(lambda p: build(p).compiled(), 0.0)

    def heavier(mass: float) -> lw.Model:
        model = lw.Model()
        model.body("bob", mass=1e-9 + mass, inertia=np.ones(3) * L**2, position=(L, 0, 0))
        return model

    assert size(lambda z: pendulum(L, z=z)) == pytest.approx(L, rel=1e-6)
    assert size(lambda angle: pendulum(L, angle=angle)) == pytest.approx(1.0, rel=0.02)
    assert size(heavier) == pytest.approx(1e-9, rel=1e-6)
    assert size(lambda nothing: pendulum(L)) is None


@pytest.mark.parametrize("what", ["stiffness", "damping"])
@pytest.mark.parametrize("L", [1e-6, 1e-3, 1e3])
def test_a_spring_or_damper_of_none_has_steps_by_the_weight(what: str, L: float) -> None:
    """The angle depends on stiffness / m g L and damping / (m L sqrt(g L)) alone, in times of sqrt(L)."""

    def found(L: float, mass: float) -> tuple[float, float]:
        def build(p: float) -> lw.Model:
            model = lw.Model()
            model.body("bob", mass=mass, inertia=np.ones(3) * 0.1 * mass * L**2, position=(L, 0, 0))
            model.revolute("ground", "bob", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
            model.rotational_spring_damper("ground", "bob", axis=(0, 1, 0), **{what: p})
            return model

        T = 0.8 * np.sqrt(L)
        angle = {"angle": OUTPUTS["angle"]}
        it = lw.sensitivity(build, {"p": 0.0}, angle, t_end=T, step=T / 200)
        unit = mass * 9.81 * L * (np.sqrt(L / 9.81) if what == "damping" else 1.0)
        assert it.steps["p"] == pytest.approx(1e-3 * unit)
        return float(it.derivatives["angle"]["p"]) * unit, float(it.errors["angle"]["p"]) * unit

    (one, _), (other, error) = found(1.0, 1.0), found(L, 1e-9 if L < 1.0 else 1e6)
    assert other == pytest.approx(one, rel=1e-8)
    assert error < 1e-4


def test_sizes_of_units() -> None:
    units = {"kg": 2.0, "m": 3.0, "s": 5.0, "rad": 1.0}
    known = {"m": 3.0, "N/m": 2 / 25, "N m s/rad": 18 / 5, "N s^2/m^2": 2 / 3, "kg m^2": 18.0, "": 1.0}
    assert {unit: size_of_unit(unit, units) for unit in known} == pytest.approx(known)
    assert size_of_unit("N/m^exponent", units) == size_of_unit("rad or m", units) == 0.0


def test_steps_that_are_given_and_too_large_are_told() -> None:
    with pytest.warns(lw.LinkworkWarning, match=r"d x and angle / d p: .* give that by steps=\{'p': ...\}"):
        found = of_pendulum(1e-6, "z", steps={"p": 1e-3})
    assert found.steps == {"p": 1e-3}


def of_function(f: Callable[[float], float], at: float, size: float | None) -> tuple[float, float, bool, int]:
    """Derivative, error, whether there is a warning, runs, of f(p); a model may tell the size of p."""
    seen = [at]

    def build(p: float) -> lw.Model:
        seen[0] = p
        return pendulum(size, z=p) if size else pendulum(1.0)

    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = lw.sensitivity(
            build, {"p": at}, {"y": lambda _: f(seen[0])}, run=lambda model: model.compiled()
        )
    return float(found.derivatives["y"]["p"]), float(found.errors["y"]["p"]), bool(told), found.runs


SMOOTH: dict[str, tuple[Callable[[float], float], Callable[[float], float]]] = {
    "sin": (np.sin, np.cos),
    "tanh": (np.tanh, lambda x: 1 / np.cosh(x) ** 2),
    "arctan": (np.arctan, lambda x: 1 / (1 + x**2)),
    "root": (lambda x: np.sqrt(1 + x**2), lambda x: x / np.sqrt(1 + x**2)),
    "resonance": (lambda x: 1 / (1 + x**2), lambda x: -2 * x / (1 + x**2) ** 2),
    "bell": (lambda x: np.exp(-(x**2)), lambda x: -2 * x * np.exp(-(x**2))),
    "cubic": (lambda x: x + x**3, lambda x: 1 + 3 * x**2),
    "constant": (lambda x: 1.0, lambda x: 0.0),
}


@pytest.mark.parametrize("name", SMOOTH)
@pytest.mark.parametrize("known", [True, False])
def test_the_error_is_a_bound_whatever_the_size_of_a_parameter(name: str, known: bool) -> None:
    f, slope = SMOOTH[name]
    random, runs = np.random.default_rng(1), []
    for _ in range(40):
        size, amplitude = 10.0 ** random.uniform(-6, 6), 10.0 ** random.uniform(-6, 6)
        x = random.choice([0.0, random.normal(), 1e-3 * random.normal()])
        tilt, offset = random.choice([0.0, 1.0]) * random.normal(), random.choice([0.0, 1.0, 100.0])

        def output(p: float, of: Any = (size, amplitude, tilt, offset)) -> float:
            size, amplitude, tilt, offset = of
            return float(amplitude * (f(p / size) + tilt * p / size + offset))

        derivative, error, told, count = of_function(output, x * size, size if known else None)
        true = amplitude / size * (slope(x) + tilt)
        assert abs(derivative - true) <= error or told, (size, x, tilt, offset, derivative, true, error)
        runs.append(count)
    assert np.median(runs) == 5


@pytest.mark.parametrize("beside", [0.0, 0.1, 0.2, 0.25, 1 / 3, 0.4, 3 / 7, 0.5, 0.7, 0.9, 1.1])
def test_the_error_is_a_bound_wherever_a_kink_is(beside: float) -> None:
    """At a part of the step beside the parameter; the derivatives are 1 and 2 on its sides."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.LinkworkWarning)
        found = lw.sensitivity(
            lambda p: pendulum(p), {"p": 1.0},
            {"y": lambda core: core.q0[0] + max(0.0, core.q0[0] - 1.0 - 1e-3 * beside)},
            run=lambda model: model.compiled(), steps={"p": 1e-3},
        )  # fmt: skip
    assert abs(found.derivatives["y"]["p"] - (1.5 if beside == 0.0 else 1.0)) <= found.errors["y"]["p"]
    derivative, error, told, _ = of_function(lambda p: p + max(0.0, p - 1.0 - 1e-3 * beside), 1.0, 1.0)
    assert abs(derivative - (1.5 if beside == 0.0 else 1.0)) <= error
    assert told == (beside == 0.0)  # smaller steps do not reach the others


@pytest.mark.parametrize("between", [0.0, 0.01, 0.2, 0.5])
def test_the_highest_of_the_frames_of_a_throw(between: float) -> None:
    """w t_k - g t_k^2 / 2 of the frame nearest to w / g, by w: with a kink in the middle of two frames."""
    step, frames = 0.01, 40
    speed = 10.0 * step * (frames + between)

    def build(speed: float) -> lw.Model:
        model = lw.Model(gravity=(0, 0, -10.0))
        model.body("stone", mass=1.0, inertia=(1, 1, 1), velocity=(0, 0, speed))
        return model

    highest = {"highest": lambda result: result.position[:, 0, 2].max()}
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = lw.sensitivity(build, {"speed": speed}, highest, t_end=1.0, step=step)
    off = abs(found.derivatives["highest"]["speed"] - step * (frames + (between == 0.5) / 2))
    assert off <= found.errors["highest"]["speed"] + 1e-12
    assert bool(told) == (between == 0.5)
