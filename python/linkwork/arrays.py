"""Types of arrays, for type hints."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["Floats", "Indices"]

Floats = NDArray[np.float64]

#: Of bodies, as the compiled module takes them.
Indices = NDArray[np.int32]
