"""No function is longer than a screen.

In Python the lines from `def` to the end without the docstring are counted: at most 60, and at most 40 where
no comment beginning with "Long:", inside or above it, says why it is better whole. In C++, which clang-format
lays out, a function is what stands between a line with parentheses that ends with a brace and the next brace
that is indented like it: at most 60 lines.
"""

import ast
import re
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


#: What opens a block and is no function.
NO_FUNCTION = re.compile(
    r"\s*(template\s*<[^>]*>\s*)?(namespace|struct|class|enum|union|extern|if|for|while|switch|else|do|#)\b"
)


def cpp_functions(file: Path) -> Iterator[tuple[str, int]]:
    """(place and first line, lines) of each, at namespace level or in a class."""
    lines = file.read_text(encoding="utf-8").splitlines()
    for indent in ("", "  "):
        opened = re.compile(rf"{indent}\S.*\{{$")
        for k, line in enumerate(lines):
            if not opened.match(line):
                continue
            start = k  # of what clang-format has broken into several lines
            while start and re.match(rf"{indent}[^\s/#]|{indent} +[^/]", lines[start - 1]) \
                    and not re.search(r"[;{}:]$", lines[start - 1]):  # fmt: skip
                start -= 1
            head = " ".join(lines[start : k + 1])
            if "(" in head and not NO_FUNCTION.match(head):
                closed = next(j for j in range(k, len(lines)) if j > k and lines[j].startswith(f"{indent}}}"))
                yield f"{file.relative_to(ROOT)}:{start + 1} {head.strip()}", closed - start + 1


def test_cpp_functions_fit_on_a_screen() -> None:
    files = [path for folder in ("cpp", "tests/cpp") for path in sorted((ROOT / folder).rglob("*.[ch]pp"))]
    found = [it for file in files for it in cpp_functions(file)]
    assert len(found) > 1400
    long = [f"{name}: {count} lines" for name, count in found if count > MOST]
    assert not long, "\n" + "\n".join(long)
