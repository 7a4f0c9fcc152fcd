"""Reference solutions in tests/python/data: independent computations, each with its definition."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Series:
    """Columns by name; rows in time."""

    def __init__(self, name: str) -> None:
        self.definition = json.loads((Path(__file__).parent / "data" / f"{name}.json").read_text())
        self._data = np.array(self.definition["data"])

    def __call__(self, *columns: str) -> Floats:
        """(k,) of one column, (k, c) of several."""
        places = [self.definition["columns"].index(column) for column in columns]
        found: Floats = self._data[:, places[0] if len(places) == 1 else places]
        return found

    @property
    def interval(self) -> float:
        """Between rows [s]."""
        return float(self("t")[1] - self("t")[0])
