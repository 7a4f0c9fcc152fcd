"""Whose the numbers of a state are, by which a model with another order of bodies and elements takes them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

from linkwork.motion.names import Names

if TYPE_CHECKING:
    from linkwork import _core

__all__ = ["StateNames", "force_kind_names", "history_names"]


class StateNames(NamedTuple):
    """Of a Snapshot, in its order."""

    bodies: Sequence[str]  #: (n,)
    history: Sequence[str]  #: (h,) the elements of its variables, in words; none: in the order of the model

    @classmethod
    def of(cls, model: _core.Model, dynamics: _core.Dynamics) -> StateNames:
        """Those of states of a model."""
        return cls(Names(model.body_name, model.body_count), history_names(model, dynamics))


def history_names(model: _core.Model, dynamics: _core.Dynamics) -> Sequence[str]:
    """Elements of history variables (h,), such as "rotational_stop 'knee' between 'thigh' and 'shank'"."""
    owners = dynamics.history_owners
    if not len(owners):
        return ()
    joints, forces = model.joint_arrays()["bodies"], model.force_arrays()
    kinds, laws, of_laws = forces["kind"], model.joint_forces, model.joint_force_bodies

    def name(variable: int) -> str:
        of_joint, element = map(int, owners[variable])
        if of_joint:
            own, ends = f"{model.joint_kind(element)} '{model.joint_name(element)}'", joints[element]
        elif element < len(kinds):
            kind = force_kind_names()[kinds[element]]
            own, ends = f"{kind} '{model.force_name(element)}'", forces["bodies"][element]
        else:
            law, coordinate = laws[element - len(kinds)]
            own, ends = f"law of the {coordinate} '{law}'", of_laws[element - len(kinds)]
        a, b = ("ground" if body < 0 else model.body_name(int(body)) for body in ends)
        return f"{own} between '{a}' and '{b}'"

    return Names(name, len(owners))


@cache
def force_kind_names() -> list[str]:
    """By the number of the kind."""
    from linkwork import _core

    return [kind.name for kind in _core.force_kinds()]
