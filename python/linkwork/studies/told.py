"""What is told of the cases of a study or the members of an ensemble, in lines of a summary."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

__all__ = ["lines"]

#: Causes of failure, and outputs, that a summary lists; characters of a remark.
LISTED, CHARACTERS = 3, 160

#: Remarks that differ in these alone are the same.
NUMBERS = re.compile(r"[-+]?\d[\d.,]*(e[-+]?\d+)?")


def lines(
    errors: Mapping[int, Mapping[str, Any]], remarks: Mapping[int, str], notes: Mapping[str, str], count: str
) -> Iterator[str]:
    """`count`: of how many, in words, "12 cases"."""
    why = Counter(str(it["message"]) for it in errors.values()).most_common(LISTED)
    yield from (f"  {many} x {message}" for message, many in why)
    if remarks:
        yield f"  remarks in {len(remarks)} of {count}{_most_frequent(remarks)}"
    outputs: dict[str, list[str]] = {}
    for label, note in notes.items():
        outputs.setdefault(note, []).append(label)
    for note, labels in outputs.items():
        more = f" and {len(labels) - LISTED} more" if len(labels) > LISTED else ""
        yield f"  {', '.join(labels[:LISTED])}{more}: {note}"


def _most_frequent(remarks: Mapping[int, str]) -> str:
    """One of them, in short."""
    kinds, first_of = Counter[str](), dict[str, str]()
    for text, count in Counter(remarks.values()).items():
        kind = NUMBERS.sub("0", text)
        kinds[kind] += count
        first_of.setdefault(kind, text)
    kind, many = kinds.most_common(1)[0]
    first = first_of[kind]
    text = first if len(first) <= CHARACTERS else f"{first[:CHARACTERS]} ..."
    if many == len(remarks):
        return f": {text}" if many == 1 else f", such as: {text}"
    return f", {many} of them like: {text}"
