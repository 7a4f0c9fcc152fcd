"""YAML 1.2, the part that is data: no anchors and aliases, no tags, no repeated keys, one document.

PyYAML reads the text into events, which are the same in YAML 1.1 and 1.2 but for three line breaks that 1.2
does not have; values are those of the core schema (YAML 1.2.2, section 10.3.2).
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import yaml
from yaml import events
from yaml.error import MarkedYAMLError, YAMLError

from linkwork.errors import Fault, Faults
from linkwork.modeling.files.decimals import TOO_SMALL, Vanished, decimal

#: Levels of lists and mappings in each other.
DEPTH = 64

#: libyaml's parser where PyYAML is built with it: 50 times as fast.
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

#: Line breaks of YAML 1.1 (next line, line separator, paragraph separator), plain characters in 1.2.
OLD_BREAKS = re.compile("[\x85\u2028\u2029]")

_CORE: Mapping[str, tuple[str, Callable[[str], Any]]] = {
    "int": (r"[-+]?[0-9]{1,300}", int),
    "float": (r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?", decimal),
    "null": (r"null|Null|NULL|~|", lambda _: None),
    "true": (r"true|True|TRUE", lambda _: True),
    "false": (r"false|False|FALSE", lambda _: False),
    "octal": (r"0o[0-7]{1,300}", lambda text: int(text[2:], 8)),
    "hexadecimal": (r"0x[0-9a-fA-F]{1,300}", lambda text: int(text, 16)),
    "special": (
        r"[-+]?(?:\.inf|\.Inf|\.INF)|\.nan|\.NaN|\.NAN",
        lambda text: float(text.replace(".", "")),
    ),
}
_VALUE = re.compile("|".join(f"(?P<{name}>(?:{pattern})\\Z)" for name, (pattern, _) in _CORE.items()))


class Malformed(Exception):
    """No YAML, or a part of it that a model file does not have."""

    def __init__(self, faults: list[Fault]) -> None:
        self.faults = faults


@dataclass(slots=True)
class _Open:
    """A list or mapping while it is read."""

    data: Any
    where: str
    key: str | None = None  #: of a mapping: waits for its value
    key_line: int = 0


class YamlText:
    """A YAML document."""

    def __init__(self, text: str) -> None:
        self._root = _Open([], "")
        self._lines = array(
            "I"
        )  # of all values, each before those in it; of a mapping's value that of its key
        self._reached: dict[tuple[str | int, ...], tuple[int, int]] = {}
        self._faults = Faults()
        try:
            self._read(text)
        except MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark  # from 0; at the end one too many
            breaks = text.count("\n") + text.count("\r") - text.count("\r\n")
            line = min(mark.line, breaks) + 1 if mark else 1
            problem = f"is no YAML: {error.problem or error.context}"
            if "nesting depth" in problem:  # which newer parsers limit, too, before a list is seen here
                problem = f"lists and mappings are nested more than {DEPTH} deep"
            self._faults.add(Fault(line, "", problem))
        except (YAMLError, RecursionError, ValueError) as error:
            line = text.encode().count(b"\n", 0, getattr(error, "position", None) or 0) + 1
            reason = getattr(error, "reason", None) or str(error).splitlines()[0]
            self._faults.add(Fault(line, "", f"is no YAML: {reason}"))
        if self._faults.count:
            raise Malformed(self._faults.all())
        self.data = self._root.data[0] if self._root.data else None

    def line(self, where: Sequence[str | int]) -> int:
        """The line, from 1 on, of the value at this place; of a mapping's value that of its key."""
        data, place = self.data, 0
        for depth, part in enumerate(where):
            place = self._place_in(tuple(where[:depth]), data, part, place)
            data = data[part]
        return self._lines[place]

    def _place_in(self, where: tuple[str | int, ...], data: Any, part: str | int, start: int) -> int:
        """Of the value `part` of the list or mapping at `start` among all values. KeyError, IndexError."""
        data[part]
        wanted = list(data).index(part) if isinstance(data, dict) else int(part)
        number, place = self._reached.get(where, (0, start + 1))
        if number > wanted:
            number, place = 0, start + 1
        values = data.values() if isinstance(data, dict) else data
        for value in islice(values, number, wanted):
            place += _size(value)
        self._reached[where] = wanted, place
        return place

    def _read(self, text: str) -> None:
        found = OLD_BREAKS.search(text)
        if found:
            line = text.count("\n", 0, found.start()) + 1
            self._refuse(line, "", f"character U+{ord(found[0]):04X}, a line break of YAML 1.1, is not taken")
        open_nodes, documents = [self._root], 0
        for event in yaml.parse(text, Loader=LOADER):
            kind, line = type(event), event.start_mark.line + 1
            if kind is events.ScalarEvent:
                if event.anchor is not None or event.tag is not None:
                    self._check_plain(event, line)
                parent = open_nodes[-1]
                is_key = parent.key is None and isinstance(parent.data, dict)
                plain = not event.style and not is_key
                self._put(parent, _value(event.value) if plain else event.value, line)
            elif kind is events.SequenceStartEvent or kind is events.MappingStartEvent:
                self._check_plain(event, line)
                data: Any = [] if kind is events.SequenceStartEvent else {}
                where = self._put(open_nodes[-1], data, line, is_node=True)
                open_nodes.append(_Open(data, where))
                if len(open_nodes) > DEPTH + 1:
                    self._refuse(line, "", f"lists and mappings are nested more than {DEPTH} deep")
            elif kind is events.SequenceEndEvent or kind is events.MappingEndEvent:
                open_nodes.pop()
            elif kind is events.DocumentStartEvent:
                documents += 1
                if documents > 1 or event.version is not None or event.tags:
                    self._refuse(line, "", "a model file is one document without directives")
            elif kind is events.AliasEvent:
                self._refuse(line, "", f"alias *{event.anchor}: aliases are not taken; write the value")

    def _put(self, parent: _Open, value: Any, line: int, *, is_node: bool = False) -> str:
        """Add a value to the list or mapping that is open; in a mapping keys and values take turns.

        Where a list or mapping is, in words.
        """
        if isinstance(parent.data, list):
            key: str | int = len(parent.data)
            parent.data.append(value)
        elif parent.key is None:
            if is_node:
                self._refuse(line, parent.where, "a key must be a word, no list or mapping")
            if value in parent.data:
                place = f"{parent.where}.{value[:80]}".removeprefix(".")
                self._faults.add(Fault(line, place, "is given twice"))
            parent.key, parent.key_line = value, line
            return ""
        else:
            key, parent.key = parent.key, None
            line = parent.key_line
            parent.data[key] = value
        self._lines.append(line)
        vanished = isinstance(value, Vanished)
        if not (is_node or vanished) or parent is self._root:
            return ""
        where = f"{parent.where}{f'[{key}]' if isinstance(key, int) else f'.{key[:80]}'}".removeprefix(".")
        if vanished:
            self._faults.add(Fault(line, where, f"{value.text} {TOO_SMALL}"))
        return where

    def _check_plain(self, event: Any, line: int) -> None:
        if event.anchor is not None:
            self._refuse(
                line, "", f"anchor &{event.anchor}: anchors are not taken; write the value where it is"
            )
        if event.tag is not None:
            self._refuse(line, "", f"tag {event.tag}: tags are not taken")

    def _refuse(self, line: int, where: str, reason: str) -> None:
        raise Malformed([*self._faults.all(), Fault(line, where, reason)])


def _size(value: Any) -> int:
    """Of a value: how many it is with those in it."""
    count, stack = 0, [value]
    while stack:
        value = stack.pop()
        count += 1
        if isinstance(value, dict):
            stack.extend(value.values())
        elif isinstance(value, list):
            stack.extend(value)
    return count


def _value(text: str) -> Any:
    found = _VALUE.match(text)
    return text if found is None else _CORE[found.lastgroup or ""][1](text)
