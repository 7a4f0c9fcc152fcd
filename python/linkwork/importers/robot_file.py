"""What the readers of URDF and SDF share: notes, the lines of links and joints, quantities that both have."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from linkwork.arrays import Floats, near_one
from linkwork.importers.building import Options, check_options
from linkwork.importers.description import Coupling, Description, JointDescription, LinkDescription, Note
from linkwork.importers.frames import Frame
from linkwork.importers.xml_text import Node, Reader

#: Coordinates beyond which a joint counts as free; kinds of joints that can have stops.
UNLIMITED, STOPPED = 1e15, ("revolute", "translational")

#: The text of a quantity by its name: of an attribute (URDF) or of a child (SDF).
Texts = Callable[[str], str | None]


class RobotFile:
    """Links and joints of a file on their way into a description."""

    def __init__(self, options: Options) -> None:
        check_options(options)
        self.stops = options.get("limits", "note") == "stops"
        self.notes: list[Note] = []
        self.lines: dict[str, int] = {}  #: of each link and joint, such as "link arm"
        self.links: dict[str, LinkDescription] = {}
        self.joints: dict[str, JointDescription] = {}
        self.couplings: list[Coupling] = []

    def note(self, topic: str, subject: str, message: str) -> None:
        self.notes.append(Note(topic, subject, message))

    def note_children(self, node: Node, who: str, tags: tuple[str, ...], what: str = "") -> None:
        """That children with these tags are not represented."""
        for tag in tags:
            if node.one(tag) is not None:
                self.note(tag, who, f"its {tag}{what} is not represented")

    def limit(
        self, joint: JointDescription, lower: float, upper: float, unit: str, others: list[str]
    ) -> None:
        """The ends of a joint as stops, or noted; `others`, such as "effort 3", are noted in any case."""
        found = list(others)
        ends = f"{lower:g} to {upper:g} {unit}".strip()
        if max(abs(lower), abs(upper)) < UNLIMITED and joint.kind in STOPPED and lower < upper:
            joint.stops = (lower, upper) if self.stops else None
        if min(abs(lower), abs(upper)) < UNLIMITED and joint.stops is None:
            found.insert(0, ends)
        if found:
            self.note("limits", f"joint '{joint.name}'", f"limits {', '.join(found)} are not represented")

    def check_couplings(self, reader: Reader) -> None:
        """Faults: joints that follow what is not there, or in the end themselves."""
        leader_of = {coupling.follower: coupling.leader for coupling in self.couplings}
        for coupling in self.couplings:
            line = self.lines.get(f"joint {coupling.follower}", 1)
            who = f"joint '{coupling.follower}' mimic"
            if coupling.leader not in self.joints:
                reader.add_line(line, who, f"no joint '{coupling.leader}'")
            elif coupling.leader_axis and coupling.leader_axis >= len(self.joints[coupling.leader].motions):
                reader.add_line(line, who, f"joint '{coupling.leader}' has no second axis")
        for ring in rings(leader_of):
            who, line = f"joint '{ring[0]}' mimic", self.lines.get(f"joint {ring[0]}", 1)
            reader.add_line(line, who, f"follows itself: {' -> '.join([*ring, ring[0]])}")

    def description(self, path: str, name: str, **others: Any) -> Description:
        """Of what was read. `others` as of Description."""
        joints = list(self.joints.values())
        return Description(path, name, self.links, joints, self.notes, couplings=self.couplings, **others)


def rings(next_of: Mapping[str, str]) -> list[list[str]]:
    """Closed rings of names of which each leads to the next. Every name is passed once."""
    passed: set[str] = set()
    found: list[list[str]] = []
    for start in next_of:
        way: dict[str, int] = {}
        name = start
        while name in next_of and name not in passed:
            passed.add(name)
            way[name] = len(way)
            name = next_of[name]
        if name in way:
            found.append(list(way)[way[name] :])
    return found


def set_inertia(link: LinkDescription, reader: Reader, frame: Frame, node: Node, texts: Texts,
                defaults: Mapping[str, float]) -> None:  # fmt: skip
    """The center of mass and the moments, which are about it and along the axes of `frame`."""
    entries = {
        key: reader.number(node, texts(key), f"link '{link.name}' inertia {key}", defaults.get(key))
        for key in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
    }
    (xx, yy, zz, xy, xz, yz) = entries.values()
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    with np.errstate(over="ignore", invalid="ignore"):  # a body refuses what is not finite
        link.center, link.inertia = frame.r, frame.A @ tensor @ frame.A.T


def direction(reader: Reader, node: Node, text: str | None, who: str, default: Floats) -> Floats:
    """Of unit length; a fault and the default where there is none."""
    given = near_one(np.array(reader.numbers(node, text, 3, who, default.tolist())))
    length = np.linalg.norm(given)
    if length == 0:
        reader.add(node, who, "has no direction")
        return default
    unit: Floats = given / length
    return unit


def coupling(reader: Reader, node: Node, follower: str, leader: str, texts: Texts) -> Coupling:
    """What a <mimic> says."""
    who = f"joint '{follower}' mimic"
    if not leader:
        reader.add(node, who, "joint is missing")
    multiplier, offset, reference = (
        reader.number(node, texts(what), f"{who} {what}", default)
        for what, default in (("multiplier", 1.0), ("offset", 0.0), ("reference", 0.0))
    )
    return Coupling(
        "mimic", f"{follower} mimic", follower, leader, multiplier, offset - multiplier * reference
    )
