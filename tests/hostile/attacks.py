"""What is done to a process: signals, full disks, no memory, threads, forks, functions that misbehave.

Each is a part of `run.py`: it returns how many trials it was.
"""

from __future__ import annotations

import gc
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import allocations
import linkwork as lw
import numpy as np
from children import Failure, child, ended, guarded
from linkwork import mechanisms

SMALL = ("pendulum", "four_bar", "bricard", "heavy_top", "bennett", "watt_six_bar", "spatial_slider_crank")


def small(rng: random.Random) -> lw.Model:
    return getattr(mechanisms, rng.choice(SMALL))()  # type: ignore[no-any-return]


def quiet(model: lw.Model, t_end: float, step: float, **choices: Any) -> lw.Result:
    return lw.simulate(model, t_end, step, progress=False, on_inaccurate="pass", **choices)


def check_file(path: Path, model: lw.Model, **choices: Any) -> lw.Result:
    """Its frames are those of a run that nothing has happened to. Failure."""
    found = lw.Result.load(path)
    if len(found) > 1:
        whole = quiet(model, float(found.t[-1]), 1e-4, record_every=choices.get("record_every", 1))
        if not np.array_equal(whole.q[: len(found)], found.q):
            raise Failure(f"{len(found)} frames, not those that were computed")
    return found


# --- ends from outside ------------------------------------------------------------------------------------


def kill(rng: random.Random, folder: Path) -> int:
    """kill -9, ten times each: whole frames, and the next run may take the place."""
    model, path = small(rng), folder / "run.h5"
    for _ in range(10):
        pid = child(lambda: quiet(model, 1e3, 1e-4, record_every=1, output=path, overwrite=True))
        time.sleep(0.005 * 100 ** rng.random())
        os.kill(pid, signal.SIGKILL)
        ended(pid)
        if path.exists() and check_file(path, model).finished:
            raise Failure("a run that was killed is finished")
    return 10


def end(rng: random.Random, folder: Path) -> int:
    """SIGTERM and ctrl-C: the file is closed in order."""
    model, path = small(rng), folder / "run.h5"

    def run() -> None:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        try:
            quiet(model, 1e3, 1e-4, record_every=1, output=path, overwrite=True)
        except KeyboardInterrupt:
            os._exit(7)

    pid = child(run)
    while not path.exists():
        time.sleep(0.001)
    time.sleep(rng.uniform(0.01, 0.3))
    os.kill(pid, rng.choice([signal.SIGTERM, signal.SIGINT]))
    patience = threading.Timer(60.0, os.kill, (pid, signal.SIGKILL))
    patience.start()
    code = ended(pid)
    patience.cancel()
    if code != 7:
        raise Failure(f"exit code {code}")
    if check_file(path, model).status != "interrupted" or list(folder.iterdir()) != [path]:
        raise Failure(f"left {sorted(it.name for it in folder.iterdir())}")
    return 1


# --- disks and files --------------------------------------------------------------------------------------


@contextmanager
def small_disk(folder: Path, size: int) -> Iterator[Path | None]:
    """None: only root makes one."""
    mount, umount = shutil.which("mount"), shutil.which("umount")
    place = folder / "disk"
    place.mkdir()
    options = ["-t", "tmpfs", "-o", f"size={size}", "none", str(place)]
    made = (
        mount and os.geteuid() == 0 and subprocess.run([mount, *options], capture_output=True).returncode == 0
    )
    try:
        yield place if made else None
    finally:
        if made and umount:
            subprocess.run([umount, str(place)], check=False)


def disk(rng: random.Random, folder: Path) -> int:
    """A disk that is full, or a file that may not grow, at any byte: a FileError, and whole frames."""
    model, size = small(rng), int(10 ** rng.uniform(2, 6.5))

    def run(path: Path) -> None:
        try:
            quiet(model, 1.0, 1e-4, record_every=1, output=path, verify=rng.random() < 0.3)
        except lw.FileError:
            return
        except lw.LinkworkWarning:
            return

    def limited(path: Path) -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        run(path)

    with small_disk(folder, max(size, 4096)) as place:
        path = (place or folder) / "run.h5"
        guarded(lambda: (run if place else limited)(path))
        if path.exists():
            check_file(path, model)
    return 1


def writers(rng: random.Random, folder: Path) -> int:
    """Two runs with one output: one of them has it, and says so."""
    model, path = small(rng), folder / "run.h5"
    times = [rng.uniform(0.2, 0.5), rng.uniform(0.2, 0.5)]

    def run(t_end: float) -> None:
        try:
            quiet(model, t_end, 1e-4, record_every=1, output=path, overwrite=True)
        except lw.FileError as error:
            if error.code not in ("busy", "replaced"):
                raise

    pids = [child(lambda t_end=t_end: run(t_end)) for t_end in times]  # type: ignore[misc]
    codes = [ended(pid) for pid in pids]
    if any(codes) or not check_file(path, model).finished:
        raise Failure(f"exit codes {codes}")
    return 1


# --- memory -----------------------------------------------------------------------------------------------


def allocation(rng: random.Random, folder: Path) -> int:
    """One allocation that fails, eighty times, in a process of its own; see `allocations`."""
    library, source = folder / "failing.so", Path(__file__).with_name("failing_malloc.c")
    compiler = shutil.which("cc")
    if compiler is None or not sys.platform.startswith("linux"):
        return 0
    subprocess.run([compiler, "-shared", "-fPIC", "-O1", "-o", library, source], check=True)
    words = [sys.executable, allocations.__file__, str(rng.randrange(10**9)), "20"]
    environment = {**os.environ, "LD_PRELOAD": str(library)}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=3600)
    failed = [line for line in done.stdout.splitlines() if line.startswith("FAILED")]
    if failed or done.returncode:
        raise Failure(f"seed {words[2]}: {failed or done.stderr[-300:]}")
    return 80


def memory_limit(rng: random.Random, folder: Path) -> int:
    """Less memory than it takes: MemoryError, an error in words, or the result; never a hang."""
    model, megabytes = mechanisms.net(rng.choice([4, 30])), int(10 ** rng.uniform(1, 3))
    solver = rng.choice(["block", "klu", "spqr", "umfpack", "eigen_ldlt"])

    def run() -> None:
        taken = 4096 * int(Path("/proc/self/statm").read_text().split()[0])
        resource.setrlimit(resource.RLIMIT_AS, (taken + megabytes * 2**20,) * 2)
        try:
            quiet(model, 2e-3, 1e-3, linear_solver=solver, formulation="augmented_lagrangian")
        except (MemoryError, lw.LinkworkError):
            return
        except ImportError as error:  # of a module of Python's own
            if "map segment" not in str(error):
                raise

    guarded(run, 300)
    return 1


def cycles(rng: random.Random, folder: Path) -> int:
    """Models, systems and runs that are made and given up, 200 times: memory does not grow."""

    def resident() -> int:
        gc.collect()
        return 4096 * int(Path("/proc/self/statm").read_text().split()[1])

    def run() -> None:
        for k in range(240):
            if k == 40:
                before = resident()
            model = small(rng)
            system = lw.System(model)
            system.derivative(0.0, system.initial_state())
            quiet(model, 5e-3, 1e-3)
        grown = resident() - before
        if grown > 8 * 2**20:
            raise Failure(f"{grown / 2**20:.1f} MB more")

    guarded(run, 600)
    return 200


# --- threads and forks ------------------------------------------------------------------------------------


def threads(rng: random.Random, folder: Path) -> int:
    """Eight threads on systems of their own, or on one: the right numbers, or a BusyError."""
    model, shared = small(rng), rng.random() < 0.5
    one = lw.System(model)
    y, expected = one.initial_state(), one.derivative(0.0, one.initial_state())
    faults: list[str] = []

    def work() -> None:
        system = one if shared else lw.System(model)
        for _ in range(50):
            try:
                if not np.array_equal(system.derivative(0.0, y), expected):
                    faults.append("other rates")
            except lw.BusyError:
                if not shared:
                    faults.append("busy, and its own")
            except Exception as error:
                faults.append(repr(error))

    workers = [threading.Thread(target=work) for _ in range(8)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    if faults:
        raise Failure(f"{model.name}, shared {shared}: {faults[:3]}")
    return 1


def fork(rng: random.Random, folder: Path) -> int:
    """Forks of a process that has computed, and that computes in another thread: the same bits."""
    model = small(rng)
    expected = quiet(model, 0.02, 1e-3).q
    going = threading.Event()

    def compute() -> None:
        while not going.is_set():
            quiet(model, 0.02, 1e-3)

    other = threading.Thread(target=compute)
    other.start()
    try:
        for _ in range(3):
            guarded(lambda: np.testing.assert_array_equal(quiet(model, 0.02, 1e-3).q, expected), 30)
    finally:
        going.set()
        other.join()
    return 3


# --- functions and numbers --------------------------------------------------------------------------------


class Own(Exception):
    """Of the user's own function."""


def misbehaving(rng: random.Random, system: list[lw.System]) -> Callable[..., Any]:
    """A function that is right until it is not."""
    calls, last = [0], rng.randrange(1, 60)

    def raises(error: BaseException) -> Any:
        raise error

    bad = rng.choice([
        lambda: raises(Own("own")), lambda: raises(StopIteration()), lambda: raises(RecursionError()),
        lambda: raises(lw.LinkworkError("mine")), lambda: raises(GeneratorExit()),
        lambda: raises(MemoryError()),
        lambda: math.nan, lambda: math.inf, lambda: -math.inf, lambda: 1e300, lambda: "x", lambda: None,
        lambda: [1.0, 2.0], lambda: 1j, lambda: np.zeros(3), lambda: 10**400,
        lambda: system[0].derivative(0.0, system[0].initial_state()) if system else math.nan,
    ])  # fmt: skip

    def function(*_: Any) -> Any:
        calls[0] += 1
        return 0.1 if calls[0] < last else bad()

    return function


def own_integrator(own: Callable[..., Any]) -> Callable[..., Any]:
    return lambda system, t, y, h: y + h * system.derivative(t, y) * float(own())


def callbacks(rng: random.Random, folder: Path) -> int:
    """Functions of the user's in every place, ten times: their own error, one of ours, or finite frames."""
    for _ in range(10):
        system: list[lw.System] = []
        own = misbehaving(rng, system)
        model = lw.Model()
        body = model.body("b", mass=1.0, inertia=(1, 1, 1), position=(0.5, 0, 0))
        choices: dict[str, Any] = {"step": 1e-2}
        place, running = rng.choice(["force", "drive", "event", "integrator", "progress"]), False
        try:
            joint = model.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0))
            if place == "drive":
                model.drive(joint, position=own)
            if place == "force":
                model.force(body, force=(own, 0.0, 0.0))
            if place == "event":
                choices |= {"events": [lw.Event(own)], "rtol": 1e-6}
            if place == "integrator":
                choices["integrator"] = own_integrator(own)
            if place == "progress":
                choices["progress"] = own
            system.append(lw.System(model))
            running = True
            found = lw.simulate(model, 0.3, **{"progress": False, "on_inaccurate": "pass", **choices})
        except (lw.LinkworkError, Own, RecursionError, MemoryError, GeneratorExit):
            continue
        except Exception as error:
            own = place == "integrator" if running else True  # what is written here calls the function
            if own and not (running and isinstance(error, StopIteration)):
                continue
            raise Failure(f"{place}: {type(error).__name__}: {error}") from error
        if not all(np.isfinite(found.recorded(name)).all() for name in ("q", "v", "vdot", "lambda")):
            raise Failure(f"{place}: frames that are not finite")
    return 10


def not_a_number(rng: random.Random, folder: Path) -> int:
    """NaN and infinities in states, twenty times: an error that says so, never a number."""
    model = small(rng)
    system = lw.System(model)
    whole = system.initial_state()
    rates = system.derivative(0.0, whole)
    for _ in range(20):
        y, t = whole.copy(), 0.0
        if rng.random() < 0.9:
            y[rng.randrange(len(y))] = rng.choice([math.nan, math.inf, -math.inf])
        else:
            t = rng.choice([math.nan, math.inf])
        n = model.body_count
        try:
            if rng.random() < 0.5:
                found: Any = system.derivative(t, y)
            else:
                found = system.accelerations(t, y[: 7 * n], y[7 * n :])[0]
        except lw.LinkworkError:
            continue
        raise Failure(f"{model.name}: {found}")
    if not np.array_equal(system.derivative(0.0, whole), rates):
        raise Failure(f"{model.name}: other rates afterwards")
    return 20
