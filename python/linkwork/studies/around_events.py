"""The states just before and after events, and strikes of drivers, among the frames of a run: an impact jumps
between two of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.results.result import Result

__all__ = ["ENERGIES", "around_events", "energy_of_bodies", "without"]

#: Energies that follow from how bodies move where nothing else has any, and how far sums may differ.
ENERGIES, SAME_ENERGY = ("kinetic_energy", "potential_energy"), 1e-12


def energy_of_bodies(result: Result, name: str) -> Floats | None:
    """Of one of ENERGIES (k,) [J]: T = v . M v / 2, V = -m g . r. None: something else has energy of this
    kind, too."""
    header, values = result.header, getattr(result, name)
    if name == "kinetic_energy":
        of_bodies = 0.5 * np.einsum("kni,n,kni->k", result.velocity, header.mass, result.velocity)
        of_bodies += 0.5 * np.einsum("kni,nij,knj->k", result.omega, header.inertia, result.omega)
    else:
        of_bodies = -np.einsum("kni,n,i->k", result.position, header.mass, header.gravity)
    rest = values - of_bodies  # potentials are known but for a constant
    known = np.isfinite(values)
    largest = np.abs(values[known]).max() + np.abs(of_bodies[known]).max()
    if np.ptp(rest[known]) > SAME_ENERGY * largest:
        return None
    return np.asarray(of_bodies + rest[known][0])


def around_events(result: Result) -> tuple[Result, NDArray[np.intp]]:
    """With two frames at each event and each strike of a driver, before what it changed and after, and the
    places of these; NaN where they do not tell a field."""
    sides = _sides(result)
    t = np.array([side["t"] for side in sides])
    places = np.searchsorted(result.t, t)
    ours = places + np.arange(len(places))
    frames = {name: np.insert(np.asarray(field[:], dtype=float), places, np.nan, axis=0)
              for name, field in result._frames.items()}  # fmt: skip
    for place, side in zip(ours, sides, strict=True):
        for name, value in side.items():
            frames[name][place] = value
    found = Result(frames, result.header, result.statistics)
    for name, energy in zip(("kinetic", "potential"), ENERGIES, strict=True):
        of_bodies = energy_of_bodies(found, energy)
        if of_bodies is not None:
            frames[name][ours] = of_bodies[ours]
    return Result(frames, result.header, result.statistics), ours


def without(result: Result, places: NDArray[np.intp]) -> Result:
    """The other frames."""
    if not len(places):
        return result
    frames = {name: np.delete(field, places, axis=0) for name, field in result._frames.items()}
    return Result(frames, result.header, result.statistics)


def _sides(result: Result) -> list[dict[str, Any]]:
    """Fields before and after each of them as far as they are known, in order of time.

    At the same time first events that change nothing, with the state up to there, then strikes, then the
    events that change what these left.
    """
    n = len(result.body_names)
    struck = [
        [
            {"t": it.t, "q": y[: 7 * n].reshape(n, 7), "v": y[7 * n : -1].reshape(n, 6), "work": y[-1],
             "kinetic": kinetic, "potential": it.potential}
            for y, kinetic in ((it.before, it.kinetic_before), (it.after, it.kinetic_after))
        ]
        for it in result._strikes
    ]  # fmt: skip
    seen, changed = list[list[dict[str, Any]]](), list[list[dict[str, Any]]]()
    for it, energies in zip(result.events, _energies(result), strict=True):
        states = ((it.q_before, it.v_before), (it.q_after, it.v_after))
        pair = [
            {"t": it.t, "q": q, "v": v, **dict(zip(("work", "kinetic", "potential"), known, strict=True))}
            for (q, v), known in zip(states, energies, strict=True)
        ]
        (changed if it.changes else seen).append(pair)
    pairs = [*seen, *struck, *changed]
    return [side for pair in sorted(pairs, key=lambda pair: float(pair[0]["t"])) for side in pair]


def _energies(result: Result) -> Floats:
    """Around each event (m, 2, 3), NaN where they are not known, as of a run that failed."""
    known, count = result._energies_around_events, len(result.events)
    return known if len(known) == count else np.full((count, 2, 3), np.nan)
