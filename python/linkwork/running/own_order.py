"""States of a run that another model begins with, in its own order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.arguments import array
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.motion.records import Snapshot
from linkwork.motion.state_names import StateNames

__all__ = ["in_own_order"]


def in_own_order(model: _core.Model, dynamics: _core.Dynamics, start: Snapshot) -> Snapshot:
    """The state with bodies and history variables in the order of the model, by their names.

    OptionError: the model has others, or the names are not those of a state. A state without names, or not of
    so many bodies, stays as it is.
    """
    if start.names is None:
        return start
    own, given, n = StateNames.of(model, dynamics), start.names, model.body_count
    fits = n == _size(start, "q") / 7 == _size(start, "v") / 6
    if not isinstance(given, StateNames) or (fits and len(given.bodies) != n):
        message = (
            f"start: names {given!r:.80} are not those of a state of {n} bodies: StateNames, or None for the "
            "order of the model"
        )
        raise OptionError(message, code="start")
    if fits:
        bodies = _order("body", given.bodies, own.bodies)
        start = start if bodies is None else _of_bodies(start, bodies)
    if len(given.history) == _size(start, "history") > 0:
        variables = _order("history", given.history, own.history)
        start = start if variables is None else start._replace(history=_rows(start.history, variables))
        given = own
    return start._replace(names=StateNames(own.bodies, given.history))


def _size(start: Snapshot, name: str) -> int:
    """OptionError: it is no array."""
    return array(getattr(start, name), f"start: {name}").size


def _order(what: str, given: Sequence[str], own: Sequence[str]) -> list[int] | None:
    """Places of the model's own among the given; None: in its order. OptionError: it has others."""
    if given == own:
        return None
    places: dict[str, list[int]] = {}
    for place, name in enumerate(given):
        places.setdefault(name, []).append(place)
    found = [places[name].pop(0) for name in own if places.get(name)]
    if len(found) == len(own) == len(given):
        return found
    without = next((name for name in own if name not in places), None)
    left = next((name for name, rest in places.items() if rest), None)
    raise OptionError(_refused(what, without, left), code="start")


def _refused(what: str, without: str | None, left: str | None) -> str:
    """`without`: one of the model's that the state has not; `left`: one of the state's."""
    own = "body '{}'" if what == "body" else "history variable of {}"
    said = [
        "" if without is None else f"says nothing of the {own.format(without)} of the model",
        "" if left is None else f"has the {own.format(left)}, which the model has not",
    ]
    or_anew = "" if what == "body" else "let what was counted begin anew (start._replace(history=())), or "
    return (
        f"start: the state {', and '.join(filter(None, said))}: start from a run of the same model, {or_anew}"
        "take all in the order of the model, whatever the names (start._replace(names=None))"
    )


def _of_bodies(start: Snapshot, order: list[int]) -> Snapshot:
    split = 7 * len(order)

    def moved(y: Any) -> Floats:
        y = np.ravel(y)
        return np.concatenate([_rows(y[:split].reshape(-1, 7), order).ravel(),
                               _rows(y[split:].reshape(-1, 6), order).ravel()])  # fmt: skip

    q, v = np.reshape(start.q, (-1, 7)), np.reshape(start.v, (-1, 6))
    happened = [(label, moved(y)) for label, y in start.happened]
    return start._replace(q=_rows(q, order), v=_rows(v, order), happened=happened)


def _rows(values: Any, order: list[int]) -> Floats:
    return np.asarray(np.asarray(values)[order])
