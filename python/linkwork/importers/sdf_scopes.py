"""Names in an SDF file: the frames of a model or of the world, and models in models with their own frames.

A name means something in the model that it is in; a::b is b in the model a. Nothing in a model can refer to
what is around it, but for joints whose parent is the world. http://sdformat.org/tutorials: pose frame
semantics, model composition.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from linkwork.errors import nearest
from linkwork.importers.description import WORLD
from linkwork.importers.frames import Frame, from_quaternion, from_rpy
from linkwork.importers.sdf_includes import DEPTH, Library, Source
from linkwork.importers.xml_text import Node

__all__ = ["Scope"]

#: What has a frame, in the order in which a name means it in files before 1.7, which may give it to several.
TAGS = ("link", "model", "frame", "joint")

#: The frame of the model that a name is in.
MODEL = "__model__"

SEPARATOR = "::"

#: The version from which on names cannot have it.
RESERVED = (1, 8)

#: What three or four numbers behind the origin of a pose are.
ROTATIONS = {"": 3, "euler_rpy": 3, "quat_xyzw": 4}


class Scope:
    """A model, or the world, with what is named in it. Poses are in the frame of the model itself."""

    def __init__(
        self,
        node: Node,
        source: Source,
        library: Library,
        parent: Scope | None = None,
        placed_by: Node | None = None,
        prefix: str | None = None,
    ) -> None:
        """`placed_by`: the <model> or <include> in the parent's file. `prefix` of full names."""
        self.node, self.source, self.parent = node, source, parent
        self.reader = source.reader
        self.placed_by = node if placed_by is None else placed_by
        self.name = self.placed_by.word("name") or node.attributes.get("name", "")
        self.prefix: str = (
            f"{parent.prefix}{self.name}{SEPARATOR}" if prefix is None and parent else prefix or ""
        )
        self.is_world = node.tag == WORLD
        self._included_at: int | None = parent._included_at if parent is not None else None
        if self._included_at is None and self.placed_by.tag == "include":
            self._included_at = self.placed_by.line
        self._depth: int = parent._depth + 1 if parent is not None else 0
        self.nodes: dict[str, dict[str, Node]] = {tag: {} for tag in TAGS}
        self.models: dict[str, Scope] = {}
        self._known: dict[tuple[str, str], Frame] = {}
        self._links: dict[str, str | None] = {}  #: of names whose link was asked for
        for child in node.children:
            if child.tag in ("link", "frame", "joint"):
                self._add(child, child.tag, child.attributes.get("name", ""))
        self._add_models(library)

    def scopes(self) -> Iterator[Scope]:
        """This one, and those of the models in it."""
        yield self
        for model in self.models.values():
            yield from model.scopes()

    def line(self, node: Node) -> int:
        """In the first file: of a node, or of what includes it."""
        return self._included_at or node.line

    @cached_property
    def is_static(self) -> bool:
        """The model cannot move: it says so, or what includes it, or one around it."""
        outer = self.parent.reader if self.parent is not None else self.reader
        node, reader = (self.placed_by, outer) if self.placed_by.word("static") else (self.node, self.reader)
        said = reader.boolean(node, node.word("static"), f"model '{self.name}' static")
        return said or (self.parent is not None and self.parent.is_static)

    # --- names ---

    def _add(self, node: Node, tag: str, name: str) -> None:
        who = f"{tag} '{name}'"
        taken = [other for other in TAGS if name in self.nodes[other]]
        if not name:
            self.reader.add(node, tag, "name is missing")
        elif name == WORLD:
            self.reader.add(node, who, "is the name of the ground")
        elif SEPARATOR in name and self.source.version >= RESERVED:
            self.reader.add(node, who, f"has {SEPARATOR}, which stands behind names of models")
        elif tag in taken:
            self.reader.add(node, who, "is given twice")
        elif taken and self.source.version >= (1, 7):
            self.reader.add(node, who, f"is the name of a {taken[0]}, too")
        self.nodes[tag][name] = node

    def _add_models(self, library: Library) -> None:
        children = [child for child in self.node.children if child.tag in ("model", "include")]
        if children and self._depth >= DEPTH:
            self.reader.add(children[0], children[0].tag, f"models are nested more than {DEPTH} deep")
            return
        prefix = "" if self.is_world and len(children) == 1 and not self.nodes["joint"] else None
        for child in children:
            found = (self.source, child) if child.tag == "model" else library.include(child, self.source)
            if found is not None:
                source, node = found
                model = Scope(node, source, library, self, child, prefix)
                self._add(child, "model", model.name)
                self.models[model.name] = model

    def _tag(self, name: str) -> str | None:
        return next((tag for tag in TAGS if name in self.nodes[tag]), None)

    def _inner(self, name: str) -> tuple[Scope, str] | None:
        """Of a name a::b: the model a and the name b in it."""
        for model, scope in self.models.items():
            if model and name.startswith(model + SEPARATOR):
                return scope, name[len(model) + len(SEPARATOR) :]
        return None

    # --- links ---

    def link(self, name: str) -> str | None:
        """The full name of the link that a frame is attached to, or world; None: there is no such frame."""
        passed: dict[str, None] = {}
        while name not in self._links and (holder := self._attached_to(name)) is not None:
            if name in passed:
                node = self.nodes[self._tag(name) or "frame"][name]
                self._refuse_ring(node, "attached to", [*passed, name])
                return None
            passed[name] = None
            name = holder
        found = self._links[name] if name in self._links else self._end(name)
        self._links |= dict.fromkeys([*passed, name], found)
        return found

    def _attached_to(self, name: str) -> str | None:
        """What a frame or joint is attached to; None: the name is that of something else."""
        tag = self._tag(name) if name not in ("", MODEL, WORLD) else None
        if tag not in ("frame", "joint"):
            return None
        node = self.nodes[tag][name]
        return node.attributes.get("attached_to", "") if tag == "frame" else node.word("child") or ""

    def _end(self, name: str) -> str | None:
        """The full name of the link of what is attached to nothing else here, as for `link`."""
        if name in ("", MODEL):
            return WORLD if self.is_world else self._canonical_link()
        if name == WORLD:
            return WORLD
        tag, inner = self._tag(name), self._inner(name)
        if tag == "link":
            return self.prefix + name
        if tag == "model":
            return self.models[name].link("")
        return inner[0].link(inner[1]) if inner else None

    def _canonical_link(self) -> str | None:
        """The one that the model names, or its first, or that of the first model in it that has one."""
        given = self.node.attributes.get("canonical_link")
        if given:
            return self.link(given) if given in self.nodes["link"] or self._inner(given) else None
        if self.nodes["link"]:
            return self.prefix + next(iter(self.nodes["link"]))
        return next((link for model in self.models.values() if (link := model.link(""))), None)

    # --- poses ---

    @cached_property
    def absolute(self) -> Frame:
        """The model's frame in the world."""
        if self.parent is not None:
            return self.parent.absolute @ self.parent.pose_of("model", self.name)
        return Frame() if self.is_world else self._placed(self, self.node)

    def pose(self, name: str, at: Node) -> Frame:
        """Of a link, joint, frame or model, or of __model__. A fault of the node `at`: there is none."""
        if name in ("", MODEL):
            return Frame()
        tag = self._tag(name)
        if tag is not None:
            return self.pose_of(tag, name)
        inner = self._inner(name)
        if inner is not None:
            scope, rest = inner
            return self.pose_of("model", scope.name) @ scope.pose(rest, at)
        if name == WORLD and self.is_world:
            return Frame()
        hint = nearest(name, (name for tag in TAGS for name in self.nodes[tag]))
        self.reader.add(at, "pose", f"no frame '{name}'{hint}")
        return Frame()

    def pose_of(self, tag: str, name: str) -> Frame:
        """Of what has this tag and name here: along what each is relative to, from the last back."""
        chain: list[tuple[str, str]] = []
        key: tuple[str, str] | None = (tag, name)
        while key is not None and key not in self._known:
            if key in chain:
                ring = chain[chain.index(key) :]
                self._refuse_ring(
                    self.nodes[key[0]][key[1]], "relative to", [name for _, name in [*ring, key]]
                )
                self._known |= dict.fromkeys(ring, Frame())
                break
            chain.append(key)
            key = self._holder(self._relative_to(*key))
        for key in reversed(chain):
            if key not in self._known:
                self._known[key] = self._resolved(*key)
        return self._known[tag, name]

    def _holder(self, name: str) -> tuple[str, str] | None:
        """Tag and name of what is here and has the frame: itself, or the model that it is in."""
        tag, inner = self._tag(name), self._inner(name)
        return (tag, name) if tag is not None else ("model", inner[0].name) if inner is not None else None

    def _relative_to(self, tag: str, name: str) -> str:
        """Links and models are in the model by default, joints in their child, frames in what they are
        attached to."""
        node = self.nodes[tag][name]
        pose = node.one("pose")
        given = (
            pose.attributes.get("relative_to") or pose.attributes.get("frame") if pose is not None else None
        )
        if given:
            return given
        return {"joint": node.word("child"), "frame": node.attributes.get("attached_to")}.get(tag) or ""

    def _resolved(self, tag: str, name: str) -> Frame:
        node = self.nodes[tag][name]
        around = self.pose(self._relative_to(tag, name), node)
        if tag != "model":
            return around @ self.own(node, f"{tag} '{name}'")
        model = self.models[name]
        if node.one("pose") is not None:
            return around @ model._placed(self, node)
        return around @ model._placed(model, model.node)  # included without a pose: as in its own file

    def _placed(self, scope: Scope, node: Node) -> Frame:
        """This model by the <pose> of a node in a scope, which is that of its placement frame."""
        pose = node.one("pose")
        frame = pose.attributes.get("relative_to") if pose is not None else None
        if scope is self and frame:
            self.reader.add(
                node, "pose", f"there is nothing that a model alone could be relative to: '{frame}'"
            )
        frame = self.placed_by.word("placement_frame") or self.node.attributes.get("placement_frame", "")
        return scope.own(node, f"model '{self.name}'") @ self.pose(frame, self.node).inverse

    def own(self, node: Node, who: str) -> Frame:
        """What the <pose> of a node says, in the frame that it is relative to."""
        pose = node.one("pose")
        if pose is None:
            return Frame()
        given = pose.attributes.get("rotation_format", "")
        degrees = self.reader.boolean(pose, pose.attributes.get("degrees"), f"{who} pose degrees")
        if given not in ROTATIONS:
            known = ", ".join(filter(None, ROTATIONS))
            self.reader.add(
                pose, f"{who} pose", f"rotation_format '{given[:60]}' is not taken; there are {known}"
            )
        angles = ROTATIONS.get(given, 3)
        if angles == 4 and degrees:
            self.reader.add(pose, f"{who} pose", "a quaternion is not in degrees")
        standard = [0.0] * 6 + [1.0] * (angles - 3)
        values = self.reader.numbers(pose, pose.text, 3 + angles, f"{who} pose", standard)
        if angles == 4:
            x, y, z, w = values[3:]
            if not any(values[3:]):
                self.reader.add(pose, f"{who} pose", "quaternion is zero")
                return Frame()
            return from_quaternion(values[:3], (w, x, y, z))
        return from_rpy(values[:3], np.radians(values[3:]) if degrees else values[3:])

    def _refuse_ring(self, node: Node, how: str, names: list[str]) -> None:
        tag = self._tag(names[0]) or "frame"
        self.reader.add(node, f"{tag} '{names[0]}' pose", f"is {how} itself: {' -> '.join(names)}")
