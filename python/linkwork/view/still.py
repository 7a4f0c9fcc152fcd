"""A picture of one pose: bodies with their names, inertial axes, and in red the joints that do not hold."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.plots.figures import literal, new_figure, written
from linkwork.view.movie import Painter

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from linkwork.results.result import Result

SIZE = (960, 640)  #: [pixels]

#: How many bodies have their names in the picture.
NAMED = 40

#: Color of joints that do not hold.
LOOSE = "#c62828"


def plot(result: Result, path: str | os.PathLike[str] | None = None) -> Figure:
    """The first frame. FileError: `path` cannot be written. OptionError: too much to paint."""
    painter = Painter(result, SIZE)
    figure = new_figure(SIZE[0] / 100, SIZE[1] / 100)
    figure.set_layout_engine("none")
    ax = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    ax.set_axis_off()
    ax.imshow(painter.picture(float(result.t[0])), extent=(0, SIZE[0], SIZE[1], 0), aspect="auto")
    _axes(ax, painter)
    if len(result.body_names) <= NAMED:
        places = painter.projected(result.recorded("q", np.s_[0, :, :3]))
        for name, place in zip(result.body_names, places, strict=True):
            ax.annotate(
                literal(name), place, fontsize=8, color="0.25", ha="center", va="center", bbox=_paper()
            )
    loose = result.manifest.get("loose", {})
    for joint, text in loose.items():
        place = painter.projected(result.joint_points(joint)[0])
        ax.plot(*place.T, color=LOOSE, marker="o", ms=5, lw=1.6, zorder=5)
        words = literal(f"{result.joint_names[joint]}: {text}")
        ax.annotate(words, place.mean(axis=0), xytext=(8, 8), textcoords="offset points", fontsize=8,
                    color=LOOSE, bbox=_paper(), zorder=6)  # fmt: skip
    said = f"; {len(loose)} joint{'s' if len(loose) > 1 else ''} not held" if loose else ""
    name = literal(result.manifest["model"].replace("_", " "))
    figure.suptitle(f"{name}: initial pose{said}", fontsize=11)
    return written(figure, path)


def _axes(ax: Axes, painter: Painter) -> None:
    """x, y, z in the lower left corner, and a length to compare with, as far away as the middle."""
    length = 0.055 * SIZE[0]
    corner = np.array([1.3 * length, SIZE[1] - 1.3 * length])
    for axis, color in zip(range(3), ("#d84040", "#3fa34d", "#3f6fd8"), strict=True):
        end = corner + length * painter.camera.axes[axis, :2] * (1, -1)
        ax.annotate("", tuple(end), tuple(corner), arrowprops={"arrowstyle": "->", "color": color, "lw": 1.6})
        beyond = corner + 1.25 * (end - corner)
        ax.text(beyond[0], beyond[1], "xyz"[axis], color=color, fontsize=9, ha="center", va="center")
    per_meter = painter.pixels_of_meter
    scale = _round(0.2 * SIZE[0] / per_meter)
    start = np.array([0.96 * SIZE[0] - scale * per_meter, 0.95 * SIZE[1]])
    ax.plot([start[0], start[0] + scale * per_meter], [start[1], start[1]], color="0.35", lw=2)
    ax.text(start[0] + scale * per_meter / 2, start[1] - 0.012 * SIZE[1], f"{scale:g} m", color="0.35",
            fontsize=9, ha="center", va="bottom")  # fmt: skip


def _round(length: float) -> float:
    """1, 2 or 5 times a power of ten, not above."""
    power = 10.0 ** np.floor(np.log10(length))
    return float(max(step * power for step in (1, 2, 5) if step * power <= length * (1 + 1e-9)))


def _paper() -> dict[str, Any]:
    return {"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none", "alpha": 0.75}
