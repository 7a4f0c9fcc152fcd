"""The page: one HTML file with the viewer, its style and the runs in it. It asks nothing of a network."""

from __future__ import annotations

import html
import json
import os
import tempfile
import webbrowser
from collections.abc import Iterable, Iterator, Sequence
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from linkwork.arguments import check_suffix, is_number
from linkwork.arrays import Floats
from linkwork.errors import OptionError, counted, warn
from linkwork.replacement import replacing
from linkwork.view.poses import page_origin
from linkwork.view.run import LIMIT, Document, document

if TYPE_CHECKING:
    from linkwork.results.result import Result

_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<main id="viewer"></main>
<script id="runs" type="application/json">{runs}</script>
{blocks}
<script>{script}</script>
</body>
</html>
"""


class Page:
    """An HTML file that needs nothing else. In a notebook it shows itself."""

    def __init__(self, html: str) -> None:
        self.html = html

    def save(self, path: str | os.PathLike[str]) -> None:
        """FileError: it has the suffix of another kind of file, or cannot be written."""
        with replacing(check_suffix(path, "page"), "page") as beside:
            beside.write_text(self.html, encoding="utf-8")

    def open(self) -> Path:
        """In the web browser, from a temporary file that stays."""
        descriptor, name = tempfile.mkstemp(prefix="linkwork-", suffix=".html")
        os.close(descriptor)
        self.save(name)
        webbrowser.open(Path(name).as_uri())
        return Path(name)

    def frame(self, height: int = 640) -> str:
        """An HTML element that holds the page, to be put into another."""
        return (
            f'<iframe title="linkwork viewer" style="width:100%;height:{height}px;border:0" '
            f'srcdoc="{html.escape(self.html)}"></iframe>'
        )

    def _repr_html_(self) -> str:
        return self.frame()

    def __repr__(self) -> str:
        return (
            f"<View of {len(self.html.encode()) / 1e6:.2f} MB: save(path), open(), or show it in a notebook>"
        )


def view(results: Sequence[Result], labels: Sequence[str] = (), limit: float = LIMIT) -> Page:
    """A page of one run, or of two laid over each other.

    labels  of the runs, where there are two
    limit   of the frames of all runs in the page, before they are deflated [bytes]; frames beyond are left
            out evenly, and the page says so

    OptionError: the limit is too small for two frames. LinkworkWarning: runs of different mechanisms.
    """
    if not is_number(limit):
        raise OptionError(f"limit {limit!r:.80} is not a finite number of bytes", code="limit")
    each = limit / len(results)
    _compare(results)
    origin = page_origin(results[0])
    return _page(
        [document(result, label, each, origin=origin) for result, label in _labelled(results, labels)]
    )


def streamed_page(results: Sequence[Result], labels: Sequence[str], origin: Floats) -> tuple[Page, list[int]]:
    """The same for a server, which gives out so many pieces of poses of each run, from `origin` (3,) [m] on.
    See `stream_piece`."""
    each = LIMIT / len(results)
    _compare(results)
    documents = [
        document(result, label, each, streamed=True, origin=origin)
        for result, label in _labelled(results, labels)
    ]
    return _page(documents), [it.facts["pieces"]["count"] for it in documents]


def _compare(results: Sequence[Result]) -> None:
    """LinkworkWarning: bodies and joints of the one are not those of the other."""
    first, *others = results
    for other in others:
        for what in ("body_names", "joint_names"):
            if list(getattr(first, what)) != list(getattr(other, what)):
                one, two = (it.manifest.get("model") or "model" for it in (first, other))
                return warn(
                    f"the two runs are of different mechanisms, '{one}' and '{two}': their "
                    f"{'bodies' if what == 'body_names' else 'joints'} are not the same; lines of both are "
                    "plotted only of what has one name"
                )
    return None


def _labelled(results: Sequence[Result], labels: Sequence[str]) -> Iterator[tuple[Result, str]]:
    """OptionError: the labels are no names."""
    if not isinstance(labels, Iterable) or isinstance(labels, np.ndarray | str):
        raise OptionError(f"labels {labels!r:.80} are no names of runs", code="labels")
    names = [*map(str, labels)]
    if len(names) > len(results):
        told = f"{counted(len(names), 'name')} for {counted(len(results), 'run')}"
        raise OptionError(f"labels {labels!r:.80}: {told}; give one each", code="labels")
    return zip(results, [*names, *("" for _ in results)], strict=False)


def _page(documents: Sequence[Document]) -> Page:
    model = documents[0].facts["model"]
    return Page(
        _PAGE.format(
            title=html.escape(f"{model} - linkwork"),
            style=_bundled("viewer.css"),
            script=_bundled("viewer.js").replace("</script", "<\\/script"),
            runs=json.dumps([it.facts for it in documents], separators=(",", ":")).replace("<", "\\u003c"),
            blocks="\n".join(
                f'<script id="{name}" type="text/plain">{block}</script>'
                for number, it in enumerate(documents)
                for name, block in _blocks(number, it)
            ),
        )
    )


def _blocks(number: int, document: Document) -> Iterator[tuple[str, str]]:
    """Of the run of that number, by their names in the page."""
    yield f"block{number}", document.block
    for place, piece in enumerate(document.pieces):
        yield f"poses{number}-{place}", piece


def _bundled(name: str) -> str:
    return resources.files("linkwork.view").joinpath("bundle", name).read_text(encoding="utf-8")
