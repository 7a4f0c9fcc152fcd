"""A robot as its file describes it: links and joints in frames of their own, before they are a model."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import warn
from linkwork.importers.frames import Frame, turned
from linkwork.modeling.model import Model
from linkwork.modeling.shapes import Shape

__all__ = ["Coupling", "Description", "Imported", "JointDescription", "LinkDescription", "Motion", "Note"]

#: The name that formats give the ground.
WORLD = "world"


@dataclass(frozen=True)
class Note:
    """What of a file is not in the model, or is there in another way."""

    topic: str  #: such as limits
    subject: str  #: such as joint 'elbow'
    message: str

    def __str__(self) -> str:
        return f"{self.subject}: {self.message}"


@dataclass(frozen=True)
class Imported:
    """A model from the file of another program."""

    path: str
    model: Model
    notes: Sequence[Note]

    def warn(self) -> None:
        """
        One LinkworkWarning that counts the notes by their topics, where there are any.

            imported = lw.import_urdf("arm.urdf")
            imported.warn()
        """
        if not self.notes:
            return
        topics = Counter(note.topic for note in self.notes)
        counted = ", ".join(f"{topic} ({count})" for topic, count in topics.items())
        text = f"{self.path}: not all is in the model as in the file: {counted}; `linkwork convert` lists it"
        warn(text)


@dataclass
class LinkDescription:
    """A link; without an inertia (mass 0) only a frame."""

    name: str
    mass: float = 0.0  #: [kg]
    center: Floats = field(default_factory=lambda: np.zeros(3))  #: of mass, in the link's frame [m]
    inertia: Floats = field(default_factory=lambda: np.zeros((3, 3)))  #: about the center, link axes [kg m2]
    pose: Frame = field(default_factory=Frame)  #: in the world, of a link that no joint carries
    weightless: float = 0.0  #: the share of its weight that is taken from it
    shapes: list[Shape] = field(default_factory=list)  #: what it looks like, in the link's frame
    between_joints: bool = False  #: massless, between the joints of one link of the file


@dataclass(frozen=True)
class Motion:
    """One elementary motion of a joint, along or about an axis of unit length in the joint's frame."""

    rotation: bool
    axis: Floats
    lead: float = 0.0  #: of a screw, its advance with the angle [m/rad]

    def displacement(self, value: float) -> Frame:
        """By an angle [rad] or a length [m]."""
        if not self.rotation:
            return Frame(r=value * self.axis)
        return Frame(value * self.lead * self.axis, turned(self.axis, value).A)


@dataclass
class JointDescription:
    """A joint: the frame of the child's side is that of the parent's side after the motions, in order."""

    name: str
    kind: str  #: fixed, revolute, translational, cylindrical, universal, planar, spherical, screw or free
    parent: str
    child: str
    in_parent: Frame  #: the joint's frame in the parent link
    in_child: Frame = field(default_factory=Frame)  #: and in the child link
    motions: Sequence[Motion] = ()
    #: the coordinates, one for each motion, where both sides agree [rad or m]
    reference: Floats = field(default_factory=lambda: np.zeros(1))
    damping: float = 0.0  #: [N m s/rad] or [N s/m]; of a free joint both, of a spherical one about all axes
    friction: float = 0.0  #: [N m] or [N]
    stiffness: float = 0.0  #: [N m/rad] or [N/m], likewise
    spring_reference: float = 0.0  #: coordinate of the spring at rest
    armature: float = 0.0  #: inertia of a rotor, seen at the joint [kg m2] or [kg]
    pitch: float = 0.0  #: of a screw [m per turn]
    stops: tuple[float, float] | None = None  #: coordinates of the ends, of a joint that has stops
    closes_loop: bool = False  #: it has no say in where its child is

    # M_1(q_1 - r_1) ... M_n(q_n - r_n) = M_1(-r_1) ... M_(n-1)(-r_(n-1)) M_1(q_1) ... M_n(q_n) M_n(-r_n):
    # shifts can change places
    def at_zero(self) -> tuple[Frame, Frame]:
        """Its frames in parent and child that agree where its coordinates are zero."""
        in_parent, in_child = self.in_parent, self.in_child
        values = np.broadcast_to(self.reference, len(self.motions)).tolist()
        for motion, value in zip(self.motions[:-1], values[:-1], strict=True):
            in_parent = in_parent @ motion.displacement(-value)
        for motion, value in zip(self.motions[-1:], values[-1:], strict=True):
            in_child = in_child @ motion.displacement(value)
        return in_parent, in_child

    def other(self, link: str) -> str:
        """Of its two links."""
        return self.child if link == self.parent else self.parent


@dataclass(frozen=True)
class Coupling:
    """The coordinate of one joint follows that of another: follower = multiplier * leader + offset.

    Coordinates from where both sides of each joint agree [rad] or [m].
    """

    kind: str  #: how the format calls it: mimic, gearbox or equality
    name: str
    follower: str
    leader: str
    multiplier: float
    offset: float
    leader_axis: int = 0  #: which of the leader's coordinates

    def __str__(self) -> str:
        offset = f" + {self.offset:g}" if self.offset else ""
        return f"{self.multiplier:g} times joint '{self.leader}'{offset}"


@dataclass
class Description:
    """What the importers make of their files."""

    path: str
    name: str
    links: Mapping[str, LinkDescription]
    joints: Sequence[JointDescription]
    notes: list[Note]
    gravity: Floats = field(default_factory=lambda: np.array([0.0, 0.0, -9.81]))
    grounded: Collection[str] = ()  #: fixed to the ground where nothing carries them, unless asked otherwise
    couplings: Sequence[Coupling] = ()

    def note(self, topic: str, subject: str, message: str) -> None:
        self.notes.append(Note(topic, subject, message))
