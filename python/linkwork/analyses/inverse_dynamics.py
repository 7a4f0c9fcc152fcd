"""Inverse dynamics: what drivers must exert for the motion that they prescribe."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core
from linkwork.analyses.kinematics import kinematics
from linkwork.arguments import is_iterable
from linkwork.arrays import Floats, ReadOnly, by_value
from linkwork.constraints.equations import called
from linkwork.equations.system import System
from linkwork.errors import ModelError, OptionError, nearest
from linkwork.modeling.elements import KINDS
from linkwork.modeling.handles import Joint
from linkwork.modeling.model import Model, check_bodies
from linkwork.motion import summary
from linkwork.results.forces import clock
from linkwork.results.result import Result

__all__ = ["Drive", "InverseDynamics", "inverse_dynamics"]

#: Of a multiplier, by the quantity of its equation.
UNITS = {"rotation": "N m", "translation": "N", "distance": "N"}


@by_value
@dataclass(frozen=True)
class Drive(ReadOnly):
    """What one driver does over time (k,)."""

    joint: str
    kind: str
    effort: Floats  #: multiplier: torque [N m] of an angle_driver, force [N] of a displacement_driver, on b
    power: Floats  #: that it gives to the mechanism [W]
    unique: bool  #: False: other drivers or joints could do a part of it; the effort is a share of least norm

    @property
    def unit(self) -> str:
        """Of the effort: "N m" of a driver of an angle, "N" of a shift or distance."""
        (equation,) = KINDS["joint"][self.kind].equations.values()
        return UNITS.get(equation.quantity, "N or N m")


@dataclass(frozen=True, eq=False)
class InverseDynamics:
    """A prescribed motion and what it needs."""

    motion: Result  #: with the reactions of all joints
    drives: Mapping[str, Drive]  #: by name of the driver

    @property
    def t(self) -> Floats:
        """Times (k,) [s]."""
        return self.motion.t

    def effort(self, name: str | Joint) -> Floats:
        """Torque [N m] or force [N] (k,) of one driver on its second body, by its name or handle.

            torque = needed.effort("motor")

        ModelError: no such driver.
        """
        text = name.name if isinstance(name, Joint) else name
        if not isinstance(text, str) or text not in self.drives:
            raise ModelError(
                f"no driver named {text!r:.80}{nearest(str(text), self.drives)}", code="unknown_name"
            )
        return self.drives[text].effort

    def __str__(self) -> str:
        """A line for each driver, with the largest of what it needs, and one for impacts."""
        struck = summary.impacts(self.motion)
        lines = [self._line(drive) for drive in self.drives.values()]
        return "\n".join([*lines, *([f"impacts: {struck}"] if struck else [])])

    def _line(self, drive: Drive) -> str:
        k = int(np.abs(drive.effort).argmax())
        shared = "" if drive.unique else ", a share of what several could do"
        return (
            f"{drive.joint}: {drive.effort[k]:.6g} {drive.unit} at t = {self.t[k]:.6g} s, power from "
            f"{drive.power.min():.6g} to {drive.power.max():.6g} W{shared}"
        )


def inverse_dynamics(
    model: Model,
    times: ArrayLike,
    *,
    drivers: Sequence[str | Joint] | None = None,
    on_singular: Literal["pass", "warn", "stop"] = "warn",
) -> InverseDynamics:
    """The driving forces and torques, and all reactions, of a mechanism whose freedoms drivers fix.

        needed = lw.inverse_dynamics(model, np.linspace(0, 2, 201))
        needed.effort("motor")

    D^T lambda = M v_dot - g along the motion of `linkwork.kinematics`; the multiplier of a driver is what it
    exerts. As a function of time, `lw.functions.table(needed.t, needed.effort("motor"))`, given to a torque
    or actuator in the driver's place, it makes forward dynamics return the motion.

    drivers  names or handles of one-equation joints; without them all that are drivers, and others of one
             equation with a function of time, such as a distance joint of variable length

    Where the velocity of a driver jumps, bodies are struck by an impulse, which no effort has a part of: a
    warning says when, and so does what is printed.

    Errors as for `kinematics`. ModelError: a driver that does not exist, or with more than one equation.
    OptionError: drivers that are no list of names or handles.
    """
    check_bodies(model)
    core = model.compiled()
    if drivers is not None:
        _check_names(drivers)
    chosen = _drivers(model) if drivers is None else [_driver(core, name) for name in drivers]
    motion = kinematics(model, times, on_singular=on_singular)
    rows = np.asarray(core.joint_rows)[chosen].astype(int)
    effort = motion.multipliers[:, rows]
    power = 0.0 - effort * _rates(model, motion, rows)  # v^T D^T lambda, with D v = -Phi_t
    drives = [
        Drive(core.joint_name(joint), core.joint_kind(joint), effort[:, k], power[:, k],
              bool(motion.unique_reactions[joint]))
        for k, joint in enumerate(chosen)
    ]  # fmt: skip
    return InverseDynamics(motion, {drive.joint: drive for drive in drives})


def _check_names(drivers: Sequence[str | Joint]) -> None:
    """OptionError: not a list of names or handles."""
    names = [] if isinstance(drivers, str) or not is_iterable(drivers) else list(drivers)
    if not names or not all(isinstance(name, str | Joint) for name in names):
        raise OptionError(
            f"inverse_dynamics: drivers {drivers!r:.80} are not a list of names of joints", code="drivers"
        )


def _rates(model: Model, motion: Result, rows: NDArray[np.integer]) -> Floats:
    """Phi_t (k, rows) along the motion."""
    dynamics = System(model).compiled()
    found: Floats = dynamics.constraint_rates(clock(motion), motion.q, motion.v, list(rows))
    return found


def _drivers(model: Model) -> list[int]:
    """Joints of one equation that are made to drive, or that a function of time drives. ModelError: none."""
    core = model.compiled()
    arrays, rows = core.joint_arrays(), np.diff(core.joint_rows)
    ends = np.append(arrays["first_parameter"], len(arrays["signals"]))
    found = [
        joint
        for joint in np.flatnonzero(rows == 1)
        if KINDS["joint"][core.joint_kind(int(joint))].driver
        or (arrays["signals"][ends[joint] : ends[joint + 1]] >= 0).any()
    ]
    if not found:
        raise ModelError(
            f"inverse_dynamics: {called(model)} has no drivers; add an angle_driver or a "
            "displacement_driver",
            code="no_drivers",
        )
    return [int(joint) for joint in found]


def _driver(core: _core.Model, given: str | Joint) -> int:
    """ModelError: no such joint, or not of one equation."""
    name = given.name if isinstance(given, Joint) else given
    joint = core.find_joint(name)
    if (
        isinstance(given, Joint)
        and joint >= 0
        and (joint, core.joint_kind(joint)) != (given.index, given.kind)
    ):
        raise ModelError(f"inverse_dynamics: joint '{name}' belongs to another model", code="unknown_joint")
    if joint < 0:
        known = [core.joint_name(k) for k in range(core.joint_count)]
        raise ModelError(f"no joint named '{name}'{nearest(name, known)}", code="unknown_name")
    count = int(np.diff(core.joint_rows)[joint])
    if count != 1:
        raise ModelError(
            f"inverse_dynamics: joint '{name}' has {count} equations and drives nothing: see its reaction",
            code="no_driver",
            joints=[name],
        )
    return joint
