"""Tries to break linkwork: `./dev hostile [--minutes N] [--seed S]` prints what was tried and what failed.

Each part is a function of a random generator that tries one thing and raises Failure where a promise of
docs/reliability.md is broken. Parts take turns until the time is over; a failure is told with its seed, by
which `--part NAME --seed S --trials 1` repeats it.
"""

from __future__ import annotations

import argparse
import os
import random
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


def damage(rng: random.Random, folder: Path) -> None:
    """A result with another bit or byte says so, or has the numbers that were written."""
    path = folder / "result.h5"
    whole = simulate(mechanisms.four_bar(), 0.1, step=1e-3)
    whole.save(path)
    content = bytearray(path.read_bytes())
    for _ in range(rng.choice([1, 1, 4])):
        place = rng.randrange(len(content))
        content[place] ^= 1 << rng.randrange(8)
    if rng.random() < 0.3:
        del content[rng.randrange(len(content)) :]
    path.write_bytes(content)
    try:
        found = lw.Result.load(path)
        q = found.q
    except lw.FileError:
        return
    if not np.array_equal(q, whole.q[: len(q)]) or (found.finished and len(q) < len(whole)):
        raise Failure(f"{len(q)} frames, finished {found.finished}")


MODEL = mechanisms.four_bar()


def model_file(rng: random.Random, folder: Path) -> None:
    """A model file with other bytes is read, or refused in words."""
    path = folder / f"model{rng.choice(['.yaml', '.json'])}"
    MODEL.save(path)
    content = bytearray(path.read_bytes())
    for _ in range(rng.choice([1, 2, 20])):
        place = rng.randrange(len(content))
        action = rng.randrange(4)
        if action == 0:
            content[place] = rng.randrange(256)
        elif action == 1:
            del content[place : place + rng.randrange(1, 40)]
        elif action == 2:
            content[place:place] = rng.choice([b"[", b"{", b"]", b": ", b"\n", b"1e999", b'"', b"\0", b"- "])
        else:
            piece = content[place : place + rng.randrange(1, 200)]
            content[place:place] = piece * rng.choice([1, 2, 50])
        content = content or bytearray(b" ")
    path.write_bytes(content)
    try:
        lw.Model.load(path)
    except lw.FileError as error:
        if len(getattr(error, "faults", ())) > 23:
            raise Failure(f"{len(error.faults)} faults") from error  # type: ignore[attr-defined]


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


OWN = (resume, interrupt, damage, model_file, value)
OTHERS = (
    attacks.kill, attacks.end, attacks.disk, attacks.writers, attacks.zeros, attacks.structure,
    attacks.allocation, attacks.memory_limit, attacks.cycles, attacks.threads, attacks.fork,
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


def table(tried: dict[str, int], failed: dict[str, int], seconds: float) -> str:
    lines = [f"{'part':<12} {'tried':>8} {'failed':>8}"]
    lines += [f"{name:<12} {tried[name]:>8} {failed[name]:>8}" for name in tried]
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
    begun = time.monotonic()
    while time.monotonic() - begun < 60 * given.minutes and min(turns.values()) < given.trials:
        name = min((it for it in names if turns[it] < given.trials), key=spent.__getitem__)
        seed, started = given.seed + turns[name], time.monotonic()
        count, what = attempt(name, seed)
        spent[name] += time.monotonic() - started
        tried[name] += count
        turns[name] += 1
        if what:
            failed[name] += 1
            print(f"{name}, seed {seed}: {what:.300}", flush=True)
    print(table(tried, failed, time.monotonic() - begun))
    return 1 if any(failed.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
