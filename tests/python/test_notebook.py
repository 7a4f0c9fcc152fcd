"""A notebook is executed as a user would: everything that is the last of a cell shows itself."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")

NOTEBOOK = Path(__file__).parents[2] / "docs/start/notebook.ipynb"


@pytest.fixture(scope="module")
def shown(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    """By the last line of each cell what it shows, by MIME type."""
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells)  # none are kept in the file
    folder = str(tmp_path_factory.mktemp("notebook"))
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": folder}}).execute()
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    shown = {}
    for cell in cells:
        (result,) = (output for output in cell.outputs if output.output_type == "execute_result")
        shown[cell.source.splitlines()[-1]] = result.data
    return shown


def table_of(data: dict[str, Any]) -> str:
    """The text of a table, cells parted by bars."""
    return re.sub(r"<[^>]*>", "|", data["text/html"])


def test_figures_are_shown_in_a_fresh_notebook(shown: dict[str, dict[str, Any]]) -> None:
    import base64

    pictures = [data["image/png"] for source, data in shown.items() if "plot(" in source]
    assert len(pictures) == 3
    assert all(base64.b64decode(picture).startswith(b"\x89PNG") for picture in pictures)


def test_pages_fit_the_cell(shown: dict[str, dict[str, Any]]) -> None:
    pages = [data["text/html"] for source, data in shown.items() if "view()" in source]
    assert len(pages) == 2
    for page in pages:
        assert re.match(r'<iframe [^>]*style="width:100%;height:\d+px;border:0" srcdoc="', page)
        assert page.endswith("</iframe>") and page.count('"') == 6  # the page is escaped as a whole


def test_a_result_shows_its_summary(shown: dict[str, dict[str, Any]]) -> None:
    text = table_of(shown["result"])
    for words in ("stewart_platform: 13 bodies", "|verdict||", "|recorded||0 to 2 s, 1001 frames|"):
        assert words in text, text


def test_a_model_shows_its_tables(shown: dict[str, dict[str, Any]]) -> None:
    text = table_of(shown["model"])
    assert "Bodies: 13" in text and "Joints: 24" in text and "|foot 1||universal|" in text


def test_an_assembly_shows_what_each_joint_misses(shown: dict[str, dict[str, Any]]) -> None:
    text = table_of(shown["lw.assemble(model)"])
    assert "Residuals: 24" in text and "|head 6||" in text and "largest residuals" in text


def test_a_linearization_shows_its_modes(shown: dict[str, dict[str, Any]]) -> None:
    """A uniform rod of length 1 m that hangs: w^2 = 3 g / (2 l)."""
    text = table_of(shown["lw.linearize(lw.equilibrium(pendulum).model)"])
    assert f"|{(1.5 * 9.81) ** 0.5:.6g}|" in text and "stable: modes" in text


def test_a_comparison_shows_its_table(shown: dict[str, dict[str, Any]]) -> None:
    data = shown["comparison"]["text/html"]
    assert data.count("<tr") > 8
    assert ".linkwork-comparison td { text-align: right; white-space: pre;" in data  # columns stay columns
    assert 'class="linkwork-comparison"' in data
