"""Several threads share one evaluation: whoever says how many, the numbers are the same."""

from __future__ import annotations

import os
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import benchmark, cli, mechanisms
from linkwork.comparison.workers import in_processes
from linkwork.errors import OptionError

#: Bodies from which on evaluations are shared.
MANY = 5000


def chain(bodies: int = MANY) -> lw.Model:
    return mechanisms.chain(bodies)


def run(model: lw.Model, **options: Any) -> lw.Result:
    return lw.simulate(
        model, t_end=2e-3, step=1e-3, integrator="rk4", progress=False, on_inaccurate="pass", **options
    )


def test_a_run_has_the_same_bits_with_several_threads_and_its_manifest_says_how_many() -> None:
    model = chain()
    alone, shared = run(model, threads=1), run(model, threads=3)
    assert (alone.manifest["options"]["threads"], shared.manifest["options"]["threads"]) == (1, 3)
    for name in ("q", "v", "multipliers"):
        assert np.array_equal(getattr(alone, name), getattr(shared, name)), name


def test_a_small_model_takes_one_thread_and_says_so() -> None:
    assert lw.System(mechanisms.pendulum(), threads=4).options["threads"] == 1


def test_the_default_heeds_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    model = chain()
    monkeypatch.setenv("OMP_NUM_THREADS", "1")
    assert lw.System(model).options["threads"] == 1
    monkeypatch.delenv("OMP_NUM_THREADS")
    usable = len(os.sched_getaffinity(0))
    assert 1 <= lw.System(model).options["threads"] <= usable


@pytest.mark.parametrize("threads", [0, -2, 1.5, "all", True, 10**9])
def test_a_number_of_threads_that_cannot_be_is_refused(threads: Any) -> None:
    with pytest.raises(OptionError, match="threads"):
        lw.System(chain(3), threads=threads)


def test_a_run_goes_on_to_the_last_bit_with_another_number_of_threads() -> None:
    model = chain()
    half, whole = (
        run(model, threads=2),
        lw.simulate(
            model, t_end=4e-3, step=1e-3, integrator="rk4", progress=False, on_inaccurate="pass", threads=1
        ),
    )
    rest = lw.simulate(
        model, t_end=4e-3, step=1e-3, integrator="rk4", progress=False, on_inaccurate="pass", threads=3,
        start=half.snapshot(-1),
    )  # fmt: skip
    assert "resumed" in rest.manifest
    assert np.array_equal(rest.q[-1], whole.q[-1])
    assert np.array_equal(rest.v[-1], whole.v[-1])


def test_processes_that_were_forked_off_work_on_with_a_system_from_before_and_with_their_own() -> None:
    model = chain()
    system = lw.System(model, threads=3)
    y = system.initial_state()
    expected = system.derivative(0.0, y)

    def task(which: str) -> tuple[bool, int]:
        used = {"before": lambda: system, "own": lambda: lw.System(model),
                "asked": lambda: lw.System(model, threads=2)}[which]()  # fmt: skip
        return np.array_equal(used.derivative(0.0, y), expected), used.options["threads"]

    found = dict(in_processes(task, ["before", "own", "asked"], processes=2, seconds=60))
    assert found == {0: (True, 3), 1: (True, 1), 2: (True, 2)}
    assert np.array_equal(system.derivative(0.0, y), expected)


def test_benchmarks_take_a_number_of_threads(capsys: pytest.CaptureFixture[str]) -> None:
    subject = benchmark.Subject.of("chain", 20)
    found = benchmark.compare_solvers(subject, ["block"], rounds=1, threads=2)
    assert found.threads == 2
    assert cli.run(["bench", "rhs", "--bodies", "20", "--threads", "0"], debug=False) != 0
    assert "threads 0 is too small" in capsys.readouterr().err
