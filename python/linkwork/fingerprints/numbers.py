"""Numbers by their bytes: a table of millions takes as long as it takes to read it."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from typing import Any

import numpy as np

__all__ = ["of_array", "of_list", "of_scalar", "plain"]

#: Shorter lists are written number by number.
FEW = 64

#: Floats of NumPy that have NaN in many bits, which a processor chooses.
_WITH_NAN = "efdFD"

#: Of a long double some bytes say nothing.
_LONG = "gG"

#: For numbers of Python.
_TYPES: dict[type, Any] = {bool: bool, float: float, int: np.int64}


def of_array(value: np.ndarray[Any, Any]) -> list[Any]:
    """Class, type of the numbers, shape, order in memory, by which sums are rounded, digest of the bytes.

    Of what has no bytes of its own, such as objects, what it holds.
    """
    if isinstance(value, np.ma.MaskedArray):
        return [type(value).__name__, value.data, np.ma.getmaskarray(value)]
    flags, dtype = value.flags, value.dtype
    order = "F" if flags.f_contiguous and not flags.c_contiguous else "C"
    about = [type(value).__name__, dtype.str, dtype.name, value.shape, order]
    if dtype.names:
        return [*about, *((name, value[name]) for name in dtype.names)]
    if not _has_bytes(dtype):
        return [*about, value.tolist()]
    bare = np.asarray(value)
    return [*about, _digest(bare.T if order == "F" else bare)]


def of_scalar(value: np.generic) -> str | list[Any]:
    """Type and value; the parts of what is made of several."""
    dtype = value.dtype
    if isinstance(value, np.void) and dtype.names:
        return ["fields", str(dtype), *((name, value[name]) for name in dtype.names)]
    if dtype.char in _LONG:
        return [dtype.str, *(np.format_float_scientific(part) for part in (value.real, value.imag))]
    if isinstance(value, np.floating):
        return f"{dtype.str} {float(value).hex()}"
    if isinstance(value, np.integer):
        return f"{dtype.str} {int(value)}"
    return f"{dtype.str} {dtype.name} {_one_nan(np.asarray(value)).tobytes().hex()}"


def of_list(values: Sequence[Any]) -> list[Any] | None:
    """Of many floats, and whole numbers of 64 bits, of Python; None: it is something else."""
    kinds = set(map(type, values)) if len(values) >= FEW else {object}
    if not kinds <= {float, int}:
        return None
    columns = [values]
    if len(kinds) == 2:
        columns = [[type(it) is float for it in values],
                   *([it for it in values if type(it) is kind] for kind in (float, int))]  # fmt: skip
    try:
        return [(type(it[0]).__name__, _digest(np.array(it, dtype=_TYPES[type(it[0])]))) for it in columns]
    except OverflowError:
        return None


def plain(value: Any) -> Any:
    """Numbers of Python in lists, as JSON has them; what is no number or array stays."""
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    if type(value) is dict:
        return {name: plain(part) for name, part in value.items()}
    return [plain(part) for part in value] if isinstance(value, list | tuple) else value


def _has_bytes(dtype: np.dtype[Any]) -> bool:
    return not dtype.hasobject and dtype.kind != "T" and dtype.char not in _LONG


def _one_nan(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    if values.dtype.char in _WITH_NAN and (nan := np.isnan(values)).any():
        return np.where(nan, values.dtype.type(np.nan), values)
    return values


def _digest(values: np.ndarray[Any, Any]) -> str:
    flat = np.ascontiguousarray(_one_nan(values)).reshape(-1)
    content = flat.view(np.uint8).data if flat.nbytes else b""
    return hashlib.blake2b(content, digest_size=16).hexdigest()
