"""XML by the standard library's parser, with line numbers; what XML can do beyond data is refused."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Sequence
from typing import Any, Literal, NoReturn
from xml.parsers import expat

from linkwork.arguments import path as path_of
from linkwork.errors import Fault, Faults, FileError, ModelFileError, cause
from linkwork.modeling.files import content

#: Largest file [bytes], levels of elements in each other, and attributes of one.
SIZE, DEPTH, ATTRIBUTES = 2**26, 10_000, 1000


#: Of elements without attributes: one for all.
_NO_ATTRIBUTES: dict[str, str] = {}


class Node:
    """An element: its tag, attributes, text, children, and line in the file."""

    __slots__ = ("attributes", "children", "line", "tag", "text")

    def __init__(self, tag: str, attributes: dict[str, str], line: int) -> None:
        self.tag, self.attributes, self.line = tag, attributes or _NO_ATTRIBUTES, line
        self.text = ""
        self.children: Sequence[Node] = ()

    def all(self, tag: str) -> Iterator[Node]:
        """Children of this tag."""
        return (child for child in self.children if child.tag == tag)

    def one(self, tag: str) -> Node | None:
        """The first child of this tag."""
        return next(self.all(tag), None)

    def find(self, *tags: str) -> Node | None:
        """The first child of the first tag, its first child of the second, ..."""
        node: Node | None = self
        for tag in tags:
            node = node.one(tag) if node is not None else None
        return node

    def below(self) -> Iterator[Node]:
        """All that is in it, in the order of the file."""
        waiting = [iter(self.children)]  # elements may be deeper in each other than calls
        while waiting:
            child = next(waiting[-1], None)
            if child is None:
                waiting.pop()
                continue
            yield child
            waiting.append(iter(child.children))

    def word(self, *tags: str) -> str | None:
        """The text of a descendant."""
        node = self.find(*tags)
        return node.text.strip() if node is not None else None


#: The values of a bool in SDF, in small or large letters.
BOOLEANS = {"1": True, "true": True, "0": False, "false": False}


#: A number in C and in XML Schema. Python knows more: 1_000, digits of other scripts, words such as nan.
NUMBER = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")


def finite(text: str, count: int) -> list[float] | None:
    """`count` finite numbers between what XML takes for blanks; None: the text is something else."""
    words = re.split(r"[ \t\r\n]+", text.strip(" \t\r\n"))
    if len(words) != count or not all(map(NUMBER.fullmatch, words)):
        return None
    values = [float(word) for word in words]
    return values if all(map(math.isfinite, values)) else None


class Reader:
    """One XML file and the faults in it."""

    def __init__(
        self,
        path: str | os.PathLike[str],
        root_tag: str | None,
        blank: Literal["missing", "wrong"] = "missing",
        encodings: Sequence[str] = (),
    ) -> None:
        """`blank`: what numbers of which there is nothing but blanks are.
        `encodings`: in small letters, those that are taken of a file that is not in ASCII; without them all.

        FileError: it cannot be read. ModelFileError: no XML, or another root than one of this tag.
        """
        self._blank_is_wrong, self._encodings = blank == "wrong", encodings
        self.path = str(path_of(path, f"<{root_tag}> file" if root_tag else "XML file"))
        self.faults = Faults()
        self.root = self._parse()
        if root_tag is not None and self.root.tag != root_tag:
            reason = f"<{self.root.tag}> is not the <{root_tag}> that was expected"
            raise ModelFileError(path, [Fault(self.root.line, "", reason)])

    def add(self, node: Node, field: str, message: str) -> None:
        self.add_line(node.line, field, message)

    def add_line(self, line: int, field: str, message: str) -> None:
        self.faults.add(Fault(line, field, message))

    def finish(self) -> None:
        """ModelFileError: there are faults."""
        if self.faults.count:
            raise ModelFileError(self.path, self.faults.all())

    def numbers(
        self, node: Node, text: str | None, count: int, field: str, default: Sequence[float] | None = None
    ) -> list[float]:
        """`count` finite numbers; a fault and zeros where there are others."""
        if text is None or not (text.strip() or self._blank_is_wrong):
            if default is None:
                self.add(node, field, "is missing")
            return list(default or [0.0] * count)
        values = finite(text, count)
        if values is None:
            wanted = "a finite number" if count == 1 else f"{count} finite numbers"
            self.add(node, field, f"'{text.strip()[:60]}' is not {wanted}")
            return [0.0] * count
        return values

    def number(self, node: Node, text: str | None, field: str, default: float | None = None) -> float:
        return self.numbers(node, text, 1, field, None if default is None else [default])[0]

    def boolean(self, node: Node, text: str | None, field: str, default: bool = False) -> bool:
        """Of a bool in SDF; a fault and the default where it is none."""
        word = (text or "").strip()
        if word and word.lower() not in BOOLEANS:
            self.add(node, field, f"'{word[:60]}' is not true, false, 1 or 0")
        return BOOLEANS.get(word.lower(), default)

    def _parse(self) -> Node:
        try:
            found = content.read(self.path, SIZE) if os.stat(self.path).st_size <= SIZE else None
        except OSError as error:
            raise FileError(f"'{self.path}': {cause(error)}", code="not_readable") from error
        if found is None:
            self._refuse(1, f"has more than {SIZE // 2**20} MiB")
        if not found.strip():
            self._refuse(1, "the file is empty")
        builder = _Builder(self)
        parser = expat.ParserCreate()
        parser.StartElementHandler = lambda tag, found: builder.start(tag, found, parser.CurrentLineNumber)
        parser.EndElementHandler = builder.end
        parser.CharacterDataHandler = builder.data
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = lambda *_: self._refuse(
            parser.CurrentLineNumber, "DOCTYPE is not taken: it can make the file mean anything"
        )
        if self._encodings and not found.isascii():
            parser.XmlDeclHandler = lambda _, encoding, __: self._check_encoding(encoding)
        try:
            parser.Parse(found, True)
        except expat.ExpatError as error:
            self._refuse(
                error.lineno, f"is no XML: {expat.ErrorString(error.code)}, column {error.offset + 1}"
            )
        except (ValueError, LookupError) as error:  # an encoding that is not there
            self._refuse(1, f"is no XML: {error}")
        return builder.root  # type: ignore[return-value]

    def _check_encoding(self, encoding: str | None) -> None:
        if encoding is not None and encoding.lower() not in self._encodings:
            self._refuse(
                1, f"is in {encoding[:60]}, which is not taken: save it in {self._encodings[0].upper()}"
            )

    def _refuse(self, line: int, message: str) -> NoReturn:
        raise ModelFileError(self.path, [Fault(line, "", message)])


class _Builder:
    def __init__(self, reader: Reader) -> None:
        self.root: Node | None = None
        self._open: list[Node] = []
        self._texts: list[list[str]] = []  # of the open ones
        self._reader = reader

    def start(self, tag: str, attributes: dict[str, str], line: int) -> None:
        if len(attributes) > ATTRIBUTES:
            self._reader._refuse(line, f"<{tag[:80]}> has more than {ATTRIBUTES} attributes")
        node = Node(tag, attributes, line)
        if self._open:
            parent = self._open[-1]
            if not isinstance(parent.children, list):
                parent.children = []
            parent.children.append(node)
        else:
            self.root = node
        self._open.append(node)
        self._texts.append([])
        if len(self._open) > DEPTH:
            self._reader._refuse(line, f"elements are nested more than {DEPTH} deep")

    def end(self, _: Any) -> None:
        texts = self._texts.pop()
        self._open.pop().text = "".join(texts)

    def data(self, text: str) -> None:
        self._texts[-1].append(text)
