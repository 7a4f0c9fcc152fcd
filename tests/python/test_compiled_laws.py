"""Compiled forces whose data change in a run: by an event, as a sampled effort, or by themselves."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest

NUMBERS = ctypes.POINTER(ctypes.c_double)
COMPILED = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_int64, *[NUMBERS] * 3, NUMBERS)


@COMPILED
def holding(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
    g[4] += data[0]


@COMPILED
def latching(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
    if v[4] > 2.0:
        data[0] = 1.0
    g[4] -= 4.0 * data[0]


@COMPILED
def with_workspace(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
    data[0] = 3.0 * v[4]
    data[1] += 1.0
    g[4] -= data[0]


def bar(function: Any, data: Any, mass: float = 1.0) -> lw.Model:
    model = lw.Model()
    body = model.body("bar", mass=mass, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    if function is None:
        model.user_force(lambda t, q, v: [0, 0, 0, 0, data[0], 0], "bar", name="law")
    else:
        model.compiled_force(function, data=data, name="law")
    return model


def clock(data: Any) -> lw.Event:
    def sample(t: float, state: Any) -> None:
        data[0] = -2.0 - state.body("bar").omega[1]

    return lw.Event(lambda t, state: np.sin(np.pi * t / 0.05 + 0.1), "clock", change=sample)


HOW: dict[str, Any] = {"rtol": 1e-7, "step": 0.02, "progress": False}


def sampled(function: Any, mass: float = 1.0) -> lw.Result:
    data = np.zeros(1)
    return lw.simulate(bar(function, data, mass), 0.3, events=clock(data), **HOW)


def angle(result: lw.Result) -> float:
    return float(result.coordinate("hinge").value[-1])


@pytest.mark.parametrize("make", [np.zeros, lambda n: (ctypes.c_double * n)()])
def test_an_effort_that_an_event_samples_into_data_is_held_as_by_a_law_of_python(
    make: Callable[[int], Any],
) -> None:
    data = make(1)
    model, events = bar(holding, data), clock(data)
    first = lw.simulate(model, 0.3, events=events, **HOW)
    expected = sampled(None)
    assert first.verdict is not None and expected.verdict is not None
    assert angle(first) == pytest.approx(angle(expected), abs=1e-9)
    assert first.verdict.level == expected.verdict.level and not first.verdict.memory
    with pytest.warns(lw.LinkworkWarning, match="'law': reads what events have changed in a run before"):
        second = lw.simulate(model, 0.3, events=events, **HOW)
    assert abs(angle(second) - angle(first)) > 1e-2


def test_members_and_cases_begin_with_the_data_that_there_was_before_the_first() -> None:
    data, masses = np.zeros(1), [1.0, 1.5]
    events, alone = clock(data), [angle(sampled(holding, mass)) for mass in masses]

    def build(mass: float) -> lw.Model:
        return bar(holding, data, mass)

    many = lw.simulate_many(build, {"mass": masses}, 0.3, events=events, **HOW)
    assert [angle(many.member(k)) for k in range(2)] == pytest.approx(alone, abs=1e-8)
    final = "coordinate('hinge').value.final"
    study = lw.sweep(build, {"mass": masses}, final, t_end=0.3, events=events, processes=1, **HOW)
    assert study.outputs[final] == pytest.approx(alone, abs=1e-8) and data[0] == 0.0


def test_a_compiled_force_that_latches_in_its_data_is_told() -> None:
    data = np.zeros(1)
    model = bar(latching, data)
    with pytest.warns(lw.LinkworkWarning, match="'law': remembers calls"):
        lw.simulate(model, 0.3, **HOW)
    assert data[0] == 1.0
    with pytest.warns(lw.LinkworkWarning, match="'law': remembers what it has kept in a run before"):
        lw.simulate(model, 0.3, on_inaccurate="pass", **HOW)


def test_a_workspace_in_data_is_no_memory() -> None:
    data = np.zeros(2)
    result = lw.simulate(bar(with_workspace, data), 0.3, **HOW)
    assert result.verdict is not None and result.verdict.steps and not result.verdict.memory
    calls, last = data[1], data[0]
    assert calls > 100 and last == pytest.approx(3.0 * result.recorded("v")[-1].ravel()[4], rel=1e-6)


def test_a_compiled_force_is_not_asked_about_bodies_that_are_not_there() -> None:
    """Of the same name in another model: of what a run before has left its calls are of one body."""

    @COMPILED
    def of_two(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
        asked.append(n)
        g[10] += data[0]

    asked: list[int] = []
    data = np.zeros(1)
    lw.simulate(bar(holding, data), 0.1, events=clock(data), **HOW)
    model = bar(of_two, np.zeros(1))
    model.body("other", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(2, 0, 0))
    lw.simulate(model, 0.1, **HOW)
    assert set(asked) == {2}
