"""Studies by the executors of other packages: each case once, with the bits of a study without a cluster."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import dask
import distributed
import linkwork as lw
import numpy as np
import pytest
import submitit
from numpy.testing import assert_array_equal

MODEL = lw.mechanisms.pendulum()
MASSES = {"gravity[2]": np.linspace(-10.0, -9.0, 60).tolist()}
OUTPUTS = ["final", "energy_error.abs_max"]
RUN: dict[str, Any] = {"t_end": 1.0, "step": 1e-3, "progress": False}


@pytest.fixture(scope="module")
def expected() -> lw.Study:
    return lw.sweep(MODEL, MASSES, OUTPUTS, processes=1, **RUN)


def same(study: lw.Study, expected: lw.Study) -> None:
    """The cases of the study are the first ones that are expected."""
    assert (study.status == "finished").all() and len(study)
    for label in expected.outputs:
        assert_array_equal(study.outputs[label], expected.outputs[label][: len(study)])


class Cluster:
    """A scheduler of Dask and its workers, each a process of its own, on loopback."""

    def __init__(self, folder: Path) -> None:
        self.file = folder / "scheduler.json"
        self.processes: list[subprocess.Popen[bytes]] = []
        self.scheduler = self.start("scheduler", "--host", "127.0.0.1", "--port", "0")

    def start(self, what: str, *options: str) -> subprocess.Popen[bytes]:
        here = ("--no-dashboard", "--dashboard-address", "127.0.0.1:0")
        command = [sys.executable, "-m", "dask", what, "--scheduler-file", str(self.file), *here, *options]
        environment = os.environ | {"DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "3s"}
        process = subprocess.Popen(command, stderr=subprocess.DEVNULL, env=environment)
        self.processes.append(process)
        return process

    def worker(self) -> subprocess.Popen[bytes]:
        return self.start("worker", "--nthreads", "1", "--no-nanny", "--host", "127.0.0.1")


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    found = Cluster(tmp_path)
    try:
        yield found
    finally:
        for process in found.processes:
            process.kill()
            process.wait()


def client_of(cluster: Cluster) -> Any:
    deadline = time.monotonic() + 60
    while not cluster.file.exists() and time.monotonic() < deadline:
        time.sleep(0.1)
    return distributed.Client(scheduler_file=str(cluster.file), timeout="60s")


def test_a_cluster_of_dask_whose_workers_are_killed_runs_each_case_once(
    cluster: Cluster, tmp_path: Path, expected: lw.Study
) -> None:
    crew = [cluster.worker(), cluster.worker()]
    over = threading.Event()

    def kill() -> None:
        for k in range(3):
            if over.wait(1.0):
                return
            os.kill(crew[k % 2].pid, signal.SIGKILL)
            crew[k % 2] = cluster.worker()

    with client_of(cluster) as client:
        client.wait_for_workers(2, timeout=60)
        killer = threading.Thread(target=kill)
        killer.start()
        try:
            study = lw.sweep(MODEL, MASSES, OUTPUTS, executor=client, directory=tmp_path / "study", **RUN)
        finally:
            over.set()
            killer.join()
        same(lw.sweep(MODEL, MASSES, OUTPUTS, executor=client.get_executor(), **RUN), expected)
    same(study, expected)
    lines = [line for file in (tmp_path / "study/cases").glob("*.jsonl") for line in file.open()]
    assert sum('"key"' in line for line in lines) == len(expected)


def test_a_scheduler_that_is_lost_is_told_and_the_study_goes_on(
    cluster: Cluster, tmp_path: Path, expected: lw.Study
) -> None:
    cluster.worker()
    where = tmp_path / "study"
    many = {"gravity[2]": [*MASSES["gravity[2]"], *np.linspace(-9, -8, 3000).tolist()]}
    with dask.config.set({"distributed.comm.timeouts.connect": "2s"}):
        client = client_of(cluster)
        client.wait_for_workers(1, timeout=60)
        threading.Timer(2.0, cluster.scheduler.kill).start()
        with pytest.raises(lw.LinkworkError, match=r"executor: works no more.*run the study again") as caught:
            lw.sweep(MODEL, many, OUTPUTS, executor=client, directory=where, **RUN)
        assert caught.value.code == "executor"
        with contextlib.suppress(Exception):
            client.close(timeout=1)
    same(lw.sweep(MODEL, MASSES, OUTPUTS, processes=1, directory=where, **RUN), expected)


def test_a_client_that_is_closed_is_told() -> None:
    client = distributed.Client(n_workers=1, processes=False, dashboard_address=None)
    client.close()
    with pytest.raises(lw.OptionError, match="the client of Dask is closed"):
        lw.sweep(MODEL, MASSES, OUTPUTS, executor=client, **RUN)


def test_jobs_of_submitit(tmp_path: Path, expected: lw.Study) -> None:
    few = {"gravity[2]": MASSES["gravity[2]"][:3]}
    for cluster in ("debug", "local"):
        executor = submitit.AutoExecutor(folder=tmp_path / cluster, cluster=cluster)
        executor.update_parameters(timeout_min=3)
        study = lw.sweep(MODEL, few, OUTPUTS, executor=executor, **RUN)
        same(study, expected)


MPI = """
import sys, linkwork as lw, numpy as np
from mpi4py.futures import MPIPoolExecutor
if __name__ == "__main__":
    with MPIPoolExecutor() as executor:
        values = np.linspace(-10.0, -9.0, 60).tolist()
        study = lw.sweep(lw.mechanisms.pendulum(), {"gravity[2]": values}, "energy_error.abs_max",
                         executor=executor, t_end=1.0, step=1e-3, progress=False)
    np.save(sys.argv[1], study.outputs["energy_error.abs_max"])
"""


def test_processes_of_mpi(tmp_path: Path, expected: lw.Study) -> None:
    (tmp_path / "study.py").write_text(MPI)
    mpiexec = Path(sys.executable).with_name("mpiexec")
    program = [sys.executable, "-m", "mpi4py.futures", tmp_path / "study.py", tmp_path / "found.npy"]
    subprocess.run([mpiexec, "-n", "3", *program], check=True, timeout=120)
    assert_array_equal(np.load(tmp_path / "found.npy"), expected.outputs["energy_error.abs_max"])
