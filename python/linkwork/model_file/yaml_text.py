"""YAML 1.2, the part that is data: no anchors and aliases, no tags, no repeated keys, one document.

ruamel.yaml reads the text into events; values are those of the core schema (YAML 1.2.2, section 10.3.2).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from ruamel.yaml import YAML, events
from ruamel.yaml.error import MarkedYAMLError, YAMLError

from linkwork.errors import Fault

#: Levels of lists and mappings in each other.
DEPTH = 64

_CORE = (
    (re.compile(r"null|Null|NULL|~|"), lambda _: None),
    (re.compile(r"true|True|TRUE"), lambda _: True),
    (re.compile(r"false|False|FALSE"), lambda _: False),
    (re.compile(r"[-+]?[0-9]{1,300}"), int),
    (re.compile(r"0o[0-7]{1,300}"), lambda text: int(text[2:], 8)),
    (re.compile(r"0x[0-9a-fA-F]{1,300}"), lambda text: int(text, 16)),
    (re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?"), float),
    (re.compile(r"[-+]?(\.inf|\.Inf|\.INF)|\.nan|\.NaN|\.NAN"), lambda text: float(text.replace(".", ""))),
)


class Malformed(Exception):
    """No YAML, or a part of it that a model file does not have."""

    def __init__(self, faults: list[Fault]) -> None:
        self.faults = faults


@dataclass
class _Node:
    """A list or mapping while it is read; what is in it has a line, and a node where it is one itself."""

    data: Any
    line: int
    lines: dict[str | int, int] = field(default_factory=dict)
    nodes: dict[str | int, _Node] = field(default_factory=dict)
    key: str | None = None  #: of a mapping: waits for its value
    key_line: int = 0
    where: str = ""


class YamlText:
    """A YAML document."""

    def __init__(self, text: str) -> None:
        self._root = _Node([], 1)
        self._faults: list[Fault] = []
        try:
            self._read(text)
        except MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark
            line = mark.line + 1 if mark else 1
            self._faults.append(Fault(line, "", f"is no YAML: {error.problem or error.context}"))
        except (YAMLError, RecursionError, ValueError) as error:
            line = text.count("\n", 0, getattr(error, "position", None) or 0) + 1
            reason = getattr(error, "reason", None) or str(error).splitlines()[0]
            self._faults.append(Fault(line, "", f"is no YAML: {reason}"))
        if self._faults:
            raise Malformed(self._faults)
        self.data = self._root.data[0] if self._root.data else None

    def line(self, where: Sequence[str | int]) -> int:
        """The line, from 1 on, of the value at this place; of a mapping's value that of its key."""
        node, line = self._root, 1
        for part in (0, *where):
            line = node.lines[part]
            node = node.nodes.get(part, node)
        return line

    def _read(self, text: str) -> None:
        open_nodes, documents = [self._root], 0
        for event in YAML(typ="safe", pure=True).parse(text):
            line = event.start_mark.line + 1
            if isinstance(event, events.DocumentStartEvent):
                documents += 1
                if documents > 1 or event.version is not None or event.tags:
                    self._refuse(line, "", "a model file is one document without directives")
            elif isinstance(event, events.AliasEvent):
                self._refuse(line, "", f"alias *{event.anchor}: aliases are not taken; write the value")
            elif isinstance(event, events.CollectionStartEvent):
                self._check_plain(event, line)
                node = _Node([] if isinstance(event, events.SequenceStartEvent) else {}, line)
                self._put(open_nodes[-1], node.data, line, node)
                open_nodes.append(node)
                if len(open_nodes) > DEPTH + 1:
                    self._refuse(line, "", f"lists and mappings are nested more than {DEPTH} deep")
            elif isinstance(event, events.CollectionEndEvent):
                open_nodes.pop()
            elif isinstance(event, events.ScalarEvent):
                self._check_plain(event, line)
                is_key = isinstance(open_nodes[-1].data, dict) and open_nodes[-1].key is None
                plain = event.style is None and not is_key
                self._put(open_nodes[-1], _value(event.value) if plain else event.value, line)

    def _put(self, parent: _Node, value: Any, line: int, node: _Node | None = None) -> None:
        """Add a value to the list or mapping that is open; in a mapping keys and values take turns."""
        if isinstance(parent.data, list):
            key: str | int = len(parent.data)
            parent.data.append(value)
        elif parent.key is None:
            if node is not None:
                self._refuse(line, parent.where, "a key must be a word, no list or mapping")
            if value in parent.data:
                self._faults.append(
                    Fault(line, f"{parent.where}.{value}".removeprefix("."), "is given twice")
                )
            parent.key, parent.key_line = value, line
            return
        else:
            key, parent.key = parent.key, None
            line = parent.key_line
            parent.data[key] = value
        parent.lines[key] = line
        if node is not None:
            part = "" if parent is self._root else f"[{key}]" if isinstance(key, int) else f".{key}"
            node.where = f"{parent.where}{part}".removeprefix(".")
            parent.nodes[key] = node

    def _check_plain(self, event: Any, line: int) -> None:
        if event.anchor is not None:
            self._refuse(
                line, "", f"anchor &{event.anchor}: anchors are not taken; write the value where it is"
            )
        if event.tag is not None:
            self._refuse(line, "", f"tag {event.tag}: tags are not taken")

    def _refuse(self, line: int, where: str, reason: str) -> None:
        raise Malformed([*self._faults, Fault(line, where, reason)])


def _value(text: str) -> Any:
    for pattern, value in _CORE:
        if pattern.fullmatch(text):
            return value(text)
    return text
