"""Studies of many cases: how fast, how much memory and disk, and what kills do to them.

python tests/benchmarks/studies.py throughput [--cases 100000] [--alone 400] [--rounds 3]
python tests/benchmarks/studies.py workers [--cases 10000] [--every 3] [--shards 8]
python tests/benchmarks/studies.py bookkeeping [--cases 20000] [--answered SECONDS]
each with [--processes 2] [--minutes 120] [--folder DIR] [--json FILE]

throughput   a crank-rocker for 1000 steps of rk4, by `sweep` and by a pool of processes that call `simulate`,
             in turn; memory, time to the first results, files and bytes of the store
workers      the same study on a cluster of Dask on loopback whose workers are killed by turns, in shards of
             which three are killed, and on a cluster whose scheduler is killed: every case is in the store
             once, with the bits of a study without a cluster
bookkeeping  a pendulum for two steps: what a case costs beside its simulation; or not simulated at all, but
             answered at once by an executor that says each took so many seconds, for a million of cases

Memory is resident, of the process that calls `sweep` and of the largest of its children. A figure with a
limit says whether it holds; where one does not, the script ends with 1.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import logging
import math
import multiprocessing
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import psutil  # type: ignore[import-untyped]
import xarray as xr
from linkwork.arrays import Floats
from linkwork.mechanisms import thin_rod
from linkwork.studies.cases import Answer, Run, machine

sys.path.append(str(Path(__file__).parents[1] / "python"))

STEP, STEPS = 1e-3, 1000
VARIED = {"coupler.mass": (1.5, 2.5), "rocker.mass": (1.0, 2.0), "gravity[2]": (-10.0, -9.6)}

#: Limits: bytes of a store a case beyond its outputs, its files, and the largest memory of a study by the
#: largest in its first half.
BEYOND, FILES, GROWTH = 1000, 100_000, 1.1

#: Between two samples of memory, and between two looks at a store [s].
SAMPLE, LOOK = 0.25, 0.05

#: Cases that are compared with their own runs, and shards that are killed.
COMPARED, KILLED = 8, 3


@dataclass
class Report:
    """Figures by name, and those that do not `hold`; None: they have no limit."""

    figures: dict[str, Any] = field(default_factory=dict)
    failed: list[str] = field(default_factory=list)

    def note(self, name: str, value: Any, holds: bool | None = None) -> None:
        self.figures[name] = value
        if holds is False:
            self.failed.append(name)
        shown = f"{value:.4g}" if isinstance(value, float) else value
        print(f"{name:50} {shown}", {None: "", True: " ok", False: " DOES NOT HOLD"}[holds], flush=True)


# --- what is studied ---


def crank_rocker(coupler: float = 2.0, rocker: float = 1.5, gravity: float = -9.81) -> lw.Model:
    """Bars of 0.5, 2.0 and 1.5 m on a base of 2 m, two of these masses [kg]; the first can turn fully."""
    model = lw.Model(gravity=(0, 0, gravity), name="crank-rocker")
    crank, base = np.array((0, 0, 0.5)), np.array((2.0, 0, 0))
    distance = float(np.linalg.norm(base - crank))
    x = (base - crank) / distance
    along = (2.0**2 - 1.5**2 + distance**2) / (2 * distance)  # of the elbow, on the line from crank to base
    elbow = crank + along * x + math.sqrt(2.0**2 - along**2) * np.array((-x[2], 0, x[0]))
    points = np.array([(0, 0, 0), crank, elbow, base])
    names = ("ground", "crank", "coupler", "rocker", "ground")
    for k, (mass, usual) in enumerate(((1.0, 1.0), (coupler, 2.0), (rocker, 1.5))):
        bar = points[k + 1] - points[k]
        model.body(names[k + 1], mass=mass, inertia=thin_rod(usual, float(np.linalg.norm(bar))),
                   position=(points[k] + points[k + 1]) / 2,
                   orientation=lw.rotation.from_axes(x=bar, y=(0, 1, 0)))  # fmt: skip
    for k, point in enumerate(points):
        model.revolute(names[k], names[k + 1], at=point, axis=(0, 1, 0), name=f"pin {k}")
    return model


def pendulum() -> lw.Model:
    model = lw.Model(name="pendulum")
    model.body("rod", mass=1.0, inertia=thin_rod(1.0, 1.0), position=(0.5, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


def study_of(cases: int, seed: int) -> dict[str, Any]:
    """Arguments of `sweep`; the first cases are those of a larger one."""
    return {"model": crank_rocker(), "parameters": VARIED, "outputs": ["final"], "sampler": "random",
            "cases": cases, "seed": seed, "t_end": STEPS * STEP, "step": STEP, "progress": False}  # fmt: skip


def final_state(values: Mapping[str, float], **options: Any) -> tuple[Floats, Floats]:
    """q and v at the end of a case of it, run by itself."""
    model = crank_rocker(*(values[name] for name in VARIED))
    result = lw.simulate(model, STEPS * STEP, STEP, progress=False, **options)
    return result.q[-1].copy(), result.v[-1].copy()


# --- a study that is watched ---


@dataclass
class Watched:
    """How a study ended, how long it took [s], and the memory of its parent and largest child [MB]."""

    counts: Mapping[str, int] = field(default_factory=dict)
    seconds: float = math.nan
    first: float = math.nan  # until something was in the store
    saving: float = math.nan  # of the file
    memory: list[tuple[float, float]] = field(default_factory=list)

    def note(self, report: Report, name: str, cases: int) -> None:
        report.note(f"{name}: how cases ended", dict(self.counts), self.counts == {"finished": cases})
        report.note(f"{name}: cases/s", cases / self.seconds)
        report.note(f"{name}: time to the first results [s]", self.first)
        for who, samples in zip(("parent", "child"), np.array(self.memory).T, strict=True):
            half = len(samples) // 2
            some = [*samples[[0, half // 2, half, half + half // 2]], samples.max()]
            holds = bool(samples.max() <= GROWTH * samples[: half + 1].max())
            report.note(f"{name}: {who} at 0, 1/4, 1/2, 3/4, peak [MB]", np.round(some).tolist(), holds)
        grown = max(parent for parent, _ in self.memory) - self.memory[0][0]
        report.note(f"{name}: memory of the parent [bytes a case]", 1e6 * grown / cases)


def _sweep(connection: Any, arguments: Mapping[str, Any], file: Path | None) -> None:
    """Times at the begin and the end, how cases ended, and the time that `file` took with all of them."""
    connection.send(time.monotonic())
    study = lw.sweep(**arguments)
    ended, counts = time.monotonic(), Counter(study.status.tolist())
    if file is not None:
        study.save(file)
    connection.send((ended, counts, time.monotonic() - ended))


def watched(file: Path | None = None, **arguments: Any) -> Watched:
    """A study in a process of its own, saved to a file. EOFError: that died."""
    ours, theirs = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=_sweep, args=(theirs, arguments, file))
    process.start()
    theirs.close()
    found, store = Watched(), Path(arguments["directory"], "cases")
    try:
        began, known = ours.recv(), psutil.Process(process.pid)
        while not ours.poll(SAMPLE if found.first > 0 else LOOK):
            if not found.first > 0 and any(store.glob("*.jsonl")):
                found.first = time.monotonic() - began
            found.memory.append((_memory(known), max(map(_memory, known.children()), default=0.0)))
        ended, found.counts, found.saving = ours.recv()
    finally:
        end(process.pid)
        process.join()
    found.seconds = ended - began
    return found


def _memory(process: psutil.Process) -> float:
    """[MB]; 0 of one that is gone."""
    try:
        return float(process.memory_info().rss / 1e6)
    except psutil.NoSuchProcess:
        return 0.0


def end(pid: int | None) -> None:
    """A process and its children, where it is still there."""
    with contextlib.suppress(psutil.NoSuchProcess):
        for it in (*psutil.Process(pid).children(recursive=True), psutil.Process(pid)):
            it.kill()


# --- stores ---


def runs_of(directory: Path) -> Iterator[dict[str, Any]]:
    """Every line of a store that is a case."""
    for path in sorted(directory.glob("cases/*.jsonl")):
        with path.open() as lines:
            next(lines)
            yield from map(json.loads, lines)


def kept(directory: Path) -> int:
    """Cases that are in a store."""
    return sum(path.read_text().count("\n") - 1 for path in directory.glob("cases/*.jsonl"))


def note_store(report: Report, name: str, directory: Path, cases: int) -> None:
    keys, outputs = Counter[str](), 0
    for run in runs_of(directory):
        keys[run["key"]] += 1
        outputs += len(json.dumps(run["outputs"]))
    sizes = [path.stat().st_size for path in directory.rglob("*") if path.is_file()]
    beyond = (sum(sizes) - outputs) / cases
    report.note(f"{name}: files", len(sizes), len(sizes) <= FILES)
    report.note(f"{name}: bytes a case", sum(sizes) / cases)
    report.note(f"{name}: bytes a case beyond outputs", beyond, beyond <= BEYOND)
    report.note(f"{name}: cases that are there, lines", f"{len(keys)}, {keys.total()}",
                len(keys) == keys.total() == cases)  # fmt: skip


def note_bits(report: Report, name: str, directory: Path, cases: int) -> None:
    """Some cases of a store beside their own deterministic runs."""
    chosen, same = set(random.Random(cases).sample(range(cases), COMPARED)), 0
    for run in (run for place, run in enumerate(runs_of(directory)) if place in chosen):
        outputs = run["outputs"]["final.q"], run["outputs"]["final.v"]
        same += all(map(np.array_equal, outputs, final_state(run["values"], deterministic=True)))
    report.note(f"{name}: of {COMPARED} cases have the bits of simulate", same, same == COMPARED)


def note_same(report: Report, name: str, study: Mapping[str, Any], directory: Path, expected: Path) -> None:
    """Two stores of a study: every case once, none failed, the same bits."""
    found, wanted = (lw.sweep(**study, directory=it, gather=True) for it in (directory, expected))
    pairs = [(found.outputs[label], wanted.outputs[label]) for label in wanted.outputs]
    same = sum(all(np.array_equal(a[k], b[k]) for a, b in pairs) for k in range(len(wanted)))
    finished = int((found.status == "finished").sum())
    report.note(f"{name}: cases that finished", finished, finished == len(wanted))
    report.note(f"{name}: cases with the same bits", same, same == len(wanted))
    note_store(report, name, directory, len(wanted))


# --- throughput ---


def throughput(given: argparse.Namespace, folder: Path, report: Report) -> None:
    few, ratios = 64, []
    watched(**study_of(few, 1), directory=folder / "few", processes=given.processes)
    note_bits(report, "few", folder / "few", few)
    for k in range(given.rounds):
        name, directory = f"round {k + 1}", folder / f"round {k + 1}"
        study = study_of(given.cases, k + 1)
        run = watched(**study, directory=directory, processes=given.processes)
        run.note(report, name, given.cases)
        rows = [run["values"] for run, _ in zip(runs_of(directory), range(given.alone), strict=False)]
        with ProcessPoolExecutor(given.processes) as pool:
            list(pool.map(final_state, rows[: 2 * given.processes]))  # so that its processes are there
            began = time.perf_counter()
            list(pool.map(final_state, rows, chunksize=5))
            alone = len(rows) / (time.perf_counter() - began)
        ratios.append(given.cases / run.seconds / alone)
        report.note(f"{name}: pool of simulate, cases/s", alone)
        report.note(f"{name}: sweep by pool", ratios[-1])
        note_bits(report, name, directory, given.cases)
        note_store(report, name, directory, given.cases)
    report.note("sweep by pool, median", float(np.median(ratios)))


# --- workers ---


@contextlib.contextmanager
def cluster_of_dask(folder: Path) -> Iterator[tuple[Any, Any]]:
    """The cluster of the tests, with two workers, and its client."""
    from test_cluster import Cluster, client_of

    logging.disable(logging.CRITICAL)  # what Dask says of those that are killed
    folder.mkdir()
    cluster = Cluster(folder)
    client: Any = None
    try:
        for _ in range(2):
            cluster.worker()
        client = client_of(cluster)
        client.wait_for_workers(2, timeout=60)
        yield cluster, client
    finally:
        with contextlib.suppress(Exception):  # its scheduler may be gone
            client.close(timeout=2)
        for process in cluster.processes:
            process.kill()
            process.wait()


@contextlib.contextmanager
def every(seconds: float, action: Callable[[], object]) -> Iterator[None]:
    """By a thread of its own."""
    over = threading.Event()

    def act() -> None:
        while not over.wait(seconds):
            action()

    thread = threading.Thread(target=act)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


def workers(given: argparse.Namespace, folder: Path, report: Report) -> None:
    study, plain = study_of(given.cases, 1), folder / "plain"
    watched(**study, directory=plain, processes=given.processes).note(report, "plain", given.cases)
    for part in (workers_killed, shards_killed, scheduler_killed):
        name = part.__name__.replace("_", " ")
        part(given, folder, report, study)
        note_same(report, name, study, folder / part.__name__, plain)


def workers_killed(given: argparse.Namespace, folder: Path, report: Report, study: dict[str, Any]) -> None:
    with cluster_of_dask(folder / "cluster") as (cluster, client):

        def kill() -> None:
            """The oldest; another one takes its place."""
            oldest = next(it for it in cluster.processes[1:] if it.poll() is None)
            oldest.kill()
            oldest.wait()
            cluster.worker()

        began = time.monotonic()
        with every(given.every, kill):
            found = lw.sweep(**study, executor=client, directory=folder / "workers_killed")
        report.note("workers killed: time [s]", time.monotonic() - began)
    kills = len(cluster.processes) - 3  # a scheduler, two workers
    report.note("workers killed: kills", kills, kills > 0)
    why = Counter(str(it["message"]) for it in found.errors.values())
    report.note("workers killed: errors", dict(why), not why)


def shards_killed(given: argparse.Namespace, folder: Path, report: Report, study: dict[str, Any]) -> None:
    """Jobs of an array, one after the other, by the command; some are killed, and run again at the end."""
    study["model"].save(folder / "model.yaml")
    document = {name: study[name] for name in ("t_end", "sampler", "cases", "seed", "outputs")}
    document |= {"linkwork_study": 1, "model": "model.yaml", "simulation": {"step": STEP},
                 "parameters": VARIED, "directory": "shards_killed"}  # fmt: skip
    (folder / "study.json").write_text(json.dumps(document))
    endings = [shard(given, folder, k, killed=k < KILLED) for k in range(given.shards)]
    ended = [-signal.SIGKILL] * KILLED + [0] * (given.shards - KILLED)
    report.note("shards killed: how they ended", endings, endings == ended)
    report.note("shards killed: missing then", given.cases - kept(folder / "shards_killed"))
    again = [shard(given, folder, k) for k in range(KILLED)]
    report.note("shards killed: how they ended again", again, not any(again))


def shard(given: argparse.Namespace, folder: Path, k: int, *, killed: bool = False) -> int:
    """Its return code; it is `killed` when a quarter is done. RuntimeError: processes of it are left."""
    until = kept(folder / "shards_killed") + given.cases // (4 * given.shards)
    command = [str(Path(sys.executable).with_name("linkwork")), "sweep", str(folder / "study.json"),
               "--shard", f"{k}/{given.shards}", "--processes", str(given.processes)]  # fmt: skip
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    try:
        while killed and process.poll() is None:
            time.sleep(LOOK)
            if kept(folder / "shards_killed") >= until:
                children = psutil.Process(process.pid).children()
                process.kill()
                if psutil.wait_procs(children, timeout=60)[1]:
                    raise RuntimeError("processes outlived a shard that was killed")
        return process.wait()
    finally:
        end(process.pid)
        process.wait()


def scheduler_killed(given: argparse.Namespace, folder: Path, report: Report, study: dict[str, Any]) -> None:
    directory, told, times = folder / "scheduler_killed", "", [math.nan]
    with cluster_of_dask(folder / "lost cluster") as (cluster, client):

        def kill() -> None:
            if cluster.scheduler.poll() is None and kept(directory) >= given.cases // 4:
                cluster.scheduler.kill()
                times[0] = time.monotonic()

        with every(LOOK, kill):
            try:
                lw.sweep(**study, executor=client, directory=directory)
            except lw.LinkworkError as error:
                told = f"{error.code}: {error}"
        seconds, done = time.monotonic() - times[0], kept(directory)
    report.note("scheduler killed: time to the error [s]", seconds, seconds < 60)
    report.note("scheduler killed: error", told, told.startswith("executor: executor: works no more"))
    report.note("scheduler killed: cases kept", done, 0 < done < given.cases)
    watched(**study, directory=directory, processes=given.processes)


# --- bookkeeping ---


def bookkeeping(given: argparse.Namespace, folder: Path, report: Report) -> None:
    study = {**study_of(given.cases, 1), "model": pendulum(), "t_end": 2 * STEP,
             "parameters": {"rod.mass": (0.5, 2.0), "gravity[2]": (-10.0, -9.6)},
             "directory": folder / "store"}  # fmt: skip
    if given.answered:
        workers: dict[str, Any] = {"executor": Answering(given.answered)}
    else:
        workers = {"processes": given.processes}
    watched(**study, **workers).note(report, "sweep", given.cases)
    note_store(report, "store", folder / "store", given.cases)
    again = watched(**study, **workers)
    report.note("again: time until nothing is missing [s]", again.seconds)
    gathered = watched(**study, gather=True)
    gathered.note(report, "gather", given.cases)
    report.note("gather: time [s]", gathered.seconds)
    saved = watched(folder / "all.nc", **study, gather=True)
    report.note("netCDF: time to write [s]", saved.saving)
    report.note("netCDF: memory of who writes it [MB]", max(parent for parent, _ in saved.memory))
    report.note("netCDF: bytes a case", (folder / "all.nc").stat().st_size / given.cases)
    began = time.monotonic()
    cases = xr.load_dataset(folder / "all.nc").sizes["case"]
    report.note("netCDF: time to read [s]", time.monotonic() - began, cases == given.cases)


class Answering(Executor):
    """Gives at once an answer as long as that of a simulation, whose cases say that they took so long [s]."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds

    def submit(self, runner: Any, cases: Any, /) -> Future[Any]:  # type: ignore[override]
        numbers = np.random.default_rng(cases[0].number)
        verdict = {"level": "good", "error": 3.905559376283024e-11, "sentence": "accurate to about 4e-11"}
        runs = [Run(it.key, "finished",
                    {"final.q": [numbers.random(7).tolist()], "final.v": [numbers.random(6).tolist()]},
                    verdict=verdict, seconds=self._seconds, values=dict(it.values))
                for it in cases]  # fmt: skip
        found: Future[Any] = Future()
        found.set_result(Answer(machine(), runs))
        return found


#: With the usual number of cases.
PARTS: dict[str, tuple[Callable[..., None], int]] = {
    "throughput": (throughput, 100_000), "workers": (workers, 10_000), "bookkeeping": (bookkeeping, 20_000)
}  # fmt: skip


def give_up(number: int, _: object) -> None:
    """By an exception, so that all processes are ended."""
    raise SystemExit(f"given up: {signal.Signals(number).name}")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("part", choices=PARTS)
    parser.add_argument("--cases", type=int, help="of a study; each part has its own number")
    parser.add_argument("--alone", type=int, default=400, help="throughput: cases of the pool in a round")
    parser.add_argument("--rounds", type=int, default=3, help="throughput: sweep and pool, in turn")
    parser.add_argument("--every", type=float, default=3.0,
                        help="workers: between two kills [s], longer than one takes to start")  # fmt: skip
    parser.add_argument("--shards", type=int, default=8, help="workers: of which three are killed")
    parser.add_argument("--answered", type=float, metavar="SECONDS", help="bookkeeping: no simulation")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=120.0, help="after which it is given up")
    parser.add_argument("--folder", type=Path, help="where stores are written, and removed")
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    given = parser.parse_args()
    part, usual = PARTS[given.part]
    given.cases = given.cases or usual
    for number in (signal.SIGALRM, signal.SIGTERM):
        signal.signal(number, give_up)
    signal.alarm(math.ceil(60 * given.minutes))
    report = Report()
    with tempfile.TemporaryDirectory(dir=given.folder) as folder:
        part(given, Path(folder), report)
    if given.json:
        given.json.write_text(json.dumps({"given": vars(given), **vars(report)}, indent=1, default=str))
    sys.exit(bool(report.failed))


if __name__ == "__main__":
    main()
