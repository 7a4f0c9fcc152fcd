"""`linkwork linearize`, `equilibrium` and `kinematics`: analyses of a mechanism, shown."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

import linkwork as lw
from linkwork.arrays import Floats
from linkwork.cli import output as out

if TYPE_CHECKING:
    from linkwork.mechanisms import Mechanism

#: Frames of a prescribed motion; times are the same within this, relative.
MOST_FRAMES, SAME_TIME = 1_000_000, 1e-9

#: The most modes, bodies and joints listed for people; JSON has all.
SHOWN = 20


def linearize_and_show(
    name: str, mechanism: Mechanism, parameters: Mapping[str, Any], *, modes: int | None, near: float,
    as_is: bool, as_json: bool,
) -> None:  # fmt: skip
    """Small vibrations about the equilibrium, or about the initial state."""
    model = mechanism.function(**parameters)
    rest = None if as_is else lw.equilibrium(model)
    found = lw.linearize(model if rest is None else rest.model, modes=modes, near=near)
    listed = [
        {"eigenvalue": [s.real, s.imag], "frequency": f, "hertz": f / (2 * np.pi), "damping_ratio": zeta,
         "motion": found.describe(k)}
        for k, (s, f, zeta) in enumerate(
            zip(found.eigenvalues, found.frequencies, found.damping_ratios, strict=True)
        )
    ]  # fmt: skip
    if as_json:
        about = "initial state" if rest is None else "equilibrium"
        out.print_json({"mechanism": name, "parameters": dict(parameters), "about": about,
                        "stable": found.stable, "modes": listed})  # fmt: skip
        return
    out.print_pairs([("mechanism", name), ("about", str(rest) if rest else "its initial state"),
                     ("motions", "stable" if found.stable else "unstable: one of them grows")])  # fmt: skip
    out.print_table(
        ("largest motion", "frequency [rad/s]", "[Hz]", "damping ratio", "growth [1/s]"),
        [
            (it["motion"], f"{it['frequency']:.7g}", f"{it['hertz']:.5g}", f"{it['damping_ratio']:.4g}",
             f"{it['eigenvalue'][0]:.4g}")
            for it in listed[:SHOWN]
        ],
        title="Modes" if len(listed) <= SHOWN else f"Modes ({SHOWN} of {len(listed)})",
    )  # fmt: skip


def equilibrium_and_show(
    name: str, mechanism: Mechanism, parameters: Mapping[str, Any], *, nearest: bool, as_json: bool
) -> None:
    """Where the mechanism rests, and the reactions there."""
    rest = lw.equilibrium(mechanism.function(**parameters), stable=not nearest)
    core = rest.model.compiled()
    poses = np.array(core.q0).reshape(-1, 7)
    joints = [core.joint_name(k) for k in range(core.joint_count)]
    force, torque = rest.reactions()
    if as_json:
        out.print_json({
            "mechanism": name, "parameters": dict(parameters), "stability": rest.stability,
            "softest": rest.softest, "softest_motion": rest.softest_motion, "imbalance": rest.imbalance,
            "bodies": [
                {"body": core.body_name(k), "position": pose[:3], "orientation": pose[3:]}
                for k, pose in enumerate(poses)
            ],
            "reactions": [
                {"joint": joint, "force": force[k], "torque": torque[k]} for k, joint in enumerate(joints)
            ],
        })  # fmt: skip
        return
    out.print_pairs([("mechanism", name), ("found", str(rest))])
    most = np.argsort(-rest.moved, kind="stable")[:SHOWN]
    out.print_table(
        ("body", "position [m]", "moved [m]", "turned [rad]"),
        [
            (core.body_name(int(k)), _vector(poses[k, :3]), f"{rest.moved[k]:.5g}", f"{rest.turned[k]:.5g}")
            for k in most
        ],
        title="Bodies" if len(poses) <= SHOWN else f"Bodies ({SHOWN} of {len(poses)})",
    )
    size = np.linalg.norm(force, axis=1)
    out.print_table(
        ("joint", "force [N]", "torque [N m]"),
        [
            (joints[k], _vector(force[k]), _vector(torque[k]))
            for k in np.argsort(-size, kind="stable")[:SHOWN]
        ],
        title="Reactions" if len(joints) <= SHOWN else f"Reactions ({SHOWN} of {len(joints)})",
    )


def kinematics_and_show(
    name: str, mechanism: Mechanism, parameters: Mapping[str, Any], *, drive: Sequence[tuple[str, float]],
    t_end: float, step: float, output: str | None, plot: str | None, as_json: bool,
) -> None:  # fmt: skip
    """The motion that the drivers prescribe, and what they must exert; `drive`: joints with their speeds."""
    for what, path in (("result", output), ("picture", plot)):
        if path is not None:
            out.check_writable(path, what)
    times = _times(t_end, step)
    model = mechanism.function(**parameters)
    for joint, speed in drive:
        model.drive(joint, velocity=speed, name=f"drive of {joint}")
    needed = _prescribed(model, times)
    motion = needed.motion
    if output:
        motion.save(output, overwrite=True)
    if plot:
        motion.plot(plot)
    drives = [
        {"driver": drive.joint, "kind": drive.kind, "unique": drive.unique, "effort_unit": drive.unit,
         "largest_effort": np.abs(drive.effort).max(), "largest_power": np.abs(drive.power).max()}
        for drive in needed.drives.values()
    ]  # fmt: skip
    if as_json:
        poses = [{"t": it.t, "joints": it.joints, "pivot": it.pivot} for it in motion.singular_poses]
        out.print_json({"mechanism": name, "parameters": dict(parameters), "frames": len(motion),
                        "violation": motion.violation.max(axis=0), "drives": drives,
                        "singular_poses": poses, "output": output, "plot": plot})  # fmt: skip
        return
    print(motion.summary())
    out.print_table(
        ("driver", "kind", "largest effort", "largest power [W]", ""),
        [
            (it["driver"], it["kind"], f"{it['largest_effort']:.6g} {it['effort_unit']}",
             f"{it['largest_power']:.6g}", "" if it["unique"] else "a share of least norm")
            for it in drives
        ],
        title="Drives",
        left=2,
    )  # fmt: skip


def _times(t_end: float, step: float) -> Floats:
    """From 0 to `t_end`, equally far apart, at most a step. OptionError: less than a step, or too many."""
    steps = t_end / step * (1 - SAME_TIME)
    if step * (1 - SAME_TIME) > t_end:
        raise lw.OptionError(
            f"step {step:g} s is longer than the run, from 0 to {t_end:g} s: give a step of {t_end:g} s or "
            "less",
            code="step",
        )
    if steps > MOST_FRAMES:
        raise lw.OptionError(
            f"step {step:g} s: up to {t_end:g} s these are more than {MOST_FRAMES} frames: give a longer one",
            code="step",
        )
    count = math.ceil(steps)
    if abs(count * step - t_end) > SAME_TIME * t_end:
        out.note(f"frames are {t_end / count:g} s apart: steps of {step:g} s would not end at {t_end:g} s")
    return np.linspace(0, t_end, count + 1)


def _prescribed(model: lw.Model, times: Floats) -> lw.InverseDynamics:
    """ModelError: nothing drives the mechanism, in the words of the command."""
    try:
        return lw.inverse_dynamics(model, times)
    except lw.ModelError as error:
        if error.code != "no_drivers":
            raise
        message = (
            f"kinematics: '{model.name}' has no drivers: give --drive JOINT=SPEED, or a file that has some"
        )
        raise lw.ModelError(message, code=error.code) from None


def _vector(x: Any) -> str:
    return "  ".join(f"{round(c, 9) + 0.0:.5g}" for c in np.asarray(x))
