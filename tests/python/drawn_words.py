"""The words in a picture of matplotlib as people read them."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

from matplotlib import rc_context
from matplotlib.figure import Figure

#: Names that matplotlib takes for formulas, or leaves out of legends.
HOSTILE = ("_arm", r"$\frac{$", "$5 bill$", r"a\$b & _c_")


def words_of(figure: Figure, folder: Path) -> set[str]:
    """Each text letter by letter; a formula is in pieces."""
    with rc_context({"svg.fonttype": "none"}):
        figure.savefig(folder / "picture.svg")
    texts = ElementTree.parse(folder / "picture.svg").iter("{http://www.w3.org/2000/svg}text")
    return {(text.text or "").replace("\N{ZERO WIDTH SPACE}", "") for text in texts}
