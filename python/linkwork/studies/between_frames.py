"""What becomes of a quantity over time: between the frames of a run, too, where they tell what is there.

Where the rate of a value is recorded as well, it is a cubic from one frame to the next (Hermite). With h the
time between them, and x going from 0 to 1,

    f(x) = f_0 + x df + x (1 - x) [(1 - x) a - x b],    df = f_1 - f_0,  a = h f_0' - df,  b = h f_1' - df

It bends one way where 3 |a + b| <= |b - a|, and lies between its chord and its tangents then, as the motion
does. Elsewhere the rates at the frames are not those between, as at an impact, or it hardly bends: there, and
where that is so often, as in an oscillation of which there are too few frames, or no rate is recorded, values
go straight from frame to frame, and are largest and smallest at one. So they do where second rates are
recorded as well and say something else than the cubic's, -4 a - 2 b and 2 a + 4 b over h^2. Where the rate is
known at one of two frames alone, as beside an impact, it is a parabola.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

__all__ = ["Bends", "Curve", "bends_of"]

#: Places and weights of Gauss from 0 to 1: exact for squares of cubics, close for magnitudes.
GAUSS = tuple(
    (0.5 + 0.5 * x, 0.5 * weight) for x, weight in zip(*np.polynomial.legendre.leggauss(8), strict=True)
)

#: The part of the times between frames in which rates have to fit, or frames are too far apart.
RESOLVED = 0.8

#: Of the largest value: by so little what rests bends.
ROUNDING = 1e-13

#: Parts of the time between frames at whose ends extremes are looked for, and how often the place of one is
#: narrowed to a half then, to some 1e-8 of that time.
PARTS, HALVINGS = 8, 24

What = Callable[[Floats], Floats]


class Bends(NamedTuple):
    """a and b between the frames (k - 1, ...), zero where it does not bend one way."""

    start: Floats
    end: Floats
    known: NDArray[np.bool_]  #: whether the rates are those of what is between the frames


def bends_of(t: Floats, values: Floats, rates: Floats, second: Floats | None = None) -> Bends:
    """Of values (k, ...) at times `t` (k,) [s] with their rates, and second ones where there are such.

    Times that are the same are a jump; rates are NaN where they are not known.
    """
    h = np.diff(t).reshape(-1, *[1] * (values.ndim - 1))
    rise = np.diff(values, axis=0)
    a, b = h * rates[:-1] - rise, h * rates[1:] - rise
    counted = (h > 0.0) & np.isfinite(a) & np.isfinite(b)
    a, b = np.where(np.isnan(a), -b, a), np.where(np.isnan(b), -a, b)  # a parabola, where one rate is known
    one_way = 3 * np.abs(a + b) <= np.abs(b - a)
    rest = ROUNDING * np.abs(values).max(axis=0)
    straight = np.maximum(np.abs(a), np.abs(b)) <= 0.5 * np.abs(rise) + rest
    if second is not None:
        apart = np.abs(h**2 * second[:-1] + 4 * a + 2 * b), np.abs(h**2 * second[1:] - 2 * a - 4 * b)
        one_way &= ~(np.fmax(*apart) > np.maximum(np.abs(a), np.abs(b)))
    resolved = ((one_way | straight) & counted).sum(axis=0) >= RESOLVED * counted.sum(axis=0)
    one_way, known = one_way & resolved, (one_way | straight) & resolved
    return Bends(np.where(one_way, a, 0.0), np.where(one_way, b, 0.0), known)


@dataclass(frozen=True)
class _Pieces:
    """From frame to frame, (k - 1, ...) or as many as are chosen; `ends`: what is looked at there."""

    start: Floats
    rise: Floats
    bends: Bends | None
    ends: tuple[Floats, Floats]
    sizes: bool

    def at(self, x: float | Floats) -> Floats:
        straight = (1 - x) * self.ends[0] + x * self.ends[1]
        if self.bends is None:
            return np.asarray(straight)
        each = np.expand_dims(np.asarray(x), -1) if self.sizes and np.ndim(x) else x
        a, b, known = self.bends
        found = self.start + each * self.rise + each * (1 - each) * ((1 - each) * a - each * b)
        if self.sizes:
            found, known = np.linalg.norm(found, axis=-1), np.asarray(known.all(axis=-1))
        return np.where(known, found, straight)

    def chosen(self, piece: NDArray[np.intp]) -> _Pieces:
        """One of each column."""
        of_values = piece[..., None] if self.sizes else piece
        assert self.bends is not None
        bends = Bends(*(_of_columns(it, of_values) for it in self.bends))
        ends = _of_columns(self.ends[0], piece), _of_columns(self.ends[1], piece)
        return _Pieces(_of_columns(self.start, of_values), _of_columns(self.rise, of_values), bends, ends,
                       self.sizes)  # fmt: skip


def _of_columns(values: NDArray[Any], row: NDArray[np.intp]) -> NDArray[Any]:
    """Of values (k, ...) in each column that of a row."""
    found: NDArray[Any] = np.take_along_axis(values, row[None], axis=0)[0]
    return found


@dataclass(frozen=True)
class Curve:
    """values (k, ...) at times `t` (k,) [s]; where `sizes`, the magnitudes of vectors (k, ..., 3) count."""

    t: Floats
    values: Floats
    bends: Bends | None = None
    sizes: bool = False

    @property
    def looked_at(self) -> Floats:
        return np.asarray(np.linalg.norm(self.values, axis=-1)) if self.sizes else self.values

    def mean(self, what: What = np.asarray) -> Floats:
        """Over time, of what becomes of the values."""
        if self.t[-1] <= self.t[0]:
            return what(self.looked_at[-1])
        pieces, h = self._pieces(), np.diff(self.t)
        each = (weight * np.tensordot(h, what(pieces.at(x)), 1) for x, weight in GAUSS)
        return np.asarray(sum(each) / (self.t[-1] - self.t[0]))

    def largest(self, what: What = np.asarray) -> Floats:
        """Of what becomes of the values, at frames or between two."""
        at_frames = what(self.looked_at).max(axis=0)
        if self.bends is None or len(self.t) < 2:
            return np.asarray(at_frames)
        pieces = self._pieces()
        most = np.full(at_frames.shape, -np.inf)
        place, piece = np.zeros(at_frames.shape), np.zeros(at_frames.shape, dtype=np.intp)
        for x in np.arange(1, PARTS) / PARTS:
            values = what(pieces.at(x))
            at = values.argmax(axis=0)
            found = _of_columns(values, at)
            better = found > most
            most, place, piece = (np.where(better, new, old)
                                  for new, old in ((found, most), (x, place), (at, piece)))  # fmt: skip
        return np.asarray(np.maximum(at_frames, _narrowed(pieces.chosen(piece), what, place, most)))

    def _pieces(self) -> _Pieces:
        ends = self.looked_at
        rise = np.diff(self.values, axis=0)
        return _Pieces(self.values[:-1], rise, self.bends, (ends[:-1], ends[1:]), self.sizes)


def _narrowed(pieces: _Pieces, what: What, place: Floats, most: Floats) -> Floats:
    """The largest near a place of each piece."""
    for halving in range(1, HALVINGS + 1):
        aside = 1.0 / (PARTS * 2.0**halving)
        for x in (np.maximum(place - aside, 0.0), np.minimum(place + aside, 1.0)):
            found = what(pieces.at(x))
            better = found > most
            most, place = np.where(better, found, most), np.where(better, x, place)
    return most
