"""What a benchmark returns, and how it is shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from statistics import median

Row = Mapping[str, float]


@dataclass(frozen=True)
class Outcome:
    """Rows of numbers, the one number that counts, and what it must be."""

    title: str
    rows: Sequence[Row]
    result: float
    target: str  #: such as "at most 1.15"
    met: bool

    def as_dict(self) -> dict[str, object]:
        return asdict(self)


def medians(runs: int, once: Callable[[], Row]) -> dict[str, float]:
    """Of every number that `once` returns, over so many runs after one that warms up."""
    once()
    found = [once() for _ in range(runs)]
    return {name: median(row[name] for row in found) for name in found[0]}


def table(name: str, outcome: Outcome) -> str:
    names = list(outcome.rows[0])
    cells = [names, *([f"{row[column]:.4g}" for column in names] for row in outcome.rows)]
    widths = [max(len(line[k]) for line in cells) for k in range(len(names))]
    lines = ["  ".join(text.rjust(width) for text, width in zip(line, widths, strict=True)) for line in cells]
    verdict = "met" if outcome.met else "MISSED"
    return "\n".join(
        [
            f"{name}: {outcome.title}",
            *lines,
            f"= {outcome.result:.3g}, target {outcome.target}: {verdict}",
            "",
        ]
    )
