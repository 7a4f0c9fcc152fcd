"""The poses of a run on their way into a page: as one array, in pieces of some frames, or by a server.

Of many bodies a page would have to hold all frames as numbers at once, tens of times what they take deflated.
So they come in pieces of their own, which the page inflates when the time comes to them, and forgets again.
The steps of the numbers are those of all frames: where pieces meet nothing jumps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.view.encoding import Extremes, Pack

if TYPE_CHECKING:
    from linkwork.results.result import Result

#: Numbers of one array; of more there are pieces, each of not more, or of a frame.
MOST_NUMBERS = 4_000_000

#: How many times its own extent a mechanism may be off the inertial origin.
FAR = 100.0

#: Numbers of a piece that a server gives out: few, as a page that jumps to a time waits for one.
STREAMED_NUMBERS = 1_000_000


def page_origin(result: Result) -> Floats:
    """Where a page has its origin (3,) [m]: amid the bodies at the start, where that is far off against their
    extent, as pictures are drawn in single precision; else the inertial one."""
    r = result.recorded("q", 0)[:, :3] if len(result) else np.zeros((0, 3))
    if not len(r):
        return np.zeros(3)
    low, high = r.min(axis=0), r.max(axis=0)
    header = result.header
    arms = [
        np.abs(header.joint_origin[header.joint_bodies >= 0]),
        np.abs(header.force_origin[header.force_bodies >= 0]),
    ]
    size = max(float((high - low).max()), *(float(arm.max(initial=0.0)) for arm in arms))
    middle: Floats = (low + high) / 2
    return middle if np.abs(middle).max() > FAR * size else np.zeros(3)


def add_poses(
    pack: Pack, result: Result, frames: Sequence[int], followed: NDArray[np.intp], origin: Floats
) -> tuple[list[str], float]:
    """Pieces, none where all fit into the pack, and the error of positions [m].

    With pieces the pack has the tracks of the bodies `followed` through all frames.
    """
    bodies = result.header.body_count
    each = frames_of_piece(bodies)
    if not in_pieces(len(frames), bodies):
        whole = np.concatenate(list(_chunks(result, frames, each, origin)))
        error = pack.add_quantized("q", whole)
        return [], float(error[:, :3].max(initial=0.0))
    extremes, tracks = Extremes(), []
    for q in _chunks(result, frames, each, origin):
        extremes.add(q)
        tracks.append(q[:, followed])
    channels = extremes.channels()
    channels.add_to(pack, "q")
    pack.add_quantized("track", np.concatenate(tracks))
    pieces = []
    for q in _chunks(result, frames, each, origin):
        piece = Pack()
        piece.add("q", channels.differences(q), "u2")
        pieces.append(piece.text())
    error = np.reshape(channels.step / 2, (-1, 7))
    return pieces, float(error[:, :3].max(initial=0.0))


def in_pieces(frames: int, bodies: int) -> bool:
    """Whether so many poses are too much for one array."""
    return 7 * frames * bodies > MOST_NUMBERS


def frames_of_piece(bodies: int) -> int:
    return max(1, MOST_NUMBERS // max(7 * bodies, 1))


def frames_of_stream(bodies: int) -> int:
    """Of a piece that a server gives out."""
    return max(1, STREAMED_NUMBERS // max(7 * bodies, 1))


def pieces_of_stream(result: Result) -> int:
    return -(-len(result) // frames_of_stream(result.header.body_count))


def stream_piece(result: Result, number: int, origin: Floats) -> bytes:
    """The poses of some frames, 7 numbers a body, float32, frame by frame. FileError: the file changed."""
    each = frames_of_stream(result.header.body_count)
    q = from_origin(result.recorded("q", slice(each * number, each * (number + 1))), origin)
    return q.astype("<f4").tobytes()


def from_origin(q: Floats, origin: Floats) -> Floats:
    """Poses (..., 7) with positions from `origin` (3,) on."""
    if not origin.any():
        return q
    moved: Floats = q - np.concatenate([origin, np.zeros(4)])
    return moved


def stream_precision(low: Floats, high: Floats) -> float:
    """The error of positions between two corners (3,) by rounding [m]."""
    return float(np.spacing(np.float32(max(np.abs(low).max(), np.abs(high).max())))) / 2


def _chunks(result: Result, frames: Sequence[int], each: int, origin: Floats) -> Iterator[Floats]:
    """q (k, n, 7) of so many frames at a time, with Euler parameters that go on without a jump of sign."""
    before: Floats | None = None
    for first in range(0, len(frames), each):
        found = from_origin(_read(result, frames[first : first + each]), origin)
        q = continuous(found if before is None else np.concatenate([before[None], found]))
        before = q[-1]
        yield q[len(q) - len(found) :]


def _read(result: Result, frames: Sequence[int]) -> Floats:
    """q (k, n, 7) of ascending frames: at once, where what is between them is not much."""
    first, count = frames[0], frames[-1] - frames[0] + 1
    if 7 * count * result.header.body_count <= MOST_NUMBERS:
        return result.recorded("q", slice(first, first + count))[np.subtract(frames, first)]
    return np.stack([result.recorded("q", frame) for frame in frames])


def continuous(q: Floats) -> Floats:
    """Euler parameters without jumps of sign: p and -p are the same pose."""
    r, p = q[..., :3], q[..., 3:]
    jumps = np.where(np.sum(p[1:] * p[:-1], axis=-1) < 0, -1.0, 1.0)
    sign = np.concatenate([np.ones_like(p[:1, :, 0]), np.cumprod(jumps, axis=0)])
    return np.concatenate([r, p * sign[..., None]], axis=-1)
