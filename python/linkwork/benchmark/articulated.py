"""Mechanisms of linkwork by Pinocchio, in joint coordinates: trees by articulated bodies, whose `aba` takes
many on several threads; loops by its constraint dynamics, which closes them at points.
"""

from __future__ import annotations

import heapq
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from linkwork.arrays import Floats
from linkwork.equations.system import System
from linkwork.modeling.model import Model
from linkwork.rotation import matrix
from linkwork.running.simulation import simulate

__all__ = ["Articulated", "articulated"]

#: Mechanisms that are evaluated at a time for each thread.
BATCH = 32

#: For about so long [s] evaluations are repeated in a round.
WINDOW_SECONDS = 2e-2

#: Accelerations are the same within this, relative to the largest, when the mechanism has moved so long [s].
AGREES, MOVED, STEP = 1e-8, 0.02, 1e-3

#: Proximal iterations: how exact, how many, and the parameters that are tried; 0: none, without redundancy.
ACCURACY, MOST_ITERATIONS, MU = 1e-11, 100, (0.0, 1e-2, 1e-4, 1e-6, 1e-8)

#: Coordinates of the joints that are translated.
COORDINATES = {"revolute": 1, "translational": 1, "universal": 2, "spherical": 3}

#: Those that can close a loop by points. A tree goes over others first.
CLOSING, DETOUR = ("revolute", "spherical"), 1000

GROUND = -1

#: What is said of a peer that is not there.
NOT_INSTALLED = "is not installed"


@dataclass(frozen=True)
class Articulated:
    """One evaluation of a mechanism's accelerations by Pinocchio.

    solves   the algorithm, in words; or why there is none
    seconds  by threads: measures once, the wall time of one evaluation of one mechanism [s]
    """

    solves: str
    seconds: dict[int, Callable[[], float]] = field(default_factory=dict)


def articulated(model: Model, threads: Sequence[int]) -> Articulated:
    """As fast as Pinocchio does it with linkwork's accelerations, which are compared in motion."""
    try:
        import pinocchio as pin
    except ImportError:
        return Articulated(NOT_INSTALLED)
    core = model.compiled()
    kinds = [core.joint_kind(joint) for joint in range(core.joint_count)]
    other = next((kind for kind in kinds if kind not in COORDINATES), "a force" if core.force_count else "")
    if other:
        return Articulated(f"not translated: {other}")
    moved = simulate(model, MOVED, STEP, record_every=round(MOVED / STEP), progress=False,
                     on_inaccurate="pass")  # fmt: skip
    state = np.concatenate([moved.recorded("q", -1), moved.recorded("v", -1)], axis=None)
    tree = _Tree(pin, model, kinds, state)
    other = next((kinds[joint] for joint in tree.closing if kinds[joint] not in CLOSING), "")
    if other:
        return Articulated(f"not translated: a loop that ends in a joint '{other}'")
    return _loops(tree) if tree.closing else _tree(tree, threads)


def _tree(tree: _Tree, threads: Sequence[int]) -> Articulated:
    """Articulated bodies, without reactions."""
    pin, state = tree.pin, (tree.q, tree.v, tree.tau)
    apart = tree.apart(pin.aba(tree.model, tree.data, *state).copy())
    if not apart < AGREES:
        return Articulated(f"aba: other accelerations, {apart:.0e} off")

    def measured(count: int) -> Callable[[], float]:
        pool = pin.ModelPool(tree.model, count)
        many = [np.asfortranarray(np.repeat(it[:, None], BATCH * count, axis=1)) for it in state]
        found = np.zeros_like(many[1], order="F")
        timed = _timed(partial(pin.abaInParallel, count, pool, *many, found))
        return lambda: timed() / (BATCH * count)

    return Articulated("aba", {count: measured(count) for count in threads})


def _loops(tree: _Tree) -> Articulated:
    """The fastest of several ways that agree: with one point or two in a hinge that closes a loop, by
    several parameters of the proximal iterations."""
    pin, none, nothing = tree.pin, tree.pin.Model(), np.zeros(0)
    empty = _timed(partial(pin.aba, none, none.createData(), nothing, nothing, nothing), time.thread_time)
    best, least, nearest = Articulated(""), math.inf, math.inf
    for points in (1, 2):
        closures, closed = tree.closures(points), pin.StdVec_RigidConstraintData()
        for closure in closures:
            closed.append(closure.createData())
        pin.initConstraintDynamics(tree.model, tree.data, closures, closed)
        for mu in MU:
            settings = pin.ProximalSettings(ACCURACY, mu, MOST_ITERATIONS)
            call = partial(pin.constraintDynamics, tree.model, tree.data, tree.q, tree.v, tree.tau,
                           closures, closed, settings)  # fmt: skip
            apart = tree.apart(call().copy())
            nearest = min(nearest, apart)
            timed = _timed(call, time.thread_time)  # of one thread; what others do does not count
            if apart < AGREES and (taken := min(timed() for _ in range(3))) < least:
                least = taken
                best = Articulated(
                    f"constraintDynamics, {3 * len(closures)} equations, {settings.iter} iterations",
                    {1: partial(_beyond, timed, empty)},
                )
    return best if best.seconds else Articulated(f"constraintDynamics: accelerations {nearest:.0e} off")


def _timed(call: Callable[[], object], clock: Callable[[], float] = time.perf_counter) -> Callable[[], float]:
    """Measures once: the time of one call, of as many as a window has room for [s]."""

    def of(count: int) -> float:
        started = clock()
        for _ in range(count):
            call()
        return (clock() - started) / count

    of(1)  # allocates
    count = max(1, round(WINDOW_SECONDS / max(of(3), 1e-7)))
    return partial(of, count)


def _beyond(timed: Callable[[], float], empty: Callable[[], float]) -> float:
    """Less a call from Python that has nothing to do."""
    return max(timed() - empty(), 0.0)


# --- in joint coordinates ---


class _Joint(NamedTuple):
    """Of the spanning tree; its frame is that of the body which it carries."""

    body: int
    parent: int
    number: int


class _Tree:
    """Coordinates are zero at the pose that it is made from; forces at joints are none."""

    def __init__(self, pin: Any, model: Model, kinds: Sequence[str], state: Floats) -> None:
        self.pin, self._core, self._kinds = pin, model.compiled(), kinds
        n = self._core.body_count
        q, self._velocity = state[: 7 * n].reshape(n, 7), state[7 * n :].reshape(n, 6)
        self._accelerations = System(model).compiled().derivative(0.0, state)[7 * n :].reshape(n, 6)
        A = matrix(q[:, 3:])
        self._pose = [*(pin.SE3(A[k], q[k, :3]) for k in range(n)), pin.SE3.Identity()]  # the ground is last
        self._arrays = self._core.joint_arrays()
        self.model = pin.Model()
        self.model.gravity = pin.Motion(np.asarray(self._core.gravity), np.zeros(3))
        branches, self.closing = _spanned(n, self._arrays["bodies"].tolist(), kinds)
        self._joint, self._place = {GROUND: 0}, {GROUND: pin.SE3.Identity()}
        speeds = [self._add(branch) for branch in branches]
        self._frames = [self._frame(body) for body in range(n)]
        self.data = self.model.createData()  # which takes longer than all else
        self.q, self.v, self.tau = pin.neutral(self.model), np.concatenate(speeds), np.zeros(self.model.nv)

    def _add(self, branch: _Joint) -> Floats:
        """Joint and body; its speeds."""
        pin, body, kind = self.pin, branch.body, self._kinds[branch.number]
        place = self._placed(branch.number, branch.parent)
        made = {
            "revolute": pin.JointModelRZ,
            "translational": pin.JointModelPZ,
            "universal": lambda: pin.JointModelUniversal(1, 0, 0, 0, 1, 0),
            "spherical": pin.JointModelSpherical,
        }[kind]()
        self._joint[body] = self.model.addJoint(
            self._joint[branch.parent], made, self._place[branch.parent].actInv(place), f"joint {body}"
        )
        self._place[body] = place
        inertia = np.asarray(self._core.inertia).reshape(-1, 3, 3)[body]
        weight = pin.Inertia(float(self._core.mass[body]), np.zeros(3), inertia)
        self.model.appendBodyToJoint(self._joint[body], weight, place.actInv(self._pose[body]))
        moves, turns = self._moving(body, place) - self._moving(branch.parent, place)
        return np.asarray({"revolute": turns[2:], "translational": moves[2:], "universal": turns[:2],
                           "spherical": turns}[kind])  # fmt: skip

    def _frame(self, body: int) -> int:
        center = self._place[body].actInv(self._pose[body])
        frame = self.pin.Frame(f"body {body}", self._joint[body], 0, center, self.pin.OP_FRAME)
        return int(self.model.addFrame(frame))

    def _placed(self, joint: int, parent: int) -> Any:
        """The inertial frame of a joint: z its axis; of a universal one x in the parent, y in the other."""
        pair = self._arrays["bodies"][joint].tolist()
        rotations = [self._pose[body].rotation @ self._arrays["frame"][joint, side]
                     for side, body in enumerate(pair)]  # fmt: skip
        axes = rotations[0]
        if self._kinds[joint] == "universal":
            x, y = (rotations[side][:, 2] for side in (pair.index(parent), 1 - pair.index(parent)))
            axes = np.column_stack([x, y, np.cross(x, y)])
        return self.pin.SE3(axes, self._pose[pair[0]].act(self._arrays["origin"][joint, 0]))

    def _moving(self, body: int, place: Any) -> Floats:
        """(2, 3): velocity of the body's point there, and its angular velocity, in the axes of that frame."""
        if body == GROUND:
            return np.zeros((2, 3))
        v, omega = self._velocity[body, :3], self._pose[body].rotation @ self._velocity[body, 3:]
        point = v + np.cross(omega, place.translation - self._pose[body].translation)
        return np.asarray(np.stack([point, omega]) @ place.rotation)

    def closures(self, points: int) -> Any:
        """Points that coincide: one of a spherical joint, and so many of a hinge, along its axis."""
        found = self.pin.StdVec_RigidConstraintModel()
        for joint in self.closing:
            a, b = self._arrays["bodies"][joint].tolist()
            place = self._placed(joint, a)
            count = points if self._kinds[joint] == "revolute" else 1
            for along in (-0.5, 0.5) if count == 2 else (0.0,):
                at = self.pin.SE3(place.rotation, place.act(np.array([0.0, 0.0, along])))
                found.append(self.pin.RigidConstraintModel(
                    self.pin.ContactType.CONTACT_3D, self.model, self._joint[a], self._place[a].actInv(at),
                    self._joint[b], self._place[b].actInv(at), self.pin.LOCAL,
                ))  # fmt: skip
        return found

    def apart(self, accelerations: Floats) -> float:
        """Of the bodies, from linkwork's, relative to the largest; infinite where they are no numbers."""
        pin, data = self.pin, self.data
        pin.forwardKinematics(self.model, data, self.q, self.v, accelerations)
        pin.updateFramePlacements(self.model, data)
        found = np.empty_like(self._accelerations)
        for body, frame in enumerate(self._frames):
            a = pin.getFrameClassicalAcceleration(self.model, data, frame, pin.LOCAL)
            found[body] = *(data.oMf[frame].rotation @ a.linear), *a.angular
        apart = np.abs(found - self._accelerations).max() / np.abs(self._accelerations).max()
        return float(apart) if np.isfinite(apart) else math.inf


def _spanned(
    count: int, pairs: Sequence[tuple[int, int]], kinds: Sequence[str]
) -> tuple[list[_Joint], list[int]]:
    """Branches, short and depth first, and the joints that close loops: those that can by points."""
    waiting, reached = [(0, -1, GROUND, GROUND)], set()
    children: dict[int, list[_Joint]] = {body: [] for body in range(GROUND, count)}
    while waiting:
        far, joint, parent, body = heapq.heappop(waiting)
        if body in reached:
            continue
        reached.add(body)
        if joint >= 0:
            children[parent].append(_Joint(body, parent, joint))
        for other, pair in enumerate(pairs):
            if body in pair:
                beyond = pair[1] if pair[0] == body else pair[0]
                step = DETOUR if kinds[other] == "spherical" else 1
                heapq.heappush(waiting, (far + step, other, body, beyond))
    order: list[_Joint] = []
    open_ = children[GROUND][::-1]
    while open_:
        order.append(open_.pop())
        open_ += children[order[-1].body][::-1]
    used = {branch.number for branch in order}
    return order, [joint for joint in range(len(pairs)) if joint not in used]
