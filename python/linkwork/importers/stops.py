"""Limits of joints as end stops: stiff springs beyond the ends, which take the energy of an impact."""

from __future__ import annotations

from collections.abc import Collection
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


class Stops:
    """Adds them to a model that has all bodies of a description."""

    def __init__(self, description: Description, model: Model) -> None:
        self._description, self._model = description, model
        self._tree = spanning_tree(description)
        self._behind: dict[str, list[str]] = {}  #: each link those that are placed from it
        for link, joint in self._tree.items():
            if joint is not None:
                self._behind.setdefault(joint.other(link), []).append(link)

    def carried(self, joint: JointDescription) -> set[str]:
        """The links that move when a joint moves alone, on its side away from the ground."""
        far = joint.parent if self._tree[joint.parent] is joint else joint.child
        near = joint.other(far)  # around a closed loop one comes to it
        found, stack = {near, far}, [far]
        while stack:
            behind = [link for link in self._behind.get(stack.pop(), []) if link not in found]
            found.update(behind)
            stack += behind
        return found - {near}

    def add(
        self,
        joint: JointDescription,
        pair: tuple[Body, Body],
        place: dict[str, Any],
        carried: Collection[Body],
        start: float,
        zero: float,
    ) -> None:
        """`place` as of the methods of Model, in body coordinates; `carried`: bodies.

        `start` and `zero`: the joint's coordinate at t = 0, and where that of `place` is zero.
        """
        assert joint.stops is not None
        turning, name = joint.kind == "revolute", f"joint '{joint.name}'"
        lower, upper = joint.stops
        inertia = self._inertia(pair[1], place["at"][1], place["axis"][1], turning, carried)
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

    # J = sum a^T A J_k A^T a + m |a x (r - p)|^2 about the axis a through the point p; along it the mass
    def _inertia(
        self, body: Body, at: Floats, axis: Floats, turning: bool, carried: Collection[Body]
    ) -> float:
        """What moves with the joint, at t = 0 [kg m2] or [kg]."""
        core, which = self._model.compiled(), np.array([it.index for it in carried], int)
        mass = core.mass[which]
        if not turning:
            return float(mass.sum())
        q = core.poses(np.array([body.index, *which], np.int32))
        A = rotation.matrix(q[:, 3:])
        p, a = q[0, :3] + A[0] @ at, A[0] @ axis
        arms = np.cross(a, q[1:, :3] - p)
        own = np.einsum("kji,j->ki", A[1:], a)  # in the axes of each body
        return float(np.einsum("ki,kij,kj->", own, core.inertia[which], own) + mass @ (arms**2).sum(axis=1))
