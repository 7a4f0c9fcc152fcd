"""`sweep`: from a model and its parameters to a Study."""

from __future__ import annotations

import datetime
import inspect
import json
import logging
import os
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import closing, contextmanager
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from linkwork.arguments import check_switch, whole
from linkwork.arrays import Floats
from linkwork.comparison.workers import Lost, can_fork
from linkwork.equations.system import System
from linkwork.errors import FileError, LinkworkError, LinkworkWarning, OptionError, warn
from linkwork.fingerprints import canonical, digest, digests, plain
from linkwork.modeling.model import Model
from linkwork.motion.header import Header
from linkwork.options import TABLE, check_number, check_option, without_threads
from linkwork.results.result import Result
from linkwork.running import checks, recording, schedule
from linkwork.running.events import events_of
from linkwork.running.interrupts import Interrupts
from linkwork.running.leaving_no_memory import called, leaving_no_memory
from linkwork.running.manifest import platform_facts
from linkwork.running.progress import ShowOption, counting
from linkwork.running.simulation import check_run, simulate
from linkwork.studies import outputs as wanted
from linkwork.studies.agreement import Here, contents, joined
from linkwork.studies.cases import Answer, Runner, check_times, machine
from linkwork.studies.chunks import run_cases
from linkwork.studies.collected import Collected, Todo
from linkwork.studies.executors import check_executor
from linkwork.studies.followed import of_the_others
from linkwork.studies.lanes import LaneRunner, fits, with_lanes
from linkwork.studies.notes import noted
from linkwork.studies.sampling import Cases, cases_of
from linkwork.studies.store import Store, stored_identity
from linkwork.studies.study import Study, assembled
from linkwork.studies.variants import Built, Source, source_of

__all__ = ["check_names", "checked_outputs", "probe", "sweep"]

log = logging.getLogger(__name__)

#: Arguments of `simulate` that a study has in another way, or cannot have.
OTHERS = {
    "output": "a study keeps outputs; Study.simulate runs one case again",
    "overwrite": "a study keeps outputs; Study.simulate runs one case again",
    "start": "give the model another initial state, model.with_initial_state(q, v)",
    "progress": "it is that of the study",
}

#: Columns of every study.
OWN = ("case", "status", "verdict", "accuracy", "unstable", "seconds", "error", "remarks", "time")

#: Names that no parameter or output can have.
_OWN = dict.fromkeys(OWN, "a column that every study has")

#: Of how many cases one is looked for that has a model, on which outputs are checked.
LOOKED_AT = 20


def sweep(
    model: Model | Callable[..., Model],
    parameters: Any,
    outputs: Any,
    *,
    t_end: float,
    times: ArrayLike | None = None,
    sampler: Any = None,
    cases: int | None = None,
    seed: int | None = None,
    executor: Executor | Any = None,
    processes: int | None = None,
    directory: str | os.PathLike[str] | None = None,
    shard: tuple[int, int] | None = None,
    gather: bool = False,
    retry: bool = False,
    case_seconds: float | None = None,
    follow_errors: bool = False,
    progress: ShowOption = None,
    **options: Any,
) -> Study:
    """Simulate a mechanism in many variants, and keep of each what is asked for.

        study = lw.sweep(model, {"rod.mass": [1, 2, 3], "gravity[2]": [-9.81, -1.62]},
                         ["energy_error.abs_max", "body('rod').position.z.min"], t_end=2.0, step=1e-3)

    model       a model, whose parameters are named by path: "crank.mass", "crank.inertia[1]",
                "spring.stiffness", "motor pin.at[2]", "gravity[2]"; in the units of `Model.values`. Or a
                function build(**parameters) -> Model, where the topology changes
    parameters  {name: values}: a grid, full factorial. A list of mappings, a table of pandas, an array with
                named fields: a case a row. With a sampler {name: (low, high)}, or distributions of
                scipy.stats: norm(1.0, 0.01), Normal(mu=1.0, sigma=0.01), rv_histogram(...); discrete ones,
                such as randint(1, 4), give a function integers
    outputs     names of quantities of a Result, with what becomes of them over time (max, min,
                abs_max, mean, rms, range, final): "reaction('pin').force.max". Of vectors in space all but
                final are those of the magnitude; .x, .y, .z are components. "final": the last q and v.
                Functions of a Result that give numbers. {label: ...} names them; a pair (function, unit) has
                a unit. Names without max, ... are arrays at `times`
    t_end       of every case [s]
    times       of outputs that are arrays [s]; with a fixed step multiples of it
    sampler     "grid", "table" (columns of equal length), "random", "sobol", "halton",
                "latin_hypercube", or an engine of scipy.stats.qmc. None: a grid or a table, "random" where
                all parameters are distributions
    cases       how many, of a sampler
    seed        of a sampler: the same cases again, of "random" also with more of them
    executor    any of concurrent.futures, such as MPIPoolExecutor of mpi4py, a Client of Dask, an executor of
                submitit; None: local processes
    processes   how many of them; None: one a processor
    directory   keeps every case, so that a study that was interrupted, or has more cases now, runs what is
                missing. It may be on a file system that machines share
    shard       (k, n): only every nth case, of arrays of jobs that begin at 0 or 1; needs `directory`
    gather      only collect what is in `directory`
    retry       run the cases that failed again, too, such as those that missed a file; one that finished
                counts from then on
    case_seconds  wall time that one case may take by itself [s], of local processes: what takes longer is
                failed, however the cases are shared out, and tried again when the study is run again. None:
                any time
    follow_errors  whether the verdicts of all cases know how errors grow in motion that is unstable or
                chaotic: in lanes at a fixed step, where that takes as long as some to 30 cases, those of one
                in 64 do, at least of 16; else all do
    progress    None: a line on a terminal or in a notebook; False: nothing
    options     of linkwork.simulate: step, rtol, integrator, events, ... Without record_every all steps are
                recorded, with rtol also about 1000 even times, as steps may be long, or of last values with a
                fixed step at most about 1000; on_inaccurate is "pass": see Study.verdict

    A case has the same bits whatever runs beside it: those of `simulate`, or where lanes of ensembles have
    all that is asked for (`Study.manifest["lanes"]`), of `simulate` with deterministic=True. One that fails
    is kept as failed; a process that dies takes no case with it but the one that ended it. Ctrl-C keeps in
    `directory` what is done, but for tasks of a few seconds under way, and says how many cases that are.

    OptionError, ModelError: a parameter or output that does not exist, a value of another shape, no cases, a
    sampler without seed, an option that cannot be: before the first case. FileError: `directory` belongs to
    another study, or cannot be written. LinkworkError: the executor works no more, or its workers have other
    functions or another version than this process. LinkworkWarning: machines of several instruction sets
    took part, functions remember calls, or errors of cases that were followed grow as those of others may.
    """  # Long: the arguments alone are twenty lines.
    check_number("t_end", t_end, positive=True, unit="s")
    _check_places(shard, gather, retry, directory, processes)
    _check_gather(gather, shard=shard, executor=executor, processes=processes, case_seconds=case_seconds,
                  retry=retry or None)  # fmt: skip
    check_switch("follow_errors", follow_errors)
    options = _checked_options(options)
    drawn = cases_of(parameters, sampler, cases, seed)
    source = source_of(model, drawn.columns)
    drawn = drawn if isinstance(source, Built) else drawn.as_floats()
    asked = wanted.outputs_of(outputs)
    check_names(_OWN, list(drawn.columns), [it.label for it in asked])
    digests_here = {} if executor is None else contents(source, asked, options)  # as yet nothing was called
    number, example = _example(model, source, drawn)
    here = Here(digests_here, [] if executor is None else joined(example, options))
    wanted_times, run_options = check_times(times, float(t_end), options, asked, example)
    checks.warn_of_opposed_axes(example, example.compiled().q0)
    first = example if number == 0 else None
    _check_run(source, drawn, first, float(t_end), run_options)
    checked = checked_outputs(asked, probe(example, run_options), wanted_times)
    _check_times(checked, wanted_times, run_options)
    runner = Runner(source, float(t_end), run_options, checked, wanted_times)
    lanes = with_lanes(runner, options, follow_errors)
    runner = _chosen(runner, lanes, model if isinstance(model, Model) else example, drawn, directory)
    check_executor(executor, processes, runner)
    case_seconds = _checked_case_seconds(case_seconds, executor)
    identity = _identity(runner, drawn)
    head = digest(identity, _version())
    keys = digests(head, drawn.columns)
    runner = runner.following(keys) if isinstance(runner, LaneRunner) else runner
    about = _about(runner, drawn, keys[0], first, seed)
    store = None if directory is None else _store(directory, drawn, identity, about, gather)
    _check_example(source, store, drawn, keys, head)
    known, machines = _known(keys, store, shard, retry=retry)
    todo = Todo.of(drawn, keys, known, shard)
    workers = _Workers(executor, processes, case_seconds, len(drawn), here)
    lost = {} if gather else _carried_out(runner, todo, _Found(known, machines, store), progress, workers)
    study = assembled(drawn, keys, known, lost, runner, {**about, "identity": identity, "machines": machines})
    return _told(study, known, options)


# --- before the first case ---


def _check_places(shard: Any, gather: Any, retry: Any, directory: Any, processes: Any) -> None:
    """OptionError: a shard that there is not, or parts of a study that nobody keeps."""
    if processes is not None:
        whole(processes, 1, "processes")
    for name, flag in (("gather", gather), ("retry", retry)):
        check_switch(name, flag)
    if shard is not None:
        good = isinstance(shard, tuple | list) and len(shard) == 2
        good = good and all(isinstance(it, int) and not isinstance(it, bool) for it in shard)
        if not good or not shard[1] >= 1 or not 0 <= shard[0] <= shard[1]:
            raise OptionError(
                f"shard {shard!r:.40}: give (k, n), k from 0 to n - 1 or from 1 to n, where n is the number "
                "of all shards, also where some of them are run again",
                code="shard",
            )
    if directory is None and (shard is not None or gather or retry):
        what = "shard" if shard is not None else "gather" if gather else "retry"
        raise OptionError(f"{what} needs a directory, where the cases are kept", code="directory")


def _check_gather(gather: bool, **others: Any) -> None:
    """OptionError: what says how cases are run, where none is."""
    for name, value in others.items():
        if gather and value is not None:
            raise OptionError(
                f"{name} {value!r:.40}: gather runs no case, it collects what all shards did; leave one out",
                code="conflict",
            )


def _checked_case_seconds(case_seconds: Any, executor: Any) -> float | None:
    """OptionError: no time, or one that nobody could keep."""
    if case_seconds is None:
        return None
    check_number("case_seconds", case_seconds, positive=True, unit="s")
    if executor is not None or not can_fork():
        where = "an executor's own processes" if executor is not None else "this system"
        raise OptionError(
            f"case_seconds {case_seconds:g}: cannot be kept in {where}, where nobody ends what takes too "
            "long; leave it out",
            code="case_seconds",
        )
    return float(case_seconds)


def check_names(own: Mapping[str, str], parameters: Sequence[str], outputs: Sequence[str]) -> None:
    """OptionError: two that a table could not tell apart; `own` says what has a name already."""
    taken = dict(own)
    for what, names in (("parameter", parameters), ("output", outputs)):
        for name in names:
            if name in taken:
                raise OptionError(
                    f"{what} '{name}': is the name of {taken[name]}: choose another", code="names"
                )
            taken[name] = f"a {what}"


def _check_kept(cases: Cases) -> None:
    """OptionError: a value that does not come back from a file as what it is."""
    for name, values in cases.columns.items():
        for value in values:
            if type(value) in (float, int, str, bool):
                continue
            kept = plain(value)
            try:
                same = canonical(json.loads(json.dumps(kept))) == canonical(kept)
            except (TypeError, ValueError):
                same = False
            if not same:
                raise OptionError(
                    f"parameter '{name}': {value!r:.60} cannot be kept in a directory, which holds numbers, "
                    "texts, lists, and mappings of texts to these: name it by one of them and look it up "
                    "in the function that builds the model, or leave directory out",
                    code="parameters",
                )


def _checked_options(options: Mapping[str, Any]) -> dict[str, Any]:
    """Each as often as there are cases. OptionError: none of `simulate`, or one that a study has in another
    way."""
    known = [*list(inspect.signature(simulate).parameters)[2:-1], *TABLE]
    for name in options:
        if name in OTHERS:
            raise OptionError(f"option '{name}' is none of a study: {OTHERS[name]}", code="option")
        check_option(name, known)
    checks.check_choices(options)
    return {**options, **({"events": events_of(options["events"])} if "events" in options else {})}


def _example(model: Any, source: Source, cases: Cases) -> tuple[int, Model]:
    """The first case that has a model, and that. What its building raises where none of many has one."""
    first: Exception | None = None
    for k in range(min(len(cases), LOOKED_AT)):
        try:
            return k, source.model(cases.case(k))
        except Exception as error:
            if first is None:
                first = error
                values = ", ".join(f"{name} = {value!r:.80}" for name, value in cases.case(k).items())
                error.add_note(f"sweep: the model of case {k}, {values}")
    if isinstance(model, Model):
        return -1, model
    assert first is not None
    raise first


def _check_run(
    source: Source, cases: Cases, first: Model | None, t_end: float, options: Mapping[str, Any]
) -> None:
    """OptionError: a choice that does not exist, or that none of some cases can honor."""
    refused: OptionError | None = None
    for k in sorted({0, len(cases) // 2, len(cases) - 1}):
        try:
            model = source.model(cases.case(k)) if first is None or k > 0 else first
            _prepare(model, t_end, options)
            return
        except OptionError as error:
            refused = refused or error
        except Exception as error:  # this case alone may fail
            log.info("%s", error)
            return
    if refused is not None:
        raise refused


def _prepare(model: Model, t_end: float, options: Mapping[str, Any]) -> None:
    """All of a run but its steps."""
    usual = {"integrator": None, "breaks": (), "assemble": True, "verify": False, "events": ()}
    given = {**usual, **options}
    step, rtol, atol, every, at = (
        given.get(name) for name in ("step", "rtol", "atol", "record_every", "times")
    )
    plan = schedule.plan(t_end, step, rtol, atol, every, at, recording.frame_bytes(model), 0.0)
    chosen: Any = {name: value for name, value in options.items() if name in TABLE}
    with leaving_no_memory(called(model, given), logs=True), warnings.catch_warnings():
        warnings.simplefilter("ignore", LinkworkWarning)
        check_run(model, plan, given, chosen)


def probe(model: Model, options: Mapping[str, Any]) -> Result:
    """A result of one frame, in which outputs are looked for."""
    core = model.compiled()
    try:
        dynamics = System(model, **{name: it for name, it in options.items() if name in TABLE}).compiled()
    except LinkworkError:
        dynamics = None
    header = Header.of(core, dynamics, {"model": model.name}, shapes=model.shapes, curves=model.curves)
    frames = {name: np.zeros((1, *shape)) for name, shape in header.frame_shapes().items()}
    frames["q"], frames["v"] = core.q0.reshape(1, -1, 7), core.v0.reshape(1, -1, 6)
    return Result(frames, header, {})


def checked_outputs(
    asked: Sequence[wanted.Output], at_start: Result, times: Floats | None
) -> list[wanted.Output]:
    """With units, descriptions and notes. OptionError: one that does not exist."""
    return [noted(wanted.checked(it, at_start, times), at_start) for it in asked]


def _check_times(outputs: Sequence[wanted.Output], times: Floats | None, options: Mapping[str, Any]) -> None:
    """OptionError: times that nothing is asked for at."""
    at_frames = "times" in options and any(it.function is not None for it in outputs)
    if times is not None and not at_frames and not any(it.over_time for it in outputs):
        raise OptionError(
            "times: no output is an array over time, such as \"body('rod').position\" without a reduction; "
            "leave times out",
            code="times",
        )


# --- what it is ---


def _chosen(alone: Runner, lanes: Runner | None, base: Model, cases: Cases, directory: Any) -> Runner:
    """In lanes where they can have it; a study that is in the directory goes on as it began."""
    if lanes is None:
        return alone
    if directory is not None and (begun := stored_identity(directory)) is not None:
        for runner in (lanes, alone):
            if begun == _identity(runner, cases):
                return runner
    return lanes if fits(lanes, base) else alone


def _version() -> str:
    return str(platform_facts()["versions"]["linkwork"])


def _identity(runner: Runner, cases: Cases) -> dict[str, Any]:
    """What a directory is for: more cases may come, but no other model, outputs or options."""
    return {
        "model": runner.source.identity(), "parameters": sorted(cases.columns), "t_end": runner.t_end,
        "outputs": digest(wanted.identity(runner.outputs)),
        "times": digest(runner.times),
        "options": {
            name: digest(value) if name == "times" else canonical(plain(value))  # of about a thousand frames
            for name, value in sorted(without_threads(runner.options).items())
        },
        **({"follow_errors": True} if isinstance(runner, LaneRunner) and runner.follow_errors else {}),
    }  # fmt: skip


def _hash_of(source: Source, values: Mapping[str, Any], built: Model | None = None) -> str:
    """Of the model of a case, where it is `built` or can be; empty where there is none."""
    try:
        return (built or source.model(values)).hash()
    except Exception:
        return ""


def _store(
    directory: Any, cases: Cases, identity: Mapping[str, Any], about: Mapping[str, Any], gather: bool
) -> Store:
    """OptionError: a value that it cannot hold. FileError: it is of another study."""
    _check_kept(cases)
    return Store(directory, identity, about, new=not gather)


def _check_example(source: Source, store: Store | None, cases: Cases, keys: Sequence[str], head: str) -> None:
    """FileError: what a function builds is not what it was, though its code is: it uses something else.

    Values of which a file does not say all, such as tuples, are those of the case here that is the same.
    """
    if store is None or not isinstance(source, Built) or not (example := store.example()):
        return
    key, kept = example["key"], example["values"]
    if digest(head, kept) == key:
        values = kept
    elif key in keys:
        values = cases.case(keys.index(key))
    else:
        return
    if _hash_of(source, values) != example["model"]:
        raise FileError(
            f"directory '{store.directory}': the function {source.name} built another model of "
            f"{kept} then: what it uses has changed, or is random; give another directory, and "
            "what changes as parameters",
            code="other_study",
        )


def _about(runner: Runner, cases: Cases, key: str, first: Model | None, seed: int | None) -> dict[str, Any]:
    """For the manifest; `key` is that of the first case, `first` its model, if it has one."""
    import scipy

    facts, values = platform_facts(), cases.case(0)
    return {
        "example": {"key": key, "values": plain(values), "model": _hash_of(runner.source, values, first)},
        "sampler": cases.how, "cases": len(cases), "seed": seed, "drawn": dict(cases.drawn),
        "lanes": runner.lanes, "outputs": [it.label for it in runner.outputs],
        **facts, "versions": {**facts["versions"], "scipy": scipy.__version__}, "machine": machine(),
        "started": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
    }  # fmt: skip


def _known(
    keys: Sequence[str], store: Store | None, shard: tuple[int, int] | None, *, retry: bool
) -> tuple[Collected, list[Mapping[str, Any]]]:
    """What is kept of the cases, and the machines that ran them; `retry`: but for failures of the shard."""
    known = Collected(keys)
    machines = [] if store is None else store.find(known)
    if retry:
        known.forget_failed(shard)
    return known, machines


# --- the cases ---


class _Workers(NamedTuple):
    """Who runs the cases, for how long at most each [s], how many the study has, also in other shards, and
    what an executor's processes are to have as this one does."""

    executor: Any
    processes: int | None
    case_seconds: float | None
    total: int
    here: Here


@dataclass(frozen=True)
class _Found:
    """Cases that are done, the machines that ran them, and who keeps them."""

    known: Collected
    machines: list[Mapping[str, Any]]
    store: Store | None

    def add(self, answer: Answer) -> None:
        if self.store is not None:
            self.store.keep(answer)
        for run in answer.runs:
            self.known.add(run)
        if answer.machine not in self.machines:
            self.machines.append(answer.machine)


def _carried_out(
    runner: Runner, todo: Todo, to: _Found, progress: ShowOption, workers: _Workers
) -> dict[str, str]:
    """Adds to what is found; gives back why cases were lost. KeyboardInterrupt: it says what is kept."""
    lost: dict[str, str] = {}
    if not todo:
        return lost
    executor, processes, seconds, total, here = workers
    done, counts, started = 0, Counter[str](), time.monotonic()
    with counting(progress, len(todo)) as report, _telling(todo, to), Interrupts() as interrupts:

        def beat() -> None:
            interrupts.check()
            report(done, _line(done, len(todo), time.monotonic() - started, counts["failed"] + len(lost)))

        with closing(run_cases(runner, todo, executor, processes, beat, seconds, total, here)) as found:
            for chunk, answer in interrupts.each(found):
                done += len(chunk)
                if isinstance(answer, Lost):
                    lost.update({case.key: answer.reason for case in chunk})
                else:
                    to.add(answer)
                    counts.update(run.status for run in answer.runs)
                beat()
    log.info("%s", _line(done, len(todo), time.monotonic() - started, counts["failed"] + len(lost)))
    return lost


@contextmanager
def _telling(todo: Todo, to: _Found) -> Iterator[None]:
    """KeyboardInterrupt says what is kept, and what is not."""
    before = to.known.done
    try:
        yield
    except KeyboardInterrupt as stop:
        total, now = to.known.alike(todo.numbers), to.known.done - before
        done = f"interrupted: {now} of {total} cases are done"
        kept = "and lost: give a directory, which keeps them"
        if to.store is not None:
            kept = f"and kept in '{to.store.directory}'; the same study again runs the other {total - now}"
        raise type(stop)(f"{done}, {kept}") from stop


def _line(done: int, total: int, elapsed: float, failed: int) -> str:
    rate = f", {done / elapsed:.3g} cases/s" if done and elapsed > 0 else ""
    return f"{done} of {total} cases{rate}" + (f", {failed} failed" if failed else "")


def _told(study: Study, found: Collected, options: Mapping[str, Any]) -> Study:
    """As it is. LinkworkWarning, once for all cases, but for what `options` say is nothing to be told."""
    if options.get("on_inaccurate") != "pass":
        found.warn_of_memory()
        every = study.runner is None or study.runner.follows_all
        if others := of_the_others(study.unstable, study.status, "cases", every=every):
            warn(f"study: {others}")
    sets = sorted({str(it.get("instruction_set")) for it in study.manifest["machines"]})
    if len(sets) > 1:
        warn(
            f"study: processors of several instruction sets took part ({', '.join(sets)}): their last bits "
            "may differ"
        )
    return study
