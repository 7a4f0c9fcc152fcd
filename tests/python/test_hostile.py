"""The first trials of each part of tests/hostile; `./dev hostile` makes as many as there is time for."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "hostile"))

import run as hostile

#: Trials of each part, of which one takes some seconds.
TRIALS = {
    "resume": 12, "interrupt": 2, "value": 60, "call": 2, "damage": 2, "model_file": 2,
    "stores": 2, "kill": 1, "end": 1,
    "disk": 12, "writers": 3, "allocation": 1, "memory_limit": 1, "cycles": 1, "threads": 10, "fork": 2,
    "callbacks": 20, "not_a_number": 10,
}  # fmt: skip


@pytest.mark.parametrize("part", hostile.PARTS)
def test_nothing_of_what_is_tried_first_fails(part: str) -> None:
    found = {seed: hostile.attempt(part, seed) for seed in range(TRIALS[part])}
    assert {seed: what for seed, (_, what) in found.items() if what} == {}
