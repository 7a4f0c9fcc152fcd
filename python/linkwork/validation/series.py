"""The solutions in data/: independent computations, each with its definition, method and trusted digits."""

from __future__ import annotations

import json
from importlib.resources import files

import numpy as np

from linkwork.arrays import Floats

__all__ = ["Series"]


class Series:
    """Columns by name; rows in time. `definition` says what was computed, and how."""

    def __init__(self, name: str) -> None:
        text = (files("linkwork.validation") / "data" / f"{name}.json").read_text(encoding="utf-8")
        self.definition = json.loads(text)
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
