"""Derivatives of the forces of a mechanism by small motions or velocities, and what is doubtful of them.

Differences of fourth order, many bodies at a time: those that no force element has in common (Curtis,
Powell, Reid, On the estimation of sparse Jacobian matrices, 1974). Each is looked at in the very steps it is
made of, f(-2h) to f(2h): of smooth forces D(h) = (f(h) - f(-h)) / 2h and B(h) = (f(h) + f(-h) - 2 f(0)) / h
are so that D(2h) - D(h) and B(2h) - 2 B(h) are of third order. At a kink, as where a contact is less deep
than 2h, one of them is not: then steps become shorter, until it is, or digits end. A kink at the state itself
looks the same in all steps: there is no derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.constraints.equations import Sparse

__all__ = [
    "DOUBT", "ROUNDING", "SMOOTH", "STENCIL", "Derivative", "Doubt", "Steps", "assembled", "colors",
    "force_derivative", "partners_of", "unsmooth",
]  # fmt: skip

Indices = NDArray[np.intp]

#: f' = sum w_k f(k h) / h.
STENCIL = ((-2, 1 / 12), (-1, -2 / 3), (1, 2 / 3), (2, -1 / 12))

#: Differences below this part of what is subtracted are zero; those that look for kinks have so much more.
ROUNDING, OF_BEND = 1e-15, 8.0

#: Steps become shorter by this factor where differences are not smooth but for such a part, as long as no
#: more than the other part of them is rounding of positions or velocities.
SHORTEN, SMOOTH, COARSE = 8.0, 1e-6, 1e-4

#: What is not smooth falls in shorter steps by more than this where the derivative, if not smooth itself, has
#: slopes on both sides: as with f = x |x|, whose derivative is |x|.
SLOPES = 6.0

#: Errors of a derivative, relative, that make it doubtful, where the first differences are not smooth by so
#: many roundings; what grows by more in shorter steps is a leap, or noise, which forces may have by such a
#: part of what acts on the body.
DOUBT, MANY, GROWING, NOISE = 1e-4, 30.0, 3.0, 1e-10


class Doubt(NamedTuple):
    entries: Sparse  # (6n, 6n) of those that shorter steps change, or that differ to both sides: by how much
    h: Floats  # (6n,) the shortest steps
    noise: Floats  # (6n,) what forces may have of it


class Derivative(NamedTuple):
    J: Sparse  # (6n, 6n)
    doubt: Doubt


class Steps(NamedTuple):
    """In which differences begin."""

    h: Floats  # (6n,)
    part: float  # of the size of the mechanism, or of its velocities
    blur: Floats  # (n,) rounding of what is changed by them, relative
    arms: Floats  # (n,) sizes of the bodies [m]
    largest: Floats  # (6n,) forces of which they may have the rounding, beside `gross`


class _Differences(NamedTuple):
    """Of some entries (p, 6, 6): by pair of bodies, row, column."""

    value: Floats
    off: Floats  # what is not smooth, with its sign
    rounding: Floats

    def where(self, chosen: NDArray[np.bool_], other: _Differences) -> _Differences:
        return _Differences(*(np.where(chosen, a, b) for a, b in zip(self, other, strict=True)))


def force_derivative(
    force: Callable[[Floats], Floats], gross: Floats, steps: Steps, pairs: NDArray[np.integer]
) -> Derivative:
    """dg/dx of g(x) (6n,) about x = 0, by force elements between these pairs of bodies (k, 2).

    `gross` (6n,): what g is the sum of, see Equations.gross_forces.
    """
    search = _Search(force, gross, steps, pairs)
    search.resolve()
    doubt = Doubt(search.matrix(search.doubtful()), search.h, search.noise())
    return Derivative(search.matrix(search.best.value), doubt)


class _Search:
    """Steps that are short enough for each body and direction.

    `best` is the best known of each entry, `last` what the last steps gave, `unsure` where it is not smooth.
    """

    def __init__(
        self, force: Callable[[Floats], Floats], gross: Floats, steps: Steps, pairs: NDArray[np.integer]
    ) -> None:
        self.force, self.gross, self.n, self.steps = force, gross, len(steps.arms), steps
        self.h, self.blur = steps.h.copy(), steps.blur[:, None].repeat(6, axis=1)
        self.unit = np.column_stack([np.ones(self.n)] * 3 + [1 / steps.arms] * 3)
        self.near, self.color = _near_and_colors(self.n, pairs)
        self.row, self.mover = self.near
        self.here = force(np.zeros(6 * self.n))
        self.best = self.first = self.last = self._differences(np.ones((self.n, 6), dtype=bool))
        off, rounding = np.abs(self.first.off), self._rounding(self.first)
        self.unsure = off > SMOOTH * np.abs(self.first.value) + rounding
        self.beyond_rounding = off > MANY * rounding
        self.limit = np.full_like(self.first.value, np.nan)

    def resolve(self) -> None:
        open_, settled = self.unsure.copy(), ~self.unsure
        while open_.any():
            wanted = np.zeros((self.n, 6), dtype=bool)
            np.logical_or.at(wanted, self.mover, open_.any(axis=1))
            wanted &= self.blur * SHORTEN <= COARSE
            if not wanted.any():
                break
            self.h = np.where(wanted.ravel(), self.h / SHORTEN, self.h)
            self.blur = np.where(wanted, SHORTEN * self.blur, self.blur)
            open_ &= wanted[self.mover][:, None, :]
            settled |= self._compare(self._differences(wanted), open_)
            open_ &= ~settled
        self.unsure = ~settled

    def _compare(self, shorter: _Differences, open_: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Which entries are known now. Where shorter steps tell nothing, by rounding, are open no more."""
        last, rounding = self.last, self._rounding(shorter)
        before, now = np.abs(last.off), np.abs(shorter.off)
        open_ &= rounding < before / 4
        near = SMOOTH * np.abs(shorter.value) + rounding
        falls, smooth = now <= before / SLOPES, now <= near
        same = falls & (np.abs(shorter.value - last.value) <= near)
        # D(h) = D + b h
        limit = shorter.value - (last.value - shorter.value) / (SHORTEN - 1)
        sloping = falls & (np.abs(limit - self.limit) <= SMOOTH * np.abs(last.value) + rounding)
        found = shorter._replace(value=np.where(sloping & ~smooth, limit, shorter.value))
        better = open_ & (smooth | sloping | (now < np.abs(self.best.off))) & ~same
        self.best = found.where(better, last.where(open_ & same, self.best))
        self.limit = np.where(open_, limit, self.limit)
        self.last = shorter.where(open_, last)
        return open_ & (smooth | same | sloping)

    def doubtful(self) -> Floats:
        """By how much entries may be wrong: (p, 6, 6), zero where they are not doubtful."""
        off, size = np.abs(self.best.off), np.abs(self.best.value)
        doubt = self.unsure & self.beyond_rounding & (off > DOUBT * size)
        if not doubt.any():
            return np.zeros_like(off)
        row, column, own = self._rows(), self._columns(), np.zeros(6 * self.n)
        np.maximum.at(own, row, np.where(row == column, size, 0.0))
        noise = self.noise()[row] / self.steps.h[column]
        beside = DOUBT * np.sqrt(own[row] * own[column])
        grows = np.abs(self.last.off) > GROWING * np.abs(self.first.off)
        return np.where(doubt & ~(grows & ((off <= beside) | (off <= noise))), self.best.off, 0.0)

    def noise(self) -> Floats:
        """A small part of what acts on each body, and would by motions of the size of the mechanism (6n,)."""
        largest, steps = self.gross + self.steps.largest, self.steps
        np.add.at(largest, self._rows(), np.abs(self.first.value) * steps.h[self._columns()] / steps.part)
        return NOISE * largest

    def matrix(self, entries: Floats) -> Sparse:
        kept = entries != 0.0
        return assembled([(entries[kept], self._rows()[kept], self._columns()[kept])], 6 * self.n)

    def _rows(self) -> Indices:
        return np.broadcast_to((6 * self.row[:, None] + np.arange(6))[:, :, None], (len(self.row), 6, 6))

    def _columns(self) -> Indices:
        return np.broadcast_to((6 * self.mover[:, None] + np.arange(6))[:, None, :], (len(self.row), 6, 6))

    def _rounding(self, found: _Differences) -> Floats:
        """Of entries, by that of their terms, and by that of what is moved in something stiff."""
        units = self.unit[self.row][:, :, None] * self.unit[self.mover][:, None, :]
        stiffest = np.zeros(self.n)
        np.maximum.at(stiffest, self.mover, (np.abs(found.value) * units).max(axis=(1, 2), initial=0.0))
        np.maximum.at(stiffest, self.row, stiffest[self.mover])
        blur = self.blur[self.mover][:, None, :] * stiffest[self.mover][:, None, None] / units
        return np.asarray(OF_BEND * (found.rounding + blur))

    def _differences(self, wanted: NDArray[np.bool_]) -> _Differences:
        """In the columns `wanted` (n, 6); zero in others."""
        found = np.zeros((3, len(self.row), 6, 6))
        gross, h = self.gross, self.h.reshape(-1, 6)
        for chosen, k in self._moves(wanted):
            x = np.zeros((self.n, 6))
            x[chosen, k] = h[chosen, k]
            back, less, more, far = (self.force(s * x.ravel()) for s, _ in STENCIL)
            total = (8 * (more - less) - (far - back)) / 12
            terms = (8 * (np.abs(more) + np.abs(less)) + np.abs(far) + np.abs(back)) / 12
            rounding = ROUNDING * np.maximum(terms, gross)
            off = unsmooth(back, less, self.here, more, far)
            at = np.flatnonzero(chosen[self.mover])
            kept = np.where(np.abs(total) > rounding, total, 0.0), off, rounding
            for part, values in zip(found, kept, strict=True):
                part[at, :, k] = values.reshape(-1, 6)[self.row[at]] / h[self.mover[at], k, None]
        return _Differences(*found)

    def _moves(self, wanted: NDArray[np.bool_]) -> Iterator[tuple[NDArray[np.bool_], int]]:
        """Which bodies (n,) move at a time, and in which of six directions."""
        for c in range(self.color.max(initial=-1) + 1):
            for k in range(6):
                chosen = (self.color == c) & wanted[:, k]
                if chosen.any():
                    yield chosen, k


def unsmooth(back: Floats, less: Floats, here: Floats, more: Floats, far: Floats) -> Floats:
    """What is not smooth of forces at -2h, -h, 0, h, 2h, with the sign of the leap: of their change in h."""
    apart = (far - back) / 4 - (more - less) / 2
    bend = 2 * (more + less - 2 * here) - (far + back - 2 * here) / 2
    return np.where(np.abs(apart) > np.abs(bend), apart, bend)


def _near_and_colors(n: int, pairs: NDArray[np.integer]) -> tuple[tuple[Indices, Indices], Indices]:
    """Bodies that act on each other, each pair in both orders; and colors (n,) of the bodies: of those of one
    color no two are near the same body."""
    from scipy.sparse import coo_array, eye_array

    inner = pairs[(pairs >= 0).all(axis=1)]
    touch = coo_array((np.ones(len(inner)), (inner[:, 0], inner[:, 1])), shape=(n, n))
    touch = (touch + touch.T + eye_array(n)).tocsr()
    both, near = (touch @ touch).tocoo(), touch.tocoo()
    return (near.row.astype(int), near.col.astype(int)), colors(n, np.column_stack([both.row, both.col]))


def partners_of(values: Floats, pairs: NDArray[np.integer]) -> Floats:
    """The largest value of each body (n,) and of those that it makes pairs with."""
    out, inner = values.copy(), pairs[(pairs >= 0).all(axis=1)]
    for a, b in (inner.T, inner.T[::-1]):
        np.maximum.at(out, a, values[b])
    return out


def assembled(
    parts: list[tuple[Floats, Indices, Indices]], size: int, row_count: int | None = None
) -> Sparse:
    """A matrix (row_count or size, size) of values, rows and columns."""
    from scipy.sparse import coo_array

    values, rows, columns = (
        (np.concatenate(list(part)) for part in zip(*parts, strict=True)) if parts else (np.zeros(0),) * 3
    )
    keep = values != 0.0
    places = rows[keep].astype(int), columns[keep].astype(int)
    return coo_array((values[keep], places), shape=(size if row_count is None else row_count, size)).tocsr()


def colors(n: int, pairs: NDArray[np.integer]) -> Indices:
    """A color (n,) for each body, other than those of its partners: the first that is free."""
    from scipy.sparse import coo_array

    inner = pairs[(pairs >= 0).all(axis=1) & (pairs[:, 0] != pairs[:, 1])]
    graph = coo_array((np.ones(len(inner)), (inner[:, 0], inner[:, 1])), shape=(n, n))
    graph = (graph + graph.T).tocsr()
    color = np.full(n, -1)
    for body in range(n):
        taken = set(color[graph.indices[graph.indptr[body] : graph.indptr[body + 1]]].tolist())
        color[body] = next(c for c in range(n + 1) if c not in taken)
    return color
