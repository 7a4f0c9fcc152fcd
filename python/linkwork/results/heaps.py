"""The heaps in which HDF5 keeps texts, looked at before HDF5 reads them.

A heap is a row of objects, each with its length in front of it; HDF5 walks from one to the next, and for ever
where an object that is free has no length, as in a heap of which a part was set to zero or is missing.
Where a heap is not what it should be in another way, HDF5 says so itself.
"""

from __future__ import annotations

import mmap
import struct
from pathlib import Path

__all__ = ["check"]

SIGNATURE = b"GCOL\x01\x00\x00\x00"

#: Of a heap: signature with version, size. Of an object: index (0: free), references, nothing, length.
HEAD, OBJECT = struct.Struct("<8sQ"), struct.Struct("<HHIQ")


def check(path: Path) -> None:
    """ValueError: HDF5 would not come to the end of a heap."""
    with path.open("rb") as file:
        if not path.stat().st_size:
            return
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            start = content.find(SIGNATURE)
            while start >= 0:
                _check_heap(content, start)
                start = content.find(SIGNATURE, start + 1)


def _check_heap(content: mmap.mmap, start: int) -> None:
    place = start + HEAD.size
    end = start + (HEAD.unpack_from(content, start)[1] if place <= len(content) else HEAD.size)
    while place + OBJECT.size <= end <= len(content):
        index, _, _, length = OBJECT.unpack_from(content, place)
        place += length if index == 0 else OBJECT.size + -(-length // 8) * 8
        if length == 0 == index or place > end:
            break
    else:
        if end <= len(content):
            return
    raise ValueError("a part of its texts is lost")
