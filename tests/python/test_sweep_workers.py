"""Workers that live on: what they computed with, where functions have changed since they began."""

from __future__ import annotations

import concurrent.futures
import importlib
import multiprocessing
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.studies import sweeping
from linkwork.studies.agreement import Sent

RUN: dict[str, Any] = {"t_end": 0.1, "step": 1e-2, "progress": False}

LAW = """
import linkwork as lw

FORCE = {force}

def pushed(mass):
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("b", mass=mass, inertia=(0.02, 0.03, 0.04))
    model.force(body, force=(FORCE, 0, 0))
    return model

def plain(mass):
    model = lw.Model(gravity=(0, 0, 0))
    model.body("b", mass=mass, inertia=(0.02, 0.03, 0.04))
    return model

def told(result):
    return {force}

def reached(t, state):
    return state.body("b").position[0] - {force}
"""


@pytest.fixture
def law(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[ModuleType]:
    """A module of the user's, with a force of 1 N."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    (tmp_path / "pushing_law.py").write_text(LAW.format(force=1.0))
    yield importlib.import_module("pushing_law")
    del sys.modules["pushing_law"]


@pytest.fixture
def pool(law: ModuleType) -> Iterator[concurrent.futures.Executor]:
    """A process that lives on, and has the law as it is before it changes."""
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as living:
        living.submit(int).result()
        yield living


def edited(law: ModuleType, force: float) -> ModuleType:
    assert law.__file__
    Path(law.__file__).write_text(LAW.format(force=force))
    importlib.invalidate_caches()
    return importlib.reload(law)


def study_of(law: ModuleType, what: str, **how: Any) -> lw.Study:
    model = {"build": law.pushed}.get(what, law.plain)
    outputs: dict[str, Any] = {"v": "body('b').velocity.x.final"}
    if what == "output":
        outputs["told"] = law.told
    more: dict[str, Any] = {**RUN, **how}
    if what == "event":
        more = {**more, "step": None, "rtol": 1e-6, "events": [lw.Event(law.reached)]}
    return lw.sweep(model, {"mass": [1.0]}, outputs, **more)


@pytest.mark.parametrize(("what", "named"), [
    ("build", "another function pushed"), ("output", "another function of the output 'told'"),
    ("event", "another option 'events'"),
])  # fmt: skip
def test_a_worker_with_a_former_function_is_refused_and_nothing_of_it_is_kept(
    what: str, named: str, law: ModuleType, pool: concurrent.futures.Executor, tmp_path: Path
) -> None:
    assert study_of(law, what, executor=pool).status.tolist() == ["finished"]
    where = tmp_path / "study"
    now = edited(law, 2.0)
    with pytest.raises(lw.LinkworkError, match=rf"{named}.*Restart the workers") as caught:
        study_of(now, what, executor=pool, directory=where)
    assert caught.value.code == "executor"
    here = study_of(now, what, processes=1, directory=where)
    velocity = 0.2 if what == "build" else 0.0  # F t / m
    np.testing.assert_allclose(here.outputs["v"], velocity, rtol=1e-12)
    if what == "output":
        assert here.outputs["told"] == [2.0]


def test_a_worker_with_other_data_of_a_module_is_refused(
    law: ModuleType, pool: concurrent.futures.Executor, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(law, "FORCE", 2.0)
    with pytest.raises(lw.LinkworkError, match="another function pushed .*pushing_law.py.: its code, or"):
        study_of(law, "build", executor=pool)
    monkeypatch.undo()
    assert study_of(law, "build", executor=pool).status.tolist() == ["finished"]


def test_a_worker_with_another_version_is_refused(
    law: ModuleType, pool: concurrent.futures.Executor, monkeypatch: pytest.MonkeyPatch
) -> None:
    found: Any = sweeping.contents  # type: ignore[attr-defined]
    monkeypatch.setattr(sweeping, "contents", lambda *given: {**found(*given), "linkwork": "99.0"})
    with pytest.raises(lw.LinkworkError, match=r"runs linkwork \d.*, and this process 99.0: give both"):
        study_of(law, "plain", executor=pool)


def test_workers_are_asked_once_a_study(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []
    monkeypatch.setattr(Sent, "_refusal", lambda sent: asked.append(sent))
    runner: Any = len
    sent: Any = Sent(runner, {}, home=("elsewhere", 1))
    assert [sent([]), sent([])] == [0, 0] and len(asked) == 1
