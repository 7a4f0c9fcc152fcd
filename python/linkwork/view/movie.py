"""Movies of a run without a display: shaded faces of what the viewer shows, painted from back to front.

GIF is written by pillow, MP4 by the ffmpeg that imageio-ffmpeg brings: pip install 'linkwork[movie]'.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwork import arguments, rotation
from linkwork.arrays import Floats
from linkwork.errors import FileError, OptionError, unwritable
from linkwork.modeling.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere
from linkwork.plots.figures import new_figure
from linkwork.view.appearance import Scene, Solid, Span, scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import PolyCollection

    from linkwork.results.result import Result

#: More faces than these take minutes to paint.
MOST_FACES = 200_000

#: Direction to the light, in axes (right, up, towards the eye).
LIGHT = np.array([0.35, 0.75, 0.56])

#: Of a movie: hours of it.
MOST_PICTURES = 1_000_000

Pixels = NDArray[np.uint8]


def movie(
    result: Result,
    path: str | os.PathLike[str],
    *,
    seconds: float | None = None,
    frames_per_second: int = 25,
    size: tuple[int, int] = (960, 640),
) -> None:
    """Write a .mp4 or .gif; see `Result.movie`."""
    file = arguments.check_suffix(path, "movie")
    if file.suffix.lower() not in (".mp4", ".gif"):
        raise FileError(f"movie '{path}': is neither .mp4 nor .gif: name it so", code="format")
    if not len(result):
        raise OptionError("the result has no frames: there is nothing to film", code="empty")
    duration = float(result.t[-1] - result.t[0])
    lasts = seconds if seconds is not None else min(max(duration, 2.0), 20.0)
    good = arguments.is_number(lasts) and arguments.is_number(frames_per_second) and _is_size(size)
    if not good or not lasts > 0 or frames_per_second < 1 or not lasts * frames_per_second < MOST_PICTURES:
        raise OptionError(
            f"movie of {lasts!r:.80} s, {frames_per_second!r:.80} frames per second, {size!r:.80} pixels: "
            f"give positive times, even sizes of 32 pixels or more, and less than {MOST_PICTURES} pictures",
            code="movie",
        )
    times = result.t[0] + duration * np.linspace(0, 1, max(2, round(lasts * frames_per_second)))
    pictures = Painter(result, size).pictures(times)
    write = _write_gif if file.suffix.lower() == ".gif" else _write_mp4
    try:
        with open(file, "ab"):  # before the work, not after it
            pass
        write(file, pictures, frames_per_second, size)
    except OSError as error:
        raise unwritable("movie", path, error) from error


def _is_size(size: object) -> bool:
    """Whether it is two even whole numbers of 32 pixels or more."""
    if not isinstance(size, Sequence) or len(size) != 2:
        return False
    return all(isinstance(n, int | np.integer) and n >= 32 and n % 2 == 0 for n in size)


def _write_gif(file: Path, pictures: Iterator[Pixels], rate: int, size: tuple[int, int]) -> None:
    from PIL import Image

    images = [Image.fromarray(picture).quantize(96) for picture in pictures]
    images[0].save(
        file, format="GIF", save_all=True, append_images=images[1:], duration=round(1000 / rate), loop=0
    )


def _write_mp4(file: Path, pictures: Iterator[Pixels], rate: int, size: tuple[int, int]) -> None:
    imageio_ffmpeg = arguments.optional_package(
        "imageio_ffmpeg", "movie", f"movie '{file}'", FileError, "a .gif needs nothing"
    )
    writer = imageio_ffmpeg.write_frames(
        str(file), size, fps=rate, quality=8, macro_block_size=2, ffmpeg_log_level="error"
    )
    writer.send(None)
    for picture in pictures:
        writer.send(np.ascontiguousarray(picture))
    writer.close()


@dataclass(frozen=True)
class _Faces:
    """Polygons with as many corners each, fixed in their bodies."""

    corners: Floats  # (m, corners, 3) body coordinates
    body: NDArray[np.intp]  # (m,)
    color: Floats  # (m, 3) red, green, blue in 0 .. 1

    def placed(self, r: Floats, A: Floats) -> Floats:
        """The corners where the bodies are (m, corners, 3), inertial."""
        moved: Floats = r[self.body, None] + np.einsum("mab,mcb->mca", A[self.body], self.corners)
        return moved


@dataclass(frozen=True)
class _Stretched:
    """Polygons between a point of one body and a point of another; z of corners is 0 to 1 between them."""

    corners: Floats  # (m, corners, 3) x and y [m]
    body: NDArray[np.intp]  # (m, 2)
    ends: Floats  # (m, 2, 3) body coordinates
    color: Floats  # (m, 3)

    def placed(self, r: Floats, A: Floats) -> Floats:
        """As of faces of bodies."""
        ends = r[self.body] + np.einsum("msab,msb->msa", A[self.body], self.ends)
        along = ends[:, 1] - ends[:, 0]
        length = np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
        x = rotation.perpendicular(along / length)
        y = np.cross(along / length, x)
        moved: Floats = ends[:, :1] + np.einsum("mca,mab->mcb", self.corners, np.stack([x, y, along], axis=1))
        return moved


class Painter:
    """Draws poses of a run in parallel projection, from the side that shows the most."""

    def __init__(self, result: Result, size: tuple[int, int]) -> None:
        """OptionError: too many faces."""
        self._result, self._size = result, size
        self._faces = _faces(scene(result))
        count = sum(len(faces.body) for faces in self._faces)
        if count > MOST_FACES:
            raise OptionError(
                f"a movie of {count:,} faces would take too long (at most {MOST_FACES:,}): "
                "give the bodies simpler shapes, or use result.view()",
                code="movie",
            )
        self._axes = _eye(result)
        self._low, self._high = self._range()

    def pictures(self, times: Floats) -> Iterator[Pixels]:
        """Red, green, blue (height, width, 3) at each time."""
        width, height = self._size
        figure = new_figure(width / 100, height / 100)
        figure.set_layout_engine("none")
        figure.set_dpi(100)
        ax = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        collection = self.prepare(ax)
        text = ax.text(0.02, 0.03, "", transform=ax.transAxes, fontsize=10, color="0.35")
        for time in times:
            self.draw(collection, time)
            text.set_text(f"{time:.3f} s")
            figure.canvas.draw()
            yield np.asarray(figure.canvas.buffer_rgba())[..., :3].copy()  # type: ignore[attr-defined]

    def prepare(self, ax: Axes) -> PolyCollection:
        """Axes in meters of the picture's plane that hold everything, and what `draw` fills."""
        from matplotlib.collections import PolyCollection

        width, height = self._size
        ax.set_axis_off()
        middle, half = (self._low + self._high) / 2, (self._high - self._low) / 2
        scale = 1.08 * max(half[0] / width, half[1] / height) or 1.0
        ax.set(xlim=(middle[0] - scale * width, middle[0] + scale * width))
        ax.set(ylim=(middle[1] - scale * height, middle[1] + scale * height))
        collection = PolyCollection([], linewidths=0.4, antialiaseds=True)
        ax.add_collection(collection)
        return collection

    def draw(self, collection: PolyCollection, time: float) -> None:
        polygons, colors = self._polygons(time)
        collection.set_verts(polygons)
        collection.set(facecolor=colors, edgecolor=colors)

    def projected(self, points: Floats) -> Floats:
        """Inertial points (k, 3) in the plane of the picture (k, 2), right and up [m]."""
        seen: Floats = points @ self._axes[:, :2]
        return seen

    def _polygons(self, time: float) -> tuple[list[Floats], Floats]:
        """What faces the eye, from back to front, and its shade."""
        r, A = self._pose(time)
        polygons: list[Floats] = []
        depths, colors = [], []
        for faces in self._faces:
            seen = faces.placed(r, A) @ self._axes
            normal = np.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
            normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
            front = normal[:, 2] > 0
            shade = 0.55 + 0.45 * np.clip(normal[front] @ LIGHT, 0, 1)
            polygons += list(seen[front, :, :2])
            depths.append(seen[front, :, 2].mean(axis=1))
            colors.append(np.clip(faces.color[front] * shade[:, None], 0, 1))
        order = np.argsort(np.concatenate(depths), kind="stable")
        return [polygons[k] for k in order], np.concatenate(colors)[order]

    def _pose(self, time: float) -> tuple[Floats, Floats]:
        """Positions (n + 1, 3) and rotation matrices (n + 1, 3, 3) between two frames; the ground is last."""
        t = self._result.t
        k = int(np.clip(np.searchsorted(t, time, side="right") - 1, 0, max(len(t) - 2, 0)))
        q = self._result.recorded("q", np.s_[k : k + 2])
        span = t[min(k + 1, len(t) - 1)] - t[k]
        f = (time - t[k]) / span if span > 0 else 0.0
        sign = np.where(np.sum(q[0, :, 3:] * q[-1, :, 3:], axis=-1, keepdims=True) < 0, -1.0, 1.0)
        r = (1 - f) * q[0, :, :3] + f * q[-1, :, :3]
        p = (1 - f) * q[0, :, 3:] + f * sign * q[-1, :, 3:]
        p /= np.linalg.norm(p, axis=-1, keepdims=True)
        return np.concatenate([r, np.zeros((1, 3))]), np.concatenate([rotation.matrix(p), np.eye(3)[None]])

    def _range(self) -> tuple[Floats, Floats]:
        """Of everything that is seen, right and up [m], from a sample of frames."""
        sample = self._result.t[:: max(1, len(self._result) // 40)]
        low, high = np.full(2, np.inf), np.full(2, -np.inf)
        for time in sample:
            r, A = self._pose(float(time))
            for faces in self._faces:
                seen = faces.placed(r, A) @ self._axes[:, :2]
                low, high = np.minimum(low, seen.min((0, 1))), np.maximum(high, seen.max((0, 1)))
        return low, high


def _eye(result: Result) -> Floats:
    """Axes of the picture (3, 3): columns right, up, towards the eye, as the viewer chooses them."""
    positions = result.sampled_positions(max(1, len(result) // 40)).reshape(-1, 3)
    sides = np.ptp(positions, axis=0)
    gravity = np.asarray(result.header.gravity, float)
    flat = int(np.argmin(sides))
    level = sides[flat] < 0.25 * sides.max()
    free = np.eye(3)[1 if level and flat == 2 else 2]
    up = -gravity / np.linalg.norm(gravity) if gravity.any() else free
    if level and abs(up[flat]) < 0.5:
        towards = np.eye(3)[flat]
        towards = towards if np.cross(up, towards).sum() >= 0 else -towards
        towards = towards + 0.28 * np.cross(up, towards)
    else:
        side = np.eye(3)[0 if abs(up[0]) < 0.5 else 1]
        side = side - (side @ up) * up
        towards = 0.75 * side + np.cross(side, up)
    towards = towards / np.linalg.norm(towards) + (0.34 if not (level and abs(up[flat]) >= 0.5) else 1.4) * up
    towards /= np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards], axis=1)


# --- faces -------------------------------------------------------------------------------------------------


def _faces(drawn: Scene) -> list[_Faces | _Stretched]:
    """Of all solids, by number of corners, and of all spans."""
    return [*_solid_faces([it for it in drawn.solids if not it.clear]), *_span_faces(drawn.spans)]


def _span_faces(drawn: list[Span]) -> Iterator[_Stretched]:
    for it in drawn:
        for corners in _span(it):
            count = len(corners)
            yield _Stretched(corners, np.tile(it.bodies, (count, 1)), np.tile(it.ends, (count, 1, 1)),
                             np.tile(_color(it), (count, 1)))  # fmt: skip


def _color(it: Solid | Span) -> Floats:
    return np.array(list(bytes.fromhex(it.color[1:]))) / 255


def _span(it: Span) -> list[Floats]:
    """Polygons (m, corners, 3) along z from 0 to 1."""
    if it.form == "coil":
        return [_helix() * (it.radius, it.radius, 1)]
    pieces = [(1.0, 0.0, 1.0)] if it.form == "bar" else [(1.0, 0.14, 0.64), (0.3, 0.0, 1.0)]
    return [
        part * (width * it.radius, width * it.radius, high - low) + (0, 0, (low + high) / 2)
        for width, low, high in pieces
        for part in _cylinder(8)
    ]


def _solid_faces(drawn: list[Solid]) -> list[_Faces]:
    by_corners: dict[int, list[_Faces]] = {}
    for it in drawn:
        color = _color(it)
        for corners in _surface(it.shape):
            count = len(corners)
            faces = _Faces(corners, np.full(count, it.body), np.tile(color, (count, 1)))
            by_corners.setdefault(corners.shape[1], []).append(faces)
    return [
        _Faces(
            *(np.concatenate([getattr(it, name) for it in several]) for name in ("corners", "body", "color"))
        )
        for several in by_corners.values()
    ]


def _surface(shape: Shape) -> list[Floats]:
    """Polygons (m, corners, 3) in body coordinates, counterclockwise from outside."""
    match shape:
        case Box():
            unit: list[Floats] = [_box() * shape.size]
        case Sphere():
            unit = [_sphere() * shape.radius]
        case Cylinder():
            unit = [part * (shape.radius, shape.radius, shape.length) for part in _cylinder()]
        case Rod():
            length = float(np.linalg.norm(shape.end - shape.start))
            unit = [part * (shape.radius, shape.radius, length) for part in _cylinder(8)]
        case Mesh():
            unit = [shape.vertices[shape.triangles]]
        case _:
            unit = []
    A = rotation.matrix(shape.orientation)
    return [shape.position + part @ A.T for part in unit]


def _box() -> Floats:
    """Edges of one."""
    square = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]) / 2
    turns = [np.roll(square, shift, axis=1) for shift in range(3)]
    return np.stack([*turns, *(-turn[::-1] for turn in turns)])


def _cylinder(sides: int = 14, slices: int = 6) -> list[Floats]:
    """Radius and length one, about z; slices, so that painting from back to front has short faces."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    heights = np.linspace(-0.5, 0.5, slices + 1)
    walls = [
        [[*a, low], [*b, low], [*b, high], [*a, high]]
        for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True)
        for low, high in pairwise(heights)
    ]
    top = np.column_stack([ring, np.full(sides, 0.5)])
    bottom = np.column_stack([ring, np.full(sides, -0.5)])[::-1]
    return [np.array(walls), np.stack([top, bottom])]


def _helix(coils: int = 7, pieces: int = 10, wire: float = 0.15) -> Floats:
    """A wire on a circle of radius one: a ribbon that is seen from both sides, z from 0 to 1."""
    angle = np.linspace(0, 2 * np.pi * coils, coils * pieces + 1)
    middle = np.stack([np.cos(angle), np.sin(angle), 0.08 + 0.84 * angle / angle[-1]], axis=1)
    middle = np.concatenate([[[0, 0, 0]], middle, [[0, 0, 1]]])
    up = np.array([0, 0, wire / 14])
    front = np.stack([middle[:-1] - up, middle[1:] - up, middle[1:] + up, middle[:-1] + up], axis=1)
    return np.concatenate([front, front[:, ::-1]])


def _sphere(rings: int = 9, sides: int = 14) -> Floats:
    """Radius one."""
    polar, angle = np.linspace(0, np.pi, rings + 1), 2 * np.pi * np.arange(sides + 1) / sides
    point = np.stack(
        [
            np.outer(np.sin(polar), np.cos(angle)),
            np.outer(np.sin(polar), np.sin(angle)),
            np.outer(np.cos(polar), np.ones(sides + 1)),
        ],
        axis=-1,
    )
    corners = (point[1:, :-1], point[1:, 1:], point[:-1, 1:], point[:-1, :-1])
    return np.stack(corners, axis=2).reshape(-1, 4, 3)
