"""A comparison as plain text."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from linkwork import _core

if TYPE_CHECKING:
    from linkwork.comparison.table import Comparison

#: Heading, and how a row says it.
COLUMNS: tuple[tuple[str, str, str], ...] = (
    ("pose\nerror", "pose_error", "{:.1e}"),
    ("\norder", "pose_order", "{:.1f}"),
    ("velocity\nerror", "velocity_error", "{:.1e}"),
    ("\norder", "velocity_order", "{:.1f}"),
    ("reaction\nerror", "reaction_error", "{:.1e}"),
    ("violation\nposition", "position_violation", "{:.0e}"),
    ("of\nvelocity", "velocity_violation", "{:.0e}"),
    ("constraints\nacceleration", "acceleration_violation", "{:.0e}"),
    ("energy\nerror [J]", "energy_error", "{:.1e}"),
    ("evalua-\ntions", "evaluations", "{:,}"),
    ("time\n[s]", "seconds", "{:.3f}"),
)


def header() -> tuple[str, ...]:
    return (
        "method",
        "order,\nh -> 0",
        "step [s]\nor rtol",
        *(heading for heading, _, _ in COLUMNS),
        "status",
    )


def rows(comparison: Comparison) -> list[tuple[str, ...]]:
    """The label of a method stands at its first cell alone."""
    out: list[tuple[str, ...]] = []
    shown, orders = "", comparison.orders()
    for outcome, row in zip(comparison.outcomes, comparison.rows(), strict=True):
        label = "" if outcome.method == shown else outcome.label
        shown = outcome.method
        size = f"{outcome.step:g}" if outcome.step is not None else f"rtol {outcome.rtol:g}"
        cells = [_said(row[key], form) for _, key, form in COLUMNS]
        limit = _said(orders[label], "{:.1f}") if label else ""
        out.append((label, limit, size, *cells, outcome.verdict))
    return out


def notes(comparison: Comparison) -> list[str]:
    """What the table rests on, and why cells are missing."""
    reference = comparison.reference
    own = (
        f"own error about {reference.error['state_error']:.1e}" if reference.error else "own error not known"
    )
    scales = reference.scales
    unique = f"{len(reference.unique_joints)} of {reference.joint_count}"
    reactions = f"of reactions to {scales.force:.3g} N, in the {unique} joints where they are unique"
    if not reference.unique_joints:
        reactions = "reactions are not compared: those of no joint follow from the motion"
    found = [
        f"Reference: {reference.description}; {own}.",
        f"Errors: largest over {_frames(comparison)}; of poses relative to {scales.length:.3g} m and 1 rad, "
        f"of velocities to {scales.speed:.3g} m/s, {reactions}.",
        "Order, h -> 0: of poses, early in the motion, with steps smaller than those of the table.",
        *_floors(comparison),
        *_reasons(comparison),
        *_remarks(comparison),
    ]
    return found if comparison.studies else [note for note in found if not note.startswith("Order,")]


def _floors(comparison: Comparison) -> list[str]:
    """Of penalties, which leave reactions wrong at any step; where others stagnate, it is rounding."""
    penalties = {info.name for info in _core.formulations() if info.has_penalty and not info.iterative}
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


def table(comparison: Comparison) -> str:
    """The table alone; lines are as long as they need to be."""
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, collapse_padding=True)
    columns = header()
    for place, column in enumerate(columns):
        justify: Any = "left" if place in (0, len(columns) - 1) else "right"
        table.add_column(Text(column), justify=justify, vertical="bottom", no_wrap=True)
    for row in rows(comparison):
        table.add_row(*map(Text, row))
    console = Console(width=300, highlight=False, color_system=None)
    with console.capture() as capture:
        console.print(table)
    return "\n".join(line.rstrip() for line in capture.get().splitlines())


def _frames(comparison: Comparison) -> str:
    counts = {len(it.curves.t) for it in comparison.outcomes if it.curves}
    if not counts:
        return "no frame"
    least, most = min(counts), max(counts)
    return f"{most} frames" if least == most else f"{least} to {most} frames"


def _said(value: Any, form: str) -> str:
    return "-" if value is None else form.format(value)
