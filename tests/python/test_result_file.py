"""Results on disk: exact, complete up to the last second, readable however the run ended."""

from __future__ import annotations

import json
import math
import os
import random
import resource
import shutil
import subprocess
import sys
import textwrap
import time
import tracemalloc
from collections.abc import Callable, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import h5py
import linkwork as lw
import numpy as np
import pytest
import synthetic
from linkwork import Result
from linkwork.errors import FileError, LinkworkWarning
from linkwork.motion.header import Header
from linkwork.results import writing
from linkwork.results.writing import ResultWriter

FIELDS = (
    "t",
    "q",
    "v",
    "acceleration",
    "angular_acceleration",
    "multipliers",
    "kinetic_energy",
    "potential_energy",
    "work",
    "violation",
)


def assert_whole(result: Result) -> None:
    """The last number of every field is the frame's time, and the reactions are finite."""
    for name in ("q", "v", "multipliers", "kinetic_energy", "work", "violation"):
        values = getattr(result, name)
        last = values.reshape(len(result), math.prod(values.shape[1:]))[:, -1]
        np.testing.assert_array_equal(last, result.t, err_msg=name)
        assert np.isfinite(values).all(), name
    assert np.isfinite(result.reactions().force).all()


def make_result(header: Header, count: int = 100) -> Result:
    return Result(synthetic.frames(header, 0, count), header, {"steps": 7, "seconds": 0.25})


@pytest.mark.parametrize("bodies, joints", [(3, 4), (1, 0), (40, 39)])
def test_round_trip_is_exact(tmp_path: Path, bodies: int, joints: int) -> None:
    result = make_result(synthetic.header(bodies, joints))
    result.save(tmp_path / "run.h5")
    loaded = Result.load(tmp_path / "run.h5")
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(loaded, name), getattr(result, name), err_msg=name)
    for name in writing.MODEL_ARRAYS:
        np.testing.assert_array_equal(
            getattr(loaded.header, name), getattr(result.header, name), err_msg=name
        )
    for part in (0, 1):
        np.testing.assert_array_equal(loaded.reactions()[part], result.reactions()[part])
    np.testing.assert_array_equal(loaded.unique_reactions, result.unique_reactions)
    np.testing.assert_array_equal(loaded.redundant_rows, result.redundant_rows)
    assert list(loaded.body_names) == list(result.body_names)
    assert list(loaded.joint_names) == list(result.joint_names)
    assert (loaded.statistics, loaded.manifest) == (result.statistics, result.manifest)


def test_file_written_in_chunks_equals_file_saved_at_once(tmp_path: Path) -> None:
    header = synthetic.header(expected_frames=100)
    result = make_result(header)
    with ResultWriter(tmp_path / "run.h5", header) as writer:
        start = 0
        for count in (1, 0, 9, 40, 50):
            if count:
                part = slice(start, start + count)
                writer.write(
                    {name: values[part] for name, values in synthetic.frames(header, 0, 100).items()}
                )
            start += count
        writer.close(result.statistics)
    loaded = Result.load(tmp_path / "run.h5")
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(loaded, name), getattr(result, name), err_msg=name)
    assert loaded.finished


def test_one_body_is_read_without_reading_the_others(tmp_path: Path) -> None:
    result = make_result(synthetic.header(bodies=200, joints=200), count=1000)  # 11 MB of poses
    result.save(tmp_path / "run.h5")
    loaded = Result.load(tmp_path / "run.h5")
    tracemalloc.start()
    body = loaded.body(77)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    np.testing.assert_array_equal(body.position, result.position[:, 77])
    assert peak < 1e6


def test_result_can_be_saved_over_the_file_it_came_from(tmp_path: Path) -> None:
    result = make_result(synthetic.header())
    result.save(tmp_path / "run.h5")
    loaded = Result.load(tmp_path / "run.h5")
    loaded.save(tmp_path / "run.h5", overwrite=True)
    np.testing.assert_array_equal(loaded.q, result.q)
    assert os.listdir(tmp_path) == ["run.h5"]


PARTS = [
    np.s_[::-1], np.s_[10:2:-3], np.s_[2:10:-1], np.s_[::-1, 0], np.s_[3:3], np.s_[-1], np.s_[-4:-1], [9, 2],
    [3, 3], [-1, 0], [], (), ..., np.s_[..., 0], np.s_[:, None], None, np.s_[:4, [2, 0]], np.s_[:3, ::-1],
    ([1, 2], [0, 1]), ([5, 1, 1], slice(None), [6, 6, 0]), np.arange(100) % 3 == 0, range(3), True,
    np.s_[np.int64(-2), 1:], (np.arange(3)[:, None], np.arange(2)), np.s_[90:1000],
]  # fmt: skip


@pytest.mark.parametrize("part", PARTS, ids=str)
def test_part_of_a_stored_field_is_that_part_of_the_array(tmp_path: Path, part: Any) -> None:
    result = make_result(synthetic.header())
    result.save(tmp_path / "run.h5")
    stored = Result.load(tmp_path / "run.h5")
    np.testing.assert_array_equal(stored.recorded("q", part), result.q[part])


@pytest.mark.parametrize("part", [100, -101, [100], np.s_[0, 3], np.s_[0, 0, 0, 0], 1.5, "q"])
def test_what_is_no_part_is_the_error_that_it_is_in_memory(tmp_path: Path, part: Any) -> None:
    result = make_result(synthetic.header())
    result.save(tmp_path / "run.h5")
    with pytest.raises(IndexError) as in_memory:
        result.recorded("q", part)
    with pytest.raises(IndexError) as in_file:
        Result.load(tmp_path / "run.h5").recorded("q", part)
    assert str(in_file.value) == str(in_memory.value)


def test_failed_save_keeps_the_old_file(tmp_path: Path) -> None:
    old = make_result(synthetic.header())
    old.save(tmp_path / "run.h5")
    new = make_result(synthetic.header(bodies=100, joints=100), count=1000)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2**20, limits[1]))
    try:
        with pytest.raises(FileError, match=r"run.h5': cannot be written: file too large"):
            new.save(tmp_path / "run.h5", overwrite=True)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    np.testing.assert_array_equal(Result.load(tmp_path / "run.h5").q, old.q)
    assert os.listdir(tmp_path) == ["run.h5"]


# --- ends that nobody wished for ---

WRITE_UNTIL_KILLED = """
    import sys, synthetic
    from linkwork.results import writing
    bodies, expected, writing.FLUSH_SECONDS = int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4])
    header = synthetic.header(bodies, bodies, expected_frames=expected or None)
    with writing.ResultWriter(sys.argv[1], header) as writer:
        print("started", flush=True)
        for first in range(0, 10**9, 5):
            writer.write(synthetic.frames(header, first, 5))
"""


def start(
    program: str, *arguments: object, before: Sequence[str] = (), limit: Callable[[], None] | None = None
) -> subprocess.Popen[str]:
    """The program in a Python of its own, in which `synthetic` can be imported."""
    words = [*before, sys.executable, "-c", textwrap.dedent(program), *map(str, arguments)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])}
    pipe = subprocess.PIPE
    return subprocess.Popen(words, env=environment, stdout=pipe, stderr=pipe, text=True, preexec_fn=limit)


@pytest.mark.parametrize("seed", range(12))
def test_file_of_a_killed_writer_holds_whole_frames(tmp_path: Path, seed: int) -> None:
    pick = random.Random(seed)
    path = tmp_path / "run.h5"
    sizes = pick.choice([1, 3, 50, 400]), pick.choice([0, 1000, 100000])
    with start(WRITE_UNTIL_KILLED, path, *sizes, 0.0) as writer:
        assert writer.stdout is not None
        writer.stdout.readline()
        time.sleep(pick.uniform(0.0, 0.5))
        writer.kill()
    result = Result.load(path)
    assert not result.finished
    np.testing.assert_array_equal(result.t, 0.01 * np.arange(len(result)))
    assert_whole(result)


BEGIN_A_LARGE_FILE = """
    import sys, synthetic
    from linkwork.results.writing import ResultWriter
    header = synthetic.header(20000, 20000)
    print("started", flush=True)
    while True:
        ResultWriter(sys.argv[1], header, run="new").close()
"""


@pytest.mark.parametrize("seed", range(6))
def test_file_of_a_writer_killed_while_it_begins_opens(tmp_path: Path, seed: int) -> None:
    """Over an old file: it is the old or the new one, at every moment."""
    ResultWriter(tmp_path / "run.h5", synthetic.header(), run="old").close()
    writer = start(BEGIN_A_LARGE_FILE, tmp_path / "run.h5")
    assert writer.stdout is not None
    writer.stdout.readline()
    time.sleep(random.Random(seed).uniform(0.0, 0.3))
    writer.kill()
    writer.wait()
    assert len(Result.load(tmp_path / "run.h5")) == 0


def test_read_only_file_is_not_replaced(tmp_path: Path) -> None:
    if os.geteuid() == 0:
        pytest.skip("root may write anywhere")
    (tmp_path / "run.h5").write_bytes(b"kept")
    (tmp_path / "run.h5").chmod(0o444)
    with pytest.raises(FileError, match="permission denied"):
        ResultWriter(tmp_path / "run.h5", synthetic.header())
    assert (tmp_path / "run.h5").read_bytes() == b"kept"


@pytest.mark.parametrize("save", [
    lambda result, path: lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, output=path, progress=False),
    lambda result, path: result.save(path), lambda result, path: result.to_csv(path),
])  # fmt: skip
def test_a_name_of_a_folder_is_none_of_a_file(save: Any, tmp_path: Path) -> None:
    result = lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, progress=False)
    with pytest.raises(FileError, match="/run/.: ends as the name of a folder"):
        save(result, f"{tmp_path}/run/")
    assert not list(tmp_path.iterdir())


def test_output_that_is_a_link_is_written_through(tmp_path: Path) -> None:
    (tmp_path / "link.h5").symlink_to(tmp_path / "run.h5")
    ResultWriter(tmp_path / "link.h5", synthetic.header()).close()
    assert (tmp_path / "link.h5").is_symlink() and (tmp_path / "run.h5").is_file()
    assert len(Result.load(tmp_path / "link.h5")) == 0


SIMULATE_FOR_AN_HOUR = """
    import sys, linkwork as lw
    model = lw.Model()
    rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.spherical(model.ground, rod, at=(0, 0, 0))
    said = lambda info: print(info.t, flush=True)
    lw.simulate(model, 1e5, 1e-3, record_every=10, output=sys.argv[1], progress=said)
"""


def test_killed_run_loses_at_most_the_last_second(tmp_path: Path) -> None:
    with start(SIMULATE_FOR_AN_HOUR, tmp_path / "run.h5") as run:
        assert run.stdout is not None
        reached = [(time.monotonic(), float(run.stdout.readline()))]
        while reached[-1][0] < reached[0][0] + 2.5:
            reached.append((time.monotonic(), float(run.stdout.readline())))
        run.kill()
        killed = time.monotonic()
    result = Result.load(tmp_path / "run.h5")
    a_second_before = max(t for at, t in reached if at < killed - 1.0)
    assert result.t[-1] >= a_second_before - 0.01
    assert np.isfinite(result.q).all() and np.isfinite(result.violation).all()


def test_file_size_limit_ends_with_one_line_and_a_readable_file(tmp_path: Path) -> None:
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (3 * 2**20, 3 * 2**20))  # noqa: E731
    writer = start(WRITE_UNTIL_KILLED, tmp_path / "run.h5", 20, 0, 0.5, limit=limit)
    error = writer.communicate(timeout=60)[1].splitlines()[-1]
    result = Result.load(tmp_path / "run.h5")
    assert len(result) > 100
    assert (
        "run.h5': cannot be written: file too large; the" in error
        and f"{len(result)} frames so far are kept" in error
    )
    np.testing.assert_array_equal(result.q[:, -1, -1], result.t)


def on_a_small_disk(program: str, folder: Path) -> list[str]:
    """What a program prints that mounts 3 MB at that folder, seen by nobody else, between its bars."""
    if os.geteuid() != 0 or shutil.which("unshare") is None:
        pytest.skip("mounting a small disk needs root")
    trial = ["unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", folder]
    if subprocess.run(trial, capture_output=True).returncode:
        pytest.skip("mounting is not allowed here")
    run = start(program, folder, before=["unshare", "-m"])
    output, errors = run.communicate(timeout=120)
    assert run.returncode == 0, errors
    return output.strip().split("|")


WRITE_ON_A_SMALL_DISK = """
    import subprocess, sys, synthetic
    from linkwork import Result, errors
    from linkwork.results import writing
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", sys.argv[1]], check=True)
    header = synthetic.header(20, 20)
    try:
        with writing.ResultWriter(sys.argv[1] + "/run.h5", header) as writer:
            for first in range(0, 10**9, 5):
                writer.write(synthetic.frames(header, first, 5))
    except errors.FileError as error:
        result = Result.load(sys.argv[1] + "/run.h5")
        print(error, len(result), (result.q[:, -1, -1] == result.t).all(), sep="|")
"""


def test_full_disk_ends_with_one_line_and_a_readable_file(tmp_path: Path) -> None:
    error, count, whole = on_a_small_disk(WRITE_ON_A_SMALL_DISK, tmp_path)
    assert int(count) > 100 and whole == "True"
    assert "run.h5': no room: " in error and f"free; the {count} frames so far are kept" in error


WRITE_ON_DISKS_OF_ALL_SIZES = """
    import os, shutil, subprocess, sys, synthetic
    from linkwork import errors
    from linkwork.results import writing
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", sys.argv[1]], check=True)
    path, filler = sys.argv[1] + "/run.h5", sys.argv[1] + "/filler"
    header = synthetic.header(3, 4, expected_frames=100)
    for size in range(100_000, 900_000, 50_000):
        with open(filler, "wb") as file:
            os.posix_fallocate(file.fileno(), 0, shutil.disk_usage(sys.argv[1]).free - size)
        writer, told = None, ""
        try:
            writer = writing.ResultWriter(path, header)
            writer.write(synthetic.frames(header, 0, 100))
            writer.close({"steps": 100})
            told = "written"
        except errors.FileError as error:
            told = str(error).partition("no room: ")[2].partition(" free")[0].replace(" kB needed,", "")
        free = shutil.disk_usage(sys.argv[1]).free
        kept = os.path.exists(path) and len(writing.h5py.File(path)["frames/t"])
        print(size, free, kept, told, sep=",", end="|")
        for name in os.listdir(sys.argv[1]):
            os.remove(sys.argv[1] + "/" + name)
"""


def test_a_full_disk_is_told_by_what_is_free_and_no_file_without_frames_stays(tmp_path: Path) -> None:
    """The file itself has some 150 kB, and 256 kB more while it is being written."""
    for row in on_a_small_disk(WRITE_ON_DISKS_OF_ALL_SIZES, tmp_path)[:-1]:
        size, free, kept, told = row.split(",")
        if int(size) >= 500_000:
            assert told == "written", row
        if told == "written":
            assert kept == "100", row
            continue
        needed, there = (float(number) * 1e3 for number in told.removesuffix(" kB").split(" "))
        assert kept == "False" or int(kept) > 0, row
        assert abs(there - int(free)) < 8192 and there < needed < 500_000, row


RUN_ON_A_SMALL_DISK = """
    import subprocess, sys
    from linkwork import Result
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", sys.argv[1]], check=True)
    words = ["run", "chain", "--bodies", "20", "--rtol", "1e-6", "--t-end", "1e4", "--record-every", "1"]
    command = [sys.executable, "-c", "from linkwork.cli import main; main()", *words, "--output"]
    done = subprocess.run([*command, sys.argv[1] + "/run.h5"], capture_output=True, text=True)
    result = Result.load(sys.argv[1] + "/run.h5")
    print(done.returncode, repr(done.stdout), done.stderr.count("\\n"), len(result), done.stderr, sep="|")
"""


def test_command_ends_with_one_line_where_the_disk_is_full(tmp_path: Path) -> None:
    code, out, lines, count, error = on_a_small_disk(RUN_ON_A_SMALL_DISK, tmp_path)
    assert (code, out, lines) == ("1", "''", "1")
    assert int(count) > 100 and f"the {count} frames so far are kept" in error


GO_ON_FROM_A_SMALL_DISK = """
    import subprocess, sys, numpy as np, linkwork as lw
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=800k", "tmpfs", sys.argv[1]], check=True)
    run = dict(t_end=60.0, rtol=1e-5, record_every=1, progress=False)
    model, path = lw.mechanisms.four_bar(), sys.argv[1] + "/run.h5"
    whole = lw.simulate(model, **run)
    try:
        lw.simulate(model, output=path, **run)
    except lw.FileError as error:
        begun = lw.Result.load(path)
        rest = lw.simulate(model, start=begun.snapshot(), **run)
        same = np.array_equal(rest.q[-1], whole.q[-1])
        print(len(begun), begun.t[-1] == rest.t[0], rest.manifest["resumed"], same, error, sep="|")
"""


def test_a_run_goes_on_to_the_last_bit_from_what_a_full_disk_has_kept(tmp_path: Path) -> None:
    count, joined, resumed, same, error = on_a_small_disk(GO_ON_FROM_A_SMALL_DISK, tmp_path)
    assert int(count) > 100 and "no room: " in error and "not that of the whole" not in error
    assert (joined, resumed, same) == ("True", "True", "True")


BEGIN_ANEW_ON_A_SMALL_DISK = """
    import pathlib, subprocess, sys, synthetic
    from linkwork import Result, errors
    from linkwork.results import writing
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8m", "tmpfs", sys.argv[1]], check=True)
    path, small, large = sys.argv[1] + "/run.h5", synthetic.header(2, 3), synthetic.header(4000, 4000)
    found = set()
    for filled in range(0, 8_000_000, 131_072):
        pathlib.Path(sys.argv[1] + "/filler").write_bytes(b"")
        with writing.ResultWriter(path, small) as writer:
            writer.write(synthetic.frames(small, 0, 5))
        with open(sys.argv[1] + "/filler", "wb") as filler:
            try:
                filler.write(b"x" * filled)
            except OSError:
                break
        try:
            with writing.ResultWriter(path, large) as writer:
                writer.write(synthetic.frames(large, 0, COUNT))
            found.add("written")
        except errors.FileError:
            found.add("refused")
        result = Result.load(path)
        found.add(f"{len(result.body_names)} bodies, {len(result)} frames")
    print(*sorted(found), sep="|")
"""


@pytest.mark.parametrize("count", [1, 3])
def test_a_file_gives_way_to_a_run_whose_first_frames_have_room(count: int, tmp_path: Path) -> None:
    """Three at once have none on some disks on which a file for one could be begun."""
    program = BEGIN_ANEW_ON_A_SMALL_DISK.replace("COUNT", str(count))
    assert on_a_small_disk(program, tmp_path) == [
        "2 bodies, 5 frames",
        f"4000 bodies, {count} frames",
        "refused",
        "written",
    ]


FILL_A_LIMITED_FILE = """
    import sys, linkwork as lw
    lw.simulate(lw.mechanisms.four_bar(), 200.0, rtol=1e-5, output=sys.argv[1], progress=False)
"""


def test_where_no_run_goes_on_from_what_was_kept_to_the_last_bit_the_error_says_so(tmp_path: Path) -> None:
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2**20, 2**20))  # noqa: E731
    run = start(FILL_A_LIMITED_FILE, tmp_path / "run.h5", limit=limit)
    error = run.communicate(timeout=60)[1].splitlines()[-1]
    goes_on = Result.load(tmp_path / "run.h5")._checkpoint is not None
    assert "file too large" in error and goes_on != ("not that of the whole to the last bit" in error)


def test_room_that_is_reserved_stays_reserved_after_the_first_flush(tmp_path: Path) -> None:
    header = synthetic.header(3, 4, expected_frames=100)
    with ResultWriter(tmp_path / "run.h5", header) as writer:
        for first in range(0, 100, 10):
            writer.write(synthetic.frames(header, first, 10))
            writer.flush()
            assert os.path.getsize(tmp_path / "run.h5") >= writer._reserved


def test_a_run_without_room_for_its_first_frame_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    header = synthetic.header(expected_frames=10)
    for path in (tmp_path / "new.h5", tmp_path / "old.h5"):
        if path.name == "old.h5":
            make_result(header).save(path)
        writer = ResultWriter(path, header)
        monkeypatch.setattr(writing.shutil, "disk_usage", lambda _: SimpleNamespace(free=0))
        with pytest.raises(FileError, match="no room"):
            writer.write(synthetic.frames(header, 0, 5000))
        monkeypatch.undo()
    assert [it.name for it in tmp_path.iterdir()] == ["old.h5"]
    assert len(Result.load(tmp_path / "old.h5")) > 0


def test_run_that_cannot_fit_is_refused_before_it_starts(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"run.h5': no room: .* needed, .* free"):
        ResultWriter(tmp_path / "run.h5", synthetic.header(expected_frames=10**14))
    assert not list(tmp_path.iterdir())


# --- several runs and one file ---


def test_file_that_is_being_written_is_left_to_its_run(tmp_path: Path) -> None:
    header = synthetic.header()
    with ResultWriter(tmp_path / "run.h5", header) as first:
        first.write(synthetic.frames(header, 0, 10))
        with pytest.raises(FileError, match="another run is writing it"):
            ResultWriter(tmp_path / "run.h5", header)
        first.write(synthetic.frames(header, 10, 10))
    assert len(Result.load(tmp_path / "run.h5")) == 20
    assert os.listdir(tmp_path) == ["run.h5"]


def test_file_that_another_process_writes_is_read_afterwards(tmp_path: Path) -> None:
    with start(WRITE_UNTIL_KILLED, tmp_path / "run.h5", 3, 0, 0.0) as writer:
        assert writer.stdout is not None
        writer.stdout.readline()
        with pytest.raises(FileError, match="a run is writing it; read it when that has ended"):
            Result.load(tmp_path / "run.h5")
        writer.kill()
    assert not Result.load(tmp_path / "run.h5").finished


@pytest.mark.parametrize("replaced", [False, True], ids=["removed", "replaced"])
def test_run_whose_file_went_away_says_so_and_harms_no_other_file(tmp_path: Path, replaced: bool) -> None:
    path, other = tmp_path / "run.h5", b"somebody else's" * 1000

    def take_away(info: object) -> None:
        path.unlink()
        if replaced:
            path.write_bytes(other)

    with pytest.raises(
        FileError, match="was replaced by another" if replaced else "was moved or removed during"
    ) as caught:
        lw.simulate(lw.mechanisms.heavy_top(), 1e4, 1e-3, output=path, progress=once(take_away))
    assert caught.value.result is None
    assert not replaced or path.read_bytes() == other


def once(function: Callable[[object], None]) -> Callable[[object], None]:
    calls: list[object] = []

    def first_call(info: object) -> None:
        if not calls:
            function(info)
        calls.append(info)

    return first_call


# --- files that are something else ---


def test_missing_directory_is_told_before_the_run(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"nowhere/run.h5': cannot be written: no such file or directory"):
        ResultWriter(tmp_path / "nowhere" / "run.h5", synthetic.header())


@pytest.mark.parametrize("content", [b"", b"text, not HDF5", os.urandom(5000)])
def test_file_of_another_kind_is_refused_in_one_line(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "run.h5").write_bytes(content)
    with pytest.raises(FileError, match=r"run.h5'") as caught:
        Result.load(tmp_path / "run.h5")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8, 0.99])
def test_file_cut_short_in_copying_has_the_frames_before_the_cut(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, share: float
) -> None:
    monkeypatch.setattr(writing, "FLUSH_SECONDS", 0.0)  # as if every piece took a second
    header = synthetic.header(bodies=20, joints=20, expected_frames=2000)
    path = tmp_path / "run.h5"
    with ResultWriter(path, header) as writer:
        for first in range(0, 2000, 10):
            writer.write(synthetic.frames(header, first, 10))
        writer.close({"steps": 2000})
    os.truncate(path, int(share * path.stat().st_size))
    with pytest.warns(LinkworkWarning, match="the file is damaged; missing: the frames after t = "):
        result = Result.load(path)
    assert 2000 * (share - 0.1) < len(result) < 2000 * share + 1
    np.testing.assert_array_equal(result.t, 0.01 * np.arange(len(result)))
    assert_whole(result)


def test_file_cut_before_the_first_frame_is_refused_in_one_line(tmp_path: Path) -> None:
    make_result(synthetic.header()).save(tmp_path / "run.h5")
    for size in (3000, 1000, 100, 10):
        os.truncate(tmp_path / "run.h5", size)
        with pytest.raises(FileError, match=r"run.h5': (cannot be read|is damaged)") as caught:
            Result.load(tmp_path / "run.h5")
        assert "\n" not in str(caught.value)


def test_frames_of_a_file_that_was_replaced_are_not_mixed_up(tmp_path: Path) -> None:
    make_result(synthetic.header()).save(tmp_path / "run.h5")
    loaded = Result.load(tmp_path / "run.h5")
    make_result(synthetic.header()).save(tmp_path / "run.h5", overwrite=True)
    with pytest.raises(FileError, match=r"run.h5': was replaced by another run since it was loaded"):
        _ = loaded.q


def test_finished_file_has_no_spare_room(tmp_path: Path) -> None:
    make_result(synthetic.header(bodies=1, joints=0), count=10).save(tmp_path / "run.h5", overwrite=True)
    assert (tmp_path / "run.h5").stat().st_size < 100_000


def test_file_with_the_former_names_of_statistics_loads_by_those_of_today(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    lw.simulate(lw.mechanisms.pendulum(), t_end=0.01, step=1e-3).save(path)
    crossing = {"t": 0.5, "pivot": 1e-9, "joints": ["A"], "rows_changed": False, "taken_over": 3}
    with h5py.File(path, "r+") as file:
        synthetic.strip_digests(file)
        statistics = json.loads(file.attrs["statistics"])
        statistics.pop("singularity_crossings")
        file.attrs["statistics"] = json.dumps(statistics | {"passages": [crossing]})
    pose = Result.load(path).singular_poses[0]
    assert pose == (0.5, ("A",), 1e-9, 3) and pose.fallback_evaluations == 3
    with pytest.raises(AttributeError, match="'fallback_evaluations' now"):
        _ = pose.taken_over


def test_a_result_is_read_on_from_another_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It was loaded, or written by its run, by a path from the folder of before."""
    (tmp_path / "other").mkdir()
    monkeypatch.chdir(tmp_path)
    model = lw.mechanisms.pendulum()
    written = lw.simulate(model, 0.1, step=1e-2, output="run.h5", progress=False)
    loaded = Result.load("run.h5")
    monkeypatch.chdir("other")
    assert loaded.q.shape == written.q.shape == (11, 1, 7)
    for found in (loaded, written):
        rest = lw.simulate(model, 0.2, step=1e-2, start=found.snapshot(), progress=False)
        assert rest.manifest["resumed"]
