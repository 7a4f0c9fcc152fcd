"""Derivatives of results by parameters, against closed forms; the estimated errors are true bounds."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest


def thrown(speed: float, gravity: float, mass: float = 1.0) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -gravity))
    model.body("stone", mass=mass, inertia=(1, 1, 1), velocity=(speed**3, 0, 0))
    return model


OUTPUTS = {"x": lambda result: result.position[-1, 0, 0], "z": lambda result: result.position[:, 0, 2]}


def test_a_throw_has_the_derivatives_of_its_closed_form() -> None:
    """x = s^3 t, z = -g t^2 / 2; nothing depends on the mass."""
    found = lw.sensitivity(
        thrown, {"speed": 2.0, "gravity": 9.81, "mass": 3.0}, OUTPUTS, t_end=1.5, step=0.01, steps=0.02
    )
    exact = {("x", "speed"): 3 * 2.0**2 * 1.5, ("x", "gravity"): 0.0, ("x", "mass"): 0.0}
    for (output, parameter), value in exact.items():
        error = abs(found.derivatives[output][parameter] - value)
        assert error <= found.errors[output][parameter] + 1e-11
    fall = -(np.linspace(0, 1.5, 151) ** 2) / 2
    assert np.abs(found.derivatives["z"]["gravity"] - fall).max() < 1e-10
    assert found.relative("x", "speed") == pytest.approx(3.0, abs=1e-10)
    assert found.runs == 13 + 6  # two for each parameter once more, finer


def pendulum(length: float) -> lw.Model:
    model = lw.Model()
    bob = model.body("bob", mass=1.0, inertia=(1e-3, 1e-3, 1e-3), position=(length, 0, 0))
    model.revolute(model.ground, bob, at=(0, 0, 0), axis=(0, 1, 0))
    return model


def test_the_estimated_error_bounds_the_true_one_and_falls_with_the_step() -> None:
    """Of a frequency: omega^2 = g l / (l^2 + 1e-3) by linearization instead of a run."""

    def vibration(model: lw.Model) -> lw.Linearization:
        return lw.linearize(lw.equilibrium(model).model)

    def derivative(length: float) -> float:
        J = length**2 + 1e-3
        squared = 9.81 * length / J
        return 9.81 * (J - 2 * length**2) / J**2 / (2 * np.sqrt(squared))

    outputs = {"omega": lambda found: found.frequencies[0]}
    estimates = []
    for step in (0.1, 0.05):
        found = lw.sensitivity(pendulum, {"length": 0.8}, outputs, run=vibration, steps=step)
        true = abs(found.derivatives["omega"]["length"] - derivative(0.8))
        assert true < found.errors["omega"]["length"]
        estimates.append(found.errors["omega"]["length"])
    assert estimates[0] / estimates[1] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize(("arguments", "message"), [
    ({"parameters": {}}, "parameters are missing"),
    ({"outputs": {}}, "outputs are missing"),
    ({"parameters": ["speed"]}, "parameters are missing"),
    ({"parameters": {"speed": "fast"}}, "parameter 'speed' 'fast' is not a finite number"),
    ({"parameters": {"speed": [1.0, 2.0]}}, "is not a finite number"),
    ({"outputs": {"x": 3}}, "output 'x' is 3, not a function of the Result"),
    ({"steps": -1.0}, "steps must be positive"),
    ({"steps": 1e-17}, "more than the rounding of the parameter"),
    ({"steps": {}}, "the step of 'speed' is missing"),
    ({"steps": {"speed": 1.0, "sped": 1.0}}, "no parameter 'sped'; the nearest is 'speed'"),
    ({"run": lw.equilibrium, "parameters": {"speed": 1.0, "gravity": 1.0}},
     "t_end, step: options of simulate, which `run` replaces"),
    ({"build": 3}, "build is 3, not a function that makes a Model"),
])  # fmt: skip
def test_what_cannot_be_varied_is_refused(arguments: dict[str, object], message: str) -> None:
    given = {"build": thrown, "parameters": {"speed": 1.0}, "outputs": OUTPUTS, **arguments}
    with pytest.raises(lw.OptionError, match=message):
        lw.sensitivity(**given, t_end=0.1, step=0.01)  # type: ignore[arg-type]


def test_an_output_that_is_not_finite_is_named() -> None:
    with pytest.raises(lw.ModelError, match="output 'broken' is not finite with speed = 1"):
        lw.sensitivity(
            lambda speed: thrown(speed, 1.0),
            {"speed": 1.0},
            {"broken": lambda _: np.nan},
            t_end=0.1,
            step=0.01,
        )


@pytest.mark.parametrize("output", ("far", [[1.0], [1.0, 2.0]], None))
def test_an_output_that_is_no_number_is_named(output: object) -> None:
    with pytest.raises(lw.ModelError, match=r"output 'x' is .*not (numbers|finite)"):
        lw.sensitivity(thrown, {"speed": 1.0, "gravity": 1.0}, {"x": lambda _: output}, t_end=0.1, step=0.01)


def test_a_parameter_that_build_does_not_take_is_named() -> None:
    with pytest.raises(lw.OptionError, match="parameters lenght: the function .* does not take them"):
        lw.sensitivity(lambda length: lw.Model(), {"lenght": 1.0}, {"z": lambda result: 1.0}, t_end=0.1)


def test_a_build_that_makes_no_model_is_told_with_its_parameter() -> None:
    with pytest.raises(lw.ModelError, match="a linkwork.Model is wanted, not None") as caught:
        lw.sensitivity(lambda mass: None, {"mass": 2.0}, OUTPUTS, t_end=0.1, step=0.01)
    assert "mass = 2.0" in caught.value.__notes__[0]


def test_the_parameter_of_a_run_that_fails_is_told() -> None:
    with pytest.raises(lw.ModelError) as caught:
        lw.sensitivity(lambda mass: thrown(1.0, 1.0, mass), {"mass": 1e-4}, OUTPUTS, steps={"mass": 1.0},
                       t_end=0.1, step=0.01)  # fmt: skip
    assert "mass = -0.9999" in caught.value.__notes__[0]


@pytest.mark.parametrize(
    "run", [{"step": 0.05}, {"step": 0.1}, {"rtol": 1e-3}, {"step": 0.02, "integrator": "heun"}], ids=str
)
@pytest.mark.filterwarnings("ignore:.*(tolerances are too large|step is too long)")
def test_the_error_counts_what_the_runs_are_off_by(run: dict[str, object]) -> None:
    """A rod on a hinge with a torsion spring, against a run that is exact."""

    def build(stiffness: float) -> lw.Model:
        model = lw.Model()
        rod = model.body("rod", mass=1.0, inertia=(0.1,) * 3, position=(1, 0, 0))
        model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
        model.rotational_spring_damper("ground", rod, axis=(0, 1, 0), stiffness=stiffness)
        return model

    def found(**options: object) -> lw.Sensitivity:
        angle = {"angle": lambda result: result.coordinate("pin").value[-1]}
        return lw.sensitivity(build, {"stiffness": 5.0}, angle, t_end=5.0, **options)

    exact = found(rtol=1e-12, integrator="dop853")
    coarse = found(**run)
    off = abs(coarse.derivatives["angle"]["stiffness"] - exact.derivatives["angle"]["stiffness"])
    assert off > 1e-6
    assert off <= coarse.errors["angle"]["stiffness"]


def test_at_a_kink_the_error_is_half_of_the_jump() -> None:
    """What stands beyond the end of the way of a slider, which it just reaches."""

    def build(speed: float) -> lw.Model:
        model = lw.Model(gravity=(0, 0, 0))
        model.body("slider", mass=1.0, inertia=(0.1,) * 3, velocity=(speed, 0, 0))
        return model

    beyond = {"beyond": lambda result: max(0.0, result.position[-1, 0, 0] - 1.0)}
    with pytest.warns(lw.LinkworkWarning, match="d beyond / d speed: differences with steps .* do not agree"):
        found = lw.sensitivity(build, {"speed": 1.0}, beyond, t_end=1.0, step=1e-2)
    assert found.derivatives["beyond"]["speed"] == pytest.approx(0.5, abs=1e-9)
    assert found.errors["beyond"]["speed"] == pytest.approx(0.5, rel=1e-6)


def bounce(stiffness: float) -> lw.Model:
    """A ball that falls by 1 m onto a spring and rises again."""
    model = lw.Model()
    ball = model.body("ball", mass=1.0, inertia=(0.004,) * 3, position=(0, 0, 1.1))
    model.translational("ground", ball, at=(0, 0, 0), axis=(0, 0, 1))
    model.sphere_plane_contact(
        "ground", ball, at=((0, 0, 0), (0, 0, 1.1)), normal=(0, 0, 1), radius=0.1, stiffness=stiffness,
        exponent=1.0,
    )  # fmt: skip
    return model


def height(stiffness: float, t: float, G: float = 9.81) -> float:
    """Of a fall, about half an oscillation, and a rise."""
    landing, omega = np.sqrt(2 / G), np.sqrt(stiffness)
    speed, sag = G * landing, G / stiffness
    contact = (np.pi + 2 * np.arctan(sag * omega / speed)) / omega  # its end: as high, and as fast upward
    left = t - landing - contact
    return speed * left - G * left**2 / 2


@pytest.mark.parametrize(
    "run", [{"step": 1e-3}, {"step": 5e-4}, {"step": 1e-4}, {"rtol": 1e-3}, {"rtol": 1e-6}], ids=str
)
@pytest.mark.parametrize("own", [False, True])
@pytest.mark.filterwarnings("ignore:.*tolerances are too large")
def test_the_error_counts_how_much_that_of_the_runs_changes_with_the_parameter(
    run: dict[str, float], own: bool
) -> None:
    """A small change of something large, of which the runs are off by more than it changes. With `own` no
    finer run is known."""
    rise = {"height": lambda result: result.position[-1, 0, 2] - 0.1}
    ways = (
        {"run": lambda model: lw.simulate(model, 0.8, progress=False, **run)}
        if own
        else {"t_end": 0.8, **run}
    )
    found = lw.sensitivity(bounce, {"stiffness": 1e4}, rise, **ways)
    true = (height(1.0001e4, 0.8) - height(0.9999e4, 0.8)) / 2
    off, error = abs(found.derivatives["height"]["stiffness"] - true), found.errors["height"]["stiffness"]
    assert off <= error
    if run == {"rtol": 1e-6} and not own:
        assert error < 1e-5 * true


def dropped(speed: float) -> lw.Model:
    """Thrown up from 1 m above the floor, on a rail, with g = 10."""
    model = lw.Model(gravity=(0, 0, -10.0))
    model.body("stone", mass=1.0, inertia=(0.1,) * 3, velocity=(0, 0, speed))
    model.translational("ground", "stone", at=(0, 0, 0), axis=(0, 0, 1))
    return model


FLOOR = lw.Event(lambda t, state: state.body("stone").position[2] + 1.0, terminal=True, name="floor")


@pytest.mark.parametrize(
    "of", [lambda it: it.events[0].t, lambda it: it.events[0].t if it.events else 0.0, lambda it: it.t[-1]]
)
@pytest.mark.parametrize("to_file", [False, True])
def test_events_have_derivatives_and_errors_as_frames_have(
    of: Callable[[lw.Result], float], to_file: bool, tmp_path: Path
) -> None:
    """t = (w + sqrt(w^2 + 2 g)) / g, with which the runs differ from finer ones, too."""
    options = {"output": tmp_path / "run.h5", "overwrite": True} if to_file else {}
    found = lw.sensitivity(
        dropped, {"speed": 3.0}, {"t": of}, t_end=5.0, rtol=1e-8, events=FLOOR, **options
    )  # fmt: skip
    off = abs(found.derivatives["t"]["speed"] - (1 + 3 / np.sqrt(29)) / 10)
    assert off <= found.errors["t"]["speed"] < 1e-6


def test_the_error_of_a_time_of_an_event_counts_what_the_runs_are_off_by() -> None:
    """A pendulum through its lowest place, with loose tolerances."""

    def build(length: float) -> lw.Model:
        model = lw.Model()
        bob = model.body("bob", mass=1.0, inertia=(0.2, 0.2, 0.2), position=(length, 0, 0))
        model.revolute("ground", bob, at=(0, 0, 0), axis=(0, 1, 0))
        return model

    lowest = lw.Event(lambda t, state: state.body("bob").position[0], terminal=True)

    def found(rtol: float, of: Callable[[lw.Result], float]) -> lw.Sensitivity:
        outputs = {"t": of}
        return lw.sensitivity(build, {"length": 1.0}, outputs, t_end=5.0, rtol=rtol, events=lowest)

    exact = found(1e-12, lambda it: it.events[0].t).derivatives["t"]["length"]
    for of in (lambda it: it.events[0].t, lambda it: it.t[-1]):
        coarse = found(1e-3, of)
        off = abs(coarse.derivatives["t"]["length"] - exact)
        assert 1e-7 < off <= coarse.errors["t"]["length"] < 0.1


def test_an_event_that_the_finer_run_has_not_leaves_the_error_of_the_verdict() -> None:
    """So it may be where a function looks at another event in each run."""
    seen = []

    def only_every_other(result: lw.Result) -> float:
        seen.append(result)
        if len(seen) > 1 and seen[-1].manifest["options"]["rtol"] < seen[0].manifest["options"]["rtol"]:
            raise IndexError
        return float(result.t[-1])

    found = lw.sensitivity(
        dropped, {"speed": 3.0}, {"t": only_every_other}, t_end=5.0, rtol=1e-8, events=FLOOR
    )  # fmt: skip
    off = abs(found.derivatives["t"]["speed"] - (1 + 3 / np.sqrt(29)) / 10)
    assert off <= found.errors["t"]["speed"]
