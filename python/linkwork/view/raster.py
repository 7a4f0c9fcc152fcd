"""Triangles into pixels by NumPy, the nearest one seen, colors between the corners: no display is needed."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

__all__ = ["Raster"]

Whole = NDArray[np.intp]

#: Triangles up to so many pixels wide and high are taken together, and so many pixels of them at a time.
SIDES, AT_ONCE = (2, 4, 8, 16, 32, 64), 2_000_000


class Raster:
    """A picture over a background (height, width, 3) in 0 .. 1; with `samples` x `samples` points a pixel."""

    def __init__(self, background: Floats, samples: int = 2) -> None:
        self._samples = samples
        self._height, self._width = (samples * n for n in background.shape[:2])
        full = np.repeat(np.repeat(background, samples, axis=0), samples, axis=1)
        self._colors = full.reshape(-1, 3).astype(np.float32)
        self._nearness = np.zeros(len(self._colors))

    def picture(self) -> NDArray[np.uint8]:
        """Red, green, blue (height, width, 3)."""
        n = self._samples
        cells = self._colors.reshape(self._height // n, n, self._width // n, n, 3)
        return np.asarray(np.clip(255 * cells.mean(axis=(1, 3)) + 0.5, 0, 255), np.uint8)

    def draw(self, corners: Floats, nearness: Floats, colors: Floats) -> None:
        """Triangles with corners (m, 3, 2) in pixels from the upper left corner, which face the eye.

        nearness  of each corner (m, 3), one over its distance along the line of sight: larger is in front
        colors    of each corner (m, 3, 3)
        """
        corners = corners * self._samples
        low = np.maximum(np.ceil(corners.min(axis=1) - 0.5), 0).astype(np.intp)
        high = np.floor(corners.max(axis=1) - 0.5).astype(np.intp)
        high = np.minimum(high, (self._width - 1, self._height - 1))
        side = (high - low).max(axis=1) + 1
        inside = ((high >= low).all(axis=1)) & (nearness > 0).all(axis=1)
        least = 0
        for most in SIDES:
            chosen = np.flatnonzero(inside & (side > least) & (side <= most))
            for part in np.array_split(chosen, len(chosen) * most**2 // AT_ONCE + 1):
                self._fill(part, low[part], most, most, corners, nearness, colors)
            least = most
        for one in np.flatnonzero(inside & (side > least)):
            for first, last in self._bands(low[one, 1], high[one, 1], int(high[one, 0] - low[one, 0]) + 1):
                corner = np.array([[low[one, 0], first]])
                wide, tall = int(high[one, 0] - low[one, 0]) + 1, last - first + 1
                self._fill(np.array([one]), corner, wide, tall, corners, nearness, colors)

    @staticmethod
    def _bands(top: int, bottom: int, width: int) -> Iterator[tuple[int, int]]:
        """Rows that are not too many at a time."""
        rows = max(1, AT_ONCE // width)
        for first in range(int(top), int(bottom) + 1, rows):
            yield first, min(first + rows - 1, int(bottom))

    # Barycentric coordinates of a point p: w_a = (b - p) x (c - p) / ((b - a) x (c - a)), and so on
    def _fill(self, which: Whole, low: Whole, wide: int, tall: int, corners: Floats, nearness: Floats,
              colors: Floats) -> None:  # fmt: skip
        """Triangles `which` in boxes of wide x tall points from `low` (k, 2) on."""
        if not len(which):
            return
        across, down = np.meshgrid(np.arange(wide), np.arange(tall))
        x, y = (low[:, [axis]] + step.ravel() for axis, step in enumerate((across, down)))
        a, b, c = (corners[which, k] for k in range(3))
        ab, ac = b - a, c - a
        twice = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
        px, py = x + 0.5 - a[:, [0]], y + 0.5 - a[:, [1]]
        with np.errstate(divide="ignore", invalid="ignore"):
            w_b = (px * ac[:, [1]] - py * ac[:, [0]]) / twice[:, None]
            w_c = (py * ab[:, [0]] - px * ab[:, [1]]) / twice[:, None]
        covered = (w_b >= 0) & (w_c >= 0) & (w_b + w_c <= 1) & (x < self._width) & (y < self._height)
        triangle, point = np.nonzero(covered)
        w = np.stack([w_b[triangle, point], w_c[triangle, point]], axis=1)
        weights = np.concatenate([1 - w.sum(axis=1, keepdims=True), w], axis=1)
        pixel = y[triangle, point] * self._width + x[triangle, point]
        near = np.einsum("kc,kc->k", weights, nearness[which[triangle]])
        np.maximum.at(self._nearness, pixel, near)
        seen = self._nearness[pixel] == near
        of = which[triangle[seen]]
        self._colors[pixel[seen]] = np.einsum("kc,kcd->kd", weights[seen], colors[of])
