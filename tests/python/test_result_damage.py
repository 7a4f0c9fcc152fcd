"""Result files of which a bit has changed or the end is missing: never another number, never "finished"."""

from __future__ import annotations

import json
import random
import subprocess
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import linkwork as lw
import numpy as np
import pytest
import synthetic
from linkwork import Result
from linkwork.cli import run
from linkwork.errors import FileError, LinkworkWarning
from linkwork.motion.records import Occurrence
from linkwork.results import writing
from linkwork.results.writing import ResultWriter
from recorded import assert_whole_or_says_so

HEADER = synthetic.header(bodies=2, joints=2, expected_frames=60)
STATISTICS = {"steps": 60, "seconds": 0.25}
FIELDS = [name for name, shape in HEADER.frame_shapes().items() if np.prod(shape)]


def saved(path: Path) -> None:
    """Written at once."""
    Result(synthetic.frames(HEADER, 0, 60), HEADER, STATISTICS, run="0" * 32, events=events(0, 4)).save(path)


def in_batches(path: Path) -> None:
    """Written as a run does, with a commit of every batch."""
    frames = synthetic.frames(HEADER, 0, 60)
    with ResultWriter(path, HEADER, run="0" * 32) as writer:
        for first in range(0, 60, 15):
            writer.write_events(events(first // 15, 1))
            writer.write({name: values[first : first + 15] for name, values in frames.items()})
            writer.flush()
        writer.close(STATISTICS)


def events(first: int, count: int) -> list[Occurrence]:
    rng = np.random.default_rng(first)
    return [
        Occurrence(f"event {k}", 0.15 * k, *(rng.random((2, width)) for width in (7, 6, 7, 6)))
        for k in range(first, first + count)
    ]


def read(path: Path) -> Result:
    """A warning says so where the file is damaged, and only there."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = Result.load(path)
    told = [str(it.message) for it in caught if it.category is LinkworkWarning]
    assert len(told) == found.damaged and not (found.damaged and found.finished)
    assert all(f"{path}': the file is damaged; missing: {found.missing[0]}" in it for it in told)
    return found


def in_memory(result: Result) -> Result:
    fields = {name: result.recorded(name) for name in result.header.frame_shapes()}
    assert result.finished
    return Result(fields, result.header, result.statistics, events=result.events)


def outcomes(path: Path, damage: Callable[[bytes, int], bytes], times: int) -> dict[str, int]:
    """Damage the file anew, so many times; how often it was refused, whole, or in part."""
    original, content = in_memory(Result.load(path)), path.read_bytes()
    counts = {"refused": 0, "whole": 0, "part": 0}
    damaged = path.with_name("damaged.h5")
    for seed in range(times):
        damaged.write_bytes(damage(content, seed))
        try:
            found = read(damaged)
            assert_whole_or_says_so(found, original)
            counts["part" if found.missing else "whole"] += 1
        except FileError as error:
            assert "\n" not in str(error) and "damaged.h5'" in str(error)
            counts["refused"] += 1
        except AssertionError as error:
            raise AssertionError(f"seed {seed}") from error
    return counts


def flip(content: bytes, seed: int) -> bytes:
    pick, changed = random.Random(f"{seed} {len(content)}"), bytearray(content)
    changed[pick.randrange(len(changed))] ^= 1 << pick.randrange(8)
    return bytes(changed)


def cut(content: bytes, seed: int) -> bytes:
    return content[: random.Random(f"{seed} {len(content)}").randrange(len(content))]


WRITERS = pytest.mark.parametrize("write", [saved, in_batches])


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    """So that most bytes of a small file are used."""
    monkeypatch.setattr(writing, "CHUNK_BYTES", (256, 4096))


@WRITERS
def test_a_flipped_bit_is_seen(tmp_path: Path, write: Callable[[Path], None]) -> None:
    write(tmp_path / "run.h5")
    counts = outcomes(tmp_path / "run.h5", flip, 100)
    assert counts["refused"] > 0 and counts["part"] > 5, counts


@WRITERS
def test_a_missing_end_is_seen(tmp_path: Path, write: Callable[[Path], None]) -> None:
    write(tmp_path / "run.h5")
    counts = outcomes(tmp_path / "run.h5", cut, 25)
    assert counts["whole"] == 0, counts


@pytest.mark.parametrize("place", [
    "frames/q", "frames/t", "frames/reaction_torque", "events/v", "digests", "model/mass", "model/body_names",
])  # fmt: skip
def test_another_number_anywhere_is_seen(tmp_path: Path, place: str) -> None:
    """Also where HDF5 wrote it, so that nothing but the digests can tell."""
    path = tmp_path / "run.h5"
    in_batches(path)
    original = Result.load(path)
    with h5py.File(path, "r+") as file:
        dataset = file[place]
        dataset[-1] = b"another" if dataset.dtype.kind == "S" else dataset[-1] + 1
    if place.startswith("model"):
        with pytest.raises(FileError, match="the model or the manifest is not what was written"):
            Result.load(path)
        return
    found = read(path)
    assert found.damaged
    assert_whole_or_says_so(found, original)
    assert len(found) == 60 if place.startswith("events") else 15 <= len(found) < 60


def test_the_last_frame_of_a_damaged_file_is_the_last_whole_one(tmp_path: Path) -> None:
    """Rows beyond it are still on disk."""
    path = tmp_path / "run.h5"
    in_batches(path)
    original = in_memory(Result.load(path))
    with h5py.File(path, "r+") as file:
        file["frames/v"][40] = 0.0
    found = read(path)
    last = len(found) - 1
    assert 15 <= last < 40
    assert found.snapshot().t == original.t[last]
    np.testing.assert_array_equal(found.snapshot().q, original.q[last])
    for name in FIELDS:
        whole = original.recorded(name)
        for part in (-1, [-1, 0], np.s_[-3:], np.s_[::-2]):
            np.testing.assert_array_equal(found.recorded(name, part), whole[: last + 1][part])
    with pytest.raises(IndexError, match="out of bounds"):
        found.recorded("q", last + 1)


@pytest.mark.parametrize("name", ["events", "finer", "statistics", "closing"])
def test_what_lost_its_name_is_missed(tmp_path: Path, name: str) -> None:
    path = tmp_path / "run.h5"
    lw.simulate(lw.mechanisms.pendulum(), 0.05, 1e-2, verify=True, output=path, progress=False)
    with ResultWriter(tmp_path / "events.h5", HEADER) as writer:
        writer.write_events(events(0, 3))
        writer.write(synthetic.frames(HEADER, 0, 60))
        writer.close(STATISTICS)
    if name == "events":
        path = tmp_path / "events.h5"
    assert Result.load(path).finished
    with h5py.File(path, "r+") as file:
        if name in file:
            file.move(name, "lost")
        else:
            rename(file, name)
    found = read(path)
    assert found.damaged and not found.finished and len(found) in (6, 60)


def rename(file: h5py.File, name: str) -> None:
    file.attrs["lost"] = file.attrs[name]
    del file.attrs[name]


def test_numbers_of_the_finer_run_have_a_digest(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    result = lw.simulate(lw.mechanisms.pendulum(), 0.05, 1e-2, verify=True, output=path, progress=False)
    assert Result.load(path).verified and Result.load(path).missing == ()
    with h5py.File(path, "r+") as file:
        file["finer/v"][2] *= 1.5
    found = read(path)
    assert (found.missing, found.verified, found.finished) == (("the second, finer run",), False, False)
    np.testing.assert_array_equal(found.q, result.q)


def test_file_between_two_commits_has_the_last(tmp_path: Path) -> None:
    """Its digests are there and its times are not, as where a run is killed between both."""
    path = tmp_path / "run.h5"
    with ResultWriter(path, HEADER) as writer:
        writer.write(synthetic.frames(HEADER, 0, 20))
        writer.flush()
        writer.write(synthetic.frames(HEADER, 20, 20))
        writer._write_digests()
        writer._file.flush()
        (tmp_path / "killed.h5").write_bytes(path.read_bytes())
    found = read(tmp_path / "killed.h5")
    np.testing.assert_array_equal(found.t, 0.01 * np.arange(20))
    assert not found.damaged and found.missing[0].startswith("the end of the run")
    assert "20 frames, not finished" in found.summary()


@pytest.mark.parametrize("frames", [0, 20])
def test_a_warning_says_what_a_file_without_its_end_has_left(tmp_path: Path, frames: int) -> None:
    """Of a run that did not end, in which nothing but the length of the file tells."""
    path, cut = tmp_path / "run.h5", tmp_path / "cut.h5"
    with ResultWriter(path, HEADER) as writer:
        writer.write(synthetic.frames(HEADER, 0, 20))
    content = path.read_bytes()
    with h5py.File(path) as file:
        ends = file["frames/q"].id.get_chunk_info(0).byte_offset
    cut.write_bytes(content[: len(content) - 8 if frames else ends])
    assert not read(path).damaged
    left = "20 frames to t = 0.19 s could be read" if frames else "no frame could be read"
    with pytest.warns(LinkworkWarning, match=f"the file is damaged; missing: the .*; {left}"):
        found = Result.load(cut)
    assert len(found) == frames and "; the file was damaged\nmissing   the " in found.summary()


SHRINK = """
import sys
print("begun", flush=True)
while True:
    with open(sys.argv[1], "wb") as file:
        file.truncate(2**25)
"""

LOOK = """
import contextlib, pathlib, sys
from linkwork.results import heaps
for _ in range(40):
    with contextlib.suppress(ValueError):
        heaps.check(pathlib.Path(sys.argv[1]))
print("alive")
"""


def test_a_file_that_becomes_shorter_while_it_is_read_ends_nobody(tmp_path: Path) -> None:
    """In processes of their own: a signal would end this one."""
    file = str(tmp_path / "run.h5")
    with subprocess.Popen([sys.executable, "-c", SHRINK, file], stdout=subprocess.PIPE, text=True) as other:
        try:
            assert other.stdout is not None and other.stdout.readline() == "begun\n"
            done = subprocess.run([sys.executable, "-c", LOOK, file], capture_output=True, text=True)
        finally:
            other.kill()
    assert (done.returncode, done.stdout) == (0, "alive\n")


def test_file_of_an_earlier_version_is_read_and_says_that_it_has_no_digests(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    saved(path)
    with h5py.File(path, "r+") as file:
        synthetic.strip_digests(file)
    found = Result.load(path)
    assert found.finished and found.missing == () and len(found) == 60
    assert found.manifest["digests"].startswith("none")


def test_blocks_are_few_in_large_files_and_small_in_small_ones(tmp_path: Path) -> None:
    header = synthetic.header(bodies=20, joints=20)
    Result(synthetic.frames(header, 0, 4000), header, STATISTICS).save(tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5") as file:
        ends = file["digests"][:, 0]
    assert ends[0] == 1 and ends[-1] == 4000 and len(ends) < 500
    assert np.diff(ends).max() <= 4000 / 16


# --- the command ---


def damaged(path: Path) -> None:
    in_batches(path)
    with h5py.File(path, "r+") as file:
        file["frames/v"][40] = 0.0


def test_repair_writes_what_is_whole(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "run.h5"
    damaged(path)
    content = path.read_bytes()
    assert run(["repair", str(path)], debug=True) == 0
    told = capsys.readouterr().out
    assert path.read_bytes() == content
    new, old = Result.load(tmp_path / "run.repaired.h5"), read(path)  # the new file is whole in itself
    assert 15 <= len(new) <= 40 and not new.finished
    assert new.missing == old.missing and f"the frames after t = {new.t[-1]:g} s" in told
    for name in FIELDS:
        np.testing.assert_array_equal(new.recorded(name), old.recorded(name))


def test_repair_as_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, new = tmp_path / "run.h5", tmp_path / "new.h5"
    damaged(path)
    assert run(["repair", str(path), "--output", str(new), "--json"], debug=True) == 0
    told: dict[str, Any] = json.loads(capsys.readouterr().out)
    found = Result.load(new)
    assert told == {"source": str(path), "target": str(new), "frames": len(found), "t_end": found.t[-1],
                    "finished": False, "missing": list(found.missing)}  # fmt: skip


def test_repair_of_a_whole_file_writes_none(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    saved(tmp_path / "run.h5")
    assert run(["repair", str(tmp_path / "run.h5")], debug=True) == 0
    assert "no new file" in capsys.readouterr().out
    assert [it.name for it in tmp_path.iterdir()] == ["run.h5"]


def test_repair_refuses_what_it_cannot_do(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "run.h5"
    damaged(path)
    assert run(["repair", str(path), "--output", str(path)], debug=False) == 1
    assert "run.h5': exists already" in capsys.readouterr().err
    assert run(["repair", str(tmp_path / "no.h5")], debug=False) == 1
    assert "no such file" in capsys.readouterr().err
    path.unlink()
    ResultWriter(path, HEADER).close()
    assert run(["repair", str(path)], debug=False) == 1
    assert "no frame is whole" in capsys.readouterr().err
    assert [it.name for it in tmp_path.iterdir()] == ["run.h5"]


@pytest.mark.parametrize("words", [
    ["plot", "FILE"], ["export", "FILE"],
    ["movie", "FILE", "-o", "run.gif", "--seconds", "0.1", "--size", "64", "64"],
    ["report", "FILE", "-o", "run.html"], ["view", "FILE", "--html", "view.html"],
    ["run", "pendulum", "--start", "FILE", "--t-end", "0.2"],
    ["compare", "pendulum", "--reference", "FILE", "--t-end", "0.1", "--steps", "0.01"],
], ids=lambda words: str(words[0]))  # fmt: skip
def test_commands_say_that_a_file_is_damaged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    lw.simulate(lw.mechanisms.pendulum(), 0.1, 1e-2, output="run.h5", progress=False)
    with h5py.File("run.h5", "r+") as file:
        file.attrs["statistics"] = "{}"
    with pytest.warns(
        LinkworkWarning, match=r"result 'run.h5': the file is damaged; missing: the statistics"
    ):
        assert run([word.replace("FILE", "run.h5") for word in words], debug=True) == 0
