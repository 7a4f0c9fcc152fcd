"""Digests of what is in a result file: whether a bit of it is another than was written.

    /          attribute `digest`: of the attributes of the beginning, /model/ and the shapes of /frames/;
               attribute `closing`: of `statistics`, the last row of /digests/ and the digests of /finer/ and
               of /checkpoint
    /digests   (b, 4), a row for each block of frames: how many frames and events there are up to its end, and
               a digest of its frames and one of its events, each of them chained to that of the row before
    /finer/    attribute `digest`

Digests are CRC-32 over the values as they are read, so that they cover how HDF5 finds them, too; of the
frames, which are many, over sums of 16 rows of 61 words modulo 2^64, four times as fast. A row comes
to the file before the times that make its frames count.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import h5py
import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.motion.records import Occurrence

__all__ = [
    "BLOCKS",
    "CLOSING",
    "DIGEST",
    "Blocks",
    "Row",
    "check_size",
    "closing",
    "content",
    "head",
    "rows",
    "whole_events",
    "whole_frames",
]

DIGEST, CLOSING, BLOCKS = "digest", "closing", "digests"

#: A block has at least the first [bytes], at most the second; between them this share of what is before it.
BLOCK_BYTES, BLOCK_SHARE = (8192, 2**24), 1 / 16

#: Arrays up to here are joined before they are summed [bytes].
SMALL_BYTES = 2**16

#: A power of two is not the length of a row: chunks of HDF5 that change places change the sums.
SUMMED_ROWS, ROW_WORDS = 16, 61

#: Frames that are read at a time [bytes].
SLAB_BYTES = 2**24

#: In /digests.
COLUMNS, CHUNK_ROWS = 4, 512


class Row(NamedTuple):
    """A row of /digests."""

    frames: int
    events: int
    frames_digest: int
    events_digest: int


class Blocks:
    """The rows of /digests as frames and events are written."""

    def __init__(self, start: int, fields: Sequence[str]) -> None:
        self._last = Row(0, 0, start, start)
        self._fields = field_order(fields)
        self._parts: list[list[Floats]] = []  # of the open block: all fields
        self._events = 0
        self._frame_count = self._event_count = self._bytes = self._total = 0
        self._new: list[Row] = []

    def add_frames(self, values: Mapping[str, Floats], count: int) -> None:
        """Frames that were written, all fields of them; full blocks are sealed."""
        width = sum(values[name].nbytes for name in self._fields) // count
        done = 0
        while done < count:
            least, most = BLOCK_BYTES
            limit = min(max(least, int(self._total * BLOCK_SHARE)), most)
            end = min(count, done + max(1, (limit - self._bytes) // width))
            if (end - done) * width > SMALL_BYTES:  # not copied to go with others
                self.seal()
            self._parts.append([values[name][done:end] for name in self._fields])
            self._frame_count += end - done
            self._bytes += (end - done) * width
            if self._bytes + width > limit:
                self.seal()
            done = end

    def add_events(self, occurrences: Sequence[Occurrence]) -> None:
        self._events = _of_events(occurrences, self._events)
        self._event_count += len(occurrences)

    def seal(self) -> None:
        """End the block that is open, if anything is in it."""
        if (self._frame_count, self._event_count) == self._last[:2]:
            return
        fields = [_joined_parts(parts) for parts in zip(*self._parts, strict=True)]
        self._last = _row(self._last, self._frame_count, self._event_count, fields, self._events)
        self._new.append(self._last)
        self._total += self._bytes
        self._parts = []
        self._events = self._bytes = 0

    @property
    def last(self) -> Row:
        """The row that was sealed last."""
        return self._last

    def take_rows(self) -> list[Row]:
        """Those that are not in the file yet."""
        taken, self._new = self._new, []
        return taken


def head(file: h5py.File, limit: float = np.inf, pause: Callable[[], None] = lambda: None) -> int:
    """Of all that is written before the first frame. ValueError: an array is larger than `limit` [bytes].

    `pause` is called between pieces; what it raises goes through.
    """
    found = 0
    for name in ("format", "version", "run", "manifest"):
        found = _crc(f"{name} {file.attrs[name]}".encode(), found)
    for name, dataset in sorted(file["frames"].items()):
        found = _crc(f"{name} {dataset.shape[1:]} {dataset.dtype.str}".encode(), found)
    return content(file["model"], found, limit, pause)


def content(
    group: h5py.Group, start: int, limit: float = np.inf, pause: Callable[[], None] = lambda: None
) -> int:
    """Of all arrays in a group, by their names. ValueError: one is larger than `limit` [bytes]."""
    names: list[str] = []
    group.visit(names.append)
    for name in sorted(names):
        found = group[name]
        if isinstance(found, h5py.Dataset):
            start = _of_dataset(name, found, start, limit)
            pause()
    return start


def of_finer(group: h5py.Group, start: int, limit: float = np.inf) -> int:
    """Of /finer/ and its factor. ValueError: an array is larger than `limit` [bytes]."""
    return content(group, _crc(float(group.attrs["factor"]).hex().encode(), int(start)), limit)


def closing(statistics: str, last: Row, finer: int = 0, checkpoint: int = 0) -> int:
    """Of a run's end: its statistics, the last row of /digests, and the digests of /finer/ and /checkpoint.

    0: there is none.
    """
    return _crc(statistics.encode(), _joined(*last, finer, *([checkpoint] if checkpoint else ())))


def last_row(file: h5py.File) -> Row:
    """Of /digests; that before the first frame where there is none."""
    found, start = file[BLOCKS], int(file.attrs[DIGEST])
    return Row(*found[-1].tolist()) if len(found) else Row(0, 0, start, start)


def rows(dataset: h5py.Dataset, limit: float = np.inf) -> list[Row]:
    """Those of /digests. ValueError: they are larger than `limit` [bytes]."""
    check_size(dataset, limit)
    return [Row(*row) for row in dataset[()].tolist()]


def check_size(dataset: h5py.Dataset, limit: float) -> None:
    """ValueError: an array has more than `limit` [bytes], which none in a file of that length can have."""
    if int(dataset.size) * dataset.dtype.itemsize > limit:
        raise ValueError(f"{dataset.name} is larger than the file")


def whole_frames(frames: h5py.Group, found: Sequence[Row], start: int, limit: float) -> int:
    """How many rows from the first on have the frames that were written; `limit` is the file's length."""
    available = min(len(dataset) for dataset in frames.values())
    width = 8 * sum(int(np.prod(dataset.shape[1:])) for dataset in frames.values())
    before, count = Row(0, 0, start, start), 0
    for slab in _slabs(found, available, width, limit):
        good = _whole_rows(frames, slab, before)
        count += good
        if good < len(slab):
            break
        before = slab[-1]
    return count


def whole_events(events: Sequence[Occurrence], found: Sequence[Row], start: int) -> int:
    """How many events from the first on are those that were written."""
    before = Row(0, 0, start, start)
    for row in found:
        if not before.events <= row.events <= len(events):
            break
        digest = _of_events(events[before.events : row.events], 0)
        if _joined(before.events_digest, row.events, digest) != row.events_digest:
            break
        before = row
    return before.events


def _slabs(found: Sequence[Row], available: int, width: int, limit: float) -> Iterator[list[Row]]:
    """Rows whose frames are read together; none whose frames there cannot be."""
    slab: list[Row] = []
    first = before = 0
    for row in found:
        if not before <= row.frames <= available or (row.frames - before) * width > limit:
            break
        if slab and (row.frames - first) * width > SLAB_BYTES:
            yield slab
            slab, first = [], before
        slab.append(row)
        before = row.frames
    if slab:
        yield slab


def _whole_rows(frames: h5py.Group, slab: Sequence[Row], before: Row) -> int:
    """How many rows of a slab have the frames that were written; row by row where not all can be read."""
    first = before.frames
    try:
        values = {name: frames[name][first : slab[-1].frames] for name in field_order(frames)}
    except Exception:  # whatever HDF5 says of what it finds
        if len(slab) == 1:
            return 0
        middle = len(slab) // 2
        good = _whole_rows(frames, slab[:middle], before)
        return good if good < middle else good + _whole_rows(frames, slab[middle:], slab[middle - 1])
    for count, row in enumerate(slab):
        part = slice(before.frames - first, row.frames - first)
        fields = [field[part] for field in values.values()] if row.frames > before.frames else []
        if _row(before, row.frames, row.events, fields, 0).frames_digest != row.frames_digest:
            return count
        before = row
    return len(slab)


def field_order(frames: Any) -> list[str]:
    """The fields in the order in which a row has their digests."""
    return sorted(frames)


def _row(before: Row, frames: int, events: int, fields: Sequence[Floats], event_digest: int) -> Row:
    return Row(
        frames,
        events,
        _joined(before.frames_digest, frames, events, *_of_fields(fields)),
        _joined(before.events_digest, events, event_digest),
    )


def _of_fields(fields: Sequence[Floats]) -> Iterator[int]:
    """Of the large ones each, and of the others together."""
    words = [np.ascontiguousarray(field, dtype=float).reshape(-1).view(np.uint64) for field in fields]
    for large in words:
        if large.nbytes > SMALL_BYTES:
            yield _of_words(large)
    small = [it for it in words if it.nbytes <= SMALL_BYTES]
    if small:
        yield _of_words(np.concatenate(small))


def _of_words(words: NDArray[np.uint64]) -> int:
    """CRC-32 of sums of some rows each, and of the words that are left over."""
    count = words.size // (SUMMED_ROWS * ROW_WORDS)
    split = count * SUMMED_ROWS * ROW_WORDS
    sums = np.add.reduce(words[:split].reshape(count, SUMMED_ROWS, ROW_WORDS), axis=1)
    return _crc(words[split:], _crc(sums))


def _joined_parts(parts: Sequence[Floats]) -> Floats:
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _joined(*numbers: int) -> int:
    return _crc(np.array(numbers, dtype="<u8"))


def _crc(values: Any, start: int = 0) -> int:
    buffer: Any = values if isinstance(values, bytes) else np.ascontiguousarray(values)
    return zlib.crc32(buffer, start)


def _of_events(occurrences: Sequence[Occurrence], start: int) -> int:
    for it in occurrences:
        start = _crc(it.name.encode(), start)
        for values in (it.t, it.q_before, it.v_before, it.q_after, it.v_after):
            start = _crc(np.asarray(values, dtype=float), start)
    return start


def _of_dataset(name: str, dataset: h5py.Dataset, start: int, limit: float) -> int:
    check_size(dataset, limit)
    start = _crc(f"{name} {dataset.shape} {dataset.dtype.str}".encode(), start)
    if not dataset.shape:
        value = dataset[()]
        return _crc(value if isinstance(value, bytes) else np.asarray(value), start)
    step = max(1, SLAB_BYTES // max(1, dataset.dtype.itemsize * int(np.prod(dataset.shape[1:]))))
    for first in range(0, len(dataset), step):
        start = _crc(dataset[first : first + step], start)
    return start
