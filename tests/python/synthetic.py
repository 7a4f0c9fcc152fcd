"""Results made of numbers instead of a simulation: their files and quantities are tested without a model."""

from __future__ import annotations

import h5py
import numpy as np
from linkwork.arrays import Floats
from linkwork.motion.header import Header


def header(
    bodies: int = 3, joints: int = 4, rows_per_joint: int = 5, expected_frames: int | None = None
) -> Header:
    """A chain of `joints` from ground through `bodies`, all numbers different."""
    chain = np.stack([np.arange(joints) - 1, np.arange(joints)], axis=1).astype(np.int32)
    rng = np.random.default_rng(0)
    return Header(
        manifest={
            "model": "synthetic",
            "options": {"formulation": "standard", "integrator": "rk4", "step": 1e-3},
        },
        body_names=[f"link {i} µ" for i in range(bodies)],
        joint_names=[f"pin {j}" for j in range(joints)],
        joint_kinds=["revolute"] * joints,
        gravity=np.array([0, 0, -9.81]),
        mass=rng.random(bodies),
        inertia=rng.random((bodies, 3, 3)),
        q0=rng.random(7 * bodies),
        v0=rng.random(6 * bodies),
        joint_rows=rows_per_joint * np.arange(joints + 1, dtype=np.int32),
        joint_bodies=np.where(chain < bodies, chain, -1),
        joint_frame=np.broadcast_to(np.eye(3), (joints, 2, 3, 3)),
        joint_origin=rng.random((joints, 2, 3)),
        reaction_unique=np.arange(joints) % 2 == 0,
        redundant_rows=np.arange(1, joints, dtype=np.int32),
        expected_frames=expected_frames,
        reactions=_reactions,
    )


def strip_digests(file: h5py.File) -> None:
    """Make the file of a run one of version 3, whose content may be changed."""
    file.attrs["version"] = 3
    for name in ("digest", "closing"):
        del file.attrs[name]
    del file["digests"]


def frames(header: Header, first: int, count: int) -> dict[str, Floats]:
    """Frames first .. first + count; the last number of every field is the frame's time."""
    t = 0.01 * np.arange(first, first + count)
    rng = np.random.default_rng(first)
    values = {name: rng.random((count, *shape)) for name, shape in header.frame_shapes().items()}
    del values["reaction_force"], values["reaction_torque"]
    for field in values.values():
        if field.size:
            field.reshape(count, -1)[:, -1] = t
    for name in ("q", "v", "vdot"):
        values[name] = values[name].reshape(count, -1)
    return values


def _reactions(t: Floats, q: Floats, multipliers: Floats) -> tuple[Floats, Floats]:
    force = multipliers.reshape(len(t), -1, 5)[:, :, :3] + t[:, None, None]
    return force, force - q[:, None, -1:]
