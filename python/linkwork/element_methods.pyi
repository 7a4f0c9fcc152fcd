"""Printed by `python -m linkwork.element_methods --stub`."""

from numpy.typing import ArrayLike

from linkwork.functions import TimeFunctionLike
from linkwork.handles import BodyLike, Force, Joint
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
        breaks: ArrayLike = (),
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
        pitch: float,
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
        teeth_a: float,
        teeth_b: float,
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
        radius: float,
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
        breaks: ArrayLike = (),
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
        breaks: ArrayLike = (),
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
        breaks: ArrayLike = (),
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
        breaks: ArrayLike = (),
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
        breaks: ArrayLike = (),
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
        radius: float,
        frames: Frames = "space",
        name: str | None = None,
    ) -> Joint:
        """A thin disc of b rolls on a plane of a without slipping; non-holonomic. The joint's point is the point of the plane for a and the center of the disc for b, its axes are the normal of the plane, toward the disc, and the axis of the disc; `radius` [m]. Reactions are about the center of the disc."""

class ForceMethods:
    def nonlinear_spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        spring: TimeFunctionLike = 0.0,
        damper: TimeFunctionLike = 0.0,
        free_length: TimeFunctionLike | None = None,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Spring and damper between a point of a and a point of b by their characteristics: the pull is spring(l - l_0) + damper(l_dot) [N], positive in tension. Each is a function of its extension [m] or rate [m/s], such as linkwork.functions.table(x, f), or a number for a linear one. The energy in the spring counts as work."""

    def nonlinear_rotational_spring_damper(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        spring: TimeFunctionLike = 0.0,
        damper: TimeFunctionLike = 0.0,
        free_angle: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Spring and damper about a joint axis by their characteristics: the torque on b is -spring(theta - theta_0) - damper(theta_dot) [N m]. Each is a function of its angle [rad] or rate [rad/s], such as linkwork.functions.table(x, n), or a number for a linear one. The energy in the spring counts as work."""

    def bending_spring(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        stiffness: TimeFunctionLike = 0.0,
        damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Bending spring [N m/rad] and damper [N m s/rad] that hold an axis of b parallel to an axis of a, in all directions alike: the torque k beta against the angle beta between the axes, and c times the relative rotation across the axis of a."""

    def motor(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        curve: TimeFunctionLike,
        throttle: TimeFunctionLike = 1.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Motor about a joint axis: the torque on b about the axis is throttle(t) curve(theta_dot) [N m], the curve a function of the speed [rad/s], such as linkwork.functions.table(speeds, torques)."""

    def rotational_friction(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        coulomb: TimeFunctionLike = 0.0,
        viscous: TimeFunctionLike = 0.0,
        transition: float = 0.01,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Friction about a joint axis: the torque on b is -n_c tanh(w / w_t) - c w [N m], w the relative speed [rad/s]: Coulomb friction `coulomb` [N m], regularized below the speed `transition` [rad/s], and `viscous` friction [N m s/rad]."""

    def translational_friction(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        coulomb: TimeFunctionLike = 0.0,
        viscous: TimeFunctionLike = 0.0,
        transition: float = 0.001,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Friction along a joint axis: the force on b is -f_c tanh(v / v_t) - c v [N], v the relative speed [m/s]: Coulomb friction `coulomb` [N], regularized below the speed `transition` [m/s], and `viscous` friction [N s/m]."""

    def rotational_stop(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        lower: TimeFunctionLike,
        upper: TimeFunctionLike,
        stiffness: TimeFunctionLike,
        damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """End stops about a joint axis: where the angle of b against a [rad] is beyond `lower` or `upper` by d, the torque k |d| + c |d| theta_dot [N m] acts against it, never back; k [N m/rad], c [N m s/rad^2]."""

    def translational_stop(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        axis: ArrayLike,
        x_axis: ArrayLike | None = None,
        lower: TimeFunctionLike,
        upper: TimeFunctionLike,
        stiffness: TimeFunctionLike,
        damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """End stops along a joint axis: where the shift of b against a [m] is beyond `lower` or `upper` by d, the force k |d| + c |d| x_dot [N] acts against it, never back; k [N/m], c [N s/m^2]."""

    def drag(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        coefficient: TimeFunctionLike,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Drag of a medium fixed in a (usually the ground) on a point of b: the force on b is -c |u| u [N], u the velocity of the point against the medium [m/s] and `coefficient` c = rho c_d A / 2 [N s^2/m^2]. Nothing acts on a."""

    def linear_damping(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        damping: TimeFunctionLike = 0.0,
        rotational_damping: TimeFunctionLike = 0.0,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Linear damping of all relative motion: the force on the point of b is -c u [N], u the velocity of that point as seen from a [m/s] and `damping` c [N s/m]; the torque on b is -C w [N m], w the angular velocity of b against a [rad/s] and `rotational_damping` C [N m s/rad]. Both act back on a, at the point of b."""

    def sphere_plane_contact(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        normal: ArrayLike,
        radius: float,
        stiffness: float,
        exponent: float = 1.5,
        hysteresis: TimeFunctionLike = 0.0,
        friction: TimeFunctionLike = 0.0,
        transition: float = 0.001,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Contact of a sphere of b, by its center and `radius` [m], with a plane of a, by a point and the normal toward b; stiffness K [N/m^n] and exponent n, hysteresis factor c, coefficient of friction, transition speed [m/s]. F = K d^n (1 + c d_dot / d_dot_0) at the depth d [m], d_dot_0 the speed at which contact began; see linkwork.contact_hysteresis."""

    def sphere_sphere_contact(
        self,
        a: BodyLike,
        b: BodyLike,
        *,
        at: ArrayLike,
        radius_a: float,
        radius_b: float,
        stiffness: float,
        exponent: float = 1.5,
        hysteresis: TimeFunctionLike = 0.0,
        friction: TimeFunctionLike = 0.0,
        transition: float = 0.001,
        breaks: ArrayLike = (),
        frames: Frames = "space",
        name: str | None = None,
    ) -> Force:
        """Contact of a sphere of a with a sphere of b, by their centers and radii [m]; stiffness K [N/m^n] and exponent n, hysteresis factor c, coefficient of friction, transition speed [m/s]. F = K d^n (1 + c d_dot / d_dot_0) at the depth d [m], d_dot_0 the speed at which contact began; see linkwork.contact_hysteresis."""
