"""Mechanisms that pass singular poses, with their motion along one branch in minimal coordinates.

A branch is a curve of poses: planar bodies whose positions and angles are functions of one coordinate s,
written with `Jet`, which carries two derivatives. The equation of motion along it,

    m(s) s_ddot + m'(s) s_dot^2 / 2 + V'(s) = 0,

is regular in the singular poses, and is integrated with 13 digits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import linkwork as lw
import numpy as np
from linkwork.arrays import Floats
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

GRAVITY = 9.81


@dataclass(frozen=True)
class Jet:
    """A function of s with its first two derivatives."""

    f: float
    d: float = 0.0
    dd: float = 0.0

    def __add__(self, other: Jet | float) -> Jet:
        o = other if isinstance(other, Jet) else Jet(other)
        return Jet(self.f + o.f, self.d + o.d, self.dd + o.dd)

    __radd__ = __add__

    def __mul__(self, other: Jet | float) -> Jet:
        o = other if isinstance(other, Jet) else Jet(other)
        return Jet(
            self.f * o.f, self.d * o.f + self.f * o.d, self.dd * o.f + 2 * self.d * o.d + self.f * o.dd
        )

    __rmul__ = __mul__

    def __neg__(self) -> Jet:
        return -1.0 * self

    def __sub__(self, other: Jet | float) -> Jet:
        return self + -1.0 * (other if isinstance(other, Jet) else Jet(other))

    def chain(self, f: float, df: float, ddf: float) -> Jet:
        return Jet(f, df * self.d, ddf * self.d**2 + df * self.dd)


def sin(x: Jet) -> Jet:
    return x.chain(np.sin(x.f), np.cos(x.f), -np.sin(x.f))


def cos(x: Jet) -> Jet:
    return x.chain(np.cos(x.f), -np.sin(x.f), -np.cos(x.f))


def folded(s: Jet, ratio: float) -> Jet:
    """2 atan(-ratio tan(s / 2)), continued over full turns: the rocker of an antiparallelogram."""
    c, n = np.cos(0.5 * s.f), np.sin(0.5 * s.f)
    turns = np.round(s.f / (2 * np.pi))
    q = (ratio * n) ** 2 + c * c
    near = s.f - 2 * np.pi * turns
    angle = 2 * np.arctan2(-ratio * np.sin(0.5 * near), np.cos(0.5 * near)) - 2 * np.pi * turns
    return s.chain(float(angle), -ratio / q, ratio * (ratio**2 - 1) * n * c / q**2)


@dataclass(frozen=True)
class Link:
    """A planar body: its center of mass at (along, across) of its base point in axes turned by its angle."""

    mass: float
    inertia: float  # about z, through the center of mass
    along: float
    across: float = 0.0


def _speed(_t: float, y: Floats) -> float:
    return float(y[1])


Pose = Callable[[Jet], Sequence[tuple[Jet, Jet, Jet]]]


@dataclass(frozen=True)
class Branch:
    """A mechanism on one branch of its motion.

    pins      (a, distance of the pin from the base point of a along its axis, b or -1, the same of b, or x on
              the ground)
    sliders   bodies that slide along x without turning
    pose      x, y of the base point and the angle of each link as functions of s
    singular  an s at which branches meet; period between such s
    """

    name: str
    links: tuple[Link, ...]
    pins: tuple[tuple[int, float, int, float], ...]
    pose: Pose
    sliders: tuple[int, ...] = ()
    singular: float = 0.0
    period: float = np.pi
    speed: tuple[float, float] = (2.5, 7.5)
    turntable: float | None = None  #: inertia of a base that turns about y, on which the mechanism stands
    size: float = 1.0

    def centers(self, s: float) -> list[tuple[Jet, Jet, Jet]]:
        """x, y of the centers of mass and angles, with their derivatives by s."""
        out = []
        for link, (x, y, angle) in zip(self.links, self.pose(Jet(s, 1.0)), strict=True):
            c, n = cos(angle), sin(angle)
            out.append((x + c * link.along - n * link.across, y + n * link.along + c * link.across, angle))
        return out

    @cached_property
    def _series(self) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Fourier coefficients (k, 6) of m, V, I (about y, without the turntable) and of their derivatives by
        s, and their i k; without those that are roundoff, which the derivatives would multiply by k."""
        count = 512
        values = np.zeros((count, 3))
        for n in range(count):
            for link, (x, y, angle) in zip(self.links, self.centers(2 * np.pi * n / count), strict=True):
                # of a flat body: J_x + J_y = J_z; here J_x = 0.2 J_z, J_y = 0.8 J_z
                across = 0.2 + 0.6 * np.cos(angle.f) ** 2
                values[n] += (
                    link.mass * (x.d**2 + y.d**2) + link.inertia * angle.d**2,
                    link.mass * GRAVITY * y.f,
                    link.mass * x.f**2 + link.inertia * across,
                )
        c = np.fft.rfft(values, axis=0) / count
        c[1:] *= 2.0
        used = int(np.flatnonzero(np.abs(c).max(axis=1) > 1e-15 * np.abs(c).max())[-1]) + 1
        ik = 1j * np.arange(used)
        return np.hstack([c[:used], ik[:, None] * c[:used]]), ik

    def _terms(self, s: float) -> list[float]:
        """m, V, I, and their derivatives by s."""
        c, ik = self._series
        terms: list[float] = (np.exp(ik * s) @ c).real.tolist()
        return terms

    def rates(self, _t: float, y: Floats) -> Floats:
        """Of (s, s_dot), and (psi, psi_dot) of the turntable."""
        s, s_dot, *turning = y.tolist()
        m, _, inertia, dm, dV, d_inertia = self._terms(s)
        if self.turntable is None:
            return np.array([s_dot, -(dV + 0.5 * dm * s_dot**2) / m])
        psi_dot, whole = turning[1], inertia + self.turntable
        s_ddot = (-dV - 0.5 * dm * s_dot**2 + 0.5 * d_inertia * psi_dot**2) / m
        return np.array([s_dot, s_ddot, psi_dot, -d_inertia * s_dot * psi_dot / whole])

    def flow(self, start: Floats, times: Floats) -> Floats:
        """States (k, 2 or 4) at these times [s], from `start` at 0; negative times go back."""
        return self.flow_and_turns(start, times)[0]

    def flow_and_turns(self, start: Floats, times: Floats) -> tuple[Floats, Floats]:
        """States (k, 2 or 4) at these times, and the values of s at which it turns back on the way."""
        if times[-1] == 0.0:
            return np.tile(start, (len(times), 1)), np.empty(0)
        solution = solve_ivp(
            self.rates, (0.0, times[-1]), start, "DOP853", times, events=_speed, rtol=3e-14, atol=1e-14
        )
        return np.asarray(solution.y.T), solution.y_events[0].reshape(-1, len(start))[:, 0]

    def positions(self, states: Floats) -> Floats:
        """Centers of mass (k, bodies, 3)."""
        out = np.empty((len(states), len(self.links), 3))
        for k, state in enumerate(states):
            psi = state[2] if self.turntable is not None else 0.0
            for b, (x, y, _) in enumerate(self.centers(state[0])):
                out[k, b] = (x.f * np.cos(psi), y.f, -x.f * np.sin(psi))
        return out

    def energy(self, state: Floats) -> tuple[float, float]:
        """Kinetic and potential [J]."""
        m, V, inertia = self._terms(state[0])[:3]
        kinetic = 0.5 * m * state[1] ** 2
        if self.turntable is not None:
            kinetic += 0.5 * (inertia + self.turntable) * state[3] ** 2
        return float(kinetic), float(V)

    def model(self, state: Floats) -> lw.Model:
        """At s and s_dot (and psi = 0 and psi_dot of the turntable)."""
        model = lw.Model(gravity=(0, -GRAVITY, 0), name=self.name)
        spin = np.array([0.0, state[3] if self.turntable is not None else 0.0, 0.0])
        base: lw.Body = model.ground
        if self.turntable is not None:
            base = model.body(
                "turntable", mass=1.0, inertia=np.full(3, self.turntable), position=(0, 0, 0), omega=spin
            )
            model.revolute(model.ground, base, at=(0, 0, 0), axis=(0, 1, 0), name="column")
        bodies = []
        for k, (link, (x, y, angle)) in enumerate(zip(self.links, self.centers(state[0]), strict=True)):
            center = np.array([x.f, y.f, 0.0])
            half = 0.5 * angle.f
            c, n = np.cos(angle.f), np.sin(angle.f)
            omega = np.array([n * spin[1], c * spin[1], angle.d * state[1]])  # body axes
            bodies.append(
                model.body(f"link {k}", mass=link.mass, inertia=link.inertia * np.array([0.2, 0.8, 1.0]),
                           position=center,
                           orientation=(np.cos(half), 0, 0, np.sin(half)), omega=omega,
                           velocity=np.array([x.d, y.d, 0.0]) * state[1] + np.cross(spin, center))
            )  # fmt: skip
        places = self.pose(Jet(state[0], 1.0))
        for k, (a, along, b, _) in enumerate(self.pins):
            x, y, angle = places[a]
            at = (x.f + along * np.cos(angle.f), y.f + along * np.sin(angle.f), 0.0)
            other = bodies[b] if b >= 0 else base
            model.revolute(other, bodies[a], at=at, axis=(0, 0, 1), name=f"pin {k}")
        for b in self.sliders:
            x, y, _ = places[b]
            model.translational(base, bodies[b], at=(x.f, y.f, 0.0), axis=(1, 0, 0), name=f"slide {b}")
        return model


def parallelogram(
    name: str, a: float, b: float, masses: Sequence[float], center: tuple[float, float], *,
    anti: bool = False, turntable: float | None = None, speed: tuple[float, float] = (2.5, 7.5),
) -> Branch:  # fmt: skip
    """Cranks of length a on a ground of length b; as a parallelogram or crossed."""
    links = (
        Link(masses[0], masses[0] * a * a / 12, a / 2),
        Link(masses[1], masses[1] * b * b / 12, *center),
        Link(masses[2], masses[2] * a * a / 12, a / 2),
    )

    def pose(s: Jet) -> Sequence[tuple[Jet, Jet, Jet]]:
        rocker = folded(s, (b + a) / (b - a)) if anti else s
        coupler = s + rocker if anti else Jet(0.0)
        return (Jet(0), Jet(0), s), (a * cos(s), a * sin(s), coupler), (Jet(b), Jet(0), rocker)

    pins = ((0, 0.0, -1, 0.0), (1, 0.0, 0, a), (2, a, 1, b), (2, 0.0, -1, b))
    return Branch(name, links, pins, pose, speed=speed, turntable=turntable, size=a)


def slider_crank() -> Branch:
    """Crank and rod of one length: singular where both stand upright and the slider is at the crank's pin."""
    L = 0.5
    links = (
        Link(1.0, L * L / 12, L / 2),
        Link(0.3, 0.3 * L * L / 10, 0.35 * L, 0.05 * L),
        Link(2.0, 0.01, 0.0),
    )

    def pose(s: Jet) -> Sequence[tuple[Jet, Jet, Jet]]:
        return (Jet(0), Jet(0), s), (L * cos(s), L * sin(s), -s), (2 * L * cos(s), Jet(0), Jet(0))

    pins = ((0, 0.0, -1, 0.0), (1, 0.0, 0, L), (1, L, 2, 0.0))
    return Branch(
        "slider-crank", links, pins, pose, sliders=(2,), singular=np.pi / 2, speed=(1.0, 3.0), size=L
    )


def row_of_two(masses: Sequence[float], lengths: tuple[float, float, float], name: str) -> Branch:
    """Two parallelograms side by side on three cranks."""
    a, b, c = lengths
    links = (
        Link(masses[0], masses[0] * a * a / 12, a / 2),
        Link(masses[1], masses[1] * b * b / 12, 0.4 * b, 0.1 * a),
        Link(masses[2], masses[2] * a * a / 12, 0.3 * a),
        Link(masses[3], masses[3] * c * c / 12, 0.3 * c, -0.1 * a),
        Link(masses[4], masses[4] * a * a / 12, a / 2),
    )

    def pose(s: Jet) -> Sequence[tuple[Jet, Jet, Jet]]:
        x, y = a * cos(s), a * sin(s)
        return (
            (Jet(0), Jet(0), s), (x, y, Jet(0)), (Jet(b), Jet(0), s),
            (b + x, y, Jet(0)), (Jet(b + c), Jet(0), s),
        )  # fmt: skip

    pins = (
        (0, 0.0, -1, 0.0), (1, 0.0, 0, a), (2, a, 1, b), (2, 0.0, -1, b),
        (3, 0.0, 2, a), (4, a, 3, c), (4, 0.0, -1, b + c),
    )  # fmt: skip
    return Branch(name, links, pins, pose, size=a)


def folding_six_bar() -> Branch:
    """A parallelogram whose second crank drives an antiparallelogram: all links fold at once."""
    a, b, c = 0.6, 1.3, 1.1
    links = (
        Link(1.0, a * a / 12, a / 2),
        Link(2.5, 2.5 * b * b / 12, 0.4, 0.15),
        Link(0.7, 0.7 * a * a / 12, a / 2),
        Link(1.4, 1.4 * c * c / 12, 0.6, -0.1),
        Link(0.5, 0.5 * a * a / 12, a / 2),
    )

    def pose(s: Jet) -> Sequence[tuple[Jet, Jet, Jet]]:
        x, y = a * cos(s), a * sin(s)
        rocker = folded(s, (c + a) / (c - a))
        return (
            (Jet(0), Jet(0), s), (x, y, Jet(0)), (Jet(b), Jet(0), s),
            (b + x, y, s + rocker), (Jet(b + c), Jet(0), rocker),
        )  # fmt: skip

    pins = (
        (0, 0.0, -1, 0.0), (1, 0.0, 0, a), (2, a, 1, b), (2, 0.0, -1, b),
        (3, 0.0, 2, a), (4, a, 3, c), (4, 0.0, -1, b + c),
    )  # fmt: skip
    return Branch("folding six-bar", links, pins, pose, speed=(1.5, 3.5), size=a)


BRANCHES = {
    branch.name: branch
    for branch in (
        parallelogram("four-bar", 1.0, 1.0, (1, 1, 1), (0.5, 0.0)),
        row_of_two((1, 1, 1, 1, 1), (1.0, 1.0, 1.0), "two four-bars"),
        parallelogram("unequal", 0.6, 1.3, (1, 2.5, 0.4), (0.4, 0.15)),
        parallelogram("antiparallelogram", 0.6, 1.3, (1, 2.5, 0.4), (0.4, 0.15), anti=True, speed=(1.5, 4.5)),
        slider_crank(),
        folding_six_bar(),
        parallelogram("on a turntable", 0.6, 1.3, (1, 2.5, 0.4), (0.4, 0.15), turntable=0.8),
    )
}
