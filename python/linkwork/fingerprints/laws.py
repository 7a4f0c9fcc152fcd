"""Texts of the functions that a model calls."""

from __future__ import annotations

import contextlib
import contextvars
from collections.abc import Iterator
from dataclasses import is_dataclass
from types import FunctionType
from typing import Any

from linkwork.fingerprints.reading import attributes
from linkwork.fingerprints.writing import Writer, text_of, together

__all__ = ["law", "under_way"]

#: Models whose laws are being written: a law may look at its model.
_UNDER_WAY: contextvars.ContextVar[tuple[int, ...]] = contextvars.ContextVar("under_way", default=())


def law(value: Any) -> str:
    """A text of a function that a model calls: its code, and what it reads from around it, of its module and
    of others that nobody has installed. What its calls change, such as a list of times, counts as it was when
    it was first looked at; names of functions, bodies and joints do not."""
    return text_of(value, _Law)


@contextlib.contextmanager
def under_way(model: Any) -> Iterator[None]:
    """While the laws of a model are written."""
    before = _UNDER_WAY.set((*_UNDER_WAY.get(), id(model)))
    try:
        with together():
            yield
    finally:
        _UNDER_WAY.reset(before)


class _Law(Writer):
    def parts(self, value: Any) -> list[Any]:
        kind = type(value)
        if isinstance(value, FunctionType):
            return self.of_function(value)
        if kind.__module__.partition(".")[0] != "linkwork":
            return super().parts(value)
        if id(value) in _UNDER_WAY.get():
            return ["the model"]
        for told in ("fingerprint", "hash", "__fingerprint__"):
            if hasattr(kind, told):
                return [kind.__qualname__, getattr(value, told)()]
        if is_dataclass(value):  # handles of bodies and joints
            return [kind.__qualname__, *((it, x) for it, x in attributes(value) if it != "name")]
        return [kind.__qualname__, getattr(value, "model", None)]
