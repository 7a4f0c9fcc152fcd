"""What the commands print: tables for people, JSON for programs."""

from __future__ import annotations

import errno
import json
import math
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from linkwork.arguments import SUFFIXES, check_new
from linkwork.arguments import path as path_of
from linkwork.cli import streams
from linkwork.cli.base import may_replace
from linkwork.errors import FileError, unwritable


def print_json(document: Any) -> None:
    """One document on standard output; what JSON cannot say (NaN, infinity) is null."""
    json.dump(_plain(document), sys.stdout, indent=2, allow_nan=False)
    sys.stdout.write("\n")


def note(text: str) -> None:
    """A remark, on standard error: what is printed stays what was asked for."""
    streams.say("note", text)


def print_pairs(pairs: Iterable[tuple[str, str]]) -> None:
    """A label and what it says, a line each."""
    shown = [(label, text) for label, text in pairs if text]
    width = max((len(label) for label, _ in shown), default=0)
    for label, text in shown:
        print(f"{label:<{width}}  " + text.replace("\n", "\n" + " " * (width + 2)))


def print_table(columns: Sequence[str], rows: Iterable[Sequence[str]], title: str | None = None,
                left: int = 1) -> None:  # fmt: skip
    """A table; the first `left` columns are text, the others numbers."""
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, collapse_padding=True)
    for place, column in enumerate(columns):
        table.add_column(Text(column), justify="left" if place < left else "right", overflow="fold")
    for row in rows:
        table.add_row(*map(Text, row))
    if title:
        print(f"\n{title}")
    width = None if sys.stdout.isatty() else 160
    Console(highlight=False, width=width).print(table)


def check_writable(path: str | os.PathLike[str], what: str = "output") -> None:
    """FileError, before a long run, where a file to be written at its end could not be, or may not.

    A file that is there is replaced where `--force` says so.
    """
    parent = Path(path).absolute().parent
    if not parent.is_dir():
        raise FileError(
            f"output '{path}': cannot be written: no directory '{parent}'; make it, or choose another place",
            code="not_writable",
        )
    if what in SUFFIXES:
        check_new(path, what, may_replace())
    else:
        path_of(path, what)
    if Path(path).is_dir():
        raise unwritable("output", path, OSError(errno.EISDIR, ""))
    if not os.access(path if os.path.exists(path) else parent, os.W_OK):
        raise unwritable("output", path, OSError(errno.EACCES, ""))


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):
        return _plain(value.tolist())
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, bool | int | float | str | None) else str(value)
