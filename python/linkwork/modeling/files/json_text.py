"""JSON: parsed by the standard library at full speed; places in the text are looked up only for messages."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any, NoReturn

from linkwork.errors import Fault

_SPACE = re.compile(r"[ \t\n\r]*")
_TOKENS = re.compile(r'"(?:[^"\\]|\\.)*"|[\[\]{}]')

#: Levels of lists and objects in each other.
DEPTH = 64


class Malformed(Exception):
    """No JSON."""

    def __init__(self, faults: list[Fault]) -> None:
        self.faults = faults


class _Repeated(dict[str, Any]):
    """An object that has a name more than once."""

    names: list[str]


class JsonText:
    """A JSON document."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._offsets: dict[tuple[str | int, ...], dict[str | int, int]] = {}
        self._any_repeated = False
        try:
            self.data = json.loads(text, object_pairs_hook=self._object, parse_constant=_refuse_constant)
        except RecursionError:
            raise Malformed([_too_deep(text)]) from None
        except json.JSONDecodeError as error:
            raise Malformed(
                [Fault(error.lineno, "", f"is no JSON: {error.msg}, column {error.colno}")]
            ) from None
        except ValueError as error:  # NaN; an integer with more digits than Python takes
            raise Malformed([_unreadable_number(text, str(error))]) from None
        if self._any_repeated:
            raise Malformed(list(self._repetitions(self.data, ())))

    def line(self, where: Sequence[str | int]) -> int:
        """The line, from 1 on, of the value at this place."""
        offset = self._offset(tuple(where))
        return self._text.count("\n", 0, offset) + 1

    def _object(self, pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        made = dict(pairs)
        if len(made) == len(pairs):
            return made
        repeated = _Repeated(made)
        names = [name for name, _ in pairs]
        repeated.names = sorted({name for name in names if names.count(name) > 1})
        self._any_repeated = True
        return repeated

    def _repetitions(self, data: Any, where: tuple[str | int, ...]) -> Iterator[Fault]:
        if isinstance(data, _Repeated):
            place = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where)
            for name in data.names:
                yield Fault(self.line((*where, name)), f"{place}.{name}".removeprefix("."), "is given twice")
        parts = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
        for part, value in parts:
            if isinstance(value, dict | list):
                yield from self._repetitions(value, (*where, part))

    def _offset(self, where: tuple[str | int, ...]) -> int:
        """Where in the text the value begins; of a name that is repeated the last."""
        if not where:
            return _skip(self._text, 0)
        parent = where[:-1]
        if parent not in self._offsets:
            self._offsets[parent] = self._members(self._offset(parent))
        return self._offsets[parent][where[-1]]

    def _members(self, start: int) -> dict[str | int, int]:
        """The places of what is in the list or object that begins at `start`."""
        text, decoder = self._text, json.JSONDecoder()
        is_object = text[start] == "{"
        place, members = _skip(text, start + 1), dict[str | int, int]()
        while text[place] not in "]}":
            key: str | int = len(members)
            if is_object:
                key, place = decoder.raw_decode(text, place)
                place = _skip(text, _skip(text, place) + 1)  # the colon
            members[key] = place
            place = _skip(text, decoder.raw_decode(text, place)[1])
            if text[place] == ",":
                place = _skip(text, place + 1)
        return members


def _skip(text: str, place: int) -> int:
    """Behind white space."""
    return _SPACE.match(text, place).end()  # type: ignore[union-attr]


def _refuse_constant(word: str) -> NoReturn:
    raise ValueError(word)


def _unreadable_number(text: str, reason: str) -> Fault:
    """The first NaN, infinity, or integer beyond all use, outside of strings."""
    found = re.compile(r'"(?:[^"\\]|\\.)*"|(-?Infinity|NaN|-?\d{300,})').finditer(text)
    token = next((match for match in found if match[1]), None)
    line = text.count("\n", 0, token.start()) + 1 if token else 1
    shown = token[1] if token and len(token[1]) < 20 else f"{token[1][:8]}..." if token else reason
    return Fault(line, "", f"{shown} is no finite number")


def _too_deep(text: str) -> Fault:
    depth = 0
    for token in _TOKENS.finditer(text):
        depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(token[0], 0)
        if depth > DEPTH:
            line = text.count("\n", 0, token.start()) + 1
            return Fault(line, "", f"lists and objects are nested more than {DEPTH} deep")
    return Fault(1, "", "lists and objects are nested too deep")
