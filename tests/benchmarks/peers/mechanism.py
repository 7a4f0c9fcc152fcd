"""A mechanism in numbers, read once from a linkwork model: every peer builds its own from the same ones."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

GROUND = -1
SPAN = 0.01  #: [s] over which `mean_acceleration` is taken


@dataclass(frozen=True)
class Mechanism:
    """n bodies and k joints in motion, at one state. SI units; a body's frame is at its center of mass.

    A joint has a point and a frame in each of its two bodies, the ground being body -1 with the inertial
    frame; its axis is z. At this state the two points coincide and so do the two frames: joint coordinates
    are zero.
    """

    name: str
    formulation: str  # by which linkwork solves it
    gravity: Floats  # (3,)
    mass: Floats  # (n,)
    inertia: Floats  # (n, 3, 3) body axes
    position: Floats  # (n, 3) inertial
    orientation: Floats  # (n, 4) Euler parameters, scalar first
    rotation: Floats  # (n, 3, 3) body axes to inertial
    velocity: Floats  # (n, 3) inertial
    omega: Floats  # (n, 3) body axes
    kind: NDArray[np.str_]  # (k,) revolute or spherical
    bodies: Integers  # (k, 2)
    origin: Floats  # (k, 2, 3) body axes
    frame: Floats  # (k, 2, 3, 3) columns are the joint's axes in body axes
    dependent: NDArray[
        np.bool_
    ]  # (k, 5) equations that repeat others: translation x, y, z, rotation about y, x
    acceleration: Floats  # (n, 6) by linkwork: inertial, and the rate of omega in body axes
    mean_acceleration: Floats  # (n, 6) by linkwork: change of velocity and omega over SPAN

    @property
    def body_count(self) -> int:
        return len(self.mass)

    @property
    def joint_count(self) -> int:
        return len(self.kind)

    @property
    def has_loops(self) -> bool:
        return self.joint_count > self.body_count

    @property
    def v(self) -> Floats:
        """(n, 6): velocity and omega."""
        return np.concatenate([self.velocity, self.omega], axis=1)

    def pose(self, body: int) -> tuple[Floats, Floats]:
        """(position (3,), rotation (3, 3)), of the ground too."""
        return (np.zeros(3), np.eye(3)) if body == GROUND else (self.position[body], self.rotation[body])

    def relative_omega(self, joint: int, side: int) -> Floats:
        """Angular velocity of the body on that side against the other one, in joint axes (3,)."""

        def inertial(body: int) -> Floats:
            return np.zeros(3) if body == GROUND else self.rotation[body] @ self.omega[body]

        this, other = self.bodies[joint, side], self.bodies[joint, 1 - side]
        axes = self.pose(this)[1] @ self.frame[joint, side]
        return np.asarray(axes.T @ (inertial(this) - inertial(other)))

    def pin_points(self, joint: int, side: int) -> list[Floats]:
        """Points (3,) in body axes that hold the joint when each coincides with its counterpart.

        One for a spherical joint. Two on the axis of a revolute one, half a meter to either side: one
        equation more than it needs, for engines that have no other way to close a loop with a hinge.
        """
        origin, axis = self.origin[joint, side], self.frame[joint, side][:, 2]
        return [origin] if self.kind[joint] == "spherical" else [origin + 0.5 * axis, origin - 0.5 * axis]

    def save(self, file: Path) -> None:
        np.savez(file, **asdict(self))

    @classmethod
    def load(cls, file: Path) -> Mechanism:
        with np.load(file) as arrays:
            texts = {name: str(arrays[name]) for name in ("name", "formulation")}
            return cls(**{**arrays, **texts})


def deviation(found: Floats, reference: Floats) -> float:
    """The largest difference over the largest acceleration."""
    return float(np.abs(found - reference).max() / np.abs(reference).max())


@dataclass(frozen=True)
class Branch:
    """A body of a spanning tree and the joint that carries it."""

    body: int
    parent: int  # a body, or the ground
    joint: int
    side: int  # which of the joint's two bodies it is


def spanning_tree(mechanism: Mechanism) -> tuple[list[Branch], list[int]]:
    """Branches, as short as can be and depth first, and the joints that close loops.

    ValueError: a body that no joint connects to the ground.
    """
    neighbors: list[list[tuple[int, int]]] = [[] for _ in range(mechanism.body_count + 1)]
    for joint, pair in enumerate(mechanism.bodies):
        for side in (0, 1):
            neighbors[pair[1 - side]].append((joint, side))  # the ground, -1, is the last

    carried: dict[int, Branch] = {}
    children: dict[int, list[int]] = {GROUND: []}
    reached = [GROUND]
    for parent in reached:  # breadth first: the list grows meanwhile
        for joint, side in neighbors[parent]:
            body = int(mechanism.bodies[joint, side])
            if body not in children:
                carried[body] = Branch(body, parent, joint, side)
                children[parent].append(body)
                children[body] = []
                reached.append(body)
    if len(carried) < mechanism.body_count:
        lost = next(body for body in range(mechanism.body_count) if body not in carried)
        raise ValueError(f"{mechanism.name}: no joint connects body {lost} to the ground")

    order: list[Branch] = []
    waiting = children[GROUND][::-1]
    while waiting:
        order.append(carried[waiting.pop()])
        waiting += children[order[-1].body][::-1]
    used = {branch.joint for branch in order}
    return order, [joint for joint in range(mechanism.joint_count) if joint not in used]
