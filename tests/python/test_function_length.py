"""No function is longer than a screen.

Counted are the lines from `def` to the end without the docstring: at most 60, and at most 40 where no comment
beginning with "Long:", inside or above it, says why it is better whole.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST, WITHOUT_REASON = 60, 40


def functions(file: Path) -> Iterator[tuple[str, int, bool]]:
    """(place and name, lines of code, whether there is a reason) of each."""
    text = file.read_text(encoding="utf-8")
    lines = text.splitlines()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            first = node.body[0]
            has_docstring = ast.get_docstring(node) is not None
            docstring = (first.end_lineno or 0) - first.lineno + 1 if has_docstring else 0
            end = node.end_lineno or 0
            reason = any("# Long:" in line for line in lines[node.lineno - 2 : end])
            yield (
                f"{file.relative_to(ROOT)}:{node.lineno} {node.name}",
                end - node.lineno + 1 - docstring,
                reason,
            )


def test_functions_fit_on_a_screen() -> None:
    files = sorted({*(ROOT / "python").rglob("*.py"), *(ROOT / "tests").rglob("*.py")})
    found = [it for file in files for it in functions(file)]
    assert len(found) > 2000
    long = [f"{name}: {count} lines" for name, count, reason in found
            if count > (MOST if reason else WITHOUT_REASON)]  # fmt: skip
    assert not long, "\n" + "\n".join(long)
