"""Pictures of a comparison with matplotlib: error over cost and step, violation and energy over time."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from linkwork.comparison.runs import WRONG, Outcome
from linkwork.plots.figures import COLORS, check_picture, literal, new_figure, written

if TYPE_CHECKING:
    from linkwork.comparison.table import Comparison

__all__ = ["KINDS", "plot"]

#: Beyond so many methods the legend says that the others are left out.
METHODS = 14
DASHES = ("-", "--", ":", "-.")
MARKERS = "os^Dv<>pPX*hd8"


def plot(comparison: Comparison, kind: str, path: str | os.PathLike[str] | None = None) -> Figure:
    """One picture, and its file. See Comparison.plot."""
    check_picture(kind, path, KINDS)
    figure = new_figure(9.0, 4.8)
    ax = figure.subplots()
    KINDS[kind](ax, comparison)
    _dress(ax, comparison)
    if path is not None:
        written(figure, path, dpi=130)
    return figure


def _work_precision(ax: Axes, comparison: Comparison) -> None:
    """State error over cost, the best at the lower left; no smaller than that of the reference."""
    for cells, style in _methods(comparison):
        known = [(comparison.cost(it), comparison.known_error(it, "state_error")) for it in cells]
        points = sorted((cost, error) for cost, error in known if cost and error)
        ax.loglog([cost for cost, _ in points], [error for _, error in points], **style)
    _mark_reference(ax, comparison)
    ax.set(xlabel="evaluations x the least time of one [s]", ylabel="state error, largest over time")


def _order(ax: Axes, comparison: Comparison) -> None:
    """Pose error over the step, as `order` observes it: a line of slope p for a method of order p."""
    studies = {study.label: study for study in comparison.studies}
    for cells, style in _methods(comparison):
        study = studies.get(cells[0].label)
        points = [(it.step, it.pose_error) for it in cells if it.pose_error and it.step]
        if study is not None:
            found = zip(study.steps, study.errors["pose_error"], strict=True)
            points = [(step, error) for step, error in found if error and error < WRONG]
        ax.loglog([step for step, _ in points], [error for _, error in points], **style)
    _slopes(ax)
    ax.set(
        xlabel="step [s]", ylabel=f"pose error, {'early in the motion' if studies else 'largest over time'}"
    )


def _violation(ax: Axes, comparison: Comparison) -> None:
    """Of positions, each method with its smallest step or tolerance."""
    _over_time(ax, comparison, lambda curves: [level[0] for level in curves.violation])
    ax.set_ylabel("largest violation of the position constraints [m or 1]")


def _energy(ax: Axes, comparison: Comparison) -> None:
    _over_time(ax, comparison, lambda curves: curves.energy_error)
    ax.set_ylabel("energy error, absolute [J]")


def _error(ax: Axes, comparison: Comparison) -> None:
    _over_time(ax, comparison, lambda curves: curves.state_error)
    _mark_reference(ax, comparison)
    ax.set_ylabel("state error")


#: By the names that `Comparison.plot` takes.
KINDS: dict[str, Callable[[Axes, Comparison], None]] = {
    "work_precision": _work_precision,
    "order": _order,
    "violation": _violation,
    "energy": _energy,
    "error": _error,
}


def _over_time(ax: Axes, comparison: Comparison, values: Callable[[Any], Sequence[float]]) -> None:
    for cells, style in _methods(comparison):
        finest = next((it for it in reversed(cells) if it.curves), None)
        if finest is None or finest.curves is None:
            continue
        magnitude = np.abs(np.asarray(values(finest.curves), dtype=float))
        style = {**style, "marker": "", "label": literal(f"{finest.label}, {finest.resolution}")}
        ax.semilogy(finest.curves.t, np.where(magnitude > 0, magnitude, np.nan), **style)
    ax.set_xlabel("time [s]")


def _methods(comparison: Comparison) -> list[tuple[list[Outcome], dict[str, Any]]]:
    """The cells of each method that finished, and how its line looks: the same in every picture."""
    out = []
    for place, cells in enumerate(list(comparison.methods.values())[:METHODS]):
        finished = [it for it in cells if it.status == "finished"]
        style = {
            "color": COLORS[place % len(COLORS)],
            "ls": DASHES[place // len(COLORS) % len(DASHES)],
            "marker": MARKERS[place % len(MARKERS)],
            "ms": 4.5,
            "lw": 1.3,
            "label": literal(cells[0].label),
        }
        if finished:
            out.append((finished, style))
    return out


def _mark_reference(ax: Axes, comparison: Comparison) -> None:
    """Below this line errors cannot be told from that of the reference; shown where they are near it."""
    error = (comparison.reference.error or {}).get("state_error", 0.0)
    if ax.lines and ax.get_ylim()[0] < 10 * error:
        ax.axhline(error, color="0.6", lw=0.8, ls="--", label="error of the reference")


def _slopes(ax: Axes) -> None:
    """Orders 1, 2 and 4 as lines through the upper right corner."""
    if not ax.lines:
        return
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    for order in (1, 2, 4):
        ends = np.array([max(left, right * (bottom / top) ** (1 / order)), right])
        ax.plot(ends, top * (ends / right) ** order, color="0.85", lw=0.8, zorder=0)
        end = max(ends[0] * 1.15, left)
        ax.annotate(
            f"order {order}", (end, top * (end / right) ** order), color="0.5", fontsize=7, va="bottom"
        )
    ax.set(xlim=(left, right), ylim=(bottom, top))


def _dress(ax: Axes, comparison: Comparison) -> None:
    ax.grid(True, which="major", color="0.92", lw=0.6)
    ax.set_axisbelow(True)
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(which="both", labelsize=8)
    name = comparison.manifest.get("model") or "model"
    ax.set_title(literal(f"{name}, 0 to {comparison.t_end:g} s"), fontsize=10, loc="left")
    if ax.get_legend_handles_labels()[1]:
        left_out = len(comparison.methods) - METHODS
        title = f"{left_out} methods more are not shown" if left_out > 0 else None
        ax.legend(fontsize=7, frameon=False, loc="upper left", bbox_to_anchor=(1.0, 1.0), title=title,
                  title_fontsize=7)  # fmt: skip
    else:
        ax.text(0.5, 0.5, "nothing to show", transform=ax.transAxes, ha="center", color="0.5")
