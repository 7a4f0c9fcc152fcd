"""Pictures of a study with matplotlib: scatter matrix, histograms, bands over time, surfaces, tornado."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import OptionError, counted, nearest, warn
from linkwork.plots.figures import COLORS, check_picture, literal, new_figure, style, written

if TYPE_CHECKING:
    from linkwork.studies.study import Study

__all__ = ["KINDS", "Column", "Swing", "check_possible", "numbers_of", "plot", "swings"]

#: Columns of a scatter matrix, panels of the other pictures; the title tells what is left out.
COLUMNS, PANELS = 6, 6

#: The part of a sample [%] that the tornado moves a parameter over, and that the bands hold.
LOW, HIGH = 5.0, 95.0

FAILED = "#d55e00"

NO_BANDS = "plot 'bands': no output is an array over time: give one without .max, and times="

#: Numbers are the same within this, relative to the largest. And bins of a histogram.
SAME, MOST_BINS = 1e-12, 60

#: Intervals between the ticks of an axis, and bars that a tornado has room for, and has at most.
TICKS, FEWEST_BARS, BARS = 5, 4, 12


@dataclass(frozen=True)
class Column:
    """A number of each case."""

    name: str
    unit: str
    values: Floats  # (n,)

    @property
    def label(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def drawn(self) -> str:
        """The label in a picture."""
        return literal(self.label)


@dataclass(frozen=True)
class Swing:
    """What a parameter does to an output by the linear fit to all cases.

    change       of the output, while the parameter goes from the 5th to the 95th percentile of its values
    explained    share of the output's variance that the fit with all parameters explains, 0 to 1
    """

    parameter: str
    change: float
    explained: float


def plot(
    study: Study,
    kind: str,
    path: str | os.PathLike[str] | None = None,
    *,
    outputs: str | Sequence[str] | None = None,
    parameters: str | Sequence[str] | None = None,
) -> Figure:
    """See Study.plot."""
    check_picture(kind, path, KINDS)
    if not (study.status == "finished").any():
        raise OptionError("study: no case has finished, so that there is nothing to draw", code="outputs")
    chosen = _chosen("output", study.outputs, outputs), _chosen("parameter", study.parameters, parameters)
    return written(KINDS[kind](study, *chosen), path)


def check_possible(kind: str, parameters: int, times: object) -> None:
    """OptionError, before a study: it would have nothing for this picture."""
    if kind == "bands" and times is None:
        raise OptionError(NO_BANDS, code="outputs")
    if kind == "surface" and parameters < 2:
        raise OptionError(
            f"plot 'surface': needs two parameters, and the study has {parameters}; use 'scatter'",
            code="outputs",
        )


def _chosen(what: str, known: Mapping[str, object], names: str | Sequence[str] | None) -> list[str]:
    """OptionError: a name that the study does not have."""
    if names is None:
        return list(known)
    wanted = [names] if isinstance(names, str) or not isinstance(names, Sequence) else list(names)
    for name in wanted:
        if name not in known:
            raise OptionError(
                f"{what} '{name}' is none of this study{nearest(str(name), known)}", code="outputs"
            )
    return wanted


def _columns(study: Study, values: Mapping[str, NDArray[np.float64]], names: Sequence[str]) -> list[Column]:
    """Numbers, one a case; of arrays each component. What is no number, or goes over time, has none."""
    found = []
    for name in names:
        array = np.asarray(values[name])
        if name in study.over_time or array.dtype.kind not in "biuf":
            continue
        for place in np.ndindex(array.shape[1:]):
            label = name + "".join(f"[{k}]" for k in place)
            column = array[(slice(None), *place)].astype(float)
            found.append(Column(label, study.units.get(name, ""), column))
    return found


def numbers_of(study: Study) -> list[Column]:
    """Parameters, then outputs, of which there is a number a case that is not the same in all."""
    both = (study.parameters, list(study.parameters)), (study.outputs, list(study.outputs))
    return [column for values, names in both for column in _moving(_columns(study, values, names))]


def _moving(columns: Sequence[Column], cases: NDArray[np.bool_] | None = None) -> list[Column]:
    """Those that are not the same in every one of the cases (all), but for roundoff."""
    of_cases = [(it, it.values if cases is None else it.values[cases]) for it in columns]
    finite = [(it, values[np.isfinite(values)]) for it, values in of_cases]
    return [it for it, values in finite if len(values) and np.ptp(values) > SAME * np.abs(values).max()]


def _bins(values: Floats) -> int:
    """As many as show how the middle half is spread (Freedman and Diaconis), but no more than can be seen."""
    low, high = map(float, np.percentile(values, [25, 75]))
    wide = 2 * (high - low) / math.cbrt(len(values))
    fewest = math.ceil(math.log2(len(values)) + 1)
    span = float(np.ptp(values))
    return MOST_BINS if wide * MOST_BINS < span else max(fewest, math.ceil(span / wide))


def _needed(columns: list[Column], what: str, count: int = 1) -> list[Column]:
    """OptionError: fewer than the picture is made of."""
    if len(columns) < count:
        raise OptionError(
            f"plot: needs {count} {what} that are numbers and not the same in all finished cases, "
            f"there are {len(columns)}",
            code="outputs",
        )
    return columns


def _title(study: Study, what: str, shown: int, total: int) -> str:
    failed = int((study.status == "failed").sum())
    parts = [what, f"{int((study.status == 'finished').sum())} cases"]
    parts += [f"{failed} failed"] if failed else []
    parts += [f"the first {shown} of {total} shown"] if shown < total else []
    words = _words(study)
    parts += (
        [f"without {' and '.join(words)}, no {'number' if len(words) == 1 else 'numbers'}"] if words else []
    )
    return literal(", ".join(parts))


def _words(study: Study) -> list[str]:
    """Parameters that are no numbers, and not the same in all cases: no picture shows them."""
    return [name for name, values in study.parameters.items()
            if values.dtype.kind not in "biuf" and len(set(values.tolist())) > 1]  # fmt: skip


def _missing(study: Study, column: Column) -> str:
    """How many of the finished cases a panel cannot show, on a line of its own."""
    count = int(((study.status == "finished") & ~np.isfinite(column.values)).sum())
    return f"\n{counted(count, 'case')} without a number" if count else ""


def _panels(count: int) -> tuple[Figure, list[Axes]]:
    across = min(count, 3)
    down = -(-count // across)
    figure = new_figure(4.2 * across + 0.6, 3.3 * down + 0.6)
    axes = list(np.atleast_1d(figure.subplots(down, across)).flat)
    for spare in axes[count:]:
        spare.remove()
    return figure, axes[:count]


# --- the kinds ---


def _scatter(study: Study, outputs: list[str], parameters: list[str]) -> Figure:
    """Each column over each other, its own distribution on the diagonal; crosses are cases that failed."""
    all_columns = _moving(_columns(study, study.parameters, parameters))
    all_columns += _moving(_columns(study, study.outputs, outputs))
    columns = _needed(all_columns, "columns", 2)[:COLUMNS]
    count = len(columns)
    figure = new_figure(1.9 * count + 1.0, 1.7 * count + 0.8)
    axes = figure.subplots(count, count, squeeze=False)
    failed = study.status == "failed"
    for row, upright in enumerate(columns):
        for place, flat in enumerate(columns):
            ax = axes[row, place]
            if row == place:
                values = flat.values[np.isfinite(flat.values)]
                ax.hist(values, bins=_bins(values), color=COLORS[0])
            else:
                ax.plot(flat.values[~failed], upright.values[~failed], ".", ms=3, color=COLORS[0])
                ax.plot(flat.values[failed], upright.values[failed], "x", ms=4, color=FAILED)
            ax.tick_params(labelsize=6)
            ax.spines[["top", "right"]].set_visible(False)
            if row == count - 1:
                ax.set_xlabel(flat.drawn, fontsize=7)
            if place == 0:
                ax.set_ylabel(upright.drawn, fontsize=7)
    figure.suptitle(_title(study, "scatter matrix", count, len(all_columns)), fontsize=10)
    return figure


def _histogram(study: Study, outputs: list[str], parameters: list[str]) -> Figure:
    """Each output's distribution, with its median and the band that holds nine of ten cases."""
    found = _needed(_moving(_columns(study, study.outputs, outputs)), "outputs")
    figure, axes = _panels(min(len(found), PANELS))
    for ax, column in zip(axes, found, strict=False):
        values = column.values[np.isfinite(column.values)]
        low, middle, high = np.percentile(values, [LOW, 50, HIGH])
        style(ax, "cases")
        ax.hist(values, bins=_bins(values), color=COLORS[0], alpha=0.8)
        for at, dash in ((low, "--"), (middle, "-"), (high, "--")):
            ax.axvline(at, color="black", ls=dash, lw=1)
        ax.set_xlabel(column.drawn, fontsize=9)
        ax.locator_params(axis="x", nbins=TICKS)
        told = f"median {middle:.4g}; {LOW:g} % below {low:.4g}, {LOW:g} % above {high:.4g}"
        ax.set_title(told + _missing(study, column), fontsize=8)
    figure.suptitle(_title(study, "distribution", len(axes), len(found)), fontsize=10)
    return figure


def _bands(study: Study, outputs: list[str], parameters: list[str]) -> Figure:
    """Outputs over time: median, the middle half and nine tenths of the cases, and the extremes."""
    names, times = [name for name in outputs if name in study.over_time], study.times
    if not names or times is None:
        raise OptionError(NO_BANDS, code="outputs")
    pieces = [(name, place) for name in names for place in np.ndindex(study.outputs[name].shape[2:])]
    figure, axes = _panels(min(len(pieces), PANELS))
    for ax, (name, place) in zip(axes, pieces, strict=False):
        values = study.outputs[name][(slice(None), slice(None), *place)]
        values = np.where(np.isfinite(values), values, np.nan)
        known = ~np.isnan(values)
        if not known.any():
            raise OptionError(f"plot 'bands': output '{name}' has no number in any case", code="outputs")
        edges = np.full((7, len(times)), np.nan)  # cases count at each time that they reach
        edges[:, known.any(axis=0)] = np.nanpercentile(
            values[:, known.any(axis=0)], [0, LOW, 25, 50, 75, HIGH, 100], axis=0
        )
        least, low, quarter, middle, most, high, largest = edges
        unit = study.units.get(name, "")
        style(ax, literal(name + "".join(f"[{k}]" for k in place) + (f" [{unit}]" if unit else "")))
        if short := int((known.any(axis=1) & ~known.all(axis=1)).sum()):
            ax.set_title(f"{counted(short, 'case')} not at all times", fontsize=8)
        ax.fill_between(times, low, high, color=COLORS[0], alpha=0.2, lw=0, label="9 of 10")
        ax.fill_between(times, quarter, most, color=COLORS[0], alpha=0.35, lw=0, label="half")
        ax.plot(times, middle, color=COLORS[0], label="median")
        for edge in (least, largest):
            ax.plot(times, edge, color="0.4", lw=0.7, ls=":", label="extremes" if edge is least else None)
        ax.set_xlabel("time [s]", fontsize=9)
    axes[0].legend(fontsize=7, frameon=False)
    figure.suptitle(_title(study, "bands over time", len(axes), len(pieces)), fontsize=10)
    return figure


def _surface(study: Study, outputs: list[str], parameters: list[str]) -> Figure:
    """Outputs over two parameters, between the cases by triangles; the mean of cases at one point."""
    from matplotlib.tri import Triangulation

    finished = study.status == "finished"
    over = _needed(_moving(_columns(study, study.parameters, parameters), finished), "parameters", 2)
    x, y = over[:2]
    found = _needed(_moving(_columns(study, study.outputs, outputs)), "outputs")
    figure, axes = _panels(min(len(found), PANELS))
    for ax, column in zip(axes, found, strict=False):
        known = np.isfinite(column.values)
        try:
            points, means = _at_points(x.values[known], y.values[known], column.values[known])
            filled = ax.tricontourf(Triangulation(*points.T), means, levels=14, cmap="viridis")
        except (ValueError, RuntimeError) as error:
            raise OptionError(
                f"plot 'surface': the {int(known.sum())} cases do not span '{x.name}' and '{y.name}'",
                code="outputs",
            ) from error
        figure.colorbar(filled, ax=ax).ax.tick_params(labelsize=7)
        ax.plot(x.values[known], y.values[known], ".", ms=2, color="black", alpha=0.5)
        ax.plot(x.values[~known], y.values[~known], "x", ms=4, color=FAILED)
        ax.set_title(column.drawn + _missing(study, column), fontsize=9)
        ax.set_xlabel(x.drawn, fontsize=8)
        ax.set_ylabel(y.drawn, fontsize=8)
        ax.tick_params(labelsize=7)
    every = _columns(study, study.parameters, list(study.parameters))
    count = len(_moving(every, finished)) - 2 + len(_words(study))
    others = (
        f", in which {counted(count, 'other parameter')} {'varies' if count == 1 else 'vary'}"
        if count
        else ""
    )
    figure.suptitle(_title(study, f"response surface{others}", len(axes), len(found)), fontsize=10)
    return figure


def _at_points(x: Floats, y: Floats, values: Floats) -> tuple[Floats, Floats]:
    """(m, 2) points that differ and the means (m,) of the values there."""
    points, place = np.unique(np.column_stack([x, y]), axis=0, return_inverse=True)
    place = place.ravel()
    return points, np.bincount(place, weights=values) / np.bincount(place)


def _tornado(study: Study, outputs: list[str], parameters: list[str]) -> Figure:
    """What each parameter does to each output while the others stay, the strongest on top.

    Parameters that are not drawn are in the fit, too, or what they do would be told of those that are.
    """
    found = _needed(_moving(_columns(study, study.outputs, outputs)), "outputs")
    drawn = _needed(_moving(_columns(study, study.parameters, parameters)), "parameters")
    moved = _moving(_columns(study, study.parameters, list(study.parameters)))
    names = {it.name for it in drawn}
    figure, axes = _panels(min(len(found), PANELS))
    for ax, column in zip(axes, found, strict=False):
        swung = _swings(moved, column, "plot 'tornado'")
        bars = sorted((it for it in swung if it.parameter in names), key=lambda it: abs(it.change))[-BARS:]
        for place, bar in enumerate(bars):
            ax.barh(place, bar.change, color=COLORS[0] if bar.change >= 0 else COLORS[1])
        ax.axvline(0.0, color="black", lw=0.8)
        middle, half = (len(bars) - 1) / 2, max(len(bars), FEWEST_BARS) / 2
        ax.set_yticks(range(len(bars)), [literal(bar.parameter) for bar in bars], fontsize=7)
        ax.set_ylim(middle - half, middle + half)
        ax.locator_params(axis="x", nbins=TICKS)
        ax.set_xlabel(f"change of {column.drawn}", fontsize=8)
        told = f"a linear fit explains {100 * swung[0].explained:.3g} % of the variance"
        same = _left_out(drawn, swung)
        told += f"\nwithout {literal(same)}, the same in these cases" if same else ""
        ax.set_title(told + _missing(study, column), fontsize=8)
        ax.tick_params(labelsize=7)
        ax.spines[["top", "right"]].set_visible(False)
    few = f"the {BARS} strongest of {len(drawn)} " if len(drawn) > BARS else ""
    what = f"{few}parameters from their {LOW:g}th to their {HIGH:g}th percentile"
    figure.suptitle(_title(study, what, len(axes), len(found)), fontsize=10)
    return figure


def swings(study: Study, output: str) -> list[Swing]:
    """See Study.swings."""
    (name,) = _chosen("output", study.outputs, output)
    found = _needed(_moving(_columns(study, study.outputs, [name])), "outputs")
    moved = _needed(_moving(_columns(study, study.parameters, list(study.parameters))), "parameters")
    if len(found) > 1:
        raise OptionError(f"output '{output}' is {len(found)} numbers a case, not one", code="outputs")
    swung = _swings(moved, found[0], "swings")
    same = _left_out(moved, swung)
    if same:
        warn(f"swings: without {same}, the same in all cases that have '{output}'")
    return sorted(swung, key=lambda it: -abs(it.change))


def _left_out(parameters: Sequence[Column], swung: Sequence[Swing]) -> str:
    fitted = {it.parameter for it in swung}
    return ", ".join(f"'{it.name}'" for it in parameters if it.name not in fitted)


def _swings(parameters: Sequence[Column], output: Column, wanted: str) -> list[Swing]:
    """By least squares on all finished cases, of parameters that are not the same in these.

    wanted  begins an error
    OptionError: fewer cases than the fit has numbers, or no such parameter.
    """
    known = np.isfinite(output.values) & np.all([np.isfinite(it.values) for it in parameters], axis=0)
    y = output.values[known]
    moved = _moving([replace(it, values=it.values[known]) for it in parameters])
    if len(y) <= len(moved) + 1:
        raise OptionError(
            f"{wanted}: {counted(len(y), 'finished case')} {'is' if len(y) == 1 else 'are'} too few for "
            f"{counted(len(moved), 'parameter')}",
            code="outputs",
        )
    if not moved:
        raise OptionError(
            f"{wanted}: in all {len(y)} finished cases the parameters are the same", code="outputs"
        )
    X = np.column_stack([it.values for it in moved])
    center, spread = X.mean(axis=0), X.std(axis=0)
    slopes, _, rank, _ = np.linalg.lstsq((X - center) / spread, y - y.mean(), rcond=1e-10)
    if rank < len(moved):
        raise OptionError(
            f"{wanted}: parameters move together in these cases, so that their effects cannot be told apart",
            code="outputs",
        )
    left = y - y.mean() - (X - center) / spread @ slopes
    explained = 1.0 - float(left @ left) / float((y - y.mean()) @ (y - y.mean()))
    low, high = np.percentile(X, [LOW, HIGH], axis=0)
    changes = slopes * (high - low) / spread
    return [Swing(it.name, float(change), explained)
            for it, change in zip(moved, changes, strict=True)]  # fmt: skip


KINDS: Mapping[str, Callable[[Study, list[str], list[str]], Figure]] = {
    "scatter": _scatter, "histogram": _histogram, "bands": _bands, "surface": _surface, "tornado": _tornado,
}  # fmt: skip
