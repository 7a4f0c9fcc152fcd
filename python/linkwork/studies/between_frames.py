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

What has no rate may jump where functions of time break: means go up to there and begin there in a straight
line through two frames of the same side.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

__all__ = ["Bends", "Curve", "bends_of", "with_sides"]

#: Places and weights of Gauss from 0 to 1: exact for squares of cubics, close for magnitudes away from zero.
GAUSS = tuple(
    (0.5 + 0.5 * x, 0.5 * weight) for x, weight in zip(*np.polynomial.legendre.leggauss(8), strict=True)
)

#: Of the largest magnitude between two frames: where some are smaller, it may turn sharply at the least.
NEAR_ZERO = 0.5

#: That is looked for in each quarter, from so many places on, in intervals that become shorter by a third so
#: many times; toward it parts become short in these steps.
QUARTERS, PLACES, NARROWED = np.linspace(0.0, 1.0, 5), 9, 40
SHORTER = tuple(0.125**k for k in range(8))

#: The part of the times between frames in which rates have to fit, or frames are too far apart.
RESOLVED = 0.8

#: Of the largest value: by so little what rests bends. Of the bend of a vector: what of a component counts.
ROUNDING, NEGLIGIBLE = 1e-13, 1e-4

#: Pieces that may hold an extreme are halved until they hold no more than so much beside what is found, of
#: the largest value, and at most so often, to some 1e-8 of the time between frames.
CLOSE, HALVINGS = 4e-15, 27

What = Callable[[Floats], Floats]


class Bends(NamedTuple):
    """a and b between the frames (k - 1, ...), zero where it does not bend one way."""

    start: Floats
    end: Floats
    known: NDArray[np.bool_]  #: whether the rates are those of what is between the frames


def bends_of(
    t: Floats, values: Floats, rates: Floats, second: Floats | None = None, *, sizes: bool = False
) -> Bends:
    """Of values (k, ...) at times `t` (k,) [s] with their rates, and second ones where there are such.

    Times that are the same are a jump; rates are NaN where they are not known. Where `sizes`, the values are
    vectors (k, ..., 3), beside whose magnitudes a component may be rounding.
    """
    h = np.diff(t).reshape(-1, *[1] * (values.ndim - 1))
    rise = np.diff(values, axis=0)
    a, b = h * rates[:-1] - rise, h * rates[1:] - rise
    counted = (h > 0.0) & np.isfinite(a) & np.isfinite(b)
    a, b = np.where(np.isnan(a), -b, a), np.where(np.isnan(b), -a, b)  # a parabola, where one rate is known
    one_way = 3 * np.abs(a + b) <= np.abs(b - a)
    bent, rest = np.maximum(np.abs(a), np.abs(b)), ROUNDING * np.abs(values).max(axis=0)
    if sizes:
        rest = rest.max(axis=-1, keepdims=True) + NEGLIGIBLE * bent.max(axis=-1, keepdims=True)
    straight = bent <= 0.5 * np.abs(rise) + rest
    if second is not None:
        apart = np.abs(h**2 * second[:-1] + 4 * a + 2 * b), np.abs(h**2 * second[1:] - 2 * a - 4 * b)
        one_way &= ~(np.fmax(*apart) > bent)
    resolved = ((one_way | straight) & counted).sum(axis=0) >= RESOLVED * counted.sum(axis=0)
    one_way, known = one_way & resolved, (one_way | straight) & resolved
    return Bends(np.where(one_way, a, 0.0), np.where(one_way, b, 0.0), known)


def with_sides(t: Floats, values: Floats, breaks: Floats, clock: Floats) -> tuple[Floats, Floats]:
    """With two values at each of the `breaks` [s], ascending, between frames: of what is before, and after.

    clock  where functions were evaluated for the frames (k,) [s], beside breaks
    """
    passed = np.searchsorted(breaks, clock)
    last = np.flatnonzero(np.diff(passed) > 0)  # before a break
    after = last + 1
    begin, end = breaks[passed[last]], breaks[passed[after] - 1]
    before = _continued(t, values, passed, last, np.clip(begin, t[last], t[after]), -1)
    behind = _continued(t, values, passed, after, np.clip(end, t[last], t[after]), 1)
    known = (t[after] == t[np.minimum(after + 1, len(t) - 1)]) & (after + 1 < len(t))  # as of a strike
    places = np.tile(after[~known], 2)
    times, added = (
        np.concatenate([one[~known], other[~known]]) for one, other in zip(before, behind, strict=True)
    )
    return np.insert(t, places, times), np.insert(values, places, added, axis=0)


def _continued(
    t: Floats, values: Floats, passed: NDArray[np.intp], frame: NDArray[np.intp], at: Floats, away: int
) -> tuple[Floats, Floats]:
    """The times `at` [s], and values there in a straight line through those frames and ones `away` from
    there, about as far or farther, with no break between; else those of the frames."""
    far = t[frame] - 0.5 * (at - t[frame])
    other = np.searchsorted(t, far, "right") - 1 if away < 0 else np.searchsorted(t, far)
    other = np.clip(other, 0, len(t) - 1)
    way = t[frame] - t[other]
    usable = (passed[other] == passed[frame]) & (way * away < 0.0)
    part = np.where(usable, (at - t[frame]) / np.where(usable, way, 1.0), 0.0)
    part = part.reshape(-1, *[1] * (values.ndim - 1))
    return at, values[frame] + part * (values[frame] - values[other])


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
            found, known = _sizes(found), np.asarray(known.all(axis=-1))
        return np.where(known, found, straight)

    def means(self, what: What, begin: float | Floats = 0.0, end: float | Floats = 1.0) -> Floats:
        """Of what becomes of the values on each, in a part of it."""
        length = end - begin
        return np.asarray(sum(weight * what(self.at(begin + x * length)) for x, weight in GAUSS))

    def pass_zero(self) -> NDArray[np.bool_]:
        """On which (k - 1, ...) magnitudes are so small somewhere that they may turn sharply there."""
        there = np.stack([*self.ends, *(self.at(x) for x, _ in GAUSS)])
        largest = there.max(axis=0)
        small = there.min(axis=0) < NEAR_ZERO * largest
        return np.asarray(small & (largest > ROUNDING * largest.max(axis=0)))

    def chosen(self, which: NDArray[np.bool_]) -> _Pieces:
        bends = self.bends
        if bends is not None:
            bends = Bends(bends.start[which], bends.end[which], bends.known[which])
        first, last = self.ends
        return _Pieces(self.start[which], self.rise[which], bends, (first[which], last[which]), self.sizes)

    def means_beside_zero(self, what: What) -> Floats:
        """As `means`, in parts that become short toward where the magnitude is least in each quarter."""
        total = np.zeros_like(self.ends[0])
        for first, last in itertools.pairwise(QUARTERS):
            least = self._least(first, last)
            before = [least + (first - least) * it for it in SHORTER]
            after = [least + (last - least) * it for it in (0.0, *SHORTER[::-1])]
            for begin, end in itertools.pairwise([*before, *after]):
                total = total + (end - begin) * self.means(what, begin, end)
        return total

    def _least(self, first: float, last: float) -> Floats:
        """Where the magnitude of each is least between these places."""
        places = np.linspace(first, last, PLACES)
        nearest = np.argmin(np.stack([self.at(x) for x in places]), axis=0)
        low, high = places[np.maximum(nearest - 1, 0)], places[np.minimum(nearest + 1, PLACES - 1)]
        for _ in range(NARROWED):
            third = (high - low) / 3
            falls = self.at(low + third) > self.at(high - third)
            low, high = np.where(falls, low + third, low), np.where(falls, high, high - third)
        return np.asarray(0.5 * (low + high))

    def arcs(self) -> _Arcs:
        """Those of which the rates are known."""
        assert self.bends is not None
        known = np.asarray(self.bends.known.all(axis=-1) if self.sizes else self.bends.known)
        a, b, start, rise = (it[known] for it in (self.bends.start, self.bends.end, self.start, self.rise))
        column = np.broadcast_to(np.arange(known[0].size).reshape(known.shape[1:]), known.shape)[known]
        points = start, start + (rise + a) / 3, start + (2 * rise - b) / 3, start + rise
        return _Arcs(points, column, self.sizes)


class _Arcs(NamedTuple):
    """Cubics (m,), or of vectors (m, 3) where `sizes`, by the control points that they lie between."""

    points: tuple[Floats, Floats, Floats, Floats]
    column: NDArray[np.intp]  #: of the quantity that each is of
    sizes: bool

    def chosen(self, which: NDArray[np.bool_]) -> _Arcs:
        p, q, r, s = (it[which] for it in self.points)
        return _Arcs((p, q, r, s), self.column[which], self.sizes)

    def halves(self) -> _Arcs:
        """All first ones, then all second ones."""
        p, q, r, s = self.points
        pq, qr, rs = 0.5 * (p + q), 0.5 * (q + r), 0.5 * (r + s)
        left, right = 0.5 * (pq + qr), 0.5 * (qr + rs)
        middle = 0.5 * (left + right)
        pairs = (p, middle), (pq, right), (left, rs), (middle, s)
        first, second, third, last = (np.concatenate(pair) for pair in pairs)
        return _Arcs((first, second, third, last), np.tile(self.column, 2), self.sizes)

    def starts(self) -> Floats:
        return _sizes(self.points[0]) if self.sizes else self.points[0]

    def bound(self, what: What) -> Floats:
        """No less than what becomes of any value on it, by a function that bends upward."""
        held = _squares(*self.points) if self.sizes else self.points
        ends = (functools.reduce(which, held) for which in (np.minimum, np.maximum))
        least, most = (np.sqrt(np.maximum(it, 0.0)) for it in ends) if self.sizes else ends
        return np.maximum(what(least), what(most))


def _squares(p: Floats, q: Floats, r: Floats, s: Floats) -> tuple[Floats, ...]:
    """Control points (m,) of the squared magnitude of cubics by theirs: it is of degree six."""

    def dot(one: Floats, other: Floats) -> Floats:
        return np.asarray(np.einsum("mi,mi->m", one, other))

    between = (
        (2 * dot(p, r) + 3 * dot(q, q)) / 5,
        (dot(p, s) + 9 * dot(q, r)) / 10,
        (2 * dot(q, s) + 3 * dot(r, r)) / 5,
    )
    return dot(p, p), dot(p, q), *between, dot(r, s), dot(s, s)


def _sizes(vectors: Floats) -> Floats:
    return np.asarray(np.linalg.norm(vectors, axis=-1))


@dataclass(frozen=True)
class Curve:
    """values (k, ...) at times `t` (k,) [s]; where `sizes`, the magnitudes of vectors (k, ..., 3) count."""

    t: Floats
    values: Floats
    bends: Bends | None = None
    sizes: bool = False

    @property
    def looked_at(self) -> Floats:
        return _sizes(self.values) if self.sizes else self.values

    def mean(self, what: What = np.asarray) -> Floats:
        """Over time, of what becomes of the values."""
        if self.t[-1] <= self.t[0]:
            return what(self.looked_at[-1])
        pieces, h = self._pieces(), np.diff(self.t)
        means = pieces.means(what)
        if self.sizes and self.bends is not None and (bent := pieces.pass_zero()).any():
            means[bent] = pieces.chosen(bent).means_beside_zero(what)
        return np.asarray(np.tensordot(h, means, 1) / (self.t[-1] - self.t[0]))

    def largest(self, what: What = np.asarray) -> Floats:
        """Of what becomes of the values, at frames or between two."""
        at_frames = np.asarray(what(self.looked_at).max(axis=0))
        if self.bends is None or len(self.t) < 2:
            return at_frames
        close = CLOSE * np.abs(self.values).max(axis=(0, -1) if self.sizes else 0)
        found = _largest(self._pieces().arcs(), what, at_frames.ravel(), close.ravel())
        return found.reshape(at_frames.shape)

    def _pieces(self) -> _Pieces:
        ends = self.looked_at
        rise = np.diff(self.values, axis=0)
        return _Pieces(self.values[:-1], rise, self.bends, (ends[:-1], ends[1:]), self.sizes)


def _largest(arcs: _Arcs, what: What, found: Floats, close: Floats) -> Floats:
    """In each column (n,): on its arcs, or what is found already, but for what is close."""
    found = found.copy()
    for _ in range(HALVINGS):
        arcs = arcs.chosen(arcs.bound(what) > (found + close)[arcs.column])
        if not len(arcs.column):
            break
        arcs = arcs.halves()
        second = len(arcs.column) // 2
        np.maximum.at(found, arcs.column[second:], what(arcs.starts()[second:]))
    return found
