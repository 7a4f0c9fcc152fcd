"""`simulate_many`: from a model and its variations to the motions of all of them."""

from __future__ import annotations

import inspect
import time
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from linkwork import memory
from linkwork.arguments import check_switch, whole
from linkwork.arrays import Floats
from linkwork.comparison.workers import processor_count
from linkwork.ensemble.outcome import DIMENSIONS, OWN, TRAJECTORIES, EnsembleResult, whole_number
from linkwork.errors import LinkworkError, LinkworkWarning, OptionError, carry, warn
from linkwork.fingerprints import digests
from linkwork.modeling.model import Model, check_model
from linkwork.options import TABLE, check_number, check_option
from linkwork.results.result import Result
from linkwork.running import checks, recording, schedule
from linkwork.running.events import events_of
from linkwork.running.leaving_no_memory import called, leaving_no_memory
from linkwork.running.manifest import platform_facts
from linkwork.running.members import Member, Method, method_of, run_members
from linkwork.running.progress import ShowOption, counting
from linkwork.running.remarks import remarked
from linkwork.running.simulation import check_run, simulate
from linkwork.studies import outputs as wanted
from linkwork.studies.cases import Run, check_times, in_one, kept
from linkwork.studies.collected import Collected
from linkwork.studies.followed import LEAST, apart, last_followed, of_the_others
from linkwork.studies.lanes import PACK
from linkwork.studies.notes import MULTIPLIERS, noted, warn_of_notes
from linkwork.studies.sampling import Cases, cases_of
from linkwork.studies.study import array_of
from linkwork.studies.sweeping import check_names, checked_outputs, probe
from linkwork.studies.variants import Built, Source, source_of

__all__ = ["Ensemble", "simulate_many"]

#: Members that are made and simulated at a time, for each thread: some packs of the widest registers.
AT_ONCE = 4 * PACK

#: Arguments of `simulate` that an ensemble has in another way, or cannot have.
OTHERS = {
    "output": "an ensemble keeps arrays; Ensemble.single simulates one member by itself",
    "overwrite": "an ensemble keeps arrays; Ensemble.single simulates one member by itself",
    "start": "give the models another initial state, model.with_initial_state(q, v)",
    "verify": "Ensemble.single simulates one member by itself",
    "progress": "it is that of the ensemble",
}


def simulate_many(
    model: Model | Callable[..., Model] | Sequence[Model],
    variations: Any = None,
    t_end: float | None = None,
    step: float | None = None,
    *,
    sampler: Any = None,
    cases: int | None = None,
    seed: int | None = None,
    **arguments: Any,
) -> EnsembleResult:
    """Simulate many mechanisms of one structure at once: `Ensemble(model, variations).simulate(t_end, step)`.

        many = lw.simulate_many(model, {"rod.mass": [1, 2, 3]}, 2.0, step=1e-3)

    For what the arguments are see Ensemble and Ensemble.simulate.
    """
    if t_end is None:
        raise OptionError("t_end is missing: simulate_many(model, variations, t_end, step)", code="t_end")
    return Ensemble(model, variations, sampler=sampler, cases=cases, seed=seed).simulate(
        t_end, step, **arguments
    )


class Ensemble:
    """n mechanisms: variations of a model by path, of a function, or the models of a list.

    model       a model, whose parameters are named by path as in `sweep`: "crank.mass", "motor pin.at[2]",
                "rod.omega", "gravity[2]"; a function build(**parameters) -> Model; or a list of models
    variations  {name: values}: a grid, full factorial. A list of mappings, a table of pandas, an array with
                named fields: a member a row. With a sampler {name: (low, high)} or distributions
    sampler     "grid", "table", "random", "sobol", "halton", "latin_hypercube", or an engine of
                scipy.stats.qmc. None: a grid or a table, "random" where all are distributions
    cases       how many members, of a sampler
    seed        of a sampler

    Members whose bodies, joints and redundant equations are the same run side by side in the lanes of the
    processor's registers: 8 with AVX-512, 4 with AVX2, else 2. All else may differ: masses, points, axes,
    parameters, functions of time, forces, gravity, the initial state.

    OptionError, ModelError: a path that leads nowhere, values of another shape, no members.
    """

    def __init__(
        self, model: Model | Callable[..., Model] | Sequence[Model], variations: Any = None, *,
        sampler: Any = None, cases: int | None = None, seed: int | None = None,
    ) -> None:  # fmt: skip
        self._members = _members(model, variations, sampler, cases, seed)

    def __len__(self) -> int:
        return len(self._members)

    def __repr__(self) -> str:
        return f"<Ensemble: {len(self)} members of {', '.join(self.parameters) or 'a list of models'}>"

    @property
    def parameters(self) -> Mapping[str, np.ndarray[Any, Any]]:
        """By name: values (n, ...); what no array can hold in words."""
        return {name: array_of(values) for name, values in self._members.columns.items()}

    def model(self, number: int) -> Model:
        """Of one member.

            heaviest = ensemble.model(2)

        OptionError: there is no such member. What its building raises.
        """
        return self._members.model(whole_number(number, len(self)))

    def single(self, number: int, t_end: float, step: float | None = None, **arguments: Any) -> Result:
        """
        One member by itself, `simulate(model, ..., deterministic=True)`: the same bits.

            print(ensemble.single(0, 0.1, step=1e-3).verdict)
        """
        model = self.model(number)
        with leaving_no_memory(called(model, arguments), logs=False):
            return simulate(model, t_end, step, **{"deterministic": True, **arguments})

    def simulate(
        self,
        t_end: float,
        step: float | None = None,
        integrator: Any = None,
        *,
        outputs: Any = None,
        times: ArrayLike | None = None,
        record_every: int | None = None,
        threads: int | None = None,
        follow_errors: bool = False,
        progress: ShowOption = None,
        **options: Any,
    ) -> EnsembleResult:
        """Simulate all members from t = 0 to `t_end` [s].

            many = ensemble.simulate(0.1, step=1e-3, outputs=["body('rod').position.z.min"])

        step          [s] fixed, or the largest with rtol or atol among the options
        integrator    as of `simulate`; None: "rk4", or "dopri5" with rtol or atol
        outputs       names of quantities as in `sweep`, "reaction('pin').force.max", "final", functions of a
                      Result: kept instead of motions, so that memory does not grow with time
        times         [s] of outputs that are arrays; multiples of the step
        record_every  steps between frames; None: about 1000 frames, with outputs every step, with rtol both
        threads       of this process; None: one a processor
        follow_errors whether the verdicts of all members know how errors grow in motion that is unstable or
                      chaotic: with rtol they do; in lanes at a fixed step, where that takes as long as some
                      to 30 members, those of one in 64, at least of 16
        progress      None: a line on a terminal or in a notebook; False: nothing
        options       of `simulate`. `deterministic` is always on

        Lanes have formulation "standard" by linear solver "block", explicit Runge-Kutta methods with a fixed
        step or steps that follow tolerances, each member its own, stabilization "sampled_baumgarte",
        "baumgarte" or "none". What they do not have, and members
        that leave their lane (a small pivot that nothing foretold), are simulated by themselves from the
        start: `EnsembleResult.alone` says which and why.

        Either way a member has the bits of its run by itself with deterministic=True, whatever its place, its
        neighbors, `threads` and the processor are. One that fails is kept as failed, and disturbs no other.

        OptionError: an option or output that does not exist or cannot be, before the first member.
        LinkworkWarning: members are more than 1 % off, errors of those that were followed grow as those of
        the others may, or functions remember calls. Ctrl-C ends it: the `result` of the KeyboardInterrupt has
        the members that are done, others have the status "skipped".
        """  # Long: its arguments are fifteen lines.
        started = time.perf_counter()
        check_number("t_end", t_end, positive=True, unit="s")
        options = _checked_options(options)
        count = processor_count() if threads is None else whole(threads, 1, "threads")
        check_switch("follow_errors", follow_errors)
        example = self._members.example()
        checks.warn_of_opposed_axes(example, example.compiled().q0)
        asked = None if outputs is None else wanted.outputs_of(outputs)
        _check_names(self._members, asked)
        warns = options.get("on_inaccurate", "warn") == "warn"
        arguments = {"step": step, "integrator": integrator, "record_every": record_every, **options,
                     "deterministic": True, "on_inaccurate": "pass"}  # fmt: skip
        wanted_times, arguments = _recorded(asked, times, float(t_end), arguments, example)
        last_state = asked is not None and times is None and all(it.at_end for it in asked)
        state_alone = asked is not None and all(it.of_state_alone for it in asked)
        method = method_of(example, float(t_end), arguments, count, judged=True, last_state=last_state,
                           state_alone=state_alone,
                           looked_at=any(it.by_user for it in asked or ()))  # fmt: skip
        _check_run(self._members, method)
        at_start = probe(example, arguments)
        if asked is not None:
            asked = told = checked_outputs(asked, at_start, wanted_times)
        else:
            _check_memory(len(self), method, example)
            told = [noted(MULTIPLIERS, at_start)]
        members = _Kept(len(self), asked, wanted_times, told)
        every = follow_errors or method.adaptive or bool(method.alone) or len(self) <= LEAST
        about = {**platform_facts(), "t_end": float(t_end), "step": step, "threads": count,
                 "follow_errors": every}  # fmt: skip
        try:
            # ctrl-C loses those under way, of which functions of Python take long
            follows = self._members.followed(every=every)
            self._carry_out(method, members, progress, PACK if example._calls else AT_ONCE, follows)
        except KeyboardInterrupt as stop:
            about["seconds"] = time.perf_counter() - started
            raise members.interrupted(stop, self, about) from stop
        found = members.outcome(self, {**about, "seconds": time.perf_counter() - started})
        if warns:
            members.warn_of_inaccurate(found)
        return found

    def _carry_out(
        self, method: Method, to: _Kept, progress: ShowOption, at_once: int, follows: Sequence[bool]
    ) -> None:
        at_once *= method.threads
        with counting(progress, len(self)) as report:
            for first in range(0, len(self), at_once):
                report(first, f"{first} of {len(self)} members")
                numbers = range(first, min(first + at_once, len(self)))
                models = [self._members.model_or_error(k) for k in numbers]
                found = run_members(models, method, follows[numbers.start : numbers.stop])
                for number, member in zip(numbers, found, strict=True):
                    to.keep(number, member)


# --- members ---


@dataclass(frozen=True)
class _Case:
    """The model of one case; it can go to other processes where the source can."""

    source: Source
    table: Cases

    def __call__(self, number: int) -> Model:
        return self.source.model(self.table.case(number))


@dataclass(frozen=True)
class _Members:
    columns: Mapping[str, Sequence[Any]]
    make: Callable[[int], Model]
    count: int
    units: Mapping[str, str]

    def __len__(self) -> int:
        return self.count

    def model(self, number: int) -> Model:
        return self.make(number)

    def model_or_error(self, number: int) -> Model | Exception:
        try:
            return self.make(number)
        except Exception as error:
            return error

    def followed(self, *, every: bool) -> Sequence[bool]:
        """Whether errors of each are followed as they grow."""
        if every:
            return [True] * self.count
        models = {} if self.columns else {"model": [self.make(k).hash() for k in range(self.count)]}
        keys = apart(digests("", self.columns or models))
        last = last_followed(keys)
        return [key <= last for key in keys]

    def example(self) -> Model:
        """The first that there is. What its building raises where none of the first has one."""
        first: Exception | None = None
        for k in range(min(self.count, 20)):
            found = self.model_or_error(k)
            if isinstance(found, Model):
                return found
            first = first or found
        assert first is not None
        raise first


def _members(model: Any, variations: Any, sampler: Any, cases: int | None, seed: int | None) -> _Members:
    if isinstance(model, list | tuple):
        if variations is not None or sampler is not None or cases is not None or seed is not None:
            raise OptionError("a list of models is varied already: leave variations out", code="conflict")
        for it in model:
            check_model(it)
        if not model:
            raise OptionError("model: the list of models is empty, so there is no member", code="parameters")
        return _Members({}, tuple(model).__getitem__, len(model), {})  # of a list that may be changed
    if variations is None:
        raise OptionError(
            "variations is missing: {name: values}, or give a list of models", code="parameters"
        )
    drawn = cases_of(variations, sampler, cases, seed)
    source = source_of(model, drawn.columns)
    table: Cases = drawn if isinstance(source, Built) else drawn.as_floats()
    units = source.units(list(table.columns))
    return _Members(table.columns, _Case(source, table), len(table), units)


# --- before the first ---


def _checked_options(options: Mapping[str, Any]) -> dict[str, Any]:
    """Each as often as there are members. OptionError: none of `simulate`, or one that an ensemble has in
    another way."""
    known = [*list(inspect.signature(simulate).parameters)[2:-1], *TABLE]
    for name in options:
        if name in OTHERS:
            raise OptionError(f"option '{name}' is none of an ensemble: {OTHERS[name]}", code="option")
        check_option(name, known)
    if (given := options.get("deterministic")) is not None and given is not True:
        raise OptionError(
            f"deterministic {given!r:.40}: members have the bits of deterministic runs; leave it out",
            code="deterministic",
        )
    checks.check_choices(options)
    if options.get("on_inaccurate") == "stop":
        raise OptionError(
            "on_inaccurate 'stop': members do not wait for each other; look at the result's `accuracy`",
            code="option",
        )
    return {**options, **({"events": events_of(options["events"])} if "events" in options else {})}


def _check_names(members: _Members, asked: Sequence[wanted.Output] | None) -> None:
    """OptionError: names that a data set of the result could not tell apart."""
    own = OWN if asked is not None else (*OWN, *TRAJECTORIES, *DIMENSIONS)
    taken = dict.fromkeys(own, "a part of the data set of every ensemble")
    check_names(taken, list(members.columns), [it.label for it in asked or ()])


def _recorded(
    asked: Sequence[wanted.Output] | None,
    times: ArrayLike | None,
    t_end: float,
    arguments: dict[str, Any],
    example: Model,
) -> tuple[Floats | None, dict[str, Any]]:
    """The times of arrays [s], and when frames are recorded. OptionError: times that have no frame."""
    if asked is None:
        if times is not None:
            raise OptionError("times are those of outputs: give outputs, or record_every", code="conflict")
        return None, arguments
    if arguments["record_every"] is None:
        del arguments["record_every"]
    return check_times(times, t_end, arguments, asked, example)


def _check_run(members: _Members, method: Method) -> None:
    """OptionError: a choice that does not exist, or that none of some members can honor."""
    refused: OptionError | None = None
    for k in sorted({0, len(members) // 2, len(members) - 1}):
        model = members.model_or_error(k)
        if isinstance(model, Exception):
            return
        try:
            with leaving_no_memory(method.functions(model), logs=True), warnings.catch_warnings():
                warnings.simplefilter("ignore", LinkworkWarning)
                check_run(model, method.plan, {"events": (), **method.given}, method.options)
            return
        except OptionError as error:
            refused = refused or error
        except LinkworkError:  # this member alone may fail
            return
    if refused is not None:
        raise refused


def _check_memory(count: int, method: Method, example: Model) -> None:
    """OptionError: the motions are too many."""
    plan = method.plan
    frames = plan.t_end / plan.step / plan.record_every + 2 if isinstance(plan, schedule.Fixed) else 1000
    needed, there = 2.0 * count * frames * recording.frame_bytes(example), memory.available()
    if needed > there:
        raise OptionError(
            f"the motions of {count} members need {memory.in_words(needed)}, and there are "
            f"{memory.in_words(there)}: give outputs=, or record fewer frames (record_every)",
            code="memory",
        )


# --- what is kept ---


class _Kept:
    def __init__(
        self, count: int, outputs: Sequence[wanted.Output] | None, times: Floats | None,
        told: Sequence[wanted.Output],
    ) -> None:  # fmt: skip
        self._outputs, self._times, self._told = outputs, times, told
        self._found = Collected([str(k) for k in range(count)])
        self._results: dict[int, Result] = {}
        self._alone: dict[int, str] = {}
        self._in_lanes = 0
        self._doubts: dict[int, str] = {}  # of verdicts that are not good

    def keep(self, number: int, member: Member) -> None:
        """With outputs instead of the motion, where they were asked for."""
        found: dict[str, Any] = {"status": "failed", "error": member.error}
        notes: list[str] = []
        if member.motion is not None:
            with remarked() as notes:
                warn_of_notes(member.motion, self._told)
                found = kept(member.motion, self._outputs or (), self._times)
            self._in_lanes += not member.reason
        if self._outputs is None and member.result is not None:
            self._results[number] = member.result
        if member.reason:
            self._alone[number] = member.reason
        verdict = found.get("verdict", {})
        if verdict.get("level", "good") != "good":
            self._doubts[number] = verdict["sentence"]
        self._found.add(Run(str(number), **found, remarks=in_one([*member.remarks, *notes], found)))

    def outcome(self, ensemble: Ensemble, about: Mapping[str, Any]) -> EnsembleResult:
        asked, count = self._outputs or (), () if self._times is None else (len(self._times),)
        longest = max((it.t for it in self._results.values()), key=len, default=np.zeros(0))
        outputs = self._found.outputs({it.label: count if it.over_time else () for it in asked})
        return EnsembleResult(
            parameters=ensemble.parameters,
            status=self._found.status({}, ()),
            errors={k: dict(it) for k, it in self._found.errors({}, ()).items()},
            alone=self._alone,
            remarks=self._found.remarks(),
            accuracy=self._found.accuracy,
            unstable=self._found.unstable,
            t=np.asarray(longest),
            trajectories=dict(_trajectories(self._results, len(ensemble), longest)),
            outputs=outputs,
            units={**ensemble._members.units, **{it.label: it.unit for it in asked}},
            times=self._times,
            manifest={**about, "lanes": self._in_lanes},
            notes={it.label: it.note for it in self._told if it.note},
            over_time=frozenset(it.label for it in asked if it.over_time),
            results=self._results,
        )

    def interrupted(
        self, stop: KeyboardInterrupt, ensemble: Ensemble, about: Mapping[str, Any]
    ) -> KeyboardInterrupt:
        """It says what is done, and has that as its `result`."""
        done = f"interrupted: {self._found.done} of {len(ensemble)} members are done"
        error = type(stop)(f"{done}; the error's `result` has them")
        carry(error, result=self.outcome(ensemble, about))
        return error

    def warn_of_inaccurate(self, found: EnsembleResult) -> None:
        """LinkworkWarning: members are more than 1 % off, or nobody knows how much, or may be."""
        self._found.warn_of_memory()
        every = bool(found.manifest["follow_errors"])
        if others := of_the_others(found.unstable, found.status, "members", every=every):
            warn(others)
        bad = [k for k in self._doubts if found.status[k] == "finished"]
        if not bad:
            return
        worst = max(bad, key=lambda k: found.accuracy[k])
        count = f"{'at least ' if others else ''}{len(bad)} of {len(found)} members are more than 1 % off"
        warn(
            f"{count}, the worst is {worst}: {self._doubts[worst]} (the result's `accuracy` tells of each, "
            "on_inaccurate='pass' nothing)"
        )


def _trajectories(results: Mapping[int, Result], count: int, times: Floats) -> Iterator[tuple[str, Floats]]:
    """Of members with the same bodies and rows, and frames at the same times, as long as each lasts. Nothing
    where a member has others: each has its own in `results`."""
    if any(not np.array_equal(it.t, times[: len(it)]) for it in results.values()):
        return
    for name in TRAJECTORIES if results else ():
        values = {k: _of(it, name) for k, it in results.items()}
        shapes = {it.shape[1:] for it in values.values()}
        if len(shapes) > 1:
            continue
        found = np.full((count, len(times), *shapes.pop()), np.nan)
        for k, value in values.items():
            found[k, : len(value)] = value
        yield name, found


def _of(result: Result, name: str) -> Floats:
    return result.energy if name == "energy" else result.recorded(name)
