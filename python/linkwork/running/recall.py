"""Whether functions of the user's own remember: whether the same arguments give another value.

A run keeps some of the calls that it makes, see linkwork.functions.calls. They are made again when it is
over, all functions in turn, backward and forward. A function that returns what it returned in the run
may keep a log, count, or use a buffer: its steps can be taken again. Of others the calls before make a
difference, or what an event has changed meanwhile, as the effort that a controller holds: then both orders
give the same.

One that remembers by time, as when it was tripped, returns then what it returned in the run. So what the
functions themselves have written in the run is made what it was before, and the last calls come first: where
that gives another value, they remember. What is computed once and kept is computed once more, and the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from linkwork.arrays import Floats
from linkwork.functions.calls import Call, Calls
from linkwork.running.kept import Kept, Parts
from linkwork.running.written import Written

__all__ = ["MOST", "NOTHING", "Recall", "call_again", "unlike_then"]

#: Of the largest force or value of a function: what differs by less does so by the tolerance of an iteration
#: inside; of the largest of all of them by rounding.
TOLERANCE, ROUNDING = 1e-7, 1e-14

#: Calls that are made again, of all functions.
MOST = 4096


class Recall(NamedTuple):
    """Of which functions calls differ from those of the run."""

    differ: tuple[str, ...] = ()
    remember: tuple[str, ...] = ()  #: of these the calls before make the difference
    example: str = ""


NOTHING = Recall()


class _Seen(NamedTuple):
    """A call of the run, and what was returned later; None: it failed.

    ..._anew  without what the functions have written by themselves
    """

    function: int
    call: Call
    backward: Floats | None
    forward: Floats | None
    backward_anew: Floats | None
    forward_anew: Floats | None

    def apart(self, sizes: _Sizes) -> float:
        """From what was returned in the run."""
        return max(sizes.apart(self.call.returned, self.forward), self.apart_by_itself(sizes),
                   sizes.apart(self.call.returned, self.backward))  # fmt: skip

    def apart_by_itself(self, sizes: _Sizes) -> float:
        """By what its function remembers by itself."""
        return max(sizes.apart(self.forward, now) for now in self.later)

    @property
    def later(self) -> tuple[Floats | None, ...]:
        return self.backward, self.forward, self.backward_anew, self.forward_anew


class _Sizes:
    """Of what a function returns: forces and torques of each body by themselves."""

    def __init__(self, seen: Sequence[_Seen]) -> None:
        values = [_vectors(it.call.returned) for it in seen]
        largest = max((float(np.max(it, initial=0.0)) for it in values), default=0.0)
        same = len({it.shape for it in values}) == 1
        self._usual = TOLERANCE * (np.max(values, axis=0) if same else largest) + ROUNDING * largest

    def apart(self, first: Floats | None, second: Floats | None) -> float:
        """Largest difference, of what is usual."""
        if first is None or second is None:
            return 0.0 if first is second else np.inf
        if first.shape != second.shape:
            return np.inf
        if first.tobytes() == second.tobytes():  # as a rule
            return 0.0
        largest = float(np.max(self._of_usual(_vectors(first - second)), initial=0.0))
        return largest if np.isfinite(largest) else np.inf

    def place(self, first: Floats, second: Floats) -> tuple[Any, ...]:
        """Of that difference."""
        apart = np.abs(first - second)
        of_usual = self._of_usual(_vectors(first - second))
        if of_usual.ndim:
            of_usual = np.repeat(of_usual, 3, axis=-1)
        worst = of_usual == np.max(of_usual)
        number = int(np.argmax(np.where(worst, apart, -1.0)))
        return tuple(np.unravel_index(number, apart.shape)) if apart.ndim else ()

    def _of_usual(self, apart: Floats) -> Floats:
        usual = np.broadcast_to(self._usual, apart.shape)
        found: Floats = np.divide(apart, usual, out=np.where(apart == 0, 0.0, np.inf), where=usual > 0)
        return found


def _vectors(value: Floats) -> Floats:
    """Sizes of forces and torques of bodies; of what has none, its largest."""
    size = np.abs(value)
    if value.ndim and value.shape[-1] == 6:
        return np.asarray(size.reshape(*value.shape[:-1], 2, 3).max(axis=-1))
    return np.asarray(np.max(size, initial=0.0))


def call_again(
    functions: Sequence[tuple[str, Calls]],
    others: Sequence[Any] = (),
    written: Written | None = None,
    own: Parts | None = None,
    beside: Sequence[tuple[str, Calls]] = (),
) -> Recall:
    """What they return now, and where they have not written in the run what they have.

    written  what was written in it, `own` parts of that by themselves
    others   functions that may rightly change what these read, as those with which events change something
    beside   functions that steps which are taken again do not call, as those of events
    """
    seen, reached = _calls([*functions, *beside], written, own), Kept(others)
    differ: dict[str, str] = {}
    remember: dict[str, str] = {}
    for k, (name, calls) in enumerate([*functions, *beside]):
        of_it = [it for it in seen if it.function == k]
        sizes = _Sizes(of_it)
        apart, worst = max(((it.apart(sizes), it) for it in of_it), key=_first, default=(0.0, None))
        calls.differs = apart > 1
        if worst is None or not calls.differs:
            continue
        told = _told(name, worst, sizes)
        if k < len(functions):
            differ[name] = told
        calls.by_itself = max(it.apart_by_itself(sizes) for it in of_it) > 1
        if calls.by_itself or not others or not Kept([calls.function]).shares(reached):
            calls.remembers = True
            remember[name] = told
    return Recall(tuple(differ), tuple(remember), next(iter([*remember.values(), *differ.values()]), ""))


def unlike_then(name: str, calls: Calls, then: Sequence[Call]) -> str:
    """As one of these calls of a run shows, made again: it returns something else; "": none does."""
    answers = [(call, calls.again(call)) for call in then]
    seen = [_Seen(0, call, now, now, now, now) for call, now in answers]
    sizes = _Sizes(seen)
    apart, worst = max(((it.apart(sizes), it) for it in seen), key=_first, default=(0.0, None))
    return "" if worst is None or apart <= 1 else _told(name, worst, sizes)


def _calls(functions: Sequence[tuple[str, Calls]], written: Written | None, own: Parts | None) -> list[_Seen]:
    of_each = MOST // max(1, len(functions))
    kept = [(k, call) for k, (_, calls) in enumerate(functions) for call in calls.some(of_each)]
    kept.sort(key=lambda it: it[1].number)
    now = Kept(calls.function for _, calls in functions)

    def again(places: range) -> list[Floats | None]:
        found = {k: functions[kept[k][0]][1].again(kept[k][1]) for k in places}
        return [found[k] for k in range(len(kept))]

    forwards, backwards = range(len(kept)), range(len(kept) - 1, -1, -1)
    backward, forward = again(backwards), again(forwards)
    anew = forward, forward
    if written is not None and own:
        now.put_back()
        with written.undone(own) as undo:
            backward_anew = again(backwards)
            undo()
            anew = backward_anew, again(forwards)
    return [_Seen(k, call, *later) for (k, call), *later in zip(kept, backward, forward, *anew, strict=True)]


def _first(pair: tuple[float, object]) -> float:
    return pair[0]


def _told(name: str, it: _Seen, sizes: _Sizes) -> str:
    """ "at t = 0.31 s 'controller' gave 3.2, and later -1.1 for the same arguments"."""
    then = it.call.returned
    now = max(it.later, key=lambda now: sizes.apart(then, now))
    first = float(np.ravel(it.call.given[0])[0])
    when = f"at t = {first:.4g} s" if len(it.call.given) > 1 else f"at {first:.4g}"
    when = f"{when} '{name}' gave"
    if now is None or now.shape != then.shape:
        return f"{when} {_shown(then)}, and nothing like it later for the same arguments"
    place = sizes.place(then, now)
    return f"{when} {_unlike(float(then[place]), float(now[place]))} for the same arguments"


def _unlike(then: float, now: float) -> str:
    """Both, with as many digits as it takes to tell them apart."""
    digits = next((k for k in range(4, 17) if f"{then:.{k}g}" != f"{now:.{k}g}"), 17)
    return f"{then:.{digits}g}, and later {now:.{digits}g}"


def _shown(value: Floats) -> str:
    return f"{value:.4g}" if value.ndim == 0 else f"an array {value.shape}"
