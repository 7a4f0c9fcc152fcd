"""Tables of the rows, and targets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import groupby
from typing import Any

from comparison import Row


@dataclass(frozen=True)
class Target:
    """How many times as long as linkwork a peer's operation should take; None: only reported."""

    model: str
    peer: str
    operation: str
    at_least: float | None

    def find(self, rows: Sequence[Row]) -> Row | None:
        wanted = (self.model, self.peer, self.operation)
        return next(
            (row for row in rows if (row.model, row.peer, row.operation) == wanted and row.ratios), None
        )

    def met(self, rows: Sequence[Row]) -> bool | None:
        """None where it is only reported, or was not measured."""
        row = self.find(rows)
        return (
            None if row is None or row.ratio is None or self.at_least is None else row.ratio >= self.at_least
        )

    def as_dict(self, rows: Sequence[Row]) -> dict[str, Any]:
        row = self.find(rows)
        return {**asdict(self), "ratio": row.ratio if row else None, "met": self.met(rows)}

    def line(self, rows: Sequence[Row]) -> str:
        row = self.find(rows)
        name = f"{self.model}: {self.peer} {self.operation}"
        if row is None:
            return f"{name}: not measured"
        wanted = "" if self.at_least is None else f", target at least {self.at_least:g}"
        verdict = {True: ": met", False: ": MISSED", None: ""}[self.met(rows)]
        return f"{name} / linkwork {row.counterpart} = {row.ratio:.2f}{wanted}{verdict}"


COLUMNS = ("", "operation", "us a call", "ns a body", "x linkwork", "of its", "spread", "deviation", "")


def table(rows: Sequence[Row]) -> str:
    """Of one model."""
    lines = [list(COLUMNS)]
    for peer, of_peer in groupby(rows, key=lambda row: row.peer):
        lines += [[peer if k == 0 else "", *_cells(row)] for k, row in enumerate(of_peer)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(COLUMNS))]
    text = {0, 1, 5, 8}  # columns to the left
    aligned = (
        [
            cell.ljust(width) if k in text else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(line, widths, strict=True))
        ]
        for line in lines
    )
    title = f"{rows[0].model}: {rows[0].bodies} bodies"
    return "\n".join([title, *("  ".join(line).rstrip() for line in aligned), ""])


def _cells(row: Row) -> Iterator[str]:
    yield row.operation
    if not row.rounds:
        yield from ["-"] * 6
        yield row.failure
        return
    yield f"{1e6 * row.seconds:,.1f}"
    yield f"{1e9 * row.seconds / row.bodies:,.0f}"
    yield "" if row.peer == "linkwork" or row.ratio is None else f"{row.ratio:.2f}"
    yield "" if row.peer == "linkwork" else row.counterpart
    yield f"{100 * row.spread:.0f} %" if len(row.rounds) > 1 else "once"
    yield "" if row.deviation is None else f"{row.deviation:.0e}{'' if row.agrees else ' !'}"
    yield row.failure or row.note
