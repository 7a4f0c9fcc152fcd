"""From a file to plain data and back to the lines it came from, whatever its syntax."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

from linkwork.arguments import path as path_of
from linkwork.errors import Fault, FileError, ModelFileError, cause, nearest
from linkwork.modeling.files import content, json_text, yaml_text

#: Keys and indices from the root of a document to a value.
Where = Sequence[str | int]


class Syntax(Protocol):
    """A document in one syntax."""

    data: Any

    def line(self, where: Where) -> int:
        """The line, from 1 on, of a value that is there."""


#: How each file name extension is read, and the largest such file [bytes], which neither reading nor writing
#: passes.
SUFFIXES: Mapping[str, tuple[Callable[[str], Any], int]] = {
    ".json": (json_text.JsonText, 2**31),
    ".yaml": (yaml_text.YamlText, 2**24),
    ".yml": (yaml_text.YamlText, 2**24),
}


def check_suffix(path: str | os.PathLike[str], what: str = "model file") -> str:
    """The extension. FileError: none of such a file."""
    suffix = path_of(path, what).suffix.lower()
    if suffix not in SUFFIXES:
        known = ", ".join(SUFFIXES)
        raise FileError(
            f"{what} '{path}': extension '{suffix}' is none of {known}{nearest(suffix, SUFFIXES)}",
            code="suffix",
        )
    return suffix


def parse(path: str | os.PathLike[str], what: str = "model file") -> Syntax:
    """The document in a file. FileError: it cannot be read. ModelFileError: it is no YAML or JSON."""
    suffix = check_suffix(path, what)
    reader, most = SUFFIXES[suffix]
    text = _text(path, most, what)
    try:
        document: Syntax = reader(text)
    except (json_text.Malformed, yaml_text.Malformed) as error:
        raise ModelFileError(path, error.faults) from None
    return document


def too_large(path: str | os.PathLike[str], size: int) -> str:
    """Why a file of this name and size [bytes] is not read, "" where it is."""
    suffix = check_suffix(path)
    most = SUFFIXES[suffix][1]
    if size <= most:
        return ""
    advice = "; write it as .json" if suffix != ".json" else ""
    return f"has {size / 2**20:.3g} MiB; a {suffix} file may have {most / 2**20:.0f} MiB{advice}"


def _text(path: str | os.PathLike[str], most: int, what: str) -> str:
    try:
        size = os.stat(path).st_size
        found = content.read(path, most) if size <= most else None
    except OSError as error:
        raise FileError(f"{what} '{path}': {cause(error)}", code="not_readable") from error
    if found is None:
        # what grows while it is read has no size
        raise ModelFileError(path, [Fault(1, "", too_large(path, max(size, most + 1)))])
    return _decoded(path, found)


def _decoded(path: str | os.PathLike[str], content: bytes) -> str:
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        reason = f"is no UTF-8 text (byte 0x{content[error.start]:02x} at {error.start})"
        raise ModelFileError(path, [Fault(line, "", reason)]) from None
    if not text.strip():
        raise ModelFileError(path, [Fault(1, "", "the file is empty")])
    return text


def field(where: Where) -> str:
    """A place in words: joints[3].axis"""
    words = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where)
    return words.removeprefix(".")
