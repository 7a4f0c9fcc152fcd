"""What functions of a model are known by: what they reach, compiled ones too, but not what they keep."""

from __future__ import annotations

import ctypes
import functools
import shutil
import subprocess
import sys
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


def typed_list(gain: float) -> Any:
    numbers = pytest.importorskip("numba").typed.List([gain])
    return lambda x: numbers[0] * x


def typed_dictionary(gain: float) -> Any:
    numba = pytest.importorskip("numba")
    numbers = numba.typed.Dict.empty(numba.float64, numba.float64)
    numbers[1.0] = gain
    return lambda x: numbers[1.0] * x


def by_a_stencil(gain: float) -> Any:
    numba = pytest.importorskip("numba")

    @numba.stencil  # type: ignore[untyped-decorator]
    def smoothed(a: Any) -> Any:
        return gain * (a[-1] + a[1])

    return lambda x: smoothed(x)


def by_an_expression(gain: float) -> Any:
    expression = pytest.importorskip("sympy").sympify("x") * gain
    return lambda x: float(expression.subs("x", x))


def made_from_an_expression(gain: float) -> Any:
    sympy = pytest.importorskip("sympy")
    x = sympy.symbols("x")
    return sympy.lambdify(x, gain * x)


def by_a_class_of_pydantic(gain: float) -> Any:
    pydantic = pytest.importorskip("pydantic")
    kind = pydantic.create_model("Law", gain=(float, gain))
    return lambda x: kind().gain * x


def by_an_object_of_pydantic(gain: float) -> Any:
    pydantic = pytest.importorskip("pydantic")
    known = pydantic.create_model("Law", gain=(float, 0.0))(gain=gain)
    return lambda x: known.gain * x


def by_coordinates(gain: float) -> Any:
    xarray = pytest.importorskip("xarray")
    table = xarray.DataArray([0.0, 1.0], dims="x", coords={"x": [0.0, gain]})
    return lambda x: float(table.interp(x=x))


class Set:
    def set_gain(self, gain: float) -> Set:
        self.gain = gain
        return self

    def __call__(self, x: float) -> float:
        return self.gain * x


class Property:
    def __init__(self, gain: float) -> None:
        self.gain = gain

    @property
    def gain(self) -> float:
        return self._gain

    @gain.setter
    def gain(self, gain: float) -> None:
        self._gain = gain

    def __call__(self, x: float) -> float:
        return self.gain * x


class Integral:
    """A controller that remembers."""

    def __init__(self, begin: float) -> None:
        self.integral = begin

    def __call__(self, x: float) -> float:
        self._add(x)
        return self.integral

    def _add(self, x: float) -> None:
        self.integral += x


def by_an_integral(begin: float) -> Any:
    law = Integral(begin)
    return lambda x: law(x)


def with_attribute(gain: float) -> Any:
    def law(x: float) -> Any:
        return vars(law)["gain"] * x

    vars(law)["gain"] = gain
    return law


def deep(gain: float) -> Any:
    held: Any = gain
    for _ in range(10):
        held = [held]
    return lambda x, held=held: held


@pytest.mark.parametrize("make", [
    by_a_table, by_a_spline, by_functions_of_functions, by_what_is_remembered, Gains, by_a_library,
    compiled_by_numba, class_compiled_by_numba,
    typed_list, typed_dictionary, by_a_stencil, by_an_expression, made_from_an_expression,
    by_a_class_of_pydantic, by_an_object_of_pydantic, by_coordinates,
    lambda gain: Set().set_gain(gain), lambda gain: Set().set_gain(gain).__call__, Property, Integral,
    by_an_integral, with_attribute, deep,
    lambda gain: (lambda *x: x) if gain == 1.0 else (lambda x: x),
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

    for function in (
        counts,
        Gains(1.0),
        Integral(0.0),
        Integral(0.0).__call__,
        np.vectorize(lambda x: 2.0 * x, otypes=[float]),
    ):
        before = law(function)
        function(1.0)
        assert law(function) == before
    assert (calls, times) == (1, [1.0])


class Spring:
    """Along x, with a stiffness [N/m] that a method sets, and a count of its calls."""

    def __init__(self) -> None:
        self.calls = 0

    def set_stiffness(self, stiffness: float) -> Spring:
        self.stiffness = stiffness
        return self

    def __call__(self, t: float, q: Any, v: Any) -> list[float]:
        self.calls += 1
        return [-self.stiffness * q[0], 0, 0, 0, 0, 0]


def oscillator(spring: Spring) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("b", mass=1.0, inertia=(0.02, 0.03, 0.04), position=(1, 0, 0))
    model.spring_damper("ground", body, at=((0, 0, 1), (1, 0, 0)), stiffness=0.0, name="weak")
    model.user_force(spring, body)
    return model


def test_what_a_method_sets_is_part_of_the_model_and_what_calls_count_is_not() -> None:
    spring = Spring().set_stiffness(10.0)
    model = oscillator(spring)
    result = lw.simulate(model, 0.1, 0.01)
    assert spring.calls and result.manifest["model_hash"] == model.hash()
    assert not result.force("weak", model).power.any()
    assert model.hash() == oscillator(Spring().set_stiffness(10.0)).hash()
    spring.set_stiffness(1000.0)
    assert model.hash() == oscillator(Spring().set_stiffness(1000.0)).hash() != result.manifest["model_hash"]
    with pytest.raises(lw.OptionError, match="another model"):
        result.force("weak", model)


def test_a_comparison_goes_on_in_its_folder_for_the_same_stiffness_alone(tmp_path: Path) -> None:
    def compare(stiffness: float) -> Any:
        model = oscillator(Spring().set_stiffness(stiffness))
        return lw.compare(model, t_end=0.1, steps=[0.05], resume=tmp_path, processes=1, progress=False)

    assert compare(10.0).to_frame().equals(compare(10.0).to_frame())
    with pytest.raises(lw.FileError, match="model_hash"):
        compare(1000.0)


NUMBERS = ctypes.POINTER(ctypes.c_double)
COMPILED = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_int64, *[NUMBERS] * 3, ctypes.c_void_p)


@COMPILED
def push(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
    g[0] += ctypes.cast(data, NUMBERS)[0]


def pushed(data: Any) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=1.0, inertia=(0.02, 0.03, 0.04))
    model.compiled_force(push, data=data)
    return model


@pytest.mark.parametrize("make", [lambda force: np.array([force]), ctypes.c_double, (ctypes.c_double * 1)])
def test_the_data_of_a_compiled_force_count(make: Callable[[float], Any]) -> None:
    models = [pushed(make(force)) for force in (2.0, 2.0, 3.0)]
    hashes = [it.hash() for it in models]
    assert hashes[0] == hashes[1] != hashes[2]
    for model, force in zip(models, (2.0, 2.0, 3.0), strict=True):
        assert lw.simulate(model, 0.1, 0.01).velocity[-1, 0, 0] == pytest.approx(0.1 * force)


def test_the_data_of_a_compiled_force_count_as_they_are() -> None:
    force = np.array([2.0])
    model = pushed(force)
    assert model.hash() == pushed(np.array([2.0])).hash()
    force[0] = 3.0
    assert model.hash() == pushed(np.array([3.0])).hash()


def test_data_at_an_address_are_those_of_one_process() -> None:
    force = ctypes.c_double(2.0)
    text = (
        "import sys; sys.path.insert(0, sys.argv[1]); import test_laws as it; "
        "print(it.pushed(4096).hash() == it.pushed(4096).hash(), it.pushed(4096).hash())"
    )
    command = [sys.executable, "-c", text, str(Path(__file__).parent)]
    said = [
        subprocess.run(command, capture_output=True, text=True, check=True).stdout.split() for _ in range(2)
    ]
    assert said[0][0] == said[1][0] == "True" and said[0][1] != said[1][1]
    with pytest.raises(lw.ModelError, match="one after the other"):
        pushed(np.zeros((4, 4))[::2, ::2])
    at = ctypes.addressof(force)
    assert lw.simulate(pushed(at), 0.1, 0.01).velocity[-1, 0, 0] == pytest.approx(0.2)


def test_a_law_counts_the_result_that_it_follows() -> None:
    """A controller that follows a recorded motion is another one with another motion."""

    def following(t_end: float) -> str:
        reference = lw.simulate(oscillator(Spring().set_stiffness(1.0)), t_end, 0.01)
        model = lw.mechanisms.chain(1)
        model.user_force(lambda t, q, v: np.full((1, 6), np.interp(t, reference.t, reference.q[:, 0])))
        return model.hash()

    assert following(0.1) == following(0.1) != following(0.2)


def test_a_law_that_looks_at_its_model_has_a_hash() -> None:
    model = lw.mechanisms.chain(2)
    model.user_force(lambda t, q, v: np.zeros((model.body_count, 6)))
    assert model.hash() == model.hash()
