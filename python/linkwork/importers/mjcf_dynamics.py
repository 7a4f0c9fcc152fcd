"""What acts at the joints of a compiled MuJoCo model: springs, dampers, friction, rotors."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.importers.description import JointDescription

if TYPE_CHECKING:
    import mujoco

__all__ = ["JointDynamics", "is_disabled"]


def is_disabled(model: mujoco.MjModel, *flags: str) -> bool:
    """Whether the file disables one of these, such as gravity."""
    import mujoco

    bits = (getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag.upper()}") for flag in flags)
    return any(model.opt.disableflags & int(bit) for bit in bits)


class JointDynamics:
    """Coefficients of joints, one for each of their degrees of freedom; zero where flags disable them."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self.damping, self.armature = np.array(model.dof_damping), np.array(model.dof_armature)
        self.friction, self.stiffness = np.array(model.dof_frictionloss), np.array(model.jnt_stiffness)
        self.bent = np.any(model.dof_dampingpoly, axis=1)  #: dofs and joints whose laws are not linear
        self.bent_springs = np.any(model.jnt_stiffnesspoly, axis=1)
        self.lost_actuators = [k for k in range(model.nu) if not self._add_actuator(k)]
        if is_disabled(model, "spring"):
            self.stiffness[:], self.bent_springs[:] = 0.0, False
        if is_disabled(model, "damper"):
            self.damping[:], self.bent[:] = 0.0, False
        if is_disabled(model, "frictionloss", "constraint"):
            self.friction[:] = 0.0

    # An actuator at a hinge or slide moves by gear times the joint's coordinate: its own damping and inertia
    # count gear^2 times.
    def _add_actuator(self, k: int) -> bool:
        """False: it has damping or inertia that cannot be at the joint."""
        import mujoco

        model, kinds = self._model, mujoco.mjtJoint
        damping, armature = float(model.actuator_damping[k]), float(model.actuator_armature[k])
        polynomial = np.any(model.actuator_dampingpoly[k])
        if not damping and not armature and not polynomial:
            return True
        transmissions = mujoco.mjtTrn
        at_joint = (int(transmissions.mjTRN_JOINT), int(transmissions.mjTRN_JOINTINPARENT))
        joint = int(model.actuator_trnid[k, 0])
        simple = (int(kinds.mjJNT_HINGE), int(kinds.mjJNT_SLIDE))
        if int(model.actuator_trntype[k]) not in at_joint or int(model.jnt_type[joint]) not in simple:
            return False
        dof, gear = int(model.jnt_dofadr[joint]), float(model.actuator_gear[k, 0])
        self.damping[dof] += gear**2 * damping
        self.armature[dof] += gear**2 * armature
        self.bent[dof] |= bool(polynomial)
        return True

    def dofs(self, joints: range) -> slice:
        first, last = joints[0], joints[-1]
        count = {0: 6, 1: 3}.get(int(self._model.jnt_type[last]), 1)
        return slice(int(self._model.jnt_dofadr[first]), int(self._model.jnt_dofadr[last]) + count)

    def set(self, k: int, joint: JointDescription) -> None:
        """Of one joint: all its degrees of freedom have the same."""
        dof = int(self._model.jnt_dofadr[k])
        joint.damping, joint.friction = float(self.damping[dof]), float(self.friction[dof])
        joint.armature, joint.stiffness = float(self.armature[dof]), float(self.stiffness[k])

    def any_at(self, joints: range) -> bool:
        """Whether anything acts at these joints."""
        dofs = self.dofs(joints)
        values: list[Any] = [self.damping[dofs], self.armature[dofs], self.friction[dofs]]
        return any(np.any(value) for value in [*values, self.stiffness[list(joints)]])

    def pulls(self, tendon: int) -> bool:
        """Whether a tendon exerts forces of its own, beside those of actuators and limits."""
        model = self._model
        kinds = {"stiffness": ["spring"], "stiffnesspoly": ["spring"], "damping": ["damper"],
                 "dampingpoly": ["damper"], "frictionloss": ["frictionloss", "constraint"],
                 "armature": []}  # fmt: skip
        return any(
            np.any(getattr(model, f"tendon_{it}")[tendon]) and not is_disabled(model, *flags)
            for it, flags in kinds.items()
        )

    def is_bent(self, joints: range) -> bool:
        return bool(np.any(self.bent[self.dofs(joints)]) or np.any(self.bent_springs[list(joints)]))
