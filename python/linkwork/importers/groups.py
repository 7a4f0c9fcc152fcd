"""Links that are rigid with each other, and whether a body can be made of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import Fault
from linkwork.importers.description import WORLD, Description, JointDescription, LinkDescription
from linkwork.importers.tree import LinkState, grounded_links

__all__ = ["Group", "check_light", "grouped", "moments_of", "real_inertia"]

#: Second moments of mass, relative to the largest principal moment, that are negative by rounding.
NEGATIVE = 1e-9


@dataclass
class Group:
    """Links that are rigid with each other; its frame is that of its main link."""

    links: list[str]
    main: str
    mass: float
    center: Floats  #: in the main link's frame
    inertia: Floats  #: about the center, main link's axes

    @property
    def is_light(self) -> bool:
        """It cannot move by itself: no mass, or no inertia."""
        return self.mass == 0 or not self.inertia.any()


# Long: what merges two groups closes over the same three tables.
def grouped(description: Description, states: Mapping[str, LinkState], merge_fixed: bool) -> dict[str, Group]:
    """The group of every link and of the world."""
    groups = {name: _group(link) for name, link in description.links.items()}
    groups[WORLD] = Group([WORLD], WORLD, np.inf, np.zeros(3), np.eye(3))
    leader = {name: name for name in groups}  # toward the link that has the group in `groups`

    def find(name: str) -> str:
        while leader[name] != name:
            leader[name] = name = leader[leader[name]]
        return name

    def merge(one: str, other: str) -> None:
        one, other = find(one), find(other)
        if one != other:
            groups[one] = _merged(groups[one], groups.pop(other), states)
            leader[other] = one

    for name in grounded_links(description):
        merge(WORLD, name)
        description.note("base", f"link '{name}'", "the base is the ground")
    fixed = [joint for joint in description.joints if joint.kind == "fixed" and not joint.closes_loop]
    at_link: dict[str, list[JointDescription]] = {name: [] for name in leader}

    def fasten(joint: JointDescription) -> None:
        """Make one body of what the joint fixes, where one is the world or cannot move by itself."""
        pair = groups[find(joint.parent)], groups[find(joint.child)]
        world = groups[find(WORLD)]
        ends = [group for group in pair if group is world or group.is_light]
        if pair[0] is not pair[1] and (ends or merge_fixed):
            _note_merger(description, pair, world, joint)
            merge(joint.parent, joint.child)

    for joint in fixed:
        fasten(joint)
        for link in (joint.parent, joint.child):
            at_link[link].append(joint)
    # No group becomes light by merging: what is not one by now becomes so only where it reaches the world.
    reached = groups[find(WORLD)].links
    for link in reached:  # which grows meanwhile
        for joint in at_link[link]:
            fasten(joint)
    return {name: groups[find(name)] for name in leader}


def _note_merger(
    description: Description, pair: tuple[Group, Group], world: Group, joint: JointDescription
) -> None:
    parent, child = pair
    if world in pair:
        other = child if parent is world else parent
        if other.mass:
            description.note(
                "merged", f"link '{other.main}'", f"is fixed to the ground by joint '{joint.name}'"
            )
        return
    light, heavy = (parent, child) if parent.is_light and not child.is_light else (child, parent)
    what = "massless link" if light.mass == 0 else "link"
    description.note(
        "merged", f"{what} '{light.main}'", f"is a part of '{heavy.main}', by joint '{joint.name}'"
    )


def _group(link: LinkDescription) -> Group:
    return Group([link.name], link.name, link.mass, link.center, link.inertia)


# Steiner: about the common center, J = sum J_k + m_k (d_k.d_k I - d_k d_k^T),  d_k = c_k - c
def _merged(first: Group, second: Group, states: Mapping[str, LinkState]) -> Group:
    """Both in the frame of the heavier one's main link; the world stays the world."""
    if second.mass and not first.mass or second.main == WORLD:
        first, second = second, first
    links = first.links  # at its end, or merging many to one would take the square of their number
    links.extend(second.links)
    if first.main == WORLD:
        return Group(links, first.main, first.mass, first.center, first.inertia)
    step = states[first.main].frame.inverse @ states[second.main].frame
    mass = first.mass + second.mass
    parts = ((first.mass, first.center, first.inertia),
             (second.mass, step.point(second.center), step.A @ second.inertia @ step.A.T))  # fmt: skip
    center = sum(m * c for m, c, _ in parts) / mass if mass else first.center
    inertia = sum(J + m * ((c - center) @ (c - center) * np.eye(3) - np.outer(c - center, c - center))
                  for m, c, J in parts)  # fmt: skip
    return Group(links, first.main, mass, np.asarray(center), np.asarray(inertia))


def check_light(
    description: Description,
    groups: Mapping[str, Group],
    keep: bool,
    lines: Mapping[str, int],
    faults: list[Fault],
) -> None:
    for name in description.links:
        group = groups[name]
        of_file = not description.links[name].between_joints
        if not of_file or group.main != name or group is groups[WORLD] or not group.is_light:
            continue
        lack = "mass" if group.mass == 0 else "moment of inertia"
        if keep:
            description.note("massless", f"link '{name}'", f"moves without {lack}: a massless body")
            continue
        reason = (
            f"moves but has no {lack}: give its inertial, or import with keep_massless (then joints must "
            "hold it)"
        )
        faults.append(Fault(lines.get(f"link {name}", 1), f"link '{name}'", reason))


# The principal moments J_k of a body follow from its second moments of mass s_k = sum m x_k^2 >= 0 along the
# principal axes: J_1 = s_2 + s_3, ..., so s_k = (J_1 + J_2 + J_3) / 2 - J_k. Where one is negative, it is
# made zero.
def real_inertia(J: Floats) -> tuple[Floats, str | None]:
    """An inertia that a body can have, and the moments (text) of the one given where it had to be another.

    One beyond all numbers stays: a body refuses it.
    """
    size = np.abs(J).max()
    if not np.isfinite(size) or size == 0:
        return J, None
    moments, axes = np.linalg.eigh(J / size)
    spread = moments.sum() / 2 - moments
    if (spread >= -NEGATIVE * np.abs(moments).max()).all():
        return J, None
    spread = np.maximum(spread, 0.0)
    return size * (axes @ np.diag(spread.sum() - spread) @ axes.T), moments_of(J)


def moments_of(J: Floats) -> str:
    size = np.abs(J).max() or 1.0
    return "(" + ", ".join(f"{size * moment:.6g}" for moment in np.linalg.eigvalsh(J / size)) + ")"
