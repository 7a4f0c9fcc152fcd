"""Accelerations of imported MJCF files against those of MuJoCo, at random states."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import linkwork as lw
import mujoco
import numpy as np
from linkwork.importers.frames import turned

#: What is soft in MuJoCo, or not in the model here.
LEFT_OUT = ("CONTACT", "CONSTRAINT", "ACTUATION")

SCALAR = (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE))
FREE = int(mujoco.mjtJoint.mjJNT_FREE)


class State:
    """A random state of MuJoCo's model, first of its scalar joints, then of all."""

    def __init__(self, path: Path, rng: np.random.Generator, spread: float) -> None:
        mujoco.set_mju_user_warning(lambda _: None)  # else it writes warnings to a file
        self.model = mujoco.MjModel.from_xml_path(str(path))
        mujoco.set_mju_user_warning(None)
        for flag in LEFT_OUT:
            self.model.opt.disableflags |= int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag}"))
        self.data = mujoco.MjData(self.model)
        there = lw.import_mjcf(path, couple=False).model.compiled()
        #: of linkwork's model, which has one for several of a body or one for each
        self._joints = {there.joint_name(k) for k in range(there.joint_count)}
        self._rng, self._spread = rng, spread
        self.coordinates: dict[str, Any] = {}
        self.velocities: dict[str, Any] = {}

    def name(self, kind: str, index: int) -> str:
        object_type = getattr(mujoco.mjtObj, f"mjOBJ_{kind.upper()}")
        return mujoco.mj_id2name(self.model, object_type, index) or f"{kind} {index}"

    def joints(self, body: int) -> range:
        first = int(self.model.body_jntadr[body])
        return range(first, first + int(self.model.body_jntnum[body])) if first >= 0 else range(0)

    def _random(self, count: int) -> np.ndarray:
        return self._rng.uniform(-self._spread, self._spread, count)

    def move_scalars(self) -> None:
        model, data = self.model, self.data
        for body in range(1, model.nbody):
            joints = self.joints(body)
            if not joints or any(int(model.jnt_type[k]) not in SCALAR for k in joints):
                continue
            q, dofs = model.jnt_qposadr[list(joints)], model.jnt_dofadr[list(joints)]
            data.qpos[q] = model.qpos0[q] + self._random(len(q))
            data.qvel[dofs] = self._random(len(q))
            labels = [self.name("joint", k) for k in joints]
            given = {label: slice(k, k + 1) for k, label in enumerate(labels)}
            if "+".join(labels) in self._joints:
                given = {"+".join(labels): slice(None)}
            for label, which in given.items():
                self.coordinates[label] = data.qpos[q][which].copy()
                self.velocities[label] = data.qvel[dofs][which].copy()
        mujoco.mj_forward(model, data)

    def move_all(self) -> None:
        """And free bodies and balls."""
        model, data = self.model, self.data
        for k in range(model.njnt):
            if int(model.jnt_type[k]) not in SCALAR:
                dof, free = int(model.jnt_dofadr[k]), int(model.jnt_type[k]) == FREE
                data.qvel[dof : dof + (6 if free else 3)] = self._random(6 if free else 3)
                q = int(model.jnt_qposadr[k]) + (3 if free else 0)
                turned = data.qpos[q : q + 4] + self._random(4)
                data.qpos[q : q + 4] = turned / np.linalg.norm(turned)
        mujoco.mj_forward(model, data)
        mujoco.mj_rnePostConstraint(model, data)

    def rates(self, body: int) -> tuple[np.ndarray, np.ndarray]:
        """Velocity of the center of mass and angular velocity, inertial."""
        out = np.zeros(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, body, out, 0)
        return out[3:], out[:3]

    def accelerations(self, body: int) -> tuple[np.ndarray, np.ndarray]:
        out, flags = np.zeros(6), self.model.opt.disableflags
        mujoco.mj_objectAcceleration(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, body, out, 0)
        weightless = flags & int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)
        return out[3:] + (0.0 if weightless else self.model.opt.gravity), out[
            :3
        ]  # theirs is against free fall

    def between_joints(
        self, body: int
    ) -> Iterator[tuple[str, np.ndarray, np.ndarray, np.ndarray, np.ndarray]]:
        """Of the massless link behind each joint of a body but its last: name, r, A, r_dot and omega.

        From the body toward its parent: the motion of a joint is taken from that of what it carries.
        """
        model, data, kinds = self.model, self.data, mujoco.mjtJoint
        A = data.xmat[body].reshape(3, 3)
        velocity, omega = self.rates(body)
        at = data.xipos[body].copy()
        for k in reversed(self.joints(body)[1:]):
            q, dof, anchor, axis = model.jnt_qposadr[k], model.jnt_dofadr[k], data.xanchor[k], data.xaxis[k]
            velocity, at = velocity + np.cross(omega, anchor - at), anchor
            turn = np.eye(3)
            if model.jnt_type[k] == kinds.mjJNT_SLIDE:
                velocity = velocity - axis * data.qvel[dof]
            elif model.jnt_type[k] == kinds.mjJNT_HINGE:
                turn = turned(model.jnt_axis[k], data.qpos[q] - model.qpos0[q]).A
                omega = omega - axis * data.qvel[dof]
            else:
                turn = lw.rotation.matrix(data.qpos[q : q + 4])
                omega = omega - A @ data.qvel[dof : dof + 3]
            A = A @ turn.T
            r = anchor - A @ model.jnt_pos[k]
            yield f"{self.name('joint', k - 1)} link", r, A, velocity + np.cross(omega, r - at), omega

    def body_of(self, name: str) -> int:
        """-1: it is no body of MuJoCo. A rotor of a free joint is with the joint's body."""
        for body in range(1, self.model.nbody):
            labels = [self.name("joint", k) for k in self.joints(body) if int(self.model.jnt_type[k]) == FREE]
            if name == self.name("body", body) or name in [f"{label} rotor" for label in labels]:
                return body
        return -1


def place_between_joints(state: State, core: Any, q: np.ndarray, v: np.ndarray) -> None:
    for body in range(1, state.model.nbody):
        for name, r, A, velocity, omega in state.between_joints(body):
            if (k := core.find_body(name)) >= 0:
                q[k, :3], q[k, 3:] = r, lw.rotation.from_matrix(A)
                v[k, :3], v[k, 3:] = velocity, A.T @ omega


def largest_difference(path: Path, rng: np.random.Generator, spread: float = 1.0, **options: Any) -> float:
    """Of accelerations, relative to the largest; positions of bodies are compared on the way."""
    state = State(path, rng, spread)
    state.move_scalars()
    imported = lw.import_mjcf(path, coordinates=state.coordinates, velocities=state.velocities, couple=False,
                              **options)  # fmt: skip
    model, core = imported.model, imported.model.compiled()
    q, v = np.array(core.q0).reshape(-1, 7), np.array(core.v0).reshape(-1, 6)
    bodies = {k: state.body_of(core.body_name(k)) for k in range(core.body_count)}
    bodies = {k: body for k, body in bodies.items() if body > 0}
    data, arms = state.data, {}
    for k, body in bodies.items():
        R = data.xmat[body].reshape(3, 3)
        assert np.abs(lw.rotation.matrix(q[k, 3:]) - R).max() < 1e-12, core.body_name(k)
        arms[k] = R.T @ (q[k, :3] - data.xipos[body])  # other than zero where links are merged
    for k, name in enumerate(state.name("body", body) for body in bodies.values()):
        merged = np.linalg.norm(list(arms.values())[k]) > 1e-12
        assert not merged or any(name in note.message + note.subject for note in imported.notes), name
    state.move_all()
    for k, body in bodies.items():
        R, (velocity, omega) = data.xmat[body].reshape(3, 3), state.rates(body)
        q[k, :3], q[k, 3:] = data.xipos[body] + R @ arms[k], lw.rotation.from_matrix(R)
        v[k, :3], v[k, 3:] = velocity + np.cross(omega, R @ arms[k]), R.T @ omega
    place_between_joints(state, core, q, v)
    v_dot = lw.System(model.with_initial_state(q.ravel(), v.ravel())).accelerations(
        0.0, q.ravel(), v.ravel()
    )[0]
    worst, scale = 0.0, 1.0
    for k, body in bodies.items():
        R, (_, omega), (a, alpha) = (
            data.xmat[body].reshape(3, 3),
            state.rates(body),
            state.accelerations(body),
        )
        arm = R @ arms[k]
        theirs = np.concatenate([a + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm)), alpha])
        ours = v_dot.reshape(-1, 6)[k]
        worst = max(worst, float(np.abs(np.concatenate([ours[:3], R @ ours[3:]]) - theirs).max()))
        scale = max(scale, float(np.abs(theirs).max()))
    return worst / scale
