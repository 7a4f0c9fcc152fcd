"""The frames of a run on their way to memory or to a file."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import replace
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core, memory
from linkwork.arguments import array
from linkwork.arrays import Floats
from linkwork.equations.system import System
from linkwork.errors import FileError, LinkworkError, OptionError, carry, counted, warn
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.motion.header import Header, frame_shapes, record_reactions
from linkwork.motion.records import Checkpoint, Occurrence, Snapshot, Strike
from linkwork.motion.state_names import StateNames
from linkwork.results.result import Result
from linkwork.running.interrupts import Interrupts
from linkwork.running.laws_of_forces import LawsOfForces
from linkwork.running.progress import Report
from linkwork.running.resuming import Identity
from linkwork.running.seen_in_frames import warn_of_what_frames_show
from linkwork.running.short_steps import ShortSteps, Suspects

if TYPE_CHECKING:
    from linkwork.running.estimation import ErrorEstimator

__all__ = [
    "Checkpoints",
    "PythonStep",
    "Recorder",
    "StopIterationIsError",
    "frame_bytes",
    "pieces",
    "record",
    "recorder",
    "statistics_of",
]

Frames = Mapping[str, Floats]

#: An integrator of the user's own: step(system, t, y, h) -> y at t + h, y (13n,).
PythonStep = Callable[[System, float, Floats, float], ArrayLike]

#: A piece of a run, between two looks at signals and progress: wall time [s], frames, bytes.
PIECE_SECONDS, PIECE_FRAMES, PIECE_BYTES = 0.1, 500, 2**26


#: Singular poses that a run warns of each by itself.
TOLD = 10

#: Of frames in memory, between two looks at how much is left.
LOOK_BYTES = 2**28


class Recorder(Protocol):
    """Where frames go.

    takes_more  whether the frames that are still in the run are to be written after an error
    abandon     what there is after an error; `statistics`: none, of a run that was interrupted
    """

    def write(self, frames: Frames) -> None: ...
    def note(self, occurrences: Sequence[Occurrence]) -> None: ...
    def takes_more(self, error: BaseException) -> bool: ...
    def abandon(self, error: BaseException, statistics: Mapping[str, Any]) -> Result | None: ...
    def result(self, statistics: Mapping[str, Any], laws: LawsOfForces) -> Result: ...


class Checkpoints:
    """Where a run can be gone on from to the last bit."""

    def __init__(self, run: _core.Run, identity: Identity) -> None:
        self._run, self._identity = run, identity

    def of_frames(self) -> Checkpoint | None:
        """For the last frame that the run gave out."""
        return self._of(self._run.checkpoint)

    def of_state(self) -> Checkpoint | None:
        """For its last state."""
        return self._of(self._run.last_checkpoint)

    def _of(self, found: tuple[float, bytes] | None) -> Checkpoint | None:
        return None if found is None else self._identity.checkpoint(*found)


class _Memory:
    def __init__(self, header: Header, checkpoints: Checkpoints, model: Model) -> None:
        self._header, self._checkpoints, self._model = header, checkpoints, model
        self._bytes = self._looked_at = 0
        frames = header.expected_frames or 0
        self._check_memory(8.0 * frames * sum(map(math.prod, header.frame_shapes().values())), frames)
        self._pieces: list[Frames] = []
        self._occurrences: list[Occurrence] = []

    def write(self, frames: Frames) -> None:
        if len(frames["t"]):
            self._pieces.append(frames)
            self._bytes += sum(field.nbytes for field in frames.values())
            if self._bytes > self._looked_at + LOOK_BYTES:
                self._looked_at = self._bytes
                self._check_memory(float(self._bytes), None)

    def _check_memory(self, needed: float, frames: int | None) -> None:
        """OptionError: before the run that its frames, or in it that as many again, are too many."""
        there = memory.available()
        if needed <= there:
            return
        what = "the frames so far" if frames is None else f"its {frames} frames"
        raise OptionError(
            f"the run is recorded in memory, where {what} need {memory.in_words(needed)}, and there are "
            f"{memory.in_words(there)}: give output='run.h5', or record fewer frames (record_every, times)",
            code="memory",
        )

    def note(self, occurrences: Sequence[Occurrence]) -> None:
        self._occurrences.extend(occurrences)

    def takes_more(self, error: BaseException) -> bool:
        return True

    def abandon(self, error: BaseException, statistics: Mapping[str, Any]) -> Result | None:
        return self.result(statistics, LawsOfForces(self._model)) if self._pieces else None

    def result(self, statistics: Mapping[str, Any], laws: LawsOfForces) -> Result:
        pieces, self._pieces = [dict(piece) for piece in self._pieces], []
        joined = {  # field by field, or memory would have to hold everything twice
            name: np.concatenate([piece.pop(name) for piece in pieces]) for name in list(pieces[0])
        }
        checkpoint = self._checkpoints.of_frames()
        header = replace(self._header, unlike_run=laws)
        return Result(joined, header, statistics, events=self._occurrences, checkpoint=checkpoint)


class _File:
    """Frames of more than LARGE_BYTES may be interrupted, and do not count then."""

    def __init__(
        self,
        path: str | os.PathLike[str],
        header: Header,
        checkpoints: Checkpoints,
        interrupts: Interrupts,
    ) -> None:
        from linkwork.results.writing import LARGE_BYTES, ResultWriter

        self._header, self._interrupts = header, interrupts
        self._large = 8 * sum(map(math.prod, header.frame_shapes().values())) > LARGE_BYTES
        self._writer = ResultWriter(path, header, checkpoint=checkpoints.of_frames, pause=interrupts.check)

    def write(self, frames: Frames) -> None:
        if self._large:
            with self._interrupts.computing():
                frames = record_reactions(self._header, frames)
        self._writer.write(frames)

    def note(self, occurrences: Sequence[Occurrence]) -> None:
        self._writer.write_events(occurrences)

    def takes_more(self, error: BaseException) -> bool:
        return not (self._large and isinstance(error, KeyboardInterrupt))

    def abandon(self, error: BaseException, statistics: Mapping[str, Any]) -> Result | None:
        try:
            self._writer.close(statistics or None, hurried=isinstance(error, KeyboardInterrupt))
            return self._own()
        except FileError as failure:
            if failure.code == "replaced":
                return None
            raise

    def result(self, statistics: Mapping[str, Any], laws: LawsOfForces) -> Result:
        self._writer.close(statistics)
        return self._own()

    def _own(self) -> Result:
        """FileError: in the moment since it was closed, it was removed, or another run took its place."""
        from linkwork.results.writing import replaced

        if not self._writer.begun:
            raise replaced(self._writer.path, "stayed what it was")
        try:
            found = Result._read(self._writer.path, written=self._header)
        except FileError as error:
            if error.code != "not_found":
                raise
            raise replaced(self._writer.path, "was moved or removed") from error
        if found._run != self._writer.run:
            raise replaced(self._writer.path, "was replaced by that of another run")
        return found


def recorder(
    output: str | os.PathLike[str] | None,
    header: Header,
    checkpoints: Checkpoints,
    interrupts: Interrupts,
    model: Model,
) -> Recorder:
    """To a file, or to memory. FileError: the file cannot be written."""
    if output is None:
        return _Memory(header, checkpoints, model)
    return _File(output, header, checkpoints, interrupts)


def frame_bytes(model: Model) -> int:
    """Of one recorded frame."""
    shapes = frame_shapes(model.body_count, model.joint_count, model.row_count)
    return 8 * sum(math.prod(shape) for shape in shapes.values())


def record(
    run: _core.Run,
    pieces: Iterator[Frames],
    to: Recorder,
    report: Report,
    labels: Sequence[str],
    estimator: ErrorEstimator,
    interrupts: Interrupts,
    *,
    t_end: float,
    warns: bool = False,
    forces: Callable[[], Suspects] = Suspects,
) -> float:
    """Write the pieces as they come; the time they took [s].

    `labels` of the events, in the order in which the run knows them; `t_end` [s]; `forces` that may be why
    steps are short. LinkworkWarning: `warns`, and the run has passed a singular pose; steps are
    very short. AccuracyError: `estimator` stops it.
    """
    spent, before, warned = 0.0, time.perf_counter(), 0
    violation: float | None = None
    follows = isinstance(run, _core.AdaptiveSimulation)
    short_steps = ShortSteps(
        run.t, run.steps_done, t_end, lambda: run.last_state, forces if follows else None
    )
    for frames in short_steps.explained(pieces):
        spent += time.perf_counter() - before
        to.note(_occurrences(run, labels))
        to.write(frames)
        with interrupts.computing():
            estimator.look(frames)
        if len(frames["t"]):
            violation = float(np.ravel(frames["violation"])[-3])  # of positions, at the last frame
        report(run.t, run.steps_done, violation)
        short_steps.look(run.t, run.steps_done)
        estimator.told_of_steps = short_steps.told
        if warns:
            warned = warn_of_singular_poses(run.statistics(), warned)
        before = time.perf_counter()
    if warns:
        warn_of_more_singular_poses(run.statistics())
    return spent


@contextmanager
def kept(
    run: _core.Run, to: Recorder, labels: Sequence[str], checkpoints: Checkpoints, names: StateNames
) -> Iterator[None]:
    """Close the file where the run, or what is said about it at the end, does not come to its end."""
    try:
        yield
    except BaseException as error:
        _abandon(run, to, labels, error, checkpoints, names)
        raise


def _abandon(
    run: _core.Run,
    to: Recorder,
    labels: Sequence[str],
    error: BaseException,
    checkpoints: Checkpoints,
    names: StateNames,
) -> None:
    """Keep what there is, and say in the error how far the run came."""
    try:
        to.note(_occurrences(run, labels))
        if to.takes_more(error):
            to.write(run.take_frames(at_the_end=True))
    finally:
        statistics = {**statistics_of(run), "failed": True} if isinstance(error, Exception) else {}
        result = to.abandon(error, statistics)
        if isinstance(error, Exception):
            state = Snapshot.of(run.t, run.last_state, run.history)._replace(names=names)
            carries = carry(error, result=result, state=state.resumable(checkpoints.of_state(), run.work))
            if not isinstance(error, LinkworkError):  # of the user's own function
                there = f"; its `result` has {counted(len(result), 'frame')}" if carries and result else ""
                error.add_note(f"linkwork: in the step after t = {run.t:.6g} s{there}")
            if result is not None:
                result._statistics.update(statistics)  # also of a file that had no room for them
                warn_of_what_frames_show(result)
        else:
            carry(error, result=result)


def statistics_of(run: _core.Run) -> dict[str, Any]:
    """At its end: with how joints turned between frames, which may be as much as these."""
    turned = run.turned
    return {**run.statistics(), **({"turned": turned} if turned else {})}


def warn_of_singular_poses(statistics: Mapping[str, Any], warned: int) -> int:
    """Of how many it has been warned; LinkworkWarning: of each after the first `warned`, up to TOLD."""
    poses = [it for it in statistics["singularity_crossings"] if not it["rows_changed"]][:TOLD]
    for place, it in enumerate(poses[warned:], start=warned):
        names = ", ".join(f"'{name}'" for name in it["joints"])
        why = (
            f": the equations of {names} depend on each other for a moment, where the motion could go on in "
            "several ways"
        )
        same = place and it["joints"] == poses[place - 1]["joints"]
        warn(f"singular pose at t = {it['t']:.6g} s{', of the same joints' if same else why}")
    return len(poses)


def warn_of_more_singular_poses(statistics: Mapping[str, Any]) -> None:
    """LinkworkWarning, at the end of a run: it has passed more than it was warned of."""
    poses = [it["t"] for it in statistics["singularity_crossings"] if not it["rows_changed"]]
    more = statistics["singular_poses"] - len(poses[:TOLD])
    if more > 0:
        warn(f"singular poses: {more} more up to t = {poses[-1]:.6g} s: see Result.singular_poses")


def _occurrences(run: _core.Run, labels: Sequence[str]) -> list[Occurrence]:
    if not isinstance(run, _core.AdaptiveSimulation):
        return []
    return [Occurrence.of(labels[event], *rest) for event, *rest in run.take_occurrences()]


def add_sides(result: Result, run: _core.Run) -> None:
    """What was around strikes of drivers, and energies around events, in the whole run; these by place."""
    if isinstance(run, _core.AdaptiveSimulation):
        result._listed = run.listed_events
        result._strikes = tuple(Strike(*it) for it in run.take_strikes())
        energies = np.asarray(run.energies_around_events(), dtype=float)
        result._energies_around_events = energies.reshape(-1, 2, 3)


def pieces(
    run: _core.Run, interrupts: Interrupts, method: Integrator | PythonStep, system: System
) -> Iterator[Frames]:
    """The frames as they come."""
    if isinstance(run, _core.Simulation) and not isinstance(method, Integrator):
        return _python_pieces(run, interrupts, method, system)
    return _compiled_pieces(run, interrupts, frame_bytes(system.model))


def _compiled_pieces(run: _core.Run, interrupts: Interrupts, frame_bytes: int) -> Iterator[Frames]:
    """The compiled driver, which returns now and then so that signals are honored and progress is shown."""
    most_frames = max(1, min(PIECE_FRAMES, PIECE_BYTES // frame_bytes))
    if run.finished:  # by somebody who took its steps beside those of other runs
        yield run.take_frames(at_the_end=True)
    while not run.finished:
        with interrupts.computing(), StopIterationIsError():
            run.advance(most_frames, PIECE_SECONDS)
        yield run.take_frames()


class StopIterationIsError(AbstractContextManager[None]):
    """OptionError: StopIteration of a function of the user's, which would only end an iteration of ours."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        if isinstance(error, StopIteration):
            raise OptionError(
                "a function of the model or the run raised StopIteration: let it return a value",
                code="callback",
            ) from error


def _python_pieces(
    run: _core.Simulation, interrupts: Interrupts, step: PythonStep, system: System
) -> Iterator[Frames]:
    """The user's own integrator."""
    finished = False
    while not finished:
        with interrupts.computing(), StopIterationIsError():
            finished = _steps(run, step, system, time.perf_counter() + PIECE_SECONDS)
        yield run.take_frames(at_the_end=True)


def _steps(run: _core.Simulation, step: PythonStep, system: System, until: float) -> bool:
    """Steps until that wall time; True at the end of the run."""
    while time.perf_counter() < until:
        t, y, h = run.begin_step()
        if h == 0.0:
            return True
        reached = array(step(system, t, y, h), f"integrator {step!r}: the state that it returned")
        if reached.shape != y.shape:
            raise OptionError(
                f"integrator {step!r}: returned shape {reached.shape}, y has {y.shape} (t = {t:g} s)",
                code="integrator",
            )
        if not np.isfinite(reached).all():
            raise OptionError(
                f"integrator {step!r}: returned a state that is not finite (t = {t:g} s)", code="integrator"
            )
        run.accept(reached)
    return False
