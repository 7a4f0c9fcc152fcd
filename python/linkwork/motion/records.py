"""What is read from a run, in records: states, the motion of a body, reactions, events, singular poses."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, NoReturn

import numpy as np

from linkwork.arguments import array
from linkwork.arrays import Floats, ReadOnly, by_value
from linkwork.errors import OptionError
from linkwork.motion.state_names import StateNames

__all__ = [
    "BodyResult",
    "Checkpoint",
    "Excess",
    "ForceResult",
    "Occurrence",
    "Reaction",
    "Resume",
    "SingularPose",
    "Snapshot",
    "Strike",
    "energy_error",
    "rotate",
]


@by_value
class Reaction(NamedTuple):
    """What a joint does to its second body: force [N] and torque [N m] (k, 3).

    The reference point is the joint's point on that second body, where `at` put it, and moves with the body:
    the force acts there, and the torque is about it. `Result.joint_points(joint)[:, 1]` is that point in
    space, and the viewer draws the arrows of reactions from it. A coupler's reaction is on the second body of
    its first joint; a distance's is along the line between its two points.
    """

    force: Floats
    torque: Floats


@by_value
class ForceResult(NamedTuple):
    """What a force element does over time (k,): to its second body, and to the mechanism."""

    force: Floats  #: on the second body (k, 3) [N], inertial axes
    torque: Floats  #: on it about the element's point there (k, 3) [N m], inertial axes
    power: Floats  #: that the element gives to the bodies (k,) [W]
    potential: Floats  #: energy that is stored in it (k,) [J]
    #: of a spring between two points its elongation [m], of one along an axis its shift [m], of one about an
    #: axis its twist over full turns [rad] (k,), beyond what it has when free; of other kinds, and where that
    #: is a function of time, None
    deflection: Floats | None


@by_value
@dataclass(frozen=True)
class BodyResult(ReadOnly):
    """The motion of one body's center of mass and its rotation; k frames, SI units."""

    name: str
    position: Floats  #: (k, 3) inertial
    orientation: Floats  #: (k, 4) Euler parameters, scalar first
    velocity: Floats  #: (k, 3) inertial
    omega: Floats  #: (k, 3) body-fixed
    acceleration: Floats  #: (k, 3) inertial
    angular_acceleration: Floats  #: (k, 3) body-fixed

    @property
    def omega_inertial(self) -> Floats:
        """Angular velocity (k, 3), inertial axes [rad/s]."""
        return rotate(self.orientation, self.omega)


class Checkpoint(NamedTuple):
    """What the driver of a run can go on from to the last bit."""

    method: str  #: digest of the mechanism and of all that decides on the steps
    t: float  #: [s]
    state: bytes
    #: functions that read something else than as the run began: name, digest then and now
    changed: tuple[tuple[str, str, str], ...] = ()
    returned: str = ""  #: what laws return now, see linkwork.running.returned
    #: from and until when [s] functions read something else than now, in order, as events have changed it
    unlike: tuple[tuple[float, float], ...] = ()
    read: tuple[tuple[str, str], ...] = ()  #: these functions: name, digest now
    remember: tuple[str, ...] = ()  #: functions that change it themselves

    @property
    def of_memory(self) -> Checkpoint | None:
        """For another state of the run: what functions read at its end; None: what they always read."""
        return self._replace(state=b"") if self.changed or self.unlike or self.remember else None

    def is_unlike(self, first: float, last: float) -> bool:
        """Whether functions read something else than now at any time from `first` to `last` [s]."""
        by_itself = bool(self.remember) and first < last
        return by_itself or any(begin <= last and first < end for begin, end in self.unlike)

    def __repr__(self) -> str:
        return f"<Checkpoint: t = {self.t:g} s, {len(self.state)} bytes>"


class Resume(NamedTuple):
    """What a snapshot has beside its state, for the run that it is of to go on to the last bit."""

    checkpoint: Checkpoint  #: steps from there on to the snapshot are taken once more
    work: float  #: up to the snapshot [J]
    state: str  #: digest of the state of the snapshot
    #: events that were listed since the checkpoint: the place or the label, and when [s]; None: nobody knows
    listed: Sequence[tuple[int | str, float]] | None = None

    def __repr__(self) -> str:
        return f"<Resume: {self.checkpoint!r}>"


@by_value
class Snapshot(NamedTuple):
    """The state of a run at one time, from which another can start."""

    t: float  #: [s]
    q: Floats  #: (n, 7) position [m] and Euler parameters of each body
    v: Floats  #: (n, 6) velocity, inertial [m/s], and angular velocity, body axes [rad/s]
    #: (h,) history variables of springs, stops, contacts and couplers: full turns, speeds at which contacts
    #: began, see linkwork.System; none: they begin anew
    history: Sequence[float] | Floats = ()
    #: of the runs that led there, see `Verdict.before`
    error: float = 0.0
    #: of a run: from its end it goes on by the same method to the last bit, see linkwork.simulate
    resume: Resume | None = None
    #: events that came at its time: the label, and y = (q, v) (13n,) before it
    happened: Sequence[tuple[str, Floats]] = ()
    #: of a run: its bodies and elements, by which a model takes them in its own order; None: they are in it
    names: StateNames | None = None

    @classmethod
    def of(cls, t: float, y: Floats, history: Sequence[float] | Floats = ()) -> Snapshot:
        """
        From y = (q, v) (13n,).

            start = lw.Snapshot.of(0.0, lw.System(model).initial_state())

        OptionError: y of another shape.
        """
        y = np.array(array(y, "Snapshot.of: y"))  # the caller may go on in his
        if y.ndim != 1 or not y.size or y.size % 13:
            raise OptionError(
                f"Snapshot.of: y of shape {y.shape} must be (q, v) in one, (13n,) for n bodies", code="y"
            )
        split = 7 * (len(y) // 13)
        return cls(t, y[:split].reshape(-1, 7), y[split:].reshape(-1, 6), history)

    @property
    def memory(self) -> NoReturn:
        """AttributeError: the former name of `history`."""
        raise AttributeError("'memory' is called 'history' now: ask for that")

    def resumable(
        self,
        checkpoint: Checkpoint | None,
        work: float,
        listed: Sequence[tuple[int | str, float]] | None = None,
    ) -> Snapshot:
        """
        The same with what the run needs to go on to the last bit; `work` [J] up to here, and the events that
        it has `listed` since the checkpoint: the place among the events of the run, or the label, and when
        [s]; None: nobody knows.

            start = lw.Snapshot.of(0.0, lw.System(model).initial_state()).resumable(None, work=0.0)
        """
        if checkpoint is None or (checkpoint.state and checkpoint.t > self.t):
            return self
        return self._replace(resume=Resume(checkpoint, work, self.digest, listed))

    @property
    def digest(self) -> str:
        """Of its time, state and history."""
        parts = (self.t, self.q, self.v, self.history)
        values = np.concatenate([np.ravel(part).astype(float) for part in parts])
        return hashlib.blake2b(values.tobytes(), digest_size=16).hexdigest()

    @property
    def y(self) -> Floats:
        """(q, v) in one (13n,)."""
        return np.concatenate([np.ravel(self.q), np.ravel(self.v)]).astype(float)


class Excess(NamedTuple):
    """A time in which the constraints were violated by more than the run's limit."""

    level: str  #: "position", "velocity" or "acceleration"
    t: float  #: when it began [s]
    largest: float  #: [m or 1, with 1/s or 1/s^2]
    joint: str  #: of the largest


class SingularPose(NamedTuple):
    """A crossing of, or near, a pose in which equations of loops depend on each other for a moment."""

    t: float  #: nearest to it [s]
    joints: tuple[str, ...]  #: whose equations they are (the first 16)
    pivot: float  #: smallest pivot of the factorizations there, relative to the usual one; 0: singular
    fallback_evaluations: int  #: there, by a rank-revealing factorization

    @property
    def taken_over(self) -> NoReturn:
        """AttributeError: the former name of `fallback_evaluations`."""
        raise AttributeError("'taken_over' is called 'fallback_evaluations' now: ask for that")


@by_value
@dataclass(frozen=True)
class Occurrence(ReadOnly):
    """An event that came: poses q (n, 7) and velocities v (n, 6) before and after it."""

    name: str
    t: float
    q_before: Floats
    v_before: Floats
    q_after: Floats
    v_after: Floats

    @property
    def changes(self) -> bool:
        """Whether it changed the state."""
        same = np.array_equal(self.q_before, self.q_after) and np.array_equal(self.v_before, self.v_after)
        return not same

    @classmethod
    def of(cls, name: str, t: float, before: Floats, after: Floats) -> Occurrence:
        """
        From y = (q, v) (13n,) before and after.

            y = lw.System(model).initial_state()
            event = lw.Occurrence.of("impact", 0.5, before=y, after=y)
        """
        split = 7 * (len(before) // 13)
        parts = [part.reshape(-1, width) for y in (before, after)
                 for part, width in ((y[:split], 7), (y[split:], 6))]  # fmt: skip
        return cls(name, t, *parts)


@by_value
class Strike(NamedTuple):
    """Bodies struck by drivers: before and after it y = (q, v, work) (13n + 1,), and energies [J]."""

    t: float  #: [s]
    potential: float
    before: Floats
    kinetic_before: float
    after: Floats
    kinetic_after: float


def rotate(p: Floats, u: Floats) -> Floats:
    """A(p) u for Euler parameters p (..., 4) and body vectors u (..., 3), both to (..., 3) inertial."""
    e0, e = p[..., :1], p[..., 1:]
    turned: Floats = u + 2 * np.cross(e, np.cross(e, u) + e0 * u)
    return turned


def energy_error(energy: Floats, work: Floats) -> Floats:
    """Energy that the method made or lost (k,) [J]; `work` may have been counted since a run before this."""
    return energy - energy[:1] - (work - work[:1])
