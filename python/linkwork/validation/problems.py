"""The reference problems. Required figures are what the mechanisms' documentation promises."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.errors import OptionError, nearest
from linkwork.results.result import Result
from linkwork.validation.problem import Figure, Problem, Verdict, largest, relative
from linkwork.validation.series import Series

__all__ = ["PROBLEMS", "validate"]


def pendulum(result: Result, exact: Series) -> list[Figure]:
    """The multiplier counts compression, the solution tension."""
    return [
        Figure("position", largest(result.position[:, 0, :2] - exact("x", "y")), 1e-8, "m"),
        Figure("velocity", largest(result.velocity[:, 0, :2] - exact("vx", "vy")), 1e-8, "m/s"),
        Figure("tension of the rod", relative(-result.multipliers[:, 0], exact("tension")), 1e-8),
    ]


def rod_pendulum(result: Result, exact: Series) -> list[Figure]:
    force, theta = result.reaction("pin").force, exact("theta")
    center = 0.5 * np.column_stack([np.sin(theta), -np.cos(theta)])
    return [
        Figure("position", largest(result.position[:, 0, :2] - center), 1e-8, "m"),
        Figure("reaction of the pin", relative(force[:, :2], exact("Rx", "Ry")), 1e-7),
        Figure("reaction out of the plane", largest(force[:, 2]), 1e-12, "N"),
    ]


def heavy_top(result: Result, exact: Series) -> list[Figure]:
    """The place after two seconds is published; energy is constant."""
    published, energy = np.array([-0.150416822746, -0.724165591637, -0.673022269560]), exact.definition["E0"]
    return [
        Figure("published position at 2 s", largest(result.position[-1, 0] - published), 1e-6, "m"),
        Figure("position", largest(result.position[:, 0] - exact("x", "y", "z")), 1e-6, "m"),
        Figure("energy", largest(result.energy - energy) / energy, 1e-6),
    ]


def torque_free_top(result: Result, exact: Series) -> list[Figure]:
    """Euler parameters p and -p are the same rotation."""
    p = exact("q0", "q1", "q2", "q3")
    same_sign = np.sign(np.sum(p * result.orientation[:, 0], axis=1))[:, None]
    return [
        Figure("orientation", largest(result.orientation[:, 0] - same_sign * p), 1e-9),
        Figure("angular velocity", largest(result.omega[:, 0] - exact("wx", "wy", "wz")), 1e-9, "rad/s"),
    ]


def four_bar(result: Result, exact: Series) -> list[Figure]:
    """The top of the first post, through singular poses; more loops, more rounding."""
    position, velocity = end_of(result.body("post 0"))
    required = 1e-7 if len(result.body_names) < 50 else 1e-5
    return [
        Figure("position", largest(position[:, :2] - exact("x", "y")), required, "m"),
        Figure("velocity", largest(velocity[:, :2] - exact("vx", "vy")), required, "m/s"),
    ]


#: Angles of Andrews' mechanism, in the order of the test set, and of which bodies they are differences.
ANDREWS_ANGLES = (
    ("K1", None),
    ("K2", "K1"),
    ("K3", None),
    ("K4", "K5"),
    ("K5", None),
    ("K6", "K7"),
    ("K7", None),
)


def andrews(result: Result, exact: Series) -> list[Figure]:
    """At 0.03 s; the forces are those on K3, K4 and K6 at their common point."""
    published = np.array(exact.definition["published_reference_y27_t0p03"])
    bodies = {name: result.body(name) for name in result.body_names}
    turned = {n: 2 * np.arctan2(b.orientation[-1, 3], b.orientation[-1, 0]) for n, b in bodies.items()}
    spins = {name: body.omega[-1, 2] for name, body in bodies.items()}
    angles = np.array([turned[body] - turned.get(other or "", 0.0) for body, other in ANDREWS_ANGLES])
    rates = np.array([spins[body] - spins.get(other or "", 0.0) for body, other in ANDREWS_ANGLES])
    angles += 2 * np.pi * np.round((published[:7] - angles) / (2 * np.pi))
    forces = np.concatenate([result.reaction(joint).force[-1, :2] for joint in ("E3", "E4", "E6")])
    return [
        Figure("angles", each(angles, published[:7]), 1e-9),
        Figure("angular velocities", each(rates, published[7:14]), 1e-7),
        Figure("reactions at the common point", each(forces, published[21:27]), 1e-5),
    ]


def bricard(result: Result, exact: Series) -> list[Figure]:
    """P3 is where the second rod ends."""
    position, _ = end_of(result.body("rod 2"))
    return [
        Figure("position", largest(position - exact("P3x", "P3y", "P3z")[: len(result)]), 1e-8, "m"),
        Figure("energy", largest(result.energy - exact.definition["E0"]), 1e-8, "J"),
    ]


def flyball_governor(result: Result, exact: Series) -> list[Figure]:
    """The angular momentum about the shaft stays, energy goes into the dampers."""
    slider, header = result.body("slider"), result.header
    A = rotation.matrix(result.orientation)
    spin = np.einsum("kbij,bjl,kbl->kbi", A, header.inertia, result.omega)
    orbital = header.mass[:, None] * np.cross(result.position, result.velocity)
    momentum = (orbital + spin).sum(axis=1)[:, 2]
    return [
        Figure("position of the slider", largest(slider.position[:, 2] - exact("s")), 1e-7, "m"),
        Figure("velocity of the slider", largest(slider.velocity[:, 2] - exact("sdot")), 1e-6, "m/s"),
        Figure("angular momentum", relative(momentum, exact("Hz")), 1e-7),
    ]


def end_of(rod: Any) -> tuple[Floats, Floats]:
    """Position and velocity of the point 0.5 m along a body's x axis."""
    A = rotation.matrix(rod.orientation)
    arm = np.array([0.5, 0.0, 0.0])
    turning = np.einsum("kij,kj->ki", A, np.cross(rod.omega, arm))
    return rod.position + A @ arm, rod.velocity + turning


def each(values: Floats, exact: Floats) -> float:
    """Largest error of any value, relative to that value."""
    return largest((values - exact) / exact)


PROBLEMS: dict[str, Problem] = {
    problem.name: problem
    for problem in (
        Problem("pendulum", "IFToMM benchmark A01, closed form", "A01_pendulum", pendulum, "pendulum"),
        Problem("rod_pendulum", "closed form", "rod_pendulum", rod_pendulum, "rod_pendulum"),
        Problem("heavy_top", "Bruels, Cardona and Arnold (2012), quadrature", "heavy_top", heavy_top,
                "heavy_top"),
        Problem("torque_free_top", "closed form", "torquefree_symmetric", torque_free_top, "torque_free_top"),
        *(
            Problem(f"four_bar_{n}", "IFToMM benchmark A02, closed form", f"A02_fourbar_N{n}_10s", four_bar,
                    "four_bar", {"n": n})
            for n in (1, 2, 40)
        ),
        Problem("andrews", "IFToMM benchmark A03, Test Set for IVP Solvers", "A03_andrews_ivp", andrews,
                "andrews"),
        Problem("bricard", "IFToMM benchmark A04, relative coordinates", "A04_bricard_section0p1", bricard,
                "bricard"),
        Problem("flyball_governor", "IFToMM benchmark A05, minimal coordinates", "A05_flyball",
                flyball_governor, "flyball_governor"),
    )
}  # fmt: skip


def validate(names: Iterable[str] | None = None) -> Iterator[Verdict]:
    """The verdict on each problem as it comes; all without `names`. OptionError: there is no such problem."""
    chosen = list(PROBLEMS if names is None else names)
    for name in chosen:
        if name not in PROBLEMS:
            raise OptionError(
                f"reference problem '{name}' does not exist{nearest(name, PROBLEMS)}", code="unknown_option"
            )
    return (PROBLEMS[name].run() for name in chosen)
