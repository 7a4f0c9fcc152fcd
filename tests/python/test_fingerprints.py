"""What functions are known by: their code, and what they read, wherever that stands."""

from __future__ import annotations

import copy
import functools
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
import scipy.interpolate
import scipy.spatial
from linkwork.fingerprints import digest
from linkwork.fingerprints.writing import Writer

MINE = """
import dataclasses
import enum
import functools
import pandas
import helpers
import package.inner
from helpers import third

FACTOR = 2.0

class Base:
    SHARE = 0.5

    def base(self):
        return 1.0

class Spring(Base):
    def __init__(self, stiffness):
        self.stiffness = stiffness

    def of(self, x):
        return self.stiffness * x * self.inner()

    def inner(self):
        return FACTOR

    @property
    def doubled(self):
        return 2.0 * self.stiffness

    @staticmethod
    def fixed():
        return 3.0

    @functools.cached_property
    def kept(self):
        return 4.0

    def __call__(self, result):
        return self.of(1.0)

SPRING = Spring(5.0)

def by_object(result):
    return SPRING.of(1.0)

def by_class(result):
    return Spring(1.0).of(1.0)

def by_module(result):
    return helpers.first(result) + helpers.GAIN

def by_import(result):
    return third(result)

object_itself = Spring(1.0)
method = Spring(1.0).of

@dataclasses.dataclass
class Peak:
    limit: float

    def __call__(self, result):
        return 11.0 * self.limit

data_class = Peak(1.0)

class Hidden:
    _gain = 12.0

    class Inner:
        SIZE = 13.0

    def __call__(self, result):
        return self._gain

stateless = Hidden()

class Limit(enum.Enum):
    LOW = 14.0

def by_member(result):
    return Limit.LOW.value

def decorate(function):
    @functools.wraps(function)
    def wrapper(*given):
        return function(*given)
    return wrapper

@decorate
@decorate
def twice(result):
    return 15.0

@functools.cache
def remembered(x):
    return 16.0

LAST, TABLE = slice(17, None), pandas.DataFrame({"a": [18.0]})

def by_global(result):
    return twice(result) + remembered(1.0) + TABLE.a.sum() + len(result.t[LAST])

def imports_itself(result):
    import helpers
    from package import inner
    return helpers.third(1.0) + inner.nested(1.0)

COUNT, KEPT = 0, {}

def remembers(result):
    global COUNT
    COUNT += 1
    if 1 not in KEPT:
        KEPT[1] = 20.0
    return KEPT[1]

REGISTRY = {"spring": Limit}

def by_registry(result):
    return REGISTRY["spring"]

def by_attribute(result):
    return result.energy.max()
"""

HELPERS = """
import math
GAIN, OFFSET, UNUSED = 1.0, 0.0, 0.0

def first(x):
    return second(x)

def second(x):
    return math.sin(6.0) + OFFSET

def third(x):
    return 7.0

def unused(x):
    return 8.0
"""

INNER = """
def nested(x):
    return 19.0
"""

NAMES = (
    "by_object", "by_class", "by_module", "by_import", "object_itself", "method", "data_class", "stateless",
    "by_member", "by_global", "imports_itself", "by_registry", "by_attribute",
    "remembers",
)  # fmt: skip
OF_SPRING = {"by_object", "by_class", "object_itself", "method"}


def write(folder: Path, mine: str, helpers: str, inner: str) -> None:
    (folder / "package").mkdir()
    (folder / "package" / "__init__.py").touch()
    (folder / "package" / "inner.py").write_text(inner)
    (folder / "mine.py").write_text(mine)
    (folder / "helpers.py").write_text(helpers)


def digests(
    folder: Path, mine: str = MINE, helpers: str = HELPERS, inner: str = INNER, before: str = ""
) -> dict[str, str]:
    """Of each, in a process of its own: modules are read once in each."""
    write(folder, mine, helpers, inner)
    program = f"import mine\nfrom linkwork.fingerprints import digest\n{before}\n"
    program += f"for name in {NAMES}: print(name, digest(getattr(mine, name)))"
    command = [sys.executable, "-B", "-c", program]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    return dict(line.split() for line in done.stdout.splitlines())


@pytest.fixture(scope="module")
def usual(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return digests(tmp_path_factory.mktemp("usual"))


EDITS: list[tuple[str, str, set[str]]] = [
    ("self.stiffness * x", "self.stiffness + x", OF_SPRING),
    ("return FACTOR", "return FACTOR + 1.0", OF_SPRING),
    ("FACTOR = 2.0", "FACTOR = 2.5", OF_SPRING),
    ("return 1.0", "return 1.5", OF_SPRING),
    ("SHARE = 0.5", "SHARE = 0.6", OF_SPRING),
    ("2.0 * self", "2.5 * self", OF_SPRING),
    ("return 3.0", "return 3.5", OF_SPRING),
    ("return 4.0", "return 4.5", OF_SPRING),
    ("Spring(5.0)", "Spring(5.5)", {"by_object"}),
    ("math.sin(6.0)", "math.sin(6.5)", {"by_module"}),
    ("GAIN, OFFSET, UNUSED = 1.0", "GAIN, OFFSET, UNUSED = 1.5", {"by_module"}),
    ("1.0, 0.0, 0.0", "1.0, 0.5, 0.0", {"by_module"}),
    ("return 7.0", "return 7.5", {"by_import", "imports_itself"}),
    ("11.0", "11.5", {"data_class"}),
    ("12.0", "12.5", {"stateless"}),
    ("13.0", "13.5", {"stateless"}),
    ("14.0", "14.5", {"by_member", "by_registry"}),
    ("15.0", "15.5", {"by_global"}),
    ("16.0", "16.5", {"by_global"}),
    ("17,", "27,", {"by_global"}),
    ("18.0", "18.5", {"by_global"}),
    ("19.0", "19.5", {"imports_itself"}),
    ("return 8.0", "return 8.5", set()),
    ("0.0, 0.0", "0.0, 0.5", set()),
]

#: Each folder in a process of its own, which is forked from one that has what all need.
IN_FOLDERS = f"""
import os, sys, pandas
from linkwork.fingerprints import digest
for folder in sys.argv[1:]:
    if os.fork() == 0:
        os.chdir(folder)
        import mine
        for name in {NAMES}: print(folder, name, digest(getattr(mine, name)))
        sys.stdout.flush()
        os._exit(0)
    os.wait()
"""


@pytest.fixture(scope="module")
def edited(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, str]]:
    """The digests after each of EDITS."""
    folders = []
    for old, new, _ in EDITS:
        folders.append(tmp_path_factory.mktemp("edited"))
        write(folders[-1], *(text.replace(old, new) for text in (MINE, HELPERS, INNER)))
    command = [sys.executable, "-B", "-c", IN_FOLDERS, *map(str, folders)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    found = [line.split() for line in done.stdout.splitlines()]
    return [{name: digest for place, name, digest in found if place == str(it)} for it in folders]


@pytest.mark.parametrize(("old", "new", "seen_by"), EDITS)
def test_an_edit_counts_for_those_that_read_it(
    old: str, new: str, seen_by: set[str], usual: dict[str, str], edited: list[dict[str, str]]
) -> None:
    assert sum(old in text for text in (MINE, HELPERS, INNER)) == 1
    found = edited[EDITS.index((old, new, seen_by))]
    assert {name for name in NAMES if found[name] != usual[name]} == seen_by


def test_a_digest_is_the_same_in_every_process_whatever_else_was_done(
    usual: dict[str, str], tmp_path: Path
) -> None:
    """Among it a global of the name of an attribute, and columns that were looked at."""
    before = "import asyncio; mine.energy = 3.0; mine.TABLE.a; mine.SPRING.kept; mine.by_object(None)"
    before += "; mine.remembers(None)"
    assert digests(tmp_path, before=before) == usual


class Node:
    def __init__(self) -> None:
        self.near: list[Node] = []


def test_meshes_and_shared_lists_take_no_longer_than_their_size() -> None:
    nodes = [Node() for _ in range(400)]
    for k, node in enumerate(nodes):
        node.near = [nodes[k + step] for step in (-20, -1, 1, 20) if 0 <= k + step < 400]
    shared: list[Any] = []
    for _ in range(200):
        shared = [shared, shared]
    assert digest(nodes) == digest(nodes) and digest(shared) == digest(shared)
    with pytest.raises(lw.OptionError, match="nested more than"):
        deep: list[Any] = []
        for _ in range(100_000):
            deep = [deep]
        digest(deep)
    assert digest(10**5000) != digest(10**5000 + 1)


def test_a_set_of_texts_has_one_digest_under_every_seed_of_hashes() -> None:
    program = "import types\nfrom linkwork.fingerprints import digest\n"
    program += "print(digest({'a', 'bc', 'd'}, types.SimpleNamespace(x={'e', 'fg', 'h'})))"
    found = set()
    for seed in "0", "1", "2":
        command, environment = [sys.executable, "-c", program], os.environ | {"PYTHONHASHSEED": seed}
        found.add(subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout)
    assert len(found) == 1


def test_a_script_and_the_module_that_it_is_have_one_digest(tmp_path: Path) -> None:
    (tmp_path / "helpers.py").write_text(HELPERS)
    (tmp_path / "package").mkdir()
    (tmp_path / "package" / "inner.py").write_text(INNER)
    again = f"\nfrom linkwork.fingerprints import digest\nprint([digest(globals()[it]) for it in {NAMES}])\n"
    (tmp_path / "mine.py").write_text(MINE + again)
    said = [
        subprocess.run([sys.executable, "-B", *how], cwd=tmp_path, capture_output=True, text=True, check=True)
        for how in (["mine.py"], ["-c", "import mine"])
    ]
    assert said[0].stdout == said[1].stdout


class Damper:
    UNIT = 1.0

    def __init__(self, damping: float) -> None:
        self.damping, self.calls = damping, 0

    def __call__(self, t: float, q: Any, v: Any) -> Any:
        self.calls += 1
        return -self.damping * v

    def method(self, t: float, q: Any, v: Any) -> Any:
        return -self.damping * v


def test_models_with_forces_by_objects_are_told_apart_by_what_these_hold(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def hashed(force: Any) -> str:
        model = lw.mechanisms.chain(2)
        model.user_force(force)
        return model.hash()

    one = Damper(1.0)
    usual = hashed(one)
    assert hashed(Damper(1.0)) == usual != hashed(Damper(2.0))
    assert hashed(Damper(1.0).method) != hashed(Damper(2.0).method)
    one(0.0, 0.0, 1.0)  # what it writes itself does not count
    assert hashed(one) == usual
    monkeypatch.setattr(Damper, "UNIT", 2.0)
    assert hashed(one) != usual
    spline = scipy.interpolate.CubicSpline
    points = ([0.0, 1.0, 2.0], [0.0, 1.0, 0.0]), ([0.0, 1.0, 2.0], [0.0, 2.0, 0.0])
    laws = {hashed(spline(*it)) for it in points}
    assert len(laws) == 2


def push(t: float, gain: float) -> float:
    return gain * t


def with_keyword(gain: float) -> Callable[[float], float]:
    def push(t: float, *, gain: float = gain) -> float:
        return gain * t

    return push


@pytest.mark.parametrize("make", [
    lambda gain: functools.partial(push, gain=gain), with_keyword,
    lambda gain: functools.partial(with_keyword(1.0), gain=gain), lambda gain: lambda t, gain=gain: gain * t,
])  # fmt: skip
def test_models_are_told_apart_by_the_keywords_of_their_functions(make: Callable[[float], Any]) -> None:
    def hashed(gain: float) -> str:
        model = rod(1.0)
        model.force("rod", force=(make(gain), 0, 0))
        return model.hash()

    assert hashed(1.0) == hashed(1.0) != hashed(2.0)


def rod(length: float) -> lw.Model:
    model = lw.Model(name="rod")
    model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(length, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


REFERENCE: Any = None


def reads_a_global(result: lw.Result) -> Any:
    return REFERENCE


def takes(result: lw.Result, reference: Any) -> Any:
    return reference


class Length(float):
    unit: Any = None


class Points(np.ndarray[Any, Any]):
    unit: Any = None


class Table(dict[str, float]):
    unit: Any = None


def with_unit(value: Any, unit: float) -> Any:
    value.unit = unit
    return value


def tagged(length: float) -> Callable[..., Any]:
    def function(result: lw.Result) -> Any:
        return vars(function)["length"]

    vars(function)["length"] = length
    return function


@pytest.mark.parametrize("make", [
    rod, lambda length: lw.simulate(rod(length), 0.01, step=1e-3),
    lambda length: scipy.spatial.transform.Rotation.from_euler("z", length),
    lambda length: scipy.spatial.KDTree(length * np.eye(3)),
    lambda length: {"short": rod(0.5), "long": (rod(length), 1.0)},
    lambda unit: with_unit(Length(1.0), unit), lambda unit: with_unit(np.eye(2).view(Points), unit),
    lambda unit: with_unit(Table(a=1.0), unit), tagged,
])  # fmt: skip
def test_objects_that_a_function_reads_count(
    make: Callable[[float], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """By what they hold: results of the same motion are the same, whatever time it took."""

    def found(value: Any) -> tuple[str, ...]:
        monkeypatch.setitem(globals(), "REFERENCE", value)
        around = functools.partial(takes, reference=value)
        return digest(reads_a_global), digest(around), digest(lambda result: value), digest([value])

    usual, again, other = (found(make(length)) for length in (1.0, 1.0, 1.1))
    assert usual == again
    assert all(a != b for a, b in zip(usual, other, strict=True))


def test_attributes_to_which_a_function_writes_do_not_count() -> None:
    def counted(result: lw.Result) -> float:
        counted.calls += 1  # type: ignore[attr-defined]
        counted.kept[result] = 1.0  # type: ignore[attr-defined]
        return 1.0

    vars(counted).update(calls=0, kept={})
    usual = digest(counted)
    counted(None)  # type: ignore[arg-type]
    assert digest(counted) == usual
    vars(counted)["scale"] = 2.0
    assert digest(counted) != usual


def test_a_tree_of_points_is_the_same_in_every_process() -> None:
    """And whoever has looked into it."""
    text = (
        "import numpy as np, scipy.spatial; from linkwork.fingerprints import digest; "
        "tree = scipy.spatial.KDTree(np.arange(300.0).reshape(100, 3)); print(digest(tree)); "
        "tree.tree; print(digest(tree))"
    )
    found = [
        line
        for _ in range(2)
        for line in subprocess.run(
            [sys.executable, "-c", text], capture_output=True, text=True, check=True
        ).stdout.split()  # fmt: skip
    ]
    assert len(found) == 4 and len(set(found)) == 1


def test_numbers_of_numpy_that_python_has_not_are_told_apart_to_the_last_bit() -> None:
    wide = np.longdouble(1) / 3
    records = [np.array([(1, 2)], [(one, int), (other, int)]) for one, other in ("xy", "yx")]
    different = [
        *(1 / 3, wide, -wide, np.nextafter(wide, 1), np.clongdouble(wide), np.clongdouble(1j) / 3, [wide]),
        *(np.datetime64(1, "ns"), np.datetime64(1, "us"), np.timedelta64(1, "ns"), np.timedelta64(1, "s"), 1),
        *(np.array([1, 2], "m8[s]"), np.array([1, 2], "m8[h]"), np.array([1, 2]), np.timedelta64("NaT")),
        *(records[0], records[1], records[0][0], records[1][0]),
    ]
    assert len({digest(value) for value in different}) == len(different)
    assert digest(wide) == digest(np.longdouble(1) / 3) != digest(np.array([wide]))


def test_a_force_that_reads_a_long_double_runs_and_counts() -> None:
    def pushed(force: np.longdouble) -> lw.Model:
        model = lw.Model(gravity=(0, 0, 0))
        body = model.body("b", mass=1.0, inertia=(0.02, 0.03, 0.04))
        model.user_force(lambda t, q, v: [float(force), 0, 0, 0, 0, 0], body)
        return model

    two = pushed(np.longdouble(2))
    assert lw.simulate(two, 0.1, 0.01).velocity[-1, 0, 0] == pytest.approx(0.2)
    assert two.hash() == pushed(np.longdouble(2)).hash() != pushed(np.longdouble(3)).hash()


def test_a_class_is_the_same_after_an_object_of_it_was_pickled() -> None:
    class Held:
        factor = 2.0

    before = digest(Held)
    copy.copy(Held())  # which, as pickling does, notes the names of slots at the class
    assert "__slotnames__" in vars(Held)
    assert digest(Held) == before


ROWS = np.array([[1.0, 2.0], [3.0, 4.0]])


@pytest.mark.parametrize(("one", "other", "read"), [
    (np.array([100], np.int8), np.array([100]), lambda it: (it * np.int8(2))[0]),  # which holds no 200
    (np.float32(0.5), np.float64(0.5), lambda it: it / 3.0),
    (np.array(0.5), 0.5, lambda it: isinstance(it, float)),
    ((0, 1), [0, 1], lambda it: ROWS[it].sum()),  # one entry, two rows
    ([1.0, 2.0], np.array([1.0, 2.0]), lambda it: len(2 * it)),
    (np.asmatrix(ROWS), ROWS, lambda it: (it * it)[0, 0]),
    (np.asfortranarray(ROWS), ROWS, lambda it: it.ravel("K")[1]),
    (np.ma.array([1.0, 2.0], mask=[0, 1]), np.ma.array([1.0, 2.0], mask=[0, 0]), lambda it: it.sum()),
    (np.ones(2), np.ones((2, 1)), lambda it: (it + it.T).size),
    (np.array([1, 2], object), np.array([1, 2]), lambda it: isinstance(it[0], int)),
    (np.ones(2, "f4, i1"), np.ones(2, "f8, i8"), lambda it: it["f1"][0] * np.int8(127) + it["f1"][0]),
    ([3] * 1000, [3.0] * 1000, lambda it: it[0] ** 40 % 10),
    ([3] * 999 + [3.0], [3.0] + [3] * 999, lambda it: it[0] ** 40 % 10),
    ([3] * 1000, (3,) * 1000, lambda it: ROWS.take(0) + (it == [3] * 1000)),
])  # fmt: skip
@pytest.mark.filterwarnings("ignore:overflow:RuntimeWarning", "ignore::PendingDeprecationWarning")
def test_functions_count_by_the_types_of_what_they_read(one: Any, other: Any, read: Any) -> None:
    """By which they do something else."""

    def hashed(value: Any) -> str:
        model = rod(1.0)
        model.joint_force("pin", lambda t, angle, rate: float(read(value)))
        return model.hash()

    assert float(read(one)) != float(read(other))
    assert hashed(one) == hashed(copy.deepcopy(one)) != hashed(other)
    assert digest(lambda x, it=one: x) != digest(lambda x, it=other: x)


def test_columns_of_a_data_frame_count_by_their_types() -> None:
    pandas = pytest.importorskip("pandas")
    small, wide = (pandas.DataFrame({"n": np.array([100], kind), "x": [0.5]}) for kind in (np.int8, int))
    assert digest(small) == digest(small.copy()) != digest(wide)


def test_models_count_by_the_numbers_that_they_are_given_whatever_holds_them() -> None:
    def hashed(rows: Any, one: Any) -> str:
        model = lw.Model(gravity=rows([0, 0, -10]))
        model.body("rod", mass=one, inertia=rows([1, 1, 1]), position=rows([1, 0, 0]))
        model.revolute("ground", "rod", at=rows([0, 0, 0]), axis=rows([0, 1, 0]), name="pin")
        model.joint_force("pin", lw.functions.table(rows([0, 1, 2, 3]), rows([0, 1, 0, 1])))
        return model.hash()

    assert (
        len({hashed(*it) for it in ((list, 1), (tuple, 1.0), (np.array, np.float32(1)), (np.array, 1))}) == 1
    )


@pytest.mark.parametrize("make", [
    list, tuple, np.array, lambda rows: np.array(rows).reshape(100, 100).T,
    lambda rows: [int(it) for it in rows], lambda rows: [7, *rows],
])  # fmt: skip
def test_long_tables_are_read_by_their_bytes_to_the_last_bit(
    make: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    numbers = [float(k) for k in range(10_000)]
    written: list[Any] = []
    usual = Writer.text
    monkeypatch.setattr(Writer, "text", lambda self, it: (written.append(it), usual(self, it))[1])
    first = digest(make(numbers))
    assert len(written) < 100 and digest(make([*numbers])) == first
    assert len({first, *(digest(make([*numbers[:k], 9e9, *numbers[k + 1 :]])) for k in (0, 5000, 9999))}) == 4


def test_what_is_no_number_in_a_table_is_the_same_in_whatever_bits() -> None:
    one, other = (np.array([0.5, np.copysign(np.nan, sign)]) for sign in (1, -1))
    assert one.tobytes() != other.tobytes()
    assert digest(one) == digest(other)
    assert digest(one.tolist() * 100) == digest(other.tolist() * 100) != digest([0.5, 0.5] * 100)
    assert digest(np.array([0.0])) != digest(np.array([-0.0]))
    assert digest([2**63] * 100) != digest([2**63 + 1] * 100)  # of which there are no 64 bits
