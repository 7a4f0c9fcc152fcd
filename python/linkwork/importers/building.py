"""From links and joints to a model: rigid groups become bodies, joints get their points and axes in these."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from linkwork import rotation
from linkwork.arguments import array, check_switch, is_number, one_of
from linkwork.arrays import Floats
from linkwork.errors import Fault, LinkworkError, ModelError, ModelFileError, OptionError, nearest
from linkwork.importers.alignment import align_axes
from linkwork.importers.description import (
    WORLD,
    Coupling,
    Description,
    Imported,
    JointDescription,
)
from linkwork.importers.frames import Frame, turned
from linkwork.importers.groups import Group, check_light, grouped, moments_of, real_inertia
from linkwork.importers.names import Renamed, free, rename, spaced
from linkwork.importers.stops import Stops
from linkwork.importers.tree import LinkState, link_states, starts
from linkwork.modeling.builder import LONGEST
from linkwork.modeling.elements import KINDS
from linkwork.modeling.handles import Body
from linkwork.modeling.model import Model
from linkwork.modeling.placement import Attachment
from linkwork.modeling.shapes import Shape

__all__ = ["Options", "build", "check_options"]

#: Cosines of the angle between two axes that are perpendicular, up to the digits of a file.
PERPENDICULAR = 1e-6

#: Angles [rad] up to which one surely begins in (-pi, pi], where angles begin: less than half a turn.
WITHIN_A_TURN = 3.0

#: Angle [rad] up to which axes can be parallel or perpendicular, but not both.
MOST_ALIGNED = 0.785

#: Coulomb friction is regularized below these speeds [rad/s], [m/s].
TRANSITION = {"rotational_friction": 1e-2, "translational_friction": 1e-3}


class Options(TypedDict, total=False):
    """What import_urdf, import_sdf and import_mjcf take by name."""

    #: links that no joint carries move freely (True) or are fixed to the ground (False); None: URDF False,
    #: else as the file says
    floating: bool | None
    #: where the joints are at t = 0, by name: angle [rad] or displacement [m], several numbers for several
    #: freedoms
    coordinates: Mapping[str, Any]
    #: their rates at t = 0 [rad/s], [m/s]
    velocities: Mapping[str, Any]
    #: acceleration (3,) [m/s2]; None: of the file, or (0, 0, -9.81)
    gravity: ArrayLike | None
    #: take moving links without mass or inertia as massless bodies, which joints must hold; False: they are
    #: refused
    keep_massless: bool
    #: give links whose principal moments no real body can have the nearest that one can; False: they are
    #: refused
    repair_inertia: bool
    #: take principal moments that no real body can have as they are in the file; False: they are refused
    inertia_as_is: bool
    #: "stops": where joints with one coordinate have ends, end stops act; "note": limits are only noted
    limits: Literal["note", "stops"]
    #: links look like the visual geometry of the file; False: like the default shapes
    shapes: bool
    #: angle [rad]: axes of joints that are parallel or perpendicular to within it, at coordinates zero, are
    #: made exactly so. Files round angles (1.57), and a planar loop whose axes are not parallel is locked.
    #: None: only in closed loops, to within 2e-3; 0: as in the file; at most 0.785
    align_axes: float | None
    #: joints that follow others (mimic, gearboxes, joint equalities) do so by couplers; False: they are free
    couple: bool
    #: make one body of links that are fixed to each other; False: only where one of them is massless
    merge_fixed: bool


#: Options that are yes or no.
SWITCHES = ("keep_massless", "repair_inertia", "inertia_as_is", "shapes", "couple", "merge_fixed")


def check_options(options: Options) -> None:
    """OptionError: no such option, a value that it cannot have, or two that contradict each other."""
    for name in options:
        if name not in Options.__annotations__:
            hint = nearest(name, Options.__annotations__)
            raise OptionError(f"an import has no option '{name}'{hint}", code="unknown_option")
    for name in SWITCHES:
        check_switch(name, options.get(name, False))
    if not isinstance(floating := options.get("floating"), bool | None):
        raise OptionError(f"floating {floating!r:.60} is not True, False or None", code="floating")
    one_of(options.get("limits", "note"), ("note", "stops"), "limits")
    for name in ("coordinates", "velocities"):
        _check_values(name, options.get(name))
    if (angle := options.get("align_axes")) is not None and (
        not is_number(angle) or not 0 <= angle <= MOST_ALIGNED
    ):
        text = f"align_axes {angle!r:.60} is no angle from 0 to {MOST_ALIGNED:g} rad, nor None"
        raise OptionError(text, code="align_axes")
    if options.get("repair_inertia") and options.get("inertia_as_is"):
        raise OptionError(
            "repair_inertia changes inertias, inertia_as_is takes those of the file: give one of them",
            code="contradiction",
        )


def _check_values(option: str, given: object) -> None:
    """OptionError: not of joints by name, or not made of numbers."""
    if given is not None and not isinstance(given, Mapping):
        text = f"{option} {given!r:.60} is no mapping: give the values of joints by name, {{'elbow': 0.3}}"
        raise OptionError(text, code=option)
    for name, value in (given or {}).items():
        array(value, f"{option}[{name!r:.60}]")
        if np.asarray(value).dtype.kind in "USb":  # texts and truths, which NumPy makes numbers of
            raise OptionError(f"{option}[{name!r:.60}] {value!r:.60} is no number", code="not_a_number")


def _by_names_here(names: Renamed, given: Mapping[str, Any] | None, what: str) -> dict[str, Any]:
    """By the names that joints have in the model. ModelError: one is given by both of its names."""
    given = given or {}
    found = {names.joints.get(name, name): value for name, value in given.items()}
    if len(found) < len(given):
        twice = next(name for name, here in names.joints.items() if {name, here} <= given.keys())
        raise ModelError(
            f"{what}: joint {twice!r} is given twice, as '{names.joints[twice]}', too: give it once",
            code=what,
        )
    return found


@np.errstate(over="ignore", invalid="ignore")  # bodies and joints refuse what is not finite
def build(description: Description, options: Options, lines: Mapping[str, int] | None = None) -> Imported:
    """The model of a description. `lines`: where each link is in the file.

    ModelFileError: a moving link without inertia, what no body or joint can be. ModelError: coordinates.
    """
    names = rename(description)
    lines = names.lines(lines or {})
    floating = options.get("floating")
    if floating is not None:
        description.grounded = () if floating else description.links
    align_axes(description, options.get("align_axes"))
    coordinates = _by_names_here(names, options.get("coordinates"), "coordinates")
    velocities = _by_names_here(names, options.get("velocities"), "velocities")
    states = link_states(description, coordinates, velocities)
    groups = grouped(description, states, options.get("merge_fixed", False))
    faults: list[Fault] = []
    check_light(description, groups, options.get("keep_massless", False), lines, faults)
    gravity = options.get("gravity")
    model = Model(description.gravity if gravity is None else gravity, _model_name(description))
    at_start = starts(description, coordinates, states, options.get("couple", True))
    builder = _Builder(description, model, states, groups, at_start, options)
    for group in builder.moving:
        _collect(faults, lines, "link", group.main, partial(builder.add_body, group))
    for joint in description.joints if not faults else ():
        _collect(faults, lines, "joint", joint.name, partial(builder.add_joint, joint))
    for coupling in description.couplings if not faults else ():
        if options.get("couple", True):
            add = partial(builder.add_coupling, coupling)
            _collect(faults, lines, "joint", coupling.follower, add)
        else:
            builder.note_coupling(coupling, "it moves freely")
    if faults:
        raise ModelFileError(description.path, faults)
    builder.add_shapes()
    return Imported(description.path, model, tuple(description.notes))


def _model_name(description: Description) -> str:
    """Of the description, as a model can have it: nothing is found by it, it need not be the file's."""
    name = "".join(c for c in spaced(description.name) if c.isprintable())[:LONGEST]
    if name != description.name:
        text = f"its name {description.name!r:.80} is {name!r:.80} here: to be printed, and not too long"
        description.note("name", "model", text)
    return name


def _collect(
    faults: list[Fault], lines: Mapping[str, int], kind: str, name: str, add: Callable[[], None]
) -> None:
    """Call, and take a refusal for a fault of the file."""
    try:
        add()
    except LinkworkError as error:
        reason = error.reason
        if error.code in ("inertia_triangle", "inertia_negative"):
            reason += "; repair_inertia takes the nearest that is possible"
        if error.code == "inertia_triangle":
            reason += ", inertia_as_is this one"
        faults.append(Fault(lines.get(f"{kind} {name}", 1), f"{kind} '{name}'", reason))


def _check_dissipation(joint: JointDescription) -> None:
    """ModelError: a joint, of whatever kind, that would drive itself."""
    for what in ("damping", "friction", "armature"):
        value = getattr(joint, what)
        if value < 0:
            raise ModelError(f"{what} = {value:g} must not be negative", code="negative")


# --- bodies and joints --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Side:
    """A joint's frame on one of its bodies, in body coordinates."""

    body: Body
    frame: Frame

    @property
    def at(self) -> Floats:
        return self.frame.r

    def axis(self, axis: Floats) -> Floats:
        turned: Floats = self.frame.A @ axis
        return turned


class _Builder:
    def __init__(
        self,
        description: Description,
        model: Model,
        states: Mapping[str, LinkState],
        groups: Mapping[str, Group],
        starts: Mapping[str, Floats],
        options: Options,
    ) -> None:
        self._description, self._model, self._starts = description, model, starts
        self._references = {joint.name: float(joint.reference[0]) for joint in description.joints}
        self._stops = Stops(description, model, self._body_of)
        self._repair_inertia = options.get("repair_inertia", False)
        self._inertia_as_is = options.get("inertia_as_is", False)
        self._states, self._groups = states, groups
        self._bodies: dict[str, Body] = {WORLD: model.ground}
        self._coordinates: dict[str, str] = {}  #: of each joint in the model that has one
        self.moving = [groups[name] for name in description.links if groups[name].main == name]
        self.moving = [group for group in self.moving if group is not groups[WORLD]]

    def add_body(self, group: Group) -> None:
        state = self._states[group.main]
        position = state.frame.point(group.center)
        J = group.inertia / 2 + group.inertia.T / 2
        real, moments = real_inertia(J)
        if moments is not None and (self._repair_inertia or self._inertia_as_is):
            what = f"made {moments_of(real)}" if self._repair_inertia else "taken as they are"
            text = f"principal moments {moments} kg m2 are those of no real body: {what}"
            self._description.note("inertia", f"link '{group.main}'", text)
            J = real if self._repair_inertia else J
        self._bodies[group.main] = self._model.body(
            self._body_name(group.main),
            mass=group.mass,
            inertia=J,
            position=position,
            orientation=rotation.from_matrix(state.frame.A),
            velocity=state.velocity_of(position),
            omega=state.frame.A.T @ state.omega,
            inertia_as_is=self._inertia_as_is and moments is not None,
        )
        for link in group.links:
            self._lift(link, group)

    def _body_name(self, link: str) -> str:
        """Of the link, but for the name that only the ground has."""
        ground = self._model.ground.name
        if link != ground:
            return link
        name = free(link, self._description.links.__contains__)
        text = f"is called '{name}' here: '{ground}' is the name of the ground"
        self._description.note("name", f"link '{link}'", text)
        return name

    def add_shapes(self) -> None:
        """What links look like, on the bodies that they are part of, and on the ground."""
        found: dict[str, list[Shape]] = {}
        for name, group in self._groups.items():
            found.setdefault(group.main, []).extend(self._shapes_of(name))
        for main, shapes in found.items():
            if shapes:
                self._model.shape(self._bodies[main], *shapes)

    def _shapes_of(self, name: str) -> Iterator[Shape]:
        """In body coordinates."""
        link = self._description.links.get(name)
        if link is not None and link.shapes:
            frame = self._side(name, Frame()).frame
            yield from (shape.moved(frame.r, frame.A) for shape in link.shapes)

    # -c m g in the link's center of mass
    def _lift(self, name: str, group: Group) -> None:
        """Take from a link the share of its weight that its file takes from it."""
        link = self._description.links[name]
        force = -link.weightless * link.mass * np.asarray(self._model.compiled().gravity)
        if force.any():
            at = self._side(name, Frame(r=link.center)).at
            lift = self._model.force(
                self._bodies[group.main], force=force.tolist(), at=at, name=f"{name} lift"
            )
            text = f"force '{lift.name}' takes {link.weightless:g} of its weight and does work"
            text += ": the weight stays in the potential energy"
            self._description.note("gravity", f"link '{name}'", text)

    def add_joint(self, joint: JointDescription) -> None:
        in_parent, in_child = joint.at_zero()
        a, b = self._side(joint.parent, in_parent), self._side(joint.child, in_child)
        if a.body == b.body:
            if joint.parent == joint.child:
                self._note("rigid", joint, "joins a link with itself: it is left out")
            elif joint.kind != "fixed":
                self._note("rigid", joint, "joins links of one rigid group: it cannot move")
            return
        _check_dissipation(joint)
        if joint.kind == "free":
            self._add_isotropic(joint, a, b)
            return
        place = {"at": (a.at, b.at), "frames": "body", "name": joint.name}
        getattr(self, f"_add_{joint.kind}")(joint, a, b, place)
        self._note_turns(joint)
        if len(joint.motions) == 1:
            self._coordinates[joint.name] = "angle" if joint.motions[0].rotation else "displacement"
        self._add_forces(joint, a, b)

    def add_coupling(self, coupling: Coupling) -> None:
        """follower - multiplier leader = offset"""
        for name in (coupling.follower, coupling.leader):
            if name not in self._coordinates:
                self.note_coupling(coupling, f"'{name}' has no coordinate of its own")
                return
        terms = [(coupling.follower, 1.0), (coupling.leader, -coupling.multiplier)]
        given = [(name, self._coordinates[name], factor) for name, factor in terms if factor]
        offset = coupling.offset + sum(factor * self._references[name] for name, factor in terms)
        self._model.coupler(given, offset=offset, name=self._coupler_name(coupling))

    def _coupler_name(self, coupling: Coupling) -> str:
        """That of the file, or, where a joint has it, with the kind behind it, or with a number."""

        def is_taken(name: str) -> bool:
            return self._model.compiled().find_joint(name) >= 0

        if not is_taken(coupling.name):
            return coupling.name
        return free(f"{coupling.name} {coupling.kind}", is_taken)

    def note_coupling(self, coupling: Coupling, reason: str) -> None:
        text = f"that it follows {coupling} is not represented: {reason}"
        self._description.note(coupling.kind, f"joint '{coupling.follower}'", text)

    def _side(self, link: str, frame: Frame) -> _Side:
        group = self._groups[link]
        step = self._states[group.main].frame.inverse @ self._states[link].frame
        in_main = step @ frame
        return _Side(self._bodies[group.main], Frame(in_main.r - group.center, in_main.A))

    def _axis_place(self, joint: JointDescription, a: _Side, b: _Side) -> dict[str, Any]:
        axis = joint.motions[0].axis
        x = rotation.perpendicular(axis)
        return {"axis": (a.axis(axis), b.axis(axis)), "x_axis": (a.axis(x), b.axis(x))}

    def _start(self, joint: JointDescription) -> Floats:
        """Its coordinates at t = 0."""
        return self._starts[joint.name]

    def _note_turns(self, joint: JointDescription) -> None:
        for motion, start in zip(joint.motions, self._start(joint).tolist(), strict=True):
            turns = np.ceil(start / (2 * np.pi) - 0.5)
            if motion.rotation and abs(start) > np.pi and turns:
                text = f"turned by {start:.6g} rad at the start: its angle in results begins within a turn"
                within = np.arctan2(np.sin(start), np.cos(start))  # start - 2 pi turns would lose digits
                self._note("coordinates", joint, f"{text}, at {within:.6g} rad")

    # The angle of a force begins in (-pi, pi]. Where that of a joint begins near half a turn or beyond, the
    # force counts from there: x_b is turned back by the start, theta = q - q(0).
    def _acting_place(self, joint: JointDescription, a: _Side, b: _Side) -> tuple[dict[str, Any], float]:
        """Of what acts about or along the axis, and the joint's coordinate where its own is zero."""
        place = {"at": (a.at, b.at), "frames": "body", **self._axis_place(joint, a, b)}
        start = float(self._start(joint)[0])
        if joint.kind != "revolute" or abs(start) < WITHIN_A_TURN:
            return place, 0.0
        axis = joint.motions[0].axis
        x = rotation.perpendicular(axis)
        place["x_axis"] = (a.axis(x), b.axis(turned(axis, -start).A @ x))
        return place, start

    def _add_about_axis(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        getattr(self._model, joint.kind)(a.body, b.body, **self._axis_place(joint, a, b), **place)

    _add_revolute = _add_translational = _add_about_axis

    def _add_cylindrical(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        self._add_about_axis(joint, a, b, place)
        first, second = joint.motions
        if first.axis @ second.axis < 0:
            which = "angle" if second.rotation else "displacement"
            text = f"its two axes are opposite: its {which} in results has the other sign than in the file"
            self._note("coordinates", joint, text)

    def _add_planar(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        normal, x = joint.motions[-1].axis, joint.motions[0].axis
        place |= {"axis": (a.axis(normal), b.axis(normal)), "x_axis": (a.axis(x), b.axis(x))}
        self._model.planar(a.body, b.body, **place)

    def _add_screw(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        self._model.screw(a.body, b.body, pitch=joint.pitch, **self._axis_place(joint, a, b), **place)

    # Model.universal counts angles from the initial pose; in frames with x = z_a x z_b they are the file's.
    def _add_universal(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        first, second = (motion.axis for motion in joint.motions)
        x = np.cross(first, second) / np.linalg.norm(np.cross(first, second))
        frames = [np.column_stack([x, np.cross(z, x), z]) for z in (first, second)]
        frame = np.array([[side.frame.A @ F for side, F in zip((a, b), frames, strict=True)]])
        where = Attachment(np.array([[a.at, b.at]]), frame, np.zeros(1))
        self._model._add_attached("universal", a.body, b.body, joint.name, where)

    def _add_spherical(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        self._model.spherical(a.body, b.body, **place)

    def _add_fixed(self, joint: JointDescription, a: _Side, b: _Side, place: dict[str, Any]) -> None:
        orientation = tuple(rotation.from_matrix(side.frame.A) for side in (a, b))
        self._model.fixed(a.body, b.body, orientation=orientation, **place)

    # --- what acts at a joint ---

    def _add_forces(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        if joint.armature and joint.name in self._coordinates:
            self._add_rotor(joint, a, b)
        elif joint.armature:
            self._note("armature", joint, f"rotor inertia {joint.armature:g} is not represented")
        if joint.kind == "spherical":
            self._add_isotropic(joint, a, b)
            return
        if joint.kind not in ("revolute", "translational"):
            if joint.damping or joint.friction or joint.stiffness:
                self._note(
                    "damping",
                    joint,
                    f"damping, friction or spring of a {joint.kind} joint is not represented",
                )
            return
        self._add_friction(joint, a, b)
        if joint.stops:
            self._add_stop(joint, a, b)
        if joint.stiffness:
            add = self._add_rotational_spring if joint.kind == "revolute" else self._add_spring
            add(joint, a, b)

    def _add_rotor(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        """Inertia seen at a joint, armature x_dot^2 / 2."""
        which = self._coordinates[joint.name]
        add = self._model.rotational_inerter if which == "angle" else self._model.translational_inerter
        place = {"at": (a.at, b.at), "frames": "body", **self._axis_place(joint, a, b)}
        add(a.body, b.body, **place, inertance=joint.armature, name=f"{joint.name} rotor")

    def _add_isotropic(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        """Spring and damping, the same in all directions and about all axes that the joint leaves free."""
        shift = float(joint.kind == "free")  # a spherical joint only turns
        if joint.stiffness:
            frames = tuple(rotation.from_matrix(side.frame.A) for side in (a, b))
            self._model.bushing(
                a.body, b.body, at=(a.at, b.at), frames="body", orientation=frames,
                stiffness=[shift * joint.stiffness] * 3, rotational_stiffness=[joint.stiffness] * 3,
                name=f"{joint.name} spring",
            )  # fmt: skip
        if joint.damping:
            self._model.linear_damping(
                a.body, b.body, at=(a.at, b.at), frames="body", damping=shift * joint.damping,
                rotational_damping=joint.damping, name=f"{joint.name} damping",
            )  # fmt: skip
        if joint.friction:
            text = f"friction {joint.friction:g} of a {joint.kind} joint is not represented"
            self._note("friction", joint, text)

    def _add_friction(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        kind = "rotational_friction" if joint.kind == "revolute" else "translational_friction"
        if not joint.damping and not joint.friction:
            return
        if kind not in KINDS["force"] or not hasattr(self._model, kind):
            self._note(
                "damping",
                joint,
                f"damping {joint.damping:g}, friction {joint.friction:g} are not represented",
            )
            return
        add = getattr(self._model, kind)
        place = {"at": (a.at, b.at), "frames": "body", **self._axis_place(joint, a, b)}
        values = {"viscous": joint.damping, "coulomb": joint.friction, "transition": TRANSITION[kind]}
        add(a.body, b.body, **place, **values, name=f"{joint.name} friction")
        if joint.friction:
            unit = "rad/s" if joint.kind == "revolute" else "m/s"
            text = f"friction {joint.friction:g} is regularized below {TRANSITION[kind]:g} {unit}"
            self._note("friction", joint, text)

    def _add_stop(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        place, zero = self._acting_place(joint, a, b)
        self._stops.add(joint, (a.body, b.body), place, float(self._start(joint)[0]), zero)

    def _body_of(self, link: str) -> Body | None:
        """None: it is part of the ground."""
        main = self._groups[link].main
        return None if main == WORLD else self._bodies[main]

    def _add_rotational_spring(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        place, zero = self._acting_place(joint, a, b)
        self._model.rotational_spring_damper(
            a.body,
            b.body,
            **place,
            stiffness=joint.stiffness,
            free_angle=joint.spring_reference - zero,
            name=f"{joint.name} spring",
        )

    def _add_spring(self, joint: JointDescription, a: _Side, b: _Side) -> None:
        self._model.translational_spring_damper(
            a.body,
            b.body,
            at=(a.at, b.at),
            frames="body",
            **self._axis_place(joint, a, b),
            stiffness=joint.stiffness,
            free_displacement=joint.spring_reference,
            name=f"{joint.name} spring",
        )

    def _note(self, topic: str, joint: JointDescription, message: str) -> None:
        self._description.note(topic, f"joint '{joint.name}'", message)
