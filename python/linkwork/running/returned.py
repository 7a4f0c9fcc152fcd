"""What functions of the user's return at the end of a run: the next one tells by that what they remember.

A run that goes on must find them as they were; one that begins anew must not find what the last one left.
"""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Hashable, Sequence, Set
from types import CodeType, FunctionType, MethodType
from typing import Any, NamedTuple

import numpy as np

from linkwork.arrays import Floats
from linkwork.functions.calls import ROW, Call, Calls
from linkwork.functions.compiled_law import CompiledLaw
from linkwork.running.kept import Kept
from linkwork.running.recall import TOLERANCE

__all__ = ["Differing", "differing", "left_by_a_run", "look_for_hidden", "note_left", "text_of"]

Functions = Sequence[tuple[str, Calls]]

#: Calls of each function that are kept, and numbers in all of them.
CALLS, NUMBERS = 6, 20_000


class _Left(NamedTuple):
    """Calls that return something else at the end of a run than at its beginning.

    UNKNOWN where that cannot be known: to call the function would leave a trace in what it remembers.
    """

    calls: list[Call]
    end: list[Floats | None]


UNKNOWN = _Left([], [])

#: Of a function that nobody could look into although all that it reaches is known.
HIDDEN = _Left([], [])

#: By code what runs left that have left something: the last one of each name and of what it reaches, of which
#: there may be several with the same code. So many of each code.
_left: dict[CodeType, dict[tuple[str, Set[Hashable]], _Left]] = {}
LEFT = 100


class Differing(NamedTuple):
    """Names of functions that return something else than then, and of those of which that is not known."""

    names: list[str]
    unknown: list[str]


def text_of(functions: Functions) -> str:
    """For `differing`."""
    listed: list[Any] = []
    left, asked, kept = NUMBERS, list[list[Call]](), _kept(functions)
    unknown = unknown_of(functions, kept)
    for place, (name, calls) in enumerate(functions):
        asked.append([])
        if name in unknown:
            listed += [[place, None, None]] if calls.differs is not False else []
            continue
        for call in calls.some(CALLS):
            left -= sum(np.size(it) for it in call.given)
            asked[-1] += [call] if left >= 0 else []
    with kept:
        answers = _answers(functions, asked, kept)
    for place, of in enumerate(asked):
        for call, now in zip(of, answers[place], strict=True):
            if now is not None:
                listed.append([place, [np.asarray(it).tolist() for it in call.given], now.tolist()])
    return json.dumps(listed)


def differing(functions: Functions, text: str) -> Differing:
    """Than when the text was made."""
    unknown: dict[str, None] = {}
    asked: list[list[Call]] = [[] for _ in functions]
    for place, given, returned in json.loads(text or "[]"):
        if given is None:
            unknown[functions[place][0]] = None
        else:
            arguments = tuple(it if isinstance(it, float) else np.array(it) for it in given)
            asked[place].append(Call(arguments, np.array(returned)))
    with _kept(functions) as kept:
        answers = _answers(functions, asked, kept)
    found = [
        name
        for (name, _), of, now in zip(functions, asked, answers, strict=True)
        if not all(map(_same, now, [call.returned for call in of]))
    ]
    return Differing(list(dict.fromkeys(found)), list(unknown))


def note_left(functions: Functions, began: Kept | None) -> None:
    """At the end of a run that `began` with what they reach, for `left_by_a_run`.

    Where a function returns something else than in its first calls although all that it reaches is given
    back, it remembers in a place that nobody knows: what it returned then is what the run began with.
    """
    with _kept(functions) as kept:
        unknown = unknown_of(functions, kept)
        known = [(name, calls) for name, calls in functions if name not in unknown]
        asked = [[*calls.first, *calls.some(CALLS)] for _, calls in known]
        end = _answers(known, asked, kept)
        then: list[list[Floats | None]] = [[call.returned for call in of] for of in asked]
        written = set[Hashable]()
        if began is not None:
            kept.put_back()
            written = {key for key, _ in began.changed()}
            with began.as_then():
                look_for_hidden(functions)
                answers = _answers(known, asked, began)
            then = [of[: len(calls.first)] if calls.hidden else it
                    for (_, calls), of, it in zip(known, then, answers, strict=True)]  # fmt: skip
    for (name, calls), *of_it in zip(known, asked, end, then, strict=True):
        apart = [(call, now) for call, now, at_first in zip(*of_it, strict=False) if not _same(now, at_first)]
        if calls.hidden and calls.by_itself:
            _note(calls, name, set(), HIDDEN)
        elif apart:
            _note(calls, name, written, _Left([it for it, _ in apart], [now for _, now in apart]))
    for name, calls in functions:
        if name in unknown and calls.differs:
            _note(calls, name, written, UNKNOWN)


def look_for_hidden(functions: Functions) -> None:
    """Makes the first calls of all of them once more, in their order; their memory is as it was then."""
    enough = [calls.first[-1].number for _, calls in functions if len(calls.first) >= ROW]
    last = min(enough, default=math.inf)  # after it calls are left out
    # Those of compiled laws are none of the run.
    seen = [calls for _, calls in functions if not isinstance(calls.function, CompiledLaw)]
    first = [(call, calls) for calls in seen for call in calls.first if call.number <= last]
    for call, calls in sorted(first, key=lambda it: it[0].number):
        calls.hidden = not _same(calls.again(call), call.returned) or calls.hidden


def _answers(functions: Functions, asked: list[list[Call]], memory: Kept) -> list[list[Floats | None]]:
    """What they return, each call where the memory is what it was, whatever the others make of it."""
    found: list[list[Floats | None]] = [[] for _ in functions]
    for k in range(max(map(len, asked), default=0)):
        memory.put_back()
        for (_, calls), of, answers in zip(functions, asked, found, strict=True):
            if k < len(of):
                answers.append(calls.again(of[k]))
    return found


def _note(calls: Calls, name: str, written: Set[Hashable], left: _Left) -> None:
    if (code := _code(calls.function)) is None:
        return
    reached = frozenset(Kept([calls.function]).keys)
    of_code = _left.setdefault(code, {})
    key = name, (reached & written) or reached
    of_code.pop(key, None)
    of_code[key] = left
    if len(of_code) > LEFT:
        del of_code[next(iter(of_code))]


def left_by_a_run(functions: Functions) -> Differing:
    """Those that return what the last run left of those that reach the same, and not what that began with."""
    left = [(name, calls, it) for name, calls in functions for it in _left_of(calls)]
    asked = [it for it in left if it[2].calls]
    functions = [(name, calls) for name, calls, _ in asked]
    with _kept(functions) as kept:
        answers = _answers(functions, [it.calls for *_, it in asked], kept)
    found = [name for (name, _, it), now in zip(asked, answers, strict=True) if all(map(_same, now, it.end))]
    unread = [(name, calls) for name, calls, it in left if it is UNKNOWN]
    unknown = [*unknown_of(unread, _kept(unread)), *(name for name, _, it in left if it is HIDDEN)]
    return Differing(list(dict.fromkeys(found)), list(dict.fromkeys(unknown)))


def _left_of(calls: Calls) -> list[_Left]:
    """What was noted of its code and something that it reaches."""
    of_code = _left.get(code, {}) if (code := _code(calls.function)) is not None else {}
    reached = Kept([calls.function]).keys if of_code else set()
    return [left for (_, places), left in of_code.items() if not (places and places.isdisjoint(reached))]


def unknown_of(functions: Functions, kept: Kept) -> list[str]:
    """Those that reach what cannot be looked into; `kept` of them all."""
    return [] if kept.whole else [name for name, calls in functions if not Kept([calls.function]).whole]


def _kept(functions: Functions) -> Kept:
    return Kept(calls.function for _, calls in functions)


def _same(first: Floats | None, second: Floats | None) -> bool:
    if first is None or second is None or first.shape != second.shape:
        return False
    return bool((np.abs(first - second) <= TOLERANCE * np.max(np.abs(second), initial=0.0)).all())


def _code(function: Any) -> CodeType | None:
    if isinstance(function, functools.partial):
        return _code(function.func)
    if isinstance(function, MethodType):
        return _code(function.__func__)
    if isinstance(function, FunctionType):
        return function.__code__
    called = vars(type(function)).get("__call__")
    return called.__code__ if isinstance(called, FunctionType) else None
