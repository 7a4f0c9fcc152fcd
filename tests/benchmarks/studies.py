"""Studies of many cases: how fast, how much memory and disk, and what kills do to them.

python tests/benchmarks/studies.py throughput [--cases 100000] [--alone 400] [--rounds 3]
python tests/benchmarks/studies.py workers [--cases 10000] [--every 3] [--shards 8]
python tests/benchmarks/studies.py bookkeeping [--cases 20000]

each with [--processes 2] [--seed 1] [--minutes 120] [--folder DIR] [--json FILE].

throughput   a crank-rocker for 1000 steps of rk4, by `sweep` and by a pool of processes that call `simulate`,
             in turn; memory over the time of the study, time to its first results, files and bytes of its store
workers      the same study on a cluster of Dask on loopback whose workers are killed one after the other,
             in shards of which three are killed, and on a cluster whose scheduler is killed: every case is in
             the store once, with the bits of a study without a cluster
bookkeeping  a pendulum for two steps: what a case costs beside its simulation

Memory is resident, of the process that calls `sweep` and of the largest of its children. Every figure with a
limit says whether it holds; where one does not, the script ends with 1. Nothing listens but on loopback.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import logging
import math
import multiprocessing
import os
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import psutil
from linkwork.arrays import Floats
from linkwork.mechanisms import thin_rod

STEP, STEPS = 1e-3, 1000
VARIED = {"coupler.mass": (1.5, 2.5), "rocker.mass": (1.0, 2.0), "gravity[2]": (-10.0, -9.6)}

#: Limits: of a store [bytes a case beyond its outputs, files], and of the growth of memory after a quarter of
#: a study, where it should be at its largest.
BEYOND, FILES, GROWTH = 1000, 100_000, 1.1

#: Between two samples of memory, and between two looks at a store that is waited for [s].
SAMPLE, LOOK = 0.25, 0.1

#: Cases that are compared with their own runs, and shards that are killed.
COMPARED, KILLED = 8, 3


@dataclass
class Report:
    """Figures by name, and those that do not hold."""

    figures: dict[str, Any] = field(default_factory=dict)
    failed: list[str] = field(default_factory=list)

    def note(self, name: str, value: Any, holds: bool | None = None) -> None:
        """Prints a figure; `holds`: whether it keeps its limit, None where it has none."""
        self.figures[name] = value
        if holds is False:
            self.failed.append(name)
        shown = f"{value:.4g}" if isinstance(value, float) else str(value)
        print(f"{name:52} {shown}{'' if holds is None else '  ok' if holds else '  DOES NOT HOLD'}", flush=True)


# --- mechanisms ---


def crank_rocker(coupler: float = 2.0, rocker: float = 1.5, gravity: float = -9.81) -> lw.Model:
    """A planar four-bar, bars of 0.5, 2.0, 1.5 and 2.0 m, of these masses [kg]; its crank turns fully."""
    model = lw.Model(gravity=(0, 0, gravity), name="crank-rocker")
    base, crank_end = np.array((2.0, 0, 0)), np.array((0, 0, 0.5))
    across = base - crank_end
    distance = float(np.linalg.norm(across))
    along = (2.0**2 - 1.5**2 + distance**2) / (2 * distance)  # the coupler on the line across
    e = across / distance
    elbow = crank_end + along * e + math.sqrt(2.0**2 - along**2) * np.array((-e[2], 0, e[0]))
    points = np.array([(0, 0, 0), crank_end, elbow, base])
    names, masses, usual = ("crank", "coupler", "rocker"), (1.0, coupler, rocker), (1.0, 2.0, 1.5)
    for name, mass, nominal, start, end in zip(names, masses, usual, points[:-1], points[1:], strict=True):
        model.body(name, mass=mass, inertia=thin_rod(nominal, float(np.linalg.norm(end - start))),
                   position=(start + end) / 2,
                   orientation=lw.rotation.from_axes(x=end - start, y=(0, 1, 0)))  # fmt: skip
    for pair, at in zip(zip(("ground", *names), (*names, "ground"), strict=True), points, strict=True):
        model.revolute(*pair, at=at, axis=(0, 1, 0), name=f"{pair[0]}-{pair[1]}")
    return model


def pendulum() -> lw.Model:
    model = lw.Model(name="rod")
    model.body("rod", mass=1.0, inertia=thin_rod(1.0, 1.0), position=(0.5, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


def final_state(values: Mapping[str, float], **options: Any) -> tuple[Floats, Floats]:
    """q and v at the end of a case of `crank_rocker`, run by itself."""
    result = lw.simulate(crank_rocker(*(values[name] for name in VARIED)), STEPS * STEP, STEP,
                         progress=False, **options)  # fmt: skip
    return np.asarray(result.q[-1]), np.asarray(result.v[-1])


def study_of(cases: int, seed: int) -> dict[str, Any]:
    """Arguments of `sweep`; the first cases are those of a larger one."""
    return {"model": crank_rocker(), "parameters": VARIED, "outputs": ["final"], "sampler": "random",
            "cases": cases, "seed": seed, "t_end": STEPS * STEP, "step": STEP, "progress": False}  # fmt: skip


# --- a study that is watched ---


@dataclass
class Watched:
    """A study in a process of its own: how it ended, how long it took [s], its memory over time [MB]."""

    counts: Mapping[str, int] = field(default_factory=dict)
    seconds: float = math.nan
    first: float = math.nan  # until something was in the store
    memory: list[tuple[float, float, float]] = field(default_factory=list)  # time [s], parent, largest child

    def note(self, report: Report, name: str, *, limited: bool = True) -> None:
        samples = np.array(self.memory)
        for k, who in ((1, "parent"), (2, "largest child")):
            at = [float(samples[int(share * (len(samples) - 1)), k]) for share in (0.25, 0.5, 0.75)]
            peak = float(samples[:, k].max())
            shown = ", ".join(f"{it:.0f}" for it in (samples[0, k], *at, peak))
            holds = peak <= GROWTH * at[0] if limited else None
            report.note(f"{name}: {who} at 0, 1/4, 1/2, 3/4, peak [MB]", shown, holds)


def _sweep(connection: Connection, arguments: Mapping[str, Any]) -> None:
    connection.send(time.monotonic())
    study = lw.sweep(**arguments)
    connection.send((time.monotonic(), Counter(study.status.tolist())))


def watched(**arguments: Any) -> Watched:
    """RuntimeError: its process died."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_sweep, args=(theirs, arguments))
    process.start()
    theirs.close()
    found, store = Watched(), Path(arguments["directory"]) / "cases"
    try:
        began, known = ours.recv(), psutil.Process(process.pid)
        while not ours.poll(SAMPLE if found.first > 0 else 0.02):
            now = time.monotonic() - began
            if not found.first > 0 and store.is_dir() and any(store.glob("*.jsonl")):
                found.first = now
            found.memory.append((now, *_memory(known)))
        ended, found.counts = ours.recv()
    except EOFError as error:
        raise RuntimeError("the process of a study died") from error
    finally:
        process.kill()
        process.join()
    found.seconds = ended - began
    return found


def _memory(process: psutil.Process) -> tuple[float, float]:
    """Of the process, and of the largest of its children [MB]."""
    children = [0.0]
    for child in process.children():
        with contextlib.suppress(psutil.NoSuchProcess):
            children.append(child.memory_info().rss / 1e6)
    return process.memory_info().rss / 1e6, max(children)


# --- stores ---


def runs_of(directory: Path) -> Iterator[dict[str, Any]]:
    """Every line of a store that is a case."""
    for path in sorted((directory / "cases").glob("*.jsonl")):
        with path.open() as lines:
            next(lines)
            yield from map(json.loads, lines)


def kept(directory: Path) -> int:
    """Cases that are in a store."""
    return sum(json.loads(path.open().readline())["cases"] for path in (directory / "cases").glob("*.jsonl"))


def note_store(report: Report, name: str, directory: Path, cases: int) -> None:
    keys, outputs = Counter[str](), 0
    for run in runs_of(directory):
        keys[run["key"]] += 1
        outputs += len(json.dumps(run["outputs"]))
    files = [path for path in directory.rglob("*") if path.is_file()]
    size = sum(path.stat().st_size for path in files)
    report.note(f"{name}: files", len(files), len(files) <= FILES)
    report.note(f"{name}: bytes a case", size / cases)
    report.note(f"{name}: bytes a case beyond outputs", (size - outputs) / cases,
                size - outputs <= BEYOND * cases)  # fmt: skip
    report.note(f"{name}: cases that are there once", sum(count == 1 for count in keys.values()),
                len(keys) == cases == keys.total())  # fmt: skip


def note_bits(report: Report, name: str, directory: Path, seed: int) -> None:
    """Some cases of a store beside their own deterministic runs."""
    runs = list(runs_of(directory))
    chosen = random.Random(seed).sample(runs, COMPARED)
    same = 0
    for run in chosen:
        q, v = final_state(run["values"], deterministic=True)
        same += np.array_equal(q, run["outputs"]["final.q"]) and np.array_equal(v, run["outputs"]["final.v"])
    report.note(f"{name}: of {COMPARED} cases have the bits of simulate", same, same == COMPARED)


def note_same(report: Report, name: str, given: Mapping[str, Any], directory: Path, expected: Path) -> None:
    """Two stores of one study: every case once, none failed, the same bits."""
    found, wanted = (lw.sweep(**given, directory=it, gather=True) for it in (directory, expected))
    differ = np.zeros(len(found), dtype=bool)
    for label, values in wanted.outputs.items():
        differ |= (found.outputs[label] != values).reshape(len(found), -1).any(axis=1)
    keys = Counter(run["key"] for run in runs_of(directory))
    finished = int((found.status == "finished").sum())
    report.note(f"{name}: finished", finished, finished == len(found))
    report.note(f"{name}: lines in the store", keys.total(), len(keys) == keys.total() == len(found))
    report.note(f"{name}: cases with other bits", int(differ.sum()), not differ.any())


# --- throughput ---


def throughput(given: argparse.Namespace, folder: Path, report: Report) -> None:
    small = study_of(max(64, COMPARED), given.seed)
    watched(**small, directory=folder / "small", processes=given.processes)
    note_bits(report, "a small study", folder / "small", given.seed)
    ratios = []
    for k in range(given.rounds):
        name, directory = f"round {k + 1}", folder / f"round {k + 1}"
        study = study_of(given.cases, given.seed + k)
        run = watched(**study, directory=directory, processes=given.processes)
        report.note(f"{name}: how cases ended", dict(run.counts), run.counts == {"finished": given.cases})
        report.note(f"{name}: sweep [cases/s]", given.cases / run.seconds)
        report.note(f"{name}: time to the first results [s]", run.first)
        run.note(report, name)
        rows = [run["values"] for run, _ in zip(runs_of(directory), range(given.alone), strict=False)]
        with ProcessPoolExecutor(given.processes) as pool:
            list(pool.map(final_state, rows[: 2 * given.processes]))  # so that its processes are there
            began = time.perf_counter()
            list(pool.map(final_state, rows, chunksize=5))
            alone = len(rows) / (time.perf_counter() - began)
        ratios.append(given.cases / run.seconds / alone)
        report.note(f"{name}: pool of simulate [cases/s]", alone)
        report.note(f"{name}: sweep to pool", ratios[-1])
        note_bits(report, name, directory, given.seed + k)
        note_store(report, name, directory, given.cases)
    report.note("sweep to pool, median", float(np.median(ratios)))


# --- workers ---


class Cluster:
    """A scheduler of Dask and two workers, each a process of its own, on loopback."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir()
        self.folder, self.file = folder, folder / "scheduler.json"
        self.processes: list[subprocess.Popen[bytes]] = []
        self.scheduler = self._start("scheduler", "--port", "0")
        self.crew = [self.worker(), self.worker()]
        self.kills = 0

    def _start(self, what: str, *options: str) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", "dask", what, "--scheduler-file", str(self.file), "--no-dashboard",
                   "--host", "127.0.0.1", *options]  # fmt: skip
        environment = os.environ | {"DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s"}
        self.processes.append(subprocess.Popen(command, stderr=subprocess.DEVNULL, cwd=self.folder,
                                               env=environment))  # fmt: skip
        return self.processes[-1]

    def worker(self) -> subprocess.Popen[bytes]:
        return self._start("worker", "--nthreads", "1", "--no-nanny")

    def kill_one(self) -> None:
        """By turns; another one takes its place."""
        k = self.kills % len(self.crew)
        os.kill(self.crew[k].pid, signal.SIGKILL)
        self.crew[k].wait()
        self.crew[k] = self.worker()
        self.kills += 1

    @contextlib.contextmanager
    def client(self) -> Iterator[Any]:
        import distributed

        waited_for(self.file.exists, 60)
        client = distributed.Client(scheduler_file=str(self.file), timeout="60s")
        try:
            client.wait_for_workers(len(self.crew), timeout=60)
            yield client
        finally:
            with contextlib.suppress(Exception):  # its scheduler may be gone
                client.close(timeout=2)

    def __enter__(self) -> Cluster:
        return self

    def __exit__(self, *_: object) -> None:
        for process in self.processes:
            process.kill()
            process.wait()


def waited_for(condition: Callable[[], bool], seconds: float, over: Callable[[], bool] = lambda: False) -> bool:
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline and not over():
        if condition():
            return True
        time.sleep(LOOK)
    return False


@contextlib.contextmanager
def meanwhile(action: Callable[[threading.Event], None]) -> Iterator[None]:
    """In a thread of its own, which is told when it is over."""
    over = threading.Event()
    thread = threading.Thread(target=action, args=(over,))
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


def workers(given: argparse.Namespace, folder: Path, report: Report) -> None:
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what it says of those that are killed
    study, plain = study_of(given.cases, given.seed), folder / "plain"
    run = watched(**study, directory=plain, processes=given.processes)
    report.note("without a cluster [s]", run.seconds, run.counts == {"finished": given.cases})
    workers_killed(given, folder, report, study)
    shards_killed(given, folder, report, study)
    scheduler_killed(given, folder, report, study)


def workers_killed(given: argparse.Namespace, folder: Path, report: Report, study: dict[str, Any]) -> None:
    with Cluster(folder / "cluster") as cluster, cluster.client() as client:

        def kill(over: threading.Event) -> None:
            while not over.wait(given.every):
                cluster.kill_one()

        began = time.monotonic()
        with meanwhile(kill):
            found = lw.sweep(**study, executor=client, directory=folder / "workers")
        report.note("workers killed: time [s]", time.monotonic() - began)
        report.note("workers killed: kills", cluster.kills, cluster.kills > 0)
    for error in found.errors.values():
        report.figures.setdefault("workers killed: errors", []).append(error["message"])
    note_same(report, "workers killed", study, folder / "workers", folder / "plain")


def shards_killed(given: argparse.Namespace, folder: Path, report: Report, study: dict[str, Any]) -> None:
    """As jobs of an array, one after the other, by the command."""
    study["model"].save(folder / "model.yaml")
    wanted = {name: study[name] for name in ("t_end", "sampler", "cases", "seed", "outputs")}
    wanted |= {"linkwork_study": 1, "model": "model.yaml", "simulation": {"step": STEP},
               "parameters": {name: list(bounds) for name, bounds in VARIED.items()}}  # fmt: skip
    (folder / "shards.json").write_text(json.dumps(wanted))
    directory, killed = folder / "shards", 0
    for k in range(given.shards):
        if k < KILLED:
            killed += shard(given, folder, k, until=kept(directory) + given.cases // (4 * given.shards))
        else:
            shard(given, folder, k)
    report.note("shards: killed midway", killed, killed == KILLED)
    missing = given.cases - kept(directory)
    report.note("shards: missing then", missing, 0 < missing < KILLED * math.ceil(given.cases / given.shards))
    for k in range(KILLED):
        shard(given, folder, k)
    note_same(report, "shards", study, directory, folder / "plain")


def shard(given: argparse.Namespace, folder: Path, k: int, until: int | None = None) -> bool:
    """Runs one; killed when `until` cases are in the store. Whether it was. RuntimeError: it failed."""
    command = [str(Path(sys.executable).with_name("linkwork")), "sweep", str(folder / "shards.json"),
               "--shard", f"{k}/{given.shards}", "--processes", str(given.processes)]  # fmt: skip
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        try:
            if until is not None:
                over = lambda: process.poll() is not None  # noqa: E731
                if waited_for(lambda: kept(folder / "shards") >= until, 60 * given.minutes, over):
                    children = psutil.Process(process.pid).children()
                    process.kill()
                    _, left = psutil.wait_procs(children, timeout=30)
                    if left:
                        raise RuntimeError(f"{len(left)} processes outlived a shard that was killed")
                    return process.wait() == -signal.SIGKILL
            _, told = process.communicate()
        finally:
            process.kill()
    if process.returncode:
        raise RuntimeError(f"shard {k}: {told}")
    return False


def scheduler_killed(given: argparse.Namespace, folder: Path, report: Report, study: dict[str, Any]) -> None:
    directory, killed, told, began = folder / "scheduler", [], "", time.monotonic()
    with Cluster(folder / "lost cluster") as cluster, cluster.client() as client:

        def kill(over: threading.Event) -> None:
            if waited_for(lambda: kept(directory) >= given.cases // 3, 60 * given.minutes, over.is_set):
                cluster.scheduler.kill()
                killed.append(time.monotonic())

        with meanwhile(kill):
            try:
                lw.sweep(**study, executor=client, directory=directory)
            except lw.LinkworkError as error:
                told = f"{error.code}: {error}"
        ended = time.monotonic()
    report.note("scheduler killed: after, and told after [s]",
                f"{killed[0] - began:.1f}, {ended - killed[0]:.1f}" if killed else "never", bool(killed))  # fmt: skip
    report.note("scheduler killed: the error", told, told.startswith("executor: executor: works no more"))
    before = kept(directory)
    report.note("scheduler killed: cases kept", before, 0 < before < given.cases)
    watched(**study, directory=directory, processes=given.processes)
    note_same(report, "scheduler killed, resumed", study, directory, folder / "plain")


# --- bookkeeping ---


def bookkeeping(given: argparse.Namespace, folder: Path, report: Report) -> None:
    study = {"model": pendulum(), "parameters": {"rod.mass": (0.5, 2.0), "gravity[2]": (-10.0, -9.6)},
             "outputs": ["final"], "sampler": "random", "cases": given.cases, "seed": given.seed,
             "t_end": 2 * STEP, "step": STEP, "progress": False, "directory": folder / "store"}  # fmt: skip
    for name, more in (("sweep", {"processes": given.processes}), ("gather", {"gather": True})):
        run = watched(**study, **more)
        report.note(f"{name}: how cases ended", dict(run.counts), run.counts == {"finished": given.cases})
        report.note(f"{name}: a case [us]", 1e6 * run.seconds / given.cases)
        if name == "sweep":
            report.note("sweep: time to the first results [s]", run.first)
        run.note(report, name, limited=name == "sweep")
        peak = max(parent for _, parent, _ in run.memory) - run.memory[0][1]
        report.note(f"{name}: memory of the parent [bytes a case]", 1e6 * peak / given.cases)
    note_store(report, "store", folder / "store", given.cases)


PARTS = {"throughput": (throughput, 100_000), "workers": (workers, 10_000), "bookkeeping": (bookkeeping, 20_000)}


def ended(number: int, _: object) -> None:
    """Whatever ends the script, its processes end with it."""
    raise SystemExit(f"ended by {signal.Signals(number).name}")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("part", choices=PARTS)
    parser.add_argument("--cases", type=int, help="of a study; each part has its own number")
    parser.add_argument("--alone", type=int, default=400, help="throughput: cases of the pool in a round")
    parser.add_argument("--rounds", type=int, default=3, help="throughput: sweep and pool, in turn")
    parser.add_argument("--every", type=float, default=3.0, help="workers: between two kills [s]")
    parser.add_argument("--shards", type=int, default=8, help="workers: of which three are killed")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=120.0, help="after which it is given up")
    parser.add_argument("--folder", type=Path, help="where stores are written, and removed")
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    given = parser.parse_args()
    part, usual = PARTS[given.part]
    given.cases = given.cases or usual
    for number in (signal.SIGALRM, signal.SIGTERM):
        signal.signal(number, ended)
    signal.alarm(math.ceil(60 * given.minutes))
    report = Report()
    with tempfile.TemporaryDirectory(dir=given.folder) as folder:
        part(given, Path(folder), report)
    if given.json:
        given.json.write_text(json.dumps({**vars(report), "part": given.part, "cases": given.cases}, indent=1))
    sys.exit(bool(report.failed))


if __name__ == "__main__":
    main()
