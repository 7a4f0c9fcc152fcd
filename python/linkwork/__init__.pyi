"""What type checkers read: the public names, which load at first use."""

from linkwork import functions, integrators, mechanisms, rotation
from linkwork.accuracy.verdict import StepEstimate, Verdict
from linkwork.analyses.equilibrium import Equilibrium, equilibrium
from linkwork.analyses.inverse_dynamics import Drive, InverseDynamics, inverse_dynamics
from linkwork.analyses.kinematics import kinematics
from linkwork.analyses.linearization import Linearization, linearize
from linkwork.analyses.sensitivity import Sensitivity, sensitivity
from linkwork.comparison import Comparison, compare
from linkwork.ensemble.ensemble import Ensemble, simulate_many
from linkwork.ensemble.outcome import EnsembleResult
from linkwork.equations.assembly import Assembly, JointResidual, assemble
from linkwork.equations.system import System
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
from linkwork.studies.study import Study
from linkwork.studies.sweeping import sweep

__version__: str

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
    "Ensemble",
    "EnsembleResult",
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
    "Study",
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
    "simulate_many",
    "sweep",
]
