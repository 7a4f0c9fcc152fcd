"""How many threads BLAS has in analyses and in workers."""

from __future__ import annotations

import threading

import linkwork as lw
import numpy as np
import pytest
import threadpoolctl
from linkwork.blas_threads import one_blas_thread
from linkwork.comparison.workers import can_fork, in_processes


def blas_threads(_: object = None) -> set[int]:
    np.linalg.svd(np.eye(3))
    return {it["num_threads"] for it in threadpoolctl.threadpool_info() if it["user_api"] == "blas"}


def test_blas_has_one_thread_as_long_as_anybody_wants_it() -> None:
    with threadpoolctl.threadpool_limits(2, "blas"):
        usual = blas_threads()
        with one_blas_thread():
            assert blas_threads() == {1}
            with one_blas_thread():
                assert blas_threads() == {1}
            assert blas_threads() == {1}
        assert blas_threads() == usual


def test_two_threads_that_want_it_leave_it_as_it_was() -> None:
    with threadpoolctl.threadpool_limits(2, "blas"):
        usual = blas_threads()
    first, second = threading.Event(), threading.Event()

    def outlast() -> None:
        with one_blas_thread():
            first.set()
            second.wait(10)

    other = threading.Thread(target=outlast)
    with threadpoolctl.threadpool_limits(2, "blas"), one_blas_thread():
        other.start()
        first.wait(10)
    second.set()
    other.join()
    with threadpoolctl.threadpool_limits(2, "blas"):
        assert blas_threads() == usual


@pytest.mark.skipif(not can_fork(), reason="there are no processes")
def test_workers_have_one_thread_of_blas_each_and_leave_ours_alone() -> None:
    with threadpoolctl.threadpool_limits(2, "blas"):
        usual = blas_threads()
        with one_blas_thread():  # of those that are forked meanwhile
            assert dict(in_processes(blas_threads, [0, 1], 2)) == {0: {1}, 1: {1}}
        assert dict(in_processes(blas_threads, [0, 1], 2)) == {0: {1}, 1: {1}}
        assert blas_threads() == usual


def test_modes_are_found_with_one_thread() -> None:
    seen: list[set[int]] = []
    model = lw.Model()
    body = model.body("bob", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, -1))
    model.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0), name="pin")

    def law(t: float, angle: float, rate: float) -> float:
        seen.append(blas_threads())
        return -angle

    model.joint_force("pin", law)
    with threadpoolctl.threadpool_limits(2, "blas"):
        found = lw.linearize(model)
    assert set.union(*seen) == {1}
    assert found.frequencies[0] == pytest.approx(np.sqrt((9.81 + 1.0) / 1.1), rel=1e-6)
