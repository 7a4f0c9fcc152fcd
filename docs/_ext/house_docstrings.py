"""Docstrings of the house, as they are read by `help()`, told to Sphinx.

They are plain text: paragraphs; lists of `name meaning` in two columns; code that is indented; errors as
"ModelError: why". Here these become parameters, code blocks and raised exceptions.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sphinx.application import Sphinx


#: "name   meaning" or "first, second   meaning"
COLUMNS = re.compile(r"^(\S(?:.*?\S)?) {2,}(\S.*)$")
NAMES = re.compile(r"^\w+(, \w+)*,?$")
ERRORS = re.compile(r"(?:^|(?<=[.;] ))((?:\w+(?:Error|Warning)(?:, | and )?)+): ")


def converted(lines: list[str], what: str) -> list[str]:
    """reStructuredText of a docstring."""
    out: list[str] = []
    for block in _blocks(lines):
        out += [*_told(block, what), ""]
    return out


def _blocks(lines: list[str]) -> Iterator[list[str]]:
    block: list[str] = []
    for line in [*lines, ""]:
        if line.strip():
            block.append(line.rstrip())
        elif block:
            yield block
            block = []


def _told(block: list[str], what: str) -> list[str]:
    if all(line.startswith("    ") for line in block):
        language = "python" if re.search(r"[(=]", block[0]) and "sum_" not in block[0] else "text"
        language = "text" if re.search(r"lambda_|Y_i|y_next|\^T|dot|''", " ".join(block)) else language
        return [f".. code-block:: {language}", "", *block]
    rows = _rows(block)
    if rows:
        return _list(rows, what)
    text = " ".join(line.strip() for line in block)
    return _with_errors(text)


def _rows(block: list[str]) -> list[tuple[str, str]]:
    """(name, meaning) of a list in two columns; none where the block is text."""
    rows: list[tuple[str, str]] = []
    column = _column(block)
    if column is None:
        return []
    for line in block:
        name, meaning = line[:column].strip(), line[column:].strip()
        if not meaning and len(line) <= column:  # a name too long for its column
            rows.append((name, ""))
        elif name:
            rows.append((name, meaning))
        elif rows:
            rows[-1] = (rows[-1][0], f"{rows[-1][1]} {meaning}".strip())
        else:
            return []
    return rows


def _column(block: list[str]) -> int | None:
    """Where the second column begins."""
    match = COLUMNS.match(block[0])
    if match:
        column = match.start(2)
    elif len(block) > 1 and NAMES.match(block[0]) and block[1].startswith("   "):
        column = len(block[1]) - len(block[1].lstrip())
    else:
        return None
    for line in block[1:]:
        own = COLUMNS.match(line)
        if line[:1] != " " and not (own and own.start(2) == column) and not NAMES.match(line):
            if line[column - 1 : column] == " " and line[column : column + 1].strip():
                continue
            return None
    return column


def _list(rows: list[tuple[str, str]], what: str) -> list[str]:
    out: list[str] = []
    parameters = what in ("function", "method") and all(NAMES.match(name) for name, _ in rows)
    for name, meaning in rows:
        if parameters:
            out.append(f":param {name.replace(' ', '')}: {inline(meaning)}")
        else:
            out += [f"``{name}``", f"    {inline(meaning) or '..'}", ""]
    return out


def _with_errors(text: str) -> list[str]:
    places = list(ERRORS.finditer(text))
    if not places:
        return [inline(text)]
    out = [inline(text[: places[0].start()].strip()), ""] if places[0].start() else []
    for match, following in zip(places, [*places[1:], None], strict=True):
        reason = text[match.end() : following.start() if following else len(text)].strip()
        names = ", ".join(re.findall(r"\w+", match[1].replace(" and ", ", ")))
        out.append(f":raises {names}: {inline(reason)}")
    return out


def inline(text: str) -> str:
    """Text with its `code`; nothing else in it means anything."""
    parts = re.split(r"(`[^`]+`)", text)
    out = ""
    for part in parts:
        if part.startswith("`") and len(part) > 2:
            out += ("\\ " if out and not out[-1].isspace() and out[-1] not in "([\"'/-" else "") + f"`{part}`"
        else:
            if out.endswith("``") and part[:1] and part[:1].isalnum():
                out += "\\ "
            out += re.sub(r"([*|\\])", r"\\\1", re.sub(r"(\w)_(?!\w)", r"\1\\_", part))
    return out


def process(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    lines[:] = converted(list(lines), what)


def setup(app: Sphinx) -> Mapping[str, Any]:
    app.connect("autodoc-process-docstring", process)
    from sphinx.util.inspect import TypeAliasForwardRef

    TypeAliasForwardRef.__repr__ = (
        lambda self: self.name
    )  # inside of other types, too, a name as in the source
    return {"parallel_read_safe": True}
