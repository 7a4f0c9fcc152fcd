"""Accelerations and reactions do not depend on how a mechanism is described."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork.arrays import Floats
from random_mechanisms import FORCES, JOINTS, Element, Maker, Mechanism, examples, mechanisms

#: Relative; two descriptions differ by roundoff only, which the worst random mechanisms magnify by 1e6.
EXACT = {"standard": 1e-9, "augmented_lagrangian": 1e-9}

#: The penalty method's reactions are its penalty, 1e7 times scaled, by which roundoff is magnified, too.
SAME_EQUATIONS = EXACT | {"penalty": 1e-6}

#: Where translations become combinations of a joint's rotations, each has another penalty, and answers of the
#: penalty method differ by its own error, 1 / (1 + sigma_min): see test_formulations_agree.
OTHER_EQUATIONS = EXACT


@dataclass(frozen=True)
class Motion:
    """What must not change: accelerations (n, 3), and each joint's wrench on its second body."""

    linear: Floats
    angular: Floats  #: body axes
    force: Floats
    torque: Floats

    free_linear: float  #: size of M^-1 g, for mechanisms that cannot move
    meter: float = (
        1.0  #: relates forces to torques, and linear to angular accelerations, where there are none
    )

    def close_to(self, other: Motion, tolerance: float, formulation: str = "") -> None:
        size = {
            what: np.abs(getattr(other, what)).max(initial=0.0)
            for what in ("linear", "angular", "force", "torque")
        }
        size["linear"] += other.free_linear
        size["angular"] += size["linear"] / other.meter
        size["torque"] += other.meter * size["force"]
        for what in size:
            error = np.abs(getattr(self, what) - getattr(other, what)).max(initial=0.0) / (size[what] or 1.0)
            assert error <= tolerance, f"{formulation} {what}: {error:.2e} relative"


def motion(mechanism: Mechanism, formulation: str) -> Motion:
    dynamics = mechanism.dynamics(formulation=formulation)
    v_dot, multipliers = dynamics.accelerations(0.0, mechanism.q, mechanism.v)
    force, torque = dynamics.reactions(0.0, mechanism.q, multipliers)
    g = dynamics.evaluate(0.0, mechanism.q, mechanism.v)["g"].reshape(-1, 6)
    free = max(np.abs(load[:3]).max() / body.mass for load, body in zip(g, mechanism.bodies, strict=True))
    halves = v_dot.reshape(-1, 6)
    return Motion(halves[:, :3], halves[:, 3:], force, torque, float(free))


def assert_same(
    mechanism: Mechanism,
    other: Mechanism,
    described: Callable[[Motion], Motion],
    tolerances: dict[str, float],
) -> None:
    """By each formulation the other one has the motion of the first, as it is `described` there."""
    for formulation, tolerance in tolerances.items():
        found, expected = motion(other, formulation), described(motion(mechanism, formulation))
        found.close_to(expected, tolerance, formulation)


# --- rigid motion of everything -----------------------------------------------------------------------------


def moved(mechanism: Mechanism, p: Floats, shift: Floats) -> Mechanism:
    """Bodies, ground points, gravity, and components along inertial axes."""
    R = lw.rotation.matrix(p)
    bodies = tuple(
        replace(body, r=R @ body.r + shift, p=quaternion_product(p, body.p), r_dot=R @ body.r_dot)
        for body in mechanism.bodies
    )

    def element(old: Element) -> Element:
        ends = tuple(
            (R @ s + shift, R @ C) if body < 0 else (s, C)
            for body, s, C in zip((old.a, old.b), old.s, old.C, strict=True)
        )
        return replace(old, s=(ends[0][0], ends[1][0]), C=(ends[0][1], ends[1][1]))

    joints, forces = (tuple(map(element, elements)) for elements in (mechanism.joints, mechanism.forces))
    return replace(mechanism, gravity=R @ mechanism.gravity, bodies=bodies, joints=joints, forces=forces)


def quaternion_product(a: Floats, b: Floats) -> Floats:
    scalar = a[0] * b[0] - a[1:] @ b[1:]
    return np.concatenate([[scalar], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])


# A joint's translations have one penalty, and its rotations one: equations along turned axes are as stiff.
@examples(30)
@given(mechanism=mechanisms(), seed=st.integers(0, 2**32 - 1))
def test_turning_and_shifting_everything_turns_the_accelerations(mechanism: Mechanism, seed: int) -> None:
    maker = Maker(seed)
    p = maker.orientation()
    R = lw.rotation.matrix(p)

    def described(old: Motion) -> Motion:
        return replace(old, linear=old.linear @ R.T, force=old.force @ R.T, torque=old.torque @ R.T)

    assert_same(mechanism, moved(mechanism, p, maker.vector(10.0)), described, SAME_EQUATIONS)


# --- numbering ----------------------------------------------------------------------------------------------


def renumbered(mechanism: Mechanism, bodies: list[int], joints: list[int]) -> Mechanism:
    """`bodies` and `joints` are the old indices in the new order; forces are turned around."""
    place = {old: new for new, old in enumerate(bodies)} | {-1: -1}

    def element(old: Element) -> Element:
        return replace(old, a=place[old.a], b=place[old.b])

    return replace(
        mechanism,
        bodies=tuple(mechanism.bodies[k] for k in bodies),
        joints=tuple(element(mechanism.joints[k]) for k in joints),
        forces=tuple(element(force) for force in reversed(mechanism.forces)),
    )


@examples(30)
@given(data=st.data(), mechanism=mechanisms())
def test_numbering_does_not_matter(data: Any, mechanism: Mechanism) -> None:
    bodies = data.draw(st.permutations(range(len(mechanism.bodies))))
    joints = data.draw(st.permutations(range(len(mechanism.joints))))

    def described(old: Motion) -> Motion:
        return replace(
            old,
            linear=old.linear[bodies],
            angular=old.angular[bodies],
            force=old.force[joints],
            torque=old.torque[joints],
        )

    assert_same(mechanism, renumbered(mechanism, bodies, joints), described, SAME_EQUATIONS)


# --- the two bodies of a joint ------------------------------------------------------------------------------


def swapped(mechanism: Mechanism) -> Mechanism:
    def turn_around(old: Element) -> Element:
        return replace(old, a=old.b, b=old.a, s=old.s[::-1], C=old.C[::-1])

    return replace(mechanism, joints=tuple(map(turn_around, mechanism.joints)))


def points_of(mechanism: Mechanism, end: int) -> Floats:
    """The joints' points on their first (0) or second (1) bodies, in space."""
    points = []
    for joint in mechanism.joints:
        k = (joint.a, joint.b)[end]
        body = mechanism.bodies[k]
        points.append(joint.s[end] if k < 0 else body.r + lw.rotation.matrix(body.p) @ joint.s[end])
    return np.array(points).reshape(-1, 3)


# What acts on the first body is the opposite, and about the point there: T_a = -(T_b + (P_b - P_a) x F_b).
@examples(30)
@given(mechanism=mechanisms(kinds=sorted(name for name, kind in JOINTS.items() if kind.symmetric)))
def test_swapping_the_bodies_of_a_joint_reverses_its_reaction(mechanism: Mechanism) -> None:
    arms = points_of(mechanism, 1) - points_of(mechanism, 0)

    def described(old: Motion) -> Motion:
        return replace(old, force=-old.force, torque=-(old.torque + np.cross(arms, old.force)))

    assert_same(mechanism, swapped(mechanism), described, OTHER_EQUATIONS)


# --- units --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Units:
    """How many of them are in 1 kg, 1 m and 1 s; radians stay."""

    kg: float
    m: float
    s: float

    def of(self, kg: float, m: float, s: float) -> float:
        """The factor of a quantity with these powers in its unit."""
        return float(self.kg**kg * self.m**m * self.s**s)


UNITS = {
    "g mm s": Units(1e3, 1e3, 1.0),
    "kg mm ms": Units(1.0, 1e3, 1e3),
    "mg km min": Units(1e6, 1e-3, 1 / 60),
    "t um us": Units(1e-3, 1e6, 1e6),
}

#: Powers of kg, m and s.
POWERS = {"kg": (1, 0, 0), "m": (0, 1, 0), "s": (0, 0, 1), "N": (1, 1, -2), "rad": (0, 0, 0)}


def factor(units: Units, unit: str, given: dict[str, Any]) -> float:
    """Of a quantity in "N s/m^2"; a power may be another of the parameters that are `given`."""
    powers = np.zeros(3)
    for sign, part in zip((1, -1), unit.split("/"), strict=False):
        for name, _, power in (word.partition("^") for word in part.split()):
            powers += sign * float(given.get(power, power or 1)) * np.array(POWERS[name])
    return units.of(*powers)


def times(value: Any, by: float, second: float) -> Any:
    """A number or a function of time, multiplied; of a time that is counted in other units."""
    if isinstance(value, lw.functions.Harmonic):
        return replace(
            value,
            amplitude=by * value.amplitude,
            offset=by * value.offset,
            frequency=value.frequency / second,
        )
    if isinstance(value, lw.functions.Polynomial):
        return lw.functions.polynomial(*(by * c / second**k for k, c in enumerate(value.coefficients)))
    return by * value


def in_units(mechanism: Mechanism, units: Units) -> Mechanism:
    kg, m, s = units.kg, units.m, units.s
    bodies = tuple(
        replace(
            body, mass=kg * body.mass, inertia=kg * m**2 * body.inertia, r=m * body.r,
            r_dot=m / s * body.r_dot, omega=body.omega / s,
        )
        for body in mechanism.bodies
    )  # fmt: skip

    def element(old: Element, parameters: dict[str, Any]) -> Element:
        given = dict(zip(parameters, old.parameters, strict=True))
        values = tuple(times(x, factor(units, parameters[it].unit, given), s) for it, x in given.items())
        return replace(old, s=(m * old.s[0], m * old.s[1]), parameters=values)

    joints = tuple(element(joint, JOINTS[joint.kind].parameters) for joint in mechanism.joints)
    forces = tuple(element(force, FORCES[force.kind].parameters) for force in mechanism.forces)
    gravity = units.of(0, 1, -2) * mechanism.gravity
    return replace(mechanism, gravity=gravity, bodies=bodies, joints=joints, forces=forces)


# Drivers and forces that vary in time are in other units, too: what they do enters Phi_t, gamma and g.
@pytest.mark.parametrize("units", UNITS)
@examples(16)
@given(mechanism=mechanisms())
def test_units_do_not_matter(mechanism: Mechanism, units: str) -> None:
    """The penalty of each equation is scaled to its inertia."""
    to = UNITS[units]
    linear, force, torque = to.of(0, 1, -2), to.of(1, 1, -2), to.of(1, 2, -2)

    def described(old: Motion) -> Motion:
        return replace(
            old, linear=linear * old.linear, angular=old.angular / to.s**2, force=force * old.force,
            torque=torque * old.torque, free_linear=linear * old.free_linear, meter=to.m,
        )  # fmt: skip

    assert_same(mechanism, in_units(mechanism, to), described, SAME_EQUATIONS)
