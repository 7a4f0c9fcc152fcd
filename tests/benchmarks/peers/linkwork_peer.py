"""linkwork: the mechanisms that all are compared on, and the operations that the peers' are compared to."""

from __future__ import annotations

import time
from functools import partial
from typing import Any

import linkwork as lw
import numpy as np
from linkwork import rotation
from linkwork.benchmark.motion_to_end import Motion, move
from mechanism import SPAN, Floats, Mechanism, deviation
from operation import FIRST_ORDER, STEP, Builders, Operation, beyond_first, calls, typical

JOINTS = ("revolute", "spherical")  # that all peers have


def describe(model: lw.Model, name: str, formulation: str = "standard") -> Mechanism:
    """The mechanism 2 SPAN into its motion; joint frames are taken anew there.

    ValueError: a kind of joint or force that the peers do not translate.
    """
    core = model.compiled()
    kind = np.array([core.joint_kind(joint) for joint in range(core.joint_count)])
    if core.force_count or not set(kind) <= set(JOINTS):
        raise ValueError(f"{name}: only {' and '.join(JOINTS)} joints and gravity can be compared")
    run = _simulate(model, formulation, 3, round(SPAN / STEP))
    arrays = core.joint_arrays()
    A = rotation.matrix(run.orientation[2])
    A_i, A_j = np.swapaxes(np.concatenate([A, np.eye(3)[None]])[arrays["bodies"]], 0, 1)
    frame_i = arrays["frame"][:, 0]
    return Mechanism(
        name=name,
        formulation=formulation,
        gravity=core.gravity,
        mass=core.mass,
        inertia=core.inertia,
        position=run.position[2],
        orientation=run.orientation[2],
        rotation=A,
        velocity=run.velocity[2],
        omega=run.omega[2],
        kind=kind,
        bodies=arrays["bodies"],
        origin=arrays["origin"],
        frame=np.stack([frame_i, np.swapaxes(A_j, 1, 2) @ A_i @ frame_i], axis=1),
        dependent=_dependent(model, formulation),
        acceleration=np.concatenate([run.acceleration[2], run.angular_acceleration[2]], axis=1),
        mean_acceleration=_mean_acceleration(run, 2),
    )


def _simulate(
    model: lw.Model, formulation: str, frames: int, steps: int, integrator: str = "rk4"
) -> lw.Result:
    """So many frames after the first, with so many steps to each."""
    t_end = frames * steps * STEP
    return lw.simulate(
        model, t_end, STEP, integrator, formulation=formulation, record_every=steps, progress=False,
        on_inaccurate="pass",
    )  # fmt: skip


def _mean_acceleration(run: lw.Result, frame: int) -> Floats:
    """(n, 6) from this frame to the next, SPAN later."""
    change = run.v[frame + 1] - run.v[frame]
    return np.asarray(change.reshape(-1, 6) / SPAN)


def _dependent(model: lw.Model, formulation: str) -> np.ndarray[Any, np.dtype[np.bool_]]:
    core = model.compiled()
    dependent = np.zeros((core.joint_count, 5), bool)
    for row in lw.System(model, formulation=formulation).compiled().rank().redundant_rows:
        joint = int(np.searchsorted(core.joint_rows, row, side="right")) - 1
        dependent[joint, row - core.joint_rows[joint]] = True
    return dependent


def build(mechanism: Mechanism) -> lw.Model:
    """The mechanism as a model again."""
    model = lw.Model(gravity=mechanism.gravity, name=mechanism.name)
    fields = ("mass", "inertia", "position", "orientation", "velocity", "omega")
    model.bodies("body", **{field: getattr(mechanism, field) for field in fields})
    for kind in JOINTS:
        chosen = mechanism.kind == kind
        if not chosen.any():
            continue
        pairs = (mechanism.bodies, mechanism.origin, mechanism.frame[..., 2])
        (a, b), at, axes = (tuple(np.swapaxes(array[chosen], 0, 1)) for array in pairs)
        axis = {"axis": axes} if kind == "revolute" else {}
        model.joints(kind, a, b, at=at, frames="body", name=kind, **axis)
    return model


def right_hand_side(mechanism: Mechanism) -> Operation:
    """Accelerations and reactions at a state, as an integrator has them: looped in compiled code."""
    model = build(mechanism)
    system = lw.System(model, formulation=mechanism.formulation)
    core, state = system.compiled(), system.initial_state()

    def batch(count: int) -> float:
        begun = time.process_time()
        core.repeat_right_hand_side(0.0, state, count)
        return time.process_time() - begun

    q, v = np.split(state, [7 * model.body_count])
    return Operation(
        partial(typical, batch),
        "rhs",
        deviation(core.accelerations(0.0, q, v)[0].reshape(-1, 6), mechanism.acceleration),
        1e-9,
        f"{system.options['formulation']}, {system.options['linear_solver']}",
    )


def step(integrator: str, tolerance: float, mechanism: Mechanism) -> Operation:
    """A step of many: what more steps take beyond the first few, without a verdict, which others have not."""
    model = build(mechanism)
    found = _simulate(model, mechanism.formulation, 1, round(SPAN / STEP), integrator)
    return Operation(
        partial(beyond_first, lambda count: _move(model, mechanism, count, integrator).cpu_seconds),
        f"{integrator} step",
        deviation(_mean_acceleration(found, 0), mechanism.mean_acceleration),
        tolerance,
        "beyond the first steps",
    )


def _move(model: lw.Model, mechanism: Mechanism, steps: int, integrator: str) -> Motion:
    return move(model, steps * STEP, STEP, integrator, looks=1, formulation=mechanism.formulation)


def first_step(mechanism: Mechanism) -> Operation:
    """Compiling the model, symbolic analysis, and one step."""
    begin = partial(_move, build(mechanism), mechanism, 1, "rk4")
    return Operation(
        partial(typical, calls(begin)), "first step", None, 0.0, "compiling, analysis, an rk4 step"
    )


OPERATIONS: Builders = {
    "rhs": right_hand_side,
    "semi_implicit_euler step": partial(step, "semi_implicit_euler", FIRST_ORDER),
    "rk4 step": partial(step, "rk4", 1e-9),
    "first step": first_step,
}
