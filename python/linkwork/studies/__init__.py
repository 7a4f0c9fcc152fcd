"""Studies: one mechanism in many variants, each run once, whatever fails or is interrupted.

study = lw.sweep(model, {"rod.mass": [1, 2, 3], "gravity[2]": [-9.81, -1.62]}, ["energy_error.abs_max"],
                 t_end=2.0, step=1e-3, directory="variants")
"""

from linkwork.studies.study import Study
from linkwork.studies.sweeping import sweep

__all__ = ["Study", "sweep"]
