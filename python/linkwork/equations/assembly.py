"""Initial conditions that satisfy the joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import astuple, dataclass
from html import escape

import numpy as np
from numpy.typing import NDArray

from linkwork import _core
from linkwork.arguments import is_number
from linkwork.arrays import Floats, ReadOnly
from linkwork.equations import branches
from linkwork.errors import ModelError, NotConvergedError
from linkwork.modeling.handles import BodiesLike, BodyLike
from linkwork.modeling.model import Model, check_model
from linkwork.modeling.tables import Table

__all__ = ["Assembly", "JointResidual", "assemble"]

#: Joints whose residual is above this part of the largest are named where joints conflict.
CONFLICTING = 1e-2

#: How many joints a message lists.
LISTED = 5


@dataclass(frozen=True)
class JointResidual:
    """Largest violation of a joint's equations, [m] or [1] and per second, as given and as assembled."""

    joint: str
    position_before: float
    position_after: float
    velocity_before: float
    velocity_after: float


@dataclass(frozen=True, eq=False)
class Assembly(ReadOnly):
    """A model with consistent initial conditions, and what it took. Arrays are over bodies or joints."""

    model: Model  #: the given model with other initial positions and velocities
    moved: Floats  #: distance of each center of mass from where it was given [m]
    turned: Floats  #: angle of each body from where it was given [rad]
    velocity_change: Floats  #: of each center of mass [m/s]
    omega_change: Floats  #: in body axes [rad/s]
    position_before: Floats  #: largest residual of each joint's equations [m] or [1]
    position_after: Floats
    velocity_before: Floats  #: likewise of their derivatives [m/s] or [1/s], at the positions as given
    velocity_after: Floats
    opposed: tuple[str, ...]  #: joints whose axes point in opposite directions
    iterations: int

    @property
    def residuals(self) -> list[JointResidual]:
        """Of every joint, before and after."""
        columns = (self.position_before, self.position_after, self.velocity_before, self.velocity_after)
        core = self.model.compiled()
        return [
            JointResidual(core.joint_name(joint), *map(float, values))
            for joint, values in enumerate(zip(*columns, strict=True))
        ]

    def __str__(self) -> str:
        """One line."""
        most = [float(x.max(initial=0.0)) for x in (self.moved, self.turned)]
        before, after = (
            f"{x.max(initial=0.0):.2g} m and {v.max(initial=0.0):.2g} m/s"
            for x, v in (
                (self.position_before, self.velocity_before),
                (self.position_after, self.velocity_after),
            )
        )
        opposed = f"; axes opposed in {', '.join(self.opposed[:LISTED])}" if self.opposed else ""
        return (
            f"largest residuals {before} before, {after} after; bodies moved by at most {most[0]:.3g} m "
            f"and {most[1]:.3g} rad{opposed}"
        )

    def _repr_html_(self) -> str:
        """In a notebook: the line, and what each joint's equations miss."""
        columns = ("joint", "position before", "after [m or 1]", "velocity before", "after [m/s or 1/s]")
        rows = [(it.joint, *(f"{x:.2g}" for x in astuple(it)[1:])) for it in self.residuals]
        return f"<p>{escape(str(self))}</p>{Table('Residuals', columns, rows)._repr_html_()}"


def assemble(
    model: Model, hold: BodiesLike = (), weights: Mapping[BodyLike, float] | None = None
) -> Assembly:
    """Correct initial positions, then initial velocities, so that all joints are satisfied at t = 0.

        assembly = lw.assemble(model, hold=["crank"])
        lw.simulate(assembly.model, t_end=1.0, step=1e-3)

    Positions change by the least displacement of the bodies' mass, integral |x - x_given|^2 dm, velocities by
    the least kinetic energy of the change, (v - v_given)^T M (v - v_given) / 2 (Nikravesh, Initial condition
    correction in multibody dynamics, Multibody System Dynamics 18, 2007). Redundant joints do no harm. The
    pose is the nearest on its branch; where axes end up opposed, or the joints are not met, the branch with
    axes turned by 180 degrees is tried as well, and the nearer of both is taken.

    hold     bodies that keep the position and velocity that they have
    weights  by which the mass of a body counts, 1 where it is not given: a large weight keeps a body in place

    The given model stays as it is. ModelError: no bodies, one that does not exist, a weight that is not
    positive. NotConvergedError: joints contradict each other, in positions or velocities; its `joints` and
    `residuals` are theirs.
    """
    check_model(model)
    if not model.body_count:
        raise ModelError(f"model '{model.name}': has no bodies", code="empty")
    core, held = model.compiled(), model.indices(hold)
    held = held[held >= 0]
    assembler = _core.Assembler(core, _weights(model, {} if weights is None else weights), held.tolist())
    q0, v0 = core.q0, core.v0
    given = assembler.residuals(q0, v0)

    q, opposed = _positions(model, assembler, q0, held)
    v, consistent = assembler.velocities(q, v0)
    found = assembler.residuals(q, v)
    if not consistent:
        raise _conflict(model, "velocities", "/s", found[1], assembler.row_lengths(q), held)
    pose, pose_given, change = q.reshape(-1, 7), q0.reshape(-1, 7), (v - v0).reshape(-1, 6)
    return Assembly(
        model=model.with_initial_state(q, v, model.compiled().initial_history),
        moved=np.linalg.norm((pose - pose_given)[:, :3], axis=1),
        turned=_angles(pose[:, 3:], pose_given[:, 3:]),
        velocity_change=np.linalg.norm(change[:, :3], axis=1),
        omega_change=np.linalg.norm(change[:, 3:], axis=1),
        position_before=_per_joint(core, given[0]),
        position_after=_per_joint(core, found[0]),
        velocity_before=_per_joint(core, given[1]),
        velocity_after=_per_joint(core, found[1]),
        opposed=tuple(core.joint_name(int(joint)) for joint in opposed),
        iterations=assembler.iterations,
    )


def _positions(
    model: Model, assembler: _core.Assembler, given: Floats, held: NDArray[np.int32]
) -> tuple[Floats, NDArray[np.intp]]:
    """The nearest pose on the joints, and the joints whose axes are opposed there."""
    core = model.compiled()
    q, reached = assembler.positions(given, given)
    opposed = branches.opposed(core, q)
    if reached and (not len(opposed) or np.array_equal(q, given)):
        return q, opposed
    doubtful = np.union1d(opposed, branches.opposed(core, given))
    start = branches.aligned(core, given, doubtful, held)
    other, other_reached = assembler.positions(given, start)
    if other_reached and (not reached or assembler.distance(given, other) < assembler.distance(given, q)):
        return other, branches.opposed(core, other)
    if not reached:
        left = assembler.residuals(q, np.zeros(len(core.v0)))[0]
        raise _conflict(model, "positions", "", left, assembler.row_lengths(q), held)
    return q, opposed


def _conflict(
    model: Model, level: str, unit: str, residuals: Floats, scales: Floats, held: NDArray[np.int32]
) -> NotConvergedError:
    """Where the violation is least, its residuals n satisfy D^T n = 0: those of the joints that conflict."""
    core = model.compiled()
    each, relative = _per_joint(core, residuals), _per_joint(core, residuals / scales)
    worst = np.argsort(-relative, kind="stable")
    worst = worst[relative[worst] >= CONFLICTING * relative[worst[0]]]
    names = [core.joint_name(int(joint)) for joint in worst]
    listed = [f"{name} {each[joint]:.3g}{unit}" for name, joint in zip(names[:LISTED], worst, strict=False)]
    more = f"; and {len(names) - LISTED} more" if len(names) > LISTED else ""
    bodies = [core.body_name(int(body)) for body in held]
    holding = (
        f" while {', '.join(bodies[:LISTED])} {'are' if len(bodies) > 1 else 'is'} held" if bodies else ""
    )
    return NotConvergedError(
        f"model '{model.name}': initial {level} that satisfy all joints were not found{holding}; "
        f"these conflict (least residual, m or 1): {'; '.join(listed)}{more}",
        code=f"conflicting_{level}",
        bodies=bodies,
        joints=names,
        residuals={name: float(each[joint]) for name, joint in zip(names, worst, strict=True)},
    )


def _weights(model: Model, weights: Mapping[BodyLike, float]) -> Floats:
    """One for each body, or none at all. ModelError: not positive and finite."""
    if not isinstance(weights, Mapping):
        raise ModelError(
            f"assemble: weights {weights!r:.80} are no mapping of bodies to numbers", code="weight"
        )
    if not weights:
        return np.zeros(0)
    out = np.ones(model.body_count)
    for body, weight in weights.items():
        (index,) = model.indices(body)
        name = model.compiled().body_name(int(index))
        if index < 0 or not (is_number(weight) and weight > 0):
            why = (
                "the ground has no weight" if index < 0 else f"weight {weight!r} must be positive and finite"
            )
            raise ModelError(f"assemble: body '{name}': {why}", code="weight", bodies=[name])
        out[index] = weight
    return out


def _per_joint(core: _core.Model, residuals: Floats) -> Floats:
    """The largest of each joint's rows (joints,)."""
    starts = core.joint_rows[:-1]
    return np.maximum.reduceat(np.abs(residuals), starts) if len(starts) else np.zeros(0)


def _angles(p: Floats, p0: Floats) -> Floats:
    """Between orientations (k, 4) [rad], from the length of the chord, exact for small ones."""
    chord = np.minimum(np.linalg.norm(p - p0, axis=1), np.linalg.norm(p + p0, axis=1))
    angles: Floats = 4 * np.arcsin(np.minimum(chord / 2, 1.0))
    return angles
