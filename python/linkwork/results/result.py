"""The motion that a run found: quantities by name, computed when asked for."""

from __future__ import annotations

import copy
import functools
import hashlib
import math
import os
import uuid
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import rotation
from linkwork.accuracy.verdict import Verdict
from linkwork.accuracy.verification import Finer, band, difference
from linkwork.arguments import array, check_new, one_of
from linkwork.arguments import path as path_of
from linkwork.arrays import Floats, read_only
from linkwork.errors import OptionError, counted, nearest, warn
from linkwork.modeling.coordinates import JointCoordinate, coordinate_of
from linkwork.modeling.handles import Named, place_of
from linkwork.motion.former_names import renamed_manifest, renamed_statistics
from linkwork.motion.header import NO_END, Header, record_reactions
from linkwork.motion.records import (
    BodyResult,
    Checkpoint,
    Excess,
    ForceResult,
    Reaction,
    SingularPose,
    Snapshot,
    energy_error,
    rotate,
)
from linkwork.results.joint_motion import each_coordinate

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure

    from linkwork.modeling.model import Model
    from linkwork.motion.records import Occurrence, Strike
    from linkwork.results.checkpoints import StoredCheckpoint
    from linkwork.view import Page
    from linkwork.view.serving import Server

Frame = Literal["inertial", "joint"]

#: Frames of which a hash is made at once.
HASHED = 256

#: Of poses that are read at a time.
READ_NUMBERS = 4_000_000

#: Work, kinetic and potential energy before and after each event, where nobody knows.
NOT_KNOWN = np.zeros((0, 2, 3))

#: So many bodies or joints are read by themselves, without the others.
FEW_PLACES = 128


class Result:
    """k frames of n bodies, J joints and m constraint rows. SI units; inertial axes unless said otherwise.

    A fresh result holds its frames in memory; a loaded one leaves them in the file until they are asked for.
    What it recorded is read-only: `result.q.copy()` is one's own.

    `manifest` says what was run (versions, options, hash of the model), `statistics` what it took
    (times of mechanisms below 20 bodies are estimated from a part of the evaluations).
    """

    def __init__(self, frames: Mapping[str, Any], header: Header, statistics: Mapping[str, Any], *,
                 run: str | None = None, events: Sequence[Occurrence] = (),
                 checkpoint: Checkpoint | StoredCheckpoint | None = None) -> None:  # fmt: skip
        """`frames`: the arrays of `Simulation.advance` joined over time, or the fields of a result file."""
        shapes = header.frame_shapes()
        count = len(frames["t"])
        self._frames = {
            name: np.reshape(field, (count, *shapes[name])) if isinstance(field, np.ndarray) else field
            for name, field in frames.items()
        }
        self._header = header
        self._run = run or uuid.uuid4().hex
        self._events = tuple(events)
        self._checkpoint = checkpoint
        self._places: dict[str, dict[str, int]] = {}
        self._statistics = dict(statistics)
        self.t: Floats = self._field("t")
        self._finer: Finer | None = None
        self._strikes: tuple[Strike, ...] = ()  # of a fresh result
        self._listed: Sequence[tuple[int, float]] | None = None  # of a fresh one, see Snapshot.resumable
        self._energies_around_events: Floats = NOT_KNOWN  # of a fresh one: (m, 2, 3) [J]

    # --- what was run ---

    @property
    def manifest(self) -> dict[str, Any]:
        """Versions, options and the hash of the model: what is needed to run it again."""
        return copy.deepcopy({**self._header.manifest, **self._said()})

    @property
    def statistics(self) -> dict[str, Any]:
        """What the run took, and how it ended."""
        return copy.deepcopy(self._statistics)

    @property
    def header(self) -> Header:
        """The constant arrays of the model."""
        return self._header

    @property
    def body_names(self) -> Sequence[str]:
        return self._header.body_names

    @property
    def joint_names(self) -> Sequence[str]:
        return self._header.joint_names

    @property
    def finished(self) -> bool:
        """False for a run that failed, and for a file that is damaged or of a run that was interrupted."""
        return bool(self._statistics) and not self._statistics.get("failed", False) and not self.missing

    @property
    def status(self) -> Literal["finished", "failed", "interrupted"]:
        """How the run ended; "interrupted" also where a file does not say how, see `missing`."""
        if self.finished:
            return "finished"
        return "failed" if self._statistics.get("failed", False) else "interrupted"

    @property
    def missing(self) -> tuple[str, ...]:
        """What a file had lost when it was read; its digests tell. The frames that are there are whole."""
        return tuple(self._header.manifest.get("missing", ()))

    @property
    def damaged(self) -> bool:
        """Whether a file had lost something, and not merely the end of a run that was interrupted.

        So it is of what `linkwork repair` wrote, too: what was lost is not there either.
        """
        return any(it != NO_END for it in self.missing)

    @property
    def verdict(self) -> Verdict | None:
        """How accurate the run is, estimated from steps that were taken again: see linkwork.Verdict.

        None: the run did not finish, or had no step.
        """
        numbers = self._statistics.get("verdict")
        return None if numbers is None else Verdict.of(numbers)

    def _said(self) -> dict[str, Any]:
        """Of the verdict for the manifest."""
        found = self._statistics.get("verdict")
        return {"verdict": {name: found[name] for name in ("level", "sentence", "error")}} if found else {}

    @property
    def events(self) -> tuple[Occurrence, ...]:
        """The events that came, in order of time."""
        return self._events

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        end = f" to t = {self.t[-1]:g} s" if len(self) else ""
        bodies = counted(self._header.body_count, "body")
        joints = counted(self._header.joint_count, "joint")
        return f"<Result: {bodies}, {joints}, {counted(len(self), 'frame')}{end}>"

    def _repr_html_(self) -> str:
        """In a notebook: the summary."""
        from linkwork.modeling.tables import Table
        from linkwork.motion import summary

        (_, title), *rows = (pair for pair in summary.lines(self) if pair[1])
        return Table(title, ("", ""), rows)._repr_html_()

    # --- motion ---

    @property
    def q(self) -> Floats:
        """Poses (k, n, 7): position, then Euler parameters."""
        return self._field("q")

    @property
    def v(self) -> Floats:
        """Velocities (k, n, 6): inertial velocity, then body-fixed angular velocity."""
        return self._field("v")

    @property
    def position(self) -> Floats:
        """Centers of mass (k, n, 3) [m]."""
        return self._field("q", np.s_[:, :, :3])

    @property
    def orientation(self) -> Floats:
        """Euler parameters (k, n, 4), scalar first; they turn body axes to inertial."""
        return self._field("q", np.s_[:, :, 3:])

    @property
    def velocity(self) -> Floats:
        """Of the centers of mass (k, n, 3) [m/s]."""
        return self._field("v", np.s_[:, :, :3])

    @property
    def omega(self) -> Floats:
        """Angular velocities in body axes (k, n, 3) [rad/s]."""
        return self._field("v", np.s_[:, :, 3:])

    @property
    def omega_inertial(self) -> Floats:
        """Angular velocities in inertial axes (k, n, 3) [rad/s]."""
        return rotate(self.orientation, self.omega)

    @property
    def acceleration(self) -> Floats:
        """Of the centers of mass (k, n, 3) [m/s2]."""
        return self._field("vdot", np.s_[:, :, :3])

    @property
    def angular_acceleration(self) -> Floats:
        """In body axes (k, n, 3) [rad/s2]."""
        return self._field("vdot", np.s_[:, :, 3:])

    def body(self, name: Named) -> BodyResult:
        """The motion of one body, by name, index or handle.

            height = result.body("rod").position[:, 2]

        ModelError: no such body.
        """
        i = self._place("body", name)
        q, v, vdot = (self._field(field, np.s_[:, i]) for field in ("q", "v", "vdot"))
        return BodyResult(
            name=self.body_names[i],
            position=q[:, :3],
            orientation=q[:, 3:],
            velocity=v[:, :3],
            omega=v[:, 3:],
            acceleration=vdot[:, :3],
            angular_acceleration=vdot[:, 3:],
        )

    # --- joints ---

    @property
    def multipliers(self) -> Floats:
        """Lagrange multipliers (k, m), joint by joint in the order they were added."""
        return self._field("lambda")

    @property
    def unique_reactions(self) -> NDArray[np.bool_]:
        """Per joint (J,): whether its reaction follows from the motion.

        Where constraints are redundant, only sums over the joints of a loop do. Their reactions are those of
        the multipliers of least norm sum_i w_i lambda_i^2, w_i the mean of diag(D M^-1 D^T) over the joint's
        translations or its rotations: equal joints side by side share their load equally. Elastic bodies or
        play would share it in another way.
        """
        return self._header.reaction_unique

    @property
    def redundant_rows(self) -> NDArray[np.int32]:
        """Places in `multipliers` of the equations that the others imply in every pose."""
        return self._header.redundant_rows

    @property
    def violations(self) -> tuple[Excess, ...]:
        """The first hundred times in which a `violation_limit` was passed, and the last."""
        return tuple(
            Excess(it["level"], it["t"], it["largest"], it["joint"])
            for it in self._statistics.get("excesses", ())
        )

    @property
    def history(self) -> Floats:
        """History variables (k, h) of couplers and force elements, see linkwork.System."""
        return self._field("history") if "history" in self._frames else np.zeros((len(self), 0))

    def snapshot(self, frame: int = -1) -> Snapshot:
        """The state of one frame, for simulate(..., start=...), with its history variables.

            onward = lw.simulate(model, t_end=0.2, step=1e-3, start=result.snapshot())

        From the last frame the run goes on to the last bit, see linkwork.simulate. Files of version 0.1 have
        no history variables: full turns and contacts then begin anew.
        OptionError: there is no such frame.
        """
        count = len(self)
        whole = isinstance(frame, int | np.integer) and not isinstance(frame, bool)
        if not whole or not -count <= frame < count:
            raise OptionError(
                f"frame {frame!r:.80} is none of the {count} of this result: give a whole number from 0 to "
                f"{count - 1}, or -1 for the last",
                code="frame",
            )
        state = self._field("q", frame).copy(), self._field("v", frame).copy()
        t = float(self.t[frame])
        came = [
            (it.name, np.concatenate([it.q_before.ravel(), it.v_before.ravel()]))
            for it in self.events
            if it.t == t
        ]
        found = Snapshot(t, *state, self.history[frame].copy(), self._error_at(frame), happened=came,
                         names=self._header.state_names)  # fmt: skip
        last = int(frame) % count == count - 1
        checkpoint = self._settled() if last else self._remembered
        listed = None if checkpoint is None else self._listed_since(checkpoint.t)
        return found.resumable(checkpoint, float(self._field("work", frame)), listed)

    def _listed_since(self, t: float) -> list[tuple[int | str, float]] | None:
        """The events since then, by their place or label; None: a run before may have listed some."""
        if self._listed is not None:
            return [(event, when) for event, when in self._listed if when >= t]
        begun = self.manifest.get("options", {}).get("t_start")
        if begun is None or t < begun:
            return None
        return [(it.name, it.t) for it in self.events if it.t >= t]

    def _settled(self) -> Checkpoint | None:
        """What a run begins with that goes on from the last frame to the last bit."""
        found = self._checkpoint
        return found if found is None or isinstance(found, Checkpoint) else found()

    @functools.cached_property
    def _remembered(self) -> Checkpoint | None:
        """What a run begins with that goes on from another frame."""
        found = self._settled()
        return None if found is None else found.of_memory

    def _error_at(self, frame: int) -> float:
        """The part of the accumulated error that a run has made up to a frame."""
        verdict = self.verdict
        if verdict is None or verdict.state is None:
            return 0.0
        if not np.isfinite(verdict.state):
            return verdict.state
        share = (self.t[frame] - self.t[0]) / ((self.t[-1] - self.t[0]) or 1.0)
        return float(verdict.before + share * (verdict.state - verdict.before))

    @property
    def singular_poses(self) -> tuple[SingularPose, ...]:
        """The first hundred that the run passed, and the last; see `on_singular` in linkwork.options.Options.

        A pose counts where the run evaluated the mechanism near enough to it: large steps may pass unseen.
        Not known of an unfinished run in a file.
        """
        return tuple(
            SingularPose(it["t"], tuple(it["joints"]), it["pivot"], it["fallback_evaluations"])
            for it in self._statistics.get("singularity_crossings", ())
            if not it["rows_changed"]
        )

    def reactions(self) -> Reaction:
        """
        Of all joints, in inertial axes: force and torque (k, J, 3). See `unique_reactions`.

            largest = np.linalg.norm(result.reactions().force, axis=-1).max(axis=0)
        """
        self._need_reactions()
        return Reaction(self._field("reaction_force"), self._field("reaction_torque"))

    def reaction(self, name: Named, frame: Frame = "inertial") -> Reaction:
        """Force and torque (k, 3) that a joint exerts on its second body, at the joint's point on that body.

            force = result.reaction("pin").force

        The torque is about that point, `joint_points(name)[:, 1]`, which moves with the second body. What the
        first body, or the ground, gets is the opposite moved to its own point: where constraints are violated
        the two points are apart.

        `frame="joint"` gives the components along the joint's own axes, which move with its first body.
        `unique_reactions` says whether it follows from the motion.
        ModelError: no such joint.
        """
        one_of(frame, ("inertial", "joint"), "frame")
        joint = self._place("joint", name)
        self._need_reactions()
        force, torque = (
            self._field(field, np.s_[:, joint]) for field in ("reaction_force", "reaction_torque")
        )
        if frame == "inertial":
            return Reaction(force, torque)
        axes = self.joint_axes(joint)
        return Reaction(np.einsum("kij,ki->kj", axes, force), np.einsum("kij,ki->kj", axes, torque))

    def coordinate(self, name: Named, which: str | None = None) -> JointCoordinate:
        """A joint's free coordinate and its rate (k,): an angle [rad] over full turns, or a shift [m].

            angle = result.coordinate("motor pin").value

        which  "angle" of revolute, cylindrical, screw; "displacement" of translational, cylindrical, screw;
               "angle_a" and "angle_b", about its two axes, of universal; not needed where there is one

        It is zero where the joint's frames agree; b against a; full turns count from the first frame on,
        which is within half a turn of zero, also where the run goes on from another. Runs count turns between
        frames in their steps. ModelError: no such joint, or no such coordinate of it. LinkworkWarning: frames
        too far apart to tell how often the angle went round, of a run that has not come to its end.
        """
        joint, header = self._place("joint", name), self._header
        kind = header.joint_kinds[joint]
        which = coordinate_of(kind, header.joint_names[joint], which)
        return next(each_coordinate(self, [(joint, which)]))

    def force(self, name: str | int, model: Model | None = None) -> ForceResult:
        """What a force element does to its second body, by its name or index; see ForceResult.

            power = result.force("spring").power

        model  for a result from a file, which has no laws of forces: the model of which it is, with the
               numbers, functions and initial state that it had (compared by `Model.hash`)

        It is by what the element's functions say now. Calls that are kept of the run are made again, and tell
        where that is something else, as what an event has changed meanwhile.

        Laws of the user's own (`joint_force`, `user_force`) are no force elements: call their functions.
        ModelError: no such force element. OptionError: a file without `model`, or another model.
        LinkworkWarning: functions do not say what they said in the run.
        """
        from linkwork.results import forces

        return forces.force(self, name, model)

    def joint_axes(self, name: Named) -> Floats:
        """
        The joint's x, y, z axes as columns (k, 3, 3), inertial; they are fixed in its first body.

            hinge = result.joint_axes("motor pin")[..., 2]
        """
        joint = self._place("joint", name)
        first, in_body = self._header.joint_bodies[joint, 0], self._header.joint_frame[joint, 0]
        if first < 0:
            return np.broadcast_to(in_body, (len(self), 3, 3))
        axes: Floats = rotation.matrix(self._field("q", np.s_[:, int(first), 3:])) @ in_body
        return axes

    # --- samples, for what must stay quick on large results ---

    def recorded(self, name: str, part: Any = np.s_[:]) -> Floats:
        """The part asked for of a recorded field, such as "q": `Header.frame_shapes` has all of them.

            last = result.recorded("q", -1)

        OptionError: there is no such field. IndexError: no such part of it, as of arrays.
        """
        known = self._header.frame_shapes()
        one_of(name, known, "field", "unknown_name")
        if name in ("reaction_force", "reaction_torque"):
            self._need_reactions()
        return self._field(name, part)

    def recorded_of(self, name: str, places: ArrayLike, every: int = 1) -> Floats:
        """Of some bodies or joints, by index, (k, places, ...) of a recorded field such as "q".

            ends = result.recorded_of("q", [0, -1])

        every  of every so manyth frame

        Of few places nothing else is read; of many some frames at a time. OptionError: no such field or
        place, or `every` is not a positive whole number.
        """
        _check_every(every)
        known = {field: shape for field, shape in self._header.frame_shapes().items() if shape}
        shape = known[one_of(name, known, "field", "unknown_name")]
        chosen = _places(places, shape[0])
        unique, back = np.unique(chosen, return_inverse=True)
        if not len(unique):
            return np.zeros((len(self.t[::every]), 0, *shape[1:]))
        if len(unique) <= FEW_PLACES:
            return self.recorded(name, (slice(None, None, every), unique))[:, back]
        each = every * max(1, READ_NUMBERS // math.prod(shape))
        pieces = [
            self.recorded(name, np.s_[first : first + each : every])[:, chosen]
            for first in range(0, len(self), each)
        ]
        return np.concatenate([np.zeros((0, len(chosen), *shape[1:])), *pieces])

    def sampled_positions(self, every: int) -> Floats:
        """Centers of mass (., n, 3) of every so manyth frame [m].

            every_tenth = result.sampled_positions(10)

        OptionError: not a whole number.
        """
        _check_every(every)
        bodies = max(1, self._header.body_count)
        each = every * max(1, READ_NUMBERS // (7 * bodies))
        pieces = [
            self._field("q", np.s_[first : first + each : every])[..., :3].copy()
            for first in range(0, len(self), each)
        ]
        return np.concatenate([np.zeros((0, self._header.body_count, 3)), *pieces])

    def sampled_reactions(self, every: int) -> Reaction:
        """Reactions (., J, 3) of every so manyth frame.

            every_tenth = result.sampled_reactions(10)

        OptionError: not a positive whole number.
        """
        _check_every(every)
        self._need_reactions()
        force, torque = (
            self._field(field, np.s_[::every]) for field in ("reaction_force", "reaction_torque")
        )
        return Reaction(force, torque)

    def joint_points(self, name: Named) -> Floats:
        """
        The joint's point on its first and on its second body (k, 2, 3), inertial [m].

            way = result.joint_points("pin")[:, 1]
        """
        joint = self._place("joint", name)
        points = np.empty((len(self), 2, 3))
        for side, (body, s) in enumerate(
            zip(self._header.joint_bodies[joint], self._header.joint_origin[joint], strict=True)
        ):
            q = self._field("q", np.s_[:, int(body)]) if body >= 0 else None
            points[:, side] = s if q is None else q[:, :3] + rotate(q[:, 3:], s)
        return points

    # --- energy and violation ---

    @property
    def kinetic_energy(self) -> Floats:
        """(k,) [J]"""
        return self._field("kinetic")

    @property
    def potential_energy(self) -> Floats:
        """Of gravity and springs (k,) [J]."""
        return self._field("potential")

    @property
    def energy(self) -> Floats:
        """Kinetic and potential energy (k,) [J]."""
        return self.kinetic_energy + self.potential_energy

    @property
    def work(self) -> Floats:
        """Done since the start by what has no potential: applied forces, dampers, driven joints (k,) [J].

        A run that goes on to the last bit counts from the start of the one before.
        """
        return self._field("work")

    @property
    def energy_error(self) -> Floats:
        """Energy that the method made or lost (k,) [J]: change of the energy, less the work."""
        return energy_error(self.energy, self.work)

    @property
    def violation(self) -> Floats:
        """Largest violation of the constraints (k, 3): max abs of Phi, Phi_dot and Phi_ddot."""
        return self._field("violation")

    # --- errors ---

    @property
    def verified(self) -> bool:
        """Whether a second, finer run was made beside this one: simulate(..., verify=True)."""
        return self._finer is not None

    def error_of(self, what: str, *name: Any, **how: Any) -> Any:
        """The estimated error of what is recorded, in its shape and unit, from the finer run of `verify`.

            sure = lw.simulate(model, t_end=0.1, step=1e-3, verify=True)
            error = sure.error_of("q")

        what       the name of a property or method of a result: "position", "energy", "reaction", "body", ...
        name, how  the arguments of the method: error_of("reaction", "pin").force (k, 3) is that of
                   reaction("pin").force

        At each time the largest of Richardson's estimates there and at the next frames; NaN after the end of
        the finer run. Frames between the times of an event in both runs are not compared where it changes the
        state. OptionError: the run was not verified, or has no such quantity.
        """
        if self._finer is None:
            raise OptionError(
                "error_of needs a second, finer run: simulate(..., verify=True)", code="not_verified"
            )
        ours, finer = (_quantity(result, what, name, how) for result in (self, self._finer.result))
        return difference(ours, finer, band(self.t, self._finer))

    # --- files, pictures, text ---

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write everything to an HDF5 file.

            result.save("motion.h5")

        overwrite  whether it may replace a file, which then stays until the new one is complete

        FileError: there is a file, `path` has the suffix of another kind of file, or cannot be written.
        """
        from linkwork.results import writing

        target = check_new(path, "result", overwrite)
        self._need_reactions()
        checkpoint = self._settled()
        writing.save(
            target,
            self._header,
            self._frames,
            self._statistics,
            self._run,
            self._events,
            checkpoint,
            self._finer,
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Result:
        """A result file, also of an interrupted run, or what is whole of a damaged one: see `missing`.

            result = lw.Result.load("motion.h5")

        FileError: there is no such file, it is damaged from the beginning, or of another kind.
        LinkworkWarning: it is damaged, and only a part of it was read.
        """
        return cls._read(path, warns=True)

    @classmethod
    def _read(
        cls, path: str | os.PathLike[str], *, written: Header | None = None, warns: bool = False
    ) -> Result:
        """`written`: a moment ago, with this header. LinkworkWarning: `warns`, and the file is damaged."""
        from linkwork.results import reading

        stored = reading.read(path_of(path, "result"), written=written)
        result = cls(stored.fields, stored.header, stored.statistics, run=stored.run, events=stored.events,
                     checkpoint=stored.checkpoint)  # fmt: skip
        if stored.finer is not None:
            factor, fields = stored.finer
            result._finer = Finer(cls(fields, stored.header, {}, run=stored.run), factor)
        if warns and stored.damage:
            warn(_told_of_damage(path, stored.damage, result))
        return result

    def to_frame(
        self,
        *,
        bodies: Sequence[Named] | None = None,
        joints: Sequence[Named] | None = None,
        quantities: Sequence[str] | None = None,
        forces: Sequence[str | int] | None = None,
    ) -> pandas.DataFrame:
        """A pandas.DataFrame over the time, a column a number, such as "crank.position.x [m]".

            result.to_frame(bodies=["crank"], quantities=["position", "coordinate"])

        bodies, joints  by name, index or handle; without, all, of an empty list none: likewise below
        quantities      of position, orientation, velocity, omega, acceleration, angular_acceleration,
                        reaction_force, reaction_torque, kinetic_energy, potential_energy, work, energy_error,
                        violation, coordinate (of joints, with their rates), and of force elements force,
                        torque, power, potential, deflection, deflection_angle (see ForceResult); without, all
        forces          elements by name or index; without, all. A result from a file knows no laws of forces:
                        its columns are without them

        `attrs` has the model and the unit of each column. OptionError: no such quantity, or no pandas:
        pip install 'linkwork[pandas]'. ModelError: no such body, joint or force element.
        """
        from linkwork.results import tables

        return tables.to_frame(self, tables.Choice(bodies, joints, quantities, forces))

    @overload
    def to_csv(
        self,
        path: None = None,
        *,
        bodies: Sequence[Named] | None = None,
        joints: Sequence[Named] | None = None,
        quantities: Sequence[str] | None = None,
        forces: Sequence[str | int] | None = None,
        overwrite: bool = False,
    ) -> str: ...  # fmt: skip

    @overload
    def to_csv(
        self,
        path: str | os.PathLike[str],
        *,
        bodies: Sequence[Named] | None = None,
        joints: Sequence[Named] | None = None,
        quantities: Sequence[str] | None = None,
        forces: Sequence[str | int] | None = None,
        overwrite: bool = False,
    ) -> None: ...  # fmt: skip

    def to_csv(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        bodies: Sequence[Named] | None = None,
        joints: Sequence[Named] | None = None,
        quantities: Sequence[str] | None = None,
        forces: Sequence[str | int] | None = None,
        overwrite: bool = False,
    ) -> str | None:
        """The columns of `to_frame` as CSV, every digit kept: to `path`, or returned where none is given.

            result.to_csv("motion.csv", bodies=["rod"])

        FileError: `path` is there already, is no .csv, or cannot be written. Others as for `to_frame`.
        """
        from linkwork.results import tables

        return tables.to_csv(self, path, tables.Choice(bodies, joints, quantities, forces), overwrite)

    def to_xarray(
        self,
        *,
        bodies: Sequence[Named] | None = None,
        joints: Sequence[Named] | None = None,
        quantities: Sequence[str] | None = None,
        forces: Sequence[str | int] | None = None,
    ) -> xarray.Dataset:
        """An xarray.Dataset with named axes: `found.position.sel(body="crank", xyz="x")` over the time.

            result.to_xarray().position.sel(body="rod", xyz="z")

        Every variable has its `units` and `long_name`, the data set the manifest. Angles and displacements of
        joints, and their rates, are over the joints that have them, deflections over springs. Arguments and
        errors as for `to_frame`; pip install 'linkwork[xarray]'.
        """
        from linkwork.results import tables

        return tables.to_xarray(self, tables.Choice(bodies, joints, quantities, forces))

    def plot(
        self,
        path: str | os.PathLike[str] | None = None,
        kind: str = "overview",
        *,
        bodies: Sequence[Named] = (),
        joints: Sequence[Named] = (),
        forces: Sequence[str | int] = (),
    ) -> Figure:
        """A figure of the run, written to `path` when given.

            result.plot("reactions.png", "reactions", joints=["pin"])

        kind    "overview": energy, violation, positions and reactions; or one of "energy", "violation",
                "positions", "velocities", "accelerations" (of bodies, the last two with those of rotations),
                "coordinates" (angles and displacements of joints), "reactions", "forces" (of force elements),
                "phase" (rates over coordinates), "step" (sizes of steps)
        bodies  by name, index or handle; without, those that move most
        joints  likewise; without, those with the largest reactions, or the first with a coordinate
        forces  by name or index; without, the largest. A result from a file knows no laws of forces

        Reactions that do not follow from the motion are dashed and marked. OptionError: no such kind, or it
        does not show what is chosen, or more than 20 of it. ModelError: no such body, joint or force element.
        FileError: `path` cannot be written, or is the name of a kind. A picture that is there is replaced.
        """
        from linkwork.plots import kinds

        return kinds.plot(self, path, kind, bodies, joints, forces)

    def index(self, what: Literal["body", "joint", "force"], name: Named) -> int:
        """Place of a body, a joint or a force element in the arrays, by name, index or handle.

            rod = result.index("body", "rod")

        ModelError: no such one.
        """
        if what != "force":
            return self._place(what, name)
        from linkwork.results import forces

        return forces.place(self, name)

    def movie(
        self,
        path: str | os.PathLike[str],
        *,
        seconds: float | None = None,
        frames_per_second: int = 25,
        size: tuple[int, int] = (960, 640),
    ) -> None:
        """Write the motion as a movie, .mp4 or .gif; no display is needed.

            result.movie("motion.gif", seconds=2, frames_per_second=10, size=(320, 200))

        seconds  that it lasts; without, as long as the motion, but between 2 and 20
        size     width and height [pixels], even

        .mp4 needs imageio-ffmpeg: pip install 'linkwork[movie]'. FileError: another format, or `path` cannot
        be written. OptionError: there are no frames, too much to paint, or more than 50 frames per second of
        a .gif.
        """
        from linkwork.view import movie

        movie.movie(self, path, seconds=seconds, frames_per_second=frames_per_second, size=size)

    def view(
        self,
        path: str | os.PathLike[str] | None = None,
        other: Result | None = None,
        *,
        labels: Sequence[str] = (),
        limit: float = 16e6,
    ) -> Page:
        """The motion as a page that opens in any browser, without a network; written to `path` when given.

            result.view("motion.html")

        other   a second run that is laid over this one, drawn as a ghost and by dashed lines
        labels  names of the two runs
        limit   of the recorded numbers in the page [bytes]; frames beyond are left out evenly, and it says so

        In a notebook the page shows itself; `result.view().open()` shows it in the browser.
        OptionError: there are no frames, or not two of them fit `limit`; what is no other result, or more
        labels than runs. FileError: `path` cannot be written.
        """
        from linkwork.view import view

        page = view(self._laid_over(other), labels, limit)
        if path is not None:
            page.save(path)
        return page

    def serve(self, other: Result | None = None, *, labels: Sequence[str] = (), port: int = 0) -> Server:
        """The page of `view` by a server for this machine alone, with all frames, however many there are: it
        asks for the poses near the time that it shows. A context manager; `close()` ends it.

            with result.serve() as server:
                print(server.url)

        other, labels  as of `view`
        port           0: a free one, see `url`

        OptionError: there are no frames, or the port is taken.
        """
        from linkwork.view.serving import Server

        return Server(self._laid_over(other), labels, port)

    def report(self, path: str | os.PathLike[str] | None = None) -> Page:
        """A page on the run: model, method, diagnostics, plots, viewer; written to `path` when given.

            result.report("report.html")

        FileError: `path` cannot be written. OptionError: there are no frames.
        """
        from linkwork.view.report import report

        page = report(self)
        if path is not None:
            page.save(path)
        return page

    def summary(self) -> str:
        """
        A few lines of plain text: what ran, how well, what it took.

            print(result.summary())
        """
        from linkwork.motion import summary

        return summary.text(self)

    def __getstate__(self) -> dict[str, Any]:
        """For pickle: a result can go to another process, with its reactions."""
        self._need_reactions()
        return {**self.__dict__, "_header": self._header.detached()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """What earlier versions pickled says of itself what it says today."""
        header = replace(state["_header"], manifest=renamed_manifest(state["_header"].manifest))
        self._checkpoint, self._strikes, self._energies_around_events = None, (), NOT_KNOWN
        self._listed = None
        given = state.get("_statistics", state.get("statistics"))  # the latter in those of version 0.1
        self.__dict__.update(state, _header=header, _statistics=renamed_statistics(given))
        self.t = read_only(self.t)

    def __fingerprint__(self) -> str:
        """Of the motion, whatever time it took: see linkwork.fingerprints."""
        digest = hashlib.blake2b(f"{self._header.manifest.get('model_hash')}".encode(), digest_size=16)
        digest.update(self.t.tobytes())
        for first in range(0, len(self), HASHED):
            for name in ("q", "v"):
                digest.update(
                    np.ascontiguousarray(self._field(name, np.s_[first : first + HASHED])).tobytes()
                )
        return digest.hexdigest()

    # --- how it works ---

    def _with_frames(self, frames: Mapping[str, Any]) -> Result:
        """The same run with other frames of it."""
        found = Result(frames, self._header, self._statistics, events=self._events)
        found._strikes, found._energies_around_events = self._strikes, self._energies_around_events
        return found

    def _field(self, name: str, part: Any = np.s_[:]) -> Floats:
        values: Floats = read_only(self._frames[name][part])
        return values

    def _laid_over(self, other: Result | None) -> list[Result]:
        """OptionError: `other` is no result."""
        if other is not None and not isinstance(other, Result):
            raise OptionError(f"other {other!r:.80} is no result of a run", code="other")
        return [self] if other is None else [self, other]

    def _need_reactions(self) -> None:
        """Evaluate the reactions of a result in memory, once."""
        if "reaction_force" not in self._frames:
            self._frames.update(record_reactions(self._header, self._frames))

    def _place(self, what: Literal["body", "joint"], name: Named) -> int:
        """Index of a body or joint given by name, index or handle."""
        one_of(what, ("body", "joint", "force"), "what")
        names = self.body_names if what == "body" else self.joint_names
        places = self._places.setdefault(what, {})
        if not places:
            places.update({known: place for place, known in enumerate(names)})
        return place_of(what, name, places)


def _told_of_damage(path: str | os.PathLike[str], damage: Sequence[str], found: Result) -> str:
    """What a damaged file has lost, what was read of it, and what to do."""
    told = f"result '{path}': the file is damaged; missing: {'; '.join(damage)}; "
    if not len(found):
        return told + "no frame could be read. Copy it again, or run again"
    read = f"{counted(len(found), 'frame')} to t = {found.t[-1]:g} s could be read"
    return told + f"{read}. Copy it again, run again, or write what is whole by `linkwork repair {path}`"


#: What `error_of` takes.
_QUANTITIES = (
    "q", "v", "position", "orientation", "velocity", "omega", "omega_inertial", "acceleration",
    "angular_acceleration", "body", "multipliers", "reactions", "reaction", "coordinate", "joint_axes",
    "joint_points", "kinetic_energy", "potential_energy", "energy", "work", "energy_error", "violation",
)  # fmt: skip


def _quantity(result: Result, what: str, name: tuple[Any, ...], how: Mapping[str, Any]) -> Any:
    """OptionError: there is none of that name."""
    if what not in _QUANTITIES:
        raise OptionError(
            f"'{what}' is no recorded quantity{nearest(str(what), _QUANTITIES)}", code="unknown_option"
        )
    found = getattr(result, what)
    return found(*name, **how) if callable(found) else found


def _places(given: ArrayLike, count: int) -> NDArray[np.intp]:
    """Of `count` that there are, from 0 on. OptionError: others, or no whole numbers."""
    places = array(given, "places").ravel()
    if not ((places == np.floor(places)) & (places >= -count) & (places < count)).all():
        raise OptionError(
            f"places {given!r:.80} are not whole numbers from 0 to {count - 1}, or from the end from -1 on",
            code="places",
        )
    found: NDArray[np.intp] = np.arange(count)[places.astype(int)]
    return found


def _check_every(every: object) -> None:
    if not isinstance(every, int | np.integer) or every < 1:
        raise OptionError(f"every {every!r:.80} is not a positive whole number of frames", code="every")
