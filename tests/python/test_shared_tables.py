"""Laws that share a table have the texts of laws by themselves; the table is written once for all of them."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import pytest
from linkwork.fingerprints import law, together


def _laws(count: int, table: Any) -> list[Any]:
    return [lambda t, angle, rate, k=k: table[k] * angle for k in range(count)]


def test_laws_that_are_written_together_have_the_texts_of_those_by_themselves() -> None:
    table = {k: [float(k), {"gains": (1.0, 2.0)}, law] for k in range(5)}
    laws = [*_laws(3, table), *_laws(2, table[1])]
    with together():
        found = [law(it) for it in laws]
    assert found == [law(it) for it in laws]


def test_a_table_that_is_changed_between_two_hashes_of_a_model_makes_it_another() -> None:
    table = {k: float(k) for k in range(2000)}
    model = lw.Model()
    for k, it in enumerate(_laws(3, table)):
        model.body(f"bar {k}", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, k, 0))
        model.revolute("ground", f"bar {k}", at=(0, k, 0), axis=(0, 1, 0), name=f"hinge {k}")
        model.joint_force(f"hinge {k}", it)
    before = model.hash()
    assert model.hash() == before
    table[1999] = -1.0
    assert model.hash() != before


def test_a_table_of_many_laws_is_written_once(monkeypatch: pytest.MonkeyPatch) -> None:
    from linkwork.fingerprints import writing

    written: list[int] = []
    parts = writing._parts
    monkeypatch.setattr(writing, "_parts", lambda it: (written.append(id(it)), parts(it))[1])
    table = {k: float(k) for k in range(20)}
    with together():
        for it in _laws(50, table):
            law(it)
    assert written.count(id(table)) == 1
