"""Each joint and each spring on bodies of general shape, against the same motion in minimal coordinates.

Axes are skew, centers of mass off the joints, inertias full; weight, a force, a torque and a spring act, and
bodies start in motion. The reference is Kane's method in minimal_coordinates.py.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from minimal_coordinates import Ball, Chain, Freedom, Link, Placed, Slide, Turn, cross
from scipy.spatial.transform import Rotation

Load = Callable[[float, list[Placed]], list[tuple[Floats, Floats]]]

TIMES = np.linspace(0.0, 2.5, 21)
GRAVITY = np.array([0.4, -0.7, -9.7])

#: Axes of joints: N is skew, E and B complete it to a right-handed frame.
N = np.array([2.0, -1.0, 3.0]) / np.sqrt(14.0)
E = np.array([1.0, 2.0, 0.0]) / np.sqrt(5.0)
B = np.cross(N, E)
FRAME = np.column_stack([E, B, N])

#: Shifts in all directions.
FLOATING = [Slide(axis) for axis in np.eye(3)]

#: Where the bodies, and the joints before them, are at the start.
CENTERS = np.array([[0.5, 0.1, 0.25], [1.1, 0.7, 0.1]])
POINTS = np.array([[0.1, -0.2, 0.3], [0.85, 0.45, -0.1]])
ORIENTATIONS = Rotation.from_rotvec([[0.3, -0.5, 0.8], [-0.9, 0.2, 0.4]]).as_quat()[:, [3, 0, 1, 2]]
TURNED = Rotation.from_quat(ORIENTATIONS[:, [1, 2, 3, 0]]).as_matrix()
MASSES = (2.0, 1.3)
MOMENTS = np.array([[0.11, 0.16, 0.21], [0.09, 0.06, 0.05]])
PRODUCTS = np.array([[0.02, -0.015, 0.01], [-0.008, 0.01, 0.004]])  # yz, zx, xy


def inertia(k: int) -> Floats:
    """(3, 3) in body axes."""
    yz, zx, xy = PRODUCTS[k]
    return np.diag(MOMENTS[k]) + np.array([[0, xy, zx], [xy, 0, yz], [zx, yz, 0]])


@dataclass
class Twin:
    """The same chain of bodies twice: for linkwork, and in minimal coordinates."""

    model: lw.Model = field(default_factory=lambda: lw.Model(gravity=GRAVITY))
    links: list[Link] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)

    @property
    def last(self) -> str:
        return f"body {len(self.links)}" if self.links else "ground"

    def body(self, freedoms: Sequence[Freedom], point: Floats) -> None:
        k, before = len(self.links), self.last
        in_space = TURNED[k] @ inertia(k) @ TURNED[k].T
        self.links.append(Link(freedoms, MASSES[k], in_space, CENTERS[k], point))
        assert before != self.last
        self.model.body(self.last, mass=MASSES[k], inertia=inertia(k), position=CENTERS[k],
                        orientation=ORIENTATIONS[k])  # fmt: skip

    def joint(self, kind: str) -> None:
        """A further body, by a joint of this kind at the next of POINTS."""
        before, point = self.last, POINTS[len(self.links)]
        freedoms, on_body, place = JOINTS[kind](point)
        self.body(freedoms, on_body)
        getattr(self.model, kind)(before, self.last, name=f"joint {len(self.links)}", **place)

    def pushed(self) -> None:
        """A constant force at a point of the last body, and a torque that turns with it."""
        k, point = len(self.links) - 1, np.array([0.1, 0.2, -0.15])
        force, torque = np.array([3.0, -2.0, 4.0]), np.array([0.1, 0.05, -0.08])
        self.model.force(self.last, force=force, at=point)
        self.model.force(self.last, torque=torque, frame="body")

        def load(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
            A = bodies[k].A @ TURNED[k]
            return _on(k, len(bodies), force, cross(A @ point, force) + A @ torque)

        self.loads.append(load)

    def sprung(self, stiffness: float = 40.0, damping: float = 0.6) -> None:
        """Spring and damper from the body before to the last one."""
        k, (start, end) = len(self.links) - 1, (CENTERS[-1] + 0.4 * E, CENTERS[len(self.links) - 1] + 0.1 * B)
        before = f"body {k}" if k else "ground"
        self.model.spring_damper(before, self.last, at=(start, end), stiffness=stiffness, damping=damping,
                                 free_length=0.3)  # fmt: skip

        def load(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
            p, p_dot = bodies[k].at(end, self.links[k])
            o, o_dot = bodies[k - 1].at(start, self.links[k - 1]) if k else (start, np.zeros(3))
            length = np.linalg.norm(p - o)
            direction = (p - o) / length
            pull = stiffness * (length - 0.3) + damping * direction @ (p_dot - o_dot)
            loads = _on(k, len(bodies), -pull * direction, cross(p - bodies[k].r, -pull * direction))
            if k:
                loads[k - 1] = (pull * direction, cross(o - bodies[k - 1].r, pull * direction))
            return loads

        self.loads.append(load)

    def twisted(self, on_last: Callable[[Floats, Placed, Placed], Floats]) -> None:
        """A torque on the last body and back on the one before: by their relative turn R, and both."""
        k = len(self.links) - 1

        def load(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
            before = bodies[k - 1] if k else GROUND
            torque = on_last(before.A.T @ bodies[k].A, before, bodies[k])
            loads = _on(k, len(bodies), np.zeros(3), torque)
            if k:
                loads[k - 1] = (np.zeros(3), -torque)
            return loads

        self.loads.append(load)

    def compare(self, speeds: Sequence[float]) -> None:
        """Positions within 1e-7 m and rad, reactions within 1e-6 N and N m, over 2.5 s."""

        def loads(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
            each = [load(t, bodies) for load in self.loads]
            return [(sum(F for F, _ in on), sum(T for _, T in on)) for on in zip(*each, strict=True)]

        chain = Chain(self.links, GRAVITY, loads)
        bodies, forces, torques = chain.motion(speeds, TIMES)
        model, tolerances = _started(self.model, bodies[0]), {"rtol": 1e-12, "atol": 1e-13}
        result = lw.simulate(model, TIMES[-1], integrator="dop853", times=TIMES, progress=False, **tolerances)
        for k in range(len(self.links)):
            r = np.array([placed[k].r for placed in bodies])
            A = np.array([placed[k].A for placed in bodies]) @ TURNED[k]
            assert np.abs(np.diff(r, axis=0)).max() > 0.05  # it moves
            assert np.abs(result.q[:, k, :3] - r).max() < 1e-7
            assert np.abs(lw.rotation.matrix(result.q[:, k, 3:]) - A).max() < 1e-7
            if k < self.model.joint_count:
                reaction = result.reaction(f"joint {k + 1}")
                assert np.abs(reaction.force - forces[:, k]).max() < 1e-6
                assert np.abs(reaction.torque - torques[:, k]).max() < 1e-6


GROUND = Placed(*(np.eye(3) if name == "A" else np.zeros(3) for name in Placed.__dataclass_fields__))


def _on(k: int, n: int, force: Floats, torque: Floats) -> list[tuple[Floats, Floats]]:
    return [(force, torque) if i == k else (np.zeros(3), np.zeros(3)) for i in range(n)]


def _started(model: lw.Model, bodies: list[Placed]) -> lw.Model:
    core = model.compiled()
    v = [[*body.v, *(TURNED[k].T @ body.w)] for k, body in enumerate(bodies)]
    return model.with_initial_state(core.q0, np.array(v))


# --- joints -------------------------------------------------------------------------------------------------


#: By kind: freedoms, the point on the second body, and what the method of the model takes, for a point.
JOINTS: dict[str, Callable[[Floats], tuple[list[Freedom], Floats, dict[str, Any]]]] = {
    "revolute": lambda P: ([Turn(P, N)], P, {"at": P, "axis": N}),
    "spherical": lambda P: ([Ball(P)], P, {"at": P}),
    "universal": lambda P: ([Turn(P, N), Turn(P, E)], P, {"at": P, "axes": (N, E)}),
    "translational": lambda P: ([Slide(N)], P, {"at": P, "axis": N}),
    "cylindrical": lambda P: ([Turn(P, N), Slide(N)], P, {"at": P, "axis": N}),
    "distance": lambda P: (
        [Turn(P, E), Turn(P, B), Ball(P + 0.9 * N)], P + 0.9 * N, {"at": (P, P + 0.9 * N)}
    ),
    "revolute_spherical": lambda P: (
        [Turn(P, N), Ball(P + 0.3 * E)], P + 0.3 * E, {"at": (P, P + 0.3 * E), "axis": N}
    ),
    "revolute_revolute": lambda P: (
        [Turn(P, N), Turn(P + 0.3 * E, N)], P + 0.3 * E, {"at": (P, P + 0.3 * E), "axis": N}
    ),
    "revolute_translational": lambda P: ([Turn(P, N), Slide(E)], P, {"at": P, "axes": (N, E)}),
    "planar": lambda P: ([Slide(E), Slide(B), Turn(P, N)], P, {"at": P, "axis": N}),
    "point_on_line": lambda P: ([Slide(N), Ball(P)], P, {"at": P, "axis": N}),
    "point_on_plane": lambda P: ([Slide(E), Slide(B), Ball(P)], P, {"at": P, "axis": N}),
    "fixed": lambda P: ([], P, {"at": P}),
}  # fmt: skip

#: Initial speeds, of which a joint takes as many as it has.
SPEEDS = (1.2, -0.7, 0.9, 0.5, -1.1)


def count(kind: str) -> int:
    return sum(freedom.speeds for freedom in JOINTS[kind](POINTS[0])[0])


@pytest.mark.parametrize("kind", [kind for kind in JOINTS if kind != "fixed"])
def test_a_body_on_the_ground_moves_as_in_minimal_coordinates(kind: str) -> None:
    twin = Twin()
    twin.joint(kind)
    twin.pushed()
    twin.sprung()
    twin.compare(SPEEDS[: count(kind)])


@pytest.mark.parametrize(
    "kinds",
    [("revolute", "spherical"), ("spherical", "universal"), ("universal", "translational"),
     ("translational", "cylindrical"), ("revolute", "distance"), ("revolute", "revolute_spherical"),
     ("revolute", "fixed")],
)  # fmt: skip
def test_two_bodies_move_as_in_minimal_coordinates(kinds: tuple[str, str]) -> None:
    twin = Twin()
    twin.joint(kinds[0])
    twin.sprung()
    twin.joint(kinds[1])
    twin.pushed()
    twin.sprung()
    twin.compare((*SPEEDS[: count(kinds[0])], *SPEEDS[: count(kinds[1])]))


# --- springs ------------------------------------------------------------------------------------------------


def test_a_spring_and_damper_between_two_points_bears_a_free_body() -> None:
    twin = Twin()
    twin.body([*FLOATING, Ball(CENTERS[0])], CENTERS[0])
    twin.pushed()
    twin.sprung(stiffness=120.0, damping=2.0)
    twin.compare((0.3, -0.4, 0.2, 0.9, 0.5, -1.1))


@pytest.mark.parametrize(("first", "second"), [("revolute", "revolute"), ("spherical", "cylindrical")])
def test_a_torsional_spring_turns_bodies_about_the_axis_of_their_joint(first: str, second: str) -> None:
    twin = Twin()
    twin.joint(first)
    twin.sprung()
    twin.joint(second)
    twin.model.rotational_spring_damper("body 1", "body 2", at=POINTS[1], axis=N, stiffness=3.0, damping=0.1,
                                        free_angle=0.4, torque=0.2)  # fmt: skip

    def torque(R: Floats, before: Placed, body: Placed) -> Floats:
        n = before.A @ N
        angle = Rotation.from_matrix(R).as_rotvec() @ N  # R turns about N
        return (-3.0 * (angle - 0.4) - 0.1 * n @ (body.w - before.w) + 0.2) * n

    twin.twisted(torque)
    twin.sprung()
    twin.compare((*SPEEDS[: count(first)], *SPEEDS[: count(second)]))


def test_a_bending_spring_holds_an_axis_of_a_body_on_a_ball() -> None:
    twin = Twin()
    twin.joint("revolute")
    twin.sprung()
    twin.joint("spherical")
    twin.pushed()
    twin.model.bending_spring("body 1", "body 2", axis=E, stiffness=8.0, damping=0.2)

    def torque(R: Floats, before: Placed, body: Placed) -> Floats:
        one, other, w = before.A @ E, body.A @ E, body.w - before.w
        across = cross(one, other)
        sine = np.linalg.norm(across) or 1e-300
        return -8.0 * np.arctan2(sine, one @ other) / sine * across - 0.2 * (w - (w @ one) * one)

    twin.twisted(torque)
    twin.compare((1.2, 0.5, -0.7, 0.9))


@pytest.mark.parametrize("on", ["the ground", "a body that turns"])
def test_a_bushing_bears_a_body_in_six_directions(on: str) -> None:
    """The torque about the axis by virtual work: phi_dot = J^-1 w, J the mean of exp(-s phi~), 0 < s < 1."""
    twin = Twin()
    if on != "the ground":
        twin.joint("revolute")
        twin.sprung()
    k, before = len(twin.links), twin.last
    twin.body([*FLOATING, Ball(CENTERS[k])], CENTERS[k])
    twin.pushed()
    point = POINTS[1]
    orientation = Rotation.from_matrix(FRAME).as_quat()[[3, 0, 1, 2]]
    along, about = np.array([150.0, 220.0, 180.0]), np.array([9.0, 6.0, 7.0])
    slow, brake = np.array([1.0, 2.0, 1.5]), np.array([0.1, 0.05, 0.2])
    twin.model.bushing(before, twin.last, at=point, orientation=orientation, stiffness=along,
                       rotational_stiffness=about, damping=slow, rotational_damping=brake)  # fmt: skip
    nodes, weights = np.polynomial.legendre.leggauss(12)

    def load(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
        body, link = bodies[k], twin.links[k]
        P, P_dot = body.at(point, link)
        base = bodies[k - 1] if k else GROUND
        H, H_dot = base.at(point, twin.links[k - 1]) if k else (point, np.zeros(3))
        F, R = base.A @ FRAME, FRAME.T @ base.A.T @ body.A @ FRAME
        u, u_dot = F.T @ (P - H), F.T @ (P_dot - H_dot - cross(base.w, P - H))
        phi = Rotation.from_matrix(R).as_rotvec()
        turns = Rotation.from_rotvec(-np.outer((nodes + 1) / 2, phi)).as_matrix()
        J = np.tensordot(weights / 2, turns, 1)
        phi_dot = np.linalg.solve(J, R.T @ F.T @ (body.w - base.w))
        force = F @ (-along * u - slow * u_dot)
        torque = F @ R @ np.linalg.solve(J.T, -about * phi - brake * phi_dot)
        loads = _on(k, len(bodies), force, cross(P - body.r, force) + torque)
        if k:
            loads[0] = (-force, -cross(P - base.r, force) - torque)
        return loads

    twin.loads.append(load)
    twin.compare((*SPEEDS[:k], 0.3, -0.4, 0.2, 0.9, 0.5, -1.1))
