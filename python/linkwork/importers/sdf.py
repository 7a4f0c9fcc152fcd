"""SDF, the Simulation Description Format of Gazebo: links anywhere, joints in trees and loops. http://sdformat.org"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from linkwork.importers.building import Options, build
from linkwork.importers.description import (
    WORLD,
    Description,
    Imported,
    JointDescription,
    LinkDescription,
    Motion,
    Note,
)
from linkwork.importers.frames import Frame, from_quaternion, from_rpy
from linkwork.importers.urdf import inertia_matrix
from linkwork.importers.xml_text import Node, Reader

__all__ = ["import_sdf"]

Floats = NDArray[np.float64]

#: How joints are called here.
KINDS = {
    "fixed": "fixed",
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "translational",
    "ball": "spherical",
    "universal": "universal",
    "screw": "screw",
}


def import_sdf(path: str | os.PathLike[str], **options: Unpack[Options]) -> Imported:
    """The model in an SDF file, with its closed loops, at the poses of its links or at `coordinates`.

    Options are those of linkwork.importers.building.Options: floating, coordinates, velocities, gravity,
    keep_massless, repair_inertia, align_axes, merge_fixed. Links that nothing joins to the world move freely,
    unless the model is static or floating=False. Joints stand where the poses of the links put them; those
    that close loops have no coordinates of their own.

    Not represented, and listed in the notes: limits, gearbox joints, plugins, geometry. ModelFileError: what
    is wrong in the file, with lines; moving links without inertia. ModelError: wrong coordinates.
    """
    reader = Reader(path, "sdf")
    model = _SdfModel(reader)
    description = model.description()
    reader.finish()
    return build(description, options, model.lines)


class _SdfModel:
    def __init__(self, reader: Reader) -> None:
        self._reader = reader
        self._notes: list[Note] = []
        self.lines: dict[str, int] = {}
        self._version = _version(reader.root)
        world = reader.root.one(WORLD)
        models = [*reader.root.all("model"), *(world.all("model") if world else ())]
        if len(models) != 1:
            reader.add(reader.root, "sdf", f"has {len(models)} models; one is taken")
            reader.finish()
        self._node = models[0]
        gravity = world.one("gravity") if world else None
        standard = [0.0, 0.0, -9.8]
        self._gravity = reader.numbers(
            gravity or reader.root, gravity.text if gravity else None, 3, "gravity", standard
        )
        for child in world.children if world else ():
            if child.tag not in ("model", "gravity"):
                self._note("element", f"<{child.tag}>", f"in line {child.line} is not represented")

    def description(self) -> Description:
        nodes = {tag: self._named(tag) for tag in ("link", "joint", "frame")}
        for child in self._node.children:
            if child.tag in ("model", "include"):
                self._reader.add(child, child.tag, "nested models are not taken: write the model out as one")
            elif child.tag not in ("link", "joint", "frame", "pose", "static"):
                self._note("element", f"<{child.tag}>", f"in line {child.line} is not represented")
        frames = _Frames(self._reader, self._node, nodes)
        links = {name: self._link(name, node, frames) for name, node in nodes["link"].items()}
        if not links:
            self._reader.add(self._node, "model", "has no links")
        joints = [
            joint for name, node in nodes["joint"].items() if (joint := self._joint(name, node, frames))
        ]
        static = self._node.word("static") in ("1", "true")
        name = self._node.attributes.get("name", "")
        gravity = np.array(self._gravity)
        return Description(self._reader.path, name, links, joints, self._notes, gravity, base_is_fixed=static)

    def _note(self, topic: str, subject: str, message: str) -> None:
        self._notes.append(Note(topic, subject, message))

    def _named(self, tag: str) -> dict[str, Node]:
        found: dict[str, Node] = {}
        for node in self._node.all(tag):
            name = node.attributes.get("name", "")
            if not name or name in found or name == WORLD:
                reason = "is given twice" if name in found else "is the name of the ground"
                self._reader.add(node, f"{tag} '{name}'", reason if name else "name is missing")
            found[name] = node
            self.lines[f"{tag} {name}"] = node.line
        return found

    def _link(self, name: str, node: Node, frames: _Frames) -> LinkDescription:
        who, reader = f"link '{name}'", self._reader
        link = LinkDescription(name, pose=frames.pose(name))
        for shape in ("visual", "collision"):
            if node.one(shape) is not None:
                self._note(shape, who, f"its {shape} geometry is not represented")
        inertial = node.one("inertial")
        if inertial is None:  # the defaults of the format
            link.mass, link.inertia = 1.0, np.eye(3)
            self._note("inertial", who, "is missing: 1 kg and 1 kg m2, the defaults of SDF")
            return link
        pose = frames.own(inertial, who)
        link.mass = reader.number(inertial, inertial.word("mass"), f"{who} mass", 1.0)
        link.center = pose.r
        inertia = inertial.one("inertia")
        entries = {"ixx": 1.0, "iyy": 1.0, "izz": 1.0, "ixy": 0.0, "ixz": 0.0, "iyz": 0.0}
        if inertia is not None:
            for key, default in entries.items():
                entries[key] = reader.number(inertia, inertia.word(key), f"{who} inertia {key}", default)
        link.inertia = pose.A @ inertia_matrix(entries) @ pose.A.T
        if inertial.one("fluid_added_mass") is not None:
            self._note("fluid_added_mass", who, "its added mass is not represented")
        return link

    def _joint(self, name: str, node: Node, frames: _Frames) -> JointDescription | None:
        who, reader, type_ = f"joint '{name}'", self._reader, node.attributes.get("type", "")
        parent, child = (node.word(end) or "" for end in ("parent", "child"))
        for end, link in (("parent", parent), ("child", child)):
            if not link:
                reader.add(node, who, f"{end} is missing")
            elif not frames.is_link(link) and not (link == WORLD and end == "parent"):
                reader.add(node, f"{who} {end}", f"no link '{link}'")
        if reader.faults:
            return None
        if type_ == "gearbox":
            ratio = node.word("gearbox_ratio") or "1"
            self._note(
                "gearbox",
                who,
                f"gearbox of '{parent}' and '{child}' with ratio {ratio} is not represented",
            )
            return None
        if type_ == "revolute2":
            type_ = "universal"
        if type_ not in KINDS:
            reader.add(
                node,
                who,
                f"type '{type_}' is not taken; there are {', '.join(KINDS)}" if type_ else "type is missing",
            )
            return None
        here = frames.pose(name)
        parent_pose = Frame() if parent == WORLD else frames.pose(parent)
        joint = JointDescription(
            name, KINDS[type_], parent, child, parent_pose.inverse @ here, frames.pose(child).inverse @ here
        )
        count = {"universal": 2, "fixed": 0, "spherical": 0}.get(joint.kind, 1)
        axes = [self._axis(node, tag, who, here, frames) for tag in ("axis", "axis2")[:count]]
        if joint.kind == "universal" and abs(axes[0] @ axes[1]) > 1e-6:
            reader.add(node, f"{who} axis2", "is not perpendicular to axis")
        joint.motions = tuple(Motion(joint.kind != "translational", axis) for axis in axes)
        if joint.kind == "screw":
            self._screw(node, joint, who)
        if count == 1:
            self._dynamics(node, joint, who)
        elif count:
            self._note_dynamics(node, who)
        for tag in ("physics", "sensor"):
            if node.one(tag) is not None:
                self._note(tag, who, f"its {tag} is not represented")
        return joint

    def _screw(self, node: Node, joint: JointDescription, who: str) -> None:
        """SDF's thread_pitch is [rad/m] with the other sign; screw_thread_pitch is [m] per turn."""
        per_turn, per_meter = node.word("screw_thread_pitch"), node.word("thread_pitch")
        if per_turn is not None or per_meter is None:
            joint.pitch = self._reader.number(node, per_turn, f"{who} screw_thread_pitch")
        else:
            rate = self._reader.number(node, per_meter, f"{who} thread_pitch")
            joint.pitch = -2 * np.pi / rate if rate else 0.0
        if joint.pitch == 0:
            self._reader.add(node, f"{who} screw_thread_pitch", "must not be zero")

    def _axis(self, node: Node, tag: str, who: str, here: Frame, frames: _Frames) -> Floats:
        """A direction of unit length in the joint's frame."""
        axis = node.one(tag)
        given = np.array([0.0, 0.0, 1.0])
        if axis is None:
            self._reader.add(node, f"{who} {tag}", "is missing")
            return given
        xyz = axis.one("xyz")
        if xyz is not None:
            given = np.array(self._reader.numbers(xyz, xyz.text, 3, f"{who} {tag}"))
        if not np.linalg.norm(given):
            self._reader.add(axis, f"{who} {tag}", "has no direction")
            return np.array([0.0, 0.0, 1.0])
        expressed_in = xyz.attributes.get("expressed_in") if xyz is not None else None
        in_model = axis.word("use_parent_model_frame") in ("1", "true") or self._version < (1, 5)
        if expressed_in:
            given = here.A.T @ (frames.pose(expressed_in).A @ given)
        elif in_model and self._version < (1, 7):
            given = here.A.T @ (frames.model.A @ given)
        unit: Floats = given / np.linalg.norm(given)
        return unit

    def _dynamics(self, node: Node, joint: JointDescription, who: str) -> None:
        axis = node.one("axis")
        dynamics, limit = (axis.one(tag) if axis else None for tag in ("dynamics", "limit"))
        for tag in ("damping", "friction", "spring_stiffness", "spring_reference"):
            field = "stiffness" if tag == "spring_stiffness" else tag
            if dynamics is not None:
                value = self._reader.number(dynamics, dynamics.word(tag), f"{who} {tag}", 0.0)
                setattr(joint, field, value)
        ends = [self._reader.number(limit, limit.word(end), f"{who} {end}", sign * 1e16)
                for end, sign in (("lower", -1), ("upper", 1))] if limit else []  # fmt: skip
        if any(abs(end) < 1e15 for end in ends):
            self._note("limits", who, f"limits {ends[0]:g} to {ends[1]:g} are not represented")
        mimic = axis.one("mimic") if axis else None
        if mimic is not None:
            multiplier = self._reader.number(mimic, mimic.word("multiplier"), f"{who} multiplier", 1.0)
            offset = self._reader.number(mimic, mimic.word("offset"), f"{who} offset", 0.0)
            joint.mimic = mimic.attributes.get("joint", ""), multiplier, offset

    def _note_dynamics(self, node: Node, who: str) -> None:
        for tag in ("axis", "axis2"):
            for what in ("dynamics", "limit", "mimic"):
                if node.find(tag, what) is not None:
                    self._note(what, who, f"the {what} of its {tag} is not represented")


class _Frames:
    """Poses of links, joints and frames in the world, through the frames that they are relative to."""

    def __init__(self, reader: Reader, model: Node, nodes: Mapping[str, Mapping[str, Node]]) -> None:
        self._reader = reader
        self._kinds = {name: kind for kind, named in nodes.items() for name in named}
        self._nodes = {name: node for named in nodes.values() for name, node in named.items()}
        self._known: dict[str, Frame] = {}
        self._open: list[str] = []
        self.model = self.own(model, "model")

    def is_link(self, name: str) -> bool:
        return self._kinds.get(name) == "link"

    def pose(self, name: str) -> Frame:
        """Of a link, joint or frame; __model__ and world, too."""
        if name in ("", "__model__"):
            return self.model
        if name == WORLD:
            return Frame()
        if name not in self._nodes:
            self._reader.add(self._reader.root, "pose", f"no frame '{name}'")
            return Frame()
        if name in self._open:
            ring = " -> ".join([*self._open[self._open.index(name) :], name])
            self._reader.add(
                self._nodes[name], f"{self._kinds[name]} '{name}' pose", f"is relative to itself: {ring}"
            )
            return Frame()
        if name not in self._known:
            self._open.append(name)
            self._known[name] = self._resolved(name)
            self._open.pop()
        return self._known[name]

    def own(self, node: Node, who: str) -> Frame:
        """What the <pose> of a node says, in the frame that it is relative to."""
        pose = node.one("pose")
        if pose is None:
            return Frame()
        angles = 4 if pose.attributes.get("rotation_format") == "quat_xyzw" else 3
        values = self._reader.numbers(
            pose, pose.text, 3 + angles, f"{who} pose", [0.0] * 6 + [1.0] * (angles - 3)
        )
        if angles == 4:
            x, y, z, w = values[3:]
            if not any(values[3:]):
                self._reader.add(pose, f"{who} pose", "quaternion is zero")
                return Frame()
            return from_quaternion(values[:3], (w, x, y, z))
        degrees = pose.attributes.get("degrees") in ("1", "true")
        return from_rpy(values[:3], np.radians(values[3:]) if degrees else values[3:])

    def _resolved(self, name: str) -> Frame:
        """A link is in the model by default, a joint in its child, a frame in what it is attached to."""
        node, kind = self._nodes[name], self._kinds[name]
        usual = (
            ""
            if kind == "link"
            else node.word("child") or ""
            if kind == "joint"
            else node.attributes.get("attached_to", "")
        )
        pose = node.one("pose")
        given = (
            (pose.attributes.get("relative_to") or pose.attributes.get("frame")) if pose is not None else None
        )
        return self.pose(given or usual) @ self.own(node, f"{kind} '{name}'")


def _version(root: Node) -> tuple[int, int]:
    """(1, 11) where there is none to be understood."""
    try:
        major, minor = (int(part) for part in root.attributes.get("version", "").split(".")[:2])
    except ValueError:
        return 1, 11
    return major, minor
