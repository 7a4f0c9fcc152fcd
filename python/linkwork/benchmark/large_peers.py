"""Models of bodies, spherical joints and gravity by other codes, from the state at the start to the end.

Both are implicit: MuJoCo in the velocities, Exudyn by generalized alpha with Newton's iterations. What they
cannot do, or not in reasonable time, they refuse with the reason.
"""

from __future__ import annotations

import importlib.util
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.modeling.model import Model
from linkwork.rotation import matrix

__all__ = ["PEERS", "Peer", "missing_peers"]

#: CPU and clock [s].
Times = tuple[float, float]

#: Of MuJoCo's constraints: the hardest that it takes (solimp).
HARDEST = [0.9999, 0.9999, 1e-3, 0.5, 2.0]


#: For one run of MuJoCo, whose Newton iterations may take very long [CPU s].
MOST_SECONDS = 30.0


@dataclass(frozen=True)
class Peer:
    """A method of another code."""

    name: str
    package: str
    most_bodies: int
    run: Callable[[Model, int, float], tuple[Times, Floats]]  #: model, steps, step [s]: times, centers (n, 3)
    only_chains: bool = False  #: at rest, each link joined to the one before

    def refusal(self, model: Model) -> str:
        """Why it cannot run the model; empty: it can."""
        core = model.compiled()
        kinds = {core.joint_kind(joint) for joint in range(min(core.joint_count, 10))}
        if core.force_count or kinds != {"spherical"}:
            return "only spherical joints and gravity are translated"
        if model.body_count > self.most_bodies:
            return f"not beyond {self.most_bodies:,} bodies: building it takes minutes"
        if self.only_chains:
            bodies = core.joint_arrays()["bodies"]
            each = np.arange(model.body_count)
            if not np.array_equal(bodies, np.stack([each - 1, each], axis=1)) or np.any(core.v0):
                return "joint coordinates of chains at rest only"
        return ""


def missing_peers() -> list[str]:
    """Packages that are not installed."""
    packages = dict.fromkeys(peer.package for peer in PEERS)
    return [name for name in packages if importlib.util.find_spec(name) is None]


def _mujoco_chain(model: Model, steps: int, step: float) -> tuple[Times, Floats]:
    """Ball joints from link to link."""
    import mujoco

    spec, parent, before = _mujoco_spec(step, model), None, (np.zeros(3), np.eye(3))
    origin = model.compiled().joint_arrays()["origin"]
    for k, (r, A) in enumerate(zip(*_poses(model), strict=True)):
        parent = _mujoco_body(
            parent or spec.worldbody, model, k, before[1].T @ (r - before[0]), before[1].T @ A
        )
        parent.add_joint(type=mujoco.mjtJoint.mjJNT_BALL, pos=origin[k, 1])
        before = r, A
    own = spec.compile()
    return _mujoco_run(own, mujoco.MjData(own), steps)


def _mujoco_free(model: Model, steps: int, step: float) -> tuple[Times, Floats]:
    """Bodies with six coordinates, held together by soft constraints."""
    import mujoco

    spec, core = _mujoco_spec(step, model), model.compiled()
    for k, (r, A) in enumerate(zip(*_poses(model), strict=True)):
        _mujoco_body(spec.worldbody, model, k, r, A).add_freejoint()
    joints = core.joint_arrays()
    for bodies, origin in zip(joints["bodies"], joints["origin"], strict=True):
        side = 0 if bodies[0] >= 0 else 1
        names = ["world" if body < 0 else f"body {body}" for body in bodies]
        equality = spec.add_equality(
            type=mujoco.mjtEq.mjEQ_CONNECT, objtype=mujoco.mjtObj.mjOBJ_BODY, name1=names[side],
            name2=names[1 - side], solimp=HARDEST, solref=[2 * step, 1.0],
        )  # fmt: skip
        equality.data[:3] = origin[side]
    own = spec.compile()
    data = mujoco.MjData(own)
    data.qvel[:] = core.v0
    return _mujoco_run(own, data, steps)


def _mujoco_spec(step: float, model: Model) -> Any:
    """No contacts, no islands, memory enough."""
    import mujoco

    spec = mujoco.MjSpec()
    spec.option.gravity, spec.option.timestep = model.compiled().gravity, step
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.disableflags = int(mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_ISLAND)
    spec.memory = 2**30
    return spec


def _mujoco_body(parent: Any, model: Model, k: int, position: Floats, rotation: Floats) -> Any:
    """Inertia must be diagonal in body axes: that of rods and balls is."""
    import mujoco

    core, quaternion = model.compiled(), np.empty(4)
    mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(rotation).ravel())
    return parent.add_body(
        name=f"body {k}", pos=position, quat=quaternion, explicitinertial=True, mass=core.mass[k],
        ipos=np.zeros(3), inertia=np.diag(np.reshape(core.inertia[k], (3, 3))),
    )  # fmt: skip


def _mujoco_run(own: Any, data: Any, steps: int) -> tuple[Times, Floats]:
    import mujoco

    cpu, clock = time.process_time(), time.perf_counter()
    for _ in range(steps):
        mujoco.mj_step(own, data)
        if time.process_time() - cpu > MOST_SECONDS:
            raise RuntimeError(f"not done after {MOST_SECONDS:g} s")
    times = time.process_time() - cpu, time.perf_counter() - clock
    mujoco.mj_kinematics(own, data)
    if data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:
        raise RuntimeError("accelerations are not finite")
    return times, np.array(data.xpos[1:])


def _exudyn(model: Model, steps: int, step: float) -> tuple[Times, Floats]:
    """Bodies with Euler parameters, Lagrange multipliers; the times are with the initialization."""
    import exudyn as exu
    from exudyn import itemInterface

    items: Any = itemInterface  # without types
    container = exu.SystemContainer()
    system, core = container.AddSystem(), model.compiled()
    ground, p = system.AddObject(items.ObjectGround()), np.reshape(core.q0, (-1, 7))
    bodies = [_exudyn_body(system, items, core, k, p[k]) for k in range(model.body_count)]
    joints = core.joint_arrays()
    for pair, origin in zip(joints["bodies"], joints["origin"], strict=True):
        markers = [
            system.AddMarker(
                items.MarkerBodyRigid(bodyNumber=ground if k < 0 else bodies[k], localPosition=place)
            )
            for k, place in zip(pair, origin, strict=True)
        ]
        system.AddObject(items.ObjectJointSpherical(markerNumbers=markers))
    system.Assemble()
    settings = _exudyn_settings(exu, steps, step)
    cpu, clock = time.process_time(), time.perf_counter()
    done = system.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    times = time.process_time() - cpu, time.perf_counter() - clock
    if not done:
        raise RuntimeError("Newton's iterations did not converge")
    kind = exu.OutputVariableType.Position
    return times, np.array([system.GetObjectOutputBody(body, kind, [0, 0, 0]) for body in bodies])


def _exudyn_body(system: Any, items: Any, core: Any, k: int, pose: Floats) -> int:
    v, J = np.reshape(core.v0, (-1, 6))[k], np.reshape(core.inertia[k], (3, 3))
    e, omega = pose[3:], v[3:]
    e_dot = 0.5 * np.append(-e[1:] @ omega, e[0] * omega + np.cross(e[1:], omega))
    node = system.AddNode(
        items.NodeRigidBodyEP(referenceCoordinates=list(pose), initialVelocities=[*v[:3], *e_dot])
    )
    moments = [J[0, 0], J[1, 1], J[2, 2], J[1, 2], J[0, 2], J[0, 1]]
    number: int = system.AddObject(items.ObjectRigidBody(mass=core.mass[k], inertia=moments, nodeNumber=node))
    weight = system.AddMarker(items.MarkerBodyMass(bodyNumber=number))
    system.AddLoad(items.LoadMassProportional(markerNumber=weight, loadVector=core.gravity))
    return number


def _exudyn_settings(exu: Any, steps: int, step: float) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = steps * step
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.stepInformation = 0
    settings.solution.file.write = False
    settings.solution.sensors.active = False
    settings.show.globalTimers = False
    settings.parallel.numberOfThreads = 1
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    return settings


def _poses(model: Model) -> tuple[Floats, Floats]:
    """Centers (n, 3) and rotations (n, 3, 3) at the start."""
    q = np.reshape(model.compiled().q0, (-1, 7))
    return q[:, :3], matrix(q[:, 3:])


#: MuJoCo compiles a model in a time that grows with the square of its bodies.
PEERS: Sequence[Peer] = (
    Peer("MuJoCo implicit, joint coordinates", "mujoco", 3000, _mujoco_chain, only_chains=True),
    Peer("MuJoCo implicit, soft constraints", "mujoco", 3000, _mujoco_free),
    Peer("Exudyn generalized alpha", "exudyn", 10_000, _exudyn),
)
