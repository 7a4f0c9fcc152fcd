"""Hostile values give errors of linkwork that name them, not those of the libraries below."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms, memory
from linkwork.running import recording


def run(model: lw.Model, **choices: Any) -> lw.Result:
    return lw.simulate(model, **{"t_end": 0.1, "step": 1e-2, "progress": False, **choices})


@pytest.mark.parametrize("name", ["a\nb", "\x1b[31m", "a\0b", "\ud800", "x" * 981])
@pytest.mark.parametrize(
    "give",
    [
        lambda name: lw.Model(name=name),
        lambda name: setattr(lw.Model(), "name", name),
        lambda name: lw.Model().body(name, mass=1.0, inertia=(1, 1, 1)),
        lambda name: lw.Model().bodies(name, mass=1.0, inertia=(1, 1, 1), position=np.eye(3)),
    ],
)
def test_names_that_no_file_or_terminal_takes_are_refused(give: Callable[[str], Any], name: str) -> None:
    with pytest.raises(lw.ModelError, match="name '.*' (is not printable text|has more than 980)"):
        give(name)


def test_the_longest_names_can_be_saved_and_loaded(tmp_path: Path) -> None:
    model = lw.Model(name="m" * 980)
    model.bodies("b" * 980, mass=1.0, inertia=(1, 1, 1), position=np.ones((12, 3)))
    model.save(tmp_path / "model.yaml")
    assert lw.Model.load(tmp_path / "model.yaml").hash() == model.hash()


def test_a_name_in_a_file_is_checked_like_one_in_python(tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text('linkwork: 1\nname: "a\\nb"\n')
    with pytest.raises(lw.ModelFileError, match=r"model.yaml:2: name: .*not printable"):
        lw.Model.load(tmp_path / "model.yaml")


@pytest.mark.parametrize("count", [2**40, 2**63, 2**64, 10**400])
def test_a_mechanism_beyond_memory_is_refused_at_once(count: int) -> None:
    with pytest.raises(lw.ModelError, match="bodies"):
        mechanisms.chain(count)


@pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan])
def test_an_event_that_is_not_finite_is_named(value: float) -> None:
    event = lw.Event(lambda t, state: value if t > 0.05 else 1.0, "odd")
    with pytest.raises(lw.OptionError, match="event 'odd'.*not a finite number"):
        run(mechanisms.pendulum(), step=None, rtol=1e-6, events=event)


@pytest.mark.parametrize("value, said", [(np.nan, "not finite"), (np.inf, "not finite")])
def test_an_integrator_of_the_users_own_is_blamed_itself(value: float, said: str) -> None:
    with pytest.raises(lw.OptionError, match=f"integrator .*{said}"):
        run(mechanisms.pendulum(), integrator=lambda system, t, y, h: y * value)


def test_text_of_an_integrator_of_the_users_own_is_no_state() -> None:
    with pytest.raises(lw.OptionError, match="integrator .*'abc' is not made of numbers"):
        run(mechanisms.pendulum(), integrator=lambda system, t, y, h: "abc")  # type: ignore[return-value]


def test_stop_iteration_in_a_function_of_the_users_ends_no_loop_of_ours() -> None:
    def tired(t: float, state: Any) -> float:
        raise StopIteration("enough")

    with pytest.raises(lw.OptionError, match="raised StopIteration"):
        run(mechanisms.pendulum(), step=None, rtol=1e-6, events=lw.Event(tired))


@pytest.mark.parametrize("field", ["t", "q", "v", "history", "error"])
@pytest.mark.parametrize("value", ["x", None])
def test_a_start_that_is_no_state_is_named(field: str, value: Any) -> None:
    state = run(mechanisms.pendulum()).snapshot()
    with pytest.raises(lw.OptionError, match="start"):
        run(mechanisms.pendulum(), t_end=0.2, start=state._replace(**{field: value}))


def test_a_run_whose_frames_do_not_fit_into_memory_asks_for_a_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "available", lambda: 1e6)
    with pytest.raises(lw.OptionError, match="need .* give output='run.h5'"):
        run(mechanisms.pendulum(), step=1e-5, record_every=1)
    assert len(run(mechanisms.pendulum(), step=1e-3)) == 101


def test_a_run_of_unknown_length_ends_before_memory_does(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recording, "LOOK_BYTES", 10_000)
    monkeypatch.setattr(memory, "available", lambda: 100_000)
    with pytest.raises(lw.OptionError, match="the frames so far need") as caught:
        run(mechanisms.pendulum(), t_end=10.0, step=1e-3, rtol=1e-6, record_every=1)
    assert caught.value.state is not None


def test_paths_that_lead_nowhere_are_refused(tmp_path: Path) -> None:
    loop = tmp_path / "loop.yaml"
    os.symlink(loop, loop)
    for use in (lw.Model.load, mechanisms.pendulum().save, lw.import_urdf, lw.Result.load):
        for path in ("\ud800.yaml", "a\0b.yaml", loop):
            with pytest.raises(lw.FileError):
                use(path)  # type: ignore[operator]
    with pytest.raises(lw.FileError, match="leads back to itself"):
        run(mechanisms.pendulum(), output=loop)
