"""The heaps in which HDF5 keeps texts, looked at before HDF5 reads them.

A heap is a row of objects, each with its length in front of it; HDF5 walks from one to the next, and for ever
where an object that is free has no length, as in a heap of which a part was set to zero or is missing.
Where a heap is not what it should be in another way, HDF5 says so itself.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

__all__ = ["check"]

SIGNATURE = b"GCOL\x01\x00\x00\x00"

#: What is said of one that is not whole.
LOST = "a part of its texts is lost"

#: Of a heap: signature with version, size. Of an object: index (0: free), references, nothing, length.
HEAD, OBJECT = struct.Struct("<8sQ"), struct.Struct("<HHIQ")


#: Bytes that are looked through at a time.
BLOCK = 2**24


def check(path: Path) -> None:
    """ValueError: HDF5 would not come to the end of a heap.

    It is read, not mapped into memory: whoever touches a mapped file that has become shorter is ended.
    """
    with path.open("rb") as file:
        for start in _starts(file):
            _check_heap(file, start)


def _starts(file: BinaryIO) -> Iterator[int]:
    """Places of all heaps."""
    overlap = len(SIGNATURE) - 1
    place, block = 0, file.read(BLOCK)
    while len(block) > overlap:
        found = block.find(SIGNATURE)
        while found >= 0:
            yield place + found
            found = block.find(SIGNATURE, found + 1)
        place += len(block) - overlap
        file.seek(place)
        block = file.read(BLOCK)


def _check_heap(file: BinaryIO, start: int) -> None:
    file.seek(start)
    head = file.read(HEAD.size)
    size = HEAD.unpack(head)[1] if len(head) == HEAD.size else HEAD.size
    file.seek(0, os.SEEK_END)
    if start + size > file.tell():
        raise ValueError(LOST)
    file.seek(start)
    content = file.read(size)
    place = HEAD.size
    while place + OBJECT.size <= len(content):
        index, _, _, length = OBJECT.unpack_from(content, place)
        place += length if index == 0 else OBJECT.size + -(-length // 8) * 8
        if length == 0 == index or place > len(content):
            raise ValueError(LOST)
    if len(content) < size:
        raise ValueError(LOST)
