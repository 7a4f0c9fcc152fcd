"""A compiled force as a function of Python: for those who look at what it is given, and ask it again."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.fingerprints import called_from_ctypes, law

__all__ = ["CompiledLaw"]

_CALLED: Any = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_int64, *[ctypes.c_void_p] * 4)


class CompiledLaw:
    """g (n, 6) of t [s], q (n, 7), v (n, 6).

    data    what it gets the address of, which it may change; an address where nobody knows what is there
    bodies  n: it would look for more in memory that is not its own
    """

    def __init__(self, function: Any, address: int, data: Any, data_address: int) -> None:
        self.data, self.bodies = data, 0
        self._function, self._behind = function, called_from_ctypes(function)
        self._called, self._at = _CALLED(address), data_address

    @property
    def may_remember(self) -> bool:
        """Whether it has something that is known, and that it or others may write to."""
        return self._behind is not None or not isinstance(self.data, int | np.integer)

    def __call__(self, t: float, q: Floats, v: Floats) -> Floats:
        """ValueError: it is of other bodies."""
        q, v = np.array(q, dtype=float, order="C"), np.array(v, dtype=float, order="C")
        if q.shape != (self.bodies, 7) or v.shape != (self.bodies, 6):
            raise ValueError(f"q {q.shape} and v {v.shape} are not of {self.bodies} bodies")
        g = np.zeros_like(v)
        self._called(float(t), self.bodies, q.ctypes.data, v.ctypes.data, g.ctypes.data, self._at)
        return g

    def __fingerprint__(self) -> str:
        return f"{law(self._function)} {law(self.data)}"
