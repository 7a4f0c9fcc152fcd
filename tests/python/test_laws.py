"""What functions of a model are known by: what they reach, compiled ones too, but not what they keep."""

from __future__ import annotations

import ctypes
import functools
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
import scipy.interpolate
from linkwork.fingerprints import digest, law


def by_a_table(gain: float) -> Any:
    table = {"gain": gain}
    return lambda x: table["gain"] * x


def by_a_spline(gain: float) -> Any:
    spline = scipy.interpolate.CubicSpline([0.0, 1.0, 2.0], [0.0, gain, 0.0])
    return lambda x: spline(x)


def by_functions_of_functions(gain: float) -> Any:
    functions: list[Any] = [lambda x: gain * x]
    for _ in range(8):
        functions = [lambda x, inner=functions[0]: inner(x)]
    return lambda x: functions[0](x)


def by_what_is_remembered(gain: float) -> Any:
    @functools.lru_cache
    def remembered(x: float) -> float:
        return gain * x

    return lambda x: remembered(x)


class Gains:
    def __init__(self, gain: float) -> None:
        self.gains, self.times = {"first": gain}, [0.0]

    def __call__(self, x: float) -> float:
        self.times.append(x)
        return self.gains["first"] * x


@functools.cache
def library(gain: float) -> Path:
    folder = Path(tempfile.mkdtemp())
    (folder / "law.c").write_text(f"double law(double x) {{ return {gain} * x; }}")
    subprocess.run(["gcc", "-shared", "-fPIC", "-o", folder / "law.so", folder / "law.c"], check=True)
    return folder / "law.so"


def by_a_library(gain: float) -> Any:
    if shutil.which("gcc") is None:
        pytest.skip("no C compiler")
    return ctypes.CDLL(str(library(gain))).law


def compiled_by_numba(gain: float) -> Any:
    numba = pytest.importorskip("numba")

    @numba.njit  # type: ignore[untyped-decorator]
    def law(x: float) -> float:
        return gain * x

    law(1.0)  # what it keeps of its compilation says nothing
    return law


def class_compiled_by_numba(gain: float) -> Any:
    numba = pytest.importorskip("numba")

    @numba.experimental.jitclass([("gain", numba.float64)])  # type: ignore[untyped-decorator]
    class Law:
        def __init__(self, gain: float) -> None:
            self.gain = gain

        def force(self, x: float) -> float:
            return self.gain * x

    return Law(gain).force


@pytest.mark.parametrize("make", [
    by_a_table, by_a_spline, by_functions_of_functions, by_what_is_remembered, Gains, by_a_library,
    compiled_by_numba, class_compiled_by_numba,
    lambda gain: np.vectorize(lambda x: gain * x, otypes=[float]),
    lambda gain: np.frompyfunc(lambda x: gain * x, 1, 1),
    lambda gain: {1.0: gain}.get,
    lambda gain: ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(lambda x: gain * x),
    lambda gain: functools.partial(by_a_table(gain)),
    lambda gain: functools.partial(max, compiled_by_numba(gain)),
])  # fmt: skip
def test_laws_are_told_apart_by_what_they_reach_compiled_ones_too(make: Callable[[float], Any]) -> None:
    for told in (law, digest):
        assert told(make(1.0)) == told(make(1.0)) != told(make(2.0))


def test_what_laws_remember_is_nothing_of_theirs() -> None:
    times: list[float] = []
    calls = 0

    def counts(x: float) -> float:
        nonlocal calls
        calls += 1
        times.append(x)
        return x

    for function in (counts, Gains(1.0), np.vectorize(lambda x: 2.0 * x, otypes=[float])):
        before = law(function)
        function(1.0)
        assert law(function) == before
    assert (calls, times) == (1, [1.0])


def test_a_law_that_looks_at_its_model_has_a_hash() -> None:
    model = lw.mechanisms.chain(2)
    model.user_force(lambda t, q, v: np.zeros((model.body_count, 6)))
    assert model.hash() == model.hash()
