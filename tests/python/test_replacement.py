"""Files are whole or what they were before."""

from __future__ import annotations

import os
import resource
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import linkwork as lw
import pytest
from linkwork import mechanisms
from linkwork.replacement import replacing


@contextmanager
def full_after(count: int) -> Iterator[None]:
    """Files grow to so many bytes only, as on a disk that is full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (count, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("suffix", ["csv", "html", "png", "yaml", "gif"])
def test_a_disk_that_is_full_leaves_the_old_file(suffix: str, tmp_path: Path) -> None:
    model = mechanisms.chain(5)
    result = lw.simulate(model, 0.2, step=1e-2, progress=False)
    path = tmp_path / f"file.{suffix}"
    path.write_text("old")
    writes = {
        "csv": lambda: result.to_csv(path, overwrite=True),
        "html": lambda: result.view(path),
        "png": lambda: result.plot(path),
        "yaml": lambda: model.save(path, overwrite=True),
        "gif": lambda: result.movie(path, seconds=0.2),
    }
    with full_after(500), pytest.raises(lw.FileError, match=f"file.{suffix}"):
        writes[suffix]()
    assert path.read_text() == "old" and os.listdir(tmp_path) == [path.name]
    writes[suffix]()
    assert path.stat().st_size > 500 and os.listdir(tmp_path) == [path.name]


def test_what_takes_its_place_has_its_mode_and_stands_behind_its_links(tmp_path: Path) -> None:
    path, link = tmp_path / "file.txt", tmp_path / "link.txt"
    path.write_text("old")
    path.chmod(0o640)
    link.symlink_to(path)
    with replacing(link, "text") as beside:
        beside.write_text("new")
    assert path.read_text() == "new" and path.stat().st_mode & 0o777 == 0o640 and link.is_symlink()


def test_what_is_raised_meanwhile_goes_through(tmp_path: Path) -> None:
    path = tmp_path / ("n" * 240 + ".txt")
    path.write_text("old")
    with pytest.raises(KeyboardInterrupt), replacing(path, "text") as beside:
        beside.write_text("new")
        raise KeyboardInterrupt
    assert path.read_text() == "old" and os.listdir(tmp_path) == [path.name]


def test_what_cannot_be_replaced_is_said(tmp_path: Path) -> None:
    for path, why in (
        (tmp_path, "directory"),
        (tmp_path / "none" / "file", "no such"),
        (Path(os.devnull), "regular"),
    ):
        with pytest.raises(lw.FileError, match=why), replacing(path, "text"):
            raise AssertionError("not reached")


def writers() -> list[tuple[str, Callable[[Any], object]]]:
    result = lw.simulate(mechanisms.pendulum(), 0.1, step=1e-2, progress=False)
    plot = partial(result.plot, kind="energy")  # has one panel
    return [("csv", result.to_csv), ("html", result.view), ("png", plot), ("h5", result.save)]


@pytest.mark.parametrize("name", ["n" * 245, "\udcff", "\u00fc" * 120, "name."])
def test_every_name_that_a_file_can_have_is_written(name: str, tmp_path: Path) -> None:
    for suffix, write in writers():
        write(tmp_path / f"{name}.{suffix}")
    assert len(list(tmp_path.iterdir())) == 4
    dict(writers())["png"](tmp_path / name)
    assert len(list(tmp_path.iterdir())) == 4 + (name == "name.")


@pytest.mark.parametrize("name", ["n" * 300, "a\0b", "file/inside"])
def test_what_no_file_can_be_called_is_said(name: str, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for suffix, write in writers():
        with pytest.raises(lw.FileError):
            write(f"{tmp_path}/{name}.{suffix}")
