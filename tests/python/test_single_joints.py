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
from minimal_coordinates import Ball, Chain, Freedom, Link, Placed, Slide, Turn
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Floats = NDArray[np.float64]
Load = Callable[[float, list[Placed]], list[tuple[Floats, Floats]]]

TIMES = np.linspace(0.0, 5.0, 41)
GRAVITY = np.array([0.4, -0.7, -9.7])

#: Axes of joints: N is skew, E and B complete it to a right-handed frame.
N = np.array([2.0, -1.0, 3.0]) / np.sqrt(14.0)
E = np.array([1.0, 2.0, 0.0]) / np.sqrt(5.0)
B = np.cross(N, E)
FRAME = np.column_stack([E, B, N])

#: Where the bodies, and the joints before them, are at the start.
CENTERS = np.array([[0.5, 0.1, 0.25], [1.1, 0.7, 0.1]])
POINTS = np.array([[0.1, -0.2, 0.3], [0.85, 0.45, -0.1]])
TURNED = Rotation.from_rotvec([[0.3, -0.5, 0.8], [-0.9, 0.2, 0.4]])
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
        turned = TURNED[k]
        in_space = turned.as_matrix() @ inertia(k) @ turned.as_matrix().T
        self.links.append(Link(freedoms, MASSES[k], in_space, CENTERS[k], point))
        assert before != self.last
        self.model.body(self.last, mass=MASSES[k], inertia=inertia(k), position=CENTERS[k],
                        orientation=turned.as_quat()[[3, 0, 1, 2]])  # fmt: skip

    def joint(self, kind: str) -> None:
        """A further body, by a joint of this kind at the next of POINTS."""
        before, point = self.last, POINTS[len(self.links)]
        freedoms, on_body, place = JOINTS[kind](point)
        self.body(freedoms, on_body)
        getattr(self.model, kind)(before, self.last, name=f"joint {len(self.links)}", **place)

    def pushed(self) -> None:
        """A constant force at a point of the last body, and a torque that turns with it."""
        k, point = len(self.links) - 1, np.array([0.1, 0.2, -0.15])
        force, torque = np.array([3.0, -2.0, 4.0]), np.array([0.3, 0.2, -0.25])
        self.model.force(self.last, force=force, at=point)
        self.model.force(self.last, torque=torque, frame="body")

        def load(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
            A = bodies[k].A @ TURNED[k].as_matrix()
            return _on(k, len(bodies), force, np.cross(A @ point, force) + A @ torque)

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
            loads = _on(k, len(bodies), -pull * direction, np.cross(p - bodies[k].r, -pull * direction))
            if k:
                loads[k - 1] = (pull * direction, np.cross(o - bodies[k - 1].r, pull * direction))
            return loads

        self.loads.append(load)

    def twisted(self, on_last: Callable[[Floats, Placed, Placed], Floats]) -> None:
        """A torque between the last body and the one before: by R, the turn of one against the other, and both."""
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
        """Positions within 1e-7 m and rad, reactions within 1e-6 N and N m, over 5 s."""

        def loads(t: float, bodies: list[Placed]) -> list[tuple[Floats, Floats]]:
            each = np.array([load(t, bodies) for load in self.loads]).sum(axis=0)
            return [(F, T) for F, T in each]

        chain = Chain(self.links, GRAVITY, loads)
        bodies, forces, torques = chain.motion(speeds, TIMES)
        result = lw.simulate(_started(self.model, bodies[0]), 5.0, integrator="dop853", rtol=1e-12, atol=1e-13,
                             times=TIMES, progress=False)  # fmt: skip
        for k in range(len(self.links)):
            r = np.array([placed[k].r for placed in bodies])
            A = np.array([placed[k].A for placed in bodies]) @ TURNED[k].as_matrix()
            assert np.abs(np.diff(r, axis=0)).max() > 0.05  # it moves
            assert np.abs(result.q[:, k, :3] - r).max() < 1e-7
            assert np.abs(lw.rotation.matrix(result.q[:, k, 3:]) - A).max() < 1e-7
            if self.model.joint_count:
                reaction = result.reaction(f"joint {k + 1}")
                assert np.abs(reaction.force - forces[:, k]).max() < 1e-6
                assert np.abs(reaction.torque - torques[:, k]).max() < 1e-6


GROUND = Placed(*(np.eye(3) if name == "A" else np.zeros(3) for name in Placed.__dataclass_fields__))


def _on(k: int, n: int, force: Floats, torque: Floats) -> list[tuple[Floats, Floats]]:
    return [(force, torque) if i == k else (np.zeros(3), np.zeros(3)) for i in range(n)]


def _started(model: lw.Model, bodies: list[Placed]) -> lw.Model:
    core = model.compiled()
    v = [[*body.v, *(TURNED[k].as_matrix().T @ body.w)] for k, body in enumerate(bodies)]
    return model.with_initial_state(core.q0, np.array(v))


# --- joints -------------------------------------------------------------------------------------------------


#: By kind: freedoms, the point on the second body, and what the method of the model takes, for a point.
JOINTS: dict[str, Callable[[Floats], tuple[list[Freedom], Floats, dict[str, Any]]]] = {
    "revolute": lambda P: ([Turn(P, N)], P, {"at": P, "axis": N}),
    "spherical": lambda P: ([Ball(P)], P, {"at": P}),
    "universal": lambda P: ([Turn(P, N), Turn(P, E)], P, {"at": P, "axes": (N, E)}),
    "translational": lambda P: ([Slide(N)], P, {"at": P, "axis": N}),
    "cylindrical": lambda P: ([Turn(P, N), Slide(N)], P, {"at": P, "axis": N}),
    "distance": lambda P: ([Turn(P, E), Turn(P, B), Ball(P + 0.4 * N)], P + 0.4 * N, {"at": (P, P + 0.4 * N)}),
    "revolute_spherical": lambda P: (
        [Turn(P, N), Ball(P + 0.3 * E)], P + 0.3 * E, {"at": (P, P + 0.3 * E), "axis": N}
    ),
    "universal_spherical": lambda P: (
        [Turn(P, E), Turn(P, B), Ball(P + 0.4 * N)], P + 0.4 * N, {"at": (P, P + 0.4 * N)}
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
     ("translational", "cylindrical"), ("cylindrical", "distance"), ("revolute", "revolute_spherical"),
     ("spherical", "revolute"), ("revolute", "fixed")],
)  # fmt: skip
def test_two_bodies_move_as_in_minimal_coordinates(kinds: tuple[str, str]) -> None:
    twin = Twin()
    twin.joint(kinds[0])
    twin.sprung()
    twin.joint(kinds[1])
    twin.pushed()
    twin.sprung()
    twin.compare((*SPEEDS[: count(kinds[0])], *SPEEDS[: count(kinds[1])]))
