"""Laws that remember calls are told, whatever they remember with; those that only keep something are not."""

from __future__ import annotations

import collections
import itertools
import queue
import random
import threading
import time
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats


def quick(model: lw.Model, t_end: float, **how: Any) -> lw.Result:
    return lw.simulate(model, t_end, **{"progress": False, "on_inaccurate": "pass", **how})


def _held_by(law: Any) -> lw.Model:
    model = lw.Model()
    bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
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
