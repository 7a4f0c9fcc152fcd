"""Limits of joints of a compiled MuJoCo model: as stops, or noted."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import numpy as np

from linkwork.importers.description import JointDescription
from linkwork.importers.mjcf_dynamics import is_disabled
from linkwork.importers.robot_file import STOPPED

if TYPE_CHECKING:
    import mujoco

__all__ = ["has_limits", "set_limits", "tendon_limits"]

#: What limits have where the file says nothing about how soft they are.
SOFTNESS = {"solreflimit": (0.02, 1.0), "solimplimit": (0.9, 0.95, 0.001, 0.5, 2.0)}


def has_limits(model: mujoco.MjModel, joints: range) -> bool:
    """Whether any of these joints has ends that count."""
    return not is_disabled(model, "limit", "constraint") and any(model.jnt_limited[k] for k in joints)


def tendon_limits(model: mujoco.MjModel, tendon: int) -> str:
    """What is to be noted of the ends of a tendon; empty where it has none."""
    if is_disabled(model, "limit", "constraint") or not model.tendon_limited[tendon]:
        return ""
    lower, upper = model.tendon_range[tendon].tolist()
    return f"limits {lower:g} to {upper:g} of its length are not represented"


def set_limits(
    model: mujoco.MjModel,
    joints: Mapping[str, int],
    joint: JointDescription,
    stops: bool,
    note: Callable[[str, str, str], None],
) -> None:
    """Of the joint that does what those of a body (numbers, by name) do: its ends where it can have `stops`.

    note(topic, subject, message): of every limit that is not in the model as in the file.
    """
    if is_disabled(model, "limit", "constraint"):
        return
    for name, k in joints.items():
        if not model.jnt_limited[k]:
            continue
        (lower, upper), margin = model.jnt_range[k].tolist(), float(model.jnt_margin[k])
        first, last = lower + margin, upper - margin  # MuJoCo pushes back where less than the margin is left
        ends = f"limits {lower:g} to {upper:g}"
        if margin:
            ends += f", which margin {margin:g} makes {first:g} to {last:g},"
        if not stops or joint.kind not in STOPPED or first >= last:
            note("limits", f"joint '{name}'", f"{ends} are not represented")
            continue
        joint.stops = (first, last)
        if soft := _softness(model, k):
            text = f"{soft} of its limits is not taken: the stiffness of stops is another"
            note("limits", f"joint '{name}'", text)


def _softness(model: mujoco.MjModel, k: int) -> str:
    """Which attributes of a limit say how soft it is."""
    found = {"solreflimit": model.jnt_solref[k], "solimplimit": model.jnt_solimp[k]}
    return ", ".join(it for it, values in found.items() if not np.array_equal(values, SOFTNESS[it]))
