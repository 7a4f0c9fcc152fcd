"""What runs say of their own accuracy, beside the truth: random mechanisms, five steps, every method.

python tests/benchmarks/verdicts.py [--mechanisms 300] [--seed 0] [--methods 3] [--minutes 30] [--json FILE]

Each mechanism is one of eight families (open trees, loops, redundant equations, springs, forces that
depend on speed, contacts and stops, drivers, all together). It runs by rk4 with five steps from 0.1 s to
1 ms, and by further methods, drawn from all integrators, formulations, stabilizations and systems, with five
steps or tolerances each. The truth is DOP853 with projection at rtol 1e-11.

local     of up to four steps of each run: the estimated error of the step by the true one, from its start
silent    runs more than 1 % off in their first second that are called good
false     runs less than 0.1 % off that are not
bands     shares of the numbers recorded by a run with verify=True within three times Richardson's band

Left out: mechanisms whose motion is chaotic, where a twin with perturbed velocities departs by more than
GROWTH times the perturbation within the first second; those that cannot move; and those of which two
references disagree.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import signal
import sys
import time
import warnings
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
from linkwork.accuracy.measures import Bodies, Differences, Sampled, Scales
from linkwork.errors import LinkworkError
from linkwork.integrators import METHODS, EmbeddedPair, HalfExplicit
from linkwork.running.estimation import unjudged

sys.path.append(str(Path(__file__).parents[1] / "python"))

from linkwork.arrays import Floats
from random_mechanisms import Mechanism, make, plant

STEPS = (0.1, 0.04, 0.01, 4e-3, 1e-3)  # s
TOLERANCES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-6)
WRONG, RIGHT = 1e-2, 1e-3
FACTOR, BAND = 30.0, 3.0

#: Of a perturbation of velocities, relative, within the first second.
PERTURBATION, GROWTH = 1e-7, 100.0

#: Speed by length [1/s]: what is slower does not move.
STILL = 1e-6

#: Of the true error: what a reference must be better than.
KNOWN = 0.1

#: A local error below is rounding.
ROUNDING = 1e-11

#: Steps of a run that are compared with the truth, and what one run may take [s].
LOOKED_AT, PATIENCE = 4, 20

JOINTS = ("revolute", "spherical", "universal", "cylindrical", "translational", "planar",
          "revolute_spherical", "screw", "constant_velocity", "distance")  # fmt: skip
SPRINGS = ("spring_damper", "rotational_spring_damper", "bushing", "nonlinear_spring_damper",
           "bending_spring")  # fmt: skip
SPEEDS = ("drag", "linear_damping", "rotational_friction", "translational_friction", "motor")
STOPS = ("sphere_plane_contact", "sphere_sphere_contact", "rotational_stop", "translational_stop")
FAMILIES = ("tree", "loops", "redundant", "springs", "speeds", "stops", "drivers", "mixed")


def mechanism(seed: int) -> tuple[str, Mechanism]:
    """One of the families, and its name."""
    rng = np.random.default_rng([seed, 13])
    family = FAMILIES[seed % len(FAMILIES)]
    joints = list(rng.choice(JOINTS, rng.integers(1, 6)))

    def some(kinds: Sequence[str], most: int = 3) -> list[str]:
        return list(rng.choice(kinds, rng.integers(1, most + 1)))

    if family == "redundant":
        return family, plant(seed, joints[:2], some(("twice", "within", "planar loop", "parallelogram"), 2))
    how: dict[str, Any] = {"driven": False}
    if family in ("loops", "mixed"):
        how["loops"] = some(("spherical", "point_on_plane", "distance", "point_on_line"), 2)
    if family in ("springs", "speeds", "stops"):
        how["forces"] = some({"springs": SPRINGS, "speeds": SPEEDS, "stops": STOPS}[family])
    if family == "mixed":
        how["forces"] = some((*SPRINGS, *SPEEDS, *STOPS, "applied"), 4)
    if family in ("drivers", "mixed"):
        how["driven"] = True
        joints += ["distance", *rng.choice(("angle_driver", "displacement_driver", "applied"), 1)]
    how["forces"] = how.get("forces", []) + [kind for kind in joints if kind == "applied"]
    joints = [kind for kind in joints if kind != "applied"]
    return family, make(seed, joints, **how)


def methods(seed: int, count: int) -> Iterator[dict[str, Any]]:
    """rk4 as it is, then others at random; each integrator comes in turn."""
    yield {}
    rng = np.random.default_rng([seed, 17])
    names = list(METHODS)
    for k in range(count):
        name = names[(count * seed + k) % len(names)]
        method = METHODS[name]
        how: dict[str, Any] = {"integrator": name}
        if isinstance(method, EmbeddedPair) and rng.random() < 0.7:
            how["adaptive"] = True
        if isinstance(method, HalfExplicit):
            yield how
            continue
        how["formulation"] = str(rng.choice(["standard", "standard", "penalty", "augmented_lagrangian"]))
        stabilizations = ["sampled_baumgarte", "none", "projection", "velocity_projection", "baumgarte"]
        how["stabilization"] = str(rng.choice(stabilizations, p=[0.4, 0.2, 0.2, 0.1, 0.1]))
        if how["formulation"] == "penalty":
            how["stabilization"] = "baumgarte"
        if how["stabilization"] == "baumgarte":
            how |= {"baumgarte_alpha": 5.0, "baumgarte_beta": 5.0}
        if how["formulation"] == "standard" and rng.random() < 0.3:
            how["matrix_form"] = "schur"
        yield how


@dataclass
class Found:
    """One run."""

    seed: int
    family: str
    how: dict[str, Any]
    size: float  #: step [s] or rtol
    true: float = np.nan  #: in the first second
    state: float = np.nan
    error: float = np.nan
    warned: bool = False
    failure: str = ""
    local: list[tuple[float, float]] = field(default_factory=list)  #: estimated and true, of steps
    bands: dict[str, float] = field(default_factory=dict)
    seconds: float = 0.0

    @property
    def silent(self) -> bool:
        return not self.failure and not self.warned and self.true > WRONG

    @property
    def name(self) -> str:
        return str(self.how.get("integrator", "rk4")) + (" adaptive" if "adaptive" in self.how else "")


@dataclass(frozen=True)
class Truth:
    """Of one mechanism, at times that every step meets."""

    model: lw.Model
    result: lw.Result
    own: float  #: error of the reference
    growth: float

    @classmethod
    def of(cls, model: lw.Model) -> Truth:
        times = np.linspace(0.0, 1.0, 101)
        first, second = (exact(model, 1.0, times, rtol) for rtol in (1e-11, 1e-10))
        own = float(difference(second, first).max())
        return cls(model, first, own, growth(model, first))


def exact(model: lw.Model, t_end: float, times: Floats, rtol: float = 1e-11, **how: Any) -> lw.Result:
    how = {"stabilization": "projection", "integrator": "dop853", "atol": rtol / 10, **how}
    with unjudged():
        return quiet(model, t_end, rtol=rtol, times=times, **how)


def quiet(model: lw.Model, t_end: float, *given: Any, **how: Any) -> lw.Result:
    with warnings.catch_warnings(), patience():
        warnings.simplefilter("ignore")
        return lw.simulate(model, t_end, *given, **{"progress": False, "on_inaccurate": "pass", **how})


@contextlib.contextmanager
def patience() -> Iterator[None]:
    """TimeoutError: the run takes too long."""

    def stop(*_: Any) -> None:
        raise TimeoutError(f"more than {PATIENCE} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(PATIENCE)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def difference(result: lw.Result, best: lw.Result) -> Floats:
    reference = Sampled.of(best)
    scales = Scales.of(reference, Bodies.of(best.header))
    return Differences.between(Sampled.of(result), reference).state(scales)


def growth(model: lw.Model, best: lw.Result) -> float:
    """Largest departure of a twin by its first."""
    reference = Sampled.of(best)
    scales = Scales.of(reference, Bodies.of(best.header))
    start = best.snapshot(0)
    push = np.random.default_rng(1).standard_normal(start.v.shape) * PERTURBATION
    speed, length = (it[scales.part, None] for it in (scales.speed, scales.length))
    push *= np.concatenate([speed, speed, speed, *3 * [speed / length]], axis=1)
    twin = exact(model, best.t[-1], best.t, start=start._replace(v=start.v + push))
    apart = Differences.between(Sampled.of(twin), reference).state(scales)
    return float(apart.max() / max(apart[1], 1e-3 * PERTURBATION))


def run(seed: int, truth: Truth, family: str, how: dict[str, Any], size: float) -> Found:
    found, began = Found(seed, family, how, size), time.perf_counter()
    given = {name: value for name, value in how.items() if name != "adaptive"}
    if "adaptive" in how:
        given |= {"rtol": size, "times": truth.result.t}
    else:
        given |= {"step": size, "record_every": 1}
    with warnings.catch_warnings(), patience():
        warnings.simplefilter("ignore")  # of accuracy the verdict says as much, and others are of the model
        try:
            result = lw.simulate(truth.model, 1.0, progress=False, **given)
        except (LinkworkError, TimeoutError) as error:
            found.failure = f"{type(error).__name__}: {error}"
            return found
    best = truth.result if "adaptive" in how else exact(truth.model, 1.0, result.t)
    found.true = float(difference(result, best).max())
    verdict = result.verdict
    assert verdict is not None
    found.warned = verdict.level != "good"
    found.error, found.state = verdict.error, np.nan if verdict.state is None else verdict.state
    if (
        "adaptive" not in how and how.get("integrator") != "semi_implicit_euler"
    ):  # it is judged between others
        found.local = list(local_errors(truth.model, result, best, given))
    found.seconds = time.perf_counter() - began
    return found


def local_errors(
    model: lw.Model, result: lw.Result, best: lw.Result, given: dict[str, Any]
) -> Iterator[tuple[float, float]]:
    """Estimated and true, of some steps that were taken again."""
    verdict = result.verdict
    if verdict is None or not verdict.steps:
        return
    scales = Scales.of(Sampled.of(best), Bodies.of(best.header))
    places = np.linspace(0, len(verdict.steps) - 1, min(LOOKED_AT, len(verdict.steps))).astype(int)
    for step in (verdict.steps[place] for place in places):
        k = int(np.argmin(np.abs(result.t - step.t)))
        if k + 1 >= len(result.t):
            continue
        try:
            end = exact(model, float(result.t[k + 1]), result.t[k + 1 : k + 2], 1e-12,
                        start=result.snapshot(k), assemble=False, **_same_return(given))  # fmt: skip
        except (LinkworkError, TimeoutError):
            continue
        apart = Differences.between(_frame(Sampled.of(result), k + 1), _frame(Sampled.of(end), -1))
        yield step.error, float(apart.state(scales).max())


def _same_return(given: dict[str, Any]) -> dict[str, Any]:
    """How the motion from a start off the constraints goes back to them, as in the run."""
    kind = given.get("stabilization", "projection")
    if kind == "baumgarte":
        return {name: value for name, value in given.items() if name.startswith("baumgarte") or value == kind}
    return {"stabilization": "projection" if kind == "sampled_baumgarte" else kind}


def _frame(of: Sampled, k: int) -> Sampled:
    return Sampled(*(getattr(of, name)[k:][:1] for name in ("t", "q", "v", "force", "torque")))


def bands(truth: Truth, how: dict[str, Any], size: float) -> dict[str, float]:
    """Shares of the recorded numbers within the bands."""
    given = {name: value for name, value in how.items() if name != "adaptive"}
    if "adaptive" in how:
        given |= {"rtol": size, "times": truth.result.t}
    else:
        given |= {"step": size}
    result = quiet(truth.model, 1.0, verify=True, **given)
    best = exact(truth.model, 1.0, result.t)
    shares = {}
    for what in ("q", "v", "acceleration", "energy", "reactions"):
        values, true, error = (_array(it) for it in (getattr(result, what), getattr(best, what),
                                                     result.error_of(what)))  # fmt: skip
        if what == "reactions":
            unique = result.unique_reactions
            values, true, error = values[:, :, unique], true[:, :, unique], error[:, :, unique]
        if values.size:
            rounding = 1e-9 * max(np.abs(true).max(), 1.0)
            shares[what] = float(np.mean(np.abs(values - true) <= BAND * error + rounding))
    return shares


def _array(of: Any) -> Any:
    of = of() if callable(of) else of
    return np.stack(of) if isinstance(of, tuple) else of


def study(seed: int, count: int) -> tuple[str, list[Found]]:
    """Of one mechanism: why it was left out, and its runs."""
    try:
        family, made = mechanism(seed)
        truth = Truth.of(made.model)
    except (LinkworkError, TimeoutError) as error:
        return f"no reference: {type(error).__name__}: {error}", []
    scales = Scales.of(Sampled.of(truth.result), Bodies.of(truth.result.header))
    fastest = np.abs(truth.result.v).max(axis=(0, 1))
    if not max(fastest[:3].max() / scales.length.max(), fastest[3:].max()) > STILL:
        return "at rest", []
    if not truth.growth < GROWTH:
        return "chaotic", []
    found = []
    for place, how in enumerate(methods(seed, count)):
        for k, size in enumerate(TOLERANCES if "adaptive" in how else STEPS):
            try:
                it = run(seed, truth, family, how, size)
                if place == 1 and k % 2 == seed % 2 and not it.failure:
                    it.bands = bands(truth, how, size)
            except (LinkworkError, TimeoutError) as error:
                it = Found(seed, family, how, size, failure=f"truth: {type(error).__name__}: {error}")
            found.append(it)
    return "disagree" if truth.own > WRONG * KNOWN else "", found


# --- what is printed ----------------------------------------------------------------------------------------


def ratios(found: Sequence[Found]) -> Floats:
    pairs = np.array([pair for it in found for pair in it.local] or np.zeros((0, 2)))
    return pairs[:, 0] / pairs[:, 1] if (pairs := pairs[(pairs > ROUNDING).all(axis=1)]).size else np.zeros(0)


def line(name: str, found: Sequence[Found]) -> str:
    ended = [it for it in found if not it.failure]
    local = ratios(ended)
    near = np.mean((local < FACTOR) & (local > 1 / FACTOR)) if len(local) else np.nan
    wrong = [it for it in ended if it.true > WRONG]
    estimate = np.array([it.error / it.true for it in ended if it.true > 1e-10] or [np.nan])
    shares = [share for it in ended for share in it.bands.values()]
    return (
        f"{name:28}{len(found):6}{len(found) - len(ended):7}{len(local):7}{100 * near:8.1f}"
        f"{np.percentile(estimate, 5):9.2g}{np.median(estimate):8.2g}{np.percentile(estimate, 95):8.2g}"
        f"{len(wrong):7}{sum(it.silent for it in wrong):7}"
        f"{sum(it.warned and it.true < RIGHT for it in ended):7}"
        f"{100 * np.mean(shares) if shares else np.nan:8.2f}"
    )


def table(found: Sequence[Found]) -> str:
    lines = [f"{'':28}{'runs':>6}{'failed':>7}{'local':>7}{'in 30':>8}{'5 %':>9}{'median':>8}{'95 %':>8}"
             f"{'wrong':>7}{'silent':>7}{'false':>7}{'bands':>8}"]  # fmt: skip
    keys = {
        "integrator": lambda it: it.name,
        "family": lambda it: it.family,
        "formulation": lambda it: it.how.get("formulation", "standard"),
        "stabilization": lambda it: it.how.get("stabilization", "usual"),
        "size": lambda it: f"{'rtol' if 'adaptive' in it.how else 'step'} {it.size:g}",
    }
    for what, key in keys.items():
        lines.append(f"-- {what}")
        groups: dict[str, list[Found]] = {}
        for it in found:
            groups.setdefault(key(it), []).append(it)
        lines += [line(name, group) for name, group in sorted(groups.items())]
    return "\n".join([*lines, "--", line("all", found)])


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--mechanisms", type=int, default=300, help="that are not left out")
    parser.add_argument("--seed", type=int, default=0, help="the first")
    parser.add_argument("--methods", type=int, default=3, help="of each mechanism, beside rk4")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=np.inf, help="after which no mechanism is begun")
    parser.add_argument("--json", help="write every run to this file")
    given = parser.parse_args()
    found: list[Found] = []
    left_out: dict[str, int] = {}
    count, began = 0, time.perf_counter()
    with ProcessPoolExecutor(given.processes) as pool:
        seed = given.seed
        while count < given.mechanisms and time.perf_counter() - began < 60 * given.minutes:
            seeds = range(seed, seed + min(8 * given.processes, given.mechanisms - count))
            seed = seeds.stop
            for why, runs in pool.map(study, seeds, [given.methods] * len(seeds)):
                if why:
                    left_out[why.split(":")[0]] = left_out.get(why.split(":")[0], 0) + 1
                    continue
                count += 1
                found += runs
    print(table(found))
    print(
        f"{count} mechanisms, left out {left_out}; {len(found)} runs in {time.perf_counter() - began:.0f} s"
    )
    for it in found:
        if it.silent:
            print(
                f"silent: {it.seed} {it.family} {it.how} {it.size:g}: {it.true:.2g} off, said {it.error:.2g}"
            )
    if given.json:
        Path(given.json).write_text(json.dumps([asdict(it) for it in found], default=float))


if __name__ == "__main__":
    main()
