"""Whether bushings turned beyond half a turn, where their torque changes its sign.

The rotation vector of the second frame against the first is not longer than pi. With its Euler parameters p,
p_0 = cos(phi / 2) >= 0: beyond half a turn p goes on as -p, that of another vector.
"""

from __future__ import annotations

import numpy as np

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.errors import warn
from linkwork.modeling.elements import KINDS
from linkwork.motion.header import Header
from linkwork.results.result import Result
from linkwork.running.sampled_frames import ELEMENTS, Elements, every_of, listed, of_bodies, times_of

__all__ = ["BUSHINGS", "warn_of_turned_bushings"]

#: Kinds of force elements whose torque goes by the rotation vector.
BUSHINGS = frozenset({"bushing"})

#: From frame to frame less is roundoff [rad].
NO_TURN = 1e-6

#: Of the turn from frame to frame speeds must make so much: else bodies may have gone the other way round.
BY_SPEED = 0.5


def warn_of_turned_bushings(result: Result) -> None:
    """LinkworkWarning: bushings turned beyond half a turn, as far as the frames that are looked at tell."""
    elements = _bushings(result.header)
    if not elements.names or not len(result):
        return
    every = every_of(result, len(elements.names))
    t = times_of(result, every)
    beyond = _goes_beyond(t, *_relative(result, elements, every))
    turned = np.flatnonzero(beyond.any(axis=0))
    if not len(turned):
        return
    first = float(t[1 + int(np.argmax(beyond.any(axis=1)))])
    names = listed([elements.names[int(k)] for k in turned])
    warn(
        f"{names}: turned beyond half a turn by t = {first:.6g} s, where the rotation vector that a bushing "
        "goes by, and its torque, change their signs: from there on the motion is not that of an elastic "
        "bearing; about one axis a rotational_spring_damper counts full turns"
    )


def _bushings(header: Header) -> Elements:
    """Those that resist turns, or may do so."""
    places = [k for k, kind in enumerate(header.force_kinds) if kind in BUSHINGS][:ELEMENTS]
    about = [name.startswith("rotational") for name in KINDS["force"]["bushing"].parameters]
    values = [header.parameters("force", k) for k in places]
    places = [k for k, it in zip(places, values, strict=True) if not len(it) or it[about].any()]
    return Elements([header.force_names[k] for k in places], header.force_bodies[places],
                    header.force_frame[places])  # fmt: skip


def _relative(result: Result, elements: Elements, every: int) -> tuple[Floats, Floats]:
    """Euler parameters (k, e, 4) of the second frame against the first, and its relative angular velocity in
    its own axes (k, e, 3) [rad/s]."""
    turn = of_bodies(result, "q", elements, every, lambda q: q[..., 3:], (1.0, 0.0, 0.0, 0.0))
    spin = of_bodies(result, "v", elements, every, lambda v: v[..., 3:], (0.0, 0.0, 0.0))
    own = rotation.from_matrix(elements.frame)
    p = _product(_inverse(_product(turn(0), own[:, 0])), _product(turn(1), own[:, 1]))
    omega = [np.einsum("eji,kej->kei", elements.frame[:, side], spin(side)) for side in (0, 1)]
    of_first = np.einsum("keji,kej->kei", rotation.matrix(p), omega[0])
    return p, omega[1] - of_first


def _goes_beyond(t: Floats, p: Floats, omega: Floats) -> Floats:
    """Whether the frames pass half a turn (k - 1, e) from each time to the next."""
    p = p * np.where(p[..., :1] < 0, -1.0, 1.0)
    step = _product(_inverse(p[:-1]), p[1:])  # in the axes of the second frame
    beyond = step[..., 0] < 0
    step = step * np.where(beyond, -1.0, 1.0)[..., None]
    half = np.linalg.norm(step[..., 1:], axis=-1)
    angle = 2 * np.arctan2(half, step[..., 0])
    mean = (omega[1:] + omega[:-1]) / 2 * np.diff(t)[:, None, None]
    by_speed = np.einsum("kei,kei->ke", mean, step[..., 1:])
    found: Floats = beyond & (angle > NO_TURN) & (by_speed > BY_SPEED * angle * half)
    return found


def _product(p: Floats, q: Floats) -> Floats:
    """Euler parameters (..., 4) of A(p) A(q)."""
    p_0, p_, q_0, q_ = p[..., :1], p[..., 1:], q[..., :1], q[..., 1:]
    scalar = p_0 * q_0 - np.sum(p_ * q_, axis=-1, keepdims=True)
    return np.concatenate([scalar, p_0 * q_ + q_0 * p_ + np.cross(p_, q_)], axis=-1)


def _inverse(p: Floats) -> Floats:
    return p * (1.0, -1.0, -1.0, -1.0)
