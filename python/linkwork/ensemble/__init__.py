"""Ensembles: many mechanisms of one structure at once, each in a lane of the processor's registers.

many = lw.simulate_many(model, {"rod.mass": [1, 2, 3], "gravity[2]": [-9.81, -1.62]}, 2.0, step=1e-3)
"""

from linkwork.ensemble.ensemble import Ensemble, simulate_many
from linkwork.ensemble.outcome import EnsembleResult

__all__ = ["Ensemble", "EnsembleResult", "simulate_many"]
