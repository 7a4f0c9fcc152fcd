"""Python of the pages is run while they are built: what it prints and draws stands below it.

The ```python fences of a page are one program, from top to bottom, in a folder of its own. As in a notebook
the value of a fence's last line is shown: figures as pictures, everything else as text. `{motion} result`
shows a result of the program as a small movie, `{page} result` in the viewer. A test runs the same programs
(tests/python/test_docs.py).
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.parsers.rst import directives
from programs import Program
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

log = logging.getLogger(__name__)

#: What pages are made of beside their sources, in the folder of the sources: pictures, movies, viewers.
MADE = "_made"

# --- in the pages -----------------------------------------------------------------------------------------


class _Shown(nodes.Element):
    """Where a result is to be shown, until the programs have run."""


class _Show(SphinxDirective):
    """`{motion} result`, `{page} result`: the expression is one of the page's program."""

    required_arguments = 1
    final_argument_whitespace = True
    option_spec = {"height": directives.positive_int, "seconds": float, "caption": directives.unchanged}
    kind = ""

    def run(self) -> list[nodes.Node]:
        shown = _Shown(kind=self.kind, expression=self.arguments[0], options=self.options)
        self.set_source_info(shown)
        return [shown]


class Motion(_Show):
    kind = "motion"


class Page(_Show):
    kind = "page"


class Execute(SphinxTransform):
    """Before pictures are collected."""

    default_priority = 200

    def apply(self) -> None:
        source = Path(self.env.doc2path(self.env.docname))
        if source.suffix != ".md":
            return
        with Program(self.env.docname) as program:
            self._execute(program)

    def _execute(self, program: Program) -> None:
        shown = list(self.document.findall(lambda it: isinstance(it, nodes.literal_block | _Shown)))
        for number, node in enumerate(shown, 1):
            name = f"{self.env.docname.replace('/', '-')}-{number}"
            try:
                if isinstance(node, _Shown):
                    node.replace_self(_shown(node, program, Path(self.env.srcdir), name))
                elif node.get("language") == "python":
                    self._run(node, program, name)
            except Exception as error:
                if isinstance(node, _Shown):
                    node.parent.remove(node)
                log.warning("the code of the page fails: %s: %s", type(error).__name__, error, location=node)

    def _run(self, node: nodes.literal_block, program: Program, name: str) -> None:
        printed, value = program.run(node.astext())
        place = node.parent.index(node) + 1
        if value is not None and not _is_figure(value):
            printed += str(value) if isinstance(value, str) else repr(value)
        if _is_figure(value):
            node.parent.insert(place, _picture(value, Path(self.env.srcdir), name))
        if printed.strip():
            output = nodes.literal_block(printed.rstrip(), printed.rstrip(), classes=["output"])
            output["language"] = "text"
            node.parent.insert(place, output)


def _is_figure(value: Any) -> bool:
    return type(value).__module__ == "matplotlib.figure"


def _made(srcdir: Path, name: str) -> tuple[Path, str]:
    """The file, and its address in the sources."""
    (srcdir / MADE).mkdir(exist_ok=True)
    return srcdir / MADE / name, f"/{MADE}/{name}"


def _picture(figure: Any, srcdir: Path, name: str) -> nodes.Node:
    file, address = _made(srcdir, f"{name}.png")
    figure.savefig(file, dpi=110)
    return nodes.image(uri=address, candidates={"*": address}, alt="figure drawn by the code above")


def _shown(node: _Shown, program: Program, srcdir: Path, name: str) -> list[nodes.Node]:
    result, options = eval(node["expression"], program.namespace), node["options"]
    if node["kind"] == "motion":
        file, address = _made(srcdir, f"{name}.gif")
        result.movie(file, seconds=options.get("seconds", 3.0), frames_per_second=10, size=(320, 240))
        return [nodes.image(uri=address, alt=f"motion of {node['expression']}", classes=["motion"])]
    file, _ = _made(srcdir, f"{name}.html")
    result.view(file)
    return [frame(f"{name}.html", options.get("height", 520))]


def frame(page: str, height: int) -> nodes.Node:
    """The viewer in a page; the address is completed when HTML is written."""
    return Viewer(page=page, height=height)


class Viewer(nodes.General, nodes.Element):
    """A page of the viewer in a page of the documentation."""


def _write_viewer(self: Any, node: Viewer) -> None:
    from sphinx.util.osutil import relative_uri

    address = relative_uri(
        self.builder.get_target_uri(self.builder.current_docname), f"{MADE}/{node['page']}"
    )
    self.body.append(
        f'<div class="viewer"><iframe title="linkwork viewer" loading="lazy" src="{address}" '
        f'style="height:{node["height"]}px"></iframe>'
        f'<a class="viewer-alone" href="{address}">open the page alone</a></div>\n'
    )
    raise nodes.SkipNode


def _nothing(self: Any, node: Viewer) -> None:
    raise nodes.SkipNode


def copy_pages(app: Sphinx, error: Exception | None) -> None:
    """The viewers go beside the pages that show them."""
    made = Path(app.srcdir) / MADE
    if error is None and app.builder.format == "html" and made.is_dir():
        target = Path(app.outdir) / MADE
        target.mkdir(exist_ok=True)
        for page in made.glob("*.html"):
            (target / page.name).write_bytes(page.read_bytes())


def setup(app: Sphinx) -> Mapping[str, Any]:
    os.environ["MPLBACKEND"] = "Agg"
    app.add_node(Viewer, html=(_write_viewer, None), latex=(_nothing, None), text=(_nothing, None))
    app.add_directive("motion", Motion)
    app.add_directive("page", Page)
    app.add_transform(Execute)
    app.connect("build-finished", copy_pages)
    return {"parallel_read_safe": False, "parallel_write_safe": True}
