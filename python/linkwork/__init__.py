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

from linkwork import former

if TYPE_CHECKING:
    from linkwork import functions, integrators, mechanisms, rotation
    from linkwork.accuracy.verdict import StepEstimate, Verdict
    from linkwork.analyses.equilibrium import Equilibrium, equilibrium
    from linkwork.analyses.inverse_dynamics import Drive, InverseDynamics, inverse_dynamics
    from linkwork.analyses.kinematics import kinematics
    from linkwork.analyses.linearization import Linearization, linearize
    from linkwork.analyses.sensitivity import Sensitivity, sensitivity
    from linkwork.comparison import Comparison, compare
    from linkwork.equations.assembly import Assembly, JointResidual, assemble
    from linkwork.equations.system import System
    from linkwork.errors import (
        AccuracyError,
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
    from linkwork.importers import Imported, import_mjcf, import_sdf, import_urdf
    from linkwork.modeling.contact import contact_hysteresis
    from linkwork.modeling.handles import Body, Force, Joint
    from linkwork.modeling.model import Model
    from linkwork.modeling.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere
    from linkwork.motion.records import BodyResult, Occurrence, Reaction, SingularPose, Snapshot
    from linkwork.results.result import Result
    from linkwork.running.events import Event, State
    from linkwork.running.progress import ProgressInfo
    from linkwork.running.simulation import simulate

__all__ = [
    "AccuracyError",
    "Assembly",
    "Body",
    "BodyResult",
    "Box",
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
    "linkwork.modeling.contact": ("contact_hysteresis",),
    "linkwork.running.events": ("Event", "State"),
    "linkwork.modeling.handles": ("Body", "Force", "Joint"),
    "linkwork.errors": ("AccuracyError", "Fault", "FileError", "LinkworkError", "LinkworkWarning",
                        "ModelError", "ModelFileError", "NotConvergedError", "NotFiniteError", "OptionError",
                        "SingularSystemError", "StepSizeError", "ViolationError"),
    "linkwork.importers": ("Imported", "import_mjcf", "import_sdf", "import_urdf"),
    "linkwork.modeling.model": ("Model",),
    "linkwork.running.progress": ("ProgressInfo",),
    "linkwork.results.result": ("Result",),
    "linkwork.motion.records": ("BodyResult", "Occurrence", "Reaction", "SingularPose", "Snapshot"),
    "linkwork.modeling.shapes": ("Box", "Cylinder", "Mesh", "Rod", "Shape", "Sphere"),
    "linkwork.running.simulation": ("simulate",),
    "linkwork.equations.system": ("System",),
    "linkwork.accuracy.verdict": ("StepEstimate", "Verdict"),
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
