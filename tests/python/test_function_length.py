"""No function is longer than a screen.

Of C++ and Python alike, tests included: at most 60 lines, and at most 40 where no comment beginning with
"Long:", inside or above, says why it is better whole. In Python lines count from `def` to the end without the
docstring, with functions inside. In C++ they count from the first line of what stands before a pair of braces
with parentheses in it, lambdas included.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST, WITHOUT_REASON = 60, 40

#: Place and name, lines of code, whether there is a reason.
Length = tuple[str, int, bool]


def too_long(found: list[Length]) -> list[str]:
    return [
        f"{name}: {count} lines"
        for name, count, reason in found
        if count > (MOST if reason else WITHOUT_REASON)
    ]


def functions(file: Path) -> Iterator[Length]:
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
    assert not too_long(found), "\n" + "\n".join(too_long(found))


#: What opens a block and is no function.
NO_FUNCTION = re.compile(
    r"\s*(template\s*<[^>]*>\s*)?(namespace|struct|class|enum|union|extern|if|for|while|switch|else|do)\b"
)
#: What is no code in C++: comments, strings, lines of the preprocessor.
NO_CODE = re.compile(
    r"""//[^\n]*|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\])'|^\s*#[^\n]*""",
    re.DOTALL | re.MULTILINE,
)


def cpp_functions(file: Path) -> Iterator[Length]:
    text = file.read_text(encoding="utf-8")
    lines = text.splitlines()
    code = NO_CODE.sub(lambda it: re.sub(r"[^\n]", " ", it[0]), text)
    opened: list[tuple[int, str]] = []  # line and text of what stands before each brace that is open
    after = 0  # the last brace or semicolon
    for mark in re.finditer("[{};]", code):
        before = code[after : mark.start()]
        after = mark.end()
        if mark[0] == "{":
            first = code.count("\n", 0, after - 1 - len(before.lstrip()))
            opened.append((first, before.strip()))
        elif mark[0] == "}":
            first, head = opened.pop()
            if "(" in head and not NO_FUNCTION.match(head):
                end = code.count("\n", 0, after) + 1
                reason = any("// Long:" in line for line in lines[max(first - 1, 0) : end])
                yield f"{file.relative_to(ROOT)}:{first + 1} {head}", end - first, reason


def test_cpp_functions_fit_on_a_screen() -> None:
    files = [path for folder in ("cpp", "tests/cpp") for path in sorted((ROOT / folder).rglob("*.[ch]pp"))]
    found = [it for file in files for it in cpp_functions(file)]
    assert len(found) > 3000
    assert not too_long(found), "\n" + "\n".join(too_long(found))
