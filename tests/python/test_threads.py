"""A System works for one caller at a time, and says so; different ones are free of each other."""

from __future__ import annotations

import os
import signal
import threading
import warnings
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, mechanisms
from linkwork.arrays import Floats

SOLVERS = ["auto", *(info.name for info in _core.linear_solvers() if info.available)]


def options(solver: str) -> dict[str, Any]:
    """With a matrix that it takes."""
    return {"linear_solver": solver} | ({} if solver in ("auto", "block") else {"matrix_form": "schur"})


class Door:
    """A force of nothing that waits inside of the evaluation while the door is closed."""

    def __init__(self) -> None:
        self.inside, self.open = threading.Event(), threading.Event()
        self.open.set()

    def __call__(self, t: float, q: Floats, v: Floats) -> Floats:
        self.inside.set()
        assert self.open.wait(60)
        return np.zeros_like(v)


def state(system: lw.System) -> tuple[float, Floats, Floats]:
    y = system.initial_state()
    split = 7 * system.model.body_count
    return 0.0, y[:split], y[split:]


CALLS: dict[str, Callable[[lw.System], Any]] = {
    "accelerations": lambda system: system.accelerations(*state(system)),
    "derivative": lambda system: system.derivative(0.0, system.initial_state()),
    "evaluate": lambda system: system.evaluate(*state(system)),
    "advance_history": lambda system: system.advance_history(0.0, system.initial_state()),
    "statistics": lambda system: system.compiled().statistics(),
    "history": lambda system: system.compiled().history,
    "times": lambda system: system.compiled().right_hand_side_times(0.0, system.initial_state(), 1),
    "run": lambda system: _core.Simulation(system.compiled(), None, 1.0, 0.1),
}


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("first", ["accelerations", "derivative", "evaluate"])
def test_a_system_at_work_refuses_a_second_thread_at_once_and_works_on(first: str, call: str) -> None:
    door = Door()
    model = mechanisms.chain(5)
    model.user_force(door)
    system, other = lw.System(model), lw.System(mechanisms.chain(5))
    alone = system.accelerations(*state(system))
    door.inside.clear()
    door.open.clear()
    with ThreadPoolExecutor(1) as pool:
        try:
            working = pool.submit(CALLS[first], system)
            assert door.inside.wait(60)
            with pytest.raises(lw.BusyError, match="a System for each") as caught:
                CALLS[call](system)
            assert caught.value.code == "busy"
            np.testing.assert_array_equal(other.accelerations(*state(other))[0], alone[0])
        finally:
            door.open.set()
        working.result(60)
    for mine, before in zip(system.accelerations(*state(system)), alone, strict=True):
        np.testing.assert_array_equal(mine, before)


def test_a_run_on_its_way_refuses_a_second_thread() -> None:
    door = Door()
    model = mechanisms.chain(3)
    model.user_force(door)
    system = lw.System(model)
    run = _core.Simulation(system.compiled(), lw.integrators.METHODS["rk4"].compiled(), 0.01, 1e-3)
    door.inside.clear()
    door.open.clear()
    with ThreadPoolExecutor(1) as pool:
        try:
            working = pool.submit(run.advance, 100, 60.0)
            assert door.inside.wait(60)
            for call in (lambda: run.advance(1, 1.0), run.take_frames, run.statistics, lambda: run.energies,
                         lambda: system.derivative(0.0, system.initial_state())):  # fmt: skip
                with pytest.raises(lw.BusyError):
                    call()
        finally:
            door.open.set()
        working.result(60)
        assert len(run.take_frames()["t"]) == 11


def test_a_function_that_calls_the_system_which_calls_it_is_told() -> None:
    model, systems = mechanisms.chain(3), list[lw.System]()

    def nosy(t: float, q: Floats, v: Floats) -> Floats:
        if systems:
            systems[0].accelerations(t, q, v)
        return np.zeros_like(v)

    model.user_force(nosy)
    system = lw.System(model)
    alone = system.accelerations(*state(system))
    systems.append(system)
    for call in ("accelerations", "derivative", "evaluate"):
        with pytest.raises(lw.BusyError, match="a function that calls it"):
            CALLS[call](system)
    systems[0] = lw.System(mechanisms.chain(3))  # another one may be called
    np.testing.assert_array_equal(system.accelerations(*state(system))[0], alone[0])


@pytest.mark.parametrize("solver", SOLVERS)
def test_what_threads_find_with_one_system_is_right_or_refused(solver: str) -> None:
    system = lw.System(mechanisms.chain(100), **options(solver))
    t, q, v = state(system)
    states = [(t, q, 0.1 * k + v) for k in range(4)]
    alone = [system.accelerations(*it) for it in states]
    refused, start = [0] * 4, threading.Barrier(4)

    def work(k: int) -> None:
        start.wait(60)
        for _ in range(50):
            try:
                found = system.accelerations(*states[k])
            except lw.BusyError:
                refused[k] += 1
                continue
            for mine, right in zip(found, alone[k], strict=True):
                np.testing.assert_array_equal(mine, right)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(work, range(4)))
    assert sum(refused) < 200  # one at least works at any time


@pytest.mark.parametrize("solver", SOLVERS)
def test_systems_of_one_model_in_threads_of_their_own_find_the_same_bits(solver: str) -> None:
    model = mechanisms.chain(60)
    alone = lw.System(model, **options(solver)).accelerations(*state(lw.System(model)))

    def work(_: int) -> None:
        system = lw.System(model, **options(solver))
        for _ in range(20):
            for mine, right in zip(system.accelerations(*state(system)), alone, strict=True):
                np.testing.assert_array_equal(mine, right)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(work, range(4)))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.parametrize("solver", [name for name in ("spqr", "block") if name in SOLVERS])
def test_a_process_that_is_forked_beside_a_working_thread_works(solver: str) -> None:
    """Whatever the thread was in the middle of."""
    system = lw.System(mechanisms.chain(60), **options(solver))
    ended = threading.Event()

    def work() -> None:
        mine = lw.System(mechanisms.chain(60), **options(solver))
        while not ended.is_set():
            mine.accelerations(*state(mine))

    with ThreadPoolExecutor(1) as pool:
        pool.submit(work)
        try:
            for _ in range(20):
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", DeprecationWarning)  # of forks beside threads
                    child = os.fork()
                if child == 0:
                    signal.alarm(20)  # its end, should it hang
                    try:
                        system.accelerations(*state(system))
                        os._exit(0)
                    finally:
                        os._exit(1)
                assert os.waitpid(child, 0)[1] == 0
        finally:
            ended.set()


def test_runs_of_one_model_in_threads_have_the_bits_of_one_alone() -> None:
    model = mechanisms.four_bar()

    def run(_: int) -> lw.Result:
        return lw.simulate(model, 0.5, 1e-3, progress=False)

    alone = run(0)
    with ThreadPoolExecutor(4) as pool:
        for result in pool.map(run, range(8)):
            np.testing.assert_array_equal(result.q, alone.q)
            assert result.verdict == alone.verdict
