"""How large a mechanism is, wherever it stands."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from linkwork import _core


class Extent(NamedTuple):
    """Of a mechanism as it is at t = 0 [m]."""

    size: float  #: the longest side of the box around it, or the longest arm of a joint on a body; without
    #: both the longest radius of gyration, or 1
    reach: float  #: the largest coordinate, which roundoff is relative to


def extent(core: _core.Model) -> Extent:
    """Of centers of mass, and of the points of joints on bodies and on the ground."""
    arrays = core.joint_arrays()
    on_ground = arrays["bodies"] < 0
    points = np.concatenate([core.q0.reshape(-1, 7)[:, :3], arrays["origin"][on_ground]])
    arms = np.abs(arrays["origin"][~on_ground]).max(initial=0.0)
    size = max(float(np.ptp(points, axis=0).max()), float(arms))
    return Extent(size or _gyration(core) or 1.0, float(np.abs(points).max()))


def _gyration(core: _core.Model) -> float:
    """The longest radius of gyration of a body, by the trace of its inertia [m]; 0 for points."""
    heavy = core.mass > 0
    squares = np.trace(core.inertia, axis1=1, axis2=2)[heavy] / core.mass[heavy]
    return float(np.sqrt(squares.max(initial=0.0)))
