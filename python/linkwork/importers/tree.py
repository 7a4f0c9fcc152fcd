"""Where the links of a description are: poses and velocities from joint coordinates, along a tree."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import ModelError, nearest
from linkwork.importers.description import WORLD, Description, JointDescription
from linkwork.importers.frames import Frame

#: A number for each elementary motion of a joint; a plain number where there is one.
Values = Mapping[str, Any]


@dataclass(frozen=True)
class LinkState:
    """Pose and velocity of a link's frame, inertial."""

    frame: Frame = field(default_factory=Frame)
    velocity: Floats = field(default_factory=lambda: np.zeros(3))  #: of the frame's origin [m/s]
    omega: Floats = field(default_factory=lambda: np.zeros(3))  #: inertial axes [rad/s]

    def velocity_of(self, point: Floats) -> Floats:
        """Of a point of the link, given in space: v + omega x (point - r)"""
        velocity: Floats = self.velocity + np.cross(self.omega, point - self.frame.r)
        return velocity


def link_states(description: Description, coordinates: Values, velocities: Values) -> dict[str, LinkState]:
    """Of every link, and of the world. Joints that close loops have no say.

    ModelError: a joint that does not exist or closes a loop, or another number of coordinates.
    """
    children: dict[str, list[JointDescription]] = {}
    tree = [joint for joint in description.joints if not joint.closes_loop]
    for joint in tree:
        children.setdefault(joint.parent, []).append(joint)
    carried = {joint.child for joint in tree}
    q = joint_values(description, coordinates)
    rates = _with_couplings(description, _checked(description, velocities, "velocities"), offsets=False)

    states: dict[str, LinkState] = {WORLD: LinkState()}
    used: set[str] = set()
    roots = [name for name in description.links if name not in carried]
    for root in [WORLD, *roots, *description.links]:  # the last for links on a ring of joints
        if root not in states:
            states[root] = LinkState(description.links[root].pose)
        elif root != WORLD:
            continue
        stack = [root]
        while stack:
            for joint in children.get(stack.pop(), []):
                if joint.child not in states:
                    states[joint.child] = _next(
                        joint, states[joint.parent], q.get(joint.name), rates.get(joint.name)
                    )
                    used.add(joint.name)
                    stack.append(joint.child)
    for name in [*coordinates, *velocities]:
        if name not in used:
            raise ModelError(
                f"joint '{name}' closes a loop: its coordinate follows from the others", code="coordinates"
            )
    return states


def joint_values(description: Description, coordinates: Values) -> dict[str, Floats]:
    """From where both sides of each joint agree, of the joints that are given and those that follow them.

    ModelError: a joint that does not exist, or another number of coordinates.
    """
    return _with_couplings(description, _checked(description, coordinates, "coordinates"), offsets=True)


def _checked(description: Description, given: Values, what: str) -> dict[str, Floats]:
    joints = {joint.name: joint for joint in description.joints if joint.kind != "free"}
    out: dict[str, Floats] = {}
    for name, value in given.items():
        if name not in joints:
            raise ModelError(f"{what}: no joint '{name}'{nearest(name, joints)}", code="coordinates")
        values, count = np.atleast_1d(np.asarray(value, dtype=float)), len(joints[name].motions)
        if values.shape != (count,) or not np.isfinite(values).all():
            raise ModelError(
                f"{what}: {joints[name].kind} joint '{name}' takes {count} finite numbers, not {value!r}",
                code="coordinates",
            )
        out[name] = values - joints[name].reference * (what == "coordinates")
    return out


def _with_couplings(description: Description, values: dict[str, Floats], offsets: bool) -> dict[str, Floats]:
    """Joints that follow others and are not given themselves: multiplier * value + offset."""
    coupling_of = {coupling.follower: coupling for coupling in description.couplings}
    single = {joint.name for joint in description.joints if len(joint.motions) == 1}
    out = dict(values)
    for name in coupling_of:
        chain = [name]  # up to the first joint whose value is known, or which follows no other
        while chain[-1] not in out and chain[-1] in coupling_of and chain[-1] not in chain[:-1]:
            chain.append(coupling_of[chain[-1]].leader)
        value = out.get(chain[-1], np.zeros(1))
        for follower in reversed(chain[:-1]):
            coupling = coupling_of[follower]
            value = coupling.multiplier * value + (coupling.offset if offsets else 0.0)
            if value.shape == (1,) and follower in single:
                out[follower] = value
    return out


# X_child = X_parent T_parent M(q) T_child^-1. Each elementary motion adds its rate to the motion of the
# frames behind it:  omega += A a q_dot  or  v += A a q_dot;  a screw of lead h adds both, v += h A a q_dot.
def _next(joint: JointDescription, parent: LinkState, q: Floats | None, rates: Floats | None) -> LinkState:
    count = len(joint.motions)
    values: Sequence[float] = q.tolist() if q is not None else [0.0] * count
    speeds: Sequence[float] = rates.tolist() if rates is not None else [0.0] * count
    frame = parent.frame @ joint.in_parent
    omega, velocity = parent.omega, parent.velocity_of(frame.r)
    for k, motion in enumerate(joint.motions):
        moved = frame @ motion.displacement(values[k])
        axis = frame.A @ motion.axis
        velocity = velocity + np.cross(omega, moved.r - frame.r)
        if motion.rotation:
            omega = omega + speeds[k] * axis
            velocity = velocity + speeds[k] * motion.lead * axis
        else:
            velocity = velocity + speeds[k] * axis
        frame = moved
    child = frame @ joint.in_child.inverse
    return LinkState(child, velocity + np.cross(omega, child.r - frame.r), omega)
