"""The documentation is true: its programs run, its commands parse, every public name has an entry in its
reference.
"""

from __future__ import annotations

import ast
import inspect
import re
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import linkwork as lw
import numpy as np
import pytest
from linkwork import benchmark, functions, integrators, mechanisms, rotation, validation
from linkwork.cli.commands import linkwork

DOCS = Path(__file__).parents[2] / "docs"
sys.path.insert(0, str(DOCS / "_ext"))

import check_site  # noqa: E402
import house_docstrings  # noqa: E402
import programs  # noqa: E402
import reference  # noqa: E402

PAGES = sorted(page for page in DOCS.rglob("*.md") if programs.blocks(page))
EXAMPLES = sorted(DOCS.glob("examples/*/*.py"))


# --- what is executed ---


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(DOCS).as_posix())
def test_program_of_the_page_runs(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")
    with programs.Program(page.stem) as program:
        for block in programs.blocks(page):
            program.run(block)


def test_most_pages_of_guide_and_theory_have_programs() -> None:
    without = {page.name for part in ("guide", "theory") for page in (DOCS / part).glob("*.md")} - {
        page.name for page in PAGES
    }
    assert without <= {"index.md"}


@pytest.mark.parametrize("joint", reference.joint_methods())
def test_every_kind_of_joint_has_an_example_in_the_guide(joint: str) -> None:
    assert f"model.{joint}(" in (DOCS / "guide/joints.md").read_text()


def test_the_pinion_of_the_guide_rolls_on_the_side_where_its_rack_is_drawn() -> None:
    """Below: there the pinion moves with the rack, which turns it by v / R."""
    block = next(it for it in programs.blocks(DOCS / "guide/joints.md") if "model.rack_pinion(" in it)
    names: dict[str, Any] = {
        "lw": lw,
        "np": np,
        "run": lambda model, t_end: lw.simulate(model, t_end=t_end, step=1e-3),
    }
    exec(block, names)
    run = names["rack_pinion"]
    pinion = run.body("pinion").omega_inertial
    below = np.cross(pinion, (0, 0, -0.1))
    assert np.abs(below).max() > 0.05
    assert np.abs(run.body("rack").velocity - below).max() < 1e-9


@pytest.mark.parametrize("force", reference.force_methods())
def test_every_kind_of_force_is_in_the_guide(force: str) -> None:
    text = (DOCS / "guide/forces.md").read_text()
    assert f"model.{force}(" in text or f"`{force}`" in text


def commands() -> Iterator[str]:
    for page in sorted(DOCS.rglob("*.md")):
        for block in re.findall(r"^```sh\n(.*?)^```$", page.read_text(), re.DOTALL | re.MULTILINE):
            yield from (line for line in block.splitlines() if line.startswith("linkwork "))


@pytest.mark.parametrize("line", sorted(set(commands())))
def test_command_is_one_that_the_program_accepts(
    line: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Up to the values of its options; a mistake is a click.UsageError."""
    monkeypatch.chdir(tmp_path)
    lw.mechanisms.four_bar().save("four-bar.yaml")
    Path("again.h5").touch()
    command: click.Command = linkwork
    words, parent = shlex.split(line, comments=True)[1:], None
    while isinstance(command, click.Group):
        parent = click.Context(command, info_name="linkwork", parent=parent)
        found = command.get_command(parent, words.pop(0))
        assert found is not None, line
        command = found
    command.make_context(command.name, words, parent=parent)


# --- the gallery ---


def test_gallery_has_more_than_twenty_examples() -> None:
    assert len(EXAMPLES) > 20


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.stem)
def test_example_has_a_title_and_shows_the_viewer(example: Path) -> None:
    tree = ast.parse(example.read_text())
    title, line, *text = (ast.get_docstring(tree) or "").splitlines()
    assert line == "=" * len(title)
    assert len(" ".join(text)) > 80
    calls = [
        it.func.attr
        for it in ast.walk(tree)
        if isinstance(it, ast.Call) and isinstance(it.func, ast.Attribute)
    ]
    assert "view" in calls


# --- the reference ---


def documented() -> set[str]:
    """Names with an entry, from `linkwork.` on; members of classes stand with these."""
    text = "\n".join(reference.texts().values())
    return set(re.findall(r"^\.\. auto\w+:: linkwork\.(\S+)$", text, re.MULTILINE))


def test_every_public_name_has_an_entry() -> None:
    names = {
        name for name in lw.__all__ if inspect.isclass(it := getattr(lw, name)) or inspect.isfunction(it)
    }
    for module in (functions, integrators, mechanisms, rotation, validation, benchmark):
        short = module.__name__.removeprefix("linkwork.")
        for name in getattr(module, "__all__", [n for n in vars(module) if not n.startswith("_")]):
            it = getattr(module, name)
            if (inspect.isclass(it) or inspect.isfunction(it)) and it.__module__.startswith("linkwork"):
                names.add(f"{short}.{name}")
    assert names - documented() - ALIASES == set()


#: What stands elsewhere by its better name, or is a type alone.
ALIASES = {"functions.TimeFunctionLike"}


def test_every_method_of_the_model_has_an_entry() -> None:
    methods = {name for name in dir(lw.Model) if not name.startswith("_")}
    listed = {name.removeprefix("Model.") for name in documented() if name.startswith("Model.")}
    assert methods - listed - {"name"} == set()


def test_every_entry_has_a_docstring() -> None:
    without = [name for name in documented() if not inspect.getdoc(reference.resolved(f"linkwork.{name}"))]
    assert without == []


def test_lists_of_docstrings_become_parameters_and_errors() -> None:
    text = ["Does it.", "", "mass       [kg], zero for", "           a massless body",
            "t, values  of a `table`", "",
            "Some end. ModelError: none. FileError,", "OptionError: another one."]  # fmt: skip
    assert [line for line in house_docstrings.converted(text, "function") if line] == [
        "Does it.",
        ":param mass: [kg], zero for a massless body",
        ":param t,values: of a ``table``",
        "Some end.",
        ":raises ModelError: none.",
        ":raises FileError, OptionError: another one.",
    ]


# --- the checks of the built site ---


def test_dead_links_anchors_and_what_is_loaded_from_elsewhere_are_found(tmp_path: Path) -> None:
    (tmp_path / "index.html").write_text(
        '<a href="there.html#here">1</a> <a href="there.html#gone">2</a> <a href="gone.html">3</a>'
        '<a href="https://example.org">4</a> <script src="https://example.org/a.js"></script>'
        '<link rel="canonical" href="https://example.org"> <iframe src="made/gone.html"></iframe>'
    )
    (tmp_path / "there.html").write_text('<p id="here">text</p>')
    (tmp_path / "style.css").write_text('@import "https://example.org/font.css";')
    assert sorted(check_site.faults(tmp_path)) == [
        "index.html: gone.html leads nowhere",
        "index.html: loads https://example.org/a.js",
        "index.html: made/gone.html leads nowhere",
        "index.html: there.html#gone leads nowhere",
        "style.css: loads https://example.org/font.css",
    ]
