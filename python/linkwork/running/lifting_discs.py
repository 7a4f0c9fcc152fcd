"""Whether rolling discs were held down, where on a plane they would lift off.

The multiplier of the first equation, n . (P_j - P_i) = R w, is the force of the plane on the disc along its
normal n, which points toward the disc.
"""

from __future__ import annotations

import numpy as np

from linkwork.arrays import Floats, Indices
from linkwork.results.result import Result
from linkwork.running.sampled_frames import ELEMENTS, every_of, listed, times_of

__all__ = ["DISCS", "note_lifting_discs"]

#: Kinds of joints that a plane would hold by pressure alone.
DISCS = frozenset({"rolling_disc"})

#: Pulls that are none: of the largest force along the normal, and of weight and centrifugal force m v^2 / R.
OF_LARGEST, OF_INERTIA = 1e-3, 1e-4


def note_lifting_discs(result: Result) -> None:
    """Statistics and summary say where planes pulled at discs that roll on them, as far as the frames tell.

    No warning: a joint may be meant to hold its disc. Those whose reaction does not follow from the motion
    are not looked at.
    """
    header = result.header
    discs = [k for k, kind in enumerate(header.joint_kinds) if kind in DISCS][:ELEMENTS]
    places = np.array([k for k in discs if header.reaction_unique[k]], dtype=int)
    if not len(places) or not len(result):
        return
    every = every_of(result, len(places))
    t, rows = times_of(result, every), header.joint_rows[places]
    normal = np.concatenate(
        [result.recorded_of("lambda", rows, every), result.recorded("lambda", np.s_[-1:])[:, rows]]
    )
    least = OF_LARGEST * np.abs(normal).max(axis=0) + OF_INERTIA * _inertial_forces(result, places, every)
    pulls = normal < -least
    held = np.flatnonzero(pulls.any(axis=0))
    if not len(held):
        return
    first, most = float(t[int(np.argmax(pulls.any(axis=1)))]), float(-normal[:, held].min())
    names = listed([header.joint_names[int(k)] for k in places[held]])
    result._statistics["lifting_discs"] = (
        f"{names}: by t = {first:.6g} s the plane pulls at the disc, with up to {most:.3g} N; one that only "
        "stands there lifts off"
    )


def _inertial_forces(result: Result, places: Indices, every: int) -> Floats:
    """The weight of each disc, and m v^2 / R at its highest speed (e,) [N]."""
    header = result.header
    bodies = header.joint_bodies[places]
    disc = np.where(bodies[:, 1] < 0, bodies[:, 0], bodies[:, 1])
    radius = np.array([header.parameters("joint", int(k))[0] for k in places])
    v = result.recorded_of("v", disc, every)[..., :3]
    fastest = np.sum(v * v, axis=-1).max(axis=0)
    found: Floats = header.mass[disc] * (np.linalg.norm(header.gravity) + fastest / radius)
    return found
