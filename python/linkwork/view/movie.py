"""Movies of a run without a display: what the viewer's page shows, with its floor, light and perspective.

GIF is written by pillow, MP4 by the ffmpeg that imageio-ffmpeg brings: pip install 'linkwork[movie]'.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwork import arguments, rotation
from linkwork.arrays import Floats
from linkwork.errors import FileError, OptionError
from linkwork.replacement import replacing
from linkwork.view.appearance import RAMPED, Scene, Solid, Span, at_least, scene
from linkwork.view.camera import Camera, floor
from linkwork.view.raster import Raster
from linkwork.view.surfaces import coil, cylinder, surface

if TYPE_CHECKING:
    from linkwork.results.result import Result

#: More faces than these take minutes to paint; more shapes than these have fewer faces each.
MOST_FACES, MANY = 1_000_000, 1500

#: Direction to the lamp from the side, in axes (right, up, towards the eye); it is above, too.
SIDE = np.array([0.35, 0.0, 0.7])

#: Bodies are at least so thick, of the height of the picture; where there are many, a line of them is seen.
THINNEST, THINNEST_OF_MANY = 1 / 300, 1 / 110

#: Of a movie: hours of it.
MOST_PICTURES = 1_000_000

#: Pictures of a .gif last whole hundredths of a second, and browsers show what lasts one for ten.
GIF_TICK, GIF_RATE = 10, 50  # [ms], [1/s]

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
    writes_gif = file.suffix.lower() == ".gif"
    if writes_gif and frames_per_second > GIF_RATE:
        raise OptionError(
            f"movie '{path}': a .gif shows at most {GIF_RATE} frames per second, not {frames_per_second:g}",
            code="movie",
        )
    times = result.t[0] + duration * np.linspace(0, 1, max(2, round(lasts * frames_per_second)))
    pictures = Painter(result, size).pictures(times)
    write = _write_gif if writes_gif else _write_mp4
    with replacing(file, "movie") as beside:
        beside.touch()  # what cannot be written is told before the work
        write(beside, pictures, frames_per_second, size)


def _is_size(size: object) -> bool:
    """Whether it is two even whole numbers of 32 pixels or more."""
    if not isinstance(size, Sequence) or len(size) != 2:
        return False
    return all(isinstance(n, int | np.integer) and n >= 32 and n % 2 == 0 for n in size)


def _write_gif(file: Path, pictures: Iterator[Pixels], rate: int, size: tuple[int, int]) -> None:
    from PIL import Image

    images = [Image.fromarray(picture).quantize(96) for picture in pictures]
    ends = np.round(np.arange(len(images) + 1) * (1000 / GIF_TICK / rate))
    lasting = [GIF_TICK * int(ticks) for ticks in np.diff(ends)]
    images[0].save(file, format="GIF", save_all=True, append_images=images[1:], duration=lasting, loop=0)


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
    """Triangles fixed in their bodies."""

    corners: Floats  # (m, 3, 3) body coordinates
    normals: Floats  # (m, 3, 3)
    body: NDArray[np.intp]  # (m,)
    color: Floats  # (m, 3) red, green, blue in 0 .. 1

    def placed(self, r: Floats, A: Floats) -> tuple[Floats, Floats]:
        """Corners and normals where the bodies are (m, 3, 3), inertial."""
        turn = A[self.body].transpose(0, 2, 1)
        return r[self.body, None] + self.corners @ turn, self.normals @ turn


@dataclass(frozen=True)
class _Stretched:
    """Triangles between a point of one body and a point of another; z of corners is -1/2 to 1/2 between
    them.
    """

    corners: Floats  # (m, 3, 3) x and y [m]
    normals: Floats  # (m, 3, 3)
    body: NDArray[np.intp]  # (m, 2)
    ends: Floats  # (m, 2, 3) body coordinates
    color: Floats  # (m, 3)

    def placed(self, r: Floats, A: Floats) -> tuple[Floats, Floats]:
        """As of faces of bodies."""
        ends = r[self.body] + np.einsum("msab,msb->msa", A[self.body], self.ends)
        along = ends[:, 1] - ends[:, 0]
        length = np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
        z = along / length
        x = rotation.perpendicular(z)
        turn = np.stack([x, np.cross(z, x), along], axis=1)
        turn_normals = np.stack([x, np.cross(z, x), z], axis=1)
        return ends.mean(axis=1)[:, None] + self.corners @ turn, self.normals @ turn_normals


class Painter:
    """Pictures of the poses of a run as the viewer shows them, from the side that shows the most."""

    def __init__(self, result: Result, size: tuple[int, int]) -> None:
        """OptionError: too many faces."""
        self._result, self._size = result, size
        drawn = scene(result)
        self._faces = _faces(drawn)
        count = sum(len(faces.body) for faces in self._faces)
        if count > MOST_FACES:
            raise OptionError(
                f"a movie of {count:,} faces would take too long (at most {MOST_FACES:,}): "
                "give the bodies simpler shapes, or use result.view()",
                code="movie",
            )
        axes = _eye(result)
        low, high = self._range()
        self.camera = Camera.around(low, high, axes, size)
        self._up = _up(result)
        self._light = _unit(_unit(axes @ SIDE) + 1.2 * self._up)
        self._floor = floor(self.camera, low, high, self._up)
        self._middle = (low + high) / 2
        part = THINNEST if len(result.body_names) < RAMPED else THINNEST_OF_MANY
        self._faces = _faces(drawn, part * size[1] / self.pixels_of_meter)

    def pictures(self, times: Floats) -> Iterator[Pixels]:
        """Red, green, blue (height, width, 3) at each time, which is written in it."""
        from PIL import Image, ImageDraw, ImageFont

        font = ImageFont.load_default(max(10, self._size[1] // 42))
        for time in times:
            image = Image.fromarray(self.picture(time))
            place = (0.02 * self._size[0], 0.97 * self._size[1])
            ImageDraw.Draw(image).text(place, f"{time:.3f} s", fill=(90, 98, 110), font=font, anchor="ls")
            yield np.asarray(image)

    def picture(self, time: float) -> Pixels:
        """At one time."""
        r, A = self._pose(time)
        raster = Raster(self._floor)
        for faces in self._faces:
            corners, normals = faces.placed(r, A)
            places, nearness = self.camera.seen(corners)
            ab, ac = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]
            front = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0] < 0  # counterclockwise; rows count downward
            colors = self._lit(faces.color[front], corners[front], normals[front])
            raster.draw(places[front], nearness[front], colors)
        return raster.picture()

    # Ambient light from above and below, a lamp by Lambert, and its reflection by Blinn and Phong
    def _lit(self, color: Floats, corners: Floats, normals: Floats) -> Floats:
        """Of each corner (m, 3, 3)."""
        towards = self.camera.position - corners
        half = towards / np.linalg.norm(towards, axis=-1, keepdims=True) + self._light
        half /= np.maximum(np.linalg.norm(half, axis=-1, keepdims=True), 1e-300)
        shade = 0.52 + 0.13 * (normals @ self._up) + 0.45 * np.clip(normals @ self._light, 0, 1)
        shine = 0.14 * np.clip(np.einsum("mcd,mcd->mc", normals, half), 0, 1) ** 30
        lit: Floats = np.clip(color[:, None] * shade[..., None] + shine[..., None], 0, 1)
        return lit

    @property
    def pixels_of_meter(self) -> float:
        """At the distance of the middle."""
        across = self._middle + np.outer((0, 1), self.camera.axes[:, 0])
        return float(np.ptp(self.projected(across)[:, 0]))

    def projected(self, points: Floats) -> Floats:
        """Inertial points (k, 3) in pixels of the picture from its upper left corner (k, 2)."""
        return self.camera.seen(points)[0]

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
        """The corners (3,) of the box around everything, from a sample of frames."""
        sample = self._result.t[:: max(1, len(self._result) // 40)]
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        for time in sample:
            r, A = self._pose(float(time))
            for faces in self._faces:
                corners, _ = faces.placed(r, A)
                low, high = np.minimum(low, corners.min((0, 1))), np.maximum(high, corners.max((0, 1)))
        return (low, high) if np.isfinite(low).all() else (np.zeros(3), np.ones(3))


def _unit(a: Floats) -> Floats:
    unit: Floats = a / np.linalg.norm(a)
    return unit


def _up(result: Result) -> Floats:
    """Against gravity; without, z, or y where everything lies in the plane of x and y."""
    gravity = np.asarray(result.header.gravity, float)
    if gravity.any():
        return -_unit(gravity)
    positions = result.sampled_positions(max(1, len(result) // 40)).reshape(-1, 3)
    sides = np.ptp(positions, axis=0)
    lies = sides[2] < 0.25 * sides.max() and int(np.argmin(sides)) == 2
    up: Floats = np.eye(3)[1 if lies else 2]
    return up


def _eye(result: Result) -> Floats:
    """Axes of the picture (3, 3): columns right, up, towards the eye, as the viewer chooses them."""
    positions = result.sampled_positions(max(1, len(result) // 40)).reshape(-1, 3)
    sides = np.ptp(positions, axis=0)
    flat = int(np.argmin(sides))
    level = sides[flat] < 0.25 * sides.max()
    up = _up(result)
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


def _faces(drawn: Scene, thinnest: float = 0.0) -> list[_Faces | _Stretched]:
    """Of all solids, and of all that is stretched; bodies are nowhere thinner than that [m]."""
    solid = [it for it in drawn.solids if not it.clear]
    coarse = len(solid) + len(drawn.spans) > MANY
    found: list[_Faces | _Stretched] = [_solid_faces(solid, coarse, thinnest)] if solid else []
    return found + [_stretched(it) for it in drawn.spans]


def _color(it: Solid | Span) -> Floats:
    return np.array(list(bytes.fromhex(it.color[1:]))) / 255


def _stretched(it: Span) -> _Stretched:
    """Bars, coils and dampers, along z from -1/2 to 1/2."""
    if it.form == "coil":
        parts = [coil()]
    else:
        pieces = [(1.0, -0.5, 0.5)] if it.form == "bar" else [(1.0, -0.36, 0.14), (0.3, -0.5, 0.5)]
        corners, normals = cylinder(16)
        parts = [(corners * (width, width, high - low) + (0, 0, (low + high) / 2), normals)
                 for width, low, high in pieces]  # fmt: skip
    corners, normals = (np.concatenate(it) for it in zip(*parts, strict=True))
    count = len(corners)
    return _Stretched(corners * (it.radius, it.radius, 1), normals, np.tile(it.bodies, (count, 1)),
                      np.tile(it.ends, (count, 1, 1)), np.tile(_color(it), (count, 1)))  # fmt: skip


def _solid_faces(drawn: list[Solid], coarse: bool, thinnest: float) -> _Faces:
    shapes = [at_least(it.shape, thinnest) if it.layer == "body" else it.shape for it in drawn]
    surfaces = [surface(shape, coarse) for shape in shapes]
    counts = [len(corners) for corners, _ in surfaces]
    corners, normals = (np.concatenate(it) for it in zip(*surfaces, strict=True))
    return _Faces(corners, normals, np.repeat([it.body for it in drawn], counts),
                  np.repeat([_color(it) for it in drawn], counts, axis=0))  # fmt: skip
