"""Chains of bodies in minimal coordinates by Kane's method: a reference that shares no code with linkwork.

A body moves against the one before it by freedoms: turns, slides, balls. Points and axes are given in space
at the initial pose, in which all coordinates are zero and all frames are parallel. The equations are

    sum m J^T (J u' + a) + W^T (I (W u' + alpha) + w x I w) = sum J^T F + W^T T

with the velocities J u of the centers of mass, the angular velocities W u, and what is left of accelerations
for u' = 0, a and alpha. Reactions follow from Newton's and Euler's laws, from the last body to the first.

Reference: Kane, Levinson, Dynamics: Theory and Applications, McGraw-Hill 1985, chapter 6.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from linkwork.arrays import Floats
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation


@dataclass(frozen=True)
class Turn:
    """About an axis (3,) through a point (3,): one angle."""

    at: ArrayLike
    axis: ArrayLike
    coordinates, speeds = 1, 1
    start = (0.0,)


@dataclass(frozen=True)
class Slide:
    """Along an axis (3,): one shift."""

    axis: ArrayLike
    coordinates, speeds = 1, 1
    start = (0.0,)


@dataclass(frozen=True)
class Ball:
    """About a point (3,): Euler parameters, and an angular velocity in the axes of what turns."""

    at: ArrayLike
    coordinates, speeds = 4, 3
    start = (1.0, 0.0, 0.0, 0.0)


Freedom = Turn | Slide | Ball


@dataclass(frozen=True)
class Link:
    """A body and its freedoms against the body before it."""

    freedoms: Sequence[Freedom]
    mass: float
    inertia: Floats  #: (3, 3) about the center of mass, axes of space at the initial pose
    position: Floats  #: (3,) of the center of mass
    point: Floats  #: (3,) of the joint on this body, about which torques are


@dataclass(frozen=True)
class Placed:
    """A body at one time: center of mass r, turn A since the start, velocities, and their terms."""

    r: Floats
    A: Floats
    v: Floats
    w: Floats
    J: Floats
    W: Floats
    a: Floats
    alpha: Floats
    point: Floats  #: of the joint

    def at(self, start: ArrayLike, link: Link) -> tuple[Floats, Floats]:
        """Place and velocity of the body's point that was at `start`."""
        arm = self.A @ (np.asarray(start) - link.position)
        return self.r + arm, self.v + cross(self.w, arm)


#: Force at the center of mass [N] and torque [N m] on each body, from t and the bodies.
Loads = Callable[[float, list[Placed]], list[tuple[Floats, Floats]]]


def skew(a: Floats) -> Floats:
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def cross(a: Floats, b: Floats) -> Floats:
    """a x b of two (3,): numpy.cross takes ten times as long."""
    a0, a1, a2 = a.tolist()
    b0, b1, b2 = b.tolist()
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])


class Chain:
    """Links one after the other, the first one on the ground; loads without weight."""

    def __init__(self, links: Sequence[Link], gravity: ArrayLike, loads: Loads) -> None:
        self.links, self.gravity, self.loads = links, np.asarray(gravity, dtype=float), loads
        freedoms = [freedom for link in links for freedom in link.freedoms]
        self.speeds = sum(freedom.speeds for freedom in freedoms)
        self.start = np.array([value for freedom in freedoms for value in freedom.start])

    def placed(self, q: Floats, u: Floats) -> list[Placed]:
        frame, at, k, bodies = _Frame(self.speeds), 0, 0, []
        for link in self.links:
            for freedom in link.freedoms:
                frame.move(freedom, q[at : at + freedom.coordinates], u, k)
                at, k = at + freedom.coordinates, k + freedom.speeds
            frame.go_to(link.point)
            point = frame.o
            frame.go_to(link.position)
            bodies.append(Placed(frame.o, frame.A, frame.v, frame.w, frame.J, frame.W, frame.a, frame.alpha,
                                 point))  # fmt: skip
        return bodies

    def rates(self, t: float, y: Floats) -> Floats:
        """y' of y = (q, u)."""
        q, u = y[: len(self.start)], y[len(self.start) :]
        return np.concatenate([self._q_dot(q, u), self._u_dot(t, self.placed(q, u))])

    def motion(self, u: ArrayLike, times: Floats) -> tuple[list[list[Placed]], Floats, Floats]:
        """From the speeds u on: the bodies at `times`; force and torque (k, links, 3) that joints exert."""
        y0 = np.concatenate([self.start, np.asarray(u, dtype=float)])
        found = solve_ivp(self.rates, (0.0, times[-1]), y0, "DOP853", t_eval=times, rtol=1e-12, atol=1e-13)
        assert found.success, found.message
        n = len(self.start)
        bodies = [self.placed(y[:n], y[n:]) for y in found.y.T]
        reactions = [self._reactions(t, placed) for t, placed in zip(times, bodies, strict=True)]
        return bodies, *np.array(reactions).swapaxes(0, 1)

    def _q_dot(self, q: Floats, u: Floats) -> Floats:
        q_dot, at, k = np.empty_like(q), 0, 0
        for link in self.links:
            for freedom in link.freedoms:
                w = u[k : k + freedom.speeds]
                if isinstance(freedom, Ball):
                    p0, p = q[at], q[at + 1 : at + 4]
                    q_dot[at : at + 4] = 0.5 * np.array([-p @ w, *(p0 * w + cross(p, w))])
                else:
                    q_dot[at] = w[0]
                at, k = at + freedom.coordinates, k + freedom.speeds
        return q_dot

    def _u_dot(self, t: float, bodies: list[Placed]) -> Floats:
        M, f = np.zeros((self.speeds, self.speeds)), np.zeros(self.speeds)
        for link, body, (F, T) in zip(self.links, bodies, self.loads(t, bodies), strict=True):
            inertia = body.A @ link.inertia @ body.A.T
            M += link.mass * body.J.T @ body.J + body.W.T @ inertia @ body.W
            f += body.J.T @ (F + link.mass * (self.gravity - body.a))
            f += body.W.T @ (T - inertia @ body.alpha - cross(body.w, inertia @ body.w))
        return np.linalg.solve(M, f)

    def _reactions(self, t: float, bodies: list[Placed]) -> tuple[Floats, Floats]:
        u_dot, loads = self._u_dot(t, bodies), self.loads(t, bodies)
        forces, torques = np.zeros((2, len(bodies), 3))
        force, torque, point = np.zeros(3), np.zeros(3), np.zeros(3)  # on the next body
        for k in reversed(range(len(bodies))):
            link, body, (F, T) = self.links[k], bodies[k], loads[k]
            inertia = body.A @ link.inertia @ body.A.T
            own = link.mass * (body.J @ u_dot + body.a - self.gravity) - F
            turning = inertia @ (body.W @ u_dot + body.alpha) + cross(body.w, inertia @ body.w) - T
            torque = turning + torque + cross(body.r - body.point, own) + cross(point - body.point, force)
            force, point = own + force, body.point
            forces[k], torques[k] = force, torque
        return forces, torques


class _Frame:
    """A point o of what moves, that was at `start`; velocities, and accelerations for u' = 0."""

    def __init__(self, speeds: int) -> None:
        self.start, self.o, self.A = np.zeros(3), np.zeros(3), np.eye(3)
        self.v, self.w, self.a, self.alpha = np.zeros((4, 3))
        self.J, self.W = np.zeros((2, 3, speeds))

    def go_to(self, start: ArrayLike) -> None:
        """Another point of the same."""
        self._shift(self.A @ (np.asarray(start) - self.start))
        self.start = np.asarray(start, dtype=float)

    def move(self, freedom: Freedom, q: Floats, u: Floats, k: int) -> None:
        if isinstance(freedom, Slide):
            n = self.A @ _unit(freedom.axis)
            self._shift(n * q[0])
            self.a = self.a + 2 * u[k] * cross(self.w, n)
            self.v = self.v + n * u[k]
            self.J = self.J.copy()
            self.J[:, k] += n
            return
        self.go_to(freedom.at)
        if isinstance(freedom, Ball):
            self.A = self.A @ Rotation.from_quat(q[[1, 2, 3, 0]]).as_matrix()
            axes = self.A
        else:
            n = self.A @ _unit(freedom.axis)
            axes, tilde = n[:, None], skew(n)
            self.A = self.A + (np.sin(q[0]) * tilde + (1 - np.cos(q[0])) * tilde @ tilde) @ self.A
        relative = axes @ u[k : k + freedom.speeds]
        self.alpha = self.alpha + cross(self.w, relative)
        self.w = self.w + relative
        self.W = self.W.copy()
        self.W[:, k : k + freedom.speeds] += axes

    def _shift(self, d: Floats) -> None:
        moving = cross(self.w, d)
        self.o = self.o + d
        self.v = self.v + moving
        self.a = self.a + cross(self.alpha, d) + cross(self.w, moving)
        self.J = self.J - skew(d) @ self.W


def _unit(axis: ArrayLike) -> Floats:
    a = np.asarray(axis, dtype=float)
    return a / np.sqrt(a @ a)
