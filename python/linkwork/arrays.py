"""Types of arrays, for type hints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Floats", "Indices", "Number", "VectorLike"]

Floats = NDArray[np.float64]

#: Of bodies, as the compiled module takes them.
Indices = NDArray[np.int32]

#: A number as users have it: Python's or NumPy's, such as a norm.
Number = float | np.floating[Any] | np.integer[Any]

#: A point or axis, several, or one for each body, of whatever numbers and arrays: ArrayLike has no mixtures.
VectorLike = ArrayLike | Sequence[ArrayLike] | Sequence[Sequence[ArrayLike]]
