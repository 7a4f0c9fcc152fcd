"""How large a mechanism is, wherever it stands."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from linkwork import _core


class Extent(NamedTuple):
    """Of a mechanism as it is at t = 0 [m]."""

    size: float  #: the longest side of the box around it, or the longest arm of a joint on a body; 1 for none
    reach: float  #: the largest coordinate, which roundoff is relative to


def extent(core: _core.Model) -> Extent:
    """Of centers of mass, and of the points of joints on bodies and on the ground."""
    arrays = core.joint_arrays()
    on_ground = arrays["bodies"] < 0
    points = np.concatenate([core.q0.reshape(-1, 7)[:, :3], arrays["origin"][on_ground]])
    arms = np.abs(arrays["origin"][~on_ground]).max(initial=0.0)
    size = max(float(np.ptp(points, axis=0).max()), float(arms))
    return Extent(size or 1.0, float(np.abs(points).max()))
