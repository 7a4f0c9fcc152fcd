"""Error against time of large models, by several methods and steps, and of peers where they are installed."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

from linkwork import integrators
from linkwork.arguments import whole
from linkwork.benchmark import memory
from linkwork.benchmark.choices import check_choices
from linkwork.benchmark.isolated import Failure, isolated
from linkwork.benchmark.large_models import LargeModel, large_subjects
from linkwork.benchmark.large_peers import PEERS, Peer, missing_peers
from linkwork.benchmark.motion_to_end import Motion, Trial, attempt, distance, try_steps, unsound
from linkwork.benchmark.subject import Subject
from linkwork.modeling.model import Model
from linkwork.running.progress import ShowOption, counting

__all__ = ["ERRORS", "METHODS", "Left", "Large", "LargeRun", "least_cost", "measure_large"]

#: One of order 1 as games and robots use, and three of order 4, 4 and 8.
METHODS = ("semi_implicit_euler", "abm4", "rk4", "dop853")

#: What the true motion is computed by.
TRUSTED = "dop853"

#: For which the least time is told.
ERRORS = (1e-2, 1e-3, 1e-4)

#: Beyond so many bodies there is no error, only the cost of a step.
MOST_BODIES = 100_000

#: Of fewer bodies what the process takes for itself hides their memory.
MANY_BODIES = 1000

#: Steps by which the cost of one is known before a run begins, fewer where they reach the limit.
TRIAL_STEPS = 3

HALVINGS, LIMIT_SECONDS = 4, 300.0


@dataclass(frozen=True)
class LargeRun:
    """One run to the end by one method; times are the least of several."""

    method: str  #: an integrator of linkwork, or the name of a peer
    step: float  #: [s]
    steps: int
    cpu_seconds: float | None  #: of the steps on all threads; None: it does not count
    seconds: float | None  #: of the clock
    error: float | None  #: the largest distance of a body from its true place, over the farthest way of one
    violation: float | None  #: of joints, relative to the size of the mechanism; None: a peer
    energy_error: float | None  #: relative to what energies changed by
    reason: str = ""  #: why it does not count: it failed, or physics did not hold


@dataclass(frozen=True)
class Large:
    """One model in one size."""

    model: str
    mechanism: str
    parameters: Mapping[str, Any]
    bodies: int
    joints: int
    equations: int
    rank: int
    redundant: int
    degrees_of_freedom: int
    threads: int
    t_end: float  #: [s]
    setup_seconds: float  #: from the model to the first step
    cpu_seconds_per_step: float  #: of RK4, on all threads
    seconds_per_step: float  #: the same by the clock
    bytes_per_body: float | None  #: at the peak, beyond the interpreter
    reference: str  #: how the true motion was computed; empty: it was not
    reference_error: float | None  #: its distance from the same with twice the step
    runs: list[LargeRun] = field(default_factory=list)
    left_out: list[str] = field(default_factory=list)


class Left(NamedTuple):
    """A model that could not be measured; `code` as in LinkworkError."""

    model: str
    reason: str
    code: str


def measure_large(
    names: Sequence[str] = (),
    *,
    size: str = "small",
    links: int | None = None,
    methods: Sequence[str] = METHODS,
    halvings: int = HALVINGS,
    repeats: int = 1,
    threads: int = 1,
    peers: bool = True,
    limit: float = LIMIT_SECONDS,
    progress: ShowOption = None,
) -> list[Large | Left]:
    """Measure the large models, each in a process of its own.

    names     of LARGE_MODELS; none: all
    size      small or full
    links     instead: for each the largest with no more bodies
    methods   integrators of linkwork
    halvings  steps that are tried: the model's longest, half of it, ...
    repeats   of each run; the least time counts
    peers     whether what else is installed runs, too
    limit     [s] for the runs of one model; those that would take longer are left out, and said

    A time counts only of a run that kept its joints, its energy and its width. OptionError: a name that does
    not exist, a number that cannot be.
    """
    check_choices((), "standard", "auto", repeats, limit, threads)
    whole(halvings, 2, "steps")
    for method in methods:
        integrators.named(method)
    subjects = large_subjects(names, size, links)
    found: list[Large | Left] = []
    with counting(progress, len(subjects)) as report:
        for number, (model, subject) in enumerate(subjects):
            beat = partial(report, number, f"{model.name}, {subject.bodies:,} bodies")
            answer = isolated(
                measure_model, model, subject, tuple(methods), halvings, repeats, threads, peers, limit,
                seconds=10 * limit, beat=beat,
            )  # fmt: skip
            found.append(
                Left(model.name, answer.reason, answer.code) if isinstance(answer, Failure) else answer
            )
    return found


def measure_model(
    it: LargeModel,
    subject: Subject,
    methods: Sequence[str],
    halvings: int,
    repeats: int,
    threads: int,
    peers: bool,
    limit: float,
) -> Large:
    """In this process, which must not have measured before. LinkworkError: it cannot take a step."""
    before = memory.resident()
    model = subject.build()
    model.compiled()
    budget = _Budget(limit, it.t_end, repeats, threads)
    trial = budget.try_steps(model, it.step / 2**halvings)
    peak = memory.peak()
    told = peak is not None and before is not None and model.body_count >= MANY_BODIES
    steps = [it.step / 2**k for k in range(halvings)]
    runs: list[LargeRun] = []
    reference, error = "", None
    if model.body_count > MOST_BODIES:
        budget.left_out.append(f"beyond {MOST_BODIES:,} bodies: no error, only the cost of a step")
    elif budget.allows(TRUSTED, steps[-2:], 1):
        truth = _true_motion(model, steps, budget)
        if isinstance(truth, str):
            budget.left_out.append(f"no errors, because the reference failed: {truth}")
        else:
            (true, error), reference = truth, f"{TRUSTED}, step {steps[-1]:g} s"
            runs += _runs(model, methods, steps, true, budget)
            runs += _peer_runs(model, it.t_end, steps, repeats, true, budget) if peers else ()
    facts = trial.rank
    return Large(
        model=it.name, mechanism=subject.mechanism, parameters=dict(subject.parameters),
        bodies=model.body_count, joints=model.joint_count, equations=facts["equations"], rank=facts["rank"],
        redundant=facts["redundant"], degrees_of_freedom=facts["degrees_of_freedom"], threads=threads,
        t_end=it.t_end, setup_seconds=trial.setup_seconds, cpu_seconds_per_step=trial.cpu_seconds,
        seconds_per_step=trial.seconds,
        bytes_per_body=(peak - before) / model.body_count if told else None,  # type: ignore[operator]
        reference=reference, reference_error=error, runs=runs, left_out=budget.left_out,
    )  # fmt: skip


def least_cost(found: Large, error: float) -> dict[str, LargeRun]:
    """Of each method the run with the least time whose error is no more; none where the reference is not
    known to half of it.
    """
    least: dict[str, LargeRun] = {}
    if found.reference_error is None or found.reference_error > error / 2:
        return least
    for run in found.runs:
        good = run.cpu_seconds is not None and run.error is not None and run.error <= error
        if good and (run.method not in least or run.cpu_seconds < least[run.method].cpu_seconds):  # type: ignore[operator]
            least[run.method] = run
    return least


@dataclass
class _Budget:
    """What all runs of a model may take together, their set-up included [CPU s]."""

    left: float
    t_end: float
    repeats: int
    threads: int
    evaluation: float = 0.0  # each of a run
    expected: float = 0.0  # of the next run of a peer
    left_out: list[str] = field(default_factory=list)

    def try_steps(self, model: Model, step: float) -> Trial:
        began = time.process_time()
        trial = try_steps(model, step, "rk4", TRIAL_STEPS, self.left, threads=self.threads)
        self.left -= time.process_time() - began
        self.evaluation = trial.cpu_seconds / 4
        return trial

    def allows(self, method: str, steps: Sequence[float], repeats: int) -> bool:
        evaluations = len(getattr(integrators.named(method), "A", ())) or 2
        needed = repeats * sum(self.evaluation * evaluations * self.t_end / step for step in steps)
        if needed > self.left:
            named = " and ".join(f"{step:g}" for step in steps)
            self.left_out.append(f"{method}, step {named} s: would take about {needed:.0f} s")
        return needed <= self.left

    def run(self, model: Model, step: float, method: str) -> Motion | str:
        """To the end, or why not: it may take longer than was expected."""
        began = time.process_time()
        motion = attempt(model, self.t_end, step, method, limit=self.left, threads=self.threads)
        self.left -= time.process_time() - began
        return motion

    def allows_peer(self, name: str, step: float) -> bool:
        """By what its run with twice the step took."""
        if self.expected > self.left:
            needed = f"would take about {self.expected:.0f} s"
            self.left_out.append(f"{name}, step {step:g} s and less: {needed}")
        return self.expected <= self.left

    def spend(self, run: LargeRun, repeats: int) -> None:
        spent = repeats * (run.cpu_seconds or 0.0)
        self.left, self.expected = self.left - spent, 2 * spent


def _true_motion(model: Model, steps: Sequence[float], budget: _Budget) -> tuple[Motion, float] | str:
    """By the trusted method with the shortest step, and how far the one before is from it; or why not."""
    true, coarser = (budget.run(model, step, TRUSTED) for step in (steps[-1], steps[-2]))
    if isinstance(true, str):
        return true
    if isinstance(coarser, str):
        return coarser
    return unsound(true) or (true, distance(coarser, true))


def _runs(
    model: Model, methods: Sequence[str], steps: Sequence[float], true: Motion, budget: _Budget
) -> Iterator[LargeRun]:
    """The coarse steps of all methods before the fine ones; the reference itself has no error to tell."""
    for step in steps:
        for method in methods:
            known = method == TRUSTED and step == steps[-1]
            if known or not budget.allows(method, [step], budget.repeats):
                continue
            motions = [budget.run(model, step, method) for _ in range(budget.repeats)]
            yield _judged(method, step, budget.t_end, motions, true)


def _judged(
    method: str, step: float, t_end: float, motions: Sequence[Motion | str], true: Motion
) -> LargeRun:
    first = motions[0]
    if isinstance(first, str):
        return LargeRun(method, step, round(t_end / step), None, None, None, None, None, first)
    reason, whole_runs = unsound(first, true), [it for it in motions if isinstance(it, Motion)]
    return LargeRun(
        method=method, step=step, steps=first.steps,
        cpu_seconds=None if reason else min(it.cpu_seconds for it in whole_runs),
        seconds=None if reason else min(it.seconds for it in whole_runs),
        error=distance(first, true), violation=first.violation, energy_error=first.energy_error,
        reason=reason,
    )  # fmt: skip


def _peer_runs(
    model: Model, t_end: float, steps: Sequence[float], repeats: int, true: Motion, budget: _Budget
) -> Iterator[LargeRun]:
    missing = missing_peers()
    refusals: dict[str, list[str]] = {}
    budget.left_out += [f"{name}: not installed (pip install 'linkwork[bench]')" for name in missing]
    for peer in PEERS:
        if peer.package in missing:
            continue
        if refusal := peer.refusal(model):
            refusals.setdefault(refusal, []).append(peer.name)
            continue
        budget.expected = 0.0
        for step in steps:
            if not budget.allows_peer(peer.name, step):
                break
            run = _peer_run(peer, model, t_end, step, repeats, true)
            budget.spend(run, repeats)
            yield run
    budget.left_out += [f"{'; '.join(names)}: {refusal}" for refusal, names in refusals.items()]


def _peer_run(peer: Peer, model: Model, t_end: float, step: float, repeats: int, true: Motion) -> LargeRun:
    """Of a peer joints and energy are not known; it must be finite and as wide as the true motion."""
    count = round(t_end / step)
    try:
        found = [peer.run(model, count, t_end / count) for _ in range(repeats)]
    except (RuntimeError, ValueError) as error:
        return LargeRun(peer.name, step, count, None, None, None, None, None, str(error)[:80] or "failed")
    (cpu, clock), end = min(times for times, _ in found), found[0][1]
    motion = Motion(true.start, end, cpu, clock, count, 0.0, 0.0, 0.0, {})
    reason = unsound(motion, true)
    return LargeRun(
        method=peer.name, step=step, steps=count, cpu_seconds=None if reason else cpu,
        seconds=None if reason else clock, error=distance(motion, true), violation=None, energy_error=None,
        reason=reason,
    )  # fmt: skip
