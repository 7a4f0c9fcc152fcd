"""URDF, the Unified Robot Description Format of ROS: links and joints in a tree. https://wiki.ros.org/urdf/XML"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TypeVar, Unpack

import numpy as np

from linkwork.arguments import folders
from linkwork.arrays import Floats
from linkwork.errors import ModelError
from linkwork.importers.building import Options, build
from linkwork.importers.coverage import report
from linkwork.importers.description import WORLD, Imported, JointDescription, LinkDescription, Motion
from linkwork.importers.frames import Frame, from_rpy
from linkwork.importers.robot_file import RobotFile, Texts, coupling, direction, rings, set_inertia
from linkwork.importers.urdf_coverage import URDF
from linkwork.importers.visuals import GRAY, Visuals, capsule, hex_of, numbers
from linkwork.importers.xml_text import Node, Reader
from linkwork.modeling.shapes import Box, Cylinder, Shape, Sphere
from linkwork.rotation import perpendicular

__all__ = ["import_urdf"]

X = np.array([1.0, 0.0, 0.0])

#: Visual geometry that needs no file, from its attributes and a color.
SOLIDS: Mapping[str, Callable[[Texts, str], Sequence[Shape]]] = {
    "box": lambda texts, color: [Box(numbers(texts("size"), 3, "box size"), color=color)],
    "cylinder": lambda texts, color: [Cylinder(*_round(texts, "cylinder"), color=color)],
    "capsule": lambda texts, color: capsule(*_round(texts, "capsule"), color),
    "sphere": lambda texts, color: [Sphere(numbers(texts("radius"), 1, "sphere radius")[0], color=color)],
}

#: How joints with axes are called here.
KINDS = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "translational",
    "planar": "planar",
}

#: And those without.
OTHERS = {"fixed": "fixed", "floating": "free", "spherical": "spherical", "ball": "spherical"}


def import_urdf(
    path: str | os.PathLike[str],
    *,
    search_path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    **options: Unpack[Options],
) -> Imported:
    """The robot in a URDF file, at joint coordinates zero or at `coordinates`.

        model = lw.import_urdf("arm.urdf", coordinates={"elbow": -0.8}, limits="stops").model

    search_path  a folder or several where meshes are looked for: package://name/... is in a folder of that
                 name in one of them or of ROS_PACKAGE_PATH, or around the file

    Options are those of linkwork.importers.building.Options: floating, coordinates, velocities, gravity,
    keep_massless, repair_inertia, inertia_as_is, limits, shapes, align_axes, couple, merge_fixed. The base is
    the ground, unless floating=True; a link named world always is. Each link is a body of the same name, its
    axes those of the link; massless links are parts of the links that they are fixed to. Links look like
    their visual geometry.

    Not represented, and listed in the notes: limits, unless limits="stops", transmissions, collision
    geometry, and what else linkwork.importers.urdf_coverage lists. ModelFileError: what is wrong in the file,
    with lines; moving links without inertia. ModelError: coordinates of joints that do not exist. FileError:
    `search_path` leads nowhere.
    """
    reader = Reader(path, "robot", blank="wrong")
    robot = _Robot(reader, folders(search_path, "search_path"), options)
    reader.finish()
    name = reader.root.attributes.get("name", "")
    return build(robot.description(reader.path, name, grounded=robot.links), options, robot.lines)


def _round(texts: Texts, kind: str) -> tuple[float, float]:
    """Radius and length."""
    radius, length = (numbers(texts(what), 1, f"{kind} {what}")[0] for what in ("radius", "length"))
    return radius, length


_Named = TypeVar("_Named", LinkDescription, JointDescription)


class _Robot(RobotFile):
    def __init__(self, reader: Reader, search_path: Sequence[Path], options: Options) -> None:
        super().__init__(options)
        self._reader = reader
        root = reader.root
        self._visuals = Visuals(reader.path, search_path, self.note, options.get("shapes", True))
        self._colors = dict(_colors(root))
        for node in root.children:
            if node.tag == "link":
                self._once(self.links, node, self._link(node))
            elif node.tag == "joint":
                joint = self._joint(node)
                if joint is not None:
                    self._once(self.joints, node, joint)
            elif node.tag.startswith("xacro:"):
                reader.add(node, node.tag, "is a macro: expand the file by xacro first")
        self._visuals.finish()
        report(URDF.survey(root), self.note, reader.add)
        self._check_tree()
        self._note_world(bool(options.get("floating")))
        self.check_couplings(reader)

    def _once(self, known: dict[str, _Named], node: Node, made: _Named) -> None:
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
        self.note_children(node, who, ("collision",), " geometry")
        for visual in node.all("visual"):
            self._visuals.add(link.shapes, who, partial(self._shapes, visual), self._origin(visual, who))
        inertial = node.one("inertial")
        if inertial is None:
            return link
        mass = inertial.one("mass")
        value = mass.attributes.get("value") if mass else None
        link.mass = self._reader.number(inertial, value, f"{who} mass")
        frame = self._origin(inertial, who)
        tensor = inertial.one("inertia")
        if tensor is None:
            self._reader.add(inertial, f"{who} inertia", "is missing")
            return link
        set_inertia(
            link, self._reader, frame, tensor, tensor.attributes.get, {"ixy": 0.0, "ixz": 0.0, "iyz": 0.0}
        )
        return link

    def _shapes(self, visual: Node) -> Sequence[Shape]:
        """Of one visual geometry, in its frame."""
        given = visual.find("material", "color")
        name = (visual.one("material") or visual).attributes.get("name", "")
        color = _color(given) if given is not None else self._colors.get(name)
        geometry = visual.one("geometry")
        for node in geometry.children if geometry is not None else ():
            texts = node.attributes.get
            if node.tag == "mesh":
                scale = numbers(texts("scale"), 3, "mesh scale", [1.0] * 3)
                return self._visuals.mesh(texts("filename", ""), scale, otherwise=color)
            if node.tag in SOLIDS:
                return SOLIDS[node.tag](texts, color or GRAY)
        raise ModelError("there is no box, cylinder, capsule, sphere or mesh", code="shape")

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
        if type_ in KINDS:
            joint.kind = KINDS[type_]
            axis = node.one("axis")
            text = axis.attributes.get("xyz") if axis else None
            along = direction(self._reader, axis or node, text, f"{who} axis", X)
            joint.motions = (
                _planar(along) if type_ == "planar" else (Motion(joint.kind == "revolute", along),)
            )
            self._dynamics(node, joint, who)
            self._limits(node, joint, type_)
            self._mimic(node, joint)
        elif type_ in OTHERS:
            joint.kind = OTHERS[type_]
            self.note_children(node, who, ("dynamics", "limit", "mimic"), f" of a {type_} joint")
        else:
            self._reader.add(node, who, f"type '{type_}' does not exist" if type_ else "type is missing")
            return None
        self.note_children(node, who, ("calibration", "safety_controller"))
        return joint

    def _dynamics(self, node: Node, joint: JointDescription, who: str) -> None:
        dynamics = node.one("dynamics")
        if dynamics is not None:
            for what in ("damping", "friction"):
                value = self._reader.number(
                    dynamics, dynamics.attributes.get(what), f"{who} dynamics {what}", 0.0
                )
                setattr(joint, what, value)

    def _limits(self, node: Node, joint: JointDescription, type_: str) -> None:
        limit = node.one("limit")
        if limit is None:
            return
        who = f"joint '{joint.name}'"
        lower, upper = (self._reader.number(limit, limit.attributes.get(end), f"{who} limit {end}", 0.0)
                        for end in ("lower", "upper"))  # fmt: skip
        ends = type_ in ("revolute", "prismatic")
        found = [
            f"{what} {text}"
            for what, text in limit.attributes.items()
            if not ends or what not in ("lower", "upper")
        ]
        if not ends:
            lower, upper = -np.inf, np.inf
        self.limit(joint, lower, upper, "rad" if type_ == "revolute" else "m", found)

    def _mimic(self, node: Node, joint: JointDescription) -> None:
        mimic = node.one("mimic")
        if mimic is None:
            return
        texts = mimic.attributes.get
        self.couplings.append(coupling(self._reader, mimic, joint.name, texts("joint", ""), texts))

    def _check_tree(self) -> None:
        """Every link has at most one parent, and the chain of parents ends."""
        links, joints = self.links, self.joints
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
            if joint.child == WORLD:
                self._reader.add(
                    node, f"joint '{name}' child", f"link '{WORLD}' is the ground: nothing carries it"
                )
            parent_of.setdefault(joint.child, joint.parent)
        ring = {link for links in rings(parent_of) for link in links}
        for name, joint in joints.items():
            if joint.child in ring and parent_of[joint.child] == joint.parent:
                self._reader.add(
                    by_name[name], f"joint '{name}'", "is part of a ring of joints; a URDF is a tree"
                )

    def _note_world(self, floating: bool) -> None:
        """What a link that is the ground by its name does not have."""
        link, who = self.links.get(WORLD), f"link '{WORLD}'"
        if link is not None and floating:
            self.note("base", who, "is the ground by its name: it does not float, nor what is fixed to it")
        if link is not None and link.mass:
            self.note("base", who, f"is the ground by its name: its mass {link.mass:g} is not represented")


def _colors(root: Node) -> Iterator[tuple[str, str]]:
    """Of materials by name: those of the robot, and those that a link defines."""
    visuals = (visual for link in root.all("link") for visual in link.all("visual"))
    for material in (*(it for visual in visuals for it in visual.all("material")), *root.all("material")):
        color, name = material.one("color"), material.attributes.get("name")
        if color is not None and name:
            with suppress(ModelError):  # said where it is used
                yield name, _color(color)


def _color(node: Node) -> str:
    """ModelError: no four numbers."""
    return hex_of(numbers(node.attributes.get("rgba"), 4, "color"))


def _planar(normal: Floats) -> tuple[Motion, ...]:
    x = perpendicular(normal)
    return Motion(False, x), Motion(False, np.cross(normal, x)), Motion(True, normal)
