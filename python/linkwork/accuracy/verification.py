"""A second, finer run beside the first: what both say differs by the error of the first.

With a fixed step h and a method of order p the second has h / 2, and the error of whatever was recorded is
(x_h - x_h/2) 2^p / (2^p - 1), Richardson (1911); with tolerances it has a tenth of them. Where contacts begin
it has a little less than h / 2 and the frames that both have, every few steps: at which speed a contact
begins is known where a step ends, and where both have one there they are off by the same. What the first is
off in these speeds, by steps taken again, is the least that its error is then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork.accuracy.measures import (
    MOVING,
    AtRest,
    Bodies,
    Differences,
    Lateness,
    Sampled,
    Scales,
    rounding_of,
    same_times,
)
from linkwork.arrays import Floats

if TYPE_CHECKING:
    from linkwork.results.result import Result

Indices = NDArray[np.intp]

__all__ = ["Extremes", "Finer", "band", "difference", "joined", "state_error"]

#: Frames on either side whose errors count, too: where an error passes through zero its estimate does so a
#: little earlier or later. At least one, and this share of all.
NEIGHBORS = 0.01

#: Of the largest value: rounding, which both runs may share.
ROUNDING = 1e-15

#: By which the times of events may differ in two runs, all together, of the duration: beyond, frames between
#: them are not left out, as the motions differ.
SHIFTED = 0.01


class Finer(NamedTuple):
    """The second run, with frames at times of the first, and the factor of the difference."""

    result: Result
    factor: float
    #: these frames with all else that the run knows: its events, and when it ended; None: of a file
    own: Result | None = None

    @classmethod
    def of(cls, first: Result, second: Result, factor: float) -> Finer:
        """With those frames of the second run that show what one of the first does, and its work counted from
        where the first counts."""
        ours, its = _paired(first, second)
        frames = {name: second.recorded(name)[its] for name in second.header.frame_shapes()}
        if first.manifest.get("resumed"):
            frames["work"] += float(first.recorded("work", 0)) - float(second.recorded("work", 0))
        own = second._with_frames(frames)
        return cls(own._with_frames({**frames, "t": first.t[ours]}), factor, own)

    def in_file(self, stored: Finer | None) -> Finer | None:
        """As it was stored a moment ago, with what its file does not know."""
        if stored is None or self.own is None:
            return stored
        return stored._replace(own=self.own._with_frames({**stored.result._frames, "t": self.own.t}))


def joined(first: Result, then: Result) -> Result:
    """The frames of a run and of one that begins anew where it ended."""
    frames = {
        name: np.concatenate([first.recorded(name)[:-1], then.recorded(name)])
        for name in then.header.frame_shapes()
    }
    frames["work"][len(first) - 1 :] += first.recorded("work", -1)
    return type(then)(frames, then.header, then.statistics, events=[*first.events, *then.events])


def difference(first: Any, second: Any, of: Callable[[Floats, Floats], Floats]) -> Any:
    """`of` two arrays; of records of arrays, such as a Reaction, a record of the same kind."""
    if isinstance(first, tuple):
        return type(first)(*(difference(a, b, of) for a, b in zip(first, second, strict=True)))
    if is_dataclass(first):
        pairs = {it.name: (getattr(first, it.name), getattr(second, it.name)) for it in fields(first)}
        kind: Any = type(first)
        return kind(**{name: difference(*pair, of) for name, pair in pairs.items()})
    return of(first, second) if isinstance(first, np.ndarray) else first


def band(t: Floats, finer: Finer) -> Callable[[Floats, Floats], Floats]:
    """Error of the first of two arrays over time (k, ...), the second that of the finer run: at each of the
    times `t` (k,) the largest of its neighbors, NaN before and after the frames of the finer run."""
    its, ours = same_times(finer.result.t, t)

    def of(first: Floats, second: Floats) -> Floats:
        apart = np.full(first.shape, np.nan)
        apart[ours] = finer.factor * np.abs(first[ours] - second[its])
        largest, reach = apart.copy(), max(1, round(NEIGHBORS * len(ours)), _spacing(ours))
        for shift in range(1, min(reach, len(first) - 1) + 1):
            np.fmax(largest[shift:], apart[:-shift], out=largest[shift:])
            np.fmax(largest[:-shift], apart[shift:], out=largest[:-shift])
        largest[: ours.min(initial=len(first))] = largest[ours.max(initial=-1) + 1 :] = np.nan
        largest += ROUNDING * np.abs(first[ours]).max(initial=0.0)
        return largest

    return of


def _spacing(places: Indices) -> int:
    """Frames from one that the finer run has, too, to the next."""
    return round(float(np.median(np.diff(places)))) if len(places) > 1 else 1


class StateError(NamedTuple):
    """The largest of poses and velocities, relative as those of linkwork.accuracy.measures."""

    error: float
    body: int  #: whose it is; -1: all bodies are one connected part, or nothing is known


class Extremes(NamedTuple):
    """What a motion came to between its frames, too."""

    speed: Floats  #: V of the connected part of each body, see linkwork.accuracy.measures (n,) [m/s]
    part: Indices  #: (n,) of each body
    begin: Floats  #: of parts of the run (r,) [s]
    end: Floats  #: (r,) [s]
    accelerations: Floats  #: the largest in each connected part (r, p) [m/s2]

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> Extremes | None:
        """From what `_core.Run.judge` found; None: nothing."""
        if not found["peaks"]:
            return None
        begin, end, accelerations = map(np.array, zip(*found["peaks"], strict=True))
        return cls(found["largest_speed"], found["connected_part"], begin, end, accelerations)

    def peaks(self, begin: Floats, end: Floats, bodies: Bodies) -> Floats:
        """Of the connected parts of `bodies` in spans of time (w,) [s]: (w, p) [m/s2]."""
        _, ours = np.unique(bodies.part, return_index=True)
        first = np.clip(np.searchsorted(self.end, begin), 0, len(self.begin) - 1)
        last = np.maximum(np.searchsorted(self.begin, end, side="right"), first + 1)
        padded = np.pad(self.accelerations[:, self.part[ours]], ((0, 1), (0, 0)))
        spans = np.stack([first, last], axis=1).ravel()
        peaks: Floats = np.maximum.reduceat(padded, spans, axis=0)[::2]
        return peaks


def state_error(
    first: Result, finer: Finer, at_rest: AtRest = MOVING, between: Extremes | None = None
) -> StateError:
    """By a second run; 1 where too few frames are in both. `between` them what is late is off by as much of a
    velocity as it accelerates there."""
    if len(finer.result) < min(2, len(first)):
        return StateError(1.0, -1)
    motion, exact, bodies = Sampled.of(first), Sampled.of(finer.result), Bodies.of(first.header)
    differences = Differences.between(motion, exact)
    rtol = first.manifest["options"].get("rtol")
    if between is not None:
        at_rest = at_rest._replace(speed=np.maximum(at_rest.speed, between.speed))
    scales = Scales.of(exact, bodies, rtol, at_rest)
    states = differences.states(scales).max(axis=0, initial=0.0)
    if between is not None and (late := Lateness.of(motion, exact, bodies, scales)) is not None:
        off = (late.by * between.peaks(late.begin, late.end, bodies) / scales.speed).max(axis=0)
        states = np.maximum(states, off[bodies.part])
    error = float(finer.factor * states.max(initial=0.0))
    return StateError(error, int(states.argmax()) if bodies.part.any() else -1)


# --- which frames are compared -----------------------------------------------------------------------------


def _paired(first: Result, second: Result) -> tuple[Indices, Indices]:
    """Places of frames of two runs that show the same: at the same time, or at the event that ends both.

    Between the times that an event which changes the state has in the two, one of them is before it and the
    other after it: frames there are left out, unless too few were left.
    """
    its, ours = same_times(second.t, first.t)
    apart = _inside(first.t[ours], _shifts(first, second), rounding_of(first.t))
    if np.count_nonzero(~apart) >= min(2, len(ours)):
        its, ours = its[~apart], ours[~apart]
    last = len(first) - 1
    if last not in ours and _ending(first) and _ending(first) == _ending(second):
        its, ours = np.append(its, len(second) - 1), np.append(ours, last)
    return ours, its


def _shifts(first: Result, second: Result) -> Floats:
    """(m, 2): when events that change the state come in the two runs, the earlier time first; none where that
    is so far apart that the motions differ."""
    later: dict[str, Iterator[float]] = {
        name: iter([it.t for it in second.events if it.name == name])
        for name in {it.name for it in second.events}
    }
    found = []
    for it in first.events:
        its_time = next(later.get(it.name, iter(())), None)
        if its_time is not None and it.changes:
            found.append(sorted((it.t, its_time)))
    shifts = np.array(found).reshape(-1, 2)
    return shifts if np.diff(shifts).sum() <= SHIFTED * np.ptp(first.t) else shifts[:0]


def _inside(t: Floats, spans: Floats, rounding: float) -> NDArray[np.bool_]:
    """Whether times are in any of the spans (m, 2)."""
    begun = np.searchsorted(np.sort(spans[:, 0]) - rounding, t, side="right")
    inside: NDArray[np.bool_] = begun > np.searchsorted(np.sort(spans[:, 1]) + rounding, t, side="left")
    return inside


def _ending(result: Result) -> str:
    """The event at which the run ended; "": at none."""
    last = result.events[-1] if result.events else None
    return last.name if last is not None and result.t[-1] - last.t <= rounding_of(result.t) else ""
