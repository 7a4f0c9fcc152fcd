"""Laws that remember calls are told, whatever they remember with; those that only keep something are not."""

from __future__ import annotations

import collections
import contextlib
import ctypes
import datetime
import functools
import io
import itertools
import math
import os
import queue
import random
import re
import sqlite3
import threading
import time
import warnings
import weakref
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from remembering_laws import delayed


def quick(model: lw.Model, t_end: float, **how: Any) -> lw.Result:
    return lw.simulate(model, t_end, **{"progress": False, "on_inaccurate": "pass", **how})


def _held_by(law: Any, position: Any = (0.3, 0, 0)) -> lw.Model:
    model = lw.Model()
    bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=position)
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.joint_force("hinge", law, name="controller")
    return model


def _inserted() -> Any:
    line = [0.0] * 40
    return lambda t, angle, rate: line.insert(0, angle) or -3.0 * line.pop()


def _queued() -> Any:
    line: queue.Queue[float] = queue.Queue()
    for _ in range(40):
        line.put(0.0)
    return lambda t, angle, rate: line.put(angle) or -3.0 * line.get()


def _sent() -> Any:
    def filtered() -> Any:
        held = angle = 0.0
        while True:
            held += 0.03 * (angle - held)
            angle = yield -6.0 * held

    it = filtered()
    next(it)
    return lambda t, angle, rate: it.send(angle)


def _filled() -> Any:
    last = np.zeros(1)
    return lambda t, angle, rate: (-3.0 * float(last[0]), last.fill(angle))[0]


def _in_turn() -> Any:
    values = itertools.cycle([0.0, 1.0])
    return lambda t, angle, rate: next(values)


def _with_noise() -> Any:
    noise = np.random.default_rng(1)
    return lambda t, angle, rate: -3.0 * angle + noise.normal()


def _switched() -> Any:
    """Hysteresis; a run may end in the state in which it began."""
    on = [False]

    def law(t: float, angle: float, rate: float) -> float:
        on[0] = angle > 0.3 or (on[0] and angle >= -0.3)
        return -4.0 if on[0] else 4.0

    return law


class _Kept:
    """In methods of its own, and in its class."""

    last = 0.0

    def put(self, angle: float) -> None:
        setattr(type(self), "la" + "st", angle)

    def get(self) -> float:
        return self.last

    def __call__(self, t: float, angle: float, rate: float) -> float:
        last = self.get()
        self.put(angle)
        return -3.0 * last


def _among_globals(t: float, angle: float, rate: float) -> float:
    last = globals().get("_angle", 0.0)
    globals()["_angle"] = angle
    return -3.0 * last


@pytest.mark.parametrize(
    "law",
    [
        _inserted(), _queued(), _sent(), _filled(), _with_noise(), _switched(), _Kept(), _among_globals,
        _in_turn(),
        lambda t, angle, rate: random.random(),
        lambda t, angle, rate: time.perf_counter() % 0.1,
    ],
)  # fmt: skip
def test_whatever_a_law_remembers_with_is_told_with_two_values_for_the_same_arguments(law: Any) -> None:
    with pytest.warns(
        lw.LinkworkWarning, match=r"'controller': remembers calls \(at t = .*'controller' gave"
    ):
        result = lw.simulate(_held_by(law), t_end=0.5, step=1e-3, progress=False)
    assert result.verdict is not None and result.verdict.memory == ("controller",)


def test_a_law_that_reads_the_log_of_another_is_told() -> None:
    log = [0.0] * 60
    model = _held_by(lambda t, angle, rate: -0.6 * log[-50])
    model.user_force(lambda t, q, v: log.append(float(v[4])) or np.zeros(6), "bar", name="sensor")
    with pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"):
        lw.simulate(model, t_end=0.5, step=1e-3, progress=False)


def test_a_law_that_remembers_is_told_in_a_run_whose_events_change_something_else() -> None:
    held, broken = [0.0], [False]

    def law(t: float, angle: float, rate: float) -> float:
        broken[0] = broken[0] or angle < -0.03
        return 0.0 if broken[0] else -3.0

    clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t), "clock", change=lambda t, state: held.append(t))
    with pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"):
        lw.simulate(_held_by(law), t_end=0.5, rtol=1e-6, events=clock, progress=False)


def _logged(log: Any) -> Any:
    def law(t: float, angle: float, rate: float) -> float:
        log.append((t, -3.0 * angle))
        return float(log[-1][1])

    return law


def _counted(calls: Any) -> Any:
    def law(t: float, angle: float, rate: float) -> float:
        calls["calls"] += 1
        calls["largest"] = max(calls["largest"], abs(angle))
        calls[t] = angle
        return -3.0 * angle

    return law


class _Overwritten:
    __slots__ = ("count", "lock", "work")

    def __init__(self) -> None:
        self.work, self.lock, self.count = np.zeros(2), threading.Lock(), 0

    def __call__(self, t: float, angle: float, rate: float) -> float:
        with self.lock:
            self.count += 1
            self.work[:] = angle, rate
            return float(self.work @ [-3.0, -0.1])


@pytest.mark.parametrize(
    "law",
    [_logged([]), _logged(collections.deque(maxlen=10)), _counted(collections.Counter()), _Overwritten()],
)
def test_what_a_law_keeps_and_does_not_read_is_no_memory(law: Any) -> None:
    result = quick(_held_by(law), 0.1, step=1e-3)
    assert result.verdict is not None and result.verdict.steps and result.verdict.state is not None


def test_a_force_that_fills_the_same_array_again_and_again_has_no_memory() -> None:
    out = np.zeros(6)

    def drag(t: float, q: Floats, v: Floats) -> Floats:
        out[:3] = -3.0 * v[:3]
        return out

    model = _held_by(0.0)
    model.user_force(drag, "bar")
    result = quick(model, 0.1, step=1e-3)
    assert result.verdict is not None and result.verdict.steps


class _Brake:
    """Holds from when the angle was first beyond a limit; `start` is None until then."""

    def __init__(self) -> None:
        self.start: float | None = None

    def __call__(self, t: float, angle: float, rate: float) -> float:
        if self.start is None and angle > 0.01:
            self.start = t
        return 0.0 if self.start is None or t < self.start else -2.0 * min(1.0, (t - self.start) / 0.2)


def _sampled() -> Any:
    """By the number of the sample."""
    held: dict[int, float] = {}
    return lambda t, angle, rate: held.setdefault(int(t / 0.02), -3.0 * angle)


@pytest.mark.parametrize("make", [_Brake, _sampled, delayed])
@pytest.mark.parametrize("how", [{"step": 1e-3}, {"rtol": 1e-8}])
def test_what_is_remembered_by_time_is_told_too_and_what_it_leaves_for_the_next_run(
    make: Any, how: dict[str, float]
) -> None:
    """These return in the end what they returned in the run."""
    law = make()
    with pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"):
        lw.simulate(_held_by(law), t_end=0.5, progress=False, **how)
    for _ in range(2):
        with pytest.warns(
            lw.LinkworkWarning, match="'controller': remembers what it has kept in a run before"
        ):
            lw.simulate(_held_by(law), t_end=0.5, progress=False, **how)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        lw.simulate(_held_by(make()), t_end=0.5, progress=False, **how)
    assert not any("in a run before" in str(it.message) for it in told)


def test_a_run_does_not_go_on_in_silence_with_a_law_that_has_lost_what_it_remembered(tmp_path: Path) -> None:
    quick(_held_by(_Brake()), 0.3, step=1e-3, output=tmp_path / "first.h5")
    start = lw.Result.load(tmp_path / "first.h5").snapshot()
    with pytest.warns(lw.LinkworkWarning, match="start: 'controller': reads something else"):
        assert not quick(_held_by(_Brake()), 0.5, step=1e-3, start=start).manifest["resumed"]


def test_each_run_of_a_sensitivity_begins_with_what_a_law_remembered_before() -> None:
    def reached(law: Any) -> float:
        def build(stiffness: float) -> lw.Model:
            brake = law()
            return _held_by(lambda t, angle, rate: brake(t, angle, rate) - stiffness * angle)

        found = lw.sensitivity(
            build, {"stiffness": 1.0}, {"angle": lambda it: it.coordinate("hinge").value[-1]},
            t_end=0.5, step=1e-3, progress=False, on_inaccurate="pass",
        )  # fmt: skip
        return float(found.derivatives["angle"]["stiffness"])

    one = _Brake()
    assert reached(lambda: one) == reached(_Brake) and one.start is None


class _Tripping:
    """Samples by an event, and is tripped by a limit in its own calls."""

    def __init__(self) -> None:
        self.effort, self.tripped = 0.0, False

    def sample(self, t: float, state: Any) -> None:
        self.effort = -2.0 - state.body("bar").omega[1]

    def law(self, t: float, angle: float, rate: float) -> float:
        self.tripped = self.tripped or angle > 0.3
        return 0.0 if self.tripped else self.effort


def test_what_a_law_changes_beside_an_event_that_changes_the_same_object_is_its_memory() -> None:
    clock = functools.partial(lw.Event, lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock")
    tripping = _Tripping()
    how: Any = {"rtol": 1e-6, "step": 0.02, "progress": False}
    with pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"):
        lw.simulate(_held_by(tripping.law), 0.5, events=clock(change=tripping.sample), **how)
    assert tripping.tripped


def test_the_second_of_two_runs_is_told_of_an_effort_that_is_held_whatever_else_the_law_touches() -> None:
    pattern, lock, day = re.compile("x"), threading.Lock(), datetime.datetime(2020, 1, 1)
    log = [(0.0, 1.0)] * 210_000
    held = np.zeros(3)

    def law(t: float, angle: float, rate: float) -> float:
        with lock:
            log.append((t, angle))
            return float(held[1:][0]) if pattern and day and log else 0.0

    def sample(t: float, state: Any) -> None:
        held[1] = -2.0 - state.body("bar").omega[1]

    clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=sample)
    how: Any = {"rtol": 1e-6, "step": 0.02, "progress": False, "events": clock}
    lw.simulate(_held_by(law), 0.1, **how)
    with pytest.warns(
        lw.LinkworkWarning, match="'controller': reads what events have changed in a run before"
    ):
        lw.simulate(_held_by(law), 0.1, **how)


def _viewed() -> tuple[Any, Any]:
    states = np.zeros(9)
    view = states[3:4]
    return lambda: view[0], lambda effort: states.__setitem__(3, effort)


def _in_environment() -> tuple[Any, Any]:
    return (
        lambda: float(os.environ.get("LINKWORK_HELD", "0")),
        lambda effort: os.environ.__setitem__("LINKWORK_HELD", str(effort)),
    )


def _global() -> tuple[Any, Any]:
    return lambda: globals().get("_effort", 0.0), lambda effort: globals().__setitem__("_effort", effort)


def _in_c() -> tuple[Any, Any]:
    held = (ctypes.c_double * 1)()
    return lambda: held[0], lambda effort: held.__setitem__(0, effort)


def _in_series() -> tuple[Any, Any]:
    held = memoryview(np.zeros(1))
    return lambda: held[0], lambda effort: held.__setitem__(0, float(effort))


@pytest.mark.parametrize("place", [_viewed, _in_environment, _global, _in_c, _in_series])
def test_an_effort_that_an_event_changes_is_no_memory_of_the_law_wherever_it_is_held(place: Any) -> None:
    get, put = place()
    put(0.0)

    def sample(t: float, state: Any) -> None:
        put(-2.0 - state.body("bar").omega[1])

    clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=sample)
    result = quick(
        _held_by(lambda t, angle, rate: get()), 0.3, rtol=1e-6, step=0.02, events=clock, on_inaccurate="warn"
    )
    put(0.0)
    assert result.verdict is not None and result.verdict.memory == ()


class _Refusing:
    def __getattribute__(self, name: str) -> Any:
        raise RuntimeError(name)


def _resized() -> Any:
    log = np.zeros(1)

    def law(t: float, angle: float, rate: float) -> float:
        log.resize((len(log) + 1,), refcheck=False)
        log[-1] = angle
        return -3.0 * float(log[-1])

    return law


def _beside(it: Any) -> Any:
    return lambda t, angle, rate: (it, -3.0 * angle)[1]


@pytest.mark.parametrize(
    "law",
    [
        _resized(), _beside(random.SystemRandom()), _beside(_Refusing()), _beside(weakref.proxy(_Brake())),
        _beside(io.StringIO()), _beside(iter([1])), _beside(sqlite3.connect(":memory:")),
    ],
)  # fmt: skip
def test_what_cannot_be_looked_at_costs_no_run(law: Any) -> None:
    result = quick(_held_by(law), 0.1, step=1e-3, verify=True)
    assert result.verdict is not None and result.verdict.verified is not None


def test_memory_of_a_torque_beside_a_large_force_is_told_with_the_digits_that_differ() -> None:
    last = [0.0]

    def forces(t: float, q: Floats, v: Floats) -> Floats:
        last[0] += 1e-3 * (float(q[0, 5]) - last[0])
        return np.array([[0, 0, 0, 0, -0.3 - last[0], 0], [1e8, 0, 0, 0, 0, 0]])

    model = lw.Model(gravity=(0, 0, 0))
    bar = model.body("bar", mass=1.0, inertia=(0.03, 0.03, 0.03), omega=(0, 0.5, 0))
    rocket = model.body("rocket", mass=1e6, inertia=(1e6, 1e6, 1e6), position=(10, 0, 0))
    model.user_force(forces, [bar, rocket], name="forces")
    with pytest.warns(lw.LinkworkWarning, match="'forces': remembers calls") as told:
        lw.simulate(model, 0.3, step=1e-2, progress=False)
    then, later = re.findall(r"'forces' gave (\S+), and later (\S+) for", str(told[0].message))[0]
    assert then != later and -0.5 < float(then) < -0.2


def test_what_a_characteristic_was_asked_for_is_no_time() -> None:
    on = [False]

    def spring(angle: float) -> float:
        on[0] = angle > 0.01 or (on[0] and angle > -0.01)
        return 1.0 if on[0] else -1.0

    model = _held_by(0.0)
    model.nonlinear_rotational_spring_damper("ground", "bar", at=(0, 0, 0), axis=(0, 1, 0), spring=spring)
    with pytest.warns(lw.LinkworkWarning, match=r"remembers calls \(at -?[0-9.e-]+ '"):
        lw.simulate(model, 0.5, step=1e-3, progress=False)


def test_what_is_computed_once_and_kept_is_no_memory() -> None:
    known: dict[float, float] = {}
    table: list[Any] = []
    start = [0.0]

    @functools.lru_cache(maxsize=10)
    def gain(place: int) -> float:
        return 3.0 + place

    def law(t: float, angle: float, rate: float) -> float:
        if not table:
            table.append(np.linspace(0, 1, 10))
        if angle not in known:
            known[angle] = math.sin(angle)
        x = start[0]
        for _ in range(60):
            x -= (x + 0.1 * math.sin(x) - angle) / (1 + 0.1 * math.cos(x))
        start[0] = x
        return -gain(0) * known[angle] - x + float(table[0][0])

    result = quick(_held_by(law), 0.1, step=1e-3, on_inaccurate="warn")
    assert result.verdict is not None and result.verdict.steps and not result.verdict.memory


def test_kinematics_says_that_a_law_remembers() -> None:
    on = [False]

    def law(t: float, angle: float, rate: float) -> float:
        on[0] = angle > 0.1 or (on[0] and angle > -0.1)
        return 2.0 if on[0] else -2.0

    def driven(law: Any) -> lw.Model:
        model = _held_by(law)
        model.drive("hinge", position=lw.functions.harmonic(0.5, 1.0))
        return model

    with pytest.warns(lw.LinkworkWarning, match="kinematics: 'controller': remembers calls"):
        lw.inverse_dynamics(driven(law), np.linspace(0, 2, 41))
    with warnings.catch_warnings():
        warnings.simplefilter("error", lw.LinkworkWarning)
        lw.inverse_dynamics(driven(lambda t, angle, rate: -3.0 * angle), np.linspace(0, 0.5, 41))


def test_equilibrium_and_linearize_say_that_a_law_remembers() -> None:
    """-30 N m/rad by an angle that a filter in the law follows: of 16.57 rad/s 57.5 are found."""

    def filtered() -> Any:
        known = [0.0]

        def law(t: float, angle: float, rate: float) -> float:
            known[0] += 0.03 * (angle - known[0])
            return -30.0 * known[0] - 3.0 * rate

        return law

    def plain(t: float, angle: float, rate: float) -> float:
        return -30.0 * angle - 3.0 * rate

    down = (0, 0, -0.3)
    with (
        pytest.warns(lw.LinkworkWarning, match="linearize: 'controller': remembers calls"),
        contextlib.suppress(lw.ModelError),  # there is no derivative
    ):
        lw.linearize(_held_by(filtered(), down))
    with (
        pytest.warns(lw.LinkworkWarning, match="equilibrium: 'controller': remembers calls"),
        contextlib.suppress(lw.NotConvergedError),
    ):
        lw.equilibrium(_held_by(filtered()))
    with warnings.catch_warnings():
        warnings.simplefilter("error", lw.LinkworkWarning)
        found = lw.linearize(lw.equilibrium(_held_by(plain, down)).model)
    assert found.frequencies[0] == pytest.approx(np.sqrt((30.0 + 0.3 * 9.80665) / 0.12), rel=1e-4)


def test_a_sweep_gives_back_what_is_held_beside_a_lock_and_says_nothing() -> None:
    lock, held = threading.Lock(), [0.0]

    def law(t: float, angle: float, rate: float) -> float:
        with lock:
            return held[0]

    def sample(t: float, state: Any) -> None:
        held[0] = -2.0 - state.body("bar").omega[1]

    clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=sample)
    how: Any = {"rtol": 1e-6, "step": 0.02, "events": clock, "processes": 1, "progress": False}
    study = lw.sweep(lambda gain: _held_by(law), {"gain": [1.0, 2.0]}, "final", t_end=0.2, **how)
    found = study.outputs["final.q"]
    assert np.array_equal(found[0], found[1]) and held == [0.0] and not study.remarks


_TABLE: Floats | None = None


def _looked_up(t: float, angle: float, rate: float) -> float:
    global _TABLE
    if _TABLE is None:
        _TABLE = np.linspace(-3.0, 3.0, 7)
    return float(np.interp(-angle, _TABLE, 3.0 * _TABLE))


def test_a_global_variable_that_was_none_stays_what_the_run_made_it() -> None:
    """A table that is made at the first call is no memory; in ensembles each member finds the variable."""
    globals()["_TABLE"] = None
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        quick(_held_by(_looked_up), 0.2, step=1e-3)
    assert _TABLE is not None
    globals()["_TABLE"] = None
    many = lw.simulate_many(_held_by(_looked_up), {"bar.mass": [1.0, 2.0]}, 0.1, step=1e-3, progress=False)
    assert list(many.status) == ["finished", "finished"]


@pytest.mark.parametrize("before", [0, 3])
def test_what_a_compiled_object_holds_for_itself_is_not_written_to(before: int) -> None:
    """A cycle keeps a list of what it goes over, and counts on it."""
    names, log = itertools.cycle("abcd"), []
    for _ in range(before):
        next(names)

    def law(t: float, angle: float, rate: float) -> float:
        log.append(next(names))
        return -3.0 * angle

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.LinkworkWarning)
        quick(_held_by(law), 0.2, step=1e-3)
    assert [next(names) for _ in range(8)] == 2 * [next(names) for _ in range(4)]
