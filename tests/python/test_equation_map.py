"""docs/equations.md leads to the code, and nothing that the code numbers is missing there."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
NUMBER = re.compile(r"\((12\.\d+)\)")
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in (ROOT / "docs" / "equations.md").read_text().splitlines()
    if line.startswith("| (12.")
]


def test_files_of_the_map_name_their_equations() -> None:
    assert len(ROWS) >= 10
    wrong = [
        (equation, file)
        for equation, _, file in ROWS
        if equation not in (ROOT / file).read_text(encoding="utf-8")
    ]
    assert not wrong


def test_equations_named_in_the_code_are_in_the_map() -> None:
    named = {
        number
        for path in (ROOT / "cpp" / "linkwork").rglob("*.?pp")
        for number in NUMBER.findall(path.read_text(encoding="utf-8"))
    }
    assert named - {NUMBER.findall(equation)[0] for equation, *_ in ROWS} == set()
