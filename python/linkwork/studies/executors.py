"""Executors of others with the interface of concurrent.futures: clients of Dask, executors of submitit.

MPIPoolExecutor of mpi4py, and what `get_executor` of a Dask client gives, have it already. Scheduling,
retries and the loss of workers are theirs.
"""

from __future__ import annotations

import concurrent.futures as futures
import contextlib
import pickle
import sys
import threading
from collections.abc import Callable
from typing import Any, TypeVar

from linkwork.comparison.workers import processor_count
from linkwork.errors import OptionError

__all__ = ["adapted", "check_executor", "workers_of"]

T = TypeVar("T")

#: Between two looks at the jobs of submitit [s], each of which is a look at files.
LOOK_SECONDS = 0.5


def check_executor(executor: Any, processes: int | None, runner: Any) -> None:
    """OptionError: no executor, or a study that cannot go to other processes."""
    if executor is None:
        return
    if not callable(getattr(executor, "submit", None)):
        raise OptionError(
            f"executor {executor!r:.80} is no concurrent.futures.Executor: it has no submit", code="executor"
        )
    if processes is not None:
        raise OptionError("processes is of the local ones: with an executor leave it out", code="conflict")
    if getattr(getattr(executor, "_client", executor), "status", "running") in ("closing", "closed"):
        raise OptionError("executor: the client of Dask is closed; make a new one", code="executor")
    if isinstance(executor, futures.ThreadPoolExecutor):
        return
    try:
        pickle.dumps(runner)
    except Exception as error:
        raise OptionError(
            f"executor: the study cannot go to another process ({error}): functions must be of a module, no "
            "lambdas; or leave executor out for local processes",
            code="executor",
        ) from error


def adapted(executor: Any) -> Any:
    """The executor, or one of concurrent.futures that hands on to it."""
    if callable(getattr(executor, "get_executor", None)):  # a client of Dask
        return executor.get_executor(pure=False)
    submitit = sys.modules.get("submitit")
    if submitit is not None and isinstance(executor, submitit.Executor):
        return _Submitit(executor)
    return executor


def workers_of(executor: Any, processes: int | None) -> int:
    """How many cases it runs at once, as far as it tells."""
    if executor is None:
        return processes or processor_count()
    client = getattr(executor, "_client", executor)
    if callable(getattr(client, "nthreads", None)):  # a client of Dask, or its executor
        return max(1, int(sum(client.nthreads().values())))
    for name in ("num_workers", "_max_workers"):  # of mpi4py, of concurrent.futures
        known = getattr(executor, name, None)
        if isinstance(known, int) and known > 0:
            return known
    return processor_count()


class _Job(futures.Future[Any]):
    """A job of submitit, which is cancelled with it."""

    def __init__(self, job: Any) -> None:
        super().__init__()
        self.job = job

    def cancel(self) -> bool:
        with contextlib.suppress(Exception):  # it may be over
            self.job.cancel()
        return super().cancel()


class _Submitit(futures.Executor):
    """Jobs of submitit (SLURM, local, debug) as futures, looked at now and then by a thread of its own."""

    def __init__(self, executor: Any) -> None:
        self._executor = executor
        self._jobs: list[_Job] = []
        self._lock = threading.Lock()
        self._watching = False

    def submit(self, function: Callable[..., T], /, *args: Any, **kwargs: Any) -> futures.Future[T]:
        future = _Job(self._executor.submit(function, *args, **kwargs))
        with self._lock:
            self._jobs.append(future)
            if not self._watching:
                self._watching = True
                threading.Thread(target=self._watch, name="submitit jobs", daemon=True).start()
        return future

    def _watch(self) -> None:
        pause = threading.Event()
        while True:
            with self._lock:
                self._jobs = [it for it in self._jobs if not it.done()]
                jobs = list(self._jobs)
                self._watching = bool(jobs)
            if not jobs:
                return
            for future in jobs:
                self._look(future)
            pause.wait(LOOK_SECONDS)

    @staticmethod
    def _look(future: _Job) -> None:
        try:
            if not future.job.done():
                return
            value = future.job.result()
        except Exception as error:  # of the task, or of the job that was lost
            with contextlib.suppress(futures.InvalidStateError):
                future.set_exception(error)
        else:
            with contextlib.suppress(futures.InvalidStateError):
                future.set_result(value)
