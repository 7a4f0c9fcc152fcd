"""Pinocchio: minimal coordinates of a spanning tree; loops closed by proximal constraints."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import pinocchio as pin
from mechanism import GROUND, Floats, Mechanism, deviation, spanning_tree
from operation import Builders, Operation, calls, typical, without_call

ACCURACY = 1e-10  #: at which proximal iterations stop
MOST_ITERATIONS = 100
MU = (1e-2, 1e-4, 1e-6, 1e-8)  #: proximal parameters that are tried
AGREEMENT = 1e-6  #: of proximal solutions


@dataclass(frozen=True)
class Tree:
    """A mechanism in joint coordinates; each joint's frame is that of the body that it carries."""

    model: pin.Model
    v: Floats
    frames: dict[int, int]  # of each body
    closures: Any  # StdVec_RigidConstraintModel

    @property
    def q(self) -> Floats:
        return np.asarray(pin.neutral(self.model))

    @property
    def tau(self) -> Floats:
        return np.zeros(self.model.nv)


def build(mechanism: Mechanism) -> Tree:
    """MemoryError at once, not after minutes, where Data has no room for its dense matrices."""
    branches, loops = spanning_tree(mechanism)
    size = sum(1 if mechanism.kind[branch.joint] == "revolute" else 3 for branch in branches)
    np.empty((size, size))
    model = pin.Model()
    model.gravity = pin.Motion(mechanism.gravity, np.zeros(3))
    joints, frames = {GROUND: 0}, {}
    carrier = {GROUND: pin.SE3.Identity()}  # the frame of the carrying joint in the body's
    v = []
    for body, parent, joint, side in ((b.body, b.parent, b.joint, b.side) for b in branches):
        place = [pin.SE3(mechanism.frame[joint, s], mechanism.origin[joint, s]) for s in (side, 1 - side)]
        hinge = mechanism.kind[joint] == "revolute"
        kind = pin.JointModelRZ() if hinge else pin.JointModelSpherical()
        joints[body] = model.addJoint(joints[parent], kind, carrier[parent].actInv(place[1]), f"joint {body}")
        carrier[body] = place[0]
        center = place[0].inverse()
        inertia = pin.Inertia(mechanism.mass[body], np.zeros(3), mechanism.inertia[body])
        model.appendBodyToJoint(joints[body], inertia, center)
        frames[body] = model.addFrame(pin.Frame(f"body {body}", joints[body], 0, center, pin.OP_FRAME))
        omega = mechanism.relative_omega(joint, side)
        v.append(omega[2:] if hinge else omega)

    closures = pin.StdVec_RigidConstraintModel()
    for joint in loops:
        bodies = [int(body) for body in mechanism.bodies[joint]]
        for points in zip(*(mechanism.pin_points(joint, side) for side in (0, 1)), strict=True):
            place = [
                carrier[body].actInv(pin.SE3(mechanism.frame[joint, side], point))
                for side, (body, point) in enumerate(zip(bodies, points, strict=True))
            ]
            a, b = (joints[body] for body in bodies)
            closures.append(
                pin.RigidConstraintModel(
                    pin.ContactType.CONTACT_3D, model, a, place[0], b, place[1], pin.LOCAL
                )
            )
    return Tree(model, np.concatenate(v), frames, closures)


def body_accelerations(tree: Tree, data: pin.Data, v_dot: Floats) -> Floats:
    """(n, 6): inertial, and the rate of omega in body axes."""
    pin.forwardKinematics(tree.model, data, tree.q, tree.v, v_dot)
    pin.updateFramePlacements(tree.model, data)
    found = np.empty((len(tree.frames), 6))
    for body, frame in tree.frames.items():
        a = pin.getFrameClassicalAcceleration(tree.model, data, frame, pin.LOCAL)
        found[body] = *(data.oMf[frame].rotation @ a.linear), *a.angular
    return found


def _seconds(call: Callable[[], object], seconds: float) -> float:
    none = pin.Model()
    nothing = np.zeros(0)
    empty = partial(pin.aba, none, none.createData(), nothing, nothing, nothing)
    return without_call(call, empty, seconds)


def aba(mechanism: Mechanism) -> Operation | None:
    """Articulated bodies, without reactions: open chains. In world axes, which is the faster of two ways."""
    if mechanism.has_loops:
        return None
    tree = build(mechanism)
    data = tree.model.createData()
    call = partial(pin.aba, tree.model, data, tree.q, tree.v, tree.tau, pin.Convention.WORLD)
    found = body_accelerations(tree, data, call().copy())
    note = "accelerations only, data preallocated; less an empty call"
    return Operation(partial(_seconds, call), "rhs", deviation(found, mechanism.acceleration), 1e-9, note)


def constraint_dynamics(mechanism: Mechanism) -> Operation | None:
    """Proximal solution with a factorization of the operational-space matrix."""
    if not mechanism.has_loops:
        return None
    tree = build(mechanism)
    data, closure_data = tree.model.createData(), _closure_data(tree)
    pin.initConstraintDynamics(tree.model, data, tree.closures, closure_data)
    return _proximal(pin.constraintDynamics, tree, data, closure_data, mechanism)


def lcaba(mechanism: Mechanism) -> Operation | None:
    """Articulated bodies with loops; not for spherical joints, on whose loops it diverges (pin 4.1)."""
    if not mechanism.has_loops or (mechanism.kind == "spherical").any():
        return None
    tree = build(mechanism)
    data, closure_data = tree.model.createData(), _closure_data(tree)
    pin.computeJointMinimalOrdering(tree.model, data, tree.closures)
    return _proximal(pin.lcaba, tree, data, closure_data, mechanism)


def _closure_data(tree: Tree) -> Any:
    data = pin.StdVec_RigidConstraintData()
    for closure in tree.closures:
        data.append(closure.createData())
    return data


def _proximal(
    solve: Callable[..., Floats], tree: Tree, data: pin.Data, closure_data: Any, mechanism: Mechanism
) -> Operation:
    """With the fastest of the parameters MU that agrees, or where none does the one that deviates least."""
    state = (tree.q, tree.v, tree.tau)

    def trial(mu: float) -> tuple[tuple[bool, float], Operation]:
        settings = pin.ProximalSettings(ACCURACY, mu, MOST_ITERATIONS)
        call = partial(solve, tree.model, data, *state, tree.closures, closure_data, settings)
        error = deviation(body_accelerations(tree, data, call().copy()), mechanism.acceleration)
        agrees = error <= AGREEMENT
        note = f"mu {mu:g}, {settings.iter} proximal iterations; less an empty call"
        rank = (not agrees, typical(calls(call), 0.01) if agrees else error)
        return rank, Operation(partial(_seconds, call), "rhs", error, AGREEMENT, note)

    return min((trial(mu) for mu in MU), key=lambda found: found[0])[1]


OPERATIONS: Builders = {
    "aba": aba,
    "constraintDynamics": constraint_dynamics,
    "lcaba": lcaba,
}
