"""Functions of time [s] for what a model lets vary: forces, free lengths, the length of a distance joint.

    model.force(rod, force=(lw.functions.harmonic(amplitude=5.0, frequency=3.0), 0, 0))

Each is a small record that the compiled module evaluates with its first two derivatives; no Python runs in
the loop, except for `Callback`. A table is never held or extrapolated: a run that goes beyond it is an error
before the first step.
"""

from linkwork.functions.time import *

__all__ = [
    "TimeFunction", "as_time_function", "constant", "cycloidal", "expression", "harmonic",
    "piecewise_polynomial", "polynomial", "table", "with_breaks",
]  # fmt: skip
