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
from linkwork.studies.agreement import Here, Sent

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
    sent: Any = Sent(runner, Here(), home=("elsewhere", 1))
    assert [sent([]), sent([])] == [0, 0] and len(asked) == 1


CONTROLLER = """
import linkwork as lw
import numpy as np

class Controller:
    def __init__(self):
        self.held = [0.0]

    def sample(self, t, state):
        self.held[0] = 1.0 - state.body("b").velocity[0]

    def law(self, t, q, v):
        return [self.held[0], 0, 0, 0, 0, 0]

CONTROLLER = Controller()

def sample(t, state):
    CONTROLLER.sample(t, state)

def clock(t, state):
    return np.sin(20 * np.pi * t + 0.1)

def built(mass):
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("b", mass=mass, inertia=(0.02, 0.03, 0.04))
    model.user_force(CONTROLLER.law, body, name="controller")
    return model
"""


@pytest.fixture
def controller(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[ModuleType]:
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "sampling_controller.py").write_text(CONTROLLER)
    yield importlib.import_module("sampling_controller")
    del sys.modules["sampling_controller"]


def test_samples_that_would_go_into_a_copy_of_the_controller_are_refused(controller: ModuleType) -> None:
    """A function of the module goes by name, and a model takes its controller along with the event's."""
    masses, final = [1.0, 2.0], "body('b').velocity.x.final"
    how: dict[str, Any] = {"t_end": 0.3, "rtol": 1e-8, "step": 0.02, "progress": False}
    bound = lw.Event(controller.clock, "clock", change=controller.CONTROLLER.sample)
    by_name = lw.Event(controller.clock, "clock", change=controller.sample)
    here = lw.sweep(controller.built, {"mass": masses}, final, events=bound, processes=1, **how)
    assert np.abs(here.outputs[final]).min() > 0.05
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as pool:
        with pytest.raises(lw.LinkworkError, match="change of event clock, 1 has a copy of what") as caught:
            lw.sweep(controller.built, {"mass": masses}, final, events=bound, executor=pool, **how)
        assert caught.value.code == "executor"
        named = lw.sweep(controller.built, {"mass": masses}, final, events=by_name, executor=pool, **how)
        model, of_body = controller.built(1.0), {"b.mass": masses}
        whole = lw.sweep(model, of_body, final, events=bound, executor=pool, **how)
    assert named.outputs[final] == pytest.approx(here.outputs[final], rel=1e-12)
    assert whole.outputs[final] == pytest.approx(here.outputs[final], rel=1e-12)
