"""Result files as they are read: see `writing` for what is in them.

A file is readable whatever ended the run, and also when its end is missing (a copy that broke off, a machine
that lost power) or anything in it is another than was written: the frames before the first gap count, and the
manifest says what is `missing`. Everything is compared with its digest before anything is given out.
"""

from __future__ import annotations

import io
import json
import math
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import h5py
import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import FileError, cause
from linkwork.motion.former_names import renamed_manifest, renamed_statistics
from linkwork.motion.header import MODEL_NAMES, NO_END, Header
from linkwork.motion.records import Checkpoint, Occurrence
from linkwork.results import checkpoints, digests, heaps
from linkwork.results.indexing import to_read
from linkwork.results.shapes import read_shapes
from linkwork.results.writing import FORMAT, MODEL_ARRAYS, VERSION

#: In HDF5's message about a file of another kind, and what is said instead.
NO_SIGNATURE = "file signature not found"
NO_HDF5 = "is no HDF5 file; give one that a run has written"

#: Files of earlier versions have none; their manifest says so.
FIRST_WITH_DIGESTS = 4
#: Of a file that was cut off and has frames of a run that did not end, all of them.
CUT_OFF = "the end of the file, and what was there"

NO_DIGESTS = "none in the file of an earlier version that this was read from: damage there goes unseen"

Found = TypeVar("Found")


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
        """As of an array; little but the part asked for is read. IndexError: there is none such."""
        expected = np.broadcast_to(np.False_, self.shape)[key]
        if not expected.size:
            return np.zeros(expected.shape)
        read, of_read = to_read(key, self.shape)
        with _opened(self.path) as file:
            if file.attrs["run"] != self.run:
                raise FileError(
                    f"result '{self.path}': was replaced by another run since it was loaded", code="changed"
                )
            values: Floats = np.asarray(file[self.group][self.name][read], dtype=float)[of_read]
            return values

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
    checkpoint: Checkpoint | checkpoints.StoredCheckpoint | None
    damage: tuple[str, ...] = ()  #: what the file has lost, the end of a run that did not end apart


class _Content(NamedTuple):
    """What is whole of a file beside its header."""

    frames: int
    events: list[Occurrence]
    statistics: dict[str, Any]
    finer: tuple[float, int] | None  #: factor and frames
    notes: dict[str, Any]  #: for the manifest
    checkpoint: Checkpoint | checkpoints.StoredCheckpoint | None = None


def read(path: str | os.PathLike[str], *, written: Header | None = None) -> StoredRun:
    """The result in a file, finished or not; the frames stay on disk until asked for.

    written  the file was written a moment ago, with this header: only what comes after it is read, no digest
             is compared, and the checkpoint stays on disk, too

    FileError: no such file, one of another kind, or one that is damaged before the first frame.
    """
    path = Path(path)
    with _failures(path), _damaged(path), _open(path) as file, _looked_through(path, written is not None):
        has_digests = _check_kind(path, file)
        size = path.stat().st_size
        if written is not None:
            header = _as_of_a_file(written, file)
            content = _as_it_is(file, size)._replace(
                checkpoint=checkpoints.StoredCheckpoint(path.absolute(), str(file.attrs["run"]))
            )
        elif has_digests:
            start = _check_head(path, file, size)
            header = _read_header(file)
            content = _compared(file, header, start, size)
        else:
            header = _read_header(file)
            checkpoint = _or_none(lambda: checkpoints.read(file, str(file.attrs["run"]), size))
            notes = {"digests": NO_DIGESTS} | ({"missing": [CUT_OFF]} if _is_cut_off(file) else {})
            content = _as_it_is(file, size)._replace(notes=notes, checkpoint=checkpoint)
        run = str(file.attrs["run"])
    if content.notes:
        missing = [*header.manifest.get("missing", ()), *content.notes.get("missing", ())]
        notes = content.notes | ({"missing": missing} if missing else {})
        header = replace(header, manifest={**header.manifest, **notes})
    return _stored(path.absolute(), run, header, content)  # the process may go to another folder


def _stored(path: Path, run: str, header: Header, content: _Content) -> StoredRun:
    def fields(group: str, count: int) -> dict[str, StoredField]:
        shapes = header.frame_shapes().items()
        return {name: StoredField(path, run, name, (count, *shape), group) for name, shape in shapes}

    finer = None if content.finer is None else (content.finer[0], fields("finer", content.finer[1]))
    frames = fields("frames", content.frames)
    checkpoint = content.checkpoint
    if checkpoint is None and (not content.statistics or content.statistics.get("failed", False)):
        checkpoint = _or_none(lambda: checkpoints.read_beside(path, run))
    if isinstance(checkpoint, Checkpoint) and not (
        content.frames and checkpoint.t <= frames["t"][content.frames - 1]
    ):
        checkpoint = None
    damage = tuple(it for it in content.notes.get("missing", ()) if it != NO_END)
    return StoredRun(run, header, content.statistics, frames, content.events, finer, checkpoint, damage)


def _check_kind(path: Path, file: h5py.File) -> bool:
    """Whether it has digests. FileError: it is no result, or none that this linkwork knows."""
    if file.attrs.get("format") != FORMAT:
        raise FileError(
            f"result '{path}': is not a result file of linkwork; give one that a run has written",
            code="not_a_result",
        )
    version = int(file.attrs["version"])
    if version > VERSION:
        raise FileError(
            f"result '{path}': has version {version}, this linkwork reads up to {VERSION}; update linkwork",
            code="not_a_result",
        )
    if version < 1:
        raise _damage(path, f"version {version}")
    return version >= FIRST_WITH_DIGESTS or digests.DIGEST in file.attrs


def _check_head(path: Path, file: h5py.File, size: int) -> int:
    """The digest of the head, from which the others start. FileError: it is not what was written."""
    start = int(file.attrs[digests.DIGEST])
    if digests.head(file, size) != start:
        raise _damage(path, "the model or the manifest is not what was written")
    return start


def _as_it_is(file: h5py.File, size: int) -> _Content:
    """Without digests, or trusting them; without the checkpoint."""
    count = _frames_with_time(file["frames"]["t"], _frames_on_disk(file["frames"], size))
    finer = (float(file["finer"].attrs["factor"]), len(file["finer"]["t"])) if "finer" in file else None
    statistics = renamed_statistics(json.loads(file.attrs.get("statistics") or "{}"))
    return _Content(count, _read_events(file), statistics, finer, {})


def _compared(file: h5py.File, header: Header, start: int, size: int) -> _Content:
    """What agrees with its digest, and what does not."""
    missing: list[str] = []
    rows = _or_none(lambda: digests.rows(file[digests.BLOCKS], size)) or []
    whole = digests.whole_frames(file["frames"], rows, start, size)
    last = rows[whole - 1] if whole else digests.Row(0, 0, start, start)
    text, finer_digest = _or_none(lambda: str(file.attrs["statistics"])), 0
    finer = None
    if "finer" in file:
        finer_digest = _or_none(lambda: int(file["finer"].attrs[digests.DIGEST])) or 0
        finer = _or_none(lambda: _read_finer(file["finer"], start, finer_digest, size))
        if finer is None:
            missing.append("the second, finer run")
    kept = _or_none(lambda: checkpoints.digest_of(file)) or 0
    checkpoint = _or_none(lambda: checkpoints.read(file, str(file.attrs["run"]), size)) if kept else None
    if kept and checkpoint is None:
        missing.append("what a run that goes on to the last bit begins with")
    closed = bool(text) and _or_none(lambda: int(file.attrs[digests.CLOSING])) == digests.closing(
        text or "", last, finer_digest, kept
    )
    events = _whole_events(file, rows, start, last.events, size, missing)
    if not closed:
        missing.append(_lost_end(file["frames"], last.frames, whole < len(rows), text))
    statistics = renamed_statistics(json.loads(text)) if closed and text else {}
    notes = {"missing": missing} if missing else {}
    return _Content(last.frames, events, statistics, finer, notes, checkpoint)


def _lost_end(frames: h5py.Group, whole: int, more: bool, statistics: str | None) -> str:
    """Frames that are there or should be, but are not whole; without them what says how the run ended.

    statistics  empty until the run ends; None: they cannot be read
    """
    if len(frames["t"]) > whole or (more and statistics != ""):
        after = f" after t = {float(frames['t'][whole - 1]):g} s" if whole else ""
        return f"the frames{after} from number {whole} on, and the statistics"
    if statistics != "":
        return "the statistics"
    return CUT_OFF if _is_cut_off(frames.file) else NO_END


def _is_cut_off(file: h5py.File) -> bool:
    """Whether it is shorter than HDF5 made it: see `_open`."""
    return bool(file.driver == "fileobj")


def _whole_events(
    file: h5py.File, rows: list[digests.Row], start: int, count: int, size: int, missing: list[str]
) -> list[Occurrence]:
    """The first `count`, or fewer and a word on that in `missing`."""
    events = (_or_none(lambda: _read_events(file, size)) or []) if count else []
    whole = min(count, digests.whole_events(events, rows, start))
    if whole < count:
        missing.append(f"the events from number {whole} on, of {count}")
    return events[:whole]


def _read_finer(group: h5py.Group, start: int, digest: int, size: int) -> tuple[float, int] | None:
    """None: it is not what was written."""
    if digests.of_finer(group, start, size) != digest:
        return None
    return float(group.attrs["factor"]), len(group["t"])


def _or_none(find: Callable[[], Found]) -> Found | None:
    """What a damaged file may have lost; HDF5, JSON and numpy each have their own words for it."""
    try:
        return find()
    except Exception:
        return None


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
    manifest = renamed_manifest(json.loads(file.attrs["manifest"]))
    return Header(manifest=manifest, shapes=read_shapes(model), curves=curves, **values)


def _as_of_a_file(written: Header, file: h5py.File) -> Header:
    """The header that was written to a file, as if it had been read from it."""
    manifest = json.loads(file.attrs["manifest"])
    return replace(written, manifest=manifest, expected_frames=None).detached()


def _read_events(file: h5py.File, limit: float = math.inf) -> list[Occurrence]:
    """ValueError: they are larger than `limit` [bytes]."""
    if "events" not in file or "t" not in file["events"]:
        return []
    group = file["events"]
    for dataset in group.values():
        digests.check_size(dataset, limit)
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
    if not _is_cut_off(frames.file):
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
def _looked_through(path: Path, trusted: bool) -> Iterator[None]:
    """ValueError: HDF5 would not come to an end with what is in the file, which is open: no run writes it."""
    if not trusted:
        heaps.check(path)
    yield


@contextmanager
def _damaged(path: Path) -> Iterator[None]:
    """FileError: whatever is raised by what is read from the file, once that is open."""
    try:
        yield
    except (FileError, OSError, RuntimeError, KeyError):  # told by `_failures`
        raise
    except Exception as error:
        raise _damage(path, cause(error)) from error


def _damage(path: Path, what: str) -> FileError:
    return FileError(f"result '{path}': is damaged: {what}; copy it again, or run again", code="not_readable")


@contextmanager
def _opened(path: Path) -> Iterator[h5py.File]:
    with _failures(path), _open(path) as file:
        yield file


@contextmanager
def _failures(path: Path) -> Iterator[None]:
    """FileError: what the operating system or HDF5 says."""
    try:
        yield
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
        raise _damage(path, cause(error)) from error


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
