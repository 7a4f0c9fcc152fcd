"""Types of arrays, for type hints, and how large ones are worked through."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Complex", "Floats", "Indices", "Number", "ReadOnly", "VectorLike", "by_value", "near_one", "pieces",
    "read_only",
]  # fmt: skip

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Of bodies, as the compiled module takes them.
Indices = NDArray[np.int32]

#: A number as users have it: Python's or NumPy's, such as a norm.
Number = float | np.floating[Any] | np.integer[Any]

#: A point or axis, several, or one for each body, of whatever numbers and arrays: ArrayLike has no mixtures.
VectorLike = ArrayLike | Sequence[ArrayLike] | Sequence[Sequence[ArrayLike]]

Found = TypeVar("Found")

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


def read_only(found: Found) -> Found:
    """The same numbers in arrays that nobody can write through, also those in a mapping.

    What is computed once and given out often would else be another one after `x = result.t; x *= 1e3`.
    """
    if isinstance(found, np.ndarray):
        view = found.view()
        view.flags.writeable = False
        return view  # type: ignore[return-value]
    if isinstance(found, Mapping):
        return {name: read_only(values) for name, values in found.items()}  # type: ignore[return-value]
    return found


class ReadOnly:
    """Of a dataclass: the arrays in its fields are read-only, whoever made it, also by a pickle."""

    def __post_init__(self) -> None:
        for it in fields(self):  # type: ignore[arg-type]
            values = getattr(self, it.name)
            object.__setattr__(self, it.name, read_only(values))

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        self.__dict__.update(state)
        self.__post_init__()


def by_value(kind: type[Found]) -> type[Found]:
    """Of a dataclass or named tuple: two are == where all their values are, those in arrays, too.

    NaN is NaN here, so that runs are equal that give the same numbers. As arrays, they have no hash.
    A field's metadata "apart" names keys of its mapping that do not count, such as when a run was made.
    """

    def equal(one: Any, other: Any) -> Any:
        plain = type(other) is tuple and isinstance(one, tuple)
        if not plain and type(other) is not type(one):
            return NotImplemented
        return one is other or _same(_compared(one), _compared(other))

    def unequal(one: Any, other: Any) -> Any:
        found = equal(one, other)
        return found if found is NotImplemented else not found

    kind.__eq__ = equal  # type: ignore[method-assign]
    kind.__ne__ = unequal  # type: ignore[method-assign]  # which tuples have of their own
    return kind


def _compared(record: Any) -> list[Any]:
    if isinstance(record, tuple):
        return list(record)
    return [
        _without(getattr(record, it.name), it.metadata.get("apart", ()))
        for it in fields(record)
        if it.compare
    ]


def _without(value: Any, keys: Collection[str]) -> Any:
    return {key: it for key, it in value.items() if key not in keys} if keys else value


def _same(a: Any, b: Any) -> bool:
    if a is b:
        return True
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        a, b = np.asarray(a), np.asarray(b)
        return a.shape == b.shape and bool(np.all((a == b) | ((a != a) & (b != b))))
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        return a.keys() == b.keys() and all(_same(a[key], b[key]) for key in a)
    if isinstance(a, list | tuple) and isinstance(b, list | tuple) and type(a) in (list, tuple):
        return len(a) == len(b) and all(map(_same, a, b))
    return bool(a == b or (a != a and b != b))
