"""SDF, the Simulation Description Format of Gazebo: links anywhere, joints in trees and loops. http://sdformat.org"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Unpack

import numpy as np

from linkwork.arguments import folders
from linkwork.arrays import Floats
from linkwork.importers.building import PERPENDICULAR, Options, build
from linkwork.importers.coverage import report
from linkwork.importers.description import (
    WORLD,
    Coupling,
    Imported,
    JointDescription,
    LinkDescription,
    Motion,
)
from linkwork.importers.frames import Frame
from linkwork.importers.robot_file import UNLIMITED, RobotFile, coupling, direction, set_inertia
from linkwork.importers.sdf_coverage import SDF
from linkwork.importers.sdf_includes import LATEST, Library, Source, version
from linkwork.importers.sdf_scopes import Scope
from linkwork.importers.sdf_visuals import shapes_of
from linkwork.importers.visuals import Visuals
from linkwork.importers.xml_text import Node, Reader

__all__ = ["import_sdf"]

Z = np.array([0.0, 0.0, 1.0])

#: What says how a joint moves: its first axis, its second.
AXES = ("axis", "axis2")

#: Elements that only joints of some types have, by these.
ONLY = {
    "universal revolute2 gearbox": "axis2",
    "screw": "thread_pitch screw_thread_pitch",
    "gearbox": "gearbox_ratio gearbox_reference_body",
}

#: Cosines of an angle from which on two axes are one, up to their sense: 1 less this.
SAME_AXIS = 1e-5

#: Acceleration [m/s2] where a file has no other.
GRAVITY = [0.0, 0.0, -9.8]

#: The version from which on it is of the world, not of <physics>.
GRAVITY_OF_WORLDS = (1, 6)

#: The inertia [kg m2] where a file has no other.
INERTIA = {"ixx": 1.0, "iyy": 1.0, "izz": 1.0, "ixy": 0.0, "ixz": 0.0, "iyz": 0.0}

#: How joints are called here.
KINDS = {
    "fixed": "fixed",
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "translational",
    "ball": "spherical",
    "universal": "universal",
    "revolute2": "universal",
    "screw": "screw",
}


def import_sdf(
    path: str | os.PathLike[str],
    *,
    search_path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    **options: Unpack[Options],
) -> Imported:
    """The mechanism in an SDF file, with its closed loops, at the poses of its links or at `coordinates`.

        model = lw.import_sdf("arm.sdf", search_path="models").model

    search_path  a folder or several where models of other files are looked for, and meshes: model://arm is
                 the folder or file arm in one of them or beside the file; a path is relative to the file, or
                 to one of them. What an <include> means must be in these folders; nothing is downloaded

    Other options are those of linkwork.importers.building.Options: floating, coordinates, velocities,
    gravity, keep_massless, repair_inertia, inertia_as_is, limits, shapes, align_axes, couple, merge_fixed.
    Links look like their visual geometry. Links that nothing joins to the
    world move freely, unless their model is static or floating=False. Joints stand where the poses of the
    links put them; those that close loops have no coordinates of their own. Links and joints of models in
    models, and of the models of a world with several, are called model::name.

    Not represented, and listed in the notes: limits, unless limits="stops", plugins, collision geometry, and
    what else linkwork.importers.sdf_coverage lists. ModelFileError: what is wrong in the file, with lines;
    versions before 1.2; moving links without inertia. ModelError: wrong coordinates. FileError: `search_path`
    leads nowhere.
    """
    places = folders(search_path, "search_path")
    library, source = Library.of(path, places)
    file = _SdfFile(source, library, places, options)
    library.finish()
    description = file.description(
        source.reader.path, file.root.name, gravity=np.array(file.gravity), grounded=file.grounded
    )
    return build(description, options, file.lines)


class _SdfFile(RobotFile):
    """All models of a file."""

    def __init__(
        self, source: Source, library: Library, search_path: Sequence[Path], options: Options
    ) -> None:
        super().__init__(options)
        self._reader = reader = source.reader
        wanted = options.get("shapes", True)
        self._visuals: dict[str, Visuals] = {}  #: by the path of the file
        self._visuals_of = partial(Visuals, search_path=search_path, note=self.note, wanted=wanted)
        first = self._first()
        self.gravity = self._gravity(first, source.version)
        self.root = Scope(first, source, library)
        self.grounded: set[str] = set()  #: links of static models
        self._gearboxes: list[tuple[Scope, str, Node]] = []
        for read in (self._read_links, self._read_joints):
            for scope in self.root.scopes():
                read(scope)
        for scope, name, node in self._gearboxes:
            self._gearbox(scope, name, node)
        for visuals in self._visuals.values():
            visuals.finish()
        self._report(library)
        if not self.links:
            reader.add(self.root.node, "model", "has no links")
        self.check_couplings(reader)

    def _report(self, library: Library) -> None:
        """Note and refuse what the lists of the format say, in all files."""
        for reader in library.readers.values():
            where = "" if reader is self._reader else f" (in '{os.path.basename(reader.path)}')"

            def note(topic: str, subject: str, message: str, where: str = where) -> None:
                self.note(topic, subject, message + where)

            if (found := version(reader.root)) is not None and found > LATEST:
                known = ".".join(map(str, LATEST))
                note("version", "sdf", f"{'.'.join(map(str, found))} is not known here: read as {known}")
            report(SDF.survey(reader.root), note, reader.add)

    def _first(self) -> Node:
        """The world, or the model where there is no world."""
        root, reader = self._reader.root, self._reader
        found = [node for node in root.children if node.tag in ("model", WORLD)]
        if len(found) != 1:
            reader.add(root, "sdf", f"has {len(found)} models; one is taken, or one world of many")
            reader.finish()
        return found[0]

    def _gravity(self, first: Node, version: tuple[int, int]) -> list[float]:
        """Of a world, or, before SDF 1.6, of its physics: that which is the default, or the first."""
        reader, world = self._reader, first.tag == WORLD
        given = first.one("gravity") if world else None
        all_physics = list(first.all("physics")) if world else []
        if given is None and all_physics and version < GRAVITY_OF_WORLDS:
            default = [
                it for it in all_physics if reader.boolean(it, it.attributes.get("default"), "default")
            ]
            given = (default or all_physics)[0].one("gravity")
        for node in (it for physics in all_physics for it in physics.all("gravity") if it is not given):
            why = "another one is" if version < GRAVITY_OF_WORLDS else "since SDF 1.6 it is that of the world"
            self.note("element", "<gravity>", f"in line {node.line}, of <physics>, is not taken: {why}")
        return reader.numbers(given or first, given.text if given else None, 3, "gravity", GRAVITY)

    def _read_links(self, scope: Scope) -> None:
        for tag, name in ((tag, name) for tag, named in scope.nodes.items() for name in named):
            scope.pose_of(tag, name)  # faults of frames that nothing uses are faults, too
        if not scope.is_world and scope.node.attributes.get("canonical_link") and scope.link("") is None:
            text = f"no link '{scope.node.attributes['canonical_link'][:60]}'"
            scope.reader.add(scope.node, f"model '{scope.name}' canonical_link", text)
        for name, node in scope.nodes["link"].items():
            link = self._link(scope, name, node)
            if link.name in self.links:
                scope.reader.add(node, f"link '{link.name}'", "is the full name of another, too")
            self.links[link.name] = link
            self.lines[f"link {link.name}"] = scope.line(node)
            if scope.is_static:
                self.grounded.add(link.name)

    def _read_joints(self, scope: Scope) -> None:
        for name, node in scope.nodes["joint"].items():
            self.lines[f"joint {scope.prefix}{name}"] = scope.line(node)
            joint = self._joint(scope, name, node)
            if joint is not None:
                if joint.name in self.joints:
                    scope.reader.add(node, f"joint '{joint.name}'", "is the full name of another, too")
                self.joints[joint.name] = joint
                if scope.is_static and joint.kind != "fixed":
                    self.note("static", f"joint '{joint.name}'", "moves, though its model is static")

    def _link(self, scope: Scope, name: str, node: Node) -> LinkDescription:
        link = LinkDescription(scope.prefix + name, pose=scope.absolute @ scope.pose_of("link", name))
        who, reader = f"link '{link.name}'", scope.reader
        self.note_children(node, who, ("collision",), " geometry")
        self._read_visuals(scope, node, link)
        link.weightless = float(not reader.boolean(node, node.word("gravity"), f"{who} gravity", True))
        inertial = node.one("inertial")
        if inertial is None:  # the defaults of the format
            link.mass, link.inertia = 1.0, np.eye(3)
            self.note("inertial", who, "is missing: 1 kg and 1 kg m2, the defaults of SDF")
            return link
        if reader.boolean(inertial, inertial.attributes.get("auto"), f"{who} inertial auto"):
            reader.add(
                inertial, who, "auto inertia is not taken: it follows from shapes; give mass and inertia"
            )
        pose = inertial.one("pose")
        for what in ("relative_to", "frame") if pose is not None else ():
            if pose is not None and pose.attributes.get(what):
                reader.add(
                    pose, f"{who} inertial pose", f"{what} is not taken: it is in the frame of the link"
                )
        link.mass = reader.number(inertial, inertial.word("mass"), f"{who} mass", 1.0)
        inertia = inertial.one("inertia") or inertial
        set_inertia(link, reader, scope.own(inertial, who), inertia, inertia.word, INERTIA)
        if inertial.one("fluid_added_mass") is not None:
            self.note("fluid_added_mass", who, "its added mass is not represented")
        return link

    def _read_visuals(self, scope: Scope, node: Node, link: LinkDescription) -> None:
        path = scope.source.reader.path
        visuals = self._visuals.setdefault(path, self._visuals_of(path))
        for visual in node.all("visual"):
            who = f"link '{link.name}' visual"
            pose = visual.one("pose")
            named = pose is not None and (pose.attributes.get("relative_to") or pose.attributes.get("frame"))
            frame = scope.own(visual, who)
            if named and named != link.name:
                at = scope.absolute @ scope.pose(named, visual)
                frame = link.pose.inverse @ at @ frame
            visuals.add(link.shapes, who, partial(shapes_of, visuals, visual), frame)

    def _ends(self, scope: Scope, name: str, node: Node) -> tuple[str, str] | None:
        """The full names of the links that a joint joins."""
        who, out = f"joint '{scope.prefix}{name}'", []
        for end in ("parent", "child"):
            frame = node.word(end) or ""
            link = scope.link(frame) if frame else None
            if not frame:
                scope.reader.add(node, who, f"{end} is missing")
            elif link is None or (end == "child" and link == WORLD):
                scope.reader.add(node, f"{who} {end}", f"no link '{frame}'")
            else:
                out.append(link)
        return (out[0], out[1]) if len(out) == 2 else None

    def _joint(self, scope: Scope, name: str, node: Node) -> JointDescription | None:
        reader, type_ = scope.reader, node.attributes.get("type", "")
        full = scope.prefix + name
        who = f"joint '{full}'"
        ends = self._ends(scope, name, node)
        if ends is None or reader.faults.count:
            return None
        if type_ == "gearbox":
            self._note_unused(node, who, type_)
            self._note_dynamics(node, who, AXES)
            self.note_children(node, who, ("physics", "sensor"))
            self._gearboxes.append((scope, name, node))
            return None
        if type_ not in KINDS:
            known = f"type '{type_}' is not taken; there are {', '.join(KINDS)}"
            reader.add(node, who, known if type_ else "type is missing")
            return None
        here = scope.absolute @ scope.pose_of("joint", name)
        in_parent, in_child = (self._pose_of_link(link).inverse @ here for link in ends)
        joint = JointDescription(full, KINDS[type_], *ends, in_parent, in_child)
        count = {"universal": 2, "fixed": 0, "spherical": 0}.get(joint.kind, 1)
        axes = [self._axis(scope, node, tag, who, here) for tag in AXES[:count]]
        if joint.kind == "universal" and abs(axes[0] @ axes[1]) > PERPENDICULAR:
            reader.add(node, f"{who} axis2", "is not perpendicular to axis")
        joint.motions = tuple(Motion(joint.kind != "translational", axis) for axis in axes)
        if joint.kind == "screw":
            self._screw(reader, node, joint, who)
        if count == 1:
            self._dynamics(scope, node, joint, who, type_)
        else:
            self._note_dynamics(node, who, AXES[: max(count, 1)])
        self._note_unused(node, who, type_)
        self.note_children(node, who, ("physics", "sensor"))
        return joint

    def _pose_of_link(self, link: str) -> Frame:
        """In the world."""
        return Frame() if link == WORLD else self.links[link].pose

    def _screw(self, reader: Reader, node: Node, joint: JointDescription, who: str) -> None:
        """SDF's thread_pitch is [rad/m] with the other sign; screw_thread_pitch is [m] per turn."""
        per_turn, per_meter = node.word("screw_thread_pitch"), node.word("thread_pitch")
        if per_turn is not None or per_meter is None:
            joint.pitch = reader.number(node, per_turn, f"{who} screw_thread_pitch")
        else:
            rate = reader.number(node, per_meter, f"{who} thread_pitch")
            joint.pitch = -2 * np.pi / rate if rate else 0.0
        if joint.pitch == 0:
            reader.add(node, f"{who} screw_thread_pitch", "must not be zero")
        (motion,) = joint.motions
        joint.motions = (replace(motion, lead=joint.pitch / (2 * np.pi)),)

    def _axis(self, scope: Scope, node: Node, tag: str, who: str, here: Frame) -> Floats:
        """A direction of unit length in the joint's frame, which is `here` in the world."""
        axis, version = node.one(tag), scope.source.version
        if axis is None:
            scope.reader.add(node, f"{who} {tag}", "is missing")
            return Z
        xyz = axis.one("xyz")
        given = direction(scope.reader, xyz or axis, xyz.text if xyz else None, f"{who} {tag}", Z)
        expressed_in = xyz.attributes.get("expressed_in") if xyz is not None else None
        word, field = axis.word("use_parent_model_frame"), f"{who} {tag} use_parent_model_frame"
        said = scope.reader.boolean(axis, word, field)
        in_model = (said or version < (1, 5)) and version < (1, 7)
        if said and not in_model:
            self.note(
                tag, who, f"use_parent_model_frame of its {tag} is not taken: there is none since SDF 1.7"
            )
        if expressed_in or in_model:
            frame = scope.absolute @ scope.pose(expressed_in or "", axis)
            given = here.A.T @ (frame.A @ given)
        return given

    def _dynamics(self, scope: Scope, node: Node, joint: JointDescription, who: str, type_: str) -> None:
        reader, axis = scope.reader, node.one("axis")
        dynamics, limit, mimic = (axis.one(tag) if axis else None for tag in ("dynamics", "limit", "mimic"))
        for tag in ("damping", "friction", "spring_stiffness", "spring_reference"):
            field = "stiffness" if tag == "spring_stiffness" else tag
            if dynamics is not None:
                setattr(joint, field, reader.number(dynamics, dynamics.word(tag), f"{who} {tag}", 0.0))
        if limit is not None:
            self._limits(reader, limit, joint, type_ != "continuous")
        if mimic is not None:
            self.couplings.append(self._mimic(scope, mimic, joint))

    def _limits(self, reader: Reader, limit: Node, joint: JointDescription, ends: bool) -> None:
        """`ends`: a joint of this type has some."""
        who = f"joint '{joint.name}'"
        lower, upper = (
            sign * np.inf if _is_infinite(limit.word(end), sign) else
            reader.number(limit, limit.word(end), f"{who} {end}", sign * np.inf)
            for end, sign in (("lower", -1), ("upper", 1))
        )  # fmt: skip
        words = ((tag, limit.word(tag)) for tag in ("effort", "velocity", "stiffness", "dissipation"))
        found = [f"{tag} {text}" for tag, text in words if text and not _is_infinite(text, 1)]
        if not ends:
            given = {"lower": lower, "upper": upper}
            found = [f"{end} {value:g}" for end, value in given.items() if abs(value) < UNLIMITED] + found
            lower, upper = -np.inf, np.inf
        unit = {"revolute": "rad", "translational": "m"}.get(joint.kind, "")
        self.limit(joint, lower, upper, unit, found)

    def _mimic(self, scope: Scope, mimic: Node, joint: JointDescription) -> Coupling:
        leader, axis = mimic.attributes.get("joint", ""), mimic.attributes.get("axis", AXES[0])
        if axis not in AXES:
            text = f"'{axis[:60]}' is not {' or '.join(AXES)}"
            scope.reader.add(mimic, f"joint '{joint.name}' mimic axis", text)
            axis = AXES[0]
        found = coupling(scope.reader, mimic, joint.name, leader and scope.prefix + leader, mimic.word)
        return replace(found, leader_axis=AXES.index(axis))

    # theta_2 = -ratio theta_1: the angles from the reference body to the parent about `axis`, and to the
    # child about `axis2`. Each is the coordinate of a revolute joint, or its negative.
    def _gearbox(self, scope: Scope, name: str, node: Node) -> None:
        """A relation between the joints that carry parent and child on the reference body."""
        full, reader = scope.prefix + name, scope.reader
        who, ends = f"joint '{full}'", self._ends(scope, name, node)
        body = node.word("gearbox_reference_body") or ""
        reference = scope.link(body)
        if not body or reference is None:
            reader.add(node, f"{who} gearbox_reference_body", f"no link '{body}'" if body else "is missing")
        ratio = reader.number(node, node.word("gearbox_ratio"), f"{who} gearbox_ratio", 1.0)
        if ends is None or not body or reference is None:
            return
        here = scope.absolute @ scope.pose_of("joint", name)
        found = [
            self._joint_about(reference, link, here.A @ self._axis(scope, node, tag, who, here))
            for link, tag in zip(ends, AXES, strict=True)
        ]
        if found[0] is None or found[1] is None:
            text = f"no revolute joints about its axes carry '{ends[0]}' and '{ends[1]}' on '{reference}'"
            self.note("gearbox", who, f"is not represented: {text}")
            return
        (leader, first), (follower, second) = found[0], found[1]
        self.couplings.append(Coupling("gearbox", full, follower, leader, -ratio * first * second, 0.0))

    def _joint_about(self, a: str, b: str, axis: Floats) -> tuple[str, float] | None:
        """The revolute joint between two links about an axis, and the sign of its angle from a to b."""
        for joint in self.joints.values():
            if joint.kind == "revolute" and {joint.parent, joint.child} == {a, b}:
                here = self._pose_of_link(joint.parent) @ joint.in_parent
                along = float(axis @ (here.A @ joint.motions[0].axis))
                if abs(along) > 1 - SAME_AXIS:
                    return joint.name, np.sign(along) * (1.0 if joint.parent == a else -1.0)
        return None

    def _note_unused(self, node: Node, who: str, type_: str) -> None:
        """What joints of other types have."""
        unused = [tag for types, tags in ONLY.items() if type_ not in types.split() for tag in tags.split()]
        self.note_children(node, who, tuple(unused), f" of a {type_} joint")

    def _note_dynamics(self, node: Node, who: str, tags: Sequence[str]) -> None:
        for tag in tags:
            for what in ("dynamics", "limit", "mimic"):
                if node.find(tag, what) is not None:
                    self.note(what, who, f"the {what} of its {tag} is not represented")


def _is_infinite(text: str | None, sign: int) -> bool:
    """Whether it says that there is no limit."""
    return bool(re.fullmatch("-inf" if sign < 0 else r"\+?inf", text or "", re.IGNORECASE))
