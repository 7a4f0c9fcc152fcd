"""Whether functions of the user's own remember: whether the same arguments give another value.

A run keeps some of the calls that it makes, see linkwork.functions.calls. They are made again when it is
over, all functions in turn, backward in time and forward. A function that returns what it returned in the run
may keep a log, count, or use a buffer: its steps can be taken again. Of others the calls before make a
difference, or what an event has changed meanwhile, as the effort that a controller holds: then both orders
give the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from linkwork.arrays import Floats
from linkwork.functions.calls import Call, Calls
from linkwork.running.kept import Kept

__all__ = ["NOTHING", "Recall", "call_again"]

#: Of the largest value of a function: what differs by less does so by the tolerance of an iteration inside.
TOLERANCE = 1e-7

#: Calls that are made again, of all functions.
MOST = 4096


class Recall(NamedTuple):
    """Of which functions calls differ from those of the run."""

    differ: tuple[str, ...] = ()
    remember: tuple[str, ...] = ()  #: of these the calls before make the difference
    example: str = ""


NOTHING = Recall()


class _Seen(NamedTuple):
    """A call of the run, and what was returned later; None: it failed."""

    function: int
    call: Call
    backward: Floats | None
    forward: Floats | None

    def apart(self) -> float:
        return max(_apart(self.call.returned, now) for now in (self.backward, self.forward))


def call_again(functions: Sequence[tuple[str, Calls]], others: Sequence[Any] = ()) -> Recall:
    """What they return now. `others`: functions that may rightly change what these read, such as events'."""
    seen, reached = _calls(functions), Kept(others)
    differ: dict[str, str] = {}
    remember = []
    for k, (name, calls) in enumerate(functions):
        own = [it for it in seen if it.function == k]
        size = max((float(np.max(np.abs(it.call.returned), initial=0.0)) for it in own), default=0.0)
        worst = max(own, key=_Seen.apart, default=None)
        if worst is None or worst.apart() <= TOLERANCE * size:
            continue
        differ[name] = _told(name, worst)
        by_order = max(_apart(it.backward, it.forward) for it in own) > TOLERANCE * size
        if by_order or not others or not Kept([calls.function]).shares(reached):
            remember.append(name)
    example = differ[remember[0] if remember else next(iter(differ))] if differ else ""
    return Recall(tuple(differ), tuple(dict.fromkeys(remember)), example)


def _calls(functions: Sequence[tuple[str, Calls]]) -> list[_Seen]:
    of_each = MOST // max(1, len(functions))
    kept = [(k, call) for k, (_, calls) in enumerate(functions) for call in calls.some(of_each)]
    kept.sort(key=lambda it: _time(it[1]))
    backward = [functions[k][1].again(call) for k, call in reversed(kept)][::-1]
    forward = [functions[k][1].again(call) for k, call in kept]
    return [_Seen(*known, *now) for known, *now in zip(kept, backward, forward, strict=True)]


def _time(call: Call) -> float:
    return float(np.ravel(call.given[0])[0])


def _apart(first: Floats | None, second: Floats | None) -> float:
    """Largest difference."""
    if first is None or second is None:
        return 0.0 if first is second else np.inf
    if first.shape != second.shape:
        return np.inf
    found = float(np.max(np.abs(first - second), initial=0.0))
    return found if np.isfinite(found) else np.inf


def _told(name: str, it: _Seen) -> str:
    """ "at t = 0.31 s 'controller' gave 3.2, and later -1.1 for the same arguments"."""
    then = it.call.returned
    now = max(it.backward, it.forward, key=lambda now: _apart(then, now))
    when = f"at t = {_time(it.call):.4g} s '{name}' gave"
    if now is None or now.shape != then.shape:
        return f"{when} {_shown(then)}, and nothing like it later for the same arguments"
    place = np.unravel_index(np.argmax(np.abs(then - now)), then.shape) if then.ndim else ()
    return f"{when} {then[place]:.4g}, and later {now[place]:.4g} for the same arguments"


def _shown(value: Floats) -> str:
    return f"{value:.4g}" if value.ndim == 0 else f"an array {value.shape}"
