"""Texts of the project's own folder that are pages here, too: what stands in them is written once.

A page says `<!-- text of CONTRIBUTING.md -->`, or `<!-- table of README.md: mechanism, bodies -->` for the
table whose head begins so; the file's own headings come one level below the page's, and its links lead to
pages where there are some, to the names of files elsewhere.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

MARK = re.compile(r"^<!-- text of (\S+) -->$", re.MULTILINE)
TABLE = re.compile(r"^<!-- table of (\S+): (.+) -->$", re.MULTILINE)
LINK = re.compile(r"\[([^\]]+)\]\((?!https?:|#)([^)]+)\)")
FENCED = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)

#: Files that are pages.
PAGES = {"CONTRIBUTING.md": "/contribute/index", "CHANGELOG.md": "/contribute/changes",
         "docs/architecture.md": "/architecture", "docs/equations.md": "/equations"}  # fmt: skip


def text_of(path: Path) -> str:
    """As part of a page: without its title."""
    text = re.sub(r"\A# .*\n", "", path.read_text())
    return "".join(part if part.startswith("```") else LINK.sub(_link, part) for part in FENCED.split(text))


def table_of(path: Path, head: str) -> str:
    """The lines of a table. LookupError: there is none."""
    lines = path.read_text().splitlines()
    for first, line in enumerate(lines):
        if line.startswith(f"| {head}"):
            last = next((k for k in range(first, len(lines)) if not lines[k].startswith("|")), len(lines))
            return "\n".join(lines[first:last])
    raise LookupError(f"{path.name} has no table that begins with {head}")


def _link(found: re.Match[str]) -> str:
    words, target = found[1].strip("`"), found[2]
    return f"{{doc}}`{words} <{PAGES[target]}>`" if target in PAGES else f"`{words}`"


def include(app: Sphinx, name: str, source: list[str]) -> None:
    root = Path(app.srcdir).parent
    for file in [*MARK.findall(source[0]), *(file for file, _ in TABLE.findall(source[0]))]:
        app.env.note_dependency(root / file)
    source[0] = TABLE.sub(lambda mark: table_of(root / mark[1], mark[2]), source[0])
    source[0] = MARK.sub(lambda mark: text_of(root / mark[1]), source[0])


def setup(app: Sphinx) -> Mapping[str, Any]:
    app.connect("source-read", include)
    return {"parallel_read_safe": True}
