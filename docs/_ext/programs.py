"""The programs of the pages: the ```python fences of a page are one, from top to bottom, in a folder of its
own.
"""

from __future__ import annotations

import ast
import contextlib
import io
import os
import re
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Self

FENCE = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def blocks(page: Path) -> list[str]:
    """The programs of a page that are run, in order."""
    return FENCE.findall(page.read_text())


class Program:
    """One page's Python, block by block in one namespace."""

    def __init__(self, name: str) -> None:
        self.namespace: dict[str, Any] = {"__name__": name}
        self.folder = tempfile.TemporaryDirectory(prefix="linkwork-docs-")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.folder.cleanup()

    def run(self, code: str) -> tuple[str, Any]:
        """What it printed, and the value of its last line; handles of what a model has say nothing."""
        tree = ast.parse(code)
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        printed, value = io.StringIO(), None
        with self._inside(), contextlib.redirect_stdout(printed):
            exec(compile(tree, "<page>", "exec"), self.namespace)
            if last is not None:
                value = eval(compile(ast.Expression(last.value), "<page>", "eval"), self.namespace)
        return printed.getvalue(), None if type(value).__module__ == "linkwork.modeling.handles" else value

    @contextlib.contextmanager
    def _inside(self) -> Iterator[None]:
        before = os.getcwd()
        os.chdir(self.folder.name)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                yield
        finally:
            os.chdir(before)
