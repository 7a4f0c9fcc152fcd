"""Ctrl-C in runs of very large mechanisms: honored amid a frame, and nothing that counts is lost."""

from __future__ import annotations

import os
import signal
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import linkwork as lw
import numpy as np
import pytest
from linkwork.results import checkpoints, reading, writing
from linkwork.running import recording
from linkwork.running.interrupts import Interrupts
from recorded import bits_after

END, STEP = 0.3, 1e-2


@pytest.fixture(autouse=True)
def large(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few bodies are taken for very many: each frame is a piece, and in pieces itself."""
    monkeypatch.setattr(writing, "LARGE_BYTES", 0)
    monkeypatch.setattr(writing, "LARGE_CHECKPOINT_BYTES", 0)
    monkeypatch.setattr(writing, "CHECKPOINT_SECONDS", 0.0)
    monkeypatch.setattr(recording, "PIECE_FRAMES", 1)


def run(t_end: float, **choices: Any) -> lw.Result:
    return lw.simulate(
        lw.mechanisms.four_bar(), t_end, STEP, "abm4", record_every=2, progress=False,
        on_inaccurate="pass", **choices,
    )  # fmt: skip


def pressed(monkeypatch: pytest.MonkeyPatch, when: Callable[[str], bool]) -> None:
    """The key, as soon as a function that looks for it is the one that is meant."""
    check = Interrupts.check

    def looked(self: Interrupts) -> None:
        if when(sys._getframe(1).f_code.co_name):
            self._pressed = KeyboardInterrupt
        check(self)

    monkeypatch.setattr(Interrupts, "check", looked)


def nth(name: str, count: int) -> Callable[[str], bool]:
    """Whether a function looks for the so manyth time, from 0 on."""
    left = [count]

    def found(looking: str) -> bool:
        left[0] -= looking == name
        return left[0] < 0

    return found


def interrupted(output: Path) -> lw.Result | None:
    with pytest.raises(KeyboardInterrupt) as caught:
        run(END, output=output)
    return getattr(caught.value, "result", None)


def assert_kept(output: Path, found: lw.Result | None, whole: lw.Result) -> None:
    """The frames are the first ones of the whole run, which goes on from them to the last bit."""
    loaded = lw.Result.load(output)
    assert loaded.status == "interrupted" and found is not None
    with h5py.File(output) as file:
        assert {len(field) for field in file["frames"].values()} == {len(found)}
    np.testing.assert_array_equal(found.q, whole.q[: len(found)])
    np.testing.assert_array_equal(loaded.q, found.q)
    if len(found) > 1:
        end = float(found.t[-1])
        for result in (found, loaded):
            rest = run(END + 0.1, start=result.snapshot())
            assert rest.manifest["resumed"] is True
            assert bits_after(rest, end) == bits_after(run(END + 0.1), end)


@pytest.mark.parametrize("name", ["_write_header", "_encoded", "content", "_head", "_write_whole"])
def test_before_the_first_frame_there_is_no_file(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pressed(monkeypatch, nth(name, 0))
    assert interrupted(tmp_path / "run.h5") is None
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("frame", [0, 1, 5])
@pytest.mark.parametrize("field", [0, 4, 9])
def test_a_frame_that_is_being_written_is_not_kept(
    frame: int, field: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, output = run(END), tmp_path / "run.h5"
    fields = len(whole.header.frame_shapes()) - 1 - (not whole.header.history_count)  # t does not count
    with monkeypatch.context() as key:
        pressed(key, nth("write", frame * fields + field))
        found = interrupted(output)
    assert found is not None and len(found) == frame
    assert_kept(output, found, whole)


@pytest.mark.parametrize("count", [0, 1, 5])
def test_a_frame_after_which_a_checkpoint_is_being_written_is_kept(
    count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, output = run(END), tmp_path / "run.h5"
    with monkeypatch.context() as key:
        pressed(key, nth("write_beside", count))
        found = interrupted(output)
    assert found is not None and len(found) >= count + 1
    assert_kept(output, found, whole)


@pytest.mark.parametrize("moment", range(30, 280, 25))
def test_at_any_moment_what_was_written_is_kept(
    moment: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, output, looks = run(END), tmp_path / "run.h5", iter(range(moment))
    with monkeypatch.context() as key:
        pressed(key, lambda name: next(looks, None) is None)
        found = interrupted(output)
    if output.exists():
        assert_kept(output, found, whole)


def test_nothing_that_takes_time_is_done_after_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The checkpoint stays where it is, the head is not read again, and no later frame is taken."""
    output = tmp_path / "run.h5"

    def refused(*_: Any) -> None:
        raise AssertionError("takes seconds of a million bodies")

    with monkeypatch.context() as key:
        key.setattr(checkpoints, "write", refused)
        key.setattr(reading, "_read_header", refused)
        pressed(key, nth("write", 50))
        found = interrupted(output)
    assert found is not None and len(found) > 1
    assert checkpoints.beside(output).exists()
    run(END, output=output, overwrite=True)
    assert not checkpoints.beside(output).exists()


def test_in_the_head_nothing_is_raised_inside_of_hdf5(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where it could be swallowed by the callback of a weak reference, as h5py has them."""
    make_place = checkpoints.make_place

    def press(*given: Any) -> None:
        os.kill(os.getpid(), signal.SIGINT)
        make_place(*given)

    monkeypatch.setattr(checkpoints, "make_place", press)
    with pytest.raises(KeyboardInterrupt) as caught:
        run(END, output=tmp_path / "run.h5")
    assert traceback.extract_tb(caught.value.__traceback__)[-1].name == "check"
    assert list(tmp_path.iterdir()) == []


def test_the_result_of_a_run_that_has_ended_is_that_of_its_file(tmp_path: Path) -> None:
    """Though its header is not read again."""
    found = run(END, output=tmp_path / "run.h5")
    loaded = lw.Result.load(tmp_path / "run.h5")
    assert found.manifest == loaded.manifest and found.statistics == loaded.statistics
    assert list(found.body_names) == list(loaded.body_names)
    for name in writing.MODEL_ARRAYS:
        np.testing.assert_array_equal(getattr(found.header, name), getattr(loaded.header, name))
    assert found.snapshot().resume == loaded.snapshot().resume is not None
