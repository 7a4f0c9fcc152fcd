"""Whether joints of constant velocity folded through 180 degrees, beyond which they are others.

With the Euler parameters p of the second frame in the first, the equation of the joint is p_0 p_3 = 0: no
turn about z, p_3 = 0, is what it means. At 180 degrees both are zero, and a run may go on along p_0 = 0,
where nothing else tells: the equation holds.
"""

from __future__ import annotations

import numpy as np

from linkwork.errors import warn
from linkwork.results.result import Result
from linkwork.running.sampled_frames import ELEMENTS, Elements, axes_of, every_of, listed, times_of

__all__ = ["CONSTANT_VELOCITY", "warn_of_folded_joints"]

#: Kinds of joints that fold.
CONSTANT_VELOCITY = frozenset({"constant_velocity"})

#: Of p_3^2 - p_0^2 on the wrong side: less is roundoff beside 180 degrees.
FOLDED = 1e-6


def warn_of_folded_joints(result: Result) -> None:
    """LinkworkWarning: joints of constant velocity that are on the other side, as far as the frames tell."""
    header = result.header
    places = [k for k, kind in enumerate(header.joint_kinds) if kind in CONSTANT_VELOCITY][:ELEMENTS]
    if not places or not len(result):
        return
    names = [header.joint_names[k] for k in places]
    elements = Elements(names, header.joint_bodies[places], header.joint_frame[places])
    every = every_of(result, len(places))
    axis = axes_of(result, elements, every)
    along = sum(np.einsum("kei,kei->ke", axis(0, which), axis(1, which)) for which in (0, 1))
    folded = np.flatnonzero((np.asarray(along) < -2 * FOLDED).any(axis=0))
    if not len(folded):
        return
    first = int(np.argmax((np.asarray(along)[:, folded] < -2 * FOLDED).any(axis=1)))
    t = float(times_of(result, every)[first])
    warn(
        f"{listed([names[k] for k in folded])}: folded through 180 degrees, beyond which such a joint is "
        f"none: by t = {t:.6g} s the motion has gone on along another one, and is wrong from there on"
    )
