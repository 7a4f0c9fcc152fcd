"""Data sets of xarray as files can hold them: names without groups, numbers of kinds that a format has."""

from __future__ import annotations

import importlib.util
from collections.abc import Set
from typing import TYPE_CHECKING

import numpy as np

from linkwork.errors import warn

if TYPE_CHECKING:
    import xarray

__all__ = ["dimensions", "for_netcdf", "without_groups"]

#: Up to here every whole number is a float.
EXACT = 2**53


def dimensions(name: str, count: int, taken: Set[str]) -> list[str]:
    """Of an array, after the first: none has the name of a parameter or output."""
    found = []
    for label in (f"{name}_{k + 1}" for k in range(count)):
        while label in taken:
            label += "_"
        found.append(label)
    return found


def without_groups(data: xarray.Dataset) -> xarray.Dataset:
    """With "_" for "/" in names, by which files of Zarr and netCDF put what has them into groups, where
    whoever opens the file does not find it. What was renamed has its own name as attribute.

    LinkworkWarning: something was.
    """
    taken = {*map(str, data.variables), *map(str, data.dims)}
    new: dict[str, str] = {}
    for name in sorted(it for it in taken if "/" in it):
        label = name.replace("/", "_")
        while label in taken:
            label += "_"
        taken.add(label)
        new[name] = label
    if not new:
        return data
    found = data.rename(new)
    for name in (it for it in new if it in data.variables):
        found[new[name]].attrs["name"] = name
    told = ", ".join(f"'{name}' is '{new[name]}'" for name in list(new)[:3] if name in data.variables)
    warn(f"data set: {told}: names in files of Zarr and netCDF have no /; attribute 'name' has what it was")
    return found


def for_netcdf(data: xarray.Dataset) -> xarray.Dataset:
    """With floats for whole numbers that SciPy's netCDF, of 32 bits, does not hold, where another package is
    not there. ValueError: they would be other numbers.
    """
    if any(importlib.util.find_spec(package) for package in ("netCDF4", "h5netcdf")):
        return data
    found = {}
    for name, it in data.variables.items():
        if it.dtype.kind not in "iu" or not it.size:
            continue
        least, most = int(it.values.min()), int(it.values.max())
        if least >= -(2**31) and most < 2**31:
            continue
        if least < -EXACT or most > EXACT:
            raise ValueError(
                f"'{name}' has whole numbers beyond 2^53, which SciPy's netCDF does not hold: install "
                "h5netcdf, or take to_csv"
            )
        found[name] = it.astype(np.float64)
    return data.assign(found) if found else data
