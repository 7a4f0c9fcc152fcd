"""MJCF, the format of MuJoCo, compiled by the `mujoco` package itself. https://mujoco.readthedocs.io/en/stable/XMLreference.html"""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np

from linkwork.arguments import optional_package
from linkwork.arrays import Floats
from linkwork.errors import Fault, LinkworkError, ModelFileError
from linkwork.importers.building import PERPENDICULAR, Options, build, check_options
from linkwork.importers.coverage import report
from linkwork.importers.description import (
    WORLD,
    Coupling,
    Description,
    Imported,
    JointDescription,
    LinkDescription,
    Motion,
)
from linkwork.importers.frames import Frame, from_quaternion
from linkwork.importers.mjcf_coverage import MJCF
from linkwork.importers.mjcf_dynamics import JointDynamics, is_disabled
from linkwork.importers.mjcf_files import roots
from linkwork.importers.mjcf_gravity import GravityCompensation
from linkwork.importers.mjcf_limits import has_limits, set_limits, tendon_limits
from linkwork.importers.mjcf_names import Names
from linkwork.importers.mjcf_visuals import shapes_of
from linkwork.importers.xml_text import Node, Reader

if TYPE_CHECKING:
    import mujoco

__all__ = ["import_mjcf"]

#: What MuJoCo reads, whatever a file says.
ENCODINGS = ("utf-8", "utf8", "us-ascii", "ascii")

#: Anchors [m] that are one point, and sines of the angle between axes that are one, by rounding.
SAME_POINT, PARALLEL = 1e-12, 1e-9


def import_mjcf(path: str | os.PathLike[str], **options: Unpack[Options]) -> Imported:
    """The model in an MJCF file: bodies, joints, springs, damping, armature; equalities connect, weld, joint.

        model = lw.import_mjcf("arm.xml", coordinates={"elbow": -0.8}).model

    Options are those of linkwork.importers.building.Options: floating, coordinates, velocities, gravity,
    keep_massless, repair_inertia, inertia_as_is, limits, shapes, align_axes, couple, merge_fixed. Coordinates
    are those of MuJoCo, zero or `ref` in the file's pose; flags that disable gravity, equalities, springs,
    dampers or friction are heeded. Several joints of one body are one joint here where one does the same: two
    slides and a hinge across them, two hinges that meet at right angles, a slide and a hinge along one axis.
    All others, and those with springs, damping, friction, armature, stops or linear joint equalities, follow
    each other with massless links between them.

    Bodies look like their geoms, but for planes of the world and geoms of the groups that MuJoCo does not
    show.

    Not represented, and listed in the notes: limits, unless limits="stops", contact, actuators (but for their
    damping and armature), joint equalities that are not linear, and what else
    linkwork.importers.mjcf_coverage lists. Needs the package mujoco (pip install linkwork[mjcf]).
    ModelFileError: what MuJoCo refuses, tendons that exert forces, deformable bodies, plugins that act on
    bodies, moving bodies without inertia. ModelError: wrong coordinates. LinkworkError: no mujoco package.
    """
    check_options(options)
    reader = Reader(path, "mujoco", encodings=ENCODINGS)  # well-formed, without DOCTYPE
    lines = dict(_lines(reader.root))
    try:
        model, said = _compiled(path)
        description = _MujocoModel(os.fspath(path), model, lines, options).description()
    except UnicodeDecodeError:
        text = "a file that it includes is not in UTF-8: save it in that"
        raise ModelFileError(path, [Fault(1, "", text)]) from None
    _report(reader, description)
    reader.finish()
    for text in dict.fromkeys(said):
        description.note("mujoco", "model", f"MuJoCo warns: {text}")
    return build(description, options, lines)


def _lines(node: Node) -> Iterator[tuple[str, int]]:
    """Where named bodies and joints are; what a file includes or MuJoCo names is not there."""
    for child in node.below():
        name = child.attributes.get("name")
        if name and child.tag in ("body", "joint", "freejoint"):
            yield f"{'link' if child.tag == 'body' else 'joint'} {name}", child.line


def _report(reader: Reader, description: Description) -> None:
    """Note and refuse what the lists of the format say, in the file and in those that it includes."""

    def unread(node: Node, reason: str) -> None:
        file = f"<{node.tag}> '{node.attributes.get('file', '')}'"
        description.note("unread", file, f"{reason}: what it has that is not represented is not listed")

    found = (met for root in roots(reader, unread) for met in MJCF.survey(root))
    report(found, description.note, reader.add)


def _compiled(path: str | os.PathLike[str]) -> tuple[mujoco.MjModel, list[str]]:
    """With the warnings, which MuJoCo would print, and write to a file in the current folder.

    In a thread of its own: after some files that MuJoCo could not read, its next warning in the same thread
    never returns.
    """
    mujoco = optional_package("mujoco", "mjcf", f"'{os.fspath(path)}': MJCF", LinkworkError)
    said: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(said.append)
    try:
        with warnings.catch_warnings(record=True) as raised:
            warnings.simplefilter("always")
            with ThreadPoolExecutor(1) as thread:
                spec = thread.submit(lambda: mujoco.MjSpec.from_file(os.fspath(path)).compile())
            model = spec.result()
        return model, said + [str(it.message) for it in raised]
    except (ValueError, RuntimeError, mujoco.FatalError) as error:
        found = re.search(r"line (\d+)", str(error))
        reason = " ".join(str(error).split()).removeprefix("Error: ")
        raise ModelFileError(path, [Fault(int(found[1]) if found else 1, "", f"MuJoCo: {reason}")]) from None
    finally:
        mujoco.set_mju_user_warning(before)


class _MujocoModel:
    def __init__(self, path: str, model: mujoco.MjModel, lines: Mapping[str, int], options: Options) -> None:
        import mujoco

        self._options = options
        self._stops = options.get("limits") == "stops"
        self._path, self._model, self._mj, self._lines = path, model, mujoco, lines
        self._name = Names(model)
        self._dynamics, self._compensation = JointDynamics(model), GravityCompensation(model)
        self._coupled = set(self._in_relations()) if options.get("couple", True) else set[int]()
        self._links: dict[str, LinkDescription] = {}
        self._faults: list[Fault] = []

    def description(self) -> Description:
        model = self._model
        for body in range(1, model.nbody):
            name = self._name("body", body)
            self._links[name] = self._link(body, name)
        gravity = np.zeros(3) if is_disabled(model, "gravity") else np.array(model.opt.gravity)
        out = Description(self._path, self._model_name(), self._links, [], [], gravity)
        joints = [joint for body in range(1, model.nbody) for joint in self._joints_of(body, out)]
        out.joints = joints
        out.joints = joints + list(self._equalities(out))
        self._refuse_and_note(out)
        self._add_shapes(out)
        if not np.isfinite(model.opt.gravity).all():
            self._fault("option gravity", "is not finite")
        if self._faults:
            raise ModelFileError(self._path, self._faults)
        return out

    def _model_name(self) -> str:
        name = bytes(self._model.names).split(b"\0", 1)[0].decode()
        return "" if name == "MuJoCo Model" else name

    def _link(self, body: int, name: str) -> LinkDescription:
        model = self._model
        inertial = from_quaternion(model.body_ipos[body], model.body_iquat[body])
        inertia = inertial.A @ np.diag(model.body_inertia[body]) @ inertial.A.T
        mass, weightless = float(model.body_mass[body]), self._compensation.share(body)
        return LinkDescription(name, mass, inertial.r, inertia, self._pose(body), weightless)

    def _pose(self, body: int) -> Frame:
        """In the parent, all joints at their reference; of children of the world that is their pose."""
        return from_quaternion(self._model.body_pos[body], self._model.body_quat[body])

    # --- joints of the tree ---

    def _joints_of(self, body: int, out: Description) -> Iterator[JointDescription]:
        """What carries a body: a fixed joint, one for all in the file or one for each; nothing carries a free
        one."""
        model, name = self._model, self._name("body", body)
        parent, pose = self._name("body", int(model.body_parentid[body])), self._pose(body)
        joints = range(model.body_jntadr[body], model.body_jntadr[body] + max(model.body_jntnum[body], 0))
        types = [int(model.jnt_type[k]) for k in joints]
        if types == [self._mj.mjtJoint.mjJNT_FREE]:
            yield from self._free(joints[0], name, pose, out)
            return
        if not types:
            label = self._name.free("joint", f"{name} fixed")
            yield JointDescription(label, "fixed", parent, name, pose)
            return
        kind, motions = self._kind(types, joints)
        if len(types) > 1 and (kind is None or self._need_coordinates(joints)):
            yield from self._one_by_one(joints, name, pose, out)
            return
        turning = [k for t, k in zip(types, joints, strict=True) if t != self._mj.mjtJoint.mjJNT_SLIDE]
        anchor = Frame(r=np.array(model.jnt_pos[(turning or joints)[-1]]))  # slides go on from any point
        labels = [self._name("joint", k) for k in joints]
        label = labels[0] if len(labels) == 1 else self._name.free("joint", "+".join(labels))
        assert kind is not None  # every single joint has one
        joint = JointDescription(label, kind, parent, name, pose @ anchor, anchor, motions)
        self._complete(joint, joints, out)
        yield joint

    def _need_coordinates(self, joints: range) -> bool:
        """Whether what acts on several joints, or leads one of them, needs the coordinate of each."""
        if self._dynamics.any_at(joints) or not self._coupled.isdisjoint(joints):
            return True
        return self._stops and has_limits(self._model, joints)

    def _in_relations(self) -> Iterator[int]:
        """Joints of linear relations that act."""
        model = self._model
        for k in range(model.neq):
            if self._acts(k) and int(model.eq_type[k]) == self._mj.mjtEq.mjEQ_JOINT and self._is_linear(k):
                yield from (int(model.eq_obj1id[k]), int(model.eq_obj2id[k]))

    def _acts(self, equality: int) -> bool:
        model = self._model
        return bool(model.eq_active0[equality]) and not is_disabled(model, "equality", "constraint")

    def _is_linear(self, equality: int) -> bool:
        """Of a joint equality: whether it relates two joints, by no more than a constant and a factor."""
        return int(self._model.eq_obj2id[equality]) >= 0 and not any(self._model.eq_data[equality][2:5])

    # T_1(q_1) T_2(q_2) ..., each about its own anchor, in axes of the body
    def _one_by_one(
        self, joints: range, name: str, pose: Frame, out: Description
    ) -> Iterator[JointDescription]:
        """A joint for each of the file, with a massless link behind each but the last."""
        body = int(self._model.jnt_bodyid[joints[0]])
        parent = self._name("body", int(self._model.body_parentid[body]))
        for k in joints:
            label, child = self._name("joint", k), name
            if k != joints[-1]:
                child = self._name.free("body", f"{label} link")
                self._links[child] = LinkDescription(child, between_joints=True)
            kind, motions = self._kind([int(self._model.jnt_type[k])], range(k, k + 1))
            assert kind is not None
            anchor = Frame(r=np.array(self._model.jnt_pos[k]))
            joint = JointDescription(label, kind, parent, child, pose @ anchor, anchor, motions)
            self._complete(joint, range(k, k + 1), out)
            yield joint
            parent, pose = child, Frame()
        labels = ", ".join(self._name("joint", k) for k in joints)
        text = f"its joints {labels} follow each other, with massless links between them"
        out.note("massless", f"body '{name}'", text)

    def _complete(self, joint: JointDescription, joints: range, out: Description) -> None:
        """With references, and what acts on the joint that does what these do."""
        model = self._model
        joint.reference = np.array([model.qpos0[model.jnt_qposadr[k]] for k in joints])
        if len(joints) == 1:
            self._dynamics.set(joints[0], joint)
            joint.spring_reference = float(model.qpos_spring[model.jnt_qposadr[joints[0]]])
        self._note_polynomials(joints, joint, out)
        set_limits(model, {self._name("joint", k): k for k in joints}, joint, self._stops, out.note)

    # The rates of a free joint are the velocity v of the body's origin, inertial, and its angular velocity
    # omega, in body axes. Each has the same armature a, T = a |v|^2 / 2 + a |omega|^2 / 2: that of a mass a
    # in the origin with the inertia a about all axes, which gravity does not pull.
    def _free(self, k: int, name: str, pose: Frame, out: Description) -> Iterator[JointDescription]:
        """What acts on a free body; a joint that carries nothing."""
        label = self._name("joint", k)
        joint = JointDescription(label, "free", WORLD, name, pose, closes_loop=True)
        self._dynamics.set(k, joint)
        self._note_polynomials(range(k, k + 1), joint, out)
        if joint.armature > 0:  # a negative one is refused where the joint is added
            armature, joint.armature = joint.armature, 0.0
            rotor = self._name.free("body", f"{label} rotor")
            self._links[rotor] = LinkDescription(
                rotor, armature, inertia=armature * np.eye(3), weightless=1.0
            )
            text = f"armature {armature:g} is that of the weightless body '{rotor}', fixed to its body"
            out.note("armature", f"joint '{label}'", text)
            held = self._name.free("joint", f"{rotor} fixed")
            yield JointDescription(held, "fixed", name, rotor, Frame())
        if joint.damping or joint.stiffness or joint.friction or joint.armature:
            yield joint

    def _kind(self, types: list[int], joints: range) -> tuple[str | None, list[Motion]]:
        """The kind of the one joint that does what several do, or None, and its motions."""
        model, kinds = self._model, self._mj.mjtJoint
        if types == [kinds.mjJNT_BALL]:
            return "spherical", []
        motions = [
            Motion(t == kinds.mjJNT_HINGE, np.array(model.jnt_axis[k]))
            for t, k in zip(types, joints, strict=True)
        ]
        if len(types) == 1:
            return ("revolute" if motions[0].rotation else "translational"), motions
        if kinds.mjJNT_BALL in types:
            return None, []
        turns, slides = ([m for m in motions if m.rotation == r] for r in (True, False))
        if len(types) == 2 and len(turns) == len(slides) == 1 and _parallel(turns[0].axis, slides[0].axis):
            return "cylindrical", motions
        if len(types) == len(turns) == 2 and self._meet_at_right_angles(turns, joints):
            return "universal", motions
        if len(slides) == 2 and len(turns) == 1 and motions[-1].rotation:
            axes = np.array([motion.axis for motion in motions])
            if np.abs(axes @ axes.T - np.eye(3)).max() < PARALLEL:
                return "planar", motions
        return None, []

    def _meet_at_right_angles(self, turns: list[Motion], joints: range) -> bool:
        first, second = (self._model.jnt_pos[k] for k in joints)
        across = bool(abs(turns[0].axis @ turns[1].axis) < PERPENDICULAR)
        return across and bool(np.abs(first - second).max() < SAME_POINT)

    def _note_polynomials(self, joints: range, joint: JointDescription, out: Description) -> None:
        if self._dynamics.is_bent(joints):
            text = "its spring or damping is a polynomial: only the linear part is represented"
            out.note("nonlinear", f"joint '{joint.name}'", text)

    # --- equalities, and what is not taken ---

    def _equalities(self, out: Description) -> Iterator[JointDescription]:
        model, kinds = self._model, self._mj.mjtEq
        for k in range(model.neq):
            name, type_, data = self._name("equality", k), int(model.eq_type[k]), model.eq_data[k]
            if not self._acts(k):
                why = "is not active" if not model.eq_active0[k] else "is disabled by a flag"
                out.note("equality", f"equality '{name}'", f"{why}: left out")
                continue
            if type_ == kinds.mjEQ_JOINT and self._couple(name, k, out):
                continue
            if type_ not in (kinds.mjEQ_CONNECT, kinds.mjEQ_WELD):
                out.note("equality", f"equality '{name}'", f"{self._lost(k)} is not represented")
                continue
            one, other = int(model.eq_obj1id[k]), int(model.eq_obj2id[k])
            if int(model.eq_objtype[k]) == int(self._mj.mjtObj.mjOBJ_SITE):
                bodies = int(model.site_bodyid[one]), int(model.site_bodyid[other])
                frames = self._site(one), self._site(other)
            else:
                bodies = one, other
                frames = self._anchors(type_ == kinds.mjEQ_WELD, data)
            names = [self._name("body", body) for body in bodies]
            turns = type_ == kinds.mjEQ_CONNECT or data[10] == 0  # a weld whose torquescale is zero
            kind = "spherical" if turns else "fixed"
            out.note("equality", f"equality '{name}'", f"soft in MuJoCo, a rigid {kind} joint here")
            yield JointDescription(name, kind, names[0], names[1], *frames, closes_loop=True)

    def _couple(self, name: str, k: int, out: Description) -> bool:
        """A linear relation between two joints that stand for themselves; False: it is another one."""
        model = self._model
        one, other = int(model.eq_obj1id[k]), int(model.eq_obj2id[k])
        constant, factor = model.eq_data[k][:2].tolist()
        follower, leader = (self._name("joint", joint) for joint in (one, other))
        known = {joint.name for joint in out.joints if len(joint.motions) == 1}
        if not self._is_linear(k) or not known.issuperset((follower, leader)):
            return False
        out.couplings = [*out.couplings, Coupling("equality", name, follower, leader, factor, constant)]
        if self._options.get("couple", True):
            out.note("equality", f"equality '{name}'", "soft in MuJoCo, a rigid coupler here")
        return True

    def _lost(self, k: int) -> str:
        """What an equality does that stands for no joint and no coupler."""
        model, kind = self._model, self._mj.mjtEq(int(self._model.eq_type[k]))
        if kind != self._mj.mjtEq.mjEQ_JOINT:
            return f"of kind {kind.name[5:].lower()}"
        one, other = self._name("joint", int(model.eq_obj1id[k])), int(model.eq_obj2id[k])
        if other < 0:
            return f"that it holds joint '{one}' at {model.eq_data[k][0]:g} from its reference"
        leader = self._name("joint", other)
        how = "" if self._is_linear(k) else " by more than a linear relation"
        return f"that joint '{one}' follows '{leader}'{how}"

    def _site(self, site: int) -> Frame:
        return from_quaternion(self._model.site_pos[site], self._model.site_quat[site])

    def _anchors(self, weld: bool, data: Any) -> tuple[Frame, Frame]:
        """The joint's frame in both bodies.

        eq_data is an anchor in each (connect), or (weld) an anchor in the second, the point of the first that
        it is to be in, and the second's orientation in the first.
        """
        if not weld:
            return Frame(r=np.array(data[:3])), Frame(r=np.array(data[3:6]))
        return from_quaternion(data[3:6], data[6:10]), Frame(r=np.array(data[:3]))

    def _refuse_and_note(self, out: Description) -> None:
        model = self._model
        for k in range(model.ntendon):
            name = f"tendon '{self._name('tendon', k)}'"
            if self._dynamics.pulls(k):
                text = "tendons that exert forces are not taken: remove it, or model it here"
                self._fault(name, text)
            else:
                out.note("tendon", name, tendon_limits(model, k) or "exerts no forces: is not represented")
        for k in range(getattr(model, "nflex", 0)):
            self._fault(f"flex '{self._name('flex', k)}'", "deformable bodies are not taken")
        for k in range(model.nu):
            lost = ", nor its damping and armature" if k in self._dynamics.lost_actuators else ""
            out.note("actuator", f"actuator '{self._name('actuator', k)}'", f"is not represented{lost}")
        for subject, message in self._compensation.notes(self._name):
            out.note("gravcomp", subject, message)
        self._note_contact(out)
        self._note_sleep(out)
        if model.opt.density or model.opt.viscosity or np.any(model.opt.wind):
            out.note("medium", "model", "forces of the surrounding medium are not represented")

    def _add_shapes(self, out: Description) -> None:
        if not self._options.get("shapes", True):
            out.note("visual", "model", f"{self._model.ngeom} geoms are left out, as was asked for")
            return
        for body, shapes in shapes_of(self._model, out.note).items():
            name = self._name("body", body)
            link = self._links.setdefault(name, LinkDescription(WORLD)) if body == 0 else self._links[name]
            link.shapes += shapes

    def _note_contact(self, out: Description) -> None:
        model = self._model
        if is_disabled(model, "contact", "constraint"):
            return
        geoms = int(np.count_nonzero((model.geom_contype != 0) | (model.geom_conaffinity != 0)))
        for count, what in ((geoms, "geoms"), (model.npair, "pairs of geoms")):
            if count:
                out.note("contact", "model", f"contact of {count} {what} is not represented")

    def _note_sleep(self, out: Description) -> None:
        model, policies = self._model, self._mj.mjtSleepPolicy
        for tree in range(model.ntree):
            if model.tree_sleep_policy[tree] == policies.mjSLEEP_INIT:
                name = self._name("body", int(model.tree_bodyadr[tree]))
                text = "and what it carries start asleep in MuJoCo: here they move from the start"
                out.note("sleep", f"body '{name}'", text)
        if model.opt.enableflags & int(self._mj.mjtEnableBit.mjENBL_SLEEP):
            out.note("sleep", "model", "what comes to rest falls asleep in MuJoCo: here it stays awake")

    def _fault(self, field: str, message: str) -> None:
        kind, _, name = field.partition(" ")
        line = self._lines.get(f"{'link' if kind == 'body' else kind} {name[1:-1]}", 1)
        self._faults.append(Fault(line, field, message))


def _parallel(u: Floats, w: Floats) -> bool:
    return bool(np.linalg.norm(np.cross(u, w)) < PARALLEL)
