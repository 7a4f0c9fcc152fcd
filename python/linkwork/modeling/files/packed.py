"""The arrays of large meshes as text: rows of three numbers, deflated, in base64, named by their type.

f4:eJxjYGBg...      f4, f8: vertices, floating point of 4 or 8 bytes; i4: triangles; all little endian
"""

from __future__ import annotations

import base64
import zlib

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats, Indices
from linkwork.errors import ModelError

__all__ = ["LEAST", "pack", "unpack"]

#: Arrays of fewer rows are written as lists of numbers.
LEAST = 100

#: The most bytes of an array.
MOST = 2**28

TYPES = ("f4", "f8", "i4")


def pack(array: Floats | Indices) -> str:
    """Of an array (n, 3); exact."""
    kind = "i4" if array.dtype.kind == "i" else "f8"
    if kind == "f8" and (array.astype(np.float32) == array).all():
        kind = "f4"
    data = zlib.compress(np.ascontiguousarray(array, dtype=f"<{kind}").tobytes(), 9)
    return f"{kind}:{base64.b64encode(data).decode('ascii')}"


def unpack(text: str, what: str) -> NDArray[np.float64] | NDArray[np.int32]:
    """ModelError: not what `pack` makes."""
    kind, _, data = text.partition(":")
    try:
        if kind not in TYPES:
            raise ValueError(f"begins with none of {', '.join(it + ':' for it in TYPES)}")
        reader = zlib.decompressobj()
        found = reader.decompress(base64.b64decode(data, validate=True), MOST)
        if reader.unconsumed_tail or not reader.eof:
            raise ValueError("is too large, or cut off")
        array = np.frombuffer(found, dtype=f"<{kind}").reshape(-1, 3)
    except (ValueError, zlib.error) as error:
        raise ModelError(f"{what}: '{text[:20]}...' is no packed array: {error}", code="shape") from error
    return array.astype(np.int32 if kind == "i4" else float)
