"""Written by `./dev stubs`."""

from numpy.typing import ArrayLike

from linkwork.arrays import Number, VectorLike
from linkwork.functions import TimeFunctionLike
from linkwork.modeling.handles import BodyLike, Force, Joint
from linkwork.modeling.placement import Frames

def stub() -> str: ...

class JointMethods:
    def spherical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Ball joint: bodies a and b share a point; all three rotations are free.

        3 equations: translation x, translation y, translation z.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.spherical("ground", body, at=(0, 0, 0))

        at      its point (3,) [m]
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def revolute(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Hinge: bodies a and b share a point and an axis; rotation about the axis is free.

        5 equations: translation x, translation y, translation z, rotation about joint y, rotation about joint x.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def cylindrical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Sleeve on a shaft: bodies a and b share an axis; sliding along it and rotation about it are free.

        4 equations: translation along joint x, translation along joint y, rotation about joint y, rotation about joint x.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.cylindrical("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def translational(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Slider: body b slides on body a along an axis; no rotation is free.

        5 equations: translation along joint x, translation along joint y, rotation about joint y, rotation about joint x, rotation about joint z.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.translational("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def universal(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axes: VectorLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Cardan joint: bodies a and b share a point; the axis fixed in a stays perpendicular to the axis fixed in b, and rotation about each is free.

        4 equations: translation x, translation y, translation z, rotation about both axes' normal.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.universal("ground", body, at=(0, 0, 0), axes=((0, 1, 0), (0, 0, 1)))

        at      its point (3,) [m]
        axes    the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def fixed(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        orientation: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Weld: bodies a and b keep their relative position and orientation.

        6 equations: translation x, translation y, translation z, rotation about joint z, rotation about joint x, rotation about joint y.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.fixed("ground", body, at=(0, 0, 0))

        at           its point (3,) [m]
        orientation  the frame's Euler parameters (4,), scalar first; without it the inertial axes
        frames       "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name         without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def distance(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        length: TimeFunctionLike | None = None,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless rod with ball ends: a point of a and a point of b keep the distance `length` [m], constant or a function of time. The multiplier is the rod's force [N], compression positive.

        1 equation: distance.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.distance("ground", body, at=((0, 0, 0), (1, 0, 0)))

        at      a point of a and a point of b: a pair of (3,) [m]
        length  of the rod [m], a number or a function of time, above 0, by default the initial distance
        breaks  times [s] at which Python functions are not smooth, see functions.with_breaks
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def planar(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A plane of b slides on a plane of a: shifts normal to the axis and rotation about it are free.

        3 equations: translation along joint z, rotation about joint y, rotation about joint x.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.planar("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def point_on_line(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A point of b stays on a line of a, the axis; all rotations are free.

        2 equations: translation along joint x, translation along joint y.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.point_on_line("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def point_on_plane(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A point of b stays in a plane of a through the joint's point, normal to the axis.

        1 equation: translation along joint z.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.point_on_plane("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def parallel_axes(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """An axis of b stays parallel to an axis of a: shifts and rotation about the axis are free.

        2 equations: rotation about joint y, rotation about joint x.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.parallel_axes("ground", body, axis=(0, 1, 0))

        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def perpendicular_axes(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axes: VectorLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """An axis of b stays perpendicular to an axis of a; shifts and rotations about both axes are free.

        1 equation: rotation about both axes' normal.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.perpendicular_axes("ground", body, axes=((0, 1, 0), (0, 0, 1)))

        axes    the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def orientation(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        orientation: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Orientation lock: bodies a and b keep their relative orientation; all shifts are free.

        3 equations: rotation about joint z, rotation about joint x, rotation about joint y.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.orientation("ground", body)

        orientation  the frame's Euler parameters (4,), scalar first; without it the inertial axes
        frames       "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name         without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def constant_velocity(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axes: VectorLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Homokinetic joint: bodies a and b share a point, and the shaft of b turns about its axis exactly as the shaft of a does, at any angle between them below 180 degrees.

        4 equations: translation x, translation y, translation z, rotation about both shafts.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.constant_velocity("ground", body, at=(0, 0, 0), axes=((1, 0, 0), (1, 0.1, 0)))

        at      its point (3,) [m]
        axes    the axes of the shafts a and b, both the same way through the joint: a pair of (3,)
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def screw(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        pitch: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Nut on a thread: bodies a and b share an axis, and b advances along it by `pitch` [m] for each turn against a; negative: a left-hand thread.

        5 equations: translation along joint x, translation along joint y, translation along the thread, rotation about joint y, rotation about joint x.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.screw("ground", body, at=(0, 0, 0), axis=(0, 1, 0), pitch=0.3)

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        pitch   advance of b for each turn [m], a number, not zero
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def gear(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        teeth_a: Number,
        teeth_b: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Spur gears: wheels a and b with `teeth_a` and `teeth_b` teeth mesh on the line between their centers; their axes are kept parallel and apart by other joints, on a carrier that may move. A negative number of teeth is that of a ring gear with teeth inside, in which the other wheel, of fewer teeth, turns.

        1 equation: rolling of the pitch circles.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.gear("ground", body, at=((0, 0, 0), (1, 0, 0)), axis=(0, 1, 0), teeth_a=20, teeth_b=-37)

        at       a point on the axis of a and a point on that of b: a pair of (3,) [m]
        axis     the direction (3,) of both axes, of any length
        teeth_a  number of teeth of a, a whole number, not zero
        teeth_b  number of teeth of b, a whole number, not zero
        frames   "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name     without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def rack_pinion(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axes: VectorLike,
        radius: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Rack and pinion: pinion b of pitch `radius` [m] rolls on rack a. Of the two axes the first is the rack's direction, the second the pinion's axis; the rack is on the side of direction x axis, with a negative radius on the other side. Other joints keep the pinion on the rack.

        1 equation: rolling of the pitch circle.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.rack_pinion("ground", body, at=(0, 0, 0), axes=((0, 1, 0), (0, 0, 1)), radius=0.3)

        at      its point (3,) [m]
        axes    the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)
        radius  of the pitch circle [m], a number, not zero
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def revolute_spherical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        length: TimeFunctionLike | None = None,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless link, hinged on an axis of a and with a ball joint on b: the ball stays on a circle of a with radius `length` [m] about the axis, constant or a function of time.

        2 equations: translation along joint z, distance.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute_spherical("ground", body, at=((0, 0, 0), (1, 0, 0)), axis=(0, 1, 0))

        at      a point on the axis of a and a point on that of b: a pair of (3,) [m]
        axis    the direction (3,) of both axes, of any length
        length  from the axis to the ball [m], a number or a function of time, above 0, by default the initial distance
        breaks  times [s] at which Python functions are not smooth, see functions.with_breaks
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def revolute_revolute(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        length: TimeFunctionLike | None = None,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless link, hinged on a and on b about parallel axes that are `length` [m] apart, constant or a function of time.

        4 equations: rotation about joint y, rotation about joint x, translation along joint z, distance.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute_revolute("ground", body, at=((0, 0, 0), (1, 0, 0)), axis=(0, 1, 0))

        at      a point on the axis of a and a point on that of b: a pair of (3,) [m]
        axis    the direction (3,) of both axes, of any length
        length  between the axes [m], a number or a function of time, above 0, by default the initial distance
        breaks  times [s] at which Python functions are not smooth, see functions.with_breaks
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def revolute_translational(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axes: VectorLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Pin in a slot: a massless block, hinged on a about the first axis, slides on b along the second, which is perpendicular to the first.

        4 equations: rotation about both axes' normal, rotation about the slot, translation along the pin, translation across the slot.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute_translational("ground", body, at=(0, 0, 0), axes=((0, 1, 0), (0, 0, 1)))

        at      its point (3,) [m]
        axes    the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def universal_spherical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        length: TimeFunctionLike | None = None,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless rod with a Cardan joint on a and a ball joint on b: the two points keep the distance `length` [m], constant or a function of time. Where the rod turns to about itself bears on neither body, so this is the equation of `distance`.

        1 equation: distance.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.universal_spherical("ground", body, at=((0, 0, 0), (1, 0, 0)))

        at      a point of a and a point of b: a pair of (3,) [m]
        length  of the rod [m], a number or a function of time, above 0, by default the initial distance
        breaks  times [s] at which Python functions are not smooth, see functions.with_breaks
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def angle_driver(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        angle: TimeFunctionLike,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Driver of a rotation: the angle of b against a about the axis, right-handed and zero at the initial pose, is `angle` [rad], constant or a function of time. Other joints keep the axis. The multiplier is the driving torque on b [N m].

        1 equation: rotation about joint z.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.angle_driver("ground", body, at=(0, 0, 0), axis=(0, 1, 0), angle=0)

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        angle   of b against a, zero at the initial pose [rad], a number or a function of time
        breaks  times [s] at which Python functions are not smooth, see functions.with_breaks
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def displacement_driver(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        displacement: TimeFunctionLike,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Driver of a shift: the point of b is `displacement` [m] along the axis of a from where it is at the initial pose, constant or a function of time. The multiplier is the driving force on b [N].

        1 equation: translation along joint z.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.displacement_driver("ground", body, at=(0, 0, 0), axis=(0, 1, 0), displacement=0)

        at            its point (3,) [m]
        axis          the axis (3,), of any length
        x_axis        the frame's x axis (3,); without it a perpendicular to the axis
        displacement  of the point of b, zero at the initial pose [m], a number or a function of time
        breaks        times [s] at which Python functions are not smooth, see functions.with_breaks
        frames        "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name          without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def knife_edge(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Knife edge: the point of b has no velocity against a along an axis fixed in b; nonholonomic. Along the edge and about the point all motion is free.

        1 equation: velocity along joint z. The last 1 of velocities only (non-holonomic).

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.knife_edge("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at      its point (3,) [m]
        axis    the axis (3,), of any length
        x_axis  the frame's x axis (3,); without it a perpendicular to the axis
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def rolling_disc(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axes: VectorLike,
        radius: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A thin disc of b rolls on a plane of a without slipping; non-holonomic. The joint's point is the point of the plane for a and the center of the disc for b, its axes are the normal of the plane, toward the disc, and the axis of the disc; `radius` [m]. Reactions are about the center of the disc.

        3 equations: translation along the normal, velocity along joint x, velocity along joint y. The last 2 of velocities only (non-holonomic).

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.rolling_disc("ground", body, at=((0, 0, -0.1), (1, 0, 0)), axes=((0, 0, 1), (0, 1, 0)), radius=0.3)

        at      a point of the plane and the center of the disc: a pair of (3,) [m]
        axes    the normal of the plane, toward the disc, and the axis of the disc: a pair of (3,)
        radius  of the disc [m], a number, above 0
        frames  "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name    without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

class ForceMethods:
    def translational_spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        stiffness: TimeFunctionLike = 0.0,
        damping: TimeFunctionLike = 0.0,
        free_displacement: TimeFunctionLike = 0.0,
        force: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Spring [N/m], damper [N s/m] and actuator [N] along a joint axis: the force on b along the axis is -k (x - x_0) - c x_dot + f, x the shift of the point of b against that of a along the axis of a [m], which may have either sign.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.translational_spring_damper("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at                 its point (3,) [m]
        axis               the axis (3,), of any length
        x_axis             the frame's x axis (3,); without it a perpendicular to the axis
        stiffness          of the spring [N/m], a number or a function of time; 0
        damping            of the damper [N s/m], a number or a function of time; 0
        free_displacement  where the spring is free [m], a number or a function of time; 0
        force              of the actuator [N], a number or a function of time; 0
        breaks             times [s] at which Python functions are not smooth, see functions.with_breaks
        frames             "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name               without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def nonlinear_spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        spring: TimeFunctionLike = 0.0,
        damper: TimeFunctionLike = 0.0,
        free_length: TimeFunctionLike | None = None,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Spring and damper between a point of a and a point of b by their characteristics: the pull is spring(l - l_0) + damper(l_dot) [N], positive in tension. Each is a function of its extension [m] or rate [m/s], such as linkwork.functions.table(x, f), or a number for a linear one. Springs by numbers, tables, polynomials, harmonics and sums of these store energy; with other functions, and where they are free by a function without derivatives, what is in them counts as work.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.nonlinear_spring_damper("ground", body, at=((0, 0, 0), (1, 0, 0)))

        at           a point of a and a point of b: a pair of (3,) [m]
        spring       pull [N] over the extension [m], its slope [N/m], a characteristic, or a number for a linear one; 0
        damper       pull [N] over the rate [m/s], its slope [N s/m], a characteristic, or a number for a linear one; 0
        free_length  where the spring is free [m], a number or a function of time, by default the initial distance
        breaks       times [s] at which Python functions are not smooth, see functions.with_breaks
        frames       "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name         without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def nonlinear_rotational_spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        spring: TimeFunctionLike = 0.0,
        damper: TimeFunctionLike = 0.0,
        free_angle: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Spring and damper about a joint axis by their characteristics: the torque on b is -spring(theta - theta_0) - damper(theta_dot) [N m]. Each is a function of its angle [rad] or rate [rad/s], such as linkwork.functions.table(x, n), or a number for a linear one. Springs by numbers, tables, polynomials, harmonics and sums of these store energy; with other functions, and where they are free by a function without derivatives, what is in them counts as work.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.nonlinear_rotational_spring_damper("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at          its point (3,) [m]
        axis        the axis (3,), of any length
        x_axis      the frame's x axis (3,); without it a perpendicular to the axis
        spring      torque [N m] over the angle [rad], its slope [N m/rad], a characteristic, or a number for a linear one; 0
        damper      torque [N m] over the rate [rad/s], its slope [N m s/rad], a characteristic, or a number for a linear one; 0
        free_angle  where the spring is free [rad], a number or a function of time; 0
        breaks      times [s] at which Python functions are not smooth, see functions.with_breaks
        frames      "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name        without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def bending_spring(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        stiffness: TimeFunctionLike = 0.0,
        damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Bending spring [N m/rad] and damper [N m s/rad] that hold an axis of b parallel to an axis of a, in all directions alike: the torque k beta against the angle beta between the axes, and c times the relative rotation across the axis of a.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.bending_spring("ground", body, axis=(0, 1, 0))

        axis       the axis (3,), of any length
        x_axis     the frame's x axis (3,); without it a perpendicular to the axis
        stiffness  against the angle between the axes [N m/rad], a number or a function of time; 0
        damping    against rotation across the axis [N m s/rad], a number or a function of time; 0
        breaks     times [s] at which Python functions are not smooth, see functions.with_breaks
        frames     "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name       without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def motor(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        curve: TimeFunctionLike,
        throttle: TimeFunctionLike = 1.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Motor about a joint axis: the torque on b about the axis is throttle(t) curve(theta_dot) [N m], the curve a function of the speed [rad/s], such as linkwork.functions.table(speeds, torques).

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.motor("ground", body, at=(0, 0, 0), axis=(0, 1, 0), curve=lambda x: 10.0 * x)

        at        its point (3,) [m]
        axis      the axis (3,), of any length
        x_axis    the frame's x axis (3,); without it a perpendicular to the axis
        curve     torque [N m] over the speed [rad/s], its slope [N m s/rad], a characteristic, or a number for a linear one
        throttle  factor of the curve, a number or a function of time; 1
        breaks    times [s] at which Python functions are not smooth, see functions.with_breaks
        frames    "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name      without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def rotational_friction(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        coulomb: TimeFunctionLike = 0.0,
        viscous: TimeFunctionLike = 0.0,
        transition: Number = 0.01,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Friction about a joint axis: the torque on b is -n_c tanh(w / w_t) - c w [N m], w the relative speed [rad/s]: Coulomb friction `coulomb` [N m], regularized below the speed `transition` [rad/s], and `viscous` friction [N m s/rad].

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.rotational_friction("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at          its point (3,) [m]
        axis        the axis (3,), of any length
        x_axis      the frame's x axis (3,); without it a perpendicular to the axis
        coulomb     Coulomb friction [N m], a number or a function of time, at least 0; 0
        viscous     viscous friction [N m s/rad], a number or a function of time, at least 0; 0
        transition  speed of regularization [rad/s], a number, above 0; 0.01
        breaks      times [s] at which Python functions are not smooth, see functions.with_breaks
        frames      "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name        without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def translational_friction(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        coulomb: TimeFunctionLike = 0.0,
        viscous: TimeFunctionLike = 0.0,
        transition: Number = 0.001,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Friction along a joint axis: the force on b is -f_c tanh(v / v_t) - c v [N], v the relative speed [m/s]: Coulomb friction `coulomb` [N], regularized below the speed `transition` [m/s], and `viscous` friction [N s/m].

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.translational_friction("ground", body, at=(0, 0, 0), axis=(0, 1, 0))

        at          its point (3,) [m]
        axis        the axis (3,), of any length
        x_axis      the frame's x axis (3,); without it a perpendicular to the axis
        coulomb     Coulomb friction [N], a number or a function of time, at least 0; 0
        viscous     viscous friction [N s/m], a number or a function of time, at least 0; 0
        transition  speed of regularization [m/s], a number, above 0; 0.001
        breaks      times [s] at which Python functions are not smooth, see functions.with_breaks
        frames      "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name        without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def rotational_stop(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        lower: TimeFunctionLike,
        upper: TimeFunctionLike,
        stiffness: TimeFunctionLike,
        damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """End stops about a joint axis: where the angle of b against a [rad] is beyond `lower` or `upper` by d, the torque k |d| + c |d| theta_dot [N m] acts against it, never back; k [N m/rad], c [N m s/rad^2].

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.rotational_stop("ground", body, at=(0, 0, 0), axis=(0, 1, 0), lower=-0.1, upper=0.1, stiffness=100)

        at         its point (3,) [m]
        axis       the axis (3,), of any length
        x_axis     the frame's x axis (3,); without it a perpendicular to the axis
        lower      end of the free range [rad], a number or a function of time, not above upper
        upper      end of the free range [rad], a number or a function of time
        stiffness  beyond the ends [N m/rad], a number or a function of time, above 0
        damping    beyond the ends, by depth [N m s/rad^2], a number or a function of time, at least 0; 0
        breaks     times [s] at which Python functions are not smooth, see functions.with_breaks
        frames     "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name       without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def translational_stop(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        lower: TimeFunctionLike,
        upper: TimeFunctionLike,
        stiffness: TimeFunctionLike,
        damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """End stops along a joint axis: where the shift of b against a [m] is beyond `lower` or `upper` by d, the force k |d| + c |d| x_dot [N] acts against it, never back; k [N/m], c [N s/m^2].

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.translational_stop("ground", body, at=(0, 0, 0), axis=(0, 1, 0), lower=-0.1, upper=0.1, stiffness=100)

        at         its point (3,) [m]
        axis       the axis (3,), of any length
        x_axis     the frame's x axis (3,); without it a perpendicular to the axis
        lower      end of the free range [m], a number or a function of time, not above upper
        upper      end of the free range [m], a number or a function of time
        stiffness  beyond the ends [N/m], a number or a function of time, above 0
        damping    beyond the ends, by depth [N s/m^2], a number or a function of time, at least 0; 0
        breaks     times [s] at which Python functions are not smooth, see functions.with_breaks
        frames     "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name       without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def drag(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        coefficient: TimeFunctionLike,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Drag of a medium fixed in a (usually the ground) on a point of b: the force on b is -c |u| u [N], u the velocity of the point against the medium [m/s] and `coefficient` c = rho c_d A / 2 [N s^2/m^2]. Nothing acts on a.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.drag("ground", body, at=(0, 0, 0), coefficient=5)

        at           its point (3,) [m]
        coefficient  rho c_d A / 2 [N s^2/m^2], a number or a function of time, at least 0
        breaks       times [s] at which Python functions are not smooth, see functions.with_breaks
        frames       "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name         without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def linear_damping(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        damping: TimeFunctionLike = 0.0,
        rotational_damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Linear damping of all relative motion: the force on the point of b is -c u [N], u the velocity of that point as seen from a [m/s] and `damping` c [N s/m]; the torque on b is -C w [N m], w the angular velocity of b against a [rad/s] and `rotational_damping` C [N m s/rad]. Both act back on a, at the point of b.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.linear_damping("ground", body, at=(0, 0, 0))

        at                  its point (3,) [m]
        damping             against the velocity of the point [N s/m], a number or a function of time; 0
        rotational_damping  against the angular velocity [N m s/rad], a number or a function of time; 0
        breaks              times [s] at which Python functions are not smooth, see functions.with_breaks
        frames              "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name                without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def sphere_plane_contact(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        normal: VectorLike,
        radius: Number,
        stiffness: Number,
        exponent: Number = 1.5,
        hysteresis: TimeFunctionLike = 0.0,
        friction: TimeFunctionLike = 0.0,
        transition: Number = 0.001,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Contact of a sphere of b, by its center and `radius` [m], with a plane of a, by a point and the normal toward b; stiffness K [N/m^n] and exponent n, hysteresis factor c, coefficient of friction, transition speed [m/s]. F = K d^n (1 + c d_dot / d_dot_0) at the depth d [m], d_dot_0 the speed at which contact began; see linkwork.contact_hysteresis.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.sphere_plane_contact("ground", body, at=((0, 0, -0.1), (1, 0, 0)), normal=(0, 0, 1), radius=2, stiffness=100)

        at          a point of the plane and a point of b: a pair of (3,) [m]
        normal      of the plane (3,), toward b, of any length; fixed in a
        radius      of the sphere [m], a number, above 0
        stiffness   K [N/m^exponent], a number, above 0
        exponent    n, a number, at least 1; 1.5
        hysteresis  factor c of the rate, a number or a function of time, at least 0; 0
        friction    coefficient of friction, a number or a function of time, at least 0; 0
        transition  speed of regularization, and the least by which hysteresis damps: at rest by F c / transition [m/s], a number, above 0; 0.001
        breaks      times [s] at which Python functions are not smooth, see functions.with_breaks
        frames      "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name        without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def sphere_sphere_contact(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        radius_a: Number,
        radius_b: Number,
        stiffness: Number,
        exponent: Number = 1.5,
        hysteresis: TimeFunctionLike = 0.0,
        friction: TimeFunctionLike = 0.0,
        transition: Number = 0.001,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Contact of a sphere of a with a sphere of b, by their centers and radii [m]; stiffness K [N/m^n] and exponent n, hysteresis factor c, coefficient of friction, transition speed [m/s]. F = K d^n (1 + c d_dot / d_dot_0) at the depth d [m], d_dot_0 the speed at which contact began; see linkwork.contact_hysteresis.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.sphere_sphere_contact("ground", body, at=((0, 0, 0), (1, 0, 0)), radius_a=2, radius_b=2, stiffness=100)

        at          a point of a and a point of b: a pair of (3,) [m]
        radius_a    of the sphere of a [m], a number, above 0
        radius_b    of the sphere of b [m], a number, above 0
        stiffness   K [N/m^exponent], a number, above 0
        exponent    n, a number, at least 1; 1.5
        hysteresis  factor c of the rate, a number or a function of time, at least 0; 0
        friction    coefficient of friction, a number or a function of time, at least 0; 0
        transition  speed of regularization, and the least by which hysteresis damps: at rest by F c / transition [m/s], a number, above 0; 0.001
        breaks      times [s] at which Python functions are not smooth, see functions.with_breaks
        frames      "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name        without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def inerter(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        inertance: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Inerter between a point of a and a point of b: the pull is b l_ddot [N], with the distance l of the points and the inertance b [kg]. Its kinetic energy is b l_dot^2 / 2; it weighs nothing.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.inerter("ground", body, at=((0, 0, 0), (1, 0, 0)), inertance=0.5)

        at         a point of a and a point of b: a pair of (3,) [m]
        inertance  of the two points [kg], a number, above 0
        frames     "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name       without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def rotational_inerter(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        inertance: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Rotational inerter about a joint axis, such as the rotor of a motor, its inertia times the square of the gear ratio: the torque on b about the axis is -b theta_ddot [N m], theta the angle of b against a and b the inertance [kg m2], also called armature. Its kinetic energy is b theta_dot^2 / 2; it weighs nothing.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.rotational_inerter("ground", body, at=(0, 0, 0), axis=(0, 1, 0), inertance=0.5)

        at         its point (3,) [m]
        axis       the axis (3,), of any length
        x_axis     the frame's x axis (3,); without it a perpendicular to the axis
        inertance  about the axis [kg m^2], a number, above 0
        frames     "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name       without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """

    def translational_inerter(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: VectorLike,
        axis: VectorLike,
        x_axis: VectorLike | None = None,
        inertance: Number,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Inerter along a joint axis, such as the rotor of a linear drive: the force on b is -b s_ddot [N], s its displacement along the axis of a and b the inertance [kg]. Its kinetic energy is b s_dot^2 / 2; it weighs nothing.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.translational_inerter("ground", body, at=(0, 0, 0), axis=(0, 1, 0), inertance=0.5)

        at         its point (3,) [m]
        axis       the axis (3,), of any length
        x_axis     the frame's x axis (3,); without it a perpendicular to the axis
        inertance  along the axis [kg], a number, above 0
        frames     "space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b
        name       without it the kind and a number

        ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name.
        """
