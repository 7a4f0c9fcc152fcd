"""URDF, the Unified Robot Description Format of ROS: links and joints in a tree. https://wiki.ros.org/urdf/XML"""

from __future__ import annotations

import os
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from linkwork.importers.building import Options, build
from linkwork.importers.description import (
    Description,
    Imported,
    JointDescription,
    LinkDescription,
    Motion,
    Note,
)
from linkwork.importers.frames import Frame, from_rpy
from linkwork.importers.xml_text import Node, Reader
from linkwork.rotation import perpendicular

__all__ = ["import_urdf"]

Floats = NDArray[np.float64]

X = np.array([1.0, 0.0, 0.0])


def import_urdf(path: str | os.PathLike[str], **options: Unpack[Options]) -> Imported:
    """The robot in a URDF file, at joint coordinates zero or at `coordinates`.

    Options are those of linkwork.importers.building.Options: floating, coordinates, velocities, gravity,
    keep_massless, repair_inertia, align_axes, merge_fixed. The base is the ground, unless floating=True. Each
    link is a body of the same name, its axes those of the link; massless links are parts of the links that
    they are fixed to.

    Not represented, and listed in the notes: limits, mimic, transmissions, geometry. ModelFileError: what is
    wrong in the file, with lines; moving links without inertia. ModelError: coordinates of joints that do not
    exist.
    """
    reader = Reader(path, "robot")
    robot = _Robot(reader)
    description = robot.description()
    reader.finish()
    return build(description, options, robot.lines)


class _Robot:
    def __init__(self, reader: Reader) -> None:
        self._reader = reader
        self.lines: dict[str, int] = {}
        self._notes: list[Note] = []

    def description(self) -> Description:
        root = self._reader.root
        links: dict[str, LinkDescription] = {}
        joints: dict[str, JointDescription] = {}
        for node in root.children:
            if node.tag == "link":
                self._once(links, node, self._link(node))
            elif node.tag == "joint":
                joint = self._joint(node)
                if joint is not None:
                    self._once(joints, node, joint)
            elif node.tag.startswith("xacro:"):
                self._reader.add(node, node.tag, "is a macro: expand the file by xacro first")
            elif node.tag not in ("material", "gazebo") or node.children:
                self._note("element", f"<{node.tag}>", f"in line {node.line} is not represented")
        self._check_tree(links, joints)
        name = root.attributes.get("name", "")
        return Description(
            self._reader.path, name, links, list(joints.values()), self._notes, base_is_fixed=True
        )

    def _note(self, topic: str, subject: str, message: str) -> None:
        self._notes.append(Note(topic, subject, message))

    def _once(self, known: dict[str, Any], node: Node, made: LinkDescription | JointDescription) -> None:
        if made.name in known:
            self._reader.add(node, f"{node.tag} '{made.name}'", "is given twice")
        known[made.name] = made
        self.lines.setdefault(f"{node.tag} {made.name}", node.line)

    def _name(self, node: Node) -> str:
        name = node.attributes.get("name", "")
        if not name:
            self._reader.add(node, node.tag, "name is missing")
        return name

    def _link(self, node: Node) -> LinkDescription:
        link = LinkDescription(self._name(node))
        who = f"link '{link.name}'"
        for shape in ("visual", "collision"):
            if node.one(shape) is not None:
                self._note(shape, who, f"its {shape} geometry is not represented")
        inertial = node.one("inertial")
        if inertial is None:
            return link
        frame = self._origin(inertial, who)
        mass = inertial.one("mass")
        link.mass = self._reader.number(
            inertial, mass.attributes.get("value") if mass else None, f"{who} mass"
        )
        link.center = frame.r
        tensor = inertial.one("inertia")
        if tensor is None:
            self._reader.add(inertial, f"{who} inertia", "is missing")
            return link
        values = {
            key: self._reader.number(
                tensor, tensor.attributes.get(key), f"{who} inertia {key}", default=default
            )
            for key, default in (
                ("ixx", None),
                ("iyy", None),
                ("izz", None),
                ("ixy", 0.0),
                ("ixz", 0.0),
                ("iyz", 0.0),
            )
        }
        link.inertia = frame.A @ inertia_matrix(values) @ frame.A.T
        return link

    def _origin(self, node: Node, who: str) -> Frame:
        origin = node.one("origin")
        if origin is None:
            return Frame()
        xyz = self._reader.numbers(origin, origin.attributes.get("xyz"), 3, f"{who} origin xyz", [0.0] * 3)
        if "quat_xyzw" in origin.attributes:
            self._reader.add(origin, f"{who} origin", "quat_xyzw is not taken; give rpy")
        return from_rpy(
            xyz, self._reader.numbers(origin, origin.attributes.get("rpy"), 3, f"{who} origin rpy", [0.0] * 3)
        )

    def _joint(self, node: Node) -> JointDescription | None:
        name, type_ = self._name(node), node.attributes.get("type", "")
        who = f"joint '{name}'"
        ends = []
        for end in ("parent", "child"):
            link = node.one(end)
            ends.append(link.attributes.get("link", "") if link is not None else "")
            if not ends[-1]:
                self._reader.add(node, who, f"{end} is missing")
        joint = JointDescription(name, "fixed", ends[0], ends[1], self._origin(node, who))
        if type_ in ("revolute", "continuous", "prismatic", "planar"):
            axis = self._axis(node, who)
            rotates = type_ in ("revolute", "continuous")
            joint.kind = "revolute" if rotates else "planar" if type_ == "planar" else "translational"
            joint.motions = (Motion(rotates, axis),) if type_ != "planar" else _planar(axis)
            self._dynamics(node, joint, who)
            self._limits(node, joint, who, type_)
            self._mimic(node, joint, who)
        elif type_ == "floating":
            joint.kind = "free"
        elif type_ == "spherical" or type_ == "ball":
            joint.kind = "spherical"
        elif type_ != "fixed":
            self._reader.add(node, who, f"type '{type_}' does not exist" if type_ else "type is missing")
            return None
        for tag in ("calibration", "safety_controller"):
            if node.one(tag) is not None:
                self._note(tag, who, f"its {tag} is not represented")
        return joint

    def _axis(self, node: Node, who: str) -> Floats:
        axis = node.one("axis")
        if axis is None:
            return X
        given = np.array(
            self._reader.numbers(axis, axis.attributes.get("xyz"), 3, f"{who} axis", [1.0, 0.0, 0.0])
        )
        length = np.linalg.norm(given)
        if length == 0:
            self._reader.add(axis, f"{who} axis", "has no direction")
            return X
        unit: Floats = given / length
        return unit

    def _dynamics(self, node: Node, joint: JointDescription, who: str) -> None:
        dynamics = node.one("dynamics")
        if dynamics is not None:
            for what in ("damping", "friction"):
                value = self._reader.number(
                    dynamics, dynamics.attributes.get(what), f"{who} dynamics {what}", 0.0
                )
                setattr(joint, what, value)

    def _limits(self, node: Node, joint: JointDescription, who: str, type_: str) -> None:
        limit = node.one("limit")
        if limit is None:
            return
        lower, upper = (self._reader.number(limit, limit.attributes.get(end), f"{who} limit {end}", 0.0)
                        for end in ("lower", "upper"))  # fmt: skip
        if type_ in ("revolute", "prismatic") and (lower or upper):
            self._note(
                "limits",
                who,
                f"limits {lower:g} to {upper:g} {'rad' if type_ == 'revolute' else 'm'} are not represented",
            )

    def _mimic(self, node: Node, joint: JointDescription, who: str) -> None:
        mimic = node.one("mimic")
        if mimic is not None:
            multiplier = self._reader.number(
                mimic, mimic.attributes.get("multiplier"), f"{who} mimic multiplier", 1.0
            )
            offset = self._reader.number(mimic, mimic.attributes.get("offset"), f"{who} mimic offset", 0.0)
            leader = mimic.attributes.get("joint", "")
            if not leader:
                self._reader.add(mimic, f"{who} mimic", "joint is missing")
            joint.mimic = leader, multiplier, offset

    def _check_tree(self, links: dict[str, LinkDescription], joints: dict[str, JointDescription]) -> None:
        """Every link has at most one parent, and the chain of parents ends."""
        if not links:
            self._reader.add(self._reader.root, "robot", "has no links")
        by_name = {node.attributes.get("name", ""): node for node in self._reader.root.all("joint")}
        parent_of: dict[str, str] = {}
        for name, joint in joints.items():
            node = by_name[name]
            for end, link in (("parent", joint.parent), ("child", joint.child)):
                if link and link not in links:
                    self._reader.add(node, f"joint '{name}' {end}", f"no link '{link}'")
            if joint.child in parent_of:
                self._reader.add(node, f"joint '{name}' child", f"link '{joint.child}' has two parents")
            parent_of.setdefault(joint.child, joint.parent)
            if joint.mimic is not None and joint.mimic[0] not in joints:
                self._reader.add(node, f"joint '{name}' mimic", f"no joint '{joint.mimic[0]}'")
        for name, joint in joints.items():
            seen, link = {joint.child}, joint.parent
            while link in parent_of and link not in seen:
                seen.add(link)
                link = parent_of[link]
            if link == joint.child:
                self._reader.add(
                    by_name[name], f"joint '{name}'", "is part of a ring of joints; a URDF is a tree"
                )


def _planar(normal: Floats) -> tuple[Motion, ...]:
    x = perpendicular(normal)
    return Motion(False, x), Motion(False, np.cross(normal, x)), Motion(True, normal)


def inertia_matrix(values: dict[str, float]) -> Floats:
    (xx, yy, zz), (xy, xz, yz) = (
        (values[key] for key in keys) for keys in (("ixx", "iyy", "izz"), ("ixy", "ixz", "iyz"))
    )
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
