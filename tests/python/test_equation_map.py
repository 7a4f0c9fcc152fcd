"""docs/equations.md leads to file and line, and nothing that the code numbers is missing there.

Where an equation is stated is the last comment of a file with its number, where it is computed the last line
of code. Run as a program, this writes the lines as they are into the table.
"""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
MAP = ROOT / "docs" / "equations.md"
NUMBER = re.compile(r"\(12\.\d+\)")
PLACE = re.compile(r"(cpp/[\w/]+\.[ch]pp):(\d+)")


def line_of(equation: str, file: str, stated: bool) -> int:
    """0 where there is none; names of equations in strings, which users read, do not count."""
    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
    found = (
        number
        for number, line in enumerate(lines, start=1)
        if equation in line and line.lstrip().startswith("//") == stated and '"' not in line
    )
    return max(found, default=0)


def mended(row: str) -> str:
    """A line of the table with the lines of the code as they are."""
    _, equation, what, stated, computed, _ = row.split("|")
    places = [
        PLACE.sub(lambda it, here=here: f"{it[1]}:{line_of(equation.strip(), it[1], here)}", cell)
        for cell, here in ((stated, True), (computed, False))
    ]
    return "|".join(["", equation, what, *places, ""])


def all_rows() -> list[str]:
    return [line for line in MAP.read_text(encoding="utf-8").splitlines() if line.startswith("| (12.")]


def rows() -> list[str]:
    """Of the equations that code computes."""
    return [row for row in all_rows() if PLACE.search(row)]


def numbers(rows: list[str]) -> list[str]:
    return [number for row in rows for number in NUMBER.findall(row.split("|")[1])]


def test_places_of_the_map_are_those_of_the_equations() -> None:
    assert len(rows()) >= 10
    assert all(len(PLACE.findall(row)) == 2 for row in rows())
    assert not any(":0 " in mended(row) for row in rows()), "a file no longer names its equation"
    wrong = [row for row in rows() if row != mended(row)]
    assert not wrong, "python tests/python/test_equation_map.py writes the lines as they are"


def test_the_map_has_every_equation_of_the_chapter_once() -> None:
    assert sorted(numbers(all_rows())) == sorted(f"(12.{k})" for k in range(1, 19))


def test_equations_named_in_the_code_are_in_the_map() -> None:
    named = {
        number
        for path in (ROOT / "cpp" / "linkwork").rglob("*.?pp")
        for number in NUMBER.findall(path.read_text(encoding="utf-8"))
    }
    assert named - set(numbers(rows())) == set()


if __name__ == "__main__":
    text = MAP.read_text(encoding="utf-8")
    for before in rows():
        text = text.replace(before, mended(before))
    MAP.write_text(text, encoding="utf-8")
