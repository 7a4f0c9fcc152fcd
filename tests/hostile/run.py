"""Tries to break linkwork: `./dev hostile [--minutes N] [--seed S]` prints what was tried and what failed.

Each part is a function of a random generator that tries one thing and raises Failure where a promise of
docs/reliability.md is broken. Parts take turns until the time is over; a failure is told with its seed, by
which `--part NAME --seed S --trials 1` repeats it.
"""

from __future__ import annotations

import argparse
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import attacks
import calls
import files
import linkwork as lw
import numpy as np
from children import Failure
from linkwork import mechanisms

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))

from recorded import FIELDS, PAIRS, bits_after

SMALL = ("pendulum", "four_bar", "bricard", "flyball_governor", "heavy_top", "bennett", "watt_six_bar")

#: Tries once, or as often as it returns.
Part = Callable[[random.Random, Path], int | None]


def simulate(model: lw.Model, t_end: float, **choices: Any) -> lw.Result:
    return lw.simulate(model, t_end, progress=False, on_inaccurate="pass", **choices)


def random_choices(rng: random.Random, t_end: float) -> dict[str, Any]:
    choices: dict[str, Any] = {"formulation": rng.choice(["standard", "penalty", "augmented_lagrangian"])}
    if rng.random() < 0.6:
        choices["integrator"] = rng.choice(list(lw.integrators.METHODS))
        choices |= {"step": t_end / rng.choice([40, 150, 333]), "record_every": rng.choice([1, 3])}
    else:
        choices |= {"integrator": rng.choice(PAIRS), "rtol": 10 ** rng.uniform(-8, -3), "record_every": 1}
    if rng.random() < 0.3:
        choices["linear_solver"] = rng.choice(["dense", "klu", "cholmod", "eigen_ldlt", "block"])
    return choices


def resume(rng: random.Random, folder: Path) -> None:
    """A run that ends and goes on has the bits of one that does not."""
    model = getattr(mechanisms, rng.choice(SMALL))()
    t_end = rng.choice([0.05, 0.2, 1.0])
    choices, middle = random_choices(rng, t_end), t_end * rng.uniform(0.1, 0.9)
    try:
        whole = simulate(model, t_end, **choices)
    except lw.LinkworkError:
        return
    first = simulate(model, middle, **choices)
    if rng.random() < 0.5:
        first.save(folder / "first.h5")
        first = lw.Result.load(folder / "first.h5")
    rest = simulate(model, t_end, start=first.snapshot(), **choices)
    if not rest.manifest["resumed"] or bits_after(rest, middle) != bits_after(whole, middle):
        raise Failure(f"{model.name} {choices} from {middle!r} to {t_end!r} s")


WRITER = """
import sys, linkwork as lw
from linkwork import mechanisms
lw.simulate(mechanisms.four_bar(), 1e3, 1e-4, "ab4", record_every=20, output=sys.argv[1], progress=False)
"""


def interrupt(rng: random.Random, folder: Path) -> None:
    """A run that is killed or ended leaves whole frames, and goes on from them to the last bit."""
    path, number = folder / "run.h5", rng.choice([signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
    process = subprocess.Popen([sys.executable, "-c", WRITER, path], stderr=subprocess.DEVNULL)
    time.sleep(rng.uniform(1.0, 3.0))
    process.send_signal(number)
    try:
        process.wait(60.0)
    except subprocess.TimeoutExpired:
        process.kill()
        raise Failure(f"signal {number} was not honored in a minute") from None
    if not path.exists():
        return
    found = lw.Result.load(path)
    if found.finished or not np.isfinite(found.q).all():
        raise Failure(f"signal {number}: finished {found.finished}, {len(found)} frames")
    if len(found) and found.snapshot().resume is not None:
        end, choices = float(found.t[-1]), {"step": 1e-4, "integrator": "ab4", "record_every": 20}
        if end > 2.0:
            return
        rest = simulate(mechanisms.four_bar(), end + 0.01, start=found.snapshot(), **choices)
        whole = simulate(mechanisms.four_bar(), end + 0.01, **choices)
        if bits_after(rest, end) != bits_after(whole, end):
            raise Failure(f"signal {number}: other bits after {end!r} s")


HUGE = (
    np.nan,
    np.inf,
    -np.inf,
    1e155,
    1e200,
    1e308,
    -1e308,
    5e-324,
    0.0,
    -1.0,
    2**63,
    10**400,
    "x",
    None,
    [],
    b"x",
)


def value(rng: random.Random, folder: Path) -> None:
    """Hostile values in calls give errors of linkwork, or finite numbers."""
    hostile = rng.choice(HUGE)
    state = {"mass": 1.0, "inertia": (1, 1, 1), "position": (0.5, 0, 0), "velocity": (0, 0, 0)}
    run: dict[str, Any] = {"t_end": 0.05, "step": 1e-2}
    where = rng.choice(
        [*state, "t_end", "step", "record_every", "rtol", "atol", "times", "breaks", "gravity"]
    )
    gravity: Any = (0, 0, -9.81)
    if where == "gravity":
        gravity = (0, 0, hostile)
    elif where in ("inertia", "position", "velocity"):
        state[where] = (hostile, 0, 0) if where != "inertia" else (hostile,) * 3
    elif where == "mass":
        state[where] = hostile
    else:
        run[where] = hostile
    try:
        model = lw.Model(gravity=gravity)
        model.body("b", **state)  # type: ignore[arg-type]
        model.spherical("ground", "b", at=(0, 0, 0))
        found = lw.simulate(model, progress=False, on_inaccurate="pass", **run)
    except lw.LinkworkError:
        return
    if not all(np.isfinite(found.recorded(name)).all() for name in FIELDS):
        raise Failure(f"{where} = {hostile!r}: frames that are not finite")


OWN = (resume, interrupt, value)
OTHERS = (
    calls.call, files.damage, files.model_file, files.stores, attacks.kill, attacks.end, attacks.disk,
    attacks.writers, attacks.allocation, attacks.memory_limit, attacks.cycles, attacks.threads, attacks.fork,
    attacks.callbacks, attacks.not_a_number,
)  # fmt: skip
PARTS: dict[str, Part] = {part.__name__: part for part in (*OWN, *OTHERS)}


def attempt(name: str, seed: int) -> tuple[int, str]:
    """How many trials it was, and what failed, "" where nothing did."""
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            count = PARTS[name](random.Random(f"{name} {seed}"), Path(folder))
        except Failure as failure:
            return 1, str(failure)
        except Exception as error:
            return 1, f"{type(error).__name__}: {error}"
    return (1 if count is None else count), ""


def processor_seconds() -> float:
    """Of this process and of those that it has waited for."""
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime


def table(tried: dict[str, int], failed: dict[str, int], processor: dict[str, float], seconds: float) -> str:
    lines = [f"{'part':<12} {'tried':>8} {'failed':>8} {'processor s':>12}"]
    lines += [f"{it:<12} {tried[it]:>8} {failed[it]:>8} {processor[it]:>12.1f}" for it in tried]
    return "\n".join([*lines, f"{seconds:.0f} s"])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--minutes", type=float, default=5.0)
    parser.add_argument("--seed", type=int, default=1, help="of the first trial of each part")
    parser.add_argument("--part", choices=list(PARTS), action="append", help="only these")
    parser.add_argument("--trials", type=int, default=10**9, help="the most turns of each part")
    given = parser.parse_args()
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which what runs in the background else ignores
    names = given.part or list(PARTS)
    tried, failed = dict.fromkeys(names, 0), dict.fromkeys(names, 0)
    spent, turns = dict.fromkeys(names, 0.0), dict.fromkeys(names, 0)
    processor = dict.fromkeys(names, 0.0)
    begun = time.monotonic()
    while time.monotonic() - begun < 60 * given.minutes and min(turns.values()) < given.trials:
        name = min((it for it in names if turns[it] < given.trials), key=spent.__getitem__)
        seed, started, before = given.seed + turns[name], time.monotonic(), processor_seconds()
        count, what = attempt(name, seed)
        spent[name] += time.monotonic() - started
        processor[name] += processor_seconds() - before
        tried[name] += count
        turns[name] += 1
        if what:
            failed[name] += 1
            print(f"{name}, seed {seed}: {what:.1000}", flush=True)
    print(table(tried, failed, processor, time.monotonic() - begun))
    return 1 if any(failed.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
