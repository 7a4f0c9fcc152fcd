"""What runs are compared by: every recorded number, and the methods whose steps follow tolerances."""

from __future__ import annotations

import linkwork as lw
import numpy as np
from linkwork.integrators import METHODS, EmbeddedPair

PAIRS = [name for name, method in METHODS.items() if isinstance(method, EmbeddedPair)]
FIELDS = ("q", "v", "vdot", "lambda", "kinetic", "potential", "work", "violation", "history")


def bits_after(result: lw.Result, t: float) -> dict[str, bytes]:
    """Of all frames after t."""
    later = result.t > t * (1 + 1e-12)
    fields = {"t": result.t, **{name: result.recorded(name) for name in FIELDS}}
    return {name: np.ascontiguousarray(field[later]).tobytes() for name, field in fields.items()}
