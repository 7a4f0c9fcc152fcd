"""Pictures of results with matplotlib. Each function returns its Figure and leaves pyplot's state alone."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from linkwork.arguments import check_suffix, one_of
from linkwork.arguments import path as path_of
from linkwork.arrays import Floats
from linkwork.errors import FileError, OptionError, nearest
from linkwork.options import LEVELS
from linkwork.replacement import replacing

if TYPE_CHECKING:
    from linkwork.results.result import Result

#: The most lines of one kind in one picture.
BODIES, JOINTS = 3, 4

#: So many chosen bodies or joints can be told apart in a picture; and rows of a legend that it has room for,
#: and the height of each of the others [in].
MOST, LEGEND_ROWS, ROW_HEIGHT = 20, 3, 0.19

#: Pixels of an inch in a notebook.
DPI = 80

#: Frames looked at to choose the bodies and joints that tell the most.
SAMPLED_FRAMES = 50

#: Okabe and Ito's colors: distinguishable with any color vision.
COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
LINES = ("-", "-", "-", (0, (5, 3)), "-")
COORDINATES = (("x", "-"), ("y", "--"), ("z", ":"))


def plot(result: Result, bodies: Sequence[int] = (), joints: Sequence[int] = ()) -> Figure:
    """Energies, energy error, violation, positions and reactions of one run.

    Of many bodies the three that move the most are shown, of many joints the four with the largest forces or
    torques: the legends say so. Or those that are chosen.
    """
    figure = new_figure(10.5, 9.0)
    axes = figure.subplots(3, 2, sharex=True)
    plot_energies(axes[0, 0], result)
    plot_energy_error(axes[0, 1], result)
    plot_positions(axes[1, 0], result, bodies)
    plot_violation(axes[1, 1], result)
    plot_reactions(axes[2, 0], result, "force", "N", joints)
    plot_reactions(axes[2, 1], result, "torque", "N m", joints)
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
    return figure


def plot_methods(
    results: Mapping[str, Result], path: str | os.PathLike[str] | None = None, title: str = ""
) -> Figure:
    """Several runs of one model: its motion, and each method's violation and energy error over time."""
    figure = new_figure(12.0, 4.3)
    grid = figure.add_gridspec(1, 3, width_ratios=(0.85, 1, 1))
    _draw_motion(figure.add_subplot(grid[0], projection="3d"), next(iter(results.values())))
    left, right = figure.add_subplot(grid[1]), figure.add_subplot(grid[2])
    for order, (label, result) in enumerate(results.items()):
        line: dict[str, Any] = {
            "color": COLORS[order % len(COLORS)],
            "ls": LINES[order % len(LINES)],
            "lw": 1.4,
            "label": literal(label),
        }
        left.plot(result.t, magnitudes(result.violation[:, 0]), **line)
        right.plot(result.t, magnitudes(result.energy_error), **line)
    for ax, quantity in (
        (left, "largest violation of the constraints [m or 1]"),
        (right, "energy error [J]"),
    ):
        style(ax, quantity)
        log_scale(ax)
        ax.set_xlabel("time [s]")
    handles, labels = left.get_legend_handles_labels()
    figure.legend(
        handles, labels, loc="outside lower center", ncols=min(len(results), 5), frameon=False, fontsize=9
    )
    figure.suptitle(literal(title), fontsize=11)
    return written(figure, path)


def _draw_motion(ax: Any, result: Result, poses: int = 8) -> None:
    """The mechanism as lines between the joints of each body, on 3-D axes; dark at the start, then faint."""
    points = np.stack([result.joint_points(j) for j in range(len(result.joint_names))], axis=1)
    shown = np.linspace(0, len(result) - 1, poses + 1).astype(int)[:-1]
    for order, k in enumerate(shown[::-1]):
        alpha = 1.0 if k == 0 else 0.15 + 0.25 * order / poses
        for body, color in enumerate(colors(len(result.body_names))):
            own = np.concatenate(
                [points[k, result.header.joint_bodies[:, side] == body, side] for side in (0, 1)]
            )
            ax.plot(*own.T, color=color, alpha=alpha, lw=2.5 if k == 0 else 1.2, solid_capstyle="round")
    for j in range(points.shape[1]):
        ax.plot(*points[:, j, 1].T, color="0.75", lw=0.6, zorder=0)
        ax.plot(*points[:1, j, 1].T, color="black", marker="o", ms=3)
    middle, half = (
        (points.max((0, 1, 2)) + points.min((0, 1, 2))) / 2,
        np.ptp(points, axis=(0, 1, 2)).max() / 2,
    )
    for axis, center in zip("xyz", middle, strict=True):
        ax.set(**{f"{axis}lim": (center - half, center + half)})
    ax.set_box_aspect((1, 1, 1), zoom=1.35)
    ax.view_init(20, -65)
    ax.set_axis_off()


def plot_energies(ax: Axes, result: Result) -> None:
    style(ax, "energy [J]")
    ax.plot(result.t, result.kinetic_energy, color=COLORS[0], label="kinetic")
    ax.plot(result.t, result.potential_energy, color=COLORS[1], label="potential")
    ax.plot(result.t, result.energy, color=COLORS[6], label="total")
    plot_band(ax, result, result.energy, COLORS[6], lambda: result.error_of("energy"))
    if np.any(result.work):
        ax.plot(result.t, result.work, color=COLORS[2], ls="--", label="work of other forces")
    legend(ax)


def plot_energy_error(ax: Axes, result: Result) -> None:
    style(ax, "energy error, absolute [J]")
    ax.plot(result.t, magnitudes(result.energy_error), color=COLORS[6])
    log_scale(ax)


def plot_violation(ax: Axes, result: Result) -> None:
    style(ax, "largest violation of constraints")
    for level, (label, color) in enumerate(zip(LEVELS, COLORS, strict=False)):
        ax.plot(result.t, magnitudes(result.violation[:, level]), color=color, label=label)
    log_scale(ax)
    legend(ax)


def plot_positions(ax: Axes, result: Result, bodies: Sequence[int] | None = None) -> None:
    """Color tells the body, line style the coordinate; coordinates that hardly change are left out."""
    style(ax, "center of mass [m]")
    chosen = bodies or largest_places(travel_of(result), BODIES)
    positions = {result.body_names[i]: result.body(i).position for i in chosen}
    most = max((np.ptp(p, axis=0).max() for p in positions.values()), default=0.0)
    for color, (name, position) in zip(colors(len(positions)), positions.items(), strict=True):
        for axis in telling(np.ptp(position, axis=0), 0.02 * most, bool(bodies)):
            coordinate, line = COORDINATES[axis]
            label = literal(f"{name}  {coordinate}")
            ax.plot(result.t, position[:, axis], color=color, ls=line, label=label)
            plot_band(ax, result, position[:, axis], color, partial(_position_error, result, name, axis))
    which = "" if bodies else share(len(chosen), len(result.body_names), "bodies, those that move most")
    legend(ax, which)


def telling(sizes: Floats, least: float, always: bool) -> list[int]:
    """Components that are not small (3,); or, of what was chosen, the largest."""
    found = np.flatnonzero(sizes >= least).tolist()
    return found or [int(np.argmax(sizes))] * always


def plot_reactions(
    ax: Axes, result: Result, part: str, unit: str, joints: Sequence[int] | None = None
) -> None:
    """Magnitudes of one part, "force" or "torque", of the joints' reactions; dashed where not unique."""
    style(ax, f"reaction {part} [{unit}]")
    sample = result.sampled_reactions(max(1, len(result) // SAMPLED_FRAMES))
    largest = np.linalg.norm(getattr(sample, part), axis=-1).max(axis=0, initial=0.0)
    rounding = 1e-9 * max(np.abs(sample.force).max(initial=0.0), np.abs(sample.torque).max(initial=0.0))
    chosen = joints or [j for j in largest_places(largest, JOINTS) if largest[j] > rounding]
    for color, j in zip(colors(len(chosen)), chosen, strict=True):
        magnitude = np.linalg.norm(getattr(result.reaction(j), part), axis=-1)
        doubt = "" if result.unique_reactions[j] else " (not unique)"
        line = "--" if doubt else "-"
        label = literal(f"{result.joint_names[j]}{doubt}")
        ax.plot(result.t, magnitude, color=color, ls=line, label=label)
        plot_band(ax, result, magnitude, color, partial(_reaction_error, result, j, part))
    if not chosen:
        write_none(ax)
    which = (
        ""
        if joints
        else share(len(chosen), len(result.joint_names), f"joints, those with the largest {part}")
    )
    legend(ax, which)


def write_none(ax: Axes) -> None:
    """Where there is nothing to draw."""
    ax.set_yticks([])
    ax.text(0.5, 0.5, "none", transform=ax.transAxes, ha="center", color="0.5")


def plot_band(ax: Axes, result: Result, values: Floats, color: str, error: Callable[[], Floats]) -> None:
    """Where the values may be, of a run that was verified."""
    if result.verified:
        reach = error()
        ax.fill_between(result.t, values - reach, values + reach, color=color, alpha=0.25, lw=0)


def _position_error(result: Result, body: str, axis: int) -> Floats:
    found: Floats = result.error_of("body", body).position[:, axis]
    return found


def _reaction_error(result: Result, joint: int, part: str) -> Floats:
    found: Floats = np.linalg.norm(getattr(result.error_of("reaction", joint), part), axis=-1)
    return found


def travel_of(result: Result) -> Floats:
    """Longest side of the box that each body's center of mass moves in (n,) [m], from a sample of frames."""
    every = max(1, len(result) // SAMPLED_FRAMES)
    positions = result.sampled_positions(every)
    travel: Floats = (
        np.ptp(positions, axis=0).max(axis=-1) if len(positions) else np.zeros(positions.shape[1])
    )
    return travel


def largest_places(values: Floats, count: int) -> Sequence[int]:
    """Places of the `count` largest values, in the order of the model."""
    return sorted(int(i) for i in np.argsort(-values, kind="stable")[:count])


def share(shown: int, total: int, which: str) -> str:
    return f"{shown} of {total} {which}" if 0 < shown < total else ""


def literal(text: str) -> str:
    """Names as matplotlib draws them letter by letter: no formula between dollars, and in the legend, too,
    where it leaves out what begins with an underscore."""
    hidden = "\N{ZERO WIDTH SPACE}" if text.startswith("_") else ""
    return hidden + text.replace("$", r"\$")


def title_of(result: Result) -> str:
    manifest = result.manifest
    options = manifest.get("options", {})
    words = (
        manifest.get("model"),
        *(options.get(key) for key in ("formulation", "stabilization", "integrator")),
    )
    step = f"step {options['step']:g} s" if options.get("step") else None
    return literal(", ".join(str(word) for word in (*words, step) if word))


def magnitudes(values: Floats) -> Floats:
    """Magnitudes for a logarithmic axis, where zero has no place."""
    magnitude: Floats = np.abs(values)
    return np.where(magnitude > 0, magnitude, np.nan)


def log_scale(ax: Axes) -> None:
    """A logarithmic axis; one on which nothing is to be seen says so instead."""
    if any(np.isfinite(np.asarray(line.get_ydata(), dtype=float)).any() for line in ax.lines):
        ax.set_yscale("log")
    else:
        ax.set_yticks([])
        ax.text(0.5, 0.5, "exactly zero", transform=ax.transAxes, ha="center", color="0.5")


def style(ax: Axes, quantity: str) -> None:
    ax.set_ylabel(quantity, fontsize=9)
    ax.grid(True, color="0.9", lw=0.6)
    ax.set_axisbelow(True)
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(labelsize=8)
    ax.margins(x=0)
    ax.yaxis.set_major_formatter("{x:.7g}")


def legend(ax: Axes, title: str = "") -> None:
    """Above the axes, where it hides nothing; the figure becomes higher by what a long one takes."""
    labels = ax.get_legend_handles_labels()[1]
    if labels:
        columns = max(1, min(4, 72 // (max(map(len, labels)) + 6)))
        box = ax.legend(
            title=title or None, ncols=columns, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2,
            frameon=False, fontsize=8, title_fontsize=8, alignment="left", columnspacing=1.5,
        )  # fmt: skip
        box.set_in_layout(True)
        more = -(-len(labels) // columns) - LEGEND_ROWS
        if more > 0 and isinstance(ax.figure, Figure):
            ax.figure.set_figheight(ax.figure.get_figheight() + more * ROW_HEIGHT)


def colors(count: int) -> list[str]:
    """So many, each another: of COLORS as far as they go, else along a rainbow."""
    if count <= len(COLORS):
        return list(COLORS[:count])
    return [to_hex(color) for color in colormaps["turbo"](np.linspace(0.02, 0.98, count))]


def new_figure(width: float, height: float) -> Figure:
    """A figure of its own, drawn by Agg: no window, no pyplot."""
    figure = Picture(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


class Picture(Figure):
    """A figure that a notebook shows by itself, whether or not pyplot is in use there."""

    def _repr_png_(self) -> bytes:
        out = io.BytesIO()
        self.savefig(out, format="png", dpi=DPI)
        return out.getvalue()


def check_format(path: str | os.PathLike[str]) -> None:
    """FileError, before a long run, where the name of a picture asks for a format that there is not."""
    path = path_of(path, "picture")
    known = FigureCanvasAgg(Figure()).get_supported_filetypes()
    suffix = os.path.splitext(path)[1].removeprefix(".").lower()
    if suffix and suffix not in known:
        raise FileError(
            f"picture '{path}': no format '{suffix}'{nearest(suffix, known)}", code="not_writable"
        )


def check_picture(kind: Any, path: Any, kinds: Iterable[str]) -> None:
    """Before anything is drawn, and in whichever order they were given.

    OptionError: no such kind. FileError: `path` is the name of a kind, which would be another picture in a
    file of an unexpected name, or no picture can be written to it.
    """
    known = list(kinds)
    if kind not in known and isinstance(kind, str) and os.path.splitext(kind)[1]:
        raise OptionError(
            f"plot kind '{kind}' does not exist; a file is given as path='{kind}'", code="unknown_option"
        )
    one_of(kind, known, "plot kind")
    if path is None:
        return
    name = str(check_suffix(path, "picture"))
    if name in known:
        raise FileError(
            f"picture '{name}' is the name of a kind, which kind='{name}' draws; a file that is called so is "
            f"'{name}.png'",
            code="path",
        )
    check_format(name)


def written(figure: Figure, path: str | os.PathLike[str] | None, dpi: float = 110) -> Figure:
    if path is not None:
        check_format(path)
        name = os.fspath(path_of(path, "picture"))
        named = name if os.path.splitext(name)[1].strip(".") else f"{name.rstrip('.')}.png"
        with replacing(named, "picture") as beside:
            figure.savefig(beside, dpi=dpi)
    return figure
