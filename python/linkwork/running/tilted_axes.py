"""Whether the bodies of elements about an axis tilted against it, so that their angle was one of many.

    theta = atan2(x_b . y_a, x_b . x_a)

is the angle by which b is turned about z_a where x_b stays across z_a, as in hinges, and in universal joints
whose other axis is x_b. Elsewhere it depends on which direction of b is x_b, and there is none at x_b = z_a.
"""

from __future__ import annotations

from functools import cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from linkwork import _core
from linkwork.equations.branches import shared_axes
from linkwork.errors import warn
from linkwork.modeling.elements import KINDS
from linkwork.motion.header import Header
from linkwork.results.result import Result
from linkwork.running.sampled_frames import ELEMENTS, Elements, axes_of, every_of, listed

__all__ = ["may_tilt", "warn_of_tilted_axes"]

#: Kinds that measure this angle, or its rate.
ABOUT_AN_AXIS = frozenset(
    {"rotational_spring_damper", "nonlinear_rotational_spring_damper", "motor", "rotational_friction",
     "rotational_stop", "rotational_inerter", "angle_driver"}
)  # fmt: skip

#: Of x_b out of the plane across z_a: so much [rad], and so many times the violation of the joints, is none.
NO_TILT, VIOLATIONS = 1e-3, 10.0

#: Axes of a joint and of an element that differ by no more [rad] are one.
HELD = NO_TILT / 10

#: From here on the angle is about to have no direction [rad].
UPRIGHT = np.radians(80.0)


def warn_of_tilted_axes(result: Result) -> None:
    """LinkworkWarning: x_b left the plane across z_a, as far as the frames that are looked at tell."""
    elements = _about_an_axis(result.header)
    if not elements.names or not len(result):
        return
    every = every_of(result, len(elements.names))
    axis = axes_of(result, elements, every)
    x_b, z_b, z_a = axis(1, 0), axis(1, 2), axis(0, 2)
    out = np.arcsin(np.clip(np.abs(np.einsum("kei,kei->ke", x_b, z_a)), 0.0, 1.0))
    least = max(NO_TILT, VIOLATIONS * float(result.violation[:, 0].max()))
    tilted = np.flatnonzero(out.max(axis=0) > least).tolist()
    if not tilted:
        return
    cosine = np.einsum("kei,kei->ke", z_b[:, tilted], z_a[:, tilted])
    degrees = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))).max()
    none = ", and where one of these comes to the axis, as at the end here, there is no angle"
    extent = "up to" if every == 1 else "at least"
    ends = none if out[-1].max() > UPRIGHT else ""
    warn(
        f"{listed([elements.names[k] for k in tilted])}: the axis of the second body tilts by {extent} "
        f"{degrees:.3g} degrees against that of the first: what is measured, and how it acts, then depends "
        f"on the choice of x axes{ends}; about an axis of a universal joint give its other axis as x_axis, "
        "or take model.joint_force on its angle_a or angle_b; elsewhere a bushing or a bending_spring"
    )


def may_tilt(model: _core.Model) -> bool:
    """Whether x_b may leave the plane across z_a in some motion: no joint of both bodies holds it there."""
    joints, forces = model.joint_arrays(), model.force_arrays()
    about = _is_about_an_axis("joint")[joints["kind"]], _is_about_an_axis("force")[forces["kind"]]
    if not (about[0].any() or about[1].any()):
        return False
    bodies, frame = (
        np.concatenate([joints[name][about[0]], forces[name][about[1]]]) for name in ("bodies", "frame")
    )
    hinges = np.flatnonzero(shared_axes(model)[:, 2])
    pairs, first = np.unique(_pairs(joints["bodies"][hinges]), return_index=True)
    place, wanted = np.searchsorted(pairs, _pairs(bodies)), _pairs(bodies)
    if not len(pairs) or (pairs[np.minimum(place, len(pairs) - 1)] != wanted).any():
        return True
    beside = hinges[first[place]]
    axis = joints["frame"][beside, :, :, 2]
    turned = joints["bodies"][beside, 0] != bodies[:, 0]
    axis[turned] = axis[turned, ::-1]
    cosine = np.einsum("ei,ei->e", axis[:, 0], frame[:, 0, :, 2])
    out = np.einsum("ei,ei->e", axis[:, 1], frame[:, 1, :, 0])
    return bool((1 - cosine**2 + out**2 > HELD**2).any())


@cache
def _is_about_an_axis(role: Literal["joint", "force"]) -> NDArray[np.bool_]:
    return np.array([kind in ABOUT_AN_AXIS for kind in KINDS[role]])


def _pairs(bodies: NDArray[np.integer]) -> NDArray[np.int64]:
    """A number of each two, whichever comes first."""
    found: NDArray[np.int64] = bodies.max(axis=1).astype(np.int64) * 2**32 + bodies.min(axis=1)
    return found


def _about_an_axis(header: Header) -> Elements:
    forces, drivers = (
        [k for k, kind in enumerate(kinds) if kind in ABOUT_AN_AXIS][:ELEMENTS]
        for kinds in (header.force_kinds, header.joint_kinds)
    )
    return Elements(
        [header.force_names[k] for k in forces] + [header.joint_names[k] for k in drivers],
        np.concatenate([header.force_bodies[forces], header.joint_bodies[drivers]]),
        np.concatenate([header.force_frame[forces], header.joint_frame[drivers]]),
    )
