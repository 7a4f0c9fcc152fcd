"""What a result knows beside its frames: the constant arrays and names of the model, and the manifest."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork.arrays import Floats, ReadOnly, by_value
from linkwork.errors import counted
from linkwork.modeling.shapes import Shapes
from linkwork.motion.names import Names
from linkwork.motion.state_names import StateNames, force_kind_names, history_names

if TYPE_CHECKING:
    from linkwork import _core

Indices = NDArray[np.integer]

#: What a file that a run began and did not end is without, beside what damage took.
NO_END = "the end of the run: it was interrupted, or what says how it ended is lost"

#: The texts of a header, one for each body, joint, force element or history variable.
MODEL_NAMES = ("body_names", "joint_names", "joint_kinds", "force_names", "force_kinds", "history_names")

#: reactions(t (k,), q (k, 7n), multipliers (k, m), history (k, h) where there is any) -> force [N] and
#: torque [N m] (k, joints, 3).
Reactions = Callable[..., tuple[Floats, Floats]]

#: force_element(index, t (k,), q (k, 7n), v, v_dot (k, 6n), history (k, h)) -> force [N] and torque
#: [N m] (k, 3) on the second body, power [W], potential [J] and what its history variable becomes (k,).
ForceElement = Callable[..., tuple[Floats, Floats, Floats, Floats, Floats]]

#: unlike_run(index, model of these laws or None) -> how its functions show that they return something else
#: now than in the run; empty: they do not.
UnlikeRun = Callable[[int, Any], str]


def _none(*shape: int) -> Callable[[], Any]:
    """Gives the default of an array that files of earlier versions do not have."""
    return lambda: np.zeros(shape)


@by_value
@dataclass(frozen=True, repr=False)
class Header(ReadOnly):
    """n bodies, J joints, m constraint rows. SI units; ground is body index -1."""

    manifest: Mapping[str, Any] = field(metadata={"apart": ("started",)})
    body_names: Sequence[str]
    joint_names: Sequence[str]
    joint_kinds: Sequence[str]
    gravity: Floats  # (3,) inertial
    mass: Floats  # (n,)
    inertia: Floats  # (n, 3, 3) about the center of mass, body frame
    q0: Floats  # (7n,) initial pose
    v0: Floats  # (6n,) initial velocity
    joint_rows: NDArray[np.int32]  # (J + 1,) offsets of each joint's constraint rows
    joint_bodies: NDArray[np.int32]  # (J, 2)
    joint_frame: Floats  # (J, 2, 3, 3) the joint's axes as columns, in the axes of its two bodies
    joint_origin: Floats  # (J, 2, 3) the joint's points in its two bodies
    reaction_unique: NDArray[np.bool_]  # (J,) False where constraints are redundant: shares of least norm
    redundant_rows: NDArray[np.int32]  # constraint rows that the others imply in every pose
    joint_first_parameter: Indices = field(
        default_factory=_none(1)
    )  # (J + 1,) offsets of each joint's numbers
    joint_parameters: Floats = field(default_factory=_none(0))  # such as a length; NaN for a function of time
    force_names: Sequence[str] = ()  # of the F force elements
    force_kinds: Sequence[str] = ()
    force_bodies: Indices = field(default_factory=_none(0, 2))  # (F, 2)
    force_frame: Floats = field(
        default_factory=_none(0, 2, 3, 3)
    )  # (F, 2, 3, 3), force_origin (F, 2, 3): as of joints
    force_origin: Floats = field(default_factory=_none(0, 2, 3))
    force_first_parameter: Indices = field(default_factory=_none(1))  # (F + 1,)
    force_parameters: Floats = field(default_factory=_none(0))
    breaks: Sequence[float] | Floats = ()  # (b,) [s] beside which functions of time were evaluated
    history_count: int = 0  # history variables; none in files of version 0.1
    history_names: Sequence[str] = ()  # their elements (h,), in words; none in files of earlier versions
    expected_frames: int | None = field(default=None, compare=False)  # of a run that begins
    shapes: Shapes = field(default_factory=Shapes, compare=False)  # of the bodies that have their own
    curves: Mapping[int, Floats] = field(default_factory=dict, compare=False)  # by joint: points (m, 3) in a
    reactions: Reactions | None = field(default=None, compare=False)
    force_element: ForceElement | None = field(default=None, compare=False)
    unlike_run: UnlikeRun | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        for it in MODEL_NAMES:
            object.__setattr__(self, it, Names.of(getattr(self, it)))

    @classmethod
    def of(
        cls,
        model: _core.Model,
        dynamics: _core.Dynamics | None,
        manifest: Mapping[str, Any],
        expected_frames: int | None = None,
        shapes: Shapes | None = None,
        curves: Mapping[int, Floats] | None = None,
        breaks: Sequence[float] = (),
    ) -> Header:  # Long: a line a field.
        """The header of a run of `model`; `expected_frames` (when known) sizes the file's chunks.

        Without `dynamics`, of a model whose equations nobody has looked at: all reactions count as unique.
        """
        joints, forces = model.joint_arrays(), model.force_arrays()
        rank = None if dynamics is None else dynamics.rank()
        return cls(
            manifest=dict(manifest),
            body_names=Names(model.body_name, model.body_count),
            joint_names=Names(model.joint_name, model.joint_count),
            joint_kinds=Names(model.joint_kind, model.joint_count),
            gravity=model.gravity,
            mass=model.mass,
            inertia=model.inertia,
            q0=model.q0,
            v0=model.v0,
            joint_rows=model.joint_rows,
            joint_bodies=joints["bodies"],
            joint_frame=joints["frame"],
            joint_origin=joints["origin"],
            reaction_unique=np.array(rank.unique if rank else [True] * model.joint_count, dtype=bool),
            redundant_rows=np.array(rank.redundant_rows if rank else [], dtype=np.int32),
            **_parameters("joint", joints),
            force_names=Names(model.force_name, len(forces["kind"])),
            force_kinds=Names(lambda index: force_kind_names()[forces["kind"][index]], len(forces["kind"])),
            force_bodies=forces["bodies"],
            force_frame=forces["frame"],
            force_origin=forces["origin"],
            **_parameters("force", forces),
            breaks=breaks,
            history_count=0 if dynamics is None else len(dynamics.initial_history),
            history_names=() if dynamics is None else history_names(model, dynamics),
            expected_frames=expected_frames,
            shapes=shapes or Shapes(),
            curves=curves or {},
            reactions=None if dynamics is None else dynamics.reactions,
            force_element=None if dynamics is None else dynamics.force_element,
        )

    def __repr__(self) -> str:
        counts = (self.body_count, "body"), (self.joint_count, "joint"), (self.row_count, "equation")
        return f"<Header: {', '.join(counted(*it) for it in counts)}>"

    def detached(self) -> Header:
        """The same without the compiled model behind it, so that it can go to another process."""
        return replace(self, reactions=None, force_element=None, unlike_run=None)

    def parameters(self, role: Literal["joint", "force"], index: int) -> Floats:
        """The numbers of a joint or force element, as its kind lists them; none in a file that has none."""
        first = getattr(self, f"{role}_first_parameter")
        values: Floats = getattr(self, f"{role}_parameters")
        return values[int(first[index]) : int(first[index + 1])] if index + 1 < len(first) else values[:0]

    @property
    def body_count(self) -> int:
        return len(self.body_names)

    @property
    def joint_count(self) -> int:
        return len(self.joint_names)

    @property
    def row_count(self) -> int:
        return int(self.joint_rows[-1])

    @property
    def state_names(self) -> StateNames:
        """Whose the numbers of a frame are."""
        return StateNames(self.body_names, self.history_names)

    def frame_shapes(self) -> dict[str, tuple[int, ...]]:
        """Shape of one frame of every recorded field; `t` comes last, as in the file."""
        return frame_shapes(self.body_count, self.joint_count, self.row_count, self.history_count)


def frame_shapes(bodies: int, joints: int, rows: int, history: int = 0) -> dict[str, tuple[int, ...]]:
    """As `Header.frame_shapes`, of so many bodies, joints, constraint rows and history variables."""
    return {
        "q": (bodies, 7),
        "v": (bodies, 6),
        "vdot": (bodies, 6),
        "lambda": (rows,),
        "kinetic": (),
        "potential": (),
        "work": (),
        "violation": (3,),
        "history": (history,),
        "reaction_force": (joints, 3),
        "reaction_torque": (joints, 3),
        "t": (),
    }


#: Units of violations of the constraints, of their rates, and of the rates of these.
VIOLATION_UNITS = ("m or 1", "m/s or 1/s", "m/s2 or 1/s2")

#: Units of the recorded fields and of the model's arrays, as attributes in a result file.
UNITS = {
    "t": "s", "q": "m, then 1", "v": "m/s, then rad/s", "vdot": "m/s2, then rad/s2",
    "lambda": "N or N m, by the equation", "kinetic": "J", "potential": "J", "work": "J",
    "violation": ", ".join(VIOLATION_UNITS), "history": "rad, m/s or m, by the variable",
    "reaction_force": "N", "reaction_torque": "N m",
    "gravity": "m/s2", "mass": "kg", "inertia": "kg m2", "q0": "m, then 1", "v0": "m/s, then rad/s",
    "joint_origin": "m", "force_origin": "m", "breaks": "s",
}  # fmt: skip


def _parameters(role: str, arrays: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers of all elements one after the other, and where those of each begin."""
    values = np.where(arrays["signals"] < 0, arrays["parameters"], np.nan)
    first = np.append(arrays["first_parameter"], len(values))
    return {f"{role}_first_parameter": first, f"{role}_parameters": values}


def record_reactions(header: Header, frames: Mapping[str, ArrayLike]) -> dict[str, Floats]:
    """`frames` as arrays, with reaction_force and reaction_torque (k, joints, 3) computed where missing."""
    values = {name: np.asarray(field, dtype=float) for name, field in frames.items()}
    if "reaction_force" in values:
        return values
    count = len(values["t"])
    force = torque = np.zeros((count, header.joint_count, 3))
    if header.joint_count and count:
        assert header.reactions is not None, "frames without reactions need the dynamics that compute them"
        history = [values["history"]] if header.history_count else []
        q = values["q"].reshape(count, -1)
        force, torque = header.reactions(values["t"], q, values["lambda"], *history)
    return {**values, "reaction_force": force, "reaction_torque": torque}
