"""`linkwork check`: what can be said of a mechanism before it is simulated."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork import _core
from linkwork.cli import output as out
from linkwork.errors import LinkworkError
from linkwork.running import checks

if TYPE_CHECKING:
    from linkwork import Model
    from linkwork.mechanisms import Mechanism

#: The most joints and bodies listed for people; JSON has all.
SHOWN = 12

#: The most dependent groups looked for: each costs a solution of the equations.
GROUPS = 25


def check_and_show(name: str, mechanism: Mechanism, parameters: Mapping[str, Any], as_json: bool) -> None:
    """Examine the mechanism at its initial pose."""
    found = {"mechanism": name, "parameters": dict(parameters), **examine(mechanism.function(**parameters))}
    if as_json:
        out.print_json(found)
    else:
        _print(found)


def examine(model: Model) -> dict[str, Any]:
    """Counts, rank, redundancy of the constraints, residuals of joints, inertias of bodies; SI units."""
    core = model.compiled()
    options = _core.Options()
    options.formulation = "augmented_lagrangian"  # takes redundant joints and massless bodies, too
    dynamics = _core.Dynamics(core, options)
    rank = dynamics.rank()
    joint_of = np.searchsorted(core.joint_rows, np.arange(rank.rows), side="right") - 1
    redundant = sorted({int(joint_of[row]) for row in rank.redundant_rows})
    groups = dynamics.dependent_groups(GROUPS)
    return {
        "bodies": core.body_count,
        "joints": core.joint_count,
        "rows": rank.rows,
        "rank": rank.rank,
        "degrees_of_freedom": rank.degrees_of_freedom,
        "redundant": len(rank.redundant_rows),
        "near_dependence": checks.near_dependence(dynamics),
        "redundant_joints": [core.joint_name(joint) for joint in redundant],
        "redundant_equations": [core.describe_row(row) for row in rank.redundant_rows],
        "dependent_groups": [
            {
                "equation": core.describe_row(row),
                "joint": core.joint_name(int(joint_of[row])),
                "repeats": [core.describe_row(other) for other in others],
                "joints": [core.joint_name(int(joint)) for joint in np.unique(joint_of[others])],
                "text": text,
            }
            for row, others, text in groups
        ],
        "singular_equations": [core.describe_row(row) for row in rank.singular_rows],
        "contradictions": _contradictions(model, dynamics),
        "residuals": _residuals(model, dynamics),
        "inertias": _inertias(core),
    }


def _contradictions(model: Model, dynamics: _core.Dynamics) -> dict[str, float]:
    """Redundant equations that ask for other accelerations [1/s2]; none where these cannot be found."""
    try:
        return checks.contradictions_at_start(model, dynamics)
    except LinkworkError:
        return {}


def _residuals(model: Model, dynamics: _core.Dynamics) -> list[dict[str, Any]]:
    """By how much each joint's equations are violated by the initial pose and velocities."""
    position, velocity = checks.joint_residuals(model, dynamics)
    core = model.compiled()
    unique = dynamics.rank().unique
    return [
        {
            "joint": core.joint_name(joint),
            "kind": core.joint_kind(joint),
            "reaction_unique": unique[joint],
            "position": float(position[joint]),
            "velocity": float(velocity[joint]),
        }
        for joint in range(core.joint_count)
    ]


def _inertias(core: _core.Model) -> list[dict[str, Any]]:
    """Mass and principal moments; `margin` is (J1 + J2 - J3) / J3, which no real body has below zero."""
    moments = np.linalg.eigvalsh(core.inertia)
    largest = moments[:, 2]
    margin = np.where(
        largest > 0, (moments[:, 0] + moments[:, 1] - largest) / np.where(largest > 0, largest, 1), 0.0
    )
    return [
        {
            "body": core.body_name(body),
            "mass": float(core_mass),
            "principal_moments": moments[body].tolist(),
            "margin": float(margin[body]),
            "remark": _remark(core_mass, largest[body], margin[body]),
        }
        for body, core_mass in enumerate(core.mass)
    ]


def _remark(mass: float, largest: float, margin: float) -> str:
    if mass == 0 and largest == 0:
        return "massless"
    if mass == 0 or largest == 0:
        return "no mass" if mass == 0 else "a point: no inertia"
    return "a rod: no thickness" if margin < 1e-9 else ""


def _print(found: dict[str, Any]) -> None:
    redundant, singular = found["redundant_joints"], found["singular_equations"]
    out.print_pairs([
        ("mechanism", found["mechanism"]),
        ("bodies", str(found["bodies"])),
        ("joints", str(found["joints"])),
        ("constraints", f"{found['rows']} equations of rank {found['rank']}"),
        ("degrees of freedom", str(found["degrees_of_freedom"])),
        ("redundant", _listed([group["text"] for group in found["dependent_groups"]], found["redundant"])),
        *([("singular", _listed(singular, len(singular)))] if singular else []),
    ])  # fmt: skip
    if singular:
        print(
            "\nIn this pose the singular equations depend on the others, too: the mechanism may go on in"
            "\nseveral ways. The standard method cannot start here; --formulation augmented_lagrangian can."
        )
    if found["near_dependence"]:
        print(f"\n{found['near_dependence']}.")
    for equation, size in found["contradictions"].items():
        print(
            f"\n{equation}, contradicts the equations that it repeats: its acceleration is off by {size:.3g}"
        )
    if redundant:
        print("\nRedundant equations are left out. A reaction that is not unique is the share of least norm.")
    _print_residuals(found["residuals"])
    _print_inertias(found["inertias"])


def _print_residuals(residuals: list[dict[str, Any]]) -> None:
    worst = sorted(residuals, key=lambda joint: -max(joint["position"], joint["velocity"]))[:SHOWN]
    if worst:
        out.print_table(
            ("joint", "kind", "position", "velocity", "reaction"),
            [
                (
                    j["joint"],
                    j["kind"],
                    f"{j['position']:.1e}",
                    f"{j['velocity']:.1e}",
                    "unique" if j["reaction_unique"] else "not unique",
                )
                for j in worst
            ],
            title=_share("Initial residuals", len(worst), len(residuals), "joints"),
            left=2,
        )


def _print_inertias(inertias: list[dict[str, Any]]) -> None:
    bodies = sorted(inertias, key=lambda body: not body["remark"])[:SHOWN]
    out.print_table(
        ("body", "mass [kg]", "principal moments [kg m2]", ""),
        [
            (b["body"], f"{b['mass']:g}", "  ".join(f"{m:.4g}" for m in b["principal_moments"]), b["remark"])
            for b in bodies
        ],
        title=_share("Inertias", len(bodies), len(inertias), "bodies"),
    )


def _share(title: str, shown: int, total: int, what: str) -> str:
    return title if shown == total else f"{title} ({shown} of {total} {what})"


def _listed(items: list[str], count: int) -> str:
    """The first of `count` items."""
    if not count:
        return "none"
    rest = count - min(SHOWN, len(items))
    return "\n".join([*items[:SHOWN], *([f"and {rest} more"] if rest > 0 else [])])
