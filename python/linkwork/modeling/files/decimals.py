"""Decimal numbers as they are written in files."""

from __future__ import annotations

import re
from typing import Self

__all__ = ["TOO_SMALL", "Vanished", "decimal"]

TOO_SMALL = "is nearer to zero than any other number: write 0.0, or a larger one"

_NOT_ZERO = re.compile(r"[-+.0]*[1-9]")


class Vanished(float):
    """Zero, of a number that is not written as zero."""

    text: str

    def __new__(cls, text: str) -> Self:
        made = super().__new__(cls, 0.0)
        made.text = text[:20]
        return made


def decimal(text: str) -> float:
    """The nearest number; `Vanished` where that is zero, and the text is not."""
    value = float(text)
    return value if value or not _NOT_ZERO.match(text) else Vanished(text)
