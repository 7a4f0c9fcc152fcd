"""Shards of a study as jobs of an array of SLURM, on a node of this machine alone; skipped without SLURM."""

from __future__ import annotations

import contextlib
import getpass
import importlib
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
import submitit
from linkwork.studies.files import read_study
from numpy.testing import assert_array_equal

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "sinfo", "squeue")

STUDY = """
linkwork_study: 1
model: pendulum
t_end: 4.0
simulation: {step: 0.0005, deterministic: false}
parameters: {"gravity[2]": [-10.0, -9.0]}
sampler: sobol
cases: 64
seed: 1
outputs: {last: final, energy: energy_error.abs_max}
"""

#: As in the guide: the number of all shards, so that some of them can be submitted again.
ARRAY = """#!/bin/sh
#SBATCH --cpus-per-task=1
linkwork sweep study.yaml --shard $SLURM_ARRAY_TASK_ID/4 --processes $SLURM_CPUS_PER_TASK
"""

COUNTED = ARRAY.replace("/4", "/$SLURM_ARRAY_TASK_COUNT")

#: Each run of a job stops in its fifth case of 16 until there is a file "go": it is killed with cases
#: behind and before it, however fast the machine.
HELD = """
import os
import time
from pathlib import Path

import linkwork as lw
from linkwork.studies.files import read_study

folder, run = Path(__file__).parent, []


def held(result):
    run.append(1.0)
    while len(run) > 4 and not (folder / "go").exists():
        (folder / os.environ["SLURM_ARRAY_TASK_ID"]).touch()
        time.sleep(0.02)
    return 1.0


def study():
    given = read_study(folder / "study.yaml")
    return given | {"outputs": given["outputs"] | {"held": held}, "progress": False}


def shard(k):
    lw.sweep(**study(), shard=(k, 4), processes=1)
"""

HELD_ARRAY = """#!/bin/sh
#SBATCH --cpus-per-task=1
python -c "import held; held.shard($SLURM_ARRAY_TASK_ID)"
"""

#: One node without accounting and control groups, that has as many processors as are asked for here.
CONFIGURATION = """
ClusterName=alone
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={control}
SlurmdPort={work}
AuthType=auth/munge
AuthInfo=socket={folder}/munge
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
SlurmdParameters=config_overrides
MpiDefault=none
SwitchType=switch/none
MailProg=/bin/true
KillWait=5
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_port() -> int:
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return int(found.getsockname()[1])


class Slurm:
    """A controller and a node of SLURM, each a process of its own, on loopback."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.processes: list[subprocess.Popen[bytes]] = []
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "munge.key").write_bytes(os.urandom(1024))
        (folder / "munge.key").chmod(0o400)
        facts = {"host": socket.gethostname().split(".")[0], "folder": folder, "user": getpass.getuser(),
                 "control": free_port(), "work": free_port()}  # fmt: skip
        (folder / "slurm.conf").write_text(CONFIGURATION.format_map(facts))
        programs = str(Path(sys.executable).parent)
        path = os.pathsep.join([programs, os.environ["PATH"], "/usr/sbin"])
        self.environment = os.environ | {"SLURM_CONF": str(folder / "slurm.conf"), "PATH": path}

    def start(self) -> None:
        """RuntimeError: no node answers."""
        files = {"socket": "munge", "key-file": "munge.key", "pid-file": "munge.pid",
                 "log-file": "munge.log", "seed-file": "munge.seed"}  # fmt: skip
        self._start("munged", "--force", "--foreground",
                    *(f"--{name}={self.folder / file}" for name, file in files.items()))  # fmt: skip
        until(lambda: (self.folder / "munge").exists(), 10, "munged")
        self._start("slurmctld", "-D")
        self._start("slurmd", "-D")
        until(lambda: self.tell("sinfo", "-h", "-o", "%T") == "idle", 30, "a node that is idle")

    def _start(self, *command: str) -> None:
        with (self.folder / f"{command[0]}.out").open("wb") as out:
            self.processes.append(subprocess.Popen(command, env=self.environment, stdout=out, stderr=out))

    def tell(self, *command: str, cwd: Path | None = None) -> str:
        done = subprocess.run(command, env=self.environment, cwd=cwd, capture_output=True, text=True)
        return done.stdout.strip()

    def submit(self, folder: Path, *options: str, script: str = ARRAY) -> str:
        """The number of an array of jobs."""
        (folder / "array.sh").write_text(script)
        return self.tell("sbatch", "--parsable", *options, "array.sh", cwd=folder)

    def state(self, job: str) -> set[str]:
        """What its tasks are: PENDING, RUNNING, COMPLETED, ..."""
        told = self.tell("scontrol", "show", "job", job, "--oneliner").split()
        return {word.partition("=")[2] for word in told if word.startswith("JobState=")}

    def finish(self, job: str) -> None:
        until(lambda: not self.tell("squeue", "-h", "-j", job), 120, f"job {job}")

    def requeue(self, job: str) -> None:
        """
        SLURM waits for two minutes; here for what it must wait for: until the first run of the job is gone,
        and until the clock has gone on, as the node starts nothing of a job that it ended in the same second.
        """
        self.tell("scontrol", "requeue", job)
        told = self.tell("scontrol", "show", "job", job, "--oneliner")
        gone = f"[{told.partition('JobId=')[2].split()[0]}.batch] done with job"
        until(lambda: gone in (self.folder / "slurmd.log").read_text(), 60, gone)
        time.sleep(2)
        self.tell("scontrol", "update", f"jobid={job}", "StartTime=now")
        until(lambda: self.state(job) == {"RUNNING"}, 60, f"job {job} again")

    def end(self) -> None:
        for process in reversed(self.processes):
            process.terminate()
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(10)
            process.kill()
            process.wait()


def until(holds: Any, seconds: float, what: str) -> None:
    deadline = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > deadline:
            raise RuntimeError(f"{what}: not within {seconds:g} s")
        time.sleep(0.1)


@pytest.fixture(scope="module")
def slurm() -> Iterator[Slurm]:
    path = os.pathsep.join([os.environ["PATH"], "/usr/sbin"])
    missing = [name for name in PROGRAMS if shutil.which(name, path=path) is None]
    if missing:
        pytest.skip(f"no SLURM here: {', '.join(missing)} not found (Debian: slurm-wlm, munge)")
    with tempfile.TemporaryDirectory(prefix="slurm") as folder:  # short, as it holds a socket
        found = Slurm(Path(folder))
        try:
            try:
                found.start()
            except RuntimeError as error:
                pytest.skip(f"SLURM cannot be started here: {error}")
            yield found
        finally:
            found.end()


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> lw.Study:
    return lw.sweep(**study_in(tmp_path_factory.mktemp("plain")), processes=2)


def study_in(folder: Path) -> dict[str, Any]:
    (folder / "study.yaml").write_text(STUDY)
    return read_study(folder / "study.yaml") | {"progress": False}


def same(given: dict[str, Any], expected: lw.Study) -> None:
    """Every case is in the store once, with the bits that are expected."""
    study = lw.sweep(**given, gather=True)
    assert (study.status == "finished").all()
    for label in expected.outputs:
        assert_array_equal(study.outputs[label], expected.outputs[label])
    lines = [line for file in (Path(given["directory"]) / "cases").glob("*.jsonl") for line in file.open()]
    assert sum('"key"' in line for line in lines) == len(expected)


@pytest.mark.parametrize("numbers", ["0-3", "1-4"])
def test_an_array_of_jobs_runs_each_case_once(
    numbers: str, slurm: Slurm, tmp_path: Path, expected: lw.Study
) -> None:
    study = study_in(tmp_path)
    job = slurm.submit(tmp_path, f"--array={numbers}", script=COUNTED)
    slurm.finish(job)
    assert slurm.state(job) == {"COMPLETED"}
    same(study, expected)


def test_jobs_that_are_requeued_and_cancelled_lose_nothing(
    slurm: Slurm, tmp_path: Path, expected: lw.Study, monkeypatch: pytest.MonkeyPatch
) -> None:
    study_in(tmp_path)
    (tmp_path / "held.py").write_text(HELD)
    monkeypatch.syspath_prepend(tmp_path)
    study = importlib.import_module("held").study()
    job = slurm.submit(tmp_path, "--array=0-3", script=HELD_ARRAY)
    until(lambda: all((tmp_path / f"{k}").exists() for k in range(4)), 60, "cases of each")
    slurm.tell("scancel", f"{job}_1")
    slurm.requeue(f"{job}_2")
    (tmp_path / "go").touch()
    slurm.finish(job)
    assert slurm.state(f"{job}_1") == {"CANCELLED"}
    status = lw.sweep(**study, gather=True).status
    skipped = np.flatnonzero(status == "skipped")
    assert set(skipped % 4) == {1}
    assert 0 < len(skipped) < 16  # it may end the case that it is in
    again = slurm.submit(tmp_path, "--array=1", script=HELD_ARRAY)
    slurm.finish(again)
    same(study, expected)


def test_jobs_of_submitit_on_slurm(slurm: Slurm, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("SLURM_CONF", "PATH"):
        monkeypatch.setenv(name, slurm.environment[name])
    run: dict[str, Any] = {"t_end": 0.2, "step": 1e-3, "progress": False}
    model, few = lw.mechanisms.pendulum(), {"gravity[2]": [-10.0, -9.5, -9.0]}
    executor = submitit.AutoExecutor(folder=tmp_path / "jobs", cluster="slurm")
    executor.update_parameters(timeout_min=3, cpus_per_task=1)
    study = lw.sweep(model, few, "final", executor=executor, **run)
    assert (study.status == "finished").all()
    assert_array_equal(study.outputs["final.q"],
                       lw.sweep(model, few, "final", processes=1, **run).outputs["final.q"])  # fmt: skip
