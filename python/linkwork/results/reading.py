"""Result files as they are read: see `writing` for what is in them.

A file is readable whatever ended the run, and also when its end is missing (a copy that broke off, a machine
that lost power): the frames before the first gap count.
"""

from __future__ import annotations

import io
import json
import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import FileError, cause
from linkwork.motion.header import MODEL_NAMES, Header
from linkwork.motion.records import Occurrence
from linkwork.options import renamed
from linkwork.results.shapes import read_shapes
from linkwork.results.writing import FORMAT, MODEL_ARRAYS, VERSION

#: In HDF5's message about a file of another kind, and what is said instead.
NO_SIGNATURE = "file signature not found"
NO_HDF5 = "is no HDF5 file; give one that a run has written"


@dataclass(frozen=True)
class StoredField:
    """One field of /frames on disk. The file is open only while it is read: it may be written again."""

    path: Path
    run: str
    name: str
    shape: tuple[int, ...]
    group: str = "frames"

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, key: Any) -> Floats:
        """The part asked for, and nothing else, is read."""
        if not math.prod(self.shape[1:]):
            nothing: Floats = np.zeros(self.shape)[key]
            return nothing
        rows, *rest = key if isinstance(key, tuple) else (key,)
        backward = isinstance(rows, slice) and (rows.step or 1) < 0
        if isinstance(rows, slice):
            chosen = range(*rows.indices(len(self)))[:: -1 if backward else 1]  # HDF5 reads forward only
            rows = slice(chosen.start, chosen.stop, chosen.step)
        with _opened(self.path) as file:
            if file.attrs["run"] != self.run:
                raise FileError(
                    f"result '{self.path}': was replaced by another run since it was loaded", code="changed"
                )
            values: Floats = np.asarray(file[self.group][self.name][(rows, *rest)], dtype=float)
            return values[::-1] if backward else values

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.asarray(self[:], dtype=dtype)


@dataclass(frozen=True)
class StoredRun:
    """What `read` finds in a file."""

    run: str
    header: Header
    statistics: dict[str, Any]
    fields: dict[str, StoredField]
    events: list[Occurrence]
    finer: tuple[float, dict[str, StoredField]] | None  #: see `verification`


def read(path: str | os.PathLike[str]) -> StoredRun:
    """The result in a file, finished or not; the frames stay on disk until asked for.

    FileError: no such file, one of another kind, or one that is damaged before the first frame.
    """
    path = Path(path)
    with _opened(path) as file:
        if file.attrs.get("format") != FORMAT:
            raise FileError(
                f"result '{path}': is not a result file of linkwork; give one that a run has written",
                code="not_a_result",
            )
        if file.attrs["version"] > VERSION:
            raise FileError(
                f"result '{path}': has version {file.attrs['version']}, this linkwork reads up to {VERSION}; "
                "update linkwork",
                code="not_a_result",
            )
        run = str(file.attrs["run"])
        header = _read_header(file)
        count = _frames_with_time(file["frames"]["t"], _frames_on_disk(file["frames"], path.stat().st_size))
        statistics = _read_statistics(file)
        events = _read_events(file)
        finer = (float(file["finer"].attrs["factor"]), len(file["finer"]["t"])) if "finer" in file else None
    shapes = header.frame_shapes().items()
    fields = {name: StoredField(path, run, name, (count, *shape)) for name, shape in shapes}
    if finer is None:
        return StoredRun(run, header, statistics, fields, events, None)
    factor, count = finer
    second = {name: StoredField(path, run, name, (count, *shape), "finer") for name, shape in shapes}
    return StoredRun(run, header, statistics, fields, events, (factor, second))


def _read_header(file: h5py.File) -> Header:
    model = file["model"]
    values: dict[str, Any] = {name: model[name][()] for name in MODEL_ARRAYS if name in model}
    if file.attrs["version"] < 2:  # knows nothing of redundancy
        joints = len(values["joint_rows"]) - 1
        values |= {"reaction_unique": np.zeros(joints, bool), "redundant_rows": np.zeros(0, np.int32)}
    values.update(
        {name: [text.decode() for text in model[name][()]] for name in MODEL_NAMES if name in model}
    )
    curves = {int(joint): line[()] for joint, line in model.get("curves", {}).items()}
    if "history" in file["frames"]:  # not before version 3
        values["history_count"] = file["frames"]["history"].shape[1]
    manifest = json.loads(file.attrs["manifest"])
    manifest |= {part: renamed(manifest[part]) for part in ("options", "options_given") if part in manifest}
    return Header(manifest=manifest, shapes=read_shapes(model), curves=curves, **values)


def _read_statistics(file: h5py.File) -> dict[str, Any]:
    """By the names of today."""
    found: dict[str, Any] = json.loads(file.attrs.get("statistics", "{}"))
    if "passages" in found:
        found["singularity_crossings"] = [
            {{"taken_over": "fallback_evaluations"}.get(name, name): value for name, value in one.items()}
            for one in found.pop("passages")
        ]
    return found


def _read_events(file: h5py.File) -> list[Occurrence]:
    if "events" not in file or "t" not in file["events"]:
        return []
    group = file["events"]
    t = group["t"][()]
    names = group["name"].asstr()[: len(t)]
    return [
        Occurrence(name, float(when), q[0], v[0], q[1], v[1])
        for name, when, q, v in zip(names, t, group["q"][: len(t)], group["v"][: len(t)], strict=True)
    ]


def _frames_with_time(t: h5py.Dataset, count: int) -> int:
    """Frames before the first without a time: after a kill the end of `t` may be named but not written."""
    chunk = t.chunks[0]
    for start in range(0, count, chunk):
        try:
            gaps = ~np.isfinite(t[start : min(start + chunk, count)])
        except OSError:
            return start
        if gaps.any():
            return start + int(np.argmax(gaps))
    return count


def _frames_on_disk(frames: h5py.Group, size: int) -> int:
    """Frames of which every field lies within the `size` bytes that there are."""
    count = min(len(dataset) for dataset in frames.values())
    if frames.file.driver != "fileobj":  # nothing is missing
        return count
    for dataset in frames.values():
        starts = range(0, count, dataset.chunks[0])
        count = next((start for start in starts if _chunk_end(dataset, start) > size), count)
    return count


def _chunk_end(dataset: h5py.Dataset, start: int) -> float:
    """Where in the file the chunk that begins with frame `start` ends [bytes]; infinite where it is lost."""
    try:
        chunk = dataset.id.get_chunk_info_by_coord((start, *(0 for _ in dataset.shape[1:])))
    except RuntimeError:
        return math.inf
    return math.inf if chunk.byte_offset is None else float(chunk.byte_offset + chunk.size)


@contextmanager
def _opened(path: Path) -> Iterator[h5py.File]:
    try:
        with _open(path) as file:
            yield file
    except FileNotFoundError as error:
        raise FileError(f"result '{path}': no such file; check the path", code="not_found") from error
    except BlockingIOError as error:
        raise FileError(
            f"result '{path}': a run is writing it; read it when that has ended, or a copy", code="busy"
        ) from error
    except (OSError, RuntimeError) as error:
        why = NO_HDF5 if NO_SIGNATURE in str(error) else cause(error)
        raise FileError(f"result '{path}': cannot be read: {why}", code="not_readable") from error
    except KeyError as error:
        raise FileError(
            f"result '{path}': is damaged: {cause(error)}; copy it again, or run again", code="not_readable"
        ) from error


def _open(path: Path) -> h5py.File:
    try:
        return h5py.File(path, "r")
    except OSError as error:
        if "truncated file" not in str(error):
            raise
        return h5py.File(_Continued(path), "r")


class _Continued(io.RawIOBase):
    """A file without its end, continued by zeros: HDF5 refuses to look at one that is shorter than it was."""

    LENGTH = 2**50

    def __init__(self, path: Path) -> None:
        self._descriptor = os.open(path, os.O_RDONLY)
        self._place = 0

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._place

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        self._place = offset + {os.SEEK_SET: 0, os.SEEK_CUR: self._place, os.SEEK_END: self.LENGTH}[whence]
        return self._place

    def readinto(self, buffer: Any) -> int:
        view = memoryview(buffer).cast("B")
        found = os.pread(self._descriptor, len(view), self._place)
        view[:] = found.ljust(len(view), b"\0")
        self._place += len(view)
        return len(view)

    def close(self) -> None:
        if not self.closed:
            os.close(self._descriptor)
        super().close()
