"""JSON: parsed by the standard library at full speed; places in the text are looked up only for messages."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any, NoReturn

from linkwork.errors import MOST_FAULTS, Fault, Faults
from linkwork.modeling.files.decimals import TOO_SMALL, Vanished, decimal

_SPACE = re.compile(r"[ \t\n\r]*")
_TOKENS = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"|[\[\]{}]')

_DEEPER = {"[": 1, "{": 1, "]": -1, "}": -1}

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
        self._reached: dict[tuple[str | int, ...], tuple[int, int]] = {}  # of a list: an entry, and its place
        self._offsets: dict[tuple[str | int, ...], int] = {}
        self._any_repeated = self._any_vanished = False
        try:
            self.data = json.loads(text, object_pairs_hook=self._object, parse_float=self._number,
                                   parse_constant=_refuse_constant)  # fmt: skip
        except RecursionError:
            raise Malformed([_too_deep(text)]) from None
        except json.JSONDecodeError as error:
            raise Malformed(
                [Fault(error.lineno, "", f"is no JSON: {error.msg}, column {error.colno}")]
            ) from None
        except ValueError as error:  # NaN; an integer with more digits than Python takes
            raise Malformed([_unreadable_number(text, str(error))]) from None
        if self._any_repeated or self._any_vanished:
            faults = Faults()
            for fault in self._found(self.data, (), faults):
                faults.add(fault)
            raise Malformed(faults.all())

    def line(self, where: Sequence[str | int]) -> int:
        """The line, from 1 on, of the value at this place."""
        offset = self._offset(tuple(where))
        return self._text.count("\n", 0, offset) + 1

    def _object(self, pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        made = dict(pairs)
        if len(made) == len(pairs):
            return made
        repeated = _Repeated(made)
        counts = Counter(name for name, _ in pairs)
        repeated.names = sorted(name for name, count in counts.items() if count > 1)
        self._any_repeated = True
        return repeated

    def _number(self, text: str) -> float:
        value = decimal(text)
        self._any_vanished |= isinstance(value, Vanished)
        return value

    def _found(self, data: Any, where: tuple[str | int, ...], so_far: Faults) -> Iterator[Fault]:
        """Names that are repeated, and numbers that vanished."""
        if isinstance(data, _Repeated):
            yield from self._repetitions(data, where, so_far)
        parts = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
        for part, value in parts:
            if isinstance(value, dict | list):
                yield from self._found(value, (*where, part), so_far)
            elif isinstance(value, Vanished):
                line = 1 if so_far.full else self.line((*where, part))
                yield Fault(line, _field((*where, part)), f"{value.text} {TOO_SMALL}")

    def _repetitions(self, data: _Repeated, where: tuple[str | int, ...], so_far: Faults) -> Iterator[Fault]:
        if not so_far.full:
            self._find(where, data.names[:MOST_FAULTS])
        for name in data.names:
            line = 1 if so_far.full else self.line((*where, name))  # those that are counted have none
            yield Fault(line, _field((*where, name[:80])), "is given twice")

    def _offset(self, where: tuple[str | int, ...]) -> int:
        """Where in the text the value begins; of a name that is repeated the last."""
        if not where:
            return _skip(self._text, 0)
        if where not in self._offsets:
            parent, part = where[:-1], where[-1]
            start = self._offset(parent)
            if isinstance(part, int) and self._text[start] == "[":
                self._offsets[where] = self._entry(parent, start, part)
            else:
                self._offsets[where] = self._member(start, part)
        return self._offsets[where]

    def _entry(self, parent: tuple[str | int, ...], start: int, wanted: int) -> int:
        """The place of an entry of the list that begins at `start`."""
        number, place = self._reached.get(parent, (0, _skip(self._text, start + 1)))
        if number > wanted:
            number, place = 0, _skip(self._text, start + 1)
        while number < wanted:
            place = _skip(self._text, _behind(self._text, place) + 1)  # the comma
            number += 1
        self._reached[parent] = number, place
        return place

    def _find(self, where: tuple[str | int, ...], names: Sequence[str]) -> None:
        """The places of members of the object there, in one go."""
        found = self._members(self._offset(where), set(names), all_of=True)
        self._offsets.update({(*where, name): place for name, place in found.items()})

    def _member(self, start: int, wanted: str | int) -> int:
        return self._members(start, {wanted}, all_of=self._any_repeated)[wanted]

    def _members(self, start: int, wanted: set[Any], *, all_of: bool) -> dict[str | int, int]:
        """The places of members of the object beginning at `start`: the last ones, or the first to come."""
        text, decoder, found = self._text, json.JSONDecoder(), dict[str | int, int]()
        place = _skip(text, start + 1)
        while text[place] not in "]}" and (not found or all_of):
            key, place = decoder.raw_decode(text, place)
            place = _skip(text, _skip(text, place) + 1)  # the colon
            if key in wanted:
                found[key] = place
            place = _behind(text, place)
            if text[place] == ",":
                place = _skip(text, place + 1)
        return found


def _field(where: Sequence[str | int]) -> str:
    """A place in words: bodies[3].mass"""
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where).removeprefix(".")


def _behind(text: str, place: int) -> int:
    """Behind the value that begins at `place`, and white space."""
    if text[place] not in "[{":
        return _skip(text, json.JSONDecoder().raw_decode(text, place)[1])
    depth = 0
    for token in _TOKENS.finditer(text, place):
        depth += _DEEPER.get(token[0], 0)
        if depth == 0:
            return _skip(text, token.end())
    raise KeyError(place)


def _skip(text: str, place: int) -> int:
    """Behind white space."""
    return _SPACE.match(text, place).end()  # type: ignore[union-attr]


def _refuse_constant(word: str) -> NoReturn:
    raise ValueError(word)


def _unreadable_number(text: str, reason: str) -> Fault:
    """The first NaN, infinity, or integer beyond all use, outside of strings."""
    found = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"|(-?Infinity|NaN|-?\d{300,})').finditer(text)
    token = next((match for match in found if match[1]), None)
    line = text.count("\n", 0, token.start()) + 1 if token else 1
    shown = token[1] if token and len(token[1]) < 20 else f"{token[1][:8]}..." if token else reason
    return Fault(line, "", f"{shown} is no finite number")


def _too_deep(text: str) -> Fault:
    depth = 0
    for token in _TOKENS.finditer(text):
        depth += _DEEPER.get(token[0], 0)
        if depth > DEPTH:
            line = text.count("\n", 0, token.start()) + 1
            return Fault(line, "", f"lists and objects are nested more than {DEPTH} deep")
    return Fault(1, "", "lists and objects are nested too deep")
