"""Checkpoints on disk: what a run can go on from to the last bit, beside its frames.

While a run is writing, its last checkpoint is in a file of its own beside the output, replaced by renaming;
when it ends, in the output itself, as bytes in /checkpoint with their CRC-32 as attribute `digest`. That of a
very large mechanism stays beside where the run is interrupted, which is to end at once.
"""

from __future__ import annotations

import json
import os
import zlib
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from linkwork.motion.records import Checkpoint

__all__ = [
    "DATASET",
    "StoredCheckpoint",
    "beside",
    "digest_of",
    "make_place",
    "read",
    "read_beside",
    "write",
    "write_beside",
]

DATASET, DIGEST = "checkpoint", "digest"

#: Of the dataset [bytes].
CHUNK_BYTES = (4096, 2**22)

#: Written beside between two looks at signals [bytes].
PIECE_BYTES = 2**24

#: The line before the state is shorter [bytes].
HEAD_BYTES = 2**20

#: Functions that are named in it.
MOST_CHANGED = 1000

#: Of the digest in a file beside [bytes].
DIGEST_BYTES = 4


@dataclass(frozen=True)
class StoredCheckpoint:
    """That of a run which ended a moment ago, in its file or beside; called, it is read."""

    path: Path
    run: str

    def __call__(self) -> Checkpoint | None:
        """None: there is none, or the file has become that of another run."""
        with suppress(OSError, ValueError, KeyError), h5py.File(self.path, "r") as file:
            if file.attrs["run"] == self.run:
                return read(file, self.run, os.path.getsize(self.path)) or read_beside(self.path, self.run)
        return None


def beside(path: Path) -> Path:
    """Where the checkpoint of a run is that writes to `path`."""
    return path.with_name(f".{path.name}.checkpoint")


def write_beside(
    path: Path, checkpoint: Checkpoint, run: str, pause: Callable[[], None] = lambda: None
) -> None:
    """OSError: it cannot be written. What `pause` raises, which is called between pieces, goes through."""
    target = beside(path)
    new = target.with_name(f"{target.name}.{os.getpid()}")
    head, state = _head(checkpoint, run), memoryview(checkpoint.state)
    digest = zlib.crc32(head)
    try:
        with new.open("wb") as file:
            file.write(bytes(DIGEST_BYTES) + head)
            for first in range(0, len(state), PIECE_BYTES):
                piece = state[first : first + PIECE_BYTES]
                digest = zlib.crc32(piece, digest)
                file.write(piece)
                pause()
            file.seek(0)
            file.write(_not_zero(digest).to_bytes(DIGEST_BYTES, "little"))
        os.replace(new, target)
    finally:
        with suppress(OSError):
            new.unlink(missing_ok=True)


def read_beside(path: Path, run: str) -> Checkpoint | None:
    """That of a run which has not ended in order; None: there is none of it, or it is damaged."""
    source = beside(Path(os.path.realpath(path)))
    try:
        if not source.is_file():
            return None
        found = source.read_bytes()
    except OSError:
        return None
    content = memoryview(found)[DIGEST_BYTES:]
    whole = int.from_bytes(found[:DIGEST_BYTES], "little") == _digest(content)
    return _unpacked(content, run) if whole else None


def make_place(file: h5py.File, bodies: int) -> None:
    """For a checkpoint at the end of the run: what is made then could be lost with the rest."""
    least, most = CHUNK_BYTES
    chunk = min(max(least, 256 * bodies), most)
    dataset = file.create_dataset(DATASET, (0,), "u1", maxshape=(None,), chunks=(chunk,))
    dataset.attrs[DIGEST] = 0


def write(file: h5py.File, checkpoint: Checkpoint, run: str) -> None:
    """Into its place."""
    content = _head(checkpoint, run) + checkpoint.state
    dataset = file[DATASET]
    dataset.resize(len(content), axis=0)
    dataset[:] = np.frombuffer(content, dtype="u1")
    dataset.attrs.modify(DIGEST, _digest(content))


def digest_of(file: h5py.File) -> int:
    """0: there is none."""
    return int(file[DATASET].attrs[DIGEST]) if DATASET in file else 0


def read(file: h5py.File, run: str, limit: float) -> Checkpoint | None:
    """ValueError: it is not what was written; it is not larger than `limit` [bytes]."""
    digest = digest_of(file)
    if not digest:
        return None
    dataset = file[DATASET]
    if dataset.size > limit:
        raise ValueError(f"{dataset.name} is larger than the file")
    content = memoryview(dataset[()])
    if _digest(content) != digest:
        raise ValueError(f"{dataset.name} is not what was written")
    return _unpacked(content, run)


def _head(checkpoint: Checkpoint, run: str) -> bytes:
    """The line before the state."""
    head: dict[str, Any] = {"run": run, "method": checkpoint.method, "t": float(checkpoint.t).hex()}
    if checkpoint.changed or checkpoint.returned:
        head |= {"changed": checkpoint.changed[:MOST_CHANGED], "returned": checkpoint.returned}
    if checkpoint.unlike or checkpoint.remember:
        unlike = [[begin.hex(), end.hex()] for begin, end in checkpoint.unlike]
        read, remember = checkpoint.read[:MOST_CHANGED], checkpoint.remember[:MOST_CHANGED]
        head |= {"unlike": unlike, "read": read, "remember": remember}
    return json.dumps(head).encode() + b"\n"


def _unpacked(content: memoryview, run: str) -> Checkpoint | None:
    """None: it is that of another run."""
    head = bytes(content[:HEAD_BYTES]).partition(b"\n")[0]
    found = json.loads(head)
    if found["run"] != run:
        return None
    changed = tuple((name, then, now) for name, then, now in found.get("changed", ()))
    state = bytes(content[len(head) + 1 :])
    unlike = tuple((float.fromhex(begin), float.fromhex(end)) for begin, end in found.get("unlike", ()))
    read, remember = tuple((name, now) for name, now in found.get("read", ())), found.get("remember", ())
    return Checkpoint(found["method"], float.fromhex(found["t"]), state, changed, found.get("returned", ""),
                      unlike, read, tuple(remember))  # fmt: skip


def _digest(content: bytes | memoryview) -> int:
    return _not_zero(zlib.crc32(content))


def _not_zero(digest: int) -> int:
    return digest or 1
