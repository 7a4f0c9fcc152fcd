"""Axes that a file means to be parallel, made so: it has angles with few digits, such as 1.57 for pi / 2."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwork.importers.description import Description
from linkwork.importers.tree import link_states

Floats = NDArray[np.float64]


def align_axes(description: Description, tolerance: float) -> None:
    """Give joints whose axes are parallel to within `tolerance` [rad] a common direction.

    At coordinates zero. The first of them has it, rounded to an axis of the model where it is that near.
    """
    states = link_states(description, {}, {})
    known: list[Floats] = list(np.eye(3))
    for joint in description.joints:
        A = states[joint.parent].frame.A @ joint.in_parent.A
        motions = []
        for motion in joint.motions:
            axis = A @ motion.axis
            near = next((u for u in known if np.linalg.norm(np.cross(u, axis)) <= np.sin(tolerance)), None)
            if near is None:
                known.append(axis)
                motions.append(motion)
                continue
            common = near * np.sign(near @ axis)
            angle = float(np.linalg.norm(np.cross(common, axis)))
            if angle > 1e-12:
                description.note(
                    "axis",
                    f"joint '{joint.name}'",
                    f"its axis is turned by {angle:.2g} rad, to be parallel to others",
                )
            motions.append(replace(motion, axis=A.T @ common / np.linalg.norm(common)))
        joint.motions = motions
