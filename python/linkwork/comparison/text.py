"""A comparison as plain text."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats

if TYPE_CHECKING:
    from linkwork.comparison.runs import Outcome
    from linkwork.comparison.table import Comparison


@dataclass(frozen=True)
class Column:
    """Of the table."""

    heading: str
    said: Callable[[Outcome, Mapping[str, Any]], str]
    text: bool = False


def _figure(name: str, form: str) -> Callable[[Outcome, Mapping[str, Any]], str]:
    return lambda outcome, row: "-" if row[name] is None else form.format(row[name])


def _order(error: str) -> Callable[[Outcome, Mapping[str, Any]], str]:
    """Noise where the error is too near to that of the reference."""
    shown = _figure(error.replace("error", "order"), "{:.1f}")
    return lambda outcome, row: "noise" if error in row["noise"] and outcome.step else shown(outcome, row)


COLUMNS: tuple[Column, ...] = (
    Column("method", lambda outcome, row: outcome.label, text=True),
    Column("order,\nh -> 0", _figure("asymptotic_order", "{:.1f}")),
    Column("step [s]\nor rtol", lambda outcome, row: _size(outcome)),
    Column("pose\nerror", _figure("pose_error", "{:.1e}")),
    Column("\norder", _order("pose_error")),
    Column("velocity\nerror", _figure("velocity_error", "{:.1e}")),
    Column("\norder", _order("velocity_error")),
    Column("reaction\nerror", _figure("reaction_error", "{:.1e}")),
    Column("violation\nposition", _figure("position_violation", "{:.0e}")),
    Column("of\nvelocity", _figure("velocity_violation", "{:.0e}")),
    Column("constraints\nacceleration", _figure("acceleration_violation", "{:.0e}")),
    Column("energy\nerror [J]", _figure("energy_error", "{:.1e}")),
    Column("evalua-\ntions", _figure("evaluations", "{:,}")),
    Column("time\n[s]", _figure("seconds", "{:.2g}")),
    Column("status", lambda outcome, row: outcome.verdict, text=True),
)

METHOD, ORDER, SIZE, *_ = COLUMNS

#: Said once for all cells of a method.
ONCE = (METHOD, ORDER)


def cells(comparison: Comparison, columns: Sequence[Column] = COLUMNS) -> list[tuple[str, ...]]:
    """What the columns say of each cell; the method and its order stand at its first one alone."""
    out, shown = [], ""
    for outcome, row in zip(comparison.outcomes, comparison.rows(), strict=True):
        repeated = outcome.method == shown
        shown = outcome.method
        out.append(tuple("" if repeated and it in ONCE else it.said(outcome, row) for it in columns))
    return out


def _size(outcome: Outcome) -> str:
    return f"{outcome.step:g}" if outcome.step is not None else f"rtol {outcome.rtol:g}"


def _range(scales: Floats) -> str:
    """Of the connected parts, which have their own."""
    least, most = (f"{value:.3g}" for value in (scales.min(initial=np.inf), scales.max(initial=0.0)))
    return f"{least} to {most}" if least != most else most


def notes(comparison: Comparison) -> list[str]:
    """What the table rests on, and why cells are missing."""
    reference = comparison.reference
    own = (
        f"own error about {reference.error['state_error']:.1e}"
        if reference.error
        else "own error not stated: smaller errors cannot be told from it"
    )
    scales = reference.scales
    unique = f"{len(reference.unique_joints)} of {reference.joint_count}"
    reactions = f"of reactions to {_range(scales.force)} N, in the {unique} joints where they are unique"
    if not reference.unique_joints:
        reactions = "reactions are not compared: those of no joint follow from the motion"
    found = [
        f"Reference: {reference.description}; {own}.",
        f"Errors, violations, energies: largest over {_frames(comparison)} of each run.",
        f"Errors: of poses relative to {_range(scales.length)} m and 1 rad, "
        f"of velocities to {_range(scales.speed)} m/s, {reactions}.",
        *_noise(comparison),
        "Order, h -> 0: of poses, early in the motion, with steps smaller than those of the table.",
        *_floors(comparison),
        *_reasons(comparison),
        *_remarks(comparison),
    ]
    return found if comparison.studies else [note for note in found if not note.startswith("Order,")]


def _noise(comparison: Comparison) -> list[str]:
    """Which errors say nothing about the order."""
    noisy = ("pose_error" in row["noise"] for row in comparison.rows() if row["step"] is not None)
    count = sum(noisy)
    if not count:
        return []
    own = (comparison.reference.error or {})["pose_error"]
    return [f"Orders of {count} cells are noise: their pose errors are near the reference's own, {own:.1e}; "
            "smaller ones are not ranked."]  # fmt: skip


def _floors(comparison: Comparison) -> list[str]:
    """Of penalties, which leave reactions wrong at any step; where others stagnate, it is rounding."""
    penalties = {info.name for info in _core.formulations() if info.compliant}
    stagnant = {
        it.label: it.stagnation("reaction_error")
        for it in comparison.studies
        if json.loads(it.method).get("formulation") in penalties
    }
    return [
        f"{label}: the reaction error stays at {floor:.1e}, however small the step."
        for label, floor in stagnant.items()
        if floor is not None
    ]


def _reasons(comparison: Comparison) -> list[str]:
    """Why cells did not finish; methods with one reason are counted together."""
    by_reason: dict[tuple[str, str], list[str]] = {}
    for it in comparison.outcomes:
        if it.reason:
            by_reason.setdefault((it.status, it.reason), []).append(it.label)
    return [
        f"{labels[0] if len(set(labels)) == 1 else f'{len(set(labels))} methods'}: {status}: {reason}"
        for (status, reason), labels in by_reason.items()
    ]


def _remarks(comparison: Comparison) -> list[str]:
    """Warnings of the runs, one a method."""
    by_label = {it.label: it.remarks[0] for it in comparison.outcomes[::-1] if it.remarks}
    return [f"{label}: {remark}" for label, remark in by_label.items()]


def whole(comparison: Comparison) -> str:
    """Table, notes and recommendation."""
    return "\n".join([table(comparison), "", *notes(comparison), comparison.recommend()])


def table(comparison: Comparison, width: int | None = None) -> str:
    """The table alone. Where it is wider than `width` characters, several tables, one below the other.

    Each has the steps and some of the other columns, and methods in lines of their own.
    """
    found = _rendered(comparison, COLUMNS)
    if width is None or _width(found) <= width:
        return found
    parts: list[str] = []
    rest = [it for it in COLUMNS if it not in (METHOD, SIZE)]
    while rest:
        count = len(rest)
        while _width(_rendered(comparison, [SIZE, *rest[:count]])) > width and count > 1:
            count -= 1
        parts.append(_by_method(comparison, _rendered(comparison, [SIZE, *rest[:count]])))
        rest = rest[count:]
    return "\n\n".join(parts)


def _width(text: str) -> int:
    return max(map(len, text.splitlines()))


def _by_method(comparison: Comparison, text: str) -> str:
    """With the name of each method before its cells."""
    lines = text.splitlines()
    head = len(lines) - len(comparison.outcomes)
    out, shown = lines[:head], ""
    for outcome, line in zip(comparison.outcomes, lines[head:], strict=True):
        out += [outcome.label] if outcome.method != shown else []
        out.append(line)
        shown = outcome.method
    return "\n".join(out)


def _rendered(comparison: Comparison, columns: Sequence[Column]) -> str:
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, collapse_padding=True)
    for column in columns:
        table.add_column(Text(column.heading), justify="left" if column.text else "right", vertical="bottom",
                         no_wrap=True)  # fmt: skip
    for row in cells(comparison, columns):
        table.add_row(*map(Text, row))
    console = Console(width=400, highlight=False, color_system=None)
    with console.capture() as capture:
        console.print(table)
    return "\n".join(line.rstrip() for line in capture.get().splitlines())


def _frames(comparison: Comparison) -> str:
    counts = {len(it.curves.t) for it in comparison.outcomes if it.curves}
    if not counts:
        return "no frame"
    least, most = min(counts), max(counts)
    return f"{most} frames" if least == most else f"{least} to {most} frames"
