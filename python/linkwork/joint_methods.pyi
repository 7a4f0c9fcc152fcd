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
