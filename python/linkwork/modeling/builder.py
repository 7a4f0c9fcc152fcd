"""How a mechanism is described: bodies, joints, forces. It is checked while it is written."""

from __future__ import annotations

import inspect
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core, arguments, functions
from linkwork.arrays import Floats, Indices, Number, VectorLike, read_only
from linkwork.errors import ModelError, about, nearest
from linkwork.functions import Sum, TimeFunction, TimeFunctionLike, as_time_function
from linkwork.functions.calls import Calls
from linkwork.functions.compiled_law import CompiledLaw
from linkwork.modeling.bodies import Bodies
from linkwork.modeling.coordinates import JointCoordinate, coordinate_of, coordinates_of
from linkwork.modeling.elements import (
    KINDS,
    Elements,
    Role,
    check_known,
    in_components,
    kind_info,
    placed,
    with_parameters,
)
from linkwork.modeling.handles import BodiesLike, Body, BodyLike, Force, Joint, Range
from linkwork.modeling.methods import ForceMethods, JointMethods
from linkwork.modeling.placement import Attachment, Frames, Subject
from linkwork.modeling.shapes import Shape, Shapes, ShapesLike
from linkwork.modeling.special import CouplerData, CurveData, SpecialJointMethods
from linkwork.modeling.user_forces import UserForce, UserForceMethods

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

__all__ = ["ModelBuilder"]


#: Kinds of force elements that act on b alone; a has the axes of the components, or the medium.
ON_B = ("applied", "drag")

#: Of names [characters]: with the number of one in a group they have no more than files take.
LONGEST = 980


class ModelBuilder(JointMethods, SpecialJointMethods, ForceMethods, UserForceMethods):
    """What models are built by: a method for whatever can be added, and what was added so far."""

    @property
    def name(self) -> str:
        """Printable text. ModelError, when it is given: it is none."""
        return self._name

    @name.setter
    def name(self, name: str) -> None:
        _check_name(name, "model")
        self._name = name

    def __init__(self, gravity: VectorLike = (0.0, 0.0, -9.81), name: str = "") -> None:
        """`gravity`: acceleration (3,), inertial [m/s2]. ModelError: not three finite numbers."""
        self.name = name
        self._core = _core.Model(arguments.shaped(gravity, [(3,)], "model", "gravity"))
        self._bodies = Bodies(cast("Model", self), self._core)
        self._counts: Counter[str] = Counter()
        self._signals: list[tuple[str, TimeFunction]] = []
        self._drivers: list[tuple[str, TimeFunction]] = []
        #: Those of the signals on which the energy stored in force elements depends.
        self._storing: list[tuple[str, TimeFunction]] = []
        self._characteristics: list[tuple[str, TimeFunction]] = []
        self._user_forces: list[UserForce] = []
        self._shapes = Shapes()
        self._functions: dict[int, TimeFunction] = {}  # by index in the compiled model
        self._special: dict[int, CouplerData | CurveData] = {}  # by joint

    def __setattr__(self, name: str, value: Any) -> None:
        """AttributeError: not of its own, or the name."""
        if name != "name" and not name.startswith("_"):
            raise AttributeError(
                f"model: '{name}' cannot be set. What a model holds is given as it is made, as in "
                "Model(gravity=...); `replaced` gives a model with other values of an object, `with_gravity` "
                "one elsewhere"
            )
        super().__setattr__(name, value)

    @property
    def gravity(self) -> Floats:
        """Acceleration (3,), inertial [m/s2]; `Model.with_gravity` changes it."""
        return read_only(np.array(self._core.gravity))

    @property
    def ground(self) -> Body:
        """The inertial frame, at rest; it is joined like a body."""
        return self._bodies.ground

    # --- bodies ---------------------------------------------------------------------------------------------

    def body(
        self,
        name: str | None = None,
        *,
        mass: Number,
        inertia: VectorLike,
        position: VectorLike = (0.0, 0.0, 0.0),
        orientation: VectorLike = (1.0, 0.0, 0.0, 0.0),
        velocity: VectorLike = (0.0, 0.0, 0.0),
        omega: VectorLike = (0.0, 0.0, 0.0),
        shape: ShapesLike = (),
        inertia_as_is: bool = False,
    ) -> Body:
        """Add a rigid body as it is at t = 0.

            arm = model.body("arm", mass=2.0, inertia=(0.01, 0.2, 0.2), position=(0.5, 0, 0))

        mass         [kg], zero for a massless body
        inertia      about the center of mass, body axes [kg m2]: (3,) principal moments or (3, 3)
        position     of the center of mass (3,), inertial [m]
        orientation  unit Euler parameters (4,), scalar first, body axes to inertial: see linkwork.rotation
        velocity     of the center of mass (3,), inertial [m/s]
        omega        angular velocity (3,), body axes [rad/s]
        shape        what it looks like: one or several Box, Cylinder, ...; without, as its joints suggest
        inertia_as_is  take principal moments that no real body has, the largest above the sum of the others,
                     as files of robots state them; refused otherwise

        ModelError: a value that no body can have, or a name that is taken.
        """
        name = self._named(name, "body", self.body_count)
        who = f"body '{name}'"
        m = arguments.shaped(mass, [()], who, "mass")
        J = arguments.shaped(inertia, [(3,), (3, 3)], who, "inertia")
        vectors = {"position": position, "velocity": velocity, "omega": omega}
        state = {what: arguments.shaped(x, [(3,)], who, what)[None] for what, x in vectors.items()}
        state["orientation"] = arguments.shaped(orientation, [(4,)], who, "orientation")[None]
        shapes = self._shapes.checked(shape)
        tensor = (np.diag(J) if J.ndim == 1 else J)[None]
        if not isinstance(inertia_as_is, bool):
            message = f"{who}: inertia_as_is {inertia_as_is!r:.80} is not True or False"
            raise ModelError(message, code="inertia_as_is", subject=who, field="inertia_as_is")
        body = self._bodies.add([name], m[None], tensor, [inertia_as_is], **state)[0]
        self._shapes.set(range(body.index, body.index + 1), shapes)
        return body

    def bodies(
        self,
        name: str | Sequence[str],
        *,
        mass: ArrayLike,
        inertia: VectorLike,
        position: VectorLike,
        orientation: VectorLike = (1.0, 0.0, 0.0, 0.0),
        velocity: VectorLike = (0.0, 0.0, 0.0),
        omega: VectorLike = (0.0, 0.0, 0.0),
        shape: ShapesLike = (),
    ) -> Range[Body]:
        """Add k bodies at once, named name[0], name[1], ..., or by k names; linear in time and memory.

            places = [(x, 0, 1) for x in range(100)]
            row = model.bodies("link", mass=1.0, inertia=(0.01, 0.1, 0.1), position=places)

        All are added, or none. As `body`, with `position` (k, 3), and each other quantity the same for all or
        with a leading k; `shape` is the same for all.
        `inertia`: (3,) or (k, 3) principal moments, or (k, 3, 3); one tensor for all is (1, 3, 3).
        """
        who = f"bodies '{name}'" if isinstance(name, str) else "bodies"
        r = arguments.shaped(position, [(None, 3)], who, "position")
        k = len(r)
        alike = isinstance(name, str)
        names: str | list[str] = self._named(name, "bodies", 0) if alike else _names_of_all(who, name, k)
        m = arguments.shaped(mass, [(), (k,)], who, "mass")
        J = arguments.shaped(inertia, [(3,), (k, 3), (1, 3, 3), (k, 3, 3)], who, "inertia")
        J = J if J.ndim == 3 else J[..., None] * np.eye(3)
        vectors = {"velocity": velocity, "omega": omega}
        state = {what: arguments.shaped(x, [(3,), (k, 3)], who, what) for what, x in vectors.items()}
        state |= {
            "orientation": arguments.shaped(orientation, [(4,), (k, 4)], who, "orientation"),
            "position": r,
        }
        full = {what: np.broadcast_to(x, (k, x.shape[-1])) for what, x in state.items()}
        shapes, first = self._shapes.checked(shape), self.body_count
        bodies = self._bodies.add(names, np.broadcast_to(m, (k,)), np.broadcast_to(J, (k, 3, 3)), (), **full)
        self._shapes.set(range(first, first + k), shapes)
        return bodies

    def shape(self, bodies: BodiesLike, *shapes: Shape) -> None:
        """Draw one or many bodies, or the ground, by these shapes; they have no influence on the motion.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.shape(body, lw.Box((0.4, 0.1, 0.1), color="#3366cc"), lw.Sphere(0.08))

        ModelError: no such body, or what is no Shape.
        """
        self._shapes.set(self.indices(bodies), self._shapes.checked(shapes))

    # --- joints ---------------------------------------------------------------------------------------------

    def joints(
        self,
        kind: str,
        a: BodiesLike,
        b: BodiesLike,
        *,
        name: str | Sequence[str] | None = None,
        frames: Frames = "space",
        **arguments: Any,
    ) -> Range[Joint]:
        """Add k joints of one kind at once, named name[0], name[1], ..., or by k names.

            row = model.bodies("link", mass=1.0, inertia=(0.01, 0.1, 0.1), position=np.diag((0.0, 1.0, 2.0)))
            model.joints("spherical", row[:-1], row[1:], at=[(0, 0.5, 0), (0, 1, 1)], name="ball")

        Linear in time and memory; all are added, or none.

        a, b       bodies; one of them may be single
        arguments  those of the kind's own method, each the same for all or with a leading k; pairs stay
                   pairs, of (3,) or (k, 3)
        """
        first = self.joint_count
        self._place("joint", kind, a, b, frames, name, True, arguments)
        return Range(range(first, self.joint_count), self._joint)

    def _add_joint(
        self,
        kind: str,
        a: BodyLike,
        b: BodyLike,
        frames: Frames,
        name: str | None,
        arguments: Mapping[str, Any],
    ) -> Joint:
        """What every generated joint method does."""
        self._place("joint", kind, a, b, frames, name, False, arguments)
        return self._joint(self.joint_count - 1)

    def _add_attached(self, kind: str, a: BodyLike, b: BodyLike, name: str, place: Attachment) -> None:
        """A joint without parameters, at points and axes in its bodies."""
        subject = Subject(kind, self._named(name, kind, 0), False, 1)
        bodies = self._bodies.pair(a, b, subject)
        self._add(with_parameters(kind_info("joint", kind), subject, bodies, place, {}))

    def drive(
        self,
        joint: Joint | str,
        *,
        position: TimeFunctionLike = None,
        velocity: TimeFunctionLike = None,
        acceleration: TimeFunctionLike = None,
        coordinate: str | None = None,
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> Joint:
        """Prescribe a free coordinate of a joint over time, by its position, velocity or acceleration.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
            model.drive("pin", velocity=lw.functions.polynomial(0.0, 4.0))   # begins at rest, 4 rad/s2

        position      the coordinate as `Result.coordinate` gives it [rad or m]
        velocity      its rate; the position is its integral from the initial pose on
        acceleration  likewise, from the initial pose and velocity on
        coordinate    "angle" or "displacement"; not needed where the joint has only one
        breaks        times [s] at which a Python function is not smooth, see functions.with_breaks

        A position may not jump. Where a velocity jumps the bodies are struck, by impulses in the joints
        alone, in runs with steps that follow tolerances.

        The driver is a joint of its own, `angle_driver` or `displacement_driver`: its reaction drives.
        ModelError: no such joint or coordinate; no motion or several; one without derivatives or integral.
        """
        index, text = self._joint_named(joint, "drive")
        which = coordinate_of(self._core.joint_kind(index), text, coordinate)
        if f"{which}_driver" not in KINDS["joint"]:
            raise ModelError(f"drive: {which} of '{text}' has no driver", code="coordinate")
        named = {"position": position, "velocity": velocity, "acceleration": acceleration}
        motions = [(what, motion) for what, motion in named.items() if motion is not None]
        if len(motions) != 1:
            raise ModelError(
                f"drive '{text}': give one of position, velocity, acceleration",
                code="drive",
                subject=f"drive '{text}'",
            )
        arrays = self._core.joint_arrays()
        place = Attachment(arrays["origin"][[index]], arrays["frame"][[index]], np.zeros(1))
        bodies = arrays["bodies"][[index]]
        kind = f"{which}_driver"
        subject = Subject(kind, self._named(name, kind, self._counts[kind]), False, 1)
        what, motion = motions[0]
        motion = functions.broken({what: motion}, breaks, subject.who(0))[what]
        function = _motion(what, motion, self._initial_coordinate(which, bodies[0], place), subject.who(0))
        self._add(with_parameters(kind_info("joint", kind), subject, bodies, place, {which: function}))
        return self._joint(self.joint_count - 1)

    def _initial_coordinate(
        self, which: str, bodies: NDArray[np.int32], place: Attachment
    ) -> JointCoordinate:
        q, v = self._core.poses(bodies), np.zeros((2, 6))
        v[bodies >= 0] = self._core.v0.reshape(-1, 6)[bodies[bodies >= 0]]
        ends = [(q[[end]], v[[end]]) for end in (0, 1)]
        return coordinates_of(which, np.zeros(1), ends, place.origin[0], place.frame[0])

    # --- forces ---------------------------------------------------------------------------------------------

    def _add_force(
        self,
        kind: str,
        a: BodyLike,
        b: BodyLike,
        frames: Frames,
        name: str | None,
        arguments: Mapping[str, Any],
    ) -> Force:
        """What every method of a force element does."""
        self._place("force", kind, a, b, frames, name, False, arguments)
        return self._force(self.force_count - 1, kind)

    def force(
        self,
        body: BodyLike,
        *,
        force: Sequence[TimeFunctionLike] = (0.0, 0.0, 0.0),
        torque: Sequence[TimeFunctionLike] = (0.0, 0.0, 0.0),
        at: VectorLike | None = None,
        frame: Literal["inertial", "body"] = "inertial",
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> Force:
        """Apply a force [N] and a torque [N m] to a body; components are numbers or functions of time.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.force(body, force=(0, lw.functions.harmonic(5.0, 2.0), 0), at=(0.1, 0, 0))

        at     the point of application (3,) in body coordinates [m]; without it the center of mass
        frame  axes of the components: "inertial", or "body" that turn with the body
        breaks times [s] at which Python functions are not smooth, see functions.with_breaks

        ModelError: the ground, which nothing moves.
        """
        given = {"force": force, "torque": torque, "at": at, "frame": frame, "breaks": breaks}
        self._apply("ground", body, name, False, given)
        return self._force(self.force_count - 1, "applied")

    def spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        stiffness: TimeFunctionLike = 0.0,
        damping: TimeFunctionLike = 0.0,
        free_length: TimeFunctionLike = None,
        force: TimeFunctionLike = 0.0,
        frames: Frames = "space",
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> Force:
        """Join two points by spring, damper and actuator: they pull with k (l - l_0) + c l_dot + f.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.spring_damper("ground", body, at=((0, 0, 0), (1, 0, 0)), stiffness=1e3, damping=10.0)

        at           a point of a and a point of b [m], in space at the initial pose; body coordinates with
                     frames="body"
        stiffness    k [N/m]
        damping      c [N s/m]
        free_length  l_0 [m]; without it the initial length
        force        f [N], positive pulls the points together

        breaks: times [s] at which Python functions are not smooth, see functions.with_breaks.
        Quantities are numbers or functions of time.
        """
        own = {"stiffness": stiffness, "damping": damping, "free_length": free_length, "force": force}
        return self._add_force("spring_damper", a, b, frames, name, {"at": at, **own, "breaks": breaks})

    def rotational_spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axis: VectorLike,
        at: VectorLike | None = None,
        x_axis: VectorLike | None = None,
        stiffness: TimeFunctionLike = 0.0,
        damping: TimeFunctionLike = 0.0,
        free_angle: TimeFunctionLike = 0.0,
        torque: TimeFunctionLike = 0.0,
        frames: Frames = "space",
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> Force:
        """Join bodies by rotational spring, damper, motor: -k (theta - theta_0) - c theta_dot + n acts on b.

        theta is the angle of b against a about the axis [rad], zero at the initial pose, over full turns.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
            model.rotational_spring_damper("ground", body, axis=(0, 0, 1), stiffness=50.0, damping=0.5)

        axis        direction in space at the initial pose, usually that of a revolute joint; with
                    frames="body" a pair
        at          a point of the axis; it does not matter for the motion
        x_axis      where theta is measured from, a pair with frames="body"; without it the initial pose
        stiffness   k [N m/rad]
        damping     c [N m s/rad]
        free_angle  theta_0 [rad]
        torque      n [N m], positive turns b about +axis

        breaks: times [s] at which Python functions are not smooth, see functions.with_breaks.
        Quantities are numbers or functions of time.
        """
        place = {"at": _on_any_axis(frames) if at is None else at, "axis": axis, "x_axis": x_axis}
        own = {"stiffness": stiffness, "damping": damping, "free_angle": free_angle, "torque": torque}
        return self._add_force(
            "rotational_spring_damper", a, b, frames, name, {**place, **own, "breaks": breaks}
        )

    def _joint_named(self, joint: Joint | str, who: str) -> tuple[int, str]:
        text = joint.name if isinstance(joint, Joint) else joint
        index = self._core.find_joint(text) if arguments.is_text(text) else -1
        if isinstance(joint, Joint) and index >= 0 and self._joint(index) != joint:
            raise ModelError(f"{who}: joint '{text}' belongs to another model", code="unknown_joint")
        if index < 0:
            known = [self._core.joint_name(k) for k in range(min(self.joint_count, 10_000))]
            raise ModelError(
                f"{who}: no joint named {text!r}{nearest(str(text), known)}", code="unknown_name"
            )
        return index, text

    def bushing(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        orientation: VectorLike | None = None,
        stiffness: Sequence[TimeFunctionLike] = (0.0, 0.0, 0.0),
        rotational_stiffness: Sequence[TimeFunctionLike] = (0.0, 0.0, 0.0),
        damping: Sequence[TimeFunctionLike] = (0.0, 0.0, 0.0),
        rotational_damping: Sequence[TimeFunctionLike] = (0.0, 0.0, 0.0),
        frames: Frames = "space",
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> Force:
        """Join frames of a and b elastically: springs and dampers along and about three axes.

        The force on b's point is -k u - c u_dot along a's axes, u its shift in a's frame [m]. Turns follow
        the rotation vector phi of b's frame against a's [rad], below half a turn: the torque on b, in a's
        axes, is

            -J (K phi + C phi_dot),  J = I + phi~/2 + (1/a^2 - (1 + cos a) / (2 a sin a)) phi~^2,  a = |phi|

        so that its power is that of the potential phi^T K phi / 2 and of the loss phi_dot^T C phi_dot; for
        small angles J is I.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.bushing("ground", body, at=(1, 0, 0), stiffness=(1e5, 1e5, 2e4), damping=(50.0, 50.0, 9.0))

        at                    the common point [m], in space at the initial pose; a pair with frames="body"
        orientation           the frame's Euler parameters, scalar first; without it the inertial axes
        stiffness             k [N/m] along x, y, z         rotational_stiffness  K [N m/rad]
        damping               c [N s/m]                     rotational_damping    C [N m s/rad]

        breaks: times [s] at which Python functions are not smooth, see functions.with_breaks.
        Quantities are numbers or functions of time.
        """
        place = {"at": at, "orientation": orientation}
        own = {"stiffness": stiffness, "rotational_stiffness": rotational_stiffness,
               "damping": damping, "rotational_damping": rotational_damping}  # fmt: skip
        return self._add_force("bushing", a, b, frames, name, {**place, **own, "breaks": breaks})

    def forces(
        self,
        kind: str,
        a: BodiesLike,
        b: BodiesLike,
        *,
        name: str | Sequence[str] | None = None,
        frames: Frames | None = None,
        **arguments: Any,
    ) -> Range[Force]:
        """
        Add k force elements of one kind at once, as `joints`.

            model.forces("drag", "ground", ["crank", "rod"], at=np.zeros((2, 3)), coefficient=0.2)

        Arguments are those of the kind's own method, with its defaults, each the same for all or with a
        leading k: of a bushing `stiffness` is (3,) or (k, 3). One component alone is `stiffness_x`, ...

        A given force, `Model.force`, is of the kind "applied": on b, `at` in its coordinates, with components
        in the axes of a, of "ground" inertial; frame="body": in those of b. With `frames` its point and axes,
        `at` and `orientation`, are given as those of a bushing.
        """
        first = self.force_count
        if kind == "applied" and frames is None:
            self._apply(a, b, name, True, arguments)
            return Range(range(first, self.force_count), lambda index: self._force(index, kind))
        frames = "space" if frames is None else frames
        if kind == "rotational_spring_damper" and arguments.get("at") is None:
            arguments["at"] = _on_any_axis(frames)
        self._place("force", kind, a, b, frames, name, True, arguments)
        return Range(range(first, self.force_count), lambda index: self._force(index, kind))

    # --- what there is --------------------------------------------------------------------------------------

    @property
    def body_count(self) -> int:
        """Number of bodies, the ground not counted."""
        return int(self._core.body_count)

    @property
    def joint_count(self) -> int:
        """Number of joints, drivers and couplers among them."""
        return int(self._core.joint_count)

    @property
    def force_count(self) -> int:
        """Number of force elements, gravity not counted."""
        return int(self._core.force_count)

    @property
    def user_force_count(self) -> int:
        """Number of the user's own forces, compiled ones included."""
        return len(self._user_forces)

    @property
    def row_count(self) -> int:
        """Number of constraint equations."""
        return int(self._core.row_count)

    @property
    def signals(self) -> Sequence[tuple[str, TimeFunction]]:
        """The functions of time in the model, each with what it drives."""
        return tuple(self._signals)

    @property
    def user_forces(self) -> Sequence[tuple[str, Any]]:
        """The user's own forces, each a name and the function that was arguments."""
        return tuple((it.name, it.law) for it in self._user_forces)

    @property
    def _calls(self) -> Sequence[tuple[str, Calls]]:
        """The functions of the user's own that may remember, each with what it is for."""
        of_forces = [(it.name, it.calls) for it in self._user_forces if it.calls is not None]
        for _, calls in of_forces:
            if isinstance(calls.function, CompiledLaw):
                calls.function.bodies = self.body_count
        others = dict([*self._signals, *self._characteristics])
        return (*of_forces, *((name, calls) for name, it in others.items() for calls in it.calls))

    @property
    def _reaching(self) -> Mapping[str, Any]:
        """What reaches all that functions of the user's own read, by name."""
        return dict([*((it.name, it.reaching) for it in self._user_forces), *self._signals])

    @property
    def drivers(self) -> Sequence[tuple[str, TimeFunction]]:
        """Those of the `signals` that drive joints."""
        return tuple(self._drivers)

    @property
    def shapes(self) -> Shapes:
        """The bodies that have shapes of their own."""
        return self._shapes

    def find(self, name: str) -> Body:
        """The body with this name.

            rod = model.find("rod")

        ModelError: there is none; the message has the nearest.
        """
        return self._bodies.handle(self._bodies.index(name, Subject("model", self.name, False, 1)))

    def indices(self, bodies: BodiesLike) -> NDArray[np.int32]:
        """Indices (k,) of one or many bodies, -1 the ground.

            crank, rod = model.indices(["crank", "rod"])

        ModelError: there is no such body.
        """
        return self._bodies.indices(bodies, Subject("model", self.name, False, 1))

    @property
    def curves(self) -> dict[int, Floats]:
        """Of each point_on_curve, by the index of the joint: points along it (m, 3), in body a [m]."""
        return {joint: it.line() for joint, it in self._special.items() if isinstance(it, CurveData)}

    def compiled(self) -> _core.Model:
        """
        The same model in the compiled module.

            q0 = model.compiled().q0.reshape(-1, 7)
        """
        return self._core

    # --- how elements are added -----------------------------------------------------------------------------

    def _place(
        self,
        role: Role,
        kind: str,
        a: BodiesLike,
        b: BodiesLike,
        frames: Frames,
        name: str | Sequence[str] | None,
        group: bool,
        arguments: Mapping[str, Any],
    ) -> None:
        """Add one element or a group; `arguments` are those of the placement and the parameters."""
        info = kind_info(role, kind)
        _choose("frames", frames, ("space", "body"))
        subject, bodies = self._subject(kind, a, b, name, group)
        quantities = _quantities(info, subject, arguments)
        self._add(placed(info, subject, bodies, self._bodies.poses, frames == "body", quantities))

    def _apply(
        self,
        a: BodiesLike,
        b: BodiesLike,
        name: str | Sequence[str] | None,
        group: bool,
        arguments: Mapping[str, Any],
    ) -> None:
        """Apply one force or a group on b, at points in its coordinates, with components in the axes of a."""
        info = kind_info("force", "applied")
        subject, bodies = self._subject("applied", a, b, name, group)
        given = dict(arguments)
        at, frame = given.pop("at", None), given.pop("frame", None)
        if at is not None and info.parameters.keys() <= given.keys():
            why = 'at is in the coordinates of b, as in Model.force: frames="space" for a point in space'
            subject.refuse(0, why, "argument", "at")
        quantities = _quantities(info, subject, given)
        known = ["at", "frame", "force", "torque", *info.parameters]
        check_known(subject, quantities, known)
        if frame is not None:
            bodies = _axes_by_frame(frame, subject, bodies)
        s = subject.array((0.0, 0.0, 0.0) if at is None else at, 3, "at")
        axes = np.broadcast_to(np.eye(3), (subject.count, 2, 3, 3))
        place = Attachment(np.stack([np.zeros_like(s), s], axis=1), axes, np.zeros(subject.count))
        self._add(with_parameters(info, subject, bodies, place, quantities))

    def _subject(
        self, kind: str, a: BodiesLike, b: BodiesLike, name: str | Sequence[str] | None, group: bool
    ) -> tuple[Subject, Indices]:
        """One element or a group, and its bodies (k, 2)."""
        several = name if group and name is not None and not isinstance(name, str) else None
        name = kind if several is not None else self._named(name, kind, self._counts[kind])
        pairs = self._bodies.pairs if group else self._bodies.pair
        bodies = pairs(a, b, Subject(kind, name, False, 1))
        each = [] if several is None else _names_of_all(kind, several, len(bodies))
        return Subject(kind, name, group, len(bodies), each), bodies

    def _add(self, elements: Elements) -> None:
        self._check_bodies(elements)
        self._functions |= elements.add_to(self._core)
        self._signals += elements.signals()
        if elements.info.rows:
            self._drivers += elements.signals()
        else:
            self._storing += elements.signals("differentiable")
        self._characteristics += elements.characteristics()
        self._counts[elements.info.name] += elements.subject.count

    def _check_bodies(self, elements: Elements) -> None:
        """ModelError: a force element that no body would feel."""
        kind, subject, (a, b) = elements.info.name, elements.subject, elements.bodies.T
        if kind in ON_B:
            subject.check(b >= 0, lambda k: "acts on b alone, and that is the ground", "ground", "b")
        if kind in KINDS["force"] and kind != "applied":  # in axes of the body itself
            subject.check(
                a != b, lambda k: f"joins body '{self._core.body_name(a[k])}' to itself", "self_joint", "b"
            )

    def _keep(self, kind: str, index: int, data: CouplerData | CurveData) -> Joint:
        """What a file of the model needs of a special joint that was added."""
        self._special[index] = data
        self._counts[kind] += 1
        return self._joint(index)

    def _joint(self, index: int) -> Joint:
        return Joint(self._core.joint_name(index), index, self._core.joint_kind(index))

    def _force(self, index: int, kind: str) -> Force:
        return Force(self._core.force_name(index), index, kind)

    def _named(self, name: object, kind: str, count: int) -> str:
        """The name given, or `revolute 3`: the first number that is not taken."""
        if name is not None:
            return _check_name(name, kind)
        core = self._core
        finders = (core.find_body, core.find_joint, core.find_force, core.find_user_force)
        while any(
            find(kind_and_number) >= 0 for find in finders for kind_and_number in _names(kind, count + 1)
        ):
            count += 1
        return f"{kind} {count + 1}"


def _quantities(info: _core.KindInfo, subject: Subject, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """The arguments, vectors in components, functions with their breaks; a group of forces with defaults."""
    given = dict(arguments)
    breaks = given.pop("breaks", ())
    usual = _usual(info) if subject.group and not info.rows else {}
    whole = {**in_components(info, subject, usual), **in_components(info, subject, given)}
    return functions.broken(whole, breaks, subject.who(0))


def _axes_by_frame(frame: str, subject: Subject, bodies: Indices) -> Indices:
    """Bodies (k, 2) of applied forces, the first with the axes of the components, by the `frame` of these."""
    _choose("frame", frame, ("inertial", "body"))
    a, b = bodies.T
    axes = np.full_like(b, -1) if frame == "inertial" else b
    subject.check(
        (a == -1) | (a == axes), lambda k: f"frame {frame!r} are not the axes of a", "frame", "frame"
    )
    return np.stack([axes, b], axis=1)


def _usual(info: _core.KindInfo) -> dict[str, Any]:
    """The defaults that the method of a force element has for its parameters."""
    method = getattr(ModelBuilder, "force" if info.name == "applied" else info.name)
    return {
        name: it.default
        for name, it in inspect.signature(method).parameters.items()
        if {name, f"{name}_x"} & info.parameters.keys() and it.default is not it.empty
    }


def _on_any_axis(frames: Frames) -> Any:
    """A point for what only the direction of an axis counts for."""
    origin = (0.0, 0.0, 0.0)
    return (origin, origin) if arguments.is_one_of(frames, ["body"]) else origin


def _names_of_all(who: str, names: Sequence[str], count: int) -> list[str]:
    """ModelError: no sequence of as many names as there are elements, or one is no printable text."""
    if not isinstance(names, Sequence | np.ndarray) or not arguments.is_iterable(names):
        raise ModelError(f"{who}: name {names!r} is neither a text nor a sequence of names", code="name")
    each = list(names)
    if len(each) != count:
        raise ModelError(f"{who}: {len(each)} names for {count}", code="names")
    texts = set(map(type, each)) <= {str} and all(map(str.isprintable, each))
    if not texts or max(map(len, each), default=0) > LONGEST:
        for name in each:
            _check_name(name, who)
    return each


def _check_name(name: object, who: str) -> str:
    """ModelError: it is no printable text, or longer than files take."""
    if not isinstance(name, str) or not name.isprintable():
        raise ModelError(f"{who}: name {name!r:.80} is not printable text", code="name")
    if len(name) > LONGEST:
        raise ModelError(f"{who}: name '{name[:40]}...' has more than {LONGEST} characters", code="name")
    return name


def _motion(what: str, motion: TimeFunctionLike, start: JointCoordinate, who: str) -> TimeFunction:
    """A coordinate over time from its position, velocity or acceleration."""
    with about(what, who):
        function = as_time_function(motion, f"{who}: {what}")
    function = function if isinstance(function, TimeFunction) else functions.constant(function)
    value, rate = float(start.value[0]), float(start.rate[0])
    if what == "position":
        return function
    if what == "velocity":
        return Sum((functions.polynomial(value), function.integral()))
    return Sum((functions.polynomial(value, rate), function.integral().integral()))


def _names(kind: str, number: int) -> tuple[str, str]:
    """The name of a single object, and of the first of a group."""
    return f"{kind} {number}", f"{kind} {number}[0]"


def _choose(what: str, value: str, known: Sequence[str]) -> None:
    arguments.one_of(value, known, what)
