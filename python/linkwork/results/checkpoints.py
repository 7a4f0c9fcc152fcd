"""Checkpoints on disk: what a run can go on from to the last bit, beside its frames.

While a run is writing, its last checkpoint is in a file of its own beside the output, replaced by renaming;
when it ends, in the output itself, as bytes in /checkpoint with their CRC-32 as attribute `digest`.
"""

from __future__ import annotations

import json
import os
import zlib
from contextlib import suppress
from pathlib import Path

import h5py
import numpy as np

from linkwork.motion.records import Checkpoint

__all__ = ["DATASET", "beside", "digest_of", "make_place", "read", "read_beside", "write", "write_beside"]

DATASET, DIGEST = "checkpoint", "digest"

#: Of the dataset [bytes].
CHUNK_BYTES = (4096, 2**22)


def beside(path: Path) -> Path:
    """Where the checkpoint of a run is that writes to `path`."""
    return path.with_name(f".{path.name}.checkpoint")


def write_beside(path: Path, checkpoint: Checkpoint, run: str) -> None:
    """OSError: it cannot be written."""
    target = beside(path)
    new = target.with_name(f"{target.name}.{os.getpid()}")
    content = _packed(checkpoint, run)
    try:
        new.write_bytes(_digest(content).to_bytes(4, "little") + content)
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
    whole = int.from_bytes(found[:4], "little") == _digest(found[4:])
    return _unpacked(found[4:], run) if whole else None


def make_place(file: h5py.File, bodies: int) -> None:
    """For a checkpoint at the end of the run: what is made then could be lost with the rest."""
    least, most = CHUNK_BYTES
    chunk = min(max(least, 256 * bodies), most)
    dataset = file.create_dataset(DATASET, (0,), "u1", maxshape=(None,), chunks=(chunk,))
    dataset.attrs[DIGEST] = 0


def write(file: h5py.File, checkpoint: Checkpoint, run: str) -> None:
    """Into its place."""
    content = np.frombuffer(_packed(checkpoint, run), dtype="u1")
    dataset = file[DATASET]
    dataset.resize(len(content), axis=0)
    dataset[:] = content
    dataset.attrs.modify(DIGEST, _digest(content.tobytes()))


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
    content = dataset[()].tobytes()
    if _digest(content) != digest:
        raise ValueError(f"{dataset.name} is not what was written")
    return _unpacked(content, run)


def _packed(checkpoint: Checkpoint, run: str) -> bytes:
    head = {"run": run, "method": checkpoint.method, "t": float(checkpoint.t).hex()}
    return json.dumps(head).encode() + b"\n" + checkpoint.state


def _unpacked(content: bytes, run: str) -> Checkpoint | None:
    """None: it is that of another run."""
    head, _, state = content.partition(b"\n")
    found = json.loads(head)
    return Checkpoint(found["method"], float.fromhex(found["t"]), state) if found["run"] == run else None


def _digest(content: bytes) -> int:
    """Not 0."""
    return zlib.crc32(content) or 1
