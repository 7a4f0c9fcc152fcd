"""Results on disk: HDF5, written while the run goes on, readable however it ends.

    /          attributes `format`, `version`, `run` (an identity), `manifest` (JSON), and
               `statistics` (JSON), empty before the end
    /frames/   q (k, n, 7), v and vdot (k, n, 6), lambda (k, m), kinetic, potential and work (k,),
               violation (k, 3), history (k, h), reaction_force and reaction_torque (k, joints, 3), t (k,)
    /model/    the arrays of `Header`, the names, those of history where there is any, the shapes of bodies
               that have their own, and the curves of joints, by their index
    /finer/    of a run that was verified: the fields of /frames/ by a finer run, at their times, and the
               attribute `factor` by which the difference is an error
    /events/   where there were any: q (e, 2, n, 7) and v (e, 2, n, 6) before and after, name and t (e,)
    /checkpoint  what the run can go on from to the last bit, see `checkpoints`
    /digests   of all this, see `digests`; not in files of versions 1 to 3

Nothing is left to HDF5 that can fail, as it does not survive that: the head is made in memory and written as
bytes, and room for whatever follows is reserved before HDF5 is told of it.

The frames that count are those with a time: every other field is written and flushed *before* `t` grows, so
a run that is killed leaves whole frames only. Room on the disk is reserved before a frame is written; when
there is none the file is closed with what it has. The reactions are stored, not recomputed: what was recorded
needs no model to be read, so a mechanism driven by a Python function (which no file can hold) loads like any
other. Fields and arrays have an attribute
`units` where they have one. A field of no width (the multipliers of a free body) is not stored.
"""

from __future__ import annotations

import errno
import json
import math
import os
import shutil
import time
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import ModuleType, TracebackType
from typing import Any, Self

import h5py
import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork.accuracy.verification import Finer
from linkwork.arguments import path as path_of
from linkwork.arrays import Floats
from linkwork.errors import FileError, cause, unwritable
from linkwork.motion.header import MODEL_NAMES, UNITS, Header, record_reactions
from linkwork.motion.records import Checkpoint, Occurrence
from linkwork.replacement import replacing
from linkwork.results import checkpoints, digests
from linkwork.results.shapes import write_shapes

fcntl: ModuleType | None
try:
    import fcntl
except ImportError:  # no such locks on Windows
    fcntl = None

FORMAT, VERSION = "linkwork result", 4

#: Together with the driver's chunk of frames, a kill loses at most the last second.
FLUSH_SECONDS = 0.5

#: A kill costs a run that is resumed so much more.
CHECKPOINT_SECONDS = 5.0

#: Frames that are larger are written in pieces, their fields, and one that is interrupted is not kept; larger
#: checkpoints stay beside an output that is closed in a hurry.
LARGE_BYTES, LARGE_CHECKPOINT_BYTES = 2**26, 2**24

#: Of the head, between two looks at signals [bytes].
HEAD_PIECE_BYTES = 2**24

#: Names that are encoded between two such looks.
NAMES = 50_000

#: HDF5's index of chunks splits beyond 64 chunks, and is inconsistent for an instant.
CHUNKS = 48
CHUNK_BYTES = (4096, 32 * 2**20)

#: Room kept for HDF5's own records and the closing attributes [bytes].
MARGIN_BYTES = 256 * 1024

#: Of it what the closing attributes take beside the statistics themselves.
CLOSING_BYTES = MARGIN_BYTES // 4

#: While there is room for so many more pieces of a run, and no others, checkpoints are kept of each.
LAST_PIECES = 4

MODEL_ARRAYS = (
    "gravity",
    "mass",
    "inertia",
    "q0",
    "v0",
    "joint_rows",
    "joint_bodies",
    "joint_frame",
    "joint_origin",
    "reaction_unique",
    "redundant_rows",
    "joint_first_parameter",
    "joint_parameters",
    "force_bodies",
    "force_frame",
    "force_origin",
    "force_first_parameter",
    "force_parameters",
    "breaks",
)


class ResultWriter:
    """Appends frames to a result file.

    FileError: before the run, where the path cannot be written or the disk has no room for the expected
    frames; during it, where the disk is full (the frames so far stay readable).
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        header: Header,
        *,
        run: str | None = None,
        checkpoint: Callable[[], Checkpoint | None] = lambda: None,
        pause: Callable[[], None] = lambda: None,
    ) -> None:
        """
        checkpoint  for the last frame that the run gave out: where that could not be written, that of the
                    last one which was
        pause       called between the pieces of the head, of large frames, and of what is written after
                    them. What it raises goes through: the frame in which that was is not kept, and `close`
                    in a hurry is to follow
        """
        self.path = path_of(path, "result")
        self._header = header
        self._frames = 0
        self._pending: list[Floats] = []
        self._last_t = -math.inf  # of the frames [s]
        self._failure: FileError | None = None
        self._checkpoint, self._checkpoint_due = checkpoint, 0.0
        self._last_checkpoint: Checkpoint | None = None  # while there is hardly any room left
        self._begun: Path | None = None  # the name of the file until it takes the place of one that is there
        self._goes_on = False  # whether what was closed has a checkpoint
        self._pause = pause
        self._beside_bytes = 0  # of the last checkpoint that was written beside
        self._large = _frame_bytes(header) > LARGE_BYTES
        self._flushed_at = time.monotonic()
        self._size = self._reserved = 0  # of the file [bytes]: with all chunks begun so far; made sure of
        self._fields: dict[str, h5py.Dataset] = {}
        self._chunks: dict[str, tuple[int, ...]] = {}
        self._check_room(_frame_bytes(header) * (header.expected_frames or 1) + MARGIN_BYTES)
        with self._failures():
            self._begin(run or uuid.uuid4().hex)

    @property
    def begun(self) -> bool:
        """Whether the file is there: until its first frame one that it replaces is."""
        return self._begun is None

    @property
    def run(self) -> str:
        """The identity of what is written."""
        return self._run

    def write(self, chunk: Mapping[str, ArrayLike]) -> None:
        """Append frames: the arrays of `Simulation.advance`, reactions included or to be computed here."""
        t = np.asarray(chunk["t"], dtype=float)
        if not len(t):
            return
        if self._failure is not None:
            raise self._failure
        recorded = record_reactions(self._header, chunk)
        values = {name: np.reshape(recorded[name], (len(t), *it[1:])) for name, it in self._chunks.items()}
        start, end = self._frames, self._frames + len(t)
        self._reserve_or_end(
            (-(-end // chunk[0]) + -start // chunk[0]) * math.prod(chunk) * 8
            for chunk in self._chunks.values()
        )
        with self._failures(), self._whole_or_not():
            self._take_place()
            for name, dataset in self._fields.items():
                if name != "t":
                    dataset.resize(end, axis=0)
                    dataset[start:end] = values[name]
                    if self._large:
                        self._pause()
        self._frames = end
        self._blocks.add_frames(values, len(t))
        self._pending.append(t)
        self._last_t = float(t[-1])
        self._last_checkpoint = self._checkpoint() if self._is_nearly_full(len(t)) else None
        if self._large or time.monotonic() - self._flushed_at > FLUSH_SECONDS:
            self.flush()

    @contextmanager
    def _whole_or_not(self) -> Iterator[None]:
        """Frames that are being written are taken back where that is interrupted."""
        try:
            yield
        except KeyboardInterrupt:
            for name, dataset in self._fields.items():
                if name != "t" and len(dataset) > self._frames:
                    dataset.resize(self._frames, axis=0)
            raise

    def write_events(self, occurrences: Sequence[Occurrence]) -> None:
        """Append events; like that of frames, their `t` grows last."""
        if not occurrences:
            return
        if self._failure is not None:
            raise self._failure
        fields = _event_fields(self._header.body_count)
        sizes = {name: _event_bytes(shape) for name, (shape, _) in fields.items()}
        self._reserve_or_end(
            max(len(occurrences) * size, CHUNK_BYTES[0]) + max(size, CHUNK_BYTES[0])
            for size in sizes.values()
        )
        with self._failures():
            group = self._file.require_group("events")
            for name, (shape, kind) in fields.items():
                if name not in group:
                    chunk = max(1, CHUNK_BYTES[0] // sizes[name]), *shape
                    group.create_dataset(name, (0, *shape), kind, maxshape=(None, *shape), chunks=chunk)
                dataset = group[name]
                start = len(dataset)
                dataset.resize(start + len(occurrences), axis=0)
                dataset[start:] = [_event_value(it, name) for it in occurrences]
        self._blocks.add_events(occurrences)

    def flush(self) -> None:
        """Bring the frames so far to the file, and now and then a checkpoint."""
        self._flush_frames()
        if self._flushed_at >= self._checkpoint_due:
            self._write_checkpoint_beside()

    def _flush_frames(self) -> None:
        """First data and digests, then the times that count."""
        self._check_mine()
        with self._failures():
            self._write_digests()
            self._file.flush()
            if self._pending:
                t = self._fields["t"]
                start = len(t)
                t.resize(self._frames, axis=0)
                t[start:] = np.concatenate(self._pending)
                self._pending.clear()
                self._file.flush()
        self._flushed_at = time.monotonic()

    def _write_checkpoint_beside(self) -> None:
        """Without it the run can be gone on from, but not to the last bit: no reason to end."""
        checkpoint = self._checkpoint()
        if checkpoint is None:
            return
        self._checkpoint_due = self._flushed_at + CHECKPOINT_SECONDS
        pause = self._pause if self._large else lambda: None
        with suppress(OSError):
            checkpoints.write_beside(self._target, checkpoint, self._run, pause)
            self._beside_bytes = len(checkpoint.state)

    def _write_digests(self) -> None:
        self._blocks.seal()
        rows = self._blocks.take_rows()
        if rows:
            dataset = self._file[digests.BLOCKS]
            start = len(dataset)
            dataset.resize(start + len(rows), axis=0)
            dataset[start:] = rows

    def close(self, statistics: Mapping[str, Any] | None = None, *, hurried: bool = False) -> None:
        """End the file; without `statistics` it is marked as interrupted.

        hurried  a large checkpoint that is beside stays there, and no later one is written; nor is one where
                 there is no frame, from which no run goes on
        """
        if not self._file:
            return
        if not self._takes_place_at_end(statistics):
            return self._release()
        stays = hurried and self._beside_bytes > LARGE_CHECKPOINT_BYTES
        checkpoint = None if stays else self._checkpoint()
        if self._frames and checkpoint is not None and checkpoint.t > self._last_t:
            checkpoint = self._last_checkpoint  # the later one is of frames that did not get here
            stays = checkpoint is None
        try:
            self._flush_frames()
        except FileError:
            self._release()
            raise
        with self._failures():
            try:
                if stays or not (self._frames or not hurried):
                    checkpoint = None
                if checkpoint is not None and self._write_checkpoint(checkpoint):
                    self._goes_on, checkpoint = True, None
                self._write_end(statistics)
            finally:
                self._release()
            ended = statistics is not None and not statistics.get("failed", False)
            if checkpoint is not None and not ended:  # there is room beside now, perhaps
                with suppress(OSError):
                    checkpoints.write_beside(self._target, checkpoint, self._run)
            elif not stays:
                checkpoints.beside(self._target).unlink(missing_ok=True)
            self._goes_on = self._goes_on or checkpoints.beside(self._target).exists()

    def _takes_place_at_end(self, statistics: Mapping[str, Any] | None) -> bool:
        """Whether the file has its name: without a frame it takes a place only to say how the run ended."""
        if statistics is not None and self._failure is None:
            try:
                with self._failures():
                    self._take_place()
            except FileError:
                self._release()
                raise
        return self._begun is None

    def _write_end(self, statistics: Mapping[str, Any] | None) -> None:
        try:
            if statistics is not None:
                text = json.dumps(dict(statistics), default=_plain)
                self._allot(self._file.id.get_filesize() + 2 * len(text) + CLOSING_BYTES)
                _write_statistics(self._file, text, self._blocks.last)
        finally:
            self._file.flush()
            os.ftruncate(self._descriptor, self._file.id.get_filesize())

    def _release(self) -> None:
        self._file.close()
        os.close(self._descriptor)
        if self._begun is not None:
            self._begun.unlink(missing_ok=True)

    def _write_checkpoint(self, checkpoint: Checkpoint) -> bool:
        """Whether there was room for it."""
        try:
            self._allot(self._file.id.get_filesize() + 2 * len(checkpoint.state) + MARGIN_BYTES)
        except (FileError, OSError):
            return False
        checkpoints.write(self._file, checkpoint, self._run)
        return True

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, tb: TracebackType | None
    ) -> None:
        try:
            self.close()
        except FileError:
            if error is None:
                raise

    def _begin(self, run: str) -> None:
        """Create the file; it takes its name when it can be read: a kill leaves no half of a header."""
        target = Path(os.path.realpath(self.path))
        mine = os.access in os.supports_effective_ids
        if target.exists() and not os.access(target, os.W_OK, effective_ids=mine):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        if _is_being_written(target):
            raise busy(self.path)
        self._target, self._run = target, run
        head, digest = self._head(run)
        begun = target.with_name(f".{target.name}.{run}.begun")
        self._descriptor = os.open(
            begun, os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666
        )
        try:
            _write_whole(self._descriptor, head, self._pause)
            self._reserved = len(head)
            self._file = h5py.File(begun, "r+")  # before room is reserved, which would be the file's to HDF5
            self._fields = {name: self._file["frames"][name] for name in self._chunks}
            # room for the first frames
            self._allot(_with_margin(len(head) + 8 * sum(map(math.prod, self._chunks.values()))))
            self._begun, self._is_new = begun, not target.exists()
            if self._is_new:
                self._take_place()
        except BaseException:
            if self._fields:
                self._file.close()
            os.close(self._descriptor)
            begun.unlink(missing_ok=True)
            raise
        self._blocks = digests.Blocks(digest, list(self._fields))

    def _take_place(self) -> None:
        """From the first frame on the file has its name: one that is there gives way when that has room.

        FileError: another run has begun to write it.
        """
        if self._begun is None:
            return
        if _is_being_written(self._target):
            self._failure = busy(self.path)
            raise self._failure
        if self._target.exists():
            shutil.copymode(self._target, self._begun)
        checkpoints.beside(self._target).unlink(missing_ok=True)
        os.replace(self._begun, self._target)
        self._begun = None

    def _head(self, run: str) -> tuple[bytes, int]:
        """The file before its first frame, and its digest."""
        with h5py.File(f"{run}.head", "w", driver="core", backing_store=False) as file:
            digest = self._write_header(file, run)
            self._pause()
            file.flush()
            self._pause()
            image = file.id.get_file_image()
            self._pause()
            return image, digest

    def _write_header(self, file: h5py.File, run: str) -> int:
        """Its digest."""
        attributes = {"format": FORMAT, "version": VERSION, "run": run}
        file.attrs.update(attributes)
        file.attrs["manifest"] = json.dumps(dict(self._header.manifest), default=_plain)
        model = file.create_group("model")
        for name in MODEL_ARRAYS:
            model[name] = np.asarray(getattr(self._header, name))
            _name_unit(model[name], name)
            self._pause()
        for name in MODEL_NAMES:
            if name == "history_names" and not self._header.history_count:
                continue  # as the field itself
            model[name] = _encoded(getattr(self._header, name), self._pause)
            self._pause()
        write_shapes(model, self._header.shapes)
        for joint, line in self._header.curves.items():
            model[f"curves/{joint}"] = line
        frames = file.create_group("frames")
        for name, shape in self._header.frame_shapes().items():
            if math.prod(shape):
                chunk = (_chunk_frames(shape, self._header.expected_frames), *shape)
                self._chunks[name] = chunk
                frames.create_dataset(
                    name, (0, *shape), "f8", maxshape=(None, *shape), chunks=chunk, fillvalue=math.nan
                )
                _name_unit(frames[name], name)
        checkpoints.make_place(file, self._header.body_count)
        rows = digests.CHUNK_ROWS, digests.COLUMNS
        file.create_dataset(digests.BLOCKS, (0, rows[1]), "u8", maxshape=(None, rows[1]), chunks=rows)
        digest = file.attrs[digests.DIGEST] = digests.head(file, pause=self._pause)
        file.attrs.update({"statistics": "", digests.CLOSING: 0})
        return digest

    def _reserve_or_end(self, sizes: Iterable[int]) -> None:
        """FileError, with the file closed: there is no room for so much [bytes].

        One that has no frame is removed, unless it has taken the place of another.
        """
        try:
            self._reserve(sizes)
        except FileError as error:
            self._failure = error
            had_some = self._frames and self._checkpoint() is not None
            self.close()
            if self._is_new and not self._frames and error.code != "replaced":
                self._target.unlink(missing_ok=True)
            if not had_some or self._goes_on:
                raise
            told = "a run that starts there is not that of the whole to the last bit"
            self._failure = FileError(f"{error}; {told}", code=error.code)
            raise self._failure from error

    def _reserve(self, sizes: Iterable[int]) -> None:
        """Make sure of the room for chunks of these sizes [bytes] before HDF5 is touched.

        Its own failure to write would leave the file half changed, and comes late: HDF5 holds chunks back.
        """
        with self._failures():
            self._size = max(self._size, self._file.id.get_filesize()) + sum(sizes)
            needed = _with_margin(self._size)
            if needed > self._reserved:
                self._check_mine()
                self._allot(needed)

    def _allot(self, needed: int) -> None:
        """The blocks of so large a file [bytes]. FileError, OSError: there is no room for them."""
        if needed <= self._reserved:
            return
        self._check_room(needed, self._taken())
        _allocate(self._descriptor, self._reserved, needed)
        self._reserved = needed

    def _taken(self) -> int:
        """Room that the file takes up, with what is reserved [bytes]."""
        return os.fstat(self._descriptor).st_blocks * 512

    def _is_nearly_full(self, frames: int) -> bool:
        """Whether few more pieces of so many frames have room."""
        with suppress(OSError):
            room = LAST_PIECES * frames * _frame_bytes(self._header) + MARGIN_BYTES
            return shutil.disk_usage(self.path.parent).free < room
        return False

    def _check_mine(self) -> None:
        """FileError: the output was removed, or what has its name by now is another file."""
        try:
            found = os.stat(self._begun or self.path)
        except FileNotFoundError:
            raise replaced(self.path, "was moved or removed") from None
        if not os.path.samestat(found, os.fstat(self._descriptor)):
            raise replaced(self.path, "was replaced by another file")

    def _check_room(self, needed: int, taken: int = 0) -> None:
        """FileError: a file of that size has no room; `taken` of it is reserved [bytes].

        The error has what is free when it is told: what is reserved and has no frames is given back.
        """
        with self._failures():
            there = shutil.disk_usage(self.path.parent).free + taken
        if needed > there:
            stays = min(taken, self._file.id.get_filesize()) if self._frames else 0
            found = f"{_bytes(needed - stays)} needed, {_bytes(there - stays)} free{self._kept()}"
            raise FileError(
                f"output '{self.path}': no room: {found}; make room, choose another place, or record "
                "fewer frames",
                code="no_room",
            )

    @contextmanager
    def _failures(self) -> Iterator[None]:
        """What the operating system or HDF5 reports, as one line about this file."""
        try:
            yield
        except (OSError, RuntimeError) as error:
            raise FileError(
                f"output '{self.path}': cannot be written: {cause(error, self._kept())}",
                code="not_writable",
            ) from error

    def _kept(self) -> str:
        return f"; the {self._frames} frames so far are kept" if self._frames else ""


def save(
    path: str | os.PathLike[str],
    header: Header,
    frames: Mapping[str, Any],
    statistics: Mapping[str, Any],
    run: str,
    events: Sequence[Occurrence] = (),
    checkpoint: Checkpoint | None = None,
    finer: Finer | None = None,
) -> None:
    """Write a whole result: to a file beside, then renamed, so that `path` is never half written; it may be
    the one that frames and the finer run are read from."""
    count = len(frames["t"])
    with replacing(path, "output") as beside:
        try:
            with ResultWriter(beside, header, run=run, checkpoint=lambda: checkpoint) as writer:
                block = max(1, 2**26 // _frame_bytes(header))
                for start in range(0, count, block):
                    writer.write({name: values[start : start + block] for name, values in frames.items()})
                writer.write_events(events)
                writer.close(statistics)
            if finer is not None:
                add_finer(beside, finer, statistics)
        except FileError as error:
            raise FileError(str(error).replace(str(beside), str(path)), code=error.code) from error


def add_finer(path: str | os.PathLike[str], finer: Finer, statistics: Mapping[str, Any]) -> None:
    """To the file of a run that was verified, with what is known by then. FileError."""
    finer.result.reactions()
    text = json.dumps(dict(statistics), default=_plain)
    try:
        with h5py.File(path, "r") as file:
            found = {name: finer.result.recorded(name) for name in file["frames"]}
        with _room(path, sum(field.nbytes for field in found.values()) + 2 * len(text) + MARGIN_BYTES):
            with h5py.File(path, "r+") as file:
                group = file.create_group("finer")
                for name, field in found.items():
                    group.create_dataset(name, data=field)
                group.attrs["factor"] = finer.factor
                digest = digests.of_finer(group, file.attrs[digests.DIGEST])
                group.attrs[digests.DIGEST] = digest
                _write_statistics(file, text, digests.last_row(file), digest)
                file.flush()
                end = file.id.get_filesize()
            os.truncate(path, end)
    except OSError as error:
        raise unwritable("output", path, error) from error


@contextmanager
def _room(path: str | os.PathLike[str], count: int) -> Iterator[None]:
    """So many bytes more in a file; none where that fails. OSError: there is no room for them."""
    before = os.path.getsize(path)
    descriptor = os.open(path, os.O_RDWR | getattr(os, "O_BINARY", 0))
    try:
        _allocate(descriptor, before, before + count)
        yield
    except OSError:
        if os.fstat(descriptor).st_size == before + count:  # nothing was written
            os.ftruncate(descriptor, before)
        raise
    finally:
        os.close(descriptor)


def _write_statistics(file: h5py.File, text: str, last: digests.Row, finer: int = 0) -> None:
    """With the digest that makes them count.

    In the place that is kept for them: HDF5 would move other attributes to the end of the file to make room
    for new ones, and a cut file would lose those.
    """
    file.attrs.modify("statistics", text)
    closing = digests.closing(text, last, finer, checkpoints.digest_of(file))
    file.attrs.modify(digests.CLOSING, closing)


def _event_fields(bodies: int) -> dict[str, tuple[tuple[int, ...], Any]]:
    """Shape and type of what is kept of one event; `t` comes last."""
    return {
        "q": ((2, bodies, 7), "f8"),
        "v": ((2, bodies, 6), "f8"),
        "name": ((), h5py.string_dtype()),
        "t": ((), "f8"),
    }


def _event_bytes(shape: tuple[int, ...]) -> int:
    """Of one field of one event; a name is counted with what HDF5 needs beside it."""
    return 8 * math.prod(shape) if shape else 64


def busy(path: Path) -> FileError:
    return FileError(
        f"output '{path}': another run is writing it; give each run an output of its own", code="busy"
    )


def replaced(path: Path, what: str) -> FileError:
    """The output of a run is not its own any more."""
    return FileError(
        f"output '{path}': {what} during the run: its frames are lost, unless the file has another name now; "
        "give each run an output of its own",
        code="replaced",
    )


def _name_unit(dataset: h5py.Dataset, name: str) -> None:
    if name in UNITS:
        dataset.attrs["units"] = UNITS[name]


def _event_value(it: Occurrence, name: str) -> Any:
    if name in ("q", "v"):
        return [getattr(it, f"{name}_before"), getattr(it, f"{name}_after")]
    return getattr(it, name)


def _chunk_frames(shape: tuple[int, ...], expected: int | None) -> int:
    """Frames in a chunk of a field: few chunks in the file, none too small or too large."""
    width = 8 * math.prod(shape)
    smallest, largest = (max(1, limit // width) for limit in CHUNK_BYTES)
    return min(max(smallest, -(-(expected or 0) // CHUNKS)), largest)


def _with_margin(size: int) -> int:
    return size + size // 50 + MARGIN_BYTES  # a chunk's entry in the index takes less than 2 %


def _frame_bytes(header: Header) -> int:
    return 8 * sum(math.prod(shape) for shape in header.frame_shapes().values())


def _is_being_written(path: Path) -> bool:
    """Whether HDF5 holds the lock that a writer has."""
    if fcntl is None or not path.exists():
        return False
    with path.open("rb") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
    return False


def _allocate(descriptor: int, start: int, end: int) -> None:
    """Give the file its blocks from start to end: writing them cannot fail then, for a quota or a limit."""
    if not hasattr(os, "posix_fallocate"):
        return
    try:
        os.posix_fallocate(descriptor, start, end - start)
    except OSError as error:
        if error.errno not in (errno.EOPNOTSUPP, errno.EINVAL):
            raise


def _write_whole(descriptor: int, content: bytes, pause: Callable[[], None]) -> None:
    """OSError: there is no room for it, or no leave."""
    view = memoryview(content)
    while view:
        pause()
        view = view[os.write(descriptor, view[:HEAD_PIECE_BYTES]) :]


def _encoded(names: Sequence[str], pause: Callable[[], None]) -> NDArray[np.bytes_]:
    texts: list[bytes] = []
    for first in range(0, len(names), NAMES):
        texts += [name.encode() for name in names[first : first + NAMES]]
        pause()
    return np.array(texts, dtype=f"S{max(map(len, texts), default=1) or 1}")


def _plain(value: Any) -> Any:
    """JSON for numpy's numbers and arrays, and text for the rest."""
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else str(value)


def _bytes(count: float) -> str:
    for unit in ("bytes", "kB", "MB", "GB"):
        if count < 1000:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} TB"
