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
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from linkwork import functions, integrators, mechanisms, rotation
    from linkwork.analyses.equilibrium import Equilibrium, equilibrium
    from linkwork.analyses.inverse_dynamics import Drive, InverseDynamics, inverse_dynamics
    from linkwork.analyses.kinematics import kinematics
    from linkwork.analyses.linearization import Linearization, linearize
    from linkwork.analyses.sensitivity import Sensitivity, sensitivity
    from linkwork.assembly import Assembly, JointResidual, assemble
    from linkwork.comparison import Comparison, compare
    from linkwork.contact import contact_hysteresis
    from linkwork.errors import (
        AccuracyError,
        BusyError,
        Fault,
        FileError,
        LinkworkError,
        LinkworkWarning,
        ModelError,
        ModelFileError,
        NotConvergedError,
        NotFiniteError,
        OptionError,
        SingularSystemError,
        StepSizeError,
        ViolationError,
    )
    from linkwork.events import Event, Occurrence, State
    from linkwork.handles import Body, Force, Joint
    from linkwork.importers import Imported, import_mjcf, import_sdf, import_urdf
    from linkwork.model import Model
    from linkwork.progress import ProgressInfo
    from linkwork.result import BodyResult, Reaction, Result, SingularPose, Snapshot
    from linkwork.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere
    from linkwork.simulation import simulate
    from linkwork.system import System
    from linkwork.verdict import StepEstimate, Verdict

__all__ = [
    "AccuracyError",
    "Assembly",
    "Body",
    "BodyResult",
    "Box",
    "BusyError",
    "Comparison",
    "Cylinder",
    "Drive",
    "Equilibrium",
    "Event",
    "Fault",
    "FileError",
    "Force",
    "Imported",
    "InverseDynamics",
    "Joint",
    "JointResidual",
    "Linearization",
    "LinkworkError",
    "LinkworkWarning",
    "Mesh",
    "Model",
    "ModelError",
    "ModelFileError",
    "NotConvergedError",
    "NotFiniteError",
    "Occurrence",
    "OptionError",
    "ProgressInfo",
    "Reaction",
    "Result",
    "Rod",
    "Sensitivity",
    "Shape",
    "SingularPose",
    "SingularSystemError",
    "Snapshot",
    "Sphere",
    "State",
    "StepEstimate",
    "StepSizeError",
    "System",
    "Verdict",
    "ViolationError",
    "__version__",
    "assemble",
    "compare",
    "contact_hysteresis",
    "equilibrium",
    "functions",
    "import_mjcf",
    "import_sdf",
    "import_urdf",
    "integrators",
    "inverse_dynamics",
    "kinematics",
    "linearize",
    "mechanisms",
    "rotation",
    "sensitivity",
    "simulate",
]

logging.getLogger(__name__).addHandler(logging.NullHandler())  # silent until the user wants to hear

_MODULES = ("functions", "integrators", "mechanisms", "rotation")
_PLACES = {
    "linkwork.analyses.equilibrium": ("Equilibrium", "equilibrium"),
    "linkwork.analyses.inverse_dynamics": ("Drive", "InverseDynamics", "inverse_dynamics"),
    "linkwork.analyses.kinematics": ("kinematics",),
    "linkwork.analyses.linearization": ("Linearization", "linearize"),
    "linkwork.analyses.sensitivity": ("Sensitivity", "sensitivity"),
    "linkwork.assembly": ("Assembly", "JointResidual", "assemble"),
    "linkwork.comparison": ("Comparison", "compare"),
    "linkwork.contact": ("contact_hysteresis",),
    "linkwork.events": ("Event", "Occurrence", "State"),
    "linkwork.handles": ("Body", "Force", "Joint"),
    "linkwork.errors": ("AccuracyError", "BusyError", "Fault", "FileError", "LinkworkError",
                        "LinkworkWarning", "ModelError", "ModelFileError", "NotConvergedError",
                        "NotFiniteError", "OptionError", "SingularSystemError", "StepSizeError",
                        "ViolationError"),
    "linkwork.importers": ("Imported", "import_mjcf", "import_sdf", "import_urdf"),
    "linkwork.model": ("Model",),
    "linkwork.progress": ("ProgressInfo",),
    "linkwork.result": ("BodyResult", "Reaction", "Result", "SingularPose", "Snapshot"),
    "linkwork.shapes": ("Box", "Cylinder", "Mesh", "Rod", "Shape", "Sphere"),
    "linkwork.simulation": ("simulate",),
    "linkwork.system": ("System",),
    "linkwork.verdict": ("StepEstimate", "Verdict"),
}  # fmt: skip
_HOME = {name: module for module, names in _PLACES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name in _HOME:
        value = getattr(import_module(_HOME[name]), name)
    elif name in _MODULES:
        value = import_module(f"linkwork.{name}")
    elif name == "__version__":
        value = import_module("importlib.metadata").version("linkwork")
    else:
        raise AttributeError(f"module 'linkwork' has no attribute '{name}'")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
