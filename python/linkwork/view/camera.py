"""Where a picture is taken from, and the floor in it: as the viewer's page has them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from linkwork.arrays import Floats

__all__ = ["Camera", "floor"]

#: Half of the angle that a picture is high [rad].
HALF = np.radians(16.0)

#: Colors of the page: background, lines of the floor, those through its middle.
SCENE, LINE, STRONG = (np.array([int(text[k : k + 2], 16) for k in (0, 2, 4)]) / 255
                       for text in ("f4f5f7", "dde1e6", "c4cad2"))  # fmt: skip


@dataclass(frozen=True)
class Camera:
    """Perspective; a picture of `size` (width, height) pixels."""

    position: Floats  # (3,) [m]
    axes: Floats  # (3, 3) columns right, up, towards the eye
    size: tuple[int, int]

    @classmethod
    def around(cls, low: Floats, high: Floats, axes: Floats, size: tuple[int, int]) -> Camera:
        """So near, from the direction of the axes, that the box between two corners (3,) is seen."""
        center, half = (low + high) / 2, np.tan(HALF)
        signs = np.array([[(k >> i) & 1 for i in range(3)] for k in range(8)]) - 0.5
        corners = signs * (high - low) @ axes
        wide = np.maximum(np.abs(corners[:, 1]), np.abs(corners[:, 0]) * size[1] / size[0]) / half
        distance = float((wide + corners[:, 2]).max()) or 1.0
        return cls(center + 1.06 * distance * axes[:, 2], axes, size)

    @property
    def _pixels(self) -> float:
        """Of what is as far away as it is wide, from the middle."""
        return self.size[1] / (2 * float(np.tan(HALF)))

    def seen(self, points: Floats) -> tuple[Floats, Floats]:
        """Points (..., 3) in pixels from the upper left corner (..., 2), and one over their distances
        (...).
        """
        local = (points - self.position) @ self.axes
        with np.errstate(divide="ignore", invalid="ignore"):
            nearness = np.where(local[..., 2] < 0, -1 / local[..., 2], 0.0)
        middle = np.array(self.size) / 2
        places: Floats = middle + self._pixels * nearness[..., None] * local[..., :2] * (1, -1)
        return places, nearness

    def rays(self) -> Floats:
        """The direction in which each pixel looks (height, width, 3), of length one along the line of
        sight.
        """
        width, height = self.size
        x = (np.arange(width) + 0.5 - width / 2) / self._pixels
        y = (height / 2 - np.arange(height) - 0.5) / self._pixels
        local = np.stack([*np.meshgrid(x, y), -np.ones((height, width))], axis=-1)
        rays: Floats = local @ self.axes.T
        return rays


def floor(camera: Camera, low: Floats, high: Floats, up: Floats) -> Floats:
    """The background (height, width, 3): a grid below the box between two corners, with round distances."""
    width, height = camera.size
    out = np.tile(SCENE, (height, width, 1))
    size = float(np.linalg.norm(high - low)) or 1.0
    spacing = _round(size / 12)
    level = min(float(low @ up), float(high @ up)) - 0.02 * size
    rays = camera.rays()
    with np.errstate(divide="ignore"):
        distance = (level - camera.position @ up) / (rays @ up)
    x = np.cross(up, np.eye(3)[int(np.argmin(np.abs(up)))])
    x /= np.linalg.norm(x)
    points = camera.position + np.clip(distance, 0, 1e6 * size)[..., None] * rays
    center = np.round((low + high) / 2 / spacing) * spacing
    away = np.linalg.norm(points - center - ((points - center) @ up)[..., None] * up, axis=-1)
    fade = np.clip(1.6 - away / (0.62 * size), 0, 1) * (distance > 0)
    lines, middle = np.zeros((height, width)), np.zeros((height, width))
    for axis in (x, np.cross(up, x)):
        along = (points - center) @ axis
        step = np.maximum(np.hypot(*np.gradient(along)), 1e-12)  # of a pixel
        lines = np.maximum(lines, _line(np.abs(along / spacing - np.round(along / spacing)) * spacing / step))
        middle = np.maximum(middle, _line(np.abs(along) / step))
    out += (fade * lines)[..., None] * (LINE - out)
    drawn: Floats = out + (fade * middle)[..., None] * (STRONG - out)
    return drawn


def _line(pixels: Floats) -> Floats:
    """How much of a line of 1.3 pixels is in a pixel at that distance from its middle."""
    part: Floats = np.clip(1.15 - pixels, 0, 1)
    return part


def _round(length: float) -> float:
    """1, 2 or 5 times a power of ten, near a length."""
    power = 10.0 ** np.floor(np.log10(length))
    return float(power * min((1, 2, 5, 10), key=lambda n: abs(n - length / power)))
