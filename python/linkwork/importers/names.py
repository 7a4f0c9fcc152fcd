"""Names of links and joints as a model can have them, where those of a file are others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace

from linkwork.importers.description import Description

__all__ = ["Renamed", "free", "rename", "spaced"]


def spaced(text: str) -> str:
    """With spaces instead of line breaks, tabs, and other blanks that cannot be printed."""
    return "".join(" " if c.isspace() else c for c in text)


def free(wanted: str, is_taken: Callable[[str], bool]) -> str:
    """The name that is wanted, or with a number behind it."""
    name, number = wanted, 1
    while is_taken(name):
        number += 1
        name = f"{wanted} {number}"
    return name


@dataclass(frozen=True)
class Renamed:
    """Names of a description by those of the file, where they are others."""

    links: Mapping[str, str] = field(default_factory=dict)
    joints: Mapping[str, str] = field(default_factory=dict)

    def lines(self, lines: Mapping[str, int]) -> dict[str, int]:
        """Of each link and joint, such as "link arm"."""
        by_kind = {"link": self.links, "joint": self.joints}
        split = ((*key.partition(" ")[::2], line) for key, line in lines.items())
        return {f"{kind} {by_kind[kind].get(name, name)}": line for kind, name, line in split}


def rename(description: Description) -> Renamed:
    """Give links and joints names without line breaks and tabs, and note those that were others."""
    joints = [joint.name for joint in description.joints]
    names = Renamed(_changed(description, "link", description.links), _changed(description, "joint", joints))
    if not names.links and not names.joints:
        return names
    links, of_joint = names.links, names.joints
    for link in description.links.values():
        link.name = links.get(link.name, link.name)
    description.links = {link.name: link for link in description.links.values()}
    description.grounded = {links.get(name, name) for name in description.grounded}
    for joint in description.joints:
        joint.name = of_joint.get(joint.name, joint.name)
        joint.parent, joint.child = (links.get(end, end) for end in (joint.parent, joint.child))
    description.couplings = [
        replace(
            coupling,
            name=spaced(coupling.name),
            follower=of_joint.get(coupling.follower, coupling.follower),
            leader=of_joint.get(coupling.leader, coupling.leader),
        )
        for coupling in description.couplings
    ]
    return names


def _changed(description: Description, kind: str, names: Iterable[str]) -> dict[str, str]:
    """New names by the former ones."""
    taken, found = set(names), dict[str, str]()
    for name in sorted(it for it in taken if spaced(it) != it):
        found[name] = free(spaced(name), taken.__contains__)
        taken.add(found[name])
        text = f"its name {name!r:.80} is {found[name]!r:.80} here: to be printed"
        description.note("name", f"{kind} '{found[name]}'", text)
    return found
