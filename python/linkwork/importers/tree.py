"""Where the links of a description are: poses and velocities from joint coordinates, along a tree."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from linkwork import rotation
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


#: To each link the joint that places it; None where it stands by itself, as in the file.
Tree = Mapping[str, JointDescription | None]


def grounded_links(description: Description) -> list[str]:
    """Those that are fixed to the ground though no joint says so: nothing carries them."""
    walk = _Walk(description)
    walk.go_from(WORLD)
    carried = {joint.child for joint in description.joints if not joint.closes_loop} | walk.tree.keys()
    return [name for name in description.links if name in description.grounded and name not in carried]


def spanning_tree(description: Description) -> Tree:
    """All links, each behind the one from which it is placed. Joints that close loops have no say."""
    walk = _Walk(description)
    walk.go_from(WORLD, *grounded_links(description))
    carried = {joint.child for joint in description.joints if not joint.closes_loop}
    roots = [name for name in description.links if name not in carried]
    for root in [*roots, *description.links]:  # the last for links on a ring of joints
        walk.go_from(root)
    return walk.tree


class _Walk:
    """Along fixed joints first, so that links stay together that these hold; then from parents to children,
    and only where none is left from children to parents."""

    def __init__(self, description: Description) -> None:
        self.tree: dict[str, JointDescription | None] = {}
        self._fixed: dict[str, list[JointDescription]] = {}  #: at each link
        self._down: dict[str, list[JointDescription]] = {}  #: by parents
        self._up: dict[str, list[JointDescription]] = {}  #: by children
        self._downward: list[str] = []  #: links from which to go on
        self._upward: deque[str] = deque()
        for joint in description.joints:
            if joint.closes_loop:
                continue
            rigid = joint.kind == "fixed"
            for table, link in ((self._down, joint.parent), (self._up, joint.child)):
                (self._fixed if rigid else table).setdefault(link, []).append(joint)

    def go_from(self, *links: str) -> None:
        for link in links:
            self._place(link, None)
        while self._downward or self._upward:
            if self._downward:
                for joint in self._down.get(self._downward.pop(), ()):
                    self._place(joint.child, joint)
            else:
                for joint in self._up.get(self._upward.popleft(), ()):
                    self._place(joint.parent, joint)

    def _place(self, link: str, joint: JointDescription | None) -> None:
        """With all that is rigid with it, if it has no place yet."""
        stack = [(link, joint)]
        while stack:
            here, by = stack.pop()
            if here in self.tree:
                continue
            self.tree[here] = by
            self._downward.append(here)
            self._upward.append(here)
            stack += [(it.other(here), it) for it in self._fixed.get(here, ())]


def link_states(description: Description, coordinates: Values, velocities: Values) -> dict[str, LinkState]:
    """Of every link, and of the world.

    ModelError: a joint that does not exist or closes a loop, or another number of coordinates.
    """
    q = joint_values(description, coordinates)
    rates = _with_couplings(description, _checked(description, velocities, "velocities"), offsets=False)
    states: dict[str, LinkState] = {}
    tree = spanning_tree(description)
    for link, joint in tree.items():
        if joint is None:
            states[link] = LinkState(Frame() if link == WORLD else description.links[link].pose)
            continue
        values = q.get(joint.name), rates.get(joint.name)
        if link == joint.child:
            states[link] = _next(joint, states[joint.parent], *values)
        else:
            states[link] = _previous(joint, states[joint.child], *values)
    used = {joint.name for joint in tree.values() if joint is not None}
    for name in [*coordinates, *velocities]:
        if name not in used:
            raise ModelError(
                f"joint '{name}' closes a loop: its coordinate follows from the others", code="coordinates"
            )
    return states


def starts(
    description: Description, coordinates: Values, states: Mapping[str, LinkState], coupled: bool
) -> dict[str, Floats]:
    """The coordinates of each joint at t = 0; of several that close a loop those of the file.

    `coupled`: couplings act. Noted: angles of these on which something acts and which may be beyond half a
    turn.
    """
    q = joint_values(description, coordinates)
    tree = {joint.name for joint in spanning_tree(description).values() if joint is not None}
    found: dict[str, Floats] = {}
    for joint in description.joints:
        found[joint.name] = q.get(joint.name, np.zeros(len(joint.motions))) + joint.reference
        if joint.name not in tree and len(joint.motions) == 1:
            value = _measured(joint, states[joint.parent], states[joint.child])
            found[joint.name] = value + joint.reference
    if _turned(description, q) > np.pi:
        _note_within_a_turn(description, found, tree, coupled)
    return found


def _turned(description: Description, q: Mapping[str, Floats]) -> float:
    """The sizes of all angles together [rad]: that of a joint that closes a loop can be as large."""
    total = 0.0
    for joint in (joint for joint in description.joints if joint.name in q):
        turns = [motion.rotation for motion in joint.motions]
        total += float(np.abs(q[joint.name][turns]).sum())
    return total


def _note_within_a_turn(
    description: Description, found: Mapping[str, Floats], tree: Collection[str], coupled: bool
) -> None:
    couplings = description.couplings if coupled else ()
    related = {name for coupling in couplings for name in (coupling.follower, coupling.leader)}
    for joint in description.joints:
        turns = len(joint.motions) == 1 and joint.motions[0].rotation and joint.name not in tree
        if turns and (joint.stiffness or joint.stops or joint.name in related):
            angle = float(found[joint.name][0])
            text = f"closes a loop: its coordinate is taken within a turn: {angle:.6g} rad"
            description.note("coordinates", f"joint '{joint.name}'", text)


def _measured(joint: JointDescription, parent: LinkState, child: LinkState) -> Floats:
    """From where both sides agree: an angle within a turn, or a shift."""
    motion = joint.motions[0]
    step = (parent.frame @ joint.in_parent).inverse @ child.frame @ joint.in_child
    if not motion.rotation:
        return np.array([motion.axis @ step.r])
    x = rotation.perpendicular(motion.axis)
    turned = step.A @ x
    return np.array([np.arctan2(np.cross(motion.axis, x) @ turned, x @ turned)])


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
    for start in coupling_of:
        name = start
        chain: dict[str, None] = {}  # up to a joint whose value is known, or which follows no other
        while name not in out and name in coupling_of and name not in chain:
            chain[name] = None
            name = coupling_of[name].leader
        value = out.get(name, np.zeros(1))
        for follower in reversed(chain):
            coupling = coupling_of[follower]
            value = coupling.multiplier * value + (coupling.offset if offsets else 0.0)
            if not np.isfinite(value).all():
                text = f"joint '{follower}', {coupling}, would be beyond all numbers"
                raise ModelError(text, code="coordinates")
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


# X_parent = X_child X^-1, where X is the child in the parent, which moves there by v and omega.
def _previous(joint: JointDescription, child: LinkState, q: Floats | None, rates: Floats | None) -> LinkState:
    """The parent, from the child."""
    step = _next(joint, LinkState(), q, rates)
    frame = child.frame @ step.frame.inverse
    omega = child.omega - frame.A @ step.omega
    velocity = child.velocity - np.cross(omega, child.frame.r - frame.r) - frame.A @ step.velocity
    return LinkState(frame, velocity, omega)
