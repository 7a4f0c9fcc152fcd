"""What functions of the user's return at the end of a run: the next one tells by that what they remember.

A run that goes on must find them as they were; one that begins anew must not find what the last one left.
"""

from __future__ import annotations

import functools
import json
from collections.abc import Sequence
from types import CodeType, FunctionType, MethodType
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.functions.calls import Call, Calls
from linkwork.running.kept import Kept
from linkwork.running.recall import TOLERANCE

__all__ = ["differing", "left_by_a_run", "note_left", "text_of"]

Functions = Sequence[tuple[str, Calls]]

#: Calls of each function that are kept, and numbers in all of them.
CALLS, NUMBERS = 6, 20_000

#: By code and name the first calls of the last run, where they would have returned something else at its end,
#: and that.
_left: dict[tuple[CodeType, str], tuple[list[Call], list[Floats | None]]] = {}
LEFT = 1000


def text_of(functions: Functions) -> str:
    """For `differing`; of no function where that cannot be known without a trace in what they remember."""
    listed, left = [], NUMBERS
    with Kept(calls.function for _, calls in functions) as kept:
        for place, (_, calls) in enumerate(functions if kept.whole else ()):
            for call in calls.some(CALLS):
                left -= sum(np.size(it) for it in call.given)
                now = calls.again(call) if left >= 0 else None
                if now is not None:
                    listed.append([place, [np.asarray(it).tolist() for it in call.given], now.tolist()])
    return json.dumps(listed)


def differing(functions: Functions, text: str) -> list[str]:
    """Names of those that return something else than when the text was made."""
    found: dict[str, None] = {}
    with Kept(calls.function for _, calls in functions):
        for place, given, returned in json.loads(text or "[]"):
            name, calls = functions[place]
            arguments = tuple(it if isinstance(it, float) else np.array(it) for it in given)
            if not _same(calls.again(Call(arguments, np.empty(0))), np.array(returned)):
                found[name] = None
    return list(found)


def note_left(functions: Functions) -> None:
    """At the end of a run, for `left_by_a_run`."""
    with Kept(calls.function for _, calls in functions) as kept:
        for name, calls in functions if kept.whole else ():
            if (code := _code(calls.function)) is None:
                continue
            _left.pop((code, name), None)
            now = [calls.again(call) for call in calls.first]
            if not all(map(_same, now, [call.returned for call in calls.first])):
                _left[code, name] = calls.first, now
    while len(_left) > LEFT:
        del _left[next(iter(_left))]


def left_by_a_run(functions: Functions) -> list[str]:
    """Names of those that return what the last run left, and not what that began with."""
    known = [(name, calls, _code(calls.function)) for name, calls in functions]
    left = [
        (name, calls, *_left[code, name]) for name, calls, code in known if code and (code, name) in _left
    ]
    with Kept(calls.function for _, calls, *_ in left):
        return [name for name, calls, first, then in left if all(map(_same, map(calls.again, first), then))]


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
