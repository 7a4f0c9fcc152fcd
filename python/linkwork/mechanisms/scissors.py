"""A structure of scissors that unfolds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.mechanisms.mechanism import Mechanism, Size, at_least
from linkwork.mechanisms.rods import thin_rod
from linkwork.modeling.handles import Body, Range
from linkwork.rotation import from_axes

#: Of a bar [m], [kg]; of its slope [rad].
LENGTH, MASS, ANGLE = 1.0, 1.0, 1.0
WIDE, HIGH = LENGTH * float(np.cos(ANGLE)), LENGTH * float(np.sin(ANGLE))

#: At which the free ends leave the hub, and the hub turns, at first [m/s], [rad/s].
SPEED, SPIN = 5.0, 0.2

#: Of the hub: its rim leaves each arm so much room [m]; mass for each arm [kg].
ROOM, HUB = 0.25, 5.0


def scissors(arms: int = 6, units: int = 10) -> Model:
    """Scissor structure that unfolds in space: arms of lazy tongs around a hub that turns.

    An arm is a row of pairs of bars of 1 m and 1 kg that cross at 2 rad, pinned to each other in the middle
    and to the next pair at their ends. Of the first pair one bar is pinned to the rim of the hub, and the end
    of the other is on a rail up the rim. The hub turns about the vertical with 0.2 rad/s, the free ends leave
    it with 5 m/s. No gravity: energy and angular momentum about the axle are conserved.

    Each arm has one freedom, however long, and the hub one. With pins everywhere three equations of every
    loop would repeat others; here lower ends meet in spherical joints and upper ones in cylindrical ones, and
    none is redundant. An arm becomes as weak as a beam of its length: the smallest singular value of its
    equations falls with the square of the pairs, and beyond some 500 of them rounding errors are felt.

    arms   around the hub
    units  pairs of bars in each, two or more

        model = lw.mechanisms.scissors(3)
    """
    at_least(1, arms, "scissors: arms")
    at_least(2, units, "scissors: units")
    model = Model(gravity=(0, 0, 0), name="scissors")
    radius = ROOM * max(4.0, arms / (2 * np.pi))
    mass = HUB * arms
    hub = model.body(
        "hub", mass=mass, inertia=mass * radius**2 * np.array([0.5, 0.5, 1.0]), omega=(0, 0, SPIN)
    )
    model.revolute(model.ground, hub, at=(0, 0, 0), axis=(0, 0, 1), name="axle")
    place = _Arms(arms, units, radius)
    turn = SPEED / (units * HIGH)  # by which the angle falls [rad/s]
    _join(model, hub, place, *(_bars(model, place, turn, sign) for sign in (1.0, -1.0)))
    return model


@dataclass(frozen=True)
class _Arms:
    """Arm by arm, all points of one before those of the next."""

    arms: int
    units: int
    radius: float

    @property
    def turned(self) -> Floats:
        """Inertial directions of an arm's outward, sideward and upward (arms, 3, 3)."""
        angle = 2 * np.pi * np.arange(self.arms) / self.arms
        axes = np.zeros((self.arms, 3, 3))
        axes[:, 0, 0] = axes[:, 1, 1] = np.cos(angle)
        axes[:, 0, 1], axes[:, 1, 0] = np.sin(angle), -np.sin(angle)
        axes[:, 2, 2] = 1.0
        return axes

    @property
    def middles(self) -> Floats:
        """Of the pairs of an arm, from the rim (units,)."""
        return np.asarray(WIDE * (np.arange(self.units) + 0.5), dtype=np.float64)

    def inertial(self, outward: Floats, upward: Floats | float) -> Floats:
        """Of one vector in each unit of an arm (k,) the same in all arms (arms k, 3)."""
        local = np.stack([outward, np.zeros(len(outward)), upward + np.zeros(len(outward))], axis=1)
        return (local[None] @ self.turned).reshape(-1, 3)

    def points(self, outward: Floats, upward: float) -> Floats:
        """Places so far from the rim."""
        return self.inertial(self.radius + outward, upward)

    def pins(self, count: int) -> Floats:
        """The axes of so many pins of each arm."""
        return np.repeat(self.turned[:, 1], count, axis=0)


def _bars(model: Model, place: _Arms, turn: float, sign: float) -> Range[Body]:
    """Those that rise outward (sign 1) or fall."""
    outward = place.middles
    position = place.points(outward, HIGH / 2)
    unfolding = place.inertial(outward / WIDE * HIGH * turn, -WIDE * turn / 2)
    along = place.inertial(np.full(place.units, WIDE), sign * HIGH)
    spin = SPIN * np.array([sign * HIGH, 0.0, WIDE]) / LENGTH  # about the vertical, in the axes of a bar
    return model.bodies(
        "rising bar" if sign > 0 else "falling bar",
        mass=MASS,
        inertia=thin_rod(MASS, LENGTH),
        position=position,
        orientation=from_axes(along, place.pins(place.units)),
        velocity=unfolding + np.cross((0.0, 0.0, SPIN), position),
        omega=spin + np.array([0.0, sign * turn, 0.0]),
    )


def _join(model: Model, hub: Body, place: _Arms, rising: Range[Body], falling: Range[Body]) -> None:
    first, inner = np.zeros(1), place.middles[1:] - WIDE / 2
    up, down = (it.indices.reshape(place.arms, place.units) for it in (rising, falling))
    pin, rail = place.points(first, 0.0), place.points(first, HIGH)
    middle = place.points(place.middles, HIGH / 2)
    model.joints("revolute", hub, up[:, 0], at=pin, axis=place.pins(1), name="pin")
    model.joints("point_on_plane", hub, down[:, 0], at=rail, axis=place.turned[:, 0], name="rail")
    model.joints("revolute", rising, falling, at=middle, axis=place.pins(place.units), name="cross")
    lower, upper = place.points(inner, 0.0), place.points(inner, HIGH)
    axis = place.pins(place.units - 1)
    model.joints("spherical", down[:, :-1].ravel(), up[:, 1:].ravel(), at=lower, name="lower end")
    ends = up[:, :-1].ravel(), down[:, 1:].ravel()
    model.joints("cylindrical", *ends, at=upper, axis=axis, name="upper end")


SCISSORS = Mechanism(scissors, size=Size("arms", lambda arms: 1 + 20 * arms), t_end=0.5, step=1e-3)
