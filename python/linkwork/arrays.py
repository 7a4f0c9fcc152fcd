"""Types of arrays, for type hints, and how large ones are worked through."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Complex", "Floats", "Indices", "Number", "VectorLike", "near_one", "pieces"]

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Of bodies, as the compiled module takes them.
Indices = NDArray[np.int32]

#: A number as users have it: Python's or NumPy's, such as a norm.
Number = float | np.floating[Any] | np.integer[Any]

#: A point or axis, several, or one for each body, of whatever numbers and arrays: ArrayLike has no mixtures.
VectorLike = ArrayLike | Sequence[ArrayLike] | Sequence[Sequence[ArrayLike]]

#: Rows of a large array that are worked on at a time: with what is computed on the way they fit into a cache.
PIECE = 4096


def near_one(vectors: Floats) -> Floats:
    """Vectors (..., n) times powers of two, without rounding: squares of what is left are numbers, too."""
    _, exponent = np.frexp(np.abs(vectors).max(axis=-1, keepdims=True))
    scaled: Floats = np.ldexp(vectors, -exponent)
    return scaled


def pieces(count: int) -> Iterator[slice]:
    """Slices of so many rows, one after the other."""
    for first in range(0, count, PIECE):
        yield slice(first, min(first + PIECE, count))
