"""MuJoCo: free bodies held by equality constraints, or a tree of joints whose loops are closed by them.

Its constraints are soft by design: the hardest impedance d that it takes, 0.9999, adds (1 - d) / d = 1e-4 of
its diagonal to D M^-1 D^T. In a long chain or a net that counts: the deviation says what it comes to.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import partial
from pathlib import Path

import mujoco
import numpy as np
from mechanism import GROUND, SPAN, Floats, Mechanism, deviation, spanning_tree
from mujoco import MjData, MjModel, MjSpec
from operation import (
    FIRST_ORDER,
    MOST_STEPS,
    STEP,
    Builders,
    Operation,
    OutOfReach,
    calls,
    typical,
    without_call,
)

HARDEST = [0.9999, 0.9999, 1e-3, 0.5, 2.0]  # solimp
MOST_BODIES = 10_000
SOFT = 2e-2  #: tolerance with equality constraints, see above
ROUNDOFF = 1e-16  #: tolerance without, times n^4: so the condition of a chain's inertia matrix grows

System = tuple[MjModel, MjData]


def free_bodies(mechanism: Mechanism) -> System:
    """Bodies with six coordinates. There is no equality that is a hinge: a revolute joint is two points."""
    spec = _spec(mechanism)
    for body in range(mechanism.body_count):
        _add_body(spec.worldbody, mechanism, body, *mechanism.pose(body)).add_freejoint()
    for joint in range(mechanism.joint_count):
        _connect(spec, mechanism, joint)
    model = spec.compile()
    data = MjData(model)
    data.qvel[:] = mechanism.v.ravel()
    return model, data


def tree(mechanism: Mechanism) -> System:
    """Joint coordinates."""
    spec = _spec(mechanism)
    branches, loops = spanning_tree(mechanism)
    made, omega = {GROUND: spec.worldbody}, {}
    for branch in branches:
        (r_i, A_i), (r, A) = mechanism.pose(branch.parent), mechanism.pose(branch.body)
        body = _add_body(made[branch.parent], mechanism, branch.body, A_i.T @ (r - r_i), A_i.T @ A)
        frame = mechanism.frame[branch.joint, branch.side]
        relative = mechanism.relative_omega(branch.joint, branch.side)
        hinge = mechanism.kind[branch.joint] == "revolute"
        body.add_joint(
            name=body.name,
            type=mujoco.mjtJoint.mjJNT_HINGE if hinge else mujoco.mjtJoint.mjJNT_BALL,
            pos=mechanism.origin[branch.joint, branch.side],
            axis=frame[:, 2],
        )
        made[branch.body], omega[body.name] = body, relative[2:] if hinge else frame @ relative
    for joint in loops:
        _connect(spec, mechanism, joint)
    model = spec.compile()
    data = MjData(model)
    for name, relative in omega.items():
        data.joint(name).qvel[:] = relative
    return model, data


def _spec(mechanism: Mechanism) -> MjSpec:
    """No contacts; no islands, which only cost where everything hangs together.

    OutOfReach: so many bodies that compiling the model takes minutes, in proportion to their square.
    """
    if mechanism.body_count > MOST_BODIES:
        raise OutOfReach(f"compiling more than {MOST_BODIES} bodies takes minutes")
    spec = MjSpec()
    spec.option.gravity, spec.option.timestep = mechanism.gravity, STEP
    spec.option.disableflags = int(mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_ISLAND)
    spec.memory = 2**30
    return spec


def _add_body(
    parent: mujoco.MjsBody, mechanism: Mechanism, body: int, position: Floats, rotation: Floats
) -> mujoco.MjsBody:
    J = mechanism.inertia[body]
    moments, axes = (np.diag(J), np.eye(3)) if np.array_equal(J, np.diag(np.diag(J))) else np.linalg.eigh(J)
    return parent.add_body(
        name=f"body {body}",
        pos=position,
        quat=_quaternion(rotation),
        explicitinertial=True,
        mass=mechanism.mass[body],
        ipos=np.zeros(3),
        inertia=moments,
        iquat=_quaternion(axes * np.sign(np.linalg.det(axes))),
    )


def _quaternion(rotation: Floats) -> Floats:
    found = np.empty(4)
    mujoco.mju_mat2Quat(found, np.ascontiguousarray(rotation).ravel())
    return found


def _connect(spec: MjSpec, mechanism: Mechanism, joint: int) -> None:
    """The other body's points follow from the initial pose."""
    side = 0 if mechanism.bodies[joint, 0] != GROUND else 1
    names = ["world" if body == GROUND else f"body {body}" for body in mechanism.bodies[joint]]
    for point in mechanism.pin_points(joint, side):
        equality = spec.add_equality(
            type=mujoco.mjtEq.mjEQ_CONNECT,
            objtype=mujoco.mjtObj.mjOBJ_BODY,
            name1=names[side],
            name2=names[1 - side],
            solimp=HARDEST,
        )
        equality.data[:3] = point


def body_accelerations(mechanism: Mechanism, model: MjModel, data: MjData) -> Floats:
    """(n, 6): inertial, and the rate of omega in body axes; MuJoCo's own are against a frame in free fall."""
    mujoco.mj_rnePostConstraint(model, data)
    found, a = np.empty((mechanism.body_count, 6)), np.empty(6)
    for body in range(mechanism.body_count):
        number = model.body(f"body {body}").id
        mujoco.mj_objectAcceleration(model, data, mujoco.mjtObj.mjOBJ_BODY, number, a, 0)
        found[body] = *(a[3:] + mechanism.gravity), *(mechanism.rotation[body].T @ a[:3])
    return found


def body_velocities(mechanism: Mechanism, model: MjModel, data: MjData) -> Floats:
    """(n, 6): inertial, and omega in body axes."""
    found, v = np.empty((mechanism.body_count, 6)), np.empty(6)
    for body in range(mechanism.body_count):
        number = model.body(f"body {body}").id
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, number, v, 0)
        found[body] = *v[3:], *(data.body(number).xmat.reshape(3, 3).T @ v[:3])
    return found


def forward(build: Callable[[Mechanism], System], mechanism: Mechanism) -> Operation:
    """mj_forward at one state: accelerations and constraint forces."""
    model, data = build(mechanism)
    call = partial(mujoco.mj_forward, model, data)
    call()
    error = deviation(body_accelerations(mechanism, model, data), mechanism.acceleration)
    tolerance = SOFT if model.neq else max(1e-10, ROUNDOFF * model.nv**4)
    note = f"{model.nv} coordinates, {data.nefc} equations; less an empty call"
    return Operation(partial(_seconds, call), "rhs", error, tolerance, note)


def _seconds(call: Callable[[], object], seconds: float) -> float:
    none = MjSpec().compile()
    return without_call(call, partial(mujoco.mj_forward, none, MjData(none)), seconds)


def native_forward(model: MjModel, data: MjData) -> tuple[Callable[[], object], Callable[[], object]]:
    """mj_forward without the bindings, which take as long as a small model, and a call that does nothing.

    Nor with the clock that the bindings have it read some ten times a call, from then on in this process.
    Neither function holds the model and the data: their caller must.
    """
    (file,) = Path(mujoco.__file__).parent.glob("libmujoco*")
    library = ctypes.PyDLL(str(file))
    ctypes.c_void_p.in_dll(library, "mjcb_time").value = None
    pair = [ctypes.c_void_p(it._address) for it in (model, data)]
    library.mj_forward.restype = library.mju_zero3.restype = None
    room = ctypes.create_string_buffer(3 * ctypes.sizeof(ctypes.c_double))
    nothing = partial(library.mju_zero3, ctypes.cast(room, ctypes.c_void_p), pair[1])
    return partial(library.mj_forward, *pair), nothing


def step(build: Callable[[Mechanism], System], mechanism: Mechanism) -> Operation:
    """mj_step, in motion from the same state again and again."""
    model, data = build(mechanism)
    q, v = data.qpos.copy(), data.qvel.copy()

    def restore() -> None:
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = q, v

    def batch(count: int) -> float:
        restore()
        return calls(partial(mujoco.mj_step, model, data, count))(1)

    batch(round(SPAN / STEP))
    mujoco.mj_forward(model, data)
    found = (body_velocities(mechanism, model, data) - mechanism.v) / SPAN
    return Operation(
        partial(typical, batch, most=MOST_STEPS),
        "semi_implicit_euler step",
        deviation(found, mechanism.mean_acceleration),
        FIRST_ORDER,
    )


OPERATIONS: Builders = {
    f"{name} {build.__name__.replace('_', ' ')}": partial(operation, build)
    for build in (free_bodies, tree)
    for name, operation in (("mj_forward", forward), ("mj_step", step))
}
