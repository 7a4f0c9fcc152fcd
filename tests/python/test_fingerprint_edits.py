"""What an edit changes in the value of a function changes its digest; nothing else does, in any process.

Each function of MINE has the value that stands where @X@ does, by a way of its own. Three processes look at
them: two at the same text, under other seeds of hashes, one at an edited one.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

MINE = """
import builtins, collections, contextlib, contextvars, ctypes, decimal, enum, functools, operator, types
import typing, weakref
import numpy as np
import helpers
import scipy.interpolate

FUNCTIONS = {}

def of(function):
    FUNCTIONS[function.__name__] = function
    return function

# imports inside functions

@of
def imports():
    import late_1
    return late_1.GAIN

@of
def imports_a_name():
    def inner():
        from late_2 import GAIN as gain
        return gain
    return inner()

@of
def imports_from_a_package():
    from package import late
    return late.GAIN

@of
def imports_a_module_of_a_package():
    import package.other as other
    return other.scaled(1.0)

@of
def imports_by_a_text():
    import importlib
    return importlib.import_module("late_3").GAIN

class Importing:
    def method(self):
        from late_4 import scaled
        return scaled(1.0)

@of
def imports_in_a_method():
    return Importing().method()

# modules that are handed on, names that are no names in the code

@of
def looks_up():
    return getattr(helpers, "GA" + "IN")

BY_NAME = {"steel": helpers}

@of
def module_in_a_table():
    return BY_NAME["steel"].GAIN

@of
def module_as_default(module=helpers):
    return module.GAIN

# reads that look like writes

@of
def calls_add():
    return helpers.add(1.0)

class Config:
    index = 0
    gain = @X@

    def update(self, x):
        return self.gain * x

CONFIG = Config()

@of
def index_of_an_array():
    found = np.zeros(2)
    found[CONFIG.index] = 1.0
    return found[0] * CONFIG.gain

@of
def calls_update():
    return CONFIG.update(1.0)

def name_of_another(gain):
    def function():
        def inner(gain):
            gain = 2.0 * gain
            return lambda: gain
        return gain + 0.0 * inner(1.0)()
    return function

FUNCTIONS["name_of_another"] = name_of_another(@X@)

# classes of data

class Load(typing.NamedTuple):
    k: float

    def force(self):
        return @X@ * self.k

class Table(dict):
    def gain(self):
        return @X@ * self["k"]

class Length(float):
    def scaled(self):
        return @X@ * self

class Points(np.ndarray):
    def gain(self):
        return @X@ * float(self.sum())

class Window(collections.deque):
    def gain(self):
        return @X@

class Exact(decimal.Decimal):
    def gain(self):
        return @X@

class Material(enum.Enum):
    STEEL = 1.0

    def gain(self):
        return @X@

class Number(enum.IntEnum):
    ONE = 1

    def gain(self):
        return @X@

LOAD, TABLE, LENGTH, POINTS = Load(1.0), Table(k=1.0), Length(1.0), np.ones(1).view(Points)
WINDOW, EXACT, STEEL, ONE = Window([1.0]), Exact(1), Material.STEEL, Number.ONE
for name, call in {
    "named_tuple": lambda: LOAD.force(), "dictionary": lambda: TABLE.gain(),
    "length": lambda: LENGTH.scaled(),
    "points": lambda: POINTS.gain(), "window": lambda: WINDOW.gain(), "exact": lambda: EXACT.gain(),
    "member": lambda: STEEL.gain(), "member_as_default": lambda it=Material.STEEL: it.gain(),
    "number": lambda: ONE.gain(),
}.items():
    FUNCTIONS[name] = call

class Curve:
    def __init__(self, x, y):
        self.x, self.y = np.array(x), np.array(y)

    def __array__(self, dtype=None, copy=None):
        return self.y

CURVE = Curve([0.0, 1.0 / @X@], [0.0, 1.0])

@of
def own_array():
    return 4.0 * float(np.interp(0.25, CURVE.x, CURVE.y))

# what installed code makes around functions

@np.errstate(all="ignore")
def safe():
    return @X@

@contextlib.contextmanager
def context():
    yield @X@

@functools.singledispatch
def dispatched(x):
    return 0.0

@dispatched.register(float)
def _(x):
    return @X@ * x

class Decorated:
    @np.errstate(all="ignore")
    def method(self):
        return @X@

    pick = operator.itemgetter(int(@X@))

DECORATED = Decorated()

@of
def decorated():
    return safe()

@of
def manages_a_context():
    with context() as gain:
        return gain

@of
def dispatches():
    return dispatched(1.0)

@of
def decorated_method():
    return DECORATED.method()

@of
def picks():
    return Decorated.pick([0.0, 1.0, 2.0])

space = {}
exec("class Made:\\n    def gain(self):\\n        return @X@\\ndef made():\\n    return Made().gain()", space)
MADE = space["made"]

@of
def made_by_exec():
    return MADE()

# numbers of C, weak references, splines

NUMBERS, NUMBER = (ctypes.c_double * 1)(@X@), ctypes.c_double(@X@)
POINTER = ctypes.pointer(ctypes.c_double(@X@))
VIEW = memoryview(bytearray(np.array(@X@)))
WEAK, SPLINE = weakref.ref(CONFIG), scipy.interpolate.UnivariateSpline(range(5), [0, @X@, 0, 1, 0], s=0)
for name, call in {
    "numbers": lambda: NUMBERS[0], "number_of_c": lambda: NUMBER.value,
    "pointer": lambda: POINTER.contents.value,
    "weak": lambda: WEAK().gain, "spline": lambda: round(float(SPLINE(1.0)), 9),
}.items():
    FUNCTIONS[name] = call

# what a context holds, what is held weakly, and what was put where others look

PLACED = @X@

@of
def its_own_module():
    import sys
    return sys.modules[__name__].PLACED

class Family:
    pass

class Member(Family):
    def gain(self):
        return @X@

@of
def a_class_by_its_base():
    return Family.__subclasses__()[0]().gain()

@of
def view_of_memory():
    return VIEW.cast("d")[0]

DEFAULT, GIVEN = contextvars.ContextVar("default", default=@X@), contextvars.ContextVar("given")
GIVEN.set(@X@)
WEAK_VALUES, WEAK_KEYS = weakref.WeakValueDictionary(a=CONFIG), weakref.WeakKeyDictionary({Config: @X@})
WEAK_SET = weakref.WeakSet([CONFIG])
builtins.PUT_INTO_BUILTINS = np.PUT_INTO_NUMPY = np.linalg.PUT_INTO_PACKAGE = @X@
np.put_function, np.put_object = helpers.scaled, CONFIG

def around(variable):
    return lambda: variable.get()

FUNCTIONS["context_around"] = around(contextvars.ContextVar("around", default=@X@))
for name, call in {
    "context": lambda: DEFAULT.get(), "given_in_a_context": lambda: GIVEN.get(),
    "weak_values": lambda: WEAK_VALUES["a"].gain, "weak_keys": lambda: WEAK_KEYS[Config],
    "weak_set": lambda: next(iter(WEAK_SET)).gain,
    "builtins": lambda: PUT_INTO_BUILTINS, "numpy": lambda: np.PUT_INTO_NUMPY,
    "package_of_numpy": lambda: np.linalg.PUT_INTO_PACKAGE,
    "function_in_numpy": lambda: np.put_function(1.0), "object_in_numpy": lambda: np.put_object.gain,
}.items():
    FUNCTIONS[name] = call

# what calls change counts as it was

class Controller:
    def __init__(self, integral):
        self.integral, self.times = integral, []

    def __call__(self):
        self.times.append(0.0)
        self.advance()
        return self.integral - len(self.times)

    def advance(self):
        self.integral += 1.0

CONTROLLER = Controller(@X@)
FUNCTIONS["object_that_remembers"] = Controller(@X@)
FUNCTIONS["through_another"] = lambda: CONTROLLER()

def counter(count):
    def function():
        nonlocal count
        count += 1.0
        return count - 1.0
    return function

FUNCTIONS["counter"] = counter(@X@)

CALLS = contextvars.ContextVar("calls", default=0)

@of
def counts_in_a_context():
    CALLS.set(CALLS.get() + 1)
    return @X@

SPACE = types.SimpleNamespace(gain=@X@, calls=0)

@of
def namespace():
    SPACE.calls += 1
    return SPACE.gain
"""

HELPER = "GAIN = @X@\ndef add(x):\n    return @X@ * x\ndef scaled(x):\n    return @X@ * x\n"
HELPERS = ("helpers", "late_1", "late_2", "late_3", "late_4", "package/late", "package/other")
PROGRAM = """
import json
import mine
from linkwork.fingerprints import digest, law
before = {name: [digest(it), law(it)] for name, it in mine.FUNCTIONS.items()}
values = {name: it() for name, it in mine.FUNCTIONS.items()}
after = {name: [digest(it), law(it)] for name, it in mine.FUNCTIONS.items()}
print(json.dumps([before, values, after]))
"""
Seen = tuple[dict[str, list[str]], dict[str, float], dict[str, list[str]]]


def look(folder: Path, value: str, seed: str) -> Seen:
    """At all functions in a process of their own: digest and law, what each returns, and both again."""
    (folder / "package").mkdir(exist_ok=True)
    for name in HELPERS:
        (folder / f"{name}.py").write_text(HELPER.replace("@X@", value))
    (folder / "mine.py").write_text(MINE.replace("@X@", value))
    done = subprocess.run(
        [sys.executable, "-B", "-c", PROGRAM], cwd=folder, env=os.environ | {"PYTHONHASHSEED": seed},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    before, values, after = json.loads(done.stdout)
    return before, values, after


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> list[Seen]:
    folder = tmp_path_factory.mktemp("edits")
    return [look(folder, value, seed) for value, seed in (("1.0", "0"), ("1.0", "1"), ("2.0", "0"))]


def test_an_edit_of_what_a_function_reaches_changes_its_digest(seen: list[Seen]) -> None:
    (usual, values, _), _, (edited, others, _) = seen
    assert all(others[name] == values[name] + 1.0 for name in values), (values, others)
    assert not [name for name in usual if any(a == b for a, b in zip(usual[name], edited[name], strict=True))]


def test_the_same_text_has_the_same_digest_in_every_process_and_after_calls(seen: list[Seen]) -> None:
    (usual, _, after), (again, _, _), _ = seen
    assert not [name for name in usual if usual[name] != again[name]]
    assert not [name for name in usual if usual[name] != after[name]]
