"""linkwork: spatial mechanisms, and the methods that solve their equations of motion, side by side.

    import linkwork as lw

    model = lw.Model(gravity=(0, 0, -9.81))
    rod = model.body("rod", mass=1.0, inertia=(0.001, 0.083, 0.083), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0))
    result = lw.simulate(model, t_end=2.0, step=1e-3)

SI units; positions inertial, omega body-fixed, Euler parameters scalar first. Names load at first use.
"""

from __future__ import annotations

import logging
from importlib import import_module
from typing import Any

from linkwork import former

logging.getLogger(__name__).addHandler(logging.NullHandler())  # silent until the user wants to hear

former.install()  # what was pickled by an earlier version loads

_MODULES = ("functions", "integrators", "mechanisms", "rotation")
_PLACES = {
    "linkwork.analyses.equilibrium": ("Equilibrium", "equilibrium"),
    "linkwork.analyses.inverse_dynamics": ("Drive", "InverseDynamics", "inverse_dynamics"),
    "linkwork.analyses.kinematics": ("kinematics",),
    "linkwork.analyses.linearization": ("Linearization", "linearize"),
    "linkwork.analyses.sensitivity": ("Sensitivity", "sensitivity"),
    "linkwork.equations.assembly": ("Assembly", "JointResidual", "assemble"),
    "linkwork.comparison": ("Comparison", "compare"),
    "linkwork.ensemble.ensemble": ("Ensemble", "simulate_many"),
    "linkwork.ensemble.outcome": ("EnsembleResult",),
    "linkwork.modeling.contact": ("contact_hysteresis",),
    "linkwork.running.events": ("Event", "State"),
    "linkwork.modeling.handles": ("Body", "Force", "Joint"),
    "linkwork.errors": ("AccuracyError", "BusyError", "Fault", "FileError", "LinkworkError",
                        "LinkworkWarning", "ModelError", "ModelFileError", "NotConvergedError",
                        "NotFiniteError", "OptionError", "SingularSystemError", "StepSizeError",
                        "ViolationError"),
    "linkwork.importers": ("Imported", "import_mjcf", "import_sdf", "import_urdf"),
    "linkwork.modeling.model": ("Model",),
    "linkwork.running.progress": ("ProgressInfo",),
    "linkwork.results.result": ("Result",),
    "linkwork.motion.records": ("BodyResult", "Occurrence", "Reaction", "SingularPose", "Snapshot"),
    "linkwork.modeling.shapes": ("Box", "Cylinder", "Mesh", "Rod", "Shape", "Sphere"),
    "linkwork.running.simulation": ("simulate",),
    "linkwork.equations.system": ("System",),
    "linkwork.studies.study": ("Study",),
    "linkwork.studies.sweeping": ("sweep",),
    "linkwork.accuracy.verdict": ("StepEstimate", "Verdict"),
}  # fmt: skip
_HOME = {name: module for module, names in _PLACES.items() for name in names}
__all__ = sorted([*_HOME, *_MODULES, "__version__"])  # type checkers read __init__.pyi


def __getattr__(name: str) -> Any:
    if name in _HOME:
        value = getattr(import_module(_HOME[name]), name)
    elif name in _MODULES:
        value = import_module(f"linkwork.{name}")
    elif name == "__version__":
        value = import_module("importlib.metadata").version("linkwork")
    else:
        places = former.PLACES.get(f"linkwork.{name}", ())
        moved = f"; its names are in linkwork.{' and linkwork.'.join(places)} now" if places else ""
        raise AttributeError(f"module 'linkwork' has no attribute '{name}'{moved}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
