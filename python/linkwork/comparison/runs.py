"""One cell of a comparison: a run, and its figures against the reference."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

import numpy as np

from linkwork.accuracy.measures import Differences, Sampled
from linkwork.arrays import Floats
from linkwork.comparison import order
from linkwork.comparison.choices import Cell
from linkwork.comparison.reference import ERRORS, Reference, largest
from linkwork.errors import (
    LinkworkError,
    ModelError,
    NotConvergedError,
    NotFiniteError,
    OptionError,
    SingularSystemError,
    StepSizeError,
    ViolationError,
)
from linkwork.modeling.model import Model
from linkwork.options import Policy, renamed
from linkwork.results.result import Result
from linkwork.running.estimation import unjudged
from linkwork.running.simulation import simulate

__all__ = ["ERRORS", "Curves", "Outcome", "Runs", "Sampling"]

Status = Literal["finished", "refused", "diverged", "singular", "failed", "lost"]

#: Frames of a run that are compared, if its steps allow that.
FRAMES, FEWEST_FRAMES = 200, 20

#: And the memory that they may take [bytes].
RUN_BYTES = 2**28

#: Kept of the statistics of a run.
COUNTS = ("steps", "rejected_steps", "evaluations", "factorizations", "iterations", "singular_poses")

#: A state error this large says that the motion is another one.
WRONG = 1.0

#: Short runs are repeated until they took so long together [s], at most so often; the shortest time counts.
SHORT_SECONDS, REPEATS = 0.1, 9

#: Numbers of steps that differ from a whole one by this part are whole.
WHOLE = 1e-6

#: Times, relative to the end of the run: so near to it they are the end, and so near to each other one.
AT_END, SAME_TIME = 1e-9, 1e-10


@dataclass(frozen=True)
class Curves:
    """Over time, at the frames that were compared."""

    t: Sequence[float]  # [s]
    state_error: Sequence[float]
    violation: Sequence[Sequence[float]]  # of positions, velocities, accelerations
    energy_error: Sequence[float]  # [J]


@dataclass(frozen=True)
class Outcome:
    """The figures of one cell: None where there is nothing to measure. Largest over the compared frames.

    method     equal for cells that differ in their step alone; `label` says it in words
    status     finished; refused before the first step; diverged: what is not finite, does not converge or
               has no step that is small enough; singular: a pose or a matrix that stopped the run; failed:
               another error; lost: the process died or was too slow
    reason     of a cell that did not finish
    t_reached  [s]
    errors     see linkwork.accuracy.measures; `reaction_error` of joints with unique reactions alone;
               `estimated_error` is what the run says of itself, see Result.verdict
    seconds    wall time of the steps, without the setup; the shortest of up to nine for short runs
    """

    method: str
    label: str
    resolution: str
    options: Mapping[str, Any]
    step: float | None
    rtol: float | None
    status: Status
    reason: str = ""
    remarks: Sequence[str] = ()
    t_reached: float | None = None
    pose_error: float | None = None
    velocity_error: float | None = None
    state_error: float | None = None
    reaction_error: float | None = None
    estimated_error: float | None = None
    position_violation: float | None = None
    velocity_violation: float | None = None
    acceleration_violation: float | None = None
    energy_error: float | None = None
    steps: int | None = None
    rejected_steps: int | None = None
    evaluations: int | None = None
    factorizations: int | None = None
    iterations: int | None = None
    singular_poses: int | None = None
    seconds: float | None = None
    curves: Curves | None = field(default=None, repr=False)

    @property
    def verdict(self) -> str:
        """The status in words; a motion that has nothing to do with the reference is not just finished."""
        if self.status == "finished":
            return "finished" if self.state_error is None or self.state_error < WRONG else "wrong"
        reached = f" at {self.t_reached:.4g} s" if self.t_reached is not None else ""
        return f"{self.status}{reached}"

    def figures(self) -> dict[str, Any]:
        """Everything but the curves."""
        return {name: value for name, value in asdict(self).items() if name != "curves"}

    @classmethod
    def from_figures(cls, figures: Mapping[str, Any]) -> Outcome:
        """The inverse of `dataclasses.asdict`."""
        curves = figures.get("curves")
        options = renamed(figures["options"])
        return cls(**{**figures, "options": options, "curves": Curves(**curves) if curves else None})


@dataclass(frozen=True)
class Sampling:
    """At which frames the cells are compared: the same times for all where their steps allow it.

    t_end      [s]
    intervals  of the common times, 0 where there are none
    most       frames of one run
    """

    t_end: float
    intervals: int
    most: int = FRAMES

    @classmethod
    def of(cls, t_end: float, steps: Sequence[float], frame_bytes: int = 0) -> Sampling:
        """`frame_bytes`: what a frame of the model takes; large models have fewer frames."""
        most = min(FRAMES, max(2, RUN_BYTES // max(frame_bytes, 1)))
        counts = [t_end / step for step in steps]
        whole = [round(count) for count in counts]
        if any(abs(c - n) > WHOLE * max(n, 1) or not n for c, n in zip(counts, whole, strict=True)):
            return cls(t_end, 0, most)
        common = math.gcd(*whole) if whole else most
        intervals = max(n for n in range(1, min(most, common) + 1) if common % n == 0)
        return cls(t_end, intervals if intervals >= min(FEWEST_FRAMES, most) else 0, most)

    def every(self, step: float) -> int:
        """Steps between frames of a run with a fixed step [s]."""
        count = max(1, round(self.t_end / step))
        return count // self.intervals if self.intervals else max(1, count // self.most)

    def times(self, steps: Sequence[float]) -> Floats:
        """At which the reference is needed."""
        grids: list[Any] = [np.linspace(0.0, self.t_end, (self.intervals or self.most) + 1)]
        if not self.intervals:
            for step in steps:
                grid = step * self.every(step) * np.arange(1, int(self.t_end / step / self.every(step)) + 1)
                grids.append(grid[grid < self.t_end * (1 - AT_END)])
        times = np.sort(np.concatenate(grids))
        apart: Floats = times[np.concatenate([[True], np.diff(times) > SAME_TIME * self.t_end])]
        return apart

    def arguments(self, cell: Cell, times: Floats | None) -> dict[str, Any]:
        """For `simulate`: where it records. `times`: of a reference that was given."""
        if cell.step is None:
            usual = np.linspace(0.0, self.t_end, (self.intervals or self.most) + 1)
            return {"times": usual if times is None else times[times <= self.t_end]}
        if times is None or len(times) < 2:
            return {"record_every": self.every(cell.step)}
        apart = float(np.min(np.diff(times))) / cell.step
        return {"record_every": round(apart) if abs(apart - round(apart)) < WHOLE and apart > 0.5 else 1}


@dataclass(frozen=True)
class Runs:
    """What every cell has in common."""

    model: Model
    t_end: float
    sampling: Sampling
    reference: Reference
    times: Floats | None  #: of a reference that was given
    on_inaccurate: Policy = "pass"

    def __call__(self, item: Cell | order.Study) -> Outcome | order.OrderStudy:
        return self.cell(item) if isinstance(item, Cell) else self.study(item)

    def study(self, study: order.Study) -> order.OrderStudy:
        """Errors at steps that are halved; coarse ones may fail, later a failure is the end."""
        base = self.sampling.arguments(Cell(study.choice, step=study.largest), self.times)["record_every"]
        found: dict[float, dict[str, float | None]] = {}
        own = self.reference.error or {}
        floors = {name: max(order.ROUNDING, order.ABOVE_REFERENCE * own.get(name, 0.0)) for name in ERRORS}
        for division in study.divisions:
            # frames at multiples of the time between those of the largest step
            every = base * 2**division if division >= 0 else base // math.gcd(base, 2**-division)
            step = study.largest / 2.0**division
            try:
                result = self._quietly(step, int(every), study)
                errors = self.reference.errors(Sampled.of(result))
            except Exception:  # whatever it was: the cells of the grid say so
                if found:
                    break
                continue
            found[step] = _numbers(errors)
            tiny = all(errors[name] <= floors[name] for name in ("pose_error", "velocity_error"))
            if tiny or float(result.statistics["seconds"]) > order.LONGEST_SECONDS:
                break
        by_error = {name: [errors[name] for errors in found.values()] for name in ERRORS}
        nominal = getattr(study.choice.integrator, "order", None)
        return order.OrderStudy(study.choice.key, study.choice.label, list(found), by_error, floors, nominal)

    def _quietly(self, step: float, every: int, study: order.Study) -> Result:
        with warnings.catch_warnings(), unjudged():
            warnings.simplefilter("ignore")
            given = Cell(study.choice, step=step).options()
            return simulate(
                self.model,
                order.WINDOW * self.t_end,
                record_every=every,
                progress=False,
                on_inaccurate="pass",
                **given,
            )

    def cell(self, cell: Cell) -> Outcome:
        """Run a cell; whatever it does is an outcome."""
        try:
            given = {**cell.options(), **self.sampling.arguments(cell, self.times)}
        except OptionError as error:
            return self._without_result(cell, "refused", error, ())
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                result, seconds = self._timed(given)
                return self._figures(cell, result, seconds, caught)
            except (OptionError, ModelError) as error:
                return self._without_result(cell, "refused", error, caught)
            except LinkworkError as error:
                return self._without_result(cell, _kind(error), error, caught)
            except MemoryError:
                return self._without_result(cell, "failed", "not enough memory", caught)
            except Exception as error:  # of a function of the user's, in the model or the integrator
                return self._without_result(cell, "failed", f"{type(error).__name__}: {error}", caught)

    def _timed(self, given: Mapping[str, Any]) -> tuple[Result, float]:
        def run(policy: Policy) -> Result:
            return simulate(self.model, self.t_end, progress=False, on_inaccurate=policy, **given)

        result = run(self.on_inaccurate)
        spent = [float(result.statistics["driver_seconds"])]
        with unjudged():
            while sum(spent) < SHORT_SECONDS and len(spent) < REPEATS:
                spent.append(float(run("pass").statistics["driver_seconds"]))
        return result, min(spent)

    def _figures(
        self, cell: Cell, result: Result, seconds: float, caught: Sequence[warnings.WarningMessage]
    ) -> Outcome:
        differences = Differences.between(Sampled.of(result), self.reference.motion)
        errors = largest(differences, self.reference.scales)
        state = differences.state(self.reference.scales)
        compared = np.isin(result.t, differences.t)
        counted = {name: int(result.statistics.get(name, 0)) for name in COUNTS}
        curves = Curves(
            differences.t.tolist(), _list(state), result.violation[compared].tolist(),
            _list(result.energy_error[compared]),
        )  # fmt: skip
        own = {"estimated_error": result.verdict.error if result.verdict is not None else np.nan}
        figures: dict[str, Any] = {
            **_numbers({**errors, **own}), **_observed(result), **counted, "seconds": seconds,
        }  # fmt: skip
        return Outcome(
            **_identity(cell, result.manifest["options"]),
            status="finished",
            remarks=_texts(caught),
            t_reached=float(result.t[-1]),
            curves=curves,
            **figures,
        )

    def _without_result(
        self,
        cell: Cell,
        status: Status,
        error: LinkworkError | str,
        caught: Sequence[warnings.WarningMessage],
    ) -> Outcome:
        result = getattr(error, "result", None)
        reached = getattr(error, "time", None)
        if reached is None and result is not None and len(result):
            reached = float(result.t[-1])
        observed: dict[str, Any] = _observed(result) if result is not None and len(result) else {}
        return Outcome(**_identity(cell, {}), status=status, reason=str(error), t_reached=reached,
                       remarks=_texts(caught), **observed)  # fmt: skip


def lost(item: Cell | order.Study, reason: str) -> Outcome | order.OrderStudy:
    """Of one whose process gave no answer."""
    if isinstance(item, Cell):
        return Outcome(**_identity(item, {}), status="lost", reason=reason)
    nothing: dict[str, list[float | None]] = {name: [] for name in ERRORS}
    return order.OrderStudy(item.choice.key, item.choice.label, [], nothing, dict.fromkeys(ERRORS, 0.0))


def _identity(cell: Cell, chosen: Mapping[str, Any]) -> dict[str, Any]:
    """`options`: as chosen, or as asked for where the run did not begin."""
    asked = {name: _said(value) for name, value in cell.choice.options.items()}
    names = ("formulation", "matrix_form", "stabilization", "integrator", "linear_solver")
    found = {name: chosen[name] for name in names if chosen.get(name) is not None}
    return {
        "method": cell.choice.key,
        "label": cell.choice.label,
        "resolution": cell.resolution,
        "options": {**asked, **found},
        "step": cell.step,
        "rtol": cell.rtol,
    }


def _texts(caught: Sequence[warnings.WarningMessage]) -> list[str]:
    return list(dict.fromkeys(str(it.message) for it in caught))


def _said(value: Any) -> Any:
    """An option as a file can hold it: methods by their names."""
    return value if isinstance(value, str | int | float | bool | None) else str(getattr(value, "name", value))


def _kind(error: LinkworkError) -> Status:
    if isinstance(error, NotFiniteError | NotConvergedError | StepSizeError | ViolationError):
        return "diverged"
    return "singular" if isinstance(error, SingularSystemError) else "failed"


def _observed(result: Result) -> dict[str, float | None]:
    violation = result.violation.max(axis=0)
    return _numbers({
        "position_violation": violation[0],
        "velocity_violation": violation[1],
        "acceleration_violation": violation[2],
        "energy_error": np.abs(result.energy_error).max(),
    })  # fmt: skip


def _numbers(values: Mapping[str, Any]) -> dict[str, float | None]:
    """NaN and infinity are None: there is nothing to measure."""
    return {name: float(value) if np.isfinite(value) else None for name, value in values.items()}


def _list(values: Floats) -> list[float]:
    return [float(value) for value in values]
