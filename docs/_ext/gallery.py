"""What examples of the gallery show: every figure and every viewer page that a part of a script makes."""

from __future__ import annotations

import weakref
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from docutils import nodes
from executed import MADE, frame
from linkwork.results.result import Result
from linkwork.view.movie import Painter
from matplotlib.figure import Figure
from matplotlib.image import imsave
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

#: Folders of the examples.
ORDER = [
    "examples/linkages",
    "examples/machines",
    "examples/robots",
    "examples/methods",
    "examples/studies",
    "examples/large",
]

_results: weakref.WeakKeyDictionary[Any, Result] = weakref.WeakKeyDictionary()
_view = Result.view


def _remembering(self: Result, *given: Any, **named: Any) -> Any:
    page = _view(self, *given, **named)
    _results[page] = self
    return page


class Shown:
    """A scraper of sphinx-gallery; what a variable is bound to is shown once."""

    def __init__(self) -> None:
        self._seen: set[int] = set()
        self._kept: list[Any] = []  # so that no identity comes twice

    def __repr__(self) -> str:
        return "Shown()"

    def __call__(self, block: Any, variables: Mapping[str, Any], config: Mapping[str, Any]) -> str:
        text = ""
        for value in list(variables["example_globals"].values()):
            if id(value) in self._seen or not (isinstance(value, Figure) or value_is_page(value)):
                continue
            self._seen.add(id(value))
            self._kept.append(value)
            text += (
                self._figure(value, variables, config)
                if isinstance(value, Figure)
                else self._page(value, variables, config)
            )
        return text

    def _figure(self, figure: Figure, variables: Mapping[str, Any], config: Mapping[str, Any]) -> str:
        file = Path(next(variables["image_path_iterator"]))
        figure.savefig(file, dpi=110)
        return _image(file, config, "figure drawn by the code above")

    def _page(self, page: Any, variables: Mapping[str, Any], config: Mapping[str, Any]) -> str:
        """The viewer; a picture for the overview and for paper comes first."""
        result, script = _results[page], Path(variables["src_file"])
        picture = Path(next(variables["image_path_iterator"]))
        time = float(result.t[0] + 0.6 * (result.t[-1] - result.t[0]))
        imsave(picture, next(Painter(result, (800, 560)).pictures(np.array([time]))))
        made = Path(config["src_dir"]) / MADE
        made.mkdir(exist_ok=True)
        name = f"{script.stem}-{picture.stem[-3:]}.html"
        page.save(made / name)
        return f"\n.. viewer:: {name}\n\n"


def value_is_page(value: Any) -> bool:
    return type(value).__name__ == "Page" and type(value).__module__ == "linkwork.view.page"


def _image(file: Path, config: Mapping[str, Any], alt: str) -> str:
    address = file.relative_to(config["src_dir"]).as_posix()
    return f"\n.. image:: /{address}\n    :alt: {alt}\n    :class: sphx-glr-single-img\n\n"


class ViewerDirective(SphinxDirective):
    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        return [frame(self.arguments[0], 560)]


def setup(app: Sphinx) -> Mapping[str, Any]:
    Result.view = _remembering  # type: ignore[method-assign]
    app.add_directive("viewer", ViewerDirective)
    return {"parallel_read_safe": False}
