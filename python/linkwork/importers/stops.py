"""Limits of joints as end stops: stiff springs beyond the ends, which take the energy of an impact."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.importers.description import Description, JointDescription
from linkwork.importers.tree import spanning_tree
from linkwork.modeling.handles import Body
from linkwork.modeling.model import Model

__all__ = ["Stops"]

#: What a joint carries swings against its stop at this frequency [rad/s]: an arm that arrives with 1 rad/s
#: goes no more than 0.01 rad beyond, and steps of a millisecond resolve it.
FREQUENCY = 100.0

#: Damping by depth over stiffness [s/rad], [s/m]. Of Hunt and Crossley (1975), c = 3 k (1 - e) / (2 v): less
#: than half of the speed is left of an impact with 1 rad/s or 1 m/s.
DAMPING = 1.5


@dataclass(frozen=True)
class _Lump:
    """Bodies as one that is rigid, at t = 0."""

    mass: float = 0.0
    center: Floats = field(default_factory=lambda: np.zeros(3))
    inertia: Floats = field(default_factory=lambda: np.zeros((3, 3)))  #: about the center, inertial axes

    # c = (m_1 c_1 + m_2 c_2) / m,  J = J_1 + J_2 + (m_1 m_2 / m) (d.d I - d d^T),  d = c_2 - c_1
    def __add__(self, other: _Lump) -> _Lump:
        mass = self.mass + other.mass
        share = other.mass / mass if mass else 0.0
        d = other.center - self.center
        steiner = self.mass * share * (d @ d * np.eye(3) - np.outer(d, d))
        return _Lump(mass, self.center + share * d, self.inertia + other.inertia + steiner)

    def about(self, point: Floats, axis: Floats) -> float:
        """J = a^T J_c a + m |a x (c - p)|^2 about the axis a through the point p."""
        arm = np.cross(axis, self.center - point)
        return float(axis @ self.inertia @ axis + self.mass * (arm @ arm))


class Stops:
    """Adds them to a model that has all bodies of a description. `body_of`: of a link; None: the ground."""

    def __init__(self, description: Description, model: Model, body_of: Callable[[str], Body | None]) -> None:
        self._description, self._model, self._body_of = description, model, body_of
        self._tree = spanning_tree(description)

    @cached_property
    def _own(self) -> dict[str, _Lump]:
        """Of each link; of several that are one body, the first in the tree has it."""
        core = self._model.compiled()
        first: dict[int, str] = {}
        for link in self._tree:
            if (body := self._body_of(link)) is not None:
                first.setdefault(body.index, link)
        which = np.array(list(first), np.int32)
        q, mass = core.poses(which), core.mass[which].tolist()
        A = rotation.matrix(q[:, 3:])
        inertia = A @ core.inertia[which] @ A.transpose(0, 2, 1)
        lumps = map(_Lump, mass, q[:, :3], inertia)
        return dict.fromkeys(self._tree, _Lump()) | dict(zip(first.values(), lumps, strict=True))

    @cached_property
    def _with_behind(self) -> dict[str, _Lump]:
        """Of each link, with all that is placed from it."""
        found = dict(self._own)
        for link, joint in reversed(self._tree.items()):  # which has those behind a link after it
            if joint is not None:
                found[joint.other(link)] += found[link]
        return found

    def _carried(self, joint: JointDescription) -> _Lump:
        """What moves when a joint moves alone, on its side away from the ground."""
        for link in (joint.parent, joint.child):
            if self._tree[link] is joint:
                return self._with_behind[link]
        far, near = self._first(joint.child), self._first(joint.parent)  # it closes a loop
        way = [near]
        while (carrier := self._tree[way[-1]]) is not None:
            way.append(carrier.other(way[-1]))
        return self._with_behind[near if far in way or self._body_of(far) is None else far]

    def _first(self, link: str) -> str:
        """Of the links that are rigid with one, that from which they are placed."""
        while (joint := self._tree[link]) is not None and joint.kind == "fixed":
            link = joint.other(link)
        return link

    def add(
        self,
        joint: JointDescription,
        pair: tuple[Body, Body],
        place: dict[str, Any],
        start: float,
        zero: float,
    ) -> None:
        """`place` as of the methods of Model, in body coordinates.

        `start` and `zero`: the joint's coordinate at t = 0, and where that of `place` is zero.
        """
        assert joint.stops is not None
        turning, name = joint.kind == "revolute", f"joint '{joint.name}'"
        lower, upper = joint.stops
        carried = self._carried(joint)
        inertia = carried.about(*self._axis(pair[1], place)) if turning else carried.mass
        ends = f"{joint.stops[0]:g} to {joint.stops[1]:g} {'rad' if turning else 'm'}"
        if inertia <= 0:
            self._description.note(
                "limits", name, f"limits {ends} are not represented: it carries no inertia"
            )
            return
        k, c = FREQUENCY**2 * inertia, DAMPING * FREQUENCY**2 * inertia
        add = self._model.rotational_stop if turning else self._model.translational_stop
        add(*pair, **place, lower=lower - zero, upper=upper - zero, stiffness=k, damping=c,
            name=f"{joint.name} stop")  # fmt: skip
        beyond = max(lower - start, start - upper)
        late = f"; it starts {beyond:.3g} beyond: give `coordinates`" if beyond > 0 else ""
        text = f"limits {ends} are stops of {k:.3g} N{' m/rad' if turning else '/m'}{late}"
        self._description.note("limits", name, text)

    def _axis(self, body: Body, place: Mapping[str, Any]) -> tuple[Floats, Floats]:
        """A point and the direction of an axis that is given in a body, at t = 0."""
        q = self._model.compiled().poses(np.array([body.index], np.int32))[0]
        A = rotation.matrix(q[3:])
        return q[:3] + A @ place["at"][1], A @ place["axis"][1]
