"""Parts of a stored array, as numpy gives them of one in memory."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["to_read"]


def to_read(key: Any, shape: tuple[int, ...]) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """What HDF5 is to read of an array of this shape, and the index into what was read that gives what `key`
    gives of the array; `key` is one that numpy takes.

    HDF5 reads forward, takes one list of indices only, ascending, and counts negative ones from the end of
    what is on disk.
    """
    read: list[Any] = []
    of_read: list[Any] = []
    for part in _by_axis(key, len(shape)):
        if _has_no_axis(part):
            of_read.append(part)
            continue
        length, listed = shape[len(read)], any(isinstance(it, np.ndarray) for it in read)
        covering, within = _slice(part, length) if isinstance(part, slice) else _indices(part, length, listed)
        read.append(covering)
        of_read.append(within)
    return tuple(read), tuple(of_read)


def _slice(part: slice, length: int) -> tuple[slice, slice]:
    chosen = range(*part.indices(length))
    forward = chosen if chosen.step > 0 else chosen[::-1]
    return slice(forward.start, forward.stop, forward.step), slice(None, None, 1 if chosen.step > 0 else -1)


def _indices(part: Any, length: int, listed: bool) -> tuple[Any, Any]:
    """Of whole numbers; `listed`: another axis has a list, so that of this one all between them is read."""
    places = np.where(part < 0, part + length, part)
    first = int(places.min())
    if not places.ndim:
        return slice(first, first + 1), 0
    if listed:
        return slice(first, int(places.max()) + 1), places - first
    unique, back = np.unique(places, return_inverse=True)
    return unique, back.reshape(places.shape)


def _by_axis(key: Any, axes: int) -> list[Any]:
    """A slice or an array of whole numbers for each axis, and what has none, in the order of `key`."""
    parts: list[Any] = []
    for part in key if isinstance(key, tuple) else (key,):
        if part is Ellipsis or isinstance(part, slice) or _has_no_axis(part):
            parts.append(part)
        elif np.asarray(part).dtype == bool:
            parts += np.asarray(part).nonzero()
        else:
            parts.append(np.asarray(part, dtype=np.intp))
    at = next((place for place, part in enumerate(parts) if part is Ellipsis), len(parts))
    before, after = parts[:at], parts[at + 1 :]
    taken = sum(not _has_no_axis(part) for part in before + after)
    return [*before, *[slice(None)] * (axes - taken), *after]


def _has_no_axis(part: Any) -> bool:
    """A new axis, or a truth value, which numpy takes for one."""
    return part is None or isinstance(part, bool | np.bool_)
