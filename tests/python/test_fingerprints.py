"""What functions are known by: their code, and what they read, wherever that stands."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

MINE = """
import functools
import helpers
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

NAMES = ("by_object", "by_class", "by_module", "by_import", "object_itself", "method")
OF_SPRING = {"by_object", "by_class", "object_itself", "method"}


def digests(folder: Path, mine: str = MINE, helpers: str = HELPERS) -> dict[str, str]:
    """Of each, in a process of its own: modules are read once in each."""
    (folder / "mine.py").write_text(mine)
    (folder / "helpers.py").write_text(helpers)
    program = "import mine\nfrom linkwork.fingerprints import digest\n"
    program += f"for name in {NAMES}: print(name, digest(getattr(mine, name)))"
    command = [sys.executable, "-B", "-c", program]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    return dict(line.split() for line in done.stdout.splitlines())


@pytest.fixture(scope="module")
def usual(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return digests(tmp_path_factory.mktemp("usual"))


@pytest.mark.parametrize(
    ("old", "new", "seen_by"),
    [
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
        ("return 7.0", "return 7.5", {"by_import"}),
        ("return 8.0", "return 8.5", set()),
        ("0.0, 0.0", "0.0, 0.5", set()),
    ],
)
def test_an_edit_counts_for_those_that_read_it(
    old: str, new: str, seen_by: set[str], usual: dict[str, str], tmp_path: Path
) -> None:
    assert (old in MINE) != (old in HELPERS)
    found = digests(tmp_path, MINE.replace(old, new), HELPERS.replace(old, new))
    assert {name for name in NAMES if found[name] != usual[name]} == seen_by


def test_a_digest_is_the_same_in_every_process(usual: dict[str, str], tmp_path: Path) -> None:
    assert digests(tmp_path) == usual
