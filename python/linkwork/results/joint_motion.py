"""Coordinates of many joints at a time: from a file their poses are read together, not anew for each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import warn
from linkwork.modeling.coordinates import JointCoordinate, coordinates_of

if TYPE_CHECKING:
    from linkwork.results.result import Result

__all__ = ["each_coordinate", "ends_of"]

#: By which the mean rate may miss an angle between two frames before its full turns are doubtful [rad].
MISSED_TURN = np.pi / 2

#: Of poses and velocities that are held at a time.
HELD_NUMBERS = 16_000_000

#: Of the pose and velocity of the two bodies of a joint.
OF_JOINT = 2 * (7 + 6)


def each_coordinate(result: Result, chosen: Sequence[tuple[int, str]]) -> Iterator[JointCoordinate]:
    """Of joints by place, each with the name of the coordinate, which its kind has.

    LinkworkWarning: frames too far apart to tell how often an angle went round.
    """
    at_once = max(1, HELD_NUMBERS // (OF_JOINT * max(1, len(result))))
    for first in range(0, len(chosen), at_once):
        yield from _read_together(result, chosen[first : first + at_once])


def ends_of(result: Result, sides: NDArray[np.integer[Any]]) -> Iterator[list[tuple[Floats, Floats]]]:
    """Poses (k, 7) and velocities (k, 6) of the two bodies of each joint or force element, (., 2)."""
    bodies = np.unique(sides[sides >= 0])
    q, v = (result.recorded_of(name, bodies) for name in ("q", "v"))
    ground = np.tile([0.0, 0, 0, 1, 0, 0, 0], (len(result), 1)), np.zeros((len(result), 6))
    places = np.searchsorted(bodies, sides)
    for of, at in zip(sides.tolist(), places.tolist(), strict=True):
        yield [ground if body < 0 else (q[:, k], v[:, k]) for body, k in zip(of, at, strict=True)]


def _read_together(result: Result, chosen: Sequence[tuple[int, str]]) -> Iterator[JointCoordinate]:
    header, counted = result.header, _counted(result)
    sides = header.joint_bodies[[joint for joint, _ in chosen]]
    for (joint, which), ends in zip(chosen, ends_of(result, sides), strict=True):
        found = coordinates_of(which, result.t, ends, header.joint_origin[joint], header.joint_frame[joint])
        if which != "displacement":
            found, known, lost = _turned(result.t, found, counted.get((joint, which), ()))
            _check_turns(f"{which} of '{header.joint_names[joint]}'", result.t, found, known, lost)
        yield found


def _counted(result: Result) -> dict[tuple[int, str], list[tuple[float, float, float | None]]]:
    """Of joints and coordinates: from one frame to another [s] they turned by an angle [rad], in steps amid
    these, where the frames do not tell it. None: neither do the steps, which were too long."""
    found: dict[tuple[int, str], list[tuple[float, float, float | None]]] = {}
    for joint, which, before, t, angle in result._statistics.get("turned", ()):
        found.setdefault((joint, which), []).append((before, t, angle))
    return found


def _turned(
    t: Floats, angle: JointCoordinate, counted: Sequence[tuple[float, float, float | None]]
) -> tuple[JointCoordinate, NDArray[np.bool_], NDArray[np.bool_]]:
    """With the full turns that the run counted, between which frames (k - 1,) it did, and between which it
    could not, or the frames are not here that it counted for."""
    value, (known, lost) = angle.value.copy(), np.zeros((2, max(len(t) - 1, 0)), dtype=bool)
    for before, after, turned in counted:
        first, last = int(np.searchsorted(t, before, "right")) - 1, int(np.searchsorted(t, after, "left"))
        missing = first < 0 or last >= len(t) or (t[first], t[last]) != (before, after)
        if turned is None or missing:
            lost[max(first, 0) : last] = True
            continue
        value[last:] += 2 * np.pi * np.round((turned - (value[last] - value[first])) / (2 * np.pi))
        known[first:last] = True
    return JointCoordinate(value, angle.rate), known, lost


def _check_turns(
    what: str, t: Floats, angle: JointCoordinate, known: NDArray[np.bool_], lost: NDArray[np.bool_]
) -> None:
    """LinkworkWarning: turns between frames follow from the rates at these alone, or not even from them."""
    change = np.diff(angle.value)
    missed = np.abs(change - np.diff(t) * (angle.rate[1:] + angle.rate[:-1]) / 2)
    doubts = (lost | (missed > MISSED_TURN), ""), (np.abs(change) > np.pi, " but by its rates there")
    for doubtful, how in ((doubt & ~known, how) for doubt, how in doubts):
        if doubtful.any():
            k = int(np.argmax(doubtful))
            return warn(
                f"{what}: frames are too far apart, such as at t = {t[k]:g} and {t[k + 1]:g} s, to tell{how} "
                "how often it went round between them: record more frames"
            )
    return None
