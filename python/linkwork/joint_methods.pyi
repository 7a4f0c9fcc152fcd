"""Printed by `python -m linkwork.joint_methods --stub`."""

from numpy.typing import ArrayLike

from linkwork.functions import TimeFunctionLike
from linkwork.handles import BodyLike, Joint
from linkwork.placement import Frames

def stub() -> str: ...

class JointMethods:
    def spherical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Ball joint: bodies a and b share a point; all three rotations are free."""

    def revolute(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Hinge: bodies a and b share a point and an axis; rotation about the axis is free."""

    def cylindrical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Sleeve on a shaft: bodies a and b share an axis; sliding along it and rotation about it are free."""

    def translational(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Slider: body b slides on body a along an axis; no rotation is free."""

    def universal(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axes: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Cardan joint: bodies a and b share a point; the axis fixed in a stays perpendicular to the axis fixed in b, and rotation about each is free."""

    def fixed(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        orientation: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Weld: bodies a and b keep their relative position and orientation."""

    def distance(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        length: TimeFunctionLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless rod with ball ends: a point of a and a point of b keep the distance `length` [m], constant or a function of time. The multiplier is the rod's force [N], compression positive."""

    def planar(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A plane of b slides on a plane of a: shifts normal to the axis and rotation about it are free."""

    def point_on_line(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A point of b stays on a line of a, the axis; all rotations are free."""

    def point_on_plane(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A point of b stays in a plane of a through the joint's point, normal to the axis."""

    def parallel_axes(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """An axis of b stays parallel to an axis of a: shifts and rotation about the axis are free."""

    def perpendicular_axes(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axes: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """An axis of b stays perpendicular to an axis of a; shifts and rotations about both axes are free."""

    def orientation(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        orientation: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Orientation lock: bodies a and b keep their relative orientation; all shifts are free."""

    def constant_velocity(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axes: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Homokinetic joint: bodies a and b share a point, and the shaft of b turns about its axis exactly as the shaft of a does, at any angle between them below 180 degrees."""

    def screw(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        pitch: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Nut on a thread: bodies a and b share an axis, and b advances along it by `pitch` [m] for each turn against a; negative: a left-hand thread."""

    def gear(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        teeth_a: ArrayLike,
        teeth_b: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Spur gears: wheels a and b with `teeth_a` and `teeth_b` teeth mesh on the line between their centers; their axes are kept parallel and apart by other joints, on a carrier that may move. A negative number of teeth is that of a ring gear with teeth inside."""

    def rack_pinion(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axes: ArrayLike,
        radius: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Rack and pinion: pinion b of pitch `radius` [m] rolls on rack a. Of the two axes the first is the rack's direction, the second the pinion's axis; the rack is on the side of direction x axis, with a negative radius on the other side. Other joints keep the pinion on the rack."""

    def revolute_spherical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        length: TimeFunctionLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless link, hinged on an axis of a and with a ball joint on b: the ball stays on a circle of a with radius `length` [m] about the axis, constant or a function of time."""

    def revolute_revolute(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        length: TimeFunctionLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless link, hinged on a and on b about parallel axes that are `length` [m] apart, constant or a function of time."""

    def revolute_translational(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axes: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Pin in a slot: a massless block, hinged on a about the first axis, slides on b along the second, which is perpendicular to the first."""

    def universal_spherical(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        length: TimeFunctionLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Massless rod with a Cardan joint on a and a ball joint on b: the two points keep the distance `length` [m], constant or a function of time. Where the rod turns to about itself bears on neither body, so this is the equation of `distance`."""

    def angle_driver(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        angle: TimeFunctionLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Driver of a rotation: the angle of b against a about the axis, right-handed and zero at the initial pose, is `angle` [rad], constant or a function of time. Other joints keep the axis. The multiplier is the driving torque on b [N m]."""

    def displacement_driver(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        displacement: TimeFunctionLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Driver of a shift: the point of b is `displacement` [m] along the axis of a from where it is at the initial pose, constant or a function of time. The multiplier is the driving force on b [N]."""

    def knife_edge(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """Knife edge: the point of b has no velocity against a along an axis fixed in b; non- holonomic. Along the edge and about the point all motion is free."""

    def rolling_disc(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axes: ArrayLike,
        radius: ArrayLike,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A thin disc of b rolls on a plane of a without slipping; non-holonomic. The joint's point is the point of the plane for a and the center of the disc for b, its axes are the normal of the plane, toward the disc, and the axis of the disc; `radius` [m]. Reactions are about the center of the disc."""
