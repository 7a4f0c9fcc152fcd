"""What an event or a law keeps in any place: each run of many begins without it, or it is told."""

from __future__ import annotations

import contextvars
import ctypes
import dataclasses
import enum
import functools
import random
import threading
import warnings
import weakref
from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
import remembering_laws

#: What reads an effort [N m], and what sets it.
Place = Callable[[], tuple[Callable[[], float], Callable[[float], object]]]

HOW: Any = {"rtol": 1e-6, "step": 0.02, "progress": False}
FINAL = "coordinate('hinge').value.final"


def _held_by(law: Any, name: str = "controller") -> lw.Model:
    model = lw.Model()
    bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    model.joint_force("hinge", law, name=name)
    return model


def _clock(put: Callable[[float], object]) -> lw.Event:
    """Samples -2 N m - omega each 0.05 s."""

    def sample(t: float, state: Any) -> None:
        put(-2.0 - state.body("bar").omega[1])

    return lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=sample)


def _reached(run: lw.Result) -> float:
    return float(run.coordinate("hinge").value[-1])


class _Controller:
    """As that of the guide: one method samples, another returns what is held."""

    def __init__(self, gain: float = 1.0) -> None:
        self.held, self.gain = 0.0, gain

    def sample(self, t: float, state: Any) -> None:
        self.held = -2.0 - self.gain * state.body("bar").omega[1]

    def law(self, t: float, angle: float, rate: float) -> float:
        return self.held


class _Counting:
    """It counts, too, what nobody reads, and fills an array."""

    def __init__(self) -> None:
        self.held, self.count = np.zeros(1), 0

    def sample(self, t: float, state: Any) -> None:
        self.count += 1
        self.held.fill(-2.0 - state.body("bar").omega[1])

    def law(self, t: float, angle: float, rate: float) -> float:
        return float(self.held[0])


@pytest.mark.parametrize("kind", [_Controller, _Counting])
def test_members_do_not_share_what_one_method_writes_and_another_reads(kind: Any) -> None:
    def event(of: Any) -> lw.Event:
        return lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=of.sample)

    masses, alone = [1.0, 1.5, 2.0], []
    for mass in masses:
        fresh = kind()
        model = _held_by(fresh.law).replaced("bar", mass=mass)
        alone.append(_reached(lw.simulate(model, 0.3, events=event(fresh), deterministic=True, **HOW)))
    one = kind()
    many = lw.simulate_many(_held_by(one.law), {"bar.mass": masses}, 0.3, events=event(one), **HOW)
    assert [_reached(many.member(k)) for k in range(3)] == alone and one.held == 0.0


def test_a_law_that_reads_in_another_method_what_it_has_put_runs_alone() -> None:
    class Delay:
        def __init__(self) -> None:
            self.angle = 0.0

        def put(self, angle: float) -> None:
            self.angle = angle

        def get(self) -> float:
            return self.angle

        def __call__(self, t: float, angle: float, rate: float) -> float:
            effort = -3.0 * self.get()
            self.put(angle)
            return effort

    alone = lw.simulate(_held_by(Delay()), 0.3, step=1e-3, progress=False, on_inaccurate="pass")
    many = lw.simulate_many(
        _held_by(Delay()), {"bar.mass": [1.0, 1.0]}, 0.3, step=1e-3, progress=False, on_inaccurate="pass"
    )
    assert [_reached(many.member(k)) for k in range(2)] == pytest.approx([_reached(alone)] * 2, abs=1e-12)


def _event_of_threads() -> Any:
    flag = threading.Event()
    return lambda: -3.0 if flag.is_set() else 0.0, lambda effort: flag.set()


def _record() -> Any:
    record = np.zeros(1, dtype=[("effort", float), ("more", float, 3)])[0]
    return lambda: float(record["effort"]), lambda effort: record.__setitem__("effort", effort)


def _pointer() -> Any:
    pointer = ctypes.pointer(ctypes.c_double(0.0))
    return lambda: pointer[0], lambda effort: pointer.__setitem__(0, effort)


def _array_by_pointer() -> Any:
    pointer = np.zeros(1).ctypes.data_as(ctypes.POINTER(ctypes.c_double))
    return lambda: pointer[0], lambda effort: pointer.__setitem__(0, effort)


class _Gain(float):
    held = 0.0


def _of_a_number() -> Any:
    gain = _Gain(1.0)
    return lambda: gain * gain.held, lambda effort: setattr(gain, "held", effort)


def _of_a_member() -> Any:
    mode: Any = enum.Enum("mode", "HELD", module=__name__)  # type: ignore[misc]
    mode.HELD.effort = 0.0
    return lambda: mode.HELD.effort, lambda effort: setattr(mode.HELD, "effort", effort)


class _Off:
    def effort(self) -> float:
        return 0.0


class _On:
    def effort(self) -> float:
        return -3.0


def _of_another_class() -> Any:
    motor = _Off()
    return lambda: motor.effort(), lambda effort: setattr(motor, "__class__", _On)


def _by_another_method() -> Any:
    class Motor:
        def effort(self) -> float:
            return 0.0

    motor = Motor()
    return lambda: motor.effort(), lambda effort: setattr(Motor, "effort", lambda self: effort)


def _by_another_function() -> Any:
    """A variable that holds one."""

    def law() -> float:
        return 0.0

    def put(effort: float) -> None:
        nonlocal law

        def law() -> float:
            return effort

    return lambda: law(), put


def _cached() -> Any:
    held = [0.0]

    @functools.lru_cache(1)
    def effort() -> float:
        return held[0]

    def put(new: float) -> None:
        held[0] = new
        effort.cache_clear()

    return effort, put


def _weakly() -> Any:
    class Held:
        effort = 0.0

    held = _KEPT.setdefault("held", Held())
    held.effort = 0.0
    reference = weakref.ref(held)
    return lambda: reference().effort, lambda effort: setattr(reference(), "effort", effort)  # type: ignore[union-attr]


_KEPT: dict[str, Any] = {}


def _in_a_table() -> Any:
    table = pytest.importorskip("pandas").DataFrame({"effort": [0.0]})
    return lambda: table.at[0, "effort"], lambda effort: table.at.__setitem__((0, "effort"), effort)


def _attribute_of_a_function_not_there_yet() -> Any:
    def get() -> float:
        return getattr(get, "held", 0.0)

    return get, lambda effort: setattr(get, "held", effort)


def _attribute_of_a_class_not_there_yet() -> Any:
    class Motor:
        pass

    return lambda: getattr(Motor, "held", 0.0), lambda effort: setattr(Motor, "held", effort)


def _slot_not_there_yet() -> Any:
    class Motor:
        __slots__ = ("held",)

    motor = Motor()
    return lambda: getattr(motor, "held", 0.0), lambda effort: setattr(motor, "held", effort)


def _private_slot_not_there_yet() -> Any:
    class Motor:
        __slots__ = ("__held",)

        def get(self) -> float:
            return getattr(self, "_Motor__held", 0.0)

        def put(self, effort: float) -> None:
            self.__held = effort

    motor = Motor()
    return motor.get, motor.put


@dataclasses.dataclass(frozen=True, slots=True)
class _Frozen:
    held: float = dataclasses.field(init=False)


def _slot_of_a_frozen_object_not_there_yet() -> Any:
    motor = _Frozen()
    return lambda: getattr(motor, "held", 0.0), lambda effort: object.__setattr__(motor, "held", effort)


def _context_variable_with_an_array() -> Any:
    held = contextvars.ContextVar("held", default=np.zeros(2))
    held.set(np.zeros(2))
    return lambda: float(held.get()[0]), lambda effort: held.set(np.full(2, effort))


def _variable_not_there_yet() -> Any:
    def get() -> float:
        try:
            return held
        except NameError:
            return 0.0

    def put(effort: float) -> None:
        nonlocal held
        held = effort

    held = 0.0
    del held
    return get, put


def _global_variable_not_there_yet() -> Any:
    def get() -> float:
        try:
            return _HELD
        except NameError:
            return 0.0

    def put(effort: float) -> None:
        global _HELD
        _HELD = effort

    globals().pop("_HELD", None)
    return get, put


_HELD: float


def _variable_of_a_module_not_there_yet() -> Any:
    def put(effort: float) -> None:
        remembering_laws.held_there = effort  # type: ignore[attr-defined]

    vars(remembering_laws).pop("held_there", None)
    return lambda: getattr(remembering_laws, "held_there", 0.0), put


PLACES = [
    _event_of_threads, _record, _pointer, _array_by_pointer, _of_a_number, _of_a_member, _of_another_class,
    _by_another_method, _by_another_function, _cached, _weakly, _in_a_table,
    _attribute_of_a_function_not_there_yet, _attribute_of_a_class_not_there_yet, _slot_not_there_yet,
    _private_slot_not_there_yet, _slot_of_a_frozen_object_not_there_yet, _context_variable_with_an_array,
    _variable_not_there_yet, _global_variable_not_there_yet, _variable_of_a_module_not_there_yet,
]  # fmt: skip


@pytest.mark.parametrize("place", PLACES)
def test_what_an_event_changes_is_given_back_wherever_it_is_held(place: Place) -> None:
    get, put = place()
    model = _held_by(lambda t, angle, rate: float(get()))
    how, steps = {"t_end": 0.2, "events": _clock(put), **HOW}, {"record_every": 1}
    alone = _reached(lw.simulate(model, deterministic=True, **how, **steps))
    with pytest.warns(lw.LinkworkWarning, match="'controller': reads what events have changed in a run"):
        assert _reached(lw.simulate(model, deterministic=True, **how, **steps)) != alone
    get, put = place()
    how = {**how, "events": _clock(put)}
    model = _held_by(lambda t, angle, rate: float(get()))
    study = lw.sweep(model, {"bar.mass": [2.0, 1.0]}, FINAL, processes=1, **how)
    many = lw.simulate_many(model, {"bar.mass": [2.0, 1.0]}, **how, **steps)
    assert not study.remarks and study.outputs[FINAL][1] == alone
    assert _reached(many.member(1)) == alone and get() == 0.0


def _lock() -> Any:
    lock = threading.Lock()
    return lambda: -3.0 if lock.locked() else 0.0, lambda effort: lock.acquire(blocking=False)


def _attribute_of_a_thread() -> Any:
    thread: Any = threading.Thread()
    thread.effort = 0.0
    return lambda: thread.effort, lambda effort: setattr(thread, "effort", effort)


def _context_variable_without_a_value() -> Any:
    held = contextvars.ContextVar("held", default=0.0)
    return held.get, held.set


@pytest.mark.parametrize("place", [_lock, _attribute_of_a_thread, _context_variable_without_a_value])
def test_what_nobody_can_give_back_is_told_by_what_it_does(place: Place) -> None:
    """A lock is no place that is looked into."""
    get, put = place()
    model = _held_by(lambda t, angle, rate: get())
    how = {"t_end": 0.2, "events": _clock(put), **HOW}
    lw.simulate(model, **how)
    with pytest.warns(lw.LinkworkWarning, match="'controller': reads what events have changed in a run"):
        lw.simulate(model, **how)
    get, put = place()
    how = {**how, "events": _clock(put)}
    study = lw.sweep(
        _held_by(lambda t, angle, rate: get()), {"bar.mass": [1.0, 2.0]}, FINAL, processes=1, **how
    )
    assert all("cannot be given back" in study.remarks[k] for k in range(2))
    get, put = place()
    model = _held_by(lambda t, angle, rate: get())
    with pytest.warns(lw.LinkworkWarning, match="'controller'.*: what it remembers cannot be given back"):
        many = lw.simulate_many(model, {"bar.mass": [1.0, 2.0]}, **{**how, "events": _clock(put)})
    assert len(many.alone) == 2


def test_of_two_controllers_with_the_same_law_each_is_told_of_what_its_own_run_left() -> None:
    def run(of: _Controller, name: str = "controller") -> lw.Result:
        return lw.simulate(
            _held_by(of.law, name), 0.2, events=lw.Event(tick, "clock", change=of.sample), **HOW
        )

    def tick(t: float, state: Any) -> float:
        return float(np.sin(20 * np.pi * t + 0.1))

    first, second = _Controller(1.0), _Controller(2.0)
    run(first), run(second)
    with pytest.warns(
        lw.LinkworkWarning, match="'controller': reads what events have changed in a run before"
    ):
        run(first)
    with pytest.warns(lw.LinkworkWarning, match="'brake': reads what events have changed in a run before"):
        run(second, "brake")


def test_a_filter_is_told_of_what_it_kept_though_it_is_called_before_the_first_step() -> None:
    kept = [0.0]

    def law(t: float, angle: float, rate: float) -> float:
        kept[0] += 0.03 * (angle - kept[0])
        return -6.0 * kept[0]

    with pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"):
        lw.simulate(_held_by(law), 0.3, step=1e-3, progress=False)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        lw.simulate(_held_by(law), 0.3, step=1e-3, progress=False)
    assert any("remembers what it has kept in a run before" in str(it.message) for it in told)


def _sampling_by_cache() -> Any:
    """The first call in each 0.02 s counts."""
    last = [0.0]

    @functools.cache
    def held(number: int) -> float:
        return -3.0 * last[0]

    def law(t: float, angle: float, rate: float) -> float:
        last[0] = angle
        return held(int(t / 0.02))

    return law


def test_a_cache_is_memory_where_what_it_was_filled_from_changes() -> None:
    law = _sampling_by_cache()
    with pytest.warns(lw.LinkworkWarning, match="'controller': remembers calls"):
        lw.simulate(_held_by(law), 0.3, step=1e-3, progress=False)
    moving = _held_by(law).replaced("bar", omega=(0, 4.0, 0), velocity=(0, 0, -1.2))
    fresh = _held_by(_sampling_by_cache()).replaced("bar", omega=(0, 4.0, 0), velocity=(0, 0, -1.2))
    how: Any = {"step": 1e-3, "progress": False, "on_inaccurate": "pass"}
    assert _reached(lw.simulate(moving, 0.3, **how)) == _reached(lw.simulate(fresh, 0.3, **how))


def test_a_cache_of_what_does_not_change_is_not_emptied() -> None:
    stiffness, log = np.linspace(0.0, 3.0, 7), [0.0]

    @functools.cache
    def table() -> Any:
        return 2.0 * stiffness

    model = _held_by(lambda t, angle, rate: log.append(t) or -float(table()[-1]) * angle)
    lw.simulate(model, 0.1, step=1e-3, progress=False)
    made = table()
    lw.simulate(model, 0.1, step=1e-3, progress=False)
    lw.simulate_many(model, {"bar.mass": [1.0, 2.0]}, 0.1, step=1e-3, progress=False)
    assert table() is made


@pytest.mark.parametrize("draw", [lambda: random.gauss(0, 1), lambda: np.random.normal()])
def test_each_member_draws_the_same_noise_from_a_global_generator(draw: Callable[[], float]) -> None:
    held = [0.0]

    def sample(t: float, state: Any) -> None:
        held[0] = -2.0 + draw()

    clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=sample)
    model = _held_by(lambda t, angle, rate: held[0])
    many = lw.simulate_many(lambda number: model, {"number": [1, 2]}, 0.2, events=clock, **HOW)
    assert _reached(many.member(0)) == _reached(many.member(1))


def test_an_event_whose_function_remembers_is_told() -> None:
    """0.1 m below the highest point so far: that of a step that is tried counts, too."""
    highest = [-1.0]

    def above(t: float, state: Any) -> float:
        height = float(state.body("ball").position[2])
        highest[0] = max(highest[0], height)
        return height - highest[0] + 0.1

    def thrown(speed: float) -> lw.Result:
        model = lw.Model()
        model.body("ball", mass=1.0, inertia=(1, 1, 1), velocity=(1, 0, speed))
        return lw.simulate(model, 0.8, rtol=1e-9, events=drop, progress=False)

    drop = lw.Event(above, name="drop", direction=-1, terminal=True)
    with pytest.warns(lw.LinkworkWarning, match="'event drop': remembers calls") as told:
        result = thrown(3.0)
    assert result.verdict is not None and result.verdict.memory == ("event drop",) and result.verdict.steps
    assert len(told) == 1
    with pytest.warns(lw.LinkworkWarning, match="'event drop': remembers what it has kept in a run before"):
        thrown(2.0)


def test_an_event_whose_function_reads_what_an_event_changes_remembers_nothing() -> None:
    level = [-0.1]

    def below(t: float, state: Any) -> float:
        return float(state.body("ball").position[2]) - level[0]

    def lower(t: float, state: Any) -> None:
        level[0] -= 0.1

    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(1, 1, 1), velocity=(1, 0, 0))
    result = lw.simulate(
        model, 0.5, rtol=1e-9, events=lw.Event(below, "level", change=lower, direction=-1), progress=False
    )
    fallen = np.array([event.t for event in result.events])
    assert fallen == pytest.approx(np.sqrt(2 * 0.1 * np.arange(1, len(fallen) + 1) / 9.81), abs=1e-9)
    assert result.verdict is not None and result.verdict.memory == ()


def test_a_value_that_an_event_drops_and_the_law_computes_anew_is_no_memory_filled_before_or_not() -> None:
    class Lazy:
        def __init__(self) -> None:
            self.speed = 0.0
            self.effort: float | None = 0.0

        def sample(self, t: float, state: Any) -> None:
            self.speed, self.effort = float(state.body("bar").omega[1]), None

        def law(self, t: float, angle: float, rate: float) -> float:
            if self.effort is None:
                self.effort = -2.0 - self.speed
            return self.effort

    lazy = Lazy()
    clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=lazy.sample)
    result = lw.simulate(_held_by(lazy.law), 0.3, events=clock, **HOW)
    assert result.verdict is not None and result.verdict.memory == ()
