"""Whether the laws of force elements say what they said in a run: `Result.force` asks them again after it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from linkwork.functions.calls import Call, Calls
from linkwork.modeling.elements import KINDS
from linkwork.modeling.model import Model
from linkwork.running.kept import Kept
from linkwork.running.recall import MOST, unlike_then

__all__ = ["LawsOfForces"]

#: Calls of a step and of its dense output, more than there are in one of any method.
SOON = 24

#: By force element, of each parameter that is a function: those of the user's own in it.
Functions = Mapping[int, Mapping[str, Sequence[Calls]]]


class LawsOfForces:
    """Made where a run ends, before steps of it are taken again: with the calls that are kept of it."""

    def __init__(self, model: Model) -> None:
        self._functions, self._name = _functions(model), model.compiled().force_name
        of_time = {id(calls) for _, function in model.signals for calls in function.calls}
        self._then: dict[int, Sequence[Call]] = {
            id(it): _not_taken_back(it.some(MOST)) if id(it) in of_time else it.some(MOST)
            for of in self._functions.values()
            for its in of.values()
            for it in its
        }

    def __call__(self, element: int, model: Model | None = None) -> str:
        """How one of its calls shows that a force element says something else now; "": none does.

        model  another one with the same laws, which is asked instead
        """
        of_run = self._functions.get(element, {})
        now = of_run if model is None else _functions(model).get(element, {})
        with Kept(calls.function for its in now.values() for calls in its):
            found = [
                unlike_then(what, calls, self._then[id(then)])
                for what, its in of_run.items()
                for then, calls in zip(its, now.get(what, ()), strict=False)
            ]
        return next(filter(None, found), "")

    def statistics(self) -> dict[str, list[str]]:
        """For a file, which has no laws: elements that say something else at the end of the run than in it.

        Where there is a verdict, which has looked for functions that do so.
        """
        changed = [
            self._name(element)
            for element, of in self._functions.items()
            if any(calls.differs for its in of.values() for calls in its) and self(element)
        ]
        return {"changed_laws": changed} if changed else {}


def _not_taken_back(calls: Sequence[Call]) -> list[Call]:
    """Functions of time: after steps that were refused, or cut where an event came, earlier times come."""
    times = [float(call.given[0]) for call in calls]
    return [call for k, call in enumerate(calls) if times[k] <= min(times[k : k + SOON])]


def _functions(model: Model) -> Functions:
    arrays, kinds = model.compiled().force_arrays(), list(KINDS["force"].values())
    first, signals = arrays["first_parameter"], arrays["signals"]
    found: dict[int, dict[str, Sequence[Calls]]] = {}
    for place in np.flatnonzero(signals >= 0).tolist():
        if calls := model._functions[int(signals[place])].calls:
            element = int(np.searchsorted(first, place, side="right")) - 1
            what = list(kinds[arrays["kind"][element]].parameters)[place - int(first[element])]
            found.setdefault(element, {})[what] = calls
    return found
